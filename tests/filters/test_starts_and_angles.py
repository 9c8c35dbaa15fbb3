"""Starting from a measurement, `kalman_step`, wrapping measurements, the linearised filter."""

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    LinearModel,
    constant_velocity,
    correct,
    cubature_kalman_filter,
    extended_kalman_filter,
    kalman_filter,
    kalman_step,
    linearized_kalman_filter,
    predict,
    random_walk,
    scenarios,
    start_from,
    unscented_kalman_filter,
)
from kflearn.core.matrices import compact
from tests.helpers import as_nonlinear, bent, close, random_belief, random_model

FILTERS = [kalman_filter, extended_kalman_filter, unscented_kalman_filter, cubature_kalman_filter]


@pytest.mark.parametrize("kf", FILTERS[1:], ids=lambda f: f.__name__)
def test_measured_angles_may_wrap(kf):
    def wrap(z, expected):
        return (z - expected + np.pi) % (2 * np.pi) - np.pi

    rng = np.random.default_rng(4)
    turns = constant_velocity(1, 0.1, 0.05)
    z = np.cumsum(rng.normal(0.4, 0.1, size=(3, 40)), axis=-1)[..., None]  # goes round more than twice
    z[:, 7] = np.nan
    start = Gaussian([0, 0.4], 0.1 * np.eye(2))
    wrapped = as_nonlinear(turns).replace(residual=wrap)
    track = kf(wrapped, wrap(z, 0), start)
    straight = kalman_filter(turns, z, start)
    assert z[..., -1, 0].min() > 4 * np.pi
    close(track.mean, straight.mean)
    close(track.nis, straight.nis)
    naive = kf(as_nonlinear(turns), wrap(z, 0), start)
    assert abs(naive.mean - straight.mean).max() > 1


def test_start_from_a_measurement():
    H, R = np.array([[2.0, 1.0], [0.0, 3.0]]), np.array([[4.0, 1.0], [1.0, 2.0]])
    belief = start_from(LinearModel(np.eye(2), H, np.eye(2), R), [5, 6])
    inverse = np.linalg.inv(H)
    np.testing.assert_allclose(belief.mean, inverse @ [5, 6])
    np.testing.assert_allclose(belief.cov, inverse @ R @ inverse.T)
    many = start_from(LinearModel(np.eye(2), H, np.eye(2), R), np.ones((7, 2)))
    assert many.mean.shape == (7, 2)
    assert many.cov.shape == (2, 2)
    assert format(start_from(random_walk(1, 4), 3), "g") == "N(3, 4)"


def test_start_from_in_any_units():
    H, size = (
        np.array([[2.0, 1.0], [1.0, 3.0]]),
        np.array([1e-9, 1e9]),
    )  # the numbers of one state are 1e18 times as large
    plain, odd = (start_from(LinearModel(np.eye(2), H / each, np.eye(2), np.eye(2)), [4, 4]) for each in (1, size))
    np.testing.assert_allclose(odd.mean / size, plain.mean)
    np.testing.assert_allclose(odd.cov / size / size[:, None], plain.cov)
    for singular in (np.array([[1, 2], [3, 6]]) / size, np.diag([1.0, 0.0])):
        with pytest.raises(ValueError, match="H of shape"):
            start_from(LinearModel(np.eye(2), singular, np.eye(2), np.eye(2)), [1, 2])


def test_kalman_step_starts_itself():
    started = kalman_step([4.0, 6.0], np.diag([2.0, 8.0]), H=2 * np.eye(2), Q=np.eye(2))
    np.testing.assert_allclose(started.mean, [2, 3])  # nothing is predicted: Q does not count
    np.testing.assert_allclose(started.cov, np.diag([0.5, 2]))
    assert format(kalman_step(7, 3), "g") == "N(7, 3)"


def test_kalman_step_with_defaults_is_a_correction():
    after = kalman_step(62, 1, x=60, P=5)
    np.testing.assert_allclose(after.mean, [185 / 3])
    np.testing.assert_allclose(after.cov, [[5 / 6]])


def test_kalman_step_with_everything():
    rng = np.random.default_rng(6)
    model, belief, z, u = random_model(rng, 3, 2, 1), random_belief(rng, 3), rng.normal(size=2), rng.normal(size=1)
    step = kalman_step(z, model.R, belief.mean, belief.cov, model.F, model.H, model.Q, model.B, u)
    expected = correct(model, predict(model, belief, u), z)
    close(step.mean, expected.mean)
    close(step.cov, expected.cov)


def test_kalman_step_with_a_gap_predicts():
    after = kalman_step(np.nan, 1, x=60, P=5, F=2, Q=3)
    np.testing.assert_allclose(after.mean, [120])
    np.testing.assert_allclose(after.cov, [[23]])


def test_linearised_filter_about_a_given_path():
    # By hand: F and H at the nominal states, everything else as in the Kalman filter on the differences from it.
    rng = np.random.default_rng(2)
    model, initial = bent(random_model(rng, 3, 2)), random_belief(rng, 3)
    z, nominal = rng.normal(size=(9, 2)), rng.normal(size=(9, 3))
    x, P, before, means = initial.mean, initial.cov, initial.mean, []
    for k in range(9):
        F, H = model.move_slope(before), model.measure_slope(nominal[k])
        x, P = model.f(before) + F @ (x - before), F @ P @ F.T + model.Q
        K = P @ H.T @ np.linalg.inv(H @ P @ H.T + model.R)
        x, P = x + K @ (z[k] - model.h(nominal[k]) - H @ (x - nominal[k])), (np.eye(3) - K @ H) @ P
        before = nominal[k]
        means.append(x)
    track = linearized_kalman_filter(model, z, initial, nominal=nominal)
    np.testing.assert_allclose(track.mean, means)
    np.testing.assert_allclose(track.cov[-1], P)


def test_linearised_filter_shares_its_gains_and_wraps_angles():
    scene = scenarios.bearings_only("crossing")
    data = scene.simulate(runs=30, rng=0)
    track = linearized_kalman_filter(scene.model, data.z, scene.initial)
    assert track.gain.shape == (30, 39, 4, 1)
    assert compact(track.gain).shape == (39, 4, 1)
    assert abs(track.innovation.mean).max() < np.pi
    turned = linearized_kalman_filter(scene.model, data.z + 2 * np.pi, scene.initial)
    np.testing.assert_allclose(turned.mean, track.mean)
