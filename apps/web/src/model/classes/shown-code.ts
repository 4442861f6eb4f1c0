import { CLASS_CODE_LENGTH } from "@corridor/protocol";

/** A code as on the board: BCD FGH. Other texts stay as they are. */
export function shownCode(code: string): string {
  const half = CLASS_CODE_LENGTH / 2;
  return code.length === CLASS_CODE_LENGTH ? `${code.slice(0, half)} ${code.slice(half)}` : code;
}
