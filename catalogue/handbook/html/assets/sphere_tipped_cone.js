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
  return (math.truth(beyond) ? pressure_integral_tanh(_arc_rate, [], r, a, R) : near);
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
        v178 = (2.0 * (math.truth(v158) ? 0.0 : 1.0));
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
      v17 = (math.truth(v8) ? (v9 - (v10 * (R + a))) : (v14 * v15));
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
        v75 = (math.truth(v8) ? (v9 - (v68 * (R + v67))) : ((v67 - v5) * (v67 + v5)));
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
      v81 = (math.truth(v38) ? Infinity : 0.0);
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
      v90 = (math.truth(v89) ? 0.0 : 1.0);
      v91 = (a - v6);
      v95 = Math.sqrt(((((v91 > 0.0) || (v91 !== v91)) ? v91 : 0.0) * (a + v6)));
      v96 = (a - v88);
      v100 = Math.sqrt(((((v96 > 0.0) || (v96 !== v96)) ? v96 : 0.0) * (a + v88)));
      v108 = Math.asinh(((math.truth(v89) ? v95 : v100) / Math.sqrt((Math.abs((v88 - v6)) * (v88 + v6)))));
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
        v179 = (2.0 * (math.truth(v159) ? 0.0 : 1.0));
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
    return (v203 - ((Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))) * (math.truth(v202) ? (0.6366197723675814 * Math.atan2(a, v92)) : 1.0)));
  }
  return _displacement_2(r, a, R, theta, E_star, dgamma);
};

const displacement_of_sphere_tipped_cone = (r, a, R, theta, E_star, dgamma) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_of_sphere_tipped_cone(r, a, R, theta, E_star, dgamma) : 0.0) : NaN);
};

const exponent_of = (x) => {
  return (math.frexp(x)[1] - 1);
};

const _rate = (a, R, theta) => {
  let v11, v16, v19, v20, v30, v4, v6;
  v4 = (R * Math.sin(theta));
  v11 = ((R - a) * (R + a));
  if ((a < v4)) {
    v20 = math.sqrt(v11);
    return (Math.asinh((a / v20)) + ((R * a) / (v20 * v20)));
  }
  v6 = (R * Math.cos(theta));
  v16 = ((v6 < v4) ? ((v6 * v6) - v11) : ((a - v4) * (a + v4)));
  v19 = math.sqrt((((v16 > 0.0) || (v16 !== v16)) ? v16 : 0.0));
  v30 = (v4 * v4);
  return ((math.log1p((((v30 / (v19 + a)) + (v30 / (v6 + R))) / (v19 + v6))) + ((v4 * Math.atan2(v19, v4)) / v6)) + ((v30 * R) / ((a * (v6 * v6)) + ((R * v19) * v6))));
};

const radii_around = (length = 1.0) => [1e-150, 1e-140, 1e-130, 1e-120, 1e-110, 1e-100, 1e-90, 1e-80, 1e-70, 1e-60, 1e-50, 1e-40, 1e-30, 1e-20, 1e-10, 0.0625, 0.125, 0.1875, 0.25, 0.3125, 0.375, 0.4375, 0.5, 0.5625, 0.625, 0.6875, 0.75, 0.8125, 0.875, 0.9375, 1.0, 1.0000000000000049, 1.0000000000000062, 1.0000000000000078, 1.00000000000001, 1.0000000000000124, 1.0000000000000158, 1.0000000000000198, 1.000000000000025, 1.0000000000000315, 1.0000000000000397, 1.00000000000005, 1.0000000000000628, 1.0000000000000793, 1.0000000000000997, 1.0000000000001255, 1.000000000000158, 1.000000000000199, 1.0000000000002505, 1.0000000000003155, 1.000000000000397, 1.0000000000005, 1.0000000000006295, 1.0000000000007925, 1.0000000000009976, 1.0000000000012559, 1.0000000000015812, 1.0000000000019904, 1.0000000000025058, 1.0000000000031548, 1.0000000000039715, 1.000000000005, 1.0000000000062945, 1.0000000000079243, 1.0000000000099762, 1.0000000000125593, 1.0000000000158114, 1.0000000000199054, 1.0000000000250593, 1.0000000000315479, 1.0000000000397165, 1.00000000005, 1.0000000000629463, 1.0000000000792446, 1.000000000099763, 1.0000000001255942, 1.0000000001581137, 1.0000000001990534, 1.0000000002505935, 1.0000000003154785, 1.000000000397164, 1.0000000005, 1.0000000006294627, 1.0000000007924466, 1.000000000997631, 1.0000000012559431, 1.0000000015811388, 1.0000000019905357, 1.0000000025059361, 1.0000000031547867, 1.000000003971641, 1.000000005, 1.000000006294627, 1.000000007924466, 1.0000000099763116, 1.0000000125594322, 1.0000000158113882, 1.0000000199053583, 1.0000000250593615, 1.0000000315478668, 1.0000000397164108, 1.0000000499999988, 1.0000000629462686, 1.0000000792446564, 1.0000000997631109, 1.0000001255943136, 1.0000001581138704, 1.0000001990535654, 1.0000002505935854, 1.0000003154786223, 1.0000003971640385, 1.000000499999875, 1.0000006294625077, 1.0000007924462821, 1.0000009976306599, 1.0000012559424272, 1.0000015811375802, 1.0000019905338717, 1.0000025059330282, 1.000003154781746, 1.0000039716332867, 1.0000049999875, 1.0000062946072479, 1.0000079244345639, 1.000009976261812, 1.000012559353289, 1.0000158112633029, 1.00001990516042, 1.0000250590477036, 1.0000315473696058, 1.0000397156230707, 1.0000499987500624, 1.0000629442895979, 1.0000792415200137, 1.0000997581399051, 1.0001255864355991, 1.0001581013849845, 1.0001990337780544, 1.000250562226099, 1.0003154289245368, 1.0003970852790027, 1.000499875062461, 1.000629264718854, 1.0007921328589973, 1.000997134019358, 1.00125515550808, 1.00157989080261, 1.0019885586699753, 1.00250280415382, 1.0031498260204212, 1.003963785376366, 1.0049875621120885, 1.0062749396253194, 1.007893313761238, 1.0099270385278765, 1.0124815377650564, 1.0156883265065522, 1.0197110948966603, 1.0247530060276584, 1.0310653395629263, 1.038957565770816, 1.0488088481701465, 1.061080836307679, 1.0763314170115514, 1.0952288489155435, 1.1185654398160756, 1.1472697006444488, 1.1824158196478314, 1.2252294616222776, 1.2770894034796945, 1.3395253766630146, 1.4142135623730545, 1.5029721926216806, 1.6077603031736196, 1.730682615319356, 1.8740027832181265, 2.040166086417477, 2.231831468891524, 2.4519119756369965, 2.7036222821986744, 2.99053211774123, 3.316624790355215, 3.68636055180989, 4.104745049891547, 4.577403537999059, 5.110661827502642, 5.711635195080283, 6.388326624034235, 7.149735894613227, 8.005981167103203, 8.96843483961487, 10.04987562112024, 11.264658946430675, 12.628908078139231, 14.160728494567662, 15.88044845559861, 17.81088897323198, 19.977666794534418, 22.40953443575305, 25.138761792898762, 28.201564402071295, 31.63858403911055, 35.49542804072076, 39.82327450701274, 44.679551418614366, 50.12869868158581, 56.243023213265424, 63.103658416405615, 70.8016407738692, 79.43911785009331, 89.13070372908327, 100.00499987499889, 112.20630159638924, 125.89651275793454, 141.25729414683593, 158.49247400142386, 177.830752688277, 199.52873741730454, 223.87434726363662, 251.19063367890456, 281.8400671877868, 316.2293471516906, 354.81479842221427, 398.10842649470067, 446.6847115100955, 501.1882312573971, 562.3422143293052, 630.9581369262412, 707.9464906525023, 794.3288641866736, 891.2514991427217, 1000.000499999875, 10000000000000.0, 1.0000000000000001e+23, 1e+33, 1e+43, 1e+53, 1e+63, 1e+73, 1e+83, 1e+93, 1e+103, 1e+113, 1e+123, 1e+133, 1e+143].map((x) => x * length);

