"""The class server: its settings, and what learners do not meet in JupyterLab."""

import json
import re
import sys
from pathlib import Path

import pytest
import yaml

from dev.lab import CHROMIUM, Lab, browser, notebook, server
from tests.dev.command import ROOT, run

LINUX = pytest.mark.skipif(sys.platform != "linux", reason="the class server is for Linux")


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
    unknown=unknown, bind=hub.bind_url, authenticator=hub.authenticator_class.__mro__[1].__name__, limits=limits,
    all=config.Authenticator.allow_all, allowed=sorted(config.Authenticator.allowed_users),
    accounts=config.LocalAuthenticator.create_system_users, spawner=hub.spawner_class.__mro__[1].__name__,
    account=config.LocalAuthenticator.add_user_cmd,
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
    assert found["account"][-3:] == ["--gecos", "", "--disabled-password"], "no quotation marks as a full name"
    assert found["home"] == "~" and found["memory"] == 2**31
    assert found["limits"] == [str(2**31), str(0o077)]
    assert "--MappingKernelManager.cull_idle_timeout=1800" in found["args"]
    assert "--ServerApp.shutdown_no_activity_timeout=3600" in found["args"]
    assert "--KernelManager.transport_encryption=required" in found["args"], "at ports everybody could listen"
    assert found["url"].startswith("/git-pull?repo=https%3A%2F%2Fexample.org%2Fcourse.git&branch=main")
    assert found["url"].endswith("urlpath=lab%2Ftree%2Fkalman%2Fnotebooks%2F00-start-here.ipynb")
    for name in ("jupyter_server_config.py", "labconfig/page_config.json", "labconfig/default_setting_overrides.json"):
        assert Path(found["env"]["JUPYTER_CONFIG_PATH"], name).exists()
    assert (tmp_path / "state").stat().st_mode & 0o077 == 0
    assert found["bare"] == [0, False, "/lab"], "without a list nobody may sign in"


SIGN_IN = """
import asyncio, sys
from traitlets.config import PyFileConfigLoader
from jupyterhub import orm
from jupyterhub.app import JupyterHub

async def start():
    hub = JupyterHub(config=PyFileConfigLoader("jupyterhub_config.py", path="class").load_config())
    hub.init_db()
    who = hub.authenticator = hub.authenticator_class(parent=hub, db=hub.db)
    await hub.init_role_creation()
    await hub.init_users()
    for name in sys.argv[1:]:
        may = await who.refresh_user(orm.User.find(hub.db, name)) if orm.User.find(hub.db, name) else None
        is_teacher = who.is_admin(None, {"name": name})
        assert bool(may) == who.check_allowed(name) and (not may or may["admin"] == is_teacher)
        print(name, "teacher" if is_teacher else "learner" if may else "out")

asyncio.run(start())
"""


@LINUX
def test_the_lists_say_who_may_sign_in_whatever_the_hub_remembers(tmp_path):
    """The hub starts again and again with the same database. Its people have accounts on every Linux."""
    learners, people = tmp_path / "learners.txt", ["daemon", "nobody", "root"]
    settings = dict(CLASS_STATE=str(tmp_path / "state"), CLASS_LEARNERS=str(learners), CLASS_REPOSITORY="")
    for listed, teachers, expected in [
        (None, "nobody", ["out", "teacher", "out"]),
        ("daemon\nroot\n", "nobody", ["learner", "teacher", "learner"]),
        ("root\n", "nobody", ["out", "teacher", "learner"]),
        ("nobody\n", "daemon", ["teacher", "learner", "out"]),
        ("", "", ["out", "out", "out"]),
    ]:
        if listed is not None:
            learners.write_text(listed, encoding="utf-8")
        printed = run("-c", SIGN_IN, *people, **settings, CLASS_TEACHERS=teachers)
        assert printed.split() == [word for pair in zip(people, expected, strict=True) for word in pair]


def test_the_configuration_is_python_and_says_its_settings():
    source = (ROOT / "class" / "jupyterhub_config.py").read_text(encoding="utf-8")
    compile(source, "jupyterhub_config.py", "exec")
    head, _, code = source.partition('"""\n\nimport')
    assert set(re.findall(r"CLASS_[A-Z]+", head)) == set(re.findall(r"CLASS_[A-Z]+", code))


def test_the_list_of_learners_is_not_committed():
    """Whoever copies the course would get the names of the class."""
    assert "class/learners.txt" in (ROOT / ".gitignore").read_text(encoding="utf-8").splitlines()


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


# ---- what learners do not meet


@pytest.mark.browser
@pytest.mark.skipif(CHROMIUM is None, reason="no chromium, chromium-browser or google-chrome on the PATH")
@pytest.mark.parametrize("course", [True, False], ids=["with the course's settings", "without them"])
def test_no_grading_buttons_and_no_pop_up_about_news(tmp_path, course):
    pytest.importorskip("nbgrader")
    notebook(tmp_path / "a.ipynb", "1 + 1")
    with server(tmp_path, ROOT if course else None, quiet=False) as url, browser() as chromium:
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


@pytest.mark.browser
@pytest.mark.skipif(CHROMIUM is None, reason="no chromium, chromium-browser or google-chrome on the PATH")
def test_a_double_click_shows_a_text_as_it_is_meant_to_be_read(tmp_path):
    notebook(tmp_path / "a.ipynb", "1 + 1")
    (tmp_path / "appendix.md").write_text("# Cheat sheet\n\n$x^2$\n", encoding="utf-8")
    with server(tmp_path) as url, browser() as chromium:
        page = Lab(chromium, url, "a.ipynb").page
        page.get_by_role("tab", name="File Browser").click()
        page.locator(".jp-DirListing-item", has_text="appendix.md").dblclick()
        page.locator(".jp-MarkdownViewer h1", has_text="Cheat sheet").wait_for(timeout=30_000)
