"""FilterPy

A gap is None, not NaN. `log_likelihood` belongs to one step and has log 2π in it; after update(None) it is
that of an innovation 0 with the S of the step before, so add up only the steps with a reading.
"""

import numpy as np
from filterpy.kalman import KalmanFilter

PINS = "filterpy==2.0.0 numpy==2.4.6 scipy==1.17.1 matplotlib==3.11.2"


def plain(F, H, Q, R, x, P, z):
    kf = KalmanFilter(dim_x=len(x), dim_z=len(R))
    kf.F, kf.H, kf.Q, kf.R, kf.x, kf.P = F, H, Q, R, x, P
    means, covs, likelihood = [], [], 0.0
    for reading in z:
        kf.predict()
        kf.update(reading)
        means, covs, likelihood = [*means, kf.x], [*covs, kf.P], likelihood + kf.log_likelihood
    return means, covs, likelihood


def same(F, H, Q, R, x, P, z):
    kf = KalmanFilter(dim_x=len(x), dim_z=len(R))
    kf.F, kf.H, kf.Q, kf.R, kf.x, kf.P = F, H, Q, R, x, P
    readings = [None if np.isnan(reading).all() else reading for reading in z]
    means, covs, *_ = kf.batch_filter(readings)
    return means, covs
