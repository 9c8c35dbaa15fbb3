"""What the engine reads in a function that is handed in: names, sizes, arguments, expressions."""

import linecache
import re
import time

import numpy as np

import kflearn
from kflearn import boats, fit, random_walk
from kflearn.exercises import _code_of, _watch, consider_filter
from kflearn.exercises._combined import combined
from kflearn.exercises._thrown_ball_signs import by_distance
from kflearn.exercises._typed import typed as near
from kflearn.exercises.engine import exercise
from tests.exercises.hand_in import asked, assert_right, assert_told

F, K, means = np.array([[1.0, 1.0], [0.0, 1.0]]), np.array([[0.8], [0.1]]), np.arange(5.0)

PREDICTED = """
P_pred, x_pred = np.eye(2), np.zeros(2)

def correct(x, P, z, H, R):
    K = P_pred @ H.T @ np.linalg.inv(H @ P_pred @ H.T + R)
    return x_pred + K @ (z - H @ x_pred), (np.eye(2) - K @ H) @ P_pred
"""


def typed(text):
    """The last function of a text, as if it had been typed into a cell of the notebook."""
    place = f"<typed {abs(hash(text))}>"
    space = {name: getattr(kflearn, name) for name in kflearn.__all__} | {"np": np, "plane": boats.plane()}
    linecache.cache[place] = (len(text), None, text.splitlines(True), place)
    exec(compile(text, place, "exec"), space)
    return space[re.findall(r"^def (\w+)\(", text, re.MULTILINE)[-1]]


SPREADS = """
def offset(v, late, dt):
    found = [0 * np.std(v[d:]) + 0 * np.std(late[d:]) for d in range(9)]
    return np.argmin(found) * dt
"""


def _told(text):
    """What is said of a gate in a function of this text."""
    return by_distance(typed(text), [], [])


def written(text, **space):
    """A function as it is written into a cell, whose names are those of the notebook."""
    space = {"np": np, "fit": fit, "random_walk": random_walk, **space}
    exec(text, space)
    return space["answer"]


def entry_by_entry(z, H, R):
    undo = 1 / np.where(np.asarray(H) == 0, np.inf, H)
    return undo @ z, undo @ R @ undo.T


def test_figures_under_their_names_are_still_taken_where_they_are_typed():
    sheets = asked("tuning_the_ratio.data_sheets")
    assert sheets.check(dict(zip("abc", sheets.right, strict=True))).status == "right"


def test_an_argument_that_only_decides_is_not_called_lost():
    def slow_gate(away, P, Q, R):
        n = 1
        while away > 3 * np.sqrt(P + R + n * Q) and n < 7:
            n += 1
        return n + 0.5

    outcome = asked("readings_that_lie.steps_shut").check(slow_gate)
    assert "get lost" not in outcome.text and "stayed the same" not in outcome.text


def test_rows_under_their_names_are_taken_where_the_lesson_says_so():
    def figures(error):
        rows = {"position": error[..., :3], "velocity": error[..., 3:6], "acceleration": error[..., 6:]}
        return {name: np.sqrt(np.mean(np.sum(row**2, axis=-1), axis=0)) for name, row in rows.items()}

    assert_right("homing_missile.figures", figures)
    assert_told(
        "homing_missile.figures", lambda error: figures(error) | {"acceleration": figures(error)["velocity"]}, "third"
    )
    assert_told("homing_missile.start_sigma", 3.37, "the factor by which")


def test_a_known_number_must_be_near():
    assert near(0.643, 9 / 14, 4e-4) and near([1, 2.5], (1, 2.5), 4e-4) and not near(63.02, 63, 1e-4)
    assert near("text", 3, 1e-4)  # nothing to compare: `check` has said before that it is no number


def test_expressions_are_read_where_there_is_no_source():
    space = {"np": np, "F": F}
    exec("def f(x, P):\n    y = np.eye(2) @ x\n    return F @ y, any(v is np.nan for v in x), 1 / (P * x)[0]", space)
    text = _code_of.text_of(space["f"])
    assert "np.eye(2) @ x" in text and "is np.nan" in text and "(P * x)[0]" in text, text
    assert _code_of.has(space["f"], r"eye\(2\)") and not _code_of.has(space["f"], r"eye\(3\)")
    assert _code_of.names_of_the_notebook(space["f"]) == ["F"] and _code_of.has(len, "anything")


