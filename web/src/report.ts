import type { State } from './state.ts';
import type { PieceReport, Shape } from './types.ts';

/** The report of what is shown: of transitions in several pieces that of the piece chosen. */
export function pieceOf(state: Pick<State, 'shape' | 'input'>): PieceReport | null {
  const report = state.shape?.report ?? null;
  const pieces = report?.pieces;
  return pieces?.length ? (pieces[Math.min(state.input.options.piece ?? 0, pieces.length - 1)] ?? report) : report;
}

/** The same of the last report that had a pattern: what is refused leaves it in sight. */
export function knownPiece(state: Pick<State, 'known' | 'input'>): PieceReport | null {
  return state.known ? pieceOf({ shape: { report: state.known } as Shape, input: state.input }) : null;
}
