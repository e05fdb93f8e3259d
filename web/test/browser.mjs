// The page against a running server: node test/browser.mjs ADDRESS [FLOW …]. What a flow downloads is written to a folder of its name in STUDIO_FILES;
// STUDIO_PROCESS is the server's process, whose workers one flow ends.
import assert from 'node:assert/strict';
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { launch } from './launch.mjs';
import { serveDist } from './serve-dist.mjs';

const [address, ...wanted] = process.argv.slice(2);
const files = process.env.STUDIO_FILES ?? '/tmp/planish-studio-files';
let out = files; // of the flow that runs
const browser = await launch();

function killWorkers() {
  for (const entry of readdirSync('/proc').filter((name) => /^\d+$/.test(name))) {
    let line = '';
    try { line = readFileSync(`/proc/${entry}/cmdline`, 'utf8'); } catch { continue; }
    const [, command, server] = line.split('\0');
    if (command === 'studio-worker' && server === process.env.STUDIO_PROCESS) process.kill(Number(entry), 'SIGKILL');
  }
}

const state = (page, code) => page.evaluate(`(() => { const s = window.planish.store.state, views = window.planish.views; return ${code}; })()`);
const settled = (page) => page.waitForFunction(() => { const s = window.planish.store.state; return s.document && s.shape && !s.shapeIsDraft && !s.computing && s.past !== undefined; }, null, { timeout: 60000 });
const rested = async (page) => { await page.waitForTimeout(250); await settled(page); };

// What the tests wait for is evaluated in the page, which its policy forbids; one flow keeps the policy.
async function fresh(bypassCSP = true) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, acceptDownloads: true, bypassCSP });
  const page = await context.newPage(), said = [];
  page.on('console', (m) => { if (m.type() === 'error') said.push(m.text()); });
  page.on('pageerror', (e) => said.push(e.message));
  await serveDist(page, address);
  await page.goto(address);
  await page.waitForSelector('[data-testid=examples-menu]');
  await page.waitForTimeout(300);
  return { page, said, context };
}

async function example(page, name) {
  if (await page.locator(`[data-testid="example-${name}"]`).count()) {
    await page.click('[data-testid=examples-menu]');
    await page.click(`[data-testid="example-${name}"]`);
    await opened(page, name);
  } else await open(page, [new URL(`../../examples/${name}`, import.meta.url).pathname]);
}

async function open(page, paths) {
  await page.setInputFiles('[data-testid=file-input]', paths);
  await opened(page, paths[0]);
}

/** A slit file without its subdivisions, which take most of the time. */
function coarse(name) {
  const path = `${out}/${name}`;
  writeFileSync(path, JSON.stringify({ ...JSON.parse(readFileSync(new URL(`../../examples/slit/${name}`, import.meta.url), 'utf8')), subdivisions: 0 }));
  return path;
}

async function opened(page, path) {
  await page.waitForFunction((n) => window.planish.store.state.document?.name === n, path.split('/').at(-1));
  await rested(page);
}

/** Names of the documents that are open at the server. */
const openAtServer = (page) => page.evaluate(async () => (await (await fetch('/api/documents', { headers: { 'X-Planish-Token': location.hash.slice(1) } })).json()).map((d) => d.name));

async function download(page, format) {
  await page.click('[data-testid=download-menu]');
  const [file] = await Promise.all([page.waitForEvent('download'), page.click(`[data-testid="download-${format}"]`)]);
  const path = `${out}/${file.suggestedFilename()}`;
  await file.saveAs(path);
  return path;
}

async function drag(page, from, by, steps = 12) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let i = 1; i <= steps; ++i) {
    await page.mouse.move(from.x + (by.x * i) / steps, from.y + (by.y * i) / steps);
    await page.waitForTimeout(20);
  }
  await page.mouse.up();
}

async function enter(page, testid, text) {
  await page.fill(`[data-testid="${testid}"]`, text);
  await page.keyboard.press('Enter');
}

