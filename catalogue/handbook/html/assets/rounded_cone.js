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

const _depth = (a, theta, b) => {
  let v11, v3;
  v3 = Math.tan(theta);
  if ((a < b)) {
    return ((v3 / b) * (a * a));
  }
  v11 = math.sqrt(((a - b) * (a + b)));
  return ((v3 * a) * (Math.atan((v11 / b)) + (b / (v11 + a))));
};

const depth = (a, theta, b) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth(a, theta, b) : NaN);
};

const _force = (a, theta, b, E_star) => {
  let v12, v18, v6;
  v6 = Math.tan(theta);
  v12 = (a * a);
  if ((a < b)) {
    return ((((4.0 * E_star) * v6) / (3.0 * b)) * (a * v12));
  }
  v18 = math.sqrt(((a - b) * (a + b)));
  return ((E_star * v6) * (((v12 * Math.atan((v18 / b))) + (((4.0 * b) * v12) / (3.0 * (v18 + a)))) + ((b / 3.0) * v18)));
};

const force = (a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force(a, theta, b, E_star) : NaN);
};

const RULE_0 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _slope_beyond = (t, root, theta, b) => {
  let angle;
  angle = Math.atan((root / b));
  return (Math.tan(theta) * (angle + ((2 * b) / (root + t))));
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

const _pressure_of_rounded_cone = (r, a, theta, b, E_star) => {
  let growth, inner, root, tip;
  inner = math.minimum(a, b);
  root = Math.sqrt(((inner - r) * (inner + r)));
  tip = math.where((r < inner), ((((2 * E_star) * Math.tan(theta)) / (Math.PI * b)) * root), 0.0);
  growth = pressure_integral_beyond(_slope_beyond, [theta, b], r, a, b);
  return math.where((r < a), (tip + ((E_star / Math.PI) * growth)), 0.0);
};

const _pressure = (r, a, theta, b, E_star) => {
  let node, v13, v24, v25, v28, v32, v33, v38, v45, v46, v47, v5, v52, v54, v57, v67, v68, v71, v74, v80, v81, v82, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((r < a)) {
      v5 = (((a < b) || (a !== a)) ? a : b);
      v13 = Math.tan(theta);
      v24 = ((r === b) ? math.nextafter(b, Infinity) : r);
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
        v46 = (2.0 * (math.truth(v25) ? 0.0 : 1.0));
        v47 = (1.0 - v46);
        v52 = (v46 - (v47 * Math.expm1(((-2.0) * v45))));
        v54 = ((v52 > 0.0) ? v52 : Infinity);
        v68 = (b * b);
        v74 = (2.0 * b);
        v81 = [];
        for ([node, weight] of RULE_0((v45 / 1.0))) {
          v57 = (node * v45);
          v67 = (v32 * ((Math.exp((-v57)) * (v46 - (v47 * Math.expm1(((-2.0) * (v45 - v57)))))) / v54));
          v71 = Math.sqrt((v68 + (v67 * v67)));
          v80 = (((v13 * (Math.atan((v67 / b)) + (v74 / (v67 + v71)))) * v67) / v71);
          v81.push((weight * v80));
        }
        v81 = (math.fsum(v81) * v45);
        v82 = v81;
      } else {
        v82 = 0.0;
      }
      return (((r < v5) ? ((((2.0 * E_star) * v13) / (3.141592653589793 * b)) * Math.sqrt(((v5 - r) * (v5 + r)))) : 0.0) + ((E_star / 3.141592653589793) * v82));
    }
    return 0.0;
  }
  return _pressure_of_rounded_cone(r, a, theta, b, E_star);
};

const pressure = (r, a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure(r, a, theta, b, E_star) : 0.0) : NaN);
};

const RULE_0_of_rounded_cone = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _displacement = (r, a, theta, b) => {
  let node, v10, v11, v12, v14, v153, v162, v17, v22, v24, v29, v32, v34, v4, v43, v44, v46, v48, v49, v5, v52, v53, v61, v63, v73, v74, v76, v88, v90, weight;
  v12 = (a - b);
  v14 = (a + b);
  v61 = Math.tan(theta);
  v63 = (2.0 * b);
  if ((r > a)) {
    v4 = (((a < b) || (a !== a)) ? a : b);
    if ((a > b)) {
      v5 = (r - b);
      v10 = math.sqrt(((((v5 > 0.0) || (v5 !== v5)) ? v5 : 0.0) * (r + b)));
      v11 = (b / r);
      v17 = (r - a);
      v22 = (math.sqrt(((((v12 > 0.0) || (v12 !== v12)) ? v12 : 0.0) * v14)) / math.sqrt(((((v17 > 0.0) || (v17 !== v17)) ? v17 : 0.0) * (r + a))));
      v24 = Math.asinh((v22 / v11));
      v29 = (0.0 - Math.expm1(((-2.0) * v24)));
      v32 = ((v29 > 0.0) ? v29 : Infinity);
      v49 = (b * b);
      v53 = (v11 * v11);
      v74 = [];
      for ([node, weight] of RULE_0_of_rounded_cone((v24 / 1.0))) {
        v34 = (node * v24);
        v43 = (v22 * ((Math.exp((-v34)) * (0.0 - Math.expm1(((-2.0) * (v24 - v34))))) / v32));
        v44 = (v43 * v43);
        v46 = math.sqrt((1.0 + v44));
        v48 = ((v10 * v43) / v46);
        v52 = math.sqrt((v49 + (v48 * v48)));
        v73 = (((((v61 * (Math.atan((v48 / b)) + (v63 / (v48 + v52)))) * v48) / v52) * Math.atan2(v52, (v10 / v46))) * (math.sqrt((v53 + v44)) / ((v46 * v46) * v46)));
        v74.push((weight * v73));
      }
      v74 = (math.fsum(v74) * v24);
      v76 = (v10 * v74);
    } else {
      v76 = 0.0;
    }
    v88 = (v4 / (r + math.sqrt(((r - v4) * (r + v4)))));
    v90 = (v88 * v88);
    return (((((2.0 * v61) / (3.141592653589793 * b)) * (v4 * v4)) * ((v4 / r) * (0.6666666666666666 + (v90 * ((((((((((((((((((-0.7327347664453868) * v90) + (-32.15553480435792)) * v90) + (-332.23363563146734)) * v90) + (-1070.7082873491413)) * v90) + (-85.27694715374247)) * v90) + 5044.821368830373) * v90) + 8082.413158212496) * v90) + 3759.725330928701) * v90) + 0.26666666666720995) / ((((((((((((((((0.21387262524856868 * v90) + 32.12935731379798) * v90) + 746.8124983579742) * v90) + 6202.125133759036) * v90) + 23553.080984642995) * v90) + 44404.005348491315) * v90) + 40380.01430284195) * v90) + 14099.684276696918) * v90) + 1.0)))))) + (0.6366197723675814 * v76));
  }
  if ((a < b)) {
    v162 = ((v61 / b) * (a * a));
  } else {
    v153 = math.sqrt((v12 * v14));
    v162 = ((v61 * a) * (Math.atan((v153 / b)) + (b / (v153 + a))));
  }
  return (v162 - ((r < b) ? ((v61 / v63) * (r * r)) : (v61 * (r - (b / 2.0)))));
};

const displacement = (r, a, theta, b) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement(r, a, theta, b) : 0.0) : NaN);
};

const _stiffness_of_rounded_cone = (a, E_star) => {
  return ((2 * E_star) * a);
};

const _stiffness = (a, E_star, theta = 0.7853981633974483, b = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30))) {
    return ((2.0 * E_star) * a);
  }
  return _stiffness_of_rounded_cone(a, E_star);
};

const stiffness = (a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness(a, E_star) : NaN);
};

const _mean_pressure_of_rounded_cone = (a, theta, b, E_star) => {
  let angle, beyond, root, tip;
  tip = ((((4 * E_star) * Math.tan(theta)) / ((3 * Math.PI) * b)) * a);
  root = Math.sqrt(((a - b) * (a + b)));
  angle = Math.atan((root / b));
  beyond = (((E_star * Math.tan(theta)) / Math.PI) * ((angle + ((4 * b) / (3 * (root + a)))) + ((b * root) / (3 * Math.pow(a, 2)))));
  return math.where((a < b), tip, beyond);
};

