import { pointOf, type Solid } from './solid-mesh.ts';
import type { Vec3 } from './types.ts';
import { cross, dot, minus, normalised, plus, scaled } from './vectors.ts';

/** From where the folded view looks at first; from the left of that comes the light. */
const toEye = normalised([1, -1.25, 0.95]),
  right = normalised(cross([0, 0, 1], toEye)),
  up = cross(toEye, right),
  light = normalised(plus(plus(toEye, scaled(up, 0.75)), scaled(right, -0.45)));

/** What is seen of a solid, pixel by pixel, y down: the face (0: none), and how bright it is, from 0 to 1. */
export interface Raster {
  width: number;
  height: number;
  faces: Uint32Array;
  bright: Float32Array;
}

/** The solid from the corner from which it is first shown, as large as fits into `extent` × `extent`. */
export function rasterOf(solid: Solid, extent: number): Raster | null {
  const { space_points: p, space_triangles: t, space_faces } = solid,
    count = p.length / 3,
    seen = [right, up, toEye].map((axis) =>
      Float64Array.from({ length: count }, (_, i) => dot(pointOf(solid, i), axis)),
    );
  const [x, y, z] = seen as [Float64Array, Float64Array, Float64Array],
    used = new Set(t),
    range = (of: Float64Array) => {
      let [low, high] = [Infinity, -Infinity];
      for (const i of used) [low, high] = [Math.min(low, of[i]!), Math.max(high, of[i]!)];
      return [low, high] as const;
    };
  const [left, farRight] = range(x),
    [bottom, top] = range(y),
    largest = Math.max(farRight - left, top - bottom);
  if (!(largest > 0)) return null;
  const scale = extent / largest,
    width = Math.max(1, Math.ceil((farRight - left) * scale)),
    height = Math.max(1, Math.ceil((top - bottom) * scale)),
    faces = new Uint32Array(width * height),
    bright = new Float32Array(width * height),
    depth = new Float64Array(width * height).fill(-Infinity);
  for (let i = 0; i < t.length; i += 3) {
    const corners = [t[i]!, t[i + 1]!, t[i + 2]!] as const,
      [ax, bx, cx] = corners.map((c) => (x[c]! - left) * scale) as Vec3,
      [ay, by, cy] = corners.map((c) => (top - y[c]!) * scale) as Vec3,
      [az, bz, cz] = corners.map((c) => z[c]!) as Vec3,
      area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (area === 0) continue;
    const [a, b, c] = corners.map((corner) => pointOf(solid, corner)) as [Vec3, Vec3, Vec3],
      shade = Math.abs(dot(normalised(cross(minus(b, a), minus(c, a))), light)),
      end = (high: number, size: number) => Math.min(size - 1, Math.ceil(high));
    const rows = end(Math.max(ay, by, cy), height),
      columns = end(Math.max(ax, bx, cx), width);
    for (let row = Math.max(0, Math.floor(Math.min(ay, by, cy))); row <= rows; ++row)
      for (let column = Math.max(0, Math.floor(Math.min(ax, bx, cx))); column <= columns; ++column) {
        const [px, py] = [column + 0.5, row + 0.5],
          u = ((bx - px) * (cy - py) - (cx - px) * (by - py)) / area,
          v = ((cx - px) * (ay - py) - (ax - px) * (cy - py)) / area,
          w = 1 - u - v,
          at = row * width + column,
          near = u * az + v * bz + w * cz;
        if (u < 0 || v < 0 || w < 0 || near <= depth[at]!) continue;
        depth[at] = near;
        faces[at] = space_faces[i / 3]!;
        bright[at] = shade;
      }
  }
  return { width, height, faces, bright };
}

const edge = [70, 84, 98] as const, // colours that are told from light and dark grounds
  dark = [96, 112, 128] as const,
  bright = [196, 206, 216] as const,
  fine = 2; // pixels of the raster for one of the picture, in both directions

/** A raster as pixels with colours, half as wide and high; lines where faces meet. */
export function pixelsOf({ width, height, faces, bright: brightness }: Raster) {
  const w = Math.ceil(width / fine),
    h = Math.ceil(height / fine),
    data = new Uint8ClampedArray(4 * w * h);
  const faceAt = (column: number, row: number) =>
    column < 0 || row < 0 || column >= width || row >= height ? 0 : faces[row * width + column]!;
  for (let row = 0; row < height; ++row)
    for (let column = 0; column < width; ++column) {
      const face = faceAt(column, row);
      if (face === 0) continue;
      const line = faceAt(column - 1, row) !== face || faceAt(column, row - 1) !== face || bordersNothing(column, row),
        at = 4 * (Math.floor(row / fine) * w + Math.floor(column / fine)),
        share = brightness[row * width + column]!;
      for (let k = 0; k < 3; ++k) data[at + k]! += (line ? edge[k]! : dark[k]! + share * (bright[k]! - dark[k]!)) / 4;
      data[at + 3]! += 255 / 4;
    }
  function bordersNothing(column: number, row: number) {
    return faceAt(column + 1, row) === 0 || faceAt(column, row + 1) === 0;
  }
  // Colours are those of the covered share.
  for (let i = 0; i < data.length; i += 4)
    if (data[i + 3]) for (let k = 0; k < 3; ++k) data[i + k] = (data[i + k]! * 255) / data[i + 3]!;
  return { width: w, height: h, data };
}

const size = 160; // pixels of the longer side

/** The picture of a solid as a data URL of a few kilobytes; null where there is nothing to be seen. */
export function solidImage(solid: Solid): { width: number; height: number; url: string } | null {
  const raster = rasterOf(solid, fine * size);
  if (!raster) return null;
  const { width, height, data } = pixelsOf(raster),
    canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [width, height];
  canvas.getContext('2d')!.putImageData(new ImageData(data, width, height), 0, 0);
  return { width: width / size, height: height / size, url: canvas.toDataURL('image/webp', 0.8) };
}
