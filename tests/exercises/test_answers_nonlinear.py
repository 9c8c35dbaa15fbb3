"""Answers of lessons 13 to 18 that a stranger handed in: what each of them must get."""

import numpy as np
import pytest

from kflearn.exercises import _radar, _radar_signs
from kflearn.exercises._radar import F, Q, R, against, converted, extended
from tests.exercises.hand_in import asked


def numerator_only(x):
    r, turn = np.hypot(x[0], x[2]), x[2] * x[1] - x[0] * x[3]
    return np.array([[x[0] / r, 0, x[2] / r, 0], [x[2] * turn / r**3, x[0] / r, x[3] / r, x[2] / r]])


def in_degrees(r, angle, sd_r, sd_angle):
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    J = np.array([[c, -r * s], [s, r * c]])
    return J @ np.diag([sd_r**2, sd_angle**2]) @ J.T


def deviation_for_R(x, P, reading, nominal):
    H = nominal / np.hypot(nominal, 20)
    K = P * H / (H * P * H + 2)
    return x + K * (reading - np.hypot(nominal, 20) - H * (x - nominal)), (1 - K * H) * P


def joseph(z, mean, cov):
    """The extended filter in another form."""
    x, P, rows = mean, cov, []
    for reading in z:
        x, P = F @ x, F @ P @ F.T + Q
        y, H = against(reading, x, wrap=True)
        K = np.linalg.solve(H @ P @ H.T + R, H @ P).T
        x, P = x + K @ y, (np.eye(4) - K @ H) @ P @ (np.eye(4) - K @ H).T + K @ R @ K.T
        rows.append((x, P))
    return [x for x, _ in rows], [P for _, P in rows]


def never_corrected(z, mean, cov):
    x, P, means, covs = mean, cov, [], []
    for reading in z:
        x, P = F @ x, F @ P @ F.T + Q
        y, H = against(reading, x, wrap=True)
        x = x + P @ H.T @ np.linalg.solve(H @ P @ H.T + R, y)
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)


def predictions(z, mean, cov):
    means, covs = extended(z, mean, cov)
    return np.vstack([F @ mean, means[:-1] @ F.T]), np.stack([F @ P @ F.T + Q for P in (cov, *covs[:-1])])


def another_order(z, mean, cov):
    means, covs = extended(z, mean, cov)
    return means[:, [0, 2, 1, 3]], covs[:, [0, 2, 1, 3]][:, :, [0, 2, 1, 3]]


def another_t0(e, v, t0, t):
    t0 = 3.7
    b = -(v + e / t0) / (2 * t0**2)
    return (e / t0 - b * t0**2) * t + b * t**3


def time_gone(e, v, t0, t):
    b = -(v + e / t0) / (2 * t0**2)
    return (e / t0 - b * t0**2) * (t0 - t) + b * (t0 - t) ** 3


def H_forgotten(sigma, turn, across):
    H = np.sin(np.radians(turn))
    K = sigma**2 * H / (H**2 * sigma**2 + across**2)
    return np.sqrt(abs((1 - K) * sigma**2))


def mean_distances(error):
    return [np.sqrt(np.linalg.norm(error[..., k : k + 3], axis=-1).mean(axis=0)) for k in (0, 3, 6)]


def symmetric_root(mean, P, Q, scale):
    w, V = np.linalg.eigh(scale * (P + Q))
    L = (V * np.sqrt(w)) @ V.T
    return np.vstack([mean, mean + L, mean - L])


def two_seconds(stays, T):
    T = 2
    q = T / np.asarray(stays, float)
    return np.diag(1 - q) + (1 - np.eye(len(stays))) * q[:, None] / (len(stays) - 1)


def samples_for_runs(z, T):
    speed = (z[:, 1] - z[:, 0]) / T
    return z[0], np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)


