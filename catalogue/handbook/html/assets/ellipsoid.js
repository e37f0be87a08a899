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

const HALVES = {8: [[0.019855071751231884, 0.05061426814518813], [0.10166676129318664, 0.11119051722668724], [0.2372337950418355, 0.15685332293894363], [0.4082826787521751, 0.181341891689181]], 16: [[0.005299532504175033, 0.013576229705877048], [0.02771248846338371, 0.031126761969323947], [0.06718439880608412, 0.04757925584124639], [0.12229779582249849, 0.06231448562776694], [0.19106187779867811, 0.07479799440828837], [0.2709916111713863, 0.08457825969750127], [0.35919822461037054, 0.09130170752246179], [0.4524937450811813, 0.09472530522753425]], 24: [[0.00240639000148932, 0.0061706148999936], [0.012635722014345251, 0.014265694314466832], [0.030862723998633622, 0.022138719408709904], [0.056792236497799485, 0.02964929245771839], [0.08999900701304854, 0.03667324070554015], [0.12993790421072282, 0.04309508076597664], [0.17595317403151223, 0.04880932605205694], [0.22728926430558022, 0.05372213505798282], [0.2831032461869774, 0.0577528340268628], [0.3424786601519183, 0.060835236463901696], [0.40444056626319186, 0.06291872817341415], [0.4679715535686972, 0.06396909767337608]], 32: [[0.0013680690752592183, 0.003509305004735048], [0.007194244227365833, 0.008137197365452835], [0.017618872206246784, 0.01269603265463103], [0.03254696203113015, 0.017136931456510716], [0.05183942211697394, 0.02141794901111334], [0.07531619313371501, 0.025499029631188087], [0.1027581020160288, 0.029342046739267772], [0.13390894062985517, 0.032911111388180925], [0.1684778665348924, 0.03617289705442425], [0.20614212137961885, 0.039096947893535156], [0.2465500455338853, 0.041655962113473374], [0.2893243619346823, 0.043826046502201906], [0.33406569885893617, 0.045586939347881945], [0.38035631887393145, 0.04692219954040228], [0.42776401920860174, 0.04781936003963743], [0.4758461671561308, 0.0482700442573639]], 64: [[0.0003474791321139303, 0.0008916403608482165], [0.0018299416140223604, 0.002073516630281234], [0.00449331426162784, 0.0032522289844891814], [0.008331873057687022, 0.0044233799131819735], [0.013336586105044517, 0.005584069730065564], [0.01949560017397314, 0.006731523948359321], [0.026794312570798593, 0.007863015238012359], [0.035215413934030215, 0.008975857887848672], [0.044738931460748595, 0.010067411576765104], [0.055342277002442944, 0.011135086904191627], [0.06700030092295359, 0.012176351284355437], [0.07968535187370981, 0.01318873485752733], [0.09336734243860122, 0.014169836307129742], [0.1080138205283293, 0.015117328536201239], [0.12359004636973406, 0.016028964177425775], [0.1400590749141946, 0.016902580918570803], [0.15738184347288336, 0.017736106628441193], [0.17551726437267132, 0.018527564270120023], [0.19442232241380336, 0.019275076589307813], [0.21405217689868297, 0.01997687056636017], [0.23436026799005272, 0.020631281621311764], [0.2552984271464735, 0.021236757561826795], [0.27681699137326793, 0.021791862264661725], [0.2988649210180042, 0.022295279081878283], [0.32138992083116596, 0.02274581396370907], [0.34433856400489454, 0.023142398290657208], [0.3676564188956163, 0.02348409140810501], [0.39128817812999644, 0.023770082857415154], [0.41517778978800357, 0.023999694298229155], [0.4392685903519397, 0.024172381117401477], [0.4635034391061005, 0.024287733720751714], [0.48782485366828776, 0.024345478504569862]], 128: [[8.755602643404277e-05, 0.00022469048014604518], [0.0004612700113120525, 0.0005229063396701744], [0.00113337568724299, 0.0008212515093345147], [0.0021036207325094065, 0.0011191442154813093], [0.003371443549893532, 0.0014163757357289956], [0.004936090754132808, 0.0017127630204551078], [0.006796628637706896, 0.002008127491869321], [0.008951945782140732, 0.0023022921283514775], [0.011400754268046306, 0.002595080916338165], [0.01414159062643171, 0.002886318771432849], [0.017172816784017365, 0.0031758315808535944], [0.020492621073150037, 0.003463446283449407], [0.024099019329367807, 0.0037489909628173643], [0.027989856084889908, 0.004032294945243029], [0.03216280586104181, 0.004313188899308375], [0.036615374560526076, 0.004591504935830437], [0.04134490095951973, 0.004867076707503403], [0.046348558299121594, 0.005139739507916079], [0.051623355975420906, 0.005409330369751538], [0.05716614132730139, 0.005675688162040208], [0.06297360152098411, 0.00593865368637014], [0.06904226553022577, 0.0061980697719754615], [0.07536850621101551, 0.006453781369633674], [0.08194854246954658, 0.0067056356443081664], [0.08877844152217808, 0.006953482066475993], [0.09585412124604317, 0.007197172502083423], [0.10317135261890335, 0.007436561301073657], [0.11072576224679402, 0.007671505384432572], [0.11851283497795263, 0.007901864329699674], [0.126527916601469, 0.008127500454892593], [0.1347662166290456, 0.008348278900794603], [0.1432228111582063, 0.00856406771155569], [0.15189264581524284, 0.008774737913558853], [0.16077053877614036, 0.008980163592504344], [0.16985118386367698, 0.00918022196866567], [0.17912915371884622, 0.009374793470272355], [0.18859890304470756, 0.009563761804975472], [0.1982547719207257, 0.009747014029353301], [0.20809098918561847, 0.00992444061641543], [0.21810167588669097, 0.010095935521065021], [0.2282808487935948, 0.010261396243480035], [0.23862242397441227, 0.010420723890375575], [0.24912022043192777, 0.010573823234110675], [0.259767963797914, 0.01072060276960423], [0.2705592900832239, 0.010860974769026038], [0.2814877494814479, 0.010994855334230245], [0.2925468102238625, 0.011122164446899882], [0.30372986248336625, 0.011242826016372484], [0.3150302223250705, 0.01135676792511823], [0.3264411357011823, 0.011463922071843423], [0.3379557824877933, 0.011564224412193513], [0.3495672805611614, 0.01165761499703138], [0.3612686899110478, 0.011744038008267956], [0.3730530167886528, 0.011823441792223808], [0.38491321788667, 0.011895778890501701], [0.3968422045489604, 0.011961006068351729], [0.4088328470073314, 0.012019084340512026], [0.4208779786428875, 0.012069978994509643], [0.4329704002694061, 0.012113659611407625], [0.4451028844361781, 0.012150100083985933], [0.45726817974774225, 0.012179278632345313], [0.4694590151979302, 0.01220117781692479], [0.48166810451563324, 0.012215784548925022], [0.4938881505196921, 0.012223090098131259]]};

