"""Lesson 17: five points through a bend."""

import numpy as np

from kflearn.exercises import _slips_fifth_late_facts as facts
from kflearn.exercises._slips_fifth_late_points import WRONG as FIFTH
from kflearn.exercises._slips_fourth_later import WRONG as FOURTH
from kflearn.exercises._slips_more import WRONG as NEW
from kflearn.exercises._slips_points import MORE
from kflearn.exercises._slips_seventh_late import WRONG as SEVENTH
from kflearn.exercises._slips_tenth_late import WRONG as TENTH
from kflearn.exercises._slips_third_filters import WRONG as THIRD
from kflearn.exercises.engine import exercise


def image(degrees):
    """The y-coordinate at a distance of 100 m."""
    return 100 * np.sin(np.radians(degrees))


@exercise(
    hints=[
        "First the rule for n = 1: the scale is α²(n + κ), the centre weighs 1 − n/scale, each of the others 1/(2 scale).",
        "The scale is 3: weights 2/3, 1/6, 1/6, and the outer points √3 standard deviations from 90°.",
        "2/3 · 100 + 1/6 · 100 sin(90° + √3 · 30°) + 1/6 · 100 sin(90° − √3 · 30°); √3 · 30° is 51.96°.",
    ],
    wrong={
        "tangent": (
            100.0,
            "That is the answer of the tangent, the image of the mean. Two points lie lower on the arc and pull the mean down.",
        ),
        "one sigma": (
            lambda: 2 / 3 * 100 + 1 / 3 * image(120),
            "That is what the right weights make of outer points at ±1σ. They sit at ±√scale σ, with scale = 3.",
        ),
        "scale without its root": (
            lambda: 2 / 3 * 100 + 1 / 3 * image(180),
            "66.7 m is the share of the centre alone. Either the outer points are left out, or they sit at ±3σ, where their image is 0: σ is stretched by the root of the scale, √3.",
        ),
        "kappa forgotten": (
            lambda: image(120),
            "That is 100 sin 60°, as with κ = 0: no weight at the centre, two points at ±1σ. Here the scale is α²(n + κ) = 3.",
        ),
        "kappa as the scale": (
            lambda: 0.5 * 100 + 0.5 * image(90 + np.sqrt(2) * 30),
            "That is right for a scale of 2, which is κ. The scale is α²(n + κ) = 3.",
        ),
        "equal weights": (
            lambda: (100 + 2 * image(90 + np.sqrt(3) * 30)) / 3,
            "That is the plain mean of the three images. The weights are not equal: the centre has 1 − n/scale = 2/3, the others 1/6 each.",
        ),
        "one outer point": (
            lambda: 2 / 3 * 100 + 1 / 6 * image(90 + np.sqrt(3) * 30),
            "That is the centre and one outer point with their weights, which sum to 5/6. There are two outer points.",
        ),
        "degrees for radians": (
            lambda: 2 / 3 * 100 * np.sin(90) + 100 / 6 * (np.sin(90 + np.sqrt(3) * 30) + np.sin(90 - np.sqrt(3) * 30)),
            "That is what comes out if `np.sin` is given degrees. It takes radians: `np.sin(np.radians(…))`.",
        ),
        "the true mean": (
            lambda: 100 * np.exp(-(np.radians(30) ** 2) / 2),
            "That is the true mean, and very near. The three points give a little more: take their weighted sum.",
        ),
        "weights not divided": (
            lambda: 100 + 2 * image(90 + np.sqrt(3) * 30),
            "That is the sum of the three images. Weigh them: 2/3 for the centre, 1/6 for each of the others.",
        ),
    }
    | MORE["three_points"]
    | NEW["three_points"]
    | FOURTH["three_points"]
    | FIFTH["three_points"]
    | SEVENTH["three_points"]
    | TENTH["three_points"],
    otherwise=facts.weight_of_centre,
    unit="m",
    rtol=1e-4,
    then="The true mean is 87.19 m: three points miss it by 2 cm, the tangent by almost 13 m. What would an angle of 90° ± 60° do to both?",
)
def three_points():
    """The mean of 100 sin θ for θ of 90° ± 30°, by the unscented rule with n = 1, α = 1, κ = 2."""
    angle = np.radians(90 + np.sqrt(3) * 30 * np.array([0, 1, -1]))
    return np.array([2 / 3, 1 / 6, 1 / 6]) @ (100 * np.sin(angle))


