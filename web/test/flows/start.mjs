import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { folder, open, opened, rested, state } from '../driving.mjs';

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
  for (const [kind, name, k] of [
    ['connect', 'plates.json', 0.44],
    ['transition', 'transition.json', 0.5],
    ['slit', 'slits.json', null],
  ]) {
    await page.click(`[data-testid=new-${kind}]`);
    await opened(page, name);
    assert.deepEqual(await state(page, '[s.document.kind, s.shape.report.status]'), [kind, 'ok']);
    assert.deepEqual(
      await state(page, 's.shape.report.checks.filter((c) => c.severity !== "info").map((c) => c.code)'),
      [],
    );
    if (k !== null) {
      assert.match(await page.textContent('[data-testid=unconfirmed]'), new RegExp(`K ${k} is only a default`));
      await page.click('[data-testid=confirm-k]');
      await rested(page);
      assert.equal(await page.locator('[data-testid=unconfirmed]').count(), 0);
      assert.equal(await state(page, 's.input.spec.k_factor'), k);
    }
    await page.evaluate(() => sessionStorage.clear());
    await page.reload();
    await page.waitForSelector('[data-testid=start]');
  }
}

/** Files that were opened are there again, at the next start too, with what lay beside them. */
export async function recent({ page }) {
  const start = async () => {
    await page.evaluate(() => sessionStorage.clear());
    await page.reload();
    await page.waitForSelector('[data-testid=start]');
    await page.waitForFunction(() => window.planish.store.state.description.makers.length);
  };
  const names = () => page.locator('[data-testid=recents] .tile b').allTextContents();
  const examples = new URL('../../../examples/', import.meta.url).pathname;
  await open(page, [`${examples}bracket.step`]);
  await open(page, [`${examples}transition/a_square_to_round.json`]);
  await open(page, [`${examples}bracket.step`]);
  await page.waitForTimeout(500);
  await start();
  assert.deepEqual(await names(), ['bracket.step', 'a_square_to_round.json'], 'the last first, each once');
  assert.equal(await page.locator('[data-testid=recents] path.sheet').count(), 2, 'with pictures');
  await page.screenshot({ path: `${folder(page)}/recent.png` });
  await page.click('[data-testid="recent-a_square_to_round.json"]');
  await opened(page, 'a_square_to_round.json');
  assert.equal(await state(page, 's.shape.report.status'), 'ok');
  const slit = ['slit/scanned_chair.json', ...[0, 1, 2, 3, 4, 5].map((i) => `slit/low_chair_scan${i}.xyz`)];
  await open(
    page,
    slit.map((name) => examples + name),
  );
  await page.waitForTimeout(500);
  await start();
  await page.click('[data-testid="recent-scanned_chair.json"]');
  await opened(page, 'scanned_chair.json');
  assert.equal(await state(page, 's.problem'), null, 'the scans came with it');
  await start();
  await page.click('[data-testid=forget-recents]');
  await page.waitForFunction(() => !document.querySelector('[data-testid=recents]'));
  await start();
  assert.deepEqual(await names(), []);
}

/** Of many files the last eight are kept, and nothing of the others stays. */
export async function many({ page }) {
  const spec = JSON.parse(readFileSync(new URL('../../../examples/connect/c_ripped.json', import.meta.url), 'utf8'));
  for (let i = 0; i < 10; ++i) {
    const path = `${folder(page)}/plate${i}.json`;
    writeFileSync(path, JSON.stringify({ ...spec, thickness: 2 + i / 10 }));
    await open(page, [path]);
  }
  await page.waitForTimeout(500);
  assert.deepEqual(
    await state(page, 's.recents.map((r) => r.name)'),
    [9, 8, 7, 6, 5, 4, 3, 2].map((i) => `plate${i}.json`),
  );
  const kept = await page.evaluate(async () =>
    (await (await fetch('/api/kept', { headers: { 'X-Planish-Token': location.hash.slice(1) } })).json()).map(
      (f) => f.name,
    ),
  );
  assert.equal(kept.filter((name) => name.startsWith('recent-')).length, 8);
}

/** Pages that are open at once share the files opened lately and the workshop: none undoes what another one keeps. */
export async function pages({ page, context }) {
  const address = page.url(),
    other = await context.newPage();
  await other.goto(address);
  await other.waitForFunction(() => window.planish.store.state.description.makers.length);
  await page.bringToFront();
  await open(page, [new URL('../../../examples/bracket.step', import.meta.url).pathname]);
  await page.waitForTimeout(500);
  const table = `${folder(page)}/steel.csv`;
  writeFileSync(table, 'r/t, k\n1, 0.3\n2, 0.4\n');
  await page.selectOption('[data-testid=k-rule]', 'k_table');
  await page.setInputFiles('[data-testid=k_table-open]', table);
  await page.waitForFunction(() => window.planish.store.state.workshop.files.length === 1);
  await other.bringToFront();
  await other.waitForSelector('[data-testid="recent-bracket.step"]');
  await open(other, [new URL('../../../examples/transition/a_square_to_round.json', import.meta.url).pathname]);
  await other.click('[data-testid=download-menu]');
  await other.selectOption('[data-testid=dxf-profile]', 'onshape');
  // A page that is not seen paints nothing.
  await page.waitForFunction(
    () => {
      const { recents, workshop } = window.planish.store.state;
      return recents.some((r) => r.name === 'a_square_to_round.json') && workshop.dxf?.profile === 'onshape';
    },
    null,
    { polling: 100 },
  );
  await page.bringToFront();
  await page.evaluate(() => sessionStorage.clear());
  await page.reload();
  await page.waitForSelector('[data-testid="recent-a_square_to_round.json"]');
  await page.waitForSelector('[data-testid="recent-bracket.step"]');
  assert.deepEqual(await state(page, '[s.workshop.files.length, s.workshop.dxf.profile]'), [1, 'onshape']);
  await other.close();
}
