"""Wrong answers to exercises of lessons 0 to 10 that a tenth group of strangers gave, each with its sentence."""

import numpy as np

from kflearn import angle_difference
from kflearn.exercises import _slips_tenth_functions as tried

WRONG = {
    "three_readings": {
        "root mean square": (
            lambda: np.sqrt((61**2 + 62**2 + 66**2) / 3),
            "63.04 is the root of the mean square. The mean takes the readings as they are: their sum, divided by "
            "three.",
        ),
        "geometric": (
            lambda: (61 * 62 * 66) ** (1 / 3),
            "62.96 is the cube root of 61 · 62 · 66, the geometric mean. For the mean the readings are added, not "
            "multiplied.",
        ),
    },
    "root_mean_square": {
        "** 1 / 2": (
            lambda error: np.mean(error**2) / 2,
            "That is half of the mean square. `** 1 / 2` leads to it, for Python takes the power 1 first and then "
            "halves. A root is `** (1 / 2)`, or `np.sqrt`.",
        ),
    },
    "motion": {
        "drag of the new velocity": (
            tried.implicit,
            "In your F the part 1/(1 + c·dt/m) of v is left, as if the drag belonged to the new velocity. It stays "
            "what it is at the step's beginning: −c·v with the old v.",
        ),
        "no dt in either row": (
            tried.without_dt,
            "B is right. In F the drag is right at dt = 1 only: it needs dt² in the first row, as the force does in "
            "(1), and dt in the second.",
        ),
    },
    "overwritten": {
        "on top of the old state": (
            lambda F, x: x + F @ x,
            "That is x + F x: the old state is still in it. The new entries are the sums alone, so each sum begins at "
            "0.",
        ),
    },
    "table_of": {
        "from the first pair": (
            tried.from_the_first,
            "These are means of products of distances from the first pair. A deviation is the distance from the mean "
            "of the series.",
        ),
        "centred in the corners alone": (
            tried.centred_in_the_corners,
            "The corners are right. On the diagonal stand the means of x² and y²: take the mean of the series away "
            "first, there too.",
        ),
    },
    "table_length": {
        "one reading's own part": (
            lambda: np.sqrt(1.8),
            "1.34 is √1.8, and 1.8 is 9 − 7.2, or 9 · (1 − 0.8): what one reading does not share with the other. Both "
            "readings have such a part, and the length has both.",
        ),
        "independent, less 80 %": (
            lambda: 0.2 * np.sqrt(18),
            "0.849 is 0.2 · √18, a fifth of the σ of independent readings. The correlation makes the corner of P: it "
            "is the *variance* 9 + 9 from which something is taken, before the root.",
        ),
        "0.8 of the sum": (
            lambda: np.sqrt(14.4),
            "3.79 is √14.4, and 14.4 mm² is 0.8 · (9 + 9), or twice the corner, 7.2: that is what must be taken away "
            "from 9 + 9.",
        ),
    },
    "told_speed": {
        "the whole position": (
            10 + 6 / 13 * 63,
            "39.08 is 10 + 6/13 · 63, with the whole position. Only what was not expected tells something new: the 3 "
            "m beyond the 60 m.",
        ),
    },
    "scale_for": {
        "two tails": (
            lambda share: np.sqrt(-2 * np.log((1 - share) / 2)),
            "That ellipse leaves (1 − share)/2 outside. One number has two tails that share the rest; an ellipse has "
            "one outside, all around it: it holds 1 − share.",
        ),
        "half of the square": (
            lambda share: -np.log(1 - share),
            "That is k²/2, half of the chi-square quantile. k itself is asked for: two steps are left.",
        ),
        "straight lines": (
            lambda share: np.interp(share, [0, 0.395, 0.864, 0.949, 0.989], [0, 1, 2, 2.45, 3]),
            "It answers as if straight lines joined the few shares that the lesson names. The curve between them is "
            "bent, and goes on beyond them: solve share = 1 − exp(−k²/2) for k.",
        ),
    },
    "predicted_covariance": {
        "two steps of 1 s": (
            [[27, 8], [8, 5]],
            "That is what two steps of 1 s make, each with this Q. Here one step takes 2 s, and Q belongs to all of "
            "it: dt = 2 in F, and Q once.",
        ),
    },
    "correct": {
        "variances alone": (
            tried.variances_alone,
            "Your x is right, and so are the variances in P. But the corners of (I − K H) P are gone: the errors of "
            "the states belong together, so keep the whole matrix.",
        ),
        "gain of the new P": (
            tried.gain_of_the_new_P,
            "Your P is right. Your x is corrected with a gain that is made of the *new* P. One gain serves (8) and "
            "(9): that of (7), from the P that comes in.",
        ),
        "first reading alone": (
            lambda x, P, z, H, R: tried.corrected(x, P, z[:1], H[:1], R[:1, :1]),
            "That is the correction by the first number of z alone. All of them count: use the whole z, H and R.",
        ),
    },
    "speedometer": {
        "correlation": (
            lambda: 60 + 3 * 6 / np.sqrt(20 * 4),
            "62.01 is 60 + 0.671 · 3, and 0.671 is the correlation, 6/√(20 · 4), which has no unit. K₁ turns m/s into "
            "metres: the corner over the variance of the innovation.",
        ),
    },
    "misprints": {
        "Q at the end": (
            tried.Q_at_the_end,
            "The second F is gone. Q is missing in line two, and is added after the correction: the bumps come before "
            "the reading, so Q belongs to P_pred.",
        ),
        "Q in the gain alone": (
            tried.Q_in_the_gain_alone,
            "The second F is gone. Q counts in the inverse of line three only. Put it into P_pred, in line two: then "
            "it is in all that is made of P_pred.",
        ),
    },
    "third_opinion": {
        "σ squared twice": (
            61.6667 + 0.8333 / (0.8333 + 16) * 4.3333,
            "61.88 comes from K = 0.8333 / (0.8333 + 16). The satellite's σ is 2 m, so its variance is 2² = 4 m², not "
            "16.",
        ),
    },
    "readings_needed": {
        "squared twice": (
            124,
            "124 is 1/0.3⁴, with or without the 1/5, rounded up. σ = 0.3 m is squared once: the precision that is "
            "wanted is 1/0.3².",
        ),
    },
    "published_claim": {
        "against the reading": (
            tried.against_the_reading,
            "These are the ratios for distances from the *reading*: μx − z, for example, has the variance var_x + "
            "var_z. An error is the distance from the truth, and μx has var_x.",
        ),
        "the tape's part left out": (
            lambda vx, vz: (vx / vz, vz * vx / (vx + vz) ** 2, (vx + vz) / vz),
            "Two are right. In Anna's only the prediction's part of the error counts, (1 − K)²·var_x. The reading "
            "errs too, with the weight K: that part comes on top.",
        ),
    },
    "steady_gain": {
        "stopped early": (
            tried.stopped_early,
            "It answers as if the recursion stopped once K changes by 0.01 or less. Many small changes can still "
            "follow: ask for a far smaller one, or take a hundred steps.",
        ),
        "whole ratio": (
            tried.in_whole_numbers,
            "It answers as if Q/R were rounded down to a whole number, which is what `//` does: where Q is smaller "
            "than R, that is 0. Divide with `/`.",
        ),
    },
    "best_error": {
        "4 more": (
            lambda: np.sqrt(8 / 3),
            "1.633 is √(8/3): 8/3 is left when a variance of 8 is fused with one of 4. The source has the variance 4, "
            "and nothing is added to it here: each voltage is drawn anew.",
        ),
    },
    "steady_sigma": {
        "ratio of σ": (
            lambda: np.sqrt((np.sqrt(0.2**2 + 4 * 0.2) - 0.2) / 2 * 0.25),
            "0.299 comes from q = 0.2, which is 0.1/0.5, the ratio of two σ. q = Q/R is the ratio of the variances.",
        ),
        "of the innovation": (
            lambda: np.sqrt((0.01 + np.sqrt(0.0101)) / 2 + 0.25),
            "0.552 is √(P⁻ + R), the σ of the innovation: so far a reading is from its prediction. The filter claims "
            "√P for its estimate, after the reading.",
        ),
    },
    "data_sheets": {
        "(c) without error": (
            (6.25, 0.09, 0),
            "(a) and (b) are right. In (c) R = 0 would make a rounded reading exact, but it may be wrong by up to a = "
            "0.25 V, half of a step. Errors that lie evenly within ±a have the variance a²/3.",
        ),
    },
    "R_with_drift": {
        "differences of squares": (
            lambda z: np.mean(abs(np.diff(z**2))) / 2,
            "That is half the mean size of the differences of *squares*, which also grows with the voltage itself. "
            "First the difference of two neighbours, then its square.",
        ),
    },
    "nees": {
        "diagonal of the inverse": (
            lambda e, P: np.diag(np.linalg.inv(P)) @ e**2,
            "That is e² times the diagonal of P⁻¹, added up. The corners of P⁻¹ count too, with the products of two "
            "different components: put the whole P⁻¹ between two e, with `@`.",
        ),
    },
    "right_prediction": {
        "corners moved first": (
            tried.corners_moved_first,
            "Three entries are right. In the upper left dt²·P₁₁ counts three times, as if the corners had been "
            "overwritten before they are used there. It counts once: use the old corners.",
        ),
    },
    "is_refused": {
        "after the correction": (
            lambda z, x, P, R, sigmas: abs(angle_difference(z, x)) * R / (P + R) > sigmas * np.sqrt(P + R),
            "It answers as if only the part R/(P + R) of the innovation were compared, what is left of it after a "
            "correction. The gate stands before the correction: compare the whole innovation.",
        ),
    },
    "steps_shut": {
        "1 + 2 + 3": (
            tried.growing_faster,
            "It answers as if P grew by Q, then by 2Q, then by 3Q. Each step adds Q alone: after n steps that is nQ.",
        ),
    },
    "agreeing": {
        "different ones": (
            lambda old, z, w: np.sum(abs(angle_difference(np.unique(old), z)) <= w),
            "It answers as if equal readings counted once. Two refused readings with the same number are two: count "
            "them both.",
        ),
        "mean of all and the new one": (
            lambda old, z, w: np.sum(abs(angle_difference(old, np.mean(np.append(old, z)))) <= w),
            "It answers as if each reading were compared with the mean of all, the new one included. Compare each "
            "with the new one itself.",
        ),
        "one side wrapped": (
            tried.one_side_wrapped,
            "Differences above 180° are taken the short way round, those below −180° are not: seen from 358°, 2° is "
            "4° away. `angle_difference` does both.",
        ),
    },
    "mended_step": {
        "Q after the correction": (
            tried.Q_after_the_correction,
            "It answers as if Q were added after the correction. The room moves before it is read: P grows by Q "
            "first, and the gain is made of that P.",
        ),
    },
    "room_filter": {
        "mean, R over n": (
            lambda z, Q, R: tried.filtered(z, Q, R, np.mean(z), R / len(z)),
            "It answers as if the start were the mean of the whole series, with R over the number of readings. "
            "All but the first are still to come, and would count twice. Start at the first one alone.",
        ),
        "shrinks at the end": (
            lambda z, Q, R: tried.filtered(z, Q, R, z[0], R, shrinks=False),
            "It answers as if P were multiplied by 1 − K at the end only, and grew all the time before. It shrinks "
            "after each correction, inside the loop.",
        ),
    },
    "noise": {
        "added": (
            lambda normal, Q: normal + np.sqrt(np.diag(Q))[:, None],
            "These are the random numbers plus the deviations: they are moved, and scatter as before. A deviation "
            "stretches: multiply each row by its own.",
        ),
    },
    "honest_report": {
        "over all moments": (
            tried.over_all_moments,
            "σ is right. Your two errors are too small: the squares above the ground are divided by the number of "
            "*all* moments. Divide by the number of those above.",
        ),
    },
}
