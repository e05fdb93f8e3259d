import type { TransitionSpec } from '../edits/transition-types.ts';

/** What "New" begins with: the least that makes a part. */
export const newTransition: { file: string; spec: TransitionSpec } = {
  file: 'transition.json',
  spec: {
    format: 'planish/transition',
    version: 1,
    units: 'mm',
    thickness: 1,
    from: {
      profile: {
        polygon: [
          [-150, -100],
          [150, -100],
          [150, 100],
          [-150, 100],
        ],
      },
    },
    to: { profile: { circle: { radius: 80 } }, frame: { origin: [0, 0, 200] } },
    sizes_are: 'mid',
    press_lines: { max_angle: 10 },
  },
};
