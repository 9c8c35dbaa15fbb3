"""Seventy models on which filters lose digits: huge starts, sensors that say the same, exact states, unstable modes."""

from dataclasses import dataclass

import numpy as np

from kflearn import Gaussian, LinearModel, constant_acceleration, constant_velocity, random_walk, scenarios

ROWS = []
SINGULAR = r"R must be larger beside P: at step \d+ S = H P⁻ Hᵀ \+ R is singular or negative"


@dataclass(frozen=True)
class Row:
    """A model with a start and a series z (T, m).

    refuses: what a filter that carries P may say in place of an answer.
    harmless: R is far below S, and yet no filter loses digits: Q or R itself is all that is left after a reading.
    thin: how far off rts_smoother may be, which divides by a root of P⁻, here 1e14 times longer than wide.
    """

    name: str
    model: LinearModel
    z: np.ndarray
    start: Gaussian
    refuses: str | None = None
    harmless: bool = False
    thin: float = 0.0


def row(name, model, start, steps=40, x=None, z=None, gaps=0.0, **more):
    """Add a Row. Without z: readings of a state that starts at x (0) and moves as F and Q say."""
    rng = np.random.default_rng(len(ROWS))
    start = start if isinstance(start, Gaussian) else Gaussian(np.zeros(model.n), start * np.eye(model.n))
    if z is None:
        x, z = np.zeros(model.n) if x is None else np.asarray(x, float), []
        for _ in range(steps):
            x = rng.multivariate_normal(model.F @ x, model.Q, method="eigh")
            z.append(rng.multivariate_normal(model.H @ x, model.R))
    z = np.reshape(z, (-1, model.m))
    z = np.where(rng.random(z.shape) < gaps, np.nan, z)
    ROWS.append(Row(name, model, z, start, **more))


def quarterly(level, slope, season, R):
    """Level, slope and the seasons of four quarters, with these variances: R's StructTS(type = "BSM")."""
    return seasonal(4, level, slope, season, R)


def seasonal(period, level, slope, season, R):
    """Level, slope and `period` − 1 seasons, of which the last is minus the sum of the others before."""
    n = period + 1
    F, H = np.zeros((n, n)), np.zeros((1, n))
    F[0, :2] = F[1, 1] = 1
    F[2, 2:] = -1
    F[3:, 2:-1] = np.eye(period - 2)
    H[0, [0, 2]] = 1
    return LinearModel(F, H, np.diag([level, slope, season, *np.zeros(n - 3)]), R)


def huge_starts():
    """P0/R from 1e8 to 1e16, with one state, two and three; then without process noise."""
    for ratio in (1e8, 1e12, 1e16):
        row(f"random walk, P0/R {ratio:.0e}", random_walk(0.1, 1), ratio, harmless=True)
    for ratio in (1e8, 1e10, 1e12, 1e14, 1e16):
        row(f"CV, P0/R {ratio:.0e}", constant_velocity(1, 0.1, 1), ratio, steps=60)
    for ratio in (1e8, 1e10, 1e12, 1e14, 1e16):
        refuses = SINGULAR if ratio == 1e16 else None
        row(f"CA, P0/R {ratio:.0e}", constant_acceleration(1, 0.01, 1), ratio, steps=60, refuses=refuses)
    for ratio in (1e8, 1e10, 1e12, 1e14):
        row(f"CA with Q = 0, P0/R {ratio:.0e}", constant_acceleration(1, 0, 1), ratio, steps=60)
    for P0 in (1e6, 1e8, 1e10, 1e12):
        row(f"train, P0 {P0:.0e}", scenarios.train().model.replace(R=1e-4), P0, steps=100, x=[0, 10])
    for P0 in (1e6, 1e8):
        row(f"gas, P0 {P0:.0e}", quarterly(1e-5, 1.7e-5, 7e-4, 1e-5), P0, x=[2.2, 0, 0.1, 0, -0.1])
    slow = LinearModel([[1, 1], [0, 1]], [[1, 0]], 0.01 * np.array([[1 / 3, 1 / 2], [1 / 2, 1]]), 1)
    for P0 in (1e7, 1e9, 1e12):
        row(f"own-data/08, P0 {P0:.0e}", slow, P0, z=[1.2, 1.9, 3.1, 3.8, 5.2, 6.1])


def sensors():
    """Two and three sensors of one quantity, and two of nearly the same."""
    cv = constant_velocity(1, 0.1, 1)
    for ratio in (1e8, 1e10, 1e12, 1e14):
        model = LinearModel(cv.F, [[1, 0], [1, 0]], cv.Q, np.diag([1e-4, 2e-4]))
        row(f"two sensors, P0/R {ratio:.0e}", model, 1e-4 * ratio)
    for ratio in (1e8, 1e12, 1e14):
        model = LinearModel(cv.F, [[1, 0]] * 3, cv.Q, np.diag([1e-4, 2e-4, 3e-4]))
        row(f"three sensors, P0/R {ratio:.0e}", model, 1e-4 * ratio)
    for sd in (1e2, 1e3, 1e4, 1e5):
        ranger = constant_velocity(0.1, 0.1, 1)
        model = LinearModel(ranger.F, [[1, 0], [1, 0]], ranger.Q, np.diag([1e-6, 4e-6]))
        row(f"api/01, rangers, start sd {sd:.0e}", model, Gaussian([0, 0], np.diag([sd**2, 100])), x=[5, 0.05])
    for shift, R in [(shift, R) for R in (1e-10, 1e-14) for shift in (1e-4, 1e-5, 1e-6, 1e-7)] + [(1e-8, 1e-17)]:
        model = LinearModel(np.eye(2), [[1, 0], [1, shift]], 0.01 * np.eye(2), R * np.eye(2))
        row(f"near-equal sensors, shift {shift:.0e}, R {R:.0e}", model, 1, refuses=SINGULAR if shift == 1e-8 else None)


