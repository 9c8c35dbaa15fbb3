"""Maximum likelihood beside closed answers, stored results of other programs, and SciPy's own search."""

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.stats import multivariate_normal

from kflearn import Gaussian, LinearModel, constant_velocity, diffuse_start, examples, fit, kalman_filter, random_walk

NILE = examples.load("nile")["flow"]
FIRST = {"Q": 1000.0, "R": 10000.0}


def trend(R, level, slope):
    return LinearModel([[1, 1], [0, 1]], [[1, 0]], np.diag([level, slope]), R)


def numbers(found):
    return np.array([found.parameters[name] for name in found.parameters])


# ---- right


def test_the_nile():
    """Dense Gaussian algebra with a flat prior; KFAS and R say the same."""
    found = fit(random_walk, NILE, FIRST)
    assert found.parameters["R"] == pytest.approx(15098.5, abs=0.1)
    assert found.parameters["Q"] == pytest.approx(1469.2, abs=0.1)
    assert found.log_likelihood == pytest.approx(-632.545625, abs=1e-5)
    assert found.log_likelihood_of_all == pytest.approx(-633.464564, abs=1e-5)
    assert found.converged and not found.at_boundary["Q"]


def test_with_gaps():
    z = NILE.copy()
    z[np.random.default_rng(1).permutation(100)[:10]] = np.nan
    found = fit(random_walk, z, FIRST)

    def dense(q, r):
        """The likelihood of the differences of readings that follow one another."""
        at = np.flatnonzero(~np.isnan(z))
        D = np.diff(np.eye(len(at)), axis=0)
        cov = D @ (q * np.minimum.outer(at, at) + r * np.eye(len(at))) @ D.T
        return multivariate_normal(np.zeros(len(D)), cov).logpdf(np.diff(z[at]))

    q, r = numbers(found)
    assert found.log_likelihood == pytest.approx(dense(q, r), abs=1e-8)
    beside = [dense(q * 1.01, r), dense(q / 1.01, r), dense(q, r * 1.01), dense(q, r / 1.01)]
    assert max(beside) < dense(q, r)


@pytest.mark.parametrize("factor", [1000, 0.01, 1e6])
def test_the_unit_does_not_matter(factor):
    one, other = fit(random_walk, NILE, FIRST), fit(random_walk, NILE * factor, FIRST)
    ratios = [found.parameters["Q"] / found.parameters["R"] for found in (one, other)]
    assert ratios[1] == pytest.approx(ratios[0], rel=1e-6)


@pytest.mark.parametrize("first", [(1, 1), (1e8, 1), (1e-6, 1e6), (1e3, 1e-5), (1e-9, 1e12), (1e20, 1e18)])
def test_the_start_does_not_matter(first):
    found = fit(random_walk, NILE, dict(zip("QR", first, strict=True)))
    assert numbers(found) == pytest.approx([1469.18, 15098.5], rel=1e-5)


def test_white_noise_is_at_the_boundary():
    z = np.random.default_rng(3).normal(1000, 100, 100)
    found = fit(random_walk, z, FIRST)
    assert found.parameters["Q"] == 0 and found.at_boundary == {"Q": True, "R": False}
    assert found.parameters["R"] == pytest.approx(np.var(z, ddof=1), rel=1e-6)
    assert np.isnan(found.standard_errors["Q"]) and "Q = 0, at its boundary" in repr(found)


def test_an_R_next_to_nothing_is_at_the_boundary():
    """A random walk read without errors: R must not be 0, but nothing speaks for more."""
    z = np.cumsum(np.random.default_rng(0).normal(0, 1, 60))
    z += 0.3 * np.append(0, np.diff(z))  # neighbours of its steps are alike, where an R would make them opposed
    found = fit(random_walk, z, {"Q": 1.0, "R": 1.0})
    assert found.at_boundary == {"Q": False, "R": True} and 0 < found.parameters["R"] < 1e-6
    assert np.isnan(found.standard_errors["R"]) and found.standard_errors["Q"] > 0


def test_local_linear_trend():
    """ssfortran 14677 / 1754, R's StructTS and KFAS with an exact diffuse start: no slope that changes."""
    found = fit(trend, NILE, dict(R=1e4, level=1e3, slope=10.0))
    assert found.parameters["R"] == pytest.approx(14678, abs=2)
    assert found.parameters["level"] == pytest.approx(1753, abs=2)
    assert found.at_boundary == {"R": False, "level": False, "slope": True}


