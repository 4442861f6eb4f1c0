/** Sections and pages of the documentation, with the Markdown file of each page. */

export interface Entry {
  path: string;
  /** label in the navigation */
  words: string;
  /** title of the page, if the label needs its section to be understood */
  title?: string;
  /** path in the repository; null if the text is generated */
  file: string | null;
}

interface Section {
  words: string;
  /** the first page is the target of the section's link */
  pages: readonly [Entry, ...Entry[]];
}

const PAGES = "apps/relay/src/docs/pages";
/** The page with the API console. */
export const CONSOLE_PATH = "/docs/try";

/** In the order in which script authors need them. docs/protocol.md lists the same pages. */
export const sections: readonly Section[] = [
  {
    words: "Quickstart",
    pages: [{ path: "/docs", words: "Quickstart", file: `${PAGES}/quickstart.md` }],
  },
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
    words: "Commands",
    pages: [{ path: "/docs/commands", words: "Commands", file: `${PAGES}/commands.md` }],
  },
  {
    words: "Reading",
    pages: [{ path: "/docs/reading", words: "Reading and streaming", file: `${PAGES}/reading.md` }],
  },
  {
    words: "Transports",
    pages: [
      {
        path: "/docs/transports",
        words: "Transports and reconnecting",
        file: `${PAGES}/transports.md`,
      },
    ],
  },
  {
    words: "Keys",
    pages: [{ path: "/docs/keys", words: "Keys and pairing", file: `${PAGES}/keys.md` }],
  },
  {
    words: "Limits and errors",
    pages: [{ path: "/docs/limits", words: "Limits and errors", file: `${PAGES}/limits.md` }],
  },
  {
    words: "Problems",
    pages: [{ path: "/problems", words: "All problems", file: null }],
  },
  {
    words: "API console",
    pages: [{ path: CONSOLE_PATH, words: "API console", file: `${PAGES}/try.md` }],
  },
  {
    words: "Robot hosts",
    pages: [
      { path: "/docs/hosts", words: "Build a robot host", file: `${PAGES}/hosts.md` },
      { path: "/docs/promises", words: "Host promises", file: `${PAGES}/promises.md` },
      {
        path: "/docs/host-connection",
        words: "Connect a host to a relay",
        file: `${PAGES}/host-connection.md`,
      },
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
      { path: "/docs/short-links", words: "Short links", file: `${PAGES}/short-links.md` },
    ],
  },
];
