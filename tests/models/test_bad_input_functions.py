"""Functions of a model that do not keep to their contract: each is answered by one sentence."""

import numpy as np
import pytest

from kflearn import correct, cubature_kalman_filter, numerical_jacobian, predict, simulate
from tests.models.wrong_calls import NAMES, columns, ekf, nan, overwrite, refuses, ukf, words

FUNCTIONS = [
    ("f of wrong length", lambda a: ekf(a, f=lambda x: x[..., :1]), "f", "(..., 2), got (1,)"),
    ("f not broadcasting", lambda a: ukf(a, a.bent(f=columns)), "f", "(..., 2), got (2, 1, 2)"),
    ("f not broadcasting, EKF", lambda a: ekf(a, f=columns), "f", "(..., 2), got (2, 1, 2)"),
    ("f for columns", lambda a: ekf(a, f=lambda x: a.F @ x), "f", "(..., 2), got an error"),
    (
        "f for columns, many runs",
        lambda a: cubature_kalman_filter(a.bent(f=lambda x: a.F @ x), np.ones((7, 5, 1)), a.start),
        "f",
        "(..., 2), got an error",
    ),
    ("f without u", lambda a: ekf(a, a.u), "f", "(..., 2), got an error"),
    ("f needs u", lambda a: ukf(a, a.bent(f=lambda x, u: x + u)), "f", "(..., 2), got an error"),
    ("f returns nothing", lambda a: ekf(a, f=lambda x: None), "f", "(..., 2), got ()"),
    ("f returns NaN", lambda a: ekf(a, f=lambda x: x * nan), "f", "finite, found nan"),
    ("f returns complex", lambda a: ekf(a, f=lambda x: x * 1j), "f", "real numbers, found complex128"),
    ("f overwrites its argument", lambda a: ekf(a, f=overwrite), "f", "read-only"),
    ("h of wrong length", lambda a: ukf(a, a.bent(h=lambda x: x)), "h", "(..., 1), got (2,)"),
    ("h drops an axis", lambda a: ekf(a, h=lambda x: x[..., 0]), "h", "(..., 1), got ()"),
    (
        "h not broadcasting",
        lambda a: cubature_kalman_filter(a.bent(h=lambda x: x[:1]), a.z, a.start),
        "h",
        "(..., 1), got (1, 1, 2)",
    ),
    ("F_jacobian a vector", lambda a: ekf(a, F_jacobian=lambda x: x), "F_jacobian", "(..., 2, 2), got (2,)"),
    ("H_jacobian transposed", lambda a: ekf(a, H_jacobian=lambda x: a.H.T), "H_jacobian", "(..., 1, 2), got (2, 1)"),
    (
        "H_jacobian ragged",
        lambda a: ekf(a, H_jacobian=lambda x: np.array([[x[..., 0], 0]])),
        "H_jacobian",
        "got an error",
    ),
    (
        "residual drops an axis",
        lambda a: ekf(a, residual=lambda z, e: (z - e)[..., 0]),
        "residual",
        "(..., 1), got ()",
    ),
    ("Q for other states", lambda a: ekf(a, Q=np.eye(3)), "initial", "3 components like the model, got 2"),
    ("f predicting", lambda a: predict(a.bent(f=lambda x: x[..., :1]), a.start), "f", "(..., 2), got (1,)"),
    ("h correcting", lambda a: correct(a.bent(h=lambda x: x), a.start, 1.0), "h", "(..., 1), got (2,)"),
    ("f simulating", lambda a: simulate(a.bent(f=lambda x: x[..., :1]), a.x, 5), "f", "(..., 2), got (1,)"),
    ("f returns a list", lambda a: ekf(a, f=lambda x: x.tolist()), "f", "return an array, got a list"),
    ("h returns a tuple", lambda a: ekf(a, h=lambda x: (x[..., 0],)), "h", "got a tuple"),
    ("f needs two axes", lambda a: ekf(a, f=lambda x: (a.F @ x.T).T), "f", "(..., 2), got an error"),
    ("f needs a batch", lambda a: ekf(a, f=lambda x: x[:, :] @ a.F.T), "f", "(..., 2), got an error"),
    ("h at the start NaN", lambda a: ekf(a, h=lambda x: nan * x[..., :1]), "what h returns", "finite, found nan"),
    ("slope of a number", lambda a: numerical_jacobian(np.sin, 1.0), "x", "(any,), got the number 1"),
    ("slope of nothing", lambda a: numerical_jacobian(3, a.x), "function", "a function, got int"),
    ("slope of rows", lambda a: numerical_jacobian(columns, a.x), "function", "(..., m), got (2, 1, 2)"),
    ("slope at NaN", lambda a: numerical_jacobian(np.sin, [nan]), "x", "finite, found nan"),
    ("scale of a slope", lambda a: numerical_jacobian(np.sin, a.x, scale=0), "scale", "positive, of a size"),
]


@pytest.mark.parametrize(NAMES, FUNCTIONS, ids=words)
def test_wrong_call(id, call, name, fragment):
    refuses(call, name, fragment)
