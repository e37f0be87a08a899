(() => {
"use strict";
// What JavaScript's Math lacks of Python's math and of NumPy over single numbers, and rules of integration.
const math = {
  asarray: (x) => x,
  vectorize: (of) => of,
  float64: (x) => x,
  full: (like, value) => value,
  ones_like: () => 1.0,
  zeros_like: () => 0.0,
  zeros: () => 0.0,
  ndim: () => 0,
  logical_not: (x) => !x,
  where: (condition, x, y) => (condition ? x : y),
  minimum: (x, y) => (x < y || x !== x ? x : y),
  maximum: (x, y) => (x > y || x !== x ? x : y),
  clip: (x, low, high) => Math.min(Math.max(x, low), high),
  sqrt: Math.sqrt,
  log: (x) => Math.log(x),
  log1p: (x) => Math.log1p(x),
  exp2: (x) => Math.pow(2.0, x),
  all: (x) => x.every(Boolean),
  length: (x) => x.length,
  range: (...given) => {
    const [start, stop, step] = given.length > 1 ? [...given, 1] : [0, given[0], 1];
    return Array.from({ length: Math.max(Math.ceil((stop - start) / step), 0) }, (_, count) => start + step * count);
  },
  zip: (x, y) => x.map((value, place) => [value, y[place]]),
  enumerate: (x, start = 0) => Array.from(x, (value, place) => [place + start, value]),
  repeated: (x, count) => math.range(count).flatMap(() => x),
  reversed: (x) => [...x].reverse(),
  reduce: (of, x) => Array.from(x).reduce((first, next) => of(first, next)),
  copysign: (x, sign) => (sign < 0.0 || Object.is(sign, -0.0) ? -Math.abs(x) : Math.abs(x)),
  prod: (x) => x.reduce((total, value) => total * value, 1.0),
  sum: (x, start = 0.0) => x.reduce((total, value) => total + value, start),
  // exact before it is rounded: partial sums that do not overlap
  fsum: (values) => {
    if (!values.every(Number.isFinite)) return math.sum(values);
    const parts = [];
    for (let x of values) {
      let count = 0;
      for (let y of parts) {
        if (Math.abs(x) < Math.abs(y)) [x, y] = [y, x];
        const high = x + y;
        const low = y - (high - x);
        if (low !== 0.0) parts[count++] = low;
        x = high;
      }
      parts.length = count;
      parts.push(x);
    }
    if (!parts.every(Number.isFinite)) return math.sum(values);
    return parts.reduceRight((total, part) => total + part, 0.0);
  },
  // Lanczos' approximation with 13 terms and g = 6.0246800407767296, as Python's math.gamma has it
  gamma: (x) => {
    if (Number.isInteger(x) && x > 0.0 && x < 24.0) return math.prod(math.range(1, x));
    if (x < 0.5) return Math.PI / (Math.sin(Math.PI * x) * math.gamma(1.0 - x));
    const y = x + (G - 0.5);
    const lost = ((x > G - 0.5 ? y - x - (G - 0.5) : y - (G - 0.5) - x) * G) / y;
    const share = lanczos(x) / Math.exp(y);
    if (x < 140.0) return (share + lost * share) * Math.pow(y, x - 0.5);
    const half = Math.pow(y, (x - 0.5) / 2.0);
    return (share + lost * share) * half * half;
  },
  lgamma: (x) => Math.log(lanczos(x)) - G + (x - 0.5) * (Math.log(x + G - 0.5) - 1.0),
  frexp: (x) => {
    if (x === 0.0 || !Number.isFinite(x)) return [x, 0];
    let power = Math.max(-1021, Math.floor(Math.log2(Math.abs(x))) + 1);
    let share = math.ldexp(x, -power);
    while (Math.abs(share) < 0.5) [share, power] = [share * 2.0, power - 1];
    while (Math.abs(share) >= 1.0) [share, power] = [share / 2.0, power + 1];
    return [share, power];
  },
  ldexp: (x, power) => {
    const half = Math.trunc(power / 3.0);
    return x * Math.pow(2.0, half) * Math.pow(2.0, half) * Math.pow(2.0, power - 2 * half);
  },
  nextafter: (x, to) => {
    if (x === to || x !== x || to !== to) return x === to ? to : NaN;
    if (x === 0.0) return to > 0.0 ? Number.MIN_VALUE : -Number.MIN_VALUE;
    const bits = new DataView(new ArrayBuffer(8));
    bits.setFloat64(0, x);
    bits.setBigInt64(0, bits.getBigInt64(0) + (x > 0.0 === to > x ? 1n : -1n));
    return bits.getFloat64(0);
  },
  // nodes and weights on (0, 1) for an interval of a length, in panels beyond the last one
  rule: (lengths) => (length) => {
    for (const [longest, count] of lengths) if (length <= longest) return pairs(count, 1);
    // thousands of panels, within each of them again, for what is no number at the end
    if (!Number.isFinite(length)) return [[NaN, NaN]];
    const [longest, count] = lengths.at(-1);
    return pairs(count, panelsOf(length / longest));
  },
  integral: (integrand, stop, count) =>
    math.fsum(pairs(count, 1).map(([node, weight]) => weight * integrand(node * stop))) * stop,
  integral_in_strip: (integrand, stop, width = 1.0, lengths = STRIPS) =>
    math.fsum(math.rule(lengths)(stop / width).map(([node, weight]) => weight * integrand(node * stop))) * stop,
  integral_by_panels: (integrand, stop, width, count) => {
    const panels = panelsOf(Math.max(stop / width, 1.0));
    return math.fsum(pairs(count, panels).map(([node, weight]) => weight * integrand(node * stop))) * stop;
  },
  integral_by_length: (...given) => math.integral_in_strip(...given),
  in_groups: (rule_of) => (slope, parameters, ...given) => {
    const { width } = typeof given.at(-1) === "object" ? given.pop() : { width: 1.0 };
    const [integrand, stop, factor, holds, otherwise] = rule_of((...t) => slope(...t, ...parameters), ...given);
    return holds ? factor * math.integral_in_strip(integrand, stop, width) : otherwise;
  },
  // the same for what has a power of the place as a weight, whose moments are products of rationals: the smooth factor
  // is a sum of Legendre's polynomials; `beyond` the value at zero the weights are those over the place
  products: (power, count, beyond) => {
    const key = `${power} ${count} ${beyond}`;
    if (!kept.has(key)) {
      if (kept.size > 999) kept.clear();
      const moments = [1.0 / (1.0 + power)];
      for (let j = 1; j < count; j++) moments.push((moments[j - 1] * (power + (1.0 - j))) / (power + (1.0 + j)));
      const weighed = ([node, weight]) => {
        const x = 2.0 * node - 1.0;
        let [last, now, total] = [1.0, x, moments[0] + 3.0 * moments[1] * x];
        for (let j = 1; j < count - 1; j++) {
          [last, now] = [now, ((2.0 * j + 1.0) * x * now - j * last) / (j + 1.0)];
          total += (2.0 * j + 3.0) * moments[j + 1] * now;
        }
        return [node, (weight * total) / (beyond ? node : 1.0)];
      };
      kept.set(key, pairs(count, 1).map(weighed));
    }
    return kept.get(key);
  },
  at_break: (b) => 1e-100 * b,
};
const G = 6.024680040776729583740234375;
const lanczos = (x) => {
  const whole = (terms) =>
    x < 5.0 ? terms.reduceRight((total, own) => total * x + own, 0.0) : terms.reduce((total, own) => total / x + own, 0.0);
  return whole(ABOVE) / whole(BELOW);
};
const ABOVE = [
  23531376880.41075968857200767445163675473076, 42919803642.64909876895789904700198885093263, 35711959237.35566804944018545154716670596,
  17921034426.03720969991975575445893111267140, 6039542586.352028005064291644307297921069938, 1439720407.311721673663223072794912393971,
  248874557.8620541565114603864132294232163212, 31426415.58540019438061423162831820536287468, 2876370.628935372441225409051620849613599,
  186056.2653952234950402949897160456992822078, 8071.672002365816210638002902272250613821851, 210.8242777515793458725097339207133627116,
  2.506628274631000270164908177133837338626431,
];
const BELOW = [
  0, 39916800, 120543840, 150917976, 105258076, 45995730, 13339535, 2637558, 357423, 32670, 1925, 66, 1,
];
const STRIPS = [[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]];
const panelsOf = (length) => (length < 4096.0 ? Math.ceil(length) : 4096);
const kept = new Map();
const pairs = (count, panels) => {
  const key = 1000 * count + panels;
  if (!kept.has(key)) {
    const half = HALVES[count];
    const whole = [...half, ...math.reversed(half).map(([node, weight]) => [1.0 - node, weight])];
    const each = (start) => whole.map(([node, weight]) => [(start + node) / panels, weight / panels]);
    kept.set(key, math.range(panels).flatMap(each));
  }
  return kept.get(key);
};

const _energy_of_flat_punch = (d, a, E_star) => {
  return ((E_star * Math.pow(d, 2)) * a);
};

const _energy = (d, a, E_star) => {
  if (((d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    return ((E_star * (d * d)) * a);
  }
  return _energy_of_flat_punch(d, a, E_star);
};

const energy = (d, a, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _energy(d, a, E_star) : NaN);
};

const _force = (d, a, E_star) => {
  return (((2 * E_star) * d) * a);
};

const _load_within_of_flat_punch = (r, d, a, E_star) => {
  let root, within;
  root = Math.sqrt(((a - r) * (a + r)));
  within = ((((2 * E_star) * d) * Math.pow(r, 2)) / (root + a));
  return math.where((r < a), within, _force(d, a, E_star));
};

const _load_within = (r, d, a, E_star) => {
  let v10;
  if (((r > 1e-30) && (r < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v10 = ((2.0 * E_star) * d);
    if ((r < a)) {
      return ((v10 * (r * r)) / (Math.sqrt(((a - r) * (a + r))) + a));
    }
    return (v10 * a);
  }
  return _load_within_of_flat_punch(r, d, a, E_star);
};

const load_within = (r, d, a, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _load_within(r, d, a, E_star) : 0.0) : NaN);
};

const _force_of_flat_punch = (d, a, E_star) => {
  return (((2.0 * E_star) * d) * a);
};

const force = (d, a, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_of_flat_punch(d, a, E_star) : NaN);
};

const _pressure_of_flat_punch = (r, d, a, E_star) => {
  let root;
  root = Math.sqrt(((a - r) * (a + r)));
  return math.where(((r <= a) & (d > 0.0)), ((E_star * d) / (Math.PI * root)), 0.0);
};

const _pressure = (r, d, a, E_star) => {
  if (((r > 1e-30) && (r < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if (((r <= a) && (d > 0.0))) {
      return ((E_star * d) / (3.141592653589793 * Math.sqrt(((a - r) * (a + r)))));
    }
    return 0.0;
  }
  return _pressure_of_flat_punch(r, d, a, E_star);
};

const pressure = (r, d, a, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _pressure(r, d, a, E_star) : 0.0) : NaN);
};

const _profile = (r, a) => {
  return math.where((r <= a), 0, NaN);
};

const _displacement_of_flat_punch = (r, d, a) => {
  let angle, inside, outside, root;
  root = Math.sqrt(((r - a) * (a + r)));
  angle = Math.atan((a / root));
  outside = (((2 * d) * angle) / Math.PI);
  inside = (d - _profile(r, a));
  return math.where((r > a), outside, inside);
};

const _displacement = (r, d, a) => {
  if (((r > 1e-30) && (r < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30))) {
    if ((r > a)) {
      return (((2.0 * d) * Math.atan((a / Math.sqrt(((r - a) * (a + r)))))) / 3.141592653589793);
    }
    return (d - ((r <= a) ? 0.0 : NaN));
  }
  return _displacement_of_flat_punch(r, d, a);
};

const displacement = (r, d, a) => {
  if ((!(0.0 < a && a < Infinity))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _displacement(r, d, a) : 0.0) : NaN);
};

const _stiffness_of_flat_punch = (a, E_star) => {
  return ((2 * E_star) * a);
};

const _stiffness = (a, E_star) => {
  if (((a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    return ((2.0 * E_star) * a);
  }
  return _stiffness_of_flat_punch(a, E_star);
};

const stiffness = (a, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return _stiffness(a, E_star);
};

const _depth_from_force_of_flat_punch = (F, a, E_star) => {
  return (F / ((2 * E_star) * a));
};

const _depth_from_force = (F, a, E_star) => {
  if (((F > 1e-30) && (F < 1e+30) && (a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    return (F / ((2.0 * E_star) * a));
  }
  return _depth_from_force_of_flat_punch(F, a, E_star);
};

const depth_from_force = (F, a, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force(F, a, E_star) : NaN);
};

const hess_retraction = (a, E_star, dgamma) => {
  return (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star)));
};

const retraction = (a, E_star, dgamma) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return hess_retraction(a, E_star, dgamma);
};

const _torque_of_flat_punch = (beta, a, G) => {
  return ((((16.0 / 3.0) * G) * Math.pow(a, 3)) * beta);
};

const _torque = (beta, a, G) => {
  if (((beta > 1e-30) && (beta < 1e+30) && (a > 1e-30) && (a < 1e+30) && (G > 1e-30) && (G < 1e+30))) {
    return (((5.333333333333333 * G) * (a * (a * a))) * beta);
  }
  return _torque_of_flat_punch(beta, a, G);
};

const torque = (beta, a, G) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < G && G < Infinity)))) {
    return NaN;
  }
  return ((beta >= 0.0) ? _torque(beta, a, G) : NaN);
};

