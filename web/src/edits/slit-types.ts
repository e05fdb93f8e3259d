import type {
  Slits,
  SlitsAnchor,
  SlitsEnd,
  SlitsLegCurve,
  SlitsMould,
  SlitsSheetStrip,
  SlitsWeights,
} from '../../generated/slits.ts';
import type { ReportSlitStrip } from '../../generated/report.ts';

export type {
  Slits as SlitSpec,
  SlitsAnchor as AnchorSpec,
  SlitsEnd as StripEnd,
  SlitsLegCurve as LegCurve,
  SlitsMould as MouldSpec,
  SlitsSheetStrip as StripSpec,
  SlitsWeights as SlitWeights,
  ReportSlitStrip as StripRow,
};
export type PanelName = 'leg' | 'second';
export type CurveName = PanelName | 'seat';
