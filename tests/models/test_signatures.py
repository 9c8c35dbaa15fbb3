"""What functions of a model take, by their parameters: x, x and u, or x, u and k."""

from functools import partial, wraps

import numpy as np
import pytest

from kflearn import Gaussian, NonlinearModel, correct, extended_kalman_filter, predict, simulate
from kflearn.models.signatures import Takes, takes


class Sensor:
    def __call__(self, x, u):
        return x

    def method(self, x, u, k):
        return x


def plain(x):
    return x


@wraps(plain)
def told(*args):
    return plain(*args)


def untold(*args):
    return plain(*args)


FUNCTIONS = {
    "x": (plain, Takes(1)),
    "x and u": (lambda x, u: x, Takes(2, True)),
    "three": (lambda x, u, k: x, Takes(3)),
    "four": (lambda x, u, k, more: x, Takes(3)),
    "its own default": (lambda x, place=3: x, Takes(1)),
    "u may be given": (lambda x, u=None: x, Takes(2)),
    "u and k may be given": (lambda x, u=None, k=0: x, Takes(3)),
    "u, and its own default": (lambda x, v, dt=0.1: x, Takes(2, True)),
    "k alone": (lambda x, k=0: x, Takes(1)),
    "any number": (lambda x, *u: x, Takes(2)),
    "any number after u": (lambda x, u, *more: x, Takes(2, True)),
    "keywords": (lambda x, *, place=3, **more: x, Takes(1)),
    "positions": (lambda x, u, /: x, Takes(2, True)),
    "nothing at all": (lambda: 1, Takes(1)),
    "partial": (partial(lambda x, u, k: x, k=3), Takes(2, True)),
    "partial from the left": (partial(lambda place, x: x, 3), Takes(1)),
    "object": (Sensor(), Takes(2, True)),
    "method": (Sensor().method, Takes(3)),
    "decorated": (told, Takes(1)),
    "decorated, not told": (untold, Takes(1)),
    "vectorized": (np.vectorize(plain), Takes(1)),
    "ufunc": (np.sin, Takes(1)),
    "ufunc of two": (np.add, Takes(2, True)),
    "compiled": (np.array, Takes(1)),
    "no function": (None, Takes(1)),
}


@pytest.mark.parametrize(("function", "expected"), FUNCTIONS.values(), ids=FUNCTIONS)
def test_what_a_function_takes(function, expected):
    assert takes(function) == expected
    assert takes(function, 2) == (Takes(2) if function is untold or isinstance(function, np.vectorize) else expected)


def model_of(f, h, **more):
    return NonlinearModel(f, h, np.eye(2), 1.0, **more)


X, U = np.array([3.0, 4.0]), np.array([10.0])


def test_a_model_gives_each_function_what_it_takes():
    fs = {lambda x: x: 0, lambda x, u: x + u: 10, lambda x, u, k: x + u + k: 17}
    hs = {lambda x: x[..., :1]: 0, lambda x, u: x[..., :1] + u: 10, lambda x, u, k: x[..., :1] + u + k: 17}
    for f, pushed in fs.items():
        for h, seen in hs.items():
            model = model_of(f, h)
            if pushed or seen:  # else u is an input for nothing
                np.testing.assert_array_equal(model.move(X, U, 7), X + pushed)
            np.testing.assert_array_equal(model.measure(X, U, 7), X[:1] + seen)
    np.testing.assert_array_equal(model_of(lambda x, u, k: x + k, lambda x: x[..., :1]).move(X, k=7), X + 7)
    np.testing.assert_array_equal(model_of(lambda x, *u: x + sum(u), plain).move(X, U), X + 10)
    np.testing.assert_array_equal(model_of(untold, lambda x, u: x[..., :1]).move(X), X)


def test_a_jacobian_takes_its_own_number():
    model = model_of(
        lambda x, u, k: (k + 1) * x * u,
        lambda x, u: x[..., :1] * u,
        F_jacobian=lambda x, u, k: (k + 1) * u[..., None] * np.eye(2),
        H_jacobian=lambda x: np.array([[10.0, 0.0]]),
    )
    by_differences = model.replace(F_jacobian=None, H_jacobian=None)
    for each in (model, by_differences):
        np.testing.assert_allclose(each.move_slope(X, U, 2), 30 * np.eye(2), atol=1e-7)
        np.testing.assert_allclose(each.measure_slope(X, U, 2), [[10, 0]], atol=1e-7)
    constant = model.replace(F_jacobian=lambda x: np.eye(2))
    np.testing.assert_array_equal(constant.move_slope(X, U, 2), np.eye(2))


def test_a_missing_input_is_named():
    moving = model_of(plain, lambda x, u: x[..., :1] + u)
    start, z = Gaussian(X, np.eye(2)), np.ones(3)
    slope = model_of(plain, lambda x: x[..., :1], H_jacobian=lambda x, u: np.ones((1, 2)))
    for model, name in ((moving, "h"), (slope, "H_jacobian")):
        for call in (
            lambda model=model: extended_kalman_filter(model, z, start),
            lambda model=model: correct(model, start, 1.0),
            lambda model=model: simulate(model, X, 3),
        ):
            with pytest.raises(ValueError, match=rf"^u must be given: {name}\(x, u\) takes it"):
                call()
    with pytest.raises(ValueError, match=r"^u must be given"):
        moving.measure(X)
    assert moving.replace(h=lambda x, u=None: x[..., :1]).measure(X) == 3
    correct(moving, predict(moving, start, 1.0), 2.0, u=1.0)


def test_an_input_that_nothing_takes_is_refused():
    with pytest.raises(ValueError, match=r"^f must return shape"):
        extended_kalman_filter(model_of(plain, lambda x: x[..., :1]), np.ones(3), Gaussian(X, np.eye(2)), np.ones(3))
