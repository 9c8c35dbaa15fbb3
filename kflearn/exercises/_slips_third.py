"""Wrong answers to exercises of lessons 0 to 8 that a third group of strangers gave, and more of their kind."""

import itertools

import numpy as np

from kflearn import chi_square_interval
from kflearn.exercises._newton_to_state_space import column, dragged
from kflearn.exercises._words import heard

SCALED = "You multiplied the mean of |error| by a fixed number. An rms is something else: square, take the mean, then the root."
READINGS = (
    "These are readings. H holds what makes readings of [p, v]: two factors in a row, and one row for each sensor."
)
TWO_ROWS = "In the first rows of F and B stands dt/2m. By (1) the distance needs dt²/2m: check the units."
KNOBS = {
    frozenset("AC"): "C is enough. A on top of it would change the ratio, and so the estimate.",
    frozenset("BC"): "C is enough. B on top of it would change the ratio, and so the estimate.",
    frozenset("CE"): "C is enough. E has no lasting effect: P₀ is forgotten after a few readings.",
    frozenset(
        "CD"
    ): "C and D are opposites: one makes the claim larger, the other smaller. Which does a claim that is too small need?",
    frozenset("ABC"): "C is enough. A and B say something else: each of them by itself changes the ratio.",
}
ALL_KNOBS = "Is the estimate bad, or the claim? 0.27 V is nearly the best possible, so only the claim is to be mended: choose one."
SUSPECTS = ["Q too large", "Q too small", "R too large", "R too small"]
MYSTERIES = {
    ("Q too large", "R too small"): "Both agree with the minus sign. Look at NIS: one of them makes it larger than 2, the other smaller.",
    ("Q too small", "R too large"): "Both make the gain too small, and neighbours alike: a plus sign. Here the sign is minus.",
    ("Q too large", "R too large"): "Both agree with NIS below 2. Look at the sign: one makes the gain too large, the other too small.",
    ("Q too small", "R too small"): "Both make NIS larger than 2. Here it is 1.85.",
    ("Q too large", "Q too small"): "You chose both directions for Q. NIS below 2 decides: is the claimed error too large or too small?",
    ("R too large", "R too small"): "With R alone sign and NIS do not agree: too large explains the NIS, too small the sign. Which choice explains both?",
}  # fmt: skip


def of_interval(limits):
    """How many of the averages lie between two limits; None where they are none."""
    from scipy.stats import chi2

    low, high = limits
    if not low < high:
        return None
    share = 100 * np.ptp(chi2.cdf(np.multiply(limits, 50), 100))
    if share > 99.5:
        single = np.allclose(limits, chi2.ppf([0.025, 0.975], 2), rtol=0.02)
        words = (
            "Those are the limits for a single run."
            if single
            else "Practically every average lies between these limits."
        )
        return f"{words} An average of 50 runs scatters far less: chi-square with 50 · 2 degrees of freedom, divided by 50."
    return f"Between {low:.4g} and {high:.4g} lie {share:.3g} % of the averages. 95 % are wanted, and 2.5 % on either side."


def grown(steps):
    """The offset after so many steps, of which the correction reduces only what is added."""
    return lambda x1, K, dt: steps * (1 - K) * dt * x1


def row_by_row(P, K):
    """The second row is made of the first one when that is changed already."""
    M = np.array(P, float)
    M[0] = (1 - K[0]) * M[0]
    M[1] = M[1] - K[1] * M[0]
    return M


MYSTERY = heard(
    {
        r"\br */ *q\b": "R/Q is one number for two. Name one of the four faults: Q or R, too small or too large.",
        r"(gain|ratio|\bk\b|\bq */ *r\b)[^,;]*(small|low)": "With a gain (a ratio Q/R) too small, neighbours would be alike, with a "
        "plus sign; here it is −0.078, so the gain is too large. And name one of the four faults.",
        r"(gain|ratio|\bk\b|\bq */ *r\b)[^,;]*(large|high|big)": "The minus sign says that the gain (the ratio Q/R) is too large. "
        "Which makes it so, Q or R? Whether NIS is below or above 2 decides.",
        r"^(?!.*small.*large|.*large.*small).*\bboth\b": "With Q and R wrong by the same factor the gain is right, and neighbours are white. "
        "−0.078 is far outside ±0.005.",
        r"^(right|ok|honest|nothing|none|neither|correct)$": "1.85 is not near 2 here: with so many readings chance allows "
        "1.986 to 2.014 only.",
    }
)
KNOB = heard({r"^9(\.0)?\b": "9 is by how much. Asked is what is to be multiplied by it: answer with a letter."})

