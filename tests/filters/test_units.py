"""No answer depends on the units of states and measurements, however different these are from one component to another.

Elimination that chooses pivots by their size loses digits there, most of all where components hardly vary together.
"""

import numpy as np
import pytest

from dev.hard import draws, units
from kflearn import Gaussian, LinearModel, NonlinearModel, diffuse_start, start_from, unscented_kalman_filter
from kflearn.core.conditioning import definite, divide, log_determinant, squared_distance
from kflearn.core.matrices import inverse_lower, solve_lower

SIZES = [np.array([1e12, 1e-12, 1e12]), np.array([1e-12, 1e12, 1e-12]), np.array([1e-9, 1.0, 1e9])]
odd_sizes = pytest.mark.parametrize("size", SIZES, ids=["large small", "small large", "rising"])
LITTLE = [1e-3, 1e-8, 1e-13]  # correlations


def by_turns(k, count):
    return 10.0 ** (k * (-1.0) ** np.arange(count))


def both(name, title, X, Z):
    """What a filter makes of a scenario, and of the same in other units."""
    case = units.plain(name)._replace(name="one model")
    X, Z = X(case.model.n), Z(case.model.m)
    run = draws.filters(case.model)[title]
    return case, run(case), run(units.rescaled(case, X, Z)), X, Z


def nearly_apart(m, little):
    """A covariance of components that hardly vary together."""
    return np.diag(np.arange(1.0, m + 1)) + little * (1 - np.eye(m))


@pytest.mark.parametrize("k", [-12, -9, 9, 12])
@pytest.mark.parametrize("title", ["extended Kalman", "linearized Kalman", "adaptive R", "smoothed extended Kalman"])
@pytest.mark.parametrize("name", ["homing_missile", "range_and_bearing"])
def test_units_by_turns(name, title, k):
    """Angles that are measured apart: S is nearly diagonal, one of its variances 1e48 times the other."""
    _, right, found, X, _ = both(name, title, lambda n: by_turns(k, n), lambda m: by_turns(k, m))
    right, found = (getattr(each, "filtered", each) for each in (right, found))
    assert units.apart(units.back(found, X), right) < units.ALIKE


@pytest.mark.parametrize("k", [-9, -3, 9])
@pytest.mark.parametrize("title", ["smoothed unscented Kalman", "smoothed cubature Kalman"])
def test_a_smoother_where_some_states_have_no_noise_of_their_own(title, k):
    """Once the root of Q + rounding errors gave a state without variance one of 1e-16, in whatever units."""

    def alike(count):
        return np.full(count, 10.0**k)

    _, right, found, X, _ = both("homing_missile", title, alike, alike)
    assert units.apart(units.back(found, X), right) < units.ALIKE


@pytest.mark.parametrize("k", [-12, 12])
@pytest.mark.parametrize("title", ["Kalman", "square root Kalman"])
@pytest.mark.parametrize("name", ["ship", "manoeuvring"])
def test_how_likely_the_measurements_are(name, title, k):
    _, right, found, _, Z = both(name, title, lambda n: by_turns(k, n), lambda m: by_turns(-k, m))
    np.testing.assert_allclose(found.nis, right.nis, rtol=1e-6)
    density = found.log_likelihood + len(found.mean) * np.log(Z).sum()
    assert density == pytest.approx(right.log_likelihood, rel=1e-6)


@pytest.mark.parametrize("k", [-12, 12])
def test_a_start_from_the_measurements_alone(k):
    case = units.plain("ship")
    X, Z = by_turns(k, case.model.n), by_turns(-k, case.model.m)
    right, found = (diffuse_start(c.model, c.z, c.u) for c in (case, units.rescaled(case, X, Z)))
    assert found.steps == right.steps
    np.testing.assert_allclose(found.belief.mean / X, right.belief.mean, rtol=1e-6)
    density = found.log_likelihood + found.steps * np.log(Z).sum() - np.log(X).sum()  # the state's density is left out
    assert density == pytest.approx(right.log_likelihood)


