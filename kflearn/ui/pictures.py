"""From a figure to the notebook: small PNG files of a fixed palette, with words for those who cannot see them."""

import html
import io
from functools import cache

import numpy as np
from matplotlib.colors import to_rgb

from .looks import BAND, colours


def pixels(fig) -> np.ndarray:
    """Draw a figure and return its pixels.

    Parameters
    ----------
    fig : matplotlib Figure
        As `kflearn.plots.figure` makes it.

    Returns
    -------
    array (height, width, 4) of uint8
        Red, green, blue and alpha.

    Examples
    --------
    >>> from kflearn import plots
    >>> fig, ax = plots.figure(size=(4, 3))
    >>> plots.pixels(fig).shape
    (300, 400, 4)
    """
    fig.canvas.draw()
    return np.asarray(fig.canvas.buffer_rgba())


@cache
def palette() -> tuple[np.ndarray, np.ndarray]:
    """256 colours, and for each of 32 × 32 × 32 colours (5 bits of red, green, blue) the number of the nearest of them.

    They are what figures of the vocabulary are made of: greys, each colour fading into white, and each colour fading
    into a band and into the other colours, as happens at smooth edges. The first is white, exactly.
    """
    white, black = np.ones(3), np.zeros(3)
    inks = [np.array(to_rgb(c)) for c in [*colours.values(), "#CC79A7", "#56B4E9"] if c not in ("#000000", "#808080")]
    bands = [white + BAND * (np.array(to_rgb(colours[role])) - white) for role in ("estimate", "prediction", "gain")]
    fade = [white * (1 - s) + black * s for s in np.linspace(0, 1, 34)]
    fade += [white * (1 - s) + ink * s for ink in inks for s in np.linspace(0.1, 1, 10)]
    fade += [a * (1 - s) + b * s for a in bands for b in [*inks, black, white / 2] for s in (0, 0.25, 0.5, 0.75)]
    fade += [a / 2 + b / 2 for i, a in enumerate([*inks, black]) for b in inks[:i]]
    table = np.unique(np.round(255 * np.array(fade)).astype(np.uint8), axis=0)[::-1][:256]
    five = np.arange(32)
    five = (five << 3 | five >> 2).astype(np.float32)
    rgb = np.stack(np.meshgrid(five, five, five, indexing="ij"), axis=-1).reshape(-1, 3)
    points = table.astype(np.float32)
    nearest = np.argmin((points**2).sum(1) - 2 * rgb @ points.T, axis=1).astype(np.uint8)
    return table, nearest


def encode(rgba, quick=False, photo=False) -> bytes:
    """Turn pixels into a PNG of at most 256 colours; white stays white.

    Parameters
    ----------
    rgba : array (height, width, 4) of uint8
        The pixels, as `pixels` returns them.
    quick : bool
        A file a third larger in a tenth of the time (2–3 ms for 800 × 500), for pictures that move.
    photo : bool
        Use 48 of the picture's own colours instead of the fixed ones, for photographs; slow.

    Returns
    -------
    bytes
        A PNG file.

    Examples
    --------
    >>> import numpy as np
    >>> from kflearn import plots
    >>> plots.encode(np.full((2, 3, 4), 255, np.uint8))[1:4]
    b'PNG'
    """
    from PIL import Image

    rgba = np.ascontiguousarray(rgba)
    picture = Image.fromarray(rgba[..., :3]).quantize(48) if photo else _indexed(rgba)
    file = io.BytesIO()
    picture.save(file, "png", **({"compress_level": 1, "compress_type": 3} if quick else {"compress_level": 9}))
    return file.getvalue()


def _indexed(rgba):
    """A picture in the fixed colours."""
    from PIL import Image

    table, nearest = palette()
    colour = rgba.view("<u4").ravel()  # one number a pixel: red in the lowest byte
    image = np.zeros(colour.size, np.uint8)  # 0 is white
    inked = np.flatnonzero(colour != 0xFFFFFFFF)
    c = colour[inked]
    image[inked] = nearest[(c << 7) & 0x7C00 | (c >> 6) & 0x3E0 | (c >> 19) & 0x1F]
    picture = Image.fromarray(image.reshape(rgba.shape[:2]))
    picture.putpalette(table.tobytes())
    return picture


def png(fig, photo=False) -> bytes:
    """Draw a figure and return it as a PNG file.

    Parameters
    ----------
    fig : matplotlib Figure
        As `kflearn.plots.figure` makes it.
    photo : bool
        Keep the colours of photographs.

    Returns
    -------
    bytes
        A PNG file. The same figure gives the same bytes each time.

    Examples
    --------
    >>> from kflearn import plots
    >>> fig, ax = plots.figure()
    >>> len(plots.png(fig)) < 80_000
    True
    """
    return encode(pixels(fig), photo=photo)


def show(fig, alt, photo=False) -> None:
    """Show a figure in the notebook, with a text that says in words what is to be seen.

    Parameters
    ----------
    fig : matplotlib Figure
        As `kflearn.plots.figure` makes it.
    alt : str
        One or two sentences. They go into the image's metadata and into the text form of the output. JupyterLab,
        nbconvert and GitHub use neither for a picture, so they also go into a line under it that opens on a click.
    photo : bool
        Keep the colours of photographs.

    Examples
    --------
    >>> from kflearn import plots
    >>> fig, ax = plots.figure()
    >>> line = plots.truth(ax, [0, 1, 2], [0, 1, 4])
    >>> plots.show(fig, "A curve that becomes steeper.")  # in a notebook, the picture  # doctest: +SKIP
    """
    display_png(png(fig, photo), alt)


def display_png(data, alt) -> None:
    """Show the bytes of a PNG file in the notebook.

    Parameters
    ----------
    data : bytes
        A PNG file.
    alt : str
        One or two sentences that say what is to be seen.
    """
    from IPython.display import display

    words = f"Figure: {alt}"
    display({"image/png": data, "text/plain": words}, metadata={"image/png": {"alt": alt}}, raw=True)
    page = f"<details><summary><small>Figure in words</small></summary><small>{html.escape(alt)}</small></details>"
    display({"text/html": page, "text/plain": words}, raw=True)
