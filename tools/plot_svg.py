"""Drawings as SVG, for tools/plot_*: text, logarithmic axes, and plots of time against error."""
import math

# Of a plot of time against error.
WIDTH, HEIGHT = 860, 560
LEFT, RIGHT, TOP, BOTTOM = 84, 36, 76, 96


def text(x, y, words, size=13, anchor="start", colour="#333", extra=""):
    style = f'font-size="{size}" text-anchor="{anchor}" fill="{colour}" {extra}'
    return f'<text x="{x:.1f}" y="{y:.1f}" {style}>{words}</text>'


def turned(x, y, words, size):
    """Returns the title of a vertical axis."""
    return text(x, y, words, size, "middle", extra=f'transform="rotate(-90 {x} {y:.1f})"')


def opening(width, height, left, title, subtitle, subtitle_y=52):
    return [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
            f'viewBox="0 0 {width} {height}" font-family="Inter, DejaVu Sans, Arial, sans-serif">',
            f'<rect width="{width}" height="{height}" fill="#fff"/>',
            text(left, 30, title, 19, extra='font-weight="700"'),
            text(left, subtitle_y, subtitle, 12.5, colour="#666")]


def closed(drawing):
    return "\n".join(drawing + ["</svg>", ""])


class LogAxis:
    """Maps a positive value to pixels between two ends, with a margin, a factor, at both."""

    def __init__(self, values, start, end, margin):
        self.low, self.high = min(values) / margin, max(values) * margin
        self.start, self.end = start, end

    def __call__(self, value):
        share = math.log(value / self.low) / math.log(self.high / self.low)
        return self.start + share * (self.end - self.start)

    def ticks(self, steps):
        """Returns the values of the axis that are one of the steps times a power of ten."""
        decades = range(math.floor(math.log10(self.low)), math.ceil(math.log10(self.high)) + 1)
        return [m * 10.0**d for d in decades for m in steps if self.low <= m * 10.0**d <= self.high]


def frame(x_ticks, y_ticks, x_title, y_title):
    """Returns grid, axes and titles of a plot of time against error. Ticks are places and labels."""
    bottom, right = HEIGHT - BOTTOM, WIDTH - RIGHT
    out = []
    for at, label in x_ticks:
        out.append(f'<line x1="{at:.1f}" x2="{at:.1f}" y1="{TOP}" y2="{bottom}" stroke="#e6e6e6"/>')
        out.append(text(at, bottom + 20, label, anchor="middle"))
    for at, label in y_ticks:
        out.append(f'<line x1="{LEFT}" x2="{right}" y1="{at:.1f}" y2="{at:.1f}" stroke="#e6e6e6"/>')
        out.append(text(LEFT - 8, at + 4, label, anchor="end"))
    out.append(f'<path d="M{LEFT} {TOP}V{bottom}H{right}" fill="none" stroke="#555"/>')
    out.append(text((LEFT + right) / 2, bottom + 44, x_title, 14, "middle"))
    out.append(turned(24, (TOP + bottom) / 2, y_title, 14))
    return out


def marked_line(points, colour):
    """Returns a line with marks. Points are x, y and the radius of the mark."""
    path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y, _ in points)
    marks = [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius:.1f}" fill="{colour}" fill-opacity="0.85"/>'
             for x, y, radius in points]
    return [f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="1.5" stroke-opacity="0.6"/>', *marks]


def overlap(a, b):
    """Whether two boxes (left, top, right, bottom) overlap."""
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def inside(box, right):
    """Whether a box is inside the axes, up to `right`."""
    return LEFT < box[0] and box[2] < right and TOP < box[1] and box[3] < HEIGHT - BOTTOM
