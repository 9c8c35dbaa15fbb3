"""kalman-py

The starts agree, so nothing is converted but the gap, which it does not know: predict and update one step at a time.
`filter` gives `log_likelihood` with log 2π where no reading is missing.
"""

import numpy as np
from kalman_py import KalmanFilter

PINS = "kalman-py==0.1.1 numpy==2.4.6 scipy==1.17.1"


def plain(F, H, Q, R, x, P, z):
    done = KalmanFilter(F, H, Q, R, x, P).filter(z)
    return done.means, done.covs, done.log_likelihood


def same(F, H, Q, R, x, P, z):
    means, covs = [], []
    for reading in z:
        kf = KalmanFilter(F, H, Q, R, x, P)  # from the belief of the step before
        x, P = F @ x, F @ P @ F.T + Q
        if not np.isnan(reading).any():
            done = kf.filter(reading[None])
            x, P = done.means[0], done.covs[0]
        means, covs = [*means, x], [*covs, P]
    return means, covs
