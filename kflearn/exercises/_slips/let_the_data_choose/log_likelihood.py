"""Lesson 24, `log_likelihood`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._slips.let_the_data_choose.shared import bridged


def seen(y, S):
    return y[~np.isnan(y)], S[~np.isnan(y)]


def of_seen(formula):
    return lambda y, S: formula(*seen(y, S))


def terms(y, S):
    return -0.5 * (np.log(2 * np.pi * S) + y**2 / S)


WRONG = {
    "gaps counted": (
        lambda y, S: -0.5 * (np.sum(np.log(2 * np.pi * S)) + np.nansum(y**2 / S)),
        "The logarithm is added for missing readings too. A step without a reading says nothing: leave out its log 2πS as well.",
    ),
    "2π counted for gaps": (
        lambda y, S: -0.5 * (len(y) * np.log(2 * np.pi) + of_seen(lambda y, S: np.sum(np.log(S) + y**2 / S))(y, S)),
        "You added log 2π for every step, `len(y)` times, also where there is no reading. Count the readings alone.",
    ),
    "NaN kept": (
        lambda y, S: -0.5 * np.sum(np.log(2 * np.pi * S) + y**2 / S),
        "One NaN makes the whole sum NaN. Leave out the steps where y is NaN.",
    ),
    "product first": (
        of_seen(lambda y, S: np.log(np.prod(np.exp(-(y**2) / (2 * S)) / np.sqrt(2 * np.pi * S)))),
        "You multiply the heights first. In a long run their product is too small for a float and becomes 0: add the logarithms.",
    ),
    "plus": (
        of_seen(lambda y, S: 0.5 * np.sum(np.log(2 * np.pi * S) + y**2 / S)),
        "The sign: that is minus the log-likelihood, as a search for a minimum wants it.",
    ),
    "no half": (
        of_seen(lambda y, S: -np.sum(np.log(2 * np.pi * S) + y**2 / S)),
        "That is twice the right number: the ½ is missing.",
    ),
    "half before the NIS only": (
        of_seen(lambda y, S: -np.sum(np.log(2 * np.pi * S) + 0.5 * y**2 / S)),
        "The ½ belongs to both parts, also to the logarithm. That is the fault of exercise 3.",
    ),
    "half before the logarithm only": (
        of_seen(lambda y, S: -np.sum(0.5 * np.log(2 * np.pi * S) + y**2 / S)),
        "The ½ belongs to both parts, also to y²/S.",
    ),
    "2π forgotten": (of_seen(lambda y, S: -0.5 * np.sum(np.log(S) + y**2 / S)), "2π is missing in the logarithm."),
    "mean": (
        of_seen(lambda y, S: -0.5 * np.mean(np.log(2 * np.pi * S) + y**2 / S)),
        "You took the mean. The logarithms of a product add: take the sum.",
    ),
    "each": (
        of_seen(lambda y, S: -0.5 * (np.log(2 * np.pi * S) + y**2 / S)),
        "That is one number for each reading. Add them up.",
    ),
    "σ for S": (
        of_seen(lambda y, S: -0.5 * np.sum(np.log(2 * np.pi * S**2) + y**2 / S**2)),
        "Your S is squared, as one would a σ. S is a variance already.",
    ),
    "root in the NIS": (
        of_seen(lambda y, S: -0.5 * np.sum(np.log(2 * np.pi * S) + y**2 / np.sqrt(S))),
        "The squared innovation is divided by S itself, not by its root.",
    ),
    "y not squared": (
        of_seen(lambda y, S: -0.5 * np.sum(np.log(2 * np.pi * S) + y / S)),
        "The innovation is squared in the NIS.",
    ),
    "logarithm of the sum": (
        of_seen(lambda y, S: -0.5 * (np.log(2 * np.pi * S.sum()) + np.sum(y**2 / S))),
        "You took the logarithm of the sum of all S. Each reading has a logarithm of its own.",
    ),
    "product of densities": (
        of_seen(lambda y, S: np.prod(np.exp(-0.5 * y**2 / S) / np.sqrt(2 * np.pi * S))),
        "That is the likelihood itself. Its logarithm was asked for; with many readings the product would become 0 in the machine.",
    ),
    "up to the first gap": (
        lambda y, S: np.sum(terms(y, S)[: np.argmax(np.append(np.isnan(y), True))]),
        "It answers as if the run ended at the first gap. A gap counts nothing, and the readings after it count "
        "again (in a loop: `continue` in place of `break`).",
    ),
    "sum of the heights": (
        lambda y, S: np.log(np.nansum(np.exp(terms(y, S)))),
        "That is the logarithm of the *sum* of the heights. All readings are to hold together, so the heights are "
        "multiplied: add their logarithms.",
    ),
    "mean S": (
        lambda y, S: np.nansum(terms(y, np.mean(S))),
        "It answers as if each reading had the same variance, the mean of all S. Each innovation has an S of its own.",
    ),
    "first left out": (
        lambda y, S: np.nansum(terms(y, S)[1:]),
        "It answers as if the first step were left out. Each reading that is there counts, the first one too.",
    ),
    "gaps bridged": (
        lambda y, S: np.sum(terms(bridged(y), S)),
        "It answers as if straight lines filled the gaps, and counted as readings. A missing reading counts "
        "nothing: leave it out.",
    ),
    "NaN taken out of y alone": (
        lambda y, S: -0.5 * np.sum(np.log(2 * np.pi * S) + y[~np.isnan(y)] ** 2 / S),
        "The NaN are taken out of y, and S keeps all its entries: the lengths differ. Take the same places out of both.",
        r"isnan",
    ),
}
