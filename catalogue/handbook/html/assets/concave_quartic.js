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

const _minimum_depth = (h) => {
  return ((4 * h) / 3);
};

const _energy_of_concave_quartic = (d, a, h, E_star) => {
  let complete, result;
  complete = ((_minimum_depth(h) * (1.0 - 1e-15)) <= d);
  result = (E_star * (((Math.pow(d, 2) * a) + ((((16 * h) / 15) * d) * a)) + (((64 * Math.pow(h, 2)) / 81) * a)));
  return math.where(complete, result, NaN);
};

const _energy = (d, a, h, E_star) => {
  if (((d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if (((((4.0 * h) / 3.0) * 0.999999999999999) <= d)) {
      return (E_star * ((((d * d) * a) + ((((16.0 * h) / 15.0) * d) * a)) + (((64.0 * (h * h)) / 81.0) * a)));
    }
    return NaN;
  }
  return _energy_of_concave_quartic(d, a, h, E_star);
};

const energy = (d, a, h, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _energy(d, a, h, E_star) : NaN);
};

const _force = (d, a, h, E_star) => {
  let complete, result;
  complete = ((_minimum_depth(h) * (1.0 - 1e-15)) <= d);
  result = (((2 * E_star) * a) * (d + ((8 * h) / 15)));
  return math.where(complete, result, NaN);
};

const _load_within_of_concave_quartic = (r, d, a, h, E_star) => {
  let complete, face, result, rise, root, within;
  root = Math.sqrt(((a - r) * (a + r)));
  rise = (Math.pow(r, 2) / (a + root));
  face = (((4 * h) * ((5 * math.raised(a, 4)) + (rise * ((rise * ((120 * Math.pow(a, 2)) + (rise * ((16 * rise) - (80 * a))))) - (40 * math.raised(a, 3)))))) / (45 * math.raised(a, 4)));
  within = (((2 * E_star) * rise) * ((d - _minimum_depth(h)) + face));
  complete = ((_minimum_depth(h) * (1.0 - 1e-15)) <= d);
  result = math.where((r < a), within, _force(d, a, h, E_star));
  return math.where(complete, result, NaN);
};

const _load_within = (r, d, a, h, E_star) => {
  let v12, v14, v15, v16, v40, v42, v48;
  if (((r > 1e-30) && (r < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v14 = (4.0 * h);
    v42 = (v14 / 3.0);
    v48 = ((v42 * 0.999999999999999) <= d);
    if (v48) {
      v40 = (2.0 * E_star);
      if ((r < a)) {
        v12 = ((r * r) / (a + Math.sqrt(((a - r) * (a + r)))));
        v15 = (a * a);
        v16 = (v15 * v15);
        return ((v40 * v12) * ((d - v42) + ((v14 * ((5.0 * v16) + (v12 * ((v12 * ((120.0 * v15) + (v12 * ((16.0 * v12) - (80.0 * a))))) - (40.0 * (a * v15)))))) / (45.0 * v16))));
      }
      if (v48) {
        return ((v40 * a) * (d + ((8.0 * h) / 15.0)));
      }
      return NaN;
    }
    return NaN;
  }
  return _load_within_of_concave_quartic(r, d, a, h, E_star);
};

const load_within = (r, d, a, h, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _load_within(r, d, a, h, E_star) : 0.0) : NaN);
};

const _force_of_concave_quartic = (d, a, h, E_star) => {
  if (((d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if (((((4.0 * h) / 3.0) * 0.999999999999999) <= d)) {
      return (((2.0 * E_star) * a) * (d + ((8.0 * h) / 15.0)));
    }
    return NaN;
  }
  return _force(d, a, h, E_star);
};

const force = (d, a, h, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_of_concave_quartic(d, a, h, E_star) : NaN);
};

const _pressure_of_concave_quartic = (r, d, a, h, E_star) => {
  let complete, face, result, root;
  root = Math.sqrt(((a - r) * (a + r)));
  face = ((((4 * h) * Math.pow(((2 * r) - a), 2)) * Math.pow((a + (2 * r)), 2)) / (9 * math.raised(a, 4)));
  complete = ((_minimum_depth(h) * (1.0 - 1e-15)) <= d);
  result = math.where(((r <= a) & (d > 0.0)), (((E_star / Math.PI) * ((d - _minimum_depth(h)) + face)) / root), 0.0);
  return math.where(complete, result, NaN);
};

const _pressure = (r, d, a, h, E_star) => {
  let v10, v12, v13, v16, v19, v25;
  if (((r > 1e-30) && (r < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v10 = (4.0 * h);
    v25 = (v10 / 3.0);
    if (((v25 * 0.999999999999999) <= d)) {
      if (((r <= a) && (d > 0.0))) {
        v12 = (2.0 * r);
        v13 = (v12 - a);
        v16 = (a + v12);
        v19 = (a * a);
        return (((E_star / 3.141592653589793) * ((d - v25) + (((v10 * (v13 * v13)) * (v16 * v16)) / (9.0 * (v19 * v19))))) / Math.sqrt(((a - r) * (a + r))));
      }
      return 0.0;
    }
    return NaN;
  }
  return _pressure_of_concave_quartic(r, d, a, h, E_star);
};

const pressure = (r, d, a, h, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _pressure(r, d, a, h, E_star) : 0.0) : NaN);
};

const RULE_0 = math.rule([[Infinity, 64]]);

const _log_ratio = (x, y) => {
  let excess;
  excess = ((x - y) / y);
  return math.where(Number.isFinite(excess), Math.log1p(excess), (Math.log(x) - Math.log(y)));
};

const _DECAY = 42.0;

const _span = (r, a, n) => {
  let fall, start;
  start = Math.sqrt(_log_ratio(r, a));
  fall = (_DECAY / (n + 1.0));
  return [start, (fall / (Math.sqrt(((start * start) + fall)) + start))];
};

const _weight = (s) => {
  return ((2.0 * s) / Math.sqrt((-Math.expm1((((-2.0) * s) * s)))));
};

const NODES = 64;

const power_punches = (r, a, n) => {
  let integrand, reach, start;
  [start, reach] = _span(r, a, n);
  integrand = (step) => {
    let s;
    s = (start + step);
    return (Math.exp((((-(n + 1.0)) * step) * ((2.0 * start) + step))) * _weight(s));
  };
  return ((a / r) * math.integral(integrand, reach, NODES));
};

const _profile = (r, a, h) => {
  return math.where((r <= a), (((-h) * math.raised(r, 4)) / math.raised(a, 4)), NaN);
};

const _displacement_of_concave_quartic = (r, d, a, h) => {
  let angle, complete, inside, outside, result;
  angle = Math.atan2(a, Math.sqrt(((r - a) * (r + a))));
  outside = ((2 / Math.PI) * ((d * angle) + (((8 * h) / 3) * power_punches(r, a, 4))));
  inside = (d - _profile(r, a, h));
  complete = ((_minimum_depth(h) * (1.0 - 1e-15)) <= d);
  result = math.where((r > a), outside, inside);
  return math.where(complete, result, NaN);
};

const _displacement = (r, d, a, h) => {
  let node, v14, v21, v27, v30, v31, v35, v4, v47, v48, v57, v60, v64, weight;
  if (((r > 1e-30) && (r < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30))) {
    if (((((4.0 * h) / 3.0) * 0.999999999999999) <= d)) {
      if ((r > a)) {
        v4 = (r - a);
        v14 = (v4 / a);
        v21 = Math.sqrt((Number.isFinite(v14) ? Math.log1p(v14) : (Math.log(r) - Math.log(a))));
        v27 = (8.4 / (Math.sqrt(((v21 * v21) + 8.4)) + v21));
        v35 = (2.0 * v21);
        v48 = [];
        for ([node, weight] of RULE_0((v27 / 1.0))) {
          v30 = (node * v27);
          v31 = (v21 + v30);
          v47 = (Math.exp((((-5.0) * v30) * (v35 + v30))) * ((2.0 * v31) / Math.sqrt((-Math.expm1((((-2.0) * v31) * v31))))));
          v48.push((weight * v47));
        }
        v48 = (math.fsum(v48) * v27);
        return (0.6366197723675814 * ((d * Math.atan2(a, Math.sqrt((v4 * (r + a))))) + (((8.0 * h) / 3.0) * ((a / r) * v48))));
      }
      if ((r <= a)) {
        v57 = (r * r);
        v60 = (a * a);
        v64 = (((-h) * (v57 * v57)) / (v60 * v60));
      } else {
        v64 = NaN;
      }
      return (d - v64);
    }
    return NaN;
  }
  return _displacement_of_concave_quartic(r, d, a, h);
};

const displacement = (r, d, a, h) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _displacement(r, d, a, h) : 0.0) : NaN);
};

