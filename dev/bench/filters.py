"""Our filters against FilterPy, simdkalman and statsmodels: same numbers, one thread, agreement checked before timing.

    python -m dev.bench.filters          prints a table of times, and of ratios (time of a rival / time of kflearn)

FilterPy and statsmodels filter one run at a time, so they are timed on a part of the runs and the time is scaled up.
simdkalman, like kflearn, takes all runs at once; it and statsmodels have linear filters only. Timed is what each needs
for the same result: estimates with their covariances, of filters or of smoothers.
"""

import time
from collections.abc import Callable
from math import isnan
from types import SimpleNamespace
from typing import NamedTuple

import numpy as np
import simdkalman
from filterpy.kalman import (
    ExtendedKalmanFilter,
    IMMEstimator,
    KalmanFilter,
    MerweScaledSigmaPoints,
    UnscentedKalmanFilter,
)
from statsmodels.tsa.statespace.kalman_smoother import KalmanSmoother

from dev.bench.goals import judged
from kflearn import (
    Gaussian,
    LinearModel,
    NonlinearModel,
    OnlineFilter,
    constant_velocity,
    extended_kalman_filter,
    homing,
    imm_filter,
    kalman_filter,
    rts_smoother,
    scenarios,
    simulate,
    unscented_kalman_filter,
)
from kflearn.filters.multiple_models import lifted


class Race(NamedTuple):
    """ours(z) → Track of all runs; a rival(z) → means (runs, T, n), and on how many runs it is timed."""

    name: str
    z: np.ndarray
    ours: Callable
    rivals: dict[str, tuple[Callable, int]]
    goal: float  # how many times as quick as FilterPy; as any other rival: once
    tolerance: float = 1e-9
    kind: str = ""  # filter, smoother, UKF or EKF of model and initial, for the rivals of `rival_races`
    model: LinearModel | NonlinearModel | None = None
    initial: Gaussian | None = None


class Result(NamedTuple):
    """Seconds of ours and of each rival for all runs, and the largest difference relative to the largest number."""

    race: Race
    ours: float
    rivals: dict[str, float]
    difference: float


def each(one_run):
    """A filter of one run as a filter of many."""
    return lambda z: np.stack([one_run(series) for series in z])


def their_kalman_filter(model, initial):
    kf = KalmanFilter(dim_x=model.n, dim_z=model.m)
    kf.x, kf.P = initial.mean.copy(), initial.cov.copy()
    kf.F, kf.H, kf.Q, kf.R = model.F, model.H, model.Q, model.R
    return kf


def first_prediction(model, initial):
    """The belief where simdkalman and statsmodels begin: at the first measurement, before it is used."""
    return model.F @ initial.mean, model.F @ initial.cov @ model.F.T + model.Q


def all_runs(model, initial, smoothed=False):
    mean, cov = first_prediction(model, initial)
    kf = simdkalman.KalmanFilter(model.F, model.Q, model.H, model.R)
    only = dict(
        initial_value=mean, initial_covariance=cov, filtered=not smoothed, smoothed=smoothed, observations=False
    )

    def means(z):
        found = kf.compute(z, 0, **only)
        return (found.smoothed if smoothed else found.filtered).states.mean

    return means


def compiled(model, initial, smoothed=False):
    start = first_prediction(model, initial)

    def means(series):
        kf = KalmanSmoother(k_endog=model.m, k_states=model.n)
        kf["design"], kf["transition"], kf["selection"] = model.H, model.F, np.eye(model.n)
        kf["obs_cov"], kf["state_cov"] = model.R, model.Q
        kf.initialize_known(*start)
        kf.bind(series)
        return kf.smooth().smoothed_state.T if smoothed else kf.filter().filtered_state.T

    return each(means)


def linear(name, model, initial, z, sample, goal):
    def theirs(series):
        return loop(their_kalman_filter(model, initial), series)

    rivals = {
        "FilterPy": (each(theirs), sample),
        "simdkalman": (all_runs(model, initial), len(z)),
        "statsmodels": (compiled(model, initial), 10 * sample),
    }
    return Race(name, z, lambda z: kalman_filter(model, z, initial), rivals, goal, 1e-9, "filter", model, initial)


