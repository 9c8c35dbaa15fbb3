"""Lesson 5, `auto_start`: wrong answers, each with the sentence that it gets."""

import numpy as np


def right_x(undo, z, H, R):
    return undo @ z


def start_of(x_of, P_of):
    """A start from one measurement, with a state and a covariance made of H⁻¹ and of z, H, R."""

    def start(z, H, R):
        undo = np.linalg.inv(H)
        return x_of(undo, z, H, R), P_of(undo, z, H, R)

    return start


def right_P(undo, z, H, R):
    return undo @ R @ undo.T


WRONG = {
    "H⁻¹R only": (
        lambda z, H, R: (np.linalg.solve(H, z), np.linalg.solve(H, R)),
        "Your x is right. P lacks its right-hand factor: H⁻¹R is not symmetric, and no covariance; multiply by H⁻ᵀ.",
    ),
    "P = R": (
        lambda z, H, R: (np.linalg.solve(H, z), R),
        "Your x is right. R is the covariance of z; that of x = H⁻¹z is H⁻¹RH⁻ᵀ.",
    ),
    "H⁻¹RH⁻¹": (
        lambda z, H, R: (np.linalg.solve(H, z), np.linalg.solve(H, R) @ np.linalg.inv(H)),
        "Your x is right. In P the second inverse must be transposed: H⁻¹RH⁻ᵀ.",
    ),
    "HRHᵀ": (
        lambda z, H, R: (np.linalg.solve(H, z), H @ R @ H.T),
        "Your x is right. HRHᵀ goes from states to measurements; here you go back, with inverses.",
    ),
    "z itself": (
        lambda z, H, R: (z, R),
        "You returned z and R. They belong to the measurement, not to the state: undo H first. The two agree only for H = 1.",
    ),
    "Hz": (
        lambda z, H, R: (H @ z, H @ R @ H.T),
        "You applied H once more instead of undoing it: z = Hx, so x = H⁻¹z.",
    ),
    "Hz, P right": (
        lambda z, H, R: (H @ z, np.linalg.inv(H) @ R @ np.linalg.inv(H).T),
        "P is right. In x you applied H once more instead of undoing it: z = Hx, so x = H⁻¹z.",
    ),
    "z for x": (
        lambda z, H, R: (z, np.linalg.inv(H) @ R @ np.linalg.inv(H).T),
        "P is right. But z is the measurement: for the state, undo H here too.",
    ),
    "transposes exchanged": (
        lambda z, H, R: (np.linalg.inv(H) @ z, np.linalg.inv(H).T @ R @ np.linalg.inv(H)),
        "Your x is right. In P the transpose is on the wrong side: the error of x is H⁻¹v, so H⁻¹ stands on the left.",
    ),
    "H⁻¹RH": (
        lambda z, H, R: (np.linalg.inv(H) @ z, np.linalg.inv(H) @ R @ H),
        "Your x is right. In P both sides undo H: the right-hand factor is the transpose of H⁻¹.",
    ),
    "Hᵀ for H⁻¹": (lambda z, H, R: (H.T @ z, H.T @ R @ H), "You used Hᵀ where the inverse of H is needed."),
    "divided": (
        lambda z, H, R: (z / np.diag(H), R / np.outer(np.diag(H), np.diag(H))),
        "You divided by the diagonal of H. The corners count too: use the inverse of the matrix.",
    ),
    "entry by entry": (
        lambda z, H, R: ((z / H), R / H**2),
        "You divided by H entry by entry. A matrix is undone by its inverse: np.linalg.inv or np.linalg.solve.",
    ),
    "H R H": (
        lambda z, H, R: (np.linalg.inv(H) @ z, H @ R @ H),
        "Your x is right. H goes from states to measurements; here you go back, with H⁻¹ on the left and its transpose on the right.",
    ),
    "R inverted": (
        lambda z, H, R: (np.linalg.inv(H) @ z, np.linalg.inv(H) @ np.linalg.inv(R) @ np.linalg.inv(H).T),
        "Your x is right. In P it is R itself that stands in the middle, not its inverse.",
    ),
    "the inverse of P": (
        lambda z, H, R: (np.linalg.inv(H) @ z, H.T @ np.linalg.inv(R) @ H),
        "Your x is right. HᵀR⁻¹H is the inverse of P.",
    ),
    "R H⁻ᵀ": (
        lambda z, H, R: (np.linalg.inv(H) @ z, R @ np.linalg.inv(H).T),
        "Your x is right. P lacks its left-hand factor H⁻¹.",
    ),
    "identity": (
        lambda z, H, R: (np.linalg.inv(H) @ z, np.eye(len(z))),
        "Your x is right. P is not the identity: it follows from R, through H⁻¹.",
    ),
    "zeros": (
        lambda z, H, R: (0 * z, np.linalg.inv(H) @ R @ np.linalg.inv(H).T),
        "P is right. x follows from the measurement: undo H.",
    ),
    "diagonal": (
        lambda z, H, R: (np.linalg.inv(H) @ z, np.diag(np.diag(np.linalg.inv(H) @ R @ np.linalg.inv(H).T))),
        "Your x is right, and so is the diagonal of P. The corners belong to it: the errors of the entries go together.",
    ),
    "z H⁻¹": (
        lambda z, H, R: (z @ np.linalg.inv(H), np.linalg.inv(H) @ R @ np.linalg.inv(H).T),
        "P is right. In x the inverse stands on the left of z: H⁻¹z.",
    ),
    "R alone, x = Hz": (
        lambda z, H, R: (H @ z, R),
        "z = Hx, so x = H⁻¹z; and R is the covariance of z: that of H⁻¹z is H⁻¹RH⁻ᵀ.",
    ),
    "Hᵀ for H⁻ᵀ": (
        lambda z, H, R: (np.linalg.solve(H, z), np.linalg.solve(H, R) @ H.T),
        "Your x is right. In P only the left side is undone: on the right stands the transpose of the *inverse*, H⁻ᵀ.",
    ),
    "R R": (
        lambda z, H, R: (np.linalg.solve(H, z), np.linalg.inv(H) @ R @ R @ np.linalg.inv(H).T),
        "Your x is right. R stands once in P: it is a covariance already.",
    ),
    "x alone": (
        lambda z, H, R: np.linalg.solve(H, z),
        "Your x is right. Its covariance is wanted as well: return both, x first.",
    ),
    "vague": (
        lambda z, H, R: (np.linalg.solve(H, z), 1e6 * np.eye(len(z))),
        "Your x is right. Its P is not huge any more: the measurement has been used, and its error is known, R.",
    ),
    "(H R Hᵀ)⁻¹": (
        start_of(right_x, lambda undo, z, H, R: np.linalg.inv(H @ R @ H.T)),
        "Your x is right. Your P is the inverse of HRHᵀ, and so R is inverted too. Only H is undone: H⁻¹RH⁻ᵀ.",
    ),
    "R added": (
        start_of(right_x, lambda undo, z, H, R: undo @ R @ undo.T + R),
        "Your x is right. In P one R too many is added: H⁻¹RH⁻ᵀ is the whole of it, for the measurement's error is counted once.",
    ),
    "transposed throughout": (
        start_of(lambda undo, z, H, R: undo.T @ z, lambda undo, z, H, R: undo.T @ R @ undo),
        "Your result has the transpose of H⁻¹ where H⁻¹ stands, and the other way round: x = H⁻¹z and P = H⁻¹RH⁻ᵀ.",
    ),
    "corners of R lost": (
        start_of(right_x, lambda undo, z, H, R: undo @ np.diag(np.diag(R)) @ undo.T),
        "Your x is right. In P only the diagonal of R counts. Its corners belong to it: the whole matrix R stands in the middle.",
    ),
    "roots": (
        start_of(right_x, lambda undo, z, H, R: np.sqrt(undo @ R @ undo.T)),
        "Your x is right. Your P holds the roots of the entries of the covariance. P is the covariance itself: no root.",
    ),
    "S": (
        start_of(right_x, lambda undo, z, H, R: H @ R @ H.T + R),
        "Your x is right. HRHᵀ + R looks like the covariance S of an innovation. There is no prediction yet: P = H⁻¹RH⁻ᵀ.",
    ),
    "half of R": (
        start_of(right_x, lambda undo, z, H, R: R / 2),
        "Your x is right. R/2 is not its covariance: the error of H⁻¹z is H⁻¹v, with the covariance H⁻¹RH⁻ᵀ.",
    ),
    "R z": (
        start_of(lambda undo, z, H, R: R @ z, right_P),
        "P is right. In x you multiply by R. The measurement z = Hx is undone with H⁻¹; R is no part of it.",
    ),
    "(I + H Hᵀ…)": (
        start_of(lambda undo, z, H, R: R @ H.T @ np.linalg.inv(H @ R @ H.T + R) @ z, right_P),
        "P is right. Your x is a gain times z, as in a correction from x = 0 with P = R. There is no belief to correct yet: x = H⁻¹z.",
    ),
    "diagonal alone": (
        lambda z, H, R: (z / np.diag(H), R / np.diag(H) ** 2),
        "You divide by the diagonal of H. A reading may hold several states: use the whole H, with its inverse H⁻¹ for the mean, and on both "
        "sides of R.",
    ),
}
