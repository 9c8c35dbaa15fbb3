"""Lesson 24: let the data choose."""

import numpy as np

from kflearn import fit, random_walk
from kflearn.exercises import _fitted_R
from kflearn.exercises._slips import let_the_data_choose as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise

ONE = -0.5 * (np.log(2 * np.pi * 5) + 3**2 / 5)


@exercise(
    hints=[
        "One term of the sum: minus a half of log 2πS plus the NIS.",
        "S = 5, so 2πS = 31.42 and its logarithm is 3.447. The NIS is y²/S = 1.8.",
        "`-0.5 * (np.log(2 * np.pi * 5) + 3**2 / 5)`",
    ],
    wrong=slips.one_reading.WRONG,
    otherwise=slips.one_reading.near_the_density,
    then="A reading exactly as expected, y = 0, would have −1.72. The largest value there can be falls as S grows: a wide claim costs.",
)
def one_reading():
    """The log-likelihood of one reading with innovation 3 V and S = 5 V²?"""
    return ONE


def runs(rng, T):
    """Innovations of a run, a third of them missing, with variances that change from step to step."""
    S = rng.integers(1, 9, T) / 2
    y = np.round(rng.normal(0, np.sqrt(S)), 1)
    y[rng.permutation(T)[: T // 3]] = np.nan
    return y, S


@exercise(
    hints=[
        "First the terms of all steps as an array, −½(log 2πS + y²/S). Where y is NaN the term is NaN too: what must it count?",
        "A missing reading counts nothing at all, not even its log 2πS. `np.isnan(y)` tells where.",
        "`seen = ~np.isnan(y)`, then `-0.5 * np.sum(np.log(2 * np.pi * S[seen]) + y[seen]**2 / S[seen])`",
    ],
    inputs=in_turn(runs, 6, 3, 800),
    wrong=slips.log_likelihood.WRONG,
    also=[lambda y, S: np.nansum(-0.5 * (np.log(2 * np.pi * S) + y**2 / S))],
    then="With this function and a filter in a loop you can fit any model with SciPy. That is all that `fit` does, only faster.",
    rtol=1e-4,  # with 6.2832 for 2π
)
def log_likelihood(y, S):
    """The log-likelihood of a run from its innovations (T,), NaN where nothing was measured, and variances (T,)."""
    seen = ~np.isnan(y)
    return -0.5 * np.sum(np.log(2 * np.pi * S[seen]) + y[seen] ** 2 / S[seen])


@exercise(
    hints=[
        "Write the sum for one reading on average: y² becomes its mean, 4. So ½·4/R + log R has to be as small as possible; a constant inside the logarithm moves nothing.",
        "The derivative with respect to R is −½·4/R² + 1/R. Where is it zero?",
        "½·4/R² = 1/R gives R = 2.",
    ],
    wrong=slips.half_missing.WRONG,
    otherwise=slips.half_missing.slope_at,
    unit="",
    then="A σ of 1.41 in place of 2, with no error message and a search that says it converged. Only the mean NIS shows it: it is 2.",
)
def half_missing():
    """Where does the search come to, if log 2πS lacks its ½ and the true R is 4?"""
    return 2.0


@exercise(
    hints=[
        "Twice a hill has its top where the hill has it. What of its curvature?",
        "AIC adds 2 for each parameter. If log L is doubled, does a parameter still cost the same beside it?",
        'The curvature is doubled, so the standard errors are too small by √2; and in the AIC the parameters count half. `"BC"`',
    ],
    wrong=slips.doubled.WRONG,
    then="The curvature is doubled, so the standard errors are too small by √2. In the AIC the gain of a larger model counts "
    "twice, and its parameters do not. Where only the place of the top or the order matters, a factor and a constant do no harm.",
)
def doubled():
    """Which of A to D come out wrong, if the log-likelihood is doubled and lacks its constant?"""
    return "B, C"


def walks(rng, T):
    """Readings of a random walk with a known Q."""
    Q, R = rng.integers(2, 20) / 10, rng.integers(20, 60) / 10
    z = np.cumsum(rng.normal(0, np.sqrt(Q), T)) + rng.normal(0, np.sqrt(R), T) + rng.integers(-20, 21)
    z[rng.permutation(np.arange(2, T))[: T // 4]] = np.nan
    return np.round(z, 2), Q


@exercise(
    hints=[
        "A function of R that filters the readings and adds the terms −½(log 2πS + y²/S); then the R at which it is largest.",
        "Let `fit` do it: build is a function of R alone, with Q inside it. Or try a hundred values of R from 0.01 to 100, evenly in the logarithm.",
        '`return fit(lambda R: random_walk(Q, R), z, {"R": 1.0}).parameters["R"]`',
    ],
    inputs=in_turn(walks, 30, 40, 24),
    trials=6,
    rtol=0.06,
    wrong=slips.fitted_R.WRONG,
    otherwise=_fitted_R.of_all,
    then="Known parameters stay in `build`, unknown ones are its arguments: so any mixture of both is fitted.",
)
def fitted_R(z, Q):
    """The most probable R of a random walk with the given Q, from readings (T,) with gaps."""
    return fit(lambda R: random_walk(Q, R), z, {"R": 1.0}).parameters["R"]