const _mean_pressure = (a, theta, b, E_star) => {
  let v15, v6;
  if (((a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v6 = Math.tan(theta);
    if ((a < b)) {
      return ((((4.0 * E_star) * v6) / (9.42477796076938 * b)) * a);
    }
    v15 = Math.sqrt(((a - b) * (a + b)));
    return (((E_star * v6) / 3.141592653589793) * ((Math.atan((v15 / b)) + ((4.0 * b) / (3.0 * (v15 + a)))) + ((b * v15) / (3.0 * (a * a)))));
  }
  return _mean_pressure_of_rounded_cone(a, theta, b, E_star);
};

const mean_pressure = (a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure(a, theta, b, E_star) : NaN);
};

const _depth_of_rounded_cone = (a, theta, b) => {
  let angle, beyond, root, tip;
  tip = ((Math.tan(theta) / b) * Math.pow(a, 2));
  root = Math.sqrt(((a - b) * (a + b)));
  angle = Math.atan((root / b));
  beyond = ((Math.tan(theta) * a) * (angle + (b / (root + a))));
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

const _depth_beyond = (a, root, theta, b) => {
  let angle;
  angle = Math.atan((root / b));
  return ((Math.tan(theta) * a) * (angle + (b / (root + a))));
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

const _energy_of_rounded_cone = (a, theta, b, E_star) => {
  let beyond, inner, sunk, tip;
  sunk = _depth_of_rounded_cone(a, theta, b);
  inner = math.minimum(a, b);
  tip = energy_integral(_depth_of_rounded_cone, [theta, b], inner, sunk, inner);
  beyond = energy_integral_beyond(_depth_beyond, [theta, b], a, sunk, b);
  return (E_star * (tip + beyond));
};

const _energy = (a, theta, b, E_star) => {
  let node, v10, v100, v102, v103, v104, v12, v21, v22, v24, v30, v33, v34, v4, v43, v49, v5, v58, v59, v61, v65, v66, v70, v72, v75, v77, v79, v88, v89, v9, v92, weight;
  if (((a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v4 = Math.tan(theta);
    v5 = (v4 / b);
    v9 = (a - b);
    v10 = (a + b);
    if ((a < b)) {
      v21 = (v5 * (a * a));
    } else {
      v12 = Math.sqrt((v9 * v10));
      v21 = ((v4 * a) * (Math.atan((v12 / b)) + (b / (v12 + a))));
    }
    v22 = (((a < b) || (a !== a)) ? a : b);
    v24 = Math.asinh((v22 / v22));
    v30 = (0.0 - Math.expm1(((-2.0) * v24)));
    v33 = ((v30 > 0.0) ? v30 : Infinity);
    v61 = (v22 * v22);
    v66 = [];
    for ([node, weight] of RULE_0((v24 / 1.0))) {
      v34 = (node * v24);
      v43 = (v22 * ((Math.exp((-v34)) * (0.0 - Math.expm1(((-2.0) * (v24 - v34))))) / v33));
      if ((v43 < b)) {
        v58 = (v5 * (v43 * v43));
      } else {
        v49 = Math.sqrt(((v43 - b) * (v43 + b)));
        v58 = ((v4 * v43) * (Math.atan((v49 / b)) + (b / (v49 + v43))));
      }
      v59 = (v21 - v58);
      v65 = ((v59 * v59) * Math.sqrt((v61 + (v43 * v43))));
      v66.push((weight * v65));
    }
    v66 = (math.fsum(v66) * v24);
    if ((a > b)) {
      v70 = Math.sqrt(((((v9 > 0.0) || (v9 !== v9)) ? v9 : 0.0) * v10));
      v72 = Math.asinh((v70 / b));
      v75 = (0.0 - Math.expm1(((-2.0) * v72)));
      v77 = ((v75 > 0.0) ? v75 : Infinity);
      v89 = (b * b);
      v103 = [];
      for ([node, weight] of RULE_0((v72 / 1.0))) {
        v79 = (node * v72);
        v88 = (v70 * ((Math.exp((-v79)) * (0.0 - Math.expm1(((-2.0) * (v72 - v79))))) / v77));
        v92 = Math.sqrt((v89 + (v88 * v88)));
        v100 = (v21 - ((v4 * v92) * (Math.atan((v88 / b)) + (b / (v88 + v92)))));
        v102 = ((v100 * v100) * v88);
        v103.push((weight * v102));
      }
      v103 = (math.fsum(v103) * v72);
      v104 = v103;
    } else {
      v104 = 0.0;
    }
    return (E_star * (v66 + v104));
  }
  return _energy_of_rounded_cone(a, theta, b, E_star);
};

const energy = (a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _energy(a, theta, b, E_star) : NaN);
};

const _slope = (t, theta, b) => {
  return (((2 * Math.tan(theta)) / b) * t);
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

const _force_of_rounded_cone = (a, theta, b, E_star) => {
  let angle, beyond, root, tip;
  tip = ((((4 * E_star) * Math.tan(theta)) / (3 * b)) * math.raised(a, 3));
  root = Math.sqrt(((a - b) * (a + b)));
  angle = Math.atan((root / b));
  beyond = ((E_star * Math.tan(theta)) * (((Math.pow(a, 2) * angle) + (((4 * b) * Math.pow(a, 2)) / (3 * (root + a)))) + ((b / 3) * root)));
  return math.where((a < b), tip, beyond);
};

const _load_within_of_rounded_cone = (r, a, theta, b, E_star) => {
  let beyond, inner, tip;
  inner = math.minimum(a, b);
  tip = load_within_integral(_slope, [theta, b], math.minimum(r, inner), inner);
  beyond = load_within_integral_beyond(_slope_beyond, [theta, b], r, a, b);
  return (_force_of_rounded_cone(math.minimum(r, a), theta, b, E_star) + ((2 * E_star) * (tip + beyond)));
};

const _load_within = (r, a, theta, b, E_star) => {
  let node, v100, v105, v106, v109, v112, v12, v121, v122, v124, v125, v132, v138, v14, v154, v19, v22, v23, v25, v34, v37, v38, v41, v45, v46, v48, v5, v51, v52, v53, v54, v58, v59, v6, v63, v7, v71, v72, v73, v75, v77, v79, v81, v82, v84, v86, v90, v92, v95, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v5 = (((a < b) || (a !== a)) ? a : b);
    v6 = (((r < v5) || (r !== r)) ? r : v5);
    v38 = Math.tan(theta);
    if ((v6 > 0.0)) {
      v7 = (v5 - v6);
      v12 = Math.sqrt(((((v7 > 0.0) || (v7 !== v7)) ? v7 : 0.0) * (v5 + v6)));
      v14 = Math.asinh((v12 / v6));
      v19 = (0.0 - Math.expm1(((-2.0) * v14)));
      v22 = ((v19 > 0.0) ? v19 : Infinity);
      v23 = (v6 * v6);
      v41 = ((2.0 * v38) / b);
      v46 = [];
      for ([node, weight] of RULE_0((v14 / 1.0))) {
        v25 = (node * v14);
        v34 = (v12 * ((Math.exp((-v25)) * (0.0 - Math.expm1(((-2.0) * (v14 - v25))))) / v22));
        v37 = Math.sqrt((v23 + (v34 * v34)));
        v45 = ((v41 * v37) * (v34 / (v37 + v34)));
        v46.push((weight * v45));
      }
      v46 = (math.fsum(v46) * v14);
      v48 = (v23 * v46);
    } else {
      v48 = 0.0;
    }
    v51 = ((r === b) ? math.nextafter(b, Infinity) : r);
    if ((a > (((v51 > b) || (v51 !== v51)) ? v51 : b))) {
      v52 = (v51 < b);
      v53 = (math.truth(v52) ? 0.0 : 1.0);
      v54 = (a - b);
      v58 = Math.sqrt(((((v54 > 0.0) || (v54 !== v54)) ? v54 : 0.0) * (a + b)));
      v59 = (a - v51);
      v63 = Math.sqrt(((((v59 > 0.0) || (v59 !== v59)) ? v59 : 0.0) * (a + v51)));
      v71 = Math.asinh(((math.truth(v52) ? v58 : v63) / Math.sqrt((Math.abs((v51 - b)) * (v51 + b)))));
      v72 = (2.0 * v53);
      v73 = (1.0 - v72);
      v75 = Math.expm1(((-2.0) * v71));
      v77 = (v72 - (v73 * v75));
      v79 = ((v77 > 0.0) ? v77 : Infinity);
      v81 = (2.0 * (1.0 - v53));
      v82 = (1.0 - v81);
      v84 = (v81 - (v82 * v75));
      v86 = ((v84 > 0.0) ? v84 : Infinity);
      v106 = (b * b);
      v112 = (2.0 * b);
      v122 = [];
      for ([node, weight] of RULE_0((v71 / 1.0))) {
        v90 = (node * v71);
        v92 = Math.exp((-v90));
        v95 = Math.expm1(((-2.0) * (v71 - v90)));
        v100 = (v58 * ((v92 * (v72 - (v73 * v95))) / v79));
        v105 = (v63 * ((v92 * (v81 - (v82 * v95))) / v86));
        v109 = Math.sqrt((v106 + (v100 * v100)));
        v121 = (((v38 * (Math.atan((v100 / b)) + (v112 / (v100 + v109)))) * (v100 / v109)) * (v105 / (v109 + v105)));
        v122.push((weight * v121));
      }
      v122 = (math.fsum(v122) * v71);
      v124 = ((v51 * v51) * v122);
    } else {
      v124 = 0.0;
    }
    v125 = (((r < a) || (r !== r)) ? r : a);
    v132 = (v125 * v125);
    if ((v125 < b)) {
      v154 = ((((4.0 * E_star) * v38) / (3.0 * b)) * (v125 * v132));
    } else {
      v138 = Math.sqrt(((v125 - b) * (v125 + b)));
      v154 = ((E_star * v38) * (((v132 * Math.atan((v138 / b))) + (((4.0 * b) * v132) / (3.0 * (v138 + v125)))) + ((b / 3.0) * v138)));
    }
    return (v154 + ((2.0 * E_star) * (v48 + v124)));
  }
  return _load_within_of_rounded_cone(r, a, theta, b, E_star);
};

const load_within = (r, a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _load_within(r, a, theta, b, E_star) : 0.0) : NaN);
};

const _peak_pressure_of_rounded_cone = (a, theta, b, E_star) => {
  return _pressure_of_rounded_cone(math.zeros_like(a), a, theta, b, E_star);
};

const _peak_pressure = (a, theta, b, E_star) => {
  let node, v13, v23, v24, v27, v31, v32, v37, v44, v45, v46, v5, v51, v53, v56, v66, v67, v70, v73, v79, v80, v81, weight;
  if (((a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((0.0 < a)) {
      v5 = (((a < b) || (a !== a)) ? a : b);
      v13 = Math.tan(theta);
      v23 = ((0.0 === b) ? math.nextafter(b, Infinity) : 0.0);
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
        v45 = (2.0 * (math.truth(v24) ? 0.0 : 1.0));
        v46 = (1.0 - v45);
        v51 = (v45 - (v46 * Math.expm1(((-2.0) * v44))));
        v53 = ((v51 > 0.0) ? v51 : Infinity);
        v67 = (b * b);
        v73 = (2.0 * b);
        v80 = [];
        for ([node, weight] of RULE_0((v44 / 1.0))) {
          v56 = (node * v44);
          v66 = (v31 * ((Math.exp((-v56)) * (v45 - (v46 * Math.expm1(((-2.0) * (v44 - v56)))))) / v53));
          v70 = Math.sqrt((v67 + (v66 * v66)));
          v79 = (((v13 * (Math.atan((v66 / b)) + (v73 / (v66 + v70)))) * v66) / v70);
          v80.push((weight * v79));
        }
        v80 = (math.fsum(v80) * v44);
        v81 = v80;
      } else {
        v81 = 0.0;
      }
      return (((0.0 < v5) ? ((((2.0 * E_star) * v13) / (3.141592653589793 * b)) * Math.sqrt(((v5 - 0.0) * (v5 + 0.0)))) : 0.0) + ((E_star / 3.141592653589793) * v81));
    }
    return 0.0;
  }
  return _peak_pressure_of_rounded_cone(a, theta, b, E_star);
};

const _peak_radius_of_rounded_cone = (a) => {
  return math.zeros_like(a);
};

const _peak_radius = (a, theta = 0.7853981633974483, b = 1.0, E_star = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    return 0.0;
  }
  return _peak_radius_of_rounded_cone(a);
};

const PeakPressure = (pressure, radius) => math.record({ pressure, radius });

const peak_pressure = (a, theta, b, E_star) => {
  let pressure, radius;
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  pressure = ((a >= 0.0) ? _peak_pressure(a, theta, b, E_star) : NaN);
  radius = ((a >= 0.0) ? _peak_radius(a) : NaN);
  return PeakPressure(pressure, radius);
};

const _slope_beyond_of_rounded_cone = (t, root, theta, b) => {
  return (Math.tan(theta) * (Math.atan((root / b)) + ((2.0 * b) / (root + t))));
};

const _depth_beyond_of_rounded_cone = (a, root, theta, b) => {
  return ((Math.tan(theta) * a) * (Math.atan((root / b)) + (b / (root + a))));
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
    return math.log1p((math.truth(v6) ? v3 : 0.0));
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

const _beyond = (curve, value, base, b, tip, powers, leaving = null) => {
  let excess, small, start, t;
  small = (math.truth(leaving) ? null : (powers || [2.0])[0]);
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
  radius = (b * nth_root(((math.truth(above) ? base : value) / base), tip));
  if ((!Boolean(above))) {
    return radius;
  }
  high = (math.truth(above) ? value : (2.0 * base));
  return (math.truth(above) ? _beyond(curve, high, base, b, tip, powers, leaving) : radius);
};

const _radius_from_depth = (d, theta, b) => {
  let curve;
  curve = (a, root) => {
    let rate;
    rate = (a * _slope_beyond_of_rounded_cone(a, root, theta, b));
    return [_depth_beyond_of_rounded_cone(a, root, theta, b), rate];
  };
  return inverse_beyond(curve, d, b, 2.0, [2.0, 1.0]);
};

const radius_from_depth = (d, theta, b) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth(d, theta, b) : NaN);
};

const _force_beyond = (a, root, theta, b, E_star) => {
  let v10;
  v10 = (a * a);
  return ((E_star * Math.tan(theta)) * (((v10 * Math.atan((root / b))) + (((4.0 * b) * v10) / (3.0 * (root + a)))) + ((b / 3.0) * root)));
};

const _radius_from_force = (F, theta, b, E_star) => {
  let curve;
  curve = (a, root) => {
    let rate;
    rate = (((2 * E_star) * Math.pow(a, 2)) * _slope_beyond_of_rounded_cone(a, root, theta, b));
    return [_force_beyond(a, root, theta, b, E_star), rate];
  };
  return inverse_beyond(curve, F, b, 3.0, [2.0, 2.0]);
};

const radius_from_force = (F, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _radius_from_force(F, theta, b, E_star) : NaN);
};

const _force_from_depth = (d, theta, b, E_star) => {
  let a, change;
  a = _radius_from_depth(d, theta, b);
  change = (((a > 0.0) & (a < Infinity)) ? (((2 * E_star) * a) * (d - _depth(a, theta, b))) : 0.0);
  return (_force(a, theta, b, E_star) + change);
};

const force_from_depth = (d, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth(d, theta, b, E_star) : NaN);
};

const _depth_from_force = (F, theta, b, E_star) => {
  let a, change;
  a = _radius_from_force(F, theta, b, E_star);
  change = (((a > 0.0) & (a < Infinity)) ? ((F - _force(a, theta, b, E_star)) / ((2 * E_star) * a)) : 0.0);
  return (_depth(a, theta, b) + change);
};

const depth_from_force = (F, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force(F, theta, b, E_star) : NaN);
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

const _depth_2 = (a, theta, b, E_star, dgamma) => {
  let v13, v22, v5;
  v5 = Math.tan(theta);
  if ((a < b)) {
    v22 = ((v5 / b) * (a * a));
  } else {
    v13 = math.sqrt(((a - b) * (a + b)));
    v22 = ((v5 * a) * (Math.atan((v13 / b)) + (b / (v13 + a))));
  }
  return (v22 - (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const depth_of_rounded_cone = (a, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_2(a, theta, b, E_star, dgamma) : NaN);
};

const _force_2 = (a, theta, b, E_star, dgamma) => {
  let v13, v19, v35, v7;
  v7 = Math.tan(theta);
  v13 = (a * a);
  if ((a < b)) {
    v35 = ((((4.0 * E_star) * v7) / (3.0 * b)) * (a * v13));
  } else {
    v19 = math.sqrt(((a - b) * (a + b)));
    v35 = ((E_star * v7) * (((v13 * Math.atan((v19 / b))) + (((4.0 * b) * v13) / (3.0 * (v19 + a)))) + ((b / 3.0) * v19)));
  }
  return (v35 - (((2.0 * E_star) * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star)))));
};

const force_of_rounded_cone = (a, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_2(a, theta, b, E_star, dgamma) : NaN);
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

const _pressure_3 = (r, a, theta, b, E_star, dgamma) => {
  return (_pressure_of_rounded_cone(r, a, theta, b, E_star) - tension(r, a, E_star, dgamma));
};

const _pressure_2 = (r, a, theta, b, E_star, dgamma) => {
  let node, v104, v106, v14, v25, v26, v29, v33, v34, v39, v46, v47, v48, v53, v55, v58, v6, v68, v69, v72, v75, v81, v82, v83, v88, v94, v97, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    if ((r < a)) {
      v6 = (((a < b) || (a !== a)) ? a : b);
      v14 = Math.tan(theta);
      v25 = ((r === b) ? math.nextafter(b, Infinity) : r);
      if ((a > (((v25 > b) || (v25 !== v25)) ? v25 : b))) {
        v26 = (v25 < b);
        v29 = (a - b);
        v33 = Math.sqrt(((((v29 > 0.0) || (v29 !== v29)) ? v29 : 0.0) * (a + b)));
        if (v26) {
          v39 = v33;
        } else {
          v34 = (a - v25);
          v39 = Math.sqrt(((((v34 > 0.0) || (v34 !== v34)) ? v34 : 0.0) * (a + v25)));
        }
        v46 = Math.asinh((v39 / Math.sqrt((Math.abs((v25 - b)) * (v25 + b)))));
        v47 = (2.0 * (math.truth(v26) ? 0.0 : 1.0));
        v48 = (1.0 - v47);
        v53 = (v47 - (v48 * Math.expm1(((-2.0) * v46))));
        v55 = ((v53 > 0.0) ? v53 : Infinity);
        v69 = (b * b);
        v75 = (2.0 * b);
        v82 = [];
        for ([node, weight] of RULE_0_2((v46 / 1.0))) {
          v58 = (node * v46);
          v68 = (v33 * ((Math.exp((-v58)) * (v47 - (v48 * Math.expm1(((-2.0) * (v46 - v58)))))) / v55));
          v72 = Math.sqrt((v69 + (v68 * v68)));
          v81 = (((v14 * (Math.atan((v68 / b)) + (v75 / (v68 + v72)))) * v68) / v72);
          v82.push((weight * v81));
        }
        v82 = (math.fsum(v82) * v46);
        v83 = v82;
      } else {
        v83 = 0.0;
      }
      v88 = (((r < v6) ? ((((2.0 * E_star) * v14) / (3.141592653589793 * b)) * Math.sqrt(((v6 - r) * (v6 + r)))) : 0.0) + ((E_star / 3.141592653589793) * v83));
    } else {
      v88 = 0.0;
    }
    if ((r <= a)) {
      v94 = (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star)));
      if ((v94 > 0.0)) {
        v97 = (a - r);
        v104 = ((E_star * v94) / (3.141592653589793 * Math.sqrt(((((v97 > 0.0) || (v97 !== v97)) ? v97 : 0.0) * (a + r)))));
      } else {
        v104 = 0.0;
      }
      v106 = v104;
    } else {
      v106 = 0.0;
    }
    return (v88 - v106);
  }
  return _pressure_3(r, a, theta, b, E_star, dgamma);
};

const pressure_of_rounded_cone = (r, a, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_2(r, a, theta, b, E_star, dgamma) : 0.0) : NaN);
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

const _profile = (r, theta, b) => {
  return math.where((r < b), ((Math.tan(theta) / (2 * b)) * Math.pow(r, 2)), (Math.tan(theta) * (r - (b / 2))));
};

