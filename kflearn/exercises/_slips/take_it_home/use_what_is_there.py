"""Lesson 29, `use_what_is_there`: wrong answers, each with the sentence that it gets."""

import numpy as np


def corrected(x, P, z, H, R, sign=1):
    """The usual correction; what is NaN stays NaN."""
    K = np.linalg.solve(H @ P @ H.T + R, H @ P).T
    return x + sign * K @ (z - H @ x), P - K @ H @ P


def dropped(x, P, z, H, R):
    return (x, P) if np.isnan(z).any() else corrected(x, P, z, H, R)


def zeros_for_nan(x, P, z, H, R):
    return corrected(x, P, np.nan_to_num(z), H, R)


def expected_for_nan(x, P, z, H, R):
    return corrected(x, P, np.where(np.isnan(z), H @ x, z), H, R)


def rows_of_zeros(x, P, z, H, R):
    seen = ~np.isnan(z)
    return corrected(x, P, np.where(seen, z, 0), seen[:, None] * H, R)


def one_by_one(x, P, z, H, R):
    for i in np.flatnonzero(~np.isnan(z)):
        x, P = corrected(x, P, z[i : i + 1], H[i : i + 1], R[i : i + 1, i : i + 1])
    return x, P


def part(z, H, R):
    """The smaller sensor of the numbers that are there."""
    seen = ~np.isnan(z)
    return z[seen], H[seen], R[np.ix_(seen, seen)]


def first_entries(x, P, z, H, R):
    """R cut at its corner, whatever is missing."""
    seen, H, _ = part(z, H, R)
    return corrected(x, P, seen, H, R[: len(seen), : len(seen)])


TWICE = r"\[(\w+), ?\1\]"

VECTOR = (
    "R came in as a vector, its diagonal: that is what `R[seen, seen]` gives. The matrix is `R[np.ix_(seen, seen)]`."
)


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


def whole_P(x, P, z, H, R):
    return corrected(x, P, *part(z, H, R))[0], corrected(x, P, np.nan_to_num(z), H, R)[1]


def wrong_sign(x, P, z, H, R):
    return corrected(x, P, *part(z, H, R), sign=-1)


def mean_alone(x, P, z, H, R):
    return corrected(x, P, *part(z, H, R))[0]


def cut_afterwards(x, P, z, H, R):
    """The inverse of the whole S, of which the rows and columns that are there are taken."""
    seen = ~np.isnan(z)
    if not seen.any():
        return x, P
    K = P @ H[seen].T @ np.linalg.inv(H @ P @ H.T + R)[np.ix_(seen, seen)]
    return x + K @ (z[seen] - H[seen] @ x), P - K @ H[seen] @ P


def gain_cut(x, P, z, H, R):
    """The gain of a whole reading, of which the columns of the missing numbers are left out."""
    seen = ~np.isnan(z)
    K = (P @ H.T @ np.linalg.inv(H @ P @ H.T + R))[:, seen]
    return x + K @ (z[seen] - H[seen] @ x), P - K @ H[seen] @ P


def first_number(x, P, z, H, R):
    """The number 1 in place of the identity."""
    seen = ~np.isnan(z)
    H, R, z = H[seen], R[np.ix_(seen, seen)], z[seen]
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), (1 - K @ H) @ P


WRONG = {
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
    "cut afterwards": (
        cut_afterwards,
        "That is what comes out if the whole S is inverted and its inverse is cut. This is right only where S has no corners: cut H and R "
        "first (or S), then invert.",
    ),
    "gain cut": (
        gain_cut,
        "That is the gain of a whole reading, with the columns of the missing numbers left out. The weights of the others were made for a "
        "reading that is whole: cut H and R first, then calculate S and K.",
    ),
    "1 − K H": (
        lambda x, P, z, H, R: first_number(x, P, z, H, R),
        "The mean is right. In P you subtract K H from the number 1, so every entry of 1 − K H gets a 1. I is the identity matrix: np.eye(len(x)).",
    ),
    "rows of R alone": (
        lambda x, P, z, H, R: P @ H[~np.isnan(z)].T @ np.linalg.inv(R[~np.isnan(z)]),
        "Your R keeps its rows and not its columns, so S is not square. Both go: `R[np.ix_(seen, seen)]`, or `R[seen][:, seen]`.",
        r"\bR\[[^\]:,]+\](?! *\[)",
    ),
}
