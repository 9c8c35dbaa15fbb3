"""The gate: what is refused, that it counts as missing from then on, and what track and report card say of it."""

import numpy as np
import pytest
from scipy.stats import chi2

from kflearn import (
    FILTERS,
    Gaussian,
    LinearModel,
    constant_velocity,
    correct,
    kalman_filter,
    predict,
    random_walk,
    report_card,
    rts_smoother,
    start_from,
)
from tests.helpers import as_nonlinear, close, random_belief, random_model, same_track, with_gaps

GATED = [row for row in FILTERS if "gate" in row.optional]
every_gated = pytest.mark.parametrize("row", GATED, ids=lambda row: row.name)


def wild(rng, *shape):
    """Readings with gaps, of which every tenth is far off."""
    z = rng.normal(size=shape)
    z[rng.random(shape[:-1]) < 0.1] += 40
    return with_gaps(rng, z, 0.1)


@every_gated
@pytest.mark.parametrize("batch", [(), (3,)])
def test_what_was_refused_might_as_well_be_missing(row, batch):
    rng = np.random.default_rng(0)
    model, start = random_model(rng, 3, 2, p=1), random_belief(rng, 3)
    z, u = wild(rng, *batch, 50, 2), rng.normal(size=(50, 1))
    found = row.run(model, z, start, u, gate=0.999)
    assert found.refused.shape == (*batch, 50)
    assert 0 < found.refused.mean() < 0.3
    expected = row.run(model, np.where(found.refused[..., None], np.nan, z), start, u)
    assert not expected.refused.any()
    for name in ("mean", "cov", "gain", "log_likelihood"):
        close(getattr(found, name), getattr(expected, name), 1e-12)
    if row.smoothed:
        smooth, wanted = rts_smoother(model, found), rts_smoother(model, expected)
        close(smooth.mean, wanted.mean, 1e-12)
        close(smooth.cov, wanted.cov, 1e-12)


@every_gated
def test_the_limit_is_that_of_the_components_that_came(row):
    rng = np.random.default_rng(1)
    model, start, z = random_model(rng, 3, 3), random_belief(rng, 3), with_gaps(rng, rng.normal(size=(200, 3)) * 3)
    track = row.run(model, z, start, gate=0.9)
    seen = (~np.isnan(z)).sum(axis=-1)
    assert set(seen) == {0, 1, 2, 3}
    limit = np.where(seen > 0, chi2.ppf(0.9, np.maximum(seen, 1)), np.inf)
    np.testing.assert_array_equal(track.refused, np.nan_to_num(track.nis) > limit)
    np.testing.assert_array_equal(np.isnan(track.nis), seen == 0)
    np.testing.assert_array_equal(np.isnan(track.innovation.mean), np.isnan(z))


@every_gated
def test_a_gate_that_is_wide_refuses_nothing_and_the_track_is_plain_data(row):
    rng = np.random.default_rng(2)
    model, start, z = random_model(rng, 2, 2), random_belief(rng, 2), rng.normal(size=(4, 20, 2))
    same_track(row.run(model, z, start, gate=1 - 1e-15), row.run(model, z, start))
    with pytest.raises(ValueError, match="read-only"):
        row.run(model, z, start).refused[:] = True


@every_gated
@pytest.mark.parametrize("gate", [0, 1, -1, 99, np.nan, "wide", [0.9, 0.8]])
def test_a_gate_is_a_probability(row, gate):
    with pytest.raises((ValueError, TypeError), match=r"^gate must "):
        row.run(random_walk(1, 1), [1.0, 2.0], Gaussian(0, 1), gate=gate)


def test_correct_tells_what_it_did():
    rng = np.random.default_rng(3)
    model, belief = random_model(rng, 3, 2), random_belief(rng, 3)
    z = np.array([model.measure(belief.mean), [100, 100], [np.nan, 100], [np.nan, np.nan]])
    for each in (model, as_nonlinear(model)):
        made = correct(each, belief, z, gate=0.99, details=True)
        assert made.refused.tolist() == [False, True, True, False]
        close(made.belief.mean[1:], np.broadcast_to(belief.mean, (3, 3)), 1e-14)
        close(made.belief.cov[1:], np.broadcast_to(belief.cov, (3, 3, 3)), 1e-14)
        np.testing.assert_array_equal(made.gain[1:], 0)
        plain = correct(each, belief, z, details=True)
        assert not plain.refused.any()
        S = model.H @ belief.cov @ model.H.T + model.R
        close(plain.innovation.cov, np.broadcast_to(S, (4, 2, 2)))
        close(plain.innovation.mean[:2], z[:2] - model.measure(belief.mean))
        close(plain.gain[0], belief.cov @ model.H.T @ np.linalg.inv(S))
        close(plain.belief.mean, correct(each, belief, z).mean)
        for array in (made.gain, made.refused, made.innovation.mean, made.innovation.cov):
            assert not array.flags.writeable


def test_steps_by_hand_are_the_gated_filter():
    rng = np.random.default_rng(4)
    model, start, z = random_model(rng, 2, 1), random_belief(rng, 2), wild(rng, 40, 1)
    track, belief = kalman_filter(model, z, start, gate=0.99), start
    for k, reading in enumerate(z):
        belief, _, _, refused = correct(model, predict(model, belief), reading, gate=0.99, details=True)
        assert refused == track.refused[k]
        close(belief.mean, track.mean[k], 1e-12)
    close(belief.cov, track.cov[-1], 1e-12)


@every_gated
def test_matrices_of_each_step_and_each_run(row):
    rng = np.random.default_rng(5)
    one = random_model(rng, 2, 1)
    R = rng.uniform(0.5, 2, (3, 30, 1, 1))
    model = LinearModel(np.stack([one.F] * 30), one.H, one.Q, R)
    z, start = wild(rng, 3, 30, 1), random_belief(rng, 2)
    together = row.run(model, z, start, gate=0.99)
    for run in range(3):
        alone = row.run(model.replace(R=R[run]), z[run], start, gate=0.99)
        np.testing.assert_array_equal(together.refused[run], alone.refused)
        close(together.cov[run], alone.cov)
        close(together.log_likelihood[run], alone.log_likelihood)


def test_lost_digits_are_refused_with_their_step():
    model = LinearModel(np.eye(2), [[1, 1], [1, 1]], np.zeros((2, 2)), 1e-9 * np.eye(2))
    with pytest.raises(ValueError, match=r"R must be larger beside P: at step 0"):
        kalman_filter(model, np.ones((3, 2)), Gaussian([0, 0], 1e12 * np.eye(2)), gate=0.99)


def test_the_report_card_counts_what_the_gate_refused():
    rng = np.random.default_rng(6)
    model = constant_velocity(1, 0.01, 1)
    z = rng.normal(size=200)
    z[100:110] += 50

    def follow(z, leave_out=None):
        first = start_from(random_walk(1, 1), z[0])
        start = Gaussian([first.mean[0], 0], np.diag([1, 0.01]))
        track = kalman_filter(model, z[1:], start, gate=0.999)
        if leave_out:
            track = kalman_filter(model, np.where(track.refused[:, None], np.nan, z[1:]), start)
        return model, track

    card = report_card(z, np.arange(200) < 50, follow)
    found = {test.what: test.found for test in card.tests}
    assert found["refused in a row"] == 10
    assert found["share refused"] == pytest.approx(follow(z[:, None])[1].refused.mean())
    other = report_card(z, np.arange(200) < 50, lambda z: follow(z, leave_out=True))
    np.testing.assert_allclose([test.found for test in card.tests], [test.found for test in other.tests], rtol=1e-9)
