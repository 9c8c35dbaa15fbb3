"""Late readings: replay is the filter in the right order; retrodiction is Bar-Shalom's algorithm, written out here."""

import numpy as np
import pytest

from kflearn import Gaussian, LinearModel, Readings, TimedFilter, discretise, kalman_filter, merge_events

A, L, q = [[0, 1], [0, 0]], [[0], [1]], 0.3
START = Gaussian([1.0, 0.5], [[4.0, 0.3], [0.3, 1.0]])
H, R = np.array([[1.0, 0.0]]), np.array([[0.5]])


def moves(dt):
    return discretise(A, L, q, dt)


def readings(T=12, seed=1):
    """Times in order, and readings."""
    rng = np.random.default_rng(seed)
    return np.cumsum(rng.uniform(0.2, 1.5, T)), rng.normal(2, 2, (T, 1))


def fed(order, times, z, **settings):
    live = TimedFilter(moves, START, 0.0, **settings)
    for i in order:
        live.update(z[..., i, :], H, R, times[i])
    return live


def in_order(times, z):
    events = merge_events([Readings(times, z, H, R)], 0.0)
    F, Q = discretise(A, L, q, events.dt)
    return kalman_filter(LinearModel(F, H, Q, R), events.z, START)


def close(one, mean, cov, atol=1e-10):
    np.testing.assert_allclose(one.mean, mean, rtol=0, atol=atol)
    np.testing.assert_allclose(one.cov, cov, rtol=0, atol=atol)


@pytest.mark.parametrize("seed", range(5))
def test_in_any_order_a_replay_is_exact(seed):
    times, z = readings()
    z[3] = np.nan
    order = np.random.default_rng(seed).permutation(len(times))
    live, right = fed(order, times, z), in_order(times, z)
    close(live.belief, right.mean[-1], right.cov[-1])
    assert live.time == times[-1]
    assert [entry.time for entry in live.log] == list(times[order])
    assert {entry.how for entry in live.log} == {"in order", "replayed"}


@pytest.mark.parametrize("late", ["replay", "retrodict", "drop"])
def test_readings_in_order_are_a_filter_and_their_nis_is_logged(late):
    times, z = readings()
    live, right = fed(range(len(times)), times, z, late=late), in_order(times, z)
    close(live.belief, right.mean[-1], right.cov[-1])
    np.testing.assert_allclose([entry.nis for entry in live.log], right.nis, rtol=1e-10)
    assert live.corrections == len(times)
    ahead = live.predict_to(times[-1] + 3)
    F, Q = moves(3.0)
    close(ahead, F @ right.mean[-1], F @ right.cov[-1] @ F.T + Q)
    close(live.belief, right.mean[-1], right.cov[-1])  # to look ahead moves nothing


def algorithm_A(older, t_older, now, t_now, z, t):
    """Bar-Shalom 2002, with the retrodicted process noise; for several lags with an equivalent measurement (2004)."""
    whole_F, whole_Q = moves(t_now - t_older)
    x_before, M = whole_F @ older.mean, whole_F @ older.cov @ whole_F.T + whole_Q  # P(k | k − l)
    F, Q = moves(t_now - t)
    back, inverse = np.linalg.inv(F), np.linalg.inv(M)
    w = Q @ inverse @ (now.mean - x_before)
    P_ww = Q - Q @ inverse @ (M - now.cov) @ inverse @ Q
    P_xw = Q - (M - now.cov) @ inverse @ Q
    x = back @ (now.mean - w)
    P = back @ (now.cov + P_ww - P_xw - P_xw.T) @ back.T
    S, C = H @ P @ H.T + R, (now.cov - P_xw) @ back.T @ H.T
    W = C @ np.linalg.inv(S)
    return now.mean + W @ (z - H @ x), now.cov - W @ S @ W.T


@pytest.mark.parametrize("lag", [1, 2, 5])
def test_retrodiction_is_bar_shaloms_algorithm(lag):
    times, z = readings()
    T, i = len(times), len(times) - 1 - lag
    order = [*range(i), *range(i + 1, T)]
    before, older = fed(order, times, z), fed(order[:i], times, z)
    live = fed([*order, i], times, z, late="retrodict")
    mean, cov = algorithm_A(older.belief, older.time, before.belief, before.time, z[i], times[i])
    close(live.belief, mean, cov)
    right = in_order(times, z)
    error = abs(live.belief.cov - right.cov[-1]).max()
    assert (error < 1e-12) if lag == 1 else (1e-6 < error < 0.05)
    assert live.log[-1][1:3] == (lag, "retrodicted")
    assert live.corrections == T  # one for each reading; a replay has to correct once more for each younger one
    assert fed([*order, i], times, z).corrections == T + lag


def test_a_late_reading_may_be_the_first():
    times, z = readings(T=4)
    before = fed([1, 2, 3], times, z).belief
    live = fed([1, 2, 3, 0], times, z, late="retrodict")
    close(live.belief, *algorithm_A(START, 0.0, before, times[3], z[0], times[0]))


