"""The house: rooms that build on one another, short files and functions, names of our own, examples that run."""

import ast
import inspect
import re
import sys
from functools import cache
from pathlib import Path

import pytest

import kflearn

ROOT = Path(__file__).parent.parent
FILES = {
    path.relative_to(ROOT).as_posix(): path
    for part in ("kflearn", "dev", "tests")
    for path in (ROOT / part).rglob("*.py")
}
PACKAGE = [name for name in FILES if name.startswith("kflearn/")]
LONGEST_FILE, LONGEST_FUNCTION = 300, 30  # lines; of a function without its docstring
HOOKS = {"sitecustomize"}  # a name by which Python itself looks for a file


@cache
def tree(name):
    return ast.parse(FILES[name].read_text(encoding="utf-8"))


# ---- lengths


@pytest.mark.parametrize("part", ["kflearn", "dev", "tests"])
def test_no_file_is_long(part):
    lines = {
        name: path.read_text(encoding="utf-8").count("\n") for name, path in FILES.items() if name.startswith(part)
    }
    assert {name: count for name, count in lines.items() if count > LONGEST_FILE} == {}


def length(function):
    """Lines of a function from `def` to its end, without its docstring."""
    first = function.body[0]
    documented = ast.get_docstring(function) is not None
    return function.end_lineno - function.lineno + 1 - documented * (first.end_lineno - first.lineno + 1)


def functions(name):
    return [node for node in ast.walk(tree(name)) if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)]


@pytest.mark.parametrize("part", ["kflearn", "dev", "tests"])
def test_no_function_is_long(part):
    lengths = {
        f"{name} {each.name}": length(each) for name in FILES if name.startswith(part) for each in functions(name)
    }
    assert {function: lines for function, lines in lengths.items() if lines > LONGEST_FUNCTION} == {}


# ---- names


def test_no_module_has_the_name_of_one_of_pythons_own():
    names = {part for name in FILES for part in Path(name).with_suffix("").parts[1:]}
    assert (names - HOOKS) & sys.stdlib_module_names == set()


def test_nobody_edits_the_path_on_which_modules_are_found():
    edit = "sys" + ".path"
    places = [*FILES.values(), *ROOT.glob("*.py"), *(ROOT / "class").glob("*.py")]
    assert [path.name for path in places if edit in path.read_text(encoding="utf-8")] == []


# ---- rooms


def drawn():
    """{room: rooms that it may import} as CONTRIBUTING.md draws them, in the order of the stack."""
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    rows = re.findall(r"^  (\w+)/ .*← (.*)$", text, re.MULTILINE)
    return {room: set(re.findall(r"\w+", may)) - {"nothing"} for room, may in rows}


def module_of(name):
    """kflearn/core/angles.py → kflearn.core.angles; a package's __init__.py → the package."""
    return ".".join(Path(name).with_suffix("").parts).removesuffix(".__init__")


def room_of(module):
    """kflearn.core.angles → core; of kflearn itself, and of what is not kflearn's, its first name."""
    first, *rest = module.split(".")
    return rest[0] if first == "kflearn" and rest else first


@cache
def imports(name):
    """The modules that a file of ours imports, wherever in the file; those of kflearn, dev and tests."""
    package = module_of(name) if name.endswith("__init__.py") else module_of(name).rpartition(".")[0]
    found, ours = set(), {module_of(each) for each in FILES}
    for node in ast.walk(tree(name)):
        if isinstance(node, ast.Import):
            found |= {each.name for each in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = ".".join(package.split(".")[: len(package.split(".")) + 1 - node.level]) if node.level else ""
            base = ".".join(filter(None, [base, node.module]))
            found |= {whole if (whole := f"{base}.{each.name}") in ours else base for each in node.names}
    return {module for module in found if module.split(".")[0] in ("kflearn", "dev", "tests")} & ours


def test_the_drawing_shows_all_rooms_and_nothing_but_a_stack():
    folders = {path.parent.name for path in (ROOT / "kflearn").glob("*/__init__.py")}
    assert set(drawn()) == folders
    below = set()
    for room, may in drawn().items():
        assert may <= below, f"{room} is below what it may import"
        below.add(room)


def test_each_room_imports_what_the_drawing_allows():
    """The top of the stack also uses kflearn as a learner does, by its public names."""
    *_, top = drawn()
    wrong = []
    for name in PACKAGE:
        room = room_of(module_of(name))
        if room == "kflearn":
            continue
        may = drawn()[room] | {room} | ({"kflearn"} if room == top else set())
        wrong += [f"{name} imports {module}" for module in imports(name) if room_of(module) not in may]
    assert wrong == []


def test_importing_the_package_opens_neither_ui_nor_exercises():
    assert {room_of(module) for module in imports("kflearn/__init__.py")} & {"ui", "exercises", "dev", "tests"} == set()


def test_no_module_imports_itself_by_way_of_others():
    graph = {module_of(name): imports(name) - {module_of(name)} for name in PACKAGE}
    while graph:  # take away what imports nothing that is left
        free = {module for module, needs in graph.items() if not needs & graph.keys()}
        assert free, f"a circle among {sorted(graph)}"
        graph = {module: needs for module, needs in graph.items() if module not in free}


# ---- public names


EXPLAINED = [name for name in kflearn.__all__ if name != "FILTERS"]  # a table, whose rows explain themselves


@pytest.mark.parametrize("name", EXPLAINED)
def test_each_public_name_is_documented_with_an_example(name):
    thing = getattr(kflearn, name)
    assert ">>>" in (inspect.getdoc(thing) or ""), f"kflearn.{name} has no example"
    if inspect.isfunction(thing):
        assert "return" in thing.__annotations__, f"kflearn.{name} does not say what it returns"


def test_every_name_is_in_the_order_of_the_alphabet_once():
    assert kflearn.__all__ == sorted(set(kflearn.__all__), key=lambda name: (name.islower(), name))
