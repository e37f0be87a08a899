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

const _depth = (a, h, s) => {
  let v3, v47, v9;
  if ((a <= (1.5019752682686114 * s))) {
    v3 = (a / s);
    v9 = (v3 * v3);
    v47 = (((((((((((((((((((((((((1.567077144036674e-13 * v9) + (-3.840375691006307e-12)) * v9) + 3.8015754128174666e-11) * v9) + (-1.8423006918213799e-10)) * v9) + 4.472469827763728e-10) * v9) + (-1.1927516362741588e-09)) * v9) + 6.225892246861416e-09) * v9) + 3.4413148480148793e-09) * v9) + (-9.933344851449817e-08)) * v9) + (-5.127541706569233e-07)) * v9) + 1.8119768160503268e-06) * v9) + 2.151585040783394e-05) * v9) + 4.61098799999374e-06) * v9);
    return (((2.0 * h) * (v3 / (((((((((((v47 + (-0.000684089638073553)) * v9) + (-0.002257495580553435)) * v9) + 0.016931216930225715) * v9) + 0.17777777777782838) * v9) + 0.6666666666666656) * v9) + 1.0))) * v3);
  }
  return NaN;
};

const depth = (a, h, s) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth(a, h, s) : NaN);
};

const RULE_0 = math.rule([[Infinity, 32]]);

const _force = (a, h, s, E_star) => {
  let node, v10, v11, v49, v66, v7, v73, v74, v8, weight;
  if ((a <= (1.5019752682686114 * s))) {
    v10 = ((2.0 * h) / s);
    v74 = [];
    for ([node, weight] of RULE_0((a / 1.0))) {
      v7 = (node * a);
      v8 = (v7 / s);
      v11 = (v8 * v8);
      v49 = (((((((((((((((((((((((((1.567077144036674e-13 * v11) + (-3.840375691006307e-12)) * v11) + 3.8015754128174666e-11) * v11) + (-1.8423006918213799e-10)) * v11) + 4.472469827763728e-10) * v11) + (-1.1927516362741588e-09)) * v11) + 6.225892246861416e-09) * v11) + 3.4413148480148793e-09) * v11) + (-9.933344851449817e-08)) * v11) + (-5.127541706569233e-07)) * v11) + 1.8119768160503268e-06) * v11) + 2.151585040783394e-05) * v11) + 4.61098799999374e-06) * v11);
      v66 = (v8 / (((((((((((v49 + (-0.000684089638073553)) * v11) + (-0.002257495580553435)) * v11) + 0.016931216930225715) * v11) + 0.17777777777782838) * v11) + 0.6666666666666656) * v11) + 1.0));
      v73 = (v7 * (v10 * (v66 + ((1.0 - ((2.0 * v66) * v8)) * v8))));
      v74.push((weight * v73));
    }
    v74 = (math.fsum(v74) * a);
    return ((2.0 * E_star) * v74);
  }
  return NaN;
};

const force = (a, h, s, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force(a, h, s, E_star) : NaN);
};

const RULE_0_of_gaussian = math.rule([[Infinity, 32]]);

const DAWSON = [[1.0, 0.6666666666666656, 0.17777777777782838, 0.016931216930225715, (-0.002257495580553435), (-0.000684089638073553), 4.61098799999374e-06, 2.151585040783394e-05, 1.8119768160503268e-06, (-5.127541706569233e-07), (-9.933344851449817e-08), 3.4413148480148793e-09, 6.225892246861416e-09, (-1.1927516362741588e-09), 4.472469827763728e-10, (-1.8423006918213799e-10), 3.8015754128174666e-11, (-3.840375691006307e-12), 1.567077144036674e-13], [1.0]];

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

const dawson = (x) => {
  return (x / rational((x * x), ...DAWSON));
};

const _slope = (t, h, s) => {
  let z;
  z = (t / s);
  return (((2 * h) / s) * (dawson(z) + ((1 - ((2 * dawson(z)) * z)) * z)));
};

const difference_root = (x, y) => {
  let v2;
  v2 = (x - y);
  return math.sqrt(((((v2 > 0.0) || (v2 !== v2)) ? v2 : 0.0) * (x + y)));
};

const pressure_integral = (slope, r, a, count) => {
  let integrand;
  integrand = (u) => {
    let t;
    t = Math.sqrt(((r * r) + (u * u)));
    return (slope(t) / t);
  };
  return math.integral(integrand, difference_root(a, r), count);
};

const _pressure_of_gaussian = (r, a, h, s, E_star) => {
  let inside, within;
  within = pressure_integral(((t) => _slope(t, h, s)), r, a, 32);
  inside = math.where((r < a), ((E_star / Math.PI) * within), 0.0);
  return math.where((a <= (1.5019752682686114 * s)), inside, NaN);
};

const _pressure = (r, a, h, s, E_star) => {
  let node, v10, v12, v13, v16, v17, v20, v21, v5, v59, v76, v83, v84, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (s > 1e-30) && (s < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((a <= (1.5019752682686114 * s))) {
      if ((r < a)) {
        v5 = (a - r);
        v10 = Math.sqrt(((((v5 > 0.0) || (v5 !== v5)) ? v5 : 0.0) * (a + r)));
        v13 = (r * r);
        v20 = ((2.0 * h) / s);
        v84 = [];
        for ([node, weight] of RULE_0_of_gaussian((v10 / 1.0))) {
          v12 = (node * v10);
          v16 = Math.sqrt((v13 + (v12 * v12)));
          v17 = (v16 / s);
          v21 = (v17 * v17);
          v59 = (((((((((((((((((((((((((1.567077144036674e-13 * v21) + (-3.840375691006307e-12)) * v21) + 3.8015754128174666e-11) * v21) + (-1.8423006918213799e-10)) * v21) + 4.472469827763728e-10) * v21) + (-1.1927516362741588e-09)) * v21) + 6.225892246861416e-09) * v21) + 3.4413148480148793e-09) * v21) + (-9.933344851449817e-08)) * v21) + (-5.127541706569233e-07)) * v21) + 1.8119768160503268e-06) * v21) + 2.151585040783394e-05) * v21) + 4.61098799999374e-06) * v21);
          v76 = (v17 / (((((((((((v59 + (-0.000684089638073553)) * v21) + (-0.002257495580553435)) * v21) + 0.016931216930225715) * v21) + 0.17777777777782838) * v21) + 0.6666666666666656) * v21) + 1.0));
          v83 = ((v20 * (v76 + ((1.0 - ((2.0 * v76) * v17)) * v17))) / v16);
          v84.push((weight * v83));
        }
        v84 = (math.fsum(v84) * v10);
        return ((E_star / 3.141592653589793) * v84);
      }
      return 0.0;
    }
    return NaN;
  }
  return _pressure_of_gaussian(r, a, h, s, E_star);
};

const pressure = (r, a, h, s, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure(r, a, h, s, E_star) : 0.0) : NaN);
};

const _displacement = (r, a, h, s) => {
  let node, v10, v117, v12, v133, v15, v17, v18, v19, v4, v57, v74, v83, v84, v88, v91, v92, weight;
  v91 = (a <= (1.5019752682686114 * s));
  if (v91) {
    v17 = (2.0 * h);
    if ((r > a)) {
      v4 = (r - a);
      v10 = Math.atan2(a, math.sqrt(((((v4 > 0.0) || (v4 !== v4)) ? v4 : 0.0) * (r + a))));
      v18 = (v17 / s);
      v84 = [];
      for ([node, weight] of RULE_0((v10 / 1.0))) {
        v12 = (node * v10);
        v15 = ((r * Math.sin(v12)) / s);
        v19 = (v15 * v15);
        v57 = (((((((((((((((((((((((((1.567077144036674e-13 * v19) + (-3.840375691006307e-12)) * v19) + 3.8015754128174666e-11) * v19) + (-1.8423006918213799e-10)) * v19) + 4.472469827763728e-10) * v19) + (-1.1927516362741588e-09)) * v19) + 6.225892246861416e-09) * v19) + 3.4413148480148793e-09) * v19) + (-9.933344851449817e-08)) * v19) + (-5.127541706569233e-07)) * v19) + 1.8119768160503268e-06) * v19) + 2.151585040783394e-05) * v19) + 4.61098799999374e-06) * v19);
        v74 = (v15 / (((((((((((v57 + (-0.000684089638073553)) * v19) + (-0.002257495580553435)) * v19) + 0.016931216930225715) * v19) + 0.17777777777782838) * v19) + 0.6666666666666656) * v19) + 1.0));
        v83 = (((v18 * (v74 + ((1.0 - ((2.0 * v74) * v15)) * v15))) * v12) * Math.cos(v12));
        v84.push((weight * v83));
      }
      v84 = (math.fsum(v84) * v10);
      return (0.6366197723675814 * (r * v84));
    }
    if (v91) {
      v88 = (a / s);
      v92 = (v88 * v88);
      v117 = (((((((((((((((((((((((((1.567077144036674e-13 * v92) + (-3.840375691006307e-12)) * v92) + 3.8015754128174666e-11) * v92) + (-1.8423006918213799e-10)) * v92) + 4.472469827763728e-10) * v92) + (-1.1927516362741588e-09)) * v92) + 6.225892246861416e-09) * v92) + 3.4413148480148793e-09) * v92) + (-9.933344851449817e-08)) * v92) + (-5.127541706569233e-07)) * v92) + 1.8119768160503268e-06) * v92) + 2.151585040783394e-05) * v92) + 4.61098799999374e-06) * v92);
      v133 = ((v17 * (v88 / (((((((((((v117 + (-0.000684089638073553)) * v92) + (-0.002257495580553435)) * v92) + 0.016931216930225715) * v92) + 0.17777777777782838) * v92) + 0.6666666666666656) * v92) + 1.0))) * v88);
    } else {
      v133 = NaN;
    }
    return (v133 - ((-h) * Math.expm1(((-(r * r)) / (s * s)))));
  }
  return NaN;
};

const displacement = (r, a, h, s) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement(r, a, h, s) : 0.0) : NaN);
};

const _stiffness_of_gaussian = (a, s, E_star) => {
  return math.where((a <= (1.5019752682686114 * s)), ((2 * E_star) * a), NaN);
};

const _stiffness = (a, s, E_star, h = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (s > 1e-30) && (s < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (h > 1e-30) && (h < 1e+30))) {
    if ((a <= (1.5019752682686114 * s))) {
      return ((2.0 * E_star) * a);
    }
    return NaN;
  }
  return _stiffness_of_gaussian(a, s, E_star);
};

const stiffness = (a, h, s, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness(a, s, E_star) : NaN);
};

const force_integral = (slope, a, count) => {
  return math.integral(((t) => (t * slope(t))), a, count);
};

const _force_of_gaussian = (a, h, s, E_star) => {
  let tip;
  tip = ((2 * E_star) * force_integral(((t) => _slope(t, h, s)), a, 32));
  return math.where((a <= (1.5019752682686114 * s)), tip, NaN);
};

const _mean_pressure_of_gaussian = (a, h, s, E_star) => {
  return math.where((a > 0.0), (_force_of_gaussian(a, h, s, E_star) / (Math.PI * Math.pow(a, 2))), 0.0);
};

const _mean_pressure = (a, h, s, E_star) => {
  let node, v10, v12, v13, v51, v68, v75, v76, v82, v9, weight;
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (s > 1e-30) && (s < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((a > 0.0)) {
      if ((a <= (1.5019752682686114 * s))) {
        v12 = ((2.0 * h) / s);
        v76 = [];
        for ([node, weight] of RULE_0_of_gaussian((a / 1.0))) {
          v9 = (node * a);
          v10 = (v9 / s);
          v13 = (v10 * v10);
          v51 = (((((((((((((((((((((((((1.567077144036674e-13 * v13) + (-3.840375691006307e-12)) * v13) + 3.8015754128174666e-11) * v13) + (-1.8423006918213799e-10)) * v13) + 4.472469827763728e-10) * v13) + (-1.1927516362741588e-09)) * v13) + 6.225892246861416e-09) * v13) + 3.4413148480148793e-09) * v13) + (-9.933344851449817e-08)) * v13) + (-5.127541706569233e-07)) * v13) + 1.8119768160503268e-06) * v13) + 2.151585040783394e-05) * v13) + 4.61098799999374e-06) * v13);
          v68 = (v10 / (((((((((((v51 + (-0.000684089638073553)) * v13) + (-0.002257495580553435)) * v13) + 0.016931216930225715) * v13) + 0.17777777777782838) * v13) + 0.6666666666666656) * v13) + 1.0));
          v75 = (v9 * (v12 * (v68 + ((1.0 - ((2.0 * v68) * v10)) * v10))));
          v76.push((weight * v75));
        }
        v76 = (math.fsum(v76) * a);
        v82 = ((2.0 * E_star) * v76);
      } else {
        v82 = NaN;
      }
      return (v82 / (3.141592653589793 * (a * a)));
    }
    return 0.0;
  }
  return _mean_pressure_of_gaussian(a, h, s, E_star);
};

