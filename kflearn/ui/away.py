"""An arrow at the edge of the axes, for a line that has left them."""

import numpy as np
from matplotlib.text import Text
from matplotlib.transforms import IdentityTransform

FAR, ROOM = 3, 4  # points: what counts as outside; between arrow and edge
HALF, SIGN = 3.5, 6.5  # points: half of an arrow; the width of a sign


class Away(Text):
    """Where a line is furthest above or below its axes: an arrow, and beside it the value. It follows the line.

    Parameters
    ----------
    line : matplotlib Line2D
        In its axes already.
    """

    def __init__(self, line):
        box = dict(facecolor="white", edgecolor="none", alpha=0.8, pad=1)
        super().__init__(color=line.get_color(), fontsize=9, zorder=line.get_zorder() + 1, bbox=box)
        self.line = line
        self.set(transform=IdentityTransform(), in_layout=False)
        line.axes.add_artist(self)

    def draw(self, renderer):
        """Find the place, and draw."""
        self.set_text("")
        if self.line.get_visible() and len(self.line.get_xdata()):
            self._follow(self.line.axes.bbox, self.figure.dpi / 72)
        super().draw(renderer)

    def _follow(self, box, point):
        values = np.ma.asarray(self.line.get_ydata(), dtype=float).filled(np.nan)
        x, y = self.line.axes.transData.transform(np.column_stack([self.line.get_xdata(), values])).T
        out = np.where((x >= box.x0) & (x <= box.x1), np.maximum(y - box.y1, box.y0 - y), np.nan)
        if not np.isfinite(out).any() or np.nanmax(out) < FAR * point:
            return
        k = np.nanargmax(out)
        up, half = y[k] > box.y1, HALF * point
        arrow, value, place = "▲" if up else "▼", short(values[k]), min(max(x[k], box.x0 + half), box.x1 - half)
        wide = SIGN * point * (len(value) + 2)
        if place - half + wide <= box.x1:  # the number fits at the right of its arrow
            left, right = place - half, place - half + wide
            self.set(text=f"{arrow} {value}", ha="left", x=left)
        else:
            left, right = place + half - wide, place + half
            self.set(text=f"{value} {arrow}", ha="right", x=right)
        self.set(va="top" if up else "bottom", y=self._height(box, left, right, up, ROOM * point))

    def _height(self, box, left, right, up, room):
        """Beside the edge, or beside a legend that is there."""
        edge, legend = box.y1 if up else box.y0, self.line.axes.get_legend()
        if legend:
            taken = legend.get_window_extent()
            beside = taken.x0 < right and left < taken.x1
            if beside and abs((taken.y1 if up else taken.y0) - edge) < 5 * room:
                edge = taken.y0 if up else taken.y1
        return edge - room if up else edge + room


def short(value) -> str:
    """A number in few signs: 1353, 12.5, −0.04, 3e+09."""
    size = abs(value)
    text = f"{value:.0e}" if size >= 1e6 else f"{value:.0f}" if size >= 100 else f"{value:.3g}"
    return text.replace("-", "−")
