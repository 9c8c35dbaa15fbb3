"""The same numbers in odd arrays and in odd units: every filter must give the same beliefs, or refuse in a sentence."""

import numpy as np

from dev.hard import draws
from dev.hard.attempt import attempt, beliefs, refusal
from dev.hard.line import Line, Tally
from kflearn import Gaussian, LinearModel, NonlinearModel, simulate
from kflearn.models.gaussian import unchecked_gaussian

STEPS = 12
FAR = 6  # from here on, units that are 10^k and 10^−k of the scenario's, 1e12 of one another, may be refused
SAME, ALIKE = 1e-12, 1e-6  # relative differences: of other arrays, of other units
KNOBS = dict(alpha=0.5, kappa=1.0, leave=0.05, window=5, floor=0.01)


def lines(quick):
    names = ["cart", "bearing"] if quick else draws.NAMES
    cases = [plain(name) for name in names]
    cases += [without_slopes(case) for case in cases if isinstance(case.model, NonlinearModel)]
    powers = [-12, 12] if quick else range(-12, 13)
    yield odd_arrays(cases)
    yield odd_units(cases, "all units × 10^k, k = −12 … 12", powers, lambda count: np.ones(count))
    yield odd_units(cases, "units by turns × 10^k and 10^−k", powers, lambda count: (-1.0) ** np.arange(count), FAR)


def plain(name):
    """One run of a scenario with its own settings."""
    model, initial, u = draws.own(name)
    model = draws.changed(model, lambda M: M[:STEPS] if M.ndim > 2 else M)
    u = None if u is None else u[:STEPS]
    x, z, _ = simulate(model, initial, STEPS, u, rng=8)
    return draws.Case(name, model, initial, x, z, u, KNOBS)


def without_slopes(case):
    """The case with central differences in place of its Jacobians."""
    model = case.model.replace(F_jacobian=None, H_jacobian=None)
    return case._replace(name=f"{case.name} by differences", model=model)


def apart(one, other):
    """How far two beliefs differ, relative to the largest standard deviation of each state and to its means.

    A standard deviation that is 1e-8 of its state comes from a covariance which is a rounding error.
    """
    size = abs(other.mean).max(axis=-2)
    std = np.maximum(other.std.max(axis=-2), 1e-8 * np.where(size > 0, size, 1))
    means = abs(one.mean - other.mean) / (std + abs(other.mean))
    covs = abs(one.cov - other.cov) / (std[:, None] * std)
    return np.nan_to_num(max(means.max(), covs.max()), nan=np.inf)


# ---- odd arrays


def whole(array):
    """As integers, where they are whole: to round a covariance might leave none."""
    return array.astype(int) if (array == np.rint(array)).all() else array


def locked(array):
    array = array.copy()
    array.flags.writeable = False
    return array


KINDS = {
    "float32": lambda array: array.astype(np.float32),
    "integers": whole,
    "lists": lambda array: array.tolist(),
    "read-only": locked,
    "every second element": lambda array: np.repeat(array, 2, axis=-1)[..., ::2],
    "back to front": lambda array: np.flip(np.flip(array).copy()),
    "columns first": np.asfortranarray,
    "the other byte order": lambda array: array.astype(array.dtype.newbyteorder()),
}


def odd_arrays(cases):
    """All arguments in other kinds of arrays, against plain arrays of the same numbers."""
    tally = Comparison(SAME)
    for case in cases:
        for name, kind in KINDS.items():
            numbers = rounded(case) if name == "integers" else case
            odd, held = given(numbers, kind)
            same, _ = given(numbers, lambda array, kind=kind: np.array(kind(array), dtype=float))
            before = [np.array(array) for array in held]
            for title, run in draws.filters(case.model).items():
                tally.take(f"{case.name}, {title}, {name}", attempt(run, odd), attempt(run, same))
            if not all(map(np.array_equal, before, held)):
                tally.faults.append(f"{case.name}, {name}: the caller's arrays are changed")
    return tally.line(f"{len(KINDS)} kinds of arrays, every scenario × filter")


