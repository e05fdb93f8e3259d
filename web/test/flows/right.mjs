import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { download, drag, enter, example, folder, open, rested, state } from '../driving.mjs';
import { perforated } from '../perforated.mjs';

// What is shown and said must be so: curves, circles, units, refused values, the bodies of an assembly.

const seeds = new URL('../../../tests/fuzz/seeds/', import.meta.url);

/** The number of an edge of the smallest circle that goes all round; several edges may make one. */
const smallest = `(() => { const c = s.shape.edge_circle, turned = new Map();
  for (let n = 0; 4 * n < c.length; ++n) if (c[4 * n + 2] > 0) {
    const key = [0, 1, 2].map((k) => c[4 * n + k].toFixed(3)).join(' '), known = turned.get(key) ?? { n, sum: 0 };
    known.sum += Math.abs(c[4 * n + 3]);
    turned.set(key, known); }
  return [...turned.values()].filter(({ sum }) => Math.abs(sum - 2 * Math.PI) < 1e-3)
    .sort((a, b) => c[4 * a.n + 2] - c[4 * b.n + 2])[0].n; })()`;

/** The farthest that an edge's chords lie from its circle, in pixels of the flat view. */
const sagitta = (n) => `(() => { const { edges: e, edge_number, edge_circle: c } = s.shape, n = ${n};
  let most = 0;
  edge_number.forEach((number, i) => {
    if (number !== n) return;
    const x = (e[4 * i] + e[4 * i + 2]) / 2 - c[4 * n], y = (e[4 * i + 1] + e[4 * i + 3]) / 2 - c[4 * n + 1];
    most = Math.max(most, c[4 * n + 2] - Math.hypot(x, y)); });
  return most * Math.max(views.flat.scale, views.folded.scale); })()`;

export async function circle({ page }) {
  await example(page, 'bracket.step');
  const n = await state(page, smallest),
    [x, y, radius] = await state(page, `[...s.shape.edge_circle.subarray(${4 * n}, ${4 * n + 4})]`),
    // a point of the edge, wherever on its circle it begins
    rim = `(() => { const i = s.shape.edge_number.indexOf(${n}), e = s.shape.edges,
      a = Math.atan2(e[4 * i + 1] - ${y}, e[4 * i] - ${x});
      return views.flat.project([${x} + ${radius} * Math.cos(a), ${y} + ${radius} * Math.sin(a)]); })()`;
  const at = await state(page, rim),
    size = (v) => String(Math.round(100 * v) / 100);
  await page.mouse.click(at.x, at.y);
  await page.waitForSelector(
    `[data-testid=message]:has-text("Ø ${size(2 * radius)} mm, ${size(2 * Math.PI * radius)} mm long")`,
  );
  await page.screenshot({ path: `${folder(page)}/circle.png` });
  // Drawn to a quarter of a pixel, as it is fitted and after each turn of the wheel.
  for (let turns = 0; turns < 4; ++turns) {
    await page.waitForFunction(
      `(() => { const s = window.planish.store.state, views = window.planish.views;
        return ${sagitta(n)} <= 0.251 && !s.computing; })()`,
      null,
      { timeout: 20000 },
    );
    if (turns === 3) break;
    const at = await state(page, rim);
    await page.mouse.move(at.x, at.y);
    await page.mouse.wheel(0, -700);
  }
  assert.notEqual(await state(page, 's.selection.edge'), null, 'what is picked stays picked');
  // The folded view likewise.
  await page.click('[data-testid=view-fit]');
  const inSpace = await state(
    page,
    `(() => { const l = views.folded.sheet.lines().find(({ line }) => line.edge === ${n});
      return views.folded.project(l.ends[0]); })()`,
  );
  await page.mouse.move(inSpace.x, inSpace.y);
  const before = await state(page, 'views.folded.scale');
  for (let turns = 0; turns < 20; ++turns) await page.mouse.wheel(0, -300);
  await page.waitForTimeout(100);
  assert.ok((await state(page, 'views.folded.scale')) > 5 * before, 'it zoomed in');
  await page.waitForFunction(
    `(() => { const s = window.planish.store.state, views = window.planish.views;
      return ${sagitta(n)} <= 0.251 && !s.computing; })()`,
    null,
    { timeout: 20000 },
  );
  await page.waitForTimeout(100);
  await page.screenshot({ path: `${folder(page)}/zoomed.png` });
}

