"""The measurements of `make bench`: gaps, single readings, rivals elsewhere; what disagrees or is missing is said."""

import numpy as np
import pytest

from dev.bench import filters, gaps, goals, online, playground, report, rival_races


def test_all_rivals_agree_where_readings_are_missing():
    for race in gaps.races():
        T = race.z.shape[1]
        z = race.z[:3, max(0, T // 2 - 300) :][:, :600]
        assert np.isnan(z).any(), race.name
        ours = race.ours(z).mean
        for name, (rival, _) in race.rivals.items():
            theirs = rival(z)
            assert abs(ours - theirs).max() <= race.tolerance * abs(theirs).max(), f"{race.name}, {name}"


def test_gaps_differ_from_run_to_run_and_take_whole_readings():
    z = gaps.with_gaps(np.ones((200, 100, 2)), 0.05)
    missing = np.isnan(z)
    assert (missing[..., 0] == missing[..., 1]).all()
    assert 0.04 < missing.mean() < 0.06
    assert len({run.tobytes() for run in missing}) > 190


def test_a_step_is_timed_and_checked():
    kalman, extended, _ = online.races()
    mine, theirs, difference = online.run(kalman._replace(z=kalman.z[:50]), 1)
    assert mine > 0 < theirs
    assert difference < kalman.tolerance
    with pytest.raises(AssertionError, match=r"EKF, 9 states: FilterPy disagrees by"):
        online.run(extended._replace(z=extended.z[:20], tolerance=0.0), 1)


def test_a_figure_short_of_its_goal_is_marked_and_named():
    assert goals.judged(2000.0, 2000) == "2,000"
    assert goals.judged(0.99, 1) == "**0.99, short**"
    assert goals.judged(1.6, 1.5, at_most=True) == "**1.60, short**"
    assert (goals.judged(0.5, None), goals.judged(1.5, None)) == ("**0.50**", "1.50")
    race = next(filters.races())
    lines = list(filters.table([filters.Result(race, 1.0, {"FilterPy": 999.0, "simdkalman": 2.0}, 1e-12)]))
    assert "**999, short**" in lines[-1]
    assert report.short(lines) == f"\nShort of a goal: {race.name}."
    assert report.short(["| in time | **0.50** |"]) == "\nShort of a goal: nothing."


def test_a_playground_short_of_its_goal_is_named():
    fast = playground.Round(wait=12.0, rate=40.0, each=0.95, size=5500.0, kernel=3.0)
    slow = playground.Round(wait=25.0, rate=20.0, each=0.5, size=29_000.0, kernel=11.0)
    plain = playground.Round(wait=113.0, rate=5.0, each=0.1, size=180_000.0, kernel=38.0)
    kept = {playground.PLAIN: plain, playground.LIVE: fast, playground.BEFORE: slow}
    assert report.short(list(playground.table(kept))) == "\nShort of a goal: nothing."
    short = report.short(list(playground.table(kept | {playground.LIVE: slow})))
    assert all(words in short for words in ("interact", "share of the time", "movement", "milliseconds a picture"))
    alone = list(playground.table({playground.PLAIN: plain, playground.LIVE: fast}))
    assert any("git does not know this commit here" in line for line in alone)


# ---- rivals with an environment of their own, which is not made here


@pytest.fixture
def race():
    return next(filters.races())._replace(z=next(filters.races()).z[:30])


@pytest.fixture
def elsewhere(monkeypatch):
    """Instead of a process: answers(factor) makes every rival's means those of ours times a factor."""

    def answers(factor, failed=""):
        def ask(rival, file):
            with np.load(file) as found:
                z = found["z"][: found["sample"]]
            return factor * next(filters.races()).ours(z).mean, rival_races.Answer(seconds=0.5, first=2.0, cpu=1.0)

        monkeypatch.setattr(rival_races, "environment", lambda: dict.fromkeys(rival_races.PACKAGES.values(), failed))
        monkeypatch.setattr(rival_races, "ask", ask)

    return answers


def test_a_rival_elsewhere_that_agrees_gets_its_time(race, elsewhere):
    elsewhere(1)
    rows = list(rival_races.table([race], 1))[2:]
    assert len(rows) == len(rival_races.PACKAGES)
    assert all("| 500.0 ms |" in row and "| 2.00 s | 100% |" in row for row in rows)


def test_a_rival_elsewhere_that_disagrees_is_not_timed(race, elsewhere):
    elsewhere(1.0001)
    assert all("disagrees by 1.0e-04" in row and " ms |" in row for row in list(rival_races.table([race], 1))[2:])


def test_a_package_that_cannot_be_installed_is_a_row_in_words(race, elsewhere):
    elsewhere(1, failed="no wheel for this Python")
    rows = list(rival_races.table([race], 1))[2:]
    assert all("cannot be installed: no wheel for this Python" in row for row in rows)
    assert {row.count("|") for row in rows} == {9}


def test_what_failed_is_tried_again_and_the_rest_is_kept(monkeypatch, tmp_path):
    tried, made = [], tmp_path / "made.json"
    monkeypatch.setattr(rival_races, "FOLDER", tmp_path / "rivals")
    monkeypatch.setattr(rival_races, "MADE", made)
    monkeypatch.setattr(rival_races.venv, "create", lambda folder, with_pip: None)
    monkeypatch.setattr(rival_races, "install", lambda name: tried.append(name) or ("no" if name == "dynamax" else ""))
    assert rival_races.environment()["dynamax"] == "no"
    assert len(tried) == 4
    rival_races.environment()
    assert tried[4:] == ["dynamax"]


@pytest.mark.skipif(not rival_races.MADE.exists(), reason="make bench has not made the rivals' environment")
def test_the_rivals_agree_on_a_part_of_each_race():
    for race in filters.races():
        if race.kind:
            one = race.z.shape[0] == 1
            part = race._replace(z=race.z[:, :300] if one else race.z[:2])
            _, answers = rival_races.run(part, 1, ("ssfortran", "fast-kalman"))
            assert not any("disagrees" in answer.words for answer in answers.values()), (race.name, answers)
