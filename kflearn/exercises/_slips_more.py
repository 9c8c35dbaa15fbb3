"""Wrong answers to exercises of lessons 2, 5, 17, 20, each with the sentence that it gets."""

import math

import numpy as np


def settled(step):
    """The gain after a hundred rounds of `step(P, Q, R)`, which returns the gain and the new P."""

    def gain(Q, R):
        P = R
        for _ in range(100):
            K, P = step(P, Q, R)
        return K

    return gain


def cut(P, K, Q, R):
    """A round that cuts P by 1 − K."""
    return K, (1 - K) * (P + Q)


def start_of(x_of, P_of):
    """A start from one measurement, with a state and a covariance made of H⁻¹ and of z, H, R."""

    def start(z, H, R):
        undo = np.linalg.inv(H)
        return x_of(undo, z, H, R), P_of(undo, z, H, R)

    return start


def right_x(undo, z, H, R):
    return undo @ z


def right_P(undo, z, H, R):
    return undo @ R @ undo.T


def new_error(x, dx, K, fix):
    return dx + K @ (fix - x[:2] - dx[:2])


def told_twice(x, dx, K, fix):
    return x + 2 * new_error(x, dx, K, fix), 0 * dx


def position_zero(x, dx, K, fix):
    dx = new_error(x, dx, K, fix)
    return x + dx, np.append(np.zeros(2), dx[2:])


def told_before_the_fix(x, dx, K, fix):
    return x + dx, new_error(x + dx, dx, K, fix)


