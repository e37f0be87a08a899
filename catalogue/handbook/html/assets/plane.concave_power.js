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

const RULE_0 = math.rule([[3.0, 32], [20.0, 64], [Infinity, 128]]);

const RULE_2 = math.rule([[16.0, 64], [Infinity, 128]]);

const gamma_ratio = (x) => {
  let v2, v21, v7;
  v2 = (x + 1.75);
  v7 = ((x + 0.5) * (x + 1.5));
  v21 = (1.0 / (v2 * v2));
  return ((((x < 1.0) ? ((x * (x + 1.0)) / v7) : (1.0 - ((x + 0.75) / v7))) * math.sqrt(v2)) * (1.0 + (v21 * (((((((((((((0.01524698625788054 * v21) + 0.5334320651111477) * v21) + 2.250488865813539) * v21) + 2.8612106440066865) * v21) + 1.3794681629043655) * v21) + 0.2596058532893223) * v21) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v21) + 49.328555418276075) * v21) + 167.28648538571198) * v21) + 195.37226190335065) * v21) + 90.69722535867314) * v21) + 16.763212110504565) * v21) + 1.0)))));
};

const _log_ratio = (x, y) => {
  let v3;
  v3 = ((x - y) / y);
  if (Number.isFinite(v3)) {
    return math.log1p(v3);
  }
  return (math.log(x) - math.log(y));
};

const RULE_0_of_powers = math.rule([[16.0, 64], [Infinity, 128]]);

const _fallen_pressure = (depth, n) => {
  let node, v10, v12, v13, v18, v20, v22, v27, v3, v30, v32, v41, v42, v5, weight;
  if ((depth > 0.0)) {
    v3 = (n > 1.0);
    v5 = Math.abs((n - 1.0));
    v10 = (depth - (42.0 / (((v5 > 0.001) || (v5 !== v5)) ? v5 : 0.001)));
    v12 = (((v10 > 0.0) || (v10 !== v10)) ? v10 : 0.0);
    v13 = math.sqrt(depth);
    v18 = (math.truth(v3) ? (v13 - math.sqrt(v12)) : math.sqrt((depth - v12)));
    v22 = (2.0 * v13);
    v27 = (-v5);
    v42 = [];
    for ([node, weight] of RULE_0_of_powers((v18 / 1.0))) {
      v20 = (node * v18);
      if (v3) {
        v30 = (v13 - v20);
        v32 = (((v30 > 0.0) || (v30 !== v30)) ? v30 : 0.0);
      } else {
        v32 = v20;
      }
      v41 = (Math.exp((v27 * (math.truth(v3) ? (v20 * (v22 - v20)) : (v20 * v20)))) * ((2.0 * v32) / math.sqrt((-Math.expm1((((-2.0) * v32) * v32))))));
      v42.push((weight * v41));
    }
    v42 = (math.fsum(v42) * v18);
    return v42;
  }
  return 0.0;
};

const power_pressure = (r, a, n) => {
  let centre, largest;
  centre = ((n > 1.0) ? (1.0 / Math.abs((n - 1.0))) : Infinity);
  largest = ((n > 1.0) ? 1.0 : (Math.pow((r / a), n) * (a / r)));
  return ((r > 0.0) ? (largest * _fallen_pressure(_log_ratio(a, r), n)) : centre);
};

const _start = (m, k) => {
  let bend, c, length, middle, small;
  small = (((4.0 / Math.PI) * Math.sin(((Math.PI / 2.0) * (1.0 - k)))) / (1.0 + k));
  middle = (2.0 * Math.expm1((((-0.5) * (1.0 - k)) * Math.log(((1.0 - k) / 4.0)))));
  bend = (0.36 + (0.4 * k));
  c = (small + ((((middle - small) * (1.0 + bend)) * m) / (m + (2.0 * math.maximum(bend, 0.0)))));
  length = (Math.log1p((c / m)) / (1.0 - k));
  return math.where((m < 2.0), math.maximum(length, (Math.log(((m * (m + 2.0)) / (2.0 * (1.0 - k)))) / m)), length);
};

const STEPS = 5;

const GONE = 300.0;

const LENGTHS = [[3.0, 32], [20.0, 64], [Infinity, 128]];

const _integral = (integrand, length) => {
  let rooted;
  rooted = (x) => {
    let power;
    power = (Math.pow(x, 2) * x);
    power = ((power * power) * x);
    return ((8.0 * power) * integrand((power * x)));
  };
  return math.integral_by_length(rooted, math.ones_like(length), (1.0 / length), LENGTHS);
};

const _balance = (length, m, k) => {
  let integrand, z;
  z = (-Math.expm1(((-2.0) * length)));
  integrand = (y) => {
    let inner, outer, rest, risen;
    [inner, outer] = [(-Math.expm1((((-2.0) * length) * y))), (-Math.expm1((((-2.0) * length) * (1.0 - y))))];
    risen = Math.expm1(((m * length) * y));
    rest = (risen - ((((0.5 * m) * (risen + 1.0)) * inner) * (outer / z)));
    return (((Math.exp((((1.0 - k) * length) * (1.0 - y))) * Math.pow((inner / z), ((k - 1.0) / 2.0))) * rest) / inner);
  };
  return (((1.0 - k) * length) * _integral(integrand, ((m + 1.0) * length)));
};

const _log_ratio_of_ring = (n, k) => {
  let _, length, lifted, slope, square, value, z;
  n = math.where((n > 2.0), n, 3.0);
  length = _start((n - 2.0), k);
  for (_ of math.range(STEPS)) {
    [z, square] = [(-Math.expm1(((-2.0) * length))), Math.exp(((-2.0) * math.minimum(length, GONE)))];
    lifted = math.maximum((((n - 1.0) + k) - (n * square)), (1.0 + k));
    value = _balance(length, (n - 2.0), k);
    slope = ((((1.0 - k) * (1.0 + k)) * Math.exp(((n - 2.0) * length))) / (z * lifted));
    slope = (slope + ((value - 1.0) * (((2.0 * ((n - 1.0) + k)) / lifted) - ((1.0 + k) / z))));
    length = (length - ((Math.log(value) * value) / slope));
  }
  return length;
};

const outside_zero_pressure = (n, k = 0.0) => {
  return math.where((n > 2.0), (-Math.expm1(((-2.0) * _log_ratio_of_ring(n, k)))), 1.0);
};

const _minimum_load = (h, n, E_star) => {
  let kappa, zeta;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  zeta = outside_zero_pressure(n);
  return ((((Math.sqrt(Math.PI) * E_star) * n) * h) / ((2 * ((n * zeta) - 1)) * kappa));
};

const _pressure_of_concave_power = (x, P, a, h, n, E_star) => {
  let complete, face, kappa, result, root, strip, value;
  root = Math.sqrt(((a - x) * (a + x)));
  strip = (P / (Math.PI * root));
  kappa = gamma_ratio(((n + 1) / 2));
  face = ((((E_star * n) * h) * ((1 / root) - ((n * power_pressure(x, a, n)) / a))) / ((2 * Math.sqrt(Math.PI)) * kappa));
  value = (strip + face);
  complete = ((_minimum_load(h, n, E_star) * (1.0 - 1e-15)) <= P);
  result = math.where(((x <= a) & (P > 0.0)), value, 0.0);
  return math.where(complete, result, NaN);
};

