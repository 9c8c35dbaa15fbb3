"""PDA against enumeration and brute force; nearest neighbour and GNN; what they do among false readings."""

import itertools

import numpy as np
import pytest
from scipy.stats import multivariate_normal, poisson

from kflearn import (
    Gaussian,
    ScanTrack,
    correct,
    gnn_filter,
    kalman_filter,
    nearest_filter,
    pair_up,
    pda_filter,
    pda_weights,
    predict,
    random_walk,
    scan_targets,
    with_error,
)
from tests.helpers import as_nonlinear, close, random_belief, random_model
from tests.targets.scenes import PLANE, START, one_target

SENSOR = dict(detection=0.9, clutter=1e-3)


def enumerated(z, S, inside, P_D, P_G, clutter, volume):
    """Probabilities of all explanations of the readings in the gate, from the full joint probability of each.

    An explanation says which of the m readings is the target's, or that none is. False readings: a Poisson number in
    the gate, each uniform there. The target's reading: Gaussian, cut at the gate.
    """
    y = [row for row, good in zip(z, inside, strict=True) if good]
    m, mean = len(y), clutter * volume
    found = [(1 - P_D * P_G) * poisson(mean).pmf(m) * volume**-m]
    for own in y:
        # m - 1 false ones; the target's is at any of the m places of the scan with the same probability 1/m
        density = multivariate_normal(np.zeros(len(S)), S).pdf(own) / P_G
        found.append(P_D * P_G / m * poisson(mean).pmf(m - 1) * density * volume ** -(m - 1))
    return np.array(found) / np.sum(found)


@pytest.mark.parametrize("m", [1, 2, 3])
def test_the_weights_against_enumeration(m):
    rng = np.random.default_rng(m)
    for _ in range(20):
        model, belief = random_model(rng, 3, m), random_belief(rng, 3)
        z = model.H @ belief.mean + 2 * rng.normal(size=(rng.integers(1, 6), m))
        P_D, P_G = rng.uniform(0.3, 1), rng.uniform(0.8, 0.999)
        pairs = pair_up(model, belief, z, gate=P_G)
        clutter = rng.uniform(0.1, 3) / float(pairs.volume)
        found = pda_weights(pairs, P_D, clutter)
        wanted = enumerated(pairs.innovation, pairs.S, pairs.inside, P_D, P_G, clutter, float(pairs.volume))
        close(found[np.append(True, pairs.inside)], wanted, 1e-9)
        assert (found[1:][~pairs.inside] == 0).all()


def test_the_weights_by_counting():
    """Of many scans that look alike (one reading near 2σ, one near 0.5σ, no other), how often is which the target's?"""
    rng, runs = np.random.default_rng(0), 400000
    model, P_D, clutter = random_walk(0, 1), 0.8, 0.1
    belief = Gaussian(0, 3)
    x = belief.sample(runs, rng)[:, None, None]
    scans = scan_targets(model, x, P_D, clutter, [[-9, 9]], rng)
    z, source = scans.z[:, 0, :, 0], scans.source[:, 0]
    pairs = pair_up(model, belief, scans.z[:, 0], gate=0.99)
    near = pairs.inside & (abs(z - 1) < 0.4)
    far = pairs.inside & (abs(z - 4) < 0.4)
    alike = (pairs.inside.sum(axis=-1) == 2) & near.any(axis=-1) & far.any(axis=-1)
    share = [((source == 0) & rows)[alike].any(axis=-1) for rows in (near, far)]
    assert alike.sum() > 1000
    beta = pda_weights(pair_up(model, belief, [[1.0], [4.0]], gate=0.99), P_D, clutter)
    for which, weight in zip(share, beta[1:], strict=True):
        error = np.sqrt(weight * (1 - weight) / alike.sum())
        assert abs(which.mean() - weight) < 4 * error + 0.005  # the bins have a width


def test_a_step_is_the_mixture_of_its_corrections():
    """The mean and covariance against those of a mixture of ordinary corrections, one for each reading."""
    rng = np.random.default_rng(3)
    model, belief = random_model(rng, 4, 2), random_belief(rng, 4)
    z = 6 * rng.normal(size=(6, 2))
    track = pda_filter(model, z[None], belief, gate=0.9, **SENSOR)
    prior = predict(model, belief)
    beliefs = [prior, *(correct(model, prior, row) for row in z)]
    beta = track.weights[0]
    assert 2 <= (beta > 0).sum() < 7
    mean = sum(w * b.mean for w, b in zip(beta, beliefs, strict=True))
    cov = sum(w * (b.cov + np.outer(b.mean - mean, b.mean - mean)) for w, b in zip(beta, beliefs, strict=True))
    close(track.mean[0], mean, 1e-10)
    close(track.cov[0], cov, 1e-10)
    close(track.predicted.cov[0], prior.cov, 1e-12)


