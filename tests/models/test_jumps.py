"""Angles that wrap in f or h without a difference for them: named where they do harm, and only there."""

import copy

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    NonlinearModel,
    adaptive_kalman_filter,
    correct,
    cubature_kalman_filter,
    extended_kalman_filter,
    imm_filter,
    linearized_kalman_filter,
    predict,
    scenarios,
    unscented,
    unscented_kalman_filter,
    wrap,
)
from kflearn.models.jumps import TURNS, jumps_of
from tests.helpers import close

FILTERS = [extended_kalman_filter, unscented_kalman_filter, cubature_kalman_filter, linearized_kalman_filter]
PAIR = dict(transition=[[0.9, 0.1], [0.1, 0.9]], mode_probabilities=[0.5, 0.5])


def robot(turn, **changes):
    """A heading that grows by a step of a 100th of a turn, and a place; f keeps the heading within ± half a turn."""

    def f(x):
        return np.stack([wrap(x[..., 0] + turn / 100, turn), x[..., 1] + 50], axis=-1)

    def difference(a, b):
        return np.concatenate([wrap(a[..., :1] - b[..., :1], turn), a[..., 1:] - b[..., 1:]], axis=-1)

    given = dict(residual=difference, state_residual=difference)
    size = np.diag([turn / 100, 3.0]) ** 2
    return NonlinearModel(f, lambda x: x, 0.01 * size, size, **{**given, **changes})


def drive(turn, steps=130):
    truth = np.stack([turn / 100 * np.arange(1, steps + 1), 50.0 * np.arange(1, steps + 1)], axis=-1)
    z = truth + np.random.default_rng(0).normal(size=truth.shape) * [turn / 100, 3]
    start = Gaussian([0, 0], np.diag([turn / 100, 3.0]) ** 2)
    return truth, z, np.concatenate([wrap(z[:, :1], turn), z[:, 1:]], axis=-1), start


@pytest.mark.parametrize("turn", TURNS)
def test_f_that_jumps_is_named_with_its_step(turn):
    _, _, z, start = drive(turn)
    told = "2π" if turn == TURNS[0] else "360"
    message = rf"^f jumps by {told} at step (4[5-9]|5[0-4]): give state_residual, which subtracts two states$"
    model = robot(turn, state_residual=None)
    for kf in FILTERS[1:3]:
        for runs in ((), (3,)):
            with pytest.raises(ValueError, match=message):
                kf(model, np.broadcast_to(z, (*runs, *z.shape)), start)
    for kf in (
        lambda: imm_filter([model, model], z, start, **PAIR, through=unscented(2)),
        lambda: adaptive_kalman_filter(model, z, start, through=unscented(2)),
    ):
        with pytest.raises(ValueError, match=message):
            kf()
    with pytest.raises(ValueError, match=f"^f jumps by {told} at step 7: give state_residual"):
        predict(model, Gaussian([0.49 * turn, 0], start.cov), k=7, through=unscented(2))


@pytest.mark.parametrize("turn", TURNS)
def test_what_is_measured_of_it_jumps_too(turn):
    _, _, z, start = drive(turn)
    told = "2π" if turn == TURNS[0] else "360"
    z[:, 0] %= turn  # the sensor counts from 0
    for kf in FILTERS:
        with pytest.raises(
            ValueError, match=rf"^h\(f\(x\)\) jumps by {told} at step \d+: give residual, which subtracts"
        ):
            kf(robot(turn, residual=None), z, start)


def bearing(x):
    return np.arctan2(x[..., 1:2], x[..., :1])


def short_way(a, b):
    return wrap(a - b, 2 * np.pi)


def ferry(**changes):
    """A ship that passes west of a station, from north to south: its bearing goes through ± π."""
    given = dict(f=lambda x: x + np.array([0, -10.0]), h=bearing, Q=np.eye(2), R=0.05**2)
    return NonlinearModel(**{**given, **changes})


def passage(steps=40):
    truth = np.array([-100, 200.0]) + np.arange(1, steps + 1)[:, None] * [0, -10.0]
    z = bearing(truth) + np.random.default_rng(1).normal(0, 0.05, (steps, 1))
    z[17] = -3.1  # on the other side already
    return z, Gaussian([-100, 200], 25 * np.eye(2))


@pytest.mark.parametrize("kf", FILTERS)
@pytest.mark.parametrize("runs", [(), (3,)])
def test_h_that_jumps_is_named_with_its_step(kf, runs):
    z, start = passage()
    z = np.broadcast_to(z, (*runs, *z.shape))
    message = r"^h jumps by 2π at step 1[679]: give residual, which subtracts two measurements$"
    with pytest.raises(ValueError, match=message):
        kf(ferry(), z, start)
    kf(ferry(), z[..., :15, :], start)  # it does not come near
    kf(ferry(residual=np.subtract), z, start)  # as the learner wants it
    kf(ferry(residual=short_way), z, start)


