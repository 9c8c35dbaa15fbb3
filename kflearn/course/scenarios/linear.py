"""The linear systems: cart, voltmeter, temperature, free fall, train, ship, two odd sensors and a ball."""

import numpy as np

from ...models import checks as check
from ...models.gaussian import Gaussian
from ...models.kinematics import cart as cart_model
from ...models.kinematics import constant_velocity, random_walk
from ...models.state_space import LinearModel
from .. import video
from .base import Recorded, Scenario, choose


def cart() -> Scenario:
    """[KP] Newton's cart, one step of one second: it rolls at 10 m/s and a tape measure reads 62 m.

    State [position (m), velocity (m/s)], Q = diag(2², 0), R = 1²; start [50, 10] with P = diag(1, 0). No force acts.
    The step must end at 61.6667 m with variance 0.8333 m².
    """
    model = cart_model(dt=1.0, mass=1.0, Q=np.diag([4.0, 0.0]), R=1.0)
    initial = Gaussian([50, 10], np.diag([1.0, 0.0]))
    return Scenario("A cart rolls at 10 m/s past a tape measure.", model, initial, model, initial, steps=1)


def voltmeter(variant="published", Q=4.0, R=4.0, steps=20) -> Scenario:
    """[KP] A voltmeter reads a source of about 12 V.

    The filter assumes a random walk and starts knowing nothing: N(0, 100²). (As published it starts at its first
    reading: `start_from`.) What really happens has standard deviations of 2 V and 2 V, whatever the filter assumes.

    Parameters
    ----------
    variant : str
        What the voltage does. "published": it is new and independent at each reading, N(12, 2²); "random walk": it
        starts at N(12, 2²) and drifts by N(0, 2²) a step, as the filter assumes; "constant": it stays at 12 V.
    Q, R : float
        What the filter assumes: the variances of a step and of a reading (V²), both 2² = 4 as published.
    steps : int
        How many readings.
    """
    check.whole_number("steps", steps)
    truths = {
        "published": (LinearModel(F=0, H=1, Q=4, R=4, B=1), Gaussian(12, 4), np.full((steps, 1), 12.0)),
        "random walk": (random_walk(4, 4), Gaussian(12, 4), None),
        "constant": (random_walk(0, 4), [12.0], None),
    }
    truth_model, start, u = choose(truths, variant)
    description = f"A voltmeter reads a source of about 12 V; its true voltage: {variant}."
    initial = Gaussian(0, 100**2)
    return Scenario(description, random_walk(Q, R), initial, truth_model, start, steps, truth_u=u)


def temperature(variant="published") -> Scenario:
    """[KM] The temperature of a room, about 25 °C, once a minute with a thermometer of R = 0.25 °C².

    Random walk, Q = 0.01 °C² a step, 119 readings after the start.

    Parameters
    ----------
    variant : str
        "published": the truth starts at 25.1 °C, the filter at a first reading, 24.9 °C, with P = 0.01 °C², as if the
        variance of that reading were 25 times smaller than it is; "honest start": P = R, and the truth is drawn from
        that belief.
    """
    model = random_walk(0.01, 0.25)
    first = Gaussian(24.9, 0.25)
    starts = {"published": (Gaussian(24.9, 0.01), np.array([25.1])), "honest start": (first, first)}
    initial, truth_start = choose(starts, variant)
    return Scenario("The temperature of a room.", model, initial, model, truth_start, steps=119)


def free_fall(variant="published") -> Scenario:
    """[KM] A body falls from 95 m: state [height (m), velocity (m/s, upwards)], gravity as control input (m/s²).

    Q = 0, R = 1 m²; the filter starts at [95, 1] with P = diag(10, 1).

    Parameters
    ----------
    variant : str
        "published": gravity −1 m/s², 999 steps of 1 s, the truth starts exactly where the filter believes, and the
        ground does not stop the fall; "physical": gravity −9.8 m/s², 45 steps of 0.1 s, the last one just above the
        ground, and the truth is drawn from the belief at the start.
    """
    belief = Gaussian([95, 1], np.diag([10, 1]))
    variants = {"published": (1.0, -1.0, 999, belief.mean), "physical": (0.1, -9.8, 45, belief)}
    dt, gravity, steps, truth_start = choose(variants, variant)
    model = LinearModel(F=[[1, dt], [0, 1]], H=[[1, 0]], Q=np.zeros((2, 2)), R=1, B=[[dt**2 / 2], [dt]])
    u = np.full((steps, 1), gravity)
    return Scenario("A body falls.", model, belief, model, truth_start, steps, u, u)


def train(start_speed_variance=1.0) -> Scenario:
    """[KS] A train at a constant 10 m/s, its position measured every 0.1 s with R = 1 m².

    State [position (m), velocity (m/s)], Q = 0, 100 steps. The filter starts at [0, 5], 5 m/s wrong in speed.

    Parameters
    ----------
    start_speed_variance : float
        Of the speed at the start, in m²/s²: 1 as published, which is five standard deviations wrong; 25 is the honest
        value.
    """
    model = LinearModel(F=[[1, 0.1], [0, 1]], H=[[1, 0]], Q=np.zeros((2, 2)), R=1)
    speed = check.covariance("start_speed_variance", start_speed_variance, 1).item()
    initial = Gaussian([0, 5], np.diag([1, speed]))
    return Scenario("A train at a constant speed.", model, initial, model, np.array([0.0, 10.0]), steps=100)


