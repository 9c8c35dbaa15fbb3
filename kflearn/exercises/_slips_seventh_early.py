"""Wrong answers to exercises of lessons 1 to 8 that a seventh group of strangers gave, and more of their kind."""

import numpy as np

ONE_SIGMA = (
    "You use one σ for all components. Each has a variance of its own: take the root of `variances` entry by entry."
)
HARD = (
    "Half the range (or the largest error), squared, over 3 is the variance of errors that lie evenly between hard limits. Noise has "
    "no such limits, and its range grows with the number of readings. R is the variance of the readings."
)


def of_best_error(error):
    """What the error of lesson 5's drawn source would mean."""
    if abs(error - 1.63) < 0.015:
        return (
            f"{error:.3g} V is about what the filter with its random walk is off by here. The best answer does not use older "
            "readings: fuse N(12, 4) with the reading alone."
        )
    return (
        f"An error of {error:.3g} V is a variance of {error**2:.3g} V². Which variance is left when N(12, 4) is fused with "
        "a reading of variance 4?"
    )


def one_minus(i, j):
    """F x, with a minus before one entry of F."""
    sign = np.ones((2, 2))
    sign[i, j] = -1
    return lambda F, x: (sign * F) @ x


def one_sigma(choose):
    """A start with one standard deviation for all components, chosen from theirs."""
    return lambda mean, variances, normal: mean + choose(variances) * normal


def one_row_for_each_reading(x, P, z, H, R):
    K = H @ P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ P


WRONG = {
    "overwritten": {
        f"−F[{i}, {j}]": (
            one_minus(i, j),
            f"The {('first', 'second')[i]} entry is what comes out with −F[{i}, {j}]. In F x all products are added, with a plus.",
        )
        for i in range(2)
        for j in range(2)
    },
    "correct": {
        "H in front of P Hᵀ": (
            one_row_for_each_reading,
            "Your K is H P Hᵀ S⁻¹. K needs one row for each state: P Hᵀ S⁻¹, without the H in front.",
        ),
    },
    "common_cause": {
        f"c²/{name} on top": (
            lambda P, R, c, i=i: (P - c**2 / (P, R)[i]) / (P + R - 2 * c),
            f"Below the line it is right. On top c²/{name} is taken away from P; it is c that belongs there.",
        )
        for i, name in enumerate("PR")
    },
    "second_gain": {
        "Q twice": (
            5 / 17,
            "0.294 is 5/(5 + 3 + 9): P⁻ = 5 contains Q already. Below the line stands P⁻ + R.",
        ),
    },
    "three_sigma": {
        "hard limits": (lambda at_rest: (np.ptp(at_rest) / 2) ** 2 / 3, HARD),
        "hard limits about the mean": (lambda at_rest: np.max(abs(at_rest - np.mean(at_rest))) ** 2 / 3, HARD),
    },
    "draw_start": {
        "σ of the mean variance": (one_sigma(lambda variances: np.sqrt(np.mean(variances))), ONE_SIGMA),
        "mean σ": (one_sigma(lambda variances: np.mean(np.sqrt(variances))), ONE_SIGMA),
        "largest σ": (one_sigma(lambda variances: np.sqrt(np.max(variances))), ONE_SIGMA),
    },
    "right_update": {
        "only the diagonal": (
            lambda P, K: P - np.diag(np.diag(P) * K),
            "You shrink the diagonal only, and P₁₁ by 1 − K₁. Every entry of the row i loses K_i times the first row of P: the last "
            "one becomes P₁₁ − K₁·P₀₁.",
        ),
    },
}  # fmt: skip
