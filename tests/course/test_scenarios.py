"""Every system: it simulates, its filter runs, and the figures of many runs are the published ones."""

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    NonlinearModel,
    chi_square_interval,
    extended_kalman_filter,
    kalman_filter,
    nees,
    nis,
    random_walk,
    rmse,
    scenarios,
    start_from,
)

# name: the variants of each function that makes a Scenario
SCENES = {
    "cart": [{}],
    "voltmeter": [{"variant": v} for v in ("published", "random walk", "constant")] + [{"steps": 7, "Q": 1, "R": 9}],
    "temperature": [{"variant": v} for v in ("published", "honest start")],
    "free_fall": [{"variant": v} for v in ("published", "physical")],
    "train": [{}, {"start_speed_variance": 25}],
    "ship": [{"variant": v} for v in ("published", "honest start")],
    "scalar_growth": [{"variant": v} for v in ("published", "corrected")] + [{"coefficient": 25, "steps": 7}],
    "range_only": [{"variant": "published"}, {"variant": "honest start", "position_sd": 30}],
    "bearings_only": [{"variant": v} for v in ("published", "honest start", "crossing")],
    "range_and_bearing": [{"variant": v} for v in ("published", "honest start")],
    "homing_missile": [{}],
    "ball": [{"variant": v} for v in ("published", "honest start")],
    "inertial_navigation": [{"variant": v} for v in ("turning", "straight")],
    "manoeuvring": [{}],
    "biased_sensor": [{}],
    "unknown_noise": [{"variant": v} for v in ("constant", "changing", "as promised")],
    "bearing": [{"variant": v} for v in ("calm", "typical", "reflections", "switching", "crossing", "hard")],
}
CASES = [(name, settings) for name, variants in SCENES.items() for settings in variants]
every_scene = pytest.mark.parametrize(
    ("name", "settings"), CASES, ids=[" ".join(map(str, [n, *s.values()])) for n, s in CASES]
)


def run_filter(scene, z, u=None):
    kf = extended_kalman_filter if isinstance(scene.model, NonlinearModel) else kalman_filter
    return kf(scene.model, z, scene.initial, scene.u if u is None else u)


def test_no_scenario_is_forgotten():
    functions = [name for name in scenarios.__all__ if name[0].islower()]
    assert sorted(functions) == sorted(SCENES)


@every_scene
def test_it_simulates_and_its_filter_runs(name, settings):
    scene = getattr(scenarios, name)(**settings)
    T, n, m = scene.steps, scene.model.n, scene.model.m
    one, many, again = scene.simulate(rng=3), scene.simulate(runs=4, rng=3), scene.simulate(runs=4, rng=3)
    assert one.x.shape == (T, n)
    assert one.z.shape == (T, m)
    assert many.x.shape == (4, T, n)
    assert many.z.shape == (4, T, m)
    assert many.u is scene.u or name == "inertial_navigation"  # there each run has its own
    np.testing.assert_array_equal(many.z, again.z)
    np.testing.assert_array_equal(many.x, again.x)
    assert (scene.simulate(runs=4, rng=4).z != many.z).any()
    assert scene.description.endswith(".")
    track = run_filter(scene, many.z, many.u)
    assert track.mean.shape == (4, T, n)
    assert np.isfinite(track.mean).all()
    assert np.isfinite(track.log_likelihood).all()
    assert (track.std > 0).any()
    alone = run_filter(scene, one.z, one.u)
    np.testing.assert_allclose(run_filter(scene, one.z[None], one.u).mean[0], alone.mean)


def per_run(estimate, truth):
    """Rms of each run: mean and standard deviation over the runs."""
    each = rmse(estimate, truth, axis=-2)
    return each.mean(axis=0), each.std(axis=0)


def within(found, published, spread, runs=1000, published_runs=300):
    """Two means over runs, each run with this spread, agree: they differ by less than two standard deviations."""
    assert abs(found - published) < 2 * spread * np.sqrt(1 / runs + 1 / published_runs)


def pooled(error):
    return np.sqrt(np.mean(error**2))


@pytest.mark.parametrize(
    ("variant", "filtered", "best"), [("published", 1.62, 1.41), ("random walk", 1.5715, None)], ids=["white", "walk"]
)
def test_voltmeter_figures(variant, filtered, best):
    scene = scenarios.voltmeter(variant)
    data = scene.simulate(runs=20_000, rng=0)
    # As published: the filter starts at the first reading. Its figures are those of the steady state.
    track = kalman_filter(scene.model, data.z[:, 1:], start_from(scene.model, data.z[:, 0]))
    error = track.mean - data.x[:, 1:]
    noise = 4 * filtered / np.sqrt(2 * error[:, 6:].size / 4)  # successive errors are related
    assert abs(pooled(data.z - data.x) - 2.00) < 0.01
    assert abs(pooled(error[:, 6:]) - filtered) < noise + 0.005
    if best:
        assert abs(pooled(12 + 0.5 * (data.z - 12) - data.x) - best) < 0.01
        # Exactly, from the weights K (1−K)^j that the steady filter gives to past readings:
        K = (np.sqrt(5) - 1) / 2
        exact = np.sqrt(8 * K / (2 - K) + 4 - 8 * K)
        assert abs(pooled(error[:, 6:]) - exact) < noise
    else:
        assert abs(pooled(error[:, 6:]) - np.sqrt(2.472136)) < noise


