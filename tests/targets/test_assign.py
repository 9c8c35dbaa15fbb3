"""Assignments and GOSPA against brute force over all permutations."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from kflearn import assign, gospa
from tests.helpers import close


def choices(M, N):
    """All ways to give M tracks one of N readings each, or none, no reading twice."""
    for choice in itertools.product(range(-1, N), repeat=M):
        given = [j for j in choice if j >= 0]
        if len(given) == len(set(given)):
            yield choice


def total(cost, choice, nothing):
    return sum(nothing if j < 0 else cost[i, j] for i, j in enumerate(choice))


costs = st.tuples(st.integers(1, 3), st.integers(1, 4)).flatmap(
    lambda shape: arrays.arrays(float, shape, elements=st.sampled_from([-2.0, 0.0, 0.5, 1.0, 3.0, 7.5, np.inf]))
)


@settings(max_examples=200, deadline=None)
@given(cost=costs, nothing=st.sampled_from([-1.0, 0.0, 2.0, 50.0]))
def test_the_sum_is_the_smallest_of_all(cost, nothing):
    found = assign(cost, nothing).tolist()
    assert found in [list(choice) for choice in choices(*cost.shape)]
    assert total(cost, found, nothing) == min(total(cost, choice, nothing) for choice in choices(*cost.shape))


def test_greedy_takes_the_cheapest_first():
    rng = np.random.default_rng(1)
    for _ in range(100):
        cost = rng.normal(size=rng.integers(1, 5, 2))  # no two alike
        wanted = [-1] * len(cost)
        for i, j in sorted(np.ndindex(cost.shape), key=lambda pair: cost[pair]):
            if cost[i, j] < 0.5 and wanted[i] < 0 and j not in wanted:
                wanted[i] = j
        assert assign(cost, 0.5, how="greedy").tolist() == wanted


@pytest.mark.parametrize("how", ["global", "greedy"])
def test_a_batch_is_each_scan_alone(how):
    rng = np.random.default_rng(0)
    cost = rng.normal(size=(5, 6, 4, 3))
    cost[rng.random(cost.shape) < 0.3] = np.inf
    found = assign(cost, 0.3, how)
    for place in np.ndindex(5, 6):
        np.testing.assert_array_equal(found[place], assign(cost[place], 0.3, how))


def test_greedy_can_be_worse():
    cost = [[1.0, 2.0], [2.0, 9.0]]
    assert assign(cost, 20).tolist() == [1, 0]  # 4
    assert assign(cost, 20, how="greedy").tolist() == [0, 1]  # 10


def test_the_array_is_not_changed():
    cost = np.array([[1.0, 2.0], [0.5, 9.0]])
    for how in ("global", "greedy"):
        assign(cost, 20, how)
    assert cost.tolist() == [[1, 2], [0.5, 9]]


@pytest.mark.parametrize(
    "cost, words", [([1.0], "must have shape"), ([[np.nan]], "found NaN"), ([[-np.inf]], "found NaN or -inf")]
)
def test_bad_costs(cost, words):
    with pytest.raises(ValueError, match=words):
        assign(cost)


# ---- GOSPA


def by_brute_force(truth, estimates, c, p):
    """The definition: the minimum over all partial matches."""
    truth, estimates = (x[~np.isnan(x).any(axis=-1)] for x in (truth, estimates))
    best = np.inf
    for choice in choices(len(truth), len(estimates)):
        matched = sum(j >= 0 for j in choice)
        near = sum(np.linalg.norm(truth[i] - estimates[j]) ** p for i, j in enumerate(choice) if j >= 0)
        missed, false = c**p / 2 * (len(truth) - matched), c**p / 2 * (len(estimates) - matched)
        if near + missed + false < best - 1e-12:
            best, parts = near + missed + false, (near, missed, false)
    return best ** (1 / p), *parts


@pytest.mark.parametrize("p", [1, 2, 3])
def test_gospa_against_brute_force(p):
    rng = np.random.default_rng(p)
    truth, estimates = 8 * rng.random((40, 3, 2)), 8 * rng.random((40, 4, 2))
    truth[rng.random((40, 3)) < 0.3] = np.nan
    estimates[rng.random((40, 4)) < 0.3] = np.nan
    found = gospa(truth, estimates, 3.0, p)
    for i in range(40):
        wanted = by_brute_force(truth[i], estimates[i], 3.0, p)
        close([part[i] for part in found[:4]], wanted, 1e-12)


def test_gospa_is_a_distance():
    rng = np.random.default_rng(0)
    a, b, c = 6 * rng.random((3, 100, 3, 2))
    ab, ba, bc, ac = (gospa(*pair, 2.5).distance for pair in ((a, b), (b, a), (b, c), (a, c)))
    close(ab, ba, 1e-12)
    assert (ac <= ab + bc + 1e-12).all()
    assert (gospa(a, a, 2.5).distance == 0).all()
    assert (ab > 0).all()


def test_gospa_says_which_estimate_is_whose():
    found = gospa([[0.0], [10.0], [20.0]], [[10.5], [np.nan], [0.2]], 3)
    assert found.match.tolist() == [2, 0, -1]


def test_bad_gospa():
    with pytest.raises(ValueError, match="estimates must have 2 components"):
        gospa([[0.0, 0.0]], [[1.0]], 3)
    with pytest.raises(ValueError, match="cutoff must be positive"):
        gospa([[0.0]], [[1.0]], 0)
    with pytest.raises(ValueError, match="p must be at least 1"):
        gospa([[0.0]], [[1.0]], 1, p=0.5)
    with pytest.raises(ValueError, match="truth must have shape"):
        gospa([0.0], [[1.0]], 1)