const _samples = (R, theta) => {
  let a;
  a = radii_around((R * Math.sin(theta)));
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

const _branches = (R, theta, E_star, dgamma, control) => {
  return branches(((a) => (Math.sqrt(a) * _rate(a, R, theta))), _samples(R, theta), least_steepness(control, E_star, dgamma));
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

const _radius_from_depth_of_sphere_tipped_cone = (d, R, theta, E_star, dgamma) => {
  let found, radius, stress, unit;
  unit = exponent_of((R * Math.sin(theta)));
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  R = math.ldexp(R, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  d = math.ldexp(d, (-unit));
  found = _branches(R, theta, E_star, dgamma, 'depth');
  radius = stable_radius(d, found, ((a) => _depth_2(a, R, theta, E_star, dgamma)), ((a) => growth(_rate(a, R, theta), a, 'depth', E_star, dgamma)), ((a) => hess_retraction(a, E_star, dgamma)), up_to(R), beyond_edge((R * Math.sin(theta))), (R * Math.sin(theta)));
  return math.ldexp(radius, unit);
};

const radius_from_depth_of_sphere_tipped_cone = (d, R, theta, E_star, dgamma) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_depth_of_sphere_tipped_cone(d, R, theta, E_star, dgamma);
};

const pull = (a, E_star, dgamma) => {
  return (((2.0 * E_star) * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const _radius_from_force_of_sphere_tipped_cone = (F, R, theta, E_star, dgamma) => {
  let found, radius, stress, unit;
  unit = exponent_of((R * Math.sin(theta)));
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  R = math.ldexp(R, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  F = math.ldexp(F, (-(stress + (2 * unit))));
  found = _branches(R, theta, E_star, dgamma, 'force');
  radius = stable_radius(F, found, ((a) => _force_2(a, R, theta, E_star, dgamma)), ((a) => growth(_rate(a, R, theta), a, 'force', E_star, dgamma)), ((a) => pull(a, E_star, dgamma)), up_to(R), beyond_edge((R * Math.sin(theta))), (R * Math.sin(theta)));
  return math.ldexp(radius, unit);
};

const radius_from_force_of_sphere_tipped_cone = (F, R, theta, E_star, dgamma) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_force_of_sphere_tipped_cone(F, R, theta, E_star, dgamma);
};

const _pull_off_radius = (R, theta, E_star, dgamma, control) => {
  let found, load, radius, stress, unit;
  unit = exponent_of((R * Math.sin(theta)));
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  R = math.ldexp(R, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  found = _branches(R, theta, E_star, dgamma, control);
  load = ((control === 'force') ? _force_2 : _depth_2);
  radius = math.lowest(found, ((a) => load(a, R, theta, E_star, dgamma)));
  return math.ldexp(radius, unit);
};

const PullOff = (radius, force, depth) => math.record({ radius, force, depth });

const pull_off = (control = 'force', R, theta, E_star, dgamma) => {
  let depth, force, radius;
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  radius = _pull_off_radius(R, theta, E_star, dgamma, control);
  force = ((radius >= 0.0) ? _force_2(radius, R, theta, E_star, dgamma) : NaN);
  depth = ((radius >= 0.0) ? _depth_2(radius, R, theta, E_star, dgamma) : NaN);
  return PullOff(radius, force, depth);
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
  return [integrand, (math.truth(holds) ? (0.5 * Math.log1p(ratio)) : 0.0), 1.0, holds, 0.0];
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
  return [integrand, (math.truth(holds) ? Math.log1p((gaps / (beyond + root))) : 0.0), 1.0, holds, 0.0];
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
    v19 = (math.truth(v10) ? (v11 - ((R - a) * (R + a))) : (v16 * v17));
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
    v143 = (math.truth(v10) ? (v11 - (v136 * v137)) : ((c - v7) * (c + v7)));
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
          v275 = (0.5 * Math.log1p((((((2.0 * v238) * (math.truth(v257) ? (((v23 - c) * (v23 + c)) / (v251 + v243)) : 0.0)) / v255) * ((v238 + v251) / (v238 + v243))) / v255)));
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
          v340 = Math.log1p((((math.truth(v320) ? (v323 / (Math.sqrt(((((v16 > 0.0) || (v16 !== v16)) ? v16 : 0.0) * v17)) + v311)) : 0.0) + v334) / (v311 + v316)));
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
  return (mu * (math.truth(close) ? gain : (sliding - stuck)));
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
      v20 = (math.truth(v11) ? (v12 - (v13 * (R + a))) : (v17 * v18));
      v23 = Math.sqrt((((v20 > 0.0) || (v20 !== v20)) ? v20 : 0.0));
      v45 = (a * (Math.log1p((((v26 / (v23 + a)) + v30) / (v23 + v10))) + ((v8 * Math.atan2(v23, v8)) / v10)));
    }
    v46 = (R - c);
    v47 = (R + c);
    if ((c < v8)) {
      v73 = (c * (Math.log1p(((2.0 * c) / v46)) / 2.0));
    } else {
      v53 = (math.truth(v11) ? (v12 - (v46 * v47)) : ((c - v8) * (c + v8)));
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
          v120 = (0.5 * Math.log1p((((((2.0 * v82) * (math.truth(v102) ? (((v77 - c) * (v77 + c)) / (v95 + v87)) : 0.0)) / v100) * ((v82 + v95) / (v82 + v87))) / v100)));
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
          v190 = Math.log1p((((math.truth(v170) ? (v173 / (Math.sqrt(((((v17 > 0.0) || (v17 !== v17)) ? v17 : 0.0) * v18)) + v161)) : 0.0) + v184) / (v161 + v166)));
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

const _cap = (t, root, b, end, k, of) => {
  let along, from_low, from_top, half, low, top;
  low = ((root > 0.0) ? math.minimum(root, end) : end);
  [top, half] = [math.hypot(low, b), ((Math.log1p(Math.pow((b / low), 2)) / 4.0) + (0.0 * t))];
  along = (near, risen) => {
    let more, z;
    more = (risen * (near + low));
    z = Math.sqrt(((root * root) + more));
    return (((Math.pow(z, k) * of(((b * b) - more), Math.sqrt(((end * end) + more)))) * near) * (near / z));
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

const flank_depth = (a, root, b, k) => {
  return (a * sine_integral(Math.atan2(root, b), k));
};

const _within = (a, R, b) => {
  let v3, v4;
  v3 = (((a < b) || (a !== a)) ? a : b);
  v4 = (R - v3);
  return [v3, math.sqrt(((((v4 > 0.0) || (v4 !== v4)) ? v4 : 0.0) * (R + v3)))];
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

const either = (condition, x, y) => {
  if (Boolean(condition)) {
    return x();
  }
  return (Boolean(condition) ? (math.truth(condition) ? x() : y()) : y());
};

const tipped_depth = (a, root, R, b, end, k) => {
  let beyond;
  beyond = () => {
    let cap;
    cap = ((Math.pow(a, (-k)) * a) * _cap(a, root, b, end, k, ((below, far) => (1.0 / far))));
    return (cap + ((b / end) * flank_depth(a, root, b, k)));
  };
  return either((root > 0.0), beyond, (() => sphere_depth(..._within(a, R, b), k)));
};

const _depth_at_2 = (a, root, R, theta, k) => {
  let b;
  b = (R * Math.sin(theta));
  return tipped_depth(a, root, R, b, (R * Math.cos(theta)), k);
};

const _depth_3 = (a, R, theta, k) => {
  return _depth_at_2(a, sine_root(a, R, theta), R, theta, k);
};

const depth_2 = (a, R, theta, k) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_3(a, R, theta, k) : NaN);
};

const flank_force = (a, root, b, k) => {
  let sides, within;
  within = math.maximum(a, b);
  sides = ((raised((root / within), k) * (b / within)) + sine_integral(Math.atan2(root, b), k));
  return (((a * raised(a, k)) * sides) / (2.0 + k));
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

const tipped_force = (a, root, R, b, end, k) => {
  let beyond;
  beyond = () => {
    let cap;
    cap = _cap(a, root, b, end, k, ((below, far) => (below / far)));
    return (cap + ((b / end) * flank_force(a, root, b, k)));
  };
  return either((root > 0.0), beyond, (() => sphere_force(..._within(a, R, b), k)));
};

const _force_at_2 = (a, root, R, theta, H, k) => {
  let b, growth;
  b = (R * Math.sin(theta));
  growth = tipped_force(a, root, R, b, (R * Math.cos(theta)), k);
  return (((2.0 * H) / (1.0 + k)) * growth);
};

const _force_3 = (a, R, theta, H, k) => {
  return _force_at_2(a, sine_root(a, R, theta), R, theta, H, k);
};

const force_2 = (a, R, theta, H, k) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_3(a, R, theta, H, k) : NaN);
};

const past_tip = (x, R, b, end) => {
  if ((end < b)) {
    return ((x - R) + (end * (end / (R + b))));
  }
  return (x - b);
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

const tipped_rate = (t, root, R, b, end, k) => {
  let beyond;
  beyond = () => {
    let cap;
    cap = (Math.pow(t, (-k)) * _cap(t, root, b, end, k, ((below, far) => ((1.0 + Math.pow((R / far), 2)) / far))));
    return (cap + ((b / end) * sine_integral(Math.atan2(root, b), k)));
  };
  return either((root > 0.0), beyond, (() => sphere_rate(..._within(t, R, b), k)));
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

const tipped_pressure = (r, a, R, b, end, k) => {
  let last, past, reach, tip, whole, within;
  past = (x) => {
    return past_tip(x, R, b, end);
  };
  [within, whole] = [(past(r) < 0.0), (past(a) >= 0.0)];
  reach = math.where(whole, Math.sqrt((math.maximum((-past(r)), 0.0) * (b + r))), difference_root(a, r));
  last = math.where(whole, end, difference_root(R, a));
  tip = either(within, (() => _sphere(math.minimum(r, b), R, reach, last, k)), (() => math.zeros_like(reach)));
  return (tip + growth_beyond_cap(((t, root) => tipped_rate(t, root, R, b, end, k)), r, a, b, k, past, end));
};

const _pressure_5 = (r, a, R, theta, H, k) => {
  let b, growth, inside;
  b = (R * Math.sin(theta));
  inside = math.minimum(r, a);
  growth = tipped_pressure(inside, a, R, b, (R * Math.cos(theta)), k);
  return math.where((r < a), ((H / Math.PI) * growth), 0.0);
};

const pressure_2 = (r, a, R, theta, H, k) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_5(r, a, R, theta, H, k) : 0.0) : NaN);
};

const _Break = (b, root, more, end = Infinity) => math.record({ b, root, more, end });

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

const tipped_displacement = (r, a, R, b, end, k) => {
  let at, past, slope, tip, within;
  slope = (b / end);
  past = (x) => {
    return past_tip(x, R, b, end);
  };
  within = (more) => {
    return ((slope * past(a)) + (more / (end + Math.sqrt(((end * end) + more)))));
  };
  at = _Break(b, Math.sqrt((math.maximum(past(a), 0.0) * (a + b))), ((-past(r)) * (b + r)), end);
  tip = sphere_displacement(r, math.minimum(a, b), R, k);
  return ((a <= b) ? tip : _broken(((s, z) => ((slope * a) * (a / (a + s)))), within, r, a, k, at));
};

const _displacement_4 = (r, a, R, theta, k) => {
  let b;
  b = (R * Math.sin(theta));
  return tipped_displacement(r, a, R, b, (R * Math.cos(theta)), k);
};

const displacement_2 = (r, a, R, theta, k) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_4(r, a, R, theta, k) : 0.0) : NaN);
};

const punch_stiffness = (a, H, k) => {
  return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
};

const _stiffness_3 = (a, H, k) => {
  return punch_stiffness(a, H, k);
};

const _stiffness_2 = (a, H, k, R = 1.0, theta = 0.7853981633974483) => {
  if (((a > 1e-30) && (a < 1e+30) && (H > 1e-30) && (H < 1e+30) && (k > 1e-30) && (k < 1.0) && (R > 1e-30) && (R < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966))) {
    return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  }
  return _stiffness_3(a, H, k);
};

const stiffness_of_sphere_tipped_cone = (a, R, theta, H, k) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness_2(a, H, k) : NaN);
};

const _mean_pressure_2 = (a, R, theta, H, k) => {
  return ((a > 0.0) ? (_force_3(a, R, theta, H, k) / ((Math.PI * a) * a)) : 0.0);
};

const mean_pressure_of_sphere_tipped_cone = (a, R, theta, H, k) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure_2(a, R, theta, H, k) : NaN);
};

