import assert from 'node:assert/strict';
import { folder, opened, state } from '../driving.mjs';

/** Nothing is open: examples have pictures, and each kind of file can be begun anew. */
export async function begin({ page }) {
  const tiles = page.locator('.tile');
  await page.waitForFunction(() => document.querySelectorAll('.tile img').length > 3);
  await page.waitForFunction(() => [...document.querySelectorAll('.tile img')].every((i) => i.complete));
  assert.ok(await tiles.evaluateAll((all) => all.every((t) => t.querySelector('img').naturalWidth > 100)));
  for (const theme of ['light', 'dark']) {
    await page.screenshot({ path: `${folder(page)}/${theme}.png` });
    await page.click('[data-testid=theme]');
  }
  for (const [kind, name] of [
    ['connect', 'plates.json'],
    ['transition', 'transition.json'],
    ['slit', 'slits.json'],
  ]) {
    await page.click(`[data-testid=new-${kind}]`);
    await opened(page, name);
    assert.deepEqual(await state(page, '[s.document.kind, s.shape.report.status]'), [kind, 'ok']);
    assert.deepEqual(
      await state(page, 's.shape.report.checks.filter((c) => c.severity !== "info").map((c) => c.code)'),
      [],
    );
    await page.evaluate(() => sessionStorage.clear());
    await page.reload();
    await page.waitForSelector('[data-testid=start]');
  }
}
