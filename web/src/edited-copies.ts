import { pictureOf } from './bodies.ts';
import { keepCopy, keptCopy } from './kept.ts';
import { keyOf, type Recent, type Recents } from './recents.ts';
import type { Input } from './state.ts';
import type { Store } from './store.ts';
import type { Options, Shape, Spec } from './types.ts';

const pause = 400; // ms without an edit, after which what was edited is kept

/** A document with what its copy needs: its file, and under which key the copy lies. */
interface Watched {
  name: string;
  bytes: ArrayBuffer;
  beside: Record<string, ArrayBuffer>;
  isNew: boolean; // made here, under a name that nobody chose
  key: string; // empty until `keyed`
  keyed: Promise<void>;
  base: string; // the content as it was opened
  before: Recent | null; // what the key stood for then
  written: string | null; // what was kept last
  shown: Shape | null; // the last result with a pattern: its picture
}

/** What was opened; `recent`: from among the files opened lately; `listed`: it is put there. */
export interface Begun {
  name: string;
  bytes: ArrayBuffer;
  beside: Record<string, ArrayBuffer>;
  isNew?: boolean;
  recent?: Recent;
  listed?: boolean;
  isRestored?: boolean; // by a reload
}

/**
 * Keeps what is edited among the files opened lately, as it is, so that nothing is lost when another file takes its
 * place. What can be edited as a file has an entry of its own, beside the one of the file that it was; of a STEP part
 * the entry of the file gets the options.
 */
export class EditedCopies {
  private readonly store: Store;
  private readonly recents: Recents;
  private watched: Watched | null = null;
  private timer = 0;
  private hasComplained = false;

  constructor(store: Store, recents: Recents) {
    this.store = store;
    this.recents = recents;
    store.subscribe((state, before) => {
      if (!this.watched || (state.input === before.input && state.result === before.result && !before.pending)) return;
      if (state.result?.facet_parent.length && !state.stale) this.watched.shown = state.result;
      clearTimeout(this.timer);
      if (!state.pending) this.timer = window.setTimeout(() => void this.rest(), pause);
    });
  }

  /** From now on the document that has just been opened. */
  begin({ name, bytes, beside, isNew, recent, listed, isRestored }: Begun) {
    const { document, input } = this.store.state,
      kept = keptCopy(isRestored ?? false),
      base = contentOf(input),
      own = document?.kind && input.spec ? (recent?.edited ? recent.key : newKey()) : '';
    const watched: Watched = {
      ...{ name, bytes, beside, base, written: null, shown: null, keyed: Promise.resolve() },
      isNew: kept?.isNew ?? isNew ?? recent?.edited === 'new',
      key: kept?.key ?? own,
      before: kept ? kept.before : recent?.edited ? recent : null,
    };
    this.watched = watched;
    this.hasComplained = false;
    if (watched.key) return keepCopy(watched);
    watched.keyed = keyOf(name, bytes).then((key) => {
      watched.key = key;
      watched.before ??= listed && document ? { key, name, kind: document.kind, beside: [] } : null;
      if (this.watched === watched) keepCopy(watched);
    });
  }

  /** What lies beside the file is now this. */
  besides(beside: Watched['beside']) {
    if (this.watched) this.watched.beside = beside;
  }

  /** Keeps what was edited at once; says whether there is anything that was. */
  rest(): boolean {
    clearTimeout(this.timer);
    const { watched } = this,
      { document, pending, input } = this.store.state;
    if (!watched || !document) return false;
    const { name, beside, isNew } = watched,
      { spec, ...set } = pending ?? input,
      content = contentOf({ spec, ...set }),
      isEdited = content !== watched.base;
    if (!isEdited && watched.written === null) return false;
    const picture = (watched.shown && pictureOf(watched.shown)) ?? undefined,
      edited: Omit<Recent, 'key'> | null = isEdited
        ? {
            ...{ name, kind: document.kind, beside: Object.keys(beside) },
            ...{ edited: isNew ? 'new' : 'file', set: { ...set, options: shared(set.options) }, picture },
          }
        : null;
    const what = JSON.stringify([content, edited, picture]);
    if (what === watched.written) return isEdited;
    watched.written = what;
    // The document may be left before its key is known: it is kept all the same.
    void watched.keyed.then(() => this.keep(watched, edited, picture, spec));
    return isEdited;
  }

  /** As it is edited; what was edited no longer, as it was before. */
  private async keep(
    watched: Watched,
    edited: Omit<Recent, 'key'> | null,
    picture: Recent['picture'],
    spec: Spec | null,
  ) {
    const { key, name, bytes, beside, before } = watched,
      own: Recent | null = edited ? { key, ...edited } : before && { ...before, picture },
      main = spec ? (new TextEncoder().encode(JSON.stringify(spec)).buffer as ArrayBuffer) : bytes,
      work = own ? this.recents.keepEdited(own, main, beside, spec !== null) : this.recents.remove(key);
    if ((await work) || this.hasComplained || this.watched !== watched) return;
    this.hasComplained = true;
    this.store.dispatch({ type: 'note', note: `This machine has no room left to keep ${name} as it is edited.` });
  }

  /** The document is left: what was edited is kept. Says whether anything was. */
  end(): boolean {
    const isEdited = this.rest();
    this.watched = null;
    return isEdited;
  }
}

/** Choosing a piece, or a body, is no edit. */
const shared = ({ piece: _, ...options }: Options) => options;

function contentOf({ spec, options, others }: Input): string {
  const { body: _, ...own } = shared(options);
  return JSON.stringify([spec, own, Object.keys(others ?? {}).length ? others : null]);
}

const newKey = () => crypto.randomUUID().replaceAll('-', '').slice(0, 24);
