"""Single steps, conveniences and worked numbers; what holds for all models is in test_properties."""

import warnings

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    LinearModel,
    NonlinearModel,
    cart,
    constant_velocity,
    correct,
    cubature_kalman_filter,
    extended_kalman_filter,
    kalman_filter,
    predict,
    random_walk,
    unscented_kalman_filter,
)
from kflearn.core.conditioning import covariance_after
from kflearn.core.matrices import compact
from kflearn.filters.moments import cubature, linearize, unscented
from tests.helpers import bent, close, random_belief, random_model, same_track, textbook, with_gaps

FILTERS = [kalman_filter, extended_kalman_filter, unscented_kalman_filter, cubature_kalman_filter]
every_filter = pytest.mark.parametrize("kf", FILTERS, ids=lambda f: f.__name__)


def test_one_step_of_the_cart_by_hand():
    model = cart(dt=1, mass=1, Q=np.diag([4, 0]), R=1)
    prior = predict(model, Gaussian([50, 10], np.diag([1, 0])))
    np.testing.assert_allclose(prior.mean, [60, 10])
    np.testing.assert_allclose(prior.cov, np.diag([5, 0]))
    after = correct(model, prior, 62)
    np.testing.assert_allclose(after.mean, [185 / 3, 10], rtol=1e-14)
    np.testing.assert_allclose(after.cov, np.diag([5 / 6, 0]), rtol=1e-14)
    pushed = predict(model, Gaussian([50, 10], np.diag([1, 0])), u=2)
    np.testing.assert_allclose(pushed.mean, [61, 12])
    np.testing.assert_allclose(pushed.cov, prior.cov)


@pytest.mark.parametrize("rule", [linearize, unscented(2), cubature(2)], ids=["linearize", "unscented", "cubature"])
def test_one_belief_may_meet_many_inputs_measurements_and_models(rule):
    rng = np.random.default_rng(7)
    model, belief = random_model(rng, 2, 1, p=1), random_belief(rng, 2)
    model = model.replace(**{name: getattr(model, name) * rng.uniform(0.5, 1, (3, 1, 1, 1, 1)) for name in "FHQRB"})
    u, z = rng.normal(size=(4, 1)), rng.normal(size=(4, 1))
    prior = predict(model, belief, u, through=rule)
    after = correct(model, prior, z, through=rule)
    direct = correct(model, belief, z, through=rule)
    assert prior.batch == after.batch == direct.batch == (3, 4)
    for i, j in np.ndindex(3, 4):
        one = LinearModel(*(getattr(model, name)[i, 0, 0] for name in "FHQRB"))
        alone = predict(one, belief, u[j])
        pairs = [(prior, alone), (after, correct(one, alone, z[j])), (direct, correct(one, belief, z[j]))]
        for many, single in pairs:
            close(many.mean[i, j], single.mean)
            close(many.cov[i, j], single.cov)


def steady(model, start):
    track = kalman_filter(model, np.zeros((400, model.m)), Gaussian(np.zeros(model.n), start))
    return track.gain[-1, :, 0], track.cov[-1], track.predicted.cov[-1]


def test_published_steady_gains():
    golden = (np.sqrt(5) - 1) / 2
    gain, after, before = steady(random_walk(4, 4), 4)
    np.testing.assert_allclose([gain[0], after.item(), before.item()], [golden, 4 * golden, 4 + 4 * golden], rtol=1e-12)
    gain, after, _ = steady(random_walk(200, 500), 500)  # the bearing of a sound source
    np.testing.assert_allclose([gain[0], after.item()], [0.463325, 231.6625], atol=5e-5)
    for dt, expected in ((0.1, [0.652975, 0.589088]), (1, [0.821846, 0.422082])):
        angle = LinearModel([[1, dt], [0, 1]], [[1, 0]], 1e-6 * np.eye(2), 1e-6)
        gain, after, _ = steady(angle, 1e-5 * np.eye(2))
        np.testing.assert_allclose(gain, expected, atol=5e-7)
        if dt == 0.1:
            np.testing.assert_allclose(after * 1e7, [[6.530, 5.891], [5.891, 110.85]], rtol=1e-4)


