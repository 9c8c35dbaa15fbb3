"""Whom a learner must trust: nobody more than Jupyter itself.

Read (sources.py): the code of lessons, package and dev has no shell, no unpickling, no text made into code; the tools
that start processes give them lists, and only they start any. Watched: the same while the lessons run. Tried:
JupyterLab as `make course` starts it, without its token; and a class of two on the class server, where one tries to get
at the other's files and at the teacher's (neighbours.py; as root, on Linux; see classroom.py).
"""

import asyncio
import inspect
import json
import os
import subprocess
import sys
import tempfile
from contextlib import contextmanager
from pathlib import Path

import nbformat
import psutil
import requests
from nbclient import NotebookClient

from dev.hard import watch
from dev.hard.classroom import wait
from dev.hard.doors import elsewhere, listeners, refused
from dev.hard.line import Line, none
from dev.hard.neighbours import try_class
from dev.hard.sources import LESSONS, ROOT, read_code, read_settings

# ---- watched


async def watched(path, turn):
    """Run a lesson, when it is its turn; what its kernel did that it has no business to do."""
    notebook = nbformat.read(path, as_version=4)
    first = inspect.getsource(watch) + f"\nseen_here = watch({str(ROOT)!r})"
    last = "import json; print(json.dumps(seen_here + listening()))"
    before, after = (nbformat.v4.new_code_cell(source) for source in (first, last))
    notebook.cells = [before, *notebook.cells, after]
    where = {"metadata": {"path": str(ROOT / "notebooks")}}
    async with turn:
        how = dict(extra_arguments=["--log-level=ERROR"], coalesce_streams=True, resources=where)
        await NotebookClient(notebook, timeout=120, kernel_name="python3", **how).async_execute()
    return [f"{path.name[:2]} {event} {detail}" for event, detail in json.loads(after.outputs[-1].text)]


async def all_watched(paths):
    """The same of some lessons, two at a time."""
    turn = asyncio.Semaphore(2)
    found = await asyncio.gather(*(watched(path, turn) for path in paths))
    return [each for one in found for each in one]


def watch_lessons(quick):
    import matplotlib.font_manager  # noqa: F401  (on a new machine it asks the system for its fonts, once)

    paths = LESSONS[4:5] if quick else LESSONS
    with tempfile.TemporaryDirectory() as folder, setting("KFLEARN_PROGRESS", f"{folder}/progress.json"):
        seen = asyncio.run(all_watched(paths))
    yield none("processes, ports to others, unpickling, eval, at work", seen, f"{len(paths)} lessons")


@contextmanager
def setting(name, value):
    """A variable of the environment, for a while."""
    before = os.environ.get(name)
    os.environ[name] = value
    try:
        yield
    finally:
        os.environ.pop(name) if before is None else os.environ.update({name: before})


# ---- JupyterLab as `make course` starts it


@contextmanager
def course():
    """The Makefile's own command, only that no browser is opened. Yields process, URL and token."""
    dry = ["make", "--dry-run", "--no-print-directory", "course", f"BIN={Path(sys.executable).parent}"]
    command = subprocess.run(dry, cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()[-1]
    with tempfile.TemporaryDirectory() as home, open(f"{home}/log", "wb") as log:
        Path(home, "jupyter_server_config.json").write_text(
            '{"ServerApp": {"open_browser": false, "allow_root": true}}', encoding="utf-8"
        )
        env = os.environ | {f"JUPYTER_{name}_DIR": home for name in ("CONFIG", "DATA", "RUNTIME")}
        started = subprocess.Popen(["sh", "-c", command.strip()], cwd=ROOT, env=env, stdout=log, stderr=log)
        process = psutil.Process(started.pid)
        try:
            wait(lambda: list(Path(home).glob("jpserver-*.json")), f"{home}/log")
            (file,) = Path(home).glob("jpserver-*.json")
            told = json.loads(file.read_text())
            wait(lambda: requests.get(f"{told['url']}api", timeout=5).ok)
            yield process, told["url"], told["token"]
        finally:
            family = [*process.children(recursive=True), process]
            for each in family:
                each.terminate()
            for each in psutil.wait_procs(family, 10)[1]:
                each.kill()
            started.wait()


def try_course():
    with course() as (process, url, token):
        kernels, word = f"{url}api/kernels", dict(token=token)
        number = requests.post(kernels, params=word, json={}, timeout=60).json()["id"]
        doors = [kernels, f"{kernels}/{number}/channels", f"{url}api/contents", f"{url}api/terminals"]
        answers = {door: requests.get(door, timeout=60).status_code for door in doors}
        answers["a new kernel"] = requests.post(kernels, json={}, timeout=60).status_code
        known = requests.get(kernels, params=word, timeout=60).status_code
        found = listeners(process)
    let_in = [f"{door} {status}" for door, status in answers.items() if not refused(status)]
    yield Line("make course: length of the token", f"{len(token)} letters", "≥ 32", len(token) >= 32)
    yield Line("make course: a request with the token", f"{known}", "200", known == 200)
    yield none("make course: requests answered without it", let_in, len(answers))
    yield none("make course: ports open to other machines", elsewhere(found), len(found))


# ---- dependencies


def check_packages():
    done = subprocess.run([sys.executable, "-m", "pip", "check"], capture_output=True, text=True)
    said = done.stdout.strip().splitlines()
    yield Line("packages that fit each other (pip check)", said[0][:32], "all", done.returncode == 0)


def audit():
    """pip-audit, in an environment of its own. Where it finds no service it ends well and has audited nothing."""
    what, names = "packages with a known weakness (pip-audit)", ("requirements.txt", "requirements-more.txt")
    with tempfile.TemporaryDirectory() as folder:
        try:
            python = f"{folder}/bin/python"
            subprocess.run([sys.executable, "-m", "venv", folder], check=True, capture_output=True)
            subprocess.run([python, "-m", "pip", "install", "pip-audit"], check=True, capture_output=True, timeout=120)
            command = [python, "-m", "pip_audit", "--no-deps", "--disable-pip", "--format=json", "--timeout=10"]
            command += [f"--requirement={ROOT / name}" for name in names]
            told = subprocess.run(command, capture_output=True, text=True, timeout=120).stdout
            packages = json.loads(told)["dependencies"]
        except (subprocess.SubprocessError, json.JSONDecodeError):
            packages = []
    audited = [package for package in packages if "vulns" in package]
    weak = [f"{package['name']} {package['vulns'][0]['id']}" for package in audited if package["vulns"]]
    if not audited:
        return Line(what, "not run: no network", "0 where it can run", True)
    return none(what, weak, f"{len(audited)} packages")


def lines(quick=False):
    yield from read_code()
    yield from read_settings()
    yield from watch_lessons(quick)
    yield from try_course()
    yield from check_packages()
    if not quick:
        yield audit()
        yield from try_class()
