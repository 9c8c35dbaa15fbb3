"""What answers must get that a fourth group of strangers handed in; each had met a general or a misleading reply."""

import linecache
import re

import numpy as np
import pytest

import kflearn
from kflearn import Gaussian, boats, pda_filter
from kflearn.exercises import _a_ride as ride
from kflearn.exercises import _cart_with_gaps as cart
from kflearn.exercises import _unknown_receiver as receiver
from kflearn.exercises._a_stream import PASSING as STREAM
from kflearn.exercises._a_stream_late import LATE
from kflearn.exercises._thrown_ball_signs import by_distance
from tests.exercises.hand_in import asked, assert_right, assert_told


def typed(text):
    """The last function of a text, as if it had been typed into a cell of the notebook."""
    place = f"<typed {abs(hash(text))}>"
    space = {name: getattr(kflearn, name) for name in kflearn.__all__} | {"np": np, "plane": boats.plane()}
    linecache.cache[place] = (len(text), None, text.splitlines(True), place)
    exec(compile(text, place, "exec"), space)
    return space[re.findall(r"^def (\w+)\(", text, re.MULTILINE)[-1]]


def anew_after_a_gap(z, dt, sd, sigma):
    (F, Q), first, gap = cart.motion(dt, sd), np.diag([sigma**2, 9.0]), False
    x, P = np.array([z[0], 0.0]), first
    rows = [(x, P)]
    for reading in z[1:]:
        x, P = F @ x, F @ P @ F.T + Q
        if np.isnan(reading):
            gap = True
        elif gap:
            x, P, gap = np.array([reading, 0.0]), first, False
        else:
            K = P[:, 0] / (P[0, 0] + sigma**2)
            x, P = x + K * (reading - x[0]), P - np.outer(K, P[0])
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def one_Q(z, dt, sd, sigma):
    return cart.run(
        z, cart.motion(dt, sd)[0], np.diag([0.005, 0.01]), sigma**2, np.array([z[0], 0]), np.diag([sigma**2, 9])
    )


def no_squares(z, dt, sd, sigma):
    start = np.array([z[0], 0]), np.diag([sigma, 9])
    return cart.run(z, cart.motion(dt, sd)[0], cart.motion(dt, sd)[1] / sd, sigma, *start)


def two_gains(z, F, Q, mean, cov):
    """R is learnt for the mean, and P goes on with that of the data sheet."""
    x, P, squares, rows = mean, cov, [], []
    for reading in z:
        x, P = F @ x, F @ P @ F.T + Q
        if not np.isnan(reading):
            y = reading - x[0]
            squares.append(y**2)
            R = 1.0 if len(squares) < 30 else max(np.mean(squares[-30:]) - P[0, 0], 0.05)
            x, P = x + P[:, 0] / (P[0, 0] + R) * y, P - np.outer(P[:, 0], P[0]) / (P[0, 0] + 1)
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def from_the_last_good_one(time, z, q):
    """A gate by the distance from the last reading that passed it."""
    R = np.nanvar(z[time < ride.REST], axis=0, ddof=1).mean()
    good, last = z.copy(), z[0]
    for k in range(1, len(z)):
        if not np.linalg.norm(z[k] - last) <= 6 * np.sqrt(R):
            good[k] = np.nan
        else:
            last = z[k]
    return ride.follow(time, good, q, R=R, gate=np.inf)


def changing(z):
    """R from each innovation."""
    x, P, rows = receiver.MEAN, receiver.COV, []
    for reading in z:
        x, P = receiver.F @ x, receiver.F @ P @ receiver.F.T + receiver.Q
        y = reading - x[0]
        K = P[:, 0] / (P[0, 0] + max(y**2 - P[0, 0], 4.0))
        x, P = x + K * y, P - np.outer(K, P[0])
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def corrects_in_gaps(z, Q, R):
    """In a gap the estimate is taken for a reading."""
    x, P = z[0], R
    rows = [(x, P)]
    for reading in z[1:]:
        P = P + Q
        K = P / (P + R)
        x, P = x + K * (np.nan_to_num(reading - x)), (1 - K) * P
        rows.append((x, P))
    return tuple(zip(*rows, strict=True))


def first_columns(z, start, clutter):
    belief = Gaussian(start, np.diag([25.0, 1, 25, 1]))
    return pda_filter(boats.plane(), z, belief, detection=0.9, clutter=clutter).mean[:, :2]


def tracks(filters, columns="[0, 2]"):
    """A tracker of the boat, typed."""
    return typed(
        "def follow(z, start, clutter):\n"
        "    belief = Gaussian(start, np.diag([25.0, 1, 25, 1]))\n"
        f"    return {filters}.mean[:, {columns}]\n"
    )


