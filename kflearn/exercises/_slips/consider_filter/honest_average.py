"""Lesson 21, `honest_average`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np

WRONG = {
    "inflated": (
        lambda N, R, B: math.sqrt((R + B) / N),
        "That is √((R + B)/N), with the bias divided by N as well. It is the inflated filter: it takes N readings for N different biases.",
    ),
    "ignored": (lambda N, R, B: math.sqrt(R / N), "That is √(R/N), the naive filter's claim, without the bias."),
    "variance": (lambda N, R, B: R / N + B, "That is the variance; the standard deviation is its root."),
    "standard deviations added": (
        lambda N, R, B: math.sqrt(R / N) + math.sqrt(B),
        "Standard deviations of independent errors do not add; their variances do.",
    ),
    "nothing averaged": (
        lambda N, R, B: math.sqrt(R + B),
        "That is a single reading. The noise differs from reading to reading, so averaging does help against it.",
    ),
    "noise as N": (
        lambda N, R, B: math.sqrt(R / math.sqrt(N) + B),
        "A variance falls with N; it is the standard deviation that falls with √N.",
    ),
    "all over N": (
        lambda N, R, B: math.sqrt(R + B) / N,
        "That is √(R + B)/N, with the bias divided by N as well. The noise's variance falls as R / N; the bias does not fall.",
    ),
    "bias falls faster": (
        lambda N, R, B: math.sqrt(R / N + B / N**2),
        "Here the bias falls with N. All N readings share one bias: its mean is the bias itself.",
    ),
    "noise over N squared": (
        lambda N, R, B: math.sqrt(R / N**2 + B),
        "The bias is right. The variance of a mean of N independent noises is R / N, not R / N²: N variances add,"
        " and the sum is divided by N².",
    ),
    "σ of the noise over N": (
        lambda N, R, B: math.sqrt(R) / N + math.sqrt(B),
        "Two things: the noise's σ falls with √N, and standard deviations do not add. Add R / N and B, then take "
        "the root.",
    ),
    "bias squared": (
        lambda N, R, B: math.sqrt(R / N + B**2),
        "B is a variance already: do not square it.",
    ),
    "both squared": (
        lambda N, R, B: math.sqrt(R**2 / N + B**2),
        "R and B are variances already: do not square them.",
    ),
    "bias alone": (
        lambda N, R, B: math.sqrt(B),
        "That is what remains when N is very large. The noise still counts: R / N.",
    ),
    "bias averaged": (
        lambda N, R, B: math.sqrt(R + B / N),
        "The other way round: the noise differs from reading to reading and is averaged; the bias is the same in "
        "all of them.",
    ),
    "mixed": (
        lambda N, R, B: math.sqrt(R / N) + B,
        "A standard deviation and a variance are added here. Add the variances R / N and B, then take the root over the whole sum.",
    ),
    "bias N times": (
        lambda N, R, B: np.sqrt(R / N + N * B),
        "All N readings hold the same bias, so their mean holds it once: B, not N·B.",
    ),
    "fused": (
        lambda N, R, B: np.sqrt(1 / (N / R + 1 / B)),
        "That is what fusing noise and bias gives, like two readings. They are two errors of one average, so their variances add: R/N + B.",
    ),
    "root of the bias alone": (
        lambda N, R, B: np.sqrt(B) + R / N,
        "Only B is under the root here. The root goes over the whole sum, R/N + B: look at the brackets.",
    ),
}