const _pressure = (x, P, a, h, n, E_star) => {
  let node, v100, v105, v106, v107, v112, v114, v115, v120, v123, v125, v134, v135, v136, v138, v148, v149, v152, v16, v164, v18, v193, v195, v196, v205, v211, v213, v214, v216, v222, v224, v225, v226, v228, v229, v23, v231, v233, v236, v239, v240, v244, v246, v247, v262, v263, v264, v269, v278, v279, v281, v286, v287, v289, v290, v292, v294, v296, v299, v300, v304, v306, v320, v321, v322, v335, v336, v338, v343, v344, v346, v347, v349, v351, v353, v356, v357, v36, v361, v363, v377, v378, v379, v392, v393, v395, v400, v401, v403, v404, v406, v408, v410, v413, v414, v418, v420, v434, v435, v436, v449, v450, v452, v457, v458, v460, v461, v463, v465, v467, v470, v471, v475, v477, v491, v492, v493, v510, v6, v81, v83, v9, v94, weight;
  if (((x > 1e-30) && (x < 1e+30) && (P > 1e-30) && (P < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v148 = ((n / 2.0) + 0.5);
    v149 = (v148 + 1.75);
    v152 = ((v148 + 0.5) * (v148 + 1.5));
    v164 = (1.0 / (v149 * v149));
    v193 = (n > 2.0);
    if (v193) {
      v195 = (math.truth(v193) ? n : 3.0);
      v196 = (v195 - 2.0);
      v205 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v196) / (v196 + 0.72))) / v196));
      if ((v196 < 2.0)) {
        v211 = (Math.log(((v196 * (v196 + 2.0)) / 2.0)) / v196);
        v213 = (((v205 > v211) || (v205 !== v205)) ? v205 : v211);
      } else {
        v213 = v205;
      }
      v214 = ((-2.0) * v213);
      v216 = (-Math.expm1(v214));
      v222 = ((v195 - 1.0) + 0.0);
      v224 = (v222 - (v195 * Math.exp(((-2.0) * (((v213 < 300.0) || (v213 !== v213)) ? v213 : 300.0)))));
      v225 = (((v224 > 1.0) || (v224 !== v224)) ? v224 : 1.0);
      v226 = (v196 + 1.0);
      v228 = (1.0 / (v226 * v213));
      v244 = (v196 * v213);
      v247 = (0.5 * v196);
      v263 = [];
      for ([node, weight] of RULE_0((1.0 / v228))) {
        v229 = (node * 1.0);
        v231 = ((v229 * v229) * v229);
        v233 = ((v231 * v231) * v229);
        v236 = (v233 * v229);
        v239 = (-Math.expm1((v214 * v236)));
        v240 = (1.0 - v236);
        v246 = Math.expm1((v244 * v236));
        v262 = ((8.0 * v233) * (((Math.exp((v213 * v240)) * Math.pow((v239 / v216), (-0.5))) * (v246 - (((v247 * (v246 + 1.0)) * v239) * ((-Math.expm1((v214 * v240))) / v216)))) / v239));
        v263.push((weight * v262));
      }
      v263 = (math.fsum(v263) * 1.0);
      v264 = (v213 * v263);
      v269 = (2.0 * v222);
      v278 = (v213 - ((Math.log(v264) * v264) / ((Math.exp(v244) / (v216 * v225)) + ((v264 - 1.0) * ((v269 / v225) - (1.0 / v216))))));
      v279 = ((-2.0) * v278);
      v281 = (-Math.expm1(v279));
      v286 = (v222 - (v195 * Math.exp(((-2.0) * (((v278 < 300.0) || (v278 !== v278)) ? v278 : 300.0)))));
      v287 = (((v286 > 1.0) || (v286 !== v286)) ? v286 : 1.0);
      v289 = (1.0 / (v226 * v278));
      v304 = (v196 * v278);
      v321 = [];
      for ([node, weight] of RULE_0((1.0 / v289))) {
        v290 = (node * 1.0);
        v292 = ((v290 * v290) * v290);
        v294 = ((v292 * v292) * v290);
        v296 = (v294 * v290);
        v299 = (-Math.expm1((v279 * v296)));
        v300 = (1.0 - v296);
        v306 = Math.expm1((v304 * v296));
        v320 = ((8.0 * v294) * (((Math.exp((v278 * v300)) * Math.pow((v299 / v281), (-0.5))) * (v306 - (((v247 * (v306 + 1.0)) * v299) * ((-Math.expm1((v279 * v300))) / v281)))) / v299));
        v321.push((weight * v320));
      }
      v321 = (math.fsum(v321) * 1.0);
      v322 = (v278 * v321);
      v335 = (v278 - ((Math.log(v322) * v322) / ((Math.exp(v304) / (v281 * v287)) + ((v322 - 1.0) * ((v269 / v287) - (1.0 / v281))))));
      v336 = ((-2.0) * v335);
      v338 = (-Math.expm1(v336));
      v343 = (v222 - (v195 * Math.exp(((-2.0) * (((v335 < 300.0) || (v335 !== v335)) ? v335 : 300.0)))));
      v344 = (((v343 > 1.0) || (v343 !== v343)) ? v343 : 1.0);
      v346 = (1.0 / (v226 * v335));
      v361 = (v196 * v335);
      v378 = [];
      for ([node, weight] of RULE_0((1.0 / v346))) {
        v347 = (node * 1.0);
        v349 = ((v347 * v347) * v347);
        v351 = ((v349 * v349) * v347);
        v353 = (v351 * v347);
        v356 = (-Math.expm1((v336 * v353)));
        v357 = (1.0 - v353);
        v363 = Math.expm1((v361 * v353));
        v377 = ((8.0 * v351) * (((Math.exp((v335 * v357)) * Math.pow((v356 / v338), (-0.5))) * (v363 - (((v247 * (v363 + 1.0)) * v356) * ((-Math.expm1((v336 * v357))) / v338)))) / v356));
        v378.push((weight * v377));
      }
      v378 = (math.fsum(v378) * 1.0);
      v379 = (v335 * v378);
      v392 = (v335 - ((Math.log(v379) * v379) / ((Math.exp(v361) / (v338 * v344)) + ((v379 - 1.0) * ((v269 / v344) - (1.0 / v338))))));
      v393 = ((-2.0) * v392);
      v395 = (-Math.expm1(v393));
      v400 = (v222 - (v195 * Math.exp(((-2.0) * (((v392 < 300.0) || (v392 !== v392)) ? v392 : 300.0)))));
      v401 = (((v400 > 1.0) || (v400 !== v400)) ? v400 : 1.0);
      v403 = (1.0 / (v226 * v392));
      v418 = (v196 * v392);
      v435 = [];
      for ([node, weight] of RULE_0((1.0 / v403))) {
        v404 = (node * 1.0);
        v406 = ((v404 * v404) * v404);
        v408 = ((v406 * v406) * v404);
        v410 = (v408 * v404);
        v413 = (-Math.expm1((v393 * v410)));
        v414 = (1.0 - v410);
        v420 = Math.expm1((v418 * v410));
        v434 = ((8.0 * v408) * (((Math.exp((v392 * v414)) * Math.pow((v413 / v395), (-0.5))) * (v420 - (((v247 * (v420 + 1.0)) * v413) * ((-Math.expm1((v393 * v414))) / v395)))) / v413));
        v435.push((weight * v434));
      }
      v435 = (math.fsum(v435) * 1.0);
      v436 = (v392 * v435);
      v449 = (v392 - ((Math.log(v436) * v436) / ((Math.exp(v418) / (v395 * v401)) + ((v436 - 1.0) * ((v269 / v401) - (1.0 / v395))))));
      v450 = ((-2.0) * v449);
      v452 = (-Math.expm1(v450));
      v457 = (v222 - (v195 * Math.exp(((-2.0) * (((v449 < 300.0) || (v449 !== v449)) ? v449 : 300.0)))));
      v458 = (((v457 > 1.0) || (v457 !== v457)) ? v457 : 1.0);
      v460 = (1.0 / (v226 * v449));
      v475 = (v196 * v449);
      v492 = [];
      for ([node, weight] of RULE_0((1.0 / v460))) {
        v461 = (node * 1.0);
        v463 = ((v461 * v461) * v461);
        v465 = ((v463 * v463) * v461);
        v467 = (v465 * v461);
        v470 = (-Math.expm1((v450 * v467)));
        v471 = (1.0 - v467);
        v477 = Math.expm1((v475 * v467));
        v491 = ((8.0 * v465) * (((Math.exp((v449 * v471)) * Math.pow((v470 / v452), (-0.5))) * (v477 - (((v247 * (v477 + 1.0)) * v470) * ((-Math.expm1((v450 * v471))) / v452)))) / v470));
        v492.push((weight * v491));
      }
      v492 = (math.fsum(v492) * 1.0);
      v493 = (v449 * v492);
      v510 = (-Math.expm1(((-2.0) * (v449 - ((Math.log(v493) * v493) / ((Math.exp(v475) / (v452 * v458)) + ((v493 - 1.0) * ((v269 / v458) - (1.0 / v452)))))))));
    } else {
      v510 = 1.0;
    }
    if (((((((1.7724538509055159 * E_star) * n) * h) / ((2.0 * ((n * v510) - 1.0)) * ((((v148 < 1.0) ? ((v148 * (v148 + 1.0)) / v152) : (1.0 - ((v148 + 0.75) / v152))) * Math.sqrt(v149)) * (1.0 + (v164 * (((((((((((((0.01524698625788054 * v164) + 0.5334320651111477) * v164) + 2.250488865813539) * v164) + 2.8612106440066865) * v164) + 1.3794681629043655) * v164) + 0.2596058532893223) * v164) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v164) + 49.328555418276075) * v164) + 167.28648538571198) * v164) + 195.37226190335065) * v164) + 90.69722535867314) * v164) + 16.763212110504565) * v164) + 1.0))))))) * 0.999999999999999) <= P)) {
      if (((x <= a) && (P > 0.0))) {
        v6 = (a - x);
        v9 = Math.sqrt((v6 * (a + x)));
        v16 = ((n + 1.0) / 2.0);
        v18 = (v16 + 1.75);
        v23 = ((v16 + 0.5) * (v16 + 1.5));
        v36 = (1.0 / (v18 * v18));
        v81 = (n > 1.0);
        v83 = Math.abs((n - 1.0));
        if ((x > 0.0)) {
          v94 = (v6 / x);
          v100 = (Number.isFinite(v94) ? Math.log1p(v94) : (Math.log(a) - Math.log(x)));
          if ((v100 > 0.0)) {
            v105 = (v100 - (42.0 / (((v83 > 0.001) || (v83 !== v83)) ? v83 : 0.001)));
            v106 = (((v105 > 0.0) || (v105 !== v105)) ? v105 : 0.0);
            v107 = Math.sqrt(v100);
            v112 = (math.truth(v81) ? (v107 - Math.sqrt(v106)) : Math.sqrt((v100 - v106)));
            v115 = (2.0 * v107);
            v120 = (-v83);
            v135 = [];
            for ([node, weight] of RULE_2((v112 / 1.0))) {
              v114 = (node * v112);
              if (v81) {
                v123 = (v107 - v114);
                v125 = (((v123 > 0.0) || (v123 !== v123)) ? v123 : 0.0);
              } else {
                v125 = v114;
              }
              v134 = (Math.exp((v120 * (math.truth(v81) ? (v114 * (v115 - v114)) : (v114 * v114)))) * ((2.0 * v125) / Math.sqrt((-Math.expm1((((-2.0) * v125) * v125))))));
              v135.push((weight * v134));
            }
            v135 = (math.fsum(v135) * v112);
            v136 = v135;
          } else {
            v136 = 0.0;
          }
          v138 = ((math.truth(v81) ? 1.0 : (Math.pow((x / a), n) * (a / x))) * v136);
        } else {
          v138 = (math.truth(v81) ? (1.0 / v83) : Infinity);
        }
        return ((P / (3.141592653589793 * v9)) + ((((E_star * n) * h) * ((1.0 / v9) - ((n * v138) / a))) / (3.5449077018110318 * ((((v16 < 1.0) ? ((v16 * (v16 + 1.0)) / v23) : (1.0 - ((v16 + 0.75) / v23))) * Math.sqrt(v18)) * (1.0 + (v36 * (((((((((((((0.01524698625788054 * v36) + 0.5334320651111477) * v36) + 2.250488865813539) * v36) + 2.8612106440066865) * v36) + 1.3794681629043655) * v36) + 0.2596058532893223) * v36) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v36) + 49.328555418276075) * v36) + 167.28648538571198) * v36) + 195.37226190335065) * v36) + 90.69722535867314) * v36) + 16.763212110504565) * v36) + 1.0))))))));
      }
      return 0.0;
    }
    return NaN;
  }
  return _pressure_of_concave_power(x, P, a, h, n, E_star);
};

