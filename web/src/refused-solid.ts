import { ShapeUtils, Vector2 } from 'three';
import type { State } from './state.ts';
import { namedPlaces, unnamed, type NamedPlaces, type Solid } from './solid-mesh.ts';
import type { Place, Vec3 } from './types.ts';
import { platesIn, type PlatesSpec } from './edits/plates-types.ts';
import { millimetres } from './units.ts';
import { cross, dot, minus, normalised, plus, scaled } from './vectors.ts';

const none: Solid = {
  space_points: new Float32Array(),
  space_triangles: new Uint32Array(),
  space_faces: new Uint32Array(),
};

/** What is to be seen of an input that is refused: the solid as read, or the plates. Empty while there is a sheet. */
export function refusedSolid({ shape, problem, input }: State): Solid {
  if (shape?.facet_parent.length) return none;
  if (shape?.space_faces.length) return shape;
  const plates = platesIn(input.spec);
  return plates && problem ? solidOf(plates) : none;
}

/** What the refusal names of it. */
export function refusedPlaces({ shape, problem, document, input }: State): NamedPlaces {
  if (!problem || !document || shape?.facet_parent.length) return unnamed;
  const plates = platesIn(input.spec);
  return plates ? namedPlates(problem.places, plates) : namedPlaces(problem.places);
}

/** Plates among places, and those of fields of the file: its own of a plate, both of a bend. */
export function namedPlates(places: Place[] = [], { plates, bends }: PlatesSpec): NamedPlaces {
  const idsOf = ({ kind, id }: Place): string[] => {
    if (kind === 'plate') return [String(id)];
    if (kind !== 'pointer') return [];
    const [, list, at] = String(id).split('/');
    return list === 'plates'
      ? [plates[Number(at)]?.id ?? '']
      : list === 'bends'
        ? (bends?.[Number(at)]?.between ?? [])
        : [];
  };
  const ids = [...new Set(places.flatMap(idsOf))].filter((id) => plates.some((p) => p.id === id));
  return { faces: ids.map((id) => ({ name: id, number: plates.findIndex((p) => p.id === id) + 1 })), edges: [] };
}

const solids = new WeakMap<PlatesSpec, Solid>();

/** Plates without thickness, as faces of a solid in their order. */
function solidOf(spec: PlatesSpec): Solid {
  const known = solids.get(spec);
  if (known) return known;
  const scale = millimetres(spec.units),
    solid = solidOfOutlines(spec.plates.map((p) => p.outline.map((c) => scaled(c, scale))));
  solids.set(spec, solid);
  return solid;
}

function solidOfOutlines(outlines: Vec3[][]): Solid {
  const points: number[] = [],
    triangles: number[] = [],
    faces: number[] = [];
  outlines.forEach((outline, i) => {
    const first = points.length / 3,
      own = ShapeUtils.triangulateShape(inPlane(outline), []);
    points.push(...outline.flat());
    triangles.push(...own.flat().map((corner) => first + corner!));
    faces.push(...own.map(() => i + 1));
  });
  return {
    space_points: new Float32Array(points),
    space_triangles: new Uint32Array(triangles),
    space_faces: new Uint32Array(faces),
  };
}

/** A polygon in its plane. */
function inPlane(outline: Vec3[]): Vector2[] {
  const normal = normalised(
    outline.reduce<Vec3>((sum, p, i) => plus(sum, cross(p, outline[(i + 1) % outline.length]!)), [0, 0, 0]),
  );
  const u = normalised(minus(outline[1] ?? [1, 0, 0], outline[0] ?? [0, 0, 0])),
    v = cross(normal, u);
  return outline.map((p) => new Vector2(dot(p, u), dot(p, v)));
}
