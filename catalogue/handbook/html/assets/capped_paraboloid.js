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

const depth = (a, R1, R2, b) => {
  if ((a < b)) {
    return ((a * a) / R1);
  }
  return ((a * (a + (((R1 - R2) / R2) * Math.sqrt(((a - b) * (a + b)))))) / R1);
};

const force = (a, R1, R2, b, E_star) => {
  let v11, v12, v8;
  v8 = (3.0 * R1);
  v11 = (a * a);
  v12 = (a * v11);
  if ((a < b)) {
    return (((4.0 * E_star) / v8) * v12);
  }
  return (((2.0 * E_star) / v8) * ((2.0 * v12) + ((((R1 - R2) / R2) * ((2.0 * v11) + (b * b))) * Math.sqrt(((a - b) * (a + b))))));
};

const stiffness = (a, E_star, R1 = 1.0, R2 = 1.0, b = 1.0) => {
  return ((2.0 * E_star) * a);
};

const _mean_pressure = (a, R1, R2, b, E_star) => {
  let beyond, root, tip;
  tip = (((4 * E_star) / ((3 * Math.PI) * R1)) * a);
  root = Math.sqrt(((a - b) * (a + b)));
  beyond = (((2 * E_star) / ((3 * Math.PI) * R1)) * ((2 * a) + ((((R1 - R2) * ((2 * Math.pow(a, 2)) + Math.pow(b, 2))) * root) / (Math.pow(a, 2) * R2))));
  return math.where((a < b), tip, beyond);
};

const mean_pressure = (a, R1, R2, b, E_star) => {
  let v20, v8, value;
  v8 = (9.42477796076938 * R1);
  if ((a < b)) {
    return (((4.0 * E_star) / v8) * a);
  }
  v20 = (a * a);
  value = (((2.0 * E_star) / v8) * ((2.0 * a) + ((((R1 - R2) * ((2.0 * v20) + (b * b))) * Math.sqrt(((a - b) * (a + b)))) / (v20 * R2))));
  if ((((value > 1e-200) && (value < 1e+200)) || (1e-200 < (-value) && (-value) < 1e+200))) {
    return value;
  }
  return _mean_pressure(a, R1, R2, b, E_star);
};

const _slope_beyond = (t, root, R1, R2, b) => {
  let v10, v8;
  v8 = (R1 - R2);
  v10 = (R1 * R2);
  return ((((2.0 * t) / R1) + (((2.0 * v8) / v10) * root)) + (((b * b) * v8) / (v10 * root)));
};

const _depth_beyond = (a, root, R1, R2) => {
  return ((a * (a + (((R1 - R2) / R2) * root))) / R1);
};

const nth_root = (x, n, more = 0) => {
  let degree, y;
  degree = (n + more);
  y = Math.pow(x, (1.0 / degree));
  return (((x > 0.0) & (x < Infinity)) ? (y + (y * (((x / (Math.pow(y, n) * Math.pow(y, more))) - 1.0) / degree))) : y);
};

const ROUNDING = 1.1102230246251565e-16;

const LOST = 16.0;

const above_noise = (difference, rate, size, power, least) => {
  let known, tiny;
  tiny = (ROUNDING * size);
  if ((power == null)) {
    known = math.maximum(difference, tiny);
  } else {
    known = ((difference > (LOST * tiny)) ? difference : math.maximum((rate / power), (ROUNDING * tiny)));
  }
  return [known, math.maximum((rate / known), least)];
};

const _excess = (t, y, rate, base, small) => {
  return above_noise((y - base), (rate * ((t * t) / (1.0 + (t * t)))), base, small, 1.0);
};

const _joined = (x, small, large, blend) => {
  let first, last;
  [first, last] = [...[small, large]].map(([c, e]) => ((blend / e) * (x - Math.log(c))));
  return Math.exp(((math.maximum(first, last) + Math.log1p(Math.exp((-Math.abs((first - last)))))) / blend));
};

const joining = (like, slope, small, large) => {
  let share, x;
  x = Math.log(like);
  if ((small === large)) {
    return Math.exp((x / ((x < 0.0) ? slope : large)));
  }
  share = math.minimum(math.maximum(((slope - small) / (large - small)), 1e-12), (1.0 - 1e-12));
  return _joined(x, [(1.0 / (1.0 - share)), small], [(1.0 / share), large], (0.5 * (small + large)));
};

