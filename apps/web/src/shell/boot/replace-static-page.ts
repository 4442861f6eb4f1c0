/**
 * Replaces the static page of index.html with React's without the user noticing: it waits while a
 * button is pressed, and moves the focus from the static Run button to React's.
 */

/** @param render renders React into the static page's root */
export async function replaceStaticPage(root: HTMLElement, render: () => void): Promise<void> {
  const isPressed = () => root.querySelector("button:active") !== null;
  while (isPressed()) await new Promise((later) => setTimeout(later, 20));
  let focused: EventTarget | null = root.querySelector("button:focus");
  const follow = ({ target }: FocusEvent): void => {
    focused = target;
  };
  root.addEventListener("focusin", follow);
  const observer = new MutationObserver(() => {
    observer.disconnect();
    root.removeEventListener("focusin", follow);
    if (focused === null || document.activeElement !== document.body) return;
    root.querySelector<HTMLElement>("[data-does]")?.focus({ preventScroll: true });
  });
  observer.observe(root, { childList: true });
  render();
}
