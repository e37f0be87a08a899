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

const _depth = (a, A, n) => {
  let v12, v26, v6, v8;
  v6 = ((n / 2.0) + 0.5);
  v8 = (v6 + 1.75);
  v12 = ((v6 + 0.5) * (v6 + 1.5));
  v26 = (1.0 / (v8 * v8));
  return (((1.7724538509055159 * A) * Math.pow(a, n)) * ((((v6 < 1.0) ? ((v6 * (v6 + 1.0)) / v12) : (1.0 - ((v6 + 0.75) / v12))) * math.sqrt(v8)) * (1.0 + (v26 * (((((((((((((0.01524698625788054 * v26) + 0.5334320651111477) * v26) + 2.250488865813539) * v26) + 2.8612106440066865) * v26) + 1.3794681629043655) * v26) + 0.2596058532893223) * v26) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v26) + 49.328555418276075) * v26) + 167.28648538571198) * v26) + 195.37226190335065) * v26) + 90.69722535867314) * v26) + 16.763212110504565) * v26) + 1.0))))));
};

const depth = (a, A, n) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth(a, A, n) : NaN);
};

const _force = (a, A, n, E_star) => {
  let v13, v27, v7, v9;
  v7 = ((n / 2.0) + 0.5);
  v9 = (v7 + 1.75);
  v13 = ((v7 + 0.5) * (v7 + 1.5));
  v27 = (1.0 / (v9 * v9));
  return (((((((3.5449077018110318 * E_star) * n) * A) / (n + 1.0)) * a) * Math.pow(a, n)) * ((((v7 < 1.0) ? ((v7 * (v7 + 1.0)) / v13) : (1.0 - ((v7 + 0.75) / v13))) * math.sqrt(v9)) * (1.0 + (v27 * (((((((((((((0.01524698625788054 * v27) + 0.5334320651111477) * v27) + 2.250488865813539) * v27) + 2.8612106440066865) * v27) + 1.3794681629043655) * v27) + 0.2596058532893223) * v27) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v27) + 49.328555418276075) * v27) + 167.28648538571198) * v27) + 195.37226190335065) * v27) + 90.69722535867314) * v27) + 16.763212110504565) * v27) + 1.0))))));
};

const force = (a, A, n, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force(a, A, n, E_star) : NaN);
};

const RULE_1 = math.rule([[16.0, 64], [Infinity, 128]]);

const RULE_0 = math.rule([[16.0, 64], [Infinity, 128]]);

const _pressure_of_power_law = (r, a, A, n, E_star) => {
  let node, v10, v100, v105, v106, v107, v112, v114, v115, v120, v123, v125, v134, v135, v136, v138, v14, v28, v78, v8, v82, v83, v94, weight;
  if ((r < a)) {
    v8 = ((n / 2.0) + 0.5);
    v10 = (v8 + 1.75);
    v14 = ((v8 + 0.5) * (v8 + 1.5));
    v28 = (1.0 / (v10 * v10));
    v78 = (n - 1.0);
    v82 = (n > 1.0);
    v83 = Math.abs(v78);
    if ((r > 0.0)) {
      v94 = ((a - r) / r);
      v100 = (Number.isFinite(v94) ? math.log1p(v94) : (math.log(a) - math.log(r)));
      if ((v100 > 0.0)) {
        v105 = (v100 - (42.0 / (((v83 > 0.001) || (v83 !== v83)) ? v83 : 0.001)));
        v106 = (((v105 > 0.0) || (v105 !== v105)) ? v105 : 0.0);
        v107 = math.sqrt(v100);
        v112 = (math.truth(v82) ? (v107 - math.sqrt(v106)) : math.sqrt((v100 - v106)));
        v115 = (2.0 * v107);
        v120 = (-v83);
        v135 = [];
        for ([node, weight] of RULE_0((v112 / 1.0))) {
          v114 = (node * v112);
          if (v82) {
            v123 = (v107 - v114);
            v125 = (((v123 > 0.0) || (v123 !== v123)) ? v123 : 0.0);
          } else {
            v125 = v114;
          }
          v134 = (Math.exp((v120 * (math.truth(v82) ? (v114 * (v115 - v114)) : (v114 * v114)))) * ((2.0 * v125) / math.sqrt((-Math.expm1((((-2.0) * v125) * v125))))));
          v135.push((weight * v134));
        }
        v135 = (math.fsum(v135) * v112);
        v136 = v135;
      } else {
        v136 = 0.0;
      }
      v138 = ((math.truth(v82) ? 1.0 : (Math.pow((r / a), n) * (a / r))) * v136);
    } else {
      v138 = (math.truth(v82) ? (1.0 / v83) : Infinity);
    }
    return ((((((E_star * n) * A) / 1.7724538509055159) * ((a > 0.0) ? (Math.pow(a, n) / a) : Math.pow(a, v78))) * v138) * ((((v8 < 1.0) ? ((v8 * (v8 + 1.0)) / v14) : (1.0 - ((v8 + 0.75) / v14))) * math.sqrt(v10)) * (1.0 + (v28 * (((((((((((((0.01524698625788054 * v28) + 0.5334320651111477) * v28) + 2.250488865813539) * v28) + 2.8612106440066865) * v28) + 1.3794681629043655) * v28) + 0.2596058532893223) * v28) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v28) + 49.328555418276075) * v28) + 167.28648538571198) * v28) + 195.37226190335065) * v28) + 90.69722535867314) * v28) + 16.763212110504565) * v28) + 1.0))))));
  }
  return 0.0;
};

const _pressure = (r, a, A, n, E_star) => {
  let node, v10, v100, v105, v106, v107, v112, v114, v115, v120, v123, v125, v134, v135, v136, v138, v14, v28, v78, v8, v82, v83, v94, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((r < a)) {
      v8 = ((n / 2.0) + 0.5);
      v10 = (v8 + 1.75);
      v14 = ((v8 + 0.5) * (v8 + 1.5));
      v28 = (1.0 / (v10 * v10));
      v78 = (n - 1.0);
      v82 = (n > 1.0);
      v83 = Math.abs(v78);
      if ((r > 0.0)) {
        v94 = ((a - r) / r);
        v100 = (Number.isFinite(v94) ? Math.log1p(v94) : (Math.log(a) - Math.log(r)));
        if ((v100 > 0.0)) {
          v105 = (v100 - (42.0 / (((v83 > 0.001) || (v83 !== v83)) ? v83 : 0.001)));
          v106 = (((v105 > 0.0) || (v105 !== v105)) ? v105 : 0.0);
          v107 = Math.sqrt(v100);
          v112 = (math.truth(v82) ? (v107 - Math.sqrt(v106)) : Math.sqrt((v100 - v106)));
          v115 = (2.0 * v107);
          v120 = (-v83);
          v135 = [];
          for ([node, weight] of RULE_1((v112 / 1.0))) {
            v114 = (node * v112);
            if (v82) {
              v123 = (v107 - v114);
              v125 = (((v123 > 0.0) || (v123 !== v123)) ? v123 : 0.0);
            } else {
              v125 = v114;
            }
            v134 = (Math.exp((v120 * (math.truth(v82) ? (v114 * (v115 - v114)) : (v114 * v114)))) * ((2.0 * v125) / Math.sqrt((-Math.expm1((((-2.0) * v125) * v125))))));
            v135.push((weight * v134));
          }
          v135 = (math.fsum(v135) * v112);
          v136 = v135;
        } else {
          v136 = 0.0;
        }
        v138 = ((math.truth(v82) ? 1.0 : (Math.pow((r / a), n) * (a / r))) * v136);
      } else {
        v138 = (math.truth(v82) ? (1.0 / v83) : Infinity);
      }
      return ((((((E_star * n) * A) / 1.7724538509055159) * ((a > 0.0) ? (Math.pow(a, n) / a) : Math.pow(a, v78))) * v138) * ((((v8 < 1.0) ? ((v8 * (v8 + 1.0)) / v14) : (1.0 - ((v8 + 0.75) / v14))) * Math.sqrt(v10)) * (1.0 + (v28 * (((((((((((((0.01524698625788054 * v28) + 0.5334320651111477) * v28) + 2.250488865813539) * v28) + 2.8612106440066865) * v28) + 1.3794681629043655) * v28) + 0.2596058532893223) * v28) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v28) + 49.328555418276075) * v28) + 167.28648538571198) * v28) + 195.37226190335065) * v28) + 90.69722535867314) * v28) + 16.763212110504565) * v28) + 1.0))))));
    }
    return 0.0;
  }
  return _pressure_of_power_law(r, a, A, n, E_star);
};

const pressure = (r, a, A, n, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure(r, a, A, n, E_star) : 0.0) : NaN);
};

const RULE_0_of_power_law = math.rule([[Infinity, 64]]);

const RULE_1_of_power_law = math.rule([[Infinity, 64]]);

const _displacement_of_power_law = (r, a, A, n) => {
  let node, v109, v114, v115, v117, v13, v27, v68, v7, v72, v75, v82, v85, v9, v90, v93, v94, v95, v97, v98, weight;
  v7 = ((n / 2.0) + 0.5);
  v9 = (v7 + 1.75);
  v13 = ((v7 + 0.5) * (v7 + 1.5));
  v27 = (1.0 / (v9 * v9));
  v68 = ((((v7 < 1.0) ? ((v7 * (v7 + 1.0)) / v13) : (1.0 - ((v7 + 0.75) / v13))) * math.sqrt(v9)) * (1.0 + (v27 * (((((((((((((0.01524698625788054 * v27) + 0.5334320651111477) * v27) + 2.250488865813539) * v27) + 2.8612106440066865) * v27) + 1.3794681629043655) * v27) + 0.2596058532893223) * v27) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v27) + 49.328555418276075) * v27) + 167.28648538571198) * v27) + 195.37226190335065) * v27) + 90.69722535867314) * v27) + 16.763212110504565) * v27) + 1.0)))));
  v72 = Math.pow(a, n);
  if ((r > a)) {
    if ((a > 0.0)) {
      v75 = ((r - a) / a);
      v82 = math.sqrt((Number.isFinite(v75) ? math.log1p(v75) : (math.log(r) - math.log(a))));
      v85 = (42.0 / (n + 1.0));
      v90 = (v85 / (math.sqrt(((v82 * v82) + v85)) + v82));
      v95 = (2.0 * v82);
      v98 = (a / r);
      v109 = (-n);
      v115 = [];
      for ([node, weight] of RULE_1_of_power_law((v90 / 1.0))) {
        v93 = (node * v90);
        v94 = (v82 + v93);
        v97 = (v93 * (v95 + v93));
        v114 = (((Math.atan2((v98 * Math.exp((-v97))), math.sqrt((-Math.expm1((((-2.0) * v94) * v94))))) * Math.exp((v109 * v97))) * 2.0) * v94);
        v115.push((weight * v114));
      }
      v115 = (math.fsum(v115) * v90);
      v117 = (n * v115);
    } else {
      v117 = 0.0;
    }
    return (((((2.0 * A) / 1.7724538509055159) * v72) * v117) * v68);
  }
  return ((((1.7724538509055159 * A) * v72) * v68) - (A * Math.pow(r, n)));
};

const _displacement = (r, a, A, n) => {
  let node, v109, v114, v115, v117, v13, v27, v68, v7, v72, v75, v82, v85, v9, v90, v93, v94, v95, v97, v98, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30))) {
    v7 = ((n / 2.0) + 0.5);
    v9 = (v7 + 1.75);
    v13 = ((v7 + 0.5) * (v7 + 1.5));
    v27 = (1.0 / (v9 * v9));
    v68 = ((((v7 < 1.0) ? ((v7 * (v7 + 1.0)) / v13) : (1.0 - ((v7 + 0.75) / v13))) * Math.sqrt(v9)) * (1.0 + (v27 * (((((((((((((0.01524698625788054 * v27) + 0.5334320651111477) * v27) + 2.250488865813539) * v27) + 2.8612106440066865) * v27) + 1.3794681629043655) * v27) + 0.2596058532893223) * v27) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v27) + 49.328555418276075) * v27) + 167.28648538571198) * v27) + 195.37226190335065) * v27) + 90.69722535867314) * v27) + 16.763212110504565) * v27) + 1.0)))));
    v72 = Math.pow(a, n);
    if ((r > a)) {
      if ((a > 0.0)) {
        v75 = ((r - a) / a);
        v82 = Math.sqrt((Number.isFinite(v75) ? Math.log1p(v75) : (Math.log(r) - Math.log(a))));
        v85 = (42.0 / (n + 1.0));
        v90 = (v85 / (Math.sqrt(((v82 * v82) + v85)) + v82));
        v95 = (2.0 * v82);
        v98 = (a / r);
        v109 = (-n);
        v115 = [];
        for ([node, weight] of RULE_0_of_power_law((v90 / 1.0))) {
          v93 = (node * v90);
          v94 = (v82 + v93);
          v97 = (v93 * (v95 + v93));
          v114 = (((Math.atan2((v98 * Math.exp((-v97))), Math.sqrt((-Math.expm1((((-2.0) * v94) * v94))))) * Math.exp((v109 * v97))) * 2.0) * v94);
          v115.push((weight * v114));
        }
        v115 = (math.fsum(v115) * v90);
        v117 = (n * v115);
      } else {
        v117 = 0.0;
      }
      return (((((2.0 * A) / 1.7724538509055159) * v72) * v117) * v68);
    }
    return ((((1.7724538509055159 * A) * v72) * v68) - (A * Math.pow(r, n)));
  }
  return _displacement_of_power_law(r, a, A, n);
};

const displacement = (r, a, A, n) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement(r, a, A, n) : 0.0) : NaN);
};

const _stiffness_of_power_law = (a, E_star) => {
  return ((2 * E_star) * a);
};

const _stiffness = (a, E_star, A = 1.0, n = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30))) {
    return ((2.0 * E_star) * a);
  }
  return _stiffness_of_power_law(a, E_star);
};

const stiffness = (a, A, n, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness(a, E_star) : NaN);
};

