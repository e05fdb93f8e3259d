import type { Finding, Vec2 } from './types.ts';

/** A finding where it is on the screen; without a number where that would cover another one. */
export interface FindingMark {
  finding: number;
  severity: Finding['severity'];
  at: Vec2;
  radius: number;
  numbered: boolean;
}

const [chosen, plain, dot] = [10, 7, 3.5]; // radii, pixels

/**
 * One mark for each finding, at its worst place, and one for each place of the chosen one; in the order in which they
 * are drawn. Those of the chosen one have their numbers first, then the findings in their order.
 */
export function findingMarks(findings: Finding[], at: (place: Vec2) => Vec2, selected: number | null): FindingMark[] {
  const wanted = findings.flatMap((f, finding) => {
    const all = (f.places ?? [{ severity: f.severity, at: f.at ?? [] }]).flatMap(({ severity, at: points }) =>
      points.map((point) => ({ severity, point })),
    );
    const shown = finding === selected ? all : all.slice(0, 1); // the worst is the first
    return shown.map(({ severity, point }) => ({ finding, severity, at: at(point) }));
  });
  const numbered: FindingMark[] = [],
    dots: FindingMark[] = [];
  for (const mark of [
    ...wanted.filter((m) => m.finding === selected),
    ...wanted.filter((m) => m.finding !== selected),
  ]) {
    const radius = mark.finding === selected ? chosen : plain;
    if (numbered.some((n) => Math.hypot(n.at[0] - mark.at[0], n.at[1] - mark.at[1]) < n.radius + radius - 1))
      dots.push({ ...mark, radius: dot, numbered: false });
    else numbered.push({ ...mark, radius, numbered: true });
  }
  return [...dots, ...numbered.reverse()];
}

/** The finding whose mark lies under a point. */
export const findingUnder = (marks: FindingMark[], x: number, y: number): number | null =>
  [...marks].reverse().find((m) => Math.hypot(m.at[0] - x, m.at[1] - y) <= m.radius)?.finding ?? null;
