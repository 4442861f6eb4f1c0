/** A short name of a script's language for the page, from the User-Agent header. */

/** Beginnings as the common HTTP libraries send them; only these fixed names are ever shown. */
const BEGINNINGS: readonly (readonly [beginning: string, name: string])[] = [
  ["python", "Python"],
  ["aiohttp", "Python"],
  ["node", "JavaScript"],
  ["undici", "JavaScript"],
  ["deno", "JavaScript"],
  ["bun", "JavaScript"],
  ["java", "Java"],
  ["okhttp", "Java"],
  ["curl", "curl"],
  ["go-http-client", "Go"],
  [".net", "C#"],
  ["mozilla", "Browser"],
];

/** The name behind a User-Agent header; "Script" where it says nothing. */
export function clientName(userAgent: string | undefined): string {
  const text = (userAgent ?? "").slice(0, 40).toLowerCase();
  return BEGINNINGS.find(([beginning]) => text.startsWith(beginning))?.[1] ?? "Script";
}
