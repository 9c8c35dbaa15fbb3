"""Lesson 20: adaptive filters."""

import numpy as np

from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "How much does a mean of N squared bells scatter? By S √(2/N), S being the variance of one of them.",
        "S is not R: an innovation scatters by what the sensor does and by what the prediction does, 1 + 0.3.",
        "You need 1.3 √(2/N) ≤ 0.1. Solve for N, and round up.",
        "`2 * (1.3 / 0.1) ** 2`",
    ],
    wrong={
        "R for S": (
            200,
            "You took R = 1 for the variance of an innovation. It is S = 1 + 0.3: the prediction is uncertain too.",
        ),
        "2 forgotten": (169, "You forgot the 2: the square of a bell has the variance 2S², so C scatters by S √(2/N)."),
        "not squared": (26, "You forgot to square: from 1.3 √(2/N) = 0.1 follows N = 2 · 13²."),
        "R alone, 2 forgotten": (
            100,
            "σ/√N is the error of a mean of plain numbers. Here it is a mean of squares: S √(2/N), with S = 1.3.",
        ),
        "0.1 as a variance": (34, "You took 0.1 for the variance of R̂. The question names its standard deviation."),
    },
    unit="innovations",
    rtol=4e-3,
)
def window_needed():
    """R = 1 m², HP⁻Hᵀ = 0.3 m². How many innovations until R̂ scatters by 0.1 m² (standard deviation) only?"""
    return int(np.ceil(2 * ((1 + 0.3) / 0.1) ** 2))


def vectors(rng):
    """Innovations of two sensors, and a lopsided H with a covariance of three states."""
    m, n, N = 2, 3, int(rng.integers(4, 9))
    factor = rng.integers(-2, 3, (n, n)) / 2 + 1.5 * np.eye(n)
    y = rng.integers(-8, 9, (N, m)) / 2 + rng.integers(1, 4, m)
    return y, rng.integers(-2, 4, (m, n)) / 2 + np.eye(m, n), factor @ factor.T


def estimate(y, H, P, C=None):
    C = y.T @ y / len(y) if C is None else C(y)
    return C - H @ P @ H.T