const leaving_power = (like, share, tip, small, large) => {
  let v15, v17, v19, v21, v23, v34, v36, v39, v42, v5, v7;
  v5 = math.log(like);
  v7 = (1.0 - share);
  v17 = math.log(share);
  v21 = math.log((((v7 > 1e-300) || (v7 !== v7)) ? v7 : 1e-300));
  if ((v5 < 0.0)) {
    v15 = ((-0.5) * (2.0 + small));
    v19 = ((v15 / 2.0) * (v5 - v17));
    v23 = ((v15 / small) * (v5 - v21));
    return Math.exp((((((v19 > v23) || (v19 !== v19)) ? v19 : v23) + math.log1p(Math.exp((-Math.abs((v19 - v23)))))) / v15));
  }
  v34 = (((v5 > 0.0) || (v5 !== v5)) ? v5 : 0.0);
  v36 = ((-0.5) * (tip + large));
  v39 = ((v36 / tip) * (v34 - v17));
  v42 = ((v36 / large) * (v34 - v21));
  return Math.exp((((((v39 > v42) || (v39 !== v39)) ? v39 : v42) + math.log1p(Math.exp((-Math.abs((v39 - v42)))))) / v36));
};

const _start = (curve, more, base, b, tip, powers, leaving = null) => {
  let one, slope;
  if (((powers == null) && (leaving == null))) {
    return math.ones_like(more);
  }
  [one, slope] = _excess(1.0, ...curve((b * Math.sqrt(2.0)), b), base, (powers && powers[0]));
  if ((powers != null)) {
    return joining((more / one), slope, ...powers);
  }
  return leaving_power((more / one), ((base / one) * (Math.pow(2.0, (tip / 2.0)) - 1.0)), tip, ...(leaving || []));
};

const NOISE = 5.551115123125783e-16;

const _missed = (value, y) => {
  let v3, v6;
  v3 = ((value - y) / y);
  v6 = (Math.abs(v3) < 0.5);
  if (v6) {
    return math.log1p((v6 ? v3 : 0.0));
  }
  return math.log((value / y));
};

const ITERATIONS = 120;

const SETTLED = 1e-09;

const PATIENCE = 8;

const _safe = (position, step, error, exponents, low, high, late) => {
  let aimed, ends, first, from_, last, least, met, middle, most, signs, to, within;
  [least, most] = exponents;
  error = math.minimum(math.maximum(error, (-1500.0)), 1500.0);
  ends = [(position + (error / most)), (position + ((error * Math.pow(2.0, Math.max(late, 0))) / math.maximum(least, 1e-300)))];
  [first, last] = [(math.minimum(...ends) - 1e-09), (math.maximum(...ends) + 1e-09)];
  aimed = math.minimum(math.maximum((position + step), first), last);
  [from_, to] = [math.maximum(first, low), math.minimum(last, high)];
  met = Number.isFinite((high - low));
  signs = ((from_ > to) | (met & (late >= 0)));
  middle = (((signs ? low : from_) / 2.0) + ((signs ? high : to) / 2.0));
  if ((late >= 0)) {
    aimed = (met ? (position + step) : aimed);
  }
  within = (((low <= aimed) & (aimed <= high)) & ((late < 0) || ((late % 2) === 0)));
  return ((within ? aimed : middle) - position);
};

const _step = (step, before, slope_before, error, slope) => {
  let v10, v14, v23, v5, v9;
  v5 = (error / slope);
  v9 = ((before === error) ? Infinity : (before - error));
  v10 = (step / v9);
  v14 = (((1.0 / slope) - v10) / v9);
  v23 = ((error * error) * (v14 + (((v14 - ((v10 - (1.0 / slope_before)) / v9)) / v9) * before)));
  return (v5 + ((Math.abs(v23) < (0.5 * Math.abs(v5))) ? v23 : 0.0));
};

const _last_step = (t, value, y, slope) => {
  let v7;
  v7 = ((t * ((value - y) / y)) / slope);
  if ((Math.abs(v7) < (0.001 * t))) {
    return v7;
  }
  return 0.0;
};

const POLISHING = 3;

