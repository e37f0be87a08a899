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

const _depth = (a, R1, R2, b) => {
  if ((a < b)) {
    return ((a * a) / R1);
  }
  return ((a * (a + (((R1 - R2) / R2) * math.sqrt(((a - b) * (a + b)))))) / R1);
};

const depth = (a, R1, R2, b) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth(a, R1, R2, b) : NaN);
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

const force = (a, R1, R2, b, E_star) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force(a, R1, R2, b, E_star) : NaN);
};

const RULE_0 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _slope_beyond = (t, root, R1, R2, b) => {
  return ((((2 * t) / R1) + (((2 * (R1 - R2)) / (R1 * R2)) * root)) + ((Math.pow(b, 2) * (R1 - R2)) / ((R1 * R2) * root)));
};

const difference_root = (x, y) => {
  let v2;
  v2 = (x - y);
  return math.sqrt(((((v2 > 0.0) || (v2 !== v2)) ? v2 : 0.0) * (x + y)));
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

const _pressure_of_capped_paraboloid = (r, a, R1, R2, b, E_star) => {
  let growth, inner, pressed, root, tip;
  inner = math.minimum(a, b);
  root = Math.sqrt(((inner - r) * (inner + r)));
  tip = math.where((r < inner), (((2 * E_star) / (Math.PI * R1)) * root), 0.0);
  growth = pressure_integral_beyond(_slope_beyond, [R1, R2, b], r, a, b);
  pressed = math.where((((r === b) & (a > b)) & (R1 > R2)), Infinity, (tip + ((E_star / Math.PI) * growth)));
  return math.where((r < a), pressed, 0.0);
};

const _pressure = (r, a, R1, R2, b, E_star) => {
  let node, v20, v23, v24, v27, v31, v32, v37, v44, v45, v46, v51, v53, v56, v6, v66, v67, v70, v73, v75, v76, v80, v85, v86, v87, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R1 > 1e-30) && (R1 < 1e+30) && (R2 > 1e-30) && (R2 < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((r < a)) {
      v20 = (r === b);
      if (((v20 && (a > b)) && (R1 > R2))) {
        return Infinity;
      }
      v6 = (((a < b) || (a !== a)) ? a : b);
      v23 = (v20 ? math.nextafter(b, Infinity) : r);
      if ((a > (((v23 > b) || (v23 !== v23)) ? v23 : b))) {
        v24 = (v23 < b);
        v27 = (a - b);
        v31 = Math.sqrt(((((v27 > 0.0) || (v27 !== v27)) ? v27 : 0.0) * (a + b)));
        if (v24) {
          v37 = v31;
        } else {
          v32 = (a - v23);
          v37 = Math.sqrt(((((v32 > 0.0) || (v32 !== v32)) ? v32 : 0.0) * (a + v23)));
        }
        v44 = Math.asinh((v37 / Math.sqrt((Math.abs((v23 - b)) * (v23 + b)))));
        v45 = (2.0 * (v24 ? 0.0 : 1.0));
        v46 = (1.0 - v45);
        v51 = (v45 - (v46 * Math.expm1(((-2.0) * v44))));
        v53 = ((v51 > 0.0) ? v51 : Infinity);
        v67 = (b * b);
        v73 = (R1 - R2);
        v75 = (R1 * R2);
        v76 = ((2.0 * v73) / v75);
        v80 = ((b * b) * v73);
        v86 = [];
        for ([node, weight] of RULE_0((v44 / 1.0))) {
          v56 = (node * v44);
          v66 = (v31 * ((Math.exp((-v56)) * (v45 - (v46 * Math.expm1(((-2.0) * (v44 - v56)))))) / v53));
          v70 = Math.sqrt((v67 + (v66 * v66)));
          v85 = ((((((2.0 * v70) / R1) + (v76 * v66)) + (v80 / (v75 * v66))) * v66) / v70);
          v86.push((weight * v85));
        }
        v86 = (math.fsum(v86) * v44);
        v87 = v86;
      } else {
        v87 = 0.0;
      }
      return (((r < v6) ? (((2.0 * E_star) / (3.141592653589793 * R1)) * Math.sqrt(((v6 - r) * (v6 + r)))) : 0.0) + ((E_star / 3.141592653589793) * v87));
    }
    return 0.0;
  }
  return _pressure_of_capped_paraboloid(r, a, R1, R2, b, E_star);
};

const pressure = (r, a, R1, R2, b, E_star) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure(r, a, R1, R2, b, E_star) : 0.0) : NaN);
};

const RULE_0_of_capped_paraboloid = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _displacement = (r, a, R1, R2, b) => {
  let node, v11, v12, v13, v15, v167, v18, v23, v25, v30, v33, v35, v44, v45, v47, v49, v5, v50, v53, v54, v6, v63, v65, v66, v69, v70, v79, v80, v82, v9, v93, v95, weight;
  v6 = (r - b);
  v9 = (r + b);
  v13 = (a - b);
  v15 = (a + b);
  v63 = (R1 - R2);
  v69 = (b * b);
  if ((r > a)) {
    v5 = (((a < b) || (a !== a)) ? a : b);
    if ((a > b)) {
      v11 = math.sqrt(((((v6 > 0.0) || (v6 !== v6)) ? v6 : 0.0) * v9));
      v12 = (b / r);
      v18 = (r - a);
      v23 = (math.sqrt(((((v13 > 0.0) || (v13 !== v13)) ? v13 : 0.0) * v15)) / math.sqrt(((((v18 > 0.0) || (v18 !== v18)) ? v18 : 0.0) * (r + a))));
      v25 = Math.asinh((v23 / v12));
      v30 = (0.0 - Math.expm1(((-2.0) * v25)));
      v33 = ((v30 > 0.0) ? v30 : Infinity);
      v50 = (b * b);
      v54 = (v12 * v12);
      v65 = (R1 * R2);
      v66 = ((2.0 * v63) / v65);
      v70 = (v69 * v63);
      v80 = [];
      for ([node, weight] of RULE_0_of_capped_paraboloid((v25 / 1.0))) {
        v35 = (node * v25);
        v44 = (v23 * ((Math.exp((-v35)) * (0.0 - Math.expm1(((-2.0) * (v25 - v35))))) / v33));
        v45 = (v44 * v44);
        v47 = math.sqrt((1.0 + v45));
        v49 = ((v11 * v44) / v47);
        v53 = math.sqrt((v50 + (v49 * v49)));
        v79 = ((((((((2.0 * v53) / R1) + (v66 * v49)) + (v70 / (v65 * v49))) * v49) / v53) * Math.atan2(v53, (v11 / v47))) * (math.sqrt((v54 + v45)) / ((v47 * v47) * v47)));
        v80.push((weight * v79));
      }
      v80 = (math.fsum(v80) * v25);
      v82 = (v11 * v80);
    } else {
      v82 = 0.0;
    }
    v93 = (v5 / (r + math.sqrt(((r - v5) * (r + v5)))));
    v95 = (v93 * v93);
    return ((((2.0 * (v5 * v5)) / (3.141592653589793 * R1)) * ((v5 / r) * (0.6666666666666666 + (v95 * ((((((((((((((((((-0.7327347664453868) * v95) + (-32.15553480435792)) * v95) + (-332.23363563146734)) * v95) + (-1070.7082873491413)) * v95) + (-85.27694715374247)) * v95) + 5044.821368830373) * v95) + 8082.413158212496) * v95) + 3759.725330928701) * v95) + 0.26666666666720995) / ((((((((((((((((0.21387262524856868 * v95) + 32.12935731379798) * v95) + 746.8124983579742) * v95) + 6202.125133759036) * v95) + 23553.080984642995) * v95) + 44404.005348491315) * v95) + 40380.01430284195) * v95) + 14099.684276696918) * v95) + 1.0)))))) + (0.6366197723675814 * v82));
  }
  v167 = (2.0 * R1);
  return (((a < b) ? ((a * a) / R1) : ((a * (a + ((v63 / R2) * math.sqrt((v13 * v15))))) / R1)) - ((r < b) ? ((r * r) / v167) : ((v69 / v167) + ((v6 * v9) / (2.0 * R2)))));
};

