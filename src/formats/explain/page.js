'use strict';
const f = Math.fround, names = ['ambient', 'diffuse', 'highlight', 'clamp', 'reflection', 'transmission', 'emission'];
const $ = id => document.getElementById(id);

// ── Formulas: read once, evaluated in single precision, channel by channel ──────────────────────────────────
const each = (a, b, op) => Array.isArray(a) || Array.isArray(b)
  ? [0, 1, 2].map(i => f(op(Array.isArray(a) ? a[i] : a, Array.isArray(b) ? b[i] : b))) : f(op(a, b));
const dot = (a, b) => f(f(f(a[0] * b[0]) + f(a[1] * b[1])) + f(a[2] * b[2]));
const times = (a, b) => Array.isArray(a) && Array.isArray(b) ? dot(a, b) : each(a, b, (x, y) => x * y);
const one = x => Math.max(-1, Math.min(1, x)), degrees = x => f(x * 180 / Math.PI);
const calls = {
  max: (a, b) => b === undefined ? Math.max(...a) : each(a, b, Math.max), min: (a, b) => each(a, b, Math.min),
  normalize: a => times(a, f(1 / f(Math.sqrt(dot(a, a))))),
  arccos: x => degrees(Math.acos(one(x))), arcsin: x => degrees(Math.asin(one(x))) };
const word = /^[\p{L}_\d₀-₉′]+²?/u, number = /^\d+(\.\d+)?/;

function reader(formula) { // "a + b · c" → a function of what looks symbols up
  let rest = formula;
  const take = s => rest.startsWith(s) ? (rest = rest.slice(s.length), true) : false;
  const spaced = s => { const before = rest; rest = rest.trimStart(); if (!take(s)) { rest = before; return false; }
    rest = rest.trimStart(); return true; };
  const joined = (next, ops) => { let left = next();
    for (;;) { const sign = Object.keys(ops).find(spaced); if (!sign) return left;
      const a = left, b = next(), op = ops[sign]; left = at => op(a(at), b(at)); } };
  const sum = () => joined(product, { '+': (a, b) => each(a, b, (x, y) => x + y), '−': (a, b) => each(a, b, (x, y) => x - y) });
  const product = () => joined(signed, { '·': times, '⊙': (a, b) => each(a, b, (x, y) => x * y), '/': (a, b) => each(a, b, (x, y) => x / y) });
  const signed = () => { if (!spaced('−')) return power(); const x = signed(); return at => each(x(at), -1, (a, b) => a * b); };
  const power = () => { const x = atom(); return take('²') ? at => each(x(at), x(at), (a, b) => a * b) : x; };
  const atom = () => {
    if (take('(')) { const x = sum(); spaced(')'); return x; }
    if (take('|')) { const x = sum(); spaced('|'); return at => f(Math.sqrt(dot(x(at), x(at)))); }
    if (take('√(')) { const x = sum(); spaced(')'); return at => f(Math.sqrt(x(at))); }
    const digits = rest.match(number);
    if (digits) { take(digits[0]); const x = f(+digits[0]); return () => x; }
    const name = rest.match(word)[0], bare = name.replace('²', '');
    if (calls[bare] && rest[bare.length] === '(') {
      take(bare + '('); const inputs = [sum()]; while (spaced(',')) inputs.push(sum()); spaced(')');
      return at => calls[bare](...inputs.map(x => x(at))); }
    take(bare); // r² is a quantity of its own, where there is one
    if (name !== bare && squares.has(name)) { take('²'); return at => at(name); }
    return at => at(bare); };
  return sum();
}

// ── The data: shapes of rays, and the numbers of each ────────────────────────────────────────────────────────
let page, ints, floats, starts = [], squares = new Set();
const formulas = new Map();
const read = formula => formulas.get(formula) || formulas.set(formula, reader(formula)).get(formula);
async function unpack() {
  const packed = Uint8Array.from(atob($('data').textContent), c => c.charCodeAt(0));
  const bytes = new Uint8Array(await new Response(new Blob([packed]).stream()
    .pipeThrough(new DecompressionStream('deflate'))).arrayBuffer());
  const view = new DataView(bytes.buffer), sizes = [0, 4, 8].map(at => view.getUint32(at, true));
  let at = 12;
  page = JSON.parse(new TextDecoder().decode(bytes.subarray(at, at + sizes[0])));
  at += sizes[0];
  const planes = count => { const out = new Uint8Array(4 * count);
    for (let b = 0; b < 4; ++b) for (let i = 0; i < count; ++i) out[4 * i + b] = bytes[at + b * count + i];
    at += 4 * count; return out.buffer; };
  ints = new Uint32Array(planes(sizes[1]));
  floats = new Float32Array(planes(sizes[2]));
  for (const step of page.steps) if (step[0].endsWith('²')) squares.add(step[0]);
  for (let i = 0, k = 0, v = 0; i < page.columns * page.rows; ++i) {
    starts.push([k, v]);
    const count = ints[k++]; v += 24;
    for (let n = 0; n < count; ++n, k += 4) v += page.shapes[ints[k]].size + ((ints[k + 2] & 1) + (ints[k + 2] >> 1)) * 3;
  }
}

