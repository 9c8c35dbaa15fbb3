"""Angles that wrap in f or h, where no difference for them was given: found out when they do harm, and named.

A function that returns an angle between −π and π jumps by 2π somewhere, and a plain difference of two of its values on
both sides of the jump is wrong by 2π. Nothing is wrong with such a function as long as no filter comes near the jump;
and large differences are right where a function returns metres. Therefore every difference is looked at (is a
component beyond half a turn?), and only then it is found out whether that component stays within a turn, whatever the
state is, and jumps by exactly a turn. What was found is remembered in `model.jumps`.
"""

from functools import cache, partial

import numpy as np

TURNS = (2 * np.pi, 360.0)
TOLD = ("2π", "360")
ADVICE = {
    "f": "give state_residual, which subtracts two states",
    "h": "give residual, which subtracts two measurements",
}


def watched(model, name, x, u, k):
    """The difference of two states ("f") or two measurements ("h") of a model, which refuses jumps of f or h near x.

    x (..., n): the states from which the values come; k: their step, or None where x and u have an axis of steps.
    """
    plain = model.difference if name == "h" else model.state_difference
    jumps = _known(model, name)
    if jumps is None or not jumps["watch"]:
        return plain

    def difference(value, other):
        apart = plain(value, other)
        # A quick test first: here no component is beyond half a turn.
        if not np.vdot(apart, apart) < TURNS[0] ** 2 / 4 and (abs(apart) > jumps["least"]).any():
            _look(model, name, jumps, apart, (x, u, k))
        return apart

    return difference


def _known(model, name):
    """What is known of f's or h's jumps; None where nothing can go wrong: a linear model, or a difference was given.

    limits (size, turns): from where on a difference is suspicious, infinity where there is no such jump. least: the
    smallest of each component. watch: is there any finite limit? found: {(a component, a turn): what jumps}, or None
    before the first suspicion.
    """
    known = getattr(model, "jumps", None)
    if known is None or (model.residual if name == "h" else model.state_residual) is not None:
        return None
    if name not in known:
        limits = np.tile(np.array(TURNS) / 2, (model.m if name == "h" else model.n, 1))
        known[name] = {"limits": limits, "least": limits[:, 0], "watch": True, "found": None}
    return known[name]


def _look(model, name, jumps, apart, at):
    """Raise an error if a component of the differences `apart` (..., m) is beyond half a turn, and jumps by a turn."""
    far = abs(np.where(np.isfinite(apart), apart, 0)).reshape(-1, apart.shape[-1])

    def place(rows):
        """The functions, the state and the step where the largest of `rows` was found."""
        row = np.unravel_index(np.argmax(rows), apart.shape[:-1])
        x, u = (_of_run(each, row) for each in at[:2])
        k = row[-1] if at[2] is None else at[2]
        return _functions(model, name, u, k), x, k

    if jumps["found"] is None:
        functions, x, _ = place(far.max(axis=1))
        within = [_within_turns(function, x, model.scale) for function in functions.values()]
        _exclude(jumps, ~np.logical_or.reduce(np.broadcast_arrays(*within)))
        jumps["found"] = {}
    for pair in map(tuple, np.argwhere(far.max(axis=0)[:, None] > jumps["limits"])):
        functions, x, k = place(far[:, pair[0]])
        if pair not in jumps["found"]:
            for what, function in functions.items():
                jumps["found"] |= dict.fromkeys(jumps_of(function, x, model.scale) - set(jumps["found"]), what)
        if pair in jumps["found"]:
            raise ValueError(f"{jumps['found'][pair]} jumps by {TOLD[pair[1]]} at step {k}: {ADVICE[name]}")
        _exclude(jumps, pair)


def _exclude(jumps, which):
    """Nothing is suspicious any more in these components and turns."""
    jumps["limits"] = jumps["limits"].copy()  # read-only in a copied model
    jumps["limits"][which] = np.inf
    jumps["least"] = jumps["limits"].min(axis=1)
    jumps["watch"] = bool(np.isfinite(jumps["least"]).any())


def _of_run(array, row):
    """The last axis of an array (..., n) that broadcasts to more axes, at the index `row` of those."""
    if array is None:
        return None
    front = array.shape[:-1]
    own = row[len(row) - len(front) :]
    return array[tuple(0 if size == 1 else i for size, i in zip(front, own, strict=True))]


def _functions(model, name, u, k):
    """What may jump, and how it is called: f; or h, and h of what f returns."""
    move, measure = partial(model.move, u=u, k=k), partial(model.measure, u=u, k=k)
    return {"f": move} if name == "f" else {"h": measure, "h(f(x))": lambda x: measure(move(x))}


def _within_turns(function, x, scale):
    """Which components (m, turns) differ by less than a turn, or little more, at states far from x (n,)?"""
    reach = np.array([1000, -1000, 100, -77, 13])[:, None, None] * np.eye(len(x)) * np.maximum(abs(x), scale)
    values = _values(function, np.concatenate([x[None], (x + reach).reshape(-1, len(x))]))
    if values is None:
        return True
    values = np.where(np.isfinite(values), values, values[0])
    return np.ptp(values, axis=0)[:, None] < 1.1 * np.array(TURNS)


def _values(function, points):
    """The values of a function, or None: what it raises far away says nothing of its jumps."""
    try:
        with np.errstate(all="ignore"):
            return function(points)
    except Exception:  # whatever a learner's function raises
        return None


def jumps_of(function, x, scale) -> set[tuple[int, int]]:
    """Which components of a function (..., n) → (..., m) jump by which turn of TURNS, somewhere around x (n,)?

    Lines through x, along each component and in random directions, are tried at points from 1/500 to 2000 times the
    size of x away. Where neighbours differ by about a turn, the interval is halved until it is a point: there a jump
    keeps its height, and a slope does not.
    """
    size, directions = np.maximum(abs(x), scale), _directions(len(x))
    for reach in (3, 1, 0):
        steps = 2 * np.logspace(-3, reach, 20 * (reach + 3))
        points = x + np.concatenate([-steps[::-1], [0], steps])[:, None, None] * directions * size
        values = _values(function, points)
        if values is not None:
            return _confirmed(function, points, values)
    return set()


@cache
def _directions(n):
    """The components' own directions and 16 others, (n + 16, n)."""
    return np.concatenate([np.eye(n), np.random.default_rng(0).uniform(-1, 1, (16, n))])


def _confirmed(function, points, values):
    """The components and turns of jumps between neighbours along the first axis of points (count, lines, n)."""
    with np.errstate(all="ignore"):
        height = abs(np.diff(values, axis=0))[..., None] / TURNS
    step, line, component, turn = np.nonzero((height > 0.5) & (height < 1.5))
    ends = np.stack([points[step, line], points[step + 1, line]])
    at_ends = np.stack([values[step, line, component], values[step + 1, line, component]])
    for _ in range(50):
        if not component.size:
            break
        count = np.arange(component.size)
        middle = ends.mean(axis=0)
        value = _values(function, middle)
        if value is None:
            return set()
        value = value[count, component]
        halves = abs(value - at_ends) / np.take(TURNS, turn)
        kept = np.argmin(abs(halves - 1), axis=0)
        steep = halves[kept, count] > 0.4
        ends = np.stack([ends[kept, count], middle])[:, steep]
        at_ends = np.stack([at_ends[kept, count], value])[:, steep]
        component, turn = component[steep], turn[steep]
    sure = abs(abs(at_ends[0] - at_ends[1]) / np.take(TURNS, turn) - 1) < 0.01
    return set(zip(component[sure].tolist(), turn[sure].tolist(), strict=True))
