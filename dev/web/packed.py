"""Recorded pictures in few bytes. recorded.js unpacks them in the browser.

A picture is a row of numbers: its words, and a block of points for each thing drawn. Equal blocks are kept once. Of a
block only the difference from one in a neighbouring picture is kept, or the steps from point to point, whichever needs
fewer bytes. Numbers are written seven bits to a byte, and everything is deflated.

    4 bytes: length of the JSON; the JSON; rows; blocks

rows    the number of entries, then each entry minus that of the row before
blocks  for each: its kind, how many blocks before it stands the one it differs from (0: none), and 0 for the numbers
        as they are or 1 for their steps; then the numbers of all blocks: first all x, then all y
"""

import json
import zlib

import numpy as np

FINENESS = 4  # parts of a pixel of the recorded picture


class Packer:
    """Takes pictures one by one; `about` is the JSON that goes with them.

    Attributes
    ----------
    styles, kinds, words : dict
        Numbers by what they stand for: a style, a thing drawn without its points, sentences.
    images : dict
        Numbers by the bytes of a PNG file.
    """

    def __init__(self):
        self.styles, self.kinds, self.words, self.images = {}, {}, {}, {}
        self._blocks, self._table, self._known, self._rows = [], [], {}, []

    def add(self, picture, words, areas, beside) -> int:
        """Keep a picture as `Stage.record` returns it, its words, the areas of its handles; returns its number.

        beside : numbers of pictures that may look much alike
        """
        about, (points, *images) = picture
        points = np.round(FINENESS * np.frombuffer(points, np.float32).reshape(-1, 2)).astype(np.int32)
        things = [self._thing(op, about["styles"], images, points) for op in about["ops"]]
        things += [(_name([len(area)]), np.round(FINENESS * np.array(area)).astype(np.int32)) for area in areas]
        near = [self._kinds_of(row) for row in beside]
        seen, row = {}, [self._number(self.words, json.dumps(words, ensure_ascii=False))]
        for kind, block in things:
            kind = self._number(self.kinds, kind)
            seen[kind] = seen.get(kind, -1) + 1
            like = [found[kind][seen[kind]] for found in near if len(found.get(kind, ())) > seen[kind]]
            row.append(self._block(kind, block, like))
        self._rows.append(row)
        return len(self._rows) - 1

    def _kinds_of(self, number):
        """The blocks of a picture by their kind."""
        found = {}
        for block in self._rows[number][1:]:
            found.setdefault(self._table[block][0], []).append(block)
        return found

    def _thing(self, op, styles, images, points):
        """The name of a thing's kind, and its points; in the kind, places count from its own first point."""
        places = [part for part in op if isinstance(part, list) and len(part) < 4]
        first = min((place[0] for place in places), default=0)
        count = sum(place[1] for place in places)
        parts = [[part[0] - first, *part[1:]] if part in places else part for part in op[1:]]
        if op[0] == "i":
            parts[0] = self._number(self.images, images[op[1]])
        else:
            parts[-2] = self._number(self.styles, _name(styles[op[-2]]))
        return _name([count, op[0], *parts]), points[first : first + count]

    def _number(self, table, key):
        return table.setdefault(key, len(table))

    def _block(self, kind, block, like):
        """The number of a block of points; a new one is kept in the shortest way."""
        key = kind, block.tobytes()
        if key not in self._known:
            self._known[key] = len(self._blocks)
            numbers = block.T
            ways = [(0, 1, _steps(numbers))]
            for other in dict.fromkeys(like):
                rest = numbers - self._blocks[other].T
                ways += [(len(self._blocks) - other, 0, rest), (len(self._blocks) - other, 1, _steps(rest))]
            back, stepwise, rest = min(ways, key=lambda way: _cost(way[2]))
            self._table.append((kind, back, stepwise, rest))
            self._blocks.append(block)
        return self._known[key]

    def packed(self, about) -> bytes:
        """Everything, with `about` in the JSON."""
        tables = dict(styles=self.styles, kinds=self.kinds, words=self.words)
        whole = about | {name: [json.loads(key) for key in table] for name, table in tables.items()}
        whole |= dict(rows=len(self._rows), blocks=len(self._blocks), fineness=FINENESS)
        text = json.dumps(whole, ensure_ascii=False, separators=(",", ":")).encode()
        rows, before = [], []
        for row in self._rows:
            padded = [*before, *[0] * len(row)]
            rows += [2 * len(row), *(_folded(np.subtract(row, padded[: len(row)])))]
            before = row
        table = [2 * number for entry in self._table for number in entry[:3]]
        rests = [_folded(rest.ravel()) for *_, rest in self._table]
        numbers = _bytes(np.concatenate([np.array([*rows, *table], np.int64), *rests]))
        return zlib.compress(len(text).to_bytes(4, "little") + text + numbers, 9)


def _name(thing):
    return json.dumps(thing, separators=(",", ":"))


def _steps(numbers):
    return np.diff(numbers, axis=1, prepend=0)


def _cost(numbers):
    """About how many bits they need."""
    return np.log2(1 + abs(numbers)).sum()


def _folded(numbers):
    """0, -1, 1, -2 … as 0, 1, 2, 3 …"""
    numbers = np.asarray(numbers, np.int64)
    return np.where(numbers < 0, -2 * numbers - 1, 2 * numbers)


def _bytes(numbers):
    """Numbers from 0 on in groups of seven bits, the lowest first; the highest bit says that more follow."""
    parts = numbers[:, None] >> np.arange(0, 35, 7)
    used = (parts > 0) | (np.arange(5) == 0)
    more = np.column_stack([parts[:, 1:] > 0, np.zeros(len(parts), bool)])
    return ((parts & 127) | 128 * more).astype(np.uint8)[used].tobytes()
