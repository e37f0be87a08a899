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

const _depth = (a, R, theta) => {
  let v16, v19, v22, v4, v6, v9;
  v4 = (R * Math.sin(theta));
  v9 = (R - a);
  if ((a < v4)) {
    return (a * (math.log1p(((2.0 * a) / v9)) / 2.0));
  }
  v6 = (R * Math.cos(theta));
  v16 = ((v6 < v4) ? ((v6 * v6) - (v9 * (R + a))) : ((a - v4) * (a + v4)));
  v19 = math.sqrt((((v16 > 0.0) || (v16 !== v16)) ? v16 : 0.0));
  v22 = (v4 * v4);
  return (a * (math.log1p((((v22 / (v19 + a)) + (v22 / (v6 + R))) / (v19 + v6))) + ((v4 * Math.atan2(v19, v4)) / v6)));
};

const depth = (a, R, theta) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth(a, R, theta) : NaN);
};

const RULE_0 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _force = (a, R, theta, E_star) => {
  let node, v102, v103, v106, v108, v112, v120, v121, v129, v130, v17, v20, v21, v29, v34, v40, v5, v7, v75, v83, v85, v89, v92, v93, weight;
  v5 = (R * Math.sin(theta));
  v7 = (R * Math.cos(theta));
  v17 = ((v7 < v5) ? ((v7 * v7) - ((R - a) * (R + a))) : ((a - v5) * (a + v5)));
  v20 = math.sqrt((((v17 > 0.0) || (v17 !== v17)) ? v17 : 0.0));
  v21 = (((a < v5) || (a !== a)) ? a : v5);
  v29 = Math.asinh((v21 / ((a < v5) ? math.sqrt(((R - v21) * (v21 + R))) : v7)));
  v34 = Math.tanh(v29);
  if ((v29 < 1.0)) {
    v40 = (v29 * v29);
    v75 = ((v34 * (v34 * v34)) * (((((((((((1.0716932453474512e-06 * v40) + 0.00019982814521087247) * v40) + 0.007076196047699156) * v40) + 0.08608622548411103) * v40) + 0.3073858328214721) * v40) + 0.3333333333333333) / ((((((((((2.565078604208634e-08 * v40) + 2.0203143566039827e-05) * v40) + 0.001617010334189783) * v40) + 0.03639274880225476) * v40) + 0.32215749846441627) * v40) + 1.0)));
  } else {
    v75 = (v29 - v34);
  }
  v83 = (1.0 - ((2.0 * theta) / 3.141592653589793));
  v85 = Math.asinh((v20 / v5));
  v89 = (0.0 - Math.expm1(((-2.0) * v85)));
  v92 = ((v89 > 0.0) ? v89 : Infinity);
  v103 = (v5 * v5);
  v108 = (v5 * v5);
  v112 = (v108 / (v7 + R));
  v120 = (v108 * R);
  v121 = (v7 * v7);
  v130 = [];
  for ([node, weight] of RULE_0((v85 / v83))) {
    v93 = (node * v85);
    v102 = (v20 * ((Math.exp((-v93)) * (0.0 - Math.expm1(((-2.0) * (v85 - v93))))) / v92));
    v106 = math.sqrt((v103 + (v102 * v102)));
    v129 = ((((math.log1p((((v108 / (v102 + v106)) + v112) / (v102 + v7))) + ((v5 * Math.atan2(v102, v5)) / v7)) + (v120 / ((v106 * v121) + ((R * v102) * v7)))) * v102) * v106);
    v130.push((weight * v129));
  }
  v130 = (math.fsum(v130) * v85);
  return ((E_star * (((v21 * v21) * v29) + ((R * R) * v75))) + ((2.0 * E_star) * v130));
};

const force = (a, R, theta, E_star) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force(a, R, theta, E_star) : NaN);
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

const _slope_beyond = (t, root, R, theta) => {
  let v10, v5, v7;
  v5 = (R * Math.sin(theta));
  v7 = (R * Math.cos(theta));
  v10 = (v5 * v5);
  return ((math.log1p((((v10 / (root + t)) + (v10 / (v7 + R))) / (root + v7))) + ((v5 * Math.atan2(root, v5)) / v7)) + ((v10 * R) / ((t * (v7 * v7)) + ((R * root) * v7))));
};

const pressure_integral_beyond = math.in_groups((slope, r, a, b) => {
  let fallen, integrand, outside, reach, stop, within;
  r = ((r === b) ? math.nextafter(b, Infinity) : r);
  within = (r < b);
  [outside, reach] = [(within ? 0.0 : 1.0), difference_root(a, b)];
  stop = Math.asinh(((within ? reach : difference_root(a, r)) / Math.sqrt((Math.abs((r - b)) * (r + b)))));
  fallen = falling(stop, outside);
  integrand = (v) => {
    let root, t;
    root = (reach * fallen(v));
    t = Math.sqrt(((b * b) + (root * root)));
    return ((slope(t, root) * root) / t);
  };
  return [integrand, stop, 1.0, (a > math.maximum(r, b)), 0.0];
});

const _pressure_of_sphere_tipped_cone = (r, a, R, theta, E_star) => {
  let b, growth, inner, root, root_Rr, root_ar, tip, within;
  b = (R * Math.sin(theta));
  inner = math.minimum(a, b);
  root_Rr = Math.sqrt(((R - r) * (r + R)));
  root = ((a < b) ? Math.sqrt(((R - inner) * (inner + R))) : (R * Math.cos(theta)));
  root_ar = Math.sqrt(((inner - r) * (inner + r)));
  within = ((E_star / Math.PI) * (((R * Math.asinh((root_ar / root))) / root_Rr) + arc_strips(r, inner, R)));
  tip = ((r < inner) ? within : 0.0);
  growth = pressure_integral_beyond(_slope_beyond, [R, theta], r, a, b, { width: (1.0 - ((2.0 * theta) / Math.PI)) });
  return ((r < a) ? (tip + ((E_star / Math.PI) * growth)) : 0.0);
};

const RULE_0_of_sphere_tipped_cone = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _pressure = (r, a, R, theta, E_star) => {
  let node, v101, v106, v107, v111, v116, v121, v126, v131, v150, v153, v157, v158, v160, v164, v165, v170, v177, v178, v179, v18, v184, v186, v189, v199, v20, v200, v203, v205, v209, v21, v217, v218, v226, v227, v228, v25, v33, v38, v39, v40, v43, v44, v45, v51, v56, v6, v61, v66, v7, v71, v76, v8, v81, v86, v91, v96, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R > 1e-30) && (R < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v6 = (R * Math.sin(theta));
    v7 = (((a < v6) || (a !== a)) ? a : v6);
    v8 = (R - r);
    v20 = (v7 - r);
    v21 = (v7 + r);
    v33 = Math.sqrt(((((v20 > 0.0) || (v20 !== v20)) ? v20 : 0.0) * v21));
    v38 = (R + Math.sqrt(((((v8 > 0.0) || (v8 !== v8)) ? v8 : 0.0) * (R + r))));
    v39 = (v7 + v33);
    v40 = (v39 / v38);
    if ((v40 > 0.7)) {
      return _pressure_of_sphere_tipped_cone(r, a, R, theta, E_star);
    }
    if ((r < a)) {
      v18 = (R * Math.cos(theta));
      v25 = (E_star / 3.141592653589793);
      if ((r < v7)) {
        v43 = ((r * (r / v39)) / v38);
        v44 = (v40 * v40);
        v45 = (v43 * v43);
        v51 = ((0.13579013365982337 * v44) + (-0.4846453962188766));
        v56 = ((v51 * v44) + 0.8293825948837366);
        v61 = ((v56 * v44) + (-0.8745573865774817));
        v66 = ((v61 * v44) + 0.6371928816963097);
        v71 = ((v66 * v44) + (-0.3332798652335896));
        v76 = ((v71 * v44) + 0.13289328569967984);
        v81 = ((v76 * v44) + (-0.03710676078458442));
        v86 = ((v81 * v44) + 0.011089560042611895);
        v91 = ((v86 * v44) + 0.0012521687336059639);
        v96 = ((v91 * v44) + 0.0036572276005780893);
        v101 = ((v96 * v44) + 0.004425450516633092);
        v106 = ((v101 * v44) + 0.005918487051520244);
        v107 = (((((((((((((((((((((((((0.0 * v45) + 0.13579013365982337) * v45) + v51) * v45) + v56) * v45) + v61) * v45) + v66) * v45) + v71) * v45) + v76) * v45) + v81) * v45) + v86) * v45) + v91) * v45) + v96) * v45) + v101) * v45);
        v111 = ((v106 * v44) + 0.008264397984935742);
        v116 = ((v111 * v44) + 0.012345681107818056);
        v121 = ((v116 * v44) + 0.020408163224119494);
        v126 = ((v121 * v44) + 0.04000000000042643);
        v131 = ((v126 * v44) + 0.11111111111110937);
        v150 = (v25 * (((R * Math.asinh((Math.sqrt((v20 * v21)) / ((a < v6) ? Math.sqrt(((R - v7) * (v7 + R))) : v18)))) / Math.sqrt((v8 * (r + R)))) + (((2.0 * v33) / v38) * (((v131 * v44) + 1.0) + ((v43 * (v43 + v40)) * (((((((((((v107 + v106) * v45) + v111) * v45) + v116) * v45) + v121) * v45) + v126) * v45) + v131))))));
      } else {
        v150 = 0.0;
      }
      v157 = ((r === v6) ? math.nextafter(v6, Infinity) : r);
      if ((a > (((v157 > v6) || (v157 !== v157)) ? v157 : v6))) {
        v153 = (1.0 - ((2.0 * theta) / 3.141592653589793));
        v158 = (v157 < v6);
        v160 = (a - v6);
        v164 = Math.sqrt(((((v160 > 0.0) || (v160 !== v160)) ? v160 : 0.0) * (a + v6)));
        if (v158) {
          v170 = v164;
        } else {
          v165 = (a - v157);
          v170 = Math.sqrt(((((v165 > 0.0) || (v165 !== v165)) ? v165 : 0.0) * (a + v157)));
        }
        v177 = Math.asinh((v170 / Math.sqrt((Math.abs((v157 - v6)) * (v157 + v6)))));
        v178 = (2.0 * (v158 ? 0.0 : 1.0));
        v179 = (1.0 - v178);
        v184 = (v178 - (v179 * Math.expm1(((-2.0) * v177))));
        v186 = ((v184 > 0.0) ? v184 : Infinity);
        v200 = (v6 * v6);
        v205 = (v6 * v6);
        v209 = (v205 / (v18 + R));
        v217 = (v205 * R);
        v218 = (v18 * v18);
        v227 = [];
        for ([node, weight] of RULE_0_of_sphere_tipped_cone((v177 / v153))) {
          v189 = (node * v177);
          v199 = (v164 * ((Math.exp((-v189)) * (v178 - (v179 * Math.expm1(((-2.0) * (v177 - v189)))))) / v186));
          v203 = Math.sqrt((v200 + (v199 * v199)));
          v226 = ((((Math.log1p((((v205 / (v199 + v203)) + v209) / (v199 + v18))) + ((v6 * Math.atan2(v199, v6)) / v18)) + (v217 / ((v203 * v218) + ((R * v199) * v18)))) * v199) / v203);
          v227.push((weight * v226));
        }
        v227 = (math.fsum(v227) * v177);
        v228 = v227;
      } else {
        v228 = 0.0;
      }
      return (v150 + (v25 * v228));
    }
    return 0.0;
  }
  return _pressure_of_sphere_tipped_cone(r, a, R, theta, E_star);
};

