"""What a recording says when it is printed."""

import numpy as np

from .codes import sentence

HELD = 0.1  # share of repeated readings from which on it is told


def told(recording) -> str:
    """Its clock, its holes, and for each column range, gaps, resolution and repeated readings."""
    steps, evenness = recording.steps, "even" if recording.steps.even else "uneven"
    word = "line" if recording.lines.any() else "row"
    holes = [f"{steps.dt[k]:.4g} s after {word} {recording.lines[k]}" for k in steps.holes]
    more = [f"and {len(holes) - 3} more"] if len(holes) > 3 else []
    rate = f", {1 / steps.median:.4g} a second" if 0 < steps.median < 1 else ""
    lines = [
        f"{len(recording)} rows in {recording.time[-1]:.6g} s, the first at {recording.start}",
        f"steps: {steps.dt.min():.4g} to {steps.dt.max():.4g} s, median {steps.median:.4g} s{rate}, {evenness}",
        f"holes: {', '.join(holes[:3] + more) or 'none'}",
    ]
    for name, unit, z in zip(recording.names, recording.units, recording.values.T, strict=True):
        lines.append(_column(name, unit, z))
    lines += [sentence(*suspect) for suspect in recording.suspects]
    return "\n".join([*lines, *recording.notes])


def _column(name, unit, z):
    there = z[~np.isnan(z)]
    if not there.size:
        return f"{name}: no readings, gaps: {z.size}"
    line = f"{name}: {there.min():.6g} to {there.max():.6g} {unit or '(no unit)'}, gaps: {z.size - there.size}"
    step = resolution(there)
    line += f", resolution {step:.3g}" if step else ""
    held = np.mean(there[1:] == there[:-1]) if there.size > 1 else 0
    return line + (f", {held:.0%} repeat the reading before" if held > HELD else "")


def resolution(there) -> float:
    """The smallest step between readings, if all are multiples of it; else 0.

    >>> print(f"{resolution(np.array([1.2, 1.4, 1.8])):.1f}")
    0.2
    """
    steps = np.diff(np.unique(there))
    if not steps.size:
        return 0.0
    for step in (float(f"{steps.min():.6g}"), *(10.0**n for n in range(3, -7, -1))):
        counts = (there - there.min()) / step if step > 0 else np.array([np.inf])
        if 1 <= counts.max() < 1e6 and step < 1.01 * steps.min() and (abs(counts - np.round(counts)) < 0.01).all():
            return step
    return 0.0