async function slide(page, testid, share) {
  await page.locator(`[data-testid="${testid}"]`).scrollIntoViewIfNeeded();
  const box = await page.locator(`[data-testid="${testid}"]`).boundingBox(), at = await page.$eval(`[data-testid="${testid}"]`, (e) => (e.value - e.min) / (e.max - e.min));
  const x = (s) => box.x + 8 + s * (box.width - 16);
  await drag(page, { x: x(at), y: box.y + box.height / 2 }, { x: x(share) - x(at), y: 0 });
}

function timings(name, list) {
  const of = (key) => { const v = list.map((t) => t[key]).filter((x) => x !== null).sort((a, b) => a - b); return v.length ? `${v[Math.floor(v.length / 2)].toFixed(1)} / ${v[Math.floor(0.95 * v.length)].toFixed(1)} ms` : '–'; };
  console.log(`   ${name}: ${list.length} drafts; to geometry ${of('toGeometry')}, to the frame ${of('toFrame')} (median / 95 %)`);
}

/** Evaluated in the page: what is cut off, or covers its neighbour, outside of the views. */
function untidy() {
  const said = [], name = (e) => `${e.tagName.toLowerCase()} ${e.dataset.testid ?? e.className} “${(e.value ?? e.textContent).trim().slice(0, 30)}”`;
  const shown = [...document.querySelectorAll('header *, .messages *, .fold *, .buttons *, aside *')].filter((e) => e.getClientRects().length && !(e instanceof SVGElement));
  for (const e of shown) {
    const r = e.getBoundingClientRect(), area = e.closest('header, .messages, .fold, .buttons, aside').getBoundingClientRect();
    if (r.left < area.left - 1 || r.right > area.right + 1) said.push(`${name(e)} leaves its area`);
    if (e.matches('button, dt, dd, td, th, input[type=text], h3, h4, summary, label > span') && e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0) said.push(`${name(e)} is cut off`);
  }
  for (const row of document.querySelectorAll('header, .messages, .fold, .buttons, .summary, .tabs, .field, .slider, .double, .triple, .row, .chips, .named, .new-plate, .point, .head')) {
    const boxes = [...row.children].map((e) => [e, e.getBoundingClientRect()]).filter(([, r]) => r.width && r.height);
    for (const [i, [a, p]] of boxes.entries()) for (const [b, q] of boxes.slice(i + 1))
      if (p.left < q.right - 1 && q.left < p.right - 1 && p.top < q.bottom - 1 && q.top < p.bottom - 1) said.push(`${name(a)} covers ${name(b)}`);
  }
  return said;
}

