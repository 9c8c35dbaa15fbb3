"""The ball: its path and picture, the detector on them, the published trackers, and the learner's own films."""

import numpy as np
import pytest

from kflearn import Gaussian, kalman_filter, scenarios, video
from tests.filters.test_reference import read


@pytest.fixture(scope="module")
def film():
    return video.render(rng=0)


@pytest.fixture(scope="module")
def found(film):
    return video.detect(film.frames, film.frames[:6].mean(axis=0))


def published(name):
    table = read(f"ball_tracking_{name}")
    z = np.where(table["flag"][:, None] > 0, np.stack([table["cc"], table["cr"]], axis=-1), np.nan)
    return table, z


def test_film(film):
    assert film.frames.shape == (60, 240, 320, 3)
    assert film.frames.dtype == np.uint8
    assert np.isnan(film.truth[:6]).all()
    assert list(np.flatnonzero(film.hidden)) == [19, 20, 21]
    table = read("ball_truth")
    truth = np.stack([table[name] for name in ("x", "y", "vx", "vy")], axis=-1)
    assert np.nanmax(abs(film.truth - truth)) < 0.03  # two bounces fall on another thousandth of a frame
    np.testing.assert_array_equal(video.render(steps=12, rng=5).frames, video.render(steps=12, rng=5).frames)


def test_detections(film, found):
    """Within 0.1 px of the published ones and of the truth; the radius loses 2.17 px to two erosions (ERRATA 25)."""
    table, z = published("coasting")
    np.testing.assert_array_equal(np.isnan(found.radius), table["flag"] == 0)
    assert np.nanmax(abs(found.centre - z)) < 0.1
    error = found.centre - film.truth[:, :2]
    assert np.nanmax(abs(error)) < 0.1
    assert np.sqrt(np.nanmean((error**2).sum(axis=1))) < 0.06
    assert abs(np.nanmean(found.radius) - 11.83) < 0.05
    whole = video.detect(film.frames[6:10], film.frames[:6].mean(axis=0), threshold=20, erosions=0)
    assert abs(whole.radius.mean() - video.RADIUS) < 0.4


def test_only_the_largest_region_counts_and_small_ones_do_not():
    frames, background = np.zeros((3, 60, 80, 3), np.uint8), np.zeros((60, 80, 3))
    frames[0, 10:30, 10:30, 0] = frames[0, 40:50, 50:60, 1] = 99
    frames[1, 10:20, 10:20] = 99  # 36 pixels are left of these 100
    frames[2, 0:16, 0:16], frames[2, 16:32, 16:32] = 99, 99  # they touch at a corner only
    found = video.detect(frames, background)
    np.testing.assert_allclose(found.centre[0], [19.5, 19.5])
    assert np.isnan(found.centre[1]).all()
    assert found.radius[2] < 8


def test_tracker_that_coasts():
    table, z = published("coasting")
    scene = scenarios.ball()
    track = kalman_filter(scene.model, z[6:], scene.initial, scene.u)
    names = (("x", track.mean), ("xp", track.predicted.mean))
    for letter, belief in names:
        expected = np.stack([table[f"{letter}{k}"] for k in range(1, 5)], axis=-1)[6:]
        np.testing.assert_allclose(belief, expected, rtol=1e-8, atol=1e-8)
    variances = np.stack([table[f"P{k}{k}"] for k in range(1, 5)], axis=-1)[6:]
    np.testing.assert_allclose(track.filtered.variance, variances, rtol=1e-8)
    np.testing.assert_allclose(track.gain[-1, [0, 2], 0], [0.475031, 0.135876], atol=2e-6)
    np.testing.assert_allclose(track.gain[-1, [1, 3], 1], [0.662442, 0.272555], atol=2e-6)
    # ERRATA 27 and 28: a spurious velocity at the start, a ball at rest that is believed too low.
    assert track.mean[0, 2] < -59
    assert abs((track.mean[-8:, 1] - video.FLOOR).mean() - 7.43) < 0.1


def test_tracker_that_restarts_from_zero():
    """As published: after a miss the state is zero, and P is as it was before the miss (ERRATA 26)."""
    table, z = published("as_published")
    scene = scenarios.ball()
    before = kalman_filter(scene.model, z[6:19], scene.initial, scene.u[:13])
    lost = Gaussian(np.zeros(4), before.cov[-1])
    after = kalman_filter(scene.model, z[22:], lost, np.full(38, 6.0))
    expected = np.stack([table[f"x{k}"] for k in range(1, 5)], axis=-1)
    np.testing.assert_allclose(before.mean, expected[6:19], rtol=1e-8, atol=1e-8)
    np.testing.assert_allclose(after.mean, expected[22:], rtol=1e-8, atol=1e-8)


def test_gravity_and_bounces():
    path = video.fall(54)
    np.testing.assert_allclose(path[:8, 1], 30 + 3 * np.arange(8) ** 2, atol=1e-9)
    assert path[:, 1].max() <= video.FLOOR
    np.testing.assert_array_equal(path[-5:, 2:], 0)


def test_own_pictures(tmp_path, film):
    iio = pytest.importorskip("imageio.v3")
    for k in range(3):
        iio.imwrite(tmp_path / f"frame{k}.png", film.frames[k + 6])
    (tmp_path / "notes.txt").write_text("no picture")
    np.testing.assert_array_equal(video.load(tmp_path), film.frames[6:9])
    iio.imwrite(tmp_path / "frame3.png", film.frames[0, ..., 0])  # grey
    np.testing.assert_array_equal(video.load(tmp_path)[3], np.repeat(film.frames[0, ..., :1], 3, axis=-1))
    iio.imwrite(tmp_path / "frame4.png", film.frames[0, :100])
    with pytest.raises(ValueError, match="pictures of one size"):
        video.load(tmp_path)
    with pytest.raises(FileNotFoundError, match="found nothing at nowhere"):
        video.load(tmp_path / "nowhere")
    (tmp_path / "empty").mkdir()
    with pytest.raises(ValueError, match="folder with pictures"):
        video.load(tmp_path / "empty")


def test_own_film(tmp_path, film):
    iio = pytest.importorskip("imageio.v3")
    pytest.importorskip("av")
    iio.imwrite(tmp_path / "ball.mp4", film.frames[:20], plugin="pyav", codec="libx264", fps=10)
    frames = video.load(tmp_path / "ball.mp4")
    assert frames.shape == (20, 240, 320, 3)
    found = video.detect(frames, frames[:6].mean(axis=0), threshold=25)
    assert np.nanmax(abs(found.centre - film.truth[:20, :2])[8:15]) < 1.5


def test_a_throw_is_hidden_between_two_bounces():
    truth, centre = video.throw(rng=1)
    assert truth.shape == (16, 4)
    np.testing.assert_array_equal(np.flatnonzero(np.isnan(centre[:, 0])), [13, 14, 15])
    np.testing.assert_allclose(np.diff(truth[12:, 3]), video.GRAVITY)
    assert np.nanmax(abs(centre - truth[:, :2])) < 0.5
    np.testing.assert_array_equal(video.throw(rng=1)[1], centre)