/// The rays of a pixel, with functions that give their quantities.
function rays_of(column, row) {
  let [k, v] = starts[row * page.columns + column];
  const next = vector => vector ? [floats[v++], floats[v++], floats[v++]] : floats[v++];
  const asked = page.pixel && column === page.first[0] && row === page.first[1] ? page.pixel : null;
  const pixel = { x: asked ? asked[0] : Math.floor((2 * column + 1) * page.width / (2 * page.columns)),
                  y: asked ? asked[1] : Math.floor((2 * row + 1) * page.height / (2 * page.rows)),
                  color: next(true), terms: names.map(() => next(true)), rays: [] };
  for (let count = ints[k++]; count > 0; --count, k += 4) {
    const ray = { shape: page.shapes[ints[k]], parent: ints[k + 1] - 1, left_out: ints[k + 3], brought: {}, known: new Map() };
    const take = (list, known) => { for (const [step, mode, value] of list)
      if (mode === 1) known.set(page.steps[step][0], next(page.steps[step][2]));
      else if (mode === 2) known.set(page.steps[step][0], page.constants[value]); };
    take(ray.shape.steps, ray.known);
    ray.lights = ray.shape.lights.map(shape => { const known = new Map();
      const light = { shape, known, distances: shape.blockers.map(() => next(false)) }; take(shape.steps, known); return light; });
    if (ints[k + 2] & 1) ray.brought.L_R = next(true);
    if (ints[k + 2] & 2) ray.brought.L_T = next(true);
    if (ray.parent >= 0) pixel.rays[ray.parent][ray.shape.kind] = ray;
    ray.up = pixel.rays[ray.parent];
    pixel.rays.push(ray);
  }
  for (const ray of pixel.rays) {
    ray.at = symbol => value(ray.shape.steps, ray.known, ray.at, symbol, step => linked(ray, step));
    for (const light of ray.lights) light.at = symbol =>
      light.shape.steps.some(s => page.steps[s[0]][0] === symbol) ? value(light.shape.steps, light.known, light.at, symbol) : ray.at(symbol);
  }
  return pixel;
}
function value(list, known, at, symbol, link) {
  if (!known.has(symbol)) {
    const step = list.find(s => page.steps[s[0]][0] === symbol);
    if (!step) throw new Error('no ' + symbol);
    known.set(symbol, step[1] === 3 ? link(step) : widened(read(page.steps[step[0]][1])(at), page.steps[step[0]][2]));
  }
  return known.get(symbol);
}
const widened = (x, vector) => vector && !Array.isArray(x) ? [x, x, x] : x;
/// What another ray or a light of this one knows.
function linked(ray, [step, , index]) {
  const symbol = page.steps[step][0], mirror = ray.shape.kind === 'reflected';
  if (symbol === 'd') return ray.up.at(mirror ? 'R' : 'T');
  if (symbol === 'W') return ray.up.at(mirror ? 'W_R' : 'W_T');
  if (symbol === 'L_R') return ray.brought.L_R || ray.reflected.at('L');
  if (symbol === 'L_T') return ray.brought.L_T || ray.refracted.at('L');
  const light = ray.lights[index], own = symbol[0];
  return light.shape.steps.some(s => page.steps[s[0]][0] === own) ? light.at(own) : [0, 0, 0];
}

// ── Showing ──────────────────────────────────────────────────────────────────────────────────────────────────
const short = x => Array.isArray(x) ? '(' + x.map(short).join(', ') + ')'
  : x === Infinity ? '∞' : String(+x.toPrecision(6)).replace('-', '−');
