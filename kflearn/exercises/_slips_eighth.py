"""Wrong answers that an eighth group of strangers gave, each with the sentence that it gets."""

import numpy as np

from kflearn import angle_difference


def exchanged(x):
    """The Jacobian of a radar with x and y exchanged in the two long entries."""
    r, turn = np.hypot(x[0], x[2]), x[2] * x[1] - x[0] * x[3]
    changes = [x[0] * turn / r**3, x[0] / r, -x[2] * turn / r**3, x[2] / r]
    return np.array([[x[0] / r, 0, x[2] / r, 0], changes])


def gain_cut(x, P, z, H, R):
    """The gain of a whole reading, of which the columns of the missing numbers are left out."""
    seen = ~np.isnan(z)
    K = (P @ H.T @ np.linalg.inv(H @ P @ H.T + R))[:, seen]
    return x + K @ (z[seen] - H[seen] @ x), P - K @ H[seen] @ P


WRONG = {
    "fuse": {
        "variance of the reading": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vz),
            "The mean is right. The variance that you return is that of the second number alone, var_z. Both together know more: K times var_z.",
        ),
    },
    "published_claim": {
        "mended is honest": (
            lambda vx, vz: (vx / vz, 1, 1),
            "The first number is right. 1 would mean honest; a filter of which one half is mended is not. Divide again: the real mean squared error "
            "of the mean that it returns by the variance that it claims.",
        ),
    },
    "auto_start": {
        "diagonal alone": (
            lambda z, H, R: (z / np.diag(H), R / np.diag(H) ** 2),
            "You divide by the diagonal of H. A reading may hold several states: use the whole H, with its inverse H⁻¹ for the mean, and on both "
            "sides of R.",
        ),
    },
    "three_sigma": {
        "half the range": (
            lambda z: ((np.max(z) - np.min(z)) / 2) ** 2,
            "You square half the range, which grows with the number of readings. R is the variance of the readings.",
        ),
    },
    "R_with_drift": {
        "mean of three": (
            lambda z: np.var(z[1:-1] - np.convolve(z, np.ones(3) / 3, mode="valid")),
            "You take the mean of three readings off, and the reading itself is one of the three: only 2/3 of its noise's variance is left. Divide by 2/3, or "
            "work with differences of neighbours.",
        ),
    },
    "agreeing": {
        "without the edge": (
            lambda old, z, w: np.sum(abs(angle_difference(old, z)) < w),
            "You leave out those that are exactly `width` away: within ± 3° includes 3°.",
        ),
    },
    "mended_slope": {
        "exchanged": (
            exchanged,
            "Two entries of the second row are wrong: x and y are exchanged in [1, 0] and [1, 2]. Compare with `jacobian(radar, x)`.",
        ),
    },
    "start_covariance": {
        "2 not squared": (
            [[6, 2], [2, 2]],
            "Only the upper left is wrong: F stands on both sides, so the variance 1 of the speed comes in with 2² = 4, not with 2.",
        ),
    },
    "with_the_constant": {
        "once": (
            -31.40 - np.log(2 * np.pi) / 2,
            "You took ½ log 2π off once. It stands in the density of each number that was used: how many are there?",
        ),
    },
    "use_what_is_there": {
        "gain cut": (
            gain_cut,
            "That is the gain of a whole reading, with the columns of the missing numbers left out. The weights of the others were made for a "
            "reading that is whole: cut H and R first, then calculate S and K.",
        ),
    },
}  # fmt: skip
