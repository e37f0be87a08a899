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

const _load = (a, theta, b, E_star) => {
  let v12, v17, v6;
  v6 = Math.tan(theta);
  v12 = (a * a);
  if ((a < b)) {
    return ((((3.141592653589793 * E_star) * v6) / (4.0 * b)) * v12);
  }
  v17 = math.sqrt(((a - b) * (a + b)));
  return (((E_star * v6) * (v17 + ((v12 * Math.atan((b / v17))) / b))) / 2.0);
};

const load = (a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _load(a, theta, b, E_star) : NaN);
};

const RULE_0 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _growth_beyond = (t, root, theta, b) => {
  let angle;
  angle = Math.atan((b / root));
  return (((Math.tan(theta) / b) * t) * angle);
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
  [outside, reach] = [(math.truth(within) ? 0.0 : 1.0), difference_root(a, b)];
  stop = Math.asinh(((math.truth(within) ? reach : difference_root(a, r)) / Math.sqrt((Math.abs((r - b)) * (r + b)))));
  fallen = falling(stop, outside);
  integrand = (v) => {
    let root, t;
    root = (reach * fallen(v));
    t = Math.sqrt(((b * b) + (root * root)));
    return ((slope(t, root) * root) / t);
  };
  return [integrand, stop, 1.0, (a > math.maximum(r, b)), 0.0];
});

const _pressure_of_rounded_wedge = (x, a, theta, b, E_star) => {
  let beyond, inner, root, tip, value;
  inner = math.minimum(a, b);
  root = Math.sqrt(((inner - x) * (inner + x)));
  tip = (((E_star * Math.tan(theta)) / (2 * b)) * root);
  beyond = pressure_integral_beyond(_growth_beyond, [theta, b], x, a, b);
  value = (math.where((x < inner), tip, 0.0) + ((E_star / Math.PI) * beyond));
  return math.where((x < a), value, 0.0);
};

