"""EM beside pykalman's, on models of two states with gaps, and what it promises of itself."""

import numpy as np
import pytest

from kflearn import Gaussian, LinearModel, diffuse_start, em, fit, kalman_filter, random_walk, rts_smoother
from kflearn.fitting.em import Task, smoothed
from kflearn.fitting.many import Matrices, Start

F, H = np.array([[1, 0.5], [0, 0.9]]), np.array([[1, 0], [0.3, 1]])
MODEL = LinearModel(F, H, np.eye(2), np.eye(2))


def readings(missing=(7, 30, 31, 32)):
    rng, x, z = np.random.default_rng(5), np.zeros(2), []
    for _ in range(60):
        x = F @ x + rng.normal(0, [0.3, 0.6])
        z.append(H @ x + rng.normal(0, [1, 2]))
    z = np.round(z, 2)
    z[list(missing)] = np.nan
    return z


def five_rounds(free):
    """From the start N(0, 4 I) at the first reading itself, as pykalman has it."""
    start = Start(np.zeros((2, 1, 1)), 4 * np.eye(2)[..., None], True)
    task, matrices = Task(MODEL, readings()[..., None], None, start, free, ()), Matrices.of(MODEL, runs=1)
    for _ in range(5):
        matrices = task.better(matrices, smoothed(task.forward(matrices)))
    return [getattr(matrices, name)[0, ..., 0] for name in free]


# pykalman 0.11.2: KalmanFilter(F, H, I, I, initial_state_mean=[0, 0], initial_state_covariance=4 I, em_vars=…).em(z, 5)
PYKALMAN = {
    ("Q", "R"): (
        [[0.7026102943311269, 0.13377321570000122], [0.13377321570000136, 1.02925965938747]],
        [[0.7914883283928736, 0.06924205303699321], [0.06924205303699323, 2.711031121234226]],
    ),
    ("Q", "R", "F", "H"): (
        [[0.6430543436363034, 0.11637317574845106], [0.11637317574845105, 1.0639511368153243]],
        [[0.8138625876851023, 0.0497402286990488], [0.04974022869904877, 2.311802281581857]],
        [[0.9757760107553551, 0.3682545601150214], [-0.0585118045404855, 0.8431027888920384]],
        [[0.9644679297424515, 0.04399865484435211], [0.30904561043257534, 1.062290127252941]],
    ),
}


@pytest.mark.parametrize("free", PYKALMAN, ids="".join)
def test_five_rounds_are_those_of_pykalman(free):
    for ours, theirs in zip(five_rounds(free), PYKALMAN[free], strict=True):
        np.testing.assert_allclose(ours, theirs, rtol=0, atol=1e-12)


@pytest.mark.parametrize("initial", [None, Gaussian([0, 0], 4 * np.eye(2))], ids=["diffuse", "given"])
@pytest.mark.parametrize("free", [("Q",), ("R",), ("Q", "R"), ("F", "H")], ids="".join)
def test_no_round_makes_the_readings_less_probable(free, initial):
    z = readings()
    z[12, 0] = z[40, 1] = np.nan  # gaps in one component alone
    found = em(MODEL, z, initial, free=free, rounds=30)
    assert (np.diff(found.log_likelihood) > -1e-9).all() and found.log_likelihood[-1] > found.log_likelihood[0]


def test_the_likelihoods_are_those_of_the_filters():
    z, initial = readings(), Gaussian([1, 2], [[3, 1], [1, 2]])
    given = em(MODEL, z, initial, rounds=1).log_likelihood[0]
    assert given == pytest.approx(kalman_filter(MODEL, z, initial).log_likelihood, abs=1e-10)
    start = diffuse_start(MODEL, z)
    after = kalman_filter(start.model, z[start.steps :], start.belief).log_likelihood
    assert em(MODEL, z, rounds=1).log_likelihood[0] == pytest.approx(start.log_likelihood + after, abs=1e-9)


def test_the_way_back_is_the_smoother():
    z, initial = readings(), Gaussian([1, 2], [[3, 1], [1, 2]])
    start = Start(initial.mean[:, None, None], initial.cov[..., None], False)
    states = smoothed(Task(MODEL, z[..., None], None, start, ("Q",), ()).forward(Matrices.of(MODEL, runs=1)))
    smooth = rts_smoother(MODEL, kalman_filter(MODEL, z, initial))
    np.testing.assert_allclose(states.mean[..., 0], smooth.mean, atol=1e-12)
    np.testing.assert_allclose(states.cov[..., 0], smooth.cov, atol=1e-12)


def test_em_climbs_to_where_fit_arrives():
    rng = np.random.default_rng(2)
    z = np.cumsum(rng.normal(0, 1, 80)) + rng.normal(0, 1, 80)
    best = fit(random_walk, z, {"Q": 1.0, "R": 1.0})
    climbed = em(best.model.replace(Q=1.1 * best.model.Q), z, rounds=500)
    assert climbed.converged and best.log_likelihood - 1e-5 < climbed.log_likelihood[-1] < best.log_likelihood + 1e-9
    assert climbed.model.Q.item() == pytest.approx(best.parameters["Q"], rel=1e-2)


def test_many_series_are_learnt_from_alone():
    rng = np.random.default_rng(3)
    z = np.cumsum(rng.normal(0, 1, (3, 50, 1)), axis=1) + rng.normal(0, 2, (3, 50, 1))
    z[1, 20:25] = np.nan
    together = em(random_walk(1, 1), z, rounds=7, tolerance=0)
    for i in range(3):
        alone = em(random_walk(1, 1), z[i], rounds=7, tolerance=0)
        np.testing.assert_allclose(together.log_likelihood[i], alone.log_likelihood, atol=1e-10)
        np.testing.assert_allclose(together.model.Q[i, 0], alone.model.Q, rtol=1e-10)
    assert kalman_filter(together.model, z, Gaussian(0, 1)).mean.shape == (3, 50, 1)


def test_a_control_input_is_not_taken_for_noise():
    rng = np.random.default_rng(4)
    u = rng.normal(0, 5, (80, 1))
    z = np.cumsum(u[:, 0] + rng.normal(0, 0.1, 80)) + rng.normal(0, 0.5, 80)
    pushed = em(LinearModel(1, 1, 1, 1, B=1), z, u=u, rounds=40).model.Q.item()
    assert pushed < 0.5 < 10 < em(random_walk(1, 1), z, rounds=40).model.Q.item()


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (dict(free="Q"), "free must list some of Q, R, F, H, got 'Q'"),
        (dict(free=("B",)), "free must list"),
        (dict(rounds=0), "rounds must be"),
        (dict(z=[[1.0, 2.0]]), "z must determine all 2 states|z must determine"),
    ],
)
def test_wrong_calls_say_so(change, says):
    call = dict(z=readings(()), rounds=2) | change
    if "z" in change:
        call["z"] = np.array([[1.0, np.nan], [np.nan, np.nan]])
    with pytest.raises((ValueError, TypeError), match=says):
        em(MODEL, **call)
    with pytest.raises(TypeError, match="model must be a LinearModel"):
        em("a model", [1.0, 2.0])
