"""Wrong answers to exercises of lessons 11 to 29 that a tenth group of strangers gave, each with its sentence."""

import numpy as np

from kflearn.exercises._fitted_R import best


def one_step_on(z0, z1, dt, R):
    """The start of two fixes, predicted by one dt more."""
    v = (z1 - z0) / dt
    return np.array([z1 + v * dt, v]), R * np.array([[5, 3 / dt], [3 / dt, 2 / dt**2]])


def run_before(z, T):
    """The second reading of the run before is subtracted; run 1 has none before it."""
    before = np.vstack([z[:1, 0], z[:-1, 1]])
    speed = (z[:, 1] - before) / T
    return z[:, 0], np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)


def with_a_tiny_number(log_weights, log_likelihoods):
    s = log_weights + log_likelihoods
    return s - np.log(np.exp(s).sum() + 1e-300)


def raised_to_a_lowest(log_weights, log_likelihoods):
    s = np.maximum(log_weights + log_likelihoods, -700)
    return s - np.log(np.exp(s).sum())


def terms(y, S):
    return -0.5 * (np.log(2 * np.pi * S) + y**2 / S)


def from_one_step_on(v, late, dt):
    found = [np.corrcoef(v[:-j], late[j:])[0, 1] for j in range(1, 11)]
    return dt * (1 + np.argmax(found))


def hole_closed(time, z):
    """The steps, of which those longer than five medians are set to the median."""
    steps = np.diff(time[~np.isnan(z)])
    return np.where(steps > 5 * np.median(steps), np.median(steps), steps)


def of_sixteen():
    """The first consider correction from P⁻ = diag(16, 1)."""
    k = 16 / 17.25
    kept = np.array([[1 - k, -k], [0, 1]])
    return kept @ np.diag([16, 1]) @ kept.T + 0.25 * np.diag([k**2, 0])


