"""What is said of a function that is wrong and in no table: what its results, or its code, have in common.

Whatever is said here is true of all trials, or of the learner's own code.
"""

import re

import numpy as np

from kflearn.exercises import _code_of, _rules, _rules_inputs
from kflearn.exercises._answers import fault, parts
from kflearn.exercises._raised import told
from kflearn.exercises._watch import TooLong

RANDOM = r"default_rng|np\.random|random\.(normal|randn|standard|multi)|\brng\."
FULL = 12  # the entries of a matrix that are looked at one by one


def in_time(exercise, answer, results, rights, faults) -> str:
    """The sentence for results that are wrong; where there is no time to look for it, the first trial that fails."""
    try:
        named = _rules_inputs.of_a_dictionary(exercise, results, rights) or exercise._lesson(answer, results)
        named = named or _otherwise(exercise, answer, results, rights)
        return named or explained(exercise, answer, results, rights, faults)
    except TooLong:
        first = next(number for number, complaint in enumerate(faults) if complaint)
        return f"For `{exercise._called(exercise.cases[first])}` {faults[first]}"


def _otherwise(exercise, answer, results, rights):
    """What the exercise itself says of such results; None where it says nothing, or can make nothing of them."""
    if not exercise.otherwise or _code_of.names_of_the_notebook(answer):
        return None
    try:
        if np.asarray(results).dtype.kind not in "biuf":  # complex numbers, or text
            return None
        return exercise.otherwise(np.asarray(results, float), np.asarray(rights, float))
    except Exception:  # results that are no numbers, or not of one shape
        return None


def explained(exercise, answer, results, rights, faults) -> str:
    """The sentence for results that are wrong: a rule that explains all of them, or else the first trial that fails."""
    close = lambda one, other: fault(one, other, "", exercise.rtol, exercise.atol, False) is None  # noqa: E731
    cases, names = exercise.cases, exercise.parameters
    named = _rules.sentence(results, rights, close)
    named = named or (not exercise.slow and _rules_inputs.as_if(results, exercise, close))
    if named and not (named.endswith("or missing.") and _of_the_notebook(answer, names)):
        return named
    if not exercise.slow and _rules.changes(answer, results, cases):
        return _drawn(exercise, answer) or _rules.CHANGES
    good = [not complaint for complaint in faults]
    first = good.index(False)
    words = f"for `{exercise._called(cases[first])}` {faults[first]}"
    lead = "" if exercise.slow else _drawn(exercise, answer) or _unused(exercise, answer, close)
    lead = lead or _of_the_notebook(answer, names)
    lead = lead or _rules_inputs.same_number(results, rights) or _not_a_number(results, rights, cases)
    lead = lead or _of_another_form(results, rights, close) or _of_matrices(answer, cases, good, names)
    lead = lead or _fixed_size(exercise, answer, _wrong_lengths(words)) or _size(results, rights, cases)
    if not lead and not exercise.slow and all(map(_rules_inputs.real, results)):
        lead = _rules_inputs.blind(answer, exercise, close)
    if not lead:
        placed = _placed(results, rights, close)
        if placed:  # the trial in which the most entries differ
            most = max(range(len(cases)), key=lambda i: _count_wrong(results[i], rights[i], close))
            words = f"for `{exercise._called(cases[most])}` {faults[most]}"
        return " ".join(filter(None, [words, placed, _rules.share(good, cases)]))
    return f"{lead} {words[0].upper()}{words[1:]}"


def raised(exercise, answer, error, case, number) -> tuple[str, str]:
    """The status and the sentence for a function that raised in a trial, after so many trials that it stood."""
    status, sentence = told(error, answer, exercise._called(case))
    if status != "raised":
        return status, sentence
    sizes = _several_sizes(exercise)
    remark = _of_the_notebook(answer, exercise.parameters)
    if not remark and isinstance(error, (ValueError, IndexError)):
        remark = _fixed_size(exercise, answer)
    if not remark and sizes and isinstance(error, IndexError) and "out of bounds" in str(error):
        remark = "The trials have several sizes: an index that is typed in may lie beyond the end."
    singular = isinstance(error, np.linalg.LinAlgError)
    if not remark and singular:
        remark = _of_the_diagonal(answer)
    if not remark and sizes and number and isinstance(error, ValueError) and not singular:
        remark = _of_shapes(error, sentence)
    return status, f"{sentence} {remark}".rstrip()


def _of_shapes(error, sentence):
    """What is said of sizes that do not fit, which they did in the first trials."""
    if "broadcast" in str(error) and re.search(r"in the line `[^`]*[A-Za-z_)\]] ?\* ?[A-Za-z_(]", sentence):
        return "In the trials before the sizes fitted by chance. `*` multiplies entry by entry; the product of matrices is `@`."
    if "broadcast" in str(error):
        return "In the trials before the sizes fitted by chance. Two arrays of different shapes are added or multiplied: is one of a fixed size, or should a product stand between them?"
    return "The trials have several sizes: is a size typed in, a transpose missing, or an order of factors wrong?"


