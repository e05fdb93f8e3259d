import assert from 'node:assert/strict';
import { inTheme, violations } from '../axe.mjs';
import { channel } from '../channel.mjs';
import { collide, plan } from '../ordering.mjs';
import { example, folder, open, state } from '../driving.mjs';

// Small windows: 1280 × 720 at 150 % and at 200 %, and what is low only.
const sizes = [
  [853, 480],
  [640, 360],
  [1280, 360],
];

/** Evaluated in the page: what cannot be reached by mouse, what lies over another thing, what was pushed away. */
function hidden() {
  const said = [],
    page = document.scrollingElement,
    name = (e) =>
      e.dataset.testid ?? `${e.tagName.toLowerCase()} ${e.className} “${e.textContent.trim().slice(0, 20)}”`;
  if (page.scrollWidth > page.clientWidth) {
    const out = [...document.querySelectorAll('body *')].filter(
      (e) => e.getBoundingClientRect().right > page.clientWidth,
    );
    said.push(`the page is ${page.scrollWidth} px wide, by ${out.map(name)}`);
  }
  for (const e of document.querySelectorAll('body *'))
    if ((e.scrollTop || e.scrollLeft) && getComputedStyle(e).overflowY === 'hidden')
      said.push(`${name(e)} is pushed away`);
  const shown = [...document.querySelectorAll('button, input, summary, select, [role=separator]')].filter(
    (e) =>
      e.checkVisibility() && !e.closest('[inert], dialog, .cube, .menu .list, .moves') && !e.matches('.away, [hidden]'),
  );
  for (const e of shown) {
    e.scrollIntoView({ block: 'center', inline: 'nearest' });
    const { x, y, width, height } = e.getBoundingClientRect(),
      there = document.elementFromPoint(x + width / 2, y + height / 2);
    if (!there || !(e.contains(there) || e.closest('label')?.contains(there)))
      said.push(`${name(e)} lies under ${there ? name(there) : 'the edge'}`);
  }
  // What is said in the views: each wholly within its view, apart from buttons and from the cube.
  const boxes = (selector) =>
      [...document.querySelectorAll(selector)].filter((e) => e.checkVisibility() && e.getClientRects().length),
    said1 = boxes('.machine li, .machine p, .machine summary'),
    others = boxes('.buttons button, .tools button, .cube canvas, .fold button, .fold input, .fold output');
  for (const e of said1) {
    const box = e.closest('.machine');
    e.scrollIntoView({ block: 'nearest' });
    const p = e.getBoundingClientRect(),
      frame = box.getBoundingClientRect();
    if (p.bottom > frame.bottom + 1 || p.right > frame.right + 1) said.push(`${name(e)} is cut off`);
    for (const o of others) {
      const q = o.getBoundingClientRect(),
        apart =
          Math.min(p.right, q.right) - Math.max(p.left, q.left) < 1 ||
          Math.min(frame.bottom, q.bottom) - Math.max(frame.top, q.top) < 1;
      if (!apart) said.push(`${name(e)} lies over ${name(o)}`);
    }
  }
  page.scrollTop = 0;
  return said;
}

/** The page in small windows, in one state of it: all can be reached, nothing lies over another thing. */
async function everywhere(page, what) {
  const wrong = [];
  for (const [width, height] of sizes) {
    await page.setViewportSize({ width, height });
    const isOpen = await state(page, 's.document !== null');
    for (const arrangement of isOpen ? ['beside', 'stacked'] : ['beside'])
      for (const split of isOpen ? [0, 0.5, 1] : [0.5]) {
        await page.evaluate((view) => window.planish.store.dispatch({ type: 'view', view }), { arrangement, split });
        await page.waitForTimeout(250);
        const at = `${what}, ${width} × ${height}, ${arrangement}, ${split}`;
        for (const line of await page.evaluate(hidden)) wrong.push(`${at}: ${line}`);
        if (split === 0.5)
          for (const theme of ['dark', 'light']) {
            await inTheme(page, theme);
            for (const line of await violations(page)) wrong.push(`${at}, ${theme}: ${line}`);
            const path = `${folder(page)}/${what}-${width}-${arrangement}-${theme}.png`;
            await page.screenshot({ path, fullPage: true });
          }
        const least = await page.$eval('main', (e) => e.clientHeight);
        if (width < 1000 && least < 300) wrong.push(`${at}: the views are ${least} px high`);
      }
  }
  return wrong;
}

