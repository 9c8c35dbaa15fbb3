"""Wrong answers to exercises of lesson 25 that a fifth group of strangers gave, and more of their kind."""

import numpy as np


def lags(v, late, score):
    """A number for each shift from 0 to 10."""
    return [score(v[: len(v) - j], late[j:]) for j in range(11)]


def whole(v, late):
    """The cross-correlation of the whole series, the means taken off, from the shift −(T − 1) on."""
    return np.correlate(late - late.mean(), v - v.mean(), "full")


OFFSET = (
    "One instrument may show an offset, and {} mixes it with the shift. Take it out: compare by the standard deviation of "
    "late[j:] − v[:len(v) − j], or by the correlation."
)
BY_DIFFERENCE = {
    "mean squared": (lambda a, b: np.mean((a - b) ** 2), "the mean squared difference"),
    "summed squared": (lambda a, b: np.sum((a - b) ** 2), "the sum of squared differences (which also has fewer terms for a large shift)"),
    "mean absolute": (lambda a, b: np.mean(abs(a - b)), "the mean absolute difference"),
    "summed absolute": (lambda a, b: np.sum(abs(a - b)), "the sum of absolute differences (which also has fewer terms for a large shift)"),
    "median absolute": (lambda a, b: np.median(abs(a - b)), "the median absolute difference"),
    "mean difference": (lambda a, b: abs(np.mean(a - b)), "the mean difference"),
}  # fmt: skip
OFFSETS = {
    f"by difference: {label}": (
        lambda v, late, dt, score=score: np.argmin(lags(v, late, score)) * dt,
        OFFSET.format(words),
    )
    for label, (score, words) in BY_DIFFERENCE.items()
}


WRONG = {
    "behind": {
        "the lesson's car": (-4.8, "−4.8 m is what 20 m/s makes, the lesson's car. The bus drives at 54 km/h = 15 m/s."),
        "the lesson's car, ahead": (
            4.8,
            "4.8 m is what 20 m/s makes, the lesson's car. The bus drives at 54 km/h = 15 m/s; and the reading lies behind it: −.",
        ),
        "the lesson's delay": (-1.5, "−1.5 m is what 0.1 s makes, the lesson's delay. Here it is 240 ms = 0.24 s."),
        "the lesson's delay, ahead": (
            1.5,
            "1.5 m is what 0.1 s makes, the lesson's delay. Here it is 240 ms = 0.24 s; and the reading lies behind the bus: −.",
        ),
        "in kilometres": (-0.0036, "−0.0036 is the way in km. Metres were asked for."),
        "2.4 s": (-36, "−36 m is what 2.4 s makes. 240 ms are 0.24 s."),
        "0.024 s": (-0.36, "−0.36 m is what 0.024 s makes. 240 ms are 0.24 s."),
    },
    "clock_offset": OFFSETS
    | {
        "index of all shifts": (
            lambda v, late, dt: np.argmax(whole(v, late)) * dt,
            "That is the place in `np.correlate(…, \"full\")`, times dt. Its place 0 is the shift −(T − 1): take T − 1 off, then times dt.",
        ),
        "index of all shifts, turned": (
            lambda v, late, dt: np.argmax(whole(late, v)) * dt,
            "That is the place in `np.correlate(v, late, \"full\")`, times dt. Its place T − 1 is the shift 0, and a delay of `late` stands before it: "
            "T − 1 minus the place, times dt.",
        ),
        "index from the middle of T": (
            lambda v, late, dt: (np.argmax(whole(v, late)) - len(v) // 2) * dt,
            "In `np.correlate(…, \"full\")` the shift 0 stands at the place T − 1, not at T // 2: take T − 1 off.",
        ),
        "index of half of the shifts": (
            lambda v, late, dt: np.argmax(np.correlate(late - late.mean(), v - v.mean(), "same")) * dt,
            "That is the place in `np.correlate(…, \"same\")`, times dt. The shift 0 stands at its place T // 2: take that off, then times dt.",
        ),
        **{
            f"difference of the speeds, {name}, {power}, {i}": (
                lambda v, late, dt, middle=middle, sign=sign, power=power: sign(middle(late - v)) * dt**power,
                f"That is made of the {name} difference of the two speeds: the offset, in {unit}. The delay in s was asked for.",
            )
            for name, middle in (("mean", np.mean), ("median", np.median))
            for power, unit in ((0, "m/s"), (1, "m/s times s"), (-1, "m/s²"))
            for i, sign in enumerate((np.positive, np.negative, np.abs))
        },
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
            lambda v, late, dt: np.argmax([np.corrcoef(v[: len(v) - j], late[: len(v) - j])[0, 1] for j in range(11)]) * dt,
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
    },
}  # fmt: skip
