"""Smoothers: both are one least-squares solve, in every variant; the published runs; FilterPy's."""

from functools import partial
from pathlib import Path

import numpy as np
import pytest
from filterpy.kalman import KalmanFilter as TheirKalmanFilter
from filterpy.kalman import MerweScaledSigmaPoints, UnscentedKalmanFilter

from kflearn import (
    Gaussian,
    LinearModel,
    chi_square_interval,
    constant_velocity,
    correct,
    cubature_kalman_filter,
    extended_kalman_filter,
    kalman_filter,
    linearized_kalman_filter,
    nees,
    rmse,
    rts_smoother,
    scenarios,
    simulate,
    square_root_kalman_filter,
    two_filter_smoother,
    unscented_kalman_filter,
)
from kflearn.core.matrices import compact
from tests.helpers import as_nonlinear, bent, close, least_squares, random_belief, random_model, with_gaps

NONLINEAR = [extended_kalman_filter, linearized_kalman_filter, unscented_kalman_filter, cubature_kalman_filter]
FOLDER = Path(__file__).parents[1] / "reference"


def rts(model, z, initial, u=None, kf=kalman_filter):
    return rts_smoother(model, kf(model, z, initial, u))


def problem(seed, steps=12):
    """A model with or without control input, fixed or changing, a series with or without gaps, a start."""
    rng = np.random.default_rng(seed)
    n, m, p = rng.integers(1, 5), rng.integers(1, 4), seed % 2
    model = random_model(rng, n, m, p, steps if seed % 3 == 0 else None)
    z, u = 2 * rng.normal(size=(steps, m)), rng.normal(size=(steps, p)) if p else None
    return model, with_gaps(rng, z) if seed % 4 else z, random_belief(rng, n), u


@pytest.mark.parametrize("smoother", [rts, two_filter_smoother, partial(rts, kf=square_root_kalman_filter)])
@pytest.mark.parametrize("seed", range(24))
def test_it_is_one_least_squares_solve(smoother, seed):
    model, z, initial, u = problem(seed, steps=1 + seed)
    smooth, (mean, cov) = smoother(model, z, initial, u), least_squares(model, z, initial, u)
    close(smooth.mean, mean, 1e-10)
    close(smooth.cov, cov, 1e-10)


@pytest.mark.parametrize("kf", NONLINEAR)
@pytest.mark.parametrize("dressed", [False, True])
@pytest.mark.parametrize("seed", range(1, 6))
def test_on_linear_models_all_filters_smooth_alike(kf, dressed, seed):
    model, z, initial, u = problem(seed)
    if dressed and model.F.ndim > 2:
        model = LinearModel(model.F[0], model.H[0], model.Q[0], model.R[0], None if model.B is None else model.B[0])
    expected = rts(model, z, initial, u)
    model = as_nonlinear(model) if dressed else model
    found = rts(model, z, initial, u, kf)
    close(found.mean, expected.mean)
    close(found.cov, expected.cov)


@pytest.mark.parametrize("smoother", [rts, two_filter_smoother])
@pytest.mark.parametrize("gaps", ["none", "shared", "each its own"])
def test_a_batch_is_a_loop_over_its_runs(smoother, gaps):
    rng = np.random.default_rng(4)
    model, initial, u = random_model(rng, 3, 2, 1), random_belief(rng, 3), rng.normal(size=(9, 1))
    z = rng.normal(size=(2, 4, 9, 2))
    if gaps != "none":
        z = z + with_gaps(rng, np.zeros(z.shape if gaps == "each its own" else (9, 2)))
    smooth = smoother(model, z, initial, u)
    assert smooth.mean.shape == (2, 4, 9, 3)
    assert smooth.cov.shape == (2, 4, 9, 3, 3)
    assert compact(smooth.cov).shape == ((2, 4, 9, 3, 3) if gaps == "each its own" else (9, 3, 3))
    one = smoother(model, z[1, 2], initial, u)
    close(smooth.mean[1, 2], one.mean)
    close(smooth.cov[1, 2], one.cov)


