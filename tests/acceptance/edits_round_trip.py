#!/usr/bin/env python3
"""A drawing edited by hand and planned again: oxturn draw --viewer, clicks in headless Chromium, oxturn draw --edits.

usage: edits_round_trip.py OXTURN [FOLDER FOR SCREENSHOTS]

The page that is edited is the one that the planner's path made. Whether the edits are obeyed is judged by the path that
is written at the end. Exit code 77 where there is no browser.
"""
import json
import math
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "reports"))
from browser import Page, expect, expect_in, middle, near  # noqa: E402

# Six short strokes far apart, and a leaf; 20 pixels to a metre. The points at the corners fix the scale.
SVG = """<svg xmlns="http://www.w3.org/2000/svg" width="392" height="292">
<g fill="none" stroke="#000" stroke-width="3">
<path id="a" d="M20 20h60"/><path id="b" d="M140 20h60"/><path id="c" d="M260 20h60"/>
<path id="d" d="M20 270h60"/><path id="e" d="M140 270h60"/><path id="f" d="M260 270h60"/>
</g><rect id="leaf" x="60" y="90" width="240" height="120" fill="#484"/>
<path id="g" d="M0 0h4" fill="none" stroke="#000"/><path id="h" d="M388 292h4" fill="none" stroke="#000"/></svg>
"""


def draw(oxturn, folder, *options):
    done = subprocess.run([oxturn, "draw", "pond.svg", *options], cwd=folder, capture_output=True, text=True,
                          check=False)
    assert done.returncode == 0, done.stderr
    return done


def legs_of(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return [(f["properties"]["tool"], f["geometry"]["coordinates"]) for f in json.load(file)["features"]]


def ends_of(page, element):
    """Both ends of a stroke, metres."""
    script = """const stroke = data.drawing.strokes.find(s => s.element === arguments[0]);
                return [stroke.points.slice(0, 2), stroke.points.slice(-2)];"""
    return page.driver.execute_script(script, element)


def same(a, b, slack=0.02):
    return math.dist(a, b) <= slack


def joined(legs, a, b):
    """A transit leads from one point to the other, in either direction."""
    return any(not tool and (same(p[0], a) and same(p[-1], b) or same(p[0], b) and same(p[-1], a)) for tool, p in legs)


def distance_to(legs, point):
    return min(math.dist(q, point) for tool, p in legs if not tool for q in p)


def edit(page, shots, before):
    """Edits of each kind. What they demand."""
    wanted = {"start": (10.0, 3.0)}
    page.tool("start")
    page.tap(*wanted["start"])
    wanted["enforced"] = (ends_of(page, "a")[0], ends_of(page, "f")[1])
    page.tool("connect")
    for end in wanted["enforced"]:
        page.tap(*end)
    expect_in("Connect a, begin", page.edits()[-1])
    # A connection between two other strokes, as it was driven.
    free = [ends_of(page, name) for name in "bcde"]
    number, wanted["deleted"] = next((k + 1, (p[0], p[-1])) for k, p in enumerate(q for tool, q in before if not tool)
                                     if any(same(p[0], end) for ends in free for end in ends) and
                                     any(same(p[-1], end) for ends in free for end in ends))
    page.tool("select")
    page.tap(*middle(page, connection_at(page, *wanted["deleted"]) or number))
    page.press("Delete")
    page.tool("cut")
    page.drag((9.2, 4), (9.2, 11))
    page.tool("fill")
    page.tap(6, 7.5)
    page.choose("Fill", "Zigzag")
    page.drag((6, 6.5), (6, 8.5))  # lanes up and down
    page.tap(12, 7.5)
    page.choose("Fill", "Contour")
    page.screenshot(shots, "round-trip-edited")
    return wanted


def connection_at(page, a, b):
    script = """const near = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]) < 0.05;
                return connections.findIndex(c => { const f = c.flat, n = f.length;
                    return near([f[0], f[1]], arguments[0]) && near([f[n - 2], f[n - 1]], arguments[1]); }) + 1;"""
    return page.driver.execute_script(script, a, b)


def obeyed(legs, wanted):
    expect(joined(legs, *wanted["enforced"]), True)
    expect(joined(legs, *wanted["deleted"]), False)
    assert any(same(p[0], wanted["start"], 0.1) or same(p[-1], wanted["start"], 0.1) for tool, p in legs[:2]), legs[0]


def lanes_are_upright(legs, cut):
    """Metres of work left of the cut that go up or down, and others."""
    up = across = 0
    for tool, points in legs:
        for p, q in zip(points, points[1:]):
            if tool and max(p[0], q[0]) < cut and 4 < min(p[1], q[1]) and max(p[1], q[1]) < 11:
                d = math.dist(p, q)
                up, across = (up + d, across) if abs(p[0] - q[0]) < 0.2 * d else (up, across + d)
    assert up > 2 * across, (up, across)


def drag_a_curve(html, folder, shots, wanted, edits):
    """On the page that was planned with the first edits: a curve on the enforced connection."""
    page = Page(html, folder)
    expect_in("obeys these edits", page.find("#edits-note").get_attribute("textContent"))
    a, b = wanted["enforced"]
    page.tool("curve")
    page.tap(*middle(page, connection_at(page, a, b) or connection_at(page, b, a)))
    handle = page.driver.execute_script("return app.tool.edit().points[0]")
    page.drag(handle, (4.0, 2.5))
    page.screenshot(shots, "round-trip-curve")
    text = page.saved()
    page.finish()
    with open(edits, "w", encoding="utf-8") as file:
        file.write(text)
    return json.loads(text)


def main():
    oxturn, shots = os.path.abspath(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else None
    with tempfile.TemporaryDirectory() as folder:
        file = lambda name: os.path.join(folder, name)
        with open(file("pond.svg"), "w", encoding="utf-8") as out:
            out.write(SVG)
        draw(oxturn, folder, "--viewer", "first.html", "-o", "first.geojson")
        page = Page(file("first.html"), folder)
        page.screenshot(shots, "round-trip-first")
        wanted = edit(page, shots, legs_of(folder, "first.geojson"))
        with open(file("one.json"), "w", encoding="utf-8") as out:
            out.write(page.saved())
        page.finish()
        draw(oxturn, folder, "--edits", "one.json", "--viewer", "second.html", "-o", "second.geojson")
        legs = legs_of(folder, "second.geojson")
        obeyed(legs, wanted)
        lanes_are_upright(legs, 9.2)

        curve = drag_a_curve(file("second.html"), folder, shots, wanted, file("two.json"))["curves"][0]
        near(curve["points"][0], [4.0, 2.5], 0.1)
        draw(oxturn, folder, "--edits", "two.json", "--viewer", "third.html", "-o", "third.geojson")
        third = legs_of(folder, "third.geojson")
        obeyed(third, wanted)
        for point in curve["points"] if curve["kind"] == "spiro" else []:
            assert distance_to(third, point) < 0.1, point
        course = lambda path: next(p for tool, p in path if not tool and joined([(tool, p)], *wanted["enforced"]))
        assert max(min(math.dist(p, q) for q in course(legs)) for p in course(third)) > 0.3, "the curve was not obeyed"
        phone = Page(file("third.html"), folder, phone=True)
        phone.screenshot(shots, "round-trip-phone")
        with open(file("two.json"), encoding="utf-8") as saved:
            expect(phone.saved(), saved.read())
        phone.finish()
    print("edits of every kind are obeyed")


main()
