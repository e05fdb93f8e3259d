import { insideFacet } from './facet.ts';
import { findingMarks, findingUnder, type FindingMark } from './finding-marks.ts';
import { dimensionReach, drawDimensions } from './flat-dimensions.ts';
import { drawnInSoftware } from './graphics.ts';
import { LabelWriter } from './flat-labels.ts';
import { labelPlaces, type Place } from './label-places.ts';
import { distanceToSegment, featureOfEdge, markedWith, type PickedLine } from './lines.ts';
import { turnedPlace } from './orientation.ts';
import { sidesAsReported, smallestRectangle, type Rectangle } from './rectangle.ts';
import type { Palette } from './theme.ts';
import type { BendRow, Finding, PieceReport, Shape, Vec2 } from './types.ts';
import { clean, lengthText, millimetres, type DisplayUnit } from './units.ts';

export interface FlatScene {
  shape: Shape | null;
  report: PieceReport | null; // of the piece that is shown
  findings: Finding[];
  turn: number; // quarters by which the findings' pattern is shown turned
  selected: number | null; // row of parts
  edge: number | null; // number of an edge
  finding: number | null;
  units: DisplayUnit;
  palette: Palette;
}

/** What is picked: a line, a flange, or a finding by its place in the list. */
export type PickedInFlat = PickedLine | { finding: number };
/** `facet`: the facet below all marks and lines. */
export type PickInFlat = (picked: PickedInFlat | null, facet: number | null) => void;

export interface FlatEvents {
  pick: PickInFlat;
  /** The sentence that is shown beside the pointer. */
  describe: (picked: PickedInFlat) => string;
  zoomed: () => void;
}

/** The flat pattern: pan by dragging, zoom by the wheel, click to pick. */
export class FlatView {
  private readonly canvas = document.createElement('canvas');
  private readonly c: CanvasRenderingContext2D;
  private scene: FlatScene;
  scale = 1; // pixels a millimetre
  private fittedScale = 1;
  private offset: Vec2 = [0, 0];
  private bounds = { x0: 0, y0: 0, x1: 1, y1: 1 };
  private rectangle: Rectangle | null = null;
  private places: Map<number, Place> | null = null;
  private marks: FindingMark[] = [];
  private fitted = true;
  private frame = 0;
  private press: { x: number; y: number; moved: boolean } | null = null;

  private hover: PointerEvent | null = null; // that is still to be looked at

  private readonly box: HTMLElement;
  private readonly on: FlatEvents;
  constructor(box: HTMLElement, palette: Palette, on: FlatEvents) {
    this.box = box;
    this.on = on;
    this.scene = {
      shape: null,
      report: null,
      findings: [],
      turn: 0,
      selected: null,
      edge: null,
      finding: null,
      units: 'mm',
      palette,
    };
    this.c = this.canvas.getContext('2d', { willReadFrequently: drawnInSoftware })!;
    this.canvas.dataset.testid = 'flat-canvas';
    box.append(this.canvas);
    this.listen();
    new ResizeObserver(() => this.resize()).observe(box);
    this.resize();
  }

  set(scene: FlatScene) {
    const other = scene.shape !== this.scene.shape;
    this.scene = scene;
    if (other) this.measure();
    if (other && this.fitted) this.fit();
    this.draw();
  }

  fit() {
    const { clientWidth: w, clientHeight: h } = this.box,
      [side, above, below] = [18, 30, 18];
    const [across, up] = [this.reach(0), this.reach(1)];
    this.scale = Math.min(scaleToFit(across, w - 2 * side), scaleToFit(up, h - above - below));
    this.fittedScale = this.scale;
    const [x0, x1] = extentAt(across, this.scale),
      [y0, y1] = extentAt(up, this.scale);
    this.offset = [w / 2 - (x0 + x1) / 2, (h + above - below) / 2 + (y0 + y1) / 2];
    this.fitted = true;
    this.draw();
  }

  /** Where a point of the pattern appears, in client coordinates; for tests. */
  project(at: Vec2) {
    const r = this.canvas.getBoundingClientRect(),
      [x, y] = this.at(at[0], at[1]);
    return { x: r.left + x, y: r.top + y };
  }

