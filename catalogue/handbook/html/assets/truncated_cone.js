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
  return ((Math.tan(theta) * a) * Math.atan((math.sqrt(((a - b) * (a + b))) / b)));
};

const depth = (a, theta, b) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth(a, theta, b) : NaN);
};

const _force = (a, theta, b, E_star) => {
  let v7;
  v7 = math.sqrt(((a - b) * (a + b)));
  return ((E_star * Math.tan(theta)) * (((a * a) * Math.atan((v7 / b))) + (b * v7)));
};

const force = (a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force(a, theta, b, E_star) : NaN);
};

const RULE_0 = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _slope_beyond = (t, root, theta, b) => {
  let angle;
  angle = Math.atan((root / b));
  return ((Math.tan(theta) * angle) + ((b * Math.tan(theta)) / root));
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

const _pressure_of_truncated_cone = (r, a, theta, b, E_star) => {
  let growth, inside, pressed;
  growth = pressure_integral_beyond(_slope_beyond, [theta, b], r, a, b);
  pressed = math.where(((r === b) & (a > b)), Infinity, ((E_star / Math.PI) * growth));
  inside = math.where((r < a), pressed, 0.0);
  return math.where((a >= b), inside, NaN);
};

const _pressure = (r, a, theta, b, E_star) => {
  let node, v13, v17, v18, v23, v30, v32, v33, v38, v40, v43, v5, v53, v54, v60, v62, v66, v67, v68, v8, v9, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (b <= a))) {
    if ((a >= b)) {
      if ((r < a)) {
        v5 = (r === b);
        if ((v5 && (a > b))) {
          return Infinity;
        }
        v8 = (math.truth(v5) ? math.nextafter(b, Infinity) : r);
        if ((a > (((v8 > b) || (v8 !== v8)) ? v8 : b))) {
          v9 = (v8 < b);
          v13 = (a - b);
          v17 = Math.sqrt(((((v13 > 0.0) || (v13 !== v13)) ? v13 : 0.0) * (a + b)));
          if (v9) {
            v23 = v17;
          } else {
            v18 = (a - v8);
            v23 = Math.sqrt(((((v18 > 0.0) || (v18 !== v18)) ? v18 : 0.0) * (a + v8)));
          }
          v30 = Math.asinh((v23 / Math.sqrt((Math.abs((v8 - b)) * (v8 + b)))));
          v32 = (2.0 * (math.truth(v9) ? 0.0 : 1.0));
          v33 = (1.0 - v32);
          v38 = (v32 - (v33 * Math.expm1(((-2.0) * v30))));
          v40 = ((v38 > 0.0) ? v38 : Infinity);
          v54 = (b * b);
          v60 = Math.tan(theta);
          v62 = (b * v60);
          v67 = [];
          for ([node, weight] of RULE_0((v30 / 1.0))) {
            v43 = (node * v30);
            v53 = (v17 * ((Math.exp((-v43)) * (v32 - (v33 * Math.expm1(((-2.0) * (v30 - v43)))))) / v40));
            v66 = ((((v60 * Math.atan((v53 / b))) + (v62 / v53)) * v53) / Math.sqrt((v54 + (v53 * v53))));
            v67.push((weight * v66));
          }
          v67 = (math.fsum(v67) * v30);
          v68 = v67;
        } else {
          v68 = 0.0;
        }
        return ((E_star / 3.141592653589793) * v68);
      }
      return 0.0;
    }
    return NaN;
  }
  return _pressure_of_truncated_cone(r, a, theta, b, E_star);
};

const pressure = (r, a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure(r, a, theta, b, E_star) : 0.0) : NaN);
};

const RULE_0_of_truncated_cone = math.rule([[0.409, 8], [1.712, 16], [3.012, 24], [4.256, 32], [9.015, 64]]);

const _displacement = (r, a, theta, b) => {
  let node, v10, v11, v13, v16, v21, v23, v28, v31, v33, v4, v42, v43, v45, v47, v48, v51, v52, v60, v62, v70, v71, v73, v9, weight;
  if ((a >= b)) {
    v4 = (r - b);
    v11 = (a - b);
    v13 = (a + b);
    v60 = Math.tan(theta);
    if ((r > a)) {
      if ((a > b)) {
        v9 = math.sqrt(((((v4 > 0.0) || (v4 !== v4)) ? v4 : 0.0) * (r + b)));
        v10 = (b / r);
        v16 = (r - a);
        v21 = (math.sqrt(((((v11 > 0.0) || (v11 !== v11)) ? v11 : 0.0) * v13)) / math.sqrt(((((v16 > 0.0) || (v16 !== v16)) ? v16 : 0.0) * (r + a))));
        v23 = Math.asinh((v21 / v10));
        v28 = (0.0 - Math.expm1(((-2.0) * v23)));
        v31 = ((v28 > 0.0) ? v28 : Infinity);
        v48 = (b * b);
        v52 = (v10 * v10);
        v62 = (b * v60);
        v71 = [];
        for ([node, weight] of RULE_0_of_truncated_cone((v23 / 1.0))) {
          v33 = (node * v23);
          v42 = (v21 * ((Math.exp((-v33)) * (0.0 - Math.expm1(((-2.0) * (v23 - v33))))) / v31));
          v43 = (v42 * v42);
          v45 = math.sqrt((1.0 + v43));
          v47 = ((v9 * v42) / v45);
          v51 = math.sqrt((v48 + (v47 * v47)));
          v70 = ((((((v60 * Math.atan((v47 / b))) + (v62 / v47)) * v47) / v51) * Math.atan2(v51, (v9 / v45))) * (math.sqrt((v52 + v43)) / ((v45 * v45) * v45)));
          v71.push((weight * v70));
        }
        v71 = (math.fsum(v71) * v23);
        v73 = (v9 * v71);
      } else {
        v73 = 0.0;
      }
      return (0.6366197723675814 * v73);
    }
    return (((v60 * a) * Math.atan((math.sqrt((v11 * v13)) / b))) - ((r < b) ? 0.0 : (v60 * v4)));
  }
  return NaN;
};

const displacement = (r, a, theta, b) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement(r, a, theta, b) : 0.0) : NaN);
};

const _stiffness_of_truncated_cone = (a, E_star) => {
  return ((2 * E_star) * a);
};

const _stiffness = (a, E_star, theta = 0.7853981633974483, b = 1.0) => {
  if (((a > 1e-30) && (a < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (b <= a))) {
    return ((2.0 * E_star) * a);
  }
  return _stiffness_of_truncated_cone(a, E_star);
};

const stiffness = (a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness(a, E_star) : NaN);
};

const _mean_pressure_of_truncated_cone = (a, theta, b, E_star) => {
  let angle, root;
  root = Math.sqrt(((a - b) * (a + b)));
  angle = Math.atan((root / b));
  return (((E_star * Math.tan(theta)) / Math.PI) * (angle + ((b * root) / Math.pow(a, 2))));
};

const _mean_pressure = (a, theta, b, E_star) => {
  let v7;
  if (((a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (b <= a))) {
    v7 = Math.sqrt(((a - b) * (a + b)));
    return (((E_star * Math.tan(theta)) / 3.141592653589793) * (Math.atan((v7 / b)) + ((b * v7) / (a * a))));
  }
  return _mean_pressure_of_truncated_cone(a, theta, b, E_star);
};

const mean_pressure = (a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure(a, theta, b, E_star) : NaN);
};

const _depth_at = (a, root, theta, b) => {
  let angle;
  angle = Math.atan((root / b));
  return ((Math.tan(theta) * a) * angle);
};

