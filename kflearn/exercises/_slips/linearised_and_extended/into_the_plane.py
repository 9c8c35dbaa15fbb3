"""Lesson 13, `into_the_plane`: wrong answers, each with the sentence that it gets."""

import numpy as np


def slopes(r, angle):
    """The Jacobian."""
    return np.array([[np.cos(angle), -r * np.sin(angle)], [np.sin(angle), r * np.cos(angle)]])


def turned(r, angle, sd_r, sd_angle, near=1.0, sign=-1.0):
    """The covariance in the plane, with places for mistakes; `near` in place of the distance where it is given."""
    far = r * near
    J = np.array([[np.cos(angle), sign * far * np.sin(angle)], [np.sin(angle), far * np.cos(angle)]])
    return J @ np.diag([sd_r**2, sd_angle**2]) @ J.T


def in_degrees(r, angle, sd_r, sd_angle):
    """The angles taken for degrees."""
    a = np.radians(angle)
    J = np.array([[np.cos(a), -r * np.sin(a)], [np.sin(a), r * np.cos(a)]])
    return J @ np.diag([sd_r**2, np.radians(sd_angle) ** 2]) @ J.T


def out_of_the_plane(r, angle, sd_r, sd_angle):
    c, s = np.cos(angle), np.sin(angle)
    J = np.array([[c, s], [-s / r, c / r]])
    return J @ np.diag([sd_r**2, sd_angle**2]) @ J.T


WRONG = {
    "standard deviations": (
        lambda r, angle, sd_r, sd_angle: slopes(r, angle) @ np.diag([sd_r, sd_angle]) @ slopes(r, angle).T,
        "A covariance holds variances: square `sd_r` and `sd_angle`.",
    ),
    "without the distance": (
        lambda r, angle, sd_r, sd_angle: turned(r, angle, sd_r, sd_angle, near=1 / r),
        "An error of the bearing moves the target across the line of sight by r times that error: the second column of the Jacobian needs r.",
    ),
    "sign": (
        lambda r, angle, sd_r, sd_angle: turned(r, angle, sd_r, sd_angle, sign=1.0),
        "One sign: the slope of r cos θ along θ is −r sin θ.",
    ),
    "J turned on its side": (
        lambda r, angle, sd_r, sd_angle: slopes(r, angle).T @ np.diag([sd_r**2, sd_angle**2]) @ slopes(r, angle),
        "Your result is Jᵀ R J for the Jacobian J: either the factors are exchanged, or your J is transposed. Its rows belong to east and north, its columns to r and θ, and the covariance is J R Jᵀ.",
    ),
    "J once": (
        lambda r, angle, sd_r, sd_angle: slopes(r, angle) @ np.diag([sd_r**2, sd_angle**2]),
        "The Jacobian stands on both sides: J R Jᵀ. Your matrix is not even symmetric.",
    ),
    "J twice": (
        lambda r, angle, sd_r, sd_angle: slopes(r, angle) @ np.diag([sd_r**2, sd_angle**2]) @ slopes(r, angle),
        "The second J must be transposed: J R Jᵀ.",
    ),
    "R as it was": (
        lambda r, angle, sd_r, sd_angle: np.diag([sd_r**2, sd_angle**2]),
        "That is the covariance of distance and bearing. Turn it into the plane: J R Jᵀ.",
    ),
    "diagonal only": (
        lambda r, angle, sd_r, sd_angle: np.diag(np.diag(turned(r, angle, sd_r, sd_angle))),
        "The two variances are right. But the errors of east and north are correlated: keep the entries off the diagonal.",
    ),
    "north first": (
        lambda r, angle, sd_r, sd_angle: turned(r, angle, sd_r, sd_angle)[::-1, ::-1],
        "East and north have changed places. East is r cos θ and comes first.",
    ),
    "the Jacobian": (
        lambda r, angle, sd_r, sd_angle: slopes(r, angle),
        "That is the Jacobian J. The covariance is J R Jᵀ.",
    ),
    "bearing's error only": (
        lambda r, angle, sd_r, sd_angle: turned(r, angle, 0, sd_angle),
        "The error of the distance is missing: `sd_r` does not come in.",
    ),
    "distance's error only": (
        lambda r, angle, sd_r, sd_angle: turned(r, angle, sd_r, 0),
        "The error of the bearing is missing: `sd_angle` does not come in.",
    ),
    "across for along": (
        lambda r, angle, sd_r, sd_angle: turned(r, angle, r * sd_angle, sd_r / r),
        "Along and across have changed places: σ of the distance acts along the line of sight, r times σ of the bearing across it.",
    ),
    "not turned": (
        lambda r, angle, sd_r, sd_angle: np.diag([sd_r**2, (r * sd_angle) ** 2]),
        "That is the covariance along and across the line of sight. East and north are turned against these by the bearing: J R Jᵀ.",
    ),
    "bearing for degrees": (
        lambda r, angle, sd_r, sd_angle: turned(r, np.radians(angle), sd_r, sd_angle),
        "You converted the bearing from degrees. It is in radians already, which is what NumPy's sine and cosine want.",
    ),
    "sd of the bearing for degrees": (
        lambda r, angle, sd_r, sd_angle: turned(r, angle, sd_r, np.radians(sd_angle)),
        "You converted `sd_angle` from degrees. It is in radians already.",
    ),
    "distance not squared": (
        lambda r, angle, sd_r, sd_angle: turned(r, angle, sd_r, sd_angle, near=r**-0.5),
        "Across the line of sight the standard deviation is r · sd_angle. In the variance both are squared, the distance as well.",
    ),
    "turned the other way": (
        lambda r, angle, sd_r, sd_angle: turned(r, -angle, sd_r, sd_angle),
        "The variances are right, and the correlation has the wrong sign, as if the bearing turned the other way. Work out the four slopes once more.",
    ),
    "inverse": (
        lambda r, angle, sd_r, sd_angle: np.linalg.inv(turned(r, angle, sd_r, sd_angle)),
        "That is the inverse of the covariance.",
    ),
    "R twice": (
        lambda r, angle, sd_r, sd_angle: turned(r, angle, sd_r**2, sd_angle**2),
        "You squared the standard deviations twice: a variance is `sd_r**2`.",
    ),
    "roots": (
        lambda r, angle, sd_r, sd_angle: np.sqrt(np.diag(turned(r, angle, sd_r, sd_angle))),
        "Those are the two standard deviations. The whole covariance matrix is wanted, 2 × 2.",
    ),
    "degrees": (in_degrees, "The angles are in radians already: do not convert them."),
    "the other way": (
        out_of_the_plane,
        "Your Jacobian goes from the plane to (r, θ). The other direction is needed: the slopes of r cos θ and r sin θ.",
    ),
}
