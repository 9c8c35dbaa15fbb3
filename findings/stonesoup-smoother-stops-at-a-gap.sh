#!/bin/sh
# stonesoup 1.9.1: KalmanSmoother does not smooth across a step without a detection.
#
# Expected: in a track with a coasted step, which holds a prediction in place of an update, readings after the gap
# improve the estimates before it, as in any fixed-interval smoother.
# Seen: the state before the gap keeps the value of the filter, 1.588 where 2.515 is right, and the states before it
# are smoothed only as far as the gap (1.176 where 1.598 is right). The step of the gap itself and all after it are
# right.
# Who is hurt: whoever smooths the tracks of a tracker with missed detections, which is every tracker: the estimates
# before each miss are worse than they could be, and their covariances say so, so that nothing looks wrong.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet stonesoup==1.9.1 numpy==2.4.6 scipy==1.17.1
"$folder/env/bin/python" - <<'PYTHON'
from datetime import datetime, timedelta

import numpy as np
from stonesoup.models.measurement.linear import LinearGaussian
from stonesoup.models.transition.linear import RandomWalk
from stonesoup.predictor.kalman import KalmanPredictor
from stonesoup.smoother.kalman import KalmanSmoother
from stonesoup.types.detection import Detection
from stonesoup.types.hypothesis import SingleHypothesis
from stonesoup.types.state import GaussianState
from stonesoup.types.track import Track
from stonesoup.updater.kalman import KalmanUpdater

z, Q, R, P, start = [1.0, 2.0, None, 6.0, 7.0], 1.0, 1.0, 4.0, datetime(2026, 3, 1)
motion, sensor = RandomWalk(Q), LinearGaussian(1, (0,), np.array([[R]]))
predictor, updater = KalmanPredictor(motion), KalmanUpdater(sensor)
last, track = GaussianState([[0.0]], [[P]], timestamp=start), Track()
for k, reading in enumerate(z, 1):
    last = predictor.predict(last, timestamp=start + timedelta(seconds=k))
    if reading is not None:
        detection = Detection([[reading]], timestamp=last.timestamp, measurement_model=sensor)
        last = updater.update(SingleHypothesis(last, detection))
    track.append(last)
smooth = np.array([float(state.mean[0, 0]) for state in KalmanSmoother(motion).smooth(track)])
filtered = np.array([float(state.mean[0, 0]) for state in track])

# The states are one Gaussian: the covariance of a walk that starts at N(0, P) is P + Q min(j, k).
k = np.arange(1, 6)
cov, there = P + Q * np.minimum(k[:, None], k), np.array([0, 1, 3, 4])
given = np.array([z[j] for j in there])
right = cov[:, there] @ np.linalg.solve(cov[np.ix_(there, there)] + R * np.eye(4), given)
print("filter", filtered.round(4), "smoother", smooth.round(4), "right", right.round(4))
assert np.allclose(smooth[2:], right[2:]) and smooth[1] == filtered[1], "this has changed"
assert np.allclose(smooth[:2], [1.1765, 1.5882], atol=1e-4), "this has changed"
PYTHON
