"""Lesson 2, `table_of`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._slips.shared import table


def _table(a, b, c, d):
    return np.array([[a, b], [c, d]])


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


def _parts(x, y):
    return x - x.mean(), y - y.mean()


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


def parts(x, y):
    """The right variances and covariance."""
    return np.var(x), np.mean((x - x.mean()) * (y - y.mean())), np.var(y)


def with_corner(corner):
    """A table with the right variances and a corner made from (x, y, the right one)."""

    def made(x, y):
        a, c, b = parts(x, y)
        return table(a, corner(x, y, c), corner(x, y, c), b)

    return made


def from_the_first(x, y):
    away = np.array([x - x[0], y - y[0]])
    return away @ away.T / len(x)


def centred_in_the_corners(x, y):
    c = np.mean(x * y) - x.mean() * y.mean()
    return np.array([[np.mean(x * x), c], [c, np.mean(y * y)]])


WRONG = {
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
    "correlation in the corners": (
        with_corner(lambda x, y, c: c / (x.std() * y.std())),
        "The variances are right. In the corners stands the correlation, a pure number: the covariance is the mean of dx · dy, not divided by the σ's.",
    ),
    "N − 1 in the corners": (
        with_corner(lambda x, y, c: np.cov(x, y)[0, 1]),
        "The variances are right. In the corners you divided by N − 1, as `np.cov` does: divide by N there too.",
    ),
    "N − 1 on the diagonal": (
        lambda x, y: table(x.var(ddof=1), parts(x, y)[1], parts(x, y)[1], y.var(ddof=1)),
        "The corners are right. On the diagonal you divided by N − 1: divide by N there too.",
    ),
    "y not centred": (
        lambda x, y: table(parts(x, y)[0], parts(x, y)[1], parts(x, y)[1], np.mean(y * y)),
        "Three entries are right. For the variance of y take away the mean of y first.",
    ),
    "x not centred": (
        lambda x, y: table(np.mean(x * x), parts(x, y)[1], parts(x, y)[1], parts(x, y)[2]),
        "Three entries are right. For the variance of x take away the mean of x first.",
    ),
    "corners not centred": (
        with_corner(lambda x, y, c: np.mean(x * y)),
        "The variances are right. In the corners you averaged x · y: take the mean of each series away first.",
    ),
    "corner summed": (
        with_corner(lambda x, y, c: c * len(x)),
        "The variances are right. In the corners stands a sum over the pairs: divide by their number.",
    ),
    "product of variances": (
        with_corner(lambda x, y, c: x.var() * y.var()),
        "The variances are right. The corner is not their product: it is the mean of dx · dy, pair by pair.",
    ),
    "product of means": (
        with_corner(lambda x, y, c: x.mean() * y.mean()),
        "The variances are right. In the corners stands the product of the two means: a covariance is the mean of dx · dy.",
    ),
    "root of the corner": (
        with_corner(lambda x, y, c: np.sqrt(abs(c))),
        "The variances are right. You took the root of the corner: leave it as it is, with its sign.",
    ),
    "σ everywhere": (
        lambda x, y: table(x.std(), 0, 0, y.std()),
        "These are the standard deviations. The table holds variances, and in the corners the mean of dx · dy.",
    ),
    "from the first pair": (
        from_the_first,
        "These are means of products of distances from the first pair. A deviation is the distance from the mean "
        "of the series.",
    ),
    "centred in the corners alone": (
        centred_in_the_corners,
        "The corners are right. On the diagonal stand the means of x² and y²: take the mean of the series away "
        "first, there too.",
    ),
}
