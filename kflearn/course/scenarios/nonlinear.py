"""The nonlinear systems: what is measured, or how the state moves, bends."""

from dataclasses import dataclass
from functools import partial

import numpy as np

from ...core.angles import angle_difference
from ...models import checks as check
from ...models.gaussian import Gaussian
from ...models.state_space import NonlinearModel
from .. import bearings, homing, navigation
from .base import Recorded, Scenario, choose


def bearing(variant="typical", q=200.0, r=500.0, steps=325) -> Recorded:
    """[KP] The bearing of a sound source, from a microphone array that reports whole degrees, 0 to 359.

    The filter assumes a random walk, as published; its innovation is wrapped. Start: N(180°, 180²), nothing known. The
    true bearing .x is not wrapped: compare with angle_difference.

    Parameters
    ----------
    variant : str
        The recordings are look-alikes of real ones, see `kflearn.bearings`; from calm to hard: "calm", "typical",
        "reflections", "switching", "crossing", "hard".
    q, r : float
        What the filter assumes: the variances of a step and of a reading, in deg².
    steps : int
        How many samples.
    """
    record = partial(_bearings, choose(bearings.VARIANTS, variant))
    model = NonlinearModel(_same, _same, q, r, _one, _one, angle_difference)
    description = f"A microphone array reports the bearing of a sound source: {variant}."
    return Recorded(description, model, Gaussian(180, 180**2), None, None, steps, record=record)


def _bearings(habits, steps, rng):
    """One recording as a scenario wants it."""
    truth, reported = bearings.recording(habits, check.whole_number("steps", steps), rng)
    return truth[:, None], reported[:, None]


def _same(x):
    return x


def _one(x):
    return np.ones((*x.shape, 1))


def scalar_growth(variant="published", coefficient=2.5, steps=49) -> Scenario:
    """[KM] One state that two places attract and an alternating input pushes about; only its square is measured.

    x' = x/2 + c x/(1 + x²) + u + w with u_k = 8 cos(1.2 k), k = 2, 3, …; z = x²/20 + v; Q = 10, R = 1; truth and filter
    start at 0.1, P₀ = 1.

    Parameters
    ----------
    variant : str
        "published": F is evaluated at the prediction; "corrected": at the last estimate.
    coefficient : float
        c, 2.5 as published; 25 is the benchmark's usual number.
    steps : int
        How many measurements.
    """
    growth = Growth(check.number("coefficient", coefficient))
    k = np.arange(2, 2 + check.whole_number("steps", steps))
    slope = choose({"published": growth.slope_after, "corrected": growth.slope}, variant)
    model = NonlinearModel(growth.move, _twentieth_square, 10, 1, slope, _twentieth_square_slope)
    u = 8 * np.cos(1.2 * k)[:, None]
    return Scenario("A state of which only the square is seen.", model, Gaussian(0.1, 1), model, [0.1], steps, u, u)


@dataclass(frozen=True)
class Growth:
    """How the state of `scalar_growth` moves, with its coefficient c, and the slope of that."""

    coefficient: float

    def move(self, x, u) -> np.ndarray:
        """States (..., 1) and pushes (..., 1) to states (..., 1)."""
        return x / 2 + self.coefficient * x / (1 + x**2) + u

    def slope(self, x, u) -> np.ndarray:
        """The Jacobian (..., 1, 1) of `move` at x."""
        return (0.5 + self.coefficient * (1 - x**2) / (1 + x**2) ** 2)[..., None]

    def slope_after(self, x, u) -> np.ndarray:
        """The Jacobian at the prediction, as published."""
        return self.slope(self.move(x, u), u)


def _twentieth_square(x):
    return x**2 / 20


def _twentieth_square_slope(x):
    return x[..., None] / 10


