"""Lesson 2: from Newton to the state space."""

import itertools

import numpy as np

from kflearn.exercises.engine import exercise


def steps_and_masses(rng):
    """A time step and a mass; neither is 1, where the usual mistakes do not show, nor are they equal."""
    dt = rng.choice([0.25, 0.5, 2.0, 4.0])
    return float(dt), float(rng.choice([3.0, 5.0, 6.0, 10.0]))


def moving(dt):
    """F of a cart."""
    return np.array([[1.0, dt], [0.0, 1.0]])


def column(upper, lower):
    """A matrix (2, 1)."""
    return np.array([[upper], [lower]])


@exercise(
    hints=[
        "Read (1) and (2) again: what stands before s, before v and before the force, in each of them?",
        "The first row of F is what (1) takes from s and from v. B is Γ = [dt²/2, dt], divided by something.",
        "`return np.array([[1, dt], [0, 1]]), np.array([[dt**2 / 2], [dt]]) / mass`",
    ],
    inputs=steps_and_masses,
    wrong={
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
        "the order of the pair": (
            lambda dt, mass: (column(dt**2 / 2, dt) / mass, moving(dt)),
            "Both are right, in the wrong order: return F first, then B.",
        ),
    },
)
def motion(dt, mass):
    """F and B of a cart of the given mass (kg) for a step of dt seconds, when the input is the force (N)."""
    F = np.array([[1, dt], [0, 1]])
    B = np.array([[dt**2 / 2], [dt]]) / mass
    return F, B


@exercise(
    hints=[
        "A row for each sensor, a column for each state: what does the sensor show for one metre, and what for one metre per second?",
        "No tape asks for the velocity, so the second column begins with two zeros. A metre is 100 cm; a metre per second is 3,600 m in an hour.",
        "Row by row: `[[1, 0], [100, 0], [0, 3.6]]`",
    ],
    wrong={
        "as published": (
            [[1, 1], [100, 0], [0, 3.6]],
            "The first row is still the article's [1, 1]: a tape does not see the velocity.",
        ),
        "ones everywhere": (
            [[1, 1], [100, 100], [3.6, 3.6]],
            "Each row asks for position and velocity at once. A tape sees the first only, a speedometer the second only.",
        ),
        "tapes that see the velocity": (
            [[1, 1], [100, 100], [0, 3.6]],
            "The speedometer is right. Both tapes still add the velocity to the position.",
        ),
        "centimetres the wrong way": (
            [[1, 0], [0.01, 0], [0, 3.6]],
            "The second row turns centimetres into metres. H goes from the state to the reading: 1 m reads 100.",
        ),
        "km/h the wrong way": (
            lambda: [[1, 0], [100, 0], [0, 1 / 3.6]],
            "The third row turns km/h into m/s. H goes from the state to the reading: 1 m/s reads 3.6.",
        ),
        "both the wrong way": (
            lambda: [[1, 0], [0.01, 0], [0, 1 / 3.6]],
            "Your units go from the reading to the state. H goes the other way: 1 m reads 100, and 1 m/s reads 3.6.",
        ),
        "speed in m/s": (
            [[1, 0], [100, 0], [0, 1]],
            "The tapes are right. The speedometer shows km/h, and the state holds m/s: 1 m/s reads 3.6.",
        ),
        "km/h without the hour": (
            [[1, 0], [100, 0], [0, 0.001]],
            "The tapes are right. You turned metres into kilometres, but not seconds into hours: 3,600 s for 1,000 m.",
        ),
        "metres per hour": (
            [[1, 0], [100, 0], [0, 3600]],
            "The tapes are right. Your speedometer shows metres per hour: divide by 1,000.",
        ),
        "km/h in the first column": (
            [[1, 0], [100, 0], [3.6, 0]],
            "The tapes are right. The speedometer's 3.6 stands in the column of the position.",
        ),
        "transposed": (
            [[1, 100, 0], [0, 0, 3.6]],
            "The numbers are right, but H is transposed: a row for each sensor, a column for each state, shape (3, 2).",
        ),
        "one number a sensor": (
            [1, 100, 3.6],
            "The numbers are right. Now say which state each belongs to: a row for each sensor, a column for each state, shape (3, 2).",
        ),
        "both tapes see the velocity": (
            [[1, 1], [100, 1], [0, 3.6]],
            "The speedometer is right. Both tapes see the velocity: their second entries should be 0.",
        ),
        "the second tape sees the velocity": (
            [[1, 0], [100, 1], [0, 3.6]],
            "The second tape sees the velocity: its second entry should be 0.",
        ),
        "columns exchanged": (
            [[0, 1], [0, 100], [3.6, 0]],
            "The columns have changed places: the state is [position, velocity], in this order.",
        ),
        "centimetres forgotten": (
            [[1, 0], [1, 0], [0, 3.6]],
            "The second tape reads centimetres: 1 m reads 100.",
        ),
        "no units": (
            [[1, 0], [1, 0], [0, 1]],
            "You picked the right states. But H converts units too: the second tape reads centimetres, the speedometer km/h.",
        ),
        "millimetres": (
            [[1, 0], [1000, 0], [0, 3.6]],
            "A metre has 1,000 millimetres; the second tape reads centimetres.",
        ),
    },
)
def three_sensors():
    """H for a tape in metres, a tape in centimetres and a speedometer in km/h; the state is [s (m), v (m/s)]."""
    return np.array([[1, 0], [100, 0], [0, 3.6]])


