"""Wrong answers to exercises that an eleventh group of strangers gave, each with its sentence."""

import numpy as np

from kflearn.exercises._fitted_R import best


def at_rest(time, z, until):
    return z[(time < until) & ~np.isnan(z)]


def taken_from_a_turn(east, north):
    """A negative angle is taken from the full circle, not added to it."""
    angle = np.arctan2(north, east)
    return angle if angle > 0 else 2 * np.pi - angle


def back_from(x, P, P_minus, F, x_next, P_next, star=False):
    """The step back with this P⁻; star: only its covariance is made entry by entry."""
    G = P @ F.T @ np.linalg.inv(P_minus)
    less = P_next - P_minus
    return x + G @ (x_next - F @ x), P + (G**2 * less if star else G @ less @ G.T)


def fused(x, P, x_back, P_back):
    V = 1 / (1 / P + 1 / P_back)
    return V * (x / P + x_back / P_back), V


def z_itself_taken_off(x, P, x_back, P_back, z, R):
    mean, V = fused(x, P, x_back, P_back)
    left = 1 / (1 / V - 1 / R)
    return mean - left / R * z, left


def undone_with_the_gain(x, P, x_back, P_back, z, R):
    mean, V = fused(x, P, x_back, P_back)
    return mean - V / R * (z - mean), V + V**2 / R


def bridged(z):
    """Straight lines in the gaps."""
    k, seen = np.arange(len(z)), ~np.isnan(z)
    return np.interp(k, k[seen], z[seen])


def terms(y, S):
    return -0.5 * (np.log(2 * np.pi * S) + y**2 / S)


def from_the_smoothed_line(z, Q):
    """The R that is the mean squared distance of the readings, without the first, from the line smoothed with it."""
    seen, steps, R = ~np.isnan(z), np.diff(np.eye(len(z)), axis=0), np.nanvar(z)
    for _ in range(30):
        level = np.linalg.solve(np.diag(seen / R) + steps.T @ steps / Q, np.where(seen, z, 0) / R)
        R = np.nanmean((z - level)[1:] ** 2) + 1e-12
    return R


