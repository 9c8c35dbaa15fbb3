"""Lesson 20, `dark_time`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np

SIGN = "Under the root it is plus. The equation is b/2·t² + dv·t − allowed = 0, so −4ac is +2·b·allowed."


def whole_seconds(dv, b, allowed):
    t = 0
    while dv * t + b * t**2 / 2 < allowed:
        t += 1
    return t


def root_of_N(dv, b, allowed):
    return -dv + np.sqrt(dv**2 + 2 * b * allowed) / b


SQUARED = (
    "Your time is the one at which √((dv·t)² + (b·t²/2)²) reaches `allowed`. Squares add where errors are independent and may "
    "cancel. Here both pull the same way: dv·t + b·t²/2 = allowed."
)


def stepped(step):
    """The first of some steps at which the root of the squared metres reaches what is allowed."""

    def time(dv, b, allowed):
        exact = np.sqrt((-(dv**2) + np.sqrt(dv**4 + (b * allowed) ** 2)) / (b**2 / 2))
        return step * np.ceil(exact / step)

    return time


WRONG = {
    "half forgotten": (
        lambda dv, b, allowed: (-dv + math.sqrt(dv**2 + 4 * b * allowed)) / (2 * b),
        "That solves dv·t + b·t² = allowed. The bias makes b·t²/2 metres: its speed grows from nothing to b·t, and on average is half of that.",
    ),
    "only the bias": (
        lambda dv, b, allowed: math.sqrt(2 * allowed / b),
        "That is the bias alone. The wrong speed, which the tram takes into the tunnel, comes on top.",
    ),
    "only the speed": (
        lambda dv, b, allowed: allowed / dv,
        "That is the speed alone. The bias makes the speed wronger all the time.",
    ),
    "the past": (
        lambda dv, b, allowed: (-dv - math.sqrt(dv**2 + 2 * b * allowed)) / b,
        "That is the other root of the parabola: a time before the tunnel. Take the plus sign.",
    ),
    "signs against each other": (
        lambda dv, b, allowed: (dv + math.sqrt(dv**2 + 2 * b * allowed)) / b,
        "Your time solves b·t²/2 − dv·t = allowed, as if speed and bias pulled against each other. Has dv the wrong sign, or is it the other root, with its sign dropped? Take (−dv + √…)/b.",
    ),
    "two times added": (
        lambda dv, b, allowed: allowed / dv + math.sqrt(2 * allowed / b),
        "That is the sum of two times, one for each error alone. The two errors happen at the same time: add the metres, then solve for t.",
    ),
    "the earlier of two": (
        lambda dv, b, allowed: min(allowed / dv, math.sqrt(2 * allowed / b)),
        "That is the earlier of two times, one for each error alone. But both errors act at the same time: add the metres, then solve for t.",
    ),
    "not divided": (
        lambda dv, b, allowed: -dv + math.sqrt(dv**2 + 2 * b * allowed),
        "Nearly: that is b·t, the speed gained meanwhile. Divide by b.",
    ),
    "four under the root": (
        lambda dv, b, allowed: (-dv + math.sqrt(dv**2 + 4 * b * allowed)) / b,
        "Under the root of the formula stands 4 times b/2 times allowed, which is 2 b allowed: the parabola "
        "begins with b/2, not with b.",
    ),
    "two in the denominator": (
        lambda dv, b, allowed: (-dv + math.sqrt(dv**2 + 2 * b * allowed)) / (2 * b),
        "The root is right. Below must stand twice the factor of t². That factor is b/2, so divide by b.",
    ),
    "no time in it": (
        lambda dv, b, allowed: allowed / (dv + b),
        "That is allowed/(dv + b), with the sum of a speed and an acceleration. First make metres of each: dv·t and b·t²/2.",
    ),
    "both squared": (
        lambda dv, b, allowed: math.sqrt(allowed / (dv + b / 2)),
        "That solves dv·t² + b·t²/2 = allowed. The speed error makes dv·t metres; only the bias grows with t².",
    ),
    "both roots": (
        lambda dv, b, allowed: tuple((-dv + side * math.sqrt(dv**2 + 2 * b * allowed)) / b for side in (1, -1)),
        "Two roots; one of them is before the tunnel. Return the one that lies in the future.",
    ),
    "constant speed error": (
        lambda dv, b, allowed: (-dv + math.sqrt(dv**2 + b * allowed)) / b,
        "Nearly: under the root stands 4 times b/2 times allowed, which is 2 b allowed.",
    ),
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
    "minus under the root": (
        lambda dv, b, allowed: (-dv + np.sqrt(abs(dv**2 - 2 * b * allowed))) / b,
        SIGN,
    ),
    "/ 2 * a": (
        lambda dv, b, allowed: (-dv + np.sqrt(dv**2 + 2 * b * allowed)) / 2 * (b / 2),
        "`/ 2 * a` divides by 2 and then multiplies by a: write `/ (2 * a)`.",
    ),
    "whole seconds": (
        whole_seconds,
        "Those are whole seconds, rounded up. The time is no whole number: solve the equation for t.",
    ),
    "the root alone divided": (
        root_of_N,
        "Only the root is divided by b here. All of −dv + root is: put brackets round it.",
    ),
    "dv alone divided": (
        lambda dv, b, allowed: -dv / b + np.sqrt(dv**2 + 2 * b * allowed),
        "Only −dv is divided by b here. All of −dv + root is: put brackets round it.",
    ),
    "metres for seconds": (
        lambda dv, b, allowed: dv * allowed + b * allowed**2 / 2,
        "That is how far the position is wrong after `allowed` seconds, in metres. `allowed` is in metres, and a time is asked for: solve "
        "dv·t + b·t²/2 = allowed for t.",
    ),
    "squares, steps of 0.01 s": (stepped(0.01), SQUARED),
    "squares, steps of 0.001 s": (stepped(0.001), SQUARED),
    "speed for position": (
        lambda dv, b, allowed: (allowed - dv) / b,
        "That solves dv + b·t = allowed: after this time the *speed* is wrong by `allowed`. It is the position "
        "that is asked for: how many metres does each of the two make?",
    ),
    "both accelerations": (
        lambda dv, b, allowed: np.sqrt(2 * allowed / (dv + b)),
        "That solves (dv + b)·t²/2 = allowed, as if dv were an acceleration too. A wrong speed makes metres that "
        "grow with t; only the bias's grow with t².",
    ),
    "minus under the root, NaN where there is none": (
        lambda dv, b, allowed: (-dv + np.sqrt(dv**2 - 2 * b * allowed)) / b,
        SIGN,
    ),
}
