"""Whom a learner must trust: nobody more than Jupyter itself.

Read: the code of lessons, package and tools has no shell, no unpickling, no text made into code; the tools that start
processes give them lists, and only they start any. Watched: the same while the lessons run. Tried: JupyterLab as
`make course` starts it, without its token; and a class of two on the class server, where one tries to get at the
other's files and at the teacher's (as root, on Linux; see classroom.py).
"""

import ast
import asyncio
import inspect
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from pathlib import Path

import nbformat
import psutil
import requests
import zmq
from IPython.core.inputtransformer2 import TransformerManager
from nbclient import NotebookClient

from hard import watch
from hard.classroom import Learner, classroom, obstacle, wait
from hard.line import Line

ROOT = Path(__file__).parent.parent
LESSONS = sorted((ROOT / "notebooks").glob("[0-9][0-9]-*.ipynb"))
LOOPBACK = ("127.", "::1")


def none(what, found, tried):
    """A line about things of which there must be none; the first one is named."""
    first = f": {found[0]}" if found else ""
    return Line(what, f"{len(found)} of {tried}{first}", "0", not found)


# ---- read

MODULES = {"pickle", "marshal", "shelve", "dill", "joblib", "code", "runpy", "pty"}  # text or data made into code
OUTSIDE = {"subprocess", "socket", "urllib", "requests", "http", "asyncio.subprocess", "ctypes", "multiprocessing"}
NAMES = {"eval", "exec", "compile", "__import__", "get_ipython"}
ATTRIBUTES = {"os.system", "os.popen", "yaml.load", "yaml.unsafe_load", "yaml.full_load", "pandas.read_pickle"}
FAMILIES = r"os\.(exec|spawn|posix_spawn)\w*|subprocess\.get(status)?output|asyncio\.create_subprocess\w+"
OPEN = {  # what would open Jupyter to others, in whatever file
    "token": r"token\s*=\s*(''|\"\")(?!\")|\btoken=(\s|$)",
    "password": r"[Pp]assword\s*=\s*(u?''|u?\"\")(?!\")",
    "origin": r"allow_origin\w*\s*=|disable_check_xsrf\s*=|allow_unauthenticated_access\s*=\s*True",
    "address": r"0\.0\.0\.0|--ip=['\"]?(\*|::(?!1))|\ballow_remote_access\s*=\s*True",
}


def faults(source, modules=MODULES):
    """Names of what a piece of Python uses that it must not."""
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import | ast.ImportFrom):
            imported = [node.module or ""] if isinstance(node, ast.ImportFrom) else [each.name for each in node.names]
            found += [name for name in imported if name in modules or name.split(".")[0] in modules]
            if isinstance(node, ast.ImportFrom):
                whole = [f"{node.module}.{each.name}" for each in node.names]
                found += [name for name in whole if name in ATTRIBUTES or re.fullmatch(FAMILIES, name)]
        elif isinstance(node, ast.Name) and node.id in NAMES:
            found.append(node.id)
        elif isinstance(node, ast.Attribute):
            name = ast.unparse(node)
            found += [name] if name in ATTRIBUTES or re.fullmatch(FAMILIES, name) else []
        elif isinstance(node, ast.Call):
            found += unsafe(node)
    return found


def unsafe(call):
    """What is wrong with a call: numpy told to unpickle, a command as one text or given to a shell."""
    words = {word.arg: word.value for word in call.keywords}
    found = [name for name in ("allow_pickle", "shell") if name in words and ast.unparse(words[name]) != "False"]
    if (
        ast.unparse(call.func).startswith("subprocess.")
        and call.args
        and isinstance(call.args[0], ast.Constant | ast.JoinedStr)
    ):
        found.append("a command that is one text")
    return found


def code_cells(path):
    """A lesson's cells as Python: `!` and `%` have become calls of get_ipython()."""
    cells = [cell.source for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == "code"]
    return [TransformerManager().transform_cell(cell) for cell in cells]


def read_code():
    lessons = {f"{path.name} cell {i}": cell for path in LESSONS for i, cell in enumerate(code_cells(path))}
    package = {
        str(path.relative_to(ROOT)): path.read_text("utf-8") for path in sorted((ROOT / "kflearn").rglob("*.py"))
    }
    paths = [
        *ROOT.glob("*.py"),
        *(path for name in ("tools", "class", "bench", "site") for path in ROOT.glob(f"{name}/*.py")),
    ]
    tools = {str(path.relative_to(ROOT)): path.read_text("utf-8") for path in sorted(paths)}
    for what, sources, modules in (
        ("lessons: shell, process, network, unpickling, eval", lessons, MODULES | OUTSIDE),
        ("kflearn: the same", package, MODULES | OUTSIDE),
        ("tools, class server: shell, unpickling, eval", tools, MODULES),
    ):
        found = [f"{fault} in {place}" for place, source in sources.items() for fault in faults(source, modules)]
        yield none(what, found, f"{len(sources)} {'cells' if sources is lessons else 'files'}")


