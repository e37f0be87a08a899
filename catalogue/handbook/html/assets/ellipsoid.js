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

const HALVES = {8: [[0.019855071751231884, 0.05061426814518813], [0.10166676129318664, 0.11119051722668724], [0.2372337950418355, 0.15685332293894363], [0.4082826787521751, 0.181341891689181]], 16: [[0.005299532504175033, 0.013576229705877048], [0.02771248846338371, 0.031126761969323947], [0.06718439880608412, 0.04757925584124639], [0.12229779582249849, 0.06231448562776694], [0.19106187779867811, 0.07479799440828837], [0.2709916111713863, 0.08457825969750127], [0.35919822461037054, 0.09130170752246179], [0.4524937450811813, 0.09472530522753425]], 24: [[0.00240639000148932, 0.0061706148999936], [0.012635722014345251, 0.014265694314466832], [0.030862723998633622, 0.022138719408709904], [0.056792236497799485, 0.02964929245771839], [0.08999900701304854, 0.03667324070554015], [0.12993790421072282, 0.04309508076597664], [0.17595317403151223, 0.04880932605205694], [0.22728926430558022, 0.05372213505798282], [0.2831032461869774, 0.0577528340268628], [0.3424786601519183, 0.060835236463901696], [0.40444056626319186, 0.06291872817341415], [0.4679715535686972, 0.06396909767337608]], 32: [[0.0013680690752592183, 0.003509305004735048], [0.007194244227365833, 0.008137197365452835], [0.017618872206246784, 0.01269603265463103], [0.03254696203113015, 0.017136931456510716], [0.05183942211697394, 0.02141794901111334], [0.07531619313371501, 0.025499029631188087], [0.1027581020160288, 0.029342046739267772], [0.13390894062985517, 0.032911111388180925], [0.1684778665348924, 0.03617289705442425], [0.20614212137961885, 0.039096947893535156], [0.2465500455338853, 0.041655962113473374], [0.2893243619346823, 0.043826046502201906], [0.33406569885893617, 0.045586939347881945], [0.38035631887393145, 0.04692219954040228], [0.42776401920860174, 0.04781936003963743], [0.4758461671561308, 0.0482700442573639]], 64: [[0.0003474791321139303, 0.0008916403608482165], [0.0018299416140223604, 0.002073516630281234], [0.00449331426162784, 0.0032522289844891814], [0.008331873057687022, 0.0044233799131819735], [0.013336586105044517, 0.005584069730065564], [0.01949560017397314, 0.006731523948359321], [0.026794312570798593, 0.007863015238012359], [0.035215413934030215, 0.008975857887848672], [0.044738931460748595, 0.010067411576765104], [0.055342277002442944, 0.011135086904191627], [0.06700030092295359, 0.012176351284355437], [0.07968535187370981, 0.01318873485752733], [0.09336734243860122, 0.014169836307129742], [0.1080138205283293, 0.015117328536201239], [0.12359004636973406, 0.016028964177425775], [0.1400590749141946, 0.016902580918570803], [0.15738184347288336, 0.017736106628441193], [0.17551726437267132, 0.018527564270120023], [0.19442232241380336, 0.019275076589307813], [0.21405217689868297, 0.01997687056636017], [0.23436026799005272, 0.020631281621311764], [0.2552984271464735, 0.021236757561826795], [0.27681699137326793, 0.021791862264661725], [0.2988649210180042, 0.022295279081878283], [0.32138992083116596, 0.02274581396370907], [0.34433856400489454, 0.023142398290657208], [0.3676564188956163, 0.02348409140810501], [0.39128817812999644, 0.023770082857415154], [0.41517778978800357, 0.023999694298229155], [0.4392685903519397, 0.024172381117401477], [0.4635034391061005, 0.024287733720751714], [0.48782485366828776, 0.024345478504569862]], 128: [[8.755602643404277e-05, 0.00022469048014604518], [0.0004612700113120525, 0.0005229063396701744], [0.00113337568724299, 0.0008212515093345147], [0.0021036207325094065, 0.0011191442154813093], [0.003371443549893532, 0.0014163757357289956], [0.004936090754132808, 0.0017127630204551078], [0.006796628637706896, 0.002008127491869321], [0.008951945782140732, 0.0023022921283514775], [0.011400754268046306, 0.002595080916338165], [0.01414159062643171, 0.002886318771432849], [0.017172816784017365, 0.0031758315808535944], [0.020492621073150037, 0.003463446283449407], [0.024099019329367807, 0.0037489909628173643], [0.027989856084889908, 0.004032294945243029], [0.03216280586104181, 0.004313188899308375], [0.036615374560526076, 0.004591504935830437], [0.04134490095951973, 0.004867076707503403], [0.046348558299121594, 0.005139739507916079], [0.051623355975420906, 0.005409330369751538], [0.05716614132730139, 0.005675688162040208], [0.06297360152098411, 0.00593865368637014], [0.06904226553022577, 0.0061980697719754615], [0.07536850621101551, 0.006453781369633674], [0.08194854246954658, 0.0067056356443081664], [0.08877844152217808, 0.006953482066475993], [0.09585412124604317, 0.007197172502083423], [0.10317135261890335, 0.007436561301073657], [0.11072576224679402, 0.007671505384432572], [0.11851283497795263, 0.007901864329699674], [0.126527916601469, 0.008127500454892593], [0.1347662166290456, 0.008348278900794603], [0.1432228111582063, 0.00856406771155569], [0.15189264581524284, 0.008774737913558853], [0.16077053877614036, 0.008980163592504344], [0.16985118386367698, 0.00918022196866567], [0.17912915371884622, 0.009374793470272355], [0.18859890304470756, 0.009563761804975472], [0.1982547719207257, 0.009747014029353301], [0.20809098918561847, 0.00992444061641543], [0.21810167588669097, 0.010095935521065021], [0.2282808487935948, 0.010261396243480035], [0.23862242397441227, 0.010420723890375575], [0.24912022043192777, 0.010573823234110675], [0.259767963797914, 0.01072060276960423], [0.2705592900832239, 0.010860974769026038], [0.2814877494814479, 0.010994855334230245], [0.2925468102238625, 0.011122164446899882], [0.30372986248336625, 0.011242826016372484], [0.3150302223250705, 0.01135676792511823], [0.3264411357011823, 0.011463922071843423], [0.3379557824877933, 0.011564224412193513], [0.3495672805611614, 0.01165761499703138], [0.3612686899110478, 0.011744038008267956], [0.3730530167886528, 0.011823441792223808], [0.38491321788667, 0.011895778890501701], [0.3968422045489604, 0.011961006068351729], [0.4088328470073314, 0.012019084340512026], [0.4208779786428875, 0.012069978994509643], [0.4329704002694061, 0.012113659611407625], [0.4451028844361781, 0.012150100083985933], [0.45726817974774225, 0.012179278632345313], [0.4694590151979302, 0.01220117781692479], [0.48166810451563324, 0.012215784548925022], [0.4938881505196921, 0.012223090098131259]]};

const _depth_of_ellipsoid = (a, h, b) => {
  let angle;
  angle = (Math.log1p(((2 * a) / (b - a))) / 2);
  return (((h / b) * a) * angle);
};

const _depth = (a, h, b) => {
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (b > 1e-30) && (b < 1e+30))) {
    return (((h / b) * a) * (Math.log1p(((2.0 * a) / (b - a))) / 2.0));
  }
  return _depth_of_ellipsoid(a, h, b);
};

const depth = (a, h, b) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth(a, h, b) : NaN);
};