def test_voltmeter_steady_state():
    scene = scenarios.voltmeter(steps=40)
    track = run_filter(scene, np.zeros(40))
    np.testing.assert_allclose(track.gain[-1], 0.618034, atol=5e-7)
    np.testing.assert_allclose(track.cov[-1], 2.472136, atol=5e-7)
    np.testing.assert_allclose(track.predicted.cov[-1], 6.472136, atol=5e-7)
    np.testing.assert_allclose(track.std[-1], 1.57, atol=0.005)  # what the filter claims


def test_voltmeter_truth_is_what_the_variant_says():
    data = {v: scenarios.voltmeter(v).simulate(runs=5000, rng=1) for v in ("published", "random walk", "constant")}
    for simulation in data.values():
        assert abs(np.std(simulation.z - simulation.x) - 2) < 0.02
        assert abs(simulation.x.mean() - 12) < 0.3
    white, walk = data["published"].x[..., 0], data["random walk"].x[..., 0]
    assert abs(np.std(white) - 2) < 0.02
    assert abs(np.mean((white[:, 1:] - 12) * (white[:, :-1] - 12))) < 0.1
    assert abs(np.std(np.diff(walk)) - 2) < 0.02
    assert np.std(walk[:, -1]) > 8
    assert (data["constant"].x == 12).all()


def test_voltmeter_beliefs_do_not_change_the_truth():
    one, other = scenarios.voltmeter(Q=0.1, R=9), scenarios.voltmeter()
    np.testing.assert_array_equal(one.simulate(3, rng=0).z, other.simulate(3, rng=0).z)
    assert (one.model.Q.item(), one.model.R.item()) == (0.1, 9)


def test_temperature_figures():
    scene = scenarios.temperature()
    data = scene.simulate(runs=1000, rng=0)
    track = run_filter(scene, data.z)
    np.testing.assert_allclose(track.gain[0, -1], 0.1809975, atol=5e-8)
    np.testing.assert_allclose(track.cov[0, -1], 0.0452494, atol=5e-8)
    (z,), (z_spread,) = per_run(data.z, data.x)
    (filtered,), (spread,) = per_run(track.mean, data.x)
    within(z, 0.497, z_spread)
    within(filtered, 0.2115, 0.030)
    assert abs(spread - 0.030) < 0.003


def test_temperature_by_hand():
    # ERRATA 19: the reading was 24.5, and the printed numbers are 23.915 and 0.0186.
    start = kalman_filter(random_walk(0.01, 0.25), [24.5], Gaussian(23.9, 0.01))
    np.testing.assert_allclose(start.predicted.cov.item(), 0.02)
    np.testing.assert_allclose(start.gain.item(), 0.0741, atol=5e-5)
    np.testing.assert_allclose(start.mean.item(), 23.944, atol=5e-4)
    np.testing.assert_allclose(start.cov.item(), 0.0185, atol=5e-5)


def test_free_fall_figures():
    scene = scenarios.free_fall()
    data = scene.simulate(runs=1000, rng=0)
    track = run_filter(scene, data.z)
    np.testing.assert_allclose(track.filtered.variance[0, -1], [3.9975973e-3, 1.2032464e-8], rtol=5e-8)
    np.testing.assert_allclose(track.gain[0, -1, :, 0], [3.9975973e-3, 6.0048016e-6], rtol=5e-8)
    assert abs(pooled(track.mean[..., 0] - data.x[..., 0]) - 0.149) < 0.003
    assert abs(pooled(data.z - data.x[..., :1]) - 0.998) < 0.005
    ignored = run_filter(scene, np.full(scene.steps, np.nan))  # the start is exact and Q = 0: predicting is perfect
    np.testing.assert_allclose(ignored.mean, data.x[0], atol=1e-6)


def test_physical_fall_ends_at_the_ground_and_is_honest():
    scene = scenarios.free_fall("physical")
    data = scene.simulate(runs=4000, rng=0)
    t = 0.1 * np.arange(1, 46)
    np.testing.assert_allclose(data.x[..., 0].mean(axis=0), 95 + t - 4.9 * t**2, atol=0.3)
    last, after = (95 + s - 4.9 * s**2 for s in (4.5, 4.6))
    assert last > 0 > after
    low, high = chi_square_interval(2, 4000, 0.999)
    score = nees(run_filter(scene, data.z), data.x).mean(axis=0)
    assert low < score[0] < high
    assert low < score[-1] < high


