"""Wrong starts from two fixes (lesson 11), each with the sentence that it gets."""

import numpy as np


def made(position, speed, P):
    return np.array([position, speed]), np.array(P, dtype=float)


WRONG = {
    "two_point_start": {
        "P₀ = I": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, np.eye(2)),
            "The mean is right, and P₀ = I is the published habit again. The position is as good as a fix, R, and the speed worse.",
        ),
        "the corner forgotten": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, [[R, 0], [0, 2 * R / dt**2]]),
            "Both variances are right, the corner is not: the error of z₁ is in the position and in the speed, so the two err together.",
        ),
        "sign of the corner": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, [[R, -R / dt], [-R / dt, 2 * R / dt**2]]),
            "The corner has the wrong sign: if z₁ is too far ahead, so is the speed too high.",
        ),
        "one reading only": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, [[R, R / dt], [R / dt, R / dt**2]]),
            "The speed has the errors of *two* fixes: 2R/dt². Your P even says that one direction is known exactly.",
        ),
        "dt not squared": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, [[R, R / dt], [R / dt, 2 * R / dt]]),
            "The speed's variance is in (m/s)²: 2R must be divided by dt².",
        ),
        "dt forgotten in P": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, [[R, R], [R, 2 * R]]),
            "The mean is right; in P you forgot dt, as if the fixes were one second apart.",
        ),
        "dt forgotten": (
            lambda z0, z1, dt, R: made(z1, z1 - z0, [[R, R], [R, 2 * R]]),
            "dt is missing: the speed is the difference per second, (z₁ − z₀)/dt; P needs it too.",
        ),
        "deviations": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, np.sqrt(R * np.array([[1, 1 / dt], [1 / dt, 2 / dt**2]]))),
            "P holds variances and covariances; you took roots.",
        ),
        "the first fix": (
            lambda z0, z1, dt, R: made(z0, (z1 - z0) / dt, [[R, R / dt], [R / dt, 2 * R / dt**2]]),
            "The belief is one *after* the second fix: the position is z₁.",
        ),
        "the middle": (
            lambda z0, z1, dt, R: made(
                (z0 + z1) / 2, (z1 - z0) / dt, [[R / 2, R / dt / 2], [R / dt / 2, 2 * R / dt**2]]
            ),
            "The middle of both fixes is where the ship was half a step ago; now it is at z₁, give or take √R.",
        ),
        "backwards": (
            lambda z0, z1, dt, R: made(z1, (z0 - z1) / dt, [[R, R / dt], [R / dt, 2 * R / dt**2]]),
            "The sign of the speed: the later fix minus the earlier one.",
        ),
        "as published": (
            lambda z0, z1, dt, R: made(z1, 0, np.eye(2)),
            "Neither fix has said anything about the speed yet: it is (z₁ − z₀)/dt; and P₀ = I is the published habit.",
        ),
        "speed R, no corner": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, [[R, 0], [0, R]]),
            "Two things are missing in P: the speed is a difference of two fixes over dt, so its variance is not R; and z₁ is in both, so there is a corner.",
        ),
        "speed R/dt², no corner": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, [[R, 0], [0, R / dt**2]]),
            "The speed has the errors of *two* fixes, 2R/dt²; and z₁ sits in the position and in the speed, so the corner is not zero.",
        ),
        "speed 2R/dt, no corner": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, [[R, 0], [0, 2 * R / dt]]),
            "The speed's variance is in (m/s)², so dt must be squared; and the corner is missing, for z₁ sits in both.",
        ),
        "speed 2R, no corner": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, [[R, 0], [0, 2 * R]]),
            "The division by dt² is missing, and so is the corner: z₁ sits in the position and in the speed.",
        ),
        "corner doubled": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, [[R, 2 * R / dt], [2 * R / dt, 2 * R / dt**2]]),
            "Both variances are right. The corner is too large: only one fix, z₁, is in the position and in the speed.",
        ),
        "corner over dt²": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, [[R, R / dt**2], [R / dt**2, 2 * R / dt**2]]),
            "Both variances are right. The corner is in m · m/s, so it is divided by dt once.",
        ),
        "the middle, no corner": (
            lambda z0, z1, dt, R: made((z0 + z1) / 2, (z1 - z0) / dt, [[R / 2, 0], [0, 2 * R / dt**2]]),
            "All of this is right for the moment half a step ago. The belief is asked for after z₁: position z₁, and then there is a corner.",
        ),
        "first fix, no corner": (
            lambda z0, z1, dt, R: made(z0, (z1 - z0) / dt, [[R, 0], [0, 2 * R / dt**2]]),
            "The position is that of the second fix, z₁, and z₁ is in the speed as well: so the corner is not zero.",
        ),
        "dt² forgotten": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, [[R, R / dt], [R / dt, 2 * R]]),
            "The corner is right. The speed is divided by dt, so its variance is divided by dt².",
        ),
        "corner without dt": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, [[R, R], [R, 2 * R / dt**2]]),
            "Both variances are right. The corner is the mean of e₁ · (e₁ − e₀)/dt: it is divided by dt.",
        ),
        "both fixes in the position": (
            lambda z0, z1, dt, R: made(z1, (z1 - z0) / dt, [[2 * R, R / dt], [R / dt, 2 * R / dt**2]]),
            "Only the position's variance is wrong: the position is one fix, z₁, so it is R.",
        ),
    },
}
