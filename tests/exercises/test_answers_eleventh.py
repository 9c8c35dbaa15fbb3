"""What answers to lessons 15, 23, 24, 27 must get that an eleventh group of strangers handed in: their own answers."""

import numpy as np
import pytest
from scipy.stats import chi2, norm

from kflearn import diffuse_start, fit, kalman_filter, random_walk, rts_smoother
from tests.exercises.hand_in import assert_told

# ---- the strangers' own answers, one for each sentence


def from_the_full_circle(east, north):
    angle = np.arctan2(north, east)
    return angle if angle > 0 else 2 * np.pi - angle


def by_arcsin(east, north):
    return np.arcsin(north / np.hypot(east, north)) % (2 * np.pi)


def height_subtracted(east, north):
    return np.arctan2(north - 1000, east) % (2 * np.pi)


def published_R(sd):
    R = 0.1 * np.pi / 180
    return R * sd**2


def Q_first(x, P, F, Q, x_next, P_next):
    P_minus = F @ (P + Q) @ F.T
    G = P @ F.T @ np.linalg.inv(P_minus)
    return x + G @ (x_next - F @ x), P + G @ (P_next - P_minus) @ G.T


def stars(x, P, F, Q, x_next, P_next):
    P_pred = F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(P_pred)
    mean = x + G @ (x_next - F @ x)
    cov = P + G**2 * (P_next - P_pred)
    return mean, cov


def more_certain(P, P_back):
    if np.linalg.det(P) < np.linalg.det(P_back):
        return P
    return P_back


def after_the_fusion(x, P, x_back, P_back, z, R):
    V = 1 / (1 / P + 1 / P_back)
    m = V * (x / P + x_back / P_back)
    V_new = 1 / (1 / V - 1 / R)
    return m - V_new / R * z, V_new


def one_correction_undone(x, P, x_back, P_back, z, R):
    V = 1 / (1 / P + 1 / P_back)
    mean = V * (x / P + x_back / P_back)
    return mean - V / R * (z - mean), V + V**2 / R


def without_the_first(y, S):
    y, S = y[1:], S[1:]
    return -0.5 * np.nansum(np.log(2 * np.pi * S) + y**2 / S)


def filled_by_a_line(y, S):
    k = np.arange(len(y))
    ok = np.isfinite(y)
    y = np.interp(k, k[ok], y[ok])
    return -0.5 * np.sum(np.log(2 * np.pi * S) + y**2 / S)


def fitted_to_bridges(z, Q):
    k, ok = np.arange(len(z)), ~np.isnan(z)
    whole = np.interp(k, k[ok], z[ok])
    return fit(lambda R: random_walk(Q, R), whole, {"R": float(np.var(whole))}).parameters["R"]


def about_the_smoothed_line(z, Q):
    R = float(np.nanvar(z))
    for _ in range(30):
        m = random_walk(Q, R)
        start = diffuse_start(m, z)
        track = kalman_filter(start.model, z[start.steps :], start.belief)
        level = rts_smoother(start.model, track).mean[:, 0]
        R = float(np.nanmean((z[start.steps :] - level) ** 2)) + 1e-12
    return R


def drawn_in():
    low, high = 0.0607, 0.147
    return 0.09 - (0.09 - low) / np.sqrt(41), 0.09 + (high - 0.09) / np.sqrt(41)


def rows_by_median(time, z):
    rows = np.flatnonzero(~np.isnan(z))
    return np.diff(rows) * np.median(np.diff(time))


def at_least_one(time, z):
    steps = np.diff(time[~np.isnan(z)])
    return np.maximum(1, np.round(steps))


def before_and_after(time, z):
    return np.gradient(time[np.isfinite(z)])


def about_the_whole_column(time, z, until):
    s = z[(time < until) & ~np.isnan(z)]
    return np.sum((s - np.nanmean(z)) ** 2) / (len(s) - 1)


def divided_again(time, z, until):
    s = z[(time < until) & ~np.isnan(z)]
    return s.var(ddof=1) / len(s)


ANSWERS = [
    ("bearings_only.mended_bearing", from_the_full_circle, "a negative angle is *added* to 2π"),
    ("bearings_only.mended_bearing", by_arcsin, "its mirror image in the east"),
    ("bearings_only.mended_bearing", height_subtracted, "a place 1000 m north of the station"),
    ("bearings_only.bearing_variance", lambda sd: (sd / 360) ** 2, "the variance in full turns, squared"),
    ("bearings_only.bearing_variance", lambda sd: np.radians(sd) ** 2 / 39, "divided by 39"),
    ("bearings_only.bearing_variance", published_R, "0.1 · π/180 times sd²"),
    (
        "bearings_only.twin_velocity",
        tuple(3 * (np.array([3, -2]) - [6, 0]) + [6, 0]),
        "three times the relative one plus ours",
    ),
    ("smoothing.one_step_back", (6 + 0.75 * (4 - 6), 2 + 0.75**2 * (3 - 4)), "begins with N(6, 2)"),
    ("smoothing.step_back", Q_first, "as if P⁻ were F (P + Q) Fᵀ"),
    ("smoothing.step_back", stars, "the square of an entry of G"),
    ("smoothing.smoothed_cov", more_certain, "whichever of the two has the smaller determinant"),
    ("smoothing.count_once", after_the_fusion, "the fused mean keeps its old weights"),
    ("smoothing.count_once", one_correction_undone, "as if z were undone with the gain V/R"),
    (
        "let_the_data_choose.one_reading",
        round(float(np.log(2 * norm.sf(3 / np.sqrt(5)))), 2),
        "The logarithm of the probability to be so far off",
    ),
    ("let_the_data_choose.one_reading", float(chi2.logpdf(9 / 5, df=1)), "the chi-square density"),
    ("let_the_data_choose.one_reading", -0.5 * (np.log(2 * np.pi) + 3**2 / 5), "right for a bell of variance 1"),
    (
        "let_the_data_choose.one_reading",
        round(100 * np.exp(-0.9) / np.sqrt(2 * np.pi * 5), 2),
        "the density itself, times 100",
    ),
    ("let_the_data_choose.log_likelihood", without_the_first, "as if the first step were left out"),
    ("let_the_data_choose.log_likelihood", filled_by_a_line, "as if straight lines filled the gaps"),
    ("let_the_data_choose.half_missing", 4**2 / 2, "4 is the mean of y² already"),
    ("let_the_data_choose.fitted_R", fitted_to_bridges, "straight lines fill the gaps"),
    ("let_the_data_choose.fitted_R", about_the_smoothed_line, "from the smoothed line"),
    ("your_data.interval_of_R", drawn_in(), "drawn in towards 0.09 by a factor √41"),
    ("your_data.milliseconds_for_seconds", (np.sqrt(0.1) / 1000**3) ** 2, "q is no σ, so nothing is squared"),
    ("your_data.clock", rows_by_median, "one median step after the row before"),
    ("your_data.clock", at_least_one, "rounded to whole seconds"),
    ("your_data.clock", before_and_after, "One number too many"),
    ("your_data.variance_at_rest", about_the_whole_column, "the mean of the *whole* record"),
    ("your_data.variance_at_rest", divided_again, "the variance of their *mean*"),
]


@pytest.mark.parametrize(("name", "answer", "words"), ANSWERS)
def test_an_answer_is_told(name, answer, words):
    assert_told(name, answer, words)
