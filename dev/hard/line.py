"""A line of the table that `make check-hard` prints."""

from collections import Counter
from typing import NamedTuple


class Line(NamedTuple):
    what: str  # was tried, in at most 58 letters
    measured: str  # the figure, with its unit
    bound: str  # that it must keep
    ok: bool  # whether it does


def none(what, found, tried, bound="0"):
    """A line about things of which there must be none; the first one is named."""
    first = f": {found[0]}" if found else ""
    return Line(what, f"{len(found)} of {tried}{first}", bound, not found)


class Tally:
    """What was tried: how often, how it ended, and what was wrong with it."""

    def __init__(self):
        self.tried, self.ends, self.faults = 0, Counter(), []

    def others(self):
        """The faults as the end of a sentence."""
        return f"{len(self.faults)} others: {self.faults[0]}" if self.faults else "no others"
