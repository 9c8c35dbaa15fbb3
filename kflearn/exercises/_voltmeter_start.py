"""Wrong answers to lesson 5's start from one measurement, each with the sentence that it gets."""

import numpy as np

WRONG = {
    "auto_start": {
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
    },
}
