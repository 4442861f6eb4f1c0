/** Java for the example in Java: installed where that can be done without asking, else left out. */
import { inPath, tryInstall } from "./programs.ts";

/** A machine without Java skips its tests, and says so. */
export function offerJava(): void {
  if (inPath("java").length === 0) tryInstall("openjdk-17-jdk-headless");
}
