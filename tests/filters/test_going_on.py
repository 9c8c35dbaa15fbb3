"""Filters that go on where they stopped: two parts of a series are the whole."""

import copy
import pickle

import numpy as np
import pytest

from kflearn import (
    FILTERS,
    Gaussian,
    LinearModel,
    adaptive_kalman_filter,
    constant_velocity,
    imm_filter,
    kalman_filter,
    mmae_filter,
    random_walk,
)
from tests.helpers import as_nonlinear, close, random_belief, random_model, with_gaps

CHAIN = dict(transition=[[0.95, 0.05], [0.1, 0.9]])


def parts(run, z, start, u, cuts):
    """The tracks of consecutive pieces, each of which goes on from the one before."""
    tracks, begin = [], 0
    for end in (*cuts, z.shape[-2]):
        start = run(z[..., begin:end, :], start, None if u is None else u[..., begin:end, :])
        tracks.append(start)
        begin = end
    return tracks


def same(run, z, start, u=None, cuts=(1, 20, 33), names=()):
    whole, tracks = run(z, start, u), parts(run, z, start, u, cuts)
    for name in ("mean", "cov", *names):
        axis = {"mean": -2, "mode_probabilities": -2}.get(name, -3)
        close(np.concatenate([getattr(track, name) for track in tracks], axis), getattr(whole, name), 1e-12)
    close(sum(track.log_likelihood for track in tracks), whole.log_likelihood, 1e-12)


@pytest.mark.parametrize("row", [row for row in FILTERS if not row.several], ids=lambda row: row.name)
def test_a_belief_is_enough_for_most_filters(row):
    rng = np.random.default_rng(0)
    model, start = random_model(rng, 3, 2, 1), random_belief(rng, 3)
    z, u = with_gaps(rng, rng.normal(size=(2, 25, 2))), rng.normal(size=(25, 1))
    whole, first = row.run(model, z, start, u), row.run(model, z[:, :11], start, u[:11])
    second = row.run(model, z[:, 11:], first[-1], u[11:])
    close(second.mean, whole.mean[:, 11:], 1e-12)
    close(second.cov, whole.cov[:, 11:], 1e-12)


@pytest.mark.parametrize("batch", [(), (3,)])
@pytest.mark.parametrize("dressed", [False, True])
@pytest.mark.parametrize(("kf", "how"), [(imm_filter, CHAIN), (mmae_filter, {})])
def test_models_go_on_with_their_own_beliefs(kf, how, dressed, batch):
    rng = np.random.default_rng(1)
    models, start = [random_model(rng, 3, 2, 1, fastest=1) for _ in range(2)], random_belief(rng, 3)
    models = [as_nonlinear(models[0]), models[1]] if dressed else models
    z, u = with_gaps(rng, rng.normal(size=(*batch, 40, 2))), rng.normal(size=(40, 1))

    def run(z, initial, u):
        first = {"mode_probabilities": [0.3, 0.7]} if isinstance(initial, Gaussian) else {}
        return kf(models, z, initial, u, **how, **first)

    same(run, z, start, u, names=["mode_probabilities"])


def test_the_user_who_has_the_second_half_later():
    z = np.concatenate([np.arange(50.0), 49 + 0.5 * np.arange(1, 51) ** 2]) + np.random.default_rng(0).normal(size=100)
    models, start = [constant_velocity(1, 0.1, 1), constant_velocity(1, 3, 1)], Gaussian([0, 1], 10 * np.eye(2))
    whole, one = imm_filter(models, z, start, **CHAIN), imm_filter(models, z[:52], start, **CHAIN)
    for first in (one, copy.deepcopy(one), pickle.loads(pickle.dumps(one))):
        two = imm_filter(models, z[52:], initial=first, **CHAIN)
        close(two.mean, whole.mean[52:], 1e-12)
        close(two.mode_probabilities, whole.mode_probabilities[52:], 1e-12)
    many = imm_filter(models, np.stack([z[52:]] * 3)[..., None], one, **CHAIN)  # one past, three futures
    close(many.mean, np.stack([two.mean] * 3), 1e-12)


