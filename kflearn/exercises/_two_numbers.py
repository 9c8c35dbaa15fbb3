"""Wrong answers to exercises of lesson 2, each with the sentence that it gets."""

import math

import numpy as np
from scipy.stats import norm


def _table(a, b, c, d):
    return np.array([[a, b], [c, d]])


def _parts(x, y):
    return x - x.mean(), y - y.mean()


def not_centred(x, y):
    return _table((x * x).mean(), (x * y).mean(), (x * y).mean(), (y * y).mean())


def divided_by_one_less(x, y):
    return np.cov(x, y)


def sums(x, y):
    return np.cov(x, y, bias=True) * len(x)


def correlation(x, y):
    return np.corrcoef(x, y)


def no_corner(x, y):
    return np.diag([x.var(), y.var()])


def deviations_on_the_diagonal(x, y):
    dx, dy = _parts(x, y)
    return _table(x.std(), (dx * dy).mean(), (dx * dy).mean(), y.std())


def product_of_sigmas(x, y):
    both = x.std() * y.std()
    return _table(x.var(), both, both, y.var())


def absolute(x, y):
    dx, dy = _parts(x, y)
    corner = abs(dx * dy).mean()
    return _table(x.var(), corner, corner, y.var())


def exchanged(x, y):
    return np.cov(y, x, bias=True)


def minus_corner(x, y):
    dx, dy = _parts(x, y)
    corner = -(dx * dy).mean()
    return _table(x.var(), corner, corner, y.var())


def the_corner_alone(x, y):
    dx, dy = _parts(x, y)
    return (dx * dy).mean()


def one_corner(x, y):
    dx, dy = _parts(x, y)
    return _table(x.var(), (dx * dy).mean(), 0, y.var())


