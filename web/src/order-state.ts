import type { Input } from './state.ts';
import type { ApiProblem, BrakeOptions, OrderAnswer, OrderedStroke } from './types.ts';

/** The order of strokes: what was asked for, what came of it, and where one looks. */
export interface OrderState {
  brake: BrakeOptions;
  answer: OrderAnswer | null;
  of: Input | null; // what the answer is of
  ofBrake: BrakeOptions | null;
  given: boolean; // the order was changed by hand
  asked: OrderedStroke[] | null; // the order that is being checked
  computing: boolean;
  problem: ApiProblem | null;
  time: number; // strokes, with the share of the one that is being made
  playing: boolean;
  past: Answered[]; // of the same input, for undo
  future: Answered[];
}

export type Answered = Pick<OrderState, 'answer' | 'ofBrake' | 'given'>;

export type OrderAction =
  | { type: 'brake'; brake: BrakeOptions }
  | { type: 'order-asked'; asked: OrderedStroke[] | null }
  | { type: 'order'; answer: OrderAnswer; of: Input; ofBrake: BrakeOptions; asked: OrderedStroke[] | null }
  | { type: 'order-problem'; problem: ApiProblem | null }
  | { type: 'stroke-time'; time: number; playing?: boolean };

export const noOrder: OrderState = {
  brake: {},
  answer: null,
  of: null,
  ofBrake: null,
  given: false,
  asked: null,
  computing: false,
  problem: null,
  time: 0,
  playing: false,
  past: [],
  future: [],
};

export function reduceOrder(state: OrderState, action: OrderAction): OrderState {
  switch (action.type) {
    case 'brake':
      return { ...state, brake: action.brake };
    case 'order-asked':
      return { ...state, asked: action.asked, computing: true, problem: null, playing: false };
    case 'order': {
      const { answer, of, ofBrake, asked } = action,
        most = answer.strokes.length,
        same = state.answer !== null && state.of === of,
        repeated = same && state.ofBrake === ofBrake && isOrder(state.answer!, orderOf(answer));
      return {
        ...state,
        answer,
        of,
        ofBrake,
        given: asked !== null,
        asked: null,
        computing: false,
        problem: null,
        time: asked === null ? 0 : Math.min(state.time, most),
        past: repeated ? state.past : same ? [...state.past, answeredBy(state)].slice(-mostPast) : [],
        future: repeated ? state.future : [],
      };
    }
    case 'order-problem':
      return { ...state, computing: false, asked: null, problem: action.problem };
    case 'stroke-time': {
      const most = state.answer?.strokes.length ?? 0;
      return {
        ...state,
        time: Math.min(most, Math.max(0, action.time)),
        playing: (action.playing ?? false) && action.time < most,
      };
    }
  }
}

const mostPast = 100;
const answeredBy = ({ answer, ofBrake, given }: OrderState): Answered => ({ answer, ofBrake, given });

/** Whether the last thing done to an input, which undo takes back, was another order of its strokes. */
export const undoesOrder = ({ past, of }: OrderState, input: Input) => past.length > 0 && of === input;
export const redoesOrder = ({ future, of }: OrderState, input: Input) => future.length > 0 && of === input;

export function undoneOrder(state: OrderState): OrderState {
  if (state.computing) return state;
  const answered = state.past.at(-1)!,
    future = [answeredBy(state), ...state.future];
  return shownAgain({ ...state, ...answered, past: state.past.slice(0, -1), future });
}

export function redoneOrder(state: OrderState): OrderState {
  if (state.computing) return state;
  const [answered, ...future] = state.future;
  return shownAgain({ ...state, ...answered!, past: [...state.past, answeredBy(state)], future });
}

const shownAgain = (state: OrderState): OrderState => ({
  ...state,
  problem: null,
  playing: false,
  time: Math.min(state.time, state.answer?.strokes.length ?? 0),
});

/** The bend that is pressed at the time that one looks at. */
export const shownBend = ({ answer, time }: OrderState): string | undefined =>
  answer?.strokes[Math.min(Math.floor(time), answer.strokes.length - 1)]?.bends[0];

/** Whether more than the place that one looks at has changed. */
export const isOtherOrder = (a: OrderState, b: OrderState) =>
  a.answer !== b.answer || a.brake !== b.brake || a.past !== b.past || a.future !== b.future;

/** The strokes in the order that is asked for: those shown, moved where that is being checked. */
export const orderOf = (answer: OrderAnswer): OrderedStroke[] =>
  answer.strokes.map(({ bends, press_line, flattening }) => ({ bends, press_line, flattening }));

const isOrder = (answer: OrderAnswer, order: OrderedStroke[]) =>
  JSON.stringify(orderOf(answer)) === JSON.stringify(order);

/** An order with the stroke of one place moved to another. */
export function moved<T>(rows: T[], from: number, to: number): T[] {
  const rest = rows.filter((_, i) => i !== from);
  return [...rest.slice(0, to), rows[from]!, ...rest.slice(to)];
}

export const nameOf = ({ bends, press_line, flattening }: OrderedStroke) =>
  bends.join(' ') + (press_line ? ` line ${press_line}` : '') + (flattening ? ' closed' : '');
