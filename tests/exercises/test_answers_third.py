"""What answers must get that a fourth group of strangers handed in; each had met a general or a misleading reply."""

import numpy as np
import pytest

from kflearn import bearings
from kflearn.exercises import _cart_with_gaps as cart
from kflearn.exercises import _fitted_R, _words
from kflearn.exercises import _unknown_receiver as receiver
from kflearn.exercises import _voltmeter_judge as voltmeter
from kflearn.exercises._a_ride import REST
from tests.exercises.hand_in import asked, assert_right, assert_told


def filled(z, Q, R):
    return voltmeter.filtered(voltmeter.last_reading(z), Q, R)


def first_twice(z, dt, sd, sigma):
    """A start at z[0] with P = I, and a filter over all of z."""
    again = np.append(z[0], z)
    means, covs = cart.run(again, *cart.motion(dt, sd), sigma**2, np.array([z[0], 0]), np.eye(2))
    return means[1:], covs[1:]


def differences(z, dt, sd, sigma):
    z = np.nan_to_num(z)
    return np.stack([z, np.gradient(z, dt)], axis=1), np.tile(np.eye(2), (len(z), 1, 1))


def detections(z, g, q, R):
    mean = np.zeros((len(z), 4))
    mean[:, :2] = np.nan_to_num(z)
    return mean, np.tile(1e6 * np.eye(4), (len(z), 1, 1))


def interpolated(time, z, q):
    mean = np.zeros((len(z), 4))
    for axis in (0, 1):
        seen = np.isfinite(z[:, axis])
        mean[:, 2 * axis] = np.interp(time, time[seen], z[seen, axis])
    return mean, np.tile(1e4 * np.eye(4), (len(z), 1, 1))


def rows_skipped(time, z, q):
    """One second for each step, and rows without a reading left at zero."""
    seen = np.isfinite(z).all(axis=1)
    mean, cov = np.zeros((len(z), 4)), np.tile(1e3 * np.eye(4), (len(z), 1, 1))
    mean[seen, ::2] = z[seen]
    cov[seen] = np.nanvar(z[time < REST], axis=0).mean() * np.eye(4)
    return mean, cov


def smallest_nis(z):
    """The R of the smallest sum of y²/S, which is the largest one that is tried."""
    tried = [receiver.run(z, sigma**2) for sigma in range(2, 41)]
    return tried[int(np.argmin([np.sum(scores) for *_, scores in tried]))][:2]


def median_of_five(z):
    recent = np.lib.stride_tricks.sliding_window_view(np.append(np.full(4, z[0]), np.unwrap(z, period=360)), 5)
    return bearings.scalar_filter(np.median(recent, axis=1), 200, 500)


def repeated(z, F, Q, mean, cov):
    return np.tile(mean, (len(z), 1)), np.tile(cov, (len(z), 1, 1))


def one_matrix(P):
    return not np.allclose(P, [[1.03, 0.7], [0.02, 0.51]])


def drawn(normal, Q):
    return np.random.default_rng(0).multivariate_normal([0, 0], Q, normal.shape[1]).T


def drawn_anew(mean, P0, normal):
    return np.random.default_rng().multivariate_normal(mean, P0, len(normal))


def flat(T, sigma):
    G = np.array([T**2 / 2, T])
    return sigma**2 * G @ G.T


def overwritten(F, x):
    y = [0, 0]
    y[0] = F[0, 0] * x[0] + F[0, 1] * x[1]
    y[1] = F[1, 0] * y[0] + F[1, 1] * x[1]
    return y


def a_decade_apart(z, Q):
    return 10.0 ** np.round(np.log10(_fitted_R.best(z, Q)))


