"""Make the picture in README.md again: `make picture`. Needs Chromium.

Lesson 5 is opened in JupyterLab, all its cells are run, and a number is typed into the box of Q.
"""

import shutil
import sys
import tempfile
from pathlib import Path

from dev.lab import CHROMIUM, Lab, browser, server

ROOT = Path(__file__).parent.parent

LESSON, TARGET = "05-voltmeter.ipynb", ROOT / "notebooks" / "pictures" / "voltmeter.png"


def main():
    if not CHROMIUM:
        sys.exit("no Chromium found: install chromium, chromium-browser or google-chrome")
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(ROOT / "notebooks" / LESSON, folder)
        with server(folder) as url, browser() as chromium:
            lab = Lab(chromium, url, LESSON, width=1280)
            lab.run_all()
            lab.settle()
            lab.type(0, "0.708")
            lab.settle()
            playground = lab.page.locator(".kf-playground").first
            playground.scroll_into_view_if_needed()
            lab.page.screenshot(path=TARGET, clip=playground.bounding_box())
    print(TARGET.relative_to(ROOT))


if __name__ == "__main__":
    main()
