"""What keeps a class server from starting: each obstacle gets a sentence, and nothing else does."""

import os
import socket
import subprocess
import sys
import tempfile
import threading
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, HTTPServer, SimpleHTTPRequestHandler
from pathlib import Path

import pytest

from tests.dev.command import ROOT

if sys.platform != "linux":
    pytest.skip("the class server is for Linux", allow_module_level=True)
from dev.teaching import obstacles

# ---- places that are closed


@pytest.fixture
def place():
    """A folder that every account may enter; those of pytest are closed."""
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        yield Path(folder)


def tree(place, closed=None):
    """A Python in a home, an environment whose python is a link to it, and the course beside them."""
    python = place / "home" / ".pyenv" / "bin" / "python3"
    (link := place / "course" / ".venv" / "bin" / "python").parent.mkdir(parents=True)
    python.parent.mkdir(parents=True)
    python.write_text("")
    python.chmod(0o755)
    link.symlink_to(python)
    for folder in (path for path in place.rglob("*") if path.is_dir()):
        folder.chmod(0o755)
    if closed:
        (place / closed).chmod(0o700)
    return link


@pytest.mark.parametrize("closed", ["home", "home/.pyenv", "home/.pyenv/bin/python3", "course/.venv"])
def test_the_closed_place_before_a_python_is_found(place, closed):
    assert obstacles.unreachable(tree(place, closed)) == place / closed


def test_a_link_through_a_closed_folder_is_closed(place):
    (place / "open").mkdir(mode=0o755)
    (place / "closed").mkdir(mode=0o700)
    (place / "closed" / "link").symlink_to("../open")
    (place / "start").symlink_to("closed/link")
    assert obstacles.unreachable(place / "start") == place / "closed"
    assert obstacles.unreachable(place / "open") is None


def test_a_folder_that_may_be_entered_but_not_read(place):
    tree(place)
    (place / "home").chmod(0o711)
    assert obstacles.unreachable(place / "home" / ".pyenv") is None, "on the way entering is enough"
    assert obstacles.unreachable(place / "home") == place / "home"


@pytest.mark.parametrize("closed, sentence", [
    (None, ""),
    ("home", "Learners cannot run the Python of this environment, because {} is closed to other accounts."),
    ("course", "Learners cannot run the Python of this environment, because {} is closed to other accounts."),
    ("course/notes", "Learners cannot read the course, because {} is closed to other accounts."),
])  # fmt: skip
def test_a_python_in_a_closed_home_is_refused(monkeypatch, place, closed, sentence):
    (place / "course" / "notes").mkdir(parents=True)
    monkeypatch.setattr("sys.executable", str(tree(place, closed) if closed else tree(place)))
    monkeypatch.setattr("sysconfig.get_path", lambda name: str(place))
    monkeypatch.setattr(obstacles, "COURSE", place / "course" / "notes")
    assert obstacles.cannot_run().startswith(sentence.format(closed and place / closed))
    assert bool(obstacles.cannot_run()) == bool(sentence)


@pytest.mark.parametrize("root", [True, False])
def test_the_hub_says_it_and_does_not_start(place, root):
    """Really started, from a copy in a closed folder as root, with plain static http as somebody else."""
    start = f"import os; os.geteuid = lambda: {0 if root else 1000}; from jupyterhub.app import main; main()"
    for name in ("dev/teaching/obstacles.py", "class/jupyterhub_config.py"):
        (copy := place / "closed" / name).parent.mkdir(parents=True, exist_ok=True)
        copy.write_bytes((ROOT / name).read_bytes())
    (place / "closed").chmod(0o700)
    with web(SimpleHTTPRequestHandler, repository(place / "web")) as address:
        command = [sys.executable, "-c", start, "--config", copy]
        settings = dict(CLASS_REPOSITORY=f"{address}/course.git", CLASS_STATE=str(place / "state"))
        done = subprocess.run(command, env=os.environ | settings, cwd=place, capture_output=True, text=True, timeout=60)
    assert done.returncode == 1
    (line,) = done.stderr.strip().splitlines()
    assert line.startswith("The class server was not started. Learners cannot ")
    assert ("is closed to other accounts" if root else "only hands out files") in line
    assert not (place / "state").exists()


# ---- where the notebooks come from


def git(*command, **more):
    return subprocess.run(["git", *map(str, command)], capture_output=True, text=True, **more)


def repository(folder):
    """A folder with course.git in it, a repository with one commit, ready for static http as well."""
    folder.mkdir()
    git("init", "--bare", "--initial-branch=main", folder / "course.git", check=True)
    empty = git("hash-object", "-t", "tree", "-w", "--stdin", cwd=folder / "course.git", input="", check=True)
    name = ["-c", "user.name=Ada", "-c", "user.email=ada@example.org"]
    commit = git(*name, "commit-tree", empty.stdout.strip(), "-m", "a", cwd=folder / "course.git", check=True)
    git("update-ref", "refs/heads/main", commit.stdout.strip(), cwd=folder / "course.git", check=True)
    git("update-server-info", cwd=folder / "course.git", check=True)
    return folder


