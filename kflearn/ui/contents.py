"""What is inside the thing that a playground's `draw` returned: what moves, and the words and numbers it shows."""

import re
import textwrap
from collections.abc import Iterator, Mapping

import numpy as np
from matplotlib.artist import Artist
from matplotlib.collections import Collection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.text import Text

from .drawn import Drawn


def leaves(thing) -> Iterator[Artist | Drawn]:
    """The drawn objects and artists in any nest of lists, tuples, dicts and namespaces."""
    if isinstance(thing, Artist | Drawn):
        yield thing
    elif isinstance(thing, str | np.ndarray) or thing is None:
        return
    elif isinstance(thing, Mapping):
        yield from leaves(list(thing.values()))
    elif isinstance(thing, list | tuple | set):
        for part in thing:
            yield from leaves(part)
    elif hasattr(thing, "__dict__"):
        yield from leaves(vars(thing))


def moving(thing) -> list[Artist]:
    """The matplotlib artists in it, in the order in which they are drawn."""
    artists = []
    for leaf in leaves(thing):
        artists += leaf.artists if isinstance(leaf, Drawn) else [leaf]
    return sorted(artists, key=lambda artist: artist.get_zorder())


def assert_finite(thing) -> None:
    """Raise AssertionError where a text, an artist or a drawn object shows a number that is not finite.

    Masked values are gaps and allowed. Values are what counts: Python in a browser does not warn of a division by 0.
    """
    for words in _words(thing):
        assert not re.search(r"\b(nan|inf)\b", words, re.IGNORECASE), f"not a number in {words!r}"
    for numbers in _numbers(thing):
        finite = np.isfinite(np.ma.masked_array(numbers, dtype=float)).filled(True).all()
        assert finite, f"a value that is not finite in {textwrap.shorten(str(thing), 80)}"


def _words(thing):
    """The text that it shows."""
    return [thing] if isinstance(thing, str) else [thing.get_text()] if isinstance(thing, Text) else []


def _numbers(thing):
    """The arrays that it draws."""
    if isinstance(thing, Drawn):
        return [data for data in thing.data if data is not None]
    if isinstance(thing, Line2D):
        return thing.get_data(orig=True)
    if isinstance(thing, Collection):
        return [thing.get_offsets()]
    if isinstance(thing, Patch):
        return [thing.get_patch_transform().transform(thing.get_path().vertices)]  # in the units of its axes
    return []
