"""Is the canvas in the browser the picture that matplotlib makes? For the tests, and to look at.

    python -m dev.canvas 05              the playgrounds of lesson 05: share of points that differ, worst pictures

`keep` runs where the playground lives and writes what `painted` draws in Chromium: each setting's operations and
points, and the same picture by matplotlib's Agg renderer.

A point differs visibly where its colour is further than VISIBLE from every one of the nine points around the same place
in the other picture, by the largest of the differences in red, green and blue, of 255: edges are smoothed a little
differently by the two renderers, and may lie one point beside each other.
"""

import base64
import io
import json
import sys
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image

from dev import lessons as course

SCRIPT = Path(__file__).parents[1] / "kflearn" / "ui" / "playground.js"
VISIBLE, RATIOS = 64, (1.0, 2.0)

PAINT = """async ([about, files, still]) => {
  const { paint } = await import(window.script);
  const bytes = text => Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
  const bitmap = text => createImageBitmap(new Blob([bytes(text)], { type: "image/png" }));
  const images = await Promise.all([still, ...files.slice(1)].map(bitmap));
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [images[0].width, images[0].height];
  const pen = canvas.getContext("2d");
  pen.drawImage(images[0], 0, 0);
  paint(pen, about, new Float32Array(bytes(files[0]).buffer), images.slice(1));
  for (const side of about.legends) pen.drawImage(images[0], ...side, ...side);
  return canvas.toDataURL().split(",")[1];
}"""


def settings(playground):
    """The start, and each control at each of its ends while the others are at their start."""
    yield {}
    for name, control in playground.controls.items():
        for value in control.ends():
            if value != control.start:
                yield {name: value}


def keep(playground, folder):
    """Write every setting at both ratios: what is recorded, and what Agg draws."""
    stage, start = playground._stage, {name: control.start for name, control in playground.controls.items()}
    Path(folder).mkdir(parents=True)
    for ratio in RATIOS:
        stage.show_at(ratio)
        sides, still = stage.still()
        Path(folder, f"still-{ratio:g}.png").write_bytes(still)
        for number, setting in enumerate(settings(playground)):
            playground.update(stage.artists, **start | setting)
            about, files = stage.record()
            files = [base64.b64encode(file).decode() for file in files]
            name = f"{number:02d}-{ratio:g}"
            told = dict(about=about | sides, files=files, setting=f"{setting or 'start'} at ratio {ratio:g}")
            Path(folder, f"{name}.json").write_text(json.dumps(told), encoding="utf-8")
            Image.fromarray(stage.pixels()[..., :3]).save(Path(folder, f"{name}.png"), compress_level=1)
    stage.show_at(1.0)
    playground.update(stage.artists, **playground.values)


def painted(page, folder):
    """For each setting in a folder, its words, the share of points that differ, and the two pictures."""
    for path in sorted(Path(folder).glob("*.json")):
        told = json.loads(path.read_text(encoding="utf-8"))
        still = base64.b64encode(Path(folder, f"still-{path.stem.split('-')[1]}.png").read_bytes()).decode()
        answer = page.evaluate(PAINT, [told["about"], told["files"], still])
        ours = np.asarray(Image.open(io.BytesIO(base64.b64decode(answer))).convert("RGB"))
        theirs = np.asarray(Image.open(path.with_suffix(".png")).convert("RGB"))
        yield told["setting"], different(ours, theirs).mean(), ours, theirs


def different(one, other):
    """Which points (height, width) differ visibly, seen from either picture."""
    return _missed(one, other) | _missed(other, one)


def _missed(one, other):
    nearest = np.full(one.shape[:2], 255)
    padded = np.pad(other.astype(np.int16), ((1, 1), (1, 1), (0, 0)), mode="edge")
    height, width = one.shape[:2]
    for down in range(3):
        for right in range(3):
            part = padded[down : down + height, right : right + width]
            nearest = np.minimum(nearest, abs(part - one).max(axis=-1))
    return nearest > VISIBLE


def page(chromium):
    """A page that has loaded the course's own script."""
    made = chromium.new_page()
    made.goto("about:blank")
    script = base64.b64encode(SCRIPT.read_bytes()).decode()
    made.evaluate("text => { window.script = `data:text/javascript;base64,${text}`; }", script)
    return made


def main(number):
    from dev.hard.grid import inside
    from dev.lab import browser

    (path,) = (path for path in course.lessons() if path.name[:2] == number)
    with tempfile.TemporaryDirectory() as folder:
        inside(path, "from dev import canvas", f"canvas.keep_all(globals(), {folder!r})")
        with browser() as chromium:
            blank = page(chromium)
            for place in sorted(Path(folder).glob("*")):
                for words, share, ours, theirs in painted(blank, place):
                    print(f"{100 * share:6.3f} %  {words}")
                    if "--pictures" in sys.argv:
                        both = Image.fromarray(np.concatenate([ours, theirs], axis=0))
                        both.save(f"/tmp/canvas-{number}-{place.name}-{len(words)}-{share:.4f}.png")


def keep_all(names, folder):
    """What `keep` does for each playground of a lesson."""
    from dev.hard.grid import shown

    for number, playground in enumerate(shown(names)):
        keep(playground, Path(folder, str(number)))


if __name__ == "__main__":
    main(sys.argv[1])
