"""Whatever a learner, or a program gone wrong, might hand in: numbers, texts, arrays, containers, functions."""

import random
from datetime import datetime
from decimal import Decimal
from fractions import Fraction

import numpy as np

from dev.hard.line import Tally, none

nan, inf = np.nan, np.inf
NUMBERS = [0, 1, -1, 2, 0.5, -0.0, nan, inf, -inf, 1e308, 5e-324, 2**63, 10**400, 1j, complex(nan, inf), True, False]
NUMBERS += [Fraction(1, 3), Decimal("NaN"), Decimal("0.1"), np.float16(2), np.int8(-3), np.uint64(2**64 - 1), np.True_]
TEXTS = [
    "",
    " ",
    "12",
    "1,5",
    "B",
    "true",
    "A, C",
    "½",
    "\0",
    "\ud800",
    "卡尔曼",
    "x" * 5000,
    "__import__('os')",
    b"12",
]
OTHERS = [None, ..., NotImplemented, object(), object, int, np, slice(3), range(5), datetime(2026, 5, 31), {1, 2}]
DTYPES = ["f8", "f8", ">f8", "f4", "f2", "i1", "u8", "?", "c16", "U3", "S3", "O", "M8[s]", "m8[ns]", [("x", float)]]
FAIR = [ValueError("no"), TypeError(), IndexError(3)]  # what a filter takes for a function that does not fit
ERRORS = [*FAIR, ZeroDivisionError(), KeyError("x"), StopIteration(), MemoryError(), RecursionError(), OSError(2, "x")]
ERRORS += [SystemExit(3), GeneratorExit(), Exception(b"\xff"), NotImplementedError(), AssertionError()]


class Fighter:
    """An object that raises however it is looked at."""

    def __init__(self, error):
        object.__setattr__(self, "error", error)

    def fight(self, *_):
        raise object.__getattribute__(self, "error")

    __repr__ = __str__ = __eq__ = __bool__ = __len__ = __iter__ = __array__ = __float__ = __int__ = __format__ = fight
    __getattr__ = __call__ = __index__ = __contains__ = __lt__ = __add__ = __mul__ = __sub__ = __getitem__ = fight
    __hash__ = object.__hash__


class Junk:
    """A source of things, the same ones for the same seed; with `fighters` also such as raise when they are touched."""

    def __init__(self, seed, fighters=False):
        self.rng, self.fighters = random.Random(seed), fighters
        self.numpy = np.random.default_rng(seed)

    def thing(self, depth=2):
        """Anything at all; containers at most `depth` deep."""
        kinds = [self.number, self.text, self.other, self.array, self.array, self.function]
        if depth:
            kinds += 2 * [lambda: self.container(depth - 1)]
        return self.rng.choice(kinds)()

    def number(self):
        return self.rng.choice([*NUMBERS, self.rng.gauss(0, 1), self.rng.randint(-9, 99)])

    def text(self):
        return self.rng.choice(TEXTS)

    def other(self):
        return (
            Fighter(self.rng.choice(ERRORS)) if self.fighters and self.rng.random() < 0.4 else self.rng.choice(OTHERS)
        )

    def array(self):
        """An array of any shape and kind."""
        shape = self.rng.choices([0, 1, 1, 2, 2, 3, 5], k=self.rng.randrange(4))
        values = np.array(self.numpy.normal(size=shape) * 10.0 ** self.rng.randint(-2, 3))
        values[self.numpy.random(shape) < self.rng.choice([0, 0, 0.3])] = self.rng.choice([nan, inf, 0])
        kind = self.rng.choice(DTYPES)
        with np.errstate(invalid="ignore", over="ignore"):
            array = values.astype("i8").astype(kind) if np.dtype(kind).kind in "Mmiu" else values.astype(kind)
        if kind == "O" and array.size:
            array.flat[0] = self.number()
        return self.dressed(array)

    def dressed(self, array):
        """The same numbers as another kind of array: turned, reversed, masked, read-only."""
        dress = [np.asarray, np.transpose, lambda a: a[::-1] if a.ndim else a, np.asarray]
        dress += [lambda a: np.ma.masked_array(a, mask=self.rng.random() < 0.5)]
        array = np.asanyarray(self.rng.choice(dress)(array))
        array.flags.writeable = self.rng.random() < 0.8
        return array

    def container(self, depth):
        """A list, tuple, dict or set of things; now and then a list that holds itself."""
        items = [self.thing(depth) for _ in range(self.rng.randrange(4))]
        if self.rng.random() < 0.05:
            items.append(items)
        numbers = set(self.rng.choices(NUMBERS, k=3))
        return self.rng.choice([items, items, tuple(items), dict(enumerate(items)), numbers, [items, items]])

    def function(self):
        """A function that raises, returns junk, overwrites its arguments, or cannot be called so."""
        error, answer = self.rng.choice(ERRORS if self.fighters else FAIR), self.thing(0)

        def raises(*_):
            raise error

        def overwrites(*given):
            for one in given:
                if isinstance(one, (np.ndarray, list)):
                    one[...] = 7  # a list raises here: it has no such index
            return given[0] if given else None

        def yields(*given):
            yield from given

        plain = [raises, overwrites, yields, lambda *given: answer, lambda: answer, lambda *given: given[-1] + 1]
        return self.rng.choice([*plain, max, np.sum, np.linalg.inv, str, float, dict, lambda x, y=1, *, z: x])


def print_of(value, depth=5):
    """A fingerprint of a value: equal as long as no number in it has changed."""
    if isinstance(value, np.ndarray):
        mask = np.ma.getmaskarray(value).tobytes() if np.ma.isMaskedArray(value) else b""
        return type(value), value.shape, value.dtype.str, value.flags.writeable, np.ma.getdata(value).tobytes("A"), mask
    if type(value) in (list, tuple) and depth:
        return type(value), [print_of(item, depth - 1) for item in value]
    if type(value) is dict and depth:
        return dict, [(key, print_of(item, depth - 1)) for key, item in value.items()]
    return id(value)


class Inputs(Tally):
    """Inputs that were tried: how they ended otherwise than documented, and which changed the caller's data."""

    def __init__(self):
        super().__init__()
        self.changed = []

    def lines(self, area, documented):
        """Two lines of the table for an area."""
        tried = f"{self.tried:,}"
        yield none(f"{area}: end otherwise", self.faults, tried, f"only with {documented}")
        yield none("    caller's data changed", self.changed, tried, "never")
