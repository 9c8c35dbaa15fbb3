#!/bin/sh
# pykalman 0.11.2: a reading that is NaN (and not masked) makes all later estimates NaN, but loglikelihood() returns a
# finite number, larger than the right one.
#
# Expected: NaN as "not measured", or an error, or NaN everywhere.
# Seen: for 1, NaN, 2 and a random walk with Q = R = 1, start N(0, 1) at the first reading: filter 0.5, NaN, NaN; smoother
# NaN three times; loglikelihood -2.5155. With the reading masked it is -3.3823, which is right.
# Who is hurt: whoever compares models or searches for parameters by loglikelihood() on a series with gaps from pandas or a
# CSV file: the number looks fine, and a series with more gaps looks better.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet pykalman==0.11.2 numpy==2.4.6 scipy==1.17.1
"$folder/env/bin/python" - <<'PYTHON'
import numpy as np
from pykalman import KalmanFilter

kf = KalmanFilter([[1.0]], [[1.0]], [[1.0]], [[1.0]], initial_state_mean=[0.0], initial_state_covariance=[[1.0]])
z = np.array([[1.0], [np.nan], [2.0]])
masked = np.ma.masked_invalid(z)
# 1 comes from N(0, 1 + 1); then the state is N(0.5, 0.5), two steps later N(0.5, 2.5), and 2 comes from N(0.5, 3.5)
right = -0.5 * (np.log(2 * np.pi * 2) + 1 / 2 + np.log(2 * np.pi * 3.5) + 1.5**2 / 3.5)
given, known = kf.loglikelihood(z), kf.loglikelihood(masked)
print(f"NaN: filter {kf.filter(z)[0].ravel()}, loglikelihood {given:.4f}; masked: {known:.4f}; right: {right:.4f}")
assert np.isnan(kf.filter(z)[0][1:]).all() and np.isnan(kf.smooth(z)[0]).all(), "this has changed"
assert abs(known - right) < 1e-9 and abs(given + 2.5155) < 1e-4 and given > right, "this has changed"
PYTHON