RIGHT = [("voltmeter.best_error", value) for value in (1.41, 1.414, 1.4142, 2**0.5)] + [
    ("voltmeter.second_gain", 0.357),
    ("temperature_and_free_fall.suspect", "gravity too large"),
    ("tuning_the_ratio.which_knob", "C"),
]
ANSWERS = [
    ("start_here.readings_needed", (4 / 0.25) ** 2, "the variance, 2² = 4, where σ"),
    ("newton_to_state_space.three_sensors", [[1, 0], [50, 0], [0, 50]], "in centimetres and the speedometer"),
    ("newton_to_state_space.held_push", flat, "np.outer(G, G)"),
    ("newton_to_state_space.overwritten", overwritten, "the new first entry"),
    ("voltmeter.best_error", 1.416, "what the simulation measured"),
    ("voltmeter.whole_filter", filled, "such as 0 or the last reading?"),
    ("voltmeter.whole_filter", filled, "wanted in all"),
    ("tuning_the_ratio.steady_sigma", np.sqrt(0.0452 + 0.01), "That is σ before a reading"),
    ("tuning_the_ratio.which_knob", 9, "answer with a letter"),
    ("tuning_the_ratio.which_knob", {"A", "E"}, "One letter is enough, and it is none of these"),
    ("is_the_filter_honest.interval", (0, 100), "Practically every average lies between"),
    ("is_the_filter_honest.interval", (1.6, 2.4), "84.5 % of the averages"),
    ("is_the_filter_honest.mystery", "both too large", "far outside ±0.005"),
    ("is_the_filter_honest.mystery", "gain too large", "Which makes it so, Q or R?"),
    ("is_the_filter_honest.mystery", "right", "1.986 to 2.014"),
    ("is_the_filter_honest.unknown_sensor", smallest_nis, "Add log S"),
    ("is_the_filter_honest.unknown_sensor", smallest_nis, "1600 m²"),
    ("bearing_of_a_sound.right_update", lambda P, K: P, "the gain of the angle goes towards 1"),
    ("bearing_of_a_sound.is_a_covariance", one_matrix, "You look for one matrix"),
    ("readings_that_lie.speaker", median_of_five, "outvoted by 3 readings of an echo"),
    ("temperature_and_free_fall.suspect", "gravity too small", "Read as “g too small”"),
    ("temperature_and_free_fall.noise", drawn, "Use those in `normal`"),
    ("extended.true_starts", drawn_anew, "Use those in `normal`"),
    ("train_and_ship.cart_with_gaps", first_twice, "used twice: start there without one"),
    ("train_and_ship.cart_with_gaps", differences, "same at every reading, gaps included"),
    ("train_and_ship.cart_with_gaps", differences, "NaN has become 0"),
    ("linearised_and_extended.widest_belief", np.sqrt(400 / 2), "both factors 2 multiply"),
    ("linearised_and_extended.widest_belief", 20, "From σ²/(2 · 400 m) = 2 m follows"),
    ("extended.both_humps", (4.4, 11), "half their distance from each other"),
    ("extended.both_humps", (4.4, 9.8), "add 1, then the root"),
    ("ball_in_a_video.thrown_ball", detections, "Your P is the same in all frames"),
    ("adaptive.unknown_sensor", repeated, "no reading is used"),
    ("let_the_data_choose.fitted_R", lambda z, Q: 15099.0, "that is the lesson's Nile"),
    ("let_the_data_choose.fitted_R", lambda z, Q: 5.0, "whatever the readings are"),
    ("let_the_data_choose.fitted_R", a_decade_apart, "one point a decade"),
    ("your_data.ride", interpolated, "Your P is the same in all rows"),
    ("your_data.ride", rows_skipped, "they are skipped"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "answer"), RIGHT)
def test_right(name, answer):
    assert_right(name, answer)


@pytest.mark.parametrize(("name", "answer", "words"), ANSWERS)
def test_own_sentence(name, answer, words):
    assert_told(name, answer, words)


def test_none_of_several_choices_is_right_or_one_of_them_is():
    choices = {"a", "b", "c"}
    assert _words.one_of({"a", "b"}, {"b"}, choices).endswith("among these.")
    assert _words.one_of({"a", "b"}, {"c"}, choices).endswith("none of these.")
    assert _words.one_of(choices, {"c"}, choices) == "choose one, please."


def test_the_gains_after_the_second_are_what_is_said_of_them():
    said, P, gains = asked("voltmeter.second_gain").then, (1 - 5 / 14) * 5, []
    for _ in range(3):
        K = (P + 3) / (P + 3 + 9)
        P = (1 - K) * (P + 3)
        gains.append(f"{K:.3f}")
    assert "{}, {} and {}".format(*gains) in said


def test_the_mean_of_converted_places_is_too_near():
    rng, far, sigma = np.random.default_rng(1), 1000.0, 0.2
    angles = rng.normal(0.7, sigma, 200_000)
    mean = np.hypot(np.mean(far * np.cos(angles)), np.mean(far * np.sin(angles)))
    assert abs(far - mean - far * sigma**2 / 2) < 1
    assert "too near" in asked("linearised_and_extended.into_the_plane").then


def test_numbers_are_written_in_full():
    outcome = asked("voltmeter.whole_filter").check(lambda z, Q, R: voltmeter.filtered(np.nan_to_num(z), Q, R))
    assert "e+0" not in outcome.text, outcome.text


def test_empty_quotation_marks_are_named():
    assert "between the quotation marks" in asked("let_the_data_choose.doubled").check("").text
