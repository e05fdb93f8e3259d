import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { channel } from '../channel.mjs';
import { address, example, folder, open, rested, state } from '../driving.mjs';
import { checked, drawn, plan, strokeNames } from '../ordering.mjs';
import { serveDist } from '../serve-dist.mjs';

/** What readers of the screen are told of a view, besides its name. */
const described = (page, view) =>
  page.$eval(`.${view} .canvas`, (c) => document.getElementById(c.getAttribute('aria-describedby')).textContent);

/** Colour of a tool: red where it collides. */
const toolIsRed = (page, tool) =>
  state(
    page,
    `(() => { const { machine, palette } = views.folded;
      return '#' + machine.materials[${JSON.stringify(tool)}].color.getHexString() === palette.hit; })()`,
  );

/** The plan is played, looked at stroke by stroke, and left again. */
export async function order({ page }) {
  await example(page, 'bracket.step');
  await plan(page);
  await page.waitForSelector('[data-testid=order-status]:has-text("The cheapest order: cost")');
  const strokes = await strokeNames(page);
  assert.equal(await state(page, 'views.folded.machine.group.visible'), true, 'the sheet is in the machine');
  await page.click('[data-testid=stroke-2]');
  assert.equal(await state(page, 's.selection.part'), strokes[1], 'the bend that is pressed is picked');
  await page.waitForSelector('[data-testid=stroke-shown]:has-text("2 of ")');
  // the sheet lies on the die: what is lowest of it over the shoulders is at the die's top
  await page.evaluate(() => window.planish.store.dispatch({ type: 'stroke-time', time: 0.44 }));
  const lowest = await state(
    page,
    `(() => { const p = views.folded.sheet.skin.geometry.getAttribute('position'); let low = Infinity;
      for (let i = 0; i < p.count; ++i) low = Math.min(low, p.getZ(i)); return low; })()`,
  );
  assert.ok(Math.abs(lowest) < 0.01, `the sheet lies on the die, not ${lowest} mm above it`);
  await page.click('[data-testid=stroke-play]');
  await page.waitForFunction(() => window.planish.store.state.order.time > 0.7);
  await page.click('[data-testid=stroke-play]');
  assert.equal(await state(page, 's.order.playing'), false);
  await page.screenshot({ path: `${folder(page)}/stroke.png` });
  await page.click('[data-testid=tab-bends]');
  assert.equal(await state(page, 'views.folded.machine.group.visible'), false);
  await page.waitForSelector('[data-testid=fold-slider]');
  assert.match(await described(page, 'folded'), /^Picked: B\d up \d+°/);
  assert.match(await described(page, 'flat'), /^Bends: B1 up 90°, B2 up 60°\. Picked: B\d/);
  await page.click('[data-testid=tab-order]');
  await page.fill('[data-testid=springback]', '2');
  await page.keyboard.press('Enter');
  await page.waitForSelector('[data-testid=order-old]'); // of other options
  await plan(page);
  assert.equal(await page.locator('[data-testid=order-old]').count(), 0);
  // the wanted V alone: both strokes go over it
  await page.click('[data-testid=ways-to-bend] summary');
  await page.fill('[data-testid=opening]', '16');
  await page.keyboard.press('Enter');
  await page.selectOption('[data-testid=v]', 'wanted');
  for (const [field, chosen] of [
    ['as-drawn', 'made'],
    ['large-radii', 'bump'],
    ['gauge-openings', 'openings'],
  ])
    await page.selectOption(`[data-testid=${field}]`, chosen);
  await plan(page);
  assert.deepEqual(await state(page, 's.order.brake'), {
    ...(await state(page, 's.order.ofBrake')),
    opening: 16,
    v: 'wanted',
    large_radii: 'bump',
    gauge_openings: true,
  });
  for (const stroke of await state(page, 's.order.answer.strokes')) assert.match(stroke.die, /^V16-/);
}

