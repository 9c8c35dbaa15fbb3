"""Wrong answers to exercises of lesson 3, each with the sentence that it gets."""

import itertools

import numpy as np

F, P, Q = np.array([[1.0, 2.0], [0.0, 1.0]]), np.array([[2.0, 1.0], [1.0, 3.0]]), np.diag([4.0, 1.0])


def correction(gain, x, P, z, H, sign=1.0):
    """The lines (8) and (9) with a given gain."""
    return x + sign * gain @ (z - H @ x), P - gain @ H @ P


def gain_of(P, H, R):
    """Line (7)."""
    return P @ H.T @ np.linalg.inv(H @ P @ H.T + R)


def ends_at(letters):
    """Where the step ends with these mistakes, in metres."""
    H = np.array([[1.0, 1.0 if "A" in letters else 0.0]])
    P = np.diag([1.0 if "B" in letters else 5.0, 0.0])
    x, sign = np.array([60.0, 1.0 if "C" in letters else 10.0]), -1.0 if "D" in letters else 1.0
    return float(x[0] + sign * (gain_of(P, H, np.eye(1)) @ (62 - H @ x))[0])


REMARKS = {
    "A": "The tape was expected to read 60 + 10 = 70. For 60.5 m gain and innovation must both be others: it takes more mistakes.",
    "B": "That is one of the readers' answers. The gain is 1/2, but the innovation is still 2 m.",
    "C": "A wrong velocity alone does no harm, as H = [1, 0] does not ask for it: the step is right.",
    "D": "The correction goes away from the tape.",
    "AB": "That is the other answer of the readers: the tape was expected to read 60 + 10 = 70. One more mistake is needed.",
    "AC": "The innovation is right for 60.5 m, but with Q the gain is 5/6. Which gain is needed?",
    "AD": "With A alone the innovation is 62 − 70 = −8 m. The wrong sign turns that into a step upwards, but of 8 m times the gain: only 0.5 m is wanted.",
    "ABD": "The gain is 1/2, as for 60.5 m. But the innovation is 62 − 70 = −8 m, and the wrong sign turns it into a step of 4 m: only 0.5 m is wanted.",
    "BC": "H = [1, 0] never looks at the velocity, so the wrong velocity changes nothing.",
}


def other_letters():
    """Every set of letters but the right one, with where it ends."""
    for letters in ("".join(c) for size in (1, 2, 3, 4) for c in itertools.combinations("ABCD", size)):
        remark = REMARKS.get(letters, "With the wrong sign the correction goes down from 60 m, and 60.5 m is above it.")
        if letters != "ABC":
            alone = "alone ends" if len(letters) == 1 else "together end"
            yield letters, f"{' and '.join(letters)} {alone} at {ends_at(letters):.2f} m. {remark}"


def step(x_pred, P_pred, z, H, R, begin=None):
    """A correction of a prediction; as printed it begins its walk elsewhere."""
    K = gain_of(P_pred, H, R)
    return (x_pred if begin is None else begin) + K @ (z - H @ x_pred), P_pred - K @ H @ P_pred


WRONG = {
    "predicted_covariance": {
        "forgot Q": (
            lambda: F @ P @ F.T,
            "That is F P Fᵀ, the old covariance, moved. The bumps of this step are missing: add Q.",
        ),
        "F P F": (
            lambda: F @ P @ F + Q,
            "That is F P F + Q. The right-hand F must be Fᵀ, or the result is not even symmetric.",
        ),
        "F P F without Q": (
            lambda: F @ P @ F,
            "Two faults: the right-hand F must be Fᵀ (a covariance is symmetric, yours is not), and Q is missing.",
        ),
        "P F P": (
            lambda: P @ F @ P + Q,
            "That is P F P + Q, in m⁴. It is the other way round: P stands between F and Fᵀ.",
        ),
        "P F P without Q": (
            lambda: P @ F @ P,
            "That is the published misprint, P F P: its unit would be m⁴ for the position. Write F P Fᵀ, and add Q.",
        ),
        "Fᵀ P F": (
            lambda: F.T @ P @ F + Q,
            "That is Fᵀ P F + Q. The errors become F e, with dt at the upper right of F: F stands on the left and Fᵀ on the right.",
        ),
        "F P": (
            lambda: F @ P + Q,
            "That is F P + Q. The error stands twice in a covariance, and both must be moved: multiply by Fᵀ on the right.",
        ),
        "P + Q": (
            lambda: P + Q,
            "That is P + Q, and the old covariance is not moved: in 2 s an uncertain velocity makes the position uncertain.",
        ),
        "entry by entry": (
            lambda: F * P * F.T + Q,
            "Two ways lead to it: P + Q without the corner of P, or `*` in F P Fᵀ, which multiplies entry by entry in NumPy. F P Fᵀ is a product of matrices, made with `@`.",
        ),
        "diagonal only": (
            lambda: np.diag(np.diag(F @ P @ F.T + Q)),
            "The diagonal is right. But the errors of position and velocity now belong together: the corners are not 0.",
        ),
        "minus Q": (
            lambda: F @ P @ F.T - Q,
            "That is F P Fᵀ − Q. Bumps make the belief wider: add Q.",
        ),
        "Q taken for σ": (
            lambda: F @ P @ F.T + Q @ Q,
            "In the upper left stands 18 + 16, the square of 4. Q holds variances already; add it as it is.",
        ),
        "dt = 1": (
            lambda: [[11, 4], [4, 4]],
            "That is the result for dt = 1 s, as in the lesson. Here dt is 2 s, so F = [[1, 2], [0, 1]].",
        ),
        "Q in the corners": (
            lambda: F @ P @ F.T + [[4, 1], [1, 1]],
            "diag(4, 1) has zeros in the corners: Q is added on the diagonal only.",
        ),
        "dt = 1 for the corner": (
            lambda: F @ P @ F.T + np.diag([1.0, 4.0]),
            "Q is upside down: diag(4, 1) has 4 for the position and 1 for the velocity.",
        ),
        "Q as a row": (
            lambda: F @ P @ F.T + np.array([4, 1]),
            "Here [4, 1] is added to each row. diag(4, 1) is a matrix with 4 and 1 on the diagonal and zeros in the corners: np.diag([4, 1]).",
        ),
        "Q times dt": (
            lambda: F @ P @ F.T + 2 * Q,
            "That is F P Fᵀ + dt·Q. Q is given for this step: add it as it is.",
        ),
        "Q times dt²": (
            lambda: F @ P @ F.T + 4 * Q,
            "That is F P Fᵀ + dt²·Q. Q is given for this step: add it as it is.",
        ),
        "P Fᵀ": (
            lambda: P @ F.T + Q,
            "That is P Fᵀ + Q, without the F on the left. The error stands twice in a covariance, and both must be moved: F P Fᵀ.",
        ),
        "F(P + Q)Fᵀ": (
            lambda: F @ (P + Q) @ F.T,
            "That is F(P + Q)Fᵀ, with Q moved as well. Q belongs to this step: first F P Fᵀ, then add Q.",
        ),
        "Q for the position only": (
            lambda: F @ P @ F.T + np.diag([4.0, 0.0]),
            "Q is added for the position only. The velocity has an entry in Q too: 1 at the lower right.",
        ),
    },
}