const mean_pressure = (a, h, s, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure(a, h, s, E_star) : NaN);
};

const RULE_1 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _depth_of_gaussian = (a, h, s) => {
  let z;
  z = (a / s);
  return math.where((a <= (1.5019752682686114 * s)), (((2 * h) * dawson(z)) * z), NaN);
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

const _energy_of_gaussian = (a, h, s, E_star) => {
  let sunk, tip;
  sunk = _depth_of_gaussian(a, h, s);
  tip = energy_integral(_depth_of_gaussian, [h, s], a, sunk, a);
  return math.where((a <= (1.5019752682686114 * s)), (E_star * tip), NaN);
};

const _energy = (a, h, s, E_star) => {
  let node, v10, v118, v133, v134, v136, v140, v141, v4, v48, v6, v7, v70, v72, v77, v80, v81, v9, v90, v91, v93, weight;
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (s > 1e-30) && (s < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v6 = (1.5019752682686114 * s);
    v7 = (a <= v6);
    if (v7) {
      v9 = (2.0 * h);
      if (v7) {
        v4 = (a / s);
        v10 = (v4 * v4);
        v48 = (((((((((((((((((((((((((1.567077144036674e-13 * v10) + (-3.840375691006307e-12)) * v10) + 3.8015754128174666e-11) * v10) + (-1.8423006918213799e-10)) * v10) + 4.472469827763728e-10) * v10) + (-1.1927516362741588e-09)) * v10) + 6.225892246861416e-09) * v10) + 3.4413148480148793e-09) * v10) + (-9.933344851449817e-08)) * v10) + (-5.127541706569233e-07)) * v10) + 1.8119768160503268e-06) * v10) + 2.151585040783394e-05) * v10) + 4.61098799999374e-06) * v10);
        v70 = ((v9 * (v4 / (((((((((((v48 + (-0.000684089638073553)) * v10) + (-0.002257495580553435)) * v10) + 0.016931216930225715) * v10) + 0.17777777777782838) * v10) + 0.6666666666666656) * v10) + 1.0))) * v4);
      } else {
        v70 = NaN;
      }
      v72 = Math.asinh((a / a));
      v77 = (0.0 - Math.expm1(((-2.0) * v72)));
      v80 = ((v77 > 0.0) ? v77 : Infinity);
      v136 = (a * a);
      v141 = [];
      for ([node, weight] of RULE_1((v72 / 1.0))) {
        v81 = (node * v72);
        v90 = (a * ((Math.exp((-v81)) * (0.0 - Math.expm1(((-2.0) * (v72 - v81))))) / v80));
        if ((v90 <= v6)) {
          v91 = (v90 / s);
          v93 = (v91 * v91);
          v118 = (((((((((((((((((((((((((1.567077144036674e-13 * v93) + (-3.840375691006307e-12)) * v93) + 3.8015754128174666e-11) * v93) + (-1.8423006918213799e-10)) * v93) + 4.472469827763728e-10) * v93) + (-1.1927516362741588e-09)) * v93) + 6.225892246861416e-09) * v93) + 3.4413148480148793e-09) * v93) + (-9.933344851449817e-08)) * v93) + (-5.127541706569233e-07)) * v93) + 1.8119768160503268e-06) * v93) + 2.151585040783394e-05) * v93) + 4.61098799999374e-06) * v93);
          v133 = ((v9 * (v91 / (((((((((((v118 + (-0.000684089638073553)) * v93) + (-0.002257495580553435)) * v93) + 0.016931216930225715) * v93) + 0.17777777777782838) * v93) + 0.6666666666666656) * v93) + 1.0))) * v91);
        } else {
          v133 = NaN;
        }
        v134 = (v70 - v133);
        v140 = ((v134 * v134) * Math.sqrt((v136 + (v90 * v90))));
        v141.push((weight * v140));
      }
      v141 = (math.fsum(v141) * v72);
      return (E_star * v141);
    }
    return NaN;
  }
  return _energy_of_gaussian(a, h, s, E_star);
};

const energy = (a, h, s, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _energy(a, h, s, E_star) : NaN);
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

const _load_within_of_gaussian = (r, a, h, s, E_star) => {
  let tip;
  tip = load_within_integral(_slope, [h, s], math.minimum(r, a), a);
  return math.where((a <= (1.5019752682686114 * s)), (_force_of_gaussian(math.minimum(r, a), h, s, E_star) + ((2 * E_star) * tip)), NaN);
};

const _load_within = (r, a, h, s, E_star) => {
  let node, v105, v106, v108, v11, v110, v112, v113, v114, v115, v13, v140, v152, v159, v160, v164, v18, v21, v22, v24, v33, v36, v37, v40, v41, v5, v6, v79, v96, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (s > 1e-30) && (s < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v110 = (1.5019752682686114 * s);
    if ((a <= v110)) {
      v5 = (((r < a) || (r !== r)) ? r : a);
      v40 = ((2.0 * h) / s);
      if ((v5 > 0.0)) {
        v6 = (a - v5);
        v11 = Math.sqrt(((((v6 > 0.0) || (v6 !== v6)) ? v6 : 0.0) * (a + v5)));
        v13 = Math.asinh((v11 / v5));
        v18 = (0.0 - Math.expm1(((-2.0) * v13)));
        v21 = ((v18 > 0.0) ? v18 : Infinity);
        v22 = (v5 * v5);
        v106 = [];
        for ([node, weight] of RULE_1((v13 / 1.0))) {
          v24 = (node * v13);
          v33 = (v11 * ((Math.exp((-v24)) * (0.0 - Math.expm1(((-2.0) * (v13 - v24))))) / v21));
          v36 = Math.sqrt((v22 + (v33 * v33)));
          v37 = (v36 / s);
          v41 = (v37 * v37);
          v79 = (((((((((((((((((((((((((1.567077144036674e-13 * v41) + (-3.840375691006307e-12)) * v41) + 3.8015754128174666e-11) * v41) + (-1.8423006918213799e-10)) * v41) + 4.472469827763728e-10) * v41) + (-1.1927516362741588e-09)) * v41) + 6.225892246861416e-09) * v41) + 3.4413148480148793e-09) * v41) + (-9.933344851449817e-08)) * v41) + (-5.127541706569233e-07)) * v41) + 1.8119768160503268e-06) * v41) + 2.151585040783394e-05) * v41) + 4.61098799999374e-06) * v41);
          v96 = (v37 / (((((((((((v79 + (-0.000684089638073553)) * v41) + (-0.002257495580553435)) * v41) + 0.016931216930225715) * v41) + 0.17777777777782838) * v41) + 0.6666666666666656) * v41) + 1.0));
          v105 = ((v40 * (v96 + ((1.0 - ((2.0 * v96) * v37)) * v37))) * (v33 / (v36 + v33)));
          v106.push((weight * v105));
        }
        v106 = (math.fsum(v106) * v13);
        v108 = (v22 * v106);
      } else {
        v108 = 0.0;
      }
      v112 = (2.0 * E_star);
      if ((v5 <= v110)) {
        v160 = [];
        for ([node, weight] of RULE_0_of_gaussian((v5 / 1.0))) {
          v113 = (node * v5);
          v114 = (v113 / s);
          v115 = (v114 * v114);
          v140 = (((((((((((((((((((((((((1.567077144036674e-13 * v115) + (-3.840375691006307e-12)) * v115) + 3.8015754128174666e-11) * v115) + (-1.8423006918213799e-10)) * v115) + 4.472469827763728e-10) * v115) + (-1.1927516362741588e-09)) * v115) + 6.225892246861416e-09) * v115) + 3.4413148480148793e-09) * v115) + (-9.933344851449817e-08)) * v115) + (-5.127541706569233e-07)) * v115) + 1.8119768160503268e-06) * v115) + 2.151585040783394e-05) * v115) + 4.61098799999374e-06) * v115);
          v152 = (v114 / (((((((((((v140 + (-0.000684089638073553)) * v115) + (-0.002257495580553435)) * v115) + 0.016931216930225715) * v115) + 0.17777777777782838) * v115) + 0.6666666666666656) * v115) + 1.0));
          v159 = (v113 * (v40 * (v152 + ((1.0 - ((2.0 * v152) * v114)) * v114))));
          v160.push((weight * v159));
        }
        v160 = (math.fsum(v160) * v5);
        v164 = (v112 * v160);
      } else {
        v164 = NaN;
      }
      return (v164 + (v112 * v108));
    }
    return NaN;
  }
  return _load_within_of_gaussian(r, a, h, s, E_star);
};

const load_within = (r, a, h, s, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _load_within(r, a, h, s, E_star) : 0.0) : NaN);
};

const _peak_pressure_of_gaussian = (a, h, s, E_star) => {
  return _pressure_of_gaussian(math.zeros_like(a), a, h, s, E_star);
};

const _peak_pressure = (a, h, s, E_star) => {
  let node, v11, v14, v15, v18, v19, v5, v57, v74, v81, v82, v9, weight;
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (s > 1e-30) && (s < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((a <= (1.5019752682686114 * s))) {
      if ((0.0 < a)) {
        v5 = (a - 0.0);
        v9 = Math.sqrt(((((v5 > 0.0) || (v5 !== v5)) ? v5 : 0.0) * (a + 0.0)));
        v18 = ((2.0 * h) / s);
        v82 = [];
        for ([node, weight] of RULE_0_of_gaussian((v9 / 1.0))) {
          v11 = (node * v9);
          v14 = Math.sqrt((0.0 + (v11 * v11)));
          v15 = (v14 / s);
          v19 = (v15 * v15);
          v57 = (((((((((((((((((((((((((1.567077144036674e-13 * v19) + (-3.840375691006307e-12)) * v19) + 3.8015754128174666e-11) * v19) + (-1.8423006918213799e-10)) * v19) + 4.472469827763728e-10) * v19) + (-1.1927516362741588e-09)) * v19) + 6.225892246861416e-09) * v19) + 3.4413148480148793e-09) * v19) + (-9.933344851449817e-08)) * v19) + (-5.127541706569233e-07)) * v19) + 1.8119768160503268e-06) * v19) + 2.151585040783394e-05) * v19) + 4.61098799999374e-06) * v19);
          v74 = (v15 / (((((((((((v57 + (-0.000684089638073553)) * v19) + (-0.002257495580553435)) * v19) + 0.016931216930225715) * v19) + 0.17777777777782838) * v19) + 0.6666666666666656) * v19) + 1.0));
          v81 = ((v18 * (v74 + ((1.0 - ((2.0 * v74) * v15)) * v15))) / v14);
          v82.push((weight * v81));
        }
        v82 = (math.fsum(v82) * v9);
        return ((E_star / 3.141592653589793) * v82);
      }
      return 0.0;
    }
    return NaN;
  }
  return _peak_pressure_of_gaussian(a, h, s, E_star);
};

const _peak_radius_of_gaussian = (a, s) => {
  return math.where((a <= (1.5019752682686114 * s)), 0.0, NaN);
};

const _peak_radius = (a, s, h = 1.0, E_star = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (s > 1e-30) && (s < 1e+30) && (h > 1e-30) && (h < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((a <= (1.5019752682686114 * s))) {
      return 0.0;
    }
    return NaN;
  }
  return _peak_radius_of_gaussian(a, s);
};

const PeakPressure = (pressure, radius) => math.record({ pressure, radius });

