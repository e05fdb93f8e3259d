import assert from 'node:assert/strict';
import { download, example, rested, slide, state, timings } from '../driving.mjs';

export async function transition({ page }) {
  await example(page, 'transition/a_square_to_round.json');
  await page.evaluate(() => {
    window.planishTimings.length = 0;
  });
  const before = await page.textContent('[data-testid=blank-size]');
  await slide(page, 'to-z', 0.95);
  await rested(page);
  assert.notEqual(await page.textContent('[data-testid=blank-size]'), before);
  await slide(page, 'to-tiltX', 0.55);
  await rested(page);
  await slide(page, 'to-twist', 0.6);
  await rested(page);
  timings('transition', await page.evaluate(() => window.planishTimings));
  assert.equal(await state(page, 's.past.length'), 3);
  return download(page, 'dxf');
}

/** Another profile below frees the seam that it has no place for. */
export async function profiles({ page }) {
  await example(page, 'transition/a_square_to_round.json');
  for (const kind of ['circle', 'ellipse', 'spline', 'obround', 'rounded_rectangle', 'polygon']) {
    await page.selectOption('[data-testid=from-kind]', kind);
    await rested(page);
    assert.equal(await state(page, 's.problem'), null, kind);
  }
}