const gamma_ratio = (x) => {
  let v2, v21, v7;
  v2 = (x + 1.75);
  v7 = ((x + 0.5) * (x + 1.5));
  v21 = (1.0 / (v2 * v2));
  return ((((x < 1.0) ? ((x * (x + 1.0)) / v7) : (1.0 - ((x + 0.75) / v7))) * math.sqrt(v2)) * (1.0 + (v21 * (((((((((((((0.01524698625788054 * v21) + 0.5334320651111477) * v21) + 2.250488865813539) * v21) + 2.8612106440066865) * v21) + 1.3794681629043655) * v21) + 0.2596058532893223) * v21) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v21) + 49.328555418276075) * v21) + 167.28648538571198) * v21) + 195.37226190335065) * v21) + 90.69722535867314) * v21) + 16.763212110504565) * v21) + 1.0)))));
};

const lower_power = (x, n) => {
  return math.where((x > 0.0), (Math.pow(x, n) / x), Math.pow(x, (n - 1.0)));
};

const _mean_pressure_of_power_law = (a, A, n, E_star) => {
  let kappa;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  return ((((((2 * E_star) * n) * A) / (Math.sqrt(Math.PI) * (n + 1))) * lower_power(a, n)) * kappa);
};

const _mean_pressure = (a, A, n, E_star) => {
  let v13, v27, v7, v9;
  if (((a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v7 = ((n / 2.0) + 0.5);
    v9 = (v7 + 1.75);
    v13 = ((v7 + 0.5) * (v7 + 1.5));
    v27 = (1.0 / (v9 * v9));
    return ((((((2.0 * E_star) * n) * A) / (1.7724538509055159 * (n + 1.0))) * ((a > 0.0) ? (Math.pow(a, n) / a) : Math.pow(a, (n - 1.0)))) * ((((v7 < 1.0) ? ((v7 * (v7 + 1.0)) / v13) : (1.0 - ((v7 + 0.75) / v13))) * Math.sqrt(v9)) * (1.0 + (v27 * (((((((((((((0.01524698625788054 * v27) + 0.5334320651111477) * v27) + 2.250488865813539) * v27) + 2.8612106440066865) * v27) + 1.3794681629043655) * v27) + 0.2596058532893223) * v27) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v27) + 49.328555418276075) * v27) + 167.28648538571198) * v27) + 195.37226190335065) * v27) + 90.69722535867314) * v27) + 16.763212110504565) * v27) + 1.0))))));
  }
  return _mean_pressure_of_power_law(a, A, n, E_star);
};

const mean_pressure = (a, A, n, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure(a, A, n, E_star) : NaN);
};

const _energy_of_power_law = (a, A, n, E_star) => {
  let kappa;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  return ((((((((2 * Math.PI) * E_star) * Math.pow(n, 2)) * Math.pow(A, 2)) / (((2 * n) + 1) * (n + 1))) * a) * Math.pow(a, (2 * n))) * Math.pow(kappa, 2));
};

const _energy = (a, A, n, E_star) => {
  let v13, v27, v68, v7, v75, v9;
  if (((a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v7 = ((n / 2.0) + 0.5);
    v9 = (v7 + 1.75);
    v13 = ((v7 + 0.5) * (v7 + 1.5));
    v27 = (1.0 / (v9 * v9));
    v68 = ((((v7 < 1.0) ? ((v7 * (v7 + 1.0)) / v13) : (1.0 - ((v7 + 0.75) / v13))) * Math.sqrt(v9)) * (1.0 + (v27 * (((((((((((((0.01524698625788054 * v27) + 0.5334320651111477) * v27) + 2.250488865813539) * v27) + 2.8612106440066865) * v27) + 1.3794681629043655) * v27) + 0.2596058532893223) * v27) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v27) + 49.328555418276075) * v27) + 167.28648538571198) * v27) + 195.37226190335065) * v27) + 90.69722535867314) * v27) + 16.763212110504565) * v27) + 1.0)))));
    v75 = (2.0 * n);
    return (((((((6.283185307179586 * E_star) * (n * n)) * (A * A)) / ((v75 + 1.0) * (n + 1.0))) * a) * Math.pow(a, v75)) * (v68 * v68));
  }
  return _energy_of_power_law(a, A, n, E_star);
};

const energy = (a, A, n, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _energy(a, A, n, E_star) : NaN);
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

const _force_of_power_law = (a, A, n, E_star) => {
  let kappa;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  return ((((((((2 * Math.sqrt(Math.PI)) * E_star) * n) * A) / (n + 1)) * a) * Math.pow(a, n)) * kappa);
};

const _load_within_of_power_law = (r, a, A, n, E_star) => {
  let kappa, root, share, within;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  root = Math.sqrt(((a - r) * (a + r)));
  share = power_pressure(r, a, n);
  within = (((((((((2 * Math.sqrt(Math.PI)) * E_star) * n) * A) / (n + 1)) * Math.pow(a, n)) * Math.pow(r, 2)) * ((1 / (root + a)) + (share / a))) * kappa);
  return math.where((r < a), math.where((r > 0.0), within, 0.0), _force_of_power_law(a, A, n, E_star));
};

const _load_within = (r, a, A, n, E_star) => {
  let node, v10, v100, v105, v107, v108, v113, v116, v118, v127, v128, v129, v131, v137, v138, v14, v28, v69, v70, v74, v76, v8, v86, v87, v93, v98, v99, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v8 = ((n / 2.0) + 0.5);
    v10 = (v8 + 1.75);
    v14 = ((v8 + 0.5) * (v8 + 1.5));
    v28 = (1.0 / (v10 * v10));
    v69 = ((((v8 < 1.0) ? ((v8 * (v8 + 1.0)) / v14) : (1.0 - ((v8 + 0.75) / v14))) * Math.sqrt(v10)) * (1.0 + (v28 * (((((((((((((0.01524698625788054 * v28) + 0.5334320651111477) * v28) + 2.250488865813539) * v28) + 2.8612106440066865) * v28) + 1.3794681629043655) * v28) + 0.2596058532893223) * v28) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v28) + 49.328555418276075) * v28) + 167.28648538571198) * v28) + 195.37226190335065) * v28) + 90.69722535867314) * v28) + 16.763212110504565) * v28) + 1.0)))));
    v137 = ((((3.5449077018110318 * E_star) * n) * A) / (n + 1.0));
    v138 = Math.pow(a, n);
    if ((r < a)) {
      v86 = (r > 0.0);
      if (v86) {
        v70 = (a - r);
        v74 = (n > 1.0);
        v76 = Math.abs((n - 1.0));
        if (v86) {
          v87 = (v70 / r);
          v93 = (Number.isFinite(v87) ? Math.log1p(v87) : (Math.log(a) - Math.log(r)));
          if ((v93 > 0.0)) {
            v98 = (v93 - (42.0 / (((v76 > 0.001) || (v76 !== v76)) ? v76 : 0.001)));
            v99 = (((v98 > 0.0) || (v98 !== v98)) ? v98 : 0.0);
            v100 = Math.sqrt(v93);
            v105 = (math.truth(v74) ? (v100 - Math.sqrt(v99)) : Math.sqrt((v93 - v99)));
            v108 = (2.0 * v100);
            v113 = (-v76);
            v128 = [];
            for ([node, weight] of RULE_1((v105 / 1.0))) {
              v107 = (node * v105);
              if (v74) {
                v116 = (v100 - v107);
                v118 = (((v116 > 0.0) || (v116 !== v116)) ? v116 : 0.0);
              } else {
                v118 = v107;
              }
              v127 = (Math.exp((v113 * (math.truth(v74) ? (v107 * (v108 - v107)) : (v107 * v107)))) * ((2.0 * v118) / Math.sqrt((-Math.expm1((((-2.0) * v118) * v118))))));
              v128.push((weight * v127));
            }
            v128 = (math.fsum(v128) * v105);
            v129 = v128;
          } else {
            v129 = 0.0;
          }
          v131 = ((math.truth(v74) ? 1.0 : (Math.pow((r / a), n) * (a / r))) * v129);
        } else {
          v131 = (math.truth(v74) ? (1.0 / v76) : Infinity);
        }
        return ((((v137 * v138) * (r * r)) * ((1.0 / (Math.sqrt((v70 * (a + r))) + a)) + (v131 / a))) * v69);
      }
      return 0.0;
    }
    return (((v137 * a) * v138) * v69);
  }
  return _load_within_of_power_law(r, a, A, n, E_star);
};

const load_within = (r, a, A, n, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _load_within(r, a, A, n, E_star) : 0.0) : NaN);
};

const RULE_2 = math.rule([[1.5, 32], [8.0, 64], [Infinity, 128]]);

const PEAK_STEPS = 5;

const PEAK_LENGTHS = [[1.5, 32], [8.0, 64], [Infinity, 128]];

const _risen = (slope, power) => {
  let end, integrand;
  end = (slope * slope);
  integrand = (u) => {
    let fallen, here, squared;
    here = Math.pow(Math.sinh(u), 2);
    fallen = ((end - here) / (1.0 + end));
    squared = math.where((fallen < 0.5), Math.log1p((-math.minimum(fallen, 0.5))), Math.log(((1.0 + here) / (1.0 + end))));
    return Math.exp(((0.5 * power) * squared));
  };
  return math.integral_by_length(integrand, Math.asinh(slope), undefined, PEAK_LENGTHS);
};

const _slope_of_peak = (n) => {
  let _, m, slope;
  m = (math.where((n > 2.0), n, 3.0) - 2.0);
  slope = ((2.0 / (Math.PI * m)) * Math.sqrt((1.0 + (4.215 * m))));
  for (_ of math.range(PEAK_STEPS)) {
    slope = (math.hypot(1.0, slope) / (m * _risen(slope, (m - 1.0))));
  }
  return slope;
};

const rise_to_greatest_pressure = (n) => {
  return math.where((n > 2.0), math.hypot(1.0, (1.0 / _slope_of_peak(n))), 1.0);
};

const _peak_pressure_of_power_law = (a, A, n, E_star) => {
  let greatest, kappa, rise;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  rise = rise_to_greatest_pressure(n);
  greatest = ((((((E_star * n) * A) * rise) / (Math.sqrt(Math.PI) * (n - 1))) * lower_power(a, n)) * kappa);
  return math.where((n > 1.0), greatest, Infinity);
};

const _peak_pressure = (a, A, n, E_star) => {
  let node, v101, v102, v104, v106, v107, v108, v109, v110, v112, v113, v123, v124, v126, v128, v129, v13, v130, v131, v132, v134, v135, v145, v146, v148, v150, v151, v152, v153, v154, v156, v157, v167, v168, v170, v172, v173, v174, v175, v176, v178, v179, v189, v190, v195, v199, v27, v69, v7, v72, v80, v83, v84, v85, v86, v87, v89, v9, v90, v99, weight;
  if (((a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    if ((n > 1.0)) {
      v7 = ((n / 2.0) + 0.5);
      v9 = (v7 + 1.75);
      v13 = ((v7 + 0.5) * (v7 + 1.5));
      v27 = (1.0 / (v9 * v9));
      v69 = (n > 2.0);
      if (v69) {
        v72 = ((math.truth(v69) ? n : 3.0) - 2.0);
        v80 = ((2.0 / (3.141592653589793 * v72)) * Math.sqrt((1.0 + (4.215 * v72))));
        v83 = (v80 * v80);
        v84 = Math.asinh(v80);
        v89 = (1.0 + v83);
        v99 = (0.5 * (v72 - 1.0));
        v102 = [];
        for ([node, weight] of RULE_2((v84 / 1.0))) {
          v85 = (node * v84);
          v86 = Math.sinh(v85);
          v87 = (v86 * v86);
          v90 = ((v83 - v87) / v89);
          v101 = Math.exp((v99 * ((v90 < 0.5) ? Math.log1p((-v90)) : Math.log(((1.0 + v87) / v89)))));
          v102.push((weight * v101));
        }
        v102 = (math.fsum(v102) * v84);
        v104 = (math.hypot(1.0, v80) / (v72 * v102));
        v106 = (v104 * v104);
        v107 = Math.asinh(v104);
        v112 = (1.0 + v106);
        v124 = [];
        for ([node, weight] of RULE_2((v107 / 1.0))) {
          v108 = (node * v107);
          v109 = Math.sinh(v108);
          v110 = (v109 * v109);
          v113 = ((v106 - v110) / v112);
          v123 = Math.exp((v99 * ((v113 < 0.5) ? Math.log1p((-v113)) : Math.log(((1.0 + v110) / v112)))));
          v124.push((weight * v123));
        }
        v124 = (math.fsum(v124) * v107);
        v126 = (math.hypot(1.0, v104) / (v72 * v124));
        v128 = (v126 * v126);
        v129 = Math.asinh(v126);
        v134 = (1.0 + v128);
        v146 = [];
        for ([node, weight] of RULE_2((v129 / 1.0))) {
          v130 = (node * v129);
          v131 = Math.sinh(v130);
          v132 = (v131 * v131);
          v135 = ((v128 - v132) / v134);
          v145 = Math.exp((v99 * ((v135 < 0.5) ? Math.log1p((-v135)) : Math.log(((1.0 + v132) / v134)))));
          v146.push((weight * v145));
        }
        v146 = (math.fsum(v146) * v129);
        v148 = (math.hypot(1.0, v126) / (v72 * v146));
        v150 = (v148 * v148);
        v151 = Math.asinh(v148);
        v156 = (1.0 + v150);
        v168 = [];
        for ([node, weight] of RULE_2((v151 / 1.0))) {
          v152 = (node * v151);
          v153 = Math.sinh(v152);
          v154 = (v153 * v153);
          v157 = ((v150 - v154) / v156);
          v167 = Math.exp((v99 * ((v157 < 0.5) ? Math.log1p((-v157)) : Math.log(((1.0 + v154) / v156)))));
          v168.push((weight * v167));
        }
        v168 = (math.fsum(v168) * v151);
        v170 = (math.hypot(1.0, v148) / (v72 * v168));
        v172 = (v170 * v170);
        v173 = Math.asinh(v170);
        v178 = (1.0 + v172);
        v190 = [];
        for ([node, weight] of RULE_2((v173 / 1.0))) {
          v174 = (node * v173);
          v175 = Math.sinh(v174);
          v176 = (v175 * v175);
          v179 = ((v172 - v176) / v178);
          v189 = Math.exp((v99 * ((v179 < 0.5) ? Math.log1p((-v179)) : Math.log(((1.0 + v176) / v178)))));
          v190.push((weight * v189));
        }
        v190 = (math.fsum(v190) * v173);
        v195 = math.hypot(1.0, (1.0 / (math.hypot(1.0, v170) / (v72 * v190))));
      } else {
        v195 = 1.0;
      }
      v199 = (n - 1.0);
      return ((((((E_star * n) * A) * v195) / (1.7724538509055159 * v199)) * ((a > 0.0) ? (Math.pow(a, n) / a) : Math.pow(a, v199))) * ((((v7 < 1.0) ? ((v7 * (v7 + 1.0)) / v13) : (1.0 - ((v7 + 0.75) / v13))) * Math.sqrt(v9)) * (1.0 + (v27 * (((((((((((((0.01524698625788054 * v27) + 0.5334320651111477) * v27) + 2.250488865813539) * v27) + 2.8612106440066865) * v27) + 1.3794681629043655) * v27) + 0.2596058532893223) * v27) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v27) + 49.328555418276075) * v27) + 167.28648538571198) * v27) + 195.37226190335065) * v27) + 90.69722535867314) * v27) + 16.763212110504565) * v27) + 1.0))))));
    }
    return Infinity;
  }
  return _peak_pressure_of_power_law(a, A, n, E_star);
};

