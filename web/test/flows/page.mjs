import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { coarse, download, drag, enter, example, folder, fresh, open, opened, rested, state } from '../driving.mjs';
import { walls } from '../walls.mjs';

/** Evaluated in the page: what is cut off, or covers its neighbour, outside of the views. */
function untidy() {
  const said = [],
    text = (e) => (e.value ?? e.textContent).trim().slice(0, 30),
    name = (e) => `${e.tagName.toLowerCase()} ${e.dataset.testid ?? e.className} “${text(e)}”`;
  const shown = [...document.querySelectorAll('header *, .messages *, .fold *, .buttons *, aside *')].filter(
    (e) => e.getClientRects().length && !(e instanceof SVGElement),
  );
  for (const e of shown) {
    const r = e.getBoundingClientRect(),
      area = e.closest('header, .messages, .fold, .buttons, aside').getBoundingClientRect();
    if (r.left < area.left - 1 || r.right > area.right + 1) said.push(`${name(e)} leaves its area`);
    if (
      e.matches('button, dt, dd, td, th, input[type=text], h2, h3, summary, label > span') &&
      e.scrollWidth > e.clientWidth + 1 &&
      e.clientWidth > 0
    )
      said.push(`${name(e)} is cut off`);
  }
  for (const row of document.querySelectorAll(
    'header, .messages, .fold, .buttons, .summary, .tabs, .field, .slider, .double, .triple, ' +
      '.row, .chips, .named, .new-plate, .point, .head',
  )) {
    const boxes = [...row.children].map((e) => [e, e.getBoundingClientRect()]).filter(([, r]) => r.width && r.height);
    for (const [i, [a, p]] of boxes.entries())
      for (const [b, q] of boxes.slice(i + 1))
        if (p.left < q.right - 1 && q.left < p.right - 1 && p.top < q.bottom - 1 && q.top < p.bottom - 1)
          said.push(`${name(a)} covers ${name(b)}`);
  }
  return said;
}

export async function inch({ page }) {
  const file = `${folder(page)}/inch.step`,
    text = readFileSync(new URL('../../../examples/bracket.step', import.meta.url), 'utf8');
  writeFileSync(
    file,
    text
      .replace(
        '( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )',
        `( CONVERSION_BASED_UNIT('INCH',#9001) LENGTH_UNIT() NAMED_UNIT(#9003) )`,
      )
      .replace(
        'DATA;',
        'DATA;\n#9001 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#9002);\n' +
          '#9002 = ( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) );\n' +
          '#9003 = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);',
      ),
  );
  await open(page, [file]);
  assert.equal(await state(page, 's.units'), 'inch', 'the page speaks the unit of the part');
  console.log(`   blank ${await page.textContent('[data-testid=blank-size]')} of ${file}`);
  const noneLeft = async () => {
    for (const tab of ['input', 'bends', 'certificate']) {
      await page.click(`[data-testid=tab-${tab}]`);
      assert.doesNotMatch(
        await page.evaluate(() => document.querySelector('aside').innerText),
        /\bmm\b/,
        `${await state(page, 's.document.name')}, ${tab}`,
      );
    }
    await page.click('[data-testid=tab-input]');
  };
  await noneLeft();
  for (const name of ['connect/a_folded.json', 'transition/a_square_to_round.json', 'chair.json']) {
    if (name === 'chair.json') await open(page, [coarse(page, name)]);
    else await example(page, name);
    assert.equal(await state(page, 's.units'), 'mm');
    await page.click('[data-testid=units-inch]');
    await noneLeft();
    await enter(page, 'thickness', '0.125');
    await rested(page);
    assert.equal(await state(page, 's.input.spec.thickness'), 3.175, name);
    assert.equal(await page.textContent('[data-testid=sheet-thickness]'), '0.125');
  }
  const plates = JSON.parse(
    readFileSync(new URL('../../../examples/connect/d_irregular.json', import.meta.url), 'utf8'),
  );
  writeFileSync(`${folder(page)}/inch.json`, JSON.stringify({ ...plates, units: 'inch' }));
  await open(page, [`${folder(page)}/inch.json`]);
  assert.equal(await state(page, 's.units'), 'inch');
  assert.equal(await page.inputValue('[data-testid=thickness]'), String(plates.thickness));
}

