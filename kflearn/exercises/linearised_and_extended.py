"""Lesson 13: linearised and extended."""

import numpy as np

from kflearn import angle_difference
from kflearn.exercises import _cart_on_a_rail
from kflearn.exercises._judge import inside, nees, track
from kflearn.exercises._linearised_and_extended import WRONG
from kflearn.exercises._radar import FAILING, PASSING, place_error, recording
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import Mark, exercise, judged


def radar_states(rng):
    """A state [x, vx, y, vy] away from the axes, seen from a radar at the origin."""
    return (rng.integers(1, 9, 4) * [20.0, 3, 20, 3] * rng.choice([-1, 1], 4) + [1, 0, 0, 0],)


@exercise(
    hints=[
        "Compare `claimed(x)` with `jacobian(radar, x)` at a state without zeros or symmetries, say [300, 20, 400, -7].",
        "Print the difference of the two: seven entries agree. The eighth has the right size and the wrong sign.",
        "The entry in row 1, column 2 is the one: `J = claimed(x)`, then `J[1, 2] = -J[1, 2]`, then `return J`.",
    ],
    inputs=radar_states,
    wrong=WRONG["mended_slope"],
    rtol=1e-5,
    fixed={"x": "the state is place and velocity in the plane: always four numbers"},
    then="One wrong sign among eight entries makes no error message: this comparison takes three lines, so do it for every filter you write.",
)
def mended_slope(x):
    """The Jacobian (2, 4) of distance and rate of distance for the state [x, vx, y, vy] seen from the origin."""
    r = np.hypot(x[0], x[2])
    turn = x[2] * x[1] - x[0] * x[3]
    return np.array([[x[0] / r, 0, x[2] / r, 0], [x[2] * turn / r**3, x[0] / r, -x[0] * turn / r**3, x[2] / r]])


def growth_beliefs(rng):
    """An estimate, its variance and an input of the growth model."""
    return float(rng.integers(-40, 41) / 4 + 0.1), float(rng.integers(1, 20) / 4), float(rng.integers(-32, 33) / 4)


@exercise(
    hints=[
        "The belief's width is stretched by the curve. At which place does the curve meet this belief: where it stood, or where it lands?",
        "A belief stands at x before it moves. So the tangent is needed at the old x, but the first line has overwritten it.",
        "Swap two lines: first `F = move_slope(x)`, then `x = move(x, u)`, then P = F * P * F + 10.",
    ],
    inputs=growth_beliefs,
    wrong=WRONG["mended_prediction"],
    then="At x = 2 the slope is −2.5, at 0 it is 25.5: the belief is stretched ten times as much. That is why the place matters.",
)
def mended_prediction(x, P, u):
    """The EKF's prediction of the growth model (coefficient 25, Q = 10): the mean and its variance."""
    F = 0.5 + 25 * (1 - x**2) / (1 + x**2) ** 2
    x = x / 2 + 25 * x / (1 + x**2) + u
    return x, F * P * F + 10


def believed_starts(rng, runs):
    """A mean, a diagonal P₀ and standard normal numbers for a few runs."""
    mean = rng.integers(-200, 200, 4).astype(float)
    return mean, np.diag(rng.integers(2, 60, 4) / 2 + 0.5), rng.normal(size=(runs, 4)).round(2)


@exercise(
    hints=[
        "A filter that starts with N(mean, P0) says that the truth lies about `mean`, with the variances of P0. Let it be so.",
        "Standard normal numbers have variance 1. Stretch column i by the *root* of P0[i, i], then move it to mean[i].",
        "`return mean + normal * np.sqrt(np.diag(P0))` (one row a run; P0 is diagonal).",
    ],
    inputs=in_turn(believed_starts, 2, 3, 6, 1),
    wrong=WRONG["true_starts"],
    fixed={"mean": "a place and a velocity in the plane: four numbers", "P0": "it belongs to a state of four numbers"},
    then="With starts like these the mean NEES before the first reading is 4, the number of states; with the published ones it is 0.",
)
def true_starts(mean, P0, normal):
    """True starts (runs, 4) drawn from the belief N(mean, P0), P0 diagonal, by standard normal numbers (runs, 4)."""
    return mean + normal * np.sqrt(np.diag(P0))


def on_the_rail(rng):
    """An estimate, its variance, a reading and a nominal place on the rail."""
    x, nominal = (float(value) / 2 for value in rng.integers(5, 60, 2))
    return x, float(rng.integers(2, 40) / 2), float(rng.integers(20, 40)), nominal + 0.25


