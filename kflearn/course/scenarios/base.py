"""What a system of the course is made of."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...core.frozen import Frozen, freeze
from ...models import checks as check
from ...models.gaussian import Gaussian
from ...models.simulation import Simulation, simulate
from ...models.state_space import LinearModel, NonlinearModel


@dataclass(frozen=True, eq=False)
class Scenario(Frozen):
    """One system of the course. It can be copied and pickled; its arrays are read-only.

    Attributes
    ----------
    description : str
        One sentence.
    model : LinearModel or NonlinearModel
        What the filter assumes.
    initial : Gaussian
        What the filter believes one step before the first measurement.
    truth_model : LinearModel, NonlinearModel or None
        What really happens.
    truth_start : Gaussian, ndarray (n,) or None
        Where that starts: a state, or a Gaussian to draw it from.
    steps : int
        T, the length of a series.
    u : ndarray (T, p), optional
        The control input known to the filter.
    truth_u : ndarray (T, p), optional
        The one that really acts.
    """

    description: str
    model: LinearModel | NonlinearModel
    initial: Gaussian
    truth_model: LinearModel | NonlinearModel | None
    truth_start: Gaussian | np.ndarray | None
    steps: int
    u: np.ndarray | None = None
    truth_u: np.ndarray | None = None

    def __post_init__(self):
        freeze(vars(self))

    def simulate(self, runs=None, rng=None) -> Simulation:
        """True states and measurements of `runs` runs.

        Parameters
        ----------
        runs : int, optional
            Without it there is a single run and no axis for runs.
        rng : numpy.random.Generator, int or None
            A generator or a seed.

        Returns
        -------
        Simulation
            x (runs, T, n), z (runs, T, m), u (T, p) or None.
        """
        truth = simulate(self.truth_model, self.truth_start, self.steps, self.truth_u, runs, rng)
        return Simulation(truth.x, truth.z, self.u)


@dataclass(frozen=True, eq=False)
class Recorded(Scenario):
    """A system whose data no model made; truth_model and truth_start are None.

    record(steps, rng) returns one run: true states (T, n), measurements (T, m) and, where each run has its own, control
    inputs (T, p).
    """

    record: Callable = None  # type: ignore[assignment]  # always given

    def simulate(self, runs=None, rng=None) -> Simulation:
        """As Scenario.simulate; u (runs, T, p) where each run has its own."""
        rng = check.generator("rng", rng)
        if runs is None:
            parts = self.record(self.steps, rng)
        else:
            series = [self.record(self.steps, rng) for _ in range(check.whole_number("runs", runs))]
            parts = [np.stack(part) for part in zip(*series, strict=True)]
        x, z, *u = parts
        return Simulation(x, z, u[0] if u else self.u)


def choose(choices, variant):
    """What belongs to a variant; a ValueError that names all of them for any other."""
    return choices[check.word("variant", variant, choices)]
