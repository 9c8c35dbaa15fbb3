"""Structural models of real series beside R's StructTS and statsmodels' exact diffuse likelihood."""

import warnings

import numpy as np
import pytest

from kflearn import Gaussian, LinearModel, diffuse_start, examples, fit, kalman_filter

NILE = examples.load("nile")["flow"]


def quarters():
    """Carbon dioxide on Mauna Loa, the means of the 80 quarters from 1980 to 1999."""
    air = examples.load("co2")
    day = np.datetime64(air.start, "D") + np.round(air.time / 86400).astype(int)
    month = day.astype("datetime64[M]").astype(int)
    quarter = month // 3 - (1980 - 1970) * 4
    return np.array([np.nanmean(air["co2"][quarter == k]) for k in range(80)])


def trend(R, level, slope):
    return LinearModel([[1, 1], [0, 1]], [[1, 0]], np.diag([level, slope]), R)


def seasonal(R, level, slope, season, period=4):
    """A level, its slope, and a season whose parts add up to noise over a period."""
    F = np.zeros((period + 1, period + 1))
    F[:2, :2] = [[1, 1], [0, 1]]
    F[2, 2:] = -1
    F[range(3, period + 1), range(2, period)] = 1
    H = np.zeros((1, period + 1))
    H[0, [0, 2]] = 1
    Q = np.zeros((period + 1, period + 1))
    Q[range(3), range(3)] = level, slope, season
    return LinearModel(F, H, Q, R)


def log_likelihood(model, z):
    """Of all readings, when nothing is known before the first: by the filter, one step after another."""
    start = diffuse_start(model, z)
    return start.log_likelihood + kalman_filter(start.model, z[start.steps :], start.belief).log_likelihood
