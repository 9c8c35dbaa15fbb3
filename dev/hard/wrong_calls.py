"""Calls of the package's functions with one to three of their arguments twisted."""

from copy import copy
from functools import cache
from inspect import signature

import numpy as np

import kflearn
from dev.hard.junk import Inputs, Junk, print_of
from kflearn import FILTERS, Gaussian, LinearModel, NonlinearModel


def turn(x, *u):
    return x + 0.1 * np.sin(x) + sum(u)


def first(x):
    return x[..., :1]


def good():
    """Good arguments, fresh for every call; `None` stands for what is made from the others.

    What a filter alone takes is in its row of FILTERS.
    """
    rows = {name: value for row in FILTERS for name, value in {**row.needed, **row.optional}.items()}
    return {name: copy(value) for name, value in rows.items()} | dict(
        F=np.array([[1.0, 1.0], [0.0, 1.0]]), H=np.array([[1.0, 0.0]]), Q=np.eye(2), R=np.array([[2.0]]),
        B=np.array([[0.5], [1.0]]), mean=np.array([0.0, 1.0]), cov=4 * np.eye(2), z=np.array([1.0, np.nan, 3.0]),
        u=np.array([0.0, 1.0, 0.0]), truth=np.ones((3, 2)), model=None, initial=None, track=None, models=None, f=turn,
        h=first, F_jacobian=None, H_jacobian=None, residual=None, scale=1.0, state_residual=None,
        nominal=None, dt=0.5, rate=0.2, mass=2.0, acceleration=1.0, acceleration_increment=1.0, window=2, lags=1,
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
        "model",
        lambda g: NonlinearModel(g.f, g.h, g.Q, g.R, g.F_jacobian, g.H_jacobian, g.residual, g.scale, g.state_residual),
    )


def belief(g):
    return g.made("initial", lambda g: Gaussian(g.mean, g.cov))


def track(g):
    return g.made("track", lambda g: kflearn.kalman_filter(linear(g), g.z, belief(g)))


def settings(function):
    """The names of a function's keyword arguments; `through` takes functions of the package, not of learners."""
    parameters = signature(function).parameters.values()
    return [each.name for each in parameters if each.kind == each.KEYWORD_ONLY and each.name != "through"]


def filters(function, models=(linear, bent)):
    """Calls of a filter over a series, one for each kind of model."""
    names = ["u", *settings(function)]
    return [lambda g, m=m: function(m(g), g.z, belief(g), **{name: g[name] for name in names}) for m in models]


def several(function):
    """The same for a filter of several models."""
    return filters(function, [lambda g: g.made("models", lambda g: [linear(g), bent(g)])])


def calls_of(row):
    """The calls of one row of FILTERS."""
    if row.several:
        return several(row.function)
    return filters(row.function, (linear,) if row.models == "linear" else (linear, bent))


CALLS_TRIED = [
    *(call for row in FILTERS for call in calls_of(row)),
    *filters(kflearn.two_filter_smoother, (linear,)),
    lambda g: kflearn.rts_smoother(linear(g), track(g)),
    lambda g: kflearn.predict(linear(g), belief(g), g.mass, k=g.k),
    lambda g: kflearn.correct(bent(g), belief(g), g.mass, k=g.k),
    lambda g: kflearn.kalman_step(g.mass, g.R, g.mean, g.cov, g.F, g.H, g.Q, g.B),
    lambda g: kflearn.start_from(kflearn.random_walk(g.Q, g.cov), g.mean),
    lambda g: kflearn.constant_velocity(g.dt, g.acceleration, g.R),
    lambda g: kflearn.constant_acceleration(g.dt, g.acceleration_increment, g.R),
    lambda g: kflearn.singer(g.dt, g.rate, g.acceleration, g.R),
    lambda g: kflearn.cart(g.dt, g.mass, g.Q, g.R),
    lambda g: Gaussian(g.mean, g.cov).fuse(g.made("other", belief)),
    lambda g: Gaussian(g.mean, g.cov).marginal(g.indices),
    lambda g: kflearn.nees(track(g), g.truth),
    lambda g: kflearn.rmse(g.truth, g.nominal if g.nominal is not None else g.truth),
    lambda g: kflearn.coverage(track(g), g.truth, g.sigmas),
    lambda g: kflearn.whiteness(track(g), g.lags),
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
    tally, junk = Inputs(), Junk(3)
    while tally.tried < inputs:
        call, given = CALLS_TRIED[tally.tried % len(CALLS_TRIED)], Given(good())
        if tally.tried < len(CALLS_TRIED):
            call(given)  # good arguments pass, or there is nothing to be learnt from the bad ones
        names = asked(call)
        for name in junk.rng.sample(names, min(len(names), junk.rng.choice([1, 1, 2, 3]))):
            given[name] = twisted(given[name], junk)
        before = print_of(dict(given))
        tally.tried += 1
        try:
            call(given)
            tally.ends["accepted"] += 1
        except Exception as error:
            tally.ends["refused"] += 1
            if type(error) not in (ValueError, TypeError):
                tally.faults.append(f"{type(error).__name__}: {error}"[:60])
        if print_of(dict(given)) != before:
            tally.changed.append(", ".join(names))
    return tally


@cache
def asked(call):
    """The arguments a call asks for."""
    given = Given(good())
    call(given)
    return list(given.asked)
