#!/bin/sh
# scipy 1.17.1: solve_discrete_lyapunov, asked for the stationary covariance of a process that has none, returns one
# with negative variances.
#
# Expected: P = F P F' + Q has a solution that is a covariance only if all eigenvalues of F lie inside the unit
# circle. For F = 1.1, an error, infinity, or a warning.
# Seen: for F = 1.1 and Q = 1 the answer is -4.76, the algebraic solution 1 / (1 - 1.21); for two coupled states of
# which one grows by 2 % a step, both variances are negative. No warning.
# Who is hurt: whoever starts a filter with the stationary covariance of a fitted model: one coefficient that was
# estimated above 1 makes P negative, and the filter's numbers still come.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet scipy==1.17.1 numpy==2.4.6
"$folder/env/bin/python" - <<'PYTHON'
import warnings

import numpy as np
from scipy.linalg import solve_discrete_lyapunov

with warnings.catch_warnings():
    warnings.simplefilter("error")
    growing = solve_discrete_lyapunov(np.array([[1.1]]), np.eye(1))[0, 0]
    coupled = solve_discrete_lyapunov(np.array([[1.02, 0.0], [0.3, 0.9]]), np.eye(2))
stable = solve_discrete_lyapunov(np.array([[0.9]]), np.eye(1))[0, 0]
print(f"F = 0.9: {stable:.4f}, right 5.2632; F = 1.1: {growing:.4f}; coupled: {np.diagonal(coupled).round(2)}")
assert abs(stable - 1 / 0.19) < 1e-9, "this has changed"
assert abs(growing + 1 / 0.21) < 1e-9 and (np.diagonal(coupled) < -1).all(), "this has changed"
PYTHON