WRONG = {
    "report": {
        "root of the mean distance": (
            lambda errors: (errors.mean(axis=0), np.sqrt(np.mean(np.hypot(*errors.T)))),
            "The mean is right. The second number is the root of the mean distance, and no square was taken before: "
            "the root belongs to the mean of the *squared* distances.",
        ),
    },
    "two_point_start": {
        "one dt missing": (
            lambda z0, z1, dt, R: (np.array([z1, (z1 - z0) / dt]), R * np.array([[1, 1], [1, 2 / dt]])),
            "The mean is right. In P one division by dt is missing in the corners and one in the lower right: the "
            "corner is in m · m/s, the speed's variance in (m/s)².",
        ),
        "predicted, P too": (
            one_step_on,
            "That is the belief one dt after the second fix, predicted. Asked is the one at the time of z₁ itself.",
        ),
    },
    "left_over": {
        "miss times the cube": (
            lambda e, v, t0, t: (e + v * t0) * (t / t0) ** 3,
            "That is b·t³ alone, with (e + v·t₀)/t₀³ for b. At t = t₀ it should be e. Fit a·t + b·t³ to both: its "
            "value at t₀ is e, its slope against t is −v.",
        ),
    },
    "memory": {
        "both for short steps": (
            lambda lasts, sd, dt: (1 - dt / lasts, 2 * sd**2 * dt / lasts),
            "Nearly: 1 − dt/lasts and 2·sd²·dt/lasts hold for short steps only. Take the exponential for the part; "
            "the noise then fills part²·sd² up to sd².",
        ),
        "lost and left": (
            lambda lasts, sd, dt: (1 - np.exp(-dt / lasts), sd**2 * np.exp(-2 * dt / lasts)),
            "Your first number is the part that fades in a step, your second the variance that survives it. Asked are "
            "the other two: the part that survives, and the variance that fades and must be added again.",
        ),
    },
    "three_points": {
        "weights of the covariance": (
            lambda: 200 + 200 / 3 + 100 / 3 * np.cos(np.radians(30) * 3**0.5),
            "287.2 is what the weights of the covariance, Wc, make of the images: with β = 2 their sum is 3. A mean "
            "takes the weights Wm, whose sum is 1.",
        ),
    },
    "mended_start": {
        "the run before": (
            run_before,
            "The positions are right, and so is the speed of run 1. In the others the second reading of the run "
            "*before* is subtracted: each run has a first reading of its own, z[:, 0].",
        ),
    },
    "first_velocity": {
        "root of p s": (
            lambda p, s, R, y: np.sqrt(p * s) / (p + s + R) * y,
            "S below is right. On top you have √(p·s), as if place and velocity had erred together before. Only the "
            "prediction ties them: F P Fᵀ has s in its corner.",
        ),
    },
    "gravity": {
        "larger than 209": (
            lambda rows: 0 if min(rows) > 209 else 6,
            "It answers as if only `min(rows) > 209` were asked: a row of 212 then counts as near, and so may a NaN. "
            "Each of the three must be less than 1 px away, above *and* below.",
        ),
    },
    "dark_time": {
        "speed for position": (
            lambda dv, b, allowed: (allowed - dv) / b,
            "That solves dv + b·t = allowed: after this time the *speed* is wrong by `allowed`. It is the position "
            "that is asked for: how many metres does each of the two make?",
        ),
        "both accelerations": (
            lambda dv, b, allowed: np.sqrt(2 * allowed / (dv + b)),
            "That solves (dv + b)·t²/2 = allowed, as if dv were an acceleration too. A wrong speed makes metres that "
            "grow with t; only the bias's grow with t².",
        ),
    },
    "inflated": {
        "fresh part of the bias": (
            lambda: 0.09 + 0.25 * (1 - np.exp(-0.1)),
            "0.114 is 0.09 + 0.25 · (1 − φ²), with what is new in the bias after one step. The whole bias is in each "
            "reading, so its whole variance counts.",
        ),
    },
    "first_covariance": {
        "4 squared": (
            of_sixteen,
            "That is right for P⁻ = diag(16, 1), with 4 squared. P⁻ holds variances already: S = 4 + 1 + 0.25.",
        ),
    },
    "weigh": {
        "a tiny number added": (
            with_a_tiny_number,
            "It answers as if 1e-300 were added to Σ exp(s). Where all s are very low that number is all there is, "
            "and the weights do not sum to 1. Take the largest s off first: then the sum is never 0.",
        ),
        "raised to −700": (
            raised_to_a_lowest,
            "It answers as if each sum below −700 were raised to −700 first: such weights all look alike then. Take "
            "the largest sum off before exp, and none needs a lowest value.",
        ),
    },
    "log_likelihood": {
        "up to the first gap": (
            lambda y, S: np.sum(terms(y, S)[: np.argmax(np.append(np.isnan(y), True))]),
            "It answers as if the run ended at the first gap. A gap counts nothing, and the readings after it count "
            "again (in a loop: `continue` in place of `break`).",
        ),
        "sum of the heights": (
            lambda y, S: np.log(np.nansum(np.exp(terms(y, S)))),
            "That is the logarithm of the *sum* of the heights. All readings are to hold together, so the heights are "
            "multiplied: add their logarithms.",
        ),
        "mean S": (
            lambda y, S: np.nansum(terms(y, np.mean(S))),
            "It answers as if each reading had the same variance, the mean of all S. Each innovation has an S of its "
            "own.",
        ),
    },
    "half_missing": {
        "less a half": (
            3.5,
            "3.5 is 4 − ½. The ½ is a factor of one of the two parts; nothing is taken off R. Where is the slope of "
            "½·4/R + log R zero?",
        ),
    },
    "fitted_R": {
        "0 in the gaps": (
            lambda z, Q: best(np.nan_to_num(z), Q),
            "That is about what comes out if a reading of 0 stands in each gap. NaN means that there is no reading: "
            "leave it in, and the filter only predicts there.",
        ),
    },
    "clock_offset": {
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
    },
    "clock": {
        "hole closed": (
            hole_closed,
            "The steps of the hole are shortened to the median. That time did pass: leave each step as long as the "
            "clock says.",
        ),
    },
    "newest_ten": {
        "j from 1 to 9": (
            lambda: sum(0.15 * 0.85**j for j in range(1, 10)),
            "0.653 is the sum for j = 1 to 9. The newest reading, with j = 0, is one of the ten, and has the largest "
            "weight.",
        ),
    },
}
