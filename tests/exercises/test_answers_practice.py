"""What a second stranger answered in lessons 7 to 12: what was refused, passed or misled, or had no own sentence."""

import numpy as np
import pytest

from kflearn import Gaussian, LinearModel, angle_difference, chi_square_interval, kalman_filter, rmse
from kflearn.exercises import _cart_with_gaps as cart
from kflearn.exercises import _unknown_receiver as ship
from kflearn.exercises._combined import combined
from kflearn.exercises._speaker import gate
from tests.exercises.hand_in import asked, assert_right, assert_told

eig = np.linalg.eigvalsh


def cholesky(P):
    try:
        np.linalg.cholesky(P)
    except np.linalg.LinAlgError:
        return False
    return np.allclose(P, P.T)


def package(z, Q, R):
    track = kalman_filter(LinearModel([[1]], [[1]], [[Q]], [[R]]), z[1:, None], Gaussian([z[0]], [[R]]))
    return track.mean[-1, 0], track.cov[-1, 0, 0]


def gated(x, P, z, Q, R, sigmas=3, refused=None, accepted=None):
    P = P + Q
    y, S = angle_difference(z, x), P + R
    if y**2 > sigmas**2 * S:
        return (z, R) if refused else (x, P)
    return x + P / S * y, P if accepted else P * R / S


def entry_by_entry(P, Q, dt):
    return np.array([[P[0, 0] + dt * P[1, 0], P[0, 1] + dt * P[1, 1]], [dt * P[1, 0], P[1, 1]]]) + Q


def room(z, Q, R, x=None, P=None, end=None, once=False):
    x, P = z[0] if x is None else x, R if P is None else P
    for reading in z[1:end]:
        K = (P + Q) / (P + Q + R)
        x, P = x + K * (reading - x), (1 - K) * (P + Q)
        if once:
            break
    return x, P


def below_ground(x, z, mean, ignored, cov):
    above = x[:, 0] > 0
    number = min(above.sum(), len(cov) - 1)
    return rmse(mean[above, 0], x[above, 0]), rmse(ignored[above, 0], x[above, 0]), np.sqrt(cov[number, 1, 1])


def two_fixes(z0, z1, dt, R):
    return np.array([z1, (z1 - z0) / dt]), R * np.array([[1, 1 / dt], [1 / dt, 2 / dt**2]])


def with_trace(measure):
    return lambda one, two: min(one @ one.T, two @ two.T, key=measure)


def own_noise(normal, Q):
    return np.random.default_rng(3).multivariate_normal([0, 0], Q, normal.shape[1]).T


def own_start(mean, variances, normal):
    return np.random.default_rng(1).normal(mean, np.sqrt(variances))


def nis(z, x, P, R):
    return angle_difference(z, x) ** 2 / (P + R)


RIGHT = [
    ("bearing_of_a_sound.is_a_covariance", lambda P: (abs(P - P.T) <= 1e-9).all() and (eig(P) >= 0).all()),
    ("bearing_of_a_sound.is_a_covariance", lambda P: np.allclose(P, P.T) and np.linalg.eigvals(P).min() > -1e-9),
    ("bearing_of_a_sound.is_a_covariance", lambda P: cholesky(P + 1e-9 * np.eye(len(P)))),
    ("readings_that_lie.agreeing", lambda old, z, w: int(sum(abs(angle_difference(old, z)) <= w))),
    ("temperature_and_free_fall.room_filter", package),
    ("train_and_ship.start_variance", lambda a, b, c: np.mean((np.linspace(a, b, 20001) - c) ** 2)),
    ("numerics.posterior", with_trace(np.linalg.det)),
    ("numerics.posterior", with_trace(np.linalg.norm)),
]


@pytest.mark.parametrize(("name", "answer"), RIGHT)
def test_right_answers_pass(name, answer):
    assert_right(name, answer)


