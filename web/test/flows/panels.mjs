import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { coarse, download, enter, example, folder, open, rested, slide, state } from '../driving.mjs';

// How the panels of slit sheets stand, and what their mould is.

/** The left end of strip 0's first ridge: a corner of the panel, which stands over an end of the leg curve. */
const corner = `s.shape.handles.ridges[0][0][0]`;
const near = (a, b, within, what) => assert.ok(Math.abs(a - b) <= within, `${what}: ${a} instead of ${b}`);

export async function leaning({ page }) {
  await open(page, [coarse(page, 'bridge.json')]);
  const lean = () => state(page, 's.input.spec.leg_curve.lean');
  assert.equal(await page.inputValue('[data-testid=leg-lean-number]'), '10');
  near((await state(page, corner))[1], 700 * Math.cos(Math.PI / 18), 0.01, 'the panel leans by 10°');
  await slide(page, 'leg-lean', 0.6);
  await rested(page);
  assert.equal(await state(page, 's.problem'), null);
  const slid = await lean();
  near(slid, -90 + 0.6 * 180, 4, 'the slider');
  near((await state(page, corner))[1], 700 * Math.cos((slid * Math.PI) / 180), 0.01, 'the panel follows');
  for (const [entered, sentence] of [
    ['120', 'Leans back cannot be 120; it must be from -90° to 90°.'],
    ['upright', '“upright” is not a number'],
  ]) {
    await enter(page, 'leg-lean-number', entered);
    await page.waitForSelector(`[data-testid=message]:has-text("${sentence}")`);
    assert.equal(await lean(), slid, sentence);
  }
  await enter(page, 'leg-lean-number', '0');
  await rested(page);
  assert.equal(await lean(), undefined, 'upright needs no key');
  near((await state(page, corner))[1], 700, 0.01, 'upright');
  // Level with the ground, as the legs of the monument.
  await example(page, 'slit/monument.json');
  assert.equal(await page.inputValue('[data-testid=leg-lean-number]'), '90');
  near((await state(page, corner))[1], 0, 0.01, 'the panel lies level');
  await page.screenshot({ path: `${folder(page)}/level.png` });
}

export async function fitted({ page }) {
  await open(page, [coarse(page, 'bridge.json')]);
  const [first, second] = await state(page, 's.shape.report.slit.leg_scales');
  assert.equal(await page.textContent('[data-testid=leg-scale]'), `× ${first.toFixed(4)}`);
  assert.equal(await page.textContent('[data-testid=second-scale]'), `× ${second.toFixed(4)}`);
  assert.equal(await page.locator('[data-testid=curve-leg-fit]').count(), 0);
  // A curve half as long is scaled to the sheet; without it, it is refused.
  await page.evaluate(`(() => { const { store } = window.planish, { input } = store.state;
    const bezier = input.spec.leg_curve.bezier.map(([x, z]) => [700 + (x - 700) / 2, z / 2]);
    const spec = { ...input.spec, leg_curve: { ...input.spec.leg_curve, bezier } };
    store.dispatch({ type: 'edit', input: { ...input, spec } }); })()`);
  await rested(page);
  assert.equal(await state(page, 's.problem'), null);
  near((await state(page, 's.shape.report.slit.leg_scales'))[0], 2 * first, 1e-3, 'the scale');
  await page.uncheck('[data-testid=leg-fit]');
  await page.waitForSelector('.message.error:has-text("leg curve")');
  assert.equal(await state(page, `'fit' in s.input.spec.leg_curve`), false);
  await page.click('[data-testid=curve-leg-fit]');
  await rested(page);
  assert.equal(await state(page, 's.problem'), null, 'as long as the sheet is wide');
  await page.check('[data-testid=leg-fit]');
  await rested(page);
  assert.equal(await state(page, 's.problem'), null);
}

