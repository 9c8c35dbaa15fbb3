"""Lesson 23, `smoothed_cov`: wrong answers, each with the sentence that it gets."""

import numpy as np


def inverses_of_entries(P, P_back):
    with np.errstate(all="ignore"):
        return 1 / (1 / P + 1 / P_back)


WRONG = {
    "as published": (
        lambda P, P_back: P / 2,
        "That is still the published idea: half, wherever in the record. P_back decides how much comes from behind.",
    ),
    "sum": (
        lambda P, P_back: P + P_back,
        "You added the covariances: two opinions would be worse than one. It is their inverses that add.",
    ),
    "mean": (
        lambda P, P_back: (P + P_back) / 2,
        "You averaged the covariances. The result must be smaller than either: add their inverses.",
    ),
    "outer inverse forgotten": (
        lambda P, P_back: np.linalg.inv(P) + np.linalg.inv(P_back),
        "That is the information, in 1/m². Invert it once more to have a covariance.",
    ),
    "inverse of the sum": (
        lambda P, P_back: np.linalg.inv(P + P_back),
        "You inverted the sum. It is the other way round: sum the inverses, then invert.",
    ),
    "entry by entry": (
        lambda P, P_back: P * P_back / (P + P_back),
        "Right for a single number. Entry by entry it forgets how the two tilts cross: multiply and invert whole matrices.",
    ),
    "inverses entry by entry": (
        inverses_of_entries,
        "You took 1/P entry by entry. The inverse of a matrix is `np.linalg.inv(P)`.",
    ),
    "variances only": (
        lambda P, P_back: np.diag(1 / (1 / np.diag(P) + 1 / np.diag(P_back))),
        "The variances are fused alone. With the tilts each becomes smaller still: fuse the whole matrices.",
    ),
    "subtracted": (
        lambda P, P_back: P - P_back,
        "You subtracted the covariances. It is the inverses that add, and the sum is inverted.",
    ),
    "quarter of the sum": (
        lambda P, P_back: (P + P_back) / 4,
        "That is the covariance of the plain mean of both. The best weights are not equal: add the inverses, then invert.",
    ),
    "the smaller": (
        lambda P, P_back: P if np.trace(P) < np.trace(P_back) else P_back,
        "That is the smaller one of the two. Both know something: fuse them.",
    ),
    "difference": (
        lambda P, P_back: np.linalg.inv(np.linalg.inv(P) - np.linalg.inv(P_back)),
        "That is (P⁻¹ − P_back⁻¹)⁻¹, with information taken away. The readings behind add theirs.",
    ),
    "P on both sides": (
        lambda P, P_back: P @ np.linalg.inv(P + P_back) @ P,
        "That is what is taken off P: the covariance that is wanted is P minus this.",
    ),
    "P_back on both sides": (
        lambda P, P_back: P_back @ np.linalg.inv(P + P_back) @ P_back,
        "That is what is taken off P_back. Either P_back minus this, or P in place of one of them.",
    ),
    "product": (
        lambda P, P_back: P @ P_back,
        "You multiplied the two, which gives m⁴. Between them stands the inverse of their sum.",
    ),
    "smaller entries": (
        lambda P, P_back: np.minimum(P, P_back),
        "You took the smaller entry of the two, place by place. Both filters know something: fuse them.",
    ),
    "matrix product, plain division": (
        lambda P, P_back: P @ P_back / (P + P_back),
        "You divided entry by entry. For matrices it is the inverse: `np.linalg.inv(P + P_back)`.",
    ),
    "half of the backward filter": (
        lambda P, P_back: P_back / 2,
        "Half again, now of the backward filter. Both decide: add their inverses.",
    ),
    "the forward filter's": (
        lambda P, P_back: P,
        "That is the forward filter's covariance. The readings behind it add their information.",
    ),
    "order of the product": (
        lambda P, P_back: P @ P_back @ np.linalg.inv(P + P_back),
        "The order counts with matrices: the inverse of the sum stands between the two, P (P + P_back)⁻¹ P_back.",
    ),
    "inverse first": (
        lambda P, P_back: np.linalg.inv(P + P_back) @ P @ P_back,
        "The order counts with matrices: the inverse of the sum stands between the two, P (P + P_back)⁻¹ P_back.",
    ),
    "the gain": (
        lambda P, P_back: P @ np.linalg.inv(P + P_back),
        "That is the gain, which has no unit. A covariance in m² is wanted: multiply by P_back.",
    ),
    "the other gain": (
        lambda P, P_back: P_back @ np.linalg.inv(P + P_back),
        "That is a gain, which has no unit. A covariance in m² is wanted: multiply by P.",
    ),
    "the gain, turned": (
        lambda P, P_back: np.linalg.inv(P + P_back) @ P,
        "That is a gain, which has no unit. A covariance in m² is wanted: P_back is missing on its left.",
    ),
    "gain once in P": (
        lambda P, P_back: P - P @ np.linalg.inv(P + P_back),
        "A gain is taken off a covariance. It multiplies one first: P − P (P + P_back)⁻¹ P.",
    ),
    "variances of the inverses": (
        lambda P, P_back: np.diag(np.diag(np.linalg.inv(np.linalg.inv(P) + np.linalg.inv(P_back)))),
        "The variances are right. The other entries are not zero: return the whole matrix.",
    ),
    "the smaller determinant": (
        lambda P, P_back: P if np.linalg.det(P) < np.linalg.det(P_back) else P_back,
        "That is whichever of the two has the smaller determinant. Both know something: fuse them, and the result "
        "is surer than either.",
    ),
    "one inverse forgotten": (
        lambda P, P_back: np.linalg.inv(np.linalg.inv(P) + P_back),
        "You added P_back to the inverse of P. Both are inverted: P⁻¹ + P_back⁻¹.",
    ),
    "the other inverse forgotten": (
        lambda P, P_back: np.linalg.inv(P + np.linalg.inv(P_back)),
        "You added P to the inverse of P_back. Both are inverted: P⁻¹ + P_back⁻¹.",
    ),
    "mean of the inverses": (
        lambda P, P_back: 2 * np.linalg.inv(np.linalg.inv(P) + np.linalg.inv(P_back)),
        "Twice too large, as from the mean of the two inverses: add them up.",
    ),
}
