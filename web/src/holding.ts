/** What is dragged can be given up; then it stays as it was until it is let go, or something else is done by keys. */
let givenUp = false;
let held = 0; // buttons of the pointer

export const isGivenUp = () => givenUp;
export function giveUp() {
  givenUp = true;
}

for (const event of ['pointerdown', 'pointerup', 'pointercancel'] as const)
  window.addEventListener(event, (e) => (held = e.type === 'pointercancel' ? 0 : e.buttons), true);
window.addEventListener('pointerdown', () => (givenUp = false), true);
window.addEventListener('keydown', () => (givenUp &&= held > 0), true);