export async function second({ page }) {
  await open(page, [coarse(page, 'bridge.json')]);
  assert.equal(await page.inputValue('[data-testid=second-height]'), '500');
  const long = () => state(page, 'Math.max(...s.shape.report.flat.size)'),
    before = await long();
  await enter(page, 'second-height', '600');
  await rested(page);
  near(await long(), before + 100, 1e-6, 'the sheet is longer');
  await page.click('[data-testid=curve-second-0]');
  await enter(page, 'curve-second-x', '-650');
  await rested(page);
  assert.deepEqual(await state(page, 's.input.spec.second_panel.leg_curve.bezier[0]'), [-650, 50]);
  assert.equal(await state(page, 's.problem'), null);
  await page.click('[data-testid=second-remove]');
  await rested(page);
  assert.deepEqual(await state(page, `[s.problem, 'second_panel' in s.input.spec]`), [null, false]);
  await page.click('[data-testid=strip-head-0]');
  await page.waitForSelector('[data-testid=end-position]'); // ends without a panel can be placed
  // Added to each of the other sheets: in reach.
  const added = async (wanted = null) => {
    await page.click('[data-testid=second-add]');
    await rested(page);
    assert.equal(await state(page, 's.problem?.code ?? null'), wanted, await state(page, 's.document.name'));
    assert.equal(await state(page, 's.shape.report.slit.strips.every((t) => t.gap < 1e-6)'), true, 'strips end at it');
    await page.screenshot({ path: `${folder(page)}/${await state(page, 's.document.name')}.png` });
  };
  await added();
  assert.equal(
    await page.locator('[data-testid=end-position]').count(),
    0,
    'strips that end at a panel are not placed',
  );
  for (const name of ['plume.json', 'chair.json', 'monument.json']) {
    await open(page, [coarse(page, name)]);
    await added();
    assert.equal(await state(page, 's.input.spec.symmetric'), false);
  }
}

/** The number of bodies of a binary STL file: triangles that share corners are one. */
function bodiesOf(path) {
  const data = readFileSync(path),
    parent = new Map();
  const root = (key) => {
    while (parent.get(key) !== key) key = parent.get(key);
    return key;
  };
  for (let t = 0; t < data.readUInt32LE(80); ++t) {
    const keys = [0, 1, 2].map((k) =>
      data.subarray(84 + 50 * t + 12 * (k + 1), 84 + 50 * t + 12 * (k + 2)).toString('hex'),
    );
    for (const key of keys) if (!parent.has(key)) parent.set(key, key);
    for (const key of keys.slice(1)) parent.set(root(key), root(keys[0]));
  }
  return new Set([...parent.keys()].map(root)).size;
}

/** Heights of a mould in a binary STL file. */
function lowestOf(path) {
  const data = readFileSync(path);
  let least = Infinity;
  for (let t = 0; t < data.readUInt32LE(80); ++t)
    for (let k = 1; k <= 3; ++k) least = Math.min(least, data.readFloatLE(84 + 50 * t + 12 * k + 4));
  return least;
}

export async function mould({ page }) {
  await open(page, [coarse(page, 'bridge.json')]);
  assert.equal(bodiesOf(await download(page, 'mould.stl')), 5, 'a rib under each of five strips');
  await page.selectOption('[data-testid=mould-form]', 'body');
  await rested(page);
  assert.deepEqual(await state(page, 's.input.spec.mould'), { form: 'body' });
  const usual = await download(page, 'mould.stl');
  assert.equal(bodiesOf(usual), 1, 'one body');
  const low = lowestOf(usual);
  await enter(page, 'mould-base', '60');
  await rested(page);
  near(lowestOf(await download(page, 'mould.stl')), low - (60 - 20), 0.01, 'the base is deeper');
  for (const [field, entered, said] of [
    ['mould-draft', '90', 'Least draft cannot be 90'],
    ['mould-base', '-1', 'Base depth cannot be -1'],
  ]) {
    await enter(page, field, entered);
    await page.waitForSelector(`[data-testid=message]:has-text("${said}")`);
  }
  await page.check('[data-testid=mould-up]');
  await enter(page, 'mould-up-x', '0.1');
  await enter(page, 'mould-inset', '8');
  await enter(page, 'mould-draft', '10');
  await page.selectOption('[data-testid=mould-side]', 'back');
  await rested(page);
  assert.deepEqual(await state(page, 's.input.spec.mould'), {
    form: 'body',
    base: 60,
    up: [0.1, 1, 0],
    inset: 8,
    draft: 10,
    side: 'back',
  });
  await page.locator('[data-testid=mould-side]').scrollIntoViewIfNeeded();
  await page.screenshot({ path: `${folder(page)}/fields.png` });
  assert.equal(await state(page, 's.problem'), null);
  for (let n = await state(page, 's.past.length'); n > 0; --n) await page.click('[data-testid=undo]');
  assert.equal(await state(page, `'mould' in s.input.spec`), false);
  await rested(page);
}
