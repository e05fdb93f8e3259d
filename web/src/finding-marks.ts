import { isKnown } from './report.ts';
import type { Finding, Vec2 } from './types.ts';

/** A finding where it is on the screen; without a number where that would cover another one of the chosen finding. */
export interface FindingMark {
  finding: number;
  severity: Finding['severity'];
  at: Vec2;
  of: Vec2; // the place that is meant: `at`, or beside it
  radius: number;
  numbered: boolean;
}

const [chosen, plain, dot] = [10, 7, 3.5]; // radii, pixels

/**
 * One mark for each finding, at its worst place, and one for each place of the chosen one; in the order in which they
 * are drawn. Those of the chosen one have their numbers first, then the findings in their order: where another one has
 * its number already, they step aside.
 */
export function findingMarks(findings: Finding[], at: (place: Vec2) => Vec2, selected: number | null): FindingMark[] {
  const wanted = findings.flatMap((f, finding) => {
    const breaches = f.count ? f.places : [{ severity: f.severity, points: f.at }],
      all = breaches.flatMap(({ severity = f.severity, points = [] }) =>
        points.filter(isKnown).map((point) => ({ severity, point })),
      );
    const shown = finding === selected ? all : all.slice(0, 1); // the worst is the first
    return shown.map(({ severity, point }) => ({ finding, severity, at: at(point), of: at(point) }));
  });
  const numbered: FindingMark[] = [],
    dots: FindingMark[] = [];
  for (const mark of [
    ...wanted.filter((m) => m.finding === selected),
    ...wanted.filter((m) => m.finding !== selected),
  ]) {
    const radius = mark.finding === selected ? chosen : plain,
      isFree = ([x, y]: Vec2) => numbered.every((n) => Math.hypot(n.at[0] - x, n.at[1] - y) >= n.radius + radius - 1);
    const free = (mark.finding === selected ? [mark.at] : [mark.at, ...around(mark.at)]).find(isFree);
    if (free) numbered.push({ ...mark, at: free, radius, numbered: true });
    if (free !== mark.at) dots.push({ ...mark, radius: dot, numbered: false });
  }
  return [...dots, ...numbered.reverse()];
}

/** Where a mark may step aside to: the nearest first, to the right and up before others. */
const around = ([x, y]: Vec2): Vec2[] =>
  [2.5, 4.5].flatMap((far) =>
    Array.from({ length: 8 }, (_, i): Vec2 => {
      const angle = (i % 2 ? -1 : 1) * Math.ceil(i / 2) * (Math.PI / 4) - Math.PI / 4;
      return [x + far * plain * Math.cos(angle), y + far * plain * Math.sin(angle)];
    }),
  );

/** The finding whose mark lies under a point. */
export const findingUnder = (marks: FindingMark[], x: number, y: number): number | null =>
  [...marks].reverse().find((m) => Math.hypot(m.at[0] - x, m.at[1] - y) <= m.radius)?.finding ?? null;
