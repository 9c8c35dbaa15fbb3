"""What is said of trackers that do not pass the open exercise of lesson 19, where the mistake can be recognised."""

import re

import numpy as np

from kflearn.exercises import _code_of, _scenes
from kflearn.exercises._inside import added, another_order, predictions, recognised, same_P, share
from kflearn.exercises._judge import pair
from kflearn.exercises._thrown_ball import KICK, H, motion
from kflearn.exercises._thrown_ball_seen import (
    BY_AXIS,
    MARKS,
    F,
    dark,
    facts,
    gravity_right,
    in_the_dark,
    is_filter,
    scenes,
)


def stands_still(answer, answers, recordings):
    """Nothing at all is done in a frame without a detection."""
    means = [pair(a)[0] for a in answers]
    if all(np.array_equal(m[1:][dark(r)], m[:-1][dark(r)]) for m, r in zip(means, recordings, strict=True)):
        return (
            "In a frame without a detection your state stays as it was. The ball flies on: predict in every frame, and "
            "correct only where there is a detection."
        )
    held = [pair(a)[1] for a in answers]
    if all(np.array_equal(P[1:][dark(r)], P[:-1][dark(r)]) for P, r in zip(held, recordings, strict=True)):
        return "In a frame without a detection your P stays as it was. Predict P in every frame: it grows there."
    return None


def gravity(answer, answers, recordings):
    """What pushes the state where nothing is seen."""
    g = np.array([inputs[1] for inputs, _ in recordings])[:, None]
    found = in_the_dark(answers, recordings)[0]
    table = [(g * np.array(push), words) for push, words in PUSHES]
    table.append(([np.array([0, 3.0, 0, 6.0])] * len(g), "Your gravity is the lesson's, 6 px/frame². Here g is given."))
    if words := recognised(found, table, 100 * g[:, 0] ** 0):
        return words
    if all(
        np.allclose(push, up, rtol=1e-6, atol=1e-6) for push, up in zip(found, g * np.array(PUSHES[0][0]), strict=True)
    ):
        return None
    if steady(answers, recordings, BY_AXIS):
        return (
            "Your F moves the first state by the second. Here they are column and row; the velocities come after them."
        )
    if steady(answers, recordings, F):
        return (
            f"In a frame without a detection your state is pushed by {np.round(found[0], 2).tolist()}, where g is "
            f"{g[0, 0]:.2f} px/frame². Gravity moves the row by g/2 in a frame, and its velocity by g."
        )
    return None


def steady(answers, recordings, moves):
    """Whether the same is added to the state in all frames without a detection of a recording."""
    pushes = [added(*pair(a), moves)[0][dark(r)] for a, r in zip(answers, recordings, strict=True)]
    return all(np.ptp(push, axis=0).max() < 1e-6 for push in pushes)


PUSHES = [
    ([0, 0.5, 0, 1], None),
    ([0, 0, 0, 0], "Gravity is missing in the frames without a detection: there your state moves without any push."),
    ([0, 0, 0, 1], "Your gravity changes the velocity only. Within the frame it moves the row as well, by g/2."),
    (
        [0, 0.5, 0, 0],
        "Your gravity moves the row and leaves its velocity as it was. The velocity grows by g in a frame.",
    ),
    (
        [0, 1, 0, 1],
        "Your gravity moves the row by g in a frame. The velocity grows during the frame: the row moves by g/2.",
    ),
    ([0, -0.5, 0, -1], "Your gravity points upwards. Rows grow downwards, and so does the push: its sign is plus."),
    ([0.5, 0, 1, 0], "Your gravity pushes the column. The row is the second state, its velocity the fourth."),
    ([0.5, 0.5, 1, 1], "Your gravity pushes column and row. Only the row falls."),
    ([0, 0.5, 1, 0], "Your gravity pushes the wrong velocity: that of the row is the fourth state."),
    ([0, 0, 0.5, 1], "Your push is laid out for another order: column, row, and then their velocities."),
    ([0, 1, 0, 2], "Your push is twice what the g that is given makes. Is the state pushed twice in a frame?"),
]


