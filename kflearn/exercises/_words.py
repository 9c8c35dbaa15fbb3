"""A choice as a learner may write it: with an article, with the words beside the letter, in another word for the same."""

import re

# Words that say the same of a size or of a comparison, as far as one of them is among the choices
ALIKE = [
    {"larger", "bigger", "greater", "higher", "more", "worse", "increases", "it increases", "grows", "it grows"},
    {"smaller", "less", "lower", "better", "decreases", "it decreases", "shrinks", "it shrinks"},
    {"nothing", "no difference", "none", "neither", "no change", "unchanged", "no effect", "same", "equal", "zero"},
    {"lkf", "linearised", "linearized", "linearised filter", "linearized filter", "linearised kalman filter"},
    {"ekf", "extended", "extended filter", "extended kalman filter"},
]
LETTER = re.compile(
    r"(?:option|answer|choice|reviewer|letter)? *\(?([a-z])\)?(?: (?:is|has it|was) ?(?:right|correct)?)?"
    r"|\(?(?:([a-z])[).:]|([b-z])) +(?!and\b|or\b)(?=.*[a-z]{4})[^()]+"  # "a" alone may be the article
)


def plain(text, choices) -> str:
    """A text in small letters, without what stands round the choice; the choice itself where it can be found.

    Examples
    --------
    >>> plain("(D) Nothing is wrong.", {"a", "d"}), plain("The LKF", {"lkf", "ekf"}), plain("bigger", {"larger"})
    ('d', 'lkf', 'larger')
    >>> plain("D nothing is wrong", {"a", "d"})
    'd'
    """
    whole = re.sub(r"^the +", "", text.strip(" .!()'\"“”").casefold())
    for said in (whole, re.sub(r" +(?:is|was|has become) +", " ", whole)):  # "g is too large"
        if said in choices:
            return said
    letter = LETTER.fullmatch(text.strip(" .!'\"“”").casefold())
    named = next(filter(None, letter.groups()), None) if letter else None
    if named in choices:
        return named
    alike = set().union(*(group & set(choices) for group in ALIKE if whole in group))
    return alike.pop() if len(alike) == 1 else whole


def not_there(answer, choices, several=False) -> str:
    """What is said before the list of choices, where the answer is a word or a number that is none of them.

    several: whether more than one is wanted.
    """
    if all(len(choice) == 1 and choice.isalpha() for choice in choices):
        one = "a letter alone is wanted: " if isinstance(answer, str) else "a letter is wanted, in quotation marks: "
        wanted = 'letters are wanted, such as {"X", "Y"}: ' if several else one
        return "" if isinstance(answer, str) and len(answer.strip()) < 3 else wanted
    words = all(len(choice) > 1 for choice in choices - {"true"})
    if isinstance(answer, str):
        text = " ".join(answer.split())
        return f"“{text[:40]}” is not among the choices: " if len(text) > 2 else ""
    return "a word is wanted, in quotation marks: " if words and "true" not in choices else ""


def heard(table):
    """What is said of a choice in the learner's own words: the sentence beside the first pattern that is found in it.

    Examples
    --------
    >>> said = heard({r"gravity.*small": "Read as g too small."})
    >>> said("Gravity too small"), said("wind"), said(9)
    ('Read as g too small.', None, None)
    """

    def said(answer):
        text = " ".join(str(answer).split()).casefold() if isinstance(answer, (str, int, float)) else ""
        return next((words for pattern, words in table.items() if re.search(pattern, text)), None)

    return said


def one_of(given, right, choices, wrong=None) -> str:
    """What is said of several choices, where one is wanted; of two that are wrong also what is said of each.

    Examples
    --------
    >>> wrong = {"first": ("a", "It bends."), "second": ("b", "It is late.")}
    >>> one_of({"a", "b"}, {"c"}, {"a", "b", "c", "d"}, wrong)
    'choose one, please. The right one is none of these. a: It bends. b: It is late.'
    """
    if given == choices:
        return "choose one, please."
    if right <= given:
        return "choose one, please. The right one is among these."
    each = [f" {value}: {words}" for value, words in (wrong or {}).values() if str(value).casefold() in given]
    return f"choose one, please. The right one is none of these.{''.join(each if len(given) == 2 else [])}"


def alone(answer, right, as_text=False) -> str:
    """What is said first of a single letter where several are wanted: all that has arrived is this letter.

    as_text: whether the exercise asks for the letters as one text, and not for a set.

    Examples
    --------
    >>> alone("A" and "C", {"a", "c"})
    'Your answer is the letter C alone; several are handed in as a set, such as {"X", "Y"} (`and` leaves only the last). '
    >>> alone("C", {"a", "c"}, as_text=True)
    'Your answer is the letter C alone; several are handed in as one text, such as "XY" (`and` leaves only the last). '
    >>> alone("AC", {"a", "c"}), alone("C", {"c"})
    ('', '')
    """
    letter = answer.strip(" .()").upper() if isinstance(answer, str) else ""
    if len(letter) != 1 or len(right) < 2 or not all(map(str.isalpha, {letter, *right})):
        return ""
    form = 'one text, such as "XY"' if as_text else 'a set, such as {"X", "Y"}'
    return f"Your answer is the letter {letter} alone; several are handed in as {form} (`and` leaves only the last). "


def of_text(answer, right):
    """What to do with a text that is handed in for a number, or for True or False."""
    words = answer if isinstance(answer, str) else ""
    if right.dtype == bool:
        return "write True or False, without quotation marks"
    if not right.ndim and re.fullmatch(r" *[+-]?\d+,\d+ *", words):
        return "leave out the quotation marks, and write a point in place of the comma"
    if right.ndim and "[" not in words:
        return "write numbers in brackets, as in `[1, 2]`"
    if re.fullmatch(r"[\d\s.,e+()\[\]*/-]*", words):
        return "leave out the quotation marks"
    return "write it without quotation marks, words and units"


def without_names(right, holds_text=False) -> str:
    """What is said of a dictionary whose values do not fit; right: the array that is wanted."""
    if holds_text:
        return "a dictionary of texts: give numbers, without quotation marks"
    example = f", as in `{list(range(1, right.size + 1))}`" if right.ndim == 1 and right.size < 6 else ""
    return f"a dictionary: give the numbers alone, without names, in the order of the question{example}"


def texts(value) -> list:
    """The names of choices as they were written."""
    some = [value] if isinstance(value, str) else value if isinstance(value, (set, frozenset, list, tuple)) else []
    return [part for part in some if isinstance(part, str)]
