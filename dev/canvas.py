"""Is the canvas in the browser the picture that matplotlib makes? For the tests, and to look at.

    python -m dev.canvas 05              the playgrounds of lesson 05: share of points that differ
    python -m dev.canvas 05 folder       and the pictures: the canvas above, matplotlib's own below

`keep` runs where the playground lives and writes what `shares` draws in Chromium: each setting's operations and points,
and the same picture by matplotlib's Agg renderer.

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

SCRIPT = Path(__file__).parents[1] / "kflearn" / "ui" / "playground.js"
VISIBLE, RATIOS = 64, (1.0, 2.0)
MOST = 0.01  # of the points of a picture may differ

PAINT = """async ([{ about, files, still, agg }, visible, wanted]) => {
  const { paint } = await import(window.script);
  const bytes = text => Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
  const bitmap = text => createImageBitmap(new Blob([bytes(text)], { type: "image/png" }));
  const [below, other, ...images] = await Promise.all([still, agg, ...files.slice(1)].map(bitmap));
  const { width, height } = below;
  const [canvas, pen] = board(width, height);
  pen.drawImage(below, 0, 0);
  paint(pen, about, new Float32Array(bytes(files[0]).buffer), images);
  for (const side of about.legends) pen.drawImage(below, ...side, ...side);
  const [, reader] = board(width, height);
  reader.drawImage(other, 0, 0);
  const [ours, theirs] = [pen, reader].map(pen => pen.getImageData(0, 0, width, height).data);
  return [differing(ours, theirs, width, height, visible), wanted ? canvas.toDataURL().split(",")[1] : ""];

  function board(width, height) {
    const canvas = Object.assign(document.createElement("canvas"), { width, height });
    return [canvas, canvas.getContext("2d", { willReadFrequently: true })];
  }
  function differing(one, two, width, height, visible) {
    const far = (a, i, b, j) => [0, 1, 2].some(k => Math.abs(a[i + k] - b[j + k]) > visible);
    const missed = (a, i, b, x, y) => {
      for (let v = Math.max(0, y - 1); v <= Math.min(height - 1, y + 1); v++)
        for (let u = Math.max(0, x - 1); u <= Math.min(width - 1, x + 1); u++)
          if (!far(a, i, b, 4 * (v * width + u))) return false;
      return true;
    };
    const [first, second] = [one, two].map(each => new Uint32Array(each.buffer));
    let count = 0;
    for (let k = 0; k < width * height; k++) {
      if (first[k] === second[k] || !far(one, 4 * k, two, 4 * k)) continue;
      const [x, y] = [k % width, Math.floor(k / width)];
      if (missed(one, 4 * k, two, x, y) || missed(two, 4 * k, one, x, y)) count += 1;
    }
    return count / (width * height);
  }
}"""


def settings(playground):
    """The start, and each control at each of its ends while the others are at their start; all buttons."""
    yield {}
    for name, control in playground.controls.items():
        for value in control.ends()[:: 2 if hasattr(control, "low") else 1]:
            if value != control.start:
                yield {name: value}


def text(file):
    return base64.b64encode(file).decode()


def pair(stage, sides, still):
    """What is recorded of a stage as it is now, and what Agg draws, for PAINT; the first two are `stage.still()`."""
    about, files = stage.record()
    agg = io.BytesIO()
    Image.fromarray(stage.pixels()[..., :3]).save(agg, "png", compress_level=1)
    return dict(about=about | sides, files=[text(file) for file in files], still=text(still), agg=text(agg.getvalue()))


def keep(playground, folder):
    """Write every setting at both ratios: what is recorded, and what Agg draws."""
    stage, start = playground._stage, {name: control.start for name, control in playground.controls.items()}
    folder.mkdir(parents=True)
    for ratio in RATIOS:
        stage.show_at(ratio)
        still = stage.still()
        for number, setting in enumerate(settings(playground)):
            playground.update(stage.artists, **start | setting)
            told = pair(stage, *still) | dict(setting=f"{setting or 'start'} at ratio {ratio:g}")
            Path(folder, f"{number:02d}-{ratio:g}.json").write_text(json.dumps(told), encoding="utf-8")
    stage.show_at(1.0)
    playground.update(stage.artists, **playground.values)


def keep_all(playgrounds, folder):
    """What `keep` does for each playground of a lesson, in a folder that holds nothing yet."""
    for number, playground in enumerate(playgrounds):
        keep(playground, Path(folder, str(number)))


def share(page, told):
    """The share of the points that differ visibly in one pair."""
    return page.evaluate(PAINT, [told, VISIBLE, False])[0]


def shares(page, folder):
    """For each setting of a lesson, its words and the share of points that differ."""
    for path in sorted(Path(folder).rglob("*.json")):
        told = json.loads(path.read_text(encoding="utf-8"))
        yield f"playground {path.parent.name}, {told.pop('setting')}", share(page, told)


def pictures(page, folder, target):
    """Write both pictures of each setting, one above the other."""
    for path in sorted(Path(folder).rglob("*.json")):
        told = json.loads(path.read_text(encoding="utf-8"))
        both = page.evaluate(PAINT, [told, VISIBLE, True])[1], told["agg"]
        arrays = [np.asarray(Image.open(io.BytesIO(base64.b64decode(each))).convert("RGB")) for each in both]
        Image.fromarray(np.concatenate(arrays)).save(Path(target, f"{path.parent.name}-{path.stem}.png"))


def page(chromium):
    """A page that has loaded the course's own script."""
    made = chromium.new_page()
    made.goto("about:blank")
    made.evaluate("text => { window.script = `data:text/javascript;base64,${text}`; }", text(SCRIPT.read_bytes()))
    return made


def main(number, target=None):
    from dev import lessons as course
    from dev.hard.grid import inside
    from dev.lab import browser

    (path,) = (path for path in course.lessons() if path.name[:2] == number)
    with tempfile.TemporaryDirectory() as folder:
        begin = "from dev import canvas as _canvas\nfrom dev.hard import grid as _grid"
        inside(path, begin, f"_canvas.keep_all(_grid.shown(globals()), {folder!r})")
        with browser() as chromium:
            blank = page(chromium)
            for words, differ in shares(blank, folder):
                print(f"{100 * differ:6.3f} %  {words}")
            if target:
                pictures(blank, folder, target)


if __name__ == "__main__":
    main(*sys.argv[1:])
