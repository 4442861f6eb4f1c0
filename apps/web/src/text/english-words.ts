/** English, which the page always has: the other languages lean on it. See build/english-words.ts. */
import address from "virtual:english-words-address";
import type { en } from "./en/index.ts";

/** @throws when the words cannot be fetched: nothing can be said then */
export async function englishWords(): Promise<typeof en> {
  if (import.meta.env.DEV) return (await import("./en/index.ts")).en;
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address}: ${answer.status}`);
  return (await answer.json()) as typeof en;
}
