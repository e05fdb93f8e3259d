import { insideFacet } from './facet.ts';
import { findingUnder, type FindingMark } from './finding-marks.ts';
import { extentOf, fitted, type Extent } from './flat-fit.ts';
import { LabelWriter } from './flat-labels.ts';
import { paintSheet } from './flat-paint.ts';
import { emptyScene, inPattern, onScreen, type FlatScene, type Lie } from './flat-scene.ts';
import { dimensionBlank, markFindings, writeLabels } from './flat-text.ts';
import { drawnInSoftware } from './graphics.ts';
import { labelPlaces, type Place } from './label-places.ts';
import { distanceToSegment, type PickedLine } from './lines.ts';
import type { Palette } from './theme.ts';
import type { Shape, Vec2 } from './types.ts';

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
  private lie: Lie = { scale: 1, offset: [0, 0] };
  private fittedScale = 1;
  private extent: Extent = extentOf(new Float32Array([0, 0, 1, 1]));
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
    this.scene = emptyScene(palette);
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
      this.press = { x: e.clientX, y: e.clientY, moved: false };
      canvas.setPointerCapture(e.pointerId);
    });
    canvas.addEventListener('pointermove', (e) => {
      if (!this.press) return this.hovered(e);
      const dx = e.clientX - this.press.x,
        dy = e.clientY - this.press.y;
      if (!this.press.moved && Math.hypot(dx, dy) < 4) return;
      this.press = { x: e.clientX, y: e.clientY, moved: true };
      const { scale, offset } = this.lie;
      this.lie = { scale, offset: [offset[0] + dx, offset[1] + dy] };
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
    canvas.addEventListener('dblclick', () => this.fit());
  }

  private clicked(e: PointerEvent) {
    const { shape } = this.scene;
    if (!shape) return this.on.pick(null, null);
    const r = this.canvas.getBoundingClientRect(),
      sx = e.clientX - r.left,
      sy = e.clientY - r.top;
    const [x, y] = inPattern(this.lie, sx, sy),
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
      const a = onScreen(this.lie, lines[4 * i]!, lines[4 * i + 1]!),
        b = onScreen(this.lie, lines[4 * i + 2]!, lines[4 * i + 3]!);
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
    paintSheet(c, this.lie, scene, shape);
    const writer = new LabelWriter(c, palette.halo);
    this.marks = markFindings(c, this.lie, scene, writer);
    if (this.extent.rectangle) dimensionBlank(c, this.lie, scene, this.extent.rectangle, writer);
    writeLabels(this.lie, scene, shape, writer, () => (this.places ??= labelPlaces(shape)));
  }
}
