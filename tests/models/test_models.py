import copy
import pickle

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    LinearModel,
    NonlinearModel,
    cart,
    constant_acceleration,
    constant_velocity,
    kalman_filter,
    numerical_jacobian,
    random_walk,
    singer,
)
from kflearn.models.state_space import stacks, step_matrix


def test_plain_numbers_are_one_by_one_matrices():
    model = LinearModel(F=1, H=2, Q=3, R=4, B=5)
    assert [M.item() for M in (model.F, model.H, model.Q, model.R, model.B)] == [1, 2, 3, 4, 5]
    assert all(M.shape == (1, 1) for M in (model.F, model.H, model.Q, model.R, model.B))
    assert (model.n, model.m, model.p) == (1, 1, 1)


def test_sizes():
    model = LinearModel(np.eye(3), np.ones((2, 3)), np.zeros((3, 3)), np.eye(2))
    assert (model.n, model.m, model.p) == (3, 2, 0)
    assert stacks(model) == {}
    stacked = model.replace(F=np.ones((7, 1, 1)) * np.eye(3))
    assert (stacked.n, stacked.m) == (3, 2)
    assert list(stacks(stacked)) == ["F"]


def test_the_callers_matrices_are_copied_and_the_copies_are_read_only():
    F, Q = np.eye(2), np.eye(2)
    model = LinearModel(F, np.eye(2), Q, np.eye(2))
    F[:] = Q[:] = 9
    np.testing.assert_array_equal(model.F, np.eye(2))
    np.testing.assert_array_equal(model.Q, np.eye(2))
    with pytest.raises(ValueError, match="read-only"):
        model.Q[0, 0] = 9
    with pytest.raises(AttributeError):
        model.Q = Q


def test_whole_numbers_become_real_ones():
    assert LinearModel(1, 1, 1, 1).replace(R=[[2]]).R.dtype == float


def test_replace_keeps_the_rest_and_checks():
    model = constant_velocity(0.5, 2, 3)
    other = model.replace(R=7)
    assert other.R.item() == 7
    np.testing.assert_array_equal(other.F, model.F)
    assert model.R.item() == 3
    bent = NonlinearModel(np.sin, np.cos, 1, 1, residual=np.subtract)
    assert bent.replace(h=np.tan).h is np.tan
    assert bent.replace(h=np.tan).residual is np.subtract


def test_the_matrix_of_a_step():
    stack = np.arange(12.0).reshape(3, 2, 2)
    np.testing.assert_array_equal(step_matrix(stack, 2), stack[2])
    np.testing.assert_array_equal(step_matrix(stack[:1], 2), stack[0])
    np.testing.assert_array_equal(step_matrix(stack[0], 2), stack[0])
    runs = np.arange(24.0).reshape(2, 3, 2, 2)
    np.testing.assert_array_equal(step_matrix(runs, 1), runs[:, 1])


@pytest.mark.parametrize("batch", [(), (5,), (4, 5)])
def test_a_linear_model_moves_and_measures_by_its_matrices(batch):
    rng = np.random.default_rng(0)
    F, H, B = (rng.normal(size=(3, *shape)) for shape in ((2, 2), (1, 2), (2, 3)))
    model = LinearModel(F, H, np.eye(2), 1, B)
    x, u = rng.normal(size=(*batch, 2)), rng.normal(size=(*batch, 3))
    np.testing.assert_allclose(model.move(x, k=1), np.einsum("ij,...j", F[1], x))
    np.testing.assert_allclose(model.move(x, u, k=2), np.einsum("ij,...j", F[2], x) + np.einsum("ij,...j", B[2], u))
    np.testing.assert_allclose(model.measure(x, k=2), np.einsum("ij,...j", H[2], x))
    np.testing.assert_array_equal(model.move_slope(x, u, 1), F[1])
    np.testing.assert_array_equal(model.measure_slope(x, u, 1), H[1])


def test_random_walk():
    model = random_walk(np.diag([1, 2]), np.eye(2))
    np.testing.assert_array_equal(model.F, np.eye(2))
    np.testing.assert_array_equal(model.H, np.eye(2))
    np.testing.assert_array_equal(model.Q, np.diag([1, 2]))


def test_constant_velocity():
    dt, sigma = 0.5, 3.0
    model = constant_velocity(dt, sigma, 2)
    np.testing.assert_array_equal(model.F, [[1, dt], [0, 1]])
    np.testing.assert_array_equal(model.H, [[1, 0]])
    np.testing.assert_allclose(model.Q, sigma**2 * np.array([[dt**4 / 4, dt**3 / 2], [dt**3 / 2, dt**2]]))
    assert model.R.item() == 2


