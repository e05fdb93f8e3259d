import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { inTheme, violations } from '../axe.mjs';
import { download, enter, example, folder, open, rested, state } from '../driving.mjs';

// Lists and choices: how a DXF is written, the bodies of an assembly, where K comes from.

/** Nothing is out of reach of a screen reader or too pale, in either theme. */
async function accessible(page) {
  for (const theme of ['dark', 'light']) {
    await inTheme(page, theme);
    assert.deepEqual(await violations(page), [], theme);
  }
}

/** What is chosen for the DXF stays chosen on this machine, and what contradicts something else is not offered. */
export async function dxfpanel({ page }) {
  await example(page, 'bracket.step');
  await page.click('[data-testid=download-menu]');
  const gone = (id) => page.waitForSelector(`[data-testid=dxf-${id}]`, { state: 'detached' });
  await gone('tick'); // the length of the ends goes with ends
  await page.selectOption('[data-testid=dxf-units]', 'inch');
  await page.selectOption('[data-testid=dxf-splines]', 'keep');
  await gone('arcs'); // splines that are kept have none
  await page.selectOption('[data-testid=dxf-release]', '12');
  await page.waitForSelector('[data-testid=dxf-arcs]'); // release 12 has no splines
  assert.equal(await page.inputValue('[data-testid=dxf-splines]'), 'arcs');
  await page.evaluate(() => {
    // Faster than the page is drawn: both hold.
    for (const [id, value] of [
      ['profile', 'onshape'],
      ['marks', 'ticks'],
    ]) {
      const select = document.querySelector(`[data-testid=dxf-${id}]`);
      select.value = value;
      select.dispatchEvent(new Event('change', { bubbles: true }));
    }
  });
  await enter(page, 'dxf-tick', '3');
  await enter(page, 'dxf-arcs', '0.02');
  for (const id of ['tangent', 'text', 'turned']) await page.check(`[data-testid=dxf-${id}]`);
  await page.screenshot({ path: `${folder(page)}/panel.png` });
  await page.reload();
  await page.waitForSelector('[data-testid=document-name]:has-text("bracket.step")');
  await page.waitForTimeout(500);
  await page.click('[data-testid=download-menu]');
  assert.equal(await page.inputValue('[data-testid=dxf-profile]'), 'onshape', 'it is kept');
  assert.equal(await page.inputValue('[data-testid=dxf-tick]'), '3');
  await page.click('[data-testid=download-menu]');
  return download(page, 'dxf');
}

const blank = (page) => page.textContent('[data-testid=blank-size]');

/** A list of sixty bodies: pictures, sizes, what became of each; chosen by mouse and keys; all of them at once. */
export async function bodies({ page }) {
  await open(page, [`${folder(page)}/../sixty.step`]);
  await page.waitForFunction(() => Object.keys(window.planish.store.state.bodies).length === 60);
  const row = (n) => page.locator(`[data-testid=body-${n}]`);
  await page.waitForSelector('[data-testid=body-60] .said:has-text("sheet")');
  assert.equal(await page.locator('[data-testid=bodies] [role=option]').count(), 60);
  assert.match(await row(4).textContent(), /block 4\s*no flat pattern: not a sheet\s*× 1/);
  assert.equal(await row(4).locator('path').count(), 0, 'what has no pattern is shown as a solid');
  assert.match(await row(4).locator('image').getAttribute('href'), /^data:image/);
  assert.match(await row(5).locator('path.sheet').getAttribute('d'), /^M[\d. ]+L/);
  assert.match(await row(5).locator('path.up').getAttribute('d'), /^M/);
  assert.equal(await row(1).getAttribute('aria-selected'), 'true');
  // By the keys: they move along the list, Enter shows.
  await row(1).focus();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  assert.equal(await state(page, 's.input.options.body'), undefined, 'moving along shows nothing yet');
  await page.keyboard.press('Enter');
  await rested(page);
  assert.equal(await state(page, 's.input.options.body'), 3);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.testid), 'body-3', 'the keys go on from here');
  await page.keyboard.press('End');
  assert.equal(await page.evaluate(() => document.activeElement.dataset.testid), 'body-60');
  // The size in the list is that of the summary, also with another K.
  await row(12).click();
  await rested(page);
  assert.ok((await row(12).textContent()).includes(`${await blank(page)} mm`));
  const before = await row(13).textContent();
  await page.selectOption('[data-testid=k-rule]', 'din6935');
  await page.waitForFunction((text) => document.querySelector('[data-testid=body-13]').textContent !== text, before);
  await page.screenshot({ path: `${folder(page)}/bodies.png` });
  await accessible(page);
  await page.check('[data-testid=sheets-only]');
  await page.waitForFunction(() => document.querySelectorAll('[data-testid=bodies] [role=option]').length === 51);
  assert.equal(await row(4).count(), 0);
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('[data-testid=download-all]')]);
  await file.saveAs(`${folder(page)}/${file.suggestedFilename()}`);
  await page.waitForSelector('[data-testid=message]:has-text("51 DXF files and a summary")');
  // What is under way can be given up.
  await page.click('[data-testid=download-all]');
  await page.click('[data-testid=archive-cancel]');
  await page.waitForSelector('[data-testid=message]:has-text("cancelled")');
  await page.waitForSelector('[data-testid=download-all]');
  await row(1).click();
  await rested(page);
}

