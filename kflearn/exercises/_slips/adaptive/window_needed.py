"""Lesson 22, `window_needed`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._shown import show


def scatter_of(count):
    """What a number would mean that is in no row."""
    if count <= 0:
        return None
    return f"With {show(count)} innovations R̂ scatters by S √(2/N) = {show(1.3 * (2 / count) ** 0.5, 3)} m², with S = 1.3 m². Wanted is 0.1 m²."


WRONG = {
    "R for S": (
        200,
        "200 is 2 (1/0.1)², which holds for S = 1 m². An innovation has S = 1 + 0.3: the prediction is uncertain too.",
    ),
    "2 forgotten": (
        169,
        "169 is (1.3/0.1)². The square of a bell has the variance 2S², so C scatters by S √(2/N): a 2 is missing.",
    ),
    "not squared": (26, "26 is 2 · 13. From 1.3 √(2/N) = 0.1 follows N = 2 · 13²."),
    "R alone, 2 forgotten": (
        100,
        "σ/√N is the error of a mean of plain numbers. Here it is a mean of squares: S √(2/N), with S = 1.3.",
    ),
    "0.1 as a variance": (
        34,
        "With 34 the *variance* of R̂ is about 0.1. The question names its standard deviation.",
    ),
    "one too few": (
        337,
        "With 337 it is still a little above 0.1 m². Take the next whole number.",
    ),
    "only the prediction": (
        18,
        "18 is right for S = 0.3 m², the prediction's share. The variance of an innovation is S = 1 + 0.3.",
    ),
    "not divided": (
        2 * 1.3**2,
        "That is 2 S², the variance of one squared innovation. How many must be averaged until the root of 2 "
        "S²/N is 0.1?",
    ),
    "root on both": (
        (2 * 1.3 / 0.1) ** 2,
        "The 2 stands under the root: S √(2/N), so N = 2 (S/0.1)², not (2 S/0.1)².",
    ),
    "S over the wanted, ten times": (
        130,
        "130 is 1.3/0.1². From 1.3 √(2/N) = 0.1 follows N = 2 (1.3/0.1)².",
    ),
    "difference": (
        98,
        "98 is right for S = 1 − 0.3. Sensor and prediction both scatter: S = 1 + 0.3.",
    ),
    "S not squared": (
        260,
        "The 2 and 0.1² are right, but S stands squared as well: N = 2 · 1.3²/0.1².",
    ),
    "root of S": (
        lambda: 2 * 1.3**0.5 / 0.01,
        "That is 2 √1.3/0.1². The mean of squares scatters by S √(2/N), so S stands squared: 2 · 1.3²/0.1².",
    ),
    "0.01 once more": (
        33800,
        "33800 is a hundred times too large, by another 1/0.1²: N = 2 (1.3/0.1)², and (1/0.1)² is 100.",
    ),
    "plain ratio": (
        13,
        "That is S divided by 0.1. From 1.3 √(2/N) = 0.1 follows N = 2 (1.3/0.1)².",
    ),
    "variances of R and prediction": (
        lambda: 2 * (1 + 0.3**2) / 0.01,
        "218 is 2 (1² + 0.3²)/0.1². 1 and 0.3 are variances that add to S = 1.3; then S is squared.",
    ),
    "0.1 not squared": (
        2 * 1.3**2 / 0.1,
        "S is squared, 0.1 is not. From 1.3 √(2/N) = 0.1 follows N = 2 · 1.3²/0.1².",
    ),
    "relative": (
        2 / 0.1**2 / 1.3**2,
        "S stands in the wrong place. A larger S scatters more and needs more innovations: N = 2 S²/0.1².",
    ),
    "the lesson's": (30, "30 is the lesson's window. How much does R̂ scatter with it? Solve S √(2/N) = 0.1 for N."),
    "half": (
        84.5,
        "The 2 stands on the wrong side: the mean of squares scatters by S √(2/N), not by S/√(2N).",
    ),
    "R alone, not squared": (20, "20 is 2 · 1/0.1. S = 1 + 0.3, and N = 2 S²/0.1²."),
    "S² alone": (1.69, "That is S². From S √(2/N) = 0.1 follows N = 2 S²/0.1²."),
    "added as deviations": (
        lambda: 2 * (1 + 0.3**0.5) ** 4 / 0.01,
        "That is right for S = (1 + √0.3)². 1 and 0.3 are variances: S = 1 + 0.3.",
    ),
    "not squared, rounded up": (19, "19 is √N. In S √(2/N) the N stands under the root: square 13·√2."),
    "root of N": (13 * 2**0.5, "That is √N. In S √(2/N) the N stands under the root: square it."),
    "0.3 squared": (238, "238 is right for S = 1 + 0.3². HP⁻Hᵀ is a variance already: S = 1 + 0.3."),
    "of a σ": (85, "S/√(2N) is the scatter of a standard deviation. R̂ is a variance: S √(2/N)."),
    "±2σ": (
        1352,
        "1352 innovations bring *twice* the standard deviation to 0.1 m². The question asks for the standard deviation itself.",
    ),
    "HP⁻Hᵀ taken off": (
        22,
        "22 is right for 0.1 + 0.3 = 0.4 m². What is taken off C is known, and takes nothing off its scatter: S √(2/N) = 0.1 m².",
    ),
    "the lesson's S": (242, "242 is 2 (1.1/0.1)². Here S is 1.3 m²."),
}
