"""What answers to lessons 0 to 10 must get that a tenth group of strangers handed in: their own answers."""

import numpy as np
import pytest
from scipy.stats import chi2

from kflearn import angle_difference
from tests.exercises.hand_in import asked, assert_told

# ---- the strangers' own answers, one for each sentence


def implicit(dt, mass, c):
    d = 1 / (1 + c * dt / mass)
    F = np.array([[1, dt * (1 + d) / 2], [0, d]])
    return F, np.array([[dt**2 / (2 * mass) * d], [dt / mass * d]])


def no_dt(dt, mass, c):
    F = np.array([[1, dt - c / (2 * mass)], [0, 1 - c / mass]])
    return F, np.array([[dt**2 / 2], [dt]]) / mass


def added(F, x):
    new = list(x)
    for i in range(2):
        for j in range(2):
            new[i] += F[i, j] * x[j]
    return new


def from_the_first(x, y):
    dx, dy = x - np.asarray(x)[0], y - np.asarray(y)[0]
    return np.array([[np.mean(dx * dx), np.mean(dx * dy)], [np.mean(dx * dy), np.mean(dy * dy)]])


def corner_alone(x, y):
    c = np.mean((x - x.mean()) * (y - y.mean()))
    return np.array([[np.mean(x * x), c], [c, np.mean(y * y)]])


def between_the_shares(share):
    return np.interp(share, [0, 0.395, 0.864, 0.949, 0.989], [0, 1, 2, 2.45, 3])


def two_steps():
    F, P = np.array([[1, 1], [0, 1]]), np.array([[2, 1], [1, 3]])
    for _ in range(2):
        P = F @ P @ F.T + np.diag([4, 1])
    return P.tolist()


def variances(x, P, z, H, R):
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), np.diag(np.diag((np.eye(len(x)) - K @ H) @ P))


def P_first(x, P, z, H, R):
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    P = (np.eye(len(x)) - K @ H) @ P
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), P


def first_reading(x, P, z, H, R):
    h = H[:1]
    K = P @ h.T / (h @ P @ h.T + R[:1, :1])
    return x + K @ (z[:1] - h @ x), (np.eye(len(x)) - K @ h) @ P


def Q_last(x, P, z, F, H, Q, R):
    x, P = F @ x, F @ P @ F.T
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ P + Q


def Q_inside(x, P, z, F, H, Q, R):
    x, P = F @ x, F @ P @ F.T
    K = P @ H.T @ np.linalg.inv(H @ (P + Q) @ H.T + R)
    return x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ P


def against_the_reading(var_x, var_z):
    K = var_x / (var_x + var_z)
    both, apart = var_x * (1 - K), var_x + var_z
    return apart / var_z, (1 - K) ** 2 * apart / var_z, apart / both


def one_part(var_x, var_z):
    K = var_x / (var_x + var_z)
    return var_x / var_z, (1 - K) ** 2 * var_x / var_z, var_x / (var_x * (1 - K))


def impatient(Q, R):
    P, old, K = R, 0, 1
    while abs(K - old) > 0.01:
        old = K
        P = P + Q
        K = P / (P + R)
        P = (1 - K) * P
    return K


def whole(Q, R):
    q = Q // R
    return (np.sqrt(q**2 + 4 * q) - q) / 2


def sigma_of_a_ratio():
    q = 0.1 / 0.5
    return np.sqrt((np.sqrt(q**2 + 4 * q) - q) / 2 * 0.25)


def overwritten(P, Q, dt):
    M = np.array(P, dtype=float)
    M[0, 1] += dt * M[1, 1]
    M[1, 0] += dt * M[1, 1]
    M[0, 0] += dt * (M[0, 1] + M[1, 0]) + dt**2 * M[1, 1]
    return M + Q


def afterwards(reading, x, P, R, sigmas):
    y = angle_difference(reading, x)
    y = y * R / (P + R)
    return bool(abs(y) > sigmas * np.sqrt(P + R))


def faster(away, P, Q, R):
    n = 0
    while away**2 > 9 * (P + R):
        n += 1
        P = P + n * Q
    return n


def different(refused, reading, width):
    return len({old for old in refused if abs(angle_difference(old, reading)) <= width})


def centred(refused, reading, width):
    centre = np.mean(np.append(refused, reading))
    return int(np.sum(abs(angle_difference(np.array(refused), centre)) <= width))


def one_side(refused, reading, width):
    y = np.array(refused, float) - reading
    y[y > 180] -= 360
    return int(np.sum(abs(y) <= width))


def late_Q(x, P, room, reading, Q, R):
    K = P / (P + R)
    x = x + K * (reading - x)
    P = (1 - K) * P + Q
    return x, np.sqrt(P)


def from_the_mean(z, Q, R):
    x, P = np.mean(z), R / len(z)
    for reading in z[1:]:
        P = P + Q
        K = P / (P + R)
        x = x + K * (reading - x)
        P = (1 - K) * P
    return x, P


def once(z, Q, R):
    x, P = z[0], R
    for reading in z[1:]:
        P = P + Q
        K = P / (P + R)
        x = x + K * (reading - x)
    return x, (1 - K) * P


def still_counted(x, z, mean, ignored, cov):
    up = (x[:, 0] > 0).astype(float)
    last = np.flatnonzero(up)[-1]
    a = np.sqrt(np.mean(up * (mean[:, 0] - x[:, 0]) ** 2))
    b = np.sqrt(np.mean(up * (ignored[:, 0] - x[:, 0]) ** 2))
    return a, b, np.sqrt(cov[last, 1, 1])