const peak_pressure = (a, h, s, E_star) => {
  let pressure, radius;
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  pressure = ((a >= 0.0) ? _peak_pressure(a, h, s, E_star) : NaN);
  radius = ((a >= 0.0) ? _peak_radius(a, s) : NaN);
  return PeakPressure(pressure, radius);
};

const _slope_of_gaussian = (t, h, s) => {
  let v3, v45, v63, v7;
  v3 = (t / s);
  v7 = (v3 * v3);
  v45 = (((((((((((((((((((((((((1.567077144036674e-13 * v7) + (-3.840375691006307e-12)) * v7) + 3.8015754128174666e-11) * v7) + (-1.8423006918213799e-10)) * v7) + 4.472469827763728e-10) * v7) + (-1.1927516362741588e-09)) * v7) + 6.225892246861416e-09) * v7) + 3.4413148480148793e-09) * v7) + (-9.933344851449817e-08)) * v7) + (-5.127541706569233e-07)) * v7) + 1.8119768160503268e-06) * v7) + 2.151585040783394e-05) * v7) + 4.61098799999374e-06) * v7);
  v63 = (v3 / (((((((((((v45 + (-0.000684089638073553)) * v7) + (-0.002257495580553435)) * v7) + 0.016931216930225715) * v7) + 0.17777777777782838) * v7) + 0.6666666666666656) * v7) + 1.0));
  return (((2.0 * h) / s) * (v63 + ((1.0 - ((2.0 * v63) * v3)) * v3)));
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

const inverse_below = (curve, value, largest, exponents, like = Math.sqrt) => {
  let noise, s, short, shortfall, t, top;
  top = curve(largest)[0];
  shortfall = (s) => {
    let short, slope, t, y;
    t = (largest / (1.0 + s));
    [y, slope] = curve(t);
    short = ((top - y) / y);
    return above_noise(short, (((s / (1.0 + s)) * slope) * (1.0 + short)), (1.0 + short), 2.0, exponents[0]);
  };
  short = math.maximum(((top - value) / value), 0.0);
  noise = ((4.0 * ROUNDING) * (1.0 + short));
  s = inverse(shortfall, short, like(short), exponents, undefined, undefined, true, noise);
  t = (largest / (1.0 + s));
  return ((value <= (top * (1.0 + Math.pow(2.0, (-48))))) ? t : NaN);
};

const _radius_from_depth = (d, h, s) => {
  let curve, largest, like;
  curve = (a) => {
    let value;
    value = _depth(a, h, s);
    return [value, ((a * _slope_of_gaussian(a, h, s)) / value)];
  };
  like = (short) => {
    let rest;
    rest = [1.003776, 0.2435676, 0.7000671, (-0.6766533), 4.031949, (-6.599278), 3.971419, (-0.793611)];
    return between(Math.log((short / 0.6348098)), [1.575, 2.0], [0.4486, 2.0], (-6.0), rest);
  };
  largest = ((1.5019752682686114 * s) * math.ones_like(d));
  return inverse_below(curve, d, largest, [1.0, 2.0], like);
};

const radius_from_depth = (d, h, s) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth(d, h, s) : NaN);
};

const _radius_from_force = (F, h, s, E_star) => {
  let curve, largest, like;
  curve = (a) => {
    let value;
    value = _force(a, h, s, E_star);
    return [value, ((((2 * E_star) * Math.pow(a, 2)) * _slope_of_gaussian(a, h, s)) / value)];
  };
  like = (short) => {
    let rest;
    rest = [0.9994039, 0.6765872, (-1.514105), 16.18697, (-61.13223), 108.1267, (-95.20743), 32.86326];
    return between(Math.log((short / 1.360193)), [1.659, 2.0], [0.1392, 3.0], (-6.0), rest);
  };
  largest = ((1.5019752682686114 * s) * math.ones_like(F));
  return inverse_below(curve, F, largest, [1.0, 3.0], like);
};

const radius_from_force = (F, h, s, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _radius_from_force(F, h, s, E_star) : NaN);
};

const _force_from_depth = (d, h, s, E_star) => {
  let a, change;
  a = _radius_from_depth(d, h, s);
  change = (((a > 0.0) & (a < Infinity)) ? (((2 * E_star) * a) * (d - _depth(a, h, s))) : 0.0);
  return (_force(a, h, s, E_star) + change);
};

const force_from_depth = (d, h, s, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth(d, h, s, E_star) : NaN);
};

const _depth_from_force = (F, h, s, E_star) => {
  let a, change;
  a = _radius_from_force(F, h, s, E_star);
  change = (((a > 0.0) & (a < Infinity)) ? ((F - _force(a, h, s, E_star)) / ((2 * E_star) * a)) : 0.0);
  return (_depth(a, h, s) + change);
};

const depth_from_force = (F, h, s, E_star) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force(F, h, s, E_star) : NaN);
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

const _depth_2 = (a, h, s, E_star, dgamma) => {
  let v11, v49, v5, v71;
  if ((a <= (1.5019752682686114 * s))) {
    v5 = (a / s);
    v11 = (v5 * v5);
    v49 = (((((((((((((((((((((((((1.567077144036674e-13 * v11) + (-3.840375691006307e-12)) * v11) + 3.8015754128174666e-11) * v11) + (-1.8423006918213799e-10)) * v11) + 4.472469827763728e-10) * v11) + (-1.1927516362741588e-09)) * v11) + 6.225892246861416e-09) * v11) + 3.4413148480148793e-09) * v11) + (-9.933344851449817e-08)) * v11) + (-5.127541706569233e-07)) * v11) + 1.8119768160503268e-06) * v11) + 2.151585040783394e-05) * v11) + 4.61098799999374e-06) * v11);
    v71 = (((2.0 * h) * (v5 / (((((((((((v49 + (-0.000684089638073553)) * v11) + (-0.002257495580553435)) * v11) + 0.016931216930225715) * v11) + 0.17777777777782838) * v11) + 0.6666666666666656) * v11) + 1.0))) * v5);
  } else {
    v71 = NaN;
  }
  return (v71 - (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const depth_of_gaussian = (a, h, s, E_star, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_2(a, h, s, E_star, dgamma) : NaN);
};

const RULE_0_2 = math.rule([[Infinity, 32]]);

const _force_2 = (a, h, s, E_star, dgamma) => {
  let node, v11, v12, v50, v6, v67, v74, v75, v8, v81, v9, weight;
  v6 = (2.0 * E_star);
  if ((a <= (1.5019752682686114 * s))) {
    v11 = ((2.0 * h) / s);
    v75 = [];
    for ([node, weight] of RULE_0_2((a / 1.0))) {
      v8 = (node * a);
      v9 = (v8 / s);
      v12 = (v9 * v9);
      v50 = (((((((((((((((((((((((((1.567077144036674e-13 * v12) + (-3.840375691006307e-12)) * v12) + 3.8015754128174666e-11) * v12) + (-1.8423006918213799e-10)) * v12) + 4.472469827763728e-10) * v12) + (-1.1927516362741588e-09)) * v12) + 6.225892246861416e-09) * v12) + 3.4413148480148793e-09) * v12) + (-9.933344851449817e-08)) * v12) + (-5.127541706569233e-07)) * v12) + 1.8119768160503268e-06) * v12) + 2.151585040783394e-05) * v12) + 4.61098799999374e-06) * v12);
      v67 = (v9 / (((((((((((v50 + (-0.000684089638073553)) * v12) + (-0.002257495580553435)) * v12) + 0.016931216930225715) * v12) + 0.17777777777782838) * v12) + 0.6666666666666656) * v12) + 1.0));
      v74 = (v8 * (v11 * (v67 + ((1.0 - ((2.0 * v67) * v9)) * v9))));
      v75.push((weight * v74));
    }
    v75 = (math.fsum(v75) * a);
    v81 = (v6 * v75);
  } else {
    v81 = NaN;
  }
  return (v81 - ((v6 * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star)))));
};

const force_of_gaussian = (a, h, s, E_star, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_2(a, h, s, E_star, dgamma) : NaN);
};

const RULE_0_3 = math.rule([[Infinity, 32]]);

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

const _pressure_3 = (r, a, h, s, E_star, dgamma) => {
  return (_pressure_of_gaussian(r, a, h, s, E_star) - tension(r, a, E_star, dgamma));
};

const _pressure_2 = (r, a, h, s, E_star, dgamma) => {
  let node, v101, v108, v11, v13, v14, v17, v18, v21, v22, v6, v60, v77, v84, v85, v90, v95, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (s > 1e-30) && (s < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v6 = (a - r);
    v11 = Math.sqrt(((((v6 > 0.0) || (v6 !== v6)) ? v6 : 0.0) * (a + r)));
    if ((a <= (1.5019752682686114 * s))) {
      if ((r < a)) {
        v14 = (r * r);
        v21 = ((2.0 * h) / s);
        v85 = [];
        for ([node, weight] of RULE_0_3((v11 / 1.0))) {
          v13 = (node * v11);
          v17 = Math.sqrt((v14 + (v13 * v13)));
          v18 = (v17 / s);
          v22 = (v18 * v18);
          v60 = (((((((((((((((((((((((((1.567077144036674e-13 * v22) + (-3.840375691006307e-12)) * v22) + 3.8015754128174666e-11) * v22) + (-1.8423006918213799e-10)) * v22) + 4.472469827763728e-10) * v22) + (-1.1927516362741588e-09)) * v22) + 6.225892246861416e-09) * v22) + 3.4413148480148793e-09) * v22) + (-9.933344851449817e-08)) * v22) + (-5.127541706569233e-07)) * v22) + 1.8119768160503268e-06) * v22) + 2.151585040783394e-05) * v22) + 4.61098799999374e-06) * v22);
          v77 = (v18 / (((((((((((v60 + (-0.000684089638073553)) * v22) + (-0.002257495580553435)) * v22) + 0.016931216930225715) * v22) + 0.17777777777782838) * v22) + 0.6666666666666656) * v22) + 1.0));
          v84 = ((v21 * (v77 + ((1.0 - ((2.0 * v77) * v18)) * v18))) / v17);
          v85.push((weight * v84));
        }
        v85 = (math.fsum(v85) * v11);
        v90 = ((E_star / 3.141592653589793) * v85);
      } else {
        v90 = 0.0;
      }
      v95 = v90;
    } else {
      v95 = NaN;
    }
    if ((r <= a)) {
      v101 = (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star)));
      v108 = ((v101 > 0.0) ? ((E_star * v101) / (3.141592653589793 * v11)) : 0.0);
    } else {
      v108 = 0.0;
    }
    return (v95 - v108);
  }
  return _pressure_3(r, a, h, s, E_star, dgamma);
};

const pressure_of_gaussian = (r, a, h, s, E_star, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_2(r, a, h, s, E_star, dgamma) : 0.0) : NaN);
};

const displacement_integral = (slope, parameters, r, a, count) => {
  let integrand;
  integrand = (angle) => {
    return ((slope((r * Math.sin(angle)), ...parameters) * angle) * Math.cos(angle));
  };
  return (r * math.integral(integrand, Math.atan2(a, difference_root(r, a)), count));
};

const _profile = (r, h, s) => {
  return ((-h) * Math.expm1(((-Math.pow(r, 2)) / Math.pow(s, 2))));
};

