"""The checks of dev/hard/security.py work, and can fail."""

import asyncio
import subprocess
import sys

import nbformat
import pytest

from dev.hard import doors, neighbours, security, sources

BAD = [
    "import pickle",
    "from subprocess import run",
    "import os\nos.system('ls')",
    "eval(text)",
    "np.load(file, allow_pickle=True)",
    "yaml.load(file)",
    "subprocess.run('ls')",
    "subprocess.run(command, shell=True)",
    "get_ipython().system('ls')",
]


@pytest.mark.parametrize("source", BAD)
def test_bad_code_is_found(source):
    assert sources.faults(source, sources.MODULES | sources.OUTSIDE)


def test_good_code_is_not():
    assert not sources.faults("re.compile('a'); model.eval(3); np.load(f, allow_pickle=False); subprocess.run(['ls'])")


@pytest.mark.parametrize("text", ["--ServerApp.token=''", 'c.X.allow_origin = "*"', "--ip=0.0.0.0", "password = ''"])
def test_an_open_setting_is_found(text, tmp_path, monkeypatch):
    (tmp_path / "README.md").write_text("c.IdentityProvider.token = secrets.token_hex()")
    monkeypatch.setattr(sources, "ROOT", tmp_path)
    assert [line.ok for line in sources.read_settings()] == [True]
    (tmp_path / "README.md").write_text(text)
    assert [line.ok for line in sources.read_settings()] == [False]


@pytest.mark.timeout(120)
def test_a_lesson_that_misbehaves_is_seen(tmp_path):
    cells = [
        "import subprocess, pickle, socket",
        "subprocess.run(['true'])",
        "pickle.loads(pickle.dumps(socket.AF_INET))",
        "eval('1 + 1')",
        "waits = socket.create_server(('0.0.0.0', 0))",
    ]
    path = tmp_path / "99-bad.ipynb"
    nbformat.write(nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in cells]), path)
    assert sources.code_cells(path)[0].strip() == cells[0]
    seen = " ".join(asyncio.run(security.all_watched([path])))
    for event in ("subprocess.Popen", "pickle.find_class", "exec", "socket.bind 0.0.0.0", "listens 0.0.0.0"):
        assert f"99 {event}" in seen


def test_an_answer_to_a_stranger_is_told():
    assert doors.refused(403) and not doors.refused(200) and not doors.refused(302)
    assert doors.elsewhere(["127.0.0.1", "::1", "0.0.0.0", "::"]) == ["0.0.0.0", "::"]


@pytest.mark.timeout(300)
def test_the_part_runs():
    found = list(security.lines(quick=True))
    assert len(found) == 10 and all(line.ok for line in found)


TALK = """
import time, zmq
mouth = zmq.Context.instance().socket(zmq.PUB)
mouth.bind_to_random_port("tcp://127.0.0.1")
for second in range(40):
    mouth.send(b"0.5 points")
    time.sleep(0.05)
"""


def test_who_talks_in_the_open_is_heard():
    start = f"import subprocess, sys; subprocess.run([sys.executable, '-c', {TALK!r}])"
    heard, ports = neighbours.listen(subprocess.Popen([sys.executable, "-c", start]))
    assert heard >= len("0.5 points")
    assert ports == 1
