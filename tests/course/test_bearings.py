"""The generated recordings against the statistics of the six real ones (SYSTEMS, "bearing of a sound source")."""

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    angle_difference,
    bearings,
    circular_mean,
    extended_kalman_filter,
    kalman_filter,
    random_walk,
    scenarios,
    wrap,
)
from kflearn.course.bearings import GRID, VARIANTS, _bursts, nearest

RUNS = 60


@pytest.fixture(scope="module")
def recordings():
    return {name: scenarios.bearing(name).simulate(RUNS, rng=1) for name in VARIANTS}


def runs_of(flags):
    """Lengths of the runs of True along the last axis, all rows together."""
    edges = np.diff(np.pad(flags.astype(int), ((0, 0), (1, 1))))
    return np.argwhere(edges == -1)[:, 1] - np.argwhere(edges == 1)[:, 1]


def dwells(z):
    """Lengths of the stretches of equal values, all rows together."""
    return np.concatenate([np.diff(np.flatnonzero(np.r_[True, row[1:] != row[:-1], True])) for row in z])


def deviations(data):
    """How far each report is from the direction of the grid that is nearest to the truth, degrees."""
    return angle_difference(data.z[..., 0], nearest(data.x[..., 0]))


def test_whole_degrees_on_a_sparse_grid(recordings):
    assert len(np.unique(GRID)) == 151
    assert np.diff(np.sort(GRID)).max() <= 4
    for data in recordings.values():
        assert np.isin(data.z, GRID).all()
        assert data.z.min() >= 0
        assert data.z.max() < 360


def test_values_hold(recordings):
    hold = {name: np.mean(data.z[:, 1:] == data.z[:, :-1]) for name, data in recordings.items()}
    assert 0.43 < hold.pop("hard") < 0.56
    assert all(0.62 < share < 0.93 for share in hold.values()), hold


def test_dwells_are_heavy_tailed(recordings):
    lengths = {name: dwells(data.z[..., 0]) for name, data in recordings.items()}
    pooled = np.concatenate(list(lengths.values()))
    assert 0.50 < np.mean(pooled == 1) < 0.62
    assert 2.9 < pooled.mean() < 3.8
    longest = [np.median([dwells(row[None]).max() for row in data.z[..., 0]]) for data in recordings.values()]
    assert min(longest) > 8
    assert 20 < np.median(longest) < 126


def test_steps_about_the_level_are_small(recordings):
    for name, data in recordings.items():
        off = deviations(data)
        near = off[abs(off) < 9]
        assert 0.55 < np.mean(near == 0) < 0.93, name
        assert 0.8 < near.std() < 2.7, name


def test_bursts_of_outliers(recordings):
    shares, lengths, whole, peaks = {}, [], [], []
    for name, data in recordings.items():
        off = abs(deviations(data))
        shares[name] = np.mean(off > 9)
        lengths.extend(runs_of(off > 9))
        jumps = abs(np.diff(data.x[..., 0], axis=1, prepend=data.x[:, :1, 0])) > 30  # another speaker
        whole.extend(runs_of((off > 9) & ~jumps))
        peaks.extend(off[off > 9])
    assert shares["calm"] == 0
    assert shares["reflections"] == max(shares.values())
    assert 0.15 < shares["reflections"] < 0.22
    assert all(share > 0.03 for name, share in shares.items() if name != "calm")
    assert 1.9 < np.mean(lengths) < 2.5
    assert max(whole) == 9
    assert 20 < np.median(peaks) < 40


def test_bursts_last_2_2_samples_on_average():
    habits = VARIANTS["typical"]._replace(bursts=0.2)
    bursts = list(_bursts(habits, 400_000, np.random.default_rng(0)))
    lengths = np.array([length for _, length in bursts])
    assert abs(lengths.mean() - 2.2) < 0.05
    assert (lengths.min(), lengths.max()) == (1, 9)
    begins = np.array([begin for begin, _ in bursts])
    assert (np.diff(begins) > lengths[:-1]).all()  # one ends before the next begins


