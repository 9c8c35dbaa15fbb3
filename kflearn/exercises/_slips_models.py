"""More wrong answers to exercises of lesson 18, each with the sentence that it gets."""

import math

import numpy as np


def chances(stays, T, leave):
    """A transition matrix whose rows leave with given chances."""
    M, leave = len(stays), leave[:, None]
    return np.where(np.eye(M, dtype=bool), 1 - leave, leave / (M - 1))


def started(z, T, speed=None):
    """The right start; or one with other speeds."""
    speed = (z[:, 1] - z[:, 0]) / T if speed is None else speed
    return z[:, 0], np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)


MORE = {
    "blended_sigma": {
        "both σ": (
            60.0,
            "60 m is the sum of the two σ. Add squares instead: the variance of a Gaussian, and the squared distance of its mean from the middle.",
        ),
        "variance of one": (
            900.0,
            "900 m² is the variance of one Gaussian. What is missing is the squared distance to the blend's mean, and then the root.",
        ),
        "variances added": (
            math.sqrt(1800),
            "That is √(30² + 30²), as for a sum of two errors. The blend takes the mean of the two variances, and adds the squared distance of each mean from the middle.",
        ),
        "spread not halved": (
            math.sqrt(900 + 3200),
            "That is √(900 + 3200). 900 m² is the variance of each, but 3200 m² is the sum of the two squared distances from the middle: take their mean.",
        ),
        "distance not squared": (
            math.sqrt(940),
            "That is √(900 + 40). The distance from the middle must be squared as well.",
        ),
        "nothing squared": (
            math.sqrt(70),
            "That is √(30 + 40). Square both first.",
        ),
        "all of it halved": (
            math.sqrt(1250),
            "That is √(2500/2), half once too often: the mean of the two variances is 900 m², the mean of the two squared distances 1600 m².",
        ),
        "weights squared": (
            math.sqrt(900 + 400),
            "That is √(900 + 400). 900 m² is the variance of each, but 400 m² belongs to a distance of 20 m: each mean is 40 m from the middle.",
        ),
        "half of it": (
            15.0,
            "15 m is half of a σ. Take the mean of the two variances, add the squared distance of each mean from the middle, then take the root.",
        ),
        "spread for one only": (
            math.sqrt(30**2 + 40**2 / 2),
            "That is √(900 + 800), with the spread of one of the two Gaussians only, or half of it: each of the two means is 40 m from the middle.",
        ),
        "everything added": (
            110.0,
            "110 m is 30 m + 80 m, σ and the distance of the means. Variances and squared distances add; the root comes last.",
        ),
        "both variances": (
            math.sqrt(2 * 30**2 + 40**2),
            "That is √(900 + 900 + 1600), with both variances in full. The blend takes their weighted mean, half of each.",
        ),
        "both variances, both spreads": (
            math.sqrt(2 * 30**2 + 2 * 40**2),
            "That is √(2 · 900 + 2 · 1600), everything for both models. Each counts with its weight, one half.",
        ),
        "half the variance": (
            math.sqrt(30**2 / 2 + 40**2),
            "That is √(450 + 1600), with half of the variance. The mean of two equal variances, half of each, is one of them: 900 m².",
        ),
    },
    "transition": {
        "also to itself": (
            lambda stays, T: np.diag(1 - T / stays) + (T / stays)[:, None] / len(stays),
            "Off the diagonal stands T/(stays·M), as if a ship that leaves a mode could pass to the same mode again. It "
            "passes to one of the *other* M − 1.",
        ),
        "T = 2": (
            lambda stays, T: chances(stays, T, 2 / stays),
            "That is right for readings every 2 s. The time between them is handed in as `T`.",
        ),
        "half-life": (
            lambda stays, T: chances(stays, T, 1 - 0.5 ** (T / stays)),
            "That is right if `stays` were a half-life. It is the mean time in the mode: with the chance p to leave in each step that is 1/p steps.",
        ),
        "leave alone": (
            lambda stays, T: chances(stays, T, T / stays) - np.diag(1 - T / stays),
            "The entries off the diagonal are right. On the diagonal stands the chance to stay, 1 − T / stays.",
        ),
        "whole number of steps": (
            lambda stays, T: chances(stays, T, 1 / np.ceil(stays / T)),
            "You rounded the number of steps. A mean of steps need not be a whole number: the chance to leave is T / stays.",
        ),
        "two by two": (
            lambda stays, T: T / stays,
            "Those are the chances to leave, one for each mode. Write the whole matrix, (M, M).",
        ),
        "chances to stay": (
            lambda stays, T: 1 - T / stays,
            "Those are the chances to stay, one for each mode. Write the whole matrix, (M, M).",
        ),
        "stays over T, at most 1": (
            lambda stays, T: chances(stays, T, np.minimum(1, stays / T)),
            "You divided stays by T. The chance to leave in one step is T / stays: the longer the stay, the smaller it is.",
        ),
        "whole steps": (
            lambda stays, T: chances(stays, T, 1 / (stays / T + 1)),
            "That is right for one step more, stays/T + 1. A mode that lasts `stays / T` steps on average is left with the chance T / stays.",
        ),
        "half": (
            lambda stays, T: chances(stays, T, T / stays / 2),
            "Your chance to leave is half of what it should be. It is T / stays, and the other M − 1 modes share it.",
        ),
        "the first for all": (
            lambda stays, T: chances(stays, T, T / stays[0] + 0 * stays),
            "All rows are right for the first length. Each mode has its own: row i belongs to `stays[i]`.",
        ),
    },
    "mended_start": {
        "runs and samples exchanged": (
            lambda z, T: (z[0], started(z, T)[1]),
            "`z[0]` is run 1 with all its samples. Read the indices aloud: run, sample, component. The first positions of all runs are `z[:, 0]`.",
        ),
        "first of run 1": (
            lambda z, T: (z[0, 0], started(z, T)[1]),
            "The states are right. Your first position is that of run 1 alone: put a colon in the place of the run.",
        ),
        "T = 2": (
            lambda z, T: started(z, 2),
            "Your speeds are right for readings 2 s apart. The time between them is handed in as `T`.",
        ),
        "speed of one sample": (
            lambda z, T: started(z, T, z[:, 1] / T),
            "You divided the second position by T. A speed is a *difference* of positions divided by T.",
        ),
        "speed east twice": (
            lambda z, T: started(z, T, (z[:, 1] - z[:, 0])[:, [0, 0]] / T),
            "You took the speed towards east for both. The last state is the speed towards north, `speed[:, 1]`.",
        ),
        "speed north twice": (
            lambda z, T: started(z, T, (z[:, 1] - z[:, 0])[:, [1, 1]] / T),
            "You took the speed towards north for both. The second state is the speed towards east, `speed[:, 0]`.",
        ),
        "speeds exchanged": (
            lambda z, T: started(z, T, (z[:, 1] - z[:, 0])[:, ::-1] / T),
            "The two speeds have changed places: the state is [east, its speed, north, its speed].",
        ),
        "first exchanged": (
            lambda z, T: (z[:, 0, ::-1], started(z, T)[1]),
            "The states are right. In the first positions north stands before east.",
        ),
        "two states alone": (
            lambda z, T: (z[:, 0], z[:, 1]),
            "The positions are right. The state holds the speeds too: [east, its speed, north, its speed].",
        ),
        "speed over two steps": (
            lambda z, T: started(z, 2 * T),
            "Your speeds are half of what they should be. From the first to the second sample there is one step, T.",
        ),
        "all first positions by T": (
            lambda z, T: (started(z, T)[1], z[:, 0]),
            "Both are right, in the wrong order: first the first positions, then the states.",
        ),
    },
}
