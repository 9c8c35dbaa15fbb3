"""What P says of a filter that does not pass the open exercise of lesson 13."""

import numpy as np

from kflearn.exercises._judge import pair
from kflearn.exercises._radar import F, Q, R


def learnt(mean, cov, start):
    """What each step has added to P⁻¹ (T, 4, 4), which is Hᵀ R⁻¹ H, and H (T, 2, 2) for east and north at the predicted place."""
    x = np.vstack([start[0], mean[:-1]]) @ F.T
    more = np.linalg.inv(cov) - np.linalg.inv(F @ np.concatenate([start[1][None], cov[:-1]]) @ F.T + Q)
    r = np.hypot(x[:, 0], x[:, 2])
    return more, np.moveaxis(np.array([[x[:, 0] / r, x[:, 2] / r], [-x[:, 2] / r**2, x[:, 0] / r**2]]), -1, 0)


def used_R(more, H):
    """The R (T, 2, 2) of such corrections; None where something else has been done."""
    if abs(more[:, 1::2]).max() > 1e-6 * abs(more).max():  # nothing is read of the speeds
        return None
    back = np.linalg.inv(H)
    return np.linalg.inv(back.mT @ more[:, ::2, ::2] @ back)


def is_R(found):
    """Whether they are all the R of the text."""
    return found is not None and np.allclose(found / np.sqrt(np.outer(np.diag(R), np.diag(R))), np.eye(2), atol=1e-3)


def of_P(answer, answers, recordings):
    """What P says of F, Q, R, H and the start."""
    both = [learnt(*pair(a), inputs[1:]) for a, (inputs, _) in zip(answers, recordings, strict=True)]
    sizes = np.concatenate([abs(more).max(axis=(1, 2)) for more, _ in both])
    idle = np.mean(sizes < 1e-9 * np.median(sizes) + 1e-12)
    if idle > 0.02:
        return f"In {100 * idle:.0f} % of the steps your P is as predicted, so the reading is not used. Here all readings are of the target: use each of them."
    later = [used_R(more[1:], H[1:]) for more, H in both]
    if any(each is None for each in later):
        return "Your P is not that of F P Fᵀ + Q and I − K H, for the order east, its speed, north, its speed. Is it the order, Q, the correction of P, or the moment (after the correction)?"
    if not all(map(is_R, later)):
        distance, bearing = np.diag(np.median(np.concatenate(later), axis=0))
        return (
            f"A reading makes your P smaller as if, with H at the predicted place, R were diag({_shown(distance)}, {_shown(bearing)}) (median of all steps). "
            "It should be diag(25, 0.0004), in m² and rad²: is it R in S, H, or the K in P?"
        )
    if not all(is_R(used_R(more[:1], H[:1])) for more, H in both):
        return (
            "From the second step on your P is right, the first one is not: it follows from `cov`, predicted for a second, and from the first reading, with "
            "H where `mean` is predicted to be. Is east first in your states?"
        )
    return (
        "Your P is right in every step, so F, Q, R, H and the start are right in it. It is the mean that goes wrong: "
        "what is expected, the innovation (only the bearing is an angle), the gain with which it moves, or the order (east first)."
    )


def _shown(variance):
    return f"{variance:.3g}" if variance > 1e-9 else "0"
