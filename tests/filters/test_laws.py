"""What has to hold on random models: the textbook loop, converged gains, batch axes, likelihood, digits."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kflearn import (
    Gaussian,
    LinearModel,
    constant_velocity,
    correct,
    extended_kalman_filter,
    kalman_filter,
    predict,
    simulate,
    unscented_kalman_filter,
)
from tests.filters.test_properties import (
    LINEAR,
    SIGMA,
    every_filter,
    every_nonlinear_filter,
    outputs,
    seeds,
    states,
)
from tests.helpers import (
    as_nonlinear,
    bent,
    close,
    random_belief,
    random_covariance,
    random_model,
    same_track,
    textbook,
    with_gaps,
)


@given(rng=seeds, n=states, m=outputs, p=st.integers(0, 2), gaps=st.booleans(), varying=st.booleans())
def test_kalman_filter_is_the_textbook_loop(rng, n, m, p, gaps, varying):
    T = 9
    model, initial = random_model(rng, n, m, p, steps=T if varying else None), random_belief(rng, n)
    z, u = rng.normal(size=(T, m)), rng.normal(size=(T, p)) if p else None
    z = with_gaps(rng, z) if gaps else z
    mean, cov, predicted_mean, predicted_cov, log_likelihood = textbook(model, z, initial, u)
    track = kalman_filter(model, z, initial, u)
    close(track.mean, mean)
    close(track.cov, cov)
    close(track.predicted.mean, predicted_mean)
    close(track.predicted.cov, predicted_cov)
    close(track.log_likelihood, log_likelihood)
    belief = initial
    for k in range(T):  # and the two steps by hand
        belief = correct(model, predict(model, belief, None if u is None else u[k], k=k), z[k], k=k)
        close(belief.mean, mean[k])
        close(belief.cov, cov[k])


@pytest.mark.parametrize("runs", [None, 3, 150])
@settings(max_examples=4)
@given(rng=seeds, n=states, m=outputs)
def test_a_converged_gain_changes_nothing(runs, rng, n, m):
    # Long enough for the gain to come to rest and for the blocked recursion, which only few runs use.
    model, initial, T = random_model(rng, n, m, p=1, fastest=1), random_belief(rng, n), 1200
    u = rng.normal(size=(T, 1))
    z = simulate(model, initial, T, u, runs, rng).z
    track = kalman_filter(model, z, initial, u)
    first = z if runs is None else z[-1]
    mean, cov, predicted_mean, predicted_cov, log_likelihood = textbook(model, first, initial, u)
    close(track.mean if runs is None else track.mean[-1], mean)
    close(track.predicted.mean if runs is None else track.predicted.mean[-1], predicted_mean)
    close(track.cov if runs is None else track.cov[-1], cov)
    close(track.predicted.cov if runs is None else track.predicted.cov[-1], predicted_cov)
    close(track.log_likelihood if runs is None else track.log_likelihood[-1], log_likelihood)


@settings(max_examples=5)
@given(ratio=st.floats(-9, 1), start=st.floats(-6, 6), rng=seeds)
def test_a_slowly_converging_gain_is_not_held_too_early(ratio, start, rng):
    model, initial = constant_velocity(1, 10**ratio, 1), Gaussian([0, 0], 10**start * np.eye(2))
    z = rng.normal(size=2000)
    mean, cov, *_, log_likelihood = textbook(model, z[:, None], initial)
    track = kalman_filter(model, z, initial)
    close(track.mean, mean)
    np.testing.assert_allclose(track.cov, cov, rtol=1e-8)
    close(track.log_likelihood, log_likelihood)


@every_filter
@given(rng=seeds, n=st.integers(1, 3), m=st.integers(1, 2), gaps=st.booleans())
def test_axes_of_q_r_and_the_start_make_a_grid(kf, rng, n, m, gaps):
    model, T = random_model(rng, n, m), 5
    model = model if kf in LINEAR else bent(model)
    Q = np.stack([random_covariance(rng, n) for _ in range(3)])
    R = np.stack([random_covariance(rng, m) for _ in range(2)])
    z, initial = rng.normal(size=(4, T, m)), random_belief(rng, n)
    z = with_gaps(rng, z) if gaps else z
    wide = model.replace(Q=Q[:, None, None, None], R=R[:, None, None])
    track = kf(wide, z, initial)
    assert track.mean.shape == (3, 2, 4, T, n)
    assert track.log_likelihood.shape == (3, 2, 4)
    assert track.cov.shape == (3, 2, 4, T, n, n)
    assert track.gain.shape == (3, 2, 4, T, n, m)
    for i in range(3):
        for j in range(2):
            alone = kf(model.replace(Q=Q[i], R=R[j]), z, initial)
            close(track.mean[i, j], alone.mean)
            close(track.predicted.mean[i, j], alone.predicted.mean)
            close(track.cov[i, j], alone.cov)
            close(track.gain[i, j], alone.gain)
            close(track.nis[i, j], alone.nis)
            close(track.log_likelihood[i, j], alone.log_likelihood)
    starts = Gaussian(rng.normal(size=(3, 1, n)), Q[:, None])
    track = kf(model, z, starts)
    for i in range(3):
        alone = kf(model, z, Gaussian(starts.mean[i, 0], Q[i]))
        close(track.mean[i], alone.mean)
        close(track.cov[i], alone.cov)


@every_filter
@given(rng=seeds, n=st.integers(1, 3), m=st.integers(1, 2))
def test_every_matrix_of_a_linear_model_may_have_batch_axes(kf, rng, n, m):
    models = [random_model(rng, n, m, 1, steps=5) for _ in range(3)]
    stacked = LinearModel(*(np.stack([getattr(model, name) for model in models])[:, None] for name in "FHQRB"))
    z, u, initial = rng.normal(size=(2, 5, m)), rng.normal(size=(2, 5, 1)), random_belief(rng, n)
    track = kf(stacked, z, initial, u)
    for i, model in enumerate(models):
        alone = kf(model, z, initial, u)
        close(track.mean[i], alone.mean)
        close(track.predicted.mean[i], alone.predicted.mean)
        close(track.nis[i], alone.nis)


@every_filter
@given(rng=seeds, n=st.integers(1, 3), m=st.integers(1, 2), gaps=st.booleans())
def test_log_likelihood_is_the_joint_density_of_the_series(kf, rng, n, m, gaps):
    T, model, initial = 5, random_model(rng, n, m), random_belief(rng, n)
    z = rng.normal(size=(T, m))
    z = with_gaps(rng, z) if gaps else z
    # x_k = F^k x_0 + sums of F^(k-j) w_j: the means and covariances of all measurements at once.
    powers = [np.linalg.matrix_power(model.F, k) for k in range(T + 1)]
    mean = np.concatenate([model.H @ powers[k + 1] @ initial.mean for k in range(T)])
    cov = np.zeros((T * m, T * m))
    for k in range(T):
        for l in range(T):
            both = powers[k + 1] @ initial.cov @ powers[l + 1].T
            both = both + sum(powers[k - j] @ model.Q @ powers[l - j].T for j in range(min(k, l) + 1))
            cov[k * m : (k + 1) * m, l * m : (l + 1) * m] = model.H @ both @ model.H.T + (k == l) * model.R
    seen = ~np.isnan(z.ravel())
    error, cov = (z.ravel() - mean)[seen], cov[np.ix_(seen, seen)]
    expected = -0.5 * (error @ np.linalg.solve(cov, error) + np.linalg.slogdet(2 * np.pi * cov)[1])
    np.testing.assert_allclose(kf(model, z, initial).log_likelihood, expected, rtol=1e-9, atol=1e-9)


@every_nonlinear_filter
@given(rng=seeds, n=states, m=outputs, p=st.integers(0, 1), gaps=st.booleans(), dressed=st.booleans())
def test_on_linear_models_all_are_the_kalman_filter(kf, rng, n, m, p, gaps, dressed):
    model, initial = random_model(rng, n, m, p), random_belief(rng, n)
    z, u = rng.normal(size=(8, m)), rng.normal(size=(8, p)) if p else None
    z = with_gaps(rng, z) if gaps else z
    same_track(kf(as_nonlinear(model) if dressed else model, z, initial, u), kalman_filter(model, z, initial, u))


@pytest.mark.parametrize("kf", [extended_kalman_filter], ids=lambda f: f.__name__)
@given(rng=seeds, n=states, m=outputs, p=st.integers(0, 1))
def test_jacobians_by_differences_do(kf, rng, n, m, p):
    model, initial = bent(random_model(rng, n, m, p)), random_belief(rng, n)
    z, u = rng.normal(size=(3, 6, m)), rng.normal(size=(3, 6, p)) if p else None
    same_track(kf(model.replace(F_jacobian=None, H_jacobian=None), z, initial, u), kf(model, z, initial, u), 1e-7)


@given(rng=seeds, n=states, m=outputs)
def test_sigma_points_close_together_lose_few_digits(rng, n, m):
    model, initial, z = random_model(rng, n, m), random_belief(rng, n), rng.normal(size=(10, m))
    narrow = unscented_kalman_filter(model, z, initial, alpha=0.01)
    same_track(narrow, kalman_filter(model, z, initial), 1e-6)


@pytest.mark.parametrize("kf", SIGMA, ids=lambda f: f.__name__)
def test_sigma_points_survive_a_start_that_knows_nothing(kf):
    # The textbook's P − K S Kᵀ is negative here: it subtracts two numbers near 1e12 to find one of 1e-6.
    model = constant_velocity(1, 0.1, 1e-6)
    track = kf(model, np.arange(10.0), Gaussian([0, 0], 1e12 * np.eye(2)))
    np.testing.assert_allclose(track.std[1:, 0], 1e-3, rtol=1e-3)