const _stiffness_of_concave_quartic = (a, E_star) => {
  return ((2 * E_star) * a);
};

const _stiffness = (a, E_star, h = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (h > 1e-30) && (h < 1e+30))) {
    return ((2.0 * E_star) * a);
  }
  return _stiffness_of_concave_quartic(a, E_star);
};

const stiffness = (a, h, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return _stiffness(a, E_star);
};

const _minimum_force = (a, h, E_star) => {
  return ((((56 * E_star) * h) / 15) * a);
};

const _depth_from_force_of_concave_quartic = (F, a, h, E_star) => {
  let complete, result;
  complete = ((_minimum_force(a, h, E_star) * (1.0 - 1e-15)) <= F);
  result = ((F / ((2 * E_star) * a)) - ((8 * h) / 15));
  return math.where(complete, result, NaN);
};

const _depth_from_force = (F, a, h, E_star) => {
  if (((F > 1e-30) && (F < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if (((((((56.0 * E_star) * h) / 15.0) * a) * 0.999999999999999) <= F)) {
      return ((F / ((2.0 * E_star) * a)) - ((8.0 * h) / 15.0));
    }
    return NaN;
  }
  return _depth_from_force_of_concave_quartic(F, a, h, E_star);
};

const depth_from_force = (F, a, h, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force(F, a, h, E_star) : NaN);
};

const _zero_radius_of_concave_quartic = (a) => {
  return (a / 2);
};

const _zero_radius = (a, h = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30))) {
    return (a / 2.0);
  }
  return _zero_radius_of_concave_quartic(a);
};

