"""Lesson 23, `step_back`: wrong answers, each with the sentence that it gets."""

from types import SimpleNamespace

import numpy as np


def without_Q(x, P, F, Q, x_next, P_next):
    G = P @ F.T @ np.linalg.inv(F @ P @ F.T)
    return x + G @ (x_next - F @ x), P + G @ (P_next - F @ P @ F.T) @ G.T


def rts(x, P, F, Q, x_next, P_next, gain=None, sign=-1):
    """The step back, with a gain that may be wrong."""
    P_pred = F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(P_pred) if gain is None else gain(P, F, P_pred)
    return x + G @ (x_next - F @ x), P + G @ (P_next + sign * P_pred) @ G.T


def one_sided(x, P, F, Q, x_next, P_next):
    P_pred = F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(P_pred)
    return x + G @ (x_next - F @ x), P + G @ (P_next - P_pred)


def filtered_not_predicted(x, P, F, Q, x_next, P_next):
    G = P @ F.T @ np.linalg.inv(F @ P @ F.T + Q)
    return x + G @ (x_next - x), P + G @ (P_next - P) @ G.T


def step(gain=None, compared=None, change=None):
    """The step back with one part of it exchanged."""

    def wrong(x, P, F, Q, x_next, P_next):
        P_pred = F @ P @ F.T + Q
        G = gain(P, F, P_pred) if gain else P @ F.T @ np.linalg.inv(P_pred)
        news = compared(x, F, x_next) if compared else x_next - F @ x
        less = change(P, P_next, P_pred) if change else P_next - P_pred
        return x + G @ news, P + G @ less @ G.T

    return wrong


def twice_on_predicted(x, P, F, Q, x_next, P_next):
    P_pred = F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(P_pred)
    return x + G @ (x_next - F @ x), P + G @ (P_next - G @ P_pred) @ G.T


def transposed_sides(x, P, F, Q, x_next, P_next):
    P_pred = F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(P_pred)
    return x + G @ (x_next - F @ x), P + G.T @ (P_next - P_pred) @ G


def back(gain=None, mean=None, cov=None):
    """The step back with one part of it exchanged."""

    def wrong(x, P, F, Q, x_next, P_next):
        P_pred = F @ P @ F.T + Q
        G = gain(P, F, P_pred, P_next, Q) if gain else P @ F.T @ np.linalg.inv(P_pred)
        x_new = mean(x, F, x_next, G) if mean else x + G @ (x_next - F @ x)
        return x_new, cov(P, P_next, P_pred, G) if cov else P + G @ (P_next - P_pred) @ G.T

    return wrong


model = SimpleNamespace(F=np.array([[1, 0.1], [0, 1]]), Q=4 * np.outer([0.005, 0.1], [0.005, 0.1]))


def with_the_lessons_F(x, P, F, Q, x_next, P_next):
    P_pred = model.F @ P @ model.F.T + model.Q
    G = P @ model.F.T @ np.linalg.inv(P_pred)
    return x + G @ (x_next - model.F @ x), P + G @ (P_next - P_pred) @ G.T


def from_the_prediction(x, P, F, Q, x_next, P_next):
    ahead = F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(ahead)
    return F @ x + G @ (x_next - F @ x), ahead + G @ (P_next - ahead) @ G.T


def overwritten(x, P, F, Q, x_next, P_next):
    x, P = F @ x, F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(P)
    return x + G @ (x_next - x), P + G @ (P_next - P) @ G.T


FUSED_BACK = (
    "That is x_next, P_next moved back by F⁻¹ and fused with x, P. But they hold x, P already, and so it counts twice: "
    "G = P Fᵀ (P⁻)⁻¹."
)


def fused_back(noise):
    """The smoothed belief carried back through F, and fused with the filter's."""

    def step(x, P, F, Q, x_next, P_next):
        back = np.linalg.inv(F)
        there = np.linalg.inv(back @ (P_next + noise * Q) @ back.T)
        cov = np.linalg.inv(np.linalg.inv(P) + there)
        return cov @ (np.linalg.solve(P, x) + there @ back @ x_next), cov

    return step


def back_from(x, P, P_minus, F, x_next, P_next, star=False):
    """The step back with this P⁻; star: only its covariance is made entry by entry."""
    G = P @ F.T @ np.linalg.inv(P_minus)
    less = P_next - P_minus
    return x + G @ (x_next - F @ x), P + (G**2 * less if star else G @ less @ G.T)


