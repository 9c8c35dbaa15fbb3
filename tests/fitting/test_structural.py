"""Structural models of real series beside R's StructTS and statsmodels' exact diffuse likelihood."""

import warnings
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import pytest

from kflearn import Gaussian, LinearModel, diffuse_start, em, examples, fit, kalman_filter
from kflearn.fitting.family import Family
from kflearn.fitting.fit import _Series

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


def start_of_r(n, z):
    """StructTS's own start (R 4.2.2, its source): the first reading and zeros, with one number, 10⁴ var(z), in *every*
    place of the covariance. So its likelihood is not the diffuse one, but it is one that we can compute."""
    return Gaussian(np.append(z[0], np.zeros(n - 1)), np.full((n, n), 1e4 * np.var(z, ddof=1)))


class Case(NamedTuple):
    build: Callable
    z: np.ndarray
    names: tuple
    n: int
    theirs: tuple  # R 4.2.2: StructTS(z, type)$coef in the order of names; $code was 0
    log_likelihood: float  # $loglik
    period: int | None


CASES = {  # type "trend" for the Nile, "BSM" for the quarters, as ts(z, frequency = 4)
    "trend": Case(
        trend,
        NILE,
        ("R", "level", "slope"),
        2,
        (15047.32557812057, 1426.73585559289, 0.0),
        -645.80742676898,
        None,
    ),
    "seasonal": Case(
        seasonal,
        quarters(),
        ("R", "level", "slope", "season"),
        5,
        (0.0, 0.06758408483858376, 0.00526576135014893, 0.12326200958165637),
        -100.883542676699,
        4,
    ),
}
per_case = pytest.mark.parametrize("case", CASES.values(), ids=CASES)


def fitted(case, initial=None):
    return fit(case.build, case.z, dict.fromkeys(case.names, 1.0), initial)


def numbers(found):
    return [found.parameters[name] for name in found.parameters]


@per_case
def test_beside_r(case):
    """With R's start our filter says what StructTS says of its own parameters, and our fit is nowhere below it."""
    start, theirs = start_of_r(case.n, case.z), np.array(case.theirs)
    theirs[0] = max(theirs[0], 1e-12)  # our models have no R = 0
    at_theirs = kalman_filter(case.build(*theirs), case.z, start).log_likelihood
    assert at_theirs == pytest.approx(case.log_likelihood, abs=1e-6)
    found = fitted(case, start)
    assert found.log_likelihood >= case.log_likelihood
    assert numbers(found) == pytest.approx(case.theirs, rel=0.02, abs=1e-9)
    assert log_likelihood(case.build(*theirs), case.z) < fitted(case).log_likelihood  # and by the diffuse likelihood


def theirs_of(case):
    structural = pytest.importorskip("statsmodels.tsa.statespace.structural")
    return structural.UnobservedComponents(case.z, "lltrend", seasonal=case.period, use_exact_diffuse=True)


@per_case
def test_beside_statsmodels(case):
    """Its parameters come in the order of ours. It counts −½ log 2π more for each state."""
    rng, model = np.random.default_rng(5), theirs_of(case)
    more = 0.5 * case.n * np.log(2 * np.pi)
    for values in np.exp(rng.normal(0, 2, (10, len(case.names)))) * np.var(case.z) / 100:
        assert log_likelihood(case.build(*values), case.z) == pytest.approx(model.loglike(values) + more, abs=1e-6)
    found = fitted(case)
    assert found.log_likelihood_of_all == pytest.approx(model.loglike(numbers(found)), abs=1e-6)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        best = model.fit(disp=0)
    assert found.converged and found.log_likelihood_of_all >= best.llf - 1e-6


@per_case
def test_it_is_the_top(case):
    """Forty places around it, and the filter of `diffuse_start`, which shares no line with the fit."""
    found, rng = fitted(case), np.random.default_rng(6)
    top = np.array(numbers(found))
    assert log_likelihood(found.model, case.z) == pytest.approx(found.log_likelihood, abs=1e-6)
    for step in rng.normal(0, 0.3, (40, len(top))):
        moved = np.maximum(top, 1e-6 * np.var(case.z)) * np.exp(step)
        assert log_likelihood(case.build(*moved), case.z) < found.log_likelihood


@pytest.mark.parametrize("R", [1e-4, 1e-6, 1e-8, 1e-10, 1e-12])
def test_a_tiny_R_costs_no_digits(R):
    """Five states, of which four never change: nearly all that is known of them comes from the first five readings."""
    z = quarters()
    family = Family(two_only, dict(R=1.0, level=1.0))
    series = _Series.of(family, z, None, None)
    found = series.log_likelihood(np.log([[[R, 0.044]]]))[0, 0]
    assert found == pytest.approx(log_likelihood(two_only(R, 0.044), z), abs=1e-5)


def test_no_top_is_made_of_rounding_errors():
    """Of R and the level's variance alone: an R of 4e-12 once had a log-likelihood of +423."""
    found = fit(two_only, quarters(), dict(R=1.0, level=1.0))
    assert found.log_likelihood == pytest.approx(-28.1174611, abs=1e-6)
    assert found.log_likelihood == pytest.approx(log_likelihood(found.model, quarters()), abs=1e-6)


def two_only(R, level):
    return seasonal(R, level, 0, 0)


@pytest.mark.parametrize("H", [[[1.0, 1.0]], [[0.1, 0.3]]])
def test_a_state_that_no_reading_tells_apart_is_named(H):
    """Two levels of which only a sum is seen; with 0.1 and 0.3 rounding hides it."""

    def build(Q, R):
        return LinearModel(np.eye(2), H, Q * np.eye(2), R)

    for call in (lambda: fit(build, NILE, dict(Q=1.0, R=1.0)), lambda: em(build(1.0, 1.0), NILE)):
        with pytest.raises(ValueError, match="z must determine all 2 states of the model in every series"):
            call()