def loop(kf, series, **how):
    means = np.empty((len(series), len(kf.x)))
    for k, z in enumerate(series):
        kf.predict()
        kf.update(None if isnan(z[0]) else z, **how)
        means[k] = kf.x
    return means


def smoothed(name, model, initial, z, sample, goal):
    def theirs(series):
        kf = their_kalman_filter(model, initial)
        means, covs, _, _ = kf.batch_filter(series)
        return kf.rts_smoother(means, covs)[0]

    rivals = {
        "FilterPy": (each(theirs), sample),
        "simdkalman": (all_runs(model, initial, smoothed=True), len(z)),
        "statsmodels": (compiled(model, initial, smoothed=True), 10 * sample),
    }
    ours = lambda z: rts_smoother(model, kalman_filter(model, z, initial))  # noqa: E731
    return Race(name, z, ours, rivals, goal, 1e-9, "smoother", model, initial)


def range_and_bearing():
    """[KM] six states, distance and bearing."""
    scene = scenarios.range_and_bearing("honest start")
    model, initial = scene.model, scene.initial

    def theirs(series):
        points = MerweScaledSigmaPoints(6, alpha=0.01, beta=2, kappa=0)
        kf = UnscentedKalmanFilter(6, 2, dt=1, hx=model.h, fx=lambda x, dt: model.f(x), points=points)
        kf.x, kf.P, kf.Q, kf.R = initial.mean.copy(), initial.cov.copy(), model.Q, model.R
        return loop(kf, series)

    def ours(z):
        return unscented_kalman_filter(model, z, initial, alpha=0.01, beta=2, kappa=0)

    rivals, z = {"FilterPy": (each(theirs), 20)}, scene.simulate(1000, rng=0).z
    return Race("UKF, 6 states: 1,000 x 50", z, ours, rivals, 130, 1e-6, "UKF", model, initial)


def their_missile_filter(initial, R):
    kf = ExtendedKalmanFilter(dim_x=9, dim_z=2)
    kf.x, kf.P, kf.F, kf.Q, kf.R = initial.mean.copy(), initial.cov.copy(), homing.F, homing.Q, R
    return kf


def missile():
    """The homing missile's nine states and two angles, without its guidance and with a constant R."""
    F, Q, R = homing.F, homing.Q, 1e-8 * np.eye(2)
    model = NonlinearModel(lambda x: x @ F.T, homing.angles, Q, R, lambda x: F, homing.angles_jacobian)
    start = np.array([3500.0, 1500, 1000, -500, -150, -50, 0, 0, 0])
    initial = Gaussian(start, homing.START.cov)

    def theirs(series):
        return loop(their_missile_filter(initial, R), series, HJacobian=homing.angles_jacobian, Hx=homing.angles)

    z = simulate(model, start, 367, runs=50, rng=0).z
    ours = lambda z: extended_kalman_filter(model, z, initial)  # noqa: E731
    rivals = {"FilterPy": (each(theirs), 3)}
    return Race("EKF, 9 states: 50 x 367", z, ours, rivals, 25, 1e-6, "EKF", model, initial)


def manoeuvring():
    """Constant velocity and two constant accelerations in the plane, six states each."""
    scene = scenarios.manoeuvring()
    models, start = lifted(scene.models, scene.initial, scene.states), scene.initial
    Pi, mu = scene.transition, scene.mode_probabilities

    def theirs(series):
        bank = [their_kalman_filter(model, start) for model in models]
        imm, means = IMMEstimator(bank, mu, Pi), []
        for z in series:
            imm.predict()
            imm.update(z)
            means.append(imm.x.copy())
        return np.array(means)

    z = scene.simulate(50, rng=0).z
    ours = lambda z: imm_filter(models, z, start, transition=Pi, mode_probabilities=mu)  # noqa: E731
    return Race("IMM, 3 models: 50 x 450", z, ours, {"FilterPy": (each(theirs), 2)}, 90)


CRUISE, START = constant_velocity(1.0, 0.1, 1.0), Gaussian([0, 0], np.eye(2))


