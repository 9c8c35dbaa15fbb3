"""Lesson 22: adaptive filters."""

from itertools import cycle

import numpy as np

from kflearn.exercises import _unknown_sensor, _unknown_sensor_seen, _unknown_sensor_signs
from kflearn.exercises._hints import after
from kflearn.exercises._judge import track
from kflearn.exercises._slips import adaptive as slips
from kflearn.exercises.engine import exercise, judged


@exercise(
    hints=[
        "How much does a mean of N squared bells scatter? By S √(2/N), S being the variance of one of them.",
        after(
            169,
            "S = 1.3 is right. The square of a bell scatters by S √2, not by S: where does the 2 go?",
            "S is not R: an innovation scatters by what the sensor does and by what the prediction does, 1 + 0.3.",
        ),
        "You need 1.3 √(2/N) ≤ 0.1. Solve for N, and round up.",
        "`2 * (1.3 / 0.1) ** 2`",
    ],
    wrong=slips.window_needed.WRONG,
    otherwise=slips.window_needed.scatter_of,
    unit="innovations",
    rtol=1e-3,
    also=[339],  # what `np.ceil` makes of 338.00000000000006
    then=(
        "At ten readings a second that is 34 s. An R̂ that is good to a tenth cannot follow a sensor that changes "
        "within seconds."
    ),
)
def window_needed():
    """R = 1 m², HP⁻Hᵀ = 0.3 m². How many innovations until R̂ scatters by 0.1 m² (standard deviation) only?"""
    return round(2 * ((1 + 0.3) / 0.1) ** 2)


SENSORS = cycle((1, 1, 1, 3, 2, 3, 2))  # one at first: y yᵀ has a shape that fits then


def vectors(rng):
    """Innovations of one, two or three sensors, few or forty, and a lopsided H with a covariance of one or two states more."""
    m, N = next(SENSORS), int(rng.integers(4, 9))
    N = 40 if N == 7 else N
    n = m + int(rng.choice([1, 2]))
    factor = rng.integers(-2, 3, (n, n)) / 2 + 1.5 * np.eye(n)
    y = rng.integers(-8, 9, (N, m)) / 2 + rng.integers(1, 4, m)
    return y, rng.integers(-2, 4, (m, n)) / 2 + np.eye(m, n), factor @ factor.T


@exercise(
    hints=[
        "C is the mean of the m × m matrices y yᵀ, one for each row of y. Then take off what the prediction explains.",
        "The sum of all y yᵀ is `y.T @ y`: try its shape. The prediction's share is H P Hᵀ.",
        "`return y.T @ y / len(y) - H @ P @ H.T`",
    ],
    inputs=vectors,
    wrong=slips.matrix_R.WRONG,
    then=(
        "With few innovations R̂ may have a negative number on its diagonal, and no variance is negative: hence "
        "the floor in the lesson."
    ),
)
def matrix_R(y, H, P):
    """R̂ (m, m) from innovations y (N, m), H (m, n) and the prediction's covariance P (n, n); no floor."""
    return y.T @ y / len(y) - H @ P @ H.T


def logarithms(rng):
    """Normalised logarithms of two to five weights, some hopeless, and log-likelihoods, some of them all very low."""
    M = int(rng.choice([5, 3, 2]))
    logs = rng.choice([0, -1, -3, -20, -400, -1200], M)
    likelihoods = rng.integers(-12, 3, M) / 2 - rng.choice([0, 900, 20000]) - rng.choice([0, 0, 300, 800, 20000], M)
    return logs - np.logaddexp.reduce(logs.astype(float)), likelihoods


@exercise(
    hints=[
        "A product of weights is a sum of their logarithms. What is left to do is to make the weights, not the logarithms, sum to 1.",
        "Take off log Σ exp(s). If all s are below −745, every exp is 0: take the largest s off first, nothing is lost by it.",
        "NumPy has it ready: `np.logaddexp.reduce(s)` is log Σ exp(s) for s as low as you like.",
        "`s = log_weights + log_likelihoods`, then `return s - np.logaddexp.reduce(s)`",
    ],
    inputs=logarithms,
    wrong=slips.weigh.WRONG,
    then="A weight of e⁻²⁰⁰⁰ is 0 for a computer; its logarithm, −2000, is an ordinary number and can rise again.",
)
def weigh(log_weights, log_likelihoods):
    """The logarithms of M weights after one more reading, from those before and the log-likelihoods of the reading."""
    s = log_weights + log_likelihoods
    s = s - s.max()
    return s - np.log(np.sum(np.exp(s)))


