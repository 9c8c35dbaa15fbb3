"""Lesson 5, `is_unknown`: wrong answers, each with the sentence that it gets."""

import numpy as np

WRONG = {
    "truth of entries": (
        lambda x: np.any(x),
        "`any` asks here whether an entry is not zero, and NaN is not zero either. Ask each entry with np.isnan first.",
        r"any\(x\)|x\.any\(",
    ),
    "is nan": (
        lambda x: any(value is np.nan for value in x),
        "`is` asks whether two names stand for the same object. A NaN in an array is another one: use np.isnan.",
        r"\bis +(not +)?(np|math|numpy|float)\b",
    ),
    "without the first": (
        lambda x: np.isnan(x[1:]).any(),
        "A NaN in the first entry is not found; every entry counts, that one too.",
    ),
    "without the last": (
        lambda x: np.isnan(x[:-1]).any(),
        "A NaN in the last entry is not found; every entry counts, that one too.",
    ),
    "where the first one is": (
        lambda x: np.isnan(x).argmax(),
        "You return the place of the first NaN, and 0 where there is none. True or False is wanted: is there any?",
    ),
    "places in rows": (
        lambda x: np.argwhere(np.isnan(x)),
        "You return the places of the unknown entries. True or False is wanted: is there any?",
    ),
    "larger than 0": (
        lambda x: (x > 0).any(),
        "Your function says True where an entry is larger than 0. Whether an entry is unknown, np.isnan tells.",
    ),
    "as published": (
        lambda x: np.isnan(x).all(),
        "That is the published test again: it says yes only when every entry is unknown.",
    ),
    "not all": (
        lambda x: not np.all(x),
        "Your function says True where an entry is 0, as `not np.all(x)` does: NaN differs from 0. But 0 is a number like any other: ask `np.isnan`.",
    ),
    "not all of what NaN is made": (
        lambda x: not np.all(np.nan_to_num(x)),
        "An entry that is 0 is taken for unknown, too: 0 is a number like any other. Ask np.isnan of the entries as they are.",
    ),
    "the wrong way round": (lambda x: not np.isnan(x).any(), "Your function says yes when the start is known."),
    "the places": (
        lambda x: np.flatnonzero(np.isnan(x)),
        "You return the places of the unknown entries. True or False is wanted: is there any?",
    ),
    "only the first": (
        lambda x: np.isnan(x[0]),
        "NaN is found only where it stands first; it may sit in any entry.",
    ),
    "x == nan": (
        lambda x: (x == np.nan).any(),
        "NaN equals nothing, not even itself, so x == np.nan is always False: use np.isnan.",
        r"== *(np|numpy|math)?\.?nan|nan *==|float\(.nan.\)",
    ),
    "always True": (
        lambda x: True,
        "Your function says True for every state that it was tried on, those without NaN as well: ask each entry with np.isnan.",
    ),
    "each entry": (
        lambda x: np.isnan(x),
        "You return an answer for each entry. One answer for the whole state is wanted: is any of them True?",
    ),
    "how many": (
        lambda x: np.isnan(x).sum(),
        "You return how many entries are unknown. True or False is wanted: is there any?",
    ),
    "only the last": (lambda x: np.isnan(x[-1]), "You look at the last entry only; NaN may sit in any of them."),
    "only two": (
        lambda x: np.isnan(x[:2]).any(),
        "You look at the first two entries only. A state may have more: let np.isnan look at all of them.",
    ),
    "only the middle": (
        lambda x: np.isnan(x[len(x) // 2]),
        "You look at one entry only; NaN may sit in any of them.",
    ),
    "first and last": (
        lambda x: np.isnan(x[0]) or np.isnan(x[-1]),
        "You look at the first and the last entry only; NaN may sit between them.",
    ),
    "finite": (
        lambda x: np.isfinite(x).any(),
        "You ask whether any entry is known, or whether not all are unknown. The question is whether any is unknown.",
    ),
    "each, from a list": (
        lambda x: [bool(np.isnan(value)) for value in x],
        "You return an answer for each entry. One answer for the whole state is wanted: is any of them True?",
    ),
    "x == nan, each": (
        lambda x: x == np.nan,
        "NaN equals nothing, not even itself, so x == np.nan is False for every entry: use np.isnan, and any() afterwards.",
        r"== *(np|numpy|math)?\.?nan|nan *==",
    ),
    "nan in x": (
        lambda x: np.nan in x,
        "`in` compares with ==, and NaN equals nothing, not even itself: use np.isnan, and any() afterwards.",
        r"nan['\")]* in ",
    ),
    "always False": (
        lambda x: False,
        "Your function says False whatever the state is. Ask each entry with np.isnan first, and any() afterwards.",
    ),
    "exactly one": (
        lambda x: np.isnan(x).sum() == 1,
        "You say yes where exactly one entry is unknown. One or more make the state unknown.",
    ),
    "more than one": (
        lambda x: np.isnan(x).sum() > 1,
        "You say yes where two or more entries are unknown. One is enough.",
    ),
    "some, not all": (
        lambda x: bool(np.isnan(x).any() and not np.isnan(x).all()),
        "A state of which all entries are unknown is left out. There too at least one is unknown: any() alone is enough.",
    ),
}
