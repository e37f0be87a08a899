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

const _energy_of_capped_cylinder = (d, a, R, E_star) => {
  let rho, whole;
  whole = Math.sqrt((R * d));
  rho = math.minimum(whole, a);
  return ((((8 * E_star) / (15 * Math.pow(R, 2))) * Math.pow(rho, 5)) + math.where((whole > a), (((((-E_star) / (3 * Math.pow(R, 2))) * a) * (Math.pow(a, 2) - (R * d))) * (Math.pow(a, 2) + ((3 * R) * d))), 0.0));
};

const _energy = (d, a, R, E_star) => {
  let v10, v23, v31, v4, v5;
  if (((d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R > 1e-30) && (R < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v4 = (R * d);
    v5 = Math.sqrt(v4);
    v10 = (R * R);
    if ((v5 > a)) {
      v23 = (a * a);
      v31 = (((((-E_star) / (3.0 * v10)) * a) * (v23 - v4)) * (v23 + ((3.0 * R) * d)));
    } else {
      v31 = 0.0;
    }
    return ((((8.0 * E_star) / (15.0 * v10)) * Math.pow((((v5 < a) || (v5 !== v5)) ? v5 : a), 5.0)) + v31);
  }
  return _energy_of_capped_cylinder(d, a, R, E_star);
};

const energy = (d, a, R, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < R && R < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _energy(d, a, R, E_star) : NaN);
};

const halves = (x) => {
  let high;
  high = (134217729.0 * x);
  high = (high - (high - x));
  return [high, (x - high)];
};

const _lost = (x, y, product) => {
  let x_high, x_low, y_high, y_low;
  [[x_high, x_low], [y_high, y_low]] = [halves(x), halves(y)];
  return (((((x_high * y_high) - product) + (x_high * y_low)) + (x_low * y_high)) + (x_low * y_low));
};

const difference_of_products = (w, x, y, z) => {
  let left, right;
  [left, right] = [(w * x), (y * z)];
  return ((left - right) + (_lost(w, x, left) - _lost(y, z, right)));
};

const _force = (d, a, R, E_star) => {
  let excess, rho;
  excess = (difference_of_products(R, d, a, a) / R);
  rho = math.minimum(Math.sqrt((R * d)), a);
  return (((((4 * E_star) / 3) * rho) * math.minimum(d, (Math.pow(a, 2) / R))) + (((2 * E_star) * a) * math.maximum(excess, 0.0)));
};

const _load_within_of_capped_cylinder = (r, d, a, R, E_star) => {
  let rho, root, root_rhor, whole, within;
  whole = Math.sqrt((R * d));
  rho = math.minimum(whole, a);
  root = Math.sqrt(((a - r) * (a + r)));
  root_rhor = Math.sqrt(((rho - r) * (rho + r)));
  within = (((((4 * E_star) / (3 * R)) * Math.pow(r, 2)) * (root_rhor + (Math.pow(rho, 2) / (rho + root_rhor)))) + math.where((whole > a), (((((-2) * E_star) * Math.pow(r, 2)) * (Math.pow(a, 2) - (R * d))) / (R * (root + a))), 0.0));
  return math.where((r < rho), within, _force(d, a, R, E_star));
};

const _load_within = (r, d, a, R, E_star) => {
  let v15, v17, v22, v33, v43, v46, v48, v49, v5, v50, v52, v53, v6, v62, v64, v65, v7, v76, v79;
  if (((r > 1e-30) && (r < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R > 1e-30) && (R < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v5 = (R * d);
    v6 = Math.sqrt(v5);
    v7 = (((v6 < a) || (v6 !== v6)) ? v6 : a);
    v17 = (4.0 * E_star);
    v33 = (a * a);
    if ((r < v7)) {
      v15 = Math.sqrt(((v7 - r) * (v7 + r)));
      v22 = (r * r);
      return ((((v17 / (3.0 * R)) * v22) * (v15 + ((v7 * v7) / (v7 + v15)))) + ((v6 > a) ? (((((-2.0) * E_star) * v22) * (v33 - v5)) / (R * (Math.sqrt(((a - r) * (a + r))) + a))) : 0.0));
    }
    v43 = (a * a);
    v46 = (134217729.0 * R);
    v48 = (v46 - (v46 - R));
    v49 = (R - v48);
    v50 = (134217729.0 * d);
    v52 = (v50 - (v50 - d));
    v53 = (d - v52);
    v62 = (134217729.0 * a);
    v64 = (v62 - (v62 - a));
    v65 = (a - v64);
    v76 = (((v5 - v43) + ((((((v48 * v52) - v5) + (v48 * v53)) + (v49 * v52)) + (v49 * v53)) - (((((v64 * v64) - v43) + (v64 * v65)) + (v65 * v64)) + (v65 * v65)))) / R);
    v79 = (v33 / R);
    return ((((v17 / 3.0) * v7) * (((d < v79) || (d !== d)) ? d : v79)) + (((2.0 * E_star) * a) * (((v76 > 0.0) || (v76 !== v76)) ? v76 : 0.0)));
  }
  return _load_within_of_capped_cylinder(r, d, a, R, E_star);
};

const load_within = (r, d, a, R, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < R && R < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _load_within(r, d, a, R, E_star) : 0.0) : NaN);
};

const _force_of_capped_cylinder = (d, a, R, E_star) => {
  let v10, v11, v12, v14, v15, v24, v26, v27, v38, v39, v4, v48, v5, v8;
  if (((d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R > 1e-30) && (R < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v4 = (R * d);
    v5 = (a * a);
    v8 = (134217729.0 * R);
    v10 = (v8 - (v8 - R));
    v11 = (R - v10);
    v12 = (134217729.0 * d);
    v14 = (v12 - (v12 - d));
    v15 = (d - v14);
    v24 = (134217729.0 * a);
    v26 = (v24 - (v24 - a));
    v27 = (a - v26);
    v38 = (((v4 - v5) + ((((((v10 * v14) - v4) + (v10 * v15)) + (v11 * v14)) + (v11 * v15)) - (((((v26 * v26) - v5) + (v26 * v27)) + (v27 * v26)) + (v27 * v27)))) / R);
    v39 = Math.sqrt(v4);
    v48 = ((a * a) / R);
    return (((((4.0 * E_star) / 3.0) * (((v39 < a) || (v39 !== v39)) ? v39 : a)) * (((d < v48) || (d !== d)) ? d : v48)) + (((2.0 * E_star) * a) * (((v38 > 0.0) || (v38 !== v38)) ? v38 : 0.0)));
  }
  return _force(d, a, R, E_star);
};

const force = (d, a, R, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < R && R < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_of_capped_cylinder(d, a, R, E_star) : NaN);
};

const _pressure_of_capped_cylinder = (r, d, a, R, E_star) => {
  let edge, excess, face, root, square;
  excess = (difference_of_products(R, d, a, a) / R);
  square = math.where((excess > 0.0), ((a - r) * (a + r)), difference_of_products(R, d, r, r));
  root = Math.sqrt(math.maximum(square, 0.0));
  face = (((2 * E_star) * root) / (Math.PI * R));
  edge = math.where((excess > 0.0), (((E_star / Math.PI) * excess) / Math.sqrt(((a - r) * (a + r)))), 0.0);
  return math.where((r <= a), (face + edge), 0.0);
};

const _pressure = (r, d, a, R, E_star) => {
  let v11, v12, v13, v15, v16, v24, v25, v27, v28, v39, v41, v44, v45, v47, v49, v5, v50, v6, v61, v9;
  if (((r > 1e-30) && (r < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R > 1e-30) && (R < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((r <= a)) {
      v5 = (R * d);
      v6 = (a * a);
      v9 = (134217729.0 * R);
      v11 = (v9 - (v9 - R));
      v12 = (R - v11);
      v13 = (134217729.0 * d);
      v15 = (v13 - (v13 - d));
      v16 = (d - v15);
      v24 = (((((v11 * v15) - v5) + (v11 * v16)) + (v12 * v15)) + (v12 * v16));
      v25 = (134217729.0 * a);
      v27 = (v25 - (v25 - a));
      v28 = (a - v27);
      v39 = (((v5 - v6) + (v24 - (((((v27 * v27) - v6) + (v27 * v28)) + (v28 * v27)) + (v28 * v28)))) / R);
      v41 = (v39 > 0.0);
      v44 = ((a - r) * (a + r));
      if (v41) {
        v61 = v44;
      } else {
        v45 = (r * r);
        v47 = (134217729.0 * r);
        v49 = (v47 - (v47 - r));
        v50 = (r - v49);
        v61 = ((v5 - v45) + (v24 - (((((v49 * v49) - v45) + (v49 * v50)) + (v50 * v49)) + (v50 * v50))));
      }
      return ((((2.0 * E_star) * Math.sqrt((((v61 > 0.0) || (v61 !== v61)) ? v61 : 0.0))) / (3.141592653589793 * R)) + (v41 ? (((E_star / 3.141592653589793) * v39) / Math.sqrt(v44)) : 0.0));
    }
    return 0.0;
  }
  return _pressure_of_capped_cylinder(r, d, a, R, E_star);
};

const pressure = (r, d, a, R, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < R && R < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _pressure(r, d, a, R, E_star) : 0.0) : NaN);
};

const OUTSIDE_2 = [[0.26666666666720995, 3759.725330928701, 8082.413158212496, 5044.821368830373, (-85.27694715374247), (-1070.7082873491413), (-332.23363563146734), (-32.15553480435792), (-0.7327347664453868)], [1.0, 14099.684276696918, 40380.01430284195, 44404.005348491315, 23553.080984642995, 6202.125133759036, 746.8124983579742, 32.12935731379798, 0.21387262524856868], 0.6666666666666666];

const _half_tangent = (r, a) => {
  return (a / (r + Math.sqrt(((r - a) * (r + a)))));
};

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

const from_start = (v, top, bottom, start) => {
  return (start + (v * rational(v, top, bottom)));
};

const beside = (r, a, kernel) => {
  let tangent;
  tangent = _half_tangent(r, a);
  return ((a / r) * from_start((tangent * tangent), ...kernel));
};

const _profile = (r, a, R) => {
  return math.where((r <= a), (Math.pow(r, 2) / (2 * R)), NaN);
};

const _displacement_of_capped_cylinder = (r, d, a, R) => {
  let angle, edge, excess, face, rho;
  excess = (difference_of_products(R, d, a, a) / R);
  rho = math.minimum(Math.sqrt((R * d)), a);
  face = (math.minimum(d, (Math.pow(a, 2) / R)) * beside(r, rho, OUTSIDE_2));
  angle = Math.atan2(a, Math.sqrt(((r - a) * (r + a))));
  edge = math.where((excess > 0.0), (math.maximum(excess, 0.0) * angle), 0.0);
  return math.where((r > rho), ((2 / Math.PI) * (face + edge)), (d - _profile(r, a, R)));
};

const _displacement = (r, d, a, R) => {
  let v10, v11, v12, v14, v15, v24, v26, v27, v38, v39, v4, v40, v43, v5, v50, v52, v8;
  if (((r > 1e-30) && (r < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R > 1e-30) && (R < 1e+30))) {
    v4 = (R * d);
    v39 = Math.sqrt(v4);
    v40 = (((v39 < a) || (v39 !== v39)) ? v39 : a);
    if ((r > v40)) {
      v5 = (a * a);
      v8 = (134217729.0 * R);
      v10 = (v8 - (v8 - R));
      v11 = (R - v10);
      v12 = (134217729.0 * d);
      v14 = (v12 - (v12 - d));
      v15 = (d - v14);
      v24 = (134217729.0 * a);
      v26 = (v24 - (v24 - a));
      v27 = (a - v26);
      v38 = (((v4 - v5) + ((((((v10 * v14) - v4) + (v10 * v15)) + (v11 * v14)) + (v11 * v15)) - (((((v26 * v26) - v5) + (v26 * v27)) + (v27 * v26)) + (v27 * v27)))) / R);
      v43 = ((a * a) / R);
      v50 = (v40 / (r + Math.sqrt(((r - v40) * (r + v40)))));
      v52 = (v50 * v50);
      return (0.6366197723675814 * (((((d < v43) || (d !== d)) ? d : v43) * ((v40 / r) * (0.6666666666666666 + (v52 * ((((((((((((((((((-0.7327347664453868) * v52) + (-32.15553480435792)) * v52) + (-332.23363563146734)) * v52) + (-1070.7082873491413)) * v52) + (-85.27694715374247)) * v52) + 5044.821368830373) * v52) + 8082.413158212496) * v52) + 3759.725330928701) * v52) + 0.26666666666720995) / ((((((((((((((((0.21387262524856868 * v52) + 32.12935731379798) * v52) + 746.8124983579742) * v52) + 6202.125133759036) * v52) + 23553.080984642995) * v52) + 44404.005348491315) * v52) + 40380.01430284195) * v52) + 14099.684276696918) * v52) + 1.0)))))) + ((v38 > 0.0) ? ((((v38 > 0.0) || (v38 !== v38)) ? v38 : 0.0) * Math.atan2(a, Math.sqrt(((r - a) * (r + a))))) : 0.0)));
    }
    return (d - ((r <= a) ? ((r * r) / (2.0 * R)) : NaN));
  }
  return _displacement_of_capped_cylinder(r, d, a, R);
};

const displacement = (r, d, a, R) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < R && R < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _displacement(r, d, a, R) : 0.0) : NaN);
};

