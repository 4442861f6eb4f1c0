/**
 * Entry of `npm run simulate`, `grade`, `report` and `conformance`. npm starts scripts in the folder of the
 * project, but users write paths relative to the folder that they are in.
 */
process.chdir(process.env["INIT_CWD"] ?? ".");
await import("./main.ts");
