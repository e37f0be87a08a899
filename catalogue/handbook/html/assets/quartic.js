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
  return ((((64 * E_star) * A) / (15 * Math.PI)) * math.raised(a, 3));
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
  return ((((2048 * E_star) * Math.pow(A, 2)) / 405) * math.raised(a, 9));
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
  return ((((64 * E_star) * A) / 15) * math.raised(a, 5));
};

const _load_within_of_quartic = (r, a, A, E_star) => {
  let root, within;
  root = Math.sqrt(((a - r) * (a + r)));
  within = (((((64 * E_star) * A) / 45) * Math.pow(r, 2)) * ((((3 * math.raised(a, 4)) / (root + a)) + (Math.pow(a, 2) * root)) + ((2 * Math.pow(r, 2)) * root)));
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

const _peak_pressure_of_quartic = (a, A, E_star) => {
  return (((((32 * E_star) * A) / (9 * Math.PI)) * math.raised(a, 3)) * Math.sqrt(2));
};

const _peak_pressure = (a, A, E_star) => {
  if (((a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    return (((((32.0 * E_star) * A) / 28.274333882308138) * (a * (a * a))) * 1.4142135623730951);
  }
  return _peak_pressure_of_quartic(a, A, E_star);
};

const _peak_radius_of_quartic = (a) => {
  return ((a * Math.sqrt(2)) / 2);
};

const _peak_radius = (a, A = 1.0, E_star = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    return ((a * 1.4142135623730951) / 2.0);
  }
  return _peak_radius_of_quartic(a);
};

const PeakPressure = (pressure, radius) => math.record({ pressure, radius });

const peak_pressure = (a, A, E_star) => {
  let pressure, radius;
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  pressure = ((a >= 0.0) ? _peak_pressure(a, A, E_star) : NaN);
  radius = ((a >= 0.0) ? _peak_radius(a) : NaN);
  return PeakPressure(pressure, radius);
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
      v23 = (v3 / (math.truth(v8) ? (v10 + (v10 * (((v3 / (Math.pow(v10, 5.0) * Math.pow(v10, 0.0))) - 1.0) / 5.0))) : v10));
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
  return (((8 * A) / 3) * math.raised(a, 4));
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
  return (A * math.raised(r, 4));
};

const _displacement_3 = (r, a, A) => {
  let inside, outside;
  outside = ((((16 * A) / (3 * Math.PI)) * math.raised(a, 4)) * beside(r, a, OUTSIDE_4));
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
    return (v88 - ((Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))) * (math.truth(v87) ? (0.6366197723675814 * Math.atan2(a, Math.sqrt(((((v14 > 0.0) || (v14 !== v14)) ? v14 : 0.0) * v15)))) : 1.0)));
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
    return math.log1p((math.truth(v6) ? v3 : 0.0));
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

const PullOff = (radius, force, depth) => math.record({ radius, force, depth });

const pull_off = (control = 'force', A, E_star, dgamma) => {
  let depth, force, radius;
  if ((!((0.0 < A && A < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  radius = _pull_off_radius(A, E_star, dgamma, control);
  force = ((radius >= 0.0) ? _pull_off_force(radius, A, E_star, dgamma, control) : NaN);
  depth = ((radius >= 0.0) ? _pull_off_depth(radius, A, E_star, dgamma, control) : NaN);
  return PullOff(radius, force, depth);
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
  return (((32 * A) / 3) * math.raised(t, 3));
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

const _gamma = (x) => {
  return math.vectorize(math.gamma)(x);
};

const FAR = 40.0;

const _near = (x, e, steps) => {
  let before, i, lost, part, total;
  [total, lost] = [0.0, 0.0];
  for (i of math.range((steps - 1), (-1), (-1))) {
    part = (Math.log1p((e / (x + i))) - lost);
    [before, total] = [total, (total + part)];
    lost = ((total - before) - part);
  }
  return total;
};

const _to_the_last_digit = (terms) => {
  let before, lost, part, term, total;
  [total, lost] = [0.0, 0.0];
  for (term of terms) {
    part = (term - lost);
    [before, total] = [total, (total + part)];
    lost = ((total - before) - part);
  }
  return total;
};

const series = (e) => {
  let first, second, third;
  first = (((-e) * ((e * e) - 1.0)) / 24.0);
  second = (((((e * (e - 1.0)) * (e - 2.0)) * (e - 3.0)) * (e + 1.0)) / 5760.0);
  third = ((((second * (e - 4.0)) * (e - 5.0)) / (-504.0)) * (((35.0 * Math.pow((e + 1.0), 2)) + (42.0 * (e + 1.0))) + 16.0));
  return [first, (second * ((5.0 * e) + 7.0)), third];
};

const _rising = (x, e) => {
  let first, near, second, shifts, steps, third, w;
  [x, e] = [math.asarray(x), math.asarray(e)];
  steps = Math.ceil(math.maximum((FAR - x), 0.0));
  if ((math.ndim((x + e)) === 0)) {
    near = _near(Number(x), Number(e), Math.trunc(steps));
  } else {
    shifts = math.reversed(math.range(Math.trunc(math.maximum(steps))));
    near = _to_the_last_digit([...shifts].map((i) => math.where((i < steps), Math.log1p((e / (x + i))), 0.0)));
  }
  w = ((x + steps) + ((e - 1.0) / 2.0));
  [first, second, third] = series(e);
  return ((Math.pow(w, e) * (1.0 + ((first + ((second + (third / (w * w))) / (w * w))) / (w * w)))) * Math.exp((-near)));
};

const power_factor = math.kept((n, k) => {
  let half;
  half = ((1.0 + k) / 2.0);
  return (((((1.0 + k) + n) / (1.0 + k)) * _gamma((1.0 + half))) / _rising((1.0 + (n / 2.0)), half));
});

const power_depth = (a, n, k) => {
  return (power_factor(n, k) * Math.pow(a, n));
};

const _depth_4 = (a, A, k) => {
  return (A * power_depth(a, 4.0, k));
};

const depth_2 = (a, A, k) => {
  if ((!((0.0 < A && A < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_4(a, A, k) : NaN);
};

const raised = (x, k) => {
  if ((x > 0.0)) {
    return (x * Math.pow(x, k));
  }
  return 0.0;
};

const power_force = (a, n, k) => {
  return (((power_factor(n, k) * (n / (n + (1.0 + k)))) * Math.pow(a, n)) * raised(a, k));
};

const _force_4 = (a, A, H, k) => {
  let growth;
  growth = (A * power_force(a, 4.0, k));
  return (((2.0 * H) / (1.0 + k)) * growth);
};

const force_2 = (a, A, H, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_4(a, A, H, k) : NaN);
};

const _EVEN = 16;

const _even_growth = (r, a, n, k) => {
  let half, j, share, square, total;
  [half, square] = [((1.0 + k) / 2.0), Math.pow((r / a), 2)];
  total = (0.5 / half);
  for (j of math.range(1, Math.floor(n / 2))) {
    total = ((0.5 + ((j * square) * total)) / (j + half));
  }
  share = (((a - r) / a) * ((a + r) / a));
  return ((Math.sqrt(share) * Math.pow(share, (k / 2.0))) * total);
};

const axis_power = (n, k) => {
  if ((n < 0.5)) {
    return ((k - 1.0) + n);
  }
  return ((n - 1.0) + k);
};

const NODES = 64;

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

const RULE_0 = math.rule([[Infinity, 64]]);

const _steep = (rest, near, m, half) => {
  let node, v11, v12, v14, v15, v25, v26, v6, v7, weight;
  v6 = (Number.isFinite(rest) ? rest : Infinity);
  v7 = Math.abs(m);
  v11 = (42.0 / (((v7 > 20.0) || (v7 !== v7)) ? v7 : 20.0));
  v12 = (((v6 < v11) || (v6 !== v6)) ? v6 : v11);
  v15 = (-m);
  v26 = [];
  for ([node, weight] of RULE_0((v12 / 1.0))) {
    v14 = (node * v12);
    v25 = (Math.exp((v15 * v14)) * Math.pow((-Math.expm1(((-2.0) * (near + (v6 - v14))))), half));
    v26.push((weight * v25));
  }
  v26 = (math.fsum(v26) * v12);
  return v26;
};

const _tail = (rest, near, m, half, far) => {
  let v10, v107, v109, v11, v110, v111, v118, v12, v133, v135, v136, v137, v144, v158, v160, v161, v162, v169, v184, v186, v187, v188, v19, v195, v209, v21, v211, v212, v213, v220, v235, v237, v238, v239, v246, v260, v262, v263, v264, v271, v286, v288, v289, v290, v297, v31, v311, v313, v314, v315, v322, v33, v337, v339, v34, v340, v341, v348, v35, v362, v364, v365, v366, v373, v388, v390, v391, v392, v399, v413, v415, v416, v417, v42, v424, v439, v441, v442, v443, v450, v464, v466, v467, v468, v475, v490, v492, v493, v494, v501, v512, v515, v517, v518, v519, v526, v543, v544, v545, v552, v56, v58, v59, v60, v67, v7, v82, v84, v85, v86, v93;
  v7 = (Number.isFinite(rest) ? rest : 0.0);
  v10 = (m - 0.0);
  v11 = (v10 === 0.0);
  if (v11) {
    v19 = v7;
  } else {
    v12 = Math.abs(v10);
    v19 = ((-Math.expm1(((-v12) * v7))) / (math.truth(v11) ? 1.0 : v12));
  }
  v21 = (near + v7);
  v31 = (0.0 - half);
  v33 = (m - 2.0);
  v34 = (v33 === 0.0);
  if (v34) {
    v42 = v7;
  } else {
    v35 = Math.abs(v33);
    v42 = ((-Math.expm1(((-v35) * v7))) / (math.truth(v34) ? 1.0 : v35));
  }
  v56 = ((v31 * (1.0 - half)) / 2.0);
  v58 = (m - 4.0);
  v59 = (v58 === 0.0);
  if (v59) {
    v67 = v7;
  } else {
    v60 = Math.abs(v58);
    v67 = ((-Math.expm1(((-v60) * v7))) / (math.truth(v59) ? 1.0 : v60));
  }
  v82 = ((v56 * (2.0 - half)) / 3.0);
  v84 = (m - 6.0);
  v85 = (v84 === 0.0);
  if (v85) {
    v93 = v7;
  } else {
    v86 = Math.abs(v84);
    v93 = ((-Math.expm1(((-v86) * v7))) / (math.truth(v85) ? 1.0 : v86));
  }
  v107 = ((v82 * (3.0 - half)) / 4.0);
  v109 = (m - 8.0);
  v110 = (v109 === 0.0);
  if (v110) {
    v118 = v7;
  } else {
    v111 = Math.abs(v109);
    v118 = ((-Math.expm1(((-v111) * v7))) / (math.truth(v110) ? 1.0 : v111));
  }
  v133 = ((v107 * (4.0 - half)) / 5.0);
  v135 = (m - 10.0);
  v136 = (v135 === 0.0);
  if (v136) {
    v144 = v7;
  } else {
    v137 = Math.abs(v135);
    v144 = ((-Math.expm1(((-v137) * v7))) / (math.truth(v136) ? 1.0 : v137));
  }
  v158 = ((v133 * (5.0 - half)) / 6.0);
  v160 = (m - 12.0);
  v161 = (v160 === 0.0);
  if (v161) {
    v169 = v7;
  } else {
    v162 = Math.abs(v160);
    v169 = ((-Math.expm1(((-v162) * v7))) / (math.truth(v161) ? 1.0 : v162));
  }
  v184 = ((v158 * (6.0 - half)) / 7.0);
  v186 = (m - 14.0);
  v187 = (v186 === 0.0);
  if (v187) {
    v195 = v7;
  } else {
    v188 = Math.abs(v186);
    v195 = ((-Math.expm1(((-v188) * v7))) / (math.truth(v187) ? 1.0 : v188));
  }
  v209 = ((v184 * (7.0 - half)) / 8.0);
  v211 = (m - 16.0);
  v212 = (v211 === 0.0);
  if (v212) {
    v220 = v7;
  } else {
    v213 = Math.abs(v211);
    v220 = ((-Math.expm1(((-v213) * v7))) / (math.truth(v212) ? 1.0 : v213));
  }
  v235 = ((v209 * (8.0 - half)) / 9.0);
  v237 = (m - 18.0);
  v238 = (v237 === 0.0);
  if (v238) {
    v246 = v7;
  } else {
    v239 = Math.abs(v237);
    v246 = ((-Math.expm1(((-v239) * v7))) / (math.truth(v238) ? 1.0 : v239));
  }
  v260 = ((v235 * (9.0 - half)) / 10.0);
  v262 = (m - 20.0);
  v263 = (v262 === 0.0);
  if (v263) {
    v271 = v7;
  } else {
    v264 = Math.abs(v262);
    v271 = ((-Math.expm1(((-v264) * v7))) / (math.truth(v263) ? 1.0 : v264));
  }
  v286 = ((v260 * (10.0 - half)) / 11.0);
  v288 = (m - 22.0);
  v289 = (v288 === 0.0);
  if (v289) {
    v297 = v7;
  } else {
    v290 = Math.abs(v288);
    v297 = ((-Math.expm1(((-v290) * v7))) / (math.truth(v289) ? 1.0 : v290));
  }
  v311 = ((v286 * (11.0 - half)) / 12.0);
  v313 = (m - 24.0);
  v314 = (v313 === 0.0);
  if (v314) {
    v322 = v7;
  } else {
    v315 = Math.abs(v313);
    v322 = ((-Math.expm1(((-v315) * v7))) / (math.truth(v314) ? 1.0 : v315));
  }
  v337 = ((v311 * (12.0 - half)) / 13.0);
  v339 = (m - 26.0);
  v340 = (v339 === 0.0);
  if (v340) {
    v348 = v7;
  } else {
    v341 = Math.abs(v339);
    v348 = ((-Math.expm1(((-v341) * v7))) / (math.truth(v340) ? 1.0 : v341));
  }
  v362 = ((v337 * (13.0 - half)) / 14.0);
  v364 = (m - 28.0);
  v365 = (v364 === 0.0);
  if (v365) {
    v373 = v7;
  } else {
    v366 = Math.abs(v364);
    v373 = ((-Math.expm1(((-v366) * v7))) / (math.truth(v365) ? 1.0 : v366));
  }
  v388 = ((v362 * (14.0 - half)) / 15.0);
  v390 = (m - 30.0);
  v391 = (v390 === 0.0);
  if (v391) {
    v399 = v7;
  } else {
    v392 = Math.abs(v390);
    v399 = ((-Math.expm1(((-v392) * v7))) / (math.truth(v391) ? 1.0 : v392));
  }
  v413 = ((v388 * (15.0 - half)) / 16.0);
  v415 = (m - 32.0);
  v416 = (v415 === 0.0);
  if (v416) {
    v424 = v7;
  } else {
    v417 = Math.abs(v415);
    v424 = ((-Math.expm1(((-v417) * v7))) / (math.truth(v416) ? 1.0 : v417));
  }
  v439 = ((v413 * (16.0 - half)) / 17.0);
  v441 = (m - 34.0);
  v442 = (v441 === 0.0);
  if (v442) {
    v450 = v7;
  } else {
    v443 = Math.abs(v441);
    v450 = ((-Math.expm1(((-v443) * v7))) / (math.truth(v442) ? 1.0 : v443));
  }
  v464 = ((v439 * (17.0 - half)) / 18.0);
  v466 = (m - 36.0);
  v467 = (v466 === 0.0);
  if (v467) {
    v475 = v7;
  } else {
    v468 = Math.abs(v466);
    v475 = ((-Math.expm1(((-v468) * v7))) / (math.truth(v467) ? 1.0 : v468));
  }
  v490 = ((v464 * (18.0 - half)) / 19.0);
  v492 = (m - 38.0);
  v493 = (v492 === 0.0);
  if (v493) {
    v501 = v7;
  } else {
    v494 = Math.abs(v492);
    v501 = ((-Math.expm1(((-v494) * v7))) / (math.truth(v493) ? 1.0 : v494));
  }
  v512 = ((((((((((((((((((((0.0 + (v19 * ((v10 > 0.0) ? Math.exp(((-0.0) * v21)) : (Math.exp(((-0.0) * near)) * far)))) + ((v31 * v42) * ((v33 > 0.0) ? Math.exp(((-2.0) * v21)) : (Math.exp(((-2.0) * near)) * far)))) + ((v56 * v67) * ((v58 > 0.0) ? Math.exp(((-4.0) * v21)) : (Math.exp(((-4.0) * near)) * far)))) + ((v82 * v93) * ((v84 > 0.0) ? Math.exp(((-6.0) * v21)) : (Math.exp(((-6.0) * near)) * far)))) + ((v107 * v118) * ((v109 > 0.0) ? Math.exp(((-8.0) * v21)) : (Math.exp(((-8.0) * near)) * far)))) + ((v133 * v144) * ((v135 > 0.0) ? Math.exp(((-10.0) * v21)) : (Math.exp(((-10.0) * near)) * far)))) + ((v158 * v169) * ((v160 > 0.0) ? Math.exp(((-12.0) * v21)) : (Math.exp(((-12.0) * near)) * far)))) + ((v184 * v195) * ((v186 > 0.0) ? Math.exp(((-14.0) * v21)) : (Math.exp(((-14.0) * near)) * far)))) + ((v209 * v220) * ((v211 > 0.0) ? Math.exp(((-16.0) * v21)) : (Math.exp(((-16.0) * near)) * far)))) + ((v235 * v246) * ((v237 > 0.0) ? Math.exp(((-18.0) * v21)) : (Math.exp(((-18.0) * near)) * far)))) + ((v260 * v271) * ((v262 > 0.0) ? Math.exp(((-20.0) * v21)) : (Math.exp(((-20.0) * near)) * far)))) + ((v286 * v297) * ((v288 > 0.0) ? Math.exp(((-22.0) * v21)) : (Math.exp(((-22.0) * near)) * far)))) + ((v311 * v322) * ((v313 > 0.0) ? Math.exp(((-24.0) * v21)) : (Math.exp(((-24.0) * near)) * far)))) + ((v337 * v348) * ((v339 > 0.0) ? Math.exp(((-26.0) * v21)) : (Math.exp(((-26.0) * near)) * far)))) + ((v362 * v373) * ((v364 > 0.0) ? Math.exp(((-28.0) * v21)) : (Math.exp(((-28.0) * near)) * far)))) + ((v388 * v399) * ((v390 > 0.0) ? Math.exp(((-30.0) * v21)) : (Math.exp(((-30.0) * near)) * far)))) + ((v413 * v424) * ((v415 > 0.0) ? Math.exp(((-32.0) * v21)) : (Math.exp(((-32.0) * near)) * far)))) + ((v439 * v450) * ((v441 > 0.0) ? Math.exp(((-34.0) * v21)) : (Math.exp(((-34.0) * near)) * far)))) + ((v464 * v475) * ((v466 > 0.0) ? Math.exp(((-36.0) * v21)) : (Math.exp(((-36.0) * near)) * far)))) + ((v490 * v501) * ((v492 > 0.0) ? Math.exp(((-38.0) * v21)) : (Math.exp(((-38.0) * near)) * far))));
  v515 = ((v490 * (19.0 - half)) / 20.0);
  v517 = (m - 40.0);
  v518 = (v517 === 0.0);
  if (v518) {
    v526 = v7;
  } else {
    v519 = Math.abs(v517);
    v526 = ((-Math.expm1(((-v519) * v7))) / (math.truth(v518) ? 1.0 : v519));
  }
  v543 = (m - 42.0);
  v544 = (v543 === 0.0);
  if (v544) {
    v552 = v7;
  } else {
    v545 = Math.abs(v543);
    v552 = ((-Math.expm1(((-v545) * v7))) / (math.truth(v544) ? 1.0 : v545));
  }
  return ((v512 + ((v515 * v526) * ((v517 > 0.0) ? Math.exp(((-40.0) * v21)) : (Math.exp(((-40.0) * near)) * far)))) + ((((v515 * (20.0 - half)) / 21.0) * v552) * ((v543 > 0.0) ? Math.exp(((-42.0) * v21)) : (Math.exp(((-42.0) * near)) * far))));
};

const power_growth = (r, a, n, k) => {
  let above, far, first, half, length, m, near, place, rest, smooth, total;
  if (((typeof n === "number") && ((n % 2.0) === 0.0) && (n <= _EVEN))) {
    return _even_growth(r, a, Math.trunc(n), k);
  }
  m = axis_power(n, k);
  length = Math.log1p(((a - r) / r));
  length = (Number.isFinite(length) ? length : (Math.log(a) - Math.log(r)));
  near = math.minimum(math.minimum(length, 1.0), (20.0 / math.maximum(Math.abs(m), 1e-300)));
  [half, above] = [((k - 1.0) / 2.0), ((k + 1.0) / 2.0)];
  smooth = (x) => {
    let shrink;
    shrink = ((x > 0.0) ? ((-Math.expm1(((-2.0) * x))) / ((x > 0.0) ? x : 1.0)) : 2.0);
    return (Math.pow(shrink, half) * Math.exp(((-m) * (near - x))));
  };
  rest = (length - near);
  place = math.minimum(((r / a) * Math.exp(near)), 1.0);
  far = ((Math.pow(place, n) / place) * Math.pow(place, k));
  first = (((rest > 0.0) ? far : 1.0) * Math.pow(near, above));
  first = (first * weighted(smooth, near, half, undefined, above));
  total = (first + ((Math.abs(m) > 20.0) ? _steep(rest, near, m, half) : _tail(rest, near, m, half, far)));
  return ((r > 0.0) ? total : ((m > 0.0) ? (1.0 / ((m > 0.0) ? m : 1.0)) : Infinity));
};

const power_pressure = (r, a, n, k) => {
  return (((power_factor(n, k) * n) * ((Math.pow(a, n) / a) * Math.pow(a, k))) * power_growth(r, a, n, k));
};

const _pressure_4 = (r, a, A, H, k) => {
  let growth, inside;
  inside = math.minimum(r, a);
  growth = (A * power_pressure(inside, a, 4.0, k));
  return ((r < a) ? ((H / Math.PI) * growth) : 0.0);
};

const pressure_2 = (r, a, A, H, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_4(r, a, A, H, k) : 0.0) : NaN);
};

const power_excess = math.kept((n, k) => {
  let change, e, first, half, high, log, low, m, second, third, u, v, x;
  [x, e, half] = [(n / 2.0), ((1.0 - k) / 2.0), ((1.0 + k) / 2.0)];
  log = math.zeros_like((x * e));
  for (m of math.range(Math.trunc(FAR))) {
    log = (log + Math.log1p(((x / ((m + 1.0) + x)) * (e / (m + half)))));
  }
  [low, high] = [(FAR + (half / 2.0)), ((FAR + (half / 2.0)) + x)];
  [u, v] = [(1.0 / (low * low)), (1.0 / (high * high))];
  [first, second, third] = series(e);
  change = (((((-x) * (low + high)) * u) * v) * ((first + (second * (u + v))) + (third * (((u * u) + (u * v)) + (v * v)))));
  log = ((log + (e * Math.log1p((x / low)))) + Math.log1p((change / ((1.0 + (first * u)) + ((second * u) * u)))));
  return math.where((log < 0.5), Math.expm1(log), (power_factor(n, k) - 1.0));
});

const STEEP = 16.0;

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

const _from_edge_of_power = (shape, q, a, n, k) => {
  return from_edge(shape, a, q, q, Math.asinh(((a / q) / 2.0)), k, Boolean((n > STEEP)));
};

const _SMOOTHING = 8;

const kernel = (sine, cosine, ratio, k) => {
  let v9;
  v9 = (ratio * sine);
  return (((ratio * Math.pow(ratio, k)) * (Math.pow(sine, k) * cosine)) / (1.0 + (v9 * v9)));
};

const SPLIT = 0.5235987755982988;

const _to_axis = (q) => {
  return math.full(math.repeated([1], math.ndim(q)), ((Math.PI / 2.0) - SPLIT));
};

const punch_scale = (k) => {
  return (0.6366197723675814 * Math.sin((1.5707963267948966 * (1.0 - Math.abs(k)))));
};

const _beside_power = (r, a, n, k, excess) => {
  let near, q, reach, smooth;
  q = difference_root(r, a);
  near = _from_edge_of_power(((s, z) => (excess - Math.expm1(((n / 2.0) * Math.log1p((-Math.pow((z / a), 2))))))), q, a, n, k);
  smooth = (u) => {
    let over, x;
    x = (reach * Math.pow(u, _SMOOTHING));
    over = ((((excess - Math.expm1((n * Math.log(Math.sin(x))))) * _SMOOTHING) * reach) * Math.pow(u, (_SMOOTHING - 1)));
    return (over * kernel(Math.cos(x), Math.sin(x), (a / q), k));
  };
  reach = _to_axis(q);
  return (punch_scale(k) * (near + math.integral(smooth, math.ones_like(reach), NODES_of_displacement)));
};

const power_displacement = (r, a, n, k) => {
  let excess, over, ratio;
  ratio = ((r < (0.5 * a)) ? Math.log((r / a)) : ((r < a) ? Math.log1p(((r - a) / a)) : 0.0));
  excess = power_excess(n, k);
  over = ((r > a) ? _beside_power(r, a, n, k, excess) : (excess - Math.expm1((n * ratio))));
  return ((a > 0.0) ? (Math.pow(a, n) * over) : 0.0);
};

const _displacement_4 = (r, a, A, k) => {
  return (A * power_displacement(r, a, 4.0, k));
};

const displacement_2 = (r, a, A, k) => {
  if ((!((0.0 < A && A < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_4(r, a, A, k) : 0.0) : NaN);
};

const punch_stiffness = (a, H, k) => {
  return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
};

const _stiffness_3 = (a, H, k) => {
  return punch_stiffness(a, H, k);
};

const _stiffness_2 = (a, H, k, A = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (H > 1e-30) && (H < 1e+30) && (k > 1e-30) && (k < 1.0) && (A > 1e-30) && (A < 1e+30))) {
    return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  }
  return _stiffness_3(a, H, k);
};

const stiffness_of_quartic = (a, A, H, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness_2(a, H, k) : NaN);
};

const power_mean = (a, n, k) => {
  let m, power;
  m = axis_power(n, k);
  power = ((a > 0.0) ? ((Math.pow(a, n) / a) * Math.pow(a, k)) : ((m > 0.0) ? 0.0 : ((m < 0.0) ? Infinity : 1.0)));
  return ((power_factor(n, k) * (n / (n + (1.0 + k)))) * power);
};

const _mean_pressure_2 = (a, A, H, k) => {
  let growth;
  growth = (A * power_mean(a, 4.0, k));
  return ((((2.0 * H) / (1.0 + k)) / Math.PI) * growth);
};

const mean_pressure_of_quartic = (a, A, H, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure_2(a, A, H, k) : NaN);
};

const _radius_from_depth_2 = (d, A, k) => {
  return Math.pow((d / _depth_4(math.ones_like(d), A, k)), (1.0 / 4.0));
};

const radius_from_depth_2 = (d, A, k) => {
  if ((!((0.0 < A && A < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth_2(d, A, k) : NaN);
};

const _radius_from_force_3 = (F, A, H, k) => {
  return Math.pow((F / _force_4(math.ones_like(F), A, H, k)), (1.0 / (5.0 + k)));
};

const radius_from_force_2 = (F, A, H, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _radius_from_force_3(F, A, H, k) : NaN);
};

const _force_from_depth_of_quartic = (d, A, H, k) => {
  let stiffness;
  stiffness = punch_stiffness(_radius_from_depth_2(d, A, k), H, k);
  return (((d > 0.0) & Number.isFinite(d)) ? (d * (stiffness * (4.0 / (4.0 + (1.0 + k))))) : d);
};

const force_from_depth_of_quartic = (d, A, H, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth_of_quartic(d, A, H, k) : NaN);
};

const _depth_from_force_2 = (F, A, H, k) => {
  let stiffness;
  stiffness = punch_stiffness(_radius_from_force_3(F, A, H, k), H, k);
  return (((F > 0.0) & Number.isFinite(F)) ? (F / (stiffness * (4.0 / (4.0 + (1.0 + k))))) : F);
};

const depth_from_force_of_quartic = (F, A, H, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force_2(F, A, H, k) : NaN);
};

const graded_retraction = (a, H, k, dgamma) => {
  if ((a > 0.0)) {
    return ((math.sqrt(((6.283185307179586 * dgamma) / H)) * math.sqrt(a)) * math.sqrt(Math.pow(a, (-k))));
  }
  return 0.0;
};

const retraction_of_quartic = (a, H, k, dgamma) => {
  if ((!((0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? graded_retraction(a, H, k, dgamma) : NaN);
};

const _depth_5 = (a, A, H, k, dgamma) => {
  return (_depth_4(a, A, k) - graded_retraction(a, H, k, dgamma));
};

const depth_3 = (a, A, H, k, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_5(a, A, H, k, dgamma) : NaN);
};

const _force_5 = (a, A, H, k, dgamma) => {
  return (_force_4(a, A, H, k) - (punch_stiffness(a, H, k) * graded_retraction(a, H, k, dgamma)));
};

const force_3 = (a, A, H, k, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_5(a, A, H, k, dgamma) : NaN);
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

const _pressure_5 = (r, a, A, H, k, dgamma) => {
  return (_pressure_4(r, a, A, H, k) - tension_of_punch(r, a, H, k, dgamma));
};

const pressure_3 = (r, a, A, H, k, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_5(r, a, A, H, k, dgamma) : 0.0) : NaN);
};

const punch_share = (r, a, k) => {
  let q, stop;
  q = difference_root(r, a);
  stop = Math.asinh((a / q));
  return (punch_scale(k) * from_edge(((s, z) => math.ones_like(z)), a, q, q, stop, k));
};

const punch_displacement = (r, a, k) => {
  return ((r > a) ? punch_share(r, a, k) : 1.0);
};

const _displacement_5 = (r, a, A, H, k, dgamma) => {
  return (_displacement_4(r, a, A, k) - (graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)));
};

const displacement_3 = (r, a, A, H, k, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_5(r, a, A, H, k, dgamma) : 0.0) : NaN);
};

const power_rate = (t, n, k) => {
  return ((power_factor(n, k) * n) * (Math.pow(t, n) / t));
};

const _rate = (a, A, k) => {
  return (A * power_rate(a, 4.0, k));
};

const STATIONARY = {'force': [3.0, 1.0], 'depth': [1.0, (-1.0)]};

const stationary = (control, k) => {
  let constant, slope;
  [constant, slope] = STATIONARY[control];
  return (constant + (slope * k));
};

const least_steepness = (control, H, k, dgamma) => {
  return (stationary(control, k) * Math.sqrt(((Math.PI * dgamma) / (2.0 * H))));
};

const unloading_radius = (rate, p, H, k, dgamma, control) => {
  return Math.pow((least_steepness(control, H, k, dgamma) / rate), (1.0 / (p - ((1.0 - k) / 2.0))));
};

const _pull_off_radius_of_quartic = (A, H, k, dgamma, control) => {
  let own, rate;
  rate = _rate(math.ones_like((H * k)), A, k);
  own = unloading_radius(rate, 4.0, H, k, dgamma, control);
  return ((dgamma > 0.0) ? own : 0.0);
};

const _pull_off_depth_of_quartic = (a, A, H, k, dgamma, control) => {
  return (_depth_4(a, A, k) * (1.0 - ((2.0 * 4.0) / stationary(control, k))));
};

const _radius_from_depth_3 = (d, A, H, k, dgamma) => {
  let a_c, least, plain;
  a_c = _pull_off_radius_of_quartic(A, H, k, dgamma, 'depth');
  least = _pull_off_depth_of_quartic(a_c, A, H, k, dgamma, 'depth');
  plain = _radius_from_depth_2(math.maximum(d, 0.0), A, k);
  return power_law_radius(d, a_c, least, 4.0, ((1.0 - k) / 2.0), plain);
};

const radius_from_depth_3 = (d, A, H, k, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_depth_3(d, A, H, k, dgamma);
};

const _pull_off_force_of_quartic = (a, A, H, k, dgamma, control) => {
  return (_force_4(a, A, H, k) * (1.0 - ((2.0 * ((4.0 + 1.0) + k)) / stationary(control, k))));
};

const _radius_from_force_4 = (F, A, H, k, dgamma) => {
  let a_c, least, plain;
  a_c = _pull_off_radius_of_quartic(A, H, k, dgamma, 'force');
  least = _pull_off_force_of_quartic(a_c, A, H, k, dgamma, 'force');
  plain = _radius_from_force_3(math.maximum(F, 0.0), A, H, k);
  return power_law_radius(F, a_c, least, ((4.0 + 1.0) + k), ((3.0 + k) / 2.0), plain);
};

const radius_from_force_3 = (F, A, H, k, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_force_4(F, A, H, k, dgamma);
};

const pull_off_of_quartic = (control = 'force', A, H, k, dgamma) => {
  let depth, force, radius;
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  radius = _pull_off_radius_of_quartic(A, H, k, dgamma, control);
  force = ((radius >= 0.0) ? _pull_off_force_of_quartic(radius, A, H, k, dgamma, control) : NaN);
  depth = ((radius >= 0.0) ? _pull_off_depth_of_quartic(radius, A, H, k, dgamma, control) : NaN);
  return PullOff(radius, force, depth);
};

const DECAY = 42.0;

const _span = (c, a, distance) => {
  if ((a > c)) {
    return (0.5 * math.log1p((((a - c) / distance) * ((a + c) / distance))));
  }
  return 0.0;
};

const PANEL = 9.0;

const NODES_of_slip = 64;

const _power_growth = (r, c, a, n, k) => {
  let cut, end, falls, inner, integrand, last, lost, outer, side, start, stop, within;
  [inner, outer] = [difference_root(c, r), difference_root(a, r)];
  falls = ((n + (k - 1.0)) >= 0.0);
  end = (math.truth(falls) ? a : c);
  start = (math.truth(falls) ? outer : inner);
  side = (1.0 - (2.0 * falls));
  lost = (Math.pow((a / outer), 2) * (-Math.expm1((((-2.0) * DECAY) / math.maximum((n - 2.0), 0.001)))));
  cut = ((-0.5) * Math.log1p((-math.minimum(lost, (1.0 - 1e-16)))));
  last = (((n > 2.0) & (lost < 1.0)) ? cut : Infinity);
  stop = math.minimum(_span(c, a, inner), last);
  integrand = (w) => {
    let base, change, distance;
    distance = (start * Math.exp((side * w)));
    base = (math.truth(falls) ? ((r * r) + (distance * distance)) : (c * c));
    change = (0.5 * Math.log1p((((start * start) * Math.abs(Math.expm1(((2.0 * side) * w)))) / base)));
    return Math.exp((side * (((n - 2.0) * change) + ((1.0 + k) * w))));
  };
  within = math.integral_by_panels(integrand, stop, (PANEL * math.ones_like(stop)), NODES_of_slip);
  return ((((Math.pow(end, n) / end) / end) * raised(start, k)) * within);
};

const power_gain = (quantity, r, c, a, n, k) => {
  if ((quantity === 'depth')) {
    return (power_depth(a, n, k) * gained_share(c, a, n));
  }
  if ((quantity === 'force')) {
    return (power_force(a, n, k) * gained_share(c, a, (n + (1.0 + k))));
  }
  return ((power_factor(n, k) * n) * _power_growth(r, c, a, n, k));
};

const _tangential_force_2 = (a, c, A, H, k, mu) => {
  let gain;
  gain = (A * power_gain('force', 0.0, c, a, 4.0, k));
  return ((mu * ((2.0 * H) / (1.0 + k))) * gain);
};

const tangential_force_of_quartic = (a, c, A, H, k, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_force_2(a, c, A, H, k, mu) : NaN);
};