const ring_of_greatest_pressure = (n) => {
  return math.where((n > 2.0), (1.0 / math.hypot(1.0, _slope_of_peak(n))), 0.0);
};

const _peak_radius_of_power_law = (a, n) => {
  return (a * ring_of_greatest_pressure(n));
};

const _peak_radius = (a, n, A = 1.0, E_star = 1.0) => {
  let node, v103, v104, v106, v108, v109, v110, v111, v112, v114, v115, v125, v126, v132, v15, v18, v19, v20, v21, v22, v24, v25, v3, v35, v37, v38, v40, v42, v43, v44, v45, v46, v48, v49, v59, v6, v60, v62, v64, v65, v66, v67, v68, v70, v71, v81, v82, v84, v86, v87, v88, v89, v90, v92, v93, weight;
  if (((a > 1e-30) && (a < 1e+30) && (n > 1e-30) && (n < 1e+30) && (A > 1e-30) && (A < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v3 = (n > 2.0);
    if (v3) {
      v6 = ((math.truth(v3) ? n : 3.0) - 2.0);
      v15 = ((2.0 / (3.141592653589793 * v6)) * Math.sqrt((1.0 + (4.215 * v6))));
      v18 = (v15 * v15);
      v19 = Math.asinh(v15);
      v24 = (1.0 + v18);
      v35 = (0.5 * (v6 - 1.0));
      v38 = [];
      for ([node, weight] of RULE_2((v19 / 1.0))) {
        v20 = (node * v19);
        v21 = Math.sinh(v20);
        v22 = (v21 * v21);
        v25 = ((v18 - v22) / v24);
        v37 = Math.exp((v35 * ((v25 < 0.5) ? Math.log1p((-v25)) : Math.log(((1.0 + v22) / v24)))));
        v38.push((weight * v37));
      }
      v38 = (math.fsum(v38) * v19);
      v40 = (math.hypot(1.0, v15) / (v6 * v38));
      v42 = (v40 * v40);
      v43 = Math.asinh(v40);
      v48 = (1.0 + v42);
      v60 = [];
      for ([node, weight] of RULE_2((v43 / 1.0))) {
        v44 = (node * v43);
        v45 = Math.sinh(v44);
        v46 = (v45 * v45);
        v49 = ((v42 - v46) / v48);
        v59 = Math.exp((v35 * ((v49 < 0.5) ? Math.log1p((-v49)) : Math.log(((1.0 + v46) / v48)))));
        v60.push((weight * v59));
      }
      v60 = (math.fsum(v60) * v43);
      v62 = (math.hypot(1.0, v40) / (v6 * v60));
      v64 = (v62 * v62);
      v65 = Math.asinh(v62);
      v70 = (1.0 + v64);
      v82 = [];
      for ([node, weight] of RULE_2((v65 / 1.0))) {
        v66 = (node * v65);
        v67 = Math.sinh(v66);
        v68 = (v67 * v67);
        v71 = ((v64 - v68) / v70);
        v81 = Math.exp((v35 * ((v71 < 0.5) ? Math.log1p((-v71)) : Math.log(((1.0 + v68) / v70)))));
        v82.push((weight * v81));
      }
      v82 = (math.fsum(v82) * v65);
      v84 = (math.hypot(1.0, v62) / (v6 * v82));
      v86 = (v84 * v84);
      v87 = Math.asinh(v84);
      v92 = (1.0 + v86);
      v104 = [];
      for ([node, weight] of RULE_2((v87 / 1.0))) {
        v88 = (node * v87);
        v89 = Math.sinh(v88);
        v90 = (v89 * v89);
        v93 = ((v86 - v90) / v92);
        v103 = Math.exp((v35 * ((v93 < 0.5) ? Math.log1p((-v93)) : Math.log(((1.0 + v90) / v92)))));
        v104.push((weight * v103));
      }
      v104 = (math.fsum(v104) * v87);
      v106 = (math.hypot(1.0, v84) / (v6 * v104));
      v108 = (v106 * v106);
      v109 = Math.asinh(v106);
      v114 = (1.0 + v108);
      v126 = [];
      for ([node, weight] of RULE_2((v109 / 1.0))) {
        v110 = (node * v109);
        v111 = Math.sinh(v110);
        v112 = (v111 * v111);
        v115 = ((v108 - v112) / v114);
        v125 = Math.exp((v35 * ((v115 < 0.5) ? Math.log1p((-v115)) : Math.log(((1.0 + v112) / v114)))));
        v126.push((weight * v125));
      }
      v126 = (math.fsum(v126) * v109);
      v132 = (1.0 / math.hypot(1.0, (math.hypot(1.0, v106) / (v6 * v126))));
    } else {
      v132 = 0.0;
    }
    return (a * v132);
  }
  return _peak_radius_of_power_law(a, n);
};

const PeakPressure = (pressure, radius) => math.record({ pressure, radius });

const peak_pressure = (a, A, n, E_star) => {
  let pressure, radius;
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  pressure = ((a >= 0.0) ? _peak_pressure(a, A, n, E_star) : NaN);
  radius = ((a >= 0.0) ? _peak_radius(a, n) : NaN);
  return PeakPressure(pressure, radius);
};

const _radius_from_depth = (d, A, n) => {
  let v12, v26, v6, v71, v73, v75, v8;
  v6 = ((n / 2.0) + 0.5);
  v8 = (v6 + 1.75);
  v12 = ((v6 + 0.5) * (v6 + 1.5));
  v26 = (1.0 / (v8 * v8));
  v71 = (d / ((1.7724538509055159 * A) * ((((v6 < 1.0) ? ((v6 * (v6 + 1.0)) / v12) : (1.0 - ((v6 + 0.75) / v12))) * math.sqrt(v8)) * (1.0 + (v26 * (((((((((((((0.01524698625788054 * v26) + 0.5334320651111477) * v26) + 2.250488865813539) * v26) + 2.8612106440066865) * v26) + 1.3794681629043655) * v26) + 0.2596058532893223) * v26) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v26) + 49.328555418276075) * v26) + 167.28648538571198) * v26) + 195.37226190335065) * v26) + 90.69722535867314) * v26) + 16.763212110504565) * v26) + 1.0)))))));
  v73 = (n + 0.0);
  v75 = Math.pow(v71, (1.0 / v73));
  if (((v71 > 0.0) && (v71 < Infinity))) {
    return (v75 + (v75 * (((v71 / (Math.pow(v75, n) * Math.pow(v75, 0.0))) - 1.0) / v73)));
  }
  return v75;
};

const radius_from_depth = (d, A, n) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth(d, A, n) : NaN);
};

const _radius_from_force = (F, A, n, E_star) => {
  let v13, v27, v69, v7, v76, v78, v9;
  v7 = ((n / 2.0) + 0.5);
  v9 = (v7 + 1.75);
  v13 = ((v7 + 0.5) * (v7 + 1.5));
  v27 = (1.0 / (v9 * v9));
  v69 = (n + 1.0);
  v76 = ((v69 * F) / ((((3.5449077018110318 * E_star) * n) * A) * ((((v7 < 1.0) ? ((v7 * (v7 + 1.0)) / v13) : (1.0 - ((v7 + 0.75) / v13))) * math.sqrt(v9)) * (1.0 + (v27 * (((((((((((((0.01524698625788054 * v27) + 0.5334320651111477) * v27) + 2.250488865813539) * v27) + 2.8612106440066865) * v27) + 1.3794681629043655) * v27) + 0.2596058532893223) * v27) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v27) + 49.328555418276075) * v27) + 167.28648538571198) * v27) + 195.37226190335065) * v27) + 90.69722535867314) * v27) + 16.763212110504565) * v27) + 1.0)))))));
  v78 = Math.pow(v76, (1.0 / v69));
  if (((v76 > 0.0) && (v76 < Infinity))) {
    return (v78 + (v78 * (((v76 / (Math.pow(v78, n) * Math.pow(v78, 1.0))) - 1.0) / v69)));
  }
  return v78;
};

const radius_from_force = (F, A, n, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _radius_from_force(F, A, n, E_star) : NaN);
};

const _force_from_depth = (d, A, n, E_star) => {
  let v13, v27, v68, v7, v72, v82, v84, v9;
  v7 = ((n / 2.0) + 0.5);
  v9 = (v7 + 1.75);
  v13 = ((v7 + 0.5) * (v7 + 1.5));
  v27 = (1.0 / (v9 * v9));
  v68 = ((((v7 < 1.0) ? ((v7 * (v7 + 1.0)) / v13) : (1.0 - ((v7 + 0.75) / v13))) * math.sqrt(v9)) * (1.0 + (v27 * (((((((((((((0.01524698625788054 * v27) + 0.5334320651111477) * v27) + 2.250488865813539) * v27) + 2.8612106440066865) * v27) + 1.3794681629043655) * v27) + 0.2596058532893223) * v27) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v27) + 49.328555418276075) * v27) + 167.28648538571198) * v27) + 195.37226190335065) * v27) + 90.69722535867314) * v27) + 16.763212110504565) * v27) + 1.0)))));
  v72 = (d / ((1.7724538509055159 * A) * v68));
  v82 = (n + 0.0);
  v84 = Math.pow(v72, (1.0 / v82));
  return (((((((3.5449077018110318 * E_star) * n) * A) / (n + 1.0)) * v68) * v72) * (((v72 > 0.0) && (v72 < Infinity)) ? (v84 + (v84 * (((v72 / (Math.pow(v84, n) * Math.pow(v84, 0.0))) - 1.0) / v82))) : v84));
};

const force_from_depth = (d, A, n, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth(d, A, n, E_star) : NaN);
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

const _depth_from_force_of_power_law = (F, A, n, E_star) => {
  let kappa, ratio;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  ratio = (((n + 1) * F) / (((((2 * Math.sqrt(Math.PI)) * E_star) * n) * A) * kappa));
  return (((Math.sqrt(Math.PI) * A) * kappa) * without_root(ratio, n, 1));
};

const _depth_from_force = (F, A, n, E_star) => {
  let v13, v27, v68, v69, v7, v76, v84, v86, v9, v97;
  if (((F > 1e-30) && (F < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v7 = ((n / 2.0) + 0.5);
    v9 = (v7 + 1.75);
    v13 = ((v7 + 0.5) * (v7 + 1.5));
    v27 = (1.0 / (v9 * v9));
    v68 = ((((v7 < 1.0) ? ((v7 * (v7 + 1.0)) / v13) : (1.0 - ((v7 + 0.75) / v13))) * Math.sqrt(v9)) * (1.0 + (v27 * (((((((((((((0.01524698625788054 * v27) + 0.5334320651111477) * v27) + 2.250488865813539) * v27) + 2.8612106440066865) * v27) + 1.3794681629043655) * v27) + 0.2596058532893223) * v27) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v27) + 49.328555418276075) * v27) + 167.28648538571198) * v27) + 195.37226190335065) * v27) + 90.69722535867314) * v27) + 16.763212110504565) * v27) + 1.0)))));
    v69 = (n + 1.0);
    v76 = ((v69 * F) / ((((3.5449077018110318 * E_star) * n) * A) * v68));
    v84 = ((v76 > 0.0) && (v76 < Infinity));
    if (v84) {
      v86 = Math.pow(v76, (1.0 / v69));
      v97 = (v76 / (math.truth(v84) ? (v86 + (v86 * (((v76 / (Math.pow(v86, n) * Math.pow(v86, 1.0))) - 1.0) / v69))) : v86));
    } else {
      v97 = v76;
    }
    return (((1.7724538509055159 * A) * v68) * v97);
  }
  return _depth_from_force_of_power_law(F, A, n, E_star);
};

const depth_from_force = (F, A, n, E_star) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force(F, A, n, E_star) : NaN);
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

const _depth_3 = (a, A, n) => {
  let kappa;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  return (((Math.sqrt(Math.PI) * A) * Math.pow(a, n)) * kappa);
};

const _depth_2 = (a, A, n, E_star, dgamma) => {
  return (_depth_3(a, A, n) - hess_retraction(a, E_star, dgamma));
};

const _depth_of_power_law = (a, A, n, E_star, dgamma) => {
  let v10, v14, v28, v8;
  if (((a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v8 = ((n / 2.0) + 0.5);
    v10 = (v8 + 1.75);
    v14 = ((v8 + 0.5) * (v8 + 1.5));
    v28 = (1.0 / (v10 * v10));
    return ((((1.7724538509055159 * A) * Math.pow(a, n)) * ((((v8 < 1.0) ? ((v8 * (v8 + 1.0)) / v14) : (1.0 - ((v8 + 0.75) / v14))) * Math.sqrt(v10)) * (1.0 + (v28 * (((((((((((((0.01524698625788054 * v28) + 0.5334320651111477) * v28) + 2.250488865813539) * v28) + 2.8612106440066865) * v28) + 1.3794681629043655) * v28) + 0.2596058532893223) * v28) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v28) + 49.328555418276075) * v28) + 167.28648538571198) * v28) + 195.37226190335065) * v28) + 90.69722535867314) * v28) + 16.763212110504565) * v28) + 1.0)))))) - (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))));
  }
  return _depth_2(a, A, n, E_star, dgamma);
};

