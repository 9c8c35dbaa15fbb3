"""Answers are collected from the learners' homes, with the rights of the learners and of the account that grades."""

import os
import secrets
import subprocess
import sys

import pytest

from tests.dev.command import run

if sys.platform != "linux" or os.geteuid():
    pytest.skip("makes accounts: needs Linux and root", allow_module_level=True)
import pwd

from dev.hard.classroom import remove


@pytest.fixture
def people():
    """Three accounts with closed homes, removed at the end: two learners and one that grades."""
    names = [f"kfcollect-{secrets.token_hex(2)}-{letter}" for letter in "abg"]
    try:
        for name in names:
            subprocess.run(["useradd", "--create-home", name], check=True)
            os.chmod(pwd.getpwnam(name).pw_dir, 0o700)
        yield [pwd.getpwnam(name) for name in names]
    finally:
        for name in names:
            remove(name)


def put(account, name, text):
    """A file in an account's home, which belongs to the account."""
    path = f"{account.pw_dir}/{name}"
    write = "import sys, pathlib; p = pathlib.Path(sys.argv[1]); p.parent.mkdir(parents=True, exist_ok=True); "
    write += "p.write_text(sys.argv[2])"
    command = ["/usr/bin/python3", "-c", write, path, text]
    subprocess.run(command, user=account.pw_uid, group=account.pw_gid, extra_groups=[], cwd="/", check=True)
    os.utime(path, (1767225600,) * 2)
    return path


def test_answers_are_collected_with_nobodys_rights_but_the_owners(people, tmp_path):
    ada, ben, grader = people
    secret = put(ben, "kalman/notebooks/secret.ipynb", "of ben")
    put(ada, "kalman/assignments/04-answers.ipynb", "of ada")
    put(ada, "kalman/notebooks/04-answers (1).ipynb", "of ada")
    put(ada, "kalman/assignments/07-answers.ipynb", "of another assignment")
    put(ada, "kalman/notebooks/.ipynb_checkpoints/04-answers-checkpoint.ipynb", "of ada")
    os.symlink(secret, f"{ada.pw_dir}/kalman/05-answers.ipynb")
    (tmp_path / "learners.txt").write_text(f"# class\n{ada.pw_name}\n{ben.pw_name}\nnobody-knows\n")
    for _ in range(2):
        printed = run("-m", "dev.teaching.collect", grader.pw_name, "4", "05", "--learners", tmp_path / "learners.txt")
        assert printed.splitlines() == [
            f"{ada.pw_name}: 2 files",
            f"No file from: {ben.pw_name}. The table of points will say: nothing handed in.",
            "No account of this name: nobody-knows.",
            f"The files are in {grader.pw_dir}/answers-04-05.",
        ]
    everybody = set(os.listdir(f"{grader.pw_dir}/answers-04-05"))
    assert everybody == {ada.pw_name, ben.pw_name}, "the table has a line for each"
    found = [
        os.path.join(place, name) for place, _, names in os.walk(f"{grader.pw_dir}/answers-04-05") for name in names
    ]
    start = f"{grader.pw_dir}/answers-04-05/{ada.pw_name}/kalman"
    assert sorted(found) == [f"{start}/assignments/04-answers.ipynb", f"{start}/notebooks/04-answers (1).ipynb"]
    for path in found:
        about = os.stat(path)
        assert about.st_uid == grader.pw_uid and about.st_mode & 0o077 == 0 and int(about.st_mtime) == 1767225600


def test_a_home_that_leads_elsewhere_gives_nothing(people, tmp_path):
    ada, ben, grader = people
    put(ben, "kalman/04-answers.ipynb", "of ben")
    os.symlink(f"{ben.pw_dir}/kalman", f"{ada.pw_dir}/kalman")
    (tmp_path / "learners.txt").write_text(ada.pw_name)
    printed = run("-m", "dev.teaching.collect", grader.pw_name, "4", "05", "--learners", tmp_path / "learners.txt")
    assert printed.startswith(f"No file from: {ada.pw_name}. ") and printed.count("\n") == 1
    assert not os.listdir(f"{grader.pw_dir}/answers-04-05/{ada.pw_name}")