const displacement = (r, a, R1, R2, b) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement(r, a, R1, R2, b) : 0.0) : NaN);
};

const _stiffness_of_capped_paraboloid = (a, E_star) => {
  return ((2 * E_star) * a);
};

const _stiffness = (a, E_star, R1 = 1.0, R2 = 1.0, b = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (R1 > 1e-30) && (R1 < 1e+30) && (R2 > 1e-30) && (R2 < 1e+30) && (b > 1e-30) && (b < 1e+30))) {
    return ((2.0 * E_star) * a);
  }
  return _stiffness_of_capped_paraboloid(a, E_star);
};

const stiffness = (a, R1, R2, b, E_star) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness(a, E_star) : NaN);
};

const _mean_pressure_of_capped_paraboloid = (a, R1, R2, b, E_star) => {
  let beyond, root, tip;
  tip = (((4 * E_star) / ((3 * Math.PI) * R1)) * a);
  root = Math.sqrt(((a - b) * (a + b)));
  beyond = (((2 * E_star) / ((3 * Math.PI) * R1)) * ((2 * a) + ((((R1 - R2) * ((2 * Math.pow(a, 2)) + Math.pow(b, 2))) * root) / (Math.pow(a, 2) * R2))));
  return math.where((a < b), tip, beyond);
};

const _mean_pressure = (a, R1, R2, b, E_star) => {
  let v20, v8;
  if (((a > 1e-30) && (a < 1e+30) && (R1 > 1e-30) && (R1 < 1e+30) && (R2 > 1e-30) && (R2 < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v8 = (9.42477796076938 * R1);
    if ((a < b)) {
      return (((4.0 * E_star) / v8) * a);
    }
    v20 = (a * a);
    return (((2.0 * E_star) / v8) * ((2.0 * a) + ((((R1 - R2) * ((2.0 * v20) + (b * b))) * Math.sqrt(((a - b) * (a + b)))) / (v20 * R2))));
  }
  return _mean_pressure_of_capped_paraboloid(a, R1, R2, b, E_star);
};

const mean_pressure = (a, R1, R2, b, E_star) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure(a, R1, R2, b, E_star) : NaN);
};

