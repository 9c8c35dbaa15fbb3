"""Lesson 17, `three_points`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._shown import show


def image(degrees):
    """The y-coordinate at a distance of 100 m."""
    return 100 * np.sin(np.radians(degrees))


def three(reach, centre=2 / 3, outer=1 / 6, middle=90):
    """The weighted sum of three images, with points so many degrees away."""
    return centre * image(middle) + outer * (image(middle + reach) + image(middle - reach))


def weight_of_centre(mean):
    """What a number would mean that is in no row."""
    low = 100 * np.cos(np.radians(30) * 3**0.5)
    if 12.5 < mean < 13.2:
        return "That is about how far the mean sinks below 100 m. The question asks for the mean itself."
    if not low <= mean <= 100:
        return "A weighted mean lies between the smallest and the largest image, here between 61 m and 100 m."
    return (
        f"With the points at 90° and 90° ± √3 · 30° that number gives the centre the weight {show((mean - low) / (100 - low), 3)}. "
        "By the rule it is 1 − n/scale = 2/3."
    )


WRONG = {
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
    "centre in degrees": (
        lambda: 100 * (2 / 3 * np.sin(90) + np.cos(np.radians(30) * 3**0.5) / 3),
        "That is right but for the centre: `np.sin(90)` takes 90 for radians. The centre lies at 90°, where the sine is 1.",
    ),
    "cosine of degrees": (
        lambda: 100 * (2 / 3 + np.cos(30 * 3**0.5) / 3),
        "That is what comes out if `np.cos` is given degrees. It takes radians: `np.cos(np.radians(…))`.",
    ),
    "degrees": (
        lambda: 2 / 3 * 100 * np.sin(90) + 1 / 6 * 100 * (np.sin(90 + 52) + np.sin(90 - 52)),
        "That is what comes out if NumPy's sine is given degrees. It wants radians: `np.sin(np.radians(90))`.",
    ),
    "the lesson's radar": (94.09, "That is the lesson's radar. Here the distance is exactly 100 m, and σ = 30°."),
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
    "degrees, rounded": (
        lambda: 100 * (2 / 3 * np.sin(90) + (np.sin(90 + 51.96) + np.sin(90 - 51.96)) / 6),
        "That is what comes out if `np.sin` is given 90 and 51.96 as they are. It takes radians: `np.sin(np.radians(…))`.",
    ),
    "one sixth for all": (
        lambda: 100 * (1 + 2 * np.cos(np.radians(30) * 3**0.5)) / 6,
        "That is what three weights of 1/6 make, which add up to 1/2. The centre weighs 1 − n/scale = 2/3: all weights add up to 1.",
    ),
    "weights of the covariance": (
        lambda: 200 + 200 / 3 + 100 / 3 * np.cos(np.radians(30) * 3**0.5),
        "287.2 is what the weights of the covariance, Wc, make of the images: with β = 2 their sum is 3. A mean "
        "takes the weights Wm, whose sum is 1.",
    ),
    "the rule for n = 2": (
        lambda: 100 * (3 / 4 + np.cos(np.radians(60)) / 4),
        "87.5 m is what the rule gives for n = 2, with a scale of 4. One number is uncertain, the angle: n = 1, and the scale is 3.",
    ),
}
