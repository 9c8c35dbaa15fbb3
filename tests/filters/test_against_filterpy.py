"""FilterPy 2.0 on the same numbers. What of it can be trusted: KalmanFilter, the EKF with its own Jacobian, the UKF."""

import numpy as np
import pytest
from filterpy.kalman import ExtendedKalmanFilter, KalmanFilter, MerweScaledSigmaPoints, UnscentedKalmanFilter

from kflearn import extended_kalman_filter, kalman_filter, unscented_kalman_filter
from tests.helpers import bent, random_belief, random_model

T = 12


def agree(found, expected, tolerance=1e-10):
    np.testing.assert_allclose(found, expected, rtol=tolerance, atol=tolerance * np.nanmax(abs(np.asarray(expected))))


def loop(kf, z, predict, update):
    """Their filter along a series; a row of NaN is update(None). One dictionary of arrays along time."""
    rows = []
    for k in range(len(z)):
        predict(k)
        row = dict(prior=kf.x.copy(), prior_cov=kf.P.copy())
        gap = np.isnan(z[k]).any()
        update(k, None if gap else z[k])
        row |= dict(mean=kf.x.copy(), cov=kf.P.copy())
        if gap:
            n, m = len(kf.x), len(z[k])
            row |= dict(gain=np.zeros((n, m)), S=np.full((m, m), np.nan), y=z[k], log=0.0, nis=np.nan)
        else:
            row |= dict(gain=kf.K.copy(), S=kf.S.copy(), y=kf.y.copy(), log=kf.log_likelihood, nis=kf.mahalanobis**2)
        rows.append(row)
    return {name: np.array([row[name] for row in rows]) for name in rows[0]}


def compare(track, theirs, tolerance=1e-10):
    seen = ~np.isnan(theirs["nis"])
    agree(track.predicted.mean, theirs["prior"], tolerance)
    agree(track.predicted.cov, theirs["prior_cov"], tolerance)
    agree(track.mean, theirs["mean"], tolerance)
    agree(track.cov, theirs["cov"], tolerance)
    agree(track.gain, theirs["gain"], tolerance)
    agree(track.innovation.mean, theirs["y"], tolerance)
    agree(track.innovation.cov[seen], theirs["S"][seen], tolerance)
    agree(track.nis, theirs["nis"], tolerance)
    agree(track.log_likelihood, theirs["log"].sum(), tolerance)


def problem(seed):
    """A model with or without control input, a series with gaps, a start."""
    rng = np.random.default_rng(seed)
    n, m, p = rng.integers(1, 6), rng.integers(1, 4), rng.integers(0, 3)
    model, start = random_model(rng, n, m, p), random_belief(rng, n)
    z, u = rng.normal(size=(T, m)), rng.normal(size=(T, p)) if p else None
    z[rng.random(T) < 0.2] = np.nan
    return model, z, start, u


@pytest.mark.parametrize("seed", range(50))
def test_kalman_filter(seed):
    model, z, start, u = problem(seed)
    kf = KalmanFilter(model.n, model.m, dim_u=model.p)
    kf.x, kf.P = start.mean.copy(), start.cov.copy()
    kf.F, kf.H, kf.Q, kf.R, kf.B = model.F, model.H, model.Q, model.R, model.B
    theirs = loop(kf, z, lambda k: kf.predict(None if u is None else u[k]), lambda k, row: kf.update(row))
    compare(kalman_filter(model, z, start, u), theirs)


class TheirEKF(ExtendedKalmanFilter):
    """Their filter with our functions in place of F x + B u."""

    model = None

    def predict_x(self, u=None):
        self.F = self.model.move_slope(self.x, u)
        self.x = self.model.move(self.x, u)


@pytest.mark.parametrize("seed", range(10))
def test_extended_kalman_filter(seed):
    linear, z, start, u = problem(seed)
    model = bent(linear)
    kf = TheirEKF(model.n, model.m, linear.p)
    kf.model, kf.x, kf.P, kf.Q, kf.R = model, start.mean.copy(), start.cov.copy(), model.Q, model.R
    theirs = loop(
        kf,
        z,
        lambda k: kf.predict(None if u is None else u[k]),
        lambda k, row: kf.update(row, HJacobian=model.H_jacobian, Hx=model.h),
    )
    compare(extended_kalman_filter(model, z, start, u), theirs)


@pytest.mark.parametrize(("alpha", "beta", "kappa"), [(1.0, 2.0, 0.5), (0.5, 2.0, 1.0), (0.3, 0.0, 0.0)])
@pytest.mark.parametrize("seed", range(8))
def test_unscented_kalman_filter(seed, alpha, beta, kappa):
    linear, z, start, _ = problem(seed)
    model = bent(linear.replace(B=None))
    points = MerweScaledSigmaPoints(model.n, alpha, beta, kappa)
    kf = UnscentedKalmanFilter(model.n, model.m, dt=1, hx=model.h, fx=lambda x, dt: model.f(x), points=points)
    kf.x, kf.P, kf.Q, kf.R = start.mean.copy(), start.cov.copy(), model.Q, model.R
    theirs = loop(kf, z, lambda k: kf.predict(), lambda k, row: kf.update(row))
    ours = unscented_kalman_filter(model, z, start, alpha=alpha, beta=beta, kappa=kappa)
    compare(ours, theirs, 1e-9)
