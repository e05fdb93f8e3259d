import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { coarse, download, drag, enter, example, open, rested, state, timings } from '../driving.mjs';

export async function slit({ page }) {
  await example(page, 'slit/chair.json');
  await page.evaluate(() => {
    window.planishTimings.length = 0;
  });
  await page.locator('[data-testid=curve-seat-2]').scrollIntoViewIfNeeded();
  const circle = await page.locator('[data-testid=curve-seat-2]').boundingBox();
  await drag(page, { x: circle.x + circle.width / 2, y: circle.y + circle.height / 2 }, { x: 12, y: -6 }, 20);
  await rested(page);
  assert.ok(await page.evaluate(() => window.planishTimings.length), 'the sheet follows the drag');
  timings('slit, seat curve', await page.evaluate(() => window.planishTimings));
  const end = await state(
    page,
    `(() => {
    const r = s.shape.handles.ridges[2], row = r[Math.floor(r.length / 2)];
    return { at: row[0], on: views.folded.project(row[0]) }; })()`,
  );
  await page.mouse.click(end.on.x, end.on.y);
  await rested(page);
  assert.equal(await state(page, 's.input.spec.anchors.length'), 1);
  await page.evaluate(() => {
    window.planishTimings.length = 0;
  });
  await drag(page, end.on, { x: 0, y: -25 }, 20);
  await rested(page);
  timings('slit, anchor', await page.evaluate(() => window.planishTimings));
  const at = await state(page, 's.input.spec.anchors[0].at');
  assert.ok(Math.hypot(...at.map((v, k) => v - end.at[k])) > 3, 'the anchor moved');
  return download(page, 'dxf');
}

export async function strips({ page }) {
  await open(page, [coarse(page, 'plume.json')]);
  const width = () => state(page, 's.shape.report.flat.size'),
    before = await width();
  await page.click('[data-testid=strip-head-1]');
  for (const key of ['direction', 'across']) {
    await page.check(`[data-testid=end-${key}]`);
    await rested(page);
    assert.equal(await state(page, 's.problem'), null);
  }
  assert.deepEqual(Object.keys(await state(page, 's.input.spec.ends[1]')), [
    'strip',
    'position',
    'direction',
    'across',
  ]);
  await enter(page, 'strip-width', '230');
  await rested(page);
  const wider = await width();
  assert.ok(
    wider.some((v, k) => Math.abs(v - before[k] - 10) < 1e-6),
    `${before} has become ${wider}`,
  );
  await page.selectOption('[data-testid=strip-kind]', 'one');
  await rested(page);
  assert.equal(await state(page, 's.input.spec.sheet.strips'), 7);
  for (let n = await state(page, 's.past.length'); n > 0; --n) await page.keyboard.press('Control+z');
  await rested(page);
  assert.equal((await state(page, 's.input.spec.sheet.strips'))[1].width, 220);
}

export async function points({ page }) {
  await open(page, [coarse(page, 'chair.json')]);
  const at = () => state(page, 's.input.spec.seat_curve.bezier'),
    before = await at();
  await page.click('[data-testid=curve-seat-1]');
  await enter(page, 'curve-seat-y', '310');
  await rested(page);
  assert.deepEqual(
    await at(),
    before.map((p, i) => (i === 1 ? [310, p[1]] : p)),
  );
  await page.locator('[data-testid=curve-seat-y]').blur();
  await page.keyboard.press('Delete');
  assert.deepEqual(
    await at(),
    before.filter((_, i) => i !== 1),
  );
  await page.focus('[data-testid=curve-seat-0]');
  await page.keyboard.press('Space');
  assert.ok(await page.isDisabled('[data-testid=curve-seat-remove]'), 'the ends stay');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  assert.deepEqual(await at(), before);
  await rested(page);
}

