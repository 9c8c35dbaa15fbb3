"""Lesson 28, `newest_ten`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._shown import show

CONSTANT_GAIN, SLOW_GAIN = 0.2207, 0.15


def older_than_ten(share):
    """What a number would mean that is in no row."""
    if not 0 <= share <= 1:
        return "A share of the whole is between 0 and 1."
    return f"That leaves {show(1 - share, 3)} to the readings older than the newest ten. One reading leaves 0.85 of the whole; what do ten of them leave?"


WRONG = {
    "the rest": (
        lambda: (1 - SLOW_GAIN) ** 10,
        "That is what lies on all readings older than these ten. The share of the ten is 1 minus it.",
    ),
    "nine readings": (
        lambda: 1 - (1 - SLOW_GAIN) ** 9,
        "That is the share of the newest nine. From j = 0 to 9 there are ten: after the first, 1 − K is left; after ten, (1 − K)¹⁰.",
    ),
    "eleven readings": (
        lambda: 1 - (1 - SLOW_GAIN) ** 11,
        "That is the share of the newest eleven: j = 0 to 9 are ten.",
    ),
    "one weight": (
        lambda: SLOW_GAIN * (1 - SLOW_GAIN) ** 9,
        "That is the weight of the tenth reading alone. Add up all ten.",
    ),
    "relative weight": (
        lambda: SLOW_GAIN * (1 - SLOW_GAIN) ** 10,
        "That is the weight of a single reading, ten nights ago. Add up the ten that are newer.",
    ),
    "ten times K": (
        lambda: 10 * SLOW_GAIN,
        "Only the newest reading has the weight K; and no share is larger than 1.",
    ),
    "the lesson's K": (
        lambda: 1 - (1 - CONSTANT_GAIN) ** 10,
        "That is right for the lesson's K = 0.2207. Here K is 0.15.",
    ),
    "powers of K": (
        lambda: 1 - SLOW_GAIN**10,
        "That is the whole weight, or nearly, but older readings have some of it: after each reading the part 1 − K of the weights before is left.",
    ),
    "per cent": (
        lambda: 100 * (1 - (1 - SLOW_GAIN) ** 10),
        "Right, in per cent. Give the share as a number between 0 and 1.",
    ),
    "as in a mean": (
        lambda: 10 / 40,
        "That would be the mean of forty readings, where all count the same. Here the newest count most.",
    ),
    "the tenth power of K": (
        lambda: SLOW_GAIN**10,
        "That is K to the power ten. After each reading the part 1 − K is left for the older ones.",
    ),
    "K forgotten": (
        lambda: (1 - (1 - SLOW_GAIN) ** 10) / SLOW_GAIN,
        "That is the sum of (1 − K)ʲ, without the factor K. A share is at most 1.",
    ),
    "ten of a hundred": (
        0.1,
        "That is ten of a hundred nights, if all counted the same. Here the newest count most.",
    ),
    "ten nights ago": (
        lambda: 1 - SLOW_GAIN,
        "That is what one reading leaves to all older ones. Ten readings leave (1 − K)¹⁰.",
    ),
    "j from 1": (
        lambda: sum(SLOW_GAIN * (1 - SLOW_GAIN) ** j for j in range(1, 11)),
        "That is the sum for j = 1 to 10. The newest reading has j = 0.",
    ),
    "the newest alone": (0.15, "That is the newest reading alone. Add the nine before it."),
    "as a list": (
        lambda: [SLOW_GAIN * (1 - SLOW_GAIN) ** j for j in range(10)],
        "These are the ten weights. Add them up.",
    ),
    "the rest in per cent": (
        lambda: 100 * (1 - SLOW_GAIN) ** 10,
        "That is the share of all older readings, in per cent. The ten newest have what is left of the whole.",
    ),
    "j from 1 to 9": (
        lambda: sum(0.15 * 0.85**j for j in range(1, 10)),
        "0.653 is the sum for j = 1 to 9. The newest reading, with j = 0, is one of the ten, and has the largest "
        "weight.",
    ),
}
