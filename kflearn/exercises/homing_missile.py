"""Lesson 16: the homing missile."""

import numpy as np

from kflearn.exercises._slips import homing_missile as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise


def errors_on_the_way(rng):
    """An error (m) and its velocity (m/s), and two times to go (s)."""
    t0 = float(rng.integers(4, 9) / 2)
    return float(rng.integers(-600, 601)), float(rng.integers(-300, 301)), t0, t0 * float(rng.integers(1, 8) / 8)


@exercise(
    hints=[
        "The error is a·t + b·t³. Two numbers are wanted, a and b, and two are known, at t₀: the error itself and its velocity.",
        "At t₀: a·t₀ + b·t₀³ = e. The velocity is the change per second that passes, and t shrinks: v = −(a + 3b·t₀²).",
        "Multiply the second by t₀ and add it to the first: e + v·t₀ = −2b·t₀³.",
        "`b = -(e + v * t0) / (2 * t0**3)`, then `a = e / t0 - b * t0**2`, then `return a * t + b * t**3`.",
    ],
    inputs=errors_on_the_way,
    wrong=slips.left_over.WRONG,
    then="An error at rest (v = 0) of 100 m with 3 s to go is 48 m with 1 s to go, with no reading at all: that is the artefact.",
)
def left_over(e, v, t0, t):
    """The error (m) with t seconds to go, when with t0 seconds to go it is e (m) and its velocity v (m/s); blind."""
    b = -(e + v * t0) / (2 * t0**3)
    a = e / t0 - b * t0**2
    return a * t + b * t**3


def manoeuvres(rng):
    """How long a manoeuvre lasts (s), its standard deviation (m/s²), a time step (s)."""
    return float(rng.integers(1, 20) / 4), float(rng.integers(2, 40)), float(rng.integers(1, 11) / 100)


@exercise(
    hints=[
        "The lower right corner of F says which part survives: e to the power −λ·dt. What is λ for a manoeuvre that lasts so long?",
        "λ = 1/lasts. Then think of variances: after the step part²·sd² is left, and noise fills it up to sd² again.",
        "`part = np.exp(-dt / lasts)`, and `return part, sd**2 * (1 - part**2)`.",
    ],
    inputs=manoeuvres,
    wrong=slips.memory.WRONG,
    then="For short steps the noise is 2·sd²·dt/lasts: half the step, half the variance, so that the result does not depend on dt.",
)
def memory(lasts, sd, dt):
    """The part of an acceleration that survives a step of dt, and the noise variance that keeps its standard deviation."""
    part = np.exp(-dt / lasts)
    return part, sd**2 * (1 - part**2)


@exercise(
    hints=[
        "With the same σ on each axis the NEES is (500² + 300² + 40²)/σ².",
        "Set it equal to the number of axes, and solve for σ: it is a standard deviation in metres, not a variance.",
        "`np.sqrt((500**2 + 300**2 + 40**2) / 3)`.",
    ],
    wrong=slips.start_sigma.WRONG,
    otherwise=slips.start_sigma.nees_of,
    unit="m",
    rtol=3e-3,
    then="Its square is the mean of the three squared errors. And one start proves little: NEES of a single start may be anything from 0.2 to 9.",
)
def start_sigma():
    """The σ (m) on each axis that makes the NEES of a position error of (−500, −300, −40) m equal to 3."""
    return np.sqrt((500**2 + 300**2 + 40**2) / 3)


def needles(rng):
    """The length of a needle (m), a turn in degrees, the noise across (m)."""
    return float(rng.integers(50, 800)), float(rng.integers(5, 300) / 10), float(rng.integers(1, 50) / 10)


@exercise(
    hints=[
        "One state: the place s along the needle, with variance σ². Its reading is s·sin(turn), across the new line.",
        "P after a reading is 1/(1/σ² + H²/R), with H = sin(turn) and R = across². NumPy's sine wants radians.",
        "`H = np.sin(np.radians(turn))`, and `return 1 / np.sqrt(1 / sigma**2 + H**2 / across**2)`.",
    ],
    inputs=needles,
    wrong=slips.false_range.WRONG,
    then="With 400 m, 2.27° and 4.01 m it is 98 m: three quarters of σ are gone, after one reading that never measured the range.",
    rtol=5e-4,  # numbers of the learner's own, such as 0.0175 for π/180
)
def false_range(sigma, turn, across):
    """What is left of a needle's sigma (m) after a reading across a line turned by `turn` degrees, good to `across` m."""
    H = np.sin(np.radians(turn))
    return sigma * across / np.sqrt((sigma * H) ** 2 + across**2)


def some_errors(rng, runs, steps):
    """Errors of a few runs, steps and nine states."""
    return (rng.integers(-9, 10, (runs, steps, 9)).astype(float) * [5, 5, 5, 2, 2, 2, 1, 1, 1],)


@exercise(
    hints=[
        "Root of the mean of the squares, read from the back: square, mean, root. The mean goes over the runs, axis 0.",
        "The squared length of the position error is the sum of its three squares. Velocity has indices 3 to 5, acceleration 6 to 8.",
        "`return [np.sqrt(np.mean(np.sum(error[..., k : k + 3] ** 2, axis=-1), axis=0)) for k in (0, 3, 6)]`.",
    ],
    inputs=in_turn(some_errors, (2, 3), (4, 5), (3, 2), (1, 4)),
    wrong=slips.figures.WRONG,
    then="Of the three axes together; for one axis, if they are alike, divide by √3. The root comes last: means of distances are smaller.",
)
def figures(error):
    """The root mean square errors of position, velocity and acceleration, (3, T), of errors (runs, T, 9)."""
    return np.array([np.sqrt(np.mean(np.sum(error[..., k : k + 3] ** 2, axis=-1), axis=0)) for k in (0, 3, 6)])
