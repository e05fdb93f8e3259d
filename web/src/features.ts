import type { FeatureRow, Shape } from './types.ts';

/** Kinds of formed features as people say them, and several of them. */
const names: Record<string, [string, string]> = {
  countersink: ['countersink', 'countersinks'],
  thread: ['thread', 'threads'],
  'slanted cut': ['slanted cut', 'slanted cuts'],
  pocket: ['pocket', 'pockets'],
  chamfer: ['chamfer', 'chamfers'],
  formed: ['formed feature', 'formed features'],
};

export const featureName = (kind: string | undefined, count = 1): string =>
  (names[kind ?? ''] ?? ['feature', 'features'])[count === 1 ? 0 : 1];

/** "75 pockets, 8 countersinks": the features of which a shape has outlines. */
export function drawnFeatures({ edge_feature }: Shape, features: FeatureRow[]): string {
  const counts = new Map<string, number>();
  for (const row of [...new Set(edge_feature)].sort((a, b) => a - b)) {
    if (row < 0) continue;
    const kind = features[row]?.kind ?? '';
    counts.set(kind, (counts.get(kind) ?? 0) + 1);
  }
  return [...counts]
    .sort((a, b) => b[1] - a[1])
    .map(([kind, count]) => `${count} ${featureName(kind, count)}`)
    .join(', ');
}
