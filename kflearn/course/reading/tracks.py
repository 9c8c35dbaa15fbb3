"""Tracks that are no tables: GPX by gpxpy, NMEA by pynmea2; and words for other files."""

import numpy as np

from .faults import RecordingError, needs
from .table import Table

KNOTS = 1852 / 3600  # m/s
MAGIC = (
    (b"PK\x03\x04", "a zip file, perhaps an Excel workbook: pandas.read_excel, then read(the DataFrame)"),
    (b"\xd0\xcf\x11\xe0", "an old Excel workbook: pandas.read_excel, then read(the DataFrame)"),
    (b"PAR1", "a Parquet file: pandas.read_parquet, then read(the DataFrame)"),
    (b"\x89HDF", "an HDF5 file: pandas.read_hdf or h5py, then read(a dict of arrays)"),
    (b"\x1f\x8b", "a gzip file: unpack it first"),
    (b"SQLite", "an SQLite database: pandas.read_sql, then read(the DataFrame)"),
    (b"MDF ", "an MDF file: asammdf's to_dataframe(), then read(the DataFrame)"),
    (b"TDSm", "a TDMS file: nptdms's as_dataframe(), then read(the DataFrame)"),
    (b"#ROSBAG", "a ROS bag: rosbags reads it, then read(a dict of arrays)"),
    (b"\x89MCAP", "an MCAP file: rosbags or mcap read it, then read(a dict of arrays)"),
    (b"ULog", "a drone's ULog: pyulog reads it, then read(a dict of arrays)"),
    (b"\xb5b", "UBX, the binary form of a receiver: pyubx2 reads it, then read(a dict of arrays)"),
    (b"MATLAB", "a MATLAB file: scipy.io.loadmat, then read(a dict of arrays)"),
    (b"%PDF", "a PDF: take the table out of it first"),
)


def refuse_binary(raw, name):
    """A sentence for a file that is no text, with what reads it."""
    found = next((words for magic, words in MAGIC if raw.startswith(magic)), None)
    found = "a FIT file: fitdecode or fit-tool read it, then read(a dict of arrays)" if raw[8:12] == b".FIT" else found
    if found:
        raise RecordingError((None, f"{name} is {found}"))


def gpx(text) -> Table:
    """Latitude, longitude and height of all points of a GPX file that have a time."""
    import pandas as pd

    gpxpy = needs("gpxpy", "GPX")
    try:
        found = gpxpy.parse(text)
    except Exception as error:  # of whatever parser gpxpy uses
        raise RecordingError((None, f"this GPX cannot be read: {str(error)[:60]}")) from None
    points = [point for track in found.tracks for part in track.segments for point in part.points] or found.waypoints
    timed = [(k, point) for k, point in enumerate(points, 1) if point.time is not None]
    if len(timed) < 2:
        raise RecordingError(
            (None, f"this GPX has {len(points)} points, {len(timed)} of them with a time: two are needed")
        )
    stamps = pd.Series(pd.to_datetime([p.time for _, p in timed], utc=True))
    places = np.array(
        [[p.latitude, p.longitude, np.nan if p.elevation is None else p.elevation] for _, p in timed], float
    )
    columns = [stamps, *(pd.Series(each) for each in places.T)]
    titles = ("time", "lat [deg]", "lon [deg]", "height [m]")
    return Table(columns, titles, np.array([k for k, _ in timed]), None, "", "point")


def nmea(text, options) -> Table:
    """Positions of RMC and GGA sentences, one row for each time; without a fix a gap."""
    import pandas as pd

    rows: dict = {}
    lines: dict = {}
    faults: list = []
    for n, stamp, said in _sentences(text, bool(options.checksum), faults):
        lines.setdefault(stamp, n)
        rows.setdefault(stamp, {}).update(said)
    if faults:
        raise RecordingError(*faults)
    if len(rows) < 2:
        raise RecordingError((None, f"{len(rows)} RMC or GGA sentences with date and time found: two are needed"))
    columns = [pd.Series(list(rows))]
    for name in ("lat", "lon", "height", "speed", "course"):
        columns.append(pd.Series([row.get(name, np.nan) for row in rows.values()], dtype=float))
    titles = ("time", "lat [deg]", "lon [deg]", "height [m]", "speed [m/s]", "course [deg]")
    return Table(columns, titles, np.array(list(lines.values())), None, "", "line")


def _sentences(text, checksum, faults):
    """(line, stamp, what it says) of each RMC and GGA sentence from the first date on."""
    import pandas as pd

    pynmea2, day = needs("pynmea2", "NMEA"), None
    for n, line in enumerate(text.splitlines(), 1):
        at = line.find("$")
        if at < 0 or line[at + 3 : at + 6] not in ("RMC", "GGA"):
            continue
        try:
            said = pynmea2.parse(line[at:].strip() if checksum else line[at:].partition("*")[0], check=checksum)
            day = getattr(said, "datestamp", None) or day
            if day is None or said.timestamp is None:
                continue
            stamp = pd.Timestamp.combine(day, said.timestamp)
            yield n, stamp if stamp.tzinfo else stamp.tz_localize("UTC"), _said(said)
        except pynmea2.ChecksumError:
            faults.append(
                (n, "the checksum does not match, so a sign may be wrong: checksum=False reads it all the same")
            )
        except (pynmea2.ParseError, ValueError, AttributeError, TypeError):
            faults.append((n, "this NMEA sentence cannot be read: delete the line"))


def _said(said):
    """What a sentence says of the position: nothing without a fix (pynmea2 gives 0° N 0° E then)."""
    if not said.is_valid or not said.lat or not said.lon:
        return {}
    row = {"lat": said.latitude, "lon": said.longitude}
    if said.sentence_type == "GGA" and said.altitude is not None:
        row["height"] = float(said.altitude)
    if said.sentence_type == "RMC" and said.spd_over_grnd is not None:
        row["speed"] = float(said.spd_over_grnd) * KNOTS
    if said.sentence_type == "RMC" and said.true_course is not None:
        row["course"] = float(said.true_course)
    return row