const depth_of_power_law = (a, A, n, E_star, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_of_power_law(a, A, n, E_star, dgamma) : NaN);
};

const pull = (a, E_star, dgamma) => {
  return (((2.0 * E_star) * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const _force_3 = (a, A, n, E_star, dgamma) => {
  return (_force_of_power_law(a, A, n, E_star) - pull(a, E_star, dgamma));
};

const _force_2 = (a, A, n, E_star, dgamma) => {
  let v10, v14, v28, v8;
  if (((a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v8 = ((n / 2.0) + 0.5);
    v10 = (v8 + 1.75);
    v14 = ((v8 + 0.5) * (v8 + 1.5));
    v28 = (1.0 / (v10 * v10));
    return ((((((((3.5449077018110318 * E_star) * n) * A) / (n + 1.0)) * a) * Math.pow(a, n)) * ((((v8 < 1.0) ? ((v8 * (v8 + 1.0)) / v14) : (1.0 - ((v8 + 0.75) / v14))) * Math.sqrt(v10)) * (1.0 + (v28 * (((((((((((((0.01524698625788054 * v28) + 0.5334320651111477) * v28) + 2.250488865813539) * v28) + 2.8612106440066865) * v28) + 1.3794681629043655) * v28) + 0.2596058532893223) * v28) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v28) + 49.328555418276075) * v28) + 167.28648538571198) * v28) + 195.37226190335065) * v28) + 90.69722535867314) * v28) + 16.763212110504565) * v28) + 1.0)))))) - (((2.0 * E_star) * a) * (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star)))));
  }
  return _force_3(a, A, n, E_star, dgamma);
};

const force_of_power_law = (a, A, n, E_star, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_2(a, A, n, E_star, dgamma) : NaN);
};

const RULE_1_2 = math.rule([[16.0, 64], [Infinity, 128]]);

const _pressure_4 = (r, a, A, n, E_star) => {
  let kappa, pressed;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  pressed = ((((((E_star * n) * A) / Math.sqrt(Math.PI)) * lower_power(a, n)) * power_pressure(r, a, n)) * kappa);
  return math.where((r < a), pressed, 0.0);
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

const _pressure_3 = (r, a, A, n, E_star, dgamma) => {
  return (_pressure_4(r, a, A, n, E_star) - tension(r, a, E_star, dgamma));
};

const _pressure_2 = (r, a, A, n, E_star, dgamma) => {
  let node, v101, v106, v107, v108, v11, v113, v115, v116, v121, v124, v126, v135, v136, v137, v139, v143, v149, v15, v161, v29, v79, v83, v84, v9, v94, v95, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v94 = (a - r);
    if ((r < a)) {
      v9 = ((n / 2.0) + 0.5);
      v11 = (v9 + 1.75);
      v15 = ((v9 + 0.5) * (v9 + 1.5));
      v29 = (1.0 / (v11 * v11));
      v79 = (n - 1.0);
      v83 = (n > 1.0);
      v84 = Math.abs(v79);
      if ((r > 0.0)) {
        v95 = (v94 / r);
        v101 = (Number.isFinite(v95) ? Math.log1p(v95) : (Math.log(a) - Math.log(r)));
        if ((v101 > 0.0)) {
          v106 = (v101 - (42.0 / (((v84 > 0.001) || (v84 !== v84)) ? v84 : 0.001)));
          v107 = (((v106 > 0.0) || (v106 !== v106)) ? v106 : 0.0);
          v108 = Math.sqrt(v101);
          v113 = (math.truth(v83) ? (v108 - Math.sqrt(v107)) : Math.sqrt((v101 - v107)));
          v116 = (2.0 * v108);
          v121 = (-v84);
          v136 = [];
          for ([node, weight] of RULE_1_2((v113 / 1.0))) {
            v115 = (node * v113);
            if (v83) {
              v124 = (v108 - v115);
              v126 = (((v124 > 0.0) || (v124 !== v124)) ? v124 : 0.0);
            } else {
              v126 = v115;
            }
            v135 = (Math.exp((v121 * (math.truth(v83) ? (v115 * (v116 - v115)) : (v115 * v115)))) * ((2.0 * v126) / Math.sqrt((-Math.expm1((((-2.0) * v126) * v126))))));
            v136.push((weight * v135));
          }
          v136 = (math.fsum(v136) * v113);
          v137 = v136;
        } else {
          v137 = 0.0;
        }
        v139 = ((math.truth(v83) ? 1.0 : (Math.pow((r / a), n) * (a / r))) * v137);
      } else {
        v139 = (math.truth(v83) ? (1.0 / v84) : Infinity);
      }
      v143 = ((((((E_star * n) * A) / 1.7724538509055159) * ((a > 0.0) ? (Math.pow(a, n) / a) : Math.pow(a, v79))) * v139) * ((((v9 < 1.0) ? ((v9 * (v9 + 1.0)) / v15) : (1.0 - ((v9 + 0.75) / v15))) * Math.sqrt(v11)) * (1.0 + (v29 * (((((((((((((0.01524698625788054 * v29) + 0.5334320651111477) * v29) + 2.250488865813539) * v29) + 2.8612106440066865) * v29) + 1.3794681629043655) * v29) + 0.2596058532893223) * v29) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v29) + 49.328555418276075) * v29) + 167.28648538571198) * v29) + 195.37226190335065) * v29) + 90.69722535867314) * v29) + 16.763212110504565) * v29) + 1.0))))));
    } else {
      v143 = 0.0;
    }
    if ((r <= a)) {
      v149 = (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star)));
      v161 = ((v149 > 0.0) ? ((E_star * v149) / (3.141592653589793 * Math.sqrt(((((v94 > 0.0) || (v94 !== v94)) ? v94 : 0.0) * (a + r))))) : 0.0);
    } else {
      v161 = 0.0;
    }
    return (v143 - v161);
  }
  return _pressure_3(r, a, A, n, E_star, dgamma);
};

const pressure_of_power_law = (r, a, A, n, E_star, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_2(r, a, A, n, E_star, dgamma) : 0.0) : NaN);
};

const RULE_0_2 = math.rule([[Infinity, 64]]);

const _span = (r, a, n) => {
  let v11, v15, v4;
  v4 = ((r - a) / a);
  v11 = math.sqrt((Number.isFinite(v4) ? math.log1p(v4) : (math.log(r) - math.log(a))));
  v15 = (42.0 / (n + 1.0));
  return [v11, (v15 / (math.sqrt(((v11 * v11) + v15)) + v11))];
};

const NODES = 64;

const power_displacement = (r, a, n) => {
  let integrand, reach, start;
  [start, reach] = _span(r, a, n);
  integrand = (step) => {
    let fall, ratio, s;
    s = (start + step);
    fall = (step * ((2.0 * start) + step));
    ratio = ((a / r) * Math.exp((-fall)));
    return (((Math.atan2(ratio, Math.sqrt((-Math.expm1((((-2.0) * s) * s))))) * Math.exp(((-n) * fall))) * 2.0) * s);
  };
  return ((a > 0.0) ? (n * math.integral(integrand, reach, NODES)) : 0.0);
};

const _profile = (r, A, n) => {
  return (A * Math.pow(r, n));
};

const _displacement_4 = (r, a, A, n) => {
  let inside, kappa, outside;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  outside = (((((2 * A) / Math.sqrt(Math.PI)) * Math.pow(a, n)) * power_displacement(r, a, n)) * kappa);
  inside = (_depth_3(a, A, n) - _profile(r, A, n));
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

const _displacement_3 = (r, a, A, n, E_star, dgamma) => {
  return (_displacement_4(r, a, A, n) - lift(r, a, E_star, dgamma));
};

const _displacement_2 = (r, a, A, n, E_star, dgamma) => {
  let node, v100, v11, v111, v116, v117, v119, v128, v129, v15, v29, v70, v74, v76, v77, v84, v87, v9, v92, v95, v96, v97, v99, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v9 = ((n / 2.0) + 0.5);
    v11 = (v9 + 1.75);
    v15 = ((v9 + 0.5) * (v9 + 1.5));
    v29 = (1.0 / (v11 * v11));
    v70 = ((((v9 < 1.0) ? ((v9 * (v9 + 1.0)) / v15) : (1.0 - ((v9 + 0.75) / v15))) * Math.sqrt(v11)) * (1.0 + (v29 * (((((((((((((0.01524698625788054 * v29) + 0.5334320651111477) * v29) + 2.250488865813539) * v29) + 2.8612106440066865) * v29) + 1.3794681629043655) * v29) + 0.2596058532893223) * v29) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v29) + 49.328555418276075) * v29) + 167.28648538571198) * v29) + 195.37226190335065) * v29) + 90.69722535867314) * v29) + 16.763212110504565) * v29) + 1.0)))));
    v74 = Math.pow(a, n);
    v76 = (r - a);
    v128 = (r > a);
    if (v128) {
      if ((a > 0.0)) {
        v77 = (v76 / a);
        v84 = Math.sqrt((Number.isFinite(v77) ? Math.log1p(v77) : (Math.log(r) - Math.log(a))));
        v87 = (42.0 / (n + 1.0));
        v92 = (v87 / (Math.sqrt(((v84 * v84) + v87)) + v84));
        v97 = (2.0 * v84);
        v100 = (a / r);
        v111 = (-n);
        v117 = [];
        for ([node, weight] of RULE_0_2((v92 / 1.0))) {
          v95 = (node * v92);
          v96 = (v84 + v95);
          v99 = (v95 * (v97 + v95));
          v116 = (((Math.atan2((v100 * Math.exp((-v99))), Math.sqrt((-Math.expm1((((-2.0) * v96) * v96))))) * Math.exp((v111 * v99))) * 2.0) * v96);
          v117.push((weight * v116));
        }
        v117 = (math.fsum(v117) * v92);
        v119 = (n * v117);
      } else {
        v119 = 0.0;
      }
      v129 = (((((2.0 * A) / 1.7724538509055159) * v74) * v119) * v70);
    } else {
      v129 = ((((1.7724538509055159 * A) * v74) * v70) - (A * Math.pow(r, n)));
    }
    return (v129 - ((Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))) * (math.truth(v128) ? (0.6366197723675814 * Math.atan2(a, Math.sqrt(((((v76 > 0.0) || (v76 !== v76)) ? v76 : 0.0) * (r + a))))) : 1.0)));
  }
  return _displacement_3(r, a, A, n, E_star, dgamma);
};

const displacement_of_power_law = (r, a, A, n, E_star, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_2(r, a, A, n, E_star, dgamma) : 0.0) : NaN);
};

const nth_root_of_functions = (x, n, more = 0) => {
  let degree, y;
  degree = (n + more);
  y = Math.pow(x, (1.0 / degree));
  return (((x > 0.0) & (x < Infinity)) ? (y + (y * (((x / (Math.pow(y, n) * Math.pow(y, more))) - 1.0) / degree))) : y);
};

const _pull_off_radius = (A, n, E_star, dgamma, control) => {
  let kappa, radius, ratio;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  if ((control === 'force')) {
    ratio = ((3 * Math.sqrt(((2 * dgamma) / E_star))) / (((2 * n) * A) * kappa));
    radius = Math.pow(nth_root_of_functions(ratio, ((2 * n) - 1)), 2);
  } else {
    ratio = (Math.sqrt(((2 * dgamma) / E_star)) / (((2 * n) * A) * kappa));
    radius = Math.pow(nth_root_of_functions(ratio, ((2 * n) - 1)), 2);
  }
  return ((n > 0.5) ? ((dgamma > 0.0) ? radius : 0.0) : NaN);
};

const XI = {'force': 3.0, 'depth': 1.0};

const _pull_off_depth = (a, A, n, E_star, dgamma, control) => {
  return (_depth(a, A, n) * (1.0 - ((2 * n) / XI[control])));
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

const _radius_from_depth_of_power_law = (d, A, n, E_star, dgamma) => {
  let a_c, least, plain;
  a_c = _pull_off_radius(A, n, E_star, dgamma, 'depth');
  least = _pull_off_depth(a_c, A, n, E_star, dgamma, 'depth');
  plain = _radius_from_depth(math.maximum(d, 0.0), A, n);
  return power_law_radius(d, a_c, least, n, 0.5, plain);
};

const radius_from_depth_of_power_law = (d, A, n, E_star, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > 0.5))) {
    return NaN;
  }
  return _radius_from_depth_of_power_law(d, A, n, E_star, dgamma);
};

const _pull_off_force = (a, A, n, E_star, dgamma, control) => {
  return (_force(a, A, n, E_star) * (1.0 - ((2 * (n + 1)) / XI[control])));
};

const _radius_from_force_of_power_law = (F, A, n, E_star, dgamma) => {
  let a_c, least, plain;
  a_c = _pull_off_radius(A, n, E_star, dgamma, 'force');
  least = _pull_off_force(a_c, A, n, E_star, dgamma, 'force');
  plain = _radius_from_force(math.maximum(F, 0.0), A, n, E_star);
  return power_law_radius(F, a_c, least, (n + 1), 1.5, plain);
};

const radius_from_force_of_power_law = (F, A, n, E_star, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > 0.5))) {
    return NaN;
  }
  return _radius_from_force_of_power_law(F, A, n, E_star, dgamma);
};

const PullOff = (radius, force, depth) => math.record({ radius, force, depth });

const pull_off = (control = 'force', A, n, E_star, dgamma) => {
  let depth, force, radius;
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > 0.5))) {
    return NaN;
  }
  radius = _pull_off_radius(A, n, E_star, dgamma, control);
  force = ((radius >= 0.0) ? _pull_off_force(radius, A, n, E_star, dgamma, control) : NaN);
  depth = ((radius >= 0.0) ? _pull_off_depth(radius, A, n, E_star, dgamma, control) : NaN);
  return PullOff(radius, force, depth);
};

const gained_share = (c, a, n) => {
  return (-Math.expm1(((-n) * ((a > c) ? math.log1p(((a - c) / c)) : 0.0))));
};

const _tangential_force_of_power_law = (a, c, A, n, E_star, mu) => {
  return ((mu * _force_of_power_law(a, A, n, E_star)) * gained_share(c, a, (n + 1)));
};