  /** What must be visible along an axis: corners of the pattern, and its dimension lines. */
  private reach(axis: 0 | 1): Reach[] {
    const { x0, y0, x1, y1 } = this.bounds,
      corners = axis ? [y0, y1] : [x0, x1];
    return [
      ...corners.map((at) => ({ at, by: 0 })),
      ...(this.rectangle ? dimensionReach(this.rectangle.corners) : []).map(({ at, by }) => ({
        at: at[axis],
        by: by[axis],
      })),
    ];
  }

  private at = (x: number, y: number): Vec2 => [this.offset[0] + this.scale * x, this.offset[1] - this.scale * y];

  private measure() {
    const p = this.scene.shape?.points;
    if (!p || p.length === 0) return;
    const b = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
    for (let i = 0; i < p.length; i += 2) {
      b.x0 = Math.min(b.x0, p[i]!);
      b.x1 = Math.max(b.x1, p[i]!);
      b.y0 = Math.min(b.y0, p[i + 1]!);
      b.y1 = Math.max(b.y1, p[i + 1]!);
    }
    this.rectangle = smallestRectangle(p);
    for (const [x, y] of this.rectangle?.corners ?? []) {
      b.x0 = Math.min(b.x0, x);
      b.x1 = Math.max(b.x1, x);
      b.y0 = Math.min(b.y0, y);
      b.y1 = Math.max(b.y1, y);
    }
    this.bounds = b;
    this.places = null;
  }

  private listen() {
    const canvas = this.canvas;
    canvas.addEventListener('pointerdown', (e) => {
      this.press = { x: e.clientX, y: e.clientY, moved: false };
      canvas.setPointerCapture(e.pointerId);
    });
    canvas.addEventListener('pointermove', (e) => {
      if (!this.press) return this.hovered(e);
      const dx = e.clientX - this.press.x,
        dy = e.clientY - this.press.y;
      if (!this.press.moved && Math.hypot(dx, dy) < 4) return;
      this.press = { x: e.clientX, y: e.clientY, moved: true };
      this.offset = [this.offset[0] + dx, this.offset[1] + dy];
      this.fitted = false;
      this.draw();
    });
    canvas.addEventListener('pointerup', (e) => {
      if (this.press && !this.press.moved) this.clicked(e);
      this.press = null;
    });
    canvas.addEventListener(
      'wheel',
      (e) => {
        e.preventDefault();
        const r = canvas.getBoundingClientRect(),
          x = e.clientX - r.left,
          y = e.clientY - r.top,
          wanted = this.scale * Math.exp(-e.deltaY * 0.0015);
        // beyond there is nothing to be seen
        const factor = Math.min(this.fittedScale * 2000, Math.max(this.fittedScale / 50, wanted)) / this.scale;
        this.scale *= factor;
        this.offset = [x + (this.offset[0] - x) * factor, y + (this.offset[1] - y) * factor];
        this.fitted = false;
        this.draw();
        this.on.zoomed();
      },
      { passive: false },
    );
    canvas.addEventListener('dblclick', () => this.fit());
  }

  private clicked(e: PointerEvent) {
    const { shape } = this.scene;
    if (!shape) return this.on.pick(null, null);
    const r = this.canvas.getBoundingClientRect(),
      sx = e.clientX - r.left,
      sy = e.clientY - r.top;
    const x = (sx - this.offset[0]) / this.scale,
      y = (this.offset[1] - sy) / this.scale,
      found = shape.facet_part.findIndex((_, f) => insideFacet(shape, f, x, y));
    const facet = found < 0 ? null : found;
    this.on.pick(this.lineUnder(shape, sx, sy) ?? (facet === null ? null : { part: shape.facet_part[facet]! }), facet);
  }

  /** Says what lies under the pointer, once a frame. */
  private hovered(e: PointerEvent) {
    const waiting = this.hover !== null;
    this.hover = e;
    if (waiting) return;
    requestAnimationFrame(() => {
      const { clientX, clientY } = this.hover!,
        r = this.canvas.getBoundingClientRect(),
        { shape } = this.scene;
      this.hover = null;
      const under = shape && this.lineUnder(shape, clientX - r.left, clientY - r.top),
        text = under ? this.on.describe(under) : '';
      if (this.canvas.title !== text) this.canvas.title = text;
    });
  }

