"""Lesson 25, `clock_offset`: wrong answers, each with the sentence that it gets."""

import numpy as np


def shifted(v, late, j):
    return np.corrcoef(v[: len(v) - j], late[j:])[0, 1]


def scores(v, late):
    return [shifted(v, late, j) for j in range(11)]


def other_way(v, late):
    return [np.corrcoef(v[j:], late[: len(late) - j])[0, 1] for j in range(11)]


def products(v, late):
    """Sums of products, the means not taken off."""
    return [np.sum(v[: len(v) - j] * late[j:]) for j in range(11)]


def wrong_one(v, late, dt):
    return np.argmin([np.std(v[d:] - late[: len(v) - d]) for d in range(11)]) * dt


def empty_slice(v, late, dt):
    """For d = 0 nothing is left, and NaN is taken for the smallest."""
    return np.argmin([np.std(late[d:] - v[:-d]) if d else np.nan for d in range(11)]) * dt


BY_DIFFERENCE = {
    "mean squared": (lambda a, b: np.mean((a - b) ** 2), "the mean squared difference"),
    "summed squared": (
        lambda a, b: np.sum((a - b) ** 2),
        "the sum of squared differences (which also has fewer terms for a large shift)",
    ),
    "mean absolute": (lambda a, b: np.mean(abs(a - b)), "the mean absolute difference"),
    "summed absolute": (
        lambda a, b: np.sum(abs(a - b)),
        "the sum of absolute differences (which also has fewer terms for a large shift)",
    ),
    "median absolute": (lambda a, b: np.median(abs(a - b)), "the median absolute difference"),
    "mean difference": (lambda a, b: abs(np.mean(a - b)), "the mean difference"),
}

OFFSET = (
    "One instrument may show an offset, and {} mixes it with the shift. Take it out: compare by the standard deviation of "
    "late[j:] − v[:len(v) − j], or by the correlation."
)


def lags(v, late, score):
    """A number for each shift from 0 to 10."""
    return [score(v[: len(v) - j], late[j:]) for j in range(11)]


OFFSETS = {
    f"by difference: {label}": (
        lambda v, late, dt, score=score: np.argmin(lags(v, late, score)) * dt,
        OFFSET.format(words),
    )
    for label, (score, words) in BY_DIFFERENCE.items()
}


def whole(v, late):
    """The cross-correlation of the whole series, the means taken off, from the shift −(T − 1) on."""
    return np.correlate(late - late.mean(), v - v.mean(), "full")


def from_one_step_on(v, late, dt):
    found = [np.corrcoef(v[:-j], late[j:])[0, 1] for j in range(1, 11)]
    return dt * (1 + np.argmax(found))


