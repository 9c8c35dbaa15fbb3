"""Lesson 22, `mixture_cov`: wrong answers, each with the sentence that it gets."""

import numpy as np


def as_published(p, means, covs):
    return sum(
        w * (np.outer(mean - part, mean - part) + P)
        for part, w, mean, P in zip(p @ means, p, means, covs, strict=False)
    )


def mixed(p, means, covs, centre=None, weights=None):
    """A mixture's covariance about a centre that may be wrong."""
    apart = means - (p @ means if centre is None else centre)
    weights = p if weights is None else weights
    return sum(w * (P + np.outer(y, y)) for w, y, P in zip(weights, apart, covs, strict=True))


def spread_about(p, means, covs, weights):
    apart = means - p @ means
    return np.tensordot(p, covs, 1) + (apart.T * weights) @ apart


def of_two(p, means, covs):
    x, P = p @ means, np.zeros((2, 2))
    for weight, mean, cov in zip(p, means, covs, strict=True):
        P += weight * (np.outer(mean - x, mean - x) + cov)
    return P


def by_component(p, means, covs):
    """From each filter's mean a component of the joint mean is subtracted, in turns."""
    parts = np.resize(p @ means, len(p))
    return sum(w * (P + np.outer(m - c, m - c)) for w, m, P, c in zip(p, means, covs, parts, strict=True))


def over_the_wrong_axis(p, means, covs):
    off = means - p @ means
    return p @ covs + off.T @ np.diag(p) @ off


def squares_inside(p, means, covs):
    """A mixture's covariance with the squares of the weights for the covariances alone."""
    y = means - p @ means
    return np.tensordot(p**2, covs, axes=1) + (p[:, None] * y).T @ y