@pytest.mark.parametrize("batch", [(), (3,), (2, 3)])
@pytest.mark.parametrize(
    ("kf", "rule"),
    [
        (extended_kalman_filter, lambda n: linearize),
        (unscented_kalman_filter, unscented),
        (cubature_kalman_filter, cubature),
    ],
    ids=["linearize", "unscented", "cubature"],
)
def test_steps_by_hand_are_the_filter(kf, rule, batch):
    rng = np.random.default_rng(0)
    linear = random_model(rng, 3, 2, p=1)
    model, belief, through = bent(linear), random_belief(rng, 3), rule(3)
    z, u = with_gaps(rng, rng.normal(size=(*batch, 6, 2))), rng.normal(size=(*batch, 6, 1))
    track = kf(model, z, belief, u)
    for k in range(6):
        belief = predict(model, belief, u[..., k, :], k=k, through=through)
        close(track.predicted.mean[..., k, :], belief.mean)
        close(track.predicted.cov[..., k, :, :], belief.cov)
        belief = correct(model, belief, z[..., k, :], k=k, through=through)
        close(track.mean[..., k, :], belief.mean)
        close(track.cov[..., k, :, :], belief.cov)


@every_filter
def test_a_series_of_scalars_may_be_flat(kf):
    model, start = random_walk(1, 2).replace(B=3), Gaussian(1, 2)
    z, u = np.array([1.0, np.nan, 2.0]), np.array([0.5, 0.0, -1.0])
    flat = kf(model, z, start, u)
    assert flat.mean.shape == (3, 1)
    same_track(flat, kf(model, z[:, None], start, u[:, None]))
    same_track(flat, kf(model, list(z), start, [0.5, 0, -1]))
    same_track(flat, kf(model, np.ma.masked_invalid(z), start, u))


@every_filter
def test_whole_numbers_are_numbers(kf):
    model, start = constant_velocity(1, 1, 1), Gaussian([0, 1], np.eye(2, dtype=int))
    same_track(kf(model, [1, 2, 4], start), kf(model, [1.0, 2.0, 4.0], start))


@every_filter
def test_one_step_and_nothing_but_gaps(kf):
    model, start = constant_velocity(1, 1, 1), Gaussian([0, 1], np.eye(2))
    once = kf(model, [2.0], start)
    assert once.mean.shape == (1, 2)
    close(once.mean[0], correct(model, predict(model, start), 2.0).mean)
    blind = kf(model, [np.nan] * 3, start)
    close(blind.mean, [[1, 1], [2, 1], [3, 1]])
    assert blind.log_likelihood == 0


@every_filter
def test_the_callers_arrays_stay_as_they_are(kf):
    rng = np.random.default_rng(1)
    model, start = random_model(rng, 2, 2, 1), random_belief(rng, 2)
    z, u = with_gaps(rng, rng.normal(size=(3, 9, 2))), rng.normal(size=(9, 1))
    before = z.copy(), u.copy()
    track = kf(model, z, start, u)
    assert np.isfinite(track.log_likelihood).all()
    np.testing.assert_array_equal(z, before[0])
    np.testing.assert_array_equal(u, before[1])


@every_filter
def test_stacks_of_one_serve_all_steps(kf):
    rng = np.random.default_rng(2)
    model, start, z = random_model(rng, 2, 1), random_belief(rng, 2), rng.normal(size=(900, 1))
    z = z if kf is kalman_filter else z[:9]
    stacked = LinearModel(model.F[None], model.H[None], model.Q[None], model.R[None])
    same_track(kf(stacked, z, start), kf(model, z, start))


@pytest.mark.parametrize("late", ["gap", "F", "H", "Q", "R", "B"])
def test_what_changes_late_is_not_overlooked(late):
    # By step 150 the gain has long come to rest; then a row is missing, or a matrix is another one.
    rng = np.random.default_rng(8)
    model, start = random_model(rng, 2, 2, 1, fastest=0.9), random_belief(rng, 2)
    z, u = rng.normal(size=(200, 2)), rng.normal(size=(200, 1))
    before = kalman_filter(model, z, start, u)
    assert (before.gain[100] == before.gain[-1]).all()
    if late == "gap":
        z[150] = np.nan
    else:
        matrix = getattr(model, late) * np.where(np.arange(200) < 150, 1, 0.5)[:, None, None]
        model = model.replace(**{late: matrix})
    track = kalman_filter(model, z, start, u)
    close(track.mean[:150], before.mean[:150])
    assert abs(track.mean[150] - before.mean[150]).max() > 1e-3
    mean, cov, _, _, log_likelihood = textbook(model, z, start, u)
    close(track.mean, mean)
    close(track.cov, cov)
    close(track.log_likelihood, log_likelihood)


