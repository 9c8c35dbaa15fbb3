"""Open exercises: the learner writes a whole filter, and a judge runs it on recordings that nobody has seen."""

import contextlib
import copy
import inspect
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from kflearn.exercises._answers import unfinished
from kflearn.exercises._kinds import Exercise
from kflearn.exercises._messages import Outcome
from kflearn.exercises._raised import arity_fault, told
from kflearn.exercises._results import first_endless, of_gaps, of_rows, pair, shape_of, singular, unlike, unusual
from kflearn.exercises._shown import show
from kflearn.exercises._watch import TooLong, in_time

RECORDINGS = 20  # on which a filter is judged
LIKELY = (
    "The check sees only the results, and they do not show the cause: what stands behind a ✗ are the likeliest ones."
)


class Likely(str):
    """What to look at, where the results do not show the cause."""

    __slots__ = ()


def likely(*causes) -> Callable:
    """For a mark: likely causes, without those that the results contradict.

    causes: texts, or (text, contradicted) with contradicted(answers, recordings) → bool, as far as that can be told.
    """

    def look(answers, recordings):
        pairs = [(cause, None) if isinstance(cause, str) else cause for cause in causes]
        return Likely(" ".join(text for text, no in pairs if not (no and _told(no, answers, recordings))))

    return look


def _told(contradicted, answers, recordings):
    """Whether the results contradict a cause; where that cannot be told they do not."""
    try:
        return bool(contradicted(answers, recordings))
    except Exception:  # results of which nothing can be made
        return False


class Mark(NamedTuple):
    """What a judge looks at.

    name, unit: what the number is, and its unit.
    value(answers, truths) → number, from what the function returned for each recording and what was true.
    low, high: between which it passes; None where there is no bound.
    below, above: what to look at when it does not pass, if the results do not show it; or a function of the answers and
        the recordings that says what they show, or something `Likely`.
    """

    name: str
    value: Callable
    low: float | None = None
    high: float | None = None
    below: str | Callable = ""
    above: str | Callable = ""
    unit: str = ""

    def verdict(self, number, answers, recordings):
        """None where the number passes; else what to look at."""
        if self.low is not None and number < self.low:
            look = self.below
        elif self.high is not None and number > self.high:
            look = self.above
        else:
            return None
        return look(answers, recordings) if callable(look) else Likely(look)

    def shown(self, number, passes):
        """A number in three digits, or in as many as show that it does not pass."""
        texts = [f"{number:.{digits}g}" for digits in (3, 4, 5, 6)]
        low, high = (-np.inf if self.low is None else self.low), (np.inf if self.high is None else self.high)
        return next((text for text in texts if passes == (low <= float(text) <= high)), texts[-1])

    def wanted(self):
        """The bounds in words, with the unit."""
        if self.low == 100 and self.unit == "%":
            return "in all"
        if self.low is None:
            bounds = f"at most {self.high:g}"
        else:
            bounds = f"at least {self.low:g}" if self.high is None else f"{self.low:g} to {self.high:g}"
        return f"{bounds} {self.unit}".rstrip()