const _displacement_3 = (r, a, theta, b) => {
  let beyond, inner, inside, outside;
  inner = math.minimum(a, b);
  beyond = displacement_integral_beyond(_slope_beyond, [theta, b], r, a, b);
  outside = (((((2 * Math.tan(theta)) / (Math.PI * b)) * Math.pow(inner, 2)) * beside(r, inner, OUTSIDE_2)) + ((2 / Math.PI) * beyond));
  inside = (_depth_of_rounded_cone(a, theta, b) - _profile(r, theta, b));
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

const _displacement_2 = (r, a, theta, b, E_star, dgamma) => {
  return (_displacement_3(r, a, theta, b) - lift(r, a, E_star, dgamma));
};

const _displacement_of_rounded_cone = (r, a, theta, b, E_star, dgamma) => {
  let node, v12, v13, v14, v155, v16, v164, v174, v175, v19, v23, v24, v26, v31, v34, v36, v45, v46, v48, v50, v51, v54, v55, v6, v63, v65, v7, v75, v76, v78, v90, v92, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v14 = (a - b);
    v16 = (a + b);
    v19 = (r - a);
    v23 = Math.sqrt(((((v19 > 0.0) || (v19 !== v19)) ? v19 : 0.0) * (r + a)));
    v63 = Math.tan(theta);
    v65 = (2.0 * b);
    v174 = (r > a);
    if (v174) {
      v6 = (((a < b) || (a !== a)) ? a : b);
      if ((a > b)) {
        v7 = (r - b);
        v12 = Math.sqrt(((((v7 > 0.0) || (v7 !== v7)) ? v7 : 0.0) * (r + b)));
        v13 = (b / r);
        v24 = (Math.sqrt(((((v14 > 0.0) || (v14 !== v14)) ? v14 : 0.0) * v16)) / v23);
        v26 = Math.asinh((v24 / v13));
        v31 = (0.0 - Math.expm1(((-2.0) * v26)));
        v34 = ((v31 > 0.0) ? v31 : Infinity);
        v51 = (b * b);
        v55 = (v13 * v13);
        v76 = [];
        for ([node, weight] of RULE_0_2((v26 / 1.0))) {
          v36 = (node * v26);
          v45 = (v24 * ((Math.exp((-v36)) * (0.0 - Math.expm1(((-2.0) * (v26 - v36))))) / v34));
          v46 = (v45 * v45);
          v48 = Math.sqrt((1.0 + v46));
          v50 = ((v12 * v45) / v48);
          v54 = Math.sqrt((v51 + (v50 * v50)));
          v75 = (((((v63 * (Math.atan((v50 / b)) + (v65 / (v50 + v54)))) * v50) / v54) * Math.atan2(v54, (v12 / v48))) * (Math.sqrt((v55 + v46)) / ((v48 * v48) * v48)));
          v76.push((weight * v75));
        }
        v76 = (math.fsum(v76) * v26);
        v78 = (v12 * v76);
      } else {
        v78 = 0.0;
      }
      v90 = (v6 / (r + Math.sqrt(((r - v6) * (r + v6)))));
      v92 = (v90 * v90);
      v175 = (((((2.0 * v63) / (3.141592653589793 * b)) * (v6 * v6)) * ((v6 / r) * (0.6666666666666666 + (v92 * ((((((((((((((((((-0.7327347664453868) * v92) + (-32.15553480435792)) * v92) + (-332.23363563146734)) * v92) + (-1070.7082873491413)) * v92) + (-85.27694715374247)) * v92) + 5044.821368830373) * v92) + 8082.413158212496) * v92) + 3759.725330928701) * v92) + 0.26666666666720995) / ((((((((((((((((0.21387262524856868 * v92) + 32.12935731379798) * v92) + 746.8124983579742) * v92) + 6202.125133759036) * v92) + 23553.080984642995) * v92) + 44404.005348491315) * v92) + 40380.01430284195) * v92) + 14099.684276696918) * v92) + 1.0)))))) + (0.6366197723675814 * v78));
    } else {
      if ((a < b)) {
        v164 = ((v63 / b) * (a * a));
      } else {
        v155 = Math.sqrt((v14 * v16));
        v164 = ((v63 * a) * (Math.atan((v155 / b)) + (b / (v155 + a))));
      }
      v175 = (v164 - ((r < b) ? ((v63 / v65) * (r * r)) : (v63 * (r - (b / 2.0)))));
    }
    return (v175 - ((Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))) * (math.truth(v174) ? (0.6366197723675814 * Math.atan2(a, v23)) : 1.0)));
  }
  return _displacement_2(r, a, theta, b, E_star, dgamma);
};

const displacement_of_rounded_cone = (r, a, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_of_rounded_cone(r, a, theta, b, E_star, dgamma) : 0.0) : NaN);
};

const exponent_of = (x) => {
  return (math.frexp(x)[1] - 1);
};

const _rate = (a, theta, b) => {
  let v10, v3, v8;
  v10 = Math.tan(theta);
  if ((a < b)) {
    return (((2.0 * v10) / b) * a);
  }
  v3 = (a - b);
  v8 = math.sqrt(((((v3 > 0.0) || (v3 !== v3)) ? v3 : 0.0) * (a + b)));
  return (v10 * (Math.atan((v8 / b)) + ((2.0 * b) / (v8 + a))));
};

const radii_around = (length = 1.0) => [1e-150, 1e-140, 1e-130, 1e-120, 1e-110, 1e-100, 1e-90, 1e-80, 1e-70, 1e-60, 1e-50, 1e-40, 1e-30, 1e-20, 1e-10, 0.0625, 0.125, 0.1875, 0.25, 0.3125, 0.375, 0.4375, 0.5, 0.5625, 0.625, 0.6875, 0.75, 0.8125, 0.875, 0.9375, 1.0, 1.0000000000000049, 1.0000000000000062, 1.0000000000000078, 1.00000000000001, 1.0000000000000124, 1.0000000000000158, 1.0000000000000198, 1.000000000000025, 1.0000000000000315, 1.0000000000000397, 1.00000000000005, 1.0000000000000628, 1.0000000000000793, 1.0000000000000997, 1.0000000000001255, 1.000000000000158, 1.000000000000199, 1.0000000000002505, 1.0000000000003155, 1.000000000000397, 1.0000000000005, 1.0000000000006295, 1.0000000000007925, 1.0000000000009976, 1.0000000000012559, 1.0000000000015812, 1.0000000000019904, 1.0000000000025058, 1.0000000000031548, 1.0000000000039715, 1.000000000005, 1.0000000000062945, 1.0000000000079243, 1.0000000000099762, 1.0000000000125593, 1.0000000000158114, 1.0000000000199054, 1.0000000000250593, 1.0000000000315479, 1.0000000000397165, 1.00000000005, 1.0000000000629463, 1.0000000000792446, 1.000000000099763, 1.0000000001255942, 1.0000000001581137, 1.0000000001990534, 1.0000000002505935, 1.0000000003154785, 1.000000000397164, 1.0000000005, 1.0000000006294627, 1.0000000007924466, 1.000000000997631, 1.0000000012559431, 1.0000000015811388, 1.0000000019905357, 1.0000000025059361, 1.0000000031547867, 1.000000003971641, 1.000000005, 1.000000006294627, 1.000000007924466, 1.0000000099763116, 1.0000000125594322, 1.0000000158113882, 1.0000000199053583, 1.0000000250593615, 1.0000000315478668, 1.0000000397164108, 1.0000000499999988, 1.0000000629462686, 1.0000000792446564, 1.0000000997631109, 1.0000001255943136, 1.0000001581138704, 1.0000001990535654, 1.0000002505935854, 1.0000003154786223, 1.0000003971640385, 1.000000499999875, 1.0000006294625077, 1.0000007924462821, 1.0000009976306599, 1.0000012559424272, 1.0000015811375802, 1.0000019905338717, 1.0000025059330282, 1.000003154781746, 1.0000039716332867, 1.0000049999875, 1.0000062946072479, 1.0000079244345639, 1.000009976261812, 1.000012559353289, 1.0000158112633029, 1.00001990516042, 1.0000250590477036, 1.0000315473696058, 1.0000397156230707, 1.0000499987500624, 1.0000629442895979, 1.0000792415200137, 1.0000997581399051, 1.0001255864355991, 1.0001581013849845, 1.0001990337780544, 1.000250562226099, 1.0003154289245368, 1.0003970852790027, 1.000499875062461, 1.000629264718854, 1.0007921328589973, 1.000997134019358, 1.00125515550808, 1.00157989080261, 1.0019885586699753, 1.00250280415382, 1.0031498260204212, 1.003963785376366, 1.0049875621120885, 1.0062749396253194, 1.007893313761238, 1.0099270385278765, 1.0124815377650564, 1.0156883265065522, 1.0197110948966603, 1.0247530060276584, 1.0310653395629263, 1.038957565770816, 1.0488088481701465, 1.061080836307679, 1.0763314170115514, 1.0952288489155435, 1.1185654398160756, 1.1472697006444488, 1.1824158196478314, 1.2252294616222776, 1.2770894034796945, 1.3395253766630146, 1.4142135623730545, 1.5029721926216806, 1.6077603031736196, 1.730682615319356, 1.8740027832181265, 2.040166086417477, 2.231831468891524, 2.4519119756369965, 2.7036222821986744, 2.99053211774123, 3.316624790355215, 3.68636055180989, 4.104745049891547, 4.577403537999059, 5.110661827502642, 5.711635195080283, 6.388326624034235, 7.149735894613227, 8.005981167103203, 8.96843483961487, 10.04987562112024, 11.264658946430675, 12.628908078139231, 14.160728494567662, 15.88044845559861, 17.81088897323198, 19.977666794534418, 22.40953443575305, 25.138761792898762, 28.201564402071295, 31.63858403911055, 35.49542804072076, 39.82327450701274, 44.679551418614366, 50.12869868158581, 56.243023213265424, 63.103658416405615, 70.8016407738692, 79.43911785009331, 89.13070372908327, 100.00499987499889, 112.20630159638924, 125.89651275793454, 141.25729414683593, 158.49247400142386, 177.830752688277, 199.52873741730454, 223.87434726363662, 251.19063367890456, 281.8400671877868, 316.2293471516906, 354.81479842221427, 398.10842649470067, 446.6847115100955, 501.1882312573971, 562.3422143293052, 630.9581369262412, 707.9464906525023, 794.3288641866736, 891.2514991427217, 1000.000499999875, 10000000000000.0, 1.0000000000000001e+23, 1e+33, 1e+43, 1e+53, 1e+63, 1e+73, 1e+83, 1e+93, 1e+103, 1e+113, 1e+123, 1e+133, 1e+143].map((x) => x * length);