const _pressure = (x, a, theta, b, E_star) => {
  let node, v10, v19, v20, v24, v28, v29, v34, v41, v42, v43, v48, v5, v50, v53, v63, v64, v67, v70, v74, v75, v76, weight;
  if (((x > 1e-30) && (x < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((x < a)) {
      v5 = (((a < b) || (a !== a)) ? a : b);
      v10 = Math.tan(theta);
      v19 = ((x === b) ? math.nextafter(b, Infinity) : x);
      if ((a > (((v19 > b) || (v19 !== v19)) ? v19 : b))) {
        v20 = (v19 < b);
        v24 = (a - b);
        v28 = Math.sqrt(((((v24 > 0.0) || (v24 !== v24)) ? v24 : 0.0) * (a + b)));
        if (v20) {
          v34 = v28;
        } else {
          v29 = (a - v19);
          v34 = Math.sqrt(((((v29 > 0.0) || (v29 !== v29)) ? v29 : 0.0) * (a + v19)));
        }
        v41 = Math.asinh((v34 / Math.sqrt((Math.abs((v19 - b)) * (v19 + b)))));
        v42 = (2.0 * (math.truth(v20) ? 0.0 : 1.0));
        v43 = (1.0 - v42);
        v48 = (v42 - (v43 * Math.expm1(((-2.0) * v41))));
        v50 = ((v48 > 0.0) ? v48 : Infinity);
        v64 = (b * b);
        v70 = (v10 / b);
        v75 = [];
        for ([node, weight] of RULE_0((v41 / 1.0))) {
          v53 = (node * v41);
          v63 = (v28 * ((Math.exp((-v53)) * (v42 - (v43 * Math.expm1(((-2.0) * (v41 - v53)))))) / v50));
          v67 = Math.sqrt((v64 + (v63 * v63)));
          v74 = ((((v70 * v67) * Math.atan((b / v63))) * v63) / v67);
          v75.push((weight * v74));
        }
        v75 = (math.fsum(v75) * v41);
        v76 = v75;
      } else {
        v76 = 0.0;
      }
      return (((x < v5) ? (((E_star * v10) / (2.0 * b)) * Math.sqrt(((v5 - x) * (v5 + x)))) : 0.0) + ((E_star / 3.141592653589793) * v76));
    }
    return 0.0;
  }
  return _pressure_of_rounded_wedge(x, a, theta, b, E_star);
};

const pressure = (x, a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((Math.abs(x) >= 0.0) && (a >= 0.0)) ? ((Math.abs(x) < Infinity) ? _pressure(Math.abs(x), a, theta, b, E_star) : 0.0) : NaN);
};

const FADED = 42.0;

const _beyond = (x, edge, far, b) => {
  let end, fallen, place, ratio, stop, widest;
  [ratio, end] = [(b / x), (edge / far)];
  [stop, widest] = [Math.asinh((end / ratio)), Math.sqrt((1.0 + (end * end)))];
  fallen = falling(stop);
  stop = math.minimum(stop, (FADED + Math.asinh(end)));
  place = (v) => {
    let narrowed, part, root, square, t;
    part = fallen(v);
    square = (1.0 + ((end * part) * (end * part)));
    narrowed = (widest / Math.sqrt(square));
    root = ((edge * part) * narrowed);
    t = Math.sqrt(((b * b) + (root * root)));
    return [t, root, narrowed, ((root / t) * (Math.sqrt((Math.pow((ratio / end), 2) + (part * part))) / square))];
  };
  return [stop, place];
};

const slope_beyond = math.in_groups((growth, x, a, b) => {
  let edge, far, integrand, place, stop;
  [edge, far] = [difference_root(a, b), difference_root(x, a)];
  [stop, place] = _beyond(x, edge, far, b);
  integrand = (v) => {
    let _, root, stretch, t;
    [t, root, _, stretch] = place(v);
    return (growth(t, root) * stretch);
  };
  return [integrand, stop, (edge / far), (a > b), 0.0];
});

const _profile_slope = (x, theta, b) => {
  return math.where((x > b), Math.tan(theta), ((Math.tan(theta) / b) * x));
};

const _slope_of_rounded_wedge = (x, a, theta, b) => {
  let beyond, conjugate, inner, root, tip, value;
  inner = math.minimum(a, b);
  root = Math.sqrt(((x - inner) * (inner + x)));
  conjugate = (root + x);
  tip = (((-Math.tan(theta)) * Math.pow(inner, 2)) / (b * conjugate));
  beyond = slope_beyond(_growth_beyond, [theta, b], x, a, b);
  value = (tip - ((2 / Math.PI) * beyond));
  return math.where((x > a), value, (-_profile_slope(x, theta, b)));
};

const _slope = (x, a, theta, b) => {
  let node, v10, v17, v22, v23, v28, v29, v31, v35, v39, v4, v42, v45, v46, v48, v56, v57, v59, v63, v64, v67, v69, v70, v78, v81, v82, v84, weight;
  if (((x > 1e-30) && (x < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30))) {
    v10 = Math.tan(theta);
    v78 = (v10 / b);
    if ((x > a)) {
      v4 = (((a < b) || (a !== a)) ? a : b);
      if ((a > b)) {
        v17 = (a - b);
        v22 = Math.sqrt(((((v17 > 0.0) || (v17 !== v17)) ? v17 : 0.0) * (a + b)));
        v23 = (x - a);
        v28 = (b / x);
        v29 = (v22 / Math.sqrt(((((v23 > 0.0) || (v23 !== v23)) ? v23 : 0.0) * (x + a))));
        v31 = Math.asinh((v29 / v28));
        v35 = Math.sqrt((1.0 + (v29 * v29)));
        v39 = (0.0 - Math.expm1(((-2.0) * v31)));
        v42 = ((v39 > 0.0) ? v39 : Infinity);
        v45 = (42.0 + Math.asinh(v29));
        v46 = (((v31 < v45) || (v31 !== v31)) ? v31 : v45);
        v64 = (b * b);
        v69 = (v28 / v29);
        v70 = (v69 * v69);
        v82 = [];
        for ([node, weight] of RULE_0((v46 / 1.0))) {
          v48 = (node * v46);
          v56 = ((Math.exp((-v48)) * (0.0 - Math.expm1(((-2.0) * (v31 - v48))))) / v42);
          v57 = (v29 * v56);
          v59 = (1.0 + (v57 * v57));
          v63 = ((v22 * v56) * (v35 / Math.sqrt(v59)));
          v67 = Math.sqrt((v64 + (v63 * v63)));
          v81 = (((v78 * v67) * Math.atan((b / v63))) * ((v63 / v67) * (Math.sqrt((v70 + (v56 * v56))) / v59)));
          v82.push((weight * v81));
        }
        v82 = (math.fsum(v82) * v46);
        v84 = (v29 * v82);
      } else {
        v84 = 0.0;
      }
      return ((((-v10) * (v4 * v4)) / (b * (Math.sqrt(((x - v4) * (v4 + x))) + x))) - (0.6366197723675814 * v84));
    }
    return (-((x > b) ? v10 : (v78 * x)));
  }
  return _slope_of_rounded_wedge(x, a, theta, b);
};

const slope = (x, a, theta, b) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity)))) {
    return NaN;
  }
  return (((((Math.abs(x) >= 0.0) && (a >= 0.0)) ? ((Math.abs(x) < Infinity) ? _slope(Math.abs(x), a, theta, b) : 0.0) : NaN) * ((x < 0.0) ? -1.0 : 1.0)) + 0.0);
};

