import assert from 'node:assert/strict';
import { inTheme, violations } from '../axe.mjs';
import { untilDrawn } from '../drawn.mjs';
import { folder, open, rested, state } from '../driving.mjs';

// The channel of step_files.py: 100 wide, 40 high, t 2, R 3, 160 long along x; holes of Ø 10 at (20, 20) and (80, 65).
const allowance = (Math.PI / 2) * (3 + 0.44 * 2);

const place = async (page, view, at) => {
  const p = await state(page, `views.${view}.project(${JSON.stringify(at)})`);
  await page.mouse.move(p.x, p.y);
  return p;
};

/** Clicks two places of a view, and returns what the list then says. */
async function measured(page, view, a, b = a) {
  const count = await state(page, 's.measure.kept.length');
  for (const at of [a, b]) {
    const p = await place(page, view, at);
    await page.mouse.click(p.x, p.y);
  }
  assert.equal(await state(page, 's.measure.kept.length'), count + 1, await state(page, 's.note'));
  await page.waitForFunction((n) => document.querySelectorAll('[data-testid=measures] li').length === n, count + 1);
  return page.locator('[data-testid=measures] li b').last().textContent();
}

const round = (v) => String(Number(v.toFixed(2)));

export async function measure({ page }) {
  await open(page, [`${folder(page)}/../channel.step`]);
  await page.keyboard.press('d');
  await page.waitForSelector('[data-testid=measure][aria-pressed=true]');
  // Where in the pattern the outlines and holes are.
  const { holes, box, line } = await state(
    page,
    `(() => { const c = s.shape.edge_circle, p = s.shape.points, holes = [], l = s.shape.bend_lines;
    for (let n = 0; 4 * n < c.length; ++n) if (Math.abs(c[4 * n + 2] - 5) < 1e-6) holes.push([c[4 * n], c[4 * n + 1]]);
    const of = (k) => [...p].filter((_, i) => i % 2 === k), range = (v) => [Math.min(...v), Math.max(...v)];
    return { holes, box: [range(of(0)), range(of(1))], line: [...l.slice(0, 4)] }; })()`,
  );
  const [[x0, x1], [y0, y1]] = box;
  const rim = ([x, y]) => [x + 5 * Math.cos(0.6), y + 5 * Math.sin(0.6)],
    [h, g] = holes;
  const d = [0, 1].map((k) => round(Math.abs(g[k] - h[k])));
  assert.deepEqual([...d].sort(), ['45', '60']);
  assert.equal(
    await measured(page, 'flat', rim(h), g),
    `75 mm, dx ${d[0]}, dy ${d[1]}, between rims 65, Ø 10, Ø 10`,
    'from a rim to a centre',
  );
  assert.equal(await measured(page, 'flat', rim(h)), 'Ø 10 mm', 'the same thing twice: its own size');
  const width = 90 + 70 + 2 * allowance;
  // From a side of 160 to the other: the developed width. A third of the way, away from corners and middles.
  const sides = await state(
    page,
    `(() => { const f = s.shape, own = [...f.edge_length.keys()].filter((n) => Math.abs(f.edge_length[n] - 160) < 1e-4);
    return own.map((n) => { const e = [...f.edge_number.keys()].find((i) => f.edge_number[i] === n);
      return [0, 1].map((k) => f.edges[4 * e + k] * 0.7 + f.edges[4 * e + 2 + k] * 0.3); }); })()`,
  );
  assert.equal(sides.length, 2);
  assert.equal(await measured(page, 'flat', sides[0], sides[1]), `${round(width)} mm`);
  const onLine = [0, 1].map((k) => 0.7 * line[k] + 0.3 * line[2 + k]),
    toLine = sides.map((side) => Math.hypot(...side.map((v, k) => v - onLine[k]))),
    nearest = sides[toLine[0] < toLine[1] ? 0 : 1];
  assert.equal(await measured(page, 'flat', onLine, nearest), `${round(35 + allowance / 2)} mm`, 'bend line to edge');
  // An edge across, which has the hole that is nearer to it 20 off.
  const ends = await state(
    page,
    `(() => { const f = s.shape, own = [...f.edge_length.keys()].filter((n) => Math.abs(f.edge_length[n] - 90) < 1e-4);
    return own.map((n) => { const e = [...f.edge_number.keys()].find((i) => f.edge_number[i] === n);
      return [0, 1].map((k) => f.edges[4 * e + k] * 0.7 + f.edges[4 * e + 2 + k] * 0.3); }); })()`,
  );
  const axis = Math.abs(ends[0][0] - ends[1][0]) > Math.abs(ends[0][1] - ends[1][1]) ? 0 : 1,
    off = (hole, end) => Math.abs(hole[axis] - end[axis]);
  const pair = holes.flatMap((hole) => ends.map((end) => [hole, end])).sort((a, b) => off(...a) - off(...b))[0];
  assert.equal(await measured(page, 'flat', rim(pair[0]), pair[1]), '20 mm, to the rim 15, Ø 10');
  assert.equal(await measured(page, 'flat', sides[0], ends[0]), '90°');
  assert.match(
    await measured(page, 'flat', [x0, y0], [x1, y1]),
    new RegExp(`^${round(Math.hypot(160, width))} mm, dx ${round(x1 - x0)}, dy ${round(y1 - y0)}$`),
    'corner to corner',
  );
  assert.equal(await measured(page, 'flat', [x0, y0], [h[0], h[1]]).then((t) => t.split(',').length), 5);
  await untilDrawn(page, 'flat-overlay', 1000);
  assert.deepEqual(
    await state(page, '[s.selection.part, s.selection.edge]'),
    [null, null],
    'nothing is picked meanwhile',
  );
  await page.screenshot({ path: `${folder(page)}/flat.png` });
  await page.click('[data-testid=measure-remove-1]');
  await page.waitForFunction(() => document.querySelectorAll('[data-testid=measures] li').length === 7);
  // Inches, and back.
  await page.click('[data-testid=units-inch]');
  await page.waitForFunction(() => document.querySelector('[data-testid=measure-2] b').textContent === 'Ø 0.394 in');
  await page.click('[data-testid=units-mm]');
  await page.waitForFunction(() => document.querySelector('[data-testid=measure-2] b').textContent === 'Ø 10 mm');
  await page.click('[data-testid=measure-clear]');
  await page.waitForFunction(() => !document.querySelector('[data-testid=measures] li'));
}

