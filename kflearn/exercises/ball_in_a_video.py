"""Lesson 19: a ball in a video."""

from itertools import cycle

import numpy as np
from scipy import ndimage

from kflearn.exercises import _thrown_ball, _thrown_ball_seen, _thrown_ball_signs
from kflearn.exercises._judge import track
from kflearn.exercises._slips import ball_in_a_video as slips
from kflearn.exercises.engine import exercise, judged


def a_picture(rng):
    """A ball, something smaller, a long thin cable and stray pixels, (60, 80) or larger."""
    height, width = rng.choice([110, 60]), rng.choice([120, 80])
    rows, columns = np.mgrid[:height, :width]
    row, column, radius = rng.uniform(14, height - 30), rng.uniform(15, width - 35), rng.uniform(7, 9.5)
    ball = np.hypot(rows - row, columns - column) < radius
    other = np.hypot(rows - rng.uniform(12, height - 30), columns - width + rng.uniform(8, 14)) < rng.uniform(4, 5)
    stray = rng.random(rows.shape) < 0.01
    return (ball | other | (abs(rows - height + 9.5) < 2) | stray,)


@exercise(
    hints=[
        "Two questions, two pictures: *which* region is the ball is answered after the erosions, *how large* it is before them.",
        "Find the eroded ball as in the lesson. Then label `differs` itself: the eroded ball's pixels all carry one label there.",
        "`ndimage.binary_propagation(ball, mask=differs)` grows a region until it fills everything that is connected with it in the mask.",
        "`whole, _ = ndimage.label(differs)`, then count `whole == whole[ball][0]`, where `ball` is the eroded ball.",
    ],
    inputs=a_picture,
    wrong=slips.true_radius.WRONG,
    then=(
        "Erosion decides which region is the ball; counting comes before it. The centre needs no such care: the "
        "rim is lost on all sides alike."
    ),
)
def true_radius(differs):
    """The radius of the ball from all pixels that are connected with it in `differs`, True where a pixel differs."""
    eroded = ndimage.binary_erosion(differs, np.ones((3, 3)), iterations=2)
    labels, _ = ndimage.label(eroded)
    ball = labels == 1 + np.bincount(labels.ravel())[1:].argmax()
    whole, _ = ndimage.label(differs)
    return np.sqrt((whole == whole[ball][0]).sum() / np.pi)


def a_gap(rng):
    """A state of one, two or three axes, its covariance, F, what pushes, and a Q that ties place and velocity."""
    axes, T = int(rng.choice([3, 2, 1])), rng.integers(1, 5) / 2
    root = rng.integers(-3, 4, (2 * axes, 2 * axes)) / 2
    return (
        rng.integers(-9, 200, 2 * axes).astype(float),
        root @ root.T + np.eye(2 * axes),
        np.kron([[1, T], [0, 1]], np.eye(axes)),
        rng.integers(1, 7, 2 * axes) / 2,
        np.kron([[1 / 3, 1 / 2], [1 / 2, 1]], np.diag(rng.integers(1, 5, axes) / 10)),
    )


@exercise(
    hints=[
        "Nothing is seen. What does the filter do in every frame *before* it looks?",
        "The state moves with F and is pushed, eq (5). The covariance moves with F on both sides and grows by Q, eq (6).",
        "`return F @ x + push, F @ P @ F.T + Q`",
    ],
    inputs=a_gap,
    wrong=slips.coast.WRONG,
    then="P grows in every frame without a ball, and S with it: so the gate is wide enough when the ball comes back.",
)
def coast(x, P, F, push, Q):
    """State and covariance after a frame without a detection; push is B u."""
    return F @ x + push, F @ P @ F.T + Q


def a_start(rng):
    """Variances of place and velocity, R, and the first innovation."""
    p, s = rng.integers(1, 50, 2) * 4.0
    return p, s, float(rng.integers(1, 9)), float(rng.integers(-99, -9))


@exercise(
    hints=[
        "One step by hand: P = diag(p, s), predict it with F, then the second number of the gain.",
        "F P Fᵀ = [[p + s, s], [s, s]]: an uncertain velocity makes the place uncertain, and makes the two correlated.",
        "The gain on the velocity is the corner of that matrix over S = p + s + R.",
        "`return s / (p + s + R) * y`",
    ],
    inputs=a_start,
    wrong=slips.first_velocity.WRONG,
    then=(
        "With p = s = 100² px² and a small R nearly half of 120 px is taken for velocity; with p = 100² and s = "
        "10² about a hundredth of it."
    ),
)
def first_velocity(p, s, R, y):
    """The velocity believed after the first innovation y: start with 0, variances p (place) and s (velocity), no Q."""
    return s / (p + s + R) * y


