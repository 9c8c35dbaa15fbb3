"""Adaptive and consider filters: the published runs, the figures over many, and what they must not do."""

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    LinearModel,
    adaptive_kalman_filter,
    constant_velocity,
    kalman_filter,
    nees,
    random_walk,
    rmse,
    rts_smoother,
    scenarios,
    schmidt_kalman_filter,
    simulate,
)
from tests.filters.test_reference import read
from tests.helpers import as_nonlinear, close, random_belief, random_model, same_track, with_gaps


def stacked(table, names):
    return np.stack([table[name] for name in names.split()], axis=-1)


def test_published_adaptive_run():
    table, scene = read("adaptive_iae"), scenarios.unknown_noise()
    track = adaptive_kalman_filter(scene.model, table["z"], scene.initial)
    np.testing.assert_allclose(track.mean, stacked(table, "x v"), rtol=1e-7, atol=1e-7)
    np.testing.assert_allclose(track.filtered.variance, stacked(table, "P11 P22"), rtol=1e-7)
    np.testing.assert_allclose(track.R[:, 0, 0], table["R_hat"], rtol=1e-7)
    np.testing.assert_allclose(track.gain[..., 0], stacked(table, "K1 K2"), rtol=1e-7)
    fixed = kalman_filter(scene.model, table["z"], scene.initial)
    np.testing.assert_allclose(fixed.mean, stacked(table, "x_fixed v_fixed"), rtol=1e-7, atol=1e-7)


def test_adaptive_figures():
    """After 10 s: mean R̂ 4.005 ± .32, position .5227, with the wrong R .5615, with the true one .5185."""
    scene = scenarios.unknown_noise()
    data = scene.simulate(runs=1000, rng=0)
    adaptive = adaptive_kalman_filter(scene.model, data.z, scene.initial)
    learnt = adaptive.R[:, 100:, 0, 0].mean(axis=1)
    assert abs(learnt.mean() - 4.005) < 2 * 0.32 * np.sqrt(1 / 1000 + 1 / 300)
    assert abs(learnt.std() - 0.32) < 0.03
    tracks = adaptive, *(kalman_filter(scene.model.replace(R=R), data.z, scene.initial) for R in (1.0, 4.0))
    for track, published in zip(tracks, (0.5227, 0.5615, 0.5185), strict=True):
        each = rmse(track.mean[:, 100:, 0], data.x[:, 100:, 0], axis=-1)
        assert abs(each.mean() - published) < 2 * each.std() * np.sqrt(1 / 1000 + 1 / 300)


def test_it_follows_a_sensor_that_changes():
    scene = scenarios.unknown_noise("changing")
    data = scene.simulate(runs=300, rng=1)
    track = adaptive_kalman_filter(scene.model, data.z, scene.initial)
    R = track.R[..., 0, 0].mean(axis=0)
    assert abs(R[100:150].mean() - 1) < 0.15
    assert abs(R[190:245].mean() - 16) < 2
    assert abs(R[300:].mean() - 1) < 0.15
    fixed = kalman_filter(scene.model, data.z, scene.initial)
    during = slice(160, 250)
    assert rmse(track.mean[:, during], data.x[:, during]) < 0.8 * rmse(fixed.mean[:, during], data.x[:, during])


def test_until_the_window_is_full_it_is_the_kalman_filter():
    rng = np.random.default_rng(0)
    model, initial = random_model(rng, 3, 2, 1), random_belief(rng, 3)
    z, u = with_gaps(rng, rng.normal(size=(4, 20, 2))), rng.normal(size=(20, 1))
    plain = kalman_filter(model, z, initial, u)
    for adapt in ("R", "Q"):
        for form in (model, as_nonlinear(model)):
            same_track(adaptive_kalman_filter(form, z, initial, u, window=21, adapt=adapt), plain)


def test_gaps_do_not_count():
    rng = np.random.default_rng(1)
    model, initial, z = random_walk(0.1, 1.0), Gaussian(0, 1), rng.normal(size=(60, 1))
    z[10:20] = np.nan
    track = adaptive_kalman_filter(model, z, initial, window=15)
    assert (track.R[:24] == 1).all()  # 10 measured before the gap, 5 after it make 15
    assert (track.R[24:] != 1).all()
    expected = np.mean(track.innovation.mean[[*range(10), *range(20, 25)]] ** 2) - track.predicted.cov[24, 0, 0]
    np.testing.assert_allclose(track.R[24, 0, 0], max(expected, 0.01))


def test_a_batch_is_a_loop_over_its_runs():
    rng = np.random.default_rng(2)
    model, initial = random_model(rng, 2, 2), random_belief(rng, 2)
    z = with_gaps(rng, rng.normal(size=(3, 40, 2)), 0.1)
    for adapt in ("R", "Q"):
        track = adaptive_kalman_filter(model, z, initial, window=10, adapt=adapt)
        one = adaptive_kalman_filter(model, z[1], initial, window=10, adapt=adapt)
        close(track.mean[1], one.mean)
        close(track.R[1], one.R)
        close(track.Q[1], one.Q)
        assert track.R.shape == (3, 40, 2, 2)
        assert track.Q.shape == (3, 40, 2, 2)


