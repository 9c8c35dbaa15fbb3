"""Hints, solutions and how an outcome is shown; what authors did wrong is said at once."""

import re
import types

import pytest

from kflearn.exercises import engine
from kflearn.exercises.engine import Outcome, exercise
from tests.exercises import examples
from tests.exercises.examples import ALL, HINTS, correct, fused_position, larger_R, made
from tests.exercises.soundness import assert_sound
from tests.exercises.test_functions import CALLED
from tests.exercises.test_values import RIGHT, SAID


def test_hints_become_stronger_and_end():
    each = exercise(hints=HINTS)(fused_position._solve)
    assert [repr(each.hint()) for _ in HINTS] == [f"Hint {i} of 3. {hint}" for i, hint in enumerate(HINTS, 1)]
    last = "There are 3 hints; after the last, `fused_position.solution()` shows the answer."
    assert repr(each.hint()) == repr(each.hint()) == last
    assert repr(each.hint(2)) == f"Hint 2 of 3. {HINTS[1]}"
    for odd in (0, 4, -1, "x", 1.5):
        assert repr(each.hint(odd)) == last


def test_solution_is_the_source_without_decorator_and_question():
    assert repr(fused_position.solution()).splitlines() == [
        "gain = 5 / (5 + 1)  # the share of doubt in the first",
        "answer = 60 + gain * (62 - 60)",
        "exercises.fused_position.check(answer)",
    ]
    assert "# the gain P / (P + R) becomes smaller" in larger_R.solution().text
    assert correct.solution()._repr_markdown_().startswith("```python\ndef my_correct(x, P, z, R):\n    gain")


def test_display():
    outcome = fused_position.check(50)
    assert isinstance(outcome, Outcome) and repr(outcome) == outcome.text
    assert outcome._repr_markdown_() == "**✗ Not yet.** Your answer (in m) is too low."
    assert dir(fused_position) == ["check", "hint", "solution"]
    assert repr(fused_position) == "fused_position: What is the fused position of N(60, 5) and N(62, 1)?"
    assert len({lead[0] for lead in engine.LEAD.values()}) == 3 and len(set(engine.LEAD.values())) == 4


def test_texts_do_not_change_from_call_to_call():
    rows = [(each, answer) for each, answer, *_ in SAID + CALLED] + RIGHT
    texts = [each.check(answer).text for each, answer in rows if type(answer) is not types.GeneratorType]
    again = [each.check(answer).text for each, answer in rows if type(answer) is not types.GeneratorType]
    assert texts == again
    for text in texts:
        assert "0x" not in text and "/" not in re.sub(r"`[^`]*`", "", text) and "\n" not in text, text
        assert len(text) < 500


def test_exercises_of_lists_in_order_of_definition():
    assert engine.exercises_of(examples) == ALL
    assert engine.exercises_of(engine) == []


# ---- authors' errors


def test_errors_of_authors_are_refused_at_once():
    with pytest.raises(ValueError, match="'same' cannot be told from the 'right answer'"):
        made(5.0, wrong={"same": (lambda: 5.0001, "No.")})
    with pytest.raises(ValueError, match="'two' cannot be told from the 'one'"):
        made(5.0, wrong={"one": (3, "No."), "two": (3.0001, "No.")})
    with pytest.raises(ValueError, match="'B' cannot be told from the 'right answer'"):
        made("b", wrong={"B": ("B", "No.")})
    with pytest.raises(ValueError, match="needs its wrong choices"):
        made("b")
    with pytest.raises(ValueError, match="the solution has no parameters"):
        made(5.0, inputs=lambda rng: (1,))
    for inputs in (None, lambda rng: 1, lambda rng: (1, 2)):
        with pytest.raises(ValueError, match=r"square: .*inputs= must"):

            @exercise(hints=[], inputs=inputs)
            def square(x):
                """Square."""
                return x * x


def test_unsound_exercises_are_found():
    def fails(each, words):
        with pytest.raises(AssertionError, match=words):
            assert_sound(each)

    fails(made(61.7, hints=["Only one."]), "two hints")
    fails(made(61.7, hints=["", "It is so."]), "no sentence")
    fails(made(61.7, hints=["no stop here", "It is so."]), "no sentence")
    fails(made(61.7, hints=["It is 61.7 of course.", "It is so."]), "gives the answer away")
    fails(made([1.5, 2.5], hints=["It is 1.5 and 2.5.", "It is so."]), "gives the answer away")
    fails(made({3}, wrong={"4": (4, "No.")}, hints=["Look at line 3.", "It is so."]), "gives the answer away")
    fails(made(5.0, wrong={"silent": (3, "")}), "no sentence")
    assert_sound(made(12.0, hints=["See eq (12).", "Yes, 12 it is."]))

    def function(**wrong):
        @exercise(hints=["First step.", "Second step."], inputs=lambda rng: (rng.normal(),), wrong=wrong)
        def square(x):
            """Square."""
            return x * x

        return square

    assert_sound(function(half=(lambda x: x * x / 2, "Half of it.")))
    fails(function(same=(lambda x: x**2, "No.")), "'same' gets: ✓ Right")
    fails(function(one=(lambda x: x, "One."), two=(lambda x: x + 0, "Two.")), "'two' gets: ✗ Not yet. One.")
    fails(function(bad=(lambda x: 1 / 0, "Bad.")), "'bad' gets: ✗ Your code raised")
    fails(exercise(hints=["First step.", "Second step."])(lambda: 3), "question")
