"""`import kflearn` is headless and fast."""

import re
import subprocess
import sys

HEAVY = ["matplotlib", "ipywidgets", "scipy", "filterpy", "IPython", "PIL", "pandas"]


def fresh(*options, code):
    return subprocess.run([sys.executable, *options, "-c", code], capture_output=True, text=True, check=True)


def test_nothing_heavy_is_loaded():
    loaded = fresh(code="import kflearn, sys; print(*sys.modules, sep='\\n')").stdout.split()
    assert "numpy" in loaded
    assert "kflearn.scenarios" in loaded
    assert [name for name in HEAVY if name in loaded] == []


def test_own_import_time_is_small():
    # The sum of what kflearn's own files take, without what they import; the best of three, on a busy machine too.
    def own():
        report = fresh("-X", "importtime", code="import kflearn").stderr
        times = re.findall(r"import time:\s+(\d+) \|\s+\d+ \|\s+(kflearn\S*)\n", report)
        assert len(times) > 8
        return sum(int(microseconds) for microseconds, _ in times)

    assert min(own() for _ in range(3)) < 50_000
