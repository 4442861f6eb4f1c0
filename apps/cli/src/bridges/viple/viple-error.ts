/** Why a message of VIPLE is ignored, as a sentence. */
export class VipleError extends Error {
  override readonly name = "VipleError";
}