const _depth_of_capped_paraboloid = (a, R1, R2, b) => {
  let beyond, root, tip;
  tip = (Math.pow(a, 2) / R1);
  root = Math.sqrt(((a - b) * (a + b)));
  beyond = ((a * (a + (((R1 - R2) / R2) * root))) / R1);
  return math.where((a < b), tip, beyond);
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

const _depth_beyond = (a, root, R1, R2) => {
  return ((a * (a + (((R1 - R2) / R2) * root))) / R1);
};

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

const _energy_of_capped_paraboloid = (a, R1, R2, b, E_star) => {
  let beyond, inner, sunk, tip;
  sunk = _depth_of_capped_paraboloid(a, R1, R2, b);
  inner = math.minimum(a, b);
  tip = energy_integral(_depth_of_capped_paraboloid, [R1, R2, b], inner, sunk, inner);
  beyond = energy_integral_beyond(_depth_beyond, [R1, R2], a, sunk, b);
  return (E_star * (tip + beyond));
};

const _energy = (a, R1, R2, b, E_star) => {
  let node, v13, v19, v20, v22, v28, v31, v32, v41, v54, v56, v60, v61, v65, v67, v70, v72, v74, v8, v83, v84, v87, v9, v92, v94, v95, v96, weight;
  if (((a > 1e-30) && (a < 1e+30) && (R1 > 1e-30) && (R1 < 1e+30) && (R2 > 1e-30) && (R2 < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v8 = (a - b);
    v9 = (a + b);
    v13 = ((R1 - R2) / R2);
    v19 = ((a < b) ? ((a * a) / R1) : ((a * (a + (v13 * Math.sqrt((v8 * v9))))) / R1));
    v20 = (((a < b) || (a !== a)) ? a : b);
    v22 = Math.asinh((v20 / v20));
    v28 = (0.0 - Math.expm1(((-2.0) * v22)));
    v31 = ((v28 > 0.0) ? v28 : Infinity);
    v56 = (v20 * v20);
    v61 = [];
    for ([node, weight] of RULE_0((v22 / 1.0))) {
      v32 = (node * v22);
      v41 = (v20 * ((Math.exp((-v32)) * (0.0 - Math.expm1(((-2.0) * (v22 - v32))))) / v31));
      v54 = (v19 - ((v41 < b) ? ((v41 * v41) / R1) : ((v41 * (v41 + (v13 * Math.sqrt(((v41 - b) * (v41 + b)))))) / R1)));
      v60 = ((v54 * v54) * Math.sqrt((v56 + (v41 * v41))));
      v61.push((weight * v60));
    }
    v61 = (math.fsum(v61) * v22);
    if ((a > b)) {
      v65 = Math.sqrt(((((v8 > 0.0) || (v8 !== v8)) ? v8 : 0.0) * v9));
      v67 = Math.asinh((v65 / b));
      v70 = (0.0 - Math.expm1(((-2.0) * v67)));
      v72 = ((v70 > 0.0) ? v70 : Infinity);
      v84 = (b * b);
      v95 = [];
      for ([node, weight] of RULE_0((v67 / 1.0))) {
        v74 = (node * v67);
        v83 = (v65 * ((Math.exp((-v74)) * (0.0 - Math.expm1(((-2.0) * (v67 - v74))))) / v72));
        v87 = Math.sqrt((v84 + (v83 * v83)));
        v92 = (v19 - ((v87 * (v87 + (v13 * v83))) / R1));
        v94 = ((v92 * v92) * v83);
        v95.push((weight * v94));
      }
      v95 = (math.fsum(v95) * v67);
      v96 = v95;
    } else {
      v96 = 0.0;
    }
    return (E_star * (v61 + v96));
  }
  return _energy_of_capped_paraboloid(a, R1, R2, b, E_star);
};

const energy = (a, R1, R2, b, E_star) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _energy(a, R1, R2, b, E_star) : NaN);
};

const _slope = (t, R1) => {
  return ((2 * t) / R1);
};

const load_within_integral = math.in_groups((slope, r, a) => {
  let fallen, integrand, reach, stop;
  reach = difference_root(a, r);
  stop = Math.asinh((reach / r));
  fallen = falling(stop);
  integrand = (v) => {
    let t, u;
    u = (reach * fallen(v));
    t = Math.sqrt(((r * r) + (u * u)));
    return (slope(t) * (u / (t + u)));
  };
  return [integrand, stop, (r * r), (r > 0.0), 0.0];
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

const _force_of_capped_paraboloid = (a, R1, R2, b, E_star) => {
  let beyond, root, tip;
  tip = (((4 * E_star) / (3 * R1)) * Math.pow(a, 3));
  root = Math.sqrt(((a - b) * (a + b)));
  beyond = (((2 * E_star) / (3 * R1)) * ((2 * Math.pow(a, 3)) + ((((R1 - R2) / R2) * ((2 * Math.pow(a, 2)) + Math.pow(b, 2))) * root)));
  return math.where((a < b), tip, beyond);
};

const _load_within_of_capped_paraboloid = (r, a, R1, R2, b, E_star) => {
  let beyond, inner, tip;
  inner = math.minimum(a, b);
  tip = load_within_integral(_slope, [R1], math.minimum(r, inner), inner);
  beyond = load_within_integral_beyond(_slope_beyond, [R1, R2, b], r, a, b);
  return (_force_of_capped_paraboloid(math.minimum(r, a), R1, R2, b, E_star) + ((2 * E_star) * (tip + beyond)));
};

const _load_within = (r, a, R1, R2, b, E_star) => {
  let node, v104, v105, v108, v111, v113, v114, v117, v118, v126, v127, v129, v13, v130, v134, v136, v137, v143, v15, v20, v23, v24, v26, v35, v38, v44, v45, v47, v50, v51, v52, v53, v57, v58, v6, v62, v7, v70, v71, v72, v74, v76, v78, v8, v80, v81, v83, v85, v89, v91, v94, v99, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R1 > 1e-30) && (R1 < 1e+30) && (R2 > 1e-30) && (R2 < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v6 = (((a < b) || (a !== a)) ? a : b);
    v7 = (((r < v6) || (r !== r)) ? r : v6);
    if ((v7 > 0.0)) {
      v8 = (v6 - v7);
      v13 = Math.sqrt(((((v8 > 0.0) || (v8 !== v8)) ? v8 : 0.0) * (v6 + v7)));
      v15 = Math.asinh((v13 / v7));
      v20 = (0.0 - Math.expm1(((-2.0) * v15)));
      v23 = ((v20 > 0.0) ? v20 : Infinity);
      v24 = (v7 * v7);
      v45 = [];
      for ([node, weight] of RULE_0((v15 / 1.0))) {
        v26 = (node * v15);
        v35 = (v13 * ((Math.exp((-v26)) * (0.0 - Math.expm1(((-2.0) * (v15 - v26))))) / v23));
        v38 = Math.sqrt((v24 + (v35 * v35)));
        v44 = (((2.0 * v38) / R1) * (v35 / (v38 + v35)));
        v45.push((weight * v44));
      }
      v45 = (math.fsum(v45) * v15);
      v47 = (v24 * v45);
    } else {
      v47 = 0.0;
    }
    v50 = ((r === b) ? math.nextafter(b, Infinity) : r);
    v111 = (R1 - R2);
    v117 = (b * b);
    if ((a > (((v50 > b) || (v50 !== v50)) ? v50 : b))) {
      v51 = (v50 < b);
      v52 = (v51 ? 0.0 : 1.0);
      v53 = (a - b);
      v57 = Math.sqrt(((((v53 > 0.0) || (v53 !== v53)) ? v53 : 0.0) * (a + b)));
      v58 = (a - v50);
      v62 = Math.sqrt(((((v58 > 0.0) || (v58 !== v58)) ? v58 : 0.0) * (a + v50)));
      v70 = Math.asinh(((v51 ? v57 : v62) / Math.sqrt((Math.abs((v50 - b)) * (v50 + b)))));
      v71 = (2.0 * v52);
      v72 = (1.0 - v71);
      v74 = Math.expm1(((-2.0) * v70));
      v76 = (v71 - (v72 * v74));
      v78 = ((v76 > 0.0) ? v76 : Infinity);
      v80 = (2.0 * (1.0 - v52));
      v81 = (1.0 - v80);
      v83 = (v80 - (v81 * v74));
      v85 = ((v83 > 0.0) ? v83 : Infinity);
      v105 = (b * b);
      v113 = (R1 * R2);
      v114 = ((2.0 * v111) / v113);
      v118 = (v117 * v111);
      v127 = [];
      for ([node, weight] of RULE_0((v70 / 1.0))) {
        v89 = (node * v70);
        v91 = Math.exp((-v89));
        v94 = Math.expm1(((-2.0) * (v70 - v89)));
        v99 = (v57 * ((v91 * (v71 - (v72 * v94))) / v78));
        v104 = (v62 * ((v91 * (v80 - (v81 * v94))) / v85));
        v108 = Math.sqrt((v105 + (v99 * v99)));
        v126 = ((((((2.0 * v108) / R1) + (v114 * v99)) + (v118 / (v113 * v99))) * (v99 / v108)) * (v104 / (v108 + v104)));
        v127.push((weight * v126));
      }
      v127 = (math.fsum(v127) * v70);
      v129 = ((v50 * v50) * v127);
    } else {
      v129 = 0.0;
    }
    v130 = (((r < a) || (r !== r)) ? r : a);
    v134 = (3.0 * R1);
    v136 = (v130 * v130);
    v137 = (v130 * v136);
    v143 = (2.0 * E_star);
    return (((v130 < b) ? (((4.0 * E_star) / v134) * v137) : ((v143 / v134) * ((2.0 * v137) + (((v111 / R2) * ((2.0 * v136) + v117)) * Math.sqrt(((v130 - b) * (v130 + b))))))) + (v143 * (v47 + v129)));
  }
  return _load_within_of_capped_paraboloid(r, a, R1, R2, b, E_star);
};

const load_within = (r, a, R1, R2, b, E_star) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _load_within(r, a, R1, R2, b, E_star) : 0.0) : NaN);
};

const _slope_beyond_of_capped_paraboloid = (t, root, R1, R2, b) => {
  let v10, v8;
  v8 = (R1 - R2);
  v10 = (R1 * R2);
  return ((((2.0 * t) / R1) + (((2.0 * v8) / v10) * root)) + (((b * b) * v8) / (v10 * root)));
};

const _depth_beyond_of_capped_paraboloid = (a, root, R1, R2) => {
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
    rate = (a * _slope_beyond_of_capped_paraboloid(a, root, R1, R2, b));
    return [_depth_beyond_of_capped_paraboloid(a, root, R1, R2), rate];
  };
  return inverse_beyond(curve, d, b, 2.0, undefined, [1.0, 2.0]);
};

const radius_from_depth = (d, R1, R2, b) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth(d, R1, R2, b) : NaN);
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
    rate = (((2 * E_star) * Math.pow(a, 2)) * _slope_beyond_of_capped_paraboloid(a, root, R1, R2, b));
    return [_force_beyond(a, root, R1, R2, b, E_star), rate];
  };
  return inverse_beyond(curve, F, b, 3.0, undefined, [1.0, 3.0]);
};

const radius_from_force = (F, R1, R2, b, E_star) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _radius_from_force(F, R1, R2, b, E_star) : NaN);
};

const _force_from_depth = (d, R1, R2, b, E_star) => {
  let a, change;
  a = _radius_from_depth(d, R1, R2, b);
  change = (((a > 0.0) & (a < Infinity)) ? (((2 * E_star) * a) * (d - _depth(a, R1, R2, b))) : 0.0);
  return (_force(a, R1, R2, b, E_star) + change);
};