const _rate_at = (a, root, R, theta, k) => {
  let b;
  b = (R * Math.sin(theta));
  return tipped_rate(a, root, R, b, (R * Math.cos(theta)), k);
};

const _with_rate = (load, rate, needs) => {
  return ((a, root) => [load(a, root, ...needs), (a * rate(a, root, ...needs))]);
};

const NEAREST = 1e-12;

const CLOSE_of_unknowns = 0.0001;

const at_break = math.kept((of, b, first, ...needs) => {
  let a, load, rate, root;
  [load, rate] = of;
  [a, root] = [(b * Math.pow((1.0 + (CLOSE_of_unknowns * CLOSE_of_unknowns)), 0.5)), (b * CLOSE_of_unknowns)];
  return [load(b, first, ...needs), load(a, root, ...needs), (a * rate(a, root, ...needs))];
});

const radius_itself = () => {
  return Unknown(((a) => a), ((x) => [x, math.ones_like(x)]));
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

const _radius_from_depth_2 = (d, R, theta, k) => {
  let b;
  b = (R * Math.sin(theta));
  return radius_across(_depth_at_2, _rate_at, d, b, [R, theta, k], 2.0, undefined, R);
};

const radius_from_depth_2 = (d, R, theta, k) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth_2(d, R, theta, k) : NaN);
};

