"""More wrong answers to exercises of lessons 19 to 22, each with the sentence that it gets."""

import itertools
import math

import numpy as np


def first_gain(k, R=0.25, S=None, kept=1.0):
    """P after the reading of exercise 2 of lesson 21 in Joseph's form, for the gain k of the position."""
    return np.array([[(1 - k) ** 2 * 4 + k**2 * (1 + R), -k], [-k, kept]])


def marked():
    """Every marking of [east, north, ψ, b, s] that has no sentence of its own, with what is wrong in it."""
    for bits in itertools.product((0, 1), repeat=5):
        east, north, heading, bias, scale = bits
        words = []
        if not (heading and scale):
            words.append(
                f"{'Two are' if not (heading or scale) else 'One is'} missing: which states stand in the slopes, that is in F?"
            )
        if east or north:
            words.append("East and north are only added to: F does not depend on them.")
        if bias:
            words.append("b enters along a straight line, by ψ + w − b: F does not depend on it.")
        yield bits, " ".join(words)


def chosen_but(known):
    """The markings that are neither right nor in the table `known`."""
    taken = [list(np.ravel(value)) for value, _ in known.values()] + [[0, 0, 1, 0, 1]]
    return {str(bits): (list(bits), words) for bits, words in marked() if list(bits) not in taken}


def late(K_of=None, P_of=None, news=None):
    """A consider correction with one part of it exchanged."""

    def wrong(x, P, z, H, R, considered):
        K = K_of(P, H, R, considered) if K_of else P @ H.T / (H @ P @ H.T + R)
        K[considered] = 0
        keep = np.eye(len(P)) - K @ H
        P = P_of(P, K, keep, H, R) if P_of else keep @ P @ keep.T + K @ R @ K.T
        return x + K @ (news(z, H, x) if news else z - H @ x), P

    return wrong


def without_bias(P, H, R, considered):
    H = H.copy()
    H[:, considered] = 0
    return P @ H.T / (H @ P @ H.T + R)


def bias_left_out(x, P, z, H, R, considered):
    H = H.copy()
    H[:, considered] = 0
    return late()(x, P, z, H, R, considered)


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


def in_blocks(cross):
    return lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, cross(C, F, fading, q), fading**2 * B + q)


BIAS_IN_S = "The bias is left out of the gain or of H: the reading holds the considered state too, so S = H P Hᵀ + R with all of H. Only the state's row of K is zero."
SLIPS = {}

