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

const _depth = (a, A) => {
  let v8;
  v8 = (a * a);
  return (((8.0 * A) / 3.0) * (v8 * v8));
};

const depth = (a, A) => {
  if ((!(0.0 < A && A < Infinity))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth(a, A) : NaN);
};

const _force = (a, A, E_star) => {
  return ((((64.0 * E_star) * A) / 15.0) * Math.pow(a, 5.0));
};

const force = (a, A, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force(a, A, E_star) : NaN);
};

const _pressure_of_quartic = (r, a, A, E_star) => {
  let root;
  root = Math.sqrt(((a - r) * (a + r)));
  return math.where((r < a), (((((32 * E_star) * A) / (9 * Math.PI)) * (Math.pow(a, 2) + (2 * Math.pow(r, 2)))) * root), 0.0);
};

const _pressure = (r, a, A, E_star) => {
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((r < a)) {
      return (((((32.0 * E_star) * A) / 28.274333882308138) * ((a * a) + (2.0 * (r * r)))) * Math.sqrt(((a - r) * (a + r))));
    }
    return 0.0;
  }
  return _pressure_of_quartic(r, a, A, E_star);
};

const pressure = (r, a, A, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure(r, a, A, E_star) : 0.0) : NaN);
};

const _displacement = (r, a, A) => {
  let v10, v17, v19, v81, v9;
  v9 = (a * a);
  v10 = (v9 * v9);
  if ((r > a)) {
    v17 = (a / (r + math.sqrt(((r - a) * (r + a)))));
    v19 = (v17 * v17);
    return ((((16.0 * A) / 9.42477796076938) * v10) * ((a / r) * (0.8 + (v19 * ((((((((((((((((((-4.320959889429597) * v19) + (-106.53004831006083)) * v19) + (-683.6776777243583)) * v19) + (-1307.862063615897)) * v19) + 1123.6903304493044) * v19) + 6598.931700123421) * v19) + 7450.127483097781) * v19) + 2696.481329529376) * v19) + 0.3809523809520408) / (((((((((((((((((-0.06548708381580395) * v19) + 10.743349921788495) * v19) + 655.5477291446655) * v19) + 5580.132341984832) * v19) + 18919.75045798054) * v19) + 30703.596314182465) * v19) + 23803.775464413437) * v19) + 7078.863490014608) * v19) + 1.0))))));
  }
  v81 = (r * r);
  return ((((8.0 * A) / 3.0) * v10) - (A * (v81 * v81)));
};

const displacement = (r, a, A) => {
  if ((!(0.0 < A && A < Infinity))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement(r, a, A) : 0.0) : NaN);
};

const _stiffness_of_quartic = (a, E_star) => {
  return ((2 * E_star) * a);
};

const _stiffness = (a, E_star, A = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (A > 1e-30) && (A < 1e+30))) {
    return ((2.0 * E_star) * a);
  }
  return _stiffness_of_quartic(a, E_star);
};

const stiffness = (a, A, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness(a, E_star) : NaN);
};

const _mean_pressure_of_quartic = (a, A, E_star) => {
  return ((((64 * E_star) * A) / (15 * Math.PI)) * Math.pow(a, 3));
};