const either = (condition, x, y) => {
  if (Boolean(condition)) {
    return x();
  }
  return (Boolean(condition) ? (math.truth(condition) ? x() : y()) : y());
};

const _traction_2 = (r, a, c, A, H, k, mu) => {
  let gain;
  gain = () => {
    let inside;
    inside = math.minimum(r, c);
    return (A * power_gain('pressure', inside, c, a, 4.0, k));
  };
  return (mu * either((r < c), (() => ((H / Math.PI) * gain())), (() => _pressure_4(r, a, A, H, k))));
};

const traction_of_quartic = (r, a, c, A, H, k, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction_2(r, a, c, A, H, k, mu) : 0.0) : NaN);
};

const _tangential_displacement_2 = (a, c, A, H, H_x, k, mu) => {
  let gain;
  gain = (A * power_gain('depth', 0.0, c, a, 4.0, k));
  return ((mu * (H / H_x)) * gain);
};

const tangential_displacement_of_quartic = (a, c, A, H, H_x, k, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement_2(a, c, A, H, H_x, k, mu) : NaN);
};

const _stick_radius_2 = (F_x, a, A, H, k, mu) => {
  let F;
  F = stick_force(_force_4(a, A, H, k), F_x, mu);
  return (((F_x === 0.0) & (a >= 0.0)) ? a : _radius_from_force_3(F, A, H, k));
};