const plain = x => x[0] === x[1] && x[1] === x[2] ? short(x[0]) : short(x); // of a colour without a hue
const encoded = x => x <= 0 ? 0 : x >= 1 ? 255 : Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
const web = c => `rgb(${c.map(encoded).join(', ')})`;
function el(tag, look, ...inside) { const e = document.createElement(tag); if (look) e.className = look; e.append(...inside); return e; }
function swatch(c) { const e = el('span', 'swatch'); e.style.background = web(c); return e; }
function details(summary, fill) { // filled when it is opened
  const d = el('details', '', el('summary', '', ...summary));
  d.addEventListener('toggle', () => { if (d.open && d.children.length === 1) d.append(...fill()); });
  return d;
}
/// The formula with its numbers for its symbols.
function filled(formula, at) {
  return formula.replace(/[\p{L}_][\p{L}_\d₀-₉′]*²?/gu, name => {
    for (const s of [name, name.replace('²', '')]) {
      if (calls[s] || (name !== s ? false : s.endsWith('²') && !squares.has(s))) continue;
      try { const x = short(at(s)); return (x.startsWith('−') ? '(' + x + ')' : x) + name.slice(s.length); } catch { continue; }
    }
    return name; });
}
function step_rows(list, at) {
  return list.filter(s => page.steps[s[0]][1]).map(s => {
    const [symbol, formula, , meaning, section, note] = page.steps[s[0]];
    const result = short(at(symbol)), numbers = filled(formula, at);
    const row = el('div', 'step', el('b', '', symbol), formula === result ? '' : ' = ' + formula);
    if (numbers !== formula && numbers !== result) row.append(' ', el('span', 'numbers', '= ' + numbers));
    row.append(' = ', el('b', '', result), ' ', el('span', 'note', meaning + ' '));
    if (section) row.append(el('span', 'section', '§ ' + section));
    if (note) row.append(el('div', 'note', note));
    return row; });
}
function light_row(light) {
  const { label, blockers } = light.shape, at = light.at;
  const has = s => light.shape.steps.some(t => page.steps[t[0]][0] === s);
  let text = label + (has('θ') ? ': ' + short(+at('θ').toPrecision(3)) + '°' : '');
  if (!has('s')) text += ', nothing arrives';
  else if (at('s') === 0) text += ', in the shadow of ' + blockers.find(b => !b[2])[0];
  else text += blockers.length ? ', ' + short(at('s')) + ' gets through' : ', arrives whole';
  return details([el('span', 'light', text)], () => [
    ...blockers.map((b, i) => el('div', 'step', `at ${short(light.distances[i])}: ${b[0]} (${b[1]})` + (b[2] ? ', passed over' : ''))),
    ...step_rows(light.shape.steps, at)]);
}
function ray_box(ray, wanted) {
  const s = ray.shape, at = ray.at, has = symbol => s.steps.some(t => page.steps[t[0]][0] === symbol);
  const box = el('div', 'ray ' + s.kind, el('div', 'head', swatch(at('L')), el('span', 'kind', s.kind + ' ray'),
    s.label ? ' → ' + s.label : '', ' = ', short(at('L'))));
  if (s.label) box.append(el('div', 'faint', `material ${s.material}, from ${s.side}, distance ${short(at('t'))}, weight ${plain(at('W'))}`));
  if (s.inside.length) box.append(el('div', 'faint', 'inside ' + s.inside.join(', within ')));
  for (const label of s.passed_over) box.append(el('div', 'faint', 'passes over ' + label + ': hidden inside a solid that owns the space'));
  if (has('θ₁')) box.append(el('div', 'faint', `index ${short(at('n₁'))} → ${short(at('n₂'))}: ${short(+at('θ₁').toPrecision(3))}° → ` +
    (has('θ₂') ? short(+at('θ₂').toPrecision(3)) + '°' : 'total reflection') + (has('θ_c') ? `, critical angle ${short(+at('θ_c').toPrecision(3))}°` : '')));
  for (const light of ray.lights) box.append(light_row(light));
  for (const name of names) if (has(name)) {
    const term = at(name);
    if (term.some(x => x !== 0)) box.append(el('div', '', swatch(term.map(Math.abs)), name + ' ' + short(term))); }
  box.append(details([el('span', 'faint', 'every step')], () => step_rows(s.steps, at)));
  if (s.end !== 'bounced') box.append(el('div', 'faint', s.why));
  for (const kind of ['reflected', 'refracted']) if (ray[kind]) { // rays that matter little are folded
    const next = ray[kind], weight = Math.max(...next.at('W'));
    if (weight >= 0.01) { box.append(ray_box(next)); continue; }
    box.append(el('details', 'light-weight', el('summary', '', swatch(next.at('L')), el('span', 'faint',
      `${kind} ray${next.shape.label ? ' → ' + next.shape.label : ''}, weight ${short(+weight.toPrecision(2))}`)), ray_box(next))); }
  if (ray.left_out) box.append(el('div', 'faint', `+ ${ray.left_out} rays that bring little are left out here; glint explain has them`));
  return box;
}

