"""Lesson 11: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np

from kflearn.exercises import _cart_with_gaps as cart
from tests.exercises.hand_in import asked


def on_the_diagonal(z0, z1, dt, R):
    return np.array([z1, (z1 - z0) / dt]), np.array([[R, R / dt], [R / dt, np.sqrt(2 * R) / dt]])


def named(exercise, *names):
    """The right values under names of their own."""
    return lambda *given: dict(zip(names, asked(exercise)._solve(*given), strict=True))


DICTIONARY = "The values are right, but the result is a dictionary: return the values one after the other"


def anew_after_a_gap(z, dt, sd, sigma):
    (F, Q), first, gap = cart.motion(dt, sd), np.diag([sigma**2, 9.0]), False
    x, P = np.array([z[0], 0.0]), first
    rows = [(x, P)]
    for reading in z[1:]:
        x, P = F @ x, F @ P @ F.T + Q
        if np.isnan(reading):
            gap = True
        elif gap:
            x, P, gap = np.array([reading, 0.0]), first, False
        else:
            K = P[:, 0] / (P[0, 0] + sigma**2)
            x, P = x + K * (reading - x[0]), P - np.outer(K, P[0])
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def one_Q(z, dt, sd, sigma):
    return cart.run(
        z, cart.motion(dt, sd)[0], np.diag([0.005, 0.01]), sigma**2, np.array([z[0], 0]), np.diag([sigma**2, 9])
    )


def no_squares(z, dt, sd, sigma):
    start = np.array([z[0], 0]), np.diag([sigma, 9])
    return cart.run(z, cart.motion(dt, sd)[0], cart.motion(dt, sd)[1] / sd, sigma, *start)


def two_fixes(z0, z1, dt, R):
    return np.array([z1, (z1 - z0) / dt]), R * np.array([[1, 1 / dt], [1 / dt, 2 / dt**2]])


def cart_in_gaps(wait=False, dt_in_F=True):
    def follow(z, dt, sd, sigma):
        F, Q = cart.motion(dt if dt_in_F else 1.0, sd)
        x, P = np.array([z[0], 0]), np.diag([sigma**2, 9])
        rows = [(x, P)]
        for reading in z[1:]:
            if not (wait and np.isnan(reading)):
                x, P = cart.run([0, np.nan], F, Q, 1, x, P)
                x, P = x[1], P[1]
            if np.isfinite(reading):
                K = P[:, 0] / (P[0, 0] + sigma**2)
                x, P = x + K * (reading - x[0]), P - np.outer(K, P[0])
            rows.append((x, P))
        return tuple(np.array(part) for part in zip(*rows, strict=True))

    return follow


def four_steps(z, dt):
    return np.append(np.full(5, np.nan), (z[5:] - z[:-5]) / (4 * dt))


def at_the_first(z0, z1, dt, R):
    return [z0, (z1 - z0) / dt], [[R, -R / dt], [-R / dt, 2 * R / dt**2]]


def report(errors):
    return np.mean(errors, axis=0), np.sqrt(np.mean(np.hypot(errors[:, 0], errors[:, 1])))


def dt_once(z0, z1, dt, R):
    return np.array([z1, (z1 - z0) / dt]), np.array([[R, R], [R, 2 * R / dt]])


def one_step_further(z0, z1, dt, R):
    v = (z1 - z0) / dt
    return np.array([z1 + v * dt, v]), np.array([[5 * R, 3 * R / dt], [3 * R / dt, 2 * R / dt**2]])


def first_twice(z, dt, sd, sigma):
    """A start at z[0] with P = I, and a filter over all of z."""
    again = np.append(z[0], z)
    means, covs = cart.run(again, *cart.motion(dt, sd), sigma**2, np.array([z[0], 0]), np.eye(2))
    return means[1:], covs[1:]


def differences(z, dt, sd, sigma):
    z = np.nan_to_num(z)
    return np.stack([z, np.gradient(z, dt)], axis=1), np.tile(np.eye(2), (len(z), 1, 1))


def cart_with(Q=None, P=None):
    def follow(z, dt, sd, sigma):
        start = np.diag([sigma**2, 9]) if P is None else P
        F, right = cart.motion(dt, sd)
        return cart.run(z, F, right if Q is None else Q(dt, sd), sigma**2, np.array([z[0], 0]), start)

    return follow


def middle_of_the_lesson(low, high, believed):
    return (high - low) ** 2 / 12 + (10 - believed) ** 2


def half_the_range(low, high, believed):
    a = (high - low) / 2
    return a**2 / 12 + ((low + high) / 2 - believed) ** 2


def typed_dt(z, dt, sd, sigma):
    dt = 0.1
    F = np.array([[1, dt], [0, 1]])
    B = np.array([dt**2 / 2, dt])
    Q = sd**2 * np.outer(B, B)
    R = sigma**2
    x, P = np.array([z[0], 0.0]), np.diag([sigma**2, 9.0])
    means, covs = [x], [P]
    for reading in z[1:]:
        x, P = F @ x, F @ P @ F.T + Q
        if not np.isnan(reading):
            K = P[:, 0] / (P[0, 0] + R)
            x = x + K * (reading - x[0])
            P = P - np.outer(K, P[0])
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)


RIGHT = [
    ("start_variance", lambda a, b, c: np.mean((np.linspace(a, b, 20001) - c) ** 2)),
    ("cart_with_gaps", cart.white(1)),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("data_sheet", 2 * (6 / 1.18) ** 2, "both axes together"),
    ("data_sheet", 6 / 1.18**2, "with the 6 m not squared", "too low"),
    ("two_point_start", on_the_diagonal, "P holds its square, the variance", "was expected"),
    ("report", named("train_and_ship.report", "mean", "RMS"), DICTIONARY),
    ("report", lambda errors: {"mean": 1, "RMS": 2}, "The result is a dictionary"),
    ("cart_with_gaps", anew_after_a_gap, "At the first reading after a gap you start anew"),
    ("cart_with_gaps", one_Q, "the same Q in every recording"),
    ("cart_with_gaps", no_squares, "its square is wanted, there and for R"),
    ("start_variance", lambda a, b, c: (b - a) ** 2 / 16 + ((a + b) / 2 - c) ** 2, "a quarter of"),
    ("data_sheet", 36 / 1.18, "with the 1.18 not squared"),
    ("data_sheet", 4.5, "twice the rms distance"),
    ("two_point_start", lambda *given: two_fixes(*given)[0], "Return value 2 as well"),
    ("two_point_start", lambda z0, z1, dt, R: two_fixes(z0, z1, dt, R**2), "R squared, in place of R"),
    ("cart_with_gaps", cart.without_corners, "no corners", "how does Q"),
    ("cart_with_gaps", cart.twice, "used twice", "how does Q"),
    ("cart_with_gaps", cart.FAILING["speed variance 3"], "square it", "how does Q"),
    ("cart_with_gaps", cart_in_gaps(wait=True), "your filter waits", "P is smaller"),
    ("cart_with_gaps", cart_in_gaps(dt_in_F=False), "does F contain dt", "how does Q"),
    ("running_average", four_steps, "five differences"),
    ("data_sheet", (6 * 1.18) ** 2, "divide, then square"),
    ("data_sheet", (6 / 2.45) ** 2, "95 % of the fixes"),
    ("two_point_start", at_the_first, "right there"),
    ("report", report, "the root of the mean distance"),
    ("two_point_start", dt_once, "one division by dt is missing in the corners"),
    ("two_point_start", one_step_further, "the belief one dt after the second fix"),
    ("cart_with_gaps", first_twice, "used twice: start there without one"),
    ("cart_with_gaps", differences, "same at every reading, gaps included"),
    ("cart_with_gaps", differences, "NaN has become 0"),
    ("cart_with_gaps", cart.white(0), "white noise", "start's P"),
    (
        "cart_with_gaps",
        cart_with(lambda dt, sd: sd**2 * np.outer([dt / 2, 1], [dt / 2, 1])),
        "lacks a factor",
        "start's P",
    ),
    ("cart_with_gaps", cart_with(lambda dt, sd: cart.motion(dt, 1)[1] * sd), "sd times G Gᵀ", "start's P"),
    ("cart_with_gaps", cart_with(P=np.eye(2)), "first reading is too small", "Is Q, R"),
    ("cart_with_gaps", cart.FAILING["gaps filled with zeros"], "your P is smaller", "Is Q, R"),
    ("start_variance", middle_of_the_lesson, "that of the lesson"),
    (
        "running_average",
        lambda z, dt: [None] * min(5, len(z)) + list((z[5:] - z[:-5]) / (5 * dt)),
        "None at [0]; NaN is `np.nan`",
    ),
    ("start_variance", half_the_range, "You took half of the width"),
    ("cart_with_gaps", typed_dt, "the way of 0.1 s", "NaN taken for a number"),
]
