import type { MeasuredView, Ref } from './things.ts';

/** Something measured: between two things, or of one alone. */
export interface Measure {
  id: number;
  view: MeasuredView;
  a: Ref;
  b: Ref | null;
}

export interface MeasureState {
  on: boolean;
  first: { view: MeasuredView; ref: Ref } | null;
  kept: Measure[];
  next: number; // id
}

export type MeasureAction =
  | { type: 'measure-mode'; on: boolean }
  | { type: 'measure-pick'; view: MeasuredView; ref: Ref }
  | { type: 'measure-drop' } // what was picked first
  | { type: 'measure-remove'; id: number }
  | { type: 'measure-clear' };

export const noMeasures: MeasureState = { on: false, first: null, kept: [], next: 1 };

export function reduceMeasure(state: MeasureState, action: MeasureAction): MeasureState {
  switch (action.type) {
    case 'measure-mode':
      return { ...state, on: action.on, first: null };
    case 'measure-pick': {
      const { view, ref } = action,
        { first, kept, next } = state;
      if (first?.view !== view) return { ...state, first: { view, ref } };
      return {
        ...state,
        first: null,
        kept: [...kept, { id: next, view, a: first.ref, b: isSame(first.ref, ref) ? null : ref }],
        next: next + 1,
      };
    }
    case 'measure-drop':
      return { ...state, first: null };
    case 'measure-remove':
      return { ...state, kept: state.kept.filter((m) => m.id !== action.id) };
    case 'measure-clear':
      return { ...state, first: null, kept: [] };
  }
}

/** Without measuring on: what was measured stays. */
export const ended = (state: MeasureState): MeasureState => (state.on ? { ...state, on: false, first: null } : state);

/** Edges of another shape have other numbers: what refers to them is gone. */
export const forgotten = (state: MeasureState): MeasureState =>
  state.first || state.kept.length ? { ...state, first: null, kept: [] } : state;

/** Whether two picks mean the same thing; a flange is the same wherever it is picked. */
export const isSame = (a: Ref, b: Ref): boolean =>
  JSON.stringify({ ...a, at: null }) === JSON.stringify({ ...b, at: null });
