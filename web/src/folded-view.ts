import { Box3, Color, Matrix4, Object3D, Plane, Raycaster, Scene, Vector3, WebGLRenderer } from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import { FoldedCamera, type StandardView } from './folded-camera.ts';
import { HandleObjects, ridgeEnds, type RidgeEnd } from './handles.ts';
import { MachineObject } from './machine-object.ts';
import { drawnInSoftware } from './graphics.ts';
import { distanceToSegment, type PickedLine } from './lines.ts';
import { SheetObject } from './sheet-object.ts';
import type { Palette } from './theme.ts';
import { frameDrawn } from './timings.ts';
import type { Stage } from './stage.ts';
import type { AnchorSpec, OrderAnswer, Shape, Vec3 } from './types.ts';

export interface FoldedViewEvents {
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

export interface Overlay {
  anchors: AnchorSpec[];
  scale: number; // millimetres in a unit of the anchors
  plate: string | null;
  numbered: string[]; // plates whose edges bear their numbers
  anchor: number | null;
  gizmo: 'translate' | 'rotate';
  ridges: number; // of a strip before it is subdivided
  handles: boolean; // whether handles fit what is shown: not while it is partly folded
}

/** What is marked: a row of parts, the number of an edge. */
export interface Picked {
  part: number | null;
  edge: number | null;
}
interface Point {
  x: number;
  y: number;
}

/** The folded sheet. Draws when something changed, never by the clock. */
export class FoldedView {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly eye: FoldedCamera;
  private readonly gizmo: TransformControls;
  private readonly grip = new Object3D();
  private readonly sheet = new SheetObject();
  private readonly handles = new HandleObjects();
  private readonly machine = new MachineObject();
  private picked: Picked = { part: null, edge: null };
  private hit: number | null = null; // the part that collides
  private shape: Shape | null = null;
  private overlay: Overlay = {
    anchors: [],
    scale: 1,
    plate: null,
    numbered: [],
    anchor: null,
    gizmo: 'translate',
    handles: true,
    ridges: 10,
  };
  private palette: Palette;
  private gripStart = new Matrix4();
  private press: { x: number; y: number; anchor: number | null; plane: Plane } | null = null;
  private frame = 0;
  private readonly box: HTMLElement;
  private readonly events: FoldedViewEvents;
  constructor(box: HTMLElement, palette: Palette, events: FoldedViewEvents) {
    this.box = box;
    this.events = events;
    this.palette = palette;
    this.renderer = new WebGLRenderer({ antialias: !drawnInSoftware });
    this.setMoving(false);
    const canvas = this.renderer.domElement;
    canvas.dataset.testid = 'folded-canvas';
    box.append(canvas);
    this.scene.add(this.sheet.group, this.handles.group, this.machine.group, this.grip);
    this.eye = new FoldedCamera(
      canvas,
      () => this.bounds(),
      () => {
        this.draw();
        this.events.zoomed();
      },
    );
    this.gizmo = new TransformControls(this.eye.camera, canvas);
    this.gizmo.setSize(0.8);
    this.scene.add(this.gizmo.getHelper());
    this.listen(canvas);
    new ResizeObserver(() => this.resize()).observe(box);
    this.resize();
    this.eye.look('iso');
  }

  setShape(shape: Shape | null, share: number, thickness: number, picked: Picked, held = 0) {
    this.shape = shape;
    this.picked = picked;
    this.sheet.group.visible = shape !== null;
    if (shape) {
      this.sheet.setShape(shape, thickness, share, held);
      this.sheet.paint(this.palette, picked.part, picked.edge, this.hit);
    }
    this.showHandles();
    this.draw();
  }

  /** Whether something is being dragged: software rendering then draws fewer pixels. */
  setMoving(moving: boolean) {
    const ratio = Math.min(window.devicePixelRatio, 2) * (moving && drawnInSoftware ? 0.6 : 1);
    if (ratio === this.renderer.getPixelRatio()) return;
    this.renderer.setPixelRatio(ratio);
    this.draw();
  }

  setShare(share: number) {
    this.sheet.setShare(share);
    this.eye.keepInSight();
    this.draw();
  }

  paint(palette: Palette, picked: Picked) {
    this.palette = palette;
    this.picked = picked;
    this.sheet.paint(palette, picked.part, picked.edge, this.hit);
    this.machine.paint(palette);
    this.showHandles();
    this.draw();
  }

