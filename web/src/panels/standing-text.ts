import type { ReportSlit } from '../../generated/report.ts';
import { clean } from '../units.ts';

/** Whether a slit sheet stands under its weight and loads, and how far it may be tilted. */
export function standingText({ standing, stable }: ReportSlit): string[] {
  const said = stable === false ? ['not stable'] : [];
  if (!standing) return said;
  return [...said, standing.stands ? `stands, may be tilted by ${clean(standing.margin, 1)}°` : 'falls over'];
}
