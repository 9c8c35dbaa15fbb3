"""pykalman

`filter` starts at the first reading, `filter_update` one step before. A gap must be masked: with a plain NaN the
means become NaN and the log-likelihood stays a number, a wrong one.
"""

import numpy as np
from pykalman import KalmanFilter

PINS = "pykalman==0.11.2 numpy==2.4.6 scipy==1.17.1"


def plain(F, H, Q, R, x, P, z):
    kf = KalmanFilter(F, H, Q, R, initial_state_mean=x, initial_state_covariance=P)
    means, covs = kf.filter(z)
    return means, covs, kf.loglikelihood(z)


def same(F, H, Q, R, x, P, z):
    kf = KalmanFilter(F, H, Q, R, initial_state_mean=F @ x, initial_state_covariance=F @ P @ F.T + Q)
    readings = np.ma.masked_invalid(z)
    means, covs = kf.filter(readings)
    return means, covs, kf.loglikelihood(readings)
