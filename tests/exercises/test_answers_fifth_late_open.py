"""What whole filters of lessons 13 to 27 must get that a fifth group of strangers handed in, and more of their kind."""

import numpy as np
import pytest

from kflearn import Gaussian, LinearModel, boats, pda_filter
from kflearn.exercises import _a_ride as ride
from kflearn.exercises import _a_stream as stream
from kflearn.exercises import _radar as radar
from kflearn.exercises import _thrown_ball as ball
from kflearn.exercises import _unknown_sensor as sensor
from kflearn.exercises._a_stream_late import at_its_own_time, corrected, sorted_first, step_to
from kflearn.exercises._judge import LIKELY, Likely, Mark, likely
from kflearn.exercises._results import of_gaps
from tests.exercises.hand_in import asked, assert_told

PLANE = boats.plane()


def exchanged(time, z, q):
    """The variance at rest stands in Q, and q in S."""
    R = np.nanvar(z[time < ride.REST], axis=0, ddof=1).mean()
    return ride.follow(time, z, R, R=q)


def locked(time, z, q):
    """A reading moves the state the other way."""
    R = np.nanvar(z[time < ride.REST], axis=0, ddof=1).mean()
    x, P, found = np.array([z[0, 0], 0, z[0, 1], 0]), np.kron(np.eye(2), np.diag([R, 9.0])), []
    for k in range(len(z)):
        if k:
            F, Q = ride.moving(time[k] - time[k - 1], q)
            x, P = F @ x, F @ P @ F.T + Q
            y, S = z[k] - ride.H @ x, ride.H @ P @ ride.H.T + R * np.eye(2)
            if y @ np.linalg.solve(S, y) < 13.8:
                K = np.linalg.solve(S, ride.H @ P).T
                x, P = x - K @ y, P - K @ S @ K.T
        found.append((x, P))
    return tuple(np.array(part) for part in zip(*found, strict=True))


def learnt_Q(z, F, Q, mean, cov):
    """Q grows with the innovations, and R is that of the data sheet."""
    x, P, recent, found = mean, cov, [], []
    for reading in z:
        wide = Q * max(np.mean(recent[-30:]), 1) if len(recent) >= 30 else Q
        x, P = F @ x, F @ P @ F.T + wide
        if not np.isnan(reading):
            y, S = reading - x[0], P[0, 0] + 1
            recent.append(y**2 / S)
            x, P = x + P[:, 0] / S * y, P - np.outer(P[:, 0], P[0]) / S
        found.append((x, P))
    return tuple(np.array(part) for part in zip(*found, strict=True))


def rooted_R(z, F, Q, mean, cov):
    def rule(R, y, explained):
        with np.errstate(invalid="ignore"):
            return max(np.sqrt(0.95 * R**2 + 0.05 * (y * y - explained)), 0.05)

    return sensor.learn(z, F, Q, mean, cov, rule=rule)


def capped(z, F, Q, mean, cov):
    def rule(R, y, explained):
        return min(max(0.95 * R + 0.05 * (y * y - explained), 0.1), 4)

    return sensor.learn(z, F, Q, mean, cov, rule=rule)


def tracker(choose, gate=9.21):
    """A tracker of the boat that corrects by what is chosen among the innovations in its gate."""

    def follow(z, start, clutter):
        x, P, found = np.array(start, float), np.diag([25.0, 1, 25, 1]), []
        for scan in z:
            x, P = PLANE.F @ x, PLANE.F @ P @ PLANE.F.T + PLANE.Q
            S = PLANE.H @ P @ PLANE.H.T + PLANE.R
            y = scan[~np.isnan(scan).any(axis=1)] - PLANE.H @ x
            nis = np.sum(y @ np.linalg.inv(S) * y, axis=1)
            y, nis = y[nis <= gate], nis[nis <= gate]
            if len(y):
                K = P @ PLANE.H.T @ np.linalg.inv(S)
                x, P = x + K @ choose(y, nis), P - K @ S @ K.T
            found.append(x[[0, 2]])
        return np.array(found)

    return follow


def with_model(model, columns=(0, 2), cov=(25, 1, 25, 1)):
    def follow(z, start, clutter):
        track = pda_filter(model, z, Gaussian(start, np.diag(cov)), detection=0.9, clutter=clutter)
        return track.mean[:, list(columns)]

    return follow


def places_first():
    """A model of x, y, v_x, v_y."""
    parts = [[1, 1], [0, 1]], [[1, 0]], 0.25 * np.array([[0.25, 0.5], [0.5, 1]]), [[25.0]]
    return LinearModel(*(np.kron(part, np.eye(2)) for part in parts))


def in_pairs(*given):
    return list(zip(*stream.fed()(*given), strict=True))


def away(now, t, z, H, R, q, mean, cov):
    """A filter of the rows as they arrive, that moves away from the readings."""
    x, P, time, found = mean, cov, 0.0, []
    for k in range(len(now)):
        x, P = step_to((time, x, P), now[k], q)
        time = now[k]
        if not np.isnan(z[k]) and t[k] == now[k]:
            seen, P = corrected(x, P, z[k], H[k], R[k])
            x = 2 * x - seen
        found.append((x, P))
    return tuple(np.array(part) for part in zip(*found, strict=True))


def looser(now, t, z, H, R, *rest):
    return stream.fed()(now, t, z, H, 3 * R, *rest)


