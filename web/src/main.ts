import { nothing, render } from 'lit-html';
import { Api } from './api.ts';
import { Archive } from './archive.ts';
import { Computation, problemOf } from './compute.ts';
import { Documents } from './documents.ts';
import { isOtherOrder, shownBend } from './order-state.ts';
import { followStroke, OrderWork } from './order-work.ts';
import { phases } from './stage.ts';
import { drawsPage } from './drawing.ts';
import { giveUp, isGivenUp } from './holding.ts';
import { keepHistory, keepOrder } from './kept.ts';
import { removePlate } from './edits/connect.ts';
import { withoutChosen } from './edits/flat-curves.ts';
import { MeasureKeys } from './measure/keys.ts';
import { escapeMeasuring, measureList } from './panels/measures.ts';
import { flatDetail, flatText, foldedDetail, foldedText } from './described.ts';
import { flatTitle } from './panels/legend.ts';
import { messageBar } from './panels/message-bar.ts';
import { foldBar, helpDialog, showHelp, viewButtons } from './panels/overlays.ts';
import { startScreen } from './panels/start.ts';
import { machineLegend, strokeBar } from './panels/stroke-bar.ts';
import { switchSection, viewTools } from './panels/section.ts';
import { sidePanel } from './panels/side-panel.ts';
import { chooseFile, topBar } from './panels/top-bar.ts';
import { arrangeViews, divider } from './split.ts';
import { Survey } from './survey.ts';
import { initialState, isInMachine, type Theme } from './state.ts';
import { Store } from './store.ts';
import './styles/styles.ts';
import { bringKept } from './kept-here.ts';
import { Recents } from './recents.ts';
import { sayRefusals } from './refusals.ts';
import type { Options, Spec } from './types.ts';
import type { PlatesSpec } from './edits/plates-types.ts';
import type { SlitSpec } from './edits/slit-types.ts';
import type { Ui } from './ui.ts';
import { beginsAnew, isUnentered, putBack } from './typing.ts';
import { Views } from './views.ts';

