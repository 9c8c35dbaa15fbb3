"""From texts to time stamps: ISO 8601 in its forms, and other ways of writing where only one of them fits."""

import re
import warnings
from datetime import datetime

import numpy as np

from .faults import RecordingError, short

MONTH, YEAR = 2_629_746, 31_556_952  # seconds: a twelfth of a year, and a year of the calendar, 365.2425 days
PERIOD = re.compile(r"(\d{4})(?:-(\d\d)|-?[Qq]([1-4]))?", re.ASCII)
CLOCK = re.compile(r"(\d{1,3}):([0-5]\d):([0-5]\d(?:[.,]\d+)?)", re.ASCII)
ORDINAL = re.compile(r"\d{4}-?\d{3}", re.ASCII)
SHAPE = re.compile(
    r"(?:[A-Za-z]{3,9},? +)?(\d{1,4}|[A-Za-z]{3,9})([-/. ] ?)(\d{1,2}|[A-Za-z]{3,9}),?([-/. ] ?)(\d{2,4})"
    r"(?:([ T,]+)(\d{1,2}):(\d\d)(?::(\d\d))?([.,]\d+)?( ?[AaPp]\.?[Mm]\.?)?)?",
    re.ASCII,
)
NO_DATE = "is no date as in ISO 8601, like 2026-05-31 14:05:09"


def iso(texts):
    """Time stamps (pandas Series) of texts as in ISO 8601, and {index: what is wrong with it}."""
    import pandas as pd

    series = pd.Series(texts, dtype=str)
    if series.str[:1].str.isdigit().all():  # pandas takes "now" for a date
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                return pd.to_datetime(series, format="ISO8601"), {}
        except (ValueError, OverflowError, UserWarning):
            pass
    stamps, faults = [_one(text) for text in series], {}
    first = next((s for s in stamps if s is not None), None)
    for k, stamp in enumerate(stamps):
        if stamp is None:
            faults[k] = _wrong(series[k])
        elif (stamp.tzinfo is None) != (first.tzinfo is None):
            faults[k] = "has a time zone where the first has none, or the other way round"
            stamps[k] = None
    try:
        return pd.to_datetime(
            pd.Series(stamps, dtype=object), utc=first is not None and first.tzinfo is not None
        ), faults
    except (ValueError, OverflowError):
        return pd.Series(np.full(len(series), "NaT", "datetime64[us]")), {0: "is too far from the first"} | faults


def _one(text):
    """A pandas Timestamp, or None."""
    import pandas as pd

    try:
        if ORDINAL.fullmatch(text):
            return pd.Timestamp(datetime.strptime(text.replace("-", ""), "%Y%j"))
        if re.match(r"\d", text) and re.search(r"[.,]\d{7,9}", text):
            return pd.Timestamp(text.replace(",", "."))
        return pd.Timestamp(datetime.fromisoformat(text))
    except (ValueError, OverflowError):
        return None


def _wrong(text):
    if re.search(r":60(\D|$)", text):
        return "is a leap second, which computers do not count: give it the stamp between its neighbours"
    return NO_DATE


def zoned_first(text, stamp):
    """The first stamp with the zone in which it was written."""
    own = _one(text) if stamp is not None and stamp.tzinfo is not None else None
    return stamp if own is None or own.tzinfo is None else own


def periods(texts):
    """Whole months, quarters or years, ["1901-01", …]: seconds from the first, stamps, a note; None for others."""
    import pandas as pd

    found = [PERIOD.fullmatch(text) for text in texts] if PERIOD.fullmatch(texts[0]) else [None]
    if not all(found) or len({(f[2] is None, f[3] is None) for f in found}) > 1:
        return None
    if any((f[2] and not 1 <= int(f[2]) <= 12) or int(f[1]) == 0 for f in found):
        return None
    months = np.array([12 * int(f[1]) + int(f[2] or 3 * int(f[3] or 1) - 2) - 1 for f in found])
    stamps = pd.Series((months - 12 * 1970).astype("datetime64[M]").astype("datetime64[s]"))
    word, days = ("month", 30.436875) if found[0][2] else ("quarter", 91.310625) if found[0][3] else ("year", 365.2425)
    note = f"each {word} counted as {days} days, so that the steps are regular"
    return (months - months[0]) * float(MONTH), stamps, note


def clocks(texts):
    """Seconds of hours, minutes and seconds, "14:05:09.5", since midnight; None where one is no clock."""
    found = [CLOCK.fullmatch(text) for text in texts] if CLOCK.fullmatch(texts[0]) else [None]
    if not all(found):
        return None
    return np.array([3600 * int(f[1]) + 60 * int(f[2]) + float(f[3].replace(",", ".")) for f in found])


def other_formats(text, dayfirst=None) -> list[str]:
    """The formats that a date like 31.05.2026 14:05 may have, by its first example."""
    found = SHAPE.fullmatch(text)
    if not found:
        return []
    one, mark, two, mark_2, three, space, hour, _, second, fraction, half = found.groups()
    day_month = "%b" if two.isalpha() and len(two) == 3 else "%B" if two.isalpha() else "%m"
    year = "%Y" if len(three) == 4 else "%y"
    if len(one) == 4 and one.isdigit():
        dates = [f"%Y{mark}{day_month}{mark_2}%d"]
    elif one.isalpha():
        dates = [f"{'%b' if len(one) == 3 else '%B'}{mark}%d{', ' if ',' in text else mark_2}{year}"]
    elif two.isalpha():
        dates = [f"%d{mark}{day_month}{mark_2}{year}"]
    else:
        dates = [f"%d{mark}%m{mark_2}{year}", f"%m{mark}%d{mark_2}{year}"]
        dates = dates[:1] if dayfirst is True else dates[1:] if dayfirst is False else dates
    clock = "" if hour is None else f"{space}{'%I' if half else '%H'}:%M" + (":%S" if second else "")
    clock += (f"{fraction[0]}%f" if fraction else "") + (" %p" if half and half[0] == " " else "%p" if half else "")
    return [date + clock for date in dates]


def by_format(texts, form):
    """Time stamps by a format of strptime, NaT where a text has another form."""
    import pandas as pd

    series = pd.Series(texts, dtype=str)
    if "%f" in form:  # where the fraction is zero some loggers leave it out
        mark = form[form.index("%f") - 1]
        series = series.where(
            series.str.contains(mark + r"\d+(?: ?[AaPp][Mm])?$" if mark != "." else r"\.\d+(?: ?[AaPp][Mm])?$"),
            series.str.replace(r"(:\d\d)( ?[AaPp][Mm])?$", rf"\1{mark}0\2", regex=True),
        )
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            return pd.to_datetime(series, format=form, errors="coerce")
    except (ValueError, TypeError, OverflowError, UserWarning, AssertionError, KeyError, re.error) as error:
        raise RecordingError((None, f"time_format={short(form)} is no format of dates: {str(error)[:60]}")) from None


def guessed(texts, dayfirst):
    """Stamps in the one other way of writing that fits all texts; else a sentence that names the option; or None."""
    forms = other_formats(texts[0], dayfirst)
    fitting = [(form, stamps) for form in forms if not (stamps := by_format(texts, form)).isna().any()]
    if len(fitting) == 1:
        return fitting[0][1], None
    if len(fitting) == 2:
        return (
            None,
            "may be day and month or month and day: dayfirst=True or dayfirst=False tells (ISO 8601 is 2026-05-31)",
        )
    return None, None