const _depth = (a, h, b) => {
  return (((h / b) * a) * (math.log1p(((2.0 * a) / (b - a))) / 2.0));
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
  return (math.truth(beyond) ? pressure_integral_tanh(_arc_rate, [], r, a, R) : near);
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

const _depth_of_ellipsoid = (a, h, b) => {
  let angle;
  angle = (Math.log1p(((2 * a) / (b - a))) / 2);
  return (((h / b) * a) * angle);
};

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
        v80 = (math.truth(v35) ? Infinity : 0.0);
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

const _angle = (a, R) => {
  let root;
  root = difference_root(R, a);
  return [math.minimum(Math.asinh((a / root)), 40.0), root];
};

const ARC_PEAK = 1.7179204967675554;

const ARC_END = 0.8;

const ARC_BEND = 0.03812728612374059;

const ARC_FAR = [[1.329889984051219, 85.36998480516608, 1923.074008763512, 17876.90896541072, 59207.63481260677, 18485.08434122529, (-53195.64116483364)], [1.0, 67.52528901476805, 1640.3784958292124, 17299.016817433552, 74691.14995817501, 93084.84736709161, (-9809.489595170257)]];

const ARC_NEAR = [[2.0, 9.5189968828819, 16.571545092002584, 13.482272517053174, 6.125980425599675, 2.1371993915944367, 0.5444629040821292, 0.09990750072362801, 0.017942334397165086], [1.0, 5.3845732038762915, 10.870096444963094, 10.425327577706595, 5.320959603282673, 1.837793059410041, 0.505498100763311, 0.08953714875930008, 0.018009433732159942]];

const _lower_angle = (y) => {
  let beyond, near, short;
  beyond = math.maximum((y - ARC_PEAK), 0.0);
  near = math.minimum(beyond, ARC_END);
  short = math.maximum((ARC_BEND - (((y * Math.tanh(y)) - 1.0) / Math.pow(Math.cosh(y), 2))), 0.0);
  return math.where((beyond > ARC_END), rational(short, ...ARC_FAR), (y - (near * rational(near, ...ARC_NEAR))));
};

const arc_peak_radius = (a, R) => {
  let root, share, y;
  [y, root] = _angle(a, R);
  share = ((Math.sinh(_lower_angle(y)) * root) / a);
  return math.where((y > ARC_PEAK), (a * Math.sqrt(((1.0 - share) * (1.0 + share)))), 0.0);
};

const END_of_arcs = 0.7;

const _arc_rate_of_arcs = (t, root) => {
  return Math.asinh((t / root));
};

const arc_strips_of_arcs = (r, a, R) => {
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
  beyond = (high > END_of_arcs);
  if ((!Boolean(beyond))) {
    return near;
  }
  return math.where(beyond, pressure_integral_tanh(_arc_rate_of_arcs, [], r, a, R), near);
};

const arc_peak_pressure = (a, R) => {
  let root, strips, v, y;
  [y, root] = _angle(a, R);
  v = _lower_angle(y);
  strips = arc_strips_of_arcs(arc_peak_radius(a, R), a, R);
  return (((R * v) / (root * Math.cosh(v))) + math.where(((a > 0.0) & (a < R)), strips, 0.0));
};

const _peak_pressure_of_ellipsoid = (a, h, b, E_star) => {
  return math.where((a <= b), (((E_star * h) / (Math.PI * b)) * arc_peak_pressure(a, b)), NaN);
};

const _peak_pressure = (a, h, b, E_star) => {
  let v125, v128, v135, v136, v14, v140, v141, v146, v147, v148, v151, v152, v153, v159, v16, v164, v169, v174, v179, v18, v184, v189, v194, v199, v20, v204, v209, v21, v214, v215, v219, v224, v229, v23, v234, v239, v260, v28, v33, v34, v9;
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v9 = (b - a);
    v14 = Math.sqrt(((((v9 > 0.0) || (v9 !== v9)) ? v9 : 0.0) * (b + a)));
    v16 = Math.asinh((a / v14));
    v18 = (((v16 < 40.0) || (v16 !== v16)) ? v16 : 40.0);
    v20 = (v18 - 1.7179204967675554);
    v21 = (((v20 > 0.0) || (v20 !== v20)) ? v20 : 0.0);
    if ((v21 > 0.8)) {
      v28 = Math.cosh(v18);
      v33 = (0.03812728612374059 - (((v18 * Math.tanh(v18)) - 1.0) / (v28 * v28)));
      v34 = (((v33 > 0.0) || (v33 !== v33)) ? v33 : 0.0);
      v125 = ((((((((((((((-53195.64116483364) * v34) + 18485.08434122529) * v34) + 59207.63481260677) * v34) + 17876.90896541072) * v34) + 1923.074008763512) * v34) + 85.36998480516608) * v34) + 1.329889984051219) / (((((((((((((-9809.489595170257) * v34) + 93084.84736709161) * v34) + 74691.14995817501) * v34) + 17299.016817433552) * v34) + 1640.3784958292124) * v34) + 67.52528901476805) * v34) + 1.0));
    } else {
      v23 = (((v21 < 0.8) || (v21 !== v21)) ? v21 : 0.8);
      v125 = (v18 - (v23 * (((((((((((((((((0.017942334397165086 * v23) + 0.09990750072362801) * v23) + 0.5444629040821292) * v23) + 2.1371993915944367) * v23) + 6.125980425599675) * v23) + 13.482272517053174) * v23) + 16.571545092002584) * v23) + 9.5189968828819) * v23) + 2.0) / ((((((((((((((((0.018009433732159942 * v23) + 0.08953714875930008) * v23) + 0.505498100763311) * v23) + 1.837793059410041) * v23) + 5.320959603282673) * v23) + 10.425327577706595) * v23) + 10.870096444963094) * v23) + 5.3845732038762915) * v23) + 1.0))));
    }
    if ((v18 > 1.7179204967675554)) {
      v128 = ((Math.sinh(v125) * v14) / a);
      v135 = (a * Math.sqrt(((1.0 - v128) * (1.0 + v128))));
    } else {
      v135 = 0.0;
    }
    v136 = (a - v135);
    v140 = Math.sqrt(((((v136 > 0.0) || (v136 !== v136)) ? v136 : 0.0) * (a + v135)));
    v141 = (b - v135);
    v146 = (b + Math.sqrt(((((v141 > 0.0) || (v141 !== v141)) ? v141 : 0.0) * (b + v135))));
    v147 = (a + v140);
    v148 = (v147 / v146);
    if ((v148 > 0.7)) {
      return _peak_pressure_of_ellipsoid(a, h, b, E_star);
    }
    if ((a <= b)) {
      if (((a > 0.0) && (a < b))) {
        v151 = ((v135 * (v135 / v147)) / v146);
        v152 = (v148 * v148);
        v153 = (v151 * v151);
        v159 = ((0.13579013365982337 * v152) + (-0.4846453962188766));
        v164 = ((v159 * v152) + 0.8293825948837366);
        v169 = ((v164 * v152) + (-0.8745573865774817));
        v174 = ((v169 * v152) + 0.6371928816963097);
        v179 = ((v174 * v152) + (-0.3332798652335896));
        v184 = ((v179 * v152) + 0.13289328569967984);
        v189 = ((v184 * v152) + (-0.03710676078458442));
        v194 = ((v189 * v152) + 0.011089560042611895);
        v199 = ((v194 * v152) + 0.0012521687336059639);
        v204 = ((v199 * v152) + 0.0036572276005780893);
        v209 = ((v204 * v152) + 0.004425450516633092);
        v214 = ((v209 * v152) + 0.005918487051520244);
        v215 = (((((((((((((((((((((((((0.0 * v153) + 0.13579013365982337) * v153) + v159) * v153) + v164) * v153) + v169) * v153) + v174) * v153) + v179) * v153) + v184) * v153) + v189) * v153) + v194) * v153) + v199) * v153) + v204) * v153) + v209) * v153);
        v219 = ((v214 * v152) + 0.008264397984935742);
        v224 = ((v219 * v152) + 0.012345681107818056);
        v229 = ((v224 * v152) + 0.020408163224119494);
        v234 = ((v229 * v152) + 0.04000000000042643);
        v239 = ((v234 * v152) + 0.11111111111110937);
        v260 = (((2.0 * v140) / v146) * (((v239 * v152) + 1.0) + ((v151 * (v151 + v148)) * (((((((((((v215 + v214) * v153) + v219) * v153) + v224) * v153) + v229) * v153) + v234) * v153) + v239))));
      } else {
        v260 = 0.0;
      }
      return (((E_star * h) / (3.141592653589793 * b)) * (((b * v125) / (v14 * Math.cosh(v125))) + v260));
    }
    return NaN;
  }
  return _peak_pressure_of_ellipsoid(a, h, b, E_star);
};

const _peak_radius_of_ellipsoid = (a, b) => {
  return math.where((a <= b), arc_peak_radius(a, b), NaN);
};

