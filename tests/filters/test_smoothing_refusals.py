"""What smoothers notice and refuse; each step smoothed with its own control input."""

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    LinearModel,
    NonlinearModel,
    constant_velocity,
    extended_kalman_filter,
    kalman_filter,
    rts_smoother,
    square_root_kalman_filter,
    two_filter_smoother,
    unscented_kalman_filter,
)
from kflearn.core.conditioning import divide_safely
from tests.filters.test_smoothing import NONLINEAR, rts
from tests.helpers import as_nonlinear, close, random_belief, random_model, with_gaps


def steered(model, us):
    """x' = (F + u G) x: the slope of f depends on the control input. The function, and the same as a stack."""
    G = np.array([[0, 0.4, 0], [-0.3, 0, 0.2], [0.1, 0, -0.2]])

    def f(x, u):
        return x @ model.F.T + u * (x @ G.T)

    def F_jacobian(x, u):
        return np.broadcast_to(model.F + u[..., None] * G, (*x.shape, 3))

    bent = NonlinearModel(f, lambda x: x @ model.H.T, model.Q, model.R, F_jacobian, lambda x: model.H)
    return bent, LinearModel(model.F + us[:, :, None] * G, model.H, model.Q, model.R)


@pytest.mark.parametrize("kf", NONLINEAR)
@pytest.mark.parametrize("given", [True, False], ids=["Jacobians given", "by differences"])
def test_each_step_is_smoothed_with_its_own_control_input(kf, given):
    rng = np.random.default_rng(7)
    us, z = rng.normal(size=(12, 1)), with_gaps(rng, rng.normal(size=(4, 12, 2)))
    model, stack = steered(random_model(rng, 3, 2), us)
    model = model if given else model.replace(F_jacobian=None, H_jacobian=None)
    initial = random_belief(rng, 3)
    expected = rts(stack, z, initial)
    found = rts(model, z, initial, us, kf)
    close(found.mean, expected.mean, 1e-7)
    close(found.cov, expected.cov, 1e-7)


@pytest.mark.parametrize("name", ["F", "Q"])
@pytest.mark.parametrize("nonlinear", [False, True])
def test_a_model_that_differs_by_a_thousandth_is_noticed(name, nonlinear):
    rng = np.random.default_rng(8)
    model, initial, z = random_model(rng, 2, 2), random_belief(rng, 2), rng.normal(size=(15, 2))
    dress, kf = (as_nonlinear, unscented_kalman_filter) if nonlinear else (lambda model: model, kalman_filter)
    track = kf(dress(model), z, initial)
    rebuilt = dress(model.replace(**{name: getattr(model, name) * (1 + 1e-12)}))
    close(rts_smoother(rebuilt, track).mean, rts_smoother(track.model, track).mean)
    with pytest.raises(ValueError, match="model must be the one the track was filtered with"):
        rts_smoother(dress(model.replace(**{name: getattr(model, name) * (1 + 1e-3)})), track)


@pytest.mark.parametrize("kf", [extended_kalman_filter, unscented_kalman_filter])
def test_a_model_that_moves_the_mean_otherwise_is_noticed(kf):
    # An offset changes no covariance.
    z, initial = np.arange(6.0)[:, None], Gaussian([0, 0], np.eye(2))
    train = as_nonlinear(constant_velocity(1, 1, 1))
    track = kf(train, z, initial)
    with pytest.raises(ValueError, match="model must be the one the track was filtered with"):
        rts_smoother(train.replace(f=lambda x: train.f(x) + np.array([0.1, 0])), track)


@pytest.mark.parametrize("kf", [extended_kalman_filter, unscented_kalman_filter])
def test_a_function_that_mixes_steps_is_named(kf):
    # The filter never sees what f does to eleven states at once; the smoother asks for all steps together.
    F, T = np.array([[1.0, 1.0], [0.0, 0.9]]), 12

    def f(x):
        return (x[..., ::-1, :] if x.ndim > 1 and x.shape[-2] == T - 1 else x) @ F.T

    model = NonlinearModel(f, lambda x: x[..., :1], np.eye(2), 1.0, lambda x: F, lambda x: np.eye(2)[:1])
    track = kf(model, np.random.default_rng(0).normal(size=(T, 1)), Gaussian([0, 0], np.eye(2)))
    with pytest.raises(ValueError, match=r"f must treat every state alone.*all steps at once give other predictions"):
        rts_smoother(model, track)


def test_a_function_that_fails_on_all_steps_at_once_is_named():
    F = np.array([[1.0, 1.0], [0.0, 0.9]])
    model = NonlinearModel(lambda x: x @ F.T, lambda x: x[..., :1], np.eye(2), 1.0)
    track = extended_kalman_filter(model, np.arange(6.0), Gaussian([0, 0], np.eye(2)))
    with pytest.raises(ValueError, match=r"f must treat every state alone.*not x\[0\] or x\.T.*error"):
        rts_smoother(model.replace(f=lambda x: (np.eye(2, 3) @ x.T).T), track)


def test_two_filters_far_apart_are_right_and_too_far_apart_are_refused():
    for n in (2, 3):
        start = Gaussian(np.zeros(n), np.eye(n))
        far = LinearModel(0.9 * np.eye(n), np.ones((1, n)), 1e8 * np.eye(n), 1e-8)
        found = two_filter_smoother(far, np.arange(6.0), start)
        expected = rts_smoother(far, square_root_kalman_filter(far, np.arange(6.0), start))
        np.testing.assert_allclose(found.std, expected.std, rtol=1e-9)
        assert (abs(found.mean - expected.mean) <= 1e-9 * expected.std).all()
        with pytest.raises(ValueError, match="Q must be smaller beside R"):
            two_filter_smoother(far.replace(Q=1e20 * np.eye(n), R=1e-12), np.arange(6.0), start)


def test_the_cut_off_of_the_division_keeps_what_is_nearly_singular():
    # Two states whose correlation is 1 − 1e-12: P P⁻¹ = I to as many digits as P has left.
    P = np.array([[1, 1 - 1e-12], [1 - 1e-12, 1]])
    np.testing.assert_allclose(divide_safely(P, P), np.eye(2), atol=1e-3)


@pytest.mark.parametrize("P0", [1.0, 1e6, 1e8])
@pytest.mark.parametrize("factor", [1.001, 2, 10, 100])
def test_a_foreign_model_is_seen_whatever_the_start(P0, factor):
    model = constant_velocity(1, 0.3, 1)
    track = kalman_filter(model, np.cumsum(np.random.default_rng(3).normal(size=60)), Gaussian([0, 0], P0 * np.eye(2)))
    with pytest.raises(ValueError, match="model must be the one the track was filtered with"):
        rts_smoother(model.replace(Q=factor * model.Q), track)
    assert rts_smoother(model.replace(Q=model.Q), track).std.max() < 2
