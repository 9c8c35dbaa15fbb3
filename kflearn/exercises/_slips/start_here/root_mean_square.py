"""Lesson 0, `root_mean_square`: wrong answers, each with the sentence that it gets."""

import numpy as np

SCALED = "You multiplied the mean of |error| by a fixed number. An rms is something else: square, take the mean, then the root."


WRONG = {
    "as published": (
        lambda error: np.mean(abs(error)),
        "That is still the mean absolute error. The square must come before the mean, and the root after it.",
    ),
    "root forgotten": (
        lambda error: np.mean(error**2),
        "That is the mean square, in m². Take the root to come back to metres.",
    ),
    "standard deviation": (
        lambda error: np.std(error),
        "That is the standard deviation (`np.std`). It leaves out the mean error, so no offset shows: the torn tape would look as good as a whole one.",
    ),
    "variance": (
        lambda error: np.var(error),
        "That is the variance (`np.var`). It leaves out the mean error, so no offset shows; and it is in m².",
    ),
    "root of the sum": (
        lambda error: np.sqrt(np.sum(error**2)),
        "That is the root of the sum of the squares, which grows with every reading. Take their mean.",
    ),
    "root of the sum, divided": (
        lambda error: np.sqrt(np.sum(error**2)) / len(error),
        "You divided by the number of errors twice, or after the root. Divide once, before the root: that is the mean of the squares.",
    ),
    "n − 1": (
        lambda error: np.sqrt(np.sum(error**2) / (len(error) - 1)),
        "Dividing by n − 1 is for distances from a mean of the same readings. These are errors against the truth: divide by n.",
    ),
    "plain mean": (
        lambda error: np.mean(error),
        "In the plain mean errors of +5 and −5 m cancel. Square first, and nothing cancels.",
    ),
    "size of the mean": (
        lambda error: np.sqrt(np.mean(error) ** 2),
        "That is the size of the mean error, in which errors of +5 and −5 m cancel. Square each error first; then take the mean, and the root.",
    ),
    "largest": (
        lambda error: np.max(abs(error)),
        "That is the largest error: one bad reading decides everything.",
    ),
    "mean squared": (
        lambda error: np.mean(error) ** 2,
        "That is the square of the mean error, in which errors of +5 and −5 m cancel. Square each error, then take the mean, then the root.",
    ),
    "no square": (
        lambda error: np.sqrt(np.mean(abs(error))),
        "You took the root, but nothing was squared before: square each error first.",
    ),
    "variance for the mean square": (
        lambda error: np.sqrt(np.var(error, ddof=1) if len(error) > 1 else 0.0),
        "You took the scatter about the mean error. An error that all readings share does not show in it: do not subtract the mean.",
    ),
    "sum of squares": (
        lambda error: np.sum(error**2),
        "That is the sum of the squares: take their mean, and then the root.",
    ),
    "root of the mean": (
        lambda error: np.sqrt(abs(np.mean(error))),
        "You never squared: in the plain mean errors of +5 and −5 m cancel. Square each error first.",
    ),
    "median": (
        lambda error: np.median(abs(error)),
        "That is the median of the sizes. The name says: root, of the mean, of the squares.",
    ),
    "minus 40": (
        lambda error: np.sqrt(np.mean((error - 40) ** 2)),
        "You took 40 m away. The function gets errors: the truth has been taken away already.",
    ),
    "largest squared": (
        lambda error: np.max(error**2),
        "That is the largest square. Take the mean of all squares, and then the root.",
    ),
    "0.1/0.08 of the published": (lambda error: np.mean(abs(error)) * 0.1 / 0.08, SCALED),
    "a bell's factor": (lambda error: np.mean(abs(error)) * np.sqrt(np.pi / 2), SCALED),
    "by 0.8": (lambda error: np.mean(abs(error)) / 0.798, SCALED),
    "** 1 / 2": (
        lambda error: np.mean(error**2) / 2,
        "That is half of the mean square. `** 1 / 2` leads to it, for Python takes the power 1 first and then "
        "halves. A root is `** (1 / 2)`, or `np.sqrt`.",
    ),
}
