"""Run one lesson inside a 32-bit Python in WebAssembly. It is started there by wasm.py, with a lesson's name, or with
"examples": then the examples in the package's docstrings run.

All code cells run; every playground is tried at the ends and in the middle of its controls, with a picture each; every
exercise gets its solution. The last line that it prints says in JSON how many of each, and which cells printed
something else than in the notebook.
"""

import ast
import doctest
import importlib
import io
import json
import pkgutil
import sys
import time
import types
from contextlib import redirect_stdout
from pathlib import Path

EXERCISES = "kflearn.exercises."


def stand_ins():
    """Modules that IPython imports and this system has not; it uses nothing in them here."""
    for name in ("termios", "fcntl", "pexpect", "resource", "psutil"):
        try:
            __import__(name)
        except ImportError:
            sys.modules[name] = types.ModuleType(name)


def shell():
    """IPython's shell without a terminal. What is shown is made as for a notebook, pictures too, and then dropped."""
    from IPython.core.interactiveshell import InteractiveShell

    InteractiveShell.instance().display_pub.publish = lambda *_, **__: None


def run(source, names):
    """Run a cell as a notebook does: the value of its last expression is shown."""
    from IPython.display import display

    body = ast.parse(source).body
    last = body.pop() if body and isinstance(body[-1], ast.Expr) and not source.rstrip().endswith(";") else None
    exec(compile(ast.Module(body, []), "<cell>", "exec"), names)
    value = None if last is None else eval(compile(ast.Expression(last.value), "<cell>", "eval"), names)
    if value is not None:
        display(value)


def printed(cell):
    """What a cell has printed, as the notebook keeps it."""
    streams = [output["text"] for output in cell["outputs"] if output["output_type"] == "stream"]
    return "".join("".join(text) for text in streams)


def lesson(path):
    """Run all cells; returns the names that they have made, and which cells printed something else than before."""
    cells = [cell for cell in json.loads(path.read_text(encoding="utf-8"))["cells"] if cell["cell_type"] == "code"]
    names, other = {"__name__": "__main__"}, []
    for cell in cells:
        out = io.StringIO()
        with redirect_stdout(out):
            run("".join(cell["source"]), names)
        if printed(cell) and out.getvalue() != printed(cell):
            other.append(cell["id"])
            print(f"{path.name}, {cell['id']} printed\n{out.getvalue()}in place of\n{printed(cell)}", file=sys.stderr)
    return names, other, len(cells)


def solved(names):
    """Check the solutions of the lesson's exercises, as they are shown; returns how many."""
    from kflearn.exercises.engine import exercises_of

    found = [exercises_of(value) for value in names.values() if getattr(value, "__name__", "").startswith(EXERCISES)]
    found = [each for module in found for each in module]
    for each in found:
        *code, check = each.solution().text.splitlines()
        mine = dict(names)
        exec("\n".join(code), mine)
        outcome = eval(check, mine)
        assert outcome.status == "right", f"{each.name}: {outcome}"
    return len(found)


def examples():
    """Run the examples of all modules of the package."""
    import kflearn

    modules = [importlib.import_module(each.name) for each in pkgutil.walk_packages(kflearn.__path__, "kflearn.")]
    results = [doctest.testmod(module) for module in modules]
    failed = sum(result.failed for result in results)
    assert not failed, f"{failed} examples failed"
    return {"modules": len(modules), "examples": sum(result.attempted for result in results)}


def try_lesson(name):
    """Run a lesson's cells, sweep its playgrounds, check its solutions; returns how many there were."""
    from kflearn.ui import Playground

    names, other, cells = lesson(Path("/notebooks", name))
    found = [value for value in names.values() if isinstance(value, Playground)]
    settings = sum(playground.sweep() for playground in found)
    return {"cells": cells, "pictures": settings, "playgrounds": len(found), "solutions": solved(names), "other": other}


def main(name):
    stand_ins()
    shell()
    import matplotlib

    matplotlib.use("agg")
    start = time.monotonic()
    told = examples() if name == "examples" else try_lesson(name)
    print(json.dumps(told | {"bits": 32 if sys.maxsize < 2**32 else 64, "seconds": round(time.monotonic() - start)}))


if __name__ == "__main__":
    main(sys.argv[1])
