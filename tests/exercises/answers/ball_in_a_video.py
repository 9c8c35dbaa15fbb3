"""Lesson 19: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np

from kflearn.exercises import _thrown_ball as ball
from kflearn.exercises._thrown_ball import KICK, motion

H = np.eye(2, 4)

inv = np.linalg.inv


def tracker(z, g, q, R, order=(0, 1, 2, 3), early=False, push=1.0, sign=1.0, shrink=1.0, at=None):
    """A tracker for the ball of lesson 19 with parts that may be wrong."""
    F, up = ball.motion(g)
    x, P, rows = np.array([*(z[0] if at is None else at), 0, 0]), np.diag([R, R, 1e4, 1e4]), []
    rows.append((x, P))
    for seen in z[1:]:
        x, P = F @ x + push * up, F @ P @ F.T + q * ball.KICK
        ahead = x, P
        y, S = seen - H @ x, H @ P @ H.T + R * np.eye(2)
        if y @ inv(S) @ y < 11.8:
            K = P @ H.T @ inv(S)
            x, P = x + sign * K @ y, P - shrink * K @ S @ K.T
        rows.append(ahead if early else (x, P))
    mean, cov = (np.array(part) for part in zip(*rows, strict=True))
    return mean[:, order], cov[:, order][:, :, order]


def with_(design, **options):
    return lambda *given: design(*given, **options)


def with_a_floor(z, g, q, R):
    (F, up), H = motion(g), np.eye(2, 4)
    x, P, rows = np.array([*z[0], 0, 0]), np.diag([R, R, 1e4, 1e4]), []
    rows.append((x, P))
    for seen in z[1:]:
        x, P = F @ x + up, F @ P @ F.T
        P = P + (900 if x[1] > 210 else q) * KICK
        y, S = seen - H @ x, H @ P @ H.T + R * np.eye(2)
        if y @ inv(S) @ y < 11.8:
            K = P @ H.T @ inv(S)
            x, P = x + K @ y, P - K @ S @ K.T
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def detections(z, g, q, R):
    mean = np.zeros((len(z), 4))
    mean[:, :2] = np.nan_to_num(z)
    return mean, np.tile(1e6 * np.eye(4), (len(z), 1, 1))


def within(size):
    return lambda rows: 0 if np.all(abs(np.array(rows) - 210) < size) else 6


def recognised(rows):
    return 0 if abs(np.median(rows) - 210) < 1 else 6


def other_side(p, s, R, y):
    F = np.array([[1, 1], [0, 1]])
    P = F.T @ np.diag([p, s]) @ F
    return P[1, 0] / (P[0, 0] + R) * y


def place_too(p, s, R, y):
    F = np.array([[1, 1], [0, 1]])
    P = F @ np.diag([p, s]) @ F.T
    return P[:, 0] / (P[0, 0] + R) * y


RIGHT = [
    ("gravity", within(1)),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("gravity", lambda rows: 0 if np.all(abs(rows - 210) <= 1) else 6, "only if it is *less* than 1 px away"),
    ("thrown_ball", lambda *given: ball.follow(*given, gate=400), "the detections of something else"),
    ("coast", lambda x, P, F, push, Q: (F @ x + push, 1e4 * np.eye(len(x))), "threw P away"),
    ("first_velocity", lambda p, s, R, y: s * y / (p + s + R**2), "right for R²"),
    ("thrown_ball", with_(tracker, early=True), "these are the predictions"),
    ("thrown_ball", with_(tracker, order=[0, 2, 1, 3]), "In another order of your states"),
    ("thrown_ball", with_(tracker, push=0), "Gravity is missing"),
    ("thrown_ball", with_(tracker, push=0.3), "your state is pushed by"),
    ("thrown_ball", with_(ball.follow, kick=np.diag([3, 3, 1, 1])), "P grows by"),
    ("thrown_ball", with_(tracker, sign=-1), "moves away from the detection"),
    ("thrown_ball", with_(tracker, shrink=0), "P stays as it was predicted"),
    ("thrown_ball", with_(tracker, at=(0, 0)), "px from the first detection"),
    ("thrown_ball", with_(ball.follow, given=64.0), "times the R that is given"),
    ("thrown_ball", with_(ball.follow, wide=0.01), "No start is given"),
    ("thrown_ball", lambda *given: tuple(part[1:] for part in tracker(*given)), "has 43 rows for 44 readings"),
    ("coast", lambda x, P, F, push, Q: (np.zeros(4), F @ P @ F.T + Q), "though the ball flies on"),
    ("thrown_ball", with_a_floor, "there is no floor"),
    ("first_velocity", lambda p, s, R, y: np.sqrt(p * s) / (p + s + R) * y, "On top you have √(p·s)"),
    ("gravity", lambda rows: 0 if min(rows) > 209 else 6, "as if only `min(rows) > 209` were asked"),
    ("thrown_ball", detections, "Your P is the same in all frames"),
    ("gravity", within(0.9), ""),
    ("gravity", within(1.1), ""),
    ("gravity", within(2), "1.5 px off"),
    ("gravity", recognised, "A median near the floor"),
    ("thrown_ball", lambda *given: ball.follow(*given, kick=np.eye(4)), "on its diagonal"),
    ("thrown_ball", ball.FAILING["σ for R"], "take no root"),
    ("first_velocity", other_side, "what Fᵀ P F makes"),
    ("first_velocity", place_too, "corrections of place and velocity"),
]
