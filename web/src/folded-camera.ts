import { Box3, OrthographicCamera, Raycaster, Sphere, Vector2, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Vec3 } from './types.ts';
import { sides, type Attitude } from './view-cube.ts';

export type StandardView = 'front' | 'top' | 'right' | 'iso';

/** From where one looks, with z up; the pole is never quite reached, since orbiting keeps up what is up. */
const directions: Record<StandardView, Vec3> = {
  front: [0, -1, 0],
  top: [0, -1e-4, 1],
  right: [1, 0, 0],
  iso: [1, -1.25, 0.95],
};
/** From low in front of the machine, beside the operator: the sides of a bend are seen, not their edges. */
const beforeMachine: Vec3 = [1, -0.9, 0.42];

const buttons = 66; // px, the height that they take at the top of the view

/** From where the folded sheet is seen: orbiting, fitting, and between space and screen. */
export class FoldedCamera {
  readonly camera = new OrthographicCamera(-1, 1, 1, -1, -1000, 1000);
  orbit: OrbitControls;
  radius = 100; // of what was fitted
  private upright: 'y' | 'z' = 'z';
  // Until the user zooms or pans; `set`: the zoom that was set.
  private fitted: { target: Vector3; zoom: number; set: number } | null = null;

  private room = 1; // half of the height for what is fitted, px
  private readonly canvas: HTMLCanvasElement;
  private readonly bounds: () => Box3; // of all that is to be seen
  private readonly moved: () => void;
  constructor(canvas: HTMLCanvasElement, bounds: () => Box3, moved: () => void) {
    this.canvas = canvas;
    this.bounds = bounds;
    this.moved = moved;
    this.camera.up.set(0, 0, 1);
    this.orbit = this.orbiting();
  }

  fit() {
    const box = this.bounds();
    if (box.isEmpty()) return;
    const { camera, orbit } = this,
      sphere = box.getBoundingSphere(new Sphere());
    this.radius = Math.max(sphere.radius, 1e-3);
    const direction = camera.position.clone().sub(orbit.target).normalize();
    orbit.target.copy(sphere.center);
    camera.position.copy(sphere.center).addScaledVector(direction, 4 * this.radius);
    camera.near = -8 * this.radius;
    camera.far = 16 * this.radius;
    camera.zoom = 0.88 * this.fittingZoom(box, direction, sphere.center);
    camera.updateProjectionMatrix();
    orbit.update();
    // beyond there is nothing to be seen
    [orbit.minZoom, orbit.maxZoom] = [camera.zoom / 50, camera.zoom * 2000];
    this.fitted = { target: orbit.target.clone(), zoom: camera.zoom, set: camera.zoom };
  }

  /** Whether the view is as fitted, except for its direction. */
  get isFitted() {
    return (
      this.fitted !== null &&
      this.fitted.set === this.camera.zoom &&
      this.fitted.target.distanceTo(this.orbit.target) < 1e-6 * this.radius
    );
  }

  /** A sheet grows as it unfolds: the view zooms out as far as needed, and returns once the sheet is folded. */
  keepInSight() {
    const box = this.bounds(),
      { camera } = this;
    if (!this.fitted || !this.isFitted || box.isEmpty()) return;
    const { target, zoom } = this.fitted,
      reach = Math.max(
        this.radius,
        box.getBoundingSphere(new Sphere()).radius + box.getCenter(new Vector3()).distanceTo(target),
      );
    camera.near = -8 * reach;
    camera.far = 16 * reach;
    camera.zoom = this.fitted.set = Math.min(
      zoom,
      0.96 * this.fittingZoom(box, camera.position.clone().sub(target).normalize(), target),
    );
    camera.updateProjectionMatrix();
  }

  look(view: StandardView) {
    const [x, y, z] = directions[view];
    this.lookFrom(view === 'iso' && this.upright === 'y' ? [-x, y, z] : [x, y, z]);
  }

  /** The directions of the corners of the view cube, that of the isometric view first. */
  get corners(): Vec3[] {
    const [x, y, z] = directions.iso,
      about = [0, 1, 2, 3].map((quarter): Vec3 => {
        const [c, s] = [
          [1, 0],
          [0, 1],
          [-1, 0],
          [0, -1],
        ][quarter]!;
        return [c! * x - s! * y, s! * x + c! * y, z];
      });
    return [...about, ...about.map(([a, b, c]): Vec3 => [a, b, -c])].map((d) => this.inSpace(d).toArray());
  }

  /** The directions of the sides and edges of the view cube. */
  get sides(): Vec3[] {
    return sides
      .filter((side) => side.includes(0))
      .map(([x, y, z]) => this.inSpace([x, y || (x ? 0 : -1e-4), z]).toArray());
  }

