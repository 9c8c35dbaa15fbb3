"""What is wrong with a function, where it is the solution for other inputs than it was given (two arguments exchanged,
one squared, one left out), or where a part of its results is missing.
"""

import copy
from itertools import combinations, permutations

import numpy as np

from kflearn.exercises._answers import parts
from kflearn.exercises._shown import show

# What is made of one argument, and what is said of a function that is right for that; {a} is the argument's name
CHANGED = [
    (lambda v: v**2, "{a} squared, in place of {a}. Is there a square too many, or a root missing?"),
    (np.sqrt, "√{a}, in place of {a}. Is there a root too many, or a square missing?"),
    (lambda v: 0 * v, "{a} = 0: {a} is left out, or cancels."),
    (lambda v: -v, "−{a}: the sign of {a} is the opposite."),
    (lambda v: 2 * v, "twice {a}, in place of {a}."),
    (lambda v: v / 2, "half of {a}, in place of {a}."),
    (lambda v: 1 / v, "1/{a}, in place of {a}."),
    (lambda v: _square(v).T, "the transpose of {a}, in place of {a}."),
    (lambda v: np.diag(np.diag(_square(v))), "the diagonal of {a} alone: its other entries are not used."),
    (lambda v: _row(v)[:-1], "{a} without its last entry."),
    (lambda v: _row(v)[1:], "{a} without its first entry."),
    (lambda v: _row(v)[::-1], "{a} in the opposite order."),
]  # fmt: skip


def _square(value):
    """The value, where it is a square matrix with something to turn round."""
    if np.ndim(value) != 2 or len(value) != len(np.transpose(value)) or len(value) < 2:
        raise ValueError
    return np.asarray(value)


def _row(value):
    """The value, where it is a series."""
    if np.ndim(value) != 1:
        raise ValueError
    return np.asarray(value)


def as_if(results, exercise, close) -> str | None:
    """What is said of a function that is right for other arguments, in all trials; None where none or several fit.

    Nothing is said where True or False is wanted: in so few bits too much looks alike; nor of NaN alone, or the same
    number in all trials.
    """
    numbers = _numbers(results)
    if numbers is None or not np.isfinite(numbers).any() or np.ptp(numbers) == 0:
        return None
    cases, names = exercise.cases, exercise.parameters
    if isinstance(exercise._solve(*copy.deepcopy(cases[0])), (bool, np.bool_)):
        return None
    fits = lambda change: _fits(results, cases, exercise._solve, close, change)  # noqa: E731
    found = [
        f"{names[i]} and {names[j]} exchanged: look where each of them stands."
        for i, j in combinations(range(len(names)), 2)
        if fits(lambda case, i=i, j=j: _exchanged(case, i, j))
    ]
    for i, j in permutations(range(len(names)), 2):
        if fits(lambda case, i=i, j=j: (*case[:i], case[j], *case[i + 1 :])):
            found = [f"{names[j]} in place of {names[i]}."]
    for i, name in enumerate(names):
        for change, words in CHANGED:
            if name not in exercise.fixed and fits(lambda case, i=i, c=change: (*case[:i], c(case[i]), *case[i + 1 :])):
                found.append(words.format(a=name))
    return f"The result is what would be right for {found[0]}" if len(found) == 1 else None


# Other values of an argument: near by at first; then far below and far above, where a comparison may turn round
NEAR = (lambda v: 1.37 * v + 0.61,)
FAR = (lambda v: 0.02 * v, lambda v: 50 * v + 3, lambda v: -v)


def blind(function, exercise, close) -> str | None:
    """Which argument could have any values, though the result should depend on it; None where there is none.

    An argument that only decides something, as in a comparison, is not lost: far values of it show that.
    """
    for i, name in enumerate(exercise.parameters):
        look = lambda cases, changes, i=i: [  # noqa: E731
            _moves(function, exercise._solve, case, i, close, change) for case in cases for change in changes
        ]
        told = look(exercise.cases, NEAR)
        if told.count(False) >= 3 and True not in told and True not in look(exercise.cases[:4], FAR):
            return f"With other values of {name} the result stayed the same. Where does {name} get lost?"
    return None