const _force_rate_at = (a, root, R, theta, H, k) => {
  return (punch_stiffness(a, H, k) * _rate_at(a, root, R, theta, k));
};

const _radius_from_force_2 = (F, R, theta, H, k) => {
  let b;
  b = (R * Math.sin(theta));
  return radius_across(_force_at_2, _force_rate_at, F, b, [R, theta, H, k], (3.0 + k), undefined, R);
};

const radius_from_force_2 = (F, R, theta, H, k) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _radius_from_force_2(F, R, theta, H, k) : NaN);
};

const punch_force = (d, a, H, k) => {
  let v14;
  v14 = (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  if (((v14 > 0.0) && (v14 < Infinity))) {
    return (v14 * d);
  }
  return 0.0;
};

const _force_from_depth_of_sphere_tipped_cone = (d, R, theta, H, k) => {
  let a;
  a = _radius_from_depth_2(d, R, theta, k);
  return (_force_3(a, R, theta, H, k) + punch_force((d - _depth_3(a, R, theta, k)), a, H, k));
};

const force_from_depth_of_sphere_tipped_cone = (d, R, theta, H, k) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth_of_sphere_tipped_cone(d, R, theta, H, k) : NaN);
};

const punch_depth = (F, a, H, k) => {
  let v14;
  v14 = (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  if (((v14 > 0.0) && (v14 < Infinity))) {
    return (F / v14);
  }
  return 0.0;
};

const _depth_from_force_of_sphere_tipped_cone = (F, R, theta, H, k) => {
  let a;
  a = _radius_from_force_2(F, R, theta, H, k);
  return (_depth_3(a, R, theta, k) + punch_depth((F - _force_3(a, R, theta, H, k)), a, H, k));
};

const depth_from_force_of_sphere_tipped_cone = (F, R, theta, H, k) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force_of_sphere_tipped_cone(F, R, theta, H, k) : NaN);
};

