/** A drawing above a view that lets the pointer through: what is hovered, and what is measured. */
export class ViewOverlay {
  private readonly canvas = document.createElement('canvas');
  private readonly c: CanvasRenderingContext2D;
  private frame = 0;
  private size: [number, number] = [0, 0]; // asking for it in a frame would lay out the page once more
  private readonly paint: (c: CanvasRenderingContext2D) => boolean; // whether there was anything to draw
  constructor(box: HTMLElement, name: string, paint: (c: CanvasRenderingContext2D) => boolean) {
    this.paint = paint;
    this.canvas.dataset.testid = name;
    this.canvas.className = 'overlay';
    this.canvas.setAttribute('aria-hidden', 'true');
    this.c = this.canvas.getContext('2d')!;
    box.append(this.canvas);
    new ResizeObserver(() => {
      this.size = [box.clientWidth, box.clientHeight];
      this.draw();
    }).observe(box);
  }

  draw() {
    this.frame ||= requestAnimationFrame(() => this.now());
  }

  /** At once, in the frame in which the view below is drawn. */
  now() {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    const [w, h] = this.size,
      ratio = window.devicePixelRatio,
      [width, height] = [Math.round(w * ratio), Math.round(h * ratio)];
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
      this.canvas.style.width = `${w}px`;
      this.canvas.style.height = `${h}px`;
    }
    this.c.setTransform(ratio, 0, 0, ratio, 0, 0);
    if (!this.canvas.hidden) this.c.clearRect(0, 0, w, h);
    this.canvas.hidden = !this.paint(this.c); // an empty one costs nothing
  }
}
