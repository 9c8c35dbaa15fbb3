#!/bin/sh
# asammdf 8.8.28: cut(start, stop) adds a reading at each end of the interval that nobody measured.
#
# Expected: the readings between 0.25 s and 2.05 s: those of 0.3 s and 2.0 s.
# Seen: four. One is added at 0.25 s and one at 2.05 s; for a channel of floats they lie on a straight line between
# their neighbours (2.5 and 20.5), for a channel of whole numbers they repeat the reading before (20 and 200).
# include_ends=False leaves the two real ones.
# Who is hurt: whoever cuts a log into pieces for a filter: each piece begins and ends with a reading made of its
# neighbours, so the filter counts their errors twice and claims too much.
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

t = np.array([0, 0.1, 0.2, 0.3, 2.0, 2.1, 2.2])
log = MDF(version="4.10")
log.append([Signal(10 * t, t, name="floats")])
log.append([Signal(np.rint(100 * t).astype(int), t, name="whole")])
for name, seen in (("floats", [2.5, 3, 20, 20.5]), ("whole", [20, 30, 200, 200])):
    piece = log.cut(start=0.25, stop=2.05).get(name)
    real = log.cut(start=0.25, stop=2.05, include_ends=False).get(name)
    print(f"{name}: {piece.samples} at {piece.timestamps}; without the ends {real.samples} at {real.timestamps}")
    assert np.allclose(piece.timestamps, [0.25, 0.3, 2.0, 2.05]) and np.allclose(piece.samples, seen), "this has changed"
    assert np.allclose(real.timestamps, [0.3, 2.0]), "this has changed"
PYTHON
