"""Lesson 13: tangents, Jacobians, and the first filter made of them."""

import numpy as np

from kflearn import angle_difference
from kflearn.exercises._judge import track
from kflearn.exercises._radar import FAILING, MARKS, PASSING, recording
from kflearn.exercises._radar_signs import SIGNS
from kflearn.exercises._slips import linearised_and_extended as slips
from kflearn.exercises.engine import exercise, judged


@exercise(
    hints=[
        "The sag is σ²/(2d). Which σ makes it as large as the standard deviation of a reading?",
        "Write the equation with numbers: σ²/(2 · 400 m) = 2 m.",
        "σ² = 2 · 400 m · 2 m = 1600 m². The answer is the root of that.",
    ],
    wrong=slips.widest_belief.WRONG,
    also=[np.sqrt(402**2 - 400**2)],  # without the parabola
    unit="m",
    then="At a quarter of that, 10 m, the sag is only a sixteenth of the reading's σ: it falls with the square.",
)
def widest_belief():
    """Abreast of a station, 400 m away, σ of a reading 2 m: for which σ of the belief (m) is the sag 2 m?"""
    return np.sqrt(2 * 400 * 2)


def radar_states(rng):
    """A state [x, vx, y, vy] away from the axes, seen from a radar at the origin."""
    return (rng.integers(1, 9, 4) * [20.0, 3, 20, 3] * rng.choice([-1, 1], 4) + [1, 0, 0, 0],)


@exercise(
    hints=[
        "Compare `claimed(x)` with `jacobian(radar, x)` at a state without zeros or symmetries, say `np.array([300.0, 20, 400, -7])`.",
        "Print the difference of the two: seven entries agree. The eighth has the right size and the wrong sign.",
        "The entry in row 1, column 2 is the one: `J = claimed(x)`, then `J[1, 2] = -J[1, 2]`, then `return J`.",
    ],
    inputs=radar_states,
    wrong=slips.mended_slope.WRONG,
    rtol=1e-11,
    fixed={"x": "the state is place and velocity in the plane: always four numbers"},
    then="One wrong sign among eight entries makes no error message. The comparison takes three lines, so do it for every filter you write.",
)
def mended_slope(x):
    """The Jacobian (2, 4) of distance and rate of distance for the state [x, vx, y, vy] seen from the origin."""
    r = np.hypot(x[0], x[2])
    turn = x[2] * x[1] - x[0] * x[3]
    return np.array([[x[0] / r, 0, x[2] / r, 0], [x[2] * turn / r**3, x[0] / r, -x[0] * turn / r**3, x[2] / r]])


def radar_readings(rng):
    """A distance, a bearing and their standard deviations."""
    angle = float(rng.integers(1, 40) * 0.15 - 3.05)
    return float(rng.integers(2, 40) * 25), angle, float(rng.integers(1, 12)), float(rng.integers(1, 20) / 200)


@exercise(
    hints=[
        "The curve takes (r, θ) to (r cos θ, r sin θ). Its Jacobian has a row for east, a row for north, and a column for r and for θ.",
        "The errors of r and θ are independent, so their covariance is diag(sd_r², sd_angle²). A tangent J makes J R Jᵀ of it.",
        "`J = np.array([[np.cos(angle), -r * np.sin(angle)], [np.sin(angle), r * np.cos(angle)]])`, then "
        "`return J @ np.diag([sd_r**2, sd_angle**2]) @ J.T`.",
    ],
    inputs=radar_readings,
    wrong=slips.into_the_plane.WRONG,
    rtol=1e-6,
    then="Many trackers do this with each reading and then use a linear filter. The angle's curve sags too: the average of many "
    "readings of one target, put into the plane, is too near by about r·σθ²/2. That is 0.2 m at 1 km with 0.02 rad, and 20 m with 0.2 rad.",
)
def into_the_plane(r, angle, sd_r, sd_angle):
    """The covariance (2, 2) of [east, north], by the tangent, of a target seen at distance r (m) and bearing `angle`.

    The bearing (rad) counts from east towards north; sd_r (m) and sd_angle (rad) are the standard deviations.
    """
    J = np.array([[np.cos(angle), -r * np.sin(angle)], [np.sin(angle), r * np.cos(angle)]])
    return J @ np.diag([sd_r**2, sd_angle**2]) @ J.T


