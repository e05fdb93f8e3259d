import type { BendRow, PieceReport } from './types.ts';

/** Whether K of a bend is the program's own, which nobody has chosen. */
export const isDefaultK = (bend: Pick<BendRow, 'k_source'>) => bend.k_source === 'default';

/** The K that somebody should confirm; null if every bend has one that was chosen. */
export const unconfirmedK = (report: PieceReport | null): number | null =>
  report?.flat?.bends.find(isDefaultK)?.k_factor ?? null;
