/**
 * Starts something whose code loads on demand. Without a network the code may not load: then nothing
 * starts, and the page works without it.
 * @param start returns the function that ends it
 * @param onFailure called if the code does not load, unless it was ended before
 * @returns a function that ends it, even before it has started
 */
export function startLater(
  start: () => Promise<() => void>,
  onFailure: () => void = () => {},
): () => void {
  let isEnded = false;
  const begun = start().catch(() => {
    if (!isEnded) onFailure();
    return () => {};
  });
  return () => {
    isEnded = true;
    void begun.then((stop) => stop());
  };
}