const _depth_of_truncated_cone = (a, theta, b) => {
  let root;
  root = Math.sqrt(((a - b) * (a + b)));
  return _depth_at(a, root, theta, b);
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

const _energy_of_truncated_cone = (a, theta, b, E_star) => {
  let beyond, sunk;
  sunk = _depth_of_truncated_cone(a, theta, b);
  beyond = energy_integral_beyond(_depth_at, [theta, b], a, sunk, b);
  return math.where((a >= b), (E_star * (((b * sunk) * sunk) + beyond)), NaN);
};

const _energy = (a, theta, b, E_star) => {
  let node, v10, v12, v16, v18, v23, v26, v28, v37, v38, v4, v46, v48, v49, v5, v50, weight;
  if (((a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (b <= a))) {
    if ((a >= b)) {
      v4 = (a - b);
      v5 = (a + b);
      v10 = Math.tan(theta);
      v12 = ((v10 * a) * Math.atan((Math.sqrt((v4 * v5)) / b)));
      if ((a > b)) {
        v16 = Math.sqrt(((((v4 > 0.0) || (v4 !== v4)) ? v4 : 0.0) * v5));
        v18 = Math.asinh((v16 / b));
        v23 = (0.0 - Math.expm1(((-2.0) * v18)));
        v26 = ((v23 > 0.0) ? v23 : Infinity);
        v38 = (b * b);
        v49 = [];
        for ([node, weight] of RULE_0((v18 / 1.0))) {
          v28 = (node * v18);
          v37 = (v16 * ((Math.exp((-v28)) * (0.0 - Math.expm1(((-2.0) * (v18 - v28))))) / v26));
          v46 = (v12 - ((v10 * Math.sqrt((v38 + (v37 * v37)))) * Math.atan((v37 / b))));
          v48 = ((v46 * v46) * v37);
          v49.push((weight * v48));
        }
        v49 = (math.fsum(v49) * v18);
        v50 = v49;
      } else {
        v50 = 0.0;
      }
      return (E_star * (((b * v12) * v12) + v50));
    }
    return NaN;
  }
  return _energy_of_truncated_cone(a, theta, b, E_star);
};

const energy = (a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return ((a >= 0.0) ? _energy(a, theta, b, E_star) : NaN);
};

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

const _force_at = (a, root, theta, b, E_star) => {
  let angle;
  angle = Math.atan((root / b));
  return ((E_star * Math.tan(theta)) * ((Math.pow(a, 2) * angle) + (b * root)));
};

const _force_of_truncated_cone = (a, theta, b, E_star) => {
  let root;
  root = Math.sqrt(((a - b) * (a + b)));
  return _force_at(a, root, theta, b, E_star);
};

const _load_within_of_truncated_cone = (r, a, theta, b, E_star) => {
  let beyond, found;
  beyond = load_within_integral_beyond(_slope_beyond, [theta, b], r, a, b);
  found = (math.where((r > b), _force_of_truncated_cone(math.maximum(math.minimum(r, a), b), theta, b, E_star), 0.0) + ((2 * E_star) * beyond));
  return math.where((a >= b), found, NaN);
};

const _load_within = (r, a, theta, b, E_star) => {
  let node, v101, v12, v13, v17, v18, v22, v30, v32, v33, v36, v38, v40, v42, v43, v45, v47, v51, v53, v56, v61, v66, v67, v70, v73, v75, v8, v82, v83, v85, v87, v88, v9, v92, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (b <= a))) {
    if ((a >= b)) {
      v8 = ((r === b) ? math.nextafter(b, Infinity) : r);
      v73 = Math.tan(theta);
      if ((a > (((v8 > b) || (v8 !== v8)) ? v8 : b))) {
        v9 = (v8 < b);
        v12 = (math.truth(v9) ? 0.0 : 1.0);
        v13 = (a - b);
        v17 = Math.sqrt(((((v13 > 0.0) || (v13 !== v13)) ? v13 : 0.0) * (a + b)));
        v18 = (a - v8);
        v22 = Math.sqrt(((((v18 > 0.0) || (v18 !== v18)) ? v18 : 0.0) * (a + v8)));
        v30 = Math.asinh(((math.truth(v9) ? v17 : v22) / Math.sqrt((Math.abs((v8 - b)) * (v8 + b)))));
        v32 = (2.0 * v12);
        v33 = (1.0 - v32);
        v36 = Math.expm1(((-2.0) * v30));
        v38 = (v32 - (v33 * v36));
        v40 = ((v38 > 0.0) ? v38 : Infinity);
        v42 = (2.0 * (1.0 - v12));
        v43 = (1.0 - v42);
        v45 = (v42 - (v43 * v36));
        v47 = ((v45 > 0.0) ? v45 : Infinity);
        v67 = (b * b);
        v75 = (b * v73);
        v83 = [];
        for ([node, weight] of RULE_0((v30 / 1.0))) {
          v51 = (node * v30);
          v53 = Math.exp((-v51));
          v56 = Math.expm1(((-2.0) * (v30 - v51)));
          v61 = (v17 * ((v53 * (v32 - (v33 * v56))) / v40));
          v66 = (v22 * ((v53 * (v42 - (v43 * v56))) / v47));
          v70 = Math.sqrt((v67 + (v61 * v61)));
          v82 = ((((v73 * Math.atan((v61 / b))) + (v75 / v61)) * (v61 / v70)) * (v66 / (v70 + v66)));
          v83.push((weight * v82));
        }
        v83 = (math.fsum(v83) * v30);
        v85 = ((v8 * v8) * v83);
      } else {
        v85 = 0.0;
      }
      if ((r > b)) {
        v87 = (((r < a) || (r !== r)) ? r : a);
        v88 = (((v87 > b) || (v87 !== v87)) ? v87 : b);
        v92 = Math.sqrt(((v88 - b) * (v88 + b)));
        v101 = ((E_star * v73) * (((v88 * v88) * Math.atan((v92 / b))) + (b * v92)));
      } else {
        v101 = 0.0;
      }
      return (v101 + ((2.0 * E_star) * v85));
    }
    return NaN;
  }
  return _load_within_of_truncated_cone(r, a, theta, b, E_star);
};

const load_within = (r, a, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _load_within(r, a, theta, b, E_star) : 0.0) : NaN);
};

const _depth_at_of_truncated_cone = (a, root, theta, b) => {
  return ((Math.tan(theta) * a) * Math.atan((root / b)));
};

const _slope_beyond_of_truncated_cone = (t, root, theta, b) => {
  let v6;
  v6 = Math.tan(theta);
  return ((v6 * Math.atan((root / b))) + ((b * v6) / root));
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

const _contact_from_depth = (d, theta, b) => {
  let curve, rest, start, t;
  curve = (t) => {
    let a, root, value;
    [a, root] = [(b * Math.sqrt((1.0 + (t * t)))), (b * t)];
    value = _depth_at_of_truncated_cone(a, root, theta, b);
    return [value, ((((root * root) / a) * _slope_beyond_of_truncated_cone(a, root, theta, b)) / value)];
  };
  rest = [1.587574, (-0.008072401), (-0.4352508), (-3.570796), 8.66489, (-8.150206), 3.403791, (-0.4812051)];
  start = between(Math.log((d / curve(1.0)[0])), [0.9003, 1.0], [1.414, 1.0], (-6.0), rest);
  t = inverse(curve, d, start, [1.0, 2.0], undefined, undefined, true);
  return [(b * Math.sqrt((1.0 + (t * t)))), (b * t)];
};

const _radius_from_depth = (d, theta, b) => {
  return _contact_from_depth(d, theta, b)[0];
};

const radius_from_depth = (d, theta, b) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _radius_from_depth(d, theta, b) : NaN);
};

const _force_at_of_truncated_cone = (a, root, theta, b, E_star) => {
  return ((E_star * Math.tan(theta)) * (((a * a) * Math.atan((root / b))) + (b * root)));
};

const _contact_from_force = (F, theta, b, E_star) => {
  let curve, rest, start, t;
  curve = (t) => {
    let a, root, value;
    [a, root] = [(b * Math.sqrt((1.0 + (t * t)))), (b * t)];
    value = _force_at_of_truncated_cone(a, root, theta, b, E_star);
    return [value, (((((2 * E_star) * root) * root) * _slope_beyond_of_truncated_cone(a, root, theta, b)) / value)];
  };
  rest = [0.9995205, 0.100541, (-0.3986471), 4.536442, (-19.76727), 34.2219, (-25.89697), 7.204481];
  start = between(Math.log((F / curve(1.0)[0])), [0.778, 1.0], [0.611, 2.0], (-2.75), rest);
  t = inverse(curve, F, start, [1.0, 2.0], undefined, undefined, true);
  return [(b * Math.sqrt((1.0 + (t * t)))), (b * t)];
};

const _radius_from_force = (F, theta, b, E_star) => {
  return _contact_from_force(F, theta, b, E_star)[0];
};

const radius_from_force = (F, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _radius_from_force(F, theta, b, E_star) : NaN);
};

const _force_from_depth = (d, theta, b, E_star) => {
  let a, change, root;
  [a, root] = _contact_from_depth(d, theta, b);
  change = (((a > 0.0) & (a < Infinity)) ? (((2 * E_star) * a) * (d - _depth_at_of_truncated_cone(a, root, theta, b))) : 0.0);
  return (_force_at_of_truncated_cone(a, root, theta, b, E_star) + change);
};

