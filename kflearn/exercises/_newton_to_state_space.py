"""Wrong answers to exercises of lesson 1, each with the sentence that it gets."""

import numpy as np


def moving(dt):
    """F of a cart."""
    return np.array([[1.0, dt], [0.0, 1.0]])


def column(upper, lower):
    """A matrix (2, 1)."""
    return np.array([[upper], [lower]])


def push(dt, mass):
    """B of a cart."""
    return column(dt**2 / 2, dt) / mass


def dragged(dt, less_far, slower):
    """F of a cart that goes less far, and is slower, by so much of its velocity."""
    return np.array([[1.0, dt - less_far], [0.0, 1.0 - slower]])


def held_drag(dt, mass, c):
    """The right F of a cart with drag."""
    return dragged(dt, c * dt**2 / (2 * mass), c * dt / mass)


def decaying(dt, mass, c):
    """F for a drag that follows the velocity at every instant."""
    left = np.exp(-c * dt / mass)
    return np.array([[1.0, mass / c * (1 - left)], [0.0, left]])


def push_covariance(upper, lower, sigma):
    """σ² G Gᵀ with G = [upper, lower]."""
    G = column(upper, lower)
    return sigma**2 * G @ G.T


def first_wrong_row(H):
    """What to look at, for an H of the right form: the first sensor whose row is not right."""
    rows = {"the tape in metres": [1, 0], "the tape in centimetres": [100, 0], "the speedometer": [0, 3.6]}
    names = [name for row, (name, right) in zip(H, rows.items(), strict=True) if not np.allclose(row, right)]
    if np.isclose(H[1][0], 100 * H[0][0]) and abs(H[0][0]) > 1.5 and not (H[0][1] or H[1][1]):
        return (
            f"These look like readings: a tape that shows {H[0][0]:g} m. H holds no readings, but what each sensor shows for "
            "1 m and 0 m/s (first column), and for 0 m and 1 m/s (second column)."
        )
    return f"Look at the {'row' if len(names) == 1 else 'rows'} of {' and '.join(names)}: what is shown for 1 m and 0 m/s, and what for 0 m and 1 m/s?"