def test_r_never_falls_below_its_floor_in_any_unit():
    rng = np.random.default_rng(3)
    model = LinearModel(np.eye(2), np.eye(2), np.eye(2), [[1, 0.3], [0.3, 2]])
    z = np.zeros((3, 50, 2)) + rng.normal(size=(50, 2)) * 1e-3  # far quieter than promised
    track = adaptive_kalman_filter(model, z, Gaussian([0, 0], np.eye(2)), window=10, floor=0.05)
    units = np.linalg.inv(np.linalg.cholesky(model.R))
    lowest = np.linalg.eigvalsh(units @ track.R @ units.T)[..., 0]
    assert lowest.min() > 0.05 - 1e-12
    np.testing.assert_allclose(lowest[:, 20:].min(), 0.05)


@pytest.mark.parametrize(("wrong", "better"), [(0.01, 0.6), (100.0, 0.75)])
def test_q_is_learnt_where_it_can_be(wrong, better):
    truth, start = random_walk(1.0, 4.0), Gaussian(0, 1)
    data = simulate(truth, start, 400, runs=300, rng=0)
    model = truth.replace(Q=wrong)
    late = slice(200, None)
    errors = [
        rmse(kf(model, data.z, start).mean[:, late], data.x[:, late])
        for kf in (lambda *a: adaptive_kalman_filter(*a, adapt="Q"), kalman_filter)
    ]
    assert errors[0] < better * errors[1]
    right = adaptive_kalman_filter(truth, data.z, start, adapt="Q")
    ideal = kalman_filter(truth, data.z, start)
    assert rmse(right.mean[:, late], data.x[:, late]) < 1.03 * rmse(ideal.mean[:, late], data.x[:, late])


@pytest.mark.parametrize("scene", [scenarios.train(), scenarios.cart()], ids=["Q = 0", "speed known exactly"])
def test_what_is_known_exactly_does_not_disturb_the_size_of_q(scene):
    # Q = 0 stays 0 whatever its factor is; where the speed is exact P is singular, and only the place has a say.
    z = 50 + np.random.default_rng(4).normal(size=40)
    track = adaptive_kalman_filter(scene.model, z, scene.initial, window=5, adapt="Q")
    assert np.isfinite(track.mean).all()
    if scene.model.Q.any():
        place = random_walk(4.0, 1.0).replace(B=1)
        alone = adaptive_kalman_filter(place, z, Gaussian(50, 1), np.full(40, 10.0), window=5, adapt="Q")
        np.testing.assert_allclose(track.Q[:, 0, 0], alone.Q[:, 0, 0])
        np.testing.assert_allclose(track.mean[:, 0], alone.mean[:, 0])
    else:
        np.testing.assert_allclose(track.mean, kalman_filter(scene.model, z, scene.initial).mean)


def test_an_adaptive_track_is_not_smoothed():
    scene = scenarios.unknown_noise()
    track = adaptive_kalman_filter(scene.model, scene.simulate(rng=0).z, scene.initial)
    with pytest.raises(ValueError, match="adaptive_kalman_filter, which cannot be smoothed; smooth a kalman_filter"):
        rts_smoother(scene.model, track)


def test_steps_measured_in_part_do_not_count():
    rng = np.random.default_rng(11)
    model, initial = LinearModel(np.eye(2), np.eye(2), 0.1 * np.eye(2), np.eye(2)), Gaussian([0, 0], np.eye(2))
    z = rng.normal(size=(40, 2))
    z[5:15, 0], z[20, 1] = np.nan, np.nan
    track = adaptive_kalman_filter(model, z, initial, window=15)
    # Steps 0 … 4 and 15 … 24 but 20 are complete: 14 of them; step 25 is the fifteenth.
    assert (track.R[:25] == np.eye(2)).all()
    assert (track.R[25] != np.eye(2)).any()
    complete = track.innovation.mean[[*range(5), *range(15, 20), *range(21, 26)]]
    expected = np.mean(complete[:, :, None] * complete[:, None, :], axis=0) - track.predicted.cov[25]
    lowest = np.linalg.eigvalsh(expected)[0]
    assert lowest > 0.01  # the floor has nothing to do with it
    close(track.R[25], expected)


