import type { Api } from './api.ts';
import { recentList, type Recent } from './recents.ts';
import type { State } from './state.ts';
import type { Store } from './store.ts';
import { keepView, soundView, viewFile } from './split.ts';
import { soundWorkshop } from './workshop-state.ts';

const workshop = 'workshop.json';

type Shared = Pick<State, 'workshop' | 'recents'>;

function take(store: Store, { workshop, recents }: Partial<Shared>) {
  if (workshop) store.dispatch({ type: 'workshop', workshop });
  if (recents) store.dispatch({ type: 'recents', recents });
}

/** Brings what was kept on this machine at an earlier start, and keeps what changes from then on. */
export async function bringKept(api: Api, store: Store) {
  // Pages of this browser: each takes over what another keeps. What is said while this one reads is newer than that.
  const others = new BroadcastChannel('planish-kept');
  let heard: Partial<Shared> = {};
  others.onmessage = ({ data }: MessageEvent<Partial<Shared>>) => void (heard = { ...heard, ...data });
  const names = new Set((await api.keptNames().catch(() => [])).map((f) => f.name));
  const read = async (name: string): Promise<unknown> => {
    try {
      return names.has(name) ? JSON.parse(new TextDecoder().decode(await api.kept(name))) : null;
    } catch {
      return null; // damaged, or of another version
    }
  };
  const [kept, recents, view] = await Promise.all([workshop, recentList, viewFile].map(read));
  take(store, {
    workshop: kept ? soundWorkshop(kept) : undefined,
    recents: Array.isArray(recents) ? recents.filter(isSound) : undefined,
    ...heard,
  });
  if (view && typeof view === 'object') store.dispatch({ type: 'view', view: soundView(view) });
  others.onmessage = ({ data }: MessageEvent<Partial<Shared>>) => {
    heard = data;
    take(store, data);
  };
  store.subscribe((state, before) => {
    if (state.recents !== before.recents && state.recents !== heard.recents)
      others.postMessage({ recents: state.recents });
    if (state.view.split !== before.view.split || state.view.arrangement !== before.view.arrangement)
      keepView(api, state.view);
    if (state.workshop === before.workshop || state.workshop === heard.workshop) return;
    others.postMessage({ workshop: state.workshop });
    api
      .keep(workshop, new Blob([JSON.stringify(state.workshop)]))
      .catch(() =>
        store.dispatch({ type: 'note', note: 'This machine has no room left to keep this for the next part.' }),
      );
  });
}

const isSound = (recent: Recent) =>
  typeof recent?.key === 'string' && typeof recent.name === 'string' && Array.isArray(recent.beside);
