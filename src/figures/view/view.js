// The spheres of a run in three dimensions, drawn from back to front on a plain canvas.
"use strict";
const scene = JSON.parse(document.getElementById("scene").textContent);
const host = document.getElementById("view");
const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const halves = (text) => new Uint16Array(bytes(text).buffer);
const words = (text) => new Uint32Array(bytes(text).buffer);
const floats = (text) => new Float32Array(bytes(text).buffer);
const middle = scene.from.map((from, k) => (from + scene.to[k]) / 2);
const half = scene.from.map((from, k) => (scene.to[k] - from) / 2);
// Beyond the centres that are to be seen: a radius, of which the largest may be a wall's.
const rim = Math.min(scene.radius, Math.hypot(...half) / 2 || scene.radius);
const reach = Math.hypot(...half) + rim;
const triangles = scene.meshes.map(words);

// --- Frames, decoded when they are first shown: coordinates in nm from the middle.
const decoded = [];
function frame(k) {
  if (decoded[k]) return decoded[k];
  const of = scene.frames[k];
  const unit = scene.span / 65535;
  return decoded[k] = {
    ...of,
    centres: Float32Array.from(halves(of.centres), (x, i) => scene.low[i % 3] + x * unit - middle[i % 3]),
    radii: Float32Array.from(halves(of.radii), (r) => r * scene.radius / 65535),
    colours: of.colours.map(bytes),
    pairs: words(of.pairs),
    corners: Float32Array.from(floats(of.corners), (x, i) => x - middle[i % 3]),
    triangles: triangles[of.mesh],
  };
}

// --- Controls.
const make = (tag, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};
const canvas = make("canvas", { tabIndex: 0 });
canvas.setAttribute("role", "img");
const play = make("button", { type: "button", textContent: "Play" });
const slider = make("input", { type: "range", min: 0, max: scene.frames.length - 1, step: 1, value: 0, className: "time", id: "time" });
slider.setAttribute("aria-label", "time");
const now = make("output");
const choice = make("select", { id: "quantity" }, ...scene.quantities.map((of, k) => make("option", { value: k, textContent: of.name })));
const links = make("input", { type: "checkbox", id: "pairs" });
const reset = make("button", { type: "button", textContent: "Reset view" });
const legend = make("div", { className: "legend" });
const several = scene.frames.length > 1;
host.append(
  canvas,
  ...(several ? [make("div", { className: "controls" }, play, slider, now)] : []),
  make("div", { className: "controls" },
    ...(scene.quantities.length > 1 ? [make("label", {}, "Colour", choice)] : []),
    ...(scene.frames.some((of) => of.pairs) ? [make("label", {}, links, scene.pairs)] : []),
    reset),
  legend);
legend.style.marginTop = ".6rem";

// --- Colours.
const SCALE = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];
const scaled = (part) => {
  const place = Math.min(part * 4, 3.9999), k = Math.floor(place), rest = place - k;
  return SCALE[k].map((from, c) => from + (SCALE[k + 1][c] - from) * rest);
};
const quantity = () => scene.quantities[Number(choice.value) || 0] ?? { names: [0], name: "" };
const colour = (byte) => (quantity().names ? scene.palette[byte % scene.palette.length] : scaled(byte / 255));
const text = (rgb) => `rgb(${rgb.map(Math.round).join(",")})`;

function number(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e5) return String(Number(value.toPrecision(2)).toExponential()).replace("e+", "e");
  return String(Number(value.toPrecision(3)));
}

function explain() {
  const of = quantity();
  legend.replaceChildren(make("span", { textContent: of.unit ? `${of.name}, ${of.unit}` : of.name }));
  if (of.names) {
    of.names.slice(0, 8).forEach((name) => {
      const dot = make("i");
      dot.style.background = text(scene.palette[((name % 8) + 8) % 8]);
      legend.append(make("span", { className: "key" }, dot, number(name)));
    });
    if (of.names.length > 8) legend.append(make("span", { textContent: "… in turn" }));
    return;
  }
  const bar = make("span", { className: "bar" });
  bar.style.background = `linear-gradient(to right, ${[0, 0.25, 0.5, 0.75, 1].map((part) => text(scaled(part))).join(", ")})`;
  const ends = [(of.below ? "≤ " : "") + number(of.low), (of.above ? "≥ " : "") + number(of.high)];
  legend.append(make("span", { className: "scale" }, ends[0], bar, ends[1]));
  if (of.log) legend.append("(logarithmic)");
}

