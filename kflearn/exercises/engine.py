"""The exercise engine: an exercise is made from its solution, and meets a wrong answer with a sentence that teaches.

What kind of exercise a solution makes follows from the solution itself:

- without parameters, returning a number, an array, a Gaussian or a tuple of these: the learner hands in that value;
- without parameters, returning a string, True or False, or a set of line numbers: the learner chooses;
- with parameters: the learner hands in a function, which is tried on random inputs.

The learner's code is never evaluated as text: a function that is handed in is called, nothing else.
"""

import ast
import contextlib
import copy
import inspect
import io
import re
import textwrap
import warnings

import numpy as np

from kflearn.exercises import progress
from kflearn.exercises._answers import arity_fault, chosen, entries, fault, listed, numbers_in, show, told, unfinished

LEAD = {
    "right": "✓ Right.",
    "wrong": "✗ Not yet.",
    "raised": "✗ Your code raised an error.",
    "not attempted": "… Not attempted yet.",
}
TRIALS = 20  # random inputs on which a function is tried


def exercise(*, hints, wrong=None, inputs=None, unit="", rtol=None, atol=None):
    """Make an exercise from its solution function, whose docstring is the question.

    hints    sentences, each stronger than the one before; only the last may name the answer
    wrong    {label: (wrong answer, sentence that teaches)}; the wrong answer is a value, or a function without
             parameters that computes it; for a function exercise it is a function that errs
    inputs   for a function exercise: a function of a numpy Generator that returns one tuple of valid inputs
             (round numbers, such as rng.integers(1, 9, 2) / 2, read well in the sentence about a failing case)
    unit     of the answer, shown beside it
    rtol     relative tolerance: 2e-3 for a value (it may be typed by hand), 1e-6 for the results of a function
    atol     absolute tolerance: 1e-12 of the largest number in the right answer
    """

    def make(solution):
        settings = (solution, hints, wrong or {}, unit, rtol, atol)
        if inspect.signature(solution).parameters:
            return FunctionExercise(*settings, inputs)
        if inputs is not None:
            raise ValueError(f"{solution.__name__}: inputs are given, but the solution has no parameters")
        right = solution()
        is_choice = isinstance(right, (str, bool, np.bool_, set, frozenset))
        return (ChoiceExercise if is_choice else ValueExercise)(*settings, right)

    return make


def exercises_of(module):
    """The exercises a module defines, in order of definition."""
    return [item for item in vars(module).values() if isinstance(item, Exercise) and item.module == module.__name__]


class Message:
    """Words for the learner, with their markdown where a notebook should show more than the plain words."""

    def __init__(self, text, markdown=None):
        self.text, self.markdown = text, markdown or text

    def __repr__(self):
        return self.text

    def _repr_markdown_(self):
        return self.markdown


class Outcome(Message):
    """What `check` found: `.status` is "not attempted", "right", "wrong" or "raised", `.text` says it in a sentence."""

    def __init__(self, status, sentence):
        if re.match(r"[a-z]+[ ,]", sentence):  # a word, and not code such as `np.std`
            sentence = sentence[0].upper() + sentence[1:]
        self.status = status
        super().__init__(f"{LEAD[status]} {sentence}", f"**{LEAD[status]}** {sentence}")