WRONG = {
    "mended_bearing": {
        "taken from a full circle": (
            taken_from_a_turn,
            "Right in the north. In the south your bearings are larger than a full circle: `arctan2` is negative there, "
            "and a negative angle is *added* to 2π.",
        ),
        "arcsine": (
            lambda east, north: np.arcsin(north / np.hypot(east, north)) % (2 * np.pi),
            "Right in the east. A target in the west gets the bearing of its mirror image in the east: the sign of "
            "`east` is lost, as in an arcsine. `arctan2` looks at both signs.",
        ),
        "1000 m further north": (
            lambda east, north: np.arctan2(north - 1000, east) % (2 * np.pi),
            "That is the bearing from a place 1000 m north of the station. `north` is counted from the station "
            "already: nothing is to be subtracted.",
        ),
    },
    "bearing_variance": {
        "in full turns": (
            lambda sd: (sd / 360) ** 2,
            "That is the variance in full turns, squared: (sd / 360)². The filter counts in radians, and a full turn "
            "has 2π of them.",
        ),
        "of 39 readings": (
            lambda sd: np.radians(sd) ** 2 / 39,
            "That is the right number divided by 39. R says how far *one* reading scatters, however many there are.",
        ),
        "the published R as a factor": (
            lambda sd: 0.1 * np.pi / 180 * sd**2,
            "That is 0.1 · π/180 times sd². The 0.1 is one sensor's σ, and `sd` stands in its place. "
            "Square the whole: the factor π/180 too.",
        ),
    },
    "one_step_back": {
        "from the next, towards the filter": (
            (4.5, 1.4375),
            "That begins with N(6, 2) and moves it towards N(4, 3). Step k is asked for: begin with the filter's "
            "N(4, 3), and compare N(6, 2) with the prediction N(4, 4).",
        ),
    },
    "step_back": {
        "Q before the step": (
            lambda x, P, F, Q, x_next, P_next: back_from(x, P, F @ (P + Q) @ F.T, F, x_next, P_next),
            "It answers as if P⁻ were F (P + Q) Fᵀ. Q is added after the step, when F P Fᵀ is done.",
        ),
        "G squared entry by entry": (
            lambda x, P, F, Q, x_next, P_next: back_from(x, P, F @ P @ F.T + Q, F, x_next, P_next, star=True),
            "The mean is right. In the covariance each entry of P_next − P⁻ is multiplied by the square of an entry of "
            "G. For matrices G stands on the left and Gᵀ on the right, with `@`.",
        ),
    },
    "smoothed_cov": {
        "the smaller determinant": (
            lambda P, P_back: P if np.linalg.det(P) < np.linalg.det(P_back) else P_back,
            "That is whichever of the two has the smaller determinant. Both know something: fuse them, and the result "
            "is surer than either.",
        ),
    },
    "count_once": {
        "z taken off the fused mean": (
            z_itself_taken_off,
            "The variance is right. Your mean is the fused one, less z times variance/R: the fused mean keeps its old "
            "weights. Take z/R out of the weighted sum first, and multiply all of it by the new variance.",
        ),
        "undone with a gain": (
            undone_with_the_gain,
            "It answers as if z were undone with the gain V/R, V being the variance of both beliefs together. That is "
            "about right only if R is much larger than V. Take 1/R out of the information instead.",
        ),
    },
    "one_reading": {
        "chi-square": (
            -0.5 * (np.log(2 * np.pi * 1.8) + 1.8),
            "−2.11 is the logarithm of the chi-square density of y²/S = 1.8. Wanted is the density of the reading "
            "itself: a bell with the variance S = 5 V².",
        ),
        "in units of σ": (
            -0.5 * (np.log(2 * np.pi) + 1.8),
            "−1.82 is right for a bell of variance 1, as if y were counted in units of √S. In volts the bell is wider, "
            "and so lower: the logarithm is that of 2πS.",
        ),
        "per cent": (
            100 * np.exp(-0.9) / np.sqrt(2 * np.pi * 5),
            "7.25 is the density itself, times 100. Its natural logarithm was asked for, which is negative here.",
        ),
    },
    "log_likelihood": {
        "first left out": (
            lambda y, S: np.nansum(terms(y, S)[1:]),
            "It answers as if the first step were left out. Each reading that is there counts, the first one too.",
        ),
        "gaps bridged": (
            lambda y, S: np.sum(terms(bridged(y), S)),
            "It answers as if straight lines filled the gaps, and counted as readings. A missing reading counts "
            "nothing: leave it out.",
        ),
    },
    "fitted_R": {
        "gaps bridged": (
            lambda z, Q: best(bridged(z), Q),
            "That is about what comes out if straight lines fill the gaps, and count as readings. Leave NaN in: the "
            "filter only predicts there.",
        ),
        "distance from the smoothed line": (
            from_the_smoothed_line,
            "That is about the mean squared distance of the readings from the smoothed line. The line follows the very "
            "readings, so this is too small. Find the largest likelihood.",
        ),
    },
    "interval_of_R": {
        "drawn in by √41": (
            (0.09 - (0.09 - 0.0607) / np.sqrt(41), 0.09 + (0.147 - 0.09) / np.sqrt(41)),
            "These are the right limits, drawn in towards 0.09 by a factor √41. All 41 readings are counted in "
            "chi-square already: nothing is divided by √41.",
        ),
    },
    "clock": {
        "rows times the median": (
            lambda time, z: np.diff(np.flatnonzero(~np.isnan(z))) * np.median(np.diff(time)),
            "It answers as if each row came one median step after the row before. The clock runs unevenly: take the "
            "time stamps of the rows that hold a reading.",
        ),
        "whole seconds": (
            lambda time, z: np.maximum(1, np.round(np.diff(time[~np.isnan(z)]))),
            "Your steps are rounded to whole seconds, and none is shorter than 1 s. Leave each step as long as the "
            "clock says.",
        ),
        "gradient": (
            lambda time, z: np.gradient(time[~np.isnan(z)]),
            "One number too many: each but the first and last is the mean of the step before a reading and the one "
            "after it, as `np.gradient` makes it. A step goes from one reading to the next.",
        ),
    },
    "variance_at_rest": {
        "about the mean of all": (
            lambda time, z, until: (
                np.sum((at_rest(time, z, until) - np.nanmean(z)) ** 2) / (len(at_rest(time, z, until)) - 1)
            ),
            "The squares are taken about the mean of the *whole* record. Take them about the mean of the readings at "
            "rest.",
        ),
        "of the mean": (
            lambda time, z, until: np.var(at_rest(time, z, until), ddof=1) / len(at_rest(time, z, until)),
            "That is the right number, divided once more by the number of readings: the variance of their *mean*. R is "
            "the variance of one reading.",
        ),
    },
}
