import type {
  ApiProblem,
  CurveName,
  Description,
  Example,
  OpenDocument,
  Options,
  PlatesSpec,
  Progress,
  Report,
  Shape,
  Spec,
  Vec2,
  Vec3,
} from './types.ts';
import { statusOfShape, type Bodies, type BodyStatus } from './bodies.ts';
import type { Recent } from './recents.ts';
import {
  noOrder,
  redoesOrder,
  redoneOrder,
  reduceOrder,
  undoesOrder,
  undoneOrder,
  type OrderAction,
  type OrderState,
} from './order-state.ts';
import { ended, forgotten, noMeasures, reduceMeasure, type MeasureAction, type MeasureState } from './measure/state.ts';
import { initialView, reduceView, type ViewAction, type ViewState } from './view-state.ts';
import { reduceOpen, type OpenAction } from './open-state.ts';
import { asBefore } from './orientation.ts';
import { pickedBend } from './picked.ts';
import { isRefused } from './report.ts';
import { millimetres, type DisplayUnit } from './units.ts';
import { emptyWorkshop, reduceWorkshop, type Workshop, type WorkshopAction } from './workshop-state.ts';

export interface Input {
  spec: Spec | null;
  options: Options;
  others?: Record<number, Options>; // what was set for one body only, of those that are not shown
}
/** What is set of a part, for the body that is shown and for the others. */
export type OptionsSet = Omit<Input, 'spec'>;
/** The input, and those that undo and redo go back and on to. */
export interface History {
  input: Input;
  past: Input[];
  future: Input[];
}
export const tabs = ['input', 'bends', 'order', 'findings', 'certificate'] as const;
export type Tab = (typeof tabs)[number];
export const severities = ['error', 'warning', 'info'] as const;
export type Severity = (typeof severities)[number];
export type Theme = 'light' | 'dark';
export type PickMode = 'none' | 'root' | 'up';
export type GizmoMode = 'translate' | 'rotate';

/**
 * What is picked: a part of the shape (bends and flanges), an edge of its outline, or a plate, an anchor, a strip or a
 * control point of the input.
 */
export interface Selection {
  part: string | null;
  edge: number | null;
  plate: string | null;
  anchor: number | null;
  strip: number | null;
  point: { curve: CurveName; index: number } | null;
  finding: number | null;
}

/** Whether the sheet is shown in the press brake, in the order that was found for it. */
export const isInMachine = ({ tab, order, input, shape, pending }: State): boolean =>
  tab === 'order' &&
  (order.answer?.strokes.length ?? 0) > 0 &&
  order.of === input &&
  !pending &&
  (shape?.facet_parent.length ?? 0) > 0;

/** A file that is being read; `long` once that takes more than half a second. */
export interface Opening {
  name: string;
  first?: boolean; // what the page begins with
  long: boolean;
  progress: Progress | null;
}

export interface State extends History {
  document: OpenDocument | null;
  given: OpenDocument | null; // of the command line
  pending: Input | null; // what the input was before a drag that has not ended
  shape: Shape | null;
  shapeIsDraft: boolean;
  shapeOf: string; // the body and the piece that the shape is of
  bodies: Bodies;
  result: Shape | null; // the last whole one: its findings stand, marked as old, while drafts are shown
  known: Report | null; // the last report with a pattern
  selection: Selection;
  hidden: Severity[]; // of findings that are left out
  fold: number;
  order: OrderState;
  measure: MeasureState;
  view: ViewState;
  workshop: Workshop;
  settingK: { kind: 'shop' | 'k_table'; file: string | null } | null; // where K shall come from, still to be chosen
  sheetsOnly: boolean; // in the list of bodies
  archive: { done: number; all: number } | null; // that is being made, in bodies
  pick: PickMode;
  gizmo: GizmoMode;
  plateSize: Vec2; // of the next plate that is added, in mm
  tab: Tab;
  units: DisplayUnit;
  theme: Theme;
  description: Description; // without rows until the server has sent it
  examples: Example[];
  recents: Recent[];
  opening: Opening | null;
  problem: ApiProblem | null;
  stale: boolean; // what is shown does not belong to this input, which could not be computed
  note: string | null;
  busy: boolean; // for longer than half a second
  computing: boolean;
  progress: Progress | null;
  help: boolean;
}