const stick_radius_of_quartic = (F_x, a, A, H, k, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius_2(F_x, a, A, H, k, mu) : NaN);
};

const _full_slip_displacement_2 = (a, A, H, H_x, k, mu) => {
  return ((mu * (H / H_x)) * _depth_4(a, A, k));
};

const full_slip_displacement_of_quartic = (a, A, H, H_x, k, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement_2(a, A, H, H_x, k, mu) : NaN);
};

const SWITCH = 40.0;

const TERMS = 170;

const ROUNDING_of_relaxation = 5.551115123125783e-17;

const fading = (x, m) => {
  let high, k, low, more, tail, term, total;
  low = math.minimum(x, SWITCH);
  [term, total] = [Math.exp((-low)), Math.exp((-low))];
  for (k of math.range(1, TERMS)) {
    term = ((term * low) / k);
    more = (term * (m / (m + k)));
    total = (total + more);
    if ((!Boolean((more > (ROUNDING_of_relaxation * total))))) {
      break;
    }
  }
  if ((!Boolean((x > SWITCH)))) {
    return total;
  }
  high = math.maximum(x, SWITCH);
  tail = math.integral(((y) => (m * Math.exp((((m - 1.0) * Math.log1p((-y))) - (high * y))))), ((0.999999 * SWITCH) / high), 64);
  return ((x <= SWITCH) ? total : ((x < Infinity) ? tail : 0.0));
};