const _tangential_force = (a, c, A, n, E_star, mu) => {
  let v11, v15, v29, v75, v9;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v9 = ((n / 2.0) + 0.5);
    v11 = (v9 + 1.75);
    v15 = ((v9 + 0.5) * (v9 + 1.5));
    v29 = (1.0 / (v11 * v11));
    v75 = (n + 1.0);
    return ((mu * (((((((3.5449077018110318 * E_star) * n) * A) / v75) * a) * Math.pow(a, n)) * ((((v9 < 1.0) ? ((v9 * (v9 + 1.0)) / v15) : (1.0 - ((v9 + 0.75) / v15))) * Math.sqrt(v11)) * (1.0 + (v29 * (((((((((((((0.01524698625788054 * v29) + 0.5334320651111477) * v29) + 2.250488865813539) * v29) + 2.8612106440066865) * v29) + 1.3794681629043655) * v29) + 0.2596058532893223) * v29) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v29) + 49.328555418276075) * v29) + 167.28648538571198) * v29) + 195.37226190335065) * v29) + 90.69722535867314) * v29) + 16.763212110504565) * v29) + 1.0))))))) * (-Math.expm1(((-v75) * ((a > c) ? Math.log1p(((a - c) / c)) : 0.0)))));
  }
  return _tangential_force_of_power_law(a, c, A, n, E_star, mu);
};

const tangential_force = (a, c, A, n, E_star, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_force(a, c, A, n, E_star, mu) : NaN);
};

const _slope = (t, A, n) => {
  let v11, v15, v29, v9;
  v9 = ((n / 2.0) + 0.5);
  v11 = (v9 + 1.75);
  v15 = ((v9 + 0.5) * (v9 + 1.5));
  v29 = (1.0 / (v11 * v11));
  return (((((1.7724538509055159 * n) * A) * ((((v9 < 1.0) ? ((v9 * (v9 + 1.0)) / v15) : (1.0 - ((v9 + 0.75) / v15))) * math.sqrt(v11)) * (1.0 + (v29 * (((((((((((((0.01524698625788054 * v29) + 0.5334320651111477) * v29) + 2.250488865813539) * v29) + 2.8612106440066865) * v29) + 1.3794681629043655) * v29) + 0.2596058532893223) * v29) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v29) + 49.328555418276075) * v29) + 167.28648538571198) * v29) + 195.37226190335065) * v29) + 90.69722535867314) * v29) + 16.763212110504565) * v29) + 1.0)))))) * Math.pow(t, n)) / t);
};

const log_ratio = (a, c) => {
  if ((a > c)) {
    return math.log1p(((a - c) / c));
  }
  return 0.0;
};

const DECAY = 42.0;

const _weight = (s) => {
  if ((s > 0.0)) {
    return ((2.0 * s) / math.sqrt((-Math.expm1((((-2.0) * s) * s)))));
  }
  return 1.4142135623730951;
};

const NODES_of_slip = 64;

const arc_gain = (r, c, a) => {
  let v13, v17, v20, v3, v7;
  v3 = (a - c);
  v13 = (c - r);
  v17 = math.sqrt(((((v13 > 0.0) || (v13 !== v13)) ? v13 : 0.0) * (c + r)));
  if ((a > c)) {
    v7 = (a - r);
    v20 = ((v3 * (a + c)) / (math.sqrt(((((v7 > 0.0) || (v7 !== v7)) ? v7 : 0.0) * (a + r))) + v17));
  } else {
    v20 = 0.0;
  }
  return math.log1p(((v3 + v20) / (c + v17)));
};

const power_gain = (r, c, a, n) => {
  let centre, cut, depth, end, growth, inner, integrand, largest, outer, rate, reach, side, start, steep, within;
  [growth, depth] = [log_ratio(a, c), log_ratio(a, r)];
  [outer, inner] = [Math.sqrt(depth), Math.sqrt(log_ratio(c, r))];
  [steep, rate] = [(n > 1.0), Math.abs((n - 1.0))];
  end = (DECAY / math.maximum(rate, 0.001));
  start = (math.truth(steep) ? outer : inner);
  side = (1.0 - (2.0 * steep));
  cut = Math.sqrt(math.maximum(((start * start) + (side * end)), 0.0));
  reach = ((growth > end) ? (end / (start + cut)) : (growth / (outer + inner)));
  integrand = (step) => {
    let fall;
    fall = (step * ((2.0 * start) + (side * step)));
    return (Math.exp(((-rate) * fall)) * _weight(math.maximum((start + (side * step)), 0.0)));
  };
  largest = (math.truth(steep) ? 1.0 : (Math.pow((c / a), n) * (a / c)));
  within = ((reach > 0.0) ? math.integral(integrand, reach, NODES_of_slip) : 0.0);
  centre = ((-Math.expm1(((-rate) * growth))) / ((rate > 0.0) ? rate : 1.0));
  return ((rate > 0.0) ? (largest * ((r > 0.0) ? within : centre)) : arc_gain(r, c, a));
};

const _traction = (r, a, c, A, n, E_star, mu) => {
  let gain, sliding;
  sliding = _pressure_of_power_law(r, a, A, n, E_star);
  gain = (((E_star / Math.PI) * _slope(a, A, n)) * power_gain(r, c, a, n));
  return (mu * ((r < c) ? gain : sliding));
};

const traction = (r, a, c, A, n, E_star, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction(r, a, c, A, n, E_star, mu) : 0.0) : NaN);
};

const _tangential_displacement_of_power_law = (a, c, A, n, E_star, G_star, mu) => {
  return (((mu * (E_star / G_star)) * _depth_3(a, A, n)) * gained_share(c, a, n));
};

const _tangential_displacement = (a, c, A, n, E_star, G_star, mu) => {
  let v12, v14, v18, v32;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v12 = ((n / 2.0) + 0.5);
    v14 = (v12 + 1.75);
    v18 = ((v12 + 0.5) * (v12 + 1.5));
    v32 = (1.0 / (v14 * v14));
    return (((mu * (E_star / G_star)) * (((1.7724538509055159 * A) * Math.pow(a, n)) * ((((v12 < 1.0) ? ((v12 * (v12 + 1.0)) / v18) : (1.0 - ((v12 + 0.75) / v18))) * Math.sqrt(v14)) * (1.0 + (v32 * (((((((((((((0.01524698625788054 * v32) + 0.5334320651111477) * v32) + 2.250488865813539) * v32) + 2.8612106440066865) * v32) + 1.3794681629043655) * v32) + 0.2596058532893223) * v32) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v32) + 49.328555418276075) * v32) + 167.28648538571198) * v32) + 195.37226190335065) * v32) + 90.69722535867314) * v32) + 16.763212110504565) * v32) + 1.0))))))) * (-Math.expm1(((-n) * ((a > c) ? Math.log1p(((a - c) / c)) : 0.0)))));
  }
  return _tangential_displacement_of_power_law(a, c, A, n, E_star, G_star, mu);
};

const tangential_displacement = (a, c, A, n, E_star, G_star, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement(a, c, A, n, E_star, G_star, mu) : NaN);
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

const _radius_from_force_2 = (F, A, n, E_star) => {
  let kappa, ratio;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  ratio = (((n + 1) * F) / (((((2 * Math.sqrt(Math.PI)) * E_star) * n) * A) * kappa));
  return nth_root_of_functions(ratio, n, 1);
};

const _stick_radius_of_power_law = (F_x, a, A, n, E_star, mu) => {
  let F;
  F = stick_force(_force_of_power_law(a, A, n, E_star), F_x, mu);
  return math.where(((F_x === 0.0) & (a >= 0.0)), a, _radius_from_force_2(F, A, n, E_star));
};

const _stick_radius = (F_x, a, A, n, E_star, mu) => {
  let v11, v15, v29, v70, v74, v75, v80, v82, v88, v9, v97, v99;
  if (((F_x > 1e-30) && (F_x < 1e+30) && (a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    if (((F_x === 0.0) && (a >= 0.0))) {
      return a;
    }
    v9 = ((n / 2.0) + 0.5);
    v11 = (v9 + 1.75);
    v15 = ((v9 + 0.5) * (v9 + 1.5));
    v29 = (1.0 / (v11 * v11));
    v70 = ((((v9 < 1.0) ? ((v9 * (v9 + 1.0)) / v15) : (1.0 - ((v9 + 0.75) / v15))) * Math.sqrt(v11)) * (1.0 + (v29 * (((((((((((((0.01524698625788054 * v29) + 0.5334320651111477) * v29) + 2.250488865813539) * v29) + 2.8612106440066865) * v29) + 1.3794681629043655) * v29) + 0.2596058532893223) * v29) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v29) + 49.328555418276075) * v29) + 167.28648538571198) * v29) + 195.37226190335065) * v29) + 90.69722535867314) * v29) + 16.763212110504565) * v29) + 1.0)))));
    v74 = (((3.5449077018110318 * E_star) * n) * A);
    v75 = (n + 1.0);
    v80 = ((((v74 / v75) * a) * Math.pow(a, n)) * v70);
    v82 = (v80 - (F_x / mu));
    v88 = ((Math.abs(v82) <= (2e-16 * v80)) ? 0.0 : v82);
    v97 = ((v75 * ((v88 >= 0.0) ? v88 : NaN)) / (v74 * v70));
    v99 = Math.pow(v97, (1.0 / v75));
    if (((v97 > 0.0) && (v97 < Infinity))) {
      return (v99 + (v99 * (((v97 / (Math.pow(v99, n) * Math.pow(v99, 1.0))) - 1.0) / v75)));
    }
    return v99;
  }
  return _stick_radius_of_power_law(F_x, a, A, n, E_star, mu);
};

const stick_radius = (F_x, a, A, n, E_star, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius(F_x, a, A, n, E_star, mu) : NaN);
};

const _full_slip_displacement_of_power_law = (a, A, n, E_star, G_star, mu) => {
  return ((mu * (E_star / G_star)) * _depth_3(a, A, n));
};

const _full_slip_displacement = (a, A, n, E_star, G_star, mu) => {
  let v11, v13, v17, v31;
  if (((a > 1e-30) && (a < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30))) {
    v11 = ((n / 2.0) + 0.5);
    v13 = (v11 + 1.75);
    v17 = ((v11 + 0.5) * (v11 + 1.5));
    v31 = (1.0 / (v13 * v13));
    return ((mu * (E_star / G_star)) * (((1.7724538509055159 * A) * Math.pow(a, n)) * ((((v11 < 1.0) ? ((v11 * (v11 + 1.0)) / v17) : (1.0 - ((v11 + 0.75) / v17))) * Math.sqrt(v13)) * (1.0 + (v31 * (((((((((((((0.01524698625788054 * v31) + 0.5334320651111477) * v31) + 2.250488865813539) * v31) + 2.8612106440066865) * v31) + 1.3794681629043655) * v31) + 0.2596058532893223) * v31) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v31) + 49.328555418276075) * v31) + 167.28648538571198) * v31) + 195.37226190335065) * v31) + 90.69722535867314) * v31) + 16.763212110504565) * v31) + 1.0)))))));
  }
  return _full_slip_displacement_of_power_law(a, A, n, E_star, G_star, mu);
};

const full_slip_displacement = (a, A, n, E_star, G_star, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement(a, A, n, E_star, G_star, mu) : NaN);
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

const _depth_4 = (a, A, n, k) => {
  return (A * power_depth(a, n, k));
};

const depth_2 = (a, A, n, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_4(a, A, n, k) : NaN);
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

const _force_4 = (a, A, n, H, k) => {
  let growth;
  growth = (A * power_force(a, n, k));
  return (((2.0 * H) / (1.0 + k)) * growth);
};

const force_2 = (a, A, n, H, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_4(a, A, n, H, k) : NaN);
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

const RULE_0_of_pressure = math.rule([[Infinity, 64]]);

const _steep = (rest, near, m, half) => {
  let node, v11, v12, v14, v15, v25, v26, v6, v7, weight;
  v6 = (Number.isFinite(rest) ? rest : Infinity);
  v7 = Math.abs(m);
  v11 = (42.0 / (((v7 > 20.0) || (v7 !== v7)) ? v7 : 20.0));
  v12 = (((v6 < v11) || (v6 !== v6)) ? v6 : v11);
  v15 = (-m);
  v26 = [];
  for ([node, weight] of RULE_0_of_pressure((v12 / 1.0))) {
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

const power_pressure_of_pressure = (r, a, n, k) => {
  return (((power_factor(n, k) * n) * ((Math.pow(a, n) / a) * Math.pow(a, k))) * power_growth(r, a, n, k));
};

const _pressure_5 = (r, a, A, n, H, k) => {
  let growth, inside;
  inside = math.minimum(r, a);
  growth = (A * power_pressure_of_pressure(inside, a, n, k));
  return ((r < a) ? ((H / Math.PI) * growth) : 0.0);
};

const pressure_2 = (r, a, A, n, H, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_5(r, a, A, n, H, k) : 0.0) : NaN);
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

const difference_root = (x, y) => {
  let v2;
  v2 = (x - y);
  return math.sqrt(((((v2 > 0.0) || (v2 !== v2)) ? v2 : 0.0) * (x + y)));
};

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

const power_displacement_of_displacement = (r, a, n, k) => {
  let excess, over, ratio;
  ratio = ((r < (0.5 * a)) ? Math.log((r / a)) : ((r < a) ? Math.log1p(((r - a) / a)) : 0.0));
  excess = power_excess(n, k);
  over = ((r > a) ? _beside_power(r, a, n, k, excess) : (excess - Math.expm1((n * ratio))));
  return ((a > 0.0) ? (Math.pow(a, n) * over) : 0.0);
};

const _displacement_5 = (r, a, A, n, k) => {
  return (A * power_displacement_of_displacement(r, a, n, k));
};

const displacement_2 = (r, a, A, n, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_5(r, a, A, n, k) : 0.0) : NaN);
};

const punch_stiffness = (a, H, k) => {
  return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
};

const _stiffness_3 = (a, H, k) => {
  return punch_stiffness(a, H, k);
};

const _stiffness_2 = (a, H, k, A = 1.0, n = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (H > 1e-30) && (H < 1e+30) && (k > 1e-30) && (k < 1.0) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30))) {
    return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  }
  return _stiffness_3(a, H, k);
};

const stiffness_of_power_law = (a, A, n, H, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
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

const _mean_pressure_2 = (a, A, n, H, k) => {
  let growth;
  growth = (A * power_mean(a, n, k));
  return ((((2.0 * H) / (1.0 + k)) / Math.PI) * growth);
};

const mean_pressure_of_power_law = (a, A, n, H, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure_2(a, A, n, H, k) : NaN);
};