@odd_sizes
@pytest.mark.parametrize("little", LITTLE)
@pytest.mark.parametrize("m", [2, 3])
def test_division_by_a_covariance(m, little, size):
    S, size = nearly_apart(m, little), size[:m]
    C, y = np.random.default_rng(0).normal(size=(4, m)), np.arange(1.0, m + 1)
    odd, right = S * np.outer(size, size), np.linalg.solve(S, C.T).T
    np.testing.assert_allclose(divide(C * size, odd) * size, right, rtol=1e-12)
    many = divide(np.stack([C * size, C]), np.stack([odd, S]))
    np.testing.assert_allclose(many * np.stack([size, np.ones(m)])[:, None], np.stack([right, right]), rtol=1e-12)
    np.testing.assert_allclose(squared_distance(y * size, odd), y @ np.linalg.solve(S, y), rtol=1e-12)
    np.testing.assert_allclose(log_determinant(odd) - 2 * np.log(size).sum(), np.linalg.slogdet(S)[1], atol=1e-12)


@odd_sizes
def test_roots_are_divided_by_without_pivots(size):
    L = np.array([[1.0, 0, 0], [1e-9, 2, 0], [0.5, 1e-8, 3]])
    odd, b = L * size[:, None], np.array([1.0, 2, 3])
    np.testing.assert_allclose(solve_lower(odd, b * size), np.linalg.solve(L, b), rtol=1e-12)
    np.testing.assert_allclose(inverse_lower(odd) * size, np.linalg.inv(L), rtol=1e-12, atol=1e-16)


@odd_sizes
@pytest.mark.parametrize("little", LITTLE)
def test_beliefs_are_fused(little, size):
    one, other, scale = nearly_apart(3, little), nearly_apart(3, -0.3 * little), np.outer(size, size)
    x, y = np.array([1.0, 2, 3]), np.array([3.0, 2, -1])
    right = Gaussian(x, one).fuse(Gaussian(y, other))
    found = Gaussian(x * size, one * scale).fuse(Gaussian(y * size, other * scale))
    np.testing.assert_allclose(found.mean / size, right.mean, rtol=1e-12)
    np.testing.assert_allclose(found.cov / scale, right.cov, rtol=1e-12, atol=1e-14 * little)


@odd_sizes
@pytest.mark.parametrize("little", LITTLE)
def test_a_start_from_one_measurement(little, size):
    H, R, z = nearly_apart(3, little), nearly_apart(3, 0.2), np.array([1.0, 2, 3])
    right = start_from(LinearModel(np.eye(3), H, np.eye(3), R), z)
    for X, Z in ((size, np.ones(3)), (np.ones(3), size), (size, size), (size, 1 / size)):
        model = LinearModel(np.eye(3), Z[:, None] * H / X, np.eye(3), R * np.outer(Z, Z))
        found = start_from(model, z * Z)
        np.testing.assert_allclose(found.mean / X, right.mean, rtol=1e-12)
        np.testing.assert_allclose(found.cov / np.outer(X, X), right.cov, rtol=1e-12)


@pytest.mark.parametrize("X", [1.0, np.array([1e9, 1e-9]), np.array([1e-9, 1e9])], ids=["plain", "small", "large"])
def test_no_covariance_is_refused_however_small_the_unit(X):
    """The variance of the second state is −2; in small units it was a rounding error beside the first one's."""
    X = X * np.ones(2)

    def f(x):
        return X * np.stack([x[..., 0] / X[0], (x[..., 1] / X[1]) ** 2], axis=-1)

    model = NonlinearModel(f, lambda x: x[..., :1] / X[0], np.diag([1, 0.01]) * np.outer(X, X), 1, scale=X)
    with pytest.raises(ValueError, match="at step 0 these sigma points make P⁻ no covariance"):
        unscented_kalman_filter(model, np.ones(5), Gaussian([0, 0], np.diag(X**2)), beta=-3)


def test_one_unit_in_the_last_place_is_no_variance():
    last = np.spacing(1.0)
    for m in (2, 3):
        S = np.ones((m, m)) + last * np.diag([0.0, *[1] * (m - 1)])
        assert not definite(S)
        assert definite(np.ones((m, m)) + 64 * last * np.eye(m))
