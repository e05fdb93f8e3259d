import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { inTheme, violations } from '../axe.mjs';
import { serveDist } from '../serve-dist.mjs';
import { folder, open, rested, state } from '../driving.mjs';

// The list of bodies: what it says of each before it is opened, which one it shows, and pictures of solids.

const known = (page, count) =>
  page.waitForFunction((n) => Object.keys(window.planish.store.state.bodies).length === n, count);
const said = (page, n) => page.textContent(`[data-testid=body-${n}] .said`);

/** A body has its warnings before it is opened, and the archive says the same. */
export async function status({ page }) {
  await open(page, [`${folder(page)}/../short.step`]);
  assert.equal(await state(page, 's.input.options.body'), 2, 'the block comes first');
  await known(page, 3);
  await page.waitForSelector('[data-testid=body-3] .said:has-text("sheet")');
  const all = () => Promise.all([1, 2, 3].map((n) => said(page, n))),
    before = await all();
  assert.deepEqual(before, ['no flat pattern: not a sheet', 'sheet', 'sheet, with warnings']);
  await page.click('[data-testid=body-3]');
  await rested(page);
  assert.equal(await state(page, 's.shape.report.checks.some((c) => c.code === "flange_height")'), true);
  assert.deepEqual(await all(), before);
  await Promise.all([page.waitForEvent('download'), page.click('[data-testid=download-all]')]);
  await page.waitForSelector('[data-testid=download-all]');
  assert.deepEqual(await all(), before);
  assert.equal(await page.locator('[data-testid=body-1] image').count(), 1, 'the picture stays');
}

/** What was set for one body only waits for it, in the list and in the archive too; undo goes back to that body. */
export async function waiting({ page }) {
  const size = (n) => state(page, `s.bodies[${n}].size`);
  const body = async (n) => {
    await page.click('[data-testid=tab-input]');
    await page.click(`[data-testid=body-${n}]`);
    await rested(page);
  };
  const k = async () => {
    await page.click('[data-testid=tab-bends]');
    return page.inputValue('[data-testid=bend-k-B1]');
  };
  await open(page, [`${folder(page)}/../short.step`]);
  await known(page, 3);
  await page.click('[data-testid=tab-bends]');
  const drawn = await size(2);
  await page.fill('[data-testid=bend-k-B1]', '0.1');
  await page.keyboard.press('Enter');
  await rested(page);
  const bent = await size(2);
  assert.ok(Math.max(...drawn) - Math.max(...bent) > 0.1, `${drawn} became ${bent}`);
  await body(3);
  assert.equal(await k(), '0.44');
  await page.click('[data-testid=tab-input]');
  await Promise.all([page.waitForEvent('download'), page.click('[data-testid=download-all]')]);
  await page.waitForSelector('[data-testid=download-all]');
  assert.deepEqual(await size(2), bent, 'the archive holds it as it was set');
  await body(2);
  assert.equal(await k(), '0.1');
  assert.deepEqual(await state(page, 's.shape.report.flat.size'), bent);
  for (const [shown, text] of [
    [3, '0.44'],
    [2, '0.1'],
    [2, '0.44'],
  ]) {
    await page.keyboard.press('Control+z');
    await rested(page);
    assert.equal(await state(page, 's.input.options.body'), shown);
    assert.equal(await k(), text);
  }
}

/** Whether a row is wholly seen in its list. */
const inList = (page, n) =>
  page.evaluate((number) => {
    const list = document.querySelector('[data-testid=bodies]').getBoundingClientRect(),
      row = document.querySelector(`[data-testid=body-${number}]`).getBoundingClientRect();
    return row.top >= list.top && row.bottom <= list.bottom;
  }, n);

/** The list moves to the body that is shown, and the panel stays where it is. */
export async function listed({ page }) {
  await open(page, [`${folder(page)}/../sixty.step`]);
  await known(page, 60);
  await page.waitForSelector('[data-testid=body-60] .said:has-text("sheet")');
  const choose = async (body) => {
    await page.evaluate((number) => {
      const { store } = window.planish,
        { input } = store.state;
      store.dispatch({ type: 'edit', input: { ...input, options: { ...input.options, body: number } } });
    }, body);
    await rested(page);
  };
  await choose(40);
  assert.ok(await inList(page, 40), 'chosen elsewhere');
  assert.equal(await page.$eval('[data-testid=panel]', (p) => p.scrollTop), 0);
  await page.screenshot({ path: `${folder(page)}/listed.png` });
  await page.click('[data-testid=tab-bends]');
  await page.click('[data-testid=tab-input]');
  await page.waitForTimeout(100);
  assert.ok(await inList(page, 40), 'after another tab');
  await page.click('[data-testid=undo]');
  await rested(page);
  assert.ok(await inList(page, 1), 'by undo');
  // One may look elsewhere meanwhile, and what is seen stays where it is when it is chosen.
  await page.$eval('[data-testid=bodies]', (list) => (list.scrollTop = 900));
  await page.waitForTimeout(100);
  await page.evaluate(() => window.planish.store.dispatch({ type: 'units', units: 'inch' }));
  await page.waitForTimeout(100);
  assert.ok(!(await inList(page, 1)));
  const at = () => page.$eval('[data-testid=bodies]', (list) => list.scrollTop),
    before = await at(),
    seen = await page.evaluate(() => {
      const middle = document.querySelector('[data-testid=bodies]').getBoundingClientRect();
      return document.elementFromPoint(middle.x + 20, middle.y + middle.height / 2).closest('[role=option]').dataset
        .testid;
    });
  await page.click(`[data-testid=${seen}]`);
  await rested(page);
  assert.equal(await at(), before);
}

