/** Subscribes to a text derived from a store's state and reports it only when it changes. */

/** The part of a store that is read. */
export interface StateSource<State> {
  getState: () => State;
  subscribe: (listener: (state: State) => void) => () => void;
}

/**
 * Writes the text now and after each change.
 * @returns a function that unsubscribes
 */
export function followText<State>(
  { getState, subscribe }: StateSource<State>,
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
