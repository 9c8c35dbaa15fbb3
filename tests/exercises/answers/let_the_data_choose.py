"""Lesson 24: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np
from scipy.optimize import minimize_scalar
from scipy.stats import chi2, norm

from kflearn import diffuse_start, fit, kalman_filter, random_walk, rts_smoother
from kflearn.exercises import _fitted_R
from tests.exercises.hand_in import asked


def without_the_first(y, S):
    y, S = y[1:], S[1:]
    return -0.5 * np.nansum(np.log(2 * np.pi * S) + y**2 / S)


def filled_by_a_line(y, S):
    k = np.arange(len(y))
    ok = np.isfinite(y)
    y = np.interp(k, k[ok], y[ok])
    return -0.5 * np.sum(np.log(2 * np.pi * S) + y**2 / S)


def fitted_to_bridges(z, Q):
    k, ok = np.arange(len(z)), ~np.isnan(z)
    whole = np.interp(k, k[ok], z[ok])
    return fit(lambda R: random_walk(Q, R), whole, {"R": float(np.var(whole))}).parameters["R"]


def about_the_smoothed_line(z, Q):
    R = float(np.nanvar(z))
    for _ in range(30):
        m = random_walk(Q, R)
        start = diffuse_start(m, z)
        track = kalman_filter(start.model, z[start.steps :], start.belief)
        level = rts_smoother(start.model, track).mean[:, 0]
        R = float(np.nanmean((z[start.steps :] - level) ** 2)) + 1e-12
    return R


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


def search(back=np.exp, log=1.0, nis=1.0):
    """A search for R in the logarithm, with a loop of one's own."""

    def answer(z, Q):
        steps = np.linspace(-5, 8, 300)
        return back(steps[np.argmin([minus_log_likelihood(z, Q, np.exp(step), log, nis) for step in steps])])

    return answer


NOTEBOOK_Z = "def answer(y, Q):\n    return fit(lambda R: random_walk(Q, R), z, {'R': 1.0}).parameters['R']"


def written(text, **space):
    """A function as it is written into a cell, whose names are those of the notebook."""
    space = {"np": np, "fit": fit, "random_walk": random_walk, **space}
    exec(text, space)
    return space["answer"]


def broken_off(y, S):
    total = 0.0
    for a, b in zip(y, S, strict=True):
        if np.isnan(a):
            break
        total -= 0.5 * (np.log(2 * np.pi * b) + a**2 / b)
    return total


def heights(y, S):
    p = np.exp(-(y**2) / (2 * S)) / np.sqrt(2 * np.pi * S)
    return np.log(np.nansum(p))


def one_S(y, S):
    y = y[~np.isnan(y)]
    S = np.mean(S)
    return -0.5 * (len(y) * np.log(2 * np.pi * S) + np.sum(y**2) / S)


def filled(z, Q):
    return fit(lambda R: random_walk(Q, R), np.nan_to_num(z), {"R": 1.0}).parameters["R"]


def a_decade_apart(z, Q):
    return 10.0 ** np.round(np.log10(_fitted_R.best(z, Q)))


def cut_y_alone(y, S):
    y = y[~np.isnan(y)]
    return -0.5 * np.sum(np.log(2 * np.pi * S) + y**2 / S)


def NaN_kept(z, Q):
    def minus_log_l(log_R):
        R = np.exp(log_R)
        x, P, total = z[0], R, 0.0
        for reading in z[1:]:
            P = P + Q
            S, y = P + R, reading - x
            total += 0.5 * (np.log(2 * np.pi * S) + y * y / S)
            x, P = x + P / S * y, P * R / S
        return total

    return np.exp(minimize_scalar(minus_log_l, bounds=(-10, 15), method="bounded").x)


RIGHT = [
    ("fitted_R", search()),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    (
        "one_reading",
        round(float(np.log(2 * norm.sf(3 / np.sqrt(5)))), 2),
        "The logarithm of the probability to be so far off",
    ),
    ("one_reading", float(chi2.logpdf(9 / 5, df=1)), "the chi-square density"),
    ("one_reading", -0.5 * (np.log(2 * np.pi) + 3**2 / 5), "right for a bell of variance 1"),
    ("one_reading", round(100 * np.exp(-0.9) / np.sqrt(2 * np.pi * 5), 2), "the density itself, times 100"),
    ("log_likelihood", without_the_first, "as if the first step were left out"),
    ("log_likelihood", filled_by_a_line, "as if straight lines filled the gaps"),
    ("half_missing", 4**2 / 2, "4 is the mean of y² already"),
    ("fitted_R", fitted_to_bridges, "straight lines fill the gaps"),
    ("fitted_R", about_the_smoothed_line, "from the smoothed line"),
    ("half_missing", 3.1, "it is still lower for a smaller R"),
    ("one_reading", -3.0, "your number is lower by 1.28"),
    ("one_reading", 0.0726, "probability density itself"),
    ("one_reading", -1.1394, "base of ten"),
    ("one_reading", 0.8237, "sign of the logarithm"),
    ("half_missing", 4 * 2**0.5, "nothing is rooted"),
    ("half_missing", 64, "nothing is squared"),
    ("doubled", {"A"}, "A does not come out wrong"),
    ("fitted_R", search(lambda step: step), "the logarithm of R"),
    ("fitted_R", search(log=2), "also to log 2πS"),
    ("fitted_R", search(log=0), "Is log 2πS in the sum?"),
    ("fitted_R", search(nis=0), "Is y²/S in the sum?"),
    ("fitted_R", asked("let_the_data_choose.fitted_R").wrong["Q fitted too"][0], "if Q is fitted as well"),
    ("fitted_R", written(NOTEBOOK_Z, z=np.arange(50.0)), "reads `z`, which is a name of the notebook"),
    ("fitted_R", lambda z, Q: np.nanvar(np.diff(z)), "2R + Q"),
    ("fitted_R", lambda z, Q: (np.var(np.diff(z)) - Q) / 2, "where the input holds NaN"),
    ("doubled", "B", 'several are handed in as one text, such as "XY"'),
    ("doubled", "A", 'several are handed in as one text, such as "XY"'),
    (
        "fitted_R",
        lambda z, Q: (np.var(np.diff(z[~np.isnan(z)])) - Q) / 2,
        "Over a gap the walk makes more than one step",
    ),
    ("fitted_R", lambda z, Q: 1.7 * np.nanvar(np.diff(z)), "both parts, log 2πS and y²/S?"),
    ("log_likelihood", broken_off, "as if the run ended at the first gap"),
    ("log_likelihood", heights, "the *sum* of the heights"),
    ("log_likelihood", one_S, "the mean of all S"),
    ("half_missing", 4 - 0.5, "3.5 is 4 − ½"),
    ("fitted_R", filled, "a reading of 0 stands in each gap"),
    ("fitted_R", lambda z, Q: 15099.0, "that is the lesson's Nile"),
    ("fitted_R", lambda z, Q: 5.0, "Does it come from z?"),
    ("fitted_R", a_decade_apart, "one point a decade"),
    ("log_likelihood", cut_y_alone, "the lengths differ", "raised an error"),
    ("fitted_R", NaN_kept, "A NaN in the sum", "whatever"),
]
