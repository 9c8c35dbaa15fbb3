"""Lesson 29: take it to your library."""

import itertools

import numpy as np

from kflearn.exercises._slips import take_it_home as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise


def half_readings():
    """Inputs for a correction: two or three numbers, of which some, none or all are missing; their errors have something in common."""
    gaps = itertools.cycle(([False, True], [True, False, False], [False, False], [True, True], [False, True, True]))

    def make(rng, n):
        missing = np.array(next(gaps))
        m = len(missing)
        root, noise = rng.integers(-2, 3, (n, n)) / 2, rng.integers(-2, 3, (m, m)) / 2
        z = np.where(missing, np.nan, rng.integers(-9, 10, m) / 2)
        H = rng.integers(-2, 3, (m, n)) + 0.5
        return rng.integers(-9, 10, n) / 2, root @ root.T + np.eye(n), z, H, noise @ noise.T + np.eye(m)

    return in_turn(make, 2, 3)


@exercise(
    hints=[
        "Between your start and the first reading lies one step. What does a filter do with a covariance in one step, before it sees a reading?",
        "It is one prediction, eq (6): F P Fᵀ + Q. Begin with F P, then multiply by the transpose of F.",
        "F P = [[4, 2], [0, 1]]. Times Fᵀ = [[1, 0], [2, 1]], and then Q is added: what becomes of the lower right entry?",
        "In NumPy: `np.array([[1, 2], [0, 1]]) @ np.diag([4, 1]) @ np.array([[1, 0], [2, 1]]) + np.diag([0, 1])`",
    ],
    wrong=slips.start_covariance.WRONG,
    then="With `to_first_reading(model, initial)` it is one call. Hand over the mean as well: it moves to F x, and by B u if there is a control input.",
)
def start_covariance():
    """Which covariance belongs to the time of the first reading?"""
    F, P, Q = np.array([[1, 2], [0, 1]]), np.diag([4, 1]), np.diag([0, 1])
    return F @ P @ F.T + Q


@exercise(
    hints=[
        "The density of one number with a variance S is exp(−½ y²/S) / √(2πS). Which constant stands in its logarithm, and what is its sign?",
        "Each number that was used has −½ log 2π = −0.919 in it. How many numbers were used, if both libraries drop the half readings?",
        "50 rows less 6 gaps and less 4 half readings, with two numbers each.",
        "`-31.40 - 80 / 2 * np.log(2 * np.pi)`",
    ],
    wrong=slips.with_the_constant.WRONG,
    then="A library that uses the half readings as well gives yet another number, and no constant leads to it: these are other data.",
)
def with_the_constant():
    """Which log L has log 2π in it?"""
    numbers = (50 - 6 - 4) * 2
    return -31.40 - numbers / 2 * np.log(2 * np.pi)


@exercise(
    hints=[
        "A reading of which only the second number is there is a whole reading of a smaller sensor. Which row of H and which entry of R belong to that sensor?",
        "`seen = ~np.isnan(z)` says which numbers are there. Then z[seen] and H[seen] are those of the smaller sensor.",
        "R needs rows and columns: `R[np.ix_(seen, seen)]`, or `R[seen][:, seen]`. Where nothing is seen, return x and P.",
        "With `H, R = H[seen], R[np.ix_(seen, seen)]` it is the usual correction: `K = P @ H.T @ inv(H @ P @ H.T + R)`, then `x + K @ (z[seen] - H @ x)` and `P - K @ H @ P`.",
    ],
    inputs=half_readings(),
    wrong=slips.use_what_is_there.WRONG,
    then="This holds for every R. Rows of zeros in H beside a whole R, and one number after another, need a diagonal R.",
)
def use_what_is_there(x, P, z, H, R):
    """Correct a belief x (n,), P (n, n) with the numbers of z (m,) that are not NaN."""
    seen = ~np.isnan(z)
    H, R = H[seen], R[np.ix_(seen, seen)]
    K = np.linalg.solve(H @ P @ H.T + R, H @ P).T
    return x + K @ (z[seen] - H @ x), P - K @ H @ P


@exercise(
    hints=[
        "The lesson says how its own start is made: 25 times the sum of the diagonal of H, times I. Which entries of a matrix with one row and two columns are on its diagonal?",
        "Of [[h₁, h₂]] only h₁ is on the diagonal; of two rows it is the first number of the first and the second of the second. Write the five sums down.",
        "By experiment: `simdkalman.KalmanFilter(np.eye(2), np.eye(2), H, np.eye(len(H)))`, then `compute` one row of NaN, `np.full((1, 1, len(H)), np.nan)`, with `filtered=True` and look at `filtered.states.cov`.",
        "The sums are 1, 0, 2, −1 and 0, for A to E.",
    ],
    wrong=slips.own_start.WRONG,
    then="With 0 the filter is sure of a state that nobody told it, and with −25 its first estimate goes beyond what the reading says (R below 25) or to the other side (R above 25). Give a start of your own, always.",
)
def own_start():
    """For which sensors does the library's own start have a variance of zero or below?"""
    return {"B", "D", "E"}
