import type { Palette } from './theme.ts';
import type { Finding, PieceReport, Shape, Vec2 } from './types.ts';
import type { DisplayUnit } from './units.ts';

export interface FlatScene {
  shape: Shape | null;
  report: PieceReport | null; // of the piece that is shown
  findings: Finding[];
  turn: number; // quarters by which the findings' pattern is shown turned
  selected: number | null; // row of parts
  edge: number | null; // number of an edge
  finding: number | null;
  units: DisplayUnit;
  palette: Palette;
}

export const emptyScene = (palette: Palette): FlatScene => ({
  shape: null,
  report: null,
  findings: [],
  turn: 0,
  selected: null,
  edge: null,
  finding: null,
  units: 'mm',
  palette,
});

/** Where the pattern lies on the screen: `scale` pixels a millimetre, its origin at `offset`, y up. */
export interface Lie {
  scale: number;
  offset: Vec2;
}

export const onScreen = ({ scale, offset }: Lie, x: number, y: number): Vec2 => [
  offset[0] + scale * x,
  offset[1] - scale * y,
];

export const inPattern = ({ scale, offset }: Lie, sx: number, sy: number): Vec2 => [
  (sx - offset[0]) / scale,
  (offset[1] - sy) / scale,
];

export const lengthOfLine = (l: Float32Array, i: number) =>
  Math.hypot(l[4 * i + 2]! - l[4 * i]!, l[4 * i + 3]! - l[4 * i + 1]!);

export const isUp = (shape: Shape, part: number) => shape.parts[part]?.direction !== 'down';
