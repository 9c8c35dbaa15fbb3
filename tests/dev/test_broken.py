"""If a process that runs tests breaks, `make test` says why, last of all, and tries the tests once more."""

import subprocess
import sys

from tests.dev.command import ROOT

TESTS = """
import pytest
import time


@pytest.mark.parametrize("k", range(5))
def test_{name}(k):
    time.sleep(0.05)
"""
HOOK = """

def pytest_runtest_logreport(report):
    if hasattr(report, "nodeid") and "test_b[2]" in report.nodeid and os.environ.get("PYTEST_XDIST_WORKER"):
        raise ValueError("this is the cause")
"""


def test_the_cause_is_printed_last(tmp_path):
    for name in "ab":
        (tmp_path / f"test_{name}.py").write_text(TESTS.format(name=name), encoding="utf-8")
    (tmp_path / "pytest.ini").write_text("[pytest]", encoding="utf-8")
    conftest = (ROOT / "tests" / "conftest.py").read_text(encoding="utf-8")
    (tmp_path / "conftest.py").write_text(f"import os\n{conftest}{HOOK}", encoding="utf-8")
    command = [sys.executable, "-m", "pytest", "-n", "2", "--dist=loadfile", "-p", "no:cacheprovider", str(tmp_path)]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 3
    told = done.stdout.rpartition("The first of ")[2]
    assert "internal errors of pytest" in told and "ValueError: this is the cause" in told


def test_only_then_are_they_run_again():
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    assert "\t$(TESTS) || { [ $$? = 3 ] && $(TESTS); }" in makefile
