"""Wrong calls: each is answered by one sentence that names the argument, what was found and what was expected."""

import copy
import re

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    LinearModel,
    NonlinearModel,
    adaptive_kalman_filter,
    cart,
    chi_square_interval,
    constant_acceleration,
    constant_velocity,
    correct,
    coverage,
    cubature_kalman_filter,
    extended_kalman_filter,
    homing,
    imm_filter,
    kalman_filter,
    kalman_step,
    linearized_kalman_filter,
    mmae_filter,
    nees,
    nis,
    predict,
    random_walk,
    rmse,
    rts_smoother,
    scenarios,
    schmidt_kalman_filter,
    simulate,
    singer,
    square_root_kalman_filter,
    start_from,
    two_filter_smoother,
    unscented_kalman_filter,
    video,
    whiteness,
)

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
    return imm_filter(models, z, a.start if initial is None else initial, transition, weights, states=states)


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


NAMES = "id, call, name, fragment"
MODELS = [
    ("F not square", lambda a: a.model(F=[[1, 1]]), "F", "square, got shape (1, 2)"),
    ("F a row", lambda a: a.model(F=[1, 1]), "F", "got shape (2,)"),
    ("F with NaN", lambda a: a.model(F=[[1, nan], [0, 1]]), "F", "finite, found nan"),
    ("F infinite", lambda a: a.model(F=[[1, inf], [0, 1]]), "F", "finite, found inf"),
    ("F text", lambda a: a.model(F="unit matrix"), "F", "real numbers, found text"),
    ("F None", lambda a: a.model(F=None), "F", "real numbers, found NoneType"),
    ("F object", lambda a: a.model(F=object()), "F", "real numbers, found object"),
    ("F complex", lambda a: a.model(F=1j * a.F), "F", "real numbers, found complex128"),
    ("F complex, masked", lambda a: a.model(F=np.ma.array(1j * a.F)), "F", "real numbers, found complex128"),
    (
        "F of dates, masked",
        lambda a: a.model(F=np.ma.array(a.F.astype("M8[s]"))),
        "F",
        "real numbers, found datetime64",
    ),
    ("F long, masked", lambda a: a.model(F=np.ma.array([[10**400]])), "F", "real numbers, found MaskedArray"),
    ("F masked in part", lambda a: a.model(F=[[np.ma.array(1, mask=True)]]), "F", "real numbers, found a masked one"),
    ("F ragged", lambda a: a.model(F=[[1, 1], [1]]), "F", "rows have different lengths"),
    ("F empty", lambda a: a.model(F=[[]]), "F", "not be empty, got shape (1, 0)"),
    ("H transposed", lambda a: a.model(H=a.H.T), "H", "(any, 2), got (2, 1)"),
    ("H a row", lambda a: a.model(H=[1, 0]), "H", "got shape (2,)"),
    ("H for other states", lambda a: a.model(H=[[1, 0, 0]]), "H", "(any, 2), got (1, 3)"),
    ("H a number", lambda a: a.model(H=1), "H", "(any, 2), got the number 1"),
    ("B of wrong length", lambda a: a.model(B=np.ones((3, 1))), "B", "(2, any), got (3, 1)"),
    ("Q of wrong size", lambda a: a.model(Q=np.eye(3)), "Q", "(2, 2), got (3, 3)"),
    ("Q a number", lambda a: a.model(Q=0.1), "Q", "(2, 2), got the number 0.1"),
    ("Q lopsided", lambda a: a.model(Q=[[1, 0.5], [0, 1]]), "Q", "symmetric"),
    ("Q lopsided in small units", lambda a: a.model(Q=[[1e12, 0.5], [-0.5, 1e-6]]), "Q", "symmetric"),
    ("Q with negative variance", lambda a: a.model(Q=np.diag([1, -0.5])), "Q", "semi-definite, found -0.5"),
    ("Q of wild scales", lambda a: a.model(Q=np.diag([1e12, -0.5])), "Q", "semi-definite, found -0.5"),
    ("Q of wild scales, correlated", lambda a: a.model(Q=[[1e12, 2], [2, 1e-12]]), "Q", "eigenvalue -1"),
    ("Q with correlation 2", lambda a: a.model(Q=[[1, 2], [2, 1]]), "Q", "eigenvalue -1"),
    ("Q correlated with nothing", lambda a: a.model(Q=[[0, 1e-3], [1e-3, 1]]), "Q", "semi-definite"),
    ("Q bad in one step", lambda a: a.model(Q=np.stack([I2, -I2])), "Q", "semi-definite, found -1"),
    ("R zero", lambda a: a.model(R=0), "R", "positive definite, found 0"),
    ("R negative", lambda a: a.model(R=-30), "R", "positive definite, found -30"),
    ("R singular", lambda a: a.model(H=I2, R=np.ones((2, 2))), "R", "positive definite"),
    ("R half zero", lambda a: a.model(H=I2, R=np.diag([1, 0])), "R", "positive definite, found 0"),
    ("R of wrong size", lambda a: a.model(R=I2), "R", "(1, 1), got (2, 2)"),
    ("R a number for two", lambda a: a.model(H=I2, R=4), "R", "(2, 2), got the number 4"),
    ("R infinite", lambda a: a.model(R=inf), "R", "finite, found inf"),
    ("replaced by nonsense", lambda a: a.model().replace(R=-1), "R", "positive definite, found -1"),
    ("Q of a walk", lambda a: random_walk(-1, 1), "Q", "semi-definite, found -1"),
    ("R of a walk", lambda a: random_walk(1, I2), "R", "(1, 1), got (2, 2)"),
    ("dt zero", lambda a: constant_velocity(0, 1, 1), "dt", "positive, got 0"),
    ("dt without a square", lambda a: constant_velocity(1e200, 1, 1), "dt", "between 1e-150 and 1e150, got 1e+200"),
    ("dt a vector", lambda a: constant_velocity([1, 1], 1, 1), "dt", "single number, got shape (2,)"),
    ("acceleration text", lambda a: constant_velocity(1, "fast", 1), "acceleration", "found text"),
    ("massless cart", lambda a: cart(1, 0, I2, 1), "mass", "positive, got 0"),
    ("f no function", lambda a: a.bent(f=I2), "f", "a function, got ndarray"),
    ("h no function", lambda a: a.bent(h=None), "h", "a function, got NoneType"),
    ("Jacobian no function", lambda a: a.bent(H_jacobian=a.H), "H_jacobian", "a function, got ndarray"),
    ("scale zero", lambda a: a.bent(scale=[1, 0]), "scale", "positive, of a size between 1e-150 and 1e150, found 0"),
    ("scale of three", lambda a: a.bent(scale=[1, 1, 1]), "scale", "shape (2,), got (3,)"),
    ("residual no function", lambda a: a.bent(residual=1), "residual", "a function, got int"),
]
BELIEFS = [
    ("mean text", lambda a: Gaussian("high", 1), "mean", "found text"),
    ("mean with NaN", lambda a: Gaussian([0, nan], I2), "mean", "finite, found nan"),
    ("P of wrong size", lambda a: Gaussian([1, 2], np.eye(3)), "cov", "(2, 2), got (3, 3)"),
    ("P a number for two", lambda a: Gaussian([1, 2], 4), "cov", "(2, 2), got the number 4"),
    ("P lopsided", lambda a: Gaussian([1, 2], [[1, 2], [0, 9]]), "cov", "symmetric"),
    ("P negative", lambda a: Gaussian(1, -4), "cov", "semi-definite, found -4"),
    ("P of wild scales", lambda a: Gaussian([1, 2], np.diag([1e12, -0.5])), "cov", "semi-definite, found -0.5"),
    ("P does not broadcast", lambda a: Gaussian(np.ones((4, 1)), np.ones((3, 1, 1))), "cov", "mean (4,), cov (3,)"),
    ("fused with a number", lambda a: a.start.fuse(1.0), "other", "a Gaussian, got float"),
    ("fused with another length", lambda a: a.start.fuse(Gaussian(0, 1)), "other", "2 components, got 1"),
    ("fused with other runs", lambda a: Gaussian([[0]] * 3, 1).fuse(Gaussian([[0]] * 4, 1)), "other", "other (4,)"),
    ("two exact opinions", lambda a: Gaussian(0, 0).fuse(Gaussian(1, 0)), "cov", "positive definite, found 0"),
    ("no such component", lambda a: a.start.marginal(2), "indices", "below 2, got 2"),
    ("component masked", lambda a: a.start.marginal(np.ma.array([85], mask=True)), "indices", "below 2, got masked"),
    ("components in rows", lambda a: a.start.marginal([[0], [0, 1]]), "indices", "below 2, got [[0], [0, 1]]"),
    ("component by name", lambda a: a.start.marginal("x"), "indices", "got 'x'"),
    ("ellipse of one", lambda a: Gaussian(0, 1).ellipse(), "ellipse", "2 components, this Gaussian has 1"),
]
FILTERS = [
    ("z empty", lambda a: kf(a, z=[]), "z", "not be empty, got shape (0,)"),
    ("z a number", lambda a: kf(a, z=1.0), "z", "(..., T, 1), got the number 1"),
    ("z two wide", lambda a: kf(a, z=np.ones((5, 2))), "z", "(..., T, 1), got (5, 2)"),
    ("z a row for two", lambda a: kf(a, a.model(H=I2, R=I2)), "z", "(..., T, 2), got (5,)"),
    ("z infinite", lambda a: kf(a, z=[1, inf]), "z", "only NaN may mark"),
    ("z with None", lambda a: kf(a, z=[1.0, None]), "z", "found NoneType"),
    ("z text", lambda a: kf(a, z=["1", "2"]), "z", "found text"),
    ("z ragged", lambda a: kf(a, z=[[1], [1, 2]]), "z", "different lengths"),
    ("no model", lambda a: kf(a, a.F), "model", "a LinearModel, got ndarray"),
    ("nonlinear model", lambda a: kf(a, a.bent()), "model", "LinearModel, got NonlinearModel"),
    ("EKF without model", lambda a: extended_kalman_filter(None, a.z, a.start), "model", "got NoneType"),
    ("UKF without model", lambda a: unscented_kalman_filter(a.F, a.z, a.start), "model", "got ndarray"),
    ("CKF without model", lambda a: cubature_kalman_filter(np.sin, a.z, a.start), "model", "got ufunc"),
    ("initial an array", lambda a: kf(a, initial=a.x), "initial", "a Gaussian, got ndarray"),
    ("initial a track", lambda a: kf(a, initial=a.track()), "initial", "a Gaussian, got Track"),
    ("initial too short", lambda a: kf(a, initial=Gaussian(0, 1)), "initial", "2 components"),
    ("initial and u swapped", lambda a: kalman_filter(a.pushed(), a.z, a.u, a.start), "initial", "got ndarray"),
    ("u without B", lambda a: kf(a, u=a.u), "u", "no B"),
    ("u too short", lambda a: kf(a, a.pushed(), u=a.u[:4]), "u", "5 steps"),
    ("u too wide", lambda a: kf(a, a.pushed(), u=np.ones((5, 2))), "u", "(..., T, 1), got (5, 2)"),
    ("u with a gap", lambda a: kf(a, a.pushed(), u=[1, 1, nan, 1, 1]), "u", "finite, found nan"),
    ("u a number", lambda a: kf(a, a.pushed(), u=1.0), "u", "(..., T, 1), got the number 1"),
    ("F too short", lambda a: kf(a, a.model(F=stack(a.F, 4))), "F", "5 steps, or 1, got shape (4, 2, 2)"),
    ("R too long", lambda a: kf(a, a.model(R=stack(a.R, 6))), "R", "5 steps, or 1, got shape (6, 1, 1)"),
    ("Q of an EKF too short", lambda a: ekf(a, Q=stack(I2, 2)), "Q", "5 steps"),
    (
        "runs of z and start",
        lambda a: kalman_filter(a.model(), np.ones((3, 5, 1)), Gaussian(np.zeros((4, 2)), I2)),
        "initial",
        "z (3,), initial (4,)",
    ),
    (
        "runs of z and u",
        lambda a: kalman_filter(a.pushed(), np.ones((3, 5, 1)), a.start, np.ones((4, 5, 1))),
        "u",
        "z (3,), u (4,)",
    ),
    (
        "runs of z and P",
        lambda a: extended_kalman_filter(a.model(), np.ones((3, 5, 1)), Gaussian(a.x, stack(I2, 4))),
        "initial",
        "z (3,), initial (4,)",
    ),
    (
        "runs of z and Q",
        lambda a: kalman_filter(a.model(Q=stack(stack(I2, 1), 4)), np.ones((3, 5, 1)), a.start),
        "Q",
        "z (3,), Q (4,)",
    ),
    ("alpha zero", lambda a: ukf(a, alpha=0), "alpha", "positive, got 0"),
    ("alpha without a square", lambda a: ukf(a, alpha=5e-324), "alpha", "between 1e-150 and 1e150, got 4.94066e-324"),
    ("alpha text", lambda a: ukf(a, alpha="small"), "alpha", "found text"),
    ("beta NaN", lambda a: ukf(a, beta=nan), "beta", "finite, found nan"),
    ("kappa too low", lambda a: ukf(a, kappa=-2), "kappa", "than -2"),
]
FUNCTIONS = [
    ("f of wrong length", lambda a: ekf(a, f=lambda x: x[..., :1]), "f", "(..., 2), got (3, 1)"),
    ("f not broadcasting", lambda a: ukf(a, a.bent(f=columns)), "f", "(..., 2), got (2, 2)"),
    ("f not broadcasting, EKF", lambda a: ekf(a, f=columns), "f", "(..., 2), got (2, 2)"),
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
    ("h of wrong length", lambda a: ukf(a, a.bent(h=lambda x: x)), "h", "(..., 1), got (3, 2)"),
    ("h drops an axis", lambda a: ekf(a, h=lambda x: x[..., 0]), "h", "(..., 1), got (3,)"),
    (
        "h not broadcasting",
        lambda a: cubature_kalman_filter(a.bent(h=lambda x: x[:1]), a.z, a.start),
        "h",
        "(..., 1), got (1, 2)",
    ),
    ("F_jacobian a vector", lambda a: ekf(a, F_jacobian=lambda x: x), "F_jacobian", "(..., 2, 2), got (3, 2)"),
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
        "(..., 1), got (3,)",
    ),
    ("Q for other states", lambda a: ekf(a, Q=np.eye(3)), "initial", "3 components like the model, got 2"),
    ("f predicting", lambda a: predict(a.bent(f=lambda x: x[..., :1]), a.start), "f", "(..., 2), got (3, 1)"),
    ("h correcting", lambda a: correct(a.bent(h=lambda x: x), a.start, 1.0), "h", "(..., 1), got (3, 2)"),
    ("f simulating", lambda a: simulate(a.bent(f=lambda x: x[..., :1]), a.x, 5), "f", "(..., 2), got (3, 1)"),
]
STEPS = [
    ("predict an array", lambda a: predict(a.model(), a.x), "belief", "a Gaussian, got ndarray"),
    ("predict without model", lambda a: predict(a.F, a.start), "model", "got ndarray"),
    ("predict with u without B", lambda a: predict(a.model(), a.start, 1.0), "u", "no B"),
    ("predict with a long u", lambda a: predict(a.pushed(), a.start, [1, 2]), "u", "(1,), got (2,)"),
    ("predict after the end", lambda a: predict(a.model(F=stack(a.F, 3)), a.start, k=3), "k", "below 3"),
    (
        "predict at half a step",
        lambda a: predict(a.model(), a.start, k=0.5),
        "k",
        "whole number of at least 0, got 0.5",
    ),
    (
        "predict other runs",
        lambda a: predict(a.pushed(), Gaussian(np.zeros((3, 2)), I2), np.ones((4, 1))),
        "u",
        "u (4,)",
    ),
    (
        "correct another length",
        lambda a: correct(a.model(), Gaussian(0, 1), 1.0),
        "belief",
        "2 components like the model",
    ),
    ("correct with two", lambda a: correct(a.model(), a.start, [1, 2]), "z", "(1,), got (2,)"),
    ("correct with infinity", lambda a: correct(a.model(), a.start, inf), "z", "only NaN may mark"),
    (
        "correct other runs",
        lambda a: correct(a.model(), Gaussian(np.zeros((3, 2)), I2), np.ones((4, 1))),
        "z",
        "z (4,)",
    ),
    ("x without P", lambda a: kalman_step(1.0, 1.0, x=1.0), "P", "together with x"),
    ("P without x", lambda a: kalman_step(1.0, 1.0, P=1.0), "x", "together with P"),
    ("x partly unknown", lambda a: kalman_step(a.x, I2, x=[nan, 7], P=a.P), "x", "found NaN"),
    ("x of wrong length", lambda a: kalman_step(a.x, I2, x=[1, 2, 3], P=a.P), "x", "(2,), got (3,)"),
    ("P of wrong size", lambda a: kalman_step(a.x, I2, x=a.x, P=np.eye(3)), "P", "(2, 2), got (3, 3)"),
    ("P negative", lambda a: kalman_step(1.0, 1.0, x=1.0, P=-1.0), "P", "semi-definite, found -1"),
    ("kalman_step without R", lambda a: kalman_step(1.0, None), "R", "found NoneType"),
    ("start from half of the state", lambda a: kalman_step(1.0, 1.0, H=[[1, 0]]), "H", "(1, 2) must be invertible"),
    ("start from a singular H", lambda a: start_from(a.model(H=np.ones((2, 2)), R=I2), a.x), "H", "invertible"),
    ("start from a gap", lambda a: kalman_step(nan, 1.0), "z", "finite, found nan"),
    ("start from a function", lambda a: start_from(a.bent(), 1.0), "model", "LinearModel, got NonlinearModel"),
]
REST = [
    ("runs zero", lambda a: simulate(a.model(), a.start, 5, runs=0), "runs", "at least 1, got 0"),
    ("runs true", lambda a: simulate(a.model(), a.start, 5, runs=True), "runs", "got True"),
    ("steps a fraction", lambda a: simulate(a.model(), a.start, 2.5), "steps", "whole number of at least 1, got 2.5"),
    ("steps zero", lambda a: simulate(a.model(), a.start, 0), "steps", "got 0"),
    ("simulate no model", lambda a: simulate(a.F, a.start, 5), "model", "got ndarray"),
    ("simulate another length", lambda a: simulate(a.model(), Gaussian(0, 1), 5), "initial", "2 components"),
    ("simulate from elsewhere", lambda a: simulate(a.model(), [0, 0, 0], 5), "initial", "(2,), got (3,)"),
    ("simulate u too long", lambda a: simulate(a.pushed(), a.start, 4, a.u), "u", "4 steps"),
    (
        "simulate u of other runs",
        lambda a: simulate(a.pushed(), a.start, 5, np.ones((3, 5, 1)), 4),
        "u",
        "(4,) of the runs, or none, got (3,)",
    ),
    ("simulate stack too short", lambda a: simulate(a.model(Q=stack(I2, 3)), a.start, 5), "Q", "5 steps, or 1"),
    (
        "simulate starts of other runs",
        lambda a: simulate(a.model(), np.zeros((3, 2)), 5),
        "initial",
        "or none, got (3,)",
    ),
    ("voltmeter variant", lambda a: scenarios.voltmeter("brown"), "variant", "'constant', got 'brown'"),
    ("voltmeter R", lambda a: scenarios.voltmeter(R=0), "R", "positive definite, found 0"),
    ("voltmeter steps", lambda a: scenarios.voltmeter(steps=2.5), "steps", "got 2.5"),
    ("ship variant", lambda a: scenarios.ship("honest"), "variant", "got 'honest'"),
    ("train variance", lambda a: scenarios.train(-1), "start_speed_variance", "found -1"),
    (
        "rmse of other lengths",
        lambda a: rmse(np.ones((5, 1)), np.ones((4, 1))),
        "truth",
        "(5, 1) of the estimate, got (4, 1)",
    ),
    (
        "rmse of a column and a row",
        lambda a: rmse(np.ones((5, 1)), np.ones(5)),
        "truth",
        "(5, 1) of the estimate, got (5,)",
    ),
    ("rmse of text", lambda a: rmse(a.z, "12 V"), "truth", "found text"),
    ("nees of an array", lambda a: nees(a.z, a.z), "belief", ".mean and a .cov"),
    ("nees of other states", lambda a: nees(a.track(), np.ones((5, 3))), "truth", "(2,), got (5, 3)"),
    ("nees of other steps", lambda a: nees(a.track(), np.ones((6, 2))), "truth", "(5, 2) of the estimate, got (6, 2)"),
    ("nees of certainty", lambda a: nees(Gaussian([0, 0], np.diag([1, 0])), [1, 0]), "belief", "singular"),
    (
        "nees of certainty in space",
        lambda a: nees(Gaussian([0, 0, 0], np.diag([1, 1, 0])), [1, 0, 0]),
        "belief",
        "singular",
    ),
    ("nis of an array", lambda a: nis(a.z), "track", "got ndarray"),
    ("coverage of an array", lambda a: coverage(a.z, a.z), "belief", ".mean and a .cov"),
    (
        "coverage of a column and a row",
        lambda a: coverage(Gaussian(np.ones((5, 1)), 1), np.ones(5)),
        "truth",
        "(1,), got (5,)",
    ),
    ("coverage sigmas", lambda a: coverage(a.track(), np.ones((5, 2)), -1), "sigmas", "positive, got -1"),
    ("dof zero", lambda a: chi_square_interval(0), "dof", "at least 1, got 0"),
    ("dof a fraction", lambda a: chi_square_interval(1.5), "dof", "whole number"),
    (
        "runs beyond counting",
        lambda a: chi_square_interval(1, 10**400),
        "runs",
        "below 2**63, got a number of 401 digits",
    ),
    ("runs of an interval", lambda a: chi_square_interval(1, 0), "runs", "at least 1, got 0"),
    ("probability in per cent", lambda a: chi_square_interval(1, 1, 95), "probability", "between 0 and 1, got 95"),
    ("probability one", lambda a: chi_square_interval(1, 1, 1.0), "probability", "between 0 and 1, got 1.0"),
    ("probability text", lambda a: chi_square_interval(1, 1, "high"), "probability", "found text"),
    (
        "two filters too far apart",
        lambda a: two_filter_smoother(a.model(Q=[[0, 1], [1, 1e300]], R=[[2]]), [1, nan, 3], a.start),
        "Q",
        "smaller beside R",
    ),
    ("whiteness of an array", lambda a: whiteness(a.z), "innovation", ".mean and a .cov"),
    ("whiteness of one belief", lambda a: whiteness(a.start, 1), "innovation", "(any, any), got (2,)"),
    ("whiteness with gaps", lambda a: whiteness(kf(a, z=[1, nan, 2]).innovation, 1), "innovation", "finite, found nan"),
    ("lags too many", lambda a: whiteness(a.track().innovation, 5), "lags", "smaller than the 5 steps"),
    ("lags zero", lambda a: whiteness(a.track().innovation, 0), "lags", "at least 1, got 0"),
]
SMOOTHERS = [
    ("smooth no track", lambda a: rts_smoother(a.model(), a.start), "track", "got Gaussian"),
    ("smooth without model", lambda a: rts_smoother(a.F, a.track()), "model", "got ndarray"),
    (
        "smooth with another length",
        lambda a: rts_smoother(random_walk(1, 1), a.track()),
        "model",
        "2 states like the track",
    ),
    ("smooth with another model", lambda a: rts_smoother(a.model(Q=2 * I2), a.track()), "model", "other covariances"),
    ("smooth with other steps", lambda a: rts_smoother(a.model(Q=stack(I2, 3)), a.track()), "Q", "5 steps, or 1"),
    ("two filters of a function", lambda a: two_filter_smoother(a.bent(), a.z, a.start), "model", "got NonlinearModel"),
    ("two filters of text", lambda a: two_filter_smoother(a.model(), "12", a.start), "z", "found text"),
    ("root of a function", lambda a: square_root_kalman_filter(a.bent(), a.z, a.start), "model", "got NonlinearModel"),
    ("root of infinity", lambda a: square_root_kalman_filter(a.model(), [1, inf], a.start), "z", "only NaN may mark"),
]
NONLINEAR = [
    ("nominal too short", lambda a: lkf(a, np.zeros((4, 2))), "nominal", "(5, 2), got (4, 2)"),
    ("nominal with a gap", lambda a: lkf(a, np.full((5, 2), nan)), "nominal", "finite, found nan"),
    ("nominal of other runs", lambda a: lkf(a, np.zeros((3, 5, 2)), np.zeros((2, 5, 1))), "nominal", "nominal (3,)"),
    ("linearised without model", lambda a: linearized_kalman_filter(a.F, a.z, a.start), "model", "got ndarray"),
    ("jerk a matrix", lambda a: constant_acceleration(1, I2, 1), "jerk", "single number, got shape (2, 2)"),
    ("no time passes", lambda a: singer(0, 1, 1, 1), "dt", "positive, got 0"),
    ("manoeuvres for ever", lambda a: singer(1, 0, 1, 1), "rate", "positive, got 0"),
    ("steered by nobody", lambda a: homing.fly(2, 0, steered_by="nobody"), "steered_by", "'estimate', got 'nobody'"),
    ("told a lie", lambda a: homing.fly(2, 0, told="a lie"), "told", "'applied', got 'a lie'"),
    ("far away", lambda a: homing.fly(2, 0, distance="far"), "distance", "'truth', got 'far'"),
    ("no flight", lambda a: homing.fly(0), "runs", "at least 1, got 0"),
    ("growth variant", lambda a: scenarios.scalar_growth("true"), "variant", "got 'true'"),
    ("range sd", lambda a: scenarios.range_only(position_sd="wide"), "position_sd", "found text"),
    ("bearings R", lambda a: scenarios.bearings_only(R=-1), "R", "found -1"),
]
MANY = [
    ("no list of models", lambda a: imm(a, a.model()), "models", "got LinearModel"),
    ("no models", lambda a: imm(a, []), "models", "a list of models, got list"),
    ("an array among the models", lambda a: imm(a, [a.model(), a.F]), "model", "got ndarray"),
    (
        "models that measure otherwise",
        lambda a: imm(a, [a.model(), a.model(H=I2, R=I2)]),
        "models",
        "got [1, 2] of them",
    ),
    ("a model of another length", lambda a: imm(a, [a.model(), random_walk(1, 1)]), "initial", "1 components like"),
    ("transition too large", lambda a: imm(a, transition=np.eye(3)), "transition", "(2, 2), got (3, 3)"),
    ("transition by columns", lambda a: imm(a, transition=[[0.9, 0.2], [0.1, 0.8]]), "transition", "sum to 1"),
    ("transition negative", lambda a: imm(a, transition=[[1.1, -0.1], [0, 1]]), "transition", "sum to 1"),
    ("weights for three", lambda a: imm(a, weights=[0.2, 0.3, 0.5]), "mode_probabilities", "(2,), got (3,)"),
    ("weights too heavy", lambda a: imm(a, weights=[1, 1]), "mode_probabilities", "sum to 1, got"),
    ("states for one", lambda a: imm(a, states=[[0, 1]]), "states", "2 lists"),
    ("states twice", lambda a: imm(a, states=[[0, 0], [0, 1]]), "states", "different indices below 2"),
    ("states beyond", lambda a: imm(a, states=[[0, 2], [0, 1]]), "states", "different indices below 2"),
    ("states a number", lambda a: imm(a, states=[0, 1]), "states", "a list of indices, got 0"),
    ("many models, infinite z", lambda a: imm(a, z=[1, inf]), "z", "only NaN may mark"),
    ("many models, odd start", lambda a: imm(a, initial=a.x, states=[[0, 1]] * 2), "initial", "got ndarray"),
    (
        "bank weights",
        lambda a: mmae_filter([a.model()] * 2, a.z, a.start, None, [2, -1]),
        "mode_probabilities",
        "sum to 1",
    ),
    ("consider beyond", lambda a: consider(a, [2]), "considered", "indices below 2"),
    ("consider a half", lambda a: consider(a, [0.5]), "considered", "whole number of at least 0, got 0.5"),
    (
        "consider from a function",
        lambda a: schmidt_kalman_filter(a.model(), a.z, max, considered=[1]),
        "initial",
        "a Gaussian, got",
    ),
    ("consider a number", lambda a: consider(a, 1), "considered", "a list of indices, got 1"),
    ("consider a function", lambda a: schmidt_kalman_filter(a.bent(), a.z, a.start), "model", "got NonlinearModel"),
    ("adapt everything", lambda a: adaptive(a, adapt="both"), "adapt", "'R' or 'Q', got 'both'"),
    ("window of one", lambda a: adaptive(a, window=1), "window", "at least 2, got 1"),
    ("floor under ground", lambda a: adaptive(a, floor=0), "floor", "positive, got 0"),
    ("adapt no model", lambda a: adaptive_kalman_filter(a.F, a.z, a.start), "model", "got ndarray"),
    ("a film without colours", lambda a: video.detect(np.zeros((2, 4, 5)), a.F), "frames", "(any, any, any, 3)"),
    (
        "another background",
        lambda a: video.detect(np.zeros((2, 4, 5, 3)), np.zeros((4, 4, 3))),
        "background",
        "(4, 5, 3)",
    ),
    ("a film of no frames", lambda a: video.render(0), "steps", "at least 1, got 0"),
    ("drive backwards", lambda a: scenarios.inertial_navigation("reverse"), "variant", "got 'reverse'"),
    ("noise variant", lambda a: scenarios.unknown_noise("loud"), "variant", "got 'loud'"),
    ("ball variant", lambda a: scenarios.ball("red"), "variant", "got 'red'"),
]
TABLE = MODELS + BELIEFS + FILTERS + FUNCTIONS + STEPS + REST + SMOOTHERS + NONLINEAR + MANY


@pytest.mark.parametrize(NAMES, TABLE, ids=lambda value: value.replace(" ", "-") if isinstance(value, str) else "")
def test_wrong_call(id, call, name, fragment):
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
