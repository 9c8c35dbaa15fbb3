import numpy as np
import pytest

from kflearn.core.recursion import linear_recursion
from tests.helpers import close


def plain(A, drive, start):
    """x_k = A_k x_{k-1} + d_k, one run after the other; the last of fewer matrices holds on."""
    n, T = drive.shape[-1], drive.shape[-2]
    batch = np.broadcast_shapes(A.shape[:-3], drive.shape[:-2], start.shape[:-1])
    A = np.broadcast_to(A, (*batch, *A.shape[-3:]))
    drive, start = np.broadcast_to(drive, (*batch, T, n)), np.broadcast_to(start, (*batch, n))
    out = np.empty((*batch, T, n))
    for run in np.ndindex(batch):
        x = start[run]
        for k in range(T):
            x = out[(*run, k)] = A[run][min(k, A.shape[-3] - 1)] @ x + drive[(*run, k)]
    return out


def stable(rng, *shape):
    A = rng.normal(size=shape)
    return 0.98 * A / abs(np.linalg.eigvals(A)).max(axis=-1)[..., None, None]


@pytest.mark.parametrize("n", [1, 2, 4])
@pytest.mark.parametrize("batch", [(), (1,), (3,), (2, 3)])
@pytest.mark.parametrize("matrices", [1, 4, 30])
def test_short_series(n, batch, matrices):
    rng = np.random.default_rng(0)
    A, drive, start = stable(rng, matrices, n, n), rng.normal(size=(*batch, 30, n)), rng.normal(size=n)
    expected = plain(A, drive, start)
    close(linear_recursion(A, drive.copy(), start), expected, 1e-12)


@pytest.mark.parametrize("T", [504, 505, 534, 900, 1004, 1237])
@pytest.mark.parametrize("runs", [(), (1,), (100,), (101,)])
def test_blocks_change_nothing(T, runs):
    # From 500 steps with a constant matrix on, and up to 100 runs, the series is cut into blocks.
    rng = np.random.default_rng(1)
    A, drive, start = stable(rng, 5, 2, 2), rng.normal(size=(*runs, T, 2)), rng.normal(size=(*runs, 2))
    found = linear_recursion(A, drive.copy(), start)
    assert found.shape == (*runs, T, 2)
    some = slice(None) if not runs else [0, -1]
    close(found[some], plain(A, drive[some], start[some]), 1e-10)


def test_blocks_of_a_series_that_remembers_everything():
    rng = np.random.default_rng(2)
    A = np.array([[[1.0, 1.0], [0.0, 1.0]]])
    drive = rng.normal(size=(3000, 2))
    close(linear_recursion(A, drive.copy(), np.ones(2)), plain(A, drive, np.ones(2)), 1e-10)


@pytest.mark.parametrize(
    ("of_A", "of_drive", "of_start"),
    [
        ((4,), (), ()),
        ((4,), (4,), (4,)),
        ((3, 1), (4,), ()),
        ((3, 1), (4,), (3, 4)),
        ((), (4,), (3, 1)),
        ((), (), (4,)),
    ],
)
@pytest.mark.parametrize("matrices", [1, 6])
def test_axes_broadcast(of_A, of_drive, of_start, matrices):
    rng = np.random.default_rng(3)
    A, drive, start = (
        stable(rng, *of_A, matrices, 2, 2),
        rng.normal(size=(*of_drive, 6, 2)),
        rng.normal(size=(*of_start, 2)),
    )
    found, expected = linear_recursion(A, drive.copy(), start), plain(A, drive, start)
    assert found.shape == expected.shape
    close(found, expected, 1e-12)


def test_blocks_of_matrices_that_differ_and_forget_nothing():
    """Rotations, a new one at each step: what a block starts with still counts at its end."""
    angle = np.random.default_rng(7).normal(size=2000)
    A = np.stack([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]).transpose(2, 0, 1)
    drive, start = np.random.default_rng(8).normal(size=(3, 2000, 2)), np.array([5.0, -2.0])
    close(linear_recursion(A, drive.copy(), start), plain(A, drive, start), 1e-10)
    index = np.repeat(np.arange(20), 100)
    index[900:] = 7
    close(linear_recursion(A[:20], drive.copy(), start, index), plain(A[index], drive, start), 1e-10)
    own = np.stack([index, index[::-1], np.arange(2000) % 20])
    found = linear_recursion(A[:20], drive.copy(), start, own)
    for run in range(3):
        close(found[run], plain(A[own[run]], drive[run], start), 1e-10)
