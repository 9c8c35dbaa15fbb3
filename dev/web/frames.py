"""Playgrounds recorded beforehand: for a page where no kernel runs.

Runs inside a lesson's kernel: after `watch(folder, lesson)`, each playground that a cell shows leaves a folder 0, 1, 2
… there: recorded.js, which a page loads, page.json with what the page needs before that, and a picture of the start.

Buttons combine with everything. So do the sliders, where a grid of all of them is small enough; else any two of them
move together, while the others stand at their start. Among the places of a slider are all values that the lesson names.
"""

import io
import itertools
import json
import math
import sys
from base64 import b64encode
from pathlib import Path

import nbformat
import numpy as np
from PIL import Image

from dev.web import named
from dev.web.packed import Packer
from kflearn.ui import Playground
from kflearn.ui.controls import Slider

BYTES = 1_000_000  # of recorded.js, at most
MOST = 1500  # settings of a playground, about
FINEST, COARSEST = 41, 6  # places of a slider; with fewer than the latter, not all sliders move together
RATIO = 2.0  # pixels of the picture for each pixel of the page


def watch(folder, lesson):
    """From now on, record every playground of a lesson, a notebook's path, at the moment when a cell shows it."""
    numbers, cells = itertools.count(), nbformat.read(lesson, as_version=4).cells

    def show(playground, **kwargs):
        names = [name for name, thing in vars(sys.modules["__main__"]).items() if thing is playground]
        wanted = named.settings(playground, cells, next(name for name in names if name[0] != "_"))
        record(playground, Path(folder, str(next(numbers))), wanted)
        return {"text/plain": str(playground)}

    Playground._repr_mimebundle_ = show


def record(playground, folder, wanted=None):
    """Write a playground's recorded.js, page.json and start.webp into a new folder.

    wanted : values that a slider must have among its places, by its name
    """
    count, stage = MOST, playground._stage
    stage.show_at(RATIO)
    while True:
        page, script = recording(playground, count, wanted or {})
        if len(script) < BYTES:
            break
        count = int(0.9 * count * BYTES / len(script))
        if count < 20:
            raise ValueError(f"{playground}: even {page['settings']} settings are larger than {BYTES} bytes")
    start = {name: control.start for name, control in playground.controls.items()}
    page["status"] = str(playground.update(stage.artists, **start) or "")
    folder.mkdir(parents=True)
    (folder / "recorded.js").write_text(script, encoding="ascii")
    (folder / "page.json").write_text(json.dumps(page, ensure_ascii=False), encoding="utf-8")
    (folder / "start.webp").write_bytes(webp(stage.pixels()[..., :3]))
    playground.update(stage.artists, **playground.values)
    stage.show_at(1.0)


def recording(playground, count, wanted):
    """What the page needs at once, and the script with all pictures for about so many settings."""
    values, together = places(playground.controls, count, wanted)
    controls, stage, packer, numbers = list(playground.controls.values()), playground._stage, Packer(), {}
    start = [stops.index(control.start) for stops, control in zip(values, controls, strict=True)]
    for setting in settings(values, start, sliders(controls), len(controls) if together else 2):
        now = [stops[place] for stops, place in zip(values, setting, strict=True)]
        now = dict(zip(playground.controls, now, strict=True))
        status = str(playground.update(stage.artists, **now) or "")
        areas, handles = grips(playground, now)
        numbers[setting] = packer.add(stage.record(), [status, *handles], areas, beside(setting, numbers))
    about, still = stage.still()
    about |= dict(settings=list(numbers))
    files = [webp(Image.open(io.BytesIO(still))), packer.packed(about), *map(webp_of, packer.images)]
    spec = playground.widget.spec
    spec = spec | {"controls": [c | {"places": v} for c, v in zip(spec["controls"], values, strict=True)]}
    page = dict(spec=spec, start=start, together=together, settings=len(numbers))
    return page, f"recorded({json.dumps([b64encode(file).decode() for file in files])});"


def grips(playground, values):
    """The handles: place and area of each as three points, zeros where it is hidden; and what else there is to say."""
    handles = [handle.spec(playground._stage.fig, values, RATIO) for handle in playground._live.handles]
    areas = [np.reshape([*handle.pop("at", [0, 0]), *handle.pop("area", [0, 0, 0, 0])], (3, 2)) for handle in handles]
    return areas, handles


def beside(setting, numbers):
    """The numbers of pictures recorded before, one place away from a setting."""
    steps = ((*setting[:i], place - 1, *setting[i + 1 :]) for i, place in enumerate(setting))
    return [numbers[step] for step in steps if step in numbers] or list(numbers.values())[-1:]


def sliders(controls):
    """Which of the controls are sliders."""
    return [i for i, control in enumerate(controls) if isinstance(control, Slider)]


def places(controls, count, wanted):
    """The values of each control for about so many settings, and whether all sliders move together."""
    named_controls, moving = list(controls.values()), len(sliders(controls.values()))
    count /= math.prod(len(control.options) for control in named_controls if not isinstance(control, Slider))
    together = moving <= 2 or count ** (1 / moving) >= COARSEST
    each = count ** (1 / max(1, moving)) if together else math.sqrt(count / math.comb(moving, 2))
    each = min(max(round(each), 3), FINEST)
    values = [
        spread(control, each, wanted.get(name, ())) if isinstance(control, Slider) else list(control.options)
        for name, control in controls.items()
    ]
    return values, together


def spread(slider, count, wanted=()):
    """About so many values of a slider: both ends, the start, those wanted, and others evenly between, on its steps."""
    scale = np.log if slider.log else np.asarray
    values = [
        slider.near(value) for value in (np.geomspace if slider.log else np.linspace)(slider.low, slider.high, count)
    ]
    kept = {slider.checked(value) for value in (slider.low, slider.high, slider.start, *wanted)}
    others = set(values) - kept
    for value in kept - set(values):
        if others:
            others.remove(min(others, key=lambda other: abs(scale(other) - scale(value))))
    return sorted(kept | others)


def settings(values, start, moving, most):
    """The places of all controls, in all combinations in which at most so many sliders are away from their start."""
    choices = []
    for together in itertools.combinations(moving, min(most, len(moving))):
        free = [i not in moving or i in together for i in range(len(values))]
        choices.append([range(len(stops)) if free[i] else (start[i],) for i, stops in enumerate(values)])
    return sorted({setting for choice in choices for setting in itertools.product(*choice)})


def webp(picture):
    """A small file of a picture, exact."""
    if isinstance(picture, np.ndarray):
        picture = Image.fromarray(picture)
    file = io.BytesIO()
    picture.convert("RGB").save(file, "webp", lossless=True, method=4, quality=80)
    return file.getvalue()


def webp_of(png):
    """A smaller file of an image that moves."""
    file = io.BytesIO()
    Image.open(io.BytesIO(png)).save(file, "webp", quality=60, method=4)
    return file.getvalue()
