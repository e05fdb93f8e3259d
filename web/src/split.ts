import { html } from 'lit-html';
import type { Api } from './api.ts';
import {
  arrangementFor,
  arrangementOf,
  evenly,
  leastSplit,
  mostSplit,
  type Arrangement,
  type ViewState,
} from './view-state.ts';
import type { State } from './state.ts';
import type { Store } from './store.ts';
import type { Ui } from './ui.ts';
import './split.css';
import './narrow.css';

export const viewFile = 'views.json';
const step = 0.02;
const pause = 300; // ms, after which what was changed is kept

/** What was kept of the arrangement: only what can be meant. */
export const soundView = ({ split, arrangement }: Partial<ViewState>): Partial<ViewState> => ({
  ...(typeof split === 'number' && split > 0 && split < 1 ? { split } : {}),
  ...(arrangement === 'beside' || arrangement === 'stacked' ? { arrangement } : {}),
});

let waiting = 0;
/** Keeps the arrangement, once it rests. */
export function keepView(api: Api, { split, arrangement }: ViewState) {
  clearTimeout(waiting);
  waiting = window.setTimeout(
    () => void api.keep(viewFile, new Blob([JSON.stringify({ split, arrangement })])).catch(() => undefined),
    pause,
  );
}

/** Whether there is no pattern to be seen, but the solid as it was read; null as long as nobody knows. */
export const withoutPattern = ({ shape }: Pick<State, 'shape'>): boolean | null =>
  shape && (shape.points.length ? false : shape.space_faces.length ? true : null);

/** The arrangement that suits the pattern of another file, or piece, in an area; what has none lies beside it. */
export function suggestedFor({ shape }: Pick<State, 'shape'>, area: HTMLElement): Arrangement | null {
  const p = shape?.points;
  if (!p?.length) return withoutPattern({ shape }) ? 'beside' : null;
  const range = (k: number) => {
    let [low, high] = [Infinity, -Infinity];
    for (let i = k; i < p.length; i += 2) {
      low = Math.min(low, p[i]!);
      high = Math.max(high, p[i]!);
    }
    return Math.max(high - low, 1e-6);
  };
  return arrangementFor([range(0), range(1)], area.clientWidth, area.clientHeight);
}

/** The share of the folded view: most of the room while there is no pattern, unless the divider was moved. */
export const shareOf = ({ split }: ViewState, empty: boolean): number =>
  empty && split === evenly ? mostSplit : split;

/** Arranges both views in an area, from now on. */
export function arrangeViews(store: Store, area: HTMLElement) {
  let arrangedFor = '',
    empty = false;
  const arrange = ({ view }: State) => {
    const share = shareOf(view, empty);
    area.classList.toggle('stacked', arrangementOf(view) === 'stacked');
    area.style.setProperty('--first', `${share}fr`);
    area.style.setProperty('--second', `${1 - share}fr`);
  };
  store.subscribe((state, before) => {
    const { document: d, view } = state,
      without = withoutPattern(state),
      file = `${d?.id} ${without}`,
      suggested = d && file !== arrangedFor ? suggestedFor(state, area) : null;
    const other = without !== null && without !== empty;
    if (other) empty = without;
    if (suggested) arrangedFor = file;
    if (suggested && suggested !== view.suggested) store.dispatch({ type: 'view', view: { suggested } });
    else if (view !== before.view || other) arrange(state);
  });
  arrange(store.state);
}

/** Between both views: dragged, or moved by arrow keys. */
export function divider(ui: Ui, area: HTMLElement) {
  const { view } = ui.state,
    stacked = arrangementOf(view) === 'stacked',
    share = shareOf(view, withoutPattern(ui.state) ?? false),
    set = (split: number) => ui.dispatch({ type: 'view', view: { split } });
  const drag = (e: PointerEvent) => {
    const handle = e.currentTarget as HTMLElement;
    if (e.button !== 0) return;
    handle.setPointerCapture(e.pointerId);
    const move = (m: PointerEvent) => {
      const r = area.getBoundingClientRect();
      set(stacked ? (m.clientY - r.top) / r.height : (m.clientX - r.left) / r.width);
    };
    handle.addEventListener('pointermove', move);
    handle.addEventListener('lostpointercapture', () => handle.removeEventListener('pointermove', move), {
      once: true,
    });
  };
  const press = (e: KeyboardEvent) => {
    const by = { ArrowLeft: -step, ArrowUp: -step, ArrowRight: step, ArrowDown: step }[e.key];
    if (by !== undefined) set(share + by);
    else if (e.key === 'Home') set(0);
    else if (e.key === 'End') set(1);
    else if (e.key === 'Enter') set(evenly);
    else return;
    e.preventDefault();
  };
  return html`<div
    role="separator"
    tabindex="0"
    data-testid="divider"
    aria-label="Share of the folded part"
    aria-orientation=${stacked ? 'horizontal' : 'vertical'}
    aria-valuemin=${Math.round(100 * leastSplit)}
    aria-valuemax=${Math.round(100 * mostSplit)}
    aria-valuenow=${Math.round(100 * share)}
    title="Drag to share the room; double-click: as it was at first"
    @pointerdown=${drag}
    @keydown=${press}
    @dblclick=${() => ui.dispatch({ type: 'view', view: { split: evenly, arrangement: null } })}
  ></div>`;
}
