/** Finds the Chromium that the tests drive, or installs it if no confirmation is needed. */
import { existsSync } from "node:fs";
import { chromium } from "playwright";
import { inPath, run, tryInstall } from "./programs.ts";

const HEADLESS_SHELL = "chromium-headless-shell";
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

/** Command-line flags for every start. Chromium refuses to run as root with its sandbox on. */
export const chromiumArguments: readonly string[] = [
  ...(process.getuid?.() === 0 ? ["--no-sandbox"] : []),
  "--disable-gpu",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** @returns the path of Chromium or Chrome, or null. `CHROMIUM_PATH` takes precedence. */
export function findChromium(): string | null {
  const configured = process.env["CHROMIUM_PATH"];
  const candidates = [
    ...(configured === undefined ? [] : [configured]),
    chromium.executablePath(),
    ...systemNames.flatMap(inPath),
    ...macPaths,
  ];
  return candidates.find((path) => path !== "" && existsSync(path)) ?? null;
}

/**
 * Finds the browser for pages that are always visible: Chromium's headless shell, which needs half
 * the processor time because it has no interface of its own, or else Chromium.
 */
export function findHeadlessChromium(): string | null {
  const isConfigured = process.env["CHROMIUM_PATH"] !== undefined;
  return (isConfigured ? undefined : inPath(HEADLESS_SHELL)[0]) ?? findChromium();
}

/** As `findHeadlessChromium`. @throws Error with installation instructions */
export function requireHeadlessChromium(): string {
  return findHeadlessChromium() ?? requireChromium();
}

/** Installs the headless shell if the machine allows that. */
export function tryInstallHeadlessShell(): void {
  if (inPath(HEADLESS_SHELL).length === 0) tryInstall(HEADLESS_SHELL);
}

/**
 * Finds Chromium, or installs it if the machine allows that.
 * @throws Error with installation instructions
 */
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