const force_from_depth = (d, theta, b, E_star) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth(d, theta, b, E_star) : NaN);
};

const _depth_from_force = (F, theta, b, E_star) => {
  let a, change, root;
  [a, root] = _contact_from_force(F, theta, b, E_star);
  change = (((a > 0.0) & (a < Infinity)) ? ((F - _force_at_of_truncated_cone(a, root, theta, b, E_star)) / ((2 * E_star) * a)) : 0.0);
  return (_depth_at_of_truncated_cone(a, root, theta, b) + change);
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
  return (((Math.tan(theta) * a) * Math.atan((math.sqrt(((a - b) * (a + b))) / b))) - (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const depth_of_truncated_cone = (a, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return ((a >= 0.0) ? _depth_2(a, theta, b, E_star, dgamma) : NaN);
};

const _force_2 = (a, theta, b, E_star, dgamma) => {
  let v8;
  v8 = math.sqrt(((a - b) * (a + b)));
  return (((E_star * Math.tan(theta)) * (((a * a) * Math.atan((v8 / b))) + (b * v8))) - (((2.0 * E_star) * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star)))));
};

const force_of_truncated_cone = (a, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
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
  return (_pressure_of_truncated_cone(r, a, theta, b, E_star) - tension(r, a, E_star, dgamma));
};

const _pressure_2 = (r, a, theta, b, E_star, dgamma) => {
  let node, v10, v14, v18, v19, v24, v31, v33, v34, v39, v41, v44, v54, v55, v6, v61, v63, v67, v68, v69, v75, v77, v80, v86, v89, v9, v96, v98, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30) && (b <= a))) {
    if ((a >= b)) {
      if ((r < a)) {
        v6 = (r === b);
        if ((v6 && (a > b))) {
          v75 = Infinity;
        } else {
          v9 = (math.truth(v6) ? math.nextafter(b, Infinity) : r);
          if ((a > (((v9 > b) || (v9 !== v9)) ? v9 : b))) {
            v10 = (v9 < b);
            v14 = (a - b);
            v18 = Math.sqrt(((((v14 > 0.0) || (v14 !== v14)) ? v14 : 0.0) * (a + b)));
            if (v10) {
              v24 = v18;
            } else {
              v19 = (a - v9);
              v24 = Math.sqrt(((((v19 > 0.0) || (v19 !== v19)) ? v19 : 0.0) * (a + v9)));
            }
            v31 = Math.asinh((v24 / Math.sqrt((Math.abs((v9 - b)) * (v9 + b)))));
            v33 = (2.0 * (math.truth(v10) ? 0.0 : 1.0));
            v34 = (1.0 - v33);
            v39 = (v33 - (v34 * Math.expm1(((-2.0) * v31))));
            v41 = ((v39 > 0.0) ? v39 : Infinity);
            v55 = (b * b);
            v61 = Math.tan(theta);
            v63 = (b * v61);
            v68 = [];
            for ([node, weight] of RULE_0_2((v31 / 1.0))) {
              v44 = (node * v31);
              v54 = (v18 * ((Math.exp((-v44)) * (v33 - (v34 * Math.expm1(((-2.0) * (v31 - v44)))))) / v41));
              v67 = ((((v61 * Math.atan((v54 / b))) + (v63 / v54)) * v54) / Math.sqrt((v55 + (v54 * v54))));
              v68.push((weight * v67));
            }
            v68 = (math.fsum(v68) * v31);
            v69 = v68;
          } else {
            v69 = 0.0;
          }
          v75 = ((E_star / 3.141592653589793) * v69);
        }
        v77 = v75;
      } else {
        v77 = 0.0;
      }
      v80 = v77;
    } else {
      v80 = NaN;
    }
    if ((r <= a)) {
      v86 = (Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star)));
      if ((v86 > 0.0)) {
        v89 = (a - r);
        v96 = ((E_star * v86) / (3.141592653589793 * Math.sqrt(((((v89 > 0.0) || (v89 !== v89)) ? v89 : 0.0) * (a + r)))));
      } else {
        v96 = 0.0;
      }
      v98 = v96;
    } else {
      v98 = 0.0;
    }
    return (v80 - v98);
  }
  return _pressure_3(r, a, theta, b, E_star, dgamma);
};

const pressure_of_truncated_cone = (r, a, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
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

const _profile = (r, theta, b) => {
  return math.where((r < b), 0, (Math.tan(theta) * (r - b)));
};

const _displacement_3 = (r, a, theta, b) => {
  let beyond, inside, outside;
  beyond = displacement_integral_beyond(_slope_beyond, [theta, b], r, a, b);
  outside = ((2 / Math.PI) * beyond);
  inside = (_depth_of_truncated_cone(a, theta, b) - _profile(r, theta, b));
  return math.where((a >= b), math.where((r > a), outside, inside), NaN);
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

const _displacement_of_truncated_cone = (r, a, theta, b, E_star, dgamma) => {
  let node, v11, v12, v13, v15, v18, v22, v23, v25, v30, v33, v35, v44, v45, v47, v49, v50, v53, v54, v6, v62, v64, v72, v73, v75, v89, v90, v92, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (dgamma > 1e-30) && (dgamma < 1e+30) && (b <= a))) {
    v18 = (r - a);
    v22 = Math.sqrt(((((v18 > 0.0) || (v18 !== v18)) ? v18 : 0.0) * (r + a)));
    v89 = (r > a);
    if ((a >= b)) {
      v6 = (r - b);
      v13 = (a - b);
      v15 = (a + b);
      v62 = Math.tan(theta);
      if (v89) {
        if ((a > b)) {
          v11 = Math.sqrt(((((v6 > 0.0) || (v6 !== v6)) ? v6 : 0.0) * (r + b)));
          v12 = (b / r);
          v23 = (Math.sqrt(((((v13 > 0.0) || (v13 !== v13)) ? v13 : 0.0) * v15)) / v22);
          v25 = Math.asinh((v23 / v12));
          v30 = (0.0 - Math.expm1(((-2.0) * v25)));
          v33 = ((v30 > 0.0) ? v30 : Infinity);
          v50 = (b * b);
          v54 = (v12 * v12);
          v64 = (b * v62);
          v73 = [];
          for ([node, weight] of RULE_0_2((v25 / 1.0))) {
            v35 = (node * v25);
            v44 = (v23 * ((Math.exp((-v35)) * (0.0 - Math.expm1(((-2.0) * (v25 - v35))))) / v33));
            v45 = (v44 * v44);
            v47 = Math.sqrt((1.0 + v45));
            v49 = ((v11 * v44) / v47);
            v53 = Math.sqrt((v50 + (v49 * v49)));
            v72 = ((((((v62 * Math.atan((v49 / b))) + (v64 / v49)) * v49) / v53) * Math.atan2(v53, (v11 / v47))) * (Math.sqrt((v54 + v45)) / ((v47 * v47) * v47)));
            v73.push((weight * v72));
          }
          v73 = (math.fsum(v73) * v25);
          v75 = (v11 * v73);
        } else {
          v75 = 0.0;
        }
        v90 = (0.6366197723675814 * v75);
      } else {
        v90 = (((v62 * a) * Math.atan((Math.sqrt((v13 * v15)) / b))) - ((r < b) ? 0.0 : (v62 * v6)));
      }
      v92 = v90;
    } else {
      v92 = NaN;
    }
    return (v92 - ((Math.sqrt(a) * Math.sqrt(((6.283185307179586 * dgamma) / E_star))) * (math.truth(v89) ? (0.6366197723675814 * Math.atan2(a, v22)) : 1.0)));
  }
  return _displacement_2(r, a, theta, b, E_star, dgamma);
};

const displacement_of_truncated_cone = (r, a, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _displacement_of_truncated_cone(r, a, theta, b, E_star, dgamma) : 0.0) : NaN);
};

const exponent_of = (x) => {
  return (math.frexp(x)[1] - 1);
};

const _rate = (a, theta, b) => {
  let v11, v3, v8;
  v3 = (a - b);
  v8 = math.sqrt(((((v3 > 0.0) || (v3 !== v3)) ? v3 : 0.0) * (a + b)));
  v11 = Math.tan(theta);
  return ((v11 * Math.atan((v8 / b))) + ((b * v11) / v8));
};

