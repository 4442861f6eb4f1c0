/** Python with the library of the Model Context Protocol. */
import { fileURLToPath } from "node:url";
import { NotInstallableError, requireEnvironment } from "../../../scripts/python.ts";

const requirements = fileURLToPath(new URL("requirements.txt", import.meta.url));

/** Python with the library, or why it cannot be installed here. */
export function mcpEnvironment(): { python: string } | { missing: string } {
  try {
    return { python: requireEnvironment("mcp", requirements, 10) };
  } catch (error) {
    if (error instanceof NotInstallableError) return { missing: error.message };
    throw error;
  }
}
