#!/bin/sh
# obspy 1.5.1: Stream.merge() moves the second piece of a recording by up to half a sample, without a word.
#
# Expected: a piece that begins between two samples of the first keeps its times, or merge() refuses or interpolates.
# Seen: at 10 Hz a piece that begins at 1.049 s is put at 1.0 s with its values as they are, 49 ms early.
# Who is hurt: whoever measures speed or timing across a restart of the logger: at 100 m/s the positions are 4.9 m
# off, all in one direction, in a series that is perfectly even.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet obspy==1.5.1 numpy==2.4.6 scipy==1.17.1
"$folder/env/bin/python" - <<'PYTHON'
import numpy as np
from obspy import Stream, Trace, UTCDateTime

ZERO = UTCDateTime("2026-03-01T12:00:00")


def piece(start, count):
    """A signal that says the time at which it was measured, in seconds, at 10 Hz."""
    trace = Trace(start + 0.1 * np.arange(count))
    trace.stats.starttime, trace.stats.delta = ZERO + start, 0.1
    return trace


(merged,) = Stream([piece(0.0, 5), piece(1.049, 3)]).merge()
times = merged.times() + (merged.stats.starttime - ZERO)
early = (merged.data - times)[-3:]
print("stands at", times[-3:], "was measured at", merged.data[-3:])
assert np.allclose(early, 0.049, atol=1e-6), "this has changed"
PYTHON
