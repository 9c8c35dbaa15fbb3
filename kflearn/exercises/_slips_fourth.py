"""Wrong answers to exercises of lessons 0 to 13 that a fourth group of strangers gave, and more of their kind."""

import numpy as np

from kflearn.exercises._newton_to_state_space import column, dragged
from kflearn.exercises._words import heard

BRACKETS = "the mass multiplies, as in `/ 2 * mass`, where Python divides by 2 only: write / (2 * mass)."
KNOB = "The estimate is nearly the best: which letter changes only the band?"
MYSTERY = {
    r"modest|cautious|careful": "Too modest, yes: NIS is below 2. Which of the four faults makes it so? The sign of the neighbours decides.",
    r"too sure|confident|optimistic": "NIS below 2 says the opposite: the claimed error is too large. Which of the four faults makes it so?",
    r"^q\b": "Is Q too large or too small? Look whether NIS is above or below 2.",
    r"^r\b": "Is R too large or too small? And do both numbers agree with it, the sign of the neighbours and NIS?",
}


def motion(first, second, dt_F=True, dt_B=True):
    """F and B; in one of them, or in both, the distance is divided by 2 and multiplied by the mass."""
    return lambda dt, mass, c: (
        dragged(dt, c * (first if dt_F else second)(dt, mass), c * dt / mass),
        column((first if dt_B else second)(dt, mass), dt / mass),
    )


def slip(dt, mass):
    return dt**2 / 2 * mass


def half(dt, mass):
    return dt**2 / (2 * mass)


def outside(x, P, z, H, R):
    """R is added to the gain."""
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T) + R
    return x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ P


def stretched(scales, rights):
    """What is said of the scale of one number, or of the share, times a factor that is the same for all shares."""
    from scipy.stats import norm

    each = scales / (1 - np.exp(-(rights**2) / 2))
    if np.ptp(each) < 1e-3 * each[0]:
        return f"Your k is {each[0]:.3g} times the share. k is not proportional to the share: solve share = 1 − exp(−k²/2) for k."

    factor = scales / norm.ppf(1 - np.exp(-(rights**2) / 2) / 2)
    if np.ptp(factor) < 1e-3 and abs(factor[0] - 1) > 0.01:
        return "You stretched the scale of one number. One factor mends one share only: solve share = 1 − exp(−k²/2) for k."
    return None


def wrapped_limits(refused, reading, width):
    low, high = (reading - width) % 360, (reading + width) % 360
    return sum(low <= old <= high for old in refused)


def old_gain(z, Q, R):
    x, P = z[0], R
    for reading in z[1:]:
        K = P / (P + R)
        x, P = x + K * (reading - x), (1 - K) * (P + Q)
    return x, P


def by_sample(normal, Q):
    w = np.sqrt(Q) @ normal
    with np.errstate(all="ignore"):
        return w / w.std(axis=1, keepdims=True) * np.sqrt(np.diag(Q))[:, None]


def report(x, z, mean, ignored, cov):
    """Errors under the ground as well."""
    up = x[:, 0] > 0
    errors = [np.sqrt(np.mean((each[:, 0] - x[:, 0]) ** 2)) for each in (mean, ignored)]
    return *errors, np.sqrt(cov[up][-1, 1, 1])


def deviations(z0, z1, dt, R):
    s = np.sqrt(R)
    return np.array([z1, (z1 - z0) / dt]), np.array([[s, s / dt], [s / dt, np.sqrt(2) * s / dt]])


def entries_added(one, two):
    L = one if one.sum() < two.sum() else two
    return L * L


def turned_slope(x):
    r, turn = np.hypot(x[0], x[2]), x[2] * x[1] + x[0] * x[3]
    changes = [x[2] * turn / r**3, x[0] / r, -x[0] * turn / r**3, x[2] / r]
    return np.array([[x[0] / r, 0, x[2] / r, 0], changes])


def out_of_the_plane(r, angle, sd_r, sd_angle):
    c, s = np.cos(angle), np.sin(angle)
    J = np.array([[c, s], [-s / r, c / r]])
    return J @ np.diag([sd_r**2, sd_angle**2]) @ J.T


