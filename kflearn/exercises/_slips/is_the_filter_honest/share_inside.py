"""Lesson 7, `share_inside`: wrong answers, each with the sentence that it gets."""

import numpy as np

WRONG = {
    "as published": (
        lambda e, P: np.mean(abs(e) <= P),
        "That is still the band ±P: it compares metres with square metres. Where P > 1 it is too wide, else too narrow.",
    ),
    "±2σ": (
        lambda e, P: np.mean(abs(e) <= 2 * np.sqrt(P)),
        "The root is right. But that is the band ±2σ, which holds 95.4 %; ±1σ was asked for.",
    ),
    "one side": (
        lambda e, P: np.mean(e <= np.sqrt(P)),
        "You forgot the lower edge: errors far below zero count as inside. Take abs(e).",
    ),
    "e² against σ": (
        lambda e, P: np.mean(e**2 <= np.sqrt(P)),
        "That is e² against √P. Compare |e| with √P, or e² with P.",
    ),
    "P²": (
        lambda e, P: np.mean(abs(e) <= P**2),
        "You squared the variance; the standard deviation is its root.",
    ),
    "a count": (
        lambda e, P: np.sum(abs(e) <= np.sqrt(P)),
        "The band is right, and you counted those inside. A share is that count divided by how many there are: np.mean.",
    ),
    "outside": (
        lambda e, P: np.mean(abs(e) > np.sqrt(P)),
        "The band is right, but that is the share outside.",
    ),
    "per cent": (
        lambda e, P: 100 * np.mean(abs(e) <= np.sqrt(P)),
        "The band is right. Leave the share between 0 and 1: the format `.1%` makes per cent of it.",
    ),
    "not averaged": (
        lambda e, P: abs(e) <= np.sqrt(P),
        "The comparison is right. It says True or False for each error; the share of True is their mean.",
    ),
    "one σ": (
        lambda e, P: np.mean(abs(e) <= np.sqrt(np.mean(P))),
        "You compare all errors with one σ. Each error has a variance of its own: take its root, entry by entry.",
    ),
    "1": (
        lambda e, P: np.mean(abs(e) <= 1),
        "You compare with 1, whatever is claimed. ±1σ means: one standard deviation, which is the root of P.",
    ),
    "scatter of the errors": (
        lambda e, P: np.mean(abs(e) <= np.std(e)),
        "You compare with the scatter of the errors themselves. The question is about what was claimed: the variances P.",
    ),
    "1.96 σ": (
        lambda e, P: np.mean(abs(e) <= 1.96 * np.sqrt(P)),
        "The root is right. 1.96 σ is the band that holds 95 %; ±1σ was asked for.",
    ),
    "3 σ": (
        lambda e, P: np.mean(abs(e) <= 3 * np.sqrt(P)),
        "The root is right. But that is the band ±3σ; ±1σ was asked for.",
    ),
    "published, one side": (
        lambda e, P: np.mean(e <= P),
        "Two faults: P is a variance, its root belongs here; and without abs(e) all errors below count as inside.",
    ),
    "expected": (
        lambda e, P: 0.683,
        "68.3 % is what to expect of an honest filter. Count how many of these errors are really inside.",
    ),
    "half of σ": (
        lambda e, P: np.mean(abs(e) <= np.sqrt(P) / 2),
        "Your band is half as wide as it should be: ±σ, with σ = √P.",
    ),
    "mean error": (
        lambda e, P: np.mean(abs(e)) <= np.sqrt(np.mean(P)),
        "You compare the mean error with a mean σ, once. Compare each error with its own σ, and take the share.",
    ),
    "first P": (
        lambda e, P: np.mean(abs(e) <= np.sqrt(P[0])),
        "You use the first variance for all. Each error has a variance of its own.",
    ),
    "lower edge": (
        lambda e, P: np.mean(e >= -np.sqrt(P)),
        "You forgot the upper edge: errors far above zero count as inside. Take abs(e).",
    ),
    "mean NEES": (
        lambda e, P: np.mean(e**2 / P),
        "That is the mean of e²/P. A share is wanted: for how many of the errors is e²/P at most 1?",
    ),
    "mean in σ": (
        lambda e, P: np.mean(abs(e) / np.sqrt(P)),
        "That is how many σ an error is on average. A share is wanted: how many of them are at most 1σ?",
    ),
    "half of P": (
        lambda e, P: np.mean(abs(e) <= P / 2),
        "You compare with half the variance. σ is the root of P.",
    ),
    "squares and P squared": (
        lambda e, P: np.mean(e**2 <= P) > 0.683,
        "You say whether the share is above 68.3 %. Return the share itself.",
    ),
}