const _radius_from_depth_2 = (d, A, n, k) => {
  return Math.pow((d / _depth_4(math.ones_like(d), A, n, k)), (1.0 / n));
};

const radius_from_depth_2 = (d, A, n, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth_2(d, A, n, k) : NaN);
};

const _radius_from_force_3 = (F, A, n, H, k) => {
  return Math.pow((F / _force_4(math.ones_like(F), A, n, H, k)), (1.0 / (n + (1.0 + k))));
};

const radius_from_force_2 = (F, A, n, H, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _radius_from_force_3(F, A, n, H, k) : NaN);
};

const _force_from_depth_of_power_law = (d, A, n, H, k) => {
  let stiffness;
  stiffness = punch_stiffness(_radius_from_depth_2(d, A, n, k), H, k);
  return (((d > 0.0) & Number.isFinite(d)) ? (d * (stiffness * (n / (n + (1.0 + k))))) : d);
};

const force_from_depth_of_power_law = (d, A, n, H, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth_of_power_law(d, A, n, H, k) : NaN);
};

const _depth_from_force_2 = (F, A, n, H, k) => {
  let stiffness;
  stiffness = punch_stiffness(_radius_from_force_3(F, A, n, H, k), H, k);
  return (((F > 0.0) & Number.isFinite(F)) ? (F / (stiffness * (n / (n + (1.0 + k))))) : F);
};

const depth_from_force_of_power_law = (F, A, n, H, k) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force_2(F, A, n, H, k) : NaN);
};

const graded_retraction = (a, H, k, dgamma) => {
  if ((a > 0.0)) {
    return ((math.sqrt(((6.283185307179586 * dgamma) / H)) * math.sqrt(a)) * math.sqrt(Math.pow(a, (-k))));
  }
  return 0.0;
};

const retraction_of_power_law = (a, H, k, dgamma) => {
  if ((!((0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? graded_retraction(a, H, k, dgamma) : NaN);
};

const _depth_5 = (a, A, n, H, k, dgamma) => {
  return (_depth_4(a, A, n, k) - graded_retraction(a, H, k, dgamma));
};

const depth_3 = (a, A, n, H, k, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_5(a, A, n, H, k, dgamma) : NaN);
};

const _force_5 = (a, A, n, H, k, dgamma) => {
  return (_force_4(a, A, n, H, k) - (punch_stiffness(a, H, k) * graded_retraction(a, H, k, dgamma)));
};

const force_3 = (a, A, n, H, k, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_5(a, A, n, H, k, dgamma) : NaN);
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

const _pressure_6 = (r, a, A, n, H, k, dgamma) => {
  return (_pressure_5(r, a, A, n, H, k) - tension_of_punch(r, a, H, k, dgamma));
};

const pressure_3 = (r, a, A, n, H, k, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_6(r, a, A, n, H, k, dgamma) : 0.0) : NaN);
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

const _displacement_6 = (r, a, A, n, H, k, dgamma) => {
  return (_displacement_5(r, a, A, n, k) - (graded_retraction(a, H, k, dgamma) * punch_displacement(r, a, k)));
};

const displacement_3 = (r, a, A, n, H, k, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_6(r, a, A, n, H, k, dgamma) : 0.0) : NaN);
};

const power_rate = (t, n, k) => {
  return ((power_factor(n, k) * n) * (Math.pow(t, n) / t));
};

const _rate = (a, A, n, k) => {
  return (A * power_rate(a, n, k));
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

const _pull_off_radius_of_power_law = (A, n, H, k, dgamma, control) => {
  let own, rate;
  rate = _rate(math.ones_like((H * k)), A, n, k);
  own = unloading_radius(rate, n, H, k, dgamma, control);
  return ((dgamma > 0.0) ? own : 0.0);
};

const _pull_off_depth_of_power_law = (a, A, n, H, k, dgamma, control) => {
  return (_depth_4(a, A, n, k) * (1.0 - ((2.0 * n) / stationary(control, k))));
};

const _radius_from_depth_3 = (d, A, n, H, k, dgamma) => {
  let a_c, least, plain;
  a_c = _pull_off_radius_of_power_law(A, n, H, k, dgamma, 'depth');
  least = _pull_off_depth_of_power_law(a_c, A, n, H, k, dgamma, 'depth');
  plain = _radius_from_depth_2(math.maximum(d, 0.0), A, n, k);
  return power_law_radius(d, a_c, least, n, ((1.0 - k) / 2.0), plain);
};

const radius_from_depth_3 = (d, A, n, H, k, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > ((1.0 - math.asarray(k)) / 2.0)))) {
    return NaN;
  }
  return _radius_from_depth_3(d, A, n, H, k, dgamma);
};

const _pull_off_force_of_power_law = (a, A, n, H, k, dgamma, control) => {
  return (_force_4(a, A, n, H, k) * (1.0 - ((2.0 * ((n + 1.0) + k)) / stationary(control, k))));
};

const _radius_from_force_4 = (F, A, n, H, k, dgamma) => {
  let a_c, least, plain;
  a_c = _pull_off_radius_of_power_law(A, n, H, k, dgamma, 'force');
  least = _pull_off_force_of_power_law(a_c, A, n, H, k, dgamma, 'force');
  plain = _radius_from_force_3(math.maximum(F, 0.0), A, n, H, k);
  return power_law_radius(F, a_c, least, ((n + 1.0) + k), ((3.0 + k) / 2.0), plain);
};

const radius_from_force_3 = (F, A, n, H, k, dgamma) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > ((1.0 - math.asarray(k)) / 2.0)))) {
    return NaN;
  }
  return _radius_from_force_4(F, A, n, H, k, dgamma);
};

const pull_off_of_power_law = (control = 'force', A, n, H, k, dgamma) => {
  let depth, force, radius;
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > ((1.0 - math.asarray(k)) / 2.0)))) {
    return NaN;
  }
  radius = _pull_off_radius_of_power_law(A, n, H, k, dgamma, control);
  force = ((radius >= 0.0) ? _pull_off_force_of_power_law(radius, A, n, H, k, dgamma, control) : NaN);
  depth = ((radius >= 0.0) ? _pull_off_depth_of_power_law(radius, A, n, H, k, dgamma, control) : NaN);
  return PullOff(radius, force, depth);
};

const DECAY_of_slip = 42.0;

const _span_of_slip = (c, a, distance) => {
  if ((a > c)) {
    return (0.5 * math.log1p((((a - c) / distance) * ((a + c) / distance))));
  }
  return 0.0;
};

const PANEL = 9.0;

const NODES_2 = 64;

const _power_growth = (r, c, a, n, k) => {
  let cut, end, falls, inner, integrand, last, lost, outer, side, start, stop, within;
  [inner, outer] = [difference_root(c, r), difference_root(a, r)];
  falls = ((n + (k - 1.0)) >= 0.0);
  end = (math.truth(falls) ? a : c);
  start = (math.truth(falls) ? outer : inner);
  side = (1.0 - (2.0 * falls));
  lost = (Math.pow((a / outer), 2) * (-Math.expm1((((-2.0) * DECAY_of_slip) / math.maximum((n - 2.0), 0.001)))));
  cut = ((-0.5) * Math.log1p((-math.minimum(lost, (1.0 - 1e-16)))));
  last = (((n > 2.0) & (lost < 1.0)) ? cut : Infinity);
  stop = math.minimum(_span_of_slip(c, a, inner), last);
  integrand = (w) => {
    let base, change, distance;
    distance = (start * Math.exp((side * w)));
    base = (math.truth(falls) ? ((r * r) + (distance * distance)) : (c * c));
    change = (0.5 * Math.log1p((((start * start) * Math.abs(Math.expm1(((2.0 * side) * w)))) / base)));
    return Math.exp((side * (((n - 2.0) * change) + ((1.0 + k) * w))));
  };
  within = math.integral_by_panels(integrand, stop, (PANEL * math.ones_like(stop)), NODES_2);
  return ((((Math.pow(end, n) / end) / end) * raised(start, k)) * within);
};

const power_gain_of_slip = (quantity, r, c, a, n, k) => {
  if ((quantity === 'depth')) {
    return (power_depth(a, n, k) * gained_share(c, a, n));
  }
  if ((quantity === 'force')) {
    return (power_force(a, n, k) * gained_share(c, a, (n + (1.0 + k))));
  }
  return ((power_factor(n, k) * n) * _power_growth(r, c, a, n, k));
};

const _tangential_force_2 = (a, c, A, n, H, k, mu) => {
  let gain;
  gain = (A * power_gain_of_slip('force', 0.0, c, a, n, k));
  return ((mu * ((2.0 * H) / (1.0 + k))) * gain);
};

const tangential_force_of_power_law = (a, c, A, n, H, k, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_force_2(a, c, A, n, H, k, mu) : NaN);
};

const either = (condition, x, y) => {
  if (Boolean(condition)) {
    return x();
  }
  return (Boolean(condition) ? (math.truth(condition) ? x() : y()) : y());
};

const _traction_of_power_law = (r, a, c, A, n, H, k, mu) => {
  let gain;
  gain = () => {
    let inside;
    inside = math.minimum(r, c);
    return (A * power_gain_of_slip('pressure', inside, c, a, n, k));
  };
  return (mu * either((r < c), (() => ((H / Math.PI) * gain())), (() => _pressure_5(r, a, A, n, H, k))));
};

const traction_of_power_law = (r, a, c, A, n, H, k, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction_of_power_law(r, a, c, A, n, H, k, mu) : 0.0) : NaN);
};

const _tangential_displacement_2 = (a, c, A, n, H, H_x, k, mu) => {
  let gain;
  gain = (A * power_gain_of_slip('depth', 0.0, c, a, n, k));
  return ((mu * (H / H_x)) * gain);
};

const tangential_displacement_of_power_law = (a, c, A, n, H, H_x, k, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement_2(a, c, A, n, H, H_x, k, mu) : NaN);
};

const _stick_radius_2 = (F_x, a, A, n, H, k, mu) => {
  let F;
  F = stick_force(_force_4(a, A, n, H, k), F_x, mu);
  return (((F_x === 0.0) & (a >= 0.0)) ? a : _radius_from_force_3(F, A, n, H, k));
};

const stick_radius_of_power_law = (F_x, a, A, n, H, k, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius_2(F_x, a, A, n, H, k, mu) : NaN);
};

const _full_slip_displacement_2 = (a, A, n, H, H_x, k, mu) => {
  return ((mu * (H / H_x)) * _depth_4(a, A, n, k));
};

const full_slip_displacement_of_power_law = (a, A, n, H, H_x, k, mu) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement_2(a, A, n, H, H_x, k, mu) : NaN);
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

const _ramp_force_maxwell = (t, v, A, n, E, tau) => {
  let force, m;
  m = ((n + 1) / n);
  force = (_force_from_depth((v * t), A, n, 1.0) * ramp_maxwell(t, m, E, tau));
  return ((t === 0.0) ? 0.0 : force);
};

const ramp_force_maxwell = (t, A, n, v, E, tau) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < v && v < Infinity) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _ramp_force_maxwell(t, v, A, n, E, tau) : NaN);
};

const relaxation_maxwell = (t, E, tau) => {
  return (E * Math.exp(((-t) / tau)));
};

const _force_from_depth_2 = (d, A, n, E_star) => {
  let kappa, ratio;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  ratio = (d / ((Math.sqrt(Math.PI) * A) * kappa));
  return ((((((((2 * Math.sqrt(Math.PI)) * E_star) * n) * A) / (n + 1)) * kappa) * ratio) * nth_root_of_functions(ratio, n));
};

const _step_force_maxwell_of_power_law = (t, d, A, n, E, tau) => {
  return (relaxation_maxwell(t, E, tau) * _force_from_depth_2(d, A, n, 1.0));
};

const _step_force_maxwell = (t, d, A, n, E, tau) => {
  let v13, v15, v19, v33, v74, v78, v87, v89;
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E > 1e-30) && (E < 1e+30) && (tau > 1e-30) && (tau < 1e+30))) {
    v13 = ((n / 2.0) + 0.5);
    v15 = (v13 + 1.75);
    v19 = ((v13 + 0.5) * (v13 + 1.5));
    v33 = (1.0 / (v15 * v15));
    v74 = ((((v13 < 1.0) ? ((v13 * (v13 + 1.0)) / v19) : (1.0 - ((v13 + 0.75) / v19))) * Math.sqrt(v15)) * (1.0 + (v33 * (((((((((((((0.01524698625788054 * v33) + 0.5334320651111477) * v33) + 2.250488865813539) * v33) + 2.8612106440066865) * v33) + 1.3794681629043655) * v33) + 0.2596058532893223) * v33) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v33) + 49.328555418276075) * v33) + 167.28648538571198) * v33) + 195.37226190335065) * v33) + 90.69722535867314) * v33) + 16.763212110504565) * v33) + 1.0)))));
    v78 = (d / ((1.7724538509055159 * A) * v74));
    v87 = (n + 0.0);
    v89 = Math.pow(v78, (1.0 / v87));
    return ((E * Math.exp(((-t) / tau))) * ((((((3.5449077018110318 * n) * A) / (n + 1.0)) * v74) * v78) * (((v78 > 0.0) && (v78 < Infinity)) ? (v89 + (v89 * (((v78 / (Math.pow(v89, n) * Math.pow(v89, 0.0))) - 1.0) / v87))) : v89)));
  }
  return _step_force_maxwell_of_power_law(t, d, A, n, E, tau);
};

const step_force_maxwell = (t, d, A, n, E, tau) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_maxwell(t, d, A, n, E, tau) : NaN);
};

const creep_maxwell = (t, E, tau) => {
  return ((1.0 + (t / tau)) / E);
};

const _step_load_radius_maxwell_of_power_law = (t, F, A, n, E, tau) => {
  return _radius_from_force_2((F * creep_maxwell(t, E, tau)), A, n, 1.0);
};