const graded_retraction = (a, H, k, dgamma) => {
  if ((a > 0.0)) {
    return ((math.sqrt(((6.283185307179586 * dgamma) / H)) * math.sqrt(a)) * math.sqrt(Math.pow(a, (-k))));
  }
  return 0.0;
};

const retraction_of_sphere_tipped_cone = (a, H, k, dgamma) => {
  if ((!((0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? graded_retraction(a, H, k, dgamma) : NaN);
};

const _depth_4 = (a, R, theta, H, k, dgamma) => {
  return (_depth_3(a, R, theta, k) - graded_retraction(a, H, k, dgamma));
};

const depth_3 = (a, R, theta, H, k, dgamma) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_4(a, R, theta, H, k, dgamma) : NaN);
};

const _force_4 = (a, R, theta, H, k, dgamma) => {
  return (_force_3(a, R, theta, H, k) - (punch_stiffness(a, H, k) * graded_retraction(a, H, k, dgamma)));
};

const force_3 = (a, R, theta, H, k, dgamma) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_4(a, R, theta, H, k, dgamma) : NaN);
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

const _pressure_6 = (r, a, R, theta, H, k, dgamma) => {
  return (_pressure_5(r, a, R, theta, H, k) - tension_of_punch(r, a, H, k, dgamma));
};

const pressure_3 = (r, a, R, theta, H, k, dgamma) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_6(r, a, R, theta, H, k, dgamma) : 0.0) : NaN);
};

const punch_displacement = (r, a, k) => {
  return ((r > a) ? punch_share(r, a, k) : 1.0);
};

const _displacement_5 = (r, a, R, theta, H, k, dgamma) => {
  return (_displacement_4(r, a, R, theta, k) - (graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)));
};

const displacement_3 = (r, a, R, theta, H, k, dgamma) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_5(r, a, R, theta, H, k, dgamma) : 0.0) : NaN);
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

const _rate_of_sphere_tipped_cone = (a, R, theta, k) => {
  return _rate_at(a, sine_root(a, R, theta), R, theta, k);
};

