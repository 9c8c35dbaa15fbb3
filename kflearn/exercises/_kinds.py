"""The kinds of exercises, made by the decorator `exercise`: a value, a choice, a function."""

import copy
import inspect

import numpy as np

from kflearn.exercises import _code_of, _rules, progress
from kflearn.exercises._answers import chosen, fault, is_whole, parts, unfinished
from kflearn.exercises._explained import in_time, raised
from kflearn.exercises._messages import NOTHING, Message, Outcome
from kflearn.exercises._raised import arity_fault
from kflearn.exercises._shown import listed, show
from kflearn.exercises._solutions import for_a_cell
from kflearn.exercises._typed import typed
from kflearn.exercises._watch import SECONDS, Printed, TooLong, watched
from kflearn.exercises._words import alone, not_there, one_of, texts

TRIALS = 20  # random inputs on which a function is tried


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

    subject, wanted, otherwise, limit = "your answer", "numbers", None, True

    def __init__(self, solution, hints, wrong, unit, rtol, atol, then):
        self.name, self.module, self.question = solution.__name__, solution.__module__, inspect.getdoc(solution) or ""
        self.hints, self.wrong, self.unit, self.rtol, self.atol = list(hints), {}, unit, rtol, atol
        self.only_if = {label: words for label, (_, _, *some) in wrong.items() for words in some}
        self.wrong = {label: (answer, sentence) for label, (answer, sentence, *_) in wrong.items()}
        self.then, self._solve, self._hints_given, self._last = then, solution, 0, None

    def __repr__(self):
        return f"{self.name}: {self.question}"

    def __dir__(self):
        return ["check", "hint", "solution"]  # what the Tab key offers a learner

    def check(self, answer=...) -> Outcome:
        """Compare an answer with the right one. Whatever is handed in, the outcome explains it; nothing is raised."""
        printed = Printed()
        try:
            with watched(printed, self.limit):
                if unfinished(answer):
                    return Outcome(*NOTHING.get(type(answer), NOTHING[type(...)]))
                self._last = answer
                outcome = self._judge(answer, printed)
        except KeyboardInterrupt:  # the learner stops their own endless loop
            raise
        except TooLong:
            outcome = Outcome("raised", f"The check was stopped after {SECONDS} seconds: is there a quicker way?")
        except BaseException:  # an object that fights back when it is looked at
            outcome = Outcome("wrong", f"{self.subject} cannot be read as {self.wanted}.")
        if printed.text():
            print(printed.text(), end="")
        if outcome.status == "right":
            progress.note(self.module, self.name)
            if progress.in_notebook() and progress.place() is None:
                outcome = Outcome("right", f"{outcome.sentence} {progress.NOT_KEPT}")
        return outcome

    def hint(self, number=None) -> Message:
        """The next hint, each stronger than the last; or hint `number`, counted from 1."""
        if number is None:
            self._hints_given += 1
            number = self._hints_given
        if number in range(1, len(self.hints) + 1):
            hint = self.hints[number - 1]
            return Message(f"Hint {number} of {len(self.hints)}. {hint(self._last) if callable(hint) else hint}")
        return Message(f"There are {len(self.hints)} hints; after the last, `{self.name}.solution()` shows the answer.")

    def solution(self) -> Message:
        """The solution as it can be run in the lesson: with what it imports, and handed to `check`."""
        code = for_a_cell(self._solve, self.name)
        return Message(code, f"```python\n{code}\n```")

    def _right(self, sentence):
        """The outcome of a right answer."""
        return Outcome("right", f"{sentence} {self.then}".rstrip())

    def _compare(self, answer, right, reveal=False):
        """What tells an answer from another one, in a sentence; None if nothing does."""
        return fault(answer, right, self.subject, self.rtol, self.atol, reveal)


