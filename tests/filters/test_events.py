"""Several sensors with clocks of their own, against one dense Gaussian over all moments."""

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    LinearModel,
    NonlinearModel,
    Readings,
    discretise,
    extended_kalman_filter,
    kalman_filter,
    merge_events,
    rts_smoother,
)
from tests.helpers import random_covariance

A, L, q = np.array([[0.0, 1.0], [0.0, 0.0]]), np.array([[0.0], [1.0]]), 0.3
START, P0 = Gaussian([1.0, 0.5], [[4.0, 0.3], [0.3, 1.0]]), 0.2


def moved(t):
    """F and Q over t seconds, in closed form."""
    return np.array([[1, t], [0, 1]]), q * np.array([[t**3 / 3, t**2 / 2], [t**2 / 2, t]])


def dense(sensors, wanted, until=np.inf):
    """Mean and covariance at the wanted times from all readings up to `until`: one big Gaussian, one solve."""
    rows = [
        (t, z[c], H[c], R[c, c], (s, i))
        for s, (times, zs, Hs, Rs) in enumerate(sensors)
        for i, (t, z) in enumerate(zip(times, zs, strict=True))
        for H, R in [(Hs[i] if Hs.ndim == 3 else Hs, Rs[i] if Rs.ndim == 3 else Rs)]
        for c in range(len(H))
        if t <= until and not np.isnan(z[c])
    ]
    times = [t for t, *_ in rows] + list(wanted)
    marginal = [(F @ START.mean, F @ START.cov @ F.T + Q) for F, Q in (moved(t - P0) for t in times)]

    def cross(i, j):
        if times[i] > times[j]:
            return cross(j, i).T
        return marginal[i][1] @ moved(times[j] - times[i])[0].T

    Z = len(rows)
    S = np.array([[rows[i][2] @ cross(i, j) @ rows[j][2] for j in range(Z)] for i in range(Z)])
    S += np.diag([r[3] for r in rows])
    y = np.array([z - H @ marginal[i][0] for i, (_, z, H, *_) in enumerate(rows)])
    found = []
    for w in range(Z, len(times)):
        C = np.stack([cross(w, i) @ rows[i][2] for i in range(Z)], axis=1)
        found.append((marginal[w][0] + C @ np.linalg.solve(S, y), marginal[w][1] - C @ np.linalg.solve(S, C.T)))
    return (np.stack(part) for part in zip(*found, strict=True))


@pytest.fixture
def sensors():
    """A position sensor, a pair (with gaps, diagonal R) at some of the same moments, and one whose H and R change."""
    rng = np.random.default_rng(3)
    position = np.sort(rng.uniform(0.3, 9, 12))
    both = np.concatenate([position[2:8:2], [9.5, 0.25]])  # not in the order of time
    z = rng.normal(2, 2, (5, 2))
    z[1, 0] = z[3, 1] = np.nan
    moving = rng.uniform(0.3, 9, 6)
    return [
        Readings(position, rng.normal(2, 2, (12, 1)), np.array([[1.0, 0.0]]), np.array([[0.5]])),
        Readings(both, z, np.array([[1.0, 0.2], [0.0, 1.0]]), np.diag([0.4, 2.0])),
        Readings(moving, rng.normal(0, 1, (6, 1)), rng.normal(size=(6, 1, 2)), rng.uniform(0.2, 2, (6, 1, 1))),
    ]


def filtered(events):
    F, Q = discretise(A, L, q, events.dt)
    return kalman_filter(LinearModel(F, events.H, Q, events.R), events.z, START)


def test_each_estimate_is_that_of_a_dense_gaussian(sensors):
    events = merge_events(sensors, P0)
    track = filtered(events)
    assert len(events.times) == len(np.unique(np.concatenate([each.times for each in sensors])))
    for k, t in enumerate(events.times):
        mean, cov = dense(sensors, [t], until=t)
        np.testing.assert_allclose(track.mean[k], mean[0], rtol=0, atol=1e-10)
        np.testing.assert_allclose(track.cov[k], cov[0], rtol=0, atol=1e-10)


def test_an_even_path_and_a_forecast(sensors):
    wanted = np.arange(0.5, 14, 0.5)[::-1]
    events = merge_events(sensors, P0, at=wanted)
    np.testing.assert_array_equal(events.times[events.at], wanted)
    smooth = rts_smoother(filtered(events).model, filtered(events))
    mean, cov = dense(sensors, wanted)
    np.testing.assert_allclose(smooth.mean[events.at], mean, rtol=0, atol=1e-10)
    np.testing.assert_allclose(smooth.cov[events.at], cov, rtol=0, atol=1e-10)