def test_cart_follows_newton():
    model = cart(dt=2.0, mass=4.0, Q=np.zeros((2, 2)), R=1)
    # From 5 m and 3 m/s, pushed with 8 N for 2 s: 5 + 3·2 + 8/(2·4)·2² = 15 m, 3 + 8/4·2 = 7 m/s.
    np.testing.assert_allclose(model.move(np.array([5.0, 3.0]), np.array([8.0])), [15, 7])


def polar(x):
    return np.stack([np.hypot(x[..., 0], x[..., 1]), np.arctan2(x[..., 1], x[..., 0])], axis=-1)


def polar_slope(x):
    X, Y = x[..., 0], x[..., 1]
    r = np.hypot(X, Y)
    return np.stack([np.stack([X / r, Y / r], -1), np.stack([-Y / r**2, X / r**2], -1)], -2)


@pytest.mark.parametrize("batch", [(), (6,), (3, 6)])
def test_numerical_jacobian(batch):
    x = np.random.default_rng(1).normal([3.0, 0.0], 1, size=(*batch, 2))
    found = numerical_jacobian(polar, x)
    assert found.shape == (*batch, 2, 2)
    np.testing.assert_allclose(found, polar_slope(x), atol=1e-9)


def test_numerical_jacobian_takes_lists_and_functions_of_other_lengths():
    np.testing.assert_allclose(numerical_jacobian(lambda x: x[..., :1] * x[..., 1:], [2, 3]), [[3, 2]], atol=1e-9)


def test_numerical_jacobian_of_small_states_needs_their_size():
    x = np.array([3e-9, 4e-9])  # 3 and 4 m, in another unit
    np.testing.assert_allclose(numerical_jacobian(polar, x, scale=[1e-9, 1e-9]), polar_slope(x), rtol=1e-9)
    assert abs(numerical_jacobian(polar, x)[1, 0] / polar_slope(x)[1, 0]) < 0.01  # the step jumps far beyond them
    model = NonlinearModel(polar, polar, np.eye(2), np.eye(2), scale=1e-9)
    np.testing.assert_allclose(model.move_slope(x), polar_slope(x), rtol=1e-9)
    np.testing.assert_allclose(model.replace(R=2 * np.eye(2)).measure_slope(x), polar_slope(x), rtol=1e-9)


def test_numerical_jacobian_across_the_jump_of_an_angle():
    def difference(z, expected):
        return (z - expected + np.pi) % (2 * np.pi) - np.pi

    x = np.array([-2.0, 0.0])  # due west: a little north is +π, a little south −π
    np.testing.assert_allclose(numerical_jacobian(polar, x, difference), [[-1, 0], [0, -0.5]], atol=1e-9)
    model = NonlinearModel(lambda x: x, polar, np.eye(2), np.eye(2), residual=difference)
    np.testing.assert_allclose(model.measure_slope(x), [[-1, 0], [0, -0.5]], atol=1e-9)
    assert abs(numerical_jacobian(polar, x)[1, 1]) > 1e5  # without it


@pytest.mark.parametrize("batch", [(), (6,), (3, 6)])
def test_slopes_of_a_nonlinear_model_with_control_input(batch):
    def f(x, u):
        return np.stack([x[..., 0] * u[..., 0], x[..., 1] ** 2 + u[..., 1]], axis=-1)

    rng = np.random.default_rng(2)
    x, u = rng.normal(size=(*batch, 2)), rng.normal(size=(*batch, 2))
    model = NonlinearModel(f, lambda x: x[..., :1] ** 3, np.eye(2), 1)
    exact = np.zeros((*batch, 2, 2))
    exact[..., 0, 0], exact[..., 1, 1] = u[..., 0], 2 * x[..., 1]
    np.testing.assert_allclose(model.move_slope(x, u), exact, atol=1e-8)
    np.testing.assert_allclose(model.measure_slope(x)[..., 0, 0], 3 * x[..., 0] ** 2, atol=1e-8)
    given = model.replace(F_jacobian=lambda x, u: exact, H_jacobian=lambda x: np.ones((1, 2)))
    assert given.move_slope(x, u) is exact
    np.testing.assert_array_equal(given.measure_slope(x), [[1, 1]])


def test_the_difference_of_measurements():
    plain = NonlinearModel(np.sin, np.sin, 1, 1)
    assert plain.difference(3.0, 1.0) == 2
    assert plain.replace(residual=lambda z, expected: 42).difference(3.0, 1.0) == 42


