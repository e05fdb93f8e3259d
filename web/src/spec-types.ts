// The makers' JSON inputs (docs/formats.md): plates, transitions, slit sheets.

import type { Vec2, Vec3, LengthUnit } from './types.ts';

export interface PlateSpec {
  id: string;
  outline: Vec3[];
  holes?: Vec3[][];
}
export interface BendSpec {
  between: string[];
  edges?: Record<string, number[]>;
  surface?: string;
  inside_radius?: number;
  inside_radii?: Vec2;
  aperture?: number;
  slope?: number;
  apex?: number;
  tangent_point?: Vec3;
  lateral?: string;
  trade_off?: number;
  angle?: number;
  length?: number;
}
export interface PlatesSpec {
  units?: LengthUnit;
  thickness: number;
  k_factor?: number;
  plates: PlateSpec[];
  bends?: BendSpec[];
  defaults?: { inside_radius?: number; lateral?: BendSpec['lateral']; trade_off?: number };
  largest_span?: number;
  root?: string;
}

export type Profile =
  | { polygon: Vec2[] }
  | { circle: { radius: number } }
  | { ellipse: { rx: number; ry: number } }
  | { rounded_rectangle: { width: number; height: number; radius: number } }
  | { obround: { length: number; width: number } }
  | { spline: Vec2[] };
export interface Frame {
  origin?: Vec3;
  x?: Vec3;
  normal?: Vec3;
}
export interface ProfileSpec {
  profile: Profile;
  frame?: Frame;
}
export type Seam = { edge: number } | { corner: number } | { parameter: number };
export type PressLines = { count: number } | { max_angle: number } | { chord: number };
export interface TransitionSpec {
  units?: LengthUnit;
  thickness: number;
  k_factor?: number;
  from: ProfileSpec;
  to: ProfileSpec;
  sizes_are?: 'inside' | 'mid' | 'outside';
  seam?: Seam;
  pieces?: 1 | 2 | 'per_side';
  press_lines?: PressLines;
}

export interface AnchorSpec {
  strip: number;
  ridge: number;
  side?: 'left' | 'right';
  at: Vec3;
}
export interface SlitWeights {
  smooth?: number;
  spacing?: number;
  anchors?: number;
  seat?: number;
  spread?: number;
  scan?: number;
}
export type PanelName = 'leg' | 'second';
export type CurveName = PanelName | 'seat';
export interface StripSpec {
  width: number;
  gap?: number;
  left_start?: number;
  right_start?: number;
  end?: number;
}
export interface StripEnd {
  strip: number;
  position?: Vec3;
  direction?: Vec3;
  across?: Vec3;
}
export interface LegCurve {
  bezier: Vec2[];
  fit?: boolean;
  lean?: number;
}

export interface MouldSpec {
  form?: 'ribs' | 'body';
  side?: 'ground' | 'back' | 'front';
  up?: Vec3;
  base?: number;
  inset?: number;
  draft?: number;
}

export interface SlitSpec {
  units?: LengthUnit;
  thickness: number;
  sheet: {
    strips: number | StripSpec[];
    strip_width?: number;
    panel_height: number;
    half_length?: number;
    margin?: number;
  };
  symmetric?: boolean;
  ridges?: number;
  subdivisions?: number;
  leg_curve: LegCurve;
  second_panel?: { height: number; leg_curve: LegCurve };
  seat_curve?: { bezier: Vec2[] };
  end_angle?: 'right_angle' | 'level' | 'free';
  ends?: StripEnd[];
  anchors?: AnchorSpec[];
  scan?: { strip: number; points: string | Vec3[] }[];
  align_scan?: boolean;
  weights?: SlitWeights;
  min_inside_radius?: number;
  kerf?: number;
  stop_hole?: number;
  mould?: MouldSpec;
}

export type Spec = PlatesSpec | TransitionSpec | SlitSpec;
