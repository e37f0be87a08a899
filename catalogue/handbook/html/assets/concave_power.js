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

const gamma_ratio = (x) => {
  let v2, v21, v7;
  v2 = (x + 1.75);
  v7 = ((x + 0.5) * (x + 1.5));
  v21 = (1.0 / (v2 * v2));
  return ((((x < 1.0) ? ((x * (x + 1.0)) / v7) : (1.0 - ((x + 0.75) / v7))) * math.sqrt(v2)) * (1.0 + (v21 * (((((((((((((0.01524698625788054 * v21) + 0.5334320651111477) * v21) + 2.250488865813539) * v21) + 2.8612106440066865) * v21) + 1.3794681629043655) * v21) + 0.2596058532893223) * v21) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v21) + 49.328555418276075) * v21) + 167.28648538571198) * v21) + 195.37226190335065) * v21) + 90.69722535867314) * v21) + 16.763212110504565) * v21) + 1.0)))));
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

const _log_ratio = (n, k) => {
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
  return math.where((n > 2.0), (-Math.expm1(((-2.0) * _log_ratio(n, k)))), 1.0);
};

const _minimum_depth = (h, n) => {
  let drop, kappa, zeta;
  zeta = outside_zero_pressure(n);
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  drop = ((n * zeta) - 1);
  return (((Math.sqrt(Math.PI) * h) * kappa) / drop);
};

const _energy_of_concave_power = (d, a, h, n, E_star) => {
  let complete, kappa, plus, result;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  plus = ((Math.pow(d, 2) + (((((2 * Math.sqrt(Math.PI)) * h) / (n + 1)) * d) * kappa)) + (((Math.PI * Math.pow(h, 2)) / ((2 * n) + 1)) * Math.pow(kappa, 2)));
  complete = ((_minimum_depth(h, n) * (1.0 - 1e-15)) <= d);
  result = ((E_star * a) * plus);
  return math.where(complete, result, NaN);
};

const _energy = (d, a, h, n, E_star) => {
  let node, v10, v105, v107, v109, v111, v118, v120, v121, v122, v124, v125, v127, v129, v132, v135, v136, v14, v140, v142, v143, v158, v159, v160, v165, v174, v175, v177, v182, v183, v185, v186, v188, v190, v192, v195, v196, v200, v202, v216, v217, v218, v231, v232, v234, v239, v240, v242, v243, v245, v247, v249, v252, v253, v257, v259, v273, v274, v275, v28, v288, v289, v291, v296, v297, v299, v300, v302, v304, v306, v309, v310, v314, v316, v330, v331, v332, v345, v346, v348, v353, v354, v356, v357, v359, v361, v363, v366, v367, v371, v373, v387, v388, v389, v406, v69, v8, v87, v89, v90, v99, weight;
  if (((d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v8 = ((n / 2.0) + 0.5);
    v10 = (v8 + 1.75);
    v14 = ((v8 + 0.5) * (v8 + 1.5));
    v28 = (1.0 / (v10 * v10));
    v69 = ((((v8 < 1.0) ? ((v8 * (v8 + 1.0)) / v14) : (1.0 - ((v8 + 0.75) / v14))) * Math.sqrt(v10)) * (1.0 + (v28 * (((((((((((((0.01524698625788054 * v28) + 0.5334320651111477) * v28) + 2.250488865813539) * v28) + 2.8612106440066865) * v28) + 1.3794681629043655) * v28) + 0.2596058532893223) * v28) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v28) + 49.328555418276075) * v28) + 167.28648538571198) * v28) + 195.37226190335065) * v28) + 90.69722535867314) * v28) + 16.763212110504565) * v28) + 1.0)))));
    v87 = (n > 2.0);
    if (v87) {
      v89 = (math.truth(v87) ? n : 3.0);
      v90 = (v89 - 2.0);
      v99 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v90) / (v90 + 0.72))) / v90));
      if ((v90 < 2.0)) {
        v105 = (Math.log(((v90 * (v90 + 2.0)) / 2.0)) / v90);
        v107 = (((v99 > v105) || (v99 !== v99)) ? v99 : v105);
      } else {
        v107 = v99;
      }
      v109 = ((-2.0) * v107);
      v111 = (-Math.expm1(v109));
      v118 = ((v89 - 1.0) + 0.0);
      v120 = (v118 - (v89 * Math.exp(((-2.0) * (((v107 < 300.0) || (v107 !== v107)) ? v107 : 300.0)))));
      v121 = (((v120 > 1.0) || (v120 !== v120)) ? v120 : 1.0);
      v122 = (v90 + 1.0);
      v124 = (1.0 / (v122 * v107));
      v140 = (v90 * v107);
      v143 = (0.5 * v90);
      v159 = [];
      for ([node, weight] of RULE_0((1.0 / v124))) {
        v125 = (node * 1.0);
        v127 = ((v125 * v125) * v125);
        v129 = ((v127 * v127) * v125);
        v132 = (v129 * v125);
        v135 = (-Math.expm1((v109 * v132)));
        v136 = (1.0 - v132);
        v142 = Math.expm1((v140 * v132));
        v158 = ((8.0 * v129) * (((Math.exp((v107 * v136)) * Math.pow((v135 / v111), (-0.5))) * (v142 - (((v143 * (v142 + 1.0)) * v135) * ((-Math.expm1((v109 * v136))) / v111)))) / v135));
        v159.push((weight * v158));
      }
      v159 = (math.fsum(v159) * 1.0);
      v160 = (v107 * v159);
      v165 = (2.0 * v118);
      v174 = (v107 - ((Math.log(v160) * v160) / ((Math.exp(v140) / (v111 * v121)) + ((v160 - 1.0) * ((v165 / v121) - (1.0 / v111))))));
      v175 = ((-2.0) * v174);
      v177 = (-Math.expm1(v175));
      v182 = (v118 - (v89 * Math.exp(((-2.0) * (((v174 < 300.0) || (v174 !== v174)) ? v174 : 300.0)))));
      v183 = (((v182 > 1.0) || (v182 !== v182)) ? v182 : 1.0);
      v185 = (1.0 / (v122 * v174));
      v200 = (v90 * v174);
      v217 = [];
      for ([node, weight] of RULE_0((1.0 / v185))) {
        v186 = (node * 1.0);
        v188 = ((v186 * v186) * v186);
        v190 = ((v188 * v188) * v186);
        v192 = (v190 * v186);
        v195 = (-Math.expm1((v175 * v192)));
        v196 = (1.0 - v192);
        v202 = Math.expm1((v200 * v192));
        v216 = ((8.0 * v190) * (((Math.exp((v174 * v196)) * Math.pow((v195 / v177), (-0.5))) * (v202 - (((v143 * (v202 + 1.0)) * v195) * ((-Math.expm1((v175 * v196))) / v177)))) / v195));
        v217.push((weight * v216));
      }
      v217 = (math.fsum(v217) * 1.0);
      v218 = (v174 * v217);
      v231 = (v174 - ((Math.log(v218) * v218) / ((Math.exp(v200) / (v177 * v183)) + ((v218 - 1.0) * ((v165 / v183) - (1.0 / v177))))));
      v232 = ((-2.0) * v231);
      v234 = (-Math.expm1(v232));
      v239 = (v118 - (v89 * Math.exp(((-2.0) * (((v231 < 300.0) || (v231 !== v231)) ? v231 : 300.0)))));
      v240 = (((v239 > 1.0) || (v239 !== v239)) ? v239 : 1.0);
      v242 = (1.0 / (v122 * v231));
      v257 = (v90 * v231);
      v274 = [];
      for ([node, weight] of RULE_0((1.0 / v242))) {
        v243 = (node * 1.0);
        v245 = ((v243 * v243) * v243);
        v247 = ((v245 * v245) * v243);
        v249 = (v247 * v243);
        v252 = (-Math.expm1((v232 * v249)));
        v253 = (1.0 - v249);
        v259 = Math.expm1((v257 * v249));
        v273 = ((8.0 * v247) * (((Math.exp((v231 * v253)) * Math.pow((v252 / v234), (-0.5))) * (v259 - (((v143 * (v259 + 1.0)) * v252) * ((-Math.expm1((v232 * v253))) / v234)))) / v252));
        v274.push((weight * v273));
      }
      v274 = (math.fsum(v274) * 1.0);
      v275 = (v231 * v274);
      v288 = (v231 - ((Math.log(v275) * v275) / ((Math.exp(v257) / (v234 * v240)) + ((v275 - 1.0) * ((v165 / v240) - (1.0 / v234))))));
      v289 = ((-2.0) * v288);
      v291 = (-Math.expm1(v289));
      v296 = (v118 - (v89 * Math.exp(((-2.0) * (((v288 < 300.0) || (v288 !== v288)) ? v288 : 300.0)))));
      v297 = (((v296 > 1.0) || (v296 !== v296)) ? v296 : 1.0);
      v299 = (1.0 / (v122 * v288));
      v314 = (v90 * v288);
      v331 = [];
      for ([node, weight] of RULE_0((1.0 / v299))) {
        v300 = (node * 1.0);
        v302 = ((v300 * v300) * v300);
        v304 = ((v302 * v302) * v300);
        v306 = (v304 * v300);
        v309 = (-Math.expm1((v289 * v306)));
        v310 = (1.0 - v306);
        v316 = Math.expm1((v314 * v306));
        v330 = ((8.0 * v304) * (((Math.exp((v288 * v310)) * Math.pow((v309 / v291), (-0.5))) * (v316 - (((v143 * (v316 + 1.0)) * v309) * ((-Math.expm1((v289 * v310))) / v291)))) / v309));
        v331.push((weight * v330));
      }
      v331 = (math.fsum(v331) * 1.0);
      v332 = (v288 * v331);
      v345 = (v288 - ((Math.log(v332) * v332) / ((Math.exp(v314) / (v291 * v297)) + ((v332 - 1.0) * ((v165 / v297) - (1.0 / v291))))));
      v346 = ((-2.0) * v345);
      v348 = (-Math.expm1(v346));
      v353 = (v118 - (v89 * Math.exp(((-2.0) * (((v345 < 300.0) || (v345 !== v345)) ? v345 : 300.0)))));
      v354 = (((v353 > 1.0) || (v353 !== v353)) ? v353 : 1.0);
      v356 = (1.0 / (v122 * v345));
      v371 = (v90 * v345);
      v388 = [];
      for ([node, weight] of RULE_0((1.0 / v356))) {
        v357 = (node * 1.0);
        v359 = ((v357 * v357) * v357);
        v361 = ((v359 * v359) * v357);
        v363 = (v361 * v357);
        v366 = (-Math.expm1((v346 * v363)));
        v367 = (1.0 - v363);
        v373 = Math.expm1((v371 * v363));
        v387 = ((8.0 * v361) * (((Math.exp((v345 * v367)) * Math.pow((v366 / v348), (-0.5))) * (v373 - (((v143 * (v373 + 1.0)) * v366) * ((-Math.expm1((v346 * v367))) / v348)))) / v366));
        v388.push((weight * v387));
      }
      v388 = (math.fsum(v388) * 1.0);
      v389 = (v345 * v388);
      v406 = (-Math.expm1(((-2.0) * (v345 - ((Math.log(v389) * v389) / ((Math.exp(v371) / (v348 * v354)) + ((v389 - 1.0) * ((v165 / v354) - (1.0 / v348)))))))));
    } else {
      v406 = 1.0;
    }
    if ((((((1.7724538509055159 * h) * v69) / ((n * v406) - 1.0)) * 0.999999999999999) <= d)) {
      return ((E_star * a) * (((d * d) + ((((3.5449077018110318 * h) / (n + 1.0)) * d) * v69)) + (((3.141592653589793 * (h * h)) / ((2.0 * n) + 1.0)) * (v69 * v69))));
    }
    return NaN;
  }
  return _energy_of_concave_power(d, a, h, n, E_star);
};

const energy = (d, a, h, n, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (n > 1)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _energy(d, a, h, n, E_star) : NaN);
};

const RULE_2 = math.rule([[16.0, 64], [Infinity, 128]]);

const _log_ratio_of_powers = (x, y) => {
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
  return ((r > 0.0) ? (largest * _fallen_pressure(_log_ratio_of_powers(a, r), n)) : centre);
};

const _force = (d, a, h, n, E_star) => {
  let complete, kappa, result;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  complete = ((_minimum_depth(h, n) * (1.0 - 1e-15)) <= d);
  result = (((2 * E_star) * a) * (d + (((Math.sqrt(Math.PI) * h) / (n + 1)) * kappa)));
  return math.where(complete, result, NaN);
};

const _load_within_of_concave_power = (r, d, a, h, n, E_star) => {
  let complete, face, kappa, punch, result, root, share, within;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  root = Math.sqrt(((a - r) * (a + r)));
  share = power_pressure(r, a, n);
  punch = ((((n * d) * Math.pow(r, 2)) / (root + a)) + ((d * Math.pow(r, 2)) / (root + a)));
  face = (((((Math.sqrt(Math.PI) * h) * Math.pow(r, 2)) * kappa) / (root + a)) - ((((((Math.sqrt(Math.PI) * n) * h) * share) * Math.pow(r, 2)) * kappa) / a));
  within = (((2 * E_star) / (n + 1)) * (punch + face));
  complete = ((_minimum_depth(h, n) * (1.0 - 1e-15)) <= d);
  result = math.where((r < a), within, _force(d, a, h, n, E_star));
  return math.where(complete, result, NaN);
};

