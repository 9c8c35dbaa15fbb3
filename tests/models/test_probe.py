"""Functions of a model, tried at different states: what mixes up the rows is refused, what is right passes."""

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    NonlinearModel,
    correct,
    extended_kalman_filter,
    linearized_kalman_filter,
    numerical_jacobian,
    predict,
    rts_smoother,
    scenarios,
    simulate,
    unscented_kalman_filter,
)

F = np.eye(4) + np.diag([1, 0, 1.0], 1)
Q, R = np.eye(4) * 0.01, np.diag([1, 0.001])
START = Gaussian([-100, 0, 20, -2], np.diag([25, 1, 25, 1.0]))
ADVICE = r"index the last axis, for instance y\[\.\.\., 1\]"


def polar(x):
    return np.stack([np.hypot(x[..., 0], x[..., 2]), np.arctan2(x[..., 2], x[..., 0])], -1)


def turned(angle):
    return (angle + np.pi) % (2 * np.pi) - np.pi


def last_axis(a, b):
    y = a - b
    y[..., 1] = turned(y[..., 1])
    return y


def first_axis(a, b):
    """FilterPy's idiom, right for one measurement."""
    y = a - b
    y[1] = turned(y[1])
    return y


def tracking(**functions):
    return NonlinearModel(**{**dict(f=lambda x: x @ F.T, h=polar, Q=Q, R=R, residual=last_axis), **functions})


def first_row(x):
    y = x @ F.T
    y[1] = turned(y[1])
    return y


def growing(x):
    return F if x.ndim == 1 else F * np.arange(1, len(x) + 1).reshape(-1, *(1,) * x.ndim)


MIXED = {
    "residual with y[1]": ("residual", tracking(residual=first_axis)),
    "f with y[1]": ("f", tracking(f=first_row)),
    "norm without axis": ("f", tracking(f=lambda x: x / np.linalg.norm(x))),
    "mean of all": ("f", tracking(f=lambda x: x - x.mean())),
    "h sorted by rows": ("h", tracking(h=lambda x: np.sort(polar(x), axis=0) if x.ndim > 1 else polar(x))),
    "Jacobian by rows": ("F_jacobian", tracking(F_jacobian=growing)),
}
RIGHT = {
    "x @ F.T": tracking(),
    "einsum": tracking(f=lambda x: np.einsum("ij,...j", F, x)),
    "norm with axis": tracking(f=lambda x: x / np.linalg.norm(x, axis=-1, keepdims=True)),
    "angle turned": tracking(f=lambda x: np.concatenate([x[..., :3], turned(x[..., 3:])], axis=-1)),
    "float32": tracking(f=lambda x: np.float32(x) @ np.float32(F.T)),
    "whole numbers": tracking(h=lambda x: np.rint(polar(x)).astype(int)),
    "constant Jacobian": tracking(F_jacobian=lambda x: F, H_jacobian=lambda x: np.ones((2, 4))),
    "constant": tracking(f=lambda x: np.zeros(x.shape)),
    "no residual": tracking(residual=None),
    "NaN elsewhere": tracking(h=lambda x: np.where(x[..., :1] > -100.5, polar(x), np.nan)),
}
FILTERS = [extended_kalman_filter, unscented_kalman_filter, linearized_kalman_filter]


@pytest.mark.parametrize(("name", "model"), MIXED.values(), ids=MIXED)
@pytest.mark.parametrize("runs", [(), (3,), (4,)])
def test_what_mixes_up_the_rows_is_refused(name, model, runs):
    z = np.ones((*runs, 5, 2))
    for kf in FILTERS:
        with pytest.raises(
            ValueError, match=rf"^{name} must treat each state alone, but row \d of a batch of 5 .*{ADVICE}"
        ):
            kf(model, z, START)
    if name in ("f", "F_jacobian"):
        with pytest.raises(ValueError, match=f"^{name} must"):
            predict(model, START)
    else:
        with pytest.raises(ValueError, match=f"^{name} must"):
            correct(model, START, [100, 0])
    with pytest.raises(ValueError, match=f"^{name} must"):
        simulate(model, START, 5)


@pytest.mark.parametrize("f", [lambda x: F @ x, lambda x: (F @ x.T).T, lambda x: x[:, :] @ F.T])
@pytest.mark.parametrize("runs", [(), (3,), (4,), (5,)])
def test_columns_and_fixed_numbers_of_axes_are_refused(f, runs):
    for kf in FILTERS:
        with pytest.raises(ValueError, match=r"^f must return shape \(\.\.\., 4\), got an error"):
            kf(tracking(f=f), np.ones((*runs, 5, 2)), START)


@pytest.mark.parametrize("model", RIGHT.values(), ids=RIGHT)
@pytest.mark.parametrize("runs", [(), (3,)])
def test_what_is_right_passes(model, runs):
    z = np.broadcast_to([100.0, 3], (*runs, 5, 2))
    start = Gaussian(START.mean, 1e-4 * np.eye(4))
    track = extended_kalman_filter(model, z, start)
    assert track.mean.shape == (*runs, 5, 4)
    predict(model, start)
    correct(model, start, z[..., 0, :])


