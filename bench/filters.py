"""Our filters against FilterPy's loop: same numbers, one run, one thread, agreement checked before anything is timed.

    python bench/filters.py          prints a table of ratios (time of FilterPy / time of kflearn)

FilterPy filters one run at a time, so it is timed on a part of the runs and the time is scaled up.
"""

import os

os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")

import time
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from filterpy.kalman import (
    ExtendedKalmanFilter,
    IMMEstimator,
    KalmanFilter,
    MerweScaledSigmaPoints,
    UnscentedKalmanFilter,
)

from kflearn import (
    Gaussian,
    NonlinearModel,
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
from kflearn.multiple_models import lifted


class Race(NamedTuple):
    """ours(z) → Track of all runs; theirs(z of one run) → means (T, n); what to filter, and on how many runs."""

    name: str
    z: np.ndarray
    ours: Callable
    theirs: Callable
    sample: int
    goal: float
    tolerance: float = 1e-9


def their_kalman_filter(model, initial):
    kf = KalmanFilter(dim_x=model.n, dim_z=model.m)
    kf.x, kf.P = initial.mean.copy(), initial.cov.copy()
    kf.F, kf.H, kf.Q, kf.R = model.F, model.H, model.Q, model.R
    return kf


def linear(name, model, initial, z, sample, goal):
    def theirs(series):
        return loop(their_kalman_filter(model, initial), series)

    return Race(name, z, lambda z: kalman_filter(model, z, initial), theirs, sample, goal)


def loop(kf, series, **how):
    means = np.empty((len(series), len(kf.x)))
    for k, z in enumerate(series):
        kf.predict()
        kf.update(z, **how)
        means[k] = kf.x
    return means


def smoothed(name, model, initial, z, sample, goal):
    def theirs(series):
        kf = their_kalman_filter(model, initial)
        means, covs, _, _ = kf.batch_filter(series)
        return kf.rts_smoother(means, covs)[0]

    return Race(name, z, lambda z: rts_smoother(model, kalman_filter(model, z, initial)), theirs, sample, goal)


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

    return Race("UKF, 6 states: 1,000 x 50", scene.simulate(1000, rng=0).z, ours, theirs, 20, 70, 1e-6)


def missile():
    """The homing missile's nine states and two angles, without its guidance and with a constant R."""
    F, Q, R = homing.F, homing.Q, 1e-8 * np.eye(2)
    model = NonlinearModel(lambda x: x @ F.T, homing.angles, Q, R, lambda x: F, homing.angles_jacobian)
    start = np.array([3500.0, 1500, 1000, -500, -150, -50, 0, 0, 0])
    initial = Gaussian(start, homing.START.cov)

    def theirs(series):
        kf = ExtendedKalmanFilter(dim_x=9, dim_z=2)
        kf.x, kf.P, kf.F, kf.Q, kf.R = initial.mean.copy(), initial.cov.copy(), F, Q, R
        return loop(kf, series, HJacobian=homing.angles_jacobian, Hx=homing.angles)

    z = simulate(model, start, 367, runs=50, rng=0).z
    ours = lambda z: extended_kalman_filter(model, z, initial)  # noqa: E731
    return Race("EKF, 9 states: 50 x 367", z, ours, theirs, 3, 14, 1e-6)


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
    return Race("IMM, 3 models: 50 x 450", z, lambda z: imm_filter(models, z, start, Pi, mu), theirs, 2, 60)


def races():
    volt, ship = scenarios.voltmeter(), scenarios.ship()
    cruise, start = constant_velocity(1.0, 0.1, 1.0), Gaussian([0, 0], np.eye(2))
    ship_z = simulate(ship.model, ship.initial, 80, runs=1000, rng=0).z
    yield linear("voltmeter: 10,000 x 20", volt.model, volt.initial, volt.simulate(10_000, rng=0).z, 200, 1000)
    yield linear("ship GPS: 1,000 x 80", ship.model, ship.initial, ship_z, 30, 500)
    yield smoothed("ship, smoothed: 1,000 x 80", ship.model, ship.initial, ship_z, 20, 500)
    long = simulate(cruise, start, 100_000, rng=0).z[None]
    yield linear("constant velocity: 1 x 100,000", cruise, start, long, 1, 100)
    yield range_and_bearing()
    yield missile()
    yield manoeuvring()


def best(function, repeats):
    times = []
    for _ in range(repeats):
        begin = time.perf_counter()
        function()
        times.append(time.perf_counter() - begin)
    return min(times)


def main():
    print(f"{'':32}{'FilterPy':>12}{'kflearn':>12}{'ratio':>9}{'goal':>7}   largest difference")
    for race in races():
        some = race.z[: race.sample]
        track = race.ours(race.z)
        theirs = np.stack([race.theirs(series) for series in some])
        difference = abs(track.mean[: race.sample] - theirs).max() / abs(theirs).max()
        assert difference < race.tolerance, f"{race.name}: FilterPy disagrees by {difference:.1e}"
        slow = best(lambda: [race.theirs(series) for series in some], 3) * len(race.z) / len(some)  # noqa: B023
        fast = best(lambda: race.ours(race.z), 25)  # noqa: B023
        ratio = slow / fast
        print(f"{race.name:32}{slow * 1e3:9.0f} ms{fast * 1e3:9.2f} ms{ratio:9.0f}{race.goal:7.0f}   {difference:.0e}")


if __name__ == "__main__":
    main()
