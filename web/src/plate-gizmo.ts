import { Matrix4, Object3D, Vector3, type Camera, type Scene } from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import type { Vec3 } from './types.ts';

export interface GizmoEvents {
  draw(): void;
  grab(grabbed: boolean): void; // orbiting rests meanwhile
  drag(moved: Matrix4): void;
}

/** Moves and turns a plate. */
export class PlateGizmo {
  readonly controls: TransformControls;
  private readonly grip = new Object3D();
  private readonly start = new Matrix4();

  constructor(camera: Camera, canvas: HTMLCanvasElement, scene: Scene, events: GizmoEvents) {
    this.controls = new TransformControls(camera, canvas);
    this.controls.setSize(0.8);
    scene.add(this.grip, this.controls.getHelper());
    this.controls.addEventListener('change', () => {
      if (!this.controls.dragging) events.draw();
    }); // else the next geometry does
    this.controls.addEventListener('dragging-changed', (e) => {
      if (e.value) this.start.copy(this.grip.matrixWorld);
      events.grab(Boolean(e.value));
    });
    this.controls.addEventListener('objectChange', () => {
      this.grip.updateMatrix();
      events.drag(this.grip.matrix.clone().multiply(this.start.clone().invert()));
    });
  }

  /** Whether the pointer is on it, or drags it. */
  get isHeld() {
    return this.controls.dragging || this.controls.axis !== null;
  }

  /**
   * It stands in the middle of the plate and is left alone while it is dragged: then it leads and the plate follows.
   */
  attach(corners: Vec3[] | undefined, mode: 'translate' | 'rotate') {
    const { controls, grip } = this;
    if (controls.dragging) return;
    if (!corners) {
      controls.detach();
      return;
    }
    const middle = new Vector3();
    for (const c of corners) middle.add(new Vector3(...c));
    grip.position.copy(middle.divideScalar(corners.length));
    grip.quaternion.identity();
    grip.scale.set(1, 1, 1);
    grip.updateMatrixWorld(true);
    controls.setMode(mode);
    controls.attach(grip);
  }
}
