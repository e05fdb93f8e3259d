import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Input } from '../src/state.ts';
import { optionsOf, pictureOf, sameOptions, sharedOptions, statusOfShape, withBody } from '../src/bodies.ts';
import { safeName, stems, summaryCsv } from '../src/body-files.ts';
import { decodeShape } from '../src/shape.ts';
import type { Report } from '../src/types.ts';
import { zip } from '../src/zip.ts';
import { twoFlangesShape } from './two-flanges.ts';

const reason = (code: string, message: string) => ({ code, message, where: '', places: [], numbers: {} });

const report = (body: string, thickness: number, more: Partial<Report> = {}): Report => ({
  format: 'planish/report',
  version: 1,
  command: 'unfold',
  input: 'a.step',
  body,
  body_number: 1,
  quantity: 2,
  units: 'mm',
  status: 'ok',
  reason: null,
  sheet: {
    thickness,
    thickness_spread: 0,
    k_factor: 0.44,
    k_source: 'default',
    flanges: 2,
    bends: 1,
    volume: 1,
    mass: null,
  },
  flat: {
    area: 6000,
    perimeter: 320,
    size: [100, 60],
    cutting: { outer: 320, inner: 0 },
    openings: 0,
    bends: [],
    features: [],
  },
  verification: {
    volume_ratio: 1,
    explained_ratio: null,
    length_error: 1.4e-14,
    refold_deviation: 0.00005,
    closure: null,
    area_at_half: null,
    openings: { pattern: 0, features: 0 },
    places: { length_error: [0, 0], refold_deviation: [0, 0] },
  },
  checks: [],
  notes: [],
  files: [],
  ...more,
});

test('names of files are those of the program', () => {
  assert.equal(safeName('door, "left"'), 'door_left');
  assert.equal(safeName('..Träger 3/4"'), 'Träger_3_4');
  assert.equal(safeName('???'), 'body');
  assert.equal(safeName('x'.repeat(300)).length, 100);
});

test('bodies of one name get files of their own, in any unit', () => {
  const refused = report('A', 2, { status: 'refused', flat: null }),
    inch = report('a', 0, { units: 'inch', sheet: { ...report('', 0).sheet!, thickness: 2 / 25.4 } });
  assert.deepEqual(stems([report('A', 2), inch, refused, report('a', 2), report('A', 1.5)]), [
    'A_t2',
    'a_t2-2',
    '',
    'a_t2-3',
    'A_t1.5',
  ]);
});

test('the summary has a row a body, figures as the page shows them', () => {
  const refused = report('lid; "small"', 2, {
      status: 'refused',
      sheet: null,
      flat: null,
      verification: null,
      reason: reason('not_a_sheet', 'it is no sheet, but a block'),
    }),
    raw = report('B', 0.7999999999999979, {
      sheet: { ...report('', 0.7999999999999979).sheet!, mass: 0.0123456789 },
      flat: {
        ...report('', 1).flat!,
        area: 6283.185307,
        size: [100.00000000000001, 59.123456],
        cutting: { outer: 320.4567, inner: 31.41592653589793 },
        openings: 1,
      },
      verification: { ...report('', 1).verification!, volume_ratio: 0.9999999999999979 },
    }),
    inch = report('C', 1 / 3, { units: 'inch', flat: { ...report('', 1).flat!, size: [10 / 3, 1], area: 10 / 3 } });
  const rows = summaryCsv([
    { report: report('A', 2), pierces: 1, files: ['A_t2.dxf'] },
    { report: refused, pierces: null, files: [] },
    { report: raw, pierces: 4, files: ['B_t0.8.dxf'] },
    { report: inch, pierces: 1, files: [] },
  ]).split('\n');
  assert.match(rows[0]!, /,outer_cutting,inner_cutting,openings,pierces,bends,/);
  assert.equal(rows[1], '1,A,2,ok,,,mm,2,100,60,6000,320,0,0,1,1,,1,1e-14,5e-5,0,A_t2.dxf');
  assert.equal(rows[2], '1,"lid; ""small""",2,refused,not_a_sheet,"it is no sheet, but a block",mm,,,,,,,,,,,,,,0,');
  assert.equal(rows[3], '1,B,2,ok,,,mm,0.8,100,59.12,6283,320.46,31.42,1,4,1,0.01235,1,1e-14,5e-5,0,B_t0.8.dxf');
  assert.match(rows[4]!, /^1,C,2,ok,,,inch,0.3333,3.333,1,3.333,/);
});

