"""What a system of the course is made of."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .. import _checks as check
from ..gaussian import Gaussian
from ..models import LinearModel, NonlinearModel
from ..simulation import Simulation, simulate


@dataclass(frozen=True, eq=False)
class Scenario:
    """One system of the course.

    model: what the filter assumes; initial: what it believes one step before the first measurement; truth_model: what
    really happens; truth_start: where that starts, a state (n,) or a Gaussian to draw from; steps: T; u: the control
    input (T, p) known to the filter, truth_u the one that really acts.
    """

    description: str
    model: LinearModel | NonlinearModel
    initial: Gaussian
    truth_model: LinearModel | NonlinearModel | None
    truth_start: Gaussian | np.ndarray | None
    steps: int
    u: np.ndarray | None = None
    truth_u: np.ndarray | None = None

    def simulate(self, runs=None, rng=None):
        """Simulation with .x (runs, T, n), .z (runs, T, m), .u (T, p); without `runs` a single run, no first axis."""
        truth = simulate(self.truth_model, self.truth_start, self.steps, self.truth_u, runs, rng)
        return Simulation(truth.x, truth.z, self.u)


@dataclass(frozen=True, eq=False)
class Recorded(Scenario):
    """A system whose data no model made: record(steps, rng) returns one run, true states (T, n) and measurements
    (T, m), and also its own control inputs (T, p) where each run has others.

    truth_model and truth_start are None.
    """

    record: Callable = None

    def simulate(self, runs=None, rng=None):
        """As Scenario.simulate; .u (runs, T, p) where each run has its own."""
        rng = np.random.default_rng(rng)
        if runs is None:
            parts = self.record(self.steps, rng)
        else:
            series = [self.record(self.steps, rng) for _ in range(check.whole_number("runs", runs))]
            parts = [np.stack(part) for part in zip(*series, strict=True)]
        return Simulation(*parts) if len(parts) == 3 else Simulation(*parts, self.u)


def choose(choices, variant):
    """What belongs to a variant; an error that names all of them for any other."""
    if variant not in choices:
        raise ValueError(f"variant must be one of {', '.join(map(repr, choices))}, got {variant!r}")
    return choices[variant]