const ramp_maxwell = (t, m, E, tau) => {
  return (E * fading((t / tau), m));
};

const _ramp_force_maxwell = (t, v, A, E, tau) => {
  let force;
  force = (_force_from_depth((v * t), A, 1.0) * ramp_maxwell(t, 1.25, E, tau));
  return ((t === 0.0) ? 0.0 : force);
};

const ramp_force_maxwell = (t, A, v, E, tau) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < v && v < Infinity) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _ramp_force_maxwell(t, v, A, E, tau) : NaN);
};

const relaxation_maxwell = (t, E, tau) => {
  return (E * Math.exp(((-t) / tau)));
};

const _force_from_depth_2 = (d, A, E_star) => {
  return ((((4 * E_star) / 5) * d) * Math.sqrt(Math.sqrt(((6 * d) / A))));
};

const _step_force_maxwell_of_quartic = (t, d, A, E, tau) => {
  return (relaxation_maxwell(t, E, tau) * _force_from_depth_2(d, A, 1.0));
};

const _step_force_maxwell = (t, d, A, E, tau) => {
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E > 1e-30) && (E < 1e+30) && (tau > 1e-30) && (tau < 1e+30))) {
    return ((E * Math.exp(((-t) / tau))) * ((0.8 * d) * Math.sqrt(Math.sqrt(((6.0 * d) / A)))));
  }
  return _step_force_maxwell_of_quartic(t, d, A, E, tau);
};

