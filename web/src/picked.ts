import { circleOfEdge, partOfEdge, partsBeside } from './lines.ts';
import type { State } from './state.ts';
import { lengthText, unitName } from './units.ts';

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

/** "Edge of F2, R 3 mm, 31.42 mm long", "Circle of F2, Ø 6.6 mm"; null where none is picked. */
export function pickedEdgeText({ shape, selection: { edge }, units }: State): string | null {
  const row = shape && edge !== null ? partOfEdge(shape, edge) : null;
  if (!shape || edge === null || row === null) return null;
  const { name, plate } = shape.parts[row]!;
  const text = (length: number) => `${lengthText(length, 'mm', units)} ${unitName(units)}`,
    circle = circleOfEdge(shape, edge),
    long = `${text(circle?.length ?? shape.edge_length[edge]!)} long in the flat pattern.`;
  if (circle?.whole) return `Circle of ${plate ?? name}, Ø ${text(2 * circle.radius)}, ${long}`;
  return `Edge of ${plate ?? name}, ${circle ? `R ${text(circle.radius)}, ` : ''}${long}`;
}
