#!/bin/sh
# pyais 3.3.1: the rate of turn of a ship comes in degrees a minute, but a turn that is too fast for the message, and
# a rate that is not available, come in the same field as 127 and -128.
#
# Expected: rates of turn in one unit, and None, NaN or another type where there is none. In the message 708 degrees a
# minute is the fastest rate; the codes 127 and -127 mean "faster than 5 degrees in 30 s, no turn indicator", -128
# means "not available".
# Seen: 300 comes back as 300, 708 as 709 (the message's own steps), 720 as 127, "not available" as -128. All of them
# take part in arithmetic.
# Who is hurt: whoever filters a ship's heading with these rates: the fastest turns look slower than a turn of 300,
# and a ship without a sensor seems to turn to port by 128 degrees a minute.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet pyais==3.3.1
"$folder/env/bin/python" - <<'PYTHON'
from pyais import decode, encode_dict


def there_and_back(turn):
    report = {"type": 1, "mmsi": 211000000, "turn": turn}
    return decode(*encode_dict(report, radio_channel="B", talker_id="AI")).turn


for sent, seen in ((10, 10), (300, 300), (708, 709), (720, 127), (-720, -127), (-128, -128)):
    turn = there_and_back(sent)
    print(f"sent {sent}, read {float(turn)}; half of it: {turn / 2}")
    assert abs(turn - seen) < 0.5, "this has changed"
assert there_and_back(720) < there_and_back(300), "this has changed"
PYTHON
