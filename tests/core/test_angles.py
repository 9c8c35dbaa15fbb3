"""Angles that wrap around, right up to the edges."""

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from kflearn import angle_difference, circular_mean, wrap

PERIODS = st.sampled_from([360.0, 2 * np.pi, 400.0, 24.0, 1.0, 6400.0]) | st.floats(1e-3, 1e6)
ANGLES = st.floats(-1e6, 1e6)


@given(ANGLES, PERIODS)
@example(np.nextafter(-np.pi, -9), 2 * np.pi)
@example(-180.0, 360.0)
@example(180.0, 360.0)
@example(-180.00000000000003, 360.0)
@example(-5e-324, 360.0)
def test_wrap_stays_below_half_a_turn(angle, period):
    found = wrap(angle, period)
    assert -period / 2 <= found < period / 2
    turns = (angle - found) / period
    assert abs(turns - np.round(turns)) < 1e-9 * max(1, abs(angle) / period)


@given(ANGLES, ANGLES, PERIODS)
def test_the_difference_leads_from_one_to_the_other(angle, other, period):
    turns = (other + angle_difference(angle, other, period) - angle) / period
    assert abs(turns - np.round(turns)) < 1e-9 * max(1, abs(angle) / period, abs(other) / period)


@given(st.lists(ANGLES, min_size=1, max_size=9), PERIODS)
@example([350, 10], 360.0)
@example([-1e-20], 360.0)
@example([np.nextafter(0, -1)], 2 * np.pi)
def test_the_mean_lies_from_0_to_a_turn(angles, period):
    assert 0 <= circular_mean(angles, period=period) < period


def test_the_mean_across_north():
    assert circular_mean([350, 10]) == 0
    assert circular_mean([-1e-20]) == 0
    np.testing.assert_allclose(circular_mean([350, 20, 5]), 5)
    np.testing.assert_allclose(circular_mean([[359, 1], [90, 92]], axis=1), [0, 91], atol=1e-12)


@pytest.mark.parametrize("function", [wrap, circular_mean])
def test_nan_stays_nan(function):
    assert np.isnan(function(np.nan))


def test_shapes_and_kinds():
    assert isinstance(wrap(190), float) and isinstance(circular_mean([1, 2]), float)
    assert wrap([190, 10]).shape == (2,) and wrap(np.zeros((3, 2))).shape == (3, 2)
    assert angle_difference(np.zeros((3, 1)), np.ones(2)).shape == (3, 2)
    np.testing.assert_array_equal(angle_difference([3, 358], [358, 3]), [5, -5])
