"""Lesson 16, `false_range`: wrong answers, each with the sentence that it gets."""

import numpy as np


def fused(sigma, H, across):
    return sigma * across / np.sqrt(sigma**2 * H**2 + across**2)


def one_minus_K(sigma, turn, across):
    """P after the reading with the factor 1 − K."""
    P, H = sigma**2, np.sin(np.radians(turn))
    return (1 - P * H / (H * P * H + across**2)) * P


def one_H(sigma, turn, across):
    H, P = np.sin(np.radians(turn)), sigma**2
    return np.sqrt((1 - P * H / (H * P + across**2) * H) * P)


WRONG = {
    "degrees as radians": (
        lambda s, turn, r: fused(s, np.sin(turn), r),
        "NumPy's sine wants radians: `np.sin(np.radians(turn))`.",
    ),
    "cosine": (
        lambda s, turn, r: fused(s, np.cos(np.radians(turn)), r),
        "That is right for H = cos(turn). A needle that is not turned at all shows nothing of its length across the line: H is the sine.",
    ),
    "tangent": (
        lambda s, turn, r: fused(s, np.tan(np.radians(turn)), r),
        "That is right for H = tan(turn); the length σ along the needle shows σ·sin(turn) across the new line.",
    ),
    "no turn": (
        lambda s, turn, r: fused(s, 1, r),
        "That is right for H = 1, a reading along the needle at its full length: H is the sine of the turn.",
    ),
    "variance": (
        lambda s, turn, r: fused(s, np.sin(np.radians(turn)), r) ** 2,
        "That is the variance; asked is the standard deviation.",
    ),
    "the reading alone": (
        lambda s, turn, r: r / np.sin(np.radians(turn)),
        "Nearly: that is what the reading alone says, across/sin(turn). The needle's own σ knows something too; fuse them.",
    ),
    "as seen across": (
        lambda s, turn, r: s * np.sin(np.radians(turn)),
        "σ·sin(turn) is how broad the needle seems before the reading. What is left of σ after it?",
    ),
    "what is left across": (
        lambda s, turn, r: np.sin(np.radians(turn)) * fused(s, np.sin(np.radians(turn)), r),
        "That is the doubt left *across the new line*; asked is the one along the needle, 1/sin(turn) times as long.",
    ),
    "standard deviations for variances": (
        lambda s, turn, r: s * r / (s * np.sin(np.radians(turn)) + r),
        "That is σ·across/(σ·sin + across), in which standard deviations add. Variances add: σ² sin² + across², and "
        "then the root.",
    ),
    "H not squared": (
        lambda s, turn, r: fused(s, np.sqrt(np.sin(np.radians(turn))), r),
        "H P Hᵀ has the sine twice: sin² times σ².",
    ),
    "across taken for a variance": (
        lambda s, turn, r: fused(s, np.sin(np.radians(turn)), np.sqrt(r)),
        "`across` is a standard deviation; R is its square.",
    ),
    "unchanged": (
        lambda s, turn, r: s,
        "That would be right for a turn of 0. Here the filter believes that it sees the needle from the side.",
    ),
    "never squared": (
        lambda s, turn, r: s * r / (s * np.sin(np.radians(turn)) ** 2 + r),
        "That is P after the reading with `sigma` for P and `across` for R. P and R are variances: square both, and take the root last.",
    ),
    "1 − K, rooted": (
        lambda s, turn, r: np.sqrt(abs(one_minus_K(s, turn, r))),
        "That is √((1 − K)·P). P shrinks by 1 − K·H: the reading does not measure the place along the needle one to one.",
    ),
    "1 − K, not a number": (
        lambda s, turn, r: np.sqrt(max(one_minus_K(s, turn, r), 0) or np.nan),
        "That is √((1 − K)·P), and where K is above 1 not a number. P shrinks by 1 − K·H.",
        r"sqrt|\*\* *\(?(0?\.5|1 */ *2)",
    ),
    "1 − K, as a variance": (
        lambda s, turn, r: one_minus_K(s, turn, r),
        "Two things: P shrinks by 1 − K·H, not by 1 − K; and asked is the root of P.",
    ),
    "the root of S": (
        lambda s, turn, r: np.hypot(s * np.sin(np.radians(turn)), r),
        "That is the root of S, H P H + R: how widely the readings scatter. Asked is the standard deviation along the needle after the reading.",
    ),
    "S": (
        lambda s, turn, r: (s * np.sin(np.radians(turn))) ** 2 + r**2,
        "That is S, H P H + R, the variance of the innovation. Asked is the standard deviation along the needle after the reading.",
    ),
    "the gain": (
        lambda s, turn, r: s**2 * np.sin(np.radians(turn)) / ((s * np.sin(np.radians(turn))) ** 2 + r**2),
        "That is the gain K. P after the reading is (1 − K·H)·P; take its root.",
    ),
    "the share": (
        lambda s, turn, r: fused(s, np.sin(np.radians(turn)), r) / s,
        "That is the factor by which σ shrinks. Multiply `sigma` by it.",
    ),
    "what is lost": (
        lambda s, turn, r: s - fused(s, np.sin(np.radians(turn)), r),
        "That is by how much σ becomes smaller. Asked is what is left.",
    ),
    "angle for its sine": (
        lambda s, turn, r: fused(s, np.radians(turn), r),
        "That is right for H = turn in radians, which is near its sine for small turns only: `np.sin(np.radians(turn))`.",
    ),
    "degrees for H": (
        lambda s, turn, r: fused(s, turn, r),
        "That is right for H = turn, in degrees. H is its sine.",
    ),
    "converted backwards": (
        lambda s, turn, r: fused(s, np.sin(np.degrees(turn)), r),
        "`np.degrees` turns radians into degrees. `turn` is in degrees, and NumPy's sine wants radians.",
    ),
    "R divides P": (
        lambda s, turn, r: s * np.cos(np.radians(turn)),
        "σ·cos(turn) is how long the needle seems along the new line. The reading looks across it: H is the sine, and R counts too.",
    ),
    "information": (
        lambda s, turn, r: 1 / s**2 + np.sin(np.radians(turn)) ** 2 / r**2,
        "That is the information, 1/P. The standard deviation is one divided by its root.",
    ),
    "σ for a variance": (
        lambda s, turn, r: fused(np.sqrt(s), np.sin(np.radians(turn)), r),
        "That is right for P = sigma. P before the reading is sigma².",
    ),
    "both taken for variances": (
        lambda s, turn, r: np.sqrt(fused(np.sqrt(s), np.sin(np.radians(turn)), np.sqrt(r)) ** 2),
        "That is right for P = sigma and R = across. Both are standard deviations, so square them.",
    ),
    "1 − K": (
        lambda s, turn, r: s * (1 - s**2 * np.sin(np.radians(turn)) / (s**2 * np.sin(np.radians(turn)) ** 2 + r**2)),
        "That is σ·(1 − K). The variance shrinks by 1 − K·H; and σ by its root.",
    ),
    "1 − KH": (
        lambda s, turn, r: s * r**2 / (s**2 * np.sin(np.radians(turn)) ** 2 + r**2),
        "1 − K·H is right, but it shrinks the variance. σ shrinks by its root.",
    ),
    "H once in S": (one_H, "S = H·P·H + R: the H stands twice, and you have it once."),
    "variances added": (
        lambda sigma, turn, across: np.sqrt(sigma**2 + (across / np.sin(np.radians(turn))) ** 2),
        "Your result is larger than sigma, and a reading makes no needle longer. It is what comes out if variances are added; in a correction the ones that add are the "
        "informations: 1/σ² + H²/R.",
    ),
}
