"""`import kflearn` is headless and fast."""

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


def test_it_takes_hardly_longer_than_numpy():
    # Processor time after NumPy is there, so that a busy machine does not count; the best of five.
    code = "import numpy, time; start = time.process_time(); import kflearn; print(time.process_time() - start)"
    assert min(float(fresh(code=code).stdout) for _ in range(5)) < 0.05