WRONG = {
    "three_readings": {"by ten": (18.9, "18.9 is 189/10. Here there are three readings.")},
    "update_mean": {
        "z alone divided": (
            lambda mean, n, z: (n - 1) * mean + z / n,
            "Only z is divided by n. Put brackets around the whole sum: ((n − 1)·mean + z)/n.",
        ),
    },
    "root_mean_square": {
        "0.1/0.08 of the published": (lambda error: np.mean(abs(error)) * 0.1 / 0.08, SCALED),
        "a bell's factor": (lambda error: np.mean(abs(error)) * np.sqrt(np.pi / 2), SCALED),
        "by 0.8": (lambda error: np.mean(abs(error)) / 0.798, SCALED),
    },
    "motion": {
        "dt/2m in the first rows": (
            lambda dt, mass, c: (
                dragged(dt, c * dt / (2 * mass), c * dt / mass),
                column(dt / (2 * mass), dt / mass),
            ),
            TWO_ROWS,
        ),
    },
    "three_sensors": {
        "the lesson's readings": ([60, 6000, 36], READINGS),
        "an hour of sixty seconds": (
            [[1, 0], [100, 0], [0, 0.06]],
            "An hour has 3,600 s, not 60: 1 m/s is 3,600 m in an hour, which is 3.6 km/h.",
        ),
        "the identity": (
            [[1, 0], [0, 1], [0, 0]],
            "Rows two and three are wrong: the tape in centimetres reads the position, the speedometer the velocity.",
        ),
    },
    "overwritten": {
        "velocity twice": (
            lambda F, x: np.array([F[0] @ x, (F[1, 0] + F[1, 1]) * x[1]]),
            "In your second line F[1, 0] is multiplied by the velocity. It belongs to the old position.",
        ),
        "position twice": (
            lambda F, x: np.array([(F[0, 0] + F[0, 1]) * x[0], F[1] @ x]),
            "In your first line F[0, 1] is multiplied by the position. It belongs to the old velocity.",
        ),
        "two steps": (lambda F, x: F @ F @ x, "That is F F x, two steps. Multiply by F once."),
    },
    "predicted_covariance": {
        "the lesson's, with an uncertain speed": (
            [[14, 9], [9, 9]],
            "That is the lesson's P⁻. Here dt, P and Q are others: calculate F P Fᵀ + Q anew.",
        ),
    },
    "speedometer": {
        "the lesson's estimate": (
            61.6667,
            "61.67 m is the lesson's estimate, with the tape. Here a speedometer reads, and P⁻ is another.",
        ),
    },
    "readings_needed": {
        "2σ": (45, "With 45 readings 2σ is below 0.3 m. σ itself was asked for."),
    },
    "which_knob": {", ".join(sorted(letters)): (set(letters), words) for letters, words in KNOBS.items()}
    | {"all": (set("ABCDE"), ALL_KNOBS), "all but P₀": (set("ABCD"), ALL_KNOBS)},
    "interval": {
        "79 seconds": (
            lambda: chi_square_interval(2, 79),
            "79 is the number of seconds of the ship's voyage. Here the average is over 50 runs.",
        ),
    },
    "mystery": {" or ".join(pair): (set(pair), words) for pair, words in MYSTERIES.items()}
    | {
        "all four": (
            set(SUSPECTS),
            "The sign of the neighbours rules out two of the four, and NIS one of the other two.",
        )
    },
    "draw_start": {
        "mean stretched": (
            lambda mean, variances, normal: mean * (1 + np.sqrt(variances) * normal),
            "You stretch the mean by the scatter. The scatter is added to the mean: √variance times the random number.",
        ),
        "mean stretched, variance": (
            lambda mean, variances, normal: mean * (1 + variances * normal),
            "You stretch the mean by the scatter, and by the variance. Add √variance times the random number to the mean.",
        ),
    },
    "offset": {
        f"old offset kept, {steps} steps": (
            grown(steps),
            "The correction reduces the old offset too: off = (1 − K)·(off + dt·x₁). Else it grows for ever.",
        )
        for steps in itertools.chain(range(2, 21), (30, 40, 50, 80, 100, 150, 200, 250, 300, 400, 500, 1000, 2000, 5000, 10000))
    },
    "right_update": {
        "first row too early": (
            row_by_row,
            "Your second row takes the first row when that is already changed. It needs the old one, P[0].",
        ),
    },
    "is_a_covariance": {
        "one matrix": (
            lambda P: not np.allclose(P, [[1.03, 0.7], [0.02, 0.51]]),
            "You look for one matrix. Ask of any P: is it symmetric, and is every eigenvalue 0 or more?",
            r"\(P, *(np\.array\()?[\[(]{2}|P *== *(np\.array\()?[\[(]{2}",
        ),
    },
}  # fmt: skip
