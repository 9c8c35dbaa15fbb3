"""Lesson 7, `draw_start`: wrong answers, each with the sentence that it gets."""

import numpy as np

ONE_SIGMA = (
    "You use one σ for all components. Each has a variance of its own: take the root of `variances` entry by entry."
)


def one_sigma(choose):
    """A start with one standard deviation for all components, chosen from theirs."""
    return lambda mean, variances, normal: mean + choose(variances) * normal


WRONG = {
    "as published": (
        lambda mean, variances, normal: mean,
        "That is the published start: every run begins where the filter believes, and P₀ is an empty claim.",
    ),
    "variance for σ": (
        lambda mean, variances, normal: mean + variances * normal,
        "You stretched by the variance, so the start scatters with variance². Stretch by its root.",
    ),
    "P₀ = I": (
        lambda mean, variances, normal: mean + normal,
        "That is right for P₀ = I only: the variances are not used yet.",
    ),
    "no chance": (
        lambda mean, variances, normal: mean + np.sqrt(variances),
        "Every run would start one σ away, on the same side. Multiply σ by the random numbers.",
    ),
    "no mean": (
        lambda mean, variances, normal: np.sqrt(variances) * normal,
        "The scatter is right, but about zero; it belongs about the mean.",
    ),
    "divided": (
        lambda mean, variances, normal: mean + normal / np.sqrt(variances),
        "You divided by σ: that makes a number standard normal. Here it goes the other way.",
    ),
    "one number for all": (
        lambda mean, variances, normal: mean + np.sqrt(variances) @ normal,
        "All states are moved by the same number, the sum of the products, as `@` makes it. Multiply entry by entry, with `*`.",
    ),
    "the same number for all": (
        lambda mean, variances, normal: mean + np.sqrt(variances) * normal[0],
        "All states share one random number, so they are always wrong together. Each has a number of its own.",
    ),
    "variance squared": (
        lambda mean, variances, normal: mean + variances**2 * normal,
        "You squared the variances; σ is their root.",
    ),
    "mean stretched too": (
        lambda mean, variances, normal: mean * np.sqrt(variances) * normal,
        "You multiplied the mean as well. The mean shifts the scatter, it is added.",
    ),
    "shifted first": (
        lambda mean, variances, normal: (mean + normal) * np.sqrt(variances),
        "You shifted first and stretched afterwards, so the mean was stretched too. First stretch, then add the mean.",
    ),
    "2σ": (
        lambda mean, variances, normal: mean + 2 * np.sqrt(variances) * normal,
        "Twice too wide: a standard normal number times σ has the standard deviation σ already.",
    ),
    "root of all": (
        lambda mean, variances, normal: mean + np.sqrt(variances * abs(normal)),
        "The random number stands under the root, and its sign is lost. Stretch it by √variance: the root is of the variance alone.",
    ),
    "one side": (
        lambda mean, variances, normal: mean + np.sqrt(variances) * abs(normal),
        "All your starts lie above the mean: you took the size of the random number. It has a sign of its own.",
    ),
    "sum of the variances": (
        lambda mean, variances, normal: mean + np.sqrt(np.sum(variances)) * normal,
        "You stretch each number by the root of the *sum*. Each state has a variance of its own.",
    ),
    "first variance": (
        lambda mean, variances, normal: mean + np.sqrt(variances[0]) * normal,
        "You use the first variance for all. Each state has a variance of its own.",
    ),
    "root of the product": (
        lambda mean, variances, normal: mean + np.sqrt(variances * normal),
        "The random number stands under the root: where it is negative there is no root. Take the root of the variance alone.",
    ),
    "added, not multiplied": (
        lambda mean, variances, normal: mean + np.sqrt(variances) + normal,
        "You added σ to the random number. It is to be stretched: multiply.",
    ),
    "divided by the variance": (
        lambda mean, variances, normal: mean + normal / variances,
        "You divided by the variance. The scatter is to become √variance: multiply by that.",
    ),
    "half of the variance": (
        lambda mean, variances, normal: mean + variances / 2 * normal,
        "You stretched by half the variance. The standard deviation is the root of the variance.",
    ),
    "mean times normal": (
        lambda mean, variances, normal: mean * normal + np.sqrt(variances),
        "Mean and σ have changed places: the random number stretches with σ, and the mean is added.",
    ),
    "squared numbers": (
        lambda mean, variances, normal: mean + np.sqrt(variances) * normal**2,
        "You squared the random numbers, so all starts lie above the mean.",
    ),
    "mean stretched": (
        lambda mean, variances, normal: mean * (1 + np.sqrt(variances) * normal),
        "You stretch the mean by the scatter. The scatter is added to the mean: √variance times the random number.",
    ),
    "mean stretched, variance": (
        lambda mean, variances, normal: mean * (1 + variances * normal),
        "You stretch the mean by the scatter, and by the variance. Add √variance times the random number to the mean.",
    ),
    "σ of the mean variance": (one_sigma(lambda variances: np.sqrt(np.mean(variances))), ONE_SIGMA),
    "mean σ": (one_sigma(lambda variances: np.mean(np.sqrt(variances))), ONE_SIGMA),
    "largest σ": (one_sigma(lambda variances: np.sqrt(np.max(variances))), ONE_SIGMA),
    "a diagonal matrix": (
        lambda mean, variances, normal: mean + np.diag(np.sqrt(variances)) * normal,
        "`np.diag(…) * normal` multiplies entry by entry and leaves a matrix. Multiply the deviations themselves by `normal`, or the matrix by `@`.",
    ),
}
