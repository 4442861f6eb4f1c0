/** Every page of the documentation. The texts are Markdown; the addresses are here alone. */
import { readFileSync } from "node:fs";
import { join, posix } from "node:path";
import type { Page } from "./frame.ts";
import { htmlOf, type Address } from "./markdown.ts";
import { problemPages } from "./problem-pages.ts";
import { htmlWithTabs } from "./tabs.ts";

const PAGES = join(import.meta.dirname, "pages");
const ROOT = join(import.meta.dirname, "../../../..");

/** Files of the repository that are served as they are. */
const files: readonly { file: string; path: string; title: string }[] = [
  {
    file: "packages/client-python/README.md",
    path: "/docs/python",
    title: "The Python library",
  },
  {
    file: "packages/client-python/REFERENCE.md",
    path: "/docs/python-reference",
    title: "Reference of the Python library",
  },
  { file: "packages/client/README.md", path: "/docs/javascript", title: "The TypeScript library" },
  {
    file: "packages/client/REFERENCE.md",
    path: "/docs/javascript-reference",
    title: "Reference of the TypeScript library",
  },
  { file: "docs/protocol.md", path: "/docs/protocol", title: "Protocol" },
  { file: "docs/conformance.md", path: "/docs/conformance", title: "Conformance kit" },
  { file: "docs/maze-format.md", path: "/docs/maze-format", title: "Mazes" },
  { file: "docs/program-language.md", path: "/docs/program-language", title: "Programs" },
  { file: "docs/run-format.md", path: "/docs/run-format", title: "Runs" },
  { file: "docs/challenge-format.md", path: "/docs/challenge-format", title: "Challenges" },
];

/** Links from one file to another lead to its page, or nowhere where that file is not served. */
function addressIn(file: string): Address {
  return (href) => {
    if (/^(?:#|\/|https?:)/.test(href)) return href;
    const [to = "", fragment] = href.split("#");
    const name = posix.join(posix.dirname(file), to);
    const path = files.find((each) => each.file === name)?.path;
    if (path === undefined) return "";
    return fragment === undefined ? path : `${path}#${fragment}`;
  };
}

const text = (folder: string, file: string): string => readFileSync(join(folder, file), "utf8");

const CONSOLE = `<div id="console"><p>The console needs JavaScript. Without it, <a href="/openapi.json">openapi.json</a> says
the same.</p></div>`;

/** Read and made once, at the start. */
export function pagesOfSite(): Page[] {
  return [
    { path: "/docs", title: "Begin", html: htmlWithTabs(text(PAGES, "begin.md")) },
    { path: "/docs/recipes", title: "Recipes", html: htmlWithTabs(text(PAGES, "recipes.md")) },
    { path: "/docs/http", title: "HTTP and WebSocket", html: htmlOf(text(PAGES, "http.md")) },
    { path: "/docs/hosts", title: "Build a robot host", html: htmlOf(text(PAGES, "hosts.md")) },
    {
      path: "/docs/try",
      title: "Try the calls",
      html: htmlOf(text(PAGES, "try.md")) + CONSOLE,
      head: `<link rel="stylesheet" href="/docs/swagger-ui.css" />
    <script defer src="/docs/swagger-ui-bundle.js"></script>
    <script type="module" src="/docs/docs.js"></script>`,
    },
    ...files.map(({ file, path, title }) => ({
      path,
      title,
      html: htmlOf(text(ROOT, file), addressIn(file)),
    })),
    ...problemPages,
  ];
}
