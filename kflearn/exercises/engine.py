"""The exercise engine: an exercise is made from its solution, and meets a wrong answer with a sentence that teaches.

What kind of exercise a solution makes follows from the solution itself:

- without parameters, returning a number, an array, a Gaussian or a tuple of these: the learner hands in that value;
- without parameters, returning a string, True or False, or a set of line numbers: the learner chooses;
- with parameters: the learner hands in a function, which is tried on random inputs.

The learner's code is never evaluated as text: a function that is handed in is called, nothing else.
"""

import ast
import copy
import inspect
import textwrap
from collections.abc import Callable

import numpy as np

from kflearn.exercises import progress
from kflearn.exercises._answers import arity_fault, chosen, fault, listed, quiet, show, told, unfinished
from kflearn.exercises._messages import LEAD, Message, Outcome

__all__ = ["LEAD", "Exercise", "Message", "Outcome", "exercise", "exercises_of"]

TRIALS = 20  # random inputs on which a function is tried


def exercise(*, hints, wrong=None, inputs=None, unit="", rtol=None, atol=None) -> Callable:
    """Make an exercise from its solution function, whose docstring is the question.

    Parameters
    ----------
    hints : list of str
        Sentences, each stronger than the one before; only the last may name the answer.
    wrong : dict, optional
        {label: (wrong answer, sentence that teaches)}. The wrong answer is a value, or a function without parameters
        that computes it; for a function exercise it is a function that errs.
    inputs : function(Generator), optional
        For a function exercise: returns one tuple of valid inputs. Round numbers, such as `rng.integers(1, 9, 2) / 2`,
        read well in the sentence about a failing case.
    unit : str
        The answer's unit, shown beside it.
    rtol : float, optional
        Relative tolerance: 2e-3 for a value (it may be typed by hand), 1e-6 for the results of a function.
    atol : float, optional
        Absolute tolerance: 1e-12 of the largest number in the right answer.

    Returns
    -------
    function
        The decorator: it turns the solution into an `Exercise`.

    Raises
    ------
    ValueError
        Where inputs are given without need or are missing, where a wrong answer equals the right one or another
        wrong one, and where a choice has no wrong choices.

    Examples
    --------
    >>> from kflearn.exercises.engine import exercise
    >>> @exercise(
    ...     hints=["Variances of independent errors add up.", "5 + 1 = 6."],
    ...     wrong={"only the first": (5, "The second error counts too.")},
    ...     unit="m²",
    ... )
    ... def sum_of_variances():
    ...     '''What is the variance of the sum of two errors with variances 5 m² and 1 m²?'''
    ...     return 5 + 1
    >>> sum_of_variances.check(5)
    ✗ Not yet. The second error counts too.
    >>> sum_of_variances.check(6)
    ✓ Right. The answer is 6 m².
    >>> sum_of_variances.hint()
    Hint 1 of 2. Variances of independent errors add up.
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


def exercises_of(module) -> list["Exercise"]:
    """The exercises that a module defines, in order of definition.

    Examples
    --------
    >>> from kflearn.exercises import voltmeter
    >>> all(each.module == voltmeter.__name__ for each in exercises_of(voltmeter))
    True
    """
    return [item for item in vars(module).values() if isinstance(item, Exercise) and item.module == module.__name__]


class Exercise:
    """A question with `check(answer)`, `hint()` and `solution()`; made by the decorator `exercise`.

    Attributes
    ----------
    name, module, question : str
        The solution's name, where it is defined, and its docstring.
    hints : list of str
    wrong : dict
        {label: (wrong answer, sentence)}
    unit : str
    rtol, atol : float
    """

    subject, wanted = "your answer", "numbers"

    def __init__(self, solution, hints, wrong, unit, rtol, atol):
        self.name, self.module, self.question = solution.__name__, solution.__module__, inspect.getdoc(solution) or ""
        self.hints, self.wrong, self.unit, self.rtol, self.atol = list(hints), dict(wrong), unit, rtol, atol
        self._solve, self._hints_given = solution, 0

    def __repr__(self):
        return f"{self.name}: {self.question}"

    def __dir__(self):
        return ["check", "hint", "solution"]  # what the Tab key offers a learner

    def check(self, answer=...) -> Outcome:
        """Compare an answer with the right one. Whatever is handed in, the outcome explains it; nothing is raised."""
        try:
            with quiet():
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

    def hint(self, number=None) -> Message:
        """The next hint, each stronger than the last; or hint `number`, counted from 1."""
        if number is None:
            self._hints_given += 1
            number = self._hints_given
        if number in range(1, len(self.hints) + 1):
            return Message(f"Hint {number} of {len(self.hints)}. {self.hints[number - 1]}")
        return Message(f"There are {len(self.hints)} hints; after the last, `{self.name}.solution()` shows the answer.")

    def solution(self) -> Message:
        """The solution's source, without the decorator and the question."""
        source = textwrap.dedent(inspect.getsource(self._solve))
        function, lines = ast.parse(source).body[0], source.splitlines()
        if ast.get_docstring(function):
            del lines[function.body[0].lineno - 1 : function.body[0].end_lineno]
        code = "\n".join(lines[function.lineno - 1 :])
        return Message(code, f"```python\n{code}\n```")

    def _compare(self, answer, right, reveal=False):
        """What tells an answer from another one, in a sentence; None if nothing does."""
        return fault(answer, right, self.subject, self.rtol, self.atol, reveal)


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
        """The outcome for an answer: the sentence of a wrong one in the table, or what is wrong with it."""
        complaint = self._compare(answer, self.right)
        if complaint is None:
            return Outcome("right", self._confirmation())
        lessons = (sentence for value, sentence in self.wrong.values() if self._compare(answer, value) is None)
        return Outcome("wrong", next(lessons, complaint))

    def _confirmation(self):
        """What is said to a right answer."""
        return f"The answer is {show(self.right)} {self.unit}".rstrip() + "."

    def _answer(self):
        """The right answer, for tests."""
        return self.right


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
    def choices(self) -> frozenset:
        """The right choices and the wrong ones."""
        return frozenset().union(*map(chosen, (self.right, *(value for value, _ in self.wrong.values()))))

    @property
    def lines(self) -> bool:
        """Whether lines of a program are chosen."""
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


class FunctionExercise(Exercise):
    """The learner hands in a function; it is compared with the solution on random inputs, the same ones every time."""

    subject = "the result"

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
        """The outcome for a function: the same, after trying it on all inputs."""
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
        """The right answer, for tests."""
        return self._solve
