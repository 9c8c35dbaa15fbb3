"""Lesson 27: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np

from kflearn.exercises import _a_ride as ride
from kflearn.exercises._a_ride import REST, moving


def drawn_in():
    low, high = 0.0607, 0.147
    return 0.09 - (0.09 - low) / np.sqrt(41), 0.09 + (high - 0.09) / np.sqrt(41)


def rows_by_median(time, z):
    rows = np.flatnonzero(~np.isnan(z))
    return np.diff(rows) * np.median(np.diff(time))


def at_least_one(time, z):
    steps = np.diff(time[~np.isnan(z)])
    return np.maximum(1, np.round(steps))


def before_and_after(time, z):
    return np.gradient(time[np.isfinite(z)])


def about_the_whole_column(time, z, until):
    s = z[(time < until) & ~np.isnan(z)]
    return np.sum((s - np.nanmean(z)) ** 2) / (len(s) - 1)


def divided_again(time, z, until):
    s = z[(time < until) & ~np.isnan(z)]
    return s.var(ddof=1) / len(s)


def exchanged(time, z, q):
    """The variance at rest stands in Q, and q in S."""
    R = np.nanvar(z[time < ride.REST], axis=0, ddof=1).mean()
    return ride.follow(time, z, R, R=q)


def locked(time, z, q):
    """A reading moves the state the other way."""
    R = np.nanvar(z[time < ride.REST], axis=0, ddof=1).mean()
    x, P, found = np.array([z[0, 0], 0, z[0, 1], 0]), np.kron(np.eye(2), np.diag([R, 9.0])), []
    for k in range(len(z)):
        if k:
            F, Q = ride.moving(time[k] - time[k - 1], q)
            x, P = F @ x, F @ P @ F.T + Q
            y, S = z[k] - ride.H @ x, ride.H @ P @ ride.H.T + R * np.eye(2)
            if y @ np.linalg.solve(S, y) < 13.8:
                K = np.linalg.solve(S, ride.H @ P).T
                x, P = x - K @ y, P - K @ S @ K.T
        found.append((x, P))
    return tuple(np.array(part) for part in zip(*found, strict=True))


def cut_off(time, z, q):
    """No step longer than 3 s."""
    return ride.follow(time, z, q, dt=np.minimum(np.diff(time), 3))


def from_the_last_good_one(time, z, q):
    """A gate by the distance from the last reading that passed it."""
    R = np.nanvar(z[time < ride.REST], axis=0, ddof=1).mean()
    good, last = z.copy(), z[0]
    for k in range(1, len(z)):
        if not np.linalg.norm(z[k] - last) <= 6 * np.sqrt(R):
            good[k] = np.nan
        else:
            last = z[k]
    return ride.follow(time, good, q, R=R, gate=np.inf)


def predictions(time, z, q):
    mean, cov = (part.copy() for part in ride.follow(time, z, q))
    for k in range(len(time) - 1, 0, -1):
        F, Q = moving(time[k] - time[k - 1], q)
        mean[k], cov[k] = F @ mean[k - 1], F @ cov[k - 1] @ F.T + Q
    return mean, cov


def flat(d):
    return [[d**4 / 4, d**3 / 2], [d**3 / 2, d**2]]


def with_(design, **options):
    return lambda *given: design(*given, **options)


def capped(time, z):
    dt = np.diff(time[~np.isnan(z)])
    return np.where(dt > 5 * np.median(dt), np.median(dt), dt)


def interpolated(time, z, q):
    mean = np.zeros((len(z), 4))
    for axis in (0, 1):
        seen = np.isfinite(z[:, axis])
        mean[:, 2 * axis] = np.interp(time, time[seen], z[seen, axis])
    return mean, np.tile(1e4 * np.eye(4), (len(z), 1, 1))


def rows_skipped(time, z, q):
    """One second for each step, and rows without a reading left at zero."""
    seen = np.isfinite(z).all(axis=1)
    mean, cov = np.zeros((len(z), 4)), np.tile(1e3 * np.eye(4), (len(z), 1, 1))
    mean[seen, ::2] = z[seen]
    cov[seen] = np.nanvar(z[time < REST], axis=0).mean() * np.eye(4)
    return mean, cov


def in_mean_steps(time, z):
    kept = time[~np.isnan(z)]
    return np.diff(kept) / ((kept[-1] - kept[0]) / (len(kept) - 1))


RIGHT = [
    ("variance_at_rest", lambda t, z, u: np.nanvar(z[t <= u], ddof=1)),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("interval_of_R", drawn_in(), "drawn in towards 0.09 by a factor √41"),
    ("milliseconds_for_seconds", (np.sqrt(0.1) / 1000**3) ** 2, "q is no σ, so nothing is squared"),
    ("clock", rows_by_median, "one median step after the row before"),
    ("clock", at_least_one, "rounded to whole seconds"),
    ("clock", before_and_after, "One number too many"),
    ("variance_at_rest", about_the_whole_column, "the mean of the *whole* record"),
    ("variance_at_rest", divided_again, "the variance of their *mean*"),
    ("interval_of_R", (0.07, 0.12), "At 95 % both are 2.5 %"),
    ("milliseconds_for_seconds", 3e-10, "becomes 3 times what it was"),
    ("ride", exchanged, "There q belongs; the variance at rest is R"),
    ("ride", locked, "Your state moves away from the readings"),
    ("ride", lambda time, z, q: ride.follow(time, z, 2 * q), "grows by 2 times the Q that belongs there"),
    ("ride", cut_off, "your state moves on for 3 s"),
    ("ride", from_the_last_good_one, "mostly many in a row"),
    ("interval_of_R", (0.061, 0.15), "give three digits"),
    ("interval_of_R", (1 / 1.4836, 1 / 0.6108), "the factors"),
    ("clock", lambda time, z: np.diff(time), "steps between all rows"),
    ("clock", lambda time, z: np.diff(time[z != np.nan]), "NaN differs from everything"),
    ("ride", predictions, "these are the predictions"),
    ("ride", with_(ride.follow, push=flat), "one push which lasts the whole step"),
    ("ride", with_(ride.follow, R=9.47), "Your R is 9.47 m² in all rides"),
    ("ride", with_(ride.follow, dt=1.0), "moves for one second in each step"),
    ("ride", with_(ride.follow, gate=np.inf), "uses readings that are far off"),
    ("ride", with_(ride.follow, gate=3), "of the good readings"),
    ("clock", capped, "shortened to the median"),
    ("ride", interpolated, "Your P is the same in all rows"),
    ("ride", rows_skipped, "they are skipped"),
    ("clock", lambda t, z: np.round(np.diff(t[~np.isnan(z)]), 1), "rounded"),
    ("milliseconds_for_seconds", 1e-8, "1000³ is 10⁹"),
    ("clock", in_mean_steps, "counted in mean steps"),
]
