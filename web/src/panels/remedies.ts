import { html, nothing } from 'lit-html';
import type { Options } from '../types.ts';
import type { Ui } from '../ui.ts';

/** An option that does away with a finding or a refusal. */
interface Remedy {
  id: string;
  text: string;
  title: string;
  options: Partial<Options>;
}

const corners: Remedy[] = [
  { id: 'rip', text: 'Cut a rip', title: 'A narrow cut where the parts meet', options: { relief: 'rip' } },
  {
    id: 'square',
    text: 'Cut a square relief',
    title: 'As wide and deep as is proposed',
    options: { relief: 'square' },
  },
  { id: 'round', text: 'Cut a round relief', title: 'As wide and deep as is proposed', options: { relief: 'round' } },
];

const besideBends: Remedy[] = (['square', 'round'] as const).map((shape) => ({
  id: `bend-${shape}`,
  text: `Cut ${shape} reliefs`,
  title: 'Beside each bend that lacks one, as wide and deep as the rules ask for',
  options: { bend_relief: shape },
}));

/** By code of a finding or a refusal. */
const known: Record<string, Remedy[]> = {
  mended_corner: [
    ...corners,
    { id: 'none', text: 'Leave it as drawn', title: 'Parts that overlap are refused', options: { relief: 'none' } },
  ],
  bend_relief: besideBends,
  bend_relief_cut: [
    {
      id: 'bend-none',
      text: 'Leave it as drawn',
      title: 'No reliefs are cut beside bends',
      options: { bend_relief: 'none' },
    },
  ],
  overlap: [
    {
      id: 'overlapping',
      text: 'Write it anyway',
      title: 'Files are written although the pattern covers itself; undo takes it back',
      options: { write_overlapping: true },
    },
  ],
};

/** A closed part is cut open along the edge that its refusal names. */
function ripsAt(code: string, where: string | null | undefined, { rip_edges }: Options): Remedy[] {
  const edge = code === 'closed_loop' ? /\bedge (\d+)/.exec(where ?? '')?.[1] : undefined;
  if (!edge) return [];
  return [
    {
      id: 'rip-edge',
      text: 'Rip here',
      title: `Cut the part open along edge ${edge}, the red one`,
      options: { rip_edges: rip_edges ? `${rip_edges},${edge}` : edge },
    },
  ];
}

/** Buttons for what would change something: the remedies that the maker takes and that are not in force. */
export function remedies(ui: Ui, { code, where }: { code: string; where?: string | null }) {
  const { document: d, description, input } = ui.state,
    taken = description.makers.find((m) => m.name === d?.kind)?.options.map((o) => o.name) ?? [];
  const inForce: Partial<Options> = { relief: 'rip', bend_relief: 'none', ...input.options };
  // Corners of which cuts were taken away overlap by little; others are not mended by any cut.
  const all = [
    ...ripsAt(code, where, input.options),
    ...(code === 'overlap' && input.options.relief === 'none' ? corners : []),
    ...(known[code] ?? []),
  ];
  const offered = all.filter(({ options }) =>
    Object.entries(options).every(([name, value]) => taken.includes(name) && inForce[name as keyof Options] !== value),
  );
  return offered.length
    ? html`<span class="remedies"
        >${offered.map(
          ({ id, text, title, options }) =>
            html`<button
              data-testid="remedy-${id}"
              title=${title}
              @click=${() => ui.editOptions((o) => ({ ...o, ...options }))}
            >
              ${text}
            </button>`,
        )}</span
      >`
    : nothing;
}
