"""All filters and both smoothers where doubles lose digits, held to the answer in 80 digits (precise.py)."""

import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    cubature_kalman_filter,
    extended_kalman_filter,
    kalman_filter,
    random_walk,
    rts_smoother,
    square_root_kalman_filter,
    start_from,
    two_filter_smoother,
    unscented_kalman_filter,
)

from ..helpers import least_squares, random_belief, random_model, textbook, with_gaps
from .ill_conditioned import ROWS, seasonal
from .precise import answer, finest, off_by

FOLDER = Path(__file__).parents[1] / "reference"
# In standard deviations. Filters that carry P itself lose as many digits as S is larger than R: LOST times S/R. From
# about 1e15 on no digit is promised, and WORST is what they may then be off without refusing.
ENOUGH, LOST, WORST = 1e-6, 5 * np.finfo(float).eps, 10


def smoothed_after(run):
    return lambda model, z, start: rts_smoother(model, run(model, z, start))


CARRY_ROOTS = {
    "square_root_kalman_filter": square_root_kalman_filter,
    "rts_smoother of square_root": smoothed_after(square_root_kalman_filter),
    "two_filter_smoother": two_filter_smoother,
}
CARRY_P = {
    "kalman_filter": kalman_filter,
    "extended_kalman_filter": extended_kalman_filter,
    "unscented_kalman_filter": unscented_kalman_filter,
    "cubature_kalman_filter": cubature_kalman_filter,
    "rts_smoother": smoothed_after(kalman_filter),
    "rts_smoother of unscented": smoothed_after(unscented_kalman_filter),
}


@cache
def right(i):
    """The answer to row i, in 80 digits."""
    return answer(ROWS[i].model, ROWS[i].z, ROWS[i].start)


def errors(found, exact):
    """By how much means, standard deviations and, beside its size, the log-likelihood are off."""
    if isinstance(found, Gaussian):
        return off_by(found, exact.smoothed)
    log = abs(found.log_likelihood - exact.log_likelihood) / max(1, abs(exact.log_likelihood))
    return *off_by(found.filtered, exact.filtered), log


def bound(i, name):
    """What is promised of row i: a millionth of a standard deviation, if a double can hold the means that well."""
    row, exact = ROWS[i], right(i)
    promised = max(ENOUGH, 4 * finest(exact.filtered), 4 * finest(exact.smoothed), row.thin * name.startswith("rts"))
    if name in CARRY_ROOTS or row.harmless:
        return promised
    return max(promised, min(LOST * exact.surprise, WORST))


@pytest.mark.parametrize("i", range(len(ROWS)), ids=[row.name for row in ROWS])
def test_filters_and_smoothers_keep_their_digits(i):
    row, wrong = ROWS[i], {}
    for name, run in (CARRY_ROOTS | CARRY_P).items():
        try:
            found = errors(run(row.model, row.z, row.start), right(i))
        except ValueError as error:
            if name in CARRY_ROOTS or not (row.refuses and re.match(row.refuses, str(error))):
                wrong[name] = str(error)
        else:
            if not max(found) <= bound(i, name):
                wrong[name] = ", ".join(f"{off:.0e}" for off in found) + f"; promised {bound(i, name):.0e}"
    assert wrong == {}


def test_the_stated_bound_is_not_loose():
    """Some row comes within a factor of ten of what is promised where P itself is carried."""
    nearest = 0
    for i, row in enumerate(ROWS):
        if not row.harmless and ENOUGH < LOST * right(i).surprise < 1:
            off = errors(kalman_filter(row.model, row.z, row.start), right(i))
            nearest = max(nearest, max(off) / bound(i, "kalman_filter"))
    assert nearest > 0.1


def test_the_answer_is_that_of_other_formulas():
    """Eqs (5) to (9) of the books, and one least-squares problem for all steps, where doubles lose nothing."""
    rng = np.random.default_rng(0)
    model, start = random_model(rng, 3, 2), random_belief(rng, 3)
    z = with_gaps(rng, rng.normal(size=(20, 2)))
    exact, (means, covs, *_, log_likelihood) = answer(model, z, start), textbook(model, z, start)
    assert max(off_by(Gaussian(means, covs), exact.filtered)) < 1e-12
    assert max(off_by(Gaussian(*least_squares(model, z, start)), exact.smoothed)) < 1e-12
    assert exact.log_likelihood == pytest.approx(log_likelihood, rel=1e-13)


def test_there_are_enough_rows():
    assert len({row.name for row in ROWS}) == len(ROWS) >= 40


# ---- known series, with the variances that StructTS of R 4.2.2 finds: Nile, UK gas, UK drivers killed or injured


def series(name):
    """One of R's data sets (Durbin and Koopman 2012; Harvey 1989), one number a line."""
    return np.loadtxt(FOLDER / f"{name}.csv", skiprows=1)


STRUCTURAL = {  # period, variances of level, slope, season and reading
    "ukgas": (4, 0.0, 1.733002994572153e-5, 7.1369434680453297e-4, 3.6779776757449935e-4),
    "seatbelts": (12, 4.1592962333116391e-4, 0.0, 2.7018366115424540e-4, 2.7612499830351715e-4),
}


@pytest.mark.parametrize("rank", [1, None], ids=["start of StructTS", "start with variances alone"])
@pytest.mark.parametrize("name", STRUCTURAL)
def test_structural_models(name, rank):
    """StructTS starts with 10,000 times the variance of the series in every entry of P0, a matrix of rank 1."""
    z, model = np.log10(series(name))[:, None], seasonal(*STRUCTURAL[name])
    vague = 1e4 * np.var(z, ddof=1)
    start = Gaussian([z[0, 0], *np.zeros(model.n - 1)], vague * (np.ones(2 * [model.n]) if rank else np.eye(model.n)))
    exact = answer(model, z, start)
    runs = CARRY_ROOTS | CARRY_P
    if rank:
        del runs["rts_smoother of unscented"]  # its docstring says that it loses its digits here
    found = {name: errors(run(model, z, start), exact) for name, run in runs.items()}
    sigma_points = ("unscented", "cubature")  # these take a root of P at each step, here of a singular one
    limit = {name: ENOUGH if any(word in name for word in sigma_points) else 1e-8 for name in found}
    assert {name: off for name, off in found.items() if not max(off) <= limit[name]} == {}


def test_nile():
    """The likelihood that KFAS gives where nothing is known of the start: the first reading only starts the filter."""
    z, model = series("nile"), random_walk(1469.1, 15099)
    for run in (kalman_filter, square_root_kalman_filter):
        track = run(model, z[1:], start_from(model, z[0]))
        assert track.log_likelihood == pytest.approx(-632.545625, abs=5e-7)
        assert max(errors(track, answer(model, z[1:, None], start_from(model, z[0])))) < 1e-12
