"""The class server: its settings, what keeps it from starting, and what learners do not meet in JupyterLab."""

import json
import os
import re
import secrets
import socket
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, HTTPServer, SimpleHTTPRequestHandler
from pathlib import Path

import pytest
import yaml
from lab import CHROMIUM, Lab, browser, notebook

ROOT = Path(__file__).parent.parent
LINUX = pytest.mark.skipif(sys.platform != "linux", reason="the class server is for Linux")


def run(*command, **environment):
    """Run a command in the environment of the tests; what it printed."""
    done = subprocess.run(
        [sys.executable, *map(str, command)],
        cwd=ROOT,
        env=os.environ | environment,
        capture_output=True,
        text=True,
        timeout=110,
    )
    assert done.returncode == 0, done.stderr + done.stdout
    return done.stdout


# ---- its settings

LOAD = """
import getpass, json, os, subprocess, sys
from traitlets.config import PyFileConfigLoader
from jupyterhub import auth, proxy, spawner
from jupyterhub.app import JupyterHub

config = PyFileConfigLoader("jupyterhub_config.py", path="class").load_config()
where = {"JupyterHub": JupyterHub}
for module in (auth, proxy, spawner):
    where |= {name: thing for name, thing in vars(module).items() if isinstance(thing, type)}
unknown = [f"{part}.{name}" for part in config for name in config[part] if name not in where[part].class_traits()]
hub = JupyterHub(config=config)
one = hub.spawner_class(config=config)
show = "import os, resource; print(resource.getrlimit(resource.RLIMIT_DATA)[0], os.umask(0))"
become = one.make_preexec_fn(getpass.getuser())
limits = subprocess.run([sys.executable, "-c", show], preexec_fn=become, capture_output=True, text=True).stdout.split()
del os.environ["CLASS_REPOSITORY"]
os.environ["CLASS_LEARNERS"] = "none"
bare = PyFileConfigLoader("jupyterhub_config.py", path="class").load_config()
found = dict(
    bare=[len(bare.Authenticator.allowed_users), bare.Authenticator.allow_all, bare.Spawner.default_url],
    unknown=unknown, bind=hub.bind_url, authenticator=hub.authenticator_class.__name__, limits=limits,
    all=config.Authenticator.allow_all, allowed=sorted(config.Authenticator.allowed_users),
    accounts=config.LocalAuthenticator.create_system_users, spawner=hub.spawner_class.__mro__[1].__name__,
    home=one.notebook_dir, memory=one.mem_limit, args=one.args, url=one.default_url, env=one.environment,
)
print(json.dumps(found))
"""


@LINUX
def test_the_configuration_of_one_machine(tmp_path):
    (tmp_path / "learners.txt").write_text("ada\nben\n\n# a remark\n", encoding="utf-8")
    settings = dict(
        CLASS_STATE=str(tmp_path / "state"),
        CLASS_LEARNERS=str(tmp_path / "learners.txt"),
        CLASS_REPOSITORY="https://example.org/course.git",
    )
    found = json.loads(run("-c", LOAD, **settings))
    assert found["unknown"] == []
    assert found["bind"].startswith("http://127.0.0.1:8000")
    assert found["authenticator"] == "PAMAuthenticator" and found["spawner"] == "LocalProcessSpawner"
    assert not found["all"] and not found["accounts"] and found["allowed"] == ["ada", "ben"]
    assert found["home"] == "~" and found["memory"] == 2**31
    assert found["limits"] == [str(2**31), str(0o077)]
    assert "--MappingKernelManager.cull_idle_timeout=1800" in found["args"]
    assert "--ServerApp.shutdown_no_activity_timeout=3600" in found["args"]
    assert "--KernelManager.transport_encryption=required" in found["args"], "at ports everybody could listen"
    assert found["url"].startswith("/git-pull?repo=https%3A%2F%2Fexample.org%2Fcourse.git&branch=main")
    assert found["url"].endswith("urlpath=lab%2Ftree%2Fkalman%2Fnotebooks%2F00-start-here.ipynb")
    for name in ("jupyter_server_config.py", "labconfig/page_config.json"):
        assert Path(found["env"]["JUPYTER_CONFIG_PATH"], name).exists()
    assert (tmp_path / "state").stat().st_mode & 0o077 == 0
    assert found["bare"] == [0, False, "/lab"], "without a list nobody may sign in"


def test_the_configuration_is_python_and_says_its_settings():
    source = (ROOT / "class" / "jupyterhub_config.py").read_text(encoding="utf-8")
    compile(source, "jupyterhub_config.py", "exec")
    head, _, code = source.partition('"""\n\nimport')
    assert set(re.findall(r"CLASS_[A-Z]+", head)) == set(re.findall(r"CLASS_[A-Z]+", code))