const _force = (a, h, b, E_star) => {
  let v14, v20, v55, v9;
  v9 = (math.log1p(((2.0 * a) / (b - a))) / 2.0);
  v14 = (a / b);
  if ((v9 < 1.0)) {
    v20 = (v9 * v9);
    v55 = ((v14 * (v14 * v14)) * (((((((((((1.0716932453474512e-06 * v20) + 0.00019982814521087247) * v20) + 0.007076196047699156) * v20) + 0.08608622548411103) * v20) + 0.3073858328214721) * v20) + 0.3333333333333333) / ((((((((((2.565078604208634e-08 * v20) + 2.0203143566039827e-05) * v20) + 0.001617010334189783) * v20) + 0.03639274880225476) * v20) + 0.32215749846441627) * v20) + 1.0)));
  } else {
    v55 = (v9 - v14);
  }
  return ((E_star * h) * ((((a * a) * v9) / b) + (b * v55)));
};

const force = (a, h, b, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force(a, h, b, E_star) : NaN);
};

const difference_root = (x, y) => {
  let v2;
  v2 = (x - y);
  return math.sqrt(((((v2 > 0.0) || (v2 !== v2)) ? v2 : 0.0) * (x + y)));
};

const LEGENDRE_CHI = [[1.0, 0.11111111111110937, 0.04000000000042643, 0.020408163224119494, 0.012345681107818056, 0.008264397984935742, 0.005918487051520244, 0.004425450516633092, 0.0036572276005780893, 0.0012521687336059639, 0.011089560042611895, (-0.03710676078458442), 0.13289328569967984, (-0.3332798652335896), 0.6371928816963097, (-0.8745573865774817), 0.8293825948837366, (-0.4846453962188766), 0.13579013365982337], [1.0]];

const END = 0.7;

const _arc_rate = (t, root) => {
  return Math.asinh((t / root));
};

const falling = (stop, even = 0.0) => {
  let below, fallen, side;
  side = (1.0 - (2.0 * even));
  below = ((2.0 * even) - (side * Math.expm1(((-2.0) * stop))));
  below = ((below > 0.0) ? below : Infinity);
  fallen = (v) => {
    return ((Math.exp((-v)) * ((2.0 * even) - (side * Math.expm1(((-2.0) * (stop - v)))))) / below);
  };
  return fallen;
};

const pressure_integral_tanh = math.in_groups((slope, r, a, R) => {
  let fallen, integrand, ratio, scale, stop;
  scale = difference_root(R, r);
  ratio = (difference_root(a, r) / difference_root(R, a));
  stop = Math.asinh(ratio);
  fallen = falling(stop);
  integrand = (v) => {
    let root, secant, side, t, u;
    side = (ratio * fallen(v));
    secant = Math.sqrt((1.0 + (side * side)));
    [u, root] = [(scale * (side / secant)), (scale / secant)];
    t = Math.sqrt(((r * r) + (u * u)));
    return ((slope(t, root) / t) * (root / secant));
  };
  return [integrand, stop, 1.0, (a < R), Infinity];
});

const arc_strips = (r, a, R) => {
  let below, beyond, coefficient, high, low, lower, near, quotient, reach, upper, value;
  [reach, below] = [difference_root(a, r), (R + difference_root(R, r))];
  high = ((a + reach) / below);
  low = ((r * (r / (a + reach))) / below);
  [upper, lower] = [(high * high), (low * low)];
  [value, quotient] = [LEGENDRE_CHI[0].at(-1), 0.0];
  for (coefficient of math.reversed(LEGENDRE_CHI[0]).slice(2 - 1)) {
    quotient = ((quotient * lower) + value);
    value = ((value * upper) + coefficient);
  }
  near = (((2.0 * reach) / below) * (value + ((low * (low + high)) * quotient)));
  beyond = (high > END);
  if ((!Boolean(beyond))) {
    return near;
  }
  return (beyond ? pressure_integral_tanh(_arc_rate, [], r, a, R) : near);
};

const _pressure_of_ellipsoid = (r, a, h, b, E_star) => {
  let inside, pressed, root, root_ba, root_br;
  root_br = Math.sqrt(((b - r) * (r + b)));
  root = Math.sqrt(((a - r) * (a + r)));
  root_ba = Math.sqrt(((b - a) * (a + b)));
  pressed = (((E_star * h) / Math.PI) * ((Math.asinh((root / root_ba)) / root_br) + (arc_strips(r, a, b) / b)));
  inside = ((r < a) ? pressed : 0.0);
  return ((a <= b) ? inside : NaN);
};

const _pressure = (r, a, h, b, E_star) => {
  let v10, v100, v104, v109, v114, v119, v124, v26, v31, v32, v33, v36, v37, v38, v44, v49, v5, v54, v59, v64, v69, v74, v79, v84, v89, v9, v94, v99;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v5 = (b - r);
    v9 = (a - r);
    v10 = (a + r);
    v26 = Math.sqrt(((((v9 > 0.0) || (v9 !== v9)) ? v9 : 0.0) * v10));
    v31 = (b + Math.sqrt(((((v5 > 0.0) || (v5 !== v5)) ? v5 : 0.0) * (b + r))));
    v32 = (a + v26);
    v33 = (v32 / v31);
    if ((v33 > 0.7)) {
      return _pressure_of_ellipsoid(r, a, h, b, E_star);
    }
    if ((a <= b)) {
      if ((r < a)) {
        v36 = ((r * (r / v32)) / v31);
        v37 = (v33 * v33);
        v38 = (v36 * v36);
        v44 = ((0.13579013365982337 * v37) + (-0.4846453962188766));
        v49 = ((v44 * v37) + 0.8293825948837366);
        v54 = ((v49 * v37) + (-0.8745573865774817));
        v59 = ((v54 * v37) + 0.6371928816963097);
        v64 = ((v59 * v37) + (-0.3332798652335896));
        v69 = ((v64 * v37) + 0.13289328569967984);
        v74 = ((v69 * v37) + (-0.03710676078458442));
        v79 = ((v74 * v37) + 0.011089560042611895);
        v84 = ((v79 * v37) + 0.0012521687336059639);
        v89 = ((v84 * v37) + 0.0036572276005780893);
        v94 = ((v89 * v37) + 0.004425450516633092);
        v99 = ((v94 * v37) + 0.005918487051520244);
        v100 = (((((((((((((((((((((((((0.0 * v38) + 0.13579013365982337) * v38) + v44) * v38) + v49) * v38) + v54) * v38) + v59) * v38) + v64) * v38) + v69) * v38) + v74) * v38) + v79) * v38) + v84) * v38) + v89) * v38) + v94) * v38);
        v104 = ((v99 * v37) + 0.008264397984935742);
        v109 = ((v104 * v37) + 0.012345681107818056);
        v114 = ((v109 * v37) + 0.020408163224119494);
        v119 = ((v114 * v37) + 0.04000000000042643);
        v124 = ((v119 * v37) + 0.11111111111110937);
        return (((E_star * h) / 3.141592653589793) * ((Math.asinh((Math.sqrt((v9 * v10)) / Math.sqrt(((b - a) * (a + b))))) / Math.sqrt((v5 * (r + b)))) + ((((2.0 * v26) / v31) * (((v124 * v37) + 1.0) + ((v36 * (v36 + v33)) * (((((((((((v100 + v99) * v38) + v104) * v38) + v109) * v38) + v114) * v38) + v119) * v38) + v124)))) / b)));
      }
      return 0.0;
    }
    return NaN;
  }
  return _pressure_of_ellipsoid(r, a, h, b, E_star);
};

const pressure = (r, a, h, b, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure(r, a, h, b, E_star) : 0.0) : NaN);
};