SLIPS["coast"] = {
    "four zeros": (
        lambda x, P, F, push, Q: (np.zeros(4), F @ P @ F.T + Q),
        "P is right. The state becomes zero, as published, though the ball flies on: it is F x + push. (And the trials have several sizes, not four states.)",
    ),
    "four zeros, P kept": (
        lambda x, P, F, push, Q: (np.zeros(4), P),
        "That is the published fault again: the state becomes zero, and P still claims a small error. (And the trials have several sizes, not four states.)",
    ),
    "P given up": (
        lambda x, P, F, push, Q: (F @ x + push, 1e4 * np.eye(len(x))),
        "The state is right. But you threw P away: the filter knows more than that. P grows from what it was, F P Fᵀ + Q.",
    ),
}
SLIPS["first_velocity"] = {
    "R squared": (
        lambda p, s, R, y: s * y / (p + s + R**2),
        "That is right for R². R is a variance already, like p and s.",
    ),
    "roots": (
        lambda p, s, R, y: math.sqrt(s) * y / (math.sqrt(p) + math.sqrt(s) + math.sqrt(R)),
        "Roots of p, s or R are in it. Variances add, not standard deviations: take none.",
    ),
    "place and velocity squared": (
        lambda p, s, R, y: s**2 * y / (p**2 + s**2 + R**2),
        "Squares of the variances are in it. p, s and R are variances already.",
    ),
    "R alone below": (
        lambda p, s, R, y: s * y / R,
        "You divided by R alone. S is the variance of the whole innovation: of place, velocity and reading.",
    ),
    "s missing above": (
        lambda p, s, R, y: y / (p + s + R),
        "The denominator is S, and it is right. What stands above it is the covariance of place and velocity after the prediction.",
    ),
    "turned over": (
        lambda p, s, R, y: (p + s + R) / s * y,
        "Your gain is upside down: S belongs below.",
    ),
}  # fmt: skip
SLIPS["all_bias"] = {
    "6 % of the reading": (
        lambda: (1 / 0.94 - 1) * 450,
        "That number comes of 6 % of what the sensor shows. They are of the true acceleration, 0.5 m/s².",
    ),
    "share as an acceleration": (
        lambda: 0.56 * 450,
        "252 m is what 0.56 m/s² makes. The braking itself is no error: what does the filter subtract too much, in m/s²?",
    ),
    "the braking itself": (
        lambda: 0.5 * 450,
        "That is the way that the tram loses by braking. What is the *error*: how much does the filter subtract too much?",
    ),
    "what was read": (
        lambda: 0.43 * 450,
        "0.43 m/s² is what the sensor shows while braking. Subtract what was learnt, and compare with the true −0.5 m/s².",
    ),
    "6 % of 0.1": (
        lambda: 0.006 * 450,
        "2.7 m is what 0.006 m/s² makes, which is 6 % of the bias. The 6 % are of the true acceleration, 0.5 m/s².",
    ),
}  # fmt: skip
SLIPS["dark_time"] = {
    "added as squares": (
        lambda dv, b, allowed: math.sqrt(2 * (math.sqrt(dv**4 + b**2 * allowed**2) - dv**2)) / b,
        "That solves (dv·t)² + (b·t²/2)² = allowed², as for independent errors. Both push the position the same way: the metres add.",
    ),
    "−dv forgotten": (
        lambda dv, b, allowed: math.sqrt(dv**2 + 2 * b * allowed) / b,
        "The root is right. The solution begins with −dv: the speed is wrong from the start.",
    ),
    "root forgotten": (
        lambda dv, b, allowed: (-dv + dv**2 + 2 * b * allowed) / b,
        "The root is missing: it goes over dv² + 2 b allowed.",
    ),
    "dv not squared": (
        lambda dv, b, allowed: (-dv + math.sqrt(dv + 2 * b * allowed)) / b,
        "Under the root dv stands squared.",
    ),
}
SLIPS["goes_back"] = {
    "their places": ([2, 4], "Those are the places of two states in the list. Mark all five: 1 for each that goes back, else 0."),
    "their numbers": ([3, 5], "Those are the numbers of two states. Mark all five: 1 for each that goes back, else 0."),
}  # fmt: skip
SLIPS["inflated"] = {
    "by the memory": (
        lambda: 0.09 + 0.25 * (1 + math.exp(-0.05)) / (1 - math.exp(-0.05)),
        "That is the lesson's other recipe, with the memory of the bias. Inflated by the *variance*, R is the sum of two variances.",
    ),
    "the memory's": (40.26, "That is the lesson's R by the memory of the bias. Here the recipe is the variance, and the numbers are others."),
}  # fmt: skip
SLIPS["first_covariance"] = {
    "bias known": (
        np.array([[4 - 4 * 4 / 5.25, 0], [0, 0]]),
        "Here the variance of the bias is zero. A considered bias keeps its variance, 1, and becomes correlated with the position.",
    ),
    "variance of the bias zero": (
        np.array([[4 - 4 * 4 / 5.25, -4 / 5.25], [-4 / 5.25, 0]]),
        "P₂₂ is not zero. The reading tells the filter nothing about a considered bias: its variance stays 1.",
    ),
    "R squared, short": (
        np.array([[4 - 4 * 4 / 5.0625, -4 / 5.0625], [-4 / 5.0625, 1]]),
        "That is right for R = 0.0625, the square of 0.25. R = 0.25 is a variance already: S = 4 + 1 + 0.25.",
    ),
    "root of R": (first_gain(4 / 5.5, 0.5), "That is right for R = 0.5, the root of 0.25. R = 0.25 is the variance: S = 4 + 1 + 0.25."),
    "R not in S": (first_gain(4 / 5), "Your gain lacks R: S = 4 + 1 + 0.25."),
    "R nowhere": (
        np.array([[0.8, -0.8], [-0.8, 1]]),
        "R is left out, in the gain and in the last term of (9J): S = 4 + 1 + 0.25, and K R Kᵀ is added.",
    ),
    "bias not in S, P11": (
        np.array([[4 * 0.25 / 4.25, -4 / 4.25], [-4 / 4.25, 1]]),
        "Your gain lacks the bias: S = 4 + 1 + 0.25, because the innovation holds the bias too.",
    ),
    "bias added": (
        np.array([[4 - 4 * 4 / 5.25 + 1, -4 / 5.25], [-4 / 5.25, 1]]),
        "P₁₁ is larger by 1, the variance of the bias, than it should be. (9J) counts that already.",
    ),
}  # fmt: skip
SLIPS["late_row"] = {
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
SLIPS["economical"] = {
    "F on both sides": (
        in_blocks(lambda C, F, fading, q: fading * F @ C @ F.T),
        "F stands in C once, on its left. On the right of C are the biases, which F does not move.",
    ),
    "q added": (
        in_blocks(lambda C, F, fading, q: fading * F @ C + q),
        "C gets no noise: what pushes the states and what renews the bias are independent.",
    ),
    "F on the right": (
        in_blocks(lambda C, F, fading, q: fading * C @ F.T),
        "F stands on the left of C, whose rows are the states.",
    ),
    "F on the right, not transposed": (
        in_blocks(lambda C, F, fading, q: fading * C @ F),
        "F stands on the left of C, whose rows are the states.",
    ),
    "first bias only": (
        lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading * F @ C[:, :1], fading**2 * B + q),
        "P and B are right. C holds the first bias only: there may be more of them, one column for each.",
    ),
    "q faded": (
        lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading * F @ C, fading**2 * (B + q)),
        "P and C are right. q is added after the fading: fading² B + q.",
    ),
    "P not transposed": (
        lambda P, C, B, F, fading, Q, q: (F @ P @ F + Q, fading * F @ C, fading**2 * B + q),
        "C and B are right. In P the second F is transposed: F P Fᵀ + Q.",
    ),
}