const _displacement_3 = (r, a, h, s) => {
  let inside, outside, tip;
  tip = displacement_integral(_slope, [h, s], r, a, 32);
  outside = ((2 / Math.PI) * tip);
  inside = (_depth_of_gaussian(a, h, s) - _profile(r, h, s));
  return math.where((a <= (1.5019752682686114 * s)), math.where((r > a), outside, inside), NaN);
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

const _displacement_2 = (r, a, h, s, E_star, dgamma) => {
  return (_displacement_3(r, a, h, s) - lift(r, a, E_star, dgamma));
};

const _displacement_of_gaussian = (r, a, h, s, E_star, dgamma) => {
  let node, v119, v12, v135, v14, v144, v145, v146, v17, v19, v20, v21, v59, v6, v76, v85, v86, v90, v93, v94, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (s > 1e-30) && (s < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v6 = (r - a);
    v12 = Math.atan2(a, Math.sqrt(((((v6 > 0.0) || (v6 !== v6)) ? v6 : 0.0) * (r + a))));
    v93 = (a <= (1.5019752682686114 * s));
    v144 = (r > a);
    if (v93) {
      v19 = (2.0 * h);
      if (v144) {
        v20 = (v19 / s);
        v86 = [];
        for ([node, weight] of RULE_0_3((v12 / 1.0))) {
          v14 = (node * v12);
          v17 = ((r * Math.sin(v14)) / s);
          v21 = (v17 * v17);
          v59 = (((((((((((((((((((((((((1.567077144036674e-13 * v21) + (-3.840375691006307e-12)) * v21) + 3.8015754128174666e-11) * v21) + (-1.8423006918213799e-10)) * v21) + 4.472469827763728e-10) * v21) + (-1.1927516362741588e-09)) * v21) + 6.225892246861416e-09) * v21) + 3.4413148480148793e-09) * v21) + (-9.933344851449817e-08)) * v21) + (-5.127541706569233e-07)) * v21) + 1.8119768160503268e-06) * v21) + 2.151585040783394e-05) * v21) + 4.61098799999374e-06) * v21);
          v76 = (v17 / (((((((((((v59 + (-0.000684089638073553)) * v21) + (-0.002257495580553435)) * v21) + 0.016931216930225715) * v21) + 0.17777777777782838) * v21) + 0.6666666666666656) * v21) + 1.0));
          v85 = (((v20 * (v76 + ((1.0 - ((2.0 * v76) * v17)) * v17))) * v14) * Math.cos(v14));
          v86.push((weight * v85));
        }
        v86 = (math.fsum(v86) * v12);
        v145 = (0.6366197723675814 * (r * v86));
      } else {
        if (v93) {
          v90 = (a / s);
          v94 = (v90 * v90);
          v119 = (((((((((((((((((((((((((1.567077144036674e-13 * v94) + (-3.840375691006307e-12)) * v94) + 3.8015754128174666e-11) * v94) + (-1.8423006918213799e-10)) * v94) + 4.472469827763728e-10) * v94) + (-1.1927516362741588e-09)) * v94) + 6.225892246861416e-09) * v94) + 3.4413148480148793e-09) * v94) + (-9.933344851449817e-08)) * v94) + (-5.127541706569233e-07)) * v94) + 1.8119768160503268e-06) * v94) + 2.151585040783394e-05) * v94) + 4.61098799999374e-06) * v94);
          v135 = ((v19 * (v90 / (((((((((((v119 + (-0.000684089638073553)) * v94) + (-0.002257495580553435)) * v94) + 0.016931216930225715) * v94) + 0.17777777777782838) * v94) + 0.6666666666666656) * v94) + 1.0))) * v90);
        } else {
          v135 = NaN;
        }
        v145 = (v135 - ((-h) * Math.expm1(((-(r * r)) / (s * s)))));
      }
      v146 = v145;
    } else {
      v146 = NaN;
    }
    return (v146 - ((Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))) * (math.truth(v144) ? (0.6366197723675814 * v12) : 1.0)));
  }
  return _displacement_2(r, a, h, s, E_star, dgamma);
};

const displacement_of_gaussian = (r, a, h, s, E_star, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_of_gaussian(r, a, h, s, E_star, dgamma) : 0.0) : NaN);
};

const exponent_of = (x) => {
  return (math.frexp(x)[1] - 1);
};

const _rate = (a, h, s) => {
  let v3, v45, v63, v7;
  v3 = (a / s);
  v7 = (v3 * v3);
  v45 = (((((((((((((((((((((((((1.567077144036674e-13 * v7) + (-3.840375691006307e-12)) * v7) + 3.8015754128174666e-11) * v7) + (-1.8423006918213799e-10)) * v7) + 4.472469827763728e-10) * v7) + (-1.1927516362741588e-09)) * v7) + 6.225892246861416e-09) * v7) + 3.4413148480148793e-09) * v7) + (-9.933344851449817e-08)) * v7) + (-5.127541706569233e-07)) * v7) + 1.8119768160503268e-06) * v7) + 2.151585040783394e-05) * v7) + 4.61098799999374e-06) * v7);
  v63 = (v3 / (((((((((((v45 + (-0.000684089638073553)) * v7) + (-0.002257495580553435)) * v7) + 0.016931216930225715) * v7) + 0.17777777777782838) * v7) + 0.6666666666666656) * v7) + 1.0));
  return (((2.0 * h) / s) * (v63 + ((1.0 - ((2.0 * v63) * v3)) * v3)));
};

const radii_to = (length = 1.0) => [1e-150, 1e-140, 1e-130, 1e-120, 1e-110, 1e-100, 1e-90, 1e-80, 1e-70, 1e-60, 1e-50, 1e-40, 1e-30, 1e-20, 1e-10, 0.0078125, 0.015625, 0.0234375, 0.03125, 0.0390625, 0.046875, 0.0546875, 0.0625, 0.0703125, 0.078125, 0.0859375, 0.09375, 0.1015625, 0.109375, 0.1171875, 0.125, 0.1328125, 0.140625, 0.1484375, 0.15625, 0.1640625, 0.171875, 0.1796875, 0.1875, 0.1953125, 0.203125, 0.2109375, 0.21875, 0.2265625, 0.234375, 0.2421875, 0.25, 0.2578125, 0.265625, 0.2734375, 0.28125, 0.2890625, 0.296875, 0.3046875, 0.3125, 0.3203125, 0.328125, 0.3359375, 0.34375, 0.3515625, 0.359375, 0.3671875, 0.375, 0.3828125, 0.390625, 0.3984375, 0.40625, 0.4140625, 0.421875, 0.4296875, 0.4375, 0.4453125, 0.453125, 0.4609375, 0.46875, 0.4765625, 0.484375, 0.4921875, 0.5, 0.5078125, 0.515625, 0.5234375, 0.53125, 0.5390625, 0.546875, 0.5546875, 0.5625, 0.5703125, 0.578125, 0.5859375, 0.59375, 0.6015625, 0.609375, 0.6171875, 0.625, 0.6328125, 0.640625, 0.6484375, 0.65625, 0.6640625, 0.671875, 0.6796875, 0.6875, 0.6953125, 0.703125, 0.7109375, 0.71875, 0.7265625, 0.734375, 0.7421875, 0.75, 0.7578125, 0.765625, 0.7734375, 0.78125, 0.7890625, 0.796875, 0.8046875, 0.8125, 0.8203125, 0.828125, 0.8359375, 0.84375, 0.8515625, 0.859375, 0.8671875, 0.875, 0.8828125, 0.890625, 0.8984375, 0.90625, 0.9140625, 0.921875, 0.9296875, 0.9375, 0.9453125, 0.953125, 0.9609375, 0.96875, 0.9765625, 0.984375, 0.9921875, 1.0].map((x) => x * length);

