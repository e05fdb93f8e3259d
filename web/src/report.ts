import type { State } from './state.ts';
import type { PieceReport, Shape } from './types.ts';

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
