/** Follows a text that is made of a store's state, and tells it only when it has become another one. */

/** What of a store is followed. */
export interface Followed<State> {
  getState: () => State;
  subscribe: (listener: (state: State) => void) => () => void;
}

/**
 * Writes the text at once, and from then on each time that it changes.
 * @returns a function that ends it
 */
export function followText<State>(
  { getState, subscribe }: Followed<State>,
  text: (state: State) => string,
  write: (text: string) => void,
): () => void {
  let written = text(getState());
  write(written);
  return subscribe((state) => {
    const next = text(state);
    if (next === written) return;
    written = next;
    write(next);
  });
}
