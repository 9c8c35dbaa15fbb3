"""Lesson 21, `late_row`: wrong answers, each with the sentence that it gets."""

import numpy as np


def gain_of(P, H, R):
    """The ordinary gain."""
    return P @ H.T / (H @ P @ H.T + R)


def zeroed(K, considered):
    """The gain with its row of zeros."""
    K = K.copy()
    K[considered] = 0
    return K


def correct_with(form, mean_gain=None):
    """A correction as it should be, but for its covariance: form(K with its zero row, the ordinary K, P, H, R, c)."""

    def wrong(x, P, z, H, R, considered):
        full = gain_of(P, H, R)
        K = zeroed(full, considered)
        return x + (full if mean_gain == "full" else K) @ (z - H @ x), form(K, full, P, H, R, considered)

    return wrong


def half_symmetric(K, full, P, H, R, considered):
    """(9) with the zero row, made symmetric."""
    P = (np.eye(len(P)) - K @ H) @ P
    return (P + P.T) / 2


def joseph(K, P, H, R):
    """(9J)."""
    keep = np.eye(len(P)) - K @ H
    return keep @ P @ keep.T + K @ R @ K.T


def without_cross(K, full, P, H, R, considered):
    """(9J), and then the covariances with the considered state are thrown away."""
    P = joseph(K, P, H, R)
    variance = P[considered, considered]
    P[considered], P[:, considered] = 0, 0
    P[considered, considered] = variance
    return P


def correct_always_third(x, P, z, H, R, considered):
    """A consider correction that does not ask which state is considered."""
    return correct_with(lambda K, full, P, H, R, c: joseph(K, P, H, R))(x, P, z, H, R, 2)


def without_row(P, considered):
    """Row and column of the considered state are zero."""
    P = P.copy()
    P[considered], P[:, considered] = 0, 0
    return P


def of_three(x, P, z, H, R, considered):
    K = P @ H.T / (H @ P @ H.T + R)
    K[considered] = 0
    keep = np.eye(3) - K @ H
    return x + K @ (z - H @ x), keep @ P @ keep.T + K @ R @ K.T


def column_zeroed(x, P, z, H, R, considered):
    K = P @ H.T / (H @ P @ H.T + R)
    K[:, considered] = 0
    keep = np.eye(len(P)) - K @ H
    return x + K @ (z - H @ x), keep @ P @ keep.T + K @ R @ K.T


def late(K_of=None, P_of=None, news=None):
    """A consider correction with one part of it exchanged."""

    def wrong(x, P, z, H, R, considered):
        K = K_of(P, H, R, considered) if K_of else P @ H.T / (H @ P @ H.T + R)
        K[considered] = 0
        keep = np.eye(len(P)) - K @ H
        P = P_of(P, K, keep, H, R) if P_of else keep @ P @ keep.T + K @ R @ K.T
        return x + K @ (news(z, H, x) if news else z - H @ x), P

    return wrong


BIAS_IN_S = "The bias is left out of the gain or of H: the reading holds the considered state too, so S = H P Hᵀ + R with all of H. Only the state's row of K is zero."


def bias_left_out(x, P, z, H, R, considered):
    H = H.copy()
    H[:, considered] = 0
    return late()(x, P, z, H, R, considered)


def without_bias(P, H, R, considered):
    H = H.copy()
    H[:, considered] = 0
    return P @ H.T / (H @ P @ H.T + R)


