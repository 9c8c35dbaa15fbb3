"""The page about other libraries: its right answers, what it says of kflearn, and that it is up to date."""

import json
import runpy
import sys
import warnings

import numpy as np
import pytest

from dev.atlas import __main__ as atlas
from dev.atlas import programs
from dev.atlas.languages import LANGUAGES, Language
from dev.atlas.page import LIBRARIES, checksum, page, parts, paths, pinned, row, section
from dev.atlas.problems import BEFORE, DROPPED, FIRST, HALF, NONE, PROBLEMS, STEADY, USED, ZERO, answers, arrays
from dev.atlas.run import asked, attempt, found_in, likelihood, missing, negative, same, start
from kflearn import Gaussian, LinearModel, from_first_reading, kalman_filter, steady_state

PAGE = atlas.PAGE.read_text(encoding="utf-8")
FILES = paths()
OTHERS = [path for path in FILES if path.suffix != ".py"]
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
    assert likelihood(odd(USED, factor=-3), BEFORE) == "minus log L, wrong: 41.712 for 13.904"
    assert start(odd(USED, HALF)) == HALF and missing(odd(USED, HALF), "moving", HALF) == "skipped"
    assert start(odd(USED, NONE)) == start(odd(USED, NONE), "state") == NONE
    assert missing(odd(USED, NONE), "level", NONE) == "skipped"
    assert same(odd(USED, FIRST)) > 0.05
    assert attempt(lambda **problem: 1 / 0, arrays("level")) == "ZeroDivisionError"


def constant_gain(F, H, Q, R, x, P, z):
    """No start, no gaps: the gain of the steady state from the first reading on."""
    steady = steady_state(LinearModel(F, H, Q, R))
    means = []
    for reading in z:
        x = F @ x + steady.gain @ (reading - H @ F @ x)
        means.append(x)
    return means, np.repeat(steady.cov[None], len(z), axis=0)


def test_a_constant_gain_is_seen_and_asked_for_no_gap():
    found = asked(constant_gain, constant_gain, "1")
    assert found["start"] == STEADY and found["gap"] == found["part"] == "no filter"
    assert found["likelihood"] == "none" and found["same"] < 1e-10


def test_a_likelihood_whose_scale_is_taken_out_is_seen():
    problem = arrays("level")
    _, covs, _ = answers(problem)[BEFORE, USED]
    means = answers(problem)[BEFORE, USED][0].ravel()
    y = problem["z"].ravel() - np.r_[10.0, means[:-1]]
    S = np.r_[9.0, covs.ravel()[:-1]] + 4 + 4
    value = 0.5 * (np.log(np.mean(y**2 / S)) + np.mean(np.log(S)))
    assert likelihood(lambda **problem: (means, covs, value), BEFORE) == "½ (log s² + mean of log S)"


def test_the_page_is_made_of_what_was_found():
    assert page(atlas.stored(), atlas.UNTRIED) == PAGE
    assert list(atlas.stored()) == FILES


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_the_page_has_each_library_as_it_was_run(path):
    title, remarks, code = parts(path)
    found = atlas.stored()[path]
    wanted = pinned(path).split()[0].split("==") if path.suffix == ".py" else programs.read(path).needs.split("@")
    assert found["version"] in wanted or wanted == [""]
    assert f"| {title} {found['version']} | " in PAGE
    assert f"\n### {title}\n\n{remarks} Same numbers: to " in PAGE
    assert "\n" + "\n".join(code) + "\n```\n" in PAGE
    assert found["lines"] == checksum(path), "other lines were run"
    assert found["same"] < atlas.NEAR and sum(bool(line) for line in code) <= 20


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


@pytest.mark.parametrize("name", HERE)
def test_what_the_lines_on_the_page_make_of_half_a_reading(name):
    path, used = LIBRARIES / f"{name}.py", atlas.stored()[LIBRARIES / f"{name}.py"]["part"] == "the other part is used"
    lines, problem = runpy.run_path(str(path))["same"], arrays("two")
    others = ("the whole reading is dropped", "NaN from there on, P stays finite")
    assert missing(lines, "two", BEFORE) in (("the other part is used",) if used else others)
    density = attempt(lines, problem)[2]
    assert density is None or abs(density - answers(problem)[BEFORE, USED if used else DROPPED][2]) < 1e-10


@pytest.mark.timeout(300)
@pytest.mark.parametrize("path", [path for path in OTHERS if not programs.read(path).needs], ids=lambda path: path.stem)
def test_the_page_says_what_the_programs_do_that_are_here(path):
    """npm's libraries are not asked: they would be fetched."""
    recorded = atlas.stored()[path]
    if programs.version(path) != recorded["version"]:
        pytest.skip(f"{LANGUAGES[path.suffix].program} {recorded['version']} is not installed")
    found = found_in(path)
    assert row(parts(path)[0], found) in PAGE and found["same"] < 1e-10


