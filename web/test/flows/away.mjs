import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { inTheme, violations } from '../axe.mjs';
import { enter, example, folder, open, opened, rested, state } from '../driving.mjs';

// What is left for another file, or for the start page, can be opened again as it was.

const examples = new URL('../../../examples/', import.meta.url).pathname;
const titles = (page) => page.locator('[data-testid=recents] .tile b').allTextContents();
const tile = (page, title) => page.locator('[data-testid=recents] .tile', { hasText: title });

async function toStart(page) {
  await page.click('[data-testid=start-page]');
  await page.waitForSelector('[data-testid=start]');
}

/** Edits of a document that another one takes the place of are among the files opened lately; none without edits. */
export async function leaving({ page }) {
  await page.click('[data-testid=new-connect]');
  await opened(page, 'plates.json');
  await open(page, [`${examples}bracket.step`]);
  await page.waitForTimeout(600);
  assert.deepEqual(await state(page, 's.recents.map((r) => r.name)'), ['bracket.step'], 'nothing new if not edited');
  await toStart(page);
  await page.click('[data-testid=new-connect]');
  await opened(page, 'plates.json');
  await enter(page, 'thickness', '3');
  await page.click('[data-testid=plate-base]');
  await page.click('[data-testid=plate-add]');
  await rested(page);
  const spec = await state(page, 's.input.spec');
  assert.deepEqual([spec.thickness, spec.plates.length], [3, 3]);
  // At once, before it rests: another file takes its place.
  await enter(page, 'thickness', '4');
  await example(page, 'connect/a_folded.json');
  assert.match(await page.textContent('[data-testid=message]'), /plates\.json is kept as edited/);
  await enter(page, 'thickness', '2.5');
  await page.waitForTimeout(1000); // and one that rests, whose page is closed
  await page.evaluate(() => sessionStorage.clear());
  await page.reload();
  await page.waitForSelector('[data-testid=recents]');
  assert.deepEqual(await titles(page), ['a_folded.json (edited)', 'New bent plate', 'bracket.step']);
  await page.waitForFunction(() => document.querySelectorAll('[data-testid=recents] path.sheet').length === 3);
  for (const theme of ['light', 'dark']) {
    await inTheme(page, theme);
    assert.deepEqual(await violations(page), [], theme);
    await page.screenshot({ path: `${folder(page)}/start-${theme}.png` });
  }
  await tile(page, 'New bent plate').click();
  await opened(page, 'plates.json');
  assert.deepEqual(await state(page, 's.input.spec'), { ...spec, thickness: 4 }, 'as it was left');
  // It goes on in the same entry, after a reload too; undone to how it was opened, it stays as it was.
  await enter(page, 'thickness', '5');
  await rested(page);
  await page.reload();
  await opened(page, 'plates.json');
  await enter(page, 'thickness', '6');
  await toStart(page);
  assert.deepEqual(await titles(page), ['New bent plate', 'a_folded.json (edited)', 'bracket.step']);
  await tile(page, 'New bent plate').click();
  await opened(page, 'plates.json');
  assert.equal(await state(page, 's.input.spec.thickness'), 6);
  await enter(page, 'thickness', '7');
  await page.waitForTimeout(800);
  await page.keyboard.press('Control+z');
  await toStart(page);
  await page.waitForTimeout(300);
  await tile(page, 'New bent plate').click();
  await opened(page, 'plates.json');
  assert.equal(await state(page, 's.input.spec.thickness'), 6);
  // Edits that were all undone leave nothing.
  await example(page, 'connect/c_ripped.json');
  await enter(page, 'thickness', '1.5');
  await page.waitForTimeout(800);
  await page.keyboard.press('Control+z');
  await page.waitForTimeout(800);
  await toStart(page);
  assert.deepEqual(await titles(page), ['New bent plate', 'a_folded.json (edited)', 'bracket.step']);
  // Of a part the options: its one entry has them.
  await tile(page, 'bracket.step').click();
  await opened(page, 'bracket.step');
  await page.selectOption('[data-testid=k-rule]', 'din6935');
  await toStart(page);
  // At once, whether the list shows the edit yet or not.
  await tile(page, 'bracket.step').click();
  await opened(page, 'bracket.step');
  assert.equal(await state(page, 's.input.options.din6935'), true);
  await toStart(page);
  await page.waitForFunction(
    () => document.querySelector('[data-testid=recents] .tile b')?.textContent === 'bracket.step (edited)',
  );
  await open(page, [`${examples}bracket.step`]);
  assert.equal(await state(page, 's.input.options.din6935'), undefined, 'the file itself has no edits');
}

