"""The running NIS and the cumulative sum, against loops in plain Python; and how often an honest filter alarms."""

import numpy as np
import pytest
from scipy import stats

from kflearn import cusum, running_nis


@pytest.fixture
def scores():
    rng = np.random.default_rng(1)
    nis = rng.chisquare(2, (3, 200))
    nis[1, 20:50] = nis[2, ::3] = np.nan
    return nis


def test_the_mean_of_a_window(scores):
    found = running_nis(scores, 10, dof=2)
    assert np.isnan(found[:, :9]).all()
    for run in range(3):
        for k in range(9, 200):
            seen = [v for v in scores[run, k - 9 : k + 1] if not np.isnan(v)]
            assert found[run, k] == pytest.approx(sum(seen) / len(seen) / 2 if seen else np.nan, nan_ok=True)
    assert np.isnan(found[1, 29:50]).all()
    assert not np.isnan(found[1, 50:]).any()
    np.testing.assert_array_equal(running_nis(scores[0], 1, dof=2), scores[0] / 2)


def test_the_share_outside_is_that_of_chi_square():
    nis = np.random.default_rng(2).chisquare(1, (400, 500))
    found = running_nis(nis, 20)[:, 19::20]  # windows that share nothing
    limit = stats.chi2.ppf(0.99, 20) / 20
    assert np.mean(found > limit) == pytest.approx(0.01, abs=4 * np.sqrt(0.01 / found.size))


def test_the_sum_begins_again_after_an_alarm(scores):
    found, alarm = cusum(scores, limit=3, slack=0.2, dof=2)
    for run in range(3):
        g = 0.0
        for k in range(200):
            value = scores[run, k]
            g = max(0.0, g + (0 if np.isnan(value) else value / 2 - 1.2))
            assert found[run, k] == pytest.approx(g, abs=1e-12)
            assert alarm[run, k] == (g > 3)
            if g > 3:
                g = 0.0
    assert alarm.any()


def test_a_higher_limit_alarms_less_and_later():
    rng = np.random.default_rng(3)
    honest, faulty = rng.chisquare(1, (200, 1000)), 2 * rng.chisquare(1, (200, 1000))
    shares = [(cusum(honest, limit)[1].mean(), cusum(faulty, limit)[1].argmax(axis=1).mean()) for limit in (5, 10, 20)]
    alarms, delays = zip(*shares, strict=True)
    assert alarms[0] > 4 * alarms[1] > 16 * alarms[2]
    assert delays[0] < delays[1] < delays[2]


REFUSED = [
    (lambda: running_nis([1.0], 2), "window must not be longer than the 1 steps, got 2"),
    (lambda: running_nis([1.0], 0), "window must be a whole number of at least 1, got 0"),
    (lambda: running_nis([-1.0], 1), "nis must be at least 0, found -1"),
    (lambda: running_nis("many", 1), "nis must consist of real numbers, found text"),
    (lambda: cusum([1.0], 0), "limit must be positive, got 0"),
    (lambda: cusum([1.0], 1, slack=0), "slack must be positive, got 0"),
    (lambda: cusum([1.0], 1, dof=0), "dof must be a whole number of at least 1, got 0"),
    (lambda: cusum(1.0, 1), r"nis must have shape \(any,\), got the number 1"),
]


@pytest.mark.parametrize("call, sentence", REFUSED)
def test_bad_input_gets_one_sentence(call, sentence):
    with pytest.raises((ValueError, TypeError), match=sentence):
        call()