def rounded(case):
    """The case with whole numbers measured, applied and believed in."""
    initial = Gaussian(np.rint(case.initial.mean), case.initial.cov)
    return case._replace(z=np.rint(case.z), u=None if case.u is None else np.rint(case.u), initial=initial)


def given(case, kind):
    """The case made from another kind of arrays, and these."""
    held = []

    def hold(array):
        held.append(kind(array))
        return held[-1]

    initial = Gaussian(hold(case.initial.mean), hold(case.initial.cov))
    u = None if case.u is None else hold(case.u)
    odd = case._replace(model=draws.changed(case.model, hold), initial=initial, z=hold(case.z), u=u)
    return odd, held


# ---- odd units


def odd_units(cases, what, powers, pattern, far=np.inf):
    """State and measurement in units that are 10^(k · pattern) times the scenario's, and the beliefs back again.

    Only from k = ±`far` on a filter may refuse them.
    """
    tally = Comparison(ALIKE)
    for case in cases:
        name, case = case.name, case._replace(name="one model")  # those of manoeuvring do not come in other units
        for title, run in draws.filters(case.model).items():
            right = attempt(run, case)
            for k in powers:
                X, Z = (10.0 ** (k * pattern(count)) for count in (case.model.n, case.model.m))
                found = attempt(lambda run=run, X=X, Z=Z, case=case: back(run(rescaled(case, X, Z)), X))
                tally.take(f"{name}, {title}, k = {k}", found, right, may_refuse=abs(k) >= far)
    return tally.line(what)


def rescaled(case, X, Z):
    """The case with states X and measurements Z times as large as numbers."""
    own, XX, ZZ = case.model, X[:, None] * X, Z[:, None] * Z
    model = own.replace(Q=own.Q * XX, R=own.R * ZZ)
    if isinstance(own, LinearModel):
        B = None if own.B is None else X[:, None] * own.B
        model = model.replace(F=X[:, None] * own.F / X, H=Z[:, None] * own.H / X, B=B)
    else:
        model = model.replace(
            f=lambda x, *u: X * own.f(x / X, *u),
            h=lambda x, u=None, k=0: Z * own.measure(x / X, u, k),
            F_jacobian=own.F_jacobian and (lambda x, *u: X[:, None] * own.F_jacobian(x / X, *u) / X),
            H_jacobian=own.H_jacobian and (lambda x, u=None, k=0: Z[:, None] * own.measure_slope(x / X, u, k) / X),
            residual=lambda z, expected: Z * own.difference(z / Z, expected / Z),
            state_residual=lambda x, other: X * own.state_difference(x / X, other / X),
            scale=X * own.scale,
        )
    initial = Gaussian(X * case.initial.mean, XX * case.initial.cov)
    return case._replace(model=model, initial=initial, z=Z * case.z)


def back(result, X):
    """The first belief of a result, in the scenario's own units."""
    belief = beliefs(result)[0]
    return unchecked_gaussian(belief.mean / X, belief.cov / X / X[:, None])


# ---- the verdict


class Comparison(Tally):
    """How many results were right, how many calls were refused, and what else there was."""

    def __init__(self, bound):
        super().__init__()
        self.bound, self.worst = bound, 0.0

    def take(self, what, found, expected, may_refuse=False):
        """Compare what a filter made of odd numbers with what it made of plain ones."""
        if may_refuse and refusal(found):
            self.ends["refused"] += 1
        elif isinstance(found, Exception) or isinstance(expected, Exception):
            self.faults.append(f"{what}: {type(found).__name__}: {found}")
        else:
            difference = apart(beliefs(found)[0], beliefs(expected)[0])
            self.worst = max(self.worst, difference)
            if difference <= self.bound:
                self.ends["right"] += 1
            else:
                self.faults.append(f"{what}: differs by {difference:.1e}")

    def line(self, what):
        measured = f"{self.ends['right']} right to {self.worst:.0e}, {self.ends['refused']} refused"
        return Line(what, measured, f"{self.bound:.0e}, {self.others()}", not self.faults)
