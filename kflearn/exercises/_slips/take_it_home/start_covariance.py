"""Lesson 29, `start_covariance`: wrong answers, each with the sentence that it gets."""

WRONG = {
    "as it is": (
        [[4, 0], [0, 1]],
        "That is P one step before the first reading, as it is. The library would take it for the time of the reading: predict once.",
    ),
    "Q alone added": (
        [[4, 0], [0, 2]],
        "That is P + Q. The step also moves the state, and with it the covariance: F P Fᵀ first, with `@` (`*` multiplies entry by entry).",
    ),
    "without Q": ([[8, 2], [2, 1]], "That is F P Fᵀ. In that step the state is disturbed as well: Q is missing."),
    "F on one side": (
        [[4, 2], [0, 2]],
        "That is F P + Q, and it is not symmetric. F stands on both sides: F P Fᵀ.",
    ),
    "transposes exchanged": (
        [[4, 8], [8, 18]],
        "That is Fᵀ P F + Q: the transpose belongs to the right. A speed must widen the position, not the other way round.",
    ),
    "diagonal alone": (
        [[8, 0], [0, 2]],
        "The variances are right. The covariance beside them is missing: after the step position and velocity err together.",
    ),
    "no transpose": (
        [[4, 10], [0, 2]],
        "That is F P F + Q, which is not symmetric. The second F is transposed: F P Fᵀ.",
    ),
    "two steps": (
        [[24, 6], [6, 3]],
        "You predicted twice. There is one step between your start and the first reading.",
    ),
    "backwards": (
        [[8, -2], [-2, 2]],
        "That is F⁻¹ P F⁻ᵀ + Q, with a step back: its covariance is negative. The first reading comes later than your start.",
    ),
    "Q first": (
        [[12, 4], [4, 2]],
        "You added Q before the step, F (P + Q) Fᵀ. In this course Q is what one step adds: F P Fᵀ + Q.",
    ),
    "Q taken off": ([[8, 2], [2, 0]], "You took Q off. A disturbance makes a belief less certain: + Q."),
    "2 not squared": (
        [[6, 2], [2, 2]],
        "Only the upper left is wrong: F stands on both sides, so the variance 1 of the speed comes in with 2² = 4, not with 2.",
    ),
}
