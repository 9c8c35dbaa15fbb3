"""What is said of filters that do not pass the open exercise of lesson 13, where the mistake can be recognised.

Each known mistake is made in the course's own filter: a result equal to that, in every step, shows the same mistake.
"""

import numpy as np

from kflearn.exercises._judge import pair
from kflearn.exercises._radar import F, Q, converted, extended, predicted
from kflearn.exercises._radar_seen import of_P

SEEN = 6  # steps in which a mistake is looked for first


def same(answer, inputs, design, steps):
    """Whether a result is that of a design, in the first so many steps."""
    z, mean, cov = inputs
    with np.errstate(all="ignore"):
        wanted = design(z[:steps], mean, cov)
    pairs = zip(pair(answer), wanted, strict=True)
    return all(np.allclose(one[:steps], other, rtol=1e-5, atol=1e-7) for one, other in pairs)


def made_in(answers, recordings, design):
    """Whether the results of two recordings are those of a design; first a few steps, then all."""
    some = [(answers[i], recordings[i][0]) for i in (0, len(recordings) - 1)]
    return all(same(a, inputs, design, SEEN) for a, inputs in some) and all(
        same(a, inputs, design, len(inputs[0])) for a, inputs in some
    )


def known(answer, answers, recordings):
    """A known mistake in the course's own filter."""
    return next((words for design, words in MISTAKES if made_in(answers, recordings, design)), None)


def growing(answer, answers, recordings):
    """P of each step is the prediction from the P before: no reading makes it smaller."""
    cov = pair(answers[0])[1]
    if np.allclose(cov[1:], F @ cov[:-1] @ F.T + Q, rtol=1e-6):
        return "Your P only grows: it is predicted in each step, and no reading makes it smaller. Correct P as well, P = (I − K H) P."
    if np.allclose(cov, cov[0], rtol=1e-9):
        return "Your P is the same in all steps. Predict it in each step, F P Fᵀ + Q, and correct it by the reading."
    return None


def predictions(answer, answers, recordings):
    """What is returned for a step does not depend on its reading; what is returned for the next one does."""
    (z, mean, cov), first = recordings[0][0], pair(answers[0])[0]
    now, later = [], []
    for k in (30, 60, 90):
        other = z.copy()
        other[k] += [1.0, 0.01]
        again = pair(answer(other, mean, cov))[0]
        now.append(np.allclose(again[k], first[k], rtol=1e-9))
        later.append(np.allclose(again[k + 1], first[k + 1], rtol=1e-9))
    if all(now) and not any(later):
        return (
            "What you return for a step does not depend on the reading of that step, only on those before it: these are "
            "the predictions. Store x and P after the correction."
        )
    return None


def raw(answer, answers, recordings):
    """The places that the readings mean."""
    (z, *_), mean = recordings[0][0], pair(answers[0])[0]
    places = z[:, 0] * np.array([np.cos(z[:, 1]), np.sin(z[:, 1])])
    if np.allclose(mean[:, [0, 2]], places.T, rtol=1e-9):
        return "Those are the raw readings, put into the plane. A filter weighs each of them against what it expects."
    return None


def another_order(answer, answers, recordings):
    """The states in another order."""
    truth = np.concatenate([truth for _, truth in recordings])
    mean = np.concatenate([pair(each)[0] for each in answers])
    turned = mean[:, [0, 2, 1, 3]]
    off = [np.sqrt(np.mean((each - truth) ** 2)) for each in (mean, turned)]
    if off[1] < 10 < off[0]:
        return "Your states stand in another order. It is [east, its speed, north, its speed]."
    return None


def jumps(answer, answers, recordings):
    """Errors where the bearing jumps, and nowhere else."""
    error = [np.sqrt(np.mean((pair(a)[0] - t)[:, [0, 2]] ** 2)) for a, (_, t) in zip(answers, recordings, strict=True)]
    west = np.array([np.any(abs(np.diff(inputs[0][:, 1])) > np.pi) for inputs, _ in recordings])
    error = np.array(error)
    if error[~west].max() < 8 < np.median(error[west]):
        return (
            f"In the {sum(~west)} recordings in which the bearing does not jump your place is right; in the {sum(west)} others it is "
            f"wrong by {np.median(error[west]):.0f} m (median). There π and −π meet: is the difference of two bearings "
            "taken the short way round, and is what you expect an `arctan2`?"
        )
    return None


