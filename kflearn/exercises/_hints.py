"""Hints that look at the learner's last answer."""

import numpy as np


def is_about(answer, value) -> bool:
    """Whether an answer, which may be anything, is within 1 % of a value."""
    try:
        return bool(np.allclose(np.ravel(np.asarray(answer, float)), np.ravel(value), rtol=0.01, atol=1e-12))
    except Exception:
        return False


def after(value, words, otherwise):
    """A hint that says one thing after a certain answer, and another after any other."""
    return lambda answer: words if is_about(answer, value) else otherwise