def ship(variant="published") -> Scenario:
    """[KM] A ship and its GPS: state [x, vx, y, vy] in m and m/s, both positions measured every second.

    R = 100 m² each, Q = 0.01 diag(0.5, 1, 0.5, 1), 79 steps, P₀ = I.

    Parameters
    ----------
    variant : str
        "published": the filter starts at the exact truth [−100, 2, 200, 20]; "honest start": the truth is drawn from
        N([−100, 2, 200, 20], P₀).
    """
    axis = np.eye(2)
    model = LinearModel(
        F=np.kron(axis, [[1, 1], [0, 1]]),
        H=np.kron(axis, [[1, 0]]),
        Q=0.01 * np.diag([0.5, 1, 0.5, 1]),
        R=100 * axis,
    )
    initial = Gaussian([-100, 2, 200, 20], np.eye(4))
    start = choose({"published": initial.mean, "honest start": initial}, variant)
    return Scenario("A ship and its GPS.", model, initial, model, start, steps=79)


def biased_sensor() -> Scenario:
    """[KS] A cart at about 10 m/s, whose position is measured every 0.1 s with a bias that wanders.

    State [position (m), velocity (m/s), bias (m)]: white acceleration of 0.2 m/s², a first-order Gauss–Markov bias of
    1 m and 2 s; R = 0.25 m², 400 steps. The filter starts at [1, 11, 0] with P = diag(4, 4, 1), the truth at [0, 10]
    with a bias drawn from N(0, 1).
    """
    fading, line = np.exp(-0.1 / 2), constant_velocity(0.1, 0.2, 0.25)
    F, Q = np.diag([0, 0, fading]), np.diag([0, 0, 1 - fading**2])
    F[:2, :2], Q[:2, :2] = line.F, line.Q
    model = LinearModel(F, [[1, 0, 1]], Q, 0.25)
    truth = Gaussian([0, 10, 0], np.diag([0, 0, 1]))
    return Scenario("A sensor with a bias.", model, Gaussian([1, 11, 0], np.diag([4, 4, 1])), model, truth, steps=400)


def unknown_noise(variant="constant") -> Scenario:
    """[KS] A cart at about 10 m/s, whose position is measured every 0.1 s by a sensor worse than its data sheet.

    State [position (m), velocity (m/s)], white acceleration of 0.5 m/s², 400 steps; the filter assumes R = 1 m² and
    starts at the truth [0, 10] with P = 4 I.

    Parameters
    ----------
    variant : str
        The sensor's variance. "constant": 4 m²; "changing": 1 m², but 16 m² from 15 to 25 s; "as promised": 1 m².
    """
    model = constant_velocity(0.1, 0.5, 1.0)
    t = 0.1 * np.arange(1, 401)
    changing = np.where((t > 15) & (t <= 25), 16.0, 1.0)[:, None, None]
    truth = model.replace(R=choose({"constant": 4.0, "changing": changing, "as promised": 1.0}, variant))
    start = np.array([0.0, 10.0])
    return Scenario("A sensor worse than promised.", model, Gaussian(start, 4 * np.eye(2)), truth, start, steps=400)


def ball(variant="published") -> Recorded:
    """[KM] A ball in a video (see `kflearn.video`): state [column, row] in px and their velocities in px/frame.

    Gravity, 6 px/frame², is the control input of the row's velocity; Q = 0.01 I; the detections' R was measured as
    [[.2845, .0045], [.0045, .0455]] px². 54 frames from the ball's first on, three of them hidden. The filter starts at
    the picture's centre, at rest, and gravity does not act before the first frame.

    Parameters
    ----------
    variant : str
        "published": P = 100 I, although the ball may be 160 px away; "honest start": standard deviations of 100 px and
        10 px/frame.
    """
    P = choose({"published": 100 * np.eye(4), "honest start": np.diag([1e4, 1e4, 100.0, 100.0])}, variant)
    F, H = np.kron([[1, 1], [0, 1]], np.eye(2)), np.eye(2, 4)
    model = LinearModel(F, H, 0.01 * np.eye(4), [[0.2845, 0.0045], [0.0045, 0.0455]], [[0], [0], [0], [1]])
    u = np.append(0, np.full(53, 6.0))[:, None]

    initial = Gaussian([160, 120, 0, 0], P)
    return Recorded("A ball falls and bounces in a video.", model, initial, None, None, 54, u, record=_film)


def _film(steps, rng):
    """One film: the ball's true states and where it was detected."""
    film = video.render(6 + steps, rng=rng)
    return film.truth[6:], video.detect(film.frames[6:], film.frames[:6].mean(axis=0)).centre
