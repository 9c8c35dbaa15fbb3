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
        legends = [ax.get_legend() for ax in self.fig.axes if ax.get_legend() and ax.get_legend().get_frame_on()]
        self._legends = [legend.get_window_extent() for legend in legends]

    def show_at(self, ratio) -> None:
        """Draw everything for a screen with so many device pixels for each pixel of the page."""
        if ratio != self.ratio:
            self.ratio = ratio
            self.fig.set_dpi(DPI * ratio)
            self._draw_still()

    def still(self) -> tuple[dict, bytes]:
        """What stays: its size in pixels and the places of its legends, and a PNG file."""
        from PIL import Image

        canvas = self.fig.canvas
        canvas.restore_region(self._still)
        pixels = np.asarray(canvas.buffer_rgba())
        file = io.BytesIO()
        Image.fromarray(pixels[..., :3]).save(file, "png", compress_level=6)
        height, width = pixels.shape[:2]
        sides = [[round(v) for v in (box.x0, height - box.y1, box.width, box.height)] for box in self._legends]
        return dict(ratio=self.ratio, width=width, height=height, legends=sides), file.getvalue()

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
        for box in self._legends:
            canvas.restore_region(self._still, bbox=box, xy=(box.x0, box.y0))
        return np.asarray(canvas.buffer_rgba())

    def png(self) -> bytes:
        """The whole picture of now as a PNG file, for a screen with ratio 1."""
        ratio = self.ratio
        self.show_at(1.0)
        try:
            return plots.encode(self.pixels(), quick=True)
        finally:
            self.show_at(ratio)
