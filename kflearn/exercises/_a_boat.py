"""Recordings for the open exercise of lesson 26: a boat among false readings; and designs."""

import re

import numpy as np

from kflearn import Gaussian, boats, nearest_filter, pda_filter, scan_targets, simulate
from kflearn.exercises import _code_of

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
    shape = np.shape(answer)
    if shape == (STEPS, 4):
        return "holds whole states, x, v_x, y, v_y: the positions alone are wanted, columns 0 and 2"
    return None if shape == truth.shape else f"should be of shape {truth.shape}, but is {shape}"


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


# ---- what an answer looks like


def used_none(answer, answers, recordings):
    straight = [np.allclose(np.diff(a, n=2, axis=0), 0, atol=1e-9) for a in answers]
    return "Your positions lie on a straight line: no reading has changed them." if all(straight) else None


def is_a_reading(answer, answers, recordings):
    hits = [
        (np.linalg.norm(z - np.asarray(a)[:, None], axis=-1) < 1e-9).any(axis=1).mean()
        for a, ((z, _, _), _) in zip(answers, recordings, strict=True)
    ]
    if np.mean(hits) > 0.9:
        return "Nearly every position that you return is one of the readings. A false one then moves the boat as far as it likes: predict, and correct by a gain."
    return None


def is_the_mean(answer, answers, recordings):
    means = [np.allclose(a, np.nanmean(z, axis=1)) for a, ((z, _, _), _) in zip(answers, recordings, strict=True)]
    return "You return the mean of all readings of a scan. Most of them are false." if all(means) else None


def other_columns(answer, answers, recordings):
    """The boat's x, and something else for y; or y first."""
    error = np.median(
        [np.sqrt(np.mean((np.asarray(a) - t) ** 2, axis=0)) for a, (_, t) in zip(answers, recordings, strict=True)],
        axis=0,
    )
    turned = [
        np.sqrt(np.mean((np.asarray(a)[:, ::-1] - t) ** 2)) for a, (_, t) in zip(answers, recordings, strict=True)
    ]
    if np.median(turned) < 8 < error.min():
        return "Your columns are y and x. Wanted are x and y, in this order."
    if error[0] < 8 and error[1] > 25:
        return "Your first column follows x, but the second one is not y. The state is x, v_x, y, v_y: take its columns 0 and 2."
    return None


OTHER_H = r"replace\([^)]*H *=[^)]*(eye\(2, *4|\[\[1\.?0?, *0\.?0?, *0\.?0?, *0\.?0?\], *\[0\.?0?, *1)"


def observed(answer, answers, recordings):
    """The lesson's model with another H."""
    if re.search(OTHER_H, _code_of.text_of(answer) or ""):
        return "Your H reads the numbers 0 and 1 of the state, x and v_x. The state is x, v_x, y, v_y: H must pick 0 and 2, and so must what you return."
    return None


def small_gate(answer, answers, recordings):
    """A gate that refuses the boat's own readings."""
    found = re.search(r"pda_filter\(.*?gate *= *(0?\.\d+)", _code_of.text_of(answer) or "", re.DOTALL)
    if found and float(found[1]) < 0.97:
        part = 100 - 100 * float(found[1])
        return f"Your gate is too small: it refuses {part:.3g} of 100 of the boat's own readings. The weights keep false ones low, so the gate can be wide: 0.99."
    return None


def takes_the_nearest(answer, answers, recordings):
    """The lesson's filter of the nearest reading."""
    if "nearest_filter(" in (_code_of.text_of(answer) or ""):
        return "Your filter takes the nearest reading for the boat's, and cannot know when it is led away. Weigh all that are in the gate. And Q must be large enough for a boat that turns."
    return None


SIGNS = (used_none, is_the_mean, is_a_reading, other_columns, observed, takes_the_nearest, small_gate)