const zero_radius = (a, h) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity)))) {
    return NaN;
  }
  return _zero_radius(a);
};

const _minimum_depth_of_concave_quartic = (h, a = 1.0) => {
  if (((h > 1e-30) && (h < 1e+30) && (a > 1e-30) && (a < 1e+30))) {
    return ((4.0 * h) / 3.0);
  }
  return _minimum_depth(h);
};

const minimum_depth = (a, h) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity)))) {
    return NaN;
  }
  return _minimum_depth_of_concave_quartic(h);
};

const _minimum_force_of_concave_quartic = (a, h, E_star) => {
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    return ((((56.0 * E_star) * h) / 15.0) * a);
  }
  return _minimum_force(a, h, E_star);
};

const minimum_force = (a, h, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return _minimum_force_of_concave_quartic(a, h, E_star);
};

const hess_retraction = (a, E_star, dgamma) => {
  return (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star)));
};

const retraction = (a, E_star, dgamma) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return hess_retraction(a, E_star, dgamma);
};

const _pull_off_depth_of_concave_quartic = (a, h, E_star, dgamma) => {
  return ((((-8) * h) / 3) - hess_retraction(a, E_star, dgamma));
};

const _pull_off_depth = (a, h, E_star, dgamma) => {
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    return ((((-8.0) * h) / 3.0) - (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))));
  }
  return _pull_off_depth_of_concave_quartic(a, h, E_star, dgamma);
};

const _pull_off_force_of_concave_quartic = (a, h, E_star, dgamma) => {
  return ((((-2) * a) * Math.sqrt(((((2 * Math.PI) * E_star) * dgamma) * a))) - ((((64 * E_star) * h) / 15) * a));
};

const _pull_off_force = (a, h, E_star, dgamma) => {
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    return ((((-2.0) * a) * Math.sqrt((((6.283185307179586 * E_star) * dgamma) * a))) - ((((64.0 * E_star) * h) / 15.0) * a));
  }
  return _pull_off_force_of_concave_quartic(a, h, E_star, dgamma);
};

const PullOff = (radius, force, depth) => math.record({ radius, force, depth });

const pull_off = (control = 'force', a, h, E_star, dgamma) => {
  let depth, force;
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  depth = _pull_off_depth(a, h, E_star, dgamma);
  force = _pull_off_force(a, h, E_star, dgamma);
  return PullOff(((depth * 0.0) + a), force, depth);
};

const _minimum_depth_2 = (a, h, k) => {
  let v8;
  v8 = (k + 1.0);
  return (((((-4.0) * h) * (k - 1.0)) / ((v8 * v8) * (k + 3.0))) + (0.0 * a));
};