const pressure = (x, P, a, h, n, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (n > 1)))) {
    return NaN;
  }
  return (((Math.abs(x) >= 0.0) && (P >= 0.0)) ? ((Math.abs(x) < Infinity) ? _pressure(Math.abs(x), P, a, h, n, E_star) : 0.0) : NaN);
};

const RULE_1 = math.rule([[Infinity, 64]]);

const _log_ratio_of_powers = (x, y) => {
  let excess;
  excess = ((x - y) / y);
  return math.where(Number.isFinite(excess), Math.log1p(excess), (Math.log(x) - Math.log(y)));
};

const _DECAY = 42.0;

const _weight = (s) => {
  return ((2.0 * s) / Math.sqrt((-Math.expm1((((-2.0) * s) * s)))));
};

const NODES = 64;

const power_strips = (x, a, n) => {
  let fall, integrand, reach, start;
  start = Math.sqrt(_log_ratio_of_powers(x, a));
  fall = (_DECAY / (n + 2.0));
  integrand = (step) => {
    let root, s;
    s = (start + step);
    root = Math.sqrt((-Math.expm1((((-2.0) * s) * s))));
    return ((Math.exp((((-(n + 2.0)) * step) * ((2.0 * start) + step))) * _weight(s)) / (1.0 + root));
  };
  reach = (fall / (Math.sqrt(((start * start) + fall)) + start));
  return (math.where((a > 0.0), (1.0 + ((n * Math.pow((a / x), 2)) * math.integral(integrand, reach, NODES))), 1.0) / x);
};

const lower_power = (x, n) => {
  return math.where((x > 0.0), (Math.pow(x, n) / x), Math.pow(x, (n - 1.0)));
};

const _profile_slope = (x, a, h, n) => {
  return ((((-n) * h) * lower_power(x, n)) / Math.pow(a, n));
};

const _slope_of_concave_power = (x, P, a, h, n, E_star) => {
  let complete, face, kappa, outside, result, root, strip, value;
  root = Math.sqrt(((x - a) * (a + x)));
  strip = (((-2) * P) / ((Math.PI * E_star) * root));
  kappa = gamma_ratio(((n + 1) / 2));
  face = (((n * h) * (power_strips(x, a, n) - (1 / root))) / (Math.sqrt(Math.PI) * kappa));
  value = (strip + face);
  outside = math.where((P > 0.0), value, 0.0);
  complete = ((_minimum_load(h, n, E_star) * (1.0 - 1e-15)) <= P);
  result = math.where((x >= a), outside, (-_profile_slope(x, a, h, n)));
  return math.where(complete, result, NaN);
};

