import type { Plates, PlatesBend, PlatesPlate } from '../../generated/plates.ts';
import type { Spec } from '../types.ts';

export type { Plates as PlatesSpec, PlatesBend as BendSpec, PlatesPlate as PlateSpec };

/** An input that is a plates file; null if it is another. */
export const platesIn = (spec: Spec | null): Plates | null => (spec && 'plates' in spec ? (spec as Plates) : null);