def _moves(function, solve, case, i, close, change):
    """Whether a function's numbers change with the argument, where those of the solution do; else None."""
    try:
        if np.asarray(case[i]).dtype.kind == "b":
            return None  # True and False have no other values but each other
        other = (*case[:i], change(np.asarray(case[i], float)), *case[i + 1 :])
        before, after, *right = (each(*copy.deepcopy(c)) for each in (function, solve) for c in (case, other))
        if np.asarray(values(right[0])[0]).dtype.kind != "f" or all(map(close, *map(values, right))):
            return None
        return not all(np.array_equal(*pair) for pair in zip(values(before), values(after), strict=True))
    except Exception:  # values that cannot be changed so
        return None


def same_number(results, rights) -> str:
    """What is said of results that hold one number, the same in all trials; empty of others."""
    numbers, wanted = _numbers(results), _numbers(rights)
    if numbers is None or not numbers.size or np.ptp(numbers) != 0:  # the span of NaN is NaN
        return ""
    what = "The result is" if len(numbers) == len(results) else "All numbers of the result are"
    cut = not numbers.any() and wanted is not None and np.all(abs(wanted) < 1)
    return f"{what} {show(numbers[0])}, in every trial{': do `//` or `int` cut it off?' if cut else '.'}"


def _numbers(results):
    """All numbers of all results in one row; None where something is no real number."""
    arrays = [real(each) for each in results]
    return None if None in arrays else np.concatenate([np.ravel(array) for each in arrays for array in each])


def real(result):
    """The parts of a result as arrays; None where one is not of real numbers: text, True and False, complex numbers."""
    try:
        arrays = [np.asarray(part) for part in values(result)]
    except ValueError:  # rows of unequal length
        return None
    return arrays if all(array.dtype.kind in "iuf" for array in arrays) else None


def _exchanged(case, i, j):
    if np.shape(case[i]) != np.shape(case[j]):
        raise ValueError
    new = list(case)
    new[i], new[j] = case[j], case[i]
    return tuple(new)


def _fits(results, cases, solve, close, change):
    """Whether all results are those of the solution for changed inputs."""
    try:
        for result, case in zip(results, cases, strict=True):
            other = solve(*change(copy.deepcopy(case)))
            rows = [values(each) for each in (result, other)]
            if len(rows[0]) != len(rows[1]) or not all(map(close, *rows)):
                return False
    except Exception:  # inputs that cannot be changed in this way, or a solution that does not take them
        return False
    return True


def values(result):
    return list(result) if isinstance(result, (list, tuple)) else list(parts(result).values()) or [result]


def one_of(results, rights, names, close) -> str | None:
    """What is said of results that are one of several parts that are wanted; None where they are not."""
    wanted = [list(parts(right).values()) for right in rights]
    for i, name in enumerate(names):
        try:
            found = all(close(result, right[i]) for result, right in zip(results, wanted, strict=True))
        except Exception:  # of no form that can be compared
            continue
        if found:
            missing = " and ".join(other for other in names if other != name)
            return f"The result is {name} alone, and it is right. Return {missing} as well: `return …, …`."
    return None


def once_each(told):
    """What is said of the parts of a result, {part: words}, in sentences of which none comes twice."""
    for words in dict.fromkeys(told.values()):
        first, *more = [name for name, same in told.items() if same == words]
        also = f" The same holds of {' and '.join(more)}." if more else ""
        yield f"{first[0].upper()}{first[1:]} of the result {words}{also}"


def of_a_dictionary(exercise, results, rights) -> str | None:
    """What is said of results in dictionaries, where several values are wanted; else, or of rows, None."""
    several = bool(parts(rights[0]))
    if not any(isinstance(result, dict) for result in results) or not (several or np.ndim(rights[0]) == 1):
        return None
    flat = [list(result.values()) if isinstance(result, dict) else result for result in results]
    good = not any(exercise._compare(*pair) for pair in zip(flat, rights, strict=True))
    how = "return the values one after the other, `return …, …`" if several else "return the values in an array"
    return f"{'The values are right, but the' if good else 'The'} result is a dictionary: {how}."