def read_settings():
    """Every text in which Jupyter could be told to let others in."""
    kinds = {".py", ".md", ".yaml", ".yml", ".toml", ".ipynb", ".txt", ".cfg", ".json", ""}
    folders = "class", "kflearn", "notebooks", "tools", "site", "bench", "tests", ".ci"
    paths = [*ROOT.glob("*"), *(path for name in folders for path in ROOT.glob(f"{name}/**/*"))]
    paths = [
        path for path in paths if path.is_file() and path.suffix in kinds and not path.name.startswith("test_hard_")
    ]
    found = []
    for path in paths:
        text = path.read_text("utf-8", errors="ignore")
        found += [f"{name} in {path.name}" for name, pattern in OPEN.items() if re.search(pattern, text)]
    yield none("settings that let others into Jupyter", found, f"{len(paths)} files")


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


def waiting(processes):
    """The ends (ip, port) at which processes wait for others."""
    found = []
    for each in processes:
        with suppress(psutil.NoSuchProcess):
            found += [one.laddr for one in each.net_connections() if one.status == psutil.CONN_LISTEN]
    return found


def listeners(process):
    """The addresses at which a process and those that it started wait for others."""
    return [end.ip for end in waiting([process, *process.children(recursive=True)])]


def elsewhere(addresses):
    return [address for address in addresses if not address.startswith(LOOPBACK)]


