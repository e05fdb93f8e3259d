import assert from 'node:assert/strict';
import { example, folder, open, state } from '../driving.mjs';

/** Of some colours, the one that the flat view has within two pixels of a place in the pattern, or nearly has. */
const colourAt = (page, [x, y], names) =>
  page.evaluate(
    ({ x, y, names }) => {
      const { flat } = window.planish.views,
        canvas = document.querySelector('[data-testid=flat-canvas]'),
        box = canvas.getBoundingClientRect(),
        at = flat.project([x, y]),
        ratio = window.devicePixelRatio,
        c = canvas.getContext('2d'),
        probe = document.createElement('canvas').getContext('2d');
      const rgb = (name) => {
        probe.fillStyle = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
        return probe.fillStyle.match(/[0-9a-f]{2}/g).map((v) => parseInt(v, 16));
      };
      const around = c.getImageData((at.x - box.left) * ratio - 2, (at.y - box.top) * ratio - 2, 5, 5).data;
      let best = { name: null, off: Infinity };
      for (const name of names)
        for (let i = 0; i < around.length; i += 4) {
          const wanted = rgb(name),
            off = Math.hypot(...wanted.map((v, k) => v - around[i + k]));
          if (off < best.off) best = { name, off };
        }
      return best.name;
    },
    { x, y, names },
  );

/** Outlines of formed features are green, as in the SVG; the legend and the sentences say that they are no cuts. */
export async function forms({ page }) {
  await open(page, [`${folder(page)}/../pressed.step`]);
  const circles = await state(
    page,
    `(() => { const c = s.shape.edge_circle; return [...s.shape.edge_feature].map((feature, n) =>
      ({ n, feature, x: c[4 * n], y: c[4 * n + 1], r: c[4 * n + 2] })).filter(({ r }) => r > 0); })()`,
  );
  const [hole, sunk, knob] = [2.5, 5, 10].map((r) => circles.find((c) => Math.abs(c.r - r) < 1e-3));
  for (const theme of ['light', 'dark']) {
    assert.equal(await state(page, 's.theme'), theme);
    await page.waitForTimeout(200);
    for (const [{ x, y, r }, wanted] of [
      [hole, '--outline'],
      [sunk, '--form'],
      [knob, '--form'],
    ]) {
      const a = 0.4; // away from where circles begin
      assert.equal(
        await colourAt(page, [x + r * Math.cos(a), y + r * Math.sin(a)], ['--form', '--outline']),
        wanted,
        `Ø ${2 * r}, ${theme}`,
      );
    }
    await page.screenshot({ path: `${folder(page)}/${theme}.png` });
    await page.click('[data-testid=theme]');
  }
  assert.equal(
    await page.getAttribute('[data-testid=legend-feature]', 'title'),
    'Drawn, not cut: 1 countersink, 1 formed feature',
  );
  assert.deepEqual(await page.$$eval('[data-testid=legend] li', (all) => all.map((e) => e.textContent.trim())), [
    'cut',
    'feature',
  ]);
  // The picked one says so, and so does what lies under the pointer.
  const at = await state(page, `views.flat.project([${sunk.x} + 5 * Math.cos(0.4), ${sunk.y} + 5 * Math.sin(0.4)])`);
  const sentence = 'Circle of a countersink in F1, Ø 10 mm, 31.42 mm long in the flat pattern. Drawn, not cut.';
  await page.mouse.move(at.x, at.y);
  await page.waitForFunction((t) => document.querySelector('[data-testid=flat-canvas]').title === t, sentence);
  await page.mouse.click(at.x, at.y);
  await page.waitForSelector(`[data-testid=message]:has-text("${sentence}")`);
  const cut = await state(
    page,
    `views.flat.project([${hole.x} + 2.5 * Math.cos(0.4), ${hole.y} + 2.5 * Math.sin(0.4)])`,
  );
  await page.mouse.click(cut.x, cut.y);
  await page.waitForSelector('[data-testid=message]:has-text("Circle of F1, Ø 5 mm, 15.71 mm long")');
  assert.doesNotMatch(await page.textContent('[data-testid=message]'), /not cut/);
  // In the folded view only what is cut has a wall: three circles of the knob and the countersink have none.
  const walls = await state(page, `[views.folded.sheet.mesh.cuts.length, views.folded.sheet.mesh.forms.length]`);
  assert.ok(walls.every((count) => count > 0));
  const perEdge = await state(page, `s.shape.edge_number.length`);
  assert.equal((walls[0] + walls[1]) / 2, perEdge);
  // What has no such features has no such line in its legend.
  await example(page, 'bracket.step');
  assert.deepEqual(await page.$$eval('[data-testid=legend] li', (all) => all.map((e) => e.textContent.trim())), [
    'cut',
    'bend up',
  ]);
}