class ValueExercise(Exercise):
    """The learner hands in a number, an array, a Gaussian or a tuple of these."""

    def __init__(self, solution, hints, wrong, unit, rtol, atol, then, right, also=()):
        super().__init__(solution, hints, wrong, unit, 2e-3 if rtol is None else rtol, atol, then)
        self.exact = rtol is None  # then a whole number is wanted exactly
        self.right, self.also = right, list(also)
        self.subject = f"your answer (in {unit})" if unit else "your answer"
        self.wrong = {label: (value() if callable(value) else value, text) for label, (value, text) in wrong.items()}
        known = {"right answer": right} | {f"right answer {value}": value for value in self.also}
        for label, (value, _) in self.wrong.items():
            twin = next((other for other in known if self._same(value, known[other], other in self.wrong)), None)
            if twin:
                raise ValueError(f"{self.name}: the wrong answer {label!r} cannot be told from the {twin!r}")
            known[label] = value

    def _compare(self, answer, right, reveal=False):
        rtol = 5e-5 if self.exact and is_whole(right) else self.rtol
        return fault(answer, right, self.subject, rtol, self.atol, reveal, by_hand=True)

    def _judge(self, answer, printed):
        """The outcome for an answer: the sentence of a wrong one in the table, or what is wrong with it."""
        complaint = self._compare(answer, self.right)
        if complaint is None or any(self._compare(answer, other) is None for other in self.also):
            return self._right(self._confirmation())
        lessons = [sentence for value, sentence in self.wrong.values() if self._same(answer, value, True)]
        if lessons:
            rounded = " Or, if you have rounded: give three digits or more." if "rounded" in complaint else ""
            return Outcome("wrong", lessons[0] + rounded)
        if "should" in complaint or "rounded" in complaint:
            return Outcome("wrong", complaint)
        return Outcome("wrong", self._rule(answer) or (self.otherwise and self.otherwise(answer)) or complaint)

    def _same(self, answer, value, narrow):
        """Whether an answer is a value; of a wrong one it must be near, as other ideas lead to numbers close to it."""
        return self._compare(answer, value) is None and (not narrow or typed(answer, value, self.rtol / 5))

    def _rule(self, answer):
        """What a rule says of the answer; None where no rule does."""
        close = lambda one, other: ValueExercise._compare(self, one, other) is None  # noqa: E731
        named = _rules.sentence([answer], [self.right], close)
        return named and named.replace("The result", self.subject).replace("of the result", f"of {self.subject}")

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
            given, right = chosen(answer, self.choices), chosen(right, self.choices)
        except (TypeError, ValueError, OverflowError):
            given = frozenset()
        if given == right:
            return None
        if self.lines and not all(map(str.isdigit, given or {""})):
            return "give the number of the line, or a list of them."
        if not given or not (self.lines or given <= self.choices):
            return f"{not_there(answer, self.choices, len(chosen(self.right)) > 1)}choose from {self._listed(self.choices)}."
        if len(given) > 1 and len(chosen(self.right)) == 1 and not self.lines:
            return one_of(given, chosen(self.right), self.choices, self.wrong)
        if len(given) > max(3, len(self.choices) // 2):
            return "these are too many: choose."
        if stray := given - right:
            return f"the fault is not in line {listed(stray)}." if self.lines else f"it is not {self._listed(stray)}."
        return "that is a part of the answer, but there is more to it."

    def _judge(self, answer, printed):
        outcome = super()._judge(answer, printed)
        lead = alone(answer, chosen(self.right), type(self.right) is str) if outcome.status == "wrong" else ""
        return Outcome("wrong", lead + outcome.sentence) if lead else outcome

    def _same(self, answer, value, narrow):
        return self._compare(answer, value) is None

    def _rule(self, answer):
        """No rule speaks of choices."""
        return

    def _listed(self, choices):
        """Choices in order, with their letters as they were written."""
        named = [text for value in (self.right, *(value for value, _ in self.wrong.values())) for text in texts(value)]
        return listed(choices, {text.casefold(): text for text in named if len(text) > 1})

    def _confirmation(self):
        return f"The {'fault is in line' if self.lines else 'answer is'} {self._listed(chosen(self.right))}."


class FunctionExercise(Exercise):
    """The learner hands in a function; it is compared with the solution on random inputs, the same ones every time."""

    subject = "the result"

    def __init__(self, solution, hints, wrong, unit, rtol, atol, then, inputs, fixed, also=(), trials=None):
        self.also, self.slow = list(also), trials is not None
        super().__init__(solution, hints, wrong, unit, 1e-6 if rtol is None else rtol, atol, then)
        if not callable(inputs):
            raise ValueError(f"{self.name}: the solution has parameters, so inputs= must be a function of a Generator")
        rng = np.random.default_rng(20)
        self.cases = [inputs(rng) for _ in range(trials or TRIALS)]
        self.parameters, self.fixed = list(inspect.signature(solution).parameters), fixed
        if any(not isinstance(case, tuple) or arity_fault(solution, case) for case in self.cases):
            raise ValueError(f"{self.name}: inputs= must return a tuple with one value for each of {self.parameters}")

    def _judge(self, answer, printed):
        """The outcome for a function: the same, after trying it on all inputs."""
        if not callable(answer):
            return Outcome("wrong", "A function is wanted: hand in its name without parentheses, as in `check(name)`.")
        if complaint := arity_fault(answer, self.cases[0]):
            return Outcome("wrong", f"{complaint} ({', '.join(self.parameters)}).")
        results = []
        for number, case in enumerate(self.cases):
            try:
                results.append(answer(*copy.deepcopy(case)))
            except KeyboardInterrupt:
                raise
            except BaseException as error:
                known = self._until(answer, results, error)
                return Outcome("wrong", known) if known else Outcome(*raised(self, answer, error, case, number))
            if number == 0:
                printed.close_after_first(len(self.cases))
        if all(map(unfinished, results)):
            return Outcome("not attempted", _code_of.nothing(answer))
        if any(result is None for result in results) and not self._lesson(answer, results):
            return Outcome("wrong", _code_of.nothing_for(results, list(map(self._called, self.cases))))
        rights = [self._solve(*copy.deepcopy(case)) for case in self.cases]
        faults = [self._compare(*pair, reveal=True) for pair in zip(results, rights, strict=True)]
        if not any(faults):
            return self._right(f"Your function agrees with the solution on {len(self.cases)} random inputs.")
        if any(all(self._gives(other, *pair) for pair in zip(self.cases, results, strict=True)) for other in self.also):
            return self._right(f"Your way is right as well: it was tried on {len(self.cases)} random inputs.")
        return Outcome("wrong", in_time(self, answer, results, rights, faults))

    def _called(self, case):
        """A trial in words."""
        return ", ".join(f"{a} = {show(b, exact=True)}" for a, b in zip(self.parameters, case, strict=False))

    def _lesson(self, answer, results):
        """The sentence of the first wrong function in the table that gives the same results."""
        return next(self._lessons(answer, results), None)

    def _lessons(self, answer, results):
        """The sentences of the wrong functions that give the same results, as far as there are results."""
        for label, (wrong, sentence) in self.wrong.items():
            same = all(self._gives(wrong, *pair) for pair in zip(self.cases, results, strict=False))
            if same and (label not in self.only_if or _code_of.has(answer, self.only_if[label])):
                yield sentence

    def _until(self, answer, results, error):
        """A known mistake, which works until the sizes do not fit; None unless it is one only."""
        if _code_of.names_of_the_notebook(answer):  # that is said first
            return None
        case, number = self.cases[len(results)], len(results)
        alike = [label for label, (wrong, _) in self.wrong.items() if _rules.raises(wrong, case, type(error))]
        sure = {self.wrong[label][1] for label in alike if label in self.only_if}
        same = {self.wrong[label][1] for label in alike} if number else sure  # they fail at the same size
        found = [sentence for sentence in self._lessons(answer, results) if number >= 3 or sentence in sure | same]
        differs = any(not self._gives(self._solve, *pair) for pair in zip(self.cases, results, strict=False))
        return found[0] if len(set(found)) == 1 and (differs or found[0] in sure) else None

    def _gives(self, wrong, case, result):
        """Whether a wrong function gives this result; not every one can be called with all sizes.

        What should be zero comes out as a rounding error, small beside the largest number of the result.
        """
        try:
            other = wrong(*copy.deepcopy(case))
            numbers = [np.ravel(np.asarray(part, float)) for part in parts(other).values()]
            atol = 1e-9 * max((np.abs(part).max(initial=0) for part in numbers), default=0) or self.atol
            return fault(result, other, "", self.rtol, atol if self.atol is None else self.atol, False) is None
        except (ValueError, IndexError, TypeError, np.linalg.LinAlgError):
            return False

    def _answer(self):
        """The right answer, for tests."""
        return self._solve