const _samples_of_sphere_tipped_cone = (R, theta, k) => {
  let a;
  a = radii_around((R * Math.sin(theta)));
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

const _branches_of_sphere_tipped_cone = (R, theta, H, k, dgamma, control) => {
  return branches(((a) => (Math.pow(a, ((1.0 + k) / 2.0)) * _rate_of_sphere_tipped_cone(a, R, theta, k))), _samples_of_sphere_tipped_cone(R, theta, k), least_steepness_of_punch(control, H, k, dgamma));
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

const _radius_from_depth_3 = (d, R, theta, H, k, dgamma) => {
  let found, pulled, radius, slope, stress, unit;
  unit = exponent_of((R * Math.sin(theta)));
  [stress, H] = stress_at(unit, H, k);
  R = math.ldexp(R, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  d = math.ldexp(d, (-unit));
  found = _branches_of_sphere_tipped_cone(R, theta, H, k, dgamma, 'depth');
  slope = growth_of(_rate_of_sphere_tipped_cone, [R, theta, k], H, k, dgamma, 'depth');
  pulled = pull_of(H, k, dgamma, 'depth');
  radius = stable_radius(d, found, ((a) => _depth_4(a, R, theta, H, k, dgamma)), slope, pulled, up_to(R, k), beyond_edge((R * Math.sin(theta))), (R * Math.sin(theta)));
  return math.ldexp(radius, unit);
};

const radius_from_depth_3 = (d, R, theta, H, k, dgamma) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_depth_3(d, R, theta, H, k, dgamma);
};

const _radius_from_force_3 = (F, R, theta, H, k, dgamma) => {
  let found, pulled, radius, slope, stress, unit;
  unit = exponent_of((R * Math.sin(theta)));
  [stress, H] = stress_at(unit, H, k);
  R = math.ldexp(R, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  F = math.ldexp(F, (-(stress + (2 * unit))));
  found = _branches_of_sphere_tipped_cone(R, theta, H, k, dgamma, 'force');
  slope = growth_of(_rate_of_sphere_tipped_cone, [R, theta, k], H, k, dgamma, 'force');
  pulled = pull_of(H, k, dgamma, 'force');
  radius = stable_radius(F, found, ((a) => _force_4(a, R, theta, H, k, dgamma)), slope, pulled, up_to(R, k), beyond_edge((R * Math.sin(theta))), (R * Math.sin(theta)));
  return math.ldexp(radius, unit);
};

const radius_from_force_3 = (F, R, theta, H, k, dgamma) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_force_3(F, R, theta, H, k, dgamma);
};

const _pull_off_radius_of_sphere_tipped_cone = (R, theta, H, k, dgamma, control) => {
  let found, load, radius, stress, unit;
  unit = exponent_of((R * Math.sin(theta)));
  [stress, H] = stress_at(unit, H, k);
  R = math.ldexp(R, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  found = _branches_of_sphere_tipped_cone(R, theta, H, k, dgamma, control);
  load = ((control === 'force') ? _force_4 : _depth_4);
  radius = math.lowest(found, ((a) => load(a, R, theta, H, k, dgamma)));
  return math.ldexp(radius, unit);
};

const pull_off_of_sphere_tipped_cone = (control = 'force', R, theta, H, k, dgamma) => {
  let depth, force, radius;
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  radius = _pull_off_radius_of_sphere_tipped_cone(R, theta, H, k, dgamma, control);
  force = ((radius >= 0.0) ? _force_4(radius, R, theta, H, k, dgamma) : NaN);
  depth = ((radius >= 0.0) ? _depth_4(radius, R, theta, H, k, dgamma) : NaN);
  return PullOff(radius, force, depth);
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

const _close = (m, c, a) => {
  let inner;
  inner = difference_root(c, m);
  return ((inner > 0.0) & (inner >= (CLOSE * difference_root(a, m))));
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

const tipped_gain = (quantity, whole, rate, lengths, r, c, a, k) => {
  let R, _, b, tip;
  [R, b, ..._] = lengths;
  tip = (close) => {
    return _grown_below(quantity, sphere_rate, r, c, math.minimum(a, math.maximum(b, c)), R, k, (close & (c < b)));
  };
  return _across(quantity, tip, whole, rate, lengths, b, r, c, a, k);
};

const _tangential_force_2 = (a, c, R, theta, H, k, mu) => {
  let b, gain;
  b = (R * Math.sin(theta));
  gain = tipped_gain('force', tipped_force, tipped_rate, [R, b, (R * Math.cos(theta))], 0.0, c, a, k);
  return ((mu * ((2.0 * H) / (1.0 + k))) * gain);
};

const tangential_force_of_sphere_tipped_cone = (a, c, R, theta, H, k, mu) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_force_2(a, c, R, theta, H, k, mu) : NaN);
};

const _traction_of_sphere_tipped_cone = (r, a, c, R, theta, H, k, mu) => {
  let b, gain;
  b = (R * Math.sin(theta));
  gain = () => {
    let inside;
    inside = math.minimum(r, c);
    return tipped_gain('pressure', tipped_pressure, tipped_rate, [R, b, (R * Math.cos(theta))], inside, c, a, k);
  };
  return (mu * either((r < c), (() => ((H / Math.PI) * gain())), (() => _pressure_5(r, a, R, theta, H, k))));
};

const traction_of_sphere_tipped_cone = (r, a, c, R, theta, H, k, mu) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction_of_sphere_tipped_cone(r, a, c, R, theta, H, k, mu) : 0.0) : NaN);
};

const _tangential_displacement_2 = (a, c, R, theta, H, H_x, k, mu) => {
  let b, gain;
  b = (R * Math.sin(theta));
  gain = tipped_gain('depth', tipped_depth, tipped_rate, [R, b, (R * Math.cos(theta))], 0.0, c, a, k);
  return ((mu * (H / H_x)) * gain);
};

const tangential_displacement_of_sphere_tipped_cone = (a, c, R, theta, H, H_x, k, mu) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement_2(a, c, R, theta, H, H_x, k, mu) : NaN);
};

const _stick_radius_of_sphere_tipped_cone = (F_x, a, R, theta, H, k, mu) => {
  let F;
  F = stick_force(_force_3(a, R, theta, H, k), F_x, mu);
  return (((F_x === 0.0) & (a >= 0.0)) ? a : _radius_from_force_2(F, R, theta, H, k));
};

const stick_radius_of_sphere_tipped_cone = (F_x, a, R, theta, H, k, mu) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius_of_sphere_tipped_cone(F_x, a, R, theta, H, k, mu) : NaN);
};

const _full_slip_displacement_2 = (a, R, theta, H, H_x, k, mu) => {
  return ((mu * (H / H_x)) * _depth_3(a, R, theta, k));
};

