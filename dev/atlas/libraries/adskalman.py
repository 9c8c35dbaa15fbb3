"""adskalman

A reading of which a part is NaN is dropped as a whole. Its log-likelihood is the fourth result with `full_output=True`,
which is an error where a reading is missing.
"""

import numpy as np
from adskalman.adskalman import kalman_filter

PINS = "adskalman==0.3.12 numpy==2.4.6 scipy==1.17.1"


def plain(F, H, Q, R, x, P, z):
    whole = not np.isnan(z).any()  # else full_output=True is an error
    means, covs, *rest = kalman_filter(z, F, H, Q, R, x, P, full_output=whole)
    return means, covs, *rest[1:]


def same(F, H, Q, R, x, P, z):
    means, covs, *_ = kalman_filter(z, F, H, Q, R, F @ x, F @ P @ F.T + Q)
    return np.array(means), np.array(covs)
