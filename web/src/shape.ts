import type { ArrayPlace, Facets, Shape, ShapeHeader } from './types.ts';

const empty: Facets = {
  points: new Float32Array(),
  ring_starts: new Uint32Array([0]),
  polygon_starts: new Uint32Array([0]),
  facet_starts: new Uint32Array([0]),
  facet_parent: new Int32Array(),
  facet_hinge: new Float32Array(),
  facet_angle: new Float32Array(),
  facet_part: new Uint32Array(),
  edges: new Float32Array(),
  edge_facet: new Uint32Array(),
  edge_number: new Uint32Array(),
  edge_length: new Float32Array(),
  edge_circle: new Float32Array(),
  edge_feature: new Int32Array(),
  contour_points: new Float32Array(),
  contour_starts: new Uint32Array([0]),
  contour_part: new Int32Array(),
  bend_lines: new Float32Array(),
  bend_line_part: new Uint32Array(),
  overlaps: new Float32Array(),
  space_points: new Float32Array(),
  space_triangles: new Uint32Array(),
  space_faces: new Uint32Array(),
};

/** Names of the arrays that a shape may have. */
export const arrayNames = Object.keys(empty);

/**
 * The shape in an answer of the server. Arrays are views into `data`; missing ones are empty. Throws if it is not a
 * shape.
 */
export function decodeShape(data: ArrayBuffer): Shape {
  const bytes = new DataView(data);
  if (data.byteLength < 8 || bytes.getUint32(0, false) !== 0x504c4e31) throw new Error('the answer is not a shape');
  const length = bytes.getUint32(4, true);
  if (8 + length > data.byteLength) throw new Error('the shape is cut off');
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 8, length))) as ShapeHeader;
  const start = 8 + length;
  const shape: Shape = {
    ...empty,
    report: header.report,
    parts: header.parts ?? [],
    root: header.root ?? [],
    handles: header.handles ?? {},
    pierces: header.pierces ?? null,
    seconds: header.seconds ?? 0,
    turn: 0,
  };
  for (const [name, place] of Object.entries(header.arrays ?? {}))
    if (name in empty) Object.assign(shape, { [name]: view(data, start, name, place) });
  return shape;
}

function view(data: ArrayBuffer, start: number, name: string, place: ArrayPlace) {
  const at = start + place.at;
  if (at % 4 !== 0 || at + 4 * place.count > data.byteLength) throw new Error(`the shape's ${name} lie outside it`);
  if (place.type === 'f32') return new Float32Array(data, at, place.count);
  return place.type === 'i32' ? new Int32Array(data, at, place.count) : new Uint32Array(data, at, place.count);
}

/** The inverse, for tests and the stand-in for the server. */
export function encodeShape(header: Omit<ShapeHeader, 'arrays'>, arrays: Partial<Facets>): ArrayBuffer {
  const places: Record<string, ArrayPlace> = {};
  let at = 0;
  for (const [name, a] of Object.entries(arrays)) {
    places[name] = {
      type: a instanceof Float32Array ? 'f32' : a instanceof Int32Array ? 'i32' : 'u32',
      at,
      count: a.length,
    };
    at += 4 * a.length;
  }
  let json = new TextEncoder().encode(JSON.stringify({ ...header, arrays: places }));
  const padded = Math.ceil(json.length / 4) * 4;
  json = new Uint8Array([...json, ...new Array<number>(padded - json.length).fill(32)]);
  const out = new Uint8Array(8 + padded + at);
  out.set([0x50, 0x4c, 0x4e, 0x31]);
  new DataView(out.buffer).setUint32(4, padded, true);
  out.set(json, 8);
  for (const [name, a] of Object.entries(arrays))
    out.set(new Uint8Array(a.buffer, a.byteOffset, a.byteLength), 8 + padded + (places[name]?.at ?? 0));
  return out.buffer;
}
