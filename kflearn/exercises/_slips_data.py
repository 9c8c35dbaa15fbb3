"""More wrong answers to exercises of lessons 23 to 28, each with the sentence that it gets."""

from types import SimpleNamespace

import numpy as np

from kflearn.results.consistency import chi_square_interval

LOW, HIGH = chi_square_interval(1, 40)
model = SimpleNamespace(F=np.array([[1, 0.1], [0, 1]]), Q=4 * np.outer([0.005, 0.1], [0.005, 0.1]))  # the lesson's


def back(gain=None, mean=None, cov=None):
    """The step back with one part of it exchanged."""

    def wrong(x, P, F, Q, x_next, P_next):
        P_pred = F @ P @ F.T + Q
        G = gain(P, F, P_pred, P_next, Q) if gain else P @ F.T @ np.linalg.inv(P_pred)
        x_new = mean(x, F, x_next, G) if mean else x + G @ (x_next - F @ x)
        return x_new, cov(P, P_next, P_pred, G) if cov else P + G @ (P_next - P_pred) @ G.T

    return wrong


def with_the_lessons_F(x, P, F, Q, x_next, P_next):
    P_pred = model.F @ P @ model.F.T + model.Q
    G = P @ model.F.T @ np.linalg.inv(P_pred)
    return x + G @ (x_next - model.F @ x), P + G @ (P_next - P_pred) @ G.T


def met(x, P, x_back, P_back):
    """Two beliefs, fused."""
    information = 1 / P + 1 / P_back
    return (x / P + x_back / P_back) / information, 1 / information


def smoothed(K, n):
    """The right weights of exponential smoothing, newest first."""
    return np.append(K * (1 - K) ** np.arange(n - 1), (1 - K) ** (n - 1))


def published(z, K):
    """The published sum of lesson 28, with weights K(1 − K)ʲ."""
    return np.sum(K * (1 - K) ** np.arange(len(z))[::-1] * z)


