"""[KM] A ball in a video: rendered frames, or the learner's own, and where the ball is in each.

Positions are (column, row) in pixels, the row counted downwards; the centre of the first pixel is (0, 0). Frames are
arrays (T, rows, columns, 3) of bytes.

Examples
--------
>>> from kflearn import video
>>> film = video.render(steps=8, rng=0)
>>> found = video.detect(film.frames, film.frames[:6].mean(axis=0))
>>> print(found.centre[6:].round())
[[40. 30.]
 [45. 33.]]
"""

from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..models import checks as check

ROWS, COLUMNS, RADIUS = 240, 320, 14
GRAVITY, BOUNCE, FLOOR, FRICTION = 6.0, 0.7, 210.0, 1.0  # px/frame², share of speed kept, px, px/frame²


class Film(NamedTuple):
    """A film and what is really in it.

    Attributes
    ----------
    frames : ndarray of bytes (T, rows, columns, 3)
    truth : ndarray (T, 4)
        Column, row and their velocities (px/frame); NaN before the ball enters.
    hidden : ndarray of bool (T,)
        Whether something stands before the ball.
    """

    frames: np.ndarray
    truth: np.ndarray
    hidden: np.ndarray


def fall(steps, start=(40.0, 30.0, 5.0, 0.0), substeps=1000) -> np.ndarray:
    """The path of a ball that falls, bounces and comes to rest.

    At the floor the vertical speed turns round and keeps 70 %; a ball that would rise with less than half of gravity's
    pull in a frame stays down and rolls on with friction.

    Parameters
    ----------
    steps : int
        How many frames.
    start : four floats
        Column, row (px) and their velocities (px/frame) in the first frame.
    substeps : int
        Into how many small steps each frame is divided.

    Returns
    -------
    ndarray (steps, 4)
        Column, row and their velocities, one row a frame.
    """
    column, row, across, down = start
    path, h = [], 1 / substeps
    for _ in range(check.whole_number("steps", steps)):
        path.append((column, row, across, down))
        for _ in range(substeps):
            column += across * h
            if row == FLOOR and down == 0:
                across = max(across - FRICTION * h, 0.0)
                continue
            row, down = row + down * h + GRAVITY / 2 * h**2, down + GRAVITY * h
            if row >= FLOOR:
                row, down = FLOOR, -BOUNCE * down
                if -down < GRAVITY / 2:
                    down = 0.0
    return np.array(path)


def render(steps=60, empty=6, hidden=(19, 20, 21), rng=None, start=(40.0, 30.0, 5.0, 0.0)) -> Film:
    """Make a film of a ball: a textured background, and noise of standard deviation 2 in every byte.

    Parameters
    ----------
    steps : int
        How many frames.
    empty : int
        How many of them, at the beginning, show the background alone.
    hidden : sequence of int
        In which frames, counted from 0, something that looks like the background stands before the ball.
    rng : numpy.random.Generator, int or None
        A generator or a seed.
    start : four floats
        Column, row (px) and their velocities (px/frame) of the ball in its first frame.
    """
    steps, empty = check.whole_number("steps", steps), check.whole_number("empty", empty)
    rng = check.generator("rng", rng)
    rows, columns = np.mgrid[:ROWS, :COLUMNS]
    waves = np.sin(columns[..., None] / [9, 13, 17] + [0, 1, 2]) * np.cos(rows[..., None] / [15, 11, 19])
    scene = np.array([120, 130, 105]) + 14 * waves + 0.06 * (rows[..., None] - ROWS / 2)
    scene = (scene + 6 * rng.standard_normal((ROWS, COLUMNS, 1))).astype(np.float32)
    truth = np.full((steps, 4), np.nan)
    truth[empty:] = fall(steps - empty, start) if steps > empty else 0
    frames = np.empty((steps, ROWS, COLUMNS, 3), np.uint8)
    covered = np.isin(np.arange(steps), hidden)
    for k in range(steps):
        picture = scene + 2 * rng.standard_normal(scene.shape, dtype=np.float32)
        if k >= empty and not covered[k]:
            _paint(picture, *truth[k, :2])
        frames[k] = np.clip(np.rint(picture), 0, 255)
    return Film(frames, truth, covered)


def throw(steps=16, hidden=(13, 14, 15), rng=None) -> tuple[np.ndarray, np.ndarray]:
    """Film another ball, thrown from a place and with a speed of its own, and find it in each frame.

    Column 30 to 60 px, row 10 to 50 px, sideways 3 to 5.5 px/frame: so the frames 12 to 16 lie between the first bounce
    and the second.

    Parameters
    ----------
    steps : int
        How many frames, from the ball's first on.
    hidden : sequence of int
        In which of them something stands before it.
    rng : numpy.random.Generator, int or None
        A generator or a seed.

    Returns
    -------
    truth : ndarray (steps, 4)
        Column, row and their velocities.
    centre : ndarray (steps, 2)
        Where it was detected, NaN where it was not.
    """
    rng = check.generator("rng", rng)
    start = rng.uniform([30, 10, 3, 0], [60, 50, 5.5, 0])
    film = render(6 + check.whole_number("steps", steps), 6, 6 + np.asarray(hidden), rng, start)
    return film.truth[6:], detect(film.frames[6:], film.frames[:6].mean(axis=0)).centre


