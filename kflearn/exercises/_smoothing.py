"""Wrong answers to exercises of lesson 23, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._smoothing_step import STEP_BACK


def meet(x, P, x_back, P_back, z, R, taken=1.0):
    """Both beliefs, and z with its weight taken out `taken` times."""
    information = 1 / P + 1 / P_back - taken / R
    return (x / P + x_back / P_back - taken * z / R) / information, 1 / information


def inverses_of_entries(P, P_back):
    with np.errstate(all="ignore"):
        return 1 / (1 / P + 1 / P_back)


WRONG = {"step_back": STEP_BACK}

WRONG["smoothed_cov"] = {
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
}

WRONG["count_once"] = {
    "as published": (
        lambda *given: meet(*given, taken=0),
        "Still as published: z sits in both beliefs and counts twice. Take 1/R out of the information, once.",
    ),
    "taken out twice": (
        lambda *given: meet(*given, taken=2),
        "Here z does not count at all: it is in there twice, and is taken out twice. Once is enough.",
    ),
    "added once more": (
        lambda *given: meet(*given, taken=-1),
        "Here z counts three times. It is too often in there: subtract 1/R and z/R.",
    ),
    "variance only": (
        lambda *given: (meet(*given, taken=0)[0], meet(*given)[1]),
        "The variance is right. The mean still leans towards z: take z/R out of the weighted sum too.",
    ),
    "mean not renewed": (
        lambda x, P, x_back, P_back, z, R: (
            (x / P + x_back / P_back - z / R) / (1 / P + 1 / P_back),
            1 / (1 / P + 1 / P_back - 1 / R),
        ),
        "The variance is right. Divide the weighted sum by the new information, with 1/R taken out.",
    ),
    "z not weighted": (
        lambda x, P, x_back, P_back, z, R: (
            (x / P + x_back / P_back - z) / (1 / P + 1 / P_back - 1 / R),
            1 / (1 / P + 1 / P_back - 1 / R),
        ),
        "The variance is right. In the sum of the mean z carries the weight 1/R, like the others theirs: take out z/R.",
    ),
    "information": (
        lambda *given: (meet(*given)[0], 1 / meet(*given)[1]),
        "The mean is right. The second number is the information; its inverse is the variance.",
    ),
    "P + R": (
        lambda x, P, x_back, P_back, z, R: meet(x, P, x_back, P_back + R, z, R, taken=0),
        "Adding R to P_back does not undo a reading: it makes the belief vaguer, but its mean still leans on z.",
    ),
    "R taken off": (
        lambda x, P, x_back, P_back, z, R: ((P_back * x + P * x_back) / (P + P_back), P * P_back / (P + P_back) - R),
        "Here R is taken off the variance. A reading is taken out of the information: 1/R off 1/P + 1/P_back.",
    ),
    "variance not mended": (
        lambda *given: (meet(*given)[0], meet(*given, taken=0)[1]),
        "The mean is right. The variance still counts z twice: take 1/R out of the information.",
    ),
    "not divided": (
        lambda x, P, x_back, P_back, z, R: (x / P + x_back / P_back - z / R, 1 / (1 / P + 1 / P_back - 1 / R)),
        "The variance is right. The mean is the weighted sum multiplied by this variance.",
    ),
    "half taken out": (
        lambda *given: meet(*given, taken=0.5),
        "Here half of z is taken out. It is in both beliefs, so one whole of it is too much.",
    ),
    "only the weighted sum": (
        lambda x, P, x_back, P_back, z, R: (
            (x / P + x_back / P_back - z / R) / (1 / P + 1 / P_back),
            1 / (1 / P + 1 / P_back),
        ),
        "You took z out of the weighted sum only. Take 1/R out of the information as well.",
    ),
    "plain sums": (
        lambda x, P, x_back, P_back, z, R: (x + x_back - z, P + P_back - R),
        "You added and subtracted the numbers themselves. Weigh each with its information: 1/P, 1/P_back, 1/R.",
    ),
    "the mean alone": (
        lambda *given: meet(*given)[0],
        "The mean is right. Return the variance too.",
    ),
    "z added to the sum": (
        lambda x, P, x_back, P_back, z, R: (
            (x / P + x_back / P_back + z / R) / (1 / P + 1 / P_back - 1 / R),
            1 / (1 / P + 1 / P_back - 1 / R),
        ),
        "The variance is right. In the weighted sum z/R is taken out too: subtract it.",
    ),
}