WRONG = {
    "motion": {
        "no drag": (
            lambda dt, mass, c: (moving(dt), push(dt, mass)),
            "B is right. Your F is that of the cart without drag. The force −c·v depends on the velocity, so it belongs to F.",
        ),
        "no half in the first rows": (
            lambda dt, mass, c: (dragged(dt, c * dt**2 / mass, c * dt / mass), column(dt**2, dt) / mass),
            "The second rows are right. In the first row of F and in that of B the ½ is missing: a force that acts for dt seconds "
            "moves the cart by ½·F/m·dt², as in (1).",
        ),
        "drag that follows the velocity": (
            lambda dt, mass, c: (
                decaying(dt, mass, c),
                column(dt - decaying(dt, mass, c)[0, 1], 1 - decaying(dt, mass, c)[1, 1]) / c,
            ),
            "You solved the differential equation, in which the drag follows the velocity at every instant. Here it is held during "
            "a step at −c·v with the v of the beginning, as the text says: put u − c·v into (1) and (2).",
        ),
        "drag in the velocity only": (
            lambda dt, mass, c: (dragged(dt, 0.0, c * dt / mass), push(dt, mass)),
            "B is right, and so is the second row of F. In the first row the drag is missing: it acts during the whole step, like u in (1).",
        ),
        "drag in the position only": (
            lambda dt, mass, c: (dragged(dt, c * dt**2 / (2 * mass), 0.0), push(dt, mass)),
            "B is right, and so is the first row of F. In the second row the drag is missing: it makes the cart slower, as in (2).",
        ),
        "one half forgotten": (
            lambda dt, mass, c: (dragged(dt, c * dt**2 / mass, c * dt / mass), push(dt, mass)),
            "B is right, and so is the second row of F. In the first row the ½ of (1) is missing before the drag.",
        ),
        "one half below too": (
            lambda dt, mass, c: (dragged(dt, c * dt**2 / (2 * mass), c * dt / (2 * mass)), push(dt, mass)),
            "B is right, and so is the first row of F. In the second row there is no ½: the velocity gets all of the force's F/m·dt.",
        ),
        "plus": (
            lambda dt, mass, c: (dragged(dt, -c * dt**2 / (2 * mass), -c * dt / mass), push(dt, mass)),
            "B is right. Your drag pushes the cart forwards: the force is −c·v, with a minus.",
        ),
        "mass forgotten in the drag": (
            lambda dt, mass, c: (dragged(dt, c * dt**2 / 2, c * dt), push(dt, mass)),
            "B is right. In F the drag is not divided by the mass yet: c·v is a force, and a force changes the velocity by F/m.",
        ),
        "dt forgotten in the drag": (
            lambda dt, mass, c: (dragged(dt, c * dt / (2 * mass), c / mass), push(dt, mass)),
            "B is right. In F the drag lacks a factor dt in both rows: it acts for dt seconds.",
        ),
        "a spring": (
            lambda dt, mass, c: (np.array([[1 - c * dt**2 / (2 * mass), dt], [-c * dt / mass, 1.0]]), push(dt, mass)),
            "B is right. In your F the force depends on the position: that is a spring. A drag depends on the velocity, so it belongs to the second column of F.",
        ),
        "minus c alone": (
            lambda dt, mass, c: (np.array([[1, dt - c * dt**2 / (2 * mass)], [0, -c * dt / mass]]), push(dt, mass)),
            "B is right, and so is the first row of F. The second row has lost the old velocity: v stays, less c·dt/m of it.",
        ),
        "first row without dt": (
            lambda dt, mass, c: (
                np.array([[1, -c * dt**2 / (2 * mass)], [0, 1 - c * dt / mass]]),
                push(dt, mass),
            ),
            "B is right, and so is the second row of F. The first row has lost v·dt, the distance without any force.",
        ),
        "exact": (
            lambda dt, mass, c: (decaying(dt, mass, c), push(dt, mass)),
            "That F is exact for a drag which follows the velocity at every instant. Here the drag is held during the step, so F has no exponential.",
        ),
        "exact velocity": (
            lambda dt, mass, c: (
                np.array([[1, dt - c * dt**2 / (2 * mass)], [0, np.exp(-c * dt / mass)]]),
                push(dt, mass),
            ),
            "B is right, and so is the first row of F. The drag is held during the step: the velocity falls by c·dt/m of itself, without an exponential.",
        ),
        "drag in B": (
            lambda dt, mass, c: (moving(dt), (1 - c) * push(dt, mass)),
            "The drag is no part of the input: it depends on v, and v is part of the state. It belongs to F.",
        ),
        "B braked": (
            lambda dt, mass, c: (held_drag(dt, mass, c), (1 - c * dt / mass) * push(dt, mass)),
            "F is right. B has the factors of u alone, and in u − c·v the force u stands undiminished: B is that of the lesson.",
        ),
        "no push on the position": (
            lambda dt, mass, c: (held_drag(dt, mass, c), column(0.0, dt / mass)),
            "F is right. Your force acts on the velocity only; during the step the new velocity already moves the cart: dt²/2m on top.",
        ),
        "[dt/2, 1]": (
            lambda dt, mass, c: (held_drag(dt, mass, c), column(dt / 2, 1.0) / mass),
            "F is right. Your B lacks a factor dt in both entries: it is right at dt = 1 only.",
        ),
        "one half forgotten in B": (
            lambda dt, mass, c: (held_drag(dt, mass, c), column(dt**2, dt) / mass),
            "F is right. The mean velocity of the step lies halfway: the first entry of B is dt²/2m.",
        ),
        "dt/2 above": (
            lambda dt, mass, c: (held_drag(dt, mass, c), column(dt / 2, dt) / mass),
            "F is right. The first entry of B must turn newtons into metres, dt²/2m: yours lacks a factor dt.",
        ),
        "mass forgotten": (
            lambda dt, mass, c: (held_drag(dt, mass, c), column(dt**2 / 2, dt)),
            "F is right. Your B takes an acceleration; the input is a force, so divide by the mass.",
        ),
        "mass forgotten in both": (
            lambda dt, mass, c: (dragged(dt, c * dt**2 / 2, c * dt), column(dt**2 / 2, dt)),
            "The mass is missing, in F and in B: u and c·v are forces, and a force changes the velocity by F/m.",
        ),
        "mass under one entry": (
            lambda dt, mass, c: (held_drag(dt, mass, c), column(dt**2 / (2 * mass), dt)),
            "F is right, and so is the first entry of B. The second turns newtons into m/s: divide by the mass there too.",
        ),
        "mass under the second": (
            lambda dt, mass, c: (held_drag(dt, mass, c), column(dt**2 / 2, dt / mass)),
            "F is right, and so is the second entry of B. The first turns newtons into metres: divide by the mass there too.",
        ),
        "B upside down": (
            lambda dt, mass, c: (held_drag(dt, mass, c), column(dt, dt**2 / 2) / mass),
            "F is right. The entries of B have changed places: the state is [position, velocity], in this order.",
        ),
        "F transposed": (
            lambda dt, mass, c: (held_drag(dt, mass, c).T, push(dt, mass)),
            "B is right. Your F is transposed: its first row makes the new position, so the factor of v stands at the upper right.",
        ),
        "everything at dt = 1": (
            lambda dt, mass, c: (held_drag(1.0, mass, c), push(1.0, mass)),
            "That is right at dt = 1 only. Your function gets dt as an argument: use it, in F and in B.",
        ),
        "a flat B": (
            lambda dt, mass, c: (held_drag(dt, mass, c), push(dt, mass).ravel()),
            "The numbers are right. But your B is flat, of shape (2,): a row for each state, a column for each input, shape (2, 1).",
        ),
        "B in a row": (
            lambda dt, mass, c: (held_drag(dt, mass, c), push(dt, mass).T),
            "The numbers are right. But your B is a row: a row for each state, a column for each input, shape (2, 1).",
        ),
        "the order of the pair": (
            lambda dt, mass, c: (push(dt, mass), held_drag(dt, mass, c)),
            "Both are right, in the wrong order: return F first, then B.",
        ),
        "F alone": (
            lambda dt, mass, c: held_drag(dt, mass, c),
            "Your F is right. B is wanted as well: return both, F first.",
        ),
        "no drag, no mass": (
            lambda dt, mass, c: (moving(dt), column(dt**2 / 2, dt)),
            "Two things: the drag is missing in F, and B is not divided by the mass.",
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
    },
}