const force_from_depth = (d, R1, R2, b, E_star) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth(d, R1, R2, b, E_star) : NaN);
};

const _depth_from_force = (F, R1, R2, b, E_star) => {
  let a, change;
  a = _radius_from_force(F, R1, R2, b, E_star);
  change = (((a > 0.0) & (a < Infinity)) ? ((F - _force(a, R1, R2, b, E_star)) / ((2 * E_star) * a)) : 0.0);
  return (_depth(a, R1, R2, b) + change);
};

const depth_from_force = (F, R1, R2, b, E_star) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force(F, R1, R2, b, E_star) : NaN);
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

const _depth_2 = (a, R1, R2, b, E_star, dgamma) => {
  return (((a < b) ? ((a * a) / R1) : ((a * (a + (((R1 - R2) / R2) * math.sqrt(((a - b) * (a + b)))))) / R1)) - (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const depth_of_capped_paraboloid = (a, R1, R2, b, E_star, dgamma) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_2(a, R1, R2, b, E_star, dgamma) : NaN);
};

const _force_2 = (a, R1, R2, b, E_star, dgamma) => {
  let v12, v13, v19, v9;
  v9 = (3.0 * R1);
  v12 = (a * a);
  v13 = (a * v12);
  v19 = (2.0 * E_star);
  return (((a < b) ? (((4.0 * E_star) / v9) * v13) : ((v19 / v9) * ((2.0 * v13) + ((((R1 - R2) / R2) * ((2.0 * v12) + (b * b))) * math.sqrt(((a - b) * (a + b))))))) - ((v19 * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star)))));
};

const force_of_capped_paraboloid = (a, R1, R2, b, E_star, dgamma) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_2(a, R1, R2, b, E_star, dgamma) : NaN);
};

const RULE_0_2 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

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

const _pressure_3 = (r, a, R1, R2, b, E_star, dgamma) => {
  return (_pressure_of_capped_paraboloid(r, a, R1, R2, b, E_star) - tension(r, a, E_star, dgamma));
};

const _pressure_2 = (r, a, R1, R2, b, E_star, dgamma) => {
  let node, v104, v107, v114, v116, v21, v24, v25, v28, v32, v33, v38, v45, v46, v47, v52, v54, v57, v67, v68, v7, v71, v74, v76, v77, v81, v86, v87, v88, v96, v98, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R1 > 1e-30) && (R1 < 1e+30) && (R2 > 1e-30) && (R2 < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    if ((r < a)) {
      v21 = (r === b);
      if (((v21 && (a > b)) && (R1 > R2))) {
        v96 = Infinity;
      } else {
        v7 = (((a < b) || (a !== a)) ? a : b);
        v24 = (v21 ? math.nextafter(b, Infinity) : r);
        if ((a > (((v24 > b) || (v24 !== v24)) ? v24 : b))) {
          v25 = (v24 < b);
          v28 = (a - b);
          v32 = Math.sqrt(((((v28 > 0.0) || (v28 !== v28)) ? v28 : 0.0) * (a + b)));
          if (v25) {
            v38 = v32;
          } else {
            v33 = (a - v24);
            v38 = Math.sqrt(((((v33 > 0.0) || (v33 !== v33)) ? v33 : 0.0) * (a + v24)));
          }
          v45 = Math.asinh((v38 / Math.sqrt((Math.abs((v24 - b)) * (v24 + b)))));
          v46 = (2.0 * (v25 ? 0.0 : 1.0));
          v47 = (1.0 - v46);
          v52 = (v46 - (v47 * Math.expm1(((-2.0) * v45))));
          v54 = ((v52 > 0.0) ? v52 : Infinity);
          v68 = (b * b);
          v74 = (R1 - R2);
          v76 = (R1 * R2);
          v77 = ((2.0 * v74) / v76);
          v81 = ((b * b) * v74);
          v87 = [];
          for ([node, weight] of RULE_0_2((v45 / 1.0))) {
            v57 = (node * v45);
            v67 = (v32 * ((Math.exp((-v57)) * (v46 - (v47 * Math.expm1(((-2.0) * (v45 - v57)))))) / v54));
            v71 = Math.sqrt((v68 + (v67 * v67)));
            v86 = ((((((2.0 * v71) / R1) + (v77 * v67)) + (v81 / (v76 * v67))) * v67) / v71);
            v87.push((weight * v86));
          }
          v87 = (math.fsum(v87) * v45);
          v88 = v87;
        } else {
          v88 = 0.0;
        }
        v96 = (((r < v7) ? (((2.0 * E_star) / (3.141592653589793 * R1)) * Math.sqrt(((v7 - r) * (v7 + r)))) : 0.0) + ((E_star / 3.141592653589793) * v88));
      }
      v98 = v96;
    } else {
      v98 = 0.0;
    }
    if ((r <= a)) {
      v104 = (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star)));
      if ((v104 > 0.0)) {
        v107 = (a - r);
        v114 = ((E_star * v104) / (3.141592653589793 * Math.sqrt(((((v107 > 0.0) || (v107 !== v107)) ? v107 : 0.0) * (a + r)))));
      } else {
        v114 = 0.0;
      }
      v116 = v114;
    } else {
      v116 = 0.0;
    }
    return (v98 - v116);
  }
  return _pressure_3(r, a, R1, R2, b, E_star, dgamma);
};

const pressure_of_capped_paraboloid = (r, a, R1, R2, b, E_star, dgamma) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_2(r, a, R1, R2, b, E_star, dgamma) : 0.0) : NaN);
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

const _profile = (r, R1, R2, b) => {
  return math.where((r < b), (Math.pow(r, 2) / (2 * R1)), ((Math.pow(b, 2) / (2 * R1)) + (((r - b) * (r + b)) / (2 * R2))));
};