WRONG = {
    "three_readings": {"of the ten": (40.186, "That is the mean of the ten readings above. Here take 61, 62 and 66 m.")},
    "motion": {
        "/ 2 * mass": (motion(slip, half), f"In the first rows of F and B {BRACKETS}"),
        "/ 2 * mass in F": (motion(slip, half, dt_B=False), f"B is right. In the first row of F {BRACKETS}"),
        "/ 2 * mass in B": (motion(slip, half, dt_F=False), f"F is right. In the first row of B {BRACKETS}"),
        "1 − c in B": (
            lambda dt, mass, c: (
                dragged(dt, c * half(dt, mass), c * dt / mass),
                (1 - c) * column(half(dt, mass), dt / mass),
            ),
            "F is right. B belongs to the push u alone: the drag depends on v and stands in F already, so c does not occur in B.",
        ),
    },
    "three_sensors": {
        "as in the lesson": (
            [[1, 0], [100, 0], [0, 1], [1, 0], [0, 1]],
            "These are the lesson's sensors. Three rows are wanted: tape in m, tape in cm, speedometer in km/h.",
        ),
    },
    "correct": {
        "R outside": (
            outside,
            "R belongs inside the bracket that is inverted, inv(H P Hᵀ + R). You added it to the gain, which is a matrix of another kind.",
        ),
    },
    "fuse": {
        "variances averaged": (
            lambda a, P, b, R: (a + P / (P + R) * (b - a), P + P / (P + R) * (R - P)),
            "The mean is right. Your variance is twice the fused one, as is (1 − K)·var_x + K·var_z. By (14) it is var_x · (1 − K).",
        ),
    },
    "second_gain": {
        "as in the lesson": (0.625, "0.625 is the lesson's gain for the third reading, where Q = R. Here Q = 3 V² and R = 9 V²: work out P⁻ anew."),
    },
    "offset": {
        "2 − K": (
            lambda x1, K, dt: dt * x1 / (2 - K),
            "At rest offset = (1 − K)(offset + dt·x₁). On the left side 1 − (1 − K) remains, and that is K; on the right 1 − K.",
        ),
        "one step": (
            lambda x1, K, dt: dt * x1 - K * dt * x1 * K,
            "The old offset is missing. It is still there when dt·x₁ is added, and the correction leaves 1 − K of both.",
        ),
    },
    "right_prediction": {
        "dt at the wrong term": (
            lambda P, Q, dt: np.array(
                [
                    [P[0, 0] + dt * (P[0, 1] + P[1, 0]) + dt**2 * P[1, 1], P[0, 1] + dt * P[1, 1]],
                    [dt * P[1, 0] + P[1, 1], P[1, 1]],
                ]
            )
            + Q,
            "Three entries are right. At the lower left dt stands beside the wrong term: it is P₁₀ + dt·P₁₁.",
        ),
    },
    "agreeing": {
        "limits wrapped": (
            wrapped_limits,
            "Near north none is counted, as when the limits are wrapped: the lower one is then above the upper one. Wrap the difference.",
        ),
    },
    "room_filter": {
        "Q after the gain": (old_gain, "Your gain uses the P before Q is added. Add Q first; then form K, and multiply P by 1 − K."),
    },
    "noise": {
        "rows exchanged": (lambda normal, Q: (np.sqrt(Q) @ normal)[::-1], "The two rows are exchanged: height comes first, then velocity."),
        "scaled by the sample": (
            by_sample,
            "Do not divide by the scatter of this sample. The numbers in `normal` are drawn with σ = 1 already: only multiply.",
        ),
    },
    "honest_report": {
        "under the ground": (
            report,
            "σ is right. Your two errors count the moments under the ground too: keep only those where x[:, 0] > 0.",
        ),
    },
    "start_variance": {
        "two sigma": (
            lambda low, high, believed: (max(high - believed, believed - low) / 2) ** 2,
            "All speeds in the range are equally likely, so there is no rule of two σ. Average the squared distance from `believed` over the range.",
        ),
        "half of high": (
            lambda low, high, believed: (high - low) ** 2 / 12 + (low + high / 2 - believed) ** 2,
            "`low + high / 2` halves only high: the middle is `(low + high) / 2`.",
        ),
    },
    "data_sheet": {
        "log10": (lambda: 36 / (2 * np.log10(2)), "59.8 comes from `np.log10(2)`. The formula holds with the natural logarithm, `np.log(2)`."),
    },
    "two_point_start": {
        "roots": (deviations, "The mean is right. A covariance holds variances: R, R/dt and 2R/dt², without roots."),
    },
    "average_nees": {
        "squared again": (
            lambda P, K, R, claim: ((1 - K) ** 2 * P + K**2 * R) ** 2 / claim,
            "(1 − K)²P + K²R is a mean squared error already: do not square it again.",
        ),
    },
    "orders_of_the_root": {
        "minus a half": (
            lambda orders: orders - 0.5,
            "A root does not take half an order away. It halves the number of orders: 10 become 5.",
        ),
    },
    "posterior": {
        "sums of entries": (
            entries_added,
            "A root's entries may be negative: compare the traces of L Lᵀ. And `*` multiplies entry by entry: `L @ L.T`.",
        ),
        "difference of the squares": (
            lambda one, two: abs(one @ one.T - two @ two.T),
            "The difference is what the reading took away. Return the smaller of the two covariances itself.",
        ),
    },
    "widest_belief": {
        "400 as σ": (40000, "40000 is 400²/(2 · 2), as if 400 m were σ. It is the distance d, and σ is unknown: σ²/(2 · 400 m) = 2 m."),
    },
    "mended_slope": {
        "turn with a plus": (
            turned_slope,
            "The signs of the entries are right. But `turn` was right before: y·vx minus x·vy.",
        ),
    },
    "into_the_plane": {
        "the other way": (
            out_of_the_plane,
            "Your Jacobian goes from the plane to (r, θ). The other direction is needed: the slopes of r cos θ and r sin θ.",
        ),
    },
}  # fmt: skip
KNOBS, MYSTERIES = heard({r"^none": f"One of the five is right. {KNOB}"}), heard(MYSTERY)
