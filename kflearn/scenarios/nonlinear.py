"""The nonlinear systems: what is measured, or how the state moves, bends."""

import numpy as np

from .. import _checks as check
from .. import bearings, homing, navigation
from ..angles import angle_difference
from ..gaussian import Gaussian
from ..models import NonlinearModel
from .base import Recorded, Scenario, choose


def bearing(variant="typical", q=200.0, r=500.0, steps=325):
    """[KP] The bearing of a sound source, from a microphone array that reports whole degrees, 0 to 359.

    The filter believes in a random walk of variance q (deg²) a sample, measured with variance r (deg²), as published;
    its innovation is wrapped. Start: N(180°, 180²), nothing known. The recordings are look-alikes of real ones, see
    `kflearn.bearings`; variants from calm to hard: "calm", "typical", "reflections", "switching", "crossing", "hard".
    The true bearing .x is not wrapped: compare with angle_difference.
    """
    habits = choose(bearings.VARIANTS, variant)
    model = NonlinearModel(lambda x: x, lambda x: x, q, r, _one, _one, angle_difference)

    def record(steps, rng):
        truth, reported = bearings.recording(habits, check.whole_number("steps", steps), rng)
        return truth[:, None], reported[:, None]

    description = f"A microphone array reports the bearing of a sound source: {variant}."
    return Recorded(description, model, Gaussian(180, 180**2), None, None, steps, record=record)


def _one(x):
    return np.ones((*x.shape, 1))


def scalar_growth(variant="published", coefficient=2.5, steps=49):
    """[KM] One state that two places attract and an alternating input pushes about; only its square is measured.

    x' = x/2 + c x/(1 + x²) + u + w with c = `coefficient` and u_k = 8 cos(1.2 k), k = 2, 3, …; z = x²/20 + v; Q = 10,
    R = 1; truth and filter start at 0.1, P₀ = 1. c = 2.5 as published, 25 is the benchmark's usual number.
    variant "published": F is evaluated at the prediction; "corrected": at the last estimate.
    """
    c = check.number("coefficient", coefficient)
    k = np.arange(2, 2 + check.whole_number("steps", steps))

    def move(x, u):
        return x / 2 + c * x / (1 + x**2) + u

    def slope(x, u):
        return (0.5 + c * (1 - x**2) / (1 + x**2) ** 2)[..., None]

    where = choose({"published": lambda x, u: slope(move(x, u), u), "corrected": slope}, variant)
    model = NonlinearModel(move, lambda x: x**2 / 20, 10, 1, where, lambda x: x[..., None] / 10)
    u = 8 * np.cos(1.2 * k)[:, None]
    return Scenario("A state of which only the square is seen.", model, Gaussian(0.1, 1), model, [0.1], steps, u, u)


def range_only(variant="published", position_sd=1.0, velocity_sd=1.0):
    """[KM] A target [x, vx, y, vy] (m, m/s) of which a station at (200, 300) measures the distance every second.

    White acceleration of variances 1e-3 diag(0.5, 1) in x and y, R = 5 m², 59 steps; the filter starts at
    [−100, 2, 200, 20] with P₀ of the standard deviations given (m, m/s). variant "published": so does the truth,
    exactly; "honest start": the truth is drawn from the filter's belief.
    """
    sd = (
        check.number("position_sd", position_sd, positive=True),
        check.number("velocity_sd", velocity_sd, positive=True),
    )
    initial = Gaussian([-100, 2, 200, 20], np.diag(np.tile(np.square(sd), 2)))
    start = choose({"published": initial.mean, "honest start": initial}, variant)
    measure, slope = _sight(4, [0, 2], [200, 300], [0])
    Q = _KICKS @ (1e-3 * np.diag([0.5, 1])) @ _KICKS.T
    model = NonlinearModel(lambda x: x @ _PLANE.T, measure, Q, 5, lambda x: _PLANE, slope)
    return Scenario("A station measures how far a target is.", model, initial, model, start, steps=59)


def bearings_only(variant="published", R=0.1 * np.pi / 180):
    """[KM] A target [x, vx, y, vy] (m, m/s) of which a station at (0, 1000) measures the bearing (rad), once a second.

    White acceleration of variance 1e-4 in x and y; P₀ = I around the truth [0, 2, 1400, −10], 39 steps. R = 0.1·π/180
    is taken as a variance, as published: a standard deviation of 2.394°. The innovation is wrapped.
    variant "published": the truth starts exactly where the filter believes; "honest start": it is drawn from the
    belief; "crossing": the target goes round the station through three quadrants, never nearer than about 140 m.
    """
    published = np.array([0.0, 2.0, 1400.0, -10.0])
    crossing = np.array([160.0, -15.0, 1400.0, -12.0])
    starts = {
        "published": (published, published),
        "honest start": (published, Gaussian(published, np.eye(4))),
        "crossing": (crossing, Gaussian(crossing, np.eye(4))),
    }
    mean, start = choose(starts, variant)
    measure, slope = _sight(4, [0, 2], [0, 1000], [1])
    Q = 1e-4 * _KICKS @ _KICKS.T
    model = NonlinearModel(lambda x: x @ _PLANE.T, measure, Q, R, lambda x: _PLANE, slope, homing.wrapped)
    return Scenario("A station measures where a target is seen.", model, Gaussian(mean, np.eye(4)), model, start, 39)