export type Action =
  | OrderAction
  | MeasureAction
  | ViewAction
  | WorkshopAction
  | { type: 'setting-k'; settingK: State['settingK'] }
  | { type: 'sheets-only'; sheetsOnly: boolean }
  | { type: 'archive'; archive: State['archive'] }
  | { type: 'description'; description: Description }
  | { type: 'examples'; examples: Example[] }
  | { type: 'recents'; recents: Recent[] }
  | { type: 'opening'; opening: Opening | null }
  | OpenAction
  | { type: 'body'; id: string; number: number; status: BodyStatus }
  | { type: 'reopened'; document: OpenDocument }
  | { type: 'history'; history: History; order?: OrderState }
  | { type: 'edit'; input: Input; live?: boolean }
  | { type: 'commit' }
  | { type: 'give-up' } // of a drag
  | { type: 'undo' }
  | { type: 'redo' }
  | { type: 'shape'; shape: Shape; draft: boolean }
  | { type: 'problem'; problem: ApiProblem; ofInput?: boolean }
  | { type: 'note'; note: string | null }
  | { type: 'computing'; computing: boolean }
  | { type: 'busy'; busy: boolean; progress?: Progress | null }
  | { type: 'select'; selection: Partial<Selection> }
  | { type: 'severity'; severity: Severity; shown: boolean }
  | { type: 'fold'; fold: number }
  | { type: 'pick'; pick: PickMode }
  | { type: 'gizmo'; gizmo: GizmoMode }
  | { type: 'plate-size'; size: Vec2 }
  | { type: 'tab'; tab: Tab }
  | { type: 'units'; units: DisplayUnit }
  | { type: 'theme'; theme: Theme }
  | { type: 'help'; help: boolean };

export const nothing: Selection = {
  part: null,
  edge: null,
  plate: null,
  anchor: null,
  strip: null,
  point: null,
  finding: null,
};

export function initialState(theme: Theme): State {
  return {
    document: null,
    given: null,
    input: { spec: null, options: {} },
    pending: null,
    past: [],
    future: [],
    shape: null,
    shapeIsDraft: false,
    shapeOf: '',
    bodies: {},
    result: null,
    known: null,
    selection: nothing,
    hidden: [],
    fold: 1,
    order: noOrder,
    measure: noMeasures,
    view: initialView,
    workshop: emptyWorkshop,
    settingK: null,
    sheetsOnly: false,
    archive: null,
    pick: 'none',
    gizmo: 'translate',
    plateSize: [100, 100],
    tab: 'input',
    units: 'mm',
    theme,
    description: { makers: [], artifacts: [] },
    examples: [],
    recents: [],
    opening: null,
    problem: null,
    stale: false,
    note: null,
    busy: false,
    computing: false,
    progress: null,
    help: false,
  };
}

const historyLength = 200;

export function reduce(state: State, action: Action): State {
  switch (action.type) {
    case 'description':
      return { ...state, description: action.description };
    case 'examples':
      return { ...state, examples: action.examples };
    case 'recents':
      return { ...state, recents: action.recents };
    case 'opening':
      return { ...state, opening: action.opening };
    case 'opened':
    case 'given':
    case 'closed':
      return reduceOpen(state, action);
    case 'body':
      return state.document?.id === action.id
        ? { ...state, bodies: { ...state.bodies, [action.number]: action.status } }
        : state;
    case 'reopened':
      return { ...state, document: action.document, problem: null };
    case 'history':
      return { ...state, ...action.history, order: action.order ?? state.order };
    case 'edit':
      return action.live
        ? { ...state, pending: state.pending ?? state.input, input: action.input, note: null }
        : edited(state, action.input);
    case 'give-up':
      return state.pending ? { ...state, input: state.pending, pending: null, note: null } : state;
    case 'commit':
      return state.pending ? edited(state, state.input) : state;
    case 'undo':
      return !state.pending && undoesOrder(state.order, state.input)
        ? { ...state, order: undoneOrder(state.order) }
        : undone(state);
    case 'redo':
      return !state.pending && redoesOrder(state.order, state.input)
        ? { ...state, order: redoneOrder(state.order) }
        : redone(state);
    case 'shape':
      return shaped(state, action.shape, action.draft);
    case 'problem':
      return {
        ...state,
        problem: action.problem,
        stale: action.ofInput ? true : state.stale,
        note: null,
        ...(action.ofInput ? { shape: withPlates(state) } : {}),
      };
    case 'note':
      return { ...state, note: action.note };
    case 'computing':
      return { ...state, computing: action.computing };
    case 'busy':
      return { ...state, busy: action.busy, progress: action.progress ?? null };
    case 'select':
      return {
        ...state,
        selection: { ...nothing, ...action.selection },
        // Another problem, such as a file that could not be opened, is done once it was read.
        problem: isRefused(state) ? state.problem : null,
      };
    case 'severity':
      return {
        ...state,
        hidden: [...state.hidden.filter((s) => s !== action.severity), ...(action.shown ? [] : [action.severity])],
      };
    case 'fold':
      return { ...state, fold: Math.min(1, Math.max(0, action.fold)) };
    case 'pick':
      return { ...state, pick: action.pick, measure: action.pick === 'none' ? state.measure : ended(state.measure) };
    case 'gizmo':
      return { ...state, gizmo: action.gizmo };
    case 'plate-size':
      return { ...state, plateSize: action.size };
    case 'tab':
      return { ...state, tab: action.tab };
    case 'units':
      return { ...state, units: action.units };
    case 'theme':
      return { ...state, theme: action.theme };
    case 'help':
      return { ...state, help: action.help };
    case 'measure-mode':
      return { ...state, pick: 'none', measure: reduceMeasure(state.measure, action) };
    case 'measure-pick':
    case 'measure-drop':
    case 'measure-remove':
    case 'measure-clear':
      return { ...state, measure: reduceMeasure(state.measure, action) };
    case 'section':
    case 'view':
      return { ...state, view: reduceView(state.view, action) };
    case 'setting-k':
      return { ...state, settingK: action.settingK, problem: problemOfInput(state) };
    case 'sheets-only':
      return { ...state, sheetsOnly: action.sheetsOnly };
    case 'archive':
      return { ...state, archive: action.archive };
    case 'dxf':
    case 'table-file':
    case 'table-forgotten':
    case 'every-part':
    case 'workshop':
      return { ...state, workshop: reduceWorkshop(state.workshop, action) };
    default:
      return { ...state, order: reduceOrder(state.order, action) };
  }
}