const pressure = (r, a, R, theta, E_star) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure(r, a, R, theta, E_star) : 0.0) : NaN);
};

const _displacement = (r, a, R, theta) => {
  let node, v100, v109, v110, v112, v114, v115, v118, v119, v126, v128, v131, v132, v14, v140, v141, v15, v153, v154, v156, v162, v167, v169, v187, v20, v23, v25, v34, v37, v39, v40, v41, v43, v45, v47, v48, v5, v51, v55, v56, v58, v6, v68, v69, v7, v70, v74, v75, v79, v8, v80, v81, v83, v86, v91, v93, v96, v98, weight;
  v5 = (R * Math.sin(theta));
  v43 = (r + R);
  v51 = (R - r);
  v75 = (r - v5);
  v81 = (a - v5);
  v83 = (a + v5);
  v126 = (R * Math.cos(theta));
  v128 = (v5 * v5);
  v131 = (v126 + R);
  v132 = (v128 / v131);
  if ((r > a)) {
    v6 = (((a < v5) || (a !== a)) ? a : v5);
    v7 = (((r < R) || (r !== r)) ? r : R);
    if ((v6 < v7)) {
      v8 = (v7 - v6);
      v14 = (v6 / math.sqrt(((((v8 > 0.0) || (v8 !== v8)) ? v8 : 0.0) * (v7 + v6))));
      v15 = Math.asinh(v14);
      v20 = (0.0 - Math.expm1(((-2.0) * v15)));
      v23 = ((v20 > 0.0) ? v20 : Infinity);
      v41 = (r - R);
      v45 = math.sqrt(((((v41 > 0.0) || (v41 !== v41)) ? v41 : 0.0) * v43));
      v47 = (v45 * v45);
      v55 = math.sqrt(((((v51 > 0.0) || (v51 !== v51)) ? v51 : 0.0) * (R + r)));
      v56 = (v55 * v55);
      v69 = [];
      for ([node, weight] of RULE_0((v15 / 1.0))) {
        v25 = (node * v15);
        v34 = (v14 * ((Math.exp((-v25)) * (0.0 - Math.expm1(((-2.0) * (v15 - v25))))) / v23));
        v37 = math.sqrt((1.0 + (v34 * v34)));
        v39 = (v7 * (v34 / v37));
        v40 = (v7 / v37);
        v48 = (v40 * v40);
        v58 = math.sqrt((v56 + v48));
        v68 = (((Math.asinh((v39 / v58)) + ((R * v39) / (v58 * v58))) * Math.atan2(v39, math.sqrt((v47 + v48)))) * (v40 / v37));
        v69.push((weight * v68));
      }
      v69 = (math.fsum(v69) * v15);
      v70 = v69;
    } else {
      v70 = Infinity;
    }
    if ((a > v5)) {
      v74 = (1.0 - ((2.0 * theta) / 3.141592653589793));
      v79 = math.sqrt(((((v75 > 0.0) || (v75 !== v75)) ? v75 : 0.0) * (r + v5)));
      v80 = (v5 / r);
      v86 = (r - a);
      v91 = (math.sqrt(((((v81 > 0.0) || (v81 !== v81)) ? v81 : 0.0) * v83)) / math.sqrt(((((v86 > 0.0) || (v86 !== v86)) ? v86 : 0.0) * (r + a))));
      v93 = Math.asinh((v91 / v80));
      v96 = (0.0 - Math.expm1(((-2.0) * v93)));
      v98 = ((v96 > 0.0) ? v96 : Infinity);
      v115 = (v5 * v5);
      v119 = (v80 * v80);
      v140 = (v128 * R);
      v141 = (v126 * v126);
      v154 = [];
      for ([node, weight] of RULE_0((v93 / v74))) {
        v100 = (node * v93);
        v109 = (v91 * ((Math.exp((-v100)) * (0.0 - Math.expm1(((-2.0) * (v93 - v100))))) / v98));
        v110 = (v109 * v109);
        v112 = math.sqrt((1.0 + v110));
        v114 = ((v79 * v109) / v112);
        v118 = math.sqrt((v115 + (v114 * v114)));
        v153 = ((((((math.log1p((((v128 / (v114 + v118)) + v132) / (v114 + v126))) + ((v5 * Math.atan2(v114, v5)) / v126)) + (v140 / ((v118 * v141) + ((R * v114) * v126)))) * v114) / v118) * Math.atan2(v118, (v79 / v112))) * (math.sqrt((v119 + v110)) / ((v112 * v112) * v112)));
        v154.push((weight * v153));
      }
      v154 = (math.fsum(v154) * v93);
      v156 = (v79 * v154);
    } else {
      v156 = 0.0;
    }
    return (0.6366197723675814 * (v70 + v156));
  }
  v162 = (R - a);
  if ((a < v5)) {
    v187 = (a * (math.log1p(((2.0 * a) / v162)) / 2.0));
  } else {
    v167 = ((v126 < v5) ? ((v126 * v126) - (v162 * (R + a))) : (v81 * v83));
    v169 = math.sqrt((((v167 > 0.0) || (v167 !== v167)) ? v167 : 0.0));
    v187 = (a * (math.log1p((((v128 / (v169 + a)) + v132) / (v169 + v126))) + ((v5 * Math.atan2(v169, v5)) / v126)));
  }
  return (v187 - ((r < v5) ? ((r * r) / (math.sqrt((v51 * v43)) + R)) : (v5 * ((v75 / v126) + (v5 / v131)))));
};

const displacement = (r, a, R, theta) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement(r, a, R, theta) : 0.0) : NaN);
};

const _stiffness_of_sphere_tipped_cone = (a, E_star) => {
  return ((2 * E_star) * a);
};

const _stiffness = (a, E_star, R = 1.0, theta = 0.7853981633974483) => {
  if (((a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (R > 1e-30) && (R < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966))) {
    return ((2.0 * E_star) * a);
  }
  return _stiffness_of_sphere_tipped_cone(a, E_star);
};

const stiffness = (a, R, theta, E_star) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness(a, E_star) : NaN);
};

