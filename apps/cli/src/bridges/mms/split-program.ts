/** Arguments of `mms`: what stands before `--`, and the program after it. */
export interface ProgramCall {
  file: string;
  args: readonly string[];
}

/** @returns `program` null if there is none */
export function splitProgram(args: readonly string[]): {
  own: readonly string[];
  program: ProgramCall | null;
} {
  const at = args.indexOf("--");
  if (at < 0) return { own: args, program: null };
  const [file, ...rest] = args.slice(at + 1);
  return {
    own: args.slice(0, at),
    program: file === undefined ? null : { file, args: rest },
  };
}