const RULE_0 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _displacement = (r, a, h, b) => {
  let node, v11, v12, v17, v20, v22, v31, v34, v36, v37, v38, v4, v42, v44, v45, v48, v5, v52, v53, v55, v58, v67, v68, v69, v79, weight;
  if ((a <= b)) {
    v58 = (h / b);
    if ((r > a)) {
      v4 = (((r < b) || (r !== r)) ? r : b);
      if ((a < v4)) {
        v5 = (v4 - a);
        v11 = (a / math.sqrt(((((v5 > 0.0) || (v5 !== v5)) ? v5 : 0.0) * (v4 + a))));
        v12 = Math.asinh(v11);
        v17 = (0.0 - Math.expm1(((-2.0) * v12)));
        v20 = ((v17 > 0.0) ? v17 : Infinity);
        v38 = (r - b);
        v42 = math.sqrt(((((v38 > 0.0) || (v38 !== v38)) ? v38 : 0.0) * (r + b)));
        v44 = (v42 * v42);
        v48 = (b - r);
        v52 = math.sqrt(((((v48 > 0.0) || (v48 !== v48)) ? v48 : 0.0) * (b + r)));
        v53 = (v52 * v52);
        v68 = [];
        for ([node, weight] of RULE_0((v12 / 1.0))) {
          v22 = (node * v12);
          v31 = (v11 * ((Math.exp((-v22)) * (0.0 - Math.expm1(((-2.0) * (v12 - v22))))) / v20));
          v34 = math.sqrt((1.0 + (v31 * v31)));
          v36 = (v4 * (v31 / v34));
          v37 = (v4 / v34);
          v45 = (v37 * v37);
          v55 = math.sqrt((v53 + v45));
          v67 = ((((v58 * Math.asinh((v36 / v55))) + ((h * v36) / (v55 * v55))) * Math.atan2(v36, math.sqrt((v44 + v45)))) * (v37 / v34));
          v68.push((weight * v67));
        }
        v68 = (math.fsum(v68) * v12);
        v69 = v68;
      } else {
        v69 = Infinity;
      }
      return (0.6366197723675814 * v69);
    }
    v79 = (r / b);
    return (((v58 * a) * (math.log1p(((2.0 * a) / (b - a))) / 2.0)) - ((h * (r * r)) / ((b * b) * (math.sqrt(((1.0 - v79) * (v79 + 1.0))) + 1.0))));
  }
  return NaN;
};

const displacement = (r, a, h, b) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement(r, a, h, b) : 0.0) : NaN);
};

const _stiffness_of_ellipsoid = (a, E_star) => {
  return ((2 * E_star) * a);
};

const _stiffness = (a, E_star, h = 1.0, b = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (h > 1e-30) && (h < 1e+30) && (b > 1e-30) && (b < 1e+30))) {
    return ((2.0 * E_star) * a);
  }
  return _stiffness_of_ellipsoid(a, E_star);
};

const stiffness = (a, h, b, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness(a, E_star) : NaN);
};

const TANH_GAP = [[0.3333333333333333, 0.3073858328214721, 0.08608622548411103, 0.007076196047699156, 0.00019982814521087247, 1.0716932453474512e-06], [1.0, 0.32215749846441627, 0.03639274880225476, 0.001617010334189783, 2.0203143566039827e-05, 2.565078604208634e-08]];

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

const tanh_gap = (y, x) => {
  let t;
  t = math.minimum(y, 1.0);
  return math.where((y < 1.0), ((x * (x * x)) * rational((t * t), ...TANH_GAP)), (y - x));
};

const _force_of_ellipsoid = (a, h, b, E_star) => {
  let angle;
  angle = (Math.log1p(((2 * a) / (b - a))) / 2);
  return ((E_star * h) * (((Math.pow(a, 2) * angle) / b) + (b * tanh_gap(angle, (a / b)))));
};

const _mean_pressure_of_ellipsoid = (a, h, b, E_star) => {
  return math.where((a > 0.0), (_force_of_ellipsoid(a, h, b, E_star) / (Math.PI * Math.pow(a, 2))), 0.0);
};

const _mean_pressure = (a, h, b, E_star) => {
  let v11, v13, v16, v22, v57;
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((a > 0.0)) {
      v11 = (Math.log1p(((2.0 * a) / (b - a))) / 2.0);
      v13 = (a * a);
      v16 = (a / b);
      if ((v11 < 1.0)) {
        v22 = (v11 * v11);
        v57 = ((v16 * (v16 * v16)) * (((((((((((1.0716932453474512e-06 * v22) + 0.00019982814521087247) * v22) + 0.007076196047699156) * v22) + 0.08608622548411103) * v22) + 0.3073858328214721) * v22) + 0.3333333333333333) / ((((((((((2.565078604208634e-08 * v22) + 2.0203143566039827e-05) * v22) + 0.001617010334189783) * v22) + 0.03639274880225476) * v22) + 0.32215749846441627) * v22) + 1.0)));
      } else {
        v57 = (v11 - v16);
      }
      return (((E_star * h) * (((v13 * v11) / b) + (b * v57))) / (3.141592653589793 * v13));
    }
    return 0.0;
  }
  return _mean_pressure_of_ellipsoid(a, h, b, E_star);
};

const mean_pressure = (a, h, b, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure(a, h, b, E_star) : NaN);
};

const RULE_0_of_ellipsoid = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _depth_at = (a, root, h, b) => {
  let angle;
  angle = Math.asinh((a / root));
  return (((h / b) * a) * angle);
};

const energy_integral_tanh = math.in_groups((depth, a, d, R) => {
  let fallen, integrand, ratio, stop;
  ratio = (a / difference_root(R, a));
  stop = Math.asinh(ratio);
  fallen = falling(stop);
  integrand = (v) => {
    let secant, short, side;
    side = (ratio * fallen(v));
    secant = Math.sqrt((1.0 + (side * side)));
    short = (d - depth((R * (side / secant)), (R / secant)));
    return ((short * short) / (secant * secant));
  };
  return [integrand, stop, R, (a < R), Infinity];
});

const _energy_of_ellipsoid = (a, h, b, E_star) => {
  let sunk, tip;
  sunk = _depth_of_ellipsoid(a, h, b);
  tip = energy_integral_tanh(_depth_at, [h, b], a, sunk, b);
  return math.where((a <= b), (E_star * tip), NaN);
};

const _energy = (a, h, b, E_star) => {
  let node, v10, v12, v18, v19, v24, v27, v29, v38, v41, v43, v49, v52, v53, v55, v6, weight;
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((a <= b)) {
      if ((a < b)) {
        v6 = (b - a);
        v10 = (h / b);
        v12 = ((v10 * a) * (Math.log1p(((2.0 * a) / v6)) / 2.0));
        v18 = (a / Math.sqrt(((((v6 > 0.0) || (v6 !== v6)) ? v6 : 0.0) * (b + a))));
        v19 = Math.asinh(v18);
        v24 = (0.0 - Math.expm1(((-2.0) * v19)));
        v27 = ((v24 > 0.0) ? v24 : Infinity);
        v53 = [];
        for ([node, weight] of RULE_0_of_ellipsoid((v19 / 1.0))) {
          v29 = (node * v19);
          v38 = (v18 * ((Math.exp((-v29)) * (0.0 - Math.expm1(((-2.0) * (v19 - v29))))) / v27));
          v41 = Math.sqrt((1.0 + (v38 * v38)));
          v43 = (b * (v38 / v41));
          v49 = (v12 - ((v10 * v43) * Math.asinh((v43 / (b / v41)))));
          v52 = ((v49 * v49) / (v41 * v41));
          v53.push((weight * v52));
        }
        v53 = (math.fsum(v53) * v19);
        v55 = (b * v53);
      } else {
        v55 = Infinity;
      }
      return (E_star * v55);
    }
    return NaN;
  }
  return _energy_of_ellipsoid(a, h, b, E_star);
};

const energy = (a, h, b, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _energy(a, h, b, E_star) : NaN);
};

const _slope = (t, root, h, b) => {
  let angle;
  angle = Math.asinh((t / root));
  return (((h / b) * angle) + ((h * t) / Math.pow(root, 2)));
};

