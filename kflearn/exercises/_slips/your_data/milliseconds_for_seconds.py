"""Lesson 27, `milliseconds_for_seconds`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._shown import show


def in_thousands(q):
    """What a number would mean that is in no row."""
    if q <= 0:
        return "q is a variance a time, and larger than 0."
    return f"Then q Δt³/3, with a Δt that is 1000 times too large, becomes {show(q * 1e10, 3)} times what it was. It is to stay as it was."


WRONG = {
    "÷ 1000": (
        1e-4,
        "That is 0.1 divided by 1000 once. The unit of q is m²/s³: the time stands there three times.",
    ),
    "÷ 1000²": (1e-7, "That is 0.1 divided by 1000². The unit of q is m²/s³: the time stands there once more."),
    "times": (1e8, "The wrong way round: the steps have become longer, so the variance a second has to shrink."),
    "unchanged": (
        0.1,
        "With the same number q the position would be 10⁹ times as uncertain after each step: NIS would fall.",
    ),
    "√": (
        lambda: 0.1 / 1000**1.5,
        "That is 0.1 divided by 1000^1.5, as for a standard deviation. q is a variance a time, m²/s³: divide by 1000³.",
    ),
    "times 1000": (
        100.0,
        "That is 0.1 times 1000. The steps have become longer, so q has to shrink; and the time stands three times in m²/s³.",
    ),
    "times 1000²": (
        1e5,
        "That is 0.1 times 1000². The steps have become longer, so q has to shrink; and the time stands three times in m²/s³.",
    ),
    "root of 1000": (
        0.1 / 1000**0.5,
        "That is 0.1 divided by √1000. Look at the unit of q, m²/s³: divide by 1000 for each of the three times.",
    ),
    "÷ 1000⁴": (
        1e-13,
        "That is 0.1 divided by 1000⁴. The unit of q is m²/s³: three times, not four.",
    ),
    "÷ 10⁷": (1e-8, "The noughts: 1000³ is 10⁹, and 0.1 divided by that is 10⁻¹⁰."),
    "÷ 10¹¹": (1e-12, "The noughts: 1000³ is 10⁹, and 0.1 divided by that is 10⁻¹⁰."),
    "without 0.1": (
        1e-9,
        "That is 1/1000³. It is to be multiplied by the 0.1 that q was before.",
    ),
    "only 1000⁻³ of a third": (
        0.1 / 3 / 1000**3,
        "The third in q Δt³/3 stands on both sides and cancels: 0.1 divided by 1000³.",
    ),
    "negative": (
        -0.1,
        "A variance cannot be negative. Divide by 1000 for each of the three times in m²/s³.",
    ),
    "the ride's q": (0.5 / 1000**3, "That is right for 0.5, the q of the ride. Here q was 0.1 m²/s³."),
    "the ride's q unchanged": (
        0.5,
        "0.5 is the q of the ride. Here q was 0.1 m²/s³; and all steps are 1000 times as long.",
    ),
    "÷ 3000": (
        0.1 / 3000,
        "That is 0.1 divided by 3 times 1000. The time stands three times in m²/s³: divide by 1000 · 1000 · 1000.",
    ),
    "a million": (
        0.1 / 1e18,
        "That is 0.1 divided by 10¹⁸, a million three times or 1000 six times. A second has a thousand milliseconds, and the "
        "time stands three times in m²/s³: q is no σ, so nothing is squared. Divide by 1000³.",
    ),
    "the thermometer": (
        3.54e-08,
        "That is the q of the lesson's thermometer. Start from 0.1 m²/s³; the time stands three times in the unit.",
    ),
    "the lift": (0.00109, "That q is the lesson's fit. Here q was 0.1: divide by 1000 as often as s stands in m²/s³."),
}
