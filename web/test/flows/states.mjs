import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { looker } from '../axe.mjs';
import { channel } from '../channel.mjs';
import { collide, plan } from '../ordering.mjs';
import { coarse, example, folder, open, opened, rested, state } from '../driving.mjs';
import { perforated } from '../perforated.mjs';
import { serveDist } from '../serve-dist.mjs';

// What the page looks like in the midst of work has no violation either, in either theme.

const away = (page) => page.mouse.move(3, 3);

/** Clicks places of a view. */
async function click(page, view, ...places) {
  for (const at of places) {
    const p = await state(page, `views.${view}.project(${JSON.stringify(at)})`);
    await page.mouse.move(p.x, p.y);
    await page.mouse.click(p.x, p.y);
  }
}

/** Opens all that can be opened in the panel. */
const unfoldPanels = (page) =>
  page.evaluate(() => document.querySelectorAll('aside details').forEach((d) => (d.open = true)));

/** Both views: measuring, section, glass, help above them, one above the other. */
export async function viewstates({ page }) {
  const { found, look } = looker(page);
  await open(page, [`${folder(page)}/../channel.step`]);
  await page.keyboard.press('d');
  await look('measuring');
  const [low, high] = await state(
    page,
    `(() => { const p = [...s.shape.points], of = (least, k) => least(...p.filter((_, i) => i % 2 === k));
      return [Math.min, Math.max].map((least) => [of(least, 0), of(least, 1)]); })()`,
  );
  await click(page, 'flat', low);
  assert.ok(await state(page, 's.measure.first'), 'one thing is picked');
  await look('measuring, one picked');
  await click(page, 'flat', high);
  await click(page, 'folded', [120, 60, 2], [120, 98, 25]);
  await page.waitForFunction(() => document.querySelectorAll('[data-testid=measures] li').length === 2);
  await look('measured');
  await page.keyboard.press('Escape');
  await page.keyboard.press('x');
  await page.waitForSelector('[data-testid=section-bar]');
  await look('section');
  await page.keyboard.press('g');
  await look('glass');
  await page.keyboard.press('?');
  await page.waitForFunction(() => document.querySelector('dialog').open);
  await look('help above a part');
  await page.keyboard.press('Escape');
  await open(page, [`${folder(page)}/../wide.step`]);
  await page.waitForFunction(() => document.querySelector('main').classList.contains('stacked'));
  await look('stacked');
  assert.ok(!found.length, [...new Set(found)].join('\n'));
}

/** Lists and choices: bodies, a shop, the DXF, findings, a refusal, files opened lately. */
export async function liststates({ page }) {
  const { found, look } = looker(page);
  await page.route('**/api/documents/*/open', async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 3500));
    await route.continue().catch(() => undefined);
  });
  await page.setInputFiles('[data-testid=file-input]', [`${folder(page)}/../sixty.step`]);
  await page.waitForSelector('[data-testid=progress]');
  await look('opening');
  await opened(page, 'sixty.step');
  await page.unroute('**/api/documents/*/open');
  await look('bodies that are looked at');
  await page.waitForFunction(() => Object.keys(window.planish.store.state.bodies).length === 60);
  await page.click('[data-testid=download-all]');
  await page.waitForSelector('[data-testid=archive-cancel]');
  await look('an archive that is made');
  await page.waitForSelector('[data-testid=download-all]');
  await page.check('[data-testid=sheets-only]');
  await look('bodies');
  await page.selectOption('[data-testid=k-rule]', 'shop');
  await look('a shop that is to be chosen');
  await page.setInputFiles(
    '[data-testid=shop-open]',
    new URL('../../../examples/shop/example.json', import.meta.url).pathname,
  );
  await page.selectOption('[data-testid=shop-material]', 'mild steel');
  await rested(page);
  await look('gauges of a shop');
  await page.click('[data-testid=download-menu]');
  await page.selectOption('[data-testid=dxf-marks]', 'ticks');
  await look('DXF');
  await page.keyboard.press('Escape');
  // Holes that are too near to each other and to a bend: rules with many places.
  await open(page, [perforated(`${folder(page)}/perforated.json`, { holes: 60, from: 35, high: 10 })]);
  await page.click('[data-testid=tab-findings]');
  const most = await state(
    page,
    `(() => { const n = s.result.report.checks.map((f) => f.count ?? 0);
      return n.indexOf(Math.max(...n)); })()`,
  );
  await page.click(`[data-testid=finding-${most + 1}] button`);
  await page.waitForSelector('[data-testid=places]');
  await look('places of a finding');
  for (const severity of ['info', 'warning', 'error']) {
    if (!(await page.locator(`[data-testid=show-${severity}]`).count())) continue;
    await page.click(`[data-testid=show-${severity}]`);
    await look(`findings without ${severity}`);
  }
  // A file that is no plate, and a part that has no pattern.
  const broken = `${folder(page)}/broken.json`;
  writeFileSync(broken, '{"format": "planish/plates", "version": 1, "thickness": 2, "plates": []}');
  await page.setInputFiles('[data-testid=file-input]', broken);
  await page.waitForFunction(() => window.planish.store.state.problem);
  await look('a file that cannot be read');
  await open(page, [`${folder(page)}/../sixty.step`]);
  await page.click('[data-testid=body-4]');
  await page.waitForFunction(() => window.planish.store.state.problem && !window.planish.store.state.computing);
  await look('a body that is no sheet');
  await page.waitForTimeout(500);
  await page.evaluate(() => sessionStorage.clear());
  await serveDist(page, process.argv[2]);
  await page.reload();
  await page.waitForSelector('[data-testid=recents] .tile');
  await look('files opened lately');
  await page.unrouteAll({ behavior: 'ignoreErrors' });
  assert.ok(!found.length, [...new Set(found)].join('\n'));
}

