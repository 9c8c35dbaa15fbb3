"""What can be seen in the results of a cart's filter (lesson 11): what it does in the gaps, its Q, its R and its start."""

from itertools import starmap

import numpy as np

from kflearn.exercises._cart_with_gaps import motion, run
from kflearn.exercises._inside import predictions
from kflearn.exercises._judge import Likely, pair


def gaps(recording):
    """The steps without a reading."""
    return np.flatnonzero(np.isnan(recording[0][0]))


def growth(answer, recording):
    """The Q that a filter uses in the gaps, as a mean, beside the right one, dt and sd."""
    (_, dt, sd, _), (F, right), cov = recording[0], motion(*recording[0][1:3]), pair(answer)[1]
    return np.mean([cov[k] - F @ cov[k - 1] @ F.T for k in gaps(recording)], axis=0), right, dt, sd


def white(Q, dt, sd):
    return sd**2 * np.array([[dt**3 / 3, dt**2 / 2], [dt**2 / 2, dt]])


PUSH = "an acceleration a, held for dt, moves the position by a·dt²/2 and the speed by a·dt."
SEEN = [
    (lambda Q, dt, sd: 0 * Q, "In the gaps P moves with F but gains no Q: add it in each prediction."),
    (lambda Q, dt, sd: Q / sd, "In the gaps P grows by sd times G Gᵀ; Q is a covariance: sd²."),
    (lambda Q, dt, sd: Q / sd**2, "In the gaps P grows by G Gᵀ alone; sd is missing in your Q."),
    (lambda Q, dt, sd: Q / dt**2, "In the gaps Q lacks a factor: an acceleration a, held for dt, adds a·dt to the speed."),
    (white, "In the gaps Q is that of white noise, new at every instant. Here the acceleration is held for the whole step."),
    (
        lambda Q, dt, sd: np.diag(np.diag(Q)),
        "In the gaps your Q has no corners. The same acceleration moves position and speed, so what it does to the one goes with what it does to the other.",
    ),
    (
        lambda Q, dt, sd: np.diag([0, Q[1, 1]]),
        "In the gaps only the speed gains a variance. In the same step the acceleration moves the position as well, by a·dt²/2.",
    ),
    (lambda Q, dt, sd: np.diag([Q[0, 0], 0]), "In the gaps only the position gains a variance. An acceleration moves the speed as well, by a·dt."),
    (lambda Q, dt, sd: sd**2 * np.eye(2), f"In the gaps Q is sd² I, without dt: {PUSH}"),
    (lambda Q, dt, sd: sd * np.eye(2), f"In the gaps Q is sd I: {PUSH} And a variance has sd²."),
    (lambda Q, dt, sd: np.eye(2), "In the gaps Q is I, whatever sd and dt are."),
    (lambda Q, dt, sd: sd**2 * np.diag([0, 1]), f"In the gaps only the speed gains a variance, sd², without dt: {PUSH}"),
    (lambda Q, dt, sd: sd**2 * dt * np.eye(2), f"In the gaps Q is sd² dt I: {PUSH}"),
    (lambda Q, dt, sd: sd**2 * np.diag([0, dt]), f"In the gaps only the speed gains a variance, sd² dt: {PUSH}"),
    (
        lambda Q, dt, sd: sd**2 * np.outer([dt**2, dt], [dt**2, dt]),
        f"In the gaps the position gains a variance that is too large: {PUSH}",
    ),
    (lambda Q, dt, sd: sd**2 * np.outer([dt, 1], [dt, 1]), f"In the gaps Q lacks a factor dt/2, or dt: {PUSH}"),
    (lambda Q, dt, sd: sd**2 * np.outer([0.5, 1], [0.5, 1]), f"In the gaps Q has dt = 1: {PUSH}"),
    (lambda Q, dt, sd: np.full((2, 2), sd**2), f"In the gaps all entries of Q are sd²: {PUSH}"),
    (lambda Q, dt, sd: dt * Q, "In the gaps Q has one dt too many: it is sd² G Gᵀ with G = [dt²/2, dt]."),
    (lambda Q, dt, sd: Q / dt, "In the gaps Q has one dt too few: it is sd² G Gᵀ with G = [dt²/2, dt]."),
]  # fmt: skip


def zero(answers, recordings):
    """What is said beside where the position is 0 in all gaps."""
    pairs = zip(answers, recordings, strict=True)
    return " And NaN has become 0." if all((pair(a)[0][gaps(r), 0] == 0).all() for a, r in pairs) else ""


