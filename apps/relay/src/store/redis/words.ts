/** Redis commands as arguments of a script that runs them. */

export type Words = [name: string, key: string, ...rest: string[]];

/** Each command after the number of its words. */
export function counted(commands: readonly Words[]): string[] {
  return commands.flatMap((words) => [String(words.length), ...words]);
}
