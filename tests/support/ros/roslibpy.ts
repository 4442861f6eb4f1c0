/** Python with roslibpy. */
import { fileURLToPath } from "node:url";
import { NotInstallableError, requireEnvironment } from "../../../scripts/python.ts";

const requirements = fileURLToPath(new URL("requirements.txt", import.meta.url));

/** Python with the library, or why it cannot be installed here. */
export function roslibpyEnvironment(): { python: string } | { missing: string } {
  try {
    return { python: requireEnvironment("ros", requirements) };
  } catch (error) {
    if (error instanceof NotInstallableError) return { missing: error.message };
    throw error;
  }
}
