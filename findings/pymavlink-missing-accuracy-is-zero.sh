#!/bin/sh
# pymavlink 2.4.50: a GPS message of an older autopilot (MAVLink 1), read with the dialect of MAVLink 2, says that its
# accuracy is 0 mm.
#
# Expected: fields that were not sent are None, or carry a code for "unknown", as cog and epv do (65535).
# Seen: h_acc and v_acc, which exist in MAVLink 2 only, are 0, beside a valid fix (fix_type 3). Nothing in the message
# tells a zero that was sent from a field that was not.
# Who is hurt: whoever makes R from h_acc: sigma is 0, so the filter takes each position for exact, or stops because R
# is singular. eph = 120 beside it is no accuracy either: it is the dilution of precision times 100.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet pymavlink==2.4.50
"$folder/env/bin/python" - <<'PYTHON'
import io

from pymavlink.dialects.v10 import ardupilotmega as first
from pymavlink.dialects.v20 import ardupilotmega as second

autopilot = first.MAVLink(io.BytesIO(), srcSystem=1)
unknown = 65535
message = autopilot.gps_raw_int_encode(60_000_000, 3, 480_000_000, 110_000_000, 545_000, 120, unknown, 500, unknown, 9)
(seen,) = second.MAVLink(io.BytesIO()).parse_buffer(message.pack(autopilot))
print(f"fix {seen.fix_type}, latitude {seen.lat / 1e7}, eph {seen.eph}, epv {seen.epv}, h_acc {seen.h_acc} mm")
assert seen.fix_type == 3 and seen.lat == 480_000_000 and seen.epv == seen.cog == unknown, "this has changed"
assert seen.h_acc == seen.v_acc == 0, "this has changed"
PYTHON
