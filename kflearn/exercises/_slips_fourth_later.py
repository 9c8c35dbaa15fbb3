"""Wrong answers to exercises of lessons 14 to 28 that a fourth group of strangers gave, and more of their kind."""

import numpy as np
from scipy import ndimage


def widths(differs):
    """Half of the width of the largest region, which is the cable."""
    labels, _ = ndimage.label(differs)
    columns = np.argwhere(labels == 1 + np.bincount(labels.ravel())[1:].argmax())[:, 1]
    return (columns.max() - columns.min() + 1) / 2


def background(differs):
    return np.sqrt(np.bincount(ndimage.label(differs)[0].ravel()).max() / np.pi)


def cut_off(floor):
    """Weights that are never smaller than a floor."""

    def weigh(log_weights, log_likelihoods):
        s = log_weights + log_likelihoods
        p = np.exp(s - s.max())
        return np.log(np.maximum(p / p.sum(), floor))

    return weigh


def over_the_wrong_axis(p, means, covs):
    off = means - p @ means
    return p @ covs + off.T @ np.diag(p) @ off


def whole_seconds(dv, b, allowed):
    t = 0
    while dv * t + b * t**2 / 2 < allowed:
        t += 1
    return t


def twice(x, dx, K, fix):
    x = x + dx
    return x + K @ (fix - x[:2] - dx[:2]), 0 * dx


def overwritten(x, P, F, Q, x_next, P_next):
    x, P = F @ x, F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(P)
    return x + G @ (x_next - x), P + G @ (P_next - P) @ G.T


def wrong_one(v, late, dt):
    return np.argmin([np.std(v[d:] - late[: len(v) - d]) for d in range(11)]) * dt


def empty_slice(v, late, dt):
    """For d = 0 nothing is left, and NaN is taken for the smallest."""
    return np.argmin([np.std(late[d:] - v[:-d]) if d else np.nan for d in range(11)]) * dt


def after_the_sum(z, expected, S, detection, clutter):
    nis = (z - expected) ** 2 / S
    e, b = np.exp(-nis / 2), clutter * np.sqrt(2 * np.pi * S) * (1 - detection * 0.99) / detection
    w = np.append(b, e) / (b + e.sum())
    w[1:][nis > 6.635] = 0
    return w


def from_one(K, n):
    w = K * (1 - K) ** np.arange(1, n + 1)
    w[-1] = 1 - w[:-1].sum()
    return w


def slope_of(t0, e, v, t):
    a, b = np.linalg.solve([[t0, t0**3], [-1, -3 * t0]], [e, v])
    return a * t + b * t**3


def growth(x):
    """The slope of the growth model, and where it moves a place without a push."""
    return 0.5 + 25 * (1 - x**2) / (1 + x**2) ** 2, x / 2 + 25 * x / (1 + x**2)


def two_slopes(x, P, u):
    """The mean of the slopes at the old and at the new place."""
    new = growth(x)[1] + u
    F = (growth(x)[0] + growth(new)[0]) / 2
    return new, F * P * F + 10


def every_step(time, z):
    return np.full(len(z) - 1, np.median(np.diff(time)))