  /**
   * Lines go before the flange they lie on, the nearest first, and marks before lines; at its ends a bend leaves them
   * to the edges.
   */
  private lineUnder(shape: Shape, sx: number, sy: number): PickedInFlat | null {
    const finding = findingUnder(this.marks, sx, sy);
    if (finding !== null) return { finding };
    const bend = this.nearest(shape.bend_lines, sx, sy, 6),
      edge = this.nearest(shape.edges, sx, sy);
    if (bend && bend.distance <= (edge?.distance ?? Infinity)) return { part: shape.bend_line_part[bend.line]! };
    return edge && { edge: shape.edge_number[edge.line]! };
  }

  /**
   * The line, of those given by four numbers each, that is nearest to a point of the screen, if it is near; lines three
   * times as long as `ends` count without so many pixels of their ends.
   */
  private nearest(lines: Float32Array, sx: number, sy: number, ends = 0): { line: number; distance: number } | null {
    let best: { line: number; distance: number } | null = null;
    for (let i = 0; 4 * i + 3 < lines.length; ++i) {
      const a = this.at(lines[4 * i]!, lines[4 * i + 1]!),
        b = this.at(lines[4 * i + 2]!, lines[4 * i + 3]!);
      const { distance, along } = distanceToSegment(sx, sy, ...a, ...b),
        length = Math.hypot(b[0] - a[0], b[1] - a[1]);
      if (length > 3 * ends && Math.min(along, 1 - along) * length < ends) continue;
      if (distance < (best?.distance ?? 5)) best = { line: i, distance };
    }
    return best;
  }

  private resize() {
    const { clientWidth: w, clientHeight: h } = this.box,
      ratio = window.devicePixelRatio;
    if (w === 0 || h === 0) return;
    this.canvas.width = Math.round(w * ratio);
    this.canvas.height = Math.round(h * ratio);
    this.canvas.style.width = `${w}px`;
    this.canvas.style.height = `${h}px`;
    if (this.fitted) this.fit();
    this.draw();
  }

