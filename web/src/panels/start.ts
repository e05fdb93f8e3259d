import { html, nothing } from 'lit-html';
import type { Example } from '../types.ts';
import type { Recent } from '../recents.ts';
import type { Ui } from '../ui.ts';
import { drawing } from './bodies.ts';
import { inputsText } from './inputs-text.ts';
import { kinds } from './kinds.ts';
import { chooseFile } from './top-bar.ts';

const most = 3; // examples of a kind

/** What is there while nothing is open: a place to drop files, what can be begun anew, and examples. */
export function startScreen(ui: Ui) {
  const { document: d, description, examples, recents, opening, given } = ui.state;
  if (d || opening?.first) return nothing;
  return html`<div class="start" data-testid="start">
    <h2>Drop a file here</h2>
    <p>${inputsText(description.makers)}</p>
    <p class="begin">
      <button class="primary" data-testid="start-open" @click=${chooseFile}>Choose a file …</button>
      ${Object.entries(kinds).map(([kind, { title, begin }]) =>
        begin
          ? html`<button data-testid="new-${kind}" @click=${() => ui.openNew(fileOf(begin))}>New ${title}</button>`
          : nothing,
      )}
      ${given
        ? html`<button data-testid="start-given" @click=${ui.openGiven}>Open ${given.name} again</button>`
        : nothing}
    </p>
    ${recents.length
      ? html`<h3>
            ${recents.some((r) => r.edited) ? 'Recent files and edits' : 'Recent files'}
            <button
              class="link"
              data-testid="forget-recents"
              title="Removes the copies kept of them"
              @click=${ui.forgetRecents}
            >
              Forget them
            </button>
          </h3>
          <div class="tiles" data-testid="recents">${recents.map((r) => recentTile(ui, r))}</div>`
      : nothing}
    ${examples.length
      ? html`<h3>or start with an example</h3>
          <div class="tiles">
            ${description.makers.flatMap(({ name }) =>
              examples
                .filter((e) => e.kind === name)
                .slice(0, most)
                .map((e) => tile(ui, e)),
            )}
          </div>`
      : nothing}
  </div>`;
}

const fileOf = ({ file, spec }: { file: string; spec: object }) =>
  new File([JSON.stringify(spec)], file, { type: 'application/json' });

const kindOf = (kind: string) => kinds[kind]?.title ?? kind;

const recentTile = (ui: Ui, r: Recent) =>
  html`<button class="tile" data-testid="recent-${r.name}" @click=${() => ui.openRecent(r)}>
    ${drawing(r.picture)}<b title=${r.name}>${breaking(titleOf(r))}</b><small>${kindOf(r.kind)}</small>
  </button>`;

/** What was made here has no name of its own. */
export const titleOf = ({ name, kind, edited }: Recent) =>
  edited === 'new' ? (kinds[kind] ? `New ${kinds[kind].title}` : name) : edited ? `${name} (edited)` : name;

/** A file's name, which may go on in another line after each of its words. */
const breaking = (name: string) => name.split(/(?<=[_\-. ])/).map((word, i) => (i ? html`<wbr />${word}` : word));

const tile = (ui: Ui, e: Example) =>
  html`<button class="tile" data-testid="start-${e.name}" @click=${() => ui.openExample(e.name)}>
    <img src="pictures/${e.name.replace(/\.\w+$/, '.webp')}" alt="" width="176" height="100" loading="lazy" />
    <b>${e.title}</b><small>${kindOf(e.kind)}</small>
  </button>`;
