"""x_k = A_k x_{k-1} + d_k for many runs at once, and in blocks once A no longer changes.

A stack of matrices (..., S, n, n) may be shorter than the series of T steps: its last matrix then serves the rest.
"""

import numpy as np

from .matrices import matvec


def linear_recursion(A, drive, start):
    """All x_k of x_k = A_k x_{k-1} + d_k, an array (..., T, n).

    A (..., S, n, n), `drive`, which holds the d_k, (..., T, n), and start (..., n) have leading axes that broadcast.
    `drive` may be overwritten.
    """
    if A.ndim > 3:
        return _one_matrix_a_run(A, drive, start)
    T, n = drive.shape[-2:]
    batch = np.broadcast_shapes(drive.shape[:-2], start.shape[:-1])
    # Time first and runs last: one small matrix times one wide matrix a step.
    if drive.shape[:-2] != batch:
        drive = np.broadcast_to(drive, (*batch, T, n)).copy()
    x = np.moveaxis(drive, (-2, -1), (0, 1)).reshape(T, n, -1)
    state = np.moveaxis(np.broadcast_to(start, (*batch, n)), -1, 0).reshape(n, -1)
    runs = x.shape[-1]
    single = T if T - len(A) < 500 or runs > 100 else len(A)
    _steps(A, x[:single], state)
    if single < T:
        x[single:] = _blocks(A[-1], x[single:], x[single - 1])
    return np.moveaxis(x.reshape(T, n, *batch), (0, 1), (-2, -1))


def _steps(A, x, state):
    """x (T, n, runs) holds d and becomes the solution."""
    for k in range(len(x)):
        x[k] += A[min(k, len(A) - 1)] @ state
        state = x[k]


def _one_matrix_a_run(A, drive, start):
    """The plain loop, for matrices that differ between runs."""
    T, n = drive.shape[-2:]
    batch = np.broadcast_shapes(A.shape[:-3], drive.shape[:-2], start.shape[:-1])
    x = np.empty((T, *batch, n))
    state = start
    for k in range(T):
        state = np.matvec(A[..., min(k, A.shape[-3] - 1), :, :], state) + drive[..., k, :]
        x[k] = state
    return np.moveaxis(x, 0, -2)


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
    _steps(A[None], x, np.zeros_like(x[0]))
    powers = np.zeros((length, n, n))
    _steps(A[None], powers, np.eye(n))
    ends = x[-1].reshape(n, count, runs)
    starts = np.empty((n, count, runs))
    state = start
    for b in range(count):
        starts[:, b] = state
        state = ends[:, b] + powers[-1] @ state
    x += (powers.reshape(-1, n) @ starts.reshape(n, -1)).reshape(x.shape)
    _steps(A[None], rest, state)
    blocks = np.moveaxis(x.reshape(length, n, count, runs), 2, 0).reshape(-1, n, runs)
    return np.concatenate([blocks, rest])


def extend_last(array, T):
    """An array (..., steps, ·, ·) made T long by repeating its last entry."""
    rest = T - array.shape[-3]
    if not rest:
        return array
    last = array[..., -1:, :, :]
    repeated = np.broadcast_to(last, (*last.shape[:-3], rest, *last.shape[-2:]))
    return np.concatenate([array, repeated], axis=-3)


def matvec_each_step(M, v):
    """M_k v_k for all steps: M (..., steps, n, m) or (n, m), v (..., T, m). A shorter M: its last matrix is reused."""
    # One matrix for all steps, and vectors that lie in memory one after the other: a single matrix product.
    if M.ndim == 2 and (v.ndim == 2 or v.flags.c_contiguous):
        return matvec(M, v)
    # Matrices that differ between runs: nothing is shared.
    if M.ndim > 3:
        return np.matvec(extend_last(M, v.shape[-2]), v)
    # One matrix a step serves all runs. Move the runs to the last axis (the means that linear_recursion makes lie that
    # way already, so nothing is copied): then one matrix product a step serves them all.
    M = M if M.ndim > 2 else M[None]
    wide = np.moveaxis(v, (-2, -1), (0, 1)).reshape(*v.shape[-2:], -1)
    out = np.empty((len(wide), M.shape[-2], wide.shape[-1]))
    np.matmul(M, wide[: len(M)], out=out[: len(M)])
    out[len(M) :] = M[-1] @ wide[len(M) :]
    return np.moveaxis(out.reshape(*out.shape[:2], *v.shape[:-2]), (0, 1), (-2, -1))
