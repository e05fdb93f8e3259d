// The states of the page that docs/studio.md shows, by the names of their pictures.
import { example, open, opened, rested, state } from './driving.mjs';
import { serveDist } from './serve-dist.mjs';
import { channel } from './channel.mjs';
import { walls } from './walls.mjs';

const examples = new URL('../../examples/', import.meta.url).pathname;

const tab = (page, name) => page.click(`[data-testid=tab-${name}]`);
const away = (page) => page.mouse.move(3, 3); // the pointer lights nothing up

async function begin({ page, address }) {
  await open(page, [`${examples}bracket.step`]);
  await open(page, [`${examples}transition/a_square_to_round.json`]);
  await open(page, [`${examples}connect/a_folded.json`]);
  await page.waitForTimeout(500);
  await page.evaluate(() => sessionStorage.clear());
  await serveDist(page, address);
  await page.reload();
  await page.waitForFunction(() => document.querySelectorAll('[data-testid=recents] path.sheet').length === 3);
  await page.waitForFunction(() => [...document.querySelectorAll('.tile img')].every((i) => i.complete));
}

async function unfold({ page }) {
  await example(page, 'bracket.step');
  await tab(page, 'bends');
  await page.click('[data-testid=bend-B1]');
  await away(page);
}

async function refused({ page, made }) {
  await open(page, [`${made}/box_tube.step`]);
  await away(page);
}

async function overlap({ page }) {
  await page.setInputFiles('[data-testid=file-input]', {
    name: 'walls.json',
    mimeType: 'application/json',
    buffer: Buffer.from(walls),
  });
  await opened(page, 'walls.json');
  await tab(page, 'findings');
  await page.waitForSelector('[data-testid=finding-1]');
}

async function findings({ page, made }) {
  await open(page, [`${made}/hexagon_tray.step`]);
  await tab(page, 'findings');
  await page.click('[data-testid=finding-1] button');
  await away(page);
}

async function remedy({ page, made }) {
  await open(page, [`${made}/shelled_box.step`]);
  await page.click('[data-testid^=remedy-rip_edges]');
  await rested(page);
  await away(page);
}

async function relief({ page, made }) {
  await open(page, [`${made}/lanced.step`]);
  await tab(page, 'findings');
  await page.click('[data-testid=finding-1] button');
  await away(page);
}

/** Clicks places of a view to measure between them. */
async function click(page, view, ...places) {
  for (const at of places) {
    const p = await state(page, `views.${view}.project(${JSON.stringify(at)})`);
    await page.mouse.move(p.x, p.y);
    await page.waitForTimeout(60);
    await page.mouse.click(p.x, p.y);
  }
}

async function measure({ page }) {
  await example(page, 'bracket.step');
  await page.keyboard.press('d');
  await click(page, 'flat', [24, 71.309], [56, 71.309]); // both holes
  await click(page, 'flat', [30, 22], [0, 14]); // an end of the slot, and the edge beside it
  await click(page, 'folded', [15, 15, 0], [30, 52.5, 8]); // two flanges
  await click(page, 'folded', [56, 52.5, 18.5], [52, 40, 0]); // a hole above the flange
  await away(page);
}

async function section({ page }) {
  await example(page, 'bracket.step');
  await page.keyboard.press('x');
  await page.click('[data-testid=section-x]');
  await page.focus('[data-testid=section-slider]');
  for (let i = 0; i < 20; ++i) await page.keyboard.press('ArrowLeft'); // through the slot
  await page.locator('[data-testid=section-slider]').blur();
  await away(page);
}

async function glass({ page, made }) {
  await open(page, [`${made}/lipped_box.step`]);
  await page.keyboard.press('g');
}

async function stacked({ page, made }) {
  await open(page, [`${made}/staircase.step`]);
}

async function bodies({ page, made }) {
  await open(page, [`${made}/all_parts.step`]);
  await page.waitForFunction(
    () =>
      Object.keys(window.planish.store.state.bodies).length === window.planish.store.state.document.info.bodies.length,
    null,
    { timeout: 120000 },
  );
  await page.click('[data-testid=body-14]');
  await rested(page);
  await page.click('[data-testid=arrangement]'); // what was suggested is for the first body
  await away(page);
}

async function shop({ page }) {
  await example(page, 'bracket.step');
  await page.selectOption('[data-testid=k-rule]', 'shop');
  await page.setInputFiles('[data-testid=shop-open]', `${examples}shop/example.json`);
  await page.selectOption('[data-testid=shop-material]', 'mild steel');
  await rested(page);
}

async function dxf({ page }) {
  await example(page, 'bracket.step');
  await page.click('[data-testid=download-menu]');
  await page.selectOption('[data-testid=dxf-marks]', 'ticks');
  await page.check('[data-testid=dxf-turned]');
  await away(page);
}

async function planned(page) {
  await tab(page, 'order');
  await page.click('[data-testid=plan]');
  await page.waitForFunction(() => {
    const { order } = window.planish.store.state;
    return order.answer && !order.computing && !order.asked;
  });
}

async function order({ page }) {
  await example(page, 'bracket.step');
  await planned(page);
  await page.click('[data-testid=stroke-2]');
  await away(page);
}

/** The channel's strokes in the wrong order: its long leg is in the way of the punch. */
async function collision({ page }) {
  await open(page, [channel(page)]);
  await page.click('[data-testid=arrangement]');
  await planned(page);
  await page.click('[data-testid=view-right]');
  await page.focus('[data-testid=stroke-2]');
  await page.keyboard.press('Alt+ArrowUp');
  await page.waitForFunction(() => {
    const { order } = window.planish.store.state;
    return order.given && order.answer && !order.computing && !order.asked;
  });
  await page.click('[data-testid=stroke-2]');
  await away(page);
}

async function help({ page }) {
  await example(page, 'bracket.step');
  await page.keyboard.press('?');
}

async function connect({ page }) {
  await example(page, 'connect/a_folded.json');
  await page.click('[data-testid=plate-right]');
  await away(page);
}

async function transition({ page }) {
  await example(page, 'transition/d_offset_square_to_round.json');
}

async function slit({ page }) {
  await example(page, 'slit/chair.json');
}

async function strips({ page }) {
  await example(page, 'slit/plume.json');
  await page.click('[data-testid=strip-head-1]');
  await away(page);
}

export const scenes = {
  start: begin,
  unfold,
  refused,
  overlap,
  findings,
  remedy,
  relief,
  measure,
  section,
  glass,
  stacked,
  bodies,
  shop,
  dxf,
  order,
  collision,
  help,
  connect,
  transition,
  slit,
  strips,
};
