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

const _finite = (name, modulus) => {
  let array;
  array = modulus;
  return math.where((array === Infinity), 1.0, array);
};

const _effective_modulus = (E_1, nu_1, E_2, nu_2) => {
  if (((E_1 > 1e-30) && (E_1 < 1e+30) && (nu_1 > 1e-30) && (nu_1 < 0.5) && (E_2 > 1e-30) && (E_2 < 1e+30) && (nu_2 > 1e-30) && (nu_2 < 0.5))) {
    return (1.0 / ((((1.0 - nu_1) * (1.0 + nu_1)) / E_1) + (((1.0 - nu_2) * (1.0 + nu_2)) / E_2)));
  }
  return NaN;
};

const effective_modulus = (E_1, nu_1, E_2, nu_2) => {
  if ((!((0.0 < _finite('E_1', E_1) && _finite('E_1', E_1) < Infinity) && (-1.0 < nu_1 && nu_1 <= 0.5) && (0.0 < _finite('E_2', E_2) && _finite('E_2', E_2) < Infinity) && (-1.0 < nu_2 && nu_2 <= 0.5)))) {
    return NaN;
  }
  return _effective_modulus(E_1, nu_1, E_2, nu_2);
};

const _transversely_isotropic_modulus_of_materials = (C_11, C_33, C_13, C_44) => {
  let high, low, mean;
  mean = (C_11 * Math.sqrt((C_33 / C_11)));
  [high, low] = [(mean + C_13), (mean - C_13)];
  return ((2.0 * high) * Math.sqrt(((C_44 / C_11) * (low / (high + (2.0 * C_44))))));
};

const _transversely_isotropic_modulus = (C_11, C_33, C_13, C_44) => {
  let v6, v7;
  if (((C_11 > 1e-30) && (C_11 < 1e+30) && (C_33 > 1e-30) && (C_33 < 1e+30) && (C_13 > 1e-30) && (C_13 < 1e+30) && (C_44 > 1e-30) && (C_44 < 1e+30))) {
    v6 = (C_11 * Math.sqrt((C_33 / C_11)));
    v7 = (v6 + C_13);
    return ((2.0 * v7) * Math.sqrt(((C_44 / C_11) * ((v6 - C_13) / (v7 + (2.0 * C_44))))));
  }
  return _transversely_isotropic_modulus_of_materials(C_11, C_33, C_13, C_44);
};

const transversely_isotropic_modulus = (C_11, C_33, C_13, C_44) => {
  if ((!((0.0 < C_11 && C_11 < Infinity) && (0.0 < C_33 && C_33 < Infinity) && (-inf < C_13 && C_13 < Infinity) && (0.0 < C_44 && C_44 < Infinity) && (Math.abs(C_13) < (Math.sqrt(C_11) * Math.sqrt(C_33)))))) {
    return NaN;
  }
  return _transversely_isotropic_modulus(C_11, C_33, C_13, C_44);
};

const _effective_shear_modulus = (E_1, nu_1, E_2, nu_2) => {
  if (((E_1 > 1e-30) && (E_1 < 1e+30) && (nu_1 > 1e-30) && (nu_1 < 0.5) && (E_2 > 1e-30) && (E_2 < 1e+30) && (nu_2 > 1e-30) && (nu_2 < 0.5))) {
    return (2.0 / ((((2.0 - nu_1) * (1.0 + nu_1)) / E_1) + (((2.0 - nu_2) * (1.0 + nu_2)) / E_2)));
  }
  return NaN;
};

const effective_shear_modulus = (E_1, nu_1, E_2, nu_2) => {
  if ((!((0.0 < _finite('E_1', E_1) && _finite('E_1', E_1) < Infinity) && (-1.0 < nu_1 && nu_1 <= 0.5) && (0.0 < _finite('E_2', E_2) && _finite('E_2', E_2) < Infinity) && (-1.0 < nu_2 && nu_2 <= 0.5)))) {
    return NaN;
  }
  return _effective_shear_modulus(E_1, nu_1, E_2, nu_2);
};

const gamma = (x) => {
  return math.vectorize(math.gamma)(x);
};