WRONG = {
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
    "P_next in the gain": (
        back(gain=lambda P, F, P_pred, P_next, Q: P @ F.T @ np.linalg.inv(P_next)),
        "Your gain divides by P_next. It divides by the prediction's covariance, P⁻ = F P Fᵀ + Q.",
    ),
    "the sum in the gain": (
        back(gain=lambda P, F, P_pred, P_next, Q: P @ F.T @ np.linalg.inv(P_pred + P_next)),
        "Your gain divides by P⁻ + P_next, as for two separate opinions. It is P Fᵀ (P⁻)⁻¹.",
    ),
    "a filter's gain": (
        back(gain=lambda P, F, P_pred, P_next, Q: P_pred @ np.linalg.inv(P_pred + P_next)),
        "Your gain is a filter's, P⁻ (P⁻ + P_next)⁻¹. The two are no separate opinions: G = P Fᵀ (P⁻)⁻¹.",
    ),
    "Q alone in the gain": (
        back(gain=lambda P, F, P_pred, P_next, Q: P @ F.T @ np.linalg.inv(P + Q)),
        "In your gain P⁻ lacks F: it is F P Fᵀ + Q.",
    ),
    "G without transpose": (
        back(cov=lambda P, P_next, P_pred, G: P + G @ (P_next - P_pred) @ G),
        "The mean is right. In the covariance the second G is transposed: G (P_next − P⁻) Gᵀ.",
    ),
    "from the next": (
        back(cov=lambda P, P_next, P_pred, G: P_next + G @ (P_next - P_pred) @ G.T),
        "The mean is right. The covariance begins with P, the filter's at step k.",
    ),
    "both from the next": (
        back(
            mean=lambda x, F, x_next, G: x_next + G @ (x_next - F @ x),
            cov=lambda P, P_next, P_pred, G: P_next + G @ (P_next - P_pred) @ G.T,
        ),
        "You begin with step k+1. Step k is asked for: begin with x and P, the filter's.",
    ),
    "x_next alone": (
        back(mean=lambda x, F, x_next, G: x + G @ x_next),
        "The covariance is right. The mean moves by G times what the prediction got wrong, x_next − F x.",
    ),
    "entry by entry": (
        back(mean=lambda x, F, x_next, G: x + np.diag(G) * (x_next - F @ x)),
        "The covariance is right. In the mean G is a matrix: `G @ (x_next - F @ x)`.",
    ),
    "the prediction's covariance": (
        back(cov=lambda P, P_next, P_pred, G: P_pred + G @ (P_next - P_pred) @ G.T),
        "The mean is right. The covariance begins with P, not with the prediction's P⁻.",
    ),
    "the lesson's F": (
        with_the_lessons_F,
        "Your function uses the model of the lesson. F and Q are arguments, and other ones in each trial.",
        r"model\.",
    ),
    "from the prediction": (
        from_the_prediction,
        "The gain is right. Start from the filter's belief at step k, x and P, not from its prediction.",
    ),
    "overwritten": (
        overwritten,
        "You put the prediction in the place of x and P. G and the result need the filter's own: give the prediction other names.",
    ),
    "the filter's": (
        lambda x, P, F, Q, x_next, P_next: (x, P),
        "That is the filter's own belief: x_next and P_next are not used yet.",
    ),
    "fused": (fused_back(1), FUSED_BACK),
    "fused, without Q": (fused_back(0), FUSED_BACK),
    "Q before the step": (
        lambda x, P, F, Q, x_next, P_next: back_from(x, P, F @ (P + Q) @ F.T, F, x_next, P_next),
        "It answers as if P⁻ were F (P + Q) Fᵀ. Q is added after the step, when F P Fᵀ is done.",
    ),
    "G squared entry by entry": (
        lambda x, P, F, Q, x_next, P_next: back_from(x, P, F @ P @ F.T + Q, F, x_next, P_next, star=True),
        "The mean is right. In the covariance each entry of P_next − P⁻ is multiplied by the square of an entry of "
        "G. For matrices G stands on the left and Gᵀ on the right, with `@`.",
    ),
    "exact next": (
        lambda x, P, F, Q, x_next, P_next: (
            rts(x, P, F, Q, x_next, P_next)[0],
            rts(x, P, F, Q, x_next, 0 * P_next)[1],
        ),
        "The mean is right. Your covariance is that for a step k+1 which is known exactly: P_next is missing, P + G (P_next − P⁻) Gᵀ.",
    ),
}