const _samples = (theta, b) => {
  let a;
  a = radii_around(b);
  return ({ radii: a, end: Infinity });
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

const _branches = (theta, b, E_star, dgamma, control) => {
  return branches(((a) => (Math.sqrt(a) * _rate(a, theta, b))), _samples(theta, b), least_steepness(control, E_star, dgamma));
};

const XI_of_stable = {'force': 3.0, 'depth': 1.0};

const growth = (slope, a, control, E_star, dgamma) => {
  let own;
  own = (slope - ((XI_of_stable[control] * hess_retraction(a, E_star, dgamma)) / (2.0 * a)));
  return ((control === 'force') ? (((2.0 * E_star) * a) * own) : own);
};

const Unknown = (of, back, end = Infinity, order = 2.0, unit = 0.0) => math.record({ of, back, end, order, unit });

const radius_itself = () => {
  return Unknown(((a) => a), ((x) => [x, math.ones_like(x)]));
};

const SHARP = 0.3;

const _product = (t, first, last) => {
  return (Math.pow(t, first) * Math.pow((1.0 + (t * t)), ((last - first) / 2.0)));
};

const power_of = (t, first, last) => {
  let low, share;
  if (Boolean((first < SHARP))) {
    return _product(t, first, last);
  }
  share = (first / last);
  low = Math.pow(math.minimum((t / Math.sqrt(share)), 1.0), first);
  return (((t * t) < share) ? low : Math.pow((math.maximum(((t * t) - share), 0.0) + 1.0), (last / 2.0)));
};

const STEPS_of_unknowns = 12;

const SETTLED_of_unknowns = 1e-09;

const _root_of_product = (x, first, last) => {
  let _, gain, joined, log, missed, near, newton, share, slope, step, t, wanted;
  [wanted, gain] = [Math.log(x), (last - first)];
  near = (0.5 * Math.log((Math.expm1(math.minimum(math.maximum(((2.0 * wanted) / last), 0.0), 600.0)) + (first / last))));
  log = ((wanted < 0.0) ? ((wanted / first) + (0.5 * Math.log((first / last)))) : near);
  log = ((wanted > (300.0 * last)) ? (wanted / last) : log);
  for (_ of math.range(STEPS_of_unknowns)) {
    share = (1.0 / (1.0 + Math.exp(((-2.0) * log))));
    slope = (first + (gain * share));
    joined = ((first * log) + (gain * (math.maximum(log, 0.0) + (0.5 * Math.log1p(Math.exp(((-2.0) * Math.abs(log))))))));
    newton = ((wanted - joined) / slope);
    step = (newton / math.maximum((1.0 + ((((gain * share) * (1.0 - share)) / slope) * newton)), 0.3));
    log = (log + (Number.isFinite(step) ? step : 0.0));
    if ((!Boolean((Math.abs(step) > SETTLED_of_unknowns)))) {
      break;
    }
  }
  [t, slope] = [Math.exp(log), (first + (gain / (1.0 + Math.exp(((-2.0) * log)))))];
  missed = ((x / _product(t, first, last)) - 1.0);
  return [(t * ((Math.abs(missed) < (1e-06 * slope)) ? (1.0 + (missed / slope)) : 1.0)), slope];
};

const root_of = (x, first, last) => {
  let share, square, t;
  if (Boolean((first < SHARP))) {
    return _root_of_product(x, first, last);
  }
  share = (first / last);
  square = ((x < 1.0) ? share : ((Math.pow(math.maximum(x, 1.0), (2.0 / last)) - 1.0) + share));
  t = (Math.sqrt(square) * ((x < 1.0) ? Math.pow(math.minimum(x, 1.0), (1.0 / first)) : 1.0));
  return [t, ((x < 1.0) ? first : ((last * square) / ((square + 1.0) - share)))];
};

const beyond_edge = (b, first = 1.0, last = 1.0) => {
  let back, of, plain;
  plain = ((typeof first === "number") && (first === last && last === 1.0));
  of = (a) => {
    let t;
    t = (difference_root(a, b) / b);
    return (math.truth(plain) ? t : power_of(t, first, last));
  };
  back = (x) => {
    let a, slope, t;
    [t, slope] = (math.truth(plain) ? [x, 1.0] : root_of(x, first, last));
    a = (b * math.hypot(1.0, t));
    return [a, ((a * ((t * t) / (1.0 + (t * t)))) / (x * slope))];
  };
  return Unknown(of, back, undefined, (3.0 / first), 1.0);
};

const at_the_end = (load, a) => {
  return load(a);
};

const NOISE_of_stable = 4.440892098500626e-16;

const _branch_of = (value, found, load, pulled) => {
  let first, fits, high, largest, last, least, low, start, top;
  low = high = least = largest = math.full(value, NaN);
  for ([first, last] of math.zip(found.first, found.last)) {
    start = load(first);
    top = (Number.isFinite(last) ? at_the_end(load, last) : Infinity);
    top = (Number.isNaN(top) ? Infinity : top);
    fits = ((value >= (start - ((2.0 * NOISE_of_stable) * (Math.abs(start) + pulled(first))))) & (value <= top));
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

const LOST_of_stable = 0.3;

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
  least_short = ((4.0 * NOISE_of_stable) * parts);
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
    return [more, (math.truth(lost) ? LOST_of_stable : slope)];
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
  start = ((ends & (slope === LOST_of_stable)) ? reach : start);
  noise = ((NOISE_of_stable * parts) * (math.truth(ends) ? ((1.0 + wanted) / short) : 1.0));
  t = inverse(excess, wanted, start, [SLACK, Infinity], largest, share, true, noise);
  a = place(t)[0];
  return (((value === Infinity) & (high === Infinity)) ? Infinity : (Number.isFinite(least) ? a : NaN));
};

const _radius_from_depth_of_rounded_cone = (d, theta, b, E_star, dgamma) => {
  let found, radius, stress, unit;
  unit = exponent_of(b);
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  d = math.ldexp(d, (-unit));
  found = _branches(theta, b, E_star, dgamma, 'depth');
  radius = stable_radius(d, found, ((a) => _depth_2(a, theta, b, E_star, dgamma)), ((a) => growth(_rate(a, theta, b), a, 'depth', E_star, dgamma)), ((a) => hess_retraction(a, E_star, dgamma)), radius_itself(), beyond_edge(b), b);
  return math.ldexp(radius, unit);
};

const radius_from_depth_of_rounded_cone = (d, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_depth_of_rounded_cone(d, theta, b, E_star, dgamma);
};

const pull = (a, E_star, dgamma) => {
  return (((2.0 * E_star) * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const _radius_from_force_of_rounded_cone = (F, theta, b, E_star, dgamma) => {
  let found, radius, stress, unit;
  unit = exponent_of(b);
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  F = math.ldexp(F, (-(stress + (2 * unit))));
  found = _branches(theta, b, E_star, dgamma, 'force');
  radius = stable_radius(F, found, ((a) => _force_2(a, theta, b, E_star, dgamma)), ((a) => growth(_rate(a, theta, b), a, 'force', E_star, dgamma)), ((a) => pull(a, E_star, dgamma)), radius_itself(), beyond_edge(b), b);
  return math.ldexp(radius, unit);
};

const radius_from_force_of_rounded_cone = (F, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_force_of_rounded_cone(F, theta, b, E_star, dgamma);
};

const _pull_off_radius = (theta, b, E_star, dgamma, control) => {
  let found, load, radius, stress, unit;
  unit = exponent_of(b);
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  found = _branches(theta, b, E_star, dgamma, control);
  load = ((control === 'force') ? _force_2 : _depth_2);
  radius = math.lowest(found, ((a) => load(a, theta, b, E_star, dgamma)));
  return math.ldexp(radius, unit);
};

const PullOff = (radius, force, depth) => math.record({ radius, force, depth });

const pull_off = (control = 'force', theta, b, E_star, dgamma) => {
  let depth, force, radius;
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  radius = _pull_off_radius(theta, b, E_star, dgamma, control);
  force = ((radius >= 0.0) ? _force_2(radius, theta, b, E_star, dgamma) : NaN);
  depth = ((radius >= 0.0) ? _depth_2(radius, theta, b, E_star, dgamma) : NaN);
  return PullOff(radius, force, depth);
};

const RULE_0_3 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const CLOSE = 0.25;

const _gap = (a, c, outer, inner) => {
  return math.where((a > c), (((a - c) * (a + c)) / (outer + inner)), 0.0);
};

const growth_of_slip = math.in_groups((slope, order, r, c, a, close) => {
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
  return [integrand, (math.truth(holds) ? Math.log1p((gaps / (beyond + root))) : 0.0), 1.0, holds, 0.0];
});

const _tangential_force_of_rounded_cone = (a, c, theta, b, E_star, mu) => {
  let beyond, close, gain, sticking, tip, whole;
  [whole, sticking] = [_force_of_rounded_cone(a, theta, b, E_star), _force_of_rounded_cone(c, theta, b, E_star)];
  close = (sticking >= (CLOSE * whole));
  tip = growth_of_slip(_slope, [theta, b], 2, 0.0, c, math.minimum(a, b), close);
  beyond = growth_beyond(_slope_beyond, [theta, b], 2, 0.0, c, a, b, close);
  gain = ((2.0 * E_star) * (tip + beyond));
  return (mu * math.where(close, gain, (whole - sticking)));
};

const _tangential_force = (a, c, theta, b, E_star, mu) => {
  let node, v100, v104, v105, v109, v113, v116, v12, v120, v127, v129, v133, v134, v139, v14, v140, v143, v146, v154, v155, v156, v161, v17, v18, v20, v23, v25, v31, v36, v37, v43, v56, v59, v60, v62, v66, v67, v68, v73, v78, v8, v83, v84, v86, v91, v93, v96, v97, v98, v99, weight;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v8 = Math.tan(theta);
    v12 = (((4.0 * E_star) * v8) / (3.0 * b));
    v14 = (a * a);
    v17 = (a - b);
    v18 = (a + b);
    v23 = (E_star * v8);
    v25 = (4.0 * b);
    v31 = (b / 3.0);
    if ((a < b)) {
      v36 = (v12 * (a * v14));
    } else {
      v20 = Math.sqrt((v17 * v18));
      v36 = (v23 * (((v14 * Math.atan((v20 / b))) + ((v25 * v14) / (3.0 * (v20 + a)))) + (v31 * v20)));
    }
    v37 = (c * c);
    if ((c < b)) {
      v56 = (v12 * (c * v37));
    } else {
      v43 = Math.sqrt(((c - b) * (c + b)));
      v56 = (v23 * (((v37 * Math.atan((v43 / b))) + ((v25 * v37) / (3.0 * (v43 + c)))) + (v31 * v43)));
    }
    v59 = (v56 >= (0.25 * v36));
    if (v59) {
      v60 = (((a < b) || (a !== a)) ? a : b);
      v73 = (v60 > c);
      v83 = (v59 && v73);
      if (v83) {
        v62 = (c - 0.0);
        v66 = Math.sqrt(((((v62 > 0.0) || (v62 !== v62)) ? v62 : 0.0) * (c + 0.0)));
        if (v83) {
          v67 = (v60 - c);
          if (v73) {
            v68 = (v60 - 0.0);
            v78 = ((v67 * (v60 + c)) / (Math.sqrt(((((v68 > 0.0) || (v68 !== v68)) ? v68 : 0.0) * (v60 + 0.0))) + v66));
          } else {
            v78 = 0.0;
          }
          v84 = Math.log1p(((v67 + v78) / (c + v66)));
        } else {
          v84 = 0.0;
        }
        v93 = ((2.0 * v8) / b);
        v97 = [];
        for ([node, weight] of RULE_0_3((v84 / 1.0))) {
          v86 = (node * v84);
          v91 = ((c * Math.cosh(v86)) + (v66 * Math.sinh(v86)));
          v96 = ((v93 * v91) * (v91 * v91));
          v97.push((weight * v96));
        }
        v97 = (math.fsum(v97) * v84);
        v98 = v97;
      } else {
        v98 = 0.0;
      }
      v99 = (((b > c) || (b !== b)) ? b : c);
      v113 = (a > v99);
      v129 = (v59 && v113);
      if (v129) {
        v100 = (v99 - b);
        v104 = Math.sqrt(((((v100 > 0.0) || (v100 !== v100)) ? v100 : 0.0) * (v99 + b)));
        v105 = (v99 - 0.0);
        v109 = Math.sqrt(((((v105 > 0.0) || (v105 !== v105)) ? v105 : 0.0) * (v99 + 0.0)));
        if (v129) {
          v116 = ((a - v99) * (a + v99));
          if (v113) {
            v120 = (a - 0.0);
            v127 = (v116 / (Math.sqrt(((((v120 > 0.0) || (v120 !== v120)) ? v120 : 0.0) * (a + 0.0))) + v109));
          } else {
            v127 = 0.0;
          }
          v133 = Math.log1p((((math.truth(v113) ? (v116 / (Math.sqrt(((((v17 > 0.0) || (v17 !== v17)) ? v17 : 0.0) * v18)) + v104)) : 0.0) + v127) / (v104 + v109)));
        } else {
          v133 = 0.0;
        }
        v140 = (b * b);
        v146 = (2.0 * b);
        v155 = [];
        for ([node, weight] of RULE_0_3((v133 / 1.0))) {
          v134 = (node * v133);
          v139 = ((v104 * Math.cosh(v134)) + (v109 * Math.sinh(v134)));
          v143 = Math.sqrt((v140 + (v139 * v139)));
          v154 = (((v8 * (Math.atan((v139 / b)) + (v146 / (v139 + v143)))) * (v139 / v143)) * (v143 * v143));
          v155.push((weight * v154));
        }
        v155 = (math.fsum(v155) * v133);
        v156 = v155;
      } else {
        v156 = 0.0;
      }
      v161 = ((2.0 * E_star) * (v98 + v156));
    } else {
      v161 = (v36 - v56);
    }
    return (mu * v161);
  }
  return _tangential_force_of_rounded_cone(a, c, theta, b, E_star, mu);
};

const tangential_force = (a, c, theta, b, E_star, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_force(a, c, theta, b, E_star, mu) : NaN);
};

const _traction_of_rounded_cone = (r, a, c, theta, b, E_star, mu) => {
  let beyond, close, gain, sliding, stuck, tip;
  sliding = _pressure_of_rounded_cone(r, a, theta, b, E_star);
  stuck = _pressure_of_rounded_cone(r, c, theta, b, E_star);
  close = ((r < c) & (stuck >= (CLOSE * sliding)));
  tip = growth_of_slip(_slope, [theta, b], 0, r, c, math.minimum(a, b), close);
  beyond = growth_beyond(_slope_beyond, [theta, b], 0, r, c, a, b, close);
  gain = ((E_star / Math.PI) * (tip + beyond));
  return (mu * math.where(close, gain, (sliding - stuck)));
};

const _traction = (r, a, c, theta, b, E_star, mu) => {
  let node, v102, v103, v108, v110, v114, v116, v118, v128, v131, v139, v140, v141, v142, v145, v149, v15, v150, v154, v155, v159, v169, v170, v171, v176, v178, v181, v182, v183, v184, v185, v189, v19, v190, v194, v195, v198, v202, v209, v211, v215, v216, v221, v224, v234, v235, v236, v240, v26, v27, v30, v34, v35, v40, v45, v47, v48, v49, v54, v56, v57, v59, v69, v7, v70, v73, v76, v8, v82, v83, v84, v86, v89, v9, v90, v98, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v7 = (((a < b) || (a !== a)) ? a : b);
    v8 = (v7 - r);
    v9 = (v7 + r);
    v15 = Math.tan(theta);
    v19 = (((2.0 * E_star) * v15) / (3.141592653589793 * b));
    v26 = ((r === b) ? math.nextafter(b, Infinity) : r);
    v27 = (v26 < b);
    v30 = (a - b);
    v34 = Math.sqrt(((((v30 > 0.0) || (v30 !== v30)) ? v30 : 0.0) * (a + b)));
    v45 = Math.sqrt((Math.abs((v26 - b)) * (v26 + b)));
    v48 = (2.0 * (math.truth(v27) ? 0.0 : 1.0));
    v49 = (1.0 - v48);
    v57 = (((v26 > b) || (v26 !== v26)) ? v26 : b);
    v70 = (b * b);
    v76 = (2.0 * b);
    v86 = (E_star / 3.141592653589793);
    if ((r < a)) {
      if ((a > v57)) {
        if (v27) {
          v40 = v34;
        } else {
          v35 = (a - v26);
          v40 = Math.sqrt(((((v35 > 0.0) || (v35 !== v35)) ? v35 : 0.0) * (a + v26)));
        }
        v47 = Math.asinh((v40 / v45));
        v54 = (v48 - (v49 * Math.expm1(((-2.0) * v47))));
        v56 = ((v54 > 0.0) ? v54 : Infinity);
        v83 = [];
        for ([node, weight] of RULE_0_3((v47 / 1.0))) {
          v59 = (node * v47);
          v69 = (v34 * ((Math.exp((-v59)) * (v48 - (v49 * Math.expm1(((-2.0) * (v47 - v59)))))) / v56));
          v73 = Math.sqrt((v70 + (v69 * v69)));
          v82 = (((v15 * (Math.atan((v69 / b)) + (v76 / (v69 + v73)))) * v69) / v73);
          v83.push((weight * v82));
        }
        v83 = (math.fsum(v83) * v47);
        v84 = v83;
      } else {
        v84 = 0.0;
      }
      v89 = (((r < v7) ? (v19 * Math.sqrt((v8 * v9))) : 0.0) + (v86 * v84));
    } else {
      v89 = 0.0;
    }
    v142 = (r < c);
    if (v142) {
      v90 = (((c < b) || (c !== c)) ? c : b);
      if ((c > v57)) {
        v98 = (c - b);
        v102 = Math.sqrt(((((v98 > 0.0) || (v98 !== v98)) ? v98 : 0.0) * (c + b)));
        if (v27) {
          v108 = v102;
        } else {
          v103 = (c - v26);
          v108 = Math.sqrt(((((v103 > 0.0) || (v103 !== v103)) ? v103 : 0.0) * (c + v26)));
        }
        v110 = Math.asinh((v108 / v45));
        v114 = (v48 - (v49 * Math.expm1(((-2.0) * v110))));
        v116 = ((v114 > 0.0) ? v114 : Infinity);
        v140 = [];
        for ([node, weight] of RULE_0_3((v110 / 1.0))) {
          v118 = (node * v110);
          v128 = (v102 * ((Math.exp((-v118)) * (v48 - (v49 * Math.expm1(((-2.0) * (v110 - v118)))))) / v116));
          v131 = Math.sqrt((v70 + (v128 * v128)));
          v139 = (((v15 * (Math.atan((v128 / b)) + (v76 / (v128 + v131)))) * v128) / v131);
          v140.push((weight * v139));
        }
        v140 = (math.fsum(v140) * v110);
        v141 = v140;
      } else {
        v141 = 0.0;
      }
      v145 = (((r < v90) ? (v19 * Math.sqrt(((v90 - r) * (v90 + r)))) : 0.0) + (v86 * v141));
    } else {
      v145 = 0.0;
    }
    v149 = (v142 && (v145 >= (0.25 * v89)));
    if (v149) {
      v159 = (v7 > c);
      v169 = (v149 && v159);
      if (v169) {
        v150 = (c - r);
        v154 = Math.sqrt(((((v150 > 0.0) || (v150 !== v150)) ? v150 : 0.0) * (c + r)));
        if (v169) {
          v155 = (v7 - c);
          v170 = Math.log1p(((v155 + (math.truth(v159) ? ((v155 * (v7 + c)) / (Math.sqrt(((((v8 > 0.0) || (v8 !== v8)) ? v8 : 0.0) * v9)) + v154)) : 0.0)) / (c + v154)));
        } else {
          v170 = 0.0;
        }
        v178 = ((2.0 * v15) / b);
        v182 = [];
        for ([node, weight] of RULE_0_3((v170 / 1.0))) {
          v171 = (node * v170);
          v176 = ((c * Math.cosh(v171)) + (v154 * Math.sinh(v171)));
          v181 = ((v178 * v176) * Math.pow(v176, 0.0));
          v182.push((weight * v181));
        }
        v182 = (math.fsum(v182) * v170);
        v183 = v182;
      } else {
        v183 = 0.0;
      }
      v184 = (((b > c) || (b !== b)) ? b : c);
      v195 = (a > v184);
      v211 = (v149 && v195);
      if (v211) {
        v185 = (v184 - b);
        v189 = Math.sqrt(((((v185 > 0.0) || (v185 !== v185)) ? v185 : 0.0) * (v184 + b)));
        v190 = (v184 - r);
        v194 = Math.sqrt(((((v190 > 0.0) || (v190 !== v190)) ? v190 : 0.0) * (v184 + r)));
        if (v211) {
          v198 = ((a - v184) * (a + v184));
          if (v195) {
            v202 = (a - r);
            v209 = (v198 / (Math.sqrt(((((v202 > 0.0) || (v202 !== v202)) ? v202 : 0.0) * (a + r))) + v194));
          } else {
            v209 = 0.0;
          }
          v215 = Math.log1p((((math.truth(v195) ? (v198 / (v34 + v189)) : 0.0) + v209) / (v189 + v194)));
        } else {
          v215 = 0.0;
        }
        v235 = [];
        for ([node, weight] of RULE_0_3((v215 / 1.0))) {
          v216 = (node * v215);
          v221 = ((v189 * Math.cosh(v216)) + (v194 * Math.sinh(v216)));
          v224 = Math.sqrt((v70 + (v221 * v221)));
          v234 = (((v15 * (Math.atan((v221 / b)) + (v76 / (v221 + v224)))) * (v221 / v224)) * Math.pow(v224, 0.0));
          v235.push((weight * v234));
        }
        v235 = (math.fsum(v235) * v215);
        v236 = v235;
      } else {
        v236 = 0.0;
      }
      v240 = (v86 * (v183 + v236));
    } else {
      v240 = (v89 - v145);
    }
    return (mu * v240);
  }
  return _traction_of_rounded_cone(r, a, c, theta, b, E_star, mu);
};

const traction = (r, a, c, theta, b, E_star, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction(r, a, c, theta, b, E_star, mu) : 0.0) : NaN);
};

