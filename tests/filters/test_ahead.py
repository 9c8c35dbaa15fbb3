"""What comes next, where a filter rests, and what the smoothed noises say."""

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    LinearModel,
    NonlinearModel,
    constant_velocity,
    diffuse_start,
    disturbances,
    examples,
    forecast,
    kalman_filter,
    lag_one_covariances,
    random_walk,
    rts_smoother,
    simulate,
    square_root_kalman_filter,
    steady_state,
    unscented_kalman_filter,
)

NILE = examples.load("nile")["flow"]
MODEL = LinearModel(
    [[1, 0.5], [0.1, 0.9]], [[1, 0], [0.3, 1]], [[0.3, 0.1], [0.1, 0.2]], [[1, 0.2], [0.2, 2]], B=[[1], [0]]
)
START = Gaussian([1, 2], [[3, 1], [1, 2]])


def dense(T):
    """Mean and covariance of all states of T steps, and of all readings, without any filter."""
    n = 2
    cov, mean = np.zeros((T * n, T * n)), np.zeros(T * n)
    x, P = START.mean, START.cov
    for k in range(T):
        x, P = MODEL.F @ x, MODEL.F @ P @ MODEL.F.T + MODEL.Q
        now = slice(n * k, n * k + n)
        mean[now], cov[now, now] = x, P
        for later in range(k + 1, T):
            cross = np.linalg.matrix_power(MODEL.F, later - k) @ P
            cov[n * later : n * later + n, now], cov[now, n * later : n * later + n] = cross, cross.T
    H = np.kron(np.eye(T), MODEL.H)
    return mean, cov, H, H @ cov @ H.T + np.kron(np.eye(T), MODEL.R)


def series(T=7):
    return np.random.default_rng(1).normal(2, 3, (T, 2))


def given(T=7):
    """Mean and covariance of all states, given all readings."""
    mean, cov, H, S = dense(T)
    K = cov @ H.T @ np.linalg.inv(S)
    return mean + K @ (series(T).ravel() - H @ mean), cov - K @ H @ cov


@pytest.mark.parametrize("run", [kalman_filter, square_root_kalman_filter])
def test_lag_one_covariances_are_those_of_all_states_together(run):
    _, cov = given()
    lag = lag_one_covariances(MODEL, run(MODEL, series(), START))
    for k in range(6):
        np.testing.assert_allclose(lag[k], cov[2 * k + 2 : 2 * k + 4, 2 * k : 2 * k + 2], atol=1e-12)


def test_lag_one_covariances_of_many_runs_and_of_one_step():
    z = np.stack([series(), series() + 1])
    assert lag_one_covariances(MODEL, kalman_filter(MODEL, z, START)).shape == (2, 6, 2, 2)
    assert lag_one_covariances(MODEL, kalman_filter(MODEL, z[:, :1], START)).shape == (2, 0, 2, 2)


def test_disturbances_are_the_noises_given_all_readings():
    mean, cov = given()
    found = disturbances(MODEL, kalman_filter(MODEL, series(), START))
    E = series().ravel() - np.kron(np.eye(7), MODEL.H) @ mean
    H = np.kron(np.eye(7), MODEL.H)
    told = np.diagonal(np.kron(np.eye(7), MODEL.R) - H @ cov @ H.T)
    np.testing.assert_allclose(found.measurement.ravel(), E / np.sqrt(told), atol=1e-9)
    step = np.kron(np.eye(7, k=0)[1:], np.eye(2)) - np.kron(np.eye(7)[:-1], MODEL.F)
    told = np.diagonal(np.kron(np.eye(6), MODEL.Q) - step @ cov @ step.T)
    np.testing.assert_allclose(found.state[1:].ravel(), step @ mean / np.sqrt(told), atol=1e-8)
    assert np.isnan(found.state[0]).all()


