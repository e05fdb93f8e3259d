import type { Store } from './store.ts';

/** Draws the page in the frame after its state changes. Returns what draws it at once, if it is to be drawn. */
export function drawsPage(store: Store, draw: () => void): () => void {
  let waiting = 0; // the frame in which the page is drawn
  let later = 0; // the frame after which it is
  let edited = false; // by no drag
  const now = () => {
    if (!waiting && !later) return;
    cancelAnimationFrame(waiting);
    cancelAnimationFrame(later);
    waiting = later = 0;
    edited = false;
    draw();
  };
  const soon = () => (waiting ||= requestAnimationFrame(now));
  store.subscribe((state, before) => {
    edited ||= state.input !== before.input && state.pending === null;
    // A drag is drawn with the geometry it leads to, if that comes within a frame: drawing would delay it.
    if (state.pending === null || state.shape !== before.shape) soon();
    else later ||= requestAnimationFrame(soon);
  });
  // What is drawn answers with the state it was drawn from: of two changes within a frame the second must see the
  // first.
  for (const event of ['pointerdown', 'keydown', 'click']) window.addEventListener(event, now, true);
  const beforeEdit = ({ type, target }: Event) => {
    if ((edited || type === 'change') && !(target instanceof HTMLSelectElement)) now(); // see `choice`
  };
  for (const event of ['change', 'input', 'pointermove']) window.addEventListener(event, beforeEdit, true);
  return now;
}
