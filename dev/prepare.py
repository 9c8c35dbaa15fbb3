"""Make the environment of the course, or bring it up to date.

    python3 -m dev.prepare                          what the course needs, in .venv
    python3 -m dev.prepare requirements-more.txt    also what teachers, the web page and the tests need
    python3 -m dev.prepare --folder .venv-other     in another folder

`make` calls this file. It needs nothing but Python, and even an old Python can read it, so that it can say what is
missing. It takes uv instead of pip where uv is installed.
"""

import argparse
import os
import shutil
import subprocess
import sys
import time

OLDEST, NEWEST = (3, 11), (3, 14)  # as in pyproject.toml
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PROGRAMS = "Scripts" if os.name == "nt" else "bin"
NEEDS = "The course needs Python {}.{} to {}.{}".format(*(OLDEST + NEWEST))
NO_PYTHON = """{}; this is {}, and no other was found here.
Install one of these and give the command again. Debian, Ubuntu: sudo apt install python3 python3-venv.
Windows, macOS: from python.org. With uv: uv python install 3.13, then make PYTHON=$(uv python find 3.13) course."""
NO_VENV = """This Python ({}) cannot make environments: its module venv is not complete.
On Debian and Ubuntu that is a package of its own: sudo apt install python3-venv. Then give the command again."""
MAKING = "The environment in {} is being made: one to three minutes, this once."
RENEWING = "The environment in {} is being brought up to date."
ADDING = "{} more packages for the tests and the teachers' commands are being added to {}: one to three minutes."
STOPPED = """The installation stopped. These are its last lines; all of them are in {}.

{}

Is the Internet reachable? Then give the command again."""


def version(python):
    """(3, 11, 7) for a program that is a Python and runs, else None."""
    ask = "import sys; print('%d.%d.%d' % sys.version_info[:3])"
    try:
        said = subprocess.check_output([python, "-c", ask], stderr=subprocess.DEVNULL, universal_newlines=True)
        return tuple(int(number) for number in said.strip().split("."))
    except (OSError, ValueError, subprocess.CalledProcessError):
        return None


def fits(found):
    return found is not None and OLDEST <= found[:2] <= NEWEST


def suitable():
    """The Python to build with: the one that runs this file, or the newest that fits on the PATH; stops without one."""
    if fits(sys.version_info[:3]):
        return sys.executable
    mine = "Python {}.{}.{}".format(*sys.version_info[:3])
    for minor in range(NEWEST[1], OLDEST[1] - 1, -1):
        other = shutil.which("python3.{}".format(minor))
        if other and fits(version(other)):
            print("{}; this is {}. Taking python3.{}, which is here too.".format(NEEDS, mine, minor))
            return other
    sys.exit(NO_PYTHON.format(NEEDS, mine))


def complete(folder):
    """Whether the environment was made to its end, and its Python still runs and fits."""
    python = os.path.join(folder, PROGRAMS, "python")
    return os.path.exists(os.path.join(folder, "ready")) and fits(version(python))


def outdated(folder):
    """Whether the lists of what the course needs are newer than the environment."""
    made = os.path.getmtime(os.path.join(folder, "ready"))
    return any(os.path.getmtime(os.path.join(ROOT, name)) > made for name in ("requirements.txt", "pyproject.toml"))


def new_environment(folder, uv):
    """An empty environment, in place of whatever is in the folder."""
    python = suitable()
    if os.path.exists(folder):
        print("{} was not complete. It is made anew.".format(os.path.basename(folder)))
        shutil.rmtree(folder)
    if uv:
        subprocess.check_call([uv, "venv", "--quiet", "--seed", "--python", python, folder])
    elif subprocess.call([python, "-c", "import ensurepip, venv"], stderr=subprocess.DEVNULL):
        sys.exit(NO_VENV.format(python))
    else:
        subprocess.check_call([python, "-m", "venv", folder])


def installed(folder):
    """How many packages are in the environment."""
    return sum(name.endswith(".dist-info") for _, names, _ in os.walk(folder) for name in names)


def follow(process, log, folder, wanted):
    """Say how far an installation is, until it ends; returns its exit code."""
    before, last, alive = installed(folder), "", sys.stdout.isatty()
    while process.poll() is None:
        time.sleep(0.5 if alive else 5)
        with open(log, encoding="utf-8", errors="replace") as file:
            fetched = sum(line.startswith("Collecting ") for line in file)
        done = min(wanted, max(0, installed(folder) - before))
        line = "installed {} of {} packages".format(done, wanted) if done else ""
        if fetched and not done:
            line = "fetched {} of {} packages".format(min(fetched, wanted), wanted)
        if line not in ("", last) and wanted > 1:
            print(("\r" if alive else "") + line + "   ", end="" if alive else "\n")
            sys.stdout.flush()
        last = line
    if wanted > 1 and process.returncode == 0:
        print(("\r" if alive else "") + "installed {0} of {0} packages   ".format(wanted))
    return process.returncode


def install(folder, uv, what, wanted):
    """Install something into the environment, with news on the screen; stops with the reason if it fails."""
    python = os.path.join(folder, PROGRAMS, "python")
    command = [uv, "pip", "install", "--python", python] if uv else [python, "-m", "pip", "install"]
    log = os.path.join(folder, "install.log")
    with open(log, "w", encoding="utf-8") as file:
        process = subprocess.Popen(command + what, cwd=ROOT, stdout=file, stderr=subprocess.STDOUT)
        failed = follow(process, log, folder, wanted)
    if failed:
        with open(log, encoding="utf-8", errors="replace") as file:
            last = file.read().splitlines()[-8:]
        sys.exit(STOPPED.format(log, "\n".join(last)))


def pins(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return sum("==" in line for line in file)


def say(text):
    print(text)
    sys.stdout.flush()


def bring(folder, uv, more):
    """Install what is missing, and say first what it is."""
    name, new = os.path.basename(folder), not complete(folder)
    if new:
        new_environment(folder, uv)
    if new or not more or outdated(folder):
        say((MAKING if new else RENEWING).format(name))
        install(folder, uv, ["--requirement", "requirements.txt"], pins("requirements.txt"))
    for path in more:
        say(ADDING.format(pins(path), name))
        install(folder, uv, ["--requirement", path], pins(path))
    install(folder, uv, ["--no-deps", "--editable", "."], 1)
    open(os.path.join(folder, "ready"), "w", encoding="utf-8").close()
    print("The environment is ready.")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("more", nargs="*", help="further files with requirements")
    parser.add_argument("--folder", default=os.path.join(ROOT, ".venv"))
    options = parser.parse_args()
    bring(os.path.abspath(options.folder), shutil.which("uv"), options.more)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("\nStopped. Give the command again.")
