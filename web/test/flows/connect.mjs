import assert from 'node:assert/strict';
import { download, drag, enter, example, rested, slide, state, timings } from '../driving.mjs';

export async function connect({ page }) {
  await example(page, 'connect/a_folded.json');
  await page.click('[data-testid=plate-right]');
  await page.waitForTimeout(200);
  const middle = await state(
    page,
    `(() => {
    const c = s.shape.handles.plates.find((p) => p.id === 'right').corners;
    const m = [0, 1, 2].map((k) => c.reduce((t, p) => t + p[k], 0) / c.length);
    return { m, at: views.folded.project(m) }; })()`,
  );
  await page.evaluate(() => {
    window.planishTimings.length = 0;
  });
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
}

export async function ten({ page }) {
  await example(page, 'connect/ten_plates.json');
  await page.click('[data-testid=plate-spout]');
  await page.waitForTimeout(200);
  const spout = () => state(page, `s.shape.handles.plates.find((p) => p.id === 'spout').corners`),
    before = await spout();
  const at = await state(
    page,
    `(() => {
    const c = s.shape.handles.plates.find((p) => p.id === 'spout').corners;
    return views.folded.project([0, 1, 2].map((k) => c.reduce((t, p) => t + p[k], 0) / c.length)); })()`,
  );
  await page.evaluate(() => {
    window.planishTimings.length = 0;
  });
  await drag(page, at, { x: -10, y: 8 }, 30);
  await rested(page);
  timings('ten plates', await page.evaluate(() => window.planishTimings));
  const moved = (await spout()).map((p, i) => p.map((v, k) => v - before[i][k]));
  assert.ok(
    Math.hypot(...moved[0]) > 3 && moved.every((m) => m.every((v, k) => Math.abs(v - moved[0][k]) < 1e-5)),
    `it moved as it is: ${moved}`,
  );
}

export async function plates({ page }) {
  await example(page, 'connect/a_folded.json');
  const before = await state(page, 's.input.spec'),
    plates = () => state(page, 's.shape.parts.flatMap((p) => p.plate ?? [])');
  await page.click('[data-testid=plate-back]');
  await page.click('[data-testid=plate-add]');
  await rested(page);
  assert.ok((await plates()).includes('P1'));
  const found = await state(page, `s.shape.report.flat.bends.find((b) => b.between.includes('P1'))`);
  await page.click(`[data-testid=bend-head-${found.id}]`);
  await page.click('.block.open [data-testid^=bend-remove]');
  await page.waitForFunction(() => window.planish.store.state.stale && !window.planish.store.state.computing);
  await page.waitForSelector('.message.error:has-text("do not join plate")');
  assert.ok(
    await state(page, `s.shape.handles.plates.some((p) => p.id === 'P1')`),
    'what is not joined has its handle all the same',
  );
  await page.click('[data-testid=plate-P1]');
  await page.click(`[data-testid=bend-add-${found.between.find((id) => id !== 'P1')}]`);
  await rested(page);
  // Beside the back and in its plane, it runs through it when folded: shown, and written when asked for.
  assert.equal(await state(page, 's.problem?.code'), 'self_intersection');
  await page.click('[data-testid=remedy-write_anyway-true]');
  await rested(page);
  assert.equal(await state(page, 's.problem'), null);
  await enter(page, 'plate-name', 'flap');
  await page.click('[data-testid=plate-corners]');
  const u = Number(await page.inputValue('[data-testid=corner-0-1-u]'));
  await enter(page, 'corner-0-1-u', String(u + 20));
  await rested(page);
  assert.deepEqual(await state(page, `s.shape.handles.plates.at(-1)`), {
    id: 'flap',
    corners: await state(page, 's.input.spec.plates.at(-1).outline'),
  });
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
}

export async function turn({ page }) {
  await example(page, 'connect/a_folded.json');
  const outline = () => state(page, `s.input.spec.plates.find((p) => p.id === 'right').outline`),
    before = await outline();
  await page.click('[data-testid=plate-right]');
  await page.keyboard.press('t');
  await page.waitForTimeout(200);
  // The ring about z, where it is seen best: its radius is half a unit of the gizmo.
  const { from, to } = await state(
    page,
    `(() => {
    const c = s.shape.handles.plates.find((p) => p.id === 'right').corners;
    const m = [0, 1, 2].map((k) => c.reduce((t, p) => t + p[k], 0) / c.length);
    const { camera, gizmo } = views.folded, r = 0.5 * (camera.top - camera.bottom) / camera.zoom * gizmo.size / 4;
    const at = (a) => views.folded.project([m[0] + r * Math.cos(a), m[1] + r * Math.sin(a), m[2]]);
    return { from: at(-0.9), to: at(-0.5) }; })()`,
  );
  await drag(page, from, { x: to.x - from.x, y: to.y - from.y }, 10);
  await rested(page);
  const turned = await outline();
  before.forEach((p, i) =>
    assert.ok(
      Math.abs(turned[i][2] - p[2]) < 1e-6 && Math.hypot(turned[i][0] - p[0], turned[i][1] - p[1]) > 1,
      `corner ${i} went from ${p} to ${turned[i]}`,
    ),
  );
  await page.keyboard.press('Control+z');
  assert.deepEqual(await outline(), before);
  await page.keyboard.press('Control+Shift+z');
  assert.deepEqual(await outline(), turned);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+y');
  assert.deepEqual(await outline(), turned);
  await rested(page);
}

/** A surface that asks for other fields drops those of the one before. */
export async function surfaces({ page }) {
  await example(page, 'connect/b_lofted.json');
  const [id] = await state(page, 's.shape.report.flat.bends.map((b) => b.id)');
  await page.click(`[data-testid=bend-head-${id}]`);
  await page.selectOption('[data-testid=bend-surface]', 'general');
  await rested(page);
  await page.selectOption('[data-testid=bend-surface]', 'cylinder');
  await rested(page);
  assert.equal(await state(page, 's.problem'), null);
  const before = await page.inputValue('[data-testid=thickness]');
  await page.fill('[data-testid=thickness]', '77');
  await page.keyboard.press('Escape');
  assert.equal(await page.inputValue('[data-testid=thickness]'), before, 'Escape takes back what was typed');
}
