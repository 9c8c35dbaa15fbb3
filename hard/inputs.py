"""Input that nobody meant to give: the exercises' check, recordings and the filters' arguments meet junk.

An input is one call. It may end with a result, or with the documented exception and its sentence: nothing else. What
the caller handed in is the same afterwards, byte for byte. All of it follows from seeds.
"""

import copy
import functools
import tempfile
import warnings
from collections import Counter
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules

import numpy as np

import kflearn
import kflearn.exercises
from hard.junk import Junk, print_of
from hard.line import Line
from kflearn import Gaussian, LinearModel, NonlinearModel, recordings
from kflearn.exercises.engine import LEAD, Outcome, exercises_of
from kflearn.recordings import RecordingError

EXERCISES, TABLES, CALLS = 25_000, 45_000, 32_000  # inputs of the full run


class Tally:
    """Inputs counted, and what went wrong with them."""

    def __init__(self):
        self.inputs, self.raised, self.changed, self.ends = 0, [], [], Counter()

    def lines(self, area, documented):
        """Two lines of the table for an area."""
        raised = told(self.raised, self.inputs)
        yield Line(f"{area}: end otherwise", raised, f"only with {documented}", not self.raised)
        yield Line("    caller's data changed", told(self.changed, self.inputs), "never", not self.changed)


def told(faults, inputs):
    """How many of the inputs, and the first of them."""
    return f"{len(faults)} of {inputs:,}" + (f": {faults[0]}" if faults else "")


# ---- exercises


def all_exercises():
    """Every exercise of every lesson."""
    names = [m.name for m in iter_modules(kflearn.exercises.__path__) if not m.name.startswith("_")]
    modules = [import_module(f"kflearn.exercises.{name}") for name in names]
    return [exercise for module in modules for exercise in exercises_of(module)]


def near(exercise, junk):
    """Something like the right answer: its numbers shifted, dressed otherwise, or a function that nearly gives it."""
    right = copy.deepcopy(getattr(exercise, "right", None))
    if right is None:
        return off(exercise, junk)
    if isinstance(right, (str, bool, set, frozenset)) or not isinstance(right, (int, float, np.ndarray)):
        return junk.rng.choice([right, [right], str(right), {"answer": right}, (right, junk.thing())])
    shifted = np.array(right, float) * junk.rng.choice([1, -1, 1000, 1 + 1e-3, np.nan])
    return junk.rng.choice(
        [shifted, shifted.tolist(), str(right), shifted.astype(object), junk.dressed(shifted), [right]]
    )


def off(exercise, junk):
    """A function that answers rightly for a while, then with junk; it overwrites what it was given."""
    left, solve, answer = junk.rng.randrange(4), exercise._answer(), junk.thing()

    def function(*given):
        nonlocal left
        left -= 1
        right = solve(*given)
        for one in given:
            if isinstance(one, np.ndarray) and one.dtype.kind == "f":
                one[...] = np.nan
        return right if left > 0 else answer

    return function


def check_exercises(inputs):
    """Junk, and nearly right answers, for every exercise in turn."""
    tally, exercises, junk = Tally(), all_exercises(), Junk(1, fighters=True)
    secrets = [print_of(known(exercise)) for exercise in exercises]
    while tally.inputs < inputs:
        exercise = exercises[tally.inputs % len(exercises)]
        answer = near(exercise, junk) if junk.rng.random() < 0.1 else junk.thing()
        tally.inputs += 1
        before = print_of(answer)
        try:
            outcome = exercise.check(answer)
            assert isinstance(outcome, Outcome) and outcome.status in LEAD and repr(outcome), "no outcome"
            tally.ends[outcome.status] += 1
        except BaseException as error:
            if isinstance(error, KeyboardInterrupt):
                raise
            tally.raised.append(f"{exercise.name} {type(error).__name__}")
        if print_of(answer) != before:
            tally.changed.append(exercise.name)
    pairs = zip(exercises, secrets, strict=True)
    tally.changed += [f"the answer of {e.name}" for e, secret in pairs if print_of(known(e)) != secret]
    return tally