  /** From a direction of space. */
  lookTowards(eye: Vec3) {
    this.camera.position.copy(this.orbit.target).add(new Vector3(...eye).setLength(4 * this.radius));
    this.orbit.update();
    this.fit();
  }

  lookAtMachine() {
    this.lookFrom(beforeMachine);
  }

  /** From a side of the view cube. */
  lookFromSide([x, y, z]: Vec3) {
    this.lookFrom(x || y ? [x, y, z] : [0, -1e-4, z]);
  }

  /** Where the axes of the view cube point on the screen: right, up, towards the eye. */
  attitude(): Attitude {
    this.camera.updateMatrixWorld();
    const e = this.camera.matrixWorldInverse.elements;
    const axis = (side: Vec3): Vec3 => {
      const [x, y, z] = this.inSpace(side).toArray();
      return [0, 1, 2].map((k) => Number((e[k]! * x + e[4 + k]! * y + e[8 + k]! * z).toFixed(5))) as Vec3;
    };
    return { axes: [axis([1, 0, 0]), axis([0, 1, 0]), axis([0, 0, 1])] };
  }

  /** Towards the eye. */
  get direction(): Vec3 {
    return this.camera.getWorldDirection(new Vector3()).negate().toArray();
  }

  /** A direction that is given with z up. */
  private inSpace([x, y, z]: Vec3) {
    return this.upright === 'z' ? new Vector3(x, y, z) : new Vector3(-x, z, y);
  }

  private lookFrom(from: Vec3) {
    const direction = this.inSpace(from);
    this.camera.position.copy(this.orbit.target).addScaledVector(direction.normalize(), 4 * this.radius);
    this.orbit.update();
    this.fit();
  }

  /** The axis of space that is upright. */
  setUp(up: 'y' | 'z') {
    if (up === this.upright) return;
    this.upright = up;
    this.camera.up.set(0, up === 'y' ? 1 : 0, up === 'z' ? 1 : 0);
    const { target } = this.orbit;
    this.orbit.dispose();
    this.orbit = this.orbiting(); // it takes its axis once, when it is made
    this.orbit.target.copy(target);
    this.look('iso');
  }

  private orbiting(): OrbitControls {
    const orbit = new OrbitControls(this.camera, this.canvas);
    orbit.zoomToCursor = true;
    orbit.addEventListener('change', this.moved);
    return orbit;
  }

  /** The zoom at which the box just fills the view centred on `center`. */
  private fittingZoom(box: Box3, direction: Vector3, center: Vector3): number {
    const right = new Vector3().crossVectors(this.camera.up, direction).normalize(),
      top = new Vector3().crossVectors(direction, right);
    let w = 1e-6,
      h = 1e-6;
    for (let i = 0; i < 8; ++i) {
      const corner = new Vector3(
        i & 1 ? box.max.x : box.min.x,
        i & 2 ? box.max.y : box.min.y,
        i & 4 ? box.max.z : box.min.z,
      ).sub(center);
      w = Math.max(w, Math.abs(corner.dot(right)));
      h = Math.max(h, Math.abs(corner.dot(top)));
    }
    return Math.min(this.camera.right / w, this.room / h);
  }

  resize(width: number, height: number) {
    const { camera } = this;
    camera.left = -width / 2;
    camera.right = width / 2;
    // What is fitted stays clear of the buttons at the top.
    const taken = Math.min(buttons, height / 4);
    this.room = (height - taken) / 2;
    camera.top = height / 2;
    camera.bottom = -height / 2;
    camera.setViewOffset(width, height, 0, -taken / 2, width, height);
    camera.updateProjectionMatrix();
    if (this.isFitted) this.fit();
  }

  /** Where a point in space appears, in pixels of the view. */
  toScreen(at: Vec3) {
    const p = new Vector3(...at).project(this.camera);
    return { x: ((p.x + 1) / 2) * this.canvas.clientWidth, y: ((1 - p.y) / 2) * this.canvas.clientHeight };
  }

  /** The place that appears nearest to the pointer, if it is within some pixels of it. */
  nearest(e: PointerEvent, places: Vec3[], within: number): number | null {
    const r = this.canvas.getBoundingClientRect();
    let best: number | null = null,
      least = within;
    places.forEach((place, i) => {
      const p = this.toScreen(place),
        d = Math.hypot(p.x - (e.clientX - r.left), p.y - (e.clientY - r.top));
      if (d < least) [best, least] = [i, d];
    });
    return best;
  }

  ray(e: PointerEvent): Raycaster {
    const r = this.canvas.getBoundingClientRect(),
      ray = new Raycaster();
    ray.setFromCamera(
      new Vector2(((e.clientX - r.left) / r.width) * 2 - 1, 1 - ((e.clientY - r.top) / r.height) * 2),
      this.camera,
    );
    return ray;
  }
}