const _slope = (x, P, a, h, n, E_star) => {
  let node, v100, v103, v104, v109, v110, v112, v120, v121, v124, v136, v137, v140, v152, v181, v183, v184, v19, v193, v199, v201, v202, v204, v21, v210, v212, v213, v214, v216, v217, v219, v221, v224, v227, v228, v232, v234, v235, v250, v251, v252, v257, v26, v266, v267, v269, v274, v275, v277, v278, v280, v282, v284, v287, v288, v292, v294, v308, v309, v310, v323, v324, v326, v331, v332, v334, v335, v337, v339, v341, v344, v345, v349, v351, v365, v366, v367, v380, v381, v383, v388, v389, v39, v391, v392, v394, v396, v398, v401, v402, v406, v408, v422, v423, v424, v437, v438, v440, v445, v446, v448, v449, v451, v453, v455, v458, v459, v463, v465, v479, v480, v481, v498, v6, v82, v89, v9, v90, v92, v97, weight;
  if (((x > 1e-30) && (x < 1e+30) && (P > 1e-30) && (P < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v136 = ((n / 2.0) + 0.5);
    v137 = (v136 + 1.75);
    v140 = ((v136 + 0.5) * (v136 + 1.5));
    v152 = (1.0 / (v137 * v137));
    v181 = (n > 2.0);
    if (v181) {
      v183 = (math.truth(v181) ? n : 3.0);
      v184 = (v183 - 2.0);
      v193 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v184) / (v184 + 0.72))) / v184));
      if ((v184 < 2.0)) {
        v199 = (Math.log(((v184 * (v184 + 2.0)) / 2.0)) / v184);
        v201 = (((v193 > v199) || (v193 !== v193)) ? v193 : v199);
      } else {
        v201 = v193;
      }
      v202 = ((-2.0) * v201);
      v204 = (-Math.expm1(v202));
      v210 = ((v183 - 1.0) + 0.0);
      v212 = (v210 - (v183 * Math.exp(((-2.0) * (((v201 < 300.0) || (v201 !== v201)) ? v201 : 300.0)))));
      v213 = (((v212 > 1.0) || (v212 !== v212)) ? v212 : 1.0);
      v214 = (v184 + 1.0);
      v216 = (1.0 / (v214 * v201));
      v232 = (v184 * v201);
      v235 = (0.5 * v184);
      v251 = [];
      for ([node, weight] of RULE_0((1.0 / v216))) {
        v217 = (node * 1.0);
        v219 = ((v217 * v217) * v217);
        v221 = ((v219 * v219) * v217);
        v224 = (v221 * v217);
        v227 = (-Math.expm1((v202 * v224)));
        v228 = (1.0 - v224);
        v234 = Math.expm1((v232 * v224));
        v250 = ((8.0 * v221) * (((Math.exp((v201 * v228)) * Math.pow((v227 / v204), (-0.5))) * (v234 - (((v235 * (v234 + 1.0)) * v227) * ((-Math.expm1((v202 * v228))) / v204)))) / v227));
        v251.push((weight * v250));
      }
      v251 = (math.fsum(v251) * 1.0);
      v252 = (v201 * v251);
      v257 = (2.0 * v210);
      v266 = (v201 - ((Math.log(v252) * v252) / ((Math.exp(v232) / (v204 * v213)) + ((v252 - 1.0) * ((v257 / v213) - (1.0 / v204))))));
      v267 = ((-2.0) * v266);
      v269 = (-Math.expm1(v267));
      v274 = (v210 - (v183 * Math.exp(((-2.0) * (((v266 < 300.0) || (v266 !== v266)) ? v266 : 300.0)))));
      v275 = (((v274 > 1.0) || (v274 !== v274)) ? v274 : 1.0);
      v277 = (1.0 / (v214 * v266));
      v292 = (v184 * v266);
      v309 = [];
      for ([node, weight] of RULE_0((1.0 / v277))) {
        v278 = (node * 1.0);
        v280 = ((v278 * v278) * v278);
        v282 = ((v280 * v280) * v278);
        v284 = (v282 * v278);
        v287 = (-Math.expm1((v267 * v284)));
        v288 = (1.0 - v284);
        v294 = Math.expm1((v292 * v284));
        v308 = ((8.0 * v282) * (((Math.exp((v266 * v288)) * Math.pow((v287 / v269), (-0.5))) * (v294 - (((v235 * (v294 + 1.0)) * v287) * ((-Math.expm1((v267 * v288))) / v269)))) / v287));
        v309.push((weight * v308));
      }
      v309 = (math.fsum(v309) * 1.0);
      v310 = (v266 * v309);
      v323 = (v266 - ((Math.log(v310) * v310) / ((Math.exp(v292) / (v269 * v275)) + ((v310 - 1.0) * ((v257 / v275) - (1.0 / v269))))));
      v324 = ((-2.0) * v323);
      v326 = (-Math.expm1(v324));
      v331 = (v210 - (v183 * Math.exp(((-2.0) * (((v323 < 300.0) || (v323 !== v323)) ? v323 : 300.0)))));
      v332 = (((v331 > 1.0) || (v331 !== v331)) ? v331 : 1.0);
      v334 = (1.0 / (v214 * v323));
      v349 = (v184 * v323);
      v366 = [];
      for ([node, weight] of RULE_0((1.0 / v334))) {
        v335 = (node * 1.0);
        v337 = ((v335 * v335) * v335);
        v339 = ((v337 * v337) * v335);
        v341 = (v339 * v335);
        v344 = (-Math.expm1((v324 * v341)));
        v345 = (1.0 - v341);
        v351 = Math.expm1((v349 * v341));
        v365 = ((8.0 * v339) * (((Math.exp((v323 * v345)) * Math.pow((v344 / v326), (-0.5))) * (v351 - (((v235 * (v351 + 1.0)) * v344) * ((-Math.expm1((v324 * v345))) / v326)))) / v344));
        v366.push((weight * v365));
      }
      v366 = (math.fsum(v366) * 1.0);
      v367 = (v323 * v366);
      v380 = (v323 - ((Math.log(v367) * v367) / ((Math.exp(v349) / (v326 * v332)) + ((v367 - 1.0) * ((v257 / v332) - (1.0 / v326))))));
      v381 = ((-2.0) * v380);
      v383 = (-Math.expm1(v381));
      v388 = (v210 - (v183 * Math.exp(((-2.0) * (((v380 < 300.0) || (v380 !== v380)) ? v380 : 300.0)))));
      v389 = (((v388 > 1.0) || (v388 !== v388)) ? v388 : 1.0);
      v391 = (1.0 / (v214 * v380));
      v406 = (v184 * v380);
      v423 = [];
      for ([node, weight] of RULE_0((1.0 / v391))) {
        v392 = (node * 1.0);
        v394 = ((v392 * v392) * v392);
        v396 = ((v394 * v394) * v392);
        v398 = (v396 * v392);
        v401 = (-Math.expm1((v381 * v398)));
        v402 = (1.0 - v398);
        v408 = Math.expm1((v406 * v398));
        v422 = ((8.0 * v396) * (((Math.exp((v380 * v402)) * Math.pow((v401 / v383), (-0.5))) * (v408 - (((v235 * (v408 + 1.0)) * v401) * ((-Math.expm1((v381 * v402))) / v383)))) / v401));
        v423.push((weight * v422));
      }
      v423 = (math.fsum(v423) * 1.0);
      v424 = (v380 * v423);
      v437 = (v380 - ((Math.log(v424) * v424) / ((Math.exp(v406) / (v383 * v389)) + ((v424 - 1.0) * ((v257 / v389) - (1.0 / v383))))));
      v438 = ((-2.0) * v437);
      v440 = (-Math.expm1(v438));
      v445 = (v210 - (v183 * Math.exp(((-2.0) * (((v437 < 300.0) || (v437 !== v437)) ? v437 : 300.0)))));
      v446 = (((v445 > 1.0) || (v445 !== v445)) ? v445 : 1.0);
      v448 = (1.0 / (v214 * v437));
      v463 = (v184 * v437);
      v480 = [];
      for ([node, weight] of RULE_0((1.0 / v448))) {
        v449 = (node * 1.0);
        v451 = ((v449 * v449) * v449);
        v453 = ((v451 * v451) * v449);
        v455 = (v453 * v449);
        v458 = (-Math.expm1((v438 * v455)));
        v459 = (1.0 - v455);
        v465 = Math.expm1((v463 * v455));
        v479 = ((8.0 * v453) * (((Math.exp((v437 * v459)) * Math.pow((v458 / v440), (-0.5))) * (v465 - (((v235 * (v465 + 1.0)) * v458) * ((-Math.expm1((v438 * v459))) / v440)))) / v458));
        v480.push((weight * v479));
      }
      v480 = (math.fsum(v480) * 1.0);
      v481 = (v437 * v480);
      v498 = (-Math.expm1(((-2.0) * (v437 - ((Math.log(v481) * v481) / ((Math.exp(v463) / (v440 * v446)) + ((v481 - 1.0) * ((v257 / v446) - (1.0 / v440)))))))));
    } else {
      v498 = 1.0;
    }
    if (((((((1.7724538509055159 * E_star) * n) * h) / ((2.0 * ((n * v498) - 1.0)) * ((((v136 < 1.0) ? ((v136 * (v136 + 1.0)) / v140) : (1.0 - ((v136 + 0.75) / v140))) * Math.sqrt(v137)) * (1.0 + (v152 * (((((((((((((0.01524698625788054 * v152) + 0.5334320651111477) * v152) + 2.250488865813539) * v152) + 2.8612106440066865) * v152) + 1.3794681629043655) * v152) + 0.2596058532893223) * v152) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v152) + 49.328555418276075) * v152) + 167.28648538571198) * v152) + 195.37226190335065) * v152) + 90.69722535867314) * v152) + 16.763212110504565) * v152) + 1.0))))))) * 0.999999999999999) <= P)) {
      if ((x >= a)) {
        if ((P > 0.0)) {
          v6 = (x - a);
          v9 = Math.sqrt((v6 * (a + x)));
          v19 = ((n + 1.0) / 2.0);
          v21 = (v19 + 1.75);
          v26 = ((v19 + 0.5) * (v19 + 1.5));
          v39 = (1.0 / (v21 * v21));
          if ((a > 0.0)) {
            v82 = (v6 / a);
            v89 = Math.sqrt((Number.isFinite(v82) ? Math.log1p(v82) : (Math.log(x) - Math.log(a))));
            v90 = (n + 2.0);
            v92 = (42.0 / v90);
            v97 = (v92 / (Math.sqrt(((v89 * v89) + v92)) + v89));
            v100 = (a / x);
            v110 = (-v90);
            v112 = (2.0 * v89);
            v121 = [];
            for ([node, weight] of RULE_1((v97 / 1.0))) {
              v103 = (node * v97);
              v104 = (v89 + v103);
              v109 = Math.sqrt((-Math.expm1((((-2.0) * v104) * v104))));
              v120 = ((Math.exp(((v110 * v103) * (v112 + v103))) * ((2.0 * v104) / v109)) / (1.0 + v109));
              v121.push((weight * v120));
            }
            v121 = (math.fsum(v121) * v97);
            v124 = (1.0 + ((n * (v100 * v100)) * v121));
          } else {
            v124 = 1.0;
          }
          return ((((-2.0) * P) / ((3.141592653589793 * E_star) * v9)) + (((n * h) * ((v124 / x) - (1.0 / v9))) / (1.7724538509055159 * ((((v19 < 1.0) ? ((v19 * (v19 + 1.0)) / v26) : (1.0 - ((v19 + 0.75) / v26))) * Math.sqrt(v21)) * (1.0 + (v39 * (((((((((((((0.01524698625788054 * v39) + 0.5334320651111477) * v39) + 2.250488865813539) * v39) + 2.8612106440066865) * v39) + 1.3794681629043655) * v39) + 0.2596058532893223) * v39) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v39) + 49.328555418276075) * v39) + 167.28648538571198) * v39) + 195.37226190335065) * v39) + 90.69722535867314) * v39) + 16.763212110504565) * v39) + 1.0))))))));
        }
        return 0.0;
      }
      return (-((((-n) * h) * ((x > 0.0) ? (Math.pow(x, n) / x) : Math.pow(x, (n - 1.0)))) / Math.pow(a, n)));
    }
    return NaN;
  }
  return _slope_of_concave_power(x, P, a, h, n, E_star);
};

