/** The frame of every page of the documentation: head, navigation and main part. */
import { escaped } from "./markdown.ts";

interface Link {
  path: string;
  words: string;
}

/** The sections in the order in which somebody who writes a script needs them; the first page leads to the others. */
const sections: readonly { words: string; pages: readonly [Link, ...Link[]] }[] = [
  { words: "Begin", pages: [{ path: "/docs", words: "Begin" }] },
  { words: "Recipes", pages: [{ path: "/docs/recipes", words: "Recipes" }] },
  {
    words: "Python",
    pages: [
      { path: "/docs/python", words: "The Python library" },
      { path: "/docs/python-reference", words: "Reference" },
    ],
  },
  {
    words: "JavaScript",
    pages: [
      { path: "/docs/javascript", words: "The TypeScript library" },
      { path: "/docs/javascript-reference", words: "Reference" },
    ],
  },
  { words: "HTTP and WebSocket", pages: [{ path: "/docs/http", words: "HTTP and WebSocket" }] },
  { words: "Problems", pages: [{ path: "/problems", words: "All problems" }] },
  { words: "Try the calls", pages: [{ path: "/docs/try", words: "Try the calls" }] },
  {
    words: "Robot hosts",
    pages: [
      { path: "/docs/hosts", words: "Build a robot host" },
      { path: "/docs/protocol", words: "Protocol" },
      { path: "/docs/conformance", words: "Conformance kit" },
    ],
  },
  {
    words: "File formats",
    pages: [
      { path: "/docs/maze-format", words: "Mazes" },
      { path: "/docs/program-language", words: "Programs" },
      { path: "/docs/run-format", words: "Runs" },
      { path: "/docs/challenge-format", words: "Challenges" },
    ],
  },
];

export interface Page {
  path: string;
  title: string;
  /** inside of `main` */
  html: string;
  /** further elements of the head */
  head?: string;
}

/** A whole page. */
export function framed({ path, title, html, head = "" }: Page): string {
  const here = sections.find(({ pages }) => pages.some((each) => isPart(path, each.path)));
  const links = sections.map(({ words, pages: [{ path: to }] }) =>
    link({ path: to, words }, to === path ? "page" : words === here?.words ? "true" : null),
  );
  const neighbours = here === undefined || here.pages.length === 1 ? [] : here.pages;
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
${html}
    </main>
  </body>
</html>
`;
}

function isPart(path: string, of: string): boolean {
  return path === of || (path.startsWith("/problems/") && of === "/problems");
}

function link({ path, words }: Link, current: "page" | "true" | null): string {
  return `<a href="${path}"${current === null ? "" : ` aria-current="${current}"`}>${words}</a>`;
}