const _displacement_3 = (r, a, R1, R2, b) => {
  let beyond, inner, inside, outside;
  inner = math.minimum(a, b);
  beyond = displacement_integral_beyond(_slope_beyond, [R1, R2, b], r, a, b);
  outside = ((((2 * Math.pow(inner, 2)) / (Math.PI * R1)) * beside(r, inner, OUTSIDE_2)) + ((2 / Math.PI) * beyond));
  inside = (_depth_of_capped_paraboloid(a, R1, R2, b) - _profile(r, R1, R2, b));
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

const _displacement_2 = (r, a, R1, R2, b, E_star, dgamma) => {
  return (_displacement_3(r, a, R1, R2, b) - lift(r, a, E_star, dgamma));
};

const _displacement_of_capped_paraboloid = (r, a, R1, R2, b, E_star, dgamma) => {
  let node, v11, v13, v14, v15, v169, v17, v178, v179, v20, v24, v25, v27, v32, v35, v37, v46, v47, v49, v51, v52, v55, v56, v65, v67, v68, v7, v71, v72, v8, v81, v82, v84, v95, v97, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (R1 > 1e-30) && (R1 < 1e+30) && (R2 > 1e-30) && (R2 < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v8 = (r - b);
    v11 = (r + b);
    v15 = (a - b);
    v17 = (a + b);
    v20 = (r - a);
    v24 = Math.sqrt(((((v20 > 0.0) || (v20 !== v20)) ? v20 : 0.0) * (r + a)));
    v65 = (R1 - R2);
    v71 = (b * b);
    v178 = (r > a);
    if (v178) {
      v7 = (((a < b) || (a !== a)) ? a : b);
      if ((a > b)) {
        v13 = Math.sqrt(((((v8 > 0.0) || (v8 !== v8)) ? v8 : 0.0) * v11));
        v14 = (b / r);
        v25 = (Math.sqrt(((((v15 > 0.0) || (v15 !== v15)) ? v15 : 0.0) * v17)) / v24);
        v27 = Math.asinh((v25 / v14));
        v32 = (0.0 - Math.expm1(((-2.0) * v27)));
        v35 = ((v32 > 0.0) ? v32 : Infinity);
        v52 = (b * b);
        v56 = (v14 * v14);
        v67 = (R1 * R2);
        v68 = ((2.0 * v65) / v67);
        v72 = (v71 * v65);
        v82 = [];
        for ([node, weight] of RULE_0_2((v27 / 1.0))) {
          v37 = (node * v27);
          v46 = (v25 * ((Math.exp((-v37)) * (0.0 - Math.expm1(((-2.0) * (v27 - v37))))) / v35));
          v47 = (v46 * v46);
          v49 = Math.sqrt((1.0 + v47));
          v51 = ((v13 * v46) / v49);
          v55 = Math.sqrt((v52 + (v51 * v51)));
          v81 = ((((((((2.0 * v55) / R1) + (v68 * v51)) + (v72 / (v67 * v51))) * v51) / v55) * Math.atan2(v55, (v13 / v49))) * (Math.sqrt((v56 + v47)) / ((v49 * v49) * v49)));
          v82.push((weight * v81));
        }
        v82 = (math.fsum(v82) * v27);
        v84 = (v13 * v82);
      } else {
        v84 = 0.0;
      }
      v95 = (v7 / (r + Math.sqrt(((r - v7) * (r + v7)))));
      v97 = (v95 * v95);
      v179 = ((((2.0 * (v7 * v7)) / (3.141592653589793 * R1)) * ((v7 / r) * (0.6666666666666666 + (v97 * ((((((((((((((((((-0.7327347664453868) * v97) + (-32.15553480435792)) * v97) + (-332.23363563146734)) * v97) + (-1070.7082873491413)) * v97) + (-85.27694715374247)) * v97) + 5044.821368830373) * v97) + 8082.413158212496) * v97) + 3759.725330928701) * v97) + 0.26666666666720995) / ((((((((((((((((0.21387262524856868 * v97) + 32.12935731379798) * v97) + 746.8124983579742) * v97) + 6202.125133759036) * v97) + 23553.080984642995) * v97) + 44404.005348491315) * v97) + 40380.01430284195) * v97) + 14099.684276696918) * v97) + 1.0)))))) + (0.6366197723675814 * v84));
    } else {
      v169 = (2.0 * R1);
      v179 = (((a < b) ? ((a * a) / R1) : ((a * (a + ((v65 / R2) * Math.sqrt((v15 * v17))))) / R1)) - ((r < b) ? ((r * r) / v169) : ((v71 / v169) + ((v8 * v11) / (2.0 * R2)))));
    }
    return (v179 - ((Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))) * (v178 ? (0.6366197723675814 * Math.atan2(a, v24)) : 1.0)));
  }
  return _displacement_2(r, a, R1, R2, b, E_star, dgamma);
};

const displacement_of_capped_paraboloid = (r, a, R1, R2, b, E_star, dgamma) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_of_capped_paraboloid(r, a, R1, R2, b, E_star, dgamma) : 0.0) : NaN);
};

const RULE_0_3 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const CLOSE = 0.25;

const _gap = (a, c, outer, inner) => {
  return math.where((a > c), (((a - c) * (a + c)) / (outer + inner)), 0.0);
};

const growth = math.in_groups((slope, order, r, c, a, close) => {
  let integrand, root, stop;
  root = difference_root(c, r);
  stop = Math.log1p((((a - c) + _gap(a, c, difference_root(a, r), root)) / (c + root)));
  integrand = (v) => {
    let t;
    t = ((c * Math.cosh(v)) + (root * Math.sinh(v)));
    return (slope(t) * Math.pow(t, order));
  };
  return [integrand, math.where((close & (a > c)), stop, 0.0), 1.0, (close & (a > c)), 0.0];
});

const _gap_of_slip = (a, c, outer, inner) => {
  if ((a > c)) {
    return (((a - c) * (a + c)) / (outer + inner));
  }
  return 0.0;
};

const growth_beyond = math.in_groups((slope, order, r, c, a, b, close) => {
  let beyond, gaps, holds, integrand, root, start;
  start = math.maximum(b, c);
  [beyond, root] = [difference_root(start, b), difference_root(start, r)];
  gaps = (_gap_of_slip(a, start, difference_root(a, b), beyond) + _gap_of_slip(a, start, difference_root(a, r), root));
  holds = (close & (a > start));
  integrand = (v) => {
    let side, t;
    side = ((beyond * Math.cosh(v)) + (root * Math.sinh(v)));
    t = Math.sqrt(((b * b) + (side * side)));
    return ((slope(t, side) * (side / t)) * Math.pow(t, order));
  };
  return [integrand, (holds ? Math.log1p((gaps / (beyond + root))) : 0.0), 1.0, holds, 0.0];
});

const _tangential_force_of_capped_paraboloid = (a, c, R1, R2, b, E_star, mu) => {
  let beyond, close, gain, sticking, tip, whole;
  [whole, sticking] = [_force_of_capped_paraboloid(a, R1, R2, b, E_star), _force_of_capped_paraboloid(c, R1, R2, b, E_star)];
  close = (sticking >= (CLOSE * whole));
  tip = growth(_slope, [R1], 2, 0.0, c, math.minimum(a, b), close);
  beyond = growth_beyond(_slope_beyond, [R1, R2, b], 2, 0.0, c, a, b, close);
  gain = ((2.0 * E_star) * (tip + beyond));
  return (mu * math.where(close, gain, (whole - sticking)));
};

