"""Scans: rates, places, order; gates against plain formulas."""

import numpy as np
import pytest
from scipy.stats import chi2, kstest, multivariate_normal

from kflearn import Gaussian, LinearModel, kalman_filter, pair_up, random_walk, scan_targets
from tests.helpers import close, random_belief, random_model
from tests.targets.scenes import AREA, PLANE, one_target

WALK = random_walk(0, 1)


def within(share, expected, count, sigmas=4):
    """Is a share of `count` independent events the expected one, but for chance?"""
    return abs(share - expected) < sigmas * np.sqrt(expected * (1 - expected) / count)


def test_rates_and_places():
    scans = scan_targets(WALK, np.zeros((20000, 2, 1)), 0.8, 0.03, [[-50, 50]], rng=1)
    assert all(within((scans.source == target).sum() / 20000, 0.8, 20000) for target in (0, 1))
    false = (scans.source == -1).sum(axis=-1)
    assert abs(false.mean() - 3) < 4 * np.sqrt(3 / 20000)
    assert abs(false.var() - 3) < 0.2  # of a Poisson number the variance is its mean
    assert kstest(scans.z[scans.source == -1][:, 0], "uniform", (-50, 100)).pvalue > 1e-3
    assert kstest(scans.z[scans.source == 1][:, 0], "norm").pvalue > 1e-3


def test_the_order_says_nothing():
    scans = scan_targets(WALK, np.zeros((20000, 2, 1)), 1.0, 0.02, [[-50, 50]], rng=2)
    place = (scans.source == 0).argmax(axis=-1)
    first = place < (scans.source == 1).argmax(axis=-1)
    assert within(first.mean(), 0.5, 20000)
    count = (scans.source > -2).sum(axis=-1)
    assert abs((place - (count - 1) / 2).mean()) < 0.05


def test_rows_without_a_reading_come_last_and_are_nan():
    _, scans = one_target(20)
    none = scans.source == -2
    assert (np.diff(none.astype(int), axis=-1) >= 0).all()
    np.testing.assert_array_equal(np.isnan(scans.z), np.broadcast_to(none[..., None], scans.z.shape))
    assert not none.all(axis=(0, 1)).any()  # as few rows as possible


def test_a_target_that_is_not_there_gives_no_reading():
    x = np.zeros((30, 2, 1))
    x[:10, 1] = np.nan
    scans = scan_targets(WALK, x, 1.0, 0.0, [[-5, 5]], rng=0)
    np.testing.assert_array_equal((scans.source == 1).any(axis=-1), np.arange(30) >= 10)
    assert scans.z.shape == (30, 2, 1)


def test_the_readings_of_one_target():
    x, scans = one_target(50, detection=0.7)
    z = scans.of(0)
    assert within(np.isnan(z[..., 0]).mean(), 0.3, 1500)
    error = (z - x[..., [0, 2]])[~np.isnan(z)]
    assert abs(error.std() - 2) < 0.1
    track = kalman_filter(PLANE, z, Gaussian([0, 3, 0, 1], np.diag([25, 1, 25, 1])))
    assert np.isfinite(track.mean).all()


@pytest.mark.parametrize("m", [1, 2, 3])
def test_pairs_against_plain_formulas(m):
    rng = np.random.default_rng(m)
    model, belief, z = random_model(rng, 4, m), random_belief(rng, 4), 2 * rng.normal(size=(7, m))
    z[3] = np.nan
    pairs = pair_up(model, belief, z, gate=0.9)
    H, P = model.H, belief.cov
    S = H @ P @ H.T + model.R
    y = z - H @ belief.mean
    close(pairs.S, S, 1e-12)
    for j, row in enumerate(y):
        if j == 3:
            assert np.isnan(pairs.nis[j]) and not pairs.inside[j]
            assert np.isneginf(pairs.log_ratio(0.8, 0.1)[j])
        else:
            nis = row @ np.linalg.inv(S) @ row
            close(pairs.nis[j], nis, 1e-9)
            assert pairs.inside[j] == (nis <= chi2.ppf(0.9, m))
            ratio = multivariate_normal(np.zeros(m), S).pdf(row) * 0.8 / (0.1 * (1 - 0.8 * 0.9))
            close(pairs.log_ratio(0.8, 0.1)[j], np.log(ratio) if pairs.inside[j] else -np.inf, 1e-9)
    K = P @ H.T @ np.linalg.inv(S)
    close(pairs.gain, K, 1e-9)
    close(pairs.corrected, P - K @ S @ K.T, 1e-9)


@pytest.mark.parametrize("m", [1, 2, 3])
def test_the_volume_by_counting(m):
    """Uniform points in a box: the share inside the gate times the volume of the box."""
    rng = np.random.default_rng(m)
    S = np.diag([1.0, 4.0, 9.0][:m]) + 0.3
    model = LinearModel(np.eye(m), np.eye(m), np.eye(m), S)
    half = 4.2 * np.sqrt(np.diag(S))
    z = rng.uniform(-half, half, (200000, m))
    pairs = pair_up(model, Gaussian(np.zeros(m), np.zeros((m, m))), z, gate=0.95)
    box = np.prod(2 * half)
    share = pairs.inside.mean()
    assert abs(share - pairs.volume / box) < 4 * np.sqrt(share / 200000)


def test_the_gate_holds_its_share():
    rng = np.random.default_rng(0)
    z = rng.normal(0, np.sqrt(25), (20000, 1))
    assert within(pair_up(random_walk(0, 9), Gaussian(0, 16), z, gate=0.9).inside.mean(), 0.9, 20000)


@pytest.mark.parametrize(
    "changed, words",
    [
        (dict(x=np.zeros((5, 1))), r"x must have shape \(any, any, 1\)"),
        (dict(detection=1.2), "detection must be a probability from 0 to 1"),
        (dict(clutter=-1), "clutter must be at least 0"),
        (dict(region=[[5, -5]]), "region must have a lower end below the upper end"),
        (dict(region=[-5, 5]), r"region must have shape \(1, 2\)"),
    ],
)
def test_bad_scenes(changed, words):
    good = dict(model=WALK, x=np.zeros((5, 1, 1)), detection=0.9, clutter=0.1, region=[[-5, 5]])
    with pytest.raises(ValueError, match=words):
        scan_targets(**(good | changed))


def test_bad_pairs():
    with pytest.raises(ValueError, match="z must have whole readings"):
        pair_up(PLANE, Gaussian(np.zeros(4), np.eye(4)), [[1.0, np.nan]])
    with pytest.raises(ValueError, match="gate must be a probability between 0 and 1"):
        pair_up(WALK, Gaussian(0, 1), [[1.0]], gate=1.5)
    with pytest.raises(ValueError, match="got None"):
        pair_up(WALK, Gaussian(0, 1), [[1.0]], gate=None)
    with pytest.raises(ValueError, match=r"z must have shape \(any, 1\)"):
        pair_up(WALK, Gaussian(0, 1), [1.0, 2.0])


def test_seeds():
    first, again = (one_target(3, rng=5)[1] for _ in range(2))
    np.testing.assert_array_equal(first.z, again.z)
    assert AREA[0][0] <= np.nanmin(first.z[first.source == -1]) < np.nanmax(first.z) <= AREA[0][1] + 50