class Exercise:
    """A question with `check(answer)`, `hint()` and `solution()`; made by the decorator `exercise`."""

    subject, wanted, _untouched = "your answer", "numbers", (..., None)

    def __init__(self, solution, hints, wrong, unit, rtol, atol):
        self.name, self.module, self.question = solution.__name__, solution.__module__, inspect.getdoc(solution) or ""
        self.hints, self.wrong, self.unit, self.rtol, self.atol = list(hints), dict(wrong), unit, rtol, atol
        self._solve, self._hints_given = solution, 0

    def __repr__(self):
        return f"{self.name}: {self.question}"

    def __dir__(self):
        return ["check", "hint", "solution"]  # what the Tab key offers a learner

    def check(self, answer=...):
        """Compare an answer with the right one. Whatever is handed in, the outcome explains it; nothing is raised."""
        try:
            with _quiet():
                if unfinished(answer):
                    return Outcome("not attempted", "Put your answer in place of `...` and run the cell again.")
                outcome = self._judge(answer)
            if outcome.status == "right":
                progress.note(self.module, self.name)
            return outcome
        except KeyboardInterrupt:  # the learner stops their own endless loop
            raise
        except BaseException:  # an object that fights back when it is looked at
            return Outcome("wrong", f"{self.subject} cannot be read as {self.wanted}.")

    def hint(self, number=None):
        """The next hint, each stronger than the last; or hint `number`, counted from 1."""
        if number is None:
            self._hints_given += 1
            number = self._hints_given
        if number in range(1, len(self.hints) + 1):
            return Message(f"Hint {number} of {len(self.hints)}. {self.hints[number - 1]}")
        return Message(f"There are {len(self.hints)} hints; after the last, `{self.name}.solution()` shows the answer.")

    def solution(self):
        """The solution's source, without the decorator and the question."""
        source = textwrap.dedent(inspect.getsource(self._solve))
        function, lines = ast.parse(source).body[0], source.splitlines()
        if ast.get_docstring(function):
            del lines[function.body[0].lineno - 1 : function.body[0].end_lineno]
        code = "\n".join(lines[function.lineno - 1 :])
        return Message(code, f"```python\n{code}\n```")

    def self_test(self):
        """For the tests: the solution passes, each wrong answer gets its own sentence, the hints are sound."""
        assert self.question, f"{self.name}: the question (the solution's docstring) is missing"
        solved = self.check(self._answer())
        assert solved.status == "right", f"{self.name}: its own solution gets: {solved}"
        for label, (answer, sentence) in self.wrong.items():
            assert sentence.strip(), f"{self.name}: the wrong answer {label!r} has no sentence"
            expected, found = Outcome("wrong", sentence).text, self.check(answer).text
            assert found == expected, f"{self.name}: the wrong answer {label!r} gets: {found}"
        for untouched in self._untouched:
            assert self.check(untouched).status == "not attempted", f"{self.name}: untouched is not recognised"
        assert len(self.hints) >= 2, f"{self.name}: two hints or more are wanted"
        for hint in self.hints:
            assert re.search(r"\w \S.*[.?!…:)`]$", hint, re.S), f"{self.name}: this hint is no sentence: {hint!r}"
        for hint in self.hints[:-1]:
            assert not self._given_away_by(hint), f"{self.name}: this hint gives the answer away: {hint!r}"
        assert self.solution().text.startswith(f"def {self.name}("), f"{self.name}: the solution cannot be shown"

    def _compare(self, answer, right, reveal=False):
        return fault(answer, right, self.subject, self.rtol, self.atol, reveal)

    def _given_away_by(self, hint):
        return False


class ValueExercise(Exercise):
    """The learner hands in a number, an array, a Gaussian or a tuple of these."""

    def __init__(self, solution, hints, wrong, unit, rtol, atol, right):
        super().__init__(solution, hints, wrong, unit, 2e-3 if rtol is None else rtol, atol)
        self.right, self.subject = right, f"your answer (in {unit})" if unit else "your answer"
        self.wrong = {label: (value() if callable(value) else value, text) for label, (value, text) in wrong.items()}
        known = {"right answer": right}
        for label, (value, _) in self.wrong.items():
            twin = next((other for other in known if self._compare(value, known[other]) is None), None)
            if twin:
                raise ValueError(f"{self.name}: the wrong answer {label!r} cannot be told from the {twin!r}")
            known[label] = value

    def _judge(self, answer):
        complaint = self._compare(answer, self.right)
        if complaint is None:
            return Outcome("right", self._confirmation())
        lessons = (sentence for value, sentence in self.wrong.values() if self._compare(answer, value) is None)
        return Outcome("wrong", next(lessons, complaint))

    def _confirmation(self):
        return f"The answer is {show(self.right)} {self.unit}".rstrip() + "."

    def _answer(self):
        return self.right

    def _given_away_by(self, hint):
        found = numbers_in(hint)[:, None]
        return bool(np.isclose(found, entries(self.right), self.rtol).any(axis=0).all())


