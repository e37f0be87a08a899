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
  return ((Math.tan(theta) * a) * Math.atan((a / b)));
};

const depth = (a, theta, b) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth(a, theta, b) : NaN);
};

const _force = (a, theta, b, E_star) => {
  let v11, v15, v58;
  v11 = (a / b);
  if ((v11 < 1.0)) {
    v15 = (v11 * v11);
    v58 = ((v11 * v15) * (((((((((((((2.229767813968649e-06 * v15) + 0.0021043873129700233) * v15) + 0.04325113828415611) * v15) + 0.2725778671008127) * v15) + 0.7123414383945195) * v15) + 0.8116412201960678) * v15) + 0.3333333333333333) / ((((((((((((0.002445452808893491 * v15) + 0.06453295925870227) * v15) + 0.5368820963772863) * v15) + 1.9680296155712274) * v15) + 3.5294070829658954) * v15) + 3.034923660588189) * v15) + 1.0)));
  } else {
    v58 = (v11 - Math.atan(v11));
  }
  return ((E_star * Math.tan(theta)) * (((a * a) * Math.atan2(a, b)) + ((b * b) * v58)));
};

const force = (a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force(a, theta, b, E_star) : NaN);
};

const RULE_0 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _slope = (t, theta, b) => {
  let angle;
  angle = Math.atan((t / b));
  return ((Math.tan(theta) * angle) + (((b * Math.tan(theta)) * t) / (Math.pow(t, 2) + Math.pow(b, 2))));
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
  below = math.where((below > 0.0), below, Infinity);
  fallen = (v) => {
    return ((Math.exp((-v)) * ((2.0 * even) - (side * Math.expm1(((-2.0) * (stop - v)))))) / below);
  };
  return fallen;
};

const pressure_integral_sinh = math.in_groups((slope, r, a, b) => {
  let fallen, integrand, reach, scale, stop;
  [scale, reach] = [Math.sqrt(((r * r) + (b * b))), difference_root(a, r)];
  stop = Math.asinh((reach / scale));
  fallen = falling(stop);
  integrand = (v) => {
    let t, u;
    u = (reach * fallen(v));
    t = Math.sqrt(((r * r) + (u * u)));
    return ((slope(t) / t) * Math.sqrt(((scale * scale) + (u * u))));
  };
  return [integrand, stop, 1.0, true, 0.0];
});

const _pressure_of_hyperboloid = (r, a, theta, b, E_star) => {
  let within;
  within = pressure_integral_sinh(_slope, [theta, b], r, a, b);
  return math.where((r < a), ((E_star / Math.PI) * within), 0.0);
};

const _pressure = (r, a, theta, b, E_star) => {
  let node, v14, v16, v21, v24, v25, v34, v35, v37, v40, v42, v46, v5, v51, v54, v55, v8, v9, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((r < a)) {
      v5 = (r * r);
      v8 = Math.sqrt((v5 + (b * b)));
      v9 = (a - r);
      v14 = Math.sqrt(((((v9 > 0.0) || (v9 !== v9)) ? v9 : 0.0) * (a + r)));
      v16 = Math.asinh((v14 / v8));
      v21 = (0.0 - Math.expm1(((-2.0) * v16)));
      v24 = ((v21 > 0.0) ? v21 : Infinity);
      v40 = Math.tan(theta);
      v42 = (b * v40);
      v46 = (b * b);
      v51 = (v8 * v8);
      v55 = [];
      for ([node, weight] of RULE_0((v16 / 1.0))) {
        v25 = (node * v16);
        v34 = (v14 * ((Math.exp((-v25)) * (0.0 - Math.expm1(((-2.0) * (v16 - v25))))) / v24));
        v35 = (v34 * v34);
        v37 = Math.sqrt((v5 + v35));
        v54 = ((((v40 * Math.atan((v37 / b))) + ((v42 * v37) / ((v37 * v37) + v46))) / v37) * Math.sqrt((v51 + v35)));
        v55.push((weight * v54));
      }
      v55 = (math.fsum(v55) * v16);
      return ((E_star / 3.141592653589793) * v55);
    }
    return 0.0;
  }
  return _pressure_of_hyperboloid(r, a, theta, b, E_star);
};

const pressure = (r, a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure(r, a, theta, b, E_star) : 0.0) : NaN);
};

const RULE_0_of_hyperboloid = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _displacement = (r, a, theta, b) => {
  let node, v15, v17, v22, v25, v26, v35, v36, v38, v39, v46, v49, v51, v55, v61, v62, v71, v8, v9, weight;
  v49 = Math.tan(theta);
  v55 = (b * b);
  if ((r > a)) {
    v8 = (b / math.sqrt(((r * r) + (b * b))));
    v9 = (r - a);
    v15 = (a / math.sqrt(((((v9 > 0.0) || (v9 !== v9)) ? v9 : 0.0) * (r + a))));
    v17 = Math.asinh((v15 / v8));
    v22 = (0.0 - Math.expm1(((-2.0) * v17)));
    v25 = ((v22 > 0.0) ? v22 : Infinity);
    v39 = (v8 * v8);
    v51 = (b * v49);
    v62 = [];
    for ([node, weight] of RULE_0_of_hyperboloid((v17 / 1.0))) {
      v26 = (node * v17);
      v35 = (v15 * ((Math.exp((-v26)) * (0.0 - Math.expm1(((-2.0) * (v17 - v26))))) / v25));
      v36 = (v35 * v35);
      v38 = math.sqrt((1.0 + v36));
      v46 = ((r * v35) / v38);
      v61 = ((((v49 * Math.atan((v46 / b))) + ((v51 * v46) / ((v46 * v46) + v55))) * Math.atan(v35)) * (math.sqrt((v39 + v36)) / ((v38 * v38) * v38)));
      v62.push((weight * v61));
    }
    v62 = (math.fsum(v62) * v17);
    return (0.6366197723675814 * (r * v62));
  }
  v71 = (r * r);
  return (((v49 * a) * Math.atan((a / b))) - ((v49 * v71) / (math.sqrt((v71 + v55)) + b)));
};

const displacement = (r, a, theta, b) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement(r, a, theta, b) : 0.0) : NaN);
};

const _stiffness_of_hyperboloid = (a, E_star) => {
  return ((2 * E_star) * a);
};

const _stiffness = (a, E_star, theta = 0.7853981633974483, b = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30))) {
    return ((2.0 * E_star) * a);
  }
  return _stiffness_of_hyperboloid(a, E_star);
};

const stiffness = (a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness(a, E_star) : NaN);
};

const ARCTAN_GAP = [[0.3333333333333333, 0.8116412201960678, 0.7123414383945195, 0.2725778671008127, 0.04325113828415611, 0.0021043873129700233, 2.229767813968649e-06], [1.0, 3.034923660588189, 3.5294070829658954, 1.9680296155712274, 0.5368820963772863, 0.06453295925870227, 0.002445452808893491]];

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

