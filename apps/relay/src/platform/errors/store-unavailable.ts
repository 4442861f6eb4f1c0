/** The store does not respond. It is unknown whether the step took effect. */
export class StoreAway extends Error {
  override readonly name = "StoreAway";

  constructor(cause: unknown) {
    super("the store is unavailable", { cause });
  }
}
