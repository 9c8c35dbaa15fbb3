"""Wrong answers to exercises of lesson 22, each with the sentence that it gets."""

import numpy as np


def estimate(y, H, P, C=None):
    C = y.T @ y / len(y) if C is None else C(y)
    return C - H @ P @ H.T


def settled(s):
    return s - np.logaddexp.reduce(s)


def multiplied(logs, likelihoods):
    p = np.exp(logs) * np.exp(likelihoods)
    return np.log(p / p.sum())


def unsafe(logs, likelihoods):
    return logs + likelihoods - np.log(np.sum(np.exp(logs + likelihoods)))


def largest_off(logs, likelihoods):
    s = logs + likelihoods
    p = np.exp(s - s.max())
    return np.log(p / p.sum())


def floored(logs, likelihoods):
    s = logs + likelihoods
    p = np.maximum(np.exp(s - s.max()), 1e-300)
    return np.log(p / p.sum())


def mixed(p, means, covs, centre=None, weights=None):
    """A mixture's covariance about a centre that may be wrong."""
    apart = means - (p @ means if centre is None else centre)
    weights = p if weights is None else weights
    return sum(w * (P + np.outer(y, y)) for w, y, P in zip(weights, apart, covs, strict=True))


def as_published(p, means, covs):
    return sum(
        w * (np.outer(mean - part, mean - part) + P)
        for part, w, mean, P in zip(p @ means, p, means, covs, strict=False)
    )


WRONG = {}

WRONG["matrix_R"] = {
    "mean removed": (
        lambda y, H, P: estimate(y, H, P, lambda y: np.cov(y.T, bias=True)),
        "Here the mean of the innovations is taken off. They should average 0, and if they do not, that belongs to C.",
    ),
    "np.cov": (
        lambda y, H, P: estimate(y, H, P, lambda y: np.cov(y.T)),
        "The mean is taken off, and the divisor is N − 1, as in `np.cov`. The mean is known to be 0: `y.T @ y / len(y)`.",
    ),
    "summed": (
        lambda y, H, P: estimate(y, H, P, lambda y: y.T @ y),
        "Your C is the sum of the y yᵀ. It is their mean: divide by the number of rows.",
    ),
    "divided by m": (
        lambda y, H, P: estimate(y, H, P, lambda y: y.T @ y / y.shape[1]),
        "Your C is the sum of the y yᵀ divided by the number of sensors. It is a mean over the innovations, the rows: `len(y)`.",
    ),
    "N − 1": (
        lambda y, H, P: estimate(y, H, P, lambda y: y.T @ y / (len(y) - 1)),
        "Your C is divided by N − 1. No mean was estimated: divide by N.",
    ),
    "variances only": (
        lambda y, H, P: estimate(y, H, P, lambda y: np.diag(np.mean(y**2, axis=0))),
        "Your C has only the variances. Two sensors may err together, and y yᵀ shows it: keep the other entries.",
    ),
    "one number": (
        lambda y, H, P: estimate(y, H, P, lambda y: np.mean(y**2)),
        "Your C is a single number. Each sensor has its own scatter: C is a matrix, `y.T @ y / len(y)`.",
    ),
    "added": (
        lambda y, H, P: y.T @ y / len(y) + H @ P @ H.T,
        "You added H P Hᵀ. C measures S = H P Hᵀ + R, and R is what remains when H P Hᵀ comes off.",
    ),
    "C alone": (
        lambda y, H, P: y.T @ y / len(y),
        "That is C. Take off what the prediction explains by itself, H P Hᵀ.",
    ),
    "H forgotten": (
        lambda y, H, P: y.T @ y / len(y) - P[: len(H), : len(H)],
        "A corner of P is taken off C here. What the sensors see of the prediction's doubt is H P Hᵀ.",
    ),
    "mean times mean": (
        lambda y, H, P: estimate(y, H, P, lambda y: np.outer(y.mean(axis=0), y.mean(axis=0))),
        "You multiplied the mean innovation by itself. C is the mean of the products y yᵀ: first multiply, then "
        "average.",
    ),
    "diagonal of the whole": (
        lambda y, H, P: np.diag(np.diag(estimate(y, H, P))),
        "The variances are right. The other entries are not 0: they tell what the sensors' errors have in common. Keep them.",
    ),
    "y yᵀ of all": (
        lambda y, H, P: y @ y.T / len(y) - H @ P @ H.T,
        "Your C has one row for each innovation, as `y @ y.T` has. The rows of y are the innovations, so the sum of all y yᵀ is `y.T @ y`.",
    ),
    "with a floor": (
        lambda y, H, P: np.maximum(estimate(y, H, P), 0.01),
        "No entry of your R̂ is below a floor. The text asks for R̂ without one; and a floor belongs under variances only, not under every entry.",
    ),
    "made positive": (
        lambda y, H, P: abs(estimate(y, H, P)),
        "You took the size of each entry. What the sensors' errors have in common may be negative; and no floor is asked for.",
    ),
    "diagonals": (
        lambda y, H, P: np.mean(y**2, axis=0) - np.diag(H @ P @ H.T),
        "Those are the variances of the sensors, and they are right. R̂ is a matrix: its other entries tell what "
        "the sensors' errors have in common.",
    ),
    "row for matrix": (
        lambda y, H, P: np.mean(y**2, axis=0) - H @ P @ H.T,
        "Here H P Hᵀ, a matrix, is taken off a row of variances. C is a matrix: `y.T @ y / len(y)`.",
    ),
    "all numbers": (
        lambda y, H, P: y.T @ y / y.size - H @ P @ H.T,
        "You divided by the number of all entries of y. C is a mean over the innovations, the rows: `len(y)`.",
    ),
    "the wrong way": (
        lambda y, H, P: H @ P @ H.T - y.T @ y / len(y),
        "You took C off H P Hᵀ. C is the larger one: R is what remains of it.",
    ),
    "identity for H": (
        lambda y, H, P: y.T @ y / len(y) - H @ H.T,
        "P is missing between H and Hᵀ: the prediction's doubt, seen by the sensors, is H P Hᵀ.",
    ),
}

WRONG["weigh"] = {
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

WRONG["mixture_cov"] = {
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
}