const depth_beyond = math.in_groups((growth, L, a, b) => {
  let edge, far, integrand, place, stop;
  [edge, far] = [difference_root(a, b), difference_root(L, a)];
  [stop, place] = _beyond(L, edge, far, b);
  integrand = (v) => {
    let narrowed, root, stretch, t;
    [t, root, narrowed, stretch] = place(v);
    return (((growth(t, root) * stretch) * narrowed) * Math.asinh(((far * narrowed) / t)));
  };
  return [integrand, stop, edge, (a > b), 0.0];
});

const _profile = (x, theta, b) => {
  return math.where((x > b), (Math.tan(theta) * (x - (b / 2))), ((Math.tan(theta) / (2 * b)) * Math.pow(x, 2)));
};

const _depth_of_rounded_wedge = (L, a, theta, b) => {
  let beyond, inner, root, tip, value;
  inner = math.minimum(a, b);
  root = Math.sqrt(((L - inner) * (inner + L)));
  tip = (((Math.tan(theta) / (2 * b)) * Math.pow(inner, 2)) * ((L / (root + L)) + Math.log1p((((L - inner) + root) / inner))));
  beyond = depth_beyond(_growth_beyond, [theta, b], L, a, b);
  value = (tip + ((2 / Math.PI) * beyond));
  value = math.where((a < L), value, _profile(a, theta, b));
  value = math.where((a > 0.0), value, 0.0);
  return math.where((a <= L), value, NaN);
};

const _depth = (L, a, theta, b) => {
  let node, v12, v22, v27, v28, v32, v33, v34, v36, v4, v40, v44, v47, v5, v50, v51, v52, v53, v61, v62, v64, v66, v68, v69, v72, v74, v75, v8, v83, v9, v91, v92, v94, weight;
  if (((L > 1e-30) && (L < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30))) {
    if ((a <= L)) {
      if ((a > 0.0)) {
        v9 = Math.tan(theta);
        v12 = (v9 / (2.0 * b));
        v52 = (a > b);
        if ((a < L)) {
          v4 = (((a < b) || (a !== a)) ? a : b);
          v5 = (L - v4);
          v8 = Math.sqrt((v5 * (v4 + L)));
          if (v52) {
            v22 = (a - b);
            v27 = Math.sqrt(((((v22 > 0.0) || (v22 !== v22)) ? v22 : 0.0) * (a + b)));
            v28 = (L - a);
            v32 = Math.sqrt(((((v28 > 0.0) || (v28 !== v28)) ? v28 : 0.0) * (L + a)));
            v33 = (b / L);
            v34 = (v27 / v32);
            v36 = Math.asinh((v34 / v33));
            v40 = Math.sqrt((1.0 + (v34 * v34)));
            v44 = (0.0 - Math.expm1(((-2.0) * v36)));
            v47 = ((v44 > 0.0) ? v44 : Infinity);
            v50 = (42.0 + Math.asinh(v34));
            v51 = (((v36 < v50) || (v36 !== v36)) ? v36 : v50);
            v69 = (b * b);
            v74 = (v33 / v34);
            v75 = (v74 * v74);
            v83 = (v9 / b);
            v92 = [];
            for ([node, weight] of RULE_0((v51 / 1.0))) {
              v53 = (node * v51);
              v61 = ((Math.exp((-v53)) * (0.0 - Math.expm1(((-2.0) * (v36 - v53))))) / v47);
              v62 = (v34 * v61);
              v64 = (1.0 + (v62 * v62));
              v66 = (v40 / Math.sqrt(v64));
              v68 = ((v27 * v61) * v66);
              v72 = Math.sqrt((v69 + (v68 * v68)));
              v91 = (((((v83 * v72) * Math.atan((b / v68))) * ((v68 / v72) * (Math.sqrt((v75 + (v61 * v61))) / v64))) * v66) * Math.asinh(((v32 * v66) / v72)));
              v92.push((weight * v91));
            }
            v92 = (math.fsum(v92) * v51);
            v94 = (v27 * v92);
          } else {
            v94 = 0.0;
          }
          return (((v12 * (v4 * v4)) * ((L / (v8 + L)) + Math.log1p(((v5 + v8) / v4)))) + (0.6366197723675814 * v94));
        }
        if (v52) {
          return (v9 * (a - (b / 2.0)));
        }
        return (v12 * (a * a));
      }
      return 0.0;
    }
    return NaN;
  }
  return _depth_of_rounded_wedge(L, a, theta, b);
};