const step_force_maxwell = (t, d, A, E, tau) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < A && A < Infinity) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_maxwell(t, d, A, E, tau) : NaN);
};

const creep_maxwell = (t, E, tau) => {
  return ((1.0 + (t / tau)) / E);
};

const _step_load_radius_maxwell_of_quartic = (t, F, A, E, tau) => {
  return _radius_from_force_2((F * creep_maxwell(t, E, tau)), A, 1.0);
};

const _step_load_radius_maxwell = (t, F, A, E, tau) => {
  let v14, v16;
  if (((t > 1e-30) && (t < 1e+30) && (F > 1e-30) && (F < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E > 1e-30) && (E < 1e+30) && (tau > 1e-30) && (tau < 1e+30))) {
    v14 = ((15.0 * (F * ((1.0 + (t / tau)) / E))) / (64.0 * A));
    v16 = Math.pow(v14, 0.2);
    if (((v14 > 0.0) && (v14 < Infinity))) {
      return (v16 + (v16 * (((v14 / (Math.pow(v16, 5.0) * Math.pow(v16, 0.0))) - 1.0) / 5.0)));
    }
    return v16;
  }
  return _step_load_radius_maxwell_of_quartic(t, F, A, E, tau);
};

const step_load_radius_maxwell = (t, F, A, E, tau) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < A && A < Infinity) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_maxwell(t, F, A, E, tau) : NaN);
};

