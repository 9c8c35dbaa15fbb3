"""What is wrong with a result, where the mistake is one that learners make in every exercise: a root for a square, two
results in the wrong order, rounding inside the function, an argument that was not used.

The exercises' own sentences come first. A rule speaks only where it explains all trials.
"""

import copy
import dis
import inspect
import re
from itertools import pairwise

import numpy as np

from kflearn.exercises._answers import parts

# What each rule makes of the right result, and what is said of an answer that is equal to that
TRANSFORMS = [
    (lambda r: np.sqrt(r), "is the square root of what is wanted: a root too many, or a square that is missing."),
    (lambda r: r**2, "is the square of what is wanted: a square too many, or a root that is missing."),
    (lambda r: 1 - r, "is 1 minus what is wanted: the other part of the whole."),
    (lambda r: 1 / r, "is 1 divided by what is wanted."),
    (lambda r: 2 * r, "is twice what is wanted."),
    (lambda r: r / 2, "is half of what is wanted."),
    (lambda r: -r, "has the opposite sign."),
    (lambda r: np.degrees(r), "is in degrees; radians are wanted."),
    (lambda r: np.radians(r), "is in radians; degrees are wanted."),
    (lambda r: 100 * r, "is 100 times too large: in per cent, or in centimetres?"),
    (lambda r: r / 100, "is 100 times too small: metres for centimetres, or a share for per cent?"),
    (lambda r: r.T if r.ndim == 2 else np.nan, "is the transpose of what is wanted."),
    (lambda r: np.eye(len(r)) - r if r.ndim == 2 and len(r) == len(r.T) else np.nan, "is I minus what is wanted."),
]  # fmt: skip
CHANGES = (
    "Called twice with the same inputs, your function gives two different results: it draws random numbers of its own, "
    "or keeps something from call to call. Use what it is given, and nothing else."
)


def sentence(results, rights, close) -> str | None:
    """What explains all results at once; None where no rule does.

    Parameters
    ----------
    results, rights : list
        What the learner's function returned in each trial, and what was wanted.
    close : function(one, other)
        Whether two numbers or arrays are equal within the exercise's tolerances.
    """
    names = list(parts(rights[0]))
    if not names:
        words = _relation(results, rights, close)
        return words and f"The result {words}"
    rows = [_row(result, len(names)) for result in results]
    if any(row is None for row in rows):
        return None
    wanted = [list(parts(right).values()) for right in rights]
    pairs = list(zip(rows, wanted, strict=True))
    if all(close(one, other) for row, right in pairs for one, other in zip(row, reversed(right), strict=True)):
        return f"The results are right, but they are wanted in the other order{_first(names[0])}."
    told = {}
    for i, name in enumerate(names):
        mine, theirs = [row[i] for row in rows], [right[i] for right in wanted]
        if not all(map(close, mine, theirs)):
            told[name] = _relation(mine, theirs, close)
    if not told or None in told.values():
        return None
    others = "The rest is right. " if len(told) < len(names) else ""
    return others + " ".join(f"{name[0].upper()}{name[1:]} of the result {words}" for name, words in told.items())


def _first(name):
    """Which part comes first, where it has a name."""
    return "" if name.startswith("value") else f": first {name}"


def _row(result, count):
    """The parts of a result with so many parts, as a list; None where it has another number."""
    found = list(result) if isinstance(result, (list, tuple)) else list(parts(result).values())
    return found if len(found) == count else None


def _relation(results, rights, close):
    """What all results are of what was wanted, in words; None where they are nothing that has a name."""
    try:
        pairs = [(np.asarray(one), np.asarray(other)) for one, other in zip(results, rights, strict=True)]
    except (TypeError, ValueError, OverflowError):  # rows of unequal length, and what else is no array
        return None
    if any(one.shape != other.shape or one.dtype.kind not in "iuf" for one, other in pairs):
        return None
    with np.errstate(all="ignore"):
        found = [
            words for change, words in TRANSFORMS if all(_equal(close, one, change(right)) for one, right in pairs)
        ]
    return found[0] if len(found) == 1 else _rounded(pairs) if not found and len(pairs) > 1 else None


def _equal(close, one, other):
    """Equal, where the relation makes a finite number of what was wanted."""
    return bool(np.isfinite(other).all()) and close(one, other)