def test_reflections_alternate_between_two_wrong_values():
    data = scenarios.bearing("reflections").simulate(RUNS, rng=2)
    z, wrong = data.z[..., 0], abs(deviations(data)) > 9
    triple = wrong[:, :-2] & wrong[:, 1:-1] & wrong[:, 2:]
    there_and_back = (z[:, :-2] == z[:, 2:]) & (z[:, :-2] != z[:, 1:-1])
    assert np.mean(there_and_back[triple]) > 0.7


def test_sources_switch_and_one_track_crosses_north(recordings):
    jumps = abs(np.diff(recordings["switching"].x[..., 0]))
    jumps = jumps[jumps > 1]
    assert len(jumps) > 2.5 * RUNS
    assert np.mean((jumps >= 50) & (jumps <= 160)) > 0.95  # two switches at once add up
    crossing = recordings["crossing"]
    assert (crossing.x[:, 0] < 360).all() and (crossing.x[:, -1] > 360).all()
    assert (crossing.z.max(axis=1) > 340).all() and (crossing.z.min(axis=1) < 20).all()


def test_the_published_series_with_and_without_wrapping():
    z = np.array([339, 8, 8, 30, 355, 3, 8, 3, 8, 3.0])
    K = 0.4633
    plain, wrapped = [z[0]], [z[0]]
    for reading in z[1:]:
        plain.append(plain[-1] + K * (reading - plain[-1]))
        wrapped.append(wrapped[-1] + K * angle_difference(reading, wrapped[-1]))
    np.testing.assert_allclose(plain, [339.0, 185.6, 103.3, 69.4, 201.7, 109.6, 62.6, 35.0, 22.5, 13.45], atol=0.05)
    told = [339, 352.4, 359.65, 13.7, 5.0, 4.1, 5.9, 4.6, 6.2, 4.7]
    np.testing.assert_allclose(np.mod(wrapped, 360), told, atol=0.05)


def test_steady_state_and_wrapped_filter():
    scene = scenarios.bearing("crossing")
    linear = kalman_filter(random_walk(200, 500), np.zeros(100), scene.initial)
    np.testing.assert_allclose(linear.gain[-1], 0.463325, atol=1e-6)
    np.testing.assert_allclose(linear.cov[-1], 231.6625, atol=1e-4)
    data = scene.simulate(20, rng=3)
    wrapped = extended_kalman_filter(scene.model, data.z, scene.initial)
    plain = kalman_filter(random_walk(200, 500), data.z, scene.initial)
    error = [np.sqrt(np.mean(angle_difference(track.mean, data.x) ** 2)) for track in (wrapped, plain)]
    assert error[0] < 12
    assert error[1] > 20


def test_angles():
    assert wrap(190.0) == -170
    assert wrap(-180.0) == -180
    assert angle_difference(3, 358) == 5
    assert angle_difference(358, 3) == -5
    np.testing.assert_allclose(wrap(3.5 * np.pi, 2 * np.pi), -0.5 * np.pi)
    np.testing.assert_allclose(circular_mean([350, 20, 5]), 5)
    np.testing.assert_allclose(circular_mean([[359, 1], [90, 92]], axis=1), [0, 91], atol=1e-12)


def test_an_unknown_variant_is_named():
    with pytest.raises(ValueError, match=r"variant must be one of 'calm'.*got 'noisy'"):
        scenarios.bearing("noisy")


def test_the_course_filters_are_kalman_filters():
    """Where no reading is refused and all weights are 1, each is `kalman_filter`; the first reading counts once."""
    z = 200 + np.random.default_rng(6).normal(0, 3, 60).cumsum() * 0.2
    right = kalman_filter(random_walk(0.2, 2.0), z[1:], Gaussian(z[0], 2.0)).mean[:, 0]
    found = [
        bearings.scalar_filter(z, 0.2, 2.0),
        bearings.robust_filter(z, 0.2, 2.0, np.ones_like),
        bearings.gated_filter(z, 0.2, 2.0, gate=1e9).mean,
    ]
    for each in found:
        assert each[0] == z[0]
        np.testing.assert_allclose(each[1:], right, rtol=1e-12)