const _peak_radius = (a, b, h = 1.0, E_star = 1.0) => {
  let v10, v119, v12, v122, v14, v15, v17, v22, v27, v28, v3, v8;
  if (((a > 1e-30) && (a < 1e+30) && (b > 1e-30) && (b < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((a <= b)) {
      v3 = (b - a);
      v8 = Math.sqrt(((((v3 > 0.0) || (v3 !== v3)) ? v3 : 0.0) * (b + a)));
      v10 = Math.asinh((a / v8));
      v12 = (((v10 < 40.0) || (v10 !== v10)) ? v10 : 40.0);
      if ((v12 > 1.7179204967675554)) {
        v14 = (v12 - 1.7179204967675554);
        v15 = (((v14 > 0.0) || (v14 !== v14)) ? v14 : 0.0);
        if ((v15 > 0.8)) {
          v22 = Math.cosh(v12);
          v27 = (0.03812728612374059 - (((v12 * Math.tanh(v12)) - 1.0) / (v22 * v22)));
          v28 = (((v27 > 0.0) || (v27 !== v27)) ? v27 : 0.0);
          v119 = ((((((((((((((-53195.64116483364) * v28) + 18485.08434122529) * v28) + 59207.63481260677) * v28) + 17876.90896541072) * v28) + 1923.074008763512) * v28) + 85.36998480516608) * v28) + 1.329889984051219) / (((((((((((((-9809.489595170257) * v28) + 93084.84736709161) * v28) + 74691.14995817501) * v28) + 17299.016817433552) * v28) + 1640.3784958292124) * v28) + 67.52528901476805) * v28) + 1.0));
        } else {
          v17 = (((v15 < 0.8) || (v15 !== v15)) ? v15 : 0.8);
          v119 = (v12 - (v17 * (((((((((((((((((0.017942334397165086 * v17) + 0.09990750072362801) * v17) + 0.5444629040821292) * v17) + 2.1371993915944367) * v17) + 6.125980425599675) * v17) + 13.482272517053174) * v17) + 16.571545092002584) * v17) + 9.5189968828819) * v17) + 2.0) / ((((((((((((((((0.018009433732159942 * v17) + 0.08953714875930008) * v17) + 0.505498100763311) * v17) + 1.837793059410041) * v17) + 5.320959603282673) * v17) + 10.425327577706595) * v17) + 10.870096444963094) * v17) + 5.3845732038762915) * v17) + 1.0))));
        }
        v122 = ((Math.sinh(v119) * v8) / a);
        return (a * Math.sqrt(((1.0 - v122) * (1.0 + v122))));
      }
      return 0.0;
    }
    return NaN;
  }
  return _peak_radius_of_ellipsoid(a, b);
};

const PeakPressure = (pressure, radius) => math.record({ pressure, radius });

const peak_pressure = (a, h, b, E_star) => {
  let pressure, radius;
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  pressure = ((a >= 0.0) ? _peak_pressure(a, h, b, E_star) : NaN);
  radius = ((a >= 0.0) ? _peak_radius(a, b) : NaN);
  return PeakPressure(pressure, radius);
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
    return math.log1p((math.truth(v6) ? v3 : 0.0));
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
  middle = (((math.truth(signs) ? low : from_) / 2.0) + ((math.truth(signs) ? high : to) / 2.0));
  if ((late >= 0)) {
    aimed = (math.truth(met) ? (position + step) : aimed);
  }
  within = (((low <= aimed) & (aimed <= high)) & ((late < 0) || ((late % 2) === 0)));
  return ((math.truth(within) ? aimed : middle) - position);
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
    position = (math.truth(left) ? (position + step) : position);
    t = (math.truth(left) ? Math.exp(position) : t);
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

const exponent_of = (x) => {
  return (math.frexp(x)[1] - 1);
};

const _rate = (a, h, b) => {
  let v3, v8;
  v3 = (b - a);
  v8 = math.sqrt(((((v3 > 0.0) || (v3 !== v3)) ? v3 : 0.0) * (b + a)));
  return (((h / b) * Math.asinh((a / v8))) + ((h * a) / (v8 * v8)));
};

const radii_below = (length = 1.0) => [1e-150, 1e-140, 1e-130, 1e-120, 1e-110, 1e-100, 1e-90, 1e-80, 1e-70, 1e-60, 1e-50, 1e-40, 1e-30, 1e-20, 1e-10, 0.5, 0.9375, 0.9921875, 0.9990234375, 0.9998779296875, 0.9999847412109375, 0.9999980926513672, 0.9999997615814209, 0.9999999701976776, 0.9999999962747097, 0.9999999995343387, 0.9999999999417923, 0.999999999992724, 0.9999999999990905, 0.9999999999998863, 0.9999999999999858, 0.9999999999999982, 0.9999999999999998, 1.0].map((x) => x * length);

const _samples = (h, b) => {
  let a;
  a = radii_below(b);
  return ({ radii: a, end: a.at(-1) });
};

const XI = {'force': 3.0, 'depth': 1.0};

const least_steepness = (control, E_star, dgamma) => {
  return (XI[control] * Math.sqrt(((Math.PI * dgamma) / (2.0 * E_star))));
};

const STEPS = 20;

const CLOSEST = Math.pow(2.0, (-51));

const _change = (above, low, high, before, after, sign) => {
  let middle, share, stays, step, tried, value;
  [before, after, stays] = [(sign * before), (sign * after), 0.0];
  for (step of math.range((STEPS + 64))) {
    if ((math.nextafter(low, high) >= high)) {
      break;
    }
    share = (((step < STEPS) && (before !== after)) ? (before / (before - after)) : NaN);
    tried = (low * Math.exp((((0.0 <= share && share <= 1.0) ? share : 0.5) * Math.log((high / low)))));
    tried = Math.min(Math.max(tried, (low * (1.0 + (CLOSEST * Math.pow(2.0, step))))), (high * (1.0 - (CLOSEST * Math.pow(2.0, step)))));
    middle = (((step < STEPS) && (low < tried && tried < high)) ? tried : math.halfway(low, high));
    value = (sign * above(middle));
    if ((value >= 0.0)) {
      [before, after] = [((stays > 0.0) ? (0.5 * before) : before), value];
      [high, stays] = [middle, 1.0];
    } else {
      [before, after] = [value, ((stays < 0.0) ? (0.5 * after) : after)];
      [low, stays] = [middle, (-1.0)];
    }
  }
  return high;
};

const FAR = 1e+50;

const branches = math.branches(_change, FAR);

const _branches = (h, b, E_star, dgamma, control) => {
  return branches(((a) => (Math.sqrt(a) * _rate(a, h, b))), _samples(h, b), least_steepness(control, E_star, dgamma));
};

const XI_of_stable = {'force': 3.0, 'depth': 1.0};

const growth = (slope, a, control, E_star, dgamma) => {
  let own;
  own = (slope - ((XI_of_stable[control] * hess_retraction(a, E_star, dgamma)) / (2.0 * a)));
  return ((control === 'force') ? (((2.0 * E_star) * a) * own) : own);
};

const CLOSEST_of_unknowns = 18.3;

const Unknown = (of, back, end = Infinity, order = 2.0, unit = 0.0) => math.record({ of, back, end, order, unit });

const up_to = (R, k = 0.0) => {
  let back, like, of;
  k = ((Math.abs(k) < 1e-30) ? 1e-30 : k);
  like = (v) => {
    return ((-Math.expm1(((-k) * v))) / k);
  };
  of = (a) => {
    return like(math.minimum(Math.atanh(math.minimum((a / R), 1.0)), CLOSEST_of_unknowns));
  };
  back = (x) => {
    let v;
    v = ((-Math.log1p(((-k) * x))) / k);
    return [(R * Math.tanh(v)), ((R * Math.exp((k * v))) / Math.pow(Math.cosh(v), 2))];
  };
  return Unknown(of, back, like(CLOSEST_of_unknowns), 3.0, 0.5);
};

const at_the_end = (load, a) => {
  return load(a);
};

const NOISE = 4.440892098500626e-16;

const _branch_of = (value, found, load, pulled) => {
  let first, fits, high, largest, last, least, low, start, top;
  low = high = least = largest = math.full(value, NaN);
  for ([first, last] of math.zip(found.first, found.last)) {
    start = load(first);
    top = (Number.isFinite(last) ? at_the_end(load, last) : Infinity);
    top = (Number.isNaN(top) ? Infinity : top);
    fits = ((value >= (start - ((2.0 * NOISE) * (Math.abs(start) + pulled(first))))) & (value <= top));
    [low, high] = [(math.truth(fits) ? first : low), (math.truth(fits) ? last : high)];
    [least, largest] = [(math.truth(fits) ? start : least), (math.truth(fits) ? top : largest)];
  }
  return [low, high, least, largest];
};

const _divided = (value, low, high, least, top, load, corner) => {
  let above, below, bend, inside;
  bend = load((corner + math.zeros_like(low)));
  inside = ((low < corner) & math.logical_not((high <= corner)));
  above = (inside & (value > bend));
  below = (inside & math.logical_not(above));
  [high, top] = [(math.truth(below) ? corner : high), (math.truth(below) ? bend : top)];
  [low, least] = [(math.truth(above) ? corner : low), (math.truth(above) ? bend : least)];
  return [low, high, least, top, (low >= corner)];
};

const _counted = (low, high, beyond, inner, outer) => {
  let first, last, of, place, reach;
  of = (a) => {
    return ((outer == null) ? inner.of(a) : (math.truth(beyond) ? outer.of((math.truth(beyond) ? a : low)) : inner.of(a)));
  };
  first = of(low);
  last = ((high === Infinity) ? Infinity : of(((high === Infinity) ? low : high)));
  reach = (last - first);
  place = (t) => {
    let a, open_, own, own_rate, rate, share, step, x;
    open_ = math.logical_not(Number.isFinite(reach));
    share = (math.truth(open_) ? 0.0 : (t / reach));
    x = (first + ((share < Infinity) ? (t / (1.0 + share)) : reach));
    step = (1.0 / Math.pow((1.0 + share), 2));
    [a, rate] = inner.back(x);
    if ((outer != null)) {
      [own, own_rate] = outer.back((math.truth(beyond) ? x : 1.0));
      [a, rate] = [(math.truth(beyond) ? own : a), (math.truth(beyond) ? own_rate : rate)];
    }
    return [a, (rate * step)];
  };
  return [first, reach, ((Number.isFinite(reach) | beyond) ? Infinity : (inner.end - first)), place];
};

const EPS = 2.220446049250313e-16;

const LOST = 0.3;

const SLACK = 1e-06;

const stable_radius = (value, found, load, slope_of, pulled, inner, outer = null, corner = null) => {
  let a, beyond, ends, excess, far, first, fixed, high, largest, least, least_short, least_unit, low, noise, order, parts, place, ratio, reach, scale, share, short, slope, start, t, top, unit, wanted;
  [low, high, least, top] = _branch_of(value, found, load, pulled);
  if ((!Boolean(Number.isFinite(least)))) {
    return least;
  }
  beyond = math.full(low, ((corner == null) && (outer != null)));
  if ((corner != null)) {
    [low, high, least, top, beyond] = _divided(value, low, high, least, top, load, corner);
  }
  ends = Number.isFinite(top);
  if (((outer == null) && Boolean(ends))) {
    ends = (ends & (slope_of(high) < Infinity));
  }
  [first, reach, largest, place] = _counted(low, (math.truth(ends) ? high : Infinity), beyond, inner, outer);
  fixed = (Math.abs(least) + pulled(low));
  parts = (fixed + Math.abs(value));
  least_short = ((4.0 * NOISE) * parts);
  excess = (t) => {
    let a, known, lost, more, own, short, slope, step;
    [a, step] = place(t);
    own = load(a);
    [more, short] = [(own - least), (math.truth(ends) ? math.maximum((top - own), least_short) : 1.0)];
    known = (EPS * (fixed + Math.abs(own)));
    lost = (more <= known);
    more = (math.truth(lost) ? known : more);
    slope = (((t * step) * slope_of(a)) * ((1.0 / more) + (math.truth(ends) ? (1.0 / short) : 0.0)));
    more = (more / short);
    slope = ((math.logical_not(ends) & (more < (0.5 * wanted))) ? math.maximum(slope, 0.7) : slope);
    return [more, (math.truth(lost) ? LOST : slope)];
  };
  share = (t) => {
    let a, step;
    [a, step] = place(t);
    return ((t * step) / a);
  };
  short = (math.truth(ends) ? math.maximum((top - value), least_short) : 1.0);
  wanted = ((value < Infinity) ? (math.maximum((value - least), 0.0) / short) : 0.0);
  far = (ends & (wanted > 1.0));
  [order, least_unit] = [...['order', 'unit']].map((name) => ((outer == null) ? inner[name] : (math.truth(beyond) ? outer[name] : inner[name])));
  unit = (math.truth(far) ? reach : math.minimum(math.maximum(first, least_unit), largest));
  [scale, slope] = excess(unit);
  ratio = (wanted / scale);
  start = (unit * Math.pow(ratio, (1.0 / (((ratio > 1.0) & math.logical_not(far)) ? 4.0 : order))));
  start = ((ends & (slope === LOST)) ? reach : start);
  noise = ((NOISE * parts) * (math.truth(ends) ? ((1.0 + wanted) / short) : 1.0));
  t = inverse(excess, wanted, start, [SLACK, Infinity], largest, share, true, noise);
  a = place(t)[0];
  return (((value === Infinity) & (high === Infinity)) ? Infinity : (Number.isFinite(least) ? a : NaN));
};

const _radius_from_depth_of_ellipsoid = (d, h, b, E_star, dgamma) => {
  let found, radius, stress, unit;
  unit = exponent_of(b);
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  h = math.ldexp(h, (-unit));
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  d = math.ldexp(d, (-unit));
  found = _branches(h, b, E_star, dgamma, 'depth');
  radius = stable_radius(d, found, ((a) => _depth_2(a, h, b, E_star, dgamma)), ((a) => growth(_rate(a, h, b), a, 'depth', E_star, dgamma)), ((a) => hess_retraction(a, E_star, dgamma)), up_to(b));
  return math.ldexp(radius, unit);
};

const radius_from_depth_of_ellipsoid = (d, h, b, E_star, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_depth_of_ellipsoid(d, h, b, E_star, dgamma);
};

const pull = (a, E_star, dgamma) => {
  return (((2.0 * E_star) * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const _radius_from_force_of_ellipsoid = (F, h, b, E_star, dgamma) => {
  let found, radius, stress, unit;
  unit = exponent_of(b);
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  h = math.ldexp(h, (-unit));
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  F = math.ldexp(F, (-(stress + (2 * unit))));
  found = _branches(h, b, E_star, dgamma, 'force');
  radius = stable_radius(F, found, ((a) => _force_2(a, h, b, E_star, dgamma)), ((a) => growth(_rate(a, h, b), a, 'force', E_star, dgamma)), ((a) => pull(a, E_star, dgamma)), up_to(b));
  return math.ldexp(radius, unit);
};

const radius_from_force_of_ellipsoid = (F, h, b, E_star, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_force_of_ellipsoid(F, h, b, E_star, dgamma);
};

const _pull_off_radius = (h, b, E_star, dgamma, control) => {
  let found, load, radius, stress, unit;
  unit = exponent_of(b);
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  h = math.ldexp(h, (-unit));
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  found = _branches(h, b, E_star, dgamma, control);
  load = ((control === 'force') ? _force_2 : _depth_2);
  radius = math.lowest(found, ((a) => load(a, h, b, E_star, dgamma)));
  return math.ldexp(radius, unit);
};

const PullOff = (radius, force, depth) => math.record({ radius, force, depth });

const pull_off = (control = 'force', h, b, E_star, dgamma) => {
  let depth, force, radius;
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  radius = _pull_off_radius(h, b, E_star, dgamma, control);
  force = ((radius >= 0.0) ? _force_2(radius, h, b, E_star, dgamma) : NaN);
  depth = ((radius >= 0.0) ? _depth_2(radius, h, b, E_star, dgamma) : NaN);
  return PullOff(radius, force, depth);
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
  return [integrand, (math.truth(holds) ? (0.5 * Math.log1p(ratio)) : 0.0), 1.0, holds, 0.0];
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
          v149 = (0.5 * Math.log1p((((((2.0 * v111) * (math.truth(v131) ? (((a - c) * (a + c)) / (v125 + v116)) : 0.0)) / v129) * ((v111 + v125) / (v111 + v116))) / v129)));
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
  return (mu * (math.truth(close) ? gain : (sliding - stuck)));
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
          v69 = (0.5 * Math.log1p((((((2.0 * v31) * (math.truth(v51) ? (((a - c) * (a + c)) / (v45 + v36)) : 0.0)) / v49) * ((v31 + v45) / (v31 + v36))) / v49)));
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

const _steepness = (a, root, v, k) => {
  if ((k > 0.0)) {
    return (v / Math.sinh(v));
  }
  return ((root / a) * v);
};

const sinh_over = (v) => {
  let v2;
  v2 = (v > 0.0);
  if (v2) {
    return (Math.sinh(v) / (math.truth(v2) ? v : 1.0));
  }
  return 1.0;
};

const STRIPS_of_rules = [[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]];

const NODES = 64;

const nodes_for = (length) => {
  let count, longest, reached;
  longest = Number(math.maximum(length));
  for ([reached, count] of STRIPS_of_rules.slice(0, 2)) {
    if ((longest <= reached)) {
      return (2 * count);
    }
  }
  return NODES;
};

const weighted = (smooth, stop, power, count = NODES, above = null) => {
  let end, pairs;
  if ((power >= (-0.25))) {
    return math.fsum([...math.products(power, count, false)].map(([node, weight]) => (weight * smooth((node * stop)))));
  }
  above = ((above == null) ? (1.0 + power) : above);
  end = smooth(0.0);
  pairs = math.products(above, count, true);
  return ((end / above) + math.fsum([...pairs].map(([node, weight]) => (weight * (smooth((node * stop)) - end)))));
};

const _last = (k) => {
  if ((k > 0.0)) {
    return (1.0 / k);
  }
  return Infinity;
};

const sphere_depth = (a, root, k) => {
  let open_, v, value;
  open_ = ((root > 0.0) ? root : a);
  v = Math.asinh((a / open_));
  value = (((a * Math.pow(_steepness(a, open_, v, k), k)) * v) * weighted(((x) => Math.pow(sinh_over(x), k)), v, k, nodes_for(v)));
  return ((a === 0.0) ? 0.0 : ((root > 0.0) ? value : (a * _last(k))));
};

const _depth_at_2 = (a, root, h, b, k) => {
  return ((h * sphere_depth(a, root, k)) / b);
};

const _depth_3 = (a, h, b, k) => {
  return ((a <= b) ? _depth_at_2(a, difference_root(b, a), h, b, k) : NaN);
};

const depth_2 = (a, h, b, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_3(a, h, b, k) : NaN);
};

const raised = (x, k) => {
  if ((x > 0.0)) {
    return (x * Math.pow(x, k));
  }
  return 0.0;
};

const sphere_force = (a, root, k) => {
  let integrand, open_, v, value, whole;
  open_ = ((root > 0.0) ? root : a);
  v = Math.asinh((a / open_));
  whole = Math.sinh(v);
  integrand = (x) => {
    let over;
    over = sinh_over(x);
    return (Math.pow(over, k) * (1.0 - Math.pow((over * (x / whole)), 2)));
  };
  value = ((((a * raised(a, k)) * Math.pow(_steepness(a, open_, v, k), k)) * v) * weighted(integrand, v, k, nodes_for(v)));
  return ((a === 0.0) ? 0.0 : ((root > 0.0) ? value : ((((a * raised(a, k)) * 2.0) / (2.0 + k)) * _last(k))));
};

const _force_at_of_ellipsoid = (a, root, h, b, H, k) => {
  let growth;
  growth = ((h * sphere_force(a, root, k)) / b);
  return (((2.0 * H) / (1.0 + k)) * growth);
};

const _force_3 = (a, h, b, H, k) => {
  return ((a <= b) ? _force_at_of_ellipsoid(a, difference_root(b, a), h, b, H, k) : NaN);
};

const force_2 = (a, h, b, H, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_3(a, h, b, H, k) : NaN);
};

const _LONGEST = 8.0;

const sphere_rate = (t, root, k) => {
  let far, first, integrand, open_, rest, total, v;
  open_ = ((root > 0.0) ? root : t);
  [v, far] = [Math.asinh((t / open_)), (math.hypot(t, root) / open_)];
  integrand = (x) => {
    return (Math.pow(sinh_over(x), k) * (1.0 + Math.pow((far / Math.cosh(x)), 2)));
  };
  first = math.minimum(v, _LONGEST);
  total = ((Math.pow(((open_ / t) * first), k) * first) * weighted(integrand, first, k, nodes_for(first)));
  if (Boolean((v > first))) {
    rest = math.integral_in_strip(((x) => (integrand((first + x)) * Math.pow((first + x), k))), (v - first));
    total = (total + (Math.pow((open_ / t), k) * rest));
  }
  return ((root > 0.0) ? total : Infinity);
};

const _AXIS = Math.pow(2.0, (-60));

const _off_axis = (r, a) => {
  return math.maximum(r, (_AXIS * a));
};

const _LONGEST_of_pressure = 8.0;

const tanh_growth = (slope, r, R, reach, end, k) => {
  let first, scale, smooth, stop, total;
  r = _off_axis(r, reach);
  scale = difference_root(R, r);
  smooth = (v) => {
    let root, t;
    root = (scale / Math.cosh(v));
    t = math.hypot(r, (scale * Math.tanh(v)));
    return (((slope(t, root) / t) * Math.pow((sinh_over(v) / Math.cosh(v)), k)) / Math.pow(Math.cosh(v), 2));
  };
  stop = Math.asinh((reach / end));
  first = math.minimum(stop, _LONGEST_of_pressure);
  total = (raised(first, k) * weighted(smooth, first, k, nodes_for(first)));
  if (Boolean((stop > first))) {
    total = (total + math.integral_in_strip(((v) => (smooth((first + v)) * Math.pow((first + v), k))), (stop - first)));
  }
  return math.where((end > 0.0), (raised(scale, k) * total), Infinity);
};

const _sphere = (r, R, reach, end, k) => {
  return tanh_growth(((t, root) => sphere_rate(t, root, k)), r, R, reach, end, k);
};

const sphere_pressure = (r, a, R, k) => {
  return _sphere(r, R, difference_root(a, r), difference_root(R, a), k);
};

const _pressure_5 = (r, a, h, b, H, k) => {
  let growth, inside;
  inside = math.minimum(r, a);
  growth = ((h * sphere_pressure(inside, a, b, k)) / b);
  return math.where((a <= b), math.where((r < a), ((H / Math.PI) * growth), 0.0), NaN);
};

const pressure_2 = (r, a, h, b, H, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_5(r, a, h, b, H, k) : 0.0) : NaN);
};

const punch_scale = (k) => {
  return (0.6366197723675814 * Math.sin((1.5707963267948966 * (1.0 - Math.abs(k)))));
};

const EDGE = [[3.0, 32], [11.0, 64]];

const NODES_of_displacement = 64;

const from_edge = (shape, a, q, c, stop, k, steep = false) => {
  let count, first, half, length, longest, ratio, second, smooth;
  ratio = (c / q);
  smooth = (v, sinh) => {
    let z;
    z = (c * sinh);
    return ((shape(difference_root(a, z), z) * Math.cosh(v)) / (1.0 + Math.pow((ratio * sinh), 2)));
  };
  first = (v) => {
    let sinh;
    sinh = Math.sinh(v);
    return (smooth(v, sinh) * Math.pow(((v > 0.0) ? (sinh / ((v > 0.0) ? v : 1.0)) : 1.0), k));
  };
  second = (v) => {
    let sinh;
    sinh = Math.sinh((half + v));
    return (smooth((half + v), sinh) * Math.pow(sinh, k));
  };
  longest = (math.truth(steep) ? Infinity : Number(math.maximum((Number.isFinite(stop) ? stop : 0.0))));
  for ([length, count] of EDGE) {
    if ((longest <= length)) {
      return ((raised(ratio, k) * raised(stop, k)) * weighted(first, stop, k, count));
    }
  }
  half = (stop / 2.0);
  return (raised(ratio, k) * ((raised(half, k) * weighted(first, half, k)) + math.integral(second, half, NODES_of_displacement)));
};

const punch_share = (r, a, k) => {
  let q, stop;
  q = difference_root(r, a);
  stop = Math.asinh((a / q));
  return (punch_scale(k) * from_edge(((s, z) => math.ones_like(z)), a, q, q, stop, k));
};

const _Gap = (outside, q, even, grown) => math.record({ outside, q, even, grown });

const _gap_of_displacement = (r, a, k) => {
  let even, outside, q, share;
  outside = (r > a);
  q = (math.truth(outside) ? difference_root(math.maximum(r, a), a) : a);
  share = ((1.0 - k) * (math.truth(outside) ? punch_share(r, a, k) : 1.0));
  even = ((share > 0.0) ? (share * raised((q / a), k)) : 0.0);
  return _Gap(outside, q, even, ((math.truth(outside) ? punch_scale(k) : 0.0) + (share * raised((a / q), (-k)))));
};

const _weighed = (gap, shape, a) => {
  return ((s, z) => (shape(s, z) * ((gap.grown * Math.pow((z / a), 2)) + gap.even)));
};

const SPLIT = 0.5235987755982988;

const over_angle = (shape, a, q, stop, k) => {
  let low, smooth;
  low = ((a * Math.cos(stop)) + math.zeros_like(q));
  smooth = (x) => {
    let s, z;
    s = (low + x);
    z = difference_root(a, s);
    return ((((shape(s, z) * (s / z)) * Math.pow((z / q), k)) / (1.0 + Math.pow((z / q), 2))) / q);
  };
  return math.integral(smooth, ((a * Math.cos(SPLIT)) - low), 32);
};

const _fall = (shape, r, a) => {
  let root;
  root = difference_root(a, r);
  return (shape(r, root) * Math.pow((root / a), 2));
};

const _joined_of_displacement = (gap, a, value, fall) => {
  return ((a > 0.0) ? (gap.outside ? value : (value + fall)) : 0.0);
};

const _smooth = (shape, r, a, k, c = Infinity) => {
  let close, gap, near, own;
  gap = _gap_of_displacement(r, a, k);
  [own, close] = [_weighed(gap, shape, a), math.minimum(gap.q, c)];
  near = from_edge(own, a, gap.q, close, Math.asinh(((a / close) / 2.0)), k);
  return _joined_of_displacement(gap, a, (near + over_angle(own, a, gap.q, math.full(gap.q, (Math.PI / 2.0)), k)), _fall(shape, r, a));
};

const sphere_displacement = (r, a, R, k) => {
  let end;
  end = difference_root(R, a);
  return _smooth(((s, z) => (a * (a / (end + math.hypot(end, z))))), r, a, k, end);
};

const _displacement_4 = (r, a, h, b, k) => {
  return ((h * sphere_displacement(r, a, b, k)) / b);
};

const displacement_2 = (r, a, h, b, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_4(r, a, h, b, k) : 0.0) : NaN);
};

const punch_stiffness = (a, H, k) => {
  return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
};

const _stiffness_3 = (a, H, k) => {
  return punch_stiffness(a, H, k);
};

const _stiffness_2 = (a, H, k, h = 1.0, b = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (H > 1e-30) && (H < 1e+30) && (k > 1e-30) && (k < 1.0) && (h > 1e-30) && (h < 1e+30) && (b > 1e-30) && (b < 1e+30))) {
    return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  }
  return _stiffness_3(a, H, k);
};