const _samples = (h, s) => {
  let a;
  a = radii_to((1.5019752682686114 * s));
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

const _branches = (h, s, E_star, dgamma, control) => {
  return branches(((a) => (Math.sqrt(a) * _rate(a, h, s))), _samples(h, s), least_steepness(control, E_star, dgamma));
};

const XI_of_stable = {'force': 3.0, 'depth': 1.0};

const growth = (slope, a, control, E_star, dgamma) => {
  let own;
  own = (slope - ((XI_of_stable[control] * hess_retraction(a, E_star, dgamma)) / (2.0 * a)));
  return ((control === 'force') ? (((2.0 * E_star) * a) * own) : own);
};

const Unknown = (of, back, end = Infinity, order = 2.0, unit = 0.0) => math.record({ of, back, end, order, unit });

const on_the_bump = (s) => {
  let back;
  back = (x) => {
    let ratio;
    ratio = Math.sqrt((-Math.log1p((-x))));
    return [(s * ratio), (s / ((2.0 * ratio) * (1.0 - x)))];
  };
  return Unknown(((a) => (-Math.expm1((-Math.pow((a / s), 2))))), back);
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
  noise = ((NOISE * parts) * (math.truth(ends) ? ((1.0 + wanted) / short) : 1.0));
  t = inverse(excess, wanted, start, [SLACK, Infinity], largest, share, true, noise);
  a = place(t)[0];
  return (((value === Infinity) & (high === Infinity)) ? Infinity : (Number.isFinite(least) ? a : NaN));
};

const _radius_from_depth_of_gaussian = (d, h, s, E_star, dgamma) => {
  let found, radius, stress, unit;
  unit = exponent_of(s);
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  h = math.ldexp(h, (-unit));
  s = math.ldexp(s, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  d = math.ldexp(d, (-unit));
  found = _branches(h, s, E_star, dgamma, 'depth');
  radius = stable_radius(d, found, ((a) => _depth_2(a, h, s, E_star, dgamma)), ((a) => growth(_rate(a, h, s), a, 'depth', E_star, dgamma)), ((a) => hess_retraction(a, E_star, dgamma)), on_the_bump(s));
  return math.ldexp(radius, unit);
};

const radius_from_depth_of_gaussian = (d, h, s, E_star, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_depth_of_gaussian(d, h, s, E_star, dgamma);
};

const pull = (a, E_star, dgamma) => {
  return (((2.0 * E_star) * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const _radius_from_force_of_gaussian = (F, h, s, E_star, dgamma) => {
  let found, radius, stress, unit;
  unit = exponent_of(s);
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  h = math.ldexp(h, (-unit));
  s = math.ldexp(s, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  F = math.ldexp(F, (-(stress + (2 * unit))));
  found = _branches(h, s, E_star, dgamma, 'force');
  radius = stable_radius(F, found, ((a) => _force_2(a, h, s, E_star, dgamma)), ((a) => growth(_rate(a, h, s), a, 'force', E_star, dgamma)), ((a) => pull(a, E_star, dgamma)), on_the_bump(s));
  return math.ldexp(radius, unit);
};

const radius_from_force_of_gaussian = (F, h, s, E_star, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_force_of_gaussian(F, h, s, E_star, dgamma);
};

const _pull_off_radius = (h, s, E_star, dgamma, control) => {
  let found, load, radius, stress, unit;
  unit = exponent_of(s);
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  h = math.ldexp(h, (-unit));
  s = math.ldexp(s, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  found = _branches(h, s, E_star, dgamma, control);
  load = ((control === 'force') ? _force_2 : _depth_2);
  radius = math.lowest(found, ((a) => load(a, h, s, E_star, dgamma)));
  return math.ldexp(radius, unit);
};

const PullOff = (radius, force, depth) => math.record({ radius, force, depth });

const pull_off = (control = 'force', h, s, E_star, dgamma) => {
  let depth, force, radius;
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  radius = _pull_off_radius(h, s, E_star, dgamma, control);
  force = ((radius >= 0.0) ? _force_2(radius, h, s, E_star, dgamma) : NaN);
  depth = ((radius >= 0.0) ? _depth_2(radius, h, s, E_star, dgamma) : NaN);
  return PullOff(radius, force, depth);
};

const RULE_1_of_gaussian = math.rule([[Infinity, 32]]);

const RULE_0_4 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

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

const _tangential_force_of_gaussian = (a, c, h, s, E_star, mu) => {
  let close, gain, sticking, whole;
  [whole, sticking] = [_force_of_gaussian(a, h, s, E_star), _force_of_gaussian(c, h, s, E_star)];
  close = (sticking >= (CLOSE * whole));
  gain = ((2.0 * E_star) * growth_of_slip(_slope, [h, s], 2, 0.0, c, a, close));
  return (mu * math.where(close, gain, (whole - sticking)));
};

const _tangential_force = (a, c, h, s, E_star, mu) => {
  let node, v10, v110, v12, v122, v129, v13, v130, v133, v136, v138, v142, v143, v144, v149, v154, v159, v160, v161, v166, v167, v168, v193, v205, v213, v214, v215, v218, v51, v68, v7, v75, v76, v79, v82, v83, v84, v85, v9, weight;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (h > 1e-30) && (h < 1e+30) && (s > 1e-30) && (s < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v7 = (2.0 * E_star);
    v12 = ((2.0 * h) / s);
    v79 = (1.5019752682686114 * s);
    if ((a <= v79)) {
      v76 = [];
      for ([node, weight] of RULE_1_of_gaussian((a / 1.0))) {
        v9 = (node * a);
        v10 = (v9 / s);
        v13 = (v10 * v10);
        v51 = (((((((((((((((((((((((((1.567077144036674e-13 * v13) + (-3.840375691006307e-12)) * v13) + 3.8015754128174666e-11) * v13) + (-1.8423006918213799e-10)) * v13) + 4.472469827763728e-10) * v13) + (-1.1927516362741588e-09)) * v13) + 6.225892246861416e-09) * v13) + 3.4413148480148793e-09) * v13) + (-9.933344851449817e-08)) * v13) + (-5.127541706569233e-07)) * v13) + 1.8119768160503268e-06) * v13) + 2.151585040783394e-05) * v13) + 4.61098799999374e-06) * v13);
        v68 = (v10 / (((((((((((v51 + (-0.000684089638073553)) * v13) + (-0.002257495580553435)) * v13) + 0.016931216930225715) * v13) + 0.17777777777782838) * v13) + 0.6666666666666656) * v13) + 1.0));
        v75 = (v9 * (v12 * (v68 + ((1.0 - ((2.0 * v68) * v10)) * v10))));
        v76.push((weight * v75));
      }
      v76 = (math.fsum(v76) * a);
      v82 = (v7 * v76);
    } else {
      v82 = NaN;
    }
    if ((c <= v79)) {
      v130 = [];
      for ([node, weight] of RULE_1_of_gaussian((c / 1.0))) {
        v83 = (node * c);
        v84 = (v83 / s);
        v85 = (v84 * v84);
        v110 = (((((((((((((((((((((((((1.567077144036674e-13 * v85) + (-3.840375691006307e-12)) * v85) + 3.8015754128174666e-11) * v85) + (-1.8423006918213799e-10)) * v85) + 4.472469827763728e-10) * v85) + (-1.1927516362741588e-09)) * v85) + 6.225892246861416e-09) * v85) + 3.4413148480148793e-09) * v85) + (-9.933344851449817e-08)) * v85) + (-5.127541706569233e-07)) * v85) + 1.8119768160503268e-06) * v85) + 2.151585040783394e-05) * v85) + 4.61098799999374e-06) * v85);
        v122 = (v84 / (((((((((((v110 + (-0.000684089638073553)) * v85) + (-0.002257495580553435)) * v85) + 0.016931216930225715) * v85) + 0.17777777777782838) * v85) + 0.6666666666666656) * v85) + 1.0));
        v129 = (v83 * (v12 * (v122 + ((1.0 - ((2.0 * v122) * v84)) * v84))));
        v130.push((weight * v129));
      }
      v130 = (math.fsum(v130) * c);
      v133 = (v7 * v130);
    } else {
      v133 = NaN;
    }
    v136 = (v133 >= (0.25 * v82));
    if (v136) {
      v149 = (a > c);
      v159 = (v136 && v149);
      if (v159) {
        v138 = (c - 0.0);
        v142 = Math.sqrt(((((v138 > 0.0) || (v138 !== v138)) ? v138 : 0.0) * (c + 0.0)));
        if (v159) {
          v143 = (a - c);
          if (v149) {
            v144 = (a - 0.0);
            v154 = ((v143 * (a + c)) / (Math.sqrt(((((v144 > 0.0) || (v144 !== v144)) ? v144 : 0.0) * (a + 0.0))) + v142));
          } else {
            v154 = 0.0;
          }
          v160 = Math.log1p(((v143 + v154) / (c + v142)));
        } else {
          v160 = 0.0;
        }
        v214 = [];
        for ([node, weight] of RULE_0_4((v160 / 1.0))) {
          v161 = (node * v160);
          v166 = ((c * Math.cosh(v161)) + (v142 * Math.sinh(v161)));
          v167 = (v166 / s);
          v168 = (v167 * v167);
          v193 = (((((((((((((((((((((((((1.567077144036674e-13 * v168) + (-3.840375691006307e-12)) * v168) + 3.8015754128174666e-11) * v168) + (-1.8423006918213799e-10)) * v168) + 4.472469827763728e-10) * v168) + (-1.1927516362741588e-09)) * v168) + 6.225892246861416e-09) * v168) + 3.4413148480148793e-09) * v168) + (-9.933344851449817e-08)) * v168) + (-5.127541706569233e-07)) * v168) + 1.8119768160503268e-06) * v168) + 2.151585040783394e-05) * v168) + 4.61098799999374e-06) * v168);
          v205 = (v167 / (((((((((((v193 + (-0.000684089638073553)) * v168) + (-0.002257495580553435)) * v168) + 0.016931216930225715) * v168) + 0.17777777777782838) * v168) + 0.6666666666666656) * v168) + 1.0));
          v213 = ((v12 * (v205 + ((1.0 - ((2.0 * v205) * v167)) * v167))) * (v166 * v166));
          v214.push((weight * v213));
        }
        v214 = (math.fsum(v214) * v160);
        v215 = v214;
      } else {
        v215 = 0.0;
      }
      v218 = (v7 * v215);
    } else {
      v218 = (v82 - v133);
    }
    return (mu * v218);
  }
  return _tangential_force_of_gaussian(a, c, h, s, E_star, mu);
};

const tangential_force = (a, c, h, s, E_star, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_force(a, c, h, s, E_star, mu) : NaN);
};

const _traction_of_gaussian = (r, a, c, h, s, E_star, mu) => {
  let close, gain, sliding, stuck;
  sliding = _pressure_of_gaussian(r, a, h, s, E_star);
  stuck = _pressure_of_gaussian(r, c, h, s, E_star);
  close = ((r < c) & (stuck >= (CLOSE * sliding)));
  gain = ((E_star / Math.PI) * growth_of_slip(_slope, [h, s], 0, r, c, a, close));
  return (mu * math.where(close, gain, (sliding - stuck)));
};

const _traction = (r, a, c, h, s, E_star, mu) => {
  let node, v101, v102, v105, v106, v107, v12, v132, v14, v144, v15, v151, v152, v153, v155, v157, v161, v162, v163, v173, v174, v175, v18, v180, v181, v182, v19, v207, v219, v22, v227, v228, v229, v23, v232, v61, v7, v78, v85, v86, v89, v91, v93, v96, v97, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (h > 1e-30) && (h < 1e+30) && (s > 1e-30) && (s < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v7 = (a - r);
    v12 = Math.sqrt(((((v7 > 0.0) || (v7 !== v7)) ? v7 : 0.0) * (a + r)));
    v15 = (r * r);
    v22 = ((2.0 * h) / s);
    v89 = (E_star / 3.141592653589793);
    v93 = (1.5019752682686114 * s);
    if ((a <= v93)) {
      if ((r < a)) {
        v86 = [];
        for ([node, weight] of RULE_1_of_gaussian((v12 / 1.0))) {
          v14 = (node * v12);
          v18 = Math.sqrt((v15 + (v14 * v14)));
          v19 = (v18 / s);
          v23 = (v19 * v19);
          v61 = (((((((((((((((((((((((((1.567077144036674e-13 * v23) + (-3.840375691006307e-12)) * v23) + 3.8015754128174666e-11) * v23) + (-1.8423006918213799e-10)) * v23) + 4.472469827763728e-10) * v23) + (-1.1927516362741588e-09)) * v23) + 6.225892246861416e-09) * v23) + 3.4413148480148793e-09) * v23) + (-9.933344851449817e-08)) * v23) + (-5.127541706569233e-07)) * v23) + 1.8119768160503268e-06) * v23) + 2.151585040783394e-05) * v23) + 4.61098799999374e-06) * v23);
          v78 = (v19 / (((((((((((v61 + (-0.000684089638073553)) * v23) + (-0.002257495580553435)) * v23) + 0.016931216930225715) * v23) + 0.17777777777782838) * v23) + 0.6666666666666656) * v23) + 1.0));
          v85 = ((v22 * (v78 + ((1.0 - ((2.0 * v78) * v19)) * v19))) / v18);
          v86.push((weight * v85));
        }
        v86 = (math.fsum(v86) * v12);
        v91 = (v89 * v86);
      } else {
        v91 = 0.0;
      }
      v96 = v91;
    } else {
      v96 = NaN;
    }
    v97 = (c - r);
    v101 = Math.sqrt(((((v97 > 0.0) || (v97 !== v97)) ? v97 : 0.0) * (c + r)));
    v153 = (r < c);
    if ((c <= v93)) {
      if (v153) {
        v152 = [];
        for ([node, weight] of RULE_1_of_gaussian((v101 / 1.0))) {
          v102 = (node * v101);
          v105 = Math.sqrt((v15 + (v102 * v102)));
          v106 = (v105 / s);
          v107 = (v106 * v106);
          v132 = (((((((((((((((((((((((((1.567077144036674e-13 * v107) + (-3.840375691006307e-12)) * v107) + 3.8015754128174666e-11) * v107) + (-1.8423006918213799e-10)) * v107) + 4.472469827763728e-10) * v107) + (-1.1927516362741588e-09)) * v107) + 6.225892246861416e-09) * v107) + 3.4413148480148793e-09) * v107) + (-9.933344851449817e-08)) * v107) + (-5.127541706569233e-07)) * v107) + 1.8119768160503268e-06) * v107) + 2.151585040783394e-05) * v107) + 4.61098799999374e-06) * v107);
          v144 = (v106 / (((((((((((v132 + (-0.000684089638073553)) * v107) + (-0.002257495580553435)) * v107) + 0.016931216930225715) * v107) + 0.17777777777782838) * v107) + 0.6666666666666656) * v107) + 1.0));
          v151 = ((v22 * (v144 + ((1.0 - ((2.0 * v144) * v106)) * v106))) / v105);
          v152.push((weight * v151));
        }
        v152 = (math.fsum(v152) * v101);
        v155 = (v89 * v152);
      } else {
        v155 = 0.0;
      }
      v157 = v155;
    } else {
      v157 = NaN;
    }
    v161 = (v153 && (v157 >= (0.25 * v96)));
    if (v161) {
      v163 = (a > c);
      v173 = (v161 && v163);
      if (v173) {
        if (v173) {
          v162 = (a - c);
          v174 = Math.log1p(((v162 + (math.truth(v163) ? ((v162 * (a + c)) / (v12 + v101)) : 0.0)) / (c + v101)));
        } else {
          v174 = 0.0;
        }
        v228 = [];
        for ([node, weight] of RULE_0_4((v174 / 1.0))) {
          v175 = (node * v174);
          v180 = ((c * Math.cosh(v175)) + (v101 * Math.sinh(v175)));
          v181 = (v180 / s);
          v182 = (v181 * v181);
          v207 = (((((((((((((((((((((((((1.567077144036674e-13 * v182) + (-3.840375691006307e-12)) * v182) + 3.8015754128174666e-11) * v182) + (-1.8423006918213799e-10)) * v182) + 4.472469827763728e-10) * v182) + (-1.1927516362741588e-09)) * v182) + 6.225892246861416e-09) * v182) + 3.4413148480148793e-09) * v182) + (-9.933344851449817e-08)) * v182) + (-5.127541706569233e-07)) * v182) + 1.8119768160503268e-06) * v182) + 2.151585040783394e-05) * v182) + 4.61098799999374e-06) * v182);
          v219 = (v181 / (((((((((((v207 + (-0.000684089638073553)) * v182) + (-0.002257495580553435)) * v182) + 0.016931216930225715) * v182) + 0.17777777777782838) * v182) + 0.6666666666666656) * v182) + 1.0));
          v227 = ((v22 * (v219 + ((1.0 - ((2.0 * v219) * v181)) * v181))) * Math.pow(v180, 0.0));
          v228.push((weight * v227));
        }
        v228 = (math.fsum(v228) * v174);
        v229 = v228;
      } else {
        v229 = 0.0;
      }
      v232 = (v89 * v229);
    } else {
      v232 = (v96 - v157);
    }
    return (mu * v232);
  }
  return _traction_of_gaussian(r, a, c, h, s, E_star, mu);
};

const traction = (r, a, c, h, s, E_star, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction(r, a, c, h, s, E_star, mu) : 0.0) : NaN);
};

const _tangential_displacement_of_gaussian = (a, c, h, s, E_star, G_star, mu) => {
  let close, gain, sticking, whole;
  [whole, sticking] = [_depth_of_gaussian(a, h, s), _depth_of_gaussian(c, h, s)];
  close = (sticking >= (CLOSE * whole));
  gain = growth_of_slip(_slope, [h, s], 1, 0.0, c, a, close);
  return ((mu * (E_star / G_star)) * math.where(close, gain, (whole - sticking)));
};

const _tangential_displacement = (a, c, h, s, E_star, G_star, mu) => {
  let node, v101, v116, v119, v12, v121, v125, v126, v127, v13, v132, v137, v142, v143, v144, v149, v150, v151, v152, v177, v189, v197, v198, v199, v203, v51, v7, v73, v74, v76, v9, weight;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (h > 1e-30) && (h < 1e+30) && (s > 1e-30) && (s < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v9 = (1.5019752682686114 * s);
    v12 = (2.0 * h);
    if ((a <= v9)) {
      v7 = (a / s);
      v13 = (v7 * v7);
      v51 = (((((((((((((((((((((((((1.567077144036674e-13 * v13) + (-3.840375691006307e-12)) * v13) + 3.8015754128174666e-11) * v13) + (-1.8423006918213799e-10)) * v13) + 4.472469827763728e-10) * v13) + (-1.1927516362741588e-09)) * v13) + 6.225892246861416e-09) * v13) + 3.4413148480148793e-09) * v13) + (-9.933344851449817e-08)) * v13) + (-5.127541706569233e-07)) * v13) + 1.8119768160503268e-06) * v13) + 2.151585040783394e-05) * v13) + 4.61098799999374e-06) * v13);
      v73 = ((v12 * (v7 / (((((((((((v51 + (-0.000684089638073553)) * v13) + (-0.002257495580553435)) * v13) + 0.016931216930225715) * v13) + 0.17777777777782838) * v13) + 0.6666666666666656) * v13) + 1.0))) * v7);
    } else {
      v73 = NaN;
    }
    if ((c <= v9)) {
      v74 = (c / s);
      v76 = (v74 * v74);
      v101 = (((((((((((((((((((((((((1.567077144036674e-13 * v76) + (-3.840375691006307e-12)) * v76) + 3.8015754128174666e-11) * v76) + (-1.8423006918213799e-10)) * v76) + 4.472469827763728e-10) * v76) + (-1.1927516362741588e-09)) * v76) + 6.225892246861416e-09) * v76) + 3.4413148480148793e-09) * v76) + (-9.933344851449817e-08)) * v76) + (-5.127541706569233e-07)) * v76) + 1.8119768160503268e-06) * v76) + 2.151585040783394e-05) * v76) + 4.61098799999374e-06) * v76);
      v116 = ((v12 * (v74 / (((((((((((v101 + (-0.000684089638073553)) * v76) + (-0.002257495580553435)) * v76) + 0.016931216930225715) * v76) + 0.17777777777782838) * v76) + 0.6666666666666656) * v76) + 1.0))) * v74);
    } else {
      v116 = NaN;
    }
    v119 = (v116 >= (0.25 * v73));
    if (v119) {
      v132 = (a > c);
      v142 = (v119 && v132);
      if (v142) {
        v121 = (c - 0.0);
        v125 = Math.sqrt(((((v121 > 0.0) || (v121 !== v121)) ? v121 : 0.0) * (c + 0.0)));
        if (v142) {
          v126 = (a - c);
          if (v132) {
            v127 = (a - 0.0);
            v137 = ((v126 * (a + c)) / (Math.sqrt(((((v127 > 0.0) || (v127 !== v127)) ? v127 : 0.0) * (a + 0.0))) + v125));
          } else {
            v137 = 0.0;
          }
          v143 = Math.log1p(((v126 + v137) / (c + v125)));
        } else {
          v143 = 0.0;
        }
        v151 = (v12 / s);
        v198 = [];
        for ([node, weight] of RULE_0_4((v143 / 1.0))) {
          v144 = (node * v143);
          v149 = ((c * Math.cosh(v144)) + (v125 * Math.sinh(v144)));
          v150 = (v149 / s);
          v152 = (v150 * v150);
          v177 = (((((((((((((((((((((((((1.567077144036674e-13 * v152) + (-3.840375691006307e-12)) * v152) + 3.8015754128174666e-11) * v152) + (-1.8423006918213799e-10)) * v152) + 4.472469827763728e-10) * v152) + (-1.1927516362741588e-09)) * v152) + 6.225892246861416e-09) * v152) + 3.4413148480148793e-09) * v152) + (-9.933344851449817e-08)) * v152) + (-5.127541706569233e-07)) * v152) + 1.8119768160503268e-06) * v152) + 2.151585040783394e-05) * v152) + 4.61098799999374e-06) * v152);
          v189 = (v150 / (((((((((((v177 + (-0.000684089638073553)) * v152) + (-0.002257495580553435)) * v152) + 0.016931216930225715) * v152) + 0.17777777777782838) * v152) + 0.6666666666666656) * v152) + 1.0));
          v197 = ((v151 * (v189 + ((1.0 - ((2.0 * v189) * v150)) * v150))) * Math.pow(v149, 1.0));
          v198.push((weight * v197));
        }
        v198 = (math.fsum(v198) * v143);
        v199 = v198;
      } else {
        v199 = 0.0;
      }
      v203 = v199;
    } else {
      v203 = (v73 - v116);
    }
    return ((mu * (E_star / G_star)) * v203);
  }
  return _tangential_displacement_of_gaussian(a, c, h, s, E_star, G_star, mu);
};

const tangential_displacement = (a, c, h, s, E_star, G_star, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement(a, c, h, s, E_star, G_star, mu) : NaN);
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

const _stick_radius = (F_x, a, h, s, E_star, mu) => {
  let F;
  F = stick_force(_force(a, h, s, E_star), F_x, mu);
  return (((F_x === 0.0) & (a >= 0.0)) ? a : _radius_from_force(F, h, s, E_star));
};

const stick_radius = (F_x, a, h, s, E_star, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius(F_x, a, h, s, E_star, mu) : NaN);
};

const _full_slip_displacement_of_gaussian = (a, h, s, E_star, G_star, mu) => {
  return ((mu * (E_star / G_star)) * _depth_of_gaussian(a, h, s));
};

const _full_slip_displacement = (a, h, s, E_star, G_star, mu) => {
  let v14, v52, v74, v8;
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (s > 1e-30) && (s < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    if ((a <= (1.5019752682686114 * s))) {
      v8 = (a / s);
      v14 = (v8 * v8);
      v52 = (((((((((((((((((((((((((1.567077144036674e-13 * v14) + (-3.840375691006307e-12)) * v14) + 3.8015754128174666e-11) * v14) + (-1.8423006918213799e-10)) * v14) + 4.472469827763728e-10) * v14) + (-1.1927516362741588e-09)) * v14) + 6.225892246861416e-09) * v14) + 3.4413148480148793e-09) * v14) + (-9.933344851449817e-08)) * v14) + (-5.127541706569233e-07)) * v14) + 1.8119768160503268e-06) * v14) + 2.151585040783394e-05) * v14) + 4.61098799999374e-06) * v14);
      v74 = (((2.0 * h) * (v8 / (((((((((((v52 + (-0.000684089638073553)) * v14) + (-0.002257495580553435)) * v14) + 0.016931216930225715) * v14) + 0.17777777777782838) * v14) + 0.6666666666666656) * v14) + 1.0))) * v8);
    } else {
      v74 = NaN;
    }
    return ((mu * (E_star / G_star)) * v74);
  }
  return _full_slip_displacement_of_gaussian(a, h, s, E_star, G_star, mu);
};

const full_slip_displacement = (a, h, s, E_star, G_star, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement(a, h, s, E_star, G_star, mu) : NaN);
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

const _bell = (a, s, k, of) => {
  let one, square;
  square = Math.pow((a / s), 2);
  one = math.ones_like(math.asarray(square));
  return weighted(((x) => of((((1.0 - x) * (1.0 + x)) * square))), one, k);
};

const gaussian_depth = (a, s, k) => {
  return ((2.0 * Math.pow((a / s), 2)) * _bell(a, s, k, ((fall) => Math.exp((-fall)))));
};

const gaussian_rate = (t, s, k) => {
  return ((((4.0 * t) / s) / s) * _bell(t, s, k, ((fall) => ((1.0 - fall) * Math.exp((-math.minimum(fall, 700.0)))))));
};

const _rate_of_gaussian = (a, h, s, k) => {
  return (h * gaussian_rate(a, s, k));
};

const _depth_3 = (a, h, s, k) => {
  let growth;
  growth = (h * gaussian_depth(a, s, k));
  return ((_rate_of_gaussian(a, h, s, k) >= 0.0) ? growth : NaN);
};

const depth_2 = (a, h, s, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_3(a, h, s, k) : NaN);
};

const raised = (x, k) => {
  if ((x > 0.0)) {
    return (x * Math.pow(x, k));
  }
  return 0.0;
};

const gaussian_force = (a, s, k) => {
  return ((2.0 * raised(a, k)) * _bell(a, s, k, ((fall) => (fall * Math.exp((-fall))))));
};

const _force_3 = (a, h, s, H, k) => {
  let growth;
  growth = (h * gaussian_force(a, s, k));
  return ((_rate_of_gaussian(a, h, s, k) >= 0.0) ? (((2.0 * H) / (1.0 + k)) * growth) : NaN);
};

const force_2 = (a, h, s, H, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_3(a, h, s, H, k) : NaN);
};

const _AXIS = Math.pow(2.0, (-60));

const _off_axis = (r, a) => {
  return math.maximum(r, (_AXIS * a));
};

const smooth_growth = (slope, r, a, k) => {
  let smooth, stop;
  r = _off_axis(r, a);
  smooth = (u) => {
    let t;
    t = Math.sqrt(((r * r) + (u * u)));
    return (slope(t) / t);
  };
  stop = difference_root(a, r);
  return (raised(stop, k) * weighted(smooth, stop, k));
};

const gaussian_pressure = (r, a, s, k) => {
  return smooth_growth(((t) => gaussian_rate(t, s, k)), r, a, k);
};

const _rate_2 = (a, h, s, k) => {
  return (h * gaussian_rate(a, s, k));
};

const _pressure_4 = (r, a, h, s, H, k) => {
  let growth, inside;
  inside = math.minimum(r, a);
  growth = (h * gaussian_pressure(inside, a, s, k));
  return math.where((_rate_2(a, h, s, k) >= 0.0), math.where((r < a), ((H / Math.PI) * growth), 0.0), NaN);
};

const pressure_2 = (r, a, h, s, H, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_4(r, a, h, s, H, k) : 0.0) : NaN);
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