def test_the_chart_values():
    values = yaml.safe_load((ROOT / "class" / "values.yaml").read_text(encoding="utf-8"))
    config, user = values["hub"]["config"], values["singleuser"]
    assert config["Authenticator"]["allow_all"] is False and config["NativeAuthenticator"]["open_signup"] is False
    assert config["JupyterHub"]["authenticator_class"] != "dummy"
    assert values["proxy"]["service"]["type"] == "ClusterIP"
    assert user["memory"] == {"guarantee": "384M", "limit": "2G"}
    assert "gitpuller REPOSITORY main" in user["lifecycleHooks"]["postStart"]["exec"]["command"][-1]
    assert user["defaultUrl"].endswith("/kalman/notebooks/00-start-here.ipynb")
    assert values["cull"]["enabled"] and values["cull"]["timeout"] == 3600
    environment = user["extraEnv"]
    assert all(isinstance(value, str) for value in environment.values())


# ---- what keeps it from starting


@pytest.fixture
def obstacles(monkeypatch):
    monkeypatch.syspath_prepend(str(ROOT / "class"))
    return pytest.importorskip("obstacles")


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


@LINUX
@pytest.mark.parametrize("closed", ["home", "home/.pyenv", "home/.pyenv/bin/python3", "course/.venv"])
def test_the_closed_place_before_a_python_is_found(obstacles, place, closed):
    assert obstacles.unreachable(tree(place, closed)) == place / closed


@LINUX
def test_a_link_through_a_closed_folder_is_closed(obstacles, place):
    (place / "open").mkdir(mode=0o755)
    (place / "closed").mkdir(mode=0o700)
    (place / "closed" / "link").symlink_to("../open")
    (place / "start").symlink_to("closed/link")
    assert obstacles.unreachable(place / "start") == place / "closed"
    assert obstacles.unreachable(place / "open") is None


@LINUX
def test_a_folder_that_may_be_entered_but_not_read(obstacles, place):
    tree(place)
    (place / "home").chmod(0o711)
    assert obstacles.unreachable(place / "home" / ".pyenv") is None, "on the way entering is enough"
    assert obstacles.unreachable(place / "home") == place / "home"


@LINUX
@pytest.mark.parametrize("closed, sentence", [
    (None, ""),
    ("home", "Learners cannot run the Python of this environment, because {} is closed to other accounts."),
    ("course", "Learners cannot run the Python of this environment, because {} is closed to other accounts."),
    ("course/notes", "Learners cannot read the course, because {} is closed to other accounts."),
])  # fmt: skip
def test_a_python_in_a_closed_home_is_refused(obstacles, monkeypatch, place, closed, sentence):
    (place / "course" / "notes").mkdir(parents=True)
    monkeypatch.setattr("sys.executable", str(tree(place, closed) if closed else tree(place)))
    monkeypatch.setattr("sysconfig.get_path", lambda name: str(place))
    monkeypatch.setattr(obstacles, "COURSE", place / "course" / "notes")
    assert obstacles.cannot_run().startswith(sentence.format(closed and place / closed))
    assert bool(obstacles.cannot_run()) == bool(sentence)


@LINUX
@pytest.mark.parametrize("root", [True, False])
def test_the_hub_says_it_and_does_not_start(place, root):
    """Really started, from a copy in a closed folder as root, with plain static http as somebody else."""
    start = f"import os; os.geteuid = lambda: {0 if root else 1000}; from jupyterhub.app import main; main()"
    for name in ("jupyterhub_config.py", "obstacles.py"):
        (copy := place / "closed" / "class" / name).parent.mkdir(parents=True, exist_ok=True)
        copy.write_bytes((ROOT / "class" / name).read_bytes())
    (place / "closed").chmod(0o700)
    with web(SimpleHTTPRequestHandler, repository(place / "web")) as address:
        command = [sys.executable, "-c", start, "--config", copy.with_name("jupyterhub_config.py")]
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


@LINUX
def test_static_http_is_refused_because_it_cannot_send_the_newest_commit_alone(obstacles, tmp_path):
    with web(SimpleHTTPRequestHandler, repository(tmp_path / "web")) as address:
        said = obstacles.cannot_copy(f"{address}/course.git")
        copied = git("clone", "--depth", "1", f"{address}/course.git", tmp_path / "copy")
        missing = obstacles.cannot_copy(f"{address}/other.git")
    assert said.startswith(f"Learners cannot copy {address}/course.git, because that server only hands out files.")
    assert copied.returncode and "shallow" in copied.stderr, "this is what learners would have met"
    assert missing.startswith(f"Learners cannot copy {address}/other.git, which answers 404")