@pytest.mark.parametrize("initial", [None, Gaussian([0, 0], np.diag([100, 9]))], ids=["diffuse", "given"])
def test_it_is_the_top_of_the_filters_likelihood(initial):
    """Of a model whose matrices are no straight functions of a parameter; searched with SciPy as well."""
    rng = np.random.default_rng(8)
    v = np.cumsum(rng.normal(0, 0.5, 60))
    z = np.cumsum(v) + rng.normal(0, 2, 60)
    z[20:24] = np.nan

    def build(acceleration, R):
        return constant_velocity(1, acceleration, R)

    def score(logs):
        model = build(*np.exp(logs))
        if initial is not None:
            return -kalman_filter(model, z, initial).log_likelihood
        start = diffuse_start(model, z)
        after = kalman_filter(start.model, z[start.steps :], start.belief)
        return -start.log_likelihood - after.log_likelihood

    found = fit(build, z, dict(acceleration=1.0, R=1.0), initial)
    best = minimize(score, np.log([1, 1]), method="Nelder-Mead", options=dict(xatol=1e-6, fatol=1e-9))
    assert numbers(found) == pytest.approx(np.exp(best.x), rel=1e-5)
    assert found.log_likelihood == pytest.approx(-best.fun, abs=1e-8)


def test_a_parameter_of_either_sign():
    rng, x = np.random.default_rng(6), [0.0]
    for _ in range(400):
        x.append(-0.7 * x[-1] + rng.normal())

    def build(fading, Q):
        return LinearModel(fading, 1, Q, 0.01)

    found = fit(build, np.array(x) + rng.normal(0, 0.1, 401), dict(fading=0.5, Q=1.0), as_is=["fading"])
    assert abs(found.parameters["fading"] + 0.7) < 3 * found.standard_errors["fading"] < 0.15


def test_control_inputs_are_used():
    rng, u = np.random.default_rng(4), np.random.default_rng(5).normal(0, 5, (80, 1))
    z = np.cumsum(u[:, 0] + rng.normal(0, 0.1, 80)) + rng.normal(0, 0.5, 80)
    found = fit(lambda Q, R: LinearModel(1, 1, Q, R, B=1), z, dict(Q=1.0, R=1.0), u=u)
    assert found.parameters["Q"] < 0.05 and found.parameters["R"] == pytest.approx(0.25, rel=0.4)


# ---- how sure


def test_standard_errors_are_the_scatter_of_many_fits():
    rng = np.random.default_rng(1)
    z = np.cumsum(rng.normal(0, 1, (2000, 200, 1)), axis=1) + rng.normal(0, 1, (2000, 200, 1))
    found = fit(random_walk, z, {"Q": 1.0, "R": 1.0})
    for name in "QR":
        scatter = found.parameters[name].std()
        assert np.median(found.standard_errors[name]) == pytest.approx(scatter, rel=0.08), name
        inside = abs(found.parameters[name] - 1) < 1.96 * found.standard_errors[name]
        assert 0.90 < inside.mean() < 0.965, name  # the errors of a variance lean to one side
    assert found.converged.all() and found.log_likelihood.shape == (2000,)


def test_many_series_are_fitted_alone():
    rng = np.random.default_rng(3)
    z = np.cumsum(rng.normal(0, 1, (3, 50, 1)), axis=1) + rng.normal(0, 2, (3, 50, 1))
    z[1, 20:25] = np.nan
    together = fit(random_walk, z, {"Q": 1.0, "R": 1.0})
    for i in range(3):
        alone = fit(random_walk, z[i], {"Q": 1.0, "R": 1.0})
        assert [p[i] for p in together.parameters.values()] == pytest.approx(numbers(alone), rel=1e-5)
        assert together.log_likelihood[i] == pytest.approx(alone.log_likelihood, abs=1e-8)


def test_the_better_model_has_the_smaller_criterion():
    rng = np.random.default_rng(9)
    straight = 3 * np.arange(60) + rng.normal(0, 1, 60)
    walk, line = (
        fit(random_walk, straight, {"Q": 1.0, "R": 1.0}),
        fit(trend, straight, dict(R=1.0, level=1.0, slope=1.0)),
    )
    assert line.aic < walk.aic - 50
    assert line.aic == pytest.approx(2 * (3 + 2) - 2 * line.log_likelihood)


# ---- words


def test_the_track_begins_where_all_is_known():
    found = fit(random_walk, NILE, FIRST)
    assert found.track.mean.shape == (99, 1)
    assert found.track.gain[-1, 0, 0] == pytest.approx(0.267, abs=5e-4)
    assert fit(random_walk, NILE, FIRST, Gaussian(1000, 1e6)).track.mean.shape == (100, 1)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (dict(build=3), "build must be a function"),
        (dict(build=lambda Q, R: 7), "build must return a LinearModel, got int"),
        (dict(start={}), "start must be a dict"),
        (dict(start={"Q": "a", "R": 1.0}), "start\\['Q'\\] must"),
        (dict(as_is=["S"]), "as_is must name parameters of start, got \\['S'\\]"),
        (dict(z=[np.nan, np.nan]), "z must determine all 1 states"),
        (dict(u=np.zeros((2, 100, 1)), build=lambda Q, R: LinearModel(1, 1, Q, R, B=1)), "u must have shape"),
    ],
)
def test_wrong_calls_say_so(change, says):
    call = dict(build=random_walk, z=NILE, start=FIRST) | change
    with pytest.raises((ValueError, TypeError), match=says):
        fit(**call)
