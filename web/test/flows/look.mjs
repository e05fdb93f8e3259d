import assert from 'node:assert/strict';
import { serveDist } from '../serve-dist.mjs';
import { drag, example, open, folder, state } from '../driving.mjs';

const direction = (page) => state(page, 'views.folded.direction');
const near = (a, b) => Math.hypot(...a.map((v, k) => v - b[k])) < 1e-3;

/** How much of the folded view has nearly the colour of a section. */
const sectioned = (page) =>
  page.evaluate(() => {
    const { folded } = window.planish.views,
      canvas = document.createElement('canvas'),
      c = canvas.getContext('2d'),
      gl = document.querySelector('[data-testid=folded-canvas]');
    folded.renderer.render(folded.scene, folded.camera);
    [canvas.width, canvas.height] = [gl.width, gl.height];
    c.drawImage(gl, 0, 0);
    const wanted = getComputedStyle(document.documentElement)
        .getPropertyValue('--section')
        .match(/[0-9a-f]{2}/g)
        .map((v) => parseInt(v, 16)),
      { data } = c.getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4) if (Math.hypot(...wanted.map((v, k) => v - data[i + k])) < 12) ++count;
    return count;
  });

/** A section in both themes: its colour is as thick as the sheet; what is cut away is not picked. */
export async function section({ page }) {
  await open(page, [`${folder(page)}/../channel.step`]);
  await page.click('[data-testid=view-right]'); // towards −x: a U
  assert.equal(await sectioned(page), 0);
  await page.keyboard.press('x');
  await page.waitForSelector('[data-testid=section-bar]');
  for (const theme of ['light', 'dark']) {
    assert.equal(await state(page, 's.theme'), theme);
    await page.waitForTimeout(200);
    // The U is 2 thick and 100 + 2 · 40 long, less what its rounded corners save.
    const scale = await state(page, 'views.folded.scale'),
      area = 2 * (90 + 70 + 2 * (Math.PI / 2) * 4);
    const shown = (await sectioned(page)) / scale ** 2;
    assert.ok(Math.abs(shown / area - 1) < 0.25, `${theme}: ${shown} mm² of ${area}`);
    await page.click('[data-testid=theme]');
  }
  // At 0.5 the half with x above 80 is gone: neither its hole nor its flange can be picked.
  const [normal, constant] = await state(page, '[views.folded.sheet.cut.normal, views.folded.sheet.cut.constant]');
  assert.ok(near(normal, [-1, 0, 0]) && Math.abs(constant - 80) < 1e-3);
  await page.click('[data-testid=view-top]');
  await page.waitForTimeout(200);
  const pick = async (at) => {
    const p = await state(page, `views.folded.project(${JSON.stringify(at)})`);
    await page.mouse.click(p.x, p.y);
    return state(page, 's.selection.part');
  };
  assert.equal(await pick([60, 50, 2]), 'F1');
  assert.equal(await pick([130, 50, 2]), null);
  // Its slider moves it, the other side is shown, and it can lie across the direction of view.
  await page.focus('[data-testid=section-slider]');
  for (let i = 0; i < 20; ++i) await page.keyboard.press('ArrowLeft');
  await page.waitForFunction(() => Math.abs(window.planish.views.folded.sheet.cut.constant - 64) < 1e-3);
  await page.click('[data-testid=section-flip]');
  assert.equal(await pick([130, 50, 2]), 'F1');
  await page.click('[data-testid=section-view]');
  assert.ok(near(await state(page, 's.view.section.along'), await direction(page)));
  await page.screenshot({ path: `${folder(page)}/section.png` });
  // The part is folded: the section follows.
  await page.click('[data-testid=section-z]');
  const before = await state(page, 'views.folded.sheet.cut.constant');
  await page.focus('[data-testid=fold-slider]');
  await page.keyboard.press('Home');
  await page.waitForFunction((b) => Math.abs(window.planish.views.folded.sheet.cut.constant - b) > 5, before);
  await page.keyboard.press('x');
  assert.equal(await state(page, 'views.folded.sheet.cut'), null);
  // Through glass what is behind is seen; it is as before without.
  const opacity = () => state(page, 'views.folded.sheet.skin.material.uniforms.opacity.value');
  await page.click('[data-testid=see-through]');
  assert.ok((await opacity()) < 0.5);
  await page.keyboard.press('g');
  assert.equal(await opacity(), 1);
}

/** The cube turns with the part; its faces, edges and corners are clicked, or reached by keys. */
export async function cube({ page }) {
  await example(page, 'bracket.step');
  const box = await page.locator('[data-testid=cube]').boundingBox(),
    middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  await page.click('[data-testid=view-front]');
  await page.waitForTimeout(150);
  await page.mouse.click(middle.x + 20, middle.y); // the edge to its right
  assert.ok(near(await direction(page), [Math.SQRT1_2, -Math.SQRT1_2, 0]), 'an edge');
  await page.waitForTimeout(150);
  await page.mouse.click(middle.x + 15, middle.y);
  assert.ok(near(await direction(page), [1, 0, 0]), 'a face');
  await page.waitForTimeout(150);
  await page.mouse.click(middle.x + 20, middle.y - 20);
  assert.ok(
    near(
      await direction(page),
      [1, 1, 1].map((v) => v / Math.sqrt(3)),
    ),
    'a corner',
  );
  // By keys: one tab stop, arrows, Enter.
  await page.focus('[data-testid=cube-front]');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowUp');
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Front left top');
  await page.keyboard.press('Enter');
  assert.ok(
    near(
      await direction(page),
      [-1, -1, 1].map((v) => v / Math.sqrt(3)),
    ),
  );
  assert.equal(await page.$$eval('.cube button[tabindex="0"]', (all) => all.length), 1);
  // It shows how the part is turned.
  const faces = () => page.evaluate(() => window.planish.views.folded.cube.cells.length / 9);
  assert.equal(await faces(), 3);
  await page.click('[data-testid=view-top]');
  await page.waitForTimeout(150);
  assert.equal(await faces(), 1);
}