class OpenExercise(Exercise):
    """The learner hands in a function that is run on hidden recordings; every design that passes is right.

    Attributes
    ----------
    passing, failing : dict
        {label: function}: designs that pass and that do not, for the tests.
    signs : list of function(answer, answers, recordings)
        What names a mistake where a filter does not pass; the first that speaks takes the place of the marks' advice.
    """

    subject, limit = "the result", False  # each recording has a limit of its own

    def __init__(self, solution, hints, recording, marks, form, then, passing, failing, signs=()):
        super().__init__(solution, hints, {}, "", 0, 0, then)
        self.marks, self.form, self.passing, self.failing, self.signs = marks, form, passing, failing, signs
        self.parameters, self.cases = list(inspect.signature(solution).parameters), []
        rng = np.random.default_rng(2026)
        self.recordings = [recording(rng) for _ in range(RECORDINGS)]  # (inputs, truth) each

    def _judge(self, answer, printed):
        if not callable(answer):
            return Outcome("wrong", "A function is wanted: hand in its name without parentheses, as in `check(name)`.")
        if complaint := arity_fault(answer, self.recordings[0][0]):
            return Outcome("wrong", f"{complaint} ({', '.join(self.parameters)}).")
        answers = []
        for number, (inputs, truth) in enumerate(self.recordings):
            try:
                with in_time():
                    answers.append(answer(*copy.deepcopy(inputs)))
            except KeyboardInterrupt:
                raise
            except BaseException as error:
                return Outcome(*self._raised(error, answer, inputs, answers))
            if unfinished(answers[-1]):
                return Outcome("not attempted", "Your function returns nothing yet. Is its `return` missing?")
            if complaint := unusual(answers[-1]) or self.form(answers[-1], truth):
                return Outcome("wrong", f"For recording {number + 1} the result {complaint}.")
            if number == 0:
                printed.close_after_first(len(self.recordings))
        return self._report(answer, answers)

    def _raised(self, error, answer, inputs, answers):
        """The status and the sentence for a function that raised; where it is slow, also what its first results lack."""
        status, words = told(error, answer, self._called(inputs))
        if isinstance(error, TooLong) and answers and first_endless(answers[0]) is not None:
            words = f"{words} {self._endless(self.marks[0], answers)}"
        return status, words

    def _called(self, inputs):
        return ", ".join(f"{name} = {show(value)}" for name, value in zip(self.parameters, inputs, strict=True))

    def _report(self, answer, answers):
        """Each mark with its number, what is wanted, and what to look at where it does not pass."""
        truths = [truth for _, truth in self.recordings]
        try:
            numbers = [float(mark.value(answers, truths)) for mark in self.marks]
        except np.linalg.LinAlgError:
            return Outcome("wrong", singular(answers))
        for mark, number in zip(self.marks, numbers, strict=True):
            if not np.isfinite(number):
                return Outcome("wrong", self._endless(mark, answers))
        pairs = zip(self.marks, numbers, strict=True)
        looks = [mark.verdict(number, answers, self.recordings) for mark, number in pairs]
        if all(look is None for look in looks):
            return self._right("\n".join(self._lines(numbers, looks, ())) + "\n\n")
        named = self._sign(answer, answers)
        lines = self._lines(numbers, looks, () if named else looks)
        guessed = not named and any(look and isinstance(look, Likely) for look in looks)
        return Outcome("wrong", "\n".join(lines) + f"\n\n{named or (LIKELY if guessed else '')}".rstrip())

    def _lines(self, numbers, looks, said_of):
        """The report: a line for each mark, with what is said of it, nothing twice."""
        lines, said = [f"On {RECORDINGS} recordings that you have not seen:"], []
        for i, (mark, number, look) in enumerate(zip(self.marks, numbers, looks, strict=True)):
            value = f"{mark.shown(number, look is None)} {mark.unit}".rstrip()
            words = (said_of and said_of[i]) or ""
            for earlier in said:
                words = words.replace(earlier, "").strip()
            said += [words] if words else []
            line = f"- {'✓' if look is None else '✗'} {mark.name}: {value}, wanted {mark.wanted()}"
            lines.append(line + (f". {words}" if words else ""))
        return lines

    def _sign(self, answer, answers):
        """What the first sign says that recognises a mistake; None where none does."""
        for sign in self.signs:
            with contextlib.suppress(Exception):  # a result of which no sign can make anything
                if words := sign(answer, answers, self.recordings):
                    return words
        return None

    def _endless(self, mark, answers):
        """What is said of results that hold NaN: nothing else is judged then."""
        for recording, answer in enumerate(answers, 1):
            if (at := first_endless(answer)) is not None:
                inputs = self.recordings[recording - 1][0]
                what = "scan" if any(np.ndim(part) == 3 for part in inputs) else "reading"
                where = f"For recording {recording} the result is not finite at {what} {at + 1}"
                return f"{where}{of_gaps(inputs, at)} Nothing else is judged yet."
        return f"The {mark.name} is not finite: is a variance zero? Nothing else is judged yet."

    def _answer(self):
        """The course's own design, for tests."""
        return self._solve


def track(states, names="mean and covariance"):
    """A form: mean (T, n) and covariance (T, n, n) for each reading, as a pair or anything with .mean and .cov."""

    def form(answer, truth):
        T = len(truth)
        if shape_of(answer) == (T, states):
            return (
                f"is one array {(T, states)}: return the means and beside them the covariances, {(T, states, states)}"
            )
        try:
            mean, cov = pair(answer)
        except (TypeError, ValueError):  # not two arrays
            return of_rows(answer, T, states)
        if np.shape(mean)[1:] == (states,) and len(mean) < T:
            return f"has {len(mean)} rows for {T} readings: one is wanted for each, the first and those without a value too"
        if np.shape(mean) != (T, states):
            return f"should hold a mean of shape {(T, states)}, but it is of shape {np.shape(mean)}"
        if np.shape(cov) != (T, states, states):
            return f"should hold a covariance of shape {(T, states, states)}, but it is of shape {np.shape(cov)}"
        return None

    return form


def series(answer, truth):
    """A form: one number for each reading."""
    return unlike(answer, np.shape(truth))


# ---- numbers that a judge looks at


def rms(state=0, first=0, difference=np.subtract):
    """The root mean square error of a state, of all recordings together, from step `first` on."""

    def value(answers, truths):
        errors = [difference(pair(a)[0][first:, state], t[first:, state]) for a, t in zip(answers, truths, strict=True)]
        return np.sqrt(np.mean(np.square(np.concatenate(errors))))

    return value


def inside(state=0, first=0):
    """The share of steps, in per cent, at which the truth lies within ±2σ."""

    def value(answers, truths):
        found = []
        for answer, truth in zip(answers, truths, strict=True):
            mean, cov = pair(answer)
            found.append(abs(mean - truth)[first:, state] <= 2 * np.sqrt(cov[first:, state, state]))
        return 100 * np.mean(np.concatenate(found))

    return value


def nees(first=0):
    """The mean NEES, of all recordings together, divided by the number of states: 1 is honest."""

    def value(answers, truths):
        found = []
        for answer, truth in zip(answers, truths, strict=True):
            mean, cov = pair(answer)
            error = (truth - mean)[first:]
            found.append(np.sum(error * np.linalg.solve(cov[first:], error[..., None])[..., 0], axis=-1))
        return np.mean(np.concatenate(found)) / truths[0].shape[-1]

    return value