const text = (page, id) => page.textContent(`[data-testid="${id}"]`);
const shop = new URL('../../../examples/shop/example.json', import.meta.url).pathname;

/** K comes from a shop's profile, which stays on this machine; a default is said to be one until it is confirmed. */
export async function allowance({ page }) {
  await example(page, 'bracket.step');
  const before = await blank(page);
  assert.match(await text(page, 'unconfirmed'), /K 0\.44 is only a default/);
  await page.click('[data-testid=tab-bends]');
  await page.waitForSelector('td.default [data-testid=bend-k-B1]');
  await page.click('[data-testid=confirm-k]');
  await rested(page);
  await page.waitForSelector('[data-testid=unconfirmed]', { state: 'detached' });
  assert.equal(await page.locator('td.default').count(), 0);
  assert.deepEqual([await state(page, 's.input.options.k'), await blank(page)], [0.44, before]);
  await page.click('[data-testid=undo]');
  await page.waitForSelector('[data-testid=unconfirmed]');
  await rested(page);
  // A density alone gives the mass.
  assert.equal(await text(page, 'mass'), '–');
  await page.click('[data-testid=tab-input]');
  await page.click('[data-testid=density-aluminium]');
  await rested(page);
  assert.match(await text(page, 'mass'), /^\d+(\.\d+)? g$/);
  const [mass, volume] = await state(page, '[s.shape.report.sheet.mass, s.shape.report.sheet.volume]');
  assert.ok(Math.abs(mass / (volume * 2.7e-6) - 1) < 1e-9, 'what the tile says: of the solid');
  assert.match(await page.getAttribute('.summary > div:has([data-testid=mass])', 'title'), /^Volume of the solid/);
  await page.click('[data-testid=density-aluminium]');
  await rested(page);
  // What is no shop profile is refused with the program's sentence, and not kept.
  await page.selectOption('[data-testid=k-rule]', 'shop');
  const broken = `${folder(page)}/broken.json`;
  writeFileSync(broken, JSON.stringify({ ...JSON.parse(readFileSync(shop, 'utf8')), materials: [{ name: 'steel' }] }));
  await page.setInputFiles('[data-testid=shop-open]', broken);
  await page.waitForSelector('[data-testid=message].error:has-text("broken.json/materials/0/gauges is missing")');
  assert.deepEqual(await state(page, 's.workshop.files'), []);
  writeFileSync(broken, 'no JSON');
  await page.setInputFiles('[data-testid=shop-open]', broken);
  await page.waitForSelector('[data-testid=message].error:has-text("broken.json is not JSON")');
  // Of several materials one has to be chosen.
  await page.setInputFiles('[data-testid=shop-open]', shop);
  await page.waitForSelector('[data-testid=shop-material]');
  assert.equal(await state(page, 's.input.options.shop'), undefined, 'nothing is guessed');
  assert.equal(await page.locator('[data-testid=message].error').count(), 0, 'this one is understood');
  assert.notEqual(await text(page, 'status'), 'error');
  await page.selectOption('[data-testid=shop-material]', 'mild steel');
  await rested(page);
  assert.match(await text(page, 'gauges'), /2 ✓\s*2\s*0\.324\s*3\.84/);
  assert.equal(await text(page, 'part-k'), '0.324');
  assert.equal(await page.locator('[data-testid=unconfirmed]').count(), 0);
  assert.match(await state(page, 's.shape.report.sheet.k_source'), /^shop Example laser shop, mild steel 2 mm/);
  await page.check('[data-testid=every-part]');
  await page.screenshot({ path: `${folder(page)}/shop.png` });
  await accessible(page);
  const report = await download(page, 'json');
  // It is there for the next part, also after a reload.
  await page.reload();
  await page.waitForSelector('[data-testid=document-name]:has-text("bracket.step")');
  await page.waitForTimeout(500);
  await open(page, [`${folder(page)}/../pressed.step`]);
  assert.equal(await state(page, 's.input.options.material'), 'mild steel');
  assert.equal(await page.inputValue('[data-testid=shop-file]'), 'example.json');
  assert.match(await text(page, 'mass'), /g$/);
  await page.click('[data-testid=shop-forget]');
  await page.waitForSelector('[data-testid=shop-forget]', { state: 'detached' });
  assert.deepEqual(await state(page, 's.workshop.files'), []);
  return report;
}

