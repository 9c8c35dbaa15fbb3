import copy
import pickle

import numpy as np
import pytest

from kflearn import Gaussian
from kflearn.core.matrices import root
from kflearn.models.gaussian import clip_variances, unchecked_gaussian


def test_plain_numbers_stand_for_one_component():
    belief = Gaussian(60, 5)
    assert belief.mean.shape == (1,)
    assert belief.cov.shape == (1, 1)
    assert belief.batch == ()
    np.testing.assert_allclose(belief.std, [np.sqrt(5)])


def test_one_covariance_serves_many_means():
    belief = Gaussian(np.zeros((7, 3, 2)), np.diag([4.0, 9.0]))
    assert belief.batch == (7, 3)
    assert belief.cov.shape == (2, 2)
    np.testing.assert_array_equal(belief.variance, [4, 9])
    np.testing.assert_array_equal(belief.std, [2, 3])


def test_the_callers_arrays_are_copied_and_the_copies_are_read_only():
    mean, cov = np.zeros(2), np.eye(2)
    belief = Gaussian(mean, cov)
    mean[0] = cov[0, 0] = 9
    np.testing.assert_array_equal(belief.mean, [0, 0])
    np.testing.assert_array_equal(belief.cov, np.eye(2))
    for array in (belief.mean, belief.cov):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1


def test_singular_and_zero_covariances_are_beliefs_too():
    for cov in (np.zeros((2, 2)), np.diag([1, 0]), np.ones((2, 2)), [[1e12, 1], [1, 1e-12]], np.diag([1e12, 1e-12])):
        np.testing.assert_array_equal(Gaussian([0, 0], cov).cov, cov)


@pytest.mark.parametrize(("rho", "fits"), [(0.999999, True), (1.0, True), (1.00001, False)])
def test_units_do_not_decide_what_a_covariance_is(rho, fits):
    for a, b in ((1, 1), (1e6, 1e-6), (1e-9, 1e-9), (1e9, 1)):
        cov = [[a * a, rho * a * b], [rho * a * b, b * b]]
        if fits:
            Gaussian([0, 0], cov)
        else:
            with pytest.raises(ValueError, match="cov must be positive semi-definite"):
                Gaussian([0, 0], cov)


def test_masked_entries_are_refused_like_nan():
    with pytest.raises(ValueError, match="mean must be finite, found nan"):
        Gaussian(np.ma.masked_array([1, 2], [False, True]), np.eye(2))


def test_fuse_is_the_carts_step():
    fused = Gaussian(60, 5).fuse(Gaussian(62, 1))
    np.testing.assert_allclose(fused.mean, [185 / 3], rtol=1e-14)
    np.testing.assert_allclose(fused.cov, [[5 / 6]], rtol=1e-14)


def test_fuse_by_the_formulas_10_to_14():
    mean, variance, other, second = 3.0, 2.0, 5.0, 0.7
    fused = Gaussian(mean, variance).fuse(Gaussian(other, second))
    np.testing.assert_allclose(fused.mean, [(mean * second + other * variance) / (variance + second)])
    np.testing.assert_allclose(fused.cov, [[variance * second / (variance + second)]])


def test_fuse_loses_no_digits_when_one_knows_nothing():
    fused = Gaussian(0, 1e12).fuse(Gaussian(5, 1e-6))
    np.testing.assert_allclose(fused.cov, [[1e-6]], rtol=1e-12)
    np.testing.assert_allclose(fused.mean, [5], rtol=1e-12)


def test_a_fused_covariance_is_symmetric_to_the_last_digit():
    rng = np.random.default_rng(5)
    A, B = rng.normal(size=(2, 200, 4, 4))
    cov = Gaussian(np.zeros(4), A @ A.mT).fuse(Gaussian(np.ones(4), B @ B.mT)).cov
    np.testing.assert_array_equal(cov, cov.mT)


def test_only_negative_variances_are_clipped():
    belief = unchecked_gaussian(np.zeros(3), np.diag([1e-12, -1e-16, 4.0]))
    assert clip_variances(belief) is belief
    np.testing.assert_array_equal(belief.cov, np.diag([1e-12, 0, 4.0]))


def test_what_is_negative_beyond_rounding_is_refused_with_its_step():
    for variance in (-4e-10, -3.9e-9):
        clip_variances(unchecked_gaussian(np.zeros(2), np.diag([variance, 4.0])))
    cov = np.array([np.eye(2)] * 6)
    cov[4, 1, 1] = -0.25
    with pytest.raises(ValueError, match=r"P must have no negative variances, found -0\.25 at step 4: sigma points"):
        clip_variances(unchecked_gaussian(np.zeros((6, 2)), cov), series=True)
    with pytest.raises(ValueError, match=r"found -0\.25: sigma points with kappa < 0 or beta < 2"):
        clip_variances(unchecked_gaussian(np.zeros((6, 2)), cov))
    with pytest.raises(ValueError, match=r"at step 0:"):
        clip_variances(unchecked_gaussian(np.zeros((3, 2, 2)), cov.reshape(3, 2, 2, 2)), series=True)


def test_what_is_handed_out_is_read_only():
    belief = Gaussian([1, 2], [[4, 1], [1, 9]])
    for result in (belief.fuse(belief), belief.marginal(0), belief.marginal([1, 0])):
        for array in (result.mean, result.cov, result.variance):
            with pytest.raises(ValueError, match="read-only"):
                array[...] = 0


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda it: pickle.loads(pickle.dumps(it))])
def test_copies_are_equal_and_read_only(again):
    for belief in (Gaussian([1, 2], np.eye(2)), Gaussian([1, 2], np.eye(2)).marginal([1, 0])):
        other = again(belief)
        np.testing.assert_array_equal(other.mean, belief.mean)
        np.testing.assert_array_equal(other.cov, belief.cov)
        for array in (other.mean, other.cov):
            assert not array.flags.writeable


