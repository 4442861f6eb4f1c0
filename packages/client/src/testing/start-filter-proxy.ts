/** A filter in front of a relay that ends with the test. */
import { onTestFinished } from "vitest";
import { openFilterProxy, type FilterProxy, type Harm } from "./filter-proxy.ts";

const MOMENT_MS = 1_200;

export async function startFilterProxy(relay: string, harm: Harm): Promise<FilterProxy> {
  const proxy = await openFilterProxy(relay, harm, MOMENT_MS);
  onTestFinished(() => proxy.close());
  return proxy;
}