/** From a part one goes back to where one began, by mouse and keys, and a reload stays there. */
export async function startpage({ page }) {
  assert.equal(await page.locator('[data-testid=start-page]').count(), 0, 'not where one is there already');
  await open(page, [`${examples}bracket.step`]);
  const button = page.getByRole('button', { name: 'Start page' });
  await button.focus();
  for (const theme of ['light', 'dark']) {
    await inTheme(page, theme);
    assert.deepEqual(await violations(page), [], theme);
    await page.screenshot({ path: `${folder(page)}/part-${theme}.png` });
  }
  await page.keyboard.press('Enter');
  await page.waitForSelector('[data-testid=start]');
  await page.waitForFunction(() => document.activeElement?.dataset.testid === 'start-open');
  for (const theme of ['light', 'dark']) {
    await inTheme(page, theme);
    assert.deepEqual(await violations(page), [], theme);
  }
  assert.equal(await state(page, 's.document'), null);
  assert.equal(await page.textContent('[data-testid=status]'), 'ready');
  await page.waitForSelector('[data-testid="recent-bracket.step"]');
  await page.reload();
  await page.waitForSelector('[data-testid="recent-bracket.step"]');
  // At once, while the bodies are looked at.
  await page.setInputFiles('[data-testid=file-input]', [`${folder(page)}/../sixty.step`]);
  await page.waitForFunction(() => window.planish.store.state.document);
  await toStart(page);
  await page.waitForTimeout(1000);
  assert.deepEqual(await state(page, '[s.document, s.problem, s.computing, s.opening]'), [null, null, false, null]);
  await page.click('[data-testid=new-slit]');
  await opened(page, 'slits.json');
  assert.equal(await state(page, 's.shape.report.status'), 'ok');
}

/** A reload keeps the tab; of another file, of another kind, the input is shown first. */
export async function tabkept({ page }) {
  await open(page, [`${examples}bracket.step`]);
  for (const tab of ['certificate', 'bends', 'findings']) {
    await page.click(`[data-testid=tab-${tab}]`);
    await page.reload();
    await opened(page, 'bracket.step');
    assert.equal(await state(page, 's.tab'), tab);
  }
  await example(page, 'connect/a_folded.json');
  assert.equal(await state(page, 's.tab'), 'input');
}

/** Files that lie beside the one that is opened are not left out in silence. */
export async function besides({ page }) {
  const notes = `${folder(page)}/x y.txt`,
    other = `${folder(page)}/other.json`;
  writeFileSync(notes, 'Bend it\n');
  writeFileSync(other, '{}');
  const message = () => page.textContent('[data-testid=message]');
  await open(page, [`${examples}bracket.step`, notes]);
  assert.equal(await message(), 'Not opened: x y.txt, which the file does not name.');
  await open(page, [`${examples}bracket.step`, other, notes]);
  assert.equal(
    await message(),
    'One file at a time; left out: other.json. Not opened: x y.txt, which the file does not name.',
  );
  await page.screenshot({ path: `${folder(page)}/notes.png` });
  const scans = [0, 1, 2, 3, 4, 5].map((i) => `${examples}slit/low_chair_scan${i}.xyz`);
  await open(page, [`${examples}slit/scanned_chair.json`, ...scans, notes]);
  assert.equal(await message(), 'Not opened: x y.txt, which the file does not name.');
}
