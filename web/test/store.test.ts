import assert from 'node:assert/strict';
import { test } from 'node:test';
import { initialState, Store } from '../src/state.ts';

const make = () => {
  const store = new Store(initialState('light'));
  store.dispatch({ type: 'opened', document: { id: 'd1', kind: 'unfold', name: 'a.step' }, spec: null });
  return store;
};
const k = (store: Store) => store.state.input.options.k;
const edit = (store: Store, value: number, live = false) => store.dispatch({ type: 'edit', input: { spec: null, options: { k: value } }, live });

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