const _load_within = (r, d, a, h, n, E_star) => {
  let node, v100, v101, v106, v108, v109, v11, v114, v117, v119, v128, v129, v130, v132, v134, v136, v142, v15, v153, v154, v158, v160, v161, v170, v176, v178, v179, v181, v187, v189, v190, v191, v193, v194, v196, v198, v201, v204, v205, v209, v211, v212, v227, v228, v229, v232, v234, v237, v243, v244, v246, v251, v252, v254, v255, v257, v259, v261, v264, v265, v269, v271, v285, v286, v287, v29, v300, v301, v303, v308, v309, v311, v312, v314, v316, v318, v321, v322, v326, v328, v342, v343, v344, v357, v358, v360, v365, v366, v368, v369, v371, v373, v375, v378, v379, v383, v385, v399, v400, v401, v414, v415, v417, v422, v423, v425, v426, v428, v430, v432, v435, v436, v440, v442, v456, v457, v458, v475, v478, v484, v486, v488, v490, v493, v494, v499, v513, v514, v515, v522, v523, v525, v530, v531, v533, v534, v536, v538, v540, v543, v544, v548, v550, v564, v565, v566, v579, v580, v582, v587, v588, v590, v591, v593, v595, v597, v600, v601, v605, v607, v621, v622, v623, v636, v637, v639, v644, v645, v647, v648, v650, v652, v654, v657, v658, v662, v664, v678, v679, v680, v693, v694, v696, v70, v701, v702, v704, v705, v707, v709, v71, v711, v714, v715, v719, v721, v735, v736, v737, v75, v754, v77, v88, v9, v94, v99, weight;
  if (((r > 1e-30) && (r < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v9 = ((n / 2.0) + 0.5);
    v11 = (v9 + 1.75);
    v15 = ((v9 + 0.5) * (v9 + 1.5));
    v29 = (1.0 / (v11 * v11));
    v70 = ((((v9 < 1.0) ? ((v9 * (v9 + 1.0)) / v15) : (1.0 - ((v9 + 0.75) / v15))) * Math.sqrt(v11)) * (1.0 + (v29 * (((((((((((((0.01524698625788054 * v29) + 0.5334320651111477) * v29) + 2.250488865813539) * v29) + 2.8612106440066865) * v29) + 1.3794681629043655) * v29) + 0.2596058532893223) * v29) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v29) + 49.328555418276075) * v29) + 167.28648538571198) * v29) + 195.37226190335065) * v29) + 90.69722535867314) * v29) + 16.763212110504565) * v29) + 1.0)))));
    v142 = (1.7724538509055159 * h);
    v158 = (n > 2.0);
    v160 = (math.truth(v158) ? n : 3.0);
    v161 = (v160 - 2.0);
    v170 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v161) / (v161 + 0.72))) / v161));
    if ((v161 < 2.0)) {
      v176 = (Math.log(((v161 * (v161 + 2.0)) / 2.0)) / v161);
      v178 = (((v170 > v176) || (v170 !== v170)) ? v170 : v176);
    } else {
      v178 = v170;
    }
    v179 = ((-2.0) * v178);
    v181 = (-Math.expm1(v179));
    v187 = ((v160 - 1.0) + 0.0);
    v189 = (v187 - (v160 * Math.exp(((-2.0) * (((v178 < 300.0) || (v178 !== v178)) ? v178 : 300.0)))));
    v190 = (((v189 > 1.0) || (v189 !== v189)) ? v189 : 1.0);
    v191 = (v161 + 1.0);
    v193 = (1.0 / (v191 * v178));
    v209 = (v161 * v178);
    v212 = (0.5 * v161);
    v232 = (Math.exp(v209) / (v181 * v190));
    v234 = (2.0 * v187);
    v237 = ((v234 / v190) - (1.0 / v181));
    if (v158) {
      v228 = [];
      for ([node, weight] of RULE_0((1.0 / v193))) {
        v194 = (node * 1.0);
        v196 = ((v194 * v194) * v194);
        v198 = ((v196 * v196) * v194);
        v201 = (v198 * v194);
        v204 = (-Math.expm1((v179 * v201)));
        v205 = (1.0 - v201);
        v211 = Math.expm1((v209 * v201));
        v227 = ((8.0 * v198) * (((Math.exp((v178 * v205)) * Math.pow((v204 / v181), (-0.5))) * (v211 - (((v212 * (v211 + 1.0)) * v204) * ((-Math.expm1((v179 * v205))) / v181)))) / v204));
        v228.push((weight * v227));
      }
      v228 = (math.fsum(v228) * 1.0);
      v229 = (v178 * v228);
      v243 = (v178 - ((Math.log(v229) * v229) / (v232 + ((v229 - 1.0) * v237))));
      v244 = ((-2.0) * v243);
      v246 = (-Math.expm1(v244));
      v251 = (v187 - (v160 * Math.exp(((-2.0) * (((v243 < 300.0) || (v243 !== v243)) ? v243 : 300.0)))));
      v252 = (((v251 > 1.0) || (v251 !== v251)) ? v251 : 1.0);
      v254 = (1.0 / (v191 * v243));
      v269 = (v161 * v243);
      v286 = [];
      for ([node, weight] of RULE_0((1.0 / v254))) {
        v255 = (node * 1.0);
        v257 = ((v255 * v255) * v255);
        v259 = ((v257 * v257) * v255);
        v261 = (v259 * v255);
        v264 = (-Math.expm1((v244 * v261)));
        v265 = (1.0 - v261);
        v271 = Math.expm1((v269 * v261));
        v285 = ((8.0 * v259) * (((Math.exp((v243 * v265)) * Math.pow((v264 / v246), (-0.5))) * (v271 - (((v212 * (v271 + 1.0)) * v264) * ((-Math.expm1((v244 * v265))) / v246)))) / v264));
        v286.push((weight * v285));
      }
      v286 = (math.fsum(v286) * 1.0);
      v287 = (v243 * v286);
      v300 = (v243 - ((Math.log(v287) * v287) / ((Math.exp(v269) / (v246 * v252)) + ((v287 - 1.0) * ((v234 / v252) - (1.0 / v246))))));
      v301 = ((-2.0) * v300);
      v303 = (-Math.expm1(v301));
      v308 = (v187 - (v160 * Math.exp(((-2.0) * (((v300 < 300.0) || (v300 !== v300)) ? v300 : 300.0)))));
      v309 = (((v308 > 1.0) || (v308 !== v308)) ? v308 : 1.0);
      v311 = (1.0 / (v191 * v300));
      v326 = (v161 * v300);
      v343 = [];
      for ([node, weight] of RULE_0((1.0 / v311))) {
        v312 = (node * 1.0);
        v314 = ((v312 * v312) * v312);
        v316 = ((v314 * v314) * v312);
        v318 = (v316 * v312);
        v321 = (-Math.expm1((v301 * v318)));
        v322 = (1.0 - v318);
        v328 = Math.expm1((v326 * v318));
        v342 = ((8.0 * v316) * (((Math.exp((v300 * v322)) * Math.pow((v321 / v303), (-0.5))) * (v328 - (((v212 * (v328 + 1.0)) * v321) * ((-Math.expm1((v301 * v322))) / v303)))) / v321));
        v343.push((weight * v342));
      }
      v343 = (math.fsum(v343) * 1.0);
      v344 = (v300 * v343);
      v357 = (v300 - ((Math.log(v344) * v344) / ((Math.exp(v326) / (v303 * v309)) + ((v344 - 1.0) * ((v234 / v309) - (1.0 / v303))))));
      v358 = ((-2.0) * v357);
      v360 = (-Math.expm1(v358));
      v365 = (v187 - (v160 * Math.exp(((-2.0) * (((v357 < 300.0) || (v357 !== v357)) ? v357 : 300.0)))));
      v366 = (((v365 > 1.0) || (v365 !== v365)) ? v365 : 1.0);
      v368 = (1.0 / (v191 * v357));
      v383 = (v161 * v357);
      v400 = [];
      for ([node, weight] of RULE_0((1.0 / v368))) {
        v369 = (node * 1.0);
        v371 = ((v369 * v369) * v369);
        v373 = ((v371 * v371) * v369);
        v375 = (v373 * v369);
        v378 = (-Math.expm1((v358 * v375)));
        v379 = (1.0 - v375);
        v385 = Math.expm1((v383 * v375));
        v399 = ((8.0 * v373) * (((Math.exp((v357 * v379)) * Math.pow((v378 / v360), (-0.5))) * (v385 - (((v212 * (v385 + 1.0)) * v378) * ((-Math.expm1((v358 * v379))) / v360)))) / v378));
        v400.push((weight * v399));
      }
      v400 = (math.fsum(v400) * 1.0);
      v401 = (v357 * v400);
      v414 = (v357 - ((Math.log(v401) * v401) / ((Math.exp(v383) / (v360 * v366)) + ((v401 - 1.0) * ((v234 / v366) - (1.0 / v360))))));
      v415 = ((-2.0) * v414);
      v417 = (-Math.expm1(v415));
      v422 = (v187 - (v160 * Math.exp(((-2.0) * (((v414 < 300.0) || (v414 !== v414)) ? v414 : 300.0)))));
      v423 = (((v422 > 1.0) || (v422 !== v422)) ? v422 : 1.0);
      v425 = (1.0 / (v191 * v414));
      v440 = (v161 * v414);
      v457 = [];
      for ([node, weight] of RULE_0((1.0 / v425))) {
        v426 = (node * 1.0);
        v428 = ((v426 * v426) * v426);
        v430 = ((v428 * v428) * v426);
        v432 = (v430 * v426);
        v435 = (-Math.expm1((v415 * v432)));
        v436 = (1.0 - v432);
        v442 = Math.expm1((v440 * v432));
        v456 = ((8.0 * v430) * (((Math.exp((v414 * v436)) * Math.pow((v435 / v417), (-0.5))) * (v442 - (((v212 * (v442 + 1.0)) * v435) * ((-Math.expm1((v415 * v436))) / v417)))) / v435));
        v457.push((weight * v456));
      }
      v457 = (math.fsum(v457) * 1.0);
      v458 = (v414 * v457);
      v475 = (-Math.expm1(((-2.0) * (v414 - ((Math.log(v458) * v458) / ((Math.exp(v440) / (v417 * v423)) + ((v458 - 1.0) * ((v234 / v423) - (1.0 / v417)))))))));
    } else {
      v475 = 1.0;
    }
    v478 = (v142 * v70);
    if ((((v478 / ((n * v475) - 1.0)) * 0.999999999999999) <= d)) {
      v153 = (2.0 * E_star);
      v154 = (n + 1.0);
      if ((r < a)) {
        v71 = (a - r);
        v75 = (n > 1.0);
        v77 = Math.abs((n - 1.0));
        if ((r > 0.0)) {
          v88 = (v71 / r);
          v94 = (Number.isFinite(v88) ? Math.log1p(v88) : (Math.log(a) - Math.log(r)));
          if ((v94 > 0.0)) {
            v99 = (v94 - (42.0 / (((v77 > 0.001) || (v77 !== v77)) ? v77 : 0.001)));
            v100 = (((v99 > 0.0) || (v99 !== v99)) ? v99 : 0.0);
            v101 = Math.sqrt(v94);
            v106 = (math.truth(v75) ? (v101 - Math.sqrt(v100)) : Math.sqrt((v94 - v100)));
            v109 = (2.0 * v101);
            v114 = (-v77);
            v129 = [];
            for ([node, weight] of RULE_2((v106 / 1.0))) {
              v108 = (node * v106);
              if (v75) {
                v117 = (v101 - v108);
                v119 = (((v117 > 0.0) || (v117 !== v117)) ? v117 : 0.0);
              } else {
                v119 = v108;
              }
              v128 = (Math.exp((v114 * (math.truth(v75) ? (v108 * (v109 - v108)) : (v108 * v108)))) * ((2.0 * v119) / Math.sqrt((-Math.expm1((((-2.0) * v119) * v119))))));
              v129.push((weight * v128));
            }
            v129 = (math.fsum(v129) * v106);
            v130 = v129;
          } else {
            v130 = 0.0;
          }
          v132 = ((math.truth(v75) ? 1.0 : (Math.pow((r / a), n) * (a / r))) * v130);
        } else {
          v132 = (math.truth(v75) ? (1.0 / v77) : Infinity);
        }
        v134 = (r * r);
        v136 = (Math.sqrt((v71 * (a + r))) + a);
        return ((v153 / v154) * (((((n * d) * v134) / v136) + ((d * v134) / v136)) + ((((v142 * v134) * v70) / v136) - ((((((1.7724538509055159 * n) * h) * v132) * v134) * v70) / a))));
      }
      if (v158) {
        v514 = [];
        for ([node, weight] of RULE_0((1.0 / v193))) {
          v484 = (node * 1.0);
          v486 = ((v484 * v484) * v484);
          v488 = ((v486 * v486) * v484);
          v490 = (v488 * v484);
          v493 = (-Math.expm1((v179 * v490)));
          v494 = (1.0 - v490);
          v499 = Math.expm1((v209 * v490));
          v513 = ((8.0 * v488) * (((Math.exp((v178 * v494)) * Math.pow((v493 / v181), (-0.5))) * (v499 - (((v212 * (v499 + 1.0)) * v493) * ((-Math.expm1((v179 * v494))) / v181)))) / v493));
          v514.push((weight * v513));
        }
        v514 = (math.fsum(v514) * 1.0);
        v515 = (v178 * v514);
        v522 = (v178 - ((Math.log(v515) * v515) / (v232 + ((v515 - 1.0) * v237))));
        v523 = ((-2.0) * v522);
        v525 = (-Math.expm1(v523));
        v530 = (v187 - (v160 * Math.exp(((-2.0) * (((v522 < 300.0) || (v522 !== v522)) ? v522 : 300.0)))));
        v531 = (((v530 > 1.0) || (v530 !== v530)) ? v530 : 1.0);
        v533 = (1.0 / (v191 * v522));
        v548 = (v161 * v522);
        v565 = [];
        for ([node, weight] of RULE_0((1.0 / v533))) {
          v534 = (node * 1.0);
          v536 = ((v534 * v534) * v534);
          v538 = ((v536 * v536) * v534);
          v540 = (v538 * v534);
          v543 = (-Math.expm1((v523 * v540)));
          v544 = (1.0 - v540);
          v550 = Math.expm1((v548 * v540));
          v564 = ((8.0 * v538) * (((Math.exp((v522 * v544)) * Math.pow((v543 / v525), (-0.5))) * (v550 - (((v212 * (v550 + 1.0)) * v543) * ((-Math.expm1((v523 * v544))) / v525)))) / v543));
          v565.push((weight * v564));
        }
        v565 = (math.fsum(v565) * 1.0);
        v566 = (v522 * v565);
        v579 = (v522 - ((Math.log(v566) * v566) / ((Math.exp(v548) / (v525 * v531)) + ((v566 - 1.0) * ((v234 / v531) - (1.0 / v525))))));
        v580 = ((-2.0) * v579);
        v582 = (-Math.expm1(v580));
        v587 = (v187 - (v160 * Math.exp(((-2.0) * (((v579 < 300.0) || (v579 !== v579)) ? v579 : 300.0)))));
        v588 = (((v587 > 1.0) || (v587 !== v587)) ? v587 : 1.0);
        v590 = (1.0 / (v191 * v579));
        v605 = (v161 * v579);
        v622 = [];
        for ([node, weight] of RULE_0((1.0 / v590))) {
          v591 = (node * 1.0);
          v593 = ((v591 * v591) * v591);
          v595 = ((v593 * v593) * v591);
          v597 = (v595 * v591);
          v600 = (-Math.expm1((v580 * v597)));
          v601 = (1.0 - v597);
          v607 = Math.expm1((v605 * v597));
          v621 = ((8.0 * v595) * (((Math.exp((v579 * v601)) * Math.pow((v600 / v582), (-0.5))) * (v607 - (((v212 * (v607 + 1.0)) * v600) * ((-Math.expm1((v580 * v601))) / v582)))) / v600));
          v622.push((weight * v621));
        }
        v622 = (math.fsum(v622) * 1.0);
        v623 = (v579 * v622);
        v636 = (v579 - ((Math.log(v623) * v623) / ((Math.exp(v605) / (v582 * v588)) + ((v623 - 1.0) * ((v234 / v588) - (1.0 / v582))))));
        v637 = ((-2.0) * v636);
        v639 = (-Math.expm1(v637));
        v644 = (v187 - (v160 * Math.exp(((-2.0) * (((v636 < 300.0) || (v636 !== v636)) ? v636 : 300.0)))));
        v645 = (((v644 > 1.0) || (v644 !== v644)) ? v644 : 1.0);
        v647 = (1.0 / (v191 * v636));
        v662 = (v161 * v636);
        v679 = [];
        for ([node, weight] of RULE_0((1.0 / v647))) {
          v648 = (node * 1.0);
          v650 = ((v648 * v648) * v648);
          v652 = ((v650 * v650) * v648);
          v654 = (v652 * v648);
          v657 = (-Math.expm1((v637 * v654)));
          v658 = (1.0 - v654);
          v664 = Math.expm1((v662 * v654));
          v678 = ((8.0 * v652) * (((Math.exp((v636 * v658)) * Math.pow((v657 / v639), (-0.5))) * (v664 - (((v212 * (v664 + 1.0)) * v657) * ((-Math.expm1((v637 * v658))) / v639)))) / v657));
          v679.push((weight * v678));
        }
        v679 = (math.fsum(v679) * 1.0);
        v680 = (v636 * v679);
        v693 = (v636 - ((Math.log(v680) * v680) / ((Math.exp(v662) / (v639 * v645)) + ((v680 - 1.0) * ((v234 / v645) - (1.0 / v639))))));
        v694 = ((-2.0) * v693);
        v696 = (-Math.expm1(v694));
        v701 = (v187 - (v160 * Math.exp(((-2.0) * (((v693 < 300.0) || (v693 !== v693)) ? v693 : 300.0)))));
        v702 = (((v701 > 1.0) || (v701 !== v701)) ? v701 : 1.0);
        v704 = (1.0 / (v191 * v693));
        v719 = (v161 * v693);
        v736 = [];
        for ([node, weight] of RULE_0((1.0 / v704))) {
          v705 = (node * 1.0);
          v707 = ((v705 * v705) * v705);
          v709 = ((v707 * v707) * v705);
          v711 = (v709 * v705);
          v714 = (-Math.expm1((v694 * v711)));
          v715 = (1.0 - v711);
          v721 = Math.expm1((v719 * v711));
          v735 = ((8.0 * v709) * (((Math.exp((v693 * v715)) * Math.pow((v714 / v696), (-0.5))) * (v721 - (((v212 * (v721 + 1.0)) * v714) * ((-Math.expm1((v694 * v715))) / v696)))) / v714));
          v736.push((weight * v735));
        }
        v736 = (math.fsum(v736) * 1.0);
        v737 = (v693 * v736);
        v754 = (-Math.expm1(((-2.0) * (v693 - ((Math.log(v737) * v737) / ((Math.exp(v719) / (v696 * v702)) + ((v737 - 1.0) * ((v234 / v702) - (1.0 / v696)))))))));
      } else {
        v754 = 1.0;
      }
      if ((((v478 / ((n * v754) - 1.0)) * 0.999999999999999) <= d)) {
        return ((v153 * a) * (d + ((v142 / v154) * v70)));
      }
      return NaN;
    }
    return NaN;
  }
  return _load_within_of_concave_power(r, d, a, h, n, E_star);
};

const load_within = (r, d, a, h, n, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (n > 1)))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _load_within(r, d, a, h, n, E_star) : 0.0) : NaN);
};

const _force_of_concave_power = (d, a, h, n, E_star) => {
  let node, v10, v101, v103, v104, v105, v107, v108, v110, v112, v115, v118, v119, v123, v125, v126, v14, v141, v142, v143, v148, v157, v158, v160, v165, v166, v168, v169, v171, v173, v175, v178, v179, v183, v185, v199, v200, v201, v214, v215, v217, v222, v223, v225, v226, v228, v230, v232, v235, v236, v240, v242, v256, v257, v258, v271, v272, v274, v279, v28, v280, v282, v283, v285, v287, v289, v292, v293, v297, v299, v313, v314, v315, v328, v329, v331, v336, v337, v339, v340, v342, v344, v346, v349, v350, v354, v356, v370, v371, v372, v389, v393, v69, v70, v72, v73, v8, v82, v88, v90, v92, v94, weight;
  if (((d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v8 = ((n / 2.0) + 0.5);
    v10 = (v8 + 1.75);
    v14 = ((v8 + 0.5) * (v8 + 1.5));
    v28 = (1.0 / (v10 * v10));
    v69 = ((((v8 < 1.0) ? ((v8 * (v8 + 1.0)) / v14) : (1.0 - ((v8 + 0.75) / v14))) * Math.sqrt(v10)) * (1.0 + (v28 * (((((((((((((0.01524698625788054 * v28) + 0.5334320651111477) * v28) + 2.250488865813539) * v28) + 2.8612106440066865) * v28) + 1.3794681629043655) * v28) + 0.2596058532893223) * v28) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v28) + 49.328555418276075) * v28) + 167.28648538571198) * v28) + 195.37226190335065) * v28) + 90.69722535867314) * v28) + 16.763212110504565) * v28) + 1.0)))));
    v70 = (n > 2.0);
    if (v70) {
      v72 = (math.truth(v70) ? n : 3.0);
      v73 = (v72 - 2.0);
      v82 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v73) / (v73 + 0.72))) / v73));
      if ((v73 < 2.0)) {
        v88 = (Math.log(((v73 * (v73 + 2.0)) / 2.0)) / v73);
        v90 = (((v82 > v88) || (v82 !== v82)) ? v82 : v88);
      } else {
        v90 = v82;
      }
      v92 = ((-2.0) * v90);
      v94 = (-Math.expm1(v92));
      v101 = ((v72 - 1.0) + 0.0);
      v103 = (v101 - (v72 * Math.exp(((-2.0) * (((v90 < 300.0) || (v90 !== v90)) ? v90 : 300.0)))));
      v104 = (((v103 > 1.0) || (v103 !== v103)) ? v103 : 1.0);
      v105 = (v73 + 1.0);
      v107 = (1.0 / (v105 * v90));
      v123 = (v73 * v90);
      v126 = (0.5 * v73);
      v142 = [];
      for ([node, weight] of RULE_0((1.0 / v107))) {
        v108 = (node * 1.0);
        v110 = ((v108 * v108) * v108);
        v112 = ((v110 * v110) * v108);
        v115 = (v112 * v108);
        v118 = (-Math.expm1((v92 * v115)));
        v119 = (1.0 - v115);
        v125 = Math.expm1((v123 * v115));
        v141 = ((8.0 * v112) * (((Math.exp((v90 * v119)) * Math.pow((v118 / v94), (-0.5))) * (v125 - (((v126 * (v125 + 1.0)) * v118) * ((-Math.expm1((v92 * v119))) / v94)))) / v118));
        v142.push((weight * v141));
      }
      v142 = (math.fsum(v142) * 1.0);
      v143 = (v90 * v142);
      v148 = (2.0 * v101);
      v157 = (v90 - ((Math.log(v143) * v143) / ((Math.exp(v123) / (v94 * v104)) + ((v143 - 1.0) * ((v148 / v104) - (1.0 / v94))))));
      v158 = ((-2.0) * v157);
      v160 = (-Math.expm1(v158));
      v165 = (v101 - (v72 * Math.exp(((-2.0) * (((v157 < 300.0) || (v157 !== v157)) ? v157 : 300.0)))));
      v166 = (((v165 > 1.0) || (v165 !== v165)) ? v165 : 1.0);
      v168 = (1.0 / (v105 * v157));
      v183 = (v73 * v157);
      v200 = [];
      for ([node, weight] of RULE_0((1.0 / v168))) {
        v169 = (node * 1.0);
        v171 = ((v169 * v169) * v169);
        v173 = ((v171 * v171) * v169);
        v175 = (v173 * v169);
        v178 = (-Math.expm1((v158 * v175)));
        v179 = (1.0 - v175);
        v185 = Math.expm1((v183 * v175));
        v199 = ((8.0 * v173) * (((Math.exp((v157 * v179)) * Math.pow((v178 / v160), (-0.5))) * (v185 - (((v126 * (v185 + 1.0)) * v178) * ((-Math.expm1((v158 * v179))) / v160)))) / v178));
        v200.push((weight * v199));
      }
      v200 = (math.fsum(v200) * 1.0);
      v201 = (v157 * v200);
      v214 = (v157 - ((Math.log(v201) * v201) / ((Math.exp(v183) / (v160 * v166)) + ((v201 - 1.0) * ((v148 / v166) - (1.0 / v160))))));
      v215 = ((-2.0) * v214);
      v217 = (-Math.expm1(v215));
      v222 = (v101 - (v72 * Math.exp(((-2.0) * (((v214 < 300.0) || (v214 !== v214)) ? v214 : 300.0)))));
      v223 = (((v222 > 1.0) || (v222 !== v222)) ? v222 : 1.0);
      v225 = (1.0 / (v105 * v214));
      v240 = (v73 * v214);
      v257 = [];
      for ([node, weight] of RULE_0((1.0 / v225))) {
        v226 = (node * 1.0);
        v228 = ((v226 * v226) * v226);
        v230 = ((v228 * v228) * v226);
        v232 = (v230 * v226);
        v235 = (-Math.expm1((v215 * v232)));
        v236 = (1.0 - v232);
        v242 = Math.expm1((v240 * v232));
        v256 = ((8.0 * v230) * (((Math.exp((v214 * v236)) * Math.pow((v235 / v217), (-0.5))) * (v242 - (((v126 * (v242 + 1.0)) * v235) * ((-Math.expm1((v215 * v236))) / v217)))) / v235));
        v257.push((weight * v256));
      }
      v257 = (math.fsum(v257) * 1.0);
      v258 = (v214 * v257);
      v271 = (v214 - ((Math.log(v258) * v258) / ((Math.exp(v240) / (v217 * v223)) + ((v258 - 1.0) * ((v148 / v223) - (1.0 / v217))))));
      v272 = ((-2.0) * v271);
      v274 = (-Math.expm1(v272));
      v279 = (v101 - (v72 * Math.exp(((-2.0) * (((v271 < 300.0) || (v271 !== v271)) ? v271 : 300.0)))));
      v280 = (((v279 > 1.0) || (v279 !== v279)) ? v279 : 1.0);
      v282 = (1.0 / (v105 * v271));
      v297 = (v73 * v271);
      v314 = [];
      for ([node, weight] of RULE_0((1.0 / v282))) {
        v283 = (node * 1.0);
        v285 = ((v283 * v283) * v283);
        v287 = ((v285 * v285) * v283);
        v289 = (v287 * v283);
        v292 = (-Math.expm1((v272 * v289)));
        v293 = (1.0 - v289);
        v299 = Math.expm1((v297 * v289));
        v313 = ((8.0 * v287) * (((Math.exp((v271 * v293)) * Math.pow((v292 / v274), (-0.5))) * (v299 - (((v126 * (v299 + 1.0)) * v292) * ((-Math.expm1((v272 * v293))) / v274)))) / v292));
        v314.push((weight * v313));
      }
      v314 = (math.fsum(v314) * 1.0);
      v315 = (v271 * v314);
      v328 = (v271 - ((Math.log(v315) * v315) / ((Math.exp(v297) / (v274 * v280)) + ((v315 - 1.0) * ((v148 / v280) - (1.0 / v274))))));
      v329 = ((-2.0) * v328);
      v331 = (-Math.expm1(v329));
      v336 = (v101 - (v72 * Math.exp(((-2.0) * (((v328 < 300.0) || (v328 !== v328)) ? v328 : 300.0)))));
      v337 = (((v336 > 1.0) || (v336 !== v336)) ? v336 : 1.0);
      v339 = (1.0 / (v105 * v328));
      v354 = (v73 * v328);
      v371 = [];
      for ([node, weight] of RULE_0((1.0 / v339))) {
        v340 = (node * 1.0);
        v342 = ((v340 * v340) * v340);
        v344 = ((v342 * v342) * v340);
        v346 = (v344 * v340);
        v349 = (-Math.expm1((v329 * v346)));
        v350 = (1.0 - v346);
        v356 = Math.expm1((v354 * v346));
        v370 = ((8.0 * v344) * (((Math.exp((v328 * v350)) * Math.pow((v349 / v331), (-0.5))) * (v356 - (((v126 * (v356 + 1.0)) * v349) * ((-Math.expm1((v329 * v350))) / v331)))) / v349));
        v371.push((weight * v370));
      }
      v371 = (math.fsum(v371) * 1.0);
      v372 = (v328 * v371);
      v389 = (-Math.expm1(((-2.0) * (v328 - ((Math.log(v372) * v372) / ((Math.exp(v354) / (v331 * v337)) + ((v372 - 1.0) * ((v148 / v337) - (1.0 / v331)))))))));
    } else {
      v389 = 1.0;
    }
    v393 = (1.7724538509055159 * h);
    if (((((v393 * v69) / ((n * v389) - 1.0)) * 0.999999999999999) <= d)) {
      return (((2.0 * E_star) * a) * (d + ((v393 / (n + 1.0)) * v69)));
    }
    return NaN;
  }
  return _force(d, a, h, n, E_star);
};