const _stiffness_of_capped_cylinder = (d, a, R, E_star) => {
  let rho;
  rho = math.minimum(Math.sqrt((R * d)), a);
  return ((2 * E_star) * rho);
};

const _stiffness = (d, a, R, E_star) => {
  let v5;
  if (((d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R > 1e-30) && (R < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v5 = Math.sqrt((R * d));
    return ((2.0 * E_star) * (((v5 < a) || (v5 !== v5)) ? v5 : a));
  }
  return _stiffness_of_capped_cylinder(d, a, R, E_star);
};

const stiffness = (d, a, R, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < R && R < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _stiffness(d, a, R, E_star) : NaN);
};

const _depth_from_force_of_capped_cylinder = (F, a, R, E_star) => {
  let above, below, edge;
  edge = (((4 * E_star) / (3 * R)) * Math.pow(a, 3));
  below = Math.cbrt(((9 * Math.pow(F, 2)) / ((16 * Math.pow(E_star, 2)) * R)));
  above = ((F / ((2 * E_star) * a)) + (Math.pow(a, 2) / (3 * R)));
  return math.where((edge > F), below, above);
};

const _depth_from_force = (F, a, R, E_star) => {
  let v10, v7;
  if (((F > 1e-30) && (F < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R > 1e-30) && (R < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v7 = (3.0 * R);
    v10 = (a * a);
    if (((((4.0 * E_star) / v7) * (a * v10)) > F)) {
      return Math.cbrt(((9.0 * (F * F)) / ((16.0 * (E_star * E_star)) * R)));
    }
    return ((F / ((2.0 * E_star) * a)) + (v10 / v7));
  }
  return _depth_from_force_of_capped_cylinder(F, a, R, E_star);
};

const depth_from_force = (F, a, R, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < R && R < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force(F, a, R, E_star) : NaN);
};

const formulas = {
  "U": (v) => energy(v.d, v.a, v.R, v.E_star),
  "Fr": (v) => load_within(v.r, v.d, v.a, v.R, v.E_star),
  "F": (v) => force(v.d, v.a, v.R, v.E_star),
  "p": (v) => pressure(v.r, v.d, v.a, v.R, v.E_star),
  "w": (v) => displacement(v.r, v.d, v.a, v.R),
  "k": (v) => stiffness(v.d, v.a, v.R, v.E_star),
  "dF": (v) => depth_from_force(v.F, v.a, v.R, v.E_star),
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
   "name": "R",
   "tex": "R",
   "meaning": "radius of curvature",
   "unit": "m",
   "rule": "R > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 0.5
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
   "value": 5000.0
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
    "R",
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
    "R",
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
    "R",
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
    "R",
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
    "a",
    "R"
   ],
   "unit": "m",
   "place": "outside",
   "suffix": "w"
  },
  "k": {
   "gives": "stiffness",
   "needs": [
    "d",
    "a",
    "R",
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
    "R",
    "E_star"
   ],
   "unit": "m",
   "place": "",
   "suffix": "dF"
  }
 },
 "place": "r"
}, evaluate: formulas };
})();
