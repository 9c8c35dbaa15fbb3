"""The pass in plain numbers beside the pass with matrices, which shares no line with it."""

import numpy as np
import pytest

from kflearn import LinearModel
from kflearn.fitting.many import Matrices, Start, forward
from kflearn.fitting.one import BLOCK, forward_of_one, is_one

RNG = np.random.default_rng(11)


def start(known, runs):
    """Nothing is known at the first step, or N(3, 2) one step before it."""
    if known:
        return Start(np.full((1, 1, 1, 1), 3.0), np.full((1, 1, 1, 1), 2.0), False)
    X = np.concatenate([RNG.normal(0, 5, (1, 1, 1, runs)), np.ones((1, 1, 1, runs))], axis=1)
    return Start(X, np.zeros((1, 1, 1, 1)), True)


@pytest.mark.parametrize("steps", [1, 2, BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK + 7])
@pytest.mark.parametrize("F", [1.0, -0.7])
@pytest.mark.parametrize("known", [False, True])
@pytest.mark.parametrize("gaps", ["none", "some", "whole steps"])
@pytest.mark.parametrize("pushed", [False, True])
def test_it_is_the_pass_with_matrices(steps, F, known, gaps, pushed):
    models, runs = 4, 5
    Q, R = np.exp(RNG.normal(0, 2, (2, 1, 1, 1, models, runs)))
    matrices = Matrices(np.full((1, 1, 1, 1, 1), F), np.full((1, 1, 1, 1, 1), -1.7), Q, R)
    z = RNG.normal(0, 3, (steps, 1, 1, runs))
    if gaps == "some":
        z[RNG.random(z.shape) < 0.3] = np.nan
    if gaps == "whole steps":
        z[::3] = np.nan
    push = RNG.normal(0, 1, (steps, 1, 1, 1)) if pushed else None
    begin = start(known, runs)
    one, other = forward_of_one(matrices, z, push, begin), forward(matrices, z, push, begin)
    np.testing.assert_allclose(one.gram, other.gram, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(one.log_det, other.log_det, rtol=1e-10, atol=1e-12)
    np.testing.assert_array_equal(np.broadcast_to(one.seen, (1, runs)), np.broadcast_to(other.seen, (1, runs)))


def test_what_is_no_number_is_minus_infinity_in_both():
    """Q and R of 0, and of −1: S is no variance."""
    Q, R = np.array([0.0, -1.0]).reshape(1, 1, 1, 2, 1), np.array([0.0, -1.0]).reshape(1, 1, 1, 2, 1)
    matrices, z = Matrices(np.ones((1,) * 5), np.ones((1,) * 5), Q, R), RNG.normal(0, 1, (6, 1, 1, 1))
    for run in (forward, forward_of_one):
        assert (run(matrices, z, None, start(True, 1)).log_likelihood()[1:] == -np.inf).all()
        assert (run(matrices, z, None, start(False, 1)).log_likelihood() == -np.inf).all()


@pytest.mark.parametrize(
    ("model", "is_it"),
    [
        (LinearModel(1, 1, 1, 1), True),
        (LinearModel(0.5, 2, 1, 1, B=[[1, 2]]), True),
        (LinearModel(1, 1, np.ones((3, 1, 1)), 1), False),
        (LinearModel(1, [[1], [1]], 1, np.eye(2)), False),
        (LinearModel(np.eye(2), [[1, 0]], np.eye(2), 1), False),
    ],
)
def test_which_models_are_one(model, is_it):
    assert is_one(Matrices.of(model, runs=2)) == is_it