@pytest.mark.parametrize("run", [nearest_filter, lambda *a, **k: pda_filter(*a, **SENSOR, **k)])
def test_all_runs_at_once_are_each_run_alone(run):
    _, scans = one_target(4, steps=12)
    together = run(PLANE, scans.z, START)
    assert isinstance(together, ScanTrack)
    for i, z in enumerate(scans.z):
        alone = run(PLANE, z, START)
        close(together.mean[i], alone.mean, 1e-12)
        close(together.cov[i], alone.cov, 1e-12)
        close(together.weights[i], alone.weights, 1e-12)
    again = run(PLANE, scans.z[:, :, ::-1], START)  # the order in a scan is of no account
    close(again.mean, together.mean, 1e-9)


@pytest.mark.parametrize("run", [nearest_filter, lambda *a, **k: pda_filter(*a, detection=1.0, clutter=1e-12, **k)])
def test_without_false_readings_it_is_the_kalman_filter(run):
    _, scans = one_target(5, detection=0.8, clutter=0.0)
    wanted = kalman_filter(PLANE, scans.of(0), START)
    track = run(PLANE, scans.z, START, gate=1 - 1e-12)
    close(track.mean, wanted.mean, 1e-6)
    close(track.cov, wanted.cov, 1e-6)


def test_nearest_takes_the_nearest():
    _, scans = one_target(10, clutter=3e-3)
    track = nearest_filter(PLANE, scans.z, START, gate=0.9)
    nis = np.where(track.nis <= 2 * np.log(10), track.nis, np.inf)  # chi-square with 2 degrees of freedom
    np.testing.assert_array_equal(track.used, np.where(np.isinf(nis).all(axis=-1), -1, nis.argmin(axis=-1)))
    stays = track.used == -1
    assert stays.any()
    close(track.mean[stays], track.predicted.mean[stays], 1e-12)
    close(track.cov[stays], track.predicted.cov[stays], 1e-12)


def likeliest(pairs, P_D, P_G, clutter):
    """The most probable joint explanation of a scan, of all there are."""
    M, N = pairs.nis.shape
    best, chosen = -np.inf, None
    for choice in itertools.product(range(-1, N), repeat=M):
        given = [j for j in choice if j >= 0]
        if len(given) > len(set(given)) or not all(pairs.inside[i, j] for i, j in enumerate(choice) if j >= 0):
            continue
        total = clutter ** (N - len(given))
        for i, j in enumerate(choice):
            S = pairs.S[i]
            own = multivariate_normal(np.zeros(len(S)), S).pdf(pairs.innovation[i, j]) if j >= 0 else None
            total *= (1 - P_D * P_G) if j < 0 else P_D * own
        best, chosen = (total, choice) if total > best else (best, chosen)
    return list(chosen)


def test_gnn_is_the_most_probable_explanation_of_each_scan():
    rng = np.random.default_rng(4)
    start = Gaussian([[0, 0, 0, 0], [4, 0, 3, 0], [-3, 0, 5, 0]], START.cov)
    differs = 0
    for _ in range(30):
        z = rng.normal(0, 8, (1, 4, 2))
        track = gnn_filter(PLANE, z, start, gate=0.95, **SENSOR)
        pairs = pair_up(PLANE, predict(PLANE, start), z[0], gate=0.95)
        assert track.used[:, 0].tolist() == likeliest(pairs, 0.9, 0.95, 1e-3)
        greedy = gnn_filter(PLANE, z, start, gate=0.95, how="greedy", **SENSOR)
        differs += (greedy.used != track.used).any()
    assert differs > 0


def test_gnn_shapes_and_runs():
    _, scans = one_target(3, steps=8)
    start = Gaussian([[0, 3, 0, 1], [30, 0, 30, 0]], START.cov)
    track = gnn_filter(PLANE, scans.z, start, **SENSOR)
    assert track.mean.shape == (3, 2, 8, 4)
    assert track.weights.shape == (3, 2, 8, scans.z.shape[2] + 1)
    alone = gnn_filter(PLANE, scans.z[1], start, **SENSOR)
    close(alone.mean, track.mean[1], 1e-12)
    used = track.used
    assert not ((used[:, 0] == used[:, 1]) & (used[:, 0] >= 0)).any()


def test_a_nonlinear_model_that_is_linear():
    _, scans = one_target(3, steps=8)
    for run in (nearest_filter, lambda *a: pda_filter(*a, **SENSOR)):
        close(run(as_nonlinear(PLANE), scans.z, START).mean, run(PLANE, scans.z, START).mean, 1e-9)


