"""Functions that take the input and the step, and states that are angles: against linear models that say the same."""

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    LinearModel,
    NonlinearModel,
    adaptive_kalman_filter,
    correct,
    cubature_kalman_filter,
    extended_kalman_filter,
    imm_filter,
    kalman_filter,
    linearized_kalman_filter,
    mmae_filter,
    predict,
    report_card,
    rts_smoother,
    simulate,
    start_from,
    unscented,
    unscented_kalman_filter,
    wrap,
)
from tests.helpers import close, random_belief, random_model, same_track, with_gaps

FILTERS = [extended_kalman_filter, unscented_kalman_filter, cubature_kalman_filter, linearized_kalman_filter]
PAIR = dict(transition=[[0.9, 0.1], [0.2, 0.8]], mode_probabilities=[0.5, 0.5])
T = 12


def of_time(linear, jacobians):
    """A linear model with stacks, as functions of the step."""
    slopes = dict(F_jacobian=lambda x, u, k: linear.F[k], H_jacobian=lambda x, u, k: linear.H[k]) if jacobians else {}
    return NonlinearModel(
        lambda x, u, k: x @ linear.F[k].T + (0 if u is None else u @ linear.B[k].T),
        lambda x, u, k: x @ linear.H[k].T,
        linear.Q,
        linear.R,
        **slopes,
    )


def case(runs=(3,)):
    rng = np.random.default_rng(5)
    linear, start = random_model(rng, 3, 2, 1, steps=T, fastest=0.9), random_belief(rng, 3)
    return linear, start, rng.normal(size=(*runs, T, 1)), with_gaps(rng, rng.normal(size=(*runs, T, 2)), 0.1)


@pytest.mark.parametrize("kf", FILTERS)
@pytest.mark.parametrize("runs", [(), (3,)])
@pytest.mark.parametrize("jacobians", [True, False])
def test_functions_of_the_step_are_stacks(kf, runs, jacobians):
    linear, start, u, z = case(runs)
    for given in (u, None):
        track, expected = kf(of_time(linear, jacobians), z, start, given), kalman_filter(linear, z, start, given)
        tolerance = 1e-9 if jacobians or kf in FILTERS[1:3] else 1e-7
        same_track(track, expected, tolerance)
        smooth, other = rts_smoother(track.model, track), rts_smoother(linear, expected)
        close(smooth.mean, other.mean, tolerance)
        close(smooth.cov, other.cov, tolerance)


def test_the_linearised_filter_along_a_given_path():
    linear, start, u, z = case()
    nominal = np.random.default_rng(1).normal(size=(T, 3))
    for jacobians in (True, False):
        track = linearized_kalman_filter(of_time(linear, jacobians), z, start, u, nominal=nominal)
        same_track(track, kalman_filter(linear, z, start, u), 1e-7)
    smooth = rts_smoother(track.model, track)
    close(smooth.mean, rts_smoother(linear, kalman_filter(linear, z, start, u)).mean, 1e-7)


def test_single_steps_simulation_and_several_models():
    linear, start, u, z = case()
    model, expected = of_time(linear, jacobians=True), kalman_filter(linear, z, start, u)
    belief = start
    for k in range(T):
        belief = correct(model, predict(model, belief, u[:, k], k=k), z[:, k], u=u[:, k], k=k)
        close(belief.mean, expected.mean[:, k])
    data, other = (simulate(each, start, T, u, runs=3, rng=2) for each in (model, linear))
    close(data.x, other.x)
    close(data.z, other.z)
    for adapt in ("R", "Q"):
        tracks = [adaptive_kalman_filter(each, z, start, u, window=3, adapt=adapt) for each in (model, linear)]
        same_track(*tracks)
    for through in (unscented(3), None):
        how = PAIR if through is None else {**PAIR, "through": through}
        tracks = [imm_filter([each, each.replace(Q=3 * linear.Q)], z, start, u, **how) for each in (model, linear)]
        close(tracks[0].mean, tracks[1].mean)
        close(tracks[0].cov, tracks[1].cov)
        close(tracks[0].log_likelihood, tracks[1].log_likelihood)