const _mean_pressure = (a, A, E_star) => {
  if (((a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    return ((((64.0 * E_star) * A) / 47.12388980384689) * (a * (a * a)));
  }
  return _mean_pressure_of_quartic(a, A, E_star);
};

const mean_pressure = (a, A, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure(a, A, E_star) : NaN);
};

const _energy_of_quartic = (a, A, E_star) => {
  return ((((2048 * E_star) * Math.pow(A, 2)) / 405) * Math.pow(a, 9));
};

const _energy = (a, A, E_star) => {
  if (((a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    return ((((2048.0 * E_star) * (A * A)) / 405.0) * Math.pow(a, 9.0));
  }
  return _energy_of_quartic(a, A, E_star);
};

const energy = (a, A, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _energy(a, A, E_star) : NaN);
};

const _force_of_quartic = (a, A, E_star) => {
  return ((((64 * E_star) * A) / 15) * Math.pow(a, 5));
};

const _load_within_of_quartic = (r, a, A, E_star) => {
  let root, within;
  root = Math.sqrt(((a - r) * (a + r)));
  within = (((((64 * E_star) * A) / 45) * Math.pow(r, 2)) * ((((3 * Math.pow(a, 4)) / (root + a)) + (Math.pow(a, 2) * root)) + ((2 * Math.pow(r, 2)) * root)));
  return math.where((r < a), math.where((r > 0.0), within, 0.0), _force_of_quartic(a, A, E_star));
};

const _load_within = (r, a, A, E_star) => {
  let v10, v14, v17, v7;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v10 = ((64.0 * E_star) * A);
    if ((r < a)) {
      if ((r > 0.0)) {
        v7 = Math.sqrt(((a - r) * (a + r)));
        v14 = (r * r);
        v17 = (a * a);
        return (((v10 / 45.0) * v14) * ((((3.0 * (v17 * v17)) / (v7 + a)) + (v17 * v7)) + ((2.0 * v14) * v7)));
      }
      return 0.0;
    }
    return ((v10 / 15.0) * Math.pow(a, 5.0));
  }
  return _load_within_of_quartic(r, a, A, E_star);
};

const load_within = (r, a, A, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _load_within(r, a, A, E_star) : 0.0) : NaN);
};

const _radius_from_depth = (d, A) => {
  return math.sqrt(math.sqrt(((3.0 * d) / (8.0 * A))));
};

const radius_from_depth = (d, A) => {
  if ((!(0.0 < A && A < Infinity))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth(d, A) : NaN);
};

const _radius_from_force = (F, A, E_star) => {
  let v10, v8;
  v8 = ((15.0 * F) / ((64.0 * E_star) * A));
  v10 = Math.pow(v8, 0.2);
  if (((v8 > 0.0) && (v8 < Infinity))) {
    return (v10 + (v10 * (((v8 / (Math.pow(v10, 5.0) * Math.pow(v10, 0.0))) - 1.0) / 5.0)));
  }
  return v10;
};

const radius_from_force = (F, A, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _radius_from_force(F, A, E_star) : NaN);
};

const _force_from_depth = (d, A, E_star) => {
  return ((((4.0 * E_star) / 5.0) * d) * math.sqrt(math.sqrt(((6.0 * d) / A))));
};

const force_from_depth = (d, A, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth(d, A, E_star) : NaN);
};

const nth_root = (x, n, more = 0) => {
  let degree, y;
  degree = (n + more);
  y = Math.pow(x, (1.0 / degree));
  return math.where(((x > 0.0) & (x < Infinity)), (y + (y * (((x / (Math.pow(y, n) * Math.pow(y, more))) - 1.0) / degree))), y);
};

const without_root = (x, n, more = 0) => {
  return math.where(((x > 0.0) & (x < Infinity)), (x / nth_root(x, n, more)), x);
};

const nth_root_of_functions = (x, n, more = 0) => {
  let degree, y;
  degree = (n + more);
  y = Math.pow(x, (1.0 / degree));
  return (((x > 0.0) & (x < Infinity)) ? (y + (y * (((x / (Math.pow(y, n) * Math.pow(y, more))) - 1.0) / degree))) : y);
};

const _depth_from_force_of_quartic = (F, A, E_star) => {
  return (without_root((F / E_star), 5) * nth_root_of_functions(((625 * A) / 1536), 5));
};