const force = (d, a, h, n, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (n > 1)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_of_concave_power(d, a, h, n, E_star) : NaN);
};

const _pressure_of_concave_power = (r, d, a, h, n, E_star) => {
  let complete, kappa, minus, plus, result, root;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  root = Math.sqrt(((a - r) * (a + r)));
  plus = ((d / (Math.PI * root)) + ((h * kappa) / (Math.sqrt(Math.PI) * root)));
  minus = ((((n * h) * power_pressure(r, a, n)) * kappa) / (Math.sqrt(Math.PI) * a));
  complete = ((_minimum_depth(h, n) * (1.0 - 1e-15)) <= d);
  result = math.where(((r <= a) & (d > 0.0)), (E_star * (plus - minus)), 0.0);
  return math.where(complete, result, NaN);
};

const _pressure = (r, d, a, h, n, E_star) => {
  let node, v103, v108, v109, v11, v110, v115, v117, v118, v123, v126, v128, v137, v138, v139, v141, v146, v148, v149, v15, v158, v164, v166, v167, v169, v175, v177, v178, v179, v181, v182, v184, v186, v189, v192, v193, v197, v199, v200, v215, v216, v217, v222, v231, v232, v234, v239, v240, v242, v243, v245, v247, v249, v252, v253, v257, v259, v273, v274, v275, v288, v289, v29, v291, v296, v297, v299, v300, v302, v304, v306, v309, v310, v314, v316, v330, v331, v332, v345, v346, v348, v353, v354, v356, v357, v359, v361, v363, v366, v367, v371, v373, v387, v388, v389, v402, v403, v405, v410, v411, v413, v414, v416, v418, v420, v423, v424, v428, v430, v444, v445, v446, v463, v70, v71, v74, v84, v86, v9, v97, weight;
  if (((r > 1e-30) && (r < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v9 = ((n / 2.0) + 0.5);
    v11 = (v9 + 1.75);
    v15 = ((v9 + 0.5) * (v9 + 1.5));
    v29 = (1.0 / (v11 * v11));
    v70 = ((((v9 < 1.0) ? ((v9 * (v9 + 1.0)) / v15) : (1.0 - ((v9 + 0.75) / v15))) * Math.sqrt(v11)) * (1.0 + (v29 * (((((((((((((0.01524698625788054 * v29) + 0.5334320651111477) * v29) + 2.250488865813539) * v29) + 2.8612106440066865) * v29) + 1.3794681629043655) * v29) + 0.2596058532893223) * v29) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v29) + 49.328555418276075) * v29) + 167.28648538571198) * v29) + 195.37226190335065) * v29) + 90.69722535867314) * v29) + 16.763212110504565) * v29) + 1.0)))));
    v146 = (n > 2.0);
    if (v146) {
      v148 = (math.truth(v146) ? n : 3.0);
      v149 = (v148 - 2.0);
      v158 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v149) / (v149 + 0.72))) / v149));
      if ((v149 < 2.0)) {
        v164 = (Math.log(((v149 * (v149 + 2.0)) / 2.0)) / v149);
        v166 = (((v158 > v164) || (v158 !== v158)) ? v158 : v164);
      } else {
        v166 = v158;
      }
      v167 = ((-2.0) * v166);
      v169 = (-Math.expm1(v167));
      v175 = ((v148 - 1.0) + 0.0);
      v177 = (v175 - (v148 * Math.exp(((-2.0) * (((v166 < 300.0) || (v166 !== v166)) ? v166 : 300.0)))));
      v178 = (((v177 > 1.0) || (v177 !== v177)) ? v177 : 1.0);
      v179 = (v149 + 1.0);
      v181 = (1.0 / (v179 * v166));
      v197 = (v149 * v166);
      v200 = (0.5 * v149);
      v216 = [];
      for ([node, weight] of RULE_0((1.0 / v181))) {
        v182 = (node * 1.0);
        v184 = ((v182 * v182) * v182);
        v186 = ((v184 * v184) * v182);
        v189 = (v186 * v182);
        v192 = (-Math.expm1((v167 * v189)));
        v193 = (1.0 - v189);
        v199 = Math.expm1((v197 * v189));
        v215 = ((8.0 * v186) * (((Math.exp((v166 * v193)) * Math.pow((v192 / v169), (-0.5))) * (v199 - (((v200 * (v199 + 1.0)) * v192) * ((-Math.expm1((v167 * v193))) / v169)))) / v192));
        v216.push((weight * v215));
      }
      v216 = (math.fsum(v216) * 1.0);
      v217 = (v166 * v216);
      v222 = (2.0 * v175);
      v231 = (v166 - ((Math.log(v217) * v217) / ((Math.exp(v197) / (v169 * v178)) + ((v217 - 1.0) * ((v222 / v178) - (1.0 / v169))))));
      v232 = ((-2.0) * v231);
      v234 = (-Math.expm1(v232));
      v239 = (v175 - (v148 * Math.exp(((-2.0) * (((v231 < 300.0) || (v231 !== v231)) ? v231 : 300.0)))));
      v240 = (((v239 > 1.0) || (v239 !== v239)) ? v239 : 1.0);
      v242 = (1.0 / (v179 * v231));
      v257 = (v149 * v231);
      v274 = [];
      for ([node, weight] of RULE_0((1.0 / v242))) {
        v243 = (node * 1.0);
        v245 = ((v243 * v243) * v243);
        v247 = ((v245 * v245) * v243);
        v249 = (v247 * v243);
        v252 = (-Math.expm1((v232 * v249)));
        v253 = (1.0 - v249);
        v259 = Math.expm1((v257 * v249));
        v273 = ((8.0 * v247) * (((Math.exp((v231 * v253)) * Math.pow((v252 / v234), (-0.5))) * (v259 - (((v200 * (v259 + 1.0)) * v252) * ((-Math.expm1((v232 * v253))) / v234)))) / v252));
        v274.push((weight * v273));
      }
      v274 = (math.fsum(v274) * 1.0);
      v275 = (v231 * v274);
      v288 = (v231 - ((Math.log(v275) * v275) / ((Math.exp(v257) / (v234 * v240)) + ((v275 - 1.0) * ((v222 / v240) - (1.0 / v234))))));
      v289 = ((-2.0) * v288);
      v291 = (-Math.expm1(v289));
      v296 = (v175 - (v148 * Math.exp(((-2.0) * (((v288 < 300.0) || (v288 !== v288)) ? v288 : 300.0)))));
      v297 = (((v296 > 1.0) || (v296 !== v296)) ? v296 : 1.0);
      v299 = (1.0 / (v179 * v288));
      v314 = (v149 * v288);
      v331 = [];
      for ([node, weight] of RULE_0((1.0 / v299))) {
        v300 = (node * 1.0);
        v302 = ((v300 * v300) * v300);
        v304 = ((v302 * v302) * v300);
        v306 = (v304 * v300);
        v309 = (-Math.expm1((v289 * v306)));
        v310 = (1.0 - v306);
        v316 = Math.expm1((v314 * v306));
        v330 = ((8.0 * v304) * (((Math.exp((v288 * v310)) * Math.pow((v309 / v291), (-0.5))) * (v316 - (((v200 * (v316 + 1.0)) * v309) * ((-Math.expm1((v289 * v310))) / v291)))) / v309));
        v331.push((weight * v330));
      }
      v331 = (math.fsum(v331) * 1.0);
      v332 = (v288 * v331);
      v345 = (v288 - ((Math.log(v332) * v332) / ((Math.exp(v314) / (v291 * v297)) + ((v332 - 1.0) * ((v222 / v297) - (1.0 / v291))))));
      v346 = ((-2.0) * v345);
      v348 = (-Math.expm1(v346));
      v353 = (v175 - (v148 * Math.exp(((-2.0) * (((v345 < 300.0) || (v345 !== v345)) ? v345 : 300.0)))));
      v354 = (((v353 > 1.0) || (v353 !== v353)) ? v353 : 1.0);
      v356 = (1.0 / (v179 * v345));
      v371 = (v149 * v345);
      v388 = [];
      for ([node, weight] of RULE_0((1.0 / v356))) {
        v357 = (node * 1.0);
        v359 = ((v357 * v357) * v357);
        v361 = ((v359 * v359) * v357);
        v363 = (v361 * v357);
        v366 = (-Math.expm1((v346 * v363)));
        v367 = (1.0 - v363);
        v373 = Math.expm1((v371 * v363));
        v387 = ((8.0 * v361) * (((Math.exp((v345 * v367)) * Math.pow((v366 / v348), (-0.5))) * (v373 - (((v200 * (v373 + 1.0)) * v366) * ((-Math.expm1((v346 * v367))) / v348)))) / v366));
        v388.push((weight * v387));
      }
      v388 = (math.fsum(v388) * 1.0);
      v389 = (v345 * v388);
      v402 = (v345 - ((Math.log(v389) * v389) / ((Math.exp(v371) / (v348 * v354)) + ((v389 - 1.0) * ((v222 / v354) - (1.0 / v348))))));
      v403 = ((-2.0) * v402);
      v405 = (-Math.expm1(v403));
      v410 = (v175 - (v148 * Math.exp(((-2.0) * (((v402 < 300.0) || (v402 !== v402)) ? v402 : 300.0)))));
      v411 = (((v410 > 1.0) || (v410 !== v410)) ? v410 : 1.0);
      v413 = (1.0 / (v179 * v402));
      v428 = (v149 * v402);
      v445 = [];
      for ([node, weight] of RULE_0((1.0 / v413))) {
        v414 = (node * 1.0);
        v416 = ((v414 * v414) * v414);
        v418 = ((v416 * v416) * v414);
        v420 = (v418 * v414);
        v423 = (-Math.expm1((v403 * v420)));
        v424 = (1.0 - v420);
        v430 = Math.expm1((v428 * v420));
        v444 = ((8.0 * v418) * (((Math.exp((v402 * v424)) * Math.pow((v423 / v405), (-0.5))) * (v430 - (((v200 * (v430 + 1.0)) * v423) * ((-Math.expm1((v403 * v424))) / v405)))) / v423));
        v445.push((weight * v444));
      }
      v445 = (math.fsum(v445) * 1.0);
      v446 = (v402 * v445);
      v463 = (-Math.expm1(((-2.0) * (v402 - ((Math.log(v446) * v446) / ((Math.exp(v428) / (v405 * v411)) + ((v446 - 1.0) * ((v222 / v411) - (1.0 / v405)))))))));
    } else {
      v463 = 1.0;
    }
    if ((((((1.7724538509055159 * h) * v70) / ((n * v463) - 1.0)) * 0.999999999999999) <= d)) {
      if (((r <= a) && (d > 0.0))) {
        v71 = (a - r);
        v74 = Math.sqrt((v71 * (a + r)));
        v84 = (n > 1.0);
        v86 = Math.abs((n - 1.0));
        if ((r > 0.0)) {
          v97 = (v71 / r);
          v103 = (Number.isFinite(v97) ? Math.log1p(v97) : (Math.log(a) - Math.log(r)));
          if ((v103 > 0.0)) {
            v108 = (v103 - (42.0 / (((v86 > 0.001) || (v86 !== v86)) ? v86 : 0.001)));
            v109 = (((v108 > 0.0) || (v108 !== v108)) ? v108 : 0.0);
            v110 = Math.sqrt(v103);
            v115 = (math.truth(v84) ? (v110 - Math.sqrt(v109)) : Math.sqrt((v103 - v109)));
            v118 = (2.0 * v110);
            v123 = (-v86);
            v138 = [];
            for ([node, weight] of RULE_2((v115 / 1.0))) {
              v117 = (node * v115);
              if (v84) {
                v126 = (v110 - v117);
                v128 = (((v126 > 0.0) || (v126 !== v126)) ? v126 : 0.0);
              } else {
                v128 = v117;
              }
              v137 = (Math.exp((v123 * (math.truth(v84) ? (v117 * (v118 - v117)) : (v117 * v117)))) * ((2.0 * v128) / Math.sqrt((-Math.expm1((((-2.0) * v128) * v128))))));
              v138.push((weight * v137));
            }
            v138 = (math.fsum(v138) * v115);
            v139 = v138;
          } else {
            v139 = 0.0;
          }
          v141 = ((math.truth(v84) ? 1.0 : (Math.pow((r / a), n) * (a / r))) * v139);
        } else {
          v141 = (math.truth(v84) ? (1.0 / v86) : Infinity);
        }
        return (E_star * (((d / (3.141592653589793 * v74)) + ((h * v70) / (1.7724538509055159 * v74))) - ((((n * h) * v141) * v70) / (1.7724538509055159 * a))));
      }
      return 0.0;
    }
    return NaN;
  }
  return _pressure_of_concave_power(r, d, a, h, n, E_star);
};

const pressure = (r, d, a, h, n, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (n > 1)))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _pressure(r, d, a, h, n, E_star) : 0.0) : NaN);
};

const RULE_1 = math.rule([[Infinity, 64]]);

const _log_ratio_2 = (x, y) => {
  let excess;
  excess = ((x - y) / y);
  return math.where(Number.isFinite(excess), Math.log1p(excess), (Math.log(x) - Math.log(y)));
};

const _DECAY = 42.0;

const _span = (r, a, n) => {
  let fall, start;
  start = Math.sqrt(_log_ratio_2(r, a));
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

const _profile = (r, a, h, n) => {
  return math.where((r <= a), ((-h) * Math.pow((r / a), n)), NaN);
};

const _displacement_of_concave_power = (r, d, a, h, n) => {
  let angle, complete, inside, kappa, outside, result, root;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  root = Math.sqrt(((r - a) * (a + r)));
  angle = Math.atan2(a, root);
  outside = ((((2 * d) * angle) / Math.PI) + ((((2 * h) / Math.sqrt(Math.PI)) * power_punches(r, a, n)) * kappa));
  inside = (d - _profile(r, a, h, n));
  complete = ((_minimum_depth(h, n) * (1.0 - 1e-15)) <= d);
  result = math.where((r > a), outside, inside);
  return math.where(complete, result, NaN);
};

const _displacement = (r, d, a, h, n) => {
  let node, v10, v100, v101, v103, v115, v116, v129, v131, v132, v14, v141, v147, v149, v150, v152, v159, v161, v162, v163, v165, v166, v168, v170, v173, v176, v177, v181, v183, v184, v199, v200, v201, v206, v215, v216, v218, v223, v224, v226, v227, v229, v231, v233, v236, v237, v241, v243, v257, v258, v259, v272, v273, v275, v28, v280, v281, v283, v284, v286, v288, v290, v293, v294, v298, v300, v314, v315, v316, v329, v330, v332, v337, v338, v340, v341, v343, v345, v347, v350, v351, v355, v357, v371, v372, v373, v386, v387, v389, v394, v395, v397, v398, v400, v402, v404, v407, v408, v412, v414, v428, v429, v430, v447, v69, v70, v8, v82, v89, v90, v92, v97, v99, weight;
  if (((r > 1e-30) && (r < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30))) {
    v8 = ((n / 2.0) + 0.5);
    v10 = (v8 + 1.75);
    v14 = ((v8 + 0.5) * (v8 + 1.5));
    v28 = (1.0 / (v10 * v10));
    v69 = ((((v8 < 1.0) ? ((v8 * (v8 + 1.0)) / v14) : (1.0 - ((v8 + 0.75) / v14))) * Math.sqrt(v10)) * (1.0 + (v28 * (((((((((((((0.01524698625788054 * v28) + 0.5334320651111477) * v28) + 2.250488865813539) * v28) + 2.8612106440066865) * v28) + 1.3794681629043655) * v28) + 0.2596058532893223) * v28) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v28) + 49.328555418276075) * v28) + 167.28648538571198) * v28) + 195.37226190335065) * v28) + 90.69722535867314) * v28) + 16.763212110504565) * v28) + 1.0)))));
    v129 = (n > 2.0);
    if (v129) {
      v131 = (math.truth(v129) ? n : 3.0);
      v132 = (v131 - 2.0);
      v141 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v132) / (v132 + 0.72))) / v132));
      if ((v132 < 2.0)) {
        v147 = (Math.log(((v132 * (v132 + 2.0)) / 2.0)) / v132);
        v149 = (((v141 > v147) || (v141 !== v141)) ? v141 : v147);
      } else {
        v149 = v141;
      }
      v150 = ((-2.0) * v149);
      v152 = (-Math.expm1(v150));
      v159 = ((v131 - 1.0) + 0.0);
      v161 = (v159 - (v131 * Math.exp(((-2.0) * (((v149 < 300.0) || (v149 !== v149)) ? v149 : 300.0)))));
      v162 = (((v161 > 1.0) || (v161 !== v161)) ? v161 : 1.0);
      v163 = (v132 + 1.0);
      v165 = (1.0 / (v163 * v149));
      v181 = (v132 * v149);
      v184 = (0.5 * v132);
      v200 = [];
      for ([node, weight] of RULE_0((1.0 / v165))) {
        v166 = (node * 1.0);
        v168 = ((v166 * v166) * v166);
        v170 = ((v168 * v168) * v166);
        v173 = (v170 * v166);
        v176 = (-Math.expm1((v150 * v173)));
        v177 = (1.0 - v173);
        v183 = Math.expm1((v181 * v173));
        v199 = ((8.0 * v170) * (((Math.exp((v149 * v177)) * Math.pow((v176 / v152), (-0.5))) * (v183 - (((v184 * (v183 + 1.0)) * v176) * ((-Math.expm1((v150 * v177))) / v152)))) / v176));
        v200.push((weight * v199));
      }
      v200 = (math.fsum(v200) * 1.0);
      v201 = (v149 * v200);
      v206 = (2.0 * v159);
      v215 = (v149 - ((Math.log(v201) * v201) / ((Math.exp(v181) / (v152 * v162)) + ((v201 - 1.0) * ((v206 / v162) - (1.0 / v152))))));
      v216 = ((-2.0) * v215);
      v218 = (-Math.expm1(v216));
      v223 = (v159 - (v131 * Math.exp(((-2.0) * (((v215 < 300.0) || (v215 !== v215)) ? v215 : 300.0)))));
      v224 = (((v223 > 1.0) || (v223 !== v223)) ? v223 : 1.0);
      v226 = (1.0 / (v163 * v215));
      v241 = (v132 * v215);
      v258 = [];
      for ([node, weight] of RULE_0((1.0 / v226))) {
        v227 = (node * 1.0);
        v229 = ((v227 * v227) * v227);
        v231 = ((v229 * v229) * v227);
        v233 = (v231 * v227);
        v236 = (-Math.expm1((v216 * v233)));
        v237 = (1.0 - v233);
        v243 = Math.expm1((v241 * v233));
        v257 = ((8.0 * v231) * (((Math.exp((v215 * v237)) * Math.pow((v236 / v218), (-0.5))) * (v243 - (((v184 * (v243 + 1.0)) * v236) * ((-Math.expm1((v216 * v237))) / v218)))) / v236));
        v258.push((weight * v257));
      }
      v258 = (math.fsum(v258) * 1.0);
      v259 = (v215 * v258);
      v272 = (v215 - ((Math.log(v259) * v259) / ((Math.exp(v241) / (v218 * v224)) + ((v259 - 1.0) * ((v206 / v224) - (1.0 / v218))))));
      v273 = ((-2.0) * v272);
      v275 = (-Math.expm1(v273));
      v280 = (v159 - (v131 * Math.exp(((-2.0) * (((v272 < 300.0) || (v272 !== v272)) ? v272 : 300.0)))));
      v281 = (((v280 > 1.0) || (v280 !== v280)) ? v280 : 1.0);
      v283 = (1.0 / (v163 * v272));
      v298 = (v132 * v272);
      v315 = [];
      for ([node, weight] of RULE_0((1.0 / v283))) {
        v284 = (node * 1.0);
        v286 = ((v284 * v284) * v284);
        v288 = ((v286 * v286) * v284);
        v290 = (v288 * v284);
        v293 = (-Math.expm1((v273 * v290)));
        v294 = (1.0 - v290);
        v300 = Math.expm1((v298 * v290));
        v314 = ((8.0 * v288) * (((Math.exp((v272 * v294)) * Math.pow((v293 / v275), (-0.5))) * (v300 - (((v184 * (v300 + 1.0)) * v293) * ((-Math.expm1((v273 * v294))) / v275)))) / v293));
        v315.push((weight * v314));
      }
      v315 = (math.fsum(v315) * 1.0);
      v316 = (v272 * v315);
      v329 = (v272 - ((Math.log(v316) * v316) / ((Math.exp(v298) / (v275 * v281)) + ((v316 - 1.0) * ((v206 / v281) - (1.0 / v275))))));
      v330 = ((-2.0) * v329);
      v332 = (-Math.expm1(v330));
      v337 = (v159 - (v131 * Math.exp(((-2.0) * (((v329 < 300.0) || (v329 !== v329)) ? v329 : 300.0)))));
      v338 = (((v337 > 1.0) || (v337 !== v337)) ? v337 : 1.0);
      v340 = (1.0 / (v163 * v329));
      v355 = (v132 * v329);
      v372 = [];
      for ([node, weight] of RULE_0((1.0 / v340))) {
        v341 = (node * 1.0);
        v343 = ((v341 * v341) * v341);
        v345 = ((v343 * v343) * v341);
        v347 = (v345 * v341);
        v350 = (-Math.expm1((v330 * v347)));
        v351 = (1.0 - v347);
        v357 = Math.expm1((v355 * v347));
        v371 = ((8.0 * v345) * (((Math.exp((v329 * v351)) * Math.pow((v350 / v332), (-0.5))) * (v357 - (((v184 * (v357 + 1.0)) * v350) * ((-Math.expm1((v330 * v351))) / v332)))) / v350));
        v372.push((weight * v371));
      }
      v372 = (math.fsum(v372) * 1.0);
      v373 = (v329 * v372);
      v386 = (v329 - ((Math.log(v373) * v373) / ((Math.exp(v355) / (v332 * v338)) + ((v373 - 1.0) * ((v206 / v338) - (1.0 / v332))))));
      v387 = ((-2.0) * v386);
      v389 = (-Math.expm1(v387));
      v394 = (v159 - (v131 * Math.exp(((-2.0) * (((v386 < 300.0) || (v386 !== v386)) ? v386 : 300.0)))));
      v395 = (((v394 > 1.0) || (v394 !== v394)) ? v394 : 1.0);
      v397 = (1.0 / (v163 * v386));
      v412 = (v132 * v386);
      v429 = [];
      for ([node, weight] of RULE_0((1.0 / v397))) {
        v398 = (node * 1.0);
        v400 = ((v398 * v398) * v398);
        v402 = ((v400 * v400) * v398);
        v404 = (v402 * v398);
        v407 = (-Math.expm1((v387 * v404)));
        v408 = (1.0 - v404);
        v414 = Math.expm1((v412 * v404));
        v428 = ((8.0 * v402) * (((Math.exp((v386 * v408)) * Math.pow((v407 / v389), (-0.5))) * (v414 - (((v184 * (v414 + 1.0)) * v407) * ((-Math.expm1((v387 * v408))) / v389)))) / v407));
        v429.push((weight * v428));
      }
      v429 = (math.fsum(v429) * 1.0);
      v430 = (v386 * v429);
      v447 = (-Math.expm1(((-2.0) * (v386 - ((Math.log(v430) * v430) / ((Math.exp(v412) / (v389 * v395)) + ((v430 - 1.0) * ((v206 / v395) - (1.0 / v389)))))))));
    } else {
      v447 = 1.0;
    }
    if ((((((1.7724538509055159 * h) * v69) / ((n * v447) - 1.0)) * 0.999999999999999) <= d)) {
      if ((r > a)) {
        v70 = (r - a);
        v82 = (v70 / a);
        v89 = Math.sqrt((Number.isFinite(v82) ? Math.log1p(v82) : (Math.log(r) - Math.log(a))));
        v90 = (n + 1.0);
        v92 = (42.0 / v90);
        v97 = (v92 / (Math.sqrt(((v89 * v89) + v92)) + v89));
        v101 = (-v90);
        v103 = (2.0 * v89);
        v116 = [];
        for ([node, weight] of RULE_1((v97 / 1.0))) {
          v99 = (node * v97);
          v100 = (v89 + v99);
          v115 = (Math.exp(((v101 * v99) * (v103 + v99))) * ((2.0 * v100) / Math.sqrt((-Math.expm1((((-2.0) * v100) * v100))))));
          v116.push((weight * v115));
        }
        v116 = (math.fsum(v116) * v97);
        return ((((2.0 * d) * Math.atan2(a, Math.sqrt((v70 * (a + r))))) / 3.141592653589793) + ((((2.0 * h) / 1.7724538509055159) * ((a / r) * v116)) * v69));
      }
      return (d - ((r <= a) ? ((-h) * Math.pow((r / a), n)) : NaN));
    }
    return NaN;
  }
  return _displacement_of_concave_power(r, d, a, h, n);
};

