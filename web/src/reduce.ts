import { statusOfShape, type Bodies } from './bodies.ts';
import { ended, forgotten, reduceMeasure } from './measure/state.ts';
import { reduceOpen } from './open-state.ts';
import { redoesOrder, redoneOrder, reduceOrder, undoesOrder, undoneOrder } from './order-state.ts';
import { asBefore } from './orientation.ts';
import { pickedBend } from './picked.ts';
import { isRefused } from './report.ts';
import { bodyOf, nothing, type Action, type Input, type State } from './state.ts';
import { platesIn } from './edits/plates-types.ts';
import type { Report, Shape, Vec3 } from './types.ts';
import { millimetres } from './units.ts';
import { reduceView } from './view-state.ts';
import { reduceWorkshop } from './workshop-state.ts';

const historyLength = 200;

export function reduce(state: State, action: Action): State {
  switch (action.type) {
    case 'description':
    case 'examples':
    case 'recents':
    case 'opening':
    case 'note':
    case 'computing':
    case 'gizmo':
    case 'tab':
    case 'units':
    case 'theme':
    case 'help':
    case 'sheets-only':
    case 'archive':
      return { ...state, ...named(action) };
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
    case 'plate-size':
      return { ...state, plateSize: action.size };
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

/** What an action says, by the names that the state has for it. */
const named = <A extends { type: string }>({ type: _, ...said }: A): Omit<A, 'type'> => said;

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
    resultOf: draft ? state.resultOf : state.input,
    earlier: !state.result ? null : draft || state.resultOf === state.input ? state.earlier : state.result,
    problem: shape.report.status === 'refused' ? shape.report.reason : null,
    note: shape.report.status === 'refused' ? null : state.note,
    stale,
  };
}

/**
 * The last shape, with the plates of an input that cannot be computed, so that they can still be seen and dragged.
 */
function withPlates({ shape, input }: State): Shape | null {
  const spec = platesIn(input.spec);
  if (!shape || !spec) return shape;
  const scale = millimetres(spec.units);
  return {
    ...shape,
    handles: {
      ...shape.handles,
      plates: spec.plates.map((p) => ({ id: p.id, corners: p.outline.map((c) => c.map((v) => v * scale) as Vec3) })),
    },
  };
}

const withStatus = (state: State, shape: Shape): Bodies =>
  (state.document?.info?.bodies.length ?? 0) > 1
    ? { ...state.bodies, [bodyOf(state)]: statusOfShape(shape, state.input.options) }
    : state.bodies;

/** Drafts of slit sheets leave out what the bends are. */
const tellsBends = (state: State, report: Report, draft: boolean) =>
  draft && state.document?.kind === 'slit' ? false : report.flat !== null || Boolean(report.pieces?.length);
