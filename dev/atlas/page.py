"""The page that `make atlas` writes, notebooks/appendix-libraries.md, from what was found in each library."""

import ast
import textwrap
from pathlib import Path

LIBRARIES = Path(__file__).parent / "libraries"
RETURNED = ("means", "covs", "log_likelihood")
HEAD = """# Appendix · Other libraries

You know a filter in `kflearn` and have to use another library, or the other way round. Libraries differ where nobody looks: in when the start holds, in what becomes of a missing reading, and in what they call a log-likelihood. This page says so for {count} of them. Every cell of the table, and every line of code, was run on {date}.

[Start here](00-start-here.ipynb) · [Notation](appendix-notation.md) · [Glossary](appendix-glossary.md) · [Errata museum](appendix-errata-museum.md) · [Cheat sheet](appendix-cheat-sheet.md) · [Real recordings](appendix-recordings.md) · [What loggers write](appendix-loggers.md)

## What was asked

Three tiny problems were given to each library: a random walk, a position with its velocity whose third reading is missing, and the same with two measured components, one of them missing once. Each library got the belief, the matrices and the readings as they are, NaN for what is missing. The right answers come from no filter: all states and readings are one large Gaussian, and the readings condition it (`dev/atlas/problems.py`).

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
A cell that says *NaN from there on, P stays finite* is the dangerous one: the covariance shrinks as if the reading had been used, so whoever looks at P alone sees nothing.

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

The lines below take the matrices F, H, Q, R, the belief x, P of `kflearn`'s kind and the readings z (T, m), with NaN in gaps. They give the means (T, n), the covariances (T, n, n) and, where the library has one, the log-likelihood of `kflearn`. `np` is NumPy. The figure behind *same numbers* is the largest difference from the exact answer in the first two problems.
"""


def parts(path):
    """The title and the remarks of a library's file, and its code for the page."""
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


def row(title, found):
    cells = [f"{title} {found['version']}", found["start"] or "neither", *(found[name] for name in ROW)]
    return f"| {' | '.join(cells)} |\n"


ROW = ("gap", "part", "likelihood", "negative")


def section(path, found):
    """What the page says of one library."""
    title, remarks, code = parts(path)
    text = f"\n### {title}\n\n{remarks} Same numbers: to {found['same']:.0e}.\n\n"
    return text + "```python\n" + "\n".join(code) + "\n```\n"


def page(results, date, untried):
    """The whole page. results: {file: what was found}, untried: what could not be installed, and why."""
    rows = "".join(row(parts(path)[0], found) for path, found in results.items())
    sections = "".join(section(path, found) for path, found in results.items())
    text = HEAD.format(count=len(results), date=date) + rows + READ + sections
    return text + f"\n## Not tried\n\n{untried}\n"
