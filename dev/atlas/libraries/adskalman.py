"""adskalman

A reading of which a part is NaN is dropped as a whole. The likelihood is not computed where a reading is missing.
"""

import numpy as np
from adskalman.adskalman import kalman_filter

PINS = "adskalman==0.3.12 numpy==2.4.6 scipy==1.17.1"


def plain(F, H, Q, R, x, P, z):
    means, covs, *_ = kalman_filter(z, F, H, Q, R, x, P)
    return means, covs


def same(F, H, Q, R, x, P, z):
    means, covs, *_ = kalman_filter(z, F, H, Q, R, F @ x, F @ P @ F.T + Q)
    return np.array(means), np.array(covs)