const _h_N = (k, nu) => {
  let beta, cosine, gammas, punch;
  beta = Math.sqrt((((1.0 + k) * ((1.0 - nu) - (k * nu))) / (1.0 - nu)));
  gammas = (gamma((((3.0 + k) + beta) / 2.0)) * gamma((((3.0 + k) - beta) / 2.0)));
  cosine = Math.sin(((Math.PI * (1.0 - Math.abs(k))) / 2.0));
  punch = (Math.pow(((1.0 + k) * gamma((1.0 + (k / 2.0)))), 2) * cosine);
  return (punch / ((beta * Math.sin(((Math.PI * beta) / 2.0))) * gammas));
};

const _graded_modulus = (E_0, c_0, k, nu) => {
  return ((_h_N(k, nu) * E_0) / (((1.0 - nu) * (1.0 + nu)) * Math.pow(c_0, k)));
};

const graded_modulus = (E_0, c_0, k, nu) => {
  if ((!((0.0 < E_0 && E_0 < Infinity) && (0.0 < c_0 && c_0 < Infinity) && (-1.0 < k && k < 1.0) && (-1.0 < nu && nu <= 0.5)))) {
    return NaN;
  }
  return _graded_modulus(E_0, c_0, k, nu);
};

const h_N = (k, nu) => {
  if ((!((-1.0 < k && k < 1.0) && (-1.0 < nu && nu <= 0.5)))) {
    return NaN;
  }
  return _h_N(k, nu);
};

const _tabor_of_materials = (R, E_star, dgamma, z_0) => {
  return Math.cbrt(((R / z_0) * Math.pow(((dgamma / E_star) / z_0), 2)));
};

const _tabor = (R, E_star, dgamma, z_0) => {
  let v6;
  if (((R > 1e-30) && (R < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30) && (z_0 > 1e-30) && (z_0 < 1e+30))) {
    v6 = ((dgamma / E_star) / z_0);
    return Math.cbrt(((R / z_0) * (v6 * v6)));
  }
  return _tabor_of_materials(R, E_star, dgamma, z_0);
};

const tabor = (R, E_star, dgamma, z_0) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity) && (0.0 < z_0 && z_0 < Infinity)))) {
    return NaN;
  }
  return _tabor(R, E_star, dgamma, z_0);
};

const _maugis_lambda_of_materials = (R, E_star, dgamma, sigma_0) => {
  return Math.cbrt((((4.5 / Math.PI) * Math.pow((sigma_0 / E_star), 2)) * ((R * sigma_0) / dgamma)));
};

const _maugis_lambda = (R, E_star, dgamma, sigma_0) => {
  let v4;
  if (((R > 1e-30) && (R < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30) && (sigma_0 > 1e-30) && (sigma_0 < 1e+30))) {
    v4 = (sigma_0 / E_star);
    return Math.cbrt(((1.432394487827058 * (v4 * v4)) * ((R * sigma_0) / dgamma)));
  }
  return _maugis_lambda_of_materials(R, E_star, dgamma, sigma_0);
};

const maugis_lambda = (R, E_star, dgamma, sigma_0) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity) && (0.0 < sigma_0 && sigma_0 < Infinity)))) {
    return NaN;
  }
  return _maugis_lambda(R, E_star, dgamma, sigma_0);
};