const arctan_gap = (x) => {
  let t;
  t = math.minimum(x, 1.0);
  return math.where((x < 1.0), ((t * (t * t)) * rational((t * t), ...ARCTAN_GAP)), (x - Math.atan(x)));
};

const _force_of_hyperboloid = (a, theta, b, E_star) => {
  let angle;
  angle = Math.atan2(a, b);
  return ((E_star * Math.tan(theta)) * ((Math.pow(a, 2) * angle) + (Math.pow(b, 2) * arctan_gap((a / b)))));
};

const _mean_pressure_of_hyperboloid = (a, theta, b, E_star) => {
  return math.where((a > 0.0), (_force_of_hyperboloid(a, theta, b, E_star) / (Math.PI * Math.pow(a, 2))), 0.0);
};

const _mean_pressure = (a, theta, b, E_star) => {
  let v10, v13, v17, v60;
  if (((a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((a > 0.0)) {
      v10 = (a * a);
      v13 = (a / b);
      if ((v13 < 1.0)) {
        v17 = (v13 * v13);
        v60 = ((v13 * v17) * (((((((((((((2.229767813968649e-06 * v17) + 0.0021043873129700233) * v17) + 0.04325113828415611) * v17) + 0.2725778671008127) * v17) + 0.7123414383945195) * v17) + 0.8116412201960678) * v17) + 0.3333333333333333) / ((((((((((((0.002445452808893491 * v17) + 0.06453295925870227) * v17) + 0.5368820963772863) * v17) + 1.9680296155712274) * v17) + 3.5294070829658954) * v17) + 3.034923660588189) * v17) + 1.0)));
      } else {
        v60 = (v13 - Math.atan(v13));
      }
      return (((E_star * Math.tan(theta)) * ((v10 * Math.atan2(a, b)) + ((b * b) * v60))) / (3.141592653589793 * v10));
    }
    return 0.0;
  }
  return _mean_pressure_of_hyperboloid(a, theta, b, E_star);
};

const mean_pressure = (a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure(a, theta, b, E_star) : NaN);
};

const _depth_of_hyperboloid = (a, theta, b) => {
  let angle;
  angle = Math.atan((a / b));
  return ((Math.tan(theta) * a) * angle);
};

const falling_of_rules = (stop, even = 0.0) => {
  let below, fallen, side;
  side = (1.0 - (2.0 * even));
  below = ((2.0 * even) - (side * Math.expm1(((-2.0) * stop))));
  below = ((below > 0.0) ? below : Infinity);
  fallen = (v) => {
    return ((Math.exp((-v)) * ((2.0 * even) - (side * Math.expm1(((-2.0) * (stop - v)))))) / below);
  };
  return fallen;
};

const energy_integral = math.in_groups((depth, a, d, length) => {
  let fallen, integrand, stop;
  stop = Math.asinh((a / length));
  fallen = falling_of_rules(stop);
  integrand = (v) => {
    let short, t;
    t = (a * fallen(v));
    short = (d - depth(t));
    return ((short * short) * Math.sqrt(((length * length) + (t * t))));
  };
  return [integrand, stop, 1.0, true, 0.0];
});

const _energy_of_hyperboloid = (a, theta, b, E_star) => {
  let sunk, tip;
  sunk = _depth_of_hyperboloid(a, theta, b);
  tip = energy_integral(_depth_of_hyperboloid, [theta, b], a, sunk, b);
  return (E_star * tip);
};

const _energy = (a, theta, b, E_star) => {
  let node, v15, v18, v19, v28, v33, v35, v39, v4, v40, v6, v8, v9, weight;
  if (((a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v4 = (a / b);
    v6 = Math.tan(theta);
    v8 = ((v6 * a) * Math.atan(v4));
    v9 = Math.asinh(v4);
    v15 = (0.0 - Math.expm1(((-2.0) * v9)));
    v18 = ((v15 > 0.0) ? v15 : Infinity);
    v35 = (b * b);
    v40 = [];
    for ([node, weight] of RULE_0((v9 / 1.0))) {
      v19 = (node * v9);
      v28 = (a * ((Math.exp((-v19)) * (0.0 - Math.expm1(((-2.0) * (v9 - v19))))) / v18));
      v33 = (v8 - ((v6 * v28) * Math.atan((v28 / b))));
      v39 = ((v33 * v33) * Math.sqrt((v35 + (v28 * v28))));
      v40.push((weight * v39));
    }
    v40 = (math.fsum(v40) * v9);
    return (E_star * v40);
  }
  return _energy_of_hyperboloid(a, theta, b, E_star);
};

const energy = (a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _energy(a, theta, b, E_star) : NaN);
};

const load_within_integral = math.in_groups((slope, r, a) => {
  let fallen, integrand, reach, stop;
  reach = difference_root(a, r);
  stop = Math.asinh((reach / r));
  fallen = falling_of_rules(stop);
  integrand = (v) => {
    let t, u;
    u = (reach * fallen(v));
    t = Math.sqrt(((r * r) + (u * u)));
    return (slope(t) * (u / (t + u)));
  };
  return [integrand, stop, (r * r), (r > 0.0), 0.0];
});

const _load_within_of_hyperboloid = (r, a, theta, b, E_star) => {
  let tip;
  tip = load_within_integral(_slope, [theta, b], math.minimum(r, a), a);
  return (_force_of_hyperboloid(math.minimum(r, a), theta, b, E_star) + ((2 * E_star) * tip));
};

const _load_within = (r, a, theta, b, E_star) => {
  let node, v105, v11, v13, v18, v21, v22, v24, v33, v36, v39, v41, v45, v5, v51, v52, v54, v59, v6, v62, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v5 = (((r < a) || (r !== r)) ? r : a);
    v39 = Math.tan(theta);
    v45 = (b * b);
    if ((v5 > 0.0)) {
      v6 = (a - v5);
      v11 = Math.sqrt(((((v6 > 0.0) || (v6 !== v6)) ? v6 : 0.0) * (a + v5)));
      v13 = Math.asinh((v11 / v5));
      v18 = (0.0 - Math.expm1(((-2.0) * v13)));
      v21 = ((v18 > 0.0) ? v18 : Infinity);
      v22 = (v5 * v5);
      v41 = (b * v39);
      v52 = [];
      for ([node, weight] of RULE_0((v13 / 1.0))) {
        v24 = (node * v13);
        v33 = (v11 * ((Math.exp((-v24)) * (0.0 - Math.expm1(((-2.0) * (v13 - v24))))) / v21));
        v36 = Math.sqrt((v22 + (v33 * v33)));
        v51 = (((v39 * Math.atan((v36 / b))) + ((v41 * v36) / ((v36 * v36) + v45))) * (v33 / (v36 + v33)));
        v52.push((weight * v51));
      }
      v52 = (math.fsum(v52) * v13);
      v54 = (v22 * v52);
    } else {
      v54 = 0.0;
    }
    v59 = (v5 / b);
    if ((v59 < 1.0)) {
      v62 = (v59 * v59);
      v105 = ((v59 * v62) * (((((((((((((2.229767813968649e-06 * v62) + 0.0021043873129700233) * v62) + 0.04325113828415611) * v62) + 0.2725778671008127) * v62) + 0.7123414383945195) * v62) + 0.8116412201960678) * v62) + 0.3333333333333333) / ((((((((((((0.002445452808893491 * v62) + 0.06453295925870227) * v62) + 0.5368820963772863) * v62) + 1.9680296155712274) * v62) + 3.5294070829658954) * v62) + 3.034923660588189) * v62) + 1.0)));
    } else {
      v105 = (v59 - Math.atan(v59));
    }
    return (((E_star * v39) * (((v5 * v5) * Math.atan2(v5, b)) + (v45 * v105))) + ((2.0 * E_star) * v54));
  }
  return _load_within_of_hyperboloid(r, a, theta, b, E_star);
};

const load_within = (r, a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _load_within(r, a, theta, b, E_star) : 0.0) : NaN);
};

