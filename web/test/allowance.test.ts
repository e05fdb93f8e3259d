import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import {
  allowanceOf,
  gaugeDeduction,
  gaugeK,
  gaugeOf,
  kRule,
  materialOf,
  sameAllowance,
  withK,
  type Shop,
} from '../src/allowance.ts';
import { areaText, massText } from '../src/amounts.ts';
import { unconfirmedK } from '../src/default-k.ts';
import { reduce } from '../src/reduce.ts';
import { initialState } from '../src/state.ts';
import type { OpenDocument, PieceReport, Spec } from '../src/types.ts';
import { soundWorkshop } from '../src/workshop-state.ts';

const near = (a: number, b: number, tolerance = 1e-9) => assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);
const example = JSON.parse(readFileSync(new URL('../../examples/shop/example.json', import.meta.url), 'utf8')) as Shop;

test('K of a gauge follows from its deduction: the example of shop-profiles.md', () => {
  const g = { thickness: 2, inside_radius: 2, deduction: 3.8374 };
  near(gaugeK(g), 0.325, 5e-5);
  near(gaugeDeduction(g), 3.8374);
});

test('a deduction beyond 90° is measured to the mould line or to the tangent plane', () => {
  const g = { thickness: 2, inside_radius: 2, angle: 120, deduction: 5 },
    plane = { ...g, deduction_to: 'tangent_plane' } as const,
    k = (allowance: number) => (allowance / ((2 * Math.PI) / 3) - 2) / 2;
  near(gaugeK(g), k(2 * 4 * Math.sqrt(3) - 5));
  near(gaugeK(plane), k(2 * 4 - 5));
  // docs: "with R = T = 2 mm and 120° the two readings differ by 5.9 mm"
  near(2 * 4 * Math.sqrt(3) - 2 * 4, 5.9, 0.05);
  near(gaugeK({ thickness: 2, inside_radius: 2, angle: 60, allowance: 3 }), (3 / (Math.PI / 3) - 2) / 2);
  near(gaugeK({ thickness: 1, inside_radius: 1, k: 0.4 }), 0.4);
  near(gaugeDeduction({ thickness: 1, inside_radius: 1, k: 0.4 }), 4 - (Math.PI / 2) * 1.4);
});

test('a part is of the nearest gauge within the tolerance, in the units of the shop', () => {
  const steel = materialOf(example, 'Mild Steel')!;
  assert.equal(gaugeOf(example, steel, 2.04)!.thickness, 2);
  assert.equal(gaugeOf(example, steel, 2.06), null);
  assert.equal(gaugeOf({ ...example, thickness_tolerance: 0.3 }, steel, 1.76)!.thickness, 2);
  const inch = { materials: [], units: 'inch' as const },
    thin = { name: 'a', gauges: [{ thickness: 0.06, inside_radius: 0.06, k: 0.4 }] };
  assert.ok(gaugeOf(inch, thin, 0.06 + 0.0019));
  assert.equal(gaugeOf(inch, thin, 0.06 + 0.0021), null);
  assert.equal(materialOf(example, undefined), null, 'of two none is chosen');
  assert.equal(materialOf({ materials: [steel] }, undefined), steel);
});

test('K comes from one place', () => {
  const shop = { name: 's', content: { materials: [] } },
    all = withK({ body: 2, density: 7.85, k: 0.4 }, { shop, material: 'steel' });
  assert.equal(kRule(all), 'shop');
  assert.deepEqual(allowanceOf(all), { shop, material: 'steel', density: 7.85 });
  assert.equal(all.body, 2);
  assert.equal(kRule(withK(all, { din6935: true })), 'din6935');
  assert.equal(kRule(withK(all, {})), 'default');
  assert.ok(sameAllowance({ k: 0.4, body: 1 }, { k: 0.4 }));
  assert.ok(!sameAllowance({ k: 0.4 }, {}));
});

test('what is set for every part holds for parts, not for other files', () => {
  const state = reduce(initialState('light'), { type: 'every-part', options: { k: 0.4, density: 7.85 } }),
    document: OpenDocument = { id: 'd1', kind: 'unfold', name: 'a' };
  const opened = (spec: Spec | null, body?: number) =>
    reduce(state, { type: 'opened', document, spec, body }).input.options;
  assert.deepEqual(opened(null), { k: 0.4, density: 7.85 });
  assert.deepEqual(opened(null, 3), { k: 0.4, density: 7.85, body: 3 });
  assert.deepEqual(opened({ thickness: 1 }), {}, 'an edited file has its own');
});

test('files of the workshop are kept once by kind and name, the last one first', () => {
  const file = (kind: 'shop' | 'k_table', name: string, text = '') => ({ kind, name, text });
  let { workshop } = initialState('light');
  const add = (f: ReturnType<typeof file>) =>
    (workshop = reduce({ ...initialState('light'), workshop }, { type: 'table-file', file: f }).workshop);
  add(file('shop', 'a'));
  add(file('k_table', 'a'));
  add(file('shop', 'a', 'new'));
  assert.deepEqual(workshop.files, [file('shop', 'a', 'new'), file('k_table', 'a')]);
  assert.deepEqual(soundWorkshop(JSON.parse(JSON.stringify(workshop))), workshop);
  assert.deepEqual(soundWorkshop({ files: [{ kind: 'other' }, null], dxf: 3 }), {
    dxf: {},
    files: [],
    everyPart: null,
  });
});

test('a K that nobody chose is to be confirmed', () => {
  const report = (...sources: string[]) =>
    ({ flat: { bends: sources.map((k_source) => ({ k_source, k_factor: 0.44 })) } }) as unknown as PieceReport;
  assert.equal(unconfirmedK(report('constant', 'default')), 0.44);
  assert.equal(unconfirmedK(report('constant', 'DIN 6935')), null);
  assert.equal(unconfirmedK(report()), null);
  assert.equal(unconfirmedK(null), null);
});

test('areas and masses have the unit that suits them', () => {
  assert.equal(areaText(6386.34, 'mm', 'mm'), '6386 mm²');
  assert.equal(areaText(123456, 'mm', 'mm'), '0.1235 m²');
  assert.equal(areaText(12.345, 'mm', 'mm'), '12.35 mm²');
  assert.equal(areaText(2.5, 'inch', 'mm'), '1613 mm²');
  assert.equal(areaText(25.4 ** 2, 'mm', 'inch'), '1 in²');
  assert.equal(areaText(2880, 'inch', 'inch'), '20 ft²');
  assert.equal(areaText(undefined, 'mm', 'mm'), '–');
  assert.equal(massText(0.1005, 'mm'), '100.5 g');
  assert.equal(massText(12.3456, 'mm'), '12.35 kg');
  assert.equal(massText(0.45359237, 'inch'), '1 lb');
  assert.equal(massText(0.45359237 / 2, 'inch'), '8 oz');
  assert.equal(massText(null, 'mm'), '–');
});