const oblate = (r, z, a) => {
  let excess, larger, smaller, whole;
  whole = (Math.hypot((r - a), z) * Math.hypot((r + a), z));
  excess = (((r - a) * (r + a)) + (z * z));
  larger = Math.sqrt((0.5 * (whole + Math.abs(excess))));
  smaller = math.where((larger > 0.0), ((z * a) / math.where((larger > 0.0), larger, 1.0)), 0.0);
  return [math.where((excess > 0.0), larger, smaller), math.where((excess > 0.0), smaller, larger), whole];
};

const ARCTAN_GAP = [[0.3333333333333333, 0.8116412201960678, 0.7123414383945195, 0.2725778671008127, 0.04325113828415611, 0.0021043873129700233, 2.229767813968649e-06], [1.0, 3.034923660588189, 3.5294070829658954, 1.9680296155712274, 0.5368820963772863, 0.06453295925870227, 0.002445452808893491]];

const rational = (v, top, bottom) => {
  let above, below, coefficient;
  [above, below] = [top.at(-1), bottom.at(-1)];
  for (coefficient of math.reversed(top).slice(2 - 1)) {
    above = ((above * v) + coefficient);
  }
  for (coefficient of math.reversed(bottom).slice(2 - 1)) {
    below = ((below * v) + coefficient);
  }
  return (above / below);
};

