"""The options of `recordings.read`, each checked before the file is opened."""

from dataclasses import dataclass, fields
from numbers import Real

from .faults import RecordingError, listed, short

EQUAL = ("refuse", "keep", "merge", "first")


@dataclass(frozen=True)
class Options:
    """What the caller has said about a file; `recordings.read` explains each."""

    time: object = None
    columns: object = None
    time_unit: object = None
    time_format: object = None
    dayfirst: object = None
    zone: object = None
    where: object = None
    pivot: object = None
    missing: object = ()
    equal: object = "refuse"
    sort: object = False
    wraps: object = None
    header: object = None
    separator: object = None
    decimal: object = None
    thousands: object = None
    checksum: object = True

    def __post_init__(self):
        for option, right, wanted in (
            ("time_format", _text, "a text such as '%d.%m.%Y %H:%M'"),
            ("dayfirst", _truth, "True or False"),
            ("zone", _text, "the name of a time zone such as 'Europe/Berlin'"),
            ("where", _choice, "a dict such as {'id': 7}: the column, and what stands in it in the rows to read"),
            ("pivot", _pair, "two names: the column of the sensors' names, the column of their readings"),
            ("missing", _marks, "a list of marks, [-999], or a dict of such lists, {'speed': [102.3]}"),
            ("equal", EQUAL.__contains__, "one of 'refuse', 'keep', 'merge', 'first'"),
            ("sort", _truth, "True or False"),
            ("wraps", _positive, "where the counter begins again, such as 2**32"),
            ("header", _line, "the number of the line with the names of the columns, or False if there is none"),
            ("separator", _mark, "one sign, such as ';' or ' '"),
            ("decimal", (".", ",").__contains__, "'.' or ','"),
            ("thousands", _mark, "one sign, such as ','"),
            ("checksum", _truth, "True or False"),
        ):
            value = getattr(self, option)
            if value is not _default(option) and not _safely(right, value):
                raise RecordingError((None, f"{option} must be {wanted}, got {short(value)}"))

    @classmethod
    def of(cls, settings) -> "Options":
        """From keywords; an unknown one is named."""
        known = [field.name for field in fields(cls)]
        for name in settings:
            if name not in known:
                raise RecordingError((None, f"there is no option {short(name)}; the options are {', '.join(known)}"))
        return cls(**settings)

    def marks_of(self, name) -> list:
        """What stands for "no reading" in a column."""
        if isinstance(self.missing, dict):
            return _list(self.missing.get(name, ()))
        return _list(self.missing)

    @property
    def clocks(self) -> list:
        """The columns of the time stamps: none, one, or date and clock."""
        return [] if self.time is None else list(self.time) if isinstance(self.time, (list, tuple)) else [self.time]


def _default(option):
    return Options.__dataclass_fields__[option].default


def _safely(right, value):
    try:
        return bool(right(value))
    except (TypeError, ValueError, OverflowError):
        return False


def _text(value):
    return isinstance(value, str) and value != ""


def _truth(value):
    return isinstance(value, bool)


def _mark(value):
    return isinstance(value, str) and len(value) == 1


def _positive(value):
    return isinstance(value, Real) and not isinstance(value, bool) and 0 < value < 1e300


def _line(value):
    return value is False or (isinstance(value, int) and not isinstance(value, bool) and value > 0)


def _choice(value):
    return isinstance(value, dict) and value and all(isinstance(name, str) for name in value)


def _pair(value):
    return isinstance(value, (list, tuple)) and len(value) == 2 and all(isinstance(name, str) for name in value)


def _marks(value):
    lists = [_list(each) for each in (value.values() if isinstance(value, dict) else [value])]
    return all(isinstance(mark, (str, Real)) for each in lists for mark in each)


def _list(value):
    return list(value) if isinstance(value, (list, tuple, set, frozenset)) else [value]


__all__ = ["Options", "listed"]
