import numpy as np
import pytest

from kflearn import (
    Gaussian,
    constant_velocity,
    cubature_kalman_filter,
    extended_kalman_filter,
    kalman_filter,
    random_walk,
    unscented_kalman_filter,
)
from kflearn.core.conditioning import decouple_missing, divide, squared_distance
from tests.helpers import bent, close, random_belief, random_covariance, random_model, with_gaps

FILTERS = [kalman_filter, extended_kalman_filter, unscented_kalman_filter, cubature_kalman_filter]
every_filter = pytest.mark.parametrize("kf", FILTERS, ids=lambda f: f.__name__)


def some_track(kf, runs=(3,), gaps=True, steps=9):
    rng = np.random.default_rng(0)
    linear = random_model(rng, 3, 2, p=1)
    z, u = rng.normal(size=(*runs, steps, 2)), rng.normal(size=(steps, 1))
    z = with_gaps(rng, z) if gaps else z
    return linear, z, u, kf(linear if kf is kalman_filter else bent(linear), z, random_belief(rng, 3), u)


@every_filter
def test_shapes(kf):
    _, _, _, track = some_track(kf)
    assert track.mean.shape == track.predicted.mean.shape == track.std.shape == (3, 9, 3)
    assert track.cov.shape == track.predicted.cov.shape == (3, 9, 3, 3)
    assert track.gain.shape == (3, 9, 3, 2)
    assert track.innovation.mean.shape == (3, 9, 2)
    assert track.innovation.cov.shape == (3, 9, 2, 2)
    assert track.nis.shape == (3, 9)
    assert track.log_likelihood.shape == (3,)
    assert track.mean is track.filtered.mean
    assert track.cov is track.filtered.cov
    alone = some_track(kf, runs=())[3]
    assert alone.mean.shape == (9, 3)
    assert alone.log_likelihood.shape == ()


@every_filter
def test_what_is_worked_out_later_agrees_with_what_was_worked_out_first(kf):
    # The corrected mean is the predicted one plus gain times innovation, whatever is asked for first.
    linear, z, _, track = some_track(kf)
    step = np.einsum("...ij,...j->...i", track.gain, np.nan_to_num(track.innovation.mean))
    close(track.mean, track.predicted.mean + step)
    np.testing.assert_array_equal(np.isnan(track.innovation.mean), np.isnan(z))
    assert (track.gain[np.isnan(z)[..., None, :] & np.ones((3, 1), bool)] == 0).all()
    if kf is kalman_filter:
        close(track.innovation.mean, z - track.predicted.mean @ linear.H.T)
        close(track.innovation.cov, linear.H @ track.predicted.cov @ linear.H.T + linear.R)


@every_filter
def test_later_changes_of_the_callers_data_do_not_matter(kf):
    _, z, u, track = some_track(kf)
    _, _, _, expected = some_track(kf)
    z[:] = u[:] = 99
    close(track.predicted.mean, expected.predicted.mean)
    close(track.innovation.mean, expected.innovation.mean)
    close(track.log_likelihood, expected.log_likelihood)


@every_filter
@pytest.mark.parametrize("gaps", [True, False])
def test_a_track_is_read_only(kf, gaps):
    _, _, _, track = some_track(kf, gaps=gaps)
    arrays = [track.gain]
    for belief in (track.filtered, track.predicted, track.innovation):
        arrays += [belief.mean, belief.cov]
    for array in arrays:
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
    with pytest.raises(AttributeError):
        track.gain = 0


@every_filter
def test_worked_out_once(kf):
    _, _, _, track = some_track(kf)
    assert track.predicted is track.predicted
    assert track.innovation is track.innovation
    assert track.nis is track.nis


@every_filter
def test_nis_and_log_likelihood_by_their_definitions(kf):
    _, z, _, track = some_track(kf)
    S = track.innovation.cov
    total = np.zeros(3)
    for run, k in np.ndindex(z.shape[:2]):
        seen = ~np.isnan(z[run, k])
        if not seen.any():
            assert np.isnan(track.nis[run, k])
            continue
        y, part = track.innovation.mean[run, k][seen], S[run, k][np.ix_(seen, seen)]
        nis = y @ np.linalg.inv(part) @ y
        np.testing.assert_allclose(track.nis[run, k], nis, rtol=1e-9)
        total[run] -= 0.5 * (nis + np.log(np.linalg.det(2 * np.pi * part)))
    np.testing.assert_allclose(track.log_likelihood, total, rtol=1e-9)


def test_a_long_series_is_held_after_the_gain_has_converged():
    track = kalman_filter(constant_velocity(1, 0.1, 1), np.zeros(3000), Gaussian([0, 0], np.eye(2)))
    for array in (track.gain, track.cov, track.predicted.cov, track.innovation.cov):
        assert len(array) == 3000
        assert (array[500:] == array[-1]).all()
        assert (array[10] != array[-1]).any()


def test_a_track_shows_itself_in_a_line():
    _, _, _, track = some_track(kalman_filter)
    start = "Track(T=9 steps, n=3 states, m=2 measured, batch=(3,); first run ends with mean ["
    assert repr(track).startswith(start)
    one = kalman_filter(random_walk(0, 1), [1.0, 2.0, 3.0], Gaussian(0, 1e6))
    assert repr(one) == "Track(T=3 steps, n=1 states, m=1 measured; last mean [2], std [0.5774])"


@pytest.mark.parametrize("m", [1, 2, 3, 5])
def test_divide_solves(m):
    rng = np.random.default_rng(m)
    S = np.stack([random_covariance(rng, m) for _ in range(7)])
    C = rng.normal(size=(4, 7, 3, m))
    np.testing.assert_allclose(divide(C, S) @ S, C, atol=1e-10)
    lopsided = S + rng.normal(size=(m, m)) / 10
    np.testing.assert_allclose(divide(C, lopsided) @ lopsided, C, atol=1e-10)
    y = rng.normal(size=(4, 7, m))
    expected = np.einsum("...i,...ij,...j->...", y, np.linalg.inv(S), y)
    np.testing.assert_allclose(squared_distance(y, S), expected, rtol=1e-9)


def test_missing_components_become_independent():
    R = np.array([[2.0, 0.5, 0.1], [0.5, 3.0, 0.2], [0.1, 0.2, 4.0]])
    hidden = decouple_missing(R, np.array([[False, True, False], [False, False, False]]))
    np.testing.assert_array_equal(hidden[0], [[2, 0, 0.1], [0, 1, 0], [0.1, 0, 4]])
    np.testing.assert_array_equal(hidden[1], R)
