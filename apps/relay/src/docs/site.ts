/** Every page of the documentation, rendered from its Markdown. */
import { readFileSync } from "node:fs";
import { join, posix } from "node:path";
import type { Page } from "./frame.ts";
import type { Address } from "./markdown.ts";
import { problemPages } from "./problem-pages.ts";
import { CONSOLE_PATH, sections } from "./sections.ts";
import { htmlWithTabs } from "./tabs.ts";

const ROOT = join(import.meta.dirname, "../../../..");

const entries = sections.flatMap(({ pages }) => pages);

/** Links from one file to another lead to its page, or nowhere where that file is not served. */
function addressIn(file: string): Address {
  return (href) => {
    if (/^(?:#|\/|https?:)/.test(href)) return href;
    const [to = "", fragment] = href.split("#");
    const name = posix.join(posix.dirname(file), to);
    const path = entries.find((each) => each.file === name)?.path;
    if (path === undefined) return "";
    return fragment === undefined ? path : `${path}#${fragment}`;
  };
}

const CONSOLE = `<div id="console"><p>The console needs JavaScript. Without it, <a href="/openapi.json">openapi.json</a> says
the same.</p></div>`;
const CONSOLE_HEAD = `<link rel="stylesheet" href="/docs/swagger-ui.css" />
    <script defer src="/docs/swagger-ui-bundle.js"></script>
    <script type="module" src="/docs/docs.js"></script>`;

/** Read and rendered once, at the start. */
export function pagesOfSite(): Page[] {
  const pages = entries.flatMap(({ path, words, title = words, file }): Page[] => {
    if (file === null) return [];
    const html = htmlWithTabs(readFileSync(join(ROOT, file), "utf8"), addressIn(file));
    const page = { path, title, html };
    return [path === CONSOLE_PATH ? { ...page, html: html + CONSOLE, head: CONSOLE_HEAD } : page];
  });
  return [...pages, ...problemPages];
}
