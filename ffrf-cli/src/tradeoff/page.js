"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const NS = "http://www.w3.org/2000/svg";
// Okabe and Ito: colours that people who see colours differently can tell apart
const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000", "#7f7f7f"];
const AXES = ["modes", "fidelity", "scalar", "integrator"];
const COSTS = {
  operations: "operations of compiled code per simulated second",
  time: "processor time of this machine / s per simulated second",
  operations_per_step: "operations of compiled code per step",
};
const SHORT = { operations: "operations per second", time: "processor time", operations_per_step: "operations per step" };
const values = {};
for (const axis of AXES) {
  values[axis] = [...new Set(data.rows.map((row) => row[axis]))];
  if (axis === "modes") values[axis].sort((a, b) => a - b);
}
const state = { hidden: {}, cost: "operations", quantity: -1, colour: "integrator", sort: "cost", down: false, marked: null };
for (const axis of AXES) state.hidden[axis] = new Set();

const html = (name, attributes = {}, ...children) => make(document.createElement(name), attributes, children);
const svg = (name, attributes = {}, ...children) => make(document.createElementNS(NS, name), attributes, children);
function make(node, attributes, children) {
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) node.addEventListener(key.slice(2), value);
    else node.setAttribute(key, value);
  }
  for (const child of children) node.append(child);
  return node;
}
const short = (x) => (x === 0 ? "0" : Math.abs(x) >= 0.01 && Math.abs(x) < 10000 ? String(Number(x.toPrecision(3))) : x.toExponential(2));
const colourOf = (row) => COLOURS[values[state.colour].indexOf(row[state.colour]) % COLOURS.length];
const errorOf = (row) => (state.quantity < 0 ? Math.max(...row.found.errors) : row.found.errors[state.quantity]);
const costOf = (row) => row.found[state.cost];
const visible = (row) => AXES.every((axis) => !state.hidden[axis].has(row[axis]));
const lineOf = (row) => AXES.map((axis) => row[axis]).join("|");

function front(rows) {
  const sorted = [...rows].sort((a, b) => costOf(a) - costOf(b) || errorOf(a) - errorOf(b));
  let best = Infinity;
  return sorted.filter((row) => {
    const better = errorOf(row) < best;
    if (better) best = errorOf(row);
    return better;
  });
}

function controls() {
  const box = document.getElementById("controls");
  box.replaceChildren();
  const choice = (title, entries, current, change) =>
    html("fieldset", {}, html("legend", {}, title),
      html("select", { onchange: (event) => { change(event.target.value); show(); } },
        ...entries.map(([value, text]) => {
          const option = html("option", { value }, text);
          option.selected = String(value) === String(current);
          return option;
        })));
  box.append(choice("Cost", Object.entries(SHORT), state.cost, (value) => (state.cost = value)));
  box.append(choice("Error in", [[-1, "the worst of all"], ...data.channels.map((c, k) => [k, c.name])], state.quantity, (value) => (state.quantity = Number(value))));
  box.append(choice("Colour by", AXES.map((axis) => [axis, axis]), state.colour, (value) => (state.colour = value)));
  for (const axis of AXES) {
    const set = html("fieldset", {}, html("legend", {}, axis));
    values[axis].forEach((value, k) => {
      const input = html("input", { type: "checkbox", onchange: (event) => { event.target.checked ? state.hidden[axis].delete(value) : state.hidden[axis].add(value); show(); } });
      input.checked = !state.hidden[axis].has(value);
      const label = html("label", {}, input);
      if (axis === state.colour) label.append(html("span", { class: "swatch", style: `background:${COLOURS[k % COLOURS.length]}` }));
      label.append(String(value));
      set.append(label);
    });
    box.append(set);
  }
}

function ticks(low, high) {
  const first = Math.ceil(low - 1e-9), last = Math.floor(high + 1e-9), every = Math.max(1, Math.ceil((last - first) / 9));
  const found = [];
  for (let k = first; k <= last; k += every) found.push(k);
  return found;
}
const SUPER = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };
const power = (k) => "10" + [...String(k)].map((c) => SUPER[c]).join("");