const displacement = (r, d, a, h, n) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (n > 1)))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _displacement(r, d, a, h, n) : 0.0) : NaN);
};

const _stiffness_of_concave_power = (a, E_star) => {
  return ((2 * E_star) * a);
};

const _stiffness = (a, E_star, h = 1.0, n = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30))) {
    return ((2.0 * E_star) * a);
  }
  return _stiffness_of_concave_power(a, E_star);
};

const stiffness = (a, h, n, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (n > 1)))) {
    return NaN;
  }
  return _stiffness(a, E_star);
};

const _minimum_force = (a, h, n, E_star) => {
  let drop, kappa, zeta;
  zeta = outside_zero_pressure(n);
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  drop = ((n + 1) * ((n * zeta) - 1));
  return ((((((((2 * Math.sqrt(Math.PI)) * E_star) * n) * h) * (zeta + 1)) * a) * kappa) / drop);
};

const _depth_from_force_of_concave_power = (F, a, h, n, E_star) => {
  let complete, kappa, result;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  complete = ((_minimum_force(a, h, n, E_star) * (1.0 - 1e-15)) <= F);
  result = ((F / ((2 * E_star) * a)) - (((Math.sqrt(Math.PI) * h) / (n + 1)) * kappa));
  return math.where(complete, result, NaN);
};

const _depth_from_force = (F, a, h, n, E_star) => {
  let node, v10, v101, v103, v104, v105, v107, v108, v110, v112, v115, v118, v119, v123, v125, v126, v14, v141, v142, v143, v148, v157, v158, v160, v165, v166, v168, v169, v171, v173, v175, v178, v179, v183, v185, v199, v200, v201, v214, v215, v217, v222, v223, v225, v226, v228, v230, v232, v235, v236, v240, v242, v256, v257, v258, v271, v272, v274, v279, v28, v280, v282, v283, v285, v287, v289, v292, v293, v297, v299, v313, v314, v315, v328, v329, v331, v336, v337, v339, v340, v342, v344, v346, v349, v350, v354, v356, v370, v371, v372, v389, v390, v69, v70, v72, v73, v8, v82, v88, v90, v92, v94, weight;
  if (((F > 1e-30) && (F < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v8 = ((n / 2.0) + 0.5);
    v10 = (v8 + 1.75);
    v14 = ((v8 + 0.5) * (v8 + 1.5));
    v28 = (1.0 / (v10 * v10));
    v69 = ((((v8 < 1.0) ? ((v8 * (v8 + 1.0)) / v14) : (1.0 - ((v8 + 0.75) / v14))) * Math.sqrt(v10)) * (1.0 + (v28 * (((((((((((((0.01524698625788054 * v28) + 0.5334320651111477) * v28) + 2.250488865813539) * v28) + 2.8612106440066865) * v28) + 1.3794681629043655) * v28) + 0.2596058532893223) * v28) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v28) + 49.328555418276075) * v28) + 167.28648538571198) * v28) + 195.37226190335065) * v28) + 90.69722535867314) * v28) + 16.763212110504565) * v28) + 1.0)))));
    v70 = (n > 2.0);
    if (v70) {
      v72 = (math.truth(v70) ? n : 3.0);
      v73 = (v72 - 2.0);
      v82 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v73) / (v73 + 0.72))) / v73));
      if ((v73 < 2.0)) {
        v88 = (Math.log(((v73 * (v73 + 2.0)) / 2.0)) / v73);
        v90 = (((v82 > v88) || (v82 !== v82)) ? v82 : v88);
      } else {
        v90 = v82;
      }
      v92 = ((-2.0) * v90);
      v94 = (-Math.expm1(v92));
      v101 = ((v72 - 1.0) + 0.0);
      v103 = (v101 - (v72 * Math.exp(((-2.0) * (((v90 < 300.0) || (v90 !== v90)) ? v90 : 300.0)))));
      v104 = (((v103 > 1.0) || (v103 !== v103)) ? v103 : 1.0);
      v105 = (v73 + 1.0);
      v107 = (1.0 / (v105 * v90));
      v123 = (v73 * v90);
      v126 = (0.5 * v73);
      v142 = [];
      for ([node, weight] of RULE_0((1.0 / v107))) {
        v108 = (node * 1.0);
        v110 = ((v108 * v108) * v108);
        v112 = ((v110 * v110) * v108);
        v115 = (v112 * v108);
        v118 = (-Math.expm1((v92 * v115)));
        v119 = (1.0 - v115);
        v125 = Math.expm1((v123 * v115));
        v141 = ((8.0 * v112) * (((Math.exp((v90 * v119)) * Math.pow((v118 / v94), (-0.5))) * (v125 - (((v126 * (v125 + 1.0)) * v118) * ((-Math.expm1((v92 * v119))) / v94)))) / v118));
        v142.push((weight * v141));
      }
      v142 = (math.fsum(v142) * 1.0);
      v143 = (v90 * v142);
      v148 = (2.0 * v101);
      v157 = (v90 - ((Math.log(v143) * v143) / ((Math.exp(v123) / (v94 * v104)) + ((v143 - 1.0) * ((v148 / v104) - (1.0 / v94))))));
      v158 = ((-2.0) * v157);
      v160 = (-Math.expm1(v158));
      v165 = (v101 - (v72 * Math.exp(((-2.0) * (((v157 < 300.0) || (v157 !== v157)) ? v157 : 300.0)))));
      v166 = (((v165 > 1.0) || (v165 !== v165)) ? v165 : 1.0);
      v168 = (1.0 / (v105 * v157));
      v183 = (v73 * v157);
      v200 = [];
      for ([node, weight] of RULE_0((1.0 / v168))) {
        v169 = (node * 1.0);
        v171 = ((v169 * v169) * v169);
        v173 = ((v171 * v171) * v169);
        v175 = (v173 * v169);
        v178 = (-Math.expm1((v158 * v175)));
        v179 = (1.0 - v175);
        v185 = Math.expm1((v183 * v175));
        v199 = ((8.0 * v173) * (((Math.exp((v157 * v179)) * Math.pow((v178 / v160), (-0.5))) * (v185 - (((v126 * (v185 + 1.0)) * v178) * ((-Math.expm1((v158 * v179))) / v160)))) / v178));
        v200.push((weight * v199));
      }
      v200 = (math.fsum(v200) * 1.0);
      v201 = (v157 * v200);
      v214 = (v157 - ((Math.log(v201) * v201) / ((Math.exp(v183) / (v160 * v166)) + ((v201 - 1.0) * ((v148 / v166) - (1.0 / v160))))));
      v215 = ((-2.0) * v214);
      v217 = (-Math.expm1(v215));
      v222 = (v101 - (v72 * Math.exp(((-2.0) * (((v214 < 300.0) || (v214 !== v214)) ? v214 : 300.0)))));
      v223 = (((v222 > 1.0) || (v222 !== v222)) ? v222 : 1.0);
      v225 = (1.0 / (v105 * v214));
      v240 = (v73 * v214);
      v257 = [];
      for ([node, weight] of RULE_0((1.0 / v225))) {
        v226 = (node * 1.0);
        v228 = ((v226 * v226) * v226);
        v230 = ((v228 * v228) * v226);
        v232 = (v230 * v226);
        v235 = (-Math.expm1((v215 * v232)));
        v236 = (1.0 - v232);
        v242 = Math.expm1((v240 * v232));
        v256 = ((8.0 * v230) * (((Math.exp((v214 * v236)) * Math.pow((v235 / v217), (-0.5))) * (v242 - (((v126 * (v242 + 1.0)) * v235) * ((-Math.expm1((v215 * v236))) / v217)))) / v235));
        v257.push((weight * v256));
      }
      v257 = (math.fsum(v257) * 1.0);
      v258 = (v214 * v257);
      v271 = (v214 - ((Math.log(v258) * v258) / ((Math.exp(v240) / (v217 * v223)) + ((v258 - 1.0) * ((v148 / v223) - (1.0 / v217))))));
      v272 = ((-2.0) * v271);
      v274 = (-Math.expm1(v272));
      v279 = (v101 - (v72 * Math.exp(((-2.0) * (((v271 < 300.0) || (v271 !== v271)) ? v271 : 300.0)))));
      v280 = (((v279 > 1.0) || (v279 !== v279)) ? v279 : 1.0);
      v282 = (1.0 / (v105 * v271));
      v297 = (v73 * v271);
      v314 = [];
      for ([node, weight] of RULE_0((1.0 / v282))) {
        v283 = (node * 1.0);
        v285 = ((v283 * v283) * v283);
        v287 = ((v285 * v285) * v283);
        v289 = (v287 * v283);
        v292 = (-Math.expm1((v272 * v289)));
        v293 = (1.0 - v289);
        v299 = Math.expm1((v297 * v289));
        v313 = ((8.0 * v287) * (((Math.exp((v271 * v293)) * Math.pow((v292 / v274), (-0.5))) * (v299 - (((v126 * (v299 + 1.0)) * v292) * ((-Math.expm1((v272 * v293))) / v274)))) / v292));
        v314.push((weight * v313));
      }
      v314 = (math.fsum(v314) * 1.0);
      v315 = (v271 * v314);
      v328 = (v271 - ((Math.log(v315) * v315) / ((Math.exp(v297) / (v274 * v280)) + ((v315 - 1.0) * ((v148 / v280) - (1.0 / v274))))));
      v329 = ((-2.0) * v328);
      v331 = (-Math.expm1(v329));
      v336 = (v101 - (v72 * Math.exp(((-2.0) * (((v328 < 300.0) || (v328 !== v328)) ? v328 : 300.0)))));
      v337 = (((v336 > 1.0) || (v336 !== v336)) ? v336 : 1.0);
      v339 = (1.0 / (v105 * v328));
      v354 = (v73 * v328);
      v371 = [];
      for ([node, weight] of RULE_0((1.0 / v339))) {
        v340 = (node * 1.0);
        v342 = ((v340 * v340) * v340);
        v344 = ((v342 * v342) * v340);
        v346 = (v344 * v340);
        v349 = (-Math.expm1((v329 * v346)));
        v350 = (1.0 - v346);
        v356 = Math.expm1((v354 * v346));
        v370 = ((8.0 * v344) * (((Math.exp((v328 * v350)) * Math.pow((v349 / v331), (-0.5))) * (v356 - (((v126 * (v356 + 1.0)) * v349) * ((-Math.expm1((v329 * v350))) / v331)))) / v349));
        v371.push((weight * v370));
      }
      v371 = (math.fsum(v371) * 1.0);
      v372 = (v328 * v371);
      v389 = (-Math.expm1(((-2.0) * (v328 - ((Math.log(v372) * v372) / ((Math.exp(v354) / (v331 * v337)) + ((v372 - 1.0) * ((v148 / v337) - (1.0 / v331)))))))));
    } else {
      v389 = 1.0;
    }
    v390 = (n + 1.0);
    if ((((((((((3.5449077018110318 * E_star) * n) * h) * (v389 + 1.0)) * a) * v69) / (v390 * ((n * v389) - 1.0))) * 0.999999999999999) <= F)) {
      return ((F / ((2.0 * E_star) * a)) - (((1.7724538509055159 * h) / v390) * v69));
    }
    return NaN;
  }
  return _depth_from_force_of_concave_power(F, a, h, n, E_star);
};

const depth_from_force = (F, a, h, n, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (n > 1)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force(F, a, h, n, E_star) : NaN);
};

const ring_of_zero_pressure = (n, k = 0.0) => {
  return math.where((n > 2.0), Math.exp((-_log_ratio(n, k))), 0.0);
};

const _zero_radius_of_concave_power = (a, n) => {
  return (a * ring_of_zero_pressure(n));
};

const _zero_radius = (a, n, h = 1.0) => {
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
  return _zero_radius_of_concave_power(a, n);
};

const zero_radius = (a, h, n) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (n > 1)))) {
    return NaN;
  }
  return _zero_radius(a, n);
};

const _minimum_depth_of_concave_power = (h, n, a = 1.0) => {
  let node, v100, v101, v103, v104, v106, v108, v110, v113, v114, v118, v120, v134, v135, v136, v149, v15, v150, v152, v157, v158, v160, v161, v163, v165, v167, v170, v171, v175, v177, v191, v192, v193, v206, v207, v209, v214, v215, v217, v218, v22, v220, v222, v224, v227, v228, v232, v234, v24, v248, v249, v250, v26, v263, v264, v266, v271, v272, v274, v275, v277, v279, v28, v281, v284, v285, v289, v291, v3, v305, v306, v307, v324, v326, v328, v332, v345, v35, v37, v38, v39, v41, v42, v44, v46, v49, v5, v52, v53, v57, v59, v6, v61, v76, v77, v78, v83, v92, v93, v95, weight;
  if (((h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (a > 1e-30) && (a < 1e+30))) {
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
      v324 = (-Math.expm1(((-2.0) * (v263 - ((Math.log(v307) * v307) / ((Math.exp(v289) / (v266 * v272)) + ((v307 - 1.0) * ((v83 / v272) - (1.0 / v266)))))))));
    } else {
      v324 = 1.0;
    }
    v326 = ((n / 2.0) + 0.5);
    v328 = (v326 + 1.75);
    v332 = ((v326 + 0.5) * (v326 + 1.5));
    v345 = (1.0 / (v328 * v328));
    return (((1.7724538509055159 * h) * ((((v326 < 1.0) ? ((v326 * (v326 + 1.0)) / v332) : (1.0 - ((v326 + 0.75) / v332))) * Math.sqrt(v328)) * (1.0 + (v345 * (((((((((((((0.01524698625788054 * v345) + 0.5334320651111477) * v345) + 2.250488865813539) * v345) + 2.8612106440066865) * v345) + 1.3794681629043655) * v345) + 0.2596058532893223) * v345) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v345) + 49.328555418276075) * v345) + 167.28648538571198) * v345) + 195.37226190335065) * v345) + 90.69722535867314) * v345) + 16.763212110504565) * v345) + 1.0)))))) / ((n * v324) - 1.0));
  }
  return _minimum_depth(h, n);
};

const minimum_depth = (a, h, n) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (n > 1)))) {
    return NaN;
  }
  return _minimum_depth_of_concave_power(h, n);
};