const gaussian_displacement = (r, a, s, k) => {
  let shape, square;
  square = Math.pow((a / s), 2);
  shape = (_, z) => {
    let x;
    x = Math.pow((z / s), 2);
    return ((square * Math.exp((-square))) * ((x > 0.0) ? (Math.expm1(x) / ((x > 0.0) ? x : 1.0)) : 1.0));
  };
  return _smooth(shape, r, a, k);
};

const _displacement_4 = (r, a, h, s, k) => {
  return (h * gaussian_displacement(r, a, s, k));
};

const displacement_2 = (r, a, h, s, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_4(r, a, h, s, k) : 0.0) : NaN);
};

const punch_stiffness = (a, H, k) => {
  return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
};

const _stiffness_3 = (a, H, k) => {
  return punch_stiffness(a, H, k);
};

const _stiffness_2 = (a, H, k, h = 1.0, s = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (H > 1e-30) && (H < 1e+30) && (k > 1e-30) && (k < 1.0) && (h > 1e-30) && (h < 1e+30) && (s > 1e-30) && (s < 1e+30))) {
    return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  }
  return _stiffness_3(a, H, k);
};

const stiffness_of_gaussian = (a, h, s, H, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness_2(a, H, k) : NaN);
};

const _mean_pressure_2 = (a, h, s, H, k) => {
  return ((a > 0.0) ? (_force_3(a, h, s, H, k) / ((Math.PI * a) * a)) : 0.0);
};