/** The rim of a hole that appears small is taken where the pointer is on it, not the middle of the edge beside it. */
export async function rims({ page }) {
  await open(page, [`${folder(page)}/../small.step`]);
  await page.keyboard.press('d');
  await page.waitForSelector('[data-testid=measure][aria-pressed=true]');
  // The hole of Ø 5 is 8 from the end of the base, in the middle.
  const { at, end, scale } = await state(
    page,
    `(() => { const f = s.shape, c = f.edge_circle, edges = [...f.edge_length.keys()],
      n = edges.find((e) => Math.abs(c[4 * e + 2] - 2.5) < 1e-6), at = [c[4 * n], c[4 * n + 1]],
      line = (e) => f.edges.slice(4 * f.edge_number.indexOf(e), 4 * f.edge_number.indexOf(e) + 4),
      middle = ([ax, ay, bx, by]) => [(ax + bx) / 2, (ay + by) / 2],
      middles = edges.filter((e) => Math.abs(f.edge_length[e] - 50) < 1e-3).map((e) => middle(line(e))),
      off = (m) => Math.hypot(m[0] - at[0], m[1] - at[1]);
    return { at, end: middles.sort((a, b) => off(a) - off(b))[0], scale: views.flat.scale }; })()`,
  );
  const away = Math.hypot(end[0] - at[0], end[1] - at[1]);
  assert.ok(Math.abs(away - 8) < 1e-3 && 5.5 * scale < 8.5, `the middle is ${5.5 * scale} pixels from the rim`);
  const rim = at.map((v, k) => v + (2.5 / 8) * (end[k] - v));
  assert.equal(await measured(page, 'flat', rim), 'Ø 5 mm');
  assert.equal(await measured(page, 'flat', at), 'Ø 5 mm', 'by its centre');
  assert.match(await measured(page, 'flat', at, end), /^8 mm, /, 'the middle, where the pointer is on it');
  await page.keyboard.press('2'); // from above
  await page.waitForTimeout(300);
  assert.equal(await measured(page, 'folded', [5.5, 30, 2]), 'Ø 5 mm');
  await page.screenshot({ path: `${folder(page)}/rims.png` });
}