def range_only(variant="published", position_sd=1.0, velocity_sd=1.0) -> Scenario:
    """[KM] A target [x, vx, y, vy] (m, m/s) of which a station at (200, 300) measures the distance every second.

    White acceleration of variances 1e-3 diag(0.5, 1) in x and y, R = 5 m², 59 steps; the filter starts at
    [−100, 2, 200, 20].

    Parameters
    ----------
    variant : str
        "published": the truth starts exactly there, too; "honest start": the truth is drawn from the filter's belief.
    position_sd, velocity_sd : float
        Standard deviations of that belief, in m and m/s.
    """
    sd = (
        check.number("position_sd", position_sd, positive=True),
        check.number("velocity_sd", velocity_sd, positive=True),
    )
    initial = Gaussian([-100, 2, 200, 20], np.diag(np.tile(np.square(sd), 2)))
    start = choose({"published": initial.mean, "honest start": initial}, variant)
    sight = Sight(4, (0, 2), (200, 300), (0,))
    Q = _KICKS @ (1e-3 * np.diag([0.5, 1])) @ _KICKS.T
    model = NonlinearModel(_sail, sight.measure, Q, 5, _sail_jacobian, sight.slope)
    return Scenario("A station measures how far a target is.", model, initial, model, start, steps=59)


def bearings_only(variant="published", R=0.1 * np.pi / 180) -> Scenario:
    """[KM] A target [x, vx, y, vy] (m, m/s) of which a station at (0, 1000) measures the bearing (rad), once a second.

    White acceleration of variance 1e-4 in x and y; P₀ = I around the truth [0, 2, 1400, −10], 39 steps. The innovation
    is wrapped.

    Parameters
    ----------
    variant : str
        "published": the truth starts exactly where the filter believes; "honest start": it is drawn from the belief;
        "crossing": the target goes round the station through three quadrants, never nearer than about 140 m.
    R : float
        Variance of a bearing, in rad². The published 0.1·π/180 is a standard deviation of 2.394°.
    """
    published = np.array([0.0, 2.0, 1400.0, -10.0])
    crossing = np.array([160.0, -15.0, 1400.0, -12.0])
    starts = {
        "published": (published, published),
        "honest start": (published, Gaussian(published, np.eye(4))),
        "crossing": (crossing, Gaussian(crossing, np.eye(4))),
    }
    mean, start = choose(starts, variant)
    sight = Sight(4, (0, 2), (0, 1000), (1,))
    Q = 1e-4 * _KICKS @ _KICKS.T
    model = NonlinearModel(_sail, sight.measure, Q, R, _sail_jacobian, sight.slope, homing.wrapped)
    return Scenario("A station measures where a target is seen.", model, Gaussian(mean, np.eye(4)), model, start, 39)


def range_and_bearing(variant="published") -> Scenario:
    """[KM] Six states [x, y, vx, vy, ax, ay] (m, s), distance (m) and bearing (rad) from the origin every 0.5 s.

    Q = diag(1, 1, .01, .01, 1e-4, 1e-4), R = diag(100, 1e-6), P₀ = diag(100, 100, 1, 1, .1, .1), 50 steps; the
    published filter has alpha = 0.01, beta = 2, kappa = 0.

    Parameters
    ----------
    variant : str
        By what the start differs from the truth. "published": N(0, Q); "honest start": N(0, P₀).
    """
    Q, R = np.diag([1, 1, 0.01, 0.01, 1e-4, 1e-4]), np.diag([100, 1e-6])
    sight = Sight(6, (0, 1), (0, 0), (0, 1))
    model = NonlinearModel(_fly, sight.measure, Q, R, _fly_jacobian, sight.slope, _polar_difference)
    initial = Gaussian([1000, 5000, 10, 50, 2, -4], np.diag([100, 100, 1, 1, 0.1, 0.1]))
    start = choose({"published": Gaussian(initial.mean, Q), "honest start": initial}, variant)
    return Scenario("A radar measures distance and bearing.", model, initial, model, start, steps=50)