LEFT_OUT = "The variance is right. In the weighted sum of the mean z still counts twice: take z/R out of it too."
SLIPS = {}
SLIPS["one_step_back"] = {
    "next known exactly": (
        (5.5, 0.75),
        "The mean is right. Your variance is that for a step k+1 which is known exactly. It is known with variance 2: 3 + G² (2 − 4).",
    ),
    "from the prediction's variance": (
        (5.5, 2.875),
        "The mean is right. The variance begins with the filter's 3, not with the predicted 4: 3 + G² (2 − 4).",
    ),
    "from the next": (
        (7.5, 1.875),
        "The variance is right. The mean begins with the filter's 4, and moves by G times (6 − 4).",
    ),
    "gain of the roots": (
        (4 + 3**0.5, 3 - 1.5),
        "Your gain is √3/2. G is a ratio of variances, P/P⁻ = 3/4.",
    ),
    "variance not moved back": ((6.0, 1.875), "The variance is right. The mean moves by a part of 6 − 4 only: by G times."),
}  # fmt: skip
SLIPS["step_back"] = {
    "P_next in the gain": (
        back(gain=lambda P, F, P_pred, P_next, Q: P @ F.T @ np.linalg.inv(P_next)),
        "Your gain divides by P_next. It divides by the prediction's covariance, P⁻ = F P Fᵀ + Q.",
    ),
    "the sum in the gain": (
        back(gain=lambda P, F, P_pred, P_next, Q: P @ F.T @ np.linalg.inv(P_pred + P_next)),
        "Your gain divides by P⁻ + P_next, as for two separate opinions. It is P Fᵀ (P⁻)⁻¹.",
    ),
    "a filter's gain": (
        back(gain=lambda P, F, P_pred, P_next, Q: P_pred @ np.linalg.inv(P_pred + P_next)),
        "Your gain is a filter's, P⁻ (P⁻ + P_next)⁻¹. The two are no separate opinions: G = P Fᵀ (P⁻)⁻¹.",
    ),
    "Q alone in the gain": (
        back(gain=lambda P, F, P_pred, P_next, Q: P @ F.T @ np.linalg.inv(P + Q)),
        "In your gain P⁻ lacks F: it is F P Fᵀ + Q.",
    ),
    "G without transpose": (
        back(cov=lambda P, P_next, P_pred, G: P + G @ (P_next - P_pred) @ G),
        "The mean is right. In the covariance the second G is transposed: G (P_next − P⁻) Gᵀ.",
    ),
    "from the next": (
        back(cov=lambda P, P_next, P_pred, G: P_next + G @ (P_next - P_pred) @ G.T),
        "The mean is right. The covariance begins with P, the filter's at step k.",
    ),
    "both from the next": (
        back(mean=lambda x, F, x_next, G: x_next + G @ (x_next - F @ x), cov=lambda P, P_next, P_pred, G: P_next + G @ (P_next - P_pred) @ G.T),
        "You begin with step k+1. Step k is asked for: begin with x and P, the filter's.",
    ),
    "x_next alone": (
        back(mean=lambda x, F, x_next, G: x + G @ x_next),
        "The covariance is right. The mean moves by G times what the prediction got wrong, x_next − F x.",
    ),
    "entry by entry": (
        back(mean=lambda x, F, x_next, G: x + np.diag(G) * (x_next - F @ x)),
        "The covariance is right. In the mean G is a matrix: `G @ (x_next - F @ x)`.",
    ),
    "the prediction's covariance": (
        back(cov=lambda P, P_next, P_pred, G: P_pred + G @ (P_next - P_pred) @ G.T),
        "The mean is right. The covariance begins with P, not with the prediction's P⁻.",
    ),
    "the lesson's F": (
        with_the_lessons_F,
        "Your function uses the model of the lesson. F and Q are arguments, and other ones in each trial.",
        r"model\.",
    ),
}  # fmt: skip
SLIPS["smoothed_cov"] = {
    "order of the product": (
        lambda P, P_back: P @ P_back @ np.linalg.inv(P + P_back),
        "The order counts with matrices: the inverse of the sum stands between the two, P (P + P_back)⁻¹ P_back.",
    ),
    "inverse first": (
        lambda P, P_back: np.linalg.inv(P + P_back) @ P @ P_back,
        "The order counts with matrices: the inverse of the sum stands between the two, P (P + P_back)⁻¹ P_back.",
    ),
    "the gain": (
        lambda P, P_back: P @ np.linalg.inv(P + P_back),
        "That is the gain, which has no unit. A covariance in m² is wanted: multiply by P_back.",
    ),
    "the other gain": (
        lambda P, P_back: P_back @ np.linalg.inv(P + P_back),
        "That is a gain, which has no unit. A covariance in m² is wanted: multiply by P.",
    ),
    "the gain, turned": (
        lambda P, P_back: np.linalg.inv(P + P_back) @ P,
        "That is a gain, which has no unit. A covariance in m² is wanted: P_back is missing on its left.",
    ),
    "gain once in P": (
        lambda P, P_back: P - P @ np.linalg.inv(P + P_back),
        "A gain is taken off a covariance. It multiplies one first: P − P (P + P_back)⁻¹ P.",
    ),
    "variances of the inverses": (
        lambda P, P_back: np.diag(np.diag(np.linalg.inv(np.linalg.inv(P) + np.linalg.inv(P_back)))),
        "The variances are right. The other entries are not zero: return the whole matrix.",
    ),
}  # fmt: skip
SLIPS["count_once"] = {
    "z left in the sum": (
        lambda x, P, x_back, P_back, z, R: (
            (x / P + x_back / P_back) / (1 / P + 1 / P_back - 1 / R),
            1 / (1 / P + 1 / P_back - 1 / R),
        ),
        LEFT_OUT,
    ),
    "R off P_back": (
        lambda x, P, x_back, P_back, z, R: met(x, P, x_back, P_back - R),
        "You subtracted R from P_back. A reading is not taken out of a variance but out of the information: 1/P_back − 1/R. And z itself must leave the mean.",
    ),
    "information, z left in": (
        lambda x, P, x_back, P_back, z, R: met(x, P, x_back, 1 / (1 / P_back - 1 / R)),
        "The variance is right. The mean x_back still holds z: take z/R out of the weighted sum.",
    ),
    "plain mean": (
        lambda x, P, x_back, P_back, z, R: ((x + x_back) / 2, (P + P_back) / 4),
        "You took the plain mean of the two. Weigh each with its information, 1/P and 1/P_back, and take z out once.",
    ),
    "plain means": (
        lambda x, P, x_back, P_back, z, R: ((x + x_back) / 2, (P + P_back) / 2),
        "You took the plain mean of the two. Weigh each with its information, 1/P and 1/P_back, and take z out once.",
    ),
    "forward alone": (
        lambda x, P, x_back, P_back, z, R: (x, P),
        "That is the forward belief. The backward one knows readings that come later: use both.",
    ),
    "backward alone": (
        lambda x, P, x_back, P_back, z, R: (x_back, P_back),
        "That is the backward belief. The forward one knows readings that came before: use both.",
    ),
    "z/R off the mean": (
        lambda x, P, x_back, P_back, z, R: (met(x, P, x_back, P_back)[0] - z / R, 1 / (1 / P + 1 / P_back - 1 / R)),
        "The variance is right. z/R is taken off the mean here; take it off the weighted sum, before you divide by the information.",
    ),
    "z off the mean": (
        lambda x, P, x_back, P_back, z, R: (met(x, P, x_back, P_back)[0] - z, 1 / (1 / P + 1 / P_back - 1 / R)),
        "The variance is right. z is taken off the mean here; take z/R off the weighted sum, before you divide by the information.",
    ),
}  # fmt: skip
SLIPS["interval_of_R"] = {
    "interval of the mean, 1.96": (
        (0.09 - 1.96 * 0.3 / 41**0.5, 0.09 + 1.96 * 0.3 / 41**0.5),
        "That is how well a *mean* is known, 1.96 σ/√n, and a variance cannot be negative. The variance has its own interval: chi-square.",
    ),
    "interval of the mean, 40": (
        (0.09 - 1.96 * 0.3 / 40**0.5, 0.09 + 1.96 * 0.3 / 40**0.5),
        "That is how well a *mean* is known, 1.96 σ/√n, and a variance cannot be negative. The variance has its own interval: chi-square.",
    ),
    "mean, with the variance": (
        (0.09 - 1.96 * 0.09 / 41**0.5, 0.09 + 1.96 * 0.09 / 41**0.5),
        "That would be the interval of a mean whose standard deviation is 0.09. The variance has its own interval: chi-square.",
    ),
    "squared": (
        (0.09**2 / HIGH, 0.09**2 / LOW),
        "That is right for 0.09². 0.09 m² is a variance already.",
    ),
    "the factors": (
        (1 / HIGH, 1 / LOW),
        "Those are the factors, and they are right. Multiply each by the sample variance, 0.09 m².",
    ),
    "rule with 41": (
        (0.09 * (1 - 1.96 * (2 / 41) ** 0.5), 0.09 * (1 + 1.96 * (2 / 41) ** 0.5)),
        "That is the rule of thumb R (1 ± 1.96 √(2/n)), symmetric about 0.09. The true interval is lopsided: it reaches further up than down.",
    ),
    "rule with 2": (
        (0.09 * (1 - 2 * (2 / 40) ** 0.5), 0.09 * (1 + 2 * (2 / 40) ** 0.5)),
        "That is the rule of thumb R (1 ± 2 √(2/n)), symmetric about 0.09. The true interval is lopsided: it reaches further up than down.",
    ),
}  # fmt: skip
SLIPS["milliseconds_for_seconds"] = {
    "the ride's q": (0.5 / 1000**3, "That is right for 0.5, the q of the ride. Here q was 0.1 m²/s³."),
    "the ride's q unchanged": (0.5, "0.5 is the q of the ride. Here q was 0.1 m²/s³; and all steps are 1000 times as long."),
    "÷ 3000": (0.1 / 3000, "That is 0.1 divided by 3 times 1000. The time stands three times in m²/s³: divide by 1000 · 1000 · 1000."),
}  # fmt: skip
SLIPS["variance_at_rest"] = {
    "mean square, n − 1": (
        lambda time, z, until: np.nansum(z[time < until] ** 2) / (np.sum(~np.isnan(z[time < until])) - 1),
        "You took the mean square about 0. Where it stood is not noise: take off the mean first.",
    ),
    "median for the mean": (
        lambda time, z, until: (
            np.nansum((z[time < until] - np.nanmedian(z[time < until])) ** 2)
            / (np.sum(~np.isnan(z[time < until])) - 1)
        ),
        "You took squares about the median. The variance is about the mean.",
    ),
    "both divided by n": (
        lambda time, z, until: np.nansum((z[time < until] - np.nanmean(z[time < until])) ** 2) / np.sum(time < until),
        "You divided by the number of rows, missing ones counted. Divide by the number of readings that are there, less one.",
    ),
}  # fmt: skip
SLIPS["exponential_weights"] = {
    "rest to the newest": (
        lambda K, n: K * (1 - K) ** np.arange(n) + np.eye(n)[0] * (1 - K) ** n,
        "The sum is 1, but the missing part went to the newest reading. It belongs to the oldest, where the estimate starts.",
    ),
    "rest to all": (
        lambda K, n: K * (1 - K) ** np.arange(n) + (1 - K) ** n / n,
        "The sum is 1, but the missing part was spread over all. It belongs to the oldest reading, where the estimate starts.",
    ),
    "added up": (
        lambda K, n: np.cumsum(smoothed(K, n)),
        "Those are running sums of the weights. Return the weights themselves.",
    ),
}  # fmt: skip
SLIPS["behind"] = {
    "the mean innovation": (
        1.30,
        "1.30 s is the mean innovation that the lesson printed, of another filter and *before* the reading. After it the estimate is nearer.",
    ),
    "all nights": (30, "30 s is what the clock gains in a hundred nights. The estimate follows it, at a distance that does not grow any more."),
    "two times (1 − K)": (
        lambda: 0.3 * (1 - 0.2207) ** 2 / 0.2207,
        "That is 0.3(1 − K)²/K, with 1 − K twice: after the night's reading it is 0.3(1 − K)/K.",
    ),
    "half": (0.15, "That is half of one night. The estimate has not caught up with the nights before either."),
    "of 2 − K": (
        lambda: 0.3 * 0.2207 / (2 - 0.2207),
        "K/(2 − K) is the share of the *noise* that is left. Here the readings have no error, and the clock drifts.",
    ),
}  # fmt: skip
SLIPS["mended"] = {
    "rest spread": (
        lambda z, K: published(z, K) + (1 - K) ** len(z) * np.mean(z),
        "The sum is 1, but the missing part was spread evenly: the ratios have changed. Divide by the sum of the weights.",
    ),
    "divided by the sum of z": (
        lambda z, K: published(z, K) / np.sum(z),
        "You divided by the sum of the readings. Divide by the sum of the weights.",
    ),
    "divided by a power": (
        lambda z, K: published(z, K) / (1 - (1 - K) ** (len(z) + 1)),
        "Close: n weights sum to 1 − (1 − K)ⁿ, with n = len(z), not n + 1.",
    ),
    "the missing part": (
        lambda z, K: published(z, K) + (1 - K) ** len(z),
        "You added the missing weight by itself. A weight multiplies a reading: divide by the sum of the weights.",
    ),
}  # fmt: skip
