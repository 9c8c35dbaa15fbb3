"""A class of two on this machine, for a minute or two: the class server of class/README.md, started for real.

It needs root: three Unix accounts are made, named kfhard-…, and removed at the end with all that is theirs. The
hub's proxy is a package of Node; it is installed into build/proxy the first time.

with classroom() as (folder, hub, (ada, ben), outsider):
    print(ada.run("print(1 + 1)"))      in her own kernel
"""

import json
import os
import secrets
import shutil
import subprocess
import sys
import tempfile
import time
import uuid
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

import psutil
import requests
import websocket

from dev.lab import free_port

ROOT = Path(__file__).parents[2]
PROXY = ROOT / "build" / "proxy"
PATIENCE = 120  # seconds for anything


def obstacle():
    """Why a class cannot be held here, in a few words; an empty string where it can."""
    if sys.platform != "linux" or os.geteuid():
        return "needs Linux and root"
    if not proxy():
        return "no configurable-http-proxy"
    if not python():
        return "learners cannot run this Python"
    return ""


def proxy():
    """The folder with the hub's proxy, installed if need be; None if there is none."""
    beside = os.pathsep.join([os.environ["PATH"], str(PROXY / "node_modules" / ".bin")])
    if not shutil.which("configurable-http-proxy", path=beside) and shutil.which("npm"):
        PROXY.mkdir(parents=True, exist_ok=True)
        with suppress(subprocess.TimeoutExpired):
            command = ["npm", "install", "--silent", "--prefix", str(PROXY), "configurable-http-proxy"]
            subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=PATIENCE)
    found = shutil.which("configurable-http-proxy", path=beside)
    return found and str(Path(found).parent)


def python():
    """A Python of our version that accounts other than ours may run, with our packages; None if there is none."""
    name = f"python{sys.version_info.major}.{sys.version_info.minor}"
    places = Path(sys.base_prefix, "bin"), Path("/usr/local/bin"), Path("/usr/bin")
    for found in (place / name for place in places):
        with suppress(OSError, subprocess.SubprocessError):
            command = [str(found), "-c", f"import os; os.listdir({str(ROOT)!r}); os.listdir({packages()!r})"]
            subprocess.run(command, user="nobody", group="nogroup", extra_groups=[], cwd="/", check=True)
            return found
    return None


def packages():
    return str(Path(requests.__file__).parent.parent)


def environment(folder):
    """An environment with our packages, and a Python that the learners may run."""
    subprocess.run([str(python()), "-m", "venv", "--without-pip", str(folder)], check=True)
    (site,) = folder.glob("lib/python*/site-packages")
    (site / "course.pth").write_text(f"import site; site.addsitedir({packages()!r})\n")
    script = folder / "bin" / "jupyterhub-singleuser"
    script.write_text(f"#!{folder}/bin/python\nfrom jupyterhub.singleuser import main\nmain()\n")
    script.chmod(0o755)
    for name in ("etc", "share"):  # JupyterLab's own pages
        (folder / name).symlink_to(Path(sys.prefix, name))
    return folder / "bin" / "python"


@contextmanager
def hub(folder, names):
    """The class server; yields its process and address."""
    (folder / "learners.txt").write_text("\n".join(names))
    address, ports = f"http://127.0.0.1:{free_port()}", [free_port(), free_port()]
    settings = dict(CLASS_BIND=address, CLASS_LEARNERS=str(folder / "learners.txt"), CLASS_ACCOUNTS="create")
    settings |= dict(CLASS_STATE=str(folder / "class"), PATH=os.pathsep.join([proxy(), os.environ["PATH"]]))
    command = [str(environment(folder / "env")), "-m", "jupyterhub", "--config", "class/jupyterhub_config.py"]
    command += [f"--JupyterHub.hub_port={ports[0]}"]
    command += [f"--ConfigurableHTTPProxy.api_url=http://127.0.0.1:{ports[1]}"]
    with open(folder / "hub.log", "wb") as log:
        process = subprocess.Popen(command, cwd=ROOT, env=os.environ | settings, stdout=log, stderr=log)
    try:
        wait(lambda: requests.get(f"{address}/hub/api", timeout=5).ok, folder / "hub.log")
        yield psutil.Process(process.pid), address
    finally:
        process.terminate()  # ends proxy and servers too
        with suppress(subprocess.TimeoutExpired):
            process.wait(30)
        process.kill()
        process.wait()


