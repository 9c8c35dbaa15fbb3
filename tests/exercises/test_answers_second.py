"""What answers must get that a third group of strangers handed in, for the second set of their answers."""

import time
from importlib import import_module

import numpy as np
import pytest

from kflearn import fit, random_walk
from kflearn.exercises import _fitted_R, _unknown_sensor, _watch
from kflearn.exercises.engine import exercise


def asked(name):
    module, exercise = name.split(".")
    return getattr(import_module(f"kflearn.exercises.{module}"), exercise)


def written(text, **space):
    """A function as it is written into a cell, whose names are those of the notebook."""
    space = {"np": np, "fit": fit, "random_walk": random_walk, **space}
    exec(text, space)
    return space["answer"]


def search(back=np.exp, log=1.0, nis=1.0):
    """A search for R in the logarithm, with a loop of one's own."""

    def answer(z, Q):
        steps = np.linspace(-5, 8, 300)
        return back(steps[np.argmin([minus_log_likelihood(z, Q, np.exp(step), log, nis) for step in steps])])

    return answer


def minus_log_likelihood(z, Q, R, log, nis):
    first = np.flatnonzero(~np.isnan(z))[0]
    x, P, total = z[first], R, 0
    for seen in z[first + 1 :]:
        P = P + Q
        if not np.isnan(seen):
            S, y = P + R, seen - x
            total += log * np.log(2 * np.pi * S) + nis * y**2 / S
            x, P = x + P / S * y, P * R / S
    return total


def learns(**settings):
    return lambda z, F, Q, mean, cov: _unknown_sensor.learn(z, F, Q, mean, cov, **settings)


def variance_of_the_readings(z, F, Q, mean, cov):
    x, P, recent, means, covs = mean, cov, [], [], []
    for seen in z:
        x, P = F @ x, F @ P @ F.T + Q
        recent.append(seen)
        if not np.isnan(seen):
            R = np.nanvar(recent[-31:]) if len(recent) > 30 else 1.0
            K = P[:, 0] / (P[0, 0] + R)
            x, P = x + K * (seen - x[0]), P - np.outer(K, P[0])
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)


NOTEBOOK_Z = "def answer(y, Q):\n    return fit(lambda R: random_walk(Q, R), z, {'R': 1.0}).parameters['R']"
RIGHT = [
    ("let_the_data_choose.fitted_R", search()),
    ("adaptive.unknown_sensor", learns(window=30, floor=0.3)),
]
ANSWERS = [
    ("let_the_data_choose.one_reading", 0.0726, "probability density itself"),
    ("let_the_data_choose.one_reading", -1.1394, "base of ten"),
    ("let_the_data_choose.one_reading", 0.8237, "sign of the logarithm"),
    ("let_the_data_choose.half_missing", 4 * 2**0.5, "nothing is rooted"),
    ("let_the_data_choose.half_missing", 64, "nothing is squared"),
    ("let_the_data_choose.doubled", {"A"}, "A does not come out wrong"),
    ("let_the_data_choose.fitted_R", search(lambda step: step), "the logarithm of R"),
    ("let_the_data_choose.fitted_R", search(log=2), "also to log 2πS"),
    ("let_the_data_choose.fitted_R", search(log=0), "Is log 2πS in the sum?"),
    ("let_the_data_choose.fitted_R", search(nis=0), "Is y²/S in the sum?"),
    ("let_the_data_choose.fitted_R", lambda z, Q: _fitted_R.WRONG["Q fitted too"][0](z, Q), "fitted Q as well"),
    ("let_the_data_choose.fitted_R", written(NOTEBOOK_Z, z=np.arange(50.0)), "reads `z`, which is a name of the notebook"),
    ("let_the_data_choose.fitted_R", lambda z, Q: np.nanvar(np.diff(z)), "2R + Q"),
    ("let_the_data_choose.fitted_R", lambda z, Q: (np.var(np.diff(z)) - Q) / 2, "where the input holds NaN"),
    ("adaptive.unknown_sensor", learns(window=30, floor=0.01), "Give R̂ a floor of 0.05 m² or more"),
    ("adaptive.unknown_sensor", learns(window=150), "until then nothing is learnt"),
    ("adaptive.unknown_sensor", learns(window=1, R=1.0), "of too few squared innovations"),
    ("adaptive.unknown_sensor", variance_of_the_readings, "Is that the variance of the readings?"),
]


@pytest.mark.parametrize(("name", "answer"), RIGHT)
def test_right(name, answer):
    assert asked(name).check(answer).status == "right"


@pytest.mark.parametrize(("name", "answer", "words"), ANSWERS)
def test_own_sentence(name, answer, words):
    outcome = asked(name).check(answer)
    assert outcome.status == "wrong" and words in outcome.text, outcome.text


def test_the_arguments_have_the_names_that_the_learner_gave_them():
    outcome = asked("let_the_data_choose.fitted_R").check(written(NOTEBOOK_Z, z=np.arange(50.0)))
    assert "It is given y, Q." in outcome.text


def test_no_time_to_explain_is_no_error_of_the_learner(monkeypatch):
    """Whether the explanation takes too long is no matter of the learner's code, which has done its work."""
    monkeypatch.setattr(_watch, "SECONDS", 0.3)

    def endless(x):
        while True:
            time.sleep(0.01)

    @exercise(hints=["A.", "B."], inputs=lambda rng: (int(rng.integers(1, 9)),), wrong={"endless": (endless, "No.")})
    def twice(x):
        """Twice x?"""
        return 2 * x

    outcome = twice.check(lambda x: 2 * x + x**3)
    assert outcome.status == "wrong" and "was expected" in outcome.text, outcome.text
