"""Open exercises: the learner writes a whole filter, and a judge runs it on recordings that nobody has seen."""

import copy
import inspect
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from kflearn.exercises._answers import arity_fault, show, told, unfinished
from kflearn.exercises._kinds import Exercise
from kflearn.exercises._messages import Outcome

RECORDINGS = 20  # on which a filter is judged


class Mark(NamedTuple):
    """What a judge looks at.

    name, unit: what the number is, and its unit.
    value(answers, truths) → number, from what the function returned for each recording and what was true.
    low, high: between which it passes; None where there is no bound.
    below, above: what to look at when it does not pass.
    """

    name: str
    value: Callable
    low: float | None = None
    high: float | None = None
    below: str = ""
    above: str = ""
    unit: str = ""

    def verdict(self, number):
        """None where the number passes; else what to look at."""
        if not np.isfinite(number):
            return "It is not finite: does the filter return a number for each reading?"
        if self.low is not None and number < self.low:
            return self.below
        return self.above if self.high is not None and number > self.high else None

    def wanted(self):
        """The bounds in words."""
        if self.low is None:
            return f"at most {self.high:g}"
        return f"at least {self.low:g}" if self.high is None else f"{self.low:g} to {self.high:g}"


class OpenExercise(Exercise):
    """The learner hands in a function that is run on hidden recordings; every design that passes is right.

    Attributes
    ----------
    passing, failing : dict
        {label: function}: designs that pass and that do not, for the tests.
    """

    subject = "the result"

    def __init__(self, solution, hints, recording, marks, form, then, passing, failing):
        super().__init__(solution, hints, {}, "", 0, 0, then)
        self.marks, self.form, self.passing, self.failing = marks, form, passing, failing
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
                answers.append(answer(*copy.deepcopy(inputs)))
            except KeyboardInterrupt:
                raise
            except BaseException as error:
                return Outcome(*told(error, answer, self._called(inputs)))
            if unfinished(answers[-1]):
                return Outcome("not attempted", "Your function returns nothing yet. Is its `return` missing?")
            if complaint := self.form(answers[-1], truth):
                return Outcome("wrong", f"For recording {number + 1} the result {complaint}.")
            if number == 0:
                printed.close_after_first(len(self.recordings))
        return self._report(answers)

    def _called(self, inputs):
        return ", ".join(f"{name} = {show(value)}" for name, value in zip(self.parameters, inputs, strict=True))

    def _report(self, answers):
        """Each mark with its number, what is wanted, and what to look at where it does not pass."""
        truths, lines, faults = [truth for _, truth in self.recordings], [], 0
        for mark in self.marks:
            number = float(mark.value(answers, truths))
            look = mark.verdict(number)
            faults += look is not None
            value = f"{number:.3g} {mark.unit}".rstrip()
            line = f"{'✓' if look is None else '✗'} {mark.name}: {value}, wanted {mark.wanted()} {mark.unit}".rstrip()
            lines.append(line + (f". {look}" if look else ""))
        first = f"On {RECORDINGS} recordings that you have not seen:"
        report = "\n".join([first, *(f"- {line}" for line in lines)])
        return self._right(f"{report}\n\n") if not faults else Outcome("wrong", report)

    def _answer(self):
        """The course's own design, for tests."""
        return self._solve


def track(states, names="mean and covariance"):
    """A form: mean (T, n) and covariance (T, n, n) for each reading, as a pair or anything with .mean and .cov."""

    def form(answer, truth):
        T = len(truth)
        if _shape(answer) == (T, states):
            return "holds the means only, and the covariance is missing: return means and covariances"
        mean, cov = pair(answer)
        if np.shape(mean) != (T, states):
            return f"should hold a mean of shape {(T, states)}, but it is of shape {np.shape(mean)}"
        if np.shape(cov) != (T, states, states):
            return f"should hold a covariance of shape {(T, states, states)}, but it is of shape {np.shape(cov)}"
        return None

    return form


def _shape(answer):
    """The shape of an array of numbers, or of lists that make one; else None."""
    try:
        return np.asarray(answer, float).shape
    except (TypeError, ValueError):
        return None


def series(answer, truth):
    """A form: one number for each reading."""
    return None if np.shape(answer) == np.shape(truth) else f"should be {np.shape(truth)}, but is {np.shape(answer)}"


def pair(answer):
    """Mean and covariance of what a filter returned."""
    if hasattr(answer, "cov") and not callable(answer.cov):
        return np.asarray(answer.mean, float), np.asarray(answer.cov, float)
    mean, cov = answer
    return np.asarray(mean, float), np.asarray(cov, float)


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