def exact_states():
    """States that the start knows exactly, with a Q of rank 1 or 0."""
    cases = (0.001, 100, 20, 1e-3), (0.002, 100, 200, 1e-3), (0.01, 100, 20, 2e-5), (0.001, 1, 20, 2e-5), (1, 1, 50, 0)
    for dt, speed, steps, thin in cases:
        model, start = constant_acceleration(dt, 0.03, 100.0), Gaussian([0, 0, 0], np.diag([0.0, speed, 0]))
        row(f"api/04, dt {dt}, speed variance {speed}", model, start, steps, thin=thin)
    row("speed known exactly, Q = 0", constant_velocity(1, 0, 1), Gaussian([0, 1], np.diag([1e10, 0])))
    row("all known exactly but noise", constant_velocity(1, 0.1, 1), Gaussian([0, 1], np.zeros((2, 2))))


def long_series():
    """Thousands of steps with little process noise or none."""
    row("parabola, 4,000 steps", constant_acceleration(1, 0, 1), 1e2, steps=4000)
    row("line, 1,000 steps", constant_velocity(1, 0, 1), 1e6, steps=1000)
    row("nearly a line, 1,000 steps", constant_velocity(1, 1e-6, 1), 1e6, steps=1000)


def unstable():
    """Modes that grow by half at each step."""
    grows = np.diag([1.5, 0.9])
    row("1.5 a step, measured", LinearModel(1.5, 1, 1e-8, 1), 1e-8, steps=60)
    row("1.5 a step, measured with another", LinearModel(grows, [[1, 1]], 1e-6 * np.eye(2), 1), 1e-2, steps=60)
    row("1.5 a step, not measured", LinearModel(grows, [[0, 1]], 1e-6 * np.eye(2), 1), 1e-2, steps=60)
    bound = LinearModel([[1.5, 0], [1, 0.5]], [[0, 1]], 1e-6 * np.eye(2), 1)
    row("1.5 a step, seen through another", bound, 1e4, steps=60)


def odd_units():
    """States in units of 1e-9 and 1e9, measured with gaps or without."""
    for small, large in ((1e-9, 1e9), (1e9, 1e-9)):
        cv, unit = constant_velocity(1, 0.1, 1), np.diag([small, large])
        F, H = unit @ cv.F @ np.linalg.inv(unit), cv.H @ np.linalg.inv(unit)
        start = Gaussian([0, 0], 100 * unit @ unit)
        row(f"position in {small:.0e}, speed in {large:.0e}", LinearModel(F, H, unit @ cv.Q @ unit, 1), start)
    model = LinearModel(np.eye(2), np.diag([1e9, 1e-9]), np.diag([1e-18, 1e18]), np.eye(2))
    row("two quantities of 1e-9 and 1e9", model, Gaussian([0, 0], np.diag([1e-10, 1e26])))
    model = LinearModel(np.eye(2), np.eye(2), np.diag([1e-12, 1e12]), np.diag([1e-12, 1e12]))
    row("two readings of 1e-6 and 1e6", model, Gaussian([0, 0], np.diag([1e-4, 1e20])))


def gaps():
    """A huge start, and readings that fail."""
    cv = constant_velocity(1, 0.1, 1)
    both = LinearModel(cv.F, [[1, 0], [1, 0]], cv.Q, np.diag([1e-4, 2e-4]))
    row("CV with gaps, P0/R 1e+10", cv, 1e10, gaps=0.4)
    row("two sensors with gaps, P0/R 1e+10", both, 1e6, gaps=0.4)
    row("CA with gaps, P0/R 1e+08", constant_acceleration(1, 0.01, 1), 1e8, gaps=0.4)


def precise_sensors():
    """R far below Q."""
    turn = [[0.8, -0.6], [0.6, 0.8]]
    row("everything measured, R 1e-14", LinearModel(turn, np.eye(2), np.eye(2), 1e-14 * np.eye(2)), 1, harmless=True)
    row("position measured, R 1e-14", LinearModel([[1, 1], [0, 1]], [[1, 0]], np.eye(2), 1e-14), 1, harmless=True)
    row("AR(2), R 1e-14", LinearModel([[0.5, 0.3], [1, 0]], [[1, 0]], np.diag([1, 0]), 1e-14), 1, harmless=True)
    row("CV, R 1e-14", constant_velocity(1, 1, 1e-14), 1, harmless=True)


for kind in (huge_starts, sensors, exact_states, long_series, unstable, odd_units, gaps, precise_sensors):
    kind()