const ramp_kelvin_voigt = (t, m, E, eta) => {
  return (E + ((eta * m) / t));
};

const _ramp_force_kelvin_voigt_of_quartic = (t, v, A, E, eta) => {
  let force;
  force = (_force_from_depth_2((v * t), A, 1.0) * ramp_kelvin_voigt(t, 1.25, E, eta));
  return math.where((t === 0.0), 0.0, force);
};

const _ramp_force_kelvin_voigt = (t, v, A, E, eta) => {
  let v5;
  if (((t > 1e-30) && (t < 1e+30) && (v > 1e-30) && (v < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E > 1e-30) && (E < 1e+30) && (eta > 1e-30) && (eta < 1e+30))) {
    if ((t === 0.0)) {
      return 0.0;
    }
    v5 = (v * t);
    return (((0.8 * v5) * Math.sqrt(Math.sqrt(((6.0 * v5) / A)))) * (E + ((eta * 1.25) / t)));
  }
  return _ramp_force_kelvin_voigt_of_quartic(t, v, A, E, eta);
};

const ramp_force_kelvin_voigt = (t, A, v, E, eta) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < v && v < Infinity) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _ramp_force_kelvin_voigt(t, v, A, E, eta) : NaN);
};

const relaxation_kelvin_voigt = (t, E, eta) => {
  if ((t > 0.0)) {
    return E;
  }
  return Infinity;
};

const _step_force_kelvin_voigt_of_quartic = (t, d, A, E, eta) => {
  return (relaxation_kelvin_voigt(t, E, eta) * _force_from_depth_2(d, A, 1.0));
};

const _step_force_kelvin_voigt = (t, d, A, E, eta) => {
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E > 1e-30) && (E < 1e+30) && (eta > 1e-30) && (eta < 1e+30))) {
    return (((t > 0.0) ? E : Infinity) * ((0.8 * d) * Math.sqrt(Math.sqrt(((6.0 * d) / A)))));
  }
  return _step_force_kelvin_voigt_of_quartic(t, d, A, E, eta);
};

const step_force_kelvin_voigt = (t, d, A, E, eta) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < A && A < Infinity) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_kelvin_voigt(t, d, A, E, eta) : NaN);
};

const creep_kelvin_voigt = (t, E, eta) => {
  return ((-Math.expm1((((-E) * t) / eta))) / E);
};

const _step_load_radius_kelvin_voigt_of_quartic = (t, F, A, E, eta) => {
  return _radius_from_force_2((F * creep_kelvin_voigt(t, E, eta)), A, 1.0);
};

const _step_load_radius_kelvin_voigt = (t, F, A, E, eta) => {
  let v16, v18;
  if (((t > 1e-30) && (t < 1e+30) && (F > 1e-30) && (F < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E > 1e-30) && (E < 1e+30) && (eta > 1e-30) && (eta < 1e+30))) {
    v16 = ((15.0 * (F * ((-Math.expm1((((-E) * t) / eta))) / E))) / (64.0 * A));
    v18 = Math.pow(v16, 0.2);
    if (((v16 > 0.0) && (v16 < Infinity))) {
      return (v18 + (v18 * (((v16 / (Math.pow(v18, 5.0) * Math.pow(v18, 0.0))) - 1.0) / 5.0)));
    }
    return v18;
  }
  return _step_load_radius_kelvin_voigt_of_quartic(t, F, A, E, eta);
};

const step_load_radius_kelvin_voigt = (t, F, A, E, eta) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < A && A < Infinity) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_kelvin_voigt(t, F, A, E, eta) : NaN);
};

const ramp_standard_solid = (t, m, E_inf, E_1, tau) => {
  return (E_inf + (E_1 * fading((t / tau), m)));
};

const _ramp_force_standard_solid = (t, v, A, E_inf, E_1, tau) => {
  let force;
  force = (_force_from_depth((v * t), A, 1.0) * ramp_standard_solid(t, 1.25, E_inf, E_1, tau));
  return ((t === 0.0) ? 0.0 : force);
};

