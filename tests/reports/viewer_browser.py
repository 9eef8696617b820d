#!/usr/bin/env python3
"""The viewer in headless Chromium, by real clicks, drags, touches and keys, on a desktop and on a phone.

usage: viewer_browser.py VIEWER_SAMPLE [FOLDER FOR SCREENSHOTS]

Exit code 77, with a message, where Chromium, its driver or Selenium are missing (browser.py). Each step fails with the
name of what it looked for; at its end the browser's log must be empty.
"""
import json
import os
import subprocess
import sys
import tempfile
import time

from browser import ActionBuilder, ActionChains, Page, expect, expect_in, middle, near, wait_for
from selenium.webdriver.common.keys import Keys


def look_and_play(page, shots):
    expect_in("8 elements", page.text("#summary"))
    expect("see remarks" in page.text("#summary"), False)
    expect(page.find("#remarks").is_displayed(), False)
    expect(page.find("#undo").is_enabled(), False)
    page.hover(9.0, 1.964)  # on the wave
    wait_for("the hovered stroke", lambda: "wave" in page.text("#card"))
    expect_in("Driven 1st of 8", page.text("#card"))
    page.tap(15, 9)
    expect_in("crown", page.text("#card"))
    expect_in("Filled area", page.text("#card"))
    for view in ("connections", "realistic", "outline"):
        page.click(f"[data-view={view}]")
        expect(page.find(f"[data-view={view}]").get_attribute("aria-pressed"), "true")
        page.screenshot(shots, view)
    page.click("#layers [name=trace1]")
    page.click("#play")
    wait_for("time passes", lambda: page.text("#clock") > "0:01" and page.text("#clock") < "4:00")
    page.screenshot(shots, "playing")
    page.click("#play")
    stopped = page.text("#clock")
    time.sleep(0.1)
    expect(page.text("#clock"), stopped)
    page.find("#time").send_keys(Keys.END)
    page.click("#overlay")
    page.keys("2")
    expect(page.find("[data-view=realistic]").get_attribute("aria-pressed"), "true")
    page.keys("1", "+", "+")
    before = page.driver.execute_script("return app.sight.scale")
    page.drag((7, 7.5), (8, 7))
    expect(page.driver.execute_script("return app.sight.scale"), before)
    wheel = ActionBuilder(page.driver)
    wheel.wheel_action.scroll(*page.pixel(10, 7.5), 0, -200)
    wheel.perform()
    wait_for("the wheel zooms", lambda: page.driver.execute_script("return app.sight.scale") > before)
    page.keys("0")


def edit_everything(page, shots):
    page.tool("start")
    page.drag((1, 0.6), (3, 0.5))
    page.tool("connect")
    page.tap(1.5, 1.8)           # the begin of the wave
    expect_in("wave, begin", page.text("#card"))
    page.tap(4.5, 8)             # the end of the letter A
    for x, y in ((12.1, 5.2), (2.1, 9.7), (12.1, 5.2), (2, 6.8)):  # the sun twice: in and out
        page.tap(x, y)
    page.tool("select")
    page.tap(*middle(page, 3))
    expect_in("Connection 3 of", page.text("#card"))
    page.press("Delete")
    page.screenshot(shots, "deleted")
    page.tool("cut")
    page.drag((8.5, 10.2), (8.5, 14))  # from the hole of the O: it stays in one part
    expect_in("does not divide", page.text("#card"))
    page.drag((15, 7), (15, 14))
    page.tool("fill")
    page.tap(13, 9)
    page.choose("Fill", "Spiral")
    page.drag((17, 8.5), (17.5, 9.0))
    page.choose("Outline", "Yes")
    page.screenshot(shots, "fill")
    page.tool("curve")
    page.tap(*middle(page, 2))
    expect_in("Connect sun <&>, vertex 0 – cross-2, begin", page.edits())
    handle = page.driver.execute_script("return app.tool.edit().points[0]")
    page.drag(handle, (16.0, 4.5))
    expect_in("In place of: Connect sun <&>, vertex 0 – cross-2, begin.", page.text("#card"))  # or the sun had three
    page.screenshot(shots, "curve")


def check_saved(text):
    """Everything exactly, but for points that a pixel of the screen decides."""
    edits = json.loads(text)
    expect(list(edits), ["oxturn_edits", "drawing_sha256", "start", "cuts", "fills", "connections", "curves"])
    expect((edits["oxturn_edits"], edits["drawing_sha256"]), (1, "5a3e"))
    near(edits["start"], [3, 0.5], 0.1)
    expect([cut["element"] for cut in edits["cuts"]], ["crown"])
    near(edits["cuts"][0]["line"][0] + edits["cuts"][0]["line"][1], [15, 7, 15, 14], 0.1)
    left, right = edits["fills"]
    expect({k: v for k, v in left.items() if k != "at"}, {"element": "crown", "fill": "spiral"})
    angle = right.pop("angle_deg")
    assert 40 <= angle <= 50, angle
    expect({k: v for k, v in right.items() if k != "at"}, {"element": "crown", "fill": "zigzag", "outline": True})
    near(left["at"] + right["at"], [13, 9, 17, 8.5], 0.1)
    expect(edits["connections"], [
        {"action": "enforce", "from": {"element": "wave", "vertex": 0}, "to": {"element": "letter-a", "vertex": -1}},
        {"action": "enforce", "from": {"element": "bar-of-a", "vertex": 0}, "to": {"element": "sun <&>", "vertex": 0}},
        {"action": "delete", "from": {"element": "sun <&>", "vertex": 0}, "to": {"element": "cross-1", "vertex": 0}}])
    curve = edits["curves"][0]
    expect((curve["from"], curve["to"]), ({"element": "wave", "vertex": -1}, {"element": "sun <&>", "vertex": 0}))
    expect((curve["kind"], len(curve["points"])), ("bezier", 2))
    near(curve["points"][0], [16.0, 4.5], 0.1)


