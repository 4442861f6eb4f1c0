/** Fetches what never loses the focus with the first key, or, for those who listen and press none, a while later. */

const LATER_MS = 8000;

/** @returns a function that ends it */
export function keepFocusLater(): () => void {
  let end = (): void => {
    clearTimeout(timer);
    removeEventListener("keydown", load);
    end = () => undefined;
  };
  function load(): void {
    end();
    let isOver = false;
    end = () => (isOver = true);
    // Without it the focus goes where the browser lets it go.
    import("./keep-focus.ts").then(
      ({ keepFocus }) => {
        if (!isOver) end = keepFocus(document);
      },
      () => undefined,
    );
  }
  const timer = setTimeout(load, LATER_MS);
  addEventListener("keydown", load);
  return () => end();
}
