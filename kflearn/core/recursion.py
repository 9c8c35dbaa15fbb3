"""x_k = A_k x_{k-1} + d_k for many runs at once, and in blocks once A no longer changes.

A stack of matrices (..., S, n, n) may be shorter than the series of T steps: its last matrix then serves the rest.
"""

from itertools import pairwise

import numpy as np

from .matrices import matvec
from .walk import commonest, pick

LONG = 500  # steps from which on blocks are quicker than a plain loop


def linear_recursion(A, drive, start, index=None):
    """All x_k of x_k = A_k x_{k-1} + d_k, an array (..., T, n).

    A (..., S, n, n), `drive`, which holds the d_k, (..., T, n), and start (..., n) have leading axes that broadcast.
    index: which of the A belongs to each step, (T,) or (..., T), as in Walk. `drive` may be overwritten.
    """
    T, n = drive.shape[-2:]
    if A.ndim > 3 or (index is not None and index.ndim > 1):
        return _one_matrix_a_run(A, drive, start, index)
    batch = np.broadcast_shapes(drive.shape[:-2], start.shape[:-1])
    # Time first and runs last: one small matrix times one wide matrix a step.
    if drive.shape[:-2] != batch:
        drive = np.broadcast_to(drive, (*batch, T, n)).copy()
    x = np.moveaxis(drive, (-2, -1), (0, 1)).reshape(T, n, -1)
    state = np.moveaxis(np.broadcast_to(start, (*batch, n)), -1, 0).reshape(n, -1)
    index = np.minimum(np.arange(T), len(A) - 1) if index is None else index
    if x.shape[-1] > 100 or T < LONG:
        _steps(A, index, x, state)
    else:
        for begin, end, constant in _stretches(index):
            part = x[begin:end]
            if constant:
                part[:] = _blocks(A[index[begin]], part, state)
            elif end - begin < LONG:
                _steps(A, index[begin:end], part, state)
            else:
                part[:] = _varying_blocks(A[index[begin:end]], part, state)
            state = part[-1]
    return np.moveaxis(x.reshape(T, n, *batch), (0, 1), (-2, -1))


def _stretches(index):
    """(begin, end, constant?) of each stretch of at least LONG steps with one matrix, and of what lies between."""
    cuts = np.concatenate([[0], np.flatnonzero(np.diff(index)) + 1, [len(index)]])
    begin = 0
    for first, last in pairwise(cuts.tolist()):
        if last - first >= LONG:
            if first > begin:
                yield begin, first, False
            yield first, last, True
            begin = last
    if begin < len(index):
        yield begin, len(index), False


def _steps(A, index, x, state):
    """x (T, n, runs) holds d and becomes the solution."""
    for row, now in zip(index, x, strict=True):
        now += A[row].dot(state)  # the same as @, and quicker where both are small
        state = now


def _one_matrix_a_run(A, drive, start, index):
    """The plain loop, for matrices that differ between runs."""
    T, n = drive.shape[-2:]
    lead = A.shape[:-3] if index is None else index.shape[:-1]
    batch = np.broadcast_shapes(lead, drive.shape[:-2], start.shape[:-1])
    x = np.empty((T, *batch, n))
    state = start
    for k in range(T):
        matrix = A[..., min(k, A.shape[-3] - 1), :, :] if index is None else A[index[..., k]]
        state = np.matvec(matrix, state) + drive[..., k, :]
        x[k] = state
    return np.moveaxis(x, 0, -2)