SAID = [
    ("is_the_filter_honest.interval", chi_square_interval(2, 50 * 79), "one for each second of 50 voyages"),
    ("is_the_filter_honest.nees", lambda e, P: np.sum(np.linalg.inv(P) @ e**2), "as if e were squared first"),
    ("is_the_filter_honest.mystery", "Q too large or R too small", "Both agree with the minus sign"),
    ("is_the_filter_honest.draw_start", own_start, "Use those in `normal`"),
    ("bearing_of_a_sound.wrap", lambda d: np.degrees(np.arctan2(np.sin(d), np.cos(d))), "taken for radians"),
    ("bearing_of_a_sound.wrap", lambda d: np.clip(d, -180, 180), "You cut the difference off"),
    ("bearing_of_a_sound.offset", lambda x1, K, dt: dt * x1 * (1 / K - K), "1/K − 1"),
    ("bearing_of_a_sound.right_prediction", entry_by_entry, "The lower left is still as published"),
    ("bearing_of_a_sound.right_update", lambda P, K: (1 - np.outer(K, [1, 0])) @ P, "full of ones"),
    ("bearing_of_a_sound.right_update", lambda P, K: (np.eye(2) - K * np.array([1, 0])) @ P, "entry by entry"),
    ("bearing_of_a_sound.is_a_covariance", cholesky, "You refuse diag(1, 0)"),
    ("bearing_of_a_sound.is_a_covariance", lambda P: (P == P.T).all() and eig(P).min() >= -1e-9, "That is rounding"),
    ("bearing_of_a_sound.is_a_covariance", lambda P: abs((P - P.T).sum()) < 1e-9 and eig(P).min() >= -1e-9,
     "plus and minus cancel"),
    ("bearing_of_a_sound.is_a_covariance", lambda P: np.allclose(P, P.T) or eig(P).min() >= 0, "Both must hold"),
    ("readings_that_lie.is_refused", lambda *given: nis(*given[:4]), "You return the NIS"),
    ("readings_that_lie.is_refused", lambda *given: nis(*given[:4]) > given[4], "sigmas² times S"),
    ("readings_that_lie.is_refused", lambda z, x, P, R, n: nis(z, x, P + 0.2, R) > n**2, "as if a Q had been added"),
    ("readings_that_lie.is_refused", lambda z, x, P, R, n: (z - x) % 360 > n * np.sqrt(P + R), "nearly a whole turn"),
    ("readings_that_lie.steps_shut", lambda a, P, Q, R: np.ceil((a**2 / 16 - P - R) / Q), "Your gate is 4σ wide"),
    ("readings_that_lie.steps_shut", lambda a, P, Q, R: np.ceil((a**2 / 9 - P - Q) / R), "Q and R exchanged"),
    ("readings_that_lie.steps_shut", lambda a, P, Q, R: np.round((a**2 / 9 - P - R) / Q), "round up"),
    ("readings_that_lie.gated_step", lambda *given: gated(*given, sigmas=4), "Your gate is 4σ wide"),
    ("readings_that_lie.gated_step", lambda *given: gated(*given, refused=True), "you start again at it"),
    ("readings_that_lie.gated_step", lambda *given: gated(*given, accepted=True), "shrink by the factor 1 − K"),
    ("readings_that_lie.gated_step", lambda *given: gated(*given)[0], "value 1 alone"),
    ("temperature_and_free_fall.room_filter", lambda *given: room(*given, x=0.0), "You start at 0 °C"),
    ("temperature_and_free_fall.room_filter", lambda z, Q, R: room(z, Q, R, P=R**2), "You start with R²"),
    ("temperature_and_free_fall.room_filter", lambda *given: room(*given, once=True), "inside the loop"),
    ("temperature_and_free_fall.room_filter", lambda *given: room(*given, end=-1), "last reading is left out"),
    ("temperature_and_free_fall.noise", own_noise, "Use those in `normal`"),
    ("temperature_and_free_fall.noise", lambda normal, Q: np.sqrt(np.diag(Q)) * normal, "As a column"),
    ("temperature_and_free_fall.honest_report", below_ground, "first moment underground"),
    ("train_and_ship.start_variance", lambda a, b, c: (b - a) ** 2 / 16 + ((a + b) / 2 - c) ** 2, "a quarter of"),
    ("train_and_ship.data_sheet", 36 / 1.18, "with the 1.18 not squared"),
    ("train_and_ship.data_sheet", 4.5, "twice the rms distance"),
    ("train_and_ship.two_point_start", lambda *given: two_fixes(*given)[0], "Return value 2 as well"),
    ("train_and_ship.two_point_start", lambda z0, z1, dt, R: two_fixes(z0, z1, dt, R**2), "R squared, in place of R"),
    ("numerics.average_nees", lambda P, K, R, claim: ((1 - K**2) * P + K**2 * R) / claim, "You squared the K alone"),
    ("numerics.posterior", with_trace(lambda P: P[0, 0]), "the first state only"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "answer", "words"), SAID, ids=[f"{row[0]}-{i}" for i, row in enumerate(SAID)])
