"""Longley's regression: the certified numbers, and how many of their digits each way keeps."""

import numpy as np
import pytest
from filterpy.kalman import KalmanFilter

from kflearn import Gaussian, kalman_filter
from kflearn.course import longley

P0 = 1e20


def test_the_certified_residual():
    """NIST certifies the residual standard deviation too: 304.854073561965."""
    left = longley.z - longley.H @ longley.CERTIFIED
    assert np.sqrt(left @ left / (16 - 7)) == pytest.approx(304.854073561965, rel=1e-10)


def test_the_data_are_those_of_statsmodels():
    data = pytest.importorskip("statsmodels.datasets.longley").load_pandas()
    assert (longley.z == data.endog.to_numpy()).all()
    assert (longley.H[:, 1:] == data.exog.to_numpy()).all()


def test_digits_kept():
    assert longley.digits(longley.at_once()) > 9
    assert longley.digits(longley.by_joseph(P0)) == 0
    assert longley.digits(longley.by_root(P0)) > 5
    assert 2 < longley.digits(longley.by_root_noise_first(P0)) < 5


def test_filterpy_keeps_none():
    kf = KalmanFilter(7, 1)
    kf.P, kf.R, kf.Q = P0 * np.eye(7), longley.MODEL.R, longley.MODEL.Q
    for row, reading in zip(longley.H, longley.z, strict=True):
        kf.predict()
        kf.update(reading, H=row[None])
    assert longley.digits(kf.x[:, 0]) == 0


def test_kalman_filter_refuses_such_a_start():
    with pytest.raises(ValueError, match="R must be larger beside P"):
        kalman_filter(longley.MODEL, longley.z, Gaussian(np.zeros(7), P0 * np.eye(7)))
