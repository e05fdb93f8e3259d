import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  FrontSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Plane,
  Vector3,
  type Box3,
  type Material,
  type ShaderMaterial,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { bendingColours, curvatures } from './curvature.ts';
import { markedWith, type PickedLine } from './lines.ts';
import { setRim } from './rim.ts';
import { replaceGeometry, bothSkins, doubled, rowsOf, setTint } from './sheet-geometry.ts';
import { isLarge, simplified } from './sheet-lod.ts';
import { capOf, type Cut } from './section.ts';
import { setOpacity, sheetMaterial } from './sheet-material.ts';
import { foldSheet, makeSheetMesh, poseSheet, type FoldedSheet, type Pose, type SheetMesh } from './sheet-mesh.ts';
import type { Palette } from './theme.ts';
import type { Shape, Vec3 } from './types.ts';

/** A line of the sheet, and its place. */
export interface SheetLine {
  line: PickedLine;
  ends: [Vec3, Vec3];
}

/** Two corners that a line runs between. */
export interface CornerLine {
  line: PickedLine;
  a: number;
  b: number;
}

/** The sheet as three.js draws it: both skins, the cut rim, outline, tangent lines and outlines of formed features. */
export class SheetObject {
  readonly group = new Group();
  readonly skin: Mesh;
  private readonly rim: Mesh;
  private readonly outline: LineSegments;
  private readonly creases: LineSegments;
  private readonly forms: LineSegments; // outlines of formed features
  private readonly cap = new Mesh(new BufferGeometry(), new MeshBasicMaterial({ side: DoubleSide }));
  private section: ((positions: Float32Array) => Cut) | null = null;
  private glass = false;
  /** What is cut away, while there is a section. */
  cut: Cut | null = null;
  private readonly marked = new LineSegments2(
    new LineSegmentsGeometry(),
    new LineMaterial({ linewidth: 3.5, depthTest: false }),
  );
  private mesh: SheetMesh | null = null;
  private shape: Shape | null = null;
  private tolerance = 0; // how far corners of a large shape that are left out may leave its circles, mm
  private readonly levels = new Map<number, SheetMesh>(); // of the shape, by this
  private pose: Pose | number = 1; // or the share
  private folded: FoldedSheet | null = null;
  /** Grows with each change of what is drawn where. */
  version = 0;
  private thickness = 1;
  private held = 0;
  private known: CornerLine[] | null = null; // made when they are asked for
  private picked: { part: number | null; edge: number | null } = { part: null, edge: null };
  private readonly rimTint = new Color();
  private readonly hitTint = new Color();
  private hit: number | null = null; // the part that collides
  private bending = false; // coloured by how sharply it is bent