/** What remains once another problem, such as that of a file of options, is settled. */
const problemOfInput = ({ stale, shape, problem }: State) =>
  shape?.report.status === 'refused' ? shape.report.reason : stale ? problem : null;

function edited(state: State, input: Input): State {
  const before = state.pending ?? state.input;
  if (before === input || JSON.stringify(before) === JSON.stringify(input)) return { ...state, input, pending: null };
  return {
    ...state,
    input,
    pending: null,
    note: null,
    past: [...state.past, before].slice(-historyLength),
    future: [],
  };
}

function undone(state: State): State {
  const input = state.pending ?? state.past.at(-1);
  if (!input) return state;
  const past = state.pending ? state.past : state.past.slice(0, -1);
  return {
    ...state,
    input,
    pending: null,
    note: null,
    past,
    future: [state.input, ...state.future],
    selection: { ...state.selection, anchor: null, strip: null, point: null },
  };
}

function redone(state: State): State {
  const [input, ...future] = state.future;
  if (!input || state.pending) return state;
  return {
    ...state,
    input,
    note: null,
    past: [...state.past, state.input],
    future,
    selection: { ...state.selection, anchor: null, strip: null, point: null },
  };
}

const hasGeometry = (s: Shape | null) => s !== null && (s.facet_parent.length > 0 || s.space_triangles.length > 0);

function shaped(state: State, shape: Shape, draft: boolean): State {
  const { body, piece } = state.input.options,
    shapeOf = `${body ?? ''} ${piece ?? ''}`;
  shape = asBefore(shape, state.shapeOf === shapeOf ? state.shape : null);
  // After a refusal without a shape the last shape stays visible; the message says that it is not this input's.
  const last = hasGeometry(state.shape) ? state.shape : null,
    stale = last !== null && !hasGeometry(shape);
  const shown = !stale ? shape : { ...last!, report: shape.report, handles: withPlates(state)!.handles };
  // Edges are renumbered if their number changes.
  const alike = shown.edge_length.length === state.shape?.edge_length.length,
    edge = alike ? state.selection.edge : null,
    part = pickedBend(state, shape.report);
  return {
    ...state,
    shape: shown,
    measure: alike && state.shapeOf === shapeOf ? state.measure : forgotten(state.measure),
    shapeOf,
    selection:
      edge === state.selection.edge && part === state.selection.part
        ? state.selection
        : { ...state.selection, edge, part },
    known: tellsBends(state, shape.report, draft) ? shape.report : state.known,
    shapeIsDraft: draft,
    bodies: draft ? state.bodies : withStatus(state, shape),
    result: draft ? state.result : shown,
    problem: shape.report.status === 'refused' ? shape.report.reason : null,
    note: shape.report.status === 'refused' ? null : state.note,
    stale,
  };
}

/**
 * The last shape, with the plates of an input that cannot be computed, so that they can still be seen and dragged.
 */
function withPlates({ shape, document, input }: State): Shape | null {
  if (!shape || document?.kind !== 'connect') return shape;
  const { plates, units } = input.spec as PlatesSpec,
    scale = millimetres(units);
  return {
    ...shape,
    handles: {
      ...shape.handles,
      plates: plates.map((p) => ({ id: p.id, corners: p.outline.map((c) => c.map((v) => v * scale) as Vec3) })),
    },
  };
}

/** The body that a file is shown by: the first, unless another was chosen. */
export const bodyOf = ({ input, document }: State): number =>
  typeof input.options.body === 'number' ? input.options.body : (document?.info?.bodies[0]?.number ?? 1);

const withStatus = (state: State, shape: Shape): Bodies =>
  (state.document?.info?.bodies.length ?? 0) > 1
    ? { ...state.bodies, [bodyOf(state)]: statusOfShape(shape, state.input.options) }
    : state.bodies;

/** Drafts of slit sheets leave out what the bends are. */
const tellsBends = (state: State, report: Report, draft: boolean) =>
  draft && state.document?.kind === 'slit' ? false : report.flat !== null || Boolean(report.pieces?.length);

export type Listener = (state: State, before: State) => void;

export class Store {
  state: State;
  private readonly listeners: Listener[] = [];
  constructor(state: State) {
    this.state = state;
  }
  subscribe(listener: Listener) {
    this.listeners.push(listener);
  }
  dispatch = (action: Action) => {
    const before = this.state;
    this.state = reduce(before, action);
    if (this.state !== before) for (const listener of this.listeners) listener(this.state, before);
  };
}
