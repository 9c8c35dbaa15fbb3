"""Make the three recordings that ship with the package, always the same ones.

    python -m dev.recordings            writes kflearn/course/data/lift.csv, cyclist.csv, thermometer.csv

They are generated, not measured; what they look like, and what is wrong with them, is taken from life.

lift         a phone in a lift: height from air pressure, 5 times a second, and acceleration. Stands still for 20 s,
             then three rides. Noise 0.3 m; doors make the pressure jump (outliers of 2 to 5 m). Comma, seconds.
cyclist      a phone on a bicycle: position in metres, speed in km/h, about once a second, now and then a fix left out.
             Waits for a minute, rides, waits at a light, rides through a tunnel (no fix), rides on, stops. Noise 3 m;
             3 fixes in 100 are reflections, and so is the first after the tunnel. Written by a European spreadsheet:
             semicolons, decimal commas, dates with a zone, a byte order mark.
thermometer  a logger in a room: temperature and humidity every 10 s, for two and a half hours; window open for a while.
             Noise 0.12 °C and 0.8 %. Milliseconds, comments, missing fields, and two stretches without rows.
"""

from datetime import datetime, timedelta, timezone
from pathlib import Path

import numpy as np

DATA = Path(__file__).parent.parent / "kflearn" / "course" / "data"


def lift(rng):
    """Lines of lift.csv."""
    dt, rides = 0.2, [(20, 12.8), (45, 9.6), (68, -22.4)]  # when each ride begins (s), how far it goes (m)
    t = dt * np.arange(476)
    height, acceleration = np.zeros_like(t), np.zeros_like(t)
    for begin, distance in rides:
        s, a = _ride(t - begin, abs(distance))
        height += np.sign(distance) * s
        acceleration += np.sign(distance) * a
    z = height + rng.normal(0, 0.3, t.size)
    doors = np.concatenate([rng.choice(np.flatnonzero((t > a) & (t < b)), 3, False) for a, b in ((31, 44), (55, 67))])
    odd = np.concatenate([doors, rng.choice(np.flatnonzero(t > 20), 5, False)])
    z[odd] += rng.choice([-1, 1], odd.size) * rng.uniform(2, 5, odd.size)
    a = acceleration + 0.02 + rng.normal(0, 0.05, t.size)
    rows = [f"{t:.1f},{h:.2f},{a:.3f}" for t, h, a in zip(t, z, a, strict=True)]
    return ["time [s],height [m],acceleration [m/s^2]", *rows]


def _ride(t, distance, push=0.8, top=1.6):
    """Distance and acceleration of one ride from rest to rest."""
    up, cruise = top / push, distance / top - top / push
    a = np.where((t > 0) & (t < up), push, 0) - np.where((t > up + cruise) & (t < 2 * up + cruise), push, 0)
    first, last = np.clip(t, 0, up), np.clip(t - up - cruise, 0, up)
    s = push * first**2 / 2 + top * np.clip(t - up, 0, cruise) + top * last - push * last**2 / 2
    return s, a


# The ride: from (s), wanted speed (m/s), turn rate (degrees/s); she rides on as told until the next line
RIDE = np.array(
    [
        (0, 0, 0), (60, 6, 0), (106, 5, 8), (117, 6.5, 0), (150, 7, -3), (166, 5, -3), (182, 0, 0), (212, 6, 0),
        (226, 6, -8), (233, 6.5, 0), (285, 6, 7), (296, 6, -7), (312, 6, 6), (320, 6.5, 0), (342, 5, 8),
        (352, 6.5, 0), (384, 0, 0),
    ]
)  # fmt: skip


def _ridden(t, dt, rng):
    """Positions and speeds at the times t of the ride, in a wind."""
    wanted, turn = RIDE[np.searchsorted(RIDE[:, 0], t, side="right") - 1, 1:].T
    speed, heading, wind = np.zeros_like(t), np.zeros_like(t), 0.0
    for k in range(1, t.size):
        wind += -wind * dt / 8 + 0.4 * np.sqrt(dt) * rng.standard_normal()
        pull = np.clip(wanted[k] + wind * (wanted[k] > 0) - speed[k - 1], -1.0, 0.8)
        speed[k] = max(speed[k - 1] + pull * dt, 0)
        heading[k] = heading[k - 1] + np.radians(turn[k]) * dt * (speed[k] > 0)
    return np.cumsum(speed[:, None] * np.stack([np.cos(heading), np.sin(heading)], -1) * dt, axis=0), speed


