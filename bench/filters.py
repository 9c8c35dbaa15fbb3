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
from filterpy.kalman import ExtendedKalmanFilter, KalmanFilter, MerweScaledSigmaPoints, UnscentedKalmanFilter

from kflearn import (
    Gaussian,
    NonlinearModel,
    constant_velocity,
    extended_kalman_filter,
    kalman_filter,
    rts_smoother,
    scenarios,
    simulate,
    unscented_kalman_filter,
)


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
    """[KM] six states, distance and bearing (SYSTEMS B, UKF6)."""
    t = 0.5
    F = np.kron([[1, t, t**2 / 2], [0, 1, t], [0, 0, 1]], np.eye(2))

    def measure(x):
        return np.stack([np.hypot(x[..., 0], x[..., 1]), np.arctan2(x[..., 1], x[..., 0])], axis=-1)

    Q, R = np.diag([1, 1, 0.01, 0.01, 1e-4, 1e-4]), np.diag([100, 1e-6])
    model = NonlinearModel(lambda x: x @ F.T, measure, Q, R)
    initial = Gaussian([1000, 5000, 10, 50, 2, -4], np.diag([100, 100, 1, 1, 0.1, 0.1]))

    def theirs(series):
        points = MerweScaledSigmaPoints(6, alpha=0.01, beta=2, kappa=0)
        kf = UnscentedKalmanFilter(6, 2, dt=t, hx=measure, fx=lambda x, dt: F @ x, points=points)
        kf.x, kf.P, kf.Q, kf.R = initial.mean.copy(), initial.cov.copy(), Q, R
        return loop(kf, series)

    def ours(z):
        return unscented_kalman_filter(model, z, initial, alpha=0.01, beta=2, kappa=0)

    z = simulate(model, initial, 50, runs=1000, rng=0).z
    return Race("UKF, 6 states: 1,000 x 50", z, ours, theirs, 20, 70, 1e-6)


def missile():
    """Nine states in space, two angles (SYSTEMS B, the homing missile without its guidance)."""
    dt, rate = 0.01, 1.0
    decay = np.exp(-rate * dt)
    axis = [[1, dt, (decay + rate * dt - 1) / rate**2], [0, 1, (1 - decay) / rate], [0, 0, decay]]
    F = np.kron(axis, np.eye(3))

    def measure(r):
        x, y, z = r[..., 0], r[..., 1], r[..., 2]
        return np.stack([np.arctan(y / np.sqrt(x**2 + z**2)), np.arctan(-z / x)], axis=-1)

    def slope(r):
        x, y, z = r[..., 0], r[..., 1], r[..., 2]
        ground, all_ = x**2 + z**2, x**2 + y**2 + z**2
        level = np.sqrt(ground)
        H = np.zeros((*r.shape[:-1], 2, 9))
        H[..., 0, 0], H[..., 0, 1], H[..., 0, 2] = -x * y / (all_ * level), level / all_, -y * z / (all_ * level)
        H[..., 1, 0], H[..., 1, 2] = z / ground, -x / ground
        return H

    Q, R = np.diag([0, 0, 0, 0, 0, 0, 0.1, 0.1, 0.1]), 1e-8 * np.eye(2)
    model = NonlinearModel(lambda x: x @ F.T, measure, Q, R, F_jacobian=lambda x: F, H_jacobian=slope)
    start = [3500, 1500, 1000, -500, -150, -50, 0, 0, 0]
    initial = Gaussian(start, np.diag([1e4] * 6 + [1e2] * 3))

    def theirs(series):
        kf = ExtendedKalmanFilter(dim_x=9, dim_z=2)
        kf.x, kf.P, kf.F, kf.Q, kf.R = initial.mean.copy(), initial.cov.copy(), F, Q, R
        return loop(kf, series, HJacobian=slope, Hx=measure)

    z = simulate(model, np.array(start, dtype=float), 367, runs=50, rng=0).z
    ours = lambda z: extended_kalman_filter(model, z, initial)  # noqa: E731
    return Race("EKF, 9 states: 50 x 367", z, ours, theirs, 3, 14, 1e-6)


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
