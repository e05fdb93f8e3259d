import type { History, State } from './state.ts';

/** What a tab needs to restore its state after a reload: the file and its edits, in the tab's own storage. */
interface Kept {
  name: string;
  bytes: ArrayBuffer;
  beside: Record<string, ArrayBuffer>;
  history: History;
}

const file = 'planish-file',
  edited = 'planish-input';
const most = 3 << 20; // storages hold some five million characters
const mostOfHistory = 1 << 20;

export function keepDocument(main: { name: string; bytes: ArrayBuffer }, beside: Record<string, ArrayBuffer>) {
  sessionStorage.removeItem(file);
  const all = [main.bytes, ...Object.values(beside)];
  if (all.reduce((sum, b) => sum + b.byteLength, 0) > most) return;
  write(file, {
    name: main.name,
    bytes: toText(main.bytes),
    beside: Object.fromEntries(Object.entries(beside).map(([name, b]) => [name, toText(b)])),
  });
}

/**
 * Keeps the input with what undo and redo go through, the farthest steps last: of large inputs as many as there is room
 * for.
 */
export function keepHistory({ input, past, future }: Pick<State, 'input' | 'past' | 'future'>) {
  for (let steps = past.length + future.length; ; steps >>= 1) {
    const text = JSON.stringify({ input, past: steps ? past.slice(-steps) : [], future: future.slice(0, steps) });
    if (steps === 0 || text.length <= mostOfHistory) return writeText(edited, text);
  }
}

export function keptDocument(): Kept | null {
  try {
    const kept = JSON.parse(sessionStorage.getItem(file) ?? 'null') as {
      name: string;
      bytes: string;
      beside: Record<string, string>;
    } | null;
    const history = JSON.parse(sessionStorage.getItem(edited) ?? 'null') as History | null;
    if (!kept || !history) return null;
    return {
      name: kept.name,
      bytes: toBytes(kept.bytes),
      beside: Object.fromEntries(Object.entries(kept.beside).map(([name, b]) => [name, toBytes(b)])),
      history,
    };
  } catch {
    return null;
  }
}

const write = (key: string, value: unknown) => writeText(key, JSON.stringify(value));

function writeText(key: string, text: string) {
  try {
    sessionStorage.setItem(key, text);
  } catch {
    sessionStorage.removeItem(key); // too large: the page begins empty
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
