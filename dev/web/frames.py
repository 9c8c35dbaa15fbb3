"""The pictures of a playground, made beforehand: for a page where no kernel runs.

Runs inside a lesson's kernel: after `watch(folder)`, each playground that a cell shows leaves a folder 0, 1, 2 … there,
with its pictures and a frames.json of its controls and sentences.

Buttons combine with everything. So do two sliders, if there are pictures enough for both; otherwise one slider moves at
a time, while the others stand at their start.
"""

import io
import itertools
import json
import math
import re
from pathlib import Path

import numpy as np
from PIL import Image

from kflearn.ui import Playground
from kflearn.ui.controls import Slider, Toggle

BYTES = 1_950_000  # of all pictures of a playground
COUNTS = 121, 90, 60, 40, 25  # how many to try
FINEST, COARSEST = 25, 6  # places of a slider; with fewer than the latter, sliders move one at a time


def watch(folder):
    """From now on, record every playground at the moment when a cell shows it."""
    numbers = itertools.count()

    def show(playground, **kwargs):
        record(playground, Path(folder, str(next(numbers))))
        return {"text/plain": str(playground)}

    Playground._repr_mimebundle_ = show


def record(playground, folder):
    """Write the pictures of a playground and frames.json into a new folder."""
    for count in COUNTS:
        page, pictures = film(playground, count)
        if sum(map(len, pictures)) < BYTES:
            break
    else:
        raise ValueError(f"{playground}: even {len(pictures)} pictures are larger than {BYTES} bytes")
    folder.mkdir(parents=True)
    for number, picture in enumerate(pictures):
        (folder / f"{number}.webp").write_bytes(picture)
    (folder / "frames.json").write_text(json.dumps(page, ensure_ascii=False, indent=1), encoding="utf-8")


def film(playground, count):
    """What the page needs (controls; for each setting the number of a picture, and a sentence), and the pictures."""
    controls = list(playground.controls.values())
    values, together = places(controls, count)
    start = [stops.index(control.start) for stops, control in zip(values, controls, strict=True)]
    numbers, frames = {}, {}  # equal pictures have one number
    for setting in settings(values, start, [] if together else sliders(controls)):
        now = [stops[place] for stops, place in zip(values, setting, strict=True)]
        playground.set(**dict(zip(playground.controls, now, strict=True)))
        if playground.errors:
            raise playground.last_error
        number = numbers.setdefault(playground.png(), len(numbers))
        frames[",".join(map(str, setting))] = [number, playground.status]
    playground.reset()
    page = {
        "text": str(playground),
        "size": [round(100 * inches) for inches in playground.size],
        "controls": [describe(control, stops) for control, stops in zip(controls, values, strict=True)],
        "start": start,
        "together": together,
        "frames": frames,
    }
    return page, [small(png) for png in numbers]


def sliders(controls):
    """Which of the controls are sliders."""
    return [i for i, control in enumerate(controls) if isinstance(control, Slider)]


def places(controls, count):
    """The values of each control for about so many pictures, and whether all sliders can move together."""
    buttons = math.prod(len(control.options) for control in controls if not isinstance(control, Slider))
    count, moving = count / buttons, max(1, len(sliders(controls)))
    together = moving == 1 or count ** (1 / moving) >= COARSEST
    each = count ** (1 / moving) if together else 1 + (count - 1) / moving
    each = min(max(round(each), 3), FINEST)
    return [spread(c, each) if isinstance(c, Slider) else list(c.options) for c in controls], together


def spread(slider, count):
    """About so many values of a slider: both ends, the start, and others evenly between them, on the slider's steps."""
    scale = np.log if slider.log else np.asarray
    values = (np.geomspace if slider.log else np.linspace)(slider.low, slider.high, count)
    if slider.start not in (slider.low, slider.high):
        values[1 + np.argmin(abs(scale(values[1:-1]) - scale(slider.start)))] = slider.start
    between = {nearest(slider, value) for value in values[1:-1]}
    return sorted({slider.checked(value) for value in (slider.low, *between, slider.high)})


def nearest(slider, value):
    """What a slider gives when it is drawn to a value."""
    if value == slider.start:
        return slider.start
    if slider.log:
        return float(f"{value:.3g}")
    return round(slider.low + slider.step * round((value - slider.low) / slider.step), 12)


def settings(values, start, alone):
    """The places of all controls, in all combinations in which at most one of `alone` is away from its start."""
    for setting in itertools.product(*(range(len(stops)) for stops in values)):
        if sum(setting[i] != start[i] for i in alone) <= 1:
            yield setting


def describe(control, values):
    """A control for the page: its label with LaTeX, its plain name, and a text for each of its values."""
    unit = getattr(control, "unit", "")
    if isinstance(control, Slider):
        texts = [f"{written(value)} {unit}".rstrip() for value in values]
    else:
        texts = ["off", "on"] if isinstance(control, Toggle) else [str(value) for value in values]
    plain = re.sub(r"[$\\{}]", "", control.label)
    return {"label": control.label, "name": plain, "slider": isinstance(control, Slider), "texts": texts}


def written(value):
    """A number as one writes it by hand: 0.25, but 10⁻⁶ and 5.18·10⁷."""
    digits, _, power = f"{value:g}".partition("e")
    if not power:
        return digits
    ten = "10" + str(int(power)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return ten if digits == "1" else f"{digits}·{ten}"


def small(png):
    """A smaller file of the same picture."""
    file = io.BytesIO()
    Image.open(io.BytesIO(png)).convert("RGB").save(file, "webp", lossless=True, method=2, quality=50)
    return file.getvalue()
