import type { Bodies } from './bodies.ts';
import { noOrder } from './order-state.ts';
import { initialState, type OptionsSet, type State } from './state.ts';
import type { OpenDocument, Options, Spec } from './types.ts';
import type { DisplayUnit } from './units.ts';
import { noSection } from './view-state.ts';

/** `set`: the options that it was left with, when it was opened before. */
export type OpenAction =
  | { type: 'opened'; document: OpenDocument; spec: Spec | null; body?: number; bodies?: Bodies; set?: OptionsSet }
  | { type: 'given'; document: OpenDocument }
  | { type: 'closed' };

/** A document takes the place of another one, or nothing does. */
export function reduceOpen(state: State, action: OpenAction): State {
  if (action.type === 'given') return { ...state, given: action.document };
  const anew: State = {
    ...initialState(state.theme),
    description: state.description,
    examples: state.examples,
    recents: state.recents,
    given: state.given,
    order: { ...noOrder, brake: state.order.brake },
    view: { ...state.view, section: noSection },
    workshop: state.workshop,
  };
  if (action.type === 'closed') return { ...anew, units: state.units };
  const { document, spec, body, bodies, set } = action,
    { options, ...others } = set ?? { options: spec ? {} : partOptions(state) };
  return {
    ...anew,
    units: unitsOf(document, spec),
    document,
    input: { spec, options: { ...options, ...(body === undefined ? {} : { body }) }, ...others },
    bodies: bodies ?? {},
    tab: state.document?.kind === document.kind ? state.tab : 'input',
  };
}

/** What is set on this machine for every part to unfold that is opened. */
export const partOptions = ({ workshop }: State): Options => workshop.everyPart ?? {};

/** The page uses the unit of the file. */
const unitsOf = (document: OpenDocument, spec: Spec | null): DisplayUnit =>
  spec?.units === 'inch' || /^inch/i.test(document.info?.file_units ?? '') ? 'inch' : 'mm';
