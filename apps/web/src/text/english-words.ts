/** English, the fallback of every other language. See build/english-words.ts. */
import address from "virtual:english-words-address";
import type { en } from "./en/index.ts";

/** @throws if the texts cannot be fetched: the page then has no texts at all */
export async function englishWords(): Promise<typeof en> {
  if (import.meta.env.DEV) return (await import("./en/index.ts")).en;
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address}: ${response.status}`);
  return (await response.json()) as typeof en;
}
