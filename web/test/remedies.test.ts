import assert from 'node:assert/strict';
import test from 'node:test';
import { nothing } from 'lit-html';
import { remedies } from '../src/panels/remedies.ts';
import type { Ui } from '../src/ui.ts';

/** The page with a STEP part, as far as remedies look at it. */
const page = (options: object) =>
  ({
    state: {
      document: { kind: 'unfold' },
      description: {
        makers: [
          {
            name: 'unfold',
            options: [
              { name: 'rip_edges', kind: 'name', default: '', description: '' },
              { name: 'bend_relief', kind: 'word', default: 'none', description: '' },
            ],
          },
        ],
      },
      input: { options },
    },
  }) as unknown as Ui;

const rip = { option: '--rip-edges', value: '21', change: 'Rip edge 21.' },
  square = { option: '--bend-relief', value: 'square', change: 'Cut square reliefs' },
  none = { option: '--bend-relief', value: 'none', change: 'Leave it as drawn' };

/** What the buttons say. */
const buttons = (...said: Parameters<typeof remedies>) => {
  const shown = remedies(...said);
  return shown === nothing
    ? []
    : (shown as unknown as { values: { values: unknown[] }[][] }).values[0]!.map((b) => b.values[4]);
};

test('an option that helps is a button', () => {
  assert.deepEqual(buttons(page({}), { remedy: rip }), ['Rip edge 21']);
  assert.deepEqual(buttons(page({}), { remedy: square, remedies: [square, rip] }), [
    'Cut square reliefs',
    'Rip edge 21',
  ]);
});

test('no button offers what is in force, by choice or by default', () => {
  assert.deepEqual(buttons(page({}), { remedy: none }), []);
  assert.deepEqual(buttons(page({ bend_relief: 'square' }), { remedies: [square, none] }), ['Leave it as drawn']);
});

test('no button is there for what the maker does not take, or for a change to the input', () => {
  assert.deepEqual(buttons(page({}), { remedy: { option: '--kerf', value: '1', change: 'Widen it' } }), []);
  assert.deepEqual(buttons(page({}), { remedy: { change: 'Draw a larger radius.' } }), []);
  assert.deepEqual(buttons(page({}), {}), []);
});
