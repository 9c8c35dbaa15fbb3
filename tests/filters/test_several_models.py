"""Several models: batches, dimensions, weights, models that nothing leads to."""

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    NonlinearModel,
    constant_velocity,
    extended_kalman_filter,
    imm_filter,
    kalman_filter,
    mmae_filter,
    random_walk,
    scenarios,
    unscented_kalman_filter,
)
from kflearn.filters.moments import unscented
from tests.helpers import as_nonlinear, bent, close, random_belief, random_model, with_gaps

SCENE = scenarios.manoeuvring()
T, R = 2.0, 1e4
WHOLE = np.eye(6)[:, :4]


def bank(rng, M=3):
    models = [random_model(rng, 3, 2, fastest=1.0) for _ in range(M)]
    transition = rng.uniform(0.1, 1, (M, M))
    weights = rng.uniform(0.1, 1, M)
    return models, transition / transition.sum(axis=1, keepdims=True), weights / weights.sum()


@pytest.mark.parametrize("dressed", ["none", "one", "all"])
@pytest.mark.parametrize("gaps", [False, True])
def test_linear_and_nonlinear_models_mix(dressed, gaps):
    rng = np.random.default_rng(7)
    models, transition, weights = bank(rng)
    start, z = random_belief(rng, 3), rng.normal(size=(4, 9, 2))
    z = with_gaps(rng, z) if gaps else z
    chain = dict(transition=transition, mode_probabilities=weights)
    expected = imm_filter(models, z, start, **chain)
    count = {"none": 0, "one": 1, "all": 3}[dressed]
    mixed = [as_nonlinear(m) if j < count else m for j, m in enumerate(models)]
    for how in ({}, {"through": unscented(3)}):
        track = imm_filter(mixed, z, start, **chain, **how)
        close(track.mean, expected.mean)
        close(track.cov, expected.cov)
        close(track.mode_probabilities, expected.mode_probabilities)
        close(track.log_likelihood, expected.log_likelihood)
        close(track.modes.mean, expected.modes.mean)


def test_one_model_is_its_own_filter():
    rng = np.random.default_rng(8)
    model, start, z, u = (
        bent(random_model(rng, 3, 2, 1)),
        random_belief(rng, 3),
        rng.normal(size=(9, 2)),
        np.ones((9, 1)),
    )
    for kf, how in ((extended_kalman_filter, {}), (unscented_kalman_filter, {"through": unscented(3)})):
        alone = kf(model, z, start, u)
        track = imm_filter([model], z, start, u, transition=[[1.0]], mode_probabilities=[1.0], **how)
        close(track.mean, alone.mean)
        close(track.cov, alone.cov)
        close(track.log_likelihood, alone.log_likelihood)
    chain = dict(transition=[[0.9, 0.1], [0.4, 0.6]], mode_probabilities=[0.5, 0.5])
    twins = imm_filter([model, model], z, start, u, **chain)
    close(twins.mean, extended_kalman_filter(model, z, start, u).mean)


@pytest.mark.parametrize("together", [imm_filter, mmae_filter])
def test_a_batch_is_a_loop_over_its_runs(together):
    rng = np.random.default_rng(9)
    models, transition, weights = bank(rng)
    how = dict(transition=transition, mode_probabilities=weights) if together is imm_filter else {}
    starts = Gaussian(rng.normal(size=(3, 3)), np.eye(3))
    z = with_gaps(rng, rng.normal(size=(5, 3, 9, 2)))
    track = together(models, z, starts, **how)
    assert track.mean.shape == (5, 3, 9, 3)
    assert track.cov.shape == (5, 3, 9, 3, 3)
    assert track.mode_probabilities.shape == (5, 3, 9, 3)
    assert track.modes.mean.shape == (5, 3, 9, 3, 3)
    assert track.modes.cov.shape == (5, 3, 9, 3, 3, 3)
    assert track.log_likelihood.shape == (5, 3)
    one = together(models, z[2, 1], Gaussian(starts.mean[1], starts.cov), **how)
    close(track.mean[2, 1], one.mean)
    close(track.cov[2, 1], one.cov)
    close(track.mode_probabilities[2, 1], one.mode_probabilities)
    np.testing.assert_allclose(track.mode_probabilities.sum(axis=-1), 1)


def test_models_of_different_dimension():
    # A model that lacks a state believes it to be 0: the same as one that holds it at 0.
    rng = np.random.default_rng(10)
    small, large = constant_velocity(1.0, 0.3, 1.0), random_model(rng, 3, 1)
    start, z = Gaussian([0, 1, 0.5], np.eye(3)), rng.normal(size=(12, 1))
    E = np.eye(3)[:, :2]
    held = type(large)(E @ small.F @ E.T, small.H @ E.T, E @ small.Q @ E.T, small.R)
    how = dict(transition=[[0.9, 0.1], [0.2, 0.8]], mode_probabilities=[0.5, 0.5])
    expected = imm_filter([held, large], z, start, **how)
    for first in (small, as_nonlinear(small)):
        track = imm_filter([first, large], z, start, **how, states=[[0, 1], [0, 1, 2]])
        close(track.mean, expected.mean)
        close(track.mode_probabilities, expected.mode_probabilities)
    np.testing.assert_array_equal(track.modes.mean[:, 0, 2], 0)
    turned = imm_filter([small, large], z, start, **how, states=[[0, 1], [0, 1, 2]])
    other = dict(transition=[[0.8, 0.2], [0.1, 0.9]], mode_probabilities=[0.5, 0.5])
    permuted = imm_filter([large, small], z, start, **other, states=[[0, 1, 2], [0, 1]])
    close(turned.mean, permuted.mean)


