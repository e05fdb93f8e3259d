import { Matrix4, type OrthographicCamera } from 'three';
import { distanceToSegment, type PickedLine } from './lines.ts';
import type { CornerLine } from './sheet-object.ts';
import type { SheetMesh } from './sheet-mesh.ts';
import { weightsUnder } from './triangle-under.ts';
import type { Vec3 } from './types.ts';

/** The sheet as it is drawn. */
export interface Drawn {
  mesh: SheetMesh;
  positions: Float32Array;
  lines: CornerLine[];
}

export interface SeenLine {
  line: PickedLine;
  at: Vec3; // the place on it that is nearest to the pointer
  upper: boolean; // on the upper skin
  distance: number; // pixels
}

export interface SeenSkin {
  facet: number;
  upper: boolean;
  at: Vec3;
  depth: number;
}

/** Whether a place is there to be seen: not cut away. */
export type Shown = (x: number, y: number, z: number) => boolean;

/**
 * What of the sheet is seen at a place of the screen. Corners are put on the screen once for each camera and fold;
 * then a look takes a millisecond for tens of thousands of triangles.
 */
export class Sight {
  private screen = new Float32Array(); // x, y in pixels and depth in mm, of each corner
  private of: { version: number; camera: string; width: number; height: number } | null = null;
  private view: number[] = [];
  private drawn: Drawn | null = null;
  private edgeA = new Uint32Array();
  private edgeB = new Uint32Array();
  private edgesOf: CornerLine[] | null = null;

  /** Takes the sheet as it is seen now. */
  look(drawn: Drawn | null, version: number, camera: OrthographicCamera, width: number, height: number) {
    this.drawn = drawn;
    if (!drawn) return;
    camera.updateMatrixWorld();
    const m = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse),
      key = m.elements.join();
    if (this.of?.version === version && this.of.camera === key && this.of.width === width && this.of.height === height)
      return;
    this.of = { version, camera: key, width, height };
    this.view = [...camera.matrixWorldInverse.elements];
    this.project(drawn.positions, m.elements, camera.matrixWorldInverse.elements, width, height);
    this.takeLines(drawn.lines);
  }

  private project(p: Float32Array, m: number[], v: number[], width: number, height: number) {
    if (this.screen.length !== p.length) this.screen = new Float32Array(p.length);
    const s = this.screen,
      w = width / 2,
      h = height / 2;
    for (let i = 0; i < p.length; i += 3) {
      const x = p[i]!,
        y = p[i + 1]!,
        z = p[i + 2]!;
      s[i] = (m[0]! * x + m[4]! * y + m[8]! * z + m[12]! + 1) * w;
      s[i + 1] = (1 - (m[1]! * x + m[5]! * y + m[9]! * z + m[13]!)) * h;
      s[i + 2] = -(v[2]! * x + v[6]! * y + v[10]! * z + v[14]!);
    }
  }

  /** How deep a place lies. */
  depthOf([x, y, z]: Vec3): number {
    const v = this.view;
    return -(v[2]! * x + v[6]! * y + v[10]! * z + v[14]!);
  }

  private takeLines(lines: CornerLine[]) {
    if (this.edgesOf === lines) return;
    this.edgesOf = lines;
    this.edgeA = Uint32Array.from(lines, (l) => l.a);
    this.edgeB = Uint32Array.from(lines, (l) => l.b);
  }

  /** The line nearest to a place, of those within so many pixels that the sheet does not hide. */
  lineAt(x: number, y: number, within: number, slack: number, shown: Shown): SeenLine | null {
    const { drawn, screen: s, edgeA, edgeB } = this;
    if (!drawn) return null;
    const n = drawn.mesh.cornerFacet.length,
      near: { i: number; skin: number; distance: number; along: number }[] = [];
    for (let skin = 0; skin < 2; ++skin)
      for (let i = 0; i < edgeA.length; ++i) {
        const a = 3 * (edgeA[i]! + skin * n),
          b = 3 * (edgeB[i]! + skin * n),
          ax = s[a]!,
          bx = s[b]!;
        if ((ax < x - within && bx < x - within) || (ax > x + within && bx > x + within)) continue;
        const ay = s[a + 1]!,
          by = s[b + 1]!;
        if ((ay < y - within && by < y - within) || (ay > y + within && by > y + within)) continue;
        const { distance, along } = distanceToSegment(x, y, ax, ay, bx, by);
        if (distance < within) near.push({ i, skin, distance, along });
      }
    near.sort((p, q) => p.distance - q.distance);
    for (const { i, skin, distance, along } of near.slice(0, 12)) {
      const a = 3 * (edgeA[i]! + skin * n),
        b = 3 * (edgeB[i]! + skin * n),
        between = (from: Float32Array, k: number) => from[a + k]! + along * (from[b + k]! - from[a + k]!),
        at = [0, 1, 2].map((k) => between(drawn.positions, k)) as Vec3;
      if (!shown(...at)) continue;
      const front = this.skinAt(between(s, 0), between(s, 1), shown);
      if (front && front.depth < between(s, 2) - slack) continue;
      return { line: drawn.lines[i]!.line, at, upper: skin === 0, distance };
    }
    return null;
  }

  /** The skin that is seen at a place. */
  skinAt(x: number, y: number, shown: Shown): SeenSkin | null {
    const { drawn, screen: s } = this;
    if (!drawn) return null;
    const { triangles: t, triangleFacet, cornerFacet } = drawn.mesh,
      n = cornerFacet.length,
      p = drawn.positions;
    let best: SeenSkin | null = null;
    for (let skin = 0; skin < 2; ++skin)
      for (let i = 0; i < t.length; i += 3) {
        const a = 3 * (t[i]! + skin * n),
          b = 3 * (t[i + 1]! + skin * n),
          c = 3 * (t[i + 2]! + skin * n);
        const under = weightsUnder(s, a, b, c, x, y);
        if (!under) continue;
        const [u, v, w] = under;
        const depth = u * s[a + 2]! + v * s[b + 2]! + w * s[c + 2]!;
        if (best && depth >= best.depth) continue;
        const at = [0, 1, 2].map((k) => u * p[a + k]! + v * p[b + k]! + w * p[c + k]!) as Vec3;
        if (shown(...at)) best = { facet: triangleFacet[i / 3]!, upper: skin === 0, at, depth };
      }
    return best;
  }
}