const _step_load_radius_maxwell = (t, F, A, n, E, tau) => {
  let v14, v16, v20, v33, v75, v81, v83;
  if (((t > 1e-30) && (t < 1e+30) && (F > 1e-30) && (F < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E > 1e-30) && (E < 1e+30) && (tau > 1e-30) && (tau < 1e+30))) {
    v14 = ((n / 2.0) + 0.5);
    v16 = (v14 + 1.75);
    v20 = ((v14 + 0.5) * (v14 + 1.5));
    v33 = (1.0 / (v16 * v16));
    v75 = (n + 1.0);
    v81 = ((v75 * (F * ((1.0 + (t / tau)) / E))) / (((3.5449077018110318 * n) * A) * ((((v14 < 1.0) ? ((v14 * (v14 + 1.0)) / v20) : (1.0 - ((v14 + 0.75) / v20))) * Math.sqrt(v16)) * (1.0 + (v33 * (((((((((((((0.01524698625788054 * v33) + 0.5334320651111477) * v33) + 2.250488865813539) * v33) + 2.8612106440066865) * v33) + 1.3794681629043655) * v33) + 0.2596058532893223) * v33) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v33) + 49.328555418276075) * v33) + 167.28648538571198) * v33) + 195.37226190335065) * v33) + 90.69722535867314) * v33) + 16.763212110504565) * v33) + 1.0)))))));
    v83 = Math.pow(v81, (1.0 / v75));
    if (((v81 > 0.0) && (v81 < Infinity))) {
      return (v83 + (v83 * (((v81 / (Math.pow(v83, n) * Math.pow(v83, 1.0))) - 1.0) / v75)));
    }
    return v83;
  }
  return _step_load_radius_maxwell_of_power_law(t, F, A, n, E, tau);
};

const step_load_radius_maxwell = (t, F, A, n, E, tau) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_maxwell(t, F, A, n, E, tau) : NaN);
};

const ramp_kelvin_voigt = (t, m, E, eta) => {
  return (E + ((eta * m) / t));
};

const _ramp_force_kelvin_voigt_of_power_law = (t, v, A, n, E, eta) => {
  let force, m;
  m = ((n + 1) / n);
  force = (_force_from_depth_2((v * t), A, n, 1.0) * ramp_kelvin_voigt(t, m, E, eta));
  return math.where((t === 0.0), 0.0, force);
};

const _ramp_force_kelvin_voigt = (t, v, A, n, E, eta) => {
  let v13, v15, v19, v32, v7, v73, v77, v85, v87;
  if (((t > 1e-30) && (t < 1e+30) && (v > 1e-30) && (v < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E > 1e-30) && (E < 1e+30) && (eta > 1e-30) && (eta < 1e+30))) {
    if ((t === 0.0)) {
      return 0.0;
    }
    v7 = (n + 1.0);
    v13 = ((n / 2.0) + 0.5);
    v15 = (v13 + 1.75);
    v19 = ((v13 + 0.5) * (v13 + 1.5));
    v32 = (1.0 / (v15 * v15));
    v73 = ((((v13 < 1.0) ? ((v13 * (v13 + 1.0)) / v19) : (1.0 - ((v13 + 0.75) / v19))) * Math.sqrt(v15)) * (1.0 + (v32 * (((((((((((((0.01524698625788054 * v32) + 0.5334320651111477) * v32) + 2.250488865813539) * v32) + 2.8612106440066865) * v32) + 1.3794681629043655) * v32) + 0.2596058532893223) * v32) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v32) + 49.328555418276075) * v32) + 167.28648538571198) * v32) + 195.37226190335065) * v32) + 90.69722535867314) * v32) + 16.763212110504565) * v32) + 1.0)))));
    v77 = ((v * t) / ((1.7724538509055159 * A) * v73));
    v85 = (n + 0.0);
    v87 = Math.pow(v77, (1.0 / v85));
    return (((((((3.5449077018110318 * n) * A) / v7) * v73) * v77) * (((v77 > 0.0) && (v77 < Infinity)) ? (v87 + (v87 * (((v77 / (Math.pow(v87, n) * Math.pow(v87, 0.0))) - 1.0) / v85))) : v87)) * (E + ((eta * (v7 / n)) / t)));
  }
  return _ramp_force_kelvin_voigt_of_power_law(t, v, A, n, E, eta);
};

const ramp_force_kelvin_voigt = (t, A, n, v, E, eta) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < v && v < Infinity) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _ramp_force_kelvin_voigt(t, v, A, n, E, eta) : NaN);
};

const relaxation_kelvin_voigt = (t, E, eta) => {
  if ((t > 0.0)) {
    return E;
  }
  return Infinity;
};

const _step_force_kelvin_voigt_of_power_law = (t, d, A, n, E, eta) => {
  return (relaxation_kelvin_voigt(t, E, eta) * _force_from_depth_2(d, A, n, 1.0));
};

const _step_force_kelvin_voigt = (t, d, A, n, E, eta) => {
  let v13, v15, v19, v33, v74, v78, v86, v88;
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E > 1e-30) && (E < 1e+30) && (eta > 1e-30) && (eta < 1e+30))) {
    v13 = ((n / 2.0) + 0.5);
    v15 = (v13 + 1.75);
    v19 = ((v13 + 0.5) * (v13 + 1.5));
    v33 = (1.0 / (v15 * v15));
    v74 = ((((v13 < 1.0) ? ((v13 * (v13 + 1.0)) / v19) : (1.0 - ((v13 + 0.75) / v19))) * Math.sqrt(v15)) * (1.0 + (v33 * (((((((((((((0.01524698625788054 * v33) + 0.5334320651111477) * v33) + 2.250488865813539) * v33) + 2.8612106440066865) * v33) + 1.3794681629043655) * v33) + 0.2596058532893223) * v33) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v33) + 49.328555418276075) * v33) + 167.28648538571198) * v33) + 195.37226190335065) * v33) + 90.69722535867314) * v33) + 16.763212110504565) * v33) + 1.0)))));
    v78 = (d / ((1.7724538509055159 * A) * v74));
    v86 = (n + 0.0);
    v88 = Math.pow(v78, (1.0 / v86));
    return (((t > 0.0) ? E : Infinity) * ((((((3.5449077018110318 * n) * A) / (n + 1.0)) * v74) * v78) * (((v78 > 0.0) && (v78 < Infinity)) ? (v88 + (v88 * (((v78 / (Math.pow(v88, n) * Math.pow(v88, 0.0))) - 1.0) / v86))) : v88)));
  }
  return _step_force_kelvin_voigt_of_power_law(t, d, A, n, E, eta);
};

const step_force_kelvin_voigt = (t, d, A, n, E, eta) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_kelvin_voigt(t, d, A, n, E, eta) : NaN);
};

const creep_kelvin_voigt = (t, E, eta) => {
  return ((-Math.expm1((((-E) * t) / eta))) / E);
};

const _step_load_radius_kelvin_voigt_of_power_law = (t, F, A, n, E, eta) => {
  return _radius_from_force_2((F * creep_kelvin_voigt(t, E, eta)), A, n, 1.0);
};

const _step_load_radius_kelvin_voigt = (t, F, A, n, E, eta) => {
  let v16, v18, v22, v36, v78, v84, v86;
  if (((t > 1e-30) && (t < 1e+30) && (F > 1e-30) && (F < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E > 1e-30) && (E < 1e+30) && (eta > 1e-30) && (eta < 1e+30))) {
    v16 = ((n / 2.0) + 0.5);
    v18 = (v16 + 1.75);
    v22 = ((v16 + 0.5) * (v16 + 1.5));
    v36 = (1.0 / (v18 * v18));
    v78 = (n + 1.0);
    v84 = ((v78 * (F * ((-Math.expm1((((-E) * t) / eta))) / E))) / (((3.5449077018110318 * n) * A) * ((((v16 < 1.0) ? ((v16 * (v16 + 1.0)) / v22) : (1.0 - ((v16 + 0.75) / v22))) * Math.sqrt(v18)) * (1.0 + (v36 * (((((((((((((0.01524698625788054 * v36) + 0.5334320651111477) * v36) + 2.250488865813539) * v36) + 2.8612106440066865) * v36) + 1.3794681629043655) * v36) + 0.2596058532893223) * v36) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v36) + 49.328555418276075) * v36) + 167.28648538571198) * v36) + 195.37226190335065) * v36) + 90.69722535867314) * v36) + 16.763212110504565) * v36) + 1.0)))))));
    v86 = Math.pow(v84, (1.0 / v78));
    if (((v84 > 0.0) && (v84 < Infinity))) {
      return (v86 + (v86 * (((v84 / (Math.pow(v86, n) * Math.pow(v86, 1.0))) - 1.0) / v78)));
    }
    return v86;
  }
  return _step_load_radius_kelvin_voigt_of_power_law(t, F, A, n, E, eta);
};

const step_load_radius_kelvin_voigt = (t, F, A, n, E, eta) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_kelvin_voigt(t, F, A, n, E, eta) : NaN);
};

const ramp_standard_solid = (t, m, E_inf, E_1, tau) => {
  return (E_inf + (E_1 * fading((t / tau), m)));
};

const _ramp_force_standard_solid = (t, v, A, n, E_inf, E_1, tau) => {
  let force, m;
  m = ((n + 1) / n);
  force = (_force_from_depth((v * t), A, n, 1.0) * ramp_standard_solid(t, m, E_inf, E_1, tau));
  return ((t === 0.0) ? 0.0 : force);
};

const ramp_force_standard_solid = (t, A, n, v, E_inf, E_1, tau) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < v && v < Infinity) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _ramp_force_standard_solid(t, v, A, n, E_inf, E_1, tau) : NaN);
};

const relaxation_standard_solid = (t, E_inf, E_1, tau) => {
  return (E_inf + (E_1 * Math.exp(((-t) / tau))));
};

const _step_force_standard_solid_of_power_law = (t, d, A, n, E_inf, E_1, tau) => {
  return (relaxation_standard_solid(t, E_inf, E_1, tau) * _force_from_depth_2(d, A, n, 1.0));
};

const _step_force_standard_solid = (t, d, A, n, E_inf, E_1, tau) => {
  let v15, v17, v21, v35, v76, v80, v89, v91;
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_inf > 1e-30) && (E_inf < 1e+30) && (E_1 > 1e-30) && (E_1 < 1e+30) && (tau > 1e-30) && (tau < 1e+30))) {
    v15 = ((n / 2.0) + 0.5);
    v17 = (v15 + 1.75);
    v21 = ((v15 + 0.5) * (v15 + 1.5));
    v35 = (1.0 / (v17 * v17));
    v76 = ((((v15 < 1.0) ? ((v15 * (v15 + 1.0)) / v21) : (1.0 - ((v15 + 0.75) / v21))) * Math.sqrt(v17)) * (1.0 + (v35 * (((((((((((((0.01524698625788054 * v35) + 0.5334320651111477) * v35) + 2.250488865813539) * v35) + 2.8612106440066865) * v35) + 1.3794681629043655) * v35) + 0.2596058532893223) * v35) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v35) + 49.328555418276075) * v35) + 167.28648538571198) * v35) + 195.37226190335065) * v35) + 90.69722535867314) * v35) + 16.763212110504565) * v35) + 1.0)))));
    v80 = (d / ((1.7724538509055159 * A) * v76));
    v89 = (n + 0.0);
    v91 = Math.pow(v80, (1.0 / v89));
    return ((E_inf + (E_1 * Math.exp(((-t) / tau)))) * ((((((3.5449077018110318 * n) * A) / (n + 1.0)) * v76) * v80) * (((v80 > 0.0) && (v80 < Infinity)) ? (v91 + (v91 * (((v80 / (Math.pow(v91, n) * Math.pow(v91, 0.0))) - 1.0) / v89))) : v91)));
  }
  return _step_force_standard_solid_of_power_law(t, d, A, n, E_inf, E_1, tau);
};

const step_force_standard_solid = (t, d, A, n, E_inf, E_1, tau) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_standard_solid(t, d, A, n, E_inf, E_1, tau) : NaN);
};

const creep_standard_solid = (t, E_inf, E_1, tau) => {
  let v4;
  v4 = (E_inf + E_1);
  return ((1.0 / v4) - (((E_1 / v4) * Math.expm1((-((t / tau) * (E_inf / v4))))) / E_inf));
};

const _step_load_radius_standard_solid_of_power_law = (t, F, A, n, E_inf, E_1, tau) => {
  return _radius_from_force_2((F * creep_standard_solid(t, E_inf, E_1, tau)), A, n, 1.0);
};

const _step_load_radius_standard_solid = (t, F, A, n, E_inf, E_1, tau) => {
  let v23, v25, v29, v42, v7, v84, v90, v92;
  if (((t > 1e-30) && (t < 1e+30) && (F > 1e-30) && (F < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_inf > 1e-30) && (E_inf < 1e+30) && (E_1 > 1e-30) && (E_1 < 1e+30) && (tau > 1e-30) && (tau < 1e+30))) {
    v7 = (E_inf + E_1);
    v23 = ((n / 2.0) + 0.5);
    v25 = (v23 + 1.75);
    v29 = ((v23 + 0.5) * (v23 + 1.5));
    v42 = (1.0 / (v25 * v25));
    v84 = (n + 1.0);
    v90 = ((v84 * (F * ((1.0 / v7) - (((E_1 / v7) * Math.expm1((-((t / tau) * (E_inf / v7))))) / E_inf)))) / (((3.5449077018110318 * n) * A) * ((((v23 < 1.0) ? ((v23 * (v23 + 1.0)) / v29) : (1.0 - ((v23 + 0.75) / v29))) * Math.sqrt(v25)) * (1.0 + (v42 * (((((((((((((0.01524698625788054 * v42) + 0.5334320651111477) * v42) + 2.250488865813539) * v42) + 2.8612106440066865) * v42) + 1.3794681629043655) * v42) + 0.2596058532893223) * v42) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v42) + 49.328555418276075) * v42) + 167.28648538571198) * v42) + 195.37226190335065) * v42) + 90.69722535867314) * v42) + 16.763212110504565) * v42) + 1.0)))))));
    v92 = Math.pow(v90, (1.0 / v84));
    if (((v90 > 0.0) && (v90 < Infinity))) {
      return (v92 + (v92 * (((v90 / (Math.pow(v92, n) * Math.pow(v92, 1.0))) - 1.0) / v84)));
    }
    return v92;
  }
  return _step_load_radius_standard_solid_of_power_law(t, F, A, n, E_inf, E_1, tau);
};

