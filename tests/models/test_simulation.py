import numpy as np
import pytest

from kflearn import Gaussian, LinearModel, cart, constant_velocity, random_walk, simulate
from tests.helpers import as_nonlinear, random_belief, random_covariance, random_model

STILL = LinearModel([[1, 1], [0, 1]], [[1, 0]], np.zeros((2, 2)), 1e-30, [[0.5], [1]])


def test_shapes():
    model, start = constant_velocity(1, 1, 1), Gaussian([0, 0], np.eye(2))
    one = simulate(model, start, 5, rng=0)
    assert (one.x.shape, one.z.shape, one.u) == ((5, 2), (5, 1), None)
    many = simulate(model, start, 5, runs=3, rng=0)
    assert (many.x.shape, many.z.shape) == ((3, 5, 2), (3, 5, 1))
    assert simulate(STILL, [0, 0], 5, u=np.ones(5)).u.shape == (5, 1)


def test_seeds():
    model, start = constant_velocity(1, 1, 1), Gaussian([0, 0], np.eye(2))
    first, again, other = (simulate(model, start, 5, runs=3, rng=seed) for seed in (1, 1, 2))
    np.testing.assert_array_equal(first.x, again.x)
    np.testing.assert_array_equal(first.z, again.z)
    assert (first.z != other.z).all()
    generator = np.random.default_rng(1)
    np.testing.assert_array_equal(simulate(model, start, 5, runs=3, rng=generator).z, first.z)
    assert (simulate(model, start, 5, runs=3, rng=generator).z != first.z).all()


def test_the_first_state_is_one_step_after_the_start():
    data = simulate(STILL, [10, 2], 4, u=[1, 0, -1, 0], rng=0)
    np.testing.assert_allclose(data.x, [[12.5, 3], [15.5, 3], [18, 2], [20, 2]])
    np.testing.assert_allclose(data.z[:, 0], data.x[:, 0])


def test_every_run_may_have_its_own_start_input_and_model():
    u = np.array([[[1.0], [0]], [[0], [-1]], [[0], [0]]])
    data = simulate(STILL, [[0, 0], [10, 1], [0, 5]], 2, u, runs=3, rng=0)
    np.testing.assert_allclose(data.x[:, :, 0], [[0.5, 1.5], [11, 11.5], [5, 10]])
    starts = simulate(STILL, Gaussian([[0, 0], [10, 1], [0, 5]], np.zeros((2, 2))), 2, u, runs=3, rng=0)
    np.testing.assert_allclose(starts.x, data.x)
    speeds = LinearModel(np.array([1.0, 2, 3]).reshape(3, 1, 1, 1), 1, 0, 1e-30)
    np.testing.assert_allclose(simulate(speeds, [1], 3, runs=3, rng=0).x[..., 0], [[1, 1, 1], [2, 4, 8], [3, 9, 27]])


def test_matrices_of_each_step():
    model = LinearModel(np.array([1.0, 2, 3]).reshape(3, 1, 1), np.array([1.0, 1, 5]).reshape(3, 1, 1), 0, 1e-30)
    data = simulate(model, [2], 3, rng=0)
    np.testing.assert_allclose(data.x[:, 0], [2, 4, 12])
    np.testing.assert_allclose(data.z[:, 0], [2, 4, 60])
    sizes = np.array([1.0, 0, 9]).reshape(3, 1, 1)
    noisy = simulate(LinearModel(0, 1, sizes, sizes + 1), [0], 3, runs=20_000, rng=0)
    np.testing.assert_allclose(noisy.x[..., 0].std(axis=0), [1, 0, 3], rtol=0.03)
    np.testing.assert_allclose((noisy.z - noisy.x)[..., 0].std(axis=0), np.sqrt([2, 1, 10]), rtol=0.03)


def test_start_and_noises_have_their_covariances():
    rng = np.random.default_rng(4)
    runs = 20_000
    model, start = random_model(rng, 2, 2), random_belief(rng, 2)
    data = simulate(model, start, 1, runs=runs, rng=5)
    x, error = data.x[:, 0], data.z[:, 0] - data.x[:, 0] @ model.H.T
    for found, mean, cov in (
        (x, model.F @ start.mean, model.F @ start.cov @ model.F.T + model.Q),
        (error, np.zeros(2), model.R),
    ):
        sigma = np.sqrt(np.diag(cov))
        assert (abs(found.mean(axis=0) - mean) < 4 * sigma / np.sqrt(runs)).all()
        assert (abs(np.cov(found.T) - cov) < 6 * np.outer(sigma, sigma) / np.sqrt(runs)).all()
    assert (abs(np.corrcoef(x.T, error.T)[:2, 2:]) < 4 / np.sqrt(runs)).all()


def test_noises_of_each_run_have_their_covariances():
    Q = np.stack([random_covariance(np.random.default_rng(k), 2) for k in range(2)])
    model = random_walk(np.eye(2), np.eye(2)).replace(Q=Q[:, None], R=Q[:, None])
    data = simulate(model, [0, 0], 8000, runs=2, rng=6)
    for run in range(2):
        sigma = np.sqrt(np.diag(Q[run]))
        for noise in (np.diff(data.x[run], axis=0), data.z[run] - data.x[run]):
            assert (abs(np.cov(noise.T) - Q[run]) < 6 * np.outer(sigma, sigma) / np.sqrt(8000)).all()


def test_noise_along_one_direction_only():
    push = np.array([[0.5], [1.0]])
    model = constant_velocity(1, 1, 1)  # Q = ΓΓᵀ is singular
    x = simulate(model, [0, 0], 50, rng=7).x
    noise = x[1:] - x[:-1] @ model.F.T
    np.testing.assert_allclose(noise[:, 0], noise[:, 1] * push[0], atol=1e-6)
    assert noise[:, 1].std() > 0.5


def test_nonlinear_models_run_too():
    rng = np.random.default_rng(8)
    model = random_model(rng, 3, 2, p=1)
    u, start = rng.normal(size=(6, 1)), random_belief(rng, 3)
    linear, dressed = (simulate(kind, start, 6, u, runs=4, rng=9) for kind in (model, as_nonlinear(model)))
    np.testing.assert_allclose(dressed.x, linear.x)
    np.testing.assert_allclose(dressed.z, linear.z)


@pytest.mark.parametrize("runs", [None, 2])
def test_the_start_is_not_changed(runs):
    start = np.array([1.0, 2.0])
    simulate(cart(1, 1, np.eye(2), 1), start, 3, runs=runs, rng=0)
    np.testing.assert_array_equal(start, [1, 2])
