import { featureName } from './features.ts';
import { circleOfEdge, featureOfEdge, partOfEdge, partsBeside } from './lines.ts';
import { knownPiece, pieceOf } from './report.ts';
import type { State } from './state.ts';
import type { Report } from './types.ts';
import { clean, lengthText, unitName } from './units.ts';

/** The bend that is picked, by its new number: the one between the same plates. */
export function pickedBend({ selection: { part }, known }: State, report: Report): string | null {
  const before = known?.flat?.bends.find((b) => b.id === part)?.between;
  if (!before || !report.flat) return part;
  const plates = (between: string[] | undefined) => JSON.stringify([...(between ?? [])].sort()),
    same = report.flat.bends.filter((b) => plates(b.between) === plates(before));
  return same.some((b) => b.id === part) ? part : (same[0]?.id ?? null);
}

/** Row of `parts` that is picked: a bend, a flange, or a plate's flange. */
export function pickedRow({ selection: { part, plate }, shape, shapeIsDraft, document }: State): number | null {
  if (shapeIsDraft && document?.kind === 'slit') return null; // it has fewer bends, with other names
  const row = (shape?.parts ?? []).findIndex((p) =>
    part !== null ? p.name === part : plate !== null && p.plate === plate,
  );
  return row < 0 ? null : row;
}

/**
 * Names of the bends that the table marks: of what is picked the bend itself, else those that its flange is joined to.
 */
export function bendsToMark(state: State): { picked: string | null; beside: Set<string> } {
  const { shape, selection } = state,
    row = shape && selection.edge !== null ? partOfEdge(shape, selection.edge) : pickedRow(state);
  const bends = (rows: Iterable<number>) =>
    [...rows].flatMap((r) => (shape?.parts[r]?.kind === 'bend' ? [shape.parts[r]!.name] : []));
  if (!shape || row === null) return { picked: selection.part, beside: new Set() };
  const [own] = bends([row]);
  return own ? { picked: own, beside: new Set() } : { picked: null, beside: new Set(bends(partsBeside(shape, row))) };
}

/** The sentence of the edge that is picked; null where none is. */
export const pickedEdgeText = (state: State): string | null =>
  state.selection.edge === null ? null : edgeText(state, state.selection.edge);

/**
 * "Edge of F2, R 3 mm, 31.42 mm long …", "Circle of F2, Ø 6.6 mm, …", "Circle of a countersink in F2, Ø 9 mm, … Drawn,
 * not cut."; null where there is no such edge.
 */
export function edgeText(state: State, edge: number): string | null {
  const { shape, units } = state,
    row = shape ? partOfEdge(shape, edge) : null;
  if (!shape || row === null) return null;
  const part = shape.parts[row]!.plate ?? shape.parts[row]!.name,
    feature = featureOfEdge(shape, edge),
    kind = feature === null ? null : featureName(pieceOf(state)?.flat?.features?.[feature]?.kind);
  const text = (length: number) => `${lengthText(length, 'mm', units)} ${unitName(units)}`,
    circle = circleOfEdge(shape, edge),
    whose = kind === null ? part : `a ${kind} in ${part}`,
    size = circle ? (circle.whole ? `Ø ${text(2 * circle.radius)}, ` : `R ${text(circle.radius)}, `) : '',
    long = `${text(circle?.length ?? shape.edge_length[edge]!)} long in the flat pattern.`;
  const what = circle?.whole ? 'Circle' : kind === null ? 'Edge' : 'Outline';
  return `${what} of ${whose}, ${size}${long}${kind === null ? '' : ' Drawn, not cut.'}`;
}

/** "B1 up 90°, R 3 mm, 50 mm long": of a bend, by its row of `parts`. */
export function bendText(state: State, row: number): string | null {
  const { shape, units } = state,
    report = pieceOf(state)?.flat ? pieceOf(state) : knownPiece(state),
    part = shape?.parts[row],
    bend = report?.flat?.bends.find((b) => b.id === part?.name);
  if (part?.kind !== 'bend') return null;
  if (!bend) return part.name;
  const text = (length: number | null) => `${lengthText(length, report?.units, units)} ${unitName(units)}`,
    radius = (bend.inside_radius ?? 0) > 0 ? `, R ${text(bend.inside_radius)}` : '';
  return `${bend.id} ${bend.direction} ${clean(bend.angle, 1)}°${radius}, ${text(bend.length)} long`;
}
