"""From continuous time to steps of any length: Van Loan's method."""

from typing import NamedTuple

import numpy as np

from ..core.matrices import symmetric
from . import checks as check


class Discrete(NamedTuple):
    """What one step, or each step of a series, does: F and Q, (n, n) each, or stacks (..., T, n, n)."""

    F: np.ndarray
    Q: np.ndarray


def discretise(A, L, q, dt) -> Discrete:
    """F and Q of steps of any length, for a model in continuous time: ẋ = A x + L w.

    w is white noise of intensity q. F = exp(A dt), and Q = ∫ exp(A t) L q Lᵀ exp(A t)ᵀ dt from 0 to dt. Both stand in
    one matrix exponential, of [[−A, L q Lᵀ], [0, Aᵀ]] dt: Aᵀ gives Fᵀ below on the right, and Q is F times what
    comes above it. It is taken for a part of the step, dt/2ˢ, so short that nothing grows large in it; then the step is
    doubled s times, F → F F and Q → F Q Fᵀ + Q.

    Parameters
    ----------
    A : array_like (n, n)
        How the state moves by itself, in 1/s times the units of the states.
    L : array_like (n, p)
        Where the noise enters.
    q : float or array_like (p, p)
        Intensity of the noise: the variance that the sum of its pushes gains in a second.
    dt : float or array_like (..., T)
        Seconds, 0 or more: one number, or one for each step. In 0 s nothing moves: F = I and Q = 0.

    Returns
    -------
    Discrete
        (F, Q).

    Raises
    ------
    ValueError or TypeError
        Naming the argument; also where exp(A dt) is too large for a float.

    References
    ----------
    C. F. Van Loan, Computing integrals involving the matrix exponential, IEEE Transactions on Automatic Control 23,
    1978.

    Examples
    --------
    >>> from kflearn import discretise
    >>> F, Q = discretise(A=[[0, 1], [0, 0]], L=[[0], [1]], q=1, dt=[1, 3])  # white noise pushes a velocity
    >>> print(F[1], Q[1], sep="; ")
    [[1. 3.]
     [0. 1.]]; [[9.  4.5]
     [4.5 3. ]]
    """
    A = check.square("A", A)
    check.shape("A", A, (None, None), exact=True)
    n = A.shape[-1]
    L = check.shape("L", check.matrix("L", L, n, None), (n, None), exact=True)
    q = check.shape("q", check.covariance("q", q, L.shape[-1]), (None, None), exact=True)
    dt = check.time_steps("dt", dt, zero=True)
    with np.errstate(all="ignore"):
        F, Q = _van_loan(A, L @ q @ L.T, dt)
    if not (np.isfinite(F).all() and np.isfinite(Q).all()):
        raise ValueError(f"dt must be shorter: in {dt.max():g} s the state of this A grows beyond what floats can hold")
    return Discrete(F, Q)


def _van_loan(A, noise, dt):
    """F and Q for noise (n, n) in each state and second; nothing is checked."""
    n, size = len(A), abs(noise).max() or 1.0
    doublings = max(0, int(np.ceil(np.log2(max(np.linalg.norm(A, 1) * dt.max(), 1e-9)))) + 1)
    block = np.block([[-A, noise / size], [np.zeros_like(A), A.T]]) * (dt / 2.0**doublings)[..., None, None]
    whole = term = np.eye(2 * n)
    for k in range(1, 20):  # A dt/2ˢ is at most ½: what is left out of the exponential is below a rounding error
        term = term @ block / k
        whole = whole + term
    F = whole[..., n:, n:].mT
    Q = symmetric(F @ whole[..., :n, n:])
    for _ in range(doublings):
        F, Q = F @ F, symmetric(F @ Q @ F.mT + Q)
    return F, size * Q
