"""Log-log line plots as inline SVG, without a library: nothing to install, and small pages."""
import math
from html import escape

WIDTH, HEIGHT = 520, 300
LEFT, RIGHT, TOP, BOTTOM = 62, 200, 16, 44
COLOURS = ("#1b6ca8", "#c8553d", "#3a7d44", "#8e5572", "#c09a2b", "#55606e", "#00a6a6", "#b0413e",
           "#6a4c93", "#8ac926", "#1982c4", "#ff924c")


def decades(values):
    """Exponents of the powers of ten that enclose the values."""
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    return low, max(high, low + 1)


def power_label(exponent):
    return f"{10 ** exponent:,}" if 0 <= exponent <= 7 else f"{10.0 ** exponent:g}"


class Axes:
    def __init__(self, xs, ys):
        self.x, self.y = decades(xs), decades(ys)

    def at_x(self, x):
        share = (math.log10(x) - self.x[0]) / (self.x[1] - self.x[0])
        return LEFT + share * (WIDTH - LEFT - RIGHT)

    def at_y(self, y):
        share = (math.log10(y) - self.y[0]) / (self.y[1] - self.y[0])
        return HEIGHT - BOTTOM - share * (HEIGHT - TOP - BOTTOM)

    def svg(self, x_title, y_title):
        parts = []
        for e in range(self.x[0], self.x[1] + 1):
            x = self.at_x(10.0 ** e)
            parts.append(f'<path class="grid" d="M{x:.1f} {TOP}V{HEIGHT - BOTTOM}"/>'
                         f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">'
                         f'{power_label(e)}</text>')
        for e in range(self.y[0], self.y[1] + 1):
            y = self.at_y(10.0 ** e)
            parts.append(f'<path class="grid" d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}"/>'
                         f'<text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">'
                         f'{power_label(e)}</text>')
        middle = (TOP + HEIGHT - BOTTOM) / 2
        parts.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 8}" '
                     f'text-anchor="middle">{escape(x_title)}</text>'
                     f'<text transform="translate(13 {middle}) rotate(-90)" text-anchor="middle">'
                     f'{escape(y_title)}</text>')
        return "".join(parts)


def log_log(series, x_title, y_title):
    """series: name -> list of (x, y), all positive. An SVG element, or empty without data."""
    series = {name: sorted(points) for name, points in series.items() if points}
    every = [p for points in series.values() for p in points]
    if not every:
        return ""
    axes = Axes([x for x, _ in every], [y for _, y in every])
    parts = [f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" role="img" '
             f'aria-label="{escape(y_title)} against {escape(x_title)}">',
             axes.svg(x_title, y_title)]
    for k, (name, points) in enumerate(series.items()):
        colour, y = COLOURS[k % len(COLOURS)], TOP + 10 + 16 * k
        line = " ".join(f"{axes.at_x(px):.1f},{axes.at_y(py):.1f}" for px, py in points)
        dots = "".join(f'<circle cx="{axes.at_x(px):.1f}" cy="{axes.at_y(py):.1f}" r="2.5" '
                       f'fill="{colour}"/>' for px, py in points)
        parts.append(f'<polyline points="{line}" fill="none" stroke="{colour}" '
                     f'stroke-width="1.6"/>{dots}<path d="M{WIDTH - RIGHT + 8} {y}h14" '
                     f'stroke="{colour}" stroke-width="2"/><text x="{WIDTH - RIGHT + 27}" '
                     f'y="{y + 4}">{escape(name)}</text>')
    return "".join(parts) + "</svg>"