const sine_root = (x, R, theta) => {
  let v16, v4, v6;
  v4 = (R * Math.sin(theta));
  v6 = (R * Math.cos(theta));
  v16 = ((v6 < v4) ? ((v6 * v6) - ((R - x) * (R + x))) : ((x - v4) * (x + v4)));
  return math.sqrt((((v16 > 0.0) || (v16 !== v16)) ? v16 : 0.0));
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

const _slope_beyond_of_sphere_tipped_cone = (t, root, R, theta) => {
  let angle, b, logarithm, root_Rb;
  b = (R * Math.sin(theta));
  root_Rb = (R * Math.cos(theta));
  angle = Math.atan2(root, b);
  logarithm = Math.log1p((((Math.pow(b, 2) / (root + t)) + (Math.pow(b, 2) / (root_Rb + R))) / (root + root_Rb)));
  return ((logarithm + ((b * angle) / root_Rb)) + ((Math.pow(b, 2) * R) / ((t * Math.pow(root_Rb, 2)) + ((R * root) * root_Rb))));
};

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

const force_integral_beyond = math.in_groups((slope, reach, b) => {
  let fallen, integrand, stop;
  stop = Math.asinh((reach / b));
  fallen = falling_of_rules(stop);
  integrand = (v) => {
    let root, t;
    root = (reach * fallen(v));
    t = Math.sqrt(((b * b) + (root * root)));
    return ((slope(t, root) * root) * t);
  };
  return [integrand, stop, 1.0, true, 0.0];
});

const _force_at = (a, reach, R, theta, E_star) => {
  let angle, b, beyond, inner, root, tip;
  b = (R * Math.sin(theta));
  inner = math.minimum(a, b);
  root = math.where((a < b), Math.sqrt(((R - inner) * (inner + R))), (R * Math.cos(theta)));
  angle = Math.asinh((inner / root));
  tip = (E_star * ((Math.pow(inner, 2) * angle) + (Math.pow(R, 2) * tanh_gap(angle, Math.tanh(angle)))));
  beyond = ((2 * E_star) * force_integral_beyond(_slope_beyond_of_sphere_tipped_cone, [R, theta], reach, b, { width: (1.0 - ((2.0 * theta) / Math.PI)) }));
  return (tip + beyond);
};

const _force_of_sphere_tipped_cone = (a, R, theta, E_star) => {
  return _force_at(a, sine_root(a, R, theta), R, theta, E_star);
};

const _mean_pressure_of_sphere_tipped_cone = (a, R, theta, E_star) => {
  return math.where((a > 0.0), (_force_of_sphere_tipped_cone(a, R, theta, E_star) / (Math.PI * Math.pow(a, 2))), 0.0);
};

const _mean_pressure = (a, R, theta, E_star) => {
  let node, v103, v104, v107, v109, v113, v121, v122, v130, v131, v19, v21, v22, v30, v35, v41, v7, v76, v84, v86, v9, v90, v93, v94, weight;
  if (((a > 1e-30) && (a < 1e+30) && (R > 1e-30) && (R < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((a > 0.0)) {
      v7 = (R * Math.sin(theta));
      v9 = (R * Math.cos(theta));
      v19 = ((v9 < v7) ? ((v9 * v9) - ((R - a) * (R + a))) : ((a - v7) * (a + v7)));
      v21 = Math.sqrt((((v19 > 0.0) || (v19 !== v19)) ? v19 : 0.0));
      v22 = (((a < v7) || (a !== a)) ? a : v7);
      v30 = Math.asinh((v22 / ((a < v7) ? Math.sqrt(((R - v22) * (v22 + R))) : v9)));
      v35 = Math.tanh(v30);
      if ((v30 < 1.0)) {
        v41 = (v30 * v30);
        v76 = ((v35 * (v35 * v35)) * (((((((((((1.0716932453474512e-06 * v41) + 0.00019982814521087247) * v41) + 0.007076196047699156) * v41) + 0.08608622548411103) * v41) + 0.3073858328214721) * v41) + 0.3333333333333333) / ((((((((((2.565078604208634e-08 * v41) + 2.0203143566039827e-05) * v41) + 0.001617010334189783) * v41) + 0.03639274880225476) * v41) + 0.32215749846441627) * v41) + 1.0)));
      } else {
        v76 = (v30 - v35);
      }
      v84 = (1.0 - ((2.0 * theta) / 3.141592653589793));
      v86 = Math.asinh((v21 / v7));
      v90 = (0.0 - Math.expm1(((-2.0) * v86)));
      v93 = ((v90 > 0.0) ? v90 : Infinity);
      v104 = (v7 * v7);
      v109 = (v7 * v7);
      v113 = (v109 / (v9 + R));
      v121 = (v109 * R);
      v122 = (v9 * v9);
      v131 = [];
      for ([node, weight] of RULE_0_of_sphere_tipped_cone((v86 / v84))) {
        v94 = (node * v86);
        v103 = (v21 * ((Math.exp((-v94)) * (0.0 - Math.expm1(((-2.0) * (v86 - v94))))) / v93));
        v107 = Math.sqrt((v104 + (v103 * v103)));
        v130 = ((((Math.log1p((((v109 / (v103 + v107)) + v113) / (v103 + v9))) + ((v7 * Math.atan2(v103, v7)) / v9)) + (v121 / ((v107 * v122) + ((R * v103) * v9)))) * v103) * v107);
        v131.push((weight * v130));
      }
      v131 = (math.fsum(v131) * v86);
      return (((E_star * (((v22 * v22) * v30) + ((R * R) * v76))) + ((2.0 * E_star) * v131)) / (3.141592653589793 * (a * a)));
    }
    return 0.0;
  }
  return _mean_pressure_of_sphere_tipped_cone(a, R, theta, E_star);
};

const mean_pressure = (a, R, theta, E_star) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure(a, R, theta, E_star) : NaN);
};

const _depth_at = (a, root, R, theta) => {
  let angle, b, beyond, logarithm, root_Rb, tip;
  b = (R * Math.sin(theta));
  root_Rb = (R * Math.cos(theta));
  angle = Math.atan2(root, b);
  logarithm = Math.log1p((((Math.pow(b, 2) / (root + a)) + (Math.pow(b, 2) / (root_Rb + R))) / (root + root_Rb)));
  beyond = (a * (logarithm + ((b * angle) / root_Rb)));
  angle = (Math.log1p(((2 * a) / (R - a))) / 2);
  tip = (a * angle);
  return math.where((a < b), tip, beyond);
};

const _depth_of_sphere_tipped_cone = (a, R, theta) => {
  return _depth_at(a, sine_root(a, R, theta), R, theta);
};

const energy_integral = math.in_groups((depth, a, d, length) => {
  let fallen, integrand, stop;
  stop = Math.asinh((a / length));
  fallen = falling(stop);
  integrand = (v) => {
    let short, t;
    t = (a * fallen(v));
    short = (d - depth(t));
    return ((short * short) * Math.sqrt(((length * length) + (t * t))));
  };
  return [integrand, stop, 1.0, true, 0.0];
});

const energy_integral_beyond = math.in_groups((depth, a, d, b) => {
  let fallen, integrand, reach, stop;
  reach = difference_root(a, b);
  stop = Math.asinh((reach / b));
  fallen = falling(stop);
  integrand = (v) => {
    let root, short;
    root = (reach * fallen(v));
    short = (d - depth(Math.sqrt(((b * b) + (root * root))), root));
    return ((short * short) * root);
  };
  return [integrand, stop, 1.0, (a > b), 0.0];
});

const _energy_of_sphere_tipped_cone = (a, R, theta, E_star) => {
  let b, beyond, inner, sunk, tip;
  b = (R * Math.sin(theta));
  sunk = _depth_of_sphere_tipped_cone(a, R, theta);
  inner = math.minimum(a, b);
  tip = energy_integral(_depth_of_sphere_tipped_cone, [R, theta], inner, sunk, R, { width: (1.0 - ((2.0 * theta) / Math.PI)) });
  beyond = energy_integral_beyond(_depth_at, [R, theta], a, sunk, b, { width: (1.0 - ((2.0 * theta) / Math.PI)) });
  return (E_star * (tip + beyond));
};

const _energy = (a, R, theta, E_star) => {
  let node, v10, v102, v103, v107, v109, v112, v114, v116, v125, v126, v129, v14, v149, v15, v151, v152, v153, v17, v20, v23, v27, v42, v43, v48, v5, v50, v54, v57, v58, v67, v68, v7, v75, v77, v8, v9, v95, v96, v98, weight;
  if (((a > 1e-30) && (a < 1e+30) && (R > 1e-30) && (R < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v5 = (R * Math.sin(theta));
    v7 = (R * Math.cos(theta));
    v8 = (v7 < v5);
    v9 = (v7 * v7);
    v10 = (R - a);
    v14 = (a - v5);
    v15 = (a + v5);
    v23 = (v5 * v5);
    v27 = (v23 / (v7 + R));
    if ((a < v5)) {
      v42 = (a * (Math.log1p(((2.0 * a) / v10)) / 2.0));
    } else {
      v17 = (v8 ? (v9 - (v10 * (R + a))) : (v14 * v15));
      v20 = Math.sqrt((((v17 > 0.0) || (v17 !== v17)) ? v17 : 0.0));
      v42 = (a * (Math.log1p((((v23 / (v20 + a)) + v27) / (v20 + v7))) + ((v5 * Math.atan2(v20, v5)) / v7)));
    }
    v43 = (((a < v5) || (a !== a)) ? a : v5);
    v48 = (1.0 - ((2.0 * theta) / 3.141592653589793));
    v50 = Math.asinh((v43 / R));
    v54 = (0.0 - Math.expm1(((-2.0) * v50)));
    v57 = ((v54 > 0.0) ? v54 : Infinity);
    v98 = (R * R);
    v103 = [];
    for ([node, weight] of RULE_0_of_sphere_tipped_cone((v50 / v48))) {
      v58 = (node * v50);
      v67 = (v43 * ((Math.exp((-v58)) * (0.0 - Math.expm1(((-2.0) * (v50 - v58))))) / v57));
      v68 = (R - v67);
      if ((v67 < v5)) {
        v95 = (v67 * (Math.log1p(((2.0 * v67) / v68)) / 2.0));
      } else {
        v75 = (v8 ? (v9 - (v68 * (R + v67))) : ((v67 - v5) * (v67 + v5)));
        v77 = Math.sqrt((((v75 > 0.0) || (v75 !== v75)) ? v75 : 0.0));
        v95 = (v67 * (Math.log1p((((v23 / (v77 + v67)) + v27) / (v77 + v7))) + ((v5 * Math.atan2(v77, v5)) / v7)));
      }
      v96 = (v42 - v95);
      v102 = ((v96 * v96) * Math.sqrt((v98 + (v67 * v67))));
      v103.push((weight * v102));
    }
    v103 = (math.fsum(v103) * v50);
    if ((a > v5)) {
      v107 = Math.sqrt(((((v14 > 0.0) || (v14 !== v14)) ? v14 : 0.0) * v15));
      v109 = Math.asinh((v107 / v5));
      v112 = (0.0 - Math.expm1(((-2.0) * v109)));
      v114 = ((v112 > 0.0) ? v112 : Infinity);
      v126 = (v5 * v5);
      v152 = [];
      for ([node, weight] of RULE_0_of_sphere_tipped_cone((v109 / v48))) {
        v116 = (node * v109);
        v125 = (v107 * ((Math.exp((-v116)) * (0.0 - Math.expm1(((-2.0) * (v109 - v116))))) / v114));
        v129 = Math.sqrt((v126 + (v125 * v125)));
        v149 = (v42 - ((v129 < v5) ? (v129 * (Math.log1p(((2.0 * v129) / (R - v129))) / 2.0)) : (v129 * (Math.log1p((((v23 / (v125 + v129)) + v27) / (v125 + v7))) + ((v5 * Math.atan2(v125, v5)) / v7)))));
        v151 = ((v149 * v149) * v125);
        v152.push((weight * v151));
      }
      v152 = (math.fsum(v152) * v109);
      v153 = v152;
    } else {
      v153 = 0.0;
    }
    return (E_star * (v103 + v153));
  }
  return _energy_of_sphere_tipped_cone(a, R, theta, E_star);
};

const energy = (a, R, theta, E_star) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _energy(a, R, theta, E_star) : NaN);
};

const _slope = (t, root, R) => {
  let angle;
  angle = Math.asinh((t / root));
  return (angle + ((R * t) / Math.pow(root, 2)));
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

const load_within_integral_beyond = math.in_groups((slope, r, a, b) => {
  let fallen, integrand, outside, reach, stop, turned, whole, within;
  r = math.where((r === b), math.nextafter(b, Infinity), r);
  within = (r < b);
  [outside, reach, whole] = [math.where(within, 0.0, 1.0), difference_root(a, b), difference_root(a, r)];
  stop = Math.asinh((math.where(within, reach, whole) / Math.sqrt((Math.abs((r - b)) * (r + b)))));
  [fallen, turned] = [falling(stop, outside), falling(stop, (1.0 - outside))];
  integrand = (v) => {
    let root, t, u;
    [root, u] = [(reach * fallen(v)), (whole * turned(v))];
    t = Math.sqrt(((b * b) + (root * root)));
    return ((slope(t, root) * (root / t)) * (u / (t + u)));
  };
  return [integrand, stop, (r * r), (a > math.maximum(r, b)), 0.0];
});

const _load_within_of_sphere_tipped_cone = (r, a, R, theta, E_star) => {
  let b, beyond, inner, tip;
  b = (R * Math.sin(theta));
  inner = math.minimum(a, b);
  tip = load_within_integral_tanh(_slope, [R], math.minimum(r, inner), inner, R);
  beyond = load_within_integral_beyond(_slope_beyond_of_sphere_tipped_cone, [R, theta], r, a, b, { width: (1.0 - ((2.0 * theta) / Math.PI)) });
  return (_force_of_sphere_tipped_cone(math.minimum(r, a), R, theta, E_star) + ((2 * E_star) * (tip + beyond)));
};

const _load_within = (r, a, R, theta, E_star) => {
  let node, v100, v108, v109, v110, v112, v114, v116, v118, v119, v121, v123, v127, v129, v132, v137, v14, v142, v143, v146, v148, v15, v150, v154, v16, v162, v163, v174, v175, v177, v178, v188, v190, v191, v199, v203, v208, v21, v243, v247, v249, v252, v254, v255, v26, v264, v267, v28, v285, v286, v33, v36, v37, v38, v42, v51, v52, v54, v56, v57, v6, v60, v7, v75, v78, v79, v8, v81, v85, v88, v89, v9, v90, v91, v95, v96, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R > 1e-30) && (R < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v6 = (R * Math.sin(theta));
    v7 = (((a < v6) || (a !== a)) ? a : v6);
    v8 = (((r < v7) || (r !== r)) ? r : v7);
    v38 = (v8 > 0.0);
    if ((v38 && (v7 < R))) {
      v9 = (R - v8);
      v14 = Math.sqrt(((((v9 > 0.0) || (v9 !== v9)) ? v9 : 0.0) * (R + v8)));
      v15 = (v8 / R);
      v16 = (v7 - v8);
      v21 = (R - v7);
      v26 = (Math.sqrt(((((v16 > 0.0) || (v16 !== v16)) ? v16 : 0.0) * (v7 + v8))) / Math.sqrt(((((v21 > 0.0) || (v21 !== v21)) ? v21 : 0.0) * (R + v7))));
      v28 = Math.asinh((v26 / v15));
      v33 = (0.0 - Math.expm1(((-2.0) * v28)));
      v36 = ((v33 > 0.0) ? v33 : Infinity);
      v37 = (v8 * v8);
      v75 = (v15 * v15);
      v79 = [];
      for ([node, weight] of RULE_0_of_sphere_tipped_cone((v28 / 1.0))) {
        v42 = (node * v28);
        v51 = (v26 * ((Math.exp((-v42)) * (0.0 - Math.expm1(((-2.0) * (v28 - v42))))) / v36));
        v52 = (v51 * v51);
        v54 = Math.sqrt((1.0 + v52));
        v56 = (v14 * (v51 / v54));
        v57 = (v14 / v54);
        v60 = Math.sqrt((v37 + (v56 * v56)));
        v78 = ((((Math.asinh((v60 / v57)) + ((R * v60) / (v57 * v57))) * (v56 / (v60 + v56))) * (v57 / ((v54 * v54) * v60))) * Math.sqrt((v75 + v52)));
        v79.push((weight * v78));
      }
      v79 = (math.fsum(v79) * v28);
      v81 = (v37 * v79);
    } else {
      v81 = (v38 ? Infinity : 0.0);
    }
    v85 = (1.0 - ((2.0 * theta) / 3.141592653589793));
    v88 = ((r === v6) ? math.nextafter(v6, Infinity) : r);
    v143 = (v6 * v6);
    v148 = (R * Math.cos(theta));
    v150 = (v6 * v6);
    v154 = (v150 / (v148 + R));
    v162 = (v150 * R);
    v163 = (v148 * v148);
    if ((a > (((v88 > v6) || (v88 !== v88)) ? v88 : v6))) {
      v89 = (v88 < v6);
      v90 = (v89 ? 0.0 : 1.0);
      v91 = (a - v6);
      v95 = Math.sqrt(((((v91 > 0.0) || (v91 !== v91)) ? v91 : 0.0) * (a + v6)));
      v96 = (a - v88);
      v100 = Math.sqrt(((((v96 > 0.0) || (v96 !== v96)) ? v96 : 0.0) * (a + v88)));
      v108 = Math.asinh(((v89 ? v95 : v100) / Math.sqrt((Math.abs((v88 - v6)) * (v88 + v6)))));
      v109 = (2.0 * v90);
      v110 = (1.0 - v109);
      v112 = Math.expm1(((-2.0) * v108));
      v114 = (v109 - (v110 * v112));
      v116 = ((v114 > 0.0) ? v114 : Infinity);
      v118 = (2.0 * (1.0 - v90));
      v119 = (1.0 - v118);
      v121 = (v118 - (v119 * v112));
      v123 = ((v121 > 0.0) ? v121 : Infinity);
      v175 = [];
      for ([node, weight] of RULE_0_of_sphere_tipped_cone((v108 / v85))) {
        v127 = (node * v108);
        v129 = Math.exp((-v127));
        v132 = Math.expm1(((-2.0) * (v108 - v127)));
        v137 = (v95 * ((v129 * (v109 - (v110 * v132))) / v116));
        v142 = (v100 * ((v129 * (v118 - (v119 * v132))) / v123));
        v146 = Math.sqrt((v143 + (v137 * v137)));
        v174 = ((((Math.log1p((((v150 / (v137 + v146)) + v154) / (v137 + v148))) + ((v6 * Math.atan2(v137, v6)) / v148)) + (v162 / ((v146 * v163) + ((R * v137) * v148)))) * (v137 / v146)) * (v142 / (v146 + v142)));
        v175.push((weight * v174));
      }
      v175 = (math.fsum(v175) * v108);
      v177 = ((v88 * v88) * v175);
    } else {
      v177 = 0.0;
    }
    v178 = (((r < a) || (r !== r)) ? r : a);
    v188 = ((v148 < v6) ? ((v148 * v148) - ((R - v178) * (R + v178))) : ((v178 - v6) * (v178 + v6)));
    v190 = Math.sqrt((((v188 > 0.0) || (v188 !== v188)) ? v188 : 0.0));
    v191 = (((v178 < v6) || (v178 !== v178)) ? v178 : v6);
    v199 = Math.asinh((v191 / ((v178 < v6) ? Math.sqrt(((R - v191) * (v191 + R))) : v148)));
    v203 = Math.tanh(v199);
    if ((v199 < 1.0)) {
      v208 = (v199 * v199);
      v243 = ((v203 * (v203 * v203)) * (((((((((((1.0716932453474512e-06 * v208) + 0.00019982814521087247) * v208) + 0.007076196047699156) * v208) + 0.08608622548411103) * v208) + 0.3073858328214721) * v208) + 0.3333333333333333) / ((((((((((2.565078604208634e-08 * v208) + 2.0203143566039827e-05) * v208) + 0.001617010334189783) * v208) + 0.03639274880225476) * v208) + 0.32215749846441627) * v208) + 1.0)));
    } else {
      v243 = (v199 - v203);
    }
    v247 = (2.0 * E_star);
    v249 = Math.asinh((v190 / v6));
    v252 = (0.0 - Math.expm1(((-2.0) * v249)));
    v254 = ((v252 > 0.0) ? v252 : Infinity);
    v286 = [];
    for ([node, weight] of RULE_0_of_sphere_tipped_cone((v249 / v85))) {
      v255 = (node * v249);
      v264 = (v190 * ((Math.exp((-v255)) * (0.0 - Math.expm1(((-2.0) * (v249 - v255))))) / v254));
      v267 = Math.sqrt((v143 + (v264 * v264)));
      v285 = ((((Math.log1p((((v150 / (v264 + v267)) + v154) / (v264 + v148))) + ((v6 * Math.atan2(v264, v6)) / v148)) + (v162 / ((v267 * v163) + ((R * v264) * v148)))) * v264) * v267);
      v286.push((weight * v285));
    }
    v286 = (math.fsum(v286) * v249);
    return (((E_star * (((v191 * v191) * v199) + ((R * R) * v243))) + (v247 * v286)) + (v247 * (v81 + v177)));
  }
  return _load_within_of_sphere_tipped_cone(r, a, R, theta, E_star);
};

const load_within = (r, a, R, theta, E_star) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _load_within(r, a, R, theta, E_star) : 0.0) : NaN);
};