def test_a_slow_gain_is_held_only_when_it_has_come_to_rest():
    # K = 0.001 in the end: it takes ten thousand steps to get there. A hold at the first small change would come early.
    Q, R, T = 1e-6, 1.0, 16_000
    P, x, gains, means = 0.01, 0.0, [], []
    z = np.random.default_rng(9).normal(size=T)
    for k in range(T):
        P = P + Q
        K = P / (P + R)
        x, P = x + K * (z[k] - x), (1 - K) * P
        gains.append(K)
        means.append(x)
    track = kalman_filter(random_walk(Q, R), z, Gaussian(0, 0.01))
    assert track.gain[-1] == track.gain[-2]  # held
    np.testing.assert_allclose(track.gain[:, 0, 0], gains, rtol=1e-10)
    close(track.mean[:, 0], means, 1e-10)


def test_the_same_gaps_in_all_runs_share_one_gain_sequence():
    rng = np.random.default_rng(3)
    model, start, z = random_model(rng, 2, 2), random_belief(rng, 2), rng.normal(size=(5, 8, 2))
    z[:, 2] = z[:, 5, 1] = np.nan
    track = kalman_filter(model, z, start)
    assert track.gain.shape == (5, 8, 2, 2)
    assert compact(track.gain).shape == (8, 2, 2)
    z[0, 3, 0] = np.nan
    assert compact(kalman_filter(model, z, start).gain).shape == (5, 8, 2, 2)


def test_the_unscented_filter_sees_what_the_tangent_misses():
    # z = x² at x = 0: the tangent is flat and learns nothing; the points do, if only that x is not far from 0.
    model = NonlinearModel(lambda x: x, lambda x: x**2, 1e-9, 0.01)
    start = Gaussian(0, 1)
    assert extended_kalman_filter(model, [0.0], start).innovation.cov.item() == pytest.approx(0.01)
    assert unscented_kalman_filter(model, [0.0], start).innovation.cov.item() == pytest.approx(2.01)
    assert unscented_kalman_filter(model, [0.0], start).innovation.mean.item() == pytest.approx(-1)


def test_alpha_beta_and_kappa_reach_the_points():
    model, start = bent(random_model(np.random.default_rng(5), 2, 1)), Gaussian([0, 0], np.eye(2))
    settings = [{}, {"alpha": 0.3}, {"beta": 0.0}, {"kappa": 1.0}]
    tracks = [unscented_kalman_filter(model, [1.0, 2.0], start, **given) for given in settings]
    for given, track in zip(settings, tracks, strict=True):
        rule = unscented(2, **given)
        belief = correct(model, predict(model, start, through=rule), 1.0, through=rule)
        close(track.mean[0], belief.mean)
        close(track.cov[0], belief.cov)
    finals = [track.cov[-1, 0, 0] for track in tracks]
    assert len(set(np.round(finals, 6))) == 4


def test_joseph_is_right_for_a_wrong_gain():
    # SYSTEMS C, numerics: the gain halved; P − K H P would claim (1.3333, 0.9583).
    P, H, R = np.array([[2, 0.5], [0.5, 1]]), np.array([[1.0, 0]]), np.array([[1.0]])
    gain = P @ H.T / 3 / 2
    np.testing.assert_allclose(np.diag(covariance_after(gain, P, H, R)), [1.0, 0.9375])
    np.testing.assert_allclose(np.diag((np.eye(2) - gain @ H) @ P), [1.3333, 0.9583], atol=5e-5)
    L = np.linalg.cholesky(P)  # and in the form for sigma points
    np.testing.assert_allclose(covariance_after(gain, P, H @ L, R, L), covariance_after(gain, P, H, R))


def twins(R, m):
    """Components that measure nearly the same: S is singular in rounded numbers."""
    H = np.ones((m, 2))
    H[1:, 1] += 1e-9 * np.arange(1, m)
    return LinearModel(np.eye(2), H, np.eye(2), R * np.eye(m))


@pytest.mark.parametrize("m", [2, 3])
@pytest.mark.parametrize("filter_", [kalman_filter, extended_kalman_filter, unscented_kalman_filter])
def test_a_singular_innovation_covariance_is_named_with_its_step(filter_, m):
    z = np.ones((6, m))
    z[:2, 1:] = np.nan
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(ValueError, match="at step 2 S = H P⁻ Hᵀ"):
            filter_(twins(1e-17, m), z, Gaussian([0, 0], np.eye(2)))
    assert np.isfinite(filter_(twins(1e-2, m), z, Gaussian([0, 0], np.eye(2))).mean).all()
