"""Wrong answers to exercises of lessons 18 to 26 that a third group of strangers gave, and more of their kind."""

import numpy as np

from kflearn.exercises._adaptive import mixed

BORN_AGAIN = "That is born again, only with a wide P. The ball is not forgotten: go on from x and P."
SIGN = "Under the root it is plus. The equation is b/2·t² + dv·t − allowed = 0, so −4ac is +2·b·allowed."
LESSONS_P = "That is the lesson's P after its last reading. Here it is the first, from P⁻ = diag(4, 1)."
ALL_ALIKE = "You give all steps the same length. Each step has its own, above all the hole."
THROWN = (
    "You throw long steps away. The hole is the step that matters: keep every one, there is one less than readings."
)
DIFFERENCES = (
    "A fair estimate if the errors are independent. Asked for are the squares about the mean, divided by n − 1."
)


def runs_for_time(z, T):
    """Run 2 minus run 1 for a speed."""
    speed = np.tile((z[1, 0] - z[0, 0]) / T, (len(z), 1))
    return z[:, 0], np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)


def by_component(p, means, covs):
    """From each filter's mean a component of the joint mean is subtracted, in turns."""
    parts = np.resize(p @ means, len(p))
    return sum(w * (P + np.outer(m - c, m - c)) for w, m, P, c in zip(p, means, covs, parts, strict=True))


def from_the_prediction(x, P, F, Q, x_next, P_next):
    ahead = F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(ahead)
    return F @ x + G @ (x_next - F @ x), ahead + G @ (P_next - ahead) @ G.T


def R_taken_off(x, P, x_back, P_back, z, R):
    V = 1 / (1 / P + 1 / P_back) - R
    return V * (x / P + x_back / P_back - z / R), V


def steps(time, z, middle):
    """The same step for all."""
    d = np.diff(time[~np.isnan(z)])
    return np.full(len(d), middle(d))


def cut_off(limit, middle=lambda d: 1.0):
    """The steps without the long ones."""

    def short(time, z):
        d = np.diff(time[~np.isnan(z)])
        return d[d < limit * middle(d)]

    return short


def weights(z, K):
    return (1 - K) ** np.arange(len(z))[::-1]


