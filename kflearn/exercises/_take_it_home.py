"""Wrong answers to exercises of lesson 29, each with the sentence that it gets."""

import itertools

import numpy as np

from kflearn.exercises._turns import in_turn

FINE = {
    "A": "A has 1 on its diagonal, so its own start has the variance 25: large or small, but a variance.",
    "C": "C has 1 and 1 on its diagonal, so its own start has the variance 50, as in the lesson.",
}
UNUSABLE = {
    "B": "B is missing: it is the sensor of the experiment above, whose estimate begins at 0.00 and stays near it.",
    "D": "D is missing: a sensor with the opposite sign has −1 on its diagonal. What is 25 times that?",
    "E": "E is missing: it sees both states, but in the other order. Which numbers are on its diagonal?",
}


def wrong_sensors():
    """Every choice of sensors but the right one, with what to say: first what is too much, then what is missing."""
    for letters in (set(c) for size in range(1, 6) for c in itertools.combinations("ABCDE", size)):
        too_many = [text for letter, text in FINE.items() if letter in letters]
        missing = [text for letter, text in UNUSABLE.items() if letter not in letters]
        if too_many or missing:
            yield letters, " ".join(too_many) or missing[0]


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


def corrected(x, P, z, H, R, sign=1):
    """The usual correction; what is NaN stays NaN."""
    K = np.linalg.solve(H @ P @ H.T + R, H @ P).T
    return x + sign * K @ (z - H @ x), P - K @ H @ P


def part(z, H, R):
    """The smaller sensor of the numbers that are there."""
    seen = ~np.isnan(z)
    return z[seen], H[seen], R[np.ix_(seen, seen)]


def dropped(x, P, z, H, R):
    return (x, P) if np.isnan(z).any() else corrected(x, P, z, H, R)


def expected_for_nan(x, P, z, H, R):
    return corrected(x, P, np.where(np.isnan(z), H @ x, z), H, R)


def zeros_for_nan(x, P, z, H, R):
    return corrected(x, P, np.nan_to_num(z), H, R)


def rows_of_zeros(x, P, z, H, R):
    seen = ~np.isnan(z)
    return corrected(x, P, np.where(seen, z, 0), seen[:, None] * H, R)


def one_by_one(x, P, z, H, R):
    for i in np.flatnonzero(~np.isnan(z)):
        x, P = corrected(x, P, z[i : i + 1], H[i : i + 1], R[i : i + 1, i : i + 1])
    return x, P


def first_entries(x, P, z, H, R):
    """R cut at its corner, whatever is missing."""
    seen, H, _ = part(z, H, R)
    return corrected(x, P, seen, H, R[: len(seen), : len(seen)])


def with_S(x, P, z, H, S):
    K = P @ H.T @ np.linalg.inv(S)
    return x + K @ (z - H @ x), P - K @ H @ P


def diagonal_of_R(x, P, z, H, R):
    """R as a vector, which NumPy adds to every row of S."""
    seen = ~np.isnan(z)
    return with_S(x, P, z[seen], H[seen], H[seen] @ P @ H[seen].T + R[seen, seen])


def diagonal_of_R_solved(x, P, z, H, R):
    """The same where the gain is `solve(S, H @ P).T`, which takes S for symmetric."""
    seen = ~np.isnan(z)
    return with_S(x, P, z[seen], H[seen], (H[seen] @ P @ H[seen].T + R[seen, seen]).T)


def without_R(x, P, z, H, R):
    seen, H, R = part(z, H, R)
    return corrected(x, P, seen, H, 1e-9 * R)


def old_P(x, P, z, H, R):
    return corrected(x, P, *part(z, H, R))[0], P


def wrong_sign(x, P, z, H, R):
    return corrected(x, P, *part(z, H, R), sign=-1)


def whole_P(x, P, z, H, R):
    return corrected(x, P, *part(z, H, R))[0], corrected(x, P, np.nan_to_num(z), H, R)[1]


def mean_alone(x, P, z, H, R):
    return corrected(x, P, *part(z, H, R))[0]


CONSTANT = np.log(2 * np.pi) / 2
LOG_L = -31.40
TWICE = r"\[(\w+), ?\1\]"  # one name for rows and columns, as in R[seen, seen]
VECTOR = (
    "R came in as a vector, its diagonal: that is what `R[seen, seen]` gives. The matrix is `R[np.ix_(seen, seen)]`."
)

