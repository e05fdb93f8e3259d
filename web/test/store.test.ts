import assert from 'node:assert/strict';
import { test } from 'node:test';
import { keepHistory } from '../src/kept.ts';
import { initialState, type History } from '../src/state.ts';
import { Store } from '../src/store.ts';
import { twoFlanges } from './two-flanges.ts';
import { decodeShape, encodeShape } from '../src/shape.ts';
import type { OpenDocument, Spec } from '../src/types.ts';

const make = () => {
  const store = new Store(initialState('light'));
  store.dispatch({ type: 'opened', document: { id: 'd1', kind: 'unfold', name: 'a.step' }, spec: null });
  return store;
};
const k = (store: Store) => store.state.input.options.k;
const edit = (store: Store, value: number, live = false) =>
  store.dispatch({ type: 'edit', input: { spec: null, options: { k: value } }, live });

test('undo goes back, redo forth, and an edit ends what could be redone', () => {
  const store = make();
  edit(store, 0.3);
  edit(store, 0.4);
  store.dispatch({ type: 'undo' });
  assert.equal(k(store), 0.3);
  store.dispatch({ type: 'undo' });
  assert.equal(k(store), undefined);
  store.dispatch({ type: 'undo' });
  assert.equal(k(store), undefined);
  store.dispatch({ type: 'redo' });
  assert.equal(k(store), 0.3);
  edit(store, 0.5);
  store.dispatch({ type: 'redo' });
  assert.equal(k(store), 0.5);
  assert.equal(store.state.past.length, 2);
});

test('a drag is one step', () => {
  const store = make();
  for (const value of [0.31, 0.32, 0.33]) edit(store, value, true);
  assert.equal(store.state.past.length, 0);
  store.dispatch({ type: 'commit' });
  assert.equal(store.state.past.length, 1);
  store.dispatch({ type: 'undo' });
  assert.equal(k(store), undefined);
});

test('a drag that ends where it began is no step', () => {
  const store = make();
  edit(store, 0.3);
  edit(store, 0.4, true);
  edit(store, 0.3, true);
  store.dispatch({ type: 'commit' });
  assert.equal(store.state.past.length, 1);
});

test('the page speaks the unit of what is opened', () => {
  const store = make();
  const open = (document: object, spec: object | null) =>
    store.dispatch({
      type: 'opened',
      document: { id: 'd2', kind: 'unfold', name: 'b', ...document } as OpenDocument,
      spec: spec as Spec | null,
    });
  open({ info: { file_units: 'INCH' } }, null);
  assert.equal(store.state.units, 'inch');
  open({ info: { file_units: 'mm' } }, null);
  assert.equal(store.state.units, 'mm');
  open({ kind: 'transition' }, { units: 'inch' });
  assert.equal(store.state.units, 'inch');
  open({ kind: 'transition' }, { units: 'm' });
  assert.equal(store.state.units, 'mm');
});

test('what could not be opened is said until something is picked; what is the matter with the input stays', () => {
  const store = make(),
    problem = { code: 'not_step', message: 'b.pdf is not a STEP file' };
  store.dispatch({ type: 'problem', problem });
  store.dispatch({ type: 'select', selection: { part: 'B1' } });
  assert.equal(store.state.problem, null);
  store.dispatch({ type: 'problem', problem, ofInput: true });
  store.dispatch({ type: 'select', selection: {} });
  assert.equal(store.state.problem, problem);
});

test('a bend that is picked stays picked when bends are numbered anew', () => {
  const store = make(),
    { header, arrays } = twoFlanges(),
    [bend] = header.report.flat!.bends;
  store.dispatch({
    type: 'opened',
    document: { id: 'd3', kind: 'connect', name: 'c' } as OpenDocument,
    spec: { thickness: 2, plates: [] } as Spec,
  });
  const show = (pairs: [string, string][]) => {
    const flat = { ...header.report.flat!, bends: pairs.map((between, i) => ({ ...bend!, id: `B${i + 1}`, between })) };
    const shape = decodeShape(encodeShape({ ...header, report: { ...header.report, flat } }, arrays));
    store.dispatch({ type: 'shape', shape, draft: false });
  };
  show([
    ['floor', 'left'],
    ['floor', 'right'],
  ]);
  store.dispatch({ type: 'select', selection: { part: 'B2' } });
  show([
    ['floor', 'left'],
    ['left', 'flap'],
    ['right', 'floor'],
  ]);
  assert.equal(store.state.selection.part, 'B3');
  show([['floor', 'left']]);
  assert.equal(store.state.selection.part, null);
});

test('what is kept of a long history is its nearest steps', () => {
  const kept = new Map<string, string>();
  Object.assign(globalThis, {
    sessionStorage: { setItem: (key: string, text: string) => kept.set(key, text), removeItem: () => undefined },
  });
  const input = (size: number, k: number) => ({ spec: { text: 'x'.repeat(size) } as unknown as Spec, options: { k } });
  const keep = (size: number) => {
    keepHistory({
      input: input(size, 0),
      past: Array.from({ length: 40 }, (_, i) => input(size, i - 40)),
      future: Array.from({ length: 10 }, (_, i) => input(size, i + 1)),
    });
    return JSON.parse(kept.get('planish-input')!) as History;
  };
  const whole = keep(100);
  assert.deepEqual([whole.past.length, whole.future.length], [40, 10]);
  const part = keep(1 << 16);
  assert.deepEqual([part.past.at(-1)?.options.k, part.future[0]?.options.k], [-1, 1]);
  assert.ok(part.past.length < 40 && part.past.length > 0);
  const none = keep(1 << 20);
  assert.deepEqual([none.past.length, none.future.length, none.input.options.k], [0, 0, 0]);
});
