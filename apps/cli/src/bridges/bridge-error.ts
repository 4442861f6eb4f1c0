/** A bridge cannot work, although its arguments are valid. `message` is a sentence for the user. */
export class BridgeError extends Error {
  override readonly name = "BridgeError";
}