// A ball of a colour, lit from the upper left; farther ones are closer to the colour of the background.
const DEPTHS = 6, BALL = 64;
let balls = new Map();
function ball(byte, depth) {
  const key = byte * DEPTHS + depth;
  if (balls.has(key)) return balls.get(key);
  const sprite = document.createElement("canvas");
  sprite.width = sprite.height = BALL;
  const pen = sprite.getContext("2d");
  const far = 0.45 * depth / (DEPTHS - 1);
  const shade = (light) => text(colour(byte).map((c, k) => {
    const lit = light > 1 ? c + (light - 1) * (255 - c) : c * light;
    return lit + far * (background[k] - lit);
  }));
  const glow = pen.createRadialGradient(0.36 * BALL, 0.34 * BALL, 0, BALL / 2, BALL / 2, BALL / 2);
  [[0, 1.55], [0.35, 1.1], [0.75, 0.8], [1, 0.42]].forEach(([stop, light]) => glow.addColorStop(stop, shade(light)));
  pen.fillStyle = glow;
  pen.beginPath();
  pen.arc(BALL / 2, BALL / 2, BALL / 2 - 0.5, 0, 2 * Math.PI);
  pen.fill();
  balls.set(key, sprite);
  return sprite;
}
let background = [246, 247, 248], ink = "#222";
function theme() {
  background = getComputedStyle(canvas).backgroundColor.match(/\d+/g).slice(0, 3).map(Number);
  ink = getComputedStyle(document.body).color;
  balls = new Map();
}

// --- The camera: rows are the directions of the screen, to the right, upwards, and towards the eye.
const turned = (m, a, b, angle) => {
  const [c, s] = [Math.cos(angle), Math.sin(angle)], out = m.map((row) => row.slice());
  for (let k = 0; k < 3; k++) {
    out[a][k] = c * m[a][k] - s * m[b][k];
    out[b][k] = s * m[a][k] + c * m[b][k];
  }
  return out;
};
const start = () => {
  const front = scene.upwards === 2 ? [[1, 0, 0], [0, 0, 1], [0, -1, 0]] : [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  return turned(turned(front, 0, 2, 0.35), 1, 2, 0.25);
};
// The place of the middle on the screen is shifted by zooming elsewhere, px.
let camera = start(), zoom = 1, shift = [0, 0];

// Pixels per nm with which all frames fit when they are first seen.
function fitting(wide, high) {
  const [across, up] = start().map((row) => row.reduce((sum, part, k) => sum + Math.abs(part) * half[k], rim));
  return 0.46 * Math.min(wide / across, high / up);
}

// --- Drawing.
let waiting = false;
function draw() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => {
    waiting = false;
    paint();
  });
}

