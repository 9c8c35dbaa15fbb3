"""The two-filter smoother: one filter runs forwards, one backwards, and their beliefs are fused at every step."""

import numpy as np

from ..core.conditioning import decouple_missing
from ..core.matrices import inverse_lower, root, step_matrix, with_batch
from ..core.recursion import linear_recursion, matvec_each_step
from ..core.walk import Walk, pick, same_root, walk
from ..models.gaussian import Gaussian, unchecked_gaussian
from ..results.track import read_only
from .linear import gap_kinds
from .square_root import square_root_kalman_filter, triangular, turned


def two_filter_smoother(model, z, initial, u=None) -> Gaussian:
    """The smoothed beliefs from two filters, one running forwards and one backwards, fused at every step.

    The backward filter knows nothing at the end of the series and so carries information, Y = P⁻¹ and y = P⁻¹x. At step
    k the forward filter has used z_k and the backward one has not: each measurement counts once.

    Parameters
    ----------
    model, z, initial, u
        As in kalman_filter.

    Returns
    -------
    Gaussian
        Like that of rts_smoother, equal to it but for rounding.

    Raises
    ------
    ValueError, TypeError
        As in kalman_filter, and where one filter knows so much more than the other that they cannot be fused.

    References
    ----------
    Fraser and Potter 1969.

    Examples
    --------
    >>> from kflearn import Gaussian, random_walk, two_filter_smoother
    >>> smooth = two_filter_smoother(random_walk(1, 1), [1.0, 2.0, 3.0], Gaussian(0, 1))
    >>> print(f"first step: {smooth.mean[0, 0]:.3f} ± {smooth.std[0, 0]:.3f}")
    first step: 1.143 ± 0.690
    """
    return read_only(unchecked_gaussian(*_fused(model, square_root_kalman_filter(model, z, initial, u))))


def _fused(model, forward):
    """Means and covariances given what the forward filter and the measurements ahead say."""
    T, before = forward.mean.shape[-2], forward._later.plan
    after, s = _ahead(model, forward)
    L, M = before.parts.root, after.parts[0]
    if L.ndim > 3 or M.ndim > 3:
        which, L, M = None, before.each(L, T), after.each(M, T)[..., ::-1, :, :]
    else:  # each pair of a belief and what is ahead of it once
        pairs = before.rows(T) * len(M) + after.rows(T)[..., ::-1]
        distinct, which = np.unique(pairs, return_inverse=True)
        which, L, M = which.reshape(pairs.shape), L[distinct // len(M)], M[distinct % len(M)]
    told = _comparable(L.mT @ M)
    half = triangular(np.concatenate([np.broadcast_to(np.eye(model.n), told.shape), told], axis=-1))
    kept = np.linalg.inv(half).mT  # (I + LᵀYL)⁻¹ = kept keptᵀ, and P₊ = (P⁻¹ + Y)⁻¹ = L kept keptᵀ Lᵀ
    mean = forward.mean + matvec_each_step(L, _in_units(kept, told, s, which), which)
    P = L @ kept
    return mean, pick(P @ P.mT, which, T)


def _in_units(kept, told, s, which):
    """How far the mean moves, in units of the forward root: the solution ξ of (I + told toldᵀ) ξ = told s.

    Solved twice, the second time for what is left: where s is millions, the first answer lacks digits.
    """

    def solve(right):
        return matvec_each_step(kept, matvec_each_step(kept.mT, right, which), which)

    move = solve(matvec_each_step(told, s, which))
    left = s - matvec_each_step(told.mT, move, which)
    return move + solve(matvec_each_step(told, left, which) - move)


def _comparable(told):
    """What measurements tell, in standard deviations of what they tell of: refused where digits cannot hold both."""
    if not (abs(told) < 1e15).all():
        raise ValueError("Q must be smaller beside R: the two filters are 1e15 times apart and cannot be fused")
    return told


def _ahead(model, forward):
    """What the measurements after each step say of its state: the Walk of _backwards, and s (..., T, n).

    M s = y − Y x̂ says by how much they disagree with the filter's mean x̂. s has a recursion of its own, driven by
    innovations: to subtract y − Y x̂ would lose digits where both are large, and the control input cancels.
    """
    missing = np.isnan(forward._later.z)
    plan, scale = _backwards(model, missing)
    T = missing.shape[-2]
    M, back, inward = (plan.each(part, T)[..., ::-1, :, :] for part in plan.parts)
    seen = matvec_each_step(scale, np.where(missing, 0, forward.innovation.mean))
    learnt = matvec_each_step(M.mT, forward.learnt)
    drive = (matvec_each_step(back, learnt) + matvec_each_step(inward, seen))[..., ::-1, :]
    s = linear_recursion(plan.parts[1], drive, np.zeros(model.n), plan.index)[..., -2::-1, :]
    return plan, np.concatenate([s, np.zeros((*s.shape[:-2], 1, model.n))], axis=-2)


def _backwards(model, missing):
    """A Walk from the last step to the first, and R^-½ (..., m, m), which gives innovations the variance 1.

    Its parts: a root M of the information Y = M Mᵀ ahead of each step, and what carries s and an innovation one step
    back.
    """
    T, start = missing.shape[-2], np.zeros((model.n, model.n))
    masks, gaps = gap_kinds(missing)
    shared = all(M.ndim == 2 for M in (model.F, model.H, model.Q, model.R))
    H, R = model.H, model.R
    if masks.any():
        gone = masks if shared else masks[gaps]
        H, R = H * ~gone[..., :, None], decouple_missing(R, gone)
    scale = inverse_lower(root(R))
    told = (scale @ H).mT  # a root of HᵀR⁻¹H
    if shared:
        G, told = root(model.Q), np.broadcast_to(told, (len(masks), *told.shape[-2:]))
        plan = walk(gaps[..., ::-1], start, lambda M, gap: _one_back(M, model.F, G, told[gap]), same_root)
        return plan, scale[gaps] if masks.any() else scale
    M, parts = start, []
    for k in range(T - 1, -1, -1):
        F, G = step_matrix(model.F, k), root(step_matrix(model.Q, k))
        M, part = _one_back(M, F, G, step_matrix(told, k))
        parts.append(part)
    return Walk(tuple(np.stack(np.broadcast_arrays(*part), axis=-3) for part in zip(*parts, strict=True))), scale


def _one_back(M, F, G, told):
    """A root of the information before a step x' = F x + G w, from that after it; and what is kept for the step.

    M gains the columns of a measurement, loses what the noise w hides (a correction again, with Gᵀ in the place of H
    and I in the place of R), and goes through Fᵀ. All three are turns of its columns; s turns with them.
    """
    batch, n = np.broadcast_shapes(M.shape[:-2], F.shape[:-2], G.shape[:-2], told.shape[:-2]), F.shape[-1]
    with_z, first = turned(np.concatenate([with_batch(M, batch), with_batch(told, batch)], axis=-1))
    hidden = _comparable(G.mT @ with_z)
    array = np.zeros((*batch, 2 * n, 2 * n))
    array[..., :n, :n], array[..., :n, n:], array[..., n:, :n] = hidden, np.eye(n), with_z
    array, second = turned(array)
    before, third = turned(F.mT @ array[..., n:, n:])
    turn = third.mT @ second[..., :n, n:].mT @ first.mT
    return before, (M, turn[..., :n], turn[..., n:])