// A file let fall on the window; its pattern covers itself.
export async function drop({ page }) {
  await page.evaluate((text) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], 'walls.json', { type: 'application/json' }));
    for (const type of ['dragover', 'drop'])
      document.body.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
  }, walls);
  await opened(page, 'walls.json');
  await page.waitForSelector('.message.error:has-text("overlap by")');
  for (const theme of ['light', 'dark']) {
    assert.equal(await state(page, 's.theme'), theme);
    await page.waitForTimeout(200);
    const { red, inside, outside } = await page.evaluate(() => {
      const s = window.planish.store.state,
        { flat } = window.planish.views,
        o = s.shape.overlaps,
        canvas = document.querySelector('[data-testid=flat-canvas]');
      const pixel = (at) => {
        const p = flat.project(at),
          r = canvas.getBoundingClientRect();
        return [
          ...canvas.getContext('2d').getImageData(Math.round(p.x - r.left), Math.round(p.y - r.top), 1, 1).data,
        ].slice(0, 3);
      };
      const [, red, alpha] = getComputedStyle(document.documentElement)
        .getPropertyValue('--overlap')
        .match(/(\d+), .*, ([\d.]+)\)/)
        .map(Number);
      return {
        red: { red, alpha },
        inside: pixel([0, 1].map((k) => (o[k] + o[2 + k] + o[4 + k]) / 3)),
        outside: pixel([10, 10]),
      };
    });
    const shown = Math.round(red.alpha * red.red + (1 - red.alpha) * outside[0]);
    assert.ok(
      Math.abs(inside[0] - shown) < 10 && inside[0] > inside[1] + 90,
      `${theme}: ${inside} is not the red of overlaps`,
    );
    await page.click('[data-testid=theme]');
  }
  // What the sentence offers is there: the files are written all the same, until it is taken back.
  assert.match(await page.textContent('[data-testid=message]'), /Set “write overlapping” to write the pattern anyway/);
  await page.click('[data-testid=remedy-write_overlapping-true]');
  await rested(page);
  assert.deepEqual(await state(page, '[s.problem, s.shape.report.status]'), [null, 'warning']);
  await download(page, 'dxf');
  await page.click('[data-testid=undo]');
  await rested(page);
  assert.equal(await state(page, 's.problem.code'), 'overlap');
}

// By a drag and by a number: the sentence is shown, the last shape stays, greyed, and so does the handle.
export async function invalid({ page }) {
  await example(page, 'connect/a_folded.json');
  const parts = await state(page, 's.shape.parts.length'),
    greyed = async (wanted) => {
      await page.waitForFunction((w) => {
        const s = window.planish.store.state;
        return s.stale === w && !s.computing;
      }, wanted);
      await page.waitForTimeout(100);
      assert.equal(
        await page.evaluate(() => getComputedStyle(document.querySelector('[data-testid=folded-canvas]')).opacity),
        wanted ? '0.4' : '1',
      );
      assert.equal(await state(page, 's.shape.parts.length'), parts);
      if (wanted) assert.match(await page.textContent('.message.error'), /\[\w+\]/);
    };
  await page.click('[data-testid=plate-left]');
  await enter(page, 'plate-x', '94');
  await rested(page);
  // By the arrow down through the floor.
  const arrow = await state(
    page,
    `(() => {
    const c = s.shape.handles.plates.find((p) => p.id === 'left').corners;
    const m = [0, 1, 2].map((k) => c.reduce((t, p) => t + p[k], 0) / c.length);
    const { camera, gizmo } = views.folded, r = 0.4 * (camera.top - camera.bottom) / camera.zoom * gizmo.size / 4;
    const at = (z) => views.folded.project([m[0], m[1], m[2] + z]);
    return { from: at(r), to: at(r - 40) }; })()`,
  );
  await drag(page, arrow.from, { x: arrow.to.x - arrow.from.x, y: arrow.to.y - arrow.from.y }, 10);
  await greyed(true);
  assert.match(await page.textContent('[data-testid=message]'), /pass through each other/);
  assert.ok(
    await state(page, `s.shape.handles.plates.find((p) => p.id === 'left').corners.some((c) => c[2] < 0)`),
    'the handle is where the plate is',
  );
  await page.keyboard.press('Control+z');
  await greyed(false);
  await enter(page, 'thickness', '90');
  await greyed(true);
  await enter(page, 'thickness', 'four');
  assert.equal(await page.inputValue('[data-testid=thickness]'), '90', 'what is no number is put back');
  await enter(page, 'thickness', '4');
  await greyed(false);
}

