"""One reading at a time: the numbers of the filters over a series, their errors, their speed, and no memory."""

import pickle
import tracemalloc

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    LinearModel,
    NonlinearModel,
    OnlineFilter,
    cubature,
    cubature_kalman_filter,
    extended_kalman_filter,
    kalman_filter,
    random_walk,
    unscented,
    unscented_kalman_filter,
)
from tests.helpers import bent, close, random_belief, random_model, with_gaps

T = 40


def online(live, z, u=None):
    """Means, covariances, NIS, S, gains and refusals of a series, (T, ...) each."""
    rows = []
    for k, reading in enumerate(z):
        live.step(reading, None if u is None else u[k])
        rows.append((live.mean, live.cov, live.nis, live.S, live.gain, live.refused, live.innovation.mean))
    return [np.stack(part) for part in zip(*rows, strict=True)]


def same(live, track, z, u=None, tolerance=1e-12):
    found = online(live, z, u)
    wanted = (track.mean, track.cov, track.nis, track.innovation.cov, track.gain, track.refused, track.innovation.mean)
    for one, other in zip(found, wanted, strict=True):
        close(one, other, tolerance)


@pytest.mark.parametrize("gate", [None, 0.9])
@pytest.mark.parametrize("gaps", [False, True])
@pytest.mark.parametrize(("n", "m", "p"), [(2, 1, 0), (3, 2, 1), (4, 3, 2)])
def test_it_is_the_kalman_filter(n, m, p, gaps, gate):
    rng = np.random.default_rng(n)
    z, u = rng.normal(size=(T, m)) * 3, rng.normal(size=(T, p)) if p else None
    z = with_gaps(rng, z) if gaps else z
    for steps in (None, T):
        model, start = random_model(rng, n, m, p, steps), random_belief(rng, n)
        same(OnlineFilter(model, start, gate=gate), kalman_filter(model, z, start, u, gate=gate), z, u)


WAYS = {
    "EKF": (extended_kalman_filter, lambda n: {}),
    "UKF": (unscented_kalman_filter, lambda n: {"through": unscented(n)}),
    "CKF": (cubature_kalman_filter, lambda n: {"through": cubature(n)}),
}


@pytest.mark.parametrize("gate", [None, 0.9])
@pytest.mark.parametrize("jacobians", [True, False])
@pytest.mark.parametrize("way", WAYS)
def test_it_is_the_filter_of_a_nonlinear_model(way, jacobians, gate):
    rng = np.random.default_rng(1)
    kf, settings = WAYS[way]
    model, start = bent(random_model(rng, 3, 2, 1)), random_belief(rng, 3)
    model = model if jacobians else model.replace(F_jacobian=None, H_jacobian=None)
    z, u = with_gaps(rng, rng.normal(size=(T, 2)) * 3), rng.normal(size=(T, 1))
    # A Jacobian by differences makes of a last digit in x the tenth digit of a slope.
    tolerance = 1e-9 if way == "EKF" and not jacobians else 1e-12
    same(OnlineFilter(model, start, **settings(3), gate=gate), kf(model, z, start, u, gate=gate), z, u, tolerance)


def test_many_runs_side_by_side():
    rng = np.random.default_rng(2)
    model, z = random_model(rng, 2, 1), rng.normal(size=(5, T, 1))
    start = Gaussian(rng.normal(size=(5, 2)), np.eye(2))
    track, live = kalman_filter(model, z, start, gate=0.9), OnlineFilter(model, start, gate=0.9)
    for k in range(T):
        live.step(z[:, k])
        close(live.mean, track.mean[:, k], 1e-12)
        np.testing.assert_array_equal(live.refused, track.refused[:, k])
    assert live.S.shape == (5, 1, 1)


def test_angles_wrap_and_numbers_are_readings():
    model = NonlinearModel(
        lambda x: x, lambda x: x[..., :1], np.eye(2), 1.0, residual=lambda a, b: (a - b + 180) % 360 - 180
    )
    live = OnlineFilter(model, Gaussian([179, 0], np.eye(2)))
    live.step(-179)
    assert live.innovation.mean == pytest.approx(2)
    for reading in (-179, -179.0, [-179], np.float64(-179), np.float32(-179), np.array(-179)):
        again = OnlineFilter(model, Gaussian([179, 0], np.eye(2)))
        again.step(reading)
        close(again.mean, live.mean, 1e-15)


