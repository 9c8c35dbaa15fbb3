"""What pyproject.toml cannot say: the wheel carries the lessons, which are not inside the package's folder."""

import shutil
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py

ROOT = Path(__file__).parent
CARRIED = {
    "notebooks": ["notebooks/[0-9][0-9]-*.ipynb", "notebooks/appendix-*.md", "notebooks/teaching-guide.md"],
    "notebooks/pictures": ["notebooks/pictures/*"],
    "settings": ["jupyter_server_config.py"],
    "settings/labconfig": ["labconfig/*"],
}


class WithLessons(build_py):
    """Copies the lessons and Jupyter's settings into kflearn/lessons of the wheel."""

    def run(self):
        super().run()
        if self.editable_mode:
            return  # a clone has them already
        for folder, patterns in CARRIED.items():
            target = Path(self.build_lib, "kflearn", "lessons", folder)
            target.mkdir(parents=True, exist_ok=True)
            for path in (path for pattern in patterns for path in ROOT.glob(pattern) if path.is_file()):
                shutil.copyfile(path, target / path.name)


setup(cmdclass={"build_py": WithLessons})