const _minimum_force_of_concave_power = (a, h, n, E_star) => {
  let node, v102, v103, v105, v106, v108, v110, v112, v115, v116, v120, v122, v136, v137, v138, v151, v152, v154, v159, v160, v162, v163, v165, v167, v169, v17, v172, v173, v177, v179, v193, v194, v195, v208, v209, v211, v216, v217, v219, v220, v222, v224, v226, v229, v230, v234, v236, v24, v250, v251, v252, v26, v265, v266, v268, v273, v274, v276, v277, v279, v28, v281, v283, v286, v287, v291, v293, v30, v307, v308, v309, v326, v328, v330, v334, v347, v37, v39, v40, v41, v43, v44, v46, v48, v5, v51, v54, v55, v59, v61, v63, v7, v78, v79, v8, v80, v85, v94, v95, v97, weight;
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30))) {
    v5 = (n > 2.0);
    if (v5) {
      v7 = (math.truth(v5) ? n : 3.0);
      v8 = (v7 - 2.0);
      v17 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v8) / (v8 + 0.72))) / v8));
      if ((v8 < 2.0)) {
        v24 = (Math.log(((v8 * (v8 + 2.0)) / 2.0)) / v8);
        v26 = (((v17 > v24) || (v17 !== v17)) ? v17 : v24);
      } else {
        v26 = v17;
      }
      v28 = ((-2.0) * v26);
      v30 = (-Math.expm1(v28));
      v37 = ((v7 - 1.0) + 0.0);
      v39 = (v37 - (v7 * Math.exp(((-2.0) * (((v26 < 300.0) || (v26 !== v26)) ? v26 : 300.0)))));
      v40 = (((v39 > 1.0) || (v39 !== v39)) ? v39 : 1.0);
      v41 = (v8 + 1.0);
      v43 = (1.0 / (v41 * v26));
      v59 = (v8 * v26);
      v63 = (0.5 * v8);
      v79 = [];
      for ([node, weight] of RULE_0((1.0 / v43))) {
        v44 = (node * 1.0);
        v46 = ((v44 * v44) * v44);
        v48 = ((v46 * v46) * v44);
        v51 = (v48 * v44);
        v54 = (-Math.expm1((v28 * v51)));
        v55 = (1.0 - v51);
        v61 = Math.expm1((v59 * v51));
        v78 = ((8.0 * v48) * (((Math.exp((v26 * v55)) * Math.pow((v54 / v30), (-0.5))) * (v61 - (((v63 * (v61 + 1.0)) * v54) * ((-Math.expm1((v28 * v55))) / v30)))) / v54));
        v79.push((weight * v78));
      }
      v79 = (math.fsum(v79) * 1.0);
      v80 = (v26 * v79);
      v85 = (2.0 * v37);
      v94 = (v26 - ((Math.log(v80) * v80) / ((Math.exp(v59) / (v30 * v40)) + ((v80 - 1.0) * ((v85 / v40) - (1.0 / v30))))));
      v95 = ((-2.0) * v94);
      v97 = (-Math.expm1(v95));
      v102 = (v37 - (v7 * Math.exp(((-2.0) * (((v94 < 300.0) || (v94 !== v94)) ? v94 : 300.0)))));
      v103 = (((v102 > 1.0) || (v102 !== v102)) ? v102 : 1.0);
      v105 = (1.0 / (v41 * v94));
      v120 = (v8 * v94);
      v137 = [];
      for ([node, weight] of RULE_0((1.0 / v105))) {
        v106 = (node * 1.0);
        v108 = ((v106 * v106) * v106);
        v110 = ((v108 * v108) * v106);
        v112 = (v110 * v106);
        v115 = (-Math.expm1((v95 * v112)));
        v116 = (1.0 - v112);
        v122 = Math.expm1((v120 * v112));
        v136 = ((8.0 * v110) * (((Math.exp((v94 * v116)) * Math.pow((v115 / v97), (-0.5))) * (v122 - (((v63 * (v122 + 1.0)) * v115) * ((-Math.expm1((v95 * v116))) / v97)))) / v115));
        v137.push((weight * v136));
      }
      v137 = (math.fsum(v137) * 1.0);
      v138 = (v94 * v137);
      v151 = (v94 - ((Math.log(v138) * v138) / ((Math.exp(v120) / (v97 * v103)) + ((v138 - 1.0) * ((v85 / v103) - (1.0 / v97))))));
      v152 = ((-2.0) * v151);
      v154 = (-Math.expm1(v152));
      v159 = (v37 - (v7 * Math.exp(((-2.0) * (((v151 < 300.0) || (v151 !== v151)) ? v151 : 300.0)))));
      v160 = (((v159 > 1.0) || (v159 !== v159)) ? v159 : 1.0);
      v162 = (1.0 / (v41 * v151));
      v177 = (v8 * v151);
      v194 = [];
      for ([node, weight] of RULE_0((1.0 / v162))) {
        v163 = (node * 1.0);
        v165 = ((v163 * v163) * v163);
        v167 = ((v165 * v165) * v163);
        v169 = (v167 * v163);
        v172 = (-Math.expm1((v152 * v169)));
        v173 = (1.0 - v169);
        v179 = Math.expm1((v177 * v169));
        v193 = ((8.0 * v167) * (((Math.exp((v151 * v173)) * Math.pow((v172 / v154), (-0.5))) * (v179 - (((v63 * (v179 + 1.0)) * v172) * ((-Math.expm1((v152 * v173))) / v154)))) / v172));
        v194.push((weight * v193));
      }
      v194 = (math.fsum(v194) * 1.0);
      v195 = (v151 * v194);
      v208 = (v151 - ((Math.log(v195) * v195) / ((Math.exp(v177) / (v154 * v160)) + ((v195 - 1.0) * ((v85 / v160) - (1.0 / v154))))));
      v209 = ((-2.0) * v208);
      v211 = (-Math.expm1(v209));
      v216 = (v37 - (v7 * Math.exp(((-2.0) * (((v208 < 300.0) || (v208 !== v208)) ? v208 : 300.0)))));
      v217 = (((v216 > 1.0) || (v216 !== v216)) ? v216 : 1.0);
      v219 = (1.0 / (v41 * v208));
      v234 = (v8 * v208);
      v251 = [];
      for ([node, weight] of RULE_0((1.0 / v219))) {
        v220 = (node * 1.0);
        v222 = ((v220 * v220) * v220);
        v224 = ((v222 * v222) * v220);
        v226 = (v224 * v220);
        v229 = (-Math.expm1((v209 * v226)));
        v230 = (1.0 - v226);
        v236 = Math.expm1((v234 * v226));
        v250 = ((8.0 * v224) * (((Math.exp((v208 * v230)) * Math.pow((v229 / v211), (-0.5))) * (v236 - (((v63 * (v236 + 1.0)) * v229) * ((-Math.expm1((v209 * v230))) / v211)))) / v229));
        v251.push((weight * v250));
      }
      v251 = (math.fsum(v251) * 1.0);
      v252 = (v208 * v251);
      v265 = (v208 - ((Math.log(v252) * v252) / ((Math.exp(v234) / (v211 * v217)) + ((v252 - 1.0) * ((v85 / v217) - (1.0 / v211))))));
      v266 = ((-2.0) * v265);
      v268 = (-Math.expm1(v266));
      v273 = (v37 - (v7 * Math.exp(((-2.0) * (((v265 < 300.0) || (v265 !== v265)) ? v265 : 300.0)))));
      v274 = (((v273 > 1.0) || (v273 !== v273)) ? v273 : 1.0);
      v276 = (1.0 / (v41 * v265));
      v291 = (v8 * v265);
      v308 = [];
      for ([node, weight] of RULE_0((1.0 / v276))) {
        v277 = (node * 1.0);
        v279 = ((v277 * v277) * v277);
        v281 = ((v279 * v279) * v277);
        v283 = (v281 * v277);
        v286 = (-Math.expm1((v266 * v283)));
        v287 = (1.0 - v283);
        v293 = Math.expm1((v291 * v283));
        v307 = ((8.0 * v281) * (((Math.exp((v265 * v287)) * Math.pow((v286 / v268), (-0.5))) * (v293 - (((v63 * (v293 + 1.0)) * v286) * ((-Math.expm1((v266 * v287))) / v268)))) / v286));
        v308.push((weight * v307));
      }
      v308 = (math.fsum(v308) * 1.0);
      v309 = (v265 * v308);
      v326 = (-Math.expm1(((-2.0) * (v265 - ((Math.log(v309) * v309) / ((Math.exp(v291) / (v268 * v274)) + ((v309 - 1.0) * ((v85 / v274) - (1.0 / v268)))))))));
    } else {
      v326 = 1.0;
    }
    v328 = ((n / 2.0) + 0.5);
    v330 = (v328 + 1.75);
    v334 = ((v328 + 0.5) * (v328 + 1.5));
    v347 = (1.0 / (v330 * v330));
    return (((((((3.5449077018110318 * E_star) * n) * h) * (v326 + 1.0)) * a) * ((((v328 < 1.0) ? ((v328 * (v328 + 1.0)) / v334) : (1.0 - ((v328 + 0.75) / v334))) * Math.sqrt(v330)) * (1.0 + (v347 * (((((((((((((0.01524698625788054 * v347) + 0.5334320651111477) * v347) + 2.250488865813539) * v347) + 2.8612106440066865) * v347) + 1.3794681629043655) * v347) + 0.2596058532893223) * v347) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v347) + 49.328555418276075) * v347) + 167.28648538571198) * v347) + 195.37226190335065) * v347) + 90.69722535867314) * v347) + 16.763212110504565) * v347) + 1.0)))))) / ((n + 1.0) * ((n * v326) - 1.0)));
  }
  return _minimum_force(a, h, n, E_star);
};

const minimum_force = (a, h, n, E_star) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (n > 1)))) {
    return NaN;
  }
  return _minimum_force_of_concave_power(a, h, n, E_star);
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

const _pull_off_depth_of_concave_power = (a, h, n, E_star, dgamma) => {
  let kappa;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  return ((((-Math.sqrt(Math.PI)) * h) * kappa) - hess_retraction(a, E_star, dgamma));
};

const _pull_off_depth = (a, h, n, E_star, dgamma) => {
  let v10, v14, v28, v8;
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v8 = ((n / 2.0) + 0.5);
    v10 = (v8 + 1.75);
    v14 = ((v8 + 0.5) * (v8 + 1.5));
    v28 = (1.0 / (v10 * v10));
    return ((((-1.7724538509055159) * h) * ((((v8 < 1.0) ? ((v8 * (v8 + 1.0)) / v14) : (1.0 - ((v8 + 0.75) / v14))) * Math.sqrt(v10)) * (1.0 + (v28 * (((((((((((((0.01524698625788054 * v28) + 0.5334320651111477) * v28) + 2.250488865813539) * v28) + 2.8612106440066865) * v28) + 1.3794681629043655) * v28) + 0.2596058532893223) * v28) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v28) + 49.328555418276075) * v28) + 167.28648538571198) * v28) + 195.37226190335065) * v28) + 90.69722535867314) * v28) + 16.763212110504565) * v28) + 1.0)))))) - (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))));
  }
  return _pull_off_depth_of_concave_power(a, h, n, E_star, dgamma);
};

const _pull_off_force_of_concave_power = (a, h, n, E_star, dgamma) => {
  let kappa;
  kappa = gamma_ratio(((n / 2) + (1 / 2)));
  return ((((-2) * a) * Math.sqrt(((((2 * Math.PI) * E_star) * dgamma) * a))) - (((((((2 * Math.sqrt(Math.PI)) * E_star) * n) * h) / (n + 1)) * a) * kappa));
};

const _pull_off_force = (a, h, n, E_star, dgamma) => {
  let v10, v14, v28, v8;
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30))) {
    v8 = ((n / 2.0) + 0.5);
    v10 = (v8 + 1.75);
    v14 = ((v8 + 0.5) * (v8 + 1.5));
    v28 = (1.0 / (v10 * v10));
    return ((((-2.0) * a) * Math.sqrt((((6.283185307179586 * E_star) * dgamma) * a))) - ((((((3.5449077018110318 * E_star) * n) * h) / (n + 1.0)) * a) * ((((v8 < 1.0) ? ((v8 * (v8 + 1.0)) / v14) : (1.0 - ((v8 + 0.75) / v14))) * Math.sqrt(v10)) * (1.0 + (v28 * (((((((((((((0.01524698625788054 * v28) + 0.5334320651111477) * v28) + 2.250488865813539) * v28) + 2.8612106440066865) * v28) + 1.3794681629043655) * v28) + 0.2596058532893223) * v28) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v28) + 49.328555418276075) * v28) + 167.28648538571198) * v28) + 195.37226190335065) * v28) + 90.69722535867314) * v28) + 16.763212110504565) * v28) + 1.0)))))));
  }
  return _pull_off_force_of_concave_power(a, h, n, E_star, dgamma);
};

const PullOff = (radius, force, depth) => math.record({ radius, force, depth });

const pull_off = (control = 'force', a, h, n, E_star, dgamma) => {
  let depth, force;
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity) && (n > 1)))) {
    return NaN;
  }
  depth = _pull_off_depth(a, h, n, E_star, dgamma);
  force = _pull_off_force(a, h, n, E_star, dgamma);
  return PullOff(((depth * 0.0) + a), force, depth);
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

const RULE_0_of_ring = math.rule([[3.0, 32], [20.0, 64], [Infinity, 128]]);

const lifted_at_zero_pressure = (n, k) => {
  let node, v10, v103, v104, v105, v106, v112, v121, v122, v124, v129, v130, v131, v133, v134, v136, v138, v140, v143, v144, v148, v150, v16, v164, v165, v166, v180, v181, v183, v188, v189, v190, v192, v193, v195, v197, v199, v202, v203, v207, v209, v223, v224, v225, v239, v240, v242, v247, v248, v249, v251, v252, v254, v256, v258, v261, v262, v266, v268, v28, v282, v283, v284, v298, v299, v3, v301, v306, v307, v308, v310, v311, v313, v315, v317, v320, v321, v325, v327, v341, v342, v343, v357, v360, v362, v365, v367, v368, v370, v372, v374, v376, v386, v387, v41, v48, v5, v50, v52, v54, v6, v60, v62, v63, v64, v65, v67, v68, v70, v72, v75, v78, v79, v8, v83, v85, v87, v9, v98, weight;
  v6 = (n > 2.0);
  v365 = (n - 1.0);
  if (v6) {
    v3 = (1.0 + k);
    v5 = (v3 / 2.0);
    v8 = (math.truth(v6) ? n : 3.0);
    v9 = (v8 - 2.0);
    v10 = (1.0 - k);
    v16 = ((1.2732395447351628 * Math.sin((1.5707963267948966 * v10))) / v3);
    v28 = (0.36 + (0.4 * k));
    v41 = (math.log1p(((v16 + (((((2.0 * Math.expm1((((-0.5) * v10) * math.log((v10 / 4.0))))) - v16) * (1.0 + v28)) * v9) / (v9 + (2.0 * (((v28 > 0.0) || (v28 !== v28)) ? v28 : 0.0))))) / v9)) / v10);
    if ((v9 < 2.0)) {
      v48 = (math.log(((v9 * (v9 + 2.0)) / (2.0 * v10))) / v9);
      v50 = (((v41 > v48) || (v41 !== v41)) ? v41 : v48);
    } else {
      v50 = v41;
    }
    v52 = ((-2.0) * v50);
    v54 = (-Math.expm1(v52));
    v60 = ((v8 - 1.0) + k);
    v62 = (v60 - (v8 * Math.exp(((-2.0) * (((v50 < 300.0) || (v50 !== v50)) ? v50 : 300.0)))));
    v63 = (((v62 > v3) || (v62 !== v62)) ? v62 : v3);
    v64 = (v10 * v50);
    v65 = (v9 + 1.0);
    v67 = (1.0 / (v65 * v50));
    v83 = (v9 * v50);
    v87 = (0.5 * v9);
    v98 = ((k - 1.0) / 2.0);
    v104 = [];
    for ([node, weight] of RULE_0_of_ring((1.0 / v67))) {
      v68 = (node * 1.0);
      v70 = ((v68 * v68) * v68);
      v72 = ((v70 * v70) * v68);
      v75 = (v72 * v68);
      v78 = (-Math.expm1((v52 * v75)));
      v79 = (1.0 - v75);
      v85 = Math.expm1((v83 * v75));
      v103 = ((8.0 * v72) * (((Math.exp((v64 * v79)) * Math.pow((v78 / v54), v98)) * (v85 - (((v87 * (v85 + 1.0)) * v78) * ((-Math.expm1((v52 * v79))) / v54)))) / v78));
      v104.push((weight * v103));
    }
    v104 = (math.fsum(v104) * 1.0);
    v105 = (v64 * v104);
    v106 = (v10 * v3);
    v112 = (2.0 * v60);
    v121 = (v50 - ((math.log(v105) * v105) / (((v106 * Math.exp(v83)) / (v54 * v63)) + ((v105 - 1.0) * ((v112 / v63) - (v3 / v54))))));
    v122 = ((-2.0) * v121);
    v124 = (-Math.expm1(v122));
    v129 = (v60 - (v8 * Math.exp(((-2.0) * (((v121 < 300.0) || (v121 !== v121)) ? v121 : 300.0)))));
    v130 = (((v129 > v3) || (v129 !== v129)) ? v129 : v3);
    v131 = (v10 * v121);
    v133 = (1.0 / (v65 * v121));
    v148 = (v9 * v121);
    v165 = [];
    for ([node, weight] of RULE_0_of_ring((1.0 / v133))) {
      v134 = (node * 1.0);
      v136 = ((v134 * v134) * v134);
      v138 = ((v136 * v136) * v134);
      v140 = (v138 * v134);
      v143 = (-Math.expm1((v122 * v140)));
      v144 = (1.0 - v140);
      v150 = Math.expm1((v148 * v140));
      v164 = ((8.0 * v138) * (((Math.exp((v131 * v144)) * Math.pow((v143 / v124), v98)) * (v150 - (((v87 * (v150 + 1.0)) * v143) * ((-Math.expm1((v122 * v144))) / v124)))) / v143));
      v165.push((weight * v164));
    }
    v165 = (math.fsum(v165) * 1.0);
    v166 = (v131 * v165);
    v180 = (v121 - ((math.log(v166) * v166) / (((v106 * Math.exp(v148)) / (v124 * v130)) + ((v166 - 1.0) * ((v112 / v130) - (v3 / v124))))));
    v181 = ((-2.0) * v180);
    v183 = (-Math.expm1(v181));
    v188 = (v60 - (v8 * Math.exp(((-2.0) * (((v180 < 300.0) || (v180 !== v180)) ? v180 : 300.0)))));
    v189 = (((v188 > v3) || (v188 !== v188)) ? v188 : v3);
    v190 = (v10 * v180);
    v192 = (1.0 / (v65 * v180));
    v207 = (v9 * v180);
    v224 = [];
    for ([node, weight] of RULE_0_of_ring((1.0 / v192))) {
      v193 = (node * 1.0);
      v195 = ((v193 * v193) * v193);
      v197 = ((v195 * v195) * v193);
      v199 = (v197 * v193);
      v202 = (-Math.expm1((v181 * v199)));
      v203 = (1.0 - v199);
      v209 = Math.expm1((v207 * v199));
      v223 = ((8.0 * v197) * (((Math.exp((v190 * v203)) * Math.pow((v202 / v183), v98)) * (v209 - (((v87 * (v209 + 1.0)) * v202) * ((-Math.expm1((v181 * v203))) / v183)))) / v202));
      v224.push((weight * v223));
    }
    v224 = (math.fsum(v224) * 1.0);
    v225 = (v190 * v224);
    v239 = (v180 - ((math.log(v225) * v225) / (((v106 * Math.exp(v207)) / (v183 * v189)) + ((v225 - 1.0) * ((v112 / v189) - (v3 / v183))))));
    v240 = ((-2.0) * v239);
    v242 = (-Math.expm1(v240));
    v247 = (v60 - (v8 * Math.exp(((-2.0) * (((v239 < 300.0) || (v239 !== v239)) ? v239 : 300.0)))));
    v248 = (((v247 > v3) || (v247 !== v247)) ? v247 : v3);
    v249 = (v10 * v239);
    v251 = (1.0 / (v65 * v239));
    v266 = (v9 * v239);
    v283 = [];
    for ([node, weight] of RULE_0_of_ring((1.0 / v251))) {
      v252 = (node * 1.0);
      v254 = ((v252 * v252) * v252);
      v256 = ((v254 * v254) * v252);
      v258 = (v256 * v252);
      v261 = (-Math.expm1((v240 * v258)));
      v262 = (1.0 - v258);
      v268 = Math.expm1((v266 * v258));
      v282 = ((8.0 * v256) * (((Math.exp((v249 * v262)) * Math.pow((v261 / v242), v98)) * (v268 - (((v87 * (v268 + 1.0)) * v261) * ((-Math.expm1((v240 * v262))) / v242)))) / v261));
      v283.push((weight * v282));
    }
    v283 = (math.fsum(v283) * 1.0);
    v284 = (v249 * v283);
    v298 = (v239 - ((math.log(v284) * v284) / (((v106 * Math.exp(v266)) / (v242 * v248)) + ((v284 - 1.0) * ((v112 / v248) - (v3 / v242))))));
    v299 = ((-2.0) * v298);
    v301 = (-Math.expm1(v299));
    v306 = (v60 - (v8 * Math.exp(((-2.0) * (((v298 < 300.0) || (v298 !== v298)) ? v298 : 300.0)))));
    v307 = (((v306 > v3) || (v306 !== v306)) ? v306 : v3);
    v308 = (v10 * v298);
    v310 = (1.0 / (v65 * v298));
    v325 = (v9 * v298);
    v342 = [];
    for ([node, weight] of RULE_0_of_ring((1.0 / v310))) {
      v311 = (node * 1.0);
      v313 = ((v311 * v311) * v311);
      v315 = ((v313 * v313) * v311);
      v317 = (v315 * v311);
      v320 = (-Math.expm1((v299 * v317)));
      v321 = (1.0 - v317);
      v327 = Math.expm1((v325 * v317));
      v341 = ((8.0 * v315) * (((Math.exp((v308 * v321)) * Math.pow((v320 / v301), v98)) * (v327 - (((v87 * (v327 + 1.0)) * v320) * ((-Math.expm1((v299 * v321))) / v301)))) / v320));
      v342.push((weight * v341));
    }
    v342 = (math.fsum(v342) * 1.0);
    v343 = (v308 * v342);
    v357 = (v298 - ((math.log(v343) * v343) / (((v106 * Math.exp(v325)) / (v301 * v307)) + ((v343 - 1.0) * ((v112 / v307) - (v3 / v301))))));
    v360 = ((-2.0) * v357);
    v362 = (-Math.expm1(v360));
    v367 = (1.0 / (v365 * v357));
    v376 = ((-((n - 3.0) + k)) * v357);
    v387 = [];
    for ([node, weight] of RULE_0_of_ring((1.0 / v367))) {
      v368 = (node * 1.0);
      v370 = ((v368 * v368) * v368);
      v372 = ((v370 * v370) * v368);
      v374 = (v372 * v368);
      v386 = ((8.0 * v372) * (Math.exp((v376 * (1.0 - v374))) * Math.pow(((-Math.expm1((v360 * v374))) / v362), v5)));
      v387.push((weight * v386));
    }
    v387 = (math.fsum(v387) * 1.0);
    return ((n * v3) / ((n - 2.0) * (1.0 - (((n - 4.0) * v357) * v387))));
  }
  return (v365 + k);
};