def test_a_prediction_without_a_reading_and_two_readings_of_a_step():
    model, start = random_walk(1, 2), Gaussian(0, 1)
    live = OnlineFilter(model, start)
    assert (live.k, live.S, live.nis, live.gain, live.refused, live.innovation) == (-1, *[None] * 5)
    live.predict()
    live.predict()
    assert live.k == 1
    live.correct(4.0)
    live.correct(2.0)
    first, second = kalman_filter(model, [np.nan, 4], start), kalman_filter(model.replace(Q=0), [2], Gaussian(2, 1.2))
    close(live.cov, 1 / (1 / first.cov[-1] + 1 / 2))
    close(second.mean[-1], [2])
    assert f"{live.belief:.3f}" == f"N({live.mean[0]:.3f}, {live.cov[0, 0]:.3f})"
    assert repr(live).startswith("OnlineFilter at step 1: N(")
    for array in (live.mean, live.cov, live.S, live.gain, live.belief.cov):
        assert not array.flags.writeable


WRONG = {
    "z two wide": (lambda live: live.step([1.0, 2.0]), r"z must have shape \(1,\), got \(2,\)"),
    "z text": (lambda live: live.step("1"), "z must consist of real numbers, found text"),
    "z infinite": (lambda live: live.step(np.inf), "z must be finite"),
    "z None": (lambda live: live.step(None), "z must .* found NoneType"),
    "u without B": (lambda live: live.step(1.0, 1.0), "no B"),
}


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_reading_is_named_and_changes_nothing(name):
    call, sentence = WRONG[name]
    live = OnlineFilter(random_walk(1, 2), Gaussian(0, 1))
    live.step(1.0)
    before = live.k, live.mean.copy(), live.cov.copy()
    with pytest.raises((ValueError, TypeError), match=sentence):
        call(live)
    assert (live.k, live.mean, live.cov) == before


def test_u_is_looked_at():
    live = OnlineFilter(LinearModel(1, 1, 1, 1, 1), Gaussian(0, 1))
    for wrong, sentence in ((np.nan, "u must be finite"), ([1, 2], r"u must have shape \(1,\)"), ("1", "found text")):
        with pytest.raises((ValueError, TypeError), match=sentence):
            live.step(1.0, wrong)
    assert live.k == -1
    live.step(1.0, 1)
    live.step(1.0, np.array([1.0]))


def test_what_a_function_or_rounding_breaks_is_named_with_its_step():
    def f(x):
        return np.where(x > 2.5, np.nan, x + 1)

    live = OnlineFilter(NonlinearModel(f, lambda x: x, 1e-12, 1.0), Gaussian(0, 1e-12))
    for _ in range(3):
        live.step(0.0)
    with pytest.raises(ValueError, match="f must return finite numbers, found nan at step 3"):
        live.step(0.0)
    live = OnlineFilter(NonlinearModel(lambda x: x + 1, lambda x: f(x), 1e-12, 1.0), Gaussian(0, 1e-12))
    live.step(0.0)
    live.step(0.0)
    with pytest.raises(ValueError, match="h must return finite numbers, found nan at step 2"):
        live.step(0.0)
    twice = LinearModel(np.eye(2), [[1, 1], [1, 1]], np.zeros((2, 2)), 1e-9 * np.eye(2))
    with pytest.raises(ValueError, match="R must be larger beside P: at step 0"):
        OnlineFilter(twice, Gaussian([0, 0], 1e12 * np.eye(2))).step([1.0, 1.0])


def test_stacks_end():
    model = LinearModel(np.ones((3, 1, 1)), 1, 1, 1)
    live = OnlineFilter(model, Gaussian(0, 1))
    for _ in range(3):
        live.step(1.0)
    with pytest.raises(ValueError, match="model must have matrices for each step, but it has 3"):
        live.step(1.0)
    with pytest.raises(ValueError, match="Q must have 3 steps, or 1"):
        OnlineFilter(model.replace(Q=np.ones((2, 1, 1))), Gaussian(0, 1))


def test_memory_stays_flat():
    live = OnlineFilter(random_walk(0.1, 1), Gaussian(0, 1), gate=0.99)
    z = np.random.default_rng(3).normal(size=1000)
    tracemalloc.start()
    try:
        live.step(0.0)
        before = tracemalloc.get_traced_memory()[0]
        for _ in range(5):
            for reading in z:
                live.step(reading)
        assert tracemalloc.get_traced_memory()[0] - before < 5_000  # a number kept of each step would be 40,000 bytes
    finally:
        tracemalloc.stop()


def test_it_can_be_pickled():
    live = OnlineFilter(random_walk(0.1, 1), Gaussian(0, 1))
    live.step(1.0)
    other = pickle.loads(pickle.dumps(live))
    for each in (live, other):
        each.step(2.0)
    assert (live.mean, live.cov, live.k) == (other.mean, other.cov, other.k)