def test_the_break_of_the_nile_is_found():
    """Durbin and Koopman 2012, fig. 2.8: the level breaks in 1899, and 1877 and 1913 are low readings."""
    start = diffuse_start(random_walk(1469.1, 15099), NILE)
    track = kalman_filter(start.model, NILE[start.steps :], start.belief)
    found = disturbances(track.model, track)
    assert 1872 + np.nanargmin(found.state[:, 0]) == 1899 and np.nanmin(found.state) < -2.8
    assert set(1872 + np.argsort(found.measurement[:, 0])[:2]) == {1877, 1913}


def test_honest_noises_scatter_as_they_should():
    model = constant_velocity(1, 0.5, 4)
    z = simulate(model, Gaussian([0, 0], np.eye(2)), 400, rng=1).z
    found = disturbances(model, kalman_filter(model, z, Gaussian([0, 0], np.eye(2))))
    assert np.std(found.measurement) == pytest.approx(1, abs=0.1)
    assert np.nanstd(found.state[:, 1]) == pytest.approx(1, abs=0.25)


def test_a_forecast_is_a_filter_without_readings():
    z, u = series(), np.arange(4.0)[:, None]
    track = kalman_filter(MODEL, z, START, np.zeros((7, 1)))
    ahead = forecast(track, 4, u)
    blind = kalman_filter(MODEL, np.full((4, 2), np.nan), track[-1], u)
    np.testing.assert_allclose(ahead.states.mean, blind.mean, atol=1e-12)
    np.testing.assert_allclose(ahead.states.cov, blind.cov, atol=1e-12)
    np.testing.assert_allclose(ahead.readings.mean, blind.mean @ MODEL.H.T, atol=1e-12)
    np.testing.assert_allclose(ahead.readings.cov, blind.innovation.cov, atol=1e-12)


def test_bands_of_a_forecast_hold_what_they_promise():
    model, start = constant_velocity(1, 0.3, 1), Gaussian([0, 0], np.eye(2))
    z = simulate(model, start, 40, runs=10000, rng=2).z
    ahead = forecast(kalman_filter(model, z[:, :30], start), 10)
    inside = abs(z[:, 30:] - ahead.readings.mean) < 1.96 * ahead.readings.std
    assert inside.mean() == pytest.approx(0.95, abs=0.006)


def test_a_forecast_through_a_curve():
    model = NonlinearModel(lambda x: 0.9 * x, lambda x: x**2, Q=0.1, R=0.2)
    ahead = forecast(unscented_kalman_filter(model, [4.0, 3.2, 2.7], Gaussian(2, 1)), 2)
    assert ahead.readings.mean.shape == (2, 1)
    assert ahead.readings.mean[0, 0] == pytest.approx(ahead.states.mean[0, 0] ** 2 + ahead.states.cov[0, 0, 0])


def test_the_steady_state_is_where_the_filter_ends():
    rest = steady_state(MODEL)
    track = kalman_filter(MODEL, np.zeros((200, 2)), START)
    np.testing.assert_allclose(rest.cov, track.cov[-1], rtol=1e-10)
    np.testing.assert_allclose(rest.gain, track.gain[-1], rtol=1e-10)
    np.testing.assert_allclose(rest.predicted, track.predicted.cov[-1], rtol=1e-10)
    np.testing.assert_allclose(rest.S, track.innovation.cov[-1], rtol=1e-10)


def test_what_cannot_be_says_so():
    with pytest.raises(ValueError, match="model must have a steady state"):
        steady_state(LinearModel([[1, 0], [0, 2]], [[1, 0]], np.eye(2), 1))
    with pytest.raises(TypeError, match="model must be a LinearModel"):
        steady_state(3)
    changing = LinearModel(np.ones((3, 1, 1)), 1, 1, 1)
    with pytest.raises(ValueError, match="same matrices at all steps"):
        steady_state(changing)
    track = kalman_filter(changing, [1.0, 2.0, 3.0], Gaussian(0, 1))
    with pytest.raises(ValueError, match="how do these go on"):
        forecast(track, 2)
    with pytest.raises(TypeError, match="track must be a Track"):
        forecast(3, 2)
    with pytest.raises(TypeError, match="track must come from kalman_filter"):
        disturbances(changing, rts_smoother(changing, track))
