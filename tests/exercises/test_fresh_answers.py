"""What a stranger answered in lessons 0 to 11: what was refused, passed or misled."""

import numpy as np
import pytest

from kflearn.exercises import _cart_with_gaps as cart
from kflearn.exercises import _unknown_receiver as ship
from kflearn.exercises import _voltmeter_judge as meter
from kflearn.exercises._speaker import gate
from tests.exercises.hand_in import asked

inv = np.linalg.inv


def corrected(x, P, z, H, R, R_gain=1, expected=None):
    K = P @ H.T @ inv(H @ P @ H.T + R_gain * R)
    return x + K @ (z - (H @ x if expected is None else expected)), (np.eye(len(x)) - K @ H) @ P


def few_steps(Q, R):
    P = R
    for _ in range(3):
        P = P + Q
        K = P / (P + R)
        P = (1 - K) * P
    return K


def turns_by_hand(d):
    return (d + 1980) - 360 * int((d + 1980) / 360) - 180


def symmetric(P, Q, dt):
    a = P[0, 0] + 2 * dt * P[0, 1] + dt**2 * P[1, 1]
    return np.array([[a, P[0, 1] + dt * P[1, 1]], [P[1, 0] + dt * P[1, 1], P[1, 1]]]) + Q


def old_P(x, P, room, reading, Q, R):
    K = (P + Q) / (P + Q + R)
    return x + K * (reading - x), np.sqrt((1 - K) * P)


def cart_with(Q=None, P=None):
    def follow(z, dt, sd, sigma):
        start = np.diag([sigma**2, 9]) if P is None else P
        F, right = cart.motion(dt, sd)
        return cart.run(z, F, right if Q is None else Q(dt, sd), sigma**2, np.array([z[0], 0]), start)

    return follow


RIGHT = [
    ("tuning_the_ratio.R_with_drift", lambda r: np.mean(np.diff(r, n=2) ** 2) / 6),
    ("tuning_the_ratio.R_with_drift", lambda r: np.var(np.diff(r, 2)) / 6),
    ("bearing_of_a_sound.wrap", lambda d: np.degrees(np.angle(np.exp(1j * np.radians(d))))),
    ("train_and_ship.cart_with_gaps", cart.white(1)),
    ("start_here.three_readings", 62.9999999),
]


@pytest.mark.parametrize(("name", "answer"), RIGHT)
def test_right_answers_pass(name, answer):
    assert asked(name).check(answer).status == "right"


