"""The picture of a playground: drawn once without what moves; what moves is recorded, or drawn, on top of it."""

import io

import numpy as np

from . import plots
from .contents import moving
from .recorder import Recorder, Unrecordable

DPI = 100  # of figures; pixels of the page at 100 %


class Stage:
    """A figure, and the artists in it that move.

    Attributes
    ----------
    artists : whatever `draw` returned
    ratio : float
        Device pixels for each pixel of the page; 1, or 2 on most modern screens.
    """

    def __init__(self, draw, update, size):
        self.fig, _ = plots.figure(0, size=size)
        self.ratio = 1.0
        with plots.style():
            self.artists = draw(self.fig)
            update(self.artists)
        self.moving = moving(self.artists)
        plots.fit(self.moving)
        self.fig.canvas.draw()  # lays out the axes
        self.fig.set_layout_engine("none")
        for ax in self.fig.axes:
            ax.autoscale(False)
        for artist in self.moving:
            artist.set_animated(True)  # left out by canvas.draw()
        self._draw_still()

    def _draw_still(self):
        """Draw what stays, and keep its pixels; what moves never covers a legend that has a frame."""
        canvas = self.fig.canvas
        canvas.draw()
        self._still = canvas.copy_from_bbox(self.fig.bbox)
        self._seen = np.array(canvas.buffer_rgba())
        legends = [ax.get_legend() for ax in self.fig.axes if ax.get_legend() and ax.get_legend().get_frame_on()]
        self._legends = [self._sides(legend.get_window_extent()) for legend in legends]

    def _sides(self, box):
        """A box in whole pixels from the top: x, y, width, height."""
        return [round(side) for side in (box.x0, len(self._seen) - box.y1, box.width, box.height)]

    def show_at(self, ratio) -> None:
        """Draw everything for a screen with so many device pixels for each pixel of the page."""
        if ratio != self.ratio:
            self.ratio = ratio
            self.fig.set_dpi(DPI * ratio)
            self._draw_still()

    def still(self) -> tuple[dict, bytes]:
        """What stays: its size in pixels and the places of its legends, and a PNG file."""
        from PIL import Image

        file = io.BytesIO()
        Image.fromarray(self._seen[..., :3]).save(file, "png", compress_level=6)
        height, width = self._seen.shape[:2]
        return dict(ratio=self.ratio, width=width, height=height, legends=self._legends), file.getvalue()

    def record(self) -> tuple[dict, list[bytes]]:
        """What moves, as playground.js draws it: operations and styles; points and images.

        What a Recorder cannot keep becomes one image of everything, drawn by matplotlib.
        """
        recorder = Recorder(self.fig)
        try:
            for artist in self.moving:
                artist.draw(recorder)
        except Unrecordable:
            whole = ["i", 0, 0, 0, 1.0, 0]
            return dict(ops=[whole], styles=[]), [b"", plots.encode(self.pixels(), quick=True)]
        return dict(ops=recorder.ops, styles=recorder.styles), [recorder.points.tobytes(), *recorder.images]

    def pixels(self) -> np.ndarray:
        """The whole picture of now by matplotlib's own Agg renderer, (height, width, 4)."""
        canvas = self.fig.canvas
        canvas.restore_region(self._still)
        for artist in self.moving:
            artist.draw(canvas.get_renderer())
        pixels = np.array(canvas.buffer_rgba())
        for x, y, width, height in self._legends:
            part = slice(y, y + height), slice(x, x + width)
            pixels[part] = self._seen[part]
        return pixels

    def png(self) -> bytes:
        """The whole picture of now as a PNG file, for a screen with ratio 1."""
        ratio = self.ratio
        self.show_at(1.0)
        try:
            return plots.encode(self.pixels(), quick=True)
        finally:
            self.show_at(ratio)