  constructor() {
    this.skin = new Mesh(new BufferGeometry(), sheetMaterial(true));
    this.rim = new Mesh(new BufferGeometry(), sheetMaterial(false));
    this.outline = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
    this.creases = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity: 0.6 }));
    this.forms = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
    this.marked.renderOrder = 1;
    this.group.add(this.skin, this.rim, this.outline, this.creases, this.forms, this.cap, this.marked);
    for (const o of this.group.children) o.frustumCulled = false;
  }

  setShape(shape: Shape, thickness: number, share: number, held: number) {
    this.thickness = thickness;
    this.held = held;
    this.shape = shape;
    this.levels.clear();
    this.pose = share;
    this.closeGaps();
    this.setMesh(shape, this.level());
  }

  /**
   * Strips of a bend begin where others have no corner: between them pixels may be left out, which then show the skin
   * behind, from within. Large parts have too much to draw for that, and of glass all is seen.
   */
  private closeGaps() {
    const open = this.glass || (this.shape !== null && isLarge(this.shape));
    (this.skin.material as Material).side = open ? FrontSide : DoubleSide;
  }

  /** How far corners of large shapes that are left out may leave circles, mm; 0: none is left out. */
  setTolerance(tolerance: number) {
    this.tolerance = tolerance > 0 ? 2 ** Math.floor(Math.log2(tolerance)) : 0;
    const { shape } = this,
      mesh = this.level();
    if (!shape || !mesh || mesh === this.mesh) return false;
    this.setMesh(shape, mesh);
    return true;
  }

  private level(): SheetMesh | null {
    const { shape, levels } = this;
    if (!shape) return null;
    const tolerance = isLarge(shape) ? this.tolerance : 0,
      known = levels.get(tolerance) ?? makeSheetMesh(tolerance ? simplified(shape, tolerance) : shape);
    levels.set(tolerance, known);
    return known;
  }

  private setMesh(shape: Shape, mesh: SheetMesh | null) {
    this.mesh = mesh ?? makeSheetMesh(shape);
    this.known = null;
    this.folded = null;
    const { triangles, cuts, forms, creases, cornerFacet } = this.mesh;
    const n = cornerFacet.length;
    replaceGeometry(this.skin, bothSkins(triangles, n));
    this.skin.geometry.setAttribute('tint', new BufferAttribute(new Float32Array(6 * n), 3));
    this.skin.geometry.setAttribute('row', new BufferAttribute(rowsOf(this.mesh), 1));
    replaceGeometry(this.outline, doubled(cuts, n));
    replaceGeometry(this.forms, doubled(forms, n));
    replaceGeometry(this.creases, doubled(creases, n));
    replaceGeometry(this.rim, new BufferGeometry());
    this.refold();
  }

  setShare(share: number) {
    this.pose = share;
    this.refold();
  }

  setPose(pose: Pose) {
    this.pose = pose;
    this.refold();
  }

  private refold() {
    const { mesh, pose, thickness, held, folded } = this;
    if (!mesh) return;
    const into = folded ?? undefined;
    const skins =
      typeof pose === 'number' ? foldSheet(mesh, pose, thickness, held, into) : poseSheet(mesh, pose, thickness, into);
    if (skins.positions !== folded?.positions) this.take(skins);
    else
      for (const name of ['position', 'normal'])
        (this.skin.geometry.getAttribute(name) as BufferAttribute).needsUpdate = true;
    setRim(this.rim.geometry, mesh.cuts, skins.positions);
    if (this.rim.geometry.getAttribute('tint')?.count !== this.rim.geometry.getAttribute('position').count)
      this.tintRim();
    this.skin.geometry.boundingSphere = null;
    this.skin.geometry.boundingBox = null;
    this.cutAgain();
    this.mark();
  }

  private take(skins: FoldedSheet) {
    this.folded = skins;
    const position = new BufferAttribute(skins.positions, 3);
    this.skin.geometry.setAttribute('position', position);
    this.skin.geometry.setAttribute('normal', new BufferAttribute(skins.normals, 3));
    for (const lines of [this.outline, this.creases, this.forms]) lines.geometry.setAttribute('position', position);
  }

  /** The section, by the corners of the sheet as it is folded; null: none. */
  setSection(section: ((positions: Float32Array) => Cut) | null) {
    this.section = section;
    this.cutAgain();
  }

  private cutAgain() {
    const { mesh, folded, cap } = this,
      cut = (mesh && folded && this.section?.(folded.positions)) ?? null,
      planes = cut ? [new Plane(new Vector3(...cut.normal), cut.constant)] : [];
    this.cut = cut;
    ++this.version;
    for (const object of [this.skin, this.rim, this.outline, this.creases, this.forms, this.marked])
      (object.material as Material).clippingPlanes = planes;
    cap.visible = cut !== null;
    if (!cut || !mesh || !folded) return;
    cap.geometry.dispose();
    cap.geometry = new BufferGeometry();
    cap.geometry.setAttribute('position', new BufferAttribute(capOf(mesh, folded.positions, cut), 3));
  }

  /** Whether one sees through the sheet. */
  setGlass(glass: boolean, palette: Palette) {
    this.glass = glass;
    this.closeGaps();
    (this.outline.material as LineBasicMaterial).color.set(glass ? palette.outline : palette.edge);
    for (const { material } of [this.skin, this.rim]) setOpacity(material as ShaderMaterial, glass);
  }

  /** Whether colours tell how sharply the sheet is bent; says whether that is other than before. */
  setBending(bending: boolean): boolean {
    const other = bending !== this.bending;
    this.bending = bending;
    return other;
  }

  /** Lights up a part, by its row; null: none. Says whether that changes something; nothing is made for it. */
  light(row: number | null, color: string): boolean {
    const { uniforms } = this.skin.material as ShaderMaterial,
      before = uniforms.lit!.value as number;
    uniforms.lit!.value = row ?? -1;
    (uniforms.light!.value as Color).set(color);
    return before !== uniforms.lit!.value;
  }

  /** Corners of the skins as they are drawn, and what lies between them. */
  get drawn(): { mesh: SheetMesh; positions: Float32Array; lines: CornerLine[] } | null {
    if (!this.mesh || !this.folded) return null;
    this.known ??= cornerLines(this.mesh);
    return { mesh: this.mesh, positions: this.folded.positions, lines: this.known };
  }

  /** `hit`: the part that collides. */
  paint(palette: Palette, selected: number | null, edge: number | null, hit: number | null = null) {
    this.rimTint.set(palette.rim);
    this.hitTint.set(palette.hit);
    this.hit = hit;
    this.tintRim();
    (this.outline.material as LineBasicMaterial).color.set(this.glass ? palette.outline : palette.edge);
    (this.creases.material as LineBasicMaterial).color.set(palette.crease);
    (this.forms.material as LineBasicMaterial).color.set(palette.form);
    this.marked.material.color.set(palette.selected);
    (this.cap.material as MeshBasicMaterial).color.set(palette.section);
    this.picked = { part: selected, edge };
    this.mark();
    const color = this.skin.geometry.getAttribute('tint') as BufferAttribute | undefined;
    if (!this.mesh || !color) return;
    const { shape, cornerFacet } = this.mesh,
      n = cornerFacet.length;
    const rows = this.skin.geometry.getAttribute('row').array;
    const [flange, bend, flangeUnder, bendUnder, mark, collides] = [
      palette.flange,
      palette.bend,
      palette.flangeUnder,
      palette.bendUnder,
      palette.selected,
      palette.hit,
    ].map((c) => new Color(c));
    const bent = this.bending ? bendingTints(shape) : null;
    for (let c = 0; c < n; ++c) {
      const part = rows[c]!,
        isBend = shape.parts[part]?.kind === 'bend';
      const own = part === hit ? collides! : part === selected ? mark! : null;
      const tint = own ?? bent?.[cornerFacet[c]!],
        upper = tint ?? (isBend ? bend! : flange!),
        lower = tint ?? (isBend ? bendUnder! : flangeUnder!);
      color.setXYZ(c, upper.r, upper.g, upper.b);
      color.setXYZ(n + c, lower.r, lower.g, lower.b);
    }
    color.needsUpdate = true;
  }

  /** The rim has one colour, but for that of the part that collides. */
  private tintRim() {
    const { geometry } = this.rim;
    setTint(geometry, this.rimTint);
    const tint = geometry.getAttribute('tint') as BufferAttribute | undefined;
    if (!this.mesh || this.hit === null || !tint) return;
    const { shape, cornerFacet, cuts } = this.mesh,
      { r, g, b } = this.hitTint;
    for (let quad = 0; 2 * quad < cuts.length; ++quad)
      if (shape.facet_part[cornerFacet[cuts[2 * quad]!]!] === this.hit)
        for (let i = 6 * quad; i < 6 * quad + 6; ++i) tint.setXYZ(i, r, g, b);
  }

  /** The lines of what is picked: an edge, or a sharp bend, which has no facets to paint. */
  private mark() {
    const { part, edge } = this.picked,
      on = this.mesh !== null && (part !== null || edge !== null),
      marked = on ? markedWith(this.mesh!.shape, edge) : null;
    const own = on ? this.linesOf((line) => ('edge' in line ? marked!.has(line.edge) : line.part === part)) : [],
      ends = own.flatMap((l) => l.ends.flat());
    this.marked.visible = ends.length > 0;
    if (!ends.length) return;
    this.marked.geometry.dispose();
    this.marked.geometry = new LineSegmentsGeometry().setPositions(ends);
  }

  /** All lines that can be picked, on both skins, at the present share of the fold. */
  lines(): SheetLine[] {
    return this.linesOf(() => true);
  }

  linesOf(whose: (line: PickedLine) => boolean): SheetLine[] {
    const { drawn } = this;
    if (!drawn) return [];
    const { positions: p, mesh, lines } = drawn,
      n = mesh.cornerFacet.length,
      at = (corner: number): Vec3 => [p[3 * corner]!, p[3 * corner + 1]!, p[3 * corner + 2]!];
    return lines
      .filter(({ line }) => whose(line))
      .flatMap(
        ({ line, a, b }) =>
          [
            { line, ends: [at(a), at(b)] },
            { line, ends: [at(n + a), at(n + b)] },
          ] as SheetLine[],
      );
  }

  get depth() {
    return this.thickness;
  }

  boundsInto(box: Box3) {
    const { geometry } = this.skin;
    if (!geometry.getAttribute('position')?.count) return;
    geometry.computeBoundingBox();
    box.union(geometry.boundingBox!);
  }
}

