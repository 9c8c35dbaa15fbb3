"""The tests leave out notebooks that are not the course's but somebody's own (`mine-05-…`, `Untitled`, copies)."""

from dev.lessons import FOLDER, notebooks

OURS = set(notebooks())


def pytest_ignore_collect(collection_path):
    if collection_path.suffix == ".ipynb" and collection_path.is_relative_to(FOLDER) and collection_path not in OURS:
        return True