def test_wrong_answers_get_their_sentence(name, answer, words):
    assert_told(name, answer, words)


def scaled(z):
    factor = ship.run(z, 100.0)[2].mean()
    return ship.run(z, 100 * factor, factor * ship.Q)[:2]


def other_start(z):
    model = LinearModel(ship.F, [[1, 0]], ship.Q, [[np.var(np.diff(z, 2)) / 6]])
    track = kalman_filter(model, z[:, None], Gaussian([z[0], 0], np.eye(2)))
    return track.mean, track.cov


def cart_in_gaps(wait=False, dt_in_F=True):
    def follow(z, dt, sd, sigma):
        F, Q = cart.motion(dt if dt_in_F else 1.0, sd)
        x, P = np.array([z[0], 0]), np.diag([sigma**2, 9])
        rows = [(x, P)]
        for reading in z[1:]:
            if not (wait and np.isnan(reading)):
                x, P = cart.run([0, np.nan], F, Q, 1, x, P)
                x, P = x[1], P[1]
            if np.isfinite(reading):
                K = P[:, 0] / (P[0, 0] + sigma**2)
                x, P = x + K * (reading - x[0]), P - np.outer(K, P[0])
            rows.append((x, P))
        return tuple(np.array(part) for part in zip(*rows, strict=True))

    return follow


OPEN = [
    ("is_the_filter_honest.unknown_sensor", other_start, "does not follow from the start", "every recording get"),
    ("is_the_filter_honest.unknown_sensor", scaled, "Only R is unknown", "every recording get"),
    ("is_the_filter_honest.unknown_sensor", lambda z: ship.run(z, np.var(np.diff(z)))[:2], "about 2 times", "own?"),
    ("is_the_filter_honest.unknown_sensor", lambda z: ship.run(z, np.diff(z).std() / 2**0.5)[:2], "the square", "is R"),
    ("is_the_filter_honest.unknown_sensor", lambda z: ship.run(z, np.var(z))[:2], "counted as noise", "own?"),
    ("readings_that_lie.speaker", gate(patience=np.inf, start=1), "Does it ever come back", "looks ahead"),
    ("readings_that_lie.speaker", lambda z: z, "You return the readings themselves", "Does it switch"),
    ("readings_that_lie.speaker", gate(start=1), "At the beginning", "looks ahead"),
    ("train_and_ship.cart_with_gaps", cart.without_corners, "no corners", "how does Q"),
    ("train_and_ship.cart_with_gaps", cart.twice, "used twice", "how does Q"),
    ("train_and_ship.cart_with_gaps", cart.FAILING["speed variance 3"], "square it", "how does Q"),
    ("train_and_ship.cart_with_gaps", cart_in_gaps(wait=True), "your filter waits", "P is smaller"),
    ("train_and_ship.cart_with_gaps", cart_in_gaps(dt_in_F=False), "does F contain dt", "how does Q"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "design", "words", "not_said"), OPEN, ids=[f"{r[0]}-{i}" for i, r in enumerate(OPEN)])
def test_reports_name_what_can_be_seen(name, design, words, not_said):
    text = asked(name).check(design).text
    assert "✗" in text and text.count(words) == 1 and not_said not in text, text


def test_the_cart_that_predicts_in_the_gaps_passes():
    assert asked("train_and_ship.cart_with_gaps").check(cart_in_gaps()).status == "right"


def test_a_median_that_looks_ahead_is_not_called_late():
    speaker = asked("readings_that_lie.speaker")
    assert "looks at later readings" in speaker.check(speaker.passing["median of 31, both sides"]).text


def test_one_thing_is_said_once():
    def squares(x, z, mean, ignored, cov):
        a = x[:, 0] > 0
        errors = [np.mean((way - x)[a, 0] ** 2) for way in (mean, ignored)]
        return *errors, np.sqrt(cov[a][-1, 1, 1])

    text = asked("temperature_and_free_fall.honest_report").check(squares).text
    assert text.count("is the square of") == 1 and "The same holds of value 2" in text


def test_a_table_of_functions_that_err_in_several_places():
    table = combined(lambda a, b: lambda x: a * x + b, a={1: "", 2: "Twice."}, b={0: "", 5: "Five more."}, most=1)
    assert [words for _, words in table.values()] == ["Five more.", "Twice."]
