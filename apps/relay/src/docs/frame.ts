/** The frame of every page of the documentation: head, navigation and main part. */
import { escaped } from "./markdown.ts";

/** The pages in the navigation, in the order in which somebody who writes a script needs them. */
const navigation = [
  { path: "/docs", words: "Begin" },
  { path: "/docs/recipes", words: "Recipes" },
  { path: "/docs/python", words: "Python" },
  { path: "/docs/javascript", words: "JavaScript" },
  { path: "/docs/http", words: "HTTP and WebSocket" },
  { path: "/problems", words: "Problems" },
  { path: "/docs/try", words: "Try the calls" },
  { path: "/docs/hosts", words: "Protocol and robot hosts" },
] as const;

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
  const links = navigation.map(({ path: to, words }) => {
    const isHere = to === path || (to === "/problems" && path.startsWith("/problems/"));
    return `<a href="${to}"${isHere ? ' aria-current="page"' : ""}>${words}</a>`;
  });
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
      <nav aria-label="Documentation">${links.join("")}</nav>
    </header>
    <main id="text" tabindex="-1">
${html}
    </main>
  </body>
</html>
`;
}
