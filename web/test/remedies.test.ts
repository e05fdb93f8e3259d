import assert from 'node:assert/strict';
import test from 'node:test';
import { nothing } from 'lit-html';
import { remedies } from '../src/panels/remedies.ts';
import type { Ui } from '../src/ui.ts';

/** The page with a STEP part, as far as remedies look at it. */
const page = {
  state: {
    document: { kind: 'unfold' },
    description: { makers: [{ name: 'unfold', options: [{ name: 'rip_edges' }, { name: 'bend_relief' }] }] },
    input: { options: {} },
  },
} as unknown as Ui;

const closed = (text: string, where: string) =>
  remedies(page, {
    code: 'closed_loop',
    message: `The flanges and bends form a closed loop that does not lie flat${text}`,
    where,
  } as Parameters<typeof remedies>[1]);

test('a rip is offered where rips lead to a pattern', () => {
  const first = '; rips along 4 edges would open it, first along the edge between face 7 and face 9.';
  assert.notEqual(closed(first, 'edge 34 between face 7 and face 9'), nothing);
  assert.equal(closed(', and no rips along its edges open it.', 'between face 7 and face 9'), nothing);
});

test('reliefs are offered where the rules ask for one', () => {
  assert.notEqual(remedies(page, { code: 'bend_relief' }), nothing);
  assert.equal(remedies(page, { code: 'flush_bend' }), nothing);
});
