"""One reading at a time: what a step of OnlineFilter costs, beside FilterPy's predict and update.

    python -m dev.bench.online

ExtendedKalmanFilter.predict_update takes the Jacobian of the measurement before the prediction, so its numbers are
others than those of predict and update; how far they are from ours is said, and not checked.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from dev.bench import filters
from dev.bench.filters import CRUISE, START, best
from dev.bench.goals import judged
from kflearn import OnlineFilter, homing

STEPS = 2000  # of the Kalman filter; the missile has 367


class Steps(NamedTuple):
    """make() → (step, state): step(reading) goes one step on, state() is the mean then."""

    name: str
    z: np.ndarray
    ours: Callable
    theirs: Callable
    tolerance: float = 1e-9  # None: not checked


def ours(model, initial):
    live = OnlineFilter(model, initial)
    return live.step, lambda: live.mean


def predict_and_update(kf, **how):
    """FilterPy's two calls as one step."""

    def step(z):
        kf.predict()
        kf.update(z, **how)

    return step, lambda: kf.x


def predict_update(kf, **how):
    """FilterPy's one call."""
    return lambda z: kf.predict_update(z, **how), lambda: kf.x


def races():
    missile, angles = filters.missile(), dict(HJacobian=homing.angles_jacobian, Hx=homing.angles)

    def theirs():
        return filters.their_missile_filter(missile.initial, missile.model.R)

    def kalman():
        return predict_and_update(filters.their_kalman_filter(CRUISE, START))

    z = filters.long_series()[0, :STEPS]
    yield Steps("KF, 2 states", z, lambda: ours(CRUISE, START), kalman)
    live, z = lambda: ours(missile.model, missile.initial), missile.z[0]
    yield Steps("EKF, 9 states", z, live, lambda: predict_and_update(theirs(), **angles), 1e-6)
    yield Steps("EKF, 9 states, predict_update", z, live, lambda: predict_update(theirs(), **angles), None)


def through(make, z):
    """All means, step by step."""
    step, state = make()
    means = []
    for reading in z:
        step(reading)
        means.append(state().copy())
    return np.array(means)


def microseconds(make, z):
    """Of one step; making the filter is not counted."""
    step, _ = make()

    def all_steps():
        for reading in z:
            step(reading)

    return 1e6 * best(all_steps, 1) / len(z)


def run(race, rounds=9):
    """µs of ours, of theirs, and the largest relative difference. Raises an AssertionError when theirs disagrees."""
    one, other = through(race.ours, race.z), through(race.theirs, race.z)
    difference = abs(one - other).max() / abs(other).max()
    agree = race.tolerance is None or difference < race.tolerance
    assert agree, f"{race.name}: FilterPy disagrees by {difference:.1e}"
    taken = [(microseconds(race.ours, race.z), microseconds(race.theirs, race.z)) for _ in range(rounds)]
    return *np.min(taken, axis=0), difference


def table():
    """The lines of a table in Markdown."""
    yield "| a step of | OnlineFilter | FilterPy | ratio | largest difference |"
    yield "|---|---:|---:|---:|---:|"
    for race in races():
        mine, theirs, difference = run(race)
        ratio = judged(theirs / mine, None)
        yield f"| {race.name} | {mine:.1f} µs | {theirs:.1f} µs | {ratio} | {difference:.0e} |"


if __name__ == "__main__":
    for line in table():
        print(line, flush=True)
