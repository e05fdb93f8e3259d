import assert from 'node:assert/strict';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { enter, example, folder, fresh, openAtServer, rested, slide, state } from '../driving.mjs';

function killWorkers() {
  for (const entry of readdirSync('/proc').filter((name) => /^\d+$/.test(name))) {
    let line = '';
    try {
      line = readFileSync(`/proc/${entry}/cmdline`, 'utf8');
    } catch {
      continue;
    }
    const [, command, server] = line.split('\0');
    if (command === 'studio-worker' && server === process.env.STUDIO_PROCESS) process.kill(Number(entry), 'SIGKILL');
  }
}

export async function rubbish({ page }) {
  const others = await openAtServer(page);
  writeFileSync(`${folder(page)}/rubbish.step`, 'this is no STEP file');
  const refused = async () => {
    await page.setInputFiles('[data-testid=file-input]', `${folder(page)}/rubbish.step`);
    await page.waitForFunction(() => window.planish.store.state.problem);
  };
  await refused();
  console.log(`   ${await page.textContent('[data-testid=message]')}`);
  await example(page, 'connect/a_folded.json');
  assert.equal(await state(page, 's.problem'), null);
  await refused();
  assert.deepEqual(await state(page, '[s.document.name, s.stale, s.opening, s.shape.parts.length]'), [
    'a_folded.json',
    false,
    null,
    9,
  ]);
  assert.deepEqual(await openAtServer(page), [...others, 'a_folded.json']);
}

export async function opening({ page, said }) {
  const others = await openAtServer(page);
  await example(page, 'connect/a_folded.json');
  await page.route('**/api/documents/*/open', async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 2000));
    await route.continue().catch(() => undefined); // given up meanwhile
  });
  const slow = () =>
    page.setInputFiles(
      '[data-testid=file-input]',
      new URL('../../../examples/transition/e_reducer.json', import.meta.url).pathname,
    );
  await slow();
  await page.waitForSelector('[data-testid=progress]');
  assert.match(await page.textContent('.messages'), /opening\s+Opening e_reducer.json …\s+reading\s+Cancel/);
  await page.click('[data-testid=cancel]');
  await page.waitForFunction(() => window.planish.store.state.note === 'cancelled');
  assert.deepEqual(await state(page, '[s.document.name, s.opening, s.stale, s.problem]'), [
    'a_folded.json',
    null,
    false,
    null,
  ]);
  assert.deepEqual(await openAtServer(page), [...others, 'a_folded.json']);
  // The one that was asked for last is opened, even where another takes longer.
  await slow();
  await page.waitForSelector('[data-testid=progress]');
  await page.unroute('**/api/documents/*/open');
  await example(page, 'connect/c_ripped.json');
  await page.waitForTimeout(2500);
  assert.equal(await state(page, 's.document.name'), 'c_ripped.json');
  assert.deepEqual(await openAtServer(page), [...others, 'c_ripped.json']);
  // One that the server has let go is opened again, with the edits.
  const id = await state(page, 's.document.id');
  await page.evaluate(
    (gone) =>
      fetch(`/api/documents/${gone}`, { method: 'DELETE', headers: { 'X-Planish-Token': location.hash.slice(1) } }),
    id,
  );
  await enter(page, 'thickness', '1.5');
  await page.waitForFunction((gone) => window.planish.store.state.document.id !== gone, id);
  await rested(page);
  assert.deepEqual(await state(page, '[s.problem, s.shape.report.sheet.thickness, s.opening]'), [null, 1.5, null]);
  said.length = 0; // the browser notes that the document was gone
}

export async function killed({ page, said }) {
  await example(page, 'slit/chair.json');
  // Between two requests: nobody notices.
  killWorkers();
  await page.click('[data-testid=coarser]');
  await rested(page);
  assert.equal(await state(page, 's.problem'), null);
  // In the middle of one, that takes seconds: the page says so, and goes on with the next edit.
  for (let i = 0; i < 3; ++i) await page.click('[data-testid=subdivide]');
  await page.waitForFunction(
    () => {
      const s = window.planish.store.state;
      return s.computing && s.shapeIsDraft && s.busy;
    },
    null,
    { timeout: 60000 },
  );
  killWorkers();
  await page.waitForFunction(() => window.planish.store.state.problem);
  assert.match(await page.textContent('[data-testid=message]'), /worker/);
  said.length = 0; // the browser notes the status of the answer
  for (let i = 0; i < 3; ++i) await page.click('[data-testid=coarser]');
  await rested(page);
  assert.equal(await state(page, 's.problem'), null);
}

export async function two({ page, said }) {
  const other = await fresh();
  await example(page, 'transition/a_square_to_round.json');
  await example(other.page, 'connect/a_folded.json');
  const blank = (p) => p.textContent('[data-testid=blank-size]');
  const before = await blank(page),
    beside = await blank(other.page);
  await slide(page, 'to-z', 0.9);
  await rested(page);
  await rested(other.page);
  assert.notEqual(await blank(page), before);
  assert.equal(await blank(other.page), beside, 'the other page is as it was');
  await other.page.click('[data-testid=bend-head-B1]');
  await slide(other.page, 'bend-radius', 0.3);
  await rested(other.page);
  assert.equal(await state(page, 's.document.name'), 'a_square_to_round.json');
  said.push(...other.said);
  await other.context.close();
}
