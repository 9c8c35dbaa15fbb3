"""What is wrong with an answer, said in plain words, for the exercise engine.

An answer may be any object at all: one that fights back may raise here, and the engine says that it cannot be read.
The words are deterministic (no addresses, no folders), so that a saved notebook can be compared with a new run.
"""

import re

import numpy as np

from kflearn.exercises._shown import ENTRIES_SHOWN, count, form, is_gaussian, show
from kflearn.exercises._words import of_text, plain, without_names


class Misfit(Exception):
    """An answer of the wrong form; the text says what it is instead."""


def fault(answer, right, subject, rtol, atol, reveal, by_hand=False, related=True) -> str | None:
    """What is wrong with an answer.

    Parameters
    ----------
    answer : object
        Anything at all.
    right : number, array, Gaussian or tuple of these
    subject : str
        What the sentence calls the answer; empty where only the comparison matters.
    rtol, atol : float
        Tolerances, as in `numpy.isclose`; with atol None, 1e-12 of the largest number in `right`.
    reveal : bool
        Whether the sentence may show the right answer.
    by_hand : bool
        Whether the numbers were typed: then three digits are enough, unless whole numbers are wanted.
    related : bool
        Whether a sign or a power of ten may be named: of several wrong parts only if it is the same for all.

    Returns
    -------
    str or None
        A sentence without its capital letter; None if nothing is wrong.
    """
    named = isinstance(answer, dict) and _may_have_names(right, by_hand)
    answer = list(answer.values()) if named else answer
    if wanted := parts(right):
        return _fault_in_parts(answer, wanted, subject, rtol, atol, reveal, by_hand)
    right = np.asarray(right)
    try:
        given = _numbers(_in_a_row(answer, right) if by_hand else answer, right)
    except Misfit as instead:
        found = without_names(right, "str" in str(instead)) if named else instead
        return f"{subject} should be {form(right.shape, right.dtype.kind)}, but it is {found}."

    if right.dtype == bool and right.ndim == 0 and reveal:
        return _fault_in_truth(given, right, subject)
    right = right.astype(given.dtype)
    good = _close(given, right, rtol, atol) | (_to_three_digits(given, right) if by_hand else False)
    if good.all() or not subject:  # without a subject only whether they differ is asked
        return None if good.all() else "differs"
    at = tuple(np.argwhere(~good)[0].tolist())  # the first entry that differs
    direction = "wrong" if np.iscomplexobj(right) else "too high" if given[at] > right[at] else "too low"
    twins = _relatives(given, right) if related else ()
    verdict = next((words for words, twin in twins if _close(given, twin, rtol).all()), "")
    if reveal:
        return f"{subject} is {_beside(given, right, at, verdict)}."
    if not verdict and by_hand and all(map(_is_rounded, given[~good], right[~good])):
        verdict = "is rounded too much: give three digits or more"
    if not verdict and right.size > 1:
        verdict = f"differs in {(~good).sum()} of {right.size} entries: {list(at)} is {direction}"
    return f"{subject} {verdict or f'is {direction}'}."


def _may_have_names(right, by_hand):
    """May a dictionary be handed in: for values that were typed, or for the rows of a matrix?"""
    return bool(by_hand) if parts(right) else np.ndim(right) > (0 if by_hand else 1)


def _fault_in_truth(given, right, subject):
    """Where True or False is wanted: 1 and 0 are taken for them, other numbers are not."""
    if given == right:
        return None
    found = bool(given) if given in (0, 1) else show(given)
    return f"{subject} is {found}, but {bool(right)} was expected."


