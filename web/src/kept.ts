import type { Input } from './state.ts';

/** What a tab needs to restore its state after a reload: the file and its input, in the tab's own storage. */
interface Kept {
  name: string;
  bytes: ArrayBuffer;
  beside: Record<string, ArrayBuffer>;
  input: Input;
}

const file = 'planish-file',
  edited = 'planish-input';
const most = 3 << 20; // storages hold some five million characters

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

export const keepInput = (input: Input) => write(edited, input);

export function keptDocument(): Kept | null {
  try {
    const kept = JSON.parse(sessionStorage.getItem(file) ?? 'null') as {
      name: string;
      bytes: string;
      beside: Record<string, string>;
    } | null;
    const input = JSON.parse(sessionStorage.getItem(edited) ?? 'null') as Input | null;
    if (!kept || !input) return null;
    return {
      name: kept.name,
      bytes: toBytes(kept.bytes),
      beside: Object.fromEntries(Object.entries(kept.beside).map(([name, b]) => [name, toBytes(b)])),
      input,
    };
  } catch {
    return null;
  }
}

function write(key: string, value: unknown) {
  try {
    sessionStorage.setItem(key, JSON.stringify(value));
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
