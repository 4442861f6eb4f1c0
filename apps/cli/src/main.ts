/**
 * Entry of the command line. Compiled modules are kept in the system's folder for temporary files:
 * without that, a short `grade` spends as long on loading its modules as on the runs. The cache has to
 * be on before they are loaded, hence the late import.
 */
import { enableCompileCache } from "node:module";

enableCompileCache();
// npm runs its scripts in the project's folder; files are named from where the user stands.
const { npm_lifecycle_event: script = "", INIT_CWD: folder = "." } = process.env;
if (["simulate", "grade"].includes(script)) process.chdir(folder);
const { runCommandLine } = await import("./command-line.ts");
await runCommandLine(process.argv.slice(2));