def known(exercise):
    """What an exercise compares with."""
    return getattr(exercise, "right", None), getattr(exercise, "cases", None)


# ---- recordings

SCRAPS = [
    *",;\t\n\r\"'# \0\ufeff−½١卡\ud800[]()\u2028",
    "\r\n",
    "\n\n",
    "NaN",
    "inf",
    "1e999",
    "-1e-999",
    "1,5",
    "1.234.567",
]
SCRAPS += ["0x10", "1_000", "=1+1", "9" * 400, "2026-05-31T14:05:09+02:00", "0001-01-01", "9999-12-31"]
SCRAPS += ["2026-W10", "[ms]", "time [fortnight]", "x" * 200_000]
TABLE = '# lift\ntime [ms];"height [m]";speed (km/h)\n0;1,5;nan\n20;-2,25;3e1\n45;;4\n60;0;5\n'
DATES = "when,volt [V]\n2026-05-31T14:05:09,1\n2026-05-31T14:05:10.5,\n2026-05-31T14:06,2\n"
BOLD = ["time", "when", "height", "", None, ["speed", "height"], [], ["height", "height"], "ms", "s", "µs", 3]
ENCODINGS = ["utf-8-sig", "utf-8", "utf-16", "cp1252", "gbk", "ascii", "rot13", "hex", "idna", "undefined", "no such"]
ENCODINGS += ["", "a\0", None, 3]


def tables():
    """The texts that are damaged: the examples, shortened, and two with all that a table may hold."""
    heads = [recordings.example(name).read_text(encoding="utf-8").splitlines()[:9] for name in recordings.EXAMPLES]
    return [TABLE, DATES, *("\n".join(head) for head in heads)]


def damaged(text, rng):
    """A text with a few pieces lost, doubled, moved or put in; now and then with none."""
    for _ in range(rng.choice([0, 1, 1, 2, 4, 8])):
        i, j = sorted(rng.choices(range(len(text) + 1), k=2))
        j = rng.choice([i, i + 1, min(j, i + 9)])
        text = text[:i] + rng.choice(["", text[i:j] * 2, *rng.choices(SCRAPS, k=6)]) + text[j:]
    return text


def read_all(table, junk):
    """What a learner does with a recording, with arguments that may be junk."""
    str(table), len(table)
    table[junk.rng.choice([table.names[0], junk.thing()])]
    table.on_grid(junk.rng.choice([None, None, 0.5, junk.thing()]))


def check_recordings(inputs):
    """Damaged texts and files, with arguments that may be junk too."""
    tally, junk, texts = Tally(), Junk(2), tables()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "own.csv")
        while tally.inputs < inputs:
            text, from_file = damaged(junk.rng.choice(texts), junk.rng), tally.inputs % 3 == 0
            odd = junk.rng.random() < 0.5
            settings = {k: option(junk) for k in ("time", "columns", "time_unit") if odd and junk.rng.random() < 0.4}
            if odd and from_file:
                settings["encoding"] = junk.rng.choice([*ENCODINGS, junk.thing()])
            before = print_of(settings)
            tally.inputs += 1
            try:
                if from_file:
                    raw = shaken(text.encode("utf-8", "surrogatepass"), junk.rng)
                    path.write_bytes(raw)
                    table = recordings.read(path if junk.rng.random() < 0.9 else junk.thing(), **settings)
                else:
                    table = recordings.parse(text if junk.rng.random() < 0.95 else junk.thing(), **settings)
                assert np.isfinite(table.time).all() and (np.diff(table.time) > 0).all(), "time runs back"
                assert not np.isinf(table.values).any() and len(table) > 1, "infinite"
                tally.ends["read"] += 1
                read_all(table, junk)
            except RecordingError as error:
                tally.ends["refused"] += 1
                assert str(error).strip(), "an exception without a sentence"
            except Exception as error:
                tally.raised.append(f"{type(error).__name__}: {error}"[:60])
            if print_of(settings) != before or (from_file and path.read_bytes() != raw):
                tally.changed.append(str(list(settings)))
    return tally