def undo_and_delete(page):
    count = len(page.edits())
    page.click("#edits li:first-child button")
    expect(len(page.edits()), count - 1)
    page.click("#overlay")
    page.keys(Keys.ESCAPE)
    ActionChains(page.driver).key_down(Keys.CONTROL).send_keys("z").key_up(Keys.CONTROL).perform()
    expect(len(page.edits()), count)
    while page.find("#undo").is_enabled():
        page.click("#undo")
    expect(page.edits(), [])


def node(page, element, vertex):
    script = "const at = nodeOf({element: arguments[0], vertex: arguments[1]}); return [at.x, at.y];"
    return page.driver.execute_script(script, element, vertex)


def desktop(html, folder, shots):
    page = Page(html, folder)
    look_and_play(page, shots)
    edit_everything(page, shots)
    text = page.saved()
    check_saved(text)
    download = os.path.join(folder, "sample.edits.json")
    wait_for("the download", lambda: os.path.exists(download))
    with open(download, encoding="utf-8") as file:
        expect(file.read(), text)
    undo_and_delete(page)
    page.finish()
    return download


def pinch(page, begin, end):
    """Two fingers left and right of the middle, first so far from it and then so far, pixels."""
    x, y = page.pixel(10, 7.5)
    for kind, reach in (("touchStart", begin), ("touchMove", (begin + end) // 2), ("touchMove", end)):
        points = [{"x": x - reach, "y": y, "id": 0}, {"x": x + reach, "y": y, "id": 1}]
        page.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    page.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})


def phone(html, folder, shots):
    page = Page(html, folder, phone=True)
    width = page.driver.execute_script("return document.documentElement.scrollWidth")
    expect(width, 390)
    small = page.driver.execute_script("""return [...document.querySelectorAll("button, select")]
        .filter(b => b.offsetParent && (b.offsetHeight < 44 || b.offsetWidth < 44)).map(b => b.textContent)""")
    expect(small, [])
    page.screenshot(shots, "phone")
    before = page.driver.execute_script("return app.sight.scale")
    pinch(page, 40, 120)
    wait_for("two fingers zoom", lambda: page.driver.execute_script("return app.sight.scale") > 2 * before)
    page.click("#zoom-fit")
    page.tap(15, 9)
    expect_in("crown", page.text("#card"))
    page.screenshot(shots, "phone-card")
    page.press("Change fill")
    page.choose("Fill", "Contour")
    page.tool("connect")
    page.tap(1.5, 1.8)
    page.tap(4.5, 8)
    page.click("#details")
    page.screenshot(shots, "phone-details")
    expect(page.edits(), ["Fill crown: contour", "Connect wave, begin – letter-a, end"])
    page.click("#details")
    page.tool("curve")
    page.tap(*middle(page, 2))
    page.drag(page.driver.execute_script("return app.tool.edit().points[1]"), (13, 3.4))
    page.screenshot(shots, "phone-curve")
    saved = json.loads(page.saved())
    near(saved["curves"][0]["points"][1], [13, 3.4], 0.2)
    taps_that_do_nothing_say_so(page)
    page.finish()


def taps_that_do_nothing_say_so(page):
    """And what contradicts a new edit goes, or the file would be refused."""
    page.tool("cut")
    page.tap(15, 9)
    expect_in("A tap does not cut", page.text("#card"))
    page.drag((15, 9.5), (15.2, 8))  # both ends within the crown
    expect_in("Cut: crown", page.text("#card"))
    page.tool("connect")
    page.tap(*node(page, "wave", -1))
    expect_in("From wave, end", page.text("#card"))
    page.tap(18, 0.5)
    expect_in("Nothing is here", page.text("#card"))
    expect_in("From wave, end", page.text("#card"))
    page.tap(*node(page, "cross-1", 0))
    expect_in("In place of: Curve wave, end", page.text("#card"))
    expect([edit for edit in page.edits() if "Curve" in edit], [])


def with_edits(sample, edits, folder, shots):
    """A page made with edits shows them, and saves the same bytes."""
    html = os.path.join(folder, "again.html")
    subprocess.run([sample, html, edits], check=True)
    page = Page(html, folder, dark=True)
    expect(len(page.edits()), 8)
    expect(page.text("#edits-note"), "The path obeys these edits.")
    expect_in("see remarks", page.text("#summary"))
    expect(page.text("#remarks"), "area 'crown' is half filled")
    page.screenshot(shots, "dark")
    page.click("[data-view=connections]")
    page.screenshot(shots, "dark-connections")
    with open(edits, encoding="utf-8") as file:
        expect(page.saved(), file.read())
    page.finish()


def without_drawing(sample, folder, shots):
    """Any planner's path: to look at, without tools."""
    html = os.path.join(folder, "plain.html")
    subprocess.run([sample, html, "plain"], check=True)
    page = Page(html, folder)
    expect([page.find(part).is_displayed() for part in ("#tools", "#save", "#play")], [False, False, True])
    page.tap(3, 9.7)
    expect_in("Leg 12 of 18", page.text("#card"))
    page.screenshot(shots, "plain")
    page.finish()


def main():
    sample, shots = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else None
    with tempfile.TemporaryDirectory() as folder:
        html = os.path.join(folder, "sample.html")
        subprocess.run([sample, html], check=True)
        edits = desktop(html, folder, shots)
        phone(html, folder, shots)
        with_edits(sample, edits, folder, shots)
        without_drawing(sample, folder, shots)
    print("the viewer works on a desktop and on a phone")


main()