const ramp_force_standard_solid = (t, A, v, E_inf, E_1, tau) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < v && v < Infinity) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _ramp_force_standard_solid(t, v, A, E_inf, E_1, tau) : NaN);
};

const relaxation_standard_solid = (t, E_inf, E_1, tau) => {
  return (E_inf + (E_1 * Math.exp(((-t) / tau))));
};

const _step_force_standard_solid_of_quartic = (t, d, A, E_inf, E_1, tau) => {
  return (relaxation_standard_solid(t, E_inf, E_1, tau) * _force_from_depth_2(d, A, 1.0));
};

const _step_force_standard_solid = (t, d, A, E_inf, E_1, tau) => {
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_inf > 1e-30) && (E_inf < 1e+30) && (E_1 > 1e-30) && (E_1 < 1e+30) && (tau > 1e-30) && (tau < 1e+30))) {
    return ((E_inf + (E_1 * Math.exp(((-t) / tau)))) * ((0.8 * d) * Math.sqrt(Math.sqrt(((6.0 * d) / A)))));
  }
  return _step_force_standard_solid_of_quartic(t, d, A, E_inf, E_1, tau);
};

const step_force_standard_solid = (t, d, A, E_inf, E_1, tau) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < A && A < Infinity) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_standard_solid(t, d, A, E_inf, E_1, tau) : NaN);
};

const creep_standard_solid = (t, E_inf, E_1, tau) => {
  let v4;
  v4 = (E_inf + E_1);
  return ((1.0 / v4) - (((E_1 / v4) * Math.expm1((-((t / tau) * (E_inf / v4))))) / E_inf));
};

const _step_load_radius_standard_solid_of_quartic = (t, F, A, E_inf, E_1, tau) => {
  return _radius_from_force_2((F * creep_standard_solid(t, E_inf, E_1, tau)), A, 1.0);
};

const _step_load_radius_standard_solid = (t, F, A, E_inf, E_1, tau) => {
  let v23, v25, v6;
  if (((t > 1e-30) && (t < 1e+30) && (F > 1e-30) && (F < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_inf > 1e-30) && (E_inf < 1e+30) && (E_1 > 1e-30) && (E_1 < 1e+30) && (tau > 1e-30) && (tau < 1e+30))) {
    v6 = (E_inf + E_1);
    v23 = ((15.0 * (F * ((1.0 / v6) - (((E_1 / v6) * Math.expm1((-((t / tau) * (E_inf / v6))))) / E_inf)))) / (64.0 * A));
    v25 = Math.pow(v23, 0.2);
    if (((v23 > 0.0) && (v23 < Infinity))) {
      return (v25 + (v25 * (((v23 / (Math.pow(v25, 5.0) * Math.pow(v25, 0.0))) - 1.0) / 5.0)));
    }
    return v25;
  }
  return _step_load_radius_standard_solid_of_quartic(t, F, A, E_inf, E_1, tau);
};

const step_load_radius_standard_solid = (t, F, A, E_inf, E_1, tau) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < A && A < Infinity) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_standard_solid(t, F, A, E_inf, E_1, tau) : NaN);
};

const gamma_quotient = (x, y) => {
  let quotient;
  quotient = (x, y) => {
    return ((x < 100.0) ? (math.gamma(x) / math.gamma(y)) : Math.exp((math.lgamma(x) - math.lgamma(y))));
  };
  return math.vectorize(quotient)(x, y);
};

const gamma = (x) => {
  return math.vectorize(math.gamma)(x);
};

const ramp_power_creep = (t, m, E, alpha, t_0) => {
  return (((E * Math.pow((t_0 / t), alpha)) * gamma_quotient((1.0 + m), ((1.0 + m) - alpha))) / gamma((1.0 + alpha)));
};

const _ramp_force_power_creep = (t, v, A, E, alpha, t_0) => {
  let force;
  force = (_force_from_depth((v * t), A, 1.0) * ramp_power_creep(t, 1.25, E, alpha, t_0));
  return ((t === 0.0) ? 0.0 : force);
};

const ramp_force_power_creep = (t, A, v, E, alpha, t_0) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < v && v < Infinity) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _ramp_force_power_creep(t, v, A, E, alpha, t_0) : NaN);
};

const relaxation_power_creep = (t, E, alpha, t_0) => {
  let v8;
  v8 = (3.141592653589793 * alpha);
  return (((E * Math.pow((t_0 / t), alpha)) * Math.sin(v8)) / v8);
};

const _step_force_power_creep_of_quartic = (t, d, A, E, alpha, t_0) => {
  return (relaxation_power_creep(t, E, alpha, t_0) * _force_from_depth_2(d, A, 1.0));
};

const _step_force_power_creep = (t, d, A, E, alpha, t_0) => {
  let v10;
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E > 1e-30) && (E < 1e+30) && (alpha > 1e-30) && (alpha < 1.0) && (t_0 > 1e-30) && (t_0 < 1e+30))) {
    v10 = (3.141592653589793 * alpha);
    return ((((E * Math.pow((t_0 / t), alpha)) * Math.sin(v10)) / v10) * ((0.8 * d) * Math.sqrt(Math.sqrt(((6.0 * d) / A)))));
  }
  return _step_force_power_creep_of_quartic(t, d, A, E, alpha, t_0);
};

const step_force_power_creep = (t, d, A, E, alpha, t_0) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < A && A < Infinity) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_power_creep(t, d, A, E, alpha, t_0) : NaN);
};

const creep_power_creep = (t, E, alpha, t_0) => {
  return (Math.pow((t / t_0), alpha) / E);
};

const _step_load_radius_power_creep_of_quartic = (t, F, A, E, alpha, t_0) => {
  return _radius_from_force_2((F * creep_power_creep(t, E, alpha, t_0)), A, 1.0);
};

const _step_load_radius_power_creep = (t, F, A, E, alpha, t_0) => {
  let v14, v16;
  if (((t > 1e-30) && (t < 1e+30) && (F > 1e-30) && (F < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E > 1e-30) && (E < 1e+30) && (alpha > 1e-30) && (alpha < 1.0) && (t_0 > 1e-30) && (t_0 < 1e+30))) {
    v14 = ((15.0 * (F * (Math.pow((t / t_0), alpha) / E))) / (64.0 * A));
    v16 = Math.pow(v14, 0.2);
    if (((v14 > 0.0) && (v14 < Infinity))) {
      return (v16 + (v16 * (((v14 / (Math.pow(v16, 5.0) * Math.pow(v16, 0.0))) - 1.0) / 5.0)));
    }
    return v16;
  }
  return _step_load_radius_power_creep_of_quartic(t, F, A, E, alpha, t_0);
};

const step_load_radius_power_creep = (t, F, A, E, alpha, t_0) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < A && A < Infinity) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_power_creep(t, F, A, E, alpha, t_0) : NaN);
};

