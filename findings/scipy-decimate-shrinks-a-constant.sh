#!/bin/sh
# scipy 1.17.1: signal.decimate(x, 4) makes every reading 1.1 % too small; order 7 in place of 8 does not.
#
# Expected: a height of 500 m, thinned out, stays 500 m.
# Seen: 494.28 m throughout. A Chebyshev filter of even order passes a constant at the bottom of its ripple of 0.05
# dB, and it runs twice, forwards and backwards: 10^(-0.1 / 20) = 0.98855. With n=7, with ftype="fir" and with
# resample_poly it is 500.00.
# Who is hurt: whoever thins out a log before filtering it: a bias proportional to the reading, 5.7 m for a noise of
# perhaps 1 m, which no innovation test sees, because all readings have it.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet scipy==1.17.1 numpy==2.4.6
"$folder/env/bin/python" - <<'PYTHON'
import numpy as np
from scipy.signal import decimate, resample_poly

height = np.full(4000, 500.0)
factor = 10 ** (-0.1 / 20)
ways = {
    "order 8": (decimate(height, 4, n=8), 500 * factor),
    "order 7": (decimate(height, 4, n=7), 500),
    "fir": (decimate(height, 4, ftype="fir"), 500),
    "resample_poly": (resample_poly(height, 1, 4), 500),
}
for name, (thin, seen) in ways.items():
    print(f"{name}: {thin[500]:.2f} m")
    assert abs(thin[500] - seen) < 0.1, "this has changed"
PYTHON