const stiffness_of_ellipsoid = (a, h, b, H, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness_2(a, H, k) : NaN);
};

const _mean_pressure_2 = (a, h, b, H, k) => {
  return ((a > 0.0) ? (_force_3(a, h, b, H, k) / ((Math.PI * a) * a)) : 0.0);
};

const mean_pressure_of_ellipsoid = (a, h, b, H, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure_2(a, h, b, H, k) : NaN);
};

const _rate_at = (a, root, h, b, k) => {
  return ((h * sphere_rate(a, root, k)) / b);
};

const STEEPEST = 100000000.0;

const SLACK_of_inverse = 1e-06;

const contact_below = (load, rate, value, R, needs, exponent, k) => {
  let a, contact, curve, half, largest, last, like, place, root, steepest, wanted, x;
  value = (value + math.zeros(1));
  k = ((Math.abs(k) < 1e-30) ? 1e-30 : k);
  like = (t) => {
    let log, power, x;
    power = Math.pow(t, exponent);
    log = Math.log1p(power);
    x = ((-Math.expm1((((-k) / exponent) * log))) / k);
    return [x, (((power / (1.0 + power)) * Math.exp((((-k) / exponent) * log))) / x)];
  };
  place = (x) => {
    let power;
    power = Math.expm1((((-exponent) / k) * Math.log1p(((-k) * x))));
    return Math.pow(power, (1.0 / exponent));
  };
  contact = (t) => {
    let root;
    root = (R / math.hypot(1.0, t));
    return [(root * t), root];
  };
  curve = (x) => {
    let a, own, root, t;
    t = place(x);
    [a, root] = contact(t);
    own = load(a, root, ...needs);
    return [own, ((((a * Math.pow((root / R), 2)) * rate(a, root, ...needs)) / own) / like(t)[1])];
  };
  steepest = (STEEPEST * math.ones_like(value));
  half = (0.5 * math.ones_like(value));
  largest = like(steepest)[0];
  last = load(...contact(steepest), ...needs);
  wanted = math.minimum(value, last);
  x = inverse(curve, wanted, (half * (wanted / curve(half)[0])), [SLACK_of_inverse, Infinity], largest, undefined, true);
  [a, root] = contact(place(x));
  if (Boolean((value > last))) {
    a = ((value <= (load(R, math.zeros_like(R), ...needs) * (1.0 + Math.pow(2.0, (-48))))) ? a : NaN);
  }
  return [a, root];
};