const arctan_gap = (x) => {
  let t;
  t = math.minimum(x, 1.0);
  return math.where((x < 1.0), ((t * (t * t)) * rational((t * t), ...ARCTAN_GAP)), (x - Math.atan(x)));
};

const turned_below = (r, z, a) => {
  let _, far, inside, outside, x, xi, y;
  [xi, _, _] = oblate(r, z, a);
  far = (xi > a);
  y = (a / math.where(far, xi, a));
  outside = ((((y * y) * y) / (1.0 + (y * y))) - arctan_gap(y));
  x = (math.where(far, 0.0, xi) / a);
  inside = (((Math.PI / 2.0) - Math.atan(x)) - (x / (1.0 + (x * x))));
  return (((2.0 * r) / Math.PI) * math.where(far, outside, inside));
};

const _displacement_3 = (r, z, a, beta) => {
  return (beta * turned_below(r, z, a));
};

const _displacement_2 = (r, z, a, beta) => {
  let v11, v16, v18, v25, v27, v29, v30, v36, v4, v6, v79, v82, v94;
  if (((r > 1e-30) && (r < 1e+30) && (z > 1e-30) && (z < 1e+30) && (a > 1e-30) && (a < 1e+30) && (beta > 1e-30) && (beta < 1e+30))) {
    v4 = (r - a);
    v6 = (r + a);
    v11 = ((v4 * v6) + (z * z));
    v16 = Math.sqrt((0.5 * ((Math.hypot(v4, z) * Math.hypot(v6, z)) + Math.abs(v11))));
    if ((v11 > 0.0)) {
      v25 = v16;
    } else {
      v18 = (v16 > 0.0);
      v25 = (v18 ? ((z * a) / (v18 ? v16 : 1.0)) : 0.0);
    }
    v27 = (v25 > a);
    if (v27) {
      v29 = (a / (v27 ? v25 : a));
      v30 = (v29 * v29);
      if ((v29 < 1.0)) {
        v36 = (v29 * v29);
        v79 = ((v29 * v36) * (((((((((((((2.229767813968649e-06 * v36) + 0.0021043873129700233) * v36) + 0.04325113828415611) * v36) + 0.2725778671008127) * v36) + 0.7123414383945195) * v36) + 0.8116412201960678) * v36) + 0.3333333333333333) / ((((((((((((0.002445452808893491 * v36) + 0.06453295925870227) * v36) + 0.5368820963772863) * v36) + 1.9680296155712274) * v36) + 3.5294070829658954) * v36) + 3.034923660588189) * v36) + 1.0)));
      } else {
        v79 = (v29 - Math.atan(v29));
      }
      v94 = (((v30 * v29) / (1.0 + v30)) - v79);
    } else {
      v82 = ((v27 ? 0.0 : v25) / a);
      v94 = ((1.5707963267948966 - Math.atan(v82)) - (v82 / (1.0 + (v82 * v82))));
    }
    return (beta * (((2.0 * r) / 3.141592653589793) * v94));
  }
  return _displacement_3(r, z, a, beta);
};