@exercise(
    hints=[
        "With λ = 3 − n, n + λ is 3, for any n. The declaration says α²(n + κ).",
        "Solve α²(4 + κ) = 3 for κ, once for each α.",
        "α = 1: κ = 3 − 4. α = ½: 4 + κ = 3/0.25 = 12.",
    ],
    wrong={
        "alpha forgotten": (
            (-1, -1),
            "Right for α = 1. But α² multiplies n + κ: with α = ½ a larger κ must make up for it.",
        ),
        "alpha not squared": (
            (-1, 2),
            "Right for α = 1. For α = ½ your number is 3/α − 4; the scale holds α², a quarter.",
        ),
        "n forgotten": ((3, 12), "Those are the values of n + κ. Take off n = 4."),
        "sign": ((1, -8), "Both signs are turned round: κ = 3/α² − n."),
        "lambda": (
            (-1, -3.25),
            "Right for α = 1. For α = ½ your number is 3α² − 4; the declaration must be larger, 3/α² − n.",
        ),
        "as declared": (
            (0, 0),
            "κ = 0 is what the program declares. Then n + λ would be 4, or 1, and it works with 3.",
        ),
        "swapped": ((8, -1), "The two values have changed places: first for α = 1, then for α = ½."),
        "lambda for alpha one half": (
            (-1, -2.5),
            "Right for α = 1. For α = ½ your number is 3α − 4; 3 must be divided by α², because α²(n + κ) has to be 3.",
        ),
        "alpha twice": (
            (-1, 12),
            "Right for α = 1. For α = ½ 12 is n + κ; take off n = 4.",
        ),
        "alpha squared once more": (
            (-1, 44),
            "Right for α = 1. For α = ½ your number is 3/α⁴ − 4; the declaration holds α².",
        ),
    }
    | MORE["declared_kappa"]
    | THIRD["declared_kappa"],
    otherwise=facts.declared,
    then="With n + λ = 3 and n = 4 the centre's weight is 1 − 4/3 = −1/3: a weight of this rule may be negative.",
)
def declared_kappa():
    """The κ that makes α²(n + κ) equal n + λ with λ = 3 − n, for n = 4: first with α = 1, then with α = ½."""
    return 3 / 1**2 - 4, 3 / 0.5**2 - 4


def covariance(rng, n):
    """A covariance with correlations."""
    root = np.tril(rng.integers(-2, 3, (n, n)) / 2, -1) + np.diag(rng.integers(2, 7, n) / 2)
    return root @ root.T


def moved_belief(rng):
    """Mean and covariance of moved points, a Q, and a scale."""
    n = int(rng.choice([3, 4, 2]))
    return rng.integers(-20, 20, n) / 2, covariance(rng, n), covariance(rng, n), rng.integers(5, 40) / 10


def around(mean, rows):
    """The points mean, mean + rows, mean − rows."""
    return np.vstack([mean, mean + rows, mean - rows])


def columns(P):
    """The columns of the Cholesky root, as rows."""
    return np.linalg.cholesky(P).T


@exercise(
    hints=[
        "The points must represent the whole predicted belief. What is its covariance, after Q has been added?",
        "`sigma_points` does it all, if it gets the right covariance.",
        "`return sigma_points(mean, P + Q, scale)`.",
    ],
    inputs=moved_belief,
    wrong={
        "as published": (
            lambda mean, P, Q, scale: around(mean, columns(scale * P)),
            "Those are points for P alone, as published. Q has made the belief wider, and the points must have the covariance P + Q.",
        ),
        "Q alone": (
            lambda mean, P, Q, scale: around(mean, columns(scale * Q)),
            "Those points carry only Q; the belief before it, P, is lost.",
        ),
        "roots added": (
            lambda mean, P, Q, scale: around(mean, np.sqrt(scale) * (columns(P) + columns(Q))),
            "You added the roots. Variances add, their roots do not: take the root of P + Q.",
        ),
        "Q not scaled": (
            lambda mean, P, Q, scale: around(mean, columns(scale * P + Q)),
            "The scale must stretch Q as well: the root of scale · (P + Q).",
        ),
        "no scale": (
            lambda mean, P, Q, scale: around(mean, columns(P + Q)),
            "The covariance is right, but the points sit at ±1σ: the scale is missing.",
        ),
        "scale without its root": (
            lambda mean, P, Q, scale: around(mean, scale * columns(P + Q)),
            "The covariance is right, but the root is stretched by the scale; stretch it by √scale, or the covariance by the scale.",
        ),
        "rows for columns": (
            lambda mean, P, Q, scale: around(mean, columns(scale * (P + Q)).T),
            "Your points go along the rows of the (lower) Cholesky root; they go along its columns, the rows of `np.linalg.cholesky(…).T`.",
        ),
        "covariance for its root": (
            lambda mean, P, Q, scale: around(mean, scale * (P + Q)),
            "You went along the columns of the covariance itself; take its Cholesky root first.",
        ),
        "minus first": (
            lambda mean, P, Q, scale: around(mean, -columns(scale * (P + Q))),
            "The right points in another order: first the centre, then all with plus, then all with minus.",
        ),
        "plus and minus by turns": (
            lambda mean, P, Q, scale: np.vstack(
                [mean, *(mean + side * row for row in columns(scale * (P + Q)) for side in (1, -1))]
            ),
            "The right points in another order: first the centre, then all with plus, then all with minus.",
        ),
        "around zero": (
            lambda mean, P, Q, scale: around(0 * mean, columns(scale * (P + Q))),
            "The spread is right, but the points lie around zero: add the mean.",
        ),
        "turned": (
            lambda mean, P, Q, scale: around(mean, columns(scale * (P + Q))).T,
            "The right points, turned on their side: one row for each point was asked for, (2n + 1, n).",
        ),
        "centre missing": (
            lambda mean, P, Q, scale: around(mean, columns(scale * (P + Q)))[1:],
            "The outer points are right. The centre, the mean itself, is a point too: put it first.",
        ),
        "minus missing": (
            lambda mean, P, Q, scale: around(mean, columns(scale * (P + Q)))[: len(mean) + 1],
            "Half of the points: each column goes both ways, mean + column and mean − column.",
        ),
        "scale divides": (
            lambda mean, P, Q, scale: around(mean, columns((P + Q) / scale)),
            "Those are the points of (P + Q)/scale. The scale multiplies the covariance: the points lie √scale standard deviations away.",
        ),
    }
    | MORE["redrawn"]
    | FIFTH["redrawn"],
    then=(
        "With Q = 0 the moved points and the new ones have the same mean and covariance. Only where something "
        "is added must the points be drawn again."
    ),
)
def redrawn(mean, P, Q, scale):
    """The points to be measured, (2n+1, n): those of a belief that moved to N(mean, P) and was then widened by Q."""
    reach = np.linalg.cholesky(scale * (P + Q)).T
    return np.vstack([mean, mean + reach, mean - reach])


