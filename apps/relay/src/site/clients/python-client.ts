/**
 * `/corridor.py`: the Python package as one file. A student saves it beside the script, and `from
 * corridor import Robot` works without an installation. It is built from the package's modules at
 * startup.
 */
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { Router } from "express";
import { methodNotAllowed } from "../../platform/http/fallbacks.ts";
import { openToAllSites } from "../../platform/http/security-headers.ts";

const PACKAGE = join(import.meta.dirname, "../../../../../packages/client-python/src/corridor");

/** In dependency order. */
const MODULES = [
  "errors",
  "uncaught",
  "other_names",
  "address",
  "reports",
  "actions",
  "requests",
  "problems",
  "command_times",
  "protocol",
  "pairing",
  "transport",
  "async_transport",
  "live_sensor",
  "robot",
  "async_robot",
  "__init__",
];

const FUTURE = "from __future__ import annotations\n";
/** An import from a sibling module, on one line or in brackets. */
const OWN_IMPORT = /^from \.\w+ import (?:\([^)]*\)|[^(\n]*)\n/gm;
const STANDARD_IMPORT = /^(?:import|from) .*\n/gm;
const DOCSTRING = /^"""([\s\S]*?)\s*"""\n/;

export function pythonClientRoutes(folder: string = PACKAGE): Router {
  const router = Router();
  // A relay without the rest of the repository has no package to serve.
  if (!existsSync(folder)) return router;
  const text = oneFile((name) => readFileSync(join(folder, `${name}.py`), "utf8"));
  router
    .route("/corridor.py")
    .all(openToAllSites)
    .get((_request, response) => {
      response.set("Cache-Control", "no-cache").type("text/x-python; charset=utf-8").send(text);
    })
    .all(methodNotAllowed("GET"));
  return router;
}

function oneFile(read: (name: string) => string): string {
  const imports = new Set<string>();
  const bodies = MODULES.map((name) => {
    const source = read(name).replace(FUTURE, "").replaceAll(OWN_IMPORT, "");
    for (const [line] of source.matchAll(STANDARD_IMPORT)) imports.add(line);
    return source
      .replaceAll(STANDARD_IMPORT, "")
      .replace(DOCSTRING, (_all, docstring: string) => comment(name, docstring))
      .replaceAll(/\n{4,}/g, "\n\n\n");
  });
  const head = `"""Drive a robot from your own script: keep this file beside it.

    from corridor import Robot

    robot = Robot("http://HOST/r/ID#KEY")
    robot.forward(100)
    print(round(robot.sensor.front))

Python 3.9 or newer, nothing else.
"""
`;
  return [head, FUTURE, [...imports].toSorted().join(""), ...bodies].join("\n");
}

function comment(name: string, docstring: string): string {
  const lines = docstring.split("\n").map((line) => `# ${line}`.trimEnd());
  return [`# --- ${name} ---`, ...lines, ""].join("\n");
}
