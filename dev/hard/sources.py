"""What the code of lessons, package and dev uses that it must not, and settings that would let others into Jupyter."""

import ast
import re
from pathlib import Path

import nbformat
from IPython.core.inputtransformer2 import TransformerManager

from dev.hard.line import none
from dev.lessons import lessons

ROOT = Path(__file__).parents[2]
LESSONS = lessons()
COMMAND = "kflearn/lessons/"  # `kflearn open` starts JupyterLab
MODULES = {"pickle", "marshal", "shelve", "dill", "joblib", "code", "runpy", "pty"}  # text or data made into code
OUTSIDE = {"subprocess", "socket", "urllib", "requests", "http", "asyncio.subprocess", "ctypes", "multiprocessing"}
NAMES = {"eval", "exec", "compile", "__import__", "get_ipython"}
ATTRIBUTES = {"os.system", "os.popen", "yaml.load", "yaml.unsafe_load", "yaml.full_load", "pandas.read_pickle"}
FAMILIES = r"os\.(exec|spawn|posix_spawn)\w*|subprocess\.get(status)?output|asyncio\.create_subprocess\w+"
OPEN = {  # what would open Jupyter to others, in whatever file
    "token": r"token\s*=\s*(''|\"\")(?!\")|\btoken=(\s|$)",
    "password": r"[Pp]assword\s*=\s*(u?''|u?\"\")(?!\")",
    "origin": r"allow_origin\w*\s*=|disable_check_xsrf\s*=|allow_unauthenticated_access\s*=\s*True",
    "address": r"0\.0\.0\.0|--ip=['\"]?(\*|::(?!1))|\ballow_remote_access\s*=\s*True",
}


def faults(source, modules=MODULES):
    """Names of what a piece of Python uses that it must not."""
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import | ast.ImportFrom):
            imported = [node.module or ""] if isinstance(node, ast.ImportFrom) else [each.name for each in node.names]
            found += [name for name in imported if name in modules or name.split(".")[0] in modules]
            if isinstance(node, ast.ImportFrom):
                whole = [f"{node.module}.{each.name}" for each in node.names]
                found += [name for name in whole if name in ATTRIBUTES or re.fullmatch(FAMILIES, name)]
        elif isinstance(node, ast.Name) and node.id in NAMES:
            found.append(node.id)
        elif isinstance(node, ast.Attribute):
            name = ast.unparse(node)
            found += [name] if name in ATTRIBUTES or re.fullmatch(FAMILIES, name) else []
        elif isinstance(node, ast.Call):
            found += unsafe(node)
    return found


def unsafe(call):
    """What is wrong with a call: numpy told to unpickle, a command as one text or given to a shell."""
    words = {word.arg: word.value for word in call.keywords}
    found = [name for name in ("allow_pickle", "shell") if name in words and ast.unparse(words[name]) != "False"]
    if (
        ast.unparse(call.func).startswith("subprocess.")
        and call.args
        and isinstance(call.args[0], ast.Constant | ast.JoinedStr)
    ):
        found.append("a command that is one text")
    return found


def code_cells(path):
    """A lesson's cells as Python: `!` and `%` have become calls of get_ipython()."""
    cells = [cell.source for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == "code"]
    return [TransformerManager().transform_cell(cell) for cell in cells]


def read_code():
    lessons = {f"{path.name} cell {i}": cell for path in LESSONS for i, cell in enumerate(code_cells(path))}
    folders = "", "dev/", "dev/teaching/", "dev/web/", "dev/bench/", "class/", COMMAND
    paths = sorted(path for folder in folders for path in ROOT.glob(f"{folder}*.py"))  # dev/hard plays the attacker
    tools = {str(path.relative_to(ROOT)): path.read_text("utf-8") for path in paths}
    paths = sorted({*(ROOT / "kflearn").rglob("*.py")} - {*paths})
    package = {str(path.relative_to(ROOT)): path.read_text("utf-8") for path in paths}
    for what, sources, modules in (
        ("lessons: shell, process, network, unpickling, eval", lessons, MODULES | OUTSIDE),
        ("kflearn: the same", package, MODULES | OUTSIDE),
        ("dev, class server, command: shell, unpickling, eval", tools, MODULES),
    ):
        found = [f"{fault} in {place}" for place, source in sources.items() for fault in faults(source, modules)]
        yield none(what, found, f"{len(sources)} {'cells' if sources is lessons else 'files'}")


def read_settings():
    """Every text in which Jupyter could be told to let others in."""
    kinds = {".py", ".md", ".yaml", ".yml", ".toml", ".ipynb", ".txt", ".cfg", ".json", ""}
    folders = "class", "kflearn", "notebooks", "dev", "tests", ".ci"
    paths = [*ROOT.glob("*"), *(path for name in folders for path in ROOT.glob(f"{name}/**/*"))]
    paths = [
        path for path in paths if path.is_file() and path.suffix in kinds and not path.name.startswith("test_hard_")
    ]
    found = []
    for path in paths:
        text = path.read_text("utf-8", errors="ignore")
        found += [f"{name} in {path.name}" for name, pattern in OPEN.items() if re.search(pattern, text)]
    yield none("settings that let others into Jupyter", found, f"{len(paths)} files")
