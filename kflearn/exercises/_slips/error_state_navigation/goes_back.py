"""Lesson 20, `goes_back`: wrong answers, each with the sentence that it gets."""

import itertools

import numpy as np

GOES_BACK = {
    "everything": (
        [1, 1, 1, 1, 1],
        "That gives the closed loop's answer. But some of the five stand nowhere in F, so they need not go back.",
    ),
    "nothing": (
        [0, 0, 0, 0, 0],
        "That is the open loop: here a product and a sine and cosine bend the motion, so it gives another answer.",
    ),
    "the bias too": (
        [0, 0, 1, 1, 1],
        "Enough, but one too many: b enters only by ψ + w − b, a straight line whose slope is −1 wherever it is drawn.",
    ),
    "heading alone": (
        [0, 0, 1, 0, 0],
        "ψ bends, yes. But it is multiplied by 1 + s: the slope with respect to ψ is −(1 + s)·d·sin ψ, and needs the right s too.",
    ),
    "scale alone": (
        [0, 0, 0, 0, 1],
        "The scale stands in F, yes. But so does ψ, inside the sine and cosine.",
    ),
    "the sensors' faults": (
        [0, 0, 0, 1, 1],
        "Not enough: the heading itself stays wrong in the INS, and F is taken at the state of the INS.",
    ),
    "the position": (
        [1, 1, 0, 0, 0],
        "The other way round: F does not depend on east and north, so F moves a metre in the same way whether it is in the INS or in the error state.",
    ),
    "position and heading": (
        [1, 1, 1, 0, 0],
        "ψ must, east and north need not: they are only added to. And one more stands in F: look at what multiplies d.",
    ),
    "all but the bias": (
        [1, 1, 1, 0, 1],
        "Enough, but two too many: east and north are only added to, and stand nowhere in F.",
    ),
    "the other ones": (
        [1, 1, 0, 1, 0],
        "You marked those that need not go back. The question asks for those that must go back: the states that stand in F.",
    ),
    "the bias alone": (
        [0, 0, 0, 1, 0],
        "b enters only by ψ + w − b, along a straight line, and stands nowhere in F. Which two of the five stand there?",
    ),
    "heading and bias": (
        [0, 0, 1, 1, 0],
        "ψ is one of them. b enters along a straight line and may stay; but look at what multiplies d.",
    ),
    "halves": (
        [0, 0, 0.5, 0, 0.5],
        "The two are right. Mark them with 1: each goes back or not.",
    ),
    "their places": (
        [2, 4],
        "Those are the places of two states in the list. Mark all five: 1 for each that goes back, else 0.",
    ),
    "their numbers": ([3, 5], "Those are the numbers of two states. Mark all five: 1 for each that goes back, else 0."),
}


def marked():
    """Every marking of [east, north, ψ, b, s] that has no sentence of its own, with what is wrong in it."""
    for bits in itertools.product((0, 1), repeat=5):
        east, north, heading, bias, scale = bits
        words = []
        if not (heading and scale):
            words.append(
                f"{'Two are' if not (heading or scale) else 'One is'} missing: which states stand in the slopes, that is in F?"
            )
        if east or north:
            words.append("East and north are only added to: F does not depend on them.")
        if bias:
            words.append("b enters along a straight line, by ψ + w − b: F does not depend on it.")
        yield bits, " ".join(words)


def chosen_but(known):
    """The markings that are neither right nor in the table `known`."""
    taken = [list(np.ravel(value)) for value, _ in known.values()] + [[0, 0, 1, 0, 1]]
    return {str(bits): (list(bits), words) for bits, words in marked() if list(bits) not in taken}


WRONG = GOES_BACK | chosen_but(GOES_BACK)