def _paint(picture, column, row):
    """A shaded ball with a smooth rim, on top of what is there."""
    down, right = np.ogrid[: picture.shape[0], : picture.shape[1]]
    near = slice(max(int(row) - 16, 0), int(row) + 18), slice(max(int(column) - 16, 0), int(column) + 18)
    below, right = (down - row)[near[0]], (right - column)[:, near[1]]
    cover = np.clip(RADIUS + 0.5 - np.hypot(right, below), 0, 1)[..., None]
    shade = np.clip(1 - 0.015 * (right + below), 0.6, 1.4)[..., None]
    picture[near] += cover * (np.array([200, 60, 45]) * shade - picture[near])


class Detections(NamedTuple):
    """Where the ball is.

    Attributes
    ----------
    centre : ndarray (T, 2)
        Column and row in px, NaN in frames without a ball.
    radius : ndarray (T,)
        Of a disc of the area found, in px.
    """

    centre: np.ndarray
    radius: np.ndarray


def detect(frames, background, threshold=10, erosions=2, smallest=100) -> Detections:
    """Find the ball in each frame, as published.

    Pixels that differ from the background are eroded with a 3×3 square; of the 4-connected regions that are left the
    largest is the ball.

    Parameters
    ----------
    frames : ndarray (T, rows, columns, 3)
    background : ndarray (rows, columns, 3)
        A frame without the ball, or the mean of several.
    threshold : float
        By how much any colour of a pixel has to differ.
    erosions : int
        How often; each takes about a pixel off the radius.
    smallest : int
        How many pixels the ball must have at least.

    Raises
    ------
    ValueError or TypeError
        Where the shapes do not fit.
    """
    from scipy import ndimage  # imported here: `import kflearn` must not wait for SciPy

    frames = check.shape("frames", np.asarray(frames), (None, None, None, 3))
    background = check.shape("background", check.numbers("background", background), frames.shape[1:])
    background = background.astype(np.float32)
    centre, radius = np.full((len(frames), 2), np.nan), np.full(len(frames), np.nan)
    for k, frame in enumerate(frames):
        differs = (abs(frame - background) > threshold).any(axis=-1)
        if erosions:
            differs = ndimage.binary_erosion(differs, np.ones((3, 3)), iterations=erosions)
        labels, count = ndimage.label(differs)
        sizes = np.bincount(labels.ravel(), minlength=2)[1:]
        if count and sizes.max() >= smallest:
            found = labels == 1 + sizes.argmax()
            centre[k] = np.argwhere(found).mean(axis=0)[::-1]
            radius[k] = np.sqrt(sizes.max() / np.pi)
    return Detections(centre, radius)


def load(path) -> np.ndarray:
    """The learner's own frames.

    Parameters
    ----------
    path : str or Path
        A folder of pictures, taken in the order of their names, or a film.

    Returns
    -------
    ndarray of bytes (T, rows, columns, 3)

    Raises
    ------
    FileNotFoundError or ValueError
        Where there is nothing to read or sizes differ.
    ImportError
        Where the optional packages of the extra `video` are not installed.
    """
    try:
        import imageio.v3 as iio
    except ImportError:
        raise ImportError("reading pictures needs the package imageio: install the extra `video`") from None
    path = Path(path)
    if not path.exists():
        raise FileNotFoundError(f"path must be a folder of pictures or a film, found nothing at {path.name}")
    if path.is_dir():
        names = sorted(
            p for p in path.iterdir() if p.suffix.lower() in (".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff")
        )
        if not names:
            raise ValueError(f"path must be a folder with pictures (png, jpg, bmp, tif), found none in {path.name}")
        pictures = [_colours(iio.imread(name)) for name in names]
    else:
        pictures = [_colours(frame) for frame in iio.imiter(path)]
    sizes = sorted({picture.shape[:2] for picture in pictures})
    if len(sizes) > 1:
        raise ValueError(f"path must hold pictures of one size, found {sizes[0]} and {sizes[1]} (rows, columns)")
    return np.stack(pictures)


def _colours(picture):
    """Bytes (rows, columns, 3), whatever was in the file: grey, with transparency, 16 bits."""
    if picture.dtype != np.uint8:
        picture = (picture / np.iinfo(picture.dtype).max * 255).astype(np.uint8)
    if picture.ndim == 2:
        picture = picture[..., None]
    return np.repeat(picture, 3, axis=-1) if picture.shape[-1] < 3 else picture[..., :3]