/** The machine, playing and stopped where something collides. */
export async function machinestates({ page }) {
  const { found, look } = looker(page);
  await open(page, [channel(page)]);
  await plan(page);
  await look('the cheapest order');
  await collide(page);
  await away(page);
  await look('a collision');
  await page.click('[data-testid=stroke-back]');
  await page.click('[data-testid=stroke-play]');
  await look('strokes that are played');
  await page.waitForFunction(() => window.planish.store.state.order.time > 1.2, null, { timeout: 20000 });
  await page.click('[data-testid=stroke-play]');
  await look('strokes that are stopped');
  await example(page, 'bracket.step');
  await plan(page);
  assert.ok(await page.locator('.strokes .change').count(), 'the part is turned between its strokes');
  await page.click('[data-testid=stroke-2]');
  await away(page);
  await look('what changes between strokes');
  await page.fill('[data-testid=springback]', '2');
  await page.keyboard.press('Enter');
  await page.waitForSelector('[data-testid=order-old]');
  await look('an order of before');
  assert.ok(!found.length, [...new Set(found)].join('\n'));
}

/** Each panel with all that it can unfold. */
export async function panelstates({ page }) {
  const { found, look } = looker(page);
  await example(page, 'connect/a_folded.json');
  await page.click('[data-testid=plate-base]');
  await unfoldPanels(page);
  await look('a plate with a hole');
  for (const [bend, surface] of [
    ['B1', 'general'],
    ['B2', 'cone'],
  ]) {
    await page.click(`[data-testid=bend-head-${bend}]`);
    await page.selectOption('[data-testid=bend-surface]', surface);
    await page.waitForFunction(() => !window.planish.store.state.computing);
    await look(`bend ${bend}, ${surface}`);
  }
  await example(page, 'connect/a_folded.json');
  await page.click('[data-testid=tab-bends]');
  for (const bend of ['B1', 'B4']) {
    await page.click(`[data-testid=bend-${bend}]`);
    await away(page);
    await look(`bend ${bend} is picked`);
  }
  await page.click('[data-testid=tab-input]');
  // Plates that no longer hold together: what was known before is still there, and says that it is old.
  await example(page, 'connect/a_folded.json');
  await page.click('[data-testid=bend-head-B1]');
  await page.click('.block.open [data-testid^=bend-remove]');
  await page.waitForFunction(() => window.planish.store.state.stale && !window.planish.store.state.computing);
  await look('an input that is refused');
  await page.click('[data-testid=tab-bends]');
  await look('bends of before');
  await page.click('[data-testid=tab-input]');
  await example(page, 'transition/a_square_to_round.json');
  for (const kind of ['polygon', 'spline', 'obround', 'rounded_rectangle']) {
    await page.selectOption('[data-testid=from-kind]', kind);
    await rested(page);
    await unfoldPanels(page);
    await look(`transition from ${kind}`);
  }
  for (const lines of ['count', 'angle']) {
    if (!(await page.locator(`[data-testid=press-lines] option[value=${lines}]`).count())) continue;
    await page.selectOption('[data-testid=press-lines]', lines);
    await rested(page);
    await look(`press lines by ${lines}`);
  }
  await open(page, [coarse(page, 'chair.json')]);
  await page.click('[data-testid=curve-seat-1]');
  await look('a control point');
  await page.click('[data-testid=second-add]');
  await rested(page);
  await unfoldPanels(page);
  await look('a second panel');
  await open(page, [coarse(page, 'plume.json')]);
  await page.click('[data-testid=strip-head-1]');
  for (const key of ['direction', 'across']) {
    await page.check(`[data-testid=end-${key}]`);
    await rested(page);
  }
  await look('a strip of its own width');
  await page.click('[data-testid=tab-bends]');
  await look('strips in the table');
  assert.ok(!found.length, [...new Set(found)].join('\n'));
}
