import { Box3, Color, Plane, Scene, Vector3, WebGLRenderer } from 'three';
import { FoldedCamera, type StandardView } from './folded-camera.ts';
import { FoldedLook, isMoved, type FoldedViewEvents } from './folded-look.ts';
import { CubeView } from './cube-view.ts';
import { cutAt, isKept } from './section.ts';
import type { ViewState } from './view-state.ts';
import { PlateGizmo } from './plate-gizmo.ts';
import { HandleObjects, noOverlay, ridgeEnds, type Overlay, type RidgeEnd } from './handles.ts';
import { MachineObject } from './machine-object.ts';
import { drawnInSoftware } from './graphics.ts';
import type { PickedLine } from './lines.ts';
import { SheetObject } from './sheet-object.ts';
import { forcesOf, noForces } from './slit-forces.ts';
import type { NamedPlaces, Solid } from './solid-mesh.ts';
import { SolidObject } from './solid-object.ts';
import { directionThatShows } from './solid-sight.ts';
import { isLarge } from './sheet-lod.ts';
import { ViewOverlay } from './view-overlay.ts';
import type { Palette } from './theme.ts';
import { frameDrawn } from './timings.ts';
import type { Stage } from './stage.ts';
import type { AnchorSpec } from './edits/slit-types.ts';
import type { OrderAnswer, Shape, Vec3 } from './types.ts';

/** What is marked: a row of parts, the number of an edge. */
export interface Picked {
  part: number | null;
  edge: number | null;
}
/** The folded sheet. Draws when something changed, never by the clock. */
export class FoldedView {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly eye: FoldedCamera;
  private readonly plateGizmo: PlateGizmo;
  readonly under: FoldedLook;
  private readonly cube: CubeView;
  private readonly sheet = new SheetObject();
  private readonly solid = new SolidObject();
  private readonly handles = new HandleObjects();
  private readonly machine = new MachineObject();
  private picked: Picked = { part: null, edge: null };
  private hit: number | null = null; // the part that collides
  private glass = false;
  private shape: Shape | null = null;
  private overlay: Overlay = noOverlay;
  private palette: Palette;
  private press: { x: number; y: number; anchor: number | null; plane: Plane; end: RidgeEnd | null } | null = null;
  private frame = 0;
  private readonly above: ViewOverlay;
  private moving = false; // something is being dragged
  private lively = 0; // timer: orbiting or folding has not paused
  private readonly box: HTMLElement;
  private readonly events: FoldedViewEvents;
  constructor(box: HTMLElement, palette: Palette, events: FoldedViewEvents) {
    this.box = box;
    this.events = events;
    this.palette = palette;
    this.renderer = new WebGLRenderer({ antialias: !drawnInSoftware });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    const canvas = this.renderer.domElement;
    canvas.dataset.testid = 'folded-canvas';
    box.append(canvas);
    this.above = new ViewOverlay(box, 'folded-overlay', (c) => this.paintAbove(c));
    this.scene.add(this.sheet.group, this.solid.group, this.handles.group, this.machine.group);
    this.eye = new FoldedCamera(
      canvas,
      () => this.bounds(),
      () => {
        this.stir();
        this.draw();
        this.events.zoomed();
      },
    );
    this.renderer.localClippingEnabled = true;
    this.cube = new CubeView(box.parentElement!, palette, (side) => {
      this.eye.lookFromSide(side);
      this.draw();
    });
    this.under = new FoldedLook(canvas, this.sheet, this.eye, events);
    this.plateGizmo = new PlateGizmo(this.eye.camera, canvas, this.scene, {
      draw: () => this.draw(),
      grab: (grabbed) => {
        this.eye.orbit.enabled = !grabbed;
        if (grabbed) return;
        this.events.dragEnd();
        this.attachGizmo();
      },
      drag: (moved) => {
        if (this.overlay.plate) this.events.dragPlate(this.overlay.plate, moved, performance.now());
      },
    });
    this.listen(canvas);
    new ResizeObserver(() => this.resize()).observe(box);
    this.resize();
    this.eye.look('iso');
  }