def wait(ready, log=None):
    """Until ready() is true."""
    for _ in range(PATIENCE):
        with suppress(requests.ConnectionError):
            if ready():
                return
        time.sleep(1)
    raise TimeoutError(Path(log).read_text(encoding="utf-8")[-2000:] if log else "nothing came")


def remove(name):
    """End what is left of an account's processes, and remove it with its home."""
    for process in psutil.process_iter(["username"]):
        if process.info["username"] == name:
            with suppress(psutil.NoSuchProcess):
                process.kill()
    if subprocess.run(["id", name], capture_output=True).returncode == 0:
        subprocess.run(["userdel", "--remove", name], capture_output=True, check=True)


class Learner:
    """Somebody with an account, signed in, whose server and kernel run."""

    def __init__(self, address, name, password):
        self.address, self.name, self.session = address, name, requests.Session()
        self.signed_in = self.sign_in(password)

    def sign_in(self, password):
        """As the page does it; the status that the hub answers with."""
        self.session.get(f"{self.address}/hub/login", timeout=30)
        form = dict(username=self.name, password=password, _xsrf=self.session.cookies.get("_xsrf", path="/hub/"))
        return self.session.post(f"{self.address}/hub/login", data=form, timeout=60, allow_redirects=False).status_code

    def start(self):
        """Fetch a token of the learner's own, with it start server and kernel."""
        hub, xsrf = f"{self.address}/hub/api/users/{self.name}", self.session.cookies.get("_xsrf", path="/hub/")
        made = self.session.post(f"{hub}/tokens", headers={"X-XSRFToken": xsrf}, json={}, timeout=30)
        self.pass_ = {"Authorization": f"token {made.json()['token']}"}
        requests.post(f"{hub}/server", headers=self.pass_, timeout=PATIENCE)
        wait(lambda: self.ask("/api/status").status_code == 200)
        self.kernel = self.ask("/api/kernels", method="POST", json={}).json()["id"]
        return self

    def ask(self, path, whose=None, method="GET", **more):
        """A request with the learner's token to a server: the own one, or that of somebody else."""
        url = f"{self.address}/user/{(whose or self).name}{path}"
        return requests.request(method, url, headers=self.pass_, timeout=PATIENCE, allow_redirects=False, **more)

    def run(self, code):
        """Run code in the learner's kernel; what it printed."""
        url = f"{self.address}/user/{self.name}/api/kernels/{self.kernel}/channels".replace("http", "ws", 1)
        channel = websocket.create_connection(url, header=self.pass_, timeout=PATIENCE)
        number, printed = uuid.uuid4().hex, []
        header = dict(msg_id=number, username=self.name, session=number, msg_type="execute_request", version="5.3")
        content = dict(code=code, silent=False, store_history=False, user_expressions={}, allow_stdin=False)
        message = dict(header=header, parent_header={}, metadata={}, content=content, channel="shell")
        channel.send(json.dumps(message))
        while True:
            answer = json.loads(channel.recv())
            if answer["parent_header"].get("msg_id") == number:
                printed.append(answer["content"].get("text") or answer["content"].get("evalue", ""))
                if answer["content"].get("execution_state") == "idle":
                    channel.close()
                    return "".join(printed)


@contextmanager
def classroom():
    """Yields a folder that all may enter, the hub's process, two learners with their servers, and a third person, who
    has an account of the machine but is not on the list."""
    mark = secrets.token_hex(2)
    names = [f"kfhard-{mark}-{letter}" for letter in "abc"]
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        folder.chmod(0o755)
        for name in names:
            stack.callback(remove, name)
        process, address = stack.enter_context(hub(folder, names[:2]))
        subprocess.run(["useradd", "--create-home", names[2]], check=True)
        passwords = {name: secrets.token_hex(12) for name in names}
        lines = "".join(f"{name}:{password}\n" for name, password in passwords.items())
        subprocess.run(["chpasswd"], input=lines, text=True, check=True)
        ada, ben, outsider = (Learner(address, name, password) for name, password in passwords.items())
        yield folder, process, (ada.start(), ben.start()), outsider