const load_within_integral_tanh = math.in_groups((slope, r, a, R) => {
  let fallen, integrand, ratio, scale, share, stop;
  [scale, share] = [difference_root(R, r), (r / R)];
  ratio = (difference_root(a, r) / difference_root(R, a));
  stop = Math.asinh((ratio / share));
  fallen = falling(stop);
  integrand = (v) => {
    let root, secant, side, t, u;
    side = (ratio * fallen(v));
    secant = Math.sqrt((1.0 + (side * side)));
    [u, root] = [(scale * (side / secant)), (scale / secant)];
    t = Math.sqrt(((r * r) + (u * u)));
    return (((slope(t, root) * (u / (t + u))) * (root / ((secant * secant) * t))) * Math.sqrt(((share * share) + (side * side))));
  };
  return [integrand, stop, (r * r), ((r > 0.0) & (a < R)), math.where((r > 0.0), Infinity, 0.0)];
});

const _load_within_of_ellipsoid = (r, a, h, b, E_star) => {
  let tip;
  tip = load_within_integral_tanh(_slope, [h, b], math.minimum(r, a), a, b);
  return math.where((a <= b), (_force_of_ellipsoid(math.minimum(r, a), h, b, E_star) + ((2 * E_star) * tip)), NaN);
};

const _load_within = (r, a, h, b, E_star) => {
  let node, v11, v12, v128, v13, v18, v23, v25, v30, v33, v34, v35, v39, v48, v49, v5, v51, v53, v54, v57, v6, v60, v74, v77, v78, v80, v85, v93, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((a <= b)) {
      v5 = (((r < a) || (r !== r)) ? r : a);
      v6 = (b - v5);
      v12 = (v5 / b);
      v35 = (v5 > 0.0);
      v74 = (v12 * v12);
      if ((v35 && (a < b))) {
        v11 = Math.sqrt(((((v6 > 0.0) || (v6 !== v6)) ? v6 : 0.0) * (b + v5)));
        v13 = (a - v5);
        v18 = (b - a);
        v23 = (Math.sqrt(((((v13 > 0.0) || (v13 !== v13)) ? v13 : 0.0) * (a + v5))) / Math.sqrt(((((v18 > 0.0) || (v18 !== v18)) ? v18 : 0.0) * (b + a))));
        v25 = Math.asinh((v23 / v12));
        v30 = (0.0 - Math.expm1(((-2.0) * v25)));
        v33 = ((v30 > 0.0) ? v30 : Infinity);
        v34 = (v5 * v5);
        v60 = (h / b);
        v78 = [];
        for ([node, weight] of RULE_0_of_ellipsoid((v25 / 1.0))) {
          v39 = (node * v25);
          v48 = (v23 * ((Math.exp((-v39)) * (0.0 - Math.expm1(((-2.0) * (v25 - v39))))) / v33));
          v49 = (v48 * v48);
          v51 = Math.sqrt((1.0 + v49));
          v53 = (v11 * (v48 / v51));
          v54 = (v11 / v51);
          v57 = Math.sqrt((v34 + (v53 * v53)));
          v77 = (((((v60 * Math.asinh((v57 / v54))) + ((h * v57) / (v54 * v54))) * (v53 / (v57 + v53))) * (v54 / ((v51 * v51) * v57))) * Math.sqrt((v74 + v49)));
          v78.push((weight * v77));
        }
        v78 = (math.fsum(v78) * v25);
        v80 = (v34 * v78);
      } else {
        v80 = (v35 ? Infinity : 0.0);
      }
      v85 = (Math.log1p(((2.0 * v5) / v6)) / 2.0);
      if ((v85 < 1.0)) {
        v93 = (v85 * v85);
        v128 = ((v12 * v74) * (((((((((((1.0716932453474512e-06 * v93) + 0.00019982814521087247) * v93) + 0.007076196047699156) * v93) + 0.08608622548411103) * v93) + 0.3073858328214721) * v93) + 0.3333333333333333) / ((((((((((2.565078604208634e-08 * v93) + 2.0203143566039827e-05) * v93) + 0.001617010334189783) * v93) + 0.03639274880225476) * v93) + 0.32215749846441627) * v93) + 1.0)));
      } else {
        v128 = (v85 - v12);
      }
      return (((E_star * h) * ((((v5 * v5) * v85) / b) + (b * v128))) + ((2.0 * E_star) * v80));
    }
    return NaN;
  }
  return _load_within_of_ellipsoid(r, a, h, b, E_star);
};

const load_within = (r, a, h, b, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _load_within(r, a, h, b, E_star) : 0.0) : NaN);
};

const _depth_at_of_ellipsoid = (a, root, h, b) => {
  return (((h / b) * a) * Math.asinh((a / root)));
};

const _slope_of_ellipsoid = (t, root, h, b) => {
  return (((h / b) * Math.asinh((t / root))) + ((h * t) / (root * root)));
};

const _joined = (x, small, large, blend) => {
  let first, last;
  [first, last] = [...[small, large]].map(([c, e]) => ((blend / e) * (x - Math.log(c))));
  return Math.exp(((math.maximum(first, last) + Math.log1p(Math.exp((-Math.abs((first - last)))))) / blend));
};

const between = (x, small, large, blend, rest) => {
  let coefficient, factor, q, v;
  q = _joined(x, small, large, blend);
  [v, factor] = [(1.0 - (1.0 / (1.0 + q))), rest.at(-1)];
  for (coefficient of math.reversed(rest).slice(2 - 1)) {
    factor = ((factor * v) + coefficient);
  }
  return (q * factor);
};

const _missed = (value, y) => {
  let v3, v6;
  v3 = ((value - y) / y);
  v6 = (Math.abs(v3) < 0.5);
  if (v6) {
    return math.log1p((v6 ? v3 : 0.0));
  }
  return math.log((value / y));
};

const ROUNDING = 1.1102230246251565e-16;

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
  let _, before, change, close, error, high, iteration, known, left, low, moved, position, root, slope, slope_before, solvable, step, t, y;
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
  known = (y === y);
  solvable = (((value > 0.0) & (value < Infinity)) & known);
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
  root = (((value >= 0.0) & known) ? math.minimum(t, largest) : NaN);
  return ((value === 0.0) ? 0.0 : ((value === Infinity) ? Infinity : root));
};

const _contact_from_depth = (d, h, b) => {
  let curve, rest, start, t;
  curve = (t) => {
    let a, root, value;
    [a, root] = [(b * Math.tanh(t)), (b / Math.cosh(t))];
    value = _depth_at_of_ellipsoid(a, root, h, b);
    return [value, (((((t * root) * root) / b) * _slope_of_ellipsoid(a, root, h, b)) / value)];
  };
  rest = [0.9983865, 0.208363, (-4.0282), 30.18372, (-93.92268), 137.5431, (-95.06062), 25.07439];
  start = between(Math.log((d / curve(1.0)[0])), [1.313, 2.0], [1.313, 1.0], 3.75, rest);
  t = inverse(curve, d, start, [1.0, 2.0], undefined, undefined, true);
  return [(b * Math.tanh(t)), (b / Math.cosh(t))];
};

const _radius_from_depth = (d, h, b) => {
  return _contact_from_depth(d, h, b)[0];
};

const radius_from_depth = (d, h, b) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth(d, h, b) : NaN);
};

const _force_at = (a, root, h, b, E_star) => {
  let v14, v49, v6, v8;
  v6 = Math.asinh((a / root));
  v8 = Math.tanh(v6);
  if ((v6 < 1.0)) {
    v14 = (v6 * v6);
    v49 = ((v8 * (v8 * v8)) * (((((((((((1.0716932453474512e-06 * v14) + 0.00019982814521087247) * v14) + 0.007076196047699156) * v14) + 0.08608622548411103) * v14) + 0.3073858328214721) * v14) + 0.3333333333333333) / ((((((((((2.565078604208634e-08 * v14) + 2.0203143566039827e-05) * v14) + 0.001617010334189783) * v14) + 0.03639274880225476) * v14) + 0.32215749846441627) * v14) + 1.0)));
  } else {
    v49 = (v6 - v8);
  }
  return ((E_star * h) * ((b * v49) + (((a * a) * v6) / b)));
};