const colours = (page, selector) =>
  page.$eval(selector, async (image) => {
    const found = new Image();
    found.src = image.getAttribute('href');
    await found.decode();
    const canvas = new OffscreenCanvas(found.width, found.height),
      c = canvas.getContext('2d');
    c.drawImage(found, 0, 0);
    const { data } = c.getImageData(0, 0, found.width, found.height);
    let [solid, dark, bright] = [0, 255, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] < 200) continue;
      ++solid;
      dark = Math.min(dark, data[i]);
      bright = Math.max(bright, data[i]);
    }
    return { share: (4 * solid) / data.length, dark, bright, size: found.src.length };
  });

/** What has no pattern is shown as a solid, in the list and among the files opened lately. */
export async function solids({ page }) {
  await open(page, [`${folder(page)}/../short.step`]);
  await known(page, 3);
  await page.waitForSelector('[data-testid=body-1] image');
  const block = await colours(page, '[data-testid=body-1] image');
  assert.ok(block.share > 0.5 && block.share < 0.95, `a box seen from a corner: ${block.share}`);
  assert.ok(block.bright - block.dark > 60, 'its sides differ');
  assert.ok(block.size < 6000, String(block.size));
  assert.equal(await page.locator('[data-testid=body-2] image').count(), 0, 'a sheet is shown as its pattern');
  for (const theme of ['dark', 'light']) {
    await inTheme(page, theme);
    assert.deepEqual(await violations(page), [], theme);
    await page.screenshot({ path: `${folder(page)}/solids-${theme}.png` });
  }
  await open(page, [`${folder(page)}/../stepped.step`]);
  assert.equal(await state(page, 's.shape.report.status'), 'refused');
  await page.waitForFunction(() => window.planish.store.state.recents[0]?.picture?.image);
  await page.evaluate(() => sessionStorage.clear());
  await serveDist(page, process.argv[2]);
  await page.reload();
  await page.waitForSelector('[data-testid="recent-stepped.step"] image');
  await page.screenshot({ path: `${folder(page)}/recent.png` });
}

/** Names are cut in the middle, since those of one maker differ at their ends, and titles have them whole. */
export async function longnames({ page }) {
  const path = `${folder(page)}/named.step`,
    common = 'Anderson PP15-30-45 one of each, in a housing of two parts';
  let text = readFileSync(`${folder(page)}/../short.step`, 'utf8');
  for (const [i, name] of ['block', 'angle', 'short'].entries())
    text = text.replaceAll(`PRODUCT('${name}','${name}'`, `PRODUCT('${name}','${common} - Blade ${i + 1}'`);
  writeFileSync(path, text);
  await open(page, [path]);
  await known(page, 3);
  await page.waitForSelector('[data-testid=body-3] .said:has-text("sheet")');
  const names = await page.$$eval('[data-testid=bodies] [role=option] b', (all) => all.map((b) => b.textContent));
  assert.deepEqual(
    names,
    [1, 2, 3].map((n) => `${n} · ${common} - Blade ${n}`),
    'whole for readers of the screen',
  );
  const shown = await page.$$eval('[data-testid=bodies] [role=option] .what', (all) =>
    all.map((what) => {
      const tail = what.querySelector('.tail'),
        head = what.querySelector('.head'),
        [room, end] = [what, tail].map((e) => e.getBoundingClientRect());
      return [end.right <= room.right + 0.5, tail.textContent, head.scrollWidth > head.clientWidth];
    }),
  );
  shown.forEach(([fits, end, cut], i) => assert.ok(fits && cut && end.endsWith(`Blade ${i + 1}`), `${shown}`));
  assert.match(await page.getAttribute('[data-testid=body-1]', 'title'), /^Anderson .* - Blade 1\n.*not a sheet/);
  assert.equal(await page.getAttribute('[data-testid=body-2]', 'title'), `${common} - Blade 2`);
  await page.screenshot({ path: `${folder(page)}/names.png` });
}
