"""One library on the three problems; runs in the library's own environment, and prints what it found as JSON.

python -m dev.atlas.run FILE
"""

import json
import runpy
import sys
import warnings
from importlib.metadata import version

import numpy as np

from dev.atlas.problems import BEFORE, DROPPED, USED, ZERO, answers, arrays

NEAR = 1e-7  # of the numbers, which are between 0.1 and 15
LOG = 0.5 * np.log(2 * np.pi)


def attempt(function, problem):
    """(means, covs, log-likelihood or None) as arrays, or the name of the error that it raised."""
    try:
        means, covs, *rest = function(**{name: value.copy() for name, value in problem.items()})
        T, n = len(problem["z"]), len(problem["x"])
        means, covs = np.reshape(np.array(means, float), (T, n)), np.reshape(np.array(covs, float), (T, n, n))
        return means, covs, float(np.squeeze(rest[0])) if rest else None
    except Exception as error:  # whatever it raises is what we want to know
        return type(error).__name__


def near(found, right):
    """Are means and covariances those of an exact answer?"""
    return all(np.allclose(one, two, rtol=0, atol=NEAR) for one, two in zip(found[:2], right[:2], strict=True))


def start(plain):
    """When does the belief hold that this library is given?"""
    problem = arrays("level")
    found = attempt(plain, problem)
    return next((when for (when, _), right in answers(problem).items() if near(found, right)), None)


def missing(plain, name, when):
    """What becomes of NaN in the readings of a problem."""
    problem = arrays(name)
    found = attempt(plain, problem)
    if isinstance(found, str):
        return f"refused ({found})"
    means, covs, _ = found
    gone = np.isnan(means).any(axis=1)
    if gone.any():
        healthy = ", P stays finite" if np.isfinite(covs).all() else ""
        return ("NaN from there on" if gone[-1] else "NaN at that step") + healthy
    words = {USED: "skipped" if name == "moving" else "the other part is used", ZERO: "read as 0",
             DROPPED: "the whole reading is dropped"}  # fmt: skip
    exact = answers(problem)
    alike = (word for part, word in words.items() if (when, part) in exact and near(found, exact[when, part]))
    return next(alike, "wrong")


def likelihood(plain, when):
    """What its log-likelihood of the first problem is."""
    problem = arrays("level")
    found, right = attempt(plain, problem)[2], answers(problem)[when, USED][2]
    bare = right + len(problem["z"]) * LOG
    known = {"with log 2π": right, "without log 2π": bare, "twice, without log 2π": 2 * bare, "negative": -right}
    if found is None:
        return "none"
    return next(
        (word for word, value in known.items() if abs(found - value) < NEAR),
        f"wrong: {found:.3f} for {right:.3f}".replace("-", "−"),
    )


def negative(plain):
    """What it says to a variance R = −1."""
    found = attempt(plain, arrays("level", R=[[-1.0]]))
    if isinstance(found, str):
        return f"refused ({found})"
    return "NaN" if np.isnan(found[0]).any() else "no error"


def same(function):
    """How far the lines on the page are from the exact numbers of kflearn's convention, for the first two problems."""
    worst = 0.0
    for name in ("level", "moving"):
        problem = arrays(name)
        found, right = attempt(function, problem), answers(problem)[BEFORE, USED]
        if isinstance(found, str):
            return found
        worst = max(worst, *(float(np.max(np.abs(one - two))) for one, two in zip(found[:2], right[:2], strict=True)))
        if found[2] is not None:
            worst = max(worst, abs(found[2] - right[2]))
    return worst


def found_in(path):
    """What one library does, a dictionary of words, its version, and the largest error of the lines on the page."""
    library = runpy.run_path(str(path))
    plain = library["plain"]
    if isinstance(first := attempt(plain, arrays("level")), str):
        sys.exit(f"plain raises {first} where nothing is missing")
    when = start(plain)
    return {
        "version": version(library["PINS"].split("==")[0]),
        "start": when,
        "gap": missing(plain, "moving", when),
        "part": missing(plain, "two", when),
        "likelihood": likelihood(plain, when or BEFORE),
        "negative": negative(plain),
        "same": same(library["same"]),
    }


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    print(json.dumps(found_in(sys.argv[1])))
