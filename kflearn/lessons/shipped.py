"""Where the lessons are that came with the package, and the few settings of Jupyter for them.

In an installed package they are beside this file: `setup.py` puts them there. In a clone they are the clone's own.
"""

from pathlib import Path

FIRST = "00-start-here.ipynb"
PACKAGE = Path(__file__).parent
CLONE = PACKAGE.parent.parent


def notebooks() -> Path:
    """The folder of the lessons, with the appendices and the pictures. Raises FileNotFoundError where it is missing."""
    for folder in (PACKAGE / "notebooks", CLONE / "notebooks"):
        if (folder / FIRST).exists():
            return folder
    raise FileNotFoundError("the lessons did not come with this installation of kflearn: install it again")


def settings() -> Path:
    """The folder with jupyter_server_config.py, for JUPYTER_CONFIG_PATH."""
    beside = PACKAGE / "settings"
    return beside if beside.exists() else CLONE


def lessons() -> list[Path]:
    """The lessons, in order."""
    return sorted(notebooks().glob("[0-9][0-9]-*.ipynb"))


def others() -> list[Path]:
    """What belongs to the lessons: appendices, the teaching guide, pictures; paths below notebooks()."""
    folder = notebooks()
    found = [*folder.glob("appendix-*.md"), *folder.glob("teaching-guide.md"), *folder.glob("pictures/*")]
    return sorted(path.relative_to(folder) for path in found)
