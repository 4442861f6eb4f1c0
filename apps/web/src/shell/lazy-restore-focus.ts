/**
 * Loads focus restoration with the first key press or, for screen-reader users who press none, some
 * seconds later.
 */

const LATER_MS = 8000;

/** @returns a function that stops it */
export function lazyRestoreFocus(): () => void {
  let end = (): void => {
    clearTimeout(timer);
    removeEventListener("keydown", load);
    end = () => undefined;
  };
  function load(): void {
    end();
    let isOver = false;
    end = () => (isOver = true);
    // Without it the browser decides about the focus.
    import("./restore-focus.ts").then(
      ({ restoreFocus: keepFocus }) => {
        if (!isOver) end = keepFocus(document);
      },
      () => undefined,
    );
  }
  const timer = setTimeout(load, LATER_MS);
  addEventListener("keydown", load);
  return () => end();
}