WRONG = (
    {
        "steps": (
            lambda v, late, dt: float(np.argmax(scores(v, late))),
            "That is the number of steps. Seconds were asked for: times dt.",
        ),
        "0 to 9 only": (
            lambda v, late, dt: np.argmax(scores(v, late)[:10]) * dt,
            "That is the best of the shifts 0 to 9. Try 10 steps as well: `range(10)` ends at 9.",
        ),
        "negative": (
            lambda v, late, dt: -np.argmax(scores(v, late)) * dt,
            "The size is right. The second series is late, and the delay is asked for as a positive number.",
        ),
        "other way": (
            lambda v, late, dt: np.argmax(other_way(v, late)) * dt,
            "That is the best delay of v, with the other series shifted. If `late` is late by j steps, `late[j:]` belongs to `v[:len(v) - j]`.",
        ),
        "smallest": (
            lambda v, late, dt: np.argmin(scores(v, late)) * dt,
            "That is the shift at which the two are least alike. Take the largest correlation.",
        ),
        "mean not taken off": (
            lambda v, late, dt: np.argmax(products(v, late)) * dt,
            "That is where the sum of products is largest, with the means not taken off: such a sum is large where there are many terms, at a small shift. Use the correlation.",
        ),
        "one step too many": (
            lambda v, late, dt: (np.argmax(scores(v, late)) + 1) * dt,
            "One step too many in every trial. Does your first shift, number 0, mean no shift at all?",
        ),
        "one step too few": (
            lambda v, late, dt: (np.argmax(scores(v, late)) - 1) * dt,
            'One step too few in every trial. Which place of your list stands for the shift 0? (In `np.correlate(…, "full")` it is T − 1.)',
        ),
        "the correlation itself": (
            lambda v, late, dt: np.max(scores(v, late)),
            "That is the largest correlation itself. Its place in the list, times dt, was asked for.",
        ),
        "divided by dt": (
            lambda v, late, dt: np.argmax(scores(v, late)) / dt,
            "That is the number of steps divided by dt. A number of steps *times* the length of a step is a time.",
        ),
        "five shifts only": (
            lambda v, late, dt: np.argmax(scores(v, late)[:5]) * dt,
            "That is the best of the shifts 0 to 4. The delay is 0 to 10 steps: that makes eleven.",
        ),
        "wrong one, difference": (
            wrong_one,
            "That is the best delay of v, with v shifted in place of late. If `late` is late by d steps, `late[d:]` belongs to `v[:len(v) - d]`.",
        ),
        "begins at one": (
            lambda v, late, dt: np.argmin([np.std(late[d:] - v[: len(v) - d]) for d in range(1, 11)]) * dt,
            "Your first shift is one step, and place 0 of your list stands for it. Begin with the shift 0.",
        ),
        "begins at one, correlation": (
            lambda v, late, dt: np.argmax([np.corrcoef(late[d:], v[: len(v) - d])[0, 1] for d in range(1, 11)]) * dt,
            "Your first shift is one step, and place 0 of your list stands for it. Begin with the shift 0.",
        ),
        "largest values": (
            lambda v, late, dt: (np.argmax(late) - np.argmax(v)) * dt,
            "One largest value is a matter of chance: noise, or the ends of the series, decide. Compare all values, for each shift from 0 to 10.",
        ),
        "mean accelerations": (
            lambda v, late, dt: np.mean(v - late) / np.mean(np.gradient(v, dt)),
            "Over a whole drive the mean acceleration is small, and an offset of the instrument looks like a delay. Try each shift and take the best match.",
        ),
        "an empty slice": (
            empty_slice,
            "Your result is 0 whatever the data are: `argmin` and `argmax` pick a NaN. `v[:len(v) - d]` is right for d = 0 too.",
            r"nan|\[: *-|empty_slice",
        ),
    }
    | OFFSETS
    | {
        "index of all shifts": (
            lambda v, late, dt: np.argmax(whole(v, late)) * dt,
            'That is the place in `np.correlate(…, "full")`, times dt. Its place 0 is the shift −(T − 1): take T − 1 off, then times dt.',
        ),
        "index of all shifts, turned": (
            lambda v, late, dt: np.argmax(whole(late, v)) * dt,
            'That is the place in `np.correlate(v, late, "full")`, times dt. Its place T − 1 is the shift 0, and a delay of `late` stands before it: '
            "T − 1 minus the place, times dt.",
        ),
        "index from the middle of T": (
            lambda v, late, dt: (np.argmax(whole(v, late)) - len(v) // 2) * dt,
            'In `np.correlate(…, "full")` the shift 0 stands at the place T − 1, not at T // 2: take T − 1 off.',
        ),
        "index of half of the shifts": (
            lambda v, late, dt: np.argmax(np.correlate(late - late.mean(), v - v.mean(), "same")) * dt,
            'That is the place in `np.correlate(…, "same")`, times dt. The shift 0 stands at its place T // 2: take that off, then times dt.',
        ),
    }
    | {
        f"difference of the speeds, {name}, {power}, {i}": (
            lambda v, late, dt, middle=middle, sign=sign, power=power: sign(middle(late - v)) * dt**power,
            f"That is made of the {name} difference of the two speeds: the offset, in {unit}. The delay in s was asked for.",
        )
        for name, middle in (("mean", np.mean), ("median", np.median))
        for power, unit in ((0, "m/s"), (1, "m/s times s"), (-1, "m/s²"))
        for i, sign in enumerate((np.positive, np.negative, np.abs))
    }
    | {
        "mean product": (
            lambda v, late, dt: np.argmax(lags(v, late, lambda a, b: np.mean(a * b))) * dt,
            "That is the shift at which the mean product is largest, with the means not taken off: which stretch of the drive is the faster one then "
            "counts as well. Use the correlation.",
        ),
        "the same stretch": (
            lambda v, late, dt: np.argmax([np.corrcoef(v[j:], late[j:])[0, 1] for j in range(11)]) * dt,
            "In your pairs the same stretch of both is cut off, so nothing is shifted. If `late` is late by j steps, `late[j:]` belongs to `v[:len(v) - j]`.",
        ),
        "the same stretch, at the end": (
            lambda v, late, dt: (
                np.argmax([np.corrcoef(v[: len(v) - j], late[: len(v) - j])[0, 1] for j in range(11)]) * dt
            ),
            "In your pairs the same stretch of both is cut off, so nothing is shifted. If `late` is late by j steps, `late[j:]` belongs to `v[:len(v) - j]`.",
        ),
        "itself": (
            lambda v, late, dt: np.argmax(lags(v, late, lambda a, b: np.corrcoef(a, b)[0, 0])) * dt,
            "`np.corrcoef(a, b)[0, 0]` is the correlation of a with itself, 1 at every shift. That of a with b is `[0, 1]`.",
            r"corrcoef\([^\n]*\)\[0, ?0\]|corrcoef[^\n]*\[\(0, 0\)\]",
        ),
        "variance of one": (
            lambda v, late, dt: np.argmax(lags(v, late, lambda a, b: np.cov(a, b)[0, 0])) * dt,
            "That is the shift at which the part of v that is left scatters most: `np.cov(a, b)[0, 0]` is the variance of a alone. Take `[0, 1]`.",
        ),
        "all four": (
            lambda v, late, dt: np.argmax(lags(v, late, np.corrcoef)) * dt,
            "`np.corrcoef(a, b)` is a matrix of four numbers, and `argmax` counts all of them. The correlation of a with b is its entry `[0, 1]`.",
        ),
        "largest scatter": (
            lambda v, late, dt: np.argmax(lags(v, late, lambda a, b: np.std(a - b))) * dt,
            "That is the shift at which the difference scatters most. At the right one it scatters least: `argmin`.",
        ),
        "smallest values": (
            lambda v, late, dt: (np.argmin(late) - np.argmin(v)) * dt,
            "One smallest value is a matter of chance: noise, or the ends of the series, decide. Compare all values, for each shift from 0 to 10.",
        ),
        "first above the mean": (
            lambda v, late, dt: (np.argmax(late > late.mean()) - np.argmax(v > v.mean())) * dt,
            "One crossing of the mean is a matter of chance: noise, or the ends of the series, decide. Compare all values, for each shift from 0 to 10.",
        ),
        "always 0": (
            lambda v, late, dt: 0.0,
            "Your result is 0 in every trial. Print what you compare for each shift from 0 to 10: are there eleven numbers, and do they differ?",
        ),
        "always the longest": (
            lambda v, late, dt: 10 * dt,
            "Your result is 10 steps in every trial. Print what you compare for each shift: does it only grow with the number of terms?",
        ),
        "correlations": (
            lambda v, late, dt: lags(v, late, lambda a, b: np.corrcoef(a, b)[0, 1]),
            "These are the correlations at each shift, and they are right. The place of the largest one, times dt, is the delay.",
        ),
        "difference by slope": (
            lambda v, late, dt: np.mean(v - late) / np.mean(np.diff(v) / dt),
            "That is the mean difference of the two series divided by the mean slope of the first. An offset between the instruments is in that "
            "difference, and a drive that stops and goes has hardly a mean slope. Compare the shapes: shift one series step by step.",
        ),
        "0 not tried": (
            from_one_step_on,
            "That is the best of the shifts 1 to 10: the shift 0 is not tried. (`v[:-0]` is empty, but `v[: len(v) - "
            "j]` is right for j = 0 too.)",
        ),
        "difference by mean size": (
            lambda v, late, dt: np.mean(v - late) / (np.mean(abs(np.diff(v))) / dt),
            "That is the mean difference of the two series, divided by the mean size of the acceleration. The "
            "difference holds the offset of an instrument, and that is no delay. Shift one series step by step and "
            "compare.",
        ),
        "rolled": (
            lambda v, late, dt: dt * np.argmin([np.mean((late - np.roll(v, j)) ** 2) for j in range(11)]),
            "`np.roll` takes the end of the drive to its beginning, and there it is compared with what it has nothing to do with. Compare the "
            "parts that belong together alone: `late[j:]` and `v[:len(v) - j]`, without their means.",
        ),
    }
)
