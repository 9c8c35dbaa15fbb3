"""A published smoother with three faults, each of which can be mended; for lesson 23."""

import numpy as np


def fixed_lag(z, model, start, first, second, third, N=10):
    """FilterPy's FixedLagSmoother, re-typed for readings z (runs, T, 1) of one sensor; True mends a fault.

    first: begin with the covariance before the correction; second: F(I − KH) for F − KH; third: go back N steps, not
    N − 1. Returns the estimates (runs, T, n).
    """
    x, P, rows = np.broadcast_to(start.mean, (len(z), model.n)), start.cov, []
    for k in range(z.shape[1]):
        x, before = x @ model.F.T, model.F @ P @ model.F.T + model.Q
        y, weight = z[:, k] - x @ model.H.T, model.H.T / (model.H @ before @ model.H.T + model.R)
        K = before @ weight
        rows.append(x)
        x, P = x + y @ K.T, before - K @ model.H @ before
        through = (model.F @ (np.eye(model.n) - K @ model.H) if second else model.F - K @ model.H).T
        back = before if first else P
        if k < N:
            rows[k] = x
            continue
        for i in range(N + third):
            rows[k - i] = rows[k - i] + y @ (back @ weight).T
            back = back @ through
    return np.stack(rows, axis=1)