LKF, OPEN = "linearised_and_extended", "linearised_and_extended.range_and_bearing"
ANSWERS = [
    (f"{LKF}.widest_belief", np.sqrt(402**2 - 400**2), "right", ""),
    (f"{LKF}.widest_belief", np.sqrt(2 * 400), "wrong", "has only one of them"),
    (f"{LKF}.widest_belief", 2**2 / 800, "wrong", "a belief 2 m wide"),
    (f"{LKF}.mended_slope", numerator_only, "wrong", "the numerator alone"),
    (f"{LKF}.into_the_plane", lambda r, a, sd_r, sd_a: np.diag([sd_r**2, (r * sd_a) ** 2]), "wrong", "turned against"),
    (f"{LKF}.into_the_plane", in_degrees, "wrong", "in radians already"),
    (f"{LKF}.linearised_correction", deviation_for_R, "wrong", "your R is 2"),
    (OPEN, joseph, "right", ""),
    (OPEN, converted, "right", ""),
    (OPEN, never_corrected, "wrong", "Your P only grows"),
    (OPEN, predictions, "wrong", "these are the predictions"),
    (OPEN, another_order, "wrong", "in another order"),
    (OPEN, _radar.raw, "wrong", "Those are the raw readings"),
    ("extended.winner", "the LKF", "right", ""),
    ("extended.winner", "neither", "wrong", "There was a difference"),
    ("extended.winner", "UKF", "wrong", "The unscented filter is not one of the two"),
    ("extended.winner", 2, "wrong", "A word is wanted"),
    ("extended.true_starts", lambda mean, P0, normal: mean - normal * np.sqrt(np.diag(P0)), "right", "as well"),
    ("extended.true_starts", lambda mean, P0, normal: mean + normal @ np.linalg.cholesky(P0), "right", ""),
    ("extended.true_starts", lambda mean, P0, normal: mean + normal * np.sqrt(P0), "wrong", "is a matrix"),
    ("extended.both_humps", (4.4, np.sqrt(0.58)), "wrong", "with squared weights"),
    ("bearings_only.review", "Nothing is wrong", "right", ""),
    ("bearings_only.review", "(d) Nothing is wrong.", "right", ""),
    ("bearings_only.review", "reviewer D", "right", ""),
    ("bearings_only.review", "none of them", "wrong", "One of the four is right"),
    ("bearings_only.twin_velocity", np.array([[0.0], [-4.0]]), "right", ""),
    ("bearings_only.twin_velocity", [[0, -4]], "right", ""),
    ("bearings_only.twin_velocity", (6, 4), "wrong", "minus the target's, doubled"),
    ("bearings_only.bearing_variance", lambda sd: sd**2 * np.pi / 180**2, "wrong", "with π not squared"),
    ("homing_missile.left_over", another_t0, "wrong", "does not depend on t0"),
    ("homing_missile.left_over", time_gone, "wrong", "the time that has passed"),
    ("homing_missile.false_range", H_forgotten, "wrong", "That is √((1 − K)·P)"),
    ("homing_missile.figures", mean_distances, "wrong", "the mean *distance*"),
    ("unscented.declared_kappa", (-1, -4), "wrong", "−4 is λ/α²"),
    ("unscented.declared_kappa", (-3, 6), "wrong", "6 would be right for n = 6"),
    ("unscented.redrawn", symmetric_root, "wrong", "the symmetric root"),
    ("unscented.redrawn", lambda m, P, Q, s: np.linalg.cholesky(s * (P - Q)), "wrong", "You took Q off P"),
    ("unscented.start_nees", 0.0599, "wrong", "quotient of the two sums of variances"),
    ("unscented.start_nees", 0.06, "wrong", "0.06 is six times 1/100"),
    ("interacting_models.blended_sigma", np.sqrt(4100), "wrong", "3200 m² is the sum of the two squared distances"),
    ("interacting_models.transition", two_seconds, "wrong", "right for readings every 2 s"),
    ("interacting_models.mended_start", samples_for_runs, "wrong", "`z[0]` is run 1"),
    ("interacting_models.wrong_push", "no effect", "right", ""),
    ("interacting_models.wrong_push", "bigger", "wrong", "Mending does no harm"),
]


@pytest.mark.parametrize(("name", "answer", "status", "words"), ANSWERS)
def test_answer(name, answer, status, words):
    outcome = asked(name).check(answer)
    assert outcome.status == status, outcome.text
    assert words in outcome.text, outcome.text


@pytest.mark.parametrize("number", range(len(_radar_signs.MISTAKES)))
def test_each_mistake_in_the_radars_filter_is_named(number):
    design, words = _radar_signs.MISTAKES[number]
    recordings = [_radar.recording(np.random.default_rng(seed)) for seed in (1, 4)]
    assert any(np.any(abs(np.diff(inputs[0][:, 1])) > 4) for inputs, _ in recordings)  # for the short way round
    answers = [design(*inputs) for inputs, _ in recordings]
    assert _radar_signs.known(design, answers, recordings) == words


def test_the_short_way_round_is_named_in_another_filter_too():
    """Where no known filter gives these results, the recordings with a jump show the mistake."""

    def slow_gain(z, mean, cov):
        return extended(z, mean, cov, wrap=False, R=1.01 * R)

    text = asked(OPEN).check(slow_gain).text
    assert "There π and −π meet" in text, text