  /** The sheet in the machine; without a stage it is as folded by `share`. Another stroke is fitted unless it plays. */
  setStage(order: OrderAnswer | null, stage: Stage | null, share: number, playing = false) {
    const was = this.machine.group.visible,
      other = stage?.stroke !== this.machine.shown && !playing && this.eye.isFitted,
      hit = stage?.hit?.part ?? null;
    this.machine.set(order, stage);
    this.machine.paint(this.palette);
    if (stage) this.sheet.setPose(stage.pose);
    else this.sheet.setShare(share);
    if (hit !== this.hit) {
      this.hit = hit;
      this.sheet.paint(this.palette, this.picked.part, this.picked.edge, hit);
    }
    if (was !== this.machine.group.visible) {
      if (was) this.eye.look('iso');
      else this.eye.lookAtMachine();
    } else if (other) this.eye.fit();
    else this.eye.keepInSight();
    this.draw();
  }

  setOverlay(overlay: Overlay) {
    this.overlay = overlay;
    this.showHandles();
    this.attachGizmo();
    this.draw();
  }

  fit() {
    this.eye.fit();
    this.draw();
  }

  /** Of all that is to be seen. */
  private bounds(): Box3 {
    const box = new Box3();
    this.sheet.boundsInto(box);
    this.machine.boundsInto(box);
    return box;
  }

  get camera() {
    return this.eye.camera;
  }

  /** Pixels a millimetre. */
  get scale() {
    return this.eye.camera.zoom;
  }

  look(view: StandardView) {
    this.eye.look(view);
    this.draw();
  }

  /** The axis of space that is upright. */
  setUp(up: 'y' | 'z') {
    this.eye.setUp(up);
    this.draw();
  }

  /** Where a point in space appears, in client coordinates; for tests. */
  project(at: Vec3): { x: number; y: number } {
    const p = this.eye.toScreen(at),
      r = this.renderer.domElement.getBoundingClientRect();
    return { x: r.left + p.x, y: r.top + p.y };
  }

  private listen(canvas: HTMLCanvasElement) {
    canvas.addEventListener('pointerdown', (e) => this.down(e), true);
    canvas.addEventListener('pointermove', (e) => this.move(e));
    canvas.addEventListener('pointerup', (e) => this.up(e));
    this.gizmo.addEventListener('change', () => {
      if (!this.gizmo.dragging) this.draw();
    }); // else the next geometry does
    this.gizmo.addEventListener('dragging-changed', (e) => {
      this.eye.orbit.enabled = !e.value;
      if (e.value) this.gripStart.copy(this.grip.matrixWorld);
      else {
        this.events.dragEnd();
        this.attachGizmo();
      }
    });
    this.gizmo.addEventListener('objectChange', () => {
      this.grip.updateMatrix();
      const moved = this.grip.matrix.clone().multiply(this.gripStart.clone().invert());
      if (this.overlay.plate) this.events.dragPlate(this.overlay.plate, moved, performance.now());
    });
  }

  private down(e: PointerEvent) {
    if (e.button !== 0) return;
    const anchor = this.overlay.handles
      ? this.nearest(
          e,
          this.overlay.anchors.map((a) => this.anchorAt(a)),
          12,
        )
      : null;
    const plane = new Plane();
    if (anchor !== null) {
      const at = new Vector3(...this.anchorAt(this.overlay.anchors[anchor]!));
      plane.setFromNormalAndCoplanarPoint(this.eye.camera.getWorldDirection(new Vector3()), at);
      this.eye.orbit.enabled = false;
      this.renderer.domElement.setPointerCapture(e.pointerId);
      this.events.pickAnchor(anchor);
    }
    this.press = { x: e.clientX, y: e.clientY, anchor, plane };
  }

  private move(e: PointerEvent) {
    if (!this.press || this.press.anchor === null) return;
    const at = this.eye.ray(e).ray.intersectPlane(this.press.plane, new Vector3());
    const { scale } = this.overlay;
    if (at) this.events.dragAnchor(this.press.anchor, [at.x / scale, at.y / scale, at.z / scale], performance.now());
  }

  private up(e: PointerEvent) {
    const press = this.press;
    this.press = null;
    if (!press || e.button !== 0) return;
    if (press.anchor !== null) {
      this.eye.orbit.enabled = true;
      this.events.dragEnd();
      return;
    }
    if (Math.hypot(e.clientX - press.x, e.clientY - press.y) > 4 || this.gizmo.dragging || this.gizmo.axis) return;
    this.click(e);
  }

