import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sentence } from '../src/said.ts';

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
