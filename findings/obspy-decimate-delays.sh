#!/bin/sh
# obspy 1.5.1: Trace.decimate(4) delivers a signal that is ten samples late, under the old start time.
#
# Expected: a ramp stays the ramp it was, because the low-pass filter before the thinning has no delay, or the start
# time is moved by its delay. tr.data[::4] has the right values here.
# Seen: after the first transient every value is 10.6 samples of the ramp too small. At 10 Hz it is the value of 1.06
# s earlier. The filter runs once, forwards, and starttime stays.
# Who is hurt: whoever thins one channel and fuses it with another: the two are out of step by a second, which a
# filter takes for a bias that grows with speed.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet obspy==1.5.1 numpy==2.4.6 scipy==1.17.1
"$folder/env/bin/python" - <<'PYTHON'
import numpy as np
from obspy import Trace, UTCDateTime

ramp = Trace(np.arange(400.0))
ramp.stats.starttime, ramp.stats.delta = UTCDateTime("2026-03-01T12:00:00"), 0.1
thin = ramp.copy().decimate(4)
right = ramp.data[::4]
late = (right - thin.data)[-20:]
print(f"start {thin.stats.starttime}, late by {late.min():.2f} to {late.max():.2f} samples of {ramp.stats.delta} s")
assert thin.stats.starttime == ramp.stats.starttime and len(thin.data) == len(right), "this has changed"
assert np.allclose(late, 10.6, atol=0.1), "this has changed"
PYTHON