def test_a_vague_or_an_exact_start_is_no_reason_to_refuse():
    for variance in (0, 1e-30, 1e8, 1e20):
        start = Gaussian(START.mean, variance * np.eye(4))
        assert extended_kalman_filter(tracking(), np.ones((3, 2)), start).mean.shape == (3, 4)
        with pytest.raises(ValueError, match=ADVICE):
            extended_kalman_filter(tracking(f=first_row), np.ones((3, 2)), start)


def test_a_function_that_is_defined_near_the_start_only():
    def near(x):
        if (abs(x - START.mean) > 1e-2).any():
            raise ValueError("off the map")
        return x @ F.T

    predict(tracking(f=near), START)
    with pytest.raises(ValueError, match=r"^f must return shape .*: off the map"):
        predict(tracking(f=near), Gaussian(START.mean + 1, START.cov))


def test_nan_at_the_start_is_an_error():
    for name in ("f", "h"):
        function = {"f": lambda x: np.sqrt(x), "h": lambda x: np.sqrt(x[..., :2])}[name]
        with pytest.raises(ValueError, match=f"what {name} returns must be finite, found nan"):
            extended_kalman_filter(tracking(**{name: function, "residual": None}), np.ones((3, 2)), START)


def test_control_inputs_of_each_run_go_with_their_states():
    def push(x, u):
        return x @ F.T + u[..., :1]

    def first(x, u):
        return x @ F.T + u[0]  # of the first run, or the first component: right for one run

    u = np.arange(15.0).reshape(3, 5, 1)
    z = np.ones((3, 5, 2))
    for kf in FILTERS:
        kf(tracking(f=push), z, START, u)
        kf(tracking(f=push), z, START, u[0])
        with pytest.raises(ValueError, match=r"^f must treat each state alone"):
            kf(tracking(f=first), z, START, u)


def count_calls(name):
    calls = []

    def f(x):
        calls.append(x.shape)
        return x @ F.T

    return tracking(f=f, F_jacobian=lambda x: F), calls


def test_a_model_is_tried_once_in_single_steps_and_each_time_before_a_series():
    model, calls = count_calls("f")
    predict(model, START)
    first = len(calls)
    assert first == 1 + 5 + 1  # together, alone, and the step itself
    predict(model, START)
    predict(model.replace(Q=2 * Q), START)  # the same functions
    assert len(calls) == first + 2
    predict(model.replace(h=lambda x: polar(x)), START)
    assert len(calls) == first + 2 + first
    calls.clear()
    for _ in range(2):
        extended_kalman_filter(model, np.ones((3, 2)), START)
    assert len(calls) == 2 * (1 + 5 + 1 + 3)  # f once more, for the states at which h is tried


def test_a_jump_exactly_at_the_start_is_no_reason_to_refuse():
    for mean in ([np.pi, 0, -np.pi, 0], [1 / 3, np.pi - 1 / 3, np.pi / 3, 2 * np.pi / 3]):
        model = tracking(f=lambda x: turned(x @ F.T), state_residual=lambda a, b: turned(a - b))
        extended_kalman_filter(model, np.ones((3, 2)), Gaussian(mean, np.eye(4)))
        extended_kalman_filter(model.replace(state_residual=None, F_jacobian=lambda x: F), np.ones((3, 2)), START)


@pytest.mark.parametrize(
    "name", ["scalar_growth", "range_only", "bearings_only", "range_and_bearing", "homing_missile"]
)
def test_the_models_of_the_course_pass_in_smoothers_too(name):
    scene = getattr(scenarios, name)()
    data = scene.simulate(runs=2, rng=0)
    track = unscented_kalman_filter(scene.model, data.z, scene.initial, data.u)
    assert np.isfinite(rts_smoother(scene.model, track).mean).all()


@pytest.mark.parametrize("batch", [(), (6,), (3, 6)])
def test_the_function_of_a_jacobian_is_tried_too(batch):
    x = np.random.default_rng(0).normal(5, 1, (*batch, 4))
    assert numerical_jacobian(polar, x, last_axis).shape == (*batch, 2, 4)
    for function in (lambda x: x - x.mean(), first_row):
        with pytest.raises(ValueError, match=f"^function must treat each state alone.*{ADVICE}"):
            numerical_jacobian(function, x)
    with pytest.raises(ValueError, match=f"^difference must treat each state alone.*{ADVICE}"):
        numerical_jacobian(polar, x, first_axis)


def test_the_function_of_a_jacobian_may_belong_to_a_batch():
    own = np.arange(6.0)[:, None]
    found = numerical_jacobian(lambda x: own * x[..., :1], np.ones((6, 2)))
    np.testing.assert_allclose(found[:, 0, 0], np.arange(6), atol=1e-8)
