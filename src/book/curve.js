// Curves of kernels, with sliders.
"use strict";

const SVG = { left: 96, right: 596, top: 26, bottom: 298 };
const short = (x) => (x === 0 ? "0" : Math.abs(x) >= 1e-3 && Math.abs(x) < 1e4 ? String(Number(x.toPrecision(4))) : x.toExponential(2));
const unitOf = (unit) => (unit === "1" ? "" : ` (${unit})`);

// Draws a path through points with numbered axes; what is not finite is left out.
function plot(svg, points, horizontal, vertical) {
  const { left, right, top, bottom } = SVG;
  const range = (values) => {
    const [low, high] = [Math.min(...values), Math.max(...values)];
    return high > low ? [low, high] : [low - 1, high + 1];
  };
  const [from, to] = range(points.map(([x]) => x));
  const [low, high] = range([0, ...points.map(([, y]) => y).filter(Number.isFinite)]);
  const across = (x) => left + ((x - from) / (to - from)) * (right - left);
  const up = (y) => bottom - ((y - low) / (high - low)) * (bottom - top);
  let path = "", pen = "M";
  for (const [x, y] of points) {
    if (Number.isFinite(y)) { path += `${pen}${across(x).toFixed(2)} ${up(y).toFixed(2)}`; pen = "L"; } else pen = "M";
  }
  // Zero, where rounding leaves something else.
  const ticks = (low, high) => [0, 0.25, 0.5, 0.75, 1].map((part) => low + (high - low) * part).map((x) => (Math.abs(x) < 1e-9 * (high - low) ? 0 : x));
  const columns = ticks(from, to).map((x, k) =>
    `<line class="axis" x1="${across(x)}" x2="${across(x)}" y1="${top}" y2="${bottom}"/><text class="${k % 2 ? "between" : ""}" x="${across(x)}" y="${bottom + 24}" text-anchor="middle">${short(x)}</text>`);
  const rows = ticks(low, high).map((y) =>
    `<line class="axis" x1="${left}" x2="${right}" y1="${up(y)}" y2="${up(y)}"/><text x="${left - 6}" y="${up(y) + 4}" text-anchor="end">${short(y)}</text>`);
  const zero = low < 0 && high > 0 ? `<line class="zero" x1="${left}" x2="${right}" y1="${up(0)}" y2="${up(0)}"/>` : "";
  svg.innerHTML = `${columns.join("")}${rows.join("")}${zero}<path class="line" d="${path}"/>
    <text x="${(left + right) / 2}" y="${bottom + 52}" text-anchor="middle">${horizontal}</text><text x="${left}" y="${top - 9}">${vertical}</text>`;
}

// A slider with its value; `change` hears of every new one.
function addSlider(form, { name, unit, meaning, lo, hi }, value, change) {
  const label = form.appendChild(document.createElement("label"));
  label.textContent = name;
  label.title = meaning;
  const slider = form.appendChild(document.createElement("input"));
  Object.assign(slider, { type: "range", min: 0, max: 1000, step: 1, value: Math.round(((value - lo) / (hi - lo)) * 1000), title: meaning });
  slider.setAttribute("aria-label", `${name}: ${meaning}`);
  const shown = form.appendChild(document.createElement("output"));
  const show = (x) => { shown.textContent = `${short(x)}${unit === "1" ? "" : " " + unit}`; };
  slider.addEventListener("input", () => { const x = lo + ((hi - lo) * slider.value) / 1000; show(x); change(x); });
  show(value);
}

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

  function value(x) {
    const all = values.slice();
    all[chosen.x] = x;
    const out = kernel(...all);
    const { k, at } = outputs[chosen.y];
    const part = results.length === 1 ? out : Object.values(out)[k];
    return at === null ? part : part[at];
  }

  function draw() {
    const [x, y] = [given[chosen.x], outputs[chosen.y]];
    const points = Array.from({ length: 401 }, (_, k) => x.lo + ((x.hi - x.lo) * k) / 400).map((x) => [x, value(x)]);
    plot(svg, points, x.name + unitOf(x.unit), y.label + unitOf(y.unit));
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
    for (const k of numbers.filter((k) => k !== chosen.x)) addSlider(form, given[k], values[k], (x) => { values[k] = x; draw(); });
    draw();
  }
  build();
}

// Draws the forces of a contact law. `constants`, if any, makes the argument of that name from radii and masses.
function drawLaw(forces, constants, { id, gaps, gap, path, parameters, arguments: given, results }) {
  const section = document.getElementById(id);
  const [normal, tangential] = section.querySelectorAll("svg");
  const [ofNormal, ofTangential] = section.querySelectorAll("form");
  const values = Object.fromEntries(parameters.map(({ name, start }) => [name, start]));
  const drive = { gap, velocity: 1 };
  const zero = ({ size }) => (size === 1 ? 0 : Array(size).fill(0));
  const next = (name) => results.findIndex((result) => result.name === `${name}_next` || result.name === name);
  const springs = given.filter(({ name }) => next(name) >= 0);
  const relaxed = () => Object.fromEntries(springs.map((spring) => [spring.name, zero(spring)]));

  // Forces on i along the normal and across it, and the springs after the step; j rests at the origin.
  function step(gap, velocity, stretched, dt) {
    const { r_i, r_j, m_i, m_j } = values;
    const [at, moves] = [[r_i + r_j + gap, 0, 0], [0, velocity, 0]];
    const known = { x: at, x_i: at, v: moves, v_i: moves, dt, constants: constants && constants(r_i, r_j, m_i, m_j), ...values, ...stretched };
    const out = Object.values(forces(...given.map((argument) => known[argument.name] ?? zero(argument))));
    const force = out[results.findIndex((result) => result.name === "force")];
    return [force[0], force[1], Object.fromEntries(springs.map(({ name }) => [name, out[next(name)]]))];
  }

  function draw() {
    const apart = Array.from({ length: 401 }, (_, k) => gaps[0] + ((gaps[1] - gaps[0]) * k) / 400);
    plot(normal, apart.map((gap) => [gap, step(gap, 0, relaxed(), 1e-15)[0]]), "gap (m)", "normal force (N)");
    const [steps, points] = [400, []];
    const dt = path / steps / drive.velocity;
    let [at, stretched] = [0, relaxed()];
    for (const [way, count] of [[1, steps], [-1, 2 * steps], [1, 2 * steps]]) {
      for (let k = 0; k < count; k++) {
        let across;
        [, across, stretched] = step(drive.gap, way * drive.velocity, stretched, dt);
        at += way * path / steps;
        points.push([at, across]);
      }
    }
    plot(tangential, points, "displacement (m)", "tangential force (N)");
  }

  for (const parameter of parameters) addSlider(ofNormal, parameter, parameter.start, (x) => { values[parameter.name] = x; draw(); });
  const gapSlider = { name: "gap", unit: "m", meaning: "gap of the surfaces, negative for an overlap", lo: gaps[0], hi: gaps[1] };
  const speed = { name: "velocity", unit: "m/s", meaning: "velocity of the shear", lo: 0.05, hi: 10 };
  addSlider(ofTangential, gapSlider, gap, (x) => { drive.gap = x; draw(); });
  addSlider(ofTangential, speed, drive.velocity, (x) => { drive.velocity = x; draw(); });
  draw();
}
