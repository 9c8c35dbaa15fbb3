"""The page that `make atlas` writes, notebooks/appendix-libraries.md, from what was found in each library."""

import ast
import textwrap
import zlib
from pathlib import Path

from dev.atlas.languages import LANGUAGES
from dev.atlas.programs import read

LIBRARIES = Path(__file__).parent / "libraries"
RETURNED = ("means", "covs", "log_likelihood")
HEAD = """# Appendix · Other libraries

You know a filter in `kflearn` and have to use another library, or the other way round. Libraries differ where nobody looks: in when the start holds, in what becomes of a missing reading, and in what they call a log-likelihood. This page says so for {count} of them. Every cell of the table, and every line of code, {ran}. [Lesson 29](29-take-it-to-your-library.ipynb) takes one filter to three of these libraries, step by step.

[Start here](00-start-here.ipynb) · [Notation](appendix-notation.md) · [Glossary](appendix-glossary.md) · [Errata museum](appendix-errata-museum.md) · [Cheat sheet](appendix-cheat-sheet.md) · [Real recordings](appendix-recordings.md) · [What loggers write](appendix-loggers.md)

## What was asked

There are three tiny problems, and each library got those that it can take: a random walk, a position with its velocity whose third reading is missing, and the same with two measured components, one of them missing once. Each library got the belief, the matrices and the readings as they are, NaN (in R and gretl NA) for what is missing. The right answers come from no filter: all states and readings are one large Gaussian, and the readings condition it (`dev/atlas/problems.py`).

- **Start:** does the belief hold one step before the first reading, so that the filter predicts first, or at the first reading?
- **A gap:** what becomes of a reading that is NaN?
- **Half a reading:** two components are measured and one is NaN. Is the other one used?
- **Log-likelihood:** of all readings. *With log 2π* means that it is the logarithm of their density.
- **R = −1:** no variance is negative. Does the library say so?

| library | start | a gap | half a reading | log-likelihood | R = −1 |
|---|---|---|---|---|---|
| `kflearn` | one step before the first reading | skipped | the other part is used | with log 2π | refused (ValueError) |
"""
READ = """
A cell that says *NaN from there on, P stays finite* is the dangerous one: the covariance shrinks as if the reading had been used, so P alone does not show it.

## From one start to the other

A library of the kind *at the first reading* wants the belief `to_first_reading(model, initial)`, which is F x and F P Fᵀ + Q. The lines below write it out. In the other direction, `from_first_reading(model, len(z))` makes a model for `kflearn` whose first step changes nothing; then the belief of such a library can be handed over as it is, and no likelihood is lost.

```python
from kflearn import Gaussian, LinearModel, from_first_reading, kalman_filter, to_first_reading

model, initial = LinearModel(F, H, Q, R), Gaussian(x, P)
track = kalman_filter(model, z, initial)
theirs = to_first_reading(model, initial)  # a start for the others
again = kalman_filter(from_first_reading(model, len(z)), z, theirs)  # and back: the same track
```

## The same numbers in each library

The lines below take the matrices F, H, Q, R, the belief x, P of `kflearn`'s kind and the readings z (T, m), with NaN in gaps. They give the means (T, n), the covariances (T, n, n) and, where they name `log_likelihood`, that of `kflearn`. `np` is NumPy. The figure behind *same numbers* is the largest difference from the exact answer in the first two problems, which have no half readings. Half a reading is used by the lines of those libraries only of which the table says that *the other part is used*; with the lines of the others it is dropped, or the means are NaN from there on.
"""
OTHERS = """
## The same numbers outside Python

These lines are in the library's own language. F, H, Q, R, x, P and z are matrices there: x is a column, and z has a row for each reading, with NA (R, gretl) or NaN (Octave, JavaScript) in gaps. They leave the means, a row for each reading, and the covariances: `covs[t, , ]` in R, a row for each reading in gretl, `covs(:, :, t)` in Octave, and a list in JavaScript.
"""


def paths():
    """The libraries' files in the order of the page, Python first."""
    others = [path for path in LIBRARIES.iterdir() if path.suffix in LANGUAGES]
    return sorted(LIBRARIES.glob("*.py")) + sorted(others, key=lambda path: parts(path)[0].lower())


def parts(path):
    """The title and the remarks of a library's file, and its code for the page."""
    if path.suffix in LANGUAGES:
        library = read(path)
        return library.title, library.remarks, library.same.splitlines()
    text = path.read_text(encoding="utf-8")
    tree = ast.parse(text)
    title, _, remarks = ast.get_docstring(tree).partition("\n")
    (same,) = (node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == "same")
    return title, " ".join(remarks.split()), [*imported(text, tree), "", *lines(text, same)]


def imported(text, tree):
    """The lines between the docstring and PINS, without NumPy's import."""
    pins = next(node for node in tree.body if isinstance(node, ast.Assign))
    top = text.splitlines()[tree.body[0].end_lineno : pins.lineno - 1]
    return "\n".join(line for line in top if line != "import numpy as np").strip().splitlines()


def lines(text, function):
    """The lines of a function's body; what it returns gets names."""
    *body, last = function.body
    before = text.splitlines()[body[0].lineno - 1 : last.lineno - 1]
    made = [(name, ast.get_source_segment(text, part)) for name, part in zip(RETURNED, last.value.elts, strict=False)]
    named = [f"{name} = {part}" for name, part in made if name != part]
    return [*textwrap.dedent("\n".join(before)).splitlines(), *named]


def pinned(path):
    """What is installed for a library: its line PINS."""
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign) and node.targets[0].id == "PINS":
            return ast.literal_eval(node.value)
    raise ValueError(f"{path.name} has no PINS")


def checksum(path):
    """Tells whether the lines on the page are those that were run."""
    return zlib.crc32("\n".join(parts(path)[2]).encode())


def row(title, found):
    cells = [f"{title} {found['version']}", found["start"] or "neither", *(found[name] for name in ROW)]
    return f"| {' | '.join(cells)} |\n"


ROW = ("gap", "part", "likelihood", "negative")


def section(path, found):
    """What the page says of one library."""
    title, remarks, code = parts(path)
    fence = LANGUAGES[path.suffix].fence if path.suffix in LANGUAGES else "python"
    text = f"\n### {title}\n\n{remarks} Same numbers: to {found['same']:.0e}.\n\n"
    return text + f"```{fence}\n" + "\n".join(code) + "\n```\n"


def ran(results):
    """The day on which the rows were found, and which of them are older."""
    newest = max(found["on"] for found in results.values())
    older = [f"{parts(path)[0]} on {found['on']}" for path, found in results.items() if found["on"] < newest]
    stayed = f"; where the program was not installed on that day, the row is an older one: {', '.join(older)}"
    return f"was run on {newest}" + (stayed if older else "")


def page(results, untried):
    """The whole page. results: {file: what was found}, untried: what was not run."""
    rows = "".join(row(parts(path)[0], found) for path, found in results.items())
    ours, others = ("".join(section(path, found) for path, found in results.items() if (path.suffix == ".py") == python)
                    for python in (True, False))  # fmt: skip
    text = HEAD.format(count=len(results), ran=ran(results)) + rows + READ + ours + OTHERS + others
    return text + f"\n## Not tried\n\n{untried}\n"