const _contact_from_force = (F, h, b, E_star) => {
  let curve, rest, start, t;
  curve = (t) => {
    let a, root, value;
    [a, root] = [(b * Math.tanh(t)), (b / Math.cosh(t))];
    value = _force_at(a, root, h, b, E_star);
    return [value, ((((((((2 * E_star) * a) * t) * root) * root) / b) * _slope_of_ellipsoid(a, root, h, b)) / value)];
  };
  rest = [0.998775, 0.1558039, (-2.915358), 22.20415, (-66.84601), 91.96521, (-58.34092), 13.75711];
  start = between(Math.log((F / curve(1.0)[0])), [1.629, 3.0], [2.405, 1.0], 1.75, rest);
  t = inverse(curve, F, start, [1.0, 3.0], undefined, undefined, true);
  return [(b * Math.tanh(t)), (b / Math.cosh(t))];
};

const _radius_from_force = (F, h, b, E_star) => {
  return _contact_from_force(F, h, b, E_star)[0];
};

const radius_from_force = (F, h, b, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _radius_from_force(F, h, b, E_star) : NaN);
};

const _force_from_depth = (d, h, b, E_star) => {
  let a, change, root;
  [a, root] = _contact_from_depth(d, h, b);
  change = (((a > 0.0) & (a < Infinity)) ? (((2 * E_star) * a) * (d - _depth_at_of_ellipsoid(a, root, h, b))) : 0.0);
  return (_force_at(a, root, h, b, E_star) + change);
};

const force_from_depth = (d, h, b, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth(d, h, b, E_star) : NaN);
};

const _depth_from_force = (F, h, b, E_star) => {
  let a, change, root;
  [a, root] = _contact_from_force(F, h, b, E_star);
  change = (((a > 0.0) & (a < Infinity)) ? ((F - _force_at(a, root, h, b, E_star)) / ((2 * E_star) * a)) : 0.0);
  return (_depth_at_of_ellipsoid(a, root, h, b) + change);
};

const depth_from_force = (F, h, b, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force(F, h, b, E_star) : NaN);
};

const hess_retraction = (a, E_star, dgamma) => {
  return (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star)));
};

const retraction = (a, E_star, dgamma) => {
  if ((!((0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? hess_retraction(a, E_star, dgamma) : NaN);
};

const _depth_2 = (a, h, b, E_star, dgamma) => {
  return ((((h / b) * a) * (math.log1p(((2.0 * a) / (b - a))) / 2.0)) - (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const depth_of_ellipsoid = (a, h, b, E_star, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_2(a, h, b, E_star, dgamma) : NaN);
};

const _force_2 = (a, h, b, E_star, dgamma) => {
  let v10, v15, v21, v56;
  v10 = (math.log1p(((2.0 * a) / (b - a))) / 2.0);
  v15 = (a / b);
  if ((v10 < 1.0)) {
    v21 = (v10 * v10);
    v56 = ((v15 * (v15 * v15)) * (((((((((((1.0716932453474512e-06 * v21) + 0.00019982814521087247) * v21) + 0.007076196047699156) * v21) + 0.08608622548411103) * v21) + 0.3073858328214721) * v21) + 0.3333333333333333) / ((((((((((2.565078604208634e-08 * v21) + 2.0203143566039827e-05) * v21) + 0.001617010334189783) * v21) + 0.03639274880225476) * v21) + 0.32215749846441627) * v21) + 1.0)));
  } else {
    v56 = (v10 - v15);
  }
  return (((E_star * h) * ((((a * a) * v10) / b) + (b * v56))) - (((2.0 * E_star) * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star)))));
};

const force_of_ellipsoid = (a, h, b, E_star, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_2(a, h, b, E_star, dgamma) : NaN);
};

const _pressure_4 = (r, a, h, b, E_star) => {
  let inside, pressed, root, root_ba, root_br;
  root_br = Math.sqrt(((b - r) * (r + b)));
  root = Math.sqrt(((a - r) * (a + r)));
  root_ba = Math.sqrt(((b - a) * (a + b)));
  pressed = (((E_star * h) / Math.PI) * ((Math.asinh((root / root_ba)) / root_br) + (arc_strips(r, a, b) / b)));
  inside = math.where((r < a), pressed, 0.0);
  return math.where((a <= b), inside, NaN);
};

const tension = (r, a, E_star, dgamma) => {
  let v13, v9;
  if ((r <= a)) {
    v9 = (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star)));
    if ((v9 > 0.0)) {
      v13 = (a - r);
      return ((E_star * v9) / (3.141592653589793 * math.sqrt(((((v13 > 0.0) || (v13 !== v13)) ? v13 : 0.0) * (a + r)))));
    }
    return 0.0;
  }
  return 0.0;
};

const _pressure_3 = (r, a, h, b, E_star, dgamma) => {
  return (_pressure_4(r, a, h, b, E_star) - tension(r, a, E_star, dgamma));
};

const _pressure_2 = (r, a, h, b, E_star, dgamma) => {
  let v10, v100, v101, v105, v11, v110, v115, v120, v125, v145, v148, v154, v161, v27, v32, v33, v34, v37, v38, v39, v45, v50, v55, v6, v60, v65, v70, v75, v80, v85, v90, v95;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v6 = (b - r);
    v10 = (a - r);
    v11 = (a + r);
    v27 = Math.sqrt(((((v10 > 0.0) || (v10 !== v10)) ? v10 : 0.0) * v11));
    v32 = (b + Math.sqrt(((((v6 > 0.0) || (v6 !== v6)) ? v6 : 0.0) * (b + r))));
    v33 = (a + v27);
    v34 = (v33 / v32);
    if ((a <= b)) {
      if ((r < a)) {
        v37 = ((r * (r / v33)) / v32);
        v38 = (v34 * v34);
        v39 = (v37 * v37);
        v45 = ((0.13579013365982337 * v38) + (-0.4846453962188766));
        v50 = ((v45 * v38) + 0.8293825948837366);
        v55 = ((v50 * v38) + (-0.8745573865774817));
        v60 = ((v55 * v38) + 0.6371928816963097);
        v65 = ((v60 * v38) + (-0.3332798652335896));
        v70 = ((v65 * v38) + 0.13289328569967984);
        v75 = ((v70 * v38) + (-0.03710676078458442));
        v80 = ((v75 * v38) + 0.011089560042611895);
        v85 = ((v80 * v38) + 0.0012521687336059639);
        v90 = ((v85 * v38) + 0.0036572276005780893);
        v95 = ((v90 * v38) + 0.004425450516633092);
        v100 = ((v95 * v38) + 0.005918487051520244);
        v101 = (((((((((((((((((((((((((0.0 * v39) + 0.13579013365982337) * v39) + v45) * v39) + v50) * v39) + v55) * v39) + v60) * v39) + v65) * v39) + v70) * v39) + v75) * v39) + v80) * v39) + v85) * v39) + v90) * v39) + v95) * v39);
        v105 = ((v100 * v38) + 0.008264397984935742);
        v110 = ((v105 * v38) + 0.012345681107818056);
        v115 = ((v110 * v38) + 0.020408163224119494);
        v120 = ((v115 * v38) + 0.04000000000042643);
        v125 = ((v120 * v38) + 0.11111111111110937);
        v145 = (((E_star * h) / 3.141592653589793) * ((Math.asinh((Math.sqrt((v10 * v11)) / Math.sqrt(((b - a) * (a + b))))) / Math.sqrt((v6 * (r + b)))) + ((((2.0 * v27) / v32) * (((v125 * v38) + 1.0) + ((v37 * (v37 + v34)) * (((((((((((v101 + v100) * v39) + v105) * v39) + v110) * v39) + v115) * v39) + v120) * v39) + v125)))) / b)));
      } else {
        v145 = 0.0;
      }
      v148 = v145;
    } else {
      v148 = NaN;
    }
    if ((r <= a)) {
      v154 = (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star)));
      v161 = ((v154 > 0.0) ? ((E_star * v154) / (3.141592653589793 * v27)) : 0.0);
    } else {
      v161 = 0.0;
    }
    if ((v34 > 0.7)) {
      return _pressure_3(r, a, h, b, E_star, dgamma);
    }
    return (v148 - v161);
  }
  return _pressure_3(r, a, h, b, E_star, dgamma);
};