function paint() {
  const ratio = window.devicePixelRatio || 1;
  const [wide, high] = [canvas.clientWidth, canvas.clientHeight];
  if (!wide) return;
  if (canvas.width !== Math.round(wide * ratio) || canvas.height !== Math.round(high * ratio)) {
    [canvas.width, canvas.height] = [Math.round(wide * ratio), Math.round(high * ratio)];
  }
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, wide, high);
  const of = frame(Number(slider.value));
  const scale = zoom * fitting(wide, high);
  const [right, up, near] = camera;
  const seen = (x, y, z) => [
    wide / 2 + shift[0] + scale * (right[0] * x + right[1] * y + right[2] * z),
    high / 2 + shift[1] - scale * (up[0] * x + up[1] * y + up[2] * z),
    near[0] * x + near[1] * y + near[2] * z,
  ];
  const count = of.radii.length;
  const [left, top, depth] = [new Float32Array(count), new Float32Array(count), new Float32Array(count)];
  for (let i = 0; i < count; i++) {
    [left[i], top[i], depth[i]] = seen(of.centres[3 * i], of.centres[3 * i + 1], of.centres[3 * i + 2]);
  }
  // Spheres, pairs and triangles by numbers that follow each other, sorted by depth.
  const withPairs = links.checked, pairs = withPairs ? of.pairs.length / 2 : 0, faces = of.triangles.length / 3;
  const depths = new Float32Array(count + pairs + faces);
  depths.set(depth);
  for (let k = 0; k < pairs; k++) depths[count + k] = (depth[of.pairs[2 * k]] + depth[of.pairs[2 * k + 1]]) / 2;
  const corners = [];
  for (let k = 0; k < of.corners.length; k += 3) corners.push(seen(of.corners[k], of.corners[k + 1], of.corners[k + 2]));
  for (let k = 0; k < faces; k++) {
    depths[count + pairs + k] = (corners[of.triangles[3 * k]][2] + corners[of.triangles[3 * k + 1]][2] + corners[of.triangles[3 * k + 2]][2]) / 3;
  }
  const order = Uint32Array.from(depths, (_, k) => k).sort((a, b) => depths[a] - depths[b]);
  const bytesOf = of.colours[Number(choice.value) || 0];
  const size = withPairs ? 0.5 : 1;
  outline(pen, of, seen);
  pen.lineCap = "round";
  for (const k of order) {
    if (k < count) {
      const r = Math.max(size * of.radii[k] * scale, 0.5);
      if (left[k] < -r || left[k] > wide + r || top[k] < -r || top[k] > high + r) continue;
      const far = Math.floor((0.5 - 0.5 * depth[k] / reach) * DEPTHS);
      pen.drawImage(ball(bytesOf ? bytesOf[k] : 0, Math.min(Math.max(far, 0), DEPTHS - 1)), left[k] - r, top[k] - r, 2 * r, 2 * r);
    } else if (k < count + pairs) {
      const [i, j] = [of.pairs[2 * (k - count)], of.pairs[2 * (k - count) + 1]];
      // A pair across a side of the box has no line through the box.
      const across = [0, 1, 2].some((axis) => scene.periodic[axis] && Math.abs(of.centres[3 * i + axis] - of.centres[3 * j + axis]) > of.sides[axis] / 2);
      if (across) continue;
      const wideness = Math.max(0.5 * Math.min(of.radii[i], of.radii[j]) * scale, 1);
      for (const [width, shade] of [[wideness, "#4b4f55"], [0.45 * wideness, "#8d939b"]]) {
        pen.lineWidth = width;
        pen.strokeStyle = shade;
        pen.beginPath();
        pen.moveTo(left[i], top[i]);
        pen.lineTo(left[j], top[j]);
        pen.stroke();
      }
    } else {
      const [a, b, c] = [0, 1, 2].map((n) => corners[of.triangles[3 * (k - count - pairs) + n]]);
      pen.fillStyle = pen.strokeStyle = ink;
      pen.beginPath();
      pen.moveTo(a[0], a[1]);
      pen.lineTo(b[0], b[1]);
      pen.lineTo(c[0], c[1]);
      pen.closePath();
      pen.globalAlpha = 0.1;
      pen.fill();
      pen.globalAlpha = 0.25;
      pen.lineWidth = 0.6;
      pen.stroke();
      pen.globalAlpha = 1;
    }
  }
  bar(pen, scale, high);
  const when = `${of.stage}, ${number(of.time)} ns`;
  now.textContent = when;
  slider.setAttribute("aria-valuetext", when);
  canvas.setAttribute("aria-label", `${count} spheres, ${when}`);
}

// The edges of a periodic box.
function outline(pen, of, seen) {
  if (!scene.periodic.some(Boolean)) return;
  const corner = (k) => seen(...[0, 1, 2].map((axis) => ((k >> axis) & 1 ? of.sides[axis] : 0) - middle[axis]));
  pen.strokeStyle = ink;
  pen.globalAlpha = 0.3;
  pen.lineWidth = 1;
  pen.beginPath();
  for (let k = 0; k < 8; k++) {
    for (let axis = 0; axis < 3; axis++) {
      if ((k >> axis) & 1) continue;
      const [a, b] = [corner(k), corner(k | (1 << axis))];
      pen.moveTo(a[0], a[1]);
      pen.lineTo(b[0], b[1]);
    }
  }
  pen.stroke();
  pen.globalAlpha = 1;
}