def _of_the_diagonal(answer):
    """What is said of an S with R[seen, seen] in it; empty where there is none."""
    text = _code_of.text_of(answer) or ""
    found = re.search(r"\bR\[([a-z_]\w+), ?\1\]", text)
    if not found or re.search(rf"\bfor {found[1]} in\b", text):
        return ""
    it, s = found[0], found[1]
    return f"{it} picks the diagonal as a vector, and adding it spreads it over all rows of S. The block of R is `R[np.ix_({s}, {s})]`."


def _several_sizes(exercise):
    """Whether the arrays of the trials have several sizes."""
    return len({tuple(map(np.shape, each)) for each in exercise.cases}) > 1


def _wrong_lengths(words):
    """The lengths of an array, in a sentence about its shape, where others are wanted."""
    shapes = re.search(r"should be an array of shape \(([\d, ]+)\), but it is an array of shape \(([\d, ]+)\)", words)
    wanted, given = (re.findall(r"\d+", part) for part in shapes.groups()) if shapes else ([], [])
    return [mine for mine, right in zip(given, wanted, strict=False) if mine != right]


def _fixed_size(exercise, answer, lengths="123456789"):
    """What is said of a call such as np.eye(2) in a function's text, with one of these lengths, where the trials have several."""
    call = rf"(np\.|numpy\.)?(eye|identity|zeros|ones|arange)\(({'|'.join(lengths)})\)"
    found = re.search(call, _code_of.text_of(answer) or "") if lengths else None
    if not found or not _several_sizes(exercise):
        return ""
    fits = "the identity that fits is `np.eye(len(x))`" if found[2] in ("eye", "identity") else "`len(x)` fits"
    return f"`{found[0]}` has a fixed size, and the trials have several: {fits}."


def _drawn(exercise, answer):
    """A function that draws random numbers, where the argument `normal` holds those that it is to use."""
    if "normal" not in exercise.parameters or not re.search(RANDOM, _code_of.text_of(answer) or ""):
        return ""
    return "You draw random numbers of your own. Use those in `normal`."


def _unused(exercise, answer, close):
    """Which arguments do not matter, though they should."""
    names = _rules.unused(answer, exercise._solve, exercise.cases, exercise.parameters, close)
    if not names:
        return ""
    instead = "a number, or a name of the notebook, stands in its place, or it is left out"
    return f"The result does not depend on {' and '.join(names)}: {instead}."


def _of_the_notebook(answer, parameters):
    """Names of the notebook that the function reads."""
    names = _code_of.names_of_the_notebook(answer)
    if not names:
        return ""
    own = _code_of.parameters(answer, parameters)
    listed = " and ".join(f"`{name}`" for name in names[:3])
    are = "is a name of the notebook and not an argument" if len(names) == 1 else "are names of the notebook"
    return f"Your function reads {listed}, which {are}: is that meant? It is given {', '.join(own)}."


def _not_a_number(results, rights, cases):
    """NaN, or a complex number, where a real number is wanted."""
    try:
        if np.iscomplexobj(results) and np.isrealobj(rights):
            return "The result is complex: is it the root of a negative number, so that a sign is missing?"
        pairs = [(np.asarray(one, float), np.asarray(other, float)) for one, other in zip(results, rights, strict=True)]
    except (TypeError, ValueError):
        return ""
    bad = [np.isnan(one).any() and np.isfinite(other).all() for one, other in pairs]
    gaps = [_rules.has_nan(case) for case in cases]
    if all(bad) and all(gaps):
        return "The result is NaN where the input holds NaN, a reading that is missing: whatever is calculated with NaN is NaN."
    if all(bad):
        return "The result is NaN: is it the root, or the logarithm, of a negative number?"
    return ""


def _of_another_form(results, rights, close):
    """The right numbers in arrays of another shape."""
    rows = [(_rules_inputs.real(one), _rules_inputs.real(other)) for one, other in zip(results, rights, strict=True)]
    if any(not one or not other or len(one) != len(other) for one, other in rows):
        return ""
    flat = [(np.ravel(a), np.ravel(b)) for one, other in rows for a, b in zip(one, other, strict=True)]
    same = all(a.size == b.size and close(a, b) for a, b in flat)
    return "The numbers are right, but not their form." if same else ""


