"""fast-kalman

Matrices are flat lists, row by row. `update` predicts and corrects; a gap is `predict` alone. It has no likelihood.
"""

import numpy as np
from kalman import LinearKalmanFilter

PINS = "fast-kalman==0.2.4 numpy==2.4.6"


def plain(F, H, Q, R, x, P, z):
    flat = {name: matrix.ravel().tolist() for name, matrix in dict(F=F, H=H, Q=Q, R=R, x=x, P=P).items()}
    kf = LinearKalmanFilter(len(x), len(R), **flat)
    means, covs = [], []
    for reading in z:
        kf.update(reading.tolist())
        means, covs = [*means, kf.x], [*covs, np.reshape(kf.P, P.shape)]
    return means, covs


def same(F, H, Q, R, x, P, z):
    flat = {name: matrix.ravel().tolist() for name, matrix in dict(F=F, H=H, Q=Q, R=R, x=x, P=P).items()}
    kf = LinearKalmanFilter(len(x), len(R), **flat)
    means, covs = [], []
    for reading in z:
        kf.predict() if np.isnan(reading).all() else kf.update(reading.tolist())
        means, covs = [*means, kf.x], [*covs, np.reshape(kf.P, P.shape)]
    return means, covs
