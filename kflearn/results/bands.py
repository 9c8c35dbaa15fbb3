"""The bands of the report card: what an honest filter shows by chance, and because R is known from few readings only.

All bands of a card have one level. It is the largest for which an honest filter leaves one band or more in ERROR of all
recordings, were the tests independent (Šidák). A share of few readings cannot have any level: of 20 forecasts all may
lie inside, and none more. Such a test counts with the chance that it really has (Tarone), so that the others get the
rest. The tests are not quite independent; what is left of ERROR is measured over simulated recordings by
`python -m dev.hard values`.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

NODES = 16  # of the distribution of ln S, for shares


@dataclass(frozen=True)
class Around0:
    """A number that is Gaussian around 0, with this standard deviation."""

    std: float

    def limits(self, level):
        """(low, high): outside with this probability."""
        from scipy import stats  # imported here: `import kflearn` shall not wait for SciPy

        z = stats.norm.isf(level / 2)
        return -z * self.std, z * self.std

    def chance(self, level):
        """How often an honest filter is outside the limits of this level."""
        return level


@dataclass(frozen=True)
class Size:
    """The mean of N squared innovations over their variance, of which `moved` is the relative variance.

    kept: the mean that is left behind a gate.
    """

    N: int
    moved: float
    kept: float = 1.0

    def limits(self, level):
        """(low, high): outside with this probability; the distribution is F, or without doubt about S chi-square."""
        from scipy import stats  # imported here: `import kflearn` shall not wait for SciPy

        ends = np.array([level / 2, 1 - level / 2])
        if self.moved:
            low, high = self.kept * stats.f.ppf(ends, self.N, max(5.0, 2 / self.moved))
        else:
            low, high = self.kept * stats.chi2.ppf(ends, self.N) / self.N
        return low, high

    def chance(self, level):
        """How often an honest filter is outside the limits of this level."""
        return level


@dataclass(frozen=True)
class Share:
    """A share of n readings, each inside with the probability `honest`; `moved` is the relative variance of S.

    below: only too few is wrong.
    """

    n: int
    honest: float
    moved: float = 0.0
    below: bool = False

    @cached_property
    def honest_shares(self):
        """What the share may be in the long run, where S may be off: NODES values, equally likely."""
        if not self.moved:
            return np.array([self.honest])
        from scipy import stats  # imported here: `import kflearn` shall not wait for SciPy

        off = np.sqrt(self.moved) * stats.norm.ppf((np.arange(NODES) + 0.5) / NODES)
        reach = stats.norm.isf((1 - self.honest) / 2)
        return 1 - 2 * stats.norm.sf(reach * np.exp(off / 2))

    @cached_property
    def at_most(self):
        """How often an honest filter has 0, 1, … n readings inside, or fewer, (n + 1,)."""
        from scipy.special import bdtr  # imported here: `import kflearn` shall not wait for SciPy

        return bdtr(np.arange(self.n + 1)[:, None], self.n, self.honest_shares).mean(axis=1)

    def count(self, probability):
        """The smallest count that is not exceeded with this probability."""
        return min(int(np.searchsorted(self.at_most, probability)), self.n)

    def limits(self, level):
        """(low, high): outside with this probability, or a smaller one."""
        if self.below:
            return self.count(level) / self.n, np.inf
        return self.count(level / 2) / self.n, self.count(1 - level / 2) / self.n

    def chance(self, level):
        """How often an honest filter is outside the limits of this level."""
        low = self.count(level if self.below else level / 2)
        above = 0.0 if self.below else 1 - self.at_most[self.count(1 - level / 2)]
        return (self.at_most[low - 1] if low else 0.0) + above


def common_level(bands, error) -> float:
    """The largest level at which an honest filter leaves one of these bands, or more, with the probability `error`."""
    low, high = 0.0, error
    for _ in range(20):
        middle = (low + high) / 2
        inside = np.prod([1 - band.chance(middle) for band in bands])
        low, high = (middle, high) if 1 - inside <= error else (low, middle)
    return low


def behind_a_gate(nis, refused, m) -> float:
    """The mean square of a normalised innovation where a gate refuses the largest: 1 if nothing was refused.

    The gate lies just above the largest NIS that it let pass. Of the share that passes, each of the m components has a
    mean square of P(χ² with m + 2 degrees of freedom < gate) by P(χ² with m < gate).
    """
    from scipy.special import gammainc  # imported here: `import kflearn` shall not wait for SciPy

    passed = nis[~np.isnan(nis) & ~refused]
    if not refused.any() or not passed.size:
        return 1.0
    half = passed.max() / 2
    return float(gammainc(m / 2 + 1, half) / gammainc(m / 2, half))