POSSIBLE = {
    "B": "B is possible: Q₁₂ is the mean of a position's error times a velocity's error, m · m/s = m²/s.",
    "D": "D is possible: K₂ gives m/s for each metre of the tape, (m/s)/m = 1/s.",
}
IMPOSSIBLE = {"A": "Which two units does A add?", "C": "In which unit is a variance?", "E": "What is (m/s²)·s?"}


def wrong_choices():
    """Every set of letters but the right one, with what to say about it: first what is too much, then what is missing."""
    letters = "ABCDE"
    for picked in (set(c) for size in range(1, 6) for c in itertools.combinations(letters, size)):
        too_many = [POSSIBLE[letter] for letter in letters if letter in picked and letter in POSSIBLE]
        missing = [IMPOSSIBLE[letter] for letter in letters if letter in IMPOSSIBLE and letter not in picked]
        if too_many:
            yield picked, " ".join(too_many)
        elif missing:
            yield picked, f"Right so far, and {len(missing)} more. {missing[0]}"


@exercise(
    hints=[
        "Write the unit beside every letter. A sum needs equal units, a variance the square of a unit, a gain the unit of what it corrects over the unit of what is read.",
        "a·dt/2 is (m/s²)·s. Is that a distance? s + v is m + m/s. R is the mean of a squared error of the tape.",
        "Three of the five are impossible: one sum, one variance, one distance.",
    ],
    wrong={", ".join(sorted(picked)): (picked, sentence) for picked, sentence in wrong_choices()},
)
def impossible():
    """Which cannot be right: A reads s + v, B Q₁₂ = 0.5 m²/s, C R = 0.5 m, D K₂ = 0.4 per second, E the distance a·dt/2?"""
    return {"A", "C", "E"}


def matrices_and_states(rng):
    """A full matrix (2, 2) without zeros and a state."""
    entries = rng.choice([-1.5, -0.5, 0.5, 1.5, 2.0], 4).reshape(2, 2)
    return entries, rng.choice([-3.0, -2.0, 1.0, 2.0, 4.0], 2)


def one_after_the_other(F, x, order=(0, 1)):
    """F x entry by entry, each written over the old one at once."""
    x = x.copy()
    for i in order:
        x[i] = F[i, 0] * x[0] + F[i, 1] * x[1]
    return x


