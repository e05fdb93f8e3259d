import assert from 'node:assert/strict';
import { download, example, rested, state } from '../driving.mjs';

// Where the largest triangle of a part is seen in the folded view.
const middleOfPart = `(() => {
  const { mesh, skin } = views.folded.sheet, p = skin.geometry.getAttribute('position');
  const at = (c) => [p.getX(c), p.getY(c), p.getZ(c)];
  const corners = (t) => [0, 1, 2].map((k) => at(mesh.triangles[3 * t + k]));
  const size = ([a, b, c]) => { const u = b.map((v, k) => v - a[k]), w = c.map((v, k) => v - a[k]);
    return Math.hypot(u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]); };
  const own = [...mesh.triangleFacet.keys()].filter((t) => s.shape.facet_part[mesh.triangleFacet[t]] === row)
    .map(corners).sort((x, y) => size(y) - size(x))[0];
  return views.folded.project([0, 1, 2].map((k) => (own[0][k] + own[1][k] + own[2][k]) / 3)); })()`;

export async function unfold({ page }) {
  await example(page, 'bracket.step');
  const before = await page.textContent('[data-testid=blank-size]');
  await page.click('[data-testid=tab-bends]');
  await page.fill('[data-testid=bend-k-B1]', '0.3');
  await page.keyboard.press('Enter');
  await rested(page);
  assert.notEqual(await page.textContent('[data-testid=blank-size]'), before, 'the blank follows K');
  await page.click('[data-testid=bend-B2]');
  assert.equal(await state(page, 's.selection.part'), 'B2');
  await page.click('[data-testid=undo]');
  await rested(page);
  assert.equal(await page.textContent('[data-testid=blank-size]'), before, 'undo brings it back');
  await page.click('[data-testid=tab-input]');
  await page.click('[data-testid=pick-root]');
  const [face, at] = await state(
    page,
    `(() => { const row = s.shape.parts.findIndex((p) => p.name === 'F2');
    return [s.shape.parts[row].faces[0], ${middleOfPart}]; })()`,
  );
  await page.mouse.click(at.x, at.y);
  await rested(page);
  assert.equal(await state(page, 's.input.options.root'), face, 'the flange that was clicked stays where it is');
  await page.click('[data-testid=tab-certificate]');
  assert.match(await page.textContent('[data-testid=certificate]'), /Volume agrees to/);
  await page.keyboard.press('Escape');
  await page.keyboard.press(' ');
  await page.waitForTimeout(1500);
  assert.equal(await state(page, 's.fold'), 0);
  return download(page, 'dxf');
}

/** What is picked in one view is marked in the other and in the bend table. */
export async function edges({ page }) {
  await example(page, 'bracket.step');
  await page.click('[data-testid=tab-bends]');
  const ofB1 = `[...s.shape.edge_facet.keys()]
    .find((e) => s.shape.parts[s.shape.facet_part[s.shape.edge_facet[e]]].name === 'B1')`;
  const [edge, inFlat] = await state(
    page,
    `(() => {
    const i = ${ofB1}, e = s.shape.edges;
    const middle = [(e[4 * i] + e[4 * i + 2]) / 2, (e[4 * i + 1] + e[4 * i + 3]) / 2];
    return [s.shape.edge_number[i], views.flat.project(middle)]; })()`,
  );
  await page.mouse.click(inFlat.x, inFlat.y);
  assert.equal(await state(page, 's.selection.edge'), edge);
  await page.waitForSelector('[data-testid=message]:has-text("Edge of B1, 5.31 mm long")'); // the developed length
  assert.ok(await state(page, 'views.folded.sheet.marked.visible'), 'it is marked in the folded view');
  await page.waitForSelector('[data-testid=bend-B1].selected');
  await page.keyboard.press('Escape');
  assert.equal(await state(page, 'views.folded.sheet.marked.visible'), false);
  // In the folded view: a hole's rim, which is seen from above.
  await page.click('[data-testid=view-top]');
  await page.waitForTimeout(200);
  const [rim, inSpace] = await state(
    page,
    `(() => {
    const lines = views.folded.sheet.lines().filter((l) => 'edge' in l.line);
    const of = (n) => lines.filter((l) => l.line.edge === n);
    const within = (p) => p[0] > 10 && p[0] < 45 && p[1] > 10 && p[1] < 45;
    const slot = [...new Set(lines.map((l) => l.line.edge))].map(of)
      .filter((l) => l.every((x) => x.ends.every(within))).sort((a, b) => b.length - a.length)[0];
    const top = slot.reduce((a, b) => (a.ends[0][2] > b.ends[0][2] ? a : b));
    return [top.line.edge, views.folded.project(top.ends[0].map((v, k) => (v + top.ends[1][k]) / 2))]; })()`,
  );
  await page.mouse.click(inSpace.x, inSpace.y);
  assert.equal(await state(page, 's.selection.edge'), rim);
  await page.waitForSelector('[data-testid=bend-B1].beside'); // the bends of its flange are marked, more weakly
  // A flange in the flat pattern.
  const label = await state(page, `views.flat.project([...(views.flat.places.get(0)?.at ?? [0, 0])])`);
  await page.mouse.click(label.x, label.y);
  assert.equal(await state(page, 's.selection.part'), await state(page, 's.shape.parts[0].name'));
}

export async function picks({ page }) {
  await example(page, 'bracket.step');
  await page.click('[data-testid=pick-root]');
  const [face, at] = await state(
    page,
    `(() => { const row = s.shape.parts.findIndex((p) => p.name === 'F3');
    return [s.shape.parts[row].faces[0], views.flat.project(views.flat.places.get(row).at)]; })()`,
  );
  await page.mouse.click(at.x, at.y);
  await rested(page);
  assert.equal(await state(page, 's.input.options.root'), face, 'a root is picked in the flat pattern too');
  assert.equal(await page.$eval('[data-testid=root]', (e) => e.selectedOptions[0].textContent), 'F3', 'and named');
  await page.selectOption('[data-testid=root]', { label: 'F2' });
  await rested(page);
  assert.equal(await state(page, `s.shape.parts.find((p) => p.name === 'F2').faces[0] === s.input.options.root`), true);
  await page.selectOption('[data-testid=root]', 'largest');
  await rested(page);
  assert.equal(await state(page, 's.input.options.root'), undefined);
}
