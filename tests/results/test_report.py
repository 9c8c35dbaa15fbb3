"""The report card: what it asks of its arguments. Its figures on recordings are in tests/course."""

import numpy as np
import pytest

from kflearn import Gaussian, kalman_filter, mmae_filter, random_walk, report_card, start_from

MODEL, REST = random_walk(0.01, 1.0), np.arange(50) < 20
Z = np.random.default_rng(0).normal(size=(50, 1))


def follow(z):
    return MODEL, kalman_filter(MODEL, z[1:], start_from(MODEL, z[0]))


def test_one_column_needs_no_axis_of_its_own():
    assert report_card(Z[:, 0], REST, follow) == report_card(Z, REST, follow)


@pytest.mark.parametrize(
    ("wrong", "error", "sentence"),
    [
        (lambda z: follow(z)[1], TypeError, "two things, the model and the track, got Track"),
        (lambda z: follow(z)[::-1], TypeError, "the model first and then its Track, got Track and LinearModel"),
        (
            lambda z: (MODEL, mmae_filter([MODEL], z[1:], start_from(MODEL, z[0]))),
            TypeError,
            "its Track, got LinearModel and MultipleModelTrack",
        ),
        (lambda z: (MODEL, kalman_filter(MODEL, z, Gaussian(0, 1))), ValueError, "the 49 others, got a track of 50"),
        (
            lambda z: (MODEL, kalman_filter(MODEL, np.stack([z[1:]] * 2), Gaussian(0, 1))),
            ValueError,
            "got a track of 49 steps of several runs",
        ),
    ],
)
def test_what_follow_must_return(wrong, error, sentence):
    with pytest.raises(error, match=f"follow must .*{sentence}"):
        report_card(Z, REST, wrong)
