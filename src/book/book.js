// The search of every page, and the curve of an equation.
"use strict";

function found(asked) {
  const words = asked.toLowerCase().split(/\s+/).filter(Boolean);
  const score = (entry) => {
    const text = `${entry.id} ${entry.label} ${entry.title} ${entry.paper}`.toLowerCase();
    const numbers = entry.numbers.map((number) => number.toLowerCase());
    const exact = words.some((word) => numbers.includes(word.replace(".", "")));
    const all = words.every((word) => numbers.includes(word.replace(".", "")) || (/^[a-z]?\.?\d+$/.test(word) ? false : text.includes(word)));
    return all ? 1 + exact : 0;
  };
  return words.length ? ENTRIES.filter(score).sort((a, b) => score(b) - score(a)).slice(0, 40) : [];
}

document.addEventListener("DOMContentLoaded", () => {
  const input = document.querySelector(".search input");
  const list = document.querySelector(".search ul");
  input.addEventListener("input", () => {
    list.replaceChildren(...found(input.value).map((entry) => {
      const item = document.createElement("li");
      const link = item.appendChild(document.createElement("a"));
      link.href = `${entry.id}.html`;
      link.textContent = `${entry.label} · ${entry.paper} · ${entry.title}`;
      return item;
    }));
  });
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") list.querySelector("a")?.click();
    if (event.key === "Escape") list.replaceChildren();
  });
});

// Draws a result of a kernel against one of its arguments; the others have sliders.
function drawCurve(kernel, { arguments: given, results }) {
  const section = document.getElementById("curve");
  const [svg, form] = [section.querySelector("svg"), section.querySelector("form")];
  const values = given.map((argument) => (argument.start.length === 1 ? argument.start[0] : argument.start));
  const numbers = given.map((argument, k) => k).filter((k) => given[k].start.length === 1);
  const axes = ["x", "y", "z"];
  const outputs = results.flatMap((result, k) =>
    result.size === 1 ? [{ ...result, k, at: null, label: result.name }]
      : Array.from({ length: result.size }, (_, at) => ({ ...result, k, at, label: `${result.name} ${result.size === 3 ? axes[at] : axes[Math.floor(at / 3)] + axes[at % 3]}` })));
  const chosen = { x: numbers[numbers.length - 1], y: outputs.length > 1 ? Math.max(0, outputs.findIndex((o) => o.at === null)) : 0 };
  const short = (x) => (x === 0 ? "0" : Math.abs(x) >= 1e-3 && Math.abs(x) < 1e4 ? String(Number(x.toPrecision(4))) : x.toExponential(2));

  function value(x) {
    const all = values.slice();
    all[chosen.x] = x;
    const out = kernel(...all);
    const { k, at, name } = outputs[chosen.y];
    const part = results.length === 1 ? out : Object.values(out)[k];
    return at === null ? part : part[at];
  }

  function draw() {
    const { lo, hi } = given[chosen.x];
    const [left, right, top, bottom] = [70, 620, 15, 315];
    const points = Array.from({ length: 401 }, (_, k) => lo + ((hi - lo) * k) / 400).map((x) => [x, value(x)]);
    const heights = points.map(([, y]) => y).filter(Number.isFinite);
    let [low, high] = [Math.min(...heights, 0), Math.max(...heights, 0)];
    if (!(high > low)) [low, high] = [low - 1, low + 1];
    const across = (x) => left + ((x - lo) / (hi - lo)) * (right - left);
    const up = (y) => bottom - ((y - low) / (high - low)) * (bottom - top);
    let path = "", pen = "M";
    for (const [x, y] of points) {
      if (Number.isFinite(y)) { path += `${pen}${across(x).toFixed(2)} ${up(y).toFixed(2)}`; pen = "L"; } else pen = "M";
    }
    const tick = (k, n) => k / n;
    const unit = (quantity) => (quantity.unit === "1" ? "" : ` (${quantity.unit})`);
    const vertical = [0, 1, 2, 3, 4].map((k) => { const x = lo + (hi - lo) * tick(k, 4);
      return `<line class="axis" x1="${across(x)}" x2="${across(x)}" y1="${top}" y2="${bottom}"/><text x="${across(x)}" y="${bottom + 16}" text-anchor="middle">${short(x)}</text>`; });
    const level = [0, 1, 2, 3, 4].map((k) => { const y = low + (high - low) * tick(k, 4);
      return `<line class="axis" x1="${left}" x2="${right}" y1="${up(y)}" y2="${up(y)}"/><text x="${left - 6}" y="${up(y) + 4}" text-anchor="end">${short(y)}</text>`; });
    const x = given[chosen.x], y = outputs[chosen.y];
    svg.innerHTML = `${vertical.join("")}${level.join("")}<path class="line" d="${path}"/>
      <text x="${(left + right) / 2}" y="352" text-anchor="middle">${x.name}${unit(x)}</text><text x="${left}" y="11">${y.label}${unit(y)}</text>`;
  }

  function choice(label, names, now, choose) {
    const row = form.appendChild(document.createElement("label"));
    row.textContent = label;
    const select = form.appendChild(document.createElement("select"));
    names.forEach(([value, name]) => select.add(new Option(name, value, false, value === now)));
    select.addEventListener("input", () => { choose(Number(select.value)); build(); });
    form.appendChild(document.createElement("span"));
  }

  function build() {
    form.replaceChildren();
    if (outputs.length > 1) choice("result", outputs.map((output, k) => [k, output.label]), chosen.y, (k) => { chosen.y = k; });
    if (numbers.length > 1) choice("against", numbers.map((k) => [k, given[k].name]), chosen.x, (k) => { chosen.x = k; });
    for (const k of numbers.filter((k) => k !== chosen.x)) {
      const { name, unit, meaning, lo, hi } = given[k];
      const label = form.appendChild(document.createElement("label"));
      label.textContent = name;
      label.title = meaning;
      const slider = form.appendChild(document.createElement("input"));
      Object.assign(slider, { type: "range", min: 0, max: 1000, step: 1, value: Math.round(((values[k] - lo) / (hi - lo)) * 1000), title: meaning });
      slider.setAttribute("aria-label", `${name}: ${meaning}`);
      const shown = form.appendChild(document.createElement("output"));
      const show = () => { shown.textContent = `${short(values[k])}${unit === "1" ? "" : " " + unit}`; };
      slider.addEventListener("input", () => { values[k] = lo + ((hi - lo) * slider.value) / 1000; show(); draw(); });
      show();
    }
    draw();
  }
  build();
}
