import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { inTheme, violations } from '../axe.mjs';
import { drag, folder, open, rested, state } from '../driving.mjs';

// A refused part: what the sentence names is marked in it.

/** How many pixels of the folded view are red, as what is marked, and of these the middle, in its pixels. */
const marked = (page) =>
  page.evaluate(async () => {
    const canvas = document.querySelector('[data-testid=folded-canvas]');
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    window.planish.views.folded.draw();
    await new Promise((done) => requestAnimationFrame(done));
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
    let [count, x, y] = [0, 0, 0];
    for (let i = 0; i < data.length; i += 4)
      // Shaded, or seen through the part: nothing else is red.
      if (data[i] > data[i + 1] + 25 && data[i] > data[i + 2] + 25) {
        ++count;
        x += (i / 4) % canvas.width;
        y += Math.floor(i / 4 / canvas.width);
      }
    return { count, x: x / count / window.devicePixelRatio, y: y / count / window.devicePixelRatio };
  });

const at = (page, point) =>
  page.evaluate((p) => {
    const { x, y } = window.planish.views.folded.project(p),
      box = document.querySelector('[data-testid=folded-canvas]').getBoundingClientRect();
    return { x: x - box.left, y: y - box.top };
  }, point);

export async function refusal({ page }) {
  await open(page, [`${folder(page)}/../tube.step`]);
  const named = () => state(page, 's.problem.places');
  const [edge] = await named();
  // Faces 7 to 10 are its inside, at 2 mm, in the order in which the file has them.
  assert.deepEqual([edge.kind, edge.id, edge.faces], ['edge', 21, [7, 8]]);
  const near = async () => {
    const found = await marked(page),
      middle = await at(page, [2, 38, 60]);
    assert.ok(found.count > 50, `${found.count} pixels are marked`);
    assert.ok(Math.hypot(found.x - middle.x, found.y - middle.y) < 6, JSON.stringify({ found, middle }));
    return found;
  };
  await near();
  await page.screenshot({ path: `${folder(page)}/edge.png` });
  // It can be turned, and seen through.
  const box = await page.locator('[data-testid=folded-canvas]').boundingBox();
  const before = await state(page, 'views.folded.direction');
  await drag(page, { x: box.x + 60, y: box.y + box.height - 60 }, { x: 150, y: -40 });
  assert.notDeepEqual(await state(page, 'views.folded.direction'), before);
  await near();
  await page.click('[data-testid=see-through]');
  await near();
  await page.click('[data-testid=see-through]');
  // One click opens it where the sentence says; undo closes it again.
  await page.click('[data-testid^=remedy-rip_edges]');
  await rested(page);
  assert.match(await page.textContent('[data-testid=blank-size]'), /148\.1\d × 120/);
  assert.match(await page.textContent('[data-testid=rip-edges]'), /edge 21/);
  await page.screenshot({ path: `${folder(page)}/ripped.png` });
  await page.click('[data-testid=undo]');
  await page.waitForSelector('[data-testid^=remedy-rip_edges]');
  // A face.
  await open(page, [`${folder(page)}/../stepped.step`]);
  assert.ok((await named()).some(({ kind, id }) => kind === 'face' && id === 6));
  const found = await marked(page),
    corners = [];
  for (const y of [30, 60]) for (const z of [0, 50]) corners.push(await at(page, [3, y, z]));
  assert.ok(found.count > 1000, `${found.count} pixels`);
  for (const k of ['x', 'y']) {
    const range = corners.map((c) => c[k]);
    assert.ok(Math.min(...range) < found[k] && found[k] < Math.max(...range), JSON.stringify({ found, corners }));
  }
  await page.screenshot({ path: `${folder(page)}/face.png` });
  // From behind its name says that it is hidden, in glass it is seen.
  const said = () =>
    page.evaluate(async () => {
      const written = [],
        own = CanvasRenderingContext2D.prototype.fillText;
      CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
        if (text.startsWith('face')) written.push(text);
        own.call(this, text, ...rest);
      };
      window.planish.views.folded.draw();
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      CanvasRenderingContext2D.prototype.fillText = own;
      return written.at(-1);
    });
  assert.equal(await said(), 'face 6');
  const eye = await state(page, 'views.folded.direction'),
    side = eye[0] > 0 ? 'left' : 'right';
  await page.focus(`[data-testid=cube-${side}]`);
  await page.keyboard.press('Enter');
  assert.equal(await said(), 'face 6, behind');
  await page.screenshot({ path: `${folder(page)}/behind.png` });
  await page.click('[data-testid=see-through]');
  assert.equal(await said(), 'face 6');
  await page.click('[data-testid=see-through]');
  // Of plates that cannot be joined, those that are named.
  const plates = JSON.parse(readFileSync(new URL('../../../examples/connect/a_folded.json', import.meta.url)));
  plates.bends = [{ between: ['base', 'back'] }];
  writeFileSync(`${folder(page)}/apart.json`, JSON.stringify(plates));
  await page.setInputFiles('[data-testid=file-input]', [`${folder(page)}/apart.json`]);
  await page.waitForSelector('[data-testid=message]:has-text("do not join plate")');
  assert.match(await page.textContent('[data-testid=message]'), /plate "top" to plate "base"/);
  assert.ok((await marked(page)).count > 5000);
  await page.screenshot({ path: `${folder(page)}/plates.png` });
  await page.click('[data-testid=bends-free]');
  await rested(page);
  assert.equal(await state(page, 'views.folded.solid.group.visible'), false, 'bends are orange, which is nearly red');
  // What is opened next has nothing of it.
  await open(page, [`${folder(page)}/../pressed.step`]);
  assert.equal((await marked(page)).count, 0);
}

