/** From a drag event to new geometry in the renderer's hands, and to the frame that shows it; in milliseconds. */
export interface DragTiming { toGeometry: number; toFrame: number | null }

declare global {
  interface Window { planishTimings: DragTiming[] }
}

const most = 2000;
let waiting: { entry: DragTiming; from: number }[] = [];

export interface Timing { geometry(): void }

export function beginTiming(from: number): Timing {
  performance.mark('planish:drag');
  return {
    geometry() {
      const now = performance.now();
      performance.measure('planish:drag', { start: from, end: now });
      const entry: DragTiming = { toGeometry: now - from, toFrame: null };
      window.planishTimings.push(entry);
      if (window.planishTimings.length > most) window.planishTimings.shift();
      waiting.push({ entry, from });
    },
  };
}

export function dropTiming(timing: Timing | null) {
  if (timing) performance.clearMarks('planish:drag');
}

/** To be called when a frame has been drawn. */
export function frameDrawn() {
  if (waiting.length === 0) return;
  const now = performance.now();
  for (const { entry, from } of waiting) {
    entry.toFrame = now - from;
    performance.measure('planish:drag-frame', { start: from, end: now });
  }
  waiting = [];
}
