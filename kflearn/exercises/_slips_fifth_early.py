"""Wrong answers to exercises of lessons 3 to 14 that a fifth group of strangers gave, and more of their kind."""

from itertools import combinations

import numpy as np

from kflearn.exercises._cart_on_a_rail import line, off
from kflearn.exercises._linearised_and_extended import radar_slope

LETTERS = {
    "A": "A changes the ratio, and so the estimate.",
    "B": "B changes the ratio, and so the estimate.",
    "D": "D makes the band narrower, and it is too narrow already.",
    "E": "E has no lasting effect: P₀ is forgotten after a few readings.",
}
KNOWN = [*map(tuple, ("AB", "AC", "BC", "CD", "CE", "ABC", "ABCD"))]  # these have sentences of their own already
RAMP = (
    "You take dt·x₁ away from x₁, as if the speaker walked by x₁ in each step. Here the speaker stays where they are, and "
    "each step pushes by dt·x₁ alone."
)
NO_LOG = "That is a logarithm of √orders. `orders` counts powers of ten already, so no logarithm is needed: a root halves it."
BOTH_PLACES = "The term 2K(1 − K)c changes both: c is taken away on top, and 2c below the line."


def too_many(letters):
    """What is said of several letters where C alone is right."""
    first = "C is enough." if "C" in letters else "One letter is enough, and it is none of these."
    return " ".join([first, *(LETTERS[letter] for letter in letters if letter != "C")])


def rail_with_two_slopes(x, P, reading, nominal):
    """The right estimate; P is made smaller with the slope at x in I − K H, beside the right gain."""
    H, beside = nominal / off(nominal), x / off(x)
    return line(x, P, reading, nominal)[0], (1 - P * H / (H * P * H + 4) * beside) * P


def speeds_exchanged(x):
    """The claimed slope, with the slopes for the speeds exchanged as well."""
    slope = radar_slope(x)
    slope[1] = slope[1, [0, 3, 2, 1]] * [1, 1, -1, 1]
    return slope


def on_a_grid(results, rights):
    """What is said of gains that are steps of a grid, the nearest to the right ones between 0 and 1."""
    for count in range(2, 2001):
        steps = results * count
        if np.allclose(steps, np.round(steps), rtol=0, atol=1e-7):
            if np.all(abs(results - np.clip(rights, 0, 1)) <= 1.001 / count):
                return (
                    f"Your gains are multiples of {1 / count:.4g} between 0 and 1, as on a grid. The lowest point of the parabola "
                    "lies between them, or beyond 0 and 1: solve slope = 0 for K."
                )
            return None
    return None


def shut(results, rights):
    """What is said of the same step in all trials, later than all that are right."""
    if np.ptp(results) or not results[0] > rights.max():
        return None
    return (
        f"Your result is {results[0]:.6g} in every trial: a number that is typed in, or the end of a loop in which the gate never "
        "opens. A refused reading does not make P smaller: P grows by Q in each step, and S with it."
    )


def start_of(result, case):
    """The estimate and the variance from which the room's filter comes to a result."""
    (x, P), (z, Q, R) = result, case
    for reading in z[:0:-1]:
        K = P / R
        x, P = (x - K * reading) / (1 - K), P / (1 - K) - Q
    return x, P


def of_a_start(results, cases):
    """What is said of a filter of the room that is right, but for a start that is the same in all trials."""
    short = [(result, case) for result, case in zip(results, cases, strict=True) if len(case[0]) < 5]
    with np.errstate(all="ignore"):
        x, P = np.array([start_of(*pair) for pair in short]).T
    first = np.array([case[0][0] for _, case in short])
    typed = [np.isfinite(part).all() and np.ptp(part) < 1e-6 * (1 + abs(part[0])) for part in (x, P)]
    if typed[0]:
        with_P = f", with P = {P[0]:.4g}" if typed[1] else ""
        return f"Your filter starts at {x[0]:.4g} °C{with_P}, whatever z is. The first reading is the start: x = z[0], P = R."
    if typed[1] and np.allclose(x, first):
        return f"You start with P = {P[0]:.4g}, whatever R is. A single reading has the variance R."
    return None


