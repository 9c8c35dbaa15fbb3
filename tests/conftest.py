"""Which tests are slow, which come first, which need something whole to be built, and what is printed if pytest breaks.

`make quick` leaves out the slow ones. `make test` takes them, and leaves out those that build the web page, a class or
slides, or that attack the course in parts: they run in CI, and wherever KFLEARN_BUILD is set (or, of the page,
KFLEARN_SITE, as `make site` does).
"""

import os

import pytest

SLOW = (  # beginnings of names: more than about a second, on a quiet machine
    "tests/course/test_bearings.py::test_whole_degrees_on_a_sparse_grid",
    "tests/course/test_copies.py::test_a_copy_does_the_same[inertial_navigation",
    "tests/course/test_navigation.py::test_open_and_closed_loop",
    "tests/course/test_navigation.py::test_what_a_turn_makes_observable",
    "tests/course/test_recordings_of_any_text.py",
    "tests/course/test_scenarios.py::test_it_simulates_and_its_filter_runs[ball",
    "tests/course/test_scenarios.py::test_it_simulates_and_its_filter_runs[inertial_navigation",
    "tests/course/test_video.py::test_own_film",
    "tests/filters/test_diffuse.py::test_structural_models",
    "tests/filters/test_ill_conditioned.py",
    "tests/filters/test_multiple_models.py::test_no_weight_ever_dies",
    "tests/filters/test_properties.py::test_a_converged_gain_changes_nothing[150]",
    "tests/filters/test_properties.py::test_a_slowly_converging_gain_is_not_held_too_early",
    "tests/targets/test_filters.py::test_among_false_readings",
    "tests/targets/test_filters.py::test_the_weights_by_counting",
    "tests/targets/test_tracker.py::test_stricter_rules_make_fewer_false_tracks_and_later_true_ones",
    "tests/test_import.py::test_it_takes_less_time_than_numpy_alone",
)
BUILT = (  # beginnings of names: a third of the time that all tests take
    "tests/dev/test_access.py",
    "tests/dev/test_assignment.py",
    "tests/dev/test_class_obstacles.py",
    "tests/dev/test_class_server.py",
    "tests/dev/test_equations.py",
    "tests/dev/test_hard_browser.py",
    "tests/dev/test_hard_lessons.py",
    "tests/dev/test_hard_security.py",
    "tests/dev/test_hard_values.py",
    "tests/dev/test_named.py::test_what_",
    "tests/dev/test_page.py",
    "tests/dev/test_pdf.py",
    "tests/dev/test_site.py",
    "tests/dev/test_slides.py",
)
FIRST = ("tests/lessons/test_lessons.py", "tests/ui/test_browser.py")  # the two longest: last, one would run alone
BROKEN = []


def pytest_collection_modifyitems(items):
    items.sort(key=lambda item: not item.nodeid.startswith(FIRST))
    all_of_them = {"KFLEARN_BUILD", "KFLEARN_SITE"} & set(os.environ)
    for item in items:
        if item.nodeid.startswith(SLOW):
            item.add_marker(pytest.mark.slow)
        if item.nodeid.startswith(BUILT) and not all_of_them:
            item.add_marker(
                pytest.mark.skip(reason="builds something whole first, or attacks the course: set KFLEARN_BUILD=1")
            )


def pytest_internalerror(excrepr):
    """A process that runs tests broke: what it said first is the cause, and everything later hides it."""
    BROKEN.append(str(excrepr))


def pytest_unconfigure(config):
    if BROKEN and not hasattr(config, "workerinput"):
        print(f"\nThe first of {len(BROKEN)} internal errors of pytest:\n{BROKEN[0]}")
