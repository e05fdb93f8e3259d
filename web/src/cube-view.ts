import './cube-view.css';
import type { Palette } from './theme.ts';
import type { Vec2 } from './types.ts';
import { cellAt, cellsOf, nameOfSide, sideBeside, sides, type Attitude, type Cell, type Side } from './view-cube.ts';

const size = 92, // pixels
  scale = 25; // of half an edge

/** The cube in a corner of the folded view: how the part is seen, and from where it can be. */
export class CubeView {
  private readonly canvas = document.createElement('canvas');
  private readonly c: CanvasRenderingContext2D;
  private readonly buttons: HTMLButtonElement[];
  private cells: Cell[] = [];
  private attitude: Attitude | null = null;
  private palette: Palette;
  private lit: Side | null = null;
  private focused: Side | null = null;

  private readonly look: (side: Side) => void;
  constructor(box: HTMLElement, palette: Palette, look: (side: Side) => void) {
    this.palette = palette;
    this.look = look;
    const cube = document.createElement('div');
    cube.className = 'cube';
    cube.setAttribute('role', 'group');
    cube.setAttribute('aria-label', 'View from');
    this.canvas.setAttribute('aria-hidden', 'true');
    this.canvas.dataset.testid = 'cube';
    this.c = this.canvas.getContext('2d')!;
    this.buttons = sides.map((side) => this.button(side));
    cube.append(this.canvas, ...this.buttons);
    box.append(cube);
    this.canvas.addEventListener('pointermove', (e) => this.light(this.sideAt(e)));
    this.canvas.addEventListener('pointerleave', () => this.light(null));
    this.canvas.addEventListener('click', (e) => {
      const side = this.sideAt(e);
      if (side) this.look(side);
    });
  }

  /** One of them can be tabbed to, arrow keys go on from there. */
  private button(side: Side): HTMLButtonElement {
    const button = document.createElement('button');
    button.textContent = nameOfSide(side);
    button.dataset.testid = `cube-${nameOfSide(side).toLowerCase().replaceAll(' ', '-')}`;
    button.tabIndex = nameOfSide(side) === 'Front' ? 0 : -1;
    button.addEventListener('click', () => this.look(side));
    button.addEventListener('focus', () => this.focus(side));
    button.addEventListener('blur', () => this.focus(null));
    button.addEventListener('keydown', (e) => {
      const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key];
      if (!step) return;
      e.preventDefault();
      const next = sideBeside(side, step[0]!, step[1]!).join();
      this.buttons[sides.findIndex((s) => s.join() === next)]!.focus();
    });
    return button;
  }

  private focus(side: Side | null) {
    this.focused = side;
    if (side) this.buttons.forEach((b, i) => (b.tabIndex = sides[i]!.join() === side.join() ? 0 : -1));
    this.paint();
  }

  private light(side: Side | null) {
    if (side?.join() === this.lit?.join()) return;
    this.lit = side;
    this.canvas.title = side ? nameOfSide(side) : '';
    this.canvas.style.cursor = side ? 'pointer' : '';
    this.paint();
  }

  private sideAt(e: MouseEvent): Side | null {
    const r = this.canvas.getBoundingClientRect(),
      at: Vec2 = [(e.clientX - r.left - size / 2) / scale, (size / 2 - e.clientY + r.top) / scale];
    return cellAt(this.cells, at)?.side ?? null;
  }

  set(attitude: Attitude, palette: Palette) {
    const same = JSON.stringify(attitude) === JSON.stringify(this.attitude) && palette === this.palette;
    if (same) return;
    this.attitude = attitude;
    this.palette = palette;
    this.paint();
  }

  private paint() {
    if (!this.attitude) return;
    const { c, canvas, palette } = this,
      ratio = window.devicePixelRatio,
      { cells, faces } = cellsOf(this.attitude);
    this.cells = cells;
    canvas.width = canvas.height = Math.round(size * ratio);
    const at = ([x, y]: Vec2): Vec2 => [size / 2 + scale * x, size / 2 - scale * y];
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    for (const { side, corners } of cells) {
      c.beginPath();
      corners.forEach((p) => c.lineTo(...at(p)));
      c.closePath();
      const marked = [this.lit, this.focused].some((s) => s?.join() === side.join());
      c.fillStyle = marked ? palette.selected : palette.fill;
      c.fill();
      c.strokeStyle = palette.dimension;
      c.lineWidth = 0.4;
      c.stroke();
    }
    for (const face of faces) this.name(face, at, ratio);
  }

  private name(face: { name: string; at: Vec2; right: Vec2; up: Vec2 }, at: (p: Vec2) => Vec2, ratio: number) {
    const { c } = this,
      [x, y] = at(face.at);
    c.setTransform(
      ratio * face.right[0],
      -ratio * face.right[1],
      -ratio * face.up[0],
      ratio * face.up[1],
      ratio * x,
      ratio * y,
    );
    c.font = '600 11px system-ui, sans-serif';
    c.textAlign = 'center';
    c.textBaseline = 'middle';
    c.fillStyle = this.palette.label;
    c.fillText(face.name, 0, 0.5);
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
  }
}