def test_an_exact_opinion_wins():
    fused = Gaussian(1, 0).fuse(Gaussian(3, 4))
    np.testing.assert_array_equal(fused.mean, [1])
    np.testing.assert_array_equal(fused.cov, [[0]])


def test_fuse_runs_beside_each_other():
    means, variances = np.arange(6.0).reshape(3, 2, 1), np.arange(1.0, 4.0).reshape(3, 1, 1, 1)
    together = Gaussian(means, variances).fuse(Gaussian(1, 2))
    for i in range(3):
        for j in range(2):
            alone = Gaussian(means[i, j], variances[i, 0]).fuse(Gaussian(1, 2))
            np.testing.assert_allclose(together.mean[i, j], alone.mean)
            np.testing.assert_allclose(together.cov[i, 0], alone.cov)


def test_marginal():
    belief = Gaussian([1, 2, 3], [[4, 1, 0], [1, 9, 2], [0, 2, 16]])
    both = belief.marginal([2, 0])
    np.testing.assert_array_equal(both.mean, [3, 1])
    np.testing.assert_array_equal(both.cov, [[16, 0], [0, 4]])
    last = belief.marginal(-1)
    np.testing.assert_array_equal(last.mean, [3])
    np.testing.assert_array_equal(last.cov, [[16]])
    many = Gaussian(np.zeros((5, 3)), belief.cov).marginal([0, 1])
    assert many.mean.shape == (5, 2)
    np.testing.assert_array_equal(many.cov, [[4, 1], [1, 9]])


def test_samples_have_the_mean_and_the_covariance():
    cov = np.array([[4.0, -3.0], [-3.0, 9.0]])
    draws = Gaussian([1, -2], cov).sample(40_000, rng=1)
    assert draws.shape == (40_000, 2)
    np.testing.assert_allclose(draws.mean(axis=0), [1, -2], atol=4 * 3 / 200)
    np.testing.assert_allclose(np.cov(draws.T), cov, atol=4 * 9 * np.sqrt(2) / 200)


def test_samples_of_a_singular_gaussian_stay_on_its_line():
    draws = Gaussian([1, 2], [[1, 3], [3, 9]]).sample(100, rng=0)
    np.testing.assert_allclose(draws[:, 1] - 2, 3 * (draws[:, 0] - 1), atol=1e-7)
    assert draws[:, 0].std() > 0.8


def test_sample_shapes_and_seeds():
    belief = Gaussian(np.zeros((4, 2)), np.eye(2))
    assert belief.sample().shape == (4, 2)
    assert belief.sample(3, rng=0).shape == (3, 4, 2)
    assert belief.sample((3, 5), rng=0).shape == (3, 5, 4, 2)
    assert Gaussian(np.zeros(2), np.ones((6, 1, 1)) * np.eye(2)).sample(rng=0).shape == (6, 2)
    np.testing.assert_array_equal(belief.sample(3, rng=7), belief.sample(3, rng=7))
    generator = np.random.default_rng(7)
    np.testing.assert_array_equal(belief.sample(3, rng=generator), belief.sample(3, rng=7))
    assert (belief.sample(3, rng=generator) != belief.sample(3, rng=7)).all()


@pytest.mark.parametrize("sigmas", [1, 2, 3.5])
def test_ellipse_is_the_contour(sigmas):
    belief = Gaussian([1, 2], [[4, 1], [1, 2]])
    contour = belief.ellipse(sigmas, points=40)
    assert contour.shape == (40, 2)
    np.testing.assert_allclose(contour[0], contour[-1], atol=1e-12)
    error = contour - belief.mean
    np.testing.assert_allclose(np.sum(error @ np.linalg.inv(belief.cov) * error, axis=-1), sigmas**2)
    assert Gaussian(np.zeros((5, 2)), np.eye(2)).ellipse().shape == (5, 61, 2)


def test_in_words():
    assert f"{Gaussian(185 / 3, 5 / 6):.3f}" == "N(61.667, 0.833)"
    assert f"{Gaussian([1, 2], np.eye(2)):.1f}" == "N([1.0, 2.0], [[1.0, 0.0], [0.0, 1.0]])"
    assert repr(Gaussian(1 / 3, 1)) == "N(0.333333, 1)"
    batch = Gaussian(np.arange(14.0).reshape(7, 2), np.eye(2))
    assert repr(batch) == "Gaussian with n = 2 and batch axes (7,); the first is N([0, 1], [[1, 0], [0, 1]])"
    many = Gaussian(np.arange(12.0), np.diag(np.arange(12.0) ** 2))
    told = "[0, 1, 2, 3, 4, 5, 6, 7, 8, …]"
    assert repr(many) == f"Gaussian with n = 12: mean {told}, std {told}"
    runs = Gaussian(np.zeros(2), np.ones((5, 1, 1)) * np.eye(2))
    assert repr(runs) == "Gaussian with n = 2 and batch axes (5,); the first is N([0, 0], [[1, 0], [0, 1]])"


def test_a_root_gives_back_the_covariance():
    rng = np.random.default_rng(3)
    A = rng.normal(size=(5, 3, 2))
    for P in (A @ A.mT, A @ A.mT + np.eye(3), np.zeros((2, 2)), np.diag([4.0, 0.0])):
        L = root(P)
        np.testing.assert_allclose(L @ L.mT, P, atol=1e-13)
    scale = np.array([1e6, 1.0, 1e-6])
    P = np.outer(scale, scale) * (A @ A.mT)[0]  # singular, in wildly different units
    L = root(P)
    np.testing.assert_allclose(L @ L.T / np.outer(scale, scale), (A @ A.mT)[0], atol=1e-13)
