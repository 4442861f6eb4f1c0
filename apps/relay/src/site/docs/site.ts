/** The pages of the documentation, rendered from Markdown. */
import { readFileSync } from "node:fs";
import { join, posix } from "node:path";
import type { GatewayName } from "@corridor/protocol";
import type { Page } from "./frame.ts";
import type { Address } from "./markdown.ts";
import { problemPages } from "./problem-pages.ts";
import { withQuickstarts } from "./quickstart-blocks.ts";
import { CONSOLE_PATH, sections } from "./sections.ts";
import { htmlWithTabs } from "./tabs.ts";

const ROOT = join(import.meta.dirname, "../../../../..");

/** Pages with at least this number of sections have a table of contents. */
const MIN_SECTIONS = 6;

const entries = sections.flatMap(({ pages }) => pages);

/** Maps links between files to served pages. Links to other files become plain text. */
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

const CONSOLE = `<div id="console"><p>The console needs JavaScript. Without JavaScript, read
<a href="/openapi.json">openapi.json</a>.</p></div>`;
const CONSOLE_HEAD = `<link rel="stylesheet" href="/docs/swagger-ui.css" />
    <script defer src="/docs/swagger-ui-bundle.js"></script>
    <script type="module" src="/docs/docs.js"></script>`;

/** Adds a table of contents below the heading of a long page. */
function withContents(html: string): string {
  const sections = [...html.matchAll(/<h2 id="(.*?)">(.*?)<\/h2>/g)];
  if (sections.length < MIN_SECTIONS) return html;
  const links = sections.map(([, id = "", words = ""]) => `<li><a href="#${id}">${words}</a></li>`);
  const contents = `<nav class="contents" aria-label="On this page"><ul>${links.join("")}</ul></nav>`;
  return html.replace("</h1>", `</h1>\n${contents}`);
}

/**
 * All pages. A page reads its file when it is rendered.
 * @param gateways those that the operator has not switched off
 */
export function pagesOfSite(gateways: readonly GatewayName[]): Page[] {
  const pages = entries.flatMap(({ path, label, title = label, file }): Page[] => {
    if (file === null) return [];
    const html = (): string => {
      const text = withQuickstarts(readFileSync(join(ROOT, file), "utf8"), gateways);
      return withContents(htmlWithTabs(text, addressIn(file)));
    };
    return [
      path === CONSOLE_PATH
        ? { path, title, html: () => html() + CONSOLE, head: CONSOLE_HEAD }
        : { path, title, html },
    ];
  });
  return [...pages, ...problemPages];
}
