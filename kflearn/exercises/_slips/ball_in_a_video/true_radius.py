"""Lesson 19, `true_radius`: wrong answers, each with the sentence that it gets."""

import numpy as np
from scipy import ndimage

SQUARE = np.ones((3, 3))


def largest(regions):
    """The largest 4-connected region of a picture of True and False."""
    labels, _ = ndimage.label(regions)
    return labels == 1 + np.bincount(labels.ravel())[1:].argmax()


def core(differs):
    return largest(ndimage.binary_erosion(differs, SQUARE, iterations=2))


def disc_radius(region):
    return np.sqrt(region.sum() / np.pi)


def neighbours(differs, structure):
    """What hangs together with the eroded ball."""
    labels, _ = ndimage.label(differs, structure)
    return labels == labels[core(differs)][0]


def widths(differs):
    """Half of the width of the largest region, which is the cable."""
    labels, _ = ndimage.label(differs)
    columns = np.argwhere(labels == 1 + np.bincount(labels.ravel())[1:].argmax())[:, 1]
    return (columns.max() - columns.min() + 1) / 2


def background(differs):
    return np.sqrt(np.bincount(ndimage.label(differs)[0].ravel()).max() / np.pi)


def by_size(measure):
    """A radius from the ball's rows and columns."""

    def radius(differs):
        labels, _ = ndimage.label(ndimage.binary_erosion(differs, np.ones((3, 3)), iterations=2))
        core = labels == 1 + np.bincount(labels.ravel())[1:].argmax()
        regions, _ = ndimage.label(differs)
        return measure(*np.ptp(np.argwhere(regions == regions[core][0]), axis=0))

    return radius


WRONG = {
    "as published": (
        lambda d: disc_radius(core(d)),
        "That is the published radius again: the right region, counted after the erosions have taken its rim.",
    ),
    "two pixels added": (
        lambda d: disc_radius(core(d)) + 2,
        "Two erosions take off about two pixels, not exactly: a square reaches further along its diagonals. Count instead of guessing.",
    ),
    "all that differs": (
        disc_radius,
        "You counted everything that differs, stray pixels and cable included: only the ball's own region.",
    ),
    "largest before erosion": (
        lambda d: disc_radius(largest(d)),
        "The largest region of `differs` may be the cable, long and thin. Let the erosions decide which region it is.",
    ),
    "all cores": (
        lambda d: disc_radius(ndimage.binary_propagation(ndimage.binary_erosion(d, SQUARE, iterations=2), mask=d)),
        "All regions that survive the erosions are counted here, in full: take the largest of them alone.",
    ),
    "all eroded": (
        lambda d: disc_radius(ndimage.binary_erosion(d, SQUARE, iterations=2)),
        "You counted all that is left after the erosions, still without its rim: first choose the largest region, then undo the loss.",
    ),
    "dilated twice": (
        lambda d: disc_radius(ndimage.binary_dilation(core(d), SQUARE, iterations=2)),
        "Two dilations give nearly all of it back, but not the shape that was there: count the region as it stands in `differs`.",
    ),
    "eroded once": (
        lambda d: disc_radius(largest(ndimage.binary_erosion(d, SQUARE))),
        "One erosion less loses less, but it still loses, and the cable may survive it.",
    ),
    "area": (
        lambda d: ndimage.binary_propagation(core(d), mask=d).sum(),
        "That is the area, in pixels, and it is right. The radius is the root of area/π.",
    ),
    "root forgotten": (
        lambda d: ndimage.binary_propagation(core(d), mask=d).sum() / np.pi,
        "The area is right, the root is missing: area = π radius².",
    ),
    "diameter": (
        lambda d: 2 * disc_radius(ndimage.binary_propagation(core(d), mask=d)),
        "That is the diameter.",
    ),
    "π forgotten": (
        lambda d: np.sqrt(ndimage.binary_propagation(core(d), mask=d).sum()),
        "The area is right; a disc's radius is the root of area/π, not of the area.",
    ),
    "eight neighbours": (
        lambda d: disc_radius(neighbours(d, SQUARE)),
        "Pixels are connected across corners as well here, so stray pixels that touch the ball at a corner "
        "count with it. Connect by sides alone: that needs no second argument.",
    ),
    "two diamonds": (
        lambda d: disc_radius(ndimage.binary_dilation(core(d), iterations=2)),
        "Two dilations with a cross do not give back what two erosions with a square took: count the region as it"
        " stands in `differs`.",
    ),
    "label 1": (
        lambda d: disc_radius(ndimage.label(d)[0] == 1),
        "You took the region of `differs` with the number 1, or with the number that the eroded ball has among the eroded regions. Each labelling counts anew, from the top left: here that region is a stray pixel. The ball is the region that holds the eroded core.",
    ),
    "scaled": (
        lambda d: disc_radius(core(d)) * 14 / 11.84,
        "14/11.84 is right for the ball of the film only. Another ball loses another share of its radius: count "
        "its pixels in `differs`.",
    ),
    "the region": (
        lambda d: ndimage.binary_propagation(core(d), mask=d),
        "That is the region, and it is right. Return its radius: the root of its number of pixels over π.",
    ),
    "half of the width": (
        widths,
        "That is half the width of the largest region, the cable. Let the erosions choose the ball, then count its pixels: √(area/π).",
    ),
    "background": (
        background,
        "The label 0 is the background, and it is the largest: leave it out. And the erosions choose the ball.",
    ),
} | {
    f"half of {of}, {more}": (
        by_size(lambda rows, columns, w=w, more=more: (w * rows + (1 - w) * columns + more) / 2),
        f"That is half of {of}, which one rough pixel at the edge changes. Count the pixels of the region: √(area/π).",
    )
    for more in (0, 1)
    for of, w in (("the ball's width", 0), ("the ball's height", 1), ("the mean of the ball's width and height", 0.5))
}
