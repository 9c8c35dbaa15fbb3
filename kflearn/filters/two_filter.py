"""The two-filter smoother: one filter runs forwards, one backwards, and their beliefs are fused at every step."""

import numpy as np

from ..core.conditioning import decouple_missing
from ..core.matrices import root, step_matrix, with_batch
from ..core.recursion import linear_recursion, matvec_each_step
from ..core.walk import Walk, same_root, walk
from ..models.gaussian import Gaussian, unchecked_gaussian
from ..results.track import read_only
from .linear import gap_kinds
from .square_root import corrected_root, divide_root, square_root_kalman_filter, triangular


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
    after, q = _ahead(model, forward)
    L, M = before.parts.root, after.parts[0]
    if L.ndim > 3 or M.ndim > 3:
        P = _fused_covariance(before.each(L, T), after.each(M, T)[..., ::-1, :, :])
    else:  # each pair of a belief and what is ahead of it once
        pairs = before.rows(T) * len(M) + after.rows(T)[..., ::-1]
        distinct, which = np.unique(pairs, return_inverse=True)
        P = _fused_covariance(L[distinct // len(M)], M[distinct % len(M)])[which.reshape(pairs.shape)]
    return forward.mean + matvec_each_step(P, q), P


def _fused_covariance(L, M):
    """(P⁻¹ + Y)⁻¹ = L (I + LᵀYL)⁻¹ Lᵀ with P = L Lᵀ and Y = M Mᵀ: neither P nor Y need have an inverse."""
    more = _comparable(L.mT @ M)
    half = triangular(np.concatenate([np.broadcast_to(np.eye(L.shape[-1]), more.shape), more], axis=-1))
    kept = np.linalg.solve(half, L.mT)
    return kept.mT @ kept


def _comparable(told):
    """What measurements tell, in standard deviations of what they tell of: refused where digits cannot hold both."""
    if not (abs(told) < 1e15).all():
        raise ValueError("Q must be smaller beside R: the two filters are 1e15 times apart and cannot be fused")
    return told


def _ahead(model, forward):
    """What the measurements after each step say of its state: the Walk of _backwards, and q = y − Y x̂ (..., T, n).

    q says by how much they disagree with the filter's mean x̂. It has a recursion of its own, driven by innovations; to
    subtract y − Y x̂ would lose digits where both are large, and in q the control input cancels.
    """
    missing = np.isnan(forward._later.z)
    seen = np.where(missing, 0, forward.innovation.mean)
    plan, weights = _backwards(model, missing)
    T = missing.shape[-2]
    M, back = (plan.each(part, T)[..., ::-1, :, :] for part in plan.parts)
    learnt = matvec_each_step(M.mT, forward.mean - forward.predicted.mean)
    learnt = matvec_each_step(M, learnt) + matvec_each_step(weights, seen)
    drive = matvec_each_step(back, learnt)[..., ::-1, :]
    q = linear_recursion(plan.parts[1], drive, np.zeros(model.n), plan.index)[..., -2::-1, :]
    return plan, np.concatenate([q, np.zeros((*q.shape[:-2], 1, model.n))], axis=-2)


def _backwards(model, missing):
    """A Walk from the last step to the first, and the weights HᵀR⁻¹ (..., n, m) of the measurements.

    The parts: a root M of the information Y = M Mᵀ ahead of each step, and what carries information one step back.
    """
    T, start = missing.shape[-2], np.zeros((model.n, model.n))
    masks, gaps = gap_kinds(missing)
    shared = all(M.ndim == 2 for M in (model.F, model.H, model.Q, model.R))
    H, R = model.H, model.R
    if masks.any():
        gone = masks if shared else masks[gaps]
        H, R = H * ~gone[..., :, None], decouple_missing(R, gone)
    told, weights = np.linalg.solve(root(R), H).mT, np.linalg.solve(R, H).mT  # told is a root of HᵀR⁻¹H
    if shared:
        G, told = root(model.Q), np.broadcast_to(told, (len(masks), *told.shape[-2:]))
        plan = walk(gaps[..., ::-1], start, lambda M, gap: _one_back(M, model.F, G, told[gap]), same_root)
        return plan, weights[gaps] if masks.any() else weights
    M, parts = start, []
    for k in range(T - 1, -1, -1):
        F, G = step_matrix(model.F, k), root(step_matrix(model.Q, k))
        M, part = _one_back(M, F, G, step_matrix(told, k))
        parts.append(part)
    return Walk(tuple(np.stack(np.broadcast_arrays(*part), axis=-3) for part in zip(*parts, strict=True))), weights


def _one_back(M, F, G, told):
    """A root of the information before a step x' = F x + G w, from that after it; and what is kept for the step.

    It is a correction again, with Gᵀ in the place of H and I in the place of R.
    """
    batch, one = np.broadcast_shapes(M.shape[:-2], F.shape[:-2], G.shape[:-2], told.shape[:-2]), np.eye(F.shape[-1])
    with_z = triangular(np.concatenate([with_batch(M, batch), with_batch(told, batch)], axis=-1))
    _comparable(G.mT @ with_z)
    S_root, cross, left = corrected_root(with_z, G.mT, one)
    gain = divide_root(cross, S_root)
    return triangular(F.mT @ left), (M, F.mT @ (one - gain @ G.mT))
