import type { FlatCurveName } from './edits/slit-types.ts';
import { onScreen, type Lie } from './flat-scene.ts';
import type { Palette } from './theme.ts';
import type { Vec2 } from './types.ts';

/** A point of a curve that is dragged on the flat pattern, where it lies there, mm. */
export interface Grip {
  curve: FlatCurveName;
  index: number;
  at: Vec2;
  chosen: boolean;
}

/** Curves on the flat pattern and their points. */
export interface Grips {
  curves: { control: Vec2[]; drawn: Vec2[] }[];
  grips: Grip[];
}

export const noGrips: Grips = { curves: [], grips: [] };

/** The nearest one to a point of the screen, if it is near. */
export function gripUnder({ grips }: Grips, lie: Lie, [sx, sy]: Vec2): Grip | null {
  let [best, near]: [Grip | null, number] = [null, 9];
  for (const grip of grips) {
    const [x, y] = onScreen(lie, ...grip.at),
      distance = Math.hypot(x - sx, y - sy);
    if (distance < near) [best, near] = [grip, distance];
  }
  return best;
}

/** Says whether there was anything to draw. */
export function paintGrips(c: CanvasRenderingContext2D, { curves, grips }: Grips, lie: Lie, palette: Palette): boolean {
  const stroke = (points: Vec2[], width: number, dash: number[]) => {
    c.beginPath();
    for (const p of points) c.lineTo(...onScreen(lie, ...p));
    c.lineWidth = width;
    c.setLineDash(dash);
    c.strokeStyle = palette.curve;
    c.stroke();
    c.setLineDash([]);
  };
  for (const { control, drawn } of curves) {
    stroke(drawn, 2, []);
    if (drawn !== control) stroke(control, 1, [3, 3]);
  }
  for (const { at, chosen } of grips) {
    const [x, y] = onScreen(lie, ...at);
    c.beginPath();
    c.arc(x, y, chosen ? 6 : 4, 0, 2 * Math.PI);
    c.fillStyle = chosen ? palette.selected : palette.curve;
    c.fill();
  }
  return grips.length > 0;
}
