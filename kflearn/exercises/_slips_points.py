"""More wrong answers to exercises of lesson 17, each with the sentence that it gets."""

import numpy as np


def image(degrees):
    """The y-coordinate at a distance of 100 m."""
    return 100 * np.sin(np.radians(degrees))


def points(mean, covariance, scale):
    """The points of a belief."""
    rows = np.linalg.cholesky(scale * covariance).T
    return np.vstack([mean, mean + rows, mean - rows])


def pushed(mean, P, Q, scale):
    """The points of P, each outer one moved by the diagonal of Q."""
    push = np.diag(np.diag(Q))
    return points(mean, P, scale) + np.vstack([0 * mean, push, -push])


def symmetric(P):
    """The symmetric root of a covariance."""
    sizes, directions = np.linalg.eigh(P)
    return (directions * np.sqrt(np.maximum(sizes, 0))) @ directions.T


def along_axes(P):
    """The axes of the ellipse, as rows."""
    sizes, directions = np.linalg.eigh(P)
    return (directions * np.sqrt(np.maximum(sizes, 0))).T


def spread(mean, rows):
    """The points mean, mean + rows, mean − rows."""
    return np.vstack([mean, mean + rows, mean - rows])


FIRST = {
    -1: "Right for α = 1.",
    3: "α = 1: 3 is n + κ; take off n = 4.",
    1: "α = 1: the sign is turned round, κ = 3/α² − n.",
    0: "α = 1: with κ = 0 the declaration gives 4, and the program works with 3.",
    -3: "α = 1: −3 would be right for n = 6. The program has four states.",
    7: "α = 1: n is taken off, not added.",
    8: "8 belongs to α = ½. The first number is for α = 1.",
}
SECOND = {
    8: "Right for α = ½.",
    -1: "α = ½: α² multiplies n + κ, so another κ is needed than for α = 1.",
    2: "α = ½: 2 is 3/α − 4; the scale holds α², a quarter.",
    12: "α = ½: 12 is n + κ; take off n = 4.",
    -4: "α = ½: −4 is λ/α², with λ = −1. It is n + κ, not κ alone, that α² multiplies.",
    -0.25: "α = ½: −0.25 is λα², with λ = −1. Solve α²(4 + κ) = 3 for κ.",
    -3.25: "α = ½: −3.25 is 3α² − 4; 3 must be divided by α².",
    -2.5: "α = ½: −2.5 is 3α − 4; 3 must be divided by α².",
    44: "α = ½: 44 is 3/α⁴ − 4; the declaration holds α².",
    6: "α = ½: 6 would be right for n = 6. The program has four states.",
    16: "α = ½: 16 is 3/α² + 4. n is taken off, not added.",
    13: "α = ½: from 3/α² = 12 the number of states comes off, 4, not κ = −1.",
    11: "α = ½: from 3/α² = 12 the number of states comes off, 4.",
    -8: "α = ½: the sign is turned round, κ = 3/α² − n.",
    0: "α = ½: with κ = 0 the declaration gives 1, and the program works with 3.",
    0.75: "α = ½: 0.75 is α² · 3. Solve α²(4 + κ) = 3 for κ.",
    -1.75: "α = ½: α² stands before 4 as well. Solve α²(4 + κ) = 3 for κ.",
}
PAIRS = [(-1, two) for two in (-4, -0.25, 6, 16, 13, 11, -8, 0, 0.75, -1.75)]
PAIRS += [(one, 8) for one in (3, 1, 0, -3, 7, 8)]
PAIRS += [(-3, 6), (0, 12), (7, 16), (0, -1), (3, -1), (3, 0.75)]
KAPPAS = {f"{one} and {two}": ((one, two), f"{FIRST[one]} {SECOND[two]}") for one, two in dict.fromkeys(PAIRS)}


