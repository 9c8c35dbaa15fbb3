"""What is said of trackers that do not pass the open exercise of lesson 26, where the mistake can be recognised.

The last signs run the tracker on a boat that goes straight on, read exactly and without false readings up to the last scan.
"""

import re

import numpy as np

from kflearn.exercises import _code_of
from kflearn.exercises._a_boat import STEPS, pda
from kflearn.exercises._shown import show

SPEED, CLUTTER = 7.0, 7.5e-4


def used_none(answer, answers, recordings):
    straight = [np.allclose(np.diff(a, n=2, axis=0), 0, atol=1e-9) for a in answers]
    return "Your positions lie on a straight line; the boat turns. Correct by the readings." if all(straight) else None


def is_a_reading(answer, answers, recordings):
    hits = [
        (np.linalg.norm(z - np.asarray(a)[:, None], axis=-1) < 1e-9).any(axis=1).mean()
        for a, ((z, _, _), _) in zip(answers, recordings, strict=True)
    ]
    if np.mean(hits) > 0.9:
        return "Nearly every position that you return is one of the readings. A false one then moves the boat as far as it likes: predict, and correct by a gain."
    return None


def is_the_mean(answer, answers, recordings):
    means = [np.allclose(a, np.nanmean(z, axis=1)) for a, ((z, _, _), _) in zip(answers, recordings, strict=True)]
    return "You return the mean of all readings of a scan. Most of them are false." if all(means) else None


def other_columns(answer, answers, recordings):
    """The boat's x, and something else for y; or y first."""
    error = np.median(
        [np.sqrt(np.mean((np.asarray(a) - t) ** 2, axis=0)) for a, (_, t) in zip(answers, recordings, strict=True)],
        axis=0,
    )
    turned = [
        np.sqrt(np.mean((np.asarray(a)[:, ::-1] - t) ** 2)) for a, (_, t) in zip(answers, recordings, strict=True)
    ]
    if np.median(turned) < 8 < error.min():
        return "Your columns are y and x. Wanted are x and y, in this order."
    if error[0] < 8 and error[1] > 25:
        return "Your first column follows x, but the second one does not follow y. The state is x, v_x, y, v_y: take its columns 0 and 2, in H as well."
    return None


OTHER_H = r"replace\([^)]*H *=[^)]*(eye\(2, *4|\[\[1\.?0?, *0\.?0?, *0\.?0?, *0\.?0?\], *\[0\.?0?, *1)"


def observed(answer, answers, recordings):
    """The lesson's model with another H."""
    if re.search(OTHER_H, _code_of.text_of(answer) or ""):
        return "Your H reads the numbers 0 and 1 of the state, x and v_x. The state is x, v_x, y, v_y: H must pick 0 and 2, and so must what you return."
    return None


def small_gate(answer, answers, recordings):
    """A gate that refuses the boat's own readings."""
    found = re.search(r"pda_filter\(.*?gate *= *(0?\.\d+)", _code_of.text_of(answer) or "", re.DOTALL)
    if found and float(found[1]) < 0.97:
        part = 100 - 100 * float(found[1])
        return f"Your gate is too small: it refuses {part:.3g} of 100 of the boat's own readings. The weights keep false ones low, so the gate can be wide: 0.99."
    return None


def takes_the_nearest(answer, answers, recordings):
    """The lesson's filter of the nearest reading."""
    text = _code_of.text_of(answer) or ""
    if "nearest_filter(" not in text:
        return None
    turns = "" if "nearest_filter(plane," in text else " And Q must be large enough for a boat that turns."
    return f"Your filter takes the nearest reading for the boat's, and cannot know when it is led away. Weigh all that are in the gate.{turns}"


# ---- what a tracker does with a boat that goes straight on


def course(answer, *last, before=(0.0,), rows=2):
    """The last position for such a boat, if the last scan holds readings so far east of it, and the one before it others.

    rows: in each scan; those without a reading are NaN.
    """
    track = np.stack([SPEED * np.arange(1, STEPS + 1), np.zeros(STEPS)], axis=1)
    z = np.full((STEPS, rows, 2), np.nan)
    z[:-2, 0] = track[:-2]
    for k, readings in ((-2, before), (-1, last)):
        for row, off in enumerate(readings):
            z[k, row] = track[k] + np.array([off, 0])
    return np.asarray(answer(z, np.array([0.0, SPEED, 0.0, 0.0]), CLUTTER), float)[-1]


def pulled(answer, *last, before=(0.0,)):
    """How far east the last scan's readings move the boat."""
    return course(answer, *last, before=before)[0] - course(answer, 0.0, before=before)[0]