@contextmanager
def course():
    """The Makefile's own command, only that no browser is opened. Yields process, URL and token."""
    dry = ["make", "--dry-run", "--no-print-directory", "course", f"BIN={Path(sys.executable).parent}"]
    command = subprocess.run(dry, cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()[-1]
    with tempfile.TemporaryDirectory() as home, open(f"{home}/log", "wb") as log:
        Path(home, "jupyter_server_config.json").write_text(
            '{"ServerApp": {"open_browser": false, "allow_root": true}}'
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


def refused(status):
    """Not allowed, or not there for you."""
    return status in (401, 403, 404)


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


# ---- a class of two

READABLE = """
import json, os
def readable(path):
    try:
        return bool(os.listdir(path) if os.path.isdir(path) else open(path, "rb").read(1))
    except OSError:
        return False
print(json.dumps([path for path in {paths} if readable(path)]))
"""
WRITABLE = "import json, os; print(json.dumps([path for path in {paths} if os.access(path, os.W_OK)]))"


def within(learner, question, paths):
    """What the learner's kernel answers about these paths, all of which exist."""
    paths = [str(path) for path in paths]
    assert paths and all(map(os.path.lexists, paths))
    return json.loads(learner.run(question.format(paths=paths)))


def listen(process):
    """What somebody hears who listens at all ports of a process and its children until it ends: (bytes, ports)."""
    ears, heard = {}, 0
    with zmq.Context() as context:
        while process.poll() is None:
            children = psutil.Process(process.pid).children(recursive=True)
            for port in {end.port for end in waiting(children)} - set(ears):
                ears[port] = context.socket(zmq.SUB)
                ears[port].subscribe(b"")
                ears[port].connect(f"tcp://127.0.0.1:{port}")
            heard += sum(len(b"".join(ear.recv_multipart())) for ear in ears.values() if ear.poll(5))
        context.destroy(linger=0)
    return heard, len(ears)


def teachers_files(folder):
    """An assignment as a teacher with the usual umask makes and grades it: all its files, and what was heard of it."""
    answers = folder / "answers" / "ada"
    tool = [sys.executable, str(ROOT / "tools" / "assignment.py"), "04", "--out", str(folder / "assignment")]
    run = dict(capture_output=True, check=True, umask=0o022)
    subprocess.run(tool, **run)
    shutil.copytree(folder / "assignment" / "release" / "lessons-04", answers)
    silent = dict(stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    grading = subprocess.Popen([*tool, "--grade", str(answers.parent)], umask=0o022, **silent)
    heard = listen(grading)
    assert grading.returncode == 0
    shutil.rmtree(answers.parent)
    files = [folder / "assignment", *(folder / "assignment").rglob("*")]
    assert {"gradebook.db", "points.csv", "answers.csv", "source"} <= {file.name for file in files}
    return files, heard


def doors(ada, ben):
    """What stands open to Ada's token in Ben's server and in the hub: {what: status}."""
    hub, number = f"{ada.address}/hub/api", ben.kernel
    asked = [("GET", ben, path) for path in ("/api/contents", "/api/contents/answer.txt", "/files/answer.txt")]
    asked += [("GET", ben, f"/api/kernels/{number}/channels"), ("POST", ben, "/api/kernels")]
    answers = {f"{way} {path}": ada.ask(path, whose, way).status_code for way, whose, path in asked}
    for way, path in [
        ("GET", "/users"), ("GET", f"/users/{ben.name}"), ("POST", f"/users/{ben.name}/tokens"),
        ("DELETE", f"/users/{ben.name}/server"), ("POST", "/shutdown"), ("GET", "/proxy"),
    ]:  # fmt: skip
        answers[f"{way} {path}"] = requests.request(way, f"{hub}{path}", headers=ada.pass_, timeout=60).status_code
    return answers


EAR = """
import json, time, zmq
ears = [(port, zmq.Context.instance().socket(zmq.SUB)) for port in {ports}]
for port, ear in ears:
    ear.subscribe(b"")
    ear.connect(f"tcp://127.0.0.1:{{port}}")
heard, end = [], time.time() + 6
while time.time() < end:
    heard += [port for port, ear in ears if ear.poll(10) and b"the answer" in b"".join(ear.recv_multipart())]
print(json.dumps(sorted(set(heard))))
"""
MOUTH = "import time\nfor second in range(6): print('the', 'answer'); time.sleep(1)"


def overheard(ada, ben, hub):
    """Of the ports of Ben's processes, those at which Ada's kernel hears what his prints; and how many there are."""
    mine = [each for each in hub.children(recursive=True) if each.username() == ben.name]
    ports = sorted({end.port for end in waiting(mine)})
    with ThreadPoolExecutor(1) as pool:
        listening = pool.submit(ada.run, EAR.format(ports=ports))
        ben.run(MOUTH)
        return json.loads(listening.result()), len(ports)


def try_class():
    """Ada and Ben on the class server; Ada tries everything."""
    if why := obstacle():
        yield Line("class server with two learners", f"not tried: {why}", "tried where it can be", True)
        return
    with classroom() as (folder, hub, (ada, ben), outsider):
        (grades, (heard, asked)), state = teachers_files(folder), [folder / "class", *(folder / "class").rglob("*")]
        ben.ask("/api/contents/answer.txt", method="PUT", json=dict(type="file", format="text", content="42"))
        home = Path(f"/home/{ben.name}")
        files = [home, *(path for path in home.rglob("*") if not path.is_symlink())]
        mine = [each for each in hub.children(recursive=True) if each.username() == ben.name]
        secret = [f"/proc/{each.pid}/{name}" for each in mine for name in ("environ", "fd", "mem")]
        assert within(ben, READABLE, [home / "answer.txt"]), "Ben himself cannot read it"
        yield none("class: files of Ben that Ada reads", within(ada, READABLE, files), len(files))
        home.chmod(0o755)
        made = [path for path in files if path != home and not Path("/etc/skel", path.name).exists()]
        yield none("class: the same where his home stands open", within(ada, READABLE, made), len(made))
        yield none("class: Ben's processes, their tokens", within(ada, READABLE, secret), len(secret))
        yield none("class: the hub's own files", within(ada, READABLE, state), len(state))
        yield none("class: the teacher's solutions and grades", within(ada, READABLE, grades), len(grades))
        shared = [ROOT / "class", ROOT / "jupyter_server_config.py", ROOT / "kflearn", folder, folder / "learners.txt"]
        yield Line("class: what all can hear of grading", f"{heard} bytes at {asked} ports", "0", heard == 0 < asked)
        yield none("class: what runs in all servers, and Ada may change", within(ada, WRITABLE, shared), len(shared))
        came = [ada.signed_in, outsider.signed_in, Learner(ada.address, ben.name, "wrong").signed_in]
        yield Line("class: Ada, not on the list, wrong password", f"{came}", "[302, 403, 403]", came == [302, 403, 403])
        answers = doors(ada, ben)
        let_in = [f"{door} {status}" for door, status in answers.items() if not refused(status)]
        yield none("class: doors that Ada's token opens at Ben's", let_in, len(answers))
        whole = ben.ask("/api/contents/answer.txt").json().get("content")
        yield Line("class: Ben's own token opens his", f"{whole}", "42", whole == "42")
        addresses = listeners(hub)
        yield none("class: ports open to other machines", elsewhere(addresses), len(addresses))
        heard, asked = overheard(ada, ben, hub)
        yield none("class: ports at which Ada hears what Ben's kernel prints", heard, asked)


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
