import type { Store } from './store.ts';

/** Says why an entry was refused, until another one is taken. */
export function sayRefusals(store: Store) {
  let said: string | null = null,
    entered = false; // something, since then
  const settle = () => {
    if (entered && said !== null && store.state.note === said) store.dispatch({ type: 'note', note: null });
  };
  window.addEventListener('input', () => (entered = true), true);
  window.addEventListener('refused', (e) => {
    entered = false;
    said = (e as CustomEvent<string>).detail;
    store.dispatch({ type: 'note', note: said });
  });
  window.addEventListener('change', settle);
  // What is again as it was is no change.
  window.addEventListener('focusout', settle);
  window.addEventListener('keydown', (e) => {
    if (e.key === 'Enter') setTimeout(settle);
  });
}
