"""The part "lessons" of `make check-hard`: it works, and it sees a fault where there is one."""

import sys

import nbformat
import pytest

from dev.hard import lessons
from dev.hard.kernels import Machine, code_cells, kernel, newest_python, oldest_pins, pythons, version

pytestmark = pytest.mark.timeout(300)
FAULTY = [
    "left_out = 1",
    "import urllib.request\nprint(left_out)",
    "print(open('new', 'w').name)",
    "count = globals().get('count', 0) + 1\nprint(count)",
    "1 / 0",
    "misspelt",
    "urllib.request.urlopen('http://192.0.2.1/', timeout=1)",
]


@pytest.fixture
def faulty(tmp_path):
    """A lesson with every fault the part looks for."""
    cells = [nbformat.v4.new_code_cell(cell) for cell in FAULTY]
    cells[1].outputs = [nbformat.v4.new_output("stream", text="1\n")]
    cells[3].outputs = [nbformat.v4.new_output("stream", text="1\n")]
    path = tmp_path / "99-faulty.ipynb"
    nbformat.write(nbformat.v4.new_notebook(cells=cells), path)
    return path


def test_errors_that_a_cell_left_out_explains_and_others(faulty, tmp_path):
    with kernel(faulty, folder=tmp_path) as client:
        cells = code_cells(client.nb)
        found = lessons.unexplained(client, cells, [*cells[1:2], *cells[4:6]])
    assert [fault.partition(":")[0] for fault in found] == ["cell 4, ZeroDivisionError", "cell 5, NameError"]


def test_a_machine_without_network_and_rights(faulty):
    where, folder, network = lessons.on_machine("here", sys.executable, "GBK", [faulty], 2)
    assert not (where.ok or network.ok) and folder.ok, (where, folder, network)
    assert where.measured.startswith("10 of 1 lessons twice: 99 cell 2, "), where
    assert network.measured == "2, 2 of ours refused"


def test_the_course_names_its_encodings_and_nobody_else_has_to():
    machine = Machine(env=dict(HARD_LOG="log", PYTHONWARNDEFAULTENCODING="1"))
    code = "try: print('opened', *exec('open(0, closefd=False)', dict(__name__={!r})) or [])\n"
    code += "except EncodingWarning: print('refused')"
    assert lessons.output(machine, code.format("kflearn.ui.plots")) == "refused"
    assert lessons.output(machine, code.format("elsewhere")) == "opened"


def test_files_without_an_encoding(tmp_path):
    (tmp_path / "a.py").write_text("open('x')\nopen('y', encoding='utf-8')\n", encoding="utf-8")
    assert lessons.unnamed_encodings(tmp_path) == ["a.py:1"]
    assert lessons.unnamed_encodings("kflearn", "dev", "class") == []


def test_pythons_and_packages():
    assert version(sys.executable) in pythons() and version("false") is None
    assert version(newest_python()) >= version(sys.executable)
    assert "numpy==2.2.*" in oldest_pins() and "jupyterlab==4.4.*" in oldest_pins()
    assert "HARD_LOG" not in Machine().variables()


def test_it_works():
    assert [line for line in lessons.lines(True) if not line.ok] == []
