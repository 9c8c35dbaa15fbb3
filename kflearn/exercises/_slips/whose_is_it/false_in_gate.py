"""Lesson 26, `false_in_gate`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._shown import show

AREA = np.pi * 9.21 * 30


def area_of(number):
    """What a number would mean that is in no row."""
    if number <= 0:
        return "In a gate of any size there are some on average: its area, in m², times 0.0005."
    if abs(number - 868) < 3:
        return "That is the area of the gate, in m². How many false readings are in it, at 0.0005 for each m²?"
    if abs(number - 868 / 0.0005) < 5e3:
        return "That is the area divided by λ. So many false readings in each m², times so many m²: multiply."
    return (
        f"At 0.0005 for each m² that is a gate of {show(number / 0.0005, 3)} m². The gate is an ellipse with the half axes √9.21 · 6 m "
        "and √9.21 · 5 m."
    )


WRONG = {
    "the sum of the variances": (
        np.pi * 9.21 * 61 * 5e-4,
        "That is π · 9.21 · 61 · 0.0005, with the trace of S. The area goes with the root of the determinant, √(36 · 25) = 30.",
    ),
    "the determinant": (
        np.pi * 9.21 * 900 * 5e-4,
        "That is π · 9.21 · 900 · 0.0005, with the determinant itself, 900 m⁴. An area in m² needs its square root, 30.",
    ),
    "the limit squared": (
        np.pi * 9.21**2 * 30 * 5e-4,
        "The limit is that of a square, the NIS, so the half axes are √9.21 σ long. In the area the limit stands once, not squared.",
    ),
    "the root of the limit": (
        np.pi * np.sqrt(9.21) * 30 * 5e-4,
        "An area has two half axes, each √9.21 σ long: their product has 9.21 in it, not its root.",
    ),
    "no π": (9.21 * 30 * 5e-4, "The π of the ellipse is missing: its area is π times the product of the half axes."),
    "a box": (
        4 * 9.21 * 30 * 5e-4,
        "That is the box around the ellipse, with sides 2√9.21 σ. The gate is the ellipse: π in place of 4.",
    ),
    "one standard deviation": (
        np.pi * 30 * 5e-4,
        "That is the ellipse of one standard deviation. The gate is larger: its limit is a NIS of 9.21.",
    ),
    "3 sigma": (np.pi * 9 * 30 * 5e-4, "That is right for a limit of 9 = 3²; the limit is said to be 9.21."),
    "2π": (2 * np.pi * 9.21 * 30 * 5e-4, "The area of an ellipse is π times its half axes, not 2π."),
    "not times λ": (
        AREA,
        "That is the area of the gate, in m². How many false readings are in it, at 0.0005 for each m²?",
    ),
    "P_G": (
        0.99 * AREA * 5e-4,
        "0.43 is 0.99 times the right number. P_G is about the boat's own reading; false ones are anywhere, and the area alone counts.",
    ),
    "the chance of none": (
        float(np.exp(-AREA * 5e-4)),
        "That is the probability that no false reading is in the gate. Their mean number was asked for.",
    ),
    "the chance of one at least": (
        1 - float(np.exp(-AREA * 5e-4)),
        "That is the probability of one false reading at least. Their mean number was asked for; it is larger, as two and three count more.",
    ),
    "with the boat": (
        AREA * 5e-4 + 0.9,
        "That is larger by 0.9 than it should be: the boat's own reading. Only the false ones were asked for.",
    ),
    "one axis": (
        np.pi * 9.21 * 36 * 5e-4,
        "That is right for 36 m² on both axes. The half axes go with 6 and 5 m: √(36 · 25) = 30.",
    ),
    "the other axis": (
        np.pi * 9.21 * 25 * 5e-4,
        "That is right for 25 m² on both axes. The half axes go with 6 and 5 m: √(36 · 25) = 30.",
    ),
    "quartered": (
        AREA * 5e-4 / 4,
        "That is a quarter of the right number, as if the axes were diameters. √9.21 σ is half an axis already.",
    ),
    "one component": (
        np.pi * 6.635 * 30 * 5e-4,
        "6.635 is the limit for one component. Here are two, and the text gives 9.21.",
    ),
    "as in the lesson": (0.591, "That is the lesson's gate. Here the determinant of S is 36 · 25, and λ is 0.0005."),
    "root of the trace": (
        np.pi * 9.21 * 61**0.5 * 5e-4,
        "That is what √(36 + 25) makes, the root of the trace. The area goes with the root of the determinant, √(36 · 25) = 30.",
    ),
    "the lesson's λ": (AREA * 4e-4, "That is right for the lesson's 4 · 10⁻⁴ per m². Here λ is 5 · 10⁻⁴ per m²."),
    "rounded to none": (
        0,
        "A mean number need not be a whole one: 0 would say that there is never one. Give three digits.",
    ),
    "rounded to one": (1, "A mean number need not be a whole one. Give three digits."),
    "half": (0.5, "That is too coarse: give three digits."),
    "P_D": (
        AREA * 5e-4 * 0.9,
        "That is 0.9 times the right number. P_D is about the boat's own reading; false ones are anywhere.",
    ),
    "λ = 0.005": (AREA * 5e-3, "That is right for 0.005 per m². Here λ is 0.0005 per m²."),
    "λ = 0.00005": (AREA * 5e-5, "That is right for 0.00005 per m². Here λ is 0.0005 per m²."),
    "mean radius": (
        np.pi * 9.21 * 5.5**2 * 5e-4,
        "That is a circle with the mean of 6 m and 5 m for both axes. The product of the half axes counts: 6 · 5 = 30.",
    ),
    "mean variance": (
        np.pi * 9.21 * 30.5 * 5e-4,
        "That is a circle with the mean of the two variances. The product of the half axes counts: √(36 · 25) = 30.",
    ),
    "a circle of 9.21 m": (
        np.pi * 9.21**2 * 5e-4,
        "That is a circle with the radius 9.21 m. 9.21 is the limit of the NIS, which has no unit: the half axes are √9.21 · 6 m and √9.21 · 5 m.",
    ),
    "900 alone": (0.45, "0.45 is 900 · 0.0005. The area of the gate is π · 9.21 · √900."),
    "30 alone": (0.015, "0.015 is 30 · 0.0005. The area of the gate is π · 9.21 · 30."),
    "900 and the limit": (9.21 * 900 * 5e-4, "That is 9.21 · 900 · 0.0005. The area of the gate is π · 9.21 · √900."),
    "diameters": (
        AREA * 4 * 5e-4,
        "That is four times the right number, as from whole axes. In the area stand the half axes, √9.21 · 6 m and √9.21 · 5 m.",
    ),
    "b without the detection": (
        lambda: 0.0005 * 2 * np.pi * 30,
        "0.0942 is λ 2π √det S, the b of the weights without its last factor. Asked is λ times the area of the gate, π · 9.21 · √det S.",
    ),
}
