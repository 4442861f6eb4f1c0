/**
 * Starts something whose code loads on demand.
 * @param start returns the function that ends it
 * @returns a function that ends it, even before it has started
 */
export function startLater(start: () => Promise<() => void>): () => void {
  const begun = start();
  return () => void begun.then((stop) => stop());
}
