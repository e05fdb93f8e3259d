import assert from 'node:assert/strict';

/** How many pixels of a view's drawing above it are not clear. */
export const drawnAbove = (page, testid) =>
  page.$eval(`[data-testid=${testid}]`, (canvas) => {
    if (canvas.hidden) return 0;
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let i = 3; i < data.length; i += 4) if (data[i] > 60) ++count;
    return count;
  });

/** Waits until so many pixels are drawn above a view; 0: none. */
export async function untilDrawn(page, testid, least) {
  for (let i = 0; i < 40; ++i) {
    const count = await drawnAbove(page, testid);
    if (least ? count >= least : count === 0) return;
    await page.waitForTimeout(50);
  }
  assert.fail(`${testid} has ${await drawnAbove(page, testid)} pixels`);
}
