"""What each page says about the course: its version, where it is kept, what can be downloaded. For `dev/web/build.py`.

Two addresses are settings in pyproject.toml, under [tool.kflearn]: `repository`, where the course is kept and where
readers say what is wrong, and `site`, where the web page itself will be. The environment variables KFLEARN_REPOSITORY
and KFLEARN_ADDRESS replace them for one build. Empty means: not known. Without the repository no link leads to it.
Without the site's own address there is no canonical address and no sitemap, the picture for previews has a relative
address (which most programs that show previews do not follow), and the page for what was not found looks for the start
page by itself.
"""

import os
import re
import shutil
import subprocess
import sys
import tomllib
from xml.sax.saxutils import escape

VARIABLES = {"repository": "KFLEARN_REPOSITORY", "site": "KFLEARN_ADDRESS"}
# How the paragraphs begin that are not true on the web page: in a lesson's first cell, and in the README
STORED, FOLDER = "*The outputs below are stored from an earlier run.", "**Get the folder.**"


def settings(root):
    """The two addresses, and the version. An address ends without a slash."""
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))
    table = project.get("tool", {}).get("kflearn", {})
    addresses = {key: os.environ.get(name, table.get(key, "")).rstrip("/") for key, name in VARIABLES.items()}
    for key, address in addresses.items():
        if address and not re.match(r"https?://[^\s\"<>]+$", address):
            sys.exit(f"{key} = {address!r} is not an address: it begins with https://, or is empty")
    package = (root / "kflearn" / "__init__.py").read_text(encoding="utf-8")
    return {**addresses, "version": re.search(r'(?m)^__version__ = "([^"]+)"', package)[1]}


def archive(root, path):
    """Write the course, as it was last committed, into a zip file; returns its size in words, "" outside of git."""
    if not (root / ".git").exists() or not shutil.which("git"):
        return ""
    command = ["git", "archive", "--format=zip", "--prefix=kalman-course/", f"--output={path}", "HEAD"]
    done = subprocess.run(command, cwd=root, capture_output=True, text=True)
    if done.returncode:
        path.unlink(missing_ok=True)
        print("no course.zip:", done.stderr.strip(), file=sys.stderr)
        return ""
    return f"{path.stat().st_size / 1e6:.1f} MB"


def note(name, size):
    """The lines under a lesson's title: how to go on from reading to changing and answering."""
    get = '<a href="course.zip" download>download the course</a>, ' if size else ""
    return f"""<p class="note">To change the code and have your answers checked, {get}
<a href="index.html#start">start JupyterLab</a> and open <a href="notebooks/{name}" download>notebooks/{name}</a>.
<span class="phone">Tap a picture to see it larger.</span></p>"""


def where(about):
    """The first page's paragraph on where to get the course's folder."""
    ways = []
    if about["zip"]:
        ways += [f'<a href="course.zip" download>download it</a> (zip, {about["zip"]}) and unpack it']
    if about["repository"]:
        ways += [f'take it from <a href="{about["repository"]}">the course\'s repository</a>']
    ways = ways or ["whoever gave you this page has it"]
    return f"{FOLDER} The course is a folder of notebooks: {', or '.join(ways)}."


def without(beginning, text):
    """A text without the paragraph that begins so."""
    return re.sub(rf"(?m)^{re.escape(beginning)}.*(\n.+)*\n*", "", text).rstrip()


def sitemap(names, site):
    """The list of pages for search engines."""
    places = "\n".join(f"<url><loc>{escape(f'{site}/{name}')}</loc></url>" for name in names)
    head = '<?xml version="1.0" encoding="UTF-8"?>\n<urlset xmlns="http://www.sitemaps.org/schemas/sitemap/0.9">'
    return f"{head}\n{places}\n</urlset>\n"


def citation(root):
    """A page with the course as an entry of a list of references, from CITATION.cff."""
    import yaml

    cited = yaml.safe_load((root / "CITATION.cff").read_text(encoding="utf-8"))
    authors = [each.get("name") or f"{each['given-names']} {each['family-names']}" for each in cited["authors"]]
    who, year, title = " and ".join(authors), str(cited["date-released"])[:4], cited["title"]
    fields = dict(author=who, title=title, version=cited["version"], year=year)
    entry = f"@software{{kflearn, {', '.join(f'{name} = {{{value}}}' for name, value in fields.items())}}}"
    words = "Name the version: numbers and lessons change from one to the next."
    return (
        f"# Cite this course\n\n{who}, *{title}*, version {cited['version']}, {year}.\n\n{words}\n\n```\n{entry}\n```\n"
    )