WRONG = {
    "start_covariance": {
        "as it is": (
            [[4, 0], [0, 1]],
            "That is P one step before the first reading, as it is. The library would take it for the time of the reading: predict once.",
        ),
        "Q alone added": (
            [[4, 0], [0, 2]],
            "That is P + Q. The step also moves the state, and with it the covariance: F P Fᵀ first, with `@` (`*` multiplies entry by entry).",
        ),
        "without Q": ([[8, 2], [2, 1]], "That is F P Fᵀ. In that step the state is disturbed as well: Q is missing."),
        "F on one side": (
            [[4, 2], [0, 2]],
            "That is F P + Q, and it is not symmetric. F stands on both sides: F P Fᵀ.",
        ),
        "transposes exchanged": (
            [[4, 8], [8, 18]],
            "That is Fᵀ P F + Q: the transpose belongs to the right. A speed must widen the position, not the other way round.",
        ),
        "diagonal alone": (
            [[8, 0], [0, 2]],
            "The variances are right. The covariance beside them is missing: after the step position and velocity err together.",
        ),
        "no transpose": (
            [[4, 10], [0, 2]],
            "That is F P F + Q, which is not symmetric. The second F is transposed: F P Fᵀ.",
        ),
        "two steps": (
            [[24, 6], [6, 3]],
            "You predicted twice. There is one step between your start and the first reading.",
        ),
        "backwards": (
            [[8, -2], [-2, 2]],
            "That is F⁻¹ P F⁻ᵀ + Q, with a step back: its covariance is negative. The first reading comes later than your start.",
        ),
        "Q first": (
            [[12, 4], [4, 2]],
            "You added Q before the step, F (P + Q) Fᵀ. In this course Q is what one step adds: F P Fᵀ + Q.",
        ),
        "Q taken off": ([[8, 2], [2, 0]], "You took Q off. A disturbance makes a belief less certain: + Q."),
    },
    "with_the_constant": {
        "added": (
            LOG_L + 80 * CONSTANT,
            "The size is right, the sign is not. 1/√(2π) is smaller than 1, so its logarithm is negative and log L becomes smaller.",
        ),
        "all rows": (
            LOG_L - 100 * CONSTANT,
            "You counted all 50 rows. Where nothing was used, there is no density and no constant: leave the gaps and the half readings out.",
        ),
        "half readings counted": (
            LOG_L - 84 * CONSTANT,
            "You counted the 4 half readings with one number each. simdkalman and the other library drop them.",
        ),
        "half readings counted whole": (
            LOG_L - 88 * CONSTANT,
            "That is right for 88 numbers, with the 4 half readings counted whole: simdkalman drops the whole row, so they count as gaps.",
        ),
        "gaps counted": (
            LOG_L - 92 * CONSTANT,
            "You left the 4 half readings out, but not the 6 rows in which nothing was read.",
        ),
        "one a row": (
            LOG_L - 40 * CONSTANT,
            "That is 40 times ½ log 2π off, one for each whole row. Each row has two numbers, and each of them its own ½ log 2π.",
        ),
        "one a row, of all rows": (
            LOG_L - 50 * CONSTANT,
            "That is 50 times ½ log 2π off, one for each of the 50 rows. Each number that was used has its own: two in a whole row, none in a gap or a half reading.",
        ),
        "one a row, half readings counted": (
            LOG_L - 44 * CONSTANT,
            "You took ½ log 2π once for each of 44 rows. Each row has two numbers, and the 4 half readings are dropped: count the numbers of the other rows.",
        ),
        "one off in ten rows": (
            LOG_L - 90 * CONSTANT,
            "You left out one number in each of the ten rows that are not whole. Nothing of them was used: leave out two in each.",
        ),
        "no half": (
            LOG_L - 160 * CONSTANT,
            "You took log 2π off for each number. It is ½ log 2π: the density has the root of 2π.",
        ),
        "decimal logarithm": (
            LOG_L - 40 * np.log10(2 * np.pi),
            "That is the decimal logarithm. log L has natural ones, `np.log`.",
        ),
        "log π": (LOG_L - 40 * np.log(np.pi), "You took log π. In the density stands 2π."),
        "unchanged": (LOG_L, "That is simdkalman's own number, which has no log 2π in it."),
        "constant alone": (-80 * CONSTANT, "That is what has to be added to −31.40: the constant alone."),
    },
    "use_what_is_there": {
        "row dropped": (
            dropped,
            "If one number is missing, you use none of the others. That is what the library does already; use the numbers that are there.",
        ),
        "zero for NaN": (
            zeros_for_nan,
            "You put 0 in place of NaN. To the filter that is a reading of 0, and it pulls the estimate there.",
        ),
        "expected for NaN": (
            expected_for_nan,
            "Where z is NaN your innovation is 0, as if H x had been read. P then counts it as read and becomes too small, and the mean is pulled towards H x.",
        ),
        "rows of zeros": (
            rows_of_zeros,
            "A row of zeros is right if R is diagonal. Here the errors of the numbers have something in common, so the 0 still changes the weights of the others: leave its row and column of R out.",
        ),
        "one by one": (
            one_by_one,
            "That is right if R is diagonal, as one number after another is. Here the errors have something in common, and the entries of R beside the diagonal are not used.",
        ),
        "corner of R": (
            first_entries,
            "You cut the first rows and columns out of R, whichever number is missing. Take those of the numbers that are there.",
        ),
        "diagonal of R": (diagonal_of_R, VECTOR, TWICE),
        "diagonal of R, solved": (diagonal_of_R_solved, VECTOR, TWICE),
        "NaN kept": (
            corrected,
            "That is the usual correction: one NaN in z makes the whole mean NaN. Use only the rows of z and H, and the rows and columns of R, of the numbers that are there.",
        ),
        "without R": (
            without_R,
            "R is missing in S = H P Hᵀ + R: such a filter believes each reading without a doubt.",
        ),
        "old P": (old_P, "The mean is right. P is still the one before the reading: P − K H P."),
        "P of a whole reading": (
            whole_P,
            "The mean is right. In P the numbers that are missing count as read, as in FilterPy told NaN: use the same rows of H and R for both.",
        ),
        "nothing corrected": (
            lambda x, P, z, H, R: (x, P),
            "You return the belief as it came in, also where numbers were read. Correct with the numbers that are there.",
        ),
        "wrong sign": (
            wrong_sign,
            "The innovation has the wrong sign: it is what was read less what was expected, z − H x.",
        ),
        "mean alone": (mean_alone, "That is the corrected mean alone. Return the covariance with it: `return x, P`."),
    },
}