def on_the_rail(rng):
    """An estimate, its variance, a reading and a nominal place on the rail."""
    x, nominal = (float(value) / 2 for value in rng.integers(5, 60, 2))
    return x, float(rng.integers(2, 40) / 2), float(rng.integers(20, 40)), nominal + 0.25


@exercise(
    hints=[
        "Two lines change. Where does the tangent touch the curve, and which distance does the tangent give at x?",
        "The slope is the one at `nominal`. At x the tangent has the height of the curve at the nominal, plus the slope times the way from there to x.",
        "With `height = np.hypot(nominal, 20)`: `H = nominal / height` and `expected = height + H * (x - nominal)`; the rest as before.",
    ],
    inputs=on_the_rail,
    wrong=slips.linearised_correction.WRONG,
    then="H and P do not depend on the readings: all gains can be computed before the first reading comes. For the extended filter that is impossible.",
)
def linearised_correction(x, P, reading, nominal):
    """A correction of the cart on the rail (R = 4), with the tangent at `nominal`: the estimate and its variance."""
    H = nominal / np.hypot(nominal, 20)
    expected = np.hypot(nominal, 20) + H * (x - nominal)
    K = P * H / (H * P * H + 4)
    return x + K * (reading - expected), (1 - K * H) * P


@judged(
    hints=[
        "Two things are measured, so h(x) has two entries and H two rows. Work H out, and test it with the three lines of the lesson.",
        "A bearing of 3.1 and one of −3.1 are close together. What does their plain difference say?",
        "H = [[x/r, 0, y/r, 0], [−y/r², 0, x/r², 0]], R = diag(5², 0.02²), and the second innovation goes through "
        "`angle_difference(…, …, 2 * np.pi)`.",
    ],
    recording=recording,
    marks=MARKS,
    signs=SIGNS,
    form=track(4),
    passing=PASSING,
    failing=FAILING,
    then="With distance and bearing together one reading fixes the place in both directions, the belief stays narrow, and the tangents are nearly right. With the distance alone a belief 30 m wide is too wide already: see lesson 14.",
)
def range_and_bearing(z, mean, cov):
    """Write a filter `(z, mean, cov) → mean, covariance` for a radar at the origin that measures distance and bearing.

    z (100, 2): distance (m) and bearing (rad, from −π to π, counted from east towards north), one a second, with
    standard deviations 5 m and 0.02 rad. The state is [east, speed east, north, speed north] in m and m/s, F is
    the lesson's, `np.kron(np.eye(2), [[1, 1], [0, 1]])`, and Q is `np.diag([0.005, 0.01, 0.005, 0.01])`. The start, one second
    before the first reading, is N(mean, cov), (4,) and (4, 4). Return the means (100, 4) and covariances (100, 4, 4).
    """
    F, Q = np.kron(np.eye(2), [[1, 1], [0, 1]]), np.diag([0.005, 0.01, 0.005, 0.01])
    R, x, P, means, covs = np.diag([5.0**2, 0.02**2]), mean, cov, [], []
    for distance, bearing in z:
        x, P = F @ x, F @ P @ F.T + Q
        r = np.hypot(x[0], x[2])
        H = np.array([[x[0] / r, 0, x[2] / r, 0], [-x[2] / r**2, 0, x[0] / r**2, 0]])
        innovation = np.array([distance - r, angle_difference(bearing, np.arctan2(x[2], x[0]), 2 * np.pi)])
        K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
        x, P = x + K @ innovation, (np.eye(4) - K @ H) @ P
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)
