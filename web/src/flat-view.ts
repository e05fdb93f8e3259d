import { insideFacet } from './facet.ts';
import { findingUnder, type FindingMark } from './finding-marks.ts';
import { extentOf, fitted, type Extent } from './flat-fit.ts';
import { LabelWriter } from './flat-labels.ts';
import { fill, paintSheet, strokeBendLinesOf, strokeEdges } from './flat-paint.ts';
import { emptyScene, inPattern, onScreen, type FlatScene, type Lie } from './flat-scene.ts';
import { dimensionBlank, markFindings, writeLabels } from './flat-text.ts';
import { drawnInSoftware } from './graphics.ts';
import { gripUnder, paintGrips, type Grip, type Grips } from './grips.ts';
import { labelPlaces, type Place } from './label-places.ts';
import { distanceToSegment, markedWith, type PickedLine } from './lines.ts';
import type { MeasuringEvents } from './measure/events.ts';
import { refOfEdge, snapAt } from './measure/snap.ts';
import type { Measured, Ref } from './measure/things.ts';
import { ViewOverlay } from './view-overlay.ts';
import type { Palette } from './theme.ts';
import type { Shape, Vec2 } from './types.ts';

/** What is picked: a line, a flange, or a finding by its place in the list. */
export type PickedInFlat = PickedLine | { finding: number };
/** `facet`: the facet below all marks and lines. */
export type PickInFlat = (picked: PickedInFlat | null, facet: number | null) => void;

export interface FlatEvents extends MeasuringEvents {
  pick: PickInFlat;
  /** The sentence that is shown beside the pointer. */
  describe: (picked: PickedInFlat) => string;
  zoomed: () => void;
  hover: (under: PickedLine | null) => void;
  /** Curves of the sheet that can be changed here. */
  grips: () => Grips;
  pickGrip: (grip: Grip) => void;
  dragGrip: (grip: Grip, at: Vec2, event: number) => void;
  dragEnd: () => void;
  /** A grip was clicked twice. */
  addGrip: (grip: Grip) => void;
}

/** The flat pattern: pan by dragging, zoom by the wheel, click to pick. */
export class FlatView {
  private readonly canvas = document.createElement('canvas');
  private readonly c: CanvasRenderingContext2D;
  private scene: FlatScene;
  private lie: Lie = { scale: 1, offset: [0, 0] };
  private fittedScale = 1;
  private extent: Extent = extentOf(new Float32Array([0, 0, 1, 1]));
  private places: Map<number, Place> | null = null;
  private marks: FindingMark[] = [];
  private fitted = true;
  private frame = 0;
  private press: { x: number; y: number; moved: boolean; grip: Grip | null } | null = null;

  private hover: PointerEvent | null = null; // that is still to be looked at
  private hovered: PickedLine | null = null;
  private readonly above: ViewOverlay;

  private readonly box: HTMLElement;
  private readonly on: FlatEvents;
  constructor(box: HTMLElement, palette: Palette, on: FlatEvents) {
    this.box = box;
    this.on = on;
    this.scene = emptyScene(palette);
    this.c = this.canvas.getContext('2d', { willReadFrequently: drawnInSoftware })!;
    this.canvas.dataset.testid = 'flat-canvas';
    box.append(this.canvas);
    this.above = new ViewOverlay(box, 'flat-overlay', (c) => this.paintAbove(c));
    this.listen();
    new ResizeObserver(() => this.resize()).observe(box);
    this.resize();
  }

  set(scene: FlatScene) {
    const other = scene.shape !== this.scene.shape;
    this.scene = scene;
    if (other) this.measure();
    if (other && this.fitted && !this.press?.grip) this.fit();
    this.draw();
  }

  /** Pixels a millimetre. */
  get scale() {
    return this.lie.scale;
  }

  fit() {
    this.lie = fitted(this.extent, this.box.clientWidth, this.box.clientHeight);
    this.fittedScale = this.lie.scale;
    this.fitted = true;
    this.draw();
  }

  /** Where a point of the pattern appears, in client coordinates; for tests. */
  project(at: Vec2) {
    const r = this.canvas.getBoundingClientRect(),
      [x, y] = onScreen(this.lie, ...at);
    return { x: r.left + x, y: r.top + y };
  }

