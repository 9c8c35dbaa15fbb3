#!/bin/sh
# FilterPy 2.0.0: plot_covariance(mean, cov, interval=0.95) draws an ellipse that holds 85 % of a two-dimensional
# Gaussian, not 95 %.
#
# Expected: the documentation calls `interval` a confidence interval. For two numbers the ellipse that holds 95 % has the
# scale sqrt(-2 ln 0.05) = 2.448 (chi-square with two degrees of freedom).
# Seen: the scale is 1.960, the quantile of ONE normal number, so 1 - exp(-1.96^2 / 2) = 85.3 % lie inside. For 0.68 the
# ellipse holds 39 %, for 0.99 it holds 96.4 %.
# Who is hurt: whoever draws a tracker's uncertainty, or sets a gate by eye, with these ellipses: of what lies outside an
# ellipse "for 95 %" two thirds should be inside.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet filterpy==2.0.0 numpy==2.4.6 scipy==1.17.1 matplotlib==3.11.1
"$folder/env/bin/python" - <<'PYTHON'
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from filterpy.stats import plot_covariance

for asked, seen in ((0.68, 0.39), (0.95, 0.8535), (0.99, 0.964)):
    plt.figure()
    plot_covariance(np.zeros(2), np.eye(2), interval=asked)
    (ellipse,) = plt.gca().patches
    scale = ellipse.width / 2  # of a round cloud with σ = 1
    inside = 1 - np.exp(-(scale**2) / 2)
    right = np.sqrt(-2 * np.log(1 - asked))
    print(f"asked {asked:.0%}: scale {scale:.3f}, holds {inside:.1%}; right would be {right:.3f}")
    assert abs(inside - seen) < 0.002, "this has changed"
    plt.close()
PYTHON
