"""More wrong answers to exercises of lessons 1 to 5 and 28, each with its sentence: those that a stranger tried."""

import numpy as np

from kflearn.exercises._voltmeter import after


def weights(K, n):
    """The right weights of exponential smoothing, newest first."""
    return np.append(K * (1 - K) ** np.arange(n - 1), (1 - K) ** (n - 1))


def held(T):
    """The right G of an acceleration that is held."""
    return np.array([[T**2 / 2], [T]])


def weighed(mx, vx, mz, vz):
    """The right mean of two opinions."""
    return (mx * vz + mz * vx) / (vx + vz)


FUSE = {
    "variance of a plain average": (
        lambda mx, vx, mz, vz: ((mx + mz) / 2, (vx + vz) / 4),
        "That is the plain average and its variance, (var_x + var_z)/4. It is honest, but not the best: weigh the two, so that the less certain one counts less.",
    ),
    "that variance, mean right": (
        lambda mx, vx, mz, vz: (weighed(mx, vx, mz, vz), (vx + vz) / 4),
        "The mean is right. Your variance is that of a plain average; the weighed one is more certain.",
    ),
    "the smaller variance": (
        lambda mx, vx, mz, vz: (weighed(mx, vx, mz, vz), min(vx, vz)),
        "The mean is right. You took the smaller of the variances; the fused one is smaller than both.",
    ),
}

WRONG = {
    "exponential_weights": {
        "K in the oldest": (
            lambda K, n: np.append(K * (1 - K) ** np.arange(n - 1), K * (1 - K) ** (n - 2.0)),
            "The oldest weight is not right: it is (1 − K)ⁿ⁻¹, without K in front. Check that the sum is 1.",
        ),
        "powers from 1": (
            lambda K, n: np.append(K * (1 - K) ** np.arange(1, n), (1 - K) ** (n - 1)),
            "The oldest weight is right. The others begin with K itself for the newest reading: the power of 1 − K starts at 0.",
        ),
        "K and 1 − K exchanged": (
            lambda K, n: (1 - K) * K ** np.arange(n),
            "K and 1 − K are exchanged: K is the weight of the newest reading. And the weights do not sum to 1, because the oldest lacks its part.",
        ),
        "all K": (
            lambda K, n: np.append(np.full(n - 1, K), (1 - K) ** (n - 1)),
            "The oldest weight is right. The others must become smaller: each reading that follows multiplies them by 1 − K.",
        ),
        "oldest 1": (
            lambda K, n: np.append(K * (1 - K) ** np.arange(n - 1), 1),
            "The oldest reading does start with the weight 1. But each reading after it multiplies that by 1 − K.",
        ),
    },
    "held_push": {
        "times T = 2 squared": (
            lambda T, sigma: 4 * sigma**2 * np.outer([T / 2, 1], [T / 2, 1]),
            "That is right at T = 2 s only: the factor by which Q is too small is T², not 4.",
        ),
        "doubled": (
            lambda T, sigma: 2 * sigma**2 * np.outer([T / 2, 1], [T / 2, 1]),
            "That is twice the published Q. Its G lacks a factor T, which stands twice in Q.",
        ),
        "G alone": (
            lambda T, sigma: sigma**2 * held(T),
            "That is σ² G, a column. Q is a matrix: σ² G Gᵀ.",
        ),
        "white, no corners": (
            lambda T, sigma: sigma**2 * T * np.diag([1 / 3, 1]),
            "Two things: the acceleration is held for T, so Q is σ² G Gᵀ; and one push disturbs position and velocity together, so Q has corners.",
        ),
        "T⁴ everywhere": (
            lambda T, sigma: sigma**2 * T**4 * np.array([[T**2 / 4, T / 2], [T / 2, 1]]),
            "That is the published Q times T⁴. G lacks one factor T, and G stands twice in Q: that makes T².",
        ),
        "T in the last entry": (
            lambda T, sigma: sigma**2 * np.array([[T**4 / 4, T**3 / 2], [T**3 / 2, T]]),
            "Three entries are right. The last is the variance of the velocity: the square of σ T.",
        ),
    },
    "correct": {
        "R for the new P": (
            lambda x, P, z, H, R: (x + P @ H.T @ np.linalg.inv(H @ P @ H.T + R) @ (z - H @ x), R),
            "Your x is right. You returned R, which belongs to the measurement; the new P is (I − K H) P.",
        ),
        "x alone": (
            lambda x, P, z, H, R: x + P @ H.T @ np.linalg.inv(H @ P @ H.T + R) @ (z - H @ x),
            "Your x is right. P is wanted as well: return both, x first.",
        ),
    },
    "fuse": FUSE,
    "auto_start": {
        "Hᵀ for H⁻ᵀ": (
            lambda z, H, R: (np.linalg.solve(H, z), np.linalg.solve(H, R) @ H.T),
            "Your x is right. In P only the left side is undone: on the right stands the transpose of the *inverse*, H⁻ᵀ.",
        ),
        "R R": (
            lambda z, H, R: (np.linalg.solve(H, z), np.linalg.inv(H) @ R @ R @ np.linalg.inv(H).T),
            "Your x is right. R stands once in P: it is a covariance already.",
        ),
        "x alone": (
            lambda z, H, R: np.linalg.solve(H, z),
            "Your x is right. Its covariance is wanted as well: return both, x first.",
        ),
        "vague": (
            lambda z, H, R: (np.linalg.solve(H, z), 1e6 * np.eye(len(z))),
            "Your x is right. Its P is not huge any more: the measurement has been used, and its error is known, R.",
        ),
    },
    "steady_gain": {
        f"{steps} steps": (
            lambda Q, R, steps=steps: after(Q, R, steps),
            f"That is the gain of reading {steps + 1}. Where Q is small beside R, it has not yet come to rest: let the recursion run for a hundred readings, or solve K² + qK − q = 0.",
        )
        for steps in range(1, 26)
    },
    "is_unknown": {
        "x == nan, each": (
            lambda x: x == np.nan,
            "NaN equals nothing, not even itself, so x == np.nan is False for every entry: use np.isnan, and any() afterwards.",
            r"== *(np|numpy|math)?\.?nan|nan *==",
        ),
        "nan in x": (
            lambda x: np.nan in x,
            "`in` compares with ==, and NaN equals nothing, not even itself: use np.isnan, and any() afterwards.",
            r"nan['\")]* in ",
        ),
        "always False": (
            lambda x: False,
            "Your function says False whatever the state is. Ask each entry with np.isnan first, and any() afterwards.",
        ),
        "exactly one": (
            lambda x: np.isnan(x).sum() == 1,
            "You say yes where exactly one entry is unknown. One or more make the state unknown.",
        ),
        "more than one": (
            lambda x: np.isnan(x).sum() > 1,
            "You say yes where two or more entries are unknown. One is enough.",
        ),
    },
}