const mean_pressure_of_gaussian = (a, h, s, H, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure_2(a, h, s, H, k) : NaN);
};

const gaussian_reach = math.kept((s, k) => {
  let _, high, low, middle, rises;
  [low, high] = [math.ones_like((s + k)), (8.0 * math.ones_like((s + k)))];
  for (_ of math.range(60)) {
    middle = ((low + high) / 2.0);
    rises = (gaussian_rate((s * middle), s, k) >= 0.0);
    [low, high] = [math.where(rises, middle, low), math.where(rises, high, middle)];
  }
  return (s * low);
});

const SHORT = [1.7763568394002505e-15, 2.9103830456733704e-11, 9.5367431640625e-07, 0.0009765625, 0.03125];

const ROUNDING_of_inverse = 1.1102230246251565e-16;

const SLACK_of_inverse = 1e-06;

const radius_up_to = (load, rate, value, largest, needs, unknown) => {
  let curve, end, held, least_short, noise, part, place, reach, t, top, wanted;
  value = (value + math.zeros(1));
  [end, top] = [largest, math.full(value, NaN)];
  for (part of SHORT) {
    end = (Number.isNaN(top) ? (largest * (1.0 - part)) : end);
    top = load(end, ...needs);
    if ((!Boolean(Number.isNaN(top)))) {
      break;
    }
  }
  held = (value <= (top * (1.0 + Math.pow(2.0, (-48)))));
  if ((!Boolean(held))) {
    return (math.truth(held) ? value : NaN);
  }
  reach = unknown.of(end);
  least_short = ((6.0 * ROUNDING_of_inverse) * top);
  place = (t) => {
    let a, step;
    [a, step] = unknown.back((t / (1.0 + (t / reach))));
    return [a, (step / Math.pow((1.0 + (t / reach)), 2))];
  };
  curve = (t) => {
    let a, own, short, step;
    [a, step] = place(t);
    own = load(a, ...needs);
    short = math.maximum((top - own), least_short);
    return [(own / short), (((t * step) * rate(a, ...needs)) * ((1.0 / own) + (1.0 / short)))];
  };
  wanted = (value / math.maximum((top - value), least_short));
  noise = (((2.0 * ROUNDING_of_inverse) * wanted) * (1.0 + wanted));
  t = inverse(curve, wanted, (reach * Math.sqrt(wanted)), [SLACK_of_inverse, Infinity], undefined, undefined, true, noise);
  return (math.truth(held) ? place(t)[0] : NaN);
};

const _radius_from_depth_2 = (d, h, s, k) => {
  return radius_up_to(_depth_3, _rate_of_gaussian, d, gaussian_reach(s, k), [h, s, k], on_the_bump(s));
};

const radius_from_depth_2 = (d, h, s, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth_2(d, h, s, k) : NaN);
};

const _force_rate = (a, h, s, H, k) => {
  return (punch_stiffness(a, H, k) * _rate_of_gaussian(a, h, s, k));
};

const _radius_from_force_2 = (F, h, s, H, k) => {
  return radius_up_to(_force_3, _force_rate, F, gaussian_reach(s, k), [h, s, H, k], on_the_bump(s));
};

const radius_from_force_2 = (F, h, s, H, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _radius_from_force_2(F, h, s, H, k) : NaN);
};

const punch_force = (d, a, H, k) => {
  let v14;
  v14 = (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  if (((v14 > 0.0) && (v14 < Infinity))) {
    return (v14 * d);
  }
  return 0.0;
};

const _force_from_depth_of_gaussian = (d, h, s, H, k) => {
  let a;
  a = _radius_from_depth_2(d, h, s, k);
  return (_force_3(a, h, s, H, k) + punch_force((d - _depth_3(a, h, s, k)), a, H, k));
};

const force_from_depth_of_gaussian = (d, h, s, H, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth_of_gaussian(d, h, s, H, k) : NaN);
};

const punch_depth = (F, a, H, k) => {
  let v14;
  v14 = (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  if (((v14 > 0.0) && (v14 < Infinity))) {
    return (F / v14);
  }
  return 0.0;
};

const _depth_from_force_of_gaussian = (F, h, s, H, k) => {
  let a;
  a = _radius_from_force_2(F, h, s, H, k);
  return (_depth_3(a, h, s, k) + punch_depth((F - _force_3(a, h, s, H, k)), a, H, k));
};

const depth_from_force_of_gaussian = (F, h, s, H, k) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force_of_gaussian(F, h, s, H, k) : NaN);
};

const graded_retraction = (a, H, k, dgamma) => {
  if ((a > 0.0)) {
    return ((math.sqrt(((6.283185307179586 * dgamma) / H)) * math.sqrt(a)) * math.sqrt(Math.pow(a, (-k))));
  }
  return 0.0;
};

const retraction_of_gaussian = (a, H, k, dgamma) => {
  if ((!((0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? graded_retraction(a, H, k, dgamma) : NaN);
};

const _depth_4 = (a, h, s, H, k, dgamma) => {
  return (_depth_3(a, h, s, k) - graded_retraction(a, H, k, dgamma));
};

const depth_3 = (a, h, s, H, k, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_4(a, h, s, H, k, dgamma) : NaN);
};

const _force_4 = (a, h, s, H, k, dgamma) => {
  return (_force_3(a, h, s, H, k) - (punch_stiffness(a, H, k) * graded_retraction(a, H, k, dgamma)));
};

const force_3 = (a, h, s, H, k, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_4(a, h, s, H, k, dgamma) : NaN);
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

const _pressure_5 = (r, a, h, s, H, k, dgamma) => {
  return (_pressure_4(r, a, h, s, H, k) - tension_of_punch(r, a, H, k, dgamma));
};

const pressure_3 = (r, a, h, s, H, k, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_5(r, a, h, s, H, k, dgamma) : 0.0) : NaN);
};

const punch_displacement = (r, a, k) => {
  return ((r > a) ? punch_share(r, a, k) : 1.0);
};

const _displacement_5 = (r, a, h, s, H, k, dgamma) => {
  return (_displacement_4(r, a, h, s, k) - (graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)));
};

const displacement_3 = (r, a, h, s, H, k, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_5(r, a, h, s, H, k, dgamma) : 0.0) : NaN);
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

const _samples_of_gaussian = (h, s, k) => {
  let a;
  a = radii_to(gaussian_reach(s, k));
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

const _branches_of_gaussian = (h, s, H, k, dgamma, control) => {
  return branches(((a) => (Math.pow(a, ((1.0 + k) / 2.0)) * _rate_of_gaussian(a, h, s, k))), _samples_of_gaussian(h, s, k), least_steepness_of_punch(control, H, k, dgamma));
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

const _radius_from_depth_3 = (d, h, s, H, k, dgamma) => {
  let found, pulled, radius, slope, stress, unit;
  unit = exponent_of(s);
  [stress, H] = stress_at(unit, H, k);
  h = math.ldexp(h, (-unit));
  s = math.ldexp(s, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  d = math.ldexp(d, (-unit));
  found = _branches_of_gaussian(h, s, H, k, dgamma, 'depth');
  slope = growth_of(_rate_of_gaussian, [h, s, k], H, k, dgamma, 'depth');
  pulled = pull_of(H, k, dgamma, 'depth');
  radius = stable_radius(d, found, ((a) => _depth_4(a, h, s, H, k, dgamma)), slope, pulled, on_the_bump(s));
  return math.ldexp(radius, unit);
};

const radius_from_depth_3 = (d, h, s, H, k, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_depth_3(d, h, s, H, k, dgamma);
};

const _radius_from_force_3 = (F, h, s, H, k, dgamma) => {
  let found, pulled, radius, slope, stress, unit;
  unit = exponent_of(s);
  [stress, H] = stress_at(unit, H, k);
  h = math.ldexp(h, (-unit));
  s = math.ldexp(s, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  F = math.ldexp(F, (-(stress + (2 * unit))));
  found = _branches_of_gaussian(h, s, H, k, dgamma, 'force');
  slope = growth_of(_rate_of_gaussian, [h, s, k], H, k, dgamma, 'force');
  pulled = pull_of(H, k, dgamma, 'force');
  radius = stable_radius(F, found, ((a) => _force_4(a, h, s, H, k, dgamma)), slope, pulled, on_the_bump(s));
  return math.ldexp(radius, unit);
};

const radius_from_force_3 = (F, h, s, H, k, dgamma) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_force_3(F, h, s, H, k, dgamma);
};

const _pull_off_radius_of_gaussian = (h, s, H, k, dgamma, control) => {
  let found, load, radius, stress, unit;
  unit = exponent_of(s);
  [stress, H] = stress_at(unit, H, k);
  h = math.ldexp(h, (-unit));
  s = math.ldexp(s, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  found = _branches_of_gaussian(h, s, H, k, dgamma, control);
  load = ((control === 'force') ? _force_4 : _depth_4);
  radius = math.lowest(found, ((a) => load(a, h, s, H, k, dgamma)));
  return math.ldexp(radius, unit);
};

const pull_off_of_gaussian = (control = 'force', h, s, H, k, dgamma) => {
  let depth, force, radius;
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  radius = _pull_off_radius_of_gaussian(h, s, H, k, dgamma, control);
  force = ((radius >= 0.0) ? _force_4(radius, h, s, H, k, dgamma) : NaN);
  depth = ((radius >= 0.0) ? _depth_4(radius, h, s, H, k, dgamma) : NaN);
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

const _tangential_force_2 = (a, c, h, s, H, k, mu) => {
  let gain;
  gain = (h * smooth_gain('force', gaussian_force, gaussian_rate, [s], 0.0, c, a, k));
  return math.where((_rate_2(a, h, s, k) >= 0.0), ((mu * ((2.0 * H) / (1.0 + k))) * gain), NaN);
};

const tangential_force_of_gaussian = (a, c, h, s, H, k, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_force_2(a, c, h, s, H, k, mu) : NaN);
};

const _traction_2 = (r, a, c, h, s, H, k, mu) => {
  let gain;
  gain = () => {
    let inside;
    inside = math.minimum(r, c);
    return (h * smooth_gain('pressure', gaussian_pressure, gaussian_rate, [s], inside, c, a, k));
  };
  return math.where((_rate_2(a, h, s, k) >= 0.0), (mu * either((r < c), (() => ((H / Math.PI) * gain())), (() => _pressure_4(r, a, h, s, H, k)))), NaN);
};

const traction_of_gaussian = (r, a, c, h, s, H, k, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction_2(r, a, c, h, s, H, k, mu) : 0.0) : NaN);
};

const _tangential_displacement_2 = (a, c, h, s, H, H_x, k, mu) => {
  let gain;
  gain = (h * smooth_gain('depth', gaussian_depth, gaussian_rate, [s], 0.0, c, a, k));
  return math.where((_rate_2(a, h, s, k) >= 0.0), ((mu * (H / H_x)) * gain), NaN);
};

const tangential_displacement_of_gaussian = (a, c, h, s, H, H_x, k, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement_2(a, c, h, s, H, H_x, k, mu) : NaN);
};

const _stick_radius_of_gaussian = (F_x, a, h, s, H, k, mu) => {
  let F;
  F = stick_force(_force_3(a, h, s, H, k), F_x, mu);
  return (((F_x === 0.0) & (a >= 0.0)) ? a : _radius_from_force_2(F, h, s, H, k));
};

const stick_radius_of_gaussian = (F_x, a, h, s, H, k, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius_of_gaussian(F_x, a, h, s, H, k, mu) : NaN);
};

const _full_slip_displacement_2 = (a, h, s, H, H_x, k, mu) => {
  return ((mu * (H / H_x)) * _depth_3(a, h, s, k));
};