const inverse = (curve, value, start, exponents, largest = Infinity, share = null, smooth = false, noise = null) => {
  let _, before, change, close, error, high, iteration, left, low, moved, position, root, slope, slope_before, solvable, step, t, y;
  if (false) {
    return start.root(curve, value, largest, exponents);
  }
  t = math.minimum(start, largest);
  position = Math.log(t);
  [y, slope] = curve(t);
  error = _missed(value, y);
  [low, high] = [math.full(position, (-Infinity)), math.full(position, Math.log(largest))];
  step = (error / slope);
  close = ((noise == null) ? (ROUNDING * value) : noise);
  solvable = (((value > 0.0) & (value < Infinity)) & (y === y));
  for (iteration of math.range(ITERATIONS)) {
    left = (solvable & math.logical_not((Math.abs(error) <= (SETTLED * math.minimum(slope, 1.0)))));
    left = (left & math.logical_not((Math.abs((value - y)) <= close)));
    if ((share != null)) {
      moved = math.maximum(share(t), share(math.minimum((t * Math.exp(math.minimum(step, 700.0))), largest)));
      left = (left & math.logical_not(((Math.abs(error) * moved) <= ((4.0 * ROUNDING) * slope))));
    }
    if ((!Boolean(left))) {
      break;
    }
    low = ((error > 0.0) ? math.maximum(low, position) : low);
    high = ((error < 0.0) ? math.minimum(high, position) : high);
    step = _safe(position, step, error, exponents, low, high, (iteration - PATIENCE));
    position = (left ? (position + step) : position);
    t = (left ? Math.exp(position) : t);
    [before, slope_before] = [error, slope];
    [y, slope] = curve(t);
    y = ((y === y) ? y : Infinity);
    error = _missed(value, y);
    step = _step(step, before, slope_before, error, slope);
  }
  change = _last_step(t, value, y, slope);
  t = (t + change);
  if ((!smooth)) {
    for (_ of math.range(POLISHING)) {
      if ((!Boolean((Math.abs(change) > (1e-14 * t))))) {
        break;
      }
      change = _last_step(t, value, ...curve(t));
      t = (t + change);
    }
  }
  root = ((value >= 0.0) ? math.minimum(t, largest) : NaN);
  return ((value === 0.0) ? 0.0 : ((value === Infinity) ? Infinity : root));
};

const _beyond = (curve, value, base, b, tip, powers, leaving = null) => {
  let excess, small, start, t;
  small = (leaving ? null : (powers || [2.0])[0]);
  excess = (t) => {
    return _excess(t, ...curve((b * Math.sqrt((1.0 + (t * t)))), (b * t)), base, small);
  };
  start = _start(curve, (value - base), base, b, tip, powers, leaving);
  t = inverse(excess, (value - base), start, [1.0, Infinity], undefined, undefined, true, (NOISE * value));
  return (b * Math.sqrt((1.0 + (t * t))));
};

const inverse_beyond = (curve, value, b, tip, powers = null, leaving = null) => {
  let above, base, high, radius;
  base = curve(b, math.at_break(b))[0];
  above = (value > base);
  radius = (b * nth_root(((above ? base : value) / base), tip));
  if ((!Boolean(above))) {
    return radius;
  }
  high = (above ? value : (2.0 * base));
  return (above ? _beyond(curve, high, base, b, tip, powers, leaving) : radius);
};

const _radius_from_depth = (d, R1, R2, b) => {
  let curve;
  curve = (a, root) => {
    let rate;
    rate = (a * _slope_beyond(a, root, R1, R2, b));
    return [_depth_beyond(a, root, R1, R2), rate];
  };
  return inverse_beyond(curve, d, b, 2.0, undefined, [1.0, 2.0]);
};

const radius_from_depth = (d, R1, R2, b) => {
  return _radius_from_depth(d, R1, R2, b);
};

const _force_beyond = (a, root, R1, R2, b, E_star) => {
  let v11;
  v11 = (a * a);
  return (((2.0 * E_star) / (3.0 * R1)) * ((2.0 * (a * v11)) + ((((R1 - R2) / R2) * ((2.0 * v11) + (b * b))) * root)));
};

const _radius_from_force = (F, R1, R2, b, E_star) => {
  let curve;
  curve = (a, root) => {
    let rate;
    rate = (((2 * E_star) * Math.pow(a, 2)) * _slope_beyond(a, root, R1, R2, b));
    return [_force_beyond(a, root, R1, R2, b, E_star), rate];
  };
  return inverse_beyond(curve, F, b, 3.0, undefined, [1.0, 3.0]);
};

const radius_from_force = (F, R1, R2, b, E_star) => {
  return _radius_from_force(F, R1, R2, b, E_star);
};

