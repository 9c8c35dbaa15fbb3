"""The report card: how often it fails an honest filter, and how surely a wrong one."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.stats import binom

from dev.hard.line import Line
from kflearn import Gaussian, LinearModel, kalman_filter, report_card
from kflearn.results.track import Track

HONEST = (0.04, 0.06)  # how often an honest filter may fail, over all kinds together
POWER = 0.9  # how surely a wrong filter fails at the lengths that are named
DOUBT = 0.001  # how often a line may fail by bad luck
REMEMBERED = 8.1  # variance of an error with a memory


def walk(dt, q, m=1):
    """F, H, Q of m quantities that drift, for steps dt (T,)."""
    each = np.eye(m)
    return np.broadcast_to(each, (len(dt), m, m)), each, q * dt[:, None, None] * each


def velocity(dt, q, m=1):
    """F, H, Q of a constant velocity with white acceleration in m directions."""
    one, none, each = np.ones_like(dt), np.zeros_like(dt), np.eye(m)
    F = np.moveaxis(np.array([[one, dt], [none, one]]), -1, 0)
    Q = q * np.moveaxis(np.array([[dt**3 / 3, dt**2 / 2], [dt**2 / 2, dt]]), -1, 0)
    return np.kron(each, F), np.kron(each, [[1, 0]]), np.kron(each, Q)


def swing(dt, q, m=1):
    """F, H, Q of a damped oscillation with a period of 12 s."""
    turn = 2 * np.pi / 12
    c, s = np.cos(turn * dt), np.sin(turn * dt)
    fade = np.exp(-dt / 30)
    F = np.moveaxis(fade * np.array([[c, s], [-s, c]]), -1, 0)
    return F, np.array([[1.0, 0]]), q * dt[:, None, None] * np.eye(2)


def remembering(dt, q, m=1):
    """F, H, Q of a constant velocity, and of an error that fades in 10 s."""
    F, _, Q = velocity(dt, q)
    fade = np.exp(-dt / 10)
    zero = np.zeros((len(dt), 2, 1))
    F = np.block([[F, zero], [zero.mT, fade[:, None, None]]])
    Q = np.block([[Q, zero], [zero.mT, (REMEMBERED * (1 - fade**2))[:, None, None]]])
    return F, np.array([[1.0, 0, 1]]), Q


@dataclass(frozen=True)
class Kind:
    """A kind of recording: the model, its numbers, and what the recording is like.

    still: rows at rest in front, from which R is taken; 0: the filter is told R. pooled: one R from all columns.
    """

    name: str
    make: Callable
    T: int
    q: float
    R: float
    m: int = 1
    still: int = 0
    pooled: bool = False
    gaps: float = 0.0
    gate: float | None = 0.999
    uneven: bool = False

    def records(self, rng, runs, memory=0.0, push=0.0):
        """(z, dt): readings (runs, T, m) of simulated truths, and the steps between them."""
        dt = rng.uniform(0.5, 1.5, self.T - 1) if self.uneven else np.ones(self.T - 1)
        F, H, Q = self.make(dt, self.q, self.m)
        n, root = F.shape[-1], np.linalg.cholesky(Q + 1e-12 * np.eye(F.shape[-1]))
        x = np.zeros((runs, self.T, n))
        if self.make is remembering:
            x[:, 0, 2] = np.sqrt(REMEMBERED) * rng.normal(size=runs)
        shove = push * Q[:, :, -1] / self.q
        for k in range(self.T - 1):
            x[:, k + 1] = x[:, k] @ F[k].T
            if k + 1 >= self.still:
                x[:, k + 1] += rng.normal(size=(runs, n)) @ root[k].T + shove[k]
        z = x @ H.T + np.sqrt(self.R) * self.noise(rng, runs, memory)
        gap = rng.random(z.shape) < self.gaps
        gap[:, 0] = False
        return np.where(gap, np.nan, z), dt

    def noise(self, rng, runs, memory):
        """Errors with variance 1 that keep this share of themselves each step."""
        v = rng.normal(size=(runs, self.T, self.m))
        for k in range(1, self.T if memory else 0):
            v[:, k] = memory * v[:, k - 1] + np.sqrt(1 - memory**2) * v[:, k]
        return v

    def filters(self, z, dt, q, R):
        """The models of the filters, one for each record, and where they start."""
        found = np.full((len(z), self.m), self.R)
        if self.still:
            found = np.nanvar(z[:, : self.still], axis=1, ddof=1)
            found = np.broadcast_to(found.mean(axis=1, keepdims=True), found.shape) if self.pooled else found
        F, H, Q = self.make(dt, q * self.q, self.m)
        model = LinearModel(F, H, Q, R * found[:, None, :, None] * np.eye(self.m))
        if self.make is remembering:
            first, variances = [1, 0, 0], [REMEMBERED + self.R, 9.0, REMEMBERED]
            return model, Gaussian(z[:, 0] * first, np.diag(variances))
        variances = np.where(H.any(axis=0), (R * found) @ abs(H), 9.0 if self.make is velocity else self.R)
        return model, Gaussian(z[:, 0] @ H, variances[..., None] * np.eye(H.shape[1]))

    def cards(self, rng, runs, q=1.0, R=1.0, **wrong):
        """The cards of filters with these times the true q and R, on so many records with what is wrong."""
        z, dt = self.records(rng, runs, **wrong)
        models, start = self.filters(z, dt, q, R)
        hidden, tracks, rest = [], [], np.arange(self.T) < self.still

        def spy(part):
            hidden.append(np.isnan(part).all(axis=1) & ~np.isnan(z[0]).all(axis=1))
            model = models.replace(R=models.R[0])
            belief = Gaussian(start.mean[0], start.cov if start.cov.ndim == 2 else start.cov[0])
            return model, kalman_filter(model, part[1:], belief, gate=self.gate)

        report_card(z[0], rest, spy)
        for rows in hidden:
            part = np.where(rows[:, None], np.nan, z)
            tracks.append(kalman_filter(models, part[:, 1:], start, gate=self.gate))
        for run in range(runs):
            parts = iter(tracks)
            yield report_card(z[run], rest, lambda _, k=run, parts=parts: one_of(models, next(parts), k))


def one_of(models, track, k):
    """One of many runs that were filtered together, as if it had been filtered by itself."""
    one = object.__new__(Track)
    beliefs = {name: Gaussian.__new__(Gaussian) for name in ("filtered", "predicted", "innovation")}
    for name, belief in beliefs.items():
        whole = getattr(track, name)
        vars(belief).update(mean=whole.mean[k], cov=whole.cov[k])
    refused = track.refused[k]
    vars(one).update(**beliefs, nis=track.nis[k], u=None, _refused=refused)
    return models.replace(R=models.R[k]), one


KINDS = (
    Kind("walk, 50 readings", walk, 50, 0.3, 1.0),
    Kind("walk, 100, no gate", walk, 100, 1.0, 1.0, gate=None),
    Kind("walk, 200, R of 60 at rest", walk, 200, 0.1, 1.0, still=60),
    Kind("two walks, 300, gaps", walk, 300, 0.2, 1.0, m=2, gaps=0.1),
    Kind("walk, 2000, a gate of 99 %", walk, 2000, 0.2, 1.0, gate=0.99),
    Kind("velocity, 100", velocity, 100, 0.5, 9.0),
    Kind("velocity, 260, R of 60 at rest", velocity, 260, 0.5, 9.0, still=60),
    Kind("two velocities, 290, one R of 45", velocity, 290, 0.5, 9.0, m=2, still=45, pooled=True, uneven=True),
    Kind("two velocities, 400, gaps", velocity, 400, 0.1, 9.0, m=2, gaps=0.1, uneven=True),
    Kind("velocity, 1000, R of 100", velocity, 1000, 0.05, 4.0, still=100),
    Kind("oscillation, 500", swing, 500, 0.1, 1.0, gate=None),
    Kind("error with a memory, 300", remembering, 300, 0.5, 0.9),
)

RIDE = Kind("velocity, 260, R of 60 at rest", velocity, 260, 0.5, 9.0, still=60)
TOLD = Kind("velocity, 260", velocity, 260, 0.5, 9.0)
WALK = Kind("walk, 200", walk, 200, 0.2, 1.0)

WRONG = (  # what is wrong, the kind of recording, the filter's R and q as multiples of the true ones, the recording
    ("R half", TOLD, dict(R=0.5), {}),
    ("R half", KINDS[9], dict(R=0.5), {}),
    ("R half", WALK, dict(R=0.5), {}),
    ("Q a tenth", RIDE, dict(q=0.1), {}),
    ("Q a tenth", WALK, dict(q=0.1), {}),
    ("Q ten times", RIDE, dict(q=10.0), {}),
    ("a push that F does not know", RIDE, {}, dict(push=1.5)),
    ("an error that keeps 0.8 of itself", RIDE, {}, dict(memory=0.8)),
    ("a gate that locks the filter out", RIDE, dict(q=0.01), {}),
)


def lines(quick):
    """First the honest filters of all kinds together, then each wrong one."""
    runs, few = (4, 4) if quick else (340, 100)
    yield from honest(runs)
    for number, (what, kind, told, how) in enumerate(WRONG):
        rng = np.random.default_rng([10, number])
        caught = np.mean([not card.passed for card in kind.cards(rng, few, **told, **how)])
        doubt = np.sqrt(max(caught * (1 - caught), 1 / few) / few)
        good = caught >= binom.ppf(DOUBT, few, POWER) / few
        short = f"  {what}; {kind.name.partition(', R of')[0]}"
        yield Line(short, f"{caught:.0%} ± {doubt:.0%} found", f"≥ {POWER:.0%}", bool(good))


def honest(runs, kinds=KINDS):
    """The share of honest filters that fail their card: of all kinds together, and of the kinds by themselves."""
    failed = np.array([_failed(kind, number, runs) for number, kind in enumerate(kinds)])
    share, N = failed.mean() / runs, len(kinds) * runs
    doubt = np.sqrt(max(share * (1 - share), 1 / N) / N)
    low, high = HONEST if N >= 4000 else binom.ppf([DOUBT, 1 - DOUBT], N, HONEST) / N
    words = f"{share:.1%} ± {doubt:.1%} of {N}"
    yield Line("report card: honest filters that fail", words, f"{low:.1%} to {high:.1%}", bool(low <= share <= high))
    top = binom.isf(DOUBT / len(kinds), runs, HONEST[1])
    worst = int(failed.argmax())
    words = f"{failed.max() / runs:.1%}, {kinds[worst].name}"
    yield Line(f"  most of one of {len(kinds)} kinds", words, f"≤ {top / runs:.1%}", bool(failed.max() <= top))


def _failed(kind, number, runs):
    rng = np.random.default_rng([9, number])
    return sum(not card.passed for card in kind.cards(rng, runs))
