"""Recordings for the open exercise of lesson 7: a ship's position from a receiver whose accuracy nobody tells."""

import numpy as np

from kflearn.exercises._inside import used_R
from kflearn.exercises._judge import Likely, pair

STEPS, F, Q = 100, np.array([[1.0, 1.0], [0.0, 1.0]]), np.diag([0.005, 0.01])
MEAN, COV = np.zeros(2), np.diag([50.0**2, 5.0**2])


def recording(rng):
    """Readings (100,) of a ship's position east, once a second, and its true position and speed (100, 2)."""
    sigma = np.exp(rng.uniform(np.log(2), np.log(40)))
    jolts = rng.normal(size=(STEPS, 2)) * np.sqrt(np.diag(Q))
    x, truth = MEAN + rng.normal(size=2) * np.sqrt(np.diag(COV)), np.empty((STEPS, 2))
    for k in range(STEPS):
        x = F @ x + jolts[k]
        truth[k] = x
    return (truth[:, 0] + rng.normal(0, sigma, STEPS),), truth


def honest_share(low=0.5, high=2.0):
    """The share of the recordings, in per cent, whose own NEES/n lies between two limits."""

    def value(answers, truths):
        good = []
        for answer, truth in zip(answers, truths, strict=True):
            mean, cov = pair(answer)
            error = truth - mean
            score = np.mean(np.sum(error * np.linalg.solve(cov, error[..., None])[..., 0], axis=-1)) / 2
            good.append(low < score < high)
        return 100 * np.mean(good)

    return value


def raw(answers, recordings):
    """Whether the positions are the readings themselves."""
    pairs = zip(answers, recordings, strict=True)
    return all(np.allclose(pair(answer)[0][:, 0], inputs[0]) for answer, (inputs, _) in pairs)


def gained(cov, Q=Q, move=lambda P: F @ P @ F.T):
    """What each of the first corrections has added to P⁻¹: Hᵀ H / R, where P follows from F and Q, or in another way."""
    return np.linalg.inv(cov[1:20]) - np.linalg.inv(move(cov[:19]) + Q)


def one_R(added):
    """The R of corrections with a reading of the position; None where something else has been done."""
    R = 1 / added[:, 0, 0]
    others = abs(added[:, [0, 1], [1, 1]]).max(axis=1)
    good = np.all(others < 1e-5 + 1e-3 * abs(added[:, 0, 0])) and np.ptp(R) < 0.02 * abs(np.mean(R))
    return float(np.mean(R)) if good and np.mean(R) > 0 else None


def used_Q(cov):
    """The Q that a filter uses, beside the right one (a factor), if it has no corners and any R; None where there is none."""
    A, P = (F @ cov[:19] @ F.T), cov[1:20]
    R = A[:, 0, 1] * P[:, 0, 0] / (A[:, 0, 1] - P[:, 0, 1])
    before = P + P[:, :, :1] @ P[:, :1, :] / (R - P[:, 0, 0])[:, None, None]
    factors = np.diagonal(before - A, axis1=1, axis2=2)[5:] / np.diag(Q)
    factor = np.median(factors)
    return float(factor) if np.all(abs(factors - factor) < 0.05 * abs(factor)) and factor > 0 else None


NEARLY = "Your R is nearly right in most recordings. An R that is found from more of the readings, or in another way, comes nearer."
BY_HAND = [
    (
        np.var,
        "Your R is the variance of the readings. The ship moves, and the way that it goes must not be counted as noise: R is the "
        "variance of the readings' errors.",
    ),
    (
        lambda z: np.mean(np.diff(z) ** 2),
        "Your R is the mean of the squared differences of neighbours. A difference holds the errors of two readings, 2R, and the way "
        "that the ship goes in a second, squared.",
    ),
    (
        lambda z: np.var(np.diff(z)),
        "Your R is the variance of the differences of neighbours, which hold the errors of two readings each: it is about 2 times R.",
    ),
]


def roots(covs):
    """Whether the covariances are roots, entry by entry, of those of a filter."""
    try:
        return all(one_R(gained(np.square(cov))) is not None for cov in covs)
    except np.linalg.LinAlgError:
        return False


MOVES = {
    "P + Q, without F": lambda P: P,
    "Fᵀ P F + Q": lambda P: F.T @ P @ F,
    "F P + Q, without Fᵀ": lambda P: F @ P,
}


def moved(covs):
    """How P is predicted, where it is not F P Fᵀ + Q and one R explains each recording; else None."""
    for name, move in MOVES.items():
        if all(one_R(gained(cov, move=move)) is not None for cov in covs):
            return f"Your P is predicted as {name}. Wanted is F P Fᵀ + Q, with F = [[1, 1], [0, 1]]: an uncertain speed makes the position less certain."
    return None