const _tangential_displacement_of_rounded_cone = (a, c, theta, b, E_star, G_star, mu) => {
  let beyond, close, gain, sticking, tip, whole;
  [whole, sticking] = [_depth_of_rounded_cone(a, theta, b), _depth_of_rounded_cone(c, theta, b)];
  close = (sticking >= (CLOSE * whole));
  tip = growth_of_slip(_slope, [theta, b], 1, 0.0, c, math.minimum(a, b), close);
  beyond = growth_beyond(_slope_beyond, [theta, b], 1, 0.0, c, a, b, close);
  gain = (tip + beyond);
  return ((mu * (E_star / G_star)) * math.where(close, gain, (whole - sticking)));
};

const _tangential_displacement = (a, c, theta, b, E_star, G_star, mu) => {
  let node, v103, v110, v112, v116, v117, v12, v122, v123, v126, v129, v13, v137, v138, v139, v144, v15, v24, v30, v39, v42, v43, v45, v49, v50, v51, v56, v61, v66, v67, v69, v7, v74, v76, v79, v8, v80, v81, v82, v83, v87, v88, v92, v96, v99, weight;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v7 = Math.tan(theta);
    v8 = (v7 / b);
    v12 = (a - b);
    v13 = (a + b);
    if ((a < b)) {
      v24 = (v8 * (a * a));
    } else {
      v15 = Math.sqrt((v12 * v13));
      v24 = ((v7 * a) * (Math.atan((v15 / b)) + (b / (v15 + a))));
    }
    if ((c < b)) {
      v39 = (v8 * (c * c));
    } else {
      v30 = Math.sqrt(((c - b) * (c + b)));
      v39 = ((v7 * c) * (Math.atan((v30 / b)) + (b / (v30 + c))));
    }
    v42 = (v39 >= (0.25 * v24));
    if (v42) {
      v43 = (((a < b) || (a !== a)) ? a : b);
      v56 = (v43 > c);
      v66 = (v42 && v56);
      if (v66) {
        v45 = (c - 0.0);
        v49 = Math.sqrt(((((v45 > 0.0) || (v45 !== v45)) ? v45 : 0.0) * (c + 0.0)));
        if (v66) {
          v50 = (v43 - c);
          if (v56) {
            v51 = (v43 - 0.0);
            v61 = ((v50 * (v43 + c)) / (Math.sqrt(((((v51 > 0.0) || (v51 !== v51)) ? v51 : 0.0) * (v43 + 0.0))) + v49));
          } else {
            v61 = 0.0;
          }
          v67 = Math.log1p(((v50 + v61) / (c + v49)));
        } else {
          v67 = 0.0;
        }
        v76 = ((2.0 * v7) / b);
        v80 = [];
        for ([node, weight] of RULE_0_3((v67 / 1.0))) {
          v69 = (node * v67);
          v74 = ((c * Math.cosh(v69)) + (v49 * Math.sinh(v69)));
          v79 = ((v76 * v74) * Math.pow(v74, 1.0));
          v80.push((weight * v79));
        }
        v80 = (math.fsum(v80) * v67);
        v81 = v80;
      } else {
        v81 = 0.0;
      }
      v82 = (((b > c) || (b !== b)) ? b : c);
      v96 = (a > v82);
      v112 = (v42 && v96);
      if (v112) {
        v83 = (v82 - b);
        v87 = Math.sqrt(((((v83 > 0.0) || (v83 !== v83)) ? v83 : 0.0) * (v82 + b)));
        v88 = (v82 - 0.0);
        v92 = Math.sqrt(((((v88 > 0.0) || (v88 !== v88)) ? v88 : 0.0) * (v82 + 0.0)));
        if (v112) {
          v99 = ((a - v82) * (a + v82));
          if (v96) {
            v103 = (a - 0.0);
            v110 = (v99 / (Math.sqrt(((((v103 > 0.0) || (v103 !== v103)) ? v103 : 0.0) * (a + 0.0))) + v92));
          } else {
            v110 = 0.0;
          }
          v116 = Math.log1p((((math.truth(v96) ? (v99 / (Math.sqrt(((((v12 > 0.0) || (v12 !== v12)) ? v12 : 0.0) * v13)) + v87)) : 0.0) + v110) / (v87 + v92)));
        } else {
          v116 = 0.0;
        }
        v123 = (b * b);
        v129 = (2.0 * b);
        v138 = [];
        for ([node, weight] of RULE_0_3((v116 / 1.0))) {
          v117 = (node * v116);
          v122 = ((v87 * Math.cosh(v117)) + (v92 * Math.sinh(v117)));
          v126 = Math.sqrt((v123 + (v122 * v122)));
          v137 = (((v7 * (Math.atan((v122 / b)) + (v129 / (v122 + v126)))) * (v122 / v126)) * Math.pow(v126, 1.0));
          v138.push((weight * v137));
        }
        v138 = (math.fsum(v138) * v116);
        v139 = v138;
      } else {
        v139 = 0.0;
      }
      v144 = (v81 + v139);
    } else {
      v144 = (v24 - v39);
    }
    return ((mu * (E_star / G_star)) * v144);
  }
  return _tangential_displacement_of_rounded_cone(a, c, theta, b, E_star, G_star, mu);
};

const tangential_displacement = (a, c, theta, b, E_star, G_star, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement(a, c, theta, b, E_star, G_star, mu) : NaN);
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

const _stick_radius = (F_x, a, theta, b, E_star, mu) => {
  let F;
  F = stick_force(_force(a, theta, b, E_star), F_x, mu);
  return (((F_x === 0.0) & (a >= 0.0)) ? a : _radius_from_force(F, theta, b, E_star));
};

const stick_radius = (F_x, a, theta, b, E_star, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius(F_x, a, theta, b, E_star, mu) : NaN);
};

const _full_slip_displacement_of_rounded_cone = (a, theta, b, E_star, G_star, mu) => {
  return ((mu * (E_star / G_star)) * _depth_of_rounded_cone(a, theta, b));
};

const _full_slip_displacement = (a, theta, b, E_star, G_star, mu) => {
  let v16, v25, v8;
  if (((a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v8 = Math.tan(theta);
    if ((a < b)) {
      v25 = ((v8 / b) * (a * a));
    } else {
      v16 = Math.sqrt(((a - b) * (a + b)));
      v25 = ((v8 * a) * (Math.atan((v16 / b)) + (b / (v16 + a))));
    }
    return ((mu * (E_star / G_star)) * v25);
  }
  return _full_slip_displacement_of_rounded_cone(a, theta, b, E_star, G_star, mu);
};

const full_slip_displacement = (a, theta, b, E_star, G_star, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement(a, theta, b, E_star, G_star, mu) : NaN);
};

const _tip = (a, root, b, k) => {
  let v10, v16, v18;
  if ((root < (0.5 * a))) {
    v16 = math.log((root / a));
  } else {
    v10 = ((((b < a) || (b !== b)) ? b : a) / a);
    v16 = (0.5 * math.log1p((-(v10 * v10))));
  }
  v18 = (1.0 + k);
  return ((-Math.expm1((v18 * v16))) / v18);
};

const raised = (x, k) => {
  if ((x > 0.0)) {
    return (x * Math.pow(x, k));
  }
  return 0.0;
};

const sine_over = (y) => {
  let v2;
  v2 = (y > 0.0);
  if (v2) {
    return (Math.sin(y) / (math.truth(v2) ? y : 1.0));
  }
  return 1.0;
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

const sine_mean = (angle, k) => {
  return weighted(((y) => Math.pow(sine_over(y), k)), angle, k, 24);
};

const sine_integral = (angle, k) => {
  return (raised(angle, k) * sine_mean(angle, k));
};

const rounded_depth = (a, root, b, k) => {
  let beyond;
  beyond = (((a / b) * _tip(a, root, b, k)) + sine_integral(Math.atan2(root, b), k));
  return (a * ((a < b) ? ((a / b) / (1.0 + k)) : beyond));
};

const _depth_at = (a, root, theta, b, k) => {
  return (rounded_depth(a, root, b, k) * Math.tan(theta));
};

const _depth_3 = (a, theta, b, k) => {
  return _depth_at(a, difference_root(a, b), theta, b, k);
};

const depth_2 = (a, theta, b, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_3(a, theta, b, k) : NaN);
};

const flank_force = (a, root, b, k) => {
  let sides, within;
  within = math.maximum(a, b);
  sides = ((raised((root / within), k) * (b / within)) + sine_integral(Math.atan2(root, b), k));
  return (((a * raised(a, k)) * sides) / (2.0 + k));
};

const rounded_force = (a, root, b, k) => {
  let inside, square, tip;
  tip = ((a / b) * (_tip(a, root, b, k) - _tip(a, root, b, (k + 2.0))));
  inside = (((2.0 * a) / b) / ((1.0 + k) * (3.0 + k)));
  square = (a * raised(a, k));
  return (square * ((a < b) ? inside : (tip + (flank_force(a, root, b, k) / square))));
};

const _force_at = (a, root, theta, b, H, k) => {
  let growth;
  growth = (rounded_force(a, root, b, k) * Math.tan(theta));
  return (((2.0 * H) / (1.0 + k)) * growth);
};

const _force_3 = (a, theta, b, H, k) => {
  return _force_at(a, difference_root(a, b), theta, b, H, k);
};

const force_2 = (a, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_3(a, theta, b, H, k) : NaN);
};

const _gamma = (x) => {
  return math.vectorize(math.gamma)(x);
};

const FAR_of_growth = 40.0;

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
  steps = Math.ceil(math.maximum((FAR_of_growth - x), 0.0));
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

const _steep = (rest, near, m, half) => {
  let integrand, stop;
  rest = math.where(Number.isFinite(rest), rest, Infinity);
  stop = math.minimum(rest, (42.0 / math.maximum(Math.abs(m), 20.0)));
  integrand = (y) => {
    return (Math.exp(((-m) * y)) * Math.pow((-Math.expm1(((-2.0) * (near + (rest - y))))), half));
  };
  return math.integral(integrand, stop, NODES);
};

const _TERMS = 22;

const _tail = (rest, near, m, half, far) => {
  let factor, j, level, rate, span, total;
  rest = math.where(Number.isFinite(rest), rest, 0.0);
  [factor, total] = [math.ones_like((rest + half)), math.zeros_like((rest + half))];
  for (j of math.range(_TERMS)) {
    rate = (m - (2.0 * j));
    span = math.where((rate === 0.0), rest, ((-Math.expm1(((-Math.abs(rate)) * rest))) / math.where((rate === 0.0), 1.0, Math.abs(rate))));
    level = math.where((rate > 0.0), Math.exp((((-2.0) * j) * (near + rest))), (Math.exp((((-2.0) * j) * near)) * far));
    total = (total + ((factor * span) * level));
    factor = ((factor * (j - half)) / (j + 1.0));
  }
  return total;
};