window.planishTimings = [];
const api = new Api(location.hash.slice(1));
const store = new Store(initialState(matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'));
document.documentElement.dataset.theme = store.state.theme;

const root = document.getElementById('app')!;
root.innerHTML = `<header></header><section class="messages" aria-label="Messages"></section><main>
  <div class="view folded"><div class="canvas" role="img" aria-describedby="folded-detail"></div>
  <p id="folded-detail" hidden></p>
  <div class="buttons"></div><div class="tools"></div><div class="measured"></div>
  <div class="machine"></div><div class="fold"></div></div>
  <div class="divider"></div>
  <div class="view flat"><div class="canvas" role="img" aria-describedby="flat-detail"></div>
  <p id="flat-detail" hidden></p><div class="title"></div></div>
  <div class="over"></div></main><aside></aside><div class="dialogs"></div>`;
const part = (selector: string) => root.querySelector<HTMLElement>(selector)!;

const ui: Ui = {
  get state() {
    return store.state;
  },
  dispatch: store.dispatch,
  edit: (change, live = false) => {
    const { input } = store.state;
    if (!input.spec || (live && isGivenUp())) return;
    if (live) computation.dragged(performance.now());
    store.dispatch({
      type: 'edit',
      input: { ...input, spec: (change as unknown as (s: Spec) => Spec)(input.spec) },
      live,
    });
  },
  editOptions: (change, live = false) => {
    const { input } = store.state;
    if (live && isGivenUp()) return;
    store.dispatch({ type: 'edit', input: { ...input, options: withoutHoles(change(input.options)) }, live });
  },
  refusal: (options) => {
    const { document: d, input } = store.state;
    return d
      ? api.draft(d.id, { spec: input.spec ?? undefined, options: withoutHoles(options) }).then(() => null, problemOf)
      : Promise.resolve(null);
  },
  commit: () => store.dispatch({ type: 'commit' }),
  faceUp: (upper) => void faceUp(upper),
  openFiles: (files) => void documents.openFiles([...files]),
  openNew: (file) => void documents.openFiles([file], true),
  openExample: (name) => void documents.openExample(name),
  openRecent: (recent) => void documents.openRecent(recent),
  forgetRecents: () => recents.forget(),
  openGiven: () => void documents.openGiven(),
  close: () => documents.close(),
  download,
  downloadAll: () => void archive.start(),
  cancelArchive: () => archive.cancel(),
  finish: () => computation.finish(),
  cancel: () => (store.state.opening ? documents.cancel() : computation.cancel()),
  look: (view) => views.folded.look(view),
  light: (part) => views.light(part === null ? null : { part }),
  fit: () => views.fit(),
  animate,
  askOrder: (order) => orderWork.ask(order),
  cancelOrder: () => orderWork.cancel(),
  showStroke: (stroke) => showTime(stroke + phases.pressed),
  showTime,
  playStrokes,
  setTheme: (theme: Theme) => {
    document.documentElement.dataset.theme = theme;
    store.dispatch({ type: 'theme', theme });
  },
};
const views = new Views(
  ui,
  part('.folded .canvas'),
  part('.flat .canvas'),
  (at) => computation.dragged(at),
  () => store.state.document && computation.zoomed(),
);
const { light } = ui;
const measureKeys = new MeasureKeys(ui, views.measuring, {
  flat: { box: part('.flat .canvas'), toClient: ([x, y]) => views.flat.project([x, y]), isSeen: () => true, light },
  folded: {
    box: part('.folded .canvas'),
    toClient: (at) => views.folded.project(at),
    isSeen: (at) => views.folded.under.isSeen(at),
    light,
  },
});
const computation = new Computation(
  api,
  store,
  () => documents.reopen(),
  (shown) => views.chord(shown),
);
const recents = new Recents(api, store);
const documents = new Documents(api, store, recents);
new Survey(api, store);
const archive = new Archive(api, store, saveFile);
const orderWork = new OrderWork(api, store, () => documents.reopen());

let scrolledFor: string | undefined;
store.subscribe((state, before) => {
  views.changed(state, before);
  measureKeys.changed(state, before);
});
const drawWaiting = drawsPage(store, draw);

arrangeViews(store, part('main'));

let pickedBefore = store.state.selection;

function draw() {
  root.classList.toggle('stale', store.state.stale && store.state.shape !== null);
  render(topBar(ui), part('header'));
  render(messageBar(ui), part('.messages'));
  render(sidePanel(ui), part('aside'));
  if (store.state.document?.id !== scrolledFor) {
    scrolledFor = store.state.document?.id;
    part('.content').scrollTop = 0;
  }
  if (store.state.selection !== pickedBefore && getComputedStyle(part('.content')).overflowY !== 'visible')
    root.querySelector('aside tr.selected, aside tr.beside, aside li.selected')?.scrollIntoView({ block: 'nearest' });
  pickedBefore = store.state.selection;
  render(isInMachine(store.state) ? strokeBar(ui) : foldBar(ui), part('.fold'));
  render(isInMachine(store.state) ? machineLegend(ui) : nothing, part('.machine'));
  render(viewButtons(ui), part('.buttons'));
  render(
    viewTools(ui, {
      direction: () => views.folded.direction,
      lengthAlong: (along) => views.folded.under.lengthAlong(along),
    }),
    part('.tools'),
  );
  render(divider(ui, part('main')), part('.divider'));
  render(measureList(ui), part('.measured'));
  root.classList.toggle('measuring', store.state.measure.on);
  render(flatTitle(ui), part('.flat .title'));
  const over = startScreen(ui);
  render(over, part('.over'));
  for (const below of root.querySelectorAll<HTMLElement>('.view, .divider')) below.inert = over !== nothing;
  render(helpDialog(ui), part('.dialogs'));
  showHelp(store.state.help);
  describeViews();
}

/** What the pictures show, for those who cannot see them. */
function describeViews() {
  part('.folded .canvas').ariaLabel = foldedText(store.state);
  part('.flat .canvas').ariaLabel = flatText(store.state);
  part('#folded-detail').textContent = foldedDetail(store.state);
  part('#flat-detail').textContent = flatDetail(store.state);
}

const withoutHoles = (o: Options) =>
  Object.fromEntries(Object.entries(o).filter(([, v]) => v !== undefined)) as Options;

async function download(artifact: string, suffix: string, more: Partial<Options> = {}) {
  const { document: d, input } = store.state;
  if (!d) return;
  try {
    const blob = await api.file(d.id, artifact, {
      spec: input.spec ?? undefined,
      options: withoutHoles({ ...input.options, ...more }),
    });
    saveFile(blob, fileName(d.name, artifact, suffix, input.options.piece));
  } catch (error) {
    store.dispatch({ type: 'problem', problem: problemOf(error) });
  }
}

function saveFile(blob: Blob, name: string) {
  const link = document.createElement('a'),
    url = URL.createObjectURL(blob);
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** "part.dxf", "part-flat.step" of the artifact "flat.step", "part-report.json" beside the edited "part.json". */
function fileName(name: string, artifact: string, suffix: string, piece?: number): string {
  const stem = name.replace(/\.[^.]*$/, '') + (piece ? `-${piece + 1}` : ''),
    more =
      artifact === 'json' ? '-report' : artifact.includes('.') ? `-${artifact.slice(0, artifact.indexOf('.'))}` : '';
  return stem + more + suffix;
}

/** Options name a side by the skin that is unfolded; which of the two that is, the shape with this one up shows. */
async function faceUp(upper: boolean) {
  const { document: d, input, shape } = store.state;
  if (!d || !shape) return;
  try {
    const reference = await api.draft(d.id, { options: { ...input.options, up: 'reference' } });
    const along = [2, 6, 10].reduce((sum, i) => sum + (shape.root[i] ?? 0) * (reference.root[i] ?? 0), 0);
    ui.editOptions((o) => ({ ...o, up: along > 0 === upper ? 'reference' : 'other' }));
  } catch (error) {
    store.dispatch({ type: 'problem', problem: problemOf(error) });
  }
}

let animation = 0;
function animate() {
  cancelAnimationFrame(animation);
  const from = store.state.fold,
    to = from > 0.5 ? 0 : 1;
  if (matchMedia('(prefers-reduced-motion: reduce)').matches) return store.dispatch({ type: 'fold', fold: to });
  const start = performance.now(),
    duration = 900 * Math.abs(to - from);
  const step = (now: number) => {
    const t = Math.min(1, Math.max(0, (now - start) / duration)),
      eased = t * t * (3 - 2 * t);
    store.dispatch({ type: 'fold', fold: t === 1 ? to : from + (to - from) * eased });
    if (t < 1) animation = requestAnimationFrame(step);
  };
  animation = requestAnimationFrame(step);
}

/** A time within the strokes; the bend that is pressed then is picked, here and in the flat pattern. */
function showTime(time: number, playing = false) {
  store.dispatch({ type: 'stroke-time', time, playing });
  const { order, selection } = store.state,
    bend = shownBend(order);
  if (bend !== undefined && bend !== selection.part) store.dispatch({ type: 'select', selection: { part: bend } });
}

const strokeSeconds = 2.6;
function playStrokes() {
  const { order } = store.state,
    most = order.answer?.strokes.length ?? 0;
  if (order.playing) return showTime(order.time);
  showTime(order.time >= most - (1 - phases.pressed) ? 0 : order.time, true);
  let last = performance.now();
  const step = (now: number) => {
    if (!store.state.order.playing) return;
    if (!isInMachine(store.state)) return showTime(store.state.order.time);
    showTime(store.state.order.time + (now - last) / 1000 / strokeSeconds, true);
    last = now;
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

const views1 = ['front', 'top', 'right', 'iso'] as const;
window.addEventListener('keydown', (e) => {
  const target = e.target as HTMLElement,
    typing = target.matches('input:not([type=range]):not([type=checkbox]), select, textarea');
  const key = e.key.toLowerCase();
  if (e.ctrlKey || e.metaKey) {
    if (key === 'o') chooseFile();
    else if (!(key === 'z' || key === 'y') || isUnentered(target)) return;
    else step(key === 'y' || e.shiftKey ? 'redo' : 'undo', target);
    e.preventDefault();
    return;
  }
  if (key === 'escape') return escape(target);
  if (typing || e.altKey) return;
  const view = views1[Number(key) - 1];
  if (view) ui.look(view);
  else if (key === 'f') ui.fit();
  else if (key === 'x') switchSection(ui, views.folded.direction);
  else if (key === 'g') store.dispatch({ type: 'view', view: { seeThrough: !store.state.view.seeThrough } });
  else if (key === 'd') {
    store.dispatch({ type: 'measure-mode', on: !store.state.measure.on });
    drawWaiting(); // what has the focus is described by then
    measureKeys.focus();
  } else if (key === ' ' && !target.matches('button, summary, input[type=checkbox]')) {
    if (isInMachine(store.state)) playStrokes();
    else animate();
    e.preventDefault();
  } else if (key === '?') store.dispatch({ type: 'help', help: !store.state.help });
  else if (key === 'm') store.dispatch({ type: 'gizmo', gizmo: 'translate' });
  else if (key === 't') store.dispatch({ type: 'gizmo', gizmo: 'rotate' });
  else if (key === 'delete' || key === 'backspace') removeChosen();
});

function step(type: 'undo' | 'redo', target: HTMLElement) {
  if (store.state.pending) giveUp();
  store.dispatch({ type });
  drawWaiting();
  beginsAnew(target);
}

function escape(target: HTMLElement) {
  if (store.state.pending) {
    giveUp();
    return store.dispatch({ type: 'give-up' });
  }
  putBack(target);
  target.blur();
  root.querySelectorAll('details.menu[open]').forEach((m) => {
    m.removeAttribute('open');
    if (m.contains(target)) m.querySelector('summary')!.focus();
  });
  if (!store.state.help && escapeMeasuring(ui)) return;
  store.dispatch({ type: 'help', help: false });
  store.dispatch({ type: 'pick', pick: 'none' });
  store.dispatch({ type: 'select', selection: {} });
}

function removeChosen() {
  const { anchor, plate, point } = store.state.selection,
    { spec } = store.state.input;
  if (point || anchor !== null) ui.edit<SlitSpec>((s) => withoutChosen(s, point, anchor));
  else if (plate !== null && (spec as PlatesSpec).plates.length > 1) ui.edit<PlatesSpec>((s) => removePlate(s, plate));
  else return;
  store.dispatch({ type: 'select', selection: {} });
}

/** Where the focus goes whose place has gone: the name of what is open, or how one begins. */
store.subscribe((state, before) => {
  if (state.document?.id === before.document?.id) return;
  requestAnimationFrame(() => {
    if (document.activeElement === document.body) part(state.document ? '.name' : '[data-testid=start-open]').focus();
  });
});

window.addEventListener('pointerdown', (e) => {
  root.querySelectorAll('details.menu[open]').forEach((m) => {
    if (!m.contains(e.target as Node)) m.removeAttribute('open');
  });
});
window.addEventListener('dragover', (e) => {
  e.preventDefault();
  root.classList.add('dropping');
});
window.addEventListener('dragleave', (e) => {
  if (!e.relatedTarget) root.classList.remove('dropping');
});
window.addEventListener('drop', (e) => {
  e.preventDefault();
  root.classList.remove('dropping');
  if (e.dataTransfer?.files.length) ui.openFiles([...e.dataTransfer.files]);
});
sayRefusals(store);
followStroke(store);
window.addEventListener('pagehide', () => documents.hidden());
store.subscribe((state, before) => {
  const changed = state.input !== before.input || before.pending !== null; // a drag that ends
  if (changed && !state.pending) keepHistory(state);
  if ((changed && !state.pending) || isOtherOrder(state.order, before.order)) keepOrder(state);
});

void documents.begin(bringKept(api, store));
draw();
api.description().then(
  (description) => store.dispatch({ type: 'description', description }),
  (error) => store.dispatch({ type: 'problem', problem: problemOf(error) }),
);
api.examples().then(
  (examples) => store.dispatch({ type: 'examples', examples }),
  (error) => store.dispatch({ type: 'problem', problem: problemOf(error) }),
);

/** Lets the server know that a page is open. Browsers allow few connections to a server, so one of its pages does. */
async function stay() {
  for (let needed = true; needed; await new Promise((resolve) => setTimeout(resolve, 5000)))
    needed = await api.stay().catch(() => true);
}
void navigator.locks.request('planish-open', stay);
Object.assign(window, { planish: { store, views, measureKeys } }); // for tests, and for the curious
