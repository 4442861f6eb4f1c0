/** A store that does not answer at the moment: whether the step was done nobody knows. */
export class StoreAway extends Error {
  override readonly name = "StoreAway";

  constructor(cause: unknown) {
    super("the store is unavailable", { cause });
  }
}
