import type { Matrix4 } from 'three';
import type { FoldedCamera } from './folded-camera.ts';
import type { RidgeEnd } from './handles.ts';
import { markedWith, partOfEdge, type PickedLine } from './lines.ts';
import type { MeasuringEvents } from './measure/events.ts';
import { refOfEdge, snapAt } from './measure/snap.ts';
import { inPlace, type Measured, type Ref } from './measure/things.ts';
import { extentAlong } from './section.ts';
import type { SheetObject } from './sheet-object.ts';
import { Sight, type SeenLine, type SeenSkin, type Shown } from './sight.ts';
import type { Shape, Vec2, Vec3 } from './types.ts';

export interface LookEvents extends MeasuringEvents {
  /** What lies under the resting pointer. */
  hover(under: PickedLine | null): void;
}

export interface FoldedViewEvents extends LookEvents {
  /** Whether the line was used; else the part behind it is picked. */
  pickLine(line: PickedLine): boolean;
  pickFacet(facet: number | null, upper: boolean, at: Vec3 | null): void;
  pickAnchor(anchor: number): void;
  pickRidgeEnd(end: RidgeEnd): void;
  dragAnchor(anchor: number, at: Vec3, event: number): void;
  dragPlate(id: string, moved: Matrix4, event: number): void;
  dragEnd(): void;
  zoomed(): void;
}

/** Whether a pointer went farther than a click does. */
export const isMoved = (e: PointerEvent, from: { x: number; y: number }) =>
  Math.hypot(e.clientX - from.x, e.clientY - from.y) > 4;

/** What of the folded sheet lies under the pointer: to be picked, lit up, or measured. */
export class FoldedLook {
  shape: Shape | null = null;
  isShown: Shown = () => true;
  hovered: PickedLine | null = null;
  private readonly sight = new Sight();
  private pointer: PointerEvent | null = null; // that is still to be looked at

  private readonly canvas: HTMLCanvasElement;
  private readonly sheet: SheetObject;
  private readonly eye: FoldedCamera;
  private readonly events: LookEvents;
  constructor(canvas: HTMLCanvasElement, sheet: SheetObject, eye: FoldedCamera, events: LookEvents) {
    this.canvas = canvas;
    this.sheet = sheet;
    this.eye = eye;
    this.events = events;
    canvas.addEventListener('pointerdown', () => (this.pointer = null));
    canvas.addEventListener('pointerleave', () => {
      this.pointer = null;
      events.hover(null);
      events.measureHover(null);
    });
  }

  /** What of the sheet is seen under the pointer: a line that is near, and the skin. */
  under(e: PointerEvent): { line: SeenLine | null; skin: SeenSkin | null } {
    const r = this.canvas.getBoundingClientRect(),
      [x, y] = [e.clientX - r.left, e.clientY - r.top];
    if (!this.shape) return { line: null, skin: null };
    this.sight.look(this.sheet.drawn, this.sheet.version, this.eye.camera, r.width, r.height);
    return { line: this.sight.lineAt(x, y, 5, this.slack, this.isShown), skin: this.sight.skinAt(x, y, this.isShown) };
  }

  /** How far behind a skin lines may lie that are seen. */
  private get slack() {
    return Math.max(this.sheet.depth, 0.004 * this.eye.radius);
  }

  /** Says what lies under the pointer, once a frame. */
  hover(e: PointerEvent) {
    const waiting = this.pointer !== null;
    this.pointer = e;
    if (waiting) return;
    requestAnimationFrame(() => {
      const at = this.pointer;
      this.pointer = null;
      if (!at) return;
      const measured = this.events.measured();
      if (measured) return this.hoverMeasured(measured.of, at);
      const { line, skin } = this.under(at),
        row = skin && this.shape?.facet_part[skin.facet];
      this.events.hover(line?.line ?? (row === null || row === undefined ? null : { part: row }));
    });
  }

  /** Marks what would be measured; of a flange all of it. */
  private hoverMeasured(of: Measured | null, e: PointerEvent) {
    const ref = of && this.refUnder(of, e);
    this.events.measureHover(ref);
    this.events.hover(ref?.kind === 'flange' || ref?.kind === 'bend' ? { part: ref.part } : null);
  }

  /** What would be measured from or to: a corner, a middle or a centre before a line, a line before a flange. */
  refUnder(of: Measured, e: PointerEvent): Ref | null {
    const { line, skin } = this.under(e),
      r = this.canvas.getBoundingClientRect();
    const snapped = snapAt(
      of,
      'folded',
      (...at) => this.toScreen(at),
      [e.clientX - r.left, e.clientY - r.top],
      (at, _upper, place) => this.isInFront(at, place),
      line && 'edge' in line.line ? { edge: line.line.edge, upper: line.upper, distance: line.distance } : null,
    );
    if (snapped) return snapped;
    const edge = line && 'edge' in line.line ? refOfEdge(of, line.line.edge, line.upper) : null,
      part = skin ? of.shape.facet_part[skin.facet]! : null;
    if (edge && of.shape.parts[partOfEdge(of.shape, (line!.line as { edge: number }).edge)!]?.place) return edge;
    if (part === null) return null;
    const at = inPlace(of.shape, part, skin!.at);
    return at ? { kind: 'flange', part, upper: skin!.upper, at } : { kind: 'bend', part, line: 0 };
  }

  /** How long the sheet is along a direction, as it is folded now, mm. */
  lengthAlong(along: Vec3): number {
    const [low, high] = extentAlong(this.sheet.drawn?.positions ?? new Float32Array(3), along);
    return high - low;
  }

  /** Whether a place of the sheet is there to be seen. */
  isSeen(place: Vec3): boolean {
    const r = this.canvas.getBoundingClientRect();
    this.sight.look(this.sheet.drawn, this.sheet.version, this.eye.camera, r.width, r.height);
    return this.isInFront(this.toScreen(place), place);
  }

  private isInFront(at: Vec2, place: Vec3): boolean {
    const front = this.sight.skinAt(...at, this.isShown);
    return this.isShown(...place) && (!front || front.depth > this.sight.depthOf(place) - this.slack);
  }

  private toScreen(at: Vec3): Vec2 {
    const p = this.eye.toScreen(at);
    return [p.x, p.y];
  }

  /** Draws the lines of what is lit up. */
  paint(c: CanvasRenderingContext2D, color: string): boolean {
    const { hovered, shape } = this;
    if (!hovered || !shape) return false;
    const marked = 'edge' in hovered ? markedWith(shape, hovered.edge) : null,
      lines = this.sheet.linesOf((line) =>
        'edge' in line ? (marked?.has(line.edge) ?? false) : 'part' in hovered && line.part === hovered.part,
      );
    if (!lines.length) return false;
    c.beginPath();
    for (const { ends } of lines) {
      const [a, b] = [this.eye.toScreen(ends[0]), this.eye.toScreen(ends[1])];
      c.moveTo(a.x, a.y);
      c.lineTo(b.x, b.y);
    }
    c.strokeStyle = color;
    c.lineWidth = 3;
    c.lineCap = 'round';
    c.stroke();
    return true;
  }
}
