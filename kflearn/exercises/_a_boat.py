"""Recordings for the open exercise of lesson 26: a boat among false readings; and designs."""

import numpy as np

from kflearn import Gaussian, boats, nearest_filter, pda_filter, scan_targets, simulate
from kflearn.exercises._results import shape_of, unlike

STEPS, DETECTION = 60, 0.9
LOST = 40.0  # m


PLANE = boats.plane()


def recording(rng):
    """Scans (60, N, 2) of a boat, a start that is not exact, and λ; the truth is (60, 2)."""
    true = np.array([0.0, rng.choice([-1, 1]) * rng.uniform(4, 8), 0.0, rng.uniform(-6, 6)])
    x = simulate(boats.plane(rng.uniform(0.4, 0.6)), true, STEPS, rng=rng).x
    low, high = x[:, [0, 2]].min(axis=0) - 100, x[:, [0, 2]].max(axis=0) + 100
    clutter = float(np.round(rng.uniform(6e-4, 9e-4), 6))
    scans = scan_targets(PLANE, x[:, None], DETECTION, clutter, np.stack([low, high], axis=1), rng)
    start = np.round(true + rng.normal(0, [5, 1, 5, 1]), 1)
    return (scans.z, start, clutter), x[:, [0, 2]]


def places(answer, truth):
    """A form: a position (60, 2) for each scan."""
    if shape_of(answer) == (STEPS, 4):
        return "holds whole states, x, v_x, y, v_y: the positions alone are wanted, columns 0 and 2"
    return unlike(answer, truth.shape)


def off(answer, truth):
    """The distance (60,) from the boat."""
    return np.linalg.norm(np.asarray(answer, float) - truth, axis=-1)


def lost_share(answers, truths):
    """In how many per cent of the recordings the boat is lost at the end."""
    return 100 * np.mean([np.median(off(a, t)[-5:]) > LOST for a, t in zip(answers, truths, strict=True)])


def typical(answers, truths):
    """The rms error of the middle recording."""
    return np.median([np.sqrt(np.mean(off(a, t) ** 2)) for a, t in zip(answers, truths, strict=True)])


def not_exact(answers, recordings):
    """What to look at where the error is too large."""
    truths = [truth for _, truth in recordings]
    if lost_share(answers, truths) > 50:
        return "The boat is lost in most recordings, and so in the middle one. Look at that first."
    return "The boat is found, but not exactly: is every reading in the gate counted by its weight, and does the gain come from S?"


# ---- designs


def belief(start):
    return Gaussian(start, np.diag([25.0, 1, 25, 1]))


def pda(acceleration=0.5, gate=0.99, factor=1.0, sigma=5.0, detection=DETECTION):
    """The lesson's PDA, with its numbers chosen anew."""

    def follow(z, start, clutter):
        model = boats.plane(acceleration, sigma)
        track = pda_filter(model, z, belief(start), detection=detection, clutter=factor * clutter, gate=gate)
        return track.mean[:, [0, 2]]

    return follow


def nearest(acceleration=0.5, gate=0.99):
    def follow(z, start, clutter):
        return nearest_filter(boats.plane(acceleration), z, belief(start), gate=gate).mean[:, [0, 2]]

    return follow


def coasting(z, start, clutter):
    """No reading at all."""
    k = np.arange(1, len(z) + 1)[:, None]
    return start[[0, 2]] + k * start[[1, 3]]


def hopping(z, start, clutter):
    """From each place to the nearest reading."""
    place, found = start[[0, 2]], []
    for scan in z:
        place = scan[np.nanargmin(np.linalg.norm(scan - place, axis=-1))]
        found.append(place)
    return np.array(found)


def middle(z, start, clutter):
    """The mean of all readings of a scan."""
    return np.nanmean(z, axis=1)


def by_hand(z, start, clutter):
    """The PDA written out, with a gate of 4 standard deviations."""
    F, H, Q, R = PLANE.F, PLANE.H, PLANE.Q, PLANE.R
    x, P, found = start, np.diag([25.0, 1, 25, 1]), []
    for scan in z:
        x, P = F @ x, F @ P @ F.T + Q
        S = H @ P @ H.T + R
        K = P @ H.T @ np.linalg.inv(S)
        y = scan[~np.isnan(scan).any(axis=1)] - H @ x
        nis = np.einsum("ij,jk,ik->i", y, np.linalg.inv(S), y)
        y, nis = y[nis < 16], nis[nis < 16]
        b = clutter * 2 * np.pi * np.sqrt(np.linalg.det(S)) * (1 - DETECTION) / DETECTION
        weight = np.append(b, np.exp(-nis / 2)) / (b + np.exp(-nis / 2).sum())
        pull = weight[1:] @ y
        spread = (weight[1:, None] * y).T @ y - np.outer(pull, pull)
        P = P - (1 - weight[0]) * K @ S @ K.T + K @ spread @ K.T
        x = x + K @ pull
        found.append(x[[0, 2]])
    return np.array(found)


PASSING = {"PDA": pda(), "PDA, more nimble": pda(0.7), "PDA, a wide gate": pda(gate=0.999), "PDA by hand": by_hand}
FAILING = {
    "the nearest reading": nearest(),
    "the nearest, a wide gate": nearest(0.7, 0.999),
    "from reading to reading": hopping,
    "no readings": coasting,
    "the mean of all readings": middle,
    "a boat that goes straight on": pda(0.02),
    "one place for all": lambda z, start, clutter: np.tile(start[[0, 2]], (len(z), 1)),
}