def start_of(answer, answers, recordings):
    """Where the boat goes from the start, without any reading."""
    nothing = np.full((STEPS, 2, 2), np.nan)
    place = np.asarray(answer(nothing, np.array([0.0, SPEED, 100.0, -2.0]), CLUTTER), float)[9]
    if np.allclose(place, [70, 80], atol=1):
        return None
    if np.allclose(place, [63, 82], atol=1):
        return (
            "With `start` = [0, 7, 100, −2] and no reading at all your boat is at [63, 82] after ten scans: that is where it is after nine. The start is one step "
            "before the first scan: predict once before it, and return the position of each scan after its readings."
        )
    return (
        f"With `start` = [0, 7, 100, −2] and no reading at all your boat is at {show(np.round(place, 1))} after ten scans. It should be at [70, 80]: "
        "predict in every scan; and the state is x, v_x, y, v_y, in F and H too."
    )


def no_gate(answer, answers, recordings):
    """A reading that is far off moves the boat."""
    way = pulled(answer, 200.0)
    if abs(way) < 20:
        return None
    return (
        f"Without any other reading in a scan, one that is 200 m from where the boat must be moves your boat by {way:.0f} m. Such a reading is false: "
        "it is outside every gate, and “none of them is the boat's” has a weight too."
    )


def blind(answer, answers, recordings):
    """No reading counts in a scan with a row of NaN."""
    single = course(answer, 6.0, rows=1)[0] - course(answer, 0.0, rows=1)[0]
    if abs(pulled(answer, 6.0)) > 0.01 or single < 0.5:
        return None
    return (
        f"A reading that is the only row of its scan and 6 m off moves your boat by {single:.2g} m. With a row of NaN beside it the boat does "
        "not move. A row of NaN is no reading, and what `argmin`, `min` or `sum` make of it is no number: leave these rows out first."
    )


def alone(answer, answers, recordings):
    """Of two readings only the nearer one counts, or both count alike."""
    both, near, far, mean = (pulled(answer, *last) for last in ((4.0, -10.0), (4.0,), (-10.0,), (-3.0,)))
    if abs(far) < 0.1 or near < 0:  # it is outside the gate; or the boat moves away, which `stiff` says
        return None
    two = "Of two readings in the gate, 4 m east and 10 m west of where the boat should be,"
    if abs(both - near) < 1e-6:
        return f"{two} only the nearer one moves your boat. When that is a false one, nothing holds it back: weigh all that are in the gate."
    if abs(both - mean) < 1e-6 and abs(both) > 0.1:
        return f"{two} each has the same weight, as if you took their mean. Weigh each by e^(−NIS/2), with a weight b for “none of them”."
    return None


def stiff(answer, answers, recordings):
    """How much of a distance a single reading takes away, beside what boats that turn less or more would need."""
    share, low, high = (pulled(each, 6.0) / 6 for each in (answer, pda(0.2), pda(1.5)))
    said = f"After {STEPS - 1} exact readings on a straight line one that is 6 m off moves your boat by {6 * share:.2g} m; for a boat that turns it should be 2 to 4 m."
    if share < -0.01:
        return f"A reading that is 6 m east of where the boat should be moves your boat by {-6 * share:.2g} m to the west: the innovation is the reading minus H x."
    if share < low:
        return (
            f"{said} The gain, or the weight of the reading, is too small: is Q too small (with Q = 0 the gain goes to zero), R larger than 25 m², "
            "P not corrected, or b too large?"
        )
    if share > high:
        return f"{said} The gain is too large: is Q too large, or R smaller than 25 m²?"
    return None


SCANS = [
    ("one reading 6 m off", (6.0,), (0.0,), "the gain: Q, R and P"),
    ("one reading 15 m off", (15.0,), (0.0,), "the gate, and e^(−NIS/2)"),
    ("a scan with two, 4 m east and 10 m west,", (4.0, -10.0), (0.0,), "the weights"),
    (
        "one reading 6 m off, after a scan with two, 10 m east and 10 m west,",
        (6.0,),
        (10.0, -10.0),
        "how far the readings are apart makes P larger",
    ),
    ("one reading 6 m off, after a scan without any,", (6.0,), (), "without a reading P does not become smaller"),
]


def compared(answer, answers, recordings):
    """What single scans do, beside the lesson's PDA, where the two differ most."""
    rows = []
    for name, last, before, look in SCANS:
        mine, right = (pulled(each, *last, before=before) for each in (answer, pda()))
        words = f"{name} moves your boat by {mine:.2g} m, that of the lesson's PDA by {right:.2g} m ({look})"
        rows.append((abs(mine - right) / (abs(right) + 1), words))
    told = [words for off, words in sorted(rows, reverse=True)[:2] if off > 0.05]
    return f"After a course straight on, {'; '.join(told)}." if told else None


SIGNS = (
    used_none,
    is_the_mean,
    is_a_reading,
    other_columns,
    observed,
    takes_the_nearest,
    small_gate,
    start_of,
    no_gate,
    blind,
    alone,
    stiff,
    compared,
)
