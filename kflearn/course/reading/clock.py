"""From the columns of time stamps to seconds from the first."""

from dataclasses import dataclass, field

import numpy as np

from . import dates
from .digits import looks_like
from .faults import RecordingError, short
from .table import NUMBER, Table

SECONDS = {"ns": 1e-9, "us": 1e-6, "µs": 1e-6, "μs": 1e-6, "ms": 1e-3, "s": 1, "sec": 1, "seconds": 1, "secs": 1}
SECONDS |= {"min": 60, "minutes": 60, "h": 3600, "hours": 3600, "hr": 3600, "d": 86400, "days": 86400, "second": 1}
SECONDS |= {"w": 604800, "weeks": 604800, "month": dates.MONTH, "months": dates.MONTH, "year": dates.YEAR}
SECONDS |= {
    "years": dates.YEAR,
    "yr": dates.YEAR,
    "a": dates.YEAR,
    "milliseconds": 1e-3,
    "microseconds": 1e-6,
    "week": 604800,
}
SECONDS |= {"nanoseconds": 1e-9, "msec": 1e-3, "minute": 60, "hour": 3600, "day": 86400}
LATEST = 1e300  # seconds
NO_DATES = "time counted from midnight, as the stamps have no date"


@dataclass
class Clock:
    """The time stamps of a table.

    `seconds` from the first good stamp, NaN where a stamp is bad; `stamps` the numbers or dates themselves; `start`
    the first of them; `tick` the seconds of one unit of start (dates: 1); `notes` what should be said about them.
    """

    seconds: np.ndarray
    stamps: object
    start: object
    tick: float
    name: str
    texts: object  # a function: the k-th stamp as written
    dated: bool = False
    bad: dict = field(default_factory=dict)  # {row: what is wrong}
    notes: list = field(default_factory=list)


