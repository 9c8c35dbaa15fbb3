#!/bin/sh
# python-can 4.6.1: frames that are logged as .asc, or as .blf with a clock that counts since boot, come back with a
# clock that begins at 0.
#
# Expected: what is written with the stamps 10.00, 10.01 and 12.50 s is read with these stamps, as it is from .csv,
# .log, .trc and .db.
# Seen: .asc comes back as 0.00, 0.01, 2.50, whatever the clock was. .blf does so with a clock since boot, and keeps
# seconds since 1970.
# Who is hurt: whoever logs two buses, or a bus and another sensor, by one clock: after reading, each log begins at 0,
# and the two are out of step by the difference of their first frames.
#
# Exit status 0: as described. Anything else: it has changed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet python-can==4.6.1
cd "$folder"
"$folder/env/bin/python" - <<'PYTHON'
import can


def there_and_back(stamps, kind):
    with can.Logger(f"log.{kind}") as log:
        for t in stamps:
            log(can.Message(timestamp=t, arbitration_id=0x123, data=[1, 2], is_extended_id=False))
    with can.LogReader(f"log.{kind}") as log:
        return [message.timestamp for message in log]


def near(first, second):
    return all(abs(a - b) < 2e-3 for a, b in zip(first, second, strict=True))


boot, since_1970 = [10.0, 10.01, 12.5], [1772366400.1, 1772366400.11, 1772366402.6]
for kind, keeps_boot, keeps_1970 in (("asc", 0, 0), ("blf", 0, 1), ("csv", 1, 1), ("log", 1, 1), ("trc", 1, 1)):
    for stamps, keeps in ((boot, keeps_boot), (since_1970, keeps_1970)):
        read = there_and_back(stamps, kind)
        print(f"{kind}: {stamps[0]:.2f} comes back as {read[0]:.2f}")
        right = stamps if keeps else [t - stamps[0] for t in stamps]
        assert near(read, right), "this has changed"
PYTHON
