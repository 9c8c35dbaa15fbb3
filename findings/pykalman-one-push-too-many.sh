#!/bin/sh
# pykalman 0.11.2: given one control offset for each reading, KalmanFilter uses all but the last of them, without a
# word, and every push comes one step late.
#
# Expected: ten offsets for nine steps are refused, or the first of them leads to the first reading.
# Seen: ten readings have nine steps between them. Nine offsets and ten give an estimate without any message, and with
# ten the offset of row k works in the step from k to k + 1, so the last one is never used.
# Right: a cart that starts at rest and is pushed by u[k] in the step to reading k. With u[1:] the estimates follow it.
# Who is hurt: whoever logs readings and commands side by side, row by row, and hands both tables over.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet pykalman==0.11.2 numpy==2.4.6 scipy==1.17.1
"$folder/env/bin/python" -W error - <<'PYTHON'
import numpy as np
from pykalman import KalmanFilter

push = np.zeros((10, 1))
push[5] = 7.0  # the log: in the step to reading 5 the cart was moved by 7 m
place = np.cumsum(push)  # where it stands at each reading
rows = dict(initial_state_mean=[0], initial_state_covariance=[[1]])


def estimates(offsets, **more):
    filter_ = KalmanFilter([[1]], [[1]], [[0.01]], [[100]], transition_offsets=offsets, **rows, **more)
    return filter_.filter(place[:, None])[0][:, 0]


right, late = estimates(push[1:]), estimates(push)
print("the cart     ", place)
print("nine offsets ", right.round(2))
print("ten offsets  ", late.round(2))
assert np.allclose(right, place), "nine offsets: this has changed"
assert abs(late[5] - place[5]) > 6 and abs(late[6] - place[6]) < 0.2, "ten offsets: this has changed"
never_used = push.copy()
never_used[9] = 1e6
assert np.array_equal(estimates(never_used), late), "the last offset: this has changed"
PYTHON
