"""Open exercises about carts, speakers and streams: what is said of designs that do not pass, and what is not."""

import numpy as np
import pytest

from kflearn import angle_difference, bearings
from kflearn.exercises import _cart_with_gaps as cart
from kflearn.exercises._a_stream import PASSING as STREAM
from kflearn.exercises._a_stream_late import LATE, step_to
from kflearn.exercises._cart_with_gaps import motion
from kflearn.exercises._speaker import medians, plain
from tests.exercises.answers.train_and_ship import cart_in_gaps
from tests.exercises.hand_in import asked, assert_right, assert_told


def running_median(z, window):
    """The lesson's, without SciPy: it unwraps before it sorts."""
    z = np.unwrap(z, period=360)
    return np.array([np.median(z[max(0, k - window + 1) : k + 1]) for k in range(len(z))])


def sorted_raw(z):
    return np.array([np.median(z[max(0, k - 4) : k + 1]) for k in range(len(z))])


SPEAKERS = [
    (lambda z: plain(running_median(z, 5)), "A median of 5 is outvoted by 3 readings of an echo", "raw bearings"),
    (lambda z: running_median(z, window=9), "A median of 9 is outvoted by 5 readings", "raw bearings"),
    (sorted_raw, "You sort raw bearings", "outvoted"),
    (
        lambda z: np.array([np.mean(z[max(0, k - 19) : k + 1]) for k in range(len(z))]),
        "Fed with 359 and 1",
        "median",
    ),
    (plain, "of the way to them", "median"),
    (lambda z: bearings.gated_filter(z[None], 0.2, 2.0, 4, 4, 8).mean[0], "Does it switch too early", "median"),
    (lambda z: medians(61)(z) + 0 * np.mean(z), "behind the walking speaker", "Fed with 359"),
    (lambda z: np.full(len(z), np.mean(z)), "one bearing for a whole recording", "Fed with 359"),
    (lambda z: np.full(325, np.median(z)), "one bearing for a whole recording", "sort raw bearings"),
]


def carts(change):
    """A filter of the cart that is right, but for a change of its means, covariances and inputs."""

    def follow(z, dt, sd, sigma):
        (F, Q), start = cart.motion(dt, sd), np.diag([sigma**2, 9.0])
        return change(*cart.run(z, F, Q, sigma**2, np.array([z[0], 0.0]), start), z)

    return follow


def never_smaller(z, dt, sd, sigma):
    """The gain uses P, and P is not made smaller."""
    (F, Q), x, P, rows = cart.motion(dt, sd), np.array([z[0], 0.0]), np.diag([sigma**2, 9.0]), []
    rows.append((x, P))
    for reading in z[1:]:
        x, P = F @ x, F @ P @ F.T + Q
        if np.isfinite(reading):
            x = x + P[:, 0] / (P[0, 0] + sigma**2) * (reading - x[0])
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def wrong_gain(z, dt, sd, sigma):
    """P is right; the mean moves by twice its gain."""
    (F, Q), x, P, rows = cart.motion(dt, sd), np.array([z[0], 0.0]), np.diag([sigma**2, 9.0]), []
    rows.append((x, P))
    for reading in z[1:]:
        x, P = F @ x, F @ P @ F.T + Q
        if np.isfinite(reading):
            K = P[:, 0] / (P[0, 0] + sigma**2)
            x, P = x + 1.9 * K * (reading - x[0]), P - np.outer(K, P[0])
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def densest(z):
    """The mean of the largest group among the last 25 readings."""
    found = []
    for k in range(len(z)):
        last = z[:36] if k < 36 else z[k - 24 : k + 1]
        away = angle_difference(last[:, None], last[None, :])
        j = (abs(away) < 7).sum(axis=0).argmax()
        found.append(last[j] + away[abs(away[:, j]) < 7, j][-8:].mean())
    return np.array(found)


LOST = [
    (densest, "of 28 long echoes your filter is wholly at the echo", "pulls"),
    (lambda z: medians()(z) - 5, "The largest error is", "short way round?"),
    (lambda z: medians(61)(z), "behind the walking speaker", "short way round?"),
    (plain, "at their end it is", "wholly at the echo"),
]