const full_slip_displacement_of_sphere_tipped_cone = (a, R, theta, H, H_x, k, mu) => {
  if ((!((0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement_2(a, R, theta, H, H_x, k, mu) : NaN);
};

const relaxation_maxwell = (t, E, tau) => {
  return (E * Math.exp(((-t) / tau)));
};

const _step_force_maxwell = (t, d, R, theta, E, tau) => {
  return (relaxation_maxwell(t, E, tau) * _force_from_depth(d, R, theta, 1.0));
};

const step_force_maxwell = (t, d, R, theta, E, tau) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_maxwell(t, d, R, theta, E, tau) : NaN);
};

const creep_maxwell = (t, E, tau) => {
  return ((1.0 + (t / tau)) / E);
};

const _step_load_radius_maxwell = (t, F, R, theta, E, tau) => {
  return _radius_from_force((F * creep_maxwell(t, E, tau)), R, theta, 1.0);
};

const step_load_radius_maxwell = (t, F, R, theta, E, tau) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_maxwell(t, F, R, theta, E, tau) : NaN);
};

const relaxation_kelvin_voigt = (t, E, eta) => {
  if ((t > 0.0)) {
    return E;
  }
  return Infinity;
};

const _step_force_kelvin_voigt = (t, d, R, theta, E, eta) => {
  return (relaxation_kelvin_voigt(t, E, eta) * _force_from_depth(d, R, theta, 1.0));
};

const step_force_kelvin_voigt = (t, d, R, theta, E, eta) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_kelvin_voigt(t, d, R, theta, E, eta) : NaN);
};

const creep_kelvin_voigt = (t, E, eta) => {
  return ((-Math.expm1((((-E) * t) / eta))) / E);
};

const _step_load_radius_kelvin_voigt = (t, F, R, theta, E, eta) => {
  return _radius_from_force((F * creep_kelvin_voigt(t, E, eta)), R, theta, 1.0);
};

const step_load_radius_kelvin_voigt = (t, F, R, theta, E, eta) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_kelvin_voigt(t, F, R, theta, E, eta) : NaN);
};

const relaxation_standard_solid = (t, E_inf, E_1, tau) => {
  return (E_inf + (E_1 * Math.exp(((-t) / tau))));
};

const _step_force_standard_solid = (t, d, R, theta, E_inf, E_1, tau) => {
  return (relaxation_standard_solid(t, E_inf, E_1, tau) * _force_from_depth(d, R, theta, 1.0));
};

const step_force_standard_solid = (t, d, R, theta, E_inf, E_1, tau) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_standard_solid(t, d, R, theta, E_inf, E_1, tau) : NaN);
};

const creep_standard_solid = (t, E_inf, E_1, tau) => {
  let v4;
  v4 = (E_inf + E_1);
  return ((1.0 / v4) - (((E_1 / v4) * Math.expm1((-((t / tau) * (E_inf / v4))))) / E_inf));
};

const _step_load_radius_standard_solid = (t, F, R, theta, E_inf, E_1, tau) => {
  return _radius_from_force((F * creep_standard_solid(t, E_inf, E_1, tau)), R, theta, 1.0);
};

const step_load_radius_standard_solid = (t, F, R, theta, E_inf, E_1, tau) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_standard_solid(t, F, R, theta, E_inf, E_1, tau) : NaN);
};

const relaxation_power_creep = (t, E, alpha, t_0) => {
  let v8;
  v8 = (3.141592653589793 * alpha);
  return (((E * Math.pow((t_0 / t), alpha)) * Math.sin(v8)) / v8);
};

const _step_force_power_creep = (t, d, R, theta, E, alpha, t_0) => {
  return (relaxation_power_creep(t, E, alpha, t_0) * _force_from_depth(d, R, theta, 1.0));
};

const step_force_power_creep = (t, d, R, theta, E, alpha, t_0) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_power_creep(t, d, R, theta, E, alpha, t_0) : NaN);
};

const creep_power_creep = (t, E, alpha, t_0) => {
  return (Math.pow((t / t_0), alpha) / E);
};

const _step_load_radius_power_creep = (t, F, R, theta, E, alpha, t_0) => {
  return _radius_from_force((F * creep_power_creep(t, E, alpha, t_0)), R, theta, 1.0);
};

const step_load_radius_power_creep = (t, F, R, theta, E, alpha, t_0) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < R && R < Infinity) && (0.0 < theta && theta < 1.5707963267948966) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_power_creep(t, F, R, theta, E, alpha, t_0) : NaN);
};