def test_names_of_the_notebook_are_named_before_a_size_that_is_typed_in():
    outcome = asked("predict_correct.correct").check(typed(PREDICTED))
    assert "`P_pred` and `x_pred`, which are names of the notebook" in outcome.text
    assert "len(x)" not in outcome.text


def test_a_size_that_is_typed_in_is_not_named_where_a_name_is_missing():
    text = "def correct(x, P, z, H, R):\n    return nowhere @ x, np.eye(2)\n"
    assert "fixed size" not in asked("predict_correct.correct").check(typed(text)).text


def test_sizes_that_fit_by_chance():
    text = "def whole(x, P, z, F, H, Q, R):\n    K = H.T * R\n    return x + K @ z, P\n"
    assert "the product of matrices is `@`" in asked("predict_correct.misprints").check(typed(text)).text
    text = "def whole(x, P, z, F, H, Q, R):\n    K = H.T + R\n    return x + K @ z, P\n"
    assert "should a product stand between them?" in asked("predict_correct.misprints").check(typed(text)).text


def test_an_argument_that_a_list_reads_is_not_called_unused():
    assert "does not depend" not in asked("when_was_it.clock_offset").check(typed(SPREADS)).text


def test_a_gate_of_so_many_pixels():
    text = "def follow(z, g, q, R):\n    return tracker(z, g, q, R, lambda y: np.hypot(*y) < 100)\n"
    assert "fixed distance in px" in _told(text)


def test_a_function_without_source_is_not_said_to_compare_with_nan():
    space = {"np": np}
    exec("def answer(time, z):\n    return np.diff(time)", space)
    assert "np.nan" not in asked("your_data.clock").check(space["answer"]).text
    exec("def answer(time, z):\n    return np.diff(time[z != np.nan])", space)
    assert "!= np.nan" in asked("your_data.clock").check(space["answer"]).text


def test_a_table_of_functions_that_err_in_several_places():
    table = combined(lambda a, b: lambda x: a * x + b, a={1: "", 2: "Twice."}, b={0: "", 5: "Five more."}, most=1)
    assert [words for _, words in table.values()] == ["Five more.", "Twice."]


def test_a_size_that_is_typed_in_is_named():
    answer = written(
        "def answer(x, dx, K, fix):\n    moved = dx + K @ (fix - x[:2] - dx[:2])\n"
        "    return x + (np.arange(9) < 4) * moved, 0 * dx"
    )
    assert "`np.arange(9)` has a fixed size" in asked("error_state_navigation.mended_fix").check(answer).text
    answer = written("def answer(x, dx, K, fix):\n    return x + dx + K @ (fix - x[:2] - dx[:2]), np.zeros(9)")
    assert "`np.zeros(9)` has a fixed size" in asked("error_state_navigation.mended_fix").check(answer).text


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


def test_a_hole_is_no_step_that_may_be_cut_off():
    outcome = asked("your_data.clock").check(lambda time, z: (s := np.diff(time[~np.isnan(z)]))[s < 10])
    assert outcome.status != "right"


def test_a_matrix_turned_over_gets_no_letter_of_another_exercise():
    def undone(z, H, R):
        pieces = np.ones_like(H) / H
        return pieces @ z, pieces @ R @ pieces.T

    def inner(z, H, R):
        def over(each):
            return 1 / each.clip(1e-3)

        return over(H) @ z, over(H) @ R @ over(H).T

    for answer in (undone, inner, entry_by_entry):
        text = asked("voltmeter.auto_start").check(answer).text
        assert "inv(S)" not in text and "only where R" not in text, text


def test_a_name_keeps_its_small_letter():
    exercise = asked("linearised_and_extended.linearised_correction")
    text = exercise.check(lambda x, P, reading, nominal: (exercise._solve(x, P, reading, nominal)[0], P)).text
    assert "Your x is right." in text


def test_an_argument_that_cancels_is_not_called_unused():
    exercise = asked("smoothing.step_back")
    cancels = exercise.check(lambda x, P, F, Q, x_next, P_next: (x - x + F @ x_next, P + F @ P_next @ F.T + Q)).text
    assert "does not depend on" not in cancels
    assert "does not depend on" in exercise.check(lambda x, P, F, Q, x_next, P_next: (x_next + x, P_next + P + Q)).text


def test_an_index_that_is_no_index_lies_beyond_no_end():
    answer = written("def answer(x, P, z, H, R, considered):\n    K = P @ H.T\n    K[z] = 0\n    return x, P")
    said = consider_filter.late_row.check(answer).sentence
    assert "IndexError" in said and "beyond the end" not in said, said
