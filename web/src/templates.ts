import type { Kind } from './types.ts';

/** What "New" begins with: the least that makes a part, in millimetres. */

const plates = {
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
};

const transition = {
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
};

const slit = {
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
};

interface Template {
  kind: Kind;
  text: string;
  file: string;
  spec: object;
}

export const templates: Template[] = [
  { kind: 'connect', text: 'New bent plate', file: 'plates.json', spec: plates },
  { kind: 'transition', text: 'New transition', file: 'transition.json', spec: transition },
  { kind: 'slit', text: 'New slit sheet', file: 'slits.json', spec: slit },
];

export const fileOf = ({ file, spec }: Template) =>
  new File([JSON.stringify(spec)], file, { type: 'application/json' });
