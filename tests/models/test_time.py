"""Steps of any length: the ready-made models with one dt for each step, and Van Loan's method."""

import numpy as np
import pytest
from scipy.integrate import quad_vec
from scipy.linalg import expm

from kflearn import (
    Gaussian,
    cart,
    constant_acceleration,
    constant_velocity,
    discretise,
    kalman_filter,
    random_walk,
    singer,
    white_acceleration,
)
from tests.helpers import random_covariance, same_track, textbook

DT = np.array([0.3, 2.0, 0.7, 1e-3])
MODELS = {
    "random walk": lambda dt: random_walk(0.3, 2, dt=dt),
    "two walks": lambda dt: random_walk([[2, 1], [1, 3]], np.eye(2), dt=dt),
    "velocity": lambda dt: constant_velocity(dt, 0.4, 2),
    "white": lambda dt: white_acceleration(dt, 0.4, 2),
    "acceleration": lambda dt: constant_acceleration(dt, 0.4, 2),
    "singer": lambda dt: singer(dt, 0.2, 3, 2),
    "cart": lambda dt: cart(dt, 2.0, np.eye(2), 2),
}


@pytest.mark.parametrize("name", MODELS)
def test_one_dt_for_each_step_is_one_model_for_each_step(name):
    build = MODELS[name]
    many, single = build(DT), [build(dt) for dt in DT]
    for letter in "FQB":
        M = getattr(many, letter)
        if M is not None:
            each = np.stack([getattr(model, letter) for model in single])
            np.testing.assert_array_equal(np.broadcast_to(M, each.shape), each)
    grid = build(DT.reshape(2, 2))  # two series of two steps
    np.testing.assert_array_equal(np.broadcast_to(grid.F, (2, 2, many.n, many.n))[1, 1], single[3].F)


@pytest.mark.parametrize("name", sorted(MODELS.keys() - {"cart"}))
def test_a_step_of_no_time_changes_nothing(name):
    model = MODELS[name]([0.0, 1.0])
    Q = np.broadcast_to(model.Q, (2, model.n, model.n))
    np.testing.assert_array_equal(Q[0], np.zeros((model.n, model.n)))
    if model.F.ndim == 3:
        np.testing.assert_array_equal(model.F[0], np.eye(model.n))


def test_a_filter_with_uneven_steps():
    rng = np.random.default_rng(1)
    dt, z, start = rng.exponential(1, 40), rng.normal(0, 3, (40, 1)), Gaussian([1, 0], [[4, 1], [1, 2]])
    model = white_acceleration(dt, 0.4, 2)
    mean, cov, *_ = textbook(model.replace(H=np.stack([model.H] * 40), R=np.stack([model.R] * 40)), z, start)
    track = kalman_filter(model, z, start)
    np.testing.assert_allclose(track.mean, mean, rtol=0, atol=1e-10)
    np.testing.assert_allclose(track.cov, cov, rtol=0, atol=1e-10)


def test_short_steps_make_a_long_one_for_white_noise_only():
    start, nothing = Gaussian([0, 0], np.zeros((2, 2))), np.full((4, 1), np.nan)
    ends = {}
    for name in ("white", "velocity"):
        parts = kalman_filter(MODELS[name](DT), nothing, start).cov[-1]
        whole = kalman_filter(MODELS[name](DT.sum()), nothing[:1], start).cov[-1]
        ends[name] = abs(parts / whole - 1).max()
    assert ends["white"] < 1e-12
    assert ends["velocity"] > 0.3  # a push that is held is another push where steps are shorter


# ---- Van Loan


A, L = np.array([[0.0, 1.0], [0.0, 0.0]]), np.array([[0.0], [1.0]])


