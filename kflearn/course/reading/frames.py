"""Tables that are in memory already: a DataFrame of pandas or of another library, or a dict of arrays."""

import numpy as np

from .faults import RecordingError, short
from .table import Table


def is_frame(source) -> bool:
    """A dict, or something with columns?"""
    return isinstance(source, dict) or hasattr(source, "columns") or hasattr(source, "column_names")


def table_of(source) -> Table:
    """A table whose lines are the numbers of the rows, counted from 1."""
    import pandas as pd

    if isinstance(source, dict):
        frame = _of_dict(source)
    elif isinstance(source, pd.DataFrame):
        frame = source
    else:
        frame = _of_another_library(source)
    if isinstance(frame.index, pd.DatetimeIndex):
        frame = frame.reset_index(names=str(frame.index.name or "index"))
    columns = [_plain(frame.iloc[:, j]) for j in range(frame.shape[1])]
    if not columns:
        raise RecordingError((None, "there is nothing in it: no columns"))
    titles = tuple(" ".join(map(str, name)) if isinstance(name, tuple) else str(name) for name in frame.columns)
    return Table(columns, titles, np.arange(1, len(frame) + 1), None, ",", "row")


def _of_dict(source):
    import pandas as pd

    lengths, columns = {}, {}
    for name, values in source.items():
        try:
            if isinstance(values, np.ma.MaskedArray):
                values = values.astype(float).filled(np.nan)
            array = np.asarray(values)
            if array.ndim != 1:
                raise ValueError
        except (ValueError, TypeError):
            raise RecordingError((None, f"{short(name)} must be a list or an array of one dimension")) from None
        lengths.setdefault(len(array), name)
        columns[str(name)] = pd.Series(values)
    if len(lengths) > 1:
        (n, one), (m, other), *_ = lengths.items()
        raise RecordingError(
            (None, f"the columns have {n} rows ({short(one)}) and {m} ({short(other)}): they must be alike")
        )
    return pd.DataFrame(columns)


def _of_another_library(source):
    """By narwhals, which knows Polars, Arrow, Modin and others."""
    import pandas as pd

    from .faults import needs

    nw = needs("narwhals", "a table of this library")
    try:
        frame = nw.from_native(source, eager_only=True)
    except TypeError:
        name = type(source).__name__
        raise RecordingError((None, f"{name} is no table: give a file name, a DataFrame or a dict of arrays")) from None
    columns = {}
    for name in frame.columns:
        column = frame[name]
        columns[name] = pd.Series(column.to_numpy())
        zone = getattr(column.dtype, "time_zone", None)
        if zone and columns[name].dtype.kind == "M" and getattr(columns[name].dt, "tz", None) is None:
            columns[name] = columns[name].dt.tz_localize("UTC").dt.tz_convert(zone)
    return pd.DataFrame(columns)


def _plain(column):
    """Numbers, dates or texts; other kinds (categories, decimals, nullable integers) become one of these."""
    import pandas as pd

    column = column.reset_index(drop=True)
    kind = column.dtype.kind
    if kind == "c":
        raise RecordingError((None, f"column {short(str(column.name))} holds complex numbers: take .real or .imag"))
    if pd.api.types.is_bool_dtype(column):
        return column.astype(object).map(str).str.lower()
    if pd.api.types.is_extension_array_dtype(column.dtype) and kind in "iuf":
        whole = kind in "iu" and not column.isna().any()
        return pd.Series(column.to_numpy(dtype=np.int64 if whole else float, **({} if whole else {"na_value": np.nan})))
    if kind == "f":
        return column.astype(float)
    if kind in "iuMm":
        return column
    texts = column.astype(object)
    return texts.where(texts.notna(), "").map(str)
