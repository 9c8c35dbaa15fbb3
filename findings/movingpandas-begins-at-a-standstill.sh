#!/bin/sh
# movingpandas 0.23.0 with stonesoup 1.9.1: KalmanSmootherCV begins every track with the velocity 0, and takes this
# for certain.
#
# Expected: a smoother for constant velocity gives back a straight line that is driven at constant speed and measured
# without noise.
# Seen: at 15 m/s, a position each second, process_noise_std=0.1 and measurement_noise_std=1, the first smoothed
# position is 29.9 m ahead of the vehicle, and seven seconds later it is 7.8 m behind. The first state has the
# variance of the readings for the position, and 0 for the velocity.
# Who is hurt: whoever smooths tracks of things that move when the recording begins: the first ten seconds or more are
# wrong, by many times the noise that was told, in a line that looks smooth.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet movingpandas==0.23.0 stonesoup==1.9.1 geopandas==1.2.0 numpy==2.4.6
"$folder/env/bin/python" - <<'PYTHON'
import geopandas as gpd
import movingpandas as mpd
import numpy as np
import pandas as pd
from shapely.geometry import Point

seconds = np.arange(21)
times = pd.Timestamp("2026-03-01 12:00") + pd.to_timedelta(seconds, unit="s")
line = [Point(15 * k, 0) for k in seconds]
drive = gpd.GeoDataFrame({"t": times}, geometry=line, crs=31256).set_index("t")
smooth = mpd.KalmanSmootherCV(mpd.Trajectory(drive, 1)).smooth(process_noise_std=0.1, measurement_noise_std=1)
error = np.array([point.x for point in smooth.df.geometry]) - 15 * seconds
print("metres ahead of the vehicle:", error.round(1))
assert abs(error[0] - 29.9) < 0.1 and abs(np.abs(error[5:11]).max() - 7.8) < 0.1, "this has changed"
PYTHON