const _depth = (a, R1, R2, b) => {
  if ((a < b)) {
    return ((a * a) / R1);
  }
  return ((a * (a + (((R1 - R2) / R2) * math.sqrt(((a - b) * (a + b)))))) / R1);
};

const _force = (a, R1, R2, b, E_star) => {
  let v11, v12, v8;
  v8 = (3.0 * R1);
  v11 = (a * a);
  v12 = (a * v11);
  if ((a < b)) {
    return (((4.0 * E_star) / v8) * v12);
  }
  return (((2.0 * E_star) / v8) * ((2.0 * v12) + ((((R1 - R2) / R2) * ((2.0 * v11) + (b * b))) * math.sqrt(((a - b) * (a + b))))));
};

const _force_from_depth = (d, R1, R2, b, E_star) => {
  let a, change;
  a = _radius_from_depth(d, R1, R2, b);
  change = (((a > 0.0) & (a < Infinity)) ? (((2 * E_star) * a) * (d - _depth(a, R1, R2, b))) : 0.0);
  return (_force(a, R1, R2, b, E_star) + change);
};

const force_from_depth = (d, R1, R2, b, E_star) => {
  return _force_from_depth(d, R1, R2, b, E_star);
};

const _depth_from_force = (F, R1, R2, b, E_star) => {
  let a, change;
  a = _radius_from_force(F, R1, R2, b, E_star);
  change = (((a > 0.0) & (a < Infinity)) ? ((F - _force(a, R1, R2, b, E_star)) / ((2 * E_star) * a)) : 0.0);
  return (_depth(a, R1, R2, b) + change);
};

const depth_from_force = (F, R1, R2, b, E_star) => {
  return _depth_from_force(F, R1, R2, b, E_star);
};

