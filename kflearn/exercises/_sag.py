"""Wrong answers to two exercises of lesson 13: the widest belief, and a radar's readings put into the plane."""

import math

import numpy as np

WRONG = {
    "not rooted": (1600, "That is σ², in m². The σ of the belief is its root."),
    "one factor 2": (
        math.sqrt(800),
        "28.3² is 800. In σ²/(2 · 400 m) = 2 m there are two factors 2, the one of the sag and the 2 m of the reading, and 800 m² has only one of them.",
    ),
    "without the 2, not rooted": (
        800,
        "800 is 2 · 400. From σ²/(2 · 400 m) = 2 m follows σ² = 2 · 400 m · 2 m, and σ is the root of that.",
    ),
    "variance of the reading": (
        math.sqrt(3200),
        "56.6 is √(2 · 400 · 4): with the variance of a reading, 4 m², or a factor 2 too many. The sag is a length, so compare it with the σ of a reading, 2 m.",
    ),
    "variance, not rooted": (
        3200,
        "3200 is 2 · 400 · 4: with the variance of a reading, 4 m², or a factor 2 too many. And that is σ², not σ.",
    ),
    "root of the distance": (
        20,
        "20² is 400, the distance: one factor 2 divides where it should multiply, or both are left out. From σ²/(2 · 400 m) = 2 m follows σ² = 2 · 400 m · 2 m.",
    ),
    "the reading's σ": (2, "A belief 2 m wide sags by 2²/(2 · 400) m = 5 mm. Solve σ²/(2 · 400 m) = 2 m for σ."),
    "the cart's distance": (
        math.sqrt(2 * 20 * 2),
        "8.94 is √(2 · 20 · 2), and 20 m belong to the cart on the rail. Here the station is 400 m away.",
    ),
    "the sag itself": (
        2**2 / 800,
        "0.005 m is the sag of a belief 2 m wide, 2²/(2 · 400) m. Asked is the σ for which the *sag* is 2 m.",
    ),
    "the root of 2 m": (
        math.sqrt(800 * math.sqrt(2)),
        "33.6 is √(2 · 400 · √2), with the root of 2 m. The 2 m are a standard deviation already: the sag is to be as large as that.",
    ),
    "upside down": (
        math.sqrt(2 / 800),
        "0.05 is the root of 2/(2 · 400). In σ²/(2d) = 2 m, multiply both sides by 2d.",
    ),
    "a quarter": (10, "At 10 m the sag is only a sixteenth of what is wanted: it grows with the square of σ."),
    "half the distance": (
        200,
        "200 is half of the distance, and the sag of a belief 400 m wide. Solve σ²/(2 · 400 m) = 2 m for σ.",
    ),
    "2 above": (
        math.sqrt(400 * 2 / 4),
        "14.1 is the root of 400/2. Solve σ²/(2d) = 2 m for σ²: both factors 2 multiply, σ² = 2 · d · 2 m.",
    ),
}


def turned(r, angle, sd_r, sd_angle, near=1.0, sign=-1.0):
    """The covariance in the plane, with places for mistakes; `near` in place of the distance where it is given."""
    far = r * near
    J = np.array([[np.cos(angle), sign * far * np.sin(angle)], [np.sin(angle), far * np.cos(angle)]])
    return J @ np.diag([sd_r**2, sd_angle**2]) @ J.T


def slopes(r, angle):
    """The Jacobian."""
    return np.array([[np.cos(angle), -r * np.sin(angle)], [np.sin(angle), r * np.cos(angle)]])


POLAR = {
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
}