const slope = (x, P, a, h, n, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (n > 1)))) {
    return NaN;
  }
  return (((((Math.abs(x) >= 0.0) && (P >= 0.0)) ? ((Math.abs(x) < Infinity) ? _slope(Math.abs(x), P, a, h, n, E_star) : 0.0) : NaN) * ((x < 0.0) ? -1.0 : 1.0)) + 0.0);
};

const _depth_of_concave_power = (L, P, a, h, n, E_star) => {
  let complete, face, kappa, result, root, strip, value;
  root = Math.sqrt(((L - a) * (a + L)));
  strip = (((2 * P) * Math.log1p((((L - a) + root) / a))) / (Math.PI * E_star));
  kappa = gamma_ratio(((n + 1) / 2));
  face = (((h * L) * power_strips(L, a, n)) / (Math.sqrt(Math.PI) * kappa));
  value = (strip - face);
  complete = ((_minimum_load(h, n, E_star) * (1.0 - 1e-15)) <= P);
  result = math.where((a <= L), value, NaN);
  return math.where(complete, result, NaN);
};

const _depth = (L, P, a, h, n, E_star) => {
  let node, v102, v105, v106, v112, v113, v115, v123, v124, v127, v135, v136, v139, v151, v180, v182, v183, v192, v198, v200, v201, v203, v209, v21, v211, v212, v213, v215, v216, v218, v220, v223, v226, v227, v23, v231, v233, v234, v249, v250, v251, v256, v265, v266, v268, v273, v274, v276, v277, v279, v28, v281, v283, v286, v287, v291, v293, v307, v308, v309, v322, v323, v325, v330, v331, v333, v334, v336, v338, v340, v343, v344, v348, v350, v364, v365, v366, v379, v380, v382, v387, v388, v390, v391, v393, v395, v397, v400, v401, v405, v407, v41, v421, v422, v423, v436, v437, v439, v444, v445, v447, v448, v450, v452, v454, v457, v458, v462, v464, v478, v479, v480, v497, v6, v84, v91, v92, v94, v99, weight;
  if (((L > 1e-30) && (L < 1e+30) && (P > 1e-30) && (P < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v135 = ((n / 2.0) + 0.5);
    v136 = (v135 + 1.75);
    v139 = ((v135 + 0.5) * (v135 + 1.5));
    v151 = (1.0 / (v136 * v136));
    v180 = (n > 2.0);
    if (v180) {
      v182 = (math.truth(v180) ? n : 3.0);
      v183 = (v182 - 2.0);
      v192 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v183) / (v183 + 0.72))) / v183));
      if ((v183 < 2.0)) {
        v198 = (Math.log(((v183 * (v183 + 2.0)) / 2.0)) / v183);
        v200 = (((v192 > v198) || (v192 !== v192)) ? v192 : v198);
      } else {
        v200 = v192;
      }
      v201 = ((-2.0) * v200);
      v203 = (-Math.expm1(v201));
      v209 = ((v182 - 1.0) + 0.0);
      v211 = (v209 - (v182 * Math.exp(((-2.0) * (((v200 < 300.0) || (v200 !== v200)) ? v200 : 300.0)))));
      v212 = (((v211 > 1.0) || (v211 !== v211)) ? v211 : 1.0);
      v213 = (v183 + 1.0);
      v215 = (1.0 / (v213 * v200));
      v231 = (v183 * v200);
      v234 = (0.5 * v183);
      v250 = [];
      for ([node, weight] of RULE_0((1.0 / v215))) {
        v216 = (node * 1.0);
        v218 = ((v216 * v216) * v216);
        v220 = ((v218 * v218) * v216);
        v223 = (v220 * v216);
        v226 = (-Math.expm1((v201 * v223)));
        v227 = (1.0 - v223);
        v233 = Math.expm1((v231 * v223));
        v249 = ((8.0 * v220) * (((Math.exp((v200 * v227)) * Math.pow((v226 / v203), (-0.5))) * (v233 - (((v234 * (v233 + 1.0)) * v226) * ((-Math.expm1((v201 * v227))) / v203)))) / v226));
        v250.push((weight * v249));
      }
      v250 = (math.fsum(v250) * 1.0);
      v251 = (v200 * v250);
      v256 = (2.0 * v209);
      v265 = (v200 - ((Math.log(v251) * v251) / ((Math.exp(v231) / (v203 * v212)) + ((v251 - 1.0) * ((v256 / v212) - (1.0 / v203))))));
      v266 = ((-2.0) * v265);
      v268 = (-Math.expm1(v266));
      v273 = (v209 - (v182 * Math.exp(((-2.0) * (((v265 < 300.0) || (v265 !== v265)) ? v265 : 300.0)))));
      v274 = (((v273 > 1.0) || (v273 !== v273)) ? v273 : 1.0);
      v276 = (1.0 / (v213 * v265));
      v291 = (v183 * v265);
      v308 = [];
      for ([node, weight] of RULE_0((1.0 / v276))) {
        v277 = (node * 1.0);
        v279 = ((v277 * v277) * v277);
        v281 = ((v279 * v279) * v277);
        v283 = (v281 * v277);
        v286 = (-Math.expm1((v266 * v283)));
        v287 = (1.0 - v283);
        v293 = Math.expm1((v291 * v283));
        v307 = ((8.0 * v281) * (((Math.exp((v265 * v287)) * Math.pow((v286 / v268), (-0.5))) * (v293 - (((v234 * (v293 + 1.0)) * v286) * ((-Math.expm1((v266 * v287))) / v268)))) / v286));
        v308.push((weight * v307));
      }
      v308 = (math.fsum(v308) * 1.0);
      v309 = (v265 * v308);
      v322 = (v265 - ((Math.log(v309) * v309) / ((Math.exp(v291) / (v268 * v274)) + ((v309 - 1.0) * ((v256 / v274) - (1.0 / v268))))));
      v323 = ((-2.0) * v322);
      v325 = (-Math.expm1(v323));
      v330 = (v209 - (v182 * Math.exp(((-2.0) * (((v322 < 300.0) || (v322 !== v322)) ? v322 : 300.0)))));
      v331 = (((v330 > 1.0) || (v330 !== v330)) ? v330 : 1.0);
      v333 = (1.0 / (v213 * v322));
      v348 = (v183 * v322);
      v365 = [];
      for ([node, weight] of RULE_0((1.0 / v333))) {
        v334 = (node * 1.0);
        v336 = ((v334 * v334) * v334);
        v338 = ((v336 * v336) * v334);
        v340 = (v338 * v334);
        v343 = (-Math.expm1((v323 * v340)));
        v344 = (1.0 - v340);
        v350 = Math.expm1((v348 * v340));
        v364 = ((8.0 * v338) * (((Math.exp((v322 * v344)) * Math.pow((v343 / v325), (-0.5))) * (v350 - (((v234 * (v350 + 1.0)) * v343) * ((-Math.expm1((v323 * v344))) / v325)))) / v343));
        v365.push((weight * v364));
      }
      v365 = (math.fsum(v365) * 1.0);
      v366 = (v322 * v365);
      v379 = (v322 - ((Math.log(v366) * v366) / ((Math.exp(v348) / (v325 * v331)) + ((v366 - 1.0) * ((v256 / v331) - (1.0 / v325))))));
      v380 = ((-2.0) * v379);
      v382 = (-Math.expm1(v380));
      v387 = (v209 - (v182 * Math.exp(((-2.0) * (((v379 < 300.0) || (v379 !== v379)) ? v379 : 300.0)))));
      v388 = (((v387 > 1.0) || (v387 !== v387)) ? v387 : 1.0);
      v390 = (1.0 / (v213 * v379));
      v405 = (v183 * v379);
      v422 = [];
      for ([node, weight] of RULE_0((1.0 / v390))) {
        v391 = (node * 1.0);
        v393 = ((v391 * v391) * v391);
        v395 = ((v393 * v393) * v391);
        v397 = (v395 * v391);
        v400 = (-Math.expm1((v380 * v397)));
        v401 = (1.0 - v397);
        v407 = Math.expm1((v405 * v397));
        v421 = ((8.0 * v395) * (((Math.exp((v379 * v401)) * Math.pow((v400 / v382), (-0.5))) * (v407 - (((v234 * (v407 + 1.0)) * v400) * ((-Math.expm1((v380 * v401))) / v382)))) / v400));
        v422.push((weight * v421));
      }
      v422 = (math.fsum(v422) * 1.0);
      v423 = (v379 * v422);
      v436 = (v379 - ((Math.log(v423) * v423) / ((Math.exp(v405) / (v382 * v388)) + ((v423 - 1.0) * ((v256 / v388) - (1.0 / v382))))));
      v437 = ((-2.0) * v436);
      v439 = (-Math.expm1(v437));
      v444 = (v209 - (v182 * Math.exp(((-2.0) * (((v436 < 300.0) || (v436 !== v436)) ? v436 : 300.0)))));
      v445 = (((v444 > 1.0) || (v444 !== v444)) ? v444 : 1.0);
      v447 = (1.0 / (v213 * v436));
      v462 = (v183 * v436);
      v479 = [];
      for ([node, weight] of RULE_0((1.0 / v447))) {
        v448 = (node * 1.0);
        v450 = ((v448 * v448) * v448);
        v452 = ((v450 * v450) * v448);
        v454 = (v452 * v448);
        v457 = (-Math.expm1((v437 * v454)));
        v458 = (1.0 - v454);
        v464 = Math.expm1((v462 * v454));
        v478 = ((8.0 * v452) * (((Math.exp((v436 * v458)) * Math.pow((v457 / v439), (-0.5))) * (v464 - (((v234 * (v464 + 1.0)) * v457) * ((-Math.expm1((v437 * v458))) / v439)))) / v457));
        v479.push((weight * v478));
      }
      v479 = (math.fsum(v479) * 1.0);
      v480 = (v436 * v479);
      v497 = (-Math.expm1(((-2.0) * (v436 - ((Math.log(v480) * v480) / ((Math.exp(v462) / (v439 * v445)) + ((v480 - 1.0) * ((v256 / v445) - (1.0 / v439)))))))));
    } else {
      v497 = 1.0;
    }
    if (((((((1.7724538509055159 * E_star) * n) * h) / ((2.0 * ((n * v497) - 1.0)) * ((((v135 < 1.0) ? ((v135 * (v135 + 1.0)) / v139) : (1.0 - ((v135 + 0.75) / v139))) * Math.sqrt(v136)) * (1.0 + (v151 * (((((((((((((0.01524698625788054 * v151) + 0.5334320651111477) * v151) + 2.250488865813539) * v151) + 2.8612106440066865) * v151) + 1.3794681629043655) * v151) + 0.2596058532893223) * v151) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v151) + 49.328555418276075) * v151) + 167.28648538571198) * v151) + 195.37226190335065) * v151) + 90.69722535867314) * v151) + 16.763212110504565) * v151) + 1.0))))))) * 0.999999999999999) <= P)) {
      if ((a <= L)) {
        v6 = (L - a);
        v21 = ((n + 1.0) / 2.0);
        v23 = (v21 + 1.75);
        v28 = ((v21 + 0.5) * (v21 + 1.5));
        v41 = (1.0 / (v23 * v23));
        if ((a > 0.0)) {
          v84 = (v6 / a);
          v91 = Math.sqrt((Number.isFinite(v84) ? Math.log1p(v84) : (Math.log(L) - Math.log(a))));
          v92 = (n + 2.0);
          v94 = (42.0 / v92);
          v99 = (v94 / (Math.sqrt(((v91 * v91) + v94)) + v91));
          v102 = (a / L);
          v113 = (-v92);
          v115 = (2.0 * v91);
          v124 = [];
          for ([node, weight] of RULE_1((v99 / 1.0))) {
            v105 = (node * v99);
            v106 = (v91 + v105);
            v112 = Math.sqrt((-Math.expm1((((-2.0) * v106) * v106))));
            v123 = ((Math.exp(((v113 * v105) * (v115 + v105))) * ((2.0 * v106) / v112)) / (1.0 + v112));
            v124.push((weight * v123));
          }
          v124 = (math.fsum(v124) * v99);
          v127 = (1.0 + ((n * (v102 * v102)) * v124));
        } else {
          v127 = 1.0;
        }
        return ((((2.0 * P) * Math.log1p(((v6 + Math.sqrt((v6 * (a + L)))) / a))) / (3.141592653589793 * E_star)) - (((h * L) * (v127 / L)) / (1.7724538509055159 * ((((v21 < 1.0) ? ((v21 * (v21 + 1.0)) / v28) : (1.0 - ((v21 + 0.75) / v28))) * Math.sqrt(v23)) * (1.0 + (v41 * (((((((((((((0.01524698625788054 * v41) + 0.5334320651111477) * v41) + 2.250488865813539) * v41) + 2.8612106440066865) * v41) + 1.3794681629043655) * v41) + 0.2596058532893223) * v41) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v41) + 49.328555418276075) * v41) + 167.28648538571198) * v41) + 195.37226190335065) * v41) + 90.69722535867314) * v41) + 16.763212110504565) * v41) + 1.0))))))));
      }
      return NaN;
    }
    return NaN;
  }
  return _depth_of_concave_power(L, P, a, h, n, E_star);
};