const pressure_of_ellipsoid = (r, a, h, b, E_star, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_2(r, a, h, b, E_star, dgamma) : 0.0) : NaN);
};

const RULE_0_2 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const falling_of_rules = (stop, even = 0.0) => {
  let below, fallen, side;
  side = (1.0 - (2.0 * even));
  below = ((2.0 * even) - (side * Math.expm1(((-2.0) * stop))));
  below = math.where((below > 0.0), below, Infinity);
  fallen = (v) => {
    return ((Math.exp((-v)) * ((2.0 * even) - (side * Math.expm1(((-2.0) * (stop - v)))))) / below);
  };
  return fallen;
};

const displacement_integral_tanh = math.in_groups((slope, r, a, R) => {
  let end, fallen, integrand, scale, stop;
  scale = math.minimum(r, R);
  end = (a / difference_root(scale, a));
  stop = Math.asinh(end);
  fallen = falling_of_rules(stop);
  integrand = (v) => {
    let beyond, part, root, secant, side, t;
    side = (end * fallen(v));
    secant = Math.sqrt((1.0 + (side * side)));
    [t, part] = [(scale * (side / secant)), (scale / secant)];
    beyond = Math.sqrt((Math.pow(difference_root(r, R), 2) + (part * part)));
    root = Math.sqrt((Math.pow(difference_root(R, r), 2) + (part * part)));
    return ((slope(t, root) * Math.atan2(t, beyond)) * (part / secant));
  };
  return [integrand, stop, 1.0, (a < scale), Infinity];
});

const _profile = (r, h, b) => {
  let root_0;
  root_0 = Math.sqrt(((1 - (r / b)) * ((r / b) + 1)));
  return ((h * Math.pow(r, 2)) / (Math.pow(b, 2) * (root_0 + 1)));
};

const _displacement_3 = (r, a, h, b) => {
  let inside, outside, tip;
  tip = displacement_integral_tanh(_slope, [h, b], r, a, b);
  outside = ((2 / Math.PI) * tip);
  inside = (_depth_of_ellipsoid(a, h, b) - _profile(r, h, b));
  return math.where((a <= b), math.where((r > a), outside, inside), NaN);
};

const lift = (r, a, E_star, dgamma) => {
  let v15, v5;
  if ((r > a)) {
    v5 = (r - a);
    v15 = (0.6366197723675814 * Math.atan2(a, math.sqrt(((((v5 > 0.0) || (v5 !== v5)) ? v5 : 0.0) * (r + a)))));
  } else {
    v15 = 1.0;
  }
  return ((math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))) * v15);
};

const _displacement_2 = (r, a, h, b, E_star, dgamma) => {
  return (_displacement_3(r, a, h, b) - lift(r, a, E_star, dgamma));
};

const _displacement_of_ellipsoid = (r, a, h, b, E_star, dgamma) => {
  let node, v105, v13, v14, v19, v22, v24, v33, v36, v38, v39, v40, v44, v46, v47, v50, v54, v55, v57, v6, v60, v69, v7, v70, v71, v81, v94, v95, v97, v98, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v94 = (r > a);
    if ((a <= b)) {
      v60 = (h / b);
      if (v94) {
        v6 = (((r < b) || (r !== r)) ? r : b);
        if ((a < v6)) {
          v7 = (v6 - a);
          v13 = (a / Math.sqrt(((((v7 > 0.0) || (v7 !== v7)) ? v7 : 0.0) * (v6 + a))));
          v14 = Math.asinh(v13);
          v19 = (0.0 - Math.expm1(((-2.0) * v14)));
          v22 = ((v19 > 0.0) ? v19 : Infinity);
          v40 = (r - b);
          v44 = Math.sqrt(((((v40 > 0.0) || (v40 !== v40)) ? v40 : 0.0) * (r + b)));
          v46 = (v44 * v44);
          v50 = (b - r);
          v54 = Math.sqrt(((((v50 > 0.0) || (v50 !== v50)) ? v50 : 0.0) * (b + r)));
          v55 = (v54 * v54);
          v70 = [];
          for ([node, weight] of RULE_0_2((v14 / 1.0))) {
            v24 = (node * v14);
            v33 = (v13 * ((Math.exp((-v24)) * (0.0 - Math.expm1(((-2.0) * (v14 - v24))))) / v22));
            v36 = Math.sqrt((1.0 + (v33 * v33)));
            v38 = (v6 * (v33 / v36));
            v39 = (v6 / v36);
            v47 = (v39 * v39);
            v57 = Math.sqrt((v55 + v47));
            v69 = ((((v60 * Math.asinh((v38 / v57))) + ((h * v38) / (v57 * v57))) * Math.atan2(v38, Math.sqrt((v46 + v47)))) * (v39 / v36));
            v70.push((weight * v69));
          }
          v70 = (math.fsum(v70) * v14);
          v71 = v70;
        } else {
          v71 = Infinity;
        }
        v95 = (0.6366197723675814 * v71);
      } else {
        v81 = (r / b);
        v95 = (((v60 * a) * (Math.log1p(((2.0 * a) / (b - a))) / 2.0)) - ((h * (r * r)) / ((b * b) * (Math.sqrt(((1.0 - v81) * (v81 + 1.0))) + 1.0))));
      }
      v97 = v95;
    } else {
      v97 = NaN;
    }
    if (v94) {
      v98 = (r - a);
      v105 = (0.6366197723675814 * Math.atan2(a, Math.sqrt(((((v98 > 0.0) || (v98 !== v98)) ? v98 : 0.0) * (r + a)))));
    } else {
      v105 = 1.0;
    }
    return (v97 - ((Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))) * v105));
  }
  return _displacement_2(r, a, h, b, E_star, dgamma);
};

const displacement_of_ellipsoid = (r, a, h, b, E_star, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_of_ellipsoid(r, a, h, b, E_star, dgamma) : 0.0) : NaN);
};

const RULE_0_3 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const CLOSE = 0.25;

const _gap = (a, c, outer, inner) => {
  if ((a > c)) {
    return (((a - c) * (a + c)) / (outer + inner));
  }
  return 0.0;
};

const growth_below = math.in_groups((slope, order, r, c, a, R, close) => {
  let below, holds, integrand, last, outer, ratio, root, scale;
  [scale, root, below] = [difference_root(R, r), difference_root(c, r), difference_root(R, c)];
  [outer, last] = [difference_root(a, r), difference_root(R, a)];
  ratio = (((((2.0 * scale) * _gap(a, c, outer, root)) / last) * ((scale + outer) / (scale + root))) / last);
  holds = (close & (a > c));
  integrand = (v) => {
    let even, odd, secant, side, t, u;
    [even, odd] = [Math.cosh(v), Math.sinh(v)];
    secant = ((scale * even) + (root * odd));
    [u, side] = [((scale * ((root * even) + (scale * odd))) / secant), ((scale * below) / secant)];
    t = Math.sqrt(((r * r) + (u * u)));
    return (((slope(t, side) * (side / scale)) * (side / t)) * Math.pow(t, order));
  };
  return [integrand, (holds ? (0.5 * Math.log1p(ratio)) : 0.0), 1.0, holds, 0.0];
});

