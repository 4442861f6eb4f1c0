/** Every page of the documentation. The texts are Markdown; the addresses are here alone. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "./frame.ts";
import { htmlOf, type Address } from "./markdown.ts";
import { problemPages } from "./problem-pages.ts";
import { htmlWithTabs } from "./tabs.ts";

const PAGES = join(import.meta.dirname, "pages");
const ROOT = join(import.meta.dirname, "../../../..");

/** Where a file of the repository is served, by its name. */
const served: Readonly<Record<string, string>> = {
  "protocol.md": "/docs/hosts",
};

/** Links between files lead to their pages, or nowhere where a file is not served. */
const address: Address = (href) => {
  if (/^(?:#|\/|https?:)/.test(href)) return href;
  const [file = "", fragment] = href.split("#");
  const path = served[file.slice(file.lastIndexOf("/") + 1)];
  if (path === undefined) return "";
  return fragment === undefined ? path : `${path}#${fragment}`;
};

const text = (folder: string, file: string): string => readFileSync(join(folder, file), "utf8");

const CONSOLE = `<div id="console"><p>The console needs JavaScript. Without it, <a href="/openapi.json">openapi.json</a> says
the same.</p></div>`;

/** Read and made once, at the start. */
export function pagesOfSite(): Page[] {
  return [
    { path: "/docs", title: "Begin", html: htmlWithTabs(text(PAGES, "begin.md"), address) },
    {
      path: "/docs/recipes",
      title: "Recipes",
      html: htmlWithTabs(text(PAGES, "recipes.md"), address),
    },
    {
      path: "/docs/python",
      title: "The Python library",
      html: htmlOf(text(join(ROOT, "packages/client-python"), "README.md"), address),
    },
    {
      path: "/docs/javascript",
      title: "The TypeScript library",
      html: htmlOf(text(join(ROOT, "packages/client"), "README.md"), address),
    },
    {
      path: "/docs/http",
      title: "HTTP and WebSocket",
      html: htmlOf(text(PAGES, "http.md"), address),
    },
    {
      path: "/docs/try",
      title: "Try the calls",
      html: htmlOf(text(PAGES, "try.md"), address) + CONSOLE,
      head: `<link rel="stylesheet" href="/docs/swagger-ui.css" />
    <script defer src="/docs/swagger-ui-bundle.js"></script>
    <script type="module" src="/docs/docs.js"></script>`,
    },
    {
      path: "/docs/hosts",
      title: "Protocol and robot hosts",
      html: htmlOf(text(join(ROOT, "docs"), "protocol.md"), address),
    },
    ...problemPages,
  ];
}
