import { BufferAttribute, type BufferGeometry } from 'three';

/** The wall between both skins along pairs of corners; `skins`: the upper one's corners, then the lower one's. */
export function setRim(geometry: BufferGeometry, pairs: Uint32Array, skins: Float32Array) {
  const quads = pairs.length / 2,
    half = skins.length / 2,
    position = attributeOf(geometry, 'position', 18 * quads),
    normal = attributeOf(geometry, 'normal', 18 * quads);
  const p = position.array as Float32Array,
    n = normal.array as Float32Array;
  for (let q = 0; q < quads; ++q) {
    const a = 3 * pairs[2 * q]!,
      b = 3 * pairs[2 * q + 1]!,
      to = 18 * q;
    copy(skins, a, p, to);
    copy(skins, b, p, to + 3);
    copy(skins, half + b, p, to + 6);
    copy(skins, a, p, to + 9);
    copy(skins, half + b, p, to + 12);
    copy(skins, half + a, p, to + 15);
    const ux = skins[b]! - skins[a]!,
      uy = skins[b + 1]! - skins[a + 1]!,
      uz = skins[b + 2]! - skins[a + 2]!,
      vx = skins[half + a]! - skins[a]!,
      vy = skins[half + a + 1]! - skins[a + 1]!,
      vz = skins[half + a + 2]! - skins[a + 2]!;
    const x = uy * vz - uz * vy,
      y = uz * vx - ux * vz,
      z = ux * vy - uy * vx,
      l = Math.hypot(x, y, z) || 1;
    for (let i = to; i < to + 18; i += 3) {
      n[i] = x / l;
      n[i + 1] = y / l;
      n[i + 2] = z / l;
    }
  }
  position.needsUpdate = normal.needsUpdate = true;
}

function copy(from: Float32Array, i: number, to: Float32Array, j: number) {
  to[j] = from[i]!;
  to[j + 1] = from[i + 1]!;
  to[j + 2] = from[i + 2]!;
}

/** An attribute of three numbers a corner, kept where it has the length: the graphics card then keeps its buffer. */
function attributeOf(geometry: BufferGeometry, name: string, length: number): BufferAttribute {
  const known = geometry.getAttribute(name) as BufferAttribute | undefined;
  if (known?.array.length === length) return known;
  const made = new BufferAttribute(new Float32Array(length), 3);
  geometry.setAttribute(name, made);
  return made;
}
