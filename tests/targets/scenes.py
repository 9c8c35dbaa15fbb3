"""Models and scans that the tests of this room share."""

import numpy as np

from kflearn import Gaussian, LinearModel, constant_velocity, scan_targets, simulate

LINE = constant_velocity(dt=1, acceleration=0.2, R=4.0)
PLANE = LinearModel(*(np.kron(np.eye(2), M) for M in (LINE.F, LINE.H, LINE.Q, LINE.R)))  # x, v_x, y, v_y
START = Gaussian([0, 3, 0, 1], np.diag([25, 1, 25, 1]))
AREA = [[-100, 300], [-100, 200]]


def one_target(runs, steps=30, detection=0.9, clutter=1e-3, rng=0):
    """A target among false readings, in many runs: true states (runs, T, n) and scans."""
    rng = np.random.default_rng(rng)
    x = simulate(PLANE, START, steps, runs=runs, rng=rng).x
    return x, scan_targets(PLANE, x[:, :, None], detection, clutter, AREA, rng)
