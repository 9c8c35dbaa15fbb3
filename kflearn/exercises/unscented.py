"""Lesson 17: five points through a bend."""

import numpy as np

from kflearn.exercises._slips import unscented as slips
from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "First the rule for n = 1: the scale is α²(n + κ), the centre weighs 1 − n/scale, each of the others 1/(2 scale).",
        "The scale is 3: weights 2/3, 1/6, 1/6, and the outer points √3 standard deviations from 90°.",
        "2/3 · 100 + 1/6 · 100 sin(90° + √3 · 30°) + 1/6 · 100 sin(90° − √3 · 30°); √3 · 30° is 51.96°.",
    ],
    wrong=slips.three_points.WRONG,
    otherwise=slips.three_points.weight_of_centre,
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
    wrong=slips.declared_kappa.WRONG,
    otherwise=slips.declared_kappa.declared,
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


@exercise(
    hints=[
        "The points must represent the whole predicted belief. What is its covariance, after Q has been added?",
        "`sigma_points` does it all, if it gets the right covariance.",
        "`return sigma_points(mean, P + Q, scale)`.",
    ],
    inputs=moved_belief,
    wrong=slips.redrawn.WRONG,
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
    wrong=slips.start_nees.WRONG,
    otherwise=slips.start_nees.six_ratios,
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
