"""Lesson 11, `two_point_start`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np


def made(position, speed, P):
    return np.array([position, speed]), np.array(P, dtype=float)


def belief(corner, speed_variance, position=lambda R, dt: R, mean=lambda z0, z1, dt: [z1, (z1 - z0) / dt]):
    """Mean and covariance with some of their entries chosen; each is a function of (R, dt)."""

    def start(z0, z1, dt, R):
        c = corner(R, dt)
        return np.array(mean(z0, z1, dt)), np.array([[position(R, dt), c], [c, speed_variance(R, dt)]], dtype=float)

    return start


def right_corner(R, dt):
    return R / dt


def right_speed(R, dt):
    return 2 * R / dt**2


def sigma_on_the_diagonal(z0, z1, dt, R):
    """A start from two fixes with the σ of the speed where its variance belongs."""
    return np.array([z1, (z1 - z0) / dt]), np.array([[R, R / dt], [R / dt, np.sqrt(2 * R) / dt]])


def deviations(z0, z1, dt, R):
    s = np.sqrt(R)
    return np.array([z1, (z1 - z0) / dt]), np.array([[s, s / dt], [s / dt, np.sqrt(2) * s / dt]])


def one_step_on(z0, z1, dt, R):
    """The start of two fixes, predicted by one dt more."""
    v = (z1 - z0) / dt
    return np.array([z1 + v * dt, v]), R * np.array([[5, 3 / dt], [3 / dt, 2 / dt**2]])


WRONG = {
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
        lambda z0, z1, dt, R: made((z0 + z1) / 2, (z1 - z0) / dt, [[R / 2, R / dt / 2], [R / dt / 2, 2 * R / dt**2]]),
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
    "deviations on the diagonal": (
        belief(lambda R, dt: 0, lambda R, dt: math.sqrt(2 * R) / dt, lambda R, dt: math.sqrt(R)),
        "The mean is right. P holds variances, and you have standard deviations; and the corner is not zero, for z₁ is in the position and in the speed.",
    ),
    "deviations on the diagonal, corner": (
        belief(right_corner, lambda R, dt: math.sqrt(2 * R) / dt, lambda R, dt: math.sqrt(R)),
        "The mean and the corner are right. On the diagonal stand variances, and you have standard deviations.",
    ),
    "the lesson's start": (
        belief(lambda R, dt: 0, lambda R, dt: 400 / 12),
        "The mean and the position's variance are right. The speed is (z₁ − z₀)/dt: what is the variance of that? And z₁ is in both, so the corner is not zero.",
    ),
    "correlation": (
        belief(lambda R, dt: math.sqrt(0.5), right_speed),
        "Both variances are right. You put the correlation, √½, into the corner. Wanted is the covariance, in m · m/s.",
    ),
    "half the corner": (
        belief(lambda R, dt: R / dt / 2, right_speed),
        "Both variances are right. The corner is the mean of e₁ · (e₁ − e₀)/dt; e₁² is R, and nothing halves it.",
    ),
    "root corner": (
        belief(lambda R, dt: math.sqrt(2) * R / dt, right_speed),
        "Both variances are right. The corner you have is the product of both σ, as if the errors were the same. Only a part of the speed's error is that of z₁.",
    ),
    "difference halved": (
        belief(right_corner, right_speed, mean=lambda z0, z1, dt: [z1, (z1 - z0) / (2 * dt)]),
        "P and the position are right. Between the two fixes lies one dt, not two.",
    ),
    "no speed": (
        belief(right_corner, right_speed, mean=lambda z0, z1, dt: [z1, 0.0]),
        "P and the position are right. The two fixes tell the speed as well: (z₁ − z₀)/dt.",
    ),
    "no dt in the mean": (
        belief(right_corner, right_speed, mean=lambda z0, z1, dt: [z1, z1 - z0]),
        "P and the position are right. The speed is the difference per second: divide by dt.",
    ),
    "predicted": (
        belief(right_corner, right_speed, mean=lambda z0, z1, dt: [2 * z1 - z0, (z1 - z0) / dt]),
        "The position is that of the second fix, z₁. You went on by one more step.",
    ),
    "four R": (
        belief(right_corner, lambda R, dt: 4 * R / dt**2),
        "The variance of a difference of two fixes is R + R = 2R, not 4R.",
    ),
    "2 squared": (
        belief(lambda R, dt: 0, lambda R, dt: 4 * R / dt**2),
        "The variance of a difference of two fixes is R + R = 2R, not 4R; and the corner is not zero, for z₁ is in both.",
    ),
    "difference of variances": (
        belief(lambda R, dt: 0, lambda R, dt: 0),
        "The variances of the two fixes do not cancel in the difference: they add up. And z₁ is in both, so there is a corner.",
    ),
    "the middle alone": (
        belief(right_corner, right_speed, mean=lambda z0, z1, dt: [(z0 + z1) / 2, (z1 - z0) / dt]),
        "P and the speed are right. The position at the time of z₁ is z₁; the middle is where it was half a step ago.",
    ),
    "half R": (
        belief(right_corner, right_speed, lambda R, dt: R / 2),
        "The position's variance is that of one fix, R. (The mean of both would have R/2, but it belongs half a step ago.)",
    ),
    "P times R twice": (
        belief(lambda R, dt: 0, right_speed, lambda R, dt: 2 * R),
        "The position is one fix, z₁, so its variance is R; and the corner is not zero, for z₁ is in both.",
    ),
    "large speed variance": (
        belief(lambda R, dt: 0, lambda R, dt: 1e6),
        "The speed is known from the two fixes, and not unknown: what is the variance of (z₁ − z₀)/dt? And z₁ is in both, so there is a corner.",
    ),
    "σ for the variance": (
        sigma_on_the_diagonal,
        "All but the lower right is right. There √(2R)/dt is the standard deviation of the speed: P holds its square, the variance.",
    ),
    "for the moment of z0": (
        lambda z0, z1, dt, R: (np.array([z0, (z1 - z0) / dt]), np.array([[R, -R / dt], [-R / dt, 2 * R / dt**2]])),
        "That is the belief at the moment of z0, and it is right there. Asked is the one after the second fix: the position is z1, "
        "and an error of z1 makes the speed larger, so the corner is positive.",
    ),
    "roots": (deviations, "The mean is right. A covariance holds variances: R, R/dt and 2R/dt², without roots."),
    "one dt missing": (
        lambda z0, z1, dt, R: (np.array([z1, (z1 - z0) / dt]), R * np.array([[1, 1], [1, 2 / dt]])),
        "The mean is right. In P one division by dt is missing in the corners and one in the lower right: the "
        "corner is in m · m/s, the speed's variance in (m/s)².",
    ),
    "predicted, P too": (
        one_step_on,
        "That is the belief one dt after the second fix, predicted. Asked is the one at the time of z₁ itself.",
    ),
}
