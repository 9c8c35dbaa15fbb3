"""More wrong answers to exercises of lessons 0 and 1, each with its sentence: those that a second stranger tried."""

import numpy as np

from kflearn.exercises._newton_to_state_space import column, dragged, held_drag, push, push_covariance

SCATTER = "That is how far the readings scatter. Asked is their mean."
NO_DT = "Your B is right, and so is the first row of F. In the second row the drag lacks dt: it acts for dt seconds."


def table(a, b, c, d):
    """A matrix (2, 2)."""
    return np.array([[a, b], [c, d]])


WRONG = {
    "three_readings": {
        "no brackets": (
            145,
            "145 is 61 + 62 + 66/3: only the 66 is divided by 3. Put brackets around the sum: (61 + 62 + 66) / 3.",
        ),
        "from 60": (3, "If you counted from 60 m, 3 m is the mean of 1, 2 and 6 m: add the 60 m again."),
        "scatter, n − 1": (lambda: np.std([61, 62, 66], ddof=1), SCATTER),
        "scatter": (lambda: np.std([61, 62, 66]), SCATTER),
        "variance": (lambda: np.var([61, 62, 66]), SCATTER),
        "variance, n − 1": (7, SCATTER),
        "range": (5, "5 m is the distance from the smallest reading to the largest. Asked is the mean of all three."),
        "in pairs": (
            63.75,
            "That is the mean of 61.5, the mean of the first two, and 66. The 66 then counts as much as the other two together.",
        ),
        "in pairs, the last two first": (
            62.5,
            "That is the mean of 61 and 64, the mean of the last two. The 61 then counts as much as the other two together.",
        ),
        "by four": (47.25, "47.25 is 189/4. There are three readings."),
    },
    "update_mean": {
        "√n": (
            lambda mean, n, z: mean + (z - mean) / np.sqrt(n),
            "You divided by √n. That belongs to the σ of a mean; the weight of one reading among n is 1/n.",
        ),
        "size of the surprise": (
            lambda mean, n, z: mean + abs(z - mean) / n,
            "Your mean never falls: the surprise has a sign, and a reading below the mean has to lower it.",
        ),
        "n²": (
            lambda mean, n, z: mean + (z - mean) / n**2,
            "You divided by n twice. The weight of one reading among n is 1/n.",
        ),
    },
    "root_mean_square": {
        "minus 40": (
            lambda error: np.sqrt(np.mean((error - 40) ** 2)),
            "You took 40 m away. The function gets errors: the truth has been taken away already.",
        ),
        "largest squared": (
            lambda error: np.max(error**2),
            "That is the largest square. Take the mean of all squares, and then the root.",
        ),
    },
    "motion": {
        "velocity braked by the position": (
            lambda dt, mass, c: (table(1, dt, -c * dt / mass, 1.0), push(dt, mass)),
            "B is right. In F the drag stands in the column of the position. It depends on the velocity, so it belongs to the second column, in both rows.",
        ),
        "no dt anywhere": (
            lambda dt, mass, c: (dragged(dt, c * dt / (2 * mass), c / mass), column(dt / 2, 1.0) / mass),
            "In F and in B a factor dt is missing, in both rows: a force that acts for dt seconds changes the velocity by F/m·dt.",
        ),
        "no dt below": (lambda dt, mass, c: (dragged(dt, c * dt**2 / (2 * mass), c / mass), push(dt, mass)), NO_DT),
        "one dt above": (
            lambda dt, mass, c: (dragged(dt, c * dt / (2 * mass), c * dt / mass), push(dt, mass)),
            "B is right, and so is the second row of F. In the first row the drag needs dt², as the force does in (1).",
        ),
        "one dt above, no half": (
            lambda dt, mass, c: (dragged(dt, c * dt / mass, c * dt / mass), push(dt, mass)),
            "B is right, and so is the second row of F. In the first row the drag needs ½·dt², as the force does in (1).",
        ),
        "plus below": (
            lambda dt, mass, c: (dragged(dt, c * dt**2 / (2 * mass), -c * dt / mass), push(dt, mass)),
            "B is right, and so is the first row of F. In the second row the drag has the wrong sign: it brakes.",
        ),
        "plus above": (
            lambda dt, mass, c: (dragged(dt, -c * dt**2 / (2 * mass), c * dt / mass), push(dt, mass)),
            "B is right, and so is the second row of F. In the first row the drag has the wrong sign: it brakes.",
        ),
        "no mass below": (
            lambda dt, mass, c: (dragged(dt, c * dt**2 / (2 * mass), c * dt), push(dt, mass)),
            "B is right, and so is the first row of F. In the second row the drag is not divided by the mass.",
        ),
        "no mass above": (
            lambda dt, mass, c: (dragged(dt, c * dt**2 / 2, c * dt / mass), push(dt, mass)),
            "B is right, and so is the second row of F. In the first row the drag is not divided by the mass.",
        ),
        "drag alone": (
            lambda dt, mass, c: (table(1, dt, 0.0, c * dt / mass), push(dt, mass)),
            "B is right. The second row of F should keep the old velocity, less the part c·dt/m; and in the first row the drag is missing.",
        ),
        "no drag, B transposed": (
            lambda dt, mass, c: (held_drag(dt, mass, c), push(dt, mass) * mass**2),
            "F is right. You multiplied B by the mass: a force makes a heavy cart move less, so divide by it.",
        ),
    },
    "held_push": {
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
    },
}
