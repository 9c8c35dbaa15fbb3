"""Wrong answers to bearing_of_a_sound.is_a_covariance, each with the sentence that it gets."""

import numpy as np

WRONG = {
    "is_a_covariance": {
        "symmetric only": (
            lambda P: np.allclose(P, P.T),
            "You test the symmetry only. A symmetric matrix may still have a negative variance, or a correlation beyond 1.",
        ),
        "eigenvalues only": (
            lambda P: np.linalg.eigvalsh(P).min() >= -1e-9,
            "You test the eigenvalues only. `eigvalsh` reads one half of the matrix and takes the other half for granted, so it does not see that P is not symmetric.",
        ),
        "variances only": (
            lambda P: np.diag(P).min() >= 0,
            "You look at the diagonal only. The corners may differ, or be larger than two such variances allow.",
        ),
        "symmetric and variances": (
            lambda P: np.allclose(P, P.T) and np.diag(P).min() >= 0,
            "Symmetric, with variances that are not negative: this still allows a correlation beyond 1, and then some combination of the states has a negative variance.",
        ),
        "determinant": (
            lambda P: np.allclose(P, P.T) and np.linalg.det(P) >= 0,
            "The determinant is the product of the eigenvalues, and two negative ones have a positive product. Look at each of them.",
        ),
        "no negative entry": (
            lambda P: np.allclose(P, P.T) and P.min() >= 0,
            "A covariance may be negative, a variance may not. Your test refuses matrices with a negative corner.",
        ),
        "the other way round": (
            lambda P: not (np.allclose(P, P.T) and np.linalg.eigvalsh(P).min() >= -1e-9),
            "You return True for the matrices that cannot be a covariance; it is the other way round.",
        ),
        "largest eigenvalue": (
            lambda P: np.allclose(P, P.T) and np.linalg.eigvalsh(P).max() >= -1e-9,
            "You look at the largest eigenvalue. The smallest one says whether a combination has a negative variance.",
        ),
    },
}
