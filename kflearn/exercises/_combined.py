"""For the authors of exercises: wrong functions that err in one place, or in several at once."""

import itertools
import re


def _once(words):
    """Some remarks in a row; a sentence that comes twice stands in the last place only."""
    sentences = [each for remark in words for each in re.split(r"(?<=[.?!]) (?=[A-Z])", remark)]
    return " ".join(each for i, each in enumerate(sentences) if each not in sentences[i + 1 :])


def combined(make, most=2, **places) -> dict:
    """A table of wrong functions: all that err in one of some places, then those that err in several.

    Parameters
    ----------
    make : function(**chosen)
        The function that does what is chosen for each place.
    most : int
        In how many places it errs at most.
    places : {option: words}
        For each place what can be done there: what is right first, with no words; then what is wrong, with a sentence.

    Examples
    --------
    >>> table = combined(lambda sign, size: lambda x: sign * size * x, sign={1: "", -1: "The sign."}, size={2: "", 3: "Too large."})
    >>> [(function(1), words) for function, words in table.values()]
    [(3, 'Too large.'), (-2, 'The sign.'), (-3, 'The sign. Too large.')]
    """
    found = []
    for choice in itertools.product(*(options.items() for options in places.values())):
        words = [said for _, said in choice if said]
        if 0 < len(words) <= most:
            chosen = {place: option for place, (option, _) in zip(places, choice, strict=True)}
            found.append((len(words), f"combined: {chosen}", (make(**chosen), _once(words))))
    return {label: entry for _, label, entry in sorted(found, key=lambda row: row[0])}
