"""Hints that look at the learner's last answer."""

from collections.abc import Callable

import numpy as np

from kflearn.exercises._shown import show
from kflearn.exercises._watch import Printed, TooLong, watched


def tried(inputs, call, advice, before) -> Callable:
    """A hint that calls the learner's last function with inputs whose result can be worked out by hand.

    Parameters
    ----------
    inputs : tuple
    call : str
        How that is written, such as "wrap(-331)".
    advice : str
        What follows, whatever the result is.
    before : str
        The hint where there is no last answer, or where it raises.

    Examples
    --------
    >>> hint = tried((-331,), "wrap(-331)", "It should be 29: which turn is missing?", "What is 8 − 339?")
    >>> print(hint(lambda d: d))
    Your function gives wrap(-331) = -331. It should be 29: which turn is missing?
    >>> print(hint(None))
    What is 8 − 339?
    """

    def hint(last):
        try:
            with watched(Printed()):
                return f"Your function gives {call} = {show(last(*inputs))}. {advice}"
        except (Exception, TooLong):
            return before

    return hint


def of_choice(words, otherwise) -> Callable:
    """A hint that depends on what was chosen last: {choice: hint}."""
    return lambda last: words.get(last.strip().casefold() if isinstance(last, str) else None, otherwise)


def is_about(answer, value, within=0.01) -> bool:
    """Whether a learner's last answer, which may be anything, is this value, within one per cent or another share.

    Examples
    --------
    >>> is_about(62, 62.1), is_about("a text", 62)
    (True, False)
    """
    try:
        return bool(np.allclose(np.ravel(np.asarray(answer, float)), np.ravel(value), rtol=within, atol=1e-12))
    except Exception:  # an answer that is no number
        return False


def after(value, words, otherwise):
    """A hint that says one thing after a certain answer, and another after any other."""
    return lambda answer: words if is_about(answer, value) else otherwise


def sure(words) -> Callable:
    """A function that says something of an answer, for answers that may be anything: None where it cannot."""

    def said(answer):
        try:
            return words(np.asarray(answer, float) if np.ndim(answer) else float(answer))
        except Exception:  # an answer that is no number, or one that cannot be divided by
            return None

    return said
