/** The original text of the field being edited: Escape restores it. */
const before = new WeakMap<EventTarget, string>();
/** Fields in which something is typed that was not entered: undo is theirs. */
const unentered = new WeakSet<EventTarget>();

const isText = (target: EventTarget | null): target is HTMLInputElement =>
  target instanceof HTMLInputElement && target.type === 'text';

export const isUnentered = (field: EventTarget) =>
  unentered.has(field) && (field as HTMLInputElement).value !== before.get(field);

/** What a field shows is what it begins from: it was drawn anew while it had the focus. */
export function beginsAnew(field: EventTarget) {
  if (before.has(field)) before.set(field, (field as HTMLInputElement).value);
}

export function putBack(field: EventTarget) {
  const text = before.get(field);
  if (text !== undefined) (field as HTMLInputElement).value = text;
}

for (const type of ['focusin', 'change'] as const)
  window.addEventListener(type, ({ target }) => {
    if (!isText(target)) return;
    before.set(target, target.value);
    unentered.delete(target);
  });
window.addEventListener('input', ({ target }) => {
  if (isText(target)) unentered.add(target);
});
/** The field whose entry was refused because of the click that is going on: what was clicked may need it. */
export const refusedByClick = (): HTMLInputElement | null => refused;
let refused: HTMLInputElement | null = null;
const refuses = ({ target }: Event) => (refused = target as HTMLInputElement);

// What was typed is entered before something else is chosen, for which its field may be needed.
window.addEventListener(
  'pointerdown',
  ({ target }) => {
    const field = document.activeElement;
    refused = null;
    if (!isText(field) || field === target || !isUnentered(field)) return;
    window.addEventListener('refused', refuses);
    field.blur();
    window.removeEventListener('refused', refuses);
  },
  true,
);
for (const type of ['click', 'keydown'] as const) window.addEventListener(type, () => (refused = null));
