"""Wrong calls of filters, steps and smoothers: each is answered by one sentence."""

import numpy as np
import pytest

from kflearn import FILTERS as ALL_FILTERS
from kflearn import (
    Gaussian,
    adaptive_kalman_filter,
    correct,
    cubature_kalman_filter,
    extended_kalman_filter,
    kalman_filter,
    kalman_step,
    linearized_kalman_filter,
    mmae_filter,
    predict,
    random_walk,
    rts_smoother,
    schmidt_kalman_filter,
    square_root_kalman_filter,
    start_from,
    two_filter_smoother,
    unscented_kalman_filter,
)
from tests.models.wrong_calls import (
    I2,
    NAMES,
    Inputs,
    adaptive,
    consider,
    ekf,
    imm,
    inf,
    kf,
    lkf,
    nan,
    refuses,
    stack,
    ukf,
    words,
)

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
    ("nominal too short", lambda a: lkf(a, np.zeros((4, 2))), "nominal", "(5, 2), got (4, 2)"),
    ("nominal with a gap", lambda a: lkf(a, np.full((5, 2), nan)), "nominal", "finite, found nan"),
    ("nominal of other runs", lambda a: lkf(a, np.zeros((3, 5, 2)), np.zeros((2, 5, 1))), "nominal", "nominal (3,)"),
    ("linearised without model", lambda a: linearized_kalman_filter(a.F, a.z, a.start), "model", "got ndarray"),
    ("z of None", lambda a: kf(a, z=[1.0, None, 2.0]), "z", "NoneType: use NaN for what was not measured"),
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
        lambda a: mmae_filter([a.model()] * 2, a.z, a.start, mode_probabilities=[2, -1]),
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
]
SMOOTH = [
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
    (
        "two filters too far apart",
        lambda a: two_filter_smoother(a.model(Q=[[0, 1], [1, 1e300]], R=[[2]]), [1, nan, 3], a.start),
        "Q",
        "smaller beside R",
    ),
]


@pytest.mark.parametrize(NAMES, FILTERS + STEPS + MANY + SMOOTH, ids=words)
def test_wrong_call(id, call, name, fragment):
    refuses(call, name, fragment)


# What no filter takes, whichever it is: changes of (model, z, initial, u).
OF_ALL = [
    ("no model", lambda a: dict(model=a.F), "model", "got ndarray"),
    ("z empty", lambda a: dict(z=[]), "z", "not be empty, got shape (0,)"),
    ("z infinite", lambda a: dict(z=[1, inf]), "z", "only NaN may mark"),
    ("z text", lambda a: dict(z=["1", "2"]), "z", "found text"),
    ("z with None", lambda a: dict(z=[1.0, None]), "z", "use NaN for what was not measured"),
    ("z two wide", lambda a: dict(z=np.ones((5, 2))), "z", "(..., T, 1), got (5, 2)"),
    ("initial an array", lambda a: dict(initial=a.x), "initial", "a Gaussian, got ndarray"),
    ("initial too short", lambda a: dict(initial=Gaussian(0, 1)), "initial", "2 components"),
    ("u without B", lambda a: dict(u=a.u), "u", "no B"),
    ("u too short", lambda a: dict(model=a.pushed(), u=a.u[:4]), "u", "5 steps"),
    ("u with a gap", lambda a: dict(model=a.pushed(), u=[1, 1, nan, 1, 1]), "u", "finite, found nan"),
    ("F too short", lambda a: dict(model=a.model(F=stack(a.F, 4))), "F", "5 steps, or 1, got shape (4, 2, 2)"),
    ("runs", lambda a: dict(z=np.ones((3, 5, 1)), initial=Gaussian(np.zeros((4, 2)), I2)), "initial", "initial (4,)"),
]


@pytest.mark.parametrize(NAMES, OF_ALL, ids=words)
@pytest.mark.parametrize("row", ALL_FILTERS, ids=lambda row: row.name)
def test_wrong_call_of_every_filter(row, id, call, name, fragment):
    def run(a):
        good = dict(model=a.model(), z=a.z, initial=a.start, u=None)
        return row.run(**{**good, **call(a)})

    refuses(run, name, fragment)


@pytest.mark.parametrize("row", [row for row in ALL_FILTERS if row.models == "both"], ids=lambda row: row.name)
def test_every_filter_refuses_a_function_that_mixes_rows(row):
    def rows_mixed(x):
        return x - x.mean()

    refuses(lambda a: row.run(a.bent(f=rows_mixed), a.z, a.start), "f", "index the last axis, for instance y[..., 1]")


@pytest.mark.parametrize("row", [row for row in ALL_FILTERS if row.needed], ids=lambda row: row.name)
def test_what_a_filter_needs_is_named(row):
    inputs = Inputs()
    with pytest.raises(TypeError, match=next(iter(row.needed))):
        row.function([inputs.model()] * 2, inputs.z, inputs.start)
