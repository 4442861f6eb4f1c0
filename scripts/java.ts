/** Java, for the tests of the Java example. */
import { inPath, tryInstall } from "./programs.ts";

/** Installs Java if it is missing. Without Java, its tests are skipped and counted as skipped. */
export function tryInstallJava(): void {
  if (inPath("java").length === 0) tryInstall("openjdk-17-jdk-headless");
}