MORE = {
    "declared_kappa": KAPPAS,
    "three_points": {
        "outer weights 1/s": (
            lambda: 100 * (2 / 3 + 2 / 3 * np.cos(np.radians(30) * 3**0.5)),
            "That is what outer points make which weigh 1/scale = 1/3 each. They weigh 1/(2 scale), so that all weights sum to 1.",
        ),
        "n = 2": (
            lambda: 100 * (1 / 2 + 2 / 8 * np.cos(np.radians(60))),
            "62.5 m is what n = 2 makes, with a scale of 4. One number is uncertain, the angle: n = 1, and the scale is α²(n + κ) = 3.",
        ),
        "true mean, the half forgotten": (
            lambda: 100 * np.exp(-(np.radians(30) ** 2)),
            "That is 100 e^(−σ²). The true mean has σ²/2 in the exponent; asked is the weighted sum of the three points.",
        ),
        "second order": (
            lambda: 100 * (1 - np.radians(30) ** 2 / 2),
            "That is 100 (1 − σ²/2), the curve's second order. Asked is the weighted sum of the three points.",
        ),
        "the outer ones alone": (
            lambda: image(90 + np.sqrt(3) * 30) / 3,
            "Those are the two outer points with their weights. The centre, with 2/3, is missing.",
        ),
        "kappa over scale, one sigma": (
            lambda: (2 * 100 + 2 * image(90 + np.sqrt(3) * 30)) / 4,
            "That is what the right points make with the weights ½ and ¼. With a scale of 3 they are 1 − 1/3 and 1/(2 · 3).",
        ),
        "six": (
            lambda: 2 / 3 * 100 + 1 / 3 * image(90 + np.sqrt(6) * 30),
            "That is what the right weights make of outer points at ±√6 · 30°. The scale is α²(n + κ) = 1 · (1 + 2).",
        ),
        "along the arc": (90.0, "90° is the mean of the angle. Asked is the mean of the images, in metres."),
        "the root of κ": (
            lambda: 2 / 3 * 100 + 1 / 3 * image(90 + np.sqrt(2) * 30),
            "That is what the right weights make of outer points at ±√2 · 30°, with the root of κ. The scale is α²(n + κ) = 3, so they sit at ±√3 · 30°.",
        ),
        "equal weights, one sigma": (
            lambda: (100 + 2 * image(120)) / 3,
            "That is the plain mean of the images of 90°, 60° and 120°. The outer points sit at ±√3 · 30°; and the weights are 2/3 for the centre, 1/6 for each of the others.",
        ),
        "outer points alone": (
            lambda: image(90 + np.sqrt(3) * 30),
            "That is the image of an outer point, and the mean of both. The centre counts as well, with a weight of 2/3.",
        ),
        "a third each way": (
            lambda: 100 / 3 + image(90 + np.sqrt(3) * 30) / 3,
            "That is what the right points make with the weights 1/3, 1/6 and 1/6, which sum to 2/3: the centre has 2/3 by itself, the other two 1/6 each.",
        ),
        "how much it sinks": (
            lambda: 100 / 3 * (1 - np.sin(np.radians(90 + np.sqrt(3) * 30))),
            "That is how far the mean sinks below 100 m. The question asks for the mean itself.",
        ),
    },
    "redrawn": {
        "symmetric root": (
            lambda mean, P, Q, scale: spread(mean, symmetric(scale * (P + Q))),
            "The covariance of your points is right, but you took the symmetric root. Here the points are wanted that `sigma_points` draws, with the Cholesky root.",
        ),
        "axes of the ellipse": (
            lambda mean, P, Q, scale: spread(mean, along_axes(scale * (P + Q))),
            "The covariance of your points is right, but they lie on the axes of the ellipse. Here the points are wanted that `sigma_points` draws, with the Cholesky root.",
        ),
        "Q taken off": (
            lambda mean, P, Q, scale: points(mean, P - Q, scale),
            "You took Q off P. Q has made the belief wider: its covariance is P + Q.",
            r"P *- *Q|Q *- *P",
        ),
        "n for the scale": (
            lambda mean, P, Q, scale: points(mean, P + Q, len(mean)),
            "The covariance is right. It is multiplied by n; use `scale`, which is handed in.",
        ),
        "√scale in the covariance": (
            lambda mean, P, Q, scale: points(mean, P + Q, np.sqrt(scale)),
            "The covariance is right. It is multiplied by √scale: the covariance is multiplied by the scale, or its root by √scale.",
        ),
        "mean of both": (
            lambda mean, P, Q, scale: points(mean, (P + Q) / 2, scale),
            "Those are the points of (P + Q)/2. The widened belief has the sum of P and Q, and the scale as it is.",
        ),
        "P, Q apart": (
            lambda mean, P, Q, scale: np.vstack([points(mean, P, scale), points(mean, Q, scale)[1:]]),
            "You drew points for P and for Q. One set of 2n + 1 points must represent the widened belief, whose covariance is P + Q.",
        ),
        "Q squared": (
            lambda mean, P, Q, scale: points(mean, P + Q @ Q, scale),
            "Those are the points of P + Q Q. Q is a covariance already: add it as it is.",
        ),
        "fused": (
            lambda mean, P, Q, scale: points(mean, np.linalg.inv(np.linalg.inv(P) + np.linalg.inv(Q)), scale),
            "Those are the points of P and Q fused, which is narrower than both. A push with covariance Q makes the belief wider: P + Q.",
        ),
        "Q twice": (
            lambda mean, P, Q, scale: points(mean, P + 2 * Q, scale),
            "Those are the points of P + 2Q. The belief was widened once: its covariance is P + Q.",
        ),
        "Q on the points": (
            pushed,
            "Those are the points of P, moved by the diagonal of Q. Q is a covariance: add it to P first, then draw the points.",
        ),
        "centre last": (
            lambda mean, P, Q, scale: np.roll(points(mean, P + Q, scale), -1, axis=0),
            "The right points in another order: first the centre, then all with plus, then all with minus.",
        ),
        "variances only": (
            lambda mean, P, Q, scale: points(mean, np.diag(np.diag(P + Q)), scale),
            "Those are the points of the variances alone. The other entries of P + Q belong to the belief too: take the root of all of it.",
        ),
        "root entry by entry": (
            lambda mean, P, Q, scale: np.vstack(
                [mean, *(mean + side * np.sqrt(abs(scale * (P + Q))) for side in (1, -1))]
            ),
            "You took the root entry by entry. The root of a matrix L fulfils L Lᵀ = scale · (P + Q): `np.linalg.cholesky`.",
        ),
    },
    "start_nees": {
        "six times the sum": (
            6 * 0.042,
            "That is six times the sum. The six terms are added, and that is all: an honest start has 6 because each of its terms is 1.",
        ),
        "six times the quotient": (
            6 * 2.0202 / 202.2,
            "That is six times the quotient of the two sums of variances. Each component has its own unit and its own claim: divide each, then add all six.",
        ),
        "one ratio": (
            0.01,
            "That is the ratio of the positions, or of the velocities. Add up the ratios of all six components.",
        ),
        "one acceleration": (
            0.041,
            "One of the two accelerations is missing: each entry stands twice on the diagonal.",
        ),
        "four with two": (
            0.022,
            "Two of the ratios of 1/100 are missing: the ratios are 1/100, 0.01/1 and 0.0001/0.1, each twice.",
        ),
        "accelerations alone": (0.002, "Those are the two accelerations. Position and velocity belong to the sum too."),
        "one of the first two": (0.032, "One ratio is missing: each entry stands twice on the diagonal."),
        "mean of three": (
            0.042 / 3,
            "That is a third of the sum. eᵀP₀⁻¹e adds the six ratios.",
        ),
        "all a hundredth": (
            0.06,
            "0.06 is six times 1/100. For the accelerations the ratio is 0.0001/0.1, which is 1/1000.",
        ),
        "inverse of the claim": (
            2 * (0.01 + 1 + 10),
            "That is the sum of the inverses of what P₀ claims, as if e² were 1 for all. Each is to be multiplied by its real variance in Q.",
        ),
        "one": (
            1.0,
            "1 would be an honest start, as a mean of the six. Asked is the sum of six ratios, and here each of them is small.",
        ),
    },
}