const _tangential_force_of_ellipsoid = (a, c, h, b, E_star, mu) => {
  let close, gain, sticking, whole;
  [whole, sticking] = [_force_of_ellipsoid(a, h, b, E_star), _force_of_ellipsoid(c, h, b, E_star)];
  close = (sticking >= (CLOSE * whole));
  gain = ((2.0 * E_star) * growth_below(_slope, [h, b], 2, 0.0, c, a, b, close));
  return (mu * math.where(close, gain, (whole - sticking)));
};

const _tangential_force = (a, c, h, b, E_star, mu) => {
  let node, v101, v104, v107, v11, v111, v112, v116, v12, v121, v125, v129, v131, v145, v149, v150, v151, v152, v155, v16, v160, v161, v162, v165, v168, v179, v180, v181, v184, v22, v57, v60, v62, v65, v69, v74, v8, v98, weight;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (h > 1e-30) && (h < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v8 = (b - a);
    v11 = (Math.log1p(((2.0 * a) / v8)) / 2.0);
    v12 = (E_star * h);
    v16 = (a / b);
    if ((v11 < 1.0)) {
      v22 = (v11 * v11);
      v57 = ((v16 * (v16 * v16)) * (((((((((((1.0716932453474512e-06 * v22) + 0.00019982814521087247) * v22) + 0.007076196047699156) * v22) + 0.08608622548411103) * v22) + 0.3073858328214721) * v22) + 0.3333333333333333) / ((((((((((2.565078604208634e-08 * v22) + 2.0203143566039827e-05) * v22) + 0.001617010334189783) * v22) + 0.03639274880225476) * v22) + 0.32215749846441627) * v22) + 1.0)));
    } else {
      v57 = (v11 - v16);
    }
    v60 = (v12 * ((((a * a) * v11) / b) + (b * v57)));
    v62 = (b - c);
    v65 = (Math.log1p(((2.0 * c) / v62)) / 2.0);
    v69 = (c / b);
    if ((v65 < 1.0)) {
      v74 = (v65 * v65);
      v98 = ((v69 * (v69 * v69)) * (((((((((((1.0716932453474512e-06 * v74) + 0.00019982814521087247) * v74) + 0.007076196047699156) * v74) + 0.08608622548411103) * v74) + 0.3073858328214721) * v74) + 0.3333333333333333) / ((((((((((2.565078604208634e-08 * v74) + 2.0203143566039827e-05) * v74) + 0.001617010334189783) * v74) + 0.03639274880225476) * v74) + 0.32215749846441627) * v74) + 1.0)));
    } else {
      v98 = (v65 - v69);
    }
    v101 = (v12 * ((((c * c) * v65) / b) + (b * v98)));
    v104 = (v101 >= (0.25 * v60));
    if (v104) {
      v131 = (a > c);
      v145 = (v104 && v131);
      if (v145) {
        v107 = (b - 0.0);
        v111 = Math.sqrt(((((v107 > 0.0) || (v107 !== v107)) ? v107 : 0.0) * (b + 0.0)));
        v112 = (c - 0.0);
        v116 = Math.sqrt(((((v112 > 0.0) || (v112 !== v112)) ? v112 : 0.0) * (c + 0.0)));
        if (v145) {
          v121 = (a - 0.0);
          v125 = Math.sqrt(((((v121 > 0.0) || (v121 !== v121)) ? v121 : 0.0) * (a + 0.0)));
          v129 = Math.sqrt(((((v8 > 0.0) || (v8 !== v8)) ? v8 : 0.0) * (b + a)));
          v149 = (0.5 * Math.log1p((((((2.0 * v111) * (v131 ? (((a - c) * (a + c)) / (v125 + v116)) : 0.0)) / v129) * ((v111 + v125) / (v111 + v116))) / v129)));
        } else {
          v149 = 0.0;
        }
        v161 = (v111 * Math.sqrt(((((v62 > 0.0) || (v62 !== v62)) ? v62 : 0.0) * (b + c))));
        v168 = (h / b);
        v180 = [];
        for ([node, weight] of RULE_0_3((v149 / 1.0))) {
          v150 = (node * v149);
          v151 = Math.cosh(v150);
          v152 = Math.sinh(v150);
          v155 = ((v111 * v151) + (v116 * v152));
          v160 = ((v111 * ((v116 * v151) + (v111 * v152))) / v155);
          v162 = (v161 / v155);
          v165 = Math.sqrt((0.0 + (v160 * v160)));
          v179 = (((((v168 * Math.asinh((v165 / v162))) + ((h * v165) / (v162 * v162))) * (v162 / v111)) * (v162 / v165)) * (v165 * v165));
          v180.push((weight * v179));
        }
        v180 = (math.fsum(v180) * v149);
        v181 = v180;
      } else {
        v181 = 0.0;
      }
      v184 = ((2.0 * E_star) * v181);
    } else {
      v184 = (v60 - v101);
    }
    return (mu * v184);
  }
  return _tangential_force_of_ellipsoid(a, c, h, b, E_star, mu);
};

const tangential_force = (a, c, h, b, E_star, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_force(a, c, h, b, E_star, mu) : NaN);
};

const CLOSE_of_ellipsoid = 0.25;

const _traction = (r, a, c, h, b, E_star, mu) => {
  let close, gain, sliding, stuck;
  sliding = _pressure_of_ellipsoid(r, a, h, b, E_star);
  stuck = _pressure_of_ellipsoid(r, c, h, b, E_star);
  close = ((r < c) & (stuck >= (CLOSE_of_ellipsoid * sliding)));
  gain = ((E_star / Math.PI) * growth_below(_slope_of_ellipsoid, [h, b], 0, r, c, a, b, close));
  return (mu * (close ? gain : (sliding - stuck)));
};

const traction = (r, a, c, h, b, E_star, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction(r, a, c, h, b, E_star, mu) : 0.0) : NaN);
};

const _tangential_displacement_of_ellipsoid = (a, c, h, b, E_star, G_star, mu) => {
  let close, gain, sticking, whole;
  [whole, sticking] = [_depth_of_ellipsoid(a, h, b), _depth_of_ellipsoid(c, h, b)];
  close = (sticking >= (CLOSE * whole));
  gain = growth_below(_slope, [h, b], 1, 0.0, c, a, b, close);
  return ((mu * (E_star / G_star)) * math.where(close, gain, (whole - sticking)));
};

const _tangential_displacement = (a, c, h, b, E_star, G_star, mu) => {
  let node, v100, v101, v105, v13, v15, v17, v22, v25, v27, v31, v32, v36, v41, v45, v49, v51, v65, v69, v71, v72, v73, v76, v81, v82, v83, v86, v9, v99, weight;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (h > 1e-30) && (h < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v9 = (b - a);
    v13 = (h / b);
    v15 = ((v13 * a) * (Math.log1p(((2.0 * a) / v9)) / 2.0));
    v17 = (b - c);
    v22 = ((v13 * c) * (Math.log1p(((2.0 * c) / v17)) / 2.0));
    v25 = (v22 >= (0.25 * v15));
    if (v25) {
      v51 = (a > c);
      v65 = (v25 && v51);
      if (v65) {
        v27 = (b - 0.0);
        v31 = Math.sqrt(((((v27 > 0.0) || (v27 !== v27)) ? v27 : 0.0) * (b + 0.0)));
        v32 = (c - 0.0);
        v36 = Math.sqrt(((((v32 > 0.0) || (v32 !== v32)) ? v32 : 0.0) * (c + 0.0)));
        if (v65) {
          v41 = (a - 0.0);
          v45 = Math.sqrt(((((v41 > 0.0) || (v41 !== v41)) ? v41 : 0.0) * (a + 0.0)));
          v49 = Math.sqrt(((((v9 > 0.0) || (v9 !== v9)) ? v9 : 0.0) * (b + a)));
          v69 = (0.5 * Math.log1p((((((2.0 * v31) * (v51 ? (((a - c) * (a + c)) / (v45 + v36)) : 0.0)) / v49) * ((v31 + v45) / (v31 + v36))) / v49)));
        } else {
          v69 = 0.0;
        }
        v82 = (v31 * Math.sqrt(((((v17 > 0.0) || (v17 !== v17)) ? v17 : 0.0) * (b + c))));
        v100 = [];
        for ([node, weight] of RULE_0_3((v69 / 1.0))) {
          v71 = (node * v69);
          v72 = Math.cosh(v71);
          v73 = Math.sinh(v71);
          v76 = ((v31 * v72) + (v36 * v73));
          v81 = ((v31 * ((v36 * v72) + (v31 * v73))) / v76);
          v83 = (v82 / v76);
          v86 = Math.sqrt((0.0 + (v81 * v81)));
          v99 = (((((v13 * Math.asinh((v86 / v83))) + ((h * v86) / (v83 * v83))) * (v83 / v31)) * (v83 / v86)) * Math.pow(v86, 1.0));
          v100.push((weight * v99));
        }
        v100 = (math.fsum(v100) * v69);
        v101 = v100;
      } else {
        v101 = 0.0;
      }
      v105 = v101;
    } else {
      v105 = (v15 - v22);
    }
    return ((mu * (E_star / G_star)) * v105);
  }
  return _tangential_displacement_of_ellipsoid(a, c, h, b, E_star, G_star, mu);
};