def test_alpha_takes_small_steps_between_its_limits():
    model, initial, floor = random_walk(1.0, 1.0), Gaussian(0, 1), 0.2
    loud = 100.0 * (-1) ** np.arange(120)
    alpha = adaptive_kalman_filter(model, loud, initial, window=5, floor=floor, adapt="Q").Q[:, 0, 0]
    steps = alpha[1:] / alpha[:-1]
    np.testing.assert_allclose(steps.max(), np.exp(0.1))
    np.testing.assert_allclose(alpha.max(), 1 / floor)
    assert alpha[-1] == alpha.max()
    quiet = adaptive_kalman_filter(model, np.zeros(120), initial, window=5, floor=floor, adapt="Q").Q[:, 0, 0]
    steps = quiet[1:] / quiet[:-1]
    assert steps.min() > np.exp(-0.1) - 1e-12
    np.testing.assert_allclose(quiet.min(), floor)
    assert quiet[-1] == quiet.min()


@pytest.mark.parametrize("adapt", ["R", "Q"])
def test_a_window_longer_than_the_series_costs_no_memory(adapt):
    z = np.random.default_rng(5).normal(size=(4, 30, 1))
    model, initial = random_walk(1.0, 1.0), Gaussian(0, 1)
    track = adaptive_kalman_filter(model, z, initial, window=1_000_000, adapt=adapt)
    same_track(track, kalman_filter(model, z, initial))
    with pytest.raises(ValueError, match="window must be at most 1,000,000 steps, got 1,000,000,000"):
        adaptive_kalman_filter(model, z, initial, window=10**9, adapt=adapt)


SCENE = scenarios.biased_sensor()


def four_filters(z):
    """Ignore the bias, inflate R, estimate it, consider it."""
    plain, start = constant_velocity(0.1, 0.2, 0.25), SCENE.initial.marginal([0, 1])
    return (
        kalman_filter(plain, z, start),
        kalman_filter(plain.replace(R=1.25), z, start),
        kalman_filter(SCENE.model, z, SCENE.initial),
        schmidt_kalman_filter(SCENE.model, z, SCENE.initial, considered=[2]),
    )


def test_published_consider_run():
    table = read("schmidt")[1:]
    tracks = four_filters(table["z"])
    names = ("xn vn", "Pn11 Pn22"), ("xi vi", "Pi11 Pi22"), ("xa va ba", "Pa11 Pa22 Pa33"), ("xs vs", "Ps11 Ps22")
    for track, (mean, variance) in zip(tracks, names, strict=True):
        n = len(mean.split())
        np.testing.assert_allclose(track.mean[:, :n], stacked(table, mean), rtol=1e-7, atol=1e-7)
        np.testing.assert_allclose(track.filtered.variance[:, :n], stacked(table, variance), rtol=1e-7)
    considered = tracks[-1]
    np.testing.assert_allclose(considered.cov[:, [0, 1, 2], 2], stacked(table, "U1 U2 W"), rtol=1e-7, atol=1e-9)
    np.testing.assert_allclose(considered.gain[:, :2, 0], stacked(table, "Ks1 Ks2"), rtol=1e-7)
    np.testing.assert_array_equal(considered.gain[:, 2], 0)
    np.testing.assert_array_equal(considered.mean[:, 2], 0)


def test_four_claims_against_four_truths():
    data = SCENE.simulate(runs=300, rng=0)
    published = (1.002, 0.146), (0.946, 0.269), (0.831, 0.817), (0.977, 0.959)
    for track, (error, claim) in zip(four_filters(data.z), published, strict=True):
        each = rmse(track.mean[:, 100:, 0], data.x[:, 100:, 0], axis=-1)
        pooled = np.sqrt(np.mean(each**2))
        assert abs(pooled - error) < 2 * each.std() * np.sqrt(2 / 300)
        assert abs(track.std[0, 100:, 0].mean() - claim) < 0.001
    assert abs(nees(track.filtered.marginal([0, 1]), data.x[..., :2])[:, 100:].mean() - 2) < 0.15


def test_considering_nothing_is_the_kalman_filter_and_everything_is_predicting():
    rng = np.random.default_rng(5)
    model, initial, z = random_model(rng, 3, 2), random_belief(rng, 3), with_gaps(rng, rng.normal(size=(9, 2)))
    same_track(schmidt_kalman_filter(model, z, initial), kalman_filter(model, z, initial))
    deaf = schmidt_kalman_filter(model, z, initial, considered=[0, 1, 2])
    close(deaf.cov, kalman_filter(model, np.full((9, 2), np.nan), initial).cov)
    with pytest.raises(ValueError, match="cannot be smoothed"):
        rts_smoother(model, deaf)


def test_a_state_alone_may_be_considered_too():
    """Nothing is estimated: the prediction stays, whatever is read."""
    model, start = random_walk(2, 9), Gaussian(5, 4)
    track = schmidt_kalman_filter(model, [50.0, -20.0, 7.0], start, considered=[0])
    np.testing.assert_allclose(track.mean[:, 0], 5, rtol=0, atol=1e-12)
    np.testing.assert_allclose(track.cov[:, 0, 0], [6, 8, 10], rtol=1e-12)
    assert not track.gain.any()
