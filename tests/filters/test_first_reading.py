"""The two conventions of the start, against FilterPy, pykalman and statsmodels."""

import numpy as np
import pytest
from filterpy.kalman import KalmanFilter
from pykalman import KalmanFilter as PyKalman
from statsmodels.tsa.statespace.kalman_smoother import KalmanSmoother

from kflearn import (
    Gaussian,
    LinearModel,
    NonlinearModel,
    from_first_reading,
    kalman_filter,
    random_walk,
    rts_smoother,
    to_first_reading,
    two_filter_smoother,
)
from tests.helpers import random_belief, random_model

T = 9


def problem(seed):
    """A model with two measured components, readings of which some are missing, a belief."""
    rng = np.random.default_rng(seed)
    model = random_model(rng, n := rng.integers(2, 4), 2, 0)
    z = rng.normal(size=(T, 2))
    z[3], z[5, 0] = np.nan, np.nan
    return model, z, random_belief(rng, n)


def with_statsmodels(model, z, at_first):
    """Their smoother, whose start is the belief at the first reading."""
    theirs = KalmanSmoother(k_endog=model.m, k_states=model.n, initialization="known", constant=at_first.mean,
                            stationary_cov=at_first.cov)  # fmt: skip
    theirs.bind(np.array(z))
    for name, M in {"design": model.H, "transition": model.F, "state_cov": model.Q, "obs_cov": model.R}.items():
        theirs[name] = M
    theirs["selection"] = np.eye(model.n)
    return theirs.smooth()


@pytest.mark.parametrize("seed", range(5))
def test_their_start_in_kflearn(seed):
    model, z, at_first = problem(seed)
    theirs = with_statsmodels(model, z, at_first)
    ours = from_first_reading(model, T)
    track = kalman_filter(ours, z, at_first)
    np.testing.assert_allclose(track.mean, theirs.filtered_state.T, atol=1e-10)
    np.testing.assert_allclose(track.cov, np.moveaxis(theirs.filtered_state_cov, -1, 0), atol=1e-10)
    np.testing.assert_allclose(track.log_likelihood, theirs.llf, rtol=1e-10)
    for smooth in (rts_smoother(ours, track), two_filter_smoother(ours, z, at_first)):
        np.testing.assert_allclose(smooth.mean, theirs.smoothed_state.T, atol=1e-9)
        np.testing.assert_allclose(smooth.cov, np.moveaxis(theirs.smoothed_state_cov, -1, 0), atol=1e-9)


@pytest.mark.parametrize("seed", range(5))
def test_our_start_in_theirs(seed):
    model, z, initial = problem(seed)
    theirs = with_statsmodels(model, z, to_first_reading(model, initial))
    track = kalman_filter(model, z, initial)
    np.testing.assert_allclose(track.mean, theirs.filtered_state.T, atol=1e-10)
    np.testing.assert_allclose(track.log_likelihood, theirs.llf, rtol=1e-10)


def test_pykalman_has_two_conventions_and_filterpy_can_have_both():
    model, z, belief = problem(0)
    z = np.nan_to_num(z)
    theirs = PyKalman(model.F, model.H, model.Q, model.R, initial_state_mean=belief.mean,
                      initial_state_covariance=belief.cov)  # fmt: skip
    at_first = kalman_filter(from_first_reading(model, T), z, belief)
    np.testing.assert_allclose(at_first.mean, theirs.filter(z)[0], atol=1e-10)
    first, _ = theirs.filter_update(belief.mean, belief.cov, z[0])
    np.testing.assert_allclose(kalman_filter(model, z, belief).mean[0], first, atol=1e-10)

    for update_first, ours in ((False, kalman_filter(model, z, belief)), (True, at_first)):
        kf = KalmanFilter(model.n, model.m)
        kf.x, kf.P, kf.F, kf.H, kf.Q, kf.R = belief.mean, belief.cov, model.F, model.H, model.Q, model.R
        means, _, ahead, _ = kf.batch_filter(list(z), update_first=update_first)
        np.testing.assert_allclose(ours.predicted.mean[1:], ahead[:-1] if update_first else ahead[1:], atol=1e-10)
        assert np.allclose(means, ours.mean)


@pytest.mark.parametrize("stacked", [False, True])
def test_the_first_matrices_of_a_stack_and_the_first_input_are_not_used(stacked):
    rng = np.random.default_rng(3)
    model, belief = random_model(rng, 3, 2, 2), random_belief(rng, 3)
    z, u = rng.normal(size=(4, T, 2)), rng.normal(size=(T, 2))
    if stacked:
        model = model.replace(F=rng.normal(size=(4, T, 3, 3)) / 2, Q=np.repeat(model.Q[None], T, 0))
    ours = kalman_filter(from_first_reading(model, T), z, belief, u)
    rest = model.replace(F=model.F[:, 1:], Q=model.Q[1:]) if stacked else model
    first = kalman_filter(LinearModel(np.eye(3), model.H, np.zeros((3, 3)), model.R), z[:, :1], belief)
    for run in range(4):
        by_hand = rest.replace(F=rest.F[run]) if stacked else rest
        start = Gaussian(first.mean[run, 0], first.cov.reshape(-1, 3, 3)[0])
        after = kalman_filter(by_hand, z[run, 1:], start, u[1:])
        np.testing.assert_allclose(ours.mean[run, 1:], after.mean, atol=1e-10)
        np.testing.assert_allclose(ours.cov[run, 1:] if ours.cov.ndim > 3 else ours.cov[1:], after.cov, atol=1e-10)


def test_what_fits_not_is_refused_by_name():
    curved = NonlinearModel(f=lambda x: x, h=lambda x: x, Q=1, R=1)
    with pytest.raises(TypeError, match="model must be a LinearModel, got NonlinearModel"):
        from_first_reading(curved, 3)
    with pytest.raises(ValueError, match="steps must be a whole number of at least 1, got 0"):
        from_first_reading(random_walk(1, 1), 0)
    with pytest.raises(ValueError, match="Q must have 4 steps, or 1"):
        from_first_reading(random_walk(1, 1).replace(Q=np.ones((3, 1, 1))), 4)
    assert f"{to_first_reading(curved, Gaussian(2, 3)):.0f}" == "N(2, 4)"
