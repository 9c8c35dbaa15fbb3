"""Correlations, roots and products of covariances."""

import numpy as np
import pytest

from kflearn.core.matrices import congruence, correlations, root, symmetric
from tests.helpers import random_covariance


def test_correlations_do_not_depend_on_units():
    P = random_covariance(np.random.default_rng(0), 3)
    units = np.array([1e-9, 1.0, 1e9])
    one, sd = correlations(P)
    other, larger = correlations(P * units * units[:, None])
    np.testing.assert_allclose(one, other, rtol=1e-12)
    np.testing.assert_allclose(larger, sd * units)
    np.testing.assert_allclose(np.diag(one), 1)
    np.testing.assert_allclose(sd, np.sqrt(np.diag(P)))


def test_correlations_of_what_is_known_exactly():
    P = np.array([[4.0, 0, 0], [0, 0, 0], [0, 0, -1e-16]])
    found, scale = correlations(P)
    np.testing.assert_array_equal(scale, [2, 1, 1])
    np.testing.assert_array_equal(found, np.diag([1, 0, -1e-16]))
    np.testing.assert_array_equal(correlations(P, np.array([2.0, 2, 2]))[0], P / 4)


@pytest.mark.parametrize("batch", [(), (5,), (2, 3)])
def test_each_of_a_batch_alone(batch):
    rng = np.random.default_rng(1)
    A = rng.normal(size=(*batch, 3, 3))
    P = symmetric(A @ A.mT)
    for i in np.ndindex(batch):
        np.testing.assert_array_equal(correlations(P)[0][i], correlations(P[i])[0])
    np.testing.assert_allclose(root(P) @ root(P).mT, P, atol=1e-12)
    F = rng.normal(size=(2, 3))
    moved, cross = congruence(F, P)
    np.testing.assert_allclose(moved, F @ P @ F.T, atol=1e-12)
    np.testing.assert_allclose(cross, P @ F.T, atol=1e-12)


@pytest.mark.parametrize("rank", [1, 2])
def test_what_is_known_exactly_stays_so_in_a_root(rank):
    """The eigenvectors of its correlations are rounded; without care the second state got a deviation of 1e-8."""
    A = np.random.default_rng(0).normal(size=(4, rank))
    A[1] = 0
    for unit in (1e-12, 1.0, 1e12):
        P = unit**2 * A @ A.T
        L = root(P)
        assert not L[1].any()
        np.testing.assert_allclose(L @ L.T, P, atol=1e-14 * unit**2)