// ── Layers and moving over the picture ───────────────────────────────────────────────────────────────────────
const on = names.map(() => true), linear = Float32Array.from({ length: 256 }, (_, i) =>
  i / 255 <= 0.04045 ? i / 255 / 12.92 : ((i / 255 + 0.055) / 1.055) ** 2.4);
let shown = null, pinned = false, layers = null;
const boxes = names.map((name, i) => {
  const box = el('input'), label = el('label', '', box, name, el('output'));
  box.type = 'checkbox'; box.checked = true; box.id = 'layer-' + name;
  box.addEventListener('change', () => { on[i] = box.checked; paint(); tell_layers(); });
  return label; });
async function pixels(id) { const image = $(id); await image.decode();
  const c = el('canvas'); c.width = image.naturalWidth; c.height = image.naturalHeight;
  const context = c.getContext('2d'); context.drawImage(image, 0, 0); return context.getImageData(0, 0, c.width, c.height); }
async function paint() {
  const context = $('canvas').getContext('2d');
  if (on.every(x => x)) return context.putImageData(await pixels('final'), 0, 0);
  layers = layers || await Promise.all(names.map(name => $('png-' + name) ? pixels('png-' + name) : null));
  const out = context.createImageData(page.width, page.height);
  for (let i = 0; i < out.data.length; ++i) {
    if (i % 4 === 3) { out.data[i] = 255; continue; }
    let sum = 0;
    layers.forEach((layer, n) => { if (layer && on[n]) sum += (names[n] === 'clamp' ? -1 : 1) * linear[layer.data[i]]; });
    out.data[i] = encoded(sum); }
  context.putImageData(out, 0, 0);
}
/// The sum of the terms that are switched on, in the order in which they make the picture.
const sum_shown = pixel => pixel.terms.reduce((sum, t, i) => on[i] ? (sum ? each(sum, t, (a, b) => a + b) : t) : sum, null) || [0, 0, 0];
function tell_layers() {
  boxes.forEach((label, i) => { label.lastChild.textContent = shown ? short(shown.terms[i]) : ''; });
  if (!shown) return;
  const sum = sum_shown(shown), all = on.every(x => x);
  $('pixel').replaceChildren(el('div', 'head', swatch(sum), `pixel ${shown.x},${shown.y} = `, short(shown.color)),
    el('div', 'faint', (all ? '' : 'shown terms: ' + short(sum) + '; ') + page.rule +
      (page.samples > 1 ? '; the rays are those of sample 0' : '') + (pinned ? ' — pinned, click to release' : '')),
    ...(page.gpu ? [el('div', 'faint', on_gpu(shown))] : []));
}
/// What a graphics card makes of the pixel.
function on_gpu(pixel) {
  const at = 3 * (pixel.row * page.columns + pixel.column), color = page.gpu.colors.slice(at, at + 3).map(f);
  const off = Math.max(...color.map((x, i) => Math.abs(x - pixel.color[i])));
  return `on ${page.gpu.device} it is ${short(color)}, off by at most ${+off.toPrecision(3)}`;
}
function show(column, row) {
  shown = rays_of(column, row);
  shown.column = column; shown.row = row;
  const mark = $('mark').style;
  mark.display = 'block';
  mark.left = 100 * column / page.columns + '%'; mark.top = 100 * row / page.rows + '%';
  mark.width = 100 / page.columns + '%'; mark.height = 100 / page.rows + '%';
  tell_layers();
  $('rays').replaceChildren(ray_box(shown.rays[0]));
}
function under(event) {
  const r = $('canvas').getBoundingClientRect(), cell = (x, n) => Math.max(0, Math.min(n - 1, Math.floor(x * n)));
  return [cell((event.clientX - r.left) / r.width, page.columns), cell((event.clientY - r.top) / r.height, page.rows)];
}
const ready = unpack().then(() => {
  $('canvas').width = page.width; $('canvas').height = page.height;
  $('layers').append(...boxes.filter((_, i) => $('png-' + names[i])));
  $('picture').addEventListener('mousemove', e => { const [c, r] = under(e);
    if (!pinned && !(shown && shown.column === c && shown.row === r)) show(c, r); });
  $('picture').addEventListener('click', e => { pinned = !pinned; show(...under(e)); });
  document.addEventListener('keydown', e => { const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[e.key];
    if (!way || !shown || e.target.tagName === 'INPUT') return;
    e.preventDefault();
    const within = (x, n) => Math.max(0, Math.min(n - 1, x));
    show(within(shown.column + way[0], page.columns), within(shown.row + way[1], page.rows)); });
  pinned = page.pixel !== null;
  show(...page.first);
  return paint();
});