// What takes long is given up, and nothing jumps meanwhile.
export async function long({ page }) {
  await example(page, 'slit/chair.json');
  const boxes = () =>
    page.evaluate(() =>
      Object.fromEntries(
        [
          'header',
          '.messages',
          '.folded',
          '.flat',
          'aside',
          '.tabs',
          '.content',
          '.fold',
          '[data-testid=undo]',
          '[data-testid=download-menu]',
        ].map((q) => {
          const r = document.querySelector(q).getBoundingClientRect();
          return [q, [r.x, r.y, r.width, r.height]];
        }),
      ),
    );
  const first = await boxes(),
    same = async (when) => assert.deepEqual(await boxes(), first, `something moved: ${when}`);
  await page.click('[data-testid=curve-seat-1]');
  await same('selected');
  while ((await state(page, 's.input.spec.subdivisions')) < 4) await page.click('[data-testid=subdivide]');
  await page.waitForSelector('[data-testid=cancel]');
  await same('busy');
  await page.click('[data-testid=cancel]');
  await page.waitForFunction(() => {
    const s = window.planish.store.state;
    return !s.computing && s.note === 'cancelled';
  });
  await same('cancelled');
  await page.click('[data-testid=finish]');
  await page.waitForSelector('[data-testid=cancel]');
  while ((await state(page, 's.input.spec.subdivisions')) > 0) await page.click('[data-testid=coarser]');
  await rested(page);
  assert.equal(await state(page, 's.note'), null);
  await page.click('[data-testid=curve-leg-3]');
  await enter(page, 'curve-leg-z', '900');
  await page.waitForFunction(() => window.planish.store.state.problem);
  await same('refused');
  await page.click('[data-testid=undo]');
  await rested(page);
  assert.equal(await state(page, 's.problem'), null);
  await page.click('[data-testid=tab-certificate]');
  await page.click('[data-testid=units-inch]');
  await same('other tab and unit');
}

export async function layout({ page }) {
  const tidy = async (what) => {
    await page.waitForTimeout(100);
    assert.deepEqual(await page.evaluate(untidy), [], what);
  };
  const openFolds = () =>
    page.evaluate(() =>
      document.querySelectorAll('aside details').forEach((d) => {
        d.open = true;
      }),
    );
  await tidy('empty');
  await example(page, 'bracket.step');
  for (const tab of ['input', 'bends', 'findings', 'certificate']) {
    await page.click(`[data-testid=tab-${tab}]`);
    await tidy(`bracket, ${tab}`);
  }
  await example(page, 'connect/a_folded.json');
  await page.click('[data-testid=plate-right]');
  await openFolds();
  for (const unit of ['inch', 'mm']) {
    await page.click(`[data-testid=units-${unit}]`);
    await tidy(`plate in ${unit}`);
  }
  await page.click('[data-testid=gizmo-rotate]');
  await tidy('plate that is turned');
  await page.click('[data-testid=bend-head-B4]');
  await tidy('bend');
  await example(page, 'transition/b_rectangle_to_ellipse_inclined.json');
  await openFolds();
  await tidy('transition');
  await open(page, [coarse(page, 'plume.json')]);
  await page.click('[data-testid=strip-head-1]');
  await page.click('[data-testid=curve-leg-1]');
  await tidy('curve');
  await page.click('[data-testid=strip-head-1]');
  for (const unit of ['inch', 'mm']) {
    await page.click(`[data-testid=units-${unit}]`);
    await tidy(`strip in ${unit}`);
  }
}

export async function policy({ said }) {
  const strict = await fresh({ bypassCSP: false });
  await strict.page.click('[data-testid=examples-menu]');
  await strict.page.click('[data-testid="example-slit/chair.json"]');
  await strict.page.waitForSelector('[data-testid=blank-size]:has-text("1768")', { timeout: 60000 });
  said.push(...strict.said);
  await strict.context.close();
}
