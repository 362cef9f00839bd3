#!/usr/bin/env python3
"""Looks at report pages with a browser: python3 tests/browser/check.py PAGE...

No error appears on the console, nothing is fetched, nothing is cut at the width of a telephone, the slider moves the spheres, the wheel, the
pointer and the keys change the view, plots are read off, and the dark page is dark. Needs Chromium and the Python package `playwright`.
"""

import os
import shutil
import sys

from playwright.sync_api import sync_playwright

WIDTHS = [1280, 390]
OF_CANVAS = """() => {
    const canvas = document.querySelector("#view canvas");
    return Array.from(canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data);
}"""
# Elements that reach beyond the window, unless a box around them scrolls.
CUT = """() => Array.from(document.querySelectorAll("body *")).filter((element) => {
    const box = element.getBoundingClientRect();
    const inside = element.closest(".scroll, details:not([open]) > :not(summary)");
    return box.width > 0 && !(inside && inside !== element) && (box.right > innerWidth + 0.5 || box.left < -0.5);
}).map((element) => element.tagName + "." + element.className)"""


def expect(holds, what):
    if not holds:
        raise AssertionError(what)


def settled(page):
    """Waits until what was asked for has been drawn."""
    page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")


def different(before, after):
    """Number of pixels that differ."""
    return sum(before[k : k + 4] != after[k : k + 4] for k in range(0, len(before), 4))


def view(page, changes):
    """Each change makes another picture of the spheres."""
    for name, change in changes:
        before = page.evaluate(OF_CANVAS)
        change()
        settled(page)
        count = different(before, page.evaluate(OF_CANVAS))
        expect(count > 50, f"{name} changes {count} pixels of the view")


def spheres(page):
    """The slider, the pointer, the wheel, the keys and the colours of the view."""
    canvas, slider = page.locator("#view canvas"), page.locator("#time")
    canvas.scroll_into_view_if_needed()
    blank = different(page.evaluate(OF_CANVAS), [0] * len(page.evaluate(OF_CANVAS)))
    expect(blank > 200, "spheres are drawn")

    def drag():
        box = canvas.bounding_box()
        page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        page.mouse.down()
        page.mouse.move(box["x"] + box["width"] / 2 + 60, box["y"] + box["height"] / 2 + 25)
        page.mouse.up()

    changes = [("dragging", drag), ("the wheel", lambda: page.mouse.wheel(0, -300)), ("a key", lambda: canvas.press("ArrowLeft"))]
    if slider.count():
        last = slider.get_attribute("max")
        move = f"(slider) => {{ slider.value = {last}; slider.dispatchEvent(new Event('input')); }}"
        changes.insert(0, ("the slider", lambda: slider.evaluate(move)))
    colours = page.locator("#quantity option")
    if colours.count() > 1:
        changes.append(("another colour", lambda: page.select_option("#quantity", index=colours.count() - 1)))
    view(page, changes)


def plots(page):
    """Every plot names the point below the pointer."""
    figures = page.locator("figure.plot")
    for k in range(figures.count()):
        figure = figures.nth(k)
        figure.scroll_into_view_if_needed()
        box = figure.locator("svg").bounding_box()
        page.mouse.move(box["x"] + 0.6 * box["width"], box["y"] + 0.5 * box["height"])
        reading = figure.locator(".reading")
        expect(reading.is_visible() and any(c.isdigit() for c in reading.inner_text()), f"plot {k + 1} is read off")
        own = reading.bounding_box()
        expect(own["x"] >= 0 and own["x"] + own["width"] <= page.viewport_size["width"], f"the reading of plot {k + 1} is cut")
    return figures.count()


def check(browser, path):
    address, found = "file://" + os.path.abspath(path), 0
    for width in WIDTHS:
        page = browser.new_page(viewport={"width": width, "height": 850})
        problems, fetched = [], []
        page.on("console", lambda message: problems.append(message.text) if message.type == "error" else None)
        page.on("pageerror", lambda error: problems.append(str(error)))
        page.on("request", lambda request: fetched.append(request.url) if request.url.startswith("http") else None)
        page.goto(address)
        settled(page)
        wide = page.evaluate("document.documentElement.scrollWidth")
        expect(wide <= width, f"the page is {wide} px wide in a window of {width} px")
        cut = page.evaluate(CUT)
        expect(not cut, f"cut at {width} px: {cut[:5]}")
        if page.locator("#view canvas").count():
            spheres(page)
        found = plots(page)
        page.emulate_media(media="print")
        expect(not page.locator("button").first.is_visible() if page.locator("button").count() else True, "controls are printed")
        expect(not problems, f"console: {problems}")
        expect(not fetched, f"fetched: {fetched}")
        page.close()
    page = browser.new_page(color_scheme="dark")
    page.goto(address)
    ground = page.evaluate("getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)")
    expect(sum(ground[:3]) < 150, f"the dark page has the colour {ground}")
    page.close()
    print(f"{path}: sound at {WIDTHS} px, {found} plots")


def main():
    chromium = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        for path in sys.argv[1:]:
            check(browser, path)
        browser.close()


if __name__ == "__main__":
    main()
