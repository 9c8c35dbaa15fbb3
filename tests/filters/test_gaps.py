"""Gaps: each distinct gain is computed once, and the numbers are those of the plain loop."""

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    LinearModel,
    constant_velocity,
    kalman_filter,
    rts_smoother,
    scenarios,
    schmidt_kalman_filter,
    square_root_kalman_filter,
    two_filter_smoother,
)
from kflearn.filters import linear

MODEL, START = constant_velocity(1.0, 1.0, 1.0), Gaussian([0, 0], 10 * np.eye(2))


def readings(T, *gaps):
    z = np.cumsum(np.random.default_rng(0).normal(size=T))
    z[list(gaps)] = np.nan
    return z


@pytest.mark.parametrize(
    ("name", "gaps", "most"),
    [
        ("none", [], 60),
        ("one", [9000], 120),
        ("at both ends", [0, 1, 2, 19_998, 19_999], 120),
        ("three far apart", [3000, 9000, 15_000], 120),
        ("every second", range(0, 20_000, 2), 300),
        ("every tenth", range(5, 20_000, 10), 500),
        ("all but every hundredth", [k for k in range(20_000) if k % 100], 10_000),
    ],
)
@pytest.mark.parametrize("filter_", [kalman_filter, square_root_kalman_filter])
def test_few_gains_are_computed(filter_, name, gaps, most):
    track = filter_(MODEL, readings(20_000, *gaps), START)
    assert len(track._later.plan.parts.cov) <= most


def plainly(monkeypatch, filter_, model, z, start):
    """The same filter with every step computed anew."""
    with monkeypatch.context() as patch:
        patch.setattr(linear, "_distinct_steps", lambda *arguments: None)
        return filter_(model, z, start)


def agree(track, plain):
    assert plain._later.plan.index is None
    for name in ("mean", "cov", "gain", "nis"):
        found, expected = getattr(track, name), getattr(plain, name)
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-11 * np.nanmax(abs(expected)), err_msg=name)
    np.testing.assert_allclose(track.innovation.cov, plain.innovation.cov, rtol=1e-9)
    np.testing.assert_allclose(track.predicted.cov, plain.predicted.cov, rtol=1e-9)
    np.testing.assert_allclose(track.log_likelihood, plain.log_likelihood, rtol=1e-10)


@pytest.mark.parametrize("filter_", [kalman_filter, square_root_kalman_filter, schmidt_kalman_filter])
@pytest.mark.parametrize("share", [0.002, 0.05, 0.6])
def test_one_series_is_as_from_the_plain_loop(monkeypatch, filter_, share):
    z = readings(2000, *np.flatnonzero(np.random.default_rng(1).random(2000) < share))
    agree(filter_(MODEL, z, START), plainly(monkeypatch, filter_, MODEL, z, START))


@pytest.mark.parametrize("filter_", [kalman_filter, square_root_kalman_filter])
@pytest.mark.parametrize("share", [0.01, 0.6])
def test_long_series_with_many_gaps_in_blocks_are_as_from_the_plain_loop(monkeypatch, filter_, share):
    z = readings(6000, *np.flatnonzero(np.random.default_rng(1).random(6000) < share))
    track = filter_(MODEL, z, START)
    agree(track, plainly(monkeypatch, filter_, MODEL, z, START))
    assert (track._later.plan.index is None) == (share == 0.6)  # in blocks each step has its own row
    smooth, two = rts_smoother(MODEL, track), two_filter_smoother(MODEL, z, START)
    each = rts_smoother(MODEL.replace(R=MODEL.R), track)
    for other in (two, each):
        np.testing.assert_allclose(smooth.mean, other.mean, rtol=1e-9, atol=1e-8)
        np.testing.assert_allclose(smooth.cov, other.cov, rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("share", [0.003, 0.05])
def test_many_runs_with_their_own_gaps_are_as_from_the_plain_loop(monkeypatch, share):
    scene, rng = scenarios.ship(), np.random.default_rng(2)
    z = scene.simulate(30, rng=0).z
    z[rng.random(z.shape) < share] = np.nan
    track = kalman_filter(scene.model, z, scene.initial)
    agree(track, plainly(monkeypatch, kalman_filter, scene.model, z, scene.initial))
    assert (track._later.plan.index is None) == (share > 0.02)


def test_matrices_given_once_for_each_step_count_as_one_where_they_are_alike():
    z, T = readings(5000, 100, 200), 5000
    plain = kalman_filter(MODEL, z, START)
    stacked = kalman_filter(MODEL.replace(Q=np.broadcast_to(MODEL.Q, (T, 2, 2))), z, START)
    np.testing.assert_allclose(stacked.mean, plain.mean, rtol=1e-12, atol=1e-10)
    assert len(stacked._later.plan.parts.cov) < 200
    steps = [constant_velocity(dt, 1.0, 1.0) for dt in (0.5, 2.0)] * (T // 2)
    uneven = LinearModel(*(np.stack([getattr(model, name) for model in steps]) for name in "FHQR"))
    track = kalman_filter(uneven, z, START)
    assert len(track._later.plan.parts.cov) < 500
    one = Gaussian(START.mean, START.cov)
    for k in range(300):
        one = kalman_filter(steps[k], z[k : k + 1], one)[-1]
        np.testing.assert_allclose(track.mean[k], one.mean, rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose(track.cov[k], one.cov, rtol=1e-9)


@pytest.mark.parametrize("gaps", [[], [700], range(0, 1500, 40)])
def test_smoothers_share_as_much(gaps):
    z = readings(1500, *gaps)
    track = kalman_filter(MODEL, z, START)
    smooth, two = rts_smoother(MODEL, track), two_filter_smoother(MODEL, z, START)
    each = rts_smoother(MODEL.replace(R=MODEL.R), track)  # another model: every step on its own
    for other in (two, each):
        np.testing.assert_allclose(smooth.mean, other.mean, rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose(smooth.cov, other.cov, rtol=1e-9, atol=1e-13)
