#!/bin/sh
# ahrs 0.4.0: two functions of one package give the angles of one quaternion, and one of them gives those of the
# inverse rotation. The estimator AQUA turns the other way than Madgwick, Mahony and EKF.
#
# Expected: roll 10, pitch 20, yaw 30 degrees (z-y-x) from both functions. A level sensor that turns at +10 degrees a
# second for 2 s has the yaw +20, from every estimator.
# Seen: Quaternion.to_angles() gives 10, 20, 30; q2euler() gives 1.1, -22.2, -28.5, which are the angles of the
# conjugate. Yaw of Madgwick, Mahony and EKF +19.9, of AQUA -19.9, all in the same attribute Q.
# Who is hurt: whoever compares two estimators, or passes Q on to a filter of position: north and south, left and
# right change places.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet ahrs==0.4.0 numpy==2.4.6 scipy==1.17.1
"$folder/env/bin/python" - <<'PYTHON'
import ahrs
import numpy as np
from scipy.spatial.transform import Rotation

attitude = Rotation.from_euler("ZYX", [30, 20, 10], degrees=True)
q = np.roll(attitude.as_quat(), 1)  # the scalar first
inverse = attitude.inv().as_euler("ZYX", degrees=True)[::-1]
first = np.degrees(ahrs.Quaternion(q).to_angles())
second = np.degrees(ahrs.common.orientation.q2euler(q))
print("to_angles", first.round(1), "q2euler", second.round(1), "angles of the inverse", inverse.round(1))
assert np.allclose(first, [10, 20, 30]) and np.allclose(second, inverse), "this has changed"

rate = np.zeros((200, 3))
rate[:, 2] = np.radians(10)
gravity = np.tile([0, 0, 9.81], (200, 1))
for name, seen in (("Madgwick", 19.9), ("Mahony", 19.9), ("EKF", 19.9), ("AQUA", -19.9)):
    estimator = getattr(ahrs.filters, name)(gyr=rate, acc=gravity, frequency=100.0)
    yaw = np.degrees(ahrs.Quaternion(estimator.Q[-1]).to_angles())[2]
    print(f"{name}: yaw {yaw:.1f}")
    assert abs(yaw - seen) < 0.05, "this has changed"
PYTHON
