#!/bin/sh
# filterpy 2.0.0: the CubatureKalmanFilter is not the Kalman filter where the model is linear: its innovation variance
# S leaves out Q, the process noise of the step.
#
# Expected: for a linear model, the cubature filter, the unscented filter and the Kalman filter give the same numbers.
# Seen: for a random walk with Q = R = 4 and a start N(10, 9) the first S is 13 (P + R) where 17 (P + Q + R) is right;
# the first gain is 0.69 in place of 0.76, and after four readings P is 6.47 in place of 2.47. update() uses the
# points that were drawn before Q was added; the UnscentedKalmanFilter of the same package draws new ones.
# Who is hurt: whoever takes it for a drop-in replacement of the unscented filter: gates and likelihoods use an S that
# is too small, and the smaller R is, the worse.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet filterpy==2.0.0 numpy==2.4.6 scipy==1.17.1 matplotlib==3.11.1
"$folder/env/bin/python" - <<'PYTHON'
import numpy as np
from filterpy.kalman import CubatureKalmanFilter, KalmanFilter

z = [11.2, 9.7, 13.1, 12.4]


def same(x, dt=1.0):
    return x


cubature = CubatureKalmanFilter(dim_x=1, dim_z=1, dt=1.0, hx=same, fx=same)
linear = KalmanFilter(dim_x=1, dim_z=1)
linear.F = linear.H = np.eye(1)
for kf in (cubature, linear):
    kf.x, kf.P, kf.Q, kf.R = np.array([10.0]), np.array([[9.0]]), np.array([[4.0]]), np.array([[4.0]])
P, right = 9.0, []
for k, reading in enumerate(z):
    for kf in (cubature, linear):
        kf.predict()
        kf.update(np.array([reading]))
    P = 1 / (1 / (P + 4) + 1 / 4)
    print(f"step {k}: S {cubature.S.item():.4f}, P {cubature.P.item():.4f}; Kalman {linear.S.item():.4f}, {P:.4f}")
    assert np.isclose(linear.P.item(), P), "the reference is wrong"
    if k == 0:
        assert np.isclose(cubature.S.item(), 13) and np.isclose(linear.S.item(), 17), "this has changed"
assert abs(cubature.P.item() - 6.473) < 0.001 and abs(P - 2.474) < 0.001, "this has changed"
PYTHON