const _depth_from_force = (F, A, E_star) => {
  let v10, v23, v27, v28, v3, v8;
  if (((F > 1e-30) && (F < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v3 = (F / E_star);
    v8 = ((v3 > 0.0) && (v3 < Infinity));
    if (v8) {
      v10 = Math.pow(v3, 0.2);
      v23 = (v3 / (v8 ? (v10 + (v10 * (((v3 / (Math.pow(v10, 5.0) * Math.pow(v10, 0.0))) - 1.0) / 5.0))) : v10));
    } else {
      v23 = v3;
    }
    v27 = ((625.0 * A) / 1536.0);
    v28 = Math.pow(v27, 0.2);
    return (v23 * (((v27 > 0.0) && (v27 < Infinity)) ? (v28 + (v28 * (((v27 / (Math.pow(v28, 5.0) * Math.pow(v28, 0.0))) - 1.0) / 5.0))) : v28));
  }
  return _depth_from_force_of_quartic(F, A, E_star);
};

const depth_from_force = (F, A, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force(F, A, E_star) : NaN);
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

const _depth_3 = (a, A) => {
  return (((8 * A) / 3) * Math.pow(a, 4));
};

const _depth_2 = (a, A, E_star, dgamma) => {
  return (_depth_3(a, A) - hess_retraction(a, E_star, dgamma));
};

const _depth_of_quartic = (a, A, E_star, dgamma) => {
  let v10;
  if (((a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v10 = (a * a);
    return ((((8.0 * A) / 3.0) * (v10 * v10)) - (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))));
  }
  return _depth_2(a, A, E_star, dgamma);
};

const depth_of_quartic = (a, A, E_star, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_of_quartic(a, A, E_star, dgamma) : NaN);
};

const pull = (a, E_star, dgamma) => {
  return (((2.0 * E_star) * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const _force_3 = (a, A, E_star, dgamma) => {
  return (_force_of_quartic(a, A, E_star) - pull(a, E_star, dgamma));
};

const _force_2 = (a, A, E_star, dgamma) => {
  if (((a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    return (((((64.0 * E_star) * A) / 15.0) * Math.pow(a, 5.0)) - (((2.0 * E_star) * a) * (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star)))));
  }
  return _force_3(a, A, E_star, dgamma);
};

const force_of_quartic = (a, A, E_star, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_2(a, A, E_star, dgamma) : NaN);
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

const _pressure_3 = (r, a, A, E_star, dgamma) => {
  return (_pressure_of_quartic(r, a, A, E_star) - tension(r, a, E_star, dgamma));
};

const _pressure_2 = (r, a, A, E_star, dgamma) => {
  let v29, v40, v5, v6;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v5 = (a - r);
    v6 = (a + r);
    if ((r <= a)) {
      v29 = (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star)));
      v40 = ((v29 > 0.0) ? ((E_star * v29) / (3.141592653589793 * Math.sqrt(((((v5 > 0.0) || (v5 !== v5)) ? v5 : 0.0) * v6)))) : 0.0);
    } else {
      v40 = 0.0;
    }
    return (((r < a) ? (((((32.0 * E_star) * A) / 28.274333882308138) * ((a * a) + (2.0 * (r * r)))) * Math.sqrt((v5 * v6))) : 0.0) - v40);
  }
  return _pressure_3(r, a, A, E_star, dgamma);
};

const pressure_of_quartic = (r, a, A, E_star, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_2(r, a, A, E_star, dgamma) : 0.0) : NaN);
};

const OUTSIDE_4 = [[0.3809523809520408, 2696.481329529376, 7450.127483097781, 6598.931700123421, 1123.6903304493044, (-1307.862063615897), (-683.6776777243583), (-106.53004831006083), (-4.320959889429597)], [1.0, 7078.863490014608, 23803.775464413437, 30703.596314182465, 18919.75045798054, 5580.132341984832, 655.5477291446655, 10.743349921788495, (-0.06548708381580395)], 0.8];

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

const _profile = (r, A) => {
  return (A * Math.pow(r, 4));
};