@pytest.mark.parametrize("smoother", [rts, two_filter_smoother])
def test_q_and_starts_may_have_batch_axes(smoother):
    rng = np.random.default_rng(5)
    model, z = constant_velocity(0.5, 1.0, 2.0), rng.normal(size=(7, 1))
    Qs, starts = [0.1 * model.Q, model.Q, 9 * model.Q], [Gaussian([k, 0], np.eye(2) * (k + 1)) for k in range(3)]
    grid = model.replace(Q=np.stack(Qs)[:, None])
    start = Gaussian(np.stack([s.mean for s in starts]), np.stack([s.cov for s in starts]))
    smooth = smoother(grid, z, start)
    for k in range(3):
        one = smoother(model.replace(Q=Qs[k]), z, starts[k])
        close(smooth.mean[k], one.mean)
        close(smooth.cov[k], one.cov)


@pytest.mark.parametrize("kf", NONLINEAR)
def test_a_nonlinear_batch_is_a_loop_and_ends_at_the_filter(kf):
    rng = np.random.default_rng(6)
    model, initial = bent(random_model(rng, 3, 2, 1)), random_belief(rng, 3)
    z, u = with_gaps(rng, rng.normal(size=(4, 9, 2))), rng.normal(size=(9, 1))
    track = kf(model, z, initial, u)
    smooth = rts_smoother(model, track)
    one = rts(model, z[2], initial, u, kf)
    close(smooth.mean[2], one.mean)
    close(smooth.cov[2], one.cov)
    close(smooth.mean[:, -1], track.mean[:, -1])
    close(smooth.cov[:, -1], track.cov[:, -1])
    assert (np.linalg.eigvalsh(smooth.cov) > 0).all()
    Gaussian(smooth.mean, smooth.cov)


def test_what_is_known_exactly_stays_so():
    # Q = 0 and a start without any doubt about the position: the predicted covariances are singular.
    model = LinearModel(F=[[1, 0], [0, 1]], H=[[1, 1]], Q=np.diag([0, 0.1]), R=1)
    initial = Gaussian([3, 0], np.diag([0, 1.0]))
    z = np.random.default_rng(0).normal(3, 1, size=(20, 1))
    one, other = rts(model, z, initial), two_filter_smoother(model, z, initial)
    for smooth in (one, other):
        np.testing.assert_allclose(smooth.mean[:, 0], 3)
        np.testing.assert_allclose(smooth.cov[:, 0], 0, atol=1e-15)
    # The other state alone is an ordinary problem.
    alone = rts(LinearModel(F=1, H=1, Q=0.1, R=1), z - 3, Gaussian(0, 1))
    for smooth in (one, other):
        close(smooth.mean[:, 1:], alone.mean)
        close(smooth.cov[:, 1:, 1:], alone.cov)


def test_results_are_read_only_and_the_track_is_not_changed():
    scene = scenarios.train()
    track = kalman_filter(scene.model, scene.simulate(rng=0).z, scene.initial)
    before = track.mean.copy(), track.cov.copy()
    smooth = rts_smoother(scene.model, track)
    np.testing.assert_array_equal(track.mean, before[0])
    np.testing.assert_array_equal(track.cov, before[1])
    with pytest.raises(ValueError, match="read-only"):
        smooth.mean[0] = 1


@pytest.mark.parametrize(
    ("name", "acceleration", "variance"), [("no_process_noise", 0.0, 1.0), ("white_acceleration", 2.0, 25.0)]
)
def test_published_runs(name, acceleration, variance):
    table = np.genfromtxt(FOLDER / f"smoothing_{name}.csv", delimiter=",", names=True)
    # The first row is the smoothed start: give the start a step of its own, in which nothing moves or is measured.
    train = constant_velocity(0.1, acceleration, 1.0)
    T = len(table)
    F, Q = np.stack([np.eye(2)] + [train.F] * (T - 1)), np.stack([0 * train.Q] + [train.Q] * (T - 1))
    model = LinearModel(F, train.H, Q, train.R)
    initial = Gaussian([0, 5], np.diag([1, variance]))
    track = kalman_filter(model, table["z"], initial)

    def agree(belief, mean, cov, rows=slice(None)):
        expected = np.stack([table[f"P{cov}{ij}"] for ij in ("11", "12", "22")], axis=-1)[rows]
        np.testing.assert_allclose(
            belief.mean, np.stack([table[f"x{mean}"], table[f"v{mean}"]], -1)[rows], rtol=1e-9, atol=1e-9
        )
        np.testing.assert_allclose(belief.cov[:, [0, 0, 1], [0, 1, 1]], expected, rtol=1e-9, atol=1e-9)

    agree(track, "f", "f")
    agree(rts_smoother(model, track), "s_rts", "s")
    agree(two_filter_smoother(model, table["z"], initial), "s_fb", "fb")
    # ERRATA 50, both filters have used z_k when they are fused: as if the smoother were corrected by z_k once more.
    smooth = rts_smoother(model, track)
    twice = [correct(train, Gaussian(smooth.mean[k], smooth.cov[k]), table["z"][k]) for k in range(1, T)]
    agree(Gaussian(np.stack([b.mean for b in twice]), np.stack([b.cov for b in twice])), "s_dbl", "dbl", slice(1, T))