def test_constant_acceleration_and_singer():
    # A Singer acceleration that hardly fades is nearly constant; one that fades at once is nearly white.
    ca, slow = constant_acceleration(0.5, 0.3, 2.0), singer(0.5, 1e-6, 0.3, 2.0)
    np.testing.assert_allclose(slow.F, ca.F, atol=1e-6)
    np.testing.assert_allclose(ca.Q[-1, -1], 0.3**2)
    np.testing.assert_allclose(ca.Q, ca.Q[:, -1:] * ca.Q[-1:] / ca.Q[-1, -1])
    fast = singer(0.01, 1e4, 2.0, 1.0)
    np.testing.assert_allclose(fast.F[2, 2], np.exp(-100), rtol=1e-9)
    np.testing.assert_allclose(fast.Q[2, 2], 4.0, rtol=1e-9)


@pytest.mark.parametrize("rate", [1e-3, 0.1, 1.0, 30.0])
def test_singer_noise_is_what_small_steps_add_up_to(rate):
    # Two halves of a step must give the whole, and the acceleration's variance must stay where it is.
    whole, half = singer(2.0, rate, 3.0, 1.0), singer(1.0, rate, 3.0, 1.0)
    np.testing.assert_allclose(half.F @ half.F, whole.F, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(half.F @ half.Q @ half.F.T + half.Q, whole.Q, rtol=1e-8)
    steady = whole.F[2, 2] ** 2 * 9 + whole.Q[2, 2]
    np.testing.assert_allclose(steady, 9.0)


COPIES = [copy.copy, copy.deepcopy, lambda it: pickle.loads(pickle.dumps(it))]


@pytest.mark.parametrize("again", COPIES)
def test_copies_are_equal_and_read_only(again):
    linear = cart(0.1, 2.0, np.eye(2), 1)
    nonlinear = NonlinearModel(np.sin, polar, np.eye(2), np.eye(2), scale=[1, 2])
    for model, names in ((linear, "FHQRB"), (nonlinear, ["Q", "R", "scale"])):
        other = again(model)
        for name in names:
            np.testing.assert_array_equal(getattr(other, name), getattr(model, name))
            assert not getattr(other, name).flags.writeable
        x = np.array([3.0, 4.0])
        np.testing.assert_array_equal(other.move(x), model.move(x))
        np.testing.assert_array_equal(other.measure(x), model.measure(x))


def test_in_words():
    assert repr(constant_velocity(2, 0.5, 9)) == (
        "LinearModel with n = 2, m = 1, p = 0:\n  F = [[1, 2], [0, 1]], H = [[1, 0]], Q = [[1, 1], [1, 1]], R = 9"
    )
    pushed = cart(2, 4, np.eye(2), 1).replace(R=np.ones((5, 1, 1)))
    assert repr(pushed).endswith("B = [[0.5], [0.5]], Q = [[1, 0], [0, 1]], R = (5, 1, 1)")
    large = LinearModel(np.eye(4), np.eye(1, 4), np.eye(4), 1)
    assert repr(large).endswith("F = (4, 4), H = [[1, 0, 0, 0]], Q = (4, 4), R = 1")
    bent = NonlinearModel(lambda x: x, polar, np.eye(2), 0.01 * np.eye(2), H_jacobian=polar_slope, residual=np.subtract)
    assert repr(bent) == (
        "NonlinearModel with n = 2, m = 2:\n  f = <lambda>, h = polar, H_jacobian = polar_slope, residual = subtract, "
        "Q = [[1, 0], [0, 1]], R = [[0.01, 0], [0, 0.01]]"
    )


def test_standard_deviations_of_zero_are_allowed():
    for model in (constant_velocity(1, 0, 1), constant_acceleration(1, 0, 1), singer(1, 1, 0, 1)):
        assert not model.Q.any()


@pytest.mark.parametrize("huge", [1e12, 1e30, 1.7e308])
def test_a_huge_variance_stands_for_not_measured(huge):
    model = LinearModel(np.eye(2), np.eye(2), 0.01 * np.eye(2), np.diag([0.1, huge]))
    start = Gaussian([0, 0], np.eye(2))
    found = kalman_filter(model, [[1.0, 5.0], [1.1, 5.0]], start)
    expected = kalman_filter(model.replace(R=0.1 * np.eye(2)), [[1.0, np.nan], [1.1, np.nan]], start)
    np.testing.assert_allclose(found.mean, expected.mean, atol=20 / huge)
    np.testing.assert_allclose(found.cov, expected.cov, atol=20 / huge)


def test_a_sensor_without_noise_is_told_what_noise_it_has():
    with pytest.raises(ValueError, match="R must be positive definite, found 0 on its diagonal; no"):
        LinearModel(1, 1, 1, 0)
    with pytest.raises(ValueError, match=r"found 0 on its diagonal$"):
        Gaussian(1, 0).fuse(Gaussian(2, 0))
