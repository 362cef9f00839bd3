// Plots are read off with the pointer, or with the arrow keys: the point nearest to the pointer is marked and named.
"use strict";
for (const svg of document.querySelectorAll("figure.plot svg")) {
  const { x: across, y: up, curves } = JSON.parse(svg.querySelector("metadata").textContent);
  const place = (axis, value) => axis.scale[0] + axis.scale[1] * (axis.log ? Math.log10(value) : value);
  const points = curves.flatMap(({ label, points }) =>
    points.map(([x, y]) => ({ label, x, y, left: place(across, x), top: place(up, y) })));
  if (!points.length) continue;

  const mark = document.createElementNS("http://www.w3.org/2000/svg", "circle");
  mark.setAttribute("r", 5);
  mark.setAttribute("style", "fill: none; stroke: #111; stroke-width: 2; pointer-events: none");
  mark.style.display = "none";
  svg.append(mark);
  const reading = document.createElement("div");
  reading.className = "reading";
  reading.setAttribute("role", "status");
  reading.hidden = true;
  svg.parentNode.append(reading);

  // "friction force [pN]" at 3 is "friction force 3 pN".
  const named = (axis, value) => {
    const [, name, unit] = axis.label.match(/^(.*?)(?: \[(.*)\])?$/);
    return `${name} ${number(value)}${unit ? " " + unit : ""}`;
  };
  let at = 0;
  const show = (k) => {
    at = k;
    const { label, x, y, left, top } = points[k];
    mark.setAttribute("cx", left);
    mark.setAttribute("cy", top);
    mark.style.display = "";
    reading.replaceChildren(...[label, named(across, x), named(up, y)].filter(Boolean).map((text) => {
      const line = document.createElement("div");
      line.textContent = text;
      return line;
    }));
    reading.hidden = false;
    const box = svg.getBoundingClientRect(), scale = box.width / svg.viewBox.baseVal.width;
    const right = left * scale > box.width / 2;
    const wide = reading.offsetWidth, beside = right ? left * scale - 12 - wide : left * scale + 12;
    reading.style.left = `${Math.max(0, Math.min(beside, box.width - wide))}px`;
    reading.style.top = `${Math.max(0, top * scale - 20)}px`;
  };
  const hide = () => {
    mark.style.display = "none";
    reading.hidden = true;
  };
  const nearest = (event) => {
    const box = svg.getBoundingClientRect(), scale = svg.viewBox.baseVal.width / box.width;
    const [left, top] = [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
    let best = 0, least = Infinity;
    points.forEach((point, k) => {
      const distance = (point.left - left) ** 2 + (point.top - top) ** 2;
      if (distance < least) [best, least] = [k, distance];
    });
    show(best);
  };
  svg.addEventListener("pointermove", nearest);
  svg.addEventListener("pointerdown", nearest);
  svg.addEventListener("pointerleave", hide);
  svg.addEventListener("blur", hide);
  svg.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1, Home: -points.length, End: points.length }[event.key];
    if (!step) return;
    event.preventDefault();
    show(Math.min(Math.max(at + step, 0), points.length - 1));
  });
}

// A number with four digits, as a person writes it.
function number(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e5) return String(Number(value.toPrecision(4)).toExponential()).replace("e+", "e");
  return String(Number(value.toPrecision(4)));
}
