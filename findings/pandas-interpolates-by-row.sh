#!/bin/sh
# pandas 3.1.1: resample("1s").interpolate() puts uneven readings on an even grid by counting rows, not by the clock.
#
# Expected: a straight line z(t) = t, read at 0, 0.9, 2.1, 2.9, 4.2, 10.0 and 11.1 s, stays the line: 1 at 1 s, 2 at 2
# s.
# Seen: 1.3 at 1 s, 1.7 at 2 s, 3.333 at 3 s, at most 0.45 off. Stamps and grid are joined into one list, and values
# are interpolated by their position in it. interpolate("time") is exact.
# Who is hurt: whoever makes the even steps that a filter with one F asks for: errors of half a step times the speed,
# which change with the pattern of the stamps.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet pandas==3.1.1 numpy==2.4.6
"$folder/env/bin/python" - <<'PYTHON'
import numpy as np
import pandas as pd

t = np.array([0, 0.9, 2.1, 2.9, 4.2, 10.0, 11.1])
line = pd.Series(t, index=pd.Timestamp("2026-03-01 12:00") + pd.to_timedelta(t, unit="s"))
by_row = line.resample("1s").interpolate().to_numpy()
by_time = line.resample("1s").interpolate("time").to_numpy()
right = np.arange(len(by_row), dtype=float)
print("by row ", by_row.round(3)[:7], f"largest error {np.abs(by_row - right).max():.2f}")
print("by time", by_time.round(3)[:7], f"largest error {np.abs(by_time - right).max():.2f}")
assert np.allclose(by_row[:4], [0, 1.3, 1.7, 3.333], atol=1e-3), "this has changed"
assert np.allclose(by_time, right), "this has changed"
PYTHON
