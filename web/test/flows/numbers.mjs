import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { channel } from '../channel.mjs';
import { checked, plan, strokeNames } from '../ordering.mjs';
import { enter, example, folder, open, rested, state } from '../driving.mjs';

// Figures as they are shown, entered and refused, and modes that end each other.

const text = (page, id) => page.textContent(`[data-testid=${id}]`).then((t) => t.trim());
const note = (page) => state(page, 's.note');

/** Each outside length says whose it is: by name, and in both views under the pointer. */
export async function whoselength({ page }) {
  await open(page, [`${folder(page)}/../channel.step`]);
  await page.click('[data-testid=tab-bends]');
  const cell = page.locator('[data-testid=outside-B1]'),
    numbers = cell.locator('.outside');
  await numbers.nth(1).waitFor();
  assert.equal(await numbers.count(), 2);
  const names = await numbers.evaluateAll((all) => all.map((e) => e.title.replace('Flange ', ''))),
    texts = await numbers.allTextContents();
  assert.equal(await cell.getAttribute('aria-label'), names.map((n, i) => `${n} ${texts[i]}`).join(', '));
  const lit = () => state(page, 'views.hovered && s.shape.parts[views.hovered.part].name');
  for (const [i, name] of names.entries()) {
    await numbers.nth(i).hover();
    assert.equal(await lit(), name);
    await page.screenshot({ path: `${folder(page)}/${name}.png` });
  }
  await page.hover('[data-testid=deduction-B1]');
  assert.equal(await lit(), null);
  // A web of 100 between two bends is as long from either side.
  const [, other] = await page.$$eval('[data-testid^=outside-B]', (all) => all.map((e) => e.ariaLabel.split(', ')));
  const shared = other.find((said) => names.includes(said.split(' ')[0]));
  assert.ok((await cell.getAttribute('aria-label')).split(', ').includes(shared), shared);
}

/** Gauges have the digits of the sheet's thickness, and a half is rounded alike everywhere. */
export async function gaugedigits({ page }) {
  const shop = `${folder(page)}/inches.json`,
    gauges = [0.0598, 0.0625, 0.125].map((thickness) => ({ thickness, inside_radius: 0.0625, k: 0.4 }));
  writeFileSync(
    shop,
    JSON.stringify({
      format: 'planish/shop',
      version: 1,
      name: 'By inches',
      units: 'inch',
      materials: [{ name: 'steel', gauges }],
    }),
  );
  await open(page, [`${folder(page)}/../channel.step`]);
  await page.selectOption('[data-testid=k-rule]', 'shop');
  await page.setInputFiles('[data-testid=shop-open]', shop);
  await page.waitForSelector('[data-testid=gauges]');
  const column = (n) =>
    page.$$eval(`[data-testid=gauges] tbody td:nth-child(${n})`, (all) =>
      all.map((e) => e.textContent.replace('✓', '').trim()),
    );
  await page.click('[data-testid=units-mm]');
  assert.deepEqual(await column(1), ['1.519', '1.588', '3.175']);
  assert.deepEqual(await column(2), ['1.59', '1.59', '1.59']);
  await page.click('[data-testid=units-inch]');
  await page.waitForSelector('[data-testid=gauges] th:has-text("Thickness in")');
  assert.deepEqual(await column(1), ['0.0598', '0.0625', '0.125']);
  assert.deepEqual(await column(2), ['0.063', '0.063', '0.063']);
  await page.screenshot({ path: `${folder(page)}/gauges.png` });
}