/** In the folded part everything is where the solid has it, at any K, and not where facets are. */
export async function measurefolded({ page }) {
  await open(page, [`${folder(page)}/../channel.step`]);
  await page.click('[data-testid=tab-bends]');
  await page.fill('[data-testid=bend-k-B1]', '0.3');
  await page.keyboard.press('Enter');
  await rested(page);
  await page.keyboard.press('Escape');
  await page.click('[data-testid=measure]');
  const inner = [120, 98, 25],
    outer = [120, 0, 25],
    base = [120, 60, 2];
  assert.equal(
    await measured(page, 'folded', outer, inner),
    '98 mm',
    'from the outside of a wall to the inside of the other',
  );
  assert.equal(await measured(page, 'folded', base, inner), '90°, bend 90°');
  assert.match(
    await measured(page, 'folded', [0, 0, 40], [160, 100, 40]),
    /^188\.68 mm, dx 160, dy 100, dz 0$/,
    'outer corners of the walls',
  );
  assert.equal(await measured(page, 'folded', [80, 65, 2], inner), '33 mm', 'a hole from a wall');
  assert.match(await measured(page, 'folded', [80, 65, 2], [160, 0, 40]), /^109\.86 mm, dx 80, dy 65, dz 38, Ø 10$/);
  await untilDrawn(page, 'folded-overlay', 500);
  await page.screenshot({ path: `${folder(page)}/folded.png` });
  // Of a part that is not folded wholly it is not known where everything is.
  await page.keyboard.press('Escape');
  assert.equal(await state(page, 's.measure.on'), false, 'Escape ends it');
  assert.equal(await page.locator('[data-testid=measures] li').count(), 5, 'what was measured stays');
  await page.keyboard.press('d');
  await page.focus('[data-testid=fold-slider]');
  await page.keyboard.press('ArrowLeft');
  const p = await place(page, 'folded', [60, 75, 2]);
  await page.mouse.click(p.x, p.y);
  await page.waitForSelector('[data-testid=message]:has-text("Fold the part completely")');
  await untilDrawn(page, 'folded-overlay', 0);
  await page.focus('[data-testid=fold-slider]');
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => window.planish.store.state.fold === 1);
  await page.mouse.click(p.x, p.y);
  assert.equal(await state(page, 's.measure.first.ref.kind'), 'flange');
  await page.keyboard.press('Escape');
  assert.deepEqual(
    await state(page, '[s.measure.first, s.measure.on]'),
    [null, true],
    'Escape drops what was picked first',
  );
}

/** Where the thing that is marked is, and what is said of it. */
const marked = (page, view) =>
  page.evaluate((v) => {
    const { measuring } = window.planish.views,
      { hovered } = measuring;
    return {
      ref: hovered?.view === v ? hovered.ref : null,
      said: document.querySelector('[data-testid=measure-said]').textContent,
    };
  }, view);

/** Goes to what is said as `wanted` and lies at a place: towards it, and around what is in the way. */
async function goTo(page, view, at, wanted) {
  const to = await state(page, `views.${view}.project(${JSON.stringify(at)})`),
    seen = new Set();
  await page.keyboard.press('ArrowUp');
  for (let presses = 0; presses < 80; ++presses) {
    const { ref, said } = await marked(page, view);
    assert.ok(ref, 'something is marked');
    const [x, y] = await page.evaluate(
      ([v, r]) => {
        const stop = window.planish.measureKeys.stops(v).find(({ ref }) => JSON.stringify(ref) === JSON.stringify(r));
        const p = window.planish.views[v].project(stop.at);
        return [p.x, p.y];
      },
      [view, ref],
    );
    const [dx, dy] = [to.x - x, to.y - y];
    if (Math.hypot(dx, dy) < 3 && wanted.test(said)) return said;
    const ways = [
      [dx, 'ArrowRight'],
      [-dx, 'ArrowLeft'],
      [dy, 'ArrowDown'],
      [-dy, 'ArrowUp'],
    ].sort((a, b) => b[0] - a[0]);
    const [, key] = ways.find(([, k]) => !seen.has(`${JSON.stringify(ref)} ${k}`)) ?? ways[0];
    seen.add(`${JSON.stringify(ref)} ${key}`);
    await page.keyboard.press(key);
  }
  throw new Error(`${wanted} was not found by keys`);
}