def test_temperature_with_an_honest_start():
    # ERRATA 20: the published P₀ makes the first ten samples worse.
    honest = scenarios.temperature("honest start")
    data = honest.simulate(runs=4000, rng=0)
    first = {}
    for name, scene in (("published", scenarios.temperature()), ("honest", honest)):
        track = run_filter(scene, data.z)
        start = scene.initial.mean - honest.truth_start.sample(4000, rng=1)  # the first of the ten, variance R
        first[name] = np.sqrt((pooled(start) ** 2 + 9 * rmse(track.mean[:, :9], data.x[:, :9]) ** 2) / 10)
        score = nees(track, data.x)[:, 0].mean()
        low, high = chi_square_interval(1, 4000, 0.999)
        assert (low < score < high) == (name == "honest")
    assert abs(first["published"] - 0.360) < 0.01
    assert abs(first["honest"] - 0.288) < 0.01


@pytest.mark.parametrize(("variance", "position", "speed"), [(1, 0.528, 1.345), (25, 0.337, 0.776)])
def test_train_figures(variance, position, speed):
    scene = scenarios.train(variance)
    data = scene.simulate(runs=1000, rng=0)
    found, spread = per_run(run_filter(scene, data.z).mean, data.x)
    within(found[0], position, spread[0])
    within(found[1], speed, spread[1])
    differences = np.diff(data.z[..., 0]) / 0.1
    assert abs(pooled(differences - 10) - 14.1) < 0.1
    average = np.lib.stride_tricks.sliding_window_view(differences, 5, axis=-1).mean(axis=-1)
    assert abs(pooled(average - 10) - 2.82) < 0.03


def test_train_end_of_the_published_run():
    cov = run_filter(scenarios.train(), np.zeros(100)).cov[-1]
    np.testing.assert_allclose([cov[0, 0], cov[0, 1], cov[1, 1]], [0.0389877, 0.0058173, 0.0011635], atol=5e-8)


def distance(a, b):
    return np.hypot(*np.moveaxis(a - b, -1, 0))


def ship_data(variant):
    scene = scenarios.ship(variant)
    data = scene.simulate(runs=1000, rng=0)
    return scene, data, data.x[..., [0, 2]]


def test_ship_figures():
    scene, data, truth = ship_data("published")
    track = run_filter(scene, data.z)
    np.testing.assert_allclose(track.gain[0, -1, :2, 0], [0.132081, 0.00931622], rtol=1e-3)
    np.testing.assert_allclose(track.filtered.variance[0, -1, :2], [13.2081, 0.141775], rtol=1e-3)
    measured, filtered = distance(data.z, truth).mean(axis=1), distance(track.mean[..., [0, 2]], truth).mean(axis=1)
    within(measured.mean(), 12.46, 0.73)
    within(measured.mean(), 10 * np.sqrt(np.pi / 2), 0.73, published_runs=np.inf)  # the mean of a Rayleigh law
    # The published mean counts the 80th, exact, value as well: the start.
    within(filtered.mean() * 79 / 80, 4.38, 0.80)
    assert abs(measured.std() - 0.73) < 0.08
    assert abs(filtered.std() - 0.80) < 0.08


def test_ship_steady_state():
    scene = scenarios.ship()
    track = kalman_filter(scene.model, np.zeros((1000, 2)), scene.initial)
    np.testing.assert_allclose(track.gain[-1, :2, 0], [0.132081, 0.00931622], rtol=5e-6)
    np.testing.assert_allclose(track.filtered.variance[-1, :2], [13.2081, 0.141775], rtol=5e-6)


def test_ship_with_an_honest_start_is_consistent():
    scene, data, truth = ship_data("honest start")
    track = run_filter(scene, data.z)
    low, high = chi_square_interval(4, 1000, 0.999)
    assert low < nees(track, data.x)[:, 0].mean() < high
    assert low < nees(track, data.x)[:, -1].mean() < high
    low, high = chi_square_interval(2, 79_000, 0.999)
    assert low < nis(track).mean() < high
    # The published 5.21 is the mean over runs of the rms distance, not of the mean distance.
    each = np.sqrt(np.mean(distance(track.mean[..., [0, 2]], truth) ** 2, axis=1))
    within(each.mean(), 5.21, each.std())
    scene, data, truth = ship_data("published")
    assert nees(run_filter(scene, data.z), data.x)[:, 0].mean() < 0.2 * 4  # it claims errors it cannot have