def test_retrodiction_is_better_than_to_drop():
    """The errors that both claim, and that both make, over many runs."""
    rng, T = np.random.default_rng(4), 10
    times = np.arange(1.0, T + 1)
    x = START.mean + rng.normal(size=(4000, 2)) @ np.linalg.cholesky(START.cov).T
    path = []
    F, Q = moves(1.0)
    for _ in times:
        x = x @ F.T + rng.normal(size=x.shape) @ np.linalg.cholesky(Q).T
        path.append(x)
    z = np.stack(path, 1)[..., :1] + rng.normal(0, np.sqrt(R[0, 0]), (4000, T, 1))
    order = [0, 1, 2, 3, 4, 5, 7, 8, 9, 6]
    found = {}
    for late in ("replay", "retrodict", "drop"):
        live = fed(order, times, z, late=late)
        off = live.belief.mean - path[-1]
        score = np.mean(np.einsum("ri,ij,rj->r", off, np.linalg.inv(live.belief.cov), off))
        assert score == pytest.approx(2, abs=4 * 2 / np.sqrt(4000)), late  # all three know how good they are
        found[late] = live.belief.cov[0, 0]
    assert found["replay"] <= found["retrodict"] < found["drop"]


def test_what_is_older_than_the_memory_is_dropped():
    times, z = readings()
    live = fed([*range(2, 12), 0], times, z, keep=5)
    assert live.log[-1].how == "dropped"
    assert np.isnan(live.log[-1].nis)
    without = fed(range(2, 12), times, z).belief
    close(live.belief, without.mean, without.cov)
    assert fed([*range(2, 12), 0], times, z).log[-1].how == "replayed"  # the default remembers twenty


def test_two_sensors_at_one_moment():
    live = TimedFilter(moves, START, 0.0)
    live.update(2.0, H, R, 1.0)
    live.update([1.0, 0.1], np.eye(2), np.diag([0.3, 0.2]), 1.0)
    events = merge_events(
        [Readings([1.0], [2.0], H, R), Readings([1.0], [[1.0, 0.1]], np.eye(2), np.diag([0.3, 0.2]))], 0
    )
    F, Q = discretise(A, L, q, events.dt)
    right = kalman_filter(LinearModel(F, events.H, Q, events.R), events.z, START)
    close(live.belief, right.mean[-1], right.cov[-1])


REFUSED = [
    (lambda f: TimedFilter(3, START, 0), "moves must be a function, got int"),
    (lambda f: TimedFilter(moves, [0, 0], 0), "initial must be a Gaussian, got list"),
    (lambda f: TimedFilter(moves, START, 0, late="forget"), "late must be one of 'replay', 'retrodict', 'drop', got"),
    (lambda f: TimedFilter(moves, START, 0, keep=0), "keep must be a whole number of at least 1, got 0"),
    (lambda f: TimedFilter(moves, START, np.nan), "time must be finite, found nan"),
    (lambda f: TimedFilter(lambda dt: 3, START, 0).predict_to(1), "moves must return two matrices, F and Q, got int"),
    (lambda f: f.update(1.0, [[1.0]], R, 2.0), r"H must have shape \(any, 2\), got \(1, 1\)"),
    (lambda f: f.update([1.0, 2.0], H, R, 2.0), r"z must have shape \(1,\), got \(2,\)"),
    (lambda f: f.update(1.0, H, -R, 2.0), "R must be positive definite"),
    (lambda f: f.update(1.0, H, R, np.inf), "t must be finite, found inf"),
    (lambda f: f.update(np.inf, H, R, 2.0), "z must be finite"),
    (lambda f: f.predict_to(0.5), "t must be 1 or later, the time of the newest reading, got 0.5"),
    (
        lambda f: TimedFilter(lambda dt: (1, 2), START, 0).predict_to(1),
        r"the F of moves must have shape \(2, 2\), got the number 1",
    ),
]


@pytest.mark.parametrize("call, sentence", REFUSED)
def test_bad_input_gets_one_sentence_and_changes_nothing(call, sentence):
    live = TimedFilter(moves, START, 0.0)
    live.update(2.0, H, R, 1.0)
    before = live.belief
    with pytest.raises((ValueError, TypeError), match=sentence):
        call(live)
    assert (live.time, live.belief, len(live.log)) == (1.0, before, 1)


def test_moves_that_fail_in_the_middle_of_a_replay_leave_the_filter_as_it_was():
    fails = []

    def fragile(dt):
        if fails:
            raise ZeroDivisionError("no more")
        return moves(dt)

    live = TimedFilter(fragile, START, 0.0)
    for t in (1.0, 2.0, 3.0):
        live.update(2.0, H, R, t)
    before = live.belief
    fails.append(1)
    with pytest.raises(ZeroDivisionError):
        live.update(2.0, H, R, 1.5)
    assert (live.time, live.belief, len(live.log)) == (3.0, before, 3)