const once = { peak_pressure: math.kept(peak_pressure), pull_off: math.kept(pull_off), pull_off_of_quartic: math.kept(pull_off_of_quartic) };
const formulas = {
  "d": (v) => depth(v.a, v.A),
  "F": (v) => force(v.a, v.A, v.E_star),
  "p": (v) => pressure(v.r, v.a, v.A, v.E_star),
  "w": (v) => displacement(v.r, v.a, v.A),
  "k": (v) => stiffness(v.a, v.A, v.E_star),
  "pm": (v) => mean_pressure(v.a, v.A, v.E_star),
  "U": (v) => energy(v.a, v.A, v.E_star),
  "Fr": (v) => load_within(v.r, v.a, v.A, v.E_star),
  "rp": (v) => (once.peak_pressure(v.a, v.A, v.E_star).radius ?? NaN),
  "pp": (v) => (once.peak_pressure(v.a, v.A, v.E_star).pressure ?? NaN),
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
  "adh.ac": (v) => (once.pull_off('force', v.A, v.E_star, v.dgamma).radius ?? NaN),
  "adh.Fc": (v) => (once.pull_off('force', v.A, v.E_star, v.dgamma).force ?? NaN),
  "adh.dc": (v) => (once.pull_off('force', v.A, v.E_star, v.dgamma).depth ?? NaN),
  "adh.am": (v) => (once.pull_off('depth', v.A, v.E_star, v.dgamma).radius ?? NaN),
  "adh.Fm": (v) => (once.pull_off('depth', v.A, v.E_star, v.dgamma).force ?? NaN),
  "adh.dm": (v) => (once.pull_off('depth', v.A, v.E_star, v.dgamma).depth ?? NaN),
  "tan.F": (v) => tangential_force(v.a, v.c, v.A, v.E_star, v.mu),
  "tan.tau": (v) => traction(v.r, v.a, v.c, v.A, v.E_star, v.mu),
  "tan.u": (v) => tangential_displacement(v.a, v.c, v.A, v.E_star, v.G_star, v.mu),
  "tan.c": (v) => stick_radius(v.F_x, v.a, v.A, v.E_star, v.mu),
  "tan.us": (v) => full_slip_displacement(v.a, v.A, v.E_star, v.G_star, v.mu),
  "fgm.d": (v) => depth_2(v.a, v.A, v.k),
  "fgm.F": (v) => force_2(v.a, v.A, v.H, v.k),
  "fgm.p": (v) => pressure_2(v.r, v.a, v.A, v.H, v.k),
  "fgm.w": (v) => displacement_2(v.r, v.a, v.A, v.k),
  "fgm.k": (v) => stiffness_of_quartic(v.a, v.A, v.H, v.k),
  "fgm.pm": (v) => mean_pressure_of_quartic(v.a, v.A, v.H, v.k),
  "fgm.ad": (v) => radius_from_depth_2(v.d, v.A, v.k),
  "fgm.aF": (v) => radius_from_force_2(v.F, v.A, v.H, v.k),
  "fgm.Fd": (v) => force_from_depth_of_quartic(v.d, v.A, v.H, v.k),
  "fgm.dF": (v) => depth_from_force_of_quartic(v.F, v.A, v.H, v.k),
  "fgm.adh.Dl": (v) => retraction_of_quartic(v.a, v.H, v.k, v.dgamma),
  "fgm.adh.d": (v) => depth_3(v.a, v.A, v.H, v.k, v.dgamma),
  "fgm.adh.F": (v) => force_3(v.a, v.A, v.H, v.k, v.dgamma),
  "fgm.adh.p": (v) => pressure_3(v.r, v.a, v.A, v.H, v.k, v.dgamma),
  "fgm.adh.w": (v) => displacement_3(v.r, v.a, v.A, v.H, v.k, v.dgamma),
  "fgm.adh.ad": (v) => radius_from_depth_3(v.d, v.A, v.H, v.k, v.dgamma),
  "fgm.adh.aF": (v) => radius_from_force_3(v.F, v.A, v.H, v.k, v.dgamma),
  "fgm.adh.ac": (v) => (once.pull_off_of_quartic('force', v.A, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fc": (v) => (once.pull_off_of_quartic('force', v.A, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dc": (v) => (once.pull_off_of_quartic('force', v.A, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.adh.am": (v) => (once.pull_off_of_quartic('depth', v.A, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fm": (v) => (once.pull_off_of_quartic('depth', v.A, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dm": (v) => (once.pull_off_of_quartic('depth', v.A, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.tan.F": (v) => tangential_force_of_quartic(v.a, v.c, v.A, v.H, v.k, v.mu),
  "fgm.tan.tau": (v) => traction_of_quartic(v.r, v.a, v.c, v.A, v.H, v.k, v.mu),
  "fgm.tan.u": (v) => tangential_displacement_of_quartic(v.a, v.c, v.A, v.H, v.H_x, v.k, v.mu),
  "fgm.tan.c": (v) => stick_radius_of_quartic(v.F_x, v.a, v.A, v.H, v.k, v.mu),
  "fgm.tan.us": (v) => full_slip_displacement_of_quartic(v.a, v.A, v.H, v.H_x, v.k, v.mu),
  "vis.ramp_mx": (v) => ramp_force_maxwell(v.t, v.A, v.v, v.E_law, v.tau),
  "vis.step_mx": (v) => step_force_maxwell(v.t, v.d, v.A, v.E_law, v.tau),
  "vis.load_mx": (v) => step_load_radius_maxwell(v.t, v.F, v.A, v.E_law, v.tau),
  "vis.ramp_kv": (v) => ramp_force_kelvin_voigt(v.t, v.A, v.v, v.E_law, v.eta),
  "vis.step_kv": (v) => step_force_kelvin_voigt(v.t, v.d, v.A, v.E_law, v.eta),
  "vis.load_kv": (v) => step_load_radius_kelvin_voigt(v.t, v.F, v.A, v.E_law, v.eta),
  "vis.ramp_sls": (v) => ramp_force_standard_solid(v.t, v.A, v.v, v.E_inf, v.E_1, v.tau),
  "vis.step_sls": (v) => step_force_standard_solid(v.t, v.d, v.A, v.E_inf, v.E_1, v.tau),
  "vis.load_sls": (v) => step_load_radius_standard_solid(v.t, v.F, v.A, v.E_inf, v.E_1, v.tau),
  "vis.ramp_pc": (v) => ramp_force_power_creep(v.t, v.A, v.v, v.E_law, v.alpha, v.t_0),
  "vis.step_pc": (v) => step_force_power_creep(v.t, v.d, v.A, v.E_law, v.alpha, v.t_0),
  "vis.load_pc": (v) => step_load_radius_power_creep(v.t, v.F, v.A, v.E_law, v.alpha, v.t_0),
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
   "name": "v",
   "tex": "v",
   "meaning": "speed of indentation",
   "unit": "m/s",
   "rule": "v > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 1e-05
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
   "suffix": "d",
   "medium": 0
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
   "suffix": "F",
   "medium": 0
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
   "suffix": "p",
   "medium": 0
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
   "suffix": "w",
   "medium": 0
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
   "suffix": "k",
   "medium": 0
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
   "suffix": "pm",
   "medium": 0
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
   "suffix": "U",
   "medium": 0
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
   "suffix": "Fr",
   "medium": 0
  },
  "rp": {
   "gives": "r_peak",
   "needs": [
    "a",
    "A",
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
    "A",
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
    "A"
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
    "A",
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
  "vis.ramp_mx": {
   "gives": "F",
   "needs": [
    "t",
    "A",
    "v",
    "E_law",
    "tau"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "vis.step_mx": {
   "gives": "F",
   "needs": [
    "t",
    "d",
    "A",
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
    "A",
    "E_law",
    "tau"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "vis.ramp_kv": {
   "gives": "F",
   "needs": [
    "t",
    "A",
    "v",
    "E_law",
    "eta"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "vis.step_kv": {
   "gives": "F",
   "needs": [
    "t",
    "d",
    "A",
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
    "A",
    "E_law",
    "eta"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "vis.ramp_sls": {
   "gives": "F",
   "needs": [
    "t",
    "A",
    "v",
    "E_inf",
    "E_1",
    "tau"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "vis.step_sls": {
   "gives": "F",
   "needs": [
    "t",
    "d",
    "A",
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
    "A",
    "E_inf",
    "E_1",
    "tau"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "vis.ramp_pc": {
   "gives": "F",
   "needs": [
    "t",
    "A",
    "v",
    "E_law",
    "alpha",
    "t_0"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "vis.step_pc": {
   "gives": "F",
   "needs": [
    "t",
    "d",
    "A",
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
    "A",
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