const _minimum_depth_2 = (a, h, n, k) => {
  return ((((h * power_factor(n, k)) * (1.0 - k)) / lifted_at_zero_pressure(n, k)) + (0.0 * a));
};

const punch_stiffness = (a, H, k) => {
  return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
};

const _force_2 = (d, a, h, n, H, k) => {
  let complete;
  complete = ((_minimum_depth_2(a, h, n, k) * (1.0 - 1e-15)) <= d);
  return (math.truth(complete) ? (punch_stiffness(a, H, k) * (d + (((h * power_factor(n, k)) * (1.0 + k)) / ((n + 1.0) + k)))) : NaN);
};

const force_of_concave_power = (d, a, h, n, H, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > (1.0 - math.asarray(k))))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_2(d, a, h, n, H, k) : NaN);
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

const _pressure_2 = (r, d, a, h, n, H, k) => {
  let complete, edge, hollow;
  complete = ((_minimum_depth_2(a, h, n, k) * (1.0 - 1e-15)) <= d);
  edge = ((d + (h * power_factor(n, k))) * punch_pressure(r, a, H, k));
  hollow = ((((H / Math.PI) * h) * power_pressure_of_pressure(math.minimum(r, a), a, n, k)) / Math.pow(a, n));
  return (math.truth(complete) ? ((r < a) ? (edge - hollow) : edge) : NaN);
};

const pressure_of_concave_power = (r, d, a, h, n, H, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > (1.0 - math.asarray(k))))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _pressure_2(r, d, a, h, n, H, k) : 0.0) : NaN);
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

const _displacement_2 = (r, d, a, h, n, k) => {
  let complete, outside, value;
  complete = ((_minimum_depth_2(a, h, n, k) * (1.0 - 1e-15)) <= d);
  outside = () => {
    return ((d * punch_share(r, a, k)) + ((h * power_sag(r, a, n, k)) / Math.pow(a, n)));
  };
  value = either((r > a), outside, (() => (d - _profile(r, a, h, n))));
  return (math.truth(complete) ? value : NaN);
};

const displacement_of_concave_power = (r, d, a, h, n, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > (1.0 - math.asarray(k))))) {
    return NaN;
  }
  return (((r >= 0.0) && (d >= 0.0)) ? ((r < Infinity) ? _displacement_2(r, d, a, h, n, k) : 0.0) : NaN);
};

const _stiffness_3 = (a, H, k) => {
  return punch_stiffness(a, H, k);
};

const _stiffness_2 = (a, H, k, h = 1.0, n = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (H > 1e-30) && (H < 1e+30) && (k > 1e-30) && (k < 1.0) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30))) {
    return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  }
  return _stiffness_3(a, H, k);
};

const stiffness_of_concave_power = (a, h, n, H, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > (1.0 - math.asarray(k))))) {
    return NaN;
  }
  return _stiffness_2(a, H, k);
};

const _minimum_force_2 = (a, h, n, H, k) => {
  return (punch_stiffness(a, H, k) * (_minimum_depth_2(a, h, n, k) + (((h * power_factor(n, k)) * (1.0 + k)) / ((n + 1.0) + k))));
};

const _depth_from_force_2 = (F, a, h, n, H, k) => {
  let complete;
  complete = ((_minimum_force_2(a, h, n, H, k) * (1.0 - 1e-15)) <= F);
  return (math.truth(complete) ? ((F / punch_stiffness(a, H, k)) - (((h * power_factor(n, k)) * (1.0 + k)) / ((n + 1.0) + k))) : NaN);
};

const depth_from_force_of_concave_power = (F, a, h, n, H, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > (1.0 - math.asarray(k))))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force_2(F, a, h, n, H, k) : NaN);
};

const RULE_0_of_concave_power = math.rule([[3.0, 32], [20.0, 64], [Infinity, 128]]);

const _zero_radius_3 = (a, h, n, k) => {
  return ((a * ring_of_zero_pressure(n, k)) + (0.0 * h));
};

const _zero_radius_2 = (a, h, n, k) => {
  let node, v10, v104, v105, v106, v107, v113, v122, v123, v125, v130, v131, v132, v134, v135, v137, v139, v141, v144, v145, v149, v151, v16, v165, v166, v167, v17, v181, v182, v184, v189, v190, v191, v193, v194, v196, v198, v200, v203, v204, v208, v210, v224, v225, v226, v240, v241, v243, v248, v249, v250, v252, v253, v255, v257, v259, v262, v263, v267, v269, v283, v284, v285, v29, v299, v300, v302, v307, v308, v309, v311, v312, v314, v316, v318, v321, v322, v326, v328, v342, v343, v344, v361, v42, v49, v5, v51, v53, v55, v61, v63, v64, v65, v66, v68, v69, v7, v71, v73, v76, v79, v8, v80, v84, v86, v88, v99, weight;
  if (((a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (k > 1e-30) && (k < 1.0))) {
    v5 = (n > 2.0);
    if (v5) {
      v7 = (math.truth(v5) ? n : 3.0);
      v8 = (v7 - 2.0);
      v10 = (1.0 - k);
      v16 = (1.0 + k);
      v17 = ((1.2732395447351628 * Math.sin((1.5707963267948966 * v10))) / v16);
      v29 = (0.36 + (0.4 * k));
      v42 = (Math.log1p(((v17 + (((((2.0 * Math.expm1((((-0.5) * v10) * Math.log((v10 / 4.0))))) - v17) * (1.0 + v29)) * v8) / (v8 + (2.0 * (((v29 > 0.0) || (v29 !== v29)) ? v29 : 0.0))))) / v8)) / v10);
      if ((v8 < 2.0)) {
        v49 = (Math.log(((v8 * (v8 + 2.0)) / (2.0 * v10))) / v8);
        v51 = (((v42 > v49) || (v42 !== v42)) ? v42 : v49);
      } else {
        v51 = v42;
      }
      v53 = ((-2.0) * v51);
      v55 = (-Math.expm1(v53));
      v61 = ((v7 - 1.0) + k);
      v63 = (v61 - (v7 * Math.exp(((-2.0) * (((v51 < 300.0) || (v51 !== v51)) ? v51 : 300.0)))));
      v64 = (((v63 > v16) || (v63 !== v63)) ? v63 : v16);
      v65 = (v10 * v51);
      v66 = (v8 + 1.0);
      v68 = (1.0 / (v66 * v51));
      v84 = (v8 * v51);
      v88 = (0.5 * v8);
      v99 = ((k - 1.0) / 2.0);
      v105 = [];
      for ([node, weight] of RULE_0_of_concave_power((1.0 / v68))) {
        v69 = (node * 1.0);
        v71 = ((v69 * v69) * v69);
        v73 = ((v71 * v71) * v69);
        v76 = (v73 * v69);
        v79 = (-Math.expm1((v53 * v76)));
        v80 = (1.0 - v76);
        v86 = Math.expm1((v84 * v76));
        v104 = ((8.0 * v73) * (((Math.exp((v65 * v80)) * Math.pow((v79 / v55), v99)) * (v86 - (((v88 * (v86 + 1.0)) * v79) * ((-Math.expm1((v53 * v80))) / v55)))) / v79));
        v105.push((weight * v104));
      }
      v105 = (math.fsum(v105) * 1.0);
      v106 = (v65 * v105);
      v107 = (v10 * v16);
      v113 = (2.0 * v61);
      v122 = (v51 - ((Math.log(v106) * v106) / (((v107 * Math.exp(v84)) / (v55 * v64)) + ((v106 - 1.0) * ((v113 / v64) - (v16 / v55))))));
      v123 = ((-2.0) * v122);
      v125 = (-Math.expm1(v123));
      v130 = (v61 - (v7 * Math.exp(((-2.0) * (((v122 < 300.0) || (v122 !== v122)) ? v122 : 300.0)))));
      v131 = (((v130 > v16) || (v130 !== v130)) ? v130 : v16);
      v132 = (v10 * v122);
      v134 = (1.0 / (v66 * v122));
      v149 = (v8 * v122);
      v166 = [];
      for ([node, weight] of RULE_0_of_concave_power((1.0 / v134))) {
        v135 = (node * 1.0);
        v137 = ((v135 * v135) * v135);
        v139 = ((v137 * v137) * v135);
        v141 = (v139 * v135);
        v144 = (-Math.expm1((v123 * v141)));
        v145 = (1.0 - v141);
        v151 = Math.expm1((v149 * v141));
        v165 = ((8.0 * v139) * (((Math.exp((v132 * v145)) * Math.pow((v144 / v125), v99)) * (v151 - (((v88 * (v151 + 1.0)) * v144) * ((-Math.expm1((v123 * v145))) / v125)))) / v144));
        v166.push((weight * v165));
      }
      v166 = (math.fsum(v166) * 1.0);
      v167 = (v132 * v166);
      v181 = (v122 - ((Math.log(v167) * v167) / (((v107 * Math.exp(v149)) / (v125 * v131)) + ((v167 - 1.0) * ((v113 / v131) - (v16 / v125))))));
      v182 = ((-2.0) * v181);
      v184 = (-Math.expm1(v182));
      v189 = (v61 - (v7 * Math.exp(((-2.0) * (((v181 < 300.0) || (v181 !== v181)) ? v181 : 300.0)))));
      v190 = (((v189 > v16) || (v189 !== v189)) ? v189 : v16);
      v191 = (v10 * v181);
      v193 = (1.0 / (v66 * v181));
      v208 = (v8 * v181);
      v225 = [];
      for ([node, weight] of RULE_0_of_concave_power((1.0 / v193))) {
        v194 = (node * 1.0);
        v196 = ((v194 * v194) * v194);
        v198 = ((v196 * v196) * v194);
        v200 = (v198 * v194);
        v203 = (-Math.expm1((v182 * v200)));
        v204 = (1.0 - v200);
        v210 = Math.expm1((v208 * v200));
        v224 = ((8.0 * v198) * (((Math.exp((v191 * v204)) * Math.pow((v203 / v184), v99)) * (v210 - (((v88 * (v210 + 1.0)) * v203) * ((-Math.expm1((v182 * v204))) / v184)))) / v203));
        v225.push((weight * v224));
      }
      v225 = (math.fsum(v225) * 1.0);
      v226 = (v191 * v225);
      v240 = (v181 - ((Math.log(v226) * v226) / (((v107 * Math.exp(v208)) / (v184 * v190)) + ((v226 - 1.0) * ((v113 / v190) - (v16 / v184))))));
      v241 = ((-2.0) * v240);
      v243 = (-Math.expm1(v241));
      v248 = (v61 - (v7 * Math.exp(((-2.0) * (((v240 < 300.0) || (v240 !== v240)) ? v240 : 300.0)))));
      v249 = (((v248 > v16) || (v248 !== v248)) ? v248 : v16);
      v250 = (v10 * v240);
      v252 = (1.0 / (v66 * v240));
      v267 = (v8 * v240);
      v284 = [];
      for ([node, weight] of RULE_0_of_concave_power((1.0 / v252))) {
        v253 = (node * 1.0);
        v255 = ((v253 * v253) * v253);
        v257 = ((v255 * v255) * v253);
        v259 = (v257 * v253);
        v262 = (-Math.expm1((v241 * v259)));
        v263 = (1.0 - v259);
        v269 = Math.expm1((v267 * v259));
        v283 = ((8.0 * v257) * (((Math.exp((v250 * v263)) * Math.pow((v262 / v243), v99)) * (v269 - (((v88 * (v269 + 1.0)) * v262) * ((-Math.expm1((v241 * v263))) / v243)))) / v262));
        v284.push((weight * v283));
      }
      v284 = (math.fsum(v284) * 1.0);
      v285 = (v250 * v284);
      v299 = (v240 - ((Math.log(v285) * v285) / (((v107 * Math.exp(v267)) / (v243 * v249)) + ((v285 - 1.0) * ((v113 / v249) - (v16 / v243))))));
      v300 = ((-2.0) * v299);
      v302 = (-Math.expm1(v300));
      v307 = (v61 - (v7 * Math.exp(((-2.0) * (((v299 < 300.0) || (v299 !== v299)) ? v299 : 300.0)))));
      v308 = (((v307 > v16) || (v307 !== v307)) ? v307 : v16);
      v309 = (v10 * v299);
      v311 = (1.0 / (v66 * v299));
      v326 = (v8 * v299);
      v343 = [];
      for ([node, weight] of RULE_0_of_concave_power((1.0 / v311))) {
        v312 = (node * 1.0);
        v314 = ((v312 * v312) * v312);
        v316 = ((v314 * v314) * v312);
        v318 = (v316 * v312);
        v321 = (-Math.expm1((v300 * v318)));
        v322 = (1.0 - v318);
        v328 = Math.expm1((v326 * v318));
        v342 = ((8.0 * v316) * (((Math.exp((v309 * v322)) * Math.pow((v321 / v302), v99)) * (v328 - (((v88 * (v328 + 1.0)) * v321) * ((-Math.expm1((v300 * v322))) / v302)))) / v321));
        v343.push((weight * v342));
      }
      v343 = (math.fsum(v343) * 1.0);
      v344 = (v309 * v343);
      v361 = Math.exp((-(v299 - ((Math.log(v344) * v344) / (((v107 * Math.exp(v326)) / (v302 * v308)) + ((v344 - 1.0) * ((v113 / v308) - (v16 / v302))))))));
    } else {
      v361 = 0.0;
    }
    return ((a * v361) + (0.0 * h));
  }
  return _zero_radius_3(a, h, n, k);
};

const zero_radius_of_concave_power = (a, h, n, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > (1.0 - math.asarray(k))))) {
    return NaN;
  }
  return _zero_radius_2(a, h, n, k);
};

const minimum_depth_of_concave_power = (a, h, n, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > (1.0 - math.asarray(k))))) {
    return NaN;
  }
  return _minimum_depth_2(a, h, n, k);
};

const minimum_force_of_concave_power = (a, h, n, H, k) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > (1.0 - math.asarray(k))))) {
    return NaN;
  }
  return _minimum_force_2(a, h, n, H, k);
};

const graded_retraction = (a, H, k, dgamma) => {
  if ((a > 0.0)) {
    return ((math.sqrt(((6.283185307179586 * dgamma) / H)) * math.sqrt(a)) * math.sqrt(Math.pow(a, (-k))));
  }
  return 0.0;
};

const retraction_of_concave_power = (a, H, k, dgamma) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return graded_retraction(a, H, k, dgamma);
};

const _pull_off_depth_2 = (a, h, n, H, k, dgamma) => {
  return (((-h) * power_factor(n, k)) - graded_retraction(a, H, k, dgamma));
};

const _pull_off_force_2 = (a, h, n, H, k, dgamma) => {
  return ((-punch_stiffness(a, H, k)) * ((((h * power_factor(n, k)) * n) / ((n + 1.0) + k)) + graded_retraction(a, H, k, dgamma)));
};

const pull_off_of_concave_power = (control = 'force', a, h, n, H, k, dgamma) => {
  let depth, force;
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  if ((!(math.asarray(n) > (1.0 - math.asarray(k))))) {
    return NaN;
  }
  depth = _pull_off_depth_2(a, h, n, H, k, dgamma);
  force = _pull_off_force_2(a, h, n, H, k, dgamma);
  return PullOff(((depth * 0.0) + a), force, depth);
};

const RULE_0_2 = math.rule([[3.0, 32], [20.0, 64], [Infinity, 128]]);

const relaxation_maxwell = (t, E, tau) => {
  return (E * Math.exp(((-t) / tau)));
};

const _step_force_maxwell_of_concave_power = (t, d, a, h, n, E, tau) => {
  return (relaxation_maxwell(t, E, tau) * _force(d, a, h, n, 1.0));
};

const _step_force_maxwell = (t, d, a, h, n, E, tau) => {
  let node, v100, v107, v109, v110, v111, v113, v114, v116, v118, v121, v124, v125, v129, v131, v132, v14, v147, v148, v149, v154, v16, v163, v164, v166, v171, v172, v174, v175, v177, v179, v181, v184, v185, v189, v191, v20, v205, v206, v207, v220, v221, v223, v228, v229, v231, v232, v234, v236, v238, v241, v242, v246, v248, v262, v263, v264, v277, v278, v280, v285, v286, v288, v289, v291, v293, v295, v298, v299, v303, v305, v319, v320, v321, v334, v335, v337, v34, v342, v343, v345, v346, v348, v350, v352, v355, v356, v360, v362, v376, v377, v378, v395, v399, v75, v76, v78, v79, v88, v94, v96, v98, weight;
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E > 1e-30) && (E < 1e+30) && (tau > 1e-30) && (tau < 1e+30))) {
    v14 = ((n / 2.0) + 0.5);
    v16 = (v14 + 1.75);
    v20 = ((v14 + 0.5) * (v14 + 1.5));
    v34 = (1.0 / (v16 * v16));
    v75 = ((((v14 < 1.0) ? ((v14 * (v14 + 1.0)) / v20) : (1.0 - ((v14 + 0.75) / v20))) * Math.sqrt(v16)) * (1.0 + (v34 * (((((((((((((0.01524698625788054 * v34) + 0.5334320651111477) * v34) + 2.250488865813539) * v34) + 2.8612106440066865) * v34) + 1.3794681629043655) * v34) + 0.2596058532893223) * v34) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v34) + 49.328555418276075) * v34) + 167.28648538571198) * v34) + 195.37226190335065) * v34) + 90.69722535867314) * v34) + 16.763212110504565) * v34) + 1.0)))));
    v76 = (n > 2.0);
    if (v76) {
      v78 = (math.truth(v76) ? n : 3.0);
      v79 = (v78 - 2.0);
      v88 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v79) / (v79 + 0.72))) / v79));
      if ((v79 < 2.0)) {
        v94 = (Math.log(((v79 * (v79 + 2.0)) / 2.0)) / v79);
        v96 = (((v88 > v94) || (v88 !== v88)) ? v88 : v94);
      } else {
        v96 = v88;
      }
      v98 = ((-2.0) * v96);
      v100 = (-Math.expm1(v98));
      v107 = ((v78 - 1.0) + 0.0);
      v109 = (v107 - (v78 * Math.exp(((-2.0) * (((v96 < 300.0) || (v96 !== v96)) ? v96 : 300.0)))));
      v110 = (((v109 > 1.0) || (v109 !== v109)) ? v109 : 1.0);
      v111 = (v79 + 1.0);
      v113 = (1.0 / (v111 * v96));
      v129 = (v79 * v96);
      v132 = (0.5 * v79);
      v148 = [];
      for ([node, weight] of RULE_0_2((1.0 / v113))) {
        v114 = (node * 1.0);
        v116 = ((v114 * v114) * v114);
        v118 = ((v116 * v116) * v114);
        v121 = (v118 * v114);
        v124 = (-Math.expm1((v98 * v121)));
        v125 = (1.0 - v121);
        v131 = Math.expm1((v129 * v121));
        v147 = ((8.0 * v118) * (((Math.exp((v96 * v125)) * Math.pow((v124 / v100), (-0.5))) * (v131 - (((v132 * (v131 + 1.0)) * v124) * ((-Math.expm1((v98 * v125))) / v100)))) / v124));
        v148.push((weight * v147));
      }
      v148 = (math.fsum(v148) * 1.0);
      v149 = (v96 * v148);
      v154 = (2.0 * v107);
      v163 = (v96 - ((Math.log(v149) * v149) / ((Math.exp(v129) / (v100 * v110)) + ((v149 - 1.0) * ((v154 / v110) - (1.0 / v100))))));
      v164 = ((-2.0) * v163);
      v166 = (-Math.expm1(v164));
      v171 = (v107 - (v78 * Math.exp(((-2.0) * (((v163 < 300.0) || (v163 !== v163)) ? v163 : 300.0)))));
      v172 = (((v171 > 1.0) || (v171 !== v171)) ? v171 : 1.0);
      v174 = (1.0 / (v111 * v163));
      v189 = (v79 * v163);
      v206 = [];
      for ([node, weight] of RULE_0_2((1.0 / v174))) {
        v175 = (node * 1.0);
        v177 = ((v175 * v175) * v175);
        v179 = ((v177 * v177) * v175);
        v181 = (v179 * v175);
        v184 = (-Math.expm1((v164 * v181)));
        v185 = (1.0 - v181);
        v191 = Math.expm1((v189 * v181));
        v205 = ((8.0 * v179) * (((Math.exp((v163 * v185)) * Math.pow((v184 / v166), (-0.5))) * (v191 - (((v132 * (v191 + 1.0)) * v184) * ((-Math.expm1((v164 * v185))) / v166)))) / v184));
        v206.push((weight * v205));
      }
      v206 = (math.fsum(v206) * 1.0);
      v207 = (v163 * v206);
      v220 = (v163 - ((Math.log(v207) * v207) / ((Math.exp(v189) / (v166 * v172)) + ((v207 - 1.0) * ((v154 / v172) - (1.0 / v166))))));
      v221 = ((-2.0) * v220);
      v223 = (-Math.expm1(v221));
      v228 = (v107 - (v78 * Math.exp(((-2.0) * (((v220 < 300.0) || (v220 !== v220)) ? v220 : 300.0)))));
      v229 = (((v228 > 1.0) || (v228 !== v228)) ? v228 : 1.0);
      v231 = (1.0 / (v111 * v220));
      v246 = (v79 * v220);
      v263 = [];
      for ([node, weight] of RULE_0_2((1.0 / v231))) {
        v232 = (node * 1.0);
        v234 = ((v232 * v232) * v232);
        v236 = ((v234 * v234) * v232);
        v238 = (v236 * v232);
        v241 = (-Math.expm1((v221 * v238)));
        v242 = (1.0 - v238);
        v248 = Math.expm1((v246 * v238));
        v262 = ((8.0 * v236) * (((Math.exp((v220 * v242)) * Math.pow((v241 / v223), (-0.5))) * (v248 - (((v132 * (v248 + 1.0)) * v241) * ((-Math.expm1((v221 * v242))) / v223)))) / v241));
        v263.push((weight * v262));
      }
      v263 = (math.fsum(v263) * 1.0);
      v264 = (v220 * v263);
      v277 = (v220 - ((Math.log(v264) * v264) / ((Math.exp(v246) / (v223 * v229)) + ((v264 - 1.0) * ((v154 / v229) - (1.0 / v223))))));
      v278 = ((-2.0) * v277);
      v280 = (-Math.expm1(v278));
      v285 = (v107 - (v78 * Math.exp(((-2.0) * (((v277 < 300.0) || (v277 !== v277)) ? v277 : 300.0)))));
      v286 = (((v285 > 1.0) || (v285 !== v285)) ? v285 : 1.0);
      v288 = (1.0 / (v111 * v277));
      v303 = (v79 * v277);
      v320 = [];
      for ([node, weight] of RULE_0_2((1.0 / v288))) {
        v289 = (node * 1.0);
        v291 = ((v289 * v289) * v289);
        v293 = ((v291 * v291) * v289);
        v295 = (v293 * v289);
        v298 = (-Math.expm1((v278 * v295)));
        v299 = (1.0 - v295);
        v305 = Math.expm1((v303 * v295));
        v319 = ((8.0 * v293) * (((Math.exp((v277 * v299)) * Math.pow((v298 / v280), (-0.5))) * (v305 - (((v132 * (v305 + 1.0)) * v298) * ((-Math.expm1((v278 * v299))) / v280)))) / v298));
        v320.push((weight * v319));
      }
      v320 = (math.fsum(v320) * 1.0);
      v321 = (v277 * v320);
      v334 = (v277 - ((Math.log(v321) * v321) / ((Math.exp(v303) / (v280 * v286)) + ((v321 - 1.0) * ((v154 / v286) - (1.0 / v280))))));
      v335 = ((-2.0) * v334);
      v337 = (-Math.expm1(v335));
      v342 = (v107 - (v78 * Math.exp(((-2.0) * (((v334 < 300.0) || (v334 !== v334)) ? v334 : 300.0)))));
      v343 = (((v342 > 1.0) || (v342 !== v342)) ? v342 : 1.0);
      v345 = (1.0 / (v111 * v334));
      v360 = (v79 * v334);
      v377 = [];
      for ([node, weight] of RULE_0_2((1.0 / v345))) {
        v346 = (node * 1.0);
        v348 = ((v346 * v346) * v346);
        v350 = ((v348 * v348) * v346);
        v352 = (v350 * v346);
        v355 = (-Math.expm1((v335 * v352)));
        v356 = (1.0 - v352);
        v362 = Math.expm1((v360 * v352));
        v376 = ((8.0 * v350) * (((Math.exp((v334 * v356)) * Math.pow((v355 / v337), (-0.5))) * (v362 - (((v132 * (v362 + 1.0)) * v355) * ((-Math.expm1((v335 * v356))) / v337)))) / v355));
        v377.push((weight * v376));
      }
      v377 = (math.fsum(v377) * 1.0);
      v378 = (v334 * v377);
      v395 = (-Math.expm1(((-2.0) * (v334 - ((Math.log(v378) * v378) / ((Math.exp(v360) / (v337 * v343)) + ((v378 - 1.0) * ((v154 / v343) - (1.0 / v337)))))))));
    } else {
      v395 = 1.0;
    }
    v399 = (1.7724538509055159 * h);
    return ((E * Math.exp(((-t) / tau))) * (((((v399 * v75) / ((n * v395) - 1.0)) * 0.999999999999999) <= d) ? ((2.0 * a) * (d + ((v399 / (n + 1.0)) * v75))) : NaN));
  }
  return _step_force_maxwell_of_concave_power(t, d, a, h, n, E, tau);
};

