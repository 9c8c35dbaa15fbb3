"""Numbers that are dates or clocks: 20260118, 120059 under "utc [s]". They are never counted without asking."""

from dataclasses import dataclass

import numpy as np

CLOCK_NAMES = ("utc", "gmt", "hms", "clock", "time of day", "timeofday", "zulu")
DATE_NAMES = ("date", "datum", "fecha", "data", "day", "tag", "jour", "yyyy", "timestamp", "month")
FORMS = {14: "%Y%m%d%H%M%S", 12: "%Y%m%d%H%M", 10: "%Y%m%d%H", 8: "%Y%m%d", 6: "%Y%m"}


@dataclass(frozen=True)
class Digits:
    """A format that fits them; whether to read by it; what to say if not."""

    form: str
    read: bool
    sentence: str = ""


def looks_like(stamps, name, unit):
    """Digits, or None where the numbers look like a count."""
    if len(stamps) > 5000 and not _possible(stamps[:: len(stamps) // 1000]):
        return None
    if len(stamps) < 2 or not np.isfinite(stamps.astype(float)).all():
        return None
    whole = np.floor(stamps.astype(float))
    if stamps.dtype.kind in "iu" or (whole == stamps).all():
        form = _date_form(whole, str(unit) != "")
        if form:
            said = any(word in name.lower() for word in DATE_NAMES) and not unit and form != "%Y%m"
            count = f"time_unit='{unit or 's'}' counts them as they are"
            return Digits(form, said, f"digits such as {whole[0]:.0f} look like dates: time_format='{form}'; {count}")
    if _is_clock(whole, name, unit):
        form = "%H%M%S" if (whole == stamps).all() else "%H%M%S.%f"
        text = f"numbers such as {whole[0]:.0f} look like hours, minutes, seconds: time_format='{form}'"
        return Digits(form, False, f"{text}; time_unit='{unit or 's'}' counts them as they are")
    return None


def _possible(some):
    """May some of many stamps be a clock or dates?"""
    whole = np.floor(some.astype(float))
    return (whole % 100 < 60).all() and (_date_form(whole, True) is not None or whole.max() < 240_000)


def _date_form(whole, with_unit):
    """The format of strptime if all are dates between 1700 and 2199."""
    if whole.min() < 0 or whole.max() >= 1e15:
        return None
    lengths = {len(str(int(each))) for each in (whole.min(), whole.max())}
    form = FORMS.get(lengths.pop()) if len(lengths) == 1 else None
    if form is None or (form == "%Y%m" and with_unit):
        return None
    rest, parts = whole.astype(np.int64), []
    for _ in range((len(form) // 2) - 1):  # the last two digits again and again
        parts.append(rest % 100)
        rest = rest // 100
    month, *later = reversed(parts)
    right = (rest >= 1700) & (rest < 2200) & (month >= 1) & (month <= 12)
    for low, high, part in zip((1, 0, 0, 0), (31, 23, 59, 60), later, strict=False):
        right &= (low <= part) & (part <= high)
    return form if right.all() else None


def _is_clock(whole, name, unit):
    """Hours, minutes, seconds as one number: the last two digits never reach 60, a minute's end adds 40."""
    if str(unit) not in ("", "s", "sec", "seconds", "UTC", "utc", "hhmmss", "hhmmss.ss", "hhmmss.sss"):
        return False
    if whole.min() < 0 or whole.max() >= 240_000 or (whole % 100 >= 60).any() or (whole // 100 % 100 >= 60).any():
        return False
    if whole.max() >= 2400 and any(word in f"{name} {unit}".lower() for word in CLOCK_NAMES):
        return True
    seconds = whole // 10_000 * 3600 + whole // 100 % 100 * 60 + whole % 100
    written, true = np.diff(whole), np.diff(seconds)
    surplus = written - true
    return bool(
        np.median(written) == np.median(true)
        and (true > 0).all()
        and (surplus >= 40).any()
        and (surplus[surplus != 0] >= 40).all()
    )
