"""Wrong calls of measures and of what belongs to the course: each is answered by one sentence."""

import numpy as np
import pytest

from kflearn import Gaussian, chi_square_interval, coverage, homing, nees, nis, rmse, scenarios, video, whiteness
from tests.models.wrong_calls import NAMES, imm, refuses, words

RESULTS = [
    (
        "rmse of other lengths",
        lambda a: rmse(np.ones((5, 1)), np.ones((4, 1))),
        "truth",
        "(5, 1) of the estimate, got (4, 1)",
    ),
    (
        "rmse of a column and another row",
        lambda a: rmse(np.ones((5, 1)), np.ones(4)),
        "truth",
        "(5, 1) of the estimate, got (4,)",
    ),
    ("rmse of text", lambda a: rmse(a.z, "12 V"), "truth", "found text"),
    ("nees of an array", lambda a: nees(a.z, a.z), "belief", ".mean and a .cov"),
    ("nees of other states", lambda a: nees(a.track(), np.ones((5, 3))), "truth", "(2,), got (5, 3)"),
    ("nees of other steps", lambda a: nees(a.track(), np.ones((6, 2))), "truth", "(5, 2) of the estimate, got (6, 2)"),
    ("nees of certainty", lambda a: nees(Gaussian([0, 0], np.diag([1, 0])), [1, 0]), "belief", "singular"),
    (
        "nees of certainty in space",
        lambda a: nees(Gaussian([0, 0, 0], np.diag([1, 1, 0])), [1, 0, 0]),
        "belief",
        "singular",
    ),
    ("nis of an array", lambda a: nis(a.z), "track", "got ndarray"),
    ("coverage of an array", lambda a: coverage(a.z, a.z), "belief", ".mean and a .cov"),
    (
        "coverage of a column and another row",
        lambda a: coverage(Gaussian(np.ones((5, 1)), 1), np.ones(4)),
        "truth",
        "(1,), got (4,)",
    ),
    ("coverage sigmas", lambda a: coverage(a.track(), np.ones((5, 2)), -1), "sigmas", "positive, got -1"),
    ("dof zero", lambda a: chi_square_interval(0), "dof", "at least 1, got 0"),
    ("dof a fraction", lambda a: chi_square_interval(1.5), "dof", "whole number"),
    (
        "runs beyond counting",
        lambda a: chi_square_interval(1, 10**400),
        "runs",
        "below 2**63, got a number of 401 digits",
    ),
    ("runs of an interval", lambda a: chi_square_interval(1, 0), "runs", "at least 1, got 0"),
    ("probability in per cent", lambda a: chi_square_interval(1, 1, 95), "probability", "between 0 and 1, got 95"),
    ("probability one", lambda a: chi_square_interval(1, 1, 1.0), "probability", "between 0 and 1, got 1.0"),
    ("probability text", lambda a: chi_square_interval(1, 1, "high"), "probability", "found text"),
    ("whiteness of an array", lambda a: whiteness(a.z), "track", ".mean and a .cov"),
    ("whiteness of one belief", lambda a: whiteness(a.start, 1), "track", "(any, any), got (2,)"),
    ("whiteness of several models", lambda a: whiteness(imm(a), 1), "track", "imm_filter or mmae_filter has one for"),
    ("lags too many", lambda a: whiteness(a.track().innovation, 5), "lags", "smaller than the 5 steps"),
    ("lags zero", lambda a: whiteness(a.track().innovation, 0), "lags", "at least 1, got 0"),
]
COURSE = [
    ("voltmeter variant", lambda a: scenarios.voltmeter("brown"), "variant", "'constant', got 'brown'"),
    ("voltmeter R", lambda a: scenarios.voltmeter(R=0), "R", "positive definite, found 0"),
    ("voltmeter steps", lambda a: scenarios.voltmeter(steps=2.5), "steps", "got 2.5"),
    ("ship variant", lambda a: scenarios.ship("honest"), "variant", "got 'honest'"),
    ("train variance", lambda a: scenarios.train(-1), "start_speed_variance", "found -1"),
    ("steered by nobody", lambda a: homing.fly(2, 0, steered_by="nobody"), "steered_by", "'estimate', got 'nobody'"),
    ("told a lie", lambda a: homing.fly(2, 0, told="a lie"), "told", "'applied', got 'a lie'"),
    ("far away", lambda a: homing.fly(2, 0, distance="far"), "distance", "'truth', got 'far'"),
    ("no flight", lambda a: homing.fly(0), "runs", "at least 1, got 0"),
    ("growth variant", lambda a: scenarios.scalar_growth("true"), "variant", "got 'true'"),
    ("range sd", lambda a: scenarios.range_only(position_sd="wide"), "position_sd", "found text"),
    ("bearings R", lambda a: scenarios.bearings_only(R=-1), "R", "found -1"),
    ("a film without colours", lambda a: video.detect(np.zeros((2, 4, 5)), a.F), "frames", "(any, any, any, 3)"),
    (
        "another background",
        lambda a: video.detect(np.zeros((2, 4, 5, 3)), np.zeros((4, 4, 3))),
        "background",
        "(4, 5, 3)",
    ),
    ("a film of no frames", lambda a: video.render(0), "steps", "at least 1, got 0"),
    ("drive backwards", lambda a: scenarios.inertial_navigation("reverse"), "variant", "got 'reverse'"),
    ("noise variant", lambda a: scenarios.unknown_noise("loud"), "variant", "got 'loud'"),
    ("ball variant", lambda a: scenarios.ball("red"), "variant", "got 'red'"),
    ("ship variants", lambda a: scenarios.ship(["published"]), "variant", "got ['published']"),
    ("drive with a word", lambda a: scenarios.inertial_navigation().simulate(rng="a"), "rng", "a seed, got 'a'"),
    ("fly with a word", lambda a: homing.fly(2, "a"), "rng", "a seed, got 'a'"),
    ("film with a word", lambda a: video.render(rng="a"), "rng", "a seed, got 'a'"),
    ("steered by a list", lambda a: homing.fly(2, 0, steered_by=["truth"]), "steered_by", "got ['truth']"),
]


@pytest.mark.parametrize(NAMES, RESULTS + COURSE, ids=words)
def test_wrong_call(id, call, name, fragment):
    refuses(call, name, fragment)
