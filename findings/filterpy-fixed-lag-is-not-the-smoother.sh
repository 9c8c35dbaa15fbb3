#!/bin/sh
# filterpy 2.0.0: FixedLagSmoother.smooth_batch(z, N=2) does not give the mean of each state given the readings up to
# two steps later.
#
# Expected: for a linear model the estimates of a fixed-lag smoother are conditional means, and the newest one is that
# of the filter.
# Seen: for six readings of a random walk every estimate is off by 0.6 to 1.3, also the newest one, where the filter's
# own last estimate has the standard deviation 1.0. The second list that it returns, the filter's, ends with the right
# value.
# Who is hurt: whoever smooths on-line with a lag: the numbers look smooth, and nothing says that they are not the
# best ones.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet filterpy==2.0.0 numpy==2.4.6 scipy==1.17.1 matplotlib==3.11.1
"$folder/env/bin/python" - <<'PYTHON'
import numpy as np
from filterpy.kalman import FixedLagSmoother

Q, R, P, N = 1.0, 2.0, 4.0, 2
z = np.array([1.2, 2.7, 3.1, 5.4, 5.9, 7.6])
T = len(z)
smoother = FixedLagSmoother(dim_x=1, dim_z=1, N=N)
smoother.x, smoother.P, smoother.Q, smoother.R = np.zeros((1, 1)), P * np.eye(1), Q * np.eye(1), R * np.eye(1)
smoother.F = smoother.H = np.eye(1)
seen, filtered = (np.ravel(part)[:T] for part in smoother.smooth_batch(z[:, None, None], N))

# The states are one Gaussian: a walk of k steps from N(0, P) has the covariance P + Q min(j, k).
k = np.arange(1, T + 1)
cov = P + Q * np.minimum(k[:, None], k)


def mean_given(count):
    """All states, given the first `count` readings."""
    return cov[:, :count] @ np.linalg.solve(cov[:count, :count] + R * np.eye(count), z[:count])


right = np.array([mean_given(min(j + N + 1, T))[j] for j in range(T)])
print("seen ", seen.round(4))
print("right", right.round(4), "filter", mean_given(T)[-1].round(4), "theirs", filtered.round(4))
spread = np.sqrt(cov[-1, -1] - cov[-1] @ np.linalg.solve(cov + R * np.eye(T), cov[-1]))
print(f"largest error {np.abs(seen - right).max():.2f}; standard deviation of the filter's last estimate {spread:.2f}")
assert np.allclose(seen, [0.8571, 2.0181, 2.5362, 3.4662, 4.7769, 5.5977], atol=1e-3), "this has changed"
assert np.isclose(filtered[-1], right[-1]) and np.abs(seen - right).min() > 0.5, "this has changed"
PYTHON