def long_series():
    return simulate(CRUISE, START, 100_000, rng=0).z[None]


def one_at_a_time(name, model, initial, theirs, z):
    """Readings as they come from a sensor: a single run, each of whose means is read at once."""

    def ours(z):
        live, means = OnlineFilter(model, initial), np.empty((z.shape[1], model.n))
        for k, reading in enumerate(z[0]):
            live.step(reading)
            means[k] = live.mean
        return SimpleNamespace(mean=means[None])

    return Race(name, z, ours, {"FilterPy": (each(theirs), 1)}, 1)


def sensors():
    """One after the other: two states and one measurement, linear, and as functions with Jacobians."""
    F, H = CRUISE.F, CRUISE.H
    bent = NonlinearModel(lambda x: x @ F.T, lambda x: x @ H.T, CRUISE.Q, CRUISE.R, lambda x: F, lambda x: H)
    z = simulate(CRUISE, START, 5000, rng=0).z[None]

    def extended(series):
        kf = ExtendedKalmanFilter(dim_x=2, dim_z=1)
        kf.x, kf.P, kf.F, kf.Q, kf.R = START.mean.copy(), START.cov.copy(), F, CRUISE.Q, CRUISE.R
        return loop(kf, series, HJacobian=lambda x: H, Hx=lambda x: H @ x)

    yield one_at_a_time(
        "one at a time: 1 x 5,000", CRUISE, START, lambda series: loop(their_kalman_filter(CRUISE, START), series), z
    )
    yield one_at_a_time("one at a time, EKF: 1 x 5,000", bent, START, extended, z)


def races():
    volt, ship = scenarios.voltmeter(), scenarios.ship()
    ship_z = simulate(ship.model, ship.initial, 80, runs=1000, rng=0).z
    yield linear("voltmeter: 10,000 x 20", volt.model, volt.initial, volt.simulate(10_000, rng=0).z, 200, 2000)
    yield linear("ship GPS: 1,000 x 80", ship.model, ship.initial, ship_z, 30, 700)
    yield smoothed("ship, smoothed: 1,000 x 80", ship.model, ship.initial, ship_z, 20, 600)
    yield linear("constant velocity: 1 x 100,000", CRUISE, START, long_series(), 1, 250)
    yield range_and_bearing()
    yield missile()
    yield manoeuvring()
    yield from sensors()


def best(function, repeats):
    times = []
    for _ in range(repeats):
        begin = time.perf_counter()
        function()
        times.append(time.perf_counter() - begin)
    return min(times)


def run(race, rounds=25):
    """Check that all agree, then time them. Raises an AssertionError when a rival disagrees."""
    track, times, differences = race.ours(race.z), {}, []
    for name, (rival, sample) in race.rivals.items():
        some = race.z[:sample]
        theirs = rival(some)
        differences.append(abs(track.mean[: len(some)] - theirs).max() / abs(theirs).max())
        assert differences[-1] < race.tolerance, f"{race.name}: {name} disagrees by {differences[-1]:.1e}"
        times[name] = best(lambda: rival(some), 3) * len(race.z) / len(some)  # noqa: B023
    return Result(race, best(lambda: race.ours(race.z), rounds), times, max(differences))


RIVALS = "FilterPy", "simdkalman", "statsmodels"


def table(results):
    """The lines of a table in Markdown."""
    yield "| | kflearn | " + " | ".join(f"{name} | ratio" for name in RIVALS) + " | goal | largest difference |"
    yield "|---|" + "---:|" * (2 * len(RIVALS) + 3)
    for race, ours, rivals, difference in results:
        cells = [f"{1e3 * ours:.2f} ms"]
        for name in RIVALS:
            goal, theirs = race.goal if name == "FilterPy" else 1, rivals.get(name)
            cells += [f"{1e3 * theirs:,.0f} ms", judged(theirs / ours, goal)] if theirs else ["", ""]
        yield f"| {race.name} | {' | '.join(cells)} | {race.goal} | {difference:.0e} |"


if __name__ == "__main__":
    for line in table(map(run, races())):
        print(line, flush=True)
