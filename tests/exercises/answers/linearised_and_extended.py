"""Lesson 13: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np

from kflearn import angle_difference
from kflearn.exercises import _radar as radar
from kflearn.exercises._radar import F, Q, R, against, converted, extended


def on_its_side(r, angle, sd_r, sd_angle):
    """A row for each reading, so J is transposed."""
    J = np.array([[np.cos(angle), np.sin(angle)], [-r * np.sin(angle), r * np.cos(angle)]])
    return J @ np.diag([sd_r**2, sd_angle**2]) @ J.T


def wide_R(*given):
    return radar.extended(*given, R=np.diag([100, 0.02**2]))


def numerator_only(x):
    r, turn = np.hypot(x[0], x[2]), x[2] * x[1] - x[0] * x[3]
    return np.array([[x[0] / r, 0, x[2] / r, 0], [x[2] * turn / r**3, x[0] / r, x[3] / r, x[2] / r]])


def in_degrees(r, angle, sd_r, sd_angle):
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    J = np.array([[c, -r * s], [s, r * c]])
    return J @ np.diag([sd_r**2, sd_angle**2]) @ J.T


def deviation_for_R(x, P, reading, nominal):
    H = nominal / np.hypot(nominal, 20)
    K = P * H / (H * P * H + 2)
    return x + K * (reading - np.hypot(nominal, 20) - H * (x - nominal)), (1 - K * H) * P


def joseph(z, mean, cov):
    """The extended filter in another form."""
    x, P, rows = mean, cov, []
    for reading in z:
        x, P = F @ x, F @ P @ F.T + Q
        y, H = against(reading, x, wrap=True)
        K = np.linalg.solve(H @ P @ H.T + R, H @ P).T
        x, P = x + K @ y, (np.eye(4) - K @ H) @ P @ (np.eye(4) - K @ H).T + K @ R @ K.T
        rows.append((x, P))
    return [x for x, _ in rows], [P for _, P in rows]


def never_corrected(z, mean, cov):
    x, P, means, covs = mean, cov, [], []
    for reading in z:
        x, P = F @ x, F @ P @ F.T + Q
        y, H = against(reading, x, wrap=True)
        x = x + P @ H.T @ np.linalg.solve(H @ P @ H.T + R, y)
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)


def predictions(z, mean, cov):
    means, covs = extended(z, mean, cov)
    return np.vstack([F @ mean, means[:-1] @ F.T]), np.stack([F @ P @ F.T + Q for P in (cov, *covs[:-1])])


def another_order(z, mean, cov):
    means, covs = extended(z, mean, cov)
    return means[:, [0, 2, 1, 3]], covs[:, [0, 2, 1, 3]][:, :, [0, 2, 1, 3]]


def written_out(difference):
    """The extended filter as a learner writes it, with a difference of two bearings of their own."""

    def follow(z, mean, cov):
        x, P, means, covs = mean, cov, [], []
        for reading in z:
            x, P = F @ x, F @ P @ F.T + Q
            r = np.hypot(x[0], x[2])
            H = np.array([[x[0] / r, 0, x[2] / r, 0], [-x[2] / r**2, 0, x[0] / r**2, 0]])
            y = np.array([reading[0] - r, difference(reading[1], np.arctan2(x[2], x[0]))])
            K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
            x, P = x + K @ y, (np.eye(4) - K @ H) @ P
            means.append(x)
            covs.append(P)
        return np.array(means), np.array(covs)

    return follow


remainder_of_a_turn = written_out(lambda read, expected: (read - expected) % (2 * np.pi))
turned_innovation = written_out(lambda read, expected: angle_difference(expected, read, 2 * np.pi))


RIGHT = [
    ("widest_belief", np.sqrt(402**2 - 400**2)),
    ("range_and_bearing", joseph),
    ("range_and_bearing", converted),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("into_the_plane", on_its_side, "either the factors are exchanged, or your J"),
    ("widest_belief", 0.005, "0.005 m is the sag of a belief 2 m wide"),
    ("range_and_bearing", wide_R, "R were diag(100, 0.0004)"),
    ("widest_belief", np.sqrt(2 * 400), "has only one of them"),
    ("widest_belief", 2**2 / 800, "a belief 2 m wide"),
    ("mended_slope", numerator_only, "the numerator alone"),
    ("into_the_plane", lambda r, a, sd_r, sd_a: np.diag([sd_r**2, (r * sd_a) ** 2]), "turned against"),
    ("into_the_plane", in_degrees, "in radians already"),
    ("linearised_correction", deviation_for_R, "your R is 2"),
    ("range_and_bearing", never_corrected, "Your P only grows"),
    ("range_and_bearing", predictions, "these are the predictions"),
    ("range_and_bearing", another_order, "in another order"),
    ("range_and_bearing", radar.raw, "Those are the raw readings"),
    ("widest_belief", np.sqrt(400 / 2), "both factors 2 multiply"),
    ("widest_belief", 20, "From σ²/(2 · 400 m) = 2 m follows"),
    ("widest_belief", np.sqrt(2 * 400**2 * 2), "a sag of σ²/(2d²)"),
    ("widest_belief", 2 * np.sqrt(2 * 400 * 2), "from −σ to +σ"),
    ("range_and_bearing", remainder_of_a_turn, "nearly 2π"),
    ("range_and_bearing", turned_innovation, "or the bearing's innovation is expected minus read"),
]
