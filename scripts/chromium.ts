/**
 * Finds the Chromium that tests drive, or installs one where that can be done without asking.
 */
import { existsSync } from "node:fs";
import { chromium } from "playwright";
import { inPath, run, tryInstall } from "./programs.ts";

const systemNames = [
  "chromium",
  "chromium-browser",
  "google-chrome",
  "google-chrome-stable",
  "chrome",
];
const macPaths = [
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
  "/Applications/Chromium.app/Contents/MacOS/Chromium",
];

/** Flags for every start: no sandbox only for root, whom Chromium refuses otherwise. */
export const chromiumArguments: readonly string[] = [
  ...(process.getuid?.() === 0 ? ["--no-sandbox"] : []),
  "--disable-gpu",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** The path of a Chromium or Chrome; null when there is none. `CHROMIUM_PATH` comes first. */
export function findChromium(): string | null {
  const wanted = process.env["CHROMIUM_PATH"];
  const candidates = [
    ...(wanted === undefined ? [] : [wanted]),
    chromium.executablePath(),
    ...systemNames.flatMap(inPath),
    ...macPaths,
  ];
  return candidates.find((path) => path !== "" && existsSync(path)) ?? null;
}

/** Installs Chromium where the machine allows it; says what to run where it does not. */
export function requireChromium(): string {
  const found = findChromium() ?? (install() ? findChromium() : null);
  if (found !== null) return found;
  throw new Error(
    "The browser tests need Chromium. Run `npx playwright install --with-deps chromium`, or install Chromium or Chrome and set CHROMIUM_PATH to it.",
  );
}

function install(): boolean {
  return tryInstall("chromium") || run("npx", ["playwright", "install", "chromium"]);
}