WRONG = {
    "steady_gain": {
        "P times K": (
            settled(lambda P, Q, R: ((K := (P + Q) / (P + Q + R)), K * (P + Q))),
            "In your loop P becomes K·P, or P − K·R. What the reading leaves is (1 − K)·P⁻: the larger the gain, the less.",
        ),
        "(1 − K) R": (
            settled(lambda P, Q, R: ((K := (P + Q) / (P + Q + R)), (1 - K) * R)),
            "In your loop P becomes (1 − K)·R. What the reading leaves is (1 − K)·P⁻; that is K·R.",
        ),
        "P by R": (
            settled(lambda P, Q, R: cut(P, (P + Q) / R, Q, R)),
            "Your gain is P⁻/R. It is a part of the whole: P⁻/(P⁻ + R), and never more than 1.",
        ),
        "Q over the sum": (
            settled(lambda P, Q, R: cut(P, Q / (P + Q + R), Q, R)),
            "Your gain has Q on top. The whole variance before the reading stands there: P⁻ = P + Q.",
        ),
        "squared": (
            lambda Q, R: (math.sqrt((Q / R) ** 4 + 4 * (Q / R) ** 2) - (Q / R) ** 2) / 2,
            "Your result is right for Q² and R². Q and R are variances already: they go in as they are.",
        ),
        "minus under the root": (
            lambda Q, R: (math.sqrt(abs((Q / R) ** 2 - 4 * Q / R)) - Q / R) / 2,
            "Under the root it is plus. In K² + qK − q = 0 the last term is −q, so b² − 4ac is q² + 4q.",
        ),
        "half of the root alone": (
            lambda Q, R: math.sqrt((Q / R) ** 2 + 4 * Q / R) / 2 - Q / R,
            "Your result is √(q² + 4q)/2 − q. The 2 divides both: (√(q² + 4q) − q)/2.",
        ),
        "half of q alone": (
            lambda Q, R: math.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R / 2,
            "Your result is √(q² + 4q) − q/2. The 2 divides both: (√(q² + 4q) − q)/2.",
        ),
        "1 − K with R / Q": (
            lambda Q, R: 1 - (math.sqrt((R / Q) ** 2 + 4 * R / Q) - R / Q) / 2,
            "Your result is one minus the gain that R/Q would give. The gain itself is asked for, with q = Q/R.",
        ),
        "2q": (
            lambda Q, R: (math.sqrt((Q / R) ** 2 + 2 * Q / R) - Q / R) / 2,
            "Under the root stands q² + 4q: the 4 of b² − 4ac stays whole.",
        ),
        "4q²": (
            lambda Q, R: (math.sqrt(5) - 1) / 2 * Q / R,
            "Your result is 0.618·q. Under the root stands q² + 4q, with a q that is not squared in the second term.",
        ),
        "R twice": (
            lambda Q, R: Q / (Q + 2 * R),
            "Your result is Q/(Q + 2R). The gain is P⁻/(P⁻ + R), and P⁻ = P + Q: what was left from before stands on top too.",
        ),
    },
    "is_unknown": {
        "without the first": (
            lambda x: np.isnan(x[1:]).any(),
            "A NaN in the first entry is not found; every entry counts, that one too.",
        ),
        "without the last": (
            lambda x: np.isnan(x[:-1]).any(),
            "A NaN in the last entry is not found; every entry counts, that one too.",
        ),
        "where the first one is": (
            lambda x: np.isnan(x).argmax(),
            "You return the place of the first NaN, and 0 where there is none. True or False is wanted: is there any?",
        ),
        "places in rows": (
            lambda x: np.argwhere(np.isnan(x)),
            "You return the places of the unknown entries. True or False is wanted: is there any?",
        ),
        "larger than 0": (
            lambda x: (x > 0).any(),
            "Your function says True where an entry is larger than 0. Whether an entry is unknown, np.isnan tells.",
        ),
    },
    "auto_start": {
        "(H R Hᵀ)⁻¹": (
            start_of(right_x, lambda undo, z, H, R: np.linalg.inv(H @ R @ H.T)),
            "Your x is right. Your P is the inverse of HRHᵀ, and so R is inverted too. Only H is undone: H⁻¹RH⁻ᵀ.",
        ),
        "R added": (
            start_of(right_x, lambda undo, z, H, R: undo @ R @ undo.T + R),
            "Your x is right. In P one R too many is added: H⁻¹RH⁻ᵀ is the whole of it, for the measurement's error is counted once.",
        ),
        "transposed throughout": (
            start_of(lambda undo, z, H, R: undo.T @ z, lambda undo, z, H, R: undo.T @ R @ undo),
            "Your result has the transpose of H⁻¹ where H⁻¹ stands, and the other way round: x = H⁻¹z and P = H⁻¹RH⁻ᵀ.",
        ),
        "corners of R lost": (
            start_of(right_x, lambda undo, z, H, R: undo @ np.diag(np.diag(R)) @ undo.T),
            "Your x is right. In P only the diagonal of R counts. Its corners belong to it: the whole matrix R stands in the middle.",
        ),
        "roots": (
            start_of(right_x, lambda undo, z, H, R: np.sqrt(undo @ R @ undo.T)),
            "Your x is right. Your P holds the roots of the entries of the covariance. P is the covariance itself: no root.",
        ),
        "S": (
            start_of(right_x, lambda undo, z, H, R: H @ R @ H.T + R),
            "Your x is right. HRHᵀ + R looks like the covariance S of an innovation. There is no prediction yet: P = H⁻¹RH⁻ᵀ.",
        ),
        "half of R": (
            start_of(right_x, lambda undo, z, H, R: R / 2),
            "Your x is right. R/2 is not its covariance: the error of H⁻¹z is H⁻¹v, with the covariance H⁻¹RH⁻ᵀ.",
        ),
        "R z": (
            start_of(lambda undo, z, H, R: R @ z, right_P),
            "P is right. In x you multiply by R. The measurement z = Hx is undone with H⁻¹; R is no part of it.",
        ),
        "(I + H Hᵀ…)": (
            start_of(lambda undo, z, H, R: R @ H.T @ np.linalg.inv(H @ R @ H.T + R) @ z, right_P),
            "P is right. Your x is a gain times z, as in a correction from x = 0 with P = R. There is no belief to correct yet: x = H⁻¹z.",
        ),
    },
    "best_error": {
        "K squared": (
            3.0,
            "3 is 4(1 − K²), with K = ½. What is left is 4(1 − K), in V²; and the error is its root.",
        ),
        "root with K squared": (
            lambda: math.sqrt(3),
            "1.73 is √3, and 3 is 4(1 − K²) with K = ½. What is left is 4(1 − K).",
        ),
        "product": (
            16.0,
            "16 is the product of the two variances, 4 · 4. What is left is 4 · 4/(4 + 4), and the error is its root.",
        ),
        "sixteen and sixteen": (
            lambda: math.sqrt(32),
            "5.66 is √(16 + 16), or 4√2. The two variances are 4 V² each, and fusing them gives a smaller one.",
        ),
        "a third": (
            lambda: math.sqrt(4 / 3),
            "1.155 is √(4/3): so much would be left if three opinions of variance 4 were fused. Here there are two.",
        ),
        "a quarter": (
            0.25,
            "0.25 is K², or 1/4, the precision of one reading. What variance is left, 4(1 − K), and what is its root?",
        ),
    },
    "three_points": {
        "centre in degrees": (
            lambda: 100 * (2 / 3 * np.sin(90) + np.cos(np.radians(30) * 3**0.5) / 3),
            "That is right but for the centre: `np.sin(90)` takes 90 for radians. The centre lies at 90°, where the sine is 1.",
        ),
        "cosine of degrees": (
            lambda: 100 * (2 / 3 + np.cos(30 * 3**0.5) / 3),
            "That is what comes out if `np.cos` is given degrees. It takes radians: `np.cos(np.radians(…))`.",
        ),
    },
    "dark_time": {
        "the later of two": (
            lambda dv, b, allowed: max(allowed / dv, math.sqrt(2 * allowed / b)),
            "That is the later of two times, one for each error alone. But both errors act at the same time: add the metres, then solve for t.",
        ),
        "mean of two": (
            lambda dv, b, allowed: (allowed / dv + math.sqrt(2 * allowed / b)) / 2,
            "That is the mean of two times, one for each error alone. But both errors act at the same time: add the metres, then solve for t.",
        ),
        "halves of allowed": (
            lambda dv, b, allowed: allowed / 2 / dv + math.sqrt(allowed / b),
            "You gave each error half of the metres and added the two times. They act at the same time, and not with equal parts: add the metres, then solve for t.",
        ),
        "divided by 2": (
            lambda dv, b, allowed: (-dv + math.sqrt(dv**2 + 2 * b * allowed)) / 2,
            "The root is right. Below stands twice the factor of t². That factor is b/2, so divide by b, not by 2.",
        ),
        "divided by b²": (
            lambda dv, b, allowed: (-dv + math.sqrt(dv**2 + 2 * b * allowed)) / b**2,
            "Your time is divided by b once too often: (−dv + √(dv² + 2 b allowed))/b.",
        ),
        "not t²": (
            lambda dv, b, allowed: allowed / (dv + b / 2),
            "That solves dv·t + b·t/2 = allowed. The bias makes b·t²/2 metres: they grow with the square of the time.",
        ),
        "speed taken from the metres": (
            lambda dv, b, allowed: math.sqrt(2 * (allowed - dv) / b),
            "That solves b·t²/2 = allowed − dv, with metres less m/s. The speed error makes dv·t metres, so t stands in that term too.",
        ),
        "dv outside the root alone": (
            lambda dv, b, allowed: math.sqrt(2 * allowed / b) - dv / b,
            "Under the root dv² is missing: (−dv + √(dv² + 2 b allowed))/b.",
        ),
        "root alone": (
            lambda dv, b, allowed: math.sqrt(dv**2 + 2 * b * allowed),
            "√(dv² + 2 b allowed) is the speed error at the end, dv + b·t. Take dv from it and divide by b.",
        ),
        "root over b": (
            lambda dv, b, allowed: math.sqrt(dv**2 + 2 * b * allowed) / b,
            "The −dv in front of the root is missing: (−dv + √(dv² + 2 b allowed))/b.",
        ),
        "squares of two times": (
            lambda dv, b, allowed: math.hypot(allowed / dv, math.sqrt(2 * allowed / b)),
            "That is the root of the sum of two squared times, one for each error alone. Both errors act at the same time: add the metres, then solve for t.",
        ),
        "precisions of two times": (
            lambda dv, b, allowed: 1 / (dv / allowed + math.sqrt(b / 2 / allowed)),
            "That is 1/(1/t₁ + 1/t₂) of two times, one for each error alone. It would hold if both grew evenly; b·t²/2 does not. Add the metres, then solve for t.",
        ),
        "both roots in an array": (
            lambda dv, b, allowed: np.roots([b / 2, dv, -allowed]),
            "np.roots gives both roots; one of them is before the tunnel. Return the one that lies in the future.",
        ),
        "sign of allowed": (
            lambda dv, b, allowed: float(np.roots([b / 2, dv, allowed])[0].real),
            "The parabola is b·t²/2 + dv·t − allowed = 0: the last term has a minus.",
        ),
        "small steps": (
            lambda dv, b, allowed: (
                0.01 * next(n for n in range(10**6) if dv * 0.01 * n + b * 1e-4 * n * (n - 1) / 2 >= allowed)
            ),
            "Your time is nearly right: it comes in steps of 0.01 s. Solve b·t²/2 + dv·t − allowed = 0 instead; then it is exact.",
        ),
    },
    "mended_fix": {
        "told before the fix": (
            told_before_the_fix,
            "You added the old dx to x first, and kept dx all the same. So the old error is in both, and what the fix brought has not been told. Correct dx first, add it to x, and set it to zero.",
        ),
        "x corrected, dx kept": (
            lambda x, dx, K, fix: (x + K @ (fix - x[:2]), dx),
            "You corrected x as if there were no error state, and kept the old dx. Correct dx with the fix, as published; then add it to x and set it to zero.",
        ),
        "dx added in the innovation": (
            lambda x, dx, K, fix: (x + dx + K @ (fix - x[:2] + dx[:2]), 0 * dx),
            "The sign of dx in the innovation: the truth is believed at x + dx, so the fix is compared with that, fix − x[:2] − dx[:2].",
        ),
        "fix less dx alone": (
            lambda x, dx, K, fix: (x + dx + K @ (fix - dx[:2]), 0 * dx),
            "x is missing in the innovation: the fix is a position, and is compared with x[:2] + dx[:2].",
        ),
        "added twice": (
            told_twice,
            "You added dx to x twice. Once is enough; after that nothing is left in dx.",
        ),
        "the position's error alone is zero": (
            position_zero,
            "x is right now. But it has been told all of dx, not the position's part alone: all of dx is zero.",
        ),
    },
}