// A bar of a round length in nm.
function bar(pen, scale, high) {
  const most = 120 / scale, power = 10 ** Math.floor(Math.log10(most));
  const length = [5, 2, 1].map((digit) => digit * power).find((length) => length <= most);
  const [x, y] = [14, high - 14];
  pen.strokeStyle = pen.fillStyle = ink;
  pen.lineWidth = 2;
  pen.lineCap = "butt";
  pen.beginPath();
  pen.moveTo(x, y - 4);
  pen.lineTo(x, y);
  pen.lineTo(x + length * scale, y);
  pen.lineTo(x + length * scale, y - 4);
  pen.stroke();
  pen.font = "13px system-ui, sans-serif";
  pen.fillText(length >= 1000 ? `${number(length / 1000)} µm` : `${number(length)} nm`, x, y - 8);
}

// --- The pointer, the wheel and the keys.
const held = new Map();
canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  held.set(event.pointerId, [event.clientX, event.clientY]);
});
canvas.addEventListener("pointermove", (event) => {
  const before = held.get(event.pointerId);
  if (!before) return;
  const other = [...held].find(([id]) => id !== event.pointerId)?.[1];
  const after = [event.clientX, event.clientY];
  if (other) {
    // Two fingers zoom.
    const apart = (place) => Math.hypot(place[0] - other[0], place[1] - other[1]);
    magnify(apart(after) / Math.max(apart(before), 1));
  } else {
    turn((after[0] - before[0]) * 0.008, (after[1] - before[1]) * 0.008);
  }
  held.set(event.pointerId, after);
});
["pointerup", "pointercancel"].forEach((name) => canvas.addEventListener(name, (event) => held.delete(event.pointerId)));
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  const at = [event.offsetX - canvas.clientWidth / 2, event.offsetY - canvas.clientHeight / 2];
  magnify(Math.exp(-0.0015 * event.deltaY * (event.deltaMode ? 20 : 1)), at);
}, { passive: false });
function turn(across, down) {
  camera = turned(turned(camera, 0, 2, -across), 1, 2, down);
  draw();
}
function magnify(factor, at = [0, 0]) {
  const before = zoom;
  zoom = Math.min(Math.max(zoom * factor, 0.2), 200);
  // What is below the pointer stays there.
  shift = shift.map((x, k) => at[k] + (x - at[k]) * zoom / before);
  draw();
}
canvas.addEventListener("keydown", (event) => {
  const angle = 0.1;
  const act = {
    ArrowLeft: () => turn(-angle, 0), ArrowRight: () => turn(angle, 0), ArrowUp: () => turn(0, -angle), ArrowDown: () => turn(0, angle),
    "+": () => magnify(1.15), "=": () => magnify(1.15), "-": () => magnify(1 / 1.15), "0": restore,
  }[event.key];
  if (!act) return;
  event.preventDefault();
  act();
});
function restore() {
  [camera, zoom, shift] = [start(), 1, [0, 0]];
  draw();
}

// --- Time.
let timer = 0;
function stop() {
  clearInterval(timer);
  timer = 0;
  play.textContent = "Play";
}
play.addEventListener("click", () => {
  if (timer) return stop();
  if (slider.value === slider.max) slider.value = 0;
  play.textContent = "Pause";
  timer = setInterval(() => {
    slider.value = Number(slider.value) + 1;
    if (slider.value === slider.max) stop();
    draw();
  }, 120);
});
slider.addEventListener("input", () => {
  stop();
  draw();
});
choice.addEventListener("change", () => {
  balls = new Map();
  explain();
  draw();
});
links.addEventListener("change", draw);
reset.addEventListener("click", restore);
new ResizeObserver(draw).observe(canvas);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  theme();
  draw();
});
addEventListener("beforeprint", () => {
  theme();
  paint();
});
theme();
explain();
draw();