function picture(rows, best) {
  const box = document.getElementById("picture");
  box.replaceChildren(html("h2", {}, "Work and precision"));
  const points = rows.filter((row) => costOf(row) > 0 && errorOf(row) > 0);
  if (points.length === 0) {
    box.append(html("p", { class: "hint" }, "Nothing to show: no run with these choices has reached its end."));
    return;
  }
  const W = 980, H = 560, L = 70, R = 18, T = 12, B = 52;
  const own = state.quantity < 0 ? data.own_error : data.channels[state.quantity].own_error;
  const xs = points.map((row) => Math.log10(costOf(row)));
  const ys = points.map((row) => Math.log10(errorOf(row)));
  const x0 = Math.min(...xs) - 0.15, x1 = Math.max(...xs) + 0.15;
  // a reference that is far more exact than all is told in words: its line would leave no height to the points
  const least = Math.min(...ys), line = own > 0 ? Math.log10(own) : -Infinity, is_near = line > least - 2;
  const y0 = Math.min(least, is_near ? line : Infinity) - 0.3, y1 = Math.max(...ys) + 0.3;
  const X = (v) => L + ((v - x0) / (x1 - x0)) * (W - L - R), Y = (v) => H - B - ((v - y0) / (y1 - y0)) * (H - T - B);
  const canvas = svg("svg", { viewBox: `0 0 ${W} ${H}`, role: "img", "aria-label": "error against cost" });
  for (const k of ticks(x0, x1)) {
    canvas.append(svg("line", { x1: X(k), x2: X(k), y1: T, y2: H - B, stroke: "#e8ebef" }));
    canvas.append(svg("text", { x: X(k), y: H - B + 18, "text-anchor": "middle", "font-size": 13 }, power(k)));
  }
  for (const k of ticks(y0, y1)) {
    canvas.append(svg("line", { x1: L, x2: W - R, y1: Y(k), y2: Y(k), stroke: "#e8ebef" }));
    canvas.append(svg("text", { x: L - 8, y: Y(k) + 4, "text-anchor": "end", "font-size": 13 }, power(k)));
  }
  canvas.append(svg("rect", { x: L, y: T, width: W - L - R, height: H - T - B, fill: "none", stroke: "#b9c0c9" }));
  canvas.append(svg("text", { x: (L + W - R) / 2, y: H - 10, "text-anchor": "middle", "font-size": 14 }, COSTS[state.cost]));
  canvas.append(svg("text", { x: 16, y: (T + H - B) / 2, "text-anchor": "middle", "font-size": 14, transform: `rotate(-90 16 ${(T + H - B) / 2})` }, "error over the scale of the quantity"));
  if (own > 0 && !is_near) {
    canvas.append(svg("text", { x: W - R - 6, y: H - B - 6, "text-anchor": "end", "font-size": 12 }, `error of the reference itself: ${own.toExponential(1)}`));
  } else if (own > 0 && line > y0) {
    canvas.append(svg("line", { x1: L, x2: W - R, y1: Y(Math.log10(own)), y2: Y(Math.log10(own)), stroke: "#888", "stroke-dasharray": "5 4" }));
    canvas.append(svg("text", { x: W - R - 6, y: Y(Math.log10(own)) - 6, "text-anchor": "end", "font-size": 12 }, "error of the reference itself"));
  }
  const lines = new Map();
  for (const row of points) lines.set(lineOf(row), [...(lines.get(lineOf(row)) || []), row]);
  for (const line of lines.values()) {
    line.sort((a, b) => a.step - b.step);
    const path = line.map((row, k) => `${k ? "L" : "M"}${X(Math.log10(costOf(row))).toFixed(1)} ${Y(Math.log10(errorOf(row))).toFixed(1)}`).join("");
    canvas.append(svg("path", { d: path, fill: "none", stroke: colourOf(line[0]), "stroke-opacity": 0.28 }));
  }
  let stairs = "";
  best.filter((row) => errorOf(row) > 0).forEach((row, k) => {
    const x = X(Math.log10(costOf(row))), y = Y(Math.log10(errorOf(row)));
    stairs += k ? `H${x}V${y}` : `M${x} ${y}`;
  });
  canvas.append(svg("path", { d: stairs, fill: "none", stroke: "#22262b", "stroke-width": 1.6 }));
  const tip = html("div", { class: "tip" });
  for (const row of points) {
    const x = X(Math.log10(costOf(row))), y = Y(Math.log10(errorOf(row)));
    const filled = row.scalar !== "f32";
    const circle = svg("circle", {
      cx: x, cy: y, r: best.includes(row) ? 5.5 : 4, fill: filled ? colourOf(row) : "#fff", "fill-opacity": filled ? 0.85 : 1,
      stroke: best.includes(row) ? "#22262b" : colourOf(row), "stroke-width": best.includes(row) ? 1.6 : 1.4,
      onmouseenter: () => {
        tip.replaceChildren(html("b", {}, `${row.modes} modes, ${row.fidelity}, ${row.scalar}`), `${row.integrator}, step ${short(row.step)} s`, html("br"),
          `error ${short(errorOf(row))}`, html("br"), `${short(row.found.operations)} operations and ${short(row.found.time)} s per simulated second`);
        tip.style.display = "block";
        const scale = canvas.clientWidth / W, left = canvas.offsetLeft + x * scale, top = canvas.offsetTop + y * scale;
        tip.style.left = `${left + 14 + tip.offsetWidth > box.clientWidth ? left - tip.offsetWidth - 14 : left + 14}px`;
        tip.style.top = `${top + 10}px`;
        mark(row);
      },
      onmouseleave: () => { tip.style.display = "none"; mark(null); },
    });
    circle.append(svg("title", {}, `${row.modes} modes, ${row.fidelity}, ${row.scalar}, ${row.integrator}, step ${short(row.step)} s`));
    canvas.append(circle);
  }
  box.append(canvas, tip, html("p", { class: "hint" }, "Filled: f64, hollow: f32. Thin lines join runs that differ in the step alone; the dark staircase is the Pareto front of what is shown: nothing is both cheaper and more exact. Time and operations are per simulated second; instructions and stack are estimates."));
}

