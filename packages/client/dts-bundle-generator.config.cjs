/** Bundles the types of each entry to one file. They need nothing besides zod. */
module.exports = {
  compilationOptions: { preferredConfigPath: `${__dirname}/tsconfig.build.json` },
  entries: ["index", "host", "learn", "show", "teach", "watch"].map((entry) => ({
    filePath: `${__dirname}/src/${entry}.ts`,
    outFile: `${__dirname}/dist/${entry}.d.ts`,
    libraries: { inlinedLibraries: ["@corridor/protocol"], importedLibraries: ["zod"] },
    // The end-to-end tests compile a script with them.
    noCheck: true,
    output: { noBanner: true },
  })),
};