  draw() {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.paint();
    });
  }

  private paint() {
    const { c, scene } = this,
      { shape, palette } = scene,
      ratio = window.devicePixelRatio;
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.fillStyle = palette.background;
    c.fillRect(0, 0, this.canvas.width, this.canvas.height);
    if (!shape || shape.points.length === 0) return;
    this.fill(shape, (part) => part < 0, palette.fill);
    this.fill(shape, (part) => shape.parts[part]?.kind === 'bend', palette.bend, 0.28);
    this.fill(shape, (part) => part === scene.selected, palette.selected);
    this.fillOverlaps(shape);
    this.strokeBendLines(shape);
    this.strokeOutline(shape);
    const writer = new LabelWriter(c, palette.halo);
    this.markFindings(writer);
    this.dimension(writer);
    this.writeLabels(shape, writer);
  }

  private dimension(writer: LabelWriter) {
    const r = this.rectangle,
      { palette, units, report } = this.scene,
      factor = millimetres(report?.units);
    if (!r) return;
    const box = r.corners.map((p) => this.at(...p)) as typeof r.corners;
    const size = report?.flat ? sidesAsReported(r.size, report.flat.size.map((v) => v * factor) as Vec2) : r.size;
    drawDimensions(
      this.c,
      box,
      size.map((v) => lengthText(v, 'mm', units)) as [string, string],
      palette,
      writer,
      r.turned,
    );
  }

  private fill(shape: Shape, whose: (part: number) => boolean, color: string, alpha = 1) {
    const { c } = this;
    c.beginPath();
    for (let i = 0; i < shape.contour_part.length; ++i) if (whose(shape.contour_part[i]!)) this.trace(shape, i);
    c.globalAlpha = alpha;
    c.fillStyle = color;
    c.fill();
    c.globalAlpha = 1;
  }

  private trace(shape: Shape, contour: number) {
    const { c } = this,
      p = shape.contour_points,
      first = shape.contour_starts[contour]!,
      end = shape.contour_starts[contour + 1]!;
    for (let i = first; i < end; ++i) {
      const [x, y] = this.at(p[2 * i]!, p[2 * i + 1]!);
      if (i === first) c.moveTo(x, y);
      else c.lineTo(x, y);
    }
  }

  private fillOverlaps(shape: Shape) {
    const { c } = this,
      o = shape.overlaps;
    if (o.length === 0) return;
    c.beginPath();
    for (let i = 0; i + 5 < o.length; i += 6) {
      c.moveTo(...this.at(o[i]!, o[i + 1]!));
      c.lineTo(...this.at(o[i + 2]!, o[i + 3]!));
      c.lineTo(...this.at(o[i + 4]!, o[i + 5]!));
      c.closePath();
    }
    c.fillStyle = this.scene.palette.overlap;
    c.fill();
  }

  private strokeOutline(shape: Shape) {
    const { palette } = this.scene,
      isCut = (i: number) => featureOfEdge(shape, shape.edge_number[i]!) === null;
    this.strokeEdges(shape, (i) => !isCut(i), palette.form, 1);
    this.strokeEdges(shape, isCut, palette.outline, 1.3);
    const marked = markedWith(shape, this.scene.edge);
    if (marked.size) this.strokeEdges(shape, (i) => marked.has(shape.edge_number[i]!), palette.selected, 4);
  }

  private strokeEdges(shape: Shape, whose: (edge: number) => boolean, color: string, width: number) {
    const { c } = this,
      e = shape.edges;
    let last = -2;
    c.beginPath();
    for (let i = 0; 4 * i + 3 < e.length; ++i) {
      if (!whose(i)) continue;
      const x = e[4 * i]!,
        y = e[4 * i + 1]!;
      // A segment that starts where the last one ends continues its line: ends cost more to draw than corners.
      if (last !== i - 1 || x !== e[4 * i - 2] || y !== e[4 * i - 1]) c.moveTo(...this.at(x, y));
      c.lineTo(...this.at(e[4 * i + 2]!, e[4 * i + 3]!));
      last = i;
    }
    c.strokeStyle = color;
    c.lineWidth = width;
    c.lineCap = c.lineJoin = 'round';
    c.setLineDash([]);
    c.stroke();
  }

  private strokeBendLines(shape: Shape) {
    const { c } = this,
      { palette, selected } = this.scene,
      l = shape.bend_lines;
    for (let i = 0; i < shape.bend_line_part.length; ++i) {
      const part = shape.bend_line_part[i]!;
      c.beginPath();
      c.moveTo(...this.at(l[4 * i]!, l[4 * i + 1]!));
      c.lineTo(...this.at(l[4 * i + 2]!, l[4 * i + 3]!));
      c.strokeStyle = this.isUp(shape, part) ? palette.up : palette.down;
      const short = this.scale * this.lengthOf(l, i) < 30;
      c.lineWidth = part === selected ? 2.6 : short ? 0.6 : 1.1;
      c.lineCap = 'butt';
      c.setLineDash(short ? [] : this.isUp(shape, part) ? [7, 4] : [7, 3, 2, 3]);
      c.stroke();
    }
    c.setLineDash([]);
  }

  private isUp = (shape: Shape, part: number) => shape.parts[part]?.direction !== 'down';

  private bendRow(shape: Shape, part: number) {
    return this.rows(shape).get(shape.parts[part]?.name ?? '');
  }

  private rowsOf: Shape | null = null;
  private rowMap = new Map<string, BendRow>();
  private rows(shape: Shape) {
    if (this.rowsOf !== shape) {
      this.rowsOf = shape;
      this.rowMap = new Map((this.scene.report?.flat?.bends ?? []).map((b) => [b.id, b]));
    }
    return this.rowMap;
  }

  private markFindings(writer: LabelWriter) {
    const { c } = this,
      { palette, findings, finding, report, turn } = this.scene,
      factor = millimetres(report?.units);
    const at = (p: Vec2) => this.at(...turnedPlace([p[0] * factor, p[1] * factor], turn));
    this.marks = findingMarks(findings, at, finding);
    for (const {
      finding: i,
      severity,
      at: [x, y],
      radius: r,
      numbered,
    } of this.marks) {
      c.beginPath();
      c.arc(x, y, r, 0, 2 * Math.PI);
      c.fillStyle = palette[severity];
      c.globalAlpha = 0.9;
      c.fill();
      c.globalAlpha = 1;
      c.strokeStyle = palette.halo;
      c.lineWidth = 1.5;
      c.stroke();
      writer.reserve({ x: x - r, y: y - r, w: 2 * r, h: 2 * r });
      if (!numbered) continue;
      c.fillStyle = palette.background;
      c.font = 'bold 10px system-ui, sans-serif';
      c.textAlign = 'center';
      c.textBaseline = 'middle';
      c.fillText(String(i + 1), x, y + 0.5);
    }
  }

  private writeLabels(shape: Shape, writer: LabelWriter) {
    const { palette, selected, report } = this.scene;
    const written = new Set<number>();
    const marks = report?.flat?.labels ?? [],
      factor = millimetres(report?.units);
    const l = shape.bend_lines,
      lines = Array.from(shape.bend_line_part, (part, i) => ({ part, i })).sort(
        (a, b) => this.lengthOf(l, b.i) - this.lengthOf(l, a.i),
      );
    const ridges = shape.handles.ridges !== undefined; // too many to name; strips are named
    for (const { part, i } of [...lines.filter((x) => x.part === selected), ...(ridges ? [] : lines)]) {
      if (written.has(part)) continue;
      const a = this.at(l[4 * i]!, l[4 * i + 1]!),
        b = this.at(l[4 * i + 2]!, l[4 * i + 3]!),
        room = Math.hypot(b[0] - a[0], b[1] - a[1]) - 6;
      const color = this.isUp(shape, part) ? palette.up : palette.down,
        angle = Math.atan2(b[1] - a[1], b[0] - a[0]);
      const along = (t: number) =>
        writer.write({
          text: this.bendText(shape, part),
          at: [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])],
          angle,
          room: 2 * Math.min(t, 1 - t) * room,
          color,
          weight: part === selected ? 'bold' : 'normal',
        });
      if ([0.5, 0.27, 0.73].some(along)) written.add(part);
    }
    for (const m of marks)
      writer.write({
        text: m.text,
        at: this.at(...turnedPlace([m.at[0] * factor, m.at[1] * factor], shape.turn)),
        angle: 0,
        room: 200,
        color: palette.label,
        weight: 'bold',
      });
    if (marks.length) return;
    this.places ??= labelPlaces(shape);
    for (const [part, { at, room }] of this.places) {
      if (room * this.scale < 9) continue;
      const { name, plate } = shape.parts[part]!;
      writer.write({
        text: plate ?? name,
        at: this.at(...at),
        angle: 0,
        room: 400,
        color: palette.label,
        weight: 'bold',
      });
    }
  }

  private bendText(shape: Shape, part: number): string {
    const row = this.bendRow(shape, part),
      name = shape.parts[part]?.name ?? '';
    if (!row) return name;
    const radius =
      row.inside_radius > 0 ? ` R${lengthText(row.inside_radius, this.scene.report?.units, this.scene.units)}` : '';
    return `${name} ${row.direction} ${clean(row.angle, 1)}°${radius}`;
  }

  private lengthOf = (l: Float32Array, i: number) =>
    Math.hypot(l[4 * i + 2]! - l[4 * i]!, l[4 * i + 3]! - l[4 * i + 1]!);
}

/** A place along an axis of the pattern, and how far from it in pixels. */
interface Reach {
  at: number;
  by: number;
}

const extentAt = (places: Reach[], scale: number): Vec2 => {
  const all = places.map(({ at, by }) => scale * at + by);
  return [Math.min(...all), Math.max(...all)];
};

/**
 * The largest scale at which all places lie within `room` pixels; of too small a room a hundredth of what the pattern
 * alone would have.
 */
function scaleToFit(places: Reach[], room: number): number {
  const own = places.map((p) => p.at),
    width = Math.max(Math.max(...own) - Math.min(...own), 1e-6);
  const most = Math.max(room, 1) / width;
  let [low, high] = [0, most];
  for (let i = 0; i < 40; ++i) {
    const middle = (low + high) / 2,
      [from, to] = extentAt(places, middle);
    if (to - from <= room) low = middle;
    else high = middle;
  }
  return Math.max(low, most / 100);
}
