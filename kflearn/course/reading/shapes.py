"""Rows of one object, and tables with one reading a row made wide."""

import numpy as np

from .faults import RecordingError, short
from .table import Table, named


def where(table: Table, choice) -> Table:
    """The rows in which the columns hold what was asked for."""
    mask = np.ones(len(table), bool)
    for name, wanted in choice.items():
        j = table.find(name)
        wanted = list(wanted) if isinstance(wanted, (list, tuple, set)) else [wanted]
        texts = np.array(table.text(j), dtype=object)
        these = {str(each).strip() for each in wanted} | {str(each).removesuffix(".0") for each in wanted}
        mask &= np.array([text in these for text in texts], bool)
        if not mask.any():
            have = ", ".join(dict.fromkeys(texts[:1000].tolist()))
            fault = (
                f"where={short(choice, 40)}: there is no such row; column {short(table.names[j])} has {short(have, 40)}"
            )
            raise RecordingError((None, fault))
    return table.take(mask)


def pivot(table: Table, names, places) -> Table:
    """From one reading a row (time, sensor, reading) to a column for each sensor."""
    import pandas as pd

    j, v = (table.find(name) for name in names)
    if {j, v} & set(places) or j == v:
        raise RecordingError((table.top, "pivot must name two columns beside that of the time stamps"))
    sensors = table.text(j)
    kinds = [kind for kind in dict.fromkeys(sensors) if kind]
    if len(kinds) > 200:
        raise RecordingError(
            (table.top, f"column {short(table.names[j])} names {len(kinds)} sensors: is it the right one?")
        )
    columns, sensors = [table.columns[p] for p in places], np.array(sensors, dtype=object)
    readings = table.columns[v]
    for kind in kinds:
        here = sensors == kind
        columns.append(
            readings.where(here) if table.is_numeric(v) else pd.Series(np.where(here, readings, ""), dtype=object)
        )
    pairs = [named(kind) for kind in kinds]
    names = [table.names[p] for p in places] + [name or kind for (name, _), kind in zip(pairs, kinds, strict=True)]
    units = [table.units[p] for p in places] + [unit or table.units[v] for _, unit in pairs]
    return table.with_columns(columns, names, units)