const punch_stiffness = (a, H, k) => {
  return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
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

const _force_2 = (d, a, h, H, k) => {
  let complete;
  complete = ((_minimum_depth_2(a, h, k) * (1.0 - 1e-15)) <= d);
  return (math.truth(complete) ? (punch_stiffness(a, H, k) * (d + (((h * power_factor(4.0, k)) * (1.0 + k)) / ((4.0 + 1.0) + k)))) : NaN);
};

const force_of_concave_quartic = (d, a, h, H, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_2(d, a, h, H, k) : NaN);
};

const _minimum_depth_3 = (a, h, k) => {
  return (((((-4) * h) * (k - 1)) / (Math.pow((k + 1), 2) * (k + 3))) + (0.0 * a));
};

const punch_pressure = (r, a, H, k) => {
  let v4, v9;
  if ((r < a)) {
    v4 = (a - r);
    v9 = math.sqrt(((((v4 > 0.0) || (v4 !== v4)) ? v4 : 0.0) * (a + r)));
    return (((H / 3.141592653589793) * Math.pow(v9, k)) / v9);
  }
  if ((r > a)) {
    return 0.0;
  }
  return Infinity;
};

const _pressure_3 = (r, d, a, h, H, k) => {
  let face, least, pressure;
  least = _minimum_depth_3(a, h, k);
  face = (((4 * h) * Math.pow((((k * Math.pow(a, 2)) + (4 * Math.pow(r, 2))) - Math.pow(a, 2)), 2)) / ((math.raised(a, 4) * Math.pow((k + 1), 2)) * Math.pow((k + 3), 2)));
  pressure = (((d - least) + face) * punch_pressure(r, a, H, k));
  return math.where(((least * (1.0 - 1e-15)) <= d), pressure, NaN);
};

const _pressure_2 = (r, d, a, h, H, k) => {
  let v11, v13, v15, v20, v23, v28, v38, v42, v52;
  if (((r > 1e-30) && (r < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (H > 1e-30) && (H < 1e+30) && (k > 1e-30) && (k < 1.0))) {
    v11 = (k + 1.0);
    v13 = (v11 * v11);
    v15 = (k + 3.0);
    v20 = (((((-4.0) * h) * (k - 1.0)) / (v13 * v15)) + (0.0 * a));
    if (((v20 * 0.999999999999999) <= d)) {
      v23 = (a * a);
      v28 = (((k * v23) + (4.0 * (r * r))) - v23);
      if ((r < a)) {
        v38 = (a - r);
        v42 = Math.sqrt(((((v38 > 0.0) || (v38 !== v38)) ? v38 : 0.0) * (a + r)));
        v52 = (((H / 3.141592653589793) * Math.pow(v42, k)) / v42);
      } else {
        v52 = ((r > a) ? 0.0 : Infinity);
      }
      return (((d - v20) + (((4.0 * h) * (v28 * v28)) / (((v23 * v23) * v13) * (v15 * v15)))) * v52);
    }
    return NaN;
  }
  return _pressure_3(r, d, a, h, H, k);
};

const pressure_of_concave_quartic = (r, d, a, h, H, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _pressure_2(r, d, a, h, H, k) : 0.0) : NaN);
};

const difference_root = (x, y) => {
  let v2;
  v2 = (x - y);
  return math.sqrt(((((v2 > 0.0) || (v2 !== v2)) ? v2 : 0.0) * (x + y)));
};

const punch_scale = (k) => {
  return (0.6366197723675814 * Math.sin((1.5707963267948966 * (1.0 - Math.abs(k)))));
};

const EDGE = [[3.0, 32], [11.0, 64]];

const raised = (x, k) => {
  if ((x > 0.0)) {
    return (x * Math.pow(x, k));
  }
  return 0.0;
};

const NODES_of_rules = 64;

const weighted = (smooth, stop, power, count = NODES_of_rules, above = null) => {
  let end, pairs;
  if ((power >= (-0.25))) {
    return math.fsum([...math.products(power, count, false)].map(([node, weight]) => (weight * smooth((node * stop)))));
  }
  above = ((above == null) ? (1.0 + power) : above);
  end = smooth(0.0);
  pairs = math.products(above, count, true);
  return ((end / above) + math.fsum([...pairs].map(([node, weight]) => (weight * (smooth((node * stop)) - end)))));
};

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

