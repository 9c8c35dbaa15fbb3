"""The missile: a place and its angles, and what a tangent does not see."""

import numpy as np

from kflearn import Gaussian, homing


def test_the_missile_with_a_larger_R():
    """What the tangent does not see, counted as noise, does as much as sigma points; and a place has its angles."""
    how = dict(steered_by="estimate", told="applied", distance="truth")
    start = Gaussian(homing.START.mean, 16 * homing.START.cov)
    plain, larger = (homing.fly(20, 0, start=start, larger_R=choice, **how).miss.mean() for choice in (False, True))
    assert plain > 250
    assert larger < 26
    x = homing.TRUE_START
    assert np.allclose(homing.place(homing.angles(x), np.linalg.norm(x[:3])), x[:3])
    d, sigma = np.linalg.norm(start.mean[:3]), 400.0  # a round belief: along and across are the same
    assert np.allclose(homing.unseen(start), sigma**4 / d**4 * np.eye(2))
