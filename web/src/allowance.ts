import type { Shop, ShopMaterial, ShopMaterialGauge as Gauge } from '../generated/shop.ts';
import type { Options } from './types.ts';

export type { Gauge, Shop, ShopMaterial };
import { millimetres } from './units.ts';
import type { TableFile } from './workshop-state.ts';

export type KRule = 'default' | 'number' | 'din6935' | 'k_table' | 'shop';

export const kRule = (o: Options): KRule =>
  o.shop ? 'shop' : o.k_table ? 'k_table' : o.din6935 ? 'din6935' : o.k === undefined ? 'default' : 'number';

const ownNames = ['k', 'din6935', 'k_table', 'shop', 'material', 'density'] as const;
/** What says how bends are laid flat, and how heavy a part is: of a part, or of every part that is opened. */
export const allowanceOf = (o: Options): Options =>
  Object.fromEntries(ownNames.flatMap((n) => (o[n] === undefined ? [] : [[n, o[n]]])));

export const sameAllowance = (a: Options, b: Options) =>
  JSON.stringify(allowanceOf(a)) === JSON.stringify(allowanceOf(b));

/** The options with K from somewhere else. */
export const withK = (o: Options, from: Pick<Options, 'k' | 'din6935' | 'k_table' | 'shop' | 'material'>): Options => ({
  ...o,
  k: undefined,
  din6935: undefined,
  k_table: undefined,
  shop: undefined,
  material: undefined,
  ...from,
});

/** A file as an option takes it. Throws if a shop profile is no JSON. */
export const contentOf = ({ kind, name, text }: TableFile): Pick<Options, 'shop' | 'k_table'> =>
  kind === 'shop' ? { shop: { name, content: JSON.parse(text) as Shop } } : { k_table: { name, content: text } };

export const shopOf = (o: Options): Shop | null => o.shop?.content ?? null;

/** The material that is chosen, in upper or lower case; the only one needs no choice. */
export function materialOf(shop: Shop, name: Options['material']): ShopMaterial | null {
  if (shop.materials.length === 1) return shop.materials[0]!;
  return shop.materials.find((m) => typeof name === 'string' && m.name.toLowerCase() === name.toLowerCase()) ?? null;
}

/** The gauge of a thickness, both in the shop's units; null if the shop has none within its tolerance. */
export function gaugeOf(shop: Shop, material: ShopMaterial, thickness: number): Gauge | null {
  const away = (g: Gauge) => Math.abs(g.thickness - thickness),
    [nearest] = [...material.gauges].sort((a, b) => away(a) - away(b)),
    tolerance = shop.thickness_tolerance ?? 0.05 / millimetres(shop.units);
  return nearest && away(nearest) <= tolerance * (1 + 1e-9) ? nearest : null;
}

/** K of a gauge, whichever way it is given: shop-profiles.md, "From a deduction to K". */
export function gaugeK(g: Gauge): number {
  if (g.k !== undefined) return g.k;
  const angle = ((g.angle ?? 90) * Math.PI) / 180,
    outside = g.inside_radius + g.thickness,
    setback = g.deduction_to === 'tangent_plane' && angle > Math.PI / 2 ? outside : outside * Math.tan(angle / 2),
    allowance = g.allowance ?? 2 * setback - (g.deduction ?? 0);
  return (allowance / angle - g.inside_radius) / g.thickness;
}

/** What a bend of 90° takes off both outside lengths. */
export const gaugeDeduction = (g: Gauge): number =>
  2 * (g.inside_radius + g.thickness) - (Math.PI / 2) * (g.inside_radius + gaugeK(g) * g.thickness);
