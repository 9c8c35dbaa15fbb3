"""The report card: how often it convicts an honest filter and how surely a wrong one, and what it asks for."""

import numpy as np
import pytest
from scipy.stats import binom, chi2

from kflearn import (
    Gaussian,
    LinearModel,
    NonlinearModel,
    extended_kalman_filter,
    kalman_filter,
    mmae_filter,
    random_walk,
    report_card,
    start_from,
    wrap,
)
from kflearn.results import held_back

MODEL, REST = random_walk(0.01, 1.0), np.arange(50) < 20
Z = np.random.default_rng(0).normal(size=(50, 1))


def follow(z):
    return MODEL, kalman_filter(MODEL, z[1:], start_from(MODEL, z[0]))


# ---- the guilty and the innocent


T, STILL, TRUE_R, TRUE_Q = 260, 60, 9.0, 0.5
F, H = np.array([[1.0, 1], [0, 1]]), np.array([[1.0, 0]])
UNIT_Q = np.array([[1 / 3, 1 / 2], [1 / 2, 1]])


def ride(rng, memory=0.0, push=0.0):
    """One axis of a ride: at rest for a minute, then pushed at random; the error keeps `memory` of itself each step."""
    x, root = np.zeros((T, 2)), np.linalg.cholesky(TRUE_Q * UNIT_Q)
    v = rng.normal(size=T)
    for k in range(1, T):
        v[k] = memory * v[k - 1] + np.sqrt(1 - memory**2) * v[k]
    for k in range(STILL, T):
        x[k] = F @ x[k - 1] + root @ rng.normal(size=2) + push * np.array([0.5, 1])
    return x[:, 0] + np.sqrt(TRUE_R) * v


def card_of(z, q=TRUE_Q, R=None):
    """The card of a constant velocity with this q; R is taken from the rest, as in lesson 27, or from elsewhere."""
    rest = np.arange(T) < (STILL if R is None else 0)
    R = np.var(z[:STILL], ddof=1) if R is None else R
    model = LinearModel(F, H, q * UNIT_Q, R)

    def follow(z):
        return model, kalman_filter(model, z[1:], Gaussian([z[0, 0], 0], np.diag([R, 9.0])), gate=0.999)

    return report_card(z, rest, follow)


def convicted(runs, rng=0, ride=ride, **told):
    """In how many of so many recordings the card fails."""
    rng = np.random.default_rng(rng)
    return sum(not card_of(ride(rng), **told).passed for _ in range(runs))


def test_an_honest_filter_fails_in_one_recording_of_twenty():
    assert convicted(60) <= binom.ppf(0.995, 60, 0.05)
    assert convicted(60, R=TRUE_R) <= binom.ppf(0.995, 60, 0.05)


@pytest.mark.parametrize(
    ("how", "told"),
    [
        ({}, dict(R=TRUE_R / 2)),
        ({}, dict(q=TRUE_Q / 10)),
        ({}, dict(q=TRUE_Q * 10)),
        (dict(memory=0.8), {}),
        (dict(push=1.5), {}),
    ],
    ids=["R half", "Q a tenth", "Q ten times", "an error with a memory", "a push"],
)
def test_a_wrong_filter_fails_in_nine_recordings_of_ten(how, told):
    assert convicted(40, ride=lambda rng: ride(rng, **how), **told) >= 36


def test_which_line_fails_and_what_it_advises():
    card = card_of(ride(np.random.default_rng(1)), q=TRUE_Q * 100)
    assert {test.kind for test in card.tests if test.passed is False} >= {"neighbours"}
    assert "verdict: not yet\n" in str(card) and "neighbours: above: Q is too small" in str(card)
    assert max(map(len, str(card).splitlines())) <= 78


def test_an_error_with_a_memory_passes_once_it_is_a_state():
    rng, passed, memory = np.random.default_rng(2), 0, 0.9
    wide = np.zeros((3, 3))
    wide[:2, :2], wide[2, 2] = TRUE_Q * UNIT_Q, (1 - memory**2) * TRUE_R
    step = np.zeros((3, 3))
    step[:2, :2], step[2, 2] = F, memory
    model = LinearModel(step, [[1, 0, 1]], wide, 0.01)

    def follow(z):
        return model, kalman_filter(model, z[1:], Gaussian([z[0, 0], 0, 0], np.diag([9.0, 9, 9])), gate=0.999)

    for _ in range(40):
        passed += report_card(ride(rng, memory=memory), np.zeros(T, dtype=bool), follow).passed
    assert passed >= 34


