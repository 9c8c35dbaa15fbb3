"""Run the filters of other libraries on three tiny problems and write the page about them: `make atlas`.

python -m dev.atlas               all, in new environments: some fifteen minutes, and a package index
python -m dev.atlas pykalman      one of them; prints what it found and writes nothing

What was found is kept in found.json. R, gretl, Octave and Node are not fetched: where one is not installed, a line says
so, and the rows of its libraries stay as they were found.
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

from dev.atlas import programs
from dev.atlas.languages import LANGUAGES
from dev.atlas.page import checksum, page, paths, pinned
from dev.atlas.run import found_in

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "notebooks" / "appendix-libraries.md"
FOUND = Path(__file__).parent / "found.json"
NEAR = 1e-8  # dynamax adds 1e-9 to each innovation variance
PROGRAMS = "Scripts" if os.name == "nt" else "bin"
UNTRIED = "MATLAB, the packages of Julia, and R's KFAS and dlm."


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


def run(files):
    """{file: what was found today} of all whose program is here."""
    results = {}
    for path in files:
        if path.suffix == ".py":
            found = ask(path)
        elif programs.version(path) is None:
            print(f"{path.stem}: not run, {LANGUAGES[path.suffix].program} is not installed here.", flush=True)
            continue
        else:
            found = found_in(path)
        results[path] = found | {"on": date.today().isoformat(), "lines": checksum(path)}
        print(path.stem, json.dumps(results[path], ensure_ascii=False), flush=True)
    return results


def stored():
    """{file: what was found} of all libraries on the page, in its order."""
    found = json.loads(FOUND.read_text(encoding="utf-8"))
    return {path: found[path.stem] for path in paths() if path.stem in found}


def write(results):
    """Keep what was found, and make the page of it."""
    kept = {path.stem: found for path, found in results.items()}
    FOUND.write_text(json.dumps(kept, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    PAGE.write_text(page(results, UNTRIED), encoding="utf-8")


def with_the_rest(results):
    """What was found today, and of libraries that could not be run, what was found before."""
    known = stored() | results
    new = [path.stem for path in paths() if path not in known or known[path]["lines"] != checksum(path)]
    if new:
        sys.exit(f"The lines of {', '.join(new)} were never run, and cannot be run here.")
    stayed = [f"{path.stem} ({found['on']})" for path, found in known.items() if path not in results]
    print(f"As they were: {', '.join(stayed)}." if stayed else "All were run.")
    return {path: known[path] for path in paths()}


def main(names):
    results = run([path for path in paths() if not names or path.stem in names])
    bad = [path.stem for path, found in results.items() if isinstance(found["same"], str) or found["same"] > NEAR]
    if bad:
        sys.exit(f"These do not give kflearn's numbers: {', '.join(bad)}")
    if not names:
        write(with_the_rest(results))
        print(f"{PAGE.name} is written.")


if __name__ == "__main__":
    main(sys.argv[1:])