const _displacement_3 = (r, a, A) => {
  let inside, outside;
  outside = ((((16 * A) / (3 * Math.PI)) * Math.pow(a, 4)) * beside(r, a, OUTSIDE_4));
  inside = (_depth_3(a, A) - _profile(r, A));
  return math.where((r > a), outside, inside);
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

const _displacement_2 = (r, a, A, E_star, dgamma) => {
  return (_displacement_3(r, a, A) - lift(r, a, E_star, dgamma));
};

const _displacement_of_quartic = (r, a, A, E_star, dgamma) => {
  let v11, v12, v14, v15, v19, v21, v83, v87, v88;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v11 = (a * a);
    v12 = (v11 * v11);
    v14 = (r - a);
    v15 = (r + a);
    v87 = (r > a);
    if (v87) {
      v19 = (a / (r + Math.sqrt((v14 * v15))));
      v21 = (v19 * v19);
      v88 = ((((16.0 * A) / 9.42477796076938) * v12) * ((a / r) * (0.8 + (v21 * ((((((((((((((((((-4.320959889429597) * v21) + (-106.53004831006083)) * v21) + (-683.6776777243583)) * v21) + (-1307.862063615897)) * v21) + 1123.6903304493044) * v21) + 6598.931700123421) * v21) + 7450.127483097781) * v21) + 2696.481329529376) * v21) + 0.3809523809520408) / (((((((((((((((((-0.06548708381580395) * v21) + 10.743349921788495) * v21) + 655.5477291446655) * v21) + 5580.132341984832) * v21) + 18919.75045798054) * v21) + 30703.596314182465) * v21) + 23803.775464413437) * v21) + 7078.863490014608) * v21) + 1.0))))));
    } else {
      v83 = (r * r);
      v88 = ((((8.0 * A) / 3.0) * v12) - (A * (v83 * v83)));
    }
    return (v88 - ((Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))) * (v87 ? (0.6366197723675814 * Math.atan2(a, Math.sqrt(((((v14 > 0.0) || (v14 !== v14)) ? v14 : 0.0) * v15)))) : 1.0)));
  }
  return _displacement_2(r, a, A, E_star, dgamma);
};

const displacement_of_quartic = (r, a, A, E_star, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_of_quartic(r, a, A, E_star, dgamma) : 0.0) : NaN);
};

const _pull_off_radius = (A, E_star, dgamma, control) => {
  let radius;
  if ((control === 'force')) {
    radius = (Math.pow(nth_root_of_functions((1 / A), 7), 2) * nth_root_of_functions((((81 * Math.PI) * dgamma) / (2048 * E_star)), 7));
  } else {
    radius = (Math.pow(nth_root_of_functions((1 / A), 7), 2) * nth_root_of_functions((((9 * Math.PI) * dgamma) / (2048 * E_star)), 7));
  }
  return ((dgamma > 0.0) ? radius : 0.0);
};

const XI = {'force': 3.0, 'depth': 1.0};

const _pull_off_depth = (a, A, E_star, dgamma, control) => {
  return (_depth(a, A) * (1.0 - (8.0 / XI[control])));
};

const ROUNDING = 1e-15;

const _missed = (value, y) => {
  let v3, v6;
  v3 = ((value - y) / y);
  v6 = (Math.abs(v3) < 0.5);
  if (v6) {
    return math.log1p((v6 ? v3 : 0.0));
  }
  return math.log((value / y));
};