def range_and_bearing(variant="published"):
    """[KM] Six states [x, y, vx, vy, ax, ay] (m, s), distance (m) and bearing (rad) from the origin every 0.5 s.

    Q = diag(1, 1, .01, .01, 1e-4, 1e-4), R = diag(100, 1e-6), P₀ = diag(100, 100, 1, 1, .1, .1), 50 steps; filter with
    alpha = 0.01, beta = 2, kappa = 0. variant "published": the start differs from the truth by N(0, Q); "honest
    start": by N(0, P₀).
    """
    dt, plane = 0.5, np.eye(2)
    F = np.kron([[1, dt, dt**2 / 2], [0, 1, dt], [0, 0, 1]], plane)
    Q = np.diag([1, 1, 0.01, 0.01, 1e-4, 1e-4])

    measure, slope = _sight(6, [0, 1], [0, 0], [0, 1])
    R = np.diag([100, 1e-6])
    model = NonlinearModel(lambda x: x @ F.T, measure, Q, R, lambda x: F, slope, _polar_difference)
    initial = Gaussian([1000, 5000, 10, 50, 2, -4], np.diag([100, 100, 1, 1, 0.1, 0.1]))
    start = choose({"published": Gaussian(initial.mean, Q), "honest start": initial}, variant)
    return Scenario("A radar measures distance and bearing.", model, initial, model, start, steps=50)


def homing_missile():
    """[KM] A missile homes on a target; nine states in space, two angles every 0.01 s: see `kflearn.homing`.

    Truth and filter, as published, each apply the guidance law to their own state; u is the time to go (s). R = 0.1/d²
    (rad²) with the distances d of an undisturbed flight. (The published filter takes d from its own estimate, which no
    fixed model can: `homing.fly` does that, and every other variant.)
    """
    u = homing.time_to_go(np.arange(homing.STEPS))[:, None]

    def move(x, u):
        return x @ homing.F.T + homing.law(x, u[..., 0]) @ homing.PUSH.T

    x, path = homing.TRUE_START, []
    for k in range(homing.STEPS):
        x = move(x, u[k])
        path.append(x)
    R = homing.noise(np.linalg.norm(np.array(path)[:, :3], axis=-1))[:, 0]
    model = NonlinearModel(
        move, homing.angles, homing.Q, R, lambda x, u: homing.F, homing.angles_jacobian, homing.wrapped
    )
    start = homing.TRUE_START
    return Scenario("A missile homes on a target.", model, homing.START, model, start, homing.STEPS, u, u)


def inertial_navigation(variant="turning", outage=(80.0, 110.0)):
    """[KS] A vehicle navigates in the plane by accelerometers and a gyro, 0.1 s a step, with a satellite fix each
    second: nine states, four of them errors of the sensors, see `kflearn.navigation`.

    120 s: from rest to 10 m/s in 10 s, then variant "turning": bends to the left and right, 9°/s for 20 s each, from
    30 s on; or "straight". No fix comes during the `outage` (from, to), in seconds. The true start of each run is drawn
    from the filter's belief, and so are the sensors' errors; .u of a simulation is what the sensors read.
    """
    choose({"turning": None, "straight": None}, variant)
    start = Gaussian([0, 0, 0, 0, np.radians(30), 0, 0, 0, 0], np.diag(navigation.START_SD**2))

    def record(steps, rng):
        return navigation.drive(variant, steps, start.sample(rng=rng), rng, outage)

    description = f"A vehicle navigates by its own sensors and by satellites: {variant}."
    return Recorded(description, navigation.model(), start, None, None, 1200, record=record)


# The plane: states [x, vx, y, vy], one second a step, an unknown acceleration in x and one in y.
_PLANE = np.kron(np.eye(2), [[1, 1], [0, 1]])
_KICKS = np.kron(np.eye(2), [[0.5], [1]])


def _sight(n, position, station, rows):
    """h and its Jacobian for distance (row 0) and bearing (row 1) from a station; `position`: where x and y stand."""

    def measure(x):
        east, north = np.moveaxis(x[..., position] - station, -1, 0)
        return np.stack([np.hypot(east, north), np.arctan2(north, east)], axis=-1)[..., rows]

    def slope(x):
        offset = x[..., position] - station
        distance = np.hypot(offset[..., :1], offset[..., 1:])
        across = offset[..., ::-1] * [-1, 1] / distance**2
        H = np.zeros((*x.shape[:-1], 2, n))
        H[..., position] = np.stack([offset / distance, across], axis=-2)
        return H[..., rows, :]

    return measure, slope


def _polar_difference(z, expected):
    return np.concatenate([z[..., :1] - expected[..., :1], homing.wrapped(z[..., 1:], expected[..., 1:])], axis=-1)
