"""Lesson 18, `mended_start`: wrong answers, each with the sentence that it gets."""

import numpy as np


def assembled(first, place, speed):
    """What a start returns: the first positions, and the states [x, vx, y, vy] at the second sample."""
    return first, np.stack([place[:, 0], speed[:, 0], place[:, 1], speed[:, 1]], axis=-1)


def for_all(speed, z):
    """The speed of run 1 for all runs."""
    return np.tile(speed[0], (len(z), 1))


def swapped(z):
    """The first position with the index of the sample where the index of the component should be."""
    return np.stack([z[:, 0, 0], z[:, 1, 0]], axis=-1)


def started(z, T, speed=None):
    """The right start; or one with other speeds."""
    speed = (z[:, 1] - z[:, 0]) / T if speed is None else speed
    return z[:, 0], np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)


def runs_for_time(z, T):
    """Run 2 minus run 1 for a speed."""
    speed = np.tile((z[1, 0] - z[0, 0]) / T, (len(z), 1))
    return z[:, 0], np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)


def speeds_from(first):
    """The start, with another first reading in the speed."""

    def start(z, T):
        speed = (z[:, 1] - first(z)) / T
        return z[:, 0], np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)

    return start


def norths(z, T):
    """The first position holds both norths."""
    speed = (z[:, 1] - z[:, 0]) / T
    return z[:, :2, 1], np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)


def run_before(z, T):
    """The second reading of the run before is subtracted; run 1 has none before it."""
    before = np.vstack([z[:1, 0], z[:-1, 1]])
    speed = (z[:, 1] - before) / T
    return z[:, 0], np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)