const flows = {
  async unfold({ page }) {
    await example(page, 'bracket.step');
    const before = await page.textContent('[data-testid=blank-size]');
    await page.click('[data-testid=tab-bends]');
    await page.fill('[data-testid=bend-k-B1]', '0.3');
    await page.keyboard.press('Enter');
    await rested(page);
    assert.notEqual(await page.textContent('[data-testid=blank-size]'), before, 'the blank follows K');
    await page.click('[data-testid=bend-B2]');
    assert.equal(await state(page, 's.selection.part'), 'B2');
    await page.click('[data-testid=undo]');
    await rested(page);
    assert.equal(await page.textContent('[data-testid=blank-size]'), before, 'undo brings it back');
    await page.click('[data-testid=tab-input]');
    await page.click('[data-testid=pick-root]');
    const spot = await state(page, `(() => { const f = [...s.shape.facet_part].findIndex((p) => s.shape.parts[p].name === 'F2'), r = s.shape.polygon_starts[s.shape.facet_starts[f]], a = s.shape.ring_starts[r], b = s.shape.ring_starts[r + 1]; return f; })()`);
    assert.ok(spot >= 0);
    await page.click('[data-testid=tab-certificate]');
    assert.match(await page.textContent('[data-testid=certificate]'), /Volume agrees to/);
    await page.keyboard.press('Escape');
    await page.keyboard.press(' ');
    await page.waitForTimeout(1500);
    assert.equal(await state(page, 's.fold'), 0);
    return download(page, 'dxf');
  },
  async connect({ page }) {
    await example(page, 'connect/a_folded.json');
    await page.click('[data-testid=plate-right]');
    await page.waitForTimeout(200);
    const middle = await state(page, `(() => { const c = s.shape.handles.plates.find((p) => p.id === 'right').corners, m = [0, 1, 2].map((k) => c.reduce((t, p) => t + p[k], 0) / c.length); return { m, at: views.folded.project(m) }; })()`);
    await page.evaluate(() => { window.planishTimings.length = 0; });
    await drag(page, middle.at, { x: 40, y: 12 }, 20);
    await rested(page);
    const moved = await state(page, `s.shape.handles.plates.find((p) => p.id === 'right').corners[0]`);
    assert.ok(Math.hypot(moved[0] - 460, moved[1], moved[2] - 40) > 5, `the plate moved: ${moved}`);
    timings('connect', await page.evaluate(() => window.planishTimings));
    await page.keyboard.press('Control+z');
    await rested(page);
    assert.deepEqual(await state(page, `s.input.spec.plates[4].outline[0]`), [460, 0, 40]);
    await page.keyboard.press('Escape');
    await page.click('[data-testid=bend-head-B1]');
    await slide(page, 'bend-radius', 0.2);
    await rested(page);
    assert.ok((await state(page, 's.shape.report.flat.bends[0].inside_radius')) < 3, 'the radius followed');
    return download(page, 'dxf');
  },
  async plates({ page }) {
    await example(page, 'connect/a_folded.json');
    const before = await state(page, 's.input.spec'), plates = () => state(page, 's.shape.parts.flatMap((p) => p.plate ?? [])');
    await page.click('[data-testid=plate-back]');
    await page.click('[data-testid=plate-add]');
    await rested(page);
    assert.ok((await plates()).includes('P1'));
    const found = await state(page, `s.shape.report.flat.bends.find((b) => b.between.includes('P1'))`);
    await page.click(`[data-testid=bend-head-${found.id}]`);
    await page.click('.block.open [data-testid^=bend-remove]');
    await page.waitForFunction(() => window.planish.store.state.stale && !window.planish.store.state.computing);
    await page.waitForSelector('.message.error:has-text("do not join plate")');
    assert.ok(await state(page, `s.shape.handles.plates.some((p) => p.id === 'P1')`), 'what is not joined has its handle all the same');
    await page.click('[data-testid=plate-P1]');
    await page.click(`[data-testid=bend-add-${found.between.find((id) => id !== 'P1')}]`);
    await rested(page);
    assert.equal(await state(page, 's.problem'), null);
    await enter(page, 'plate-name', 'flap');
    await page.click('[data-testid=plate-corners]');
    const u = Number(await page.inputValue('[data-testid=corner-0-1-u]'));
    await enter(page, 'corner-0-1-u', String(u + 20));
    await rested(page);
    assert.deepEqual(await state(page, `s.shape.handles.plates.at(-1)`), { id: 'flap', corners: await state(page, 's.input.spec.plates.at(-1).outline') });
    await page.click('[data-testid=plate-copy]');
    await rested(page);
    assert.equal(await state(page, 's.input.spec.plates.at(-1).id'), 'flap-2');
    await page.keyboard.press('Delete');
    assert.equal(await state(page, 's.input.spec.plates.at(-1).id'), 'flap');
    await rested(page);
    const file = await download(page, 'dxf');
    for (let n = await state(page, 's.past.length'); n > 0; --n) await page.keyboard.press('Control+z');
    assert.deepEqual(await state(page, 's.input.spec'), before);
    await rested(page);
    return file;
  },
  async transition({ page }) {
    await example(page, 'transition/a_square_to_round.json');
    await page.evaluate(() => { window.planishTimings.length = 0; });
    const before = await page.textContent('[data-testid=blank-size]');
    await slide(page, 'to-z', 0.95);
    await rested(page);
    assert.notEqual(await page.textContent('[data-testid=blank-size]'), before);
    await slide(page, 'to-tiltX', 0.55);
    await rested(page);
    await slide(page, 'to-twist', 0.6);
    await rested(page);
    timings('transition', await page.evaluate(() => window.planishTimings));
    assert.equal(await state(page, 's.past.length'), 3);
    return download(page, 'dxf');
  },
  async slit({ page }) {
    await example(page, 'slit/chair.json');
    await page.evaluate(() => { window.planishTimings.length = 0; });
    const circle = await page.locator('[data-testid=curve-seat-2]').boundingBox();
    await drag(page, { x: circle.x + circle.width / 2, y: circle.y + circle.height / 2 }, { x: 12, y: -6 }, 20);
    await rested(page);
    timings('slit, seat curve', await page.evaluate(() => window.planishTimings));
    const end = await state(page, `(() => { const r = s.shape.handles.ridges[2], row = r[Math.floor(r.length / 2)]; return { at: row[0], on: views.folded.project(row[0]) }; })()`);
    await page.mouse.click(end.on.x, end.on.y);
    await rested(page);
    assert.equal(await state(page, 's.input.spec.anchors.length'), 1);
    await page.evaluate(() => { window.planishTimings.length = 0; });
    await drag(page, end.on, { x: 0, y: -25 }, 20);
    await rested(page);
    timings('slit, anchor', await page.evaluate(() => window.planishTimings));
    const at = await state(page, 's.input.spec.anchors[0].at');
    assert.ok(Math.hypot(...at.map((v, k) => v - end.at[k])) > 3, 'the anchor moved');
    return download(page, 'dxf');
  },
  async strips({ page }) {
    await open(page, [coarse('plume.json')]);
    const width = () => state(page, 's.shape.report.flat.size'), before = await width();
    await page.click('[data-testid=strip-head-1]');
    for (const key of ['direction', 'across']) {
      await page.check(`[data-testid=end-${key}]`);
      await rested(page);
      assert.equal(await state(page, 's.problem'), null);
    }
    assert.deepEqual(Object.keys(await state(page, 's.input.spec.ends[1]')), ['strip', 'position', 'direction', 'across']);
    await enter(page, 'strip-width', '230');
    await rested(page);
    const wider = await width();
    assert.ok(wider.some((v, k) => Math.abs(v - before[k] - 10) < 1e-6), `${before} has become ${wider}`);
    await page.selectOption('[data-testid=strip-kind]', 'one');
    await rested(page);
    assert.equal(await state(page, 's.input.spec.sheet.strips'), 7);
    for (let n = await state(page, 's.past.length'); n > 0; --n) await page.keyboard.press('Control+z');
    await rested(page);
    assert.equal((await state(page, 's.input.spec.sheet.strips'))[1].width, 220);
  },
  async points({ page }) {
    await open(page, [coarse('chair.json')]);
    const at = () => state(page, 's.input.spec.seat_curve.bezier'), before = await at();
    await page.click('[data-testid=curve-seat-1]');
    await enter(page, 'curve-seat-y', '310');
    await rested(page);
    assert.deepEqual(await at(), before.map((p, i) => (i === 1 ? [310, p[1]] : p)));
    await page.locator('[data-testid=curve-seat-y]').blur();
    await page.keyboard.press('Delete');
    assert.deepEqual(await at(), before.filter((_, i) => i !== 1));
    await page.click('[data-testid=curve-seat-0]');
    assert.ok(await page.isDisabled('[data-testid=curve-seat-remove]'), 'the ends stay');
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    assert.deepEqual(await at(), before);
    await rested(page);
  },
  async inch({ page }) {
    const file = `${out}/inch.step`, text = readFileSync(new URL('../../examples/bracket.step', import.meta.url), 'utf8');
    writeFileSync(file, text.replace('( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )', `( CONVERSION_BASED_UNIT('INCH',#9001) LENGTH_UNIT() NAMED_UNIT(#9003) )`)
      .replace('DATA;', `DATA;\n#9001 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#9002);\n#9002 = ( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) );\n#9003 = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);`));
    await open(page, [file]);
    assert.equal(await state(page, 's.units'), 'inch', 'the page speaks the unit of the part');
    console.log(`   blank ${await page.textContent('[data-testid=blank-size]')} of ${file}`);
    const noneLeft = async () => {
      for (const tab of ['input', 'bends', 'certificate']) {
        await page.click(`[data-testid=tab-${tab}]`);
        assert.doesNotMatch(await page.evaluate(() => document.querySelector('aside').innerText), /\bmm\b/, `${await state(page, 's.document.name')}, ${tab}`);
      }
      await page.click('[data-testid=tab-input]');
    };
    await noneLeft();
    for (const name of ['connect/a_folded.json', 'transition/a_square_to_round.json', 'chair.json']) {
      if (name === 'chair.json') await open(page, [coarse(name)]);
      else await example(page, name);
      assert.equal(await state(page, 's.units'), 'mm');
      await page.click('[data-testid=units-inch]');
      await noneLeft();
      await enter(page, 'thickness', '0.125');
      await rested(page);
      assert.equal(await state(page, 's.input.spec.thickness'), 3.175, name);
      assert.equal(await page.textContent('[data-testid=sheet-thickness]'), '0.125');
    }
    const plates = JSON.parse(readFileSync(new URL('../../examples/connect/d_irregular.json', import.meta.url), 'utf8'));
    writeFileSync(`${out}/inch.json`, JSON.stringify({ ...plates, units: 'inch' }));
    await open(page, [`${out}/inch.json`]);
    assert.equal(await state(page, 's.units'), 'inch');
    assert.equal(await page.inputValue('[data-testid=thickness]'), String(plates.thickness));
  },
  // A file let fall on the window; its pattern covers itself.
  async drop({ page }) {
    const square = (id, points) => ({ id, outline: points }), walls = {
      format: 'planish/plates', version: 1, thickness: 2, plates: [
        square('floor', [[0, 0, 0], [100, 0, 0], [100, 100, 0], [0, 100, 0]]), square('up', [[106, 0, 6], [106, 200, 6], [106, 200, 100], [106, 0, 100]]),
        square('down', [[0, 106, -6], [200, 106, -6], [200, 106, -100], [0, 106, -100]])] };
    await page.evaluate((text) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], 'walls.json', { type: 'application/json' }));
      for (const type of ['dragover', 'drop']) document.body.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    }, JSON.stringify(walls));
    await opened(page, 'walls.json');
    await page.waitForSelector('.message.error:has-text("overlap by")');
    for (const theme of ['light', 'dark']) {
      assert.equal(await state(page, 's.theme'), theme);
      await page.waitForTimeout(200);
      const { red, inside, outside } = await page.evaluate(() => {
        const s = window.planish.store.state, { flat } = window.planish.views, o = s.shape.overlaps, canvas = document.querySelector('[data-testid=flat-canvas]');
        const pixel = (at) => {
          const p = flat.project(at), r = canvas.getBoundingClientRect();
          return [...canvas.getContext('2d').getImageData(Math.round(p.x - r.left), Math.round(p.y - r.top), 1, 1).data].slice(0, 3);
        };
        const [, red, alpha] = getComputedStyle(document.documentElement).getPropertyValue('--overlap').match(/(\d+), .*, ([\d.]+)\)/).map(Number);
        return { red: { red, alpha }, inside: pixel([0, 1].map((k) => (o[k] + o[2 + k] + o[4 + k]) / 3)), outside: pixel([10, 10]) };
      });
      const shown = Math.round(red.alpha * red.red + (1 - red.alpha) * outside[0]);
      assert.ok(Math.abs(inside[0] - shown) < 10 && inside[0] > inside[1] + 90, `${theme}: ${inside} is not the red of overlaps`);
      await page.click('[data-testid=theme]');
    }
  },
  async turn({ page }) {
    await example(page, 'connect/a_folded.json');
    const outline = () => state(page, `s.input.spec.plates.find((p) => p.id === 'right').outline`), before = await outline();
    await page.click('[data-testid=plate-right]');
    await page.keyboard.press('t');
    await page.waitForTimeout(200);
    // The ring about z, where it is seen best: its radius is half a unit of the gizmo.
    const { from, to } = await state(page, `(() => {
      const c = s.shape.handles.plates.find((p) => p.id === 'right').corners, m = [0, 1, 2].map((k) => c.reduce((t, p) => t + p[k], 0) / c.length);
      const { camera, gizmo } = views.folded, r = 0.5 * (camera.top - camera.bottom) / camera.zoom * gizmo.size / 4;
      const at = (a) => views.folded.project([m[0] + r * Math.cos(a), m[1] + r * Math.sin(a), m[2]]);
      return { from: at(-0.9), to: at(-0.5) }; })()`);
    await drag(page, from, { x: to.x - from.x, y: to.y - from.y }, 10);
    await rested(page);
    const turned = await outline();
    before.forEach((p, i) => assert.ok(Math.abs(turned[i][2] - p[2]) < 1e-6 && Math.hypot(turned[i][0] - p[0], turned[i][1] - p[1]) > 1, `corner ${i} went from ${p} to ${turned[i]}`));
    await page.keyboard.press('Control+z');
    assert.deepEqual(await outline(), before);
    await page.keyboard.press('Control+Shift+z');
    assert.deepEqual(await outline(), turned);
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+y');
    assert.deepEqual(await outline(), turned);
    await rested(page);
  },
  // By a drag and by a number: the sentence is shown, the last shape stays, greyed, and so does the handle.
  async invalid({ page }) {
    await example(page, 'connect/a_folded.json');
    const parts = await state(page, 's.shape.parts.length'), greyed = async (wanted) => {
      await page.waitForFunction((w) => { const s = window.planish.store.state; return s.stale === w && !s.computing; }, wanted);
      await page.waitForTimeout(100);
      assert.equal(await page.evaluate(() => getComputedStyle(document.querySelector('[data-testid=folded-canvas]')).opacity), wanted ? '0.4' : '1');
      assert.equal(await state(page, 's.shape.parts.length'), parts);
      if (wanted) assert.match(await page.textContent('.message.error'), /\[\w+\]/);
    };
    await page.click('[data-testid=plate-left]');
    await enter(page, 'plate-x', '94');
    await rested(page);
    // By the arrow down through the floor.
    const arrow = await state(page, `(() => {
      const c = s.shape.handles.plates.find((p) => p.id === 'left').corners, m = [0, 1, 2].map((k) => c.reduce((t, p) => t + p[k], 0) / c.length);
      const { camera, gizmo } = views.folded, r = 0.4 * (camera.top - camera.bottom) / camera.zoom * gizmo.size / 4, at = (z) => views.folded.project([m[0], m[1], m[2] + z]);
      return { from: at(r), to: at(r - 40) }; })()`);
    await drag(page, arrow.from, { x: arrow.to.x - arrow.from.x, y: arrow.to.y - arrow.from.y }, 10);
    await greyed(true);
    assert.match(await page.textContent('[data-testid=message]'), /pass through each other/);
    assert.ok(await state(page, `s.shape.handles.plates.find((p) => p.id === 'left').corners.some((c) => c[2] < 0)`), 'the handle is where the plate is');
    await page.keyboard.press('Control+z');
    await greyed(false);
    await enter(page, 'thickness', '90');
    await greyed(true);
    await enter(page, 'thickness', 'four');
    assert.equal(await page.inputValue('[data-testid=thickness]'), '90', 'what is no number is put back');
    await enter(page, 'thickness', '4');
    await greyed(false);
  },
  async scan({ page }) {
    const folder = new URL('../../examples/slit/', import.meta.url).pathname;
    await open(page, [coarse('scanned_chair.json'), ...[0, 1, 2, 3, 4, 5].map((i) => `${folder}low_chair_scan${i}.xyz`)]);
    assert.match(await page.textContent('[data-testid=scan-state]'), /6 strips are scanned; [1-9]\d* points are drawn/);
    const distance = () => state(page, 's.shape.report.slit.strips.map((t) => t.scan_distance)'), before = await distance();
    await page.check('[data-testid=align-scan]');
    await rested(page);
    assert.equal(await state(page, 's.problem'), null);
    const after = await distance();
    assert.notDeepEqual(after, before);
    after.forEach((d) => assert.ok(d < 2, `the scans lie ${after} mm from their strips`));
  },
  // What takes long is given up, and nothing jumps meanwhile.
  async long({ page }) {
    await example(page, 'slit/chair.json');
    const boxes = () => page.evaluate(() => Object.fromEntries(['header', '.messages', '.folded', '.flat', 'aside', '.tabs', '.content', '.fold', '[data-testid=undo]', '[data-testid=download-menu]']
      .map((q) => { const r = document.querySelector(q).getBoundingClientRect(); return [q, [r.x, r.y, r.width, r.height]]; })));
    const first = await boxes(), same = async (when) => assert.deepEqual(await boxes(), first, `something moved: ${when}`);
    await page.click('[data-testid=curve-seat-1]');
    await same('selected');
    while ((await state(page, 's.input.spec.subdivisions')) < 4) await page.click('[data-testid=subdivide]');
    await page.waitForSelector('[data-testid=cancel]');
    await same('busy');
    await page.click('[data-testid=cancel]');
    await page.waitForFunction(() => { const s = window.planish.store.state; return !s.computing && s.note === 'cancelled'; });
    await same('cancelled');
    while ((await state(page, 's.input.spec.subdivisions')) > 0) await page.click('[data-testid=coarser]');
    await rested(page);
    assert.equal(await state(page, 's.note'), null);
    await page.click('[data-testid=curve-leg-3]');
    await enter(page, 'curve-leg-z', '900');
    await page.waitForFunction(() => window.planish.store.state.problem);
    await same('refused');
    await page.click('[data-testid=undo]');
    await rested(page);
    assert.equal(await state(page, 's.problem'), null);
    await page.click('[data-testid=tab-certificate]');
    await page.click('[data-testid=units-inch]');
    await same('other tab and unit');
  },
  async layout({ page }) {
    const tidy = async (what) => {
      await page.waitForTimeout(100);
      assert.deepEqual(await page.evaluate(untidy), [], what);
    };
    const openFolds = () => page.evaluate(() => document.querySelectorAll('aside details').forEach((d) => { d.open = true; }));
    await tidy('empty');
    await example(page, 'bracket.step');
    for (const tab of ['input', 'bends', 'findings', 'certificate']) {
      await page.click(`[data-testid=tab-${tab}]`);
      await tidy(`bracket, ${tab}`);
    }
    await example(page, 'connect/a_folded.json');
    await page.click('[data-testid=plate-right]');
    await openFolds();
    for (const unit of ['inch', 'mm']) {
      await page.click(`[data-testid=units-${unit}]`);
      await tidy(`plate in ${unit}`);
    }
    await page.click('[data-testid=gizmo-rotate]');
    await tidy('plate that is turned');
    await page.click('[data-testid=bend-head-B4]');
    await tidy('bend');
    await example(page, 'transition/b_rectangle_to_ellipse_inclined.json');
    await openFolds();
    await tidy('transition');
    await open(page, [coarse('plume.json')]);
    await page.click('[data-testid=strip-head-1]');
    await page.click('[data-testid=curve-leg-1]');
    await tidy('curve');
    await page.click('[data-testid=strip-head-1]');
    for (const unit of ['inch', 'mm']) {
      await page.click(`[data-testid=units-${unit}]`);
      await tidy(`strip in ${unit}`);
    }
  },
  async policy({ said }) {
    const strict = await fresh(false);
    await strict.page.click('[data-testid=examples-menu]');
    await strict.page.click('[data-testid="example-slit/chair.json"]');
    await strict.page.waitForSelector('[data-testid=blank-size]:has-text("1768")', { timeout: 60000 });
    said.push(...strict.said);
    await strict.context.close();
  },
  async rubbish({ page }) {
    const others = await openAtServer(page);
    writeFileSync(`${out}/rubbish.step`, 'this is no STEP file');
    const refused = async () => {
      await page.setInputFiles('[data-testid=file-input]', `${out}/rubbish.step`);
      await page.waitForFunction(() => window.planish.store.state.problem);
    };
    await refused();
    console.log(`   ${await page.textContent('[data-testid=message]')}`);
    await example(page, 'connect/a_folded.json');
    assert.equal(await state(page, 's.problem'), null);
    await refused();
    assert.deepEqual(await state(page, '[s.document.name, s.stale, s.opening, s.shape.parts.length]'), ['a_folded.json', false, null, 9]);
    assert.deepEqual(await openAtServer(page), [...others, 'a_folded.json']);
  },
  async opening({ page, said }) {
    const others = await openAtServer(page);
    await example(page, 'connect/a_folded.json');
    await page.route('**/api/documents/*/open', async (route) => {
      await new Promise((resolve) => setTimeout(resolve, 2000));
      await route.continue().catch(() => undefined); // given up meanwhile
    });
    const slow = () => page.setInputFiles('[data-testid=file-input]', new URL('../../examples/transition/e_reducer.json', import.meta.url).pathname);
    await slow();
    await page.waitForSelector('[data-testid=progress]');
    assert.match(await page.textContent('.messages'), /opening\s+Opening e_reducer.json …\s+reading\s+Cancel/);
    await page.click('[data-testid=cancel]');
    await page.waitForFunction(() => window.planish.store.state.note === 'cancelled');
    assert.deepEqual(await state(page, '[s.document.name, s.opening, s.stale, s.problem]'), ['a_folded.json', null, false, null]);
    assert.deepEqual(await openAtServer(page), [...others, 'a_folded.json']);
    // The one that was asked for last is opened, even where another takes longer.
    await slow();
    await page.waitForSelector('[data-testid=progress]');
    await page.unroute('**/api/documents/*/open');
    await example(page, 'connect/c_ripped.json');
    await page.waitForTimeout(2500);
    assert.equal(await state(page, 's.document.name'), 'c_ripped.json');
    assert.deepEqual(await openAtServer(page), [...others, 'c_ripped.json']);
    // One that the server has let go is opened again, with the edits.
    const id = await state(page, 's.document.id');
    await page.evaluate((gone) => fetch(`/api/documents/${gone}`, { method: 'DELETE', headers: { 'X-Planish-Token': location.hash.slice(1) } }), id);
    await enter(page, 'thickness', '1.5');
    await page.waitForFunction((gone) => window.planish.store.state.document.id !== gone, id);
    await rested(page);
    assert.deepEqual(await state(page, '[s.problem, s.shape.report.sheet.thickness, s.opening]'), [null, 1.5, null]);
    said.length = 0; // the browser notes that the document was gone
  },
  async killed({ page, said }) {
    await example(page, 'slit/chair.json');
    // Between two requests: nobody notices.
    killWorkers();
    await page.click('[data-testid=coarser]');
    await rested(page);
    assert.equal(await state(page, 's.problem'), null);
    // In the middle of one, that takes seconds: the page says so, and goes on with the next edit.
    for (let i = 0; i < 3; ++i) await page.click('[data-testid=subdivide]');
    await page.waitForFunction(() => { const s = window.planish.store.state; return s.computing && s.shapeIsDraft && s.busy; }, null, { timeout: 60000 });
    killWorkers();
    await page.waitForFunction(() => window.planish.store.state.problem);
    assert.match(await page.textContent('[data-testid=message]'), /worker/);
    said.length = 0; // the browser notes the status of the answer
    for (let i = 0; i < 3; ++i) await page.click('[data-testid=coarser]');
    await rested(page);
    assert.equal(await state(page, 's.problem'), null);
  },
  async two({ page, said }) {
    const other = await fresh();
    await example(page, 'transition/a_square_to_round.json');
    await example(other.page, 'connect/a_folded.json');
    const blank = (p) => p.textContent('[data-testid=blank-size]');
    const before = await blank(page), beside = await blank(other.page);
    await slide(page, 'to-z', 0.9);
    await rested(page);
    await rested(other.page);
    assert.notEqual(await blank(page), before);
    assert.equal(await blank(other.page), beside, 'the other page is as it was');
    await other.page.click('[data-testid=bend-head-B1]');
    await slide(other.page, 'bend-radius', 0.3);
    await rested(other.page);
    assert.equal(await state(page, 's.document.name'), 'a_square_to_round.json');
    said.push(...other.said);
    await other.context.close();
  },
};

let failed = 0;
for (const [name, flow] of Object.entries(flows)) {
  if (wanted.length && !wanted.includes(name)) continue;
  const begun = performance.now(), given = await fresh();
  out = `${files}/${name}`;
  mkdirSync(out, { recursive: true });
  try {
    const file = await flow(given);
    await given.page.goto('about:blank'); // the page lets its document go
    assert.deepEqual(given.said, [], 'nothing on the console');
    console.log(`ok ${name}${file ? ` (${file})` : ''} ${((performance.now() - begun) / 1000).toFixed(1)} s`);
  } catch (error) {
    ++failed;
    await given.page.screenshot({ path: `${out}/failed.png` });
    console.log(`not ok ${name}: ${error.message}\n   ${given.said.join('\n   ')}`);
  }
  await given.context.close();
}
await browser.close();
process.exitCode = failed ? 1 : 0;