/** Edges of the outline, and hinges that are sharp bends. */
function cornerLines(mesh: SheetMesh): CornerLine[] {
  const { shape, rim, hinges } = mesh,
    withFacets = new Set(shape.facet_part);
  const sharp = shape.parts.flatMap((p, row) => (p.kind === 'bend' && !withFacets.has(row) ? [row] : []));
  const out: CornerLine[] = Array.from(shape.edge_number, (edge, e) => ({
    line: { edge },
    a: rim[2 * e]!,
    b: rim[2 * e + 1]!,
  }));
  for (let i = 0; i + 1 < hinges.length; i += 2) {
    const [a, b] = [hinges[i]!, hinges[i + 1]!],
      part = sharp.find((row) => liesOn(mesh, a, b, row));
    if (part !== undefined) out.push({ line: { part }, a, b });
  }
  return out;
}

/** Whether the crease between two corners is a line of bend `part`. */
function liesOn({ shape, corners }: SheetMesh, a: number, b: number, part: number): boolean {
  const l = shape.bend_lines,
    [x, y] = [(corners[2 * a]! + corners[2 * b]!) / 2, (corners[2 * a + 1]! + corners[2 * b + 1]!) / 2];
  return shape.bend_line_part.some((p, i) => {
    if (p !== part) return false;
    const ux = l[4 * i + 2]! - l[4 * i]!,
      uy = l[4 * i + 3]! - l[4 * i + 1]!,
      length = Math.hypot(ux, uy),
      vx = x - l[4 * i]!,
      vy = y - l[4 * i + 1]!;
    const along = (vx * ux + vy * uy) / length;
    return Math.abs(vx * uy - vy * ux) < 0.01 * length && along > -0.01 && along < length + 0.01;
  });
}

/** The colour of each facet between those of flat and of the sharpest bend. */
function bendingTints(shape: Shape): Color[] {
  const bent = curvatures(shape),
    most = bent.reduce((a, b) => Math.max(a, b), 0) || 1,
    stops = bendingColours.map((c) => new Color(c));
  return Array.from(bent, (k) => {
    const at = (k / most) * (stops.length - 1),
      i = Math.min(Math.floor(at), stops.length - 2);
    return stops[i]!.clone().lerp(stops[i + 1]!, at - i);
  });
}