/** What is refused has the room, also after a part whose pattern lay below it. */
export async function roomy({ page }) {
  const size = () => page.locator('[data-testid=folded-canvas]').boundingBox(),
    main = await page.locator('main').boundingBox(),
    stacked = () => page.$eval('main', (m) => m.classList.contains('stacked')),
    share = () => page.getAttribute('[data-testid=divider]', 'aria-valuenow');
  await open(page, [`${folder(page)}/../wide.step`]);
  assert.ok(await stacked());
  await open(page, [`${folder(page)}/../tube.step`]);
  assert.ok(!(await stacked()), 'an empty pattern lies beside');
  const { width, height } = await size();
  assert.ok(width > 0.8 * main.width && height > 0.8 * main.height, `${width} × ${height}`);
  assert.equal(await share(), '85');
  await page.screenshot({ path: `${folder(page)}/refused.png` });
  // The divider goes on from there, and what was chosen holds.
  await page.focus('[data-testid=divider]');
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction(() => document.querySelector('[data-testid=divider]').ariaValueNow === '83');
  assert.ok((await size()).width < width);
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.querySelector('[data-testid=divider]').ariaValueNow === '85');
  // With a pattern the views share the room again.
  await page.click('[data-testid^=remedy-rip_edges]');
  await rested(page);
  assert.equal(await share(), '50');
  assert.ok((await size()).width < 0.55 * main.width || (await stacked()));
  await open(page, [`${folder(page)}/../wide.step`]);
  assert.ok(await stacked());
}

