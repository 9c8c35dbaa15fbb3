"""Steps that depend on symbols alone: each distinct one is computed once, and nothing else changes."""

import numpy as np
import pytest

from kflearn.core.walk import Walk, same_covariance, walk, walk_in_blocks

RATES = np.array([0.5, 0.9, 1.0])


class Counted:
    """A recursion P → a² P + q with a of the symbol; its part tells where it came from. Counts what it computes."""

    def __init__(self):
        self.count = 0

    def __call__(self, P, symbol):
        self.count += np.size(symbol)
        a = RATES[symbol]
        after = a[..., None, None] ** 2 * P + (a[..., None, None] < 1)
        return after, (P + 0.0, after, None)


def plain(symbols, start):
    P, parts = start, []
    for symbol in symbols:
        P, part = Counted()(P, symbol)
        parts.append(part[:2])
    return [np.stack(part) for part in zip(*parts, strict=True)]


def agrees(symbols, most=None):
    step = Counted()
    plan = walk(symbols, np.array([[7.0]]), step, same_covariance)
    T = symbols.shape[-1]
    for i, run in enumerate(symbols.reshape(-1, T)):
        for part, expected in zip(plan.parts, plain(run, np.array([[7.0]])), strict=False):
            found = plan.each(part, T).reshape(-1, T, 1, 1)[i if symbols.ndim > 1 and plan.index is not None else 0]
            np.testing.assert_allclose(found, expected, rtol=1e-12)
    assert plan.parts[2] is None
    if most is not None:
        assert step.count <= most
    return plan


def test_one_symbol_comes_to_rest_and_needs_no_index():
    plan = agrees(np.zeros(10_000, int), most=40)
    assert plan.index is None
    np.testing.assert_array_equal(plan.rows(10_000)[-2:], len(plan.parts[0]) - 1)


def test_after_a_gap_it_is_picked_up_again():
    symbols = np.zeros(10_000, int)
    symbols[[3000, 7000]] = 2
    agrees(symbols, most=60)


@pytest.mark.parametrize("period", [2, 3, 4, 7, 20])
def test_a_cycle_is_found(period):
    symbols = np.zeros(5000, int)
    symbols[::period] = 1
    agrees(symbols, most=400)


def test_steps_that_end_alike_keep_their_own_parts():
    """After symbol 0 with a = 0 all ends are alike, wherever one came from."""

    def step(P, symbol):
        return np.ones((1, 1)), (P * 1.0,)

    plan = walk(np.zeros(9, int), np.array([[7.0]]), step, same_covariance)
    assert plan.each(plan.parts[0], 9)[:, 0, 0].tolist() == [7] + [1] * 8


def test_runs_differ_in_their_symbols():
    rng = np.random.default_rng(0)
    symbols = (rng.random((5, 300)) < 0.02).astype(int)
    agrees(symbols)
    agrees(symbols.reshape(5, 1, 300))
    agrees(rng.integers(0, 3, size=(4, 60)))


def test_growth_without_rest_is_followed_to_the_end():
    plan = agrees(np.full(300, 1), most=300)
    assert len(plan.parts[0]) <= 300


def test_the_last_row_serves_all_later_steps():
    rows = np.arange(6.0).reshape(3, 2, 1)
    plan = Walk((rows,))
    np.testing.assert_array_equal(plan.each(rows, 5)[:, :, 0], [[0, 1], [2, 3], [4, 5], [4, 5], [4, 5]])
    np.testing.assert_array_equal(Walk((rows,), np.array([2, 0])).each(rows, 2)[:, :, 0], [[4, 5], [0, 1]])


def test_blocks_side_by_side_are_the_same_series():
    symbols = (np.random.default_rng(4).random(5037) < 0.3).astype(int)
    start = np.array([[7.0]])
    plan = walk_in_blocks(symbols, start, np.array([[1000.0]]), Counted(), same_covariance)
    assert plan.index is None and len(plan.parts[0]) == 5037 and plan.parts[2] is None
    for part, expected in zip(plan.parts, plain(symbols, start), strict=False):
        np.testing.assert_allclose(part, expected, rtol=1e-12)


def test_blocks_that_would_not_forget_their_start_are_given_up():
    start = np.array([[7.0]])
    for symbols in (np.full(20_000, 2), np.where(np.arange(20_000) < 15_000, 0, 2), np.zeros(300, int)):
        assert walk_in_blocks(symbols, start, np.array([[9.0]]), Counted(), same_covariance) is None


def test_a_long_series_of_which_few_steps_are_alike_goes_in_blocks():
    symbols = np.random.default_rng(5).integers(0, 2, 8000)
    agrees(symbols, most=1100 + 8000 + 24 * 64 * 8)
    plan = walk(symbols, np.array([[7.0]]), Counted(), same_covariance)
    assert plan.index is None and len(plan.parts[0]) == 8000
    unforgetting = np.random.default_rng(6).integers(1, 3, 6000) * (np.arange(6000) < 20) + 2 * (np.arange(6000) >= 20)
    agrees(unforgetting)
