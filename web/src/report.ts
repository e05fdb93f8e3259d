import type { State } from './state.ts';
import type { PieceReport, Shape, Vec2 } from './types.ts';

/** The report of what is shown: of transitions in several pieces that of the piece chosen. */
export function pieceOf(state: Pick<State, 'shape' | 'input'>): PieceReport | null {
  const report = state.shape?.report ?? null;
  const pieces = report?.pieces;
  return pieces?.length ? (pieces[Math.min(state.input.options.piece ?? 0, pieces.length - 1)] ?? report) : report;
}

/** The same for the last report with a pattern, which stays visible after a refusal. */
export function knownPiece(state: Pick<State, 'known' | 'input'>): PieceReport | null {
  return state.known ? pieceOf({ shape: { report: state.known } as Shape, input: state.input }) : null;
}

/** Whether a report knows a place or a size: coordinates that could not be measured are null. */
export const isKnown = (at: readonly (number | null)[]): at is Vec2 => at.every((v) => v !== null);

/** Whether no file can be made of the input as it is: only what says why. */
export const isRefused = ({ shape, stale }: Pick<State, 'shape' | 'stale'>): boolean =>
  stale || shape?.report.status === 'refused';

/** Whether there is a pattern of this input, with flanges to choose and a side to turn up. */
export const hasFlanges = ({ shape, stale }: Pick<State, 'shape' | 'stale'>): boolean =>
  !stale && Boolean(shape?.facet_parent.length);