def test_a_smaller_model_of_a_bank_gets_input_and_step():
    linear, start, u, z = case()
    small = random_model(np.random.default_rng(3), 2, 2, 1, steps=T, fastest=0.9)
    E = np.eye(3)[:, [2, 0]]
    whole = LinearModel(E @ small.F @ E.T, small.H @ E.T, E @ small.Q @ E.T, small.R, E @ small.B)
    expected = imm_filter([whole, linear], z, start, u, **PAIR)
    for jacobians in (True, False):
        models = [of_time(small, jacobians).replace(scale=[1.0, 2.0]), of_time(linear, jacobians)]
        track = imm_filter(models, z, start, u, **PAIR, states=[[2, 0], [0, 1, 2]])
        close(track.mean, expected.mean, 1e-7)
        close(track.mode_probabilities, expected.mode_probabilities, 1e-7)
    with pytest.raises(ValueError, match=r"^u must be given: h"):
        needs = models[0].replace(h=lambda x, u: x)
        imm_filter([needs, models[1]], z, start, **PAIR, states=[[2, 0], [0, 1, 2]])


def test_the_report_card_expects_what_the_filter_expects():
    rng = np.random.default_rng(7)
    steps, H = 60, 1 + 0.5 * np.sin(np.arange(59))[:, None, None]
    linear = LinearModel(1, H, 1, 1)
    bent = NonlinearModel(lambda x: x, lambda x, u: x * u, 1, 1)
    z = np.concatenate([np.zeros(20), np.cumsum(rng.normal(size=40))]) + rng.normal(size=steps)
    start, rest = start_from(linear.replace(H=1), z[0]), np.arange(steps) < 20
    card = report_card(z, rest, lambda z: (linear, kalman_filter(linear, z[1:], start)))
    for model in (bent, bent.replace(h=lambda x, u, k: x * H[k, 0])):
        other = report_card(z, rest, lambda z, m=model: (m, extended_kalman_filter(m, z[1:], start, H[:, 0])))
        close([test.found for test in other.tests], [test.found for test in card.tests], 1e-7)


def observer(steps=30):
    """A course with a bend: 5 m east each step, then also 8 m north."""
    k = np.arange(steps)
    return np.column_stack([5.0 * k, np.where(k < 15, 0, 8.0 * (k - 15))])


def bearing(x, u):
    return np.arctan2(x[..., 2:3] - u[..., 1:2], x[..., :1] - u[..., :1])


F = np.kron(np.eye(2), [[1, 1], [0, 1]])


@pytest.mark.parametrize("kf", FILTERS[:3])
def test_a_moving_sensor_finds_where_a_target_is(kf):
    model = NonlinearModel(lambda x: x @ F.T, bearing, 1e-6 * np.eye(4), 1e-5)
    start = Gaussian([300, 0, 300, 0], np.diag([100.0, 0.5, 100, 0.5]) ** 2)
    data = simulate(model, start, 30, observer(), runs=100, rng=1)
    track = kf(model, data.z, start, data.u)
    miss = np.linalg.norm((track.mean - data.x)[..., ::2], axis=-1)
    assert np.median(miss[:, -1]) < 15 < 50 < np.median(miss[:, 0])
    at_rest = kf(model, data.z, start, np.zeros((30, 2)))  # not told that the sensor moves
    assert np.median(np.linalg.norm((at_rest.mean - data.x)[:, -1, ::2], axis=-1)) > 100
    path = observer()
    own = model.replace(h=lambda x, u, k: bearing(x, path[k]))  # the path in the function, no input
    same_track(kf(own, data.z, start), track)
    belief = start
    for k, (row, place) in enumerate(zip(data.z[0], path, strict=True)):  # FilterPy's loop, by hand
        belief = predict(model, belief)
        x, P, H = belief.mean, belief.cov, model.measure_slope(belief.mean, place)
        K = P @ H.T / (H @ P @ H.T + 1e-5)
        belief = Gaussian(x + K @ (row - bearing(x, place)), P - K @ H @ P)
        if kf is extended_kalman_filter:
            close(track.mean[0, k], belief.mean, 1e-6)


# ---- states that are angles: f returns them wrapped, and the same model with angles that go on counting


TURN = 2 * np.pi
TURNING = np.array([[1, 1, 0], [0, 1, 0], [0, 0.5, 1.0]])  # heading, its rate, and what the rate does to a third


def difference(a, b):
    return np.concatenate([wrap(a[..., :1] - b[..., :1], TURN), a[..., 1:] - b[..., 1:]], axis=-1)


def turning(jacobians=True, q=1e-4):
    H = np.eye(3)[:2]
    counting = LinearModel(TURNING, H, q * np.eye(3), 0.01 * np.eye(2))

    def f(x):
        moved = x @ TURNING.T
        return np.concatenate([wrap(moved[..., :1], TURN), moved[..., 1:]], axis=-1)

    slopes = dict(F_jacobian=lambda x: TURNING, H_jacobian=lambda x: H) if jacobians else {}
    how = dict(residual=difference, state_residual=difference)
    return counting, NonlinearModel(f, lambda x: x @ H.T, counting.Q, counting.R, **how, **slopes)


