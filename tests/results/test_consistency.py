import numpy as np
import pytest
from scipy import stats

from kflearn import (
    Gaussian,
    chi_square_interval,
    constant_velocity,
    coverage,
    kalman_filter,
    mmae_filter,
    nees,
    nis,
    random_walk,
    rmse,
    simulate,
    whiteness,
)
from kflearn.models.gaussian import unchecked_gaussian
from tests.helpers import random_covariance, with_gaps

MODEL, START, RUNS, T = constant_velocity(1, 0.5, 2), Gaussian([0, 0], np.diag([4.0, 1.0])), 60, 80


@pytest.fixture(scope="module")
def data():
    return simulate(MODEL, START, T, runs=RUNS, rng=2)


def test_rmse():
    estimate, truth = np.array([[[1.0, 2], [3, 4]], [[5, 6], [7, 8]]]), np.zeros((2, 2))
    assert rmse(estimate, truth) == pytest.approx(np.sqrt(204 / 8))
    np.testing.assert_allclose(rmse(estimate, truth, axis=(0, 1)), np.sqrt([84 / 4, 120 / 4]))
    np.testing.assert_allclose(rmse(estimate, truth, axis=0), np.sqrt([[13, 20], [29, 40]]))
    assert rmse([1, 2], 0) == pytest.approx(np.sqrt(2.5))
    assert rmse(truth, estimate) == rmse(estimate, truth)


def test_nees_is_the_squared_distance_in_standard_deviations():
    rng = np.random.default_rng(0)
    P = np.stack([random_covariance(rng, 3) for _ in range(5)])
    belief, truth = Gaussian(rng.normal(size=(4, 5, 3)), P), rng.normal(size=(4, 5, 3))
    error = truth - belief.mean
    np.testing.assert_allclose(nees(belief, truth), np.einsum("rki,kij,rkj->rk", error, np.linalg.inv(P), error))
    assert nees(Gaussian([1.0, 2.0], np.diag([4, 9])), [3, 5]) == pytest.approx(2)
    one = Gaussian(belief.mean[0], P)  # one belief, many truths
    np.testing.assert_allclose(nees(one, truth)[0], nees(Gaussian(belief.mean[0], P), truth[0]))


def test_nis_is_the_tracks_own(data):
    track = kalman_filter(MODEL, data.z, START)
    assert nis(track) is track.nis


@pytest.mark.parametrize("dof", [1, 2, 6])
@pytest.mark.parametrize("runs", [1, 50, 4000])
@pytest.mark.parametrize("probability", [0.5, 0.95, 0.999])
def test_chi_square_interval_against_scipy(dof, runs, probability):
    tail = (1 - probability) / 2
    expected = stats.chi2.ppf([tail, 1 - tail], dof * runs) / runs
    np.testing.assert_allclose(chi_square_interval(dof, runs, probability), expected, rtol=1e-10)


def test_published_chi_square_intervals():
    # Bar-Shalom et al. 2001, section 5.4.3: 50 runs of 2 states, 95 %: [1.5, 2.6].
    np.testing.assert_allclose(chi_square_interval(2, 50), [1.5, 2.6], atol=0.02)
    low, high = chi_square_interval(1)
    assert isinstance(low, float)
    assert (low, high) == pytest.approx((0.000982, 5.0239), rel=1e-3)


def test_an_honest_filter_passes_both_tests(data):
    track = kalman_filter(MODEL, data.z, START)
    low, high = chi_square_interval(1, RUNS * T)
    assert low < nis(track).mean() < high
    # The NEES of successive steps are not independent: judge each step over the runs, 95 of 100 must pass.
    low, high = chi_square_interval(2, RUNS)
    mean = nees(track, data.x).mean(axis=0)
    assert 0.88 < np.mean((low < mean) & (mean < high)) <= 1


@pytest.mark.parametrize(("factor", "too"), [(0.25, "high"), (4, "low")])
def test_a_wrong_noise_variance_fails_both_tests(data, factor, too):
    # R too small makes a filter too sure of itself, R too large too modest: the interval has two sides.
    track = kalman_filter(MODEL.replace(R=factor * MODEL.R), data.z, START)
    low, high = chi_square_interval(1, RUNS * T)
    assert nis(track).mean() > 1.2 * high if too == "high" else nis(track).mean() < 0.8 * low
    low, high = chi_square_interval(2, RUNS)
    mean = nees(track, data.x)[:, 10:].mean(axis=0)
    outside = mean > high if too == "high" else mean < low
    assert outside.mean() > 0.7


def test_coverage(data):
    track = kalman_filter(MODEL, data.z, START)
    for sigmas, share in ((1, 0.6827), (2, 0.9545), (3, 0.9973)):
        np.testing.assert_allclose(coverage(track, data.x, sigmas), [share, share], atol=0.03)
    sure = kalman_filter(MODEL.replace(R=MODEL.R / 100), data.z, START)
    assert coverage(sure, data.x)[0] < 0.7


def test_coverage_counts():
    belief = Gaussian(np.zeros((4, 2)), np.diag([1.0, 4.0]))
    truth = [[0, 5], [1.9, 3.9], [2.1, -3.9], [-2.1, -4.1]]
    np.testing.assert_array_equal(coverage(belief, truth), [0.5, 0.5])
    np.testing.assert_array_equal(coverage(belief, truth, sigmas=3), [1, 1])
    one = Gaussian([0.0, 0.0], np.diag([1.0, 4.0]))  # one belief, many truths
    np.testing.assert_array_equal(coverage(one, truth), [0.5, 0.5])