def clock_of(table: Table, places, options) -> Clock:
    """The clock in one column, or in two (date and clock)."""
    name = " and ".join(table.names[j] for j in places)
    if len(places) > 1:
        parts = [table.text(j) for j in places]
        texts = [" ".join(filter(None, row)) for row in zip(*parts, strict=True)]
        return _of_texts(texts, name, options)
    (j,) = places
    kind = table.columns[j].dtype.kind
    if kind == "M" or hasattr(table.columns[j].dtype, "tz"):
        return _dated(table.columns[j], {}, name, lambda k: str(table.columns[j][k]), options)
    if kind == "m":
        return _numeric(table.columns[j].to_numpy().astype("timedelta64[ns]").astype(np.int64), 1e-9, name, None)
    if kind in "iuf" and options.time_format is None:
        return _of_numbers(table, j, options)
    texts = table.text(j)
    some = texts[:: 1 + len(texts) // 1000]
    numbers = 2 * sum(bool(NUMBER.fullmatch(text.replace("−", "-"))) for text in some) >= len(some)
    if numbers and options.time_format is None:
        return _of_numbers(table, j, options)
    return _of_texts(texts, name, options)


# ---- numbers


def _of_numbers(table, j, options):
    """From numbers with a unit, unless they look like dates."""
    name, bad, stamps = table.names[j], {}, table.columns[j].to_numpy()
    if not table.is_numeric(j):
        stamps, bad = _numbers(table.text(j), table.separator, options)
    elif stamps.dtype.kind == "f":
        bad = {int(k): "" for k in np.flatnonzero(np.isnan(stamps))}
    asked = options.time_unit is not None and str(options.time_unit) != ""
    unit = options.time_unit if asked else table.units[j]
    if not asked and not unit and name.lower() in ("year", "years", "yr"):
        unit = "year"
    good = np.delete(stamps, list(bad)) if bad else stamps
    if not asked and (found := looks_like(good, name, unit)):
        if found.read:
            texts = ["" if k in bad else f"{int(each)}" for k, each in enumerate(stamps)]
            return _of_texts(texts, name, options, found.form)
        raise RecordingError((table.top, f"column {short(name)}: {found.sentence}"), word=table.word)
    scale = SECONDS.get(str(unit)) or SECONDS.get(str(unit).lower())
    if scale is None:
        reason = f"{short(unit)} is not one of ns, us, ms, s, min, h, d, week, month, year"
        reason = reason if str(unit) else f"write [s] or [ms] behind it, or time_unit='s'{_since_1970(good)}"
        fault = f"column {short(name)} needs the unit of its time stamps: {reason}"
        raise RecordingError((table.top, fault), word=table.word)
    texts = table.text(j) if len(stamps) < 1000 or bad else None
    return _numeric(stamps, scale, name, texts.__getitem__ if texts else lambda k: f"{stamps[k]:.15g}", bad)


def _since_1970(stamps):
    """Do they look like a count since 1970?"""
    for unit, size in (("s", 1), ("ms", 1e3), ("us", 1e6), ("ns", 1e9)):
        if len(stamps) and 1e9 * size <= stamps[0] < 2.5e9 * size and unit != "s":
            return f"; such numbers are {unit} since 1970: time_unit='{unit}'"
    return ""


def _numbers(texts, separator, options):
    """Numbers of texts, whole ones as integers, and {row: what is wrong}."""
    from .columns import Numbers

    number, bad, values = Numbers(separator, options), {}, []
    for k, text in enumerate(texts):
        try:
            if not text:
                raise ValueError("")
            values.append(number(text))
        except ValueError as error:
            bad[k] = str(error)
            values.append(0.0)
    array = np.array(values)
    whole = all(text.replace("−", "-").lstrip("+-").isdigit() for k, text in enumerate(texts) if k not in bad)
    if whole and len(array) and abs(array).max() < 9e18:
        array = np.array([int(text.replace("−", "-")) if k not in bad else 0 for k, text in enumerate(texts)])
    return array, bad


def _in_seconds(apart, scale):
    """Differences in units of scale seconds, divided once."""
    if scale == 1:
        return apart.astype(float, copy=False)
    return apart * float(scale) if scale > 1 else apart / float(round(1 / scale))


def _numeric(stamps, scale, name, quoted, bad=None):
    """Integers are subtracted as integers, and divided once."""
    bad = dict(bad or {})
    good = np.array([k for k in range(len(stamps)) if k not in bad]) if bad else range(len(stamps))
    start = stamps[good[0]] if len(good) else 0
    with np.errstate(over="ignore"):
        apart = stamps.astype(np.int64) - np.int64(start) if stamps.dtype.kind in "iu" else stamps - start
        seconds = _in_seconds(apart, scale)
    if stamps.dtype.kind in "iu" and len(good) and stamps.astype(float).max() - stamps.astype(float).min() > 9e18:
        seconds = (stamps.astype(float) - float(start)) * scale
    near = seconds.size and seconds.min() > -LATEST and seconds.max() < LATEST  # NaN is not
    for k in () if near else np.flatnonzero(~(abs(seconds) < LATEST)):
        bad.setdefault(int(k), "is too far from the first")
    for k in bad:
        seconds[k] = np.nan
    return Clock(
        seconds, stamps, start.item() if len(good) else 0, scale, name, quoted or (lambda k: str(stamps[k])), False, bad
    )


# ---- dates


def _of_texts(texts, name, options, form=None):
    """From dates, or clocks without a date, as texts."""
    form = form or options.time_format
    bad = {k: "" for k, text in enumerate(texts) if not text}
    full = [text for text in texts if text]
    if not full:
        return _nothing(texts, name, bad)
    if form:
        return _formatted(texts, form, bad, name, options)
    if not bad and (found := dates.clocks(full)) is not None:
        return Clock(found - found[0], found, float(found[0]), 1, name, texts.__getitem__, notes=[NO_DATES])
    if not bad and (found := dates.periods(full)) is not None:
        seconds, stamps, note = found
        return Clock(seconds, stamps, stamps[0], 1, name, texts.__getitem__, True, notes=[note])
    stamps, faults = dates.iso([text or full[0] for text in texts])
    if len(faults) == len(texts):
        there = [k for k, text in enumerate(texts) if text]
        other, sentence = dates.guessed(full, options.dayfirst)
        if sentence:
            return _nothing(texts, name, {there[0]: sentence})
        if other is not None:
            stamps, faults = other.set_axis(there).reindex(range(len(texts))), {}
    bad |= {k: f"{why} (or time_format=…)" if why == dates.NO_DATE else why for k, why in faults.items() if texts[k]}
    return _dated(stamps, bad, name, texts.__getitem__, options)


def _nothing(texts, name, bad):
    """A clock without a good stamp."""
    return Clock(np.full(len(texts), np.nan), None, None, 1, name, texts.__getitem__, True, bad)


def _formatted(texts, form, bad, name, options):
    """By the caller's own format."""
    if not any(sign in form for sign in ("%d", "%j", "%Y", "%y", "%m", "%U", "%W", "%V", "%x", "%c", "%s", "%b", "%B")):
        texts_ = [_filled(text, form) for text in texts]
        stamps = dates.by_format(texts_, form)
        bad |= {int(k): f"does not fit time_format={short(form)}" for k in np.flatnonzero(stamps.isna()) if texts[k]}
        seconds = np.array([(s - s.normalize()).total_seconds() if s == s else np.nan for s in stamps])
        start = seconds[~np.isnan(seconds)][0] if not np.isnan(seconds).all() else 0.0
        return Clock(seconds - start, seconds, float(start), 1, name, texts.__getitem__, False, bad, [NO_DATES])
    stamps = dates.by_format(texts, form)
    bad |= {int(k): f"does not fit time_format={short(form)}" for k in np.flatnonzero(stamps.isna()) if texts[k]}
    return _dated(stamps, bad, name, texts.__getitem__, options)


def _filled(text, form):
    """Digits of a clock with the zeros that a spreadsheet has taken away: 90059 → 090059."""
    if form.replace("%f", "").replace(".", "") == "%H%M%S":
        whole, point, rest = text.partition(".")
        return whole.zfill(6) + ((point + (rest or "0")) if "%f" in form else "")
    return text


def _dated(stamps, bad, name, quoted, options):
    """From dates of pandas to seconds."""
    import pandas as pd

    bad = dict(bad)
    bad |= {int(k): "is missing" for k in np.flatnonzero(stamps.isna()) if int(k) not in bad}
    zoned = getattr(stamps.dt, "tz", None) is not None
    notes = []
    if options.zone is not None:
        stamps, start_zone = _in_zone(stamps, zoned, options.zone, bad, quoted), options.zone
        notes.append(f"local time of {start_zone}")
    good = [k for k in range(len(stamps)) if k not in bad] if bad else range(len(stamps))
    if not len(good):
        return Clock(np.full(len(stamps), np.nan), None, None, 1, name, quoted, True, bad, notes)
    start = stamps.iloc[good[0]]
    plain = stamps.dt.tz_convert("UTC").dt.tz_localize(None) if getattr(stamps.dt, "tz", None) else stamps
    ticks = plain.to_numpy()
    per = {"s": 1, "ms": 10**3, "us": 10**6, "ns": 10**9}[np.datetime_data(ticks.dtype)[0]]
    numbers = ticks.astype(np.int64)
    seconds = (numbers - numbers[good[0]]) / per
    for k in bad:
        seconds[k] = np.nan
    if zoned and options.zone is None:
        start = dates.zoned_first(str(quoted(good[0])), start)
    return Clock(seconds, stamps, pd.Timestamp(start), 1, name, quoted, True, bad, notes)


def _in_zone(stamps, zoned, zone, bad, quoted):
    """Local time with its zone; what the clocks left out or repeated undecidably is a fault."""
    import pandas as pd

    try:
        if zoned:
            return stamps.dt.tz_convert(zone)
        plain = stamps.dt.tz_localize(zone, ambiguous="NaT", nonexistent="NaT")
    except Exception as error:
        if (
            "tz" in str(error).lower()
            or "zone" in type(error).__name__.lower()
            or isinstance(error, (KeyError, ValueError))
        ):
            raise RecordingError((None, f"zone={short(zone)} is not known; such as 'Europe/Berlin'")) from None
        raise
    open_ = plain.isna() & ~stamps.isna()
    try:
        told = stamps.dt.tz_localize(zone, ambiguous="infer", nonexistent="NaT")
    except ValueError:
        told = plain
    for k in np.flatnonzero(told.isna() & open_):
        early, late = (pd.Timestamp(stamps[k]).tz_localize(zone, ambiguous=a, nonexistent="NaT") for a in (True, False))
        why = (
            f"does not exist in {zone}: the clocks were put forward"
            if pd.isna(early)
            else (f"happened twice in {zone} when the clocks were put back, and nothing tells which it is")
        )
        bad.setdefault(int(k), why)
        del late
    return told