const STEEP = 16.0;

const _from_edge_of_power = (shape, q, a, n, k) => {
  return from_edge(shape, a, q, q, Math.asinh(((a / q) / 2.0)), k, Boolean((n > STEEP)));
};

const sine_over = (y) => {
  let v2;
  v2 = (y > 0.0);
  if (v2) {
    return (Math.sin(y) / (math.truth(v2) ? y : 1.0));
  }
  return 1.0;
};

const kernel = (sine, cosine, ratio, k) => {
  let v9;
  v9 = (ratio * sine);
  return (((ratio * Math.pow(ratio, k)) * (Math.pow(sine, k) * cosine)) / (1.0 + (v9 * v9)));
};

const SPLIT = 0.5235987755982988;

const _to_axis = (q) => {
  return math.full(math.repeated([1], math.ndim(q)), ((Math.PI / 2.0) - SPLIT));
};

const power_sag = (r, a, n, k) => {
  let far, near, q, reach, smooth, weight, whole;
  q = difference_root(r, a);
  near = _from_edge_of_power(((s, z) => Math.exp(((n / 2.0) * Math.log1p((-Math.pow((z / a), 2)))))), q, a, n, k);
  whole = Math.floor(n);
  weight = (n - whole);
  smooth = (x) => {
    return ((Math.pow(sine_over(x), weight) * Math.pow(Math.sin(x), whole)) * kernel(Math.cos(x), Math.sin(x), (a / q), k));
  };
  reach = _to_axis(q);
  far = ((Math.pow(reach, weight) * reach) * weighted(smooth, reach, weight));
  return ((punch_scale(k) * Math.pow(a, n)) * (near + far));
};

const either = (condition, x, y) => {
  if (Boolean(condition)) {
    return x();
  }
  return (Boolean(condition) ? (math.truth(condition) ? x() : y()) : y());
};

const _displacement_2 = (r, d, a, h, k) => {
  let complete, outside, value;
  complete = ((_minimum_depth_2(a, h, k) * (1.0 - 1e-15)) <= d);
  outside = () => {
    return ((d * punch_share(r, a, k)) + ((h * power_sag(r, a, 4.0, k)) / Math.pow(a, 4.0)));
  };
  value = either((r > a), outside, (() => (d - _profile(r, a, h))));
  return (math.truth(complete) ? value : NaN);
};

const displacement_of_concave_quartic = (r, d, a, h, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _displacement_2(r, d, a, h, k) : 0.0) : NaN);
};

const _stiffness_3 = (a, H, k) => {
  return punch_stiffness(a, H, k);
};

const _stiffness_2 = (a, H, k, h = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (H > 1e-30) && (H < 1e+30) && (k > 1e-30) && (k < 1.0) && (h > 1e-30) && (h < 1e+30))) {
    return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  }
  return _stiffness_3(a, H, k);
};

const stiffness_of_concave_quartic = (a, h, H, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return _stiffness_2(a, H, k);
};

const _minimum_force_2 = (a, h, H, k) => {
  return (punch_stiffness(a, H, k) * (_minimum_depth_2(a, h, k) + (((h * power_factor(4.0, k)) * (1.0 + k)) / ((4.0 + 1.0) + k))));
};

const _depth_from_force_2 = (F, a, h, H, k) => {
  let complete;
  complete = ((_minimum_force_2(a, h, H, k) * (1.0 - 1e-15)) <= F);
  return (math.truth(complete) ? ((F / punch_stiffness(a, H, k)) - (((h * power_factor(4.0, k)) * (1.0 + k)) / ((4.0 + 1.0) + k))) : NaN);
};

const depth_from_force_of_concave_quartic = (F, a, h, H, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force_2(F, a, h, H, k) : NaN);
};

const _zero_radius_3 = (a, h, k) => {
  return (((a * Math.sqrt((1 - k))) / 2) + (0.0 * h));
};

const _zero_radius_2 = (a, h, k) => {
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (k > 1e-30) && (k < 1.0))) {
    return (((a * Math.sqrt((1.0 - k))) / 2.0) + (0.0 * h));
  }
  return _zero_radius_3(a, h, k);
};

const zero_radius_of_concave_quartic = (a, h, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return _zero_radius_2(a, h, k);
};