/** By keys alone what the mouse measures: two holes, and a hole from a wall of the folded part. */
export async function measurekeys({ page }) {
  await open(page, [`${folder(page)}/../channel.step`]);
  const holes = await state(
    page,
    `(() => { const c = s.shape.edge_circle, out = new Map();
      for (let n = 0; 4 * n < c.length; ++n)
        if (Math.abs(c[4 * n + 2] - 5) < 1e-6) out.set(c[4 * n].toFixed(3), [c[4 * n], c[4 * n + 1]]);
      return [...out.values()]; })()`,
  );
  assert.equal(holes.length, 2);
  await page.keyboard.press('d');
  const text = () => page.locator('[data-testid=measures] li b').last().textContent();
  const byMouse = await measured(page, 'flat', holes[0], holes[1]);
  assert.match(byMouse, /^75 mm, .*between rims 65/, 'the distance in the file');
  await page.click('[data-testid=measure-clear]');
  await page.mouse.move(3, 3);
  await page.keyboard.press('Escape');
  assert.equal(await state(page, 's.measure.on'), false);
  // From here on nothing but keys.
  await page.keyboard.press('d');
  assert.equal(await page.evaluate(() => document.activeElement.matches('.flat .canvas')), true);
  assert.match(await page.evaluate(() => document.activeElement.ariaLabel), /Arrow keys go from one thing to the next/);
  assert.match(await goTo(page, 'flat', holes[0], /^circle in F\d, diameter 10 mm$/), /diameter/);
  await page.keyboard.press('Enter');
  await page.waitForSelector('[data-testid=measure-hint]:has-text("From the circle")');
  assert.match(
    await goTo(page, 'flat', holes[1], /^circle in F\d, diameter 10 mm/),
    /, 75 mm from circle in F\d$/,
    'what Enter would measure',
  );
  await page.keyboard.press('Enter');
  await page.waitForSelector('[data-testid=measures] li');
  assert.equal(await text(), byMouse);
  assert.equal((await marked(page, 'flat')).said, byMouse, 'and it is said');
  await untilDrawn(page, 'flat-overlay', 300);
  await page.screenshot({ path: `${folder(page)}/keys.png` });
  // In the folded part, of what is seen of it: nothing that the sheet hides is marked.
  await page.keyboard.press('v');
  assert.equal(await page.evaluate(() => document.activeElement.matches('.folded .canvas')), true);
  await goTo(page, 'folded', [80, 65, 2], /^circle in F\d, diameter 10 mm/);
  await page.keyboard.press('Enter');
  for (const key of ['ArrowUp', 'ArrowUp', 'ArrowRight', 'ArrowDown', 'ArrowLeft']) {
    await page.keyboard.press(key);
    const { ref } = await marked(page, 'folded');
    assert.ok(
      await page.evaluate((r) => {
        const stop = window.planish.measureKeys
          .stops('folded')
          .find(({ ref }) => JSON.stringify(ref) === JSON.stringify(r));
        return !stop.onSheet || window.planish.views.folded.under.isSeen(stop.at);
      }, ref),
    );
  }
  // The wall whose inside is seen.
  const wall = await page.evaluate(
    () =>
      window.planish.measureKeys
        .stops('folded')
        .find(({ ref, at }) => ref.kind === 'flange' && Math.abs(at[1] - 98) < 1e-3)?.at,
  );
  await goTo(page, 'folded', wall, /^F\d, 33 mm from circle in F\d$/);
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.querySelectorAll('[data-testid=measures] li').length === 2);
  assert.equal(await text(), '33 mm');
  await page.screenshot({ path: `${folder(page)}/keys-folded.png` });
  // A part that is not wholly folded says why it is not measured; Escape ends it, and the views let the focus go.
  await page.evaluate(() => window.planish.store.dispatch({ type: 'fold', fold: 0.5 }));
  await page.keyboard.press('ArrowUp');
  await page.waitForSelector('[data-testid=message]:has-text("Fold the part completely")');
  await page.keyboard.press('Escape');
  assert.equal(await state(page, 's.measure.on'), false);
  assert.equal(await page.getAttribute('.flat .canvas', 'role'), 'img');
  assert.equal(await page.evaluate(() => document.activeElement.matches('.canvas')), false);
}

/** Many measures leave most of the part to be seen; the last one is in the list, the others are scrolled to. */
export async function manymeasures({ page }) {
  await open(page, [`${folder(page)}/../channel.step`]);
  await page.keyboard.press('d');
  await page.evaluate(() => {
    const { dispatch } = window.planish.store;
    for (let i = 0; i < 12; ++i)
      for (const edge of [i % 4, (i + 1) % 4])
        dispatch({ type: 'measure-pick', view: 'flat', ref: { kind: 'edge', edge } });
  });
  for (const stacked of [false, true]) {
    await page.evaluate(
      (arrangement) => window.planish.store.dispatch({ type: 'view', view: { arrangement } }),
      stacked ? 'stacked' : 'beside',
    );
    await page.waitForTimeout(200);
    const { list, view, last, clear } = await page.evaluate(() => {
      const box = (selector) => document.querySelector(selector).getBoundingClientRect().toJSON();
      return {
        list: box('.measures'),
        view: box('.view.folded'),
        last: box('.measures li:last-child'),
        clear: box('[data-testid=measure-clear]'),
      };
    });
    assert.ok(list.height < view.height / 3 + 1, `${list.height} of ${view.height}`);
    if (stacked) continue;
    assert.ok(last.top >= list.top && last.bottom <= clear.top + 1 && clear.bottom <= list.bottom, 'the last is seen');
    for (const theme of ['light', 'dark']) {
      await inTheme(page, theme);
      assert.deepEqual(await violations(page), [], theme);
      await page.screenshot({ path: `${folder(page)}/${theme}.png` });
    }
    await page.click('[data-testid=measure-remove-1]'); // it is scrolled to
    await page.waitForFunction(() => document.querySelectorAll('.measures li').length === 11);
  }
}