/** Measuring and picking a flange end each other, and the button makes one sentence with what stands beside it. */
export async function onemode({ page }) {
  await example(page, 'bracket.step');
  const pressed = (id, on) => page.waitForSelector(`[data-testid=${id}][aria-pressed=${on}]`);
  await page.click('[data-testid=measure]');
  await pressed('measure', true);
  await page.click('[data-testid=pick-root]');
  await pressed('pick-root', true);
  await pressed('measure', false);
  assert.equal(
    `${await text(page, 'pick-root')} ${await text(page, 'pick-hint')}`,
    'Click a flange in a view; Esc cancels',
  );
  await page.screenshot({ path: `${folder(page)}/picking.png` });
  await page.click('[data-testid=measure]');
  await pressed('measure', true);
  await pressed('pick-root', false);
  // What is measured stays when a flange is picked, and the click in the view picks it.
  await page.keyboard.press('d');
  await page.click('[data-testid=pick-root]');
  const row = await state(page, "s.shape.parts.findIndex((p) => p.name === 'F2')"),
    at = await page.evaluate((part) => {
      const { store, views } = window.planish,
        { shape } = store.state,
        f = shape.facet_part.indexOf(part),
        first = shape.ring_starts[shape.polygon_starts[shape.facet_starts[f]]],
        end = shape.ring_starts[shape.polygon_starts[shape.facet_starts[f]] + 1];
      const middle = [0, 1].map((k) => {
        let sum = 0;
        for (let i = first; i < end; ++i) sum += shape.points[2 * i + k];
        return sum / (end - first);
      });
      const p = views.flat.project(middle);
      return Array.isArray(p) ? { x: p[0], y: p[1] } : p;
    }, row);
  await page.mouse.click(at.x, at.y);
  await rested(page);
  assert.equal(await state(page, 's.input.options.root'), await state(page, `s.shape.parts[${row}].faces[0]`));
}

/** What was said of a wrong entry goes once one is right; what was clicked with a wrong entry is not done. */
export async function wrongentry({ page }) {
  await example(page, 'bracket.step');
  await page.click('[data-testid=download-menu]');
  await enter(page, 'dxf-arcs', 'abc');
  assert.match(await note(page), /“abc” is not a number; Arcs within needs one/);
  await enter(page, 'dxf-arcs', '5');
  assert.equal(await note(page), null);
  await enter(page, 'dxf-arcs', 'abc');
  await enter(page, 'dxf-arcs', '5'); // what it was
  await page.waitForFunction(() => window.planish.store.state.note === null);
  // Pressed with the entry still in the field.
  let files = 0;
  page.on('download', () => ++files);
  await page.fill('[data-testid=dxf-arcs]', 'abc');
  await page.click('[data-testid=download-dxf]');
  await page.waitForTimeout(500);
  assert.equal(files, 0);
  assert.match(await note(page), /“abc” is not a number/);
  assert.equal(await page.isVisible('[data-testid=download-dxf]'), true);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.testid), 'dxf-arcs');
  await page.screenshot({ path: `${folder(page)}/refused.png` });
  await page.keyboard.type('0.02');
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('[data-testid=download-dxf]')]);
  const path = `${folder(page)}/${file.suggestedFilename()}`;
  await file.saveAs(path);
  assert.match(readFileSync(path, 'utf8').slice(0, 200), /SECTION/);
  assert.equal(await note(page), null);
  assert.equal(await state(page, 's.workshop.dxf.arc_tolerance'), 0.02);
}

/** The bend that is picked is the one of the stroke that is shown; a row's own buttons know its keys. */
export async function strokefollows({ page }) {
  const picked = () => state(page, 's.selection.part');
  await open(page, [channel(page)]);
  await plan(page);
  const [first, second] = await strokeNames(page);
  await page.dragAndDrop('[data-testid=stroke-2]', '[data-testid=stroke-1]', { targetPosition: { x: 60, y: 4 } });
  await page.waitForFunction(() => window.planish.store.state.order.given);
  await checked(page);
  assert.deepEqual(await strokeNames(page), [second, first]);
  await page.click('[data-testid=stroke-2]');
  assert.equal(await picked(), first);
  await page.click('[data-testid=undo]');
  await checked(page);
  assert.equal(await picked(), second, 'the bend of stroke 2 of 2');
  await page.screenshot({ path: `${folder(page)}/undone.png` });
  await page.keyboard.press('Control+y');
  await checked(page);
  assert.equal(await picked(), first);
  // Alt with an arrow moves the row of the button that has the focus.
  await page.focus('[data-testid=earlier-2]');
  await page.keyboard.press('Alt+ArrowUp');
  await page.waitForFunction((n) => document.activeElement?.dataset.stroke === n, first);
  await checked(page);
  assert.deepEqual(await strokeNames(page), [first, second]);
}