const radii_beyond = (length = 1.0) => [1.0, 1.0000000000000049, 1.0000000000000062, 1.0000000000000078, 1.00000000000001, 1.0000000000000124, 1.0000000000000158, 1.0000000000000198, 1.000000000000025, 1.0000000000000315, 1.0000000000000397, 1.00000000000005, 1.0000000000000628, 1.0000000000000793, 1.0000000000000997, 1.0000000000001255, 1.000000000000158, 1.000000000000199, 1.0000000000002505, 1.0000000000003155, 1.000000000000397, 1.0000000000005, 1.0000000000006295, 1.0000000000007925, 1.0000000000009976, 1.0000000000012559, 1.0000000000015812, 1.0000000000019904, 1.0000000000025058, 1.0000000000031548, 1.0000000000039715, 1.000000000005, 1.0000000000062945, 1.0000000000079243, 1.0000000000099762, 1.0000000000125593, 1.0000000000158114, 1.0000000000199054, 1.0000000000250593, 1.0000000000315479, 1.0000000000397165, 1.00000000005, 1.0000000000629463, 1.0000000000792446, 1.000000000099763, 1.0000000001255942, 1.0000000001581137, 1.0000000001990534, 1.0000000002505935, 1.0000000003154785, 1.000000000397164, 1.0000000005, 1.0000000006294627, 1.0000000007924466, 1.000000000997631, 1.0000000012559431, 1.0000000015811388, 1.0000000019905357, 1.0000000025059361, 1.0000000031547867, 1.000000003971641, 1.000000005, 1.000000006294627, 1.000000007924466, 1.0000000099763116, 1.0000000125594322, 1.0000000158113882, 1.0000000199053583, 1.0000000250593615, 1.0000000315478668, 1.0000000397164108, 1.0000000499999988, 1.0000000629462686, 1.0000000792446564, 1.0000000997631109, 1.0000001255943136, 1.0000001581138704, 1.0000001990535654, 1.0000002505935854, 1.0000003154786223, 1.0000003971640385, 1.000000499999875, 1.0000006294625077, 1.0000007924462821, 1.0000009976306599, 1.0000012559424272, 1.0000015811375802, 1.0000019905338717, 1.0000025059330282, 1.000003154781746, 1.0000039716332867, 1.0000049999875, 1.0000062946072479, 1.0000079244345639, 1.000009976261812, 1.000012559353289, 1.0000158112633029, 1.00001990516042, 1.0000250590477036, 1.0000315473696058, 1.0000397156230707, 1.0000499987500624, 1.0000629442895979, 1.0000792415200137, 1.0000997581399051, 1.0001255864355991, 1.0001581013849845, 1.0001990337780544, 1.000250562226099, 1.0003154289245368, 1.0003970852790027, 1.000499875062461, 1.000629264718854, 1.0007921328589973, 1.000997134019358, 1.00125515550808, 1.00157989080261, 1.0019885586699753, 1.00250280415382, 1.0031498260204212, 1.003963785376366, 1.0049875621120885, 1.0062749396253194, 1.007893313761238, 1.0099270385278765, 1.0124815377650564, 1.0156883265065522, 1.0197110948966603, 1.0247530060276584, 1.0310653395629263, 1.038957565770816, 1.0488088481701465, 1.061080836307679, 1.0763314170115514, 1.0952288489155435, 1.1185654398160756, 1.1472697006444488, 1.1824158196478314, 1.2252294616222776, 1.2770894034796945, 1.3395253766630146, 1.4142135623730545, 1.5029721926216806, 1.6077603031736196, 1.730682615319356, 1.8740027832181265, 2.040166086417477, 2.231831468891524, 2.4519119756369965, 2.7036222821986744, 2.99053211774123, 3.316624790355215, 3.68636055180989, 4.104745049891547, 4.577403537999059, 5.110661827502642, 5.711635195080283, 6.388326624034235, 7.149735894613227, 8.005981167103203, 8.96843483961487, 10.04987562112024, 11.264658946430675, 12.628908078139231, 14.160728494567662, 15.88044845559861, 17.81088897323198, 19.977666794534418, 22.40953443575305, 25.138761792898762, 28.201564402071295, 31.63858403911055, 35.49542804072076, 39.82327450701274, 44.679551418614366, 50.12869868158581, 56.243023213265424, 63.103658416405615, 70.8016407738692, 79.43911785009331, 89.13070372908327, 100.00499987499889, 112.20630159638924, 125.89651275793454, 141.25729414683593, 158.49247400142386, 177.830752688277, 199.52873741730454, 223.87434726363662, 251.19063367890456, 281.8400671877868, 316.2293471516906, 354.81479842221427, 398.10842649470067, 446.6847115100955, 501.1882312573971, 562.3422143293052, 630.9581369262412, 707.9464906525023, 794.3288641866736, 891.2514991427217, 1000.000499999875, 10000000000000.0, 1.0000000000000001e+23, 1e+33, 1e+43, 1e+53, 1e+63, 1e+73, 1e+83, 1e+93, 1e+103, 1e+113, 1e+123, 1e+133, 1e+143].map((x) => x * length);

const _samples = (theta, b) => {
  let a;
  a = radii_beyond(b);
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

const _radius_from_depth_of_truncated_cone = (d, theta, b, E_star, dgamma) => {
  let found, radius, stress, unit;
  unit = exponent_of(b);
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  d = math.ldexp(d, (-unit));
  found = _branches(theta, b, E_star, dgamma, 'depth');
  radius = stable_radius(d, found, ((a) => _depth_2(a, theta, b, E_star, dgamma)), ((a) => growth(_rate(a, theta, b), a, 'depth', E_star, dgamma)), ((a) => hess_retraction(a, E_star, dgamma)), radius_itself(), beyond_edge(b));
  return math.ldexp(radius, unit);
};

const radius_from_depth_of_truncated_cone = (d, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_depth_of_truncated_cone(d, theta, b, E_star, dgamma);
};

const pull = (a, E_star, dgamma) => {
  return (((2.0 * E_star) * a) * (math.sqrt(a) * math.sqrt(((6.283185307179586 * dgamma) / E_star))));
};

const _radius_from_force_of_truncated_cone = (F, theta, b, E_star, dgamma) => {
  let found, radius, stress, unit;
  unit = exponent_of(b);
  stress = exponent_of(E_star);
  E_star = math.ldexp(E_star, (-stress));
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  F = math.ldexp(F, (-(stress + (2 * unit))));
  found = _branches(theta, b, E_star, dgamma, 'force');
  radius = stable_radius(F, found, ((a) => _force_2(a, theta, b, E_star, dgamma)), ((a) => growth(_rate(a, theta, b), a, 'force', E_star, dgamma)), ((a) => pull(a, E_star, dgamma)), radius_itself(), beyond_edge(b));
  return math.ldexp(radius, unit);
};

const radius_from_force_of_truncated_cone = (F, theta, b, E_star, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_force_of_truncated_cone(F, theta, b, E_star, dgamma);
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
  if ((a > c)) {
    return (((a - c) * (a + c)) / (outer + inner));
  }
  return 0.0;
};

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

const _tangential_force_of_truncated_cone = (a, c, theta, b, E_star, mu) => {
  let close, gain, sticking, whole;
  [whole, sticking] = [_force_of_truncated_cone(a, theta, b, E_star), _force_of_truncated_cone(c, theta, b, E_star)];
  close = (sticking >= (CLOSE * whole));
  gain = ((2.0 * E_star) * growth_beyond(_slope_beyond, [theta, b], 2, 0.0, c, a, b, close));
  return (mu * math.where(close, gain, (whole - sticking)));
};

const _tangential_force = (a, c, theta, b, E_star, mu) => {
  let node, v12, v13, v19, v23, v30, v33, v35, v36, v41, v42, v46, v50, v53, v57, v6, v64, v66, v7, v70, v72, v77, v78, v81, v85, v9, v91, v92, v93, v96, weight;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30) && (b <= a))) {
    v6 = (a - b);
    v7 = (a + b);
    v9 = Math.sqrt((v6 * v7));
    v12 = Math.tan(theta);
    v13 = (E_star * v12);
    v19 = (v13 * (((a * a) * Math.atan((v9 / b))) + (b * v9)));
    v23 = Math.sqrt(((c - b) * (c + b)));
    v30 = (v13 * (((c * c) * Math.atan((v23 / b))) + (b * v23)));
    v33 = (v30 >= (0.25 * v19));
    if (v33) {
      v35 = (((b > c) || (b !== b)) ? b : c);
      v50 = (a > v35);
      v66 = (v33 && v50);
      if (v66) {
        v36 = (v35 - b);
        v41 = Math.sqrt(((((v36 > 0.0) || (v36 !== v36)) ? v36 : 0.0) * (v35 + b)));
        v42 = (v35 - 0.0);
        v46 = Math.sqrt(((((v42 > 0.0) || (v42 !== v42)) ? v42 : 0.0) * (v35 + 0.0)));
        if (v66) {
          v53 = ((a - v35) * (a + v35));
          if (v50) {
            v57 = (a - 0.0);
            v64 = (v53 / (Math.sqrt(((((v57 > 0.0) || (v57 !== v57)) ? v57 : 0.0) * (a + 0.0))) + v46));
          } else {
            v64 = 0.0;
          }
          v70 = Math.log1p((((math.truth(v50) ? (v53 / (Math.sqrt(((((v6 > 0.0) || (v6 !== v6)) ? v6 : 0.0) * v7)) + v41)) : 0.0) + v64) / (v41 + v46)));
        } else {
          v70 = 0.0;
        }
        v78 = (b * b);
        v85 = (b * v12);
        v92 = [];
        for ([node, weight] of RULE_0_3((v70 / 1.0))) {
          v72 = (node * v70);
          v77 = ((v41 * Math.cosh(v72)) + (v46 * Math.sinh(v72)));
          v81 = Math.sqrt((v78 + (v77 * v77)));
          v91 = ((((v12 * Math.atan((v77 / b))) + (v85 / v77)) * (v77 / v81)) * (v81 * v81));
          v92.push((weight * v91));
        }
        v92 = (math.fsum(v92) * v70);
        v93 = v92;
      } else {
        v93 = 0.0;
      }
      v96 = ((2.0 * E_star) * v93);
    } else {
      v96 = (v19 - v30);
    }
    return (mu * v96);
  }
  return _tangential_force_of_truncated_cone(a, c, theta, b, E_star, mu);
};

