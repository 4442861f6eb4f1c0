/** The pages of the documentation: their addresses, their names and the Markdown files that they show. */

export interface Entry {
  path: string;
  /** in the navigation */
  words: string;
  /** of the page, where the words need their section to be understood */
  title?: string;
  /** path in the repository; null where the text is made from a table */
  file: string | null;
}

interface Section {
  words: string;
  /** the first one leads to the others */
  pages: readonly [Entry, ...Entry[]];
}

const PAGES = "apps/relay/src/docs/pages";
/** The page on which calls can be tried. */
export const CONSOLE_PATH = "/docs/try";

/** In the order in which script authors need them. */
export const sections: readonly Section[] = [
  { words: "Begin", pages: [{ path: "/docs", words: "Begin", file: `${PAGES}/begin.md` }] },
  {
    words: "Recipes",
    pages: [{ path: "/docs/recipes", words: "Recipes", file: `${PAGES}/recipes.md` }],
  },
  {
    words: "Python",
    pages: [
      {
        path: "/docs/python",
        words: "The Python library",
        file: "packages/client-python/README.md",
      },
      {
        path: "/docs/python-reference",
        words: "Reference",
        title: "Reference of the Python library",
        file: "packages/client-python/REFERENCE.md",
      },
    ],
  },
  {
    words: "JavaScript",
    pages: [
      {
        path: "/docs/javascript",
        words: "The TypeScript library",
        file: "packages/client/README.md",
      },
      {
        path: "/docs/javascript-reference",
        words: "Reference",
        title: "Reference of the TypeScript library",
        file: "packages/client/REFERENCE.md",
      },
    ],
  },
  {
    words: "HTTP and WebSocket",
    pages: [{ path: "/docs/http", words: "HTTP and WebSocket", file: `${PAGES}/http.md` }],
  },
  {
    words: "Protocol",
    pages: [{ path: "/docs/protocol", words: "Protocol", file: "docs/protocol.md" }],
  },
  {
    words: "Problems",
    pages: [{ path: "/problems", words: "All problems", file: null }],
  },
  {
    words: "Try the calls",
    pages: [{ path: CONSOLE_PATH, words: "Try the calls", file: `${PAGES}/try.md` }],
  },
  {
    words: "Robot hosts",
    pages: [
      { path: "/docs/hosts", words: "Build a robot host", file: `${PAGES}/hosts.md` },
      { path: "/docs/conformance", words: "Conformance kit", file: "docs/conformance.md" },
    ],
  },
  {
    words: "File formats",
    pages: [
      { path: "/docs/maze-format", words: "Mazes", file: "docs/maze-format.md" },
      { path: "/docs/program-language", words: "Programs", file: "docs/program-language.md" },
      { path: "/docs/run-format", words: "Runs", file: "docs/run-format.md" },
      { path: "/docs/challenge-format", words: "Challenges", file: "docs/challenge-format.md" },
    ],
  },
];
