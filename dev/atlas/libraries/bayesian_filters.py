"""bayesian-filters

The classes are those of FilterPy, in a package of another name. A gap is None in update(), one step at a time;
batch_filter() refuses None where one component is measured.
"""

import numpy as np
from bayesian_filters.kalman import KalmanFilter

PINS = "bayesian-filters==1.4.5 numpy==2.4.6 scipy==1.17.1 matplotlib==3.11.2"


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
    means, covs = [], []
    for reading in z:
        kf.predict()
        kf.update(None if np.isnan(reading).all() else reading)
        means, covs = [*means, kf.x], [*covs, kf.P]
    return means, covs
