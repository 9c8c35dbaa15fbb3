#!/bin/sh
# gps-time 3.0.0: to_datetime() of a GPS time is labelled +00:00 and is 18 s ahead of UTC; from_datetime() of a UTC
# time is 18 s behind.
#
# Expected: GPS time has no leap seconds and has been 18 s ahead of UTC since 2017. Week 2408, second 43218 is
# 2026-03-01 12:00:00 UTC, and noon UTC is second 43218.
# Seen: to_datetime() gives 12:00:18+00:00, and from_datetime() of noon, with the time zone UTC, gives second 43200.
# Who is hurt: whoever joins a receiver's log (GPS week and second) with a log in UTC: at 30 m/s the positions are 540
# m away from where the other sensors say the vehicle was.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet gps-time==3.0.0 numpy==2.4.6
"$folder/env/bin/python" - <<'PYTHON'
from datetime import datetime, timedelta, timezone

from gps_time import GPSTime

noon = datetime(2026, 3, 1, 12, tzinfo=timezone.utc)
epoch = datetime(1980, 1, 6, tzinfo=timezone.utc)
right = (noon - epoch + timedelta(seconds=18)).total_seconds() - 2408 * 7 * 86400  # 18 leap seconds from 1980 to 2017
told = GPSTime(2408, right).to_datetime()
asked = GPSTime.from_datetime(noon)
print(f"second {right:.0f} of week 2408 is noon UTC; told {told}; noon UTC is said to be second {asked.time_of_week}")
assert right == 43218 and told - noon == timedelta(seconds=18) and told.utcoffset() == timedelta(0), "this has changed"
assert (asked.week_number, asked.time_of_week) == (2408, 43200), "this has changed"
PYTHON