  private measure() {
    const p = this.scene.shape?.points;
    if (!p || p.length === 0) return;
    this.extent = extentOf(p);
    this.places = null;
  }

  private listen() {
    const canvas = this.canvas;
    canvas.addEventListener('pointerdown', (e) => {
      const grip = this.gripAt(e);
      this.press = { x: e.clientX, y: e.clientY, moved: false, grip };
      canvas.setPointerCapture(e.pointerId);
      if (grip) this.on.pickGrip(grip);
    });
    canvas.addEventListener('pointermove', (e) => {
      if (!this.press) return this.lookUnder(e);
      const dx = e.clientX - this.press.x,
        dy = e.clientY - this.press.y;
      if (!this.press.moved && Math.hypot(dx, dy) < 4) return;
      const { grip } = this.press;
      if (grip) {
        this.press.moved = true; // from where it was taken
        const by = this.lie.scale;
        return this.on.dragGrip(grip, [grip.at[0] + dx / by, grip.at[1] - dy / by], e.timeStamp);
      }
      this.press = { x: e.clientX, y: e.clientY, moved: true, grip };
      const { scale, offset } = this.lie;
      this.lie = { scale, offset: [offset[0] + dx, offset[1] + dy] };
      this.fitted = false;
      this.draw();
    });
    canvas.addEventListener('pointerup', (e) => {
      const { press } = this;
      this.press = null;
      if (press?.grip) return press.moved ? this.on.dragEnd() : undefined;
      if (press && !press.moved) this.clicked(e);
    });
    canvas.addEventListener(
      'wheel',
      (e) => {
        e.preventDefault();
        const r = canvas.getBoundingClientRect(),
          x = e.clientX - r.left,
          y = e.clientY - r.top,
          { scale, offset } = this.lie,
          wanted = scale * Math.exp(-e.deltaY * 0.0015);
        // beyond there is nothing to be seen
        const factor = Math.min(this.fittedScale * 2000, Math.max(this.fittedScale / 50, wanted)) / scale;
        this.lie = { scale: scale * factor, offset: [x + (offset[0] - x) * factor, y + (offset[1] - y) * factor] };
        this.fitted = false;
        this.draw();
        this.on.zoomed();
      },
      { passive: false },
    );
    canvas.addEventListener('pointerleave', () => {
      this.hover = null;
      this.on.hover(null);
      this.on.measureHover(null);
    });
    canvas.addEventListener('dblclick', (e) => {
      const grip = this.gripAt(e);
      if (grip) this.on.addGrip(grip);
      else this.fit();
    });
  }

  private gripAt(e: MouseEvent): Grip | null {
    if (this.on.measured()) return null;
    const r = this.canvas.getBoundingClientRect();
    return gripUnder(this.on.grips(), this.lie, [e.clientX - r.left, e.clientY - r.top]);
  }

  private clicked(e: PointerEvent) {
    const { shape } = this.scene;
    const r = this.canvas.getBoundingClientRect(),
      sx = e.clientX - r.left,
      sy = e.clientY - r.top,
      measured = this.on.measured();
    if (measured) return this.on.measurePick(measured.of && this.refUnder(measured.of, sx, sy));
    if (!shape) return this.on.pick(null, null);
    const facet = this.facetUnder(shape, sx, sy);
    this.on.pick(this.lineUnder(shape, sx, sy) ?? (facet === null ? null : { part: shape.facet_part[facet]! }), facet);
  }

  private facetUnder(shape: Shape, sx: number, sy: number): number | null {
    const [x, y] = inPattern(this.lie, sx, sy),
      found = shape.facet_part.findIndex((_, f) => insideFacet(shape, f, x, y));
    return found < 0 ? null : found;
  }