test('what is said of one body only does not go with another', () => {
  const shop = { content: { materials: [] } },
    all = { body: 3, k: 0.4, root: 7, up: 'other', bend_k: { B1: 0.3 }, shop } as const;
  assert.deepEqual(sharedOptions(all), { k: 0.4, shop });
  assert.ok(sameOptions({ body: 1, k: 0.4, shop }, { body: 2, k: 0.4, shop }));
  assert.ok(!sameOptions({ k: 0.4 }, {}));
  assert.ok(!sameOptions({ shop }, { shop: { content: { materials: [] } } }));
});

test('what is said of one body only waits for it', () => {
  const first: Input = { spec: null, options: { k: 0.4, bend_k: { B1: 0.2 }, rip_edges: '3' } },
    second = withBody(first, 1, 2);
  assert.deepEqual(second.options, { k: 0.4, body: 2 });
  assert.deepEqual(optionsOf(second, 1, 2), { k: 0.4, bend_k: { B1: 0.2 }, rip_edges: '3' });
  const changed = { ...second, options: { ...second.options, k: 0.3, up: 'other' as const } },
    back = withBody(changed, 2, 1);
  assert.deepEqual(back.options, { k: 0.3, body: 1, bend_k: { B1: 0.2 }, rip_edges: '3' });
  assert.deepEqual(optionsOf(back, 2, 1), { k: 0.3, up: 'other' });
  assert.deepEqual(optionsOf(back, 3, 1), { k: 0.3 });
  const bare = withBody({ ...back, options: { k: 0.3, body: 1 } }, 1, 3);
  assert.deepEqual(bare.others, { 2: { up: 'other' } }, 'of the first nothing is left to keep');
});

test('a pattern has a picture, its y axis down, and no more points than are seen', () => {
  const shape = decodeShape(twoFlangesShape()),
    ring = Array.from({ length: 4000 }, (_, i) => (2 * Math.PI * i) / 4000);
  const seen = pictureOf({
    ...shape,
    contour_points: Float32Array.from(ring.flatMap((a) => [200 + 200 * Math.cos(a), 50 * Math.sin(a)])),
    contour_starts: new Uint32Array([0, 4000]),
    contour_part: new Int32Array([-1]),
    bend_lines: new Float32Array([200, -50, 200, 50]),
    bend_line_part: new Uint32Array([shape.parts.findIndex((p) => p.kind === 'bend')]),
    parts: shape.parts.map((p) => ({ ...p, direction: 'down' })),
  })!;
  assert.deepEqual([seen.width, seen.height], [100, 25]);
  assert.equal(seen.down, 'M50 25L50 0');
  assert.equal(seen.up, '');
  const points = seen.sheet.slice(1, -1).split('L');
  assert.ok(points.length > 100 && points.length < 300, String(points.length));
  assert.equal(pictureOf({ ...shape, contour_part: new Int32Array() }), undefined);
});

test('a refusal is said with its reason', () => {
  const shape = decodeShape(twoFlangesShape()),
    refused = { status: 'refused', reason: reason('not_a_sheet', 'no'), sheet: null, flat: null } as const;
  const status = statusOfShape({ ...shape, report: { ...shape.report, ...refused } }, {});
  assert.deepEqual(status, { status: 'refused', code: 'not_a_sheet', message: 'no', of: {}, units: 'mm' });
});

test('an archive holds its files, and their checksums', async () => {
  const text = (s: string) => new TextEncoder().encode(s),
    made = await zip([
      { name: 'a.txt', bytes: text('123456789') },
      { name: 'leer', bytes: text('') },
    ]);
  const view = new DataView(await made.arrayBuffer());
  assert.equal(view.getUint32(0, true), 0x04034b50);
  assert.equal(view.getUint32(14, true), 0xcbf43926, 'CRC-32 of 123456789');
  const end = view.byteLength - 22,
    first = view.getUint32(end + 16, true);
  assert.equal(view.getUint32(end, true), 0x06054b50);
  assert.equal(view.getUint16(end + 10, true), 2);
  assert.equal(view.getUint32(first, true), 0x02014b50);
  assert.equal(first + view.getUint32(end + 12, true), end);
});