WRONG = {
    "speedometer": {
        "moved on, and corrected": (
            73.6,
            "73.6 is 10 m too far. 60 m is the prediction already: the cart is not moved on by 10 m/s once more.",
        ),
        "moved on, not corrected": (
            70,
            "70 is 60 + 10, one more second at the speed of before. x̂⁻ is predicted already: only the correction is wanted.",
        ),
    },
    "readings_needed": {
        "σ that is reached": (
            lambda: np.sqrt(1 / 11.2),
            "0.299 m is a σ, and it is below 0.3 m. Asked is how many readings reach it.",
        ),
        "variance that is reached": (
            lambda: 1 / 11.2,
            "0.0893 m² is a variance, and it is below 0.09 m². Asked is how many readings reach it.",
        ),
        "precision that is reached": (
            11.2,
            "11.2 is a precision, in 1/m², and it is above 1/0.09. Asked is how many readings reach it.",
        ),
    },
    "common_cause": {
        "c below": (lambda P, R, c: P / (P + R + c), f"That is (12) with c added below the line. {BOTH_PLACES}"),
        "c off below": (
            lambda P, R, c: P / (P + R - c),
            f"That is (12) with c taken away below the line. {BOTH_PLACES}",
        ),
        "c in both": (
            lambda P, R, c: (P + c) / (P + R + c),
            f"That is (12) with c added in both places. {BOTH_PLACES}",
        ),
        "c below, taken away on top": (
            lambda P, R, c: (P - c) / (P + R + c),
            "On top is right. Below the line 2c is taken away, and not c added.",
        ),
    },
    "is_unknown": {
        "some, not all": (
            lambda x: bool(np.isnan(x).any() and not np.isnan(x).all()),
            "A state of which all entries are unknown is left out. There too at least one is unknown: any() alone is enough.",
        ),
    },
    "which_knob": {
        ", ".join(letters): (set(letters), too_many(letters))
        for size in (2, 3, 4)
        for letters in combinations("ABCDE", size)
        if letters not in KNOWN
    },
    "offset": {
        "as on a ramp": (lambda x1, K, dt: (x1 - dt * x1) * (1 - K) / K, RAMP),
        "as on a ramp, the other sign": (lambda x1, K, dt: (dt * x1 - x1) * (1 - K) / K, RAMP),
        "as on a ramp, before the correction": (lambda x1, K, dt: (x1 - dt * x1) / K, RAMP),
    },
    "orders_of_the_root": {
        "logarithm of the root": (lambda orders: np.log10(np.sqrt(orders)), NO_LOG),
        "natural logarithm of the root": (lambda orders: np.log(np.sqrt(orders)), NO_LOG),
        "logarithm by 2 of the root": (lambda orders: np.log2(np.sqrt(orders)), NO_LOG),
    },
    "mended_slope": {
        "speeds exchanged, sign as claimed": (
            speeds_exchanged,
            "The slopes for the two speeds, x/r and y/r, have changed places, and they were right. The wrong sign is still "
            "there: it is in one of the two entries with `turn`.",
        ),
    },
    "linearised_correction": {
        "two slopes": (
            rail_with_two_slopes,
            "Your x is right. In 1 − K·H, which makes P smaller, the H is the slope at x: take the nominal's, which is in the gain.",
        ),
    },
    "mended_prediction": {
        "u for 25": (
            lambda x, P, u: (x / 2 + 25 * x / (1 + x**2) + u, (0.5 + u * (1 - x**2) / (1 + x**2) ** 2) ** 2 * P + 10),
            "The mean is right. In your slope u stands where 25 belongs: the second argument of `move_slope` is c, not u. "
            "Call `move_slope(x)`.",
        ),
    },
    "both_humps": {
        "of the picture": (
            (4.4, 9.9),
            "The mean is right. 9.9 is the σ of the belief in the opening picture, which is another belief. Work it out for "
            "N(11, 1) and N(−11, 1).",
        ),
    },
}