EDGES = [[210.0, 210.0, 210.0], [210.4, 209.6, 209.7], [210.4, 209.6, 210.7]]
EDGES += [[210.98, 209.02, 210.5], [210.3, 211.02, 209.8], [208.98, 210.3, 209.8]]  # just inside 1 px, just outside
EDGES += [[211.0, 210.0, 209.7]]  # exactly 1 px
KINDS = cycle(range(15))  # each of them in the twenty trials


def three_rows(rng):
    """Rows of the last three frames: at rest, bouncing, about the floor, hidden for a frame, high up, or below."""
    kind = next(KINDS)
    rows = 210 + rng.integers(-19, 20, 3) / 20
    if kind == 1:
        rows[rng.integers(0, 3)] -= rng.integers(2, 40)
    elif kind == 2:
        rows[[0, 2]] += [-3.0, 3.0]
    elif kind in (3, 4):
        rows[rng.integers(0, 3)] = np.nan
    elif kind == 5:
        rows -= rng.integers(20, 150)
    elif kind == 6:
        rows[:2] -= rng.integers(2, 40, 2)
    elif kind == 7:  # the floor is not where it was thought to be
        rows[rng.integers(0, 3)] = 211.5
    elif kind > 7:
        rows[:] = EDGES[kind - 8]
    return (rows,)


@exercise(
    hints=[
        "Three conditions that must hold together, and a NaN must not count as near the floor.",
        "`abs(rows - 210) < 1` gives three truth values; a comparison with NaN is always False. Which function wants them all?",
        "`return 0.0 if np.all(abs(rows - 210) < 1) else 6.0`",
    ],
    inputs=three_rows,
    fixed={"rows": "the text asks about the last three frames"},
    wrong=slips.gravity.WRONG,
    then="With a NaN among the rows the ball keeps falling: what was not seen is not known to rest.",
)
def gravity(rows):
    """The push on the row's velocity: 0 if the last three rows (NaN: not seen) were within 1 px of 210, else 6."""
    return 0.0 if np.all(abs(rows - 210) < 1) else 6.0


@judged(
    hints=[
        "Begin with `follow` of this lesson. What in it belongs to that film only: start, gravity, Q, R, the floor, the gate?",
        "x starts at the first detection, with R for its place and a wide variance for the velocity. In every further frame: predict, push by [0, g/2, 0, g], ask for the NIS, correct if it passes the gate, and store x and P.",
        "A NaN makes the NIS NaN, and no comparison with NaN is true: such a frame coasts by itself. For two numbers a gate at 11.8 refuses one good detection in 365.",
    ],
    recording=_thrown_ball.thrown,
    marks=_thrown_ball_seen.MARKS,
    form=track(4),
    then="Where does it pay? Compare with the detections in the frames where the ball was seen: an R of several px² is what makes a filter worth its lines here.",
    passing=_thrown_ball.PASSING,
    failing=_thrown_ball.FAILING,
    signs=_thrown_ball_signs.SIGNS,
)
def thrown_ball(z, g, q, R):
    """Write the whole tracker for a ball in the air: the mean (T, 4) and the covariance (T, 4, 4) in every frame.

    State: column, row, and their velocities in px and px/frame. z (T, 2) holds the detections in px, NaN where nothing was
    found; the first ten are of the ball, of the later ones some are of something else. g: gravity in px/frame², which
    makes rows grow; q: variance of the kicks that the air gives, on each axis, in px²/frame²; R: variance of a detection,
    on each axis, in px². There is no floor.
    """
    F, up = np.kron([[1, 1], [0, 1]], np.eye(2)), np.array([0, g / 2, 0, g])
    H, Q = np.eye(2, 4), q * np.kron([[1 / 3, 1 / 2], [1 / 2, 1]], np.eye(2))
    x, P = np.array([*z[0], 0, 0]), np.diag([R, R, 1e4, 1e4])
    means, covs = [x], [P]
    for seen in z[1:]:
        x, P = F @ x + up, F @ P @ F.T + Q
        y, S = seen - H @ x, H @ P @ H.T + R * np.eye(2)
        if y @ np.linalg.solve(S, y) <= 11.8:  # not so for NaN
            K = np.linalg.solve(S, H @ P).T
            x, P = x + K @ y, P - K @ S @ K.T
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)