@exercise(
    hints=[
        "P₀ is diagonal: eᵀP₀⁻¹e is a sum of six terms, each component's e² divided by its claimed variance.",
        "On average e² is the variance it is really drawn with. So add up six ratios, real to claimed.",
        "1/100 + 1/100 + 0.01/1 + 0.01/1 + 0.0001/0.1 + 0.0001/0.1.",
    ],
    wrong={
        "honest": (
            6.0,
            "That would be an honest start, each component contributing 1. Here each contributes far less.",
        ),
        "the wrong way": (2400.0, "2400 is the sum of the ratios of claim to real variance. Divide Q by P₀."),
        "per state": (
            0.042 / 6,
            "That is the mean of the six ratios, to be compared with 1; their sum was asked for, to be compared with 6.",
        ),
        "with standard deviations": (
            lambda: 2 * (0.1 + 0.1 + np.sqrt(0.001)),
            "That is the sum of the ratios of standard deviations; eᵀP₀⁻¹e is made of squares, so take ratios of variances.",
        ),
        "squared twice": (
            2 * (1e-4 + 1e-4 + 1e-6),
            "That is the sum of the squared ratios, but Q and P₀ hold variances already.",
        ),
        "position only": (0.02, "0.02 is twice 1/100, as of the positions alone. All six ratios belong to it."),
        "one axis": (0.021, "That is one axis, x or y; each entry stands twice on the diagonal."),
        "acceleration forgotten": (0.04, "The accelerations are missing: they bring 0.0001/0.1 twice."),
        "quotient of the sums": (
            2.0202 / 202.2,
            "That is the quotient of the sums. Each component has its own unit and its own claim: divide each, then add all six.",
        ),
        "real variances": (
            2.0202,
            "That is the sum of the real variances. Each of them is to be divided by the variance that P₀ claims "
            "for it.",
        ),
        "claimed variances": (
            202.2,
            "That is the sum of the claimed variances. Divide the real one of each component by its claimed one, "
            "then add.",
        ),
        "upside down, as a factor": (
            6 / 0.042,
            "That is how many times too small it is. The question asks for the average of eᵀP₀⁻¹e itself.",
        ),
    }
    | MORE["start_nees"]
    | THIRD["start_nees"]
    | FIFTH["start_nees"],
    otherwise=facts.six_ratios,
    rtol=4e-4,  # 0.06 and 0.05994 are two mistakes
    then=(
        "The claimed variance is too large, by a factor of 100 or 1000; in the NEES together by 6/0.042, about 143. A NEES far below its band shows that,"
        " while the error alone looks excellent."
    ),
)
def start_nees():
    """The average of eᵀP₀⁻¹e for P₀ = diag(100, 100, 1, 1, 0.1, 0.1), when e is drawn from Q = diag(1, 1, 0.01, 0.01, 0.0001, 0.0001)."""
    claimed = np.array([100, 100, 1, 1, 0.1, 0.1])
    real = np.array([1, 1, 0.01, 0.01, 1e-4, 1e-4])
    return np.sum(real / claimed)