const _contact_from_depth_of_ellipsoid = (d, h, b, k) => {
  return contact_below(_depth_at_2, _rate_at, d, b, [h, b, k], 2.0, k);
};

const _radius_from_depth_2 = (d, h, b, k) => {
  return _contact_from_depth_of_ellipsoid(d, h, b, k)[0];
};

const radius_from_depth_2 = (d, h, b, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth_2(d, h, b, k) : NaN);
};

const _force_rate_at = (a, root, h, b, H, k) => {
  return (punch_stiffness(a, H, k) * _rate_at(a, root, h, b, k));
};

const _contact_from_force_of_ellipsoid = (F, h, b, H, k) => {
  return contact_below(_force_at_of_ellipsoid, _force_rate_at, F, b, [h, b, H, k], (3.0 + k), k);
};

const _radius_from_force_2 = (F, h, b, H, k) => {
  return _contact_from_force_of_ellipsoid(F, h, b, H, k)[0];
};

const radius_from_force_2 = (F, h, b, H, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _radius_from_force_2(F, h, b, H, k) : NaN);
};

const punch_force = (d, a, H, k) => {
  let v14;
  v14 = (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  if (((v14 > 0.0) && (v14 < Infinity))) {
    return (v14 * d);
  }
  return 0.0;
};

const _force_from_depth_of_ellipsoid = (d, h, b, H, k) => {
  let a, root;
  [a, root] = _contact_from_depth_of_ellipsoid(d, h, b, k);
  return (_force_at_of_ellipsoid(a, root, h, b, H, k) + punch_force((d - _depth_at_2(a, root, h, b, k)), a, H, k));
};

const force_from_depth_of_ellipsoid = (d, h, b, H, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth_of_ellipsoid(d, h, b, H, k) : NaN);
};

const punch_depth = (F, a, H, k) => {
  let v14;
  v14 = (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  if (((v14 > 0.0) && (v14 < Infinity))) {
    return (F / v14);
  }
  return 0.0;
};

const _depth_from_force_of_ellipsoid = (F, h, b, H, k) => {
  let a, root;
  [a, root] = _contact_from_force_of_ellipsoid(F, h, b, H, k);
  return (_depth_at_2(a, root, h, b, k) + punch_depth((F - _force_at_of_ellipsoid(a, root, h, b, H, k)), a, H, k));
};

const depth_from_force_of_ellipsoid = (F, h, b, H, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force_of_ellipsoid(F, h, b, H, k) : NaN);
};

const graded_retraction = (a, H, k, dgamma) => {
  if ((a > 0.0)) {
    return ((math.sqrt(((6.283185307179586 * dgamma) / H)) * math.sqrt(a)) * math.sqrt(Math.pow(a, (-k))));
  }
  return 0.0;
};

const retraction_of_ellipsoid = (a, H, k, dgamma) => {
  if ((!((0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? graded_retraction(a, H, k, dgamma) : NaN);
};

const _depth_4 = (a, h, b, H, k, dgamma) => {
  return (_depth_3(a, h, b, k) - graded_retraction(a, H, k, dgamma));
};

const depth_3 = (a, h, b, H, k, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_4(a, h, b, H, k, dgamma) : NaN);
};

const _force_4 = (a, h, b, H, k, dgamma) => {
  return (_force_3(a, h, b, H, k) - (punch_stiffness(a, H, k) * graded_retraction(a, H, k, dgamma)));
};

const force_3 = (a, h, b, H, k, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_4(a, h, b, H, k, dgamma) : NaN);
};

const tension_of_punch = (r, a, H, k, dgamma) => {
  let v17, v19, v23, v33;
  v17 = ((a > 0.0) ? ((math.sqrt(((6.283185307179586 * dgamma) / H)) * math.sqrt(a)) * math.sqrt(Math.pow(a, (-k)))) : 0.0);
  if ((v17 > 0.0)) {
    if ((r < a)) {
      v19 = (a - r);
      v23 = math.sqrt(((((v19 > 0.0) || (v19 !== v19)) ? v19 : 0.0) * (a + r)));
      v33 = (((H / 3.141592653589793) * Math.pow(v23, k)) / v23);
    } else {
      v33 = ((r > a) ? 0.0 : Infinity);
    }
    return (v17 * v33);
  }
  return 0.0;
};

const _pressure_6 = (r, a, h, b, H, k, dgamma) => {
  return (_pressure_5(r, a, h, b, H, k) - tension_of_punch(r, a, H, k, dgamma));
};

const pressure_3 = (r, a, h, b, H, k, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_6(r, a, h, b, H, k, dgamma) : 0.0) : NaN);
};

const punch_displacement = (r, a, k) => {
  return ((r > a) ? punch_share(r, a, k) : 1.0);
};

const _displacement_5 = (r, a, h, b, H, k, dgamma) => {
  return (_displacement_4(r, a, h, b, k) - (graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)));
};

const displacement_3 = (r, a, h, b, H, k, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_5(r, a, h, b, H, k, dgamma) : 0.0) : NaN);
};

const halves = (x) => {
  let v2, v4;
  v2 = (134217729.0 * x);
  v4 = (v2 - (v2 - x));
  return [v4, (x - v4)];
};

const stress_at = (unit, H, k) => {
  let exponent, high, low, mantissa, whole;
  [mantissa, exponent] = math.frexp(H);
  [high, low] = halves(k);
  whole = Math.floor(((unit * high) + 0.5));
  return [(exponent + exponent_of(math.exp2(whole))), (mantissa * math.exp2((((unit * high) - whole) + (unit * low))))];
};

const _rate_of_ellipsoid = (a, h, b, k) => {
  return ((a <= b) ? _rate_at(a, difference_root(b, a), h, b, k) : NaN);
};

const _samples_of_ellipsoid = (h, b, k) => {
  let a;
  a = radii_below(b);
  return ({ radii: a, end: a.at(-1) });
};

const STATIONARY = {'force': [3.0, 1.0], 'depth': [1.0, (-1.0)]};