const tangential_force = (a, c, theta, b, E_star, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_force(a, c, theta, b, E_star, mu) : NaN);
};

const _traction_of_truncated_cone = (r, a, c, theta, b, E_star, mu) => {
  let close, gain, sliding, stuck;
  sliding = _pressure_of_truncated_cone(r, a, theta, b, E_star);
  stuck = _pressure_of_truncated_cone(r, c, theta, b, E_star);
  close = ((r < c) & (stuck >= (CLOSE * sliding)));
  gain = ((E_star / Math.PI) * growth_beyond(_slope_beyond, [theta, b], 0, r, c, a, b, close));
  return (mu * math.where(close, gain, (sliding - stuck)));
};

const _traction = (r, a, c, theta, b, E_star, mu) => {
  let node, v10, v100, v102, v11, v112, v122, v123, v124, v128, v129, v130, v132, v136, v137, v138, v142, v143, v147, v148, v15, v151, v155, v162, v164, v168, v169, v174, v177, v186, v187, v188, v19, v191, v20, v25, v30, v32, v34, v35, v40, v42, v43, v45, v55, v56, v62, v64, v68, v69, v7, v70, v74, v76, v78, v81, v82, v86, v87, v92, v94, v98, weight;
  if (((r > 1e-30) && (r < 1e+30) && (a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30) && (b <= a))) {
    v7 = (r === b);
    v10 = (math.truth(v7) ? math.nextafter(b, Infinity) : r);
    v11 = (v10 < b);
    v15 = (a - b);
    v19 = Math.sqrt(((((v15 > 0.0) || (v15 !== v15)) ? v15 : 0.0) * (a + b)));
    v30 = Math.sqrt((Math.abs((v10 - b)) * (v10 + b)));
    v34 = (2.0 * (math.truth(v11) ? 0.0 : 1.0));
    v35 = (1.0 - v34);
    v43 = (((v10 > b) || (v10 !== v10)) ? v10 : b);
    v56 = (b * b);
    v62 = Math.tan(theta);
    v64 = (b * v62);
    v74 = (E_star / 3.141592653589793);
    if ((a >= b)) {
      if ((r < a)) {
        if ((v7 && (a > b))) {
          v76 = Infinity;
        } else {
          if ((a > v43)) {
            if (v11) {
              v25 = v19;
            } else {
              v20 = (a - v10);
              v25 = Math.sqrt(((((v20 > 0.0) || (v20 !== v20)) ? v20 : 0.0) * (a + v10)));
            }
            v32 = Math.asinh((v25 / v30));
            v40 = (v34 - (v35 * Math.expm1(((-2.0) * v32))));
            v42 = ((v40 > 0.0) ? v40 : Infinity);
            v69 = [];
            for ([node, weight] of RULE_0_3((v32 / 1.0))) {
              v45 = (node * v32);
              v55 = (v19 * ((Math.exp((-v45)) * (v34 - (v35 * Math.expm1(((-2.0) * (v32 - v45)))))) / v42));
              v68 = ((((v62 * Math.atan((v55 / b))) + (v64 / v55)) * v55) / Math.sqrt((v56 + (v55 * v55))));
              v69.push((weight * v68));
            }
            v69 = (math.fsum(v69) * v32);
            v70 = v69;
          } else {
            v70 = 0.0;
          }
          v76 = (v74 * v70);
        }
        v78 = v76;
      } else {
        v78 = 0.0;
      }
      v81 = v78;
    } else {
      v81 = NaN;
    }
    v129 = (r < c);
    if ((c >= b)) {
      if (v129) {
        if ((v7 && (c > b))) {
          v128 = Infinity;
        } else {
          if ((c > v43)) {
            v82 = (c - b);
            v86 = Math.sqrt(((((v82 > 0.0) || (v82 !== v82)) ? v82 : 0.0) * (c + b)));
            if (v11) {
              v92 = v86;
            } else {
              v87 = (c - v10);
              v92 = Math.sqrt(((((v87 > 0.0) || (v87 !== v87)) ? v87 : 0.0) * (c + v10)));
            }
            v94 = Math.asinh((v92 / v30));
            v98 = (v34 - (v35 * Math.expm1(((-2.0) * v94))));
            v100 = ((v98 > 0.0) ? v98 : Infinity);
            v123 = [];
            for ([node, weight] of RULE_0_3((v94 / 1.0))) {
              v102 = (node * v94);
              v112 = (v86 * ((Math.exp((-v102)) * (v34 - (v35 * Math.expm1(((-2.0) * (v94 - v102)))))) / v100));
              v122 = ((((v62 * Math.atan((v112 / b))) + (v64 / v112)) * v112) / Math.sqrt((v56 + (v112 * v112))));
              v123.push((weight * v122));
            }
            v123 = (math.fsum(v123) * v94);
            v124 = v123;
          } else {
            v124 = 0.0;
          }
          v128 = (v74 * v124);
        }
        v130 = v128;
      } else {
        v130 = 0.0;
      }
      v132 = v130;
    } else {
      v132 = NaN;
    }
    v136 = (v129 && (v132 >= (0.25 * v81)));
    if (v136) {
      v137 = (((b > c) || (b !== b)) ? b : c);
      v148 = (a > v137);
      v164 = (v136 && v148);
      if (v164) {
        v138 = (v137 - b);
        v142 = Math.sqrt(((((v138 > 0.0) || (v138 !== v138)) ? v138 : 0.0) * (v137 + b)));
        v143 = (v137 - r);
        v147 = Math.sqrt(((((v143 > 0.0) || (v143 !== v143)) ? v143 : 0.0) * (v137 + r)));
        if (v164) {
          v151 = ((a - v137) * (a + v137));
          if (v148) {
            v155 = (a - r);
            v162 = (v151 / (Math.sqrt(((((v155 > 0.0) || (v155 !== v155)) ? v155 : 0.0) * (a + r))) + v147));
          } else {
            v162 = 0.0;
          }
          v168 = Math.log1p((((math.truth(v148) ? (v151 / (v19 + v142)) : 0.0) + v162) / (v142 + v147)));
        } else {
          v168 = 0.0;
        }
        v187 = [];
        for ([node, weight] of RULE_0_3((v168 / 1.0))) {
          v169 = (node * v168);
          v174 = ((v142 * Math.cosh(v169)) + (v147 * Math.sinh(v169)));
          v177 = Math.sqrt((v56 + (v174 * v174)));
          v186 = ((((v62 * Math.atan((v174 / b))) + (v64 / v174)) * (v174 / v177)) * Math.pow(v177, 0.0));
          v187.push((weight * v186));
        }
        v187 = (math.fsum(v187) * v168);
        v188 = v187;
      } else {
        v188 = 0.0;
      }
      v191 = (v74 * v188);
    } else {
      v191 = (v81 - v132);
    }
    return (mu * v191);
  }
  return _traction_of_truncated_cone(r, a, c, theta, b, E_star, mu);
};

