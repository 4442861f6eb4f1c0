/** Maps a User-Agent header to the short name that the page displays for a script. */
import { bridgePrefix, protocolClients } from "@corridor/protocol";

/**
 * User-Agent prefixes of bridges and of common HTTP libraries. The page only ever displays these
 * fixed names.
 */
const PREFIXES: readonly (readonly [prefix: string, name: string])[] = [
  ...Object.entries(protocolClients).map(
    ([protocol, name]) => [bridgePrefix(protocol), name] as const,
  ),
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

/** Name for a User-Agent header, or "Script" if the header is missing or unknown. */
export function clientName(userAgent: string | undefined): string {
  const text = (userAgent ?? "").slice(0, 40).toLowerCase();
  return PREFIXES.find(([prefix]) => text.startsWith(prefix))?.[1] ?? "Script";
}