const minimum_depth_of_concave_quartic = (a, h, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return _minimum_depth_2(a, h, k);
};

const minimum_force_of_concave_quartic = (a, h, H, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return _minimum_force_2(a, h, H, k);
};

const graded_retraction = (a, H, k, dgamma) => {
  if ((a > 0.0)) {
    return ((math.sqrt(((6.283185307179586 * dgamma) / H)) * math.sqrt(a)) * math.sqrt(Math.pow(a, (-k))));
  }
  return 0.0;
};

const retraction_of_concave_quartic = (a, H, k, dgamma) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return graded_retraction(a, H, k, dgamma);
};

const _pull_off_depth_2 = (a, h, H, k, dgamma) => {
  return (((-h) * power_factor(4.0, k)) - graded_retraction(a, H, k, dgamma));
};

const _pull_off_force_2 = (a, h, H, k, dgamma) => {
  return ((-punch_stiffness(a, H, k)) * ((((h * power_factor(4.0, k)) * 4.0) / ((4.0 + 1.0) + k)) + graded_retraction(a, H, k, dgamma)));
};

const pull_off_of_concave_quartic = (control = 'force', a, h, H, k, dgamma) => {
  let depth, force;
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  depth = _pull_off_depth_2(a, h, H, k, dgamma);
  force = _pull_off_force_2(a, h, H, k, dgamma);
  return PullOff(((depth * 0.0) + a), force, depth);
};

const relaxation_maxwell = (t, E, tau) => {
  return (E * Math.exp(((-t) / tau)));
};

const _step_force_maxwell_of_concave_quartic = (t, d, a, h, E, tau) => {
  return (relaxation_maxwell(t, E, tau) * _force(d, a, h, 1.0));
};

const _step_force_maxwell = (t, d, a, h, E, tau) => {
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E > 1e-30) && (E < 1e+30) && (tau > 1e-30) && (tau < 1e+30))) {
    return ((E * Math.exp(((-t) / tau))) * (((((4.0 * h) / 3.0) * 0.999999999999999) <= d) ? ((2.0 * a) * (d + ((8.0 * h) / 15.0))) : NaN));
  }
  return _step_force_maxwell_of_concave_quartic(t, d, a, h, E, tau);
};

const step_force_maxwell = (t, d, a, h, E, tau) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_maxwell(t, d, a, h, E, tau) : NaN);
};

const relaxation_kelvin_voigt = (t, E, eta) => {
  if ((t > 0.0)) {
    return E;
  }
  return Infinity;
};

const _step_force_kelvin_voigt_of_concave_quartic = (t, d, a, h, E, eta) => {
  return (relaxation_kelvin_voigt(t, E, eta) * _force(d, a, h, 1.0));
};

const _step_force_kelvin_voigt = (t, d, a, h, E, eta) => {
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E > 1e-30) && (E < 1e+30) && (eta > 1e-30) && (eta < 1e+30))) {
    return (((t > 0.0) ? E : Infinity) * (((((4.0 * h) / 3.0) * 0.999999999999999) <= d) ? ((2.0 * a) * (d + ((8.0 * h) / 15.0))) : NaN));
  }
  return _step_force_kelvin_voigt_of_concave_quartic(t, d, a, h, E, eta);
};

const step_force_kelvin_voigt = (t, d, a, h, E, eta) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_kelvin_voigt(t, d, a, h, E, eta) : NaN);
};

const relaxation_standard_solid = (t, E_inf, E_1, tau) => {
  return (E_inf + (E_1 * Math.exp(((-t) / tau))));
};

const _step_force_standard_solid_of_concave_quartic = (t, d, a, h, E_inf, E_1, tau) => {
  return (relaxation_standard_solid(t, E_inf, E_1, tau) * _force(d, a, h, 1.0));
};

const _step_force_standard_solid = (t, d, a, h, E_inf, E_1, tau) => {
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E_inf > 1e-30) && (E_inf < 1e+30) && (E_1 > 1e-30) && (E_1 < 1e+30) && (tau > 1e-30) && (tau < 1e+30))) {
    return ((E_inf + (E_1 * Math.exp(((-t) / tau)))) * (((((4.0 * h) / 3.0) * 0.999999999999999) <= d) ? ((2.0 * a) * (d + ((8.0 * h) / 15.0))) : NaN));
  }
  return _step_force_standard_solid_of_concave_quartic(t, d, a, h, E_inf, E_1, tau);
};