ANSWERS = [
    ("start_here.three_readings", np.sqrt(np.mean(np.array([61, 62, 66]) ** 2)), "the root of the mean square"),
    ("start_here.three_readings", (61 * 62 * 66) ** (1 / 3), "the geometric mean"),
    ("start_here.readings_needed", np.log2(2 / 0.25), "Three halvings lead from 2 m to 0.25 m"),
    ("start_here.root_mean_square", lambda error: np.mean(np.square(error)) ** 1 / 2, "half of the mean square"),
    ("newton_to_state_space.motion", implicit, "as if the drag belonged to the new velocity"),
    ("newton_to_state_space.motion", no_dt, "In F the drag is right at dt = 1 only"),
    ("newton_to_state_space.overwritten", added, "That is x + F x"),
    ("two_numbers.table_of", from_the_first, "distances from the first pair"),
    ("two_numbers.table_of", corner_alone, "On the diagonal stand the means of x² and y²"),
    ("two_numbers.table_length", 3 * np.sqrt(1 - 0.8), "what one reading does not share"),
    ("two_numbers.table_length", np.sqrt(18) * (1 - 0.8), "a fifth of the σ of independent readings"),
    ("two_numbers.table_length", np.sqrt(0.8 * (9 + 9)), "twice the corner, 7.2"),
    ("two_numbers.told_speed", 10 + 6 / 13 * 63, "with the whole position"),
    ("two_numbers.scale_for", lambda share: np.sqrt(-2 * np.log((1 - share) / 2)), "(1 − share)/2 outside"),
    ("two_numbers.scale_for", lambda share: chi2.ppf(share, 2) / 2, "That is k²/2"),
    ("two_numbers.scale_for", between_the_shares, "as if straight lines joined"),
    ("predict_correct.predicted_covariance", two_steps(), "what two steps of 1 s make"),
    ("predict_correct.correct", variances, "the corners of (I − K H) P are gone"),
    ("predict_correct.correct", P_first, "made of the *new* P"),
    ("predict_correct.correct", first_reading, "the first number of z alone"),
    ("predict_correct.speedometer", 60 + 6 / np.sqrt(20 * 4) * 3, "0.671 is the correlation"),
    ("predict_correct.speedometer", 60 + 6 / 5 * (13 - 60), "It is also 60 + K₁ · (13 − 60)"),
    ("predict_correct.misprints", Q_last, "is added after the correction"),
    ("predict_correct.misprints", Q_inside, "in the inverse of line three only"),
    ("gaussian_fusion.third_opinion", 61.6667 + 0.8333 / (0.8333 + 16) * (66 - 61.6667), "2² = 4 m², not 16"),
    ("gaussian_fusion.readings_needed", 3, "a variance that each reading divides by 6"),
    ("gaussian_fusion.readings_needed", int(np.ceil(1 / 0.3**4 - 1 / 5)), "124 is 1/0.3⁴"),
    ("gaussian_fusion.published_claim", against_the_reading, "ratios for distances from the *reading*"),
    ("gaussian_fusion.published_claim", one_part, "only the prediction's part of the error"),
    ("voltmeter.steady_gain", impatient, "once K changes by 0.01 or less"),
    ("voltmeter.steady_gain", whole, "rounded down to a whole number"),
    ("voltmeter.best_error", np.sqrt((1 - 8 / 12) * 8), "1.633 is √(8/3)"),
    ("tuning_the_ratio.steady_sigma", sigma_of_a_ratio(), "the ratio of two σ"),
    ("tuning_the_ratio.steady_sigma", np.sqrt((0.01 + np.sqrt(0.0101)) / 2 + 0.25), "the σ of the innovation"),
    ("tuning_the_ratio.data_sheets", [6.25, 0.09, 0.0], "would make a rounded reading exact"),
    ("tuning_the_ratio.R_with_drift", lambda z: np.mean(np.abs(np.diff(np.square(z)))) / 2, "differences of *squares*"),
    (
        "is_the_filter_honest.nees",
        lambda e, P: np.sum(np.diag(np.linalg.inv(P)) * np.asarray(e) ** 2),
        "the diagonal of P⁻¹, added up",
    ),
    ("bearing_of_a_sound.right_prediction", overwritten, "dt²·P₁₁ counts three times"),
    ("readings_that_lie.is_refused", afterwards, "as if only the part R/(P + R) of the innovation"),
    ("readings_that_lie.steps_shut", faster, "as if P grew by Q, then by 2Q"),
    ("readings_that_lie.agreeing", different, "as if equal readings counted once"),
    ("readings_that_lie.agreeing", centred, "the new one included"),
    ("readings_that_lie.agreeing", one_side, "those below −180° are not"),
    ("temperature_and_free_fall.mended_step", late_Q, "as if Q were added after the correction"),
    ("temperature_and_free_fall.room_filter", from_the_mean, "R over the number of readings"),
    ("temperature_and_free_fall.room_filter", once, "multiplied by 1 − K at the end only"),
    (
        "temperature_and_free_fall.noise",
        lambda normal, Q: normal + np.sqrt(np.diag(Q))[:, None],
        "the random numbers plus the deviations",
    ),
    ("temperature_and_free_fall.honest_report", still_counted, "the number of *all* moments"),
]


@pytest.mark.parametrize(("name", "answer", "words"), ANSWERS)
def test_an_answer_is_told(name, answer, words):
    assert_told(name, answer, words)


@pytest.mark.parametrize(
    ("name", "answer", "not_said"),
    [
        ("voltmeter.best_error", 1.63, "8/3"),
        ("tuning_the_ratio.steady_sigma", 0.301, "0.1/0.5"),
        ("gaussian_fusion.third_opinion", 61.85, "not 16"),
        ("start_here.three_readings", 62.93, "geometric"),
    ],
)
def test_an_answer_near_one_of_them_does_not_get_its_sentence(name, answer, not_said):
    assert not_said not in asked(name).check(answer).text
