"""`import kflearn` is headless and fast."""

import subprocess
import sys

HEAVY = ["matplotlib", "ipywidgets", "scipy", "filterpy", "IPython", "PIL", "pandas", "narwhals", "gpxpy"]


def fresh(*options, code):
    return subprocess.run([sys.executable, *options, "-c", code], capture_output=True, text=True, check=True)


def test_nothing_heavy_is_loaded():
    loaded = fresh(code="import kflearn, sys; print(*sys.modules, sep='\\n')").stdout.split()
    assert "numpy" in loaded
    assert "kflearn.course.scenarios" in loaded
    assert [name for name in HEAVY if name in loaded] == []


def test_it_takes_less_time_than_numpy_alone(tmp_path, monkeypatch):
    # Processor time in one process, so that a busy machine slows both; the least disturbed of five.
    code = (
        "from time import process_time as now; a = now(); import numpy; b = now(); import kflearn; c = now(); "
        "print((c - b) / (b - a))"
    )
    # Compiled files are kept, as Python does unless it is told not to: else the time of compiling would be measured.
    monkeypatch.delenv("PYTHONDONTWRITEBYTECODE", raising=False)
    monkeypatch.setenv("PYTHONPYCACHEPREFIX", str(tmp_path))
    fresh(code=code)
    assert any(tmp_path.rglob("kflearn/**/*.pyc")), "nothing was compiled"
    assert min(float(fresh(code=code).stdout) for _ in range(5)) < 1


def test_dir_shows_what_is_public():
    import kflearn

    assert dir(kflearn) == sorted(kflearn.__all__)
    assert len(set(kflearn.__all__)) == len(kflearn.__all__)
    for name in kflearn.__all__:
        assert getattr(kflearn, name) is not None
    assert {"unscented", "cubature", "linearize", "Track", "RecordingError", "FILTERS"} <= set(dir(kflearn))
