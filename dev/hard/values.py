"""Numbers: random settings of every scenario for every filter, playgrounds on a full grid, odd units, report cards."""

from collections import defaultdict

import numpy as np
from scipy.stats import binom

from dev.hard import cards, draws, grid, units
from dev.hard.attempt import attempt, beliefs, refusal
from dev.hard.line import Line, Tally
from kflearn import LinearModel

FEW = ["ship", "bearing"]  # for a quick look
BLOCK = 40  # settings in one call; the knobs of the filters are drawn anew for each call
RUNS = 10  # of each setting, where the covariances do not depend on the data
INSIDE = 0.9544997361036416  # of a Gaussian, within two standard deviations
REFUSED = 0.05  # of the settings at most: with few states, the unscented filter cannot take every kappa of its slider
DOUBT = 0.001  # how often a line on coverage may fail by bad luck


def lines(quick):
    yield from random_settings(FEW, 1) if quick else random_settings(draws.NAMES, 5)
    yield from units.lines(quick)
    yield from grid.lines(quick)
    yield from cards.lines(quick)


# ---- random settings


def random_settings(names, blocks):
    """Every scenario × filter: what comes out is a belief, and an honest one where the model is right."""
    tally = Beliefs()
    for number, name in enumerate(names):
        rng = np.random.default_rng([8, number])
        linear = isinstance(draws.own(name)[0], LinearModel)
        for _ in range(blocks):
            case = draws.case(name, BLOCK, RUNS if linear else 1, rng)
            for title, run in draws.filters(case.model).items():
                tally.take(title, run, case, honest=linear and title not in draws.MORE)
    yield from tally.lines()


class Beliefs(Tally):
    """What the filters did with the cases."""

    def __init__(self):
        super().__init__()
        self.pairs, self.lopsided, self.negative = set(), 0.0, np.inf
        self.inside = defaultdict(list)  # {(scenario, filter, state): counts of runs, one for each setting}

    def take(self, title, run, case, honest):
        """Run a filter on a case; where it refuses the case, on each of its settings."""
        self.pairs.add((case.name, title))
        for part, result in attempts(run, case):
            self.tried += len(part.z)
            if refusal(result):
                self.ends["refused"] += len(part.z)
            elif isinstance(result, Exception):
                self.faults += [f"{part.name}, {title}: {type(result).__name__}: {result}"] * len(part.z)
            elif not all(map(self.look, beliefs(result))):
                self.faults += [f"{part.name}, {title}: not finite"] * len(part.z)
            elif honest:
                self.cover(title, part, beliefs(result)[0])

    def look(self, belief):
        """Is it finite? How symmetric, how positive is P? Of the runs of a setting, the first is looked at."""
        cov = belief.cov[:, 0]
        if not (np.isfinite(belief.mean).all() and np.isfinite(cov).all()):
            return False
        variance = np.diagonal(cov, axis1=-2, axis2=-1)
        scale = np.sqrt(np.where(variance > 0, variance, 1))
        correlation = cov / scale[..., None] / scale[..., None, :]
        self.lopsided = max(self.lopsided, abs(correlation - correlation.mT).max())
        self.negative = min(self.negative, np.linalg.eigvalsh(correlation).min())
        return True

    def cover(self, title, case, belief):
        """Count the runs whose truth lies within ±2σ: at the last step, or half-way where later measurements count."""
        k = draws.STEPS // 2 if "smooth" in title else -1
        std = np.broadcast_to(belief.std, belief.mean.shape)[..., k, :]
        inside = abs(case.x - belief.mean)[..., k, :] <= 2 * std
        for state in np.flatnonzero((std > 0).all(axis=(0, 1))):  # what is known exactly cannot be inside or outside
            self.inside[case.name, title, state] += list(inside[..., state].sum(axis=1))

    def lines(self):
        refused = self.ends["refused"]
        finite = f"{self.tried - refused - len(self.faults)} finite, {refused} refused"
        others = self.others() if self.faults else f"no others, {REFUSED:.0%} refused"
        kept = not self.faults and refused <= REFUSED * self.tried
        yield Line(f"random settings, {len(self.pairs)} pairs scenario × filter", finite, others, kept)
        symmetric, positive = bool(self.lopsided <= 1e-9), bool(self.negative >= -1e-6)
        yield Line("  all P: largest asymmetry, in correlations", f"{self.lopsided:.0e}", "1e-09", symmetric)
        yield Line("  all P: smallest eigenvalue of correlations", f"{self.negative:.0e}", "-1e-06", positive)
        yield self.shares()
        yield self.outsiders()

    def shares(self):
        """Each (scenario, filter, state) over all settings, against the band that 999 of 1000 such tables keep."""
        runs = np.array([RUNS * len(counts) for counts in self.inside.values()])
        shares = np.array([np.mean(counts) / RUNS for counts in self.inside.values()])
        low, high = np.divide(binom.interval(1 - DOUBT / len(runs), runs, INSIDE), runs)
        return Line(
            f"  right model: truth within ±2σ, {len(runs)} shares of {runs.max()} runs",
            f"{shares.min():.1%} to {shares.max():.1%}",
            f"{low.max():.1%} to {high.min():.1%} (exactly {INSIDE:.2%})",
            bool(((low <= shares) & (shares <= high)).all()),
        )

    def outsiders(self):
        """The same for each setting by itself: as many may leave a band of 95 % as chance allows."""
        low, high = binom.interval(0.95, RUNS, INSIDE)
        chance = binom.cdf(low - 1, RUNS, INSIDE) + binom.sf(high, RUNS, INSIDE)
        settings = np.array([len(counts) for counts in self.inside.values()])
        outside = np.array([np.sum((np.array(c) < low) | (np.array(c) > high)) for c in self.inside.values()])
        limit = binom.isf(DOUBT / len(outside), settings, chance)
        return Line(
            f"  of {settings.max()} settings, not {low:.0f} to {high:.0f} of {RUNS} runs within ±2σ",
            f"{outside.mean():.2f} on average, at most {outside.max()}",
            f"{settings.mean() * chance:.2f} expected, {limit.max():.0f}",
            bool((outside <= limit).all()),
        )


def attempts(run, case):
    """(case, result or exception): of a case as a whole or, where that fails, of each of its settings."""
    whole = attempt(run, case)
    alone = [case.alone(i) for i in range(len(case.z))] if isinstance(whole, Exception) else []
    parts = [(part, attempt(run, part)) for part in alone]
    return parts if any(isinstance(result, Exception) for _, result in parts) else [(case, whole)]