def of_the_gaps(answers, recordings):
    """Where mean and P do not move in the gaps as they should; None where they do."""
    moved, stood, lasted, even = [], [], [], []
    for answer, recording in zip(answers, recordings, strict=True):
        (mean, cov), (F, _) = pair(answer), motion(*recording[0][1:3])
        steps = gaps(recording)
        moved.append(np.allclose(mean[steps], mean[steps - 1] @ F.T, rtol=1e-6, atol=1e-6))
        stood.append(np.allclose(mean[steps], mean[steps - 1]) and np.allclose(cov[steps], cov[steps - 1]))
        way = mean[steps, 0] - mean[steps - 1, 0]
        with np.errstate(all="ignore"):
            lasted.append(np.median(way / mean[steps - 1, 1]))
        even.append(np.allclose(way, lasted[-1] * mean[steps - 1, 1], rtol=1e-6, atol=1e-6))
    if all(np.allclose(pair(each)[1], pair(each)[1][0]) for each in answers):
        return f"Your P is the same at every reading, gaps included. In a gap it must grow.{zero(answers, recordings)}"
    if all(stood):
        return (
            "In the gaps your filter waits: mean and P stay as they were. "
            "The cart goes on: predict in every step, and leave out the correction alone."
        )
    if all(even) and np.ptp(lasted) < 1e-6 < lasted[0]:
        return f"In the gaps your position moves on by the way of {lasted[0]:.3g} s, whatever dt is: does F contain dt, the one that is given?"
    if all(growth(*each)[0][0, 0] < 0 for each in zip(answers, recordings, strict=True)):
        return "In the gaps your P is smaller than F P Fᵀ + Q. Is a NaN taken for a number, is the speed in the state, is dt the one that is given, and is P handed in after its correction?"
    if not any(moved):
        return "In the gaps your mean does not move on as F says: position + dt · speed, and the same speed."
    return None


def anew(answers, recordings):
    """A filter that begins again at the first reading after a gap."""
    same = []
    for answer, recording in zip(answers, recordings, strict=True):
        (mean, cov), z, steps = pair(answer), recording[0][0], gaps(recording)
        back = np.setdiff1d(steps + 1, steps)
        same += [np.allclose(cov[k], cov[0]) and np.isclose(mean[k, 0], z[k]) for k in back[back < len(z)]]
    if all(same):
        return (
            "At the first reading after a gap you start anew, as at the very first one. The filter still knows the speed, "
            "and its P says how well: correct there as always."
        )
    return None


def of_sigma(answers, recordings):
    """What is said beside, where the first P holds sigma in place of its square."""
    firsts = zip(answers, recordings, strict=True)
    once = all(abs(pair(a)[1][0, 0, 0] - sigma) < 1e-6 * sigma for a, ((*_, sigma), _) in firsts)
    return " And at the first reading your P holds sigma: its square is wanted, there and for R." if once else ""


def of_Q(answers, recordings):
    """The Q in the gaps, where it has a name."""
    grown = [growth(*each) for each in zip(answers, recordings, strict=True)]
    for form, words in SEEN:
        if all(
            np.allclose(Q, form(right, dt, sd), rtol=1e-3, atol=1e-6 * abs(right).max()) for Q, right, dt, sd in grown
        ):
            return words + of_sigma(answers, recordings)
    Qs = np.array([Q for Q, *_ in grown])
    if np.ptp(Qs, axis=0).max() < 1e-6 * abs(Qs).max():
        return "In the gaps P grows by the same Q in every recording. Here each cart has its own: Q = sd² G Gᵀ, and G has dt in it."
    return None


def of_the_start(answers, recordings):
    """The belief at the first reading, where it is not the one that is given."""
    firsts = [(pair(answer)[0][0], pair(answer)[1][0]) for answer in answers]
    rows = [(mean, P, z[0], sigma) for (mean, P), ((z, _, _, sigma), _) in zip(firsts, recordings, strict=True)]
    if all(abs(mean[0] - z) > 1e-6 for mean, _, z, _ in rows) and all(P[0, 0] < 4 * s**2 for _, P, _, s in rows):
        return "Your position at the first reading is another one than that reading, and P says that it is as good: start at z[0]."
    if all(abs(mean[0] - z) < 1e-6 and abs(P[0, 1]) > 1e-9 for mean, P, z, _ in rows):
        wide = (
            " And at the first reading the speed has the variance 3²."
            if all(P[1, 1] < 8 for _, P, _, _ in rows)
            else ""
        )
        return f"At the first reading your P has a corner, as if z[0] were predicted or used twice: start there without one, and go on with z[1:].{wide}"
    if all(abs(P[1, 1] - 3) < 1e-3 for _, P, _, _ in rows):
        return "At the first reading your speed has the variance 3. 3 m/s is the standard deviation: square it."
    if all(P[1, 1] < 4 for _, P, _, _ in rows):
        return "Your P at the first reading is too small for the speed, which is drawn from N(0, 3²)."
    if all(P[0, 0] < (1 - 1e-4) * sigma**2 for _, P, _, sigma in rows):
        return (
            "Your P at the first reading says that the position is known better than by one reading, which has sigma². "
            "Is the first reading used twice, for the start and for a correction?"
        )
    return None