/** A file of three bodies, of which the first is a block. */
function blockFirst(page) {
  const file = `${folder(page)}/assembly.step`,
    text = readFileSync(new URL('several.step', seeds), 'utf8').replace(/\r?\n\s*/g, '\n');
  const found = [...text.matchAll(/=\s*ADVANCED_BREP_SHAPE_REPRESENTATION\('[^']*',\((#\d+),(#\d+)\)/g)],
    solid = (m) => m[2],
    [first, last] = [solid(found[0]), solid(found.at(-1))];
  writeFileSync(
    file,
    text.replace(
      /(=\s*ADVANCED_BREP_SHAPE_REPRESENTATION\('[^']*',\(#\d+,)(#\d+)/g,
      (_, head, body) => head + (body === first ? last : body === last ? first : body),
    ),
  );
  return file;
}

export async function assembly({ page }) {
  await open(page, [blockFirst(page)]);
  const bodies = await state(page, 's.document.info.bodies.map((b) => b.number)');
  assert.equal(bodies.length, 3);
  assert.equal(await state(page, 's.input.options.body'), 2, 'it opens on the first sheet');
  assert.equal(await state(page, 's.past.length'), 0, 'which is no edit');
  await page.waitForFunction(() => Object.keys(window.planish.store.state.bodies).length === 3);
  await page.waitForTimeout(100);
  const list = await page.$$eval('[data-testid=bodies] [role=option]', (all) => all.map((o) => o.textContent));
  assert.match(list[0], /no flat pattern: not a sheet/);
  assert.match(list[1], /sheet/);
  assert.match(list[2], /sheet/);
  await page.screenshot({ path: `${folder(page)}/bodies.png` });
  await page.click('[data-testid=body-3]');
  await rested(page);
  assert.equal((await state(page, 's.shape.report.status')) === 'refused', false);
}

export async function refused({ page }) {
  await example(page, 'bracket.step');
  const said = async (text) => page.waitForSelector(`[data-testid=message]:has-text("${text}")`);
  await page.selectOption('[data-testid=k-rule]', 'number');
  for (const [entered, sentence] of [
    ['5', 'K of the part cannot be 5; it must be from 0 to 1.'],
    ['abc', '“abc” is not a number'],
  ]) {
    await enter(page, 'k-number', entered);
    await said(sentence);
    assert.equal(await page.inputValue('[data-testid=k-number]'), '0.44');
  }
  await page.screenshot({ path: `${folder(page)}/refused.png` });
  await page.click('[data-testid=tab-bends]');
  await enter(page, 'bend-k-B1', '-1');
  await said('K of B1 cannot be -1; it must be from 0 to 1.');
  await example(page, 'connect/a_folded.json');
  await page.click('[data-testid=tab-input]');
  const before = await page.inputValue('[data-testid=thickness]');
  await enter(page, 'thickness', '-3');
  await said('cannot be -3');
  assert.equal(await page.inputValue('[data-testid=thickness]'), before);
  await enter(page, 'thickness', '2.5');
  await rested(page);
  assert.equal(await state(page, 's.note'), null, 'it goes with the next edit');
  // Nor is any other value bent into one that can be.
  const kept = async (field, entered, sentence) => {
    const was = await page.inputValue(`[data-testid="${field}"]`),
      input = await state(page, 's.input');
    await enter(page, field, entered);
    await said(sentence);
    assert.equal(await page.inputValue(`[data-testid="${field}"]`), was);
    assert.deepEqual(await state(page, 's.input'), input);
  };
  await example(page, 'transition/a_square_to_round.json');
  await kept('from-width-number', '-3', 'Width cannot be -3; it must be above 0.');
  await kept('from-width-number', '0', 'Width cannot be 0; it must be above 0.');
  await kept('to-radius-number', 'big', '“big” is not a number; Radius needs one.');
  await page.selectOption('[data-testid=press-lines]', 'count');
  await rested(page);
  await kept('press-count-number', '2.5', 'Lines per bend cannot be 2.5; it must be a whole number.');
  await example(page, 'slit/chair.json');
  await kept('panel-height', '0', 'Panel height cannot be 0; it must be above 0.');
  await kept('ridges', '10.5', 'Ridges at the start cannot be 10.5; it must be a whole number.');
  await kept('strips', '2.4', 'Strips cannot be 2.4; it must be a whole number.');
  await kept('weight-spacing-number', '-1', 'Spacing cannot be -1');
}

/** The page's unit is that of the DXF, which says so; another can be chosen. */
export async function dxfunit({ page }) {
  await example(page, 'bracket.step');
  const unit = async () => {
    const text = readFileSync(await download(page, 'dxf'), 'utf8')
      .split(/\r?\n/)
      .map((line) => line.trim());
    return { 1: 'inch', 4: 'mm' }[text[text.indexOf('$INSUNITS') + 2]];
  };
  const shown = () => page.inputValue('[data-testid=dxf-units]');
  assert.deepEqual([await shown(), await unit()], ['mm', 'mm']);
  await page.click('[data-testid=units-inch]');
  await page.waitForTimeout(100);
  assert.deepEqual([await shown(), await unit()], ['inch', 'inch']);
  await page.click('[data-testid=download-menu]');
  await page.screenshot({ path: `${folder(page)}/menu.png` });
  await page.selectOption('[data-testid=dxf-units]', 'mm');
  await page.click('[data-testid=download-menu]');
  assert.deepEqual([await shown(), await unit()], ['mm', 'mm']);
}

/** Where a plate is seen in the folded view. */
const middleOf = (id) => `(() => { const c = s.shape.handles.plates.find((p) => p.id === '${id}').corners;
  return views.folded.project([0, 1, 2].map((k) => c.reduce((t, p) => t + p[k], 0) / c.length)); })()`;

export async function reload({ page }) {
  await example(page, 'connect/a_folded.json');
  const outline = () => state(page, `s.input.spec.plates.find((p) => p.id === 'right').outline`),
    before = await outline();
  await page.click('[data-testid=plate-right]');
  await page.waitForTimeout(200);
  await drag(page, await state(page, middleOf('right')), { x: 40, y: 12 }, 10);
  await rested(page);
  const moved = await outline();
  assert.notDeepEqual(moved, before);
  await page.reload();
  await page.waitForFunction(() => window.planish?.store.state.document);
  await rested(page);
  assert.deepEqual(await outline(), moved, 'what was dragged is there again');
  await page.click('[data-testid=undo]');
  await rested(page);
  assert.deepEqual(await outline(), before, 'and can be undone still');
  await page.reload();
  await page.waitForFunction(() => window.planish?.store.state.document);
  await rested(page);
  assert.deepEqual(await outline(), before);
  await page.click('[data-testid=redo]');
  await rested(page);
  assert.deepEqual(await outline(), moved, 'and done again');
}

/** While a plate is moved its bends keep their names, and the pattern lies as it did. */
export async function steady({ page }) {
  await example(page, 'connect/a_folded.json');
  const named = () =>
      state(page, `s.shape.report.flat.bends.map((b) => [b.id, [...b.between].sort().join('–')].join(' ')).sort()`),
    // the way of the first bend in the flat pattern
    lies = () =>
      state(
        page,
        `(() => { const l = s.shape.bend_lines,
          i = [...s.shape.bend_line_part.keys()].find((k) => s.shape.parts[s.shape.bend_line_part[k]].name === 'B1');
          return Math.abs(l[4 * i + 2] - l[4 * i]) > Math.abs(l[4 * i + 3] - l[4 * i + 1]) ? 'across' : 'up'; })()`,
      );
  const [names, way] = [await named(), await lies()];
  const move = async (by) => {
    await page.evaluate(`(() => { const { store } = window.planish, { input } = store.state;
      const plates = input.spec.plates.map((p) => p.id !== 'top' ? p :
        { ...p, outline: p.outline.map(([x, y, z]) => [x + ${by[0]}, y + ${by[1]}, z + ${by[2]}]) });
      store.dispatch({ type: 'edit', input: { ...input, spec: { ...input.spec, plates } } }); })()`);
    await rested(page);
  };
  for (const by of [
    [0, 0, 60],
    [0, 0, 190],
  ]) {
    await move(by);
    assert.deepEqual(await named(), names, `bends keep their names after ${by}`);
    assert.equal(await lies(), way, `the pattern lies as it did after ${by}`);
  }
  // It is as high as it was wide now: in the files it is laid the other way.
  assert.notEqual(await state(page, 's.shape.turn'), 0);
  await page.screenshot({ path: `${folder(page)}/steady.png` });
}

/** Where a plate that is moved is joined to another one, the bend that was chosen stays chosen, whatever its number. */
export async function chosen({ page }) {
  await example(page, 'connect/ten_plates.json');
  const pair = () =>
    state(
      page,
      `(() => { const b = s.shape.report.flat.bends.find((x) => x.id === s.selection.part);
        return [b?.id, b?.between.join('–')]; })()`,
    );
  await page.click('[data-testid=bend-head-B7]');
  assert.deepEqual(await pair(), ['B7', 'back–hook']);
  await page.evaluate(`(() => { const { store } = window.planish, { input } = store.state;
    const plates = input.spec.plates.map((p) => p.id !== 'spout' ? p :
      { ...p, outline: p.outline.map(([x, y, z]) => [x - 2.88, y - 4.512, z - 2.905]) });
    store.dispatch({ type: 'edit', input: { ...input, spec: { ...input.spec, plates } } }); })()`);
  await rested(page);
  const [id, between] = await pair();
  assert.notEqual(id, 'B7', 'another bend comes before it now');
  assert.equal(between, 'back–hook');
  await page.waitForSelector(`[data-testid=bend-head-${id}][aria-expanded=true]`);
}

/** A plate with 200 holes too near to each other: one mark for the rule, and one for each place once it is chosen. */
export async function marks({ page }) {
  await open(page, [perforated(`${folder(page)}/perforated.json`, { holes: 200, from: 3, high: 40 })]);
  const [rules, places] = await state(
      page,
      `[s.result.report.checks.length,
    s.result.report.checks.map((f) => f.count ?? f.at?.length ?? 0)]`,
    ),
    many = places.indexOf(Math.max(...places));
  assert.ok(places[many] >= 100, `places by rule: ${places}`);
  const shown = () => state(page, 'views.flat.marks.length');
  assert.ok((await shown()) <= rules, `${await shown()} marks of ${rules} rules`);
  await page.screenshot({ path: `${folder(page)}/marks.png` });
  await page.click('[data-testid=tab-findings]');
  await page.click(`[data-testid=finding-${many + 1}]`);
  await page.waitForTimeout(300);
  assert.ok((await shown()) >= places[many], 'the chosen one has a mark at each place');
  await page.screenshot({ path: `${folder(page)}/chosen.png` });
  // By severity: what is left out has no marks, and the others keep their numbers.
  const severity = await state(page, `s.result.report.checks[${many}].severity`),
    rows = () => page.locator('[data-testid=findings] > li').count(),
    own = await state(page, `s.result.report.checks.filter((f) => f.severity === '${severity}').length`);
  await page.click(`[data-testid=show-${severity}]`);
  await page.waitForTimeout(300);
  assert.equal(await rows(), rules - own);
  assert.ok((await shown()) <= rules - own);
  await page.click(`[data-testid=show-${severity}]`);
  await page.waitForTimeout(300);
  assert.equal(await rows(), rules);
  // By keys.
  await page.focus(`[data-testid=finding-${many + 1}] button`);
  await page.keyboard.press('Enter');
  assert.equal(await state(page, 's.selection.finding'), null);
  await page.keyboard.press('Enter');
  assert.equal(await state(page, 's.selection.finding'), many);
}
