"""The square-root filter: the Kalman filter's numbers, in single precision too, where the other forms break."""

import numpy as np
import pytest

from kflearn import Gaussian, LinearModel, kalman_filter, random_walk, scenarios, square_root_kalman_filter
from kflearn.core.conditioning import covariance_after
from kflearn.filters.square_root import square_root_step, triangular
from tests.helpers import random_belief, random_model, same_track, with_gaps

train = scenarios.train().model


@pytest.mark.parametrize("seed", range(50))
def test_it_is_the_kalman_filter(seed):
    rng = np.random.default_rng(seed)
    n, m, p = rng.integers(1, 6), rng.integers(1, 4), seed % 2
    model, initial = random_model(rng, n, m, p, 20 if seed % 3 else None), random_belief(rng, n)
    z, u = rng.normal(size=(3, 20, m)), rng.normal(size=(20, p)) if p else None
    z = with_gaps(rng, z) if seed % 5 else z
    same_track(square_root_kalman_filter(model, z, initial, u), kalman_filter(model, z, initial, u), 1e-10)


def test_singular_covariances():
    model = train.replace(Q=np.diag([4.0, 0.0]))
    initial, z = Gaussian([50, 10], np.diag([1.0, 0.0])), np.arange(60, 70.0)
    same_track(square_root_kalman_filter(model, z, initial), kalman_filter(model, z, initial), 1e-12)


def test_triangular_is_a_root():
    A = np.random.default_rng(0).normal(size=(5, 3, 7))
    L = triangular(A)
    np.testing.assert_allclose(L @ L.mT, A @ A.mT)
    np.testing.assert_array_equal(L, np.tril(L))


def corrected(form, P, H, R, gain):
    """The ways to write eq. (9); each keeps the precision of its arguments."""
    left = np.eye(len(P), dtype=P.dtype) - gain @ H
    if form == "Joseph":
        return left @ P @ left.T + gain @ R @ gain.T
    return left @ P if form == "plain" else (left @ P + (left @ P).T) / 2


def negative_steps(form, precision):
    """Steps in 100 with a negative eigenvalue (of the symmetric part), and the last P."""
    F, H, R, Q = (M.astype(precision) for M in (train.F, train.H, 1e-4 * np.eye(1), np.zeros((2, 2))))
    P = (1e6 * np.eye(2)).astype(precision)
    L, count = np.sqrt(P), 0
    for _ in range(100):
        if form == "square root":
            L, (_, _, _, P, *_) = square_root_step(L, F, H, Q, R)
        else:
            P = F @ P @ F.T
            P = corrected(form, P, H, R, P @ H.T / (H @ P @ H.T + R))
        count += np.linalg.eigvalsh((P + P.T).astype(float))[0] < 0
    assert P.dtype == precision
    return count, P


@pytest.mark.parametrize(
    ("form", "negative", "error"),
    [("plain", 99, None), ("symmetrised", 1, None), ("Joseph", 0, 0.03), ("square root", 0, 1e-5)],
)
def test_single_precision(form, negative, error):
    count, P = negative_steps(form, np.float32)
    assert count == negative
    if error is not None:
        np.testing.assert_allclose(P, negative_steps("Joseph", np.float64)[1], rtol=error)


@pytest.mark.parametrize("form", ["plain", "symmetrised", "Joseph", "square root"])
def test_double_precision_is_enough_here(form):
    count, P = negative_steps(form, np.float64)
    assert count == 0
    model = LinearModel(train.F, train.H, train.Q, 1e-4)
    expected = square_root_kalman_filter(model, np.zeros(100), Gaussian([0, 0], 1e6 * np.eye(2))).cov[-1]
    np.testing.assert_allclose(P, expected, rtol=1e-6)


def test_a_wrong_gain_and_what_the_forms_claim():
    P, H, R = np.array([[2, 0.5], [0.5, 1]]), np.array([[1.0, 0]]), np.eye(1)
    half = P @ H.T / 3 / 2
    np.testing.assert_allclose(np.diag(corrected("plain", P, H, R, half)), [4 / 3, 0.95833], atol=1e-5)
    np.testing.assert_allclose(np.diag(corrected("Joseph", P, H, R, half)), [1.0, 0.9375])
    np.testing.assert_allclose(np.diag(covariance_after(half, P, H, R)), [1.0, 0.9375])
    # The truth, by sampling: errors of many estimates corrected with that gain.
    rng = np.random.default_rng(0)
    error = Gaussian([0, 0], P).sample(200_000, rng)
    after = error - (error @ H.T + rng.standard_normal((200_000, 1))) @ half.T
    np.testing.assert_allclose(after.var(axis=0), [1.0, 0.9375], rtol=0.01)


@pytest.mark.parametrize("ratio", [1e-8, 1e-16, 1e-28])
def test_no_digit_is_lost_where_R_is_far_below_P(ratio):
    R = 1e14 * ratio
    track = square_root_kalman_filter(random_walk(0, R), [3.0], Gaussian(0, 1e14))
    assert track.cov[0, 0, 0] == pytest.approx(R / (1 + ratio), rel=1e-12)