export async function scan({ page }) {
  const folder = new URL('../../../examples/slit/', import.meta.url).pathname;
  await open(page, [
    coarse(page, 'scanned_chair.json'),
    ...[0, 1, 2, 3, 4, 5].map((i) => `${folder}low_chair_scan${i}.xyz`),
  ]);
  assert.match(await page.textContent('[data-testid=scan-state]'), /Scanned strips: 6; points drawn: [1-9]/);
  const distance = () => state(page, 's.shape.report.slit.strips.map((t) => t.scan_distance)'),
    before = await distance();
  await page.check('[data-testid=align-scan]');
  await rested(page);
  assert.equal(await state(page, 's.problem'), null);
  const after = await distance();
  assert.notDeepEqual(after, before);
  after.forEach((d) => assert.ok(d < 2, `the scans lie ${after} mm from their strips`));
}

/** Slits that are curves: made from straight ones, dragged on the flat pattern, with a point more and a point less. */
export async function curves({ page }) {
  await open(page, [coarse(page, 'chair.json')]);
  await page.click('[data-testid=slits-curved]');
  await rested(page);
  assert.equal(await state(page, 's.problem'), null);
  const slit = () => state(page, 's.input.spec.slits[1].bezier'),
    before = await slit(),
    area = await state(page, 's.shape.report.flat.area');
  assert.deepEqual(before[1], [574.667, 120]);
  const grip = await state(page, 'views.flat.project([574.667, 120])');
  await drag(page, grip, { x: 0, y: -4 }, 12);
  await rested(page);
  assert.equal(await state(page, 's.problem'), null);
  const after = await slit();
  assert.ok(after[1][1] > 121 && Math.abs(after[1][0] - before[1][0]) < 1, `dragged to ${after[1]}`);
  assert.deepEqual(await state(page, 's.selection.point'), { curve: 'slits-1', index: 1 });
  const now = await state(page, 's.shape.report.flat.area');
  assert.ok(Math.abs(now - area) < 1e-6 * area, 'a slit without width takes nothing away');
  assert.match(await page.textContent('[data-testid=energy]'), /energy [\d.]+ → [\d.]+/);
  assert.match(await page.textContent('[data-testid=least-radius]'), /least radius/);
  await page.screenshot({ path: '/tmp/planish-slit-curves.png' });
  await page.click('[data-testid=slit-raise]');
  await rested(page);
  assert.equal((await slit()).length, 5);
  await page.keyboard.press('Delete');
  await rested(page);
  assert.equal((await slit()).length, 4);
  const end = await state(page, 'views.flat.project([884, 120])');
  await drag(page, end, { x: -9, y: -3 }, 6);
  await rested(page);
  const [x, y] = (await slit())[3];
  assert.ok(x === 884 && y > 121, `the slit ends with the strips, at ${x}, ${y}`);
  const moved = await state(page, `views.flat.project([${x}, ${y}])`);
  await page.mouse.dblclick(moved.x, moved.y);
  await rested(page);
  assert.equal((await slit()).length, 5);
  for (let n = await state(page, 's.past.length'); n > 0; --n) await page.keyboard.press('Control+z');
  await rested(page);
  assert.equal(await state(page, 's.input.spec.slits'), undefined);
  assert.equal(await state(page, 's.input.spec.sheet.strips'), 6);
}

