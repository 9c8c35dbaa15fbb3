"""Recordings for the open exercise of lesson 9: a speaker among echoes that last longer than the lesson's."""

import re

import numpy as np

from kflearn import angle_difference, bearings
from kflearn.exercises import _code_of
from kflearn.exercises._judge import Likely

STEPS, LONGEST, SETTLED = 325, 14, 30  # readings in a recording, in an echo; after a change, until it is judged again
HABITS = bearings.VARIANTS["crossing"]


def recording(rng):
    """Readings (325,) of a speaker who walks across north; in half of them somebody else takes over.

    Where nobody does, a long echo begins just after the speaker has passed north: a filter that has lost its way there
    follows the echo.
    """
    truth, z = bearings.recording(HABITS._replace(drift=0.15 * rng.choice([-1, 1])), STEPS, rng)
    turn, moment = rng.choice([-1, 1]) * rng.uniform(70, 150) * (rng.random() < 0.5), rng.integers(150, 180)
    truth[moment:] += turn
    z[moment:] = bearings.nearest(z[moment:] + turn)
    _quiet(z, truth, moment - 16, moment + 16)
    early, late = rng.integers(55, 90), rng.integers(240, 280)
    left = bearings.nearest(truth) > 180
    crossed = np.flatnonzero(left == left[0])[-1] + 5
    for begin in (0, early if turn or crossed > 225 else crossed, late):
        end = begin + (rng.integers(3, 6) if begin == 0 else rng.integers(11, LONGEST + 1))
        _quiet(z, truth, begin - 16, end + 16)
        z[begin:end] = bearings.nearest(truth[begin] + rng.choice([-1, 1]) * rng.uniform(50, 120))
    return (z,), truth


def _quiet(z, truth, first, last):
    """No echoes between two readings."""
    place = slice(max(first, 0), last)
    z[place] = bearings.nearest(truth[place])


def off(changed):
    """The rms error of the recordings with a change, or without; the readings just after it do not count."""

    def value(answers, truths):
        errors = []
        for answer, truth in zip(answers, truths, strict=True):
            jumps = np.flatnonzero(abs(np.diff(truth)) > 30) + 1
            if bool(len(jumps)) == changed:
                error = angle_difference(np.asarray(answer, float), truth)
                keep = np.ones(len(truth), bool)
                for moment in jumps:
                    keep[moment : moment + SETTLED] = False
                errors.append(error[keep])
        return np.sqrt(np.mean(np.concatenate(errors) ** 2))

    return value


def errors_of(answers, recordings, late=False):
    """Error, truth and readings of each recording: up to a change of speaker where there is one, or later than that."""
    for answer, ((z,), truth) in zip(answers, recordings, strict=True):
        jumps = np.flatnonzero(abs(np.diff(truth)) > 30) + 1
        if late and not len(jumps):
            continue
        part = slice(jumps[0] + SETTLED, None) if late else slice(0, jumps[0] if len(jumps) else None)
        yield angle_difference(np.asarray(answer, float), truth)[part], truth[part], np.asarray(z, float)[part]


def echoes(z, truth):
    """(first, last) reading of each long echo that ends."""
    far = np.flatnonzero(abs(angle_difference(z, truth)) > 10)
    runs = np.split(far, np.flatnonzero(np.diff(far) > 1) + 1)
    return [(run[0], run[-1]) for run in runs if len(run) > 9 and run[-1] < len(z) - 1]


def of_the_readings(answers, recordings):
    """What is said of an answer that needs no filter; None where there is one."""
    if all(np.ptp(answer) < 1e-6 for answer in answers):
        return "You return one bearing for a whole recording. The speaker walks, by 0.15° a reading: 49° in all."
    if all(
        np.allclose(angle_difference(np.asarray(answer, float), inputs[0]), 0)
        for answer, (inputs, _) in zip(answers, recordings, strict=True)
    ):
        return "You return the readings themselves: during an echo they are 50° off and more."
    return None


def of_one(answers, recordings):
    """What to look at where the errors with one speaker are too large."""
    if words := of_the_readings(answers, recordings):
        return words
    rows = list(errors_of(answers, recordings))
    return seen_of_one(rows) or where(rows)


