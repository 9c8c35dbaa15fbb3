"""Make the course a site that runs in a browser without an installation: JupyterLite, in build/lite.

    python -m dev.lite.build                       Pyodide and its compiled packages come from its public server
    python -m dev.lite.build --pyodide FOLDER      … or from a copy that becomes a part of the site, for a class offline

It runs in an environment of its own (`make lite`). The site needs a web server, and no other program on it.
"""

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from dev import lessons
from dev.lite import pure

ROOT = lessons.ROOT
KERNEL = "@jupyterlite/pyodide-kernel-extension:kernel"
SPEC = {"display_name": "Python (Pyodide)", "language": "python", "name": "python"}
FIRST = "# In the browser, run this cell first: it fetches the course's package and what it needs, in about a minute.\n"
PYODIDE = "static/pyodide"
EXTENSION = "extensions/@jupyterlite/pyodide-kernel-extension/static/schema/kernel.v0.schema.json"
NO_PYODIDE = "{} has no pyodide.mjs. It should be the folder `pyodide` from Pyodide's release pyodide-VERSION.tar.bz2."
OTHER_PYODIDE = "{} is Pyodide {}. This JupyterLite was made for {}."


def in_one_string(data):
    """A text of an output as one string: as a list of lines, as Jupyter saves it, it empties the table of contents."""
    return {
        kind: "".join(text) if isinstance(text, list) and kind != "application/json" else text
        for kind, text in data.items()
    }


def for_browser(notebook):
    """A lesson (a notebook's JSON) as the site shows it, changed in place: it begins with an installation."""
    install = FIRST + "%pip install -q " + " ".join(["kflearn", *pure.needed()])
    cell = {"cell_type": "code", "id": "in-the-browser", "metadata": {}, "source": install}
    notebook["cells"].insert(1, cell | {"outputs": [], "execution_count": None})
    for cell in notebook["cells"]:
        for output in cell.get("outputs", []):
            if "data" in output:
                output["data"] = in_one_string(output["data"])
    notebook["metadata"] = {"kernelspec": SPEC, "language_info": {"name": "python"}}
    return notebook


def contents(folder):
    """The lessons and what belongs to them, into a folder."""
    notebooks = ROOT / "notebooks"
    shutil.copytree(notebooks / "pictures", folder / "pictures")
    for path in notebooks.glob("*.md"):
        shutil.copy(path, folder)
    for path in lessons.lessons():
        notebook = for_browser(json.loads(path.read_text(encoding="utf-8")))
        (folder / path.name).write_text(json.dumps(notebook, ensure_ascii=False, indent=1), encoding="utf-8")


def settings(folder):
    """The site's settings: nothing from PyPI, no news of Jupyter, and texts shown with their formulas."""
    page = json.loads((ROOT / "labconfig" / "page_config.json").read_text(encoding="utf-8"))
    page |= {"appName": "Kalman filtering, hands on", "litePluginSettings": {KERNEL: {"disablePyPIFallback": True}}}
    site = {"jupyter-lite-schema-version": 0, "jupyter-config-data": page}
    (folder / "jupyter-lite.json").write_text(json.dumps(site, indent=2), encoding="utf-8")
    shutil.copy(ROOT / "labconfig" / "default_setting_overrides.json", folder / "overrides.json")


def version(site):
    """The version of Pyodide for which a site was made."""
    schema = json.loads((site / EXTENSION).read_text(encoding="utf-8"))
    return re.search(r"/v([^/]+)/full/", schema["properties"]["pyodideUrl"]["default"])[1]


def beside(pyodide, site):
    """Put a copy of Pyodide into a site, which then asks no other server."""
    found = json.loads((pyodide / "package.json").read_text(encoding="utf-8"))["version"]
    if found != version(site):
        sys.exit(OTHER_PYODIDE.format(pyodide, found, version(site)))
    shutil.copytree(pyodide, site / PYODIDE, dirs_exist_ok=True)
    file = site / "jupyter-lite.json"
    config = json.loads(file.read_text(encoding="utf-8"))
    config["jupyter-config-data"]["litePluginSettings"][KERNEL]["pyodideUrl"] = f"./{PYODIDE}/pyodide.mjs"
    file.write_text(json.dumps(config, indent=2), encoding="utf-8")


def build(draft, out):
    """Make the site from a draft folder; stops with JupyterLite's words if it fails."""
    command = [sys.executable, "-m", "jupyterlite_core", "build", "--lite-dir", draft, "--output-dir", out]
    command += ["--apps", "lab", "--no-sourcemaps"]
    done = subprocess.run(list(map(str, command)), cwd=draft, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{done.stdout}\n{done.stderr}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "lite")
    parser.add_argument("--pyodide", type=Path, help="the folder of a copy of Pyodide, with its compiled packages")
    options = parser.parse_args()
    if options.pyodide and not all((options.pyodide / name).exists() for name in ("pyodide.mjs", "package.json")):
        sys.exit(NO_PYODIDE.format(options.pyodide))
    with tempfile.TemporaryDirectory() as folder:
        draft = Path(folder).resolve()
        (draft / "files").mkdir()
        (draft / "pypi").mkdir()
        contents(draft / "files")
        settings(draft)
        pure.fetch(pure.SITE, draft / "pypi")
        pure.wheel(draft / "pypi")
        build(draft, draft / "site")
        if options.pyodide:
            beside(options.pyodide, draft / "site")
        if (options.out / "jupyter-lite.json").exists():  # a site built before, nothing else
            shutil.rmtree(options.out)
        shutil.copytree(draft / "site", options.out)
    print(f"{options.out} is ready. To see it: python3 -m http.server --bind 127.0.0.1 --directory {options.out}")
    print("and open http://127.0.0.1:8000/lab/index.html?path=00-start-here.ipynb")


if __name__ == "__main__":
    main()