const _peak_pressure_of_hyperboloid = (a, theta, b, E_star) => {
  return _pressure_of_hyperboloid(math.zeros_like(a), a, theta, b, E_star);
};

const _peak_pressure = (a, theta, b, E_star) => {
  let node, v12, v14, v19, v22, v23, v32, v33, v35, v38, v40, v44, v49, v52, v53, v7, v8, weight;
  if (((a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((0.0 < a)) {
      v7 = Math.sqrt((0.0 + (b * b)));
      v8 = (a - 0.0);
      v12 = Math.sqrt(((((v8 > 0.0) || (v8 !== v8)) ? v8 : 0.0) * (a + 0.0)));
      v14 = Math.asinh((v12 / v7));
      v19 = (0.0 - Math.expm1(((-2.0) * v14)));
      v22 = ((v19 > 0.0) ? v19 : Infinity);
      v38 = Math.tan(theta);
      v40 = (b * v38);
      v44 = (b * b);
      v49 = (v7 * v7);
      v53 = [];
      for ([node, weight] of RULE_0((v14 / 1.0))) {
        v23 = (node * v14);
        v32 = (v12 * ((Math.exp((-v23)) * (0.0 - Math.expm1(((-2.0) * (v14 - v23))))) / v22));
        v33 = (v32 * v32);
        v35 = Math.sqrt((0.0 + v33));
        v52 = ((((v38 * Math.atan((v35 / b))) + ((v40 * v35) / ((v35 * v35) + v44))) / v35) * Math.sqrt((v49 + v33)));
        v53.push((weight * v52));
      }
      v53 = (math.fsum(v53) * v14);
      return ((E_star / 3.141592653589793) * v53);
    }
    return 0.0;
  }
  return _peak_pressure_of_hyperboloid(a, theta, b, E_star);
};

const _peak_radius_of_hyperboloid = (a) => {
  return math.zeros_like(a);
};

const _peak_radius = (a, theta = 0.7853981633974483, b = 1.0, E_star = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    return 0.0;
  }
  return _peak_radius_of_hyperboloid(a);
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

const _slope_of_hyperboloid = (t, theta, b) => {
  let v5;
  v5 = Math.tan(theta);
  return ((v5 * Math.atan((t / b))) + (((b * v5) * t) / ((t * t) + (b * b))));
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

const _radius_from_depth = (d, theta, b) => {
  let curve;
  curve = (a) => {
    let value;
    value = _depth(a, theta, b);
    return [value, ((a * _slope_of_hyperboloid(a, theta, b)) / value)];
  };
  return inverse(curve, d, ((b / 1000) * math.ones_like(d)), [1.0, 2.0], undefined, undefined, true);
};

const radius_from_depth = (d, theta, b) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth(d, theta, b) : NaN);
};

const _radius_from_force = (F, theta, b, E_star) => {
  let curve;
  curve = (a) => {
    let value;
    value = _force(a, theta, b, E_star);
    return [value, ((((2 * E_star) * Math.pow(a, 2)) * _slope_of_hyperboloid(a, theta, b)) / value)];
  };
  return inverse(curve, F, ((b / 1000) * math.ones_like(F)), [2.0, 3.0], undefined, undefined, true);
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
  return (((Math.tan(theta) * a) * Math.atan((a / b))) - (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const depth_of_hyperboloid = (a, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_2(a, theta, b, E_star, dgamma) : NaN);
};

const _force_2 = (a, theta, b, E_star, dgamma) => {
  let v12, v16, v59;
  v12 = (a / b);
  if ((v12 < 1.0)) {
    v16 = (v12 * v12);
    v59 = ((v12 * v16) * (((((((((((((2.229767813968649e-06 * v16) + 0.0021043873129700233) * v16) + 0.04325113828415611) * v16) + 0.2725778671008127) * v16) + 0.7123414383945195) * v16) + 0.8116412201960678) * v16) + 0.3333333333333333) / ((((((((((((0.002445452808893491 * v16) + 0.06453295925870227) * v16) + 0.5368820963772863) * v16) + 1.9680296155712274) * v16) + 3.5294070829658954) * v16) + 3.034923660588189) * v16) + 1.0)));
  } else {
    v59 = (v12 - Math.atan(v12));
  }
  return (((E_star * Math.tan(theta)) * (((a * a) * Math.atan2(a, b)) + ((b * b) * v59))) - (((2.0 * E_star) * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star)))));
};

const force_of_hyperboloid = (a, theta, b, E_star, dgamma) => {
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
  return (_pressure_of_hyperboloid(r, a, theta, b, E_star) - tension(r, a, E_star, dgamma));
};

const _pressure_2 = (r, a, theta, b, E_star, dgamma) => {
  let node, v10, v15, v17, v22, v25, v26, v35, v36, v38, v41, v43, v47, v52, v55, v56, v6, v62, v68, v75, v9, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v10 = (a - r);
    v15 = Math.sqrt(((((v10 > 0.0) || (v10 !== v10)) ? v10 : 0.0) * (a + r)));
    if ((r < a)) {
      v6 = (r * r);
      v9 = Math.sqrt((v6 + (b * b)));
      v17 = Math.asinh((v15 / v9));
      v22 = (0.0 - Math.expm1(((-2.0) * v17)));
      v25 = ((v22 > 0.0) ? v22 : Infinity);
      v41 = Math.tan(theta);
      v43 = (b * v41);
      v47 = (b * b);
      v52 = (v9 * v9);
      v56 = [];
      for ([node, weight] of RULE_0_2((v17 / 1.0))) {
        v26 = (node * v17);
        v35 = (v15 * ((Math.exp((-v26)) * (0.0 - Math.expm1(((-2.0) * (v17 - v26))))) / v25));
        v36 = (v35 * v35);
        v38 = Math.sqrt((v6 + v36));
        v55 = ((((v41 * Math.atan((v38 / b))) + ((v43 * v38) / ((v38 * v38) + v47))) / v38) * Math.sqrt((v52 + v36)));
        v56.push((weight * v55));
      }
      v56 = (math.fsum(v56) * v17);
      v62 = ((E_star / 3.141592653589793) * v56);
    } else {
      v62 = 0.0;
    }
    if ((r <= a)) {
      v68 = (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star)));
      v75 = ((v68 > 0.0) ? ((E_star * v68) / (3.141592653589793 * v15)) : 0.0);
    } else {
      v75 = 0.0;
    }
    return (v62 - v75);
  }
  return _pressure_3(r, a, theta, b, E_star, dgamma);
};

