"""From latitude and longitude to metres in a plane, and how wrong the plane is at its edge."""

from dataclasses import replace

import numpy as np

from .faults import RecordingError, needs, short

EARTH = 6_371_000.0  # m, its mean radius


def metres(recording, lat, lon, origin):
    """East and north of the origin in place of the two columns, by the ellipsoid WGS 84."""
    pymap3d = needs("pymap3d", "a plane in metres")
    i, j = recording.find(lat), recording.find(lon)
    north, east = recording.values[:, i], recording.values[:, j]
    for name, degrees, most in ((lat, north, 90), (lon, east, 180)):
        wrong = np.flatnonzero(abs(degrees) > most)
        if wrong.size:
            worst = f"{degrees[wrong[0]]:g}"
            sentence = f"column {short(name)} has {worst}, which is no angle up to {most} degrees: missing=[{worst}]?"
            raise RecordingError((int(recording.lines[wrong[0]]), sentence))
    there = ~np.isnan(north) & ~np.isnan(east)
    if origin is None:
        if not there.any():
            raise RecordingError((None, "there is no row with a latitude and a longitude"))
        origin = (north[there][0], east[there][0])
    x, y = np.full(len(recording), np.nan), np.full(len(recording), np.nan)
    try:
        x[there], y[there], _ = pymap3d.geodetic2enu(north[there], east[there], 0.0, *map(float, origin), 0.0)
    except (TypeError, ValueError):
        raise RecordingError((None, f"origin must be latitude and longitude in degrees, got {short(origin)}")) from None
    far = float(np.nanmax(np.hypot(x, y))) if there.any() else 0.0
    short_by = far**3 / (6 * EARTH**2)  # of the arc: R sin(s / R) in place of s
    note = f"metres in a plane from {origin[0]:.6f}°, {origin[1]:.6f}°"
    note += f": at {far:.4g} m distances are {short_by:.2g} m too short"
    values = recording.values.copy()
    values[:, i], values[:, j] = y, x
    names = tuple("north" if k == i else "east" if k == j else name for k, name in enumerate(recording.names))
    units = tuple("m" if k in (i, j) else unit for k, unit in enumerate(recording.units))
    return replace(recording, values=values, names=names, units=units, notes=(*recording.notes, note))
