/**
 * Names of CSS classes in the build: `c` and a number in base 36. Short names reduce the size of
 * the page. index.html names its classes `app.page` (file and class), which this plugin replaces by
 * the short names.
 */
import { globSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";

const source = (path: string): string =>
  fileURLToPath(new URL(`../src/${path}.module.css`, import.meta.url));

/** The stylesheets that index.html may use. */
const shellStyles: Readonly<Record<string, string>> = {
  app: source("shell/app"),
  bar: source("shell/top-bar"),
  brand: source("ui/brand"),
  failure: source("ui/failure"),
  loading: source("shell/loading-page"),
  panel: source("shell/side-panel"),
  sheet: source("shell/phone-sheet"),
  transport: source("features/transport/transport"),
  button: source("ui/button"),
  field: source("ui/field"),
  segmented: source("ui/segmented"),
  tabs: source("ui/tabs"),
  lessons: source("features/lessons/lessons-invitation"),
};

/** A class, or an animation, which needs a name of the same kind. */
const NAME = /(?:\.|@keyframes )([a-z][\w-]*)/gi;

let numbers: ReadonlyMap<string, number> | null = null;

/**
 * The same numbers in each build, independent of the order of files. The classes of the first
 * screen get the smallest numbers.
 */
function classNumbers(): ReadonlyMap<string, number> {
  const files = globSync(source("**/*")).toSorted();
  const keys = [...new Set([...Object.values(shellStyles), ...files])].flatMap((path) =>
    [...readFileSync(path, "utf8").matchAll(NAME)].map(([, name]) => `${path} ${name}`),
  );
  return new Map([...new Set(keys)].map((key, at) => [key, at]));
}

export function scopedName(name: string, path: string): string {
  numbers ??= classNumbers();
  const at = numbers.get(`${path} ${name}`);
  if (at === undefined) throw new Error(`${path} has no class ${name}`);
  return `c${at.toString(36)}`;
}

/** @param word of a class attribute: `app.page` is the class `page` of app.module.css */
function shortName(word: string): string {
  const [file = "", name] = word.split(".");
  if (name === undefined) return word;
  const path = shellStyles[file];
  if (path === undefined || !readFileSync(path, "utf8").includes(`.${name}`)) {
    throw new Error(`index.html: there is no class ${word}`);
  }
  return scopedName(name, path);
}

export function shellClasses(): Plugin {
  return {
    name: "corridor-shell-classes",
    transformIndexHtml: {
      order: "pre",
      handler: (html) =>
        html.replaceAll(
          /\bclass="([^"]*)"/g,
          (_, words: string) => `class="${words.split(" ").map(shortName).join(" ")}"`,
        ),
    },
  };
}
