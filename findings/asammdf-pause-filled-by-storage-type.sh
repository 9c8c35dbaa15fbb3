#!/bin/sh
# asammdf 8.8.28: on an even raster a pause of a recording is filled without a mark, and with other values for floats,
# for whole numbers, and for whole numbers with a scale.
#
# Expected: one height, recorded three times (metres as floats, centimetres as whole numbers, whole numbers that are
# scaled to decimetres), gives the same numbers, and no reading or a mark between 0.3 s and 2.0 s, where nothing was
# measured.
# Seen: in metres, at 0.5, 1.0 and 1.5 s: floats are joined by a straight line (5, 10, 15), whole numbers are held (3,
# 3, 3), and the scaled ones are joined in to_dataframe(raster=0.5) and held in resample(0.5).
# Who is hurt: whoever gives the raster to a filter: invented readings with no noise between them, and for a signal of
# 10 m/s an error of up to 12 m on this raster, which depends on how the logger stored the number.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet asammdf==8.8.28 numpy==2.4.6
cd "$folder"
"$folder/env/bin/python" - <<'PYTHON'
import numpy as np
from asammdf import MDF, Signal

t = np.array([0, 0.1, 0.2, 0.3, 2.0, 2.1])
height = 10 * t
log = MDF(version="4.10")
log.append([Signal(height, t, name="metres")])
log.append([Signal(np.rint(100 * height).astype(int), t, name="centimetres")])
log.append([Signal(np.rint(100 * height).astype(int), t, name="decimetres", conversion={"a": 0.1, "b": 0.0})])
frame, raster = log.to_dataframe(raster=0.5), log.resample(0.5)
line, held = [5, 10, 15], [3, 3, 3]
expected = {"metres": (1, line, line), "centimetres": (100, held, held), "decimetres": (10, line, held)}
for name, (unit, in_frame, in_raster) in expected.items():
    first = frame[name].to_numpy(float)[1:4] / unit
    second = raster.get(name).samples.astype(float)[1:4] / unit
    print(f"{name}: to_dataframe {first} m, resample {second} m")
    assert np.allclose(first, in_frame) and np.allclose(second, in_raster), "this has changed"
PYTHON
