import type { Shape } from '../types.ts';
import { clean, lengthText, unitName, type DisplayUnit } from '../units.ts';
import type { Answer } from './answer.ts';
import { edgeForms } from './edges.ts';
import type { Ref } from './things.ts';

const mark = { diameter: 'Ø ', radius: 'R ', distance: '', length: '', angle: '' };

/** What stands at the dimension line: "40 mm", "Ø 6 mm", "90°". */
export const labelText = ({ value, of }: Answer, units: DisplayUnit): string =>
  of === 'angle' ? `${clean(value, 2)}°` : `${mark[of]}${lengthText(value, 'mm', units)} ${unitName(units)}`;

/** All that was measured: "40 mm, dx 40, dy 0, between rims 34, Ø 6, Ø 6". */
export const wholeText = (answer: Answer, units: DisplayUnit): string =>
  [
    labelText(answer, units),
    ...answer.more.map(({ name, value }) =>
      name === 'bend' ? `bend ${clean(value, 2)}°` : `${name} ${lengthText(value, 'mm', units)}`,
    ),
  ].join(', ');

/** "corner of F1", "hole in F2", "B1". */
export function nameOfRef(shape: Shape, ref: Ref): string {
  const name = (row: number) => shape.parts[row]?.plate ?? shape.parts[row]?.name ?? '';
  if (ref.kind === 'bend' || ref.kind === 'flange') return name(ref.part);
  const { part: row, circle } = edgeForms(shape)[ref.edge]!,
    part = name(row);
  if (ref.kind === 'corner') return `corner of ${part}`;
  if (ref.kind === 'middle') return `middle of an edge of ${part}`;
  if (ref.kind === 'edge') return `edge of ${part}`;
  return circle?.whole ? `circle in ${part}` : `arc of ${part}`;
}
