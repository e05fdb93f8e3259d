import { BufferAttribute, BufferGeometry, type Color, type LineSegments, type Mesh } from 'three';
import type { SheetMesh } from './sheet-mesh.ts';
import type { Solid } from './solid-mesh.ts';

export function replaceGeometry(object: Mesh | LineSegments, geometry: BufferGeometry) {
  object.geometry.dispose();
  object.geometry = geometry;
}

export function bothSkins(triangles: Uint32Array, n: number): BufferGeometry {
  const index = new Uint32Array(2 * triangles.length);
  index.set(triangles);
  for (let i = 0; i < triangles.length; i += 3) {
    index[triangles.length + i] = n + triangles[i]!;
    index[triangles.length + i + 1] = n + triangles[i + 2]!;
    index[triangles.length + i + 2] = n + triangles[i + 1]!;
  }
  return new BufferGeometry().setIndex(new BufferAttribute(index, 1));
}

export function doubled(pairs: Uint32Array, n: number): BufferGeometry {
  const index = new Uint32Array(2 * pairs.length);
  index.set(pairs);
  for (let i = 0; i < pairs.length; ++i) index[pairs.length + i] = n + pairs[i]!;
  return new BufferGeometry().setIndex(new BufferAttribute(index, 1));
}

/** The part of each corner, of the upper skin and of the lower one. */
export function rowsOf({ shape, cornerFacet }: SheetMesh): Float32Array {
  const n = cornerFacet.length,
    rows = new Float32Array(2 * n);
  for (let c = 0; c < n; ++c) rows[c] = rows[n + c] = shape.facet_part[cornerFacet[c]!]!;
  return rows;
}

export function setTint(geometry: BufferGeometry, tint: Color) {
  const count = geometry.getAttribute('position')?.count ?? 0,
    values = new Float32Array(3 * count);
  for (let i = 0; i < 3 * count; i += 3) {
    values[i] = tint.r;
    values[i + 1] = tint.g;
    values[i + 2] = tint.b;
  }
  geometry.setAttribute('tint', new BufferAttribute(values, 3));
}

export function spaceGeometry(shape: Solid): BufferGeometry {
  let geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(shape.space_points, 3));
  geometry.setIndex(new BufferAttribute(shape.space_triangles, 1));
  geometry = geometry.toNonIndexed(); // every triangle shaded by its own plane
  geometry.computeVertexNormals();
  return geometry;
}