  private click(e: PointerEvent) {
    if (this.shape && this.overlay.handles) {
      const ends = ridgeEnds(this.shape.handles, this.overlay.ridges),
        end = this.nearest(
          e,
          ends.map((r) => r.at),
          7,
        );
      if (end !== null) return this.events.pickRidgeEnd(ends[end]!);
    }
    const line = this.lineUnder(e);
    if (line && this.events.pickLine(line)) return;
    const hit = this.sheet.empty ? undefined : this.eye.ray(e).intersectObject(this.sheet.skin, false)[0];
    const found = hit?.faceIndex === undefined || hit.faceIndex === null ? null : this.sheet.facetOf(hit.faceIndex);
    this.events.pickFacet(found?.facet ?? null, found?.upper ?? true, hit ? (hit.point.toArray() as Vec3) : null);
  }

  /** The line nearest to the pointer of those that are near and not hidden by the sheet. */
  private lineUnder(e: PointerEvent): PickedLine | null {
    const r = this.renderer.domElement.getBoundingClientRect(),
      x = e.clientX - r.left,
      y = e.clientY - r.top;
    const near = this.sheet
      .lines()
      .flatMap(({ line, ends }) => {
        const [a, b] = ends.map((end) => this.eye.toScreen(end)) as [Point, Point],
          { distance, along } = distanceToSegment(x, y, a.x, a.y, b.x, b.y);
        return distance < 5
          ? [{ line, distance, at: new Vector3(...ends[0]).lerp(new Vector3(...ends[1]), along) }]
          : [];
      })
      .sort((a, b) => a.distance - b.distance);
    return near.slice(0, 12).find(({ at }) => this.isSeen(at))?.line ?? null;
  }

  private isSeen(at: Vector3): boolean {
    const direction = this.eye.camera.getWorldDirection(new Vector3()),
      ray = new Raycaster(at.clone().addScaledVector(direction, -8 * this.eye.radius), direction);
    const hit = ray.intersectObject(this.sheet.skin, false)[0];
    return !hit || hit.distance > 8 * this.eye.radius - Math.max(this.sheet.depth, 0.004 * this.eye.radius);
  }

  private nearest(e: PointerEvent, places: Vec3[], within: number): number | null {
    const r = this.renderer.domElement.getBoundingClientRect();
    let best: number | null = null,
      least = within;
    places.forEach((place, i) => {
      const p = this.eye.toScreen(place),
        d = Math.hypot(p.x - (e.clientX - r.left), p.y - (e.clientY - r.top));
      if (d < least) {
        least = d;
        best = i;
      }
    });
    return best;
  }

  private anchorAt = (a: AnchorSpec): Vec3 => a.at.map((v) => v * this.overlay.scale) as Vec3;

  private showHandles() {
    const shown = this.overlay.handles ? (this.shape?.handles ?? {}) : {};
    this.handles.set(
      shown,
      this.overlay.handles ? this.overlay.anchors : [],
      this.palette,
      this.overlay,
      this.overlay.scale,
      this.overlay.ridges,
    );
  }

  /**
   * The gizmo stands in the middle of the plate and is left alone while it is dragged: then it leads and the plate
   * follows.
   */
  private attachGizmo() {
    if (this.gizmo.dragging) return;
    const plate = this.overlay.handles
      ? this.shape?.handles.plates?.find((p) => p.id === this.overlay.plate)
      : undefined;
    if (!plate) {
      this.gizmo.detach();
      return;
    }
    const middle = new Vector3();
    for (const c of plate.corners) middle.add(new Vector3(...c));
    this.grip.position.copy(middle.divideScalar(plate.corners.length));
    this.grip.quaternion.identity();
    this.grip.scale.set(1, 1, 1);
    this.grip.updateMatrixWorld(true);
    this.gizmo.setMode(this.overlay.gizmo);
    this.gizmo.attach(this.grip);
  }

  /** After new geometry: handles may have moved with it. */
  follow() {
    this.attachGizmo();
  }

  private resize() {
    const { clientWidth: w, clientHeight: h } = this.box;
    if (w === 0 || h === 0) return;
    this.renderer.setSize(w, h);
    this.eye.resize(w, h);
    this.draw();
  }

  draw() {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.renderer.setClearColor(new Color(this.palette.background));
      this.renderer.render(this.scene, this.eye.camera);
      frameDrawn();
    });
  }
}