def _rounded(pairs):
    """Rounded or cut off inside the function."""
    for digits in range(5):
        if all((np.round(right, digits) == result).all() for result, right in pairs):
            return f"is rounded to {digits} digits after the point: return all of them, and round only what you print."
    if all((np.floor(right) == result).all() for result, right in pairs):
        return "lacks its digits after the point: `//` and `int` cut them off, and so does an array of whole numbers."
    return None


def unused(function, solve, cases, names, close) -> str | None:
    """The name of an argument on which the function's result does not depend, though it should; None if there is none.

    Each argument is put in from another trial, where that trial's arguments have the same shapes. An argument that the
    learner's own code reads is not named: it may cancel, or the trials may not show what it does.
    """
    for i, name in enumerate(names):
        if _reads(function, i):
            continue
        seen, needed = 0, 0
        for case, other in pairwise(cases):
            if _shapes(case) != _shapes(other):
                continue
            mixed = (*case[:i], other[i], *case[i + 1 :])
            try:
                wanted = not _same(solve, case, mixed, close)
                if wanted and not _same(function, case, mixed, close):
                    seen += 1
                needed += wanted
            except Exception:
                continue
        if needed >= 2 and not seen:
            return name
    return None


def _reads(function, i) -> bool:
    """Whether a function's own code reads its argument number i, as far as the code can be looked at."""
    code = getattr(function, "__code__", None)  # of a method as well
    i += inspect.ismethod(function)
    if code is None or _overwritten(code, i):
        return False
    if i >= code.co_argcount:
        return True  # it comes in by a star: whatever is done with it cannot be seen
    name = code.co_varnames[i]
    read = [step.argval for step in dis.get_instructions(code) if not step.opname.startswith(("STORE", "DELETE"))]
    return any(name == one or (isinstance(one, tuple) and name in one) for one in read)


def _overwritten(code, i) -> bool:
    """Whether a function gives its argument number i another value before it reads it."""
    name = code.co_varnames[i] if i < code.co_argcount else None
    uses = (step for step in dis.get_instructions(code) if "FAST" in step.opname and step.argval == name)
    first = next(uses, None)
    return first is not None and first.opname == "STORE_FAST"


def _shapes(case):
    return [np.shape(part) for part in case]


def _same(function, case, other, close):
    one, two = function(*copy.deepcopy(case)), function(*copy.deepcopy(other))
    rows = [list(parts(result).values()) or [result] for result in (one, two)]
    return all(close(a, b) for a, b in zip(*rows, strict=True))


def share(good, cases) -> str:
    """In how many trials the function is right, and what sets those apart in which it is not; else an empty string."""
    if not any(good) or all(good):
        return ""
    count = f"It is right in {sum(good)} of {len(good)} trials"
    for words, has in TRAITS.items():
        holds = [has(case, cases[0]) for case in cases]
        if holds == [not one for one in good]:
            return f"{count}; {words}."
    return f"{count}."


TRAITS = {
    "those that fail have a NaN": lambda case, first: any(_nan(part) for part in case),
    "those that fail have a negative number": lambda case, first: any((_flat(part) < 0).any() for part in case),
    "those that fail have another size than the first trial": lambda case, first: _shapes(case) != _shapes(first),
    "those that fail have a zero": lambda case, first: any((_flat(part) == 0).any() for part in case),
}


def _flat(part):
    try:
        return np.ravel(np.asarray(part, float))
    except (TypeError, ValueError):
        return np.zeros(0) + np.inf


def _nan(part):
    return np.isnan(_flat(part)).any()


def changes(function, results, cases) -> bool:
    """Whether a function, called once more with the inputs of the first trials, gives something else."""
    for case, result in list(zip(cases, results, strict=False))[:3]:
        try:
            again = function(*copy.deepcopy(case))
            rows = [list(parts(each).values()) or [each] for each in (again, result)]
            numbers = [[np.asarray(part, float) for part in row] for row in rows]
            if any(not np.array_equal(a, b, equal_nan=True) for a, b in zip(*numbers, strict=True)):
                return True
        except Exception:  # no numbers, or an error in the second call
            return False
    return False


def source_has(function, pattern) -> bool:
    """Whether a function's source holds a pattern, as far as it can be read."""
    try:
        return re.search(pattern, inspect.getsource(function)) is not None
    except (OSError, TypeError):
        return True  # it cannot be read: nothing speaks against it


def raises(function, case, kind) -> bool:
    """Whether a function raises such an error."""
    try:
        function(*copy.deepcopy(case))
    except Exception as error:
        return isinstance(error, kind)
    return False