const traction = (r, a, c, theta, b, E_star, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction(r, a, c, theta, b, E_star, mu) : 0.0) : NaN);
};

const _tangential_displacement_of_truncated_cone = (a, c, theta, b, E_star, G_star, mu) => {
  let close, gain, sticking, whole;
  [whole, sticking] = [_depth_of_truncated_cone(a, theta, b), _depth_of_truncated_cone(c, theta, b)];
  close = (sticking >= (CLOSE * whole));
  gain = growth_beyond(_slope_beyond, [theta, b], 1, 0.0, c, a, b, close);
  return ((mu * (E_star / G_star)) * math.where(close, gain, (whole - sticking)));
};

const _tangential_displacement = (a, c, theta, b, E_star, G_star, mu) => {
  let node, v13, v15, v23, v26, v27, v28, v33, v34, v38, v42, v45, v49, v56, v58, v62, v64, v69, v7, v70, v73, v77, v8, v83, v84, v85, v89, weight;
  if (((a > 1e-30) && (a < 1e+30) && (c > 1e-30) && (c < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30) && (b <= a))) {
    v7 = (a - b);
    v8 = (a + b);
    v13 = Math.tan(theta);
    v15 = ((v13 * a) * Math.atan((Math.sqrt((v7 * v8)) / b)));
    v23 = ((v13 * c) * Math.atan((Math.sqrt(((c - b) * (c + b))) / b)));
    v26 = (v23 >= (0.25 * v15));
    if (v26) {
      v27 = (((b > c) || (b !== b)) ? b : c);
      v42 = (a > v27);
      v58 = (v26 && v42);
      if (v58) {
        v28 = (v27 - b);
        v33 = Math.sqrt(((((v28 > 0.0) || (v28 !== v28)) ? v28 : 0.0) * (v27 + b)));
        v34 = (v27 - 0.0);
        v38 = Math.sqrt(((((v34 > 0.0) || (v34 !== v34)) ? v34 : 0.0) * (v27 + 0.0)));
        if (v58) {
          v45 = ((a - v27) * (a + v27));
          if (v42) {
            v49 = (a - 0.0);
            v56 = (v45 / (Math.sqrt(((((v49 > 0.0) || (v49 !== v49)) ? v49 : 0.0) * (a + 0.0))) + v38));
          } else {
            v56 = 0.0;
          }
          v62 = Math.log1p((((math.truth(v42) ? (v45 / (Math.sqrt(((((v7 > 0.0) || (v7 !== v7)) ? v7 : 0.0) * v8)) + v33)) : 0.0) + v56) / (v33 + v38)));
        } else {
          v62 = 0.0;
        }
        v70 = (b * b);
        v77 = (b * v13);
        v84 = [];
        for ([node, weight] of RULE_0_3((v62 / 1.0))) {
          v64 = (node * v62);
          v69 = ((v33 * Math.cosh(v64)) + (v38 * Math.sinh(v64)));
          v73 = Math.sqrt((v70 + (v69 * v69)));
          v83 = ((((v13 * Math.atan((v69 / b))) + (v77 / v69)) * (v69 / v73)) * Math.pow(v73, 1.0));
          v84.push((weight * v83));
        }
        v84 = (math.fsum(v84) * v62);
        v85 = v84;
      } else {
        v85 = 0.0;
      }
      v89 = v85;
    } else {
      v89 = (v15 - v23);
    }
    return ((mu * (E_star / G_star)) * v89);
  }
  return _tangential_displacement_of_truncated_cone(a, c, theta, b, E_star, G_star, mu);
};

const tangential_displacement = (a, c, theta, b, E_star, G_star, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
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
  if ((!(a >= b))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius(F_x, a, theta, b, E_star, mu) : NaN);
};

const _full_slip_displacement_of_truncated_cone = (a, theta, b, E_star, G_star, mu) => {
  return ((mu * (E_star / G_star)) * _depth_of_truncated_cone(a, theta, b));
};

const _full_slip_displacement = (a, theta, b, E_star, G_star, mu) => {
  if (((a > 1e-30) && (a < 1e+30) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (E_star > 1e-30) && (E_star < 1e+30) && (G_star > 1e-30) && (G_star < 1e+30) && (mu > 1e-30) && (mu < 1e+30) && (b <= a))) {
    return ((mu * (E_star / G_star)) * ((Math.tan(theta) * a) * Math.atan((Math.sqrt(((a - b) * (a + b))) / b))));
  }
  return _full_slip_displacement_of_truncated_cone(a, theta, b, E_star, G_star, mu);
};

const full_slip_displacement = (a, theta, b, E_star, G_star, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < E_star && E_star < Infinity) && (0.0 < G_star && G_star < Infinity) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return ((a >= 0.0) ? _full_slip_displacement(a, theta, b, E_star, G_star, mu) : NaN);
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

const _depth_at_2 = (a, root, theta, b, k) => {
  return (flank_depth(a, root, b, k) * Math.tan(theta));
};

const _depth_3 = (a, theta, b, k) => {
  return ((a >= b) ? _depth_at_2(a, difference_root(a, b), theta, b, k) : NaN);
};

const depth_2 = (a, theta, b, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  if ((!(a >= b))) {
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

const _force_at_2 = (a, root, theta, b, H, k) => {
  let growth;
  growth = (flank_force(a, root, b, k) * Math.tan(theta));
  return (((2.0 * H) / (1.0 + k)) * growth);
};

const _force_3 = (a, theta, b, H, k) => {
  return ((a >= b) ? _force_at_2(a, difference_root(a, b), theta, b, H, k) : NaN);
};

const force_2 = (a, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return ((a >= 0.0) ? _force_3(a, theta, b, H, k) : NaN);
};

const _tame = (t, root, k) => {
  return Math.pow((root / t), (1.0 - k));
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

const growth_beyond_of_pressure = (slope, r, a, b, k, order = 0.0) => {
  let at, reach, scale, smooth, value, within;
  [within, scale, reach] = _branches_of_pressure(r, a, b, (order + (2.0 * k)), (r - b), (a - b));
  smooth = (near, far) => {
    let root, t;
    root = math.where(within, near, far);
    t = math.hypot(b, root);
    return (slope(t, root) * Math.pow((far / t), k));
  };
  value = math.where((reach > 0.0), _from_branch(smooth, scale, reach, k), 0.0);
  at = ((r === b) & (reach > 0.0));
  return (Boolean(at) ? math.where(at, growth_from_break(slope, math.where(at, reach, b), b, k, order), value) : value);
};

const _cornered = (value, r, a, b, k) => {
  return math.where((((r === b) & (a > b)) & (k <= 0.0)), Infinity, value);
};

const flank_pressure = (r, a, b, k) => {
  let slope;
  slope = (t, root) => {
    return ((_tame(t, root, k) * sine_integral(Math.atan2(root, b), k)) + (b / t));
  };
  return _cornered(growth_beyond_of_pressure(slope, r, a, b, k), r, a, b, k);
};

const _pressure_4 = (r, a, theta, b, H, k) => {
  let growth, inside;
  inside = math.minimum(r, a);
  growth = (flank_pressure(inside, a, b, k) * Math.tan(theta));
  return math.where((a >= b), math.where((r < a), ((H / Math.PI) * growth), 0.0), NaN);
};

const pressure_2 = (r, a, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0)) ? ((r < Infinity) ? _pressure_4(r, a, theta, b, H, k) : 0.0) : NaN);
};

const _Break = (b, root, more, end = Infinity) => math.record({ b, root, more, end });