/** A finding that names a relief has a button that cuts it. */
export async function reliefs({ page }) {
  await open(page, [`${folder(page)}/../lanced.step`]);
  await page.click('[data-testid=tab-findings]');
  const list = () => page.textContent('[data-testid=findings]');
  const area = () => state(page, 's.shape.report.flat.area');
  assert.match(await list(), /2 ends of bends[^]*without relief; it needs one 1 mm/);
  const drawn = await area();
  await page.click('[data-testid=remedy-bend_relief-round]');
  await rested(page);
  assert.match(await list(), /2 round reliefs are cut beside bends/);
  assert.doesNotMatch(await list(), /without relief/);
  const round = await area();
  // Its outline is drawn, and within it nothing is, also where the slit was.
  const line = await state(page, '[...s.shape.bend_lines]'),
    corner = [line[0], Math.max(line[1], line[3])],
    at = await state(page, `views.flat.project(${JSON.stringify(corner)})`);
  await page.mouse.move(at.x, at.y);
  for (let turns = 0; turns < 5; ++turns) await page.mouse.wheel(0, -400);
  await page.waitForTimeout(200);
  const darkest = (away) =>
    page.evaluate(
      ([x, y]) => {
        const { flat } = window.planish.views,
          canvas = document.querySelector('[data-testid=flat-canvas]'),
          box = canvas.getBoundingClientRect(),
          at = flat.project([x, y]),
          near = canvas.getContext('2d').getImageData(at.x - box.left - 2, at.y - box.top - 2, 5, 5).data;
        return Math.min(...near.filter((_, i) => i % 4 === 1));
      },
      [corner[0] + 0.5, corner[1] + away],
    );
  for (const line of [0, 1]) assert.ok((await darkest(line)) < 120, `a side of the relief, ${line} mm from the bend`);
  for (const off of [0.2, 0.5, 0.8, 1.2]) assert.ok((await darkest(off)) > 200, `no line ${off} mm from the bend`);
  await page.screenshot({ path: `${folder(page)}/round.png` });
  await page.click('[data-testid=undo]');
  await page.click('[data-testid=remedy-bend_relief-square]');
  await rested(page);
  assert.match(await list(), /2 reliefs are cut/);
  // Each 1 mm wide over the bend zone and 0.2 mm beyond at both ends; the slits of 0.01 mm are cut anyway.
  const zone = (Math.PI / 2) * (2 + 0.44 * 2),
    square = 2 * (0.99 * (zone + 0.2) + 0.2);
  assert.ok(Math.abs(drawn - (await area()) - square) < 1e-3, `${drawn - (await area())} mm² is cut`);
  // With half circles at both ends.
  assert.ok(drawn - round > square, `${drawn - round} mm² is cut`);
  await page.click('[data-testid=remedy-bend_relief-none]');
  await rested(page);
  assert.equal(await area(), drawn);
}

/** A refused part offers what can be had of it, and says where the reason is for the rest. */
export async function offered({ page }) {
  await open(page, [`${folder(page)}/../tube.step`]);
  await page.click('[data-testid=download-menu]');
  const all = page.locator('.downloads .list button[data-testid^=download-]');
  const offers = await all.evaluateAll((es) => es.map((e) => [e.dataset.testid, e.disabled, e.title]));
  assert.ok(offers.length >= 7);
  for (const [name, disabled, title] of offers) {
    assert.equal(disabled, name !== 'download-json', name);
    assert.equal(/The reason is at the top/.test(title), disabled, name);
  }
  assert.match(await page.textContent('[data-testid=download-refused]'), /Refused/);
  for (const theme of ['light', 'dark']) {
    await inTheme(page, theme);
    assert.deepEqual(await violations(page), [], theme);
    await page.screenshot({ path: `${folder(page)}/downloads-${theme}.png` });
  }
  await page.keyboard.press('Escape');
  for (const one of ['pick-root', 'pick-up', 'up-turn'])
    assert.equal(await page.locator(`[data-testid=${one}]`).isDisabled(), true, one);
  await page.click('[data-testid=tab-findings]');
  await page.waitForSelector('[data-testid=no-findings]');
  assert.match(await page.textContent('[data-testid=no-findings]'), /refused.*The reason is at the top/s);
  await page.click('[data-testid=tab-bends]');
  await page.locator('[data-testid=panel]', { hasText: 'Refused: no bends are known.' }).waitFor();
  // Opened along its edge it has all of it.
  await page.click('[data-testid^=remedy-rip_edges]');
  await rested(page);
  await page.click('[data-testid=tab-input]');
  for (const one of ['pick-root', 'pick-up', 'up-turn']) await page.waitForSelector(`[data-testid=${one}]:enabled`);
  await page.click('[data-testid=download-menu]');
  assert.deepEqual(await all.evaluateAll((es) => es.filter((e) => e.disabled).length), 0);
  assert.equal(await page.locator('[data-testid=download-refused]').count(), 0);
}