NEAREST = tracks("nearest_filter(plane, z, belief)")
SMALL = tracks("pda_filter(plane, z, belief, detection=0.9, clutter=clutter, gate=0.9)")
OTHER_H = tracks("pda_filter(plane.replace(H=np.eye(2, 4)), z, belief, detection=0.9, clutter=clutter)", ":2")
MEDIAN = typed("def raw(z):\n    return np.array([np.median(z[max(0, k - 30) : k + 1]) for k in range(len(z))])")
POWER = typed("def start(z, H, R):\n    G = H**-1.0\n    return G @ z, G @ R @ G.T")
PREDICTED = """
P_pred, x_pred = np.eye(2), np.zeros(2)

def correct(x, P, z, H, R):
    K = P_pred @ H.T @ np.linalg.inv(H @ P_pred @ H.T + R)
    return x_pred + K @ (z - H @ x_pred), (np.eye(2) - K @ H) @ P_pred
"""
SPREADS = """
def offset(v, late, dt):
    found = [0 * np.std(v[d:]) + 0 * np.std(late[d:]) for d in range(9)]
    return np.argmin(found) * dt
"""
OPEN = [
    ("train_and_ship.cart_with_gaps", anew_after_a_gap, "At the first reading after a gap you start anew"),
    ("train_and_ship.cart_with_gaps", one_Q, "the same Q in every recording"),
    ("train_and_ship.cart_with_gaps", no_squares, "its square is wanted, there and for R"),
    ("adaptive.unknown_sensor", two_gains, "Use the same R, the learnt one, in both"),
    ("your_data.ride", from_the_last_good_one, "mostly many in a row"),
    ("is_the_filter_honest.unknown_sensor", changing, "an R which changes from reading to reading"),
    ("voltmeter.whole_filter", corrects_in_gaps, "no factor 1 − K"),
    ("whose_is_it.boat", first_columns, "take its columns 0 and 2"),
    ("whose_is_it.boat", NEAREST, "takes the nearest reading"),
    ("whose_is_it.boat", SMALL, "refuses 10 of 100"),
    ("whose_is_it.boat", OTHER_H, "H must pick 0 and 2"),
    ("readings_that_lie.speaker", MEDIAN, "You sort raw bearings"),
]  # fmt: skip
WORDS = [
    ("start_here.readings_needed", 3, "The square of 8 is wanted"),
    ("gaussian_fusion.readings_needed", 12, "does your counter begin at 1?"),
    ("two_numbers.scale_for", lambda share: 2.45 * np.sqrt(share), "was expected"),
    ("voltmeter.auto_start", POWER, "`H**-1` turns over each entry by itself"),
    ("is_the_filter_honest.mystery", "too modest", "Too modest, yes"),
    ("is_the_filter_honest.mystery", "Q", "Is Q too large or too small?"),
    ("is_the_filter_honest.mystery", "R", "Is R too large or too small?"),
    ("tuning_the_ratio.which_knob", "none", "One of the five is right"),
    ("extended.winner", "no difference in the median run", "In it the bad runs count"),
    ("bearings_only.review", "line 2 lacks the square root", "That is reviewer (a)"),
    ("interacting_models.wrong_push", "a little smaller", "Not even a little"),
    ("interacting_models.wrong_push", "smaller in turns, larger on the straight", "does not depend on turns"),
    ("adaptive.moved_or_noisy", 0.85, "You read the right number"),
    ("adaptive.moved_or_noisy", "D", "One of the three is right"),
    ("smoothing.real_gap", -0.032, "That is the difference in ppm"),
    ("smoothing.real_gap", 0.39 / 0.43, "The ratio is right"),
    ("smoothing.real_gap", "none", "One of the three is right"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "answer", "words"), OPEN + WORDS)
def test_own_sentence(name, answer, words):
    assert_told(name, answer, words)


@pytest.mark.parametrize("label", list(LATE))
def test_late_readings(label):
    answer, words = LATE[label]
    assert_told("when_was_it.live", answer, words)


def test_scale_of_one_number_stretched():
    from scipy.stats import norm

    assert_told(
        "two_numbers.scale_for", lambda share: norm.interval(share)[1] * 1.25, "One factor mends one share only"
    )


def test_other_readers_of_the_stream_still_pass():
    for answer in STREAM.values():
        assert_right("when_was_it.live", answer)


def test_names_of_the_notebook_are_named_before_a_size_that_is_typed_in():
    outcome = asked("predict_correct.correct").check(typed(PREDICTED))
    assert "`P_pred` and `x_pred`, which are names of the notebook" in outcome.text
    assert "len(x)" not in outcome.text


def test_a_size_that_is_typed_in_is_not_named_where_a_name_is_missing():
    text = "def correct(x, P, z, H, R):\n    return nowhere @ x, np.eye(2)\n"
    assert "fixed size" not in asked("predict_correct.correct").check(typed(text)).text


def test_sizes_that_fit_by_chance():
    text = "def whole(x, P, z, F, H, Q, R):\n    K = H.T * R\n    return x + K @ z, P\n"
    assert "the product of matrices is `@`" in asked("predict_correct.misprints").check(typed(text)).text
    text = "def whole(x, P, z, F, H, Q, R):\n    K = H.T + R\n    return x + K @ z, P\n"
    assert "should a product stand between them?" in asked("predict_correct.misprints").check(typed(text)).text


def test_an_argument_that_a_list_reads_is_not_called_unused():
    assert "does not depend" not in asked("when_was_it.clock_offset").check(typed(SPREADS)).text


def test_a_slow_filter_is_also_told_what_its_first_result_lacks(monkeypatch):
    calls = []

    def slow(now, *rest):
        calls.append(0)
        while len(calls) > 1:
            pass
        return np.full((len(now), 2), np.nan), np.tile(np.eye(2), (len(now), 1, 1))

    monkeypatch.setattr("kflearn.exercises._watch.SECONDS", 0.3)
    outcome = asked("when_was_it.live").check(slow)
    assert "is it only slow" in outcome.text and "not finite at reading 1" in outcome.text


def test_a_gate_of_so_many_pixels():
    text = "def follow(z, g, q, R):\n    return tracker(z, g, q, R, lambda y: np.hypot(*y) < 100)\n"
    assert "fixed distance in px" in _told(text)


def _told(text):
    """What is said of a gate in a function of this text."""
    return by_distance(typed(text), [], [])
