#!/bin/sh
# nptdms 1.13.0: a channel that was written in two segments, each with its own start time, is read as one even series
# that begins at the start of the last segment.
#
# Expected: the ten samples stand at 12:00:00.0 to 12:00:00.4 and at 12:01:00.0 to 12:01:00.4, with a pause of 59.6 s
# between them; or the reader says that it cannot tell.
# Seen: time_track() gives 12:01:00.0 to 12:01:00.9 in steps of 0.1 s. In the file a property that is written again
# replaces the first one, so the first five samples come 60 s late, the last five 0.5 s late, and the pause is gone.
# Who is hurt: whoever fuses such a channel with another sensor, or takes the step dt of a filter from time_track():
# nothing in the series shows that the recording was interrupted.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet nptdms==1.13.0 numpy==2.4.6
cd "$folder"
"$folder/env/bin/python" - <<'PYTHON'
import numpy as np
from nptdms import ChannelObject, TdmsFile, TdmsWriter

start = np.datetime64("2026-03-01T12:00:00", "ms")
minute, tenth = np.timedelta64(60, "s"), np.timedelta64(100, "ms")
with TdmsWriter("log.tdms") as file:
    for k in (0, 1):
        clock = {"wf_start_time": start + k * minute, "wf_increment": 0.1, "wf_start_offset": 0.0}
        file.write_segment([ChannelObject("logger", "height", np.arange(5.0) + 100 * k, properties=clock)])
channel = TdmsFile.read("log.tdms")["logger"]["height"]
seen = channel.time_track(absolute_time=True, accuracy="ms")
right = np.concatenate([start + np.arange(5) * tenth, start + minute + np.arange(5) * tenth])
late = (seen - right) / np.timedelta64(1, "s")
print("seconds late:", late, "steps:", np.unique(np.diff(seen)))
assert np.allclose(late, [60] * 5 + [-0.5 + 1] * 5), "this has changed"
assert (np.diff(seen) == tenth).all() and channel[:][5] == 100, "this has changed"
PYTHON