WRONG = {
    "as published": (
        as_published,
        "That is still the published loop: its first item runs over the components of x, so it stops after as many turns as x has numbers.",
    ),
    "one component": (
        lambda p, means, covs: mixed(p, means, covs, centre=(p @ means)[0]),
        "All filters count now. But from each mean you subtract one component of x, a position, even from the "
        "velocity: subtract the vector.",
    ),
    "two filters": (
        lambda p, means, covs: mixed(*(part[: means.shape[1]] for part in (p, means, covs)), centre=p @ means),
        "The difference is mended. The second fault remains: only as many filters have their turn as x has numbers.",
    ),
    "spread forgotten": (
        lambda p, means, covs: np.tensordot(p, covs, 1),
        "That is the weighted mean of the covariances alone. When the filters disagree, the joint belief is wider: add p y yᵀ, y being how far each mean is from the joint one.",
    ),
    "spread only": (
        lambda p, means, covs: mixed(p, means, 0 * covs),
        "That is only how far the means are apart. Each filter's own doubt comes on top.",
    ),
    "plain average as centre": (
        lambda p, means, covs: mixed(p, means, covs, centre=means.mean(axis=0)),
        "You measured distances from the plain average of the means. The joint mean is the weighted one, p @ means.",
    ),
    "weights forgotten": (
        lambda p, means, covs: mixed(p, means, covs, weights=np.full(len(p), 1 / len(p))),
        "All filters have the same say in your sum. Weigh each with its probability.",
    ),
    "fused": (
        lambda p, means, covs: np.linalg.inv(np.sum(np.linalg.inv(covs), axis=0)),
        "That is what fusing them as separate opinions gives. They have seen the same readings, and only one of them is right: it is a mixture, not a fusion.",
    ),
    "not weighted": (
        lambda p, means, covs: mixed(p, means, covs, weights=np.ones(len(p))),
        "You added all of them in full. Weigh each with its probability.",
    ),
    "about zero": (
        lambda p, means, covs: mixed(p, means, covs, centre=0 * means[0]),
        "You measured how far the means are from zero. Measure from the joint mean, p @ means.",
    ),
    "squared distance": (
        lambda p, means, covs: sum(
            w * (P + (m - p @ means) @ (m - p @ means)) for w, m, P in zip(p, means, covs, strict=True)
        ),
        "You added the squared distance, one number, to every entry. The spread of vectors is a matrix: "
        "`np.outer(y, y)`.",
    ),
    "entry by entry": (
        lambda p, means, covs: sum(w * (P + (m - p @ means) ** 2) for w, m, P in zip(p, means, covs, strict=True)),
        "You squared the differences entry by entry. The spread of vectors is a matrix: `np.outer(y, y)`.",
    ),
    "weights squared": (
        lambda p, means, covs: mixed(p, means, covs, weights=p**2),
        "You squared the weights, as for an average of independent errors. Only one of the filters is right: "
        "weigh each with p.",
    ),
    "spread subtracted": (
        lambda p, means, covs: 2 * np.tensordot(p, covs, 1) - mixed(p, means, covs),
        "You subtracted the spread. Disagreement makes the joint belief wider.",
    ),
    "the most probable": (
        lambda p, means, covs: covs[np.argmax(p)],
        "That is the covariance of the most probable filter. All of them may be right, each with its weight.",
    ),
    "plain mean of the covariances": (
        lambda p, means, covs: covs.mean(axis=0),
        "That is the plain mean of the covariances. Weigh them with p, and add how far the means are apart.",
    ),
    "spread not weighted": (
        lambda p, means, covs: spread_about(p, means, covs, np.ones(len(p))),
        "The covariances are weighed, how far the means are apart is not. Each y yᵀ counts with its filter's probability too.",
    ),
    "spread averaged": (
        lambda p, means, covs: spread_about(p, means, covs, np.full(len(p), 1 / len(p))),
        "The covariances are weighed. You took the plain average of the y yᵀ: each counts with its filter's probability too.",
    ),
    "covariances not weighted": (
        lambda p, means, covs: covs.mean(axis=0) + spread_about(p, means, 0 * covs, p),
        "The spread of the means is right. The covariances must be weighed too: each with its filter's probability.",
    ),
    "covariances summed": (
        lambda p, means, covs: covs.sum(axis=0) + spread_about(p, means, 0 * covs, p),
        "The spread of the means is right. The covariances must be weighed too: each with its filter's probability.",
    ),
    "2 × 2": (
        of_two,
        "The size 2 stands in the function. It must work for any number of states: begin with zeros like `covs[0]`.",
        r"zeros\(\[?\(?2, ?2",
    ),
    "informations averaged": (
        lambda p, means, covs: np.linalg.inv(np.tensordot(p, np.linalg.inv(covs), 1)),
        "You averaged the inverses. One of the filters is right, and we do not know which: the covariances are averaged, and how far the means are apart comes on top.",
    ),
    "np.cov's divisor": (
        lambda p, means, covs: np.tensordot(p, covs, 1) + np.cov(means.T, aweights=p),
        "Nearly: by itself `np.cov` divides by less than the sum of the weights, as for a sample. Here it is a plain weighted mean: `ddof=0`.",
    ),
    "np.cov without weights": (
        lambda p, means, covs: np.tensordot(p, covs, 1) + np.cov(means.T),
        "The spread is that of `np.cov(means.T)`, without the weights and divided by M − 1. Each y yᵀ counts with its filter's probability.",
    ),
    "the last filter": (
        lambda p, means, covs: p[-1] * (covs[-1] + np.outer(means[-1] - p @ means, means[-1] - p @ means)),
        "Only the last filter is left: each turn of the loop overwrites P. Add to it.",
    ),
    "a component each": (
        by_component,
        "All filters are counted now. But from each mean you subtract one number: subtract the whole vector p @ means.",
    ),
    "spread on the diagonal": (
        lambda p, means, covs: np.tensordot(p, covs, 1) + np.diag(np.diag(mixed(p, means, 0 * covs))),
        "The variances are right. The spread has entries off the diagonal too: np.outer(y, y).",
    ),
    "p @ covs": (
        over_the_wrong_axis,
        "`p @ covs` multiplies over the wrong axis of (M, n, n): use `np.einsum('m,mij->ij', p, covs)`.",
        r"p @ covs|over_the_wrong|(dot|matmul)\(p, covs",
    ),
    "squares inside": (
        squares_inside,
        "Each covariance counts with the square of its weight in your result. Squares belong to a weighted mean of independent estimates. Here "
        "one of the models holds, the i-th with probability pᵢ: its Pᵢ counts with pᵢ.",
    ),
    "about the most probable": (
        lambda p, means, covs: mixed(p, means, covs, centre=means[np.argmax(p)]),
        "You take the spread about the mean of the most probable filter. It is taken about the joint mean, Σ pᵢ xᵢ.",
    ),
}
