"""A line of the table that `make check-hard` prints."""

from typing import NamedTuple


class Line(NamedTuple):
    what: str  # was tried, in at most 58 letters
    measured: str  # the figure, with its unit
    bound: str  # that it must keep
    ok: bool  # whether it does
