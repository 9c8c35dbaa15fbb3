#!/bin/sh
# pynmea2 1.19.0: a receiver that has no fix leaves its position empty; pynmea2 reads it as 0.0 degrees north and
# 0.0 degrees east.
#
# Expected: None, as altitude is in the same sentence, and as the empty fields lat and lon say.
# Seen: latitude and longitude are 0.0, in GGA, RMC and GLL alike: numbers like any other, in the sea south of Ghana.
# Who is hurt: whoever makes a track of latitude and longitude. A receiver that starts, or drives through a tunnel,
# jumps by thousands of kilometres; a filter without a gate is dragged along by each such reading, and one that tests
# its readings for None or NaN finds nothing to leave out.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet pynmea2==1.19.0
"$folder/env/bin/python" - <<'PYTHON'
from functools import reduce

import pynmea2


def sentence(body):
    """A whole sentence, with its checksum."""
    return f"${body}*{reduce(lambda one, other: one ^ other, body.encode()):02X}"


fix = pynmea2.parse(sentence("GPGGA,120000.00,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,"))
print(f"with a fix: {fix.latitude:.4f} {fix.longitude:.4f}, altitude {fix.altitude}")
for body in (
    "GPGGA,120001.00,,,,,0,00,99.99,,,,,,",
    "GPRMC,120001.00,V,,,,,,,010126,,,N",
    "GPGLL,,,,,120001.00,V,N",
):
    lost = pynmea2.parse(sentence(body))
    print(f"{body[2:5]} without: fields {lost.lat!r} {lost.lon!r}, latitude {lost.latitude}, longitude {lost.longitude}")
    assert lost.lat == lost.lon == "", "this has changed"
    assert lost.latitude == lost.longitude == 0.0, "this has changed"
    if body[2:5] == "GGA":
        assert lost.altitude is None, "this has changed"
print("right: no position, so that the reading can be left out")
PYTHON
