import assert from 'node:assert/strict';
import { example, folder, open, rested, state } from '../driving.mjs';

/** Times between the frames that follow a move of the pointer in a page, ms: median and 95th percentile. */
async function frames(page, action) {
  await page.evaluate(() => {
    const times = (window.frameTimes = []);
    let moved = false;
    window.frameMoved = () => (moved = true);
    addEventListener('pointermove', window.frameMoved, true);
    const step = (now) => {
      if (moved) times.push(now);
      moved = false;
      window.frameStep = requestAnimationFrame(step);
    };
    window.frameStep = requestAnimationFrame(step);
  });
  await action();
  const between = await page.evaluate(() => {
    cancelAnimationFrame(window.frameStep);
    removeEventListener('pointermove', window.frameMoved, true);
    return window.frameTimes.slice(1).map((t, i) => t - window.frameTimes[i]);
  });
  between.sort((a, b) => a - b);
  return between.length ? [0.5, 0.95].map((share) => between[Math.floor(share * (between.length - 1))]) : [NaN, NaN];
}

const said = (name, [median, most]) => console.log(`   ${name}: ${median.toFixed(1)} / ${most.toFixed(1)} ms a frame`);

/** Moves the pointer through places between two, one every 8 ms, as a mouse does. */
async function sweep(page, from, to, steps) {
  const moves = [];
  for (let i = 0; i <= steps; ++i) {
    moves.push(page.mouse.move(from.x + ((to.x - from.x) * i) / steps, from.y + ((to.y - from.y) * i) / steps));
    await new Promise((resolve) => setTimeout(resolve, 8));
  }
  await Promise.all(moves);
}

/** A channel with 1,000 holes: orbit, slider and hover; what is hovered lights up, and no geometry is made for it. */
export async function thousand({ page }) {
  await open(page, [`${folder(page)}/../thousand.step`]);
  assert.equal(await state(page, 's.shape.report.flat.openings'), 1000);
  await rested(page);
  const box = async (testid) => {
    const b = await page.locator(`[data-testid=${testid}]`).boundingBox();
    return (x, y) => ({ x: b.x + x * b.width, y: b.y + y * b.height });
  };
  const folded = await box('folded-canvas'),
    flat = await box('flat-canvas');
  said(
    'orbit',
    await frames(page, async () => {
      await page.mouse.move(folded(0.3, 0.9).x, folded(0.3, 0.9).y);
      await page.mouse.down();
      await sweep(page, folded(0.3, 0.9), folded(0.7, 0.7), 120);
      await page.mouse.up();
    }),
  );
  const slider = await box('fold-slider');
  said(
    'slider',
    await frames(page, async () => {
      const [from, to] = [slider(0.97, 0.5), slider(0.3, 0.5)];
      await page.mouse.move(from.x, from.y);
      await page.mouse.down();
      await sweep(page, from, to, 60);
      await sweep(page, to, from, 60);
      await page.mouse.up();
    }),
  );
  await page.click('[data-testid=view-iso]');
  const resting = () => state(page, 'views.folded.sheet.version');
  await page.waitForTimeout(400); // until it is drawn with all its corners again
  const version = await resting();
  said('hover, folded', await frames(page, () => sweep(page, folded(0.2, 0.45), folded(0.8, 0.55), 120)));
  said('hover, flat', await frames(page, () => sweep(page, flat(0.1, 0.4), flat(0.9, 0.6), 120)));
  assert.equal(await resting(), version, 'no geometry was made for what is hovered');
}

/** From the address to the first picture: of an empty page, and of one with a part, which shows no start screen. */
export async function first({ page }) {
  await page.addInitScript(() => {
    const look = () => {
      window.sawStart ||= document.querySelector('[data-testid=start]') !== null;
      const drawn = window.planish?.store.state.shape && performance.now();
      if (drawn) requestAnimationFrame(() => (window.firstShape = performance.now()));
      else requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
  const paints = [],
    shapes = [];
  for (let i = 0; i < 5; ++i) {
    await page.reload();
    await page.waitForSelector('[data-testid=start]');
    paints.push(await page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0].startTime));
  }
  await example(page, 'bracket.step');
  for (let i = 0; i < 5; ++i) {
    await page.reload();
    await page.waitForFunction(() => window.firstShape);
    assert.equal(await page.evaluate(() => window.sawStart), false);
    shapes.push(await page.evaluate(() => window.firstShape));
  }
  const median = (times) => times.sort((a, b) => a - b)[2].toFixed(0);
  console.log(`   first picture: empty page ${median(paints)} ms, with a part ${median(shapes)} ms`);
}
