#!/bin/sh
# xarray 2025.6.1 and netCDF4 1.7.2: one file, and a depth of 99.99 m that one of the two calls missing.
#
# The convention for NetCDF says that values outside `valid_range` count as missing. It is written in the packed
# whole numbers of the file: here 0 to 2000, which is 0 to 20 m.
# Expected: NaN, as for the fill value, which open_dataset masks, and as netCDF4 does with the same file.
# Seen: open_dataset scales the values outside the range like all others: -0.01 m and 99.99 m are readings. And it
# leaves valid_range as it was, beside depths in metres: who compares the two finds 99.99 between 0 and 2000.
# Who is hurt: whoever filters an echo sounder or a gauge from such a file. The sounder's "lost the ground" is a
# reading of 99.99 m, and a filter without a gate follows it.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet xarray==2025.6.1 netCDF4==1.7.2 numpy==2.2.6 pandas==2.3.3
cd "$folder"
"$folder/env/bin/python" - <<'PYTHON'
import netCDF4
import numpy as np
import xarray

packed = np.array([512, 513, 9999, -1, 515, -32768], "i2")  # hundredths of a metre; the last is the fill value
with netCDF4.Dataset("sounder.nc", "w") as file:
    file.createDimension("time", len(packed))
    depth = file.createVariable("depth", "i2", ("time",), fill_value=-32768)
    depth.units, depth.scale_factor, depth.valid_range = "m", 0.01, np.array([0, 2000], "i2")
    depth.set_auto_maskandscale(False)
    depth[:] = packed

with netCDF4.Dataset("sounder.nc") as file:
    masked = file["depth"][:]
opened = xarray.open_dataset("sounder.nc").depth
print("netCDF4", masked)
print("xarray ", opened.values, "valid_range", opened.attrs["valid_range"])
assert masked.mask.tolist() == [False, False, True, True, False, True], "this has changed"
assert np.isnan(opened.values).tolist() == [False] * 5 + [True], "this has changed"
low, high = opened.attrs["valid_range"]
assert round(float(opened[2]), 6) == 99.99 and low <= opened[2] <= high, "this has changed"
low, high = np.array([low, high]) * opened.encoding["scale_factor"]
print("right  ", opened.where((opened >= low) & (opened <= high)).values, "with the range in metres too:", low, high)
PYTHON