@pytest.mark.parametrize("dt", [0.1, 2.0, DT])
def test_the_three_Qs_of_lesson_1(dt):
    white = white_acceleration(dt, 0.7, 1)
    F, Q = discretise(A, L, 0.7, dt)
    np.testing.assert_allclose(F, white.F, rtol=0, atol=1e-14)
    np.testing.assert_allclose(Q, white.Q, rtol=1e-12, atol=1e-16)
    # Held: the acceleration is a third state that does not change during the step, with variance σ² at its start.
    held, (F, _) = constant_velocity(dt, 0.7, 1), discretise(np.eye(3, k=1), np.zeros((3, 1)), 0, dt)
    push = F[..., :2, 2:]
    np.testing.assert_allclose(push @ push.mT * 0.7**2, held.Q, rtol=1e-12, atol=1e-16)
    # Independent: position and velocity are pushed by noises of their own, and F = I while they act.
    _, Q = discretise(np.zeros((2, 2)), np.eye(2), np.diag([1 / 3, 1]), dt)
    np.testing.assert_allclose(Q, np.multiply.outer(dt, np.diag([1 / 3, 1])), rtol=1e-13)


@pytest.mark.parametrize("rate", [1e-5, 0.1, 2.0, 300.0])  # below, the closed form in `singer` loses digits
@pytest.mark.parametrize("dt", [0.01, 1.0, 20.0])
def test_singers_model(rate, dt):
    F, Q = discretise([[0, 1, 0], [0, 0, 1], [0, 0, -rate]], [[0], [0], [1]], 2 * rate * 9, dt)
    model = singer(dt, rate, 3, 1)
    scale = np.sqrt(np.diag(model.Q))
    np.testing.assert_allclose(F, model.F, rtol=1e-9, atol=1e-12)
    if rate * dt < 100:  # beyond, the quadrature of `singer` is the less exact one
        np.testing.assert_allclose(Q / np.outer(scale, scale), model.Q / np.outer(scale, scale), rtol=0, atol=1e-9)


@pytest.mark.parametrize("seed", range(6))
def test_random_models_against_quadrature(seed):
    rng = np.random.default_rng(seed)
    n, p, dt = rng.integers(1, 5), rng.integers(1, 3), rng.uniform(0.1, 3)
    A, L, q = rng.normal(size=(n, n)), rng.normal(size=(n, p)), random_covariance(rng, p)
    F, Q = discretise(A, L, q, dt)
    np.testing.assert_allclose(F, expm(A * dt), rtol=1e-10, atol=1e-12)
    inside = L @ q @ L.T
    right, _ = quad_vec(lambda t: expm(A * t) @ inside @ expm(A * t).T, 0, dt, epsabs=1e-12, epsrel=1e-12)
    np.testing.assert_allclose(Q, right, rtol=1e-10, atol=1e-12 * abs(right).max())


def test_a_fast_decay_does_not_overflow():
    """exp(−A dt), which stands in Van Loan's matrix, would be e^1000."""
    F, Q = discretise([[-1000.0]], [[1]], 2000, [1.0, 1e-3])
    np.testing.assert_allclose(Q[:, 0, 0], [1, 1 - np.exp(-2)], rtol=1e-12)
    np.testing.assert_allclose(F[1, 0, 0], np.exp(-1), rtol=1e-12)


@pytest.mark.parametrize("dt", [0, 0.0, [0.0, 0.0]])
def test_in_no_time_nothing_moves(dt):
    F, Q = discretise(A, L, 0.7, dt)
    assert F.shape == Q.shape == (*np.shape(dt), 2, 2)
    assert (np.eye(2) == F).all()
    assert not Q.any()


@pytest.mark.parametrize("unit", [1e-12, 1.0, 1e12])
def test_the_unit_does_not_matter(unit):
    Q = discretise(A, L, 0.7 * unit**2, 2.0).Q
    np.testing.assert_allclose(Q / unit**2, white_acceleration(2.0, 0.7, 1).Q, rtol=1e-12)


def test_equal_steps_are_one_step():
    z, start = np.arange(5.0), Gaussian([0, 0], np.eye(2))
    many, one = white_acceleration(np.full(5, 0.5), 0.3, 2), white_acceleration(0.5, 0.3, 2)
    same_track(kalman_filter(many, z, start), kalman_filter(one, z, start))
