/**
 * Entry of the command line. Compiled modules are kept in the system's folder for temporary files:
 * without that, a short `grade` spends as long on loading its modules as on the runs. The cache has to
 * be on before they are loaded, hence the late import.
 */
import { enableCompileCache } from "node:module";

enableCompileCache();
const { runCommandLine } = await import("./command-line.ts");
await runCommandLine(process.argv.slice(2));
