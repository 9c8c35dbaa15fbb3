"""Functions of the tenth group's wrong answers to exercises of lessons 0 to 10, each with one mistake."""

import numpy as np


def without_dt(dt, mass, c):
    F = np.array([[1, dt - c / (2 * mass)], [0, 1 - c / mass]])
    return F, np.array([[dt**2 / 2], [dt]]) / mass


def implicit(dt, mass, c):
    """The cart whose drag is that of the new velocity."""
    kept = 1 / (1 + c * dt / mass)
    F = np.array([[1, dt * (1 + kept) / 2], [0, kept]])
    return F, np.array([[dt**2 / 2], [dt]]) * kept / mass


def from_the_first(x, y):
    away = np.array([x - x[0], y - y[0]])
    return away @ away.T / len(x)


def centred_in_the_corners(x, y):
    c = np.mean(x * y) - x.mean() * y.mean()
    return np.array([[np.mean(x * x), c], [c, np.mean(y * y)]])


def gain(P, H, R):
    return P @ H.T @ np.linalg.inv(H @ P @ H.T + R)


def corrected(x, P, z, H, R, K=None):
    K = gain(P, H, R) if K is None else K
    return x + K @ (z - H @ x), P - K @ H @ P


def variances_alone(x, P, z, H, R):
    x, P = corrected(x, P, z, H, R)
    return x, np.diag(np.diag(P))


def gain_of_the_new_P(x, P, z, H, R):
    after = corrected(x, P, z, H, R)[1]
    return corrected(x, after, z, H, R)[0], after


def Q_at_the_end(x, P, z, F, H, Q, R):
    x, P = corrected(F @ x, F @ P @ F.T, z, H, R)
    return x, P + Q


def Q_in_the_gain_alone(x, P, z, F, H, Q, R):
    P = F @ P @ F.T
    return corrected(F @ x, P, z, H, R, P @ H.T @ np.linalg.inv(H @ (P + Q) @ H.T + R))


def against_the_reading(vx, vz):
    S = vx + vz
    return S / vz, vz / S, S**2 / (vx * vz)


def stopped_early(Q, R):
    """The recursion until the gain changes by 0.01 or less."""
    P, old, K = R, 0, 1
    while abs(K - old) > 0.01:
        old, K = K, (P + Q) / (P + Q + R)
        P = K * R
    return K


def in_whole_numbers(Q, R):
    q = Q // R
    return (np.sqrt(q**2 + 4 * q) - q) / 2


def growing_faster(away, P, Q, R):
    """The first n at which P + (1 + 2 + … + n) Q + R is enough."""
    rest = (away**2 / 9 - P - R) / Q
    return np.ceil((np.sqrt(1 + 8 * rest) - 1) / 2)


def corners_moved_first(P, Q, dt):
    F, M = np.array([[1, dt], [0, 1]]), P.copy()
    M[[0, 1], [1, 0]] += dt * P[1, 1]
    right = F @ P @ F.T + Q
    return np.array([[(F @ M @ F.T + Q)[0, 0], right[0, 1]], right[1]])


def one_side_wrapped(old, z, width):
    y = old - z
    return np.sum(abs(np.where(y > 180, y - 360, y)) <= width)


def Q_after_the_correction(x, P, room, reading, Q, R):
    K = P / (P + R)
    return x + K * (reading - x), np.sqrt(K * R + Q)


def filtered(z, Q, R, x, P, shrinks=True):
    """The room's filter from a start (x, P) over z[1:]; or one whose P shrinks at the end only."""
    for reading in z[1:]:
        P = P + Q
        K = P / (P + R)
        x, P = x + K * (reading - x), P * (1 - K) if shrinks else P
    return x, P if shrinks else (1 - K) * P


def over_all_moments(x, z, mean, ignored, cov):
    up = x[:, 0] > 0
    errors = [np.sqrt(np.sum((each - x)[up, 0] ** 2) / len(x)) for each in (mean, ignored)]
    return *errors, np.sqrt(cov[up][-1, 1, 1])