const _slope_at = (a, root, R, theta) => {
  let v19, v21, v5, v9;
  v5 = (R * Math.sin(theta));
  if ((a < v5)) {
    v9 = math.sqrt(((R - a) * (R + a)));
    return (Math.asinh((a / v9)) + ((R * a) / (v9 * v9)));
  }
  v19 = (R * Math.cos(theta));
  v21 = (v5 * v5);
  return ((math.log1p((((v21 / (root + a)) + (v21 / (v19 + R))) / (root + v19))) + ((v5 * Math.atan2(root, v5)) / v19)) + ((v21 * R) / ((a * (v19 * v19)) + ((R * root) * v19))));
};

const _depth_at_of_sphere_tipped_cone = (a, root, R, theta) => {
  let v10, v5, v7;
  v5 = (R * Math.sin(theta));
  if ((a < v5)) {
    return (a * (math.log1p(((2.0 * a) / (R - a))) / 2.0));
  }
  v7 = (R * Math.cos(theta));
  v10 = (v5 * v5);
  return (a * (math.log1p((((v10 / (root + a)) + (v10 / (v7 + R))) / (root + v7))) + ((v5 * Math.atan2(root, v5)) / v7)));
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

const ROUNDING_of_across = 1.1102230246251565e-16;

const _tip = (b, end) => {
  let reach;
  if ((end == null)) {
    return [((t) => t), math.ones_like, b];
  }
  reach = Math.atanh(math.minimum((b / end), (1.0 - ROUNDING_of_across)));
  return [((t) => (end * Math.tanh(t))), ((t) => (t / (Math.sinh(t) * Math.cosh(t)))), reach];
};

const inverse_across = (curve, value, b, tip, end = null, powers = null) => {
  let above, base, both, last, least, like, most, radius_at, rate, reach, share, start, t, wanted;
  base = curve(b, math.zeros_like(b))[0];
  above = (value > base);
  if (Boolean(above)) {
    return _beyond(curve, value, base, b, tip, powers);
  }
  [radius_at, share, reach] = _tip(b, end);
  both = (t) => {
    let inner, more, rate, slope, y;
    inner = math.minimum(t, reach);
    [y, rate] = curve((above ? (b * Math.sqrt((1.0 + (t * t)))) : radius_at(inner)), (above ? (b * t) : 0.0));
    [more, slope] = _excess(t, y, rate, base, (powers ? powers[0] : 2.0));
    return [(above ? more : y), (above ? slope : ((rate / y) * share(inner)))];
  };
  [last, rate] = curve(radius_at(reach), math.zeros_like(b));
  wanted = (above ? (value - base) : math.minimum(value, last));
  like = ((above ? last : wanted) / last);
  start = (reach * ((end == null) ? Math.pow(like, (1.0 / tip)) : joining(like, ((rate / last) * share(reach)), tip, 1.0)));
  if (Boolean(above)) {
    start = (above ? _start(curve, (above ? wanted : base), base, b, tip, powers) : start);
  }
  [least, most] = ((end == null) ? [tip, Infinity] : [1.0, tip]);
  t = inverse(both, wanted, start, [(above ? 1.0 : least), (above ? Infinity : most)], (above ? Infinity : reach), ((t) => (above ? 1.0 : share(math.minimum(t, reach)))), true, ((above ? NOISE : ROUNDING_of_across) * value));
  return (above ? (b * Math.sqrt((1.0 + (t * t)))) : math.minimum(b, radius_at(math.minimum(t, reach))));
};

const _radius_from_depth = (d, R, theta) => {
  let b, curve;
  b = (R * Math.sin(theta));
  curve = (a, root) => {
    let rate;
    rate = (a * _slope_at(a, root, R, theta));
    return [_depth_at_of_sphere_tipped_cone(a, root, R, theta), rate];
  };
  return inverse_across(curve, d, b, 2.0, R, [2.0, 1.0]);
};

const radius_from_depth = (d, R, theta) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth(d, R, theta) : NaN);
};

const _force_at_of_sphere_tipped_cone = (a, reach, R, theta, E_star) => {
  let node, v101, v109, v110, v118, v119, v14, v17, v22, v28, v6, v63, v7, v71, v73, v78, v81, v82, v91, v92, v95, v97, weight;
  v6 = (R * Math.sin(theta));
  v7 = (((a < v6) || (a !== a)) ? a : v6);
  v14 = (R * Math.cos(theta));
  v17 = Math.asinh((v7 / ((a < v6) ? math.sqrt(((R - v7) * (v7 + R))) : v14)));
  v22 = Math.tanh(v17);
  if ((v17 < 1.0)) {
    v28 = (v17 * v17);
    v63 = ((v22 * (v22 * v22)) * (((((((((((1.0716932453474512e-06 * v28) + 0.00019982814521087247) * v28) + 0.007076196047699156) * v28) + 0.08608622548411103) * v28) + 0.3073858328214721) * v28) + 0.3333333333333333) / ((((((((((2.565078604208634e-08 * v28) + 2.0203143566039827e-05) * v28) + 0.001617010334189783) * v28) + 0.03639274880225476) * v28) + 0.32215749846441627) * v28) + 1.0)));
  } else {
    v63 = (v17 - v22);
  }
  v71 = (1.0 - ((2.0 * theta) / 3.141592653589793));
  v73 = Math.asinh((reach / v6));
  v78 = (0.0 - Math.expm1(((-2.0) * v73)));
  v81 = ((v78 > 0.0) ? v78 : Infinity);
  v92 = (v6 * v6);
  v97 = (v6 * v6);
  v101 = (v97 / (v14 + R));
  v109 = (v97 * R);
  v110 = (v14 * v14);
  v119 = [];
  for ([node, weight] of RULE_0((v73 / v71))) {
    v82 = (node * v73);
    v91 = (reach * ((Math.exp((-v82)) * (0.0 - Math.expm1(((-2.0) * (v73 - v82))))) / v81));
    v95 = math.sqrt((v92 + (v91 * v91)));
    v118 = ((((math.log1p((((v97 / (v91 + v95)) + v101) / (v91 + v14))) + ((v6 * Math.atan2(v91, v6)) / v14)) + (v109 / ((v95 * v110) + ((R * v91) * v14)))) * v91) * v95);
    v119.push((weight * v118));
  }
  v119 = (math.fsum(v119) * v73);
  return ((E_star * (((v7 * v7) * v17) + ((R * R) * v63))) + ((2.0 * E_star) * v119));
};

const _radius_from_force = (F, R, theta, E_star) => {
  let b, curve;
  b = (R * Math.sin(theta));
  curve = (a, root) => {
    let rate;
    rate = (((2 * E_star) * Math.pow(a, 2)) * _slope_at(a, root, R, theta));
    return [_force_at_of_sphere_tipped_cone(a, root, R, theta, E_star), rate];
  };
  return inverse_across(curve, F, b, 3.0, R, [2.0, 2.0]);
};