@exercise(
    hints=[
        "Which x[0] does the second line want: the one before the step, or the one after it? For which F does that make no difference?",
        "Keep the old state under two names of its own before anything is overwritten. The cart was lucky: its F[1, 0] is 0.",
        "`s, v = x`, then `return np.array([F[0, 0] * s + F[0, 1] * v, F[1, 0] * s + F[1, 1] * v])`",
    ],
    inputs=matrices_and_states,
    wrong={
        "as published": (
            one_after_the_other,
            "The second line still meets the new x[0]. Keep the old values first (old = x is not enough: that is a second name for the same array).",
        ),
        "the other order": (
            lambda F, x: one_after_the_other(F, x, (1, 0)),
            "You exchanged the two lines. Now the line of x[0] meets the new x[1]: keep both old values first.",
        ),
        "transposed": (
            lambda F, x: F.T @ x,
            "Rows and columns are exchanged: the first entry is F[0, 0] * x[0] + F[0, 1] * x[1].",
        ),
        "diagonal only": (
            lambda F, x: np.diag(F) * x,
            "You left out F[0, 1] and F[1, 0]: each new entry is made of both old ones.",
        ),
        "entry by entry": (
            lambda F, x: F * x,
            "* multiplies entry by entry and gives a matrix. Each new entry is the sum of a row of it.",
        ),
        "only one entry mended": (
            lambda F, x: np.array([F[0] @ x, x[1]]),
            "The first entry is right. The second has not been moved at all.",
        ),
        "the same row twice": (
            lambda F, x: np.array([F[0] @ x, F[0] @ x]),
            "The first entry is right. The second takes the second row: F[1, 0] and F[1, 1].",
        ),
    },
)
def overwritten(F, x):
    """F x entry by entry, which a published program gets wrong by overwriting x[0] too early."""
    first = F[0, 0] * x[0] + F[0, 1] * x[1]
    second = F[1, 0] * x[0] + F[1, 1] * x[1]
    return np.array([first, second])


def steps_and_sigmas(rng):
    """A time step and the standard deviation of an acceleration, neither of them 1."""
    return float(rng.choice([0.5, 2.0, 3.0, 4.0])), float(rng.choice([0.2, 1.5, 2.5, 3.0]))


def spread(upper, lower, sigma):
    """σ² G Gᵀ with G = [upper, lower]."""
    G = column(upper, lower)
    return sigma**2 * G @ G.T


@exercise(
    hints=[
        "Write units beside G = [T/2; 1]: G times m/s² should be metres above and metres per second below.",
        "What does an acceleration a, held for T seconds, add to the position, what to the velocity? See (1) and (2).",
        "G = np.array([[T**2 / 2], [T]]), and Q as before: sigma**2 * G @ G.T.",
    ],
    inputs=steps_and_sigmas,
    wrong={
        "as published": (
            lambda T, sigma: spread(T / 2, 1.0, sigma),
            "That is still the published G: both entries lack a factor T, which shows at every T but 1.",
        ),
        "only the position mended": (
            lambda T, sigma: spread(T**2 / 2, 1.0, sigma),
            "The position is mended. The velocity changes by a·T, so the lower entry of G is T.",
        ),
        "only the velocity mended": (
            lambda T, sigma: spread(T / 2, T, sigma),
            "The velocity is mended. The position changes by a·T²/2: one more factor T above.",
        ),
        "one half forgotten": (
            lambda T, sigma: spread(T**2, T, sigma),
            "The factors T are there, but the distance is a·T²/2: the ½ has got lost.",
        ),
        "σ for σ²": (
            lambda T, sigma: spread(T**2 / 2, T, sigma) / sigma,
            "G is right. Q is a covariance: multiply by σ², not by σ.",
        ),
        "σ forgotten": (
            lambda T, sigma: spread(T**2 / 2, T, 1.0),
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
            lambda T, sigma: spread(T, T**2 / 2, sigma),
            "The entries of G have changed places: the state is [position, velocity], in this order.",
        ),
        "published Q times T": (
            lambda T, sigma: T * spread(T / 2, 1.0, sigma),
            "You multiplied Q by T. G needs the factor T, and G stands twice in Q: that makes T².",
        ),
    },
)
def held_push(T, sigma):
    """Q for an unknown acceleration of standard deviation sigma held for T, published with G = [T/2; 1]."""
    G = np.array([[T**2 / 2], [T]])
    return sigma**2 * G @ G.T