const once = {  };
const formulas = {
  "E_star": (v) => effective_modulus(v.E_1, v.nu_1, v.E_2, v.nu_2),
  "E_ti": (v) => transversely_isotropic_modulus(v.C_11, v.C_33, v.C_13, v.C_44),
  "G_star": (v) => effective_shear_modulus(v.E_1, v.nu_1, v.E_2, v.nu_2),
  "H": (v) => graded_modulus(v.E_0, v.c_0, v.k, v.nu),
  "h_N": (v) => h_N(v.k, v.nu),
  "mu_T": (v) => tabor(v.R, v.E_star, v.dgamma, v.z_0),
  "lambda_M": (v) => maugis_lambda(v.R, v.E_star, v.dgamma, v.sigma_0),
};
window.calculator = { ...{
 "fields": [
  {
   "name": "nu_1",
   "tex": "\\nu_1",
   "meaning": "Poisson ratio of the first body",
   "unit": "1",
   "rule": "-1 < nu_1 <= 1/2",
   "low": -1.0,
   "high": 0.5,
   "closed": "high",
   "value": ""
  },
  {
   "name": "E_2",
   "tex": "E_2",
   "meaning": "Young's modulus of the second body",
   "unit": "Pa",
   "rule": "E_2 > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": ""
  },
  {
   "name": "nu_2",
   "tex": "\\nu_2",
   "meaning": "Poisson ratio of the second body",
   "unit": "1",
   "rule": "-1 < nu_2 <= 1/2",
   "low": -1.0,
   "high": 0.5,
   "closed": "high",
   "value": ""
  },
  {
   "name": "C_11",
   "tex": "C_{11}",
   "meaning": "elastic constant",
   "unit": "Pa",
   "rule": "C_11 > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": ""
  },
  {
   "name": "C_33",
   "tex": "C_{33}",
   "meaning": "elastic constant",
   "unit": "Pa",
   "rule": "C_33 > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": ""
  },
  {
   "name": "C_13",
   "tex": "C_{13}",
   "meaning": "elastic constant of both directions",
   "unit": "Pa",
   "rule": "",
   "low": null,
   "high": null,
   "closed": "",
   "value": ""
  },
  {
   "name": "C_44",
   "tex": "C_{44}",
   "meaning": "shear modulus in planes across the surface",
   "unit": "Pa",
   "rule": "C_44 > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": ""
  },
  {
   "name": "E_0",
   "tex": "E_0",
   "meaning": "Young's modulus at the depth of reference",
   "unit": "Pa",
   "rule": "E_0 > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": ""
  },
  {
   "name": "c_0",
   "tex": "c_0",
   "meaning": "depth of reference of the graded half-space",
   "unit": "m",
   "rule": "c_0 > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": ""
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
   "value": ""
  },
  {
   "name": "z_0",
   "tex": "z_0",
   "meaning": "distance of the surfaces at which they do not attract",
   "unit": "m",
   "rule": "z_0 > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": ""
  },
  {
   "name": "sigma_0",
   "tex": "\\sigma_0",
   "meaning": "greatest stress of the attraction",
   "unit": "Pa",
   "rule": "sigma_0 > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
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
   "value": 3300000.0
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
   "value": ""
  },
  {
   "name": "k",
   "tex": "k",
   "meaning": "exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space",
   "unit": "1",
   "rule": "-1 < k < 1",
   "low": -1.0,
   "high": 1.0,
   "closed": "",
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
   "name": "E_1",
   "tex": "E_1",
   "meaning": "Young's modulus of the first body",
   "unit": "Pa",
   "rule": "E_1 > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 2000000.0
  }
 ],
 "state": [],
 "formulas": {
  "E_star": {
   "gives": "E_star",
   "needs": [
    "E_1",
    "nu_1",
    "E_2",
    "nu_2"
   ],
   "unit": "Pa",
   "place": "",
   "suffix": "E_star",
   "medium": 0
  },
  "E_ti": {
   "gives": "E_star",
   "needs": [
    "C_11",
    "C_33",
    "C_13",
    "C_44"
   ],
   "unit": "Pa",
   "place": "",
   "suffix": "E_ti",
   "medium": 0
  },
  "G_star": {
   "gives": "G_star",
   "needs": [
    "E_1",
    "nu_1",
    "E_2",
    "nu_2"
   ],
   "unit": "Pa",
   "place": "",
   "suffix": "G_star",
   "medium": 0
  },
  "H": {
   "gives": "H",
   "needs": [
    "E_0",
    "c_0",
    "k",
    "nu"
   ],
   "unit": "Pa m^(-k)",
   "place": "",
   "suffix": "H",
   "medium": 0
  },
  "h_N": {
   "gives": "h_N",
   "needs": [
    "k",
    "nu"
   ],
   "unit": "1",
   "place": "",
   "suffix": "h_N",
   "medium": 0
  },
  "mu_T": {
   "gives": "mu_T",
   "needs": [
    "R",
    "E_star",
    "dgamma",
    "z_0"
   ],
   "unit": "1",
   "place": "",
   "suffix": "mu_T",
   "medium": 0
  },
  "lambda_M": {
   "gives": "lambda_M",
   "needs": [
    "R",
    "E_star",
    "dgamma",
    "sigma_0"
   ],
   "unit": "1",
   "place": "",
   "suffix": "lambda_M",
   "medium": 0
  }
 },
 "place": "r"
}, evaluate: formulas };
})();