def test_no_weight_ever_dies():
    """E7: after 3,000 readings that speak against it by e^-1000s, a model comes back when the world changes."""
    quiet, loud = random_walk(1e-6, 0.01), random_walk(1e-6, 100.0)
    rng = np.random.default_rng(0)
    z = np.concatenate([rng.normal(0, 0.1, 3000), rng.normal(0, 10.0, 3000)])
    probability = mmae_filter([quiet, loud], z, Gaussian(0, 1)).mode_probabilities
    assert probability[2999, 1] < 1e-300
    assert probability[-1, 1] > 0.999
    chain = dict(transition=[[0.99, 0.01], [0.01, 0.99]], mode_probabilities=[0.5, 0.5])
    moving = imm_filter([quiet, loud], z, Gaussian(0, 1), **chain)
    assert moving.mode_probabilities[2999, 0] > 0.9
    assert moving.mode_probabilities[3010, 1] > 0.99
    chain = dict(transition=np.eye(2), mode_probabilities=[1.0, 0.0])
    sure = imm_filter([quiet, loud], z[:50], Gaussian(0, 1), **chain)
    np.testing.assert_array_equal(sure.mode_probabilities[:, 1], 0)
    assert np.isfinite(sure.mean).all()


def steered_turn(x, u):
    return np.stack([x[..., 0] + x[..., 1] * u[..., 0], np.sin(x[..., 1])], axis=-1)


def steered_slope(x, u):
    rows = (
        [np.ones_like(x[..., 0]), np.broadcast_to(u[..., 0], x[..., 0].shape)],
        [0 * x[..., 0], np.cos(x[..., 1])],
    )
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def test_a_smaller_nonlinear_model_is_pushed_with_its_own_slope():
    """f's slope depends on u: lifted to the whole state it must be the model one writes down for that state."""
    rng = np.random.default_rng(12)
    us, z, start = rng.normal(size=(10, 1)), rng.normal(size=(3, 10, 1)), Gaussian([0.3, 1, 0], np.eye(3))
    large = random_model(rng, 3, 1, 1)
    H, E = np.array([[1.0, 0.5]]), np.eye(3)[:, :2]

    small = NonlinearModel(steered_turn, lambda x: x @ H.T, 0.1 * np.eye(2), 1.0, steered_slope, lambda x: H)
    whole = NonlinearModel(
        lambda x, u: steered_turn(x[..., :2], u) @ E.T,
        lambda x: x[..., :2] @ H.T,
        0.1 * E @ E.T,
        1.0,
        lambda x, u: E @ steered_slope(x[..., :2], u) @ E.T,
        lambda x: H @ E.T,
    )
    how = dict(transition=[[0.9, 0.1], [0.2, 0.8]], mode_probabilities=[0.5, 0.5])
    expected = imm_filter([whole, large], z, start, us, **how)
    for first in (small, small.replace(F_jacobian=None)):
        track = imm_filter([first, large], z, start, us, **how, states=[[0, 1], [0, 1, 2]])
        close(track.mean, expected.mean, 1e-7)
        close(track.cov, expected.cov, 1e-7)
        close(track.mode_probabilities, expected.mode_probabilities, 1e-7)


def test_a_model_that_nothing_leads_to_goes_on_alone():
    rng = np.random.default_rng(13)
    models, _, _ = bank(rng, 2)
    start, z = Gaussian([5, -3, 8], np.eye(3)), rng.normal(size=(2, 9, 2))
    for kf, how in ((imm_filter, dict(transition=np.eye(2))), (mmae_filter, {})):
        track = kf(models, z, start, mode_probabilities=[1, 0], **how)
        for j, model in enumerate(models):
            alone = kalman_filter(model, z, start)
            close(track.modes.mean[..., j, :], alone.mean)
            close(track.modes.cov[..., j, :, :], alone.cov)
        np.testing.assert_array_equal(track.mode_probabilities, np.broadcast_to([1, 0], (2, 9, 2)))


def test_probabilities_sum_to_one_to_nine_digits():
    model, z, start = random_walk(1, 1), [1.0, 2.0], Gaussian(0, 1)
    chain = np.array([[0.9, 0.1], [0.2, 0.8]])

    def run(more, where):
        weights, transition = np.array([0.5, 0.5]), chain.copy()
        (weights if where == "weights" else transition[1])[0] += more
        return imm_filter([model, model], z, start, transition=transition, mode_probabilities=weights)

    for where in ("weights", "chain"):
        run(1e-10, where)
        for more in (1e-8, -1e-8, 1e-3):
            with pytest.raises(ValueError, match="probabilities that sum to 1"):
                run(more, where)


def test_shapes_that_are_not_one_chain_for_all():
    model, z, start = random_walk(1, 1), np.zeros(50), Gaussian(0, 1)
    with pytest.raises(ValueError, match=r"transition must have shape \(2, 2\), got \(50, 2, 2\): one chain"):
        imm_filter([model] * 2, z, start, transition=np.full((50, 2, 2), 0.5), mode_probabilities=[0.5, 0.5])
    with pytest.raises(ValueError, match=r"mode_probabilities must have shape \(2,\), got \(4, 2\)"):
        mmae_filter([model] * 2, z, start, mode_probabilities=np.full((4, 2), 0.5))