def kicks(answer, answers, recordings):
    """What is added to P where nothing is seen."""
    q = np.array([inputs[2] for inputs, _ in recordings])[:, None, None]
    table = [(q * kick, words) for kick, words in KICKS]
    for other, words in (
        (q**2, "q squared"),
        (q**0.5, "the root of q"),
        (q**0, "1 for q"),
        (0.01 + 0 * q, "the lesson's 0.01 for q"),
    ):
        table.append((other * KICK, f"Your Q is the right matrix, but with {words}. q is the variance that is given."))
    found = in_the_dark(answers, recordings)[1]
    words = recognised(found, table, q[:, 0, 0])
    if words or not is_filter(answers, recordings) or np.allclose(found, q * KICK, rtol=1e-3, atol=1e-6):
        return words
    return (
        f"In a frame without a detection your P grows by {np.round(found[0], 2).tolist()} beyond F P Fᵀ, where q is {q[0, 0, 0]:g}. "
        "It should grow by q times the lesson's matrix."
    )


EACH = np.eye(2)
FLAT = np.kron([[0.25, 0.5], [0.5, 1]], EACH)
KICKS = [
    (KICK, None),
    (0 * KICK, "In frames without a detection your P becomes F P Fᵀ, as if the air gave no kick: Q is missing there."),
    (np.eye(4), "Your Q is q on its diagonal. A kick to the velocity moves the place by less, and the two are correlated: Q is q times the lesson's matrix."),
    (np.diag(np.diag(KICK)), "Your Q lacks its corners. A kick moves place and velocity together, which is q/2 between the two."),
    (np.diag([0, 0, 1, 1]), "Your Q holds the velocities only. A kick moves the place within the frame as well: Q is q times the lesson's matrix."),
    (FLAT, "Your Q is that of one push a frame. Here the kicks come all the time: q/3 for the place, as in the lesson's matrix."),
    (np.kron(EACH, [[1 / 3, 1 / 2], [1 / 2, 1]]), "Your Q is laid out for another order of the states: column, row, and then their velocities."),
]  # fmt: skip


def trusts(answer, answers, recordings):
    """The R of the corrections."""
    R = np.array([inputs[3] for inputs, _ in recordings])
    found = [np.median(u[good & np.isfinite(u)]) for u, good in zip(*facts(answers, recordings)[:2], strict=True)]
    table = [
        (R, None),
        (R**2, "A detection makes your P smaller as with R². R is a variance already, in px²: do not square it."),
        (R**0.5, "A detection makes your P smaller as with √R. R is the variance itself, in px²: take no root."),
        (0 * R + 0.05**2, "Your P shrinks as with the lesson's R, 0.05² px². This detector is coarser: R is given."),
        (0 * R + 1, "A detection makes your P smaller as with R = 1. R is given, in px²."),
        (2 * R, "A detection makes your P smaller as with 2 R. R is the variance of each axis by itself."),
        (R / 2, "A detection makes your P smaller as with R/2. R is the variance of each axis: is it used twice?"),
    ]
    words, ratio = recognised(found, table, R), np.median(found / R)
    if words or 0.99 < ratio < 1.01 or not np.isfinite(ratio):
        return words
    return (
        f"A detection makes your P smaller as if R were {ratio:.3g} times the R that is given (median of the recordings): look at R in S, at the P in "
        "the gain, and at the line that corrects P."
    )


def begins(answer, answers, recordings):
    """The start, which shows in what is refused of the first ten detections."""
    used, good, _ = facts(answers, recordings)
    refused = [np.isinf(u) for u in used]
    first = [(np.arange(len(u)) < 9) & g for u, g in zip(used, good, strict=True)]
    away = [abs(pair(a)[0][0, :2] - r[0][0][0]).max() for a, r in zip(answers, recordings, strict=True)]
    if share(refused, good) > 0.1 and np.median(away) > 30:
        return (
            f"Your state begins {np.median(away):.0f} px from the first detection (median), and then good detections are refused. "
            "No start is given, but the first ten detections are of the ball."
        )
    if share(refused, first) > 0.15 and np.median(away) < 1 and pair(answers[0])[1][0, 3, 3] > 300:
        return (
            f"Your state begins at the first detection and its velocity is wide, and yet {100 * share(refused, first):.0f} % of the detections in the first "
            "ten frames are refused, which are all of the ball. S holds P and R, and NIS is the square of a distance in σ: how large may it be?"
        )
    if share(refused, first) > 0.9:
        return (
            "Hardly a detection makes your P smaller, from the first frames on, and the first ten are all of the ball. No "
            "start is given: does x begin at the first detection, is P wide enough for a velocity that nobody knows, and "
            "the gate for a good detection?"
        )
    if share(refused, first) > 0.15 and pair(answers[0])[1][0, 3, 3] < 300:
        return (
            f"Your filter refuses {100 * share(refused, first):.0f} % of the detections in the first ten frames, and these "
            "are all of the ball. No start is given. Is P wide enough at first for a velocity that nobody knows, and the "
            "gate for a good detection?"
        )
    return None


