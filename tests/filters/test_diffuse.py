"""A start from nothing: the limit of a start with an ever larger variance, in 80 digits."""

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    LinearModel,
    constant_acceleration,
    constant_velocity,
    diffuse_start,
    kalman_filter,
    random_walk,
    start_from,
)
from kflearn.filters.diffuse import resting_first

from .ill_conditioned import seasonal
from .precise import answer
from .test_ill_conditioned import STRUCTURAL, series


def limit(model, z):
    """The answer in 80 digits from a variance of 1e40, one step before z[0], and the likelihood without that start.

    F has the determinant 1 here: so vague a start is as vague one step later.
    """
    far = answer(model, z, Gaussian(np.zeros(model.n), 1e40 * np.eye(model.n)))
    return far, far.log_likelihood + model.n / 2 * np.log(1e40 * 2 * np.pi)


@pytest.mark.parametrize("model", [random_walk(2, 3), constant_velocity(1, 0.5, 2), constant_acceleration(1, 0.1, 4)])
@pytest.mark.parametrize("gaps", [(), (1,), (0, 3)])
def test_it_is_the_limit_of_a_vague_start(model, gaps):
    z = np.cumsum(np.random.default_rng(5).normal(size=(30, 1)), axis=0)
    z[list(gaps)] = np.nan
    start = diffuse_start(model, z)
    seen = np.flatnonzero(~np.isnan(z[:, 0]))
    assert start.steps == seen[model.n - 1] + 1
    track = kalman_filter(start.model, z[start.steps :], start.belief)
    far, log_likelihood = limit(model, z)
    mean, std = far.filtered
    exact_mean, exact_std = (np.array(part, float) for part in (mean, std))
    np.testing.assert_allclose(start.belief.mean, exact_mean[start.steps - 1], rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(start.belief.std, exact_std[start.steps - 1], rtol=1e-9)
    np.testing.assert_allclose(track.mean, exact_mean[start.steps :], rtol=1e-9, atol=1e-9)
    assert start.log_likelihood + track.log_likelihood == pytest.approx(log_likelihood, abs=1e-8)


def test_nile_and_its_likelihood_as_kfas_gives_it():
    z, model = series("nile"), random_walk(1469.1, 15099)
    start = diffuse_start(model, z)
    track = kalman_filter(start.model, z[start.steps :], start.belief)
    assert start.log_likelihood + track.log_likelihood == pytest.approx(-632.545625, abs=5e-7)
    same = start_from(model, z[0])
    np.testing.assert_allclose([start.belief.mean[0], start.belief.cov[0, 0]], [same.mean[0], same.cov[0, 0]])


@pytest.mark.parametrize("name", STRUCTURAL)
def test_structural_models_start_from_nothing(name):
    z, model = np.log10(series(name))[:, None], seasonal(*STRUCTURAL[name])
    start = diffuse_start(model, z)
    assert start.steps == model.n
    track = kalman_filter(start.model, z[start.steps :], start.belief)
    far = answer(model, z, Gaussian(np.zeros(model.n), 1e40 * np.eye(model.n)))
    mean, std = (np.array(part[start.steps :], float) for part in far.filtered)
    assert (abs(track.mean - mean) / std).max() < 1e-8
    assert abs(track.std / std - 1).max() < 1e-8


def test_a_control_input_counts_from_the_second_step_on():
    model = LinearModel([[1, 1], [0, 1]], [[1, 0]], np.zeros((2, 2)), 1, [[0.5], [1]])
    u = np.array([[99.0], [2.0], [-1.0], [0.5]])
    x = np.array([3.0, 1.0])
    z = [x[0]]
    for push in u[1:]:
        x = model.F @ x + model.B[:, 0] * push[0]
        z.append(x[0])
    start = diffuse_start(model, z, u)
    assert start.steps == 2
    track = kalman_filter(model, z[2:], start.belief, u[2:])
    np.testing.assert_allclose(track.mean[-1], x, atol=1e-12)


def test_stacks_are_cut_where_the_filter_goes_on():
    H = np.random.default_rng(1).normal(size=(8, 1, 2))
    z = H @ [2.0, -3.0]
    start = diffuse_start(LinearModel(np.eye(2), H, np.zeros((2, 2)), 1), z)
    assert start.model.H.shape == (6, 1, 2)
    np.testing.assert_allclose(kalman_filter(start.model, z[2:], start.belief).mean[-1], [2, -3])


def test_what_the_data_leave_open_is_said():
    model = LinearModel(np.eye(2), [[1, 0]], np.eye(2), 1)
    with pytest.raises(ValueError, match="z must determine all 2 states, but its 9 steps"):
        diffuse_start(model, np.arange(9.0))
    with pytest.raises(ValueError, match="z must be one series"):
        diffuse_start(random_walk(1, 1), np.zeros((3, 9, 1)))
    with pytest.raises(TypeError, match="model must be a LinearModel"):
        diffuse_start("model", [1.0])


def test_nothing_moves_at_the_first_step():
    model = resting_first(constant_velocity(1, 1, 1), 3)
    np.testing.assert_array_equal(model.F[0], np.eye(2))
    assert (model.Q[0] == 0).all() and (model.F[1:] == [[1, 1], [0, 1]]).all() and model.Q[1:].any(axis=(1, 2)).all()