const stationary = (control, k) => {
  let constant, slope;
  [constant, slope] = STATIONARY[control];
  return (constant + (slope * k));
};

const least_steepness_of_punch = (control, H, k, dgamma) => {
  return (stationary(control, k) * Math.sqrt(((Math.PI * dgamma) / (2.0 * H))));
};

const _branches_of_ellipsoid = (h, b, H, k, dgamma, control) => {
  return branches(((a) => (Math.pow(a, ((1.0 + k) / 2.0)) * _rate_of_ellipsoid(a, h, b, k))), _samples_of_ellipsoid(h, b, k), least_steepness_of_punch(control, H, k, dgamma));
};

const growth_of = (rate, geometry, H, k, dgamma, control) => {
  let growth;
  growth = (a) => {
    let slope;
    slope = (rate(a, ...geometry) - ((stationary(control, k) * graded_retraction(a, H, k, dgamma)) / (2.0 * a)));
    return ((control === 'force') ? (slope * punch_stiffness(a, H, k)) : slope);
  };
  return growth;
};

const pull_of = (H, k, dgamma, control) => {
  let pulled;
  pulled = (a) => {
    let moved;
    moved = graded_retraction(a, H, k, dgamma);
    return ((control === 'force') ? (moved * punch_stiffness(a, H, k)) : moved);
  };
  return pulled;
};

const _radius_from_depth_3 = (d, h, b, H, k, dgamma) => {
  let found, pulled, radius, slope, stress, unit;
  unit = exponent_of(b);
  [stress, H] = stress_at(unit, H, k);
  h = math.ldexp(h, (-unit));
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  d = math.ldexp(d, (-unit));
  found = _branches_of_ellipsoid(h, b, H, k, dgamma, 'depth');
  slope = growth_of(_rate_of_ellipsoid, [h, b, k], H, k, dgamma, 'depth');
  pulled = pull_of(H, k, dgamma, 'depth');
  radius = stable_radius(d, found, ((a) => _depth_4(a, h, b, H, k, dgamma)), slope, pulled, up_to(b, k));
  return math.ldexp(radius, unit);
};

const radius_from_depth_3 = (d, h, b, H, k, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_depth_3(d, h, b, H, k, dgamma);
};

const _radius_from_force_3 = (F, h, b, H, k, dgamma) => {
  let found, pulled, radius, slope, stress, unit;
  unit = exponent_of(b);
  [stress, H] = stress_at(unit, H, k);
  h = math.ldexp(h, (-unit));
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  F = math.ldexp(F, (-(stress + (2 * unit))));
  found = _branches_of_ellipsoid(h, b, H, k, dgamma, 'force');
  slope = growth_of(_rate_of_ellipsoid, [h, b, k], H, k, dgamma, 'force');
  pulled = pull_of(H, k, dgamma, 'force');
  radius = stable_radius(F, found, ((a) => _force_4(a, h, b, H, k, dgamma)), slope, pulled, up_to(b, k));
  return math.ldexp(radius, unit);
};

const radius_from_force_3 = (F, h, b, H, k, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_force_3(F, h, b, H, k, dgamma);
};

const _pull_off_radius_of_ellipsoid = (h, b, H, k, dgamma, control) => {
  let found, load, radius, stress, unit;
  unit = exponent_of(b);
  [stress, H] = stress_at(unit, H, k);
  h = math.ldexp(h, (-unit));
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  found = _branches_of_ellipsoid(h, b, H, k, dgamma, control);
  load = ((control === 'force') ? _force_4 : _depth_4);
  radius = math.lowest(found, ((a) => load(a, h, b, H, k, dgamma)));
  return math.ldexp(radius, unit);
};

const pull_off_of_ellipsoid = (control = 'force', h, b, H, k, dgamma) => {
  let depth, force, radius;
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  radius = _pull_off_radius_of_ellipsoid(h, b, H, k, dgamma, control);
  force = ((radius >= 0.0) ? _force_4(radius, h, b, H, k, dgamma) : NaN);
  depth = ((radius >= 0.0) ? _depth_4(radius, h, b, H, k, dgamma) : NaN);
  return PullOff(radius, force, depth);
};

const _close = (m, c, a) => {
  let inner;
  inner = difference_root(c, m);
  return ((inner > 0.0) & (inner >= (CLOSE * difference_root(a, m))));
};

const _weight = (quantity, t, y, k) => {
  if ((quantity === 'depth')) {
    return 1.0;
  }
  return ((quantity === 'force') ? (t * Math.pow(t, k)) : (Math.pow(y, k) / y));
};

const _span = (c, a, distance) => {
  return math.where((a > c), (0.5 * Math.log1p((((a - c) / distance) * ((a + c) / distance)))), 0.0);
};

const _grown_below = (quantity, rate, r, c, a, R, k, close) => {
  let holds, integrand, last, ratio, scale, start;
  [scale, start] = [difference_root(R, r), difference_root(c, r)];
  [ratio, last] = [(start / difference_root(R, c)), (difference_root(R, a) / scale)];
  integrand = (w) => {
    let secant, t, tangent, y;
    tangent = (ratio * Math.exp(w));
    secant = Math.sqrt((1.0 + (tangent * tangent)));
    y = (scale * (tangent / secant));
    t = Math.sqrt(((r * r) + (y * y)));
    return (((rate(t, (scale / secant), k) * _weight(quantity, t, y, k)) * (y / secant)) * ((y / t) / secant));
  };
  holds = (close & (start > 0.0));
  return math.where(holds, math.integral_in_strip(integrand, math.where(holds, _span(c, a, (start * last)), 0.0)), 0.0);
};

const either = (condition, x, y) => {
  if (Boolean(condition)) {
    return x();
  }
  return (Boolean(condition) ? (math.truth(condition) ? x() : y()) : y());
};

const below_gain = (quantity, whole, rate, lengths, r, c, a, k) => {
  let R, close, values;
  [R] = lengths;
  values = (t) => {
    return ((quantity === 'pressure') ? whole(r, t, R, k) : whole(t, difference_root(R, t), k));
  };
  close = _close(r, c, a);
  return either(close, (() => _grown_below(quantity, rate, r, c, a, R, k, close)), (() => (values(a) - values(c))));
};

const _tangential_force_2 = (a, c, h, b, H, k, mu) => {
  let gain;
  gain = ((h * below_gain('force', sphere_force, sphere_rate, [b], 0.0, c, a, k)) / b);
  return math.where((a <= b), ((mu * ((2.0 * H) / (1.0 + k))) * gain), NaN);
};

const tangential_force_of_ellipsoid = (a, c, h, b, H, k, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_force_2(a, c, h, b, H, k, mu) : NaN);
};

const _traction_of_ellipsoid = (r, a, c, h, b, H, k, mu) => {
  let gain;
  gain = () => {
    let inside;
    inside = math.minimum(r, c);
    return ((h * below_gain('pressure', sphere_pressure, sphere_rate, [b], inside, c, a, k)) / b);
  };
  return math.where((a <= b), (mu * either((r < c), (() => ((H / Math.PI) * gain())), (() => _pressure_5(r, a, h, b, H, k)))), NaN);
};

const traction_of_ellipsoid = (r, a, c, h, b, H, k, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction_of_ellipsoid(r, a, c, h, b, H, k, mu) : 0.0) : NaN);
};

const _tangential_displacement_2 = (a, c, h, b, H, H_x, k, mu) => {
  let gain;
  gain = ((h * below_gain('depth', sphere_depth, sphere_rate, [b], 0.0, c, a, k)) / b);
  return math.where((a <= b), ((mu * (H / H_x)) * gain), NaN);
};

const tangential_displacement_of_ellipsoid = (a, c, h, b, H, H_x, k, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement_2(a, c, h, b, H, H_x, k, mu) : NaN);
};

const _stick_radius_of_ellipsoid = (F_x, a, h, b, H, k, mu) => {
  let F;
  F = stick_force(_force_3(a, h, b, H, k), F_x, mu);
  return (((F_x === 0.0) & (a >= 0.0)) ? a : _radius_from_force_2(F, h, b, H, k));
};

const stick_radius_of_ellipsoid = (F_x, a, h, b, H, k, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius_of_ellipsoid(F_x, a, h, b, H, k, mu) : NaN);
};

const _full_slip_displacement_2 = (a, h, b, H, H_x, k, mu) => {
  return ((mu * (H / H_x)) * _depth_3(a, h, b, k));
};

const full_slip_displacement_of_ellipsoid = (a, h, b, H, H_x, k, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement_2(a, h, b, H, H_x, k, mu) : NaN);
};

const relaxation_maxwell = (t, E, tau) => {
  return (E * Math.exp(((-t) / tau)));
};

const _step_force_maxwell = (t, d, h, b, E, tau) => {
  return (relaxation_maxwell(t, E, tau) * _force_from_depth(d, h, b, 1.0));
};

const step_force_maxwell = (t, d, h, b, E, tau) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_maxwell(t, d, h, b, E, tau) : NaN);
};

const creep_maxwell = (t, E, tau) => {
  return ((1.0 + (t / tau)) / E);
};

const _step_load_radius_maxwell = (t, F, h, b, E, tau) => {
  return _radius_from_force((F * creep_maxwell(t, E, tau)), h, b, 1.0);
};

const step_load_radius_maxwell = (t, F, h, b, E, tau) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_maxwell(t, F, h, b, E, tau) : NaN);
};

const relaxation_kelvin_voigt = (t, E, eta) => {
  if ((t > 0.0)) {
    return E;
  }
  return Infinity;
};

const _step_force_kelvin_voigt = (t, d, h, b, E, eta) => {
  return (relaxation_kelvin_voigt(t, E, eta) * _force_from_depth(d, h, b, 1.0));
};

const step_force_kelvin_voigt = (t, d, h, b, E, eta) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_kelvin_voigt(t, d, h, b, E, eta) : NaN);
};

const creep_kelvin_voigt = (t, E, eta) => {
  return ((-Math.expm1((((-E) * t) / eta))) / E);
};

const _step_load_radius_kelvin_voigt = (t, F, h, b, E, eta) => {
  return _radius_from_force((F * creep_kelvin_voigt(t, E, eta)), h, b, 1.0);
};

const step_load_radius_kelvin_voigt = (t, F, h, b, E, eta) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_kelvin_voigt(t, F, h, b, E, eta) : NaN);
};

const relaxation_standard_solid = (t, E_inf, E_1, tau) => {
  return (E_inf + (E_1 * Math.exp(((-t) / tau))));
};