def gates(answer, answers, recordings):
    """Which detections are left unused."""
    used, good, bad = facts(answers, recordings)
    refused = [np.isinf(u) for u in used]
    if share(refused, good) > 0.99:
        return "Your P never becomes smaller where the ball is seen, as if no detection were used."
    if share(refused, bad) < 0.99:
        return (
            f"Your filter uses {100 - 100 * share(refused, bad):.0f} % of the detections of something else, far from where the ball must be. Is there a gate, "
            "by the NIS, and before the correction? And is it not so wide that they pass?"
        )
    if share(refused, good) > 0.1:
        return (
            f"{100 * share(refused, good):.0f} % of the detections that are of the ball do not make your P smaller. Is S the "
            "whole H P Hᵀ + R? NIS is the square of a distance in σ, and of two numbers: how large may it be?"
        )
    return None


def moves(answer, answers, recordings):
    """How far a detection moves the state, beside what the covariance says of the gain."""
    if not gravity_right(answers, recordings):
        return None
    turned, moved, used = [], [], facts(answers, recordings)[0]
    for a, (inputs, _), R_used in zip(answers, recordings, used, strict=True):
        (mean, cov), (z, g, _, R) = pair(a), inputs
        ahead = mean[:-1] @ F.T + motion(g)[1]
        gained = (cov[1:] @ H.T @ (z[1:] - ahead[:, :2])[..., None])[..., 0] / R
        turned.append(((mean[1:] - ahead) / gained)[np.isfinite(R_used)])
        moved.append((abs(mean[1:] - ahead).max(axis=1) > 1e-6)[np.isinf(R_used)])
    if np.concatenate(moved).mean() > 0.5:
        return (
            "Your detections move the state, and P stays as it was predicted. A detection makes P smaller, by K S Kᵀ."
        )
    return of_gains(np.concatenate(turned))


def of_gains(parts):
    """What is said of the ways that a state goes, in units of those that it should go."""
    if len(parts) == 0:
        return None
    if np.mean(abs(parts + 1) < 1e-6) > 0.5:
        return "Your P is right. Your state moves away from the detection: the innovation is z − H x."
    place, velocity = (np.mean(abs(part - 1).max(axis=1) > 1e-6) for part in (parts[:, :2], parts[:, 2:]))
    if place < 0.02 < velocity:
        return "The place moves by K (z − H x). The velocities do not always: K has four rows, one for each state. Or does something set them anew?"
    if place > 0.02:
        often = f"In {100 * place:.0f} % of the corrections your" if place < 0.98 else "Your"
        return f"Your P is right. {often} state does not move by K (z − H x), with the K that made P smaller."
    return None


def floor(answer, answers, recordings):
    """The lesson's floor, below which P grows by much more."""
    pairs = list(zip(answers, recordings, strict=True))
    grown = np.concatenate([added(*pair(a), F)[1][dark(r)][:, 3, 3] / r[0][2] for a, r in pairs])
    row = np.concatenate([pair(a)[0][1:][dark(r)][:, 1] for a, r in pairs])
    much = grown > 20
    if much.any() and not much.all() and row[much].min() > row[~much].max() - 1:
        return (
            f"Where nothing is seen, your P grows much more from row {row[much].min():.0f} downwards: is that the lesson's "
            "floor, at row 210? This ball is in the air, and there is no floor."
        )
    return None


FIXED = r"(hypot|norm)\([^)]*\) *[<>]=? *\d"


def by_distance(answer, answers, recordings):
    """A gate that is a number of pixels."""
    if re.search(FIXED, _code_of.text_of(answer) or ""):
        return "Is your gate a fixed distance in px? Measure the innovation in units of S, by the NIS: narrow where the filter is sure, wide after a gap."
    return None


def seen(check, *words, of_filters_only=False):
    """A sign from a check of scenes."""
    return _scenes.sign(check, scenes, "frames", *words, of_filters_only=of_filters_only)


ORDER = "In another order of your states all of this passes. The order is: column, row, velocity of the column, velocity of the row."
SIGNS = [
    same_P("frames"),
    predictions(),
    another_order(MARKS, ORDER),
    stands_still,
    floor,
    gravity,
    kicks,
    seen(_scenes.predicted),
    seen(_scenes.negative),
    seen(_scenes.rooted),
    seen(_scenes.read_in_gaps, of_filters_only=True),
    trusts,
    moves,
    by_distance,
    begins,
    gates,
]
