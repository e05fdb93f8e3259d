import type {
  ApiProblem,
  Description,
  Example,
  MakerRow,
  OpenDocument,
  Options,
  Progress,
  Report,
  Shape,
  Spec,
  Vec2,
} from './types.ts';
import type { CurveName, FlatCurveName } from './edits/slit-types.ts';
import type { Bodies, BodyStatus } from './bodies.ts';
import type { Recent } from './recents.ts';
import { noOrder, type OrderAction, type OrderState } from './order-state.ts';
import { noMeasures, type MeasureAction, type MeasureState } from './measure/state.ts';
import { initialView, type ViewAction, type ViewState } from './view-state.ts';
import type { OpenAction } from './open-state.ts';
import type { DisplayUnit } from './units.ts';
import { emptyWorkshop, type Workshop, type WorkshopAction } from './workshop-state.ts';

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
  point: { curve: CurveName | FlatCurveName; index: number } | null;
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
  resultOf: Input | null; // of the last whole one
  earlier: Shape | null; // the whole one before the last change, with which it is compared
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
    resultOf: null,
    earlier: null,
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

/** The body that a file is shown by: the first, unless another was chosen. */
export const bodyOf = ({ input, document }: State): number =>
  typeof input.options.body === 'number' ? input.options.body : (document?.info?.bodies[0]?.number ?? 1);

/** The row of the maker that the document is of. */
export const makerOf = ({ description, document }: Pick<State, 'description' | 'document'>): MakerRow | undefined =>
  description.makers.find((m) => m.name === document?.kind);