/** Under weight and loads: what is said beside the picture, the colours, a strip that is pulled and let go. */
export async function loads({ page }) {
  await open(page, [coarse(page, 'stool.json')]);
  const facts = () => page.textContent('[data-testid=slit-facts]');
  assert.match(await facts(), /energy [\d.]+ J\s*least radius [\d.]+ mm\s*stands, may be tilted by 1\d\.\d°/);
  await page.click('[data-testid=bending]');
  assert.match(await page.textContent('[data-testid=bending-scale]'), /radius 2\d\d\.?\d* mm, \d+ N\/mm² of 1100/);
  const end = await state(
    page,
    `(() => { const r = s.shape.handles.ridges[1], row = r[Math.floor(r.length / 2)][0];
    return { ...views.folded.project(row), eye: views.folded.direction }; })()`,
  );
  await drag(page, end, { x: 0, y: 8 }, 8);
  await rested(page);
  assert.equal(await state(page, 's.input.spec.anchors.length'), 1, 'a strip that is pulled has an anchor');
  assert.deepEqual(await state(page, 'views.folded.direction'), end.eye, 'the view stays');
  await page.keyboard.press('Delete');
  await rested(page);
  assert.equal(await state(page, 's.input.spec.anchors'), undefined);
  await page.click('[data-testid=load-add]');
  await rested(page);
  const loads = await state(page, 's.input.spec.loads');
  assert.deepEqual(loads.at(-1), { strip: 0, at: 1, force: [0, -100, 0] });
  await page.locator(`[data-testid=load-${loads.length - 1}] [data-testid=load-y]`).fill('-9000');
  await page.keyboard.press('Enter');
  await rested(page);
  assert.ok((await state(page, 's.problem')) || /not stable|N\/mm²/.test(await facts()), 'it is told');
}

/** An outline is dragged by its corners; the strips before are drawn faintly beside those that are. */
export async function outline({ page }) {
  const path = coarse(page, 'chair.json'),
    { strips: _strips, strip_width: _width, ...sheet } = JSON.parse(readFileSync(path, 'utf8')).sheet;
  writeFileSync(
    path,
    JSON.stringify({
      ...JSON.parse(readFileSync(path, 'utf8')),
      sheet,
      slits: [120, 240].map((across) => ({ points: [420, 884].map((along) => [along, across]) })),
      outline: [
        {
          points: [
            [0, 0],
            [420, 0],
            [650, 0],
            [884, 0],
            [884, 360],
            [650, 360],
            [420, 360],
            [0, 360],
          ],
        },
      ],
    }),
  );
  await open(page, [path]);
  assert.equal(await state(page, 's.problem'), null);
  const corners = () => state(page, 's.input.spec.outline[0].points'),
    area = () => state(page, 's.shape.report.flat.area'),
    faint = () =>
      state(
        page,
        `views.folded.handles.group.children
          .filter((c) => c.isLineLoop && c.material.opacity < 0.5)
          .map((c) => [...c.geometry.attributes.position.array])`,
      ),
    edges = () => state(page, 's.shape.handles.ridges.map((r) => r[5][0])');
  assert.equal((await faint()).length, 0, 'nothing is before the first shape');
  const before = await area(),
    middle = await edges();
  await drag(page, await state(page, 'views.flat.project([650, 0])'), { x: 0, y: 6 }, 12);
  await rested(page);
  assert.equal(await state(page, 's.problem'), null);
  const [along, across] = (await corners())[2];
  assert.ok(across < -1 && Math.abs(along - 650) < 1, `dragged to ${along}, ${across}`);
  assert.deepEqual(await state(page, 's.selection.point'), { curve: 'outline-0', index: 2 });
  // A triangle on the side of each half.
  const grown = 2 * 0.5 * (884 - 420) * -across;
  assert.ok(Math.abs((await area()) - before - grown) < 0.01, `${await area()} is not ${grown} more than ${before}`);
  const drawn = await faint();
  assert.equal(drawn.length, 3, 'each strip is drawn as it was');
  middle.forEach((at, strip) =>
    at.forEach((v, k) => assert.ok(Math.abs(drawn[strip][3 * 5 + k] - v) < 0.01, `strip ${strip} was at ${at}`)),
  );
  assert.notDeepEqual(await edges(), middle);
  await page.keyboard.press('Delete');
  await rested(page);
  assert.equal((await corners()).length, 7);
  for (let n = await state(page, 's.past.length'); n > 0; --n) await page.keyboard.press('Control+z');
  await rested(page);
  assert.ok(Math.abs((await area()) - before) < 1e-6);
}
