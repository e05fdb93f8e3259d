import assert from 'node:assert/strict';
import { test } from 'node:test';
import { byPlates, plateOf, sentence } from '../src/said.ts';
import type { State } from '../src/state.ts';

test('options in a message are said in words, all else as it stands', () => {
  const wording = [
    { text: '`bend_relief`', option: 'bend_relief' },
    { text: ' is not `square` at ' },
    { text: '/options/bend_relief', place: { kind: 'pointer' as const, id: '/options/bend_relief' } },
    { text: '.' },
  ];
  const message = wording.map((piece) => piece.text).join('');
  assert.equal(sentence({ message, wording }), '“bend relief” is not `square` at /options/bend_relief.');
  assert.equal(sentence({ message }), message, 'without pieces nothing is read out of it');
});

test('flanges of plates are called as their plates, by what the sentence names', () => {
  const parts = [
      { name: 'F1', kind: 'flange', plate: 'web', faces: [] },
      { name: 'F2', kind: 'flange', faces: [] },
    ],
    state = { shape: { parts } } as unknown as State,
    flange = (id: number) => ({ text: `flange ${id}`, place: { kind: 'flange' as const, id } }),
    told = (id: number) => ({
      sentence: `B1: flange ${id} hits punch F1`,
      wording: [{ text: 'B1: ' }, flange(id), { text: ' hits punch F1' }],
    });
  assert.equal(byPlates(state, told(1)), 'B1: web hits punch F1');
  assert.equal(byPlates(state, told(2)), 'B1: flange 2 hits punch F1', 'it was made of no plate');
  assert.equal(byPlates(state, { sentence: 'none', wording: [] }), 'none');
  assert.deepEqual([plateOf(state, 'F1'), plateOf(state, 'F2'), plateOf(state, 'edge')], ['web', 'F2', 'edge']);
});
