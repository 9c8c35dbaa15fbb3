"""What answers to lessons 15 to 28 must get that a fifth group of strangers handed in, and more of their kind."""

import numpy as np
import pytest

from tests.exercises.hand_in import assert_right, assert_told

# ---- numbers that are in no table

FACTS = [
    ("bearings_only.twin_velocity", (10, 3), "Relative to us that target moves with (4, 3) m/s"),
    ("homing_missile.start_sigma", 250, "the NEES is 5.47, where 3 is wanted"),
    ("unscented.three_points", 96, "gives the centre the weight 0.896"),
    ("unscented.three_points", 40, "between the smallest and the largest image"),
    ("unscented.three_points", 100 - 87.2, "how far the mean sinks"),
    ("unscented.three_points", 100 * np.cos(np.pi / 2), "along the x-axis"),
    ("unscented.declared_kappa", (1, 10), "that would be right for n = 2"),
    ("unscented.declared_kappa", (-5, -8), "which is λ itself"),
    ("unscented.declared_kappa", (-1, 9), "3 for α = 1 and 3.25 for α = ½"),
    ("unscented.start_nees", 700, "More than 6 would mean"),
    ("unscented.start_nees", 0.5, "the sum is at most 0.06"),
    ("unscented.start_nees", 0.035, "between 0.04 and 0.06"),
    ("interacting_models.blended_sigma", 20, "wider than each of the two"),
    ("interacting_models.blended_sigma", 56, "900 m² and 2236 m² more"),
    ("error_state_navigation.all_bias", 20, "an acceleration of 0.0444 m/s²"),
    ("consider_filter.inflated", 0.4225, "an error of σ = 0.65 m"),
    ("adaptive.window_needed", 50, "R̂ scatters by S √(2/N) = 0.26 m²"),
    ("smoothing.one_step_back", (4.8, 2.9), "moved by 0.4 times 6 − 4"),
    ("smoothing.one_step_back", (5.5, 2.6), "Your variance is 3 and -0.4 more"),
    ("let_the_data_choose.half_missing", 3.1, "it is still lower for a smaller R"),
    ("let_the_data_choose.one_reading", -3.0, "your number is lower by 1.28"),
    ("when_was_it.behind", -2.4, "a speed of 10 m/s, and the reading would lie behind"),
    ("whose_is_it.false_in_gate", 0.2, "a gate of 400 m²"),
    ("whose_is_it.zeros", [2, 7], "There is no reading 7"),
    ("your_data.interval_of_R", (0.07, 0.12), "At 95 % both are 2.5 %"),
    ("your_data.milliseconds_for_seconds", 3e-10, "becomes 3 times what it was"),
    ("history.newest_ten", 0.7, "That leaves 0.3 to the readings older"),
    ("history.behind", 2.0, "the reading leaves 1.792 s"),
    ("history.behind", np.inf, "It does not grow for ever"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "answer", "words"), FACTS)
def test_a_number_is_told_what_it_would_mean(name, answer, words):
    assert_told(name, answer, words)


def test_an_offset_of_the_speeds_must_be_taken_out():
    def plain(v, late, dt):
        return np.argmin([np.mean((v[: len(v) - j] - late[j:]) ** 2) for j in range(11)]) * dt

    def without_offset(v, late, dt):
        return np.argmin([np.std(v[: len(v) - j] - late[j:]) for j in range(11)]) * dt

    def numpys(v, late, dt):
        return (np.argmax(np.correlate(late - late.mean(), v - v.mean(), "full")) - len(v) + 1) * dt

    assert_told("when_was_it.clock_offset", plain, "One instrument may show an offset")
    for right in (without_offset, numpys):
        assert_right("when_was_it.clock_offset", right)


def test_two_mistakes_in_the_weights_are_both_named():
    def weights(z, expected, S, detection, clutter):
        nis = (z - expected) ** 2 / S
        e = np.where(nis <= 9.21, np.exp(-nis / 2), 0)
        b = clutter * 2 * np.pi * np.sqrt(S) * (1 - 0.99 * detection) / detection
        return np.append(b, e) / (b + e.sum())

    for words in ("2π√S belongs to readings in the plane", "9.21 is the limit for readings in the plane"):
        assert_told("whose_is_it.weights", weights, words)
