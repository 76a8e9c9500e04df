"""Line plots as SVG text: axes with round numbers and units, curves, bands, markers."""

import math
from html import escape
from typing import List, Sequence, Tuple

LEFT, RIGHT, TOP, BOTTOM = 58, 12, 26, 42  # px around the plotting area


class Plot:
    """Collects curves, then draws. `equal`: one metre is as long to the side as upwards."""

    def __init__(self, title: str, x_label: str, y_label: str, width: int = 540, height: int = 250,
                 equal: bool = False):
        self._title, self._x_label, self._y_label = title, x_label, y_label
        self._width, self._height, self._equal = width, height, equal
        self._curves: List[Tuple[Sequence[float], Sequence[float], str]] = []
        self._markers: List[Tuple[float, float, str, str]] = []
        self._bands: List[Tuple[float, float, str]] = []

    def curve(self, xs: Sequence[float], ys: Sequence[float], style: str) -> None:
        """A line of the style sheet's class `style`."""
        self._curves.append((xs, ys, style))

    def marker(self, x: float, y: float, style: str, text: str = "") -> None:
        self._markers.append((x, y, style, text))

    def bands(self, bands: Sequence[Tuple[float, float, str]]) -> None:
        """Stretches of the x axis, (from, to, short name)."""
        self._bands = list(bands)

    def svg(self) -> str:
        xs = [x for curve in self._curves for x in curve[0]] + [mark[0] for mark in self._markers]
        ys = [y for curve in self._curves for y in curve[1]] + [mark[1] for mark in self._markers]
        x_span, y_span = _span(xs, 0.0), _span(ys, 0.12)
        if self._equal:
            x_span, y_span = self._equalSpans(x_span, y_span)
        self._to_x = _scale(x_span, LEFT, self._width - RIGHT)
        self._to_y = _scale(y_span, self._height - BOTTOM, TOP)
        parts = self._drawBands() + self._drawAxes(x_span, y_span)
        parts += [self._drawCurve(*curve) for curve in self._curves]
        parts += [self._drawMarker(*marker) for marker in self._markers]
        return '<svg viewBox="0 0 %d %d" role="img" aria-label="%s">%s</svg>' % (
            self._width, self._height, escape(self._title), "".join(parts))

    def _equalSpans(self, x_span, y_span):
        pixels_x, pixels_y = self._width - LEFT - RIGHT, self._height - TOP - BOTTOM
        per_pixel = 1.1 * max((x_span[1] - x_span[0]) / pixels_x,
                              (y_span[1] - y_span[0]) / pixels_y)
        return (_around(x_span, per_pixel * pixels_x), _around(y_span, per_pixel * pixels_y))

    def _drawBands(self) -> List[str]:
        parts = []
        for i, (start, end, name) in enumerate(self._bands):
            left, right = self._to_x(start), self._to_x(end)
            parts.append('<rect class="band%d" x="%.1f" y="%d" width="%.1f" height="%d"/>' % (
                i % 2, left, TOP, max(right - left, 0), self._height - TOP - BOTTOM))
            parts.append('<text class="bandname" x="%.1f" y="%d">%s</text>' % (
                (left + right) / 2, TOP + 11, escape(name)))
        return parts

    def _drawAxes(self, x_span, y_span) -> List[str]:
        bottom, right = self._height - BOTTOM, self._width - RIGHT
        parts = ['<text class="title" x="%d" y="16">%s</text>' % (LEFT, escape(self._title))]
        for value, text in ticks(*x_span):
            x = self._to_x(value)
            parts.append('<line class="grid" x1="%.1f" x2="%.1f" y1="%d" y2="%d"/>' % (
                x, x, TOP, bottom))
            parts.append('<text class="xtick" x="%.1f" y="%d">%s</text>' % (x, bottom + 15, text))
        for value, text in ticks(*y_span):
            y = self._to_y(value)
            parts.append('<line class="grid" x1="%d" x2="%d" y1="%.1f" y2="%.1f"/>' % (
                LEFT, right, y, y))
            parts.append('<text class="ytick" x="%d" y="%.1f">%s</text>' % (LEFT - 6, y + 4, text))
        middle = (TOP + bottom) / 2
        parts.append('<text class="label" x="%.1f" y="%d">%s</text>' % (
            (LEFT + right) / 2, self._height - 6, escape(self._x_label)))
        parts.append('<text class="label" transform="translate(14 %.1f) rotate(-90)">%s</text>' % (
            middle, escape(self._y_label)))
        return parts

    def _drawCurve(self, xs, ys, style) -> str:
        points = " ".join("%.1f,%.1f" % (self._to_x(x), self._to_y(y)) for x, y in zip(xs, ys))
        return '<polyline class="curve %s" points="%s"/>' % (style, points)

    def _drawMarker(self, x, y, style, text) -> str:
        px, py = self._to_x(x), self._to_y(y)
        return ('<circle class="marker %s" cx="%.1f" cy="%.1f" r="4.5"/>'
                '<text class="markname" x="%.1f" y="%.1f">%s</text>' % (
                    style, px, py, px + 8, py - 8, escape(text)))


def ticks(low: float, high: float) -> List[Tuple[float, str]]:
    """Round values within the span, four to nine of them, and how to write them."""
    rough = (high - low) / 6
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(factor * power for factor in (1, 2, 5, 10) if factor * power >= rough)
    digits = max(0, -math.floor(math.log10(step) + 1e-9))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [(i * step, "%.*f" % (digits, i * step + 0.0)) for i in range(first, last + 1)]


def _span(values: Sequence[float], margin: float) -> Tuple[float, float]:
    low, high = (min(values), max(values)) if values else (0.0, 1.0)
    extra = (high - low) * margin
    if high - low < 1e-6:
        extra = 0.5
    return low - extra, high + extra


def _around(span: Tuple[float, float], size: float) -> Tuple[float, float]:
    middle = (span[0] + span[1]) / 2
    return middle - size / 2, middle + size / 2


def _scale(span: Tuple[float, float], start: float, end: float):
    factor = (end - start) / (span[1] - span[0])
    return lambda value: start + (value - span[0]) * factor