def test_models_of_fewer_states_go_on():
    rng = np.random.default_rng(2)
    models, states = [random_model(rng, 2, 1), random_model(rng, 3, 1)], [[0, 1], [0, 1, 2]]
    start = Gaussian([0.3, 1, 0], np.eye(3))
    same(lambda z, first, u: imm_filter(models, z, first, **CHAIN, states=states), rng.normal(size=(40, 1)), start)


def test_a_weight_too_small_for_a_float_is_carried_on():
    quiet, loud = random_walk(1e-6, 0.01), random_walk(1e-6, 100.0)
    rng = np.random.default_rng(0)
    z = np.concatenate([rng.normal(0, 0.1, 400), rng.normal(0, 10.0, 200)])[:, None]
    first = mmae_filter([quiet, loud], z[:400], Gaussian(0, 1))
    assert first.mode_probabilities[-1, 1] < 1e-300
    assert mmae_filter([quiet, loud], z[400:], first).mode_probabilities[-1, 1] > 0.999


@pytest.mark.parametrize("window", [4, 15, 30, 1000])
@pytest.mark.parametrize("adapt", ["R", "Q"])
@pytest.mark.parametrize("batch", [(), (3,)])
def test_the_adaptive_filter_goes_on_with_its_window(batch, adapt, window):
    rng = np.random.default_rng(3)
    model, start, z = random_model(rng, 2, 2), random_belief(rng, 2), 4 * rng.normal(size=(*batch, 60, 2))
    z = with_gaps(rng, z, 0.1)

    def run(z, initial, u):
        return adaptive_kalman_filter(model, z, initial, window=window, adapt=adapt)

    same(run, z, start, cuts=(1, 20, 25, 50), names=["R", "Q"])
    whole, first = run(z, start, None), pickle.loads(pickle.dumps(run(z[..., :20, :], start, None)))
    close(run(z[..., 20:, :], first, None).R, whole.R[..., 20:, :, :], 1e-12)
    moved = (whole.R if adapt == "R" else whole.Q) != (model.R if adapt == "R" else model.Q)
    assert moved.any() == (window < 60)


def test_a_window_that_has_grown_is_filled_first():
    model, z = random_walk(1, 1), np.random.default_rng(4).normal(size=60) * 5
    first = adaptive_kalman_filter(model, z, Gaussian(0, 1), window=5)
    second = adaptive_kalman_filter(model, z, first, window=20)
    np.testing.assert_array_equal(second.R[:14], 1)
    assert (second.R[14:] != 1).all()


def test_what_does_not_go_on_is_named():
    models, z, start = [random_walk(1, 1), random_walk(2, 1)], [1.0, 2.0], Gaussian(0, 1)
    track = imm_filter(models, z, start, **CHAIN)
    for kf, how in ((imm_filter, CHAIN), (mmae_filter, {})):
        with pytest.raises(ValueError, match="mode_probabilities must be left out where initial is a track"):
            kf(models, z, track, **how, mode_probabilities=[0.5, 0.5])
        with pytest.raises(TypeError, match="initial must be a Gaussian, got Track"):
            kf(models, z, kalman_filter(models[0], z, start), **how)
    with pytest.raises(ValueError, match="initial must be a track of as many models as are given, 3, got one of 2"):
        mmae_filter([*models, models[0]], z, track)
    with pytest.raises(TypeError, match="initial must be a Gaussian, got MultipleModelTrack"):
        adaptive_kalman_filter(models[0], z, track)
    with pytest.raises(ValueError, match="initial must have 1 components like the model, got 2"):
        wide = Gaussian([0, 0], np.eye(2))
        adaptive_kalman_filter(models[0], z, adaptive_kalman_filter(constant_velocity(1, 1, 1), z, wide))
    two = LinearModel(1, [[1], [2]], 1, np.eye(2))
    with pytest.raises(ValueError, match="initial must be a track of 1 measured components like the model, got 2"):
        adaptive_kalman_filter(models[0], z, adaptive_kalman_filter(two, [z], start))


def test_all_models_are_equally_probable_when_nothing_is_said():
    models, z, start = [random_walk(1, 1), random_walk(2, 1)], [1.0, 2.0], Gaussian(0, 1)
    found = imm_filter(models, z, start, **CHAIN)
    told = imm_filter(models, z, start, **CHAIN, mode_probabilities=[0.5, 0.5])
    np.testing.assert_array_equal(found.mode_probabilities, told.mode_probabilities)