export async function small({ page }) {
  await page.waitForFunction(() => [...document.querySelectorAll('.tile img')].length > 3);
  const wrong = await everywhere(page, 'start');
  await page.setViewportSize({ width: 640, height: 360 });
  await example(page, 'bracket.step');
  for (const tab of ['input', 'bends', 'findings', 'certificate']) {
    await page.click(`[data-testid=tab-${tab}]`);
    if (tab === 'input' || tab === 'bends') wrong.push(...(await everywhere(page, tab)));
  }
  // Tab goes through all of it, and the wheel leads back.
  await page.setViewportSize({ width: 640, height: 360 });
  await page.evaluate(() => document.activeElement?.blur());
  const seen = new Set();
  for (let i = 0; i < 80; ++i) {
    await page.keyboard.press('Tab');
    const at = await page.evaluate(() => {
      const e = document.activeElement,
        r = e.getBoundingClientRect();
      const isSeen = r.bottom > 0 && r.top < innerHeight && r.left >= -1 && r.right <= innerWidth + 1;
      return { name: e.dataset.testid ?? e.className, isSeen: isSeen || e === document.body };
    });
    seen.add(at.name);
    if (!at.isSeen) wrong.push(`the focus on ${at.name} is not seen`);
  }
  for (const one of ['start-page', 'download-menu', 'divider', 'tab-certificate']) assert.ok(seen.has(one), one);
  await page.mouse.move(320, 350);
  await page.mouse.wheel(0, 3000);
  await page.waitForTimeout(200);
  await page.mouse.wheel(0, -5000);
  await page.waitForTimeout(300);
  assert.equal(await page.evaluate(() => scrollY + scrollX), 0);
  // A menu is within the window; a bend that is picked in the view does not scroll the page.
  for (const menu of ['examples-menu', 'download-menu']) {
    await page.click(`[data-testid=${menu}]`);
    const { x, y, width, height } = await page.locator('details[open] .list').boundingBox();
    if (x < 0 || x + width > 640 || y + height > 360) wrong.push(`${menu}: ${JSON.stringify({ x, y, width, height })}`);
    await page.screenshot({ path: `${folder(page)}/${menu}.png` });
    await page.keyboard.press('Escape');
  }
  await page.click('[data-testid=help]');
  await page.waitForSelector('dialog[open]');
  wrong.push(...(await violations(page)).map((line) => `help: ${line}`));
  await page.screenshot({ path: `${folder(page)}/help.png` });
  await page.click('[data-testid=shortcuts-close]');
  await page.click('[data-testid=tab-bends]');
  await page.evaluate(() => scrollTo(0, 0));
  await page.evaluate(() => window.planish.store.dispatch({ type: 'select', selection: { part: 'B2' } }));
  await page.waitForTimeout(200);
  assert.equal(await page.evaluate(() => scrollY), 0);
  assert.ok(!wrong.length, [...new Set(wrong)].join('\n'));
}

/** The bend order in small windows: what is said of a stroke has a place of its own. */
export async function smallmachine({ page }) {
  await open(page, [channel(page)]);
  await plan(page);
  const wrong = await everywhere(page, 'machine');
  await page.setViewportSize({ width: 1280, height: 720 });
  await collide(page);
  wrong.push(...(await everywhere(page, 'collision')));
  // The tools are folded away where it is narrow, and can be seen.
  await page.setViewportSize({ width: 640, height: 360 });
  await page.evaluate(() =>
    window.planish.store.dispatch({ type: 'view', view: { arrangement: 'beside', split: 0.5 } }),
  );
  await page.waitForSelector('[data-testid=machine-legend]', { state: 'hidden' });
  await page.click('[data-testid=machine-tools] summary');
  await page.waitForSelector('[data-testid=machine-legend]', { state: 'visible' });
  await page.screenshot({ path: `${folder(page)}/tools.png` });
  wrong.push(...(await page.evaluate(hidden)));
  await page.setViewportSize({ width: 1280, height: 720 });
  await page.waitForSelector('[data-testid=machine-legend]', { state: 'visible' });
  await page.dblclick('[data-testid=divider]');
  await page.waitForTimeout(500); // until that is kept
  assert.ok(!wrong.length, [...new Set(wrong)].join('\n'));
}
