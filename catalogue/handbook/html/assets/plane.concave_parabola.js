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
  maximum: (x, y = x) => (x > y || x !== x ? x : y),
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
  truth: (x) => (Array.isArray(x) ? x.length > 0 : Boolean(x)),
  zip: (x, y) => x.slice(0, y.length).map((value, place) => [value, y[place]]),
  // named fields that are told by their places too
  record: (fields) => Object.assign(Object.values(fields), fields),
  replaced: (x, changes) => math.record({ ...Object.fromEntries(Object.entries(x).slice(x.length)), ...changes }),
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
  // within a unit of the last place, as Math.hypot is not: what the root of the rounded squares is off by is taken from
  // it in differences without rounding (Borges 2020)
  hypot: (x, y) => {
    const [least, most] = [Math.min(Math.abs(x), Math.abs(y)), Math.max(Math.abs(x), Math.abs(y))];
    if (most !== most) return Math.hypot(x, y);
    if (least <= 1e-17 * most || most === Infinity) return most;
    if (most > 1e150) return math.hypot(x * TINY, y * TINY) / TINY;
    if (least < 1e-140) return math.hypot(x / TINY, y / TINY) * TINY;
    const root = Math.sqrt(most * most + least * least);
    if (root <= 2.0 * least) {
      const left = root - least;
      return root - (most * (2.0 * left - most) + (left - 2.0 * (most - least)) * left) / (2.0 * root);
    }
    const left = root - most;
    return root - (2.0 * left * (most - 2.0 * least) + ((4.0 * left - least) * least + left * left)) / (2.0 * root);
  },
  // x to a whole power as C has it, where Math.pow is a unit off at a tenth of all places: what each product is rounded by
  // goes with it (Dekker's product)
  raised: (x, exponent) => {
    const found = Math.pow(x, exponent);
    if (!(Math.abs(found) > 1e-250 && Math.abs(found) < 1e250)) return found;
    const apart = (value) => {
      const large = 134217729.0 * value;
      const high = large - (large - value);
      return [high, value - high];
    };
    const [first, second] = apart(x);
    let [whole, left] = [x, 0.0];
    for (let count = 1; count < exponent; count++) {
      const [high, low] = apart(whole);
      const product = whole * x;
      const lost = low * second - (product - high * first - low * first - high * second) + left * x;
      [whole, left] = [product + lost, lost - (product + lost - product)];
    }
    return whole;
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
  halfway: (low, high) => {
    const bits = new DataView(new ArrayBuffer(16));
    bits.setFloat64(0, low);
    bits.setFloat64(8, high);
    const first = bits.getBigInt64(0);
    bits.setBigInt64(0, first + (bits.getBigInt64(8) - first) / 2n);
    return bits.getFloat64(0);
  },
  // radii around waves: decades, sixteen in each wave, decades
  radii_of_waves: (length, reach) => {
    const waves = Math.floor(math.clip(Number.isFinite(reach / length) ? reach / length : 4.0, 4.0, 4096.0));
    const inner = [...math.range(15).map((place) => Math.pow(10.0, 10 * place - 150)), ...math.range(1, 16 * waves + 1).map((x) => x / 16.0)];
    return [...inner, ...math.range(10).map((place) => (waves + 1.0) * Math.pow(10.0, 10 * place))].map((x) => x * length);
  },
  // what was found for the last arguments
  kept: (of) => {
    const known = new Map();
    return (...given) => {
      const key = given.join();
      if (known.size > 99) known.clear();
      if (!known.has(key)) known.set(key, of(...given));
      return known.get(key);
    };
  },
  // the branches on which a steepness is above a level, each end refined where the sign changes between two radii; what
  // was sampled is that of a geometry, and keeps what was found in it
  branches: (change, far) => (steepness, sampled, level) => {
    const { radii, end } = sampled;
    const steep = (sampled.steep ??= radii.map((a) => steepness(a)));
    sampled.found ??= math.kept((level) => math.searched(change, far, steepness, radii, steep, end, level));
    return sampled.found(level);
  },
  searched: (change, far, steepness, radii, steep, end, level) => {
    const above = (a) => Math.log(steepness(a) / level);
    const [first, last] = [[], []];
    if (steep[0] >= level) first.push(radii[0]);
    for (let place = 1; place < radii.length; place++) {
      const [before, after] = [steep[place - 1], steep[place]];
      const up = after >= level;
      if (up !== before >= level && (up || radii[place - 1] < far)) {
        const found = change(above, radii[place - 1], radii[place], Math.log(before / level), Math.log(after / level), up ? 1.0 : -1.0);
        (up ? first : last).push(found);
      }
    }
    const largest = math.nextafter(radii.at(-1), 0.0);
    return { first: first.map((a) => Math.min(a, largest)), last: [...last, end].slice(0, first.length) };
  },
  lowest: ({ first }, load) => {
    const loads = first.map(load);
    const known = loads.filter((x) => x === x);
    return known.length ? first[loads.indexOf(Math.min(...known))] : NaN;
  },
  springs: (pairs, under) => (left, low, high) => {
    const first = left(low);
    const terms = pairs.map(([node, weight]) => weight * left(low + (high - low) * node));
    return (high - low) * (math.fsum(terms) + under * first);
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
  both: (integrand, stop, width = 1.0, lengths = STRIPS) => {
    const [first, second] = [[], []];
    for (const [node, weight] of Math.abs(stop) > 0.0 ? math.rule(lengths)(stop / width) : []) {
      const [x, y] = integrand(node * stop);
      first.push(weight * x);
      second.push(weight * y);
    }
    return [math.fsum(first) * stop, math.fsum(second) * stop];
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
const TINY = Math.pow(2.0, -600);
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

const _minimum_load = (h, E_star) => {
  return (((Math.PI * E_star) * h) / 2);
};

const _pressure_of_concave_parabola = (x, P, a, h, E_star) => {
  let carried, complete, face, result, root, value;
  root = Math.sqrt(((a - x) * (a + x)));
  face = ((((Math.PI * E_star) * h) * Math.pow(x, 2)) / Math.pow(a, 2));
  carried = ((P - _minimum_load(h, E_star)) + face);
  value = (carried / (Math.PI * root));
  complete = ((_minimum_load(h, E_star) * (1.0 - 1e-15)) <= P);
  result = math.where(((x <= a) & (P > 0.0)), value, 0.0);
  return math.where(complete, result, NaN);
};

const _pressure = (x, P, a, h, E_star) => {
  let v11, v17;
  if (((x > 1e-30) && (x < 1e+30) && (P > 1e-30) && (P < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v11 = ((3.141592653589793 * E_star) * h);
    v17 = (v11 / 2.0);
    if (((v17 * 0.999999999999999) <= P)) {
      if (((x <= a) && (P > 0.0))) {
        return (((P - v17) + ((v11 * (x * x)) / (a * a))) / (3.141592653589793 * Math.sqrt(((a - x) * (a + x)))));
      }
      return 0.0;
    }
    return NaN;
  }
  return _pressure_of_concave_parabola(x, P, a, h, E_star);
};

const pressure = (x, P, a, h, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((Math.abs(x) >= 0.0) && (P >= 0.0)) ? ((Math.abs(x) < Infinity) ? _pressure(Math.abs(x), P, a, h, E_star) : 0.0) : NaN);
};

const _profile_slope = (x, a, h) => {
  return ((((-2) * h) * x) / Math.pow(a, 2));
};

const _slope_of_concave_parabola = (x, P, a, h, E_star) => {
  let complete, conjugate, face, outside, result, root, strip, value;
  root = Math.sqrt(((x - a) * (a + x)));
  strip = (((-2) * P) / ((Math.PI * E_star) * root));
  conjugate = (((2 * Math.pow(root, 2)) + ((2 * x) * root)) + Math.pow(a, 2));
  face = ((h * Math.pow(a, 2)) / (conjugate * root));
  value = (strip - face);
  outside = math.where((P > 0.0), value, 0.0);
  complete = ((_minimum_load(h, E_star) * (1.0 - 1e-15)) <= P);
  result = math.where((x >= a), outside, (-_profile_slope(x, a, h)));
  return math.where(complete, result, NaN);
};

const _slope = (x, P, a, h, E_star) => {
  let v12, v21, v8;
  if (((x > 1e-30) && (x < 1e+30) && (P > 1e-30) && (P < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v12 = (3.141592653589793 * E_star);
    if (((((v12 * h) / 2.0) * 0.999999999999999) <= P)) {
      v21 = (a * a);
      if ((x >= a)) {
        if ((P > 0.0)) {
          v8 = Math.sqrt(((x - a) * (a + x)));
          return ((((-2.0) * P) / (v12 * v8)) - ((h * v21) / ((((2.0 * (v8 * v8)) + ((2.0 * x) * v8)) + v21) * v8)));
        }
        return 0.0;
      }
      return (-((((-2.0) * h) * x) / v21));
    }
    return NaN;
  }
  return _slope_of_concave_parabola(x, P, a, h, E_star);
};

const slope = (x, P, a, h, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((((Math.abs(x) >= 0.0) && (P >= 0.0)) ? ((Math.abs(x) < Infinity) ? _slope(Math.abs(x), P, a, h, E_star) : 0.0) : NaN) * ((x < 0.0) ? -1.0 : 1.0)) + 0.0);
};

const _depth_of_concave_parabola = (L, P, a, h, E_star) => {
  let complete, conjugate, face, result, root, strip, value;
  root = Math.sqrt(((L - a) * (a + L)));
  strip = (((2 * P) * Math.log1p((((L - a) + root) / a))) / (Math.PI * E_star));
  conjugate = (root + L);
  face = ((h * L) / conjugate);
  value = (strip - face);
  complete = ((_minimum_load(h, E_star) * (1.0 - 1e-15)) <= P);
  result = math.where((a <= L), value, NaN);
  return math.where(complete, result, NaN);
};

const _depth = (L, P, a, h, E_star) => {
  let v16, v5, v8;
  if (((L > 1e-30) && (L < 1e+30) && (P > 1e-30) && (P < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v16 = (3.141592653589793 * E_star);
    if (((((v16 * h) / 2.0) * 0.999999999999999) <= P)) {
      if ((a <= L)) {
        v5 = (L - a);
        v8 = Math.sqrt((v5 * (a + L)));
        return ((((2.0 * P) * Math.log1p(((v5 + v8) / a))) / v16) - ((h * L) / (v8 + L)));
      }
      return NaN;
    }
    return NaN;
  }
  return _depth_of_concave_parabola(L, P, a, h, E_star);
};

const depth = (L, P, a, h, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((L >= 0.0) && (P >= 0.0)) ? _depth(L, P, a, h, E_star) : NaN);
};

const _zero_distance = (a) => {
  return (0.0 * a);
};

const zero_distance = (a, h) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity)))) {
    return NaN;
  }
  return _zero_distance(a);
};

const _minimum_load_of_concave_parabola = (h, E_star, a = 1.0) => {
  if (((h > 1e-30) && (h < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (a > 1e-30) && (a < 1e+30))) {
    return (((3.141592653589793 * E_star) * h) / 2.0);
  }
  return _minimum_load(h, E_star);
};

const minimum_load = (a, h, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return _minimum_load_of_concave_parabola(h, E_star);
};

const once = {  };
const formulas = {
  "p": (v) => pressure(v.x, v.P, v.a, v.h, v.E_star),
  "s": (v) => slope(v.x, v.P, v.a, v.h, v.E_star),
  "d": (v) => depth(v.L, v.P, v.a, v.h, v.E_star),
  "xz": (v) => zero_distance(v.a, v.h),
  "Pmin": (v) => minimum_load(v.a, v.h, v.E_star),
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
   "name": "h",
   "tex": "h",
   "meaning": "height or depth of the profile",
   "unit": "m",
   "rule": "h > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 1e-06
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
   "value": 1000000.0
  }
 ],
 "formulas": {
  "p": {
   "gives": "p",
   "needs": [
    "x",
    "P",
    "a",
    "h",
    "E_star"
   ],
   "unit": "Pa",
   "place": "inside",
   "suffix": "p",
   "medium": 0
  },
  "s": {
   "gives": "slope",
   "needs": [
    "x",
    "P",
    "a",
    "h",
    "E_star"
   ],
   "unit": "1",
   "place": "outside",
   "suffix": "s",
   "medium": 0
  },
  "d": {
   "gives": "d",
   "needs": [
    "L",
    "P",
    "a",
    "h",
    "E_star"
   ],
   "unit": "m",
   "place": "",
   "suffix": "d",
   "medium": 0
  },
  "xz": {
   "gives": "x_zero",
   "needs": [
    "a",
    "h"
   ],
   "unit": "m",
   "place": "",
   "suffix": "xz",
   "medium": 0
  },
  "Pmin": {
   "gives": "P",
   "needs": [
    "a",
    "h",
    "E_star"
   ],
   "unit": "N/m",
   "place": "",
   "suffix": "Pmin",
   "medium": 0
  }
 },
 "place": "x"
}, evaluate: formulas };
})();