const step_force_maxwell = (t, d, a, h, n, E, tau) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 <= d && d < Infinity) && (0.0 < E && E < Infinity) && (0.0 < tau && tau < Infinity) && (n > 1)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_maxwell(t, d, a, h, n, E, tau) : NaN);
};

const relaxation_kelvin_voigt = (t, E, eta) => {
  if ((t > 0.0)) {
    return E;
  }
  return Infinity;
};

const _step_force_kelvin_voigt_of_concave_power = (t, d, a, h, n, E, eta) => {
  return (relaxation_kelvin_voigt(t, E, eta) * _force(d, a, h, n, 1.0));
};

const _step_force_kelvin_voigt = (t, d, a, h, n, E, eta) => {
  let node, v100, v106, v108, v109, v110, v112, v113, v115, v117, v120, v123, v124, v128, v130, v131, v14, v146, v147, v148, v153, v16, v162, v163, v165, v170, v171, v173, v174, v176, v178, v180, v183, v184, v188, v190, v20, v204, v205, v206, v219, v220, v222, v227, v228, v230, v231, v233, v235, v237, v240, v241, v245, v247, v261, v262, v263, v276, v277, v279, v284, v285, v287, v288, v290, v292, v294, v297, v298, v302, v304, v318, v319, v320, v333, v334, v336, v34, v341, v342, v344, v345, v347, v349, v351, v354, v355, v359, v361, v375, v376, v377, v394, v398, v75, v76, v78, v79, v88, v94, v96, v98, weight;
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E > 1e-30) && (E < 1e+30) && (eta > 1e-30) && (eta < 1e+30))) {
    v14 = ((n / 2.0) + 0.5);
    v16 = (v14 + 1.75);
    v20 = ((v14 + 0.5) * (v14 + 1.5));
    v34 = (1.0 / (v16 * v16));
    v75 = ((((v14 < 1.0) ? ((v14 * (v14 + 1.0)) / v20) : (1.0 - ((v14 + 0.75) / v20))) * Math.sqrt(v16)) * (1.0 + (v34 * (((((((((((((0.01524698625788054 * v34) + 0.5334320651111477) * v34) + 2.250488865813539) * v34) + 2.8612106440066865) * v34) + 1.3794681629043655) * v34) + 0.2596058532893223) * v34) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v34) + 49.328555418276075) * v34) + 167.28648538571198) * v34) + 195.37226190335065) * v34) + 90.69722535867314) * v34) + 16.763212110504565) * v34) + 1.0)))));
    v76 = (n > 2.0);
    if (v76) {
      v78 = (math.truth(v76) ? n : 3.0);
      v79 = (v78 - 2.0);
      v88 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v79) / (v79 + 0.72))) / v79));
      if ((v79 < 2.0)) {
        v94 = (Math.log(((v79 * (v79 + 2.0)) / 2.0)) / v79);
        v96 = (((v88 > v94) || (v88 !== v88)) ? v88 : v94);
      } else {
        v96 = v88;
      }
      v98 = ((-2.0) * v96);
      v100 = (-Math.expm1(v98));
      v106 = ((v78 - 1.0) + 0.0);
      v108 = (v106 - (v78 * Math.exp(((-2.0) * (((v96 < 300.0) || (v96 !== v96)) ? v96 : 300.0)))));
      v109 = (((v108 > 1.0) || (v108 !== v108)) ? v108 : 1.0);
      v110 = (v79 + 1.0);
      v112 = (1.0 / (v110 * v96));
      v128 = (v79 * v96);
      v131 = (0.5 * v79);
      v147 = [];
      for ([node, weight] of RULE_0_2((1.0 / v112))) {
        v113 = (node * 1.0);
        v115 = ((v113 * v113) * v113);
        v117 = ((v115 * v115) * v113);
        v120 = (v117 * v113);
        v123 = (-Math.expm1((v98 * v120)));
        v124 = (1.0 - v120);
        v130 = Math.expm1((v128 * v120));
        v146 = ((8.0 * v117) * (((Math.exp((v96 * v124)) * Math.pow((v123 / v100), (-0.5))) * (v130 - (((v131 * (v130 + 1.0)) * v123) * ((-Math.expm1((v98 * v124))) / v100)))) / v123));
        v147.push((weight * v146));
      }
      v147 = (math.fsum(v147) * 1.0);
      v148 = (v96 * v147);
      v153 = (2.0 * v106);
      v162 = (v96 - ((Math.log(v148) * v148) / ((Math.exp(v128) / (v100 * v109)) + ((v148 - 1.0) * ((v153 / v109) - (1.0 / v100))))));
      v163 = ((-2.0) * v162);
      v165 = (-Math.expm1(v163));
      v170 = (v106 - (v78 * Math.exp(((-2.0) * (((v162 < 300.0) || (v162 !== v162)) ? v162 : 300.0)))));
      v171 = (((v170 > 1.0) || (v170 !== v170)) ? v170 : 1.0);
      v173 = (1.0 / (v110 * v162));
      v188 = (v79 * v162);
      v205 = [];
      for ([node, weight] of RULE_0_2((1.0 / v173))) {
        v174 = (node * 1.0);
        v176 = ((v174 * v174) * v174);
        v178 = ((v176 * v176) * v174);
        v180 = (v178 * v174);
        v183 = (-Math.expm1((v163 * v180)));
        v184 = (1.0 - v180);
        v190 = Math.expm1((v188 * v180));
        v204 = ((8.0 * v178) * (((Math.exp((v162 * v184)) * Math.pow((v183 / v165), (-0.5))) * (v190 - (((v131 * (v190 + 1.0)) * v183) * ((-Math.expm1((v163 * v184))) / v165)))) / v183));
        v205.push((weight * v204));
      }
      v205 = (math.fsum(v205) * 1.0);
      v206 = (v162 * v205);
      v219 = (v162 - ((Math.log(v206) * v206) / ((Math.exp(v188) / (v165 * v171)) + ((v206 - 1.0) * ((v153 / v171) - (1.0 / v165))))));
      v220 = ((-2.0) * v219);
      v222 = (-Math.expm1(v220));
      v227 = (v106 - (v78 * Math.exp(((-2.0) * (((v219 < 300.0) || (v219 !== v219)) ? v219 : 300.0)))));
      v228 = (((v227 > 1.0) || (v227 !== v227)) ? v227 : 1.0);
      v230 = (1.0 / (v110 * v219));
      v245 = (v79 * v219);
      v262 = [];
      for ([node, weight] of RULE_0_2((1.0 / v230))) {
        v231 = (node * 1.0);
        v233 = ((v231 * v231) * v231);
        v235 = ((v233 * v233) * v231);
        v237 = (v235 * v231);
        v240 = (-Math.expm1((v220 * v237)));
        v241 = (1.0 - v237);
        v247 = Math.expm1((v245 * v237));
        v261 = ((8.0 * v235) * (((Math.exp((v219 * v241)) * Math.pow((v240 / v222), (-0.5))) * (v247 - (((v131 * (v247 + 1.0)) * v240) * ((-Math.expm1((v220 * v241))) / v222)))) / v240));
        v262.push((weight * v261));
      }
      v262 = (math.fsum(v262) * 1.0);
      v263 = (v219 * v262);
      v276 = (v219 - ((Math.log(v263) * v263) / ((Math.exp(v245) / (v222 * v228)) + ((v263 - 1.0) * ((v153 / v228) - (1.0 / v222))))));
      v277 = ((-2.0) * v276);
      v279 = (-Math.expm1(v277));
      v284 = (v106 - (v78 * Math.exp(((-2.0) * (((v276 < 300.0) || (v276 !== v276)) ? v276 : 300.0)))));
      v285 = (((v284 > 1.0) || (v284 !== v284)) ? v284 : 1.0);
      v287 = (1.0 / (v110 * v276));
      v302 = (v79 * v276);
      v319 = [];
      for ([node, weight] of RULE_0_2((1.0 / v287))) {
        v288 = (node * 1.0);
        v290 = ((v288 * v288) * v288);
        v292 = ((v290 * v290) * v288);
        v294 = (v292 * v288);
        v297 = (-Math.expm1((v277 * v294)));
        v298 = (1.0 - v294);
        v304 = Math.expm1((v302 * v294));
        v318 = ((8.0 * v292) * (((Math.exp((v276 * v298)) * Math.pow((v297 / v279), (-0.5))) * (v304 - (((v131 * (v304 + 1.0)) * v297) * ((-Math.expm1((v277 * v298))) / v279)))) / v297));
        v319.push((weight * v318));
      }
      v319 = (math.fsum(v319) * 1.0);
      v320 = (v276 * v319);
      v333 = (v276 - ((Math.log(v320) * v320) / ((Math.exp(v302) / (v279 * v285)) + ((v320 - 1.0) * ((v153 / v285) - (1.0 / v279))))));
      v334 = ((-2.0) * v333);
      v336 = (-Math.expm1(v334));
      v341 = (v106 - (v78 * Math.exp(((-2.0) * (((v333 < 300.0) || (v333 !== v333)) ? v333 : 300.0)))));
      v342 = (((v341 > 1.0) || (v341 !== v341)) ? v341 : 1.0);
      v344 = (1.0 / (v110 * v333));
      v359 = (v79 * v333);
      v376 = [];
      for ([node, weight] of RULE_0_2((1.0 / v344))) {
        v345 = (node * 1.0);
        v347 = ((v345 * v345) * v345);
        v349 = ((v347 * v347) * v345);
        v351 = (v349 * v345);
        v354 = (-Math.expm1((v334 * v351)));
        v355 = (1.0 - v351);
        v361 = Math.expm1((v359 * v351));
        v375 = ((8.0 * v349) * (((Math.exp((v333 * v355)) * Math.pow((v354 / v336), (-0.5))) * (v361 - (((v131 * (v361 + 1.0)) * v354) * ((-Math.expm1((v334 * v355))) / v336)))) / v354));
        v376.push((weight * v375));
      }
      v376 = (math.fsum(v376) * 1.0);
      v377 = (v333 * v376);
      v394 = (-Math.expm1(((-2.0) * (v333 - ((Math.log(v377) * v377) / ((Math.exp(v359) / (v336 * v342)) + ((v377 - 1.0) * ((v153 / v342) - (1.0 / v336)))))))));
    } else {
      v394 = 1.0;
    }
    v398 = (1.7724538509055159 * h);
    return (((t > 0.0) ? E : Infinity) * (((((v398 * v75) / ((n * v394) - 1.0)) * 0.999999999999999) <= d) ? ((2.0 * a) * (d + ((v398 / (n + 1.0)) * v75))) : NaN));
  }
  return _step_force_kelvin_voigt_of_concave_power(t, d, a, h, n, E, eta);
};

const step_force_kelvin_voigt = (t, d, a, h, n, E, eta) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 <= d && d < Infinity) && (0.0 < E && E < Infinity) && (0.0 < eta && eta < Infinity) && (n > 1)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_kelvin_voigt(t, d, a, h, n, E, eta) : NaN);
};

const relaxation_standard_solid = (t, E_inf, E_1, tau) => {
  return (E_inf + (E_1 * Math.exp(((-t) / tau))));
};

const _step_force_standard_solid_of_concave_power = (t, d, a, h, n, E_inf, E_1, tau) => {
  return (relaxation_standard_solid(t, E_inf, E_1, tau) * _force(d, a, h, n, 1.0));
};

