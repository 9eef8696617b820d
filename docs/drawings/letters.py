"""letters.py FOLDER: writes script.svg and sans.svg, lines of letters from the Hershey fonts of Debian's
hershey-fonts-data, which are single lines as a drawing robot needs them. The SVG files keep the fonts'
acknowledgement."""
import os
import sys

FONTS = "/usr/share/hershey-fonts"
ACKNOWLEDGEMENT = """\
Made by docs/drawings/letters.py from the Hershey Fonts, which were originally created by Dr. A. V. Hershey while
working at the U. S. National Bureau of Standards. The format of the font data was originally created by James Hurt,
Cognition, Inc., 900 Technology Park Drive, Billerica, MA 01821 (mit-eddie!ci-dandelion!hurt)."""


def glyphs(name):
    """{character: (left, right, lines)}: a glyph is its number in five columns, the count of pairs in three, pairs."""
    with open(os.path.join(FONTS, name + ".jhf")) as file:
        text = file.read()
    result, at = {}, 0
    for code in range(32, 127):
        pairs = int(text[at + 5:at + 8])
        data, at = "", at + 8
        while len(data) < 2 * pairs:  # long glyphs are broken into lines
            if text[at] != "\n":
                data += text[at]
            at += 1
        at += 1
        numbers = [(ord(data[i]) - ord("R"), ord(data[i + 1]) - ord("R")) for i in range(0, len(data), 2)]
        lines = [[]]
        for i, pair in enumerate(numbers[1:], 1):
            if data[2 * i:2 * i + 2] == " R":
                lines.append([])
            else:
                lines[-1].append(pair)
        result[chr(code)] = (*numbers[0], [line for line in lines if len(line) > 1])
    return result


def drawing(font, rows):
    letters, paths, widest = glyphs(font), [], 0
    for row, text in enumerate(rows):
        x, y = 0, 44 * row
        for letter in text:
            left, right, lines = letters[letter]
            for line in lines:
                points = " L ".join(f"{x - left + px},{y + py}" for px, py in line)
                paths.append(f'    <path d="M {points}"/>\n')
            x += right - left
        widest = max(widest, x)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-4 -24 {widest + 8} {44 * len(rows) + 4}">\n'
            f'  <!-- {ACKNOWLEDGEMENT} -->\n'
            f'  <g fill="none" stroke="black" stroke-width="1">\n{"".join(paths)}  </g>\n</svg>\n')


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for name, font in (("script", "scripts"), ("sans", "futural")):
        with open(os.path.join(sys.argv[1], name + ".svg"), "w") as file:
            file.write(drawing(font, ["Drawn in", "the sand"]))


main()
