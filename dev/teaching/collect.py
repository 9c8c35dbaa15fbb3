"""Collect a class's answers from the learners' homes of a class server, for grading. Only root can do it:

    python -m dev.teaching.collect grading 04 05       into the home of the account grading: answers-04-05/LEARNER

Taken are all files below kalman with 04-answers or 05-answers in their names, with their times. They are read as the
learner, so that nobody can hand in a link to somebody else's file, and written as the account that will grade them.
The next collection overwrites them and removes nothing. Files of 20 MB and more are left out.
"""

import argparse
import os
import pwd
import subprocess
import sys
from pathlib import Path

from dev.teaching.obstacles import listed

LISTED = Path(__file__).parents[2] / "class" / "learners.txt"
FIND = ["find", "kalman", "-name", ".*", "-prune", "-o", "-type", "f", "-size", "-20M"]
PACK = ["tar", "--create", "--dereference", "--hard-dereference", "--null", "--no-recursion", "--files-from=-"]
UNPACK = ["tar", "--extract", "--no-same-owner", "--no-same-permissions"]


def run_as(account, command, given=b""):
    """Run a command in an account's home, with its rights alone; how it ended and what it wrote."""
    rights = dict(user=account.pw_uid, group=account.pw_gid, extra_groups=[], umask=0o077)
    env = {"PATH": "/usr/bin:/bin", "HOME": account.pw_dir, "LANG": "C.UTF-8"}
    enter = ["env", f"--chdir={account.pw_dir}"]  # with these rights, not with root's
    return subprocess.run([*enter, *command], cwd="/", env=env, input=given, capture_output=True, **rights)


def collect(learner, grader, lessons):
    """Copy a learner's files; how many. An empty folder brings the name into the table of points all the same."""
    patterns = [word for number in lessons for word in ("-o", "-name", f"*{number:0>2}-answers*.ipynb")][1:]
    names = run_as(learner, [*FIND, "(", *patterns, ")", "-print0"]).stdout
    target = f"{folder(grader, lessons)}/{learner.pw_name}"
    run_as(grader, ["mkdir", "--parents", target])
    if not names:
        return 0
    packed = run_as(learner, PACK, names).stdout
    if run_as(grader, [*UNPACK, f"--directory={target}"], packed).returncode:
        sys.exit(f"{grader.pw_name} could not write {learner.pw_name}'s files into {target}.")
    return names.count(b"\0")


def folder(grader, lessons):
    return "-".join([f"{grader.pw_dir}/answers", *(f"{number:0>2}" for number in lessons)])


def accounts(path):
    """The accounts of a list of learners. (accounts, names that have none)"""
    names = [name.lower() for name in listed(path)]
    known = {each.pw_name: each for each in pwd.getpwall()}
    return [known[name] for name in names if name in known], [name for name in names if name not in known]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("account", help="the account that will grade, such as grading")
    parser.add_argument("lessons", nargs="+", help="numbers of the assignment's lessons, such as 04 05")
    parser.add_argument("--learners", type=Path, default=LISTED, help="the list of names (class/learners.txt)")
    options = parser.parse_args()
    if os.geteuid():
        sys.exit("Only root can collect from the homes of others.")
    try:
        grader = pwd.getpwnam(options.account)
    except KeyError:
        sys.exit(f"There is no account {options.account}.")
    if not options.learners.exists():
        sys.exit(f"There is no list {options.learners}.")
    learners, unknown = accounts(options.learners)
    counts = {learner.pw_name: collect(learner, grader, options.lessons) for learner in learners}
    for name in filter(counts.get, counts):
        print(f"{name}: {counts[name]} file{'s' * (counts[name] > 1)}")
    if absent := [name for name, number in counts.items() if not number]:
        print(f"No file from: {', '.join(absent)}. The table of points will say: nothing handed in.")
    if unknown:
        print(f"No account of this name: {', '.join(unknown)}.")
    if any(counts.values()):
        print(f"The files are in {folder(grader, options.lessons)}.")


if __name__ == "__main__":
    main()
