import assert from 'node:assert/strict';
import { untilDrawn } from '../drawn.mjs';
import { example, state } from '../driving.mjs';

const lit = (page) =>
  state(page, `[views.flat.hovered, views.folded.hovered, views.folded.sheet.skin.material.uniforms.lit.value]`);

/** What lies under the pointer in one view lights up in both, without being picked, and without new geometry. */
export async function hover({ page }) {
  await example(page, 'bracket.step');
  const [line, bend, flange, row] = await state(
    page,
    `(() => { const l = s.shape.bend_lines, flange = s.shape.parts.findIndex((p) => p.name === 'F2');
    return [views.flat.project([(l[0] + l[2]) / 2, (l[1] + l[3]) / 2]), s.shape.bend_line_part[0],
      views.flat.project([...views.flat.places.get(flange).at]), flange]; })()`,
  );
  const before = await state(page, 'views.folded.sheet.version');
  await page.mouse.move(line.x, line.y);
  await page.waitForFunction((part) => window.planish.views.folded.hovered?.part === part, bend);
  assert.deepEqual(await lit(page), [{ part: bend }, { part: bend }, bend]);
  await untilDrawn(page, 'flat-overlay', 100);
  await page.mouse.move(flange.x, flange.y);
  await page.waitForFunction((part) => window.planish.views.folded.hovered?.part === part, row);
  // A rim in the folded view, from above.
  await page.click('[data-testid=view-top]');
  await page.waitForTimeout(200);
  const [edge, at] = await state(
    page,
    `(() => { const top = views.folded.sheet.lines().filter((l) => 'edge' in l.line)
      .reduce((a, b) => (a.ends[0][2] + a.ends[1][2] > b.ends[0][2] + b.ends[1][2] ? a : b));
    return [top.line.edge, views.folded.project(top.ends[0].map((v, k) => (v + top.ends[1][k]) / 2))]; })()`,
  );
  await page.mouse.move(at.x, at.y);
  await page.waitForFunction(() => 'edge' in (window.planish.views.flat.hovered ?? {}));
  const [flat, folded, part] = await lit(page);
  assert.equal(flat.edge, folded.edge);
  assert.equal(part, -1, 'of an edge the flange is not lit');
  assert.ok(edge >= 0);
  await untilDrawn(page, 'flat-overlay', 20);
  await untilDrawn(page, 'folded-overlay', 20);
  await page.mouse.move(600, 20);
  await page.waitForFunction(() => window.planish.views.flat.hovered === null);
  await untilDrawn(page, 'folded-overlay', 0);
  assert.equal(await state(page, 'views.folded.sheet.version'), before, 'no geometry was made');
  assert.deepEqual(await state(page, '[s.selection.part, s.selection.edge]'), [null, null]);
}
