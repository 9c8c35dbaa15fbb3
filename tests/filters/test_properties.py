"""What must hold for every model and all data (Hypothesis)."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kflearn import (
    FILTERS,
    Gaussian,
    LinearModel,
    correct,
    cubature_kalman_filter,
    kalman_filter,
    predict,
    unscented_kalman_filter,
)
from kflearn.core.matrices import compact
from tests.helpers import (
    bent,
    close,
    random_belief,
    random_covariance,
    random_model,
    with_gaps,
)

settings.register_profile("course", max_examples=15, deadline=None, derandomize=True, database=None)
settings.load_profile("course")

SIGMA = [unscented_kalman_filter, cubature_kalman_filter]
# Those that are the Kalman filter on a linear model and return a Track of one model: a new one is found in the table.
ONE_MODEL = [row for row in FILTERS if row.exact and not row.several]
LINEAR = [row.function for row in ONE_MODEL if row.models == "linear"]
NONLINEAR = [row.function for row in ONE_MODEL if row.models == "both"]
ALL = [*LINEAR, *NONLINEAR]

seeds = st.integers(0, 2**32 - 1).map(np.random.default_rng)
states = st.integers(1, 4)
outputs = st.integers(1, 3)
every_filter = pytest.mark.parametrize("kf", ALL, ids=lambda f: f.__name__)
every_nonlinear_filter = pytest.mark.parametrize("kf", NONLINEAR, ids=lambda f: f.__name__)


def lowest(P, relative_to=None):
    """The lowest eigenvalue of each P in units of the highest of `relative_to`, or of P itself."""
    highest = np.linalg.eigvalsh(P if relative_to is None else relative_to)[..., -1]
    return (np.linalg.eigvalsh(P)[..., 0] / np.where(highest > 0, highest, 1)).min()


@every_filter
@given(rng=seeds, n=states, m=outputs, spread=st.floats(-6, 6), noise=st.floats(-6, 6), drop=st.integers(0, 4))
def test_covariances_stay_symmetric_and_positive(kf, rng, n, m, spread, noise, drop):
    # Start and Q may be singular, and twelve powers of ten apart from R.
    rank = max(n - drop, 1) if drop else None
    model = random_model(rng, n, m).replace(Q=random_covariance(rng, n, rank), R=10**noise * random_covariance(rng, m))
    initial = Gaussian(np.zeros(n), 10**spread * random_covariance(rng, n, rank))
    z = with_gaps(rng, rng.normal(size=(12, m)))
    track = kf(model if kf in LINEAR else bent(model), z, initial)
    for belief in (track.predicted, track.filtered):
        assert np.isfinite(belief.mean).all()
        assert (abs(belief.cov - belief.cov.mT) <= 1e-13 * abs(belief.cov).max()).all()
        assert (belief.variance >= 0).all()
        assert lowest(belief.cov, track.predicted.cov) > -1e-14
        if spread - noise < 8:  # P⁺ is known to a rounding of P⁻: beyond this its correlations may be off by 1e-6
            Gaussian(belief.mean, belief.cov)  # a belief made of them passes for one
    assert lowest(track.innovation.cov) > 0


@pytest.mark.parametrize("kf", [*LINEAR, unscented_kalman_filter], ids=lambda f: f.__name__)
@given(rng=seeds, degrees=st.sampled_from([1, 30, 45, 60, 90]), size=st.floats(-3, 3), noise=st.floats(-3, 3))
def test_what_is_known_exactly_gets_no_negative_variance(kf, rng, degrees, size, noise):
    # One direction of the state is known exactly and turns: its variance is 0, and rounding makes it ±1e-16.
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    model = LinearModel([[c, -s], [s, c]], [[1, 0]], np.zeros((2, 2)), 10**noise)
    track = kf(model, rng.normal(size=24), Gaussian([0, 0], np.diag([10**size, 0])))
    steps = [predict(model, Gaussian([0, 0], np.diag([10**size, 0])))]
    steps.append(correct(model, steps[0], 1.0))
    for belief in (track.predicted, track.filtered, *steps):
        assert (belief.variance >= 0).all()
        assert np.isfinite(belief.std).all()
        Gaussian(belief.mean, belief.cov)


@every_filter
@given(rng=seeds, n=states, m=outputs, gaps=st.booleans(), shared_u=st.booleans(), varying=st.booleans())
def test_a_batch_is_a_loop_over_its_runs(kf, rng, n, m, gaps, shared_u, varying):
    runs, T, p = 4, 7, 2
    model = random_model(rng, n, m, p, steps=T if varying else None)
    if kf in NONLINEAR and not varying:
        model = bent(model)
    z, u = rng.normal(size=(runs, T, m)), rng.normal(size=(runs, T, p))
    z = with_gaps(rng, z) if gaps else z
    u = u[0] if shared_u else u
    initial = random_belief(rng, n)
    together = kf(model, z, initial, u)
    assert together.mean.shape == (runs, T, n)
    assert together.log_likelihood.shape == (runs,)
    for run in range(runs):
        alone = kf(model, z[run], initial, u if shared_u else u[run])
        close(together.mean[run], alone.mean)
        close(together.predicted.mean[run], alone.predicted.mean)
        close(together.innovation.mean[run], alone.innovation.mean)
        close(together.nis[run], alone.nis)
        close(together.log_likelihood[run], alone.log_likelihood)
        for batched, single in (
            (together.cov, alone.cov),
            (together.gain, alone.gain),
            (together.predicted.cov, alone.predicted.cov),
            (together.innovation.cov, alone.innovation.cov),
        ):
            close(batched[run], single)


@given(rng=seeds, n=states, m=outputs)
def test_without_gaps_one_covariance_is_stored_for_all_runs(rng, n, m):
    track = kalman_filter(random_model(rng, n, m), rng.normal(size=(5, 6, m)), random_belief(rng, n))
    for array, size in (
        (track.cov, n * n),
        (track.predicted.cov, n * n),
        (track.innovation.cov, m * m),
        (track.gain, n * m),
    ):
        assert array.shape[:2] == (5, 6)
        assert array.strides[0] == 0
        assert compact(array).size == 6 * size


@every_filter
@given(rng=seeds, n=states, m=outputs)
def test_the_coordinates_of_the_state_do_not_matter(kf, rng, n, m):
    model, initial = random_model(rng, n, m, p=1), random_belief(rng, n)
    z, u = with_gaps(rng, rng.normal(size=(10, m))), rng.normal(size=(10, 1))
    T = random_covariance(rng, n) + rng.normal(size=(n, n)) / 5 + np.eye(n)  # any invertible matrix
    inverse = np.linalg.inv(T)
    turned = LinearModel(T @ model.F @ inverse, model.H @ inverse, T @ model.Q @ T.T, model.R, T @ model.B)
    track, other = kf(model, z, initial, u), kf(turned, z, Gaussian(T @ initial.mean, T @ initial.cov @ T.T), u)
    tolerance = 1e-12 * np.linalg.cond(T) ** 2
    close(other.mean, track.mean @ T.T, tolerance)
    close(other.cov, T @ track.cov @ T.T, tolerance)
    close(other.nis, track.nis, tolerance)
    close(other.log_likelihood, track.log_likelihood, tolerance)


@every_filter
@given(rng=seeds, n=states, m=outputs, powers=st.lists(st.integers(-6, 6), min_size=7, max_size=7), full=st.booleans())
def test_other_units_only_rescale(kf, rng, n, m, powers, full):
    model = random_model(rng, n, m).replace(Q=random_covariance(rng, n, None if full else 1))
    initial = Gaussian(rng.normal(size=n), random_covariance(rng, n, None if full else 1))
    z = with_gaps(rng, rng.normal(size=(10, m)))
    X, Z = 10.0 ** np.array(powers[:n]), 10.0 ** np.array(powers[4 : 4 + m])
    XX, ZZ = np.outer(X, X), np.outer(Z, Z)
    rescaled = LinearModel(model.F * np.outer(X, 1 / X), model.H * np.outer(Z, 1 / X), model.Q * XX, model.R * ZZ)
    track, other = kf(model, z, initial), kf(rescaled, z * Z, Gaussian(initial.mean * X, initial.cov * XX))
    close(other.mean / X, track.mean)
    close(other.cov / XX, track.cov)
    close(other.gain / np.outer(X, 1 / Z), track.gain)
    close(other.innovation.cov / ZZ, track.innovation.cov)
    close(other.nis, track.nis)
    seen = (~np.isnan(z) * np.log(Z)).sum()  # a density per kilometre is not one per metre
    close(other.log_likelihood + seen, track.log_likelihood)


@given(rng=seeds, n=states)
def test_fusion_commutes_associates_and_is_a_correction(rng, n):
    a, b, c = (random_belief(rng, n) for _ in range(3))
    for one, other in ((a.fuse(b), b.fuse(a)), (a.fuse(b).fuse(c), a.fuse(b.fuse(c)))):
        close(one.mean, other.mean)
        close(one.cov, other.cov)
    direct = LinearModel(np.eye(n), np.eye(n), np.zeros((n, n)), b.cov)
    after = correct(direct, a, b.mean)
    close(a.fuse(b).mean, after.mean)
    close(a.fuse(b).cov, after.cov)


@given(rng=seeds, n=states, m=outputs)
def test_more_data_never_raises_the_covariance(rng, n, m):
    model, initial = random_model(rng, n, m), random_belief(rng, n)
    z = rng.normal(size=(10, m))
    some, fewer = with_gaps(rng, z), None
    fewer = with_gaps(rng, some)
    tracks = [kalman_filter(model, data, initial) for data in (z, some, fewer, np.full_like(z, np.nan))]
    for more, less in pairwise(tracks):
        assert lowest(less.cov - more.cov, less.cov) > -1e-12
    for track in tracks:
        assert lowest(track.predicted.cov - track.cov, track.predicted.cov) > -1e-12


@every_filter
@given(rng=seeds, n=states, m=outputs)
def test_a_missing_row_is_predict_only(kf, rng, n, m):
    model, initial = random_model(rng, n, m), random_belief(rng, n)
    model = model if kf in LINEAR else bent(model)
    z = rng.normal(size=(6, m))
    z[3] = np.nan
    track = kf(model, z, initial)
    close(track.mean[3], track.predicted.mean[3], 1e-15)
    close(track.cov[3], track.predicted.cov[3], 1e-13)
    assert (track.gain[3] == 0).all()
    assert np.isnan(track.innovation.mean[3]).all()
    assert np.isnan(track.nis[3])
    assert np.isfinite(np.delete(track.nis, 3)).all()
    assert np.isfinite(track.innovation.cov).all()  # what would have been expected is known


@every_filter
@given(rng=seeds, n=states, m=st.integers(2, 3))
def test_a_component_that_is_never_measured_might_as_well_not_exist(kf, rng, n, m):
    model, initial = random_model(rng, n, m), random_belief(rng, n)
    z = rng.normal(size=(8, m))
    keep = np.sort(rng.permutation(m)[: m - 1])
    less = model.replace(H=model.H[keep], R=model.R[np.ix_(keep, keep)])
    gone = np.setdiff1d(np.arange(m), keep)
    gappy = z.copy()
    gappy[:, gone] = np.nan
    if kf in NONLINEAR:
        model, less = bent(model), bent(less)
    track, smaller = kf(model, gappy, initial), kf(less, z[:, keep], initial)
    close(track.mean, smaller.mean)
    close(track.cov, smaller.cov)
    close(track.nis, smaller.nis)
    close(track.log_likelihood, smaller.log_likelihood)
    close(track.gain[..., keep], smaller.gain)
    assert (track.gain[..., gone] == 0).all()