def with_R(distance, bearing):
    """The extended filter with another R."""
    return lambda *given: extended(*given, R=np.diag([distance, bearing]))


def with_H(change):
    """The extended filter with another H, made of the right one and the state."""
    return lambda *given: extended(*given, slope=change)


def with_seen(change):
    """The extended filter that expects another bearing."""
    return lambda *given: extended(*given, expect=change)


def across(H, factor):
    """H with another second row."""
    return np.vstack([H[0], factor * H[1]])


def along(x):
    return np.hypot(x[0], x[2])


def compass(x):
    """Distance and bearing, counted from north."""
    return np.array([along(x), np.arctan2(x[0], x[2])])


MISTAKES = [
    (
        lambda *given: extended(*given, wrap=False),
        "Somewhere the bearings are not subtracted the short way round, on one side or on both. A bearing of 3.1 rad and one of −3.1 rad are close together: `angle_difference(…, …, 2 * np.pi)`.",
    ),
    (
        lambda *given: extended(*given, wrap="remainder"),
        "Your difference of two bearings lies between 0 and 2π, as `% (2 * np.pi)` makes it: a small negative one becomes nearly 2π. Take it the short way round, between −π and π: `angle_difference(…, …, 2 * np.pi)`.",
    ),
    (
        lambda *given: extended(*given, wrap="both"),
        "The distance is taken the short way round as well. Only the bearing is an angle: subtract the distance plainly.",
    ),
    (
        with_R(5.0**2, np.radians(0.02) ** 2),
        "In your R the variance of the bearing is (0.02·π/180)², as if 0.02 were in degrees. It is in radians already.",
    ),
    (
        with_R(5.0**2, np.degrees(0.02) ** 2),
        "In your R the bearing's 0.02 is turned into degrees. The bearing, and its σ, are in radians.",
    ),
    (with_R(5.0, 0.02), "Your R holds the standard deviations. R holds variances: 5² and 0.02²."),
    (
        with_R(5.0, 0.02**2),
        "In your R the first entry is 5, the standard deviation of the distance. R holds variances.",
    ),
    (
        with_R(5.0**2, 0.02),
        "In your R the second entry is 0.02, the standard deviation of the bearing. R holds variances.",
    ),
    (with_R(5.0**4, 0.02**4), "In your R the standard deviations are squared twice. R holds variances: 5² and 0.02²."),
    (with_R(0.02**2, 5.0**2), "In your R the two variances are exchanged. The first entry belongs to the distance."),
    (with_R(0.02, 5.0), "In your R the two entries are exchanged, and they are not squared."),
    (with_R(1.0, 1.0), "Your R is the identity. It holds the variances of the readings, 5² and 0.02²."),
    (
        with_H(lambda H, x: across(H, along(x))),
        "The second row of your H, the slope of the bearing, is too large: the distance below it is not squared. Test H with the three lines of the lesson.",
    ),
    (
        with_H(lambda H, x: across(H, 1 / along(x))),
        "The second row of your H, the slope of the bearing, is too small: below it stands the square of the distance, not its third power.",
    ),
    (
        with_H(lambda H, x: across(H, -1)),
        "Your bearings push the wrong way: the second row of H, the slope of the bearing, has the wrong sign, or the bearing's innovation is expected minus read. Test H with the three lines of the lesson; an innovation is the reading minus what is expected.",
    ),
    (
        with_H(lambda H, x: np.vstack([H[0], [x[0] / along(x) ** 2, 0, x[2] / along(x) ** 2, 0]])),
        "In the second row of your H east and north are exchanged, and the minus is missing. Test H with the three lines of the lesson.",
    ),
    (
        with_H(lambda H, x: np.vstack([H[0], [x[2] / along(x) ** 2, 0, x[0] / along(x) ** 2, 0]])),
        "In the second row of your H the minus is missing: a target in the north-east that goes further east has a *smaller* bearing.",
    ),
    (
        with_H(lambda H, x: np.vstack([along(x) * H[0], H[1]])),
        "The first row of your H is not divided by the distance. Test H with the three lines of the lesson.",
    ),
    (
        with_H(lambda H, x: H[:, [0, 2, 1, 3]]),
        "The columns of your H stand in another order than the states: [east, its speed, north, its speed].",
    ),
    (
        with_seen(lambda x: np.array([along(x), np.arctan(x[2] / x[0])])),
        "You expect the bearing by `arctan`, which gives a target in the west the bearing of one in the east. `np.arctan2(north, east)` looks at both signs.",
    ),
    (
        with_seen(compass),
        "You expect the bearing counted from north, `arctan2(east, north)`. It counts from east towards north; H has the right slope for that.",
    ),
    (
        lambda *given: extended(*given, expect=compass, slope=lambda H, x: across(H, -1)),
        "You count the bearing from north, in what is expected and in H. In the readings it counts from east towards north: `np.arctan2(north, east)`.",
    ),
    (
        with_seen(lambda x: np.array([np.hypot(x[0], x[1]), np.arctan2(x[1], x[0])])),
        "You expect distance and bearing from the first two states, and the second is a speed. North is `x[2]`.",
    ),
    (
        lambda *given: extended(*given, move=lambda x, P: predicted(x, P, 0 * Q)),
        "Q is missing: P becomes F P Fᵀ only, so that your filter believes it knows more in every step. Add Q when you predict.",
    ),
    (
        lambda *given: extended(*given, move=lambda x, P: predicted(x, P, Q @ Q)),
        "Your Q is squared. Q is a covariance already: take it as it is given.",
    ),
    (
        lambda *given: extended(*given, move=lambda x, P: predicted(x, P, np.sqrt(Q))),
        "You took the root of Q. Q is a covariance already: take it as it is given.",
    ),
    (
        lambda *given: extended(*given, first=False),
        "In the first step nothing is predicted. The start is one second *before* the first reading: predict first, there too.",
    ),
    (
        lambda *given: extended(*given, early="H"),
        "Your H is taken at the estimate before the prediction. What is expected, and H, belong to the predicted state.",
    ),
    (
        lambda *given: extended(*given, early="both"),
        "What you expect, and H, are taken at the estimate before the prediction. Both belong to the predicted state.",
    ),
    (
        lambda *given: extended(*given, move=lambda x, P: (x, P + Q)),
        "Your state does not move between the readings: predict it by F, and P by F P Fᵀ + Q.",
    ),
    (
        lambda *given: extended(*given, move=lambda x, P: (x, F @ P @ F.T + Q)),
        "P is predicted, but your state does not move between the readings: x becomes F x.",
    ),
    (
        lambda *given: extended(*given, move=lambda x, P: (F @ x, P + Q)),
        "Your state moves, but P gets Q only. A speed that is not known well makes the place less certain: P becomes F P Fᵀ + Q.",
    ),
    (
        lambda *given: extended(*given, move=lambda x, P: (F @ x, F.T @ P @ F + Q)),
        "You predict P by Fᵀ P F. It is F P Fᵀ + Q.",
    ),
    (
        lambda *given: extended(*given, move=lambda x, P: (F @ x, P)),
        "Your state is predicted and P is not. Both are: P becomes F P Fᵀ + Q.",
    ),
    (
        lambda *given: extended(*given, move=lambda x, P: predicted(x, P, 2 * Q)),
        "You add Q twice in each step.",
    ),
    (
        lambda *given: converted(*given, turned=False),
        "You put the readings into the plane, and left R as it was, for distance and bearing. Turn it as well: J R Jᵀ, exercise 3.",
    ),
    (
        lambda *given: converted(*given, R=25 * np.eye(2), turned=False),
        "Your R says that a place is read to 5 m in all directions. Across the line of sight it is 0.02·r: turn R into the plane, J R Jᵀ, exercise 3.",
    ),
    (
        lambda *given: converted(*given, R=np.diag([5.0, 0.02])),
        "Your R holds the standard deviations. R holds variances, 5² and 0.02², before it is turned into the plane.",
    ),
    (
        lambda *given: extended(*given, rows=(0,)),
        "Your filter uses the distance only. The bearing is measured too: h(x) has two entries, and H two rows.",
    ),
    (
        lambda *given: extended(*given, rows=(1,)),
        "Your filter uses the bearing only. The distance is measured too: h(x) has two entries, and H two rows.",
    ),
    (
        lambda *given: extended(*given, rows=()),
        "Your filter uses none of the readings: x and P are predicted only.",
    ),
    (
        lambda *given: extended(*given, back=True),
        "Your mean moves the wrong way: K times (reading − expected) is added.",
    ),
]
SIGNS = [known, raw, predictions, growing, another_order, jumps, of_P]