const radius_from_force = (F, R, theta, E_star) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _radius_from_force(F, R, theta, E_star) : NaN);
};

const _force_from_depth = (d, R, theta, E_star) => {
  let a, change;
  a = _radius_from_depth(d, R, theta);
  change = (((a > 0.0) & (a < Infinity)) ? (((2 * E_star) * a) * (d - _depth(a, R, theta))) : 0.0);
  return (_force(a, R, theta, E_star) + change);
};

const force_from_depth = (d, R, theta, E_star) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth(d, R, theta, E_star) : NaN);
};

const _depth_from_force = (F, R, theta, E_star) => {
  let a, change;
  a = _radius_from_force(F, R, theta, E_star);
  change = (((a > 0.0) & (a < Infinity)) ? ((F - _force(a, R, theta, E_star)) / ((2 * E_star) * a)) : 0.0);
  return (_depth(a, R, theta) + change);
};

const depth_from_force = (F, R, theta, E_star) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force(F, R, theta, E_star) : NaN);
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

const _depth_2 = (a, R, theta, E_star, dgamma) => {
  let v11, v18, v21, v24, v43, v6, v8;
  v6 = (R * Math.sin(theta));
  v11 = (R - a);
  if ((a < v6)) {
    v43 = (a * (math.log1p(((2.0 * a) / v11)) / 2.0));
  } else {
    v8 = (R * Math.cos(theta));
    v18 = ((v8 < v6) ? ((v8 * v8) - (v11 * (R + a))) : ((a - v6) * (a + v6)));
    v21 = math.sqrt((((v18 > 0.0) || (v18 !== v18)) ? v18 : 0.0));
    v24 = (v6 * v6);
    v43 = (a * (math.log1p((((v24 / (v21 + a)) + (v24 / (v8 + R))) / (v21 + v8))) + ((v6 * Math.atan2(v21, v6)) / v8)));
  }
  return (v43 - (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const depth_of_sphere_tipped_cone = (a, R, theta, E_star, dgamma) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_2(a, R, theta, E_star, dgamma) : NaN);
};

const RULE_0_2 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _force_2 = (a, R, theta, E_star, dgamma) => {
  let node, v103, v104, v107, v109, v113, v121, v122, v130, v131, v18, v21, v22, v30, v35, v41, v6, v76, v8, v80, v84, v86, v90, v93, v94, weight;
  v6 = (R * Math.sin(theta));
  v8 = (R * Math.cos(theta));
  v18 = ((v8 < v6) ? ((v8 * v8) - ((R - a) * (R + a))) : ((a - v6) * (a + v6)));
  v21 = math.sqrt((((v18 > 0.0) || (v18 !== v18)) ? v18 : 0.0));
  v22 = (((a < v6) || (a !== a)) ? a : v6);
  v30 = Math.asinh((v22 / ((a < v6) ? math.sqrt(((R - v22) * (v22 + R))) : v8)));
  v35 = Math.tanh(v30);
  if ((v30 < 1.0)) {
    v41 = (v30 * v30);
    v76 = ((v35 * (v35 * v35)) * (((((((((((1.0716932453474512e-06 * v41) + 0.00019982814521087247) * v41) + 0.007076196047699156) * v41) + 0.08608622548411103) * v41) + 0.3073858328214721) * v41) + 0.3333333333333333) / ((((((((((2.565078604208634e-08 * v41) + 2.0203143566039827e-05) * v41) + 0.001617010334189783) * v41) + 0.03639274880225476) * v41) + 0.32215749846441627) * v41) + 1.0)));
  } else {
    v76 = (v30 - v35);
  }
  v80 = (2.0 * E_star);
  v84 = (1.0 - ((2.0 * theta) / 3.141592653589793));
  v86 = Math.asinh((v21 / v6));
  v90 = (0.0 - Math.expm1(((-2.0) * v86)));
  v93 = ((v90 > 0.0) ? v90 : Infinity);
  v104 = (v6 * v6);
  v109 = (v6 * v6);
  v113 = (v109 / (v8 + R));
  v121 = (v109 * R);
  v122 = (v8 * v8);
  v131 = [];
  for ([node, weight] of RULE_0_2((v86 / v84))) {
    v94 = (node * v86);
    v103 = (v21 * ((Math.exp((-v94)) * (0.0 - Math.expm1(((-2.0) * (v86 - v94))))) / v93));
    v107 = math.sqrt((v104 + (v103 * v103)));
    v130 = ((((math.log1p((((v109 / (v103 + v107)) + v113) / (v103 + v8))) + ((v6 * Math.atan2(v103, v6)) / v8)) + (v121 / ((v107 * v122) + ((R * v103) * v8)))) * v103) * v107);
    v131.push((weight * v130));
  }
  v131 = (math.fsum(v131) * v86);
  return (((E_star * (((v22 * v22) * v30) + ((R * R) * v76))) + (v80 * v131)) - ((v80 * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star)))));
};

const force_of_sphere_tipped_cone = (a, R, theta, E_star, dgamma) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_2(a, R, theta, E_star, dgamma) : NaN);
};

const RULE_0_3 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _pressure_4 = (r, a, R, theta, E_star) => {
  let b, growth, inner, root, root_Rr, root_ar, tip, within;
  b = (R * Math.sin(theta));
  inner = math.minimum(a, b);
  root_Rr = Math.sqrt(((R - r) * (r + R)));
  root = math.where((a < b), Math.sqrt(((R - inner) * (inner + R))), (R * Math.cos(theta)));
  root_ar = Math.sqrt(((inner - r) * (inner + r)));
  within = ((E_star / Math.PI) * (((R * Math.asinh((root_ar / root))) / root_Rr) + arc_strips(r, inner, R)));
  tip = math.where((r < inner), within, 0.0);
  growth = pressure_integral_beyond(_slope_beyond_of_sphere_tipped_cone, [R, theta], r, a, b, { width: (1.0 - ((2.0 * theta) / Math.PI)) });
  return math.where((r < a), (tip + ((E_star / Math.PI) * growth)), 0.0);
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

const _pressure_3 = (r, a, R, theta, E_star, dgamma) => {
  return (_pressure_4(r, a, R, theta, E_star) - tension(r, a, E_star, dgamma));
};

const _pressure_2 = (r, a, R, theta, E_star, dgamma) => {
  let node, v102, v107, v108, v112, v117, v122, v127, v132, v151, v154, v158, v159, v161, v165, v166, v171, v178, v179, v180, v185, v187, v19, v190, v200, v201, v204, v206, v21, v210, v218, v219, v22, v227, v228, v229, v233, v239, v242, v249, v251, v26, v34, v39, v40, v41, v44, v45, v46, v52, v57, v62, v67, v7, v72, v77, v8, v82, v87, v9, v92, v97, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R > 1e-30) && (R < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v7 = (R * Math.sin(theta));
    v8 = (((a < v7) || (a !== a)) ? a : v7);
    v9 = (R - r);
    v21 = (v8 - r);
    v22 = (v8 + r);
    v34 = Math.sqrt(((((v21 > 0.0) || (v21 !== v21)) ? v21 : 0.0) * v22));
    v39 = (R + Math.sqrt(((((v9 > 0.0) || (v9 !== v9)) ? v9 : 0.0) * (R + r))));
    v40 = (v8 + v34);
    v41 = (v40 / v39);
    if ((r < a)) {
      v19 = (R * Math.cos(theta));
      v26 = (E_star / 3.141592653589793);
      if ((r < v8)) {
        v44 = ((r * (r / v40)) / v39);
        v45 = (v41 * v41);
        v46 = (v44 * v44);
        v52 = ((0.13579013365982337 * v45) + (-0.4846453962188766));
        v57 = ((v52 * v45) + 0.8293825948837366);
        v62 = ((v57 * v45) + (-0.8745573865774817));
        v67 = ((v62 * v45) + 0.6371928816963097);
        v72 = ((v67 * v45) + (-0.3332798652335896));
        v77 = ((v72 * v45) + 0.13289328569967984);
        v82 = ((v77 * v45) + (-0.03710676078458442));
        v87 = ((v82 * v45) + 0.011089560042611895);
        v92 = ((v87 * v45) + 0.0012521687336059639);
        v97 = ((v92 * v45) + 0.0036572276005780893);
        v102 = ((v97 * v45) + 0.004425450516633092);
        v107 = ((v102 * v45) + 0.005918487051520244);
        v108 = (((((((((((((((((((((((((0.0 * v46) + 0.13579013365982337) * v46) + v52) * v46) + v57) * v46) + v62) * v46) + v67) * v46) + v72) * v46) + v77) * v46) + v82) * v46) + v87) * v46) + v92) * v46) + v97) * v46) + v102) * v46);
        v112 = ((v107 * v45) + 0.008264397984935742);
        v117 = ((v112 * v45) + 0.012345681107818056);
        v122 = ((v117 * v45) + 0.020408163224119494);
        v127 = ((v122 * v45) + 0.04000000000042643);
        v132 = ((v127 * v45) + 0.11111111111110937);
        v151 = (v26 * (((R * Math.asinh((Math.sqrt((v21 * v22)) / ((a < v7) ? Math.sqrt(((R - v8) * (v8 + R))) : v19)))) / Math.sqrt((v9 * (r + R)))) + (((2.0 * v34) / v39) * (((v132 * v45) + 1.0) + ((v44 * (v44 + v41)) * (((((((((((v108 + v107) * v46) + v112) * v46) + v117) * v46) + v122) * v46) + v127) * v46) + v132))))));
      } else {
        v151 = 0.0;
      }
      v158 = ((r === v7) ? math.nextafter(v7, Infinity) : r);
      if ((a > (((v158 > v7) || (v158 !== v158)) ? v158 : v7))) {
        v154 = (1.0 - ((2.0 * theta) / 3.141592653589793));
        v159 = (v158 < v7);
        v161 = (a - v7);
        v165 = Math.sqrt(((((v161 > 0.0) || (v161 !== v161)) ? v161 : 0.0) * (a + v7)));
        if (v159) {
          v171 = v165;
        } else {
          v166 = (a - v158);
          v171 = Math.sqrt(((((v166 > 0.0) || (v166 !== v166)) ? v166 : 0.0) * (a + v158)));
        }
        v178 = Math.asinh((v171 / Math.sqrt((Math.abs((v158 - v7)) * (v158 + v7)))));
        v179 = (2.0 * (v159 ? 0.0 : 1.0));
        v180 = (1.0 - v179);
        v185 = (v179 - (v180 * Math.expm1(((-2.0) * v178))));
        v187 = ((v185 > 0.0) ? v185 : Infinity);
        v201 = (v7 * v7);
        v206 = (v7 * v7);
        v210 = (v206 / (v19 + R));
        v218 = (v206 * R);
        v219 = (v19 * v19);
        v228 = [];
        for ([node, weight] of RULE_0_3((v178 / v154))) {
          v190 = (node * v178);
          v200 = (v165 * ((Math.exp((-v190)) * (v179 - (v180 * Math.expm1(((-2.0) * (v178 - v190)))))) / v187));
          v204 = Math.sqrt((v201 + (v200 * v200)));
          v227 = ((((Math.log1p((((v206 / (v200 + v204)) + v210) / (v200 + v19))) + ((v7 * Math.atan2(v200, v7)) / v19)) + (v218 / ((v204 * v219) + ((R * v200) * v19)))) * v200) / v204);
          v228.push((weight * v227));
        }
        v228 = (math.fsum(v228) * v178);
        v229 = v228;
      } else {
        v229 = 0.0;
      }
      v233 = (v151 + (v26 * v229));
    } else {
      v233 = 0.0;
    }
    if ((r <= a)) {
      v239 = (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star)));
      if ((v239 > 0.0)) {
        v242 = (a - r);
        v249 = ((E_star * v239) / (3.141592653589793 * Math.sqrt(((((v242 > 0.0) || (v242 !== v242)) ? v242 : 0.0) * (a + r)))));
      } else {
        v249 = 0.0;
      }
      v251 = v249;
    } else {
      v251 = 0.0;
    }
    if ((v41 > 0.7)) {
      return _pressure_3(r, a, R, theta, E_star, dgamma);
    }
    return (v233 - v251);
  }
  return _pressure_3(r, a, R, theta, E_star, dgamma);
};