# ---- what is on the card


def test_one_column_needs_no_axis_of_its_own():
    assert report_card(Z[:, 0], REST, follow) == report_card(Z, REST, follow)


def test_too_few_readings_are_neither_passed_nor_failed():
    z = np.full((50, 1), np.nan)
    z[:8] = Z[:8]
    card = report_card(z, np.arange(50) < 4, follow)
    assert not card.passed and {test.passed for test in card.tests} == {None}
    assert "nothing to test: 4 readings" in str(card) and str(card).endswith("verdict: too few readings to say")
    assert card_of(ride(np.random.default_rng(3))).tests[0].passed


def test_rows_at_rest_are_not_judged():
    card = report_card(Z, np.ones(50, dtype=bool), follow)
    kinds = [test.kind for test in card.tests if test.passed is None and test.count == 0]
    assert kinds == ["size", "mean", "neighbours"]


def test_columns_have_names():
    model = LinearModel(np.eye(2), np.eye(2), np.eye(2), np.eye(2))
    z = np.cumsum(np.random.default_rng(4).normal(size=(80, 2)), axis=0)

    def follow(z):
        return model, kalman_filter(model, z[1:], start_from(model, z[0]))

    for names, told in ((["east", "north"], "east"), (None, "column 1")):
        card = report_card(z, np.arange(80) < 20, follow, names)
        assert [test.what for test in card.tests[:2]] == [
            f"size of innovations, {told}",
            f"mean of innovations, {told}",
        ]
    with pytest.raises(ValueError, match="names must be 2, one for each column, got 1"):
        report_card(z, np.arange(80) < 20, follow, ["east"])


def test_an_R_of_each_step():
    z = Z[:, 0]
    for R in (np.full((49, 1, 1), 1.0), np.ones((50, 1, 1))[1:]):
        model = MODEL.replace(R=R)
        card = report_card(z, REST, lambda z, m=model: (m, kalman_filter(m, z[1:], start_from(MODEL, z[0]))))
        np.testing.assert_allclose(
            [test.low for test in card.tests], [t.low for t in report_card(z, REST, follow).tests]
        )
        np.testing.assert_allclose(
            [test.found for test in card.tests], [t.found for t in report_card(z, REST, follow).tests]
        )


def test_angles_are_as_far_apart_as_the_model_says():
    rng = np.random.default_rng(5)
    heading = 3 + 0.02 * np.cumsum(rng.normal(size=150)) + 0.1 * rng.normal(size=150)  # π lies in the middle of it
    plain = random_walk(0.02**2, 0.01)
    how = dict(residual=lambda a, b: wrap(a - b, 2 * np.pi), state_residual=lambda a, b: wrap(a - b, 2 * np.pi))
    folding = NonlinearModel(lambda x: x, lambda x: x, plain.Q, plain.R, **how)
    rest = np.arange(150) < 0

    def kf(model, filtered):
        return report_card(heading if model is plain else wrap(heading, 2 * np.pi), rest, filtered)

    start = Gaussian(3, 0.01)
    expected = kf(plain, lambda z: (plain, kalman_filter(plain, z[1:], start)))
    card = kf(folding, lambda z: (folding, extended_kalman_filter(folding, z[1:], start)))
    assert (abs(np.diff(wrap(heading, 2 * np.pi))) > 5).any()
    for test, other in zip(card.tests, expected.tests, strict=True):
        if test.kind != "rival":
            assert test.found == pytest.approx(other.found, abs=1e-6), test.what


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


def test_a_first_row_with_a_gap():
    z = Z.copy()
    z[0] = np.nan
    with pytest.raises(ValueError, match="z must begin with a row without gaps"):
        report_card(z, REST, follow)


def test_what_counts_as_an_outlier():
    assert pytest.approx(chi2.ppf(0.999, 1), abs=5e-4) == held_back.FAR


def test_forecasts_that_differ_by_rounding_alone_are_not_compared():
    """A filter whose forecast is the last reading is neither nearer than it nor farther."""
    z = np.round(300 + np.cumsum(np.random.default_rng(3).normal(0, 0.5, (400, 1)), axis=0), 1)
    model = LinearModel([[1]], [[1]], [[0.3]], [[1e-12]])
    card = report_card(
        z,
        np.zeros(len(z), bool),
        lambda z: (model, kalman_filter(model, z[1:], Gaussian(z[0], [[1e-12]]))),
    )
    (against,) = [test for test in card.tests if test.what == "nearer than last reading"]
    assert against.passed is None and against.count == 0
