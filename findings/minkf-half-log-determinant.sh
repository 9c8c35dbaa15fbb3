#!/bin/sh
# minkf 0.0.5: run_filter(..., likelihood=True) returns ½ Σ y²/S + Σ log 2πS, without the ½ before the logarithm.
#
# Expected: minus the log-likelihood, ½ Σ (y²/S + log 2πS), which has its minimum at the variance of the readings.
# Seen: for white noise of variance 4 (400 readings, R = 4) it returns 1487.98 where 843.15 is right, and over a grid of R
# the minimum lies at R = 2.
# Who is hurt: whoever minimises it to find Q and R: every variance comes out half as large, so σ is 29 % too small, and
# the search says that it has converged.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet minkf==0.0.5 numpy==2.4.6
"$folder/env/bin/python" - <<'PYTHON'
import minkf
import numpy as np

z = np.random.default_rng(0).normal(0, 2, 400)


def returned(R):
    """Readings of a state that is 0 for certain: each innovation is the reading, and S = R."""
    zero, one = np.zeros((1, 1)), np.eye(1)
    readings = [np.array([v]) for v in z]
    return minkf.run_filter(readings, np.zeros(1), zero, one, one, zero, R * one, likelihood=True)["loglike"]


right = 0.5 * np.sum(z**2 / 4 + np.log(2 * np.pi * 4))
lacking = np.sum(0.5 * z**2 / 4 + np.log(2 * np.pi * 4))
print(f"returned {returned(4.0):.2f}, right {right:.2f}, without the half {lacking:.2f}")
assert np.isclose(returned(4.0), lacking) and not np.isclose(returned(4.0), right), "this has changed"
grid = np.linspace(0.5, 8, 151)
best = grid[np.argmin([returned(R) for R in grid])]
print(f"least at R = {best:.2f}; the readings' mean square is {np.mean(z**2):.2f}")
assert abs(best - np.mean(z**2) / 2) < 0.06, "this has changed"
PYTHON
