"""The tracker: starts, confirmations and ends by counting; batches; rates with standard errors."""

import numpy as np
import pytest

from kflearn import Gaussian, correct, gospa, kalman_filter, random_walk, scan_targets, simulate, tracker, with_error
from tests.helpers import close
from tests.targets.scenes import AREA, PLANE

WALK, WIDE = random_walk(1, 9), Gaussian(0, 1e6)
SENSOR = dict(detection=0.9, clutter=1e-4)
BIRTH = Gaussian([100, 0, 50, 0], np.diag([1e8, 25, 1e8, 25]))
NONE = np.nan


def confirmed(*readings, **settings):
    """How many confirmed tracks after each scan, one reading a scan at most."""
    z = np.array(readings, float)[:, None, None]
    return tracker(WALK, z, WIDE, **(SENSOR | settings)).confirmed.sum(axis=-1).tolist()


@pytest.mark.parametrize(
    "readings, settings, wanted",
    [
        ([5, 5, 5], {}, [0, 1, 1]),
        ([5, NONE, 5], {}, [0, 0, 1]),
        ([5, NONE, NONE, 5], {}, [0, 0, 0, 0]),  # dropped, and a new one starts
        ([5, NONE, NONE, 5, 5], {}, [0, 0, 0, 0, 1]),
        ([5, 5, 5], dict(confirm=(1, 1)), [1, 1, 1]),
        ([5, 5, 5, 5], dict(confirm=(3, 4)), [0, 0, 1, 1]),
        ([5, NONE, 5, 5], dict(confirm=(3, 4)), [0, 0, 0, 1]),
        ([5, NONE, 5, NONE, 5], dict(confirm=(3, 4)), [0, 0, 0, 0, 0]),
        ([5, 5, NONE, NONE, 5], {}, [0, 1, 1, 1, 1]),
        ([5, 5, NONE, NONE, NONE, NONE], {}, [0, 1, 1, 1, 0, 0]),
        ([5, 5, NONE, 5], dict(patience=1), [0, 1, 0, 0]),
        ([NONE, NONE, 5, 5], {}, [0, 0, 0, 1]),
    ],
)
def test_m_of_n(readings, settings, wanted):
    assert confirmed(*readings, **settings) == wanted


def test_a_track_is_the_filter_from_its_first_reading_on():
    z = np.array([[3.0], [5.0], [NONE], [4.0]])
    tracks = tracker(WALK, z[:, None], WIDE, **SENSOR)
    start = correct(WALK, WIDE, z[0])
    wanted = kalman_filter(WALK, z[1:], start)
    close(tracks.mean[0, 0], start.mean, 1e-12)
    close(tracks.mean[1:, 0], wanted.mean, 1e-12)
    close(tracks.cov[1:, 0], wanted.cov, 1e-12)
    assert tracks.used[:, 0].tolist() == [0, 0, -1, 0]


def test_the_score_is_a_sum_of_logarithms():
    z = np.array([[3.0], [5.0], [NONE], [4.0]])
    tracks = tracker(WALK, z[:, None], WIDE, detection=0.8, clutter=0.01, gate=0.99)
    track = kalman_filter(WALK, z[1:], correct(WALK, WIDE, z[0]))
    y, S = track.innovation.mean[:, 0], track.innovation.cov[:, 0, 0]
    hit = np.log(0.8 * np.exp(-(y**2) / S / 2) / np.sqrt(2 * np.pi * S) / 0.01)
    wanted = np.cumsum(np.where(np.isnan(y), np.log(1 - 0.8 * 0.99), hit))
    close(tracks.score[:, 0], [0, *wanted], 1e-12)


def scene(runs, targets=2, steps=25, clutter=2e-5, detection=0.9, rng=0):
    rng = np.random.default_rng(rng)
    start = Gaussian(np.array([[0, 4, 0, 2], [200, -4, 100, -2], [0, 4, 150, -3]])[:targets], np.diag([9, 0.1, 9, 0.1]))
    x = np.stack([simulate(PLANE, start, steps, runs=targets, rng=rng).x for _ in range(runs)])
    x = np.moveaxis(x, 1, 2)  # runs, T, targets, n
    return x, scan_targets(PLANE, x, detection, clutter, AREA, rng)


def test_a_batch_is_each_run_alone():
    _, scans = scene(4, steps=12)
    together = tracker(PLANE, scans.z, BIRTH, detection=0.9, clutter=2e-5)
    for i, z in enumerate(scans.z):
        alone = tracker(PLANE, z, BIRTH, detection=0.9, clutter=2e-5)
        M = alone.label.shape[-1]
        np.testing.assert_array_equal(alone.label, together.label[i, :, :M])
        np.testing.assert_array_equal(alone.used, together.used[i, :, :M])
        np.testing.assert_allclose(alone.mean, together.mean[i, :, :M], rtol=1e-9, atol=1e-9)
        assert (together.label[i, :, M:] == -1).all()


