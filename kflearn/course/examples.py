"""Real recordings: measured, not simulated, so nobody knows the truth behind them.

    light     a hundred measurements of the speed of light, 1879
    nile      the flow of the Nile at Aswan, yearly, 1871 to 1970
    co2       carbon dioxide on Mauna Loa, weekly, 1958 to 2001, with gaps
    seattle   the weather of Seattle, daily, 2012 to 2015
    spring    discharge and level of Silver Springs, daily, 2010 to 2022, with gaps and a hurricane
    imu       an inertial sensor, 50 times a second, moved for some seconds and then at rest

Each file begins with comments that say where it is from, its licence, its units and what was left out; the appendix
*Recordings* of the notebooks says more. (`recordings.example` gives the files that are simulated.)

Examples
--------
>>> from kflearn import examples
>>> nile = examples.load("nile")
>>> print(len(nile), nile["flow"][:3], nile.licence)
100 [1120. 1160.  963.] public domain (as statsmodels says)
"""

from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np

from .recordings import Recording, RecordingError, read

__all__ = ["NAMES", "Example", "how_well", "load", "path", "who_fits_nile"]

NAMES = ("light", "nile", "co2", "seattle", "spring", "imu")


@dataclass(frozen=True, eq=False, kw_only=True)
class Example(Recording):
    """A recording that says where it is from.

    Attributes
    ----------
    time, values, names, units, lines, start
        As those of a Recording.
    title, source, licence : str
        What it is, where it is from, and under which terms it may be passed on.
    """

    title: str
    source: str
    licence: str


def path(name) -> Path:
    """The file of a real recording, to be read as if it were one's own.

    Parameters
    ----------
    name : str
        As for `load`.

    Returns
    -------
    Path
        Of a table of text, which begins with comments.

    Raises
    ------
    RecordingError
        For any other name.

    Examples
    --------
    >>> from kflearn import examples
    >>> print(examples.path("co2").name)
    co2.csv
    """
    if name not in NAMES:
        raise RecordingError((None, f"there is no real recording {name!r}; they are {', '.join(NAMES)}"))
    return Path(__file__).with_name("data") / f"{name}.csv"


def load(name) -> Example:
    """A real recording of the course, read by `recordings.read`.

    Parameters
    ----------
    name : str
        "light", "nile", "co2", "seattle", "spring" or "imu".

    Raises
    ------
    RecordingError
        For any other name.

    Examples
    --------
    >>> from kflearn import examples
    >>> air = examples.load("co2")
    >>> print(air.title)
    carbon dioxide in the air on Mauna Loa, Hawaii, week by week, 1958 to 2001
    >>> print(f"{air['co2'][0]} {air.units[0]}")
    316.1 ppm
    """
    file = path(name)
    said, recording = _said(file), read(file)
    parts = {field.name: getattr(recording, field.name) for field in fields(recording)}
    return Example(**parts, title=said["title"], source=said["source"], licence=said["licence"])


def _said(file):
    """What the comments at the top of a file say: "# licence: public domain" → {"licence": "public domain"}."""
    lines = file.read_text(encoding="utf-8").splitlines()
    pairs = (line[2:].partition(": ") for line in lines if line.startswith("# "))
    return {key: value for key, colon, value in pairs if colon}


def how_well() -> np.ndarray:
    """The study of lesson 24: what `fit` finds in 10,000 random walks each with R = 1, for lengths T and true Q.

    Returns
    -------
    ndarray
        One row for each pair of T and Q, with named columns: T, Q, mean_Q, low_Q, median_Q, high_Q (quantiles 5, 50 and
        95 %), share_zero, inside, inside_log, mean_R, low_R, median_R, high_R, inside_R; see dev/how_well.py.

    Examples
    --------
    >>> from kflearn import examples
    >>> first = examples.how_well()[0]
    >>> print(f"T = {first['T']:.0f}, Q = {first['Q']:g}: Q = 0 is found in {first['share_zero']:.0%}")
    T = 25, Q = 0: Q = 0 is found in 63%
    """
    return np.genfromtxt(Path(__file__).with_name("data") / "how_well.csv", delimiter=",", names=True)


def who_fits_nile() -> np.ndarray:
    """What `fit` and thirteen calls of other libraries find for R and Q of the Nile, each with its own defaults.

    Returns
    -------
    ndarray
        One row for each call, with named columns. Of the Nile: library, version, call, R, Q, log_likelihood (as the
        library counts it), steps, converged ("yes", "no", "-" where it has no word for it, "boundary" where it says
        that Q is at its boundary). Of the Nile times 1000, in the first unit: R_1000, Q_1000, converged_1000. Of white
        noise, where Q is 0: R_white, Q_white, converged_white. also: what else the call fits. seen: the day of the run.
        See dev/who_fits_nile.py.

    Examples
    --------
    >>> from kflearn import examples
    >>> for row in examples.who_fits_nile()[1:4]:
    ...     print(f"{row['library']} {row['version']}: R = {row['R']:.0f}, Q = {row['Q']:.0f}")
    statsmodels 0.15.0: R = 15078, Q = 1479
    statsmodels exact 0.15.0: R = 15068, Q = 1485
    R StructTS 4.2.2: R = 15099, Q = 1469
    """
    path = Path(__file__).with_name("data") / "who_fits_nile.csv"
    return np.genfromtxt(path, delimiter=",", names=True, dtype=None, encoding="utf-8")