def of_R(answers, recordings):
    """The R in the corrections, where F and Q are right and R is not."""
    used = []
    for answer, recording in zip(answers, recordings, strict=True):
        cov, (F, Q), sigma = pair(answer)[1], motion(*recording[0][1:3]), recording[0][3]
        added = np.linalg.inv(cov[1:20]) - np.linalg.inv(F @ cov[:19] @ F.T + Q)
        used.append((1 / np.median(added[:, 0, 0]), sigma))
    if all(abs(R / sigma - 1) < 0.01 for R, sigma in used):
        return "In the corrections your R is sigma. A variance is wanted: sigma²."
    if all(abs(R / sigma**4 - 1) < 0.01 for R, sigma in used):
        return "In the corrections your R is sigma to the power of four: it is squared twice."
    if np.ptp([R for R, _ in used]) < 1e-3 * used[0][0]:
        return "In the corrections your R is the same in each recording. It is sigma² of that recording."
    return None


def of_the_corrections(answers, recordings):
    """What is left to look at where P grows in the gaps as it should; None where it does not."""
    pairs = list(zip(answers, recordings, strict=True))
    if not all(np.allclose(Q, right, rtol=1e-3, atol=1e-6 * right.max()) for Q, right, *_ in starmap(growth, pairs)):
        return None
    first = [np.diag([sigma**2, 9.0]) for (*_, sigma), _ in recordings]
    if not all(np.allclose(pair(a)[1][0], P, rtol=1e-3) for a, P in zip(answers, first, strict=True)):
        return "In the gaps P grows as it should. At the first reading it is not diag(sigma², 3²): what is known of position and speed there?"
    right = [
        run(z, *motion(dt, sd), sigma**2, np.array([z[0], 0]), P)[1]
        for ((z, dt, sd, sigma), _), P in zip(recordings, first, strict=True)
    ]
    if all(np.allclose(pair(a)[1], P, rtol=1e-5) for a, P in zip(answers, right, strict=True)):
        return (
            "Your P is right at every reading, so F, Q and R are right in it. It is the mean that goes wrong: predict it by F, and "
            "where there is a reading add K times the reading minus the predicted position, with K = P[:, 0] / (P[0, 0] + sigma²)."
        )
    return (
        "In the gaps P grows as it should, and it begins as it should. Look at the corrections: K = P[:, 0] / (P[0, 0] + sigma²) is "
        "formed of the predicted P, and it is used for the mean and for P."
    )


BEFORE = "At reading k you return the belief *before* reading k is used. Your filter itself is right: append x and P after the correction."


def before(answer, answers, recordings):
    """A sign: the beliefs before the readings are returned; of the right filter, or of another one."""
    for found, ((z, dt, sd, sigma), _) in zip(answers, recordings, strict=True):
        F, Q = motion(dt, sd)
        mean, cov = run(z, F, Q, sigma**2, np.array([z[0], 0]), np.diag([sigma**2, 9.0]))
        mean[1:], cov[1:] = mean[:-1] @ F.T, F @ cov[:-1] @ F.T + Q
        if not (np.allclose(pair(found)[0], mean, atol=1e-6) and np.allclose(pair(found)[1], cov, rtol=1e-5)):
            return predictions()(answer, answers, recordings)
    return BEFORE


def named(answers, recordings):
    """What a filter does wrongly, as far as it can be seen in its results; else None."""
    for look in (of_the_gaps, anew, of_Q, of_the_start, of_R, of_the_corrections):
        try:
            if words := look(answers, recordings):
                return words
        except np.linalg.LinAlgError:  # a covariance that has no inverse
            continue
    return None


def look(otherwise):
    """What to look at: what can be seen in the results, or something else."""
    return lambda answers, recordings: named(answers, recordings) or Likely(otherwise)
