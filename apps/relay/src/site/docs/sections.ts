/** Sections and pages of the documentation, with the Markdown file of each page. */

export interface Entry {
  path: string;
  /** label in the navigation */
  label: string;
  /** title of the page, if the label needs its section to be understood */
  title?: string;
  /** path in the repository; null if the text is generated */
  file: string | null;
}

interface Section {
  label: string;
  /** the first page is the target of the section's link */
  pages: readonly [Entry, ...Entry[]];
}

const PAGES = "apps/relay/src/site/docs/pages";
/** The page with the API console. */
export const CONSOLE_PATH = "/docs/try";

/** In the order in which script authors need them. docs/protocol.md lists the same pages. */
export const sections: readonly Section[] = [
  {
    label: "Quickstart",
    pages: [{ path: "/docs", label: "Quickstart", file: `${PAGES}/quickstart.md` }],
  },
  {
    label: "Recipes",
    pages: [{ path: "/docs/recipes", label: "Recipes", file: `${PAGES}/recipes.md` }],
  },
  {
    label: "Python",
    pages: [
      {
        path: "/docs/python",
        label: "The Python library",
        file: "packages/client-python/README.md",
      },
      {
        path: "/docs/python-reference",
        label: "Reference",
        title: "Reference of the Python library",
        file: "packages/client-python/REFERENCE.md",
      },
    ],
  },
  {
    label: "JavaScript",
    pages: [
      {
        path: "/docs/javascript",
        label: "The TypeScript library",
        file: "packages/client/README.md",
      },
      {
        path: "/docs/javascript-reference",
        label: "Reference",
        title: "Reference of the TypeScript library",
        file: "packages/client/REFERENCE.md",
      },
    ],
  },
  {
    label: "Commands",
    pages: [{ path: "/docs/commands", label: "Commands", file: `${PAGES}/commands.md` }],
  },
  {
    label: "Reading",
    pages: [{ path: "/docs/reading", label: "Reading and streaming", file: `${PAGES}/reading.md` }],
  },
  {
    label: "Transports",
    pages: [
      {
        path: "/docs/transports",
        label: "Transports and reconnecting",
        file: `${PAGES}/transports.md`,
      },
    ],
  },
  {
    label: "Keys",
    pages: [{ path: "/docs/keys", label: "Keys and pairing", file: `${PAGES}/keys.md` }],
  },
  {
    label: "Limits and errors",
    pages: [{ path: "/docs/limits", label: "Limits and errors", file: `${PAGES}/limits.md` }],
  },
  {
    label: "Problems",
    pages: [{ path: "/problems", label: "All problems", file: null }],
  },
  {
    label: "API console",
    pages: [{ path: CONSOLE_PATH, label: "API console", file: `${PAGES}/try.md` }],
  },
  {
    label: "Robot hosts",
    pages: [
      { path: "/docs/hosts", label: "Build a robot host", file: `${PAGES}/hosts.md` },
      { path: "/docs/promises", label: "Host promises", file: `${PAGES}/promises.md` },
      {
        path: "/docs/host-connection",
        label: "Connect a host to a relay",
        file: `${PAGES}/host-connection.md`,
      },
      { path: "/docs/conformance", label: "Conformance kit", file: "docs/conformance.md" },
    ],
  },
  {
    label: "File formats",
    pages: [
      { path: "/docs/maze-format", label: "Mazes", file: "docs/maze-format.md" },
      { path: "/docs/program-language", label: "Programs", file: "docs/program-language.md" },
      { path: "/docs/run-format", label: "Runs", file: "docs/run-format.md" },
      { path: "/docs/challenge-format", label: "Challenges", file: "docs/challenge-format.md" },
      { path: "/docs/short-links", label: "Short links", file: `${PAGES}/short-links.md` },
      { path: "/docs/classes", label: "Classes", file: `${PAGES}/classes.md` },
    ],
  },
];
