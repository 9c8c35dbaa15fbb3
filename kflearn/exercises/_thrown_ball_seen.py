"""What is judged in the open exercise of lesson 19, and what of a tracker is measurably right."""

import numpy as np

from kflearn.exercises._inside import added, share, used_R
from kflearn.exercises._judge import Mark, inside, likely, nees, pair, rms
from kflearn.exercises._scenes import Scene
from kflearn.exercises._thrown_ball import KICK, H, motion

F = motion(0.0)[0]
BY_AXIS = np.kron(np.eye(2), [[1, 1], [0, 1]])  # as for a state of column, its velocity, row, its velocity


def dark(recording):
    """The frames but the first in which nothing is seen."""
    return np.isnan(recording[0][0][1:, 0])


def in_the_dark(answers, recordings, moves=F):
    """What is added to x and P in the frames in which nothing is seen, the median of each recording."""
    both = [added(*pair(a), moves) for a in answers]
    rows = [(push[dark(r)], Q[dark(r)]) for (push, Q), r in zip(both, recordings, strict=True)]
    return [np.median(push, axis=0) for push, _ in rows], [np.median(Q, axis=0) for _, Q in rows]


def is_filter(answers, recordings):
    """Whether the same is added to P in all frames without a detection of a recording; not so in a smoother."""
    both = [added(*pair(a), F)[1][dark(r)] for a, r in zip(answers, recordings, strict=True)]
    return all(np.ptp(Q, axis=0).max() < 1e-6 * (1 + abs(Q).max()) for Q in both)


def facts(answers, recordings):
    """For each recording: the R used in each frame, which detections are of the ball, and which of something else."""
    if not is_filter(answers, recordings):
        raise ValueError("no filter, so its corrections cannot be read")
    Q = in_the_dark(answers, recordings)[1]
    used = [used_R(pair(a)[1], F, each, H) for a, each in zip(answers, Q, strict=True)]
    off = [np.abs(z - truth[:, :2]).max(axis=1)[1:] / R**0.5 for (z, _, _, R), truth in recordings]
    return used, [each < 4 for each in off], [each > 15 for each in off]


def scenes(answers, recordings):
    """What the tracker did in each recording, beside F, Q, gravity and H."""
    return [
        Scene(
            *pair(a),
            np.broadcast_to(F, (len(z) - 1, 4, 4)),
            np.broadcast_to(q * KICK, (len(z) - 1, 4, 4)),
            motion(g)[1],
            H,
            z[1:],
        )
        for a, ((z, g, q, _), _) in zip(answers, recordings, strict=True)
    ]


# ---- what is right in it


def gravity_right(answers, recordings):
    """Whether the state moves as it should where nothing is seen."""
    pairs = zip(in_the_dark(answers, recordings)[0], recordings, strict=True)
    return all(np.allclose(push, motion(r[0][1])[1], atol=1e-6) for push, r in pairs)


def Q_right(answers, recordings):
    """Whether P grows as it should where nothing is seen."""
    pairs = zip(in_the_dark(answers, recordings)[1], recordings, strict=True)
    return all(np.allclose(Q, r[0][2] * KICK, rtol=1e-3, atol=1e-6) for Q, r in pairs)


def R_right(answers, recordings):
    """Whether a detection makes P smaller as R says."""
    used, good, _ = facts(answers, recordings)
    found = [np.median(u[g & np.isfinite(u)]) for u, g in zip(used, good, strict=True)]
    return np.allclose(found, [inputs[3] for inputs, _ in recordings], rtol=0.01)


def start_right(answers, recordings):
    """Whether the state begins at the first detection."""
    return all(abs(pair(a)[0][0, :2] - r[0][0][0]).max() < 1 for a, r in zip(answers, recordings, strict=True))


def gate_right(answers, recordings):
    """Whether detections of the ball are used, and those of something else are not."""
    used, good, bad = facts(answers, recordings)
    refused = [np.isinf(u) for u in used]
    return share(refused, good) < 0.1 and share(refused, bad) > 0.99


MARKS = [
    Mark(
        "error of the row (rms, from frame 10 on)",
        rms(1, 10),
        high=4.2,
        unit="px",
        above=likely(
            (
                "Is there a gate, by the NIS and before the correction? And is it not so narrow that it refuses one good detection after another?",
                gate_right,
            ),
            ("g is given, it is not the lesson's.", gravity_right),
            ("q is given, it is not the lesson's.", Q_right),
            ("R is given, it is not the lesson's.", R_right),
            ("No start is given: begin at the first detection.", start_right),
            "In each frame: predict, push, look whether there is a detection, gate, correct, keep x and P.",
        ),
    ),
    Mark(
        "error of the row's velocity (rms)",
        rms(3, 10),
        high=1.56,
        unit="px/frame",
        above=likely(
            ("Gravity moves the row by g/2 within the frame as well.", gravity_right),
            "If the row itself is wrong, mend that first.",
        ),
    ),
    Mark(
        "truth within ±2σ of the row",
        inside(1, 10),
        low=90,
        high=99,
        unit="%",
        below=likely(
            "The claimed σ is too small for the errors.",
            ("Look at P where nothing is seen.", Q_right),
            ("R is a variance.", R_right),
        ),
        above=likely(
            "The claimed σ is too large for the errors.",
            ("Are the readings used, with the R that is given?", R_right),
            ("Is q used as it is given?", Q_right),
        ),
    ),
    Mark(
        "NEES / 4",
        nees(10),
        low=0.88,
        high=1.14,
        below=likely(
            "The covariance is too large for the errors.",
            ("Look at R.", R_right),
            (
                "Look at q, and at the form of Q: a kick to the velocity moves the place as well, q [[1/3, 1/2], [1/2, 1]] for place and velocity of each axis.",
                Q_right,
            ),
        ),
        above=likely(
            "The covariance is too small for the errors.",
            ("Look at R, which is a variance (R, not √R).", R_right),
            ("Look at q as it is given, and at Q on both axes.", Q_right),
            ("Look at the gate.", gate_right),
            ("Look at gravity.", gravity_right),
        ),
    ),
]
