"""statsmodels

Time is the last axis. Their names: `design` is our H, `obs_cov` our R, `selection` is I where every state has its
noise. `loglikelihood_burn` leaves the first steps out of the sum.
"""

import numpy as np
from statsmodels.tsa.statespace.kalman_smoother import KalmanSmoother

PINS = "statsmodels==0.15.0 numpy==2.4.6 scipy==1.17.1 pandas==3.1.1"


def plain(F, H, Q, R, x, P, z):
    kf = KalmanSmoother(k_endog=len(R), k_states=len(x), initialization="known", constant=x, stationary_cov=P)
    kf.bind(np.array(z))
    kf["design"], kf["transition"], kf["selection"] = H, F, np.eye(len(x))
    kf["state_cov"], kf["obs_cov"] = Q, R
    done = kf.filter()
    return done.filtered_state.T, np.moveaxis(done.filtered_state_cov, -1, 0), done.llf


def same(F, H, Q, R, x, P, z):
    start = {"constant": F @ x, "stationary_cov": F @ P @ F.T + Q}
    kf = KalmanSmoother(k_endog=len(R), k_states=len(x), initialization="known", **start)
    kf.bind(np.array(z))
    kf["design"], kf["transition"], kf["selection"] = H, F, np.eye(len(x))
    kf["state_cov"], kf["obs_cov"] = Q, R
    done = kf.filter()
    return done.filtered_state.T, np.moveaxis(done.filtered_state_cov, -1, 0), done.llf
