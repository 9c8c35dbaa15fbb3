"""Exercises of every kind, and answers that fight back, for the tests of the engine."""

from typing import NamedTuple

import numpy as np

from kflearn.exercises.engine import exercise


class Belief(NamedTuple):
    """Stands in for a Gaussian: anything with a mean and a cov."""

    mean: object
    cov: object


HINTS = ["Which of the two do you trust more?", "Weigh with the variances, eq (12).", "It is 60 + 5/6 × 2 = 61.67."]


@exercise(
    wrong={
        "weighed with σ": (lambda: 60 + 2 * 5**0.5 / (5**0.5 + 1), "You weighed with σ; eq (12) wants variances σ²."),
        "K for 1 − K": (60 + 1 / 6 * 2, "You gave the weight of the second source to the first."),
        "handed in both": ([60, 62], "These are the two sources: fuse them."),
    },
    hints=HINTS,
    unit="m",
)
def fused_position():
    """What is the fused position of N(60, 5) and N(62, 1)?"""
    gain = 5 / (5 + 1)  # the share of doubt in the first
    return 60 + gain * (62 - 60)


@exercise(
    wrong={"forgot F": (np.array([[1, 0.5], [0, 3]]), "Moving mixes position and velocity: F P Fᵀ.")},
    hints=["Multiply three matrices first.", "Do F P first."],
)
def lopsided():
    """What is F P Fᵀ + D for F = [[1, 2], [0, 1]], P = diag(1, 3), D = [[0, 0.5], [0, 0]]?"""
    F = np.array([[1.0, 2.0], [0.0, 1.0]])
    return F @ np.diag([1.0, 3.0]) @ F.T + np.array([[0, 0.5], [0, 0]])


@exercise(hints=["Fuse the two means.", "Fuse the two variances."])
def fused_belief():
    """What is the fused belief?"""
    return Belief(np.array([1.0, 2.0]), np.array([[2.0, 0.3], [0.3, 1.0]]))


def beliefs(rng):
    mean, z = rng.normal(size=2)
    P, R = rng.uniform(0.5, 3, 2)
    return mean, P, z, R


@exercise(
    wrong={
        "wrong sign": (lambda x, P, z, R: (x + P / (P + R) * (x - z), P * R / (P + R)), "The innovation is z − x."),
        "K for 1 − K": (lambda x, P, z, R: (x + R / (P + R) * (z - x), P * R / (P + R)), "That is 1 − K."),
        "P left as it was": (lambda x, P, z, R: (x + P / (P + R) * (z - x), P), "A measurement makes P smaller."),
        "only the mean": (lambda x, P, z, R: x + P / (P + R) * (z - x), "Return the variance too."),
    },
    hints=["First the gain K.", "K = P / (P + R)."],
    inputs=beliefs,
)
def correct(x, P, z, R):
    """Write correct(x, P, z, R): it returns the corrected mean and variance."""
    gain = P / (P + R)
    return x + gain * (z - x), (1 - gain) * P


@exercise(
    wrong={"no transpose": (lambda F, P: F @ P @ F, "The second F is transposed: F P Fᵀ.")},
    hints=["It has three factors.", "F P and one more."],
    inputs=lambda rng: (rng.normal(size=(2, 2)), np.eye(2) * rng.uniform(1, 2)),
)
def spread(F, P):
    """Write spread(F, P), the covariance after x ↦ F x."""
    return F @ P @ F.T


@exercise(
    wrong={"a": ("a", "That would be more trust in the model."), "c": ("c", "Q does not measure the sensor.")},
    hints=["What does R stand for?", "R is the sensor's variance."],
)
def larger_R():
    """A larger R makes the filter … (a) quicker, (b) slower, (c) neither?"""
    # the gain P / (P + R) becomes smaller
    return "b"


@exercise(
    wrong={"the gain": (2, "Line 2 is eq (7) as it should be."), "one of two": (4, "Right, but it has a companion.")},
    hints=["Look at the order.", "Something is used before it is made."],
)
def bug_hunt():
    """Which lines hold the fault?"""
    return {4, 7}


@exercise(wrong={"no": (False, "The mean of n readings has the variance σ²/n.")}, hints=["Try it.", "Count the σs."])
def true_or_false():
    """True or False: more readings make the mean better."""
    return True


ALL = [fused_position, lopsided, fused_belief, correct, spread, larger_R, bug_hunt, true_or_false]
VALUES = [fused_position, lopsided, fused_belief, larger_R, bug_hunt, true_or_false]
FUNCTIONS = [correct, spread]


def made(value, **options):
    def asked():
        """What?"""
        return value

    return exercise(**{"hints": ["First step.", "Second step."], **options})(asked)


class Hostile:
    """Fights back whatever is done to it."""

    def _refuse(self, *args, **kwargs):
        raise RuntimeError("no")

    __array__ = __repr__ = __str__ = __eq__ = __ne__ = __float__ = __int__ = __index__ = __len__ = __iter__ = _refuse
    __hash__ = __bool__ = __getitem__ = __deepcopy__ = __copy__ = __format__ = __lt__ = __gt__ = __contains__ = _refuse
    __getattr__ = _refuse


class HostileClass:
    @property
    def __class__(self):
        raise RuntimeError("no")


class Fighter(Exception):
    def __str__(self):
        raise RuntimeError("no")


class Sequence:
    def __len__(self):
        return 10**12

    def __getitem__(self, i):
        return self


def loop_list():
    loop = [1.0]
    loop.append(loop)
    return loop
