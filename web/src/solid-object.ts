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
import { isBetween, namedPieces, pointOf, solidLines, unnamed, type NamedPlaces, type Solid } from './solid-mesh.ts';
import { writeNames } from './name-labels.ts';
import type { Palette } from './theme.ts';
import type { Vec3 } from './types.ts';

/** A solid without a flat pattern, as it was read. The faces and edges that its refusal names are marked. */
export class SolidObject {
  readonly group = new Group();
  private readonly skin = new Mesh(new BufferGeometry(), sheetMaterial(false));
  private readonly lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
  private readonly marked = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial({ linewidth: 4 }));
  private readonly behind = new LineSegments2(
    new LineSegmentsGeometry(),
    new LineMaterial({ linewidth: 4, depthTest: false, transparent: true, opacity: 0.35 }),
  ); // the same, through the part
  private faces: Uint32Array = new Uint32Array(); // by triangle
  private named = unnamed;
  private labels: { text: string; at: Vec3 }[] = [];

  constructor() {
    this.behind.renderOrder = 1;
    this.group.add(this.skin, this.lines, this.marked, this.behind);
    for (const o of this.group.children) o.frustumCulled = false;
  }

  setShape(shape: Solid, named: NamedPlaces) {
    if (shape.space_faces.length === 0 && this.faces.length === 0) return;
    this.faces = shape.space_faces;
    this.named = named;
    this.group.visible = this.faces.length > 0;
    this.labels = namedPieces(shape, named).map(([{ name, middle }]) => ({ text: name, at: middle }));
    replaceGeometry(this.skin, spaceGeometry(shape));
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
    setOpacity(material as ShaderMaterial, glass);
    (this.lines.material as LineBasicMaterial).color.set(glass ? palette.outline : palette.edge);
    for (const { material } of [this.marked, this.behind]) material.color.set(palette.hit);
    const tint = geometry.getAttribute('tint') as BufferAttribute | undefined,
      { r, g, b } = new Color(palette.hit),
      own = new Set(this.named.faces.map((f) => f.number));
    this.faces.forEach((face, i) => {
      if (own.has(face)) for (let k = 3 * i; k < 3 * i + 3; ++k) tint!.setXYZ(k, r, g, b);
    });
  }

  /** Names what is marked. */
  paintNames(c: CanvasRenderingContext2D, palette: Palette, toScreen: (at: Vec3) => { x: number; y: number }): boolean {
    if (!this.group.visible) return false;
    const names = this.labels.map(({ text, at }) => ({ text, ...toScreen(at) }));
    return writeNames(c, names, palette);
  }

  boundsInto(box: Box3) {
    if (!this.faces.length) return;
    this.skin.geometry.computeBoundingBox();
    box.union(this.skin.geometry.boundingBox!);
  }
}
