"""The exercise engine: an exercise is made from its solution, and meets a wrong answer with a sentence that teaches.

What kind of exercise a solution makes follows from the solution itself:

- without parameters, returning a number, an array, a Gaussian or a tuple of these: the learner hands in that value;
- without parameters, returning a string, True or False, or a set of line numbers: the learner chooses;
- with parameters: the learner hands in a function, which is tried on random inputs.

`judged` makes an open exercise: a whole filter is handed in, and judged by its results on hidden recordings.

The learner's code is never evaluated as text: a function that is handed in is called, nothing else.
"""

import inspect
from collections.abc import Callable

import numpy as np

from kflearn.exercises._hints import sure
from kflearn.exercises._judge import Mark, OpenExercise
from kflearn.exercises._kinds import ChoiceExercise, Exercise, FunctionExercise, ValueExercise
from kflearn.exercises._messages import LEAD, Message, Outcome

__all__ = ["LEAD", "Exercise", "Mark", "Message", "Outcome", "exercise", "exercises_of", "judged"]


def exercise(
    *,
    hints,
    wrong=None,
    inputs=None,
    unit="",
    rtol=None,
    atol=None,
    then="",
    fixed=None,
    also=(),
    otherwise=None,
    trials=None,
) -> Callable:
    """Make an exercise from its solution function, whose docstring is the question.

    Parameters
    ----------
    hints : list of str or function(answer)
        Sentences, each stronger than the one before; only the last may name the answer. A function makes the sentence
        from the learner's last answer, None before there was one.
    wrong : dict, optional
        {label: (wrong answer, sentence that teaches)}. The wrong answer is a value, or a function without parameters
        that computes it; for a function exercise it is a function that errs. A third part, such as "==", is a pattern
        (`re`) that must stand in the learner's function for the sentence to be true of it.
    inputs : function(Generator), optional
        For a function exercise: returns one tuple of valid inputs. Round numbers, such as `rng.integers(1, 9, 2) / 2`,
        read well in the sentence about a failing case.
    unit : str
        The answer's unit, shown beside it.
    rtol : float, optional
        Relative tolerance: 2e-3 for a value (it may be typed by hand), 1e-6 for the results of a function.
    atol : float, optional
        Absolute tolerance: 1e-12 of the largest number in the right answer.
    then : str
        What is said after "right": a consequence, the reason or a next question. Choices need it.
    fixed : dict, optional
        {parameter: why}: inputs that are the same in all trials, or of one size.
    also : list, optional
        Other values that are right, such as one with 1.96 σ where the solution takes 2 σ; or other functions.
    otherwise : function(answer), optional
        For a value: what to say of an answer that is in no table, such as what it would mean; None for nothing. A choice
        is handed over as it is written. For a function it is called with the results and the right ones of all trials.
    trials : int, optional
        For a function that takes long: on how few inputs it is tried; then it is called no more often to explain it.

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
    ...     then="The variance of a sum is larger than each part.",
    ... )
    ... def sum_of_variances():
    ...     '''What is the variance of the sum of two errors with variances 5 m² and 1 m²?'''
    ...     return 5 + 1
    >>> sum_of_variances.check(5)
    ✗ Not yet. The second error counts too.
    >>> sum_of_variances.check(6)
    ✓ Right. The answer is 6 m². The variance of a sum is larger than each part.
    >>> sum_of_variances.hint()
    Hint 1 of 2. Variances of independent errors add up.
    """

    def make(solution):
        settings = (solution, hints, wrong or {}, unit, rtol, atol, then)
        if inspect.signature(solution).parameters:
            made = FunctionExercise(*settings, inputs, fixed or {}, also, trials)
            made.otherwise = otherwise
            return made
        if inputs is not None:
            raise ValueError(f"{solution.__name__}: inputs are given, but the solution has no parameters")
        right = solution()
        is_choice = isinstance(right, (str, bool, np.bool_, set, frozenset))
        made = (ChoiceExercise if is_choice else ValueExercise)(*settings, right, also)
        made.otherwise = otherwise if is_choice else otherwise and sure(otherwise)
        return made

    return make


def judged(*, hints, recording, marks, form, then, passing=None, failing=None, signs=()) -> Callable:
    """Make an open exercise from a solution: any function passes whose results on hidden recordings pass all marks.

    Parameters
    ----------
    hints : list of str
        As in `exercise`.
    recording : function(Generator)
        Returns (inputs, truth): the tuple that the learner's function is called with, and what the marks compare with.
    marks : list of Mark
        What is looked at. The design that ignores all measurements must not pass, nor the lesson's own example.
    form : function(result, truth)
        What is wrong with the form of a result, in words, or None; `track(n)` and `series` are such functions.
    then : str
        What is said after "right".
    passing, failing : dict, optional
        {label: function}: designs for the tests.
    signs : list of function(answer, answers, recordings), optional
        Where a filter does not pass: each may name the mistake in a sentence, or return None.

    Returns
    -------
    function
        The decorator: it turns the solution into an `OpenExercise`, whose docstring is the question.
    """

    def make(solution):
        return OpenExercise(solution, hints, recording, marks, form, then, passing or {}, failing or {}, signs)

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