const step_force_standard_solid = (t, d, a, h, E_inf, E_1, tau) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_standard_solid(t, d, a, h, E_inf, E_1, tau) : NaN);
};

const relaxation_power_creep = (t, E, alpha, t_0) => {
  let v8;
  v8 = (3.141592653589793 * alpha);
  return (((E * Math.pow((t_0 / t), alpha)) * Math.sin(v8)) / v8);
};

const _step_force_power_creep_of_concave_quartic = (t, d, a, h, E, alpha, t_0) => {
  return (relaxation_power_creep(t, E, alpha, t_0) * _force(d, a, h, 1.0));
};

const _step_force_power_creep = (t, d, a, h, E, alpha, t_0) => {
  let v11;
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E > 1e-30) && (E < 1e+30) && (alpha > 1e-30) && (alpha < 1.0) && (t_0 > 1e-30) && (t_0 < 1e+30))) {
    v11 = (3.141592653589793 * alpha);
    return ((((E * Math.pow((t_0 / t), alpha)) * Math.sin(v11)) / v11) * (((((4.0 * h) / 3.0) * 0.999999999999999) <= d) ? ((2.0 * a) * (d + ((8.0 * h) / 15.0))) : NaN));
  }
  return _step_force_power_creep_of_concave_quartic(t, d, a, h, E, alpha, t_0);
};

const step_force_power_creep = (t, d, a, h, E, alpha, t_0) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_power_creep(t, d, a, h, E, alpha, t_0) : NaN);
};

