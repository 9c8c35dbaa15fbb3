"""Lesson 22, `weigh`: wrong answers, each with the sentence that it gets."""

import numpy as np


def multiplied(logs, likelihoods):
    p = np.exp(logs) * np.exp(likelihoods)
    return np.log(p / p.sum())


def unsafe(logs, likelihoods):
    return logs + likelihoods - np.log(np.sum(np.exp(logs + likelihoods)))


def settled(s):
    return s - np.logaddexp.reduce(s)


def floored(logs, likelihoods):
    s = logs + likelihoods
    p = np.maximum(np.exp(s - s.max()), 1e-300)
    return np.log(p / p.sum())


def largest_off(logs, likelihoods):
    s = logs + likelihoods
    p = np.exp(s - s.max())
    return np.log(p / p.sum())


def cut_off(floor):
    """Weights that are never smaller than a floor."""

    def weigh(log_weights, log_likelihoods):
        s = log_weights + log_likelihoods
        p = np.exp(s - s.max())
        return np.log(np.maximum(p / p.sum(), floor))

    return weigh


def largest_lost(a, b):
    """The largest taken off inside the exponential only."""
    s = a + b
    return s - np.log(np.sum(np.exp(s - s.max())))


def largest_twice(a, b):
    s = a + b
    return s - s.max() - np.log(np.sum(np.exp(s - s.max()))) - s.max()


def with_a_tiny_number(log_weights, log_likelihoods):
    s = log_weights + log_likelihoods
    return s - np.log(np.exp(s).sum() + 1e-300)


def raised_to_a_lowest(log_weights, log_likelihoods):
    s = np.maximum(log_weights + log_likelihoods, -700)
    return s - np.log(np.exp(s).sum())


WRONG = (
    {
        "as published": (
            multiplied,
            "As published, the way between two logarithms leads through exp, and there a weight of e⁻⁸⁰⁰ becomes 0 for "
            "ever. Stay with the sum of the logarithms instead.",
        ),
        "unsafe sum": (
            unsafe,
            "Nearly. When all sums are below −745, every exp is 0 and the log of 0 is −∞. Take the largest off first.",
        ),
        "not made to sum to 1": (
            lambda logs, likelihoods: logs + likelihoods,
            "The sum of logarithms is right. The weights must still sum to 1: subtract log Σ exp(s).",
        ),
        "largest set to 1": (
            lambda logs, likelihoods: (logs + likelihoods) - np.max(logs + likelihoods),
            "Taking the largest off makes its weight 1, whatever the others are. Now subtract log Σ exp of that.",
        ),
        "logarithms divided": (
            lambda logs, likelihoods: (logs + likelihoods) / np.sum(logs + likelihoods),
            "Those are the logarithms divided by their sum. Dividing weights is *subtracting* a logarithm from each.",
        ),
        "old weights forgotten": (
            lambda logs, likelihoods: settled(likelihoods),
            "Those are the weights of this reading alone. All readings before it are in log_weights: add them.",
        ),
        "likelihood forgotten": (
            lambda logs, likelihoods: settled(logs),
            "The reading has not been used: add its log-likelihoods.",
        ),
        "floored": (
            floored,
            "A floor keeps the weight alive, and lies about it: e⁻²⁰⁰⁰ becomes e⁻⁶⁹¹, and the model comes back far too "
            "early. Keep the logarithm, it has room enough.",
        ),
        "floored, largest left in": (
            lambda logs, likelihoods: (lambda p: np.log(p / p.sum()))(np.maximum(np.exp(logs + likelihoods), 1e-300)),
            "A floor of 1e-300 makes all that are below it equal. Do not go through exp: subtract log Σ exp(s) from s.",
        ),
        "cut off at −700": (
            lambda logs, likelihoods: np.maximum(settled(logs + likelihoods), -700),
            "You cut the logarithms off at −700. −20000 is an ordinary number for a logarithm: leave it, so that it can rise again.",
        ),
        "divided by the likelihood": (
            lambda logs, likelihoods: settled(logs - likelihoods),
            "You subtracted the log-likelihoods. A weight is multiplied by its likelihood: add the logarithms.",
        ),
        "powers of ten": (
            lambda logs, likelihoods: settled(logs + likelihoods) / np.log(10),
            "Those are logarithms to the base 10. The weights' logarithms are natural ones.",
        ),
        "weights": (
            lambda logs, likelihoods: np.exp(settled(logs + likelihoods)),
            "These are the weights, and the low ones are 0. Return the logarithms: only they remember how far behind.",
        ),
        "their sum taken off": (
            lambda logs, likelihoods: logs + likelihoods - np.sum(logs + likelihoods),
            "You subtracted the sum of the logarithms. The weights must sum to 1: subtract log Σ exp(s).",
        ),
        "their mean taken off": (
            lambda logs, likelihoods: logs + likelihoods - np.mean(logs + likelihoods),
            "You subtracted the mean of the logarithms. The weights must sum to 1: subtract log Σ exp(s).",
        ),
        "largest off, then through exp": (
            largest_off,
            "The largest makes no trouble any more, but the low weights go through exp: e⁻⁸⁰⁰ "
            "becomes 0, and its logarithm −∞. Subtract log Σ exp(s) from s itself.",
        ),
        "multiplied logarithms": (
            lambda logs, likelihoods: settled(logs * likelihoods),
            "You multiplied the logarithms. A product of weights is a sum of their logarithms.",
        ),
        "product": (
            lambda logs, likelihoods: logs * likelihoods,
            "You multiplied the logarithms. A product of weights is a sum of their logarithms; then the weights must "
            "sum to 1.",
        ),
        "only the new one settled": (
            lambda logs, likelihoods: logs + settled(likelihoods),
            "You made the likelihoods sum to 1, not the weights. First add both, then subtract log Σ exp of the sum.",
        ),
        "divided by the sum of weights": (
            lambda logs, likelihoods: (logs + likelihoods) - np.exp(np.logaddexp.reduce(logs + likelihoods)),
            "You subtracted the sum of the weights. Subtract its logarithm.",
        ),
    }
    | {
        f"floor of {floor:g}": (
            cut_off(floor),
            "A floor forgets how far behind a model is: all below it look alike. Stay in logarithms, s − log Σ exp(s).",
        )
        for floor in (1e-300, 1e-308, 1e-200, 1e-100, 1e-50, 1e-30, 1e-20, 1e-16, 1e-15, 1e-12, 1e-10, 1e-9, 1e-8, 1e-6)
    }
    | {
        "largest off inside only": (
            largest_lost,
            "The largest is taken off inside exp and is missing outside: log Σ exp(s) = largest + log Σ exp(s − largest).",
        ),
        "largest off twice": (
            largest_twice,
            "The largest is taken off twice: log Σ exp(s) = largest + log Σ exp(s − largest), and the largest counts once in it.",
        ),
        "a tiny number added": (
            with_a_tiny_number,
            "It answers as if 1e-300 were added to Σ exp(s). Where all s are very low that number is all there is, "
            "and the weights do not sum to 1. Take the largest s off first: then the sum is never 0.",
        ),
        "raised to −700": (
            raised_to_a_lowest,
            "It answers as if each sum below −700 were raised to −700 first: such weights all look alike then. Take "
            "the largest sum off before exp, and none needs a lowest value.",
        ),
        "logarithms added up": (
            lambda log_weights, log_likelihoods: (s := log_weights + log_likelihoods) - np.log(np.sum(s)),
            "You add up logarithms and take the logarithm of that sum; they are negative, so there is none. The weights are added up: log Σ exp(s).",
            r"np\.log\(",
        ),
    }
)
