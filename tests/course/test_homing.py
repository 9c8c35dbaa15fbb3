"""The missile: a place and its angles, and what a tangent does not see."""

import numpy as np

from kflearn import Gaussian, homing


def test_the_missile_with_a_larger_R():
    """What the tangent does not see, counted as noise, does as much as sigma points; and a place has its angles."""
    how = dict(steered_by="estimate", told="applied", distance="truth")
    start = Gaussian(homing.START.mean, 16 * homing.START.cov)
    plain, larger = (homing.fly(20, 0, start=start, larger_R=choice, **how) for choice in (False, True))
    assert plain.left.mean() > 250
    assert larger.left.mean() < 26
    assert larger.miss.mean() < plain.miss.mean() / 10
    x = homing.TRUE_START
    assert np.allclose(homing.place(homing.angles(x), np.linalg.norm(x[:3])), x[:3])
    d, sigma = np.linalg.norm(start.mean[:3]), 400.0  # a round belief: along and across are the same
    assert np.allclose(homing.unseen(start), sigma**4 / d**4 * np.eye(2))


def test_the_miss_is_where_a_missile_would_pass():
    """Ahead of the target, past it, or two of both: the line through the nearest step, however late it is reached."""
    t = np.array([-3.0, -2, -1])
    course = np.zeros((2, 3, 9))
    course[0, :, :6] = [[-100 * s, 3, 4, 100, 0, 0] for s in t]  # 5 m beside the line
    course[1, :, :6] = [[100 * (s + 2.2), 0, -7, 100, 0, 0] for s in t]  # passed between two steps
    assert np.allclose(homing.miss(course), [5, 7])
    assert np.allclose(homing.miss(course[0]), 5)


def test_who_ignores_the_angles_flies_past():
    """Steered by its estimate: with angles late and near the line, without them early and wide."""
    seen, blind = (homing.fly(3, 0, steered_by="estimate", told="applied", measured=see) for see in (True, False))
    assert np.all(seen.miss < 10)
    assert np.all(seen.left > 400)
    assert np.all(seen.nearest == homing.DT * homing.STEPS)
    away = np.linalg.norm(blind.x[..., :3], axis=-1)
    assert np.all(away.min(axis=-1) < blind.left - 100)
    assert np.allclose(blind.nearest, 3.33)
    assert np.allclose(blind.miss, away.min(axis=-1), atol=0.1)