const once = { pull_off: math.kept(pull_off), pull_off_of_concave_quartic: math.kept(pull_off_of_concave_quartic) };
const formulas = {
  "U": (v) => energy(v.d, v.a, v.h, v.E_star),
  "Fr": (v) => load_within(v.r, v.d, v.a, v.h, v.E_star),
  "F": (v) => force(v.d, v.a, v.h, v.E_star),
  "p": (v) => pressure(v.r, v.d, v.a, v.h, v.E_star),
  "w": (v) => displacement(v.r, v.d, v.a, v.h),
  "k": (v) => stiffness(v.a, v.h, v.E_star),
  "dF": (v) => depth_from_force(v.F, v.a, v.h, v.E_star),
  "rz": (v) => zero_radius(v.a, v.h),
  "dmin": (v) => minimum_depth(v.a, v.h),
  "Fmin": (v) => minimum_force(v.a, v.h, v.E_star),
  "adh.Dl": (v) => retraction(v.a, v.E_star, v.dgamma),
  "adh.Fc": (v) => (once.pull_off('force', v.a, v.h, v.E_star, v.dgamma).force ?? NaN),
  "adh.dc": (v) => (once.pull_off('force', v.a, v.h, v.E_star, v.dgamma).depth ?? NaN),
  "fgm.F": (v) => force_of_concave_quartic(v.d, v.a, v.h, v.H, v.k),
  "fgm.p": (v) => pressure_of_concave_quartic(v.r, v.d, v.a, v.h, v.H, v.k),
  "fgm.w": (v) => displacement_of_concave_quartic(v.r, v.d, v.a, v.h, v.k),
  "fgm.k": (v) => stiffness_of_concave_quartic(v.a, v.h, v.H, v.k),
  "fgm.dF": (v) => depth_from_force_of_concave_quartic(v.F, v.a, v.h, v.H, v.k),
  "fgm.rz": (v) => zero_radius_of_concave_quartic(v.a, v.h, v.k),
  "fgm.dmin": (v) => minimum_depth_of_concave_quartic(v.a, v.h, v.k),
  "fgm.Fmin": (v) => minimum_force_of_concave_quartic(v.a, v.h, v.H, v.k),
  "fgm.adh.Dl": (v) => retraction_of_concave_quartic(v.a, v.H, v.k, v.dgamma),
  "fgm.adh.Fc": (v) => (once.pull_off_of_concave_quartic('force', v.a, v.h, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dc": (v) => (once.pull_off_of_concave_quartic('force', v.a, v.h, v.H, v.k, v.dgamma).depth ?? NaN),
  "vis.step_mx": (v) => step_force_maxwell(v.t, v.d, v.a, v.h, v.E_law, v.tau),
  "vis.step_kv": (v) => step_force_kelvin_voigt(v.t, v.d, v.a, v.h, v.E_law, v.eta),
  "vis.step_sls": (v) => step_force_standard_solid(v.t, v.d, v.a, v.h, v.E_inf, v.E_1, v.tau),
  "vis.step_pc": (v) => step_force_power_creep(v.t, v.d, v.a, v.h, v.E_law, v.alpha, v.t_0),
};
window.calculator = { ...{
 "fields": [
  {
   "name": "a",
   "tex": "a",
   "meaning": "contact radius",
   "unit": "m",
   "rule": "a > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 0.002
  },
  {
   "name": "h",
   "tex": "h",
   "meaning": "height or depth of the profile",
   "unit": "m",
   "rule": "h > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 2e-06
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
   "value": 5000.0
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
  }
 ],
 "formulas": {
  "U": {
   "gives": "U",
   "needs": [
    "d",
    "a",
    "h",
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
    "d",
    "a",
    "h",
    "E_star"
   ],
   "unit": "N",
   "place": "inside",
   "suffix": "Fr",
   "medium": 0
  },
  "F": {
   "gives": "F",
   "needs": [
    "d",
    "a",
    "h",
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
    "d",
    "a",
    "h",
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
    "d",
    "a",
    "h"
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
    "E_star"
   ],
   "unit": "N/m",
   "place": "",
   "suffix": "k",
   "medium": 0
  },
  "dF": {
   "gives": "d",
   "needs": [
    "F",
    "a",
    "h",
    "E_star"
   ],
   "unit": "m",
   "place": "",
   "suffix": "dF",
   "medium": 0
  },
  "rz": {
   "gives": "r_zero",
   "needs": [
    "a",
    "h"
   ],
   "unit": "m",
   "place": "",
   "suffix": "rz",
   "medium": 0
  },
  "dmin": {
   "gives": "d",
   "needs": [
    "a",
    "h"
   ],
   "unit": "m",
   "place": "",
   "suffix": "dmin",
   "medium": 0
  },
  "Fmin": {
   "gives": "F",
   "needs": [
    "a",
    "h",
    "E_star"
   ],
   "unit": "N",
   "place": "",
   "suffix": "Fmin",
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
  "adh.Fc": {
   "gives": "F",
   "needs": [
    "a",
    "h",
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
    "a",
    "h",
    "E_star",
    "dgamma"
   ],
   "unit": "m",
   "place": "",
   "suffix": "",
   "medium": 0
  },
  "fgm.F": {
   "gives": "F",
   "needs": [
    "d",
    "a",
    "h",
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
    "d",
    "a",
    "h",
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
    "d",
    "a",
    "h",
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
    "H",
    "k"
   ],
   "unit": "N/m",
   "place": "",
   "suffix": "k",
   "medium": 1
  },
  "fgm.dF": {
   "gives": "d",
   "needs": [
    "F",
    "a",
    "h",
    "H",
    "k"
   ],
   "unit": "m",
   "place": "",
   "suffix": "dF",
   "medium": 1
  },
  "fgm.rz": {
   "gives": "r_zero",
   "needs": [
    "a",
    "h",
    "k"
   ],
   "unit": "m",
   "place": "",
   "suffix": "rz",
   "medium": 1
  },
  "fgm.dmin": {
   "gives": "d",
   "needs": [
    "a",
    "h",
    "k"
   ],
   "unit": "m",
   "place": "",
   "suffix": "dmin",
   "medium": 1
  },
  "fgm.Fmin": {
   "gives": "F",
   "needs": [
    "a",
    "h",
    "H",
    "k"
   ],
   "unit": "N",
   "place": "",
   "suffix": "Fmin",
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
  "fgm.adh.Fc": {
   "gives": "F",
   "needs": [
    "a",
    "h",
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
    "a",
    "h",
    "H",
    "k",
    "dgamma"
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
    "a",
    "h",
    "E_law",
    "tau"
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
    "a",
    "h",
    "E_law",
    "eta"
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
    "a",
    "h",
    "E_inf",
    "E_1",
    "tau"
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
    "a",
    "h",
    "E_law",
    "alpha",
    "t_0"
   ],
   "unit": "N",
   "place": "",
   "suffix": "",
   "medium": 0
  }
 },
 "place": "r"
}, evaluate: formulas };
})();