@exercise(
    hints=[
        "Two lines change. Where is the tangent drawn, and what does it expect at x?",
        "The slope is that at `nominal`. At x the line stands at: its height at the nominal, plus slope times the way from there to x.",
        "With `height = np.hypot(nominal, 20)`: `H = nominal / height` and `expected = height + H * (x - nominal)`; the rest as before.",
    ],
    inputs=on_the_rail,
    wrong=_cart_on_a_rail.WRONG["linearised_correction"],
    then="H and P do not depend on the readings: all gains can be computed before the first one comes. For the EKF that is impossible.",
)
def linearised_correction(x, P, reading, nominal):
    """A correction of the cart on the rail (R = 4), with the tangent at `nominal`: the estimate and its variance."""
    H = nominal / np.hypot(nominal, 20)
    expected = np.hypot(nominal, 20) + H * (x - nominal)
    K = P * H / (H * P * H + 4)
    return x + K * (reading - expected), (1 - K * H) * P


@exercise(
    hints=[
        "Two things decide: does the path run away from the nominal, and is the sag of the tangent large beside a reading's σ of 2.24 m?",
        "The speeds are as in the start that was 30 m off. The sag grows with the square of σ: 100²/(2·316), which is 16 m.",
        "Seven times a reading's σ: each tangent is badly wrong. Which of the two filters draws new tangents at each step, and takes each for new information?",
    ],
    wrong={
        "EKF": (
            "EKF",
            "So says the slide. But each of its first corrections is sharp and bent, and it takes the turning of its own tangents for new information.",
        ),
        "neither": (
            "no difference",
            "There was a difference at 30 m already, and the sag is eleven times as large now.",
        ),
    },
    then="Over a thousand runs the LKF is off by 43 m on average, the EKF by 80 m. The EKF draws each tangent at another wrong place, "
    "and takes the turning of its tangents for new directions that were measured.",
)
def winner():
    """Which filter errs less with a start wrong by 100 m and 1 m/s: "LKF", "EKF" or "no difference"?"""
    return "LKF"


@judged(
    hints=[
        "Two things are measured, so h(x) has two entries and H two rows. Work H out, and test it with the three lines of the lesson.",
        "A bearing of 3.1 and one of −3.1 are close together. What does their plain difference say?",
        "H = [[x/r, 0, y/r, 0], [−y/r², 0, x/r², 0]], R = diag(5², 0.02²), and the second innovation goes through "
        "`angle_difference(…, …, 2 * np.pi)`.",
    ],
    recording=recording,
    marks=[
        Mark(
            "place error (rms)",
            place_error(),
            high=4.6,
            above="That is more than needed. Test the two rows of H; the bearing is arctan2(north, east); R holds variances, 5² and 0.02²; and take the difference of two bearings the short way round.",
            unit="m",
        ),
        Mark(
            "true east inside ±2σ",
            inside(0),
            91,
            98.5,
            below="The claim is too small: is Q added in each step, is R = diag(5², 0.02²)?",
            above="The claim is too large: are Q and R as given?",
            unit="%",
        ),
        Mark(
            "true north inside ±2σ",
            inside(2),
            91,
            98.5,
            below="The claim is too small: is Q added in each step, is R = diag(5², 0.02²)?",
            above="The claim is too large: are Q and R as given?",
            unit="%",
        ),
        Mark(
            "NEES / n",
            nees(),
            0.8,
            1.25,
            below="Too modest: the squared errors are smaller than claimed. Are both measurements used, with R = diag(5², 0.02²)?",
            above="Too sure: the squared errors are larger than claimed. Is H right, is R = diag(5², 0.02²), is Q added, are bearings subtracted the short way?",
        ),
    ],
    form=track(4),
    passing=PASSING,
    failing=FAILING,
    then="With distance and bearing together the tangents are nearly right, and the filter honest. With the distance alone it was not.",
)
def range_and_bearing(z, mean, cov):
    """Write a filter `(z, mean, cov) → mean, covariance` for a radar at the origin that measures distance and bearing.

    z (100, 2): distance (m) and bearing (rad, from −π to π, counted from east towards north), one a second, with
    standard deviations 5 m and 0.02 rad. The state is [east, speed east, north, speed north] in m and m/s, F and Q are
    the lesson's: `np.kron(np.eye(2), [[1, 1], [0, 1]])` and `np.diag([0.005, 0.01, 0.005, 0.01])`. The start, one second
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
