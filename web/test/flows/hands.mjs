import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { address, coarse, drag, example, folder, open, opened, rested, state } from '../driving.mjs';

// What hands do at once: type and drag, change their mind in the middle, go on by keys.

const centre = async (page, id) => {
  await page.locator(`[data-testid=${id}]`).scrollIntoViewIfNeeded();
  const box = await page.locator(`[data-testid=${id}]`).boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
};
const seat = (page) => state(page, 's.input.spec.seat_curve.bezier');

/** Ctrl+Z in a field takes back what is typed there; where that was entered, the last edit. */
export async function undofield({ page }) {
  await example(page, 'transition/a_square_to_round.json');
  const thickness = () => state(page, 's.input.spec.thickness'),
    before = await thickness(),
    field = page.locator('[data-testid=thickness]');
  await field.fill(String(before + 1));
  await field.press('Enter');
  await rested(page);
  assert.equal(await thickness(), before + 1);
  await field.press('Control+z');
  assert.equal(await field.inputValue(), String(before));
  assert.equal(await thickness(), before);
  await field.blur();
  assert.deepEqual(await state(page, '[s.past.length, s.future.length]'), [0, 1]);
  await field.focus();
  await field.press('Control+Shift+z');
  assert.equal(await field.inputValue(), String(before + 1));
  await field.pressSequentially('5');
  await field.press('Control+z');
  assert.equal(await thickness(), before + 1, 'what is typed is taken back first');
  assert.deepEqual(await state(page, '[s.past.length, s.future.length]'), [1, 0]);
  await field.press('Escape');
  await rested(page);
}

/** What is typed is entered by leaving the field, whatever one takes hold of next. */
export async function typed({ page }) {
  await open(page, [coarse(page, 'chair.json')]);
  await page.click('[data-testid=curve-seat-1]');
  await page.fill('[data-testid=curve-seat-z]', '400');
  await drag(page, await centre(page, 'curve-seat-2'), { x: 10, y: 4 }, 4);
  await rested(page);
  assert.equal((await seat(page))[1][1], 400, 'the point that was typed stays while another one is dragged');
  const count = (await seat(page)).length;
  await page.click('[data-testid=curve-seat-1]');
  await page.fill('[data-testid=curve-seat-z]', '390');
  await page.click('[data-testid=curve-seat-raise]');
  await rested(page);
  assert.equal((await seat(page)).length, count + 1);
  await page.keyboard.press('Control+z');
  assert.equal((await seat(page))[1][1], 390, 'the typed one is a step of its own');
  await rested(page);

  await example(page, 'transition/a_square_to_round.json');
  const size = () =>
    state(
      page,
      `(() => { const p = s.input.spec.from.profile.polygon, of = (k) => Math.max(...p.map((q) => q[k])) -
      Math.min(...p.map((q) => q[k])); return [of(0), of(1)]; })()`,
    );
  const [, height] = await size();
  await page.fill('[data-testid=from-width-number]', '333');
  const box = await page.locator('[data-testid=from-height]').boundingBox();
  await page.mouse.move(box.x + 0.7 * box.width, box.y + box.height / 2);
  await page.mouse.down();
  await page.waitForTimeout(60);
  await page.mouse.up();
  await rested(page);
  const [width, taller] = await size();
  assert.ok(Math.abs(width - 333) < 1e-6, `${width}`);
  assert.ok(Math.abs(taller - height) > 50, `the slider counts too: ${taller} after ${height}`);
  const shown = await page.inputValue('[data-testid=from-height-number]');
  assert.ok(Math.abs(Number(shown) - taller) < 0.01);
}

