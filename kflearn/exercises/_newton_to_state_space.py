"""Wrong answers to exercises of lesson 1, each with the sentence that it gets."""

import numpy as np


def moving(dt):
    """F of a cart."""
    return np.array([[1.0, dt], [0.0, 1.0]])


def column(upper, lower):
    """A matrix (2, 1)."""
    return np.array([[upper], [lower]])


def push_covariance(upper, lower, sigma):
    """σ² G Gᵀ with G = [upper, lower]."""
    G = column(upper, lower)
    return sigma**2 * G @ G.T


WRONG = {
    "motion": {
        "no push on the position": (
            lambda dt, mass: (moving(dt), column(0.0, dt / mass)),
            "F is right. Your force acts on the velocity only; during the step the new velocity already moves the cart: dt²/2m on top.",
        ),
        "[dt/2, 1]": (
            lambda dt, mass: (moving(dt), column(dt / 2, 1.0) / mass),
            "F is right. Your B lacks a factor dt in both entries: it is right at dt = 1 only.",
        ),
        "one half forgotten": (
            lambda dt, mass: (moving(dt), column(dt**2, dt) / mass),
            "F is right. The mean velocity of the step lies halfway: the first entry of B is dt²/2m.",
        ),
        "dt/2 above": (
            lambda dt, mass: (moving(dt), column(dt / 2, dt) / mass),
            "F is right. The first entry of B must turn newtons into metres, dt²/2m: yours lacks a factor dt.",
        ),
        "one half below too": (
            lambda dt, mass: (moving(dt), column(dt**2 / 2, dt / 2) / mass),
            "F is right. The ½ belongs to the position only: the velocity gets all of F/m·dt.",
        ),
        "mass forgotten": (
            lambda dt, mass: (moving(dt), column(dt**2 / 2, dt)),
            "F is right. Your B takes an acceleration; the input is a force, so divide by the mass.",
        ),
        "times the mass": (
            lambda dt, mass: (moving(dt), column(dt**2 / 2, dt) * mass),
            "F is right. You multiplied by the mass: a heavier cart would be pushed further. a = F/m.",
        ),
        "mass under one entry": (
            lambda dt, mass: (moving(dt), column(dt**2 / (2 * mass), dt)),
            "F is right, and so is the first entry of B. The second turns newtons into m/s: divide by the mass there too.",
        ),
        "B upside down": (
            lambda dt, mass: (moving(dt), column(dt, dt**2 / 2) / mass),
            "F is right. The entries of B have changed places: the state is [position, velocity], in this order.",
        ),
        "minus": (
            lambda dt, mass: (moving(dt), -column(dt**2 / 2, dt) / mass),
            "F is right. A force forwards pushes the cart forwards: B has no minus.",
        ),
        "F transposed": (
            lambda dt, mass: (moving(dt).T, column(dt**2 / 2, dt) / mass),
            "B is right. Your F is transposed: its first row makes the new position, so dt stands at the upper right.",
        ),
        "1 for dt": (
            lambda dt, mass: (moving(1.0), column(dt**2 / 2, dt) / mass),
            "B is right. In F you wrote 1 where dt belongs: the distance is velocity times time.",
        ),
        "identity": (
            lambda dt, mass: (np.eye(2), column(dt**2 / 2, dt) / mass),
            "B is right. With your F a cart that nobody pushes stands still: the velocity must move the position by v·dt.",
        ),
        "velocity lost": (
            lambda dt, mass: (np.array([[1.0, dt], [0.0, 0.0]]), column(dt**2 / 2, dt) / mass),
            "B is right. Your F forgets the velocity: without a force it stays as it was, so the lower right entry is 1.",
        ),
        "backwards": (
            lambda dt, mass: (moving(-dt), column(dt**2 / 2, dt) / mass),
            "B is right. Your F lets time run backwards: v·dt is added.",
        ),
        "everything at dt = 1": (
            lambda dt, mass: (moving(1.0), column(0.5, 1.0) / mass),
            "You took dt = 1 for granted. Your function gets dt as an argument: use it, in F and in B.",
        ),
        "F without dt, no push on the position": (
            lambda dt, mass: (np.eye(2), column(0.0, dt / mass)),
            "Nothing ever moves your position: (1) adds v·dt to it, and the push adds dt²/2m.",
        ),
        "a flat B": (
            lambda dt, mass: (moving(dt), np.array([dt**2 / 2, dt]) / mass),
            "The numbers are right. But your B is flat, of shape (2,): a row for each state, a column for each input, shape (2, 1).",
        ),
        "B in a row": (
            lambda dt, mass: (moving(dt), np.array([[dt**2 / 2, dt]]) / mass),
            "The numbers are right. But your B is a row: a row for each state, a column for each input, shape (2, 1).",
        ),
        "mass in F": (
            lambda dt, mass: (np.array([[1.0, dt], [0.0, 1 / mass]]), column(dt**2 / 2, dt) / mass),
            "B is right. No mass belongs in F: without a force the cart keeps its velocity, however heavy it is.",
        ),
        "the order of the pair": (
            lambda dt, mass: (column(dt**2 / 2, dt) / mass, moving(dt)),
            "Both are right, in the wrong order: return F first, then B.",
        ),
        "acceleration in F": (
            lambda dt, mass: (np.array([[1, dt**2 / 2], [0, 1.0]]), column(dt**2 / 2, dt) / mass),
            "B is right. In F you wrote dt²/2, which belongs to an acceleration: the velocity moves the position by v·dt.",
        ),
        "B without dt": (
            lambda dt, mass: (moving(dt), column(0.0, 1 / mass)),
            "F is right. A force acts for the whole step: the velocity gains F/m·dt, and the position dt²/2m.",
        ),
        "B a factor dt short": (
            lambda dt, mass: (moving(dt), column(dt, 1.0) / mass),
            "F is right. Write units beside B: its entries turn newtons into metres and metres per second, dt²/2m and dt/m.",
        ),
        "three states": (
            lambda dt, mass: (np.array([[1, dt, dt**2 / 2], [0, 1, dt], [0, 0, 1]]), column(dt**2 / 2, dt) / mass),
            "B is right. The acceleration is no part of the state here, it is the input: F is (2, 2).",
        ),
        "mass under the second": (
            lambda dt, mass: (moving(dt), column(dt**2 / 2, dt / mass)),
            "F is right, and so is the second entry of B. The first turns newtons into metres: divide by the mass there too.",
        ),
        "F turned": (
            lambda dt, mass: (moving(dt).T, column(dt**2 / 2, dt)),
            "F is transposed (dt stands at the upper right), and B is not divided by the mass yet.",
        ),
    },
    "held_push": {
        "as published": (
            lambda T, sigma: push_covariance(T / 2, 1.0, sigma),
            "That is still the published G: both entries lack a factor T, which shows at every T but 1.",
        ),
        "only the position mended": (
            lambda T, sigma: push_covariance(T**2 / 2, 1.0, sigma),
            "The position is mended. The velocity changes by a·T, so the lower entry of G is T.",
        ),
        "only the velocity mended": (
            lambda T, sigma: push_covariance(T / 2, T, sigma),
            "The velocity is mended. The position changes by a·T²/2: one more factor T above.",
        ),
        "one half forgotten": (
            lambda T, sigma: push_covariance(T**2, T, sigma),
            "The factors T are there, but the distance is a·T²/2: the ½ has got lost.",
        ),
        "σ for σ²": (
            lambda T, sigma: push_covariance(T**2 / 2, T, sigma) / sigma,
            "G is right. Q is a covariance: multiply by σ², not by σ.",
        ),
        "σ forgotten": (
            lambda T, sigma: push_covariance(T**2 / 2, T, 1.0),
            "G is right. Multiply by the variance σ² of the acceleration.",
        ),
        "white": (
            lambda T, sigma: sigma**2 * np.array([[T**3 / 3, T**2 / 2], [T**2 / 2, T]]),
            "That is the white Q, for an acceleration that is new at every instant. Here it is held for T: σ² G Gᵀ.",
        ),
        "diagonal only": (
            lambda T, sigma: sigma**2 * np.diag([T**4 / 4, T**2]),
            "The diagonal is right. One push disturbs both, so position and velocity err together: keep G Gᵀ whole.",
        ),
        "entry by entry": (
            lambda T, sigma: sigma**2 * column(T**2 / 2, T) * column(T**2 / 2, T),
            "You squared G entry by entry. Q is the product G @ G.T, a matrix (2, 2).",
        ),
        "G Gᵀ the other way": (
            lambda T, sigma: sigma**2 * (T**4 / 4 + T**2),
            "Gᵀ G is one number, and it adds m² to m²/s². Q is G @ G.T, a matrix (2, 2).",
        ),
        "standard deviations": (
            lambda T, sigma: sigma * column(T**2 / 2, T),
            "G times σ holds two standard deviations. Q is the covariance: (σG)(σG)ᵀ.",
        ),
        "upside down": (
            lambda T, sigma: push_covariance(T, T**2 / 2, sigma),
            "The entries of G have changed places: the state is [position, velocity], in this order.",
        ),
        "published Q times T": (
            lambda T, sigma: T * push_covariance(T / 2, 1.0, sigma),
            "You multiplied Q by T. G needs the factor T, and G stands twice in Q: that makes T².",
        ),
        "[T, 1]": (
            lambda T, sigma: push_covariance(T, 1.0, sigma),
            "Write units beside your G: an acceleration, held for T, makes metres above (T²/2) and metres per second below (T).",
        ),
        "half below too": (
            lambda T, sigma: push_covariance(T**2 / 2, T / 2, sigma),
            "The first entry of G is right. The velocity gains all of a·T: no ½ there.",
        ),
        "σ⁴": (
            lambda T, sigma: sigma**2 * push_covariance(T**2 / 2, T, sigma),
            "You multiplied by σ² twice. σ² G Gᵀ has it once.",
        ),
        "one power more": (
            lambda T, sigma: push_covariance(T**3 / 6, T**2 / 2, sigma),
            "That would be a jerk, held for T. An acceleration moves the velocity by a·T and the position by a·T²/2.",
        ),
        "corners not halved": (
            lambda T, sigma: sigma**2 * np.array([[T**4 / 4, T**3], [T**3, T**2]]),
            "The diagonal is right. The corners are the products of the two entries of G: T²/2 times T.",
        ),
        "G alone": (lambda T, sigma: column(T**2 / 2, T), "That is G. Q is the covariance σ² G Gᵀ, a matrix (2, 2)."),
    },
}