const pressure_of_sphere_tipped_cone = (r, a, R, theta, E_star, dgamma) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_2(r, a, R, theta, E_star, dgamma) : 0.0) : NaN);
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

const displacement_integral_beyond = math.in_groups((slope, r, a, b) => {
  let end, fallen, integrand, ratio, reach, stop;
  [reach, ratio] = [difference_root(r, b), (b / r)];
  end = (difference_root(a, b) / difference_root(r, a));
  stop = Math.asinh((end / ratio));
  fallen = falling_of_rules(stop);
  integrand = (v) => {
    let root, secant, t, tangent, weight;
    tangent = (end * fallen(v));
    secant = Math.sqrt((1.0 + (tangent * tangent)));
    root = ((reach * tangent) / secant);
    t = Math.sqrt(((b * b) + (root * root)));
    weight = (Math.sqrt(((ratio * ratio) + (tangent * tangent))) / ((secant * secant) * secant));
    return ((((slope(t, root) * root) / t) * Math.atan2(t, (reach / secant))) * weight);
  };
  return [integrand, stop, reach, (a > b), 0.0];
});

const _profile = (r, R, theta) => {
  let b, root_Rb, root_Rr;
  b = (R * Math.sin(theta));
  root_Rr = Math.sqrt(((R - r) * (r + R)));
  root_Rb = (R * Math.cos(theta));
  return math.where((r < b), (Math.pow(r, 2) / (root_Rr + R)), (b * (((r - b) / root_Rb) + (b / (root_Rb + R)))));
};

const _displacement_3 = (r, a, R, theta) => {
  let b, beyond, inner, inside, outside, tip;
  b = (R * Math.sin(theta));
  inner = math.minimum(a, b);
  tip = displacement_integral_tanh(_slope, [R], r, inner, R);
  beyond = displacement_integral_beyond(_slope_beyond_of_sphere_tipped_cone, [R, theta], r, a, b, { width: (1.0 - ((2.0 * theta) / Math.PI)) });
  outside = ((2 / Math.PI) * (tip + beyond));
  inside = (_depth_of_sphere_tipped_cone(a, R, theta) - _profile(r, R, theta));
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

const _displacement_2 = (r, a, R, theta, E_star, dgamma) => {
  return (_displacement_3(r, a, R, theta) - lift(r, a, E_star, dgamma));
};

const _displacement_of_sphere_tipped_cone = (r, a, R, theta, E_star, dgamma) => {
  let node, v10, v100, v102, v111, v112, v114, v116, v117, v120, v121, v128, v130, v133, v134, v142, v143, v155, v156, v158, v16, v164, v169, v17, v171, v189, v202, v203, v22, v25, v27, v36, v39, v41, v42, v43, v45, v47, v49, v50, v53, v57, v58, v60, v7, v70, v71, v72, v76, v77, v8, v81, v82, v83, v85, v88, v9, v92, v93, v95, v98, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R > 1e-30) && (R < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v7 = (R * Math.sin(theta));
    v45 = (r + R);
    v53 = (R - r);
    v77 = (r - v7);
    v83 = (a - v7);
    v85 = (a + v7);
    v88 = (r - a);
    v92 = Math.sqrt(((((v88 > 0.0) || (v88 !== v88)) ? v88 : 0.0) * (r + a)));
    v128 = (R * Math.cos(theta));
    v130 = (v7 * v7);
    v133 = (v128 + R);
    v134 = (v130 / v133);
    v202 = (r > a);
    if (v202) {
      v8 = (((a < v7) || (a !== a)) ? a : v7);
      v9 = (((r < R) || (r !== r)) ? r : R);
      if ((v8 < v9)) {
        v10 = (v9 - v8);
        v16 = (v8 / Math.sqrt(((((v10 > 0.0) || (v10 !== v10)) ? v10 : 0.0) * (v9 + v8))));
        v17 = Math.asinh(v16);
        v22 = (0.0 - Math.expm1(((-2.0) * v17)));
        v25 = ((v22 > 0.0) ? v22 : Infinity);
        v43 = (r - R);
        v47 = Math.sqrt(((((v43 > 0.0) || (v43 !== v43)) ? v43 : 0.0) * v45));
        v49 = (v47 * v47);
        v57 = Math.sqrt(((((v53 > 0.0) || (v53 !== v53)) ? v53 : 0.0) * (R + r)));
        v58 = (v57 * v57);
        v71 = [];
        for ([node, weight] of RULE_0_3((v17 / 1.0))) {
          v27 = (node * v17);
          v36 = (v16 * ((Math.exp((-v27)) * (0.0 - Math.expm1(((-2.0) * (v17 - v27))))) / v25));
          v39 = Math.sqrt((1.0 + (v36 * v36)));
          v41 = (v9 * (v36 / v39));
          v42 = (v9 / v39);
          v50 = (v42 * v42);
          v60 = Math.sqrt((v58 + v50));
          v70 = (((Math.asinh((v41 / v60)) + ((R * v41) / (v60 * v60))) * Math.atan2(v41, Math.sqrt((v49 + v50)))) * (v42 / v39));
          v71.push((weight * v70));
        }
        v71 = (math.fsum(v71) * v17);
        v72 = v71;
      } else {
        v72 = Infinity;
      }
      if ((a > v7)) {
        v76 = (1.0 - ((2.0 * theta) / 3.141592653589793));
        v81 = Math.sqrt(((((v77 > 0.0) || (v77 !== v77)) ? v77 : 0.0) * (r + v7)));
        v82 = (v7 / r);
        v93 = (Math.sqrt(((((v83 > 0.0) || (v83 !== v83)) ? v83 : 0.0) * v85)) / v92);
        v95 = Math.asinh((v93 / v82));
        v98 = (0.0 - Math.expm1(((-2.0) * v95)));
        v100 = ((v98 > 0.0) ? v98 : Infinity);
        v117 = (v7 * v7);
        v121 = (v82 * v82);
        v142 = (v130 * R);
        v143 = (v128 * v128);
        v156 = [];
        for ([node, weight] of RULE_0_3((v95 / v76))) {
          v102 = (node * v95);
          v111 = (v93 * ((Math.exp((-v102)) * (0.0 - Math.expm1(((-2.0) * (v95 - v102))))) / v100));
          v112 = (v111 * v111);
          v114 = Math.sqrt((1.0 + v112));
          v116 = ((v81 * v111) / v114);
          v120 = Math.sqrt((v117 + (v116 * v116)));
          v155 = ((((((Math.log1p((((v130 / (v116 + v120)) + v134) / (v116 + v128))) + ((v7 * Math.atan2(v116, v7)) / v128)) + (v142 / ((v120 * v143) + ((R * v116) * v128)))) * v116) / v120) * Math.atan2(v120, (v81 / v114))) * (Math.sqrt((v121 + v112)) / ((v114 * v114) * v114)));
          v156.push((weight * v155));
        }
        v156 = (math.fsum(v156) * v95);
        v158 = (v81 * v156);
      } else {
        v158 = 0.0;
      }
      v203 = (0.6366197723675814 * (v72 + v158));
    } else {
      v164 = (R - a);
      if ((a < v7)) {
        v189 = (a * (Math.log1p(((2.0 * a) / v164)) / 2.0));
      } else {
        v169 = ((v128 < v7) ? ((v128 * v128) - (v164 * (R + a))) : (v83 * v85));
        v171 = Math.sqrt((((v169 > 0.0) || (v169 !== v169)) ? v169 : 0.0));
        v189 = (a * (Math.log1p((((v130 / (v171 + a)) + v134) / (v171 + v128))) + ((v7 * Math.atan2(v171, v7)) / v128)));
      }
      v203 = (v189 - ((r < v7) ? ((r * r) / (Math.sqrt((v53 * v45)) + R)) : (v7 * ((v77 / v128) + (v7 / v133)))));
    }
    return (v203 - ((Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))) * (v202 ? (0.6366197723675814 * Math.atan2(a, v92)) : 1.0)));
  }
  return _displacement_2(r, a, R, theta, E_star, dgamma);
};

const displacement_of_sphere_tipped_cone = (r, a, R, theta, E_star, dgamma) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_of_sphere_tipped_cone(r, a, R, theta, E_star, dgamma) : 0.0) : NaN);
};

const RULE_0_4 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

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

const growth_beyond = math.in_groups((slope, order, r, c, a, b, close) => {
  let beyond, gaps, holds, integrand, root, start;
  start = math.maximum(b, c);
  [beyond, root] = [difference_root(start, b), difference_root(start, r)];
  gaps = (_gap(a, start, difference_root(a, b), beyond) + _gap(a, start, difference_root(a, r), root));
  holds = (close & (a > start));
  integrand = (v) => {
    let side, t;
    side = ((beyond * Math.cosh(v)) + (root * Math.sinh(v)));
    t = Math.sqrt(((b * b) + (side * side)));
    return ((slope(t, side) * (side / t)) * Math.pow(t, order));
  };
  return [integrand, (holds ? Math.log1p((gaps / (beyond + root))) : 0.0), 1.0, holds, 0.0];
});

const _tangential_force_of_sphere_tipped_cone = (a, c, R, theta, E_star, mu) => {
  let b, beyond, close, gain, sticking, tip, whole;
  [whole, sticking] = [_force_of_sphere_tipped_cone(a, R, theta, E_star), _force_of_sphere_tipped_cone(c, R, theta, E_star)];
  close = (sticking >= (CLOSE * whole));
  b = (R * Math.sin(theta));
  tip = growth_below(_slope, [R], 2, 0.0, c, math.minimum(a, b), R, close);
  beyond = growth_beyond(_slope_beyond_of_sphere_tipped_cone, [R, theta], 2, 0.0, c, a, b, close, { width: (1.0 - ((2.0 * theta) / Math.PI)) });
  gain = ((2.0 * E_star) * (tip + beyond));
  return (mu * math.where(close, gain, (whole - sticking)));
};