const _tangential_force = (a, c, R1, R2, b, E_star, mu) => {
  let node, v10, v101, v105, v108, v11, v112, v119, v121, v125, v126, v13, v131, v132, v135, v139, v14, v140, v143, v150, v151, v152, v156, v16, v17, v20, v21, v23, v24, v26, v33, v34, v35, v49, v52, v53, v55, v59, v60, v61, v66, v71, v76, v77, v79, v84, v88, v89, v90, v91, v92, v96, v97, weight;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (R1 > 1e-30) && (R1 < 1e+30) && (R2 > 1e-30) && (R2 < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v10 = (3.0 * R1);
    v11 = ((4.0 * E_star) / v10);
    v13 = (a * a);
    v14 = (a * v13);
    v16 = (a - b);
    v17 = (a + b);
    v20 = (2.0 * E_star);
    v21 = (v20 / v10);
    v23 = (R1 - R2);
    v24 = (v23 / R2);
    v26 = (b * b);
    v33 = ((a < b) ? (v11 * v14) : (v21 * ((2.0 * v14) + ((v24 * ((2.0 * v13) + v26)) * Math.sqrt((v16 * v17))))));
    v34 = (c * c);
    v35 = (c * v34);
    v49 = ((c < b) ? (v11 * v35) : (v21 * ((2.0 * v35) + ((v24 * ((2.0 * v34) + v26)) * Math.sqrt(((c - b) * (c + b)))))));
    v52 = (v49 >= (0.25 * v33));
    if (v52) {
      v53 = (((a < b) || (a !== a)) ? a : b);
      v66 = (v53 > c);
      v76 = (v52 && v66);
      if (v76) {
        v55 = (c - 0.0);
        v59 = Math.sqrt(((((v55 > 0.0) || (v55 !== v55)) ? v55 : 0.0) * (c + 0.0)));
        if (v76) {
          v60 = (v53 - c);
          if (v66) {
            v61 = (v53 - 0.0);
            v71 = ((v60 * (v53 + c)) / (Math.sqrt(((((v61 > 0.0) || (v61 !== v61)) ? v61 : 0.0) * (v53 + 0.0))) + v59));
          } else {
            v71 = 0.0;
          }
          v77 = Math.log1p(((v60 + v71) / (c + v59)));
        } else {
          v77 = 0.0;
        }
        v89 = [];
        for ([node, weight] of RULE_0_3((v77 / 1.0))) {
          v79 = (node * v77);
          v84 = ((c * Math.cosh(v79)) + (v59 * Math.sinh(v79)));
          v88 = (((2.0 * v84) / R1) * (v84 * v84));
          v89.push((weight * v88));
        }
        v89 = (math.fsum(v89) * v77);
        v90 = v89;
      } else {
        v90 = 0.0;
      }
      v91 = (((b > c) || (b !== b)) ? b : c);
      v105 = (a > v91);
      v121 = (v52 && v105);
      if (v121) {
        v92 = (v91 - b);
        v96 = Math.sqrt(((((v92 > 0.0) || (v92 !== v92)) ? v92 : 0.0) * (v91 + b)));
        v97 = (v91 - 0.0);
        v101 = Math.sqrt(((((v97 > 0.0) || (v97 !== v97)) ? v97 : 0.0) * (v91 + 0.0)));
        if (v121) {
          v108 = ((a - v91) * (a + v91));
          if (v105) {
            v112 = (a - 0.0);
            v119 = (v108 / (Math.sqrt(((((v112 > 0.0) || (v112 !== v112)) ? v112 : 0.0) * (a + 0.0))) + v101));
          } else {
            v119 = 0.0;
          }
          v125 = Math.log1p((((v105 ? (v108 / (Math.sqrt(((((v16 > 0.0) || (v16 !== v16)) ? v16 : 0.0) * v17)) + v96)) : 0.0) + v119) / (v96 + v101)));
        } else {
          v125 = 0.0;
        }
        v132 = (b * b);
        v139 = (R1 * R2);
        v140 = ((2.0 * v23) / v139);
        v143 = (v26 * v23);
        v151 = [];
        for ([node, weight] of RULE_0_3((v125 / 1.0))) {
          v126 = (node * v125);
          v131 = ((v96 * Math.cosh(v126)) + (v101 * Math.sinh(v126)));
          v135 = Math.sqrt((v132 + (v131 * v131)));
          v150 = ((((((2.0 * v135) / R1) + (v140 * v131)) + (v143 / (v139 * v131))) * (v131 / v135)) * (v135 * v135));
          v151.push((weight * v150));
        }
        v151 = (math.fsum(v151) * v125);
        v152 = v151;
      } else {
        v152 = 0.0;
      }
      v156 = (v20 * (v90 + v152));
    } else {
      v156 = (v33 - v49);
    }
    return (mu * v156);
  }
  return _tangential_force_of_capped_paraboloid(a, c, R1, R2, b, E_star, mu);
};

const tangential_force = (a, c, R1, R2, b, E_star, mu) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_force(a, c, R1, R2, b, E_star, mu) : NaN);
};

const _traction_of_capped_paraboloid = (r, a, c, R1, R2, b, E_star, mu) => {
  let beyond, close, gain, sliding, stuck, tip;
  sliding = _pressure_of_capped_paraboloid(r, a, R1, R2, b, E_star);
  stuck = _pressure_of_capped_paraboloid(r, c, R1, R2, b, E_star);
  close = ((r < c) & (stuck >= (CLOSE * sliding)));
  tip = growth(_slope, [R1], 0, r, c, math.minimum(a, b), close);
  beyond = growth_beyond(_slope_beyond, [R1, R2, b], 0, r, c, a, b, close);
  gain = ((E_star / Math.PI) * (tip + beyond));
  return (mu * math.where(close, gain, (sliding - stuck)));
};