const power_growth = (r, a, n, k) => {
  let above, far, first, half, length, m, near, place, rest, smooth, total;
  if (((typeof n === "number") && ((n % 2.0) === 0.0) && (n <= _EVEN))) {
    return _even_growth(r, a, Math.trunc(n), k);
  }
  m = axis_power(n, k);
  length = Math.log1p(((a - r) / r));
  length = math.where(Number.isFinite(length), length, (Math.log(a) - Math.log(r)));
  near = math.minimum(math.minimum(length, 1.0), (20.0 / math.maximum(Math.abs(m), 1e-300)));
  [half, above] = [((k - 1.0) / 2.0), ((k + 1.0) / 2.0)];
  smooth = (x) => {
    let shrink;
    shrink = math.where((x > 0.0), ((-Math.expm1(((-2.0) * x))) / math.where((x > 0.0), x, 1.0)), 2.0);
    return (Math.pow(shrink, half) * Math.exp(((-m) * (near - x))));
  };
  rest = (length - near);
  place = math.minimum(((r / a) * Math.exp(near)), 1.0);
  far = ((Math.pow(place, n) / place) * Math.pow(place, k));
  first = (math.where((rest > 0.0), far, 1.0) * Math.pow(near, above));
  first = (first * weighted(smooth, near, half, undefined, above));
  total = (first + math.where((Math.abs(m) > 20.0), _steep(rest, near, m, half), _tail(rest, near, m, half, far)));
  return math.where((r > 0.0), total, math.where((m > 0.0), (1.0 / math.where((m > 0.0), m, 1.0)), Infinity));
};

const power_pressure = (r, a, n, k) => {
  return (((power_factor(n, k) * n) * ((Math.pow(a, n) / a) * Math.pow(a, k))) * power_growth(r, a, n, k));
};

const either = (condition, x, y) => {
  if (Boolean(condition)) {
    return x();
  }
  return (Boolean(condition) ? (math.truth(condition) ? x() : y()) : y());
};

const rounded_rate = (t, root, b, k) => {
  let beyond;
  beyond = () => {
    return ((((2.0 * t) / b) * _tip(t, root, b, k)) + sine_integral(Math.atan2(root, b), k));
  };
  return either((t < b), (() => (((2.0 * t) / b) / (1.0 + k))), beyond);
};

const _branches_of_pressure = (r, a, b, power, near, far) => {
  let least, reach, within;
  within = (near < 0.0);
  reach = math.where(within, Math.sqrt((math.maximum(far, 0.0) * (a + b))), difference_root(a, r));
  least = (math.minimum(b, reach) * Math.exp(((-37.0) / math.minimum(math.maximum(power, 0.107), 2.0))));
  return [within, math.where((near === 0.0), least, Math.sqrt((Math.abs(near) * (r + b)))), reach];
};

const _PANEL = 3.0;

const _panel = (scale, reach, longest) => {
  let first, whole;
  whole = Math.asinh((reach / scale));
  first = math.minimum(whole, longest);
  return [first, math.where((first < whole), (scale * Math.sinh(first)), reach)];
};

const growth_far = (integrand, start, reach, scale) => {
  let along, half, long, rising;
  long = (reach > start);
  if ((!Boolean(long))) {
    return math.zeros_like(start);
  }
  half = math.where(long, Math.log((Math.sqrt(reach) / Math.sqrt(math.where(long, start, 1.0)))), 0.0);
  along = (y) => {
    let far;
    far = math.hypot(scale, y);
    return (integrand(y, far) * (y / far));
  };
  rising = math.integral_in_strip(((x) => along((start * Math.exp(x)))), half);
  return (rising + math.integral_in_strip(((x) => along((reach * Math.exp((-x))))), half));
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

const _from_branch = (smooth, scale, reach, k, above = null) => {
  let first, near, rest, start, weighed;
  [first, start] = _panel(scale, reach, _PANEL);
  weighed = (v) => {
    return (smooth((scale * Math.sinh(v)), (scale * Math.cosh(v))) * Math.pow(sinh_over(v), k));
  };
  near = weighted(weighed, first, k, nodes_for(first), above);
  rest = growth_far(((y, far) => (Math.pow(y, k) * smooth(y, far))), start, reach, scale);
  return ((Math.pow(scale, k) * (raised(first, k) * near)) + rest);
};

const growth_beyond_cap = (slope, r, a, b, k, past = null, bend = Infinity) => {
  let below, cube, first, gaps, inner, outer, reach, scale, start, value, within;
  gaps = [...[r, a]].map((x) => (math.truth(past) ? past(x) : (x - b)));
  [within, scale, reach] = _branches_of_pressure(r, a, b, (2.0 + (2.0 * k)), ...gaps);
  [first, start] = _panel(scale, reach, (_PANEL * math.minimum(1.0, (bend / scale))));
  inner = (root, u) => {
    let t;
    t = math.hypot(b, root);
    return (((slope(t, root) * root) / t) * Math.pow(u, k));
  };
  outer = (_, root) => {
    let t;
    t = math.hypot(b, root);
    return ((slope(t, root) * root) / t);
  };
  cube = (x) => {
    let v;
    v = (first * math.raised(x, 3));
    return (((inner((scale * Math.sinh(v)), (scale * Math.cosh(v))) * 3.0) * x) * x);
  };
  below = () => {
    let near;
    near = (first * math.integral(cube, math.ones_like(first), NODES));
    return (near + growth_far(inner, start, reach, scale));
  };
  value = either(within, below, (() => _from_branch(outer, scale, reach, k)));
  return math.where((reach > 0.0), value, 0.0);
};

const _tame = (t, root, k) => {
  return Math.pow((root / t), (1.0 - k));
};

const rounding_rate = (t, root, b, k) => {
  let angle;
  angle = Math.atan2(root, b);
  return ((((2.0 * t) * raised((root / t), k)) / (1.0 + k)) - (b * sine_integral(angle, k)));
};

const _rounding = (b, k) => {
  return ((t, root) => (_tame(t, root, k) * rounding_rate(t, root, b, k)));
};

const _NEAREST = 1e-09;

const growth_from_break = (slope, reach, b, k, order) => {
  let above, smooth;
  above = math.where((((2.0 * k) + order) > 0.0), ((2.0 * k) + order), 1.0);
  smooth = (near, far) => {
    let root;
    root = math.maximum(near, (_NEAREST * b));
    return ((slope(far, root) * Math.pow(far, (1.0 - k))) / Math.pow(root, order));
  };
  return _from_branch(smooth, b, reach, (above - 1.0), above);
};

const _rounded_at = (a, b, k) => {
  let near, reach, turn;
  reach = difference_root(a, b);
  turn = math.minimum(reach, b);
  near = (((2.0 * raised(turn, k)) / Math.pow((1.0 + k), 2)) - growth_from_break(_rounding(b, k), turn, b, k, 2.0));
  return ((near / b) + growth_far(((y, t) => (Math.pow(y, k) * rounded_rate(t, y, b, k))), turn, reach, b));
};

const rounded_pressure = (r, a, b, k) => {
  let at, tip, value;
  tip = math.where((r < b), (power_pressure(math.minimum(r, b), math.minimum(a, b), 2.0, k) / (2.0 * b)), 0.0);
  value = (tip + growth_beyond_cap(((t, root) => rounded_rate(t, root, b, k)), r, a, b, k));
  at = ((r === b) & (a > b));
  return (Boolean(at) ? math.where(at, _rounded_at(math.where(at, a, (2.0 * b)), b, k), value) : value);
};

const _pressure_4 = (r, a, theta, b, H, k) => {
  let growth, inside;
  inside = math.minimum(r, a);
  growth = (rounded_pressure(inside, a, b, k) * Math.tan(theta));
  return math.where((r < a), ((H / Math.PI) * growth), 0.0);
};

const pressure_2 = (r, a, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_4(r, a, theta, b, H, k) : 0.0) : NaN);
};

const _Break = (b, root, more, end = Infinity) => math.record({ b, root, more, end });

const _break_at = (r, a, b) => {
  return _Break(b, difference_root(a, b), ((b - r) * (b + r)));
};

const power_excess = math.kept((n, k) => {
  let change, e, first, half, high, log, low, m, second, third, u, v, x;
  [x, e, half] = [(n / 2.0), ((1.0 - k) / 2.0), ((1.0 + k) / 2.0)];
  log = math.zeros_like((x * e));
  for (m of math.range(Math.trunc(FAR_of_growth))) {
    log = (log + Math.log1p(((x / ((m + 1.0) + x)) * (e / (m + half)))));
  }
  [low, high] = [(FAR_of_growth + (half / 2.0)), ((FAR_of_growth + (half / 2.0)) + x)];
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

const over_cap = (shape, q, root, b, k, end = Infinity) => {
  let along, from_low, from_top, half, low, top;
  low = math.minimum(root, end);
  [top, half] = [math.hypot(low, b), ((Math.log1p(Math.pow((b / low), 2)) / 4.0) + math.zeros_like(q))];
  along = (near, risen) => {
    let more, z;
    more = (risen * (near + low));
    z = Math.sqrt(((root * root) + more));
    return ((((shape(more, z) * (near / z)) * (near / q)) * Math.pow((z / q), k)) / (1.0 + Math.pow((z / q), 2)));
  };
  from_low = (x) => {
    return along((low * Math.exp(x)), (low * Math.expm1(x)));
  };
  from_top = (x) => {
    let near;
    near = (top * Math.exp((-x)));
    return along(near, ((near > (2.0 * low)) ? (near - low) : ((b * (b / (top + low))) + (top * Math.expm1((-x))))));
  };
  return (math.integral_in_strip(from_low, half) + math.integral_in_strip(from_top, half));
};

const _fall = (shape, r, a) => {
  let root;
  root = difference_root(a, r);
  return (shape(r, root) * Math.pow((root / a), 2));
};

const _joined_of_displacement = (gap, a, value, fall) => {
  return ((a > 0.0) ? (gap.outside ? value : (value + fall)) : 0.0);
};

const _broken = (beyond, within, r, a, k, at) => {
  let fall, gap, near, own, tip, value;
  gap = _gap_of_displacement(r, a, k);
  own = _weighed(gap, beyond, a);
  near = from_edge(own, a, gap.q, gap.q, Math.asinh((math.minimum(at.root, (a / 2.0)) / gap.q)), k);
  value = (near + over_angle(own, a, gap.q, math.maximum(Math.atan2(at.root, at.b), SPLIT), k));
  tip = _weighed(gap, ((more, z) => (within(more) / Math.pow((z / a), 2))), a);
  value = (value + over_cap(tip, gap.q, at.root, at.b, k, at.end));
  fall = ((at.more < 0.0) ? _fall(beyond, r, a) : within(math.maximum(at.more, 0.0)));
  return ((a > at.b) ? _joined_of_displacement(gap, a, value, fall) : 0.0);
};

const rounded_displacement = (r, a, b, k) => {
  let at, tip, within;
  at = _break_at(r, a, b);
  within = (more) => {
    return ((at.root * (at.root / (a + b))) + (more / (2.0 * b)));
  };
  tip = (power_displacement(r, a, 2.0, k) / (2.0 * b));
  return ((a <= b) ? tip : _broken(((s, z) => (a * (a / (a + s)))), within, r, a, k, at));
};

const _displacement_4 = (r, a, theta, b, k) => {
  return (rounded_displacement(r, a, b, k) * Math.tan(theta));
};

const displacement_2 = (r, a, theta, b, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_4(r, a, theta, b, k) : 0.0) : NaN);
};

const punch_stiffness = (a, H, k) => {
  return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
};

const _stiffness_3 = (a, H, k) => {
  return punch_stiffness(a, H, k);
};

const _stiffness_2 = (a, H, k, theta = 0.7853981633974483, b = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (H > 1e-30) && (H < 1e+30) && (k > 1e-30) && (k < 1.0) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30))) {
    return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  }
  return _stiffness_3(a, H, k);
};

const stiffness_of_rounded_cone = (a, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness_2(a, H, k) : NaN);
};

const _mean_pressure_2 = (a, theta, b, H, k) => {
  return ((a > 0.0) ? (_force_3(a, theta, b, H, k) / ((Math.PI * a) * a)) : 0.0);
};

const mean_pressure_of_rounded_cone = (a, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure_2(a, theta, b, H, k) : NaN);
};

const _rate_at = (a, root, theta, b, k) => {
  return (rounded_rate(a, root, b, k) * Math.tan(theta));
};

const _with_rate = (load, rate, needs) => {
  return ((a, root) => [load(a, root, ...needs), (a * rate(a, root, ...needs))]);
};

const ROUNDING_of_across = 1.1102230246251565e-16;

const _tip_of_across = (b, end) => {
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
  [radius_at, share, reach] = _tip_of_across(b, end);
  both = (t) => {
    let inner, more, rate, slope, y;
    inner = math.minimum(t, reach);
    [y, rate] = curve((math.truth(above) ? (b * Math.sqrt((1.0 + (t * t)))) : radius_at(inner)), (math.truth(above) ? (b * t) : 0.0));
    [more, slope] = _excess(t, y, rate, base, (math.truth(powers) ? powers[0] : 2.0));
    return [(math.truth(above) ? more : y), (math.truth(above) ? slope : ((rate / y) * share(inner)))];
  };
  [last, rate] = curve(radius_at(reach), math.zeros_like(b));
  wanted = (math.truth(above) ? (value - base) : math.minimum(value, last));
  like = ((math.truth(above) ? last : wanted) / last);
  start = (reach * ((end == null) ? Math.pow(like, (1.0 / tip)) : joining(like, ((rate / last) * share(reach)), tip, 1.0)));
  if (Boolean(above)) {
    start = (math.truth(above) ? _start(curve, (math.truth(above) ? wanted : base), base, b, tip, powers) : start);
  }
  [least, most] = ((end == null) ? [tip, Infinity] : [1.0, tip]);
  t = inverse(both, wanted, start, [(math.truth(above) ? 1.0 : least), (math.truth(above) ? Infinity : most)], (math.truth(above) ? Infinity : reach), ((t) => (math.truth(above) ? 1.0 : share(math.minimum(t, reach)))), true, ((math.truth(above) ? NOISE : ROUNDING_of_across) * value));
  return (math.truth(above) ? (b * Math.sqrt((1.0 + (t * t)))) : math.minimum(b, radius_at(math.minimum(t, reach))));
};

const NEAREST = 1e-12;

const CLOSE_of_unknowns = 0.0001;

const at_break = math.kept((of, b, first, ...needs) => {
  let a, load, rate, root;
  [load, rate] = of;
  [a, root] = [(b * Math.pow((1.0 + (CLOSE_of_unknowns * CLOSE_of_unknowns)), 0.5)), (b * CLOSE_of_unknowns)];
  return [load(b, first, ...needs), load(a, root, ...needs), (a * rate(a, root, ...needs))];
});

const CLOSEST_of_unknowns = 18.3;

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

const SLACK_of_inverse = 1e-06;