def turns():
    counting, _ = turning()
    start = Gaussian([0, 0.3, 0], np.diag([0.1, 0.1, 0.1]) ** 2)
    data = simulate(counting, start, 80, runs=4, rng=0)
    assert abs(data.x[..., -1, 0]).min() > TURN
    return start, data.z, np.concatenate([wrap(data.z[..., :1], TURN), data.z[..., 1:]], axis=-1)


@pytest.mark.parametrize("kf", FILTERS)
@pytest.mark.parametrize("jacobians", [True, False])
def test_headings_that_wrap_are_headings_that_go_on(kf, jacobians):
    counting, wrapped = turning(jacobians)
    start, z, folded = turns()
    expected, tolerance = kalman_filter(counting, z, start), 1e-7
    near = dict(nominal=expected.mean) if kf is linearized_kalman_filter else {}  # within half a turn of the truth
    track = kf(wrapped, folded, start, **near)
    np.testing.assert_allclose(difference(track.mean, expected.mean), 0, atol=tolerance)
    close(track.cov, expected.cov, tolerance)
    close(track.nis, expected.nis, 1e-6)
    smooth, other = rts_smoother(wrapped, track), rts_smoother(counting, expected)
    np.testing.assert_allclose(difference(smooth.mean, other.mean), 0, atol=tolerance)
    close(smooth.cov, other.cov, tolerance)


def test_the_linearised_filter_along_a_path_written_in_other_turns():
    counting, wrapped = turning()
    start, z, folded = turns()
    nominal = kalman_filter(counting, z, start).mean
    expected = linearized_kalman_filter(wrapped, folded, start, nominal=nominal)
    track = linearized_kalman_filter(wrapped, folded, start, nominal=nominal + np.array([3 * TURN, 0, 0]))
    close(track.mean, expected.mean)
    np.testing.assert_allclose(difference(track.mean, nominal), 0, atol=1e-7)


@pytest.mark.parametrize("through", [None, unscented(3)])
def test_models_that_mix_headings(through):
    (counting, wrapped), (loose, folding) = turning(), turning(q=1e-2)
    start, z, folded = turns()
    how = {} if through is None else {"through": through}
    for kf, more in ((imm_filter, PAIR), (mmae_filter, {})):
        expected = kf([counting, loose], z, start, **more)
        for models in ([wrapped, folding], [folding, wrapped]):
            chain = {**PAIR, "transition": np.flip(PAIR["transition"])} if models[0] is folding else PAIR
            track = kf(models, folded, start, **(chain if more else {}), **how)
            np.testing.assert_allclose(difference(track.mean, expected.mean), 0, atol=1e-7)
            close(track.cov, expected.cov, 1e-7)
            close(track.log_likelihood, expected.log_likelihood, 1e-7)


def test_a_smaller_model_keeps_its_headings():
    """States 2 and 0 of the whole are the heading and its rate; the third, 1, belongs to the larger model alone."""
    order = [1, 2, 0]  # of the whole: rate, third, heading
    (counting, wrapped), (start, z, folded) = turning(), turns()
    shuffled = np.eye(3)[order]
    small = NonlinearModel(
        lambda x: np.stack([wrap(x[..., 0] + x[..., 1], TURN), x[..., 1]], axis=-1),
        lambda x: x,
        1e-4 * np.eye(2),
        wrapped.R,
        residual=difference,
        state_residual=difference,
    )
    straight = LinearModel(TURNING[:2, :2], np.eye(2), small.Q, small.R)
    large = LinearModel(shuffled @ TURNING @ shuffled.T, counting.H @ shuffled.T, counting.Q, counting.R)
    bent = NonlinearModel(
        lambda x: wrapped.f(x @ shuffled) @ shuffled.T,
        lambda x: wrapped.h(x @ shuffled),
        wrapped.Q,
        wrapped.R,
        residual=difference,
        state_residual=lambda a, b: difference(a @ shuffled, b @ shuffled) @ shuffled.T,
    )
    initial = Gaussian(shuffled @ start.mean, shuffled @ start.cov @ shuffled.T)
    how = dict(**PAIR, states=[[2, 0], [0, 1, 2]])
    expected = imm_filter([straight, large], z, initial, **how)
    track = imm_filter([small, bent], folded, initial, **how)
    np.testing.assert_allclose(difference((track.mean - expected.mean) @ shuffled, np.zeros(3)), 0, atol=1e-6)
    close(track.cov, expected.cov, 1e-6)