const full_slip_displacement_of_gaussian = (a, h, s, H, H_x, k, mu) => {
  if ((!((0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement_2(a, h, s, H, H_x, k, mu) : NaN);
};

const relaxation_maxwell = (t, E, tau) => {
  return (E * Math.exp(((-t) / tau)));
};

const _step_force_maxwell = (t, d, h, s, E, tau) => {
  return (relaxation_maxwell(t, E, tau) * _force_from_depth(d, h, s, 1.0));
};

const step_force_maxwell = (t, d, h, s, E, tau) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_maxwell(t, d, h, s, E, tau) : NaN);
};

const creep_maxwell = (t, E, tau) => {
  return ((1.0 + (t / tau)) / E);
};

const _step_load_radius_maxwell = (t, F, h, s, E, tau) => {
  return _radius_from_force((F * creep_maxwell(t, E, tau)), h, s, 1.0);
};

const step_load_radius_maxwell = (t, F, h, s, E, tau) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_maxwell(t, F, h, s, E, tau) : NaN);
};

const relaxation_kelvin_voigt = (t, E, eta) => {
  if ((t > 0.0)) {
    return E;
  }
  return Infinity;
};

const _step_force_kelvin_voigt = (t, d, h, s, E, eta) => {
  return (relaxation_kelvin_voigt(t, E, eta) * _force_from_depth(d, h, s, 1.0));
};

const step_force_kelvin_voigt = (t, d, h, s, E, eta) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_kelvin_voigt(t, d, h, s, E, eta) : NaN);
};

const creep_kelvin_voigt = (t, E, eta) => {
  return ((-Math.expm1((((-E) * t) / eta))) / E);
};

const _step_load_radius_kelvin_voigt = (t, F, h, s, E, eta) => {
  return _radius_from_force((F * creep_kelvin_voigt(t, E, eta)), h, s, 1.0);
};

const step_load_radius_kelvin_voigt = (t, F, h, s, E, eta) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_kelvin_voigt(t, F, h, s, E, eta) : NaN);
};

const relaxation_standard_solid = (t, E_inf, E_1, tau) => {
  return (E_inf + (E_1 * Math.exp(((-t) / tau))));
};

const _step_force_standard_solid = (t, d, h, s, E_inf, E_1, tau) => {
  return (relaxation_standard_solid(t, E_inf, E_1, tau) * _force_from_depth(d, h, s, 1.0));
};

const step_force_standard_solid = (t, d, h, s, E_inf, E_1, tau) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_standard_solid(t, d, h, s, E_inf, E_1, tau) : NaN);
};

const creep_standard_solid = (t, E_inf, E_1, tau) => {
  let v4;
  v4 = (E_inf + E_1);
  return ((1.0 / v4) - (((E_1 / v4) * Math.expm1((-((t / tau) * (E_inf / v4))))) / E_inf));
};

const _step_load_radius_standard_solid = (t, F, h, s, E_inf, E_1, tau) => {
  return _radius_from_force((F * creep_standard_solid(t, E_inf, E_1, tau)), h, s, 1.0);
};

const step_load_radius_standard_solid = (t, F, h, s, E_inf, E_1, tau) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_standard_solid(t, F, h, s, E_inf, E_1, tau) : NaN);
};

const relaxation_power_creep = (t, E, alpha, t_0) => {
  let v8;
  v8 = (3.141592653589793 * alpha);
  return (((E * Math.pow((t_0 / t), alpha)) * Math.sin(v8)) / v8);
};

const _step_force_power_creep = (t, d, h, s, E, alpha, t_0) => {
  return (relaxation_power_creep(t, E, alpha, t_0) * _force_from_depth(d, h, s, 1.0));
};

const step_force_power_creep = (t, d, h, s, E, alpha, t_0) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_power_creep(t, d, h, s, E, alpha, t_0) : NaN);
};

const creep_power_creep = (t, E, alpha, t_0) => {
  return (Math.pow((t / t_0), alpha) / E);
};

const _step_load_radius_power_creep = (t, F, h, s, E, alpha, t_0) => {
  return _radius_from_force((F * creep_power_creep(t, E, alpha, t_0)), h, s, 1.0);
};

const step_load_radius_power_creep = (t, F, h, s, E, alpha, t_0) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < h && h < Infinity) && (0.0 < s && s < Infinity) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_power_creep(t, F, h, s, E, alpha, t_0) : NaN);
};

const once = { peak_pressure: math.kept(peak_pressure), pull_off: math.kept(pull_off), pull_off_of_gaussian: math.kept(pull_off_of_gaussian) };
const formulas = {
  "d": (v) => depth(v.a, v.h, v.s),
  "F": (v) => force(v.a, v.h, v.s, v.E_star),
  "p": (v) => pressure(v.r, v.a, v.h, v.s, v.E_star),
  "w": (v) => displacement(v.r, v.a, v.h, v.s),
  "k": (v) => stiffness(v.a, v.h, v.s, v.E_star),
  "pm": (v) => mean_pressure(v.a, v.h, v.s, v.E_star),
  "U": (v) => energy(v.a, v.h, v.s, v.E_star),
  "Fr": (v) => load_within(v.r, v.a, v.h, v.s, v.E_star),
  "rp": (v) => (once.peak_pressure(v.a, v.h, v.s, v.E_star).radius ?? NaN),
  "pp": (v) => (once.peak_pressure(v.a, v.h, v.s, v.E_star).pressure ?? NaN),
  "ad": (v) => radius_from_depth(v.d, v.h, v.s),
  "aF": (v) => radius_from_force(v.F, v.h, v.s, v.E_star),
  "Fd": (v) => force_from_depth(v.d, v.h, v.s, v.E_star),
  "dF": (v) => depth_from_force(v.F, v.h, v.s, v.E_star),
  "adh.Dl": (v) => retraction(v.a, v.E_star, v.dgamma),
  "adh.d": (v) => depth_of_gaussian(v.a, v.h, v.s, v.E_star, v.dgamma),
  "adh.F": (v) => force_of_gaussian(v.a, v.h, v.s, v.E_star, v.dgamma),
  "adh.p": (v) => pressure_of_gaussian(v.r, v.a, v.h, v.s, v.E_star, v.dgamma),
  "adh.w": (v) => displacement_of_gaussian(v.r, v.a, v.h, v.s, v.E_star, v.dgamma),
  "adh.ad": (v) => radius_from_depth_of_gaussian(v.d, v.h, v.s, v.E_star, v.dgamma),
  "adh.aF": (v) => radius_from_force_of_gaussian(v.F, v.h, v.s, v.E_star, v.dgamma),
  "adh.ac": (v) => (once.pull_off('force', v.h, v.s, v.E_star, v.dgamma).radius ?? NaN),
  "adh.Fc": (v) => (once.pull_off('force', v.h, v.s, v.E_star, v.dgamma).force ?? NaN),
  "adh.dc": (v) => (once.pull_off('force', v.h, v.s, v.E_star, v.dgamma).depth ?? NaN),
  "adh.am": (v) => (once.pull_off('depth', v.h, v.s, v.E_star, v.dgamma).radius ?? NaN),
  "adh.Fm": (v) => (once.pull_off('depth', v.h, v.s, v.E_star, v.dgamma).force ?? NaN),
  "adh.dm": (v) => (once.pull_off('depth', v.h, v.s, v.E_star, v.dgamma).depth ?? NaN),
  "tan.F": (v) => tangential_force(v.a, v.c, v.h, v.s, v.E_star, v.mu),
  "tan.tau": (v) => traction(v.r, v.a, v.c, v.h, v.s, v.E_star, v.mu),
  "tan.u": (v) => tangential_displacement(v.a, v.c, v.h, v.s, v.E_star, v.G_star, v.mu),
  "tan.c": (v) => stick_radius(v.F_x, v.a, v.h, v.s, v.E_star, v.mu),
  "tan.us": (v) => full_slip_displacement(v.a, v.h, v.s, v.E_star, v.G_star, v.mu),
  "fgm.d": (v) => depth_2(v.a, v.h, v.s, v.k),
  "fgm.F": (v) => force_2(v.a, v.h, v.s, v.H, v.k),
  "fgm.p": (v) => pressure_2(v.r, v.a, v.h, v.s, v.H, v.k),
  "fgm.w": (v) => displacement_2(v.r, v.a, v.h, v.s, v.k),
  "fgm.k": (v) => stiffness_of_gaussian(v.a, v.h, v.s, v.H, v.k),
  "fgm.pm": (v) => mean_pressure_of_gaussian(v.a, v.h, v.s, v.H, v.k),
  "fgm.ad": (v) => radius_from_depth_2(v.d, v.h, v.s, v.k),
  "fgm.aF": (v) => radius_from_force_2(v.F, v.h, v.s, v.H, v.k),
  "fgm.Fd": (v) => force_from_depth_of_gaussian(v.d, v.h, v.s, v.H, v.k),
  "fgm.dF": (v) => depth_from_force_of_gaussian(v.F, v.h, v.s, v.H, v.k),
  "fgm.adh.Dl": (v) => retraction_of_gaussian(v.a, v.H, v.k, v.dgamma),
  "fgm.adh.d": (v) => depth_3(v.a, v.h, v.s, v.H, v.k, v.dgamma),
  "fgm.adh.F": (v) => force_3(v.a, v.h, v.s, v.H, v.k, v.dgamma),
  "fgm.adh.p": (v) => pressure_3(v.r, v.a, v.h, v.s, v.H, v.k, v.dgamma),
  "fgm.adh.w": (v) => displacement_3(v.r, v.a, v.h, v.s, v.H, v.k, v.dgamma),
  "fgm.adh.ad": (v) => radius_from_depth_3(v.d, v.h, v.s, v.H, v.k, v.dgamma),
  "fgm.adh.aF": (v) => radius_from_force_3(v.F, v.h, v.s, v.H, v.k, v.dgamma),
  "fgm.adh.ac": (v) => (once.pull_off_of_gaussian('force', v.h, v.s, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fc": (v) => (once.pull_off_of_gaussian('force', v.h, v.s, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dc": (v) => (once.pull_off_of_gaussian('force', v.h, v.s, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.adh.am": (v) => (once.pull_off_of_gaussian('depth', v.h, v.s, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fm": (v) => (once.pull_off_of_gaussian('depth', v.h, v.s, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dm": (v) => (once.pull_off_of_gaussian('depth', v.h, v.s, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.tan.F": (v) => tangential_force_of_gaussian(v.a, v.c, v.h, v.s, v.H, v.k, v.mu),
  "fgm.tan.tau": (v) => traction_of_gaussian(v.r, v.a, v.c, v.h, v.s, v.H, v.k, v.mu),
  "fgm.tan.u": (v) => tangential_displacement_of_gaussian(v.a, v.c, v.h, v.s, v.H, v.H_x, v.k, v.mu),
  "fgm.tan.c": (v) => stick_radius_of_gaussian(v.F_x, v.a, v.h, v.s, v.H, v.k, v.mu),
  "fgm.tan.us": (v) => full_slip_displacement_of_gaussian(v.a, v.h, v.s, v.H, v.H_x, v.k, v.mu),
  "vis.step_mx": (v) => step_force_maxwell(v.t, v.d, v.h, v.s, v.E_law, v.tau),
  "vis.load_mx": (v) => step_load_radius_maxwell(v.t, v.F, v.h, v.s, v.E_law, v.tau),
  "vis.step_kv": (v) => step_force_kelvin_voigt(v.t, v.d, v.h, v.s, v.E_law, v.eta),
  "vis.load_kv": (v) => step_load_radius_kelvin_voigt(v.t, v.F, v.h, v.s, v.E_law, v.eta),
  "vis.step_sls": (v) => step_force_standard_solid(v.t, v.d, v.h, v.s, v.E_inf, v.E_1, v.tau),
  "vis.load_sls": (v) => step_load_radius_standard_solid(v.t, v.F, v.h, v.s, v.E_inf, v.E_1, v.tau),
  "vis.step_pc": (v) => step_force_power_creep(v.t, v.d, v.h, v.s, v.E_law, v.alpha, v.t_0),
  "vis.load_pc": (v) => step_load_radius_power_creep(v.t, v.F, v.h, v.s, v.E_law, v.alpha, v.t_0),
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
   "value": 0.0002
  },
  {
   "name": "s",
   "tex": "s",
   "meaning": "length scale of the profile",
   "unit": "m",
   "rule": "s > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 0.001
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
    "h",
    "s"
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
    "s",
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
    "s",
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
    "s"
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s"
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
    "s",
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