def cart_before(speed=9.0, R=1.0, late=False):
    """The cart's filter, which returns the belief before each reading; or uses each reading one step late."""

    def follow(z, dt, sd, sigma):
        (F, Q), x, P = motion(dt, sd), np.array([z[0], 0.0]), np.diag([sigma**2, speed])
        means, covs = [x], [P]
        for reading in z[:-1] if late else z[1:]:
            x, P = F @ x, F @ P @ F.T + Q
            before = x, P
            if not np.isnan(reading):
                K = P[:, 0] / (P[0, 0] + R * sigma**2)
                x, P = x + K * (reading - x[0]), P - np.outer(K, P[0])
            means.append(x if late else before[0])
            covs.append(P if late else before[1])
        return np.array(means), np.array(covs)

    return follow


def stream(first, newest_first=False):
    """A filter for a stream that sorts all readings; first: what is done first in a row, "use" or "return"."""

    def follow(now, t, z, H, R, q, mean, cov):
        log, kept = [], []
        for k in range(len(now)):
            reading = [(t[k], z[k], H[k], R[k])] if not np.isnan(z[k]) else []
            log += reading if first == "use" else []
            younger = [each for each in log if each[0] > t[k]]
            order = sorted((each for each in log if each[0] <= t[k]), key=lambda each: each[0])
            order += sorted(younger, key=lambda each: each[0], reverse=newest_first)
            x, P, last = mean, cov, 0.0
            for at, value, h, r in order:
                x, P = step_to((last, x, P), at, q)
                K, last = P @ h / (h @ P @ h + r), at
                x, P = x + K * (value - h @ x), P - np.outer(K, h @ P)
            kept.append(step_to((last, x, P), now[k], q))
            log += reading if first == "return" else []
        return tuple(np.array(part) for part in zip(*kept, strict=True))

    return follow


@pytest.mark.parametrize(("answer", "words", "not_said"), SPEAKERS)
def test_a_speaker(answer, words, not_said):
    assert_told("readings_that_lie.speaker", answer, words)
    assert not_said not in asked("readings_that_lie.speaker").check(answer).text


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        (carts(lambda mean, cov, z: (mean * [1, 0], cov)), "does not move on as F says"),
        (never_smaller, "Look at the corrections"),
        (wrong_gain, "Your P is right at every reading"),
    ],
)
def test_what_is_right_in_a_cart_is_not_blamed(answer, words):
    outcome = asked("train_and_ship.cart_with_gaps").check(answer)
    assert words in outcome.text and "does Q have sd²?" not in outcome.text, outcome.text


@pytest.mark.parametrize("label", list(LATE))
def test_late_readings(label):
    answer, words = LATE[label]
    assert_told("when_was_it.live", answer, words)


def test_other_readers_of_the_stream_still_pass():
    for answer in STREAM.values():
        assert_right("when_was_it.live", answer)


def test_the_cart_that_predicts_in_the_gaps_passes():
    assert asked("train_and_ship.cart_with_gaps").check(cart_in_gaps()).status == "right"


def test_a_median_that_looks_ahead_is_not_called_late():
    speaker = asked("readings_that_lie.speaker")
    assert "looks at later readings" in speaker.check(speaker.passing["median of 31, both sides"]).text


@pytest.mark.parametrize(("answer", "words", "not_said"), LOST)
def test_a_speaker_that_is_lost_is_told_where(answer, words, not_said):
    assert_told("readings_that_lie.speaker", answer, words)
    assert not_said not in asked("readings_that_lie.speaker").check(answer).text


def test_a_cart_whose_predictions_are_returned():
    name, right = "train_and_ship.cart_with_gaps", "Your filter itself is right: append x and P after the correction"
    assert_told(name, cart_before(), right)
    for other in (cart_before(speed=900.0), cart_before(R=0.2), cart_before(late=True)):
        assert_told(name, other, "does not depend on the reading of that step")
        assert right not in asked(name).check(other).text


def test_a_stream():
    assert_right("when_was_it.live", stream("use"))
    assert_told("when_was_it.live", stream("return"), "does not depend on the reading of that row")
    assert_told("when_was_it.live", stream("use", newest_first=True), "Is one of your steps negative?")