/** A bend table, and what the bends take off: outside lengths are those of the part. */
export async function bendtable({ page }) {
  await open(page, [`${folder(page)}/../sixty.step`]);
  await page.selectOption('[data-testid=k-rule]', 'k_table');
  const table = `${folder(page)}/steel.csv`;
  writeFileSync(table, 'r/t, k\n1, 0.3\n2, 0.4\n');
  await page.setInputFiles('[data-testid=k_table-open]', table);
  await page.waitForFunction(() => window.planish.store.state.input.options.k_table?.name === 'steel.csv');
  await rested(page);
  assert.equal(await text(page, 'part-k'), '0.3');
  assert.equal(await text(page, 'pierces'), '1');
  await page.click('[data-testid=tab-bends]');
  // Both legs are 30, of 1 mm with R 1: what a bend of 90° takes off is 4 - (1 + 0.3) π/2.
  await page.waitForSelector('[data-testid=outside-B1]:has-text("30 + 30")');
  const deduction = 4 - (1.3 * Math.PI) / 2;
  assert.equal(await text(page, 'deduction-B1'), String(Math.round(100 * deduction) / 100));
  const [length] = (await blank(page)).split(' ');
  assert.ok(Math.abs(Number(length) - (60 - deduction)) < 0.006);
  assert.match(await page.getAttribute('[data-testid=deduction-head]', 'title'), /mould line.*above 90° too.*180°/);
  assert.equal(await page.getAttribute('[data-testid=deduction-B1]', 'title'), null);
  await page.screenshot({ path: `${folder(page)}/bends.png` });
  await accessible(page);
  // A row that K leaves is refused; the table that was there stays.
  await page.click('[data-testid=tab-input]');
  writeFileSync(table, 'r/t, k\n1, 3\n');
  await page.setInputFiles('[data-testid=k_table-open]', table);
  await page.waitForSelector('[data-testid=message].error');
  assert.equal(await state(page, 's.workshop.files[0].text.includes("0.3")'), true);
  assert.equal(await text(page, 'part-k'), '0.3');
}

/** Of bends beyond 90° the table says what the deduction is measured to, and of bends without outside lengths why. */
export async function deductions({ page }) {
  const title = (id) => page.getAttribute(`[data-testid=${id}]`, 'title');
  await open(page, [`${folder(page)}/../curled.step`]);
  await page.click('[data-testid=tab-bends]');
  const bends = await state(page, 's.shape.report.flat.bends.map((b) => [b.id, b.angle])'),
    id = (angle) => bends.find((b) => Math.abs(b[1] - angle) < 1e-3)[0];
  assert.match(await title(`deduction-${id(120)}`), /^Measured to the mould line/);
  assert.match(await title(`deduction-${id(200)}`), /^Measured to the plane/);
  assert.equal(await text(page, `outside-${id(200)}`).then((t) => t.trim()), '–');
  assert.match(await title(`outside-${id(200)}`), /no flange on one of its sides/);
  await page.screenshot({ path: `${folder(page)}/deductions.png` });
}
