"""Wrong answers to the exercise `step_back` of lesson 23, each with the sentence that it gets."""

import numpy as np


def rts(x, P, F, Q, x_next, P_next, gain=None, sign=-1):
    """The step back, with a gain that may be wrong."""
    P_pred = F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(P_pred) if gain is None else gain(P, F, P_pred)
    return x + G @ (x_next - F @ x), P + G @ (P_next + sign * P_pred) @ G.T


def step(gain=None, compared=None, change=None):
    """The step back with one part of it exchanged."""

    def wrong(x, P, F, Q, x_next, P_next):
        P_pred = F @ P @ F.T + Q
        G = gain(P, F, P_pred) if gain else P @ F.T @ np.linalg.inv(P_pred)
        news = compared(x, F, x_next) if compared else x_next - F @ x
        less = change(P, P_next, P_pred) if change else P_next - P_pred
        return x + G @ news, P + G @ less @ G.T

    return wrong


def without_Q(x, P, F, Q, x_next, P_next):
    G = P @ F.T @ np.linalg.inv(F @ P @ F.T)
    return x + G @ (x_next - F @ x), P + G @ (P_next - F @ P @ F.T) @ G.T


def twice_on_predicted(x, P, F, Q, x_next, P_next):
    P_pred = F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(P_pred)
    return x + G @ (x_next - F @ x), P + G @ (P_next - G @ P_pred) @ G.T


def transposed_sides(x, P, F, Q, x_next, P_next):
    P_pred = F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(P_pred)
    return x + G @ (x_next - F @ x), P + G.T @ (P_next - P_pred) @ G


def one_sided(x, P, F, Q, x_next, P_next):
    P_pred = F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(P_pred)
    return x + G @ (x_next - F @ x), P + G @ (P_next - P_pred)


def filtered_not_predicted(x, P, F, Q, x_next, P_next):
    G = P @ F.T @ np.linalg.inv(F @ P @ F.T + Q)
    return x + G @ (x_next - x), P + G @ (P_next - P) @ G.T


STEP_BACK = {
    "Q forgotten": (
        without_Q,
        "That is right for Q = 0: x_next and P_next carried back by F⁻¹. Then all that was wrong at k+1 was wrong at k already, and the filter's own knowledge of step k is thrown away. P⁻ = F P Fᵀ + Q.",
    ),
    "F for its transpose": (
        lambda *given: rts(*given, gain=lambda P, F, P_pred: P @ F @ np.linalg.inv(P_pred)),
        "Your gain begins with P F. The covariance of now and next is P Fᵀ.",
    ),
    "gain transposed": (
        lambda *given: rts(*given, gain=lambda P, F, P_pred: np.linalg.solve(P_pred, F @ P)),
        "Your gain is transposed: `solve(P_pred, F @ P)` is Gᵀ. Put `.T` behind it.",
    ),
    "without F": (
        lambda *given: rts(*given, gain=lambda P, F, P_pred: P @ np.linalg.inv(P_pred)),
        "Your gain has no F. It is the covariance of now and next, P Fᵀ, that stands before (P⁻)⁻¹.",
    ),
    "sign": (
        lambda *given: rts(*given, sign=1),
        "The mean is right. In the covariance it is P_next minus P⁻: more knowledge makes it smaller.",
    ),
    "one side only": (
        one_sided,
        "The mean is right. In the covariance G stands on both sides: G (P_next − P⁻) Gᵀ. Yours is not symmetric.",
    ),
    "filtered, not predicted": (
        filtered_not_predicted,
        "You compared x_next with x. They belong to different moments: compare it with the prediction F x, P⁻.",
    ),
    "x in place of F x": (
        step(compared=lambda x, F, x_next: x_next - x),
        "The covariance is right. The mean compares x_next with x; they belong to different moments: compare it "
        "with the prediction F x.",
    ),
    "difference turned": (
        step(change=lambda P, P_next, P_pred: P_pred - P_next),
        "The mean is right. In the covariance the difference is turned round: P_next minus P⁻, which makes it smaller.",
    ),
    "P in place of P⁻": (
        step(change=lambda P, P_next, P_pred: P_next - P),
        "The mean is right. In the covariance P_next is compared with P; compare it with the prediction's P⁻.",
    ),
    "mean turned": (
        step(compared=lambda x, F, x_next: F @ x - x_next),
        "The covariance is right. In the mean the difference is turned round: x_next minus F x.",
    ),
    "F for Fᵀ, on the left": (
        step(gain=lambda P, F, P_pred: F @ P @ np.linalg.inv(P_pred)),
        "Your gain begins with F P. The covariance of now and next is P Fᵀ.",
    ),
    "not inverted": (
        step(gain=lambda P, F, P_pred: P @ F.T @ P_pred),
        "Your gain is multiplied by P⁻. It is divided by it: P Fᵀ (P⁻)⁻¹.",
    ),
    "divided entry by entry": (
        step(gain=lambda P, F, P_pred: P @ F.T / P_pred),
        "You divided by P⁻ entry by entry. For matrices it is the inverse: `P @ F.T @ np.linalg.inv(P_pred)`.",
    ),
    "Q forgotten in the gain": (
        step(gain=lambda P, F, P_pred: np.linalg.inv(F)),
        "Your gain is F⁻¹, as it is without Q: then all that was wrong at k+1 would have been wrong at k already. The gain "
        "is P Fᵀ (P⁻)⁻¹ with P⁻ = F P Fᵀ + Q.",
    ),
    "G twice on P⁻": (
        twice_on_predicted,
        "The mean is right. In the covariance P⁻ is multiplied by G once too often: G (P_next − P⁻) Gᵀ.",
    ),
    "run backwards": (
        lambda x, P, F, Q, x_next, P_next: (
            np.linalg.inv(F) @ x_next,
            np.linalg.inv(F) @ (P_next + Q) @ np.linalg.inv(F).T,
        ),
        "You ran the model backwards from step k+1. That forgets what the filter knew about step k, x and P.",
    ),
    "Gᵀ on the left": (
        transposed_sides,
        "The mean is right. In the covariance G stands on the left and Gᵀ on the right.",
    ),
    "F before the gain": (
        step(gain=lambda P, F, P_pred: F @ P @ F.T @ np.linalg.inv(P_pred)),
        "Your gain begins with F P Fᵀ. The covariance of now and next is P Fᵀ.",
    ),
    "inverse on the left": (
        step(gain=lambda P, F, P_pred: np.linalg.inv(P_pred) @ P @ F.T),
        "In your gain the inverse stands on the left. It is P Fᵀ (P⁻)⁻¹.",
    ),
    "only the mean from there": (
        lambda x, P, F, Q, x_next, P_next: (
            F @ x - x + rts(x, P, F, Q, x_next, P_next)[0],
            rts(x, P, F, Q, x_next, P_next)[1],
        ),
        "The covariance is right. The mean begins with F x, the prediction for k+1. Step k is asked for: begin with x.",
    ),
    "P as it was": (
        step(change=lambda P, P_next, P_pred: 0 * P),
        "The mean is right. The covariance is still the filter's: it changes by G (P_next − P⁻) Gᵀ.",
    ),
    "nothing done": (
        lambda x, P, F, Q, x_next, P_next: (x_next, P_next),
        "That is the belief about step k+1. Step k is asked for.",
    ),
    "prediction not subtracted": (
        step(change=lambda P, P_next, P_pred: P_next),
        "The mean is right. In the covariance P⁻ is missing: G (P_next − P⁻) Gᵀ.",
    ),
}