const _below = (load, rate, value, base, b, needs, unknown, tip) => {
  let curve, largest, share, start, x;
  largest = unknown.of((b + math.zeros_like(value)));
  share = (x) => {
    let a, step;
    [a, step] = unknown.back(x);
    return ((x * step) / a);
  };
  curve = (x) => {
    let a, own, step;
    [a, step] = unknown.back(x);
    own = load(a, difference_root(a, b), ...needs);
    return [own, (((x * step) * rate(a, difference_root(a, b), ...needs)) / own)];
  };
  start = (largest * Math.pow((value / base), (1.0 / tip)));
  x = inverse(curve, value, start, [SLACK_of_inverse, Infinity], largest, share, true);
  return math.minimum(unknown.back(x)[0], b);
};

const ROUNDING_of_inverse = 1.1102230246251565e-16;

const LOST_of_inverse = 16.0;

const CLOSE_of_inverse = 0.0001;

const _beyond_of_inverse = (load, rate, excess, base, b, needs, least, tip, at_close, slope_at_close) => {
  let curve, curve_at, first, meet, more, more_and_rate, near, noise, place, second, share, slope, start, t, unit, wanted, x;
  curve_at = _with_rate(load, rate, needs);
  more_and_rate = (t, y, slope) => {
    let more;
    slope = (slope * ((t * t) / (1.0 + (t * t))));
    more = math.maximum((y - base), (ROUNDING_of_inverse * base));
    return [more, ((more > ((LOST_of_inverse * ROUNDING_of_inverse) * base)) ? slope : math.maximum(slope, (math.minimum(least, 1.0) * more)))];
  };
  near = (CLOSE_of_inverse * math.ones_like(excess));
  [more, slope] = more_and_rate(near, at_close, slope_at_close);
  second = math.clip((((slope / more) - least) / math.maximum((2.0 - least), ROUNDING_of_inverse)), ROUNDING_of_inverse, (1.0 - ROUNDING_of_inverse));
  meet = (near * Math.pow(((1.0 - second) / second), (1.0 / math.maximum((2.0 - least), 0.2))));
  meet = math.minimum(math.maximum(meet, NEAREST), (1.0 / NEAREST));
  unit = ((more * (1.0 - second)) * Math.pow((meet / near), least));
  place = (x) => {
    let power, t;
    [t, power] = root_of(x, least, 2.0);
    return [(meet * t), power];
  };
  curve = (x) => {
    let own, power, slope, t;
    [t, power] = place(x);
    [own, slope] = more_and_rate(t, ...curve_at((b * Math.sqrt((1.0 + (t * t)))), (b * t)));
    return [own, ((slope / own) / power)];
  };
  share = (x) => {
    let power, t;
    [t, power] = place(x);
    return (((t * t) / (1.0 + (t * t))) / power);
  };
  noise = ((8.0 * ROUNDING_of_inverse) * (base + excess));
  first = place(((excess > 0.0) ? (excess / unit) : 1.0))[0];
  start = power_of((((first > 1.0) ? Math.pow(first, (2.0 / tip)) : first) / meet), least, 2.0);
  wanted = ((excess > 0.0) ? excess : unit);
  x = inverse(curve, wanted, start, [SLACK_of_inverse, Infinity], undefined, share, true, noise);
  t = place(x)[0];
  return ((excess > 0.0) ? (b * Math.sqrt((1.0 + (t * t)))) : b);
};

const radius_across = (load, rate, value, b, needs, tip, least = null, end = null) => {
  let above, base, below, close, radius;
  value = (value + math.zeros(1));
  if (((end == null) && (least == null))) {
    return inverse_across(_with_rate(load, rate, needs), value, (b + math.zeros_like(value)), tip);
  }
  [base, ...close] = at_break([load, rate], b, ((end == null) ? (0.0 * b) : (NEAREST * b)), ...needs);
  base = (base + math.zeros_like(value));
  above = (value > base);
  below = ((end == null) ? radius_itself() : up_to(end, needs.at(-1)));
  radius = (b + math.zeros_like(value));
  if ((!Boolean(above))) {
    radius = _below(load, rate, (math.truth(above) ? base : value), base, b, needs, below, tip);
  }
  if ((!Boolean(above))) {
    return radius;
  }
  return (math.truth(above) ? _beyond_of_inverse(load, rate, (math.truth(above) ? (value - base) : 0.0), base, b, needs, ((least == null) ? 1.0 : least), tip, ...close) : radius);
};

const _radius_from_depth_2 = (d, theta, b, k) => {
  return radius_across(_depth_at, _rate_at, d, b, [theta, b, k], 2.0);
};

const radius_from_depth_2 = (d, theta, b, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth_2(d, theta, b, k) : NaN);
};

const _force_rate_at = (a, root, theta, b, H, k) => {
  return (punch_stiffness(a, H, k) * _rate_at(a, root, theta, b, k));
};

const _radius_from_force_2 = (F, theta, b, H, k) => {
  return radius_across(_force_at, _force_rate_at, F, b, [theta, b, H, k], (3.0 + k));
};

const radius_from_force_2 = (F, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _radius_from_force_2(F, theta, b, H, k) : NaN);
};

const punch_force = (d, a, H, k) => {
  let v14;
  v14 = (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  if (((v14 > 0.0) && (v14 < Infinity))) {
    return (v14 * d);
  }
  return 0.0;
};

const _force_from_depth_of_rounded_cone = (d, theta, b, H, k) => {
  let a;
  a = _radius_from_depth_2(d, theta, b, k);
  return (_force_3(a, theta, b, H, k) + punch_force((d - _depth_3(a, theta, b, k)), a, H, k));
};

const force_from_depth_of_rounded_cone = (d, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth_of_rounded_cone(d, theta, b, H, k) : NaN);
};

const punch_depth = (F, a, H, k) => {
  let v14;
  v14 = (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  if (((v14 > 0.0) && (v14 < Infinity))) {
    return (F / v14);
  }
  return 0.0;
};

const _depth_from_force_of_rounded_cone = (F, theta, b, H, k) => {
  let a;
  a = _radius_from_force_2(F, theta, b, H, k);
  return (_depth_3(a, theta, b, k) + punch_depth((F - _force_3(a, theta, b, H, k)), a, H, k));
};

const depth_from_force_of_rounded_cone = (F, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force_of_rounded_cone(F, theta, b, H, k) : NaN);
};

const graded_retraction = (a, H, k, dgamma) => {
  if ((a > 0.0)) {
    return ((math.sqrt(((6.283185307179586 * dgamma) / H)) * math.sqrt(a)) * math.sqrt(Math.pow(a, (-k))));
  }
  return 0.0;
};

const retraction_of_rounded_cone = (a, H, k, dgamma) => {
  if ((!((0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? graded_retraction(a, H, k, dgamma) : NaN);
};

const _depth_4 = (a, theta, b, H, k, dgamma) => {
  return (_depth_3(a, theta, b, k) - graded_retraction(a, H, k, dgamma));
};

const depth_3 = (a, theta, b, H, k, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_4(a, theta, b, H, k, dgamma) : NaN);
};

const _force_4 = (a, theta, b, H, k, dgamma) => {
  return (_force_3(a, theta, b, H, k) - (punch_stiffness(a, H, k) * graded_retraction(a, H, k, dgamma)));
};

const force_3 = (a, theta, b, H, k, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_4(a, theta, b, H, k, dgamma) : NaN);
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

const _pressure_5 = (r, a, theta, b, H, k, dgamma) => {
  return (_pressure_4(r, a, theta, b, H, k) - tension_of_punch(r, a, H, k, dgamma));
};

const pressure_3 = (r, a, theta, b, H, k, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_5(r, a, theta, b, H, k, dgamma) : 0.0) : NaN);
};

const punch_displacement = (r, a, k) => {
  return ((r > a) ? punch_share(r, a, k) : 1.0);
};

const _displacement_5 = (r, a, theta, b, H, k, dgamma) => {
  return (_displacement_4(r, a, theta, b, k) - (graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)));
};

const displacement_3 = (r, a, theta, b, H, k, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_5(r, a, theta, b, H, k, dgamma) : 0.0) : NaN);
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

const _rate_of_rounded_cone = (a, theta, b, k) => {
  return _rate_at(a, difference_root(a, b), theta, b, k);
};

const _samples_of_rounded_cone = (theta, b, k) => {
  let a;
  a = radii_around(b);
  return ({ radii: a, end: Infinity });
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

const _branches_of_rounded_cone = (theta, b, H, k, dgamma, control) => {
  return branches(((a) => (Math.pow(a, ((1.0 + k) / 2.0)) * _rate_of_rounded_cone(a, theta, b, k))), _samples_of_rounded_cone(theta, b, k), least_steepness_of_punch(control, H, k, dgamma));
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

const _radius_from_depth_3 = (d, theta, b, H, k, dgamma) => {
  let found, pulled, radius, slope, stress, unit;
  unit = exponent_of(b);
  [stress, H] = stress_at(unit, H, k);
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  d = math.ldexp(d, (-unit));
  found = _branches_of_rounded_cone(theta, b, H, k, dgamma, 'depth');
  slope = growth_of(_rate_of_rounded_cone, [theta, b, k], H, k, dgamma, 'depth');
  pulled = pull_of(H, k, dgamma, 'depth');
  radius = stable_radius(d, found, ((a) => _depth_4(a, theta, b, H, k, dgamma)), slope, pulled, radius_itself(), beyond_edge(b), b);
  return math.ldexp(radius, unit);
};

const radius_from_depth_3 = (d, theta, b, H, k, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_depth_3(d, theta, b, H, k, dgamma);
};

const _radius_from_force_3 = (F, theta, b, H, k, dgamma) => {
  let found, pulled, radius, slope, stress, unit;
  unit = exponent_of(b);
  [stress, H] = stress_at(unit, H, k);
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  F = math.ldexp(F, (-(stress + (2 * unit))));
  found = _branches_of_rounded_cone(theta, b, H, k, dgamma, 'force');
  slope = growth_of(_rate_of_rounded_cone, [theta, b, k], H, k, dgamma, 'force');
  pulled = pull_of(H, k, dgamma, 'force');
  radius = stable_radius(F, found, ((a) => _force_4(a, theta, b, H, k, dgamma)), slope, pulled, radius_itself(), beyond_edge(b), b);
  return math.ldexp(radius, unit);
};

const radius_from_force_3 = (F, theta, b, H, k, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_force_3(F, theta, b, H, k, dgamma);
};

const _pull_off_radius_of_rounded_cone = (theta, b, H, k, dgamma, control) => {
  let found, load, radius, stress, unit;
  unit = exponent_of(b);
  [stress, H] = stress_at(unit, H, k);
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  found = _branches_of_rounded_cone(theta, b, H, k, dgamma, control);
  load = ((control === 'force') ? _force_4 : _depth_4);
  radius = math.lowest(found, ((a) => load(a, theta, b, H, k, dgamma)));
  return math.ldexp(radius, unit);
};

const pull_off_of_rounded_cone = (control = 'force', theta, b, H, k, dgamma) => {
  let depth, force, radius;
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  radius = _pull_off_radius_of_rounded_cone(theta, b, H, k, dgamma, control);
  force = ((radius >= 0.0) ? _force_4(radius, theta, b, H, k, dgamma) : NaN);
  depth = ((radius >= 0.0) ? _depth_4(radius, theta, b, H, k, dgamma) : NaN);
  return PullOff(radius, force, depth);
};

const power_depth = (a, n, k) => {
  return (power_factor(n, k) * Math.pow(a, n));
};

const gained_share = (c, a, n) => {
  return (-Math.expm1(((-n) * ((a > c) ? math.log1p(((a - c) / c)) : 0.0))));
};

const power_force = (a, n, k) => {
  return (((power_factor(n, k) * (n / (n + (1.0 + k)))) * Math.pow(a, n)) * raised(a, k));
};

const DECAY = 42.0;

const _span = (c, a, distance) => {
  return math.where((a > c), (0.5 * Math.log1p((((a - c) / distance) * ((a + c) / distance)))), 0.0);
};

const PANEL = 9.0;

const NODES_of_slip = 64;

const _power_growth = (r, c, a, n, k) => {
  let cut, end, falls, inner, integrand, last, lost, outer, side, start, stop, within;
  [inner, outer] = [difference_root(c, r), difference_root(a, r)];
  falls = ((n + (k - 1.0)) >= 0.0);
  end = math.where(falls, a, c);
  start = math.where(falls, outer, inner);
  side = (1.0 - (2.0 * falls));
  lost = (Math.pow((a / outer), 2) * (-Math.expm1((((-2.0) * DECAY) / math.maximum((n - 2.0), 0.001)))));
  cut = ((-0.5) * Math.log1p((-math.minimum(lost, (1.0 - 1e-16)))));
  last = math.where(((n > 2.0) & (lost < 1.0)), cut, Infinity);
  stop = math.minimum(_span(c, a, inner), last);
  integrand = (w) => {
    let base, change, distance;
    distance = (start * Math.exp((side * w)));
    base = math.where(falls, ((r * r) + (distance * distance)), (c * c));
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

const _grown = (quantity, rate, r, c, a, b, k, close) => {
  let branch, holds, integrand, start;
  branch = math.maximum(r, b);
  start = difference_root(c, branch);
  integrand = (w) => {
    let distance, root, t, y;
    distance = (start * Math.exp(w));
    [t, root, y] = [...[0.0, b, r]].map((x) => Math.sqrt((((branch - x) * (branch + x)) + (distance * distance))));
    return (((rate(t, root) * _weight(quantity, t, y, k)) * distance) * (distance / t));
  };
  holds = (close & (start > 0.0));
  return math.where(holds, math.integral_in_strip(integrand, math.where(holds, _span(c, a, start), 0.0)), 0.0);
};

const _difference = (quantity, whole, lengths, b, r, c, a, k) => {
  if ((quantity === 'pressure')) {
    return (whole(r, a, ...lengths, k) - whole(r, c, ...lengths, k));
  }
  return (whole(a, difference_root(a, b), ...lengths, k) - whole(c, difference_root(c, b), ...lengths, k));
};

const _across = (quantity, tip, whole, rate, lengths, b, r, c, a, k) => {
  let beyond, close, from_tip, power, slope, start;
  power = {'pressure': 0.0, 'depth': (1.0 - k), 'force': 2.0}[quantity];
  start = ((quantity === 'pressure') ? r : (0.0 * a));
  close = _close(r, c, a);
  slope = (t, root) => {
    return rate(t, root, ...lengths, k);
  };
  from_tip = () => {
    return (tip(close) + growth_beyond_cap(((t, root) => (slope(t, root) * Math.pow(t, power))), start, a, b, k));
  };
  beyond = () => {
    return _grown(quantity, slope, r, c, a, b, k, (close & (c > b)));
  };
  return either(close, (() => either((c <= b), from_tip, beyond)), (() => _difference(quantity, whole, lengths, b, r, c, a, k)));
};

const rounded_gain = (quantity, whole, rate, lengths, r, c, a, k) => {
  let b, tip;
  [b] = lengths;
  tip = (close) => {
    return (power_gain(quantity, r, c, math.minimum(a, math.maximum(b, c)), 2.0, k) / (2.0 * b));
  };
  return _across(quantity, tip, whole, rate, lengths, b, r, c, a, k);
};

const _tangential_force_2 = (a, c, theta, b, H, k, mu) => {
  let gain;
  gain = (rounded_gain('force', rounded_force, rounded_rate, [b], 0.0, c, a, k) * Math.tan(theta));
  return ((mu * ((2.0 * H) / (1.0 + k))) * gain);
};

const tangential_force_of_rounded_cone = (a, c, theta, b, H, k, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_force_2(a, c, theta, b, H, k, mu) : NaN);
};

const _traction_2 = (r, a, c, theta, b, H, k, mu) => {
  let gain;
  gain = () => {
    let inside;
    inside = math.minimum(r, c);
    return (rounded_gain('pressure', rounded_pressure, rounded_rate, [b], inside, c, a, k) * Math.tan(theta));
  };
  return (mu * either((r < c), (() => ((H / Math.PI) * gain())), (() => _pressure_4(r, a, theta, b, H, k))));
};

const traction_of_rounded_cone = (r, a, c, theta, b, H, k, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction_2(r, a, c, theta, b, H, k, mu) : 0.0) : NaN);
};

const _tangential_displacement_2 = (a, c, theta, b, H, H_x, k, mu) => {
  let gain;
  gain = (rounded_gain('depth', rounded_depth, rounded_rate, [b], 0.0, c, a, k) * Math.tan(theta));
  return ((mu * (H / H_x)) * gain);
};

const tangential_displacement_of_rounded_cone = (a, c, theta, b, H, H_x, k, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement_2(a, c, theta, b, H, H_x, k, mu) : NaN);
};