const step_load_radius_standard_solid = (t, F, A, n, E_inf, E_1, tau) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_standard_solid(t, F, A, n, E_inf, E_1, tau) : NaN);
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

const _ramp_force_power_creep = (t, v, A, n, E, alpha, t_0) => {
  let force, m;
  m = ((n + 1) / n);
  force = (_force_from_depth((v * t), A, n, 1.0) * ramp_power_creep(t, m, E, alpha, t_0));
  return ((t === 0.0) ? 0.0 : force);
};

const ramp_force_power_creep = (t, A, n, v, E, alpha, t_0) => {
  if ((!((0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < v && v < Infinity) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _ramp_force_power_creep(t, v, A, n, E, alpha, t_0) : NaN);
};

const relaxation_power_creep = (t, E, alpha, t_0) => {
  let v8;
  v8 = (3.141592653589793 * alpha);
  return (((E * Math.pow((t_0 / t), alpha)) * Math.sin(v8)) / v8);
};

const _step_force_power_creep_of_power_law = (t, d, A, n, E, alpha, t_0) => {
  return (relaxation_power_creep(t, E, alpha, t_0) * _force_from_depth_2(d, A, n, 1.0));
};

const _step_force_power_creep = (t, d, A, n, E, alpha, t_0) => {
  let v11, v18, v20, v24, v38, v79, v83, v92, v94;
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E > 1e-30) && (E < 1e+30) && (alpha > 1e-30) && (alpha < 1.0) && (t_0 > 1e-30) && (t_0 < 1e+30))) {
    v11 = (3.141592653589793 * alpha);
    v18 = ((n / 2.0) + 0.5);
    v20 = (v18 + 1.75);
    v24 = ((v18 + 0.5) * (v18 + 1.5));
    v38 = (1.0 / (v20 * v20));
    v79 = ((((v18 < 1.0) ? ((v18 * (v18 + 1.0)) / v24) : (1.0 - ((v18 + 0.75) / v24))) * Math.sqrt(v20)) * (1.0 + (v38 * (((((((((((((0.01524698625788054 * v38) + 0.5334320651111477) * v38) + 2.250488865813539) * v38) + 2.8612106440066865) * v38) + 1.3794681629043655) * v38) + 0.2596058532893223) * v38) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v38) + 49.328555418276075) * v38) + 167.28648538571198) * v38) + 195.37226190335065) * v38) + 90.69722535867314) * v38) + 16.763212110504565) * v38) + 1.0)))));
    v83 = (d / ((1.7724538509055159 * A) * v79));
    v92 = (n + 0.0);
    v94 = Math.pow(v83, (1.0 / v92));
    return ((((E * Math.pow((t_0 / t), alpha)) * Math.sin(v11)) / v11) * ((((((3.5449077018110318 * n) * A) / (n + 1.0)) * v79) * v83) * (((v83 > 0.0) && (v83 < Infinity)) ? (v94 + (v94 * (((v83 / (Math.pow(v94, n) * Math.pow(v94, 0.0))) - 1.0) / v92))) : v94)));
  }
  return _step_force_power_creep_of_power_law(t, d, A, n, E, alpha, t_0);
};

const step_force_power_creep = (t, d, A, n, E, alpha, t_0) => {
  if ((!((0.0 <= d && d < Infinity) && (0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_power_creep(t, d, A, n, E, alpha, t_0) : NaN);
};

const creep_power_creep = (t, E, alpha, t_0) => {
  return (Math.pow((t / t_0), alpha) / E);
};

const _step_load_radius_power_creep_of_power_law = (t, F, A, n, E, alpha, t_0) => {
  return _radius_from_force_2((F * creep_power_creep(t, E, alpha, t_0)), A, n, 1.0);
};

const _step_load_radius_power_creep = (t, F, A, n, E, alpha, t_0) => {
  let v14, v16, v20, v34, v76, v82, v84;
  if (((t > 1e-30) && (t < 1e+30) && (F > 1e-30) && (F < 1e+30) && (A > 1e-30) && (A < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E > 1e-30) && (E < 1e+30) && (alpha > 1e-30) && (alpha < 1.0) && (t_0 > 1e-30) && (t_0 < 1e+30))) {
    v14 = ((n / 2.0) + 0.5);
    v16 = (v14 + 1.75);
    v20 = ((v14 + 0.5) * (v14 + 1.5));
    v34 = (1.0 / (v16 * v16));
    v76 = (n + 1.0);
    v82 = ((v76 * (F * (Math.pow((t / t_0), alpha) / E))) / (((3.5449077018110318 * n) * A) * ((((v14 < 1.0) ? ((v14 * (v14 + 1.0)) / v20) : (1.0 - ((v14 + 0.75) / v20))) * Math.sqrt(v16)) * (1.0 + (v34 * (((((((((((((0.01524698625788054 * v34) + 0.5334320651111477) * v34) + 2.250488865813539) * v34) + 2.8612106440066865) * v34) + 1.3794681629043655) * v34) + 0.2596058532893223) * v34) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v34) + 49.328555418276075) * v34) + 167.28648538571198) * v34) + 195.37226190335065) * v34) + 90.69722535867314) * v34) + 16.763212110504565) * v34) + 1.0)))))));
    v84 = Math.pow(v82, (1.0 / v76));
    if (((v82 > 0.0) && (v82 < Infinity))) {
      return (v84 + (v84 * (((v82 / (Math.pow(v84, n) * Math.pow(v84, 1.0))) - 1.0) / v76)));
    }
    return v84;
  }
  return _step_load_radius_power_creep_of_power_law(t, F, A, n, E, alpha, t_0);
};

const step_load_radius_power_creep = (t, F, A, n, E, alpha, t_0) => {
  if ((!((0.0 <= F && F < Infinity) && (0.0 < A && A < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_load_radius_power_creep(t, F, A, n, E, alpha, t_0) : NaN);
};

const once = { peak_pressure: math.kept(peak_pressure), pull_off: math.kept(pull_off), pull_off_of_power_law: math.kept(pull_off_of_power_law) };
const formulas = {
  "d": (v) => depth(v.a, v.A, v.n),
  "F": (v) => force(v.a, v.A, v.n, v.E_star),
  "p": (v) => pressure(v.r, v.a, v.A, v.n, v.E_star),
  "w": (v) => displacement(v.r, v.a, v.A, v.n),
  "k": (v) => stiffness(v.a, v.A, v.n, v.E_star),
  "pm": (v) => mean_pressure(v.a, v.A, v.n, v.E_star),
  "U": (v) => energy(v.a, v.A, v.n, v.E_star),
  "Fr": (v) => load_within(v.r, v.a, v.A, v.n, v.E_star),
  "rp": (v) => (once.peak_pressure(v.a, v.A, v.n, v.E_star).radius ?? NaN),
  "pp": (v) => (once.peak_pressure(v.a, v.A, v.n, v.E_star).pressure ?? NaN),
  "ad": (v) => radius_from_depth(v.d, v.A, v.n),
  "aF": (v) => radius_from_force(v.F, v.A, v.n, v.E_star),
  "Fd": (v) => force_from_depth(v.d, v.A, v.n, v.E_star),
  "dF": (v) => depth_from_force(v.F, v.A, v.n, v.E_star),
  "adh.Dl": (v) => retraction(v.a, v.E_star, v.dgamma),
  "adh.d": (v) => depth_of_power_law(v.a, v.A, v.n, v.E_star, v.dgamma),
  "adh.F": (v) => force_of_power_law(v.a, v.A, v.n, v.E_star, v.dgamma),
  "adh.p": (v) => pressure_of_power_law(v.r, v.a, v.A, v.n, v.E_star, v.dgamma),
  "adh.w": (v) => displacement_of_power_law(v.r, v.a, v.A, v.n, v.E_star, v.dgamma),
  "adh.ad": (v) => radius_from_depth_of_power_law(v.d, v.A, v.n, v.E_star, v.dgamma),
  "adh.aF": (v) => radius_from_force_of_power_law(v.F, v.A, v.n, v.E_star, v.dgamma),
  "adh.ac": (v) => (once.pull_off('force', v.A, v.n, v.E_star, v.dgamma).radius ?? NaN),
  "adh.Fc": (v) => (once.pull_off('force', v.A, v.n, v.E_star, v.dgamma).force ?? NaN),
  "adh.dc": (v) => (once.pull_off('force', v.A, v.n, v.E_star, v.dgamma).depth ?? NaN),
  "adh.am": (v) => (once.pull_off('depth', v.A, v.n, v.E_star, v.dgamma).radius ?? NaN),
  "adh.Fm": (v) => (once.pull_off('depth', v.A, v.n, v.E_star, v.dgamma).force ?? NaN),
  "adh.dm": (v) => (once.pull_off('depth', v.A, v.n, v.E_star, v.dgamma).depth ?? NaN),
  "tan.F": (v) => tangential_force(v.a, v.c, v.A, v.n, v.E_star, v.mu),
  "tan.tau": (v) => traction(v.r, v.a, v.c, v.A, v.n, v.E_star, v.mu),
  "tan.u": (v) => tangential_displacement(v.a, v.c, v.A, v.n, v.E_star, v.G_star, v.mu),
  "tan.c": (v) => stick_radius(v.F_x, v.a, v.A, v.n, v.E_star, v.mu),
  "tan.us": (v) => full_slip_displacement(v.a, v.A, v.n, v.E_star, v.G_star, v.mu),
  "fgm.d": (v) => depth_2(v.a, v.A, v.n, v.k),
  "fgm.F": (v) => force_2(v.a, v.A, v.n, v.H, v.k),
  "fgm.p": (v) => pressure_2(v.r, v.a, v.A, v.n, v.H, v.k),
  "fgm.w": (v) => displacement_2(v.r, v.a, v.A, v.n, v.k),
  "fgm.k": (v) => stiffness_of_power_law(v.a, v.A, v.n, v.H, v.k),
  "fgm.pm": (v) => mean_pressure_of_power_law(v.a, v.A, v.n, v.H, v.k),
  "fgm.ad": (v) => radius_from_depth_2(v.d, v.A, v.n, v.k),
  "fgm.aF": (v) => radius_from_force_2(v.F, v.A, v.n, v.H, v.k),
  "fgm.Fd": (v) => force_from_depth_of_power_law(v.d, v.A, v.n, v.H, v.k),
  "fgm.dF": (v) => depth_from_force_of_power_law(v.F, v.A, v.n, v.H, v.k),
  "fgm.adh.Dl": (v) => retraction_of_power_law(v.a, v.H, v.k, v.dgamma),
  "fgm.adh.d": (v) => depth_3(v.a, v.A, v.n, v.H, v.k, v.dgamma),
  "fgm.adh.F": (v) => force_3(v.a, v.A, v.n, v.H, v.k, v.dgamma),
  "fgm.adh.p": (v) => pressure_3(v.r, v.a, v.A, v.n, v.H, v.k, v.dgamma),
  "fgm.adh.w": (v) => displacement_3(v.r, v.a, v.A, v.n, v.H, v.k, v.dgamma),
  "fgm.adh.ad": (v) => radius_from_depth_3(v.d, v.A, v.n, v.H, v.k, v.dgamma),
  "fgm.adh.aF": (v) => radius_from_force_3(v.F, v.A, v.n, v.H, v.k, v.dgamma),
  "fgm.adh.ac": (v) => (once.pull_off_of_power_law('force', v.A, v.n, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fc": (v) => (once.pull_off_of_power_law('force', v.A, v.n, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dc": (v) => (once.pull_off_of_power_law('force', v.A, v.n, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.adh.am": (v) => (once.pull_off_of_power_law('depth', v.A, v.n, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fm": (v) => (once.pull_off_of_power_law('depth', v.A, v.n, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dm": (v) => (once.pull_off_of_power_law('depth', v.A, v.n, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.tan.F": (v) => tangential_force_of_power_law(v.a, v.c, v.A, v.n, v.H, v.k, v.mu),
  "fgm.tan.tau": (v) => traction_of_power_law(v.r, v.a, v.c, v.A, v.n, v.H, v.k, v.mu),
  "fgm.tan.u": (v) => tangential_displacement_of_power_law(v.a, v.c, v.A, v.n, v.H, v.H_x, v.k, v.mu),
  "fgm.tan.c": (v) => stick_radius_of_power_law(v.F_x, v.a, v.A, v.n, v.H, v.k, v.mu),
  "fgm.tan.us": (v) => full_slip_displacement_of_power_law(v.a, v.A, v.n, v.H, v.H_x, v.k, v.mu),
  "vis.ramp_mx": (v) => ramp_force_maxwell(v.t, v.A, v.n, v.v, v.E_law, v.tau),
  "vis.step_mx": (v) => step_force_maxwell(v.t, v.d, v.A, v.n, v.E_law, v.tau),
  "vis.load_mx": (v) => step_load_radius_maxwell(v.t, v.F, v.A, v.n, v.E_law, v.tau),
  "vis.ramp_kv": (v) => ramp_force_kelvin_voigt(v.t, v.A, v.n, v.v, v.E_law, v.eta),
  "vis.step_kv": (v) => step_force_kelvin_voigt(v.t, v.d, v.A, v.n, v.E_law, v.eta),
  "vis.load_kv": (v) => step_load_radius_kelvin_voigt(v.t, v.F, v.A, v.n, v.E_law, v.eta),
  "vis.ramp_sls": (v) => ramp_force_standard_solid(v.t, v.A, v.n, v.v, v.E_inf, v.E_1, v.tau),
  "vis.step_sls": (v) => step_force_standard_solid(v.t, v.d, v.A, v.n, v.E_inf, v.E_1, v.tau),
  "vis.load_sls": (v) => step_load_radius_standard_solid(v.t, v.F, v.A, v.n, v.E_inf, v.E_1, v.tau),
  "vis.ramp_pc": (v) => ramp_force_power_creep(v.t, v.A, v.n, v.v, v.E_law, v.alpha, v.t_0),
  "vis.step_pc": (v) => step_force_power_creep(v.t, v.d, v.A, v.n, v.E_law, v.alpha, v.t_0),
  "vis.load_pc": (v) => step_load_radius_power_creep(v.t, v.F, v.A, v.n, v.E_law, v.alpha, v.t_0),
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
   "value": 10000.0
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
    "A",
    "n"
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
    "n",
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
    "n",
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
    "A",
    "n"
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "A",
    "n"
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