const depth = (L, P, a, h, n, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (n > 1)))) {
    return NaN;
  }
  return (((L >= 0.0) && (P >= 0.0)) ? _depth(L, P, a, h, n, E_star) : NaN);
};

const ring_of_zero_pressure = (n, k = 0.0) => {
  return math.where((n > 2.0), Math.exp((-_log_ratio_of_ring(n, k))), 0.0);
};

const _zero_distance_of_concave_power = (a, n) => {
  return (a * ring_of_zero_pressure(n));
};

const _zero_distance = (a, n, h = 1.0) => {
  let node, v100, v101, v103, v104, v106, v108, v110, v113, v114, v118, v120, v134, v135, v136, v149, v15, v150, v152, v157, v158, v160, v161, v163, v165, v167, v170, v171, v175, v177, v191, v192, v193, v206, v207, v209, v214, v215, v217, v218, v22, v220, v222, v224, v227, v228, v232, v234, v24, v248, v249, v250, v26, v263, v264, v266, v271, v272, v274, v275, v277, v279, v28, v281, v284, v285, v289, v291, v3, v305, v306, v307, v323, v35, v37, v38, v39, v41, v42, v44, v46, v49, v5, v52, v53, v57, v59, v6, v61, v76, v77, v78, v83, v92, v93, v95, weight;
  if (((a > 1e-30) && (a < 1e+30) && (n > 1e-30) && (n < 1e+30) && (h > 1e-30) && (h < 1e+30))) {
    v3 = (n > 2.0);
    if (v3) {
      v5 = (math.truth(v3) ? n : 3.0);
      v6 = (v5 - 2.0);
      v15 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v6) / (v6 + 0.72))) / v6));
      if ((v6 < 2.0)) {
        v22 = (Math.log(((v6 * (v6 + 2.0)) / 2.0)) / v6);
        v24 = (((v15 > v22) || (v15 !== v15)) ? v15 : v22);
      } else {
        v24 = v15;
      }
      v26 = ((-2.0) * v24);
      v28 = (-Math.expm1(v26));
      v35 = ((v5 - 1.0) + 0.0);
      v37 = (v35 - (v5 * Math.exp(((-2.0) * (((v24 < 300.0) || (v24 !== v24)) ? v24 : 300.0)))));
      v38 = (((v37 > 1.0) || (v37 !== v37)) ? v37 : 1.0);
      v39 = (v6 + 1.0);
      v41 = (1.0 / (v39 * v24));
      v57 = (v6 * v24);
      v61 = (0.5 * v6);
      v77 = [];
      for ([node, weight] of RULE_0((1.0 / v41))) {
        v42 = (node * 1.0);
        v44 = ((v42 * v42) * v42);
        v46 = ((v44 * v44) * v42);
        v49 = (v46 * v42);
        v52 = (-Math.expm1((v26 * v49)));
        v53 = (1.0 - v49);
        v59 = Math.expm1((v57 * v49));
        v76 = ((8.0 * v46) * (((Math.exp((v24 * v53)) * Math.pow((v52 / v28), (-0.5))) * (v59 - (((v61 * (v59 + 1.0)) * v52) * ((-Math.expm1((v26 * v53))) / v28)))) / v52));
        v77.push((weight * v76));
      }
      v77 = (math.fsum(v77) * 1.0);
      v78 = (v24 * v77);
      v83 = (2.0 * v35);
      v92 = (v24 - ((Math.log(v78) * v78) / ((Math.exp(v57) / (v28 * v38)) + ((v78 - 1.0) * ((v83 / v38) - (1.0 / v28))))));
      v93 = ((-2.0) * v92);
      v95 = (-Math.expm1(v93));
      v100 = (v35 - (v5 * Math.exp(((-2.0) * (((v92 < 300.0) || (v92 !== v92)) ? v92 : 300.0)))));
      v101 = (((v100 > 1.0) || (v100 !== v100)) ? v100 : 1.0);
      v103 = (1.0 / (v39 * v92));
      v118 = (v6 * v92);
      v135 = [];
      for ([node, weight] of RULE_0((1.0 / v103))) {
        v104 = (node * 1.0);
        v106 = ((v104 * v104) * v104);
        v108 = ((v106 * v106) * v104);
        v110 = (v108 * v104);
        v113 = (-Math.expm1((v93 * v110)));
        v114 = (1.0 - v110);
        v120 = Math.expm1((v118 * v110));
        v134 = ((8.0 * v108) * (((Math.exp((v92 * v114)) * Math.pow((v113 / v95), (-0.5))) * (v120 - (((v61 * (v120 + 1.0)) * v113) * ((-Math.expm1((v93 * v114))) / v95)))) / v113));
        v135.push((weight * v134));
      }
      v135 = (math.fsum(v135) * 1.0);
      v136 = (v92 * v135);
      v149 = (v92 - ((Math.log(v136) * v136) / ((Math.exp(v118) / (v95 * v101)) + ((v136 - 1.0) * ((v83 / v101) - (1.0 / v95))))));
      v150 = ((-2.0) * v149);
      v152 = (-Math.expm1(v150));
      v157 = (v35 - (v5 * Math.exp(((-2.0) * (((v149 < 300.0) || (v149 !== v149)) ? v149 : 300.0)))));
      v158 = (((v157 > 1.0) || (v157 !== v157)) ? v157 : 1.0);
      v160 = (1.0 / (v39 * v149));
      v175 = (v6 * v149);
      v192 = [];
      for ([node, weight] of RULE_0((1.0 / v160))) {
        v161 = (node * 1.0);
        v163 = ((v161 * v161) * v161);
        v165 = ((v163 * v163) * v161);
        v167 = (v165 * v161);
        v170 = (-Math.expm1((v150 * v167)));
        v171 = (1.0 - v167);
        v177 = Math.expm1((v175 * v167));
        v191 = ((8.0 * v165) * (((Math.exp((v149 * v171)) * Math.pow((v170 / v152), (-0.5))) * (v177 - (((v61 * (v177 + 1.0)) * v170) * ((-Math.expm1((v150 * v171))) / v152)))) / v170));
        v192.push((weight * v191));
      }
      v192 = (math.fsum(v192) * 1.0);
      v193 = (v149 * v192);
      v206 = (v149 - ((Math.log(v193) * v193) / ((Math.exp(v175) / (v152 * v158)) + ((v193 - 1.0) * ((v83 / v158) - (1.0 / v152))))));
      v207 = ((-2.0) * v206);
      v209 = (-Math.expm1(v207));
      v214 = (v35 - (v5 * Math.exp(((-2.0) * (((v206 < 300.0) || (v206 !== v206)) ? v206 : 300.0)))));
      v215 = (((v214 > 1.0) || (v214 !== v214)) ? v214 : 1.0);
      v217 = (1.0 / (v39 * v206));
      v232 = (v6 * v206);
      v249 = [];
      for ([node, weight] of RULE_0((1.0 / v217))) {
        v218 = (node * 1.0);
        v220 = ((v218 * v218) * v218);
        v222 = ((v220 * v220) * v218);
        v224 = (v222 * v218);
        v227 = (-Math.expm1((v207 * v224)));
        v228 = (1.0 - v224);
        v234 = Math.expm1((v232 * v224));
        v248 = ((8.0 * v222) * (((Math.exp((v206 * v228)) * Math.pow((v227 / v209), (-0.5))) * (v234 - (((v61 * (v234 + 1.0)) * v227) * ((-Math.expm1((v207 * v228))) / v209)))) / v227));
        v249.push((weight * v248));
      }
      v249 = (math.fsum(v249) * 1.0);
      v250 = (v206 * v249);
      v263 = (v206 - ((Math.log(v250) * v250) / ((Math.exp(v232) / (v209 * v215)) + ((v250 - 1.0) * ((v83 / v215) - (1.0 / v209))))));
      v264 = ((-2.0) * v263);
      v266 = (-Math.expm1(v264));
      v271 = (v35 - (v5 * Math.exp(((-2.0) * (((v263 < 300.0) || (v263 !== v263)) ? v263 : 300.0)))));
      v272 = (((v271 > 1.0) || (v271 !== v271)) ? v271 : 1.0);
      v274 = (1.0 / (v39 * v263));
      v289 = (v6 * v263);
      v306 = [];
      for ([node, weight] of RULE_0((1.0 / v274))) {
        v275 = (node * 1.0);
        v277 = ((v275 * v275) * v275);
        v279 = ((v277 * v277) * v275);
        v281 = (v279 * v275);
        v284 = (-Math.expm1((v264 * v281)));
        v285 = (1.0 - v281);
        v291 = Math.expm1((v289 * v281));
        v305 = ((8.0 * v279) * (((Math.exp((v263 * v285)) * Math.pow((v284 / v266), (-0.5))) * (v291 - (((v61 * (v291 + 1.0)) * v284) * ((-Math.expm1((v264 * v285))) / v266)))) / v284));
        v306.push((weight * v305));
      }
      v306 = (math.fsum(v306) * 1.0);
      v307 = (v263 * v306);
      v323 = Math.exp((-(v263 - ((Math.log(v307) * v307) / ((Math.exp(v289) / (v266 * v272)) + ((v307 - 1.0) * ((v83 / v272) - (1.0 / v266))))))));
    } else {
      v323 = 0.0;
    }
    return (a * v323);
  }
  return _zero_distance_of_concave_power(a, n);
};

