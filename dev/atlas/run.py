"""One library on the three problems; runs in the library's own environment, and prints what it found as JSON.

python -m dev.atlas.run FILE
"""

import json
import runpy
import sys
import warnings
from importlib.metadata import version
from pathlib import Path

import numpy as np

from dev.atlas import programs
from dev.atlas.problems import BEFORE, DROPPED, GAP, STEADY, USED, WHOLE, ZERO, answers, arrays, exact

NEAR = 1e-7  # of the numbers, which are between 0.1 and 15
LOG = 0.5 * np.log(2 * np.pi)


def attempt(function, problem):
    """(means, covs, log-likelihood or None) as arrays, or the name of the error that it raised."""
    try:
        means, covs, *rest = function(**{name: value.copy() for name, value in problem.items()})
        T, n = len(problem["z"]), len(problem["x"])
        means, covs = np.reshape(np.array(means, float), (T, n)), np.reshape(np.array(covs, float), (T, n, n))
        return means, covs, float(np.squeeze(rest[0])) if rest else None
    except programs.Stopped:
        return "error"
    except Exception as error:  # whatever it raises is what we want to know
        return type(error).__name__


def near(found, right):
    """Are means and covariances those of an exact answer?"""
    return not isinstance(found, str) and all(
        np.allclose(one, two, rtol=0, atol=NEAR) for one, two in zip(found[:2], right[:2], strict=True)
    )


def start(plain, one=""):
    """When does the belief hold that this library is given?"""
    for problem in [arrays("level")] if one == "state" else [arrays("moving", **WHOLE), arrays("level")]:
        found = attempt(plain, problem)
        for (when, _), right in answers(problem).items():
            if near(found, right):
                return when
    return STEADY if far(plain, "level") < NEAR else None


def far(function, name):
    """How far its last estimate of eight times the readings of a problem without gaps is from the exact one."""
    whole = arrays(name, **(WHOLE if name == "moving" else {}))
    problem = whole | {"z": np.tile(whole["z"], (8, 1))}
    found, right = attempt(function, problem), exact(**problem)
    if isinstance(found, str):
        return float("inf")
    return max(float(np.max(np.abs(one[-1] - two[-1]))) for one, two in zip(found[:2], right[:2], strict=True))


def missing(plain, name, when):
    """What becomes of NaN in the readings of a problem."""
    problem = arrays(name, **(GAP if name == "level" else {}))
    found = attempt(plain, problem)
    if isinstance(found, str):
        return f"refused ({found})"
    means, covs, _ = found
    gone = np.isnan(means).any(axis=1)
    if gone.any():
        healthy = ", P stays finite" if np.isfinite(covs).all() else ""
        return ("NaN from there on" if gone[-1] else "NaN at that step") + healthy
    words = {USED: "the other part is used" if name == "two" else "skipped", ZERO: "read as 0",
             DROPPED: "the whole reading is dropped"}  # fmt: skip
    known = answers(problem)
    alike = (word for part, word in words.items() if (when, part) in known and near(found, known[when, part]))
    return next(alike, "wrong")


def likelihood(plain, when):
    """What its log-likelihood of the first problem is."""
    problem = arrays("level")
    found = attempt(plain, problem)[2]
    if found is None:
        return "none"
    right, count = answers(problem)[when, USED][2], len(problem["z"])
    bare = right + count * LOG
    known = {"with log 2π": right, "without log 2π": bare, "twice, without log 2π": 2 * bare, "negative": -right,
             "½ (log s² + mean of log S)": scaled_out(problem, when)}  # fmt: skip
    sign, wanted = ("minus log L, ", -right) if found * right < 0 else ("", right)
    return next(
        (word for word, value in known.items() if abs(found - value) < NEAR),
        f"{sign}wrong: {found:.3f} for {wanted:.3f}".replace("-", "−"),
    )


def scaled_out(problem, when):
    """½ (log s² + mean of log S): S the innovations' variances, s² the mean of y²/S; found from two scales of all."""
    doubled = problem | {name: 2 * problem[name] for name in "PQR"}
    once, twice = (answers(each)[when, USED][2] for each in (problem, doubled))
    count = len(problem["z"])
    squares = 2 * count * np.log(2) - 4 * (once - twice)  # the sum of y²/S
    logs = -2 * once - 2 * count * LOG - squares  # the sum of log S
    return 0.5 * (np.log(squares / count) + logs / count)


def negative(plain):
    """What it says to a variance R = −1."""
    found = attempt(plain, arrays("level", R=[[-1.0]]))
    if isinstance(found, str):
        return f"refused ({found})"
    return "NaN" if np.isnan(found[0]).any() else "no error"


def same(function, names=("level", "moving")):
    """How far the lines on the page are from the exact numbers of kflearn's convention."""
    worst = 0.0
    for name in names:
        problem = arrays(name)
        found, right = attempt(function, problem), answers(problem)[BEFORE, USED]
        if isinstance(found, str):
            return found
        worst = max(worst, *(float(np.max(np.abs(one - two))) for one, two in zip(found[:2], right[:2], strict=True)))
        if found[2] is not None:
            worst = max(worst, abs(found[2] - right[2]))
    return worst


def asked(plain, lines, version, one=""):
    """What one library does, a dictionary of words, its version, and the largest error of the lines on the page.

    one: "reading" where a reading is one number, "state" where also the state is.
    """
    if isinstance(first := attempt(plain, arrays("level")), str):
        sys.exit(f"plain raises {first} where nothing is missing")
    when = start(plain, one)
    names = ("level",) if one == "state" else ("level", "moving")
    found = {"version": version, "start": when, "likelihood": likelihood(plain, when or BEFORE)}
    found |= {"negative": negative(plain)}
    if when == STEADY:
        return found | {"gap": "no filter", "part": "no filter", "same": max(far(lines, name) for name in names)}
    part = "one number only" if one else missing(plain, "two", when)
    return found | {"gap": missing(plain, names[-1], when), "part": part, "same": same(lines, names)}


def found_in(path):
    """What a library does that is a Python module, or a program that is installed here."""
    if path.suffix == ".py":
        library = runpy.run_path(str(path))
        return asked(library["plain"], library["same"], version(library["PINS"].split("==")[0]))
    with programs.functions(path) as (plain, lines):
        return asked(plain, lines, programs.version(path), programs.read(path).one)


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    print(json.dumps(found_in(Path(sys.argv[1]))))
