"""Lesson 5: the voltmeter."""

import math

import numpy as np

from kflearn.exercises import _voltmeter_judge as judge
from kflearn.exercises._hints import is_about
from kflearn.exercises._judge import Mark
from kflearn.exercises._slips import voltmeter as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise, judged


@exercise(
    hints=[
        lambda last: (
            "Your prediction has 2 V². Which line of the loop comes before the gain?"
            if is_about(last, 2 / 11)
            else "Two lines of the loop come before x is touched: P grows by Q, then K is formed."
        ),
        "Before the second reading P has grown from 2 to 2 + Q.",
        "K = 5 / (5 + 9).",
    ],
    wrong=slips.second_gain.WRONG,
    otherwise=lambda K: (
        f"A gain of {K:.3g} would need P⁻ = {9 * K / (1 - K):.3g} V² beside R = 9 V². What is P⁻ before the second reading?"
        if 0 < K < 1
        else "A gain lies between 0 and 1: it is a part of the sum P⁻ + R."
    ),
    then="The next gains are 0.408, 0.426 and 0.432: a few readings later the gain has settled at 0.434, whatever the readings were.",
)
def second_gain():
    """The gain for the second reading, with P = 2 V² after the first, Q = 3 V² and R = 9 V²."""
    before = 2 + 3
    return before / (before + 9)


def noises(rng):
    """A pair Q, R over two decades, with three digits."""
    return float(f"{10 ** rng.uniform(-1, 1):.3g}"), float(f"{10 ** rng.uniform(-1, 1):.3g}")


@exercise(
    hints=[
        "After the correction P = K·R (why? P = (1 − K)P⁻, and K = P⁻/(P⁻ + R)). So P⁻ = K·R + Q.",
        "Put it into K = P⁻/(P⁻ + R) and write q = Q/R: K² + qK − q = 0.",
        "K = (√(q² + 4q) − q) / 2; or simply `P = R`, then a hundred times `P = (P + Q) * R / (P + Q + R)`.",
    ],
    inputs=noises,
    rtol=5e-4,  # for a recursion of a hundred steps, or one that stops when the gain rests
    wrong=slips.steady_gain.WRONG,
    then="For a small q the gain is nearly √q: with Q a hundred times smaller than R it is 0.095.",
)
def steady_gain(Q, R):
    """The gain at which growth by Q and cut by the reading balance."""
    q = Q / R
    return (math.sqrt(q**2 + 4 * q) - q) / 2


def starts(rng, n):
    """A state of n numbers, of which none, the first, the last, one in between, some or all are unknown."""
    x = rng.integers(-9, 10, n).astype(float)
    x[abs(x) < 4] = 0  # a number like any other
    where = rng.choice(["none", "first", "last", "middle", "some", "all"])
    some, middle = rng.permutation(n)[: (n + 1) // 2], [int(rng.integers(1, n - 1))] if n > 2 else []
    x[{"none": [], "first": [0], "last": [-1], "middle": middle, "some": some, "all": range(n)}[where]] = np.nan
    return (x,)


@exercise(
    hints=[
        "One unknown entry is enough to spoil everything that follows.",
        "np.isnan(x) gives one True or False for each entry; you want to know whether any of them is True.",
        "`return np.isnan(x).any()`",
    ],
    inputs=in_turn(starts, 1, 3, 2, 5),
    wrong=slips.is_unknown.WRONG,
    then="One NaN spreads at once: in F @ x each entry becomes NaN, even where F has a zero, because 0 · NaN is NaN.",
)
def is_unknown(x):
    """True if any entry of the state is unknown (NaN)."""
    return np.isnan(x).any()


def first_measurements(rng, n):
    """A measurement of n states, its H and its R, with corners."""
    noise = rng.integers(1, 5, (n, n)).astype(float)
    H = rng.integers(0, 3, (n, n)) + 5 * np.eye(n)
    return rng.integers(1, 10, n) * rng.choice([-1.0, 1.0], n), H, noise @ noise.T + np.eye(n)


@exercise(
    hints=[
        "z = Hx + v. If you knew that v = 0, what would x be?",
        "The error of x is H⁻¹v. The covariance of a matrix A times v is A R Aᵀ, here with A = H⁻¹.",
        "`A = np.linalg.inv(H)`, then `return A @ z, A @ R @ A.T`",
    ],
    inputs=in_turn(first_measurements, 1, 2, 3, 2),
    wrong=slips.auto_start.WRONG,
    then="A correction that starts from any x with a P that grows beyond all bounds tends to the same x and P: this is the start of somebody who knew nothing.",
)
def auto_start(z, H, R):
    """The state and covariance that one measurement z = Hx + v alone gives, H invertible."""
    undo = np.linalg.inv(H)
    return undo @ z, undo @ R @ undo.T


@exercise(
    hints=[
        "Two opinions about the voltage of this moment: N(12, 4) from knowing the source, and a reading with variance 4.",
        "Fuse them: K = 4 / (4 + 4), and the variance that is left is 4(1 − K).",
        "The variance that is left is 2 V²; its root is √2 V.",
    ],
    unit="V",
    rtol=1e-3,  # 1.416, which the lesson measured, is not the exact value
    wrong=slips.best_error.WRONG,
    otherwise=slips.best_error.of_best_error,
    then="The filter with its random walk is off by 1.63 V, because it also uses older readings, and in this world they say nothing about now.",
)
def best_error():
    """The root mean square error of the best answer when N(12, 4) is read with variance 4."""
    gain = 4 / (4 + 4)
    return math.sqrt(4 * (1 - gain))


@judged(
    hints=[
        "Begin with the loop of the lesson. Which four lines depend on Q and R, and what is kept after each reading?",
        "Without a reading (`np.isnan(reading)`) only the first line of the loop is done: P grows. The estimate stays, "
        "and both are kept all the same.",
        "Start with `x, P = z[0], R`. For each further reading: `P = P + Q`; if there is a reading, `K = P / (P + R)`, "
        "`x = x + K * (reading - x)`, `P = (1 - K) * P`; then append x and P.",
    ],
    recording=judge.recording,
    marks=[
        Mark("recordings that begin with z[0] and R", judge.starts, low=100, unit="%", below=judge.of_start),
        Mark("error, compared with that of the best filter", judge.error_ratio, high=1.05, above=judge.of_errors),
        Mark(
            "truth inside ±2σ where there is a reading",
            judge.inside_readings,
            low=93,
            high=97.5,
            unit="%",
            below=judge.of_variances,
            above=judge.of_variances,
        ),
        Mark(
            "truth inside ±2σ in the gaps",
            judge.inside_gaps,
            low=90,
            high=99,
            unit="%",
            below=judge.before_gaps,
            above=judge.too_wide_in_gaps,
        ),
        Mark(
            "mean of error²/P",
            judge.nees,
            low=0.85,
            high=1.15,
            below=judge.of_variances,
            above=judge.of_variances,
        ),
    ],
    form=judge.two_series,
    then="With the same two numbers Q and R it copes with gaps of any length. Where do Q and R come from, if nobody hands them over? That is lesson 6.",
    passing=judge.PASSING,
    failing=judge.FAILING,
    signs=[judge.exchanged],
)
def whole_filter(z, Q, R):
    """A whole filter: the estimates and their variances for 200 readings z, of which some are NaN, with given Q and R."""
    x, P = z[0], R
    estimates, variances = [x], [P]
    for reading in z[1:]:
        P = P + Q
        if not np.isnan(reading):
            K = P / (P + R)
            x = x + K * (reading - x)
            P = (1 - K) * P
        estimates.append(x)
        variances.append(P)
    return estimates, variances
