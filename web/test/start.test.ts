import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inputsText } from '../src/panels/inputs-text.ts';
import type { MakerRow } from '../src/types.ts';

const maker = (name: string, input: string, editable: boolean): MakerRow => ({
  ...{ name, input: `${input} file`, editable, names_files: false, description: '', options: [], artifacts: [] },
});

test('the start page says what the makers read', () => {
  const [step, plates, slit] = [
    maker('unfold', 'STEP', false),
    maker('connect', 'plates', true),
    maker('x', 'slit', true),
  ];
  assert.equal(inputsText([step, plates]), 'A STEP part to unfold, or a plates file (JSON).');
  assert.equal(
    inputsText([step, plates, maker('new', 'disc', true), slit]),
    'A STEP part to unfold, or a plates, disc or slit file (JSON).',
  );
  assert.equal(inputsText([]).trim(), '', 'nothing before the server has said it');
});