const depth = (L, a, theta, b) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity)))) {
    return NaN;
  }
  return (((L >= 0.0) && (a >= 0.0)) ? _depth(L, a, theta, b) : NaN);
};

const _growth = (t, theta, b) => {
  return (((3.141592653589793 * Math.tan(theta)) / (2.0 * b)) * t);
};

const _growth_beyond_of_rounded_wedge = (t, root, theta, b) => {
  return (((Math.tan(theta) / b) * t) * Math.atan((b / root)));
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

const _half_width_from_load = (P, theta, b, E_star) => {
  let curve;
  curve = (a) => {
    let growth, root, value;
    root = Math.sqrt(((a - b) * (a + b)));
    growth = ((a < b) ? _growth(a, theta, b) : _growth_beyond_of_rounded_wedge(a, root, theta, b));
    value = _load(a, theta, b, E_star);
    return [value, (((E_star * a) * growth) / value)];
  };
  return inverse(curve, P, math.full(P, (0.99 * b)), [1.0, 2.0]);
};

const half_width_from_load = (P, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((P >= 0.0) ? _half_width_from_load(P, theta, b, E_star) : NaN);
};

const once = {  };
const formulas = {
  "P": (v) => load(v.a, v.theta, v.b, v.E_star),
  "p": (v) => pressure(v.x, v.a, v.theta, v.b, v.E_star),
  "s": (v) => slope(v.x, v.a, v.theta, v.b),
  "d": (v) => depth(v.L, v.a, v.theta, v.b),
  "aP": (v) => half_width_from_load(v.P, v.theta, v.b, v.E_star),
};
window.calculator = { ...{
 "fields": [
  {
   "name": "theta",
   "tex": "\\theta",
   "meaning": "inclination of the flank to the surface",
   "unit": "rad",
   "rule": "0 < theta < pi/2",
   "low": 0.0,
   "high": 1.5707963267948966,
   "closed": "",
   "value": 0.01
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
   "value": 5e-05
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
   "value": 100000.0
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
  "P": {
   "gives": "P",
   "needs": [
    "a",
    "theta",
    "b",
    "E_star"
   ],
   "unit": "N/m",
   "place": "",
   "suffix": "P",
   "medium": 0
  },
  "p": {
   "gives": "p",
   "needs": [
    "x",
    "a",
    "theta",
    "b",
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
    "a",
    "theta",
    "b"
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
    "a",
    "theta",
    "b"
   ],
   "unit": "m",
   "place": "",
   "suffix": "d",
   "medium": 0
  },
  "aP": {
   "gives": "a",
   "needs": [
    "P",
    "theta",
    "b",
    "E_star"
   ],
   "unit": "m",
   "place": "",
   "suffix": "aP",
   "medium": 0
  }
 },
 "place": "x"
}, evaluate: formulas };
})();