def option(junk):
    """A value for an argument of `read`."""
    return junk.rng.choice([*BOLD, junk.thing()])


def shaken(raw, rng):
    """Bytes of which a few are changed."""
    raw = bytearray(raw)
    for _ in range(rng.choice([0, 0, 1, 3]) if raw else 0):
        raw[rng.randrange(len(raw))] = rng.randrange(256)
    return bytes(raw)


# ---- filters

I2 = np.eye(2)


def turn(x, *u):
    return x + 0.1 * np.sin(x) + sum(u)


def first(x):
    return x[..., :1]


def good():
    """Good arguments, fresh for every call; `None` stands for what is made from the others."""
    return dict(
        F=np.array([[1.0, 1.0], [0.0, 1.0]]), H=np.array([[1.0, 0.0]]), Q=np.eye(2), R=np.array([[2.0]]),
        B=np.array([[0.5], [1.0]]), mean=np.array([0.0, 1.0]), cov=4 * np.eye(2), z=np.array([1.0, np.nan, 3.0]),
        u=np.array([0.0, 1.0, 0.0]), truth=np.ones((3, 2)), model=None, initial=None, track=None, models=None, f=turn,
        h=first, F_jacobian=None, H_jacobian=None, residual=None, scale=1.0, nominal=None, dt=0.5, rate=0.2, mass=2.0,
        acceleration=1.0, jerk=1.0, alpha=1.0, beta=2.0, kappa=0.5, considered=[1], window=2, floor=0.1, lags=1,
        transition=np.array([[0.9, 0.1], [0.2, 0.8]]), mode_probabilities=np.array([0.5, 0.5]), states=None, dof=2,
        runs=3, probability=0.9, sigmas=2.0, k=0, indices=[0], other=None,
    )  # fmt: skip


class Given(dict):
    """Arguments that remember which of them a call has asked for."""

    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.asked = {}

    def __getitem__(self, name):
        self.asked[name] = None
        return super().__getitem__(name)

    def __getattr__(self, name):
        return self[name]

    def made(self, name, make):
        """The argument `name`, or what `make` makes in its place."""
        return make(self) if self[name] is None else self[name]


def linear(g):
    return g.made("model", lambda g: LinearModel(g.F, g.H, g.Q, g.R, g.B))


def bent(g):
    return g.made(
        "model", lambda g: NonlinearModel(g.f, g.h, g.Q, g.R, g.F_jacobian, g.H_jacobian, g.residual, g.scale)
    )


def belief(g):
    return g.made("initial", lambda g: Gaussian(g.mean, g.cov))


def track(g):
    return g.made("track", lambda g: kflearn.kalman_filter(linear(g), g.z, belief(g)))


def filters(name, *settings, models=(linear, bent)):
    """Calls of a filter over a series, one for each kind of model."""
    function = getattr(kflearn, name)
    return [lambda g, m=m: function(m(g), g.z, belief(g), **{s: g[s] for s in ("u", *settings)}) for m in models]


def several(name, *settings):
    """The same for a filter of several models."""
    function = getattr(kflearn, name)

    def call(g):
        models = g.made("models", lambda g: [linear(g), bent(g)])
        return function(models, g.z, belief(g), **{s: g[s] for s in ("u", "states", *settings)})

    return [call]


