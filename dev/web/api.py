"""The package name by name: pages for Sphinx's autodoc, one a room, with the lessons that use each name."""

import inspect
import json
import re
from pathlib import Path

import kflearn
from kflearn import ui

ROOMS = {
    "models": "Models and beliefs",
    "filters": "Filters and smoothers",
    "results": "Is it honest?",
    "fitting": "Parameters from data",
    "targets": "Several targets",
    "core": "Angles",
    "course": "Of the course",
    "ui": "Pictures and playgrounds",
}
EXTRA = {"ui": ["Playground", "drag", "drag_bell", "slider", "log_slider", "choice", "toggle"]}
HEAD = """# The package

Everything that `import kflearn` gives, name by name, made from the package itself (version {version}). A belief is a
`Gaussian`, a model says how a state moves and how it is measured, a filter returns a track. Arrays have the time in
their last axis but one, and everything broadcasts over the axes in front of it.

{rooms}

## The filters

All are called as `filter(model, z, initial, u)`.

| filter | models | returns | `rts_smoother` |
|---|---|---|---|
{table}
"""


def pages(lessons):
    """{file name: text} of all pages; lessons: paths of the notebooks that are linked to."""
    used, made = where_used(lessons), {}
    for room, title in ROOMS.items():
        names = public(room)
        lead = f"What `kflearn` gives for this: {', '.join(names)}."
        parts = [f"# {title}", lead, *(entry(name, used.get(name, [])) for name in names)]
        made[f"api-{room}.md"] = "\n\n".join(parts) + "\n"
    rooms = "\n".join(
        f"- [{title}](api-{room}.md): {', '.join(map(link, public(room)))}" for room, title in ROOMS.items()
    )
    table = "\n".join(map(row, kflearn.FILTERS))
    return {"api.md": HEAD.format(version=kflearn.__version__, rooms=rooms, table=table)} | made


def row(filter):
    """A line of the table of filters."""
    takes = "several" if filter.several else {"both": "linear, nonlinear"}.get(filter.models, filter.models)
    return f"| {link(filter.name)} | {takes} | `{filter.returns.__name__}` | {'yes' if filter.smoothed else 'no'} |"


def link(name):
    """A name that leads to its entry."""
    return f"{{py:obj}}`{name} <{place(name)}>`"


def place(name):
    """Where a name is found, as autodoc writes it."""
    thing = getattr(kflearn, name, None)
    if inspect.ismodule(thing):
        return thing.__name__
    return f"kflearn.ui.{name}" if thing is None else f"kflearn.{name}"


def names_of(path):
    """A sentence with the public names that a lesson's code uses, each leading to its entry; "" where it uses none."""
    known = {*kflearn.__all__, *EXTRA["ui"]} - {"FILTERS"}
    names = sorted({name for name, paths in where_used([path]).items() if paths} & known, key=str.casefold)
    return f"*Names of `kflearn` in this lesson:* {', '.join(map(link, names))}." if names else ""


def public(room):
    """The public names that a room makes, in the order of the alphabet."""
    names = [name for name in kflearn.__all__ if name != "FILTERS" and home(getattr(kflearn, name)) == room]
    return sorted(names + EXTRA.get(room, []), key=str.casefold)


def home(thing):
    """The room in which a public thing is written."""
    name = thing.__name__ if inspect.ismodule(thing) else thing.__module__
    return name.split(".")[1]


def entry(name, lessons):
    """The part of a page on one name."""
    thing = getattr(kflearn, name, None) or getattr(ui, name)
    kind = "module" if inspect.ismodule(thing) else "class" if inspect.isclass(thing) else "function"
    members = {"module": "\n   :members:\n   :exclude-members: RecordingError", "class": "\n   :members:"}.get(kind, "")
    how = f".. auto{kind}:: {place(name)}{members}"
    links = ", ".join(f"[{int(path.name[:2])}]({path.name})" for path in lessons)
    note = f"\n\nIn lessons {links}." if links else ""
    return f"## {name}\n\n```{{eval-rst}}\n{how}\n```{note}"


def where_used(lessons):
    """{name: paths of the lessons whose code imports it}."""
    found = {}
    for path in lessons:
        cells = json.loads(Path(path).read_text(encoding="utf-8"))["cells"]
        code = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")
        imported = re.findall(r"(?m)^from kflearn(?:\.ui)? import (?:\(([^)]*)\)|(.+))$", code)
        for name in {*re.findall(r"\w+", " ".join(map("".join, imported)))}:
            found.setdefault(name, []).append(path)
    return found