const _traction = (r, a, c, R1, R2, b, E_star, mu) => {
  let node, v10, v100, v108, v112, v113, v118, v120, v124, v126, v128, v138, v141, v150, v151, v152, v158, v159, v160, v164, v165, v169, v170, v174, v18, v184, v185, v186, v191, v195, v196, v197, v198, v199, v203, v204, v208, v209, v212, v216, v22, v223, v225, v229, v230, v235, v238, v249, v25, v250, v251, v255, v26, v29, v33, v34, v39, v44, v46, v47, v48, v53, v55, v56, v58, v68, v69, v72, v75, v77, v78, v8, v82, v87, v88, v89, v9, v92, v94, v97, v99, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (R1 > 1e-30) && (R1 < 1e+30) && (R2 > 1e-30) && (R2 < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v8 = (((a < b) || (a !== a)) ? a : b);
    v9 = (v8 - r);
    v10 = (v8 + r);
    v18 = ((2.0 * E_star) / (3.141592653589793 * R1));
    v22 = (r === b);
    v25 = (v22 ? math.nextafter(b, Infinity) : r);
    v26 = (v25 < b);
    v29 = (a - b);
    v33 = Math.sqrt(((((v29 > 0.0) || (v29 !== v29)) ? v29 : 0.0) * (a + b)));
    v44 = Math.sqrt((Math.abs((v25 - b)) * (v25 + b)));
    v47 = (2.0 * (v26 ? 0.0 : 1.0));
    v48 = (1.0 - v47);
    v56 = (((v25 > b) || (v25 !== v25)) ? v25 : b);
    v69 = (b * b);
    v75 = (R1 - R2);
    v77 = (R1 * R2);
    v78 = ((2.0 * v75) / v77);
    v82 = ((b * b) * v75);
    v92 = (R1 > R2);
    v94 = (E_star / 3.141592653589793);
    if ((r < a)) {
      if (((v22 && (a > b)) && v92)) {
        v97 = Infinity;
      } else {
        if ((a > v56)) {
          if (v26) {
            v39 = v33;
          } else {
            v34 = (a - v25);
            v39 = Math.sqrt(((((v34 > 0.0) || (v34 !== v34)) ? v34 : 0.0) * (a + v25)));
          }
          v46 = Math.asinh((v39 / v44));
          v53 = (v47 - (v48 * Math.expm1(((-2.0) * v46))));
          v55 = ((v53 > 0.0) ? v53 : Infinity);
          v88 = [];
          for ([node, weight] of RULE_0_3((v46 / 1.0))) {
            v58 = (node * v46);
            v68 = (v33 * ((Math.exp((-v58)) * (v47 - (v48 * Math.expm1(((-2.0) * (v46 - v58)))))) / v55));
            v72 = Math.sqrt((v69 + (v68 * v68)));
            v87 = ((((((2.0 * v72) / R1) + (v78 * v68)) + (v82 / (v77 * v68))) * v68) / v72);
            v88.push((weight * v87));
          }
          v88 = (math.fsum(v88) * v46);
          v89 = v88;
        } else {
          v89 = 0.0;
        }
        v97 = (((r < v8) ? (v18 * Math.sqrt((v9 * v10))) : 0.0) + (v94 * v89));
      }
      v99 = v97;
    } else {
      v99 = 0.0;
    }
    v159 = (r < c);
    if (v159) {
      if (((v22 && (c > b)) && v92)) {
        v158 = Infinity;
      } else {
        v100 = (((c < b) || (c !== c)) ? c : b);
        if ((c > v56)) {
          v108 = (c - b);
          v112 = Math.sqrt(((((v108 > 0.0) || (v108 !== v108)) ? v108 : 0.0) * (c + b)));
          if (v26) {
            v118 = v112;
          } else {
            v113 = (c - v25);
            v118 = Math.sqrt(((((v113 > 0.0) || (v113 !== v113)) ? v113 : 0.0) * (c + v25)));
          }
          v120 = Math.asinh((v118 / v44));
          v124 = (v47 - (v48 * Math.expm1(((-2.0) * v120))));
          v126 = ((v124 > 0.0) ? v124 : Infinity);
          v151 = [];
          for ([node, weight] of RULE_0_3((v120 / 1.0))) {
            v128 = (node * v120);
            v138 = (v112 * ((Math.exp((-v128)) * (v47 - (v48 * Math.expm1(((-2.0) * (v120 - v128)))))) / v126));
            v141 = Math.sqrt((v69 + (v138 * v138)));
            v150 = ((((((2.0 * v141) / R1) + (v78 * v138)) + (v82 / (v77 * v138))) * v138) / v141);
            v151.push((weight * v150));
          }
          v151 = (math.fsum(v151) * v120);
          v152 = v151;
        } else {
          v152 = 0.0;
        }
        v158 = (((r < v100) ? (v18 * Math.sqrt(((v100 - r) * (v100 + r)))) : 0.0) + (v94 * v152));
      }
      v160 = v158;
    } else {
      v160 = 0.0;
    }
    v164 = (v159 && (v160 >= (0.25 * v99)));
    if (v164) {
      v174 = (v8 > c);
      v184 = (v164 && v174);
      if (v184) {
        v165 = (c - r);
        v169 = Math.sqrt(((((v165 > 0.0) || (v165 !== v165)) ? v165 : 0.0) * (c + r)));
        if (v184) {
          v170 = (v8 - c);
          v185 = Math.log1p(((v170 + (v174 ? ((v170 * (v8 + c)) / (Math.sqrt(((((v9 > 0.0) || (v9 !== v9)) ? v9 : 0.0) * v10)) + v169)) : 0.0)) / (c + v169)));
        } else {
          v185 = 0.0;
        }
        v196 = [];
        for ([node, weight] of RULE_0_3((v185 / 1.0))) {
          v186 = (node * v185);
          v191 = ((c * Math.cosh(v186)) + (v169 * Math.sinh(v186)));
          v195 = (((2.0 * v191) / R1) * Math.pow(v191, 0.0));
          v196.push((weight * v195));
        }
        v196 = (math.fsum(v196) * v185);
        v197 = v196;
      } else {
        v197 = 0.0;
      }
      v198 = (((b > c) || (b !== b)) ? b : c);
      v209 = (a > v198);
      v225 = (v164 && v209);
      if (v225) {
        v199 = (v198 - b);
        v203 = Math.sqrt(((((v199 > 0.0) || (v199 !== v199)) ? v199 : 0.0) * (v198 + b)));
        v204 = (v198 - r);
        v208 = Math.sqrt(((((v204 > 0.0) || (v204 !== v204)) ? v204 : 0.0) * (v198 + r)));
        if (v225) {
          v212 = ((a - v198) * (a + v198));
          if (v209) {
            v216 = (a - r);
            v223 = (v212 / (Math.sqrt(((((v216 > 0.0) || (v216 !== v216)) ? v216 : 0.0) * (a + r))) + v208));
          } else {
            v223 = 0.0;
          }
          v229 = Math.log1p((((v209 ? (v212 / (v33 + v203)) : 0.0) + v223) / (v203 + v208)));
        } else {
          v229 = 0.0;
        }
        v250 = [];
        for ([node, weight] of RULE_0_3((v229 / 1.0))) {
          v230 = (node * v229);
          v235 = ((v203 * Math.cosh(v230)) + (v208 * Math.sinh(v230)));
          v238 = Math.sqrt((v69 + (v235 * v235)));
          v249 = ((((((2.0 * v238) / R1) + (v78 * v235)) + (v82 / (v77 * v235))) * (v235 / v238)) * Math.pow(v238, 0.0));
          v250.push((weight * v249));
        }
        v250 = (math.fsum(v250) * v229);
        v251 = v250;
      } else {
        v251 = 0.0;
      }
      v255 = (v94 * (v197 + v251));
    } else {
      v255 = (v99 - v160);
    }
    return (mu * v255);
  }
  return _traction_of_capped_paraboloid(r, a, c, R1, R2, b, E_star, mu);
};

const traction = (r, a, c, R1, R2, b, E_star, mu) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction(r, a, c, R1, R2, b, E_star, mu) : 0.0) : NaN);
};

const _tangential_displacement_of_capped_paraboloid = (a, c, R1, R2, b, E_star, G_star, mu) => {
  let beyond, close, gain, sticking, tip, whole;
  [whole, sticking] = [_depth_of_capped_paraboloid(a, R1, R2, b), _depth_of_capped_paraboloid(c, R1, R2, b)];
  close = (sticking >= (CLOSE * whole));
  tip = growth(_slope, [R1], 1, 0.0, c, math.minimum(a, b), close);
  beyond = growth_beyond(_slope_beyond, [R1, R2, b], 1, 0.0, c, a, b, close);
  gain = (tip + beyond);
  return ((mu * (E_star / G_star)) * math.where(close, gain, (whole - sticking)));
};

