"""A class server on one machine: JupyterHub, each learner a Unix account with a server of their own.

    sudo CLASS_REPOSITORY=https://… .venv/bin/jupyterhub --config class/jupyterhub_config.py

Settings come from the environment (README.md beside this file says more):

    CLASS_BIND         where to listen: http://127.0.0.1:8000, only this machine, unless something else is said
    CLASS_CERTIFICATE  a folder with fullchain.pem and privkey.pem, for https
    CLASS_LEARNERS     a file with one name a line (learners.txt beside this file); nobody else may sign in
    CLASS_TEACHERS     names of teachers with blanks between them: they may sign in, and see and stop servers
    CLASS_ACCOUNTS     "create": make an account for every name that has none
    CLASS_REPOSITORY   a git repository with the course; nbgitpuller copies it into each home, and brings it up to date
    CLASS_BRANCH       its branch (main)
    CLASS_MEMORY       of each process of a learner, such as 2G: a kernel that asks for more gets a MemoryError
    CLASS_STATE        a folder for the hub's own files (build/class)
"""

import os
import resource
import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from urllib.parse import urlencode

from jupyterhub.app import JupyterHub
from jupyterhub.auth import PAMAuthenticator
from jupyterhub.spawner import LocalProcessSpawner

HERE = Path(__file__).resolve().parent
spec = spec_from_file_location("obstacles", HERE.parent / "dev" / "teaching" / "obstacles.py")
spec.loader.exec_module(obstacles := module_from_spec(spec))  # the course's folder is not on Python's path here

COURSE, FIRST = "kalman", "notebooks/00-start-here.ipynb"


class ClassSpawner(LocalProcessSpawner):
    """Servers as local processes of their users, with the memory limit enforced, and files that others cannot read."""

    def make_preexec_fn(self, name):
        become, limit = super().make_preexec_fn(name), self.mem_limit

        def before_the_server():
            if limit:  # inherited by its kernels; it counts what a process writes to, not the libraries it maps
                resource.setrlimit(resource.RLIMIT_DATA, (int(limit), int(limit)))
            os.umask(0o077)
            become()

        return before_the_server


class ClassAuthenticator(PAMAuthenticator):
    """Unix passwords, for the names of the lists alone. What the hub remembers of earlier lists gives no rights."""

    async def add_user(self, user):
        """No Unix account for a name that the hub remembers, or that somebody typed at /hub/admin."""
        if user.name in self.allowed_users:
            await super().add_user(user)
        else:
            self.log.warning("%s is on no list and cannot sign in.", user.name)

    def is_admin(self, handler, authentication):
        return authentication["name"] in self.admin_users  # False takes the rights of a former teacher away

    async def refresh_user(self, user, handler=None):
        """The same for browsers that are still signed in from before."""
        return user.name in self.allowed_users and dict(name=user.name, admin=user.name in self.admin_users)


def named(variable, otherwise):
    return os.environ.get(variable, otherwise)


repository, branch = named("CLASS_REPOSITORY", ""), named("CLASS_BRANCH", "main")
creates = named("CLASS_ACCOUNTS", "") == "create"
learners = obstacles.listed(Path(named("CLASS_LEARNERS", HERE / "learners.txt")))
teachers = set(named("CLASS_TEACHERS", "").split())
new = {*learners, *teachers} if creates else ()
if JupyterHub.initialized() and (found := obstacles.obstacle(repository, branch, new)):  # only when a hub starts
    sys.exit(f"The class server was not started. {found}")

c = get_config()  # noqa: F821 (JupyterHub puts this function here)

# Where it listens. Without https passwords are readable on the way, so only this machine is the default.
c.JupyterHub.bind_url = named("CLASS_BIND", "http://127.0.0.1:8000")
if certificate := named("CLASS_CERTIFICATE", ""):
    c.JupyterHub.ssl_cert = f"{certificate}/fullchain.pem"
    c.JupyterHub.ssl_key = f"{certificate}/privkey.pem"

state = Path(named("CLASS_STATE", HERE.parent / "build" / "class"))
state.mkdir(mode=0o700, parents=True, exist_ok=True)
c.JupyterHub.db_url = f"sqlite:///{state}/jupyterhub.sqlite"
c.JupyterHub.cookie_secret_file = f"{state}/cookie_secret"
c.ConfigurableHTTPProxy.pid_file = f"{state}/proxy.pid"

# Who may sign in: Unix accounts with their passwords, of the names in the lists. No one can register. JupyterHub adds
# teachers to a list of learners by itself, but not when that is empty; and it would go on letting everybody in whom it
# has ever known, so that a name taken off the list would change nothing.
c.JupyterHub.authenticator_class = ClassAuthenticator
c.Authenticator.allow_all = False
c.Authenticator.allowed_users = {*learners, *teachers}
c.Authenticator.admin_users = teachers
c.Authenticator.allow_existing_users = False
c.Authenticator.auth_refresh_strict = True  # also for tokens
c.PAMAuthenticator.open_sessions = False
c.LocalAuthenticator.create_system_users = creates
c.LocalAuthenticator.add_user_cmd = ["adduser", "--quiet", "--gecos", "", "--disabled-password"]

# A server each, in the learner's own home. Numerical libraries get one thread: thirty learners share the cores.
c.JupyterHub.spawner_class = ClassSpawner
c.Spawner.cmd = [str(Path(sys.executable).with_name("jupyterhub-singleuser"))]
c.Spawner.notebook_dir = "~"
c.Spawner.mem_limit = named("CLASS_MEMORY", "2G")
c.Spawner.environment = {
    "JUPYTER_CONFIG_PATH": str(HERE.parent),  # jupyter_server_config.py and labconfig
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
}
c.JupyterHub.concurrent_spawn_limit = 10  # at nine o'clock all come at once
c.Spawner.start_timeout = 120
c.Spawner.http_timeout = 120

# The notebooks: nbgitpuller copies the course, and later merges what is new without touching a learner's changes.
c.Spawner.default_url = "/lab"
if repository:
    pull = dict(repo=repository, branch=branch, targetpath=COURSE)
    c.Spawner.default_url = "/git-pull?" + urlencode(pull | {"urlpath": f"lab/tree/{COURSE}/{FIRST}"})

# What a kernel and its server say to each other is encrypted: else whoever has an account of the machine can listen.
# Idle: a kernel ends after 30 minutes without work, its page open or not; a server without kernels after an hour.
c.Spawner.args = [
    "--KernelManager.transport_encryption=required",
    "--MappingKernelManager.cull_idle_timeout=1800",
    "--MappingKernelManager.cull_interval=120",
    "--MappingKernelManager.cull_connected=True",
    "--ServerApp.shutdown_no_activity_timeout=3600",
]
