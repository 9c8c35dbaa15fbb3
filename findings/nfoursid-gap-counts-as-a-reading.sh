#!/bin/sh
# nfoursid 1.0.2: Kalman.step(y=None) is meant for a missing output, but the covariance shrinks as if the output had
# been measured.
#
# Expected: without an output the filter predicts: a random walk with Q = 1 that is unread for ten steps has the
# variance 11 (it starts at N(0, 1)).
# Seen: 1.618 before each step and 0.618 after it, which is what ten readings with R = 1 leave. The mean is only
# predicted. The first reading after the gap then gets the gain 0.62 in place of 0.92.
# Who is hurt: whoever filters a plant whose sensor pauses: the estimate after the pause follows the readings slowly,
# and its claimed standard deviation is four times too small while it is worst.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet nfoursid==1.0.2 numpy==2.4.6
"$folder/env/bin/python" - <<'PYTHON'
import numpy as np
from nfoursid.kalman import Kalman
from nfoursid.state_space import StateSpace

one, zero = np.eye(1), np.zeros((1, 1))
kf = Kalman(StateSpace(one, zero, one, zero), np.eye(2))  # the variances of measurement and process noise are 1
for _ in range(10):
    kf.step(None, zero)
before, right = kf.p_predicteds[-1].item(), 1.0 + 10
kf.step(np.array([[5.0]]), zero)
gain = kf.x_filtereds[-1].item() / 5
print(f"variance after ten gaps {before:.4f}, right {right}; gain of the next reading {gain:.4f}, right {11 / 12:.4f}")
assert abs(before - (1 + 5**0.5) / 2) < 1e-3 and abs(gain - 0.618) < 1e-3, "this has changed"
PYTHON
