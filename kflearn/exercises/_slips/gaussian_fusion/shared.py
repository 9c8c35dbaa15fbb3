"""Lesson 4: what several exercises' wrong answers are made of."""


def fused(vx, vz):
    """The right variance of two opinions."""
    return vx * vz / (vx + vz)