def _of_matrices(answer, cases, good, names):
    """Right where a matrix holds one number, wrong for all others: what is different for matrices."""
    found = [i for i, part in enumerate(cases[0]) if np.ndim(part) == 2]
    alike = [names[i] for i in found if [np.size(case[i]) == 1 for case in cases] == good]
    if not alike or not any(good):
        return ""
    several = f"{' and '.join(alike)} hold a single number each" if alike[1:] else f"{alike[0]} holds a single number"
    lead = f"In the trials that is right only where {several}."
    if _code_of.has(answer, r"\b1(\.0?)? */ *[\w(]|\*\* *\(?-1|reciprocal|power\("):
        name = _turned_over(answer, names) or "…"  # no letter that the learner does not have
        lead = f"In the trials that is right only where {name} holds a single number." if name in alike else lead
        sign = f"`1 / {name}`" if _code_of.has(answer, r"\b1(\.0?)? */") else f"`{name}**-1`"
        return f"{lead} {sign} turns over each entry by itself; the inverse of a matrix is `np.linalg.inv({name})`."
    if all(np.ndim(part) for part in cases[0]) and _code_of.has(answer, r"[A-Za-z_)\]] *(?<!\*)\*(?!\*) *[A-Za-z_(]"):
        return f"{lead} `*` multiplies entry by entry; the product of matrices is `@`."
    return f"{lead} What is different in larger ones: a transpose, an inverse, the order of factors, a part, a choice?"


def _turned_over(answer, names):
    """What a function divides 1 by: an argument, under the exercise's name for it, or another name; None where none is seen."""
    found = re.search(
        r"\b1(?:\.0?)? */ *\(?(?:np\.\w+\()?([A-Za-z_]\w*)\b(?! *[@*+(.\[-])", _code_of.text_of(answer) or ""
    )
    found = found or re.search(r"([A-Za-z_]\w*) *\*\* *\(?-1", _code_of.text_of(answer) or "")
    own = dict(zip(_code_of.parameters(answer, names), names, strict=True))
    if found:
        return own.get(found[1], found[1])
    line = re.search(r"\b1(?:\.0?)? */ *(.*)", _code_of.text_of(answer) or "")  # the only argument behind the stroke
    behind = {word for word in re.findall(r"[A-Za-z_]\w*", line[1]) if word in own} if line else set()
    return own[behind.pop()] if len(behind) == 1 else None


def _size(results, rights, cases):
    """Wrong by a factor that follows the number of values that come in."""
    sizes = np.array([max((np.size(part) for part in case), default=1) for case in cases], float)
    try:
        ratios = [np.ravel(one) / np.ravel(other) for one, other in zip(results, rights, strict=True)]
        first = np.array([row[np.isfinite(row)][0] for row in ratios])
        same = all(np.allclose(row[np.isfinite(row)], one, rtol=1e-6) for row, one in zip(ratios, first, strict=True))
    except (IndexError, TypeError, ValueError):
        return ""
    if same and len(set(sizes)) > 2:
        for power in (1, -1, 0.5, -0.5):
            if np.allclose(first / sizes**power, first[0] / sizes[0] ** power, rtol=1e-6):
                return "The result is wrong by a factor that follows how many numbers come in: is one of these numbers typed in, or a division by `len(...)`, as in `np.mean`, missing or one too many?"
    return ""


def _placed(results, rights, close):
    """What is right in all trials, and what is not, of a result of several parts or a small matrix."""
    wanted = [list(parts(right).values()) or [right] for right in rights]
    rows = [_rules.row(result, len(wanted[0])) if parts(rights[0]) else [result] for result in results]
    if any(row is None for row in rows):
        return ""
    count, said = len(wanted[0]), []
    for i in range(count):
        name = f"value {i + 1} of the result" if count > 1 else "the result"
        said.append(_entries(name, [row[i] for row in rows], [right[i] for right in wanted], close, count > 1))
    return " ".join(filter(None, said))


def _count_wrong(result, right, close):
    """How many numbers of a result differ from those wanted."""
    wanted = list(parts(right).values()) or [right]
    row = _rules.row(result, len(wanted)) if parts(right) else [result]
    pairs = [(np.ravel(one), np.ravel(other)) for one, other in zip(row, wanted, strict=True)]
    return sum(not close(a, b) for one, other in pairs for a, b in zip(one, other, strict=False))


def _entries(name, mine, theirs, close, several):
    """What is right of one part in all trials."""
    try:
        if any(map(np.iscomplexobj, mine)):
            return ""
        pairs = [(np.asarray(one, float), np.asarray(other, float)) for one, other in zip(mine, theirs, strict=True)]
    except (TypeError, ValueError):
        return ""
    if all(close(one, other) for one, other in pairs):
        return f"{name[0].upper()}{name[1:]} is right in all trials." if several else ""
    shape = pairs[0][1].shape
    if any(one.shape != shape or other.shape != shape for one, other in pairs) or not 1 < np.prod(shape) <= FULL:
        return ""
    wrong = [at for at in np.ndindex(shape) if not all(close(one[at], other[at]) for one, other in pairs)]
    if len(wrong) == np.prod(shape):
        return ""
    return f"Of {name} only {', '.join(str(list(at)) for at in wrong)} {'are' if wrong[1:] else 'is'} wrong."
