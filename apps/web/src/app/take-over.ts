/**
 * From the Run of index.html to React's, without the reader noticing: who is pressing it is waited for,
 * and who stands on it with the keyboard stands on the new one.
 */

/** Called with the house of index.html still there, right before React moves in. */
export async function takeOver(house: HTMLElement, moveIn: () => void): Promise<void> {
  const isPressed = () => house.querySelector("button:active") !== null;
  while (isPressed()) await new Promise((later) => setTimeout(later, 20));
  let focused: EventTarget | null = house.querySelector("button:focus");
  const follow = ({ target }: FocusEvent): void => {
    focused = target;
  };
  house.addEventListener("focusin", follow);
  const watch = new MutationObserver(() => {
    watch.disconnect();
    house.removeEventListener("focusin", follow);
    if (focused === null || document.activeElement !== document.body) return;
    house.querySelector<HTMLElement>("[data-does]")?.focus({ preventScroll: true });
  });
  watch.observe(house, { childList: true });
  moveIn();
}
