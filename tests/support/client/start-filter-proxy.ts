import { onTestFinished } from "vitest";
import { openFilterProxy, type FilterProxy, type FilterMode } from "./filter-proxy.ts";

const TIMEOUT_MS = 1_200;

/** Starts a filter proxy; it stops with the test. */
export async function startFilterProxy(relay: string, mode: FilterMode): Promise<FilterProxy> {
  const proxy = await openFilterProxy(relay, mode, TIMEOUT_MS);
  onTestFinished(() => proxy.close());
  return proxy;
}
