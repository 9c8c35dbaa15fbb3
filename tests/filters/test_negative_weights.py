"""Sigma points whose weights may be negative: a matrix that is no covariance is refused, with its step."""

import numpy as np
import pytest

from kflearn import (
    Gaussian,
    NonlinearModel,
    adaptive_kalman_filter,
    correct,
    predict,
    random_walk,
    simulate,
    unscented,
    unscented_kalman_filter,
)
from kflearn.filters.moments import refuse_negative

CASES = {
    "squares": (lambda x: x, lambda x: (x**2).sum(-1, keepdims=True)),
    "cosines": (lambda x: x, lambda x: np.cos(x).sum(-1, keepdims=True)),
    "moves by |x|": (lambda x: 0.2 * abs(x).sum(-1, keepdims=True) * np.ones(x.shape[-1]), lambda x: x[..., :1]),
}


def case(name, n):
    model = NonlinearModel(*CASES[name], 0.01 * np.eye(n), 0.01)
    start = Gaussian(np.full(n, 0.1), np.eye(n))
    return model, start, simulate(model, start, 20, rng=1).z


@pytest.mark.parametrize("name", CASES)
def test_julier_s_choice_for_six_states_is_refused(name):
    model, start, z = case(name, 6)
    with pytest.raises(ValueError, match=r"at step \d+ .*kappa|kappa.*at step \d+"):
        unscented_kalman_filter(model, z, start, alpha=1, beta=0, kappa=-3)


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("n", [1, 2, 3])
def test_julier_s_choice_for_up_to_three_states_is_sound(name, n):
    model, start, z = case(name, n)
    track = unscented_kalman_filter(model, z, start, alpha=1, beta=0, kappa=3 - n)
    assert np.linalg.eigvalsh(track.cov).min() > 0
    assert not unscented(n, 1, 0, 3 - n).may_be_negative(n)


def test_every_way_to_take_a_step_looks():
    model, start, z = case("moves by |x|", 6)
    rule, sentence = unscented(6, 1, 0, -3), r"n beta \+ alpha² kappa is at least 0: at step {} .*P⁻ .*eigenvalue -1\.3"
    with pytest.raises(ValueError, match=sentence.format(4)):
        predict(model, start, k=4, through=rule)
    with pytest.raises(ValueError, match=sentence.format(0)):
        adaptive_kalman_filter(model, z, start, through=rule)


def test_the_posterior_is_looked_at_too():
    """What h bends makes S too small here, but not negative: the gain is too large for what is left."""
    rule, n = unscented(6, 1, 0, -3), 6
    for size in np.geomspace(0.01, 10, 60):
        model = NonlinearModel(
            lambda x: x, lambda x, size=size: x[..., :1] + size * np.cos(x).sum(-1, keepdims=True), np.eye(n), 9
        )
        try:
            after = correct(model, Gaussian(np.full(n, 0.1), np.eye(n)), 0.0, through=rule)
        except ValueError as error:
            assert "kappa" in str(error)
        else:
            values = np.linalg.eigvalsh(after.cov)
            assert values[0] > -1e-9 * values[-1]
    bad = np.diag([1.0, 1, 1, 1, 1, -1e-8])
    with pytest.raises(ValueError, match=r"at step 7 .*P⁺ no covariance, with the eigenvalue -1e-08"):
        refuse_negative("P⁺", np.stack([np.eye(6), bad]), rule, 7, np.eye(6))
    refuse_negative("P⁺", np.diag([1.0, 1, 1, 1, 1, -1e-10]), rule, 7, np.eye(6))


def test_a_linear_model_is_right_with_any_weights():
    model = random_walk(1, 1)
    track = unscented_kalman_filter(model, [1.0, 2.0], Gaussian(0, 1), beta=-1)
    assert (track.filtered.variance > 0).all()