SAID = [
    ("start_here.three_readings", 62.9, "too low"),
    ("start_here.three_readings", 63.1, "too high"),
    ("start_here.three_readings", 62.99, "too low"),
    ("start_here.data_sheet", 81, "is the square of what is wanted. Is there a square too many"),
    ("gaussian_fusion.readings_needed", 121, "is the square of what is wanted. Is there a square too many"),
    ("gaussian_fusion.readings_needed", 10.911, "a whole number of times"),
    ("history.exponential_weights", lambda K, n: (1 - K) * K ** np.arange(n), "K and 1 − K are exchanged"),
    ("newton_to_state_space.held_push", lambda T, s: s**2 * np.array([[T**2 / 2], [T]]), "That is σ² G, a column"),
    ("predict_correct.correct", lambda x, P, z, H, R: corrected(x, P, z, H, R, expected=x[: len(z)]),
     "you took x away from z"),
    ("predict_correct.correct", lambda x, P, z, H, R: corrected(x, P, z, H, R, R_gain=1e-13),
     "R is missing in your gain"),
    ("gaussian_fusion.fuse", lambda m, v, n, w: ((m + n) / 2, (v + w) / 4),
     "That is the plain average and its variance"),
    ("gaussian_fusion.third_opinion", 61.67, "before the satellite"),
    ("gaussian_fusion.published_claim", lambda v, w: (v / w, v / w, 1 + v / w), "Anna returns the fused mean"),
    ("gaussian_fusion.common_cause", lambda P, R, c: P / (P + R), "which holds for c = 0"),
    ("voltmeter.steady_gain", few_steps, "That is the gain of reading 4"),
    ("voltmeter.steady_gain", lambda Q, R: (R + Q) / (2 * R + Q), "That is the gain of reading 2"),
    ("voltmeter.is_unknown", lambda x: x == np.nan, "NaN equals nothing"),
    ("voltmeter.is_unknown", lambda x: np.nan in x, "`in` compares with =="),
    ("voltmeter.is_unknown", lambda x: len(x) == 0, "says False whatever the state is"),
    ("voltmeter.is_unknown", lambda x: np.isnan(x[0]) or np.isnan(x[1]), "IndexError"),
    ("voltmeter.auto_start", lambda z, H, R: (inv(H) @ z, inv(H) @ R @ H.T), "only the left side is undone"),
    ("voltmeter.auto_start", lambda z, H, R: (inv(H) @ R @ inv(H).T, inv(H) @ z), "wanted in the other order"),
    ("tuning_the_ratio.R_with_drift", lambda r: np.mean(np.diff(r)) ** 2 / 2, "You took the mean first"),
    ("is_the_filter_honest.nees", lambda e, P: e @ inv(P @ P) @ e, "P⁻¹ stands once between the two e"),
    ("is_the_filter_honest.share_inside", lambda e, P: 0.683, "what to expect of an honest filter"),
    ("is_the_filter_honest.draw_start", lambda m, v, n: np.random.default_rng().normal(m, np.sqrt(v)),
     "Use those in `normal`"),
    ("bearing_of_a_sound.wrap", turns_by_hand, "trials"),
    ("bearing_of_a_sound.right_prediction", symmetric, "need not be symmetric"),
    ("temperature_and_free_fall.mended_step", old_P, "the P that came in"),
    ("temperature_and_free_fall.noise", lambda normal, Q: np.sqrt(Q) * normal, "`*` multiplies entry by entry"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "answer", "words"), SAID, ids=[f"{row[0]}-{i}" for i, row in enumerate(SAID)])
def test_wrong_answers_get_their_sentence(name, answer, words):
    outcome = asked(name).check(answer)
    assert outcome.status != "right" and words in outcome.text, outcome.text


OPEN = [
    ("voltmeter.whole_filter", meter.FAILING["gaps filled with zeros"], "or the last reading?", "P has to grow by Q"),
    ("voltmeter.whole_filter", meter.FAILING["raw readings, NaN kept"], "not finite at reading", "±2σ"),
    ("voltmeter.whole_filter", meter.FAILING["predictions"], "one reading late", "Does the gain"),
    ("is_the_filter_honest.unknown_sensor", ship.FAILING["Q forgotten"], "Is Q added in each", "is R the variance"),
    ("is_the_filter_honest.unknown_sensor", lambda z: (np.stack([z, 0 * z], 1), np.tile(np.eye(2), (100, 1, 1))),
     "are the readings themselves", "Does each recording get"),
    ("readings_that_lie.speaker", lambda z: np.full(len(z), 180.0), "one bearing for a whole", "Do echoes of"),
    ("readings_that_lie.speaker", gate(patience=8), "at their end it is 100 % of the way", "gate open again"),
    ("readings_that_lie.speaker", gate(patience=np.inf), "gate open again", "too early"),
    ("train_and_ship.cart_with_gaps", cart.white(0), "white noise", "start's P"),
    ("train_and_ship.cart_with_gaps", cart_with(lambda dt, sd: sd**2 * np.outer([dt / 2, 1], [dt / 2, 1])),
     "lacks a factor", "start's P"),
    ("train_and_ship.cart_with_gaps", cart_with(lambda dt, sd: cart.motion(dt, 1)[1] * sd),
     "sd times G Gᵀ", "start's P"),
    ("train_and_ship.cart_with_gaps", cart_with(P=np.eye(2)), "first reading is too small", "Is Q, R"),
    ("train_and_ship.cart_with_gaps", cart.FAILING["gaps filled with zeros"], "your P is smaller", "Is Q, R"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "design", "words", "not_said"), OPEN, ids=[f"{r[0]}-{i}" for i, r in enumerate(OPEN)])
def test_open_exercises_say_what_the_results_show(name, design, words, not_said):
    text = asked(name).check(design).text
    assert words in text and not_said not in text, text