const _step_force_standard_solid = (t, d, h, b, E_inf, E_1, tau) => {
  return (relaxation_standard_solid(t, E_inf, E_1, tau) * _force_from_depth(d, h, b, 1.0));
};

const step_force_standard_solid = (t, d, h, b, E_inf, E_1, tau) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_standard_solid(t, d, h, b, E_inf, E_1, tau) : NaN);
};

const creep_standard_solid = (t, E_inf, E_1, tau) => {
  let v4;
  v4 = (E_inf + E_1);
  return ((1.0 / v4) - (((E_1 / v4) * Math.expm1((-((t / tau) * (E_inf / v4))))) / E_inf));
};

const _step_load_radius_standard_solid = (t, F, h, b, E_inf, E_1, tau) => {
  return _radius_from_force((F * creep_standard_solid(t, E_inf, E_1, tau)), h, b, 1.0);
};

const step_load_radius_standard_solid = (t, F, h, b, E_inf, E_1, tau) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_standard_solid(t, F, h, b, E_inf, E_1, tau) : NaN);
};

const relaxation_power_creep = (t, E, alpha, t_0) => {
  let v8;
  v8 = (3.141592653589793 * alpha);
  return (((E * Math.pow((t_0 / t), alpha)) * Math.sin(v8)) / v8);
};

const _step_force_power_creep = (t, d, h, b, E, alpha, t_0) => {
  return (relaxation_power_creep(t, E, alpha, t_0) * _force_from_depth(d, h, b, 1.0));
};

const step_force_power_creep = (t, d, h, b, E, alpha, t_0) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_power_creep(t, d, h, b, E, alpha, t_0) : NaN);
};

const creep_power_creep = (t, E, alpha, t_0) => {
  return (Math.pow((t / t_0), alpha) / E);
};

const _step_load_radius_power_creep = (t, F, h, b, E, alpha, t_0) => {
  return _radius_from_force((F * creep_power_creep(t, E, alpha, t_0)), h, b, 1.0);
};

const step_load_radius_power_creep = (t, F, h, b, E, alpha, t_0) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < h && h < Infinity) && (0.0 < b && b < Infinity) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_power_creep(t, F, h, b, E, alpha, t_0) : NaN);
};

