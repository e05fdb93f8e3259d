import assert from 'node:assert/strict';
import { test } from 'node:test';
import { dxfOptions, soundChoices, type DxfChoices } from '../src/dxf-choices.ts';
import type { MakerRow } from '../src/types.ts';

const row = (name: string, words: string[] = []) => ({
  name,
  kind: '',
  group: 'DXF',
  description: '',
  default: '',
  words,
});
const unfold: MakerRow = {
  name: 'unfold',
  description: '',
  input: 'STEP',
  editable: false,
  names_files: false,
  artifacts: ['dxf'],
  options: [
    row('units', ['mm', 'inch', 'm']),
    row('profile', ['default', 'inventor']),
    row('r12'),
    row('splines', ['keep', 'arcs']),
    row('arc_tolerance'),
    row('bend_marks', ['lines', 'ticks']),
    row('tick_length'),
    row('turn_to_blank'),
  ],
};

test('a DXF has the unit of the page until another is chosen', () => {
  assert.deepEqual(dxfOptions({}, unfold, 'inch'), { units: 'inch' });
  assert.deepEqual(dxfOptions({ units: 'm' }, unfold, 'inch'), { units: 'm' });
});

test('what contradicts something else is left out, and there again when that is gone', () => {
  const chosen = { tick_length: 3, splines: 'keep', arc_tolerance: 0.1, r12: true } as const;
  assert.deepEqual(dxfOptions(chosen, unfold, 'mm'), { units: 'mm', r12: true, arc_tolerance: 0.1 });
  assert.deepEqual(dxfOptions({ ...chosen, r12: undefined, bend_marks: 'ticks' }, unfold, 'mm'), {
    units: 'mm',
    splines: 'keep',
    bend_marks: 'ticks',
    tick_length: 3,
  });
});

test('only what the maker takes is asked for', () => {
  const few = { ...unfold, options: unfold.options.filter((o) => o.name !== 'turn_to_blank') };
  assert.deepEqual(dxfOptions({ turn_to_blank: true, tangent_lines: true }, few, 'mm'), { units: 'mm' });
  assert.deepEqual(dxfOptions({ profile: 'no such layers' } as unknown as DxfChoices, unfold, 'mm'), { units: 'mm' });
});

test('of what was kept, only what can be meant is taken', () => {
  assert.deepEqual(soundChoices({ r12: true, profile: 7, tick_length: '3', bend_text: true, other: 1 }), {
    r12: true,
    bend_text: true,
  });
  for (const rubbish of [null, 3, 'r12', undefined]) assert.deepEqual(soundChoices(rubbish), {});
});