function mark(row) {
  for (const line of document.querySelectorAll("tr.marked")) line.classList.remove("marked");
  if (row) for (const line of document.querySelectorAll(`tr[data-row="${data.rows.indexOf(row)}"]`)) line.classList.add("marked");
}

const COLUMNS = [
  ["modes", "modes", (row) => row.modes, (row) => row.modes],
  ["fidelity", "fidelity", (row) => row.fidelity, (row) => row.fidelity, "word"],
  ["scalar", "scalar", (row) => row.scalar, (row) => row.scalar, "word"],
  ["integrator", "integrator", (row) => row.integrator, (row) => row.integrator, "word"],
  ["step", "step / s", (row) => row.step, (row) => short(row.step)],
  ["error", "error", (row) => errorOf(row), (row) => short(errorOf(row))],
  ["time", "time / s", (row) => row.found.time, (row) => short(row.found.time)],
  ["cost", "operations / s", (row) => row.found.operations, (row) => short(row.found.operations)],
  ["step_cost", "operations / step", (row) => row.found.operations_per_step, (row) => short(row.found.operations_per_step)],
  ["instructions", "instructions / step", (row) => row.found.instructions_per_step, (row) => short(row.found.instructions_per_step)],
  ["data", "data / B", (row) => row.found.data, (row) => row.found.data],
  ["stack", "stack / B", (row) => row.found.stack, (row) => row.found.stack],
];

function table(rows, best) {
  const head = html("tr", {}, ...COLUMNS.map(([key, title, , , kind]) => {
    const classes = [kind || "", state.sort === key ? "sorted" : "", state.sort === key && state.down ? "down" : ""].join(" ");
    return html("th", { class: classes, onclick: () => { state.down = state.sort === key && !state.down; state.sort = key; show(); } }, title);
  }));
  return html("div", { class: "scroll" }, html("table", {}, html("thead", {}, head), html("tbody", {}, ...rows.map((row) =>
    html("tr", { class: best.includes(row) ? "front" : "", "data-row": data.rows.indexOf(row) }, ...COLUMNS.map(([, , , text, kind]) => html("td", { class: kind || "" }, String(text(row)))))))));
}

function show() {
  controls();
  const shown = data.rows.filter(visible), rows = shown.filter((row) => row.found), best = front(rows);
  picture(rows, best);
  document.getElementById("best").replaceChildren(html("h2", {}, "The Pareto front"), table(best, []));
  const value = COLUMNS.find(([key]) => key === state.sort)[2];
  const sorted = [...rows].sort((a, b) => (value(a) < value(b) ? -1 : value(a) > value(b) ? 1 : 0) * (state.down ? -1 : 1));
  const failed = shown.filter((row) => row.failure !== undefined);
  const box = document.getElementById("table");
  box.replaceChildren(html("h2", {}, `All ${rows.length} runs that reached their end`), table(sorted, best));
  if (failed.length > 0) {
    box.append(html("h2", { style: "margin-top:16px" }, `${failed.length} that did not`), html("div", { class: "scroll" }, html("table", {}, html("tbody", {}, ...failed.map((row) =>
      html("tr", {}, ...[row.modes, row.fidelity, row.scalar, row.integrator, short(row.step)].map((text) => html("td", { class: "word" }, String(text))), html("td", { class: "reason" }, row.failure)))))));
  }
}
show();
