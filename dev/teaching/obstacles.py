"""What would keep a class server from working, found before it starts.

Each function answers with sentences for the teacher, or with an empty string where nothing is in the way.
"""

import logging
import os
import pwd
import re
import subprocess
import sys
import sysconfig
from pathlib import Path

import requests

COURSE = Path(__file__).resolve().parents[2]
GIT = "application/x-git-upload-pack-advertisement"  # what a git server says that it sends
ACCOUNT = re.compile(r"[a-z][a-z0-9_-]{0,31}")  # the names of which Debian's adduser makes an account
NO_BRANCH = "no such branch"


def obstacle(repository, branch="main", names=()):
    """The first thing in the way of a class. Only root starts servers for other accounts.

    Names are those of whom the hub makes an account, if they have none.
    """
    return (os.geteuid() == 0 and cannot_run()) or cannot_be_made(names) or cannot_copy(repository, branch)


def listed(path):
    """The names in a list: one a line, without blank lines and remarks. A file that is not there has none."""
    lines = path.read_text(encoding="utf-8-sig").splitlines() if path.exists() else []
    return [name for name in map(str.strip, lines) if name and not name.startswith("#")]


def has_account(name):
    try:
        return bool(pwd.getpwnam(name))
    except KeyError:
        return False


def cannot_be_made(names):
    """The hub makes small letters of capitals. Of other names adduser makes no account, and the hub goes on without."""
    small = sorted({name.lower() for name in names})
    if wrong := [name for name in small if not ACCOUNT.fullmatch(name) and not has_account(name)]:
        return (
            f"No account can be made for: {', '.join(wrong)}. A name in class/learners.txt or in CLASS_TEACHERS begins "
            "with a letter from a to z. Only such letters, digits, - and _ come after it, and it has at most 32 signs."
        )
    return ""


def unreachable(path, wanted=0o005):
    """The first place on the way to a path that other accounts may not enter; None if they get there and may read it.

    Links are followed one by one, because each may lead through a closed folder.
    """
    path = Path(os.path.abspath(path))
    for place in (*reversed(path.parents), path):
        bits = wanted if place == path else 0o001
        if place.is_symlink() and (closed := unreachable(place.parent / place.readlink(), bits)):
            return closed
        if place.stat().st_mode & bits != bits:
            return place
    return None


def cannot_run():
    """Learners run this Python with its packages, and the course's settings."""
    for path in (sys.executable, sysconfig.get_path("stdlib"), sysconfig.get_path("purelib")):
        if closed := unreachable(path):
            return (
                f"Learners cannot run the Python of this environment, because {closed} is closed to other accounts. "
                "Make the environment with a Python that everybody may run, such as Debian's: `rm -r .venv`, then "
                "`make .venv/more PYTHON=/usr/bin/python3`. A Python of pyenv, conda or uv must lie in an open folder, "
                "such as one under /opt."
            )
    if closed := unreachable(COURSE):
        return f"Learners cannot read the course, because {closed} is closed to other accounts. Move it under /opt."
    return ""


def cannot_copy(repository, branch="main"):
    """Learners copy the course with git, each as an account of their own."""
    if repository.startswith(("http://", "https://")):
        return cannot_copy_from_the_web(repository)
    folder = Path(repository.removeprefix("file://"))
    if not folder.is_absolute() or os.geteuid():
        return ""  # an address for ssh; or a hub for oneself alone
    if not folder.exists():
        return f"CLASS_REPOSITORY names the folder {folder}, which does not exist."
    if closed := unreachable(folder):
        return f"Learners cannot copy CLASS_REPOSITORY, because {closed} is closed to other accounts."
    said = ask_as_nobody(repository, branch)
    if "dubious ownership" in said:
        git = folder / ".git" if (folder / ".git").exists() else folder
        return (
            f"git does not let learners copy {folder}, because it belongs to another account. "
            f"Allow it once: `git config --system --add safe.directory {git}`."
        )
    if said == NO_BRANCH:
        return f"{folder} has no branch {branch}. Say with CLASS_BRANCH which branch learners get."
    return said and f"Learners cannot copy CLASS_REPOSITORY. git says: {said}"


def ask_as_nobody(repository, branch="main"):
    """What git complains of when an account without any rights asks for a branch, or a tag, of the repository."""
    nobody = dict(user="nobody", group=pwd.getpwnam("nobody").pw_gid, extra_groups=[])
    env = {"PATH": os.environ["PATH"], "HOME": "/", "LANG": "C"}
    command = ["git", "ls-remote", "--exit-code", "--", repository, f"refs/heads/{branch}", f"refs/tags/{branch}"]
    done = subprocess.run(command, cwd="/", env=env, capture_output=True, text=True, **nobody)
    return NO_BRANCH if done.returncode == 2 else done.stderr.strip() if done.returncode else ""


def cannot_copy_from_the_web(repository):
    """nbgitpuller asks for the newest commit alone. A server that only hands out files cannot do this."""
    try:
        address = f"{repository.rstrip('/')}/info/refs?service=git-upload-pack"
        answer = requests.get(address, timeout=10, stream=True)
    except requests.RequestException as error:
        logging.getLogger("class").warning("CLASS_REPOSITORY cannot be reached at the moment: %s", error)
        return ""
    with answer:
        if answer.headers.get("Content-Type") == GIT or answer.status_code >= 500:
            return ""
        if not answer.ok:
            return f"Learners cannot copy {repository}, which answers {answer.status_code} {answer.reason}."
    return (
        f"Learners cannot copy {repository}, because that server only hands out files. CLASS_REPOSITORY must be on a "
        "git server that can send the newest commit alone, such as GitHub, GitLab or Gitea, or in a folder of this "
        "machine."
    )