def _varying_blocks(A, drive, start):
    """The recursion for matrices A (T, n, n) that differ from step to step, in about 2√T steps in place of T.

    As _blocks, but each block has its own products Φ of matrices. They ride along as n more columns.
    """
    T, n, runs = drive.shape
    length = int(np.sqrt(T))
    count = T // length
    used = count * length
    M = A[:used].reshape(count, length, n, n).swapaxes(0, 1)
    x = np.zeros((length, count, n, n + runs))
    x[..., n:] = drive[:used].reshape(count, length, n, runs).swapaxes(0, 1)
    x[0, :, :, :n] = M[0]
    for j in range(1, length):
        x[j] += M[j] @ x[j - 1]
    starts, state = np.empty((count, n, runs)), start
    for b in range(count):
        starts[b] = state
        state = x[-1, b, :, n:] + x[-1, b, :, :n] @ state
    solved = x[..., n:] + x[..., :n] @ starts
    rest = drive[used:].copy()
    _steps(A[used:], range(T - used), rest, state)
    return np.concatenate([solved.swapaxes(0, 1).reshape(used, n, runs), rest])


def _blocks(A, drive, start):
    """The recursion for a constant A, in about 2√T steps in place of T.

    Cut the series (T, n, runs) into blocks that all start at zero and are computed side by side. Then add to each block
    what its true start contributes: A^j x_start at its step j.
    """
    T, n, runs = drive.shape
    length = int(np.sqrt(T))
    count = T // length
    head, rest = drive[: count * length], drive[count * length :].copy()
    x = np.moveaxis(head.reshape(count, length, n, runs), 0, 2).reshape(length, n, -1).copy()
    same = np.zeros(T, int)
    _steps(A[None], same[:length], x, np.zeros_like(x[0]))
    powers = np.zeros((length, n, n))
    _steps(A[None], same[:length], powers, np.eye(n))
    ends = x[-1].reshape(n, count, runs)
    starts = np.empty((n, count, runs))
    state = start
    for b in range(count):
        starts[:, b] = state
        state = ends[:, b] + powers[-1] @ state
    x += (powers.reshape(-1, n) @ starts.reshape(n, -1)).reshape(x.shape)
    _steps(A[None], same[: len(rest)], rest, state)
    blocks = np.moveaxis(x.reshape(length, n, count, runs), 2, 0).reshape(-1, n, runs)
    return np.concatenate([blocks, rest])


def matvec_each_step(M, v, index=None):
    """M_k v_k for all steps: M (..., S, n, m) or (n, m), v (..., T, m). A shorter M: its last matrix is reused.

    index: which of the M belongs to each step, (..., T), as in Walk.
    """
    if index is not None and M.ndim > 2:
        if index.ndim > 1:  # step by step: the matrices of all steps at once could fill the memory
            out = np.empty((v.shape[-2], *np.broadcast_shapes(index.shape[:-1], v.shape[:-2]), M.shape[-2]))
            for k in range(len(out)):
                np.matvec(M[index[..., k]], v[..., k, :], out=out[k])
            return np.moveaxis(out, 0, -2)
        if v.ndim == 2:
            common, others = commonest(index)
            out = v @ M[common].T
            out[others] = np.matvec(M[index[others]], v[others])
            return out
        M = M[index]
    # One matrix for all steps, and vectors that lie in memory one after the other: a single matrix product.
    if M.ndim == 2 and (v.ndim == 2 or v.flags.c_contiguous):
        return matvec(M, v)
    # Matrices that differ between runs: nothing is shared.
    if M.ndim > 3:
        return np.matvec(pick(M, None, v.shape[-2]), v)
    # One matrix a step serves all runs. Move the runs to the last axis (the means that linear_recursion makes lie that
    # way already, so nothing is copied): then one matrix product a step serves them all.
    M = M if M.ndim > 2 else M[None]
    wide = np.moveaxis(v, (-2, -1), (0, 1)).reshape(*v.shape[-2:], -1)
    out = np.empty((len(wide), M.shape[-2], wide.shape[-1]))
    np.matmul(M, wide[: len(M)], out=out[: len(M)])
    out[len(M) :] = M[-1] @ wide[len(M) :]
    return np.moveaxis(out.reshape(*out.shape[:2], *v.shape[:-2]), (0, 1), (-2, -1))