def test_wanted_moments_change_nothing_else(sensors):
    plain, more = merge_events(sensors, P0), merge_events(sensors, P0, at=[1.0, 2.0, *sensors[0].times, 20.0])
    same = np.isin(more.times, plain.times)
    np.testing.assert_allclose(filtered(more).mean[same], filtered(plain).mean, rtol=0, atol=1e-11)
    assert filtered(more).log_likelihood == pytest.approx(filtered(plain).log_likelihood, rel=1e-12)


def test_the_order_of_a_sensors_readings_does_not_matter(sensors):
    order = np.random.default_rng(1).permutation(6)
    sensor = sensors[2]
    mixed = Readings(*(part[order] for part in sensor))
    for one, other in zip(merge_events([*sensors[:2], mixed], P0), merge_events(sensors, P0), strict=True):
        np.testing.assert_array_equal(one, other)


def test_many_runs_at_once(sensors):
    rng = np.random.default_rng(2)
    many = sensors[0]._replace(z=rng.normal(size=(7, 12, 1)))
    events = merge_events([many, *sensors[1:]], P0)
    assert events.z.shape == (7, len(events.times), 4)
    alone = merge_events([many._replace(z=many.z[4]), *sensors[1:]], P0)
    np.testing.assert_allclose(filtered(events).mean[4], filtered(alone).mean, rtol=0, atol=1e-11)


def test_a_nonlinear_model_takes_the_steps_by_their_number(sensors):
    events = merge_events(sensors[:2], P0)
    F, Q = discretise(A, L, q, events.dt)
    model = NonlinearModel(lambda x, u, k: x @ F[k].T, lambda x: x @ events.H.T, Q, events.R)
    found, right = extended_kalman_filter(model, events.z, START), filtered(events)
    np.testing.assert_allclose(found.mean, right.mean, rtol=0, atol=1e-7)
    np.testing.assert_allclose(found.cov, right.cov, rtol=0, atol=1e-7)


def test_full_covariances_are_blocks():
    rng = np.random.default_rng(0)
    R = random_covariance(rng, 2)
    events = merge_events([Readings([1], [3.0], [[1, 0]], 2), Readings([2], [[1, 2]], np.eye(2), R)], 0)
    np.testing.assert_array_equal(events.R[0], [2, 0, 0])
    np.testing.assert_array_equal(events.R[1:, 1:], R)
    np.testing.assert_array_equal(events.z, [[3, np.nan, np.nan], [np.nan, 1, 2]])


GOOD = Readings([1.0, 2.0], [3.0, 4.0], [[1.0, 0.0]], 1.0)
REFUSED = [
    (lambda: merge_events(GOOD, 0), "sensors must be a list of Readings, got Readings"),
    (lambda: merge_events([], 0), "sensors must be a list of Readings, got list"),
    (lambda: merge_events([GOOD, 3], 0), "sensor 1 must be Readings, got int"),
    (lambda: merge_events([GOOD._replace(times=[1, 1])], 0), "times of sensor 0 must differ, found 1 twice"),
    (lambda: merge_events([GOOD._replace(times=[1, np.nan])], 0), "times of sensor 0 must be finite, found nan"),
    (lambda: merge_events([GOOD._replace(times=[[1, 2]])], 0), r"times of sensor 0 must have shape \(any,\)"),
    (lambda: merge_events([GOOD._replace(z=[1.0])], 0), r"z of sensor 0 must have shape \(2, 1\), got \(1, 1\)"),
    (
        lambda: merge_events([GOOD, GOOD._replace(H=[[1]])], 0),
        r"H of sensor 1 must have shape \(any, 2\), got",
    ),
    (lambda: merge_events([GOOD._replace(R=np.eye(2))], 0), r"R of sensor 0 must have shape \(1, 1\), got \(2, 2\)"),
    (lambda: merge_events([GOOD._replace(R=np.ones((3, 1, 1)))], 0), "R of sensor 0 must be one matrix, or one for"),
    (lambda: merge_events([GOOD._replace(R=0)], 0), "R of sensor 0 must be positive definite"),
    (lambda: merge_events([GOOD], 1.5), "start must not be later than the first time, got 1.5 and 1"),
    (lambda: merge_events([GOOD], 0, at=[-1]), "start must not be later than the first time, got 0 and -1"),
    (lambda: merge_events([GOOD], 0, at=[[1]]), r"at must have shape \(any,\), got \(1, 1\)"),
    (
        lambda: merge_events([GOOD._replace(z=np.ones((3, 2, 1))), GOOD._replace(z=np.ones((4, 2, 1)))], 0),
        "z of sensor 0 and z of sensor 1 must have batch axes that broadcast",
    ),
]


@pytest.mark.parametrize("call, sentence", REFUSED)
def test_bad_input_gets_one_sentence(call, sentence):
    with pytest.raises((ValueError, TypeError), match=sentence):
        call()
