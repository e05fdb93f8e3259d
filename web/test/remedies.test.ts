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

test('reliefs are offered where the finding names one', () => {
  const found = (message: string) => remedies(page, { code: 'bend_relief', message });
  assert.notEqual(found('bend B1 ends inside an edge at (1, 2) without relief; it needs one 1 mm wide'), nothing);
  assert.notEqual(found('the relief of bend B1 at (1, 2) is 0.2 mm wide; at least 1 mm (0.5 T) is needed'), nothing);
  assert.equal(found('bend B1 ends flush with an edge at (1, 2) without relief; the corner bulges'), nothing);
});
