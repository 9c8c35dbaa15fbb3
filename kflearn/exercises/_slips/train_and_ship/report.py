"""Lesson 11, `report`: wrong answers, each with the sentence that it gets."""

import numpy as np

COV = (
    "The mean is right. Your distance is what `np.cov` makes of the errors: it takes their mean away first, and divides by T − 1. Then a receiver that "
    "is always 50 m off would seem exact. Square the errors themselves."
)


WRONG = {
    "as published": (
        lambda e: (np.cov(e.T), np.mean(np.hypot(*e.T))),
        "That is the published report again: a covariance called a mean, and a mean distance called RMS.",
    ),
    "mean distance": (
        lambda e: (e.mean(axis=0), np.mean(np.hypot(*e.T))),
        "The mean is right. The second number is still the mean distance: square, *then* average, then take the root.",
    ),
    "rms right, covariance": (
        lambda e: (np.cov(e.T), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
        "The root mean square is right. The first is still a covariance, in m²: a mean error is in metres.",
    ),
    "variances": (
        lambda e: (e.var(axis=0), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
        "The root mean square is right. The first are variances, in m²: a mean error is in metres and has a sign.",
    ),
    "an rms for each axis": (
        lambda e: (e.mean(axis=0), np.sqrt(np.mean(e**2, axis=0))),
        "The mean is right. You return one rms for each axis, whose squares R holds; the rms *distance* is one number.",
    ),
    "all numbers alike": (
        lambda e: (e.mean(axis=0), np.sqrt(np.mean(e**2))),
        "The mean is right. The second is the rms of all 2T numbers, per axis, √2 too small: first add the squares of a fix.",
    ),
    "root forgotten": (
        lambda e: (e.mean(axis=0), np.mean(np.sum(e**2, axis=1))),
        "The mean is right. The second is a mean square, in m²: the root is missing.",
    ),
    "about the mean": (
        lambda e: (e.mean(axis=0), np.sqrt(np.mean(np.sum((e - e.mean(axis=0)) ** 2, axis=1)))),
        "The mean is right. But it is taken off before the squares: a receiver that is always 50 m off would get a fine mark.",
    ),
    "mean not divided": (
        lambda e: (e.mean(axis=0), np.sqrt(np.sum(e**2))),
        "The mean is right. You took the root of the *sum* over all fixes: more fixes would make the error larger.",
    ),
    "mean of both axes": (
        lambda e: (e.mean(), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
        "The root mean square is right. The mean needs `axis=0`: east and north apart, else one hides the other.",
    ),
    "mean of each fix": (
        lambda e: (e.mean(axis=1), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
        "The root mean square is right. You averaged east with north in each fix: the mean goes over the fixes, `axis=0`.",
    ),
    "mean without sign": (
        lambda e: (abs(e).mean(axis=0), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
        "The root mean square is right. A mean error keeps its sign: errors to both sides cancel, and so they should.",
    ),
    "swapped": (
        lambda e: (np.sqrt(np.mean(np.sum(e**2, axis=1))), e.mean(axis=0)),
        "Both are right, in the wrong order: first the mean error, then the rms distance.",
    ),
    "length of the mean": (
        lambda e: (e.mean(axis=0), np.hypot(*e.mean(axis=0))),
        "The mean is right. The second number is the length of the mean error, in which errors to both sides have cancelled: square first.",
    ),
    "not averaged": (
        lambda e: (e.mean(axis=0), np.sqrt(np.sum(e**2, axis=1))),
        "The mean is right. You return the distance of each fix; asked is the root of the mean of their squares.",
    ),
    "standard deviation": (
        lambda e: (e.mean(axis=0), np.std(e)),
        "The mean is right. A standard deviation leaves a mean out, and this one mixes the axes: square, add the two axes, average, root.",
    ),
    "scatter of the distances": (
        lambda e: (e.mean(axis=0), np.std(np.hypot(*e.T))),
        "The mean is right. The second is how the distances scatter about their mean. Root mean square: square, mean, root.",
    ),
    "median distance": (
        lambda e: (e.mean(axis=0), np.median(np.hypot(*e.T))),
        "The mean is right. The second number is the median distance, which half of the fixes have. Root mean square: square, mean, root.",
    ),
    "largest distance": (
        lambda e: (e.mean(axis=0), np.max(np.hypot(*e.T))),
        "The mean is right. The second number is the largest distance. Root mean square: square, mean, root.",
    ),
    "root of the sum over T": (
        lambda e: (e.mean(axis=0), np.sqrt(np.sum(e**2)) / len(e)),
        "The mean is right. You divided after the root. First the mean of the squares, then its root.",
    ),
    "sum of the errors": (
        lambda e: (e.sum(axis=0), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
        "The root mean square is right. The first are sums: divide by the number of fixes.",
    ),
    "median error": (
        lambda e: (np.median(e, axis=0), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
        "The root mean square is right. The first are medians; the mean error is wanted.",
    ),
    "deviations": (
        lambda e: (e.std(axis=0), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
        "The root mean square is right. The first are standard deviations: a mean error has a sign, and is 0 where plus and minus cancel.",
    ),
    "rms of each axis, summed": (
        lambda e: (e.mean(axis=0), np.sum(np.sqrt(np.mean(e**2, axis=0)))),
        "The mean is right. You added the rms of both axes. Their squares add up, and then comes the root.",
    ),
    "rms first": (
        lambda e: (np.sqrt(np.mean(e**2, axis=0)), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
        "The second is right. The first are root mean squares of each axis; the mean error has a sign.",
    ),
    "mean distance and covariance": (
        lambda e: (np.cov(e.T), np.sqrt(np.mean(e**2))),
        "Two faults: the first is still a covariance; and in the second the squares of east and north are to be added before the mean.",
    ),
    "mean distance, mean of all": (
        lambda e: (e.mean(), np.mean(np.hypot(*e.T))),
        "Two faults: the mean needs `axis=0`, east and north apart; and the second is still the mean distance: square first.",
    ),
    "length of the mean, and of all": (
        lambda e: (np.hypot(*e.mean(axis=0)), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
        "The root mean square is right. The first is the length of the mean error; wanted are its two numbers, east and north.",
    ),
    "covariance": (
        lambda e: (e.mean(axis=0), np.sqrt(np.trace(np.cov(e.T)))),
        COV,
    ),
    "root of the mean distance": (
        lambda errors: (errors.mean(axis=0), np.sqrt(np.mean(np.hypot(*errors.T)))),
        "The mean is right. The second number is the root of the mean distance, and no square was taken before: "
        "the root belongs to the mean of the *squared* distances.",
    ),
}
