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
    "A": "The tape was expected to read 60 + 10 = 70.",
    "B": "That is one of the readers' answers. The gain is 1/2, but the innovation is still 2 m.",
    "C": "A wrong velocity alone does no harm, as H = [1, 0] does not ask for it: the step is right.",
    "D": "The correction goes away from the tape.",
    "AB": "That is the other answer of the readers: the tape was expected to read 60 + 10 = 70. One more mistake is needed.",
    "AC": "The innovation is right for 60.5 m, but with Q the gain is 5/6. Which gain is needed?",
    "BC": "H = [1, 0] never looks at the velocity, so the wrong velocity changes nothing.",
}


def other_letters():
    """Every set of up to three letters but the right one, with where it ends."""
    for letters in ("".join(c) for size in (1, 2, 3) for c in itertools.combinations("ABCD", size)):
        remark = REMARKS.get(letters, "With the wrong sign the correction goes the wrong way.")
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
            "That is F P Fᵀ: the old doubt, moved. The jolts of this step are missing: add Q.",
        ),
        "F P F": (
            lambda: F @ P @ F + Q,
            "You multiplied by F on both sides. The right-hand one must be Fᵀ, or the result is not even symmetric.",
        ),
        "F P F without Q": (
            lambda: F @ P @ F,
            "Two faults: the right-hand F must be Fᵀ (a covariance is symmetric, yours is not), and Q is missing.",
        ),
        "P F P": (
            lambda: P @ F @ P + Q,
            "You put F between two P. It is the other way round: P is the filling, F P Fᵀ. Variances squared have no place here.",
        ),
        "P F P without Q": (
            lambda: P @ F @ P,
            "That is the published misprint, P F P: its unit would be m⁴ for the position. Write F P Fᵀ, and add Q.",
        ),
        "Fᵀ P F": (
            lambda: F.T @ P @ F + Q,
            "The transpose is on the wrong side: the errors become F e, so F stands on the left and Fᵀ on the right.",
        ),
        "F P": (
            lambda: F @ P + Q,
            "You stopped after F P. The error stands twice in a covariance, and both must be moved: multiply by Fᵀ on the right.",
        ),
        "P + Q": (
            lambda: P + Q,
            "You added the jolts, but forgot to move the old doubt: in 2 s an unsure velocity makes the position unsure.",
        ),
        "entry by entry": (
            lambda: F * P * F.T + Q,
            "In NumPy * multiplies entry by entry; the product of matrices is @.",
        ),
        "diagonal only": (
            lambda: np.diag(np.diag(F @ P @ F.T + Q)),
            "The diagonal is right. But position and velocity now err together: the corners are not 0.",
        ),
        "minus Q": (
            lambda: F @ P @ F.T - Q,
            "You took Q away. Jolts make the belief wider, never sharper: add it.",
        ),
        "Q taken for σ": (
            lambda: F @ P @ F.T + Q @ Q,
            "You squared Q. It holds variances already; add it as it is.",
        ),
        "dt = 1": (
            lambda: [[11, 4], [4, 4]],
            "You took dt = 1, as in the lesson. Here dt is 2 s, so F = [[1, 2], [0, 1]].",
        ),
        "Q in the corners": (
            lambda: F @ P @ F.T + [[4, 1], [1, 1]],
            "diag(4, 1) has zeros in the corners: the jolts are added on the diagonal only.",
        ),
        "dt = 1 for the corner": (
            lambda: F @ P @ F.T + np.diag([1.0, 4.0]),
            "Q is upside down: diag(4, 1) has 4 for the position and 1 for the velocity.",
        ),
        "Q as a row": (
            lambda: F @ P @ F.T + np.array([4, 1]),
            "You added [4, 1] to each row. diag(4, 1) is a matrix with 4 and 1 on the diagonal and zeros in the corners: np.diag([4, 1]).",
        ),
        "Q times dt": (
            lambda: F @ P @ F.T + 2 * Q,
            "You multiplied Q by dt. It is given for this step: add it as it is.",
        ),
        "Q times dt²": (
            lambda: F @ P @ F.T + 4 * Q,
            "You multiplied Q by dt². It is given for this step: add it as it is.",
        ),
        "P Fᵀ": (
            lambda: P @ F.T + Q,
            "You left out the F on the left. The error stands twice in a covariance, and both must be moved: F P Fᵀ.",
        ),
        "F(P + Q)Fᵀ": (
            lambda: F @ (P + Q) @ F.T,
            "You added Q before the step and moved it along. It belongs to this step: first F P Fᵀ, then add Q.",
        ),
        "Q for the position only": (
            lambda: F @ P @ F.T + np.diag([4.0, 0.0]),
            "You added Q for the position only. The velocity is jolted too: 1 at the lower right.",
        ),
        "only moved the position": (
            lambda: [[16, 7], [7, 4]],
            "In the upper left you forgot a part: P₁₁ + 2·dt·P₁₂ + dt²·P₂₂ + Q₁₁, with the corner counted twice.",
        ),
    },
    "correct": {
        "H for Hᵀ in the gain": (
            lambda x, P, z, H, R: correction(P @ H @ np.linalg.inv(H @ P @ H.T + R), x, P, z, H),
            "Your gain has H where (7) has Hᵀ. With square matrices nobody complains; with H = [1, 0] the shapes would not fit.",
        ),
        "H and Hᵀ exchanged": (
            lambda x, P, z, H, R: correction(P @ H @ np.linalg.inv(H.T @ P @ H + R), x, P, z, H),
            "You exchanged H and Hᵀ in (7): the state's covariance goes through H from the left and through Hᵀ from the right, H P Hᵀ.",
        ),
        "Hᵀ everywhere": (
            lambda x, P, z, H, R: correction(gain_of(P, H.T, R), x, P, z, H.T),
            "You used Hᵀ for H throughout. H takes a state to what would be measured: H x.",
        ),
        "R forgotten": (
            lambda x, P, z, H, R: correction(gain_of(P, H, 0 * R), x, P, z, H),
            "R is missing in your gain: without it the measurement is believed as if it were exact.",
        ),
        "σ for σ²": (
            lambda x, P, z, H, R: correction(gain_of(P, H, np.sqrt(R)), x, P, z, H),
            "You took the root of R. R holds variances, and (7) wants variances.",
        ),
        "R squared": (
            lambda x, P, z, H, R: correction(gain_of(P, H, R @ R), x, P, z, H),
            "You squared R. It holds variances already.",
        ),
        "innovation backwards": (
            lambda x, P, z, H, R: correction(gain_of(P, H, R), x, P, z, H, sign=-1.0),
            "Your P is right. Your x walks away from the measurement: the innovation is measured minus expected, z − H x.",
        ),
        "innovation without H": (
            lambda x, P, z, H, R: (x + gain_of(P, H, R) @ (z - x[: len(z)]), P - gain_of(P, H, R) @ H @ P),
            "Your P is right. But you took x away from z: compare the measurement with what you expected to measure, H x.",
        ),
        "z in place of the innovation": (
            lambda x, P, z, H, R: (x + gain_of(P, H, R) @ z, P - gain_of(P, H, R) @ H @ P),
            "Your P is right. But you added K z: only what is new about z counts, z − H x.",
        ),
        "covariance not reduced": (
            lambda x, P, z, H, R: (correction(gain_of(P, H, R), x, P, z, H)[0], P),
            "Your x is right. P is still the predicted one: a measurement makes it smaller, (I − K H) P.",
        ),
        "I − K": (
            lambda x, P, z, H, R: (correction(gain_of(P, H, R), x, P, z, H)[0], P - gain_of(P, H, R) @ P),
            "Your x is right. In P you wrote I − K; K takes metres of the tape to the state, so H must come first: I − K H.",
        ),
        "I − H K": (
            lambda x, P, z, H, R: (correction(gain_of(P, H, R), x, P, z, H)[0], P - H @ gain_of(P, H, R) @ P),
            "Your x is right. In P the order matters: K H, not H K.",
        ),
        "K H P": (
            lambda x, P, z, H, R: (correction(gain_of(P, H, R), x, P, z, H)[0], gain_of(P, H, R) @ H @ P),
            "Your x is right. For P you kept the part that the measurement has removed; what remains is (I − K H) P.",
        ),
        "covariance added": (
            lambda x, P, z, H, R: (correction(gain_of(P, H, R), x, P, z, H)[0], P + gain_of(P, H, R) @ H @ P),
            "Your x is right. Your P has grown: a measurement takes doubt away, (I − K H) P with a minus.",
        ),
        "divided entry by entry": (
            lambda x, P, z, H, R: correction(P @ H.T / (H @ P @ H.T + R), x, P, z, H),
            "You divided entry by entry with /. The −1 in (7) is the inverse of a matrix: np.linalg.inv.",
        ),
        "multiplied entry by entry": (
            lambda x, P, z, H, R: correction(P * H.T @ np.linalg.inv(H * P * H.T + R), x, P, z, H),
            "In NumPy * multiplies entry by entry; the product of matrices is @.",
        ),
        "the order of the pair": (
            lambda x, P, z, H, R: correction(gain_of(P, H, R), x, P, z, H)[::-1],
            "Both are right, in the wrong order: return x first, then P.",
        ),
        "R for S": (
            lambda x, P, z, H, R: correction(P @ H.T @ np.linalg.inv(R), x, P, z, H),
            "You inverted R alone. What is inverted in (7) is the covariance of the innovation: H P Hᵀ belongs to it as well.",
        ),
        "S not inverted": (
            lambda x, P, z, H, R: correction(P @ H.T @ (H @ P @ H.T + R), x, P, z, H),
            "You multiplied by H P Hᵀ + R. The gain divides by it: the inverse is missing.",
        ),
        "no Hᵀ in the gain": (
            lambda x, P, z, H, R: correction(P @ np.linalg.inv(H @ P @ H.T + R), x, P, z, H),
            "Your gain lacks Hᵀ: (7) begins with P Hᵀ.",
        ),
        "S without H": (
            lambda x, P, z, H, R: correction(P @ H.T @ np.linalg.inv(P + R), x, P, z, H),
            "You added P and R, but P is about the state and R about the measurement. What the state's doubt does to the measurement is H P Hᵀ.",
        ),
        "only the diagonal of R": (
            lambda x, P, z, H, R: correction(gain_of(P, H, np.diag(np.diag(R))), x, P, z, H),
            "You used the diagonal of R only. The errors of two sensors may go together: take R as it is.",
        ),
        "P shrunk by K": (
            lambda x, P, z, H, R: (
                correction(gain_of(P, H, R), x, P, z, H)[0],
                P - gain_of(P, H, R) @ R @ gain_of(P, H, R).T,
            ),
            "Your x is right. In P you took away K R Kᵀ, which a reading adds. Take away K H P.",
        ),
        "I − K H alone": (
            lambda x, P, z, H, R: (correction(gain_of(P, H, R), x, P, z, H)[0], np.eye(len(x)) - gain_of(P, H, R) @ H),
            "Your x is right. For P you stopped at I − K H: multiply P by it.",
        ),
        "P(I − K H)": (
            lambda x, P, z, H, R: (
                correction(gain_of(P, H, R), x, P, z, H)[0],
                P @ (np.eye(len(x)) - gain_of(P, H, R) @ H),
            ),
            "Your x is right. In P the order is the other way round: (I − K H) stands on the left.",
        ),
        "the step alone": (
            lambda x, P, z, H, R: (gain_of(P, H, R) @ (z - H @ x), P - gain_of(P, H, R) @ H @ P),
            "Your P is right. The first result is the step alone: add it to x.",
        ),
        "half of Joseph": (
            lambda x, P, z, H, R: (
                correction(gain_of(P, H, R), x, P, z, H)[0],
                (np.eye(len(x)) - gain_of(P, H, R) @ H) @ P @ (np.eye(len(x)) - gain_of(P, H, R) @ H).T,
            ),
            "Your x is right. The form with (I − K H) on both sides needs K R Kᵀ as well; or use it once, as in (9).",
        ),
        "Hᵀ P H": (
            lambda x, P, z, H, R: correction(P @ H.T @ np.linalg.inv(H.T @ P @ H + R), x, P, z, H),
            "In your gain H and Hᵀ are exchanged inside the inverse: H P Hᵀ + R.",
        ),
        "K S taken away": (
            lambda x, P, z, H, R: (
                correction(gain_of(P, H, R), x, P, z, H)[0],
                P - gain_of(P, H, R) @ (H @ P @ H.T + R),
            ),
            "Your x is right. In P you took K S away; (9) takes K H P away.",
        ),
        "both kept": (
            lambda x, P, z, H, R: (x, P),
            "You return what came in. First the gain, then the new x and the new P.",
        ),
        "minus R": (
            lambda x, P, z, H, R: correction(P @ H.T @ np.linalg.inv(H @ P @ H.T - R), x, P, z, H),
            "You took R away from H P Hᵀ. The innovation contains both errors, so their covariances add.",
        ),
    },
}