const once = { pull_off: math.kept(pull_off), pull_off_of_sphere_tipped_cone: math.kept(pull_off_of_sphere_tipped_cone) };
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
  "adh.ad": (v) => radius_from_depth_of_sphere_tipped_cone(v.d, v.R, v.theta, v.E_star, v.dgamma),
  "adh.aF": (v) => radius_from_force_of_sphere_tipped_cone(v.F, v.R, v.theta, v.E_star, v.dgamma),
  "adh.ac": (v) => (once.pull_off('force', v.R, v.theta, v.E_star, v.dgamma).radius ?? NaN),
  "adh.Fc": (v) => (once.pull_off('force', v.R, v.theta, v.E_star, v.dgamma).force ?? NaN),
  "adh.dc": (v) => (once.pull_off('force', v.R, v.theta, v.E_star, v.dgamma).depth ?? NaN),
  "adh.am": (v) => (once.pull_off('depth', v.R, v.theta, v.E_star, v.dgamma).radius ?? NaN),
  "adh.Fm": (v) => (once.pull_off('depth', v.R, v.theta, v.E_star, v.dgamma).force ?? NaN),
  "adh.dm": (v) => (once.pull_off('depth', v.R, v.theta, v.E_star, v.dgamma).depth ?? NaN),
  "tan.F": (v) => tangential_force(v.a, v.c, v.R, v.theta, v.E_star, v.mu),
  "tan.tau": (v) => traction(v.r, v.a, v.c, v.R, v.theta, v.E_star, v.mu),
  "tan.u": (v) => tangential_displacement(v.a, v.c, v.R, v.theta, v.E_star, v.G_star, v.mu),
  "tan.c": (v) => stick_radius(v.F_x, v.a, v.R, v.theta, v.E_star, v.mu),
  "tan.us": (v) => full_slip_displacement(v.a, v.R, v.theta, v.E_star, v.G_star, v.mu),
  "fgm.d": (v) => depth_2(v.a, v.R, v.theta, v.k),
  "fgm.F": (v) => force_2(v.a, v.R, v.theta, v.H, v.k),
  "fgm.p": (v) => pressure_2(v.r, v.a, v.R, v.theta, v.H, v.k),
  "fgm.w": (v) => displacement_2(v.r, v.a, v.R, v.theta, v.k),
  "fgm.k": (v) => stiffness_of_sphere_tipped_cone(v.a, v.R, v.theta, v.H, v.k),
  "fgm.pm": (v) => mean_pressure_of_sphere_tipped_cone(v.a, v.R, v.theta, v.H, v.k),
  "fgm.ad": (v) => radius_from_depth_2(v.d, v.R, v.theta, v.k),
  "fgm.aF": (v) => radius_from_force_2(v.F, v.R, v.theta, v.H, v.k),
  "fgm.Fd": (v) => force_from_depth_of_sphere_tipped_cone(v.d, v.R, v.theta, v.H, v.k),
  "fgm.dF": (v) => depth_from_force_of_sphere_tipped_cone(v.F, v.R, v.theta, v.H, v.k),
  "fgm.adh.Dl": (v) => retraction_of_sphere_tipped_cone(v.a, v.H, v.k, v.dgamma),
  "fgm.adh.d": (v) => depth_3(v.a, v.R, v.theta, v.H, v.k, v.dgamma),
  "fgm.adh.F": (v) => force_3(v.a, v.R, v.theta, v.H, v.k, v.dgamma),
  "fgm.adh.p": (v) => pressure_3(v.r, v.a, v.R, v.theta, v.H, v.k, v.dgamma),
  "fgm.adh.w": (v) => displacement_3(v.r, v.a, v.R, v.theta, v.H, v.k, v.dgamma),
  "fgm.adh.ad": (v) => radius_from_depth_3(v.d, v.R, v.theta, v.H, v.k, v.dgamma),
  "fgm.adh.aF": (v) => radius_from_force_3(v.F, v.R, v.theta, v.H, v.k, v.dgamma),
  "fgm.adh.ac": (v) => (once.pull_off_of_sphere_tipped_cone('force', v.R, v.theta, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fc": (v) => (once.pull_off_of_sphere_tipped_cone('force', v.R, v.theta, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dc": (v) => (once.pull_off_of_sphere_tipped_cone('force', v.R, v.theta, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.adh.am": (v) => (once.pull_off_of_sphere_tipped_cone('depth', v.R, v.theta, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fm": (v) => (once.pull_off_of_sphere_tipped_cone('depth', v.R, v.theta, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dm": (v) => (once.pull_off_of_sphere_tipped_cone('depth', v.R, v.theta, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.tan.F": (v) => tangential_force_of_sphere_tipped_cone(v.a, v.c, v.R, v.theta, v.H, v.k, v.mu),
  "fgm.tan.tau": (v) => traction_of_sphere_tipped_cone(v.r, v.a, v.c, v.R, v.theta, v.H, v.k, v.mu),
  "fgm.tan.u": (v) => tangential_displacement_of_sphere_tipped_cone(v.a, v.c, v.R, v.theta, v.H, v.H_x, v.k, v.mu),
  "fgm.tan.c": (v) => stick_radius_of_sphere_tipped_cone(v.F_x, v.a, v.R, v.theta, v.H, v.k, v.mu),
  "fgm.tan.us": (v) => full_slip_displacement_of_sphere_tipped_cone(v.a, v.R, v.theta, v.H, v.H_x, v.k, v.mu),
  "vis.step_mx": (v) => step_force_maxwell(v.t, v.d, v.R, v.theta, v.E_law, v.tau),
  "vis.load_mx": (v) => step_load_radius_maxwell(v.t, v.F, v.R, v.theta, v.E_law, v.tau),
  "vis.step_kv": (v) => step_force_kelvin_voigt(v.t, v.d, v.R, v.theta, v.E_law, v.eta),
  "vis.load_kv": (v) => step_load_radius_kelvin_voigt(v.t, v.F, v.R, v.theta, v.E_law, v.eta),
  "vis.step_sls": (v) => step_force_standard_solid(v.t, v.d, v.R, v.theta, v.E_inf, v.E_1, v.tau),
  "vis.load_sls": (v) => step_load_radius_standard_solid(v.t, v.F, v.R, v.theta, v.E_inf, v.E_1, v.tau),
  "vis.step_pc": (v) => step_force_power_creep(v.t, v.d, v.R, v.theta, v.E_law, v.alpha, v.t_0),
  "vis.load_pc": (v) => step_load_radius_power_creep(v.t, v.F, v.R, v.theta, v.E_law, v.alpha, v.t_0),
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
   "suffix": "d",
   "medium": 0
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
   "suffix": "F",
   "medium": 0
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
   "suffix": "p",
   "medium": 0
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
   "suffix": "w",
   "medium": 0
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
   "suffix": "k",
   "medium": 0
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
   "suffix": "pm",
   "medium": 0
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
   "suffix": "U",
   "medium": 0
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
   "suffix": "Fr",
   "medium": 0
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
   "suffix": "ad",
   "medium": 0
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
   "suffix": "aF",
   "medium": 0
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
   "suffix": "Fd",
   "medium": 0
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
    "R",
    "theta",
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
