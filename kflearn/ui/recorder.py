"""What artists draw, as numbers: paths in pixels that a canvas in the browser draws again."""

import io
from functools import cache

import numpy as np
from matplotlib.backend_bases import GraphicsContextBase, RendererBase
from matplotlib.colors import to_hex
from matplotlib.path import Path
from matplotlib.transforms import Affine2D


class Unrecordable(Exception):
    """An artist draws something that a `Recorder` cannot keep, such as a hatch."""


class Recorder(RendererBase):
    """A matplotlib renderer that keeps what is drawn; pixels are those of the figure, counted from the top.

    Paths are prepared as matplotlib's own Agg renderer prepares them: cut at the picture's edge, put on whole pixels
    where they are straight, simplified.

    Parameters
    ----------
    fig : matplotlib Figure

    Attributes
    ----------
    ops : list of lists
        What was drawn, in order:

        - ["p", place, style, clip]: a path
        - ["m", place, [place, …], style, clip]: the same marker, made of some paths, at each point
        - ["i", number, x, y, alpha, clip]: image `number` with its upper left corner at x, y

        A place is [first point, number of points, codes], with a path's codes as one string of digits (1 move, 2 line,
        3 and 4 curves, 9 close) or 0 where all are lines. style: number of an entry of `styles`. clip: the sides
        [x, y, width, height], or a place, or 0.
    styles : list of lists
        [line width, line colour, dashes, fill colour, cap, join]; 0 where there is none.
    images : list of bytes
        PNG files.
    """

    def __init__(self, fig):
        super().__init__()
        self.dpi, self.width, self.height = fig.dpi, float(fig.bbox.width), float(fig.bbox.height)
        self.agg = fig.canvas.get_renderer()  # which knows how large its letters are
        self.flip = Affine2D().scale(1, -1).translate(0, self.height)
        self.ops, self.styles, self.images = [], [], []
        self._numbers, self._count, self._known = [], 0, {}

    @property
    def points(self) -> np.ndarray:
        """All points of all paths, (any, 2) in single precision."""
        return np.concatenate(self._numbers) if self._numbers else np.zeros((0, 2), np.float32)

    # -- what matplotlib asks a renderer

    def points_to_pixels(self, points):
        return points * self.dpi / 72

    def get_canvas_width_height(self):
        return self.width, self.height

    def flipy(self):
        return False

    def get_text_width_height_descent(self, s, prop, ismath):
        return self.agg.get_text_width_height_descent(s, prop, ismath)

    def new_gc(self):
        return GraphicsContextBase()

    def draw_path(self, gc, path, transform, rgbFace=None):
        _refuse(gc)
        style = self._style(gc, rgbFace)
        if style is None:
            return
        edge = None if rgbFace is not None else (-1, -1, self.width + 1, self.height + 1)
        place = self._clean(path, transform + self.flip, gc, edge)
        if place[1]:
            self.ops.append(["p", place, style, self._clip(gc)])

    def draw_markers(self, gc, marker_path, marker_trans, path, trans, rgbFace=None):
        _refuse(gc)
        style = self._style(gc, rgbFace)
        where = trans.transform(path.vertices)
        where = where[np.isfinite(where).all(axis=1)]
        if style is None or not len(where):
            return
        # As Agg does: markers stand on whole pixels.
        at = self._put(np.floor(np.column_stack([where[:, 0], self.height - where[:, 1]]) + 0.5))
        marker = self._clean(marker_path, marker_trans + Affine2D().scale(1, -1), gc, None)
        self.ops.append(["m", at, marker, style, self._clip(gc)])

    def draw_image(self, gc, x, y, im, transform=None):
        _refuse(gc)
        if transform is not None:
            raise Unrecordable("a turned image")
        from PIL import Image

        file = io.BytesIO()  # matplotlib counts an image's rows from its lower edge
        Image.fromarray(np.ascontiguousarray(im[::-1])).save(file, "png", compress_level=1)
        self.images.append(file.getvalue())
        place = [round(x), round(self.height - y - im.shape[0])]
        self.ops.append(["i", len(self.images) - 1, *place, _alpha(gc), self._clip(gc)])

    def draw_gouraud_triangles(self, *args, **kwargs):
        raise Unrecordable("shaded triangles")

    def start_filter(self):
        raise Unrecordable("a filter for pixels")

    # -- how it is kept

    def _clean(self, path, transform, gc, edge):
        """Put a path's points down as Agg would draw them; returns its place."""
        simplify = edge is not None and path.should_simplify
        width = self.points_to_pixels(gc.get_linewidth()) if gc.get_rgb()[3] else 0
        clean = path.cleaned(
            transform, True, edge, simplify=simplify, curves=True, stroke_width=width, snap=gc.get_snap()
        )
        codes, points = clean.codes[:-1], clean.vertices[:-1]  # the last one says "stop"
        plain = len(codes) and codes[0] == Path.MOVETO and (codes[1:] == Path.LINETO).all()
        return [*self._put(points), 0 if plain or not len(codes) else _digits(codes.tobytes())]

    def _put(self, points):
        """Keep points; returns the number of the first, and how many they are."""
        self._numbers.append(points.astype(np.float32))
        first, self._count = self._count, self._count + len(points)
        return [first, len(points)]

    def _style(self, gc, face):
        """The number of a style; None where nothing would be seen."""
        width, line = float(self.points_to_pixels(gc.get_linewidth())), gc.get_rgb()
        offset, dashes = gc.get_dashes()
        fill = _css(*face) if face is not None and (len(face) < 4 or face[3]) else 0
        if face is not None and gc.get_forced_alpha():
            fill = _css(*face[:3], gc.get_alpha())
        if not width or not line[3]:
            style = (0, 0, 0, fill, 0, 0)
        else:
            scaled = 0 if dashes is None else (*(round(float(self.points_to_pixels(d)), 2) for d in (offset, *dashes)),)
            style = (round(width, 3), _css(*line), scaled, fill, gc.get_capstyle(), gc.get_joinstyle())
        if not style[1] and not style[3]:
            return None
        if style not in self._known:
            self._known[style] = len(self.styles)
            self.styles.append(list(style))
        return self._known[style]

    def _clip(self, gc):
        """What limits the drawing: whole pixels of a rectangle, as in Agg, or a path."""
        path, transform = gc.get_clip_path()
        if path is not None:
            return self._clean(path, transform + self.flip, GraphicsContextBase(), None)
        rectangle = gc.get_clip_rectangle()
        if rectangle is None:
            return 0
        left, low, right, high = (int(np.floor(side + 0.5)) for side in rectangle.extents)
        return [left, int(self.height) - high, right - left, high - low]


def _refuse(gc):
    if gc.get_hatch():
        raise Unrecordable("a hatch")
    if gc.get_sketch_params():
        raise Unrecordable("a sketched line")


def _alpha(gc):
    return 1.0 if gc.get_alpha() is None else float(gc.get_alpha())


@cache
def _css(red, green, blue, alpha=1.0):
    """A colour as browsers write it."""
    return to_hex((red, green, blue, alpha), keep_alpha=True)


@cache
def _digits(codes):
    """A path's codes as digits; 79 means that it is closed."""
    return "".join("9" if code == Path.CLOSEPOLY else str(code) for code in codes)
