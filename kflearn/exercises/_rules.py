"""What is wrong with a result, where the mistake is one that learners make in every exercise: a root for a square, two
results in the wrong order, rounding inside the function, an argument that was not used.

The exercises' own sentences come first. A rule speaks only where it explains all trials.
"""

import copy
import dis
import inspect
import re

import numpy as np

from kflearn.exercises import _rules_inputs
from kflearn.exercises._answers import parts

# What each rule makes of the right result, and what is said of an answer that is equal to that
TRANSFORMS = [
    (lambda r: np.sqrt(r), "is the square root of what is wanted. Is there a root too many, or a square missing?"),
    (lambda r: r**2, "is the square of what is wanted. Is there a square too many, or a root missing?"),
    (lambda r: np.where((abs(r) > 0.01) & (abs(r) < 100), 1 - r, np.nan), "is 1 minus what is wanted."),
    (lambda r: 1 / r, "is 1 divided by what is wanted."),
    (lambda r: 2 * r, "is twice what is wanted."),
    (lambda r: r / 2, "is half of what is wanted."),
    (lambda r: -r, "has the opposite sign."),
    (lambda r: np.degrees(r), "is 180/π times what is wanted: degrees in place of radians?"),
    (lambda r: np.radians(r), "is π/180 times what is wanted: radians in place of degrees?"),
    (lambda r: 100 * r, "is 100 times too large: in per cent, or in centimetres?"),
    (lambda r: r / 100, "is 100 times too small: metres for centimetres, or a share for per cent?"),
    (lambda r: r.T if r.ndim == 2 else np.nan, "is the transpose of what is wanted."),
    (lambda r: np.eye(len(r)) - r if r.ndim == 2 and len(r) == len(r.T) else np.nan, "is I minus what is wanted."),
]  # fmt: skip
MOVED = "holds the right numbers, but not all of them at their places."
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
    rows = [row(result, len(names)) for result in results]
    if any(each is None for each in rows):
        return _rules_inputs.one_of(results, rights, names, close)
    wanted = [list(parts(right).values()) for right in rights]
    pairs = list(zip(rows, wanted, strict=True))
    if all(close(one, other) for mine, right in pairs for one, other in zip(mine, reversed(right), strict=True)):
        return f"The results are right, but they are wanted in the other order{_first(names[0])}."
    if len(names) > 2 and all(np.ndim(each) == 0 for each in (*rows[0], *wanted[0])) and _moved(pairs, close):
        return "The results are right, but they are wanted in another order."
    told = {}
    for i, name in enumerate(names):
        mine, theirs = [each[i] for each in rows], [right[i] for right in wanted]
        if not all(map(close, mine, theirs)):
            told[name] = _relation(mine, theirs, close)
    by_chance = len(results) == 1 and len(set(told.values())) > 1  # two numbers that are related in two ways
    if not told or None in told.values() or by_chance:
        return None
    others = "The rest is right. " if len(told) < len(names) else ""
    return others + " ".join(_rules_inputs.once_each(told))


def _first(name):
    """Which part comes first, where it has a name."""
    return "" if name.startswith("value") else f": first {name}"


def row(result, count):
    """The parts of a result with so many parts, as a list; None where it has another number."""
    found = list(result) if isinstance(result, (list, tuple)) else list(parts(result).values())
    return found if len(found) == count else None


def _relation(results, rights, close):
    """What all results are of what was wanted, in words; None where they are nothing that has a name."""
    try:
        pairs = [(np.asarray(one), np.asarray(other)) for one, other in zip(results, rights, strict=True)]
    except (TypeError, ValueError, OverflowError):  # rows of unequal length, and what else is no array
        return None
    if any(one.shape != other.shape or {one.dtype.kind, other.dtype.kind} - set("iuf") for one, other in pairs):
        return None
    with np.errstate(all="ignore"):
        found = [
            words
            for change, words in TRANSFORMS
            if all(_equal(close, one, change(right), right) for one, right in pairs)
        ]
    if found or len(pairs) == 1:
        return found[0] if len(found) == 1 else MOVED if not found and _moved(pairs, close) else None
    return _rounded(pairs) or (MOVED if _moved(pairs, close) else _constant(pairs, close))


def _moved(pairs, close):
    """The right numbers, of which there are more than one, at other places."""
    flat = [(np.sort(np.ravel(one)), np.sort(np.ravel(other))) for one, other in pairs]
    return flat[0][1].size > 1 and all(one.shape == other.shape and close(one, other) for one, other in flat)