SIZES = cycle((2, 2, 2, 3))  # of the state, in the trials


def bank(rng):
    """Weights (M,), means (M, n) and covariances (M, n, n) of a bank of four filters or more."""
    M, n = int(rng.choice([6, 5, 4])), next(SIZES)
    p = rng.integers(1, 9, M).astype(float)
    factors = rng.integers(-2, 3, (M, n, n)) / 2 + 1.5 * np.eye(n)
    return p / p.sum(), rng.integers(-9, 10, (M, n)) / 2, factors @ factors.mT + np.eye(n) / 2


@exercise(
    hints=[
        "The loop takes three things in step: over what does the first of them run? How many turns does it make for four filters?",
        "Each filter's mean must be compared with the joint mean, a vector, and every filter must have its turn.",
        "For each filter: its weight times (its covariance + np.outer(y, y)), with y = its mean − p @ means. Sum over all.",
        "`return sum(w * (P + np.outer(m - p @ means, m - p @ means)) for w, m, P in zip(p, means, covs))`",
    ],
    inputs=bank,
    wrong=slips.mixture_cov.WRONG,
    then=(
        "Where all means are equal nothing is left but the mean of the covariances; where they differ the joint "
        "belief is wider."
    ),
)
def mixture_cov(p, means, covs):
    """The covariance (n, n) of a bank's joint belief: weights p (M,), means (M, n), covariances (M, n, n)."""
    apart = means - p @ means
    return np.tensordot(p, covs + apart[:, :, None] * apart[:, None, :], 1)


@exercise(
    hints=[
        "Both would make R̂ large. What does larger white noise do to the correlation of neighbours, and what does a motion do?",
        "The noise of a sensor is nearly white. Neighbours that are correlated by 0.85 are one motion, read again and again.",
        "Until 3.5 s the neighbours are strongly correlated, so it is the motion: B.",
    ],
    wrong=slips.moved_or_noisy.WRONG,
    otherwise=slips.moved_or_noisy.NOISY,
    then="Noise that is nearly white does not correlate by 0.85. (Noise with a memory of several readings would; but the board is at rest later, and there the same sensor's noise is white.) A model that can turn, with a Q for turning, would have followed it.",
)
def moved_or_noisy():
    """R̂ is huge until 3.5 s: noise of the sensor, motion of the board, or can it not be told?"""
    return "B"


@judged(
    hints=[
        "Begin with `adaptive` of this lesson. Which of its names belong to that cart only? And what must not happen where a reading is NaN?",
        "Predict in every step. Where there is a reading: put its innovation into the list, estimate R, correct. Where there is none: store the prediction, and leave the list alone.",
        "`R = max(np.mean(recent[-30:]) - P[0, 0], 0.05)` with the squared innovations in `recent`, as soon as there are 30; before that R = 1.",
    ],
    recording=_unknown_sensor.unknown_sensor,
    marks=_unknown_sensor_seen.MARKS,
    form=track(2),
    then="A bank with the candidates 1, 4 and 16 m² that may change, as in lesson 18, is nearer to the truth in the 25 steps after a change: 1.01 m against 1.16 m with a window of 30, where the sensor becomes good again.",
    passing=_unknown_sensor.PASSING,
    failing=_unknown_sensor.FAILING,
    signs=_unknown_sensor_signs.SIGNS,
)
def unknown_sensor(z, F, Q, mean, cov):
    """Write a filter that learns R: the mean (T, 2) and the covariance (T, 2, 2) after each of T steps.

    State: position (m) and velocity (m/s). z (T,): readings of the position in m, NaN where there is none. F, Q (2, 2):
    the cart, which is not the lesson's. mean (2,), cov (2, 2): what is known one step before the first reading. The data
    sheet says R = 1 m². At some moment the sensor becomes much worse, or it was much worse before and becomes as good as
    the sheet says. It is judged after that moment; 45 steps are granted to notice. With a window the floor of R̂ must be 0.05 m² or more.
    """
    x, P, R, recent, means, covs = mean, cov, 1.0, [], [], []
    for reading in z:
        x, P = F @ x, F @ P @ F.T + Q
        if not np.isnan(reading):
            y = reading - x[0]
            recent.append(y**2)
            if len(recent) >= 30:
                R = max(np.mean(recent[-30:]) - P[0, 0], 0.05)
            K = P[:, 0] / (P[0, 0] + R)
            x, P = x + K * y, P - np.outer(K, P[0])
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)