const _break_at = (r, a, b) => {
  return _Break(b, difference_root(a, b), ((b - r) * (b + r)));
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

const flank_displacement = (r, a, b, k) => {
  let at;
  at = _break_at(r, a, b);
  return _broken(((s, z) => (a * (a / (a + s)))), ((_) => (at.root * (at.root / (a + b)))), r, a, k, at);
};

const _displacement_4 = (r, a, theta, b, k) => {
  return (flank_displacement(r, a, b, k) * Math.tan(theta));
};

const displacement_2 = (r, a, theta, b, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  if ((!(a >= b))) {
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
  if (((a > 1e-30) && (a < 1e+30) && (H > 1e-30) && (H < 1e+30) && (k > 1e-30) && (k < 1.0) && (theta > 1e-30) && (theta < 1.5707963267948966) && (b > 1e-30) && (b < 1e+30) && (b <= a))) {
    return (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  }
  return _stiffness_3(a, H, k);
};

const stiffness_of_truncated_cone = (a, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return ((a >= 0.0) ? _stiffness_2(a, H, k) : NaN);
};

const _mean_pressure_2 = (a, theta, b, H, k) => {
  return (_force_3(a, theta, b, H, k) / ((Math.PI * a) * a));
};

const mean_pressure_of_truncated_cone = (a, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return ((a >= 0.0) ? _mean_pressure_2(a, theta, b, H, k) : NaN);
};

const flank_rate = (t, root, b, k) => {
  return ((t < b) ? 0.0 : (sine_integral(Math.atan2(root, b), k) + ((b / t) * Math.pow((root / t), (k - 1.0)))));
};

const _rate_at = (a, root, theta, b, k) => {
  return (flank_rate(a, root, b, k) * Math.tan(theta));
};

const SLACK_of_inverse = 1e-06;

const contact_beyond = (load, rate, value, b, needs, exponents) => {
  let curve, first, last, unit, unknown, x;
  [first, last] = exponents;
  value = (value + math.zeros(1));
  unknown = beyond_edge(b, first, last);
  curve = (x) => {
    let a, own, root, slope, t;
    [t, slope] = root_of(x, first, last);
    [a, root] = [math.hypot(b, (b * t)), (b * t)];
    own = load(a, root, ...needs);
    return [own, ((((root * (root / a)) * rate(a, root, ...needs)) / own) / slope)];
  };
  unit = (unknown.of((b * Math.sqrt(2.0))) * math.ones_like(value));
  x = inverse(curve, value, (unit * (value / curve(unit)[0])), [SLACK_of_inverse, Infinity], undefined, undefined, true);
  return [unknown.back(x)[0], (b * root_of(x, first, last)[0])];
};

const _contact_from_depth_of_truncated_cone = (d, theta, b, k) => {
  return contact_beyond(_depth_at_2, _rate_at, d, b, [theta, b, k], [(1.0 + k), 1.0]);
};

const _radius_from_depth_2 = (d, theta, b, k) => {
  return _contact_from_depth_of_truncated_cone(d, theta, b, k)[0];
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

const _contact_from_force_of_truncated_cone = (F, theta, b, H, k) => {
  return contact_beyond(_force_at_2, _force_rate_at, F, b, [theta, b, H, k], [(1.0 + k), (2.0 + k)]);
};

const _radius_from_force_2 = (F, theta, b, H, k) => {
  return _contact_from_force_of_truncated_cone(F, theta, b, H, k)[0];
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

const _force_from_depth_of_truncated_cone = (d, theta, b, H, k) => {
  let a, root;
  [a, root] = _contact_from_depth_of_truncated_cone(d, theta, b, k);
  return (_force_at_2(a, root, theta, b, H, k) + punch_force((d - _depth_at_2(a, root, theta, b, k)), a, H, k));
};

const force_from_depth_of_truncated_cone = (d, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((d >= 0.0) ? _force_from_depth_of_truncated_cone(d, theta, b, H, k) : NaN);
};

const punch_depth = (F, a, H, k) => {
  let v14;
  v14 = (((2.0 * H) / (1.0 + k)) * ((a > 0.0) ? (a * Math.pow(a, k)) : 0.0));
  if (((v14 > 0.0) && (v14 < Infinity))) {
    return (F / v14);
  }
  return 0.0;
};

const _depth_from_force_of_truncated_cone = (F, theta, b, H, k) => {
  let a, root;
  [a, root] = _contact_from_force_of_truncated_cone(F, theta, b, H, k);
  return (_depth_at_2(a, root, theta, b, k) + punch_depth((F - _force_at_2(a, root, theta, b, H, k)), a, H, k));
};

const depth_from_force_of_truncated_cone = (F, theta, b, H, k) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0)))) {
    return NaN;
  }
  return ((F >= 0.0) ? _depth_from_force_of_truncated_cone(F, theta, b, H, k) : NaN);
};

const graded_retraction = (a, H, k, dgamma) => {
  if ((a > 0.0)) {
    return ((math.sqrt(((6.283185307179586 * dgamma) / H)) * math.sqrt(a)) * math.sqrt(Math.pow(a, (-k))));
  }
  return 0.0;
};

const retraction_of_truncated_cone = (a, H, k, dgamma) => {
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
  if ((!(a >= b))) {
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
  if ((!(a >= b))) {
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
  if ((!(a >= b))) {
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
  if ((!(a >= b))) {
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

const _rate_of_truncated_cone = (a, theta, b, k) => {
  return ((a >= b) ? _rate_at(a, difference_root(a, b), theta, b, k) : NaN);
};

const _samples_of_truncated_cone = (theta, b, k) => {
  let a;
  a = radii_beyond(b);
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

const _branches_of_truncated_cone = (theta, b, H, k, dgamma, control) => {
  return branches(((a) => (Math.pow(a, ((1.0 + k) / 2.0)) * _rate_of_truncated_cone(a, theta, b, k))), _samples_of_truncated_cone(theta, b, k), least_steepness_of_punch(control, H, k, dgamma));
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
  found = _branches_of_truncated_cone(theta, b, H, k, dgamma, 'depth');
  slope = growth_of(_rate_of_truncated_cone, [theta, b, k], H, k, dgamma, 'depth');
  pulled = pull_of(H, k, dgamma, 'depth');
  radius = stable_radius(d, found, ((a) => _depth_4(a, theta, b, H, k, dgamma)), slope, pulled, radius_itself(), beyond_edge(b, (1.0 + k)));
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
  found = _branches_of_truncated_cone(theta, b, H, k, dgamma, 'force');
  slope = growth_of(_rate_of_truncated_cone, [theta, b, k], H, k, dgamma, 'force');
  pulled = pull_of(H, k, dgamma, 'force');
  radius = stable_radius(F, found, ((a) => _force_4(a, theta, b, H, k, dgamma)), slope, pulled, radius_itself(), beyond_edge(b, (1.0 + k)));
  return math.ldexp(radius, unit);
};

const radius_from_force_3 = (F, theta, b, H, k, dgamma) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  return _radius_from_force_3(F, theta, b, H, k, dgamma);
};

const _pull_off_radius_of_truncated_cone = (theta, b, H, k, dgamma, control) => {
  let found, load, radius, stress, unit;
  unit = exponent_of(b);
  [stress, H] = stress_at(unit, H, k);
  b = math.ldexp(b, (-unit));
  dgamma = math.ldexp(dgamma, (-(stress + unit)));
  found = _branches_of_truncated_cone(theta, b, H, k, dgamma, control);
  load = ((control === 'force') ? _force_4 : _depth_4);
  radius = math.lowest(found, ((a) => load(a, theta, b, H, k, dgamma)));
  return math.ldexp(radius, unit);
};

const pull_off_of_truncated_cone = (control = 'force', theta, b, H, k, dgamma) => {
  let depth, force, radius;
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= dgamma && dgamma < Infinity)))) {
    return NaN;
  }
  radius = _pull_off_radius_of_truncated_cone(theta, b, H, k, dgamma, control);
  force = ((radius >= 0.0) ? _force_4(radius, theta, b, H, k, dgamma) : NaN);
  depth = ((radius >= 0.0) ? _depth_4(radius, theta, b, H, k, dgamma) : NaN);
  return PullOff(radius, force, depth);
};

const CLOSE_of_slip = 0.25;

const _close = (m, c, a) => {
  let inner;
  inner = difference_root(c, m);
  return ((inner > 0.0) & (inner >= (CLOSE_of_slip * difference_root(a, m))));
};

const _weight = (quantity, t, y, k) => {
  if ((quantity === 'depth')) {
    return 1.0;
  }
  return ((quantity === 'force') ? (t * Math.pow(t, k)) : (Math.pow(y, k) / y));
};

const _span = (c, a, distance) => {
  if ((a > c)) {
    return (0.5 * math.log1p((((a - c) / distance) * ((a + c) / distance))));
  }
  return 0.0;
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
  return (math.truth(holds) ? math.integral_in_strip(integrand, (math.truth(holds) ? _span(c, a, start) : 0.0)) : 0.0);
};

const _difference = (quantity, whole, lengths, b, r, c, a, k) => {
  if ((quantity === 'pressure')) {
    return (whole(r, a, ...lengths, k) - whole(r, c, ...lengths, k));
  }
  return (whole(a, difference_root(a, b), ...lengths, k) - whole(c, difference_root(c, b), ...lengths, k));
};

const either = (condition, x, y) => {
  if (Boolean(condition)) {
    return x();
  }
  return (Boolean(condition) ? (math.truth(condition) ? x() : y()) : y());
};

const beyond_gain = (quantity, whole, rate, lengths, r, c, a, k) => {
  let b, close;
  [b] = lengths;
  close = _close(math.maximum(r, b), c, a);
  return either(close, (() => _grown(quantity, ((t, root) => rate(t, root, ...lengths, k)), r, c, a, b, k, close)), (() => _difference(quantity, whole, lengths, b, r, c, a, k)));
};

const _tangential_force_2 = (a, c, theta, b, H, k, mu) => {
  let gain;
  gain = (beyond_gain('force', flank_force, flank_rate, [b], 0.0, c, a, k) * Math.tan(theta));
  return math.where((c >= b), ((mu * ((2.0 * H) / (1.0 + k))) * gain), NaN);
};

const tangential_force_of_truncated_cone = (a, c, theta, b, H, k, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
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
    return (beyond_gain('pressure', flank_pressure, flank_rate, [b], inside, c, a, k) * Math.tan(theta));
  };
  return math.where((c >= b), (mu * either((r < c), (() => ((H / Math.PI) * gain())), (() => _pressure_4(r, a, theta, b, H, k)))), NaN);
};

