"""The boats of lesson 26."""

import numpy as np

from kflearn import boats, gnn_filter, with_error
from tests.helpers import close

PLANE = boats.plane()


def test_two_boats_meet_in_the_middle():
    scene = boats.crossing(PLANE, 30, 2e-5, 3, rng=0)
    apart = np.linalg.norm((scene.x[:, 0] - scene.x[:, 1])[:, [0, 2]], axis=-1)
    assert apart.argmin() == 19
    close(apart[19], 0, 1e-12)
    close(np.linalg.norm(scene.x[..., [1, 3]], axis=-1), 7, 1e-12)
    first, second = scene.x[0][:, [1, 3]]
    close(np.degrees(np.arccos(first @ second / 49)), 30, 1e-9)
    close(np.diff(scene.x[..., [0, 2]], axis=0), np.broadcast_to(scene.x[:1, :, [1, 3]], (39, 2, 2)), 1e-9)


def test_what_is_seen_at_the_end():
    x = np.zeros((1, 2, 4))
    x[0, 1, 0] = 10
    own, other = x[0], x[0][::-1]
    mean = np.stack([own, other, own[[0, 0]], own[[1, 1]]])[:, :, None]
    exchanged, together = boats.at_the_end(mean, x)
    assert exchanged.tolist() == [False, True, False, False]
    assert together.tolist() == [False, False, True, True]


def test_a_small_angle_exchanges_more():
    shares = []
    for angle in (15, 60):
        scene = boats.crossing(PLANE, angle, 2e-5, 100, rng=1)
        mean = gnn_filter(PLANE, scene.z, scene.start, detection=0.9, clutter=2e-5).mean
        shares.append(with_error(1.0 * boats.at_the_end(mean, scene.x)[0]))
    assert shares[0].value - shares[1].value > 4 * np.hypot(shares[0].error, shares[1].error)


def test_the_fleet_comes_and_goes():
    x = boats.fleet(PLANE, 2, rng=0)
    there = ~np.isnan(x).any(axis=-1)
    assert there.sum(axis=1).tolist() == [[40, 35, 25]] * 2
    assert there[0, 5:25].all() and not there[0, 4, 1] and not there[0, 25, 2]


def test_knobs_take_away_and_move_nothing():
    x = boats.fleet(PLANE, 1, rng=0)[0, :, 0]
    scans = boats.adjustable(PLANE, x, 1e-3, boats.AREA, rng=0)
    full, few = scans(1.0, 1e-3), scans(0.5, 1e-4)
    kept = ~np.isnan(few)
    np.testing.assert_array_equal(few[kept], full[kept])
    count = (~np.isnan(scans(0.0 + 1e-9, 1e-4)[..., 0])).sum() / 40
    assert abs(count - 36) < 4 * np.sqrt(36 / 40)  # λ times the area
    own = (~np.isnan(scans(0.5, 1e-12)[..., 0])).sum()
    assert abs(own - 20) < 4 * np.sqrt(10)