def _fixes(t, path, rng):
    """At which steps there is a fix, and where it says she is: with noise and reflections."""
    steps = rng.choice([10, 20, 30], 4100, p=[0.78, 0.17, 0.05])
    k = np.cumsum(steps)[np.cumsum(steps) < t.size] - 10
    k = k[(t[k] < 240) | (t[k] > 268)]  # the tunnel
    z = path[k] + rng.normal(0, 3, (k.size, 2))
    reflected = (t[k] > 62) & (rng.random(k.size) < 0.03)
    reflected[np.flatnonzero(t[k] > 268)[0]] = True
    angle, far = rng.uniform(0, 2 * np.pi, k.size), rng.uniform(20, 60, k.size)
    return k, z + (reflected * far * [np.cos(angle), np.sin(angle)]).T


def cyclist(rng):
    """Lines of cyclist.csv."""
    dt = 0.1
    t = dt * np.arange(4100)
    path, speed = _ridden(t, dt, rng)
    k, z = _fixes(t, path, rng)
    seen = 3.6 * abs(speed[k] + rng.normal(0, 0.25, k.size))
    lost = (t[k] > 62) & (rng.random(k.size) < 0.015)  # stamped, but no position
    begin = datetime(2026, 5, 3, 8, 14, 2, tzinfo=timezone(timedelta(hours=2)))
    rows = []
    for now, (e, n), v, gone in zip(t[k] + rng.normal(0, 0.02, k.size), z, seen, lost, strict=True):
        stamp = (begin + timedelta(seconds=round(now, 2) + 1)).isoformat(timespec="milliseconds")
        readings = ";;" if gone else f"{e:.2f};{n:.2f};{v:.1f}".replace(".", ",")
        rows.append(f"{stamp};{readings}")
    return ["\ufefftime;east [m];north [m];speed [km/h]", *rows]


def thermometer(rng):
    """Lines of thermometer.csv."""
    n = 901
    t = 10.0 * np.arange(n)
    outside = np.where((t > 3600) & (t < 4500), 9.0, 20.0 + 1.5 * np.sin(2 * np.pi * np.maximum(t - 1800, 0) / 9000))
    room = np.empty(n)
    room[0] = 20
    for k in range(1, n):
        slow = 800 if 3600 < t[k] < 4500 else 2500
        room[k] = room[k - 1] + (outside[k] - room[k - 1]) * 10 / slow + 0.008 * rng.standard_normal()
    temperature = room + rng.normal(0, 0.12, n)
    humidity = 45 - 1.5 * (room - 20) + np.cumsum(rng.normal(0, 0.05, n)) + rng.normal(0, 0.8, n)
    stamps = 125_000 + 10_000 * np.arange(n) + rng.integers(0, 12, n)
    rows = []
    for stamp, c, h, draw in zip(stamps, temperature, humidity, rng.random(n), strict=True):
        c, h = "" if draw < 0.02 else f"{c:.2f}", "NA" if 0.015 < draw < 0.04 else f"{h:.1f}"
        rows.append(f"{stamp},{c},{h}")
    kept = [*rows[:250], "# battery changed", *rows[268:610], *rows[613:]]
    head = ["# room logger, ground floor", "# stamps: milliseconds since power-on"]
    return [*head, "time [ms],temperature [°C],humidity [%]", *kept]


RECORDINGS = ((lift, 4), (cyclist, 21), (thermometer, 3))  # with their seeds


def main():
    DATA.mkdir(exist_ok=True)
    for make, seed in RECORDINGS:
        lines = make(np.random.default_rng(seed))
        (DATA / f"{make.__name__}.csv").write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