const _tangential_displacement = (a, c, R1, R2, b, E_star, G_star, mu) => {
  let node, v104, v106, v11, v110, v111, v116, v117, v12, v120, v124, v125, v129, v136, v137, v138, v143, v15, v16, v22, v34, v37, v38, v40, v44, v45, v46, v51, v56, v61, v62, v64, v69, v73, v74, v75, v76, v77, v81, v82, v86, v90, v93, v97, weight;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (R1 > 1e-30) && (R1 < 1e+30) && (R2 > 1e-30) && (R2 < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v11 = (a - b);
    v12 = (a + b);
    v15 = (R1 - R2);
    v16 = (v15 / R2);
    v22 = ((a < b) ? ((a * a) / R1) : ((a * (a + (v16 * Math.sqrt((v11 * v12))))) / R1));
    v34 = ((c < b) ? ((c * c) / R1) : ((c * (c + (v16 * Math.sqrt(((c - b) * (c + b)))))) / R1));
    v37 = (v34 >= (0.25 * v22));
    if (v37) {
      v38 = (((a < b) || (a !== a)) ? a : b);
      v51 = (v38 > c);
      v61 = (v37 && v51);
      if (v61) {
        v40 = (c - 0.0);
        v44 = Math.sqrt(((((v40 > 0.0) || (v40 !== v40)) ? v40 : 0.0) * (c + 0.0)));
        if (v61) {
          v45 = (v38 - c);
          if (v51) {
            v46 = (v38 - 0.0);
            v56 = ((v45 * (v38 + c)) / (Math.sqrt(((((v46 > 0.0) || (v46 !== v46)) ? v46 : 0.0) * (v38 + 0.0))) + v44));
          } else {
            v56 = 0.0;
          }
          v62 = Math.log1p(((v45 + v56) / (c + v44)));
        } else {
          v62 = 0.0;
        }
        v74 = [];
        for ([node, weight] of RULE_0_3((v62 / 1.0))) {
          v64 = (node * v62);
          v69 = ((c * Math.cosh(v64)) + (v44 * Math.sinh(v64)));
          v73 = (((2.0 * v69) / R1) * Math.pow(v69, 1.0));
          v74.push((weight * v73));
        }
        v74 = (math.fsum(v74) * v62);
        v75 = v74;
      } else {
        v75 = 0.0;
      }
      v76 = (((b > c) || (b !== b)) ? b : c);
      v90 = (a > v76);
      v106 = (v37 && v90);
      if (v106) {
        v77 = (v76 - b);
        v81 = Math.sqrt(((((v77 > 0.0) || (v77 !== v77)) ? v77 : 0.0) * (v76 + b)));
        v82 = (v76 - 0.0);
        v86 = Math.sqrt(((((v82 > 0.0) || (v82 !== v82)) ? v82 : 0.0) * (v76 + 0.0)));
        if (v106) {
          v93 = ((a - v76) * (a + v76));
          if (v90) {
            v97 = (a - 0.0);
            v104 = (v93 / (Math.sqrt(((((v97 > 0.0) || (v97 !== v97)) ? v97 : 0.0) * (a + 0.0))) + v86));
          } else {
            v104 = 0.0;
          }
          v110 = Math.log1p((((v90 ? (v93 / (Math.sqrt(((((v11 > 0.0) || (v11 !== v11)) ? v11 : 0.0) * v12)) + v81)) : 0.0) + v104) / (v81 + v86)));
        } else {
          v110 = 0.0;
        }
        v117 = (b * b);
        v124 = (R1 * R2);
        v125 = ((2.0 * v15) / v124);
        v129 = ((b * b) * v15);
        v137 = [];
        for ([node, weight] of RULE_0_3((v110 / 1.0))) {
          v111 = (node * v110);
          v116 = ((v81 * Math.cosh(v111)) + (v86 * Math.sinh(v111)));
          v120 = Math.sqrt((v117 + (v116 * v116)));
          v136 = ((((((2.0 * v120) / R1) + (v125 * v116)) + (v129 / (v124 * v116))) * (v116 / v120)) * Math.pow(v120, 1.0));
          v137.push((weight * v136));
        }
        v137 = (math.fsum(v137) * v110);
        v138 = v137;
      } else {
        v138 = 0.0;
      }
      v143 = (v75 + v138);
    } else {
      v143 = (v22 - v34);
    }
    return ((mu * (E_star / G_star)) * v143);
  }
  return _tangential_displacement_of_capped_paraboloid(a, c, R1, R2, b, E_star, G_star, mu);
};

const tangential_displacement = (a, c, R1, R2, b, E_star, G_star, mu) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement(a, c, R1, R2, b, E_star, G_star, mu) : NaN);
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
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius(F_x, a, R1, R2, b, E_star, mu) : NaN);
};

const _full_slip_displacement_of_capped_paraboloid = (a, R1, R2, b, E_star, G_star, mu) => {
  return ((mu * (E_star / G_star)) * _depth_of_capped_paraboloid(a, R1, R2, b));
};

const _full_slip_displacement = (a, R1, R2, b, E_star, G_star, mu) => {
  if (((a > 1e-30) && (a < 1e+30) && (R1 > 1e-30) && (R1 < 1e+30) && (R2 > 1e-30) && (R2 < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    return ((mu * (E_star / G_star)) * ((a < b) ? ((a * a) / R1) : ((a * (a + (((R1 - R2) / R2) * Math.sqrt(((a - b) * (a + b)))))) / R1)));
  }
  return _full_slip_displacement_of_capped_paraboloid(a, R1, R2, b, E_star, G_star, mu);
};

const full_slip_displacement = (a, R1, R2, b, E_star, G_star, mu) => {
  if ((!((0.0 < R1 && R1 < Infinity) && (0.0 < R2 && R2 < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity) && (R2 <= R1)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement(a, R1, R2, b, E_star, G_star, mu) : NaN);
};

const formulas = {
  "d": (v) => depth(v.a, v.R1, v.R2, v.b),
  "F": (v) => force(v.a, v.R1, v.R2, v.b, v.E_star),
  "p": (v) => pressure(v.r, v.a, v.R1, v.R2, v.b, v.E_star),
  "w": (v) => displacement(v.r, v.a, v.R1, v.R2, v.b),
  "k": (v) => stiffness(v.a, v.R1, v.R2, v.b, v.E_star),
  "pm": (v) => mean_pressure(v.a, v.R1, v.R2, v.b, v.E_star),
  "U": (v) => energy(v.a, v.R1, v.R2, v.b, v.E_star),
  "Fr": (v) => load_within(v.r, v.a, v.R1, v.R2, v.b, v.E_star),
  "ad": (v) => radius_from_depth(v.d, v.R1, v.R2, v.b),
  "aF": (v) => radius_from_force(v.F, v.R1, v.R2, v.b, v.E_star),
  "Fd": (v) => force_from_depth(v.d, v.R1, v.R2, v.b, v.E_star),
  "dF": (v) => depth_from_force(v.F, v.R1, v.R2, v.b, v.E_star),
  "adh.Dl": (v) => retraction(v.a, v.E_star, v.dgamma),
  "adh.d": (v) => depth_of_capped_paraboloid(v.a, v.R1, v.R2, v.b, v.E_star, v.dgamma),
  "adh.F": (v) => force_of_capped_paraboloid(v.a, v.R1, v.R2, v.b, v.E_star, v.dgamma),
  "adh.p": (v) => pressure_of_capped_paraboloid(v.r, v.a, v.R1, v.R2, v.b, v.E_star, v.dgamma),
  "adh.w": (v) => displacement_of_capped_paraboloid(v.r, v.a, v.R1, v.R2, v.b, v.E_star, v.dgamma),
  "tan.F": (v) => tangential_force(v.a, v.c, v.R1, v.R2, v.b, v.E_star, v.mu),
  "tan.tau": (v) => traction(v.r, v.a, v.c, v.R1, v.R2, v.b, v.E_star, v.mu),
  "tan.u": (v) => tangential_displacement(v.a, v.c, v.R1, v.R2, v.b, v.E_star, v.G_star, v.mu),
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
  "p": {
   "gives": "p",
   "needs": [
    "r",
    "a",
    "R1",
    "R2",
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
    "R1",
    "R2",
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
    "R1",
    "R2",
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
    "R1",
    "R2",
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
    "R1",
    "R2",
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
    "R1",
    "R2",
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
  "adh.p": {
   "gives": "p",
   "needs": [
    "r",
    "a",
    "R1",
    "R2",
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
    "R1",
    "R2",
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
    "R1",
    "R2",
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
    "R1",
    "R2",
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