@contextmanager
def web(handler, folder):
    """A web server for a folder; yields its address."""

    class Quiet(handler):
        def __init__(self, *args):
            more = dict(directory=str(folder)) if handler is SimpleHTTPRequestHandler else {}
            super().__init__(*args, **more)

        def log_message(self, *args):
            pass

    with HTTPServer(("127.0.0.1", 0), Quiet) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        try:
            yield f"http://127.0.0.1:{server.server_port}"
        finally:
            server.shutdown()


def git_server(folder):
    """The first answer of a real git server, as git's own program for web servers gives it."""

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self):
            path, _, query = self.path.partition("?")
            asked = dict(GIT_PROJECT_ROOT=str(folder), GIT_HTTP_EXPORT_ALL="1", REQUEST_METHOD="GET")
            answer = subprocess.run(
                ["git", "-c", "safe.directory=*", "http-backend"],
                env=os.environ | asked | dict(PATH_INFO=path, QUERY_STRING=query),
                capture_output=True,
            )
            self.wfile.write(b"HTTP/1.0 200 OK\r\n" + answer.stdout)

    return Handler


def test_static_http_is_refused_because_it_cannot_send_the_newest_commit_alone(tmp_path):
    with web(SimpleHTTPRequestHandler, repository(tmp_path / "web")) as address:
        said = obstacles.cannot_copy(f"{address}/course.git")
        copied = git("clone", "--depth", "1", f"{address}/course.git", tmp_path / "copy")
        missing = obstacles.cannot_copy(f"{address}/other.git")
    assert said.startswith(f"Learners cannot copy {address}/course.git, because that server only hands out files.")
    assert copied.returncode and "shallow" in copied.stderr, "this is what learners would have met"
    assert missing.startswith(f"Learners cannot copy {address}/other.git, which answers 404")


def test_a_git_server_is_welcome(tmp_path):
    with web(git_server(repository(tmp_path / "web")), tmp_path) as address:
        assert obstacles.cannot_copy(f"{address}/course.git") == ""
        assert obstacles.cannot_copy(f"{address}/course.git/") == ""


def test_a_server_that_cannot_be_reached_is_only_warned_of(caplog):
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        assert obstacles.cannot_copy(f"http://127.0.0.1:{free.getsockname()[1]}/course.git") == ""
    assert "cannot be reached at the moment" in caplog.text


def test_names_of_which_no_account_can_be_made(monkeypatch):
    monkeypatch.setattr(obstacles, "has_account", "dr.known".__eq__)
    monkeypatch.setattr(obstacles, "cannot_run", str)
    assert obstacles.cannot_be_made(["ada", "Grace", "e-va_2", "dr.known", "a" * 32]) == ""
    said = obstacles.cannot_be_made(["ada", "kim.lee", "Ada Byron", "zoë", "7up", "grace,linus", "a" * 33])
    assert said.startswith(f"No account can be made for: 7up, {'a' * 33}, ada byron, grace,linus, kim.lee, zoë. ")
    assert obstacles.obstacle("", names=["kim.lee"]) and not obstacles.obstacle("", names=[])


def test_a_list_from_another_system_is_read(tmp_path):
    (tmp_path / "learners.txt").write_bytes("\ufeffada\r\n  # a remark\r\n\r\n ben \r\n".encode())
    assert obstacles.listed(tmp_path / "learners.txt") == ["ada", "ben"]
    assert obstacles.listed(tmp_path / "nowhere.txt") == []


def test_addresses_for_ssh_are_left_alone():
    for address in ("git@example.org:course.git", "ssh://git@example.org/course.git", "git://example.org/course.git"):
        assert obstacles.cannot_copy(address) == ""


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="asks as another account: needs root")
def test_a_folder_of_this_machine(monkeypatch, place):
    folder = repository(place / "web") / "course.git"
    said = obstacles.cannot_copy(str(folder))
    if not obstacles.ask_as_nobody(str(folder)):
        assert said == ""
        pytest.skip("this git lets every account copy the folder")
    assert said.endswith(f"Allow it once: `git config --system --add safe.directory {folder}`.")
    (settings := place / "gitconfig").write_text(f"[safe]\n\tdirectory = {folder}\n")
    settings.chmod(0o644)
    ask = subprocess.run
    system = dict(GIT_CONFIG_SYSTEM=str(settings))  # in place of /etc/gitconfig
    monkeypatch.setattr(subprocess, "run", lambda *a, env, **more: ask(*a, env=env | system, **more))
    assert obstacles.cannot_copy(str(folder)) == obstacles.cannot_copy(f"file://{folder}") == ""
    assert obstacles.cannot_copy(str(folder), "other").startswith(f"{folder} has no branch other.")
    (place / "web").chmod(0o700)
    assert f"because {place / 'web'} is closed to other accounts" in obstacles.cannot_copy(f"file://{folder}")
    assert "which does not exist" in obstacles.cannot_copy(str(place / "nowhere"))
    assert "git says: fatal" in obstacles.cannot_copy("/usr")