@exercise(
    hints=[
        "C is the mean of the m × m matrices y yᵀ, one for each row of y. Then take off what the prediction explains.",
        "The sum of all y yᵀ is `y.T @ y`: try its shape. The prediction's share is H P Hᵀ.",
        "`return y.T @ y / len(y) - H @ P @ H.T`",
    ],
    inputs=vectors,
    wrong={
        "mean removed": (
            lambda y, H, P: estimate(y, H, P, lambda y: np.cov(y.T, bias=True)),
            "You took the mean of the innovations off. They should average 0, and if they do not, that belongs to C.",
        ),
        "np.cov": (
            lambda y, H, P: estimate(y, H, P, lambda y: np.cov(y.T)),
            "`np.cov` takes the mean off and divides by N − 1. Here the mean is known to be 0: `y.T @ y / len(y)`.",
        ),
        "summed": (
            lambda y, H, P: estimate(y, H, P, lambda y: y.T @ y),
            "You summed the y yᵀ. C is their mean: divide by the number of rows.",
        ),
        "divided by m": (
            lambda y, H, P: estimate(y, H, P, lambda y: y.T @ y / y.shape[1]),
            "You divided by the number of sensors. C is a mean over the innovations, the rows: `len(y)`.",
        ),
        "N − 1": (
            lambda y, H, P: estimate(y, H, P, lambda y: y.T @ y / (len(y) - 1)),
            "You divided by N − 1. No mean was estimated: divide by N.",
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
    },
)
def matrix_R(y, H, P):
    """R̂ (m, m) from innovations y (N, m), H (m, n) and the prediction's covariance P (n, n); no floor."""
    return y.T @ y / len(y) - H @ P @ H.T


def logarithms(rng):
    """Normalised logarithms of weights, some hopeless, and log-likelihoods, some of them all very low."""
    logs = rng.choice([0, -1, -3, -20, -400, -1200], 3)
    likelihoods = rng.integers(-12, 3, 3) / 2 - rng.choice([0, 900]) - rng.choice([0, 0, 300, 800], 3)
    logs = logs - np.logaddexp.reduce(logs.astype(float))
    return logs, likelihoods


def settled(s):
    return s - np.logaddexp.reduce(s)


def multiplied(logs, likelihoods):
    p = np.exp(logs) * np.exp(likelihoods)
    return np.log(p / p.sum())


def unsafe(logs, likelihoods):
    return logs + likelihoods - np.log(np.sum(np.exp(logs + likelihoods)))


def floored(logs, likelihoods):
    s = logs + likelihoods
    p = np.maximum(np.exp(s - s.max()), 1e-300)
    return np.log(p / p.sum())


@exercise(
    hints=[
        "A product of weights is a sum of their logarithms. What is left to do is to make the weights, not the logarithms, sum to 1.",
        "Take off log Σ exp(s). If all s are below −745, every exp is 0: take the largest s off first, nothing is lost by it.",
        "NumPy has it ready: `np.logaddexp.reduce(s)` is log Σ exp(s) for s as low as you like.",
        "`s = log_weights + log_likelihoods`, then `return s - np.logaddexp.reduce(s)`",
    ],
    inputs=logarithms,
    wrong={
        "as published": (
            multiplied,
            "Still as published: between two logarithms you went through exp, and there a weight of e⁻⁸⁰⁰ becomes 0 for "
            "ever. Add the logarithms instead.",
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
            "You divided the logarithms by their sum. Dividing weights is *subtracting* a logarithm from each.",
        ),
        "old weights forgotten": (
            lambda logs, likelihoods: settled(likelihoods),
            "You weighed this reading alone. All readings before it are in log_weights: add them.",
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
        "weights": (
            lambda logs, likelihoods: np.exp(settled(logs + likelihoods)),
            "These are the weights, and the low ones are 0. Return the logarithms: only they remember how far behind.",
        ),
    },
)
def weigh(log_weights, log_likelihoods):
    """The logarithms of M weights after one more reading, from those before and the log-likelihoods of the reading."""
    s = log_weights + log_likelihoods
    s = s - s.max()
    return s - np.log(np.sum(np.exp(s)))


def bank(rng):
    """Weights, means (4, 2) and covariances (4, 2, 2) of a bank."""
    p = rng.integers(1, 9, 4).astype(float)
    factors = rng.integers(-2, 3, (4, 2, 2)) / 2 + 1.5 * np.eye(2)
    return p / p.sum(), rng.integers(-9, 10, (4, 2)) / 2, factors @ factors.mT + np.eye(2) / 2


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


@exercise(
    hints=[
        "The loop takes three things in step: over what does the first of them run? How many turns does it make for four filters?",
        "Each filter's mean must be compared with the joint mean, a vector, and every filter must have its turn.",
        "For each filter: its weight times (its covariance + np.outer(y, y)), with y = its mean − p @ means. Sum over all.",
        "`return sum(w * (P + np.outer(m - p @ means, m - p @ means)) for w, m, P in zip(p, means, covs))`",
    ],
    inputs=bank,
    wrong={
        "as published": (
            as_published,
            "That is still the published loop: its first item runs over the components of x, so it stops after two turns.",
        ),
        "one component": (
            lambda p, means, covs: mixed(p, means, covs, centre=(p @ means)[0]),
            "All four filters count now. But from each mean you subtract one component of x, a position, even from the "
            "velocity: subtract the vector.",
        ),
        "two filters": (
            lambda p, means, covs: mixed(p[:2], means[:2], covs[:2], centre=p @ means),
            "The difference is mended. The second fault remains: two of the four filters never have their turn.",
        ),
        "spread forgotten": (
            lambda p, means, covs: np.tensordot(p, covs, 1),
            "You averaged the covariances. When the filters disagree, the joint belief is wider than any of them: add "
            "p y yᵀ, y being how far each mean is from the joint one.",
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
            lambda p, means, covs: mixed(p, means, covs, weights=np.full(4, 0.25)),
            "All filters have the same say in your sum. Weigh each with its probability.",
        ),
        "fused": (
            lambda p, means, covs: np.linalg.inv(np.sum(np.linalg.inv(covs), axis=0)),
            "You fused the four as separate opinions. They have seen the same readings, and only one of them is right: it "
            "is a mixture, not a fusion.",
        ),
    },
)
def mixture_cov(p, means, covs):
    """The covariance (2, 2) of a bank's joint belief: weights p (4,), means (4, 2), covariances (4, 2, 2)."""
    apart = means - p @ means
    return np.tensordot(p, covs + apart[:, :, None] * apart[:, None, :], 1)
