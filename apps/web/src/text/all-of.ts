/** The values of a text about all of `count` things: "both mazes" for two, "all 3 mazes" for three. */
export function allOf(count: number): { count: number; context?: "both" } {
  return count === 2 ? { count, context: "both" } : { count };
}
