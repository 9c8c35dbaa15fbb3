"""Input that nobody meant to give: the exercises' check, recordings and the filters' arguments meet junk.

An input is one call. It may end with a result, or with the documented exception and its sentence: nothing else. What
the caller handed in is the same afterwards, byte for byte. All of it follows from seeds.
"""

import warnings

import numpy as np

from dev.hard.line import Line
from dev.hard.wrong_answers import check_exercises
from dev.hard.wrong_calls import check_filters
from dev.hard.wrong_tables import check_recordings

EXERCISES, TABLES, CALLS = 25_000, 45_000, 32_000  # inputs of the full run


def lines(quick):
    """The lines of the table."""
    share = 40 if quick else 1
    checks = [
        ("exercises", check_exercises, EXERCISES, "an outcome"),
        ("recordings", check_recordings, TABLES, "RecordingError"),
        ("filters", check_filters, CALLS, "ValueError, TypeError"),
    ]
    total = 0
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        for area, check, inputs, documented in checks:
            tally = check(inputs // share)
            total += tally.tried
            yield from tally.lines(area, documented)
    yield Line("inputs in all", f"{total:,}", f">= {100_000 // share:,}", total >= 100_000 // share)