const ROUNDING_of_inverse = 1.1102230246251565e-16;

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
  close = ((noise == null) ? (ROUNDING_of_inverse * value) : noise);
  known = (y === y);
  solvable = (((value > 0.0) & (value < Infinity)) & known);
  for (iteration of math.range(ITERATIONS)) {
    left = (solvable & math.logical_not((Math.abs(error) <= (SETTLED * math.minimum(slope, 1.0)))));
    left = (left & math.logical_not((Math.abs((value - y)) <= close)));
    if ((share != null)) {
      moved = math.maximum(share(t), share(math.minimum((t * Math.exp(math.minimum(step, 700.0))), largest)));
      left = (left & math.logical_not(((Math.abs(error) * moved) <= ((4.0 * ROUNDING_of_inverse) * slope))));
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

const _growth = (e, m) => {
  let _, curve, far, near, start;
  curve = (s) => {
    let log, more, rate, value;
    log = Math.log1p(s);
    more = (((s > 1.0) & (((m - 1.0) * log) > 1.0)) ? (Math.pow((1.0 + s), (m - 1.0)) - 1.0) : Math.expm1(((m - 1.0) * log)));
    rate = ((m * more) / (m - 1.0));
    value = (((math.minimum(s, 4.0) * math.maximum(m, 2.0)) < 4.0) ? near(s) : ((((1.0 + s) * rate) / m) - s));
    return [value, ((s * rate) / value)];
  };
  near = (s) => {
    s = math.minimum(s, 2.0);
    return (((m * s) * s) * math.integral(((y) => ((1.0 - y) * Math.exp(((m - 2.0) * Math.log1p((s * y)))))), math.ones_like(s), 16));
  };
  far = 0.0;
  for (_ of math.range(3)) {
    far = Math.expm1((Math.log1p((((m - 1.0) * e) + (m * far))) / m));
  }
  start = (((e * m) < 1.0) ? Math.sqrt(((2.0 * e) / m)) : far);
  return inverse(curve, e, start, [math.minimum(m, 2.0), math.maximum(m, 2.0)]);
};

const power_law_radius = (value, a_c, least, p, q, plain) => {
  let a, e, m, s;
  m = ((p / q) + math.zeros_like(value));
  e = ((least < 0.0) ? (1.0 - (value / ((least < 0.0) ? least : (-1.0)))) : Infinity);
  e = ((Math.abs(e) < ROUNDING) ? 0.0 : e);
  s = _growth(((e > 0.0) ? e : 1.0), m);
  a = (a_c * Math.pow((1.0 + ((e === 0.0) ? 0.0 : s)), (1.0 / q)));
  return ((e < 0.0) ? NaN : (Number.isFinite(e) ? a : ((value >= 0.0) ? plain : NaN)));
};

const _radius_from_depth_of_quartic = (d, A, E_star, dgamma) => {
  let a_c, least, plain;
  a_c = _pull_off_radius(A, E_star, dgamma, 'depth');
  least = _pull_off_depth(a_c, A, E_star, dgamma, 'depth');
  plain = _radius_from_depth(math.maximum(d, 0.0), A);
  return power_law_radius(d, a_c, least, 4.0, 0.5, plain);
};

const radius_from_depth_of_quartic = (d, A, E_star, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_depth_of_quartic(d, A, E_star, dgamma);
};

const _pull_off_force = (a, A, E_star, dgamma, control) => {
  return (_force(a, A, E_star) * (1.0 - (10.0 / XI[control])));
};

const _radius_from_force_of_quartic = (F, A, E_star, dgamma) => {
  let a_c, least, plain;
  a_c = _pull_off_radius(A, E_star, dgamma, 'force');
  least = _pull_off_force(a_c, A, E_star, dgamma, 'force');
  plain = _radius_from_force(math.maximum(F, 0.0), A, E_star);
  return power_law_radius(F, a_c, least, 5.0, 1.5, plain);
};

const radius_from_force_of_quartic = (F, A, E_star, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_force_of_quartic(F, A, E_star, dgamma);
};

const gained_share = (c, a, n) => {
  return (-Math.expm1(((-n) * ((a > c) ? math.log1p(((a - c) / c)) : 0.0))));
};

const _tangential_force_of_quartic = (a, c, A, E_star, mu) => {
  return ((mu * _force_of_quartic(a, A, E_star)) * gained_share(c, a, 5.0));
};

const _tangential_force = (a, c, A, E_star, mu) => {
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    return ((mu * ((((64.0 * E_star) * A) / 15.0) * Math.pow(a, 5.0))) * (-Math.expm1(((-5.0) * ((a > c) ? Math.log1p(((a - c) / c)) : 0.0)))));
  }
  return _tangential_force_of_quartic(a, c, A, E_star, mu);
};

const tangential_force = (a, c, A, E_star, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_force(a, c, A, E_star, mu) : NaN);
};

const _slope = (t, A) => {
  return (((32 * A) / 3) * Math.pow(t, 3));
};

const difference_root = (x, y) => {
  let v2;
  v2 = (x - y);
  return math.sqrt(((((v2 > 0.0) || (v2 !== v2)) ? v2 : 0.0) * (x + y)));
};

const root_gain = (r, c, a) => {
  return math.where((a > c), (((a - c) * (a + c)) / (difference_root(a, r) + difference_root(c, r))), 0.0);
};

const even_gain = (r, c, a, n) => {
  let inner, j, outer, power, quotient, total;
  [outer, inner] = [difference_root(a, r), difference_root(c, r)];
  [quotient, power, total] = [0.0, 1.0, 1.0];
  for (j of math.range(4, (n + 1), 2)) {
    [quotient, power] = [(((a * a) * quotient) + power), ((c * c) * power)];
    total = (((((((j - 2) * r) * r) * total) + ((quotient * (outer + inner)) * outer)) + power) / (j - 1));
  }
  return (root_gain(r, c, a) * total);
};