def test_whiteness_is_the_autocorrelation():
    rng = np.random.default_rng(1)
    y = rng.normal(size=(3, 50, 2))
    belief = Gaussian(y * [2, 5], np.diag([4.0, 25.0]))
    found = whiteness(belief, lags=4)
    assert found.shape == (4, 2)
    for lag in range(1, 5):
        expected = np.mean(y[:, lag:] * y[:, :-lag], axis=(0, 1)) / np.mean(y**2, axis=(0, 1))
        np.testing.assert_allclose(found[lag - 1], expected)
    assert whiteness(belief).shape == (20, 2)


def test_innovations_are_white_only_when_the_model_is_right(data):
    lags = np.arange(1, 21)
    bound = 1.96 / np.sqrt(RUNS * (T - lags))
    right = whiteness(kalman_filter(MODEL, data.z, START).innovation)[:, 0]
    assert np.mean(abs(right) < bound) >= 0.85
    sluggish = kalman_filter(MODEL.replace(Q=MODEL.Q / 100), data.z, START)
    assert whiteness(sluggish.innovation)[0, 0] > 10 * bound[0]
    nervous = kalman_filter(MODEL.replace(Q=MODEL.Q * 100), data.z, START)
    assert whiteness(nervous.innovation)[0, 0] < -5 * bound[0]


def test_bounds_of_whiteness_hold_in_95_of_100_cases():
    y = np.random.default_rng(3).normal(size=(400, 100, 1))
    outside = [abs(whiteness(Gaussian(run, 1), lags=5)[:, 0]) > 1.96 / np.sqrt(100 - np.arange(1, 6)) for run in y]
    assert 0.03 < np.mean(outside) < 0.06


def test_whiteness_takes_the_track(data):
    track = kalman_filter(MODEL, data.z, START)
    np.testing.assert_array_equal(whiteness(track, 3), whiteness(track.innovation, 3))
    assert abs(whiteness(track, 3)).max() < 0.1  # not the autocorrelation of the state's mean, which is near 1


def test_whiteness_with_gaps_is_that_of_the_pairs_that_are_there():
    rng = np.random.default_rng(4)
    y = with_gaps(rng, rng.normal(size=(3, 50, 2)))
    found = whiteness(unchecked_gaussian(y * [2, 5], np.diag([4.0, 25.0])), lags=4)
    for lag in range(1, 5):
        for i in range(2):
            pairs = [(b, a) for run in y[..., i] for b, a in zip(run[lag:], run, strict=False)]
            products = [b * a for b, a in pairs if not np.isnan(b * a)]
            power = np.mean([v**2 for v in y[..., i].ravel() if not np.isnan(v)])
            np.testing.assert_allclose(found[lag - 1, i], np.mean(products) / power)


def test_without_gaps_whiteness_is_the_plain_mean_to_the_last_bit(data):
    innovation = kalman_filter(MODEL, data.z, START).innovation
    y = innovation.mean / innovation.std
    expected = np.mean(y[..., 3:, :] * y[..., :-3, :], axis=(0, 1)) / np.mean(y**2, axis=(0, 1))
    np.testing.assert_array_equal(whiteness(innovation, 3)[2], expected)


def test_gaps_do_not_make_white_innovations_coloured(data):
    z = with_gaps(np.random.default_rng(6), data.z)
    track = kalman_filter(MODEL, z, START)
    assert abs(whiteness(track, 5)).max() < 4 / np.sqrt(RUNS * T * 0.49)
    z[:, ::2] = np.nan  # neighbours are never both there
    found = whiteness(kalman_filter(MODEL, z, START), 2)
    assert np.isnan(found[0])
    assert np.isfinite(found[1])


def test_tracks_of_several_models_have_no_innovations_of_their_own(data):
    track = mmae_filter([MODEL, MODEL], data.z, START)
    with pytest.raises(TypeError, match="track must have innovations"):
        whiteness(track)
    with pytest.raises(TypeError, match="track must be what a filter returns"):
        nis(track)
    assert nees(track, data.x).shape == (RUNS, T)


@pytest.mark.parametrize("runs", [(), (5,)])
def test_one_state_needs_no_axis_of_its_own(runs):
    rng = np.random.default_rng(7)
    track = kalman_filter(random_walk(1, 1), rng.normal(size=(*runs, 9, 1)), Gaussian(0, 1))
    x = rng.normal(size=(*runs, 9))
    np.testing.assert_array_equal(nees(track, x), nees(track, x[..., None]))
    np.testing.assert_array_equal(coverage(track, x), coverage(track, x[..., None]))
    assert rmse(track.mean, x) == rmse(x, track.mean) == rmse(track.mean, x[..., None])
    for measure in (nees, coverage, lambda track, x: rmse(track.mean, x)):
        with pytest.raises(ValueError, match="truth must"):
            measure(track, x[..., :-1])


def test_run_by_run_is_what_it_looks_like(data):
    """Case api/03: what a learner writes must not depend on whether a reading is missing."""
    z = data.z.copy()
    for gap in (False, True):
        if gap:
            z[2, 10] = np.nan
        track = kalman_filter(MODEL, z, START)
        inside = [(abs(x - m) <= 2 * s).mean(axis=0) for x, m, s in zip(data.x, track.mean, track.std, strict=True)]
        np.testing.assert_allclose(np.mean(inside, axis=0), coverage(track, data.x))