def _fault_in_parts(answer, wanted, subject, rtol, atol, reveal, by_hand):
    """The first fault in the parts of an answer; `wanted` holds the right ones by name."""
    is_row = isinstance(answer, list) or (isinstance(answer, np.ndarray) and answer.ndim > 0)
    given = answer if is_row else list(parts(answer).values())
    if len(given) != len(wanted):
        found = len(given) or f"one of type {type(answer).__name__}"
        return f"{subject} should hold {count(len(wanted), 'value')} ({', '.join(wanted)}), not {found}."
    if isinstance(answer, np.ndarray) and list(map(np.size, given)) != list(map(np.size, wanted.values())):
        forms = " and ".join(form(np.shape(part)) for part in wanted.values())
        return f"{subject} should be {count(len(wanted), 'value')}, {forms}, but it is {form(answer.shape)}."
    rows = list(zip(given, wanted.values(), wanted, strict=True))

    def faults(related=True):
        for piece, part, name in rows:
            yield fault(piece, part, subject and f"{name} of {subject}", rtol, atol, reveal, by_hand, related)

    said = {name: words for words, name in zip(faults(), wanted, strict=True) if words}
    if not by_hand or not subject or len(said) < 2 or any("should" in words for words in said.values()):
        return next(iter(said.values()), None)
    alike = len({words.removeprefix(name) for name, words in said.items()}) == 1
    return " ".join(words[0].upper() + words[1:] for words in filter(None, faults(alike)))


def _beside(given, right, at, verdict):
    """What is given and what was expected, in as many digits as tell them apart; of a large array the entry `at`."""
    where = f"at {list(at)} " if right.size > ENTRIES_SHOWN else ""
    pair = (given[at], right[at]) if where else (given, right)
    digits = next((d for d in (4, 6, 9, 12) if show(pair[0], d) != show(pair[1], d)), 17)
    remark = f" (it {verdict})" if verdict else ""
    return f"{where}{show(pair[0], digits)}, but {show(pair[1], digits)} was expected{remark}"


def _in_a_row(answer, right):
    """A typed column, or a row in double brackets, as the row that is wanted."""
    if right.ndim != 1 or not isinstance(answer, (list, np.ndarray)):
        return answer
    try:
        return np.ravel(answer) if np.shape(answer) in ((right.size, 1), (1, right.size)) else answer
    except ValueError:  # rows of unequal length
        return answer


def _array(answer, misfit, with_nan):
    """Numbers of any kind as an array: fractions, decimals and very long integers become floats."""
    try:
        array = np.asarray(answer)
    except ValueError:
        raise Misfit(f"{misfit}, and its parts differ in shape") from None
    if array.dtype != object:
        return array
    if empty := [list(at) for at in np.ndindex(array.shape) if array[at] is None]:
        raise Misfit(f"None at {empty[0]}" + ("; NaN is `np.nan`" if with_nan else ""))
    try:
        return array.astype(float)
    except (TypeError, ValueError, OverflowError):
        raise Misfit(misfit) from None


def _numbers(answer, right):
    """The answer as an array of the form of `right`; a Misfit says what it is instead."""
    kind = type(answer).__name__
    if answer is None or isinstance(answer, (str, bytes)):
        raise Misfit("None" if answer is None else f"text (of type {kind}): {of_text(answer, right)}")
    if callable(answer):
        raise Misfit("a function: hand in the value itself")
    if isinstance(answer, (list, tuple, range)) and len(answer) != (right.shape or (1,))[0]:
        raise Misfit(f"a {kind} of {count(len(answer), 'item')}")
    array = _array(answer, f"of type {kind}", np.isnan(right).any() if right.dtype.kind == "f" else False)
    if array.dtype.kind == "b" and array.ndim and right.dtype.kind in "iu" and np.isin(right, (0, 1)).all():
        array = array.astype(int)  # True and False for 1 and 0
    if array.dtype.kind not in "iuf" and array.dtype.kind != right.dtype.kind:
        holding = f", holding {array.dtype.type.__name__.strip('_')}" if array.ndim else ""
        raise Misfit(f"of type {kind}{holding}{': real numbers are wanted' if array.dtype.kind == 'c' else ''}")
    single = array.size == right.size == 1 and not (right.dtype == bool and array.dtype != bool)  # a place is no truth
    if array.shape != right.shape and not single:
        several = array.ndim > 1 and (isinstance(answer, tuple) or (kind == "list" and np.ndim(answer[0]) > 1))
        raise Misfit(f"a {kind} of {len(answer)} items" if several else form(array.shape))
    array = array.reshape(right.shape).astype(complex if right.dtype.kind == "c" else float)
    strange = np.argwhere(~np.isfinite(array) & np.isfinite(right))
    if len(strange):
        at = tuple(strange[0].tolist())
        raise Misfit(f"{show(array[at])}" if not at else f"{show(array[at])} at {list(at)}")
    return array


