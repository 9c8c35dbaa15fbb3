"""Wrong answers to exercises of lesson 11 that a third group of strangers tried, each with the sentence that it gets."""

import numpy as np


def sigma_on_the_diagonal(z0, z1, dt, R):
    """A start from two fixes with the σ of the speed where its variance belongs."""
    return np.array([z1, (z1 - z0) / dt]), np.array([[R, R / dt], [R / dt, np.sqrt(2 * R) / dt]])


WRONG = {
    "running_average": {
        "span of four steps": (
            lambda z, dt: np.append(np.full(min(5, len(z)), np.nan), (z[5:] - z[:-5]) / (4 * dt)),
            "From z[k − 5] to z[k] five steps of dt pass, not four: six readings, five differences.",
        ),
    },
    "data_sheet": {
        "6/1.18²": (
            6 / 1.18**2,
            "4.31 is 6/1.18², with the 6 m not squared. First σ = 6 m/1.18, then the square of it.",
        ),
        "1.18 · 6, squared": (
            lambda: (6 * 1.18) ** 2,
            "50.1 is (1.18 · 6)². The radius is the larger number here, σ the smaller: divide, then square.",
        ),
        "rms distance, 1.41": (
            lambda: (6 / 1.41) ** 2,
            "18.1 is (6/1.41)², with 6 m for the rms distance, 1.41 σ. Half of the fixes lie within a smaller circle, 1.18 σ.",
        ),
        "95 %": (
            lambda: (6 / 2.45) ** 2,
            "6.0 is (6/2.45)², with 6 m for the radius that holds 95 % of the fixes, 2.45 σ. This one holds half of them, and is 1.18 σ.",
        ),
    },
    "two_point_start": {
        "σ for the variance": (
            sigma_on_the_diagonal,
            "All but the lower right is right. There √(2R)/dt is the standard deviation of the speed: P holds its square, the variance.",
        ),
        "for the moment of z0": (
            lambda z0, z1, dt, R: (np.array([z0, (z1 - z0) / dt]), np.array([[R, -R / dt], [-R / dt, 2 * R / dt**2]])),
            "That is the belief at the moment of z0, and it is right there. Asked is the one after the second fix: the position is z1, "
            "and an error of z1 makes the speed larger, so the corner is positive.",
        ),
    },
}
