import type { Shape } from './types.ts';

const coarsest = 0.05, // mm, as the server has it by itself
  finest = 1e-5, // what it accepts
  pixels = 0.25,
  most = 400_000; // corners that a page can fold smoothly

/**
 * How far polygons may lie from curves, in mm, at `scale` pixels a millimetre: a quarter of a pixel at most. In
 * steps of a half, so that not every turn of the wheel asks for another. `known` is what is shown, `at` its chord:
 * where so many corners would be too many, the finest chord with which they are not.
 */
export function chordFor(scale: number, known: Pick<Shape, 'points'> | null, at: number): number {
  const wanted = pixels / scale;
  let chord = coarsest;
  while (chord > wanted && chord > finest) chord /= 2;
  // A polygon of half the chord has √2 times as many corners.
  const corners = (known?.points.length ?? 0) / 2,
    least = Math.min(at, coarsest) * (corners / most) ** 2;
  return Math.max(chord, finest, Math.min(least, coarsest));
}
