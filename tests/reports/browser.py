"""A page of the viewer in headless Chromium, driven by real clicks, drags, touches and keys.

Importing it ends the program with exit code 77 and a message where Chromium, its driver or Selenium are missing
(Debian: chromium, chromium-driver, python3-selenium).
"""
import os
import shutil
import sys
import time

DRIVER = "/usr/bin/chromedriver"


def skip(reason):
    print("skipped: " + reason)
    sys.exit(77)


try:
    from selenium import webdriver
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.actions import interaction
    from selenium.webdriver.common.actions.action_builder import ActionBuilder
    from selenium.webdriver.common.actions.pointer_input import PointerInput
    from selenium.webdriver.common.by import By
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.support.ui import Select
except ImportError:
    skip("there is no Selenium (Debian: python3-selenium)")
if not os.path.exists(DRIVER) or not shutil.which("chromium"):
    skip("there is no Chromium (Debian: chromium, chromium-driver)")


class Page:
    """A page in a browser of its own; points of the drawing are in metres."""

    def __init__(self, page, folder, phone=False, dark=False):
        options = webdriver.ChromeOptions()
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                         "--hide-scrollbars", "--window-size=1280,800"):
            options.add_argument(argument)
        options.add_experimental_option("prefs", {"download.default_directory": folder})
        if phone:
            metrics = {"width": 390, "height": 844, "pixelRatio": 2, "touch": True}
            options.add_experimental_option("mobileEmulation", {"deviceMetrics": metrics})
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(DRIVER), options=options)
        self.touch = phone
        if not phone:
            self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                        {"width": 1280, "height": 800, "deviceScaleFactor": 1, "mobile": False})
        if dark:
            scheme = {"name": "prefers-color-scheme", "value": "dark"}
            self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [scheme]})
        self.driver.get("file://" + page)

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def click(self, selector):
        self.find(selector).click()

    def press(self, text):
        """The button of the card with this text."""
        self.driver.find_element(By.XPATH, f"//section[@id='card']//button[text()='{text}']").click()

    def tool(self, name):
        self.click(f"[data-tool={name}]")

    def pixel(self, x, y):
        script = """const box = document.getElementById("overlay").getBoundingClientRect();
                    const [px, py] = app.sight.toScreen(arguments[0], arguments[1]);
                    return [Math.round(box.left + px), Math.round(box.top + py)];"""
        return self.driver.execute_script(script, x, y)

    def drag(self, *points):
        """Down at the first point, up at the last; a tap if there is one only."""
        kind = interaction.POINTER_TOUCH if self.touch else interaction.POINTER_MOUSE
        action = ActionBuilder(self.driver, mouse=PointerInput(kind, "finger" if self.touch else "mouse"), duration=20)
        pixels = [self.pixel(*point) for point in points]
        action.pointer_action.move_to_location(*pixels[0])
        action.pointer_action.pointer_down()
        for (ax, ay), (bx, by) in zip(pixels, pixels[1:]):
            action.pointer_action.move_to_location((ax + bx) // 2, (ay + by) // 2)
            action.pointer_action.move_to_location(bx, by)
        action.pointer_action.pointer_up()
        action.perform()

    def tap(self, x, y):
        self.drag((x, y))

    def hover(self, x, y):
        action = ActionBuilder(self.driver)
        action.pointer_action.move_to_location(*self.pixel(x, y))
        action.perform()

    def keys(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def text(self, selector):
        return self.find(selector).text

    def choose(self, label, option):
        select = self.driver.find_element(By.XPATH, f"//section[@id='card']//label[starts-with(., '{label}')]/select")
        Select(select).select_by_visible_text(option)

    def edits(self):
        items = self.driver.find_elements(By.CSS_SELECTOR, "#edits li > span")
        return [item.get_attribute("textContent") for item in items]

    def saved(self):
        self.click("#save")
        text = self.find("#saved-text").get_attribute("value")
        self.click("#close")
        return text

    def screenshot(self, folder, name):
        if folder:
            painted = "return new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"
            self.driver.execute_script(painted)
            self.driver.get_screenshot_as_file(os.path.join(folder, name + ".png"))

    def finish(self):
        log = self.driver.get_log("browser")
        self.driver.quit()
        assert not log, log


def expect(found, wanted):
    assert found == wanted, f"\nfound  {found}\nwanted {wanted}"


def expect_in(part, text):
    assert part in text, f"'{part}' is not in '{text}'"


def wait_for(what, condition):
    for _ in range(100):
        if condition():
            return
        time.sleep(0.05)
    raise AssertionError("waited in vain: " + what)


def near(found, wanted, slack):
    assert len(found) == len(wanted) and all(abs(f - w) <= slack for f, w in zip(found, wanted)), (found, wanted)


def middle(page, number):
    """Of the connection with that number, from 1."""
    script = "const at = pointAlong(connections[arguments[0] - 1].flat, 0.5); return [at.x, at.y];"
    return page.driver.execute_script(script, number)