/** Escape lets go of what is dragged, and so does Ctrl+Z; it stays as it was, wherever the pointer goes then. */
export async function giveup({ page }) {
  await open(page, [coarse(page, 'chair.json')]);
  const still = async (name, at, by, spec) => {
    const before = await spec(),
      past = await state(page, 's.past.length');
    for (const key of ['Escape', 'Control+z']) {
      await page.mouse.move(at.x, at.y);
      await page.mouse.down();
      for (let i = 1; i <= 4; ++i) {
        await page.mouse.move(at.x + (by.x * i) / 4, at.y + (by.y * i) / 4);
        await page.waitForTimeout(30);
      }
      assert.notDeepEqual(await spec(), before, `${name} is dragged`);
      await page.keyboard.press(key);
      assert.deepEqual(await spec(), before, `${name}, ${key}`);
      await page.mouse.move(at.x + 2 * by.x, at.y + 2 * by.y);
      await page.waitForTimeout(60);
      await page.mouse.up();
      await page.waitForTimeout(60);
      assert.deepEqual(await spec(), before, `${name} stays as it was`);
      assert.equal(await state(page, 's.past.length'), past, 'no step of undo is left');
    }
    await rested(page);
  };
  await still('point', await centre(page, 'curve-seat-1'), { x: 14, y: 9 }, () => seat(page));
  const at = await centre(page, 'curve-seat-1'),
    before = (await seat(page))[1];
  await drag(page, { x: at.x + 5, y: at.y + 3 }, { x: 1, y: 0 }, 1);
  await rested(page);
  const after = (await seat(page))[1];
  assert.ok(Math.hypot(after[0] - before[0], after[1] - before[1]) < 8, `held beside its centre: ${before}, ${after}`);

  await example(page, 'transition/a_square_to_round.json');
  const height = () => state(page, 's.input.spec.to.frame.origin[2]'),
    slider = await page.locator('[data-testid=to-z]').boundingBox(),
    share = await page.$eval('[data-testid=to-z]', (e) => (e.value - e.min) / (e.max - e.min)),
    thumb = { x: slider.x + 8 + share * (slider.width - 16), y: slider.y + slider.height / 2 };
  await still('slider', thumb, { x: -24, y: 0 }, height);
  assert.ok(Math.abs(Number(await page.inputValue('[data-testid=to-z]')) - (await height())) < 2, 'its thumb is back');

  await example(page, 'connect/a_folded.json');
  await page.click('[data-testid=plate-right]');
  await page.waitForTimeout(200);
  const plate = () => state(page, `s.input.spec.plates.find((p) => p.id === 'right').outline`);
  const middle = await state(
    page,
    `(() => { const c = s.shape.handles.plates.find((p) => p.id === 'right').corners;
    return views.folded.project([0, 1, 2].map((k) => c.reduce((t, p) => t + p[k], 0) / c.length)); })()`,
  );
  await still('plate', middle, { x: 30, y: 10 }, plate);
}

/** The space bar toggles what has the focus; elsewhere it folds. */
export async function spacebar({ page }) {
  await open(page, [coarse(page, 'chair.json')]);
  await page.focus('[data-testid=leg-fit]');
  await page.keyboard.press('Space');
  await rested(page);
  assert.equal(await page.isChecked('[data-testid=leg-fit]'), true);
  assert.equal(await state(page, 's.fold'), 1);
  await page.keyboard.press('Space');
  await rested(page);
  assert.equal(await page.isChecked('[data-testid=leg-fit]'), false);
  await page.locator('[data-testid=leg-fit]').blur();
  await page.keyboard.press('Space');
  await page.waitForFunction(() => window.planish.store.state.fold === 0);
  // What has the focus is never hidden, and what is done with leaves it where it was.
  await page.click('[data-testid=download-menu]');
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('[data-testid="download-dxf"]')]);
  await file.path();
  assert.equal(await page.evaluate(() => document.activeElement.dataset.testid), 'download-menu');
}

