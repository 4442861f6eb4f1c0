/** Two halves of letters. Without an import of the schemas, which not every page of a code loads. */
const COMPLETE = /^(\w{3})(\w{3})$/;

/** A code as on the board: BCD FGH. Other texts stay as they are. */
export function shownCode(code: string): string {
  return code.replace(COMPLETE, "$1 $2");
}
