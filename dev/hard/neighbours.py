"""A class of two on the class server, where one tries to get at the other's files and at the teacher's."""

import json
import os
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import psutil
import requests
import zmq

from dev.hard.classroom import Learner, classroom, obstacle
from dev.hard.doors import elsewhere, listeners, refused, waiting
from dev.hard.line import Line, none

ROOT = Path(__file__).parents[2]
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
    tool = [sys.executable, "-m", "dev.teaching.assignment", "04", "--out", str(folder / "assignment")]
    run = dict(cwd=ROOT, capture_output=True, check=True, umask=0o022)
    subprocess.run(tool, **run)
    shutil.copytree(folder / "assignment" / "release" / "lessons-04", answers)
    silent = dict(stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    grading = subprocess.Popen([*tool, "--grade", str(answers.parent)], cwd=ROOT, umask=0o022, **silent)
    heard = listen(grading)
    assert grading.returncode == 0
    shutil.rmtree(answers.parent)
    files = [folder / "assignment", *(folder / "assignment").rglob("*")]
    assert {"gradebook.db", "points-04.csv", "answers-04.csv", "source"} <= {file.name for file in files}
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


def try_files(folder, hub, ada, ben):
    """Ada looks for files: Ben's, the hub's, the teacher's."""
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


def try_doors(hub, ada, ben, outsider):
    """Ada tries addresses and ports."""
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


def try_class():
    """Ada and Ben on the class server; Ada tries everything."""
    if why := obstacle():
        yield Line("class server with two learners", f"not tried: {why}", "tried where it can be", True)
        return
    with classroom() as (folder, hub, (ada, ben), outsider):
        yield from try_files(folder, hub, ada, ben)
        yield from try_doors(hub, ada, ben, outsider)