const displacement_of_flat_punch = (r, z, a, beta) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 <= beta && beta < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (z >= 0.0)) ? ((r < Infinity) ? _displacement_2(r, z, a, beta) : 0.0) : NaN);
};

const formulas = {
  "U": (v) => energy(v.d, v.a, v.E_star),
  "Fr": (v) => load_within(v.r, v.d, v.a, v.E_star),
  "F": (v) => force(v.d, v.a, v.E_star),
  "p": (v) => pressure(v.r, v.d, v.a, v.E_star),
  "w": (v) => displacement(v.r, v.d, v.a),
  "k": (v) => stiffness(v.a, v.E_star),
  "dF": (v) => depth_from_force(v.F, v.a, v.E_star),
  "adh.Dl": (v) => retraction(v.a, v.E_star, v.dgamma),
  "tor.M": (v) => torque(v.beta, v.a, v.G),
  "tor.ut": (v) => displacement_of_flat_punch(v.r, v.z, v.a, v.beta),
};
window.calculator = { ...{
 "fields": [
  {
   "name": "a",
   "tex": "a",
   "meaning": "contact radius",
   "unit": "m",
   "rule": "a > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 0.002
  },
  {
   "name": "beta",
   "tex": "\\beta",
   "meaning": "angle by which the punch turns",
   "unit": "rad",
   "rule": "beta >= 0",
   "low": 0.0,
   "high": null,
   "closed": "low",
   "value": ""
  },
  {
   "name": "G",
   "tex": "G",
   "meaning": "shear modulus of the half-space",
   "unit": "Pa",
   "rule": "G > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": ""
  },
  {
   "name": "z",
   "tex": "z",
   "meaning": "depth below the surface",
   "unit": "m",
   "rule": "z >= 0",
   "low": 0.0,
   "high": null,
   "closed": "low",
   "value": ""
  },
  {
   "name": "E_star",
   "tex": "E^{*}",
   "meaning": "effective (plane-strain) modulus",
   "unit": "Pa",
   "rule": "E_star > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 115384615384.61539
  },
  {
   "name": "E",
   "tex": "E",
   "meaning": "Young's modulus of an elastic body under a rigid one, in place of E*",
   "unit": "Pa",
   "rule": "E_1 > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": ""
  },
  {
   "name": "nu",
   "tex": "\\nu",
   "meaning": "its Poisson ratio",
   "unit": "1",
   "rule": "-1 < nu <= 1/2",
   "low": -1.0,
   "high": 0.5,
   "closed": "high",
   "value": 0.3
  },
  {
   "name": "dgamma",
   "tex": "\\Delta\\gamma",
   "meaning": "work of separation per unit area",
   "unit": "N/m",
   "rule": "dgamma >= 0",
   "low": 0.0,
   "high": null,
   "closed": "low",
   "value": 0.05
  },
  {
   "name": "r",
   "tex": "r",
   "meaning": "distance from the axis",
   "unit": "m",
   "rule": "r >= 0",
   "low": 0.0,
   "high": null,
   "closed": "low",
   "value": ""
  }
 ],
 "state": [
  {
   "name": "F",
   "tex": "F_{\\mathrm N}",
   "meaning": "normal force",
   "unit": "N",
   "rule": "F > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 1000.0
  },
  {
   "name": "d",
   "tex": "d",
   "meaning": "indentation depth of the point r = 0",
   "unit": "m",
   "rule": "d > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": ""
  }
 ],
 "formulas": {
  "U": {
   "gives": "U",
   "needs": [
    "d",
    "a",
    "E_star"
   ],
   "unit": "J",
   "place": "",
   "suffix": "U"
  },
  "Fr": {
   "gives": "F_r",
   "needs": [
    "r",
    "d",
    "a",
    "E_star"
   ],
   "unit": "N",
   "place": "inside",
   "suffix": "Fr"
  },
  "F": {
   "gives": "F",
   "needs": [
    "d",
    "a",
    "E_star"
   ],
   "unit": "N",
   "place": "",
   "suffix": "F"
  },
  "p": {
   "gives": "p",
   "needs": [
    "r",
    "d",
    "a",
    "E_star"
   ],
   "unit": "Pa",
   "place": "inside",
   "suffix": "p"
  },
  "w": {
   "gives": "w",
   "needs": [
    "r",
    "d",
    "a"
   ],
   "unit": "m",
   "place": "outside",
   "suffix": "w"
  },
  "k": {
   "gives": "stiffness",
   "needs": [
    "a",
    "E_star"
   ],
   "unit": "N/m",
   "place": "",
   "suffix": "k"
  },
  "dF": {
   "gives": "d",
   "needs": [
    "F",
    "a",
    "E_star"
   ],
   "unit": "m",
   "place": "",
   "suffix": "dF"
  },
  "adh.Dl": {
   "gives": "retraction",
   "needs": [
    "a",
    "E_star",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": ""
  },
  "tor.M": {
   "gives": "torque",
   "needs": [
    "beta",
    "a",
    "G"
   ],
   "unit": "N m",
   "place": "",
   "suffix": ""
  },
  "tor.ut": {
   "gives": "around",
   "needs": [
    "r",
    "z",
    "a",
    "beta"
   ],
   "unit": "m",
   "place": "",
   "suffix": ""
  }
 },
 "place": "r"
}, evaluate: formulas };
})();
