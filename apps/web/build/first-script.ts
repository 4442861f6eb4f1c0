/**
 * Builds the page's first script, which is not part of the bundle, and minifies it. Writes its
 * texts and the addresses of the simulator worker and the page's script into index.html. The first
 * script fetches and starts both.
 */
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";
import { build, type Plugin } from "vite";
import type { en } from "../src/text/en/index.ts";
import { languages } from "../src/text/languages.ts";

const WORKER = /(?:^|\/)simulator\.worker-[\w-]+\.js$/;
const SCRIPT = /\s*<script type="module" crossorigin src="([^"]+)"><\/script>/;
const PART = /\s*<link rel="modulepreload" crossorigin href="[^"]+">/g;
const FIRST = '<script src="/first.js"';

const require = createRequire(import.meta.url);

function read<File extends keyof typeof en>(tag: string, file: File): (typeof en)[File] {
  return require(`../src/text/${tag}/${file}.json`) as (typeof en)[File];
}

/** The texts of `public/first.js` in a language. */
export function firstWords(tag: string) {
  const { controls, run, pause, step, max } = read(tag, "shell").run;
  const { invitation, begin } = read(tag, "lessons");
  const maze = read(tag, "presets")["long-way-round"].title;
  const { writeOwn: own, example: program } = read(tag, "program");
  return { controls, run, own, pause, step, max, invitation, begin, maze, program };
}

function withAttribute(html: string, attribute: string, value: string): string {
  return replaced(html, attribute, `${attribute}="${value}"`);
}

function replaced(html: string, text: string, by: string): string {
  const result = html.replace(text, () => by);
  if (result === html) throw new Error(`index.html has no ${text}`);
  return result;
}

/** `public/first.js`, minified. */
async function minifiedScript(): Promise<string> {
  const built = await build({
    configFile: false,
    publicDir: false,
    logLevel: "warn",
    build: {
      write: false,
      target: "es2022",
      modulePreload: false,
      rolldownOptions: {
        input: fileURLToPath(new URL("../public/first.js", import.meta.url)),
        output: { format: "iife" },
      },
    },
  });
  const [file] = [built].flat().flatMap((each) => ("output" in each ? each.output : []));
  if (file?.type !== "chunk") throw new Error("public/first.js was not built");
  return file.code;
}

export function firstScript(): Plugin {
  return {
    name: "corridor-first-script",
    async generateBundle() {
      this.emitFile({ type: "asset", fileName: "first.js", source: await minifiedScript() });
    },
    transformIndexHtml: {
      order: "post",
      handler(html, { bundle }) {
        const words = Object.fromEntries(languages.map(({ tag }) => [tag, firstWords(tag)]));
        const withTexts = withAttribute(
          html,
          "data-words",
          JSON.stringify(words).replaceAll('"', "&quot;"),
        );
        // In development the page starts the worker.
        if (bundle === undefined) return withTexts;
        const worker = Object.keys(bundle).find((file) => WORKER.test(file));
        if (worker === undefined) throw new Error("the build has no simulator worker");
        const [tag, page] = SCRIPT.exec(withTexts) ?? [];
        if (tag === undefined || page === undefined) throw new Error("index.html has no script");
        const parts = [`<link rel="modulepreload" crossorigin href="${page}">`];
        const withoutScripts = withTexts.replace(tag, "").replaceAll(PART, (part) => {
          parts.push(part.trim());
          return "";
        });
        // The browser does not fetch what a template contains before the script inserts it. The
        // styles of the static page and the worker have a higher priority.
        const links = parts.join("").replaceAll(" crossorigin", ' fetchpriority="low" crossorigin');
        const template = `<template id="parts">${links}</template>`;
        const withTemplate = replaced(withoutScripts, FIRST, `${template}\n    ${FIRST}`);
        return withAttribute(
          withAttribute(withTemplate, "data-simulator", `/${worker}`),
          "data-page",
          page,
        );
      },
    },
  };
}