const depth_of_capped_paraboloid = (a, R1, R2, b, E_star, dgamma) => {
  return (((a < b) ? ((a * a) / R1) : ((a * (a + (((R1 - R2) / R2) * Math.sqrt(((a - b) * (a + b)))))) / R1)) - (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const force_of_capped_paraboloid = (a, R1, R2, b, E_star, dgamma) => {
  let v12, v13, v19, v9;
  v9 = (3.0 * R1);
  v12 = (a * a);
  v13 = (a * v12);
  v19 = (2.0 * E_star);
  return (((a < b) ? (((4.0 * E_star) / v9) * v13) : ((v19 / v9) * ((2.0 * v13) + ((((R1 - R2) / R2) * ((2.0 * v12) + (b * b))) * Math.sqrt(((a - b) * (a + b))))))) - ((v19 * a) * (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star)))));
};

const stick_force = (F, F_x, mu) => {
  let v10, v4;
  v4 = (F - (F_x / mu));
  v10 = ((Math.abs(v4) <= (2e-16 * F)) ? 0.0 : v4);
  if ((v10 >= 0.0)) {
    return v10;
  }
  return NaN;
};

const _stick_radius = (F_x, a, R1, R2, b, E_star, mu) => {
  let F;
  F = stick_force(_force(a, R1, R2, b, E_star), F_x, mu);
  return (((F_x === 0.0) & (a >= 0.0)) ? a : _radius_from_force(F, R1, R2, b, E_star));
};

const stick_radius = (F_x, a, R1, R2, b, E_star, mu) => {
  return _stick_radius(F_x, a, R1, R2, b, E_star, mu);
};

const full_slip_displacement = (a, R1, R2, b, E_star, G_star, mu) => {
  return ((mu * (E_star / G_star)) * ((a < b) ? ((a * a) / R1) : ((a * (a + (((R1 - R2) / R2) * Math.sqrt(((a - b) * (a + b)))))) / R1)));
};

const formulas = {
  "d": (v) => depth(v.a, v.R1, v.R2, v.b),
  "F": (v) => force(v.a, v.R1, v.R2, v.b, v.E_star),
  "k": (v) => stiffness(v.a, v.E_star, v.R1, v.R2, v.b),
  "pm": (v) => mean_pressure(v.a, v.R1, v.R2, v.b, v.E_star),
  "ad": (v) => radius_from_depth(v.d, v.R1, v.R2, v.b),
  "aF": (v) => radius_from_force(v.F, v.R1, v.R2, v.b, v.E_star),
  "Fd": (v) => force_from_depth(v.d, v.R1, v.R2, v.b, v.E_star),
  "dF": (v) => depth_from_force(v.F, v.R1, v.R2, v.b, v.E_star),
  "adh.d": (v) => depth_of_capped_paraboloid(v.a, v.R1, v.R2, v.b, v.E_star, v.dgamma),
  "adh.F": (v) => force_of_capped_paraboloid(v.a, v.R1, v.R2, v.b, v.E_star, v.dgamma),
  "tan.c": (v) => stick_radius(v.F_x, v.a, v.R1, v.R2, v.b, v.E_star, v.mu),
  "tan.us": (v) => full_slip_displacement(v.a, v.R1, v.R2, v.b, v.E_star, v.G_star, v.mu),
};
window.calculator = { ...{
 "fields": [
  {
   "name": "R1",
   "tex": "R_1",
   "meaning": "radius of curvature of the inner part",
   "unit": "m",
   "rule": "R1 > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 0.05
  },
  {
   "name": "R2",
   "tex": "R_2",
   "meaning": "radius of curvature of the outer part",
   "unit": "m",
   "rule": "R2 > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 0.02
  },
  {
   "name": "b",
   "tex": "b",
   "meaning": "radius at which the profile breaks",
   "unit": "m",
   "rule": "b > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 0.0003
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
   "name": "G_star",
   "tex": "G^{*}",
   "meaning": "effective shear modulus",
   "unit": "Pa",
   "rule": "G_star > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": ""
  },
  {
   "name": "mu",
   "tex": "\\mu",
   "meaning": "coefficient of friction",
   "unit": "1",
   "rule": "mu >= 0",
   "low": 0.0,
   "high": null,
   "closed": "low",
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
   "name": "F_x",
   "tex": "F_x",
   "meaning": "tangential force",
   "unit": "N",
   "rule": "",
   "low": null,
   "high": null,
   "closed": "",
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
   "value": 200.0
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
  "d": {
   "gives": "d",
   "needs": [
    "a",
    "R1",
    "R2",
    "b"
   ],
   "unit": "m",
   "place": "",
   "suffix": "d"
  },
  "F": {
   "gives": "F",
   "needs": [
    "a",
    "R1",
    "R2",
    "b",
    "E_star"
   ],
   "unit": "N",
   "place": "",
   "suffix": "F"
  },
  "k": {
   "gives": "stiffness",
   "needs": [
    "a",
    "E_star",
    "R1",
    "R2",
    "b"
   ],
   "unit": "N/m",
   "place": "",
   "suffix": "k"
  },
  "pm": {
   "gives": "p_mean",
   "needs": [
    "a",
    "R1",
    "R2",
    "b",
    "E_star"
   ],
   "unit": "Pa",
   "place": "",
   "suffix": "pm"
  },
  "ad": {
   "gives": "a",
   "needs": [
    "d",
    "R1",
    "R2",
    "b"
   ],
   "unit": "m",
   "place": "",
   "suffix": "ad"
  },
  "aF": {
   "gives": "a",
   "needs": [
    "F",
    "R1",
    "R2",
    "b",
    "E_star"
   ],
   "unit": "m",
   "place": "",
   "suffix": "aF"
  },
  "Fd": {
   "gives": "F",
   "needs": [
    "d",
    "R1",
    "R2",
    "b",
    "E_star"
   ],
   "unit": "N",
   "place": "",
   "suffix": "Fd"
  },
  "dF": {
   "gives": "d",
   "needs": [
    "F",
    "R1",
    "R2",
    "b",
    "E_star"
   ],
   "unit": "m",
   "place": "",
   "suffix": "dF"
  },
  "adh.d": {
   "gives": "d",
   "needs": [
    "a",
    "R1",
    "R2",
    "b",
    "E_star",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": ""
  },
  "adh.F": {
   "gives": "F",
   "needs": [
    "a",
    "R1",
    "R2",
    "b",
    "E_star",
    "dgamma"
   ],
   "unit": "N",
   "place": "",
   "suffix": ""
  },
  "tan.c": {
   "gives": "c",
   "needs": [
    "F_x",
    "a",
    "R1",
    "R2",
    "b",
    "E_star",
    "mu"
   ],
   "unit": "m",
   "place": "",
   "suffix": ""
  },
  "tan.us": {
   "gives": "u_0",
   "needs": [
    "a",
    "R1",
    "R2",
    "b",
    "E_star",
    "G_star",
    "mu"
   ],
   "unit": "m",
   "place": "",
   "suffix": ""
  }
 },
 "place": "r"
}, evaluate: formulas };
})();