WRONG = {
    "as published": (
        lambda z, T: assembled(swapped(z), z[:, 1], for_all((z[:, 1] - z[:, 0]) / T, z)),
        "That is still the published start: an east in place of a north, and run 1's speed for all.",
    ),
    "only the position mended": (
        lambda z, T: assembled(z[:, 0], z[:, 1], for_all((z[:, 1] - z[:, 0]) / T, z)),
        "The first position is mended. All runs still start with the speed of run 1.",
    ),
    "only the speed mended": (
        lambda z, T: assembled(swapped(z), z[:, 1], (z[:, 1] - z[:, 0]) / T),
        "Each run has its own speed now. The first position still has the second sample's east in place of a north.",
    ),
    "wrong sample": (
        lambda z, T: assembled(np.stack([z[:, 0, 0], z[:, 1, 1]], axis=-1), z[:, 1], (z[:, 1] - z[:, 0]) / T),
        "It is a north now, but that of the second sample: both parts of the first position come from sample 0.",
    ),
    "speed backwards": (
        lambda z, T: assembled(z[:, 0], z[:, 1], (z[:, 0] - z[:, 1]) / T),
        "Your ships sail backwards: later minus earlier.",
    ),
    "T forgotten": (
        lambda z, T: assembled(z[:, 0], z[:, 1], z[:, 1] - z[:, 0]),
        "Both faults are mended, but a difference of positions is no speed until it is divided by T.",
    ),
    "mean speed of all runs": (
        lambda z, T: assembled(z[:, 0], z[:, 1], np.tile(((z[:, 1] - z[:, 0]) / T).mean(axis=0), (len(z), 1))),
        "Each run is a ship of its own that knows nothing of the others: do not average over the runs.",
    ),
    "state at the first sample": (
        lambda z, T: assembled(z[:, 0], z[:, 0], (z[:, 1] - z[:, 0]) / T),
        "Both faults are mended, but the state belongs to the second sample: its position is z[:, 1].",
    ),
    "order of the states": (
        lambda z, T: (z[:, 0], np.concatenate([z[:, 1], (z[:, 1] - z[:, 0]) / T], axis=-1)),
        "The numbers are right, the order is not: the state is [east, its speed, north, its speed].",
    ),
    "first is the second": (
        lambda z, T: assembled(z[:, 1], z[:, 1], (z[:, 1] - z[:, 0]) / T),
        "The state is right. The first positions are those of the first sample, z[:, 0], both components.",
    ),
    "two steps": (
        lambda z, T: assembled(z[:, 0], z[:, 1], (z[:, 2] - z[:, 0]) / (2 * T)),
        "Your speed is that from the first to the third sample. The start uses the first two.",
    ),
    "later speed": (
        lambda z, T: assembled(z[:, 0], z[:, 1], (z[:, 2] - z[:, 1]) / T),
        "That is the speed between the second and the third sample. The start uses the first two.",
    ),
    "state at the third": (
        lambda z, T: assembled(z[:, 0], z[:, 2], (z[:, 1] - z[:, 0]) / T),
        "The state belongs to the second sample: its position is z[:, 1].",
    ),
    "velocity of the last pair": (
        lambda z, T: assembled(z[:, 0], z[:, 1], (z[:, -1] - z[:, -2]) / T),
        "The last two readings are not there yet at the start. The speed comes from the first two.",
    ),
    "times T": (
        lambda z, T: assembled(z[:, 0], z[:, 1], (z[:, 1] - z[:, 0]) * T),
        "You multiplied by T. A speed is a difference of positions divided by the time between them.",
    ),
    "the first positions alone": (
        lambda z, T: z[:, 0],
        "The first positions are right. Return two things: the first positions, and then the states.",
    ),
    "the state alone": (
        lambda z, T: assembled(z[:, 0], z[:, 1], (z[:, 1] - z[:, 0]) / T)[1],
        "The states are right. Return two things: the first positions, and then the states.",
    ),
    "runs and samples exchanged": (
        lambda z, T: (z[0], started(z, T)[1]),
        "`z[0]` is run 1 with all its samples. Read the indices aloud: run, sample, component. The first positions of all runs are `z[:, 0]`.",
    ),
    "first of run 1": (
        lambda z, T: (z[0, 0], started(z, T)[1]),
        "The states are right. Your first position is that of run 1 alone: put a colon in the place of the run.",
    ),
    "T = 2": (
        lambda z, T: started(z, 2),
        "Your speeds are right for readings 2 s apart. The time between them is handed in as `T`.",
    ),
    "speed of one sample": (
        lambda z, T: started(z, T, z[:, 1] / T),
        "You divided the second position by T. A speed is a *difference* of positions divided by T.",
    ),
    "speed east twice": (
        lambda z, T: started(z, T, (z[:, 1] - z[:, 0])[:, [0, 0]] / T),
        "You took the speed towards east for both. The last state is the speed towards north, `speed[:, 1]`.",
    ),
    "speed north twice": (
        lambda z, T: started(z, T, (z[:, 1] - z[:, 0])[:, [1, 1]] / T),
        "You took the speed towards north for both. The second state is the speed towards east, `speed[:, 0]`.",
    ),
    "speeds exchanged": (
        lambda z, T: started(z, T, (z[:, 1] - z[:, 0])[:, ::-1] / T),
        "The two speeds have changed places: the state is [east, its speed, north, its speed].",
    ),
    "first exchanged": (
        lambda z, T: (z[:, 0, ::-1], started(z, T)[1]),
        "The states are right. In the first positions north stands before east.",
    ),
    "two states alone": (
        lambda z, T: (z[:, 0], z[:, 1]),
        "The positions are right. The state holds the speeds too: [east, its speed, north, its speed].",
    ),
    "speed over two steps": (
        lambda z, T: started(z, 2 * T),
        "Your speeds are half of what they should be. From the first to the second sample there is one step, T.",
    ),
    "all first positions by T": (
        lambda z, T: (started(z, T)[1], z[:, 0]),
        "Both are right, in the wrong order: first the first positions, then the states.",
    ),
    "runs for time": (
        runs_for_time,
        "Your speed is run 2 minus run 1. Take sample 2 minus sample 1 within each run: z[:, 1] − z[:, 0].",
    ),
    "first reading of run 1": (
        speeds_from(lambda z: z[0, 0]),
        "The positions are right. In the speeds the first reading of run 1 is subtracted from every run's second one: each run has its "
        "own, z[:, 0].",
    ),
    "first reading, mean of the runs": (
        speeds_from(lambda z: z[:, 0].mean(axis=0)),
        "The positions are right. In the speeds the mean first reading of all runs is subtracted: each run has its own, z[:, 0].",
    ),
    "two norths": (
        norths,
        "The states are right. Your first position holds the north of the first sample and the north of the second. The indices are run, "
        "sample, component: `z[:, 0, 1]` is a north; east and north of the first sample are `z[:, 0]`.",
    ),
    "the run before": (
        run_before,
        "The positions are right, and so is the speed of run 1. In the others the second reading of the run "
        "*before* is subtracted: each run has a first reading of its own, z[:, 0].",
    ),
}