def homing_missile() -> Scenario:
    """[KM] A missile homes on a target; nine states in space, two angles every 0.01 s: see `kflearn.homing`.

    Truth and filter, as published, each apply the guidance law to their own state; u is the time to go (s). R = 0.1/d²
    (rad²) with the distances d of an undisturbed flight. (The published filter takes d from its own estimate, which no
    fixed model can: `homing.fly` does that, and every other variant.)
    """
    u = homing.time_to_go(np.arange(homing.STEPS))[:, None]
    x, path = homing.TRUE_START, []
    for k in range(homing.STEPS):
        x = _home(x, u[k])
        path.append(x)
    R = homing.noise(np.linalg.norm(np.array(path)[:, :3], axis=-1))[:, 0]
    model = NonlinearModel(
        _home, homing.angles, homing.Q, R, homing.move_jacobian, homing.angles_jacobian, homing.wrapped
    )
    start = homing.TRUE_START
    return Scenario("A missile homes on a target.", model, homing.START, model, start, homing.STEPS, u, u)


def _home(x, u):
    """One step of a missile that applies the law to its own state; u (..., 1) is the time to go."""
    return homing.move(x, homing.law(x, u[..., 0]))


def inertial_navigation(variant="turning", outage=(80.0, 110.0)) -> Recorded:
    """[KS] A vehicle navigates in the plane by accelerometers and a gyro, 0.1 s a step, with a satellite fix each
    second: nine states, four of them errors of the sensors, see `kflearn.navigation`.

    120 s. The true start of each run is drawn from the filter's belief, and so are the sensors' errors; .u of a
    simulation is what the sensors read.

    Parameters
    ----------
    variant : str
        From rest to 10 m/s in 10 s, then "turning": bends to the left and right, 9°/s for 20 s each, from 30 s on; or
        "straight".
    outage : (float, float)
        From when to when no fix comes, in seconds.
    """
    check.word("variant", variant, ("turning", "straight"))
    start = Gaussian([0, 0, 0, 0, np.radians(30), 0, 0, 0, 0], np.diag(navigation.START_SD**2))
    record = partial(_drive, variant, start, outage)
    description = f"A vehicle navigates by its own sensors and by satellites: {variant}."
    return Recorded(description, navigation.model(), start, None, None, 1200, record=record)


def _drive(variant, start, outage, steps, rng):
    """One drive from a start that is drawn."""
    return navigation.drive(variant, steps, start.sample(rng=rng), rng, outage)


# The plane: states [x, vx, y, vy], one second a step, an unknown acceleration in x and one in y.
_PLANE = np.kron(np.eye(2), [[1, 1], [0, 1]])
_KICKS = np.kron(np.eye(2), [[0.5], [1]])


def _sail(x):
    return x @ _PLANE.T


def _sail_jacobian(x):
    return _PLANE


# The same with accelerations: states [x, y, vx, vy, ax, ay], half a second a step.
_SPACE = np.kron([[1, 0.5, 0.5**2 / 2], [0, 1, 0.5], [0, 0, 1]], np.eye(2))


def _fly(x):
    return x @ _SPACE.T


def _fly_jacobian(x):
    return _SPACE


@dataclass(frozen=True)
class Sight:
    """What a station sees of a target in the plane: its distance (row 0) and its bearing (row 1).

    n: the number of states; position: which two of them are x and y; station: where it stands; rows: which of the two
    it measures.
    """

    n: int
    position: tuple[int, int]
    station: tuple[float, float]
    rows: tuple[int, ...]

    def measure(self, x) -> np.ndarray:
        """Distance and bearing of states (..., n): (..., rows)."""
        east, north = np.moveaxis(x[..., list(self.position)] - self.station, -1, 0)
        return np.stack([np.hypot(east, north), np.arctan2(north, east)], axis=-1)[..., list(self.rows)]

    def slope(self, x) -> np.ndarray:
        """The Jacobian (..., rows, n) of `measure`."""
        offset = x[..., list(self.position)] - self.station
        distance = np.hypot(offset[..., :1], offset[..., 1:])
        across = offset[..., ::-1] * [-1, 1] / distance**2
        H = np.zeros((*x.shape[:-1], 2, self.n))
        H[..., list(self.position)] = np.stack([offset / distance, across], axis=-2)
        return H[..., list(self.rows), :]


def _polar_difference(z, expected):
    """The difference of two pairs (..., 2) of distance and bearing."""
    return np.concatenate([z[..., :1] - expected[..., :1], homing.wrapped(z[..., 1:], expected[..., 1:])], axis=-1)
