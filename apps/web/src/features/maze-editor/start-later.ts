/**
 * Starts something whose code loads on demand. Without a network the code may not load: then nothing
 * starts, and the page works without it.
 * @param start returns the function that ends it
 * @returns a function that ends it, even before it has started
 */
export function startLater(start: () => Promise<() => void>): () => void {
  const begun = start().catch(() => () => {});
  return () => void begun.then((stop) => stop());
}