def of_the_means(answers, recordings, Rs):
    """What is said of means that do not move by the gain that P says; None where they do."""
    for answer, ((z,), _), R in zip(answers, recordings, Rs, strict=True):
        mean, cov = pair(answer)
        ahead = mean[:19] @ F.T
        right = ahead + cov[1:20, :, 0] / R * (z[1:20] - ahead[:, 0])[:, None]  # P Hᵀ / R is the gain
        if not np.allclose(mean[1:20], right, rtol=1e-3, atol=0.02 * np.sqrt(R)):
            return (
                "Your P is that of a filter with about the right R. But the means do not follow with it: predict x by F, and add "
                "K times the reading minus the predicted position, with the K of the same step."
            )
    return None


def uses(answers, recordings, first):
    """Whether the mean of row k + 1 has moved by the gain, with F, from row k to reading k + first."""
    fits = []
    for answer, ((z,), _) in zip(answers, recordings, strict=True):
        mean, cov = pair(answer)
        ahead, K = mean[:19] @ F.T, cov[1:20, :, 0] / one_R(gained(cov))
        right = ahead + K * (z[first : first + 19] - ahead[:, 0])[:, None]
        fits.append(np.allclose(mean[1:20], right, rtol=1e-3, atol=1e-3 * np.std(z)))
    return all(fits)


def too_early(answers, recordings):
    """What is said of beliefs of which the first is the start, or the prediction for the first reading; else None."""
    covs = [pair(answer)[1] for answer in answers]
    if all(np.allclose(cov[0], COV, rtol=1e-6) and one_R(gained(cov)) for cov in covs):
        words = "Your first P is the start itself, one second before the first reading."
        if uses(answers, recordings, 0):
            return f"{words} You return the beliefs before each reading; wanted are those after it."
        lost = " The first reading is not used." if uses(answers, recordings, 1) else ""
        return f"{words}{lost} Predict from the start to the first reading, and correct with it."
    undo = np.linalg.inv(F)
    after = [undo @ (cov[1:] - Q) @ undo.T for cov in covs]
    Rs = [one_R(np.linalg.inv(P[:19]) - np.linalg.inv(cov[:19])) for P, cov in zip(after, covs, strict=True)]
    first = all(np.allclose(cov[0], F @ COV @ F.T + Q, rtol=1e-6) for cov in covs)
    if first and all(R and R < 1e5 for R in Rs):
        return "Your P is that of the prediction for each reading; wanted are the beliefs after it. Append after the correction."
    return None


def of_Q_or_many_R(covs):
    """What is said where no single R explains a recording: another prediction, another Q, or an R for each reading."""
    if words := moved(covs):
        return words
    factors = [used_Q(cov) for cov in covs]
    if None not in factors and any(abs(factor - 1) > 0.05 for factor in factors):
        return (
            f"In recording 1 your P grows in each prediction by {factors[0]:.2g} times the Q that is given. "
            "Only R is unknown: Q stays as it is, and P is not scaled."
        )
    low, high = np.quantile(used_R(covs[0], F, Q, np.eye(1, 2)), [0.1, 0.9])
    if high > 5 * low > 0:
        return (
            f"In recording 1 your P is that of an R which changes from reading to reading, mostly between {low:.3g} and {high:.3g} m². "
            "Do you find R anew each time? Find one from the whole recording. If not, look at both lines of P, and at the order of the states."
        )
    return (
        "Your P does not follow from F P Fᵀ + Q and corrections with one R in each recording. Is the order position, speed? Are both "
        "lines of P as in lesson 3, and does R stay the same through a recording?"
    )


def named(answers, recordings):
    """What a filter does that can be seen in its covariances: a start, a Q or an R that are not right; else None."""
    covs = [pair(answer)[1] for answer in answers]
    if raw(answers, recordings):
        return "Your positions are the readings themselves, whose variance is R: a filter with the right R is nearer to the truth."
    if all(
        np.allclose(gained(cov, 0 * Q)[:, 1], 0, atol=1e-6 * np.abs(np.linalg.inv(cov[1:20])).max()) for cov in covs
    ):
        return "Your P moves with F but gains no Q. Is Q added in each prediction?"
    if roots(covs):
        return "You return the root of P. Return P itself: it holds variances, and its root is no covariance."
    if words := too_early(answers, recordings):
        return words
    Rs = [one_R(gained(cov)) for cov in covs]
    if any(R is None for R in Rs):
        return of_Q_or_many_R(covs)
    first = [np.linalg.inv(cov[0]) - np.linalg.inv(F @ COV @ F.T + Q) for cov in covs]
    if not all(abs(each[0, 0] * R - 1) < 0.05 and abs(each[1, 1]) < 1e-4 for each, R in zip(first, Rs, strict=True)):
        return (
            "R and Q are used as they should be, but your first P does not follow from the start that is given: "
            "N([0, 0], diag(50², 5²)), one second before the first reading."
        )
    for formula, words in BY_HAND:
        if np.allclose(Rs, [formula(z) for (z,), _ in recordings], rtol=0.02):
            return words
    words = of_R(np.array(Rs), np.array([np.var(z - truth[:, 0]) for (z,), truth in recordings]))
    return words or of_the_means(answers, recordings, Rs) or NEARLY