ONE_SIGMA = 0.09 * np.array([1 - np.sqrt(2 / 40), 1 + np.sqrt(2 / 40)])
WRONG = {
    "true_starts": {
        "mean stretched": (
            lambda mean, P0, normal: (mean + normal) * np.sqrt(np.diag(P0)),
            "You stretched the mean too. Multiply only `normal` by σ, then add the mean.",
        ),
    },
    "mended_prediction": {
        "two slopes": (two_slopes, "Half of your slope still comes from the new place. Take the one at the old x alone."),
    },
    "bearing_variance": {
        "180 squared": (
            lambda sd: sd * np.pi / 180**2,
            "The square reaches only the 180. Put brackets round the whole: `(sd * np.pi / 180) ** 2`.",
        ),
    },
    "left_over": {
        "t0 not squared": (
            lambda e, v, t0, t: slope_of(t0, e, v, t),
            "The slope of b·t³ is 3·b·t²: in the second row t₀ needs a square.",
            r"slope_of|3(\.0)? *\* *t0\b(?! *\*\*)|t0 *\* *3\b",
        ),
    },
    "start_sigma": {
        "about the mean": (
            lambda: np.std([-500, -300, -40]),
            "188 m is the scatter of the three errors about their mean, as `np.std` gives it. The errors count from zero: the root of the mean of their squares.",
        ),
    },
    "three_points": {
        "degrees": (
            lambda: 2 / 3 * 100 * np.sin(90) + 1 / 6 * 100 * (np.sin(90 + 52) + np.sin(90 - 52)),
            "That is what comes out if NumPy's sine is given degrees. It wants radians: `np.sin(np.radians(90))`.",
        ),
        "the lesson's radar": (94.09, "That is the lesson's radar. Here the distance is exactly 100 m, and σ = 30°."),
    },
    "blended_sigma": {
        "100": (100, "Wider than each, but not so wide: √(30² + the squared distance of each mean from the middle)."),
    },
    "twin_velocity": {
        "three numbers": (
            (-3, -2, 5000),
            "Two numbers are wanted. (−3, −2) is the target's velocity relative to us: double it, and add ours.",
        ),
    },
    "true_radius": {
        "half of the width": (
            widths,
            "That is half the width of the largest region, the cable. Let the erosions choose the ball, then count its pixels: √(area/π).",
        ),
        "background": (background, "The label 0 is the background, and it is the largest: leave it out. And the erosions choose the ball."),
    },
    "coast": {
        "push squared": (
            lambda x, P, F, push, Q: (F @ x + push, F @ P @ F.T + Q + np.outer(push, push)),
            "The state is right. The push is known, so it moves the state and adds no uncertainty to P.",
        ),
    },
    "dark_time": {
        "/ 2 * a": (
            lambda dv, b, allowed: (-dv + np.sqrt(dv**2 + 2 * b * allowed)) / 2 * (b / 2),
            "`/ 2 * a` divides by 2 and then multiplies by a: write `/ (2 * a)`.",
        ),
        "whole seconds": (whole_seconds, "Those are whole seconds, rounded up. The time is no whole number: solve the equation for t."),
    },
    "mended_fix": {
        "dx off twice": (twice, "Your x holds dx already, and you subtract dx[:2] from the fix once more: compare the fix with x + dx once."),
    },
    "all_bias": {
        "as in the lesson": (21.6, "That number is from the lesson's table. Here the learnt 0.13 meets a sensor error of 0.07."),
    },
    "economical": {
        "star": (
            lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading * F * C, fading**2 * B + q),
            "In C you multiply entry by entry, by `*`. The product of matrices is `@`: `fading * F @ C`.",
        ),
    },
    "honest_average": {
        "fused": (
            lambda N, R, B: np.sqrt(1 / (N / R + 1 / B)),
            "That is what fusing noise and bias gives, like two readings. They are two errors of one average, so their variances add: R/N + B.",
        ),
    },
    "window_needed": {
        "0.3 squared": (238, "238 is right for S = 1 + 0.3². HP⁻Hᵀ is a variance already: S = 1 + 0.3."),
        "of a σ": (85, "S/√(2N) is the scatter of a standard deviation. R̂ is a variance: S √(2/N)."),
    },
    "weigh": {
        f"floor of {floor:g}": (
            cut_off(floor),
            "A floor forgets how far behind a model is: all below it look alike. Stay in logarithms, s − log Σ exp(s).",
        )
        for floor in (1e-300, 1e-308, 1e-200, 1e-100, 1e-50, 1e-30, 1e-20, 1e-16, 1e-15, 1e-12, 1e-10, 1e-9, 1e-8, 1e-6)
    },
    "mixture_cov": {
        "p @ covs": (
            over_the_wrong_axis,
            "`p @ covs` multiplies over the wrong axis of (M, n, n): use `np.einsum('m,mij->ij', p, covs)`.",
            r"p @ covs|over_the_wrong|(dot|matmul)\(p, covs",
        ),
    },
    "moved_or_noisy": {
        "A, B": ({"A", "B"}, "Choose one, please. White noise would leave the neighbours near 0: only one of A and B can make 0.85."),
        "B, C": ({"B", "C"}, "Choose one, please. If B can be told from A, then C is wrong: does the third printed number tell it?"),
        "A, C": ({"A", "C"}, "The right one is none of these. Neighbours that correlate by 0.85 are not white, so not A; and this tells the two apart."),
        "all": ({"A", "B", "C"}, "Choose one, please: the three exclude one another. The third printed number decides."),
    },
    "real_gap": {
        "A, B": ({"A", "B"}, "Choose one, please. Divide the two printed errors, 0.39/0.43: is that nearer to a half or to nine tenths?"),
        "B, C": ({"B", "C"}, "Choose one, please. The printed difference is −0.032: with the minus, which of the two errors is the smaller one?"),
        "A, C": ({"A", "C"}, "The right one is none of these: 0.39/0.43 is neither a half nor more than 1."),
        "all": ({"A", "B", "C"}, "Choose one, please: the three exclude one another. Divide the two printed errors."),
    },
    "step_back": {
        "overwritten": (
            overwritten,
            "You put the prediction in the place of x and P. G and the result need the filter's own: give the prediction other names.",
        ),
        "the filter's": (
            lambda x, P, F, Q, x_next, P_next: (x, P),
            "That is the filter's own belief: x_next and P_next are not used yet.",
        ),
    },
    "one_reading": {"as in the lesson": (-640.23, "That is the sum over a whole record of the lesson. Here it is one reading: y = 3, S = 5.")},
    "half_missing": {"the Nile": (15099, "That is the R of the Nile. Here the true R is 4.")},
    "behind_25": {"as in the lesson": (-2.0, "That is the lesson's number. Here it is 15 m/s times 0.24 s.")},
    "clock_offset": {
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
    },
    "false_in_gate": {
        "one component": (np.pi * 6.635 * 30 * 5e-4, "6.635 is the limit for one component. Here are two, and the text gives 9.21."),
        "as in the lesson": (0.591, "That is the lesson's gate. Here the determinant of S is 36 · 25, and λ is 0.0005."),
    },
    "weights": {
        "gate after the sum": (
            after_the_sum,
            "Your weights no longer sum to 1 where a reading is refused: set those to 0 before you divide by the sum.",
        ),
    },
    "zeros": {
        "all for both": ([[1, 2, 3], [1, 2, 3]], "Each track gets one reading: two numbers in all, first that of A, then that of B."),
    },
    "interval_of_R": {
        "one standard error": (ONE_SIGMA, "That is one standard error each way, 68 %. At 95 % use chi-square with 40 degrees of freedom."),
        "16 %": ((0.09 * 0.84, 0.09 * 1.16), "16 % belongs to the lesson's number of readings. With 41 readings R is known less well."),
        "as in the lesson": ((0.025, 0.0344), "Those are the lesson's limits. Here the sample variance is 0.09 m², of 41 readings."),
    },
    "milliseconds_for_seconds": {
        "the lift": (0.00109, "That q is the lesson's fit. Here q was 0.1: divide by 1000 as often as s stands in m²/s³."),
    },
    "clock": {
        "median step, all rows": (
            every_step,
            "Every step is the same in your answer, and rows without a reading count. Drop the rows with NaN, then take differences of time.",
        ),
    },
    "exponential_weights": {
        "from 1": (from_one, "The newest reading has K itself: the exponents begin at 0, not at 1."),
    },
    "behind_28": {"one clock's": (3.2, "That is the error of one clock in the lesson, with its noise. Here the readings have none.")},
}  # fmt: skip