const _tangential_force = (a, c, R, theta, E_star, mu) => {
  let node, v10, v104, v105, v108, v11, v110, v114, v122, v123, v131, v132, v135, v136, v137, v143, v145, v146, v154, v157, v16, v162, v17, v186, v19, v191, v194, v196, v197, v206, v209, v22, v227, v228, v23, v230, v233, v234, v238, v239, v243, v247, v25, v251, v255, v257, v271, v275, v276, v277, v278, v281, v286, v287, v288, v291, v303, v304, v305, v306, v307, v31, v311, v312, v316, v320, v323, v327, v334, v336, v340, v341, v346, v349, v35, v36, v369, v370, v371, v375, v42, v7, v77, v81, v85, v87, v9, v91, v94, v95, weight;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (R > 1e-30) && (R < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v7 = (R * Math.sin(theta));
    v9 = (R * Math.cos(theta));
    v10 = (v9 < v7);
    v11 = (v9 * v9);
    v16 = (a - v7);
    v17 = (a + v7);
    v19 = (v10 ? (v11 - ((R - a) * (R + a))) : (v16 * v17));
    v22 = Math.sqrt((((v19 > 0.0) || (v19 !== v19)) ? v19 : 0.0));
    v23 = (((a < v7) || (a !== a)) ? a : v7);
    v25 = (R - v23);
    v31 = Math.asinh((v23 / ((a < v7) ? Math.sqrt((v25 * (v23 + R))) : v9)));
    v35 = (R * R);
    v36 = Math.tanh(v31);
    if ((v31 < 1.0)) {
      v42 = (v31 * v31);
      v77 = ((v36 * (v36 * v36)) * (((((((((((1.0716932453474512e-06 * v42) + 0.00019982814521087247) * v42) + 0.007076196047699156) * v42) + 0.08608622548411103) * v42) + 0.3073858328214721) * v42) + 0.3333333333333333) / ((((((((((2.565078604208634e-08 * v42) + 2.0203143566039827e-05) * v42) + 0.001617010334189783) * v42) + 0.03639274880225476) * v42) + 0.32215749846441627) * v42) + 1.0)));
    } else {
      v77 = (v31 - v36);
    }
    v81 = (2.0 * E_star);
    v85 = (1.0 - ((2.0 * theta) / 3.141592653589793));
    v87 = Math.asinh((v22 / v7));
    v91 = (0.0 - Math.expm1(((-2.0) * v87)));
    v94 = ((v91 > 0.0) ? v91 : Infinity);
    v105 = (v7 * v7);
    v110 = (v7 * v7);
    v114 = (v110 / (v9 + R));
    v122 = (v110 * R);
    v123 = (v9 * v9);
    v132 = [];
    for ([node, weight] of RULE_0_4((v87 / v85))) {
      v95 = (node * v87);
      v104 = (v22 * ((Math.exp((-v95)) * (0.0 - Math.expm1(((-2.0) * (v87 - v95))))) / v94));
      v108 = Math.sqrt((v105 + (v104 * v104)));
      v131 = ((((Math.log1p((((v110 / (v104 + v108)) + v114) / (v104 + v9))) + ((v7 * Math.atan2(v104, v7)) / v9)) + (v122 / ((v108 * v123) + ((R * v104) * v9)))) * v104) * v108);
      v132.push((weight * v131));
    }
    v132 = (math.fsum(v132) * v87);
    v135 = ((E_star * (((v23 * v23) * v31) + (v35 * v77))) + (v81 * v132));
    v136 = (R - c);
    v137 = (R + c);
    v143 = (v10 ? (v11 - (v136 * v137)) : ((c - v7) * (c + v7)));
    v145 = Math.sqrt((((v143 > 0.0) || (v143 !== v143)) ? v143 : 0.0));
    v146 = (((c < v7) || (c !== c)) ? c : v7);
    v154 = Math.asinh((v146 / ((c < v7) ? Math.sqrt(((R - v146) * (v146 + R))) : v9)));
    v157 = Math.tanh(v154);
    if ((v154 < 1.0)) {
      v162 = (v154 * v154);
      v186 = ((v157 * (v157 * v157)) * (((((((((((1.0716932453474512e-06 * v162) + 0.00019982814521087247) * v162) + 0.007076196047699156) * v162) + 0.08608622548411103) * v162) + 0.3073858328214721) * v162) + 0.3333333333333333) / ((((((((((2.565078604208634e-08 * v162) + 2.0203143566039827e-05) * v162) + 0.001617010334189783) * v162) + 0.03639274880225476) * v162) + 0.32215749846441627) * v162) + 1.0)));
    } else {
      v186 = (v154 - v157);
    }
    v191 = Math.asinh((v145 / v7));
    v194 = (0.0 - Math.expm1(((-2.0) * v191)));
    v196 = ((v194 > 0.0) ? v194 : Infinity);
    v228 = [];
    for ([node, weight] of RULE_0_4((v191 / v85))) {
      v197 = (node * v191);
      v206 = (v145 * ((Math.exp((-v197)) * (0.0 - Math.expm1(((-2.0) * (v191 - v197))))) / v196));
      v209 = Math.sqrt((v105 + (v206 * v206)));
      v227 = ((((Math.log1p((((v110 / (v206 + v209)) + v114) / (v206 + v9))) + ((v7 * Math.atan2(v206, v7)) / v9)) + (v122 / ((v209 * v123) + ((R * v206) * v9)))) * v206) * v209);
      v228.push((weight * v227));
    }
    v228 = (math.fsum(v228) * v191);
    v230 = ((E_star * (((v146 * v146) * v154) + (v35 * v186))) + (v81 * v228));
    v233 = (v230 >= (0.25 * v135));
    if (v233) {
      v257 = (v23 > c);
      v271 = (v233 && v257);
      if (v271) {
        v234 = (R - 0.0);
        v238 = Math.sqrt(((((v234 > 0.0) || (v234 !== v234)) ? v234 : 0.0) * (R + 0.0)));
        v239 = (c - 0.0);
        v243 = Math.sqrt(((((v239 > 0.0) || (v239 !== v239)) ? v239 : 0.0) * (c + 0.0)));
        if (v271) {
          v247 = (v23 - 0.0);
          v251 = Math.sqrt(((((v247 > 0.0) || (v247 !== v247)) ? v247 : 0.0) * (v23 + 0.0)));
          v255 = Math.sqrt(((((v25 > 0.0) || (v25 !== v25)) ? v25 : 0.0) * (R + v23)));
          v275 = (0.5 * Math.log1p((((((2.0 * v238) * (v257 ? (((v23 - c) * (v23 + c)) / (v251 + v243)) : 0.0)) / v255) * ((v238 + v251) / (v238 + v243))) / v255)));
        } else {
          v275 = 0.0;
        }
        v287 = (v238 * Math.sqrt(((((v136 > 0.0) || (v136 !== v136)) ? v136 : 0.0) * v137)));
        v304 = [];
        for ([node, weight] of RULE_0_4((v275 / 1.0))) {
          v276 = (node * v275);
          v277 = Math.cosh(v276);
          v278 = Math.sinh(v276);
          v281 = ((v238 * v277) + (v243 * v278));
          v286 = ((v238 * ((v243 * v277) + (v238 * v278))) / v281);
          v288 = (v287 / v281);
          v291 = Math.sqrt((0.0 + (v286 * v286)));
          v303 = ((((Math.asinh((v291 / v288)) + ((R * v291) / (v288 * v288))) * (v288 / v238)) * (v288 / v291)) * (v291 * v291));
          v304.push((weight * v303));
        }
        v304 = (math.fsum(v304) * v275);
        v305 = v304;
      } else {
        v305 = 0.0;
      }
      v306 = (((v7 > c) || (v7 !== v7)) ? v7 : c);
      v320 = (a > v306);
      v336 = (v233 && v320);
      if (v336) {
        v307 = (v306 - v7);
        v311 = Math.sqrt(((((v307 > 0.0) || (v307 !== v307)) ? v307 : 0.0) * (v306 + v7)));
        v312 = (v306 - 0.0);
        v316 = Math.sqrt(((((v312 > 0.0) || (v312 !== v312)) ? v312 : 0.0) * (v306 + 0.0)));
        if (v336) {
          v323 = ((a - v306) * (a + v306));
          if (v320) {
            v327 = (a - 0.0);
            v334 = (v323 / (Math.sqrt(((((v327 > 0.0) || (v327 !== v327)) ? v327 : 0.0) * (a + 0.0))) + v316));
          } else {
            v334 = 0.0;
          }
          v340 = Math.log1p((((v320 ? (v323 / (Math.sqrt(((((v16 > 0.0) || (v16 !== v16)) ? v16 : 0.0) * v17)) + v311)) : 0.0) + v334) / (v311 + v316)));
        } else {
          v340 = 0.0;
        }
        v370 = [];
        for ([node, weight] of RULE_0_4((v340 / v85))) {
          v341 = (node * v340);
          v346 = ((v311 * Math.cosh(v341)) + (v316 * Math.sinh(v341)));
          v349 = Math.sqrt((v105 + (v346 * v346)));
          v369 = ((((Math.log1p((((v110 / (v346 + v349)) + v114) / (v346 + v9))) + ((v7 * Math.atan2(v346, v7)) / v9)) + (v122 / ((v349 * v123) + ((R * v346) * v9)))) * (v346 / v349)) * (v349 * v349));
          v370.push((weight * v369));
        }
        v370 = (math.fsum(v370) * v340);
        v371 = v370;
      } else {
        v371 = 0.0;
      }
      v375 = (v81 * (v305 + v371));
    } else {
      v375 = (v135 - v230);
    }
    return (mu * v375);
  }
  return _tangential_force_of_sphere_tipped_cone(a, c, R, theta, E_star, mu);
};

const tangential_force = (a, c, R, theta, E_star, mu) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_force(a, c, R, theta, E_star, mu) : NaN);
};

const CLOSE_of_sphere_tipped_cone = 0.25;

const _slope_of_sphere_tipped_cone = (t, root, R) => {
  return (Math.asinh((t / root)) + ((R * t) / (root * root)));
};

const _traction = (r, a, c, R, theta, E_star, mu) => {
  let b, beyond, close, gain, sliding, stuck, tip;
  sliding = _pressure_of_sphere_tipped_cone(r, a, R, theta, E_star);
  stuck = _pressure_of_sphere_tipped_cone(r, c, R, theta, E_star);
  close = ((r < c) & (stuck >= (CLOSE_of_sphere_tipped_cone * sliding)));
  b = (R * Math.sin(theta));
  tip = growth_below(_slope_of_sphere_tipped_cone, [R], 0, r, c, math.minimum(a, b), R, close);
  beyond = growth_beyond(_slope_beyond, [R, theta], 0, r, c, a, b, close, { width: (1.0 - ((2.0 * theta) / Math.PI)) });
  gain = ((E_star / Math.PI) * (tip + beyond));
  return (mu * (close ? gain : (sliding - stuck)));
};

const traction = (r, a, c, R, theta, E_star, mu) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction(r, a, c, R, theta, E_star, mu) : 0.0) : NaN);
};

const _tangential_displacement_of_sphere_tipped_cone = (a, c, R, theta, E_star, G_star, mu) => {
  let b, beyond, close, gain, sticking, tip, whole;
  [whole, sticking] = [_depth_of_sphere_tipped_cone(a, R, theta), _depth_of_sphere_tipped_cone(c, R, theta)];
  close = (sticking >= (CLOSE * whole));
  b = (R * Math.sin(theta));
  tip = growth_below(_slope, [R], 1, 0.0, c, math.minimum(a, b), R, close);
  beyond = growth_beyond(_slope_beyond_of_sphere_tipped_cone, [R, theta], 1, 0.0, c, a, b, close, { width: (1.0 - ((2.0 * theta) / Math.PI)) });
  gain = (tip + beyond);
  return ((mu * (E_star / G_star)) * math.where(close, gain, (whole - sticking)));
};

