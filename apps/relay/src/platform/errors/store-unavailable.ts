/** The store does not respond. It is unknown whether the step took effect. */
export class StoreUnavailableError extends Error {
  override readonly name = "StoreUnavailableError";

  constructor(cause: unknown) {
    super("the store is unavailable", { cause });
  }
}