/** The section says where it lies, in the page's unit. */
export async function sectionplace({ page }) {
  await open(page, [`${folder(page)}/../channel.step`]);
  await page.click('[data-testid=section]');
  await page.waitForSelector('[data-testid=section-place]');
  const value = () => page.getAttribute('[data-testid=section-slider]', 'aria-valuetext'),
    shown = (text) => page.waitForSelector(`[data-testid=section-place]:text-is("${text}")`);
  const length = await state(page, 'views.folded.under.lengthAlong([1, 0, 0])');
  assert.equal(await text(page, 'section-place'), `${Math.round(5 * length) / 10} mm`);
  assert.equal(await value(), `${Math.round(5 * length) / 10} mm from its lower end along x`);
  await page.focus('[data-testid=section-slider]');
  for (let i = 0; i < 20; ++i) await page.keyboard.press('ArrowLeft');
  await shown(`${Math.round(4 * length) / 10} mm`);
  await page.screenshot({ path: `${folder(page)}/section.png` });
  await page.click('[data-testid=units-inch]');
  await shown(`${Math.round((40 * length) / 25.4) / 100} in`);
  await page.click('[data-testid=section-view]');
  await page.waitForSelector('[data-testid=section-slider][aria-valuetext$=" in from its far end"]');
}

/** Texts of measures lie above all of their lines, also those of measures made later on the same line. */
export async function textsabove({ page }) {
  await open(page, [`${folder(page)}/../channel.step`]);
  const { sides, line } = await state(
    page,
    `(() => { const f = s.shape, own = [...f.edge_length.keys()].filter((n) => Math.abs(f.edge_length[n] - 160) < 1e-4);
    const at = (v, i) => [0, 1].map((k) => v[i + k] * 0.7 + v[i + 2 + k] * 0.3);
    return { line: at(f.bend_lines, 0), sides: own.map((n) => at(f.edges, 4 * f.edge_number.indexOf(n))) }; })()`,
  );
  const off = (side) => Math.hypot(side[0] - line[0], side[1] - line[1]),
    [near, far] = off(sides[0]) < off(sides[1]) ? sides : [sides[1], sides[0]];
  await page.evaluate(() => {
    const { prototype } = CanvasRenderingContext2D;
    for (const name of ['clearRect', 'lineTo', 'fillText']) {
      const real = prototype[name];
      prototype[name] = function (...more) {
        if (this.canvas.className === 'overlay') {
          if (name === 'clearRect') this.canvas.done = [];
          else (this.canvas.done ??= []).push(name);
        }
        return real.apply(this, more);
      };
    }
  });
  await page.keyboard.press('d');
  for (const at of [near, far, line, far]) {
    const p = await state(page, `views.flat.project(${JSON.stringify(at)})`);
    await page.mouse.click(p.x, p.y);
  }
  await page.keyboard.press('d');
  await page.waitForFunction(() => document.querySelectorAll('[data-testid=measures] li').length === 2);
  await page.waitForTimeout(200);
  const done = await page.$$eval('.flat canvas.overlay', (all) => all.flatMap((c) => c.done ?? []));
  assert.equal(done.filter((name) => name === 'fillText').length, 2, done.join());
  assert.ok(done.lastIndexOf('lineTo') < done.indexOf('fillText'), done.join());
  await page.screenshot({ path: `${folder(page)}/measures.png` });
}
