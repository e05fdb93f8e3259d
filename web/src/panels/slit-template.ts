import type { SlitSpec } from '../edits/slit-types.ts';

/** What "New" begins with: the least that makes a part. */
export const newSlitSheet: { file: string; spec: SlitSpec } = {
  file: 'slits.json',
  spec: {
    format: 'planish/slits',
    version: 1,
    units: 'mm',
    thickness: 4,
    sheet: { strips: 4, strip_width: 60, panel_height: 420, half_length: 464 },
    symmetric: true,
    ridges: 10,
    subdivisions: 1,
    leg_curve: {
      bezier: [
        [360, 0],
        [360, 80],
        [360, 160],
        [360, 240],
      ],
    },
    seat_curve: {
      bezier: [
        [330, 0],
        [300, 80],
        [310, 160],
        [560, 240],
      ],
    },
  },
};