/** The room that both views share, kept on this machine; wide patterns lie below their part. */
export async function split({ page }) {
  const boxes = () =>
    page.evaluate(() =>
      ['.folded', '.flat'].map((q) => {
        const r = document.querySelector(q).getBoundingClientRect();
        return [r.x, r.y, r.width, r.height].map(Math.round);
      }),
    );
  await example(page, 'bracket.step');
  const even = await boxes();
  assert.ok(Math.abs(even[0][2] - even[1][2]) <= 1 && even[0][1] === even[1][1], 'side by side, evenly');
  const handle = await page.locator('[data-testid=divider]').boundingBox(),
    at = { x: handle.x + 3, y: handle.y + 200 };
  await drag(page, at, { x: -150, y: 0 });
  const wide = await boxes();
  assert.ok(Math.abs(wide[1][2] - even[1][2] - 150) <= 4, `${wide}`);
  const seen = await state(page, '[views.flat.scale, views.folded.scale]');
  const value = () => page.getAttribute('[data-testid=divider]', 'aria-valuenow').then(Number);
  const now = await value();
  await page.focus('[data-testid=divider]');
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction(
    (n) => Number(document.querySelector('[data-testid=divider]').ariaValueNow) === n + 2,
    now,
  );
  await page.waitForTimeout(500); // until it is kept
  await serveDist(page, process.argv[2]);
  await page.reload();
  await page.waitForFunction(() => window.planish?.store.state.shape);
  await page.waitForFunction(
    (n) => Number(document.querySelector('[data-testid=divider]').ariaValueNow) === n + 2,
    now,
  );
  await page.dblclick('[data-testid=divider]');
  await page.waitForFunction(() => document.querySelector('[data-testid=divider]').ariaValueNow === '50');
  await page.waitForTimeout(300);
  assert.ok((await state(page, 'views.flat.scale')) < seen[0], 'the pattern was larger with more room');
  // A wide pattern.
  await open(page, [`${folder(page)}/../wide.step`]);
  await page.waitForFunction(() => document.querySelector('main').classList.contains('stacked'));
  const [folded, flat] = await boxes();
  assert.ok(folded[0] === flat[0] && flat[1] > folded[1] + 200, 'one above the other');
  assert.equal(await page.getAttribute('[data-testid=divider]', 'aria-orientation'), 'horizontal');
  const stacked = await state(page, 'views.flat.scale');
  await page.click('[data-testid=arrangement]');
  await page.waitForFunction(() => !document.querySelector('main').classList.contains('stacked'));
  await page.waitForTimeout(300);
  assert.ok((await state(page, 'views.flat.scale')) < stacked / 1.3, 'beside it would be smaller');
  await page.dblclick('[data-testid=divider]');
  await page.waitForFunction(() => document.querySelector('main').classList.contains('stacked'));
  await page.waitForTimeout(500); // until that is kept
}

/** However the room is shared, nothing lies over a button, and sliders are wide enough to be held. */
export async function narrow({ page }) {
  await example(page, 'bracket.step');
  const show = (view) => page.evaluate((v) => window.planish.store.dispatch({ type: 'view', view: v }), view);
  const free = async (what) => {
    await page.waitForTimeout(200);
    const wrong = await page.evaluate(() =>
      [...document.querySelectorAll('.view button, .view input')].flatMap((e) => {
        if (e.closest('.cube')) return [];
        const { x, y, width, height, left, right } = e.getBoundingClientRect(),
          view = e.closest('.view').getBoundingClientRect(),
          there = document.elementFromPoint(x + width / 2, y + height / 2),
          name = e.dataset.testid;
        return [
          ...(e.contains(there) ? [] : [`${name} lies under ${there?.className || there?.tagName}`]),
          ...(left < view.left || right > view.right ? [`${name} is cut off`] : []),
          ...(e.type === 'range' && width < 80 ? [`${name} is ${width} px wide`] : []),
        ];
      }),
    );
    assert.deepEqual(wrong, [], what);
  };
  const everywhere = async (what) => {
    for (const arrangement of ['beside', 'stacked'])
      for (const split of [0, 1]) {
        await show({ arrangement, split });
        await free(`${what}, ${arrangement}, ${split}`);
      }
    await show({ arrangement: 'beside', split: 0 });
    await page.screenshot({ path: `${folder(page)}/${what}.png` });
  };
  await everywhere('folded');
  await page.click('[data-testid=view-iso]');
  await page.click('[data-testid=section]');
  await everywhere('section');
  await page.click('[data-testid=section]');
  await page.click('[data-testid=tab-order]');
  await page.click('[data-testid=plan]');
  await page.waitForSelector('[data-testid=stroke-slider]');
  await everywhere('machine');
  await page.dblclick('[data-testid=divider]');
  await page.waitForTimeout(500); // until that is kept
}