const _traction_of_quartic = (r, a, c, A, E_star, mu) => {
  let gain, sliding;
  sliding = _pressure_of_quartic(r, a, A, E_star);
  gain = (((E_star / Math.PI) * _slope(1.0, A)) * even_gain(r, c, a, 4));
  return (mu * math.where((r < c), gain, sliding));
};

const _traction = (r, a, c, A, E_star, mu) => {
  let v34, v35, v46, v6, v61, v7;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v6 = (a - r);
    v7 = (a + r);
    if ((r < c)) {
      v34 = Math.sqrt(((((v6 > 0.0) || (v6 !== v6)) ? v6 : 0.0) * v7));
      v35 = (c - r);
      v46 = (v34 + Math.sqrt(((((v35 > 0.0) || (v35 !== v35)) ? v35 : 0.0) * (c + r))));
      v61 = (((E_star / 3.141592653589793) * ((32.0 * A) / 3.0)) * (((a > c) ? (((a - c) * (a + c)) / v46) : 0.0) * (((((2.0 * r) * r) + (((((a * a) * 0.0) + 1.0) * v46) * v34)) + (c * c)) / 3.0)));
    } else {
      v61 = ((r < a) ? (((((32.0 * E_star) * A) / 28.274333882308138) * ((a * a) + (2.0 * (r * r)))) * Math.sqrt((v6 * v7))) : 0.0);
    }
    return (mu * v61);
  }
  return _traction_of_quartic(r, a, c, A, E_star, mu);
};

const traction = (r, a, c, A, E_star, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction(r, a, c, A, E_star, mu) : 0.0) : NaN);
};

const _tangential_displacement_of_quartic = (a, c, A, E_star, G_star, mu) => {
  return (((mu * (E_star / G_star)) * _depth_3(a, A)) * gained_share(c, a, 4.0));
};

const _tangential_displacement = (a, c, A, E_star, G_star, mu) => {
  let v14;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v14 = (a * a);
    return (((mu * (E_star / G_star)) * (((8.0 * A) / 3.0) * (v14 * v14))) * (-Math.expm1(((-4.0) * ((a > c) ? Math.log1p(((a - c) / c)) : 0.0)))));
  }
  return _tangential_displacement_of_quartic(a, c, A, E_star, G_star, mu);
};

const tangential_displacement = (a, c, A, E_star, G_star, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement(a, c, A, E_star, G_star, mu) : NaN);
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

const _radius_from_force_2 = (F, A, E_star) => {
  return nth_root_of_functions(((15 * F) / ((64 * E_star) * A)), 5);
};

const _stick_radius_of_quartic = (F_x, a, A, E_star, mu) => {
  let F;
  F = stick_force(_force_of_quartic(a, A, E_star), F_x, mu);
  return math.where(((F_x === 0.0) & (a >= 0.0)), a, _radius_from_force_2(F, A, E_star));
};

