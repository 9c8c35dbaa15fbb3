"""The Cramér–Rao bound: the P of a linear filter; else the inverse of the information about a whole path."""

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    NonlinearModel,
    cramer_rao_bound,
    extended_kalman_filter,
    kalman_filter,
    linearized_kalman_filter,
    scenarios,
    simulate,
    white_acceleration,
)
from tests.helpers import as_nonlinear, bent, random_belief, random_model, with_gaps


@pytest.mark.parametrize("seed", range(6))
def test_of_a_linear_model_it_is_the_filters_P(seed):
    rng = np.random.default_rng(seed)
    n, m, T = rng.integers(1, 5), rng.integers(1, 4), 25
    model, start = random_model(rng, n, m, steps=T if seed % 2 else None), random_belief(rng, n)
    data = simulate(model, start, T, runs=3, rng=1)
    P = kalman_filter(model, data.z[0], start).cov
    for x in (data.x, data.x[0]):
        np.testing.assert_allclose(cramer_rao_bound(model, x, start), P, rtol=0, atol=1e-10 * abs(P).max())


@pytest.mark.parametrize("Q", [0.0, 0.4])
def test_with_a_singular_Q_and_known_states(Q):
    model, start = white_acceleration([0.0, 1.0, 0.2, 3.0], Q, 2), Gaussian([0, 1], [[4, 0], [0, 0]])
    x = simulate(model, start, 4, rng=1).x
    P = kalman_filter(model, x[:, :1], start).cov
    np.testing.assert_allclose(cramer_rao_bound(model, x, start), P, rtol=0, atol=1e-12)


def test_what_is_not_measured_tells_nothing():
    rng = np.random.default_rng(5)
    model, start = random_model(rng, 3, 2), random_belief(rng, 3)
    data = simulate(model, start, 30, rng=1)
    z = with_gaps(rng, data.z, 0.5)
    P = kalman_filter(model, z, start).cov
    np.testing.assert_allclose(cramer_rao_bound(model, data.x, start, z=z), P, rtol=0, atol=1e-10 * abs(P).max())


def test_a_linear_model_dressed_as_functions():
    rng = np.random.default_rng(1)
    model, start = random_model(rng, 3, 2), random_belief(rng, 3)
    x = simulate(model, start, 20, runs=5, rng=1).x
    plain = as_nonlinear(model)
    for other in (plain, NonlinearModel(plain.f, plain.h, plain.Q, plain.R)):  # with Jacobians, and without
        found = cramer_rao_bound(other, x, start)
        np.testing.assert_allclose(found, cramer_rao_bound(model, x, start), rtol=0, atol=1e-7)


def test_along_one_path_it_is_the_filter_with_slopes_at_the_truth():
    """As lesson 15 computes it for bearings; the mean information of many such paths is a far weaker bound."""
    scene = scenarios.bearings_only("honest start")
    x = scene.simulate(runs=40, rng=1).x
    best = linearized_kalman_filter(scene.model, np.zeros((40, x.shape[1], 1)), scene.initial, nominal=x).cov
    for run in range(3):
        found = cramer_rao_bound(scene.model, x[run], scene.initial)
        np.testing.assert_allclose(found, best[run], rtol=0, atol=1e-9 * abs(best[run]).max())
    mean = cramer_rao_bound(scene.model, x, scene.initial)[-1]
    assert np.trace(mean) < np.trace(best[:, -1].mean(axis=0)) / 1.2


def whole_path(model, x, start):
    """The last block of the inverse of the information about all states of a path, start included."""
    runs, T, n = x.shape
    J = np.zeros(((T + 1) * n, (T + 1) * n))
    J[:n, :n] = np.linalg.inv(start.cov)
    before = np.concatenate([np.broadcast_to(start.mean, (runs, 1, n)), x[:, :-1]], axis=1)
    for k in range(T):
        for r in range(runs):
            row = np.zeros((n, (T + 1) * n))
            row[:, k * n : (k + 1) * n] = -model.F_jacobian(before[r, k])
            row[:, (k + 1) * n : (k + 2) * n] = np.eye(n)
            J += row.T @ np.linalg.inv(model.Q) @ row / runs
            seen = np.zeros((model.m, (T + 1) * n))
            seen[:, (k + 1) * n : (k + 2) * n] = model.H_jacobian(x[r, k])
            J += seen.T @ np.linalg.inv(model.R) @ seen / runs
    return np.linalg.inv(J)[-n:, -n:]


@pytest.mark.parametrize("runs", [1, 7])
def test_a_nonlinear_model_against_the_information_of_the_whole_path(runs):
    rng = np.random.default_rng(2)
    model, start = bent(random_model(rng, 2, 1)), random_belief(rng, 2)
    x = simulate(model, start, 8, runs=runs, rng=3).x
    found = cramer_rao_bound(model, x, start)
    for T in (1, 4, 8):
        right = whole_path(model, x[:, :T], start)
        np.testing.assert_allclose(found[T - 1], right, rtol=0, atol=1e-10 * abs(right).max())


def test_no_filter_is_below_it_and_a_good_one_is_near():
    """The range to a sensor 50 m beside a straight path."""
    model = NonlinearModel(
        lambda x: np.stack([x[..., 0] + x[..., 1], x[..., 1]], axis=-1),
        lambda x: np.hypot(x[..., :1], 50),
        np.diag([0.01, 0.01]),
        1.0,
    )
    start = Gaussian([60.0, 2.0], np.diag([25.0, 0.25]))
    data = simulate(model, start, 30, runs=4000, rng=1)
    bound = np.sqrt(cramer_rao_bound(model, data.x, start)[:, 0, 0])
    off = (extended_kalman_filter(model, data.z, start).mean - data.x)[..., 0]
    error = np.sqrt(np.mean(off**2, axis=0))
    assert (error > bound * (1 - 4 / np.sqrt(2 * 4000))).all()  # four standard errors
    assert (error < 1.2 * bound).all()


GOOD = white_acceleration(1, 1, 1)
BENT = NonlinearModel(lambda x: x + 0.1 * np.sin(x), lambda x: x[..., :1], np.diag([1.0, 0.0]), 1)
START = Gaussian([0, 0], np.eye(2))
REFUSED = [
    (lambda: cramer_rao_bound(3, np.zeros((4, 2)), START), "model must be a LinearModel or a NonlinearModel, got int"),
    (lambda: cramer_rao_bound(GOOD, np.zeros((4, 3)), START), r"x must have shape \(any, 2\), got \(4, 3\)"),
    (lambda: cramer_rao_bound(GOOD, np.zeros((2, 2, 4, 2)), START), r"x must have shape \(T, 2\) or \(runs, T, 2\)"),
    (lambda: cramer_rao_bound(GOOD, np.zeros((4, 2)), Gaussian(0, 1)), "initial must have 2 components"),
    (lambda: cramer_rao_bound(GOOD, np.zeros((4, 2)), Gaussian([[0, 0]], np.eye(2))), "initial must be the same for"),
    (lambda: cramer_rao_bound(GOOD, np.full((4, 2), np.nan), START), "x must be finite, found nan"),
    (lambda: cramer_rao_bound(GOOD, np.zeros((4, 2)), START, z=np.zeros(3)), r"z must have shape \(4, 1\), got"),
    (lambda: cramer_rao_bound(BENT, np.arange(16.0).reshape(2, 4, 2), START), "Q must be positive definite where F"),
]


@pytest.mark.parametrize("call, sentence", REFUSED)
def test_bad_input_gets_one_sentence(call, sentence):
    with pytest.raises((ValueError, TypeError), match=sentence):
        call()