const _step_force_standard_solid = (t, d, a, h, n, E_inf, E_1, tau) => {
  let node, v100, v102, v109, v111, v112, v113, v115, v116, v118, v120, v123, v126, v127, v131, v133, v134, v149, v150, v151, v156, v16, v165, v166, v168, v173, v174, v176, v177, v179, v18, v181, v183, v186, v187, v191, v193, v207, v208, v209, v22, v222, v223, v225, v230, v231, v233, v234, v236, v238, v240, v243, v244, v248, v250, v264, v265, v266, v279, v280, v282, v287, v288, v290, v291, v293, v295, v297, v300, v301, v305, v307, v321, v322, v323, v336, v337, v339, v344, v345, v347, v348, v350, v352, v354, v357, v358, v36, v362, v364, v378, v379, v380, v397, v401, v77, v78, v80, v81, v90, v96, v98, weight;
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E_inf > 1e-30) && (E_inf < 1e+30) && (E_1 > 1e-30) && (E_1 < 1e+30) && (tau > 1e-30) && (tau < 1e+30))) {
    v16 = ((n / 2.0) + 0.5);
    v18 = (v16 + 1.75);
    v22 = ((v16 + 0.5) * (v16 + 1.5));
    v36 = (1.0 / (v18 * v18));
    v77 = ((((v16 < 1.0) ? ((v16 * (v16 + 1.0)) / v22) : (1.0 - ((v16 + 0.75) / v22))) * Math.sqrt(v18)) * (1.0 + (v36 * (((((((((((((0.01524698625788054 * v36) + 0.5334320651111477) * v36) + 2.250488865813539) * v36) + 2.8612106440066865) * v36) + 1.3794681629043655) * v36) + 0.2596058532893223) * v36) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v36) + 49.328555418276075) * v36) + 167.28648538571198) * v36) + 195.37226190335065) * v36) + 90.69722535867314) * v36) + 16.763212110504565) * v36) + 1.0)))));
    v78 = (n > 2.0);
    if (v78) {
      v80 = (math.truth(v78) ? n : 3.0);
      v81 = (v80 - 2.0);
      v90 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v81) / (v81 + 0.72))) / v81));
      if ((v81 < 2.0)) {
        v96 = (Math.log(((v81 * (v81 + 2.0)) / 2.0)) / v81);
        v98 = (((v90 > v96) || (v90 !== v90)) ? v90 : v96);
      } else {
        v98 = v90;
      }
      v100 = ((-2.0) * v98);
      v102 = (-Math.expm1(v100));
      v109 = ((v80 - 1.0) + 0.0);
      v111 = (v109 - (v80 * Math.exp(((-2.0) * (((v98 < 300.0) || (v98 !== v98)) ? v98 : 300.0)))));
      v112 = (((v111 > 1.0) || (v111 !== v111)) ? v111 : 1.0);
      v113 = (v81 + 1.0);
      v115 = (1.0 / (v113 * v98));
      v131 = (v81 * v98);
      v134 = (0.5 * v81);
      v150 = [];
      for ([node, weight] of RULE_0_2((1.0 / v115))) {
        v116 = (node * 1.0);
        v118 = ((v116 * v116) * v116);
        v120 = ((v118 * v118) * v116);
        v123 = (v120 * v116);
        v126 = (-Math.expm1((v100 * v123)));
        v127 = (1.0 - v123);
        v133 = Math.expm1((v131 * v123));
        v149 = ((8.0 * v120) * (((Math.exp((v98 * v127)) * Math.pow((v126 / v102), (-0.5))) * (v133 - (((v134 * (v133 + 1.0)) * v126) * ((-Math.expm1((v100 * v127))) / v102)))) / v126));
        v150.push((weight * v149));
      }
      v150 = (math.fsum(v150) * 1.0);
      v151 = (v98 * v150);
      v156 = (2.0 * v109);
      v165 = (v98 - ((Math.log(v151) * v151) / ((Math.exp(v131) / (v102 * v112)) + ((v151 - 1.0) * ((v156 / v112) - (1.0 / v102))))));
      v166 = ((-2.0) * v165);
      v168 = (-Math.expm1(v166));
      v173 = (v109 - (v80 * Math.exp(((-2.0) * (((v165 < 300.0) || (v165 !== v165)) ? v165 : 300.0)))));
      v174 = (((v173 > 1.0) || (v173 !== v173)) ? v173 : 1.0);
      v176 = (1.0 / (v113 * v165));
      v191 = (v81 * v165);
      v208 = [];
      for ([node, weight] of RULE_0_2((1.0 / v176))) {
        v177 = (node * 1.0);
        v179 = ((v177 * v177) * v177);
        v181 = ((v179 * v179) * v177);
        v183 = (v181 * v177);
        v186 = (-Math.expm1((v166 * v183)));
        v187 = (1.0 - v183);
        v193 = Math.expm1((v191 * v183));
        v207 = ((8.0 * v181) * (((Math.exp((v165 * v187)) * Math.pow((v186 / v168), (-0.5))) * (v193 - (((v134 * (v193 + 1.0)) * v186) * ((-Math.expm1((v166 * v187))) / v168)))) / v186));
        v208.push((weight * v207));
      }
      v208 = (math.fsum(v208) * 1.0);
      v209 = (v165 * v208);
      v222 = (v165 - ((Math.log(v209) * v209) / ((Math.exp(v191) / (v168 * v174)) + ((v209 - 1.0) * ((v156 / v174) - (1.0 / v168))))));
      v223 = ((-2.0) * v222);
      v225 = (-Math.expm1(v223));
      v230 = (v109 - (v80 * Math.exp(((-2.0) * (((v222 < 300.0) || (v222 !== v222)) ? v222 : 300.0)))));
      v231 = (((v230 > 1.0) || (v230 !== v230)) ? v230 : 1.0);
      v233 = (1.0 / (v113 * v222));
      v248 = (v81 * v222);
      v265 = [];
      for ([node, weight] of RULE_0_2((1.0 / v233))) {
        v234 = (node * 1.0);
        v236 = ((v234 * v234) * v234);
        v238 = ((v236 * v236) * v234);
        v240 = (v238 * v234);
        v243 = (-Math.expm1((v223 * v240)));
        v244 = (1.0 - v240);
        v250 = Math.expm1((v248 * v240));
        v264 = ((8.0 * v238) * (((Math.exp((v222 * v244)) * Math.pow((v243 / v225), (-0.5))) * (v250 - (((v134 * (v250 + 1.0)) * v243) * ((-Math.expm1((v223 * v244))) / v225)))) / v243));
        v265.push((weight * v264));
      }
      v265 = (math.fsum(v265) * 1.0);
      v266 = (v222 * v265);
      v279 = (v222 - ((Math.log(v266) * v266) / ((Math.exp(v248) / (v225 * v231)) + ((v266 - 1.0) * ((v156 / v231) - (1.0 / v225))))));
      v280 = ((-2.0) * v279);
      v282 = (-Math.expm1(v280));
      v287 = (v109 - (v80 * Math.exp(((-2.0) * (((v279 < 300.0) || (v279 !== v279)) ? v279 : 300.0)))));
      v288 = (((v287 > 1.0) || (v287 !== v287)) ? v287 : 1.0);
      v290 = (1.0 / (v113 * v279));
      v305 = (v81 * v279);
      v322 = [];
      for ([node, weight] of RULE_0_2((1.0 / v290))) {
        v291 = (node * 1.0);
        v293 = ((v291 * v291) * v291);
        v295 = ((v293 * v293) * v291);
        v297 = (v295 * v291);
        v300 = (-Math.expm1((v280 * v297)));
        v301 = (1.0 - v297);
        v307 = Math.expm1((v305 * v297));
        v321 = ((8.0 * v295) * (((Math.exp((v279 * v301)) * Math.pow((v300 / v282), (-0.5))) * (v307 - (((v134 * (v307 + 1.0)) * v300) * ((-Math.expm1((v280 * v301))) / v282)))) / v300));
        v322.push((weight * v321));
      }
      v322 = (math.fsum(v322) * 1.0);
      v323 = (v279 * v322);
      v336 = (v279 - ((Math.log(v323) * v323) / ((Math.exp(v305) / (v282 * v288)) + ((v323 - 1.0) * ((v156 / v288) - (1.0 / v282))))));
      v337 = ((-2.0) * v336);
      v339 = (-Math.expm1(v337));
      v344 = (v109 - (v80 * Math.exp(((-2.0) * (((v336 < 300.0) || (v336 !== v336)) ? v336 : 300.0)))));
      v345 = (((v344 > 1.0) || (v344 !== v344)) ? v344 : 1.0);
      v347 = (1.0 / (v113 * v336));
      v362 = (v81 * v336);
      v379 = [];
      for ([node, weight] of RULE_0_2((1.0 / v347))) {
        v348 = (node * 1.0);
        v350 = ((v348 * v348) * v348);
        v352 = ((v350 * v350) * v348);
        v354 = (v352 * v348);
        v357 = (-Math.expm1((v337 * v354)));
        v358 = (1.0 - v354);
        v364 = Math.expm1((v362 * v354));
        v378 = ((8.0 * v352) * (((Math.exp((v336 * v358)) * Math.pow((v357 / v339), (-0.5))) * (v364 - (((v134 * (v364 + 1.0)) * v357) * ((-Math.expm1((v337 * v358))) / v339)))) / v357));
        v379.push((weight * v378));
      }
      v379 = (math.fsum(v379) * 1.0);
      v380 = (v336 * v379);
      v397 = (-Math.expm1(((-2.0) * (v336 - ((Math.log(v380) * v380) / ((Math.exp(v362) / (v339 * v345)) + ((v380 - 1.0) * ((v156 / v345) - (1.0 / v339)))))))));
    } else {
      v397 = 1.0;
    }
    v401 = (1.7724538509055159 * h);
    return ((E_inf + (E_1 * Math.exp(((-t) / tau)))) * (((((v401 * v77) / ((n * v397) - 1.0)) * 0.999999999999999) <= d) ? ((2.0 * a) * (d + ((v401 / (n + 1.0)) * v77))) : NaN));
  }
  return _step_force_standard_solid_of_concave_power(t, d, a, h, n, E_inf, E_1, tau);
};

const step_force_standard_solid = (t, d, a, h, n, E_inf, E_1, tau) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 <= d && d < Infinity) && (0.0 < E_inf && E_inf < Infinity) && (0.0 <= E_1 && E_1 < Infinity) && (0.0 < tau && tau < Infinity) && (n > 1)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_standard_solid(t, d, a, h, n, E_inf, E_1, tau) : NaN);
};

const relaxation_power_creep = (t, E, alpha, t_0) => {
  let v8;
  v8 = (3.141592653589793 * alpha);
  return (((E * Math.pow((t_0 / t), alpha)) * Math.sin(v8)) / v8);
};

const _step_force_power_creep_of_concave_power = (t, d, a, h, n, E, alpha, t_0) => {
  return (relaxation_power_creep(t, E, alpha, t_0) * _force(d, a, h, n, 1.0));
};

const _step_force_power_creep = (t, d, a, h, n, E, alpha, t_0) => {
  let node, v101, v103, v105, v112, v114, v115, v116, v118, v119, v12, v121, v123, v126, v129, v130, v134, v136, v137, v152, v153, v154, v159, v168, v169, v171, v176, v177, v179, v180, v182, v184, v186, v189, v19, v190, v194, v196, v21, v210, v211, v212, v225, v226, v228, v233, v234, v236, v237, v239, v241, v243, v246, v247, v25, v251, v253, v267, v268, v269, v282, v283, v285, v290, v291, v293, v294, v296, v298, v300, v303, v304, v308, v310, v324, v325, v326, v339, v340, v342, v347, v348, v350, v351, v353, v355, v357, v360, v361, v365, v367, v381, v382, v383, v39, v400, v404, v80, v81, v83, v84, v93, v99, weight;
  if (((t > 1e-30) && (t < 1e+30) && (d > 1e-30) && (d < 1e+30) && (a > 1e-30) && (a < 1e+30) && (h > 1e-30) && (h < 1e+30) && (n > 1e-30) && (n < 1e+30) && (E > 1e-30) && (E < 1e+30) && (alpha > 1e-30) && (alpha < 1.0) && (t_0 > 1e-30) && (t_0 < 1e+30))) {
    v12 = (3.141592653589793 * alpha);
    v19 = ((n / 2.0) + 0.5);
    v21 = (v19 + 1.75);
    v25 = ((v19 + 0.5) * (v19 + 1.5));
    v39 = (1.0 / (v21 * v21));
    v80 = ((((v19 < 1.0) ? ((v19 * (v19 + 1.0)) / v25) : (1.0 - ((v19 + 0.75) / v25))) * Math.sqrt(v21)) * (1.0 + (v39 * (((((((((((((0.01524698625788054 * v39) + 0.5334320651111477) * v39) + 2.250488865813539) * v39) + 2.8612106440066865) * v39) + 1.3794681629043655) * v39) + 0.2596058532893223) * v39) + 0.015624999999999823) / ((((((((((((3.278794792785737 * v39) + 49.328555418276075) * v39) + 167.28648538571198) * v39) + 195.37226190335065) * v39) + 90.69722535867314) * v39) + 16.763212110504565) * v39) + 1.0)))));
    v81 = (n > 2.0);
    if (v81) {
      v83 = (math.truth(v81) ? n : 3.0);
      v84 = (v83 - 2.0);
      v93 = Math.log1p(((1.2732395447351628 + ((0.9883942191601786 * v84) / (v84 + 0.72))) / v84));
      if ((v84 < 2.0)) {
        v99 = (Math.log(((v84 * (v84 + 2.0)) / 2.0)) / v84);
        v101 = (((v93 > v99) || (v93 !== v93)) ? v93 : v99);
      } else {
        v101 = v93;
      }
      v103 = ((-2.0) * v101);
      v105 = (-Math.expm1(v103));
      v112 = ((v83 - 1.0) + 0.0);
      v114 = (v112 - (v83 * Math.exp(((-2.0) * (((v101 < 300.0) || (v101 !== v101)) ? v101 : 300.0)))));
      v115 = (((v114 > 1.0) || (v114 !== v114)) ? v114 : 1.0);
      v116 = (v84 + 1.0);
      v118 = (1.0 / (v116 * v101));
      v134 = (v84 * v101);
      v137 = (0.5 * v84);
      v153 = [];
      for ([node, weight] of RULE_0_2((1.0 / v118))) {
        v119 = (node * 1.0);
        v121 = ((v119 * v119) * v119);
        v123 = ((v121 * v121) * v119);
        v126 = (v123 * v119);
        v129 = (-Math.expm1((v103 * v126)));
        v130 = (1.0 - v126);
        v136 = Math.expm1((v134 * v126));
        v152 = ((8.0 * v123) * (((Math.exp((v101 * v130)) * Math.pow((v129 / v105), (-0.5))) * (v136 - (((v137 * (v136 + 1.0)) * v129) * ((-Math.expm1((v103 * v130))) / v105)))) / v129));
        v153.push((weight * v152));
      }
      v153 = (math.fsum(v153) * 1.0);
      v154 = (v101 * v153);
      v159 = (2.0 * v112);
      v168 = (v101 - ((Math.log(v154) * v154) / ((Math.exp(v134) / (v105 * v115)) + ((v154 - 1.0) * ((v159 / v115) - (1.0 / v105))))));
      v169 = ((-2.0) * v168);
      v171 = (-Math.expm1(v169));
      v176 = (v112 - (v83 * Math.exp(((-2.0) * (((v168 < 300.0) || (v168 !== v168)) ? v168 : 300.0)))));
      v177 = (((v176 > 1.0) || (v176 !== v176)) ? v176 : 1.0);
      v179 = (1.0 / (v116 * v168));
      v194 = (v84 * v168);
      v211 = [];
      for ([node, weight] of RULE_0_2((1.0 / v179))) {
        v180 = (node * 1.0);
        v182 = ((v180 * v180) * v180);
        v184 = ((v182 * v182) * v180);
        v186 = (v184 * v180);
        v189 = (-Math.expm1((v169 * v186)));
        v190 = (1.0 - v186);
        v196 = Math.expm1((v194 * v186));
        v210 = ((8.0 * v184) * (((Math.exp((v168 * v190)) * Math.pow((v189 / v171), (-0.5))) * (v196 - (((v137 * (v196 + 1.0)) * v189) * ((-Math.expm1((v169 * v190))) / v171)))) / v189));
        v211.push((weight * v210));
      }
      v211 = (math.fsum(v211) * 1.0);
      v212 = (v168 * v211);
      v225 = (v168 - ((Math.log(v212) * v212) / ((Math.exp(v194) / (v171 * v177)) + ((v212 - 1.0) * ((v159 / v177) - (1.0 / v171))))));
      v226 = ((-2.0) * v225);
      v228 = (-Math.expm1(v226));
      v233 = (v112 - (v83 * Math.exp(((-2.0) * (((v225 < 300.0) || (v225 !== v225)) ? v225 : 300.0)))));
      v234 = (((v233 > 1.0) || (v233 !== v233)) ? v233 : 1.0);
      v236 = (1.0 / (v116 * v225));
      v251 = (v84 * v225);
      v268 = [];
      for ([node, weight] of RULE_0_2((1.0 / v236))) {
        v237 = (node * 1.0);
        v239 = ((v237 * v237) * v237);
        v241 = ((v239 * v239) * v237);
        v243 = (v241 * v237);
        v246 = (-Math.expm1((v226 * v243)));
        v247 = (1.0 - v243);
        v253 = Math.expm1((v251 * v243));
        v267 = ((8.0 * v241) * (((Math.exp((v225 * v247)) * Math.pow((v246 / v228), (-0.5))) * (v253 - (((v137 * (v253 + 1.0)) * v246) * ((-Math.expm1((v226 * v247))) / v228)))) / v246));
        v268.push((weight * v267));
      }
      v268 = (math.fsum(v268) * 1.0);
      v269 = (v225 * v268);
      v282 = (v225 - ((Math.log(v269) * v269) / ((Math.exp(v251) / (v228 * v234)) + ((v269 - 1.0) * ((v159 / v234) - (1.0 / v228))))));
      v283 = ((-2.0) * v282);
      v285 = (-Math.expm1(v283));
      v290 = (v112 - (v83 * Math.exp(((-2.0) * (((v282 < 300.0) || (v282 !== v282)) ? v282 : 300.0)))));
      v291 = (((v290 > 1.0) || (v290 !== v290)) ? v290 : 1.0);
      v293 = (1.0 / (v116 * v282));
      v308 = (v84 * v282);
      v325 = [];
      for ([node, weight] of RULE_0_2((1.0 / v293))) {
        v294 = (node * 1.0);
        v296 = ((v294 * v294) * v294);
        v298 = ((v296 * v296) * v294);
        v300 = (v298 * v294);
        v303 = (-Math.expm1((v283 * v300)));
        v304 = (1.0 - v300);
        v310 = Math.expm1((v308 * v300));
        v324 = ((8.0 * v298) * (((Math.exp((v282 * v304)) * Math.pow((v303 / v285), (-0.5))) * (v310 - (((v137 * (v310 + 1.0)) * v303) * ((-Math.expm1((v283 * v304))) / v285)))) / v303));
        v325.push((weight * v324));
      }
      v325 = (math.fsum(v325) * 1.0);
      v326 = (v282 * v325);
      v339 = (v282 - ((Math.log(v326) * v326) / ((Math.exp(v308) / (v285 * v291)) + ((v326 - 1.0) * ((v159 / v291) - (1.0 / v285))))));
      v340 = ((-2.0) * v339);
      v342 = (-Math.expm1(v340));
      v347 = (v112 - (v83 * Math.exp(((-2.0) * (((v339 < 300.0) || (v339 !== v339)) ? v339 : 300.0)))));
      v348 = (((v347 > 1.0) || (v347 !== v347)) ? v347 : 1.0);
      v350 = (1.0 / (v116 * v339));
      v365 = (v84 * v339);
      v382 = [];
      for ([node, weight] of RULE_0_2((1.0 / v350))) {
        v351 = (node * 1.0);
        v353 = ((v351 * v351) * v351);
        v355 = ((v353 * v353) * v351);
        v357 = (v355 * v351);
        v360 = (-Math.expm1((v340 * v357)));
        v361 = (1.0 - v357);
        v367 = Math.expm1((v365 * v357));
        v381 = ((8.0 * v355) * (((Math.exp((v339 * v361)) * Math.pow((v360 / v342), (-0.5))) * (v367 - (((v137 * (v367 + 1.0)) * v360) * ((-Math.expm1((v340 * v361))) / v342)))) / v360));
        v382.push((weight * v381));
      }
      v382 = (math.fsum(v382) * 1.0);
      v383 = (v339 * v382);
      v400 = (-Math.expm1(((-2.0) * (v339 - ((Math.log(v383) * v383) / ((Math.exp(v365) / (v342 * v348)) + ((v383 - 1.0) * ((v159 / v348) - (1.0 / v342)))))))));
    } else {
      v400 = 1.0;
    }
    v404 = (1.7724538509055159 * h);
    return ((((E * Math.pow((t_0 / t), alpha)) * Math.sin(v12)) / v12) * (((((v404 * v80) / ((n * v400) - 1.0)) * 0.999999999999999) <= d) ? ((2.0 * a) * (d + ((v404 / (n + 1.0)) * v80))) : NaN));
  }
  return _step_force_power_creep_of_concave_power(t, d, a, h, n, E, alpha, t_0);
};

const step_force_power_creep = (t, d, a, h, n, E, alpha, t_0) => {
  if ((!((0.0 < a && a < Infinity) && (0.0 < h && h < Infinity) && (0.0 < n && n < Infinity) && (0.0 <= d && d < Infinity) && (0.0 < E && E < Infinity) && (0.0 < alpha && alpha < 1.0) && (0.0 < t_0 && t_0 < Infinity) && (n > 1)))) {
    return NaN;
  }
  return ((t >= 0.0) ? _step_force_power_creep(t, d, a, h, n, E, alpha, t_0) : NaN);
};

const once = { pull_off: math.kept(pull_off), pull_off_of_concave_power: math.kept(pull_off_of_concave_power) };
const formulas = {
  "U": (v) => energy(v.d, v.a, v.h, v.n, v.E_star),
  "Fr": (v) => load_within(v.r, v.d, v.a, v.h, v.n, v.E_star),
  "F": (v) => force(v.d, v.a, v.h, v.n, v.E_star),
  "p": (v) => pressure(v.r, v.d, v.a, v.h, v.n, v.E_star),
  "w": (v) => displacement(v.r, v.d, v.a, v.h, v.n),
  "k": (v) => stiffness(v.a, v.h, v.n, v.E_star),
  "dF": (v) => depth_from_force(v.F, v.a, v.h, v.n, v.E_star),
  "rz": (v) => zero_radius(v.a, v.h, v.n),
  "dmin": (v) => minimum_depth(v.a, v.h, v.n),
  "Fmin": (v) => minimum_force(v.a, v.h, v.n, v.E_star),
  "adh.Dl": (v) => retraction(v.a, v.E_star, v.dgamma),
  "adh.Fc": (v) => (once.pull_off('force', v.a, v.h, v.n, v.E_star, v.dgamma).force ?? NaN),
  "adh.dc": (v) => (once.pull_off('force', v.a, v.h, v.n, v.E_star, v.dgamma).depth ?? NaN),
  "fgm.F": (v) => force_of_concave_power(v.d, v.a, v.h, v.n, v.H, v.k),
  "fgm.p": (v) => pressure_of_concave_power(v.r, v.d, v.a, v.h, v.n, v.H, v.k),
  "fgm.w": (v) => displacement_of_concave_power(v.r, v.d, v.a, v.h, v.n, v.k),
  "fgm.k": (v) => stiffness_of_concave_power(v.a, v.h, v.n, v.H, v.k),
  "fgm.dF": (v) => depth_from_force_of_concave_power(v.F, v.a, v.h, v.n, v.H, v.k),
  "fgm.rz": (v) => zero_radius_of_concave_power(v.a, v.h, v.n, v.k),
  "fgm.dmin": (v) => minimum_depth_of_concave_power(v.a, v.h, v.n, v.k),
  "fgm.Fmin": (v) => minimum_force_of_concave_power(v.a, v.h, v.n, v.H, v.k),
  "fgm.adh.Dl": (v) => retraction_of_concave_power(v.a, v.H, v.k, v.dgamma),
  "fgm.adh.Fc": (v) => (once.pull_off_of_concave_power('force', v.a, v.h, v.n, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dc": (v) => (once.pull_off_of_concave_power('force', v.a, v.h, v.n, v.H, v.k, v.dgamma).depth ?? NaN),
  "vis.step_mx": (v) => step_force_maxwell(v.t, v.d, v.a, v.h, v.n, v.E_law, v.tau),
  "vis.step_kv": (v) => step_force_kelvin_voigt(v.t, v.d, v.a, v.h, v.n, v.E_law, v.eta),
  "vis.step_sls": (v) => step_force_standard_solid(v.t, v.d, v.a, v.h, v.n, v.E_inf, v.E_1, v.tau),
  "vis.step_pc": (v) => step_force_power_creep(v.t, v.d, v.a, v.h, v.n, v.E_law, v.alpha, v.t_0),
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
    "d",
    "a",
    "h",
    "n",
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
    "d",
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
  "w": {
   "gives": "w",
   "needs": [
    "r",
    "d",
    "a",
    "h",
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
    "h",
    "n",
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
    "n",
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
    "h",
    "n"
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
    "h",
    "n"
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
    "n",
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
    "a",
    "h",
    "n",
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
    "d",
    "a",
    "h",
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
    "d",
    "a",
    "h",
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
    "h",
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "n",
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
    "a",
    "h",
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
  "vis.step_mx": {
   "gives": "F",
   "needs": [
    "t",
    "d",
    "a",
    "h",
    "n",
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
    "n",
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
  "vis.step_pc": {
   "gives": "F",
   "needs": [
    "t",
    "d",
    "a",
    "h",
    "n",
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