WRITTEN = {
    ".R": "F <- matrix(c(1.0, NA, 0.5, -2.0), 2, byrow = TRUE)",
    ".inp": "matrix F = {1.0, NA; 0.5, -2.0}",
    ".m": "F = [1.0, NaN; 0.5, -2.0];",
    ".js": "const F = [[1.0, NaN], [0.5, -2.0]];",
}


@pytest.mark.parametrize("suffix", LANGUAGES)
def test_a_matrix_in_each_language(suffix):
    assert programs.written(LANGUAGES[suffix], "F", [[1, np.nan], [0.5, -2]]) == WRITTEN[suffix]


PYTHON = Language(
    program="a program nobody has",
    start=(sys.executable,),
    version=(sys.executable, "--version"),
    comment="#",
    fence="python",
    matrix="{name} = [[{rows}]]",
    between="], [",
    missing="None",
    tail="print('noise')\nprint('means', *means)\nprint('covs', *covs)\nprint('log_likelihood', 3)",
)
LIBRARY = """# Title (here)
#
# Two remarks,
# in two lines.
#
# one: state

# plain

means, covs = [z[0][0], "NA", x[1][0]], [P[0][1], "Infinity", "nan"]

# same

means, covs = z
"""


@pytest.fixture
def library(tmp_path, monkeypatch):
    """A library whose language is Python, but not run as one."""
    monkeypatch.setitem(LANGUAGES, ".txt", PYTHON)
    path = tmp_path / "here.txt"
    path.write_text(LIBRARY, encoding="utf-8")
    return path


def test_a_library_in_another_language_is_read_and_run(library):
    read = programs.read(library)
    assert read[:4] == ("Title (here)", "Two remarks, in two lines.", "", "state") and read.same == "means, covs = z"
    with programs.functions(library) as (plain, lines):
        found = plain(x=np.array([1.0, 2.0]), P=np.eye(2), z=np.array([[1.25], [np.nan]]))
        np.testing.assert_array_equal(found[0], [1.25, np.nan, 2])
        np.testing.assert_array_equal(found[1], [0, np.inf, np.nan])
        assert found[2] == [3.0]
        with pytest.raises(programs.Stopped, match="unpack"):
            lines(z=np.ones((1, 1)))
        assert attempt(lines, {"z": np.ones((1, 1)), "x": np.ones(1)}) == "error"
    assert programs.version(library) == sys.version.split()[0]


@pytest.fixture
def nothing_here(tmp_path, monkeypatch):
    """None of the programs is installed, Python's libraries are as recorded, and all was found on an old day."""
    before = {path.stem: found | {"on": "2001-02-03"} for path, found in atlas.stored().items()}
    monkeypatch.setattr(programs.shutil, "which", lambda program: None)
    monkeypatch.setattr(atlas, "ask", lambda path: before[path.stem])
    monkeypatch.setattr(atlas, "PAGE", tmp_path / "page.md")
    monkeypatch.setattr(atlas, "FOUND", tmp_path / "found.json")
    atlas.FOUND.write_text(json.dumps(before), encoding="utf-8")
    return before


def test_without_the_programs_all_rows_stay_as_they_were(nothing_here, capsys):
    atlas.main([])
    said, made = capsys.readouterr().out, atlas.PAGE.read_text(encoding="utf-8")
    after = json.loads(atlas.FOUND.read_text(encoding="utf-8"))
    for path in OTHERS:
        assert f"{path.stem}: not run, {LANGUAGES[path.suffix].program} is not installed here." in said
        assert after[path.stem] == nothing_here[path.stem] and row(parts(path)[0], nothing_here[path.stem]) in made
        assert f"{parts(path)[0]} on 2001-02-03" in made and f"{path.stem} (2001-02-03)" in said
    assert after["filterpy"]["on"] > "2020" and "FilterPy on 2001" not in made


@pytest.mark.parametrize("before", [{"lines": 0}, None])
def test_lines_that_never_ran_do_not_come_onto_the_page(nothing_here, before):
    kept = nothing_here | {"gretl": nothing_here["gretl"] | before} if before else nothing_here
    atlas.FOUND.write_text(json.dumps({n: f for n, f in kept.items() if before or n != "gretl"}), encoding="utf-8")
    with pytest.raises(SystemExit, match="The lines of gretl were never run"):
        atlas.main([])
    assert not atlas.PAGE.exists()


def test_lines_that_give_other_numbers_are_no_page(tmp_path, monkeypatch):
    monkeypatch.setattr(atlas, "PAGE", tmp_path / "page.md")
    monkeypatch.setattr(atlas, "ask", lambda path: {"same": 1e-3 if path.stem == "minkf" else 0.0})
    with pytest.raises(SystemExit, match="minkf"):
        atlas.main(["minkf", "filterpy"])
    assert not atlas.PAGE.exists()