def mixed_R(now, t, z, H, R, *rest):
    return stream.fed()(now, t, z, H, 0 * R + R.mean(), *rest)


def inflated(now, t, z, H, R, q, mean, cov):
    """A late reading is used as if it were new, with a larger R."""
    last, found = (0.0, mean, cov), []
    for k in range(len(now)):
        x, P = step_to(last, now[k], q)
        if not np.isnan(z[k]):
            x, P = corrected(x, P, z[k], H[k], R[k] + 9 * (now[k] - t[k]) ** 2)
        last = now[k], x, P
        found.append((x, P))
    return tuple(np.array(part) for part in zip(*found, strict=True))


def turned_round(y, nis):
    return -y[nis.argmin()]


def nearest(y, nis):
    return y[nis.argmin()]


def middle(y, nis):
    return y.mean(axis=0)


def cut_off(time, z, q):
    """No step longer than 3 s."""
    return ride.follow(time, z, q, dt=np.minimum(np.diff(time), 3))


def wide_R(*given):
    return radar.extended(*given, R=np.diag([100, 0.02**2]))


STRAIGHT = LinearModel(PLANE.F, PLANE.H, 0 * PLANE.Q, PLANE.R)
RADAR = "linearised_and_extended.range_and_bearing"
OPEN = [
    ("your_data.ride", exchanged, "There q belongs; the variance at rest is R"),
    ("your_data.ride", locked, "Your state moves away from the readings"),
    ("your_data.ride", lambda time, z, q: ride.follow(time, z, 2 * q), "grows by 2 times the Q that belongs there"),
    ("your_data.ride", cut_off, "your state moves on for 3 s"),
    ("adaptive.unknown_sensor", learnt_Q, "Q is given, and right; what changes is the sensor: learn R"),
    ("adaptive.unknown_sensor", rooted_R, "or a root, stand in place of a variance"),
    ("adaptive.unknown_sensor", capped, "a limit holds it"),
    ("whose_is_it.boat", tracker(nearest, np.inf), "200 m from where the boat must be moves your boat"),
    ("whose_is_it.boat", tracker(nearest), "only the nearer one moves your boat"),
    ("whose_is_it.boat", tracker(middle), "each has the same weight, as if you took their mean"),
    ("whose_is_it.boat", tracker(turned_round), "to the west: the innovation is the reading minus H x"),
    ("whose_is_it.boat", with_model(STRAIGHT), "with Q = 0 the gain goes to zero"),
    ("whose_is_it.boat", with_model(places_first(), (0, 1), (25, 25, 1, 1)), "is x, v_x, y, v_y, in F and H too"),
    ("when_was_it.live", at_its_own_time, "Wanted is the state at its `now`"),
    ("when_was_it.live", sorted_first, "uses readings before they have arrived"),
    ("when_was_it.live", in_pairs, "one list with a mean and a covariance for each reading"),
    ("when_was_it.live", away, "your state moves away from them"),
    ("when_was_it.live", looser, "as if R were 3 times the R of its row"),
    ("when_was_it.live", mixed_R, "it uses what has not arrived yet"),
    ("when_was_it.live", inflated, "It goes wrong with the rows that arrive late"),
    ("ball_in_a_video.thrown_ball", lambda *given: ball.follow(*given, gate=400), "the detections of something else"),
    (RADAR, wide_R, "R were diag(100, 0.0004)"),
]


@pytest.mark.parametrize(("name", "answer", "words"), OPEN)
def test_a_filter_is_told_what_it_does(name, answer, words):
    assert_told(name, answer, words)
    assert LIKELY not in asked(name).check(answer).text


# ---- likely causes


def test_a_cause_that_the_results_contradict_is_left_out():
    known, unknown = (lambda answers, recordings: True), (lambda answers, recordings: False)
    look = likely("Too small.", ("Is it Q?", known), ("Is it R?", unknown))
    assert look([], []) == "Too small. Is it R?" and isinstance(look([], []), Likely)


def test_a_cause_of_which_nothing_can_be_told_stays():
    assert likely(("Is it Q?", lambda answers, recordings: 1 / 0))([], []) == "Is it Q?"


def test_a_mark_says_what_is_likely_or_what_is_seen():
    mark = Mark("error", lambda answers, truths: 2.0, high=1, above="Look at R.")
    assert isinstance(mark.verdict(2.0, [], []), Likely) and mark.verdict(0.5, [], []) is None
    seen = mark._replace(above=lambda answers, recordings: "Your R is 4.")
    assert not isinstance(seen.verdict(2.0, [], []), Likely)


def test_likely_causes_are_called_likely():
    """A smoother of which no step can be read: its P is too wide, and only likely causes are known."""

    def wide(time, z, q):
        mean, cov = ride.smoothed(time, z, q)
        return mean, 9 * cov

    text = asked("your_data.ride").check(wide).text
    assert LIKELY in text and "The claimed σ is too large." in text


@pytest.mark.parametrize(
    ("gaps", "at", "words"),
    [
        ([3], 3, "There the reading is NaN"),
        ([3], 4, "the first after a missing reading"),
        ([1, 3], 4, "missing readings have been passed before"),
        ([], 4, "The reading there is a number: is it the root"),
    ],
)
def test_a_result_that_is_not_finite(gaps, at, words):
    z = np.arange(8.0)
    z[gaps] = np.nan
    assert words in of_gaps((z, np.eye(2), 0.5), at)
