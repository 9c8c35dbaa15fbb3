"""Wrong answers to exercises of lesson 17 that a fifth group of strangers gave, and more of their kind."""

import numpy as np


def image(degrees):
    """The y-coordinate at a distance of 100 m."""
    return 100 * np.sin(np.radians(degrees))


def around(mean, covariance):
    """The points of a covariance that is scaled already."""
    rows = np.linalg.cholesky(covariance).T
    return np.vstack([mean, mean + rows, mean - rows])


def three(reach, centre=2 / 3, outer=1 / 6, middle=90):
    """The weighted sum of three images, with points so many degrees away."""
    return centre * image(middle) + outer * (image(middle + reach) + image(middle - reach))


WRONG = {
    "three_points": {
        "along x": (
            0.0,
            "That is the mean along the x-axis, or a mean of differences. The y-axis was asked for: 100 sin θ.",
        ),
        "κ for the scale, in σ": (
            three(60),
            "That is what the right weights make of outer points at ±60°, that is at ±2σ. They sit at ±√3 σ, since the scale α²(n + κ) is 3.",
        ),
        "half of the spread": (
            three(15 * 3**0.5),
            "The weights are right, with outer points at ±√3 · 15°. σ is 30°, so they sit at ±√3 · 30°.",
        ),
        "60° for σ": (
            three(60 * 3**0.5),
            "The weights are right, with outer points at ±√3 · 60°. 30° is σ itself, so they sit at ±√3 · 30°.",
        ),
        "σ squared": (
            three(np.degrees(3**0.5 * np.radians(30) ** 2)),
            "The weights are right, with outer points at ±√3 σ², σ in radians. They sit at ±√3 σ.",
        ),
        "outer weights ½": (
            three(30 * 3**0.5, outer=1 / 2),
            "The points are right. With ½ for each outer point the weights sum to 5/3: they weigh 1/(2 · 3) = 1/6 each.",
        ),
        "against the true mean": (
            0.016,
            "That is by how much the three points miss the true mean, in m. The question asks for their mean itself.",
        ),
    },
    "redrawn": {
        "n + scale": (
            lambda mean, P, Q, scale: around(mean, (len(mean) + scale) * (P + Q)),
            "The covariance is right. It is multiplied by n + scale; `scale` is α²(n + κ), with the n in it already.",
        ),
        "n times scale": (
            lambda mean, P, Q, scale: around(mean, len(mean) * scale * (P + Q)),
            "The covariance is right. It is multiplied by n · scale; `scale` is α²(n + κ), with the n in it already.",
        ),
        "both squared": (
            lambda mean, P, Q, scale: around(mean, scale * (P + Q) @ (P + Q)),
            "Those points belong to the square of P + Q. P and Q are covariances already: add them, and take the root.",
        ),
        "Q scaled twice": (
            lambda mean, P, Q, scale: around(mean, scale * (P + scale * Q)),
            "Q has the scale twice in these points, P once: both need it once, scale · (P + Q).",
        ),
        "half as far": (
            lambda mean, P, Q, scale: around(mean, scale * (P + Q) / 4),
            "The directions are right, but your points are half as far from the mean as they should be.",
        ),
        "twice as far": (
            lambda mean, P, Q, scale: around(mean, scale * (P + Q) * 4),
            "The directions are right, but your points are twice as far from the mean as they should be.",
        ),
        **{
            f"scale {fixed}": (
                lambda mean, P, Q, scale, fixed=fixed: around(mean, fixed * (P + Q)),
                f"The covariance is right, and your points sit at ±√{fixed} σ in every trial: use the `scale` that is handed in.",
            )
            for fixed in (2, 3, 4, 5, 6, 9)
        },
        "the belief": (
            lambda mean, P, Q, scale: (mean, P + Q),
            "That is the widened belief, and it is right. What is wanted are its 2n + 1 points: `sigma_points` draws them, with `scale`.",
        ),
        "the covariance": (
            lambda mean, P, Q, scale: P + Q,
            "That is the covariance of the widened belief, and it is right. Wanted are its 2n + 1 points: `sigma_points` draws them.",
        ),
        "centre twice": (
            lambda mean, P, Q, scale: np.vstack([mean, around(mean, scale * (P + Q))]),
            "The centre stands there twice. There are 2n + 1 points: the centre, n with plus, n with minus.",
        ),
        "centre in the middle": (
            lambda mean, P, Q, scale: np.roll(around(mean, scale * (P + Q)), len(mean), axis=0),
            "The right points in another order: first the centre, then all with plus, then all with minus.",
        ),
        "in one row": (
            lambda mean, P, Q, scale: around(mean, scale * (P + Q)).ravel(),
            "The right numbers in one long row. One row for each point is wanted, (2n + 1, n): `np.vstack`.",
        ),
        "covariance of the points, unweighted": (
            lambda mean, P, Q, scale: around(mean, scale * (np.cov(around(mean, scale * P).T) + Q)),
            "P has been worked out anew from points, as a plain sample's covariance, and that is not P: the points have weights. P is handed in.",
        ),
        "covariance of the points, over all": (
            lambda mean, P, Q, scale: around(mean, scale * (np.cov(around(mean, scale * P).T, ddof=0) + Q)),
            "P has been worked out anew from points, as a plain sample's covariance, and that is not P: the points have weights. P is handed in.",
        ),
        "root of Q": (
            lambda mean, P, Q, scale: around(mean, scale * (P + np.sqrt(abs(Q)))),
            "Q stands there with roots of its entries. Q is a covariance already: add it as it is.",
        ),
        "first of Q": (
            lambda mean, P, Q, scale: around(mean, scale * (P + Q[0, 0] * np.eye(len(mean)))),
            "Of Q the first entry stands there alone, for all states. Q is a matrix: add all of it.",
        ),
    },
    "start_nees": {
        "not inverted": (
            200.02,
            "200.02 is the trace of P₀ Q. In eᵀP₀⁻¹e P₀ divides: add up the ratios of Q to P₀.",
        ),
        "factors in the mean": (
            400,
            "400 is the mean of the six ratios of claim to real variance. Turn each of them over, and add all six.",
        ),
        "what is missing to 6": (5.958, "That is 6 minus the sum. The sum of the six ratios itself is the answer."),
        "P₀ as σ": (
            0.0402,
            "That is what comes of P₀ squared. P₀ holds variances already: each ratio is Q to P₀, as they are.",
        ),
        "Q as σ": (
            0.0202,
            "That is what comes of Q squared. Q holds variances already: each ratio is Q to P₀, as they are.",
        ),
        "one of each, all a hundredth": (
            0.03,
            "That is three times 1/100. There are six ratios, and those of the accelerations are 0.0001/0.1 = 1/1000.",
        ),
        "traces upside down": (
            202.2 / 2.0202,
            "That is the sum of all claims by the sum of all real variances. Divide each real variance by its own claim, then add all six.",
        ),
        "six ratios": (
            [0.01, 0.01, 0.01, 0.01, 0.001, 0.001],
            "These are the six ratios, and they are right. eᵀP₀⁻¹e is their sum.",
        ),
        "three ratios": ([0.01, 0.01, 0.001], "These are the ratios of one axis. eᵀP₀⁻¹e is the sum of all six."),
    },
}  # fmt: skip
