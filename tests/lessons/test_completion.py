"""What the Tab key offers in a lesson: the public names of the package, and nothing else."""

from pathlib import Path

import pytest
from jupyter_client.manager import start_new_kernel

import kflearn
from kflearn import ui
from kflearn.ui import plots

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"


@pytest.fixture(scope="module")
def kernel():
    """A kernel that has imported the package, as after the first cell of a lesson."""
    manager, client = start_new_kernel(kernel_name="python3", cwd=str(NOTEBOOKS), extra_arguments=["--log-level=ERROR"])
    try:
        code = "import kflearn\nfrom kflearn import plots\nfrom kflearn.exercises import voltmeter as exercises"
        reply = client.execute_interactive(code, timeout=60)
        assert reply["content"]["status"] == "ok"
        yield client
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)


def offered(client, code):
    """The names that the Tab key offers after `code`, as a notebook asks for them."""
    content = client.complete(code, reply=True, timeout=60)["content"]
    start = code.rindex(".") + 1
    return {code[: content["cursor_start"]][start:] + match.rpartition(".")[2] for match in content["matches"]}


@pytest.mark.parametrize(
    ("code", "names"),
    [
        ("kflearn.", kflearn.__all__),
        ("plots.", plots.__all__),
        ("kflearn.ui.", ui.__all__),
        ("exercises.steady_gain.", ["check", "hint", "solution"]),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_only_public_names_are_offered(kernel, code, names):
    assert offered(kernel, code) == set(names)


def test_a_beginning_is_completed(kernel):
    assert offered(kernel, "kflearn.kalman") == {"kalman_filter", "kalman_step"}


@pytest.mark.parametrize("module", [kflearn, plots, ui], ids=lambda module: module.__name__)
def test_the_names_are_public_and_exist(module):
    assert dir(module) == sorted(module.__all__)
    assert not [name for name in module.__all__ if not hasattr(module, name) or name.startswith("_")]