def _close(given, right, rtol, atol=None):
    """Entry by entry: equal within the tolerances, NaN equal to NaN."""
    if given.shape != right.shape:
        return np.False_
    if atol is None:
        atol = 1e-12 * (np.abs(right[np.isfinite(right)]).max(initial=0) or 1)
    return np.isclose(given, right, rtol, atol, equal_nan=True)


def _to_three_digits(given, right):
    """Entry by entry: the right number, rounded to three digits; whole numbers are wanted exactly."""
    return (
        np.array(
            [
                not float(b).is_integer() and float(a) == float(f"{b:.3g}")
                for a, b in zip(given.flat, right.flat, strict=True)
            ]
        ).reshape(right.shape)
        if right.dtype.kind == "f"
        else np.False_
    )


def _is_rounded(given, right):
    """Whether a typed number is the right one, rounded to two digits."""
    return isinstance(right, float) and not float(right).is_integer() and given == float(f"{right:.2g}")


def is_whole(right):
    """Whether a right answer is one whole number."""
    return isinstance(right, (int, float, np.number)) and float(right).is_integer()


def _relatives(given, right):
    """Arrays that differ from the right one in a way which is easily named."""
    yield "has the opposite sign", -right
    yield "is the transpose of what it should be", right.T
    largest = np.argmax(np.abs(right)) if right.size else None
    with np.errstate(all="ignore"):
        ratio = abs(given.flat[largest] / right.flat[largest]) if given.size == right.size > 0 else 1
        power = np.log10(ratio) if ratio > 0 else 0
    if abs(power) < 9.5 and (power := round(float(power))):
        yield f"is {10 ** abs(power)} times too {'large' if power > 0 else 'small'}", right * 10.0**power


BETWEEN = r"[,;+&]|\b(?:and|or|then)\b"  # what stands between two choices


def chosen(answer, choices=frozenset()) -> frozenset:
    """A choice as a set of plain words: "B)" is {"b"}, "A, C" is {"a", "c"}, 3 is {"3"}, True is {"true"}.

    choices: "A and C" and "AC" are two of them too, unless that is the name of one.
    """
    if isinstance(answer, (np.ndarray, np.generic)) and answer.size <= 100:
        answer = answer.tolist()
    if isinstance(answer, str):
        whole = plain(answer, choices)
        if whole in choices:
            return frozenset({whole})
        found = frozenset(part.strip(" .()").casefold() for part in re.split(BETWEEN, answer)) - {""}
        letters = frozenset(whole.replace(" ", ""))
        return letters if letters and letters <= choices and not found <= choices else found
    if isinstance(answer, bool):
        return frozenset({str(answer).casefold()})
    if isinstance(answer, (list, tuple, set, frozenset, range)) and len(answer) <= 100:
        found = [chosen(part, choices) for part in answer]
        if any(len(part) > 1 for part in found) and len(set(found)) > 1:
            raise ValueError("several answers are no choice")
        return frozenset().union(*found)
    if int(answer) != answer:
        raise ValueError("a fraction is no choice")
    return frozenset({str(int(answer))})


def parts(value) -> dict:
    """The named parts of a Gaussian or a tuple; of anything else, nothing."""
    if is_gaussian(value):
        return {"the mean": value.mean, "the covariance": value.cov}
    return {f"value {i}": part for i, part in enumerate(value, 1)} if isinstance(value, tuple) else {}


def unfinished(answer, depth=5) -> bool:
    """Nothing at all, or lists with a `...` still in them."""
    if answer is None or answer is ... or (type(answer) is str and not answer.strip()):
        return True
    inside = answer if type(answer) in (list, tuple) and depth else ()
    return any(unfinished(item, depth - 1) for item in inside if item is not None)
