import assert from 'node:assert/strict';
import { looker } from '../axe.mjs';
import { example, opened, rested, state } from '../driving.mjs';
import { walls } from '../walls.mjs';

/** Everyone can use the page: no state of it has a violation, in either theme. */
export async function access({ page }) {
  const { found, look } = looker(page);
  const tabs = async (what) => {
    for (const tab of ['input', 'bends', 'order', 'findings', 'certificate']) {
      await page.click(`[data-testid=tab-${tab}]`);
      await page.waitForTimeout(50);
      await look(`${what}, ${tab}`);
    }
  };
  await look('start');
  await page.keyboard.press('?');
  await look('help');
  await page.keyboard.press('Escape');
  await page.click('[data-testid=examples-menu]');
  await look('examples');
  await page.keyboard.press('Escape');
  for (const name of ['bracket.step', 'connect/a_folded.json', 'transition/a_square_to_round.json', 'slit/arch.json']) {
    await example(page, name);
    await tabs(name);
  }
  await page.click('[data-testid=download-menu]');
  await look('downloads');
  await page.keyboard.press('Escape');
  await example(page, 'connect/a_folded.json');
  await page.click('[data-testid=plate-right]');
  await rested(page);
  await look('a plate');
  // Refused, with what it proposes; and with findings of each kind, one of them open.
  await page.setInputFiles('[data-testid=file-input]', {
    name: 'walls.json',
    mimeType: 'application/json',
    buffer: Buffer.from(walls),
  });
  await opened(page, 'walls.json');
  await tabs('refused');
  await page.click('[data-testid=remedy-write_overlapping-true]');
  await rested(page);
  await page.click('[data-testid=tab-findings]');
  await page.click('[data-testid=finding-1] button');
  await look('findings');
  // Wherever one is, the keys lead on: the dialog takes the focus and gives it back.
  await page.focus('[data-testid=help]');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.activeElement?.closest('dialog')); // the dialog has the focus
  await page.keyboard.press('Escape');
  assert.equal(await page.evaluate(() => document.activeElement?.dataset.testid), 'help', 'and gives it back');
  assert.equal(await state(page, 's.help'), false);
  await page.focus('[data-testid=tab-findings]');
  await page.keyboard.press('ArrowRight');
  assert.equal(await state(page, 's.tab'), 'certificate');
  assert.match(
    await page.getAttribute('.flat .canvas', 'aria-label'),
    /^Flat pattern of walls.json, [\d.]+ by [\d.]+ mm/,
  );
  assert.match(await page.getAttribute('.folded .canvas', 'aria-label'), /^Folded part walls.json: 3 flanges, 2 bends/);
  assert.ok(!found.length, [...new Set(found)].join('\n'));
}