CALLS_TRIED = [
    *filters("kalman_filter", models=(linear,)),
    *filters("square_root_kalman_filter", models=(linear,)),
    *filters("two_filter_smoother", models=(linear,)),
    *filters("extended_kalman_filter"),
    *filters("cubature_kalman_filter"),
    *filters("unscented_kalman_filter", "alpha", "beta", "kappa"),
    *filters("linearized_kalman_filter", "nominal"),
    *filters("schmidt_kalman_filter", "considered", models=(linear,)),
    *filters("adaptive_kalman_filter", "window", "floor"),
    *several("imm_filter", "transition", "mode_probabilities"),
    *several("mmae_filter", "mode_probabilities"),
    lambda g: kflearn.rts_smoother(linear(g), track(g)),
    lambda g: kflearn.predict(linear(g), belief(g), g.mass, g.k),
    lambda g: kflearn.correct(bent(g), belief(g), g.mass, g.k),
    lambda g: kflearn.kalman_step(g.mass, g.R, g.mean, g.cov, g.F, g.H, g.Q, g.B),
    lambda g: kflearn.start_from(kflearn.random_walk(g.Q, g.cov), g.mean),
    lambda g: kflearn.constant_velocity(g.dt, g.acceleration, g.R),
    lambda g: kflearn.constant_acceleration(g.dt, g.jerk, g.R),
    lambda g: kflearn.singer(g.dt, g.rate, g.acceleration, g.R),
    lambda g: kflearn.cart(g.dt, g.mass, g.Q, g.R),
    lambda g: Gaussian(g.mean, g.cov).fuse(g.made("other", belief)),
    lambda g: Gaussian(g.mean, g.cov).marginal(g.indices),
    lambda g: kflearn.nees(track(g), g.truth),
    lambda g: kflearn.rmse(g.truth, g.nominal if g.nominal is not None else g.truth),
    lambda g: kflearn.coverage(track(g), g.truth, g.sigmas),
    lambda g: kflearn.whiteness(g.made("other", lambda g: Gaussian(g.truth, g.cov)), g.lags),
    lambda g: kflearn.nis(track(g)),
    lambda g: kflearn.chi_square_interval(g.dof, g.runs, g.probability),
]


def twisted(value, junk):
    """A good argument made a little wrong, or junk in its place."""
    if not isinstance(value, np.ndarray) or junk.rng.random() < 0.5:
        return junk.thing()
    value, place = value.copy(), junk.rng.randrange(value.size)
    value.flat[place] = junk.rng.choice([np.nan, np.inf, -1, 0, 1e300, 1e-300, value.flat[place] + 1e-6])
    wrong = [
        value,
        value.T,
        value[..., None],
        value[None],
        value[:1],
        value[0],
        -value,
        value.astype(object),
        value * 1j,
    ]
    return junk.dressed(np.array(junk.rng.choice([*wrong, value.astype(object)])))


def check_filters(inputs):
    """Every call with one to three of its arguments twisted."""
    tally, junk = Tally(), Junk(3)
    while tally.inputs < inputs:
        call, given = CALLS_TRIED[tally.inputs % len(CALLS_TRIED)], Given(good())
        if tally.inputs < len(CALLS_TRIED):
            call(given)  # good arguments pass, or there is nothing to be learnt from the bad ones
        names = asked(call)
        for name in junk.rng.sample(names, min(len(names), junk.rng.choice([1, 1, 2, 3]))):
            given[name] = twisted(given[name], junk)
        before = print_of(dict(given))
        tally.inputs += 1
        try:
            call(given)
            tally.ends["accepted"] += 1
        except Exception as error:
            tally.ends["refused"] += 1
            if type(error) not in (ValueError, TypeError):
                tally.raised.append(f"{type(error).__name__}: {error}"[:60])
        if print_of(dict(given)) != before:
            tally.changed.append(", ".join(names))
    return tally


@functools.cache
def asked(call):
    """The arguments a call asks for."""
    given = Given(good())
    call(given)
    return list(given.asked)


def lines(quick):
    """The lines of the table."""
    share = 40 if quick else 1
    checks = [
        ("exercises", check_exercises, EXERCISES, "an outcome"),
        ("recordings", check_recordings, TABLES, "RecordingError"),
        ("filters", check_filters, CALLS, "ValueError, TypeError"),
    ]
    total = 0
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        for area, check, inputs, documented in checks:
            tally = check(inputs // share)
            total += tally.inputs
            yield from tally.lines(area, documented)
    yield Line("inputs in all", f"{total:,}", f">= {100_000 // share:,}", total >= 100_000 // share)
