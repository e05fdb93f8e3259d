import { namedPieces, unnamed, type NamedPlaces, type Solid } from './solid-mesh.ts';
import { hiding, placesOn } from './solid-sight.ts';
import type { Vec3 } from './types.ts';

/** A name at the place that it is written beside; `behind`: the solid hides all of what has it. */
export interface PlacedName {
  text: string;
  at: Vec3;
  behind: boolean;
}

const mostPlaces = 24; // of a face or an edge

/** The names of faces and edges of a solid, each beside a place that is seen, if there is one. */
export class SolidNames {
  private shape: Solid | null = null;
  private names: { text: string; places: Vec3[]; chosen: Vec3 }[] = [];
  private placed: { of: string; names: PlacedName[] } | null = null;

  set(shape: Solid, named: NamedPlaces = unnamed) {
    this.shape = shape;
    this.placed = null;
    this.names = namedPieces(shape, named).map((own) => {
      const middles = own.slice(0, mostPlaces).map((piece) => piece.middle),
        places = [...middles, ...own.slice(0, mostPlaces).flatMap(placesOn)].slice(0, mostPlaces);
      return { text: own[0]!.name, places, chosen: places[0]! };
    });
  }

  /** Seen from a direction. A name stays at its place as long as that is seen. */
  seenFrom(towards: Vec3): PlacedName[] {
    const of = towards.map((v) => v.toFixed(4)).join();
    if (this.placed?.of === of || !this.shape) return this.placed?.names ?? [];
    const hides = this.names.length ? hiding(this.shape, towards) : () => false;
    const names = this.names.map((name): PlacedName => {
      const at = [name.chosen, ...name.places].find((place) => !hides(place));
      name.chosen = at ?? name.places[0]!;
      return { text: name.text, at: name.chosen, behind: at === undefined };
    });
    this.placed = { of, names };
    return names;
  }
}