@LINUX
def test_a_git_server_is_welcome(obstacles, tmp_path):
    with web(git_server(repository(tmp_path / "web")), tmp_path) as address:
        assert obstacles.cannot_copy(f"{address}/course.git") == ""
        assert obstacles.cannot_copy(f"{address}/course.git/") == ""


@LINUX
def test_a_server_that_cannot_be_reached_is_only_warned_of(obstacles, caplog):
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        assert obstacles.cannot_copy(f"http://127.0.0.1:{free.getsockname()[1]}/course.git") == ""
    assert "cannot be reached at the moment" in caplog.text


@LINUX
def test_addresses_for_ssh_are_left_alone(obstacles):
    for address in ("git@example.org:course.git", "ssh://git@example.org/course.git", "git://example.org/course.git"):
        assert obstacles.cannot_copy(address) == ""


@LINUX
@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="asks as another account: needs root")
def test_a_folder_of_this_machine(obstacles, monkeypatch, place):
    folder = repository(place / "web") / "course.git"
    said = obstacles.cannot_copy(str(folder))
    assert said.endswith(f"Allow it once: `git config --system --add safe.directory {folder}`.")
    (settings := place / "gitconfig").write_text(f"[safe]\n\tdirectory = {folder}\n")
    settings.chmod(0o644)
    ask = subprocess.run
    system = dict(GIT_CONFIG_SYSTEM=str(settings))  # in place of /etc/gitconfig
    monkeypatch.setattr(subprocess, "run", lambda *a, env, **more: ask(*a, env=env | system, **more))
    assert obstacles.cannot_copy(str(folder)) == obstacles.cannot_copy(f"file://{folder}") == ""
    (place / "web").chmod(0o700)
    assert f"because {place / 'web'} is closed to other accounts" in obstacles.cannot_copy(f"file://{folder}")
    assert "which does not exist" in obstacles.cannot_copy(str(place / "nowhere"))
    assert "git says: fatal" in obstacles.cannot_copy("/usr")


# ---- what learners do not meet


@contextmanager
def jupyterlab(home, config):
    """JupyterLab as it comes, with one folder of settings; yields its URL with {} for the path of a page."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    token = secrets.token_hex(16)
    command = [sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root", "--ip=127.0.0.1", f"--port={port}"]
    command += [f"--IdentityProvider.token={token}", f"--ServerApp.root_dir={home}"]
    command += ["--LabApp.expose_app_in_browser=True"]
    places = ["JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR"]
    places += ["JUPYTERLAB_SETTINGS_DIR", "JUPYTERLAB_WORKSPACES_DIR"]
    env = os.environ | {name: f"{home}/{name}" for name in places} | {"JUPYTER_CONFIG_PATH": str(config)}
    with open(home / "log", "wb") as log:
        process = subprocess.Popen(command, env=env, stdout=log, stderr=log)
    try:
        for _ in range(300):
            try:
                urllib.request.urlopen(f"http://127.0.0.1:{port}/api", timeout=5).close()
                break
            except OSError:
                assert process.poll() is None, (home / "log").read_text()
                time.sleep(0.1)
        yield f"http://127.0.0.1:{port}/{{}}?token={token}"
    finally:
        process.terminate()
        process.wait(20)


@pytest.mark.browser
@pytest.mark.skipif(CHROMIUM is None, reason="no chromium, chromium-browser or google-chrome on the PATH")
@pytest.mark.parametrize("course", [True, False], ids=["with the course's settings", "without them"])
def test_no_grading_buttons_and_no_pop_up_about_news(tmp_path, course):
    pytest.importorskip("nbgrader")
    notebook(tmp_path / "a.ipynb", "1 + 1")
    with jupyterlab(tmp_path, ROOT if course else tmp_path) as url, browser() as chromium:
        page = Lab(chromium, url, "a.ipynb").page
        page.wait_for_timeout(5000)  # the pop-up takes its time
        tabs = page.locator(".jp-SideBar .lm-TabBar-tab").evaluate_all("all => all.map(tab => tab.title).join()")
        met = {
            "news": page.get_by_text("official Jupyter news").count(),
            "button": page.locator(".jp-NotebookPanel-toolbar").get_by_text("Validate").count(),
            "menu": page.locator(".lm-MenuBar-itemLabel").get_by_text("Nbgrader").count(),
            "side bar": int("Create Assignment" in tabs),
            "server": int(page.request.get(url.format("formgrader")).ok),
        }
        assert "Table of Contents" in tabs
    assert set(met.values()) == {0 if course else 1}, met
