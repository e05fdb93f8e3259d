import type { Plates, PlatesBend, PlatesPlate } from '../../generated/plates.ts';

export type { Plates as PlatesSpec, PlatesBend as BendSpec, PlatesPlate as PlateSpec };
