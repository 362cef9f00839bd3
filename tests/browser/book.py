#!/usr/bin/env python3
"""Looks at the book with a browser: python3 tests/browser/book.py BOOK

Every link leads to a page, no page has an error on the console or fetches from a network, the search finds an equation by its number in each paper and every
table, a slider and a choice move the curve, every slider of a contact law moves its forces, every law and every erratum says how it is established, every claim how it is measured, nothing is cut at the
width of a telephone, paper has no controls, and the dark page is dark. Needs Chromium and the Python package `playwright`.
"""

import json
import pathlib
import re
import shutil
import sys

from playwright.sync_api import sync_playwright

CURVE = "() => document.querySelector('#curve svg').innerHTML"
# Elements that reach beyond the window, unless a box around them scrolls.
CUT = """() => Array.from(document.querySelectorAll("body *")).filter((element) => {
    const box = element.getBoundingClientRect();
    const inside = element.closest(".formula, .wide, p, pre, details:not([open]) > :not(summary)");
    return box.width > 0 && !(inside && inside !== element) && (box.right > innerWidth + 0.5 || box.left < -0.5);
}).map((element) => element.tagName + "." + element.className)"""


def expect(holds, what):
    if not holds:
        raise AssertionError(what)


def links(folder):
    """No link leads nowhere."""
    pages = sorted(folder.glob("*.html"))
    for page in pages:
        text = page.read_text()
        for target in re.findall(r'(?:href|src)="([^"]*)"', text):
            name, _, place = target.partition("#")
            expect("://" not in target, f"{page.name} needs a network for {target}")
            if target.startswith("data:"):
                continue
            expect(not name or (folder / name).exists(), f"{page.name} links to {name}, which does not exist")
            expect(not place or f'id="{place}"' in ((folder / name) if name else page).read_text(), f"{page.name} links to {target}")
    for entry in json.loads((folder / "entries.js").read_text().removeprefix("const ENTRIES = ").rstrip(";\n")):
        name, _, place = entry["page"].partition("#")
        expect((folder / name).exists() and (not place or f'id="{place}"' in (folder / name).read_text()), f"the search leads to {entry['page']}")
    return pages


def found(page, asked):
    page.fill(".search input", asked)
    return page.eval_on_selector_all(".search li a", "all => all.map((a) => a.getAttribute('href'))")


def search(page, folder):
    page.goto((folder / "index.html").as_uri())
    for asked, expected in [
        ("14", {"titania-14.html", "wear-14.html", "soot-14.html"}),
        ("A.17", {"wear-A17.html"}),
        ("table 5", {"tables.html#wear-2"}),
    ]:
        all = found(page, asked)
        expect(expected <= set(all), f"{asked} finds {all}")
    page.fill(".search input", "normal force")
    page.keyboard.press("Enter")
    page.wait_for_url("**/*-*.html*")


def curve(page, path):
    page.goto(path.as_uri())
    before = page.evaluate(CURVE)
    expect(re.search(r'class="line" d="M[^"]{400}', before), f"{path.name} has no curve")
    sliders = page.locator("#curve input[type=range]")
    for slider in sliders.all():
        move(slider)
    after = page.evaluate(CURVE)
    expect(after != before, f"no slider of {path.name} moves the curve")
    page.locator("#curve select").last.select_option(index=0)
    expect(page.evaluate(CURVE) != after, f"the choice of {path.name} does not move the curve")


def move(slider):
    slider.evaluate("(slider) => { slider.value = Number(slider.value) > 500 ? 200 : 800; slider.dispatchEvent(new Event('input')); }")


def forces(page, folder):
    """Each slider of a contact law moves one of its two curves, but for those that act on spins or on moving spheres alone, or not on every law."""
    page.goto((folder / "laws.html").as_uri())
    laws = page.locator("section.law")
    expect(laws.count() > 3, "laws are drawn")
    for k in range(laws.count()):
        law = laws.nth(k)
        name, drawn = law.get_attribute("id"), lambda: [svg.inner_html() for svg in law.locator("svg").all()]
        for svg in drawn():
            expect(re.search(r'class="line" d="M[^"]{400}', svg) and "NaN" not in svg, f"{name} has no curve")
        for slider in law.locator("input[type=range]").all():
            before, label = drawn(), slider.get_attribute("aria-label")
            move(slider)
            still = re.search(r"^m_|rolling|torsion|radius|damping|velocity", label) or (name.endswith("neck") and label.startswith("gap"))
            expect(still or drawn() != before, f"the slider {label} of {name} moves nothing")


def statements(page, folder):
    """Each law of an equation says how it is established; each erratum has its effect and its proof."""
    for path in folder.glob("*-*.html"):
        if path.name.startswith("claims-"):
            continue
        text = path.read_text()
        status = re.findall(r'class="status">([^<]*)<', text)
        expect(len(status) > 1 and all(re.search("proved|sampled|by construction|checked", one) for one in status), f"{path.name}: {status}")
        expect(re.search(r"<h2>Rounding</h2><p>(At most \S+ ULP: (proved|measured)|No bound)", text), f"{path.name} says nothing of rounding")
    page.goto((folder / "errata.html").as_uri())
    rows = [page.locator("section.finding", has_text=word).count() for word in ["effect", "proof"]]
    expect(min(rows) > 20, f"errata with effect, with proof: {rows}")
    shown = page.locator("section.finding").first
    page.emulate_media(media="print")
    expect(shown.is_visible() and not page.locator("header").is_visible(), "paper has the errata and no search")
    page.emulate_media(media="screen")


def claims(page, folder):
    """Each claim has a command that measures it, or a reason why nothing does; its page leads to what was measured."""
    page.goto((folder / "claims.html").as_uri())
    rows = page.eval_on_selector_all("main tbody tr", "rows => rows.map((row) => Array.from(row.cells, (cell) => cell.innerText))")
    expect(len(rows) > 50, f"{len(rows)} claims")
    for row in rows:
        expect(row[4].startswith("veridem reproduce") or row[5].startswith("never measured"), f"nothing measures {row}")
    page.click("main a[href^='index.html']")
    page.wait_for_url("**/index.html#claims")


def main(folder):
    pages = links(folder)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        errors = []
        for width, scheme in [(1280, "light"), (390, "dark")]:
            page = browser.new_page(viewport={"width": width, "height": 900}, color_scheme=scheme)
            page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
            page.on("pageerror", lambda error: errors.append(str(error)))
            page.on("request", lambda request: expect(request.url.startswith(("file:", "data:")), f"fetches {request.url}"))
            for path in pages:
                page.goto(path.as_uri())
                expect(not errors, f"{path.name}: {errors}")
                cut = page.evaluate(CUT)
                expect(not cut, f"{path.name} is cut at {width}: {cut[:3]}")
            dark = page.evaluate("() => getComputedStyle(document.body).backgroundColor")
            expect((dark == "rgb(22, 22, 22)") == (scheme == "dark"), f"{scheme} is {dark}")
            search(page, folder)
            for name in ["wear-3", "titania-8", "titania-14"]:
                curve(page, folder / f"{name}.html")
            forces(page, folder)
            statements(page, folder)
            claims(page, folder)
            page.close()
        browser.close()
    print(f"{len(pages)} pages of the book are as they should be")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
