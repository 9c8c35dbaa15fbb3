"""The page about other libraries: its right answers, what it says of kflearn, and that it is up to date."""

import warnings
from pathlib import Path

import numpy as np
import pytest

from dev.atlas.page import LIBRARIES, parts, pinned, row, section
from dev.atlas.problems import BEFORE, DROPPED, FIRST, PROBLEMS, USED, ZERO, answers, arrays
from dev.atlas.run import attempt, found_in, likelihood, missing, negative, same, start
from kflearn import Gaussian, LinearModel, from_first_reading, kalman_filter

PAGE = (Path(__file__).parents[2] / "notebooks" / "appendix-libraries.md").read_text(encoding="utf-8")
FILES = sorted(LIBRARIES.glob("*.py"))
HERE = ["filterpy", "pykalman", "simdkalman", "statsmodels"]  # installed for other tests


def ours(F, H, Q, R, x, P, z, first=False):
    model = LinearModel(F, H, Q, R)
    track = kalman_filter(from_first_reading(model, len(z)) if first else model, z, Gaussian(x, P))
    return track.mean, track.cov, track.log_likelihood


@pytest.mark.parametrize("name", PROBLEMS)
@pytest.mark.parametrize("when", [BEFORE, FIRST])
def test_kflearn_gives_the_exact_answers(name, when):
    problem = arrays(name)
    for one, two in zip(ours(**problem, first=when == FIRST), answers(problem)[when, USED], strict=True):
        np.testing.assert_allclose(one, two, rtol=0, atol=1e-12)


def test_what_the_page_says_of_kflearn_is_found_like_the_rest():
    found = [start(ours), missing(ours, "moving", BEFORE), missing(ours, "two", BEFORE), likelihood(ours, BEFORE)]
    assert f"| `kflearn` | {' | '.join([*found, negative(ours)])} |" in PAGE
    assert same(ours) < 1e-12


def odd(part, when=BEFORE, factor=1.0):
    """A library that does one thing differently."""

    def filtered(**problem):
        exact = answers(problem)
        means, covs, density = exact[when, part] if (when, part) in exact else exact[when, USED]
        return means, covs, factor * density

    return filtered


def test_each_convention_is_seen():
    assert start(odd(USED, FIRST)) == FIRST
    assert missing(odd(DROPPED), "two", BEFORE) == "the whole reading is dropped"
    assert missing(odd(ZERO), "moving", BEFORE) == "read as 0"
    assert missing(odd(ZERO), "moving", FIRST) == "wrong"
    assert likelihood(odd(USED, factor=-1), BEFORE) == "negative"
    assert likelihood(odd(USED, factor=3), BEFORE).startswith("wrong: −41.7")
    assert same(odd(USED, FIRST)) > 0.05
    assert attempt(lambda **problem: 1 / 0, arrays("level")) == "ZeroDivisionError"


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_the_page_has_each_library_as_it_was_run(path):
    title, remarks, code = parts(path)
    version = pinned(path).split()[0].split("==")[1]
    assert f"| {title} {version} | " in PAGE
    assert f"\n### {title}\n\n{remarks} Same numbers: to " in PAGE
    assert "```python\n" + "\n".join(code) + "\n```\n" in PAGE
    assert sum(bool(line) for line in code) <= 20


def test_the_page_has_no_others():
    assert PAGE.count("\n### ") == len(FILES)
    assert f"for {len(FILES)} of them" in PAGE


@pytest.mark.parametrize("name", HERE)
def test_the_page_says_what_these_libraries_do_today(name):
    path = LIBRARIES / f"{name}.py"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = found_in(path)
    assert row(parts(path)[0], found) in PAGE
    assert found["same"] < 1e-12 and "Same numbers" in section(path, found)
