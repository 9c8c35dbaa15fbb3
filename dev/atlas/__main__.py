"""Run the filters of other libraries on three tiny problems and write the page about them: `make atlas`.

python -m dev.atlas               all, in new environments: some fifteen minutes, and a package index
python -m dev.atlas pykalman      one of them; prints what it found and writes nothing
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import venv
from datetime import date
from pathlib import Path

from dev.atlas.page import LIBRARIES, page, pinned

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "notebooks" / "appendix-libraries.md"
NEAR = 1e-8  # dynamax adds 1e-9 to each innovation variance
PROGRAMS = "Scripts" if os.name == "nt" else "bin"
UNTRIED = "MATLAB, the packages of Julia and R (KFAS, dlm, base R), Octave and gretl: they are not installed by pip."


def ask(path):
    """What `dev.atlas.run` found, in an environment of the library's own."""
    with tempfile.TemporaryDirectory() as folder:
        uv = shutil.which("uv", path=os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]]))
        venv.create(folder, with_pip=uv is None)
        python = Path(folder, PROGRAMS, "python")
        install = [uv, "pip", "install", "--python", python] if uv else [python, "-m", "pip", "install"]
        subprocess.run([*install, "--quiet", *pinned(path).split()], check=True)
        env = os.environ | {"PYTHONPATH": str(ROOT), "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run(
            [python, "-m", "dev.atlas.run", path], env=env, capture_output=True, text=True, check=False
        )
    if done.returncode:
        sys.exit(f"{path.stem}: {done.stderr}")
    return json.loads(done.stdout.splitlines()[-1])


def main(names):
    files = sorted(LIBRARIES.glob("*.py"))
    results = {}
    for path in (path for path in files if not names or path.stem in names):
        results[path] = ask(path)
        print(path.stem, json.dumps(results[path], ensure_ascii=False), flush=True)
    bad = [path.stem for path, found in results.items() if isinstance(found["same"], str) or found["same"] > NEAR]
    if bad:
        sys.exit(f"These do not give kflearn's numbers: {', '.join(bad)}")
    if not names:
        PAGE.write_text(page(results, date.today().isoformat(), UNTRIED), encoding="utf-8")
        print(f"{PAGE.name} is written.")


if __name__ == "__main__":
    main(sys.argv[1:])