  setShape(shape: Shape | null, share: number, thickness: number, picked: Picked, held = 0) {
    this.shape = this.under.shape = shape;
    this.picked = picked;
    this.sheet.group.visible = shape !== null;
    if (shape) {
      this.sheet.setShape(shape, thickness, share, held);
      this.sheet.paint(this.palette, picked.part, picked.edge, this.hit);
    }
    this.showHandles();
    this.draw();
  }

  /** A solid that is refused, and what is named in the reason. `turn`: so that this is seen. */
  setSolid(solid: Solid, named: NamedPlaces, turn: boolean) {
    this.solid.setShape(solid, named);
    this.solid.paint(this.palette, this.glass);
    if (turn && named.faces.length + named.edges.length > 0)
      this.eye.lookTowards(directionThatShows(solid, named, this.eye.corners, this.eye.sides));
    this.draw();
  }

  /** Whether something is being dragged: software rendering then draws fewer pixels. */
  setMoving(moving: boolean) {
    if (moving === this.moving) return;
    this.moving = moving;
    this.adapt();
  }

  /** Orbiting and folding of large parts are drawn with fewer corners, until they pause. */
  private stir() {
    if (!this.shape || !isLarge(this.shape)) return;
    clearTimeout(this.lively);
    this.lively = window.setTimeout(() => {
      this.lively = 0;
      this.adapt();
    }, 160);
    this.adapt();
  }

  /** How many pixels and corners are drawn: circles are left by a quarter of a pixel at rest. */
  private adapt() {
    const moving = this.moving || this.lively > 0,
      ratio = Math.min(window.devicePixelRatio, 2) * (moving && drawnInSoftware ? 0.5 : 1);
    const other = this.sheet.setTolerance((moving ? 0.75 : 0.25) / (this.scale * window.devicePixelRatio));
    if (other) this.sheet.paint(this.palette, this.picked.part, this.picked.edge, this.hit);
    if (ratio !== this.renderer.getPixelRatio()) this.renderer.setPixelRatio(ratio);
    else if (!other) return;
    this.draw();
  }

  setShare(share: number) {
    this.stir();
    this.sheet.setShare(share);
    this.eye.keepInSight();
    this.draw();
  }

  paint(palette: Palette, picked: Picked) {
    this.palette = palette;
    this.picked = picked;
    this.sheet.paint(palette, picked.part, picked.edge, this.hit);
    this.machine.paint(palette);
    this.solid.paint(palette, this.glass);
    this.showHandles();
    this.draw();
  }

  /** What of the sheet is cut away, and whether one sees through it. */
  setSection({ section: { on, along, at, flipped }, seeThrough, bending }: ViewState, inMachine: boolean) {
    this.glass = seeThrough;
    if (this.sheet.setBending(bending)) this.sheet.paint(this.palette, this.picked.part, this.picked.edge, this.hit);
    this.sheet.setGlass(seeThrough, this.palette);
    this.solid.paint(this.palette, seeThrough);
    this.sheet.setSection(on && !inMachine ? (positions) => cutAt(positions, along, at, flipped) : null);
    this.under.isShown = (x, y, z) => !this.sheet.cut || isKept(this.sheet.cut, x, y, z);
    this.draw();
  }

  /** Towards the eye. */
  get direction(): Vec3 {
    return this.eye.direction;
  }

  /** The sheet in the machine; without a stage it is as folded by `share`. Another stroke is fitted unless it plays. */
  setStage(order: OrderAnswer | null, stage: Stage | null, share: number, playing = false) {
    const was = this.machine.group.visible,
      other = stage?.stroke !== this.machine.shown && !playing && this.eye.isFitted,
      hit = stage?.hit?.part ?? null;
    this.machine.set(order, stage);
    this.machine.paint(this.palette);
    this.stir();
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
    this.solid.boundsInto(box);
    this.machine.boundsInto(box);
    return box;
  }

  get hovered() {
    return this.under.hovered;
  }