def seen_of_one(rows):
    """What the errors of some recordings show of starts and of long echoes; None where they do not show it."""
    lost = [np.median(abs(error)) > 10 for error, _, _ in rows]
    begin = [np.median(abs(error[1:5])) > 10 for error, _, _ in rows]
    pulls = [(abs(error[last]), abs(angle_difference(z[last], truth[last])))
             for error, truth, z in rows for _, last in echoes(z, truth)]  # fmt: skip
    share = np.median([pull / full for pull, full in pulls])
    if np.mean(lost) > 0.4:
        at = " It is off from the first readings on, and they are an echo." if np.mean(begin) > 0.5 else ""
        return f"In {sum(lost)} of {len(rows)} recordings the filter is not at the speaker most of the time.{at} Does it ever come back?"
    if share > 0.7:
        return f"Echoes of 11 to 14 readings take the filter along: at their end it is {100 * share:.0f} % of the way to them. Does it switch too early, or believe each reading?"
    between = np.mean([0.1 < pull / full < 0.9 for pull, full in pulls])
    if share > 0.1 and between > 0.5:
        return (
            f"At the end of an echo of 11 to 14 readings the filter is {100 * share:.0f} % of the way to it. "
            "Each reading of an echo pulls, and the pulls add up: a reading so far off should not pull at all."
        )
    if np.mean(begin) > 0.4:
        return "At the beginning the filter is off. Does it follow the first readings? They may be an echo: what do the first fifteen together say?"
    return taken(rows)


def taken(rows):
    """At the ends of how many long echoes a filter is at the echo; None where it is at none."""
    count = at = 0
    right = True  # at all other times
    for error, truth, z in rows:
        keep = np.ones(len(z), bool)
        for first, last in echoes(z, truth):
            count += 1
            at += abs(error[last] - angle_difference(z[last], truth[last])) < 10
            keep[first : last + 16] = False
        right = right and np.all(abs(error[keep]) < 10)
    rest = " Otherwise it is within 10° of the speaker, up to a change of speaker." if right else ""
    advice = "An echo lasts up to 14 readings: look at more readings before you leave the old place."
    return (
        f"At the end of {at} of {count} long echoes your filter is wholly at the echo.{rest} {advice}" if at else None
    )


def where(rows):
    """Where the errors of some recordings are: near north, behind a speaker who walks, or around one reading."""
    error, truth = (np.concatenate(part) for part in list(zip(*rows, strict=True))[:2])
    north = abs(angle_difference(truth, 0)) < 15
    if np.sum(error[north] ** 2) > 0.8 * np.sum(error**2):
        words = "Nearly all of the error is where the speaker is near north."
        return Likely(f"{words} Is every difference taken the short way round?")
    walks = [np.sign(np.median(np.diff(truth))) for _, truth, _ in rows]
    behind = [-np.median(side * error) for side, (error, _, _) in zip(walks, rows, strict=True)]
    if min(behind) > 1:
        return f"Your filter is {np.median(behind):.0f}° behind the walking speaker (median): let it follow faster."
    row = max(rows, key=lambda each: np.max(abs(each[0])))
    k = np.argmax(abs(row[0]))
    return f"The largest error is {abs(row[0][k]):.0f}°, where the speaker is at {row[1][k] % 360:.0f}°."


def of_two(answers, recordings):
    """What to look at where the errors with two speakers are too large: it never comes to the new one, or it does."""
    arrived, early, slow = [], [], []
    for answer, (_, truth) in zip(answers, recordings, strict=True):
        for moment in np.flatnonzero(abs(np.diff(truth)) > 30) + 1:
            late = angle_difference(np.asarray(answer, float), truth)[moment + SETTLED :]
            arrived.append(np.median(abs(late)) < 10)
            slow.append(len(late) > 10 and np.mean(abs(late[:10]) > 30) > 0.5)
            new = angle_difference(np.asarray(answer, float)[moment - 1 : moment], truth[moment])
            early.append(np.median(abs(new)) < 10)
    if words := of_the_readings(answers, recordings):
        return words
    rows = list(errors_of(answers, recordings))
    shown = seen_of_one(rows)
    if np.mean(early) > 0.5 or (any(early) and not shown):
        count = f"In {sum(early)} of {len(early)} recordings with two speakers"
        return f"{count} the filter comes to the new speaker before the change: it looks ahead, and switches too early."
    if np.mean(arrived) < 0.5:
        return "After a change the filter must come to the new speaker within 30 readings: does a gate open again, and do new readings count enough?"
    if np.mean(slow) > 0.3:
        return "After a change the filter comes to the new speaker, but later than 30 readings: new readings must count for more when many of them agree."
    words = shown or where([*errors_of(answers, recordings, late=True), *rows])
    said = f"The filter comes to the new speaker, but it is wrong at other times. {words}"
    return Likely(said) if isinstance(words, Likely) else said


BEGINNING = "And what do the first fifteen together say? They may begin with an echo."


def leads_to(answer, readings, place, within):
    """Whether such readings, again and again, lead an answer to this place."""
    last = np.asarray(answer(np.resize(np.asarray(readings, float), STEPS)), float)[-100:]
    return np.median(abs(angle_difference(last, place))) < within


