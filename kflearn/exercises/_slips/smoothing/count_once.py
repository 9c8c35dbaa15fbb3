"""Lesson 23, `count_once`: wrong answers, each with the sentence that it gets."""


def meet(x, P, x_back, P_back, z, R, taken=1.0):
    """Both beliefs, and z with its weight taken out `taken` times."""
    information = 1 / P + 1 / P_back - taken / R
    return (x / P + x_back / P_back - taken * z / R) / information, 1 / information


LEFT_OUT = "The variance is right. In the weighted sum of the mean z still counts twice: take z/R out of it too."


def met(x, P, x_back, P_back):
    """Two beliefs, fused."""
    information = 1 / P + 1 / P_back
    return (x / P + x_back / P_back) / information, 1 / information


def R_taken_off(x, P, x_back, P_back, z, R):
    V = 1 / (1 / P + 1 / P_back) - R
    return V * (x / P + x_back / P_back - z / R), V


def outside(x, P, x_back, P_back, z, R):
    V = 1 / (1 / P + 1 / P_back - 1 / R)
    return V * (x / P + x_back / P_back) - z / R, V


def fused(x, P, x_back, P_back):
    V = 1 / (1 / P + 1 / P_back)
    return V * (x / P + x_back / P_back), V


def z_itself_taken_off(x, P, x_back, P_back, z, R):
    mean, V = fused(x, P, x_back, P_back)
    left = 1 / (1 / V - 1 / R)
    return mean - left / R * z, left


def undone_with_the_gain(x, P, x_back, P_back, z, R):
    mean, V = fused(x, P, x_back, P_back)
    return mean - V / R * (z - mean), V + V**2 / R


WRONG = {
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
        "The variance is right. The mean still leans towards z: take z/R out of the sum x/P + x_back/P_back too.",
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
    "z left in the sum": (
        lambda x, P, x_back, P_back, z, R: (
            (x / P + x_back / P_back) / (1 / P + 1 / P_back - 1 / R),
            1 / (1 / P + 1 / P_back - 1 / R),
        ),
        LEFT_OUT,
    ),
    "R off P_back": (
        lambda x, P, x_back, P_back, z, R: met(x, P, x_back, P_back - R),
        "You subtracted R from P_back. A reading is not taken out of a variance but out of the information: 1/P_back − 1/R. And z itself must leave the mean.",
    ),
    "information, z left in": (
        lambda x, P, x_back, P_back, z, R: met(x, P, x_back, 1 / (1 / P_back - 1 / R)),
        "The variance is right. x_back still holds z, and you weigh it with 1/P_back − 1/R. It keeps its full weight, x_back/P_back, and z/R is taken from the weighted sum.",
    ),
    "plain mean": (
        lambda x, P, x_back, P_back, z, R: ((x + x_back) / 2, (P + P_back) / 4),
        "You took the plain mean of the two. Weigh each with its information, 1/P and 1/P_back, and take z out once.",
    ),
    "plain means": (
        lambda x, P, x_back, P_back, z, R: ((x + x_back) / 2, (P + P_back) / 2),
        "You took the plain mean of the two. Weigh each with its information, 1/P and 1/P_back, and take z out once.",
    ),
    "forward alone": (
        lambda x, P, x_back, P_back, z, R: (x, P),
        "That is the forward belief. The backward one knows readings that come later: use both.",
    ),
    "backward alone": (
        lambda x, P, x_back, P_back, z, R: (x_back, P_back),
        "That is the backward belief. The forward one knows readings that came before: use both.",
    ),
    "z/R off the mean": (
        lambda x, P, x_back, P_back, z, R: (met(x, P, x_back, P_back)[0] - z / R, 1 / (1 / P + 1 / P_back - 1 / R)),
        "The variance is right. z/R is taken off the mean here; take it off the weighted sum, before you divide by the information.",
    ),
    "z off the mean": (
        lambda x, P, x_back, P_back, z, R: (met(x, P, x_back, P_back)[0] - z, 1 / (1 / P + 1 / P_back - 1 / R)),
        "The variance is right. z is taken off the mean here; take z/R off the weighted sum, before you divide by the information.",
    ),
    "R off the variance": (
        R_taken_off,
        "A reading is taken out of the information, not of the variance: subtract 1/R before you invert.",
    ),
    "z/R outside the brackets": (
        outside,
        "The variance is right. z/R is subtracted after the multiplication by the variance: it belongs inside, (x/P + x_back/P_back − z/R).",
    ),
    "z taken off the fused mean": (
        z_itself_taken_off,
        "The variance is right. Your mean is the fused one, less z times variance/R: the fused mean keeps its old "
        "weights. Take z/R out of the weighted sum first, and multiply all of it by the new variance.",
    ),
    "undone with a gain": (
        undone_with_the_gain,
        "It answers as if z were undone with the gain V/R, V being the variance of both beliefs together. That is "
        "about right only if R is much larger than V. Take 1/R out of the information instead.",
    ),
}