const once = { peak_pressure: math.kept(peak_pressure), pull_off: math.kept(pull_off), pull_off_of_ellipsoid: math.kept(pull_off_of_ellipsoid) };
const formulas = {
  "d": (v) => depth(v.a, v.h, v.b),
  "F": (v) => force(v.a, v.h, v.b, v.E_star),
  "p": (v) => pressure(v.r, v.a, v.h, v.b, v.E_star),
  "w": (v) => displacement(v.r, v.a, v.h, v.b),
  "k": (v) => stiffness(v.a, v.h, v.b, v.E_star),
  "pm": (v) => mean_pressure(v.a, v.h, v.b, v.E_star),
  "U": (v) => energy(v.a, v.h, v.b, v.E_star),
  "Fr": (v) => load_within(v.r, v.a, v.h, v.b, v.E_star),
  "rp": (v) => (once.peak_pressure(v.a, v.h, v.b, v.E_star).radius ?? NaN),
  "pp": (v) => (once.peak_pressure(v.a, v.h, v.b, v.E_star).pressure ?? NaN),
  "ad": (v) => radius_from_depth(v.d, v.h, v.b),
  "aF": (v) => radius_from_force(v.F, v.h, v.b, v.E_star),
  "Fd": (v) => force_from_depth(v.d, v.h, v.b, v.E_star),
  "dF": (v) => depth_from_force(v.F, v.h, v.b, v.E_star),
  "adh.Dl": (v) => retraction(v.a, v.E_star, v.dgamma),
  "adh.d": (v) => depth_of_ellipsoid(v.a, v.h, v.b, v.E_star, v.dgamma),
  "adh.F": (v) => force_of_ellipsoid(v.a, v.h, v.b, v.E_star, v.dgamma),
  "adh.p": (v) => pressure_of_ellipsoid(v.r, v.a, v.h, v.b, v.E_star, v.dgamma),
  "adh.w": (v) => displacement_of_ellipsoid(v.r, v.a, v.h, v.b, v.E_star, v.dgamma),
  "adh.ad": (v) => radius_from_depth_of_ellipsoid(v.d, v.h, v.b, v.E_star, v.dgamma),
  "adh.aF": (v) => radius_from_force_of_ellipsoid(v.F, v.h, v.b, v.E_star, v.dgamma),
  "adh.ac": (v) => (once.pull_off('force', v.h, v.b, v.E_star, v.dgamma).radius ?? NaN),
  "adh.Fc": (v) => (once.pull_off('force', v.h, v.b, v.E_star, v.dgamma).force ?? NaN),
  "adh.dc": (v) => (once.pull_off('force', v.h, v.b, v.E_star, v.dgamma).depth ?? NaN),
  "adh.am": (v) => (once.pull_off('depth', v.h, v.b, v.E_star, v.dgamma).radius ?? NaN),
  "adh.Fm": (v) => (once.pull_off('depth', v.h, v.b, v.E_star, v.dgamma).force ?? NaN),
  "adh.dm": (v) => (once.pull_off('depth', v.h, v.b, v.E_star, v.dgamma).depth ?? NaN),
  "tan.F": (v) => tangential_force(v.a, v.c, v.h, v.b, v.E_star, v.mu),
  "tan.tau": (v) => traction(v.r, v.a, v.c, v.h, v.b, v.E_star, v.mu),
  "tan.u": (v) => tangential_displacement(v.a, v.c, v.h, v.b, v.E_star, v.G_star, v.mu),
  "tan.c": (v) => stick_radius(v.F_x, v.a, v.h, v.b, v.E_star, v.mu),
  "tan.us": (v) => full_slip_displacement(v.a, v.h, v.b, v.E_star, v.G_star, v.mu),
  "fgm.d": (v) => depth_2(v.a, v.h, v.b, v.k),
  "fgm.F": (v) => force_2(v.a, v.h, v.b, v.H, v.k),
  "fgm.p": (v) => pressure_2(v.r, v.a, v.h, v.b, v.H, v.k),
  "fgm.w": (v) => displacement_2(v.r, v.a, v.h, v.b, v.k),
  "fgm.k": (v) => stiffness_of_ellipsoid(v.a, v.h, v.b, v.H, v.k),
  "fgm.pm": (v) => mean_pressure_of_ellipsoid(v.a, v.h, v.b, v.H, v.k),
  "fgm.ad": (v) => radius_from_depth_2(v.d, v.h, v.b, v.k),
  "fgm.aF": (v) => radius_from_force_2(v.F, v.h, v.b, v.H, v.k),
  "fgm.Fd": (v) => force_from_depth_of_ellipsoid(v.d, v.h, v.b, v.H, v.k),
  "fgm.dF": (v) => depth_from_force_of_ellipsoid(v.F, v.h, v.b, v.H, v.k),
  "fgm.adh.Dl": (v) => retraction_of_ellipsoid(v.a, v.H, v.k, v.dgamma),
  "fgm.adh.d": (v) => depth_3(v.a, v.h, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.F": (v) => force_3(v.a, v.h, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.p": (v) => pressure_3(v.r, v.a, v.h, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.w": (v) => displacement_3(v.r, v.a, v.h, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.ad": (v) => radius_from_depth_3(v.d, v.h, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.aF": (v) => radius_from_force_3(v.F, v.h, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.ac": (v) => (once.pull_off_of_ellipsoid('force', v.h, v.b, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fc": (v) => (once.pull_off_of_ellipsoid('force', v.h, v.b, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dc": (v) => (once.pull_off_of_ellipsoid('force', v.h, v.b, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.adh.am": (v) => (once.pull_off_of_ellipsoid('depth', v.h, v.b, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fm": (v) => (once.pull_off_of_ellipsoid('depth', v.h, v.b, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dm": (v) => (once.pull_off_of_ellipsoid('depth', v.h, v.b, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.tan.F": (v) => tangential_force_of_ellipsoid(v.a, v.c, v.h, v.b, v.H, v.k, v.mu),
  "fgm.tan.tau": (v) => traction_of_ellipsoid(v.r, v.a, v.c, v.h, v.b, v.H, v.k, v.mu),
  "fgm.tan.u": (v) => tangential_displacement_of_ellipsoid(v.a, v.c, v.h, v.b, v.H, v.H_x, v.k, v.mu),
  "fgm.tan.c": (v) => stick_radius_of_ellipsoid(v.F_x, v.a, v.h, v.b, v.H, v.k, v.mu),
  "fgm.tan.us": (v) => full_slip_displacement_of_ellipsoid(v.a, v.h, v.b, v.H, v.H_x, v.k, v.mu),
  "vis.step_mx": (v) => step_force_maxwell(v.t, v.d, v.h, v.b, v.E_law, v.tau),
  "vis.load_mx": (v) => step_load_radius_maxwell(v.t, v.F, v.h, v.b, v.E_law, v.tau),
  "vis.step_kv": (v) => step_force_kelvin_voigt(v.t, v.d, v.h, v.b, v.E_law, v.eta),
  "vis.load_kv": (v) => step_load_radius_kelvin_voigt(v.t, v.F, v.h, v.b, v.E_law, v.eta),
  "vis.step_sls": (v) => step_force_standard_solid(v.t, v.d, v.h, v.b, v.E_inf, v.E_1, v.tau),
  "vis.load_sls": (v) => step_load_radius_standard_solid(v.t, v.F, v.h, v.b, v.E_inf, v.E_1, v.tau),
  "vis.step_pc": (v) => step_force_power_creep(v.t, v.d, v.h, v.b, v.E_law, v.alpha, v.t_0),
  "vis.load_pc": (v) => step_load_radius_power_creep(v.t, v.F, v.h, v.b, v.E_law, v.alpha, v.t_0),
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
   "name": "H",
   "tex": "H",
   "meaning": "foundation modulus of the graded half-space",
   "unit": "Pa m^(-k)",
   "rule": "H > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 50000000.0
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
   "name": "H_x",
   "tex": "H_x",
   "meaning": "tangential foundation modulus",
   "unit": "Pa m^(-k)",
   "rule": "H_x > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 30000000.0
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
  },
  {
   "name": "E_law",
   "tex": "E",
   "meaning": "effective (plane-strain) modulus of the viscoelastic law",
   "unit": "Pa",
   "rule": "E_law > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 3000000.0
  },
  {
   "name": "E_inf",
   "tex": "E_\\infty",
   "meaning": "long-time effective modulus",
   "unit": "Pa",
   "rule": "E_inf > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 1000000.0
  },
  {
   "name": "E_1",
   "tex": "E_1",
   "meaning": "relaxing part of the effective modulus",
   "unit": "Pa",
   "rule": "E_1 >= 0",
   "low": 0.0,
   "high": null,
   "closed": "low",
   "value": 2000000.0
  },
  {
   "name": "tau",
   "tex": "\\tau",
   "meaning": "relaxation time",
   "unit": "s",
   "rule": "tau > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 1.0
  },
  {
   "name": "eta",
   "tex": "\\eta",
   "meaning": "effective viscosity",
   "unit": "Pa s",
   "rule": "eta > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 1000000.0
  },
  {
   "name": "alpha",
   "tex": "\\alpha",
   "meaning": "exponent of power-law creep",
   "unit": "1",
   "rule": "0 < alpha < 1",
   "low": 0.0,
   "high": 1.0,
   "closed": "",
   "value": 0.3
  },
  {
   "name": "t_0",
   "tex": "t_0",
   "meaning": "reference time of power-law creep",
   "unit": "s",
   "rule": "t_0 > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 1.0
  },
  {
   "name": "t",
   "tex": "t",
   "meaning": "time since first contact",
   "unit": "s",
   "rule": "t >= 0",
   "low": 0.0,
   "high": null,
   "closed": "low",
   "value": 1.0
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
   "suffix": "d",
   "medium": 0
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
   "suffix": "F",
   "medium": 0
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
   "suffix": "p",
   "medium": 0
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
   "suffix": "w",
   "medium": 0
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
   "suffix": "k",
   "medium": 0
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
   "suffix": "pm",
   "medium": 0
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
   "suffix": "U",
   "medium": 0
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
   "suffix": "Fr",
   "medium": 0
  },
  "rp": {
   "gives": "r_peak",
   "needs": [
    "a",
    "h",
    "b",
    "E_star"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "pp": {
   "gives": "p_peak",
   "needs": [
    "a",
    "h",
    "b",
    "E_star"
   ],
   "unit": "Pa",
   "place": "",
   "suffix": "",
   "medium": 0
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
   "suffix": "ad",
   "medium": 0
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
   "suffix": "aF",
   "medium": 0
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
   "suffix": "Fd",
   "medium": 0
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
   "suffix": "dF",
   "medium": 0
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
   "suffix": "",
   "medium": 0
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
   "suffix": "",
   "medium": 0
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
   "suffix": "",
   "medium": 0
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
   "suffix": "",
   "medium": 0
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
   "suffix": "",
   "medium": 0
  },
  "adh.ad": {
   "gives": "a",
   "needs": [
    "d",
    "h",
    "b",
    "E_star",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "adh.aF": {
   "gives": "a",
   "needs": [
    "F",
    "h",
    "b",
    "E_star",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "adh.ac": {
   "gives": "a_c",
   "needs": [
    "h",
    "b",
    "E_star",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "adh.Fc": {
   "gives": "F",
   "needs": [
    "h",
    "b",
    "E_star",
    "dgamma"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "adh.dc": {
   "gives": "d",
   "needs": [
    "h",
    "b",
    "E_star",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "adh.am": {
   "gives": "a_c",
   "needs": [
    "h",
    "b",
    "E_star",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "adh.Fm": {
   "gives": "F",
   "needs": [
    "h",
    "b",
    "E_star",
    "dgamma"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "adh.dm": {
   "gives": "d",
   "needs": [
    "h",
    "b",
    "E_star",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
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
   "suffix": "",
   "medium": 0
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
   "suffix": "",
   "medium": 0
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
   "suffix": "",
   "medium": 0
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
   "suffix": "",
   "medium": 0
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
   "suffix": "",
   "medium": 0
  },
  "fgm.d": {
   "gives": "d",
   "needs": [
    "a",
    "h",
    "b",
    "k"
   ],
   "unit": "m",
   "place": "",
   "suffix": "d",
   "medium": 1
  },
  "fgm.F": {
   "gives": "F",
   "needs": [
    "a",
    "h",
    "b",
    "H",
    "k"
   ],
   "unit": "N",
   "place": "",
   "suffix": "F",
   "medium": 1
  },
  "fgm.p": {
   "gives": "p",
   "needs": [
    "r",
    "a",
    "h",
    "b",
    "H",
    "k"
   ],
   "unit": "Pa",
   "place": "inside",
   "suffix": "p",
   "medium": 1
  },
  "fgm.w": {
   "gives": "w",
   "needs": [
    "r",
    "a",
    "h",
    "b",
    "k"
   ],
   "unit": "m",
   "place": "outside",
   "suffix": "w",
   "medium": 1
  },
  "fgm.k": {
   "gives": "stiffness",
   "needs": [
    "a",
    "h",
    "b",
    "H",
    "k"
   ],
   "unit": "N/m",
   "place": "",
   "suffix": "k",
   "medium": 1
  },
  "fgm.pm": {
   "gives": "p_mean",
   "needs": [
    "a",
    "h",
    "b",
    "H",
    "k"
   ],
   "unit": "Pa",
   "place": "",
   "suffix": "pm",
   "medium": 1
  },
  "fgm.ad": {
   "gives": "a",
   "needs": [
    "d",
    "h",
    "b",
    "k"
   ],
   "unit": "m",
   "place": "",
   "suffix": "ad",
   "medium": 1
  },
  "fgm.aF": {
   "gives": "a",
   "needs": [
    "F",
    "h",
    "b",
    "H",
    "k"
   ],
   "unit": "m",
   "place": "",
   "suffix": "aF",
   "medium": 1
  },
  "fgm.Fd": {
   "gives": "F",
   "needs": [
    "d",
    "h",
    "b",
    "H",
    "k"
   ],
   "unit": "N",
   "place": "",
   "suffix": "Fd",
   "medium": 1
  },
  "fgm.dF": {
   "gives": "d",
   "needs": [
    "F",
    "h",
    "b",
    "H",
    "k"
   ],
   "unit": "m",
   "place": "",
   "suffix": "dF",
   "medium": 1
  },
  "fgm.adh.Dl": {
   "gives": "retraction",
   "needs": [
    "a",
    "H",
    "k",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "fgm.adh.d": {
   "gives": "d",
   "needs": [
    "a",
    "h",
    "b",
    "H",
    "k",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "fgm.adh.F": {
   "gives": "F",
   "needs": [
    "a",
    "h",
    "b",
    "H",
    "k",
    "dgamma"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "fgm.adh.p": {
   "gives": "p",
   "needs": [
    "r",
    "a",
    "h",
    "b",
    "H",
    "k",
    "dgamma"
   ],
   "unit": "Pa",
   "place": "inside",
   "suffix": "",
   "medium": 1
  },
  "fgm.adh.w": {
   "gives": "w",
   "needs": [
    "r",
    "a",
    "h",
    "b",
    "H",
    "k",
    "dgamma"
   ],
   "unit": "m",
   "place": "outside",
   "suffix": "",
   "medium": 1
  },
  "fgm.adh.ad": {
   "gives": "a",
   "needs": [
    "d",
    "h",
    "b",
    "H",
    "k",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "fgm.adh.aF": {
   "gives": "a",
   "needs": [
    "F",
    "h",
    "b",
    "H",
    "k",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "fgm.adh.ac": {
   "gives": "a_c",
   "needs": [
    "h",
    "b",
    "H",
    "k",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "fgm.adh.Fc": {
   "gives": "F",
   "needs": [
    "h",
    "b",
    "H",
    "k",
    "dgamma"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "fgm.adh.dc": {
   "gives": "d",
   "needs": [
    "h",
    "b",
    "H",
    "k",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "fgm.adh.am": {
   "gives": "a_c",
   "needs": [
    "h",
    "b",
    "H",
    "k",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "fgm.adh.Fm": {
   "gives": "F",
   "needs": [
    "h",
    "b",
    "H",
    "k",
    "dgamma"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "fgm.adh.dm": {
   "gives": "d",
   "needs": [
    "h",
    "b",
    "H",
    "k",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "fgm.tan.F": {
   "gives": "F_x",
   "needs": [
    "a",
    "c",
    "h",
    "b",
    "H",
    "k",
    "mu"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "fgm.tan.tau": {
   "gives": "tau",
   "needs": [
    "r",
    "a",
    "c",
    "h",
    "b",
    "H",
    "k",
    "mu"
   ],
   "unit": "Pa",
   "place": "inside",
   "suffix": "",
   "medium": 1
  },
  "fgm.tan.u": {
   "gives": "u_0",
   "needs": [
    "a",
    "c",
    "h",
    "b",
    "H",
    "H_x",
    "k",
    "mu"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "fgm.tan.c": {
   "gives": "c",
   "needs": [
    "F_x",
    "a",
    "h",
    "b",
    "H",
    "k",
    "mu"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "fgm.tan.us": {
   "gives": "u_0",
   "needs": [
    "a",
    "h",
    "b",
    "H",
    "H_x",
    "k",
    "mu"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 1
  },
  "vis.step_mx": {
   "gives": "F",
   "needs": [
    "t",
    "d",
    "h",
    "b",
    "E_law",
    "tau"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "vis.load_mx": {
   "gives": "a",
   "needs": [
    "t",
    "F",
    "h",
    "b",
    "E_law",
    "tau"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "vis.step_kv": {
   "gives": "F",
   "needs": [
    "t",
    "d",
    "h",
    "b",
    "E_law",
    "eta"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "vis.load_kv": {
   "gives": "a",
   "needs": [
    "t",
    "F",
    "h",
    "b",
    "E_law",
    "eta"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "vis.step_sls": {
   "gives": "F",
   "needs": [
    "t",
    "d",
    "h",
    "b",
    "E_inf",
    "E_1",
    "tau"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "vis.load_sls": {
   "gives": "a",
   "needs": [
    "t",
    "F",
    "h",
    "b",
    "E_inf",
    "E_1",
    "tau"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "vis.step_pc": {
   "gives": "F",
   "needs": [
    "t",
    "d",
    "h",
    "b",
    "E_law",
    "alpha",
    "t_0"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "vis.load_pc": {
   "gives": "a",
   "needs": [
    "t",
    "F",
    "h",
    "b",
    "E_law",
    "alpha",
    "t_0"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
  }
 },
 "place": "r"
}, evaluate: formulas };
})();