/** A stroke is dragged, and moved by keys: what collides is red in the list and in the picture. */
export async function reorder({ page }) {
  await open(page, [channel(page)]);
  await rested(page);
  await plan(page);
  const [first, second] = await strokeNames(page);
  assert.equal(await page.locator('.strokes li.blocked').count(), 0);
  await page.dragAndDrop('[data-testid=stroke-1]', '[data-testid=stroke-2]', { targetPosition: { x: 60, y: 30 } });
  await page.waitForFunction(() => window.planish.store.state.order.given);
  await checked(page);
  assert.deepEqual(await strokeNames(page), [second, first]);
  await page.waitForSelector('[data-testid=order-status]:has-text("1 of 2 strokes cannot be made")');
  assert.equal(await page.getAttribute('[data-testid=stroke-2]', 'class').then((c) => c.includes('blocked')), true);
  await page.click('[data-testid=stroke-2]');
  const blocked = await state(page, 's.order.answer.strokes[1].blocked');
  assert.equal(await toolIsRed(page, blocked.tool), true, 'the tool that is hit is red');
  const [tint, red] = await state(
    page,
    `(() => { const { sheet } = views.folded, row = s.shape.parts.findIndex((p) => p.name === '${blocked.with}'),
        tint = sheet.skin.geometry.getAttribute('tint'),
        c = [...sheet.mesh.cornerFacet].findIndex((f) => s.shape.facet_part[f] === row),
        hit = views.folded.machine.materials[${JSON.stringify(blocked.tool)}].color;
      return [[tint.getX(c), tint.getY(c), tint.getZ(c)], hit.toArray()]; })()`,
  );
  tint.forEach((v, i) => assert.ok(Math.abs(v - red[i]) < 1e-6, 'the flange that collides is red'));
  const told = () => described(page, 'folded');
  // The words follow the picture.
  const [bend] = await state(page, 's.order.answer.strokes[1].bends');
  await page.waitForFunction((begin) => {
    const canvas = document.querySelector('.folded .canvas');
    return document.getElementById(canvas.getAttribute('aria-describedby')).textContent.startsWith(begin);
  }, `Stroke 2 of 2: bend ${bend} to 90°, bent by `);
  const said = await told();
  assert.match(said, /It collides: .*punch/);
  await page.screenshot({ path: `${folder(page)}/collision.png` });
  // back again by the keyboard
  await page.focus('[data-testid=stroke-2]');
  await page.keyboard.press('Alt+ArrowUp');
  await page.waitForFunction(() => window.planish.store.state.order.asked === null);
  await checked(page);
  assert.deepEqual(await strokeNames(page), [first, second]);
  assert.equal(await page.locator('.strokes li.blocked').count(), 0);
  await page.waitForFunction((name) => document.activeElement?.dataset.stroke === name, first);
  assert.equal(await toolIsRed(page, blocked.tool), false);
  assert.doesNotMatch(await told(), /collides|cannot/);
  // Orders are undone like all else, and before the edits that came before them.
  await page.keyboard.press('Control+z');
  assert.deepEqual(await strokeNames(page), [second, first]);
  assert.equal(await toolIsRed(page, blocked.tool), true);
  await page.keyboard.press('Control+z');
  assert.deepEqual(await strokeNames(page), [first, second]);
  assert.equal(await state(page, 's.order.given'), false, 'the cheapest one');
  assert.equal(await page.isDisabled('[data-testid=undo]'), true);
  await page.click('[data-testid=redo]');
  await drawn(page);
  assert.deepEqual(await strokeNames(page), [second, first]);
}

/** What cannot be planned is said, and a tools file that is none. */
export async function unplanned({ page }) {
  await example(page, 'bracket.step');
  const path = `${folder(page)}/tools.json`;
  writeFileSync(path, JSON.stringify({ format: 'planish/tools', version: 1 }));
  await page.click('[data-testid=tab-order]');
  await page.setInputFiles('[data-testid=tools-file]', path);
  await page.waitForFunction(() => window.planish.store.state.order.brake.tools);
  await page.click('[data-testid=plan]');
  await page.waitForSelector('[data-testid=order-problem]');
  assert.equal(await state(page, 's.shape.facet_parent.length > 0'), true, 'the part is still there');
  await page.click('[data-testid=tools-clear]');
  await plan(page);
  assert.equal(await page.locator('[data-testid=order-problem]').count(), 0);
}

/** After a reload the order that was asked for is there, and undo takes it back, also from before an edit. */
export async function orderkept({ page }) {
  await open(page, [channel(page)]);
  await rested(page);
  await plan(page);
  const [first, second] = await strokeNames(page);
  await page.click('[data-testid=later-1]');
  await page.waitForFunction(() => window.planish.store.state.order.given);
  await checked(page);
  /** The list follows what the server has checked, which takes a moment. */
  const are = async (wanted) => {
    const end = performance.now() + 10000;
    while (`${await strokeNames(page)}` !== `${wanted}` && performance.now() < end)
      await new Promise((resolve) => setTimeout(resolve, 50));
    assert.deepEqual(await strokeNames(page), wanted);
  };
  const again = async () => {
    await serveDist(page, address);
    await page.reload();
    await page.waitForFunction(() => window.planish?.store.state.shape);
    await page.unrouteAll();
    await rested(page);
    await page.click('[data-testid=tab-order]');
    await drawn(page);
  };
  await again();
  await are([second, first]);
  assert.equal(await page.locator('[data-testid=order-old]').count(), 0);
  assert.equal(await state(page, 'views.folded.machine.group.visible'), true, 'the sheet is in the machine');
  assert.equal(await page.isDisabled('[data-testid=undo]'), false);
  await page.click('[data-testid=undo]');
  await are([first, second]);
  assert.equal(await state(page, 's.order.given'), false, 'the cheapest one');
  assert.equal(await page.isDisabled('[data-testid=undo]'), true);
  await again();
  await page.click('[data-testid=redo]');
  await are([second, first]);
  // An edit after it is taken back first.
  await page.click('[data-testid=tab-input]');
  await page.click('[data-testid=density-steel]');
  await rested(page);
  await again();
  await page.waitForSelector('[data-testid=order-old]');
  await page.click('[data-testid=undo]');
  await rested(page);
  await are([second, first]);
  assert.equal(await page.locator('[data-testid=order-old]').count(), 0);
  await page.click('[data-testid=undo]');
  await are([first, second]);
  // It is worked on as before.
  await page.click('[data-testid=later-1]');
  await page.waitForFunction(() => window.planish.store.state.order.given);
  await checked(page);
  await are([second, first]);
  // Another file has nothing of it.
  await example(page, 'bracket.step');
  await again();
  assert.equal(await state(page, 's.order.answer'), null);
}