  /** What would be measured from or to: a corner, a middle or a centre before a line. */
  private refUnder(of: Measured, sx: number, sy: number): Ref | null {
    const bend = this.nearest(of.shape.bend_lines, sx, sy, 6),
      edge = this.nearest(of.shape.edges, sx, sy);
    const snapped = snapAt(
      of,
      'flat',
      (x, y) => onScreen(this.lie, x, y),
      [sx, sy],
      () => true,
      edge && { edge: of.shape.edge_number[edge.line]!, upper: true, distance: edge.distance },
    );
    if (snapped) return snapped;
    if (bend && bend.distance <= (edge?.distance ?? Infinity))
      return { kind: 'bend', part: of.shape.bend_line_part[bend.line]!, line: bend.line };
    return edge && refOfEdge(of, of.shape.edge_number[edge.line]!, true);
  }

  /** Says what lies under the pointer, once a frame. */
  private lookUnder(e: PointerEvent) {
    const waiting = this.hover !== null;
    this.hover = e;
    if (waiting) return;
    requestAnimationFrame(() => {
      if (!this.hover) return;
      const { clientX, clientY } = this.hover,
        r = this.canvas.getBoundingClientRect(),
        [sx, sy] = [clientX - r.left, clientY - r.top],
        { shape } = this.scene;
      this.hover = null;
      const measured = this.on.measured();
      if (measured) return this.on.measureHover(measured.of && this.refUnder(measured.of, sx, sy));
      const under = shape && this.lineUnder(shape, sx, sy),
        facet = shape && !under ? this.facetUnder(shape, sx, sy) : null,
        part = facet === null ? null : { part: shape!.facet_part[facet]! };
      this.on.hover(under ? ('finding' in under ? null : under) : part);
      const text = under ? this.on.describe(under) : '';
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
    const { scale, offset } = this.lie,
      [x0, y0] = inPattern(this.lie, sx - 5, sy + 5),
      [x1, y1] = inPattern(this.lie, sx + 5, sy - 5);
    for (let i = 0; i + 3 < lines.length; i += 4) {
      const ax = lines[i]!,
        ay = lines[i + 1]!,
        bx = lines[i + 2]!,
        by = lines[i + 3]!;
      if ((ax < x0 && bx < x0) || (ax > x1 && bx > x1) || (ay < y0 && by < y0) || (ay > y1 && by > y1)) continue;
      const a: Vec2 = [offset[0] + scale * ax, offset[1] - scale * ay],
        b: Vec2 = [offset[0] + scale * bx, offset[1] - scale * by];
      const { distance, along } = distanceToSegment(sx, sy, ...a, ...b),
        length = Math.hypot(b[0] - a[0], b[1] - a[1]);
      if (length > 3 * ends && Math.min(along, 1 - along) * length < ends) continue;
      if (distance < (best?.distance ?? 5)) best = { line: i / 4, distance };
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

  /** Lights up an edge or a part. */
  setHover(under: PickedLine | null) {
    this.hovered = under;
    this.above.draw();
  }

  drawAbove() {
    this.above.draw();
  }

  private paintAbove(c: CanvasRenderingContext2D): boolean {
    const lit = this.paintHovered(c),
      gripped = paintGrips(c, this.on.grips(), this.lie, this.scene.palette),
      measured = this.on.paintAbove(c, ([x, y]) => onScreen(this.lie, x, y));
    return lit || gripped || measured;
  }

  private paintHovered(c: CanvasRenderingContext2D): boolean {
    const { hovered, lie, scene } = this,
      { shape, palette } = scene;
    if (!hovered || !shape) return false;
    if ('edge' in hovered) {
      const marked = markedWith(shape, hovered.edge);
      strokeEdges(c, lie, shape, (e) => marked.has(e), palette.selected, 3);
    } else {
      fill(c, lie, shape, (part) => part === hovered.part, palette.selected, 0.3);
      strokeBendLinesOf(c, lie, shape, hovered.part, palette.selected);
    }
    return true;
  }

  draw() {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.paint();
      this.above.now();
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
    paintSheet(c, this.lie, scene, shape);
    const writer = new LabelWriter(c, palette.halo);
    this.marks = markFindings(c, this.lie, scene, writer);
    if (this.extent.rectangle) dimensionBlank(c, this.lie, scene, this.extent.rectangle, writer);
    writeLabels(this.lie, scene, shape, writer, () => (this.places ??= labelPlaces(shape)));
  }
}
