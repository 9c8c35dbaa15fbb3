"""Lesson 1, `held_push`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._slips.newton_to_state_space.shared import column
from kflearn.exercises._slips.shared import table


def push_covariance(upper, lower, sigma):
    """σ² G Gᵀ with G = [upper, lower]."""
    G = column(upper, lower)
    return sigma**2 * G @ G.T


def held(T):
    """The right G of an acceleration that is held."""
    return np.array([[T**2 / 2], [T]])


WRONG = {
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
        "That is G squared entry by entry, a column. Q is the product G @ G.T, a matrix (2, 2).",
    ),
    "G Gᵀ the other way": (
        lambda T, sigma: sigma**2 * (T**4 / 4 + T**2),
        "That is one number, Gᵀ G, and it adds m² to m²/s². If your G is flat, G.T changes nothing: make it a column, or use np.outer(G, G).",
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
        "That is the published Q times T. G needs the factor T, and G stands twice in Q: that makes T².",
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
    "only G": (lambda T, sigma: column(T**2 / 2, T), "That is G. Q is the covariance σ² G Gᵀ, a matrix (2, 2)."),
    "times T = 2 squared": (
        lambda T, sigma: 4 * sigma**2 * np.outer([T / 2, 1], [T / 2, 1]),
        "That is right at T = 2 s only: the factor by which Q is too small is T², not 4.",
    ),
    "doubled": (
        lambda T, sigma: 2 * sigma**2 * np.outer([T / 2, 1], [T / 2, 1]),
        "That is twice the published Q. Its G lacks a factor T, which stands twice in Q.",
    ),
    "G alone": (
        lambda T, sigma: sigma**2 * held(T),
        "That is σ² G, a column. Q is a matrix: σ² G Gᵀ.",
    ),
    "white, no corners": (
        lambda T, sigma: sigma**2 * T * np.diag([1 / 3, 1]),
        "Two things: the acceleration is held for T, so Q is σ² G Gᵀ; and one push disturbs position and velocity together, so Q has corners.",
    ),
    "T⁴ everywhere": (
        lambda T, sigma: sigma**2 * T**4 * np.array([[T**2 / 4, T / 2], [T / 2, 1]]),
        "That is the published Q times T⁴. G lacks one factor T, and G stands twice in Q: that makes T².",
    ),
    "T in the last entry": (
        lambda T, sigma: sigma**2 * np.array([[T**4 / 4, T**3 / 2], [T**3 / 2, T]]),
        "Three entries are right. The last is the variance of the velocity: the square of σ T.",
    ),
    "velocity alone": (
        lambda T, sigma: push_covariance(0.0, T, sigma),
        "The lower entry of G is right. The upper one is not 0: an acceleration that is held moves the cart too, by a·T²/2.",
    ),
    "position alone": (
        lambda T, sigma: push_covariance(T**2 / 2, 0.0, sigma),
        "The upper entry of G is right. The lower one is not 0: an acceleration that is held changes the velocity by a·T.",
    ),
    "1 for the velocity": (
        lambda T, sigma: sigma**2 * table(T**4 / 4, T**3 / 2, T**3 / 2, 1.0),
        "Three entries are right. The last is the variance of the velocity: (σ T)².",
    ),
    "corners once": (
        lambda T, sigma: sigma**2 * table(T**4 / 4, T**2 / 2, T**2 / 2, T**2),
        "The diagonal is right. The corners are the product of the two entries of G, T²/2 times T.",
    ),
    "white, times σ": (
        lambda T, sigma: sigma * table(T**3 / 3, T**2 / 2, T**2 / 2, T),
        "That is the white Q, with σ for σ². Here the acceleration is held for T: σ² G Gᵀ.",
    ),
    "half not squared": (
        lambda T, sigma: sigma**2 * np.array([[T**4 / 2, T**3 / 2], [T**3 / 2, T**2]]),
        "Upper left stands T⁴/2. It is the square of T²/2, and the half is squared too: T⁴/4.",
    ),
}