class ChoiceExercise(ValueExercise):
    """The learner chooses: a letter or word, True or False, or the lines that hold a fault.

    The choices are the right answer and those in the table of wrong ones, so every wrong choice gets its sentence.
    """

    wanted = "a choice"

    def __init__(self, *settings):
        super().__init__(*settings)
        if not self.wrong:
            raise ValueError(f"{self.name}: a choice needs its wrong choices, each with a sentence")

    @property
    def choices(self):
        return frozenset().union(*map(chosen, (self.right, *(value for value, _ in self.wrong.values()))))

    @property
    def lines(self):
        return all(choice.isdigit() for choice in chosen(self.right))

    def _compare(self, answer, right, reveal=False):
        try:
            given, right = chosen(answer), chosen(right)
        except (TypeError, ValueError, OverflowError):
            given = frozenset()
        if given == right:
            return None
        if self.lines and not all(map(str.isdigit, given or {""})):
            return "give the number of the line, or a list of them."
        if not given or not (self.lines or given <= self.choices):
            return f"choose from {listed(self.choices)}."
        if stray := given - right:
            return f"the fault is not in line {listed(stray)}." if self.lines else f"it is not {listed(stray)}."
        return "that is a part of the answer, but there is more to it."

    def _confirmation(self):
        return f"The {'fault is in line' if self.lines else 'answer is'} {listed(chosen(self.right))}."

    def _given_away_by(self, hint):
        return self.lines and {int(line) for line in chosen(self.right)} <= set(numbers_in(hint))


class FunctionExercise(Exercise):
    """The learner hands in a function; it is compared with the solution on random inputs, the same ones every time."""

    subject, _untouched = "the result", (..., None, lambda *inputs: None, lambda *inputs: ...)

    def __init__(self, solution, hints, wrong, unit, rtol, atol, inputs):
        super().__init__(solution, hints, wrong, unit, 1e-6 if rtol is None else rtol, atol)
        if not callable(inputs):
            raise ValueError(f"{self.name}: the solution has parameters, so inputs= must be a function of a Generator")
        rng = np.random.default_rng(20)
        self.cases = [inputs(rng) for _ in range(TRIALS)]
        self.parameters = list(inspect.signature(solution).parameters)
        if any(not isinstance(case, tuple) or arity_fault(solution, case) for case in self.cases):
            raise ValueError(f"{self.name}: inputs= must return a tuple with one value for each of {self.parameters}")

    def _judge(self, answer):
        if not callable(answer):
            return Outcome("wrong", "A function is wanted: hand in its name without parentheses, as in `check(name)`.")
        if complaint := arity_fault(answer, self.cases[0]):
            return Outcome("wrong", f"{complaint} ({', '.join(self.parameters)}).")
        results, complaints = [], []
        for case in self.cases:
            shown = ", ".join(f"{name} = {show(value)}" for name, value in zip(self.parameters, case, strict=False))
            try:
                results.append(answer(*copy.deepcopy(case)))
            except KeyboardInterrupt:
                raise
            except BaseException as error:
                return Outcome(*told(error, answer, shown))
            if complaint := self._compare(results[-1], self._solve(*copy.deepcopy(case)), reveal=True):
                complaints.append(f"for `{shown}` {complaint}")
        if all(map(unfinished, results)):
            return Outcome(
                "not attempted", "Your function returns nothing yet. If it is written, is its `return` missing?"
            )
        if not complaints:
            return Outcome("right", f"Your function agrees with the solution on {len(self.cases)} random inputs.")
        for wrong, sentence in self.wrong.values():
            pairs = zip(results, self.cases, strict=True)
            if all(self._compare(result, wrong(*copy.deepcopy(case))) is None for result, case in pairs):
                return Outcome("wrong", sentence)
        return Outcome("wrong", complaints[0])

    def _answer(self):
        return self._solve


@contextlib.contextmanager
def _quiet():
    """Keep to ourselves what the learner's code prints and warns of."""
    with contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        yield
