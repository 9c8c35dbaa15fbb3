"""simdkalman

Data have the shape (series, time, m). Its log-likelihood has no log 2π in it: take ½ log 2π off for each number that
was used, which those of half a reading are not.
"""

import numpy as np
from simdkalman import KalmanFilter

PINS = "simdkalman==1.0.4 numpy==2.4.6"


def plain(F, H, Q, R, x, P, z):
    kf = KalmanFilter(F, Q, H, R)
    done = kf.compute(z[None], 0, x, P, filtered=True, log_likelihood=True)
    return done.filtered.states.mean[0], done.filtered.states.cov[0], done.log_likelihood[0]


def same(F, H, Q, R, x, P, z):
    kf = KalmanFilter(F, Q, H, R)
    start = F @ x, F @ P @ F.T + Q
    done = kf.compute(z[None], 0, *start, filtered=True, log_likelihood=True)
    means, covs = done.filtered.states.mean[0], done.filtered.states.cov[0]
    used = z[~np.isnan(z).any(axis=1)].size
    return means, covs, done.log_likelihood[0] - used * np.log(2 * np.pi) / 2
