"""ssfortran

Names as in statsmodels: `design` is our H, `obs_cov` our R. Readings have time first, results have it last.
"""

import numpy as np
from ssfortran import Representation

PINS = "ssfortran==0.1.4 numpy==2.4.6"


def plain(F, H, Q, R, x, P, z):
    kf = Representation(z, len(x))
    kf["design"], kf["transition"], kf["state_cov"], kf["obs_cov"] = H, F, Q, R
    kf.initialize_known(x, P)
    done = kf.filter()
    return done.filtered_state.T, np.moveaxis(done.filtered_state_cov, -1, 0), done.llf


def same(F, H, Q, R, x, P, z):
    kf = Representation(z, len(x))
    kf["design"], kf["transition"], kf["state_cov"], kf["obs_cov"] = H, F, Q, R
    kf.initialize_known(F @ x, F @ P @ F.T + Q)
    done = kf.filter()
    return done.filtered_state.T, np.moveaxis(done.filtered_state_cov, -1, 0), done.llf
