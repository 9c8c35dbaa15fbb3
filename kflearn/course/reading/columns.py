"""Which columns hold readings, and their numbers; what stands in the way is told with its line."""

import math
import re

import numpy as np

from .faults import RecordingError, listed, short
from .table import NUMBER, is_gap

THOUSANDS = re.compile(r"[+-]?\d{1,3}([., '’\u00a0\u202f]\d{3})+([.,]\d*)?", re.ASCII)
NUMBER_LIKE = re.compile(r"[-+−]?[\d.,'’\u00a0\u202f ]*\d[\d.,'’\u00a0\u202f ]*([eE][-+]?\d+)?")


class Numbers:
    """From text to number; keeps to one way of writing decimals within a file."""

    def __init__(self, separator, options):
        self.separator, self.mark, self.thousands = separator, options.decimal, options.thousands

    def __call__(self, text) -> float:
        text = text.replace("−", "-")
        if self.thousands is not None:
            text = text.replace(self.thousands, "")
        if not NUMBER.fullmatch(text):
            if found := THOUSANDS.fullmatch(text):
                raise ValueError(f"has separators of thousands: thousands={found[1][0]!r} takes them out")
            raise ValueError("is no number")
        mark = next((mark for mark in ".," if mark in text), None)
        if mark == "," == self.separator:
            raise ValueError("has a comma, but commas separate the columns: thousands=',' takes it out")
        if mark and mark != (self.mark or mark):
            raise ValueError(f"has a {mark!r} where others have {self.mark!r}: is it thousands={mark!r}?")
        value = float(text.replace(",", "."))
        if math.isinf(value):
            raise ValueError("is too large")
        self.mark = self.mark or mark
        return value


def chosen_of(table, places, options):
    """The columns to read, [j, …], and {j: why not} of the others: those asked for, or all that hold numbers."""
    columns = [options.columns] if isinstance(options.columns, str) else options.columns
    if columns is not None:
        if not isinstance(columns, (list, tuple)):
            raise RecordingError((None, f"columns must be a list of names, got {short(columns)}"))
        chosen = [table.find(name) for name in columns]
        if not chosen or set(places) & set(chosen) or len(set(chosen)) < len(chosen):
            fault = "there must be a column or more beside that of the time stamps, each named once"
            raise RecordingError((table.top, fault), word=table.word)
        return chosen, {}
    others = {}
    for j in range(len(table.names)):
        if j not in places and (why := _no_readings(table, j, options)):
            others[j] = why
    chosen = [j for j in range(len(table.names)) if j not in places and j not in others]
    if not chosen:
        told = "; ".join(f"{short(table.names[j])} holds {why}" for j, why in list(others.items())[:3])
        fault = "there must be a column or more beside that of the time stamps" + (f": {told}" if told else "")
        raise RecordingError((table.top, fault), word=table.word)
    return chosen, others


def _no_readings(table, j, options):
    """Why a column is not read without being asked for: "" if it is."""
    if table.is_numeric(j):
        return "no reading" if not (table.columns[j] == table.columns[j]).any() else ""
    marks = {str(mark) for mark in options.marks_of(table.names[j])}
    texts = [text for text in table.text(j) if not is_gap(text) and text not in marks]
    if not texts:
        return "no reading"
    if table.columns[j].dtype.kind == "M":
        return "dates"
    numbers = sum(bool(NUMBER_LIKE.fullmatch(text)) for text in texts)
    return "" if 2 * numbers >= len(texts) and numbers else f"{_kind(texts[0])}, such as {short(texts[0], 16)}"


def _kind(text):
    return "words" if any(sign.isalpha() for sign in text) else "no numbers"


def values_of(table, chosen, options, faults):
    """The readings (T, m), NaN for gaps; texts are read in the order of the lines."""
    values = np.empty((len(chosen), len(table))).T  # a column lies in one piece
    texts = {}
    for i, j in enumerate(chosen):
        if table.is_numeric(j):
            plain = isinstance(table.columns[j].dtype, np.dtype)  # others have a mark of their own for gaps
            values[:, i] = table.columns[j].to_numpy(**({} if plain else {"dtype": float, "na_value": np.nan}))
            for k in np.flatnonzero(np.isinf(values[:, i])) if table.exact else ():
                faults.append((int(table.lines[k]), f"column {short(table.names[j])}: {values[k, i]} is no number"))
        else:
            texts[i], values[:, i] = table.text(j), np.nan
    number = Numbers(table.separator, options)
    words = {i: {m for m in options.marks_of(table.names[chosen[i]]) if isinstance(m, str)} for i in texts}
    for k in range(len(table) if texts else 0):
        for i, column in texts.items():
            text = column[k]
            if is_gap(text) or text in words[i]:
                continue
            try:
                values[k, i] = number(text)
            except ValueError as error:
                help_ = f" (no reading? missing=[{short(text)}])" if str(error) == "is no number" else ""
                faults.append(
                    (int(table.lines[k]), f"column {short(table.names[chosen[i]])}: {short(text)} {error}{help_}")
                )
    for i, j in enumerate(chosen):
        marks = [float(m) for m in options.marks_of(table.names[j]) if not isinstance(m, str)]
        if marks:
            values[np.isin(values[:, i], marks), i] = np.nan
    return values


def without_silent(table, chosen, values, options, faults, others):
    """Columns in which every reading is a gap: a fault if they were asked for, else left out."""
    silent = np.array([bool(np.isnan(z[0]) and np.isnan(z).all()) for z in values.T])
    if options.columns is not None:
        faults += [
            (table.top, f"column {short(table.names[j])} holds no reading at all")
            for j, s in zip(chosen, silent, strict=True)
            if s
        ]
        return chosen, values
    if silent.all():
        faults.append((table.top, f"column {short(table.names[chosen[0]])} holds no reading at all"))
        return chosen, values
    if not silent.any():
        return chosen, values
    others |= {j: "no reading" for j, s in zip(chosen, silent, strict=True) if s}
    return [j for j, s in zip(chosen, silent, strict=True) if not s], values[:, ~silent]


__all__ = ["Numbers", "chosen_of", "listed", "values_of", "without_silent"]