def test_what_holds_for_every_scan():
    _, scans = scene(5, clutter=1e-4)
    tracks = tracker(PLANE, scans.z, BIRTH, detection=0.9, clutter=1e-4)
    empty = tracks.label == -1
    assert np.isnan(tracks.mean[empty]).all() and np.isfinite(tracks.mean[~empty]).all()
    assert not (tracks.confirmed & empty).any()
    N = scans.z.shape[2]
    used = (tracks.used[..., None] == np.arange(N)).sum(axis=-2)
    there = ~np.isnan(scans.z[..., 0])
    np.testing.assert_array_equal(used, there)  # each reading is some track's, and one track's only
    for run in range(5):
        for k in range(1, 25):
            now, before = (tracks.label[run, step][~empty[run, step]] for step in (k, k - 1))
            assert len(set(now)) == len(now)
            new = set(now) - set(before)
            assert not before.size or not new or min(new) > max(before)
    assert np.linalg.eigvalsh(tracks.cov[~empty]).min() > 0


def test_two_targets_are_found_and_kept():
    x, scans = scene(100)
    tracks = tracker(PLANE, scans.z, BIRTH, detection=0.9, clutter=2e-5)
    found = gospa(x[..., [0, 2]], tracks.estimates[..., [0, 2]], cutoff=20)
    known = np.stack([kalman_filter(PLANE, scans.of(i), BIRTH).mean[..., [0, 2]] for i in range(2)], axis=2)
    perfect = gospa(x[..., [0, 2]], known, cutoff=20)
    late = found.missed[:, 10:] / 200  # targets missed after the start
    assert late.mean() < 0.1
    more = with_error(found.distance[:, 10:], minus=perfect.distance[:, 10:])
    assert more.value > 4 * more.error
    readings = gospa(x[..., [0, 2]], scans.z, cutoff=20)  # all readings as they come
    less = with_error(readings.distance[:, 10:], minus=found.distance[:, 10:])
    assert less.value > 4 * less.error


def test_stricter_rules_make_fewer_false_tracks_and_later_true_ones():
    nothing = np.full((60, 25, 1, 4), np.nan)
    empty = scan_targets(PLANE, nothing, 0.9, 1e-4, AREA, rng=1)
    x, scans = scene(60, targets=1, clutter=1e-4)
    false, first = [], []
    for confirm in ((2, 2), (2, 3), (3, 4)):
        rules = dict(detection=0.9, clutter=1e-4, confirm=confirm)
        false.append(tracker(PLANE, empty.z, BIRTH, **rules).confirmed.sum(axis=(1, 2)) / 25)
        tracks = tracker(PLANE, scans.z, BIRTH, **rules)
        near = gospa(x[..., [0, 2]], tracks.estimates[..., [0, 2]], cutoff=20).match[..., 0] >= 0
        first.append(np.where(near.any(axis=1), near.argmax(axis=1), 25))
    for loose, strict in ((0, 2), (1, 2)):
        fewer = with_error(false[loose], minus=false[strict])
        assert fewer.value > 4 * fewer.error
        later = with_error(first[strict], minus=first[loose])
        assert later.value > 2 * later.error


def test_results_cannot_be_changed():
    tracks = tracker(WALK, np.zeros((2, 1, 1)), WIDE, **SENSOR)
    with pytest.raises(ValueError, match="read-only"):
        tracks.mean[:] = 0
    assert repr(tracks) == "Tracks(T=2 steps, M=1 slots, n=1 states; confirmed tracks a step: 0.50)"


@pytest.mark.parametrize(
    "changed, words",
    [
        (dict(birth=Gaussian([[0.0], [1.0]], [[1.0]])), "birth must be one belief"),
        (dict(confirm=3), r"confirm must be two whole numbers \(M, N\)"),
        (dict(confirm=(3, 2)), "N of confirm must be a whole number of at least 3"),
        (dict(patience=0), "patience must be a whole number of at least 1"),
        (dict(clutter=0), "clutter must be positive"),
        (dict(how="nearest"), "how must be one of"),
        (dict(z=np.zeros((3, 1))), r"z must have shape \(any, any, 1\)"),
    ],
)
def test_bad_input(changed, words):
    good = dict(model=WALK, z=np.zeros((3, 2, 1)), birth=WIDE, **SENSOR)
    with pytest.raises(ValueError, match=words):
        tracker(**(good | changed))


def test_the_order_in_a_scan_is_of_no_account():
    _, scans = scene(3, steps=12)
    one, other = (tracker(PLANE, z, BIRTH, detection=0.9, clutter=2e-5) for z in (scans.z, scans.z[:, :, ::-1]))
    for run in range(3):
        for k in range(12):
            a, b = (t.estimates[run, k][t.confirmed[run, k]] for t in (one, other))
            np.testing.assert_allclose(a[np.argsort(a[:, 0])], b[np.argsort(b[:, 0])], rtol=1e-9, atol=1e-9)


def test_a_model_that_changes_with_time():
    rng = np.random.default_rng(0)
    R = np.linspace(4, 16, 6)[:, None, None]
    model, z = WALK.replace(R=R), rng.normal(0, 3, (6, 1, 1))
    tracks = tracker(model, z, WIDE, detection=0.9, clutter=1e-6)
    start = correct(model, WIDE, z[0, 0], k=0)
    wanted = kalman_filter(WALK.replace(R=R[1:]), z[1:, 0], start)
    close(tracks.mean[1:, 0], wanted.mean, 1e-12)
    close(tracks.cov[1:, 0], wanted.cov, 1e-12)
