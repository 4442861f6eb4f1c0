/** Values for a text about all of `count` items: "both mazes" for 2, "all 3 mazes" for 3. */
export function allOf(count: number): { count: number; context?: "both" } {
  return count === 2 ? { count, context: "both" } : { count };
}
