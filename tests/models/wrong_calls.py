"""Good arguments, calls with one wrong one among them, and what the answer to a wrong call has to be."""

import copy
import re

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    LinearModel,
    NonlinearModel,
    adaptive_kalman_filter,
    extended_kalman_filter,
    imm_filter,
    kalman_filter,
    linearized_kalman_filter,
    schmidt_kalman_filter,
    unscented_kalman_filter,
)

NAMES = "id, call, name, fragment"
nan, inf = np.nan, np.inf
I2 = np.eye(2)


class Inputs:
    """Good arguments for a model of two states, one measurement and one control input, fresh for every call."""

    def __init__(self):
        self.F, self.H, self.Q, self.R = (
            np.array([[1.0, 1.0], [0.0, 1.0]]),
            np.array([[1.0, 0.0]]),
            np.eye(2),
            I2[:1, :1],
        )
        self.B, self.P, self.x, self.z, self.u = np.ones((2, 1)), np.eye(2), np.zeros(2), np.arange(5.0), np.ones(5)

    def model(self, **changes):
        return LinearModel(**{**dict(F=self.F, H=self.H, Q=self.Q, R=self.R), **changes})

    def pushed(self):
        return self.model(B=self.B)

    def bent(self, **changes):
        given = dict(f=lambda x: x, h=lambda x: x[..., :1], Q=self.Q, R=self.R)
        return NonlinearModel(**{**given, **changes})

    @property
    def start(self):
        return Gaussian(self.x, self.P)

    def track(self):
        return kalman_filter(self.model(), self.z, self.start)


def kf(a, model=None, z=None, initial=None, u=None):
    """The Kalman filter with one wrong argument."""
    z, initial = a.z if z is None else z, a.start if initial is None else initial
    return kalman_filter(a.model() if model is None else model, z, initial, u)


def ekf(a, u=None, **functions):
    return extended_kalman_filter(a.bent(**functions), a.z, a.start, u)


def imm(a, models=None, transition=((0.5, 0.5), (0.5, 0.5)), weights=(0.5, 0.5), z=None, initial=None, states=None):
    """The IMM filter with one wrong argument."""
    models, z = [a.model(), a.bent()] if models is None else models, a.z if z is None else z
    initial, chain = a.start if initial is None else initial, dict(transition=transition, mode_probabilities=weights)
    return imm_filter(models, z, initial, **chain, states=states)


def consider(a, considered):
    return schmidt_kalman_filter(a.model(), a.z, a.start, considered=considered)


def adaptive(a, **settings):
    return adaptive_kalman_filter(a.model(), a.z, a.start, **settings)


def lkf(a, nominal, z=None):
    return linearized_kalman_filter(a.bent(), a.z if z is None else z, a.start, nominal=nominal)


def ukf(a, model=None, **settings):
    return unscented_kalman_filter(a.model() if model is None else model, a.z, a.start, **settings)


def columns(x):
    """For one state it does, for many in rows it does not."""
    return np.array([x[0] + x[1], x[1]])


def overwrite(x):
    x[..., 0] += x[..., 1]
    return x


def stack(M, T):
    return np.broadcast_to(M, (T, *np.shape(M)))


def words(value):
    """The name of a test."""
    return value.replace(" ", "-") if isinstance(value, str) else ""


def refuses(call, name, fragment):
    """A wrong call is answered by one sentence that names the argument, what was found and what was expected."""
    inputs = Inputs()
    before = copy.deepcopy(vars(inputs))
    with pytest.raises((ValueError, TypeError)) as raised:
        call(inputs)
    message = str(raised.value)
    assert re.search(rf"(?<![\w.]){re.escape(name)}\b", message), f"does not name {name}: {message}"
    assert fragment in message
    assert "\n" not in message
    assert not re.search(r"[.!?]( |$)(?!\.)", message.replace("...,", "")), f"more than a sentence: {message}"
    assert len(message) < 250
    for argument, value in before.items():
        np.testing.assert_array_equal(getattr(inputs, argument), value)
