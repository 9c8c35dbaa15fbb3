"""Run a command of `dev` as its users do."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]


def run(*command, timeout=110, **environment):
    """Run Python with some arguments, in the environment of the tests; what it printed."""
    done = subprocess.run(
        [sys.executable, *map(str, command)],
        cwd=ROOT,
        env=os.environ | environment,
        capture_output=True,
        text=True,
        timeout=timeout,
    )
    assert done.returncode == 0, done.stderr + done.stdout
    return done.stdout


def make(folder, *command):
    """Run make as a newcomer does: what the make that runs the tests was told is not handed on."""
    told = {name: value for name, value in os.environ.items() if not name.startswith(("MAKE", "MFLAGS"))}
    done = subprocess.run(
        ["make", "--no-print-directory", *command], cwd=folder, env=told, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    return done.stdout
