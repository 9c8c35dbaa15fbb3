"""Recordings that are damaged, and arguments of their reading that are junk."""

import tempfile
from pathlib import Path

import numpy as np

from dev.hard.junk import Inputs, Junk, print_of
from kflearn import recordings
from kflearn.course.recordings import RecordingError

SCRAPS = [
    *",;\t\n\r\"'# \0\ufeff−½١卡\ud800[]()\u2028",
    "\r\n",
    "\n\n",
    "NaN",
    "inf",
    "1e999",
    "-1e-999",
    "1,5",
    "1.234.567",
]
SCRAPS += ["0x10", "1_000", "=1+1", "9" * 400, "2026-05-31T14:05:09+02:00", "0001-01-01", "9999-12-31"]
SCRAPS += ["2026-W10", "[ms]", "time [fortnight]", "x" * 200_000]
TABLE = '# lift\ntime [ms];"height [m]";speed (km/h)\n0;1,5;nan\n20;-2,25;3e1\n45;;4\n60;0;5\n'
DATES = "when,volt [V]\n2026-05-31T14:05:09,1\n2026-05-31T14:05:10.5,\n2026-05-31T14:06,2\n"
BOLD = ["time", "when", "height", "", None, ["speed", "height"], [], ["height", "height"], "ms", "s", "µs", 3]
GOOD = dict(
    time_format=["%d.%m.%Y", "%H%M%S", "%Y-%m-%dT%H:%M:%S", "%"],
    dayfirst=[True, False],
    zone=["Europe/Berlin", "UTC", "Nowhere"],
    where=[{"speed (km/h)": 4}, {"volt": "1"}],
    pivot=[("height", "speed"), ("when", "volt"), ("a", "a")],
    missing=[[-999], ["nan", 5], {"height": [1.5]}],
    equal=["keep", "merge", "first"],
    sort=[True],
    wraps=[60, 2**32, 1e-300],
    header=[False, 1, 2, 9],
    separator=[" ", ";", ",", "\0"],
    decimal=[",", "."],
    thousands=[".", " ", "1"],
)
ENCODINGS = ["utf-8-sig", "utf-8", "utf-16", "cp1252", "gbk", "ascii", "rot13", "hex", "idna", "undefined", "no such"]
ENCODINGS += ["", "a\0", None, 3]


def tables():
    """The texts that are damaged: the examples, shortened, and two with all that a table may hold."""
    heads = [recordings.example(name).read_text(encoding="utf-8").splitlines()[:9] for name in recordings.EXAMPLES]
    return [TABLE, DATES, *("\n".join(head) for head in heads)]


def damaged(text, rng):
    """A text with a few pieces lost, doubled, moved or put in; now and then with none."""
    for _ in range(rng.choice([0, 1, 1, 2, 4, 8])):
        i, j = sorted(rng.choices(range(len(text) + 1), k=2))
        j = rng.choice([i, i + 1, min(j, i + 9)])
        text = text[:i] + rng.choice(["", text[i:j] * 2, *rng.choices(SCRAPS, k=6)]) + text[j:]
    return text


def read_all(table, junk):
    """What a learner does with a recording, with arguments that may be junk."""
    str(table), len(table)
    table[junk.rng.choice([table.names[0], junk.thing()])]
    table.on_grid(junk.rng.choice([None, None, 0.5, junk.thing()]))


def settings_of(junk, from_file):
    """Arguments for reading: half of the time some, which may be junk."""
    odd = junk.rng.random() < 0.5
    settings = {k: option(junk) for k in ("time", "columns", "time_unit") if odd and junk.rng.random() < 0.4}
    settings |= {k: junk.rng.choice(GOOD[k]) for k in GOOD if odd and junk.rng.random() < 0.05}
    settings |= {k: junk.thing() for k in GOOD if odd and junk.rng.random() < 0.01}
    if odd and from_file:
        settings["encoding"] = junk.rng.choice([*ENCODINGS, junk.thing()])
    return settings


def read_one(text, path, settings, junk):
    """The table read from the file at a path or, where there is none, from the text; as whole as promised."""
    if path:
        table = recordings.read(path if junk.rng.random() < 0.9 else junk.thing(), **settings)
    else:
        table = recordings.parse(text if junk.rng.random() < 0.95 else junk.thing(), **settings)
    steps = np.diff(table.time)
    assert np.isfinite(table.time).all(), "time is not finite"
    assert (steps > 0).all() or (settings.get("equal") == "keep" and (steps >= 0).all()), "time runs back"
    assert not np.isinf(table.values).any() and len(table) > 1, "infinite"
    return table


def check_recordings(inputs):
    """Damaged texts and files, with arguments that may be junk too."""
    tally, junk, texts = Inputs(), Junk(2), tables()
    with tempfile.TemporaryDirectory() as folder:
        while tally.tried < inputs:
            text, path = damaged(junk.rng.choice(texts), junk.rng), None
            if tally.tried % 3 == 0:
                path = Path(folder, "own.csv")
                path.write_bytes(raw := shaken(text.encode("utf-8", "surrogatepass"), junk.rng))
            settings = settings_of(junk, path)
            before = print_of(settings)
            tally.tried += 1
            try:
                table = read_one(text, path, settings, junk)
                tally.ends["read"] += 1
                read_all(table, junk)
            except RecordingError as error:
                tally.ends["refused"] += 1
                assert str(error).strip(), "an exception without a sentence"
            except Exception as error:
                tally.faults.append(f"{type(error).__name__}: {error}"[:60])
            if print_of(settings) != before or (path and path.read_bytes() != raw):
                tally.changed.append(str(list(settings)))
    return tally


def option(junk):
    """A value for an argument of `read`."""
    return junk.rng.choice([*BOLD, junk.thing()])


def shaken(raw, rng):
    """Bytes of which a few are changed."""
    raw = bytearray(raw)
    for _ in range(rng.choice([0, 0, 1, 3]) if raw else 0):
        raw[rng.randrange(len(raw))] = rng.randrange(256)
    return bytes(raw)