const pressure_of_hyperboloid = (r, a, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_2(r, a, theta, b, E_star, dgamma) : 0.0) : NaN);
};

const displacement_integral_sinh = math.in_groups((slope, r, a, b) => {
  let end, fallen, integrand, scale, stop;
  [scale, end] = [(b / Math.sqrt(((r * r) + (b * b)))), (a / difference_root(r, a))];
  stop = Math.asinh((end / scale));
  fallen = falling(stop);
  integrand = (v) => {
    let secant, tangent, weight;
    tangent = (end * fallen(v));
    secant = Math.sqrt((1.0 + (tangent * tangent)));
    weight = (Math.sqrt(((scale * scale) + (tangent * tangent))) / ((secant * secant) * secant));
    return ((slope(((r * tangent) / secant)) * Math.atan(tangent)) * weight);
  };
  return [integrand, stop, r, true, 0.0];
});

const _profile = (r, theta, b) => {
  let root;
  root = Math.sqrt((Math.pow(r, 2) + Math.pow(b, 2)));
  return ((Math.tan(theta) * Math.pow(r, 2)) / (root + b));
};

const _displacement_3 = (r, a, theta, b) => {
  let inside, outside, tip;
  tip = displacement_integral_sinh(_slope, [theta, b], r, a, b);
  outside = ((2 / Math.PI) * tip);
  inside = (_depth_of_hyperboloid(a, theta, b) - _profile(r, theta, b));
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

const _displacement_of_hyperboloid = (r, a, theta, b, E_star, dgamma) => {
  let node, v10, v11, v16, v17, v19, v24, v27, v28, v37, v38, v40, v41, v48, v51, v53, v57, v63, v64, v73, v80, v81, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v11 = (r - a);
    v16 = Math.sqrt(((((v11 > 0.0) || (v11 !== v11)) ? v11 : 0.0) * (r + a)));
    v51 = Math.tan(theta);
    v57 = (b * b);
    v80 = (r > a);
    if (v80) {
      v10 = (b / Math.sqrt(((r * r) + (b * b))));
      v17 = (a / v16);
      v19 = Math.asinh((v17 / v10));
      v24 = (0.0 - Math.expm1(((-2.0) * v19)));
      v27 = ((v24 > 0.0) ? v24 : Infinity);
      v41 = (v10 * v10);
      v53 = (b * v51);
      v64 = [];
      for ([node, weight] of RULE_0_2((v19 / 1.0))) {
        v28 = (node * v19);
        v37 = (v17 * ((Math.exp((-v28)) * (0.0 - Math.expm1(((-2.0) * (v19 - v28))))) / v27));
        v38 = (v37 * v37);
        v40 = Math.sqrt((1.0 + v38));
        v48 = ((r * v37) / v40);
        v63 = ((((v51 * Math.atan((v48 / b))) + ((v53 * v48) / ((v48 * v48) + v57))) * Math.atan(v37)) * (Math.sqrt((v41 + v38)) / ((v40 * v40) * v40)));
        v64.push((weight * v63));
      }
      v64 = (math.fsum(v64) * v19);
      v81 = (0.6366197723675814 * (r * v64));
    } else {
      v73 = (r * r);
      v81 = (((v51 * a) * Math.atan((a / b))) - ((v51 * v73) / (Math.sqrt((v73 + v57)) + b)));
    }
    return (v81 - ((Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))) * (math.truth(v80) ? (0.6366197723675814 * Math.atan2(a, v16)) : 1.0)));
  }
  return _displacement_2(r, a, theta, b, E_star, dgamma);
};

const displacement_of_hyperboloid = (r, a, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_of_hyperboloid(r, a, theta, b, E_star, dgamma) : 0.0) : NaN);
};

const exponent_of = (x) => {
  return (math.frexp(x)[1] - 1);
};

const _rate = (a, theta, b) => {
  let v5;
  v5 = Math.tan(theta);
  return ((v5 * Math.atan((a / b))) + (((b * v5) * a) / ((a * a) + (b * b))));
};

const decades = (length = 1.0) => [1e-150, 1e-140, 1e-130, 1e-120, 1e-110, 1e-100, 1e-90, 1e-80, 1e-70, 1e-60, 1e-50, 1e-40, 1e-30, 1e-20, 1e-10, 1.0, 10000000000.0, 1e+20, 1e+30, 1e+40, 1e+50, 1e+60, 1e+70, 1e+80, 1e+90, 1e+100, 1e+110, 1e+120, 1e+130, 1e+140, 1e+150].map((x) => x * length);

