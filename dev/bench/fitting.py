"""How long it takes to fit Q and R, beside statsmodels' search and pykalman's EM.

    python -m dev.bench.fitting

A random walk with readings, without a start. Where both search, both arrive at the same log-likelihood to 0.01 (each
stops where it thinks fit); after the same number of rounds of EM, both have the same Q and R to 1e-6.
"""

import warnings

import numpy as np

from dev.bench.filters import best
from dev.bench.goals import judged
from kflearn import examples, fit, random_walk
from kflearn.fitting.em import Task, smoothed
from kflearn.fitting.many import Matrices, Start

SERIES, STEPS, SAMPLE, ROUNDS = 1000, 100, 20, 10
FIRST = {"Q": 1.0, "R": 1.0}


def series():
    """Random walks with Q = 1 and R = 4, (SERIES, STEPS, 1)."""
    rng = np.random.default_rng(0)
    return np.cumsum(rng.normal(0, 1, (SERIES, STEPS, 1)), axis=1) + rng.normal(0, 2, (SERIES, STEPS, 1))


def their_fit(z):
    """statsmodels' local level: its log-likelihood counts one log 2π more than ours."""
    from statsmodels.tsa.statespace.structural import UnobservedComponents

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return UnobservedComponents(z, "llevel", use_exact_diffuse=True).fit(disp=0)


def our_em(z):
    """ROUNDS rounds from Q = R = 1 and N(0, 100) at the first reading, all series at once: Q and R of each."""
    model = random_walk(1, 1)
    task = Task(
        model, np.moveaxis(z, 0, -1), None, Start(np.zeros((1, 1, 1)), np.full((1, 1, 1), 100.0), True), ("Q", "R"), ()
    )
    matrices = Matrices.of(model, runs=1)
    for _ in range(ROUNDS):
        matrices = task.better(matrices, smoothed(task.forward(matrices)))
    return np.stack([matrices.Q[0, 0, 0], matrices.R[0, 0, 0]])


def their_em(z):
    """The same by pykalman, for one series."""
    from pykalman import KalmanFilter

    start = dict(initial_state_mean=[0.0], initial_state_covariance=[[100.0]])
    free = ["transition_covariance", "observation_covariance"]
    kf = KalmanFilter([[1.0]], [[1.0]], [[1.0]], [[1.0]], em_vars=free, **start).em(z, n_iter=ROUNDS)
    return np.array([kf.transition_covariance[0, 0], kf.observation_covariance[0, 0]])


def rows():
    """(what, our seconds, theirs, their name, goal) of each race, after agreement was checked."""
    nile, z = examples.load("nile")["flow"], series()
    ours, theirs = fit(random_walk, nile, FIRST), their_fit(nile)
    assert abs(ours.log_likelihood_of_all - theirs.llf) < 0.01
    yield (
        "Nile, one fit",
        best(lambda: fit(random_walk, nile, FIRST), 10),
        best(lambda: their_fit(nile), 5),
        "statsmodels",
        3,
    )
    ours, some = fit(random_walk, z, FIRST), z[:SAMPLE]
    found = np.array([their_fit(one[:, 0]).llf for one in some])
    assert abs(ours.log_likelihood_of_all[:SAMPLE] - found).max() < 0.01
    all_of_them = best(lambda: [their_fit(one[:, 0]) for one in some], 2) * SERIES / SAMPLE
    yield (
        f"{SERIES:,} x {STEPS}, all fitted",
        best(lambda: fit(random_walk, z, FIRST), 3),
        all_of_them,
        "statsmodels",
        200,
    )
    ours, found = our_em(z)[:, :3].T, np.array([their_em(one) for one in z[:3]])
    assert abs(ours / found - 1).max() < 1e-6
    all_of_them = best(lambda: [their_em(one) for one in z[:3]], 2) * SERIES / 3
    yield f"{SERIES:,} x {STEPS}, {ROUNDS} rounds of EM", best(lambda: our_em(z), 3), all_of_them, "pykalman", 100


def table():
    """The lines of the report."""
    yield "| | kflearn | rival | its time | ratio | goal |\n|---|---:|---|---:|---:|---:|"
    for what, own, other, name, goal in rows():
        times = f"{1e3 * own:,.1f} ms | {name} | {1e3 * other:,.0f} ms"
        yield f"| {what} | {times} | {judged(other / own, goal)} | {goal} |"


if __name__ == "__main__":
    print("\n".join(table()))
