"""minkf

Its M is our F, its K our H; readings and estimates are lists. Its likelihood is minus the log-likelihood, but do
not use it: a factor ½ is missing before the logarithm (`findings/minkf-half-log-determinant.sh`).
"""

import minkf
import numpy as np

PINS = "minkf==0.0.5 numpy==2.4.6"


def plain(F, H, Q, R, x, P, z):
    done = minkf.run_filter(list(z), x, P, F, H, Q, R, likelihood=True)
    return done["x"], done["C"], done["loglike"]


def same(F, H, Q, R, x, P, z):
    done = minkf.run_filter(list(z), x, P, F, H, Q, R)
    return np.array(done["x"]), np.array(done["C"])