def _constant(pairs, close):
    """The same factor in all trials, or the same term."""
    ones, others = (
        np.concatenate([np.ravel(part) for part in side]).astype(float) for side in zip(*pairs, strict=True)
    )
    if not (np.isfinite(ones).all() and np.isfinite(others).all()) or np.ptp(others) == 0 or not others.any():
        return None
    factor, term = ones @ others / (others @ others), np.mean(ones - others)
    scale = abs(others).max()
    if abs(factor) > 1e-6 and all(close(one, factor * other) for one, other in pairs) and abs(factor - 1) > 1e-3:
        return f"is {factor:.4g} times what is wanted, in every trial: a factor is wrong, or missing."
    if abs(term) > 1e-3 * scale and all(np.ndim(one) == 0 and close(one, other + term) for one, other in pairs):
        size = "larger" if term > 0 else "smaller"
        return f"is {size} by {abs(term):.4g} than what is wanted, in every trial: a term is wrong, or missing."
    return None


def _equal(close, one, other, right):
    """Equal, where the relation makes a finite number of each that was wanted."""
    missing = np.isnan(right) if np.shape(other) == np.shape(right) else False
    return bool((np.isfinite(other) | missing).all()) and close(one, other)


def _rounded(pairs):
    """Rounded or cut off inside the function; of zeros alone that cannot be told."""
    if not any(result.any() for result, _ in pairs):
        return None
    for digits in range(5):
        if all((np.round(right, digits) == result).all() for result, right in pairs):
            return f"is rounded to {digits} digits after the point: return all of them, and round only what you print."
    if any(all((cut(right) == result).all() for result, right in pairs) for cut in (np.floor, np.trunc)):
        return "lacks its digits after the point: `//` and `int` cut them off, and so does an array of whole numbers."
    return None


def unused(function, solve, cases, names, close) -> list:
    """The names of the arguments on which the function's result does not depend, though it should.

    Each argument is put in from another trial: one in which all arguments have the same shapes, or any other where
    there is one argument only. An argument that the learner's own code reads is not named: it may cancel, or the
    trials may not show what it does.
    """
    return [
        name
        for i, name in enumerate(names)
        if not _reads(function, i) and _matters(function, solve, cases, i, close) == (True, False)
    ]


def _matters(function, solve, cases, i, close):
    """Whether argument i matters: to the solution, in two trials at least, and to the learner's function in any."""
    seen, needed = False, 0
    for number, case in enumerate(cases):
        alike = [each for each in cases[number + 1 :] if len(case) == 1 or _shapes(each) == _shapes(case)]
        for other in alike[:2]:
            mixed = (*case[:i], other[i], *case[i + 1 :])
            try:
                wanted = not _same(solve, case, mixed, close)
                seen = seen or (wanted and not _same(function, case, mixed, close))
                needed += wanted
            except Exception:
                continue
        if seen or needed >= 4:
            break
    return needed >= 2, seen


def _reads(function, i) -> bool:
    """Whether a function's own code reads its argument number i, as far as the code can be looked at."""
    code = getattr(function, "__code__", None)  # of a method as well
    i += inspect.ismethod(function)
    if code is None or _overwritten(code, i):
        return False
    if i >= code.co_argcount:
        return True  # it comes in by a star: whatever is done with it cannot be seen
    name = code.co_varnames[i]
    steps = [step for step in dis.get_instructions(code) if re.search("FAST|DEREF|CLOSURE", step.opname)]
    read = [step.argval for step in steps if not step.opname.startswith(("STORE", "DELETE"))]
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
    "those that fail have a NaN": lambda case, first: has_nan(case),
    "those that fail have a negative number": lambda case, first: any((_flat(part) < 0).any() for part in case),
    "those that fail have another size than the first trial": lambda case, first: _shapes(case) != _shapes(first),
    "those that fail have a zero": lambda case, first: any((_flat(part) == 0).any() for part in case),
}


def _flat(part):
    try:
        return np.ravel(np.asarray(part, float))
    except (TypeError, ValueError):
        return np.zeros(0) + np.inf


def has_nan(case):
    """Whether a trial's inputs hold a NaN."""
    return any(bool(np.isnan(_flat(part)).any()) for part in case)


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


def raises(function, case, kind) -> bool:
    """Whether a function raises such an error."""
    try:
        function(*copy.deepcopy(case))
    except Exception as error:
        return isinstance(error, kind)
    return False