const traction_of_truncated_cone = (r, a, c, theta, b, H, k, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((r >= 0.0) && (a >= 0.0) && (c >= 0.0)) ? ((r < Infinity) ? _traction_2(r, a, c, theta, b, H, k, mu) : 0.0) : NaN);
};

const _tangential_displacement_2 = (a, c, theta, b, H, H_x, k, mu) => {
  let gain;
  gain = (beyond_gain('depth', flank_depth, flank_rate, [b], 0.0, c, a, k) * Math.tan(theta));
  return math.where((c >= b), ((mu * (H / H_x)) * gain), NaN);
};

const tangential_displacement_of_truncated_cone = (a, c, theta, b, H, H_x, k, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  if ((!(!(c > a)))) {
    return NaN;
  }
  return (((a >= 0.0) && (c >= 0.0)) ? _tangential_displacement_2(a, c, theta, b, H, H_x, k, mu) : NaN);
};

const _stick_radius_of_truncated_cone = (F_x, a, theta, b, H, k, mu) => {
  let F;
  F = stick_force(_force_3(a, theta, b, H, k), F_x, mu);
  return (((F_x === 0.0) & (a >= 0.0)) ? a : _radius_from_force_2(F, theta, b, H, k));
};

const stick_radius_of_truncated_cone = (F_x, a, theta, b, H, k, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
    return NaN;
  }
  return (((F_x >= 0.0) && (a >= 0.0)) ? _stick_radius_of_truncated_cone(F_x, a, theta, b, H, k, mu) : NaN);
};

const _full_slip_displacement_2 = (a, theta, b, H, H_x, k, mu) => {
  return ((mu * (H / H_x)) * _depth_3(a, theta, b, k));
};

const full_slip_displacement_of_truncated_cone = (a, theta, b, H, H_x, k, mu) => {
  if ((!((0.0 < theta && theta < 1.5707963267948966) && (0.0 < b && b < Infinity) && (0.0 < H && H < Infinity) && (0.0 < H_x && H_x < Infinity) && (-1.0 < k && k < 1.0) && (0.0 <= mu && mu < Infinity)))) {
    return NaN;
  }
  if ((!(a >= b))) {
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

const once = { pull_off: math.kept(pull_off), pull_off_of_truncated_cone: math.kept(pull_off_of_truncated_cone) };
const formulas = {
  "d": (v) => depth(v.a, v.theta, v.b),
  "F": (v) => force(v.a, v.theta, v.b, v.E_star),
  "p": (v) => pressure(v.r, v.a, v.theta, v.b, v.E_star),
  "w": (v) => displacement(v.r, v.a, v.theta, v.b),
  "k": (v) => stiffness(v.a, v.theta, v.b, v.E_star),
  "pm": (v) => mean_pressure(v.a, v.theta, v.b, v.E_star),
  "U": (v) => energy(v.a, v.theta, v.b, v.E_star),
  "Fr": (v) => load_within(v.r, v.a, v.theta, v.b, v.E_star),
  "ad": (v) => radius_from_depth(v.d, v.theta, v.b),
  "aF": (v) => radius_from_force(v.F, v.theta, v.b, v.E_star),
  "Fd": (v) => force_from_depth(v.d, v.theta, v.b, v.E_star),
  "dF": (v) => depth_from_force(v.F, v.theta, v.b, v.E_star),
  "adh.Dl": (v) => retraction(v.a, v.E_star, v.dgamma),
  "adh.d": (v) => depth_of_truncated_cone(v.a, v.theta, v.b, v.E_star, v.dgamma),
  "adh.F": (v) => force_of_truncated_cone(v.a, v.theta, v.b, v.E_star, v.dgamma),
  "adh.p": (v) => pressure_of_truncated_cone(v.r, v.a, v.theta, v.b, v.E_star, v.dgamma),
  "adh.w": (v) => displacement_of_truncated_cone(v.r, v.a, v.theta, v.b, v.E_star, v.dgamma),
  "adh.ad": (v) => radius_from_depth_of_truncated_cone(v.d, v.theta, v.b, v.E_star, v.dgamma),
  "adh.aF": (v) => radius_from_force_of_truncated_cone(v.F, v.theta, v.b, v.E_star, v.dgamma),
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
  "fgm.k": (v) => stiffness_of_truncated_cone(v.a, v.theta, v.b, v.H, v.k),
  "fgm.pm": (v) => mean_pressure_of_truncated_cone(v.a, v.theta, v.b, v.H, v.k),
  "fgm.ad": (v) => radius_from_depth_2(v.d, v.theta, v.b, v.k),
  "fgm.aF": (v) => radius_from_force_2(v.F, v.theta, v.b, v.H, v.k),
  "fgm.Fd": (v) => force_from_depth_of_truncated_cone(v.d, v.theta, v.b, v.H, v.k),
  "fgm.dF": (v) => depth_from_force_of_truncated_cone(v.F, v.theta, v.b, v.H, v.k),
  "fgm.adh.Dl": (v) => retraction_of_truncated_cone(v.a, v.H, v.k, v.dgamma),
  "fgm.adh.d": (v) => depth_3(v.a, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.F": (v) => force_3(v.a, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.p": (v) => pressure_3(v.r, v.a, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.w": (v) => displacement_3(v.r, v.a, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.ad": (v) => radius_from_depth_3(v.d, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.aF": (v) => radius_from_force_3(v.F, v.theta, v.b, v.H, v.k, v.dgamma),
  "fgm.adh.ac": (v) => (once.pull_off_of_truncated_cone('force', v.theta, v.b, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fc": (v) => (once.pull_off_of_truncated_cone('force', v.theta, v.b, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dc": (v) => (once.pull_off_of_truncated_cone('force', v.theta, v.b, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.adh.am": (v) => (once.pull_off_of_truncated_cone('depth', v.theta, v.b, v.H, v.k, v.dgamma).radius ?? NaN),
  "fgm.adh.Fm": (v) => (once.pull_off_of_truncated_cone('depth', v.theta, v.b, v.H, v.k, v.dgamma).force ?? NaN),
  "fgm.adh.dm": (v) => (once.pull_off_of_truncated_cone('depth', v.theta, v.b, v.H, v.k, v.dgamma).depth ?? NaN),
  "fgm.tan.F": (v) => tangential_force_of_truncated_cone(v.a, v.c, v.theta, v.b, v.H, v.k, v.mu),
  "fgm.tan.tau": (v) => traction_of_truncated_cone(v.r, v.a, v.c, v.theta, v.b, v.H, v.k, v.mu),
  "fgm.tan.u": (v) => tangential_displacement_of_truncated_cone(v.a, v.c, v.theta, v.b, v.H, v.H_x, v.k, v.mu),
  "fgm.tan.c": (v) => stick_radius_of_truncated_cone(v.F_x, v.a, v.theta, v.b, v.H, v.k, v.mu),
  "fgm.tan.us": (v) => full_slip_displacement_of_truncated_cone(v.a, v.theta, v.b, v.H, v.H_x, v.k, v.mu),
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
   "value": 0.05
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
   "value": 0.0005
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
   "value": 500.0
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