/** Of a large file, and of one that was named on the command line, a reload keeps the edits too. */
export async function large({ page, said }) {
  const comment = `/* ${'x'.repeat(93)} */\n`,
    path = `${folder(page)}/large.step`,
    text = readFileSync(new URL('../../../examples/bracket.step', import.meta.url), 'utf8');
  writeFileSync(path, text.replace('DATA;', `DATA;\n${comment.repeat(50_000)}`));
  await open(page, [path]);
  await page.waitForFunction(() => sessionStorage.getItem('planish-file'));
  await page.click('[data-testid=up-turn]');
  await rested(page);
  const options = await state(page, 's.input.options');
  assert.equal(await state(page, 's.past.length'), 1);
  await page.reload();
  await opened(page, 'large.step');
  assert.deepEqual(await state(page, 's.input.options'), options);
  await page.keyboard.press('Control+z');
  await rested(page);
  assert.deepEqual(await state(page, 's.input.options'), {});
  // A file of middle size beside a long list: browsers let only 64 KiB outlive a page.
  const middling = `${folder(page)}/middling.step`;
  writeFileSync(middling, text.slice(0, -1));
  await page.evaluate(() => {
    const { store } = window.planish;
    store.dispatch({
      type: 'recents',
      recents: [...store.state.recents, { key: 'k', name: 'x'.repeat(26_000), kind: 'unfold', beside: [] }],
    });
  });
  await open(page, [middling]);
  await page.waitForFunction(() => window.planish.store.state.recents[0].name === 'middling.step');
  // One that is gone is said by its name, and its tile goes.
  await page.evaluate(() => sessionStorage.clear());
  await page.reload();
  await page.waitForSelector('[data-testid="recent-large.step"]');
  assert.deepEqual(
    await page.evaluate(() =>
      [...document.querySelectorAll('button, [tabindex="0"], canvas')]
        .filter((e) => e.checkVisibility() && !e.closest('[inert]'))
        .filter((e) => {
          const r = e.getBoundingClientRect(),
            top = document.elementFromPoint(r.x + r.width / 2, r.y + r.height / 2);
          return r.bottom < innerHeight && top && !e.contains(top) && !top.contains(e);
        })
        .map((e) => e.dataset.testid ?? e.className),
    ),
    [],
    'nothing that takes the focus is hidden',
  );
  const { key } = await state(page, `s.recents.find((r) => r.name === 'large.step')`),
    { origin, hash } = new URL(address);
  await fetch(`${origin}/api/kept/recent-${key}-0`, {
    method: 'DELETE',
    headers: { 'X-Planish-Token': hash.slice(1) },
  });
  await page.click('[data-testid="recent-large.step"]');
  await page.waitForSelector('[data-testid=message]:has-text("large.step is no longer kept")');
  await page.waitForSelector('[data-testid="recent-large.step"]', { state: 'detached' });
  assert.match(said.splice(0).join(), /404/); // the browser says so by itself
}

/** A file that the studio was started with: a reload keeps its edits. */
export async function given({ page }) {
  await page.waitForFunction(() => window.planish.store.state.result);
  await page.click('[data-testid=up-turn]');
  await rested(page);
  const options = await state(page, 's.input.options');
  assert.equal(await state(page, 's.past.length'), 1);
  await page.reload();
  await page.waitForFunction(() => window.planish?.store.state.result);
  await rested(page);
  assert.deepEqual(await state(page, 's.input.options'), options);
  await page.keyboard.press('Control+z');
  await rested(page);
  assert.deepEqual(await state(page, 's.input.options'), {});
  // From the start page, too, where a reload stays, it can be opened again, as it was left.
  await page.click('[data-testid=up-turn]');
  await rested(page);
  await page.click('[data-testid=start-page]');
  await page.click('[data-testid=start-given]');
  await page.waitForFunction(() => window.planish.store.state.result);
  assert.deepEqual(await state(page, 's.input.options'), options);
  await page.click('[data-testid=start-page]');
  await page.reload();
  await page.waitForSelector('[data-testid=start-given]');
  assert.equal(await state(page, 's.document'), null);
  await page.click('[data-testid=start-given]');
  await page.waitForFunction(() => window.planish.store.state.result);
}
given.isAlone = true; // its studio was started with a file