const _tangential_displacement = (a, c, R, theta, E_star, G_star, mu) => {
  let node, v10, v100, v102, v11, v116, v12, v120, v122, v123, v124, v127, v13, v132, v133, v134, v137, v149, v150, v151, v155, v156, v157, v161, v162, v166, v17, v170, v173, v177, v18, v184, v186, v190, v191, v196, v197, v20, v200, v211, v212, v222, v223, v224, v229, v23, v26, v30, v45, v46, v47, v53, v55, v73, v76, v77, v78, v8, v82, v83, v87, v91, v95, v96, weight;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (R > 1e-30) && (R < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v8 = (R * Math.sin(theta));
    v10 = (R * Math.cos(theta));
    v11 = (v10 < v8);
    v12 = (v10 * v10);
    v13 = (R - a);
    v17 = (a - v8);
    v18 = (a + v8);
    v26 = (v8 * v8);
    v30 = (v26 / (v10 + R));
    if ((a < v8)) {
      v45 = (a * (Math.log1p(((2.0 * a) / v13)) / 2.0));
    } else {
      v20 = (v11 ? (v12 - (v13 * (R + a))) : (v17 * v18));
      v23 = Math.sqrt((((v20 > 0.0) || (v20 !== v20)) ? v20 : 0.0));
      v45 = (a * (Math.log1p((((v26 / (v23 + a)) + v30) / (v23 + v10))) + ((v8 * Math.atan2(v23, v8)) / v10)));
    }
    v46 = (R - c);
    v47 = (R + c);
    if ((c < v8)) {
      v73 = (c * (Math.log1p(((2.0 * c) / v46)) / 2.0));
    } else {
      v53 = (v11 ? (v12 - (v46 * v47)) : ((c - v8) * (c + v8)));
      v55 = Math.sqrt((((v53 > 0.0) || (v53 !== v53)) ? v53 : 0.0));
      v73 = (c * (Math.log1p((((v26 / (v55 + c)) + v30) / (v55 + v10))) + ((v8 * Math.atan2(v55, v8)) / v10)));
    }
    v76 = (v73 >= (0.25 * v45));
    if (v76) {
      v77 = (((a < v8) || (a !== a)) ? a : v8);
      v102 = (v77 > c);
      v116 = (v76 && v102);
      if (v116) {
        v78 = (R - 0.0);
        v82 = Math.sqrt(((((v78 > 0.0) || (v78 !== v78)) ? v78 : 0.0) * (R + 0.0)));
        v83 = (c - 0.0);
        v87 = Math.sqrt(((((v83 > 0.0) || (v83 !== v83)) ? v83 : 0.0) * (c + 0.0)));
        if (v116) {
          v91 = (v77 - 0.0);
          v95 = Math.sqrt(((((v91 > 0.0) || (v91 !== v91)) ? v91 : 0.0) * (v77 + 0.0)));
          v96 = (R - v77);
          v100 = Math.sqrt(((((v96 > 0.0) || (v96 !== v96)) ? v96 : 0.0) * (R + v77)));
          v120 = (0.5 * Math.log1p((((((2.0 * v82) * (v102 ? (((v77 - c) * (v77 + c)) / (v95 + v87)) : 0.0)) / v100) * ((v82 + v95) / (v82 + v87))) / v100)));
        } else {
          v120 = 0.0;
        }
        v133 = (v82 * Math.sqrt(((((v46 > 0.0) || (v46 !== v46)) ? v46 : 0.0) * v47)));
        v150 = [];
        for ([node, weight] of RULE_0_4((v120 / 1.0))) {
          v122 = (node * v120);
          v123 = Math.cosh(v122);
          v124 = Math.sinh(v122);
          v127 = ((v82 * v123) + (v87 * v124));
          v132 = ((v82 * ((v87 * v123) + (v82 * v124))) / v127);
          v134 = (v133 / v127);
          v137 = Math.sqrt((0.0 + (v132 * v132)));
          v149 = ((((Math.asinh((v137 / v134)) + ((R * v137) / (v134 * v134))) * (v134 / v82)) * (v134 / v137)) * Math.pow(v137, 1.0));
          v150.push((weight * v149));
        }
        v150 = (math.fsum(v150) * v120);
        v151 = v150;
      } else {
        v151 = 0.0;
      }
      v156 = (((v8 > c) || (v8 !== v8)) ? v8 : c);
      v170 = (a > v156);
      v186 = (v76 && v170);
      if (v186) {
        v155 = (1.0 - ((2.0 * theta) / 3.141592653589793));
        v157 = (v156 - v8);
        v161 = Math.sqrt(((((v157 > 0.0) || (v157 !== v157)) ? v157 : 0.0) * (v156 + v8)));
        v162 = (v156 - 0.0);
        v166 = Math.sqrt(((((v162 > 0.0) || (v162 !== v162)) ? v162 : 0.0) * (v156 + 0.0)));
        if (v186) {
          v173 = ((a - v156) * (a + v156));
          if (v170) {
            v177 = (a - 0.0);
            v184 = (v173 / (Math.sqrt(((((v177 > 0.0) || (v177 !== v177)) ? v177 : 0.0) * (a + 0.0))) + v166));
          } else {
            v184 = 0.0;
          }
          v190 = Math.log1p((((v170 ? (v173 / (Math.sqrt(((((v17 > 0.0) || (v17 !== v17)) ? v17 : 0.0) * v18)) + v161)) : 0.0) + v184) / (v161 + v166)));
        } else {
          v190 = 0.0;
        }
        v197 = (v8 * v8);
        v211 = (v26 * R);
        v212 = (v10 * v10);
        v223 = [];
        for ([node, weight] of RULE_0_4((v190 / v155))) {
          v191 = (node * v190);
          v196 = ((v161 * Math.cosh(v191)) + (v166 * Math.sinh(v191)));
          v200 = Math.sqrt((v197 + (v196 * v196)));
          v222 = ((((Math.log1p((((v26 / (v196 + v200)) + v30) / (v196 + v10))) + ((v8 * Math.atan2(v196, v8)) / v10)) + (v211 / ((v200 * v212) + ((R * v196) * v10)))) * (v196 / v200)) * Math.pow(v200, 1.0));
          v223.push((weight * v222));
        }
        v223 = (math.fsum(v223) * v190);
        v224 = v223;
      } else {
        v224 = 0.0;
      }
      v229 = (v151 + v224);
    } else {
      v229 = (v45 - v73);
    }
    return ((mu * (E_star / G_star)) * v229);
  }
  return _tangential_displacement_of_sphere_tipped_cone(a, c, R, theta, E_star, G_star, mu);
};

const tangential_displacement = (a, c, R, theta, E_star, G_star, mu) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement(a, c, R, theta, E_star, G_star, mu) : NaN);
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

const _stick_radius = (F_x, a, R, theta, E_star, mu) => {
  let F;
  F = stick_force(_force(a, R, theta, E_star), F_x, mu);
  return (((F_x === 0.0) & (a >= 0.0)) ? a : _radius_from_force(F, R, theta, E_star));
};

const stick_radius = (F_x, a, R, theta, E_star, mu) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius(F_x, a, R, theta, E_star, mu) : NaN);
};

const _full_slip_displacement_of_sphere_tipped_cone = (a, R, theta, E_star, G_star, mu) => {
  return ((mu * (E_star / G_star)) * _depth_of_sphere_tipped_cone(a, R, theta));
};

const _full_slip_displacement = (a, R, theta, E_star, G_star, mu) => {
  let v11, v14, v21, v24, v27, v46, v9;
  if (((a > 1e-30) && (a < 1e+30) && (R > 1e-30) && (R < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v9 = (R * Math.sin(theta));
    v14 = (R - a);
    if ((a < v9)) {
      v46 = (a * (Math.log1p(((2.0 * a) / v14)) / 2.0));
    } else {
      v11 = (R * Math.cos(theta));
      v21 = ((v11 < v9) ? ((v11 * v11) - (v14 * (R + a))) : ((a - v9) * (a + v9)));
      v24 = Math.sqrt((((v21 > 0.0) || (v21 !== v21)) ? v21 : 0.0));
      v27 = (v9 * v9);
      v46 = (a * (Math.log1p((((v27 / (v24 + a)) + (v27 / (v11 + R))) / (v24 + v11))) + ((v9 * Math.atan2(v24, v9)) / v11)));
    }
    return ((mu * (E_star / G_star)) * v46);
  }
  return _full_slip_displacement_of_sphere_tipped_cone(a, R, theta, E_star, G_star, mu);
};

const full_slip_displacement = (a, R, theta, E_star, G_star, mu) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement(a, R, theta, E_star, G_star, mu) : NaN);
};

const formulas = {
  "d": (v) => depth(v.a, v.R, v.theta),
  "F": (v) => force(v.a, v.R, v.theta, v.E_star),
  "p": (v) => pressure(v.r, v.a, v.R, v.theta, v.E_star),
  "w": (v) => displacement(v.r, v.a, v.R, v.theta),
  "k": (v) => stiffness(v.a, v.R, v.theta, v.E_star),
  "pm": (v) => mean_pressure(v.a, v.R, v.theta, v.E_star),
  "U": (v) => energy(v.a, v.R, v.theta, v.E_star),
  "Fr": (v) => load_within(v.r, v.a, v.R, v.theta, v.E_star),
  "ad": (v) => radius_from_depth(v.d, v.R, v.theta),
  "aF": (v) => radius_from_force(v.F, v.R, v.theta, v.E_star),
  "Fd": (v) => force_from_depth(v.d, v.R, v.theta, v.E_star),
  "dF": (v) => depth_from_force(v.F, v.R, v.theta, v.E_star),
  "adh.Dl": (v) => retraction(v.a, v.E_star, v.dgamma),
  "adh.d": (v) => depth_of_sphere_tipped_cone(v.a, v.R, v.theta, v.E_star, v.dgamma),
  "adh.F": (v) => force_of_sphere_tipped_cone(v.a, v.R, v.theta, v.E_star, v.dgamma),
  "adh.p": (v) => pressure_of_sphere_tipped_cone(v.r, v.a, v.R, v.theta, v.E_star, v.dgamma),
  "adh.w": (v) => displacement_of_sphere_tipped_cone(v.r, v.a, v.R, v.theta, v.E_star, v.dgamma),
  "tan.F": (v) => tangential_force(v.a, v.c, v.R, v.theta, v.E_star, v.mu),
  "tan.tau": (v) => traction(v.r, v.a, v.c, v.R, v.theta, v.E_star, v.mu),
  "tan.u": (v) => tangential_displacement(v.a, v.c, v.R, v.theta, v.E_star, v.G_star, v.mu),
  "tan.c": (v) => stick_radius(v.F_x, v.a, v.R, v.theta, v.E_star, v.mu),
  "tan.us": (v) => full_slip_displacement(v.a, v.R, v.theta, v.E_star, v.G_star, v.mu),
};
window.calculator = { ...{
 "fields": [
  {
   "name": "R",
   "tex": "R",
   "meaning": "radius of curvature",
   "unit": "m",
   "rule": "R > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 1e-07
  },
  {
   "name": "theta",
   "tex": "\\theta",
   "meaning": "inclination of the flank to the surface",
   "unit": "rad",
   "rule": "0 < theta < pi/2",
   "low": 0.0,
   "high": 1.5707963267948966,
   "closed": "",
   "value": 0.34383
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
   "value": 3571428571.428571
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
   "value": 0.4
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
   "value": 0.006429
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
    "R",
    "theta"
   ],
   "unit": "m",
   "place": "",
   "suffix": "d"
  },
  "F": {
   "gives": "F",
   "needs": [
    "a",
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta"
   ],
   "unit": "m",
   "place": "outside",
   "suffix": "w"
  },
  "k": {
   "gives": "stiffness",
   "needs": [
    "a",
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta"
   ],
   "unit": "m",
   "place": "",
   "suffix": "ad"
  },
  "aF": {
   "gives": "a",
   "needs": [
    "F",
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