WRONG = {
    "as shown": (
        correct_with(lambda K, full, P, H, R, c: (np.eye(len(P)) - full @ H) @ P),
        "P still shrinks by the full gain, as if the row had never been zeroed; x and P must use the same K.",
    ),
    "row first, plain form": (
        correct_with(lambda K, full, P, H, R, c: (np.eye(len(P)) - K @ H) @ P),
        "The bias keeps its row of P, but your P is not symmetric: (9) holds for the best gain only. Set the row of K to zero first, then use (9J) with that K.",
    ),
    "row first, symmetrised": (
        correct_with(half_symmetric),
        "Symmetrising hides that (9) is the wrong formula for this gain; half of the mistake stays in. Use (9J).",
    ),
    "never zeroed": (
        correct_with(lambda K, full, P, H, R, c: joseph(full, P, H, R), mean_gain="full"),
        "x and P are those of the full gain, as if no row were zeroed. Zero it first: the state is not to be estimated.",
    ),
    "KRKᵀ forgotten": (
        correct_with(lambda K, full, P, H, R, c: (np.eye(len(P)) - K @ H) @ P @ (np.eye(len(P)) - K @ H).T),
        "The term KRKᵀ is missing: the noise of the reading came in through K as well.",
    ),
    "cross-covariance dropped": (
        correct_with(without_cross),
        "In your P the covariance of the considered state with the others is zero. A consider filter works through this covariance.",
    ),
    "always the third": (
        correct_always_third,
        "In your code the same state is considered each time. The argument `considered` says which state it is.",
    ),
    "P left": (
        correct_with(lambda K, full, P, H, R, c: P),
        "The state is right. P must change as well: the other states have learnt something from the reading.",
    ),
    "K S Kᵀ": (
        correct_with(lambda K, full, P, H, R, c: P - K @ (H @ P @ H.T + R) @ K.T),
        "That is P − K S Kᵀ, with the row and the column of the considered state as they were before the reading. It holds for the best gain only, like (9): after the row is zeroed use (9J).",
    ),
    "x with the full gain": (
        correct_with(lambda K, full, P, H, R, c: joseph(K, P, H, R), mean_gain="full"),
        "P is right. The state still moves by the full gain, with the considered state: zero the row before you use K.",
    ),
    "column zeroed in P": (
        correct_with(lambda K, full, P, H, R, c: without_row((np.eye(len(P)) - full @ H) @ P, c)),
        "Row and column of the considered state are zero in your P. It keeps its variance, and the filter needs "
        "its covariances.",
    ),
    "3 × 3": (
        of_three,
        "You wrote the size 3 into the function. It must work for any number of states: `np.eye(len(x))`.",
        r"(eye|identity)\(3\)",
    ),
    "column zeroed": (
        column_zeroed,
        "You set a column of K to zero. K has a row for each state: `K[considered] = 0`.",
        r"K\[:, ?considered\] ?=",
    ),
    "keep turned": (
        late(P_of=lambda P, K, keep, H, R: keep.T @ P @ keep + K @ R @ K.T),
        "The state is right. In (9J) I − K H stands on the left of P, and its transpose on the right.",
    ),
    "keep twice": (
        late(P_of=lambda P, K, keep, H, R: keep @ P @ keep + K @ R @ K.T),
        "The state is right. In (9J) the second I − K H is transposed.",
    ),
    "bias not in H": (bias_left_out, BIAS_IN_S),
    "bias not in the gain": (late(K_of=without_bias), BIAS_IN_S),
    "R not in the last term": (
        late(P_of=lambda P, K, keep, H, R: keep @ P @ keep.T + K @ K.T),
        "The state is right. In the last term of (9J) R is missing: K R Kᵀ, not K Kᵀ.",
    ),
    "R not in S": (
        late(K_of=lambda P, H, R, c: P @ H.T / (H @ P @ H.T)),
        "Your S lacks R: S = H P Hᵀ + R.",
    ),
    "innovation turned": (
        late(news=lambda z, H, x: H @ x - z),
        "P is right. The state moves the wrong way: the innovation is z − H x.",
    ),
    "H forgotten": (
        late(news=lambda z, H, x: z - x[:1]),
        "P is right. The reading is compared with the first state alone: the innovation is z − H x.",
    ),
    "KRKᵀ subtracted": (
        late(P_of=lambda P, K, keep, H, R: keep @ P @ keep.T - K @ R @ K.T),
        "The state is right. The noise of the reading makes P larger: K R Kᵀ is added.",
    ),
}
