"""Numbers that loggers write for "not available", found where they stand far from all other readings of a column."""

import numpy as np

LARGEST, SMALLEST = "the type's largest", "the type's smallest"
KNOWN = {102.3: "AIS", 1023: "AIS", 511: "AIS", 360: "AIS", 91: "AIS", 181: "AIS", 4095: "AIS", 127: "FIT", 255: "FIT"}
KNOWN |= {65534: "FIT", 65535: "FIT, MAVLink", 655.35: "MAVLink", 6553.5: "FIT", 4294967295: "UBX, FIT", 99.99: "NMEA"}
KNOWN |= {-200: "gas analysers", -999.25: "well logs", 1e20: "netCDF", -1e20: "netCDF", 9.969209968386869e36: "netCDF"}
KNOWN |= dict.fromkeys((999, 999.9, 9999, 9999.9, 99999), "weather") | dict.fromkeys((7999, -7999, -6999), "Campbell")
KNOWN |= dict.fromkeys((-99, -99.9, -999, -999.9, -999.99, -9999, -9999.9, -99999), "")
KNOWN |= {2.0**n - 1: LARGEST for n in (15, 24, 31, 63, 64)} | {-(2.0**n): SMALLEST for n in (15, 31, 63)}
KNOWN |= {214.7483647: LARGEST, 3.4028234663852886e38: LARGEST, 1.7976931348623157e308: LARGEST}
APART = 0.2  # how far from the next reading, as a share of the range of the others


def suspects(values) -> list:
    """(column, code, how often, who writes it) for each suspected code of a table (T, m).

    >>> suspects(np.array([[2.6], [-200], [2.0]]))
    [(0, -200.0, 1, 'gas analysers')]
    """
    found = []
    for j, column in enumerate(values.T):
        there = column[~np.isnan(column)]
        codes, fresh = [], True
        while fresh and there.size:
            fresh = False
            for code in (there.min(), there.max()):
                others = there[there != code]
                near = float(f"{code:.9g}")
                who = next((w for k, w in KNOWN.items() if near in (k, float(f"{k:.9g}"))), None)
                if who is not None and others.size and _apart(code, others):
                    codes.append((j, float(code), int((there == code).sum()), who))
                    there, fresh = others, True
        found += codes
    return found


def _apart(code, others):
    span = others.max() - others.min()
    return min(abs(code - others.min()), abs(code - others.max())) > APART * span


def sentence(name, code, count, who) -> str:
    """The line of a printed recording."""
    source = f" ({who})" if who else ""
    times = "once" if count == 1 else f"{count} times"
    return f"{name}: {code:.12g} {times}, far from the rest: not available{source}? missing={{{name!r}: [{code:.12g}]}}"