  get gizmo() {
    return this.plateGizmo.controls;
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
  }

  private down(e: PointerEvent) {
    if (e.button !== 0) return;
    const anchor = this.overlay.handles
      ? this.eye.nearest(
          e,
          this.overlay.anchors.map((a) => this.anchorAt(a)),
          12,
        )
      : null;
    const end = anchor === null && !this.events.measured() ? this.ridgeEndUnder(e) : null,
      at = anchor === null ? end?.at : this.anchorAt(this.overlay.anchors[anchor]!),
      plane = new Plane();
    if (at) {
      plane.setFromNormalAndCoplanarPoint(this.eye.camera.getWorldDirection(new Vector3()), new Vector3(...at));
      this.eye.orbit.enabled = false;
      this.renderer.domElement.setPointerCapture(e.pointerId);
    }
    if (anchor !== null) this.events.pickAnchor(anchor);
    this.press = { x: e.clientX, y: e.clientY, anchor, plane, end };
  }

  private ridgeEndUnder(e: PointerEvent): RidgeEnd | null {
    if (!this.shape || !this.overlay.handles) return null;
    const ends = ridgeEnds(this.shape.handles, this.overlay.ridges),
      end = this.eye.nearest(
        e,
        ends.map((r) => r.at),
        7,
      );
    return end === null ? null : ends[end]!;
  }

  private move(e: PointerEvent) {
    const { press } = this;
    if (!press) return this.under.hover(e);
    if (press.end && isMoved(e, press)) {
      // A strip that is pulled gets an anchor where it was picked up.
      this.events.pickRidgeEnd(press.end);
      press.anchor = this.overlay.anchors.length - 1;
      press.end = null;
    }
    if (press.anchor === null) return;
    const at = this.eye.ray(e).ray.intersectPlane(press.plane, new Vector3());
    const { scale } = this.overlay;
    if (at) this.events.dragAnchor(press.anchor, [at.x / scale, at.y / scale, at.z / scale], performance.now());
  }

  private up(e: PointerEvent) {
    const press = this.press;
    this.press = null;
    if (!press || e.button !== 0) return;
    if (press.anchor !== null || press.end) this.eye.orbit.enabled = true;
    if (press.anchor !== null) return this.events.dragEnd();
    if (press.end) return this.events.pickRidgeEnd(press.end);
    if (isMoved(e, press) || this.plateGizmo.isHeld) return;
    this.click(e);
  }

  private click(e: PointerEvent) {
    const measured = this.events.measured();
    if (measured) return this.events.measurePick(measured.of && this.under.refUnder(measured.of, e));
    const { line, skin } = this.under.under(e);
    if (line && this.events.pickLine(line.line)) return;
    this.events.pickFacet(skin?.facet ?? null, skin?.upper ?? true, skin?.at ?? null);
  }

  /** Lights up an edge or a part. */
  setHover(under: PickedLine | null) {
    this.under.hovered = under;
    const row = under && 'part' in under ? under.part : null;
    if (this.sheet.light(row, this.palette.selected)) this.draw();
    this.above.draw();
  }

  drawAbove() {
    this.above.draw();
  }

  private paintAbove(c: CanvasRenderingContext2D): boolean {
    const lit = this.under.paint(c, this.palette.selected);
    const measured = this.events.paintAbove(c, (at) => {
      const p = this.eye.toScreen(at);
      return [p.x, p.y];
    });
    const named = this.solid.paintNames(c, this.palette, this.direction, (at) => this.eye.toScreen(at));
    return lit || measured || named;
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
      this.overlay.handles ? forcesOf(this.shape, this.overlay.loads) : noForces,
    );
  }

  private attachGizmo() {
    const { plate, handles, gizmo } = this.overlay,
      own = handles ? this.shape?.handles.plates?.find((p) => p.id === plate) : undefined;
    this.plateGizmo.attach(own?.corners, gizmo);
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
      this.above.now();
      this.cube.set(this.eye.attitude(), this.palette);
      frameDrawn();
    });
  }
}
