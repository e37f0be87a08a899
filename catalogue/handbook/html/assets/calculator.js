"use strict";
(() => {

// a number with a unit of each kind, and what of the SI it is
const PREFIX = { G: 1e9, M: 1e6, k: 1e3, "": 1, c: 1e-2, m: 1e-3, "µ": 1e-6, u: 1e-6, n: 1e-9 };
const SCALES = { m: "kmcµun", Pa: "GMk", N: "MkmµunG", "N/m": "GMkmµu", s: "mµun", "m/s": "cmµun", "Pa s": "GMkm" };
const LINE_LOADS = { "N/mm": 1e3, "J/m²": 1, "J/m^2": 1, "mJ/m²": 1e-3, "mJ/m^2": 1e-3 };
const ANGLES = { rad: 1, deg: Math.PI / 180, "°": Math.PI / 180 };
const SHOWN = ["G", "M", "k", "", "m", "µ", "n"];
const DIGITS = 5;

function units(unit) {
  if (unit === "rad") return ANGLES;
  if (unit === "1") return { "": 1 };
  const prefixes = ["", ...(SCALES[unit] ?? "")];
  const found = Object.fromEntries(prefixes.map((prefix) => [prefix + unit, PREFIX[prefix]]));
  return unit === "N/m" ? { ...found, ...LINE_LOADS } : found;
}

// the value of a field in the SI; an error says what is wrong with it
function valueOf(field, text) {
  if (field.name === "A" && text.includes(",")) return text.split(",").map((one) => valueOf(field, one));
  const [, number, rest] = text.trim().match(/^([-+]?[\d.,]*(?:[eE][-+]?\d+)?)\s*(.*)$/);
  const value = number === "" ? NaN : Number(number.replace(",", "."));
  if (Number.isNaN(value)) throw new Error(`${text.trim() || "nothing"} is no number; write ${example(field)}`);
  const known = units(field.unit);
  const half = field.unit === "rad" && rest.match(/^(.*?)\s*half(?:-angle)?$/);
  const unit = half ? half[1] || "deg" : rest.replace("μ", "µ");
  if (unit && !(unit in known)) {
    throw new Error(`${unit} is no unit of ${field.name}; use ${Object.keys(known).filter(Boolean).join(", ") || "no unit"}`);
  }
  const size = value * (unit ? known[unit] : 1);
  const found = half ? Math.PI / 2 - size : size;
  const low = field.low ?? -Infinity, high = field.high ?? Infinity;
  const at = (end, edge) => field.closed.includes(edge) && found === end;
  const inside = (found > low || at(low, "low")) && (found < high || at(high, "high"));
  if (!inside) throw new Error(`${text.trim()} is outside ${field.rule}`);
  return found;
}

function example(field) {
  return field.unit === "rad" ? "20 deg or 70 half" : shown(field.value || 1, field.unit);
}

// four digits and more with a prefix of the unit
function shown(value, unit) {
  if (typeof value === "string") return value;
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "outside its range" : value > 0 ? "∞" : "−∞";
  if (unit === "rad") return `${Number((value / ANGLES.deg).toPrecision(DIGITS))}°`;
  const known = unit === "N/m" ? { "": 1, k: 1e3, M: 1e6, m: 1e-3 } : Object.fromEntries(SHOWN.map((one) => [one, PREFIX[one]]));
  if (!(unit in SCALES) || value === 0) return `${Number(value.toPrecision(DIGITS))}${unit === "1" ? "" : ` ${unit}`}`;
  const fitting = Object.entries(known).filter(([, size]) => Math.abs(value) >= size).sort(([, x], [, y]) => y - x)[0];
  const [prefix, size] = fitting ?? ["n", 1e-9];
  return `${Number((value / size).toPrecision(DIGITS))} ${prefix}${unit}`;
}

// what an empty field stands for where a formula needs it
const ASSUMED = {
  r: (values, formula) => (formula.place === "outside" ? 2 : 0.5) * values.a,
  x: (values, formula) => (formula.place === "outside" ? 2 : 0.5) * values.a,
  F_x: (values) => 0.5 * values.mu * values.F,
  c: (values, formula, form) => form.givenBy("c", formula.medium, { F_x: ASSUMED.F_x(values), ...values }),
  G_star: (values) => (2 * values.E_star * (1 - values.nu)) / (2 - values.nu),
};
// of one elastic body under a rigid one
const MODULUS = ({ E, nu }) => E / (1 - nu * nu);

class Form {
  constructor(place, data) {
    Object.assign(this, { place, data, inputs: {}, given: data.state[0]?.name });
    const address = new URLSearchParams(location.search);
    for (const one of data.state) if (address.has(one.name)) this.given = one.name;
    const field = (one, title) => {
      const input = document.createElement("input");
      input.value = address.get(one.name) ?? (one.value === "" ? "" : shown(one.value, one.unit));
      input.setAttribute("aria-label", one.meaning);
      input.spellcheck = false;
      input.addEventListener("input", () => this.changed(one.name));
      const line = document.createElement("label");
      const sign = document.createElement("span");
      katex.render(one.tex, sign);
      const words = document.createElement("small");
      words.textContent = title ? "" : one.meaning;
      const fault = document.createElement("em");
      fault.setAttribute("role", "alert");
      line.append(title ?? sign, input, words, fault);
      this.inputs[one.name] = { input, fault, one };
      place.append(line);
    };
    if (data.state.length) {
      const choice = document.createElement("select");
      choice.setAttribute("aria-label", "what is given");
      for (const one of data.state) choice.add(new Option(one.meaning.split(/ (?:of|at) /)[0], one.name, false, one.name === this.given));
      choice.addEventListener("change", () => { this.choose(choice.value); });
      field({ ...data.state.find((one) => one.name === this.given) }, choice);
      this.known = this.inputs[this.given];
    }
    for (const one of data.fields) field(one);
    this.curves = document.createElement("div");
    this.curves.className = "drawn";
    place.after(this.curves);
    this.rewrite("E");
    this.calculate();
  }

  changed(name) {
    this.rewrite(name);
    this.calculate();
    const address = new URLSearchParams(Object.values(this.inputs).map(({ input, one }) => [one.name, input.value]));
    history.replaceState(null, "", `?${address}${location.hash}`);
  }

  // a modulus of its own takes the place of that of a body, and the other way round
  rewrite(name) {
    const { E, E_star: whole } = this.inputs;
    if (name === "E_star" && E) E.input.value = "";
    if ((name === "E" || name === "nu") && E && E.input.value.trim()) {
      try {
        const [young, ratio] = ["E", "nu"].map((own) => valueOf(this.inputs[own].one, this.inputs[own].input.value));
        whole.input.value = shown(MODULUS({ E: young, nu: ratio }), "Pa");
      } catch { /* what is wrong is said beside the field */ }
    }
  }

  choose(name) {
    const one = this.data.state.find((own) => own.name === name);
    const value = this.values?.[name];
    delete this.inputs[this.given];
    this.given = name;
    this.inputs[name] = { ...this.known, one };
    this.known.input.setAttribute("aria-label", one.meaning);
    this.known.input.value = Number.isFinite(value) ? shown(value, one.unit) : "";
    this.changed(name);
  }

  // what is given, and what follows from it by the formulas that give a letter of the state
  read() {
    const values = {};
    let sound = true;
    for (const { input, fault, one } of Object.values(this.inputs)) {
      fault.textContent = "";
      if (input.value.trim() === "" && one.name !== this.given) continue;
      try {
        values[one.name] = valueOf(one, input.value);
      } catch (error) {
        fault.textContent = error.message;
        sound = false;
      }
    }
    if (!sound) return null;
    return values;
  }

  // on every half-space the contact has its own depth, force and radius
  completed(given, medium = 0) {
    const values = { ...given };
    const wanted = new Set(this.data.state.map((one) => one.name));
    for (let more = true; more;) {
      more = false;
      for (const [row, formula] of Object.entries(this.data.formulas)) {
        const open = formula.suffix && formula.medium === medium && wanted.has(formula.gives) && !(formula.gives in values);
        if (!open || !formula.needs.every((name) => name in values)) continue;
        values[formula.gives] = this.data.evaluate[row](values);
        more = true;
      }
    }
    return values;
  }

  // by the formula that gives a letter, where its arguments are known
  givenBy(letter, medium, values) {
    const [row, formula] = Object.entries(this.data.formulas).find(([, one]) => one.gives === letter && one.medium === medium) ?? [];
    return formula?.needs.every((name) => name in values) ? this.data.evaluate[row](values) : NaN;
  }

  calculate() {
    const given = this.read();
    const states = given && [0, 1].map((medium) => this.completed(given, medium));
    this.values = states?.[0] ?? null;
    for (const [row, formula] of Object.entries(this.data.formulas)) this.show(row, formula, states?.[formula.medium]);
    clearTimeout(this.pending);
    this.curves.setAttribute("aria-busy", "true");
    if (states) this.draw(this.drawn(states[0]), []);
    else this.replace([]);
  }

  // curve by curve, once the numbers are there: a curve takes as long as all of these
  draw(figures, found) {
    this.pending = setTimeout(() => {
      const { value, done } = figures.next();
      if (done) this.replace(found);
      else this.draw(figures, value ? [...found, value] : found);
    });
  }

  replace(figures) {
    this.curves.replaceChildren(...figures);
    this.curves.setAttribute("aria-busy", "false");
  }

  show(row, formula, values) {
    const key = document.querySelector(`a.key[href="#${row}"]`);
    if (!key) return;
    let output = key.parentElement.querySelector("output");
    if (!output) {
      output = document.createElement("output");
      key.parentElement.append(output);
    }
    const assumed = {};
    for (const name of formula.needs) {
      if (!values || name in values || !(name in ASSUMED)) continue;
      const value = ASSUMED[name]({ ...values, ...assumed }, formula, this);
      if (Number.isFinite(value)) assumed[name] = value;
    }
    const known = { ...values, ...assumed };
    const ready = values && formula.needs.every((name) => name in known);
    const where = Object.entries(assumed).map(([name, value]) => `${name} = ${shown(value, this.inputs[name].one.unit)}`);
    output.textContent = ready ? shown(this.data.evaluate[row](known), formula.unit) : "";
    if (ready && where.length) output.append(Object.assign(document.createElement("small"), { textContent: ` at ${where.join(", ")}` }));
  }

  *drawn(values) {
    const { formulas, evaluate, place, state } = this.data;
    const ratios = Array.from({ length: POINTS }, (_, count) => (count + 0.5) / POINTS);
    for (const [row, formula] of Object.entries(formulas)) {
      if (formula.suffix === "" || formula.medium || !formula.needs.includes(place) || !("a" in values)) continue;
      const outside = formula.place === "outside";
      const places = ratios.map((ratio) => (outside ? values.a * (1 + 2 * ratio) : values.a * ratio));
      const points = places.map((x) => [x, evaluate[row]({ ...values, [place]: x })]);
      yield plot(row, points, [place, "m"], [formula.gives, formula.unit]);
    }
    const load = state.find(({ name }) => name === "F" || name === "P");
    if (load && "d" in values && state.some(({ name }) => name === "d")) {
      const rest = Object.fromEntries(Object.entries(values).filter(([name]) => !state.some((one) => one.name === name)));
      const states = ratios.map((ratio) => this.completed({ ...rest, d: 2 * ratio * values.d }));
      const points = states.map((own) => [own.d, own[load.name]]);
      yield plot("load", points, ["d", "m"], [load.name, load.unit], [values.d, values[load.name]]);
    }
  }
}

const POINTS = 81, WIDTH = 300, HEIGHT = 180, EDGE = 8;

function plot(name, all, [x, xUnit], [y, yUnit], mark) {
  const points = all.filter((point) => point.every(Number.isFinite));
  if (points.length < 3) return null;
  const sorted = points.map(([, value]) => value).sort((one, other) => one - other);
  // an infinite edge leaves room for the rest
  const high = Math.max(0, Math.min(sorted.at(-1), 4 * sorted[Math.floor(0.75 * sorted.length)] || sorted.at(-1)));
  const low = Math.min(0, Math.max(sorted[0], 4 * sorted[Math.floor(0.25 * sorted.length)] || sorted[0]));
  const [first, last] = [points[0][0], points.at(-1)[0]];
  const across = (value) => EDGE + ((WIDTH - 2 * EDGE) * (value - first)) / (last - first);
  const up = (value) => HEIGHT - EDGE - ((HEIGHT - 2 * EDGE) * (Math.min(Math.max(value, low), high) - low)) / (high - low || 1);
  const line = points.map(([one, other]) => `${across(one).toFixed(1)},${up(other).toFixed(1)}`).join(" ");
  const figure = document.createElement("figure");
  const table = [`"${x} in ${xUnit}","${y} in ${yUnit}"`, ...points.map((point) => point.join(","))].join("\r\n");
  const dot = mark && mark.every(Number.isFinite) ? `<circle cx="${across(mark[0]).toFixed(1)}" cy="${up(mark[1]).toFixed(1)}" r="3"/>` : "";
  figure.innerHTML = `<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="${y} over ${x}"><line x1="${EDGE}" x2="${WIDTH - EDGE}" y1="${up(0)}" y2="${up(0)}"/><polyline points="${line}"/>${dot}</svg>`;
  const caption = document.createElement("figcaption");
  const link = document.createElement("a");
  Object.assign(link, { href: `data:text/csv;charset=utf-8,${encodeURIComponent(table)}`, download: `${name}.csv`, className: "table", textContent: "CSV" });
  caption.append(`${y} up to ${shown(high || low, yUnit)}; ${x} from ${shown(first, xUnit)} to ${shown(last, xUnit)} `, link);
  figure.append(caption);
  return figure;
}

const form = document.getElementById("calculator");
if (form && window.calculator) new Form(form, window.calculator);

})();