def averages_raw(answer, answers, recordings):
    """A mean of bearings as plain numbers."""
    averages = re.search(r"(mean|average|convolve|cumsum)\(", _code_of.text_of(answer) or "")
    if averages and not of_the_readings(answers, recordings) and leads_to(answer, [359, 1], 180, 20):
        return "Fed with 359 and 1 in turn, your filter goes to 180: do you average, or subtract, raw bearings? Take the short ways from one of them. Even so, 14 echo readings among 20 take a mean most of the way: let most of them decide, not their mean."
    return None


def outvoted(answer, answers, recordings):
    """A running median of too few readings."""
    text = _code_of.text_of(answer) or ""
    found = re.search(r"(?:running_median|median_filter)\(.*?, *(?:window=|size=)?(\d+)", text)
    found = found or ("median(" in text and re.search(r"sliding_window_view\(.*?, *(\d+)\)", text))
    if found and 2 < int(found[1]) < 2 * LONGEST:
        half = int(found[1]) // 2 + 1
        return f"A median of {found[1]} is outvoted by {half} readings of an echo, and these echoes last up to {LONGEST}. A window must be longer than two echoes, or something else must decide. {BEGINNING}"
    return None


def sorts_raw(answer, answers, recordings):
    """A running median of bearings as plain numbers: there 120 is in the middle of 1, 2, 120, 358, 359."""
    text = re.sub(r"median\(\w+\[: *\w+\]\)", "", _code_of.text_of(answer) or "")  # without that of a start
    sorts = re.search(r"median(_filter)?\(", text)
    if sorts and not of_the_readings(answers, recordings) and leads_to(answer, [359, 1, 120, 358, 2], 120, 5):
        return f"You sort raw bearings: near north 359 and 1 end up at opposite ends. Use np.unwrap first. {BEGINNING}"
    return None


def turned(answer, answers, recordings):
    """A filter that answers otherwise if all is turned: somewhere a bearing is taken for a plain number."""
    if of_the_readings(answers, recordings):
        return None
    rows = [
        abs(angle_difference(np.asarray(a, float), truth)) for a, (_, truth) in zip(answers, recordings, strict=True)
    ]
    for k in np.argsort([-row.mean() for row in rows])[:4]:
        (z,), truth = recordings[k]
        error = abs(angle_difference(np.asarray(answer((z + 90) % 360), float) - 90, truth))
        if 2 * error.mean() < rows[k].mean():
            return (
                f"In recording {k + 1} your error is {rows[k].mean():.2g}° on average; with all readings turned by 90° it is "
                f"{error.mean():.2g}°. North is an ordinary bearing: take every difference, mean and median the short way round."
            )
    return None


# ---- designs


def gate(Q=0.5, R=9.0, patience=LONGEST, start=15):
    """The lesson's gate, with its numbers chosen anew."""

    def follow(z):
        x, P, refused, found = z[0] + np.median(angle_difference(z[:start], z[0])), R, 0, []
        for reading in z:
            P, innovation = P + Q, angle_difference(reading, x)
            far = innovation**2 > 9 * (P + R)
            refused = refused + 1 if far else 0
            K = 1 if refused > patience else 0 if far else P / (P + R)
            x, P = x + K * innovation, (1 - K) ** 2 * P + K**2 * R
            found.append(x)
        return np.array(found)

    return follow


def medians(window=31, centred=False):
    """The median of the last readings, or of those on both sides, taken the short way round."""

    def follow(z):
        found, x = [], z[0] + np.median(angle_difference(z[:window], z[0]))
        for k in range(len(z)):
            first = max(0, k - window // 2) if centred else max(0, k - window + 1)
            last = k + window // 2 + 1 if centred else max(k + 1, window // 2)
            x = x + np.median(angle_difference(z[first:last], x))
            found.append(x)
        return np.array(found)

    return follow


def plain(z):
    """The lesson's scalar filter with the published Q and R."""
    return bearings.scalar_filter(z, 200, 500)


PASSING = {"gate": gate(), "median of the last 31": medians(), "median of 31, both sides": medians(centred=True)}
FAILING = {
    "raw readings": lambda z: z,
    "ignores the readings": lambda z: np.full(len(z), 180.0),
    "one value for all": lambda z: z[0] + np.full(len(z), np.median(angle_difference(z, z[0]))),
    "the filter of lesson 8": plain,
    "a gate that starts at the first reading": gate(1.0, 9.0, 10, 1),
    "a gate that opens too early": gate(patience=8),
    "a gate that stays shut": gate(patience=np.inf),
    "median without the short way": lambda z: np.array([np.median(z[max(0, k - 30) : k + 1]) for k in range(len(z))]),
}