const _stick_radius_of_rounded_cone = (F_x, a, theta, b, H, k, mu) => {
  let F;
  F = stick_force(_force_3(a, theta, b, H, k), F_x, mu);
  return (((F_x === 0.0) & (a >= 0.0)) ? a : _radius_from_force_2(F, theta, b, H, k));
};

const stick_radius_of_rounded_cone = (F_x, a, theta, b, H, k, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius_of_rounded_cone(F_x, a, theta, b, H, k, mu) : NaN);
};

const _full_slip_displacement_2 = (a, theta, b, H, H_x, k, mu) => {
  return ((mu * (H / H_x)) * _depth_3(a, theta, b, k));
};

const full_slip_displacement_of_rounded_cone = (a, theta, b, H, H_x, k, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement_2(a, theta, b, H, H_x, k, mu) : NaN);
};

const relaxation_maxwell = (t, E, tau) => {
  return (E * Math.exp(((-t) / tau)));
};

const _step_force_maxwell = (t, d, theta, b, E, tau) => {
  return (relaxation_maxwell(t, E, tau) * _force_from_depth(d, theta, b, 1.0));
};

const step_force_maxwell = (t, d, theta, b, E, tau) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_maxwell(t, d, theta, b, E, tau) : NaN);
};

const creep_maxwell = (t, E, tau) => {
  return ((1.0 + (t / tau)) / E);
};

const _step_load_radius_maxwell = (t, F, theta, b, E, tau) => {
  return _radius_from_force((F * creep_maxwell(t, E, tau)), theta, b, 1.0);
};

const step_load_radius_maxwell = (t, F, theta, b, E, tau) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_maxwell(t, F, theta, b, E, tau) : NaN);
};

const relaxation_kelvin_voigt = (t, E, eta) => {
  if ((t > 0.0)) {
    return E;
  }
  return Infinity;
};

const _step_force_kelvin_voigt = (t, d, theta, b, E, eta) => {
  return (relaxation_kelvin_voigt(t, E, eta) * _force_from_depth(d, theta, b, 1.0));
};

const step_force_kelvin_voigt = (t, d, theta, b, E, eta) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_kelvin_voigt(t, d, theta, b, E, eta) : NaN);
};

const creep_kelvin_voigt = (t, E, eta) => {
  return ((-Math.expm1((((-E) * t) / eta))) / E);
};

const _step_load_radius_kelvin_voigt = (t, F, theta, b, E, eta) => {
  return _radius_from_force((F * creep_kelvin_voigt(t, E, eta)), theta, b, 1.0);
};

const step_load_radius_kelvin_voigt = (t, F, theta, b, E, eta) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_kelvin_voigt(t, F, theta, b, E, eta) : NaN);
};

const relaxation_standard_solid = (t, E_inf, E_1, tau) => {
  return (E_inf + (E_1 * Math.exp(((-t) / tau))));
};

const _step_force_standard_solid = (t, d, theta, b, E_inf, E_1, tau) => {
  return (relaxation_standard_solid(t, E_inf, E_1, tau) * _force_from_depth(d, theta, b, 1.0));
};

const step_force_standard_solid = (t, d, theta, b, E_inf, E_1, tau) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_standard_solid(t, d, theta, b, E_inf, E_1, tau) : NaN);
};

const creep_standard_solid = (t, E_inf, E_1, tau) => {
  let v4;
  v4 = (E_inf + E_1);
  return ((1.0 / v4) - (((E_1 / v4) * Math.expm1((-((t / tau) * (E_inf / v4))))) / E_inf));
};

const _step_load_radius_standard_solid = (t, F, theta, b, E_inf, E_1, tau) => {
  return _radius_from_force((F * creep_standard_solid(t, E_inf, E_1, tau)), theta, b, 1.0);
};

const step_load_radius_standard_solid = (t, F, theta, b, E_inf, E_1, tau) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_standard_solid(t, F, theta, b, E_inf, E_1, tau) : NaN);
};

const relaxation_power_creep = (t, E, alpha, t_0) => {
  let v8;
  v8 = (3.141592653589793 * alpha);
  return (((E * Math.pow((t_0 / t), alpha)) * Math.sin(v8)) / v8);
};

const _step_force_power_creep = (t, d, theta, b, E, alpha, t_0) => {
  return (relaxation_power_creep(t, E, alpha, t_0) * _force_from_depth(d, theta, b, 1.0));
};

const step_force_power_creep = (t, d, theta, b, E, alpha, t_0) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_power_creep(t, d, theta, b, E, alpha, t_0) : NaN);
};

const creep_power_creep = (t, E, alpha, t_0) => {
  return (Math.pow((t / t_0), alpha) / E);
};

const _step_load_radius_power_creep = (t, F, theta, b, E, alpha, t_0) => {
  return _radius_from_force((F * creep_power_creep(t, E, alpha, t_0)), theta, b, 1.0);
};

const step_load_radius_power_creep = (t, F, theta, b, E, alpha, t_0) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_power_creep(t, F, theta, b, E, alpha, t_0) : NaN);
};

const once = { peak_pressure: math.kept(peak_pressure), pull_off: math.kept(pull_off), pull_off_of_rounded_cone: math.kept(pull_off_of_rounded_cone) };
const formulas = {
  "d": (v) => depth(v.a, v.theta, v.b),
  "F": (v) => force(v.a, v.theta, v.b, v.E_star),
  "p": (v) => pressure(v.r, v.a, v.theta, v.b, v.E_star),
  "w": (v) => displacement(v.r, v.a, v.theta, v.b),
  "k": (v) => stiffness(v.a, v.theta, v.b, v.E_star),
  "pm": (v) => mean_pressure(v.a, v.theta, v.b, v.E_star),
  "U": (v) => energy(v.a, v.theta, v.b, v.E_star),
  "Fr": (v) => load_within(v.r, v.a, v.theta, v.b, v.E_star),
  "rp": (v) => (once.peak_pressure(v.a, v.theta, v.b, v.E_star).radius ?? NaN),
  "pp": (v) => (once.peak_pressure(v.a, v.theta, v.b, v.E_star).pressure ?? NaN),
  "ad": (v) => radius_from_depth(v.d, v.theta, v.b),
  "aF": (v) => radius_from_force(v.F, v.theta, v.b, v.E_star),
  "Fd": (v) => force_from_depth(v.d, v.theta, v.b, v.E_star),
  "dF": (v) => depth_from_force(v.F, v.theta, v.b, v.E_star),
  "adh.Dl": (v) => retraction(v.a, v.E_star, v.dgamma),
  "adh.d": (v) => depth_of_rounded_cone(v.a, v.theta, v.b, v.E_star, v.dgamma),
  "adh.F": (v) => force_of_rounded_cone(v.a, v.theta, v.b, v.E_star, v.dgamma),
  "adh.p": (v) => pressure_of_rounded_cone(v.r, v.a, v.theta, v.b, v.E_star, v.dgamma),
  "adh.w": (v) => displacement_of_rounded_cone(v.r, v.a, v.theta, v.b, v.E_star, v.dgamma),
  "adh.ad": (v) => radius_from_depth_of_rounded_cone(v.d, v.theta, v.b, v.E_star, v.dgamma),
  "adh.aF": (v) => radius_from_force_of_rounded_cone(v.F, v.theta, v.b, v.E_star, v.dgamma),
  "adh.ac": (v) => (once.pull_off('force', v.theta, v.b, v.E_star, v.dgamma).radius ?? NaN),
  "adh.Fc": (v) => (once.pull_off('force', v.theta, v.b, v.E_star, v.dgamma).force ?? NaN),
  "adh.dc": (v) => (once.pull_off('force', v.theta, v.b, v.E_star, v.dgamma).depth ?? NaN),
  "adh.am": (v) => (once.pull_off('depth', v.theta, v.b, v.E_star, v.dgamma).radius ?? NaN),
  "adh.Fm": (v) => (once.pull_off('depth', v.theta, v.b, v.E_star, v.dgamma).force ?? NaN),
  "adh.dm": (v) => (once.pull_off('depth', v.theta, v.b, v.E_star, v.dgamma).depth ?? NaN),
  "tan.F": (v) => tangential_force(v.a, v.c, v.theta, v.b, v.E_star, v.mu),
  "tan.tau": (v) => traction(v.r, v.a, v.c, v.theta, v.b, v.E_star, v.mu),
  "tan.u": (v) => tangential_displacement(v.a, v.c, v.theta, v.b, v.E_star, v.G_star, v.mu),
  "tan.c": (v) => stick_radius(v.F_x, v.a, v.theta, v.b, v.E_star, v.mu),
  "tan.us": (v) => full_slip_displacement(v.a, v.theta, v.b, v.E_star, v.G_star, v.mu),
  "fgm.d": (v) => depth_2(v.a, v.theta, v.b, v.k),
  "fgm.F": (v) => force_2(v.a, v.theta, v.b, v.H, v.k),
  "fgm.p": (v) => pressure_2(v.r, v.a, v.theta, v.b, v.H, v.k),
  "fgm.w": (v) => displacement_2(v.r, v.a, v.theta, v.b, v.k),
  "fgm.k": (v) => stiffness_of_rounded_cone(v.a, v.theta, v.b, v.H, v.k),
  "fgm.pm": (v) => mean_pressure_of_rounded_cone(v.a, v.theta, v.b, v.H, v.k),
  "fgm.ad": (v) => radius_from_depth_2(v.d, v.theta, v.b, v.k),
  "fgm.aF": (v) => radius_from_force_2(v.F, v.theta, v.b, v.H, v.k),
  "fgm.Fd": (v) => force_from_depth_of_rounded_cone(v.d, v.theta, v.b, v.H, v.k),
  "fgm.dF": (v) => depth_from_force_of_rounded_cone(v.F, v.theta, v.b, v.H, v.k),
  "fgm.adh.Dl": (v) => retraction_of_rounded_cone(v.a, v.H, v.k, v.dgamma),
  "fgm.adh.d": (v) => depth_3(v.a, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.F": (v) => force_3(v.a, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.p": (v) => pressure_3(v.r, v.a, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.w": (v) => displacement_3(v.r, v.a, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.ad": (v) => radius_from_depth_3(v.d, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.aF": (v) => radius_from_force_3(v.F, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.ac": (v) => (once.pull_off_of_rounded_cone('force', v.theta, v.b, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fc": (v) => (once.pull_off_of_rounded_cone('force', v.theta, v.b, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dc": (v) => (once.pull_off_of_rounded_cone('force', v.theta, v.b, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.adh.am": (v) => (once.pull_off_of_rounded_cone('depth', v.theta, v.b, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fm": (v) => (once.pull_off_of_rounded_cone('depth', v.theta, v.b, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dm": (v) => (once.pull_off_of_rounded_cone('depth', v.theta, v.b, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.tan.F": (v) => tangential_force_of_rounded_cone(v.a, v.c, v.theta, v.b, v.H, v.k, v.mu),
  "fgm.tan.tau": (v) => traction_of_rounded_cone(v.r, v.a, v.c, v.theta, v.b, v.H, v.k, v.mu),
  "fgm.tan.u": (v) => tangential_displacement_of_rounded_cone(v.a, v.c, v.theta, v.b, v.H, v.H_x, v.k, v.mu),
  "fgm.tan.c": (v) => stick_radius_of_rounded_cone(v.F_x, v.a, v.theta, v.b, v.H, v.k, v.mu),
  "fgm.tan.us": (v) => full_slip_displacement_of_rounded_cone(v.a, v.theta, v.b, v.H, v.H_x, v.k, v.mu),
  "vis.step_mx": (v) => step_force_maxwell(v.t, v.d, v.theta, v.b, v.E_law, v.tau),
  "vis.load_mx": (v) => step_load_radius_maxwell(v.t, v.F, v.theta, v.b, v.E_law, v.tau),
  "vis.step_kv": (v) => step_force_kelvin_voigt(v.t, v.d, v.theta, v.b, v.E_law, v.eta),
  "vis.load_kv": (v) => step_load_radius_kelvin_voigt(v.t, v.F, v.theta, v.b, v.E_law, v.eta),
  "vis.step_sls": (v) => step_force_standard_solid(v.t, v.d, v.theta, v.b, v.E_inf, v.E_1, v.tau),
  "vis.load_sls": (v) => step_load_radius_standard_solid(v.t, v.F, v.theta, v.b, v.E_inf, v.E_1, v.tau),
  "vis.step_pc": (v) => step_force_power_creep(v.t, v.d, v.theta, v.b, v.E_law, v.alpha, v.t_0),
  "vis.load_pc": (v) => step_load_radius_power_creep(v.t, v.F, v.theta, v.b, v.E_law, v.alpha, v.t_0),
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
   "value": 0.34383
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
   "value": 3.58e-08
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
   "value": 0.006432
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
    "theta",
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
