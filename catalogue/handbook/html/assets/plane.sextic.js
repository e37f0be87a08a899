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
    const [longest, count] = lengths.at(-1);
    return pairs(count, Math.ceil(length / longest));
  },
  integral: (integrand, stop, count) =>
    math.fsum(pairs(count, 1).map(([node, weight]) => weight * integrand(node * stop))) * stop,
  integral_in_strip: (integrand, stop, width = 1.0, lengths = STRIPS) =>
    math.fsum(math.rule(lengths)(stop / width).map(([node, weight]) => weight * integrand(node * stop))) * stop,
  integral_by_panels: (integrand, stop, width, count) => {
    const panels = Math.max(Math.ceil(stop / width), 1);
    return math.fsum(pairs(count, panels).map(([node, weight]) => weight * integrand(node * stop))) * stop;
  },
  integral_by_length: (...given) => math.integral_in_strip(...given),
  in_groups: (rule_of) => (slope, parameters, ...given) => {
    const { width } = typeof given.at(-1) === "object" ? given.pop() : { width: 1.0 };
    const [integrand, stop, factor, holds, otherwise] = rule_of((...t) => slope(...t, ...parameters), ...given);
    return holds ? factor * math.integral_in_strip(integrand, stop, width) : otherwise;
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

const load = (a, A, E_star) => {
  return ((((47.12388980384689 * E_star) * A) * Math.pow(a, 6.0)) / 16.0);
};

const pressure = (x, a, A, E_star) => {
  let v13, v17;
  if ((x < a)) {
    v13 = (a * a);
    v17 = (x * x);
    return (((((3.0 * E_star) * A) * (((3.0 * (v13 * v13)) + ((4.0 * v13) * v17)) + (8.0 * (v17 * v17)))) * Math.sqrt(((a - x) * (a + x)))) / 8.0);
  }
  return 0.0;
};

const slope = (x, a, A) => {
  let v10, v14, v15, v25, v6, v9, value;
  v25 = Math.pow(x, 5.0);
  if ((x > a)) {
    v6 = Math.sqrt(((x - a) * (a + x)));
    v9 = (x * x);
    v10 = (v9 * v9);
    v14 = (a * a);
    v15 = (v14 * v14);
    value = (((((-3.0) * A) * Math.pow(a, 6.0)) * (((9.0 * v15) + ((15.0 * v14) * v9)) + (40.0 * v10))) / (4.0 * (((((8.0 * v10) * v6) + ((3.0 * v15) * v6)) + (((4.0 * v14) * v9) * v6)) + (8.0 * v25))));
    return value;
  }
  return (-((6.0 * A) * v25));
};

const depth = (L, a, A) => {
  let v13, v14, v17, v18, v6, value;
  if ((a <= L)) {
    if ((a > 0.0)) {
      v6 = Math.sqrt(((L - a) * (a + L)));
      v13 = (a * a);
      v14 = (v13 * v13);
      v17 = (L * L);
      v18 = (v17 * v17);
      value = (((A * Math.pow(a, 6.0)) * ((15.0 * Math.asinh((v6 / a))) + ((L * (((9.0 * v14) + (40.0 * v18)) + ((15.0 * v13) * v17))) / ((8.0 * Math.pow(L, 5.0)) + ((((3.0 * v14) + (8.0 * v18)) + ((4.0 * v13) * v17)) * v6))))) / 8.0);
      return value;
    }
    return 0.0;
  }
  return NaN;
};

const half_width_from_load = (P, A, E_star) => {
  let v10, v8, value;
  v8 = ((16.0 * P) / ((47.12388980384689 * E_star) * A));
  v10 = Math.pow(v8, 0.16666666666666666);
  if (((v8 > 0.0) && (v8 < Infinity))) {
    value = (v10 + (v10 * (((v8 / (Math.pow(v10, 6.0) * Math.pow(v10, 0.0))) - 1.0) / 6.0)));
    return value;
  }
  return v10;
};

const formulas = {
  "P": (v) => load(v.a, v.A, v.E_star),
  "p": (v) => pressure(v.x, v.a, v.A, v.E_star),
  "s": (v) => slope(v.x, v.a, v.A),
  "d": (v) => depth(v.L, v.a, v.A),
  "aP": (v) => half_width_from_load(v.P, v.A, v.E_star),
};
window.calculator = { ...{
 "fields": [
  {
   "name": "A",
   "tex": "A",
   "meaning": "coefficient of a power-law profile",
   "unit": "m^(1-n)",
   "rule": "A > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 20000000000000.0
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
   "name": "x",
   "tex": "x",
   "meaning": "distance from the middle of a plane contact; lower limit of a primitive",
   "unit": "m",
   "rule": "",
   "low": null,
   "high": null,
   "closed": "",
   "value": ""
  },
  {
   "name": "L",
   "tex": "L",
   "meaning": "distance of the reference point from the middle of the contact",
   "unit": "m",
   "rule": "L > a",
   "low": null,
   "high": null,
   "closed": "",
   "value": 0.05
  }
 ],
 "state": [
  {
   "name": "P",
   "tex": "P",
   "meaning": "line load",
   "unit": "N/m",
   "rule": "P > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 100000.0
  },
  {
   "name": "a",
   "tex": "a",
   "meaning": "contact radius",
   "unit": "m",
   "rule": "a > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 0.001
  }
 ],
 "formulas": {
  "P": {
   "gives": "P",
   "needs": [
    "a",
    "A",
    "E_star"
   ],
   "unit": "N/m",
   "place": "",
   "suffix": "P"
  },
  "p": {
   "gives": "p",
   "needs": [
    "x",
    "a",
    "A",
    "E_star"
   ],
   "unit": "Pa",
   "place": "inside",
   "suffix": "p"
  },
  "s": {
   "gives": "slope",
   "needs": [
    "x",
    "a",
    "A"
   ],
   "unit": "1",
   "place": "outside",
   "suffix": "s"
  },
  "d": {
   "gives": "d",
   "needs": [
    "L",
    "a",
    "A"
   ],
   "unit": "m",
   "place": "",
   "suffix": "d"
  },
  "aP": {
   "gives": "a",
   "needs": [
    "P",
    "A",
    "E_star"
   ],
   "unit": "m",
   "place": "",
   "suffix": "aP"
  }
 },
 "place": "x"
}, evaluate: formulas };
})();
