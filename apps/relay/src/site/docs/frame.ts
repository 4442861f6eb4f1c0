/** The layout of all documentation pages: head, navigation and main content. */
import { escaped } from "./markdown.ts";
import { sections, type Entry } from "./sections.ts";

export interface Page {
  path: string;
  title: string;
  /** renders the content of `main` */
  html: () => string;
  /** additional elements of the head */
  head?: string;
}

/** Renders a complete page. */
export function renderPage({ path, title, html, head = "" }: Page): string {
  const current = sections.find(({ pages }) => pages.some((each) => isPart(path, each.path)));
  const links = sections.map(({ label, pages: [{ path: to }] }) =>
    link({ path: to, label }, to === path ? "page" : label === current?.label ? "true" : null),
  );
  const neighbours = current === undefined || current.pages.length === 1 ? [] : current.pages;
  const inSection = neighbours.map((each) => link(each, each.path === path ? "page" : null));
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <title>${escaped(title)} - Corridor</title>
    <link rel="icon" href="data:," />
    <link rel="stylesheet" href="/docs/docs.css" />
    <script type="module" src="/docs/copy.js"></script>
    <script type="module" src="/docs/tabs.js"></script>
    ${head}
  </head>
  <body>
    <a class="skip" href="#text">Skip to the text</a>
    <header>
      <a class="home" href="/">Corridor</a>
      <nav aria-label="Documentation">
        <div>${links.join("")}</div>
        ${inSection.length === 0 ? "" : `<div class="section">${inSection.join("")}</div>`}
      </nav>
    </header>
    <main id="text" tabindex="-1">
${html()}
    </main>
  </body>
</html>
`;
}

function isPart(path: string, of: string): boolean {
  return path === of || (path.startsWith("/problems/") && of === "/problems");
}

function link(
  { path, label }: Pick<Entry, "path" | "label">,
  current: "page" | "true" | null,
): string {
  return `<a href="${path}"${current === null ? "" : ` aria-current="${current}"`}>${label}</a>`;
}