const zero_distance = (a, h, n) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (n > 1)))) {
    return NaN;
  }
  return _zero_distance(a, n);
};

const _minimum_load_of_concave_power = (h, n, E_star, a = 1.0) => {
  let node, v101, v102, v103, v105, v106, v108, v110, v113, v116, v117, v12, v121, v123, v124, v139, v140, v141, v146, v155, v156, v158, v163, v164, v166, v167, v169, v171, v173, v176, v177, v181, v183, v197, v198, v199, v212, v213, v215, v220, v221, v223, v224, v226, v228, v230, v233, v234, v238, v240, v254, v255, v256, v26, v269, v270, v272, v277, v278, v280, v281, v283, v285, v287, v290, v291, v295, v297, v311, v312, v313, v326, v327, v329, v334, v335, v337, v338, v340, v342, v344, v347, v348, v352, v354, v368, v369, v370, v387, v6, v68, v70, v71, v8, v80, v86, v88, v90, v92, v99, weight;
  if (((h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (a > 1e-30) && (a < 1e+30))) {
    v6 = ((n / 2.0) + 0.5);
    v8 = (v6 + 1.75);
    v12 = ((v6 + 0.5) * (v6 + 1.5));
    v26 = (1.0 / (v8 * v8));
    v68 = (n > 2.0);
    if (v68) {
      v70 = (math.truth(v68) ? n : 3.0);
      v71 = (v70 - 2.0);
      v80 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v71) / (v71 + 0.72))) / v71));
      if ((v71 < 2.0)) {
        v86 = (Math.log(((v71 * (v71 + 2.0)) / 2.0)) / v71);
        v88 = (((v80 > v86) || (v80 !== v80)) ? v80 : v86);
      } else {
        v88 = v80;
      }
      v90 = ((-2.0) * v88);
      v92 = (-Math.expm1(v90));
      v99 = ((v70 - 1.0) + 0.0);
      v101 = (v99 - (v70 * Math.exp(((-2.0) * (((v88 < 300.0) || (v88 !== v88)) ? v88 : 300.0)))));
      v102 = (((v101 > 1.0) || (v101 !== v101)) ? v101 : 1.0);
      v103 = (v71 + 1.0);
      v105 = (1.0 / (v103 * v88));
      v121 = (v71 * v88);
      v124 = (0.5 * v71);
      v140 = [];
      for ([node, weight] of RULE_0((1.0 / v105))) {
        v106 = (node * 1.0);
        v108 = ((v106 * v106) * v106);
        v110 = ((v108 * v108) * v106);
        v113 = (v110 * v106);
        v116 = (-Math.expm1((v90 * v113)));
        v117 = (1.0 - v113);
        v123 = Math.expm1((v121 * v113));
        v139 = ((8.0 * v110) * (((Math.exp((v88 * v117)) * Math.pow((v116 / v92), (-0.5))) * (v123 - (((v124 * (v123 + 1.0)) * v116) * ((-Math.expm1((v90 * v117))) / v92)))) / v116));
        v140.push((weight * v139));
      }
      v140 = (math.fsum(v140) * 1.0);
      v141 = (v88 * v140);
      v146 = (2.0 * v99);
      v155 = (v88 - ((Math.log(v141) * v141) / ((Math.exp(v121) / (v92 * v102)) + ((v141 - 1.0) * ((v146 / v102) - (1.0 / v92))))));
      v156 = ((-2.0) * v155);
      v158 = (-Math.expm1(v156));
      v163 = (v99 - (v70 * Math.exp(((-2.0) * (((v155 < 300.0) || (v155 !== v155)) ? v155 : 300.0)))));
      v164 = (((v163 > 1.0) || (v163 !== v163)) ? v163 : 1.0);
      v166 = (1.0 / (v103 * v155));
      v181 = (v71 * v155);
      v198 = [];
      for ([node, weight] of RULE_0((1.0 / v166))) {
        v167 = (node * 1.0);
        v169 = ((v167 * v167) * v167);
        v171 = ((v169 * v169) * v167);
        v173 = (v171 * v167);
        v176 = (-Math.expm1((v156 * v173)));
        v177 = (1.0 - v173);
        v183 = Math.expm1((v181 * v173));
        v197 = ((8.0 * v171) * (((Math.exp((v155 * v177)) * Math.pow((v176 / v158), (-0.5))) * (v183 - (((v124 * (v183 + 1.0)) * v176) * ((-Math.expm1((v156 * v177))) / v158)))) / v176));
        v198.push((weight * v197));
      }
      v198 = (math.fsum(v198) * 1.0);
      v199 = (v155 * v198);
      v212 = (v155 - ((Math.log(v199) * v199) / ((Math.exp(v181) / (v158 * v164)) + ((v199 - 1.0) * ((v146 / v164) - (1.0 / v158))))));
      v213 = ((-2.0) * v212);
      v215 = (-Math.expm1(v213));
      v220 = (v99 - (v70 * Math.exp(((-2.0) * (((v212 < 300.0) || (v212 !== v212)) ? v212 : 300.0)))));
      v221 = (((v220 > 1.0) || (v220 !== v220)) ? v220 : 1.0);
      v223 = (1.0 / (v103 * v212));
      v238 = (v71 * v212);
      v255 = [];
      for ([node, weight] of RULE_0((1.0 / v223))) {
        v224 = (node * 1.0);
        v226 = ((v224 * v224) * v224);
        v228 = ((v226 * v226) * v224);
        v230 = (v228 * v224);
        v233 = (-Math.expm1((v213 * v230)));
        v234 = (1.0 - v230);
        v240 = Math.expm1((v238 * v230));
        v254 = ((8.0 * v228) * (((Math.exp((v212 * v234)) * Math.pow((v233 / v215), (-0.5))) * (v240 - (((v124 * (v240 + 1.0)) * v233) * ((-Math.expm1((v213 * v234))) / v215)))) / v233));
        v255.push((weight * v254));
      }
      v255 = (math.fsum(v255) * 1.0);
      v256 = (v212 * v255);
      v269 = (v212 - ((Math.log(v256) * v256) / ((Math.exp(v238) / (v215 * v221)) + ((v256 - 1.0) * ((v146 / v221) - (1.0 / v215))))));
      v270 = ((-2.0) * v269);
      v272 = (-Math.expm1(v270));
      v277 = (v99 - (v70 * Math.exp(((-2.0) * (((v269 < 300.0) || (v269 !== v269)) ? v269 : 300.0)))));
      v278 = (((v277 > 1.0) || (v277 !== v277)) ? v277 : 1.0);
      v280 = (1.0 / (v103 * v269));
      v295 = (v71 * v269);
      v312 = [];
      for ([node, weight] of RULE_0((1.0 / v280))) {
        v281 = (node * 1.0);
        v283 = ((v281 * v281) * v281);
        v285 = ((v283 * v283) * v281);
        v287 = (v285 * v281);
        v290 = (-Math.expm1((v270 * v287)));
        v291 = (1.0 - v287);
        v297 = Math.expm1((v295 * v287));
        v311 = ((8.0 * v285) * (((Math.exp((v269 * v291)) * Math.pow((v290 / v272), (-0.5))) * (v297 - (((v124 * (v297 + 1.0)) * v290) * ((-Math.expm1((v270 * v291))) / v272)))) / v290));
        v312.push((weight * v311));
      }
      v312 = (math.fsum(v312) * 1.0);
      v313 = (v269 * v312);
      v326 = (v269 - ((Math.log(v313) * v313) / ((Math.exp(v295) / (v272 * v278)) + ((v313 - 1.0) * ((v146 / v278) - (1.0 / v272))))));
      v327 = ((-2.0) * v326);
      v329 = (-Math.expm1(v327));
      v334 = (v99 - (v70 * Math.exp(((-2.0) * (((v326 < 300.0) || (v326 !== v326)) ? v326 : 300.0)))));
      v335 = (((v334 > 1.0) || (v334 !== v334)) ? v334 : 1.0);
      v337 = (1.0 / (v103 * v326));
      v352 = (v71 * v326);
      v369 = [];
      for ([node, weight] of RULE_0((1.0 / v337))) {
        v338 = (node * 1.0);
        v340 = ((v338 * v338) * v338);
        v342 = ((v340 * v340) * v338);
        v344 = (v342 * v338);
        v347 = (-Math.expm1((v327 * v344)));
        v348 = (1.0 - v344);
        v354 = Math.expm1((v352 * v344));
        v368 = ((8.0 * v342) * (((Math.exp((v326 * v348)) * Math.pow((v347 / v329), (-0.5))) * (v354 - (((v124 * (v354 + 1.0)) * v347) * ((-Math.expm1((v327 * v348))) / v329)))) / v347));
        v369.push((weight * v368));
      }
      v369 = (math.fsum(v369) * 1.0);
      v370 = (v326 * v369);
      v387 = (-Math.expm1(((-2.0) * (v326 - ((Math.log(v370) * v370) / ((Math.exp(v352) / (v329 * v335)) + ((v370 - 1.0) * ((v146 / v335) - (1.0 / v329)))))))));
    } else {
      v387 = 1.0;
    }
    return ((((1.7724538509055159 * E_star) * n) * h) / ((2.0 * ((n * v387) - 1.0)) * ((((v6 < 1.0) ? ((v6 * (v6 + 1.0)) / v12) : (1.0 - ((v6 + 0.75) / v12))) * Math.sqrt(v8)) * (1.0 + (v26 * (((((((((((((0.01524698625788054 * v26) + 0.5334320651111477) * v26) + 2.250488865813539) * v26) + 2.8612106440066865) * v26) + 1.3794681629043655) * v26) + 0.2596058532893223) * v26) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v26) + 49.328555418276075) * v26) + 167.28648538571198) * v26) + 195.37226190335065) * v26) + 90.69722535867314) * v26) + 16.763212110504565) * v26) + 1.0)))))));
  }
  return _minimum_load(h, n, E_star);
};