WRONG = {
    "table_of": {
        "not centred": (
            not_centred,
            "You averaged products of the numbers themselves. Take the means away first: a covariance is made of deviations.",
        ),
        "N − 1": (
            divided_by_one_less,
            "You divided by N − 1, as `np.cov` does. Here the plain mean over the pairs is asked for: divide by N.",
        ),
        "sums": (sums, "These are sums over the pairs. A variance is a mean: divide by the number of pairs."),
        "correlation": (
            correlation,
            "These are correlations, pure numbers with ones on the diagonal. A covariance keeps its units: do not divide by the σ's.",
        ),
        "no corner": (
            no_corner,
            "The variances are right; the corners are 0. They are the mean of dx · dy, once above and once below the diagonal.",
        ),
        "σ on the diagonal": (
            deviations_on_the_diagonal,
            "The corners are right. On the diagonal you have standard deviations; a covariance matrix holds variances, σ².",
        ),
        "product of σ": (
            product_of_sigmas,
            "σx · σy is the largest that the corner can be. It is smaller where the two do not quite go together: take the mean of dx · dy.",
        ),
        "absolute": (
            absolute,
            "You took the size of each product. The signs matter: where one number is high while the other is low, the product is negative.",
        ),
        "exchanged": (exchanged, "The two series are exchanged: the variance of x belongs at the top left."),
        "minus": (
            minus_corner,
            "The corners have the wrong sign: two numbers that are high together have a positive covariance.",
        ),
        "corner alone": (
            the_corner_alone,
            "That is the corner alone. Return the whole table: two variances on the diagonal and the covariance twice.",
        ),
        "one corner": (
            one_corner,
            "The covariance stands in both corners: the table is the same when its rows and columns are exchanged.",
        ),
    },
    "table_length": {
        "independent": (
            math.sqrt(18),
            "√(9 + 9) holds for errors that have nothing in common. These share most of their error: the corner must be subtracted, twice.",
        ),
        "added": (
            math.sqrt(18 + 14.4),
            "5.69 is √(9 + 9 + 2 · 7.2), the σ of a sum. The length is a difference: A = [−1, 1], and the products of A's entries with the corner are negative.",
        ),
        "variance": (3.6, "3.6 mm² is the variance of the length. σ is its root."),
        "corner once": (math.sqrt(18 - 7.2), "The corner stands twice in P, so it counts twice: 9 + 9 − 2 · 7.2."),
        "σ instead of σ²": (
            math.sqrt(6 - 1.6),
            "2.1 is √(3 + 3 − 2 · 0.8), with σ = 3 mm on the diagonal. A covariance matrix holds variances: 9 mm², and 0.8 · 3 · 3 in the corner.",
        ),
        "correlation as covariance": (
            math.sqrt(18 - 1.6),
            "0.8 is the correlation, a pure number. The corner of P is 0.8 · 3 mm · 3 mm = 7.2 mm².",
        ),
        "correlation on 3": (
            math.sqrt(18 - 2 * 2.4),
            "The corner is the correlation times both σ: 0.8 · 3 · 3, not 0.8 · 3.",
        ),
        "one end": (3.0, "3 mm is the σ of one end. The length depends on both ends and on what their errors share."),
        "added σ": (6.0, "The σ's do not add. Variances do, and here twice the corner is subtracted from their sum."),
        "subtracted σ": (
            0.0,
            "0 would be so if the two errors were equal, with correlation 1. These share only a part: the two variances add up, and twice the corner is subtracted.",
        ),
        "1 − ρ of σ": (
            0.6,
            "0.6 is 3 · (1 − 0.8), or √(1 − 0.8²): a share of one σ is not the σ of a difference. Calculate with variances: A P Aᵀ, then the root.",
        ),
        "√(1 − ρ²)": (
            1.8,
            "1.8 is 3 · √(1 − 0.8²), what is left of one end's σ when the other end's error is known; or 9 − 7.2, one variance less the corner. The difference of the two is asked for: A P Aᵀ, and its root.",
        ),
        "0.9·": (0.8, "That is the correlation. Build P from it and calculate A P Aᵀ with A = [−1, 1]."),
        "corner": (7.2, "7.2 mm² is the corner of P. Go on: 9 + 9 − 2 · 7.2, and the root."),
        "sum of variances": (
            18.0,
            "18 mm² is the sum of the two variances. Subtract twice the corner, then take the root.",
        ),
    },
    "told_speed": {
        "nothing learnt": (
            10.0,
            "10 m/s was expected before. The position and the velocity err together, so a cart that is further ahead is, on average, faster.",
        ),
        "deviation": (
            6 / 13 * 3,
            "That is how much faster these carts are than expected. The velocity itself was asked for: add the 10 m/s.",
        ),
        "minus": (
            10 - 6 / 13 * 3,
            "That is slower than the average cart. The corner is positive, so carts that are further ahead are faster: 10 m/s and the step, not 10 m/s less the step.",
        ),
        "corner": (
            10 + 6 * 3,
            "28 is 10 + 6 · 3. The corner must be divided by the variance of the position, 13 m².",
        ),
        "over the velocity's variance": (
            10 + 6 / 4 * 3,
            "14.5 is 10 + 6/4 · 3, with the variance of the velocity below the line. What was told is the position: divide by its variance, 13 m².",
        ),
        "the reciprocal": (
            10 + 13 / 6 * 3,
            "That is variance over corner. Corner over variance has the unit that turns metres into m/s.",
        ),
        "roots": (
            10 + 6 / math.sqrt(13) * 3,
            "14.99 is 10 + 6/√13 · 3, with σ of the position below the line. The step is corner over variance: 6 / 13.",
        ),
        "correlation": (
            10 + 6 / math.sqrt(52) * 3,
            "12.5 is 10 + 0.832 · 3. 0.832 is the correlation, 6/√(13 · 4), which has no unit. Corner over variance of the position has (m/s)/m.",
        ),
        "both σ": (
            10 + math.sqrt(4 / 13) * 3,
            "That would be so if the two were tied completely, one σ of the velocity for each σ of the position. Use the corner: 6 / 13.",
        ),
        "for one metre": (
            10 + 6 / 13,
            "10 + 6/13 is for a cart 1 m further ahead; this one is 3 m further. (10 · 63/60, in proportion, leaves the corner out.)",
        ),
        "ratio alone": (6 / 13, "That is how much faster for each metre. Go on: 3 m, and on top of 10 m/s."),
        "3 m in a second": (
            13.0,
            "13 is 10 + 3, metres added to metres per second; or it is the variance of the position. Take corner over variance, 6/13 (m/s)/m, for each of the 3 m, on top of 10 m/s.",
        ),
    },
    "scale_for": {
        "one number": (
            lambda share: norm.interval(share)[1],
            "That is right for one number: 1.96 for 95 %. With two numbers both have to be inside: solve share = 1 − exp(−k²/2).",
        ),
        "one-sided": (
            lambda share: norm.ppf(share),
            "`norm.ppf` is the quantile of one number, and of one side. For two numbers solve share = 1 − exp(−k²/2) for k.",
        ),
        "no root": (lambda share: -2 * np.log(1 - share), "That is k². Take the root."),
        "no 2": (
            lambda share: np.sqrt(-np.log(1 - share)),
            "exp(−k²/2) = 1 − share gives k² = −2 ln(1 − share): the 2 is missing.",
        ),
        "share for 1 − share": (
            lambda share: np.sqrt(-2 * np.log(share)),
            "That ellipse leaves the share outside. Inside is 1 − exp(−k²/2).",
        ),
        "log10": (
            lambda share: np.sqrt(-2 * np.log10(1 - share)),
            "`np.log10` is the logarithm to base 10. The formula has exp: use `np.log`.",
        ),
        "forwards": (
            lambda share: 1 - np.exp(-(share**2) / 2),
            "That is the share for a given k. It is k for a given share that is asked for: solve the formula for k.",
        ),
        "half": (
            lambda share: np.sqrt(-np.log(1 - share) / 2),
            "That is half of k: k² = −2 ln(1 − share), without another division by 2.",
        ),
        "root of both": (
            lambda share: norm.interval(np.sqrt(share))[1],
            "That is a square whose two sides hold √share each. An ellipse leaves the square's corners out: solve share = 1 − exp(−k²/2).",
        ),
        "always 2.45": (lambda share: 2.4477, "2.45 is right for 95 %. The function must work for every share."),
    },
}