def test_an_angle_counted_from_zero_is_found_too():
    z, _ = passage()
    with pytest.raises(ValueError, match=r"^h jumps by 2π at step"):
        extended_kalman_filter(ferry(), (z - np.pi) % (2 * np.pi), Gaussian([100, 200], 25 * np.eye(2)))
    east = ferry(h=lambda x: np.degrees(bearing(x)) % 360, R=1)
    with pytest.raises(ValueError, match=r"^h jumps by 360 at step"):
        extended_kalman_filter(east, wrap(np.degrees(np.pi - z)), Gaussian([100, 200], 25 * np.eye(2)))
    with pytest.raises(ValueError, match=r"^h jumps by 2π at step 3: give residual"):
        correct(ferry(), Gaussian([-100, 1], np.eye(2)), -3.1, k=3)


def test_slopes_across_a_jump_are_refused():
    start = Gaussian([-100.0, 0.0], np.eye(2))
    with pytest.raises(ValueError, match=r"^h jumps by 2π at step 0: give residual"):
        correct(ferry(), start, np.nan)  # nothing was measured: by differences alone
    turning = NonlinearModel(lambda x: wrap(x + 1, 360), lambda x: x, 1, 1)
    with pytest.raises(ValueError, match=r"^f jumps by 360 at step 0: give state_residual"):
        predict(turning, Gaussian(179, 1))
    turning = turning.replace(state_residual=lambda a, b: wrap(a - b, 360))
    close(predict(turning, Gaussian(179, 1)).cov, [[2]], 1e-6)


@pytest.mark.parametrize("size", [1e-3, 1.0, 6.283185, 360, 1e6])
def test_large_differences_are_no_jumps(size):
    functions = {
        "linear": lambda x: x * size,
        "saturated": lambda x: size * np.tanh(x),
        "waves": lambda x: size * np.sin(x),
        "steps of another height": lambda x: size * np.where(x > 0.3, 1.3, -1.3),
        "root": lambda x: size * np.hypot(x, 1),
    }
    z = size * np.random.default_rng(0).normal(0, 5, (2, 30, 2))
    for function in functions.values():
        model = NonlinearModel(lambda x: x, function, np.eye(2), size**2 * np.eye(2))
        moving = NonlinearModel(lambda x, f=function: f(x) + x, lambda x: x, size**2 * np.eye(2), size**2 * np.eye(2))
        for kf in FILTERS:
            kf(model, z, Gaussian([0.1, 0.2], 9 * np.eye(2)))
        for kf in FILTERS[1:3]:
            kf(moving, z[:, :2], Gaussian([0.1, 0.2], 9 * np.eye(2)))


def test_all_is_as_before_where_nothing_jumps():
    """The search leaves no trace in numbers, and is made once for each model."""
    scene = scenarios.range_only()
    data, calls = scene.simulate(runs=3, rng=0), []

    def h(x):
        calls.append(len(x))
        return scene.model.h(x)

    model = scene.model.replace(h=h, H_jacobian=None)
    expected = unscented_kalman_filter(scene.model.replace(residual=np.subtract), data.z, scene.initial)
    counts = []
    for _ in range(2):
        calls.clear()
        np.testing.assert_array_equal(unscented_kalman_filter(model, data.z, scene.initial).mean, expected.mean)
        counts.append(len(calls))
    assert counts[0] - counts[1] <= 3
    assert not model.jumps["h"]["watch"]
    assert model.replace(R=7).jumps is model.jumps
    fresh = scene.model.replace(h=scene.model.h)
    correct(fresh, scene.initial, fresh.h(scene.initial.mean))  # nothing suspicious so far
    again = copy.deepcopy(fresh)
    np.testing.assert_array_equal(unscented_kalman_filter(again, data.z, scene.initial).mean, expected.mean)
    assert not again.jumps["h"]["watch"]
    assert model.replace(h=scene.model.h).jumps == {}


def test_what_a_function_raises_far_away_is_no_matter():
    def near(x):
        if (abs(x) > 1500).any():
            raise RuntimeError("off the map")
        return bearing(x)

    z, start = passage()
    with pytest.raises(ValueError, match=r"^h jumps by 2π at step"):
        unscented_kalman_filter(ferry(h=near), z, start)
    unscented_kalman_filter(ferry(h=near, residual=short_way), z, start)


def test_jumps_of_a_function():
    def angles(x):
        heading = np.sum(x, axis=-1)
        rounded = np.rint(heading * 100) % 360
        return np.stack(
            [heading % (2 * np.pi), np.degrees(heading) % 360, rounded, np.floor(heading), heading], axis=-1
        )

    for x in ([0.0, 0], [400, -3], [1e-3, 1e5]):
        assert jumps_of(angles, np.array(x), 1.0) == {(0, 0), (1, 1), (2, 1)}
    assert jumps_of(lambda x: np.full_like(x, np.nan), np.zeros(2), 1.0) == set()
