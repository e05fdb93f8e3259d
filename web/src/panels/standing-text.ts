import type { ReportSlit } from '../../generated/report.ts';
import { clean } from '../units.ts';

/** What it was before a change, where that is seen, and is now. */
export const compared = (now: string, before: string | null) =>
  before === null || before === now ? now : `${before} → ${now}`;

/** Whether a slit sheet stands under its weight and loads, and how far it may be tilted. */
export function standingText({ standing, stable }: ReportSlit, before: ReportSlit | null = null): string[] {
  const said = stable === false ? ['not stable'] : [];
  if (!standing) return said;
  const tilt = before?.standing?.stands ? clean(before.standing.margin, 1) : null;
  return [
    ...said,
    standing.stands ? `stands, may be tilted by ${compared(clean(standing.margin, 1), tilt)}°` : 'falls over',
  ];
}