const minimum_load = (a, h, n, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (n > 1)))) {
    return NaN;
  }
  return _minimum_load_of_concave_power(h, n, E_star);
};

const once = {  };
const formulas = {
  "p": (v) => pressure(v.x, v.P, v.a, v.h, v.n, v.E_star),
  "s": (v) => slope(v.x, v.P, v.a, v.h, v.n, v.E_star),
  "d": (v) => depth(v.L, v.P, v.a, v.h, v.n, v.E_star),
  "xz": (v) => zero_distance(v.a, v.h, v.n),
  "Pmin": (v) => minimum_load(v.a, v.h, v.n, v.E_star),
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
   "value": 1e-06
  },
  {
   "name": "n",
   "tex": "n",
   "meaning": "exponent of the profile",
   "unit": "1",
   "rule": "n > 0",
   "low": 0.0,
   "high": null,
   "closed": "",
   "value": 3.0
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
   "value": 1000000.0
  }
 ],
 "formulas": {
  "p": {
   "gives": "p",
   "needs": [
    "x",
    "P",
    "a",
    "h",
    "n",
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
    "P",
    "a",
    "h",
    "n",
    "E_star"
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
    "P",
    "a",
    "h",
    "n",
    "E_star"
   ],
   "unit": "m",
   "place": "",
   "suffix": "d",
   "medium": 0
  },
  "xz": {
   "gives": "x_zero",
   "needs": [
    "a",
    "h",
    "n"
   ],
   "unit": "m",
   "place": "",
   "suffix": "xz",
   "medium": 0
  },
  "Pmin": {
   "gives": "P",
   "needs": [
    "a",
    "h",
    "n",
    "E_star"
   ],
   "unit": "N/m",
   "place": "",
   "suffix": "Pmin",
   "medium": 0
  }
 },
 "place": "x"
}, evaluate: formulas };
})();