def test_errata_50_in_figures():
    table = np.genfromtxt(FOLDER / "smoothing_white_acceleration.csv", delimiter=",", names=True)[1:]
    assert abs(rmse(table["xs_dbl"], table["x_true"]) - 0.2328) < 5e-5
    assert abs(rmse(table["xs_rts"], table["x_true"]) - 0.2212) < 5e-5
    np.testing.assert_allclose(table["Pdbl11"][45:55] / table["Ps11"][45:55], 1 - 0.048, atol=5e-4)


def test_published_figures():
    model, initial = constant_velocity(0.1, 2.0, 1.0), Gaussian([0, 5], np.diag([1.0, 25.0]))
    data = simulate(model, np.array([0.0, 10.0]), 100, runs=2000, rng=0)
    track = kalman_filter(model, data.z, initial)
    for belief, published in ((track, 0.443), (rts_smoother(model, track), 0.226)):
        each = rmse(belief.mean[..., 0], data.x[..., 0], axis=-1)
        assert abs(each.mean() - published) < 2 * each.std() * np.sqrt(1 / 2000 + 1 / 300)


def test_an_honest_smoother_knows_how_good_it_is():
    model, initial = constant_velocity(0.1, 2.0, 1.0), Gaussian([0, 5], np.diag([1.0, 25.0]))
    data = simulate(model, initial, 60, runs=4000, rng=1)
    low, high = chi_square_interval(2, 4000, 0.9999)
    for k, score in enumerate(nees(rts(model, data.z, initial), data.x).mean(axis=0)):
        assert low < score < high, f"step {k}"


@pytest.mark.parametrize("seed", range(10))
def test_filterpy_smooths_alike(seed):
    rng = np.random.default_rng(seed)
    n, m = rng.integers(1, 5), rng.integers(1, 4)
    model, initial = random_model(rng, n, m), random_belief(rng, n)
    z = rng.normal(size=(15, m))
    kf = TheirKalmanFilter(dim_x=n, dim_z=m)
    kf.x, kf.P = initial.mean.copy(), initial.cov.copy()
    kf.F, kf.H, kf.Q, kf.R = model.F, model.H, model.Q, model.R
    means, covs, _, _ = kf.batch_filter(z)
    mean, cov, _, _ = kf.rts_smoother(means, covs)
    smooth = rts(model, z, initial)
    close(smooth.mean, mean, 1e-10)
    close(smooth.cov, cov, 1e-10)


@pytest.mark.parametrize("seed", range(5))
def test_filterpy_unscented_smooths_alike(seed):
    rng = np.random.default_rng(seed)
    model, initial = bent(random_model(rng, 3, 2)), random_belief(rng, 3)
    z = rng.normal(size=(12, 2))
    points = MerweScaledSigmaPoints(3, alpha=0.5, beta=2, kappa=0)
    kf = UnscentedKalmanFilter(3, 2, dt=1, hx=model.h, fx=lambda x, dt: model.f(x), points=points)
    kf.x, kf.P, kf.Q, kf.R = initial.mean.copy(), initial.cov.copy(), model.Q, model.R
    means, covs = kf.batch_filter(z)
    mean, cov, _ = kf.rts_smoother(means, covs)
    smooth = rts(model, z, initial, kf=partial(unscented_kalman_filter, alpha=0.5))
    close(smooth.mean, mean, 1e-9)
    close(smooth.cov, cov, 1e-9)