const _samples = (theta, b) => {
  let a;
  a = decades();
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

const _radius_from_depth_of_hyperboloid = (d, theta, b, E_star, dgamma) => {
  let found, radius, stress, unit;
  unit = exponent_of(b);
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  d = math.ldexp(d, (-unit));
  found = _branches(theta, b, E_star, dgamma, 'depth');
  radius = stable_radius(d, found, ((a) => _depth_2(a, theta, b, E_star, dgamma)), ((a) => growth(_rate(a, theta, b), a, 'depth', E_star, dgamma)), ((a) => hess_retraction(a, E_star, dgamma)), radius_itself());
  return math.ldexp(radius, unit);
};

const radius_from_depth_of_hyperboloid = (d, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_depth_of_hyperboloid(d, theta, b, E_star, dgamma);
};

const pull = (a, E_star, dgamma) => {
  return (((2.0 * E_star) * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const _radius_from_force_of_hyperboloid = (F, theta, b, E_star, dgamma) => {
  let found, radius, stress, unit;
  unit = exponent_of(b);
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  F = math.ldexp(F, (-(stress + (2 * unit))));
  found = _branches(theta, b, E_star, dgamma, 'force');
  radius = stable_radius(F, found, ((a) => _force_2(a, theta, b, E_star, dgamma)), ((a) => growth(_rate(a, theta, b), a, 'force', E_star, dgamma)), ((a) => pull(a, E_star, dgamma)), radius_itself());
  return math.ldexp(radius, unit);
};

const radius_from_force_of_hyperboloid = (F, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_force_of_hyperboloid(F, theta, b, E_star, dgamma);
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

const _tangential_force_of_hyperboloid = (a, c, theta, b, E_star, mu) => {
  let close, gain, sticking, whole;
  [whole, sticking] = [_force_of_hyperboloid(a, theta, b, E_star), _force_of_hyperboloid(c, theta, b, E_star)];
  close = (sticking >= (CLOSE * whole));
  gain = ((2.0 * E_star) * growth_of_slip(_slope, [theta, b], 2, 0.0, c, a, close));
  return (mu * math.where(close, gain, (whole - sticking)));
};

const _tangential_force = (a, c, theta, b, E_star, mu) => {
  let node, v100, v103, v106, v109, v113, v114, v115, v12, v120, v125, v13, v130, v131, v132, v137, v141, v143, v147, v148, v149, v152, v17, v60, v63, v67, v7, v70, v8, weight;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v7 = Math.tan(theta);
    v8 = (E_star * v7);
    v12 = (b * b);
    v13 = (a / b);
    if ((v13 < 1.0)) {
      v17 = (v13 * v13);
      v60 = ((v13 * v17) * (((((((((((((2.229767813968649e-06 * v17) + 0.0021043873129700233) * v17) + 0.04325113828415611) * v17) + 0.2725778671008127) * v17) + 0.7123414383945195) * v17) + 0.8116412201960678) * v17) + 0.3333333333333333) / ((((((((((((0.002445452808893491 * v17) + 0.06453295925870227) * v17) + 0.5368820963772863) * v17) + 1.9680296155712274) * v17) + 3.5294070829658954) * v17) + 3.034923660588189) * v17) + 1.0)));
    } else {
      v60 = (v13 - Math.atan(v13));
    }
    v63 = (v8 * (((a * a) * Math.atan2(a, b)) + (v12 * v60)));
    v67 = (c / b);
    if ((v67 < 1.0)) {
      v70 = (v67 * v67);
      v100 = ((v67 * v70) * (((((((((((((2.229767813968649e-06 * v70) + 0.0021043873129700233) * v70) + 0.04325113828415611) * v70) + 0.2725778671008127) * v70) + 0.7123414383945195) * v70) + 0.8116412201960678) * v70) + 0.3333333333333333) / ((((((((((((0.002445452808893491 * v70) + 0.06453295925870227) * v70) + 0.5368820963772863) * v70) + 1.9680296155712274) * v70) + 3.5294070829658954) * v70) + 3.034923660588189) * v70) + 1.0)));
    } else {
      v100 = (v67 - Math.atan(v67));
    }
    v103 = (v8 * (((c * c) * Math.atan2(c, b)) + (v12 * v100)));
    v106 = (v103 >= (0.25 * v63));
    if (v106) {
      v120 = (a > c);
      v130 = (v106 && v120);
      if (v130) {
        v109 = (c - 0.0);
        v113 = Math.sqrt(((((v109 > 0.0) || (v109 !== v109)) ? v109 : 0.0) * (c + 0.0)));
        if (v130) {
          v114 = (a - c);
          if (v120) {
            v115 = (a - 0.0);
            v125 = ((v114 * (a + c)) / (Math.sqrt(((((v115 > 0.0) || (v115 !== v115)) ? v115 : 0.0) * (a + 0.0))) + v113));
          } else {
            v125 = 0.0;
          }
          v131 = Math.log1p(((v114 + v125) / (c + v113)));
        } else {
          v131 = 0.0;
        }
        v141 = (b * v7);
        v148 = [];
        for ([node, weight] of RULE_0_3((v131 / 1.0))) {
          v132 = (node * v131);
          v137 = ((c * Math.cosh(v132)) + (v113 * Math.sinh(v132)));
          v143 = (v137 * v137);
          v147 = (((v7 * Math.atan((v137 / b))) + ((v141 * v137) / (v143 + v12))) * v143);
          v148.push((weight * v147));
        }
        v148 = (math.fsum(v148) * v131);
        v149 = v148;
      } else {
        v149 = 0.0;
      }
      v152 = ((2.0 * E_star) * v149);
    } else {
      v152 = (v63 - v103);
    }
    return (mu * v152);
  }
  return _tangential_force_of_hyperboloid(a, c, theta, b, E_star, mu);
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

const _traction_of_hyperboloid = (r, a, c, theta, b, E_star, mu) => {
  let close, gain, sliding, stuck;
  sliding = _pressure_of_hyperboloid(r, a, theta, b, E_star);
  stuck = _pressure_of_hyperboloid(r, c, theta, b, E_star);
  close = ((r < c) & (stuck >= (CLOSE * sliding)));
  gain = ((E_star / Math.PI) * growth_of_slip(_slope, [theta, b], 0, r, c, a, close));
  return (mu * math.where(close, gain, (sliding - stuck)));
};

const _traction = (r, a, c, theta, b, E_star, mu) => {
  let node, v10, v100, v101, v102, v104, v108, v109, v11, v110, v120, v121, v122, v127, v137, v138, v139, v142, v16, v18, v23, v26, v27, v36, v37, v39, v42, v44, v48, v53, v56, v57, v61, v63, v64, v68, v7, v70, v73, v75, v76, v85, v86, v88, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v7 = (r * r);
    v10 = Math.sqrt((v7 + (b * b)));
    v11 = (a - r);
    v16 = Math.sqrt(((((v11 > 0.0) || (v11 !== v11)) ? v11 : 0.0) * (a + r)));
    v42 = Math.tan(theta);
    v44 = (b * v42);
    v48 = (b * b);
    v53 = (v10 * v10);
    v61 = (E_star / 3.141592653589793);
    if ((r < a)) {
      v18 = Math.asinh((v16 / v10));
      v23 = (0.0 - Math.expm1(((-2.0) * v18)));
      v26 = ((v23 > 0.0) ? v23 : Infinity);
      v57 = [];
      for ([node, weight] of RULE_0_3((v18 / 1.0))) {
        v27 = (node * v18);
        v36 = (v16 * ((Math.exp((-v27)) * (0.0 - Math.expm1(((-2.0) * (v18 - v27))))) / v26));
        v37 = (v36 * v36);
        v39 = Math.sqrt((v7 + v37));
        v56 = ((((v42 * Math.atan((v39 / b))) + ((v44 * v39) / ((v39 * v39) + v48))) / v39) * Math.sqrt((v53 + v37)));
        v57.push((weight * v56));
      }
      v57 = (math.fsum(v57) * v18);
      v63 = (v61 * v57);
    } else {
      v63 = 0.0;
    }
    v64 = (c - r);
    v68 = Math.sqrt(((((v64 > 0.0) || (v64 !== v64)) ? v64 : 0.0) * (c + r)));
    v102 = (r < c);
    if (v102) {
      v70 = Math.asinh((v68 / v10));
      v73 = (0.0 - Math.expm1(((-2.0) * v70)));
      v75 = ((v73 > 0.0) ? v73 : Infinity);
      v101 = [];
      for ([node, weight] of RULE_0_3((v70 / 1.0))) {
        v76 = (node * v70);
        v85 = (v68 * ((Math.exp((-v76)) * (0.0 - Math.expm1(((-2.0) * (v70 - v76))))) / v75));
        v86 = (v85 * v85);
        v88 = Math.sqrt((v7 + v86));
        v100 = ((((v42 * Math.atan((v88 / b))) + ((v44 * v88) / ((v88 * v88) + v48))) / v88) * Math.sqrt((v53 + v86)));
        v101.push((weight * v100));
      }
      v101 = (math.fsum(v101) * v70);
      v104 = (v61 * v101);
    } else {
      v104 = 0.0;
    }
    v108 = (v102 && (v104 >= (0.25 * v63)));
    if (v108) {
      v110 = (a > c);
      v120 = (v108 && v110);
      if (v120) {
        if (v120) {
          v109 = (a - c);
          v121 = Math.log1p(((v109 + (math.truth(v110) ? ((v109 * (a + c)) / (v16 + v68)) : 0.0)) / (c + v68)));
        } else {
          v121 = 0.0;
        }
        v138 = [];
        for ([node, weight] of RULE_0_3((v121 / 1.0))) {
          v122 = (node * v121);
          v127 = ((c * Math.cosh(v122)) + (v68 * Math.sinh(v122)));
          v137 = (((v42 * Math.atan((v127 / b))) + ((v44 * v127) / ((v127 * v127) + v48))) * Math.pow(v127, 0.0));
          v138.push((weight * v137));
        }
        v138 = (math.fsum(v138) * v121);
        v139 = v138;
      } else {
        v139 = 0.0;
      }
      v142 = (v61 * v139);
    } else {
      v142 = (v63 - v104);
    }
    return (mu * v142);
  }
  return _traction_of_hyperboloid(r, a, c, theta, b, E_star, mu);
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

const _tangential_displacement_of_hyperboloid = (a, c, theta, b, E_star, G_star, mu) => {
  let close, gain, sticking, whole;
  [whole, sticking] = [_depth_of_hyperboloid(a, theta, b), _depth_of_hyperboloid(c, theta, b)];
  close = (sticking >= (CLOSE * whole));
  gain = growth_of_slip(_slope, [theta, b], 1, 0.0, c, a, close);
  return ((mu * (E_star / G_star)) * math.where(close, gain, (whole - sticking)));
};

const _tangential_displacement = (a, c, theta, b, E_star, G_star, mu) => {
  let node, v11, v15, v18, v20, v24, v25, v26, v31, v36, v41, v42, v44, v49, v53, v57, v62, v63, v64, v68, v9, weight;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v9 = Math.tan(theta);
    v11 = ((v9 * a) * Math.atan((a / b)));
    v15 = ((v9 * c) * Math.atan((c / b)));
    v18 = (v15 >= (0.25 * v11));
    if (v18) {
      v31 = (a > c);
      v41 = (v18 && v31);
      if (v41) {
        v20 = (c - 0.0);
        v24 = Math.sqrt(((((v20 > 0.0) || (v20 !== v20)) ? v20 : 0.0) * (c + 0.0)));
        if (v41) {
          v25 = (a - c);
          if (v31) {
            v26 = (a - 0.0);
            v36 = ((v25 * (a + c)) / (Math.sqrt(((((v26 > 0.0) || (v26 !== v26)) ? v26 : 0.0) * (a + 0.0))) + v24));
          } else {
            v36 = 0.0;
          }
          v42 = Math.log1p(((v25 + v36) / (c + v24)));
        } else {
          v42 = 0.0;
        }
        v53 = (b * v9);
        v57 = (b * b);
        v63 = [];
        for ([node, weight] of RULE_0_3((v42 / 1.0))) {
          v44 = (node * v42);
          v49 = ((c * Math.cosh(v44)) + (v24 * Math.sinh(v44)));
          v62 = (((v9 * Math.atan((v49 / b))) + ((v53 * v49) / ((v49 * v49) + v57))) * Math.pow(v49, 1.0));
          v63.push((weight * v62));
        }
        v63 = (math.fsum(v63) * v42);
        v64 = v63;
      } else {
        v64 = 0.0;
      }
      v68 = v64;
    } else {
      v68 = (v11 - v15);
    }
    return ((mu * (E_star / G_star)) * v68);
  }
  return _tangential_displacement_of_hyperboloid(a, c, theta, b, E_star, G_star, mu);
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

const _full_slip_displacement_of_hyperboloid = (a, theta, b, E_star, G_star, mu) => {
  return ((mu * (E_star / G_star)) * _depth_of_hyperboloid(a, theta, b));
};

const _full_slip_displacement = (a, theta, b, E_star, G_star, mu) => {
  if (((a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    return ((mu * (E_star / G_star)) * ((Math.tan(theta) * a) * Math.atan((a / b))));
  }
  return _full_slip_displacement_of_hyperboloid(a, theta, b, E_star, G_star, mu);
};

const full_slip_displacement = (a, theta, b, E_star, G_star, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement(a, theta, b, E_star, G_star, mu) : NaN);
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

const hyperboloid_depth = (a, b, k) => {
  let angle;
  angle = Math.atan2(a, b);
  return ((a > 0.0) ? (((a * angle) * Math.pow(((math.hypot(a, b) / a) * angle), k)) * sine_mean(angle, k)) : 0.0);
};

const _depth_3 = (a, theta, b, k) => {
  return (hyperboloid_depth(a, b, k) * Math.tan(theta));
};

const depth_2 = (a, theta, b, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_3(a, theta, b, k) : NaN);
};

const hyperboloid_force = (a, b, k) => {
  let angle, c, integrand;
  angle = Math.atan2(a, b);
  integrand = (y) => {
    return ((Math.pow(sine_over(y), k) * Math.sin((angle - y))) * Math.sin((angle + y)));
  };
  c = math.hypot(a, b);
  return ((a > 0.0) ? ((((c * c) * angle) * Math.pow((c * angle), k)) * weighted(integrand, angle, k)) : 0.0);
};

const _force_3 = (a, theta, b, H, k) => {
  let growth;
  growth = (hyperboloid_force(a, b, k) * Math.tan(theta));
  return (((2.0 * H) / (1.0 + k)) * growth);
};

const force_2 = (a, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_3(a, theta, b, H, k) : NaN);
};

const hyperboloid_rate = (t, b, k) => {
  let angle, c;
  [c, angle] = [math.hypot(t, b), Math.atan2(t, b)];
  return ((((angle * Math.pow(((c / t) * angle), k)) * sine_mean(angle, k)) * (1.0 - (k * Math.pow((b / c), 2)))) + ((t / c) * (b / c)));
};

const _AXIS = Math.pow(2.0, (-60));

const _off_axis = (r, a) => {
  return math.maximum(r, (_AXIS * a));
};

const _PANEL = 3.0;

const _panel = (scale, reach, longest) => {
  let first, whole;
  whole = Math.asinh((reach / scale));
  first = math.minimum(whole, longest);
  return [first, math.where((first < whole), (scale * Math.sinh(first)), reach)];
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

const raised = (x, k) => {
  if ((x > 0.0)) {
    return (x * Math.pow(x, k));
  }
  return 0.0;
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

const sinh_growth = (slope, r, a, b, k) => {
  let smooth;
  r = _off_axis(r, a);
  smooth = (near, far) => {
    let t;
    t = math.hypot(r, near);
    return ((slope(t) / t) * far);
  };
  return _from_branch(smooth, math.hypot(r, b), difference_root(a, r), k);
};

const hyperboloid_pressure = (r, a, b, k) => {
  return sinh_growth(((t) => hyperboloid_rate(t, b, k)), r, a, b, k);
};

const _pressure_4 = (r, a, theta, b, H, k) => {
  let growth, inside;
  inside = math.minimum(r, a);
  growth = (hyperboloid_pressure(inside, a, b, k) * Math.tan(theta));
  return math.where((r < a), ((H / Math.PI) * growth), 0.0);
};

const pressure_2 = (r, a, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_4(r, a, theta, b, H, k) : 0.0) : NaN);
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

const kernel = (sine, cosine, ratio, k) => {
  let v9;
  v9 = (ratio * sine);
  return (((ratio * Math.pow(ratio, k)) * (Math.pow(sine, k) * cosine)) / (1.0 + (v9 * v9)));
};

const SPLIT = 0.5235987755982988;

const _joined = (gap, a, value, fall) => {
  return ((a > 0.0) ? (gap.outside ? value : (value + fall)) : 0.0);
};

const hyperboloid_displacement = (r, a, b, k) => {
  let far, gap, near, ratio, root, shape, smooth;
  gap = _gap_of_displacement(r, a, k);
  shape = _weighed(gap, ((s, z) => (a * (a / (math.hypot(a, b) + math.hypot(s, b))))), a);
  near = from_edge(shape, a, gap.q, gap.q, Math.asinh(((a / gap.q) / 2.0)), k);
  ratio = (b / a);
  smooth = (x) => {
    let value, y;
    y = (ratio * Math.sinh(x));
    value = (shape((a * Math.sin(y)), (a * Math.cos(y))) * kernel(Math.cos(y), Math.sin(y), (a / gap.q), k));
    return ((value * ratio) * Math.cosh(x));
  };
  far = math.integral(smooth, (Math.asinh((((Math.PI / 2.0) - SPLIT) / ratio)) + math.zeros_like(gap.q)), NODES_of_displacement);
  root = difference_root(a, r);
  return _joined(gap, a, (near + far), (root * (root / (math.hypot(a, b) + math.hypot(r, b)))));
};

const _displacement_4 = (r, a, theta, b, k) => {
  return (hyperboloid_displacement(r, a, b, k) * Math.tan(theta));
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

const stiffness_of_hyperboloid = (a, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness_2(a, H, k) : NaN);
};

const _mean_pressure_2 = (a, theta, b, H, k) => {
  return ((a > 0.0) ? (_force_3(a, theta, b, H, k) / ((Math.PI * a) * a)) : 0.0);
};

const mean_pressure_of_hyperboloid = (a, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure_2(a, theta, b, H, k) : NaN);
};

const _rate_of_hyperboloid = (a, theta, b, k) => {
  return (hyperboloid_rate(a, b, k) * Math.tan(theta));
};

const _curve = (load, rate, needs) => {
  let curve;
  curve = (a) => {
    let own;
    own = load(a, ...needs);
    return [own, ((a * rate(a, ...needs)) / own)];
  };
  return curve;
};

const SLACK_of_inverse = 1e-06;

const radius_to = (load, rate, value, start, needs) => {
  value = (value + math.zeros(1));
  start = (start + math.zeros_like(value));
  return inverse(_curve(load, rate, needs), value, start, [SLACK_of_inverse, Infinity], undefined, undefined, true);
};

const _radius_from_depth_2 = (d, theta, b, k) => {
  return radius_to(_depth_3, _rate_of_hyperboloid, d, (1.5 * b), [theta, b, k]);
};

const radius_from_depth_2 = (d, theta, b, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth_2(d, theta, b, k) : NaN);
};

const _force_rate = (a, theta, b, H, k) => {
  return (punch_stiffness(a, H, k) * _rate_of_hyperboloid(a, theta, b, k));
};

const _radius_from_force_2 = (F, theta, b, H, k) => {
  return radius_to(_force_3, _force_rate, F, (1.5 * b), [theta, b, H, k]);
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

const _force_from_depth_of_hyperboloid = (d, theta, b, H, k) => {
  let a;
  a = _radius_from_depth_2(d, theta, b, k);
  return (_force_3(a, theta, b, H, k) + punch_force((d - _depth_3(a, theta, b, k)), a, H, k));
};

const force_from_depth_of_hyperboloid = (d, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth_of_hyperboloid(d, theta, b, H, k) : NaN);
};

const punch_depth = (F, a, H, k) => {
  let v14;
  v14 = (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  if (((v14 > 0.0) && (v14 < Infinity))) {
    return (F / v14);
  }
  return 0.0;
};

const _depth_from_force_of_hyperboloid = (F, theta, b, H, k) => {
  let a;
  a = _radius_from_force_2(F, theta, b, H, k);
  return (_depth_3(a, theta, b, k) + punch_depth((F - _force_3(a, theta, b, H, k)), a, H, k));
};

const depth_from_force_of_hyperboloid = (F, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force_of_hyperboloid(F, theta, b, H, k) : NaN);
};

const graded_retraction = (a, H, k, dgamma) => {
  if ((a > 0.0)) {
    return ((math.sqrt(((6.283185307179586 * dgamma) / H)) * math.sqrt(a)) * math.sqrt(Math.pow(a, (-k))));
  }
  return 0.0;
};

const retraction_of_hyperboloid = (a, H, k, dgamma) => {
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

const _samples_of_hyperboloid = (theta, b, k) => {
  let a;
  a = decades();
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

const _branches_of_hyperboloid = (theta, b, H, k, dgamma, control) => {
  return branches(((a) => (Math.pow(a, ((1.0 + k) / 2.0)) * _rate_of_hyperboloid(a, theta, b, k))), _samples_of_hyperboloid(theta, b, k), least_steepness_of_punch(control, H, k, dgamma));
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
  found = _branches_of_hyperboloid(theta, b, H, k, dgamma, 'depth');
  slope = growth_of(_rate_of_hyperboloid, [theta, b, k], H, k, dgamma, 'depth');
  pulled = pull_of(H, k, dgamma, 'depth');
  radius = stable_radius(d, found, ((a) => _depth_4(a, theta, b, H, k, dgamma)), slope, pulled, radius_itself());
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
  found = _branches_of_hyperboloid(theta, b, H, k, dgamma, 'force');
  slope = growth_of(_rate_of_hyperboloid, [theta, b, k], H, k, dgamma, 'force');
  pulled = pull_of(H, k, dgamma, 'force');
  radius = stable_radius(F, found, ((a) => _force_4(a, theta, b, H, k, dgamma)), slope, pulled, radius_itself());
  return math.ldexp(radius, unit);
};

const radius_from_force_3 = (F, theta, b, H, k, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_force_3(F, theta, b, H, k, dgamma);
};

const _pull_off_radius_of_hyperboloid = (theta, b, H, k, dgamma, control) => {
  let found, load, radius, stress, unit;
  unit = exponent_of(b);
  [stress, H] = stress_at(unit, H, k);
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  found = _branches_of_hyperboloid(theta, b, H, k, dgamma, control);
  load = ((control === 'force') ? _force_4 : _depth_4);
  radius = math.lowest(found, ((a) => load(a, theta, b, H, k, dgamma)));
  return math.ldexp(radius, unit);
};

const pull_off_of_hyperboloid = (control = 'force', theta, b, H, k, dgamma) => {
  let depth, force, radius;
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  radius = _pull_off_radius_of_hyperboloid(theta, b, H, k, dgamma, control);
  force = ((radius >= 0.0) ? _force_4(radius, theta, b, H, k, dgamma) : NaN);
  depth = ((radius >= 0.0) ? _depth_4(radius, theta, b, H, k, dgamma) : NaN);
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

const either = (condition, x, y) => {
  if (Boolean(condition)) {
    return x();
  }
  return (Boolean(condition) ? (math.truth(condition) ? x() : y()) : y());
};

const smooth_gain = (quantity, whole, rate, lengths, r, c, a, k) => {
  let close, fields;
  close = _close(r, c, a);
  fields = ((quantity === 'pressure') ? [r] : []);
  return either(close, (() => _grown(quantity, ((t, _) => rate(t, ...lengths, k)), r, c, a, 0.0, k, close)), (() => (whole(...fields, a, ...lengths, k) - whole(...fields, c, ...lengths, k))));
};

const _tangential_force_2 = (a, c, theta, b, H, k, mu) => {
  let gain;
  gain = (smooth_gain('force', hyperboloid_force, hyperboloid_rate, [b], 0.0, c, a, k) * Math.tan(theta));
  return ((mu * ((2.0 * H) / (1.0 + k))) * gain);
};

const tangential_force_of_hyperboloid = (a, c, theta, b, H, k, mu) => {
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
    return (smooth_gain('pressure', hyperboloid_pressure, hyperboloid_rate, [b], inside, c, a, k) * Math.tan(theta));
  };
  return (mu * either((r < c), (() => ((H / Math.PI) * gain())), (() => _pressure_4(r, a, theta, b, H, k))));
};

const traction_of_hyperboloid = (r, a, c, theta, b, H, k, mu) => {
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
  gain = (smooth_gain('depth', hyperboloid_depth, hyperboloid_rate, [b], 0.0, c, a, k) * Math.tan(theta));
  return ((mu * (H / H_x)) * gain);
};

const tangential_displacement_of_hyperboloid = (a, c, theta, b, H, H_x, k, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement_2(a, c, theta, b, H, H_x, k, mu) : NaN);
};

const _stick_radius_of_hyperboloid = (F_x, a, theta, b, H, k, mu) => {
  let F;
  F = stick_force(_force_3(a, theta, b, H, k), F_x, mu);
  return (((F_x === 0.0) & (a >= 0.0)) ? a : _radius_from_force_2(F, theta, b, H, k));
};

const stick_radius_of_hyperboloid = (F_x, a, theta, b, H, k, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius_of_hyperboloid(F_x, a, theta, b, H, k, mu) : NaN);
};

const _full_slip_displacement_2 = (a, theta, b, H, H_x, k, mu) => {
  return ((mu * (H / H_x)) * _depth_3(a, theta, b, k));
};

const full_slip_displacement_of_hyperboloid = (a, theta, b, H, H_x, k, mu) => {
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

const once = { peak_pressure: math.kept(peak_pressure), pull_off: math.kept(pull_off), pull_off_of_hyperboloid: math.kept(pull_off_of_hyperboloid) };
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
  "adh.d": (v) => depth_of_hyperboloid(v.a, v.theta, v.b, v.E_star, v.dgamma),
  "adh.F": (v) => force_of_hyperboloid(v.a, v.theta, v.b, v.E_star, v.dgamma),
  "adh.p": (v) => pressure_of_hyperboloid(v.r, v.a, v.theta, v.b, v.E_star, v.dgamma),
  "adh.w": (v) => displacement_of_hyperboloid(v.r, v.a, v.theta, v.b, v.E_star, v.dgamma),
  "adh.ad": (v) => radius_from_depth_of_hyperboloid(v.d, v.theta, v.b, v.E_star, v.dgamma),
  "adh.aF": (v) => radius_from_force_of_hyperboloid(v.F, v.theta, v.b, v.E_star, v.dgamma),
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
  "fgm.k": (v) => stiffness_of_hyperboloid(v.a, v.theta, v.b, v.H, v.k),
  "fgm.pm": (v) => mean_pressure_of_hyperboloid(v.a, v.theta, v.b, v.H, v.k),
  "fgm.ad": (v) => radius_from_depth_2(v.d, v.theta, v.b, v.k),
  "fgm.aF": (v) => radius_from_force_2(v.F, v.theta, v.b, v.H, v.k),
  "fgm.Fd": (v) => force_from_depth_of_hyperboloid(v.d, v.theta, v.b, v.H, v.k),
  "fgm.dF": (v) => depth_from_force_of_hyperboloid(v.F, v.theta, v.b, v.H, v.k),
  "fgm.adh.Dl": (v) => retraction_of_hyperboloid(v.a, v.H, v.k, v.dgamma),
  "fgm.adh.d": (v) => depth_3(v.a, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.F": (v) => force_3(v.a, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.p": (v) => pressure_3(v.r, v.a, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.w": (v) => displacement_3(v.r, v.a, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.ad": (v) => radius_from_depth_3(v.d, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.aF": (v) => radius_from_force_3(v.F, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.ac": (v) => (once.pull_off_of_hyperboloid('force', v.theta, v.b, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fc": (v) => (once.pull_off_of_hyperboloid('force', v.theta, v.b, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dc": (v) => (once.pull_off_of_hyperboloid('force', v.theta, v.b, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.adh.am": (v) => (once.pull_off_of_hyperboloid('depth', v.theta, v.b, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fm": (v) => (once.pull_off_of_hyperboloid('depth', v.theta, v.b, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dm": (v) => (once.pull_off_of_hyperboloid('depth', v.theta, v.b, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.tan.F": (v) => tangential_force_of_hyperboloid(v.a, v.c, v.theta, v.b, v.H, v.k, v.mu),
  "fgm.tan.tau": (v) => traction_of_hyperboloid(v.r, v.a, v.c, v.theta, v.b, v.H, v.k, v.mu),
  "fgm.tan.u": (v) => tangential_displacement_of_hyperboloid(v.a, v.c, v.theta, v.b, v.H, v.H_x, v.k, v.mu),
  "fgm.tan.c": (v) => stick_radius_of_hyperboloid(v.F_x, v.a, v.theta, v.b, v.H, v.k, v.mu),
  "fgm.tan.us": (v) => full_slip_displacement_of_hyperboloid(v.a, v.theta, v.b, v.H, v.H_x, v.k, v.mu),
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
   "value": 0.12
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
   "value": 1e-06
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
   "value": 0.02
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