const _stick_radius = (F_x, a, A, E_star, mu) => {
  let v12, v14, v20, v28, v30, v7;
  if (((F_x > 1e-30) && (F_x < 1e+30) && (a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    if (((F_x === 0.0) && (a >= 0.0))) {
      return a;
    }
    v7 = ((64.0 * E_star) * A);
    v12 = ((v7 / 15.0) * Math.pow(a, 5.0));
    v14 = (v12 - (F_x / mu));
    v20 = ((Math.abs(v14) <= (2e-16 * v12)) ? 0.0 : v14);
    v28 = ((15.0 * ((v20 >= 0.0) ? v20 : NaN)) / v7);
    v30 = Math.pow(v28, 0.2);
    if (((v28 > 0.0) && (v28 < Infinity))) {
      return (v30 + (v30 * (((v28 / (Math.pow(v30, 5.0) * Math.pow(v30, 0.0))) - 1.0) / 5.0)));
    }
    return v30;
  }
  return _stick_radius_of_quartic(F_x, a, A, E_star, mu);
};

const stick_radius = (F_x, a, A, E_star, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius(F_x, a, A, E_star, mu) : NaN);
};

const _full_slip_displacement_of_quartic = (a, A, E_star, G_star, mu) => {
  return ((mu * (E_star / G_star)) * _depth_3(a, A));
};

const _full_slip_displacement = (a, A, E_star, G_star, mu) => {
  let v13;
  if (((a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v13 = (a * a);
    return ((mu * (E_star / G_star)) * (((8.0 * A) / 3.0) * (v13 * v13)));
  }
  return _full_slip_displacement_of_quartic(a, A, E_star, G_star, mu);
};

const full_slip_displacement = (a, A, E_star, G_star, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement(a, A, E_star, G_star, mu) : NaN);
};

const formulas = {
  "d": (v) => depth(v.a, v.A),
  "F": (v) => force(v.a, v.A, v.E_star),
  "p": (v) => pressure(v.r, v.a, v.A, v.E_star),
  "w": (v) => displacement(v.r, v.a, v.A),
  "k": (v) => stiffness(v.a, v.A, v.E_star),
  "pm": (v) => mean_pressure(v.a, v.A, v.E_star),
  "U": (v) => energy(v.a, v.A, v.E_star),
  "Fr": (v) => load_within(v.r, v.a, v.A, v.E_star),
  "ad": (v) => radius_from_depth(v.d, v.A),
  "aF": (v) => radius_from_force(v.F, v.A, v.E_star),
  "Fd": (v) => force_from_depth(v.d, v.A, v.E_star),
  "dF": (v) => depth_from_force(v.F, v.A, v.E_star),
  "adh.Dl": (v) => retraction(v.a, v.E_star, v.dgamma),
  "adh.d": (v) => depth_of_quartic(v.a, v.A, v.E_star, v.dgamma),
  "adh.F": (v) => force_of_quartic(v.a, v.A, v.E_star, v.dgamma),
  "adh.p": (v) => pressure_of_quartic(v.r, v.a, v.A, v.E_star, v.dgamma),
  "adh.w": (v) => displacement_of_quartic(v.r, v.a, v.A, v.E_star, v.dgamma),
  "adh.ad": (v) => radius_from_depth_of_quartic(v.d, v.A, v.E_star, v.dgamma),
  "adh.aF": (v) => radius_from_force_of_quartic(v.F, v.A, v.E_star, v.dgamma),
  "tan.F": (v) => tangential_force(v.a, v.c, v.A, v.E_star, v.mu),
  "tan.tau": (v) => traction(v.r, v.a, v.c, v.A, v.E_star, v.mu),
  "tan.u": (v) => tangential_displacement(v.a, v.c, v.A, v.E_star, v.G_star, v.mu),
  "tan.c": (v) => stick_radius(v.F_x, v.a, v.A, v.E_star, v.mu),
  "tan.us": (v) => full_slip_displacement(v.a, v.A, v.E_star, v.G_star, v.mu),
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
   "value": 2000000.0
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
   "value": 50.0
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
    "A"
   ],
   "unit": "m",
   "place": "",
   "suffix": "d"
  },
  "F": {
   "gives": "F",
   "needs": [
    "a",
    "A",
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
    "A",
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
    "A"
   ],
   "unit": "m",
   "place": "outside",
   "suffix": "w"
  },
  "k": {
   "gives": "stiffness",
   "needs": [
    "a",
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A"
   ],
   "unit": "m",
   "place": "",
   "suffix": "ad"
  },
  "aF": {
   "gives": "a",
   "needs": [
    "F",
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
    "E_star",
    "dgamma"
   ],
   "unit": "m",
   "place": "outside",
   "suffix": ""
  },
  "adh.ad": {
   "gives": "a",
   "needs": [
    "d",
    "A",
    "E_star",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": ""
  },
  "adh.aF": {
   "gives": "a",
   "needs": [
    "F",
    "A",
    "E_star",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": ""
  },
  "tan.F": {
   "gives": "F_x",
   "needs": [
    "a",
    "c",
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
