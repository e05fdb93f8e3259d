import {
  type Box3,
  BufferAttribute,
  BufferGeometry,
  Color,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  type ShaderMaterial,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { replaceGeometry, setTint, spaceGeometry } from './sheet-geometry.ts';
import { setOpacity, sheetMaterial } from './sheet-material.ts';
import { isBetween, pointOf, solidLines, unnamed, type NamedPlaces, type Solid } from './solid-mesh.ts';
import { writeNames } from './name-labels.ts';
import { SolidNames } from './solid-names.ts';
import type { Palette } from './theme.ts';
import type { Vec3 } from './types.ts';

/** A solid without a flat pattern, as it was read. The faces and edges that its refusal names are marked. */
export class SolidObject {
  readonly group = new Group();
  private readonly skin = new Mesh(new BufferGeometry(), sheetMaterial(false));
  private readonly red = new Mesh(new BufferGeometry(), sheetMaterial(false)); // of the same: faces that are named
  private readonly lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
  private readonly marked = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial({ linewidth: 4 }));
  private readonly behind = new LineSegments2(
    new LineSegmentsGeometry(),
    new LineMaterial({ linewidth: 4, depthTest: false, transparent: true, opacity: 0.35 }),
  ); // the same, through the part
  private faces: Uint32Array = new Uint32Array(); // by triangle
  private named = unnamed;
  readonly names = new SolidNames();
  private glass = false;

  constructor() {
    this.behind.renderOrder = 1;
    Object.assign(this.red.material, { polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1 });
    this.group.add(this.skin, this.red, this.lines, this.marked, this.behind);
    for (const o of this.group.children) o.frustumCulled = false;
  }

  setShape(shape: Solid, named: NamedPlaces) {
    if (shape.space_faces.length === 0 && this.faces.length === 0) return;
    this.faces = shape.space_faces;
    this.named = named;
    this.group.visible = this.faces.length > 0;
    this.names.set(shape, named);
    replaceGeometry(this.skin, spaceGeometry(shape));
    this.red.geometry.dispose();
    const lines = solidLines(shape),
      geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(shape.space_points, 3));
    geometry.setIndex(lines.flatMap(({ ends }) => ends));
    replaceGeometry(this.lines, geometry);
    const marked = lines.filter((line) => named.edges.some(({ between }) => isBetween(line, between)));
    this.marked.visible = this.behind.visible = marked.length > 0;
    if (!marked.length) return;
    this.marked.geometry.dispose();
    this.marked.geometry = new LineSegmentsGeometry().setPositions(
      marked.flatMap(({ ends }) => ends.flatMap((i) => pointOf(shape, i))),
    );
    this.behind.geometry = this.marked.geometry;
  }

  paint(palette: Palette, glass: boolean) {
    const { geometry, material } = this.skin;
    setTint(geometry, new Color(palette.flange));
    this.glass = glass;
    setOpacity(material as ShaderMaterial, glass);
    (this.lines.material as LineBasicMaterial).color.set(glass ? palette.outline : palette.edge);
    for (const { material } of [this.marked, this.behind]) material.color.set(palette.hit);
    const tint = geometry.getAttribute('tint') as BufferAttribute | undefined,
      { r, g, b } = new Color(palette.hit),
      own = new Set(this.named.faces.map((f) => f.number));
    const corners: number[] = [];
    this.faces.forEach((face, i) => {
      if (!own.has(face)) return;
      corners.push(3 * i, 3 * i + 1, 3 * i + 2);
      for (let k = 3 * i; k < 3 * i + 3; ++k) tint!.setXYZ(k, r, g, b);
    });
    // Of two faces in one place the one that is named is seen.
    this.red.visible = corners.length > 0 && !glass;
    this.red.geometry.setIndex(corners);
    for (const name of Object.keys(geometry.attributes))
      this.red.geometry.setAttribute(name, geometry.getAttribute(name));
  }

  /** Names what is marked, seen from a direction; through glass all of it is seen. */
  paintNames(
    c: CanvasRenderingContext2D,
    palette: Palette,
    towards: Vec3,
    toScreen: (at: Vec3) => { x: number; y: number },
  ): boolean {
    if (!this.group.visible) return false;
    const names = this.names
      .seenFrom(towards)
      .map(({ text, at, behind }) => ({ text, behind: behind && !this.glass, ...toScreen(at) }));
    return writeNames(c, names, palette);
  }

  boundsInto(box: Box3) {
    if (!this.faces.length) return;
    this.skin.geometry.computeBoundingBox();
    box.union(this.skin.geometry.boundingBox!);
  }
}
