import numpy as np
import pytest

from kflearn import Gaussian
from kflearn.filters.moments import congruence, cubature, linearize, unscented
from tests.helpers import close, random_belief, random_covariance

RULES = [unscented(3), unscented(3, 0.5, 2, 1), unscented(3, 0.01), unscented(3, 1, 0, -2), cubature(3)]


def bend(x):
    """Three numbers in, two out."""
    return np.stack([x[..., 0] * x[..., 1] + x[..., 2], np.sin(x[..., 0]) + x[..., 1] ** 2], axis=-1)


def test_linearize_follows_the_tangent():
    belief = Gaussian([2.0], [[0.5]])
    out = linearize(belief, lambda x: x**3, lambda x: 3 * x[..., None] ** 2)
    np.testing.assert_allclose(out.mean, [8])
    np.testing.assert_allclose(out.cov, [[12 * 0.5 * 12]])
    np.testing.assert_allclose(out.cross, [[0.5 * 12]])


def test_congruence():
    rng = np.random.default_rng(0)
    A, P = rng.normal(size=(5, 2, 3)), random_covariance(rng, 3)
    cov, cross = congruence(A, P)
    np.testing.assert_allclose(cov, np.einsum("bij,jk,blk->bil", A, P, A))
    np.testing.assert_allclose(cross, np.einsum("ij,bkj->bik", P, A))


@pytest.mark.parametrize("rule", RULES)
def test_sigma_points_are_exact_for_a_linear_function(rule):
    rng = np.random.default_rng(1)
    A, belief = rng.normal(size=(2, 3)), random_belief(rng, 3)
    out, exact = rule(belief, lambda x: x @ A.T), linearize(belief, lambda x: x @ A.T, lambda x: A)
    for found, expected in zip(out[:3], exact[:3], strict=True):
        close(found, expected, 1e-11)


@pytest.mark.parametrize(("alpha", "beta", "kappa"), [(1, 2, 0), (0.5, 2, 1), (1, 0, -2), (0.9, 1.5, 4)])
def test_unscented_is_the_published_sum_over_points(alpha, beta, kappa):
    n, belief = 3, random_belief(np.random.default_rng(2), 3)
    scale = alpha**2 * (n + kappa)  # n + λ
    L = np.linalg.cholesky(belief.cov) * np.sqrt(scale)
    points = np.concatenate([belief.mean[None], belief.mean + L.T, belief.mean - L.T])
    for_mean = np.full(7, 1 / (2 * scale))
    for_mean[0] = 1 - n / scale
    for_cov = for_mean.copy()
    for_cov[0] += 1 - alpha**2 + beta
    images = bend(points)
    mean = for_mean @ images
    out = unscented(n, alpha, beta, kappa)(belief, bend)
    close(out.mean, mean, 1e-12)
    close(out.cov, (images - mean).T @ np.diag(for_cov) @ (images - mean), 1e-11)
    close(out.cross, (points - belief.mean).T @ np.diag(for_cov) @ (images - mean), 1e-11)


def test_the_square_of_a_gaussian():
    # Mean μ² + σ² and variance 4μ²σ² + 2σ⁴: the default unscented rule finds both, the tangent neither.
    belief = Gaussian([3.0], [[2.0]])
    out = unscented(1)(belief, lambda x: x**2)
    np.testing.assert_allclose(out.mean, [11])
    np.testing.assert_allclose(out.cov, [[4 * 9 * 2 + 2 * 4]])
    np.testing.assert_allclose(out.cross, [[2 * 3 * 2]])


@pytest.mark.parametrize("rule", RULES)
def test_the_mean_of_a_cubic_is_exact(rule):
    belief, a = random_belief(np.random.default_rng(4), 3), np.array([1.0, -2.0, 0.5])
    centre, variance = a @ belief.mean, a @ belief.cov @ a
    out = rule(belief, lambda x: (x @ a)[..., None] ** 3)
    np.testing.assert_allclose(out.mean, [centre**3 + 3 * centre * variance], rtol=1e-10)


@pytest.mark.parametrize("rule", RULES)
def test_batches_and_unbatched_covariances(rule):
    rng = np.random.default_rng(5)
    means, cov = rng.normal(size=(4, 2, 3)), random_covariance(rng, 3)
    together = rule(Gaussian(means, cov), bend)
    assert together.mean.shape == (4, 2, 2)
    for i in np.ndindex(4, 2):
        alone = rule(Gaussian(means[i], cov), bend)
        for found, expected in zip(together[:3], alone[:3], strict=True):
            close(found[i], expected, 1e-12)
    covs = np.stack([random_covariance(rng, 3) for _ in range(5)])
    together = rule(Gaussian(means[0, 0], covs), bend)
    for i in range(5):
        close(together.cov[i], rule(Gaussian(means[0, 0], covs[i]), bend).cov, 1e-12)


@pytest.mark.parametrize("rule", [unscented(2), unscented(2, 0.01), cubature(2)])
def test_an_angle_may_jump(rule):
    # Due west of the origin the bearing jumps from π to −π. Turned by half a circle the same thing does not jump.
    def bearing(x):
        return np.arctan2(x[..., 1:], x[..., :1])

    def difference(z, expected):
        return (z - expected + np.pi) % (2 * np.pi) - np.pi

    cov = np.array([[0.1, 0.02], [0.02, 0.3]])
    west = rule(Gaussian([-5, 0.1], cov), bearing, difference=difference)
    east = rule(Gaussian([5, -0.1], cov), bearing)
    rounding = 1e-15 * rule.weight * 2  # the weights multiply the rounding errors of angles near π
    np.testing.assert_allclose(difference(west.mean - np.pi, east.mean), 0, atol=rounding)
    np.testing.assert_allclose(west.cov, east.cov, rtol=1e-9)
    np.testing.assert_allclose(west.cross, -east.cross, atol=rounding)


@pytest.mark.parametrize("rule", RULES)
def test_slope_basis_and_rest_are_the_same_moments_in_parts(rule):
    belief = random_belief(np.random.default_rng(6), 3)
    out = rule(belief, bend)
    close(out.basis @ out.basis.T, belief.cov, 1e-12)
    close(out.basis @ out.slope.T, out.cross, 1e-12)
    close(out.slope @ out.slope.T + out.rest, out.cov, 1e-12)


@pytest.mark.parametrize("rule", [unscented, cubature])
def test_a_rule_needs_a_number_of_states(rule):
    for n in (0, -1, 1.5, "2"):
        with pytest.raises(ValueError, match="n must be a whole number of at least 1"):
            rule(n)
