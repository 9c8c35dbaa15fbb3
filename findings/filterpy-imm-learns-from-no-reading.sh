#!/bin/sh
# filterpy 2.0.0: an IMMEstimator whose update(None) is called, because there is no reading, changes the probabilities
# of its models as if it had learnt something.
#
# Expected: without a reading the probabilities only mix, by the transition matrix.
# Seen: ten steps without a reading bring the first model from 0.62 to 0.93; mixing alone would bring it to 0.54. A
# step without a reading counts as one whose reading came exactly as predicted, with the S of the last reading, and
# this favours the model with the smaller S.
# Who is hurt: whoever tracks a target through a gap with several models: after ten steps the estimator is nearly
# certain of the calm model, on no evidence, and its covariance is too small when the target returns.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet filterpy==2.0.0 numpy==2.4.6 scipy==1.17.1 matplotlib==3.11.1
"$folder/env/bin/python" - <<'PYTHON'
import numpy as np
from filterpy.kalman import IMMEstimator, KalmanFilter

moves = np.array([[0.95, 0.05], [0.05, 0.95]])


def walk(Q):
    kf = KalmanFilter(dim_x=1, dim_z=1)
    kf.F = kf.H = np.eye(1)
    kf.x, kf.P, kf.Q, kf.R = np.zeros((1, 1)), np.eye(1), Q * np.eye(1), np.eye(1)
    return kf


imm = IMMEstimator([walk(0.1), walk(4.0)], [0.5, 0.5], moves)
imm.predict()
imm.update(np.array([[0.3]]))
mixed = imm.mu.copy()
for k in range(10):
    imm.predict()
    imm.update(None)
    mixed = mixed @ moves
    print(f"gap {k + 1}: probability of the first model {imm.mu[0]:.4f}, mixing alone {mixed[0]:.4f}")
assert mixed[0] < 0.6 and imm.mu[0] > 0.8, "this has changed"
PYTHON
