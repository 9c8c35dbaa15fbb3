"""Wrong answers to exercises of lessons 10 to 29 that a seventh group of strangers gave, and more of their kind."""

import numpy as np


def stepped(step):
    """The first of some steps at which the root of the squared metres reaches what is allowed."""

    def time(dv, b, allowed):
        exact = np.sqrt((-(dv**2) + np.sqrt(dv**4 + (b * allowed) ** 2)) / (b**2 / 2))
        return step * np.ceil(exact / step)

    return time


SQUARED = (
    "Your time is the one at which √((dv·t)² + (b·t²/2)²) reaches `allowed`. Squares add where errors are independent and may "
    "cancel. Here both pull the same way: dv·t + b·t²/2 = allowed."
)


def squares_inside(p, means, covs):
    """A mixture's covariance with the squares of the weights for the covariances alone."""
    y = means - p @ means
    return np.tensordot(p**2, covs, axes=1) + (p[:, None] * y).T @ y


def cut_afterwards(x, P, z, H, R):
    """The inverse of the whole S, of which the rows and columns that are there are taken."""
    seen = ~np.isnan(z)
    if not seen.any():
        return x, P
    K = P @ H[seen].T @ np.linalg.inv(H @ P @ H.T + R)[np.ix_(seen, seen)]
    return x + K @ (z[seen] - H[seen] @ x), P - K @ H[seen] @ P


def whole(P, C, B, F, fading, Q, q):
    """The prediction as one matrix."""
    return np.block([[F @ P @ F.T + Q, fading * F @ C], [fading * C.T @ F.T, fading**2 * B + q]])


def powers_from_one(K, n):
    return np.append(K * (1 - K) ** np.arange(1, n), (1 - K) ** n)


def of_the_others(x, P, room, reading, Q, R):
    """A step with the gain R/(P + R)."""
    P = P + Q
    K = R / (P + R)
    return x + K * (reading - x), np.sqrt((1 - K) * P)


def norths(z, T):
    """The first position holds both norths."""
    speed = (z[:, 1] - z[:, 0]) / T
    return z[:, :2, 1], np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)


COV = (
    "The mean is right. Your distance is what `np.cov` makes of the errors: it takes their mean away first, and divides by T − 1. Then a receiver that "
    "is always 50 m off would seem exact. Square the errors themselves."
)
WRONG = {
    "mended_step": {
        "the other share": (
            of_the_others,
            "These are the results of the gain R/(P + R), with which a reading counts for less the better it is. The gain is the share of the "
            "prediction's variance: K = P/(P + R).",
        ),
    },
    "report": {
        "covariance": (
            lambda e: (e.mean(axis=0), np.sqrt(np.trace(np.cov(e.T)))),
            COV,
        ),
    },
    "orders_of_the_root": {
        "at most seven": (
            lambda orders: min(orders / 2, 7),
            "Your result is never larger than 7, the digits of single precision. How many orders a root spans does not depend on the "
            "digits of a number: it is half of `orders` also for more than 14.",
        ),
    },
    "left_over": {
        "e and v for a and b": (
            lambda e, v, t0, t: v * t + e * (t / t0) ** 3,
            "Your error is v·t + e·(t/t₀)³. With t = t₀ that is e + v·t₀, and it should be e. In a·t + b·t³ neither number is e or v: find a and b "
            "from the error and from the velocity at t₀.",
        ),
    },
    "memory": {
        "the part that is lost": (
            lambda lasts, sd, dt: (1 - np.exp(-dt / lasts), sd**2 * (1 - (1 - np.exp(-dt / lasts)) ** 2)),
            "Your first number is the part that is forgotten in a step, 1 − e^(−dt/lasts), and your noise is the one that belongs to it. The part "
            "that survives is e^(−dt/lasts).",
        ),
    },
    "false_range": {
        "variances added": (
            lambda sigma, turn, across: np.sqrt(sigma**2 + (across / np.sin(np.radians(turn))) ** 2),
            "Your result is larger than sigma, and a reading makes no needle longer. It is what comes out if variances are added; in a correction the ones that add are the "
            "informations: 1/σ² + H²/R.",
        ),
    },
    "three_points": {
        "degrees, rounded": (
            lambda: 100 * (2 / 3 * np.sin(90) + (np.sin(90 + 51.96) + np.sin(90 - 51.96)) / 6),
            "That is what comes out if `np.sin` is given 90 and 51.96 as they are. It takes radians: `np.sin(np.radians(…))`.",
        ),
        "one sixth for all": (
            lambda: 100 * (1 + 2 * np.cos(np.radians(30) * 3**0.5)) / 6,
            "That is what three weights of 1/6 make, which add up to 1/2. The centre weighs 1 − n/scale = 2/3: all weights add up to 1.",
        ),
    },
    "mended_start": {
        "two norths": (
            norths,
            "The states are right. Your first position holds the north of the first sample and the north of the second. The indices are run, "
            "sample, component: `z[:, 0, 1]` is a north; east and north of the first sample are `z[:, 0]`.",
        ),
    },
    "dark_time": {
        "metres for seconds": (
            lambda dv, b, allowed: dv * allowed + b * allowed**2 / 2,
            "That is how far the position is wrong after `allowed` seconds, in metres. `allowed` is in metres, and a time is asked for: solve "
            "dv·t + b·t²/2 = allowed for t.",
        ),
        "squares, steps of 0.01 s": (stepped(0.01), SQUARED),
        "squares, steps of 0.001 s": (stepped(0.001), SQUARED),
    },
    "economical": {
        "the whole": (
            whole,
            "Your whole matrix is right. Cut it into its blocks and return these: with n = len(P) they are `big[:n, :n]`, `big[:n, n:]` and `big[n:, n:]`.",
        ),
    },
    "mixture_cov": {
        "squares inside": (
            squares_inside,
            "Each covariance counts with the square of its weight in your result. Squares belong to a weighted mean of independent estimates. Here "
            "one of the models holds, the i-th with probability pᵢ: its Pᵢ counts with pᵢ.",
        ),
    },
    "clock_offset": {
        "difference by slope": (
            lambda v, late, dt: np.mean(v - late) / np.mean(np.diff(v) / dt),
            "That is the mean difference of the two series divided by the mean slope of the first. An offset between the instruments is in that "
            "difference, and a drive that stops and goes has hardly a mean slope. Compare the shapes: shift one series step by step.",
        ),
    },
    "clock": {
        "since the first": (
            lambda time, z: time[~np.isnan(z)][1:] - time[~np.isnan(z)][0],
            "These are the times since the first reading. Wanted are the steps, each from one reading to the next.",
        ),
    },
    "exponential_weights": {
        "powers from one": (
            powers_from_one,
            "Each of your weights has one factor 1 − K too many, so their sum is 1 − K: the powers begin at 1. The newest reading has the power 0, "
            "which leaves K.",
        ),
    },
    "use_what_is_there": {
        "cut afterwards": (
            cut_afterwards,
            "That is what comes out if the whole S is inverted and its inverse is cut. This is right only where S has no corners: cut H and R "
            "first (or S), then invert.",
        ),
    },
}  # fmt: skip
