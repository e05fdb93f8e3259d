import type { PlatesSpec } from '../edits/plates-types.ts';

/** What "New" begins with: the least that makes a part. */
export const newPlates: { file: string; spec: PlatesSpec } = {
  file: 'plates.json',
  spec: {
    format: 'planish/plates',
    version: 1,
    units: 'mm',
    thickness: 2,
    plates: [
      {
        id: 'base',
        outline: [
          [0, 0, 0],
          [200, 0, 0],
          [200, 120, 0],
          [0, 120, 0],
        ],
      },
      {
        id: 'back',
        outline: [
          [0, 125, 5],
          [200, 125, 5],
          [200, 125, 85],
          [0, 125, 85],
        ],
      },
    ],
  },
};
