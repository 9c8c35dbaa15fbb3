"""Lesson 9: what several exercises' wrong answers are made of."""

import numpy as np

from kflearn import angle_difference

ROUND = "As with `% 360`, a small step to the left is nearly a whole turn: −3° is 357°. The short way is between −180 and 180."

DISTANCES = {"short": angle_difference, "plain": np.subtract, "mod": lambda z, x: np.subtract(z, x) % 360}


def wide(sigmas):
    return f"Your gate is {sigmas}σ wide; 3σ is wanted."
