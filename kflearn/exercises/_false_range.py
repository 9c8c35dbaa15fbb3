"""Wrong answers about a needle seen from the side (lesson 16), each with the sentence that it gets."""

import numpy as np


def fused(sigma, H, across):
    return sigma * across / np.sqrt(sigma**2 * H**2 + across**2)


WRONG = {
    "false_range": {
        "degrees as radians": (
            lambda s, turn, r: fused(s, np.sin(turn), r),
            "NumPy's sine wants radians: `np.sin(np.radians(turn))`.",
        ),
        "cosine": (
            lambda s, turn, r: fused(s, np.cos(np.radians(turn)), r),
            "You took the cosine. A needle that is not turned at all shows nothing of its length across the line: H is the sine.",
        ),
        "tangent": (
            lambda s, turn, r: fused(s, np.tan(np.radians(turn)), r),
            "You took the tangent of the turn; the length σ along the needle shows σ·sin(turn) across the new line.",
        ),
        "no turn": (
            lambda s, turn, r: fused(s, 1, r),
            "You fused as if the reading saw the needle at full length: H is the sine of the turn, not 1.",
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
            "You added standard deviations. Variances add: σ² sin² + across², and then the root.",
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
        "σ for a variance": (
            lambda s, turn, r: fused(np.sqrt(s), np.sin(np.radians(turn)), r),
            "You took `sigma` for a variance. P before the reading is sigma².",
        ),
        "both taken for variances": (
            lambda s, turn, r: np.sqrt(fused(np.sqrt(s), np.sin(np.radians(turn)), np.sqrt(r)) ** 2),
            "You took `sigma` and `across` for variances; both are standard deviations, so square them.",
        ),
        "1 − K": (
            lambda s, turn, r: (
                s * (1 - s**2 * np.sin(np.radians(turn)) / (s**2 * np.sin(np.radians(turn)) ** 2 + r**2))
            ),
            "You multiplied σ by 1 − K. The variance shrinks by 1 − K·H; and σ by its root.",
        ),
        "1 − KH": (
            lambda s, turn, r: s * r**2 / (s**2 * np.sin(np.radians(turn)) ** 2 + r**2),
            "1 − K·H is right, but it shrinks the variance. σ shrinks by its root.",
        ),
    },
}
