import type { Recent } from './recents.ts';
import { orderOfText, textOfOrder } from './kept-order.ts';
import type { OrderState } from './order-state.ts';
import { tabs, type History, type State, type Tab } from './state.ts';

/** What a tab needs to restore its state after a reload, in the tab's own storage: the edits, and the file. */
export interface Kept {
  source: Source;
  history: History;
  order?: OrderState;
}

/** Where what is edited lies among the files opened lately. */
interface Copy {
  key: string;
  isNew: boolean;
  before: Recent | null;
}

/** A file, or where it is to be had: on this machine, if it is large, or from the server that was started with it. */
type Source = { name: string; bytes: ArrayBuffer; beside: Record<string, ArrayBuffer> } | Elsewhere;
type Elsewhere = { recent: Recent } | { given: string };
/** The start page, by the server's token: it is shown even if the server was started with a file. */
type Start = { start: string };

const file = 'planish-file',
  edited = 'planish-input',
  ordered = 'planish-order',
  copied = 'planish-copy',
  shown = 'planish-tab';
const most = 3 << 20; // storages hold some five million characters
const mostOfHistory = 1 << 20;

/** False if it is too large. */
export function keepDocument(main: { name: string; bytes: ArrayBuffer }, beside: Record<string, ArrayBuffer>): boolean {
  sessionStorage.removeItem(file);
  const all = [main.bytes, ...Object.values(beside)];
  if (all.reduce((sum, b) => sum + b.byteLength, 0) > most) return false;
  return write(file, {
    name: main.name,
    bytes: toText(main.bytes),
    beside: Object.fromEntries(Object.entries(beside).map(([name, b]) => [name, toText(b)])),
  });
}

export const keepSource = (source: Elsewhere | Start) => write(file, source);
export const isAtStart = (token: string) => sessionStorage.getItem(file) === JSON.stringify({ start: token });

export const keepCopy = ({ key, isNew, before }: Copy) => write(copied, { key, isNew, before });
export function keptCopy(isRestored: boolean): Copy | null {
  if (!isRestored) sessionStorage.removeItem(copied);
  return JSON.parse(sessionStorage.getItem(copied) ?? 'null') as Copy | null;
}

export const keepTab = (tab: Tab) => writeText(shown, tab);
export const keptTab = (): Tab => tabs.find((tab) => tab === sessionStorage.getItem(shown)) ?? 'input';

/**
 * Keeps the input with what undo and redo go through, the farthest steps last: of large inputs as many as there is room
 * for.
 */
export function keepHistory({ input, past, future }: Pick<State, 'input' | 'past' | 'future'>) {
  for (let steps = past.length + future.length; ; steps >>= 1) {
    const text = JSON.stringify({ input, past: steps ? past.slice(-steps) : [], future: future.slice(0, steps) });
    if (steps === 0 || text.length <= mostOfHistory) return void writeText(edited, text);
  }
}

/** Keeps the order of strokes, with as many of those that undo and redo go through as there is room for. */
export function keepOrder(state: State) {
  const { past, future } = state.order;
  for (let steps = Math.max(past.length, future.length); ; steps >>= 1) {
    const text = textOfOrder(state, steps);
    if (text === null) return sessionStorage.removeItem(ordered);
    if ((steps === 0 || text.length <= mostOfHistory) && (writeText(ordered, text) || steps === 0)) return;
  }
}

export function keptDocument(): Kept | null {
  try {
    const kept = JSON.parse(sessionStorage.getItem(file) ?? 'null') as
      | { name: string; bytes: string; beside: Record<string, string> }
      | Elsewhere
      | Start
      | null;
    const history = JSON.parse(sessionStorage.getItem(edited) ?? 'null') as History | null;
    if (!kept || !history || 'start' in kept) return null;
    const order = keptOrder(history);
    if (!('bytes' in kept)) return { source: kept, history, order };
    const beside = Object.fromEntries(Object.entries(kept.beside).map(([name, b]) => [name, toBytes(b)]));
    return { source: { name: kept.name, bytes: toBytes(kept.bytes), beside }, history, order };
  } catch {
    return null;
  }
}

function keptOrder(history: History): OrderState | undefined {
  const text = sessionStorage.getItem(ordered);
  try {
    return text === null ? undefined : orderOfText(text, history);
  } catch {
    return undefined;
  }
}

const write = (key: string, value: unknown) => writeText(key, JSON.stringify(value));

function writeText(key: string, text: string): boolean {
  try {
    sessionStorage.setItem(key, text);
    return true;
  } catch {
    sessionStorage.removeItem(key); // too large: the page begins empty
    return false;
  }
}

function toText(bytes: ArrayBuffer): string {
  const view = new Uint8Array(bytes);
  let text = '';
  for (let i = 0; i < view.length; i += 8192) text += String.fromCharCode(...view.subarray(i, i + 8192));
  return btoa(text);
}

function toBytes(text: string): ArrayBuffer {
  return Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
}