const tangential_displacement = (a, c, h, b, E_star, G_star, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement(a, c, h, b, E_star, G_star, mu) : NaN);
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

const _stick_radius = (F_x, a, h, b, E_star, mu) => {
  let F;
  F = stick_force(_force(a, h, b, E_star), F_x, mu);
  return (((F_x === 0.0) & (a >= 0.0)) ? a : _radius_from_force(F, h, b, E_star));
};

const stick_radius = (F_x, a, h, b, E_star, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius(F_x, a, h, b, E_star, mu) : NaN);
};

const _full_slip_displacement_of_ellipsoid = (a, h, b, E_star, G_star, mu) => {
  return ((mu * (E_star / G_star)) * _depth_of_ellipsoid(a, h, b));
};

const _full_slip_displacement = (a, h, b, E_star, G_star, mu) => {
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    return ((mu * (E_star / G_star)) * (((h / b) * a) * (Math.log1p(((2.0 * a) / (b - a))) / 2.0)));
  }
  return _full_slip_displacement_of_ellipsoid(a, h, b, E_star, G_star, mu);
};

const full_slip_displacement = (a, h, b, E_star, G_star, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement(a, h, b, E_star, G_star, mu) : NaN);
};

const formulas = {
  "d": (v) => depth(v.a, v.h, v.b),
  "F": (v) => force(v.a, v.h, v.b, v.E_star),
  "p": (v) => pressure(v.r, v.a, v.h, v.b, v.E_star),
  "w": (v) => displacement(v.r, v.a, v.h, v.b),
  "k": (v) => stiffness(v.a, v.h, v.b, v.E_star),
  "pm": (v) => mean_pressure(v.a, v.h, v.b, v.E_star),
  "U": (v) => energy(v.a, v.h, v.b, v.E_star),
  "Fr": (v) => load_within(v.r, v.a, v.h, v.b, v.E_star),
  "ad": (v) => radius_from_depth(v.d, v.h, v.b),
  "aF": (v) => radius_from_force(v.F, v.h, v.b, v.E_star),
  "Fd": (v) => force_from_depth(v.d, v.h, v.b, v.E_star),
  "dF": (v) => depth_from_force(v.F, v.h, v.b, v.E_star),
  "adh.Dl": (v) => retraction(v.a, v.E_star, v.dgamma),
  "adh.d": (v) => depth_of_ellipsoid(v.a, v.h, v.b, v.E_star, v.dgamma),
  "adh.F": (v) => force_of_ellipsoid(v.a, v.h, v.b, v.E_star, v.dgamma),
  "adh.p": (v) => pressure_of_ellipsoid(v.r, v.a, v.h, v.b, v.E_star, v.dgamma),
  "adh.w": (v) => displacement_of_ellipsoid(v.r, v.a, v.h, v.b, v.E_star, v.dgamma),
  "tan.F": (v) => tangential_force(v.a, v.c, v.h, v.b, v.E_star, v.mu),
  "tan.tau": (v) => traction(v.r, v.a, v.c, v.h, v.b, v.E_star, v.mu),
  "tan.u": (v) => tangential_displacement(v.a, v.c, v.h, v.b, v.E_star, v.G_star, v.mu),
  "tan.c": (v) => stick_radius(v.F_x, v.a, v.h, v.b, v.E_star, v.mu),
  "tan.us": (v) => full_slip_displacement(v.a, v.h, v.b, v.E_star, v.G_star, v.mu),
};
window.calculator = { ...{
 "fields": [
  {
   "name": "h",
   "tex": "h",
   "meaning": "height or depth of the profile",
   "unit": "m",
   "rule": "h > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 0.004
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
   "value": 0.005
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
   "value": 2666666.6666666665
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
   "value": 0.5
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
   "value": 0.8
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
  },
  {
   "name": "c",
   "tex": "c",
   "meaning": "radius of the stick zone",
   "unit": "m",
   "rule": "0 <= c <= a",
   "low": 0.0,
   "high": null,
   "closed": "lowhigh",
   "value": ""
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
   "value": 0.5
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
    "h",
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
    "h",
    "b",
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
    "a",
    "h",
    "b",
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
    "a",
    "h",
    "b"
   ],
   "unit": "m",
   "place": "outside",
   "suffix": "w"
  },
  "k": {
   "gives": "stiffness",
   "needs": [
    "a",
    "h",
    "b",
    "E_star"
   ],
   "unit": "N/m",
   "place": "",
   "suffix": "k"
  },
  "pm": {
   "gives": "p_mean",
   "needs": [
    "a",
    "h",
    "b",
    "E_star"
   ],
   "unit": "Pa",
   "place": "",
   "suffix": "pm"
  },
  "U": {
   "gives": "U",
   "needs": [
    "a",
    "h",
    "b",
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
    "a",
    "h",
    "b",
    "E_star"
   ],
   "unit": "N",
   "place": "inside",
   "suffix": "Fr"
  },
  "ad": {
   "gives": "a",
   "needs": [
    "d",
    "h",
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
    "h",
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
    "h",
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
    "h",
    "b",
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
  "adh.d": {
   "gives": "d",
   "needs": [
    "a",
    "h",
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
    "h",
    "b",
    "E_star",
    "dgamma"
   ],
   "unit": "N",
   "place": "",
   "suffix": ""
  },
  "adh.p": {
   "gives": "p",
   "needs": [
    "r",
    "a",
    "h",
    "b",
    "E_star",
    "dgamma"
   ],
   "unit": "Pa",
   "place": "inside",
   "suffix": ""
  },
  "adh.w": {
   "gives": "w",
   "needs": [
    "r",
    "a",
    "h",
    "b",
    "E_star",
    "dgamma"
   ],
   "unit": "m",
   "place": "outside",
   "suffix": ""
  },
  "tan.F": {
   "gives": "F_x",
   "needs": [
    "a",
    "c",
    "h",
    "b",
    "E_star",
    "mu"
   ],
   "unit": "N",
   "place": "",
   "suffix": ""
  },
  "tan.tau": {
   "gives": "tau",
   "needs": [
    "r",
    "a",
    "c",
    "h",
    "b",
    "E_star",
    "mu"
   ],
   "unit": "Pa",
   "place": "inside",
   "suffix": ""
  },
  "tan.u": {
   "gives": "u_0",
   "needs": [
    "a",
    "c",
    "h",
    "b",
    "E_star",
    "G_star",
    "mu"
   ],
   "unit": "m",
   "place": "",
   "suffix": ""
  },
  "tan.c": {
   "gives": "c",
   "needs": [
    "F_x",
    "a",
    "h",
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
    "h",
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
