"""Lines over a common height axis as SVG text, in panels side by side. Same lines, same bytes."""
import dataclasses
import html

PANEL_WIDTH, PANEL_HEIGHT, GAP = 430, 400, 24
LEFT, TOP, BOTTOM, RIGHT = 64, 46, 70, 12  # outside the panels
INK, MUTED, GRID = "#1c232d", "#5a6470", "#e3e6e9"


@dataclasses.dataclass
class Line:
    points: list        # [(x, y)]; an x is the number of a tick, from 0
    colour: str
    width: float = 1
    opacity: float = 1
    name: str = ""      # in the panel's key; without one it has no marks either


@dataclasses.dataclass
class Panel:
    title: str
    lines: list         # later ones are drawn over earlier ones
    ticks: list         # [(text, ...)]: what is written below each, line by line


def text(x, y, content, anchor="middle", colour=MUTED, more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}"{more}>{html.escape(content)}</text>\n'


class Frame:
    """Of one panel: from its coordinates to those of the picture."""

    def __init__(self, left, ticks, low, high):
        self.left, self.ticks, self.low, self.high = left, ticks, low, high

    def x(self, tick):
        return self.left + PANEL_WIDTH * (tick + 0.5) / self.ticks

    def y(self, value):
        return TOP + PANEL_HEIGHT * (self.high - value) / (self.high - self.low)


def line_of(frame, line):
    spots = [(frame.x(x), frame.y(y)) for x, y in line.points]
    result = (f'<polyline fill="none" stroke="{line.colour}" stroke-width="{line.width}" stroke-linejoin="round" '
              f'opacity="{line.opacity}" points="' + " ".join(f"{x:.1f},{y:.1f}" for x, y in spots) + '"/>\n')
    if line.name:
        result += "".join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{line.colour}"/>\n' for x, y in spots)
    return result


def key(frame, lines):
    result, right = "", frame.left + PANEL_WIDTH - 14
    for k, line in enumerate(lines):
        y = TOP + 22 + 20 * k
        result += (f'<path d="M{right - 24} {y - 4}h24" stroke="{line.colour}" stroke-width="{line.width}"/>\n'
                   + text(right - 32, y, line.name, "end", INK))
    return result


def panel_of(frame, panel, values, first):
    result = text(frame.left + PANEL_WIDTH / 2, TOP - 14, panel.title, colour=INK, more=' font-weight="600"')
    for value, name in values:
        y = frame.y(value)
        result += f'<path d="M{frame.left} {y:.1f}h{PANEL_WIDTH}" stroke="{GRID}"/>\n'
        result += text(frame.left - 8, y + 4, name, "end") if first else ""
    for k, names in enumerate(panel.ticks):
        result += "".join(text(frame.x(k), TOP + PANEL_HEIGHT + 20 + 17 * i, name) for i, name in enumerate(names))
    return (result + "".join(line_of(frame, line) for line in panel.lines)
            + key(frame, [line for line in panel.lines if line.name]))


def chart(title, panels, values, below):
    """`values`: [(height, text)] of the height axis, ascending, from end to end. `below`: a caption."""
    width = LEFT + len(panels) * PANEL_WIDTH + (len(panels) - 1) * GAP + RIGHT
    height = TOP + PANEL_HEIGHT + BOTTOM
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
             f'height="{height}" font-family="sans-serif" font-size="13">\n<title>{html.escape(title)}</title>\n'
             f'<rect width="{width}" height="{height}" fill="#fff"/>\n']
    for k, panel in enumerate(panels):
        frame = Frame(LEFT + k * (PANEL_WIDTH + GAP), len(panel.ticks), values[0][0], values[-1][0])
        parts.append(panel_of(frame, panel, values, k == 0))
    middle = TOP + PANEL_HEIGHT / 2
    parts.append(text(18, middle, title, more=f' transform="rotate(-90 18 {middle})"'))
    parts.append(text(LEFT + (width - LEFT - RIGHT) / 2, height - 10, below))
    return "".join(parts) + "</svg>\n"