def of_R(used, right):
    """What is said of the R of all recordings; None where they are near to what they should be."""
    ratio = used / right
    alike = np.exp(np.std(np.log(ratio))) < 1.4
    if np.ptp(used) < 1e-6 * used.max():
        words = f"You use the same R, {used[0]:.3g} m², in every recording. Each sensor has its own: find it in the readings."
        searched = " If you searched for R: the sum of y²/S alone always prefers the largest. Add log S."
        return words + (searched if used[0] > 0.5 * right.max() else "")
    if alike and 0.75 < np.median(ratio) < 1.35:
        return None
    if alike:
        return f"The R of your filter is about {np.median(ratio):.2g} times the variance of the readings' errors. Is a factor wrong, or missing?"
    if np.exp(np.std(np.log(used / np.sqrt(right)))) < 1.4:
        return "The R of your filter is about the standard deviation of the readings' errors, in metres. R is a variance: the square."
    if np.median(ratio) > 1.35:
        worst = int(np.argmax(ratio))
        return (
            f"Your R is too large: in recording {worst + 1} it is {_times(ratio[worst])} times the variance of the readings' errors. "
            "The ship moves: is the way that it goes counted as noise? Or does a search for R stop too early?"
        )
    return (
        f"Your R is wrong by a factor that is different in each recording, from {ratio.min():.2g} to {ratio.max():.2g}. "
        "Is it made of too few readings, or of something else than their errors?"
    )


def _times(ratio):
    return f"{ratio:,.0f}" if ratio > 10 else f"{ratio:.2g}"


def look(otherwise):
    """What to look at: what can be seen in means and covariances, or something else where a P has no inverse."""

    def words(answers, recordings):
        try:
            return named(answers, recordings)
        except np.linalg.LinAlgError:
            return Likely(otherwise)

    return words


# ---- designs


def run(z, R, Q=Q):
    """The lesson's filter: the means, the covariances and the NIS."""
    x, P, means, covs, scores = MEAN, COV, [], [], []
    for reading in z:
        x, P = F @ x, F @ P @ F.T + Q
        innovation, S = reading - x[0], P[0, 0] + R
        K = P[:, 0] / S
        x, P = x + K * innovation, P - np.outer(K, P[0])
        means.append(x)
        covs.append(P)
        scores.append(innovation**2 / S)
    return np.array(means), np.array(covs), np.array(scores)


def by_differences(z):
    """R from the second differences, which contain hardly anything but noise: six times R."""
    return run(z, np.var(np.diff(z, 2)) / 6)[:2]


def by_scale(z):
    """R scaled by the NIS, four times: where the filter is surprised too often, R was too small."""
    R = 100.0
    for _ in range(4):
        R = R * np.mean(run(z, R)[2])
    return run(z, R)[:2]


def by_median(z):
    """R from the middle of the second differences, which a few wild readings would not change."""
    return run(z, (np.median(abs(np.diff(z, 2))) / 0.6745) ** 2 / 6)[:2]


PASSING = {
    "second differences": by_differences,
    "R times the NIS, four times": by_scale,
    "median of second differences": by_median,
}
FAILING = {
    "the lesson's R": lambda z: run(z, 100.0)[:2],
    "ignores the readings": lambda z: run(z, 1e12)[:2],
    "raw readings": lambda z: (np.stack([z, 0 * z], axis=1), np.tile(np.diag([np.var(np.diff(z)) / 2, 25]), (STEPS, 1, 1))),
    "too modest": lambda z: run(z, np.var(np.diff(z, 2)))[:2],
    "too sure": lambda z: run(z, np.var(np.diff(z, 2)) / 36)[:2],
    "Q forgotten": lambda z: run(z, np.var(np.diff(z, 2)) / 6, 0 * Q)[:2],
    "R from the scatter of z": lambda z: run(z, np.var(z))[:2],
}  # fmt: skip