WRONG = {
    "mended_start": {
        "runs for time": (
            runs_for_time,
            "Your speed is run 2 minus run 1. Take sample 2 minus sample 1 within each run: z[:, 1] − z[:, 0].",
        ),
    },
    "coast": {
        f"born again, {wide:g}": (
            lambda x, P, F, push, Q, wide=wide: (np.zeros(len(x)), wide * np.eye(len(x))),
            BORN_AGAIN,
        )
        for wide in (10.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e8)
    },
    "all_bias": {
        "the lesson's": (
            21.3,
            "21.3 m is in the lesson's table, for other numbers and with noise. Here the scale error is 6 %, for 30 s.",
        ),
    },
    "dark_time": {
        "minus under the root": (
            lambda dv, b, allowed: (-dv + np.sqrt(abs(dv**2 - 2 * b * allowed))) / b,
            SIGN,
        ),
    },
    "mended_fix": {
        "dx kept": (
            lambda x, dx, K, fix: (x + K @ (fix - x[:2] - dx[:2]), dx),
            "You gave x what this fix brings, and left the old dx beside it. Add all of dx, then set dx to zero.",
        ),
    },
    "inflated": {
        "the lesson's R": (
            0.25 + 0.5**2,
            "0.5 is the σ of the bias, and also 0.25 + 0.25, with the lesson's noise. R is the sum of the variances: "
            "here the noise has σ = 0.3 m.",
        ),
    },
    "first_covariance": {
        "root on the diagonal": (
            [[0.976, -0.762], [-0.762, 1]],
            "0.976 is the root of what is wanted. On the diagonal stand variances, in m².",
        ),
        "the gain of the bias": (
            [[0.952, -0.190], [-0.190, 1]],
            "0.190 is the bias's gain, whose row is set to zero. By (9J) P₁₂ is −K₁ times the bias's variance, 1.",
        ),
        "the lesson's last": ([[0.916, -0.866], [-0.866, 1.0]], LESSONS_P),
    },
    "honest_average": {
        "bias N times": (
            lambda N, R, B: np.sqrt(R / N + N * B),
            "All N readings hold the same bias, so their mean holds it once: B, not N·B.",
        ),
    },
    "window_needed": {
        "not squared, rounded up": (19, "19 is √N. In S √(2/N) the N stands under the root: square 13·√2."),
        "root of N": (13 * 2**0.5, "That is √N. In S √(2/N) the N stands under the root: square it."),
    },
    "mixture_cov": {
        "a component each": (
            by_component,
            "All filters are counted now. But from each mean you subtract one number: subtract the whole vector p @ means.",
        ),
        "spread on the diagonal": (
            lambda p, means, covs: np.tensordot(p, covs, 1)
            + np.diag(np.diag(mixed(p, means, 0 * covs))),
            "The variances are right. The spread has entries off the diagonal too: np.outer(y, y).",
        ),
    },
    "one_step_back": {
        "mean left alone": (
            (4, 1.875),
            "The variance is right. The mean moves too: add G times what the prediction missed, 6 − 4.",
        ),
        "plus P⁻": (
            (5.5, 3 + 0.75**2 * 6),
            "The mean is right. In the variance the predicted 4 is subtracted: G² (2 − 4).",
        ),
    },
    "step_back": {
        "from the prediction": (
            from_the_prediction,
            "The gain is right. Start from the filter's belief at step k, x and P, not from its prediction.",
        ),
    },
    "count_once": {
        "R off the variance": (
            R_taken_off,
            "A reading is taken out of the information, not of the variance: subtract 1/R before you invert.",
        ),
    },
    "half_missing": {
        "infinity": (
            np.inf,
            "A huge R costs too: log 2πR grows without end. Set the derivative −½·4/R² + 1/R to zero.",
        ),
    },
    "milliseconds_for_seconds": {
        "a million": (
            0.1 / 1e18,
            "That is 0.1 divided by 10¹⁸, a million three times or 1000 six times. A second has a thousand milliseconds, and the "
            "time stands three times in m²/s³: q is no σ, so nothing is squared. Divide by 1000³.",
        ),
        "the thermometer": (
            3.54e-08,
            "That is the q of the lesson's thermometer. Start from 0.1 m²/s³; the time stands three times in the unit.",
        ),
    },
    "interval_of_R": {
        "the lesson's ride": (
            (7.2, 13.1),
            "That is the interval of the lesson's ride. Here the sample variance is 0.09 m², with 40 degrees of freedom.",
        ),
    },
    "clock": {
        "the median step": (lambda time, z: steps(time, z, np.median), ALL_ALIKE),
        "the mean step": (lambda time, z: steps(time, z, np.mean), ALL_ALIKE),
        **{f"cut off at {limit} s": (cut_off(limit), THROWN) for limit in (1, 1.5, 2, 3, 5, 10, 20, 30, 60, 100, 120, 300, 1000)},
        **{f"cut off at {limit} medians": (cut_off(limit, np.median), THROWN) for limit in (2, 3, 4, 5, 10, 20)},
    },
    "variance_at_rest": {
        "half the squared differences": (
            lambda time, z, until: np.nanmean(np.diff(z[time < until]) ** 2) / 2,
            DIFFERENCES,
        ),
        "half the variance of the differences": (
            lambda time, z, until: np.nanvar(np.diff(z[time < until])) / 2,
            DIFFERENCES,
        ),
    },
    "behind": {
        "ten nights ago": (
            0.083,
            "0.083 is the weight of a reading of ten nights ago. Asked for are seconds.",
        ),
    },
    "mended": {
        "by their number": (
            lambda z, K: np.sum(weights(z, K) * z) / len(z),
            "Divide by the sum of the weights, not by how many there are.",
        ),
        "five seconds added": (
            lambda z, K: np.sum(K * weights(z, K) * z) + 5,
            "What is missing depends on K, on the length and on z. Divide by the sum of the weights.",
        ),
    },
}  # fmt: skip