def test_among_false_readings():
    """PDA is better than the nearest neighbour, by many standard errors; not as good as knowing whose reading it is."""
    x, scans = one_target(200, steps=40, detection=0.9, clutter=2e-3)
    tracks = {
        "known": kalman_filter(PLANE, scans.of(0), START),
        "pda": pda_filter(PLANE, scans.z, START, detection=0.9, clutter=2e-3),
        "nearest": nearest_filter(PLANE, scans.z, START),
    }
    lost = {n: (abs(t.mean - x)[:, -1, [0, 2]] > 20).any(axis=-1).astype(float) for n, t in tracks.items()}
    assert lost["known"].mean() == 0
    gain = with_error(lost["nearest"], minus=lost["pda"])
    assert gain.value > 4 * gain.error > 0
    assert lost["pda"].mean() > 0


def test_pda_is_honest_with_a_lost_target_left_out():
    """The claimed covariance of PDA: mean NEES of the runs that kept the target is near 4."""
    x, scans = one_target(400, steps=20, clutter=5e-4)
    track = pda_filter(PLANE, scans.z, START, detection=0.9, clutter=5e-4)
    error = x - track.mean
    nees = np.einsum("...i,...ij,...j", error, np.linalg.inv(track.cov), error)[:, -1]
    assert 3.2 < np.median(nees) * 4 / 3.357 < 4.8  # the median of chi-square with 4 degrees of freedom is 3.357


@pytest.mark.parametrize(
    "changed, words",
    [
        (dict(z=np.zeros((5, 2))), r"z must have shape \(any, any, 2\)"),
        (dict(detection=0), "detection must be a probability above 0"),
        (dict(clutter=0), "clutter must be positive"),
        (dict(gate=1), "gate must be a probability"),
        (dict(initial=Gaussian(0, 1)), "initial must have 4 components"),
        (dict(z=[[[1.0, np.nan]]]), "whole readings"),
    ],
)
def test_bad_input(changed, words):
    good = dict(model=PLANE, z=np.zeros((3, 2, 2)), initial=START, **SENSOR)
    with pytest.raises(ValueError, match=words):
        pda_filter(**(good | changed))


def test_bad_gnn():
    with pytest.raises(ValueError, match="initial must have an axis for the targets"):
        gnn_filter(PLANE, np.zeros((3, 2, 2)), START, **SENSOR)
    with pytest.raises(ValueError, match="how must be one of 'global', 'greedy'"):
        gnn_filter(PLANE, np.zeros((3, 2, 2)), Gaussian(np.zeros((1, 4)), START.cov), how="best", **SENSOR)
    with pytest.raises(TypeError, match="pairs must come from pair_up"):
        pda_weights([1.0], 0.9, 0.1)


def test_inputs_u():
    model = PLANE.replace(B=np.ones((4, 1)))
    u = np.arange(3.0)[:, None]
    z = np.full((3, 1, 2), np.nan)
    wanted = kalman_filter(model, z[:, 0], START, u)
    close(pda_filter(model, z, START, u, **SENSOR).mean, wanted.mean, 1e-12)
    start = Gaussian(np.stack([START.mean, START.mean]), START.cov)
    found = gnn_filter(model, z, start, u, **SENSOR)
    close(found.mean[1], wanted.mean, 1e-12)


def test_a_model_that_changes_with_time():
    rng = np.random.default_rng(6)
    model, start = random_model(rng, 3, 2, steps=9), random_belief(rng, 3)
    z = rng.normal(size=(9, 2))
    z[4] = np.nan
    wanted = kalman_filter(model, z, start)
    for run in (nearest_filter, lambda *a, **k: pda_filter(*a, detection=1.0, clutter=1e-14, **k)):
        track = run(model, z[:, None], start, gate=1 - 1e-12)
        close(track.mean, wanted.mean, 1e-6)
        close(track.cov, wanted.cov, 1e-6)


@pytest.mark.parametrize("unit", [1e-3, 1e3])
def test_units_do_not_matter(unit):
    """In other units of length λ has another value, and nothing else changes."""
    _, scans = one_target(3, steps=10)
    other = PLANE.replace(Q=unit**2 * PLANE.Q, R=unit**2 * PLANE.R)
    start = Gaussian(unit * START.mean, unit**2 * START.cov)
    here = pda_filter(PLANE, scans.z, START, detection=0.9, clutter=1e-3)
    there = pda_filter(other, unit * scans.z, start, detection=0.9, clutter=1e-3 / unit**2)
    close(there.weights, here.weights, 1e-9)
    close(there.mean / unit, here.mean, 1e-9)
    both = [Gaussian(np.stack([s.mean, s.mean + 5 * u]), s.cov) for s, u in ((START, 1), (start, unit))]
    one = gnn_filter(PLANE, scans.z, both[0], detection=0.9, clutter=1e-3)
    two = gnn_filter(other, unit * scans.z, both[1], detection=0.9, clutter=1e-3 / unit**2)
    np.testing.assert_array_equal(one.used, two.used)
