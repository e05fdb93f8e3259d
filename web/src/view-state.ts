import type { Vec3 } from './types.ts';

export type Arrangement = 'beside' | 'stacked';
export type SectionAxis = 'x' | 'y' | 'z' | 'view';

/** How the views are shown: not of a file, except for the section. */
export interface ViewState {
  section: { on: boolean; axis: SectionAxis; along: Vec3; at: number; flipped: boolean }; // at: share of the part
  seeThrough: boolean;
  bending: boolean; // coloured by how sharply it is bent
  arrangement: Arrangement | null; // that was chosen; null: by the pattern
  suggested: Arrangement; // by the pattern
  split: number; // share of the folded view
}

export type ViewAction =
  | { type: 'section'; section: Partial<ViewState['section']> }
  | { type: 'view'; view: Partial<Omit<ViewState, 'section'>> };

export const evenly = 0.5;
export const [leastSplit, mostSplit] = [0.28, 0.85]; // the buttons of the folded view need that much

export const noSection: ViewState['section'] = { on: false, axis: 'x', along: [1, 0, 0], at: 0.5, flipped: false };

export const initialView: ViewState = {
  section: noSection,
  seeThrough: false,
  bending: false,
  arrangement: null,
  suggested: 'beside',
  split: evenly,
};

export function reduceView(state: ViewState, action: ViewAction): ViewState {
  if (action.type === 'section') return { ...state, section: { ...state.section, ...action.section } };
  const split = action.view.split ?? state.split;
  return { ...state, ...action.view, split: Math.min(mostSplit, Math.max(leastSplit, split)) };
}

export const arrangementOf = ({ arrangement, suggested }: ViewState): Arrangement => arrangement ?? suggested;

const clearly = 1.3; // times as large a pattern is worth another arrangement

/** How views of `width` × `height` together are best arranged for a pattern of a size: beside, unless it is wide. */
export function arrangementFor([w, h]: [number, number], width: number, height: number): Arrangement {
  const border = 60, // for dimensions
    scale = (across: number, up: number) => Math.min((across - border) / w, (up - border) / h);
  return scale(width, height / 2) > clearly * scale(width / 2, height) ? 'stacked' : 'beside';
}
